"""What a request puts on furniture: on the right thing, in the stated order, with room for all of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from sceneweaver.assets import Library
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.kin import families, kin
from sceneweaver.language import Entity, SceneGraph, StatedRelation
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context, Proposal
from sceneweaver.tools.init_prior import InitPrior
from sceneweaver.verify import check

Design = Callable[..., Proposal]


def entity(name: str, category: str = "", count: int = 1) -> Entity:
    return Entity(id=name, noun=name.replace("_", " "), category=category or name, count=(count, count))


def said(kind: Any, subject: str, *targets: str, **more: Any) -> StatedRelation:
    return StatedRelation(id=f"{subject}-{kind}", type=kind, subject=subject, targets=targets, words=kind, **more)


@pytest.fixture(scope="module")
def design(library: Library) -> Design:
    """The first scene of a room that holds only what is named."""

    def run(kind: str, entities: list[Entity], relations: list[StatedRelation], **more: Any) -> Proposal:
        more.setdefault("only", True)
        graph = SceneGraph(text="", entities=tuple(entities), relations=tuple(relations), **more)
        start = Scene(id="empty", room={"outline": ((0, 0), (3, 0), (3, 3), (0, 3))})
        return InitPrior().propose(Context(graph, room_type(kind), start, library, 0))

    return run


def scene_of(proposal: Proposal) -> Scene:
    assert proposal.scene is not None
    return proposal.scene


def holder(scene: Scene, name: str) -> tuple[str, str]:
    """What a thing stands on, and which of its surfaces."""
    support = scene.object(name).support
    assert support is not None
    return support.object, support.surface


def astray(scene: Scene) -> list[str]:
    """What the judge says of small things where they are before any search: collisions, no support, relations."""
    small = {o.id for o in scene.objects if o.mount == "surface"}
    kinds = ("collision", "unsupported", "relation")
    violations = check(scene, walkable=False).violations
    return [v.detail for v in violations if v.hard and v.kind in kinds and small & set(v.objects)]


def test_things_stand_as_stated(design):
    things = [entity("desk"), entity("monitor"), entity("keyboard"), entity("mouse"), entity("mug")]
    relations = [
        said("on", "monitor", "desk"),
        said("in_front_of", "keyboard", "monitor"),
        said("right_of", "mouse", "keyboard"),
        said("left_of", "mug", "keyboard"),
    ]
    proposal = design("office", things, relations)
    scene = scene_of(proposal)
    at = {o.category: o.pose.position for o in scene.objects}
    assert not proposal.unmet and all(holder(scene, o.id)[0] == "desk-0" for o in scene.objects if o.id != "desk-0")
    assert at["keyboard"][0] > at["monitor"][0]  # +x is the desk's front, where its user is
    assert at["mug"][1] < at["keyboard"][1] < at["mouse"][1]  # the right of who looks at it
    stated = [r for r in scene.relations if r.asked]
    assert len(stated) == 3 and all(r.hard and r.request for r in stated)
    assert not astray(scene)


def test_inside_is_on_boards_and_on_is_on_top(design):
    things = [entity("low_bookcase"), entity("book", count=3), entity("vase")]
    proposal = design("study", things, [said("inside", "book", "low_bookcase"), said("on", "vase", "low_bookcase")])
    scene = scene_of(proposal)
    shelf = scene.object("low_bookcase-0")
    boards = {s.name: s.headroom for s in shelf.surfaces}
    books = [holder(scene, o.id)[1] for o in scene.objects if o.category == "book"]
    assert len(books) == 3 and all(boards[name] is not None for name in books)
    assert len(set(books)) > 1  # spread over the boards
    assert boards[holder(scene, "vase-0")[1]] is None


def test_on_a_table_is_not_on_the_shelf_under_it(design):
    things = [entity("nightstand"), entity("magazine", count=2)]
    scene = scene_of(design("bedroom", things, [said("on", "magazine", "nightstand")]))
    tops = {s.name for s in scene.object("nightstand-0").surfaces if s.headroom is None}
    assert {holder(scene, f"magazine-{k}")[1] for k in range(2)} <= tops


def test_stacks(design):
    things = [entity("desk"), entity("serving_tray"), entity("apple", count=2)]
    scene = scene_of(design("study", things, [said("on", "serving_tray", "desk"), said("on", "apple", "serving_tray")]))
    assert {holder(scene, f"apple-{k}")[0] for k in range(2)} == {"serving_tray-0"}
    assert not astray(scene)


def test_what_has_no_surface_gets_a_flat_top(design):
    scene = scene_of(design("study", [entity("chair"), entity("book")], [said("on", "book", "chair")]))
    assert scene.object(holder(scene, "book-0")[0]).intent.request == "chair"
    assert not astray(scene)


def test_a_support_grows_with_what_it_carries(design):
    sizes = []
    for count in (1, 14):
        table = [entity("dining_table"), entity("laptop", count=count)]
        proposal = design("dining_room", table, [said("on", "laptop", "dining_table")])
        assert not proposal.unmet and not astray(scene_of(proposal))
        sizes.append(scene_of(proposal).object("dining_table-0").size)
    assert sizes[0][1] < sizes[1][1]


def test_a_support_grows_beyond_what_is_usual_before_anything_goes_to_the_floor(design):
    proposal = design("living_room", [entity("bench"), entity("cushion", count=3)], [said("on", "cushion", "bench")])
    scene = scene_of(proposal)
    assert not proposal.unmet and not astray(scene)
    assert {holder(scene, f"cushion-{k}")[0] for k in range(3)} == {"bench-0"}


def test_a_desk_grows_where_what_is_told_of_the_things_on_it_would_not_hold(design):
    things = [entity("side_table"), entity("monitor"), entity("keyboard"), entity("mouse")]
    stated = [said("on", name, "side_table") for name in ("monitor", "keyboard", "mouse")]
    stated += [said("in_front_of", "keyboard", "monitor"), said("right_of", "mouse", "keyboard")]
    proposal = design("study", things, stated)
    scene = scene_of(proposal)
    assert not proposal.unmet and not astray(scene)
    assert all(r.hard for r in scene.relations if r.asked and r.subject in ("keyboard-0", "mouse-0"))


def test_flat_things_without_room_lie_on_others_of_their_kind(design):
    towels = [entity("stool"), entity("folded_towel", count=4)]
    proposal = design("bathroom", towels, [said("on", "folded_towel", "stool")])
    scene = scene_of(proposal)
    assert not proposal.unmet and not astray(scene)
    holders = {holder(scene, f"folded_towel-{k}")[0] for k in range(4)}
    assert "stool-0" in holders and holders <= {"stool-0", *(f"folded_towel-{k}" for k in range(4))}


@pytest.mark.parametrize("box", ["storage_box", "toy_chest", "laundry_hamper", "trash_can"])
def test_a_box_that_holds_things_is_open_and_they_are_within_it(design, box):
    scene = scene_of(design("childrens_room", [entity(box), entity("ball", count=2)], [said("inside", "ball", box)]))
    held = scene.object(f"{box}-0")
    for k in range(2):
        ball = scene.object(f"ball-{k}")
        assert holder(scene, ball.id) == (held.id, "inside")
        assert ball.pose.position[2] < held.pose.position[2] + 0.2 * held.size[2]
    assert not astray(scene)


def test_a_top_with_something_rising_from_it_carries_what_is_put_on_it(design):
    things = [entity("train_table"), entity("toy_train", count=2)]
    scene = scene_of(design("childrens_room", things, [said("on", "toy_train", "train_table")]))
    assert {holder(scene, f"toy_train-{k}")[0] for k in range(2)} == {"train_table-0"}
    assert not astray(scene)


def test_what_is_told_to_be_on_the_floor_is_there(design):
    things = [entity("freestanding_bathtub"), entity("side_table"), entity("candle", count=3)]
    for relation in (said("on", "candle", "floor"), said("around", "candle", "freestanding_bathtub")):
        scene = scene_of(design("bathroom", things, [relation]))
        assert {scene.object(f"candle-{k}").mount for k in range(3)} == {"floor"}


def test_a_basket_beside_which_something_stands_on_the_floor_is_there_as_well(design):
    things = [entity("dining_table"), entity("palm"), entity("basket")]
    scene = scene_of(design("dining_room", things, [said("next_to", "palm", "basket")]))
    assert scene.object("basket-0").mount == "floor"


def test_what_stands_on_nothing_that_is_named_is_not_put_on_a_seat(design):
    scene = scene_of(design("bar", [entity("bar_counter"), entity("stool", count=2), entity("plate")], []))
    assert holder(scene, "plate-0")[0] == "bar_counter-0"


def test_what_has_no_room_is_said(design):
    proposal = design("study", [entity("stool"), entity("laptop", count=3)], [said("on", "laptop", "stool")])
    scene = scene_of(proposal)
    beside = [o.id for o in scene.objects if o.category == "laptop" and o.mount == "floor"]
    assert sum(o.category == "laptop" for o in scene.objects) == 3 and beside
    assert all(any(line.startswith(f"{name}: ") for line in proposal.unmet) for name in beside)
    near = {r.subject for r in scene.relations if r.asked and r.type == "near"}
    assert near == set(beside)


def test_the_middle_of_a_table(design):
    scene = scene_of(
        design("dining_room", [entity("dining_table"), entity("bowl")], [said("centered_on", "bowl", "dining_table")])
    )
    x, y, _ = scene.object("bowl-0").pose.position
    assert abs(x) < 0.1 and abs(y) < 0.1


def test_a_ball_before_a_chest_is_on_the_floor(design):
    scene = scene_of(
        design("childrens_room", [entity("toy_chest"), entity("ball")], [said("in_front_of", "ball", "toy_chest")])
    )
    assert scene.object("ball-0").mount == "floor"


@pytest.mark.parametrize(
    ("named", "noun", "default", "same"),
    [
        ("loveseat", "loveseat", "sofa", True),
        ("armchair", "armchair", "sofa", False),
        ("armchair", "armchair", "office_chair", False),
        ("chair", "chair", "conference_chair", True),
        ("dining_table", "table", "coffee_table", True),
        ("dining_table", "dining table", "coffee_table", False),
        ("bookcase", "bookshelf", "low_bookcase", True),
        ("book", "book", "standing_books", True),
    ],
)
def test_kinds(named, noun, default, same):
    assert (default in kin(named, noun)) is same
    assert named in kin(named, noun) and families()[0]


def test_nothing_is_added_of_a_kind_that_was_named(design):
    things = [entity("loveseat"), entity("office_chair"), entity("bookcase")]
    scene = scene_of(design("living_room", things, [], only=False))
    for thing in things:
        own = kin(thing.category, thing.noun)
        assert [o.category for o in scene.objects if o.category in own] == [thing.category]
    sofa = next(o for o in scene.objects if o.category == "loveseat")
    assert sofa.intent.program_item == "sofa"  # it takes the place of the room's own


def test_the_more_is_said_the_less_is_added(design):
    few = scene_of(design("living_room", [entity("sofa")], [], only=False))
    names = ("sofa", "armchair", "coffee_table", "tv_stand", "tv", "rug", "floor_lamp", "bookcase", "ottoman", "bench")
    many = scene_of(design("living_room", [entity(name) for name in names], [], only=False))
    extra = [sum(o.intent.priority != "asked" for o in scene.objects) for scene in (few, many)]
    assert extra[1] < extra[0]


def test_far_too_many_things_are_found_out_soon(design, monkeypatch):
    """After some of a kind without room no more of it are tried, so that the rest costs nothing."""
    from sceneweaver.generate.surface_stated import MISSES, StatedLayer

    asked: list[int] = []
    once, cluster = StatedLayer._once, StatedLayer._cluster

    def begun(self, riders, rows):
        asked.append(0)
        laid, lost = once(self, riders, rows)
        assert asked[-1] <= len(laid) + MISSES
        return laid, lost

    def counted(self, group, rows):
        asked[-1] += 1
        return cluster(self, group, rows)

    monkeypatch.setattr(StatedLayer, "_once", begun)
    monkeypatch.setattr(StatedLayer, "_cluster", counted)
    things = [entity("side_table"), entity("serving_tray", count=30)]
    proposal = design("kitchen", things, [said("on", "serving_tray", "side_table")])
    assert asked and sum(o.category == "serving_tray" for o in scene_of(proposal).objects) > 0


def test_a_draft_that_is_short_of_time_changes_no_sizes(library, monkeypatch):
    from sceneweaver.generate import supports

    def never(*_: object) -> None:
        raise AssertionError("there is no time for this")

    monkeypatch.setattr(supports, "_larger", never)
    monkeypatch.setattr(supports, "_smaller", never)
    things = (entity("side_table"), entity("serving_tray", count=30))
    graph = SceneGraph(text="", entities=things, relations=(said("on", "serving_tray", "side_table"),), only=True)
    start = Scene(id="empty", room={"outline": ((0, 0), (3, 0), (3, 3), (0, 3))})
    context = Context(graph, room_type("kitchen"), start, library, 0, hurried=lambda: True)
    assert any(o.category == "serving_tray" for o in scene_of(InitPrior().propose(context)).objects)
