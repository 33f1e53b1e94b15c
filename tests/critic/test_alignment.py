"""Whether the critic measures each item of a request as people mean it."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.critic import STATUSES, Alignment, phrases
from sceneweaver.critic.partners import own_partners
from sceneweaver.scene import SceneObject
from tests.critic import rooms
from tests.critic.measuring import (
    BED,
    CHAIR,
    LAMP,
    ROOM,
    RUG,
    SOFA,
    TABLE,
    aligned,
    box,
    carrier,
    graph,
    holds,
    legs,
    on,
    relation,
)
from tests.critic.rooms import Case

bed = box("bed-0", BED, 2.0, 2.5)  # its head at x = 1, its foot at x = 3, looks along +x
table = carrier(box("dining_table-0", TABLE, 3.0, 2.5))
sofa = box("sofa-0", SOFA, 0.5, 2.5)


def lamp(x: float, y: float, yaw: float = 0.0, k: int = 0) -> SceneObject:
    return box(f"floor_lamp-{k}", LAMP, x, y, yaw)


def stool(x: float, y: float, yaw: float = 0.0, k: int = 0) -> SceneObject:
    return box(f"stool-{k}", (*CHAIR[:2], 0.45), x, y, yaw)


@pytest.mark.parametrize(
    ("kind", "x", "y", "yes"),
    [
        ("next_to", 2.0, 3.9, True),
        ("next_to", 2.0, 4.1, False),
        ("near", 2.0, 4.1, True),
        ("near", 5.2, 4.5, False),
        ("against", 2.0, 3.5, True),
        ("against", 2.0, 3.7, False),
        ("far_from", 5.8, 4.8, True),
        ("far_from", 5.0, 2.5, False),
        ("right_of", 1.5, 3.6, True),
        ("left_of", 1.5, 3.6, False),
        ("left_of", 1.5, 1.4, True),
        ("right_of", 1.5, 1.4, False),
        ("right_of", 4.0, 3.6, False),
        ("in_front_of", 3.6, 2.5, True),
        ("in_front_of", 3.6, 4.0, False),
        ("in_front_of", 4.9, 2.5, True),
        ("in_front_of", 5.4, 2.5, False),
        ("behind", 0.5, 2.5, True),
        ("behind", 3.6, 2.5, False),
        ("at_foot", 3.4, 2.0, True),
        ("at_foot", 0.6, 2.0, False),
        ("at_foot", 4.0, 2.0, False),
        ("at_head", 0.6, 2.5, True),
        ("at_head", 1.2, 3.6, True),
        ("at_head", 2.8, 3.6, False),
        ("along", 2.0, 3.6, True),
        ("along", 3.5, 2.5, False),
        ("centered_on", 3.6, 2.6, True),
        ("centered_on", 3.6, 2.9, False),
    ],
)
def test_beside_a_bed(kind: str, x: float, y: float, yes: bool) -> None:
    """Left and right are those of who stands at the foot and looks at the bed."""
    assert holds(bed, lamp(x, y), type=kind, subject="floor_lamp", targets=("bed",)) is yes


def test_far_from_is_half_of_a_small_room() -> None:
    closet = ROOM.model_copy(update={"outline": ((0, 0), (2.5, 0), (2.5, 2), (0, 2)), "doors": (), "windows": ()})
    said: dict[str, Any] = {"type": "far_from", "subject": "floor_lamp", "targets": ("stool",)}
    pair = stool(0.3, 1.0), lamp(2.3, 1.0)
    assert holds(*pair, room=closet, **said) and not holds(*pair, **said)
    assert holds(*pair, **said, params={"min": 1.2})


def test_a_distance_that_was_given_counts() -> None:
    said: dict[str, Any] = {
        "type": "near",
        "subject": "floor_lamp",
        "targets": ("bed",),
        "params": {"min": 0.4, "max": 0.6},
    }
    assert holds(bed, lamp(2.0, 3.95), **said) and not holds(bed, lamp(2.0, 3.55), **said)
    outcome = relation(bed, lamp(2.0, 3.55), **said)
    assert outcome.allowed == (0.4, 0.6) and outcome.measured == pytest.approx(0.1) and outcome.unit == "m"
    assert outcome.objects == ("floor_lamp-0", "bed-0") and "0.1 m" in outcome.reason


@pytest.mark.parametrize(
    ("kind", "subject", "yes"),
    [
        ("facing", box("sofa-0", SOFA, 0.5, 2.5, 0), True),
        ("facing", box("sofa-0", SOFA, 0.5, 2.5, 40), False),
        ("facing", box("desk-0", SOFA, 0.5, 2.5, 180), True),  # who sits at it does
        ("facing", box("desk-0", SOFA, 0.5, 2.5, 90), False),
        ("facing", box("sofa-0", SOFA, 0.5, 3.3, 0), True),  # its front meets the table though its middle is aside
        ("opposite", box("sofa-0", SOFA, 5.55, 2.5, 180), True),
        ("opposite", box("sofa-0", SOFA, 5.55, 0.6, 90), False),
        ("opposite", box("tv-0", (0.1, 1.2, 0.7), 5.9, 2.5, 180, z=1.0, mount="wall"), True),
        ("opposite", box("tv-0", (0.1, 1.2, 0.7), 5.3, 0.06, 90, z=1.0, mount="wall"), False),  # at the side wall
        ("parallel", box("sofa-0", SOFA, 0.5, 2.5, 180), True),
        ("parallel", box("sofa-0", SOFA, 0.5, 2.5, 90), False),
        ("aligned", box("sofa-0", SOFA, 0.5, 2.5, 90), True),
        ("aligned", box("sofa-0", SOFA, 0.5, 2.5, 45), False),
        ("back_to_back", box("sofa-0", SOFA, 2.0, 2.5, 180), True),
        ("back_to_back", box("sofa-0", SOFA, 2.0, 2.5, 0), False),
    ],
)
def test_directions(kind: str, subject: SceneObject, yes: bool) -> None:
    assert holds(table, subject, type=kind, subject=subject.category, targets=("dining_table",)) is yes


def test_a_screen_that_is_faced_looks_back() -> None:
    said: dict[str, Any] = {"type": "facing", "subject": "sofa", "targets": ("tv",)}
    for yaw, yes in ((180, True), (150, False), (90, False)):
        assert holds(sofa, box("tv-0", (0.1, 1.2, 0.7), 4.0, 2.5, yaw, z=0.6), **said) is yes, yaw


def test_a_picture_over_a_sofa_hangs_at_the_wall_behind_it() -> None:
    said: dict[str, Any] = {"type": "above", "subject": "picture", "targets": ("sofa",)}
    behind = box("picture-0", (0.03, 0.8, 0.6), 0.02, 2.5, 0, z=1.3, mount="wall")
    assert holds(sofa, behind, **said)
    aside = box("picture-0", (0.03, 0.8, 0.6), 1.0, 2.5, 0, z=1.3, mount="wall")
    assert not holds(sofa, aside, **said)


def test_two_of_a_kind_that_face_each_other() -> None:
    a, b = box("armchair-0", CHAIR, 2.0, 2.5, 0), box("armchair-1", CHAIR, 3.2, 2.5, 180)
    said: dict[str, Any] = {"type": "opposite", "subject": "armchair", "targets": ("armchair",)}
    assert holds(a, b, **said)
    assert not holds(a, box("armchair-1", CHAIR, 3.2, 2.5, 90), **said)


def test_at_a_table_a_chair_is_turned_to_it() -> None:
    said: dict[str, Any] = {"type": "at", "subject": "dining_chair", "targets": ("dining_table",)}
    for y in (1.8, 2.5, 3.2):
        assert holds(table, box("dining_chair-0", CHAIR, 2.2, y, 0), **said), y
        assert not holds(table, box("dining_chair-0", CHAIR, 2.2, y, 180), **said), y
    assert not holds(table, box("dining_chair-0", CHAIR, 1.2, 2.5, 0), **said)


def test_one_over_the_other() -> None:
    vase = on(table, "vase-0", (0.1, 0.1, 0.3))
    on_it: dict[str, Any] = {"type": "on", "subject": "vase", "targets": ("dining_table",)}
    assert holds(table, vase, **on_it)
    assert not holds(table, box("vase-0", (0.1, 0.1, 0.3), 1.0, 1.0), **on_it)
    tray = carrier(on(table, "tray-0", (0.4, 0.4, 0.05)))
    assert holds(table, tray, on(tray, "vase-0", (0.1, 0.1, 0.3)), **on_it), "with a tray between"
    rug = box("rug-0", RUG, 3.0, 2.5)
    high = table.model_copy(update={"pose": table.pose.from_yaw(3.0, 2.5, 0.0, 0.0)})
    for subject, target, kind in (("rug", "dining_table", "below"), ("dining_table", "rug", "on")):
        said = {"type": kind, "subject": subject, "targets": (target,)}
        assert holds(legs(high), rug, **said) and not holds(legs(high), box("rug-0", RUG, 3.0, 5.5), **said)
    art = box("picture-0", (0.03, 1.0, 0.7), 0.02, 2.6, z=1.4, mount="wall")
    for subject, target, kind in (("picture", "sofa", "above"), ("sofa", "picture", "below")):
        said = {"type": kind, "subject": subject, "targets": (target,)}
        assert holds(sofa, art, **said)
        aside = box("picture-0", (0.03, 1.0, 0.7), 0.02, 4.4, z=1.4, mount="wall")
        assert not holds(sofa, aside, **said)
    low = box("picture-0", (0.03, 1.0, 0.7), 0.02, 2.6, z=0.3, mount="wall")
    assert not holds(sofa, low, type="above", subject="picture", targets=("sofa",))


def test_inside_is_not_on_top() -> None:
    case = carrier(box("bookcase-0", (0.4, 1.0, 1.8), 0.3, 2.5), inner=True)
    said: dict[str, Any] = {"type": "inside", "subject": "book", "targets": ("bookcase",)}
    assert holds(case, on(case, "book-0", (0.2, 0.2, 0.2), inner=True), **said)
    assert not holds(case, on(case, "book-0", (0.2, 0.2, 0.2)), **said)
    bowl = carrier(on(table, "bowl-0", (0.5, 0.5, 0.2)))
    assert holds(table, bowl, on(bowl, "book-0", (0.2, 0.2, 0.2)), **said | {"targets": ("bowl",)})
    chest = carrier(box("chest-0", (0.5, 0.5, 0.4), 3.0, 3.0))
    assert not holds(chest, on(chest, "book-0", (0.2, 0.2, 0.2)), **said | {"targets": ("chest",)}), "on its lid"


def test_flanking_needs_both_sides() -> None:
    said: dict[str, Any] = {"type": "flanking", "subject": "floor_lamp", "targets": ("bed",)}
    assert holds(bed, lamp(1.2, 1.4), lamp(1.2, 3.6, k=1), **said)
    assert not holds(bed, lamp(1.2, 3.6), lamp(1.8, 3.6, k=1), **said)
    assert not holds(bed, lamp(1.2, 0.3), lamp(1.2, 4.7, k=1), **said), "too far away"
    assert not holds(bed, lamp(1.2, 3.6), **said), "one cannot"
    window = {**said, "targets": ("window",)}
    assert holds(lamp(2.0, 4.7), lamp(4.4, 4.7, k=1), **window)
    assert not holds(lamp(2.8, 4.7), lamp(4.4, 4.7, k=1), **window)


def test_two_different_things_flank_together() -> None:
    names = ("floor_lamp", "stool")
    said = [{"id": f"beside-{n}", "type": "flanking", "subject": n, "targets": ("bed",)} for n in names]
    for x, y, status in ((1.2, 1.4, "met"), (1.8, 3.6, "unmet")):
        things = (bed, lamp(1.2, 3.6), stool(x, y))
        found = aligned(things, graph(things, *said))
        assert {o.status for o in found.items if o.kind == "relation"} == {status}


def test_around_is_all_about() -> None:
    said: dict[str, Any] = {"type": "around", "subject": "stool", "targets": ("dining_table",)}
    places = [(2.3, 1.9), (2.3, 3.1), (3.7, 1.9), (3.7, 3.1), (3.0, 1.2), (3.0, 3.8)]
    six = [stool(x, y, k=k) for k, (x, y) in enumerate(places)]
    assert holds(table, *six, **said) and holds(table, *six[:4], **said) and holds(table, six[4], six[5], **said)
    assert not holds(table, *[stool(2.3, 1.7 + 0.55 * k, k=k) for k in range(4)], **said), "all on one side"
    assert not holds(table, *six[:3], stool(5.7, 4.7, k=3), **said), "one stands elsewhere"
    assert relation(table, *six[:3], stool(5.7, 4.7, k=3), **said).status == "unmet"


def test_between() -> None:
    said: dict[str, Any] = {"type": "between", "subject": "floor_lamp", "targets": ("bed", "sofa")}
    a, b = box("bed-0", BED, 1.2, 1.0), box("sofa-0", BED, 1.2, 4.0)
    assert holds(a, b, lamp(1.2, 2.5), **said) and not holds(a, b, lamp(4.0, 2.5), **said)
    assert not holds(a, b, lamp(2.4, 1.0), **said), "beside one of them"
    twins = box("bed-0", BED, 1.2, 1.0), box("bed-1", BED, 1.2, 3.2)
    both = {**said, "targets": ("bed",)}
    assert holds(*twins, lamp(0.4, 2.1), **both), "at their heads"
    assert not holds(*twins, lamp(0.4, 4.5), **both)


@pytest.mark.parametrize(
    ("kind", "place", "subject", "yes"),
    [
        ("against", "wall", sofa, True),
        ("against", "wall", box("sofa-0", SOFA, 1.0, 2.5), False),
        ("against", "wall:left", sofa, True),
        ("against", "wall:west", sofa, True),
        ("against", "wall:right", sofa, False),
        ("along", "wall", box("sofa-0", SOFA, 3.0, 4.4, 0), False),
        ("on", "wall", box("sofa-0", (0.05, 1.0, 0.5), 0.03, 2.5, z=1.2, mount="wall"), True),
        ("on", "wall", sofa, True),  # what never hangs
        ("on", "wall", box("sofa-0", SOFA, 3.0, 2.5), False),
        ("far_from", "wall", box("sofa-0", SOFA, 3.0, 2.5), True),
        ("facing", "wall:right", sofa, True),
        ("facing", "wall:far", sofa, False),
        ("next_to", "window", box("sofa-0", SOFA, 3.0, 4.2, -90), True),
        ("next_to", "window", box("sofa-0", SOFA, 3.0, 3.5, -90), False),
        ("near", "window", box("sofa-0", SOFA, 3.0, 3.5, -90), True),
        ("below", "window", box("sofa-0", SOFA, 3.0, 4.4, -90), True),
        ("below", "window", box("sofa-0", (0.6, 1.0, 2.2), 3.0, 4.6, -90), False),
        ("below", "window", box("sofa-0", SOFA, 5.5, 4.4, -90), False),
        ("below", "window", box("sofa-0", SOFA, 3.0, 3.9, 0), False),  # its end to the window
        ("behind", "door", box("sofa-0", (0.3, 0.3, 0.8), 1.5, 0.2, 90), True),
        ("behind", "door", box("sofa-0", (0.3, 0.3, 0.8), 1.5, 0.9, 90), False),
        ("hanging_from", "wall", box("sofa-0", CHAIR, 0.25, 2.5), False),
        ("hanging_from", "wall", box("sofa-0", (0.2, 0.5, 0.9), 0.1, 2.5, z=0.8, mount="wall"), True),
        ("on", "wall:short", sofa, True),
        ("on", "wall:long", sofa, False),
        ("at", "corner:near+right", box("sofa-0", CHAIR, 5.7, 0.3), True),
        ("at", "corner:far+right", box("sofa-0", CHAIR, 5.7, 0.3), False),
        ("facing", "window", box("sofa-0", SOFA, 3.0, 2.0, 90), True),
        ("facing", "window", box("sofa-0", SOFA, 3.0, 2.0, 0), False),
        ("left_of", "window", box("sofa-0", (0.4, 0.4, 1.0), 2.0, 4.7), True),
        ("right_of", "window", box("sofa-0", (0.4, 0.4, 1.0), 2.0, 4.7), False),
        ("right_of", "window", box("sofa-0", (0.4, 0.4, 1.0), 4.4, 4.7), True),
        ("near", "door", box("sofa-0", CHAIR, 1.6, 0.4), True),
        ("far_from", "door", box("sofa-0", CHAIR, 1.6, 0.4), False),
        ("far_from", "door", box("sofa-0", CHAIR, 4.6, 4.4), True),
        ("opposite", "door", box("sofa-0", CHAIR, 1.0, 4.4), True),
        ("opposite", "door", box("sofa-0", CHAIR, 5.5, 0.6), False),
        ("at", "corner", box("sofa-0", CHAIR, 5.6, 4.6), True),
        ("at", "corner", box("sofa-0", CHAIR, 5.6, 3.0), False),
        ("at", "middle", box("sofa-0", SOFA, 3.1, 2.4), True),
        ("at", "middle", box("sofa-0", SOFA, 1.6, 2.4), False),
        ("hanging_from", "ceiling", box("sofa-0", (0.4, 0.4, 0.6), 3.0, 2.5, z=2.0, mount="ceiling"), True),
        ("hanging_from", "ceiling", box("sofa-0", (0.4, 0.4, 0.6), 3.0, 2.5), False),
        ("on", "floor", sofa, True),
        ("at", "room", sofa, True),
    ],
)
def test_places(kind: str, place: str, subject: SceneObject, yes: bool) -> None:
    assert holds(subject, type=kind, subject="sofa", targets=(place,)) is yes


def test_a_place_that_the_room_has_not() -> None:
    blind = ROOM.model_copy(update={"windows": ()})
    outcome = relation(sofa, room=blind, type="near", subject="sofa", targets=("window",))
    assert outcome.status == "unmet" and "no window" in outcome.reason


def test_counts_sides_and_each() -> None:
    places = [(2.3, 2.0), (2.3, 3.0), (3.7, 2.0), (3.7, 3.0)]
    four = [stool(x, y, k=k) for k, (x, y) in enumerate(places)]
    sides: dict[str, Any] = {"type": "at", "subject": "stool", "targets": ("dining_table",), "side": "long"}
    assert holds(table, *four, **sides, count=(2, 2), each=True)
    assert not holds(table, *four[:3], stool(3.0, 1.2, k=3), **sides, count=(2, 2), each=True)
    assert holds(table, *four[:3], stool(3.0, 1.2, k=3), **sides, count=(3, 3))
    ends = {**sides, "side": "short"}
    assert holds(table, *four, stool(3.0, 1.2, k=4), stool(3.0, 3.8, k=5), **ends, count=(1, 1), each=True)
    assert not holds(table, *four, stool(3.0, 1.2, k=4), stool(2.9, 1.2, k=5), **ends, count=(1, 1), each=True)
    near: dict[str, Any] = {"type": "near", "subject": "stool", "targets": ("window",)}
    assert holds(*four, stool(3.0, 4.5, k=4), **near, count=(1, 1))
    assert not holds(*four, **near, count=(1, 1)) and not holds(*four, stool(3.0, 4.5, k=4), **near)


def test_each_target_and_each_corner() -> None:
    tables = [carrier(box(f"dining_table-{k}", (0.5, 0.5, 0.5), 1.0 + 2 * k, 2.5)) for k in range(2)]
    said: dict[str, Any] = {"type": "on", "subject": "vase", "targets": ("dining_table",), "each": True}
    vases = [on(t, f"vase-{k}", (0.1, 0.1, 0.2)) for k, t in enumerate(tables)]
    assert holds(*tables, *vases, **said)
    both_here = [on(tables[0], f"vase-{k}", (0.1, 0.1, 0.2)) for k in range(2)]
    outcome = relation(*tables, *both_here, **said)
    assert outcome.status == "unmet" and (outcome.measured, outcome.allowed) == (0.0, (1.0, None))
    corners = [lamp(x, y, k=k) for k, (x, y) in enumerate([(0.3, 0.3), (5.7, 0.3), (5.7, 4.7), (0.3, 4.7)])]
    every: dict[str, Any] = {"type": "at", "subject": "floor_lamp", "targets": ("corner",), "each": True}
    assert holds(*corners, **every) and not holds(*corners[:3], **every)


def test_what_is_each_ones_own_counts_for_one() -> None:
    assert own_partners({"a": ["x"], "b": ["x", "y"]}, 1) == {"a": ["x"], "b": ["y"]}
    assert own_partners({"a": ["x", "y"], "b": ["x", "y", "z"]}, 2)["b"] == ["z"]
    pair = [carrier(box(f"dining_table-{k}", (0.5, 0.5, 0.5), 2.0 + 1.2 * k, 2.5)) for k in range(2)]
    said: dict[str, Any] = {"type": "near", "subject": "stool", "targets": ("dining_table",), "each": True}
    between = [stool(2.6, 2.5, k=0)]
    assert not holds(*pair, *between, **said)
    assert holds(*pair, *between, stool(3.8, 2.5, k=1), **said)


def test_of_what_is_missing_its_relations_and_looks_are_unmet() -> None:
    brief = graph((bed,), {"id": "it", "type": "near", "subject": "floor_lamp", "targets": ("bed",)})
    more = {"id": "floor_lamp", "noun": "floor_lamp", "category": "floor_lamp", "count": (1, 1), "color": "red"}
    brief = brief.model_validate({**brief.model_dump(), "entities": [*brief.model_dump()["entities"], more]})
    found = aligned((bed,), brief)
    assert [(o.item, o.status) for o in found.items] == [
        ("bed", "met"),
        ("floor_lamp", "unmet"),
        ("floor_lamp.color", "unmet"),
        ("it", "unmet"),
    ]
    assert found.summary == {"total": 4} | {status: 0 for status in STATUSES} | {"met": 1, "unmet": 3}
    assert Alignment.model_validate_json(found.model_dump_json()) == found


def test_what_was_only_implied_is_assumed_and_the_unknown_is_said() -> None:
    said = {"type": "near", "subject": "floor_lamp", "targets": ("bed",), "implied": True}
    assert relation(bed, lamp(2.0, 4.0), **said).status == "assumed"
    brief = graph((bed,), unread=[{"words": "zorblax"}])
    assert aligned((bed,), brief).of("unread-0").status == "not_understood"
    odd = relation(bed, lamp(2.0, 4.0), type="around", subject="floor_lamp", targets=("ceiling",))
    assert odd.status == "not_understood"


@pytest.mark.parametrize(
    ("attribute", "given", "status"),
    [
        ({"kind": "color", "value": "navy"}, {"color": "dark blue"}, "met"),
        ({"kind": "color", "value": "red"}, {"color": "dark blue"}, "unmet"),
        ({"kind": "color", "value": "red"}, {}, "not_understood"),
        ({"kind": "material", "value": "wood"}, {"material": "oak"}, "met"),
        ({"kind": "style", "value": "rustic"}, {"style": "modern"}, "unmet"),
        ({"kind": "style", "value": "gothic"}, {"style": "modern"}, "not_understood"),
        ({"kind": "shape", "value": "rectangular"}, {}, "met"),
        ({"kind": "shape", "value": "round"}, {}, "unmet"),
        ({"kind": "shape", "value": "round"}, {"shape": "round"}, "unmet"),  # its outline is none
        ({"kind": "size", "value": "large"}, {}, "unmet"),
        ({"kind": "size", "value": "small"}, {}, "met"),
        ({"kind": "size", "value": "long"}, {}, "unmet"),
        ({"kind": "part", "value": "3 drawers"}, {"drawers": 3}, "met"),
        ({"kind": "part", "value": "3 drawers"}, {"drawers": 2}, "unmet"),
        ({"kind": "part", "value": "3 drawers"}, {}, "not_understood"),
        ({"kind": "other", "value": "cheerful"}, {}, "not_understood"),
        ({"kind": "other", "value": "as desk"}, {}, "met"),
        ({"kind": "other", "value": "as bar stool"}, {}, "met"),
        ({"kind": "other", "value": "as coffee table"}, {}, "unmet"),
        ({"kind": "other", "value": "as whatsit"}, {}, "not_understood"),
    ],
)
def test_attributes(attribute: dict[str, Any], given: dict[str, Any], status: str) -> None:
    thing = box("dresser-0", (0.4, 0.7, 0.7), 0.3, 2.5, attributes=given)
    brief = graph((thing,))
    data = brief.model_dump()
    data["entities"][0]["attributes"] = [{"id": "look", **attribute}]
    assert aligned((thing,), brief.model_validate(data)).of("look").status == status


def test_an_attribute_of_some_of_them() -> None:
    things = tuple(
        box(f"dresser-{k}", (0.4, 0.7, 0.7), 0.3, 1.0 + k, attributes={"color": c})
        for k, c in enumerate(("red", "red", "blue"))
    )
    data = graph(things).model_dump()
    for count, status in (((2, 2), "met"), ((1, 1), "unmet"), ((3, 3), "unmet"), (None, "unmet")):
        data["entities"][0]["attributes"] = [{"id": "look", "kind": "color", "value": "red", "count": count}]
        assert aligned(things, graph(()).model_validate(data)).of("look").status == status, count


def test_every_item_has_one_outcome() -> None:
    case = rooms.living()
    data: dict[str, Any] = {
        "text": "",
        "room_type": "living_room",
        "area": 21.0,
        "height": 2.6,
        "windows": 1,
        "style": "modern",
        "colors": ("grey",),
        "people": 2,
        "entities": [{"id": "sofa", "noun": "sofa", "category": "sofa", "color": "red", "size": (None, 2.0, None)}],
        "relations": [{"type": "against", "subject": "sofa", "targets": ("wall",)}],
        "exclusions": [{"words": "piano", "categories": ("upright_piano",)}],
        "unread": [{"words": "x"}],
    }
    found = Case(case.scene, case.room_type, graph(()).model_validate(data)).review().alignment
    ids = [o.item for o in found.items]
    assert len(ids) == len(set(ids)) and {"sofa", "sofa.color", "sofa.metres", "relation-0", "exclusion-0"} <= set(ids)
    assert found.summary["total"] == len(ids) == sum(v for k, v in found.summary.items() if k != "total")
    assert all(o.reason and set(o.objects) <= set(case.scene.ids) for o in found.items)


def test_each_unmet_item_lowers_the_grade() -> None:
    case = rooms.living()
    relations = [
        {"type": "on", "subject": "sofa", "targets": ("coffee_table",)},
        {"type": "at", "subject": "coffee_table", "targets": ("corner",)},
        {"type": "against", "subject": "coffee_table", "targets": ("wall",)},
        *({"type": kind, "subject": "armchair", "targets": ("tv_stand",)} for kind in ("behind", "on", "at_head")),
        *(
            {"type": kind, "subject": "bookcase", "targets": ("sofa",)}
            for kind in ("left_of", "next_to", "on", "inside")
        ),
    ]
    names = ("sofa", "coffee_table", "armchair", "tv_stand", "bookcase")
    entities = [{"id": n, "noun": n, "category": n, "count": (1, 1)} for n in names]
    last = 11.0
    for k in range(len(relations) + 1):
        brief = graph(()).model_validate({"text": "", "entities": entities, "relations": relations[:k]})
        found = Case(case.scene, case.room_type, brief).review()
        assert found.alignment.summary["unmet"] == k and found.grades["alignment"] < last
        last = found.grades["alignment"]
        faults = [f for f in found.faults if f.criterion == "alignment"]
        assert len(faults) == k and all(f.tool for f in faults)


def test_what_can_hang_has_to_when_it_is_to_be_on_a_wall() -> None:
    said: dict[str, Any] = {"type": "on", "subject": "picture", "targets": ("wall",)}
    size = (0.03, 1.0, 0.7)
    assert holds(box("picture-0", size, 0.02, 2.5, z=1.4, mount="wall"), **said)
    assert not holds(box("picture-0", size, 0.02, 2.5), **said), "it stands on the floor"


def test_phrases_are_cut_out_of_the_text_by_their_spans() -> None:
    text = "A bedroom with a red bed by the wall"  # "bed" of the room's name is part of other words
    brief = graph((bed,), {"type": "against", "subject": "bed", "targets": ("wall",), "span": (21, 36)}, text=text)
    data = brief.model_dump()
    data |= {"room_type": "bedroom", "room_words": "bedroom"}
    data["entities"][0].update(span=(17, 24), color="red")
    data["entities"][0]["attributes"] = [{"id": "look", "kind": "color", "value": "red", "span": (99, 120)}]
    brief = brief.model_validate(data)
    found = {p.outcome.item: (p.words, p.span) for p in phrases(brief, aligned((bed,), brief))}
    assert found == {
        "bed": ("red bed", (17, 24)),
        "look": ("red bed", None),  # the span is none of this text
        "relation-0": ("bed by the wall", (21, 36)),
        "room.room_type": ("bedroom", (2, 9)),
    }


def test_the_third_of_a_row_is_counted_from_either_end():
    stools = tuple(carrier(stool(0.5 + k, 4.0, k=k)) for k in range(5))
    book = (0.1, 0.1, 0.05)
    yes = [
        holds(*stools, on(stools[k], "book-0", book), type="on", subject="book", targets=("stool",), nth=2)
        for k in range(5)
    ]
    assert yes == [False, True, False, True, False]
    last = [
        holds(*stools, on(stools[k], "book-0", book), type="on", subject="book", targets=("stool",), nth=-1)
        for k in range(5)
    ]
    assert last == [True, False, False, False, True]


def test_a_half_of_the_room_is_beyond_its_middle():
    def there(x: float, half: str) -> bool:
        return holds(stool(x, 2.5), type="at", subject="stool", targets=(f"half:{half}",))

    assert there(4.0, "east")
    assert not there(2.0, "east")
    assert there(2.0, "west")


def test_nothing_is_on_a_table_but_what_the_request_places_there():
    book = on(table, "book-0", (0.1, 0.1, 0.05))
    nothing = {"id": "no", "words": "nothing on it", "categories": ("anything",), "relation": "on"}
    barred = {**nothing, "targets": ("dining_table",)}
    said = {"id": "it", "type": "on", "subject": "book", "targets": ("dining_table",)}
    objects = (table, book)
    assert aligned(objects, graph(objects, exclusions=[barred])).of("no").status == "unmet"
    assert aligned(objects, graph(objects, said, exclusions=[barred])).of("no").status == "met"
    assert aligned((table,), graph((table,), exclusions=[barred])).of("no").status == "met"
