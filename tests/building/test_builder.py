"""Scenes by words: what is drawn, what relations come of keywords, and that a call that fails changes nothing."""

from __future__ import annotations

import ast
import inspect

import pytest

import sceneweaver as sw
from sceneweaver.building.relating import SHORT
from sceneweaver.scene import CATALOGUE
from sceneweaver.scene.catalogue import BUILT_IN
from tests.building.builder_stub import STUB, stub


@pytest.fixture
def room() -> sw.SceneBuilder:
    return sw.build(sw.Room.rectangle(4, 5, height=2.6, kind="study").with_door("south").with_window("east"))


def test_what_is_built_can_be_laid_out(room):
    desk = room.add("white desk", against="north")
    room.add("office chair", front_to_front=desk)
    room.add("lamp", on=desk)
    shelf = room.add("bookcase", against="wall", away_from_door=True)
    room.add("books", inside=shelf)
    room.add("picture", against="west")
    room.add("ceiling lamp", in_middle=True)
    best = sw.refine(room.scene(), candidates=16, device="cpu").best
    report = sw.check(best)
    assert report.valid and report.relations.hard.total == 6
    assert best.room.type == "study" and best.object(desk.id).attributes["color"] == "white"
    assert best.object("standing_books-0").support.object == shelf.id
    assert best.object("picture-0").mount == "wall" and best.object("ceiling_light-0").mount == "ceiling"


def test_words_and_numbers_say_the_size(room):
    assert room.add("desk", width=1.2).object.size[1] == pytest.approx(1.2, abs=1e-6)
    plain, large = room.add("rug").object.size, room.add("large rug").object.size
    assert large[0] * large[1] > plain[0] * plain[1]


def test_the_same_words_give_the_same_piece(room):
    one, two = room.add_many(2, "dining chair")
    assert one.object.asset == two.object.asset and one.id != two.id
    assert room.add("dining chair", seed=5).object.asset != one.object.asset


def test_a_place_and_a_turn(room):
    desk = room.add("desk", at=(1.0, 2.0), turn=90, fixed=True)
    assert desk.object.pose.position[:2] == (1.0, 2.0) and desk.object.fixed
    assert desk.object.pose.yaw == pytest.approx(1.5707963)
    lamp = room.add("lamp", on=desk).object
    x, y, z = lamp.pose.position
    assert abs(x - 1.0) < 0.1 and abs(y - 2.0) < 0.1 and z == pytest.approx(desk.object.surfaces[0].z)


def test_what_was_not_known_is_noted(room):
    thing = room.add("frobnicator", mount="floor")
    assert len(room.notes) == 1 and "frobnicator" in room.notes[0] and thing.object.category == "frobnicator"


def test_objects_of_ones_own(room):
    box = sw.SceneObject(id="box", category="box", size=(0.4, 0.4, 0.4))
    handle = room.add(box, against="wall")
    assert handle.object == box and handle in room.objects and len({handle, *room.objects}) == 1


def some_target(kind: str, builder: sw.SceneBuilder):
    one, other = builder.add("desk"), builder.add("bookcase")
    return {
        "none": True,
        "wall": "north",
        "object": one,
        "objects": (one, other.id),
        "window": builder.room.windows[0].id,
        "door": builder.room.doors[0].id,
    }[kind]


@pytest.mark.parametrize("name", sorted(BUILT_IN - {"inside"}))
def test_every_type_of_the_catalogue_is_a_keyword_and_a_method(room, name):
    spec = CATALOGUE[name]
    params = {p.name: value for p, value in zip(spec.params.values(), (0.5, 2.0), strict=False) if p.required}
    target = some_target(spec.target_kind, room)
    if not params:
        room.add("armchair", **{name: target}, frame="viewer")
    params |= {"frame": "viewer"} if "frame" in spec.params else {}
    getattr(room.add("armchair"), name)(*(() if spec.target == "none" else (target,)), hard=False, **params)
    found = [r for r in room.scene().relations if r.type == name]
    assert [r.hard for r in found] == ([False] if name == "distance" else [True, False])
    wanted = {"none": None, "wall": "wall:2"}.get(spec.target_kind, target)
    ids = tuple(getattr(t, "id", t) for t in wanted) if isinstance(wanted, tuple) else getattr(wanted, "id", wanted)
    assert {r.target for r in found} == {ids}


def test_methods_say_what_they_take(room):
    facing = room.add("armchair").facing
    assert list(inspect.signature(facing).parameters) == ["target", "hard", "degrees", "offset"]
    assert facing.__doc__ == CATALOGUE["facing"].description
    assert set(CATALOGUE) <= set(dir(room.objects[0]))


def test_the_stub_is_that_of_the_catalogue():
    assert STUB.read_text("utf-8") == stub(), "write it anew: python -m tests.building.builder_stub"


def test_the_stub_has_what_the_code_has():
    """Names and defaults of the arguments that are no relations are those of the code."""
    classes = {node.name: node for node in ast.parse(stub()).body if isinstance(node, ast.ClassDef)}
    for cls in (sw.SceneBuilder, sw.ObjectHandle):
        written = {node.name: node for node in classes[cls.__name__].body if isinstance(node, ast.FunctionDef)}
        for name, function in inspect.getmembers(cls, inspect.isfunction):
            if name.startswith("__") and name != "__init__" or name.startswith("_") and name != "__init__":
                continue
            own = inspect.signature(function).parameters
            if any(p.kind is p.VAR_KEYWORD for p in own.values()) and name in ("add_door", "add_window", "add_many"):
                continue
            args = written[name].args
            named = [a.arg for a in (*args.posonlyargs, *args.args, *args.kwonlyargs)]
            more = {*SHORT, *CATALOGUE} - {"inside"}
            assert [n for n in named if n not in more] == [n for n, p in own.items() if p.kind is not p.VAR_KEYWORD]
    doors = {node.name: node for node in classes["SceneBuilder"].body if isinstance(node, ast.FunctionDef)}
    for name, source in (("add_door", sw.Room.with_door), ("add_window", sw.Room.with_window)):
        named = [a.arg for a in (*doors[name].args.args, *doors[name].args.kwonlyargs)]
        assert named == list(inspect.signature(source).parameters)


def test_edits_of_the_scene_take_handles(room):
    desk, shelf = room.add("desk"), room.add("bookcase")
    scene = room.scene().move(desk, by=(0.1, 0)).relate(shelf, "near", desk).relate("desk-0", "parallel", shelf.object)
    assert [(r.subject, r.target) for r in scene.relations] == [("bookcase-0", "desk-0"), ("desk-0", "bookcase-0")]
    assert scene.unrelate(shelf, "near", desk).remove(desk.object).ids == ("bookcase-0",)
    assert repr(scene) == "Scene('scene': 2 objects, 2 relations)"


def test_a_list_gives_several_relations(room):
    desk, shelf = room.add("desk"), room.add("bookcase")
    room.add("plant", near=[desk, shelf.id], facing=None, parallel=False)
    assert [(r.type, r.target) for r in room.scene().relations] == [("near", "desk-0"), ("near", "bookcase-0")]


WRONG = [
    (lambda r: r.add("desk", facng="x"), '"facng" is no relation; did you mean "facing"?'),
    (lambda r: r.add("desk", against="nord"), 'there is no wall "nord"; did you mean "north"?'),
    (lambda r: r.add("lamp"), "add: a table lamp stands on something; say on=..., or inside=... for a shelf"),
    (lambda r: r.add("lamp", on="desk-7"), "'desk-7' is no object"),
    (lambda r: r.add("desk", facing=True), "facing: say of what (object); True is no target"),
    (lambda r: r.add("desk", between="bed"), "between is"),
    (lambda r: r.add("desk", near=3), "3 is no object; give its id, or what add returned"),
    (lambda r: r.add(" "), "add: name what to add"),
    (lambda r: r.add("books", on=r.add("rug")), 'add: "rug-0" has no top to stand on'),
    (lambda r: r.add("bed", inside=r.add("bookcase")), "fits on no surface"),
    (lambda r: r.add("desk", on="a", inside="b"), "both on and inside"),
    (lambda r: r.add_many(0, "desk"), "add_many: 0 is not a whole number"),
    (lambda r: r.add_door("south", at=2), "door: at is 2; give a share of the wall, 0 to 1"),
    (lambda r: r.add_window("north", width="wide"), "window: width is"),
    (lambda r: r.relate("nobody", "near", "door-0"), "nobody"),
    (lambda r: r.add("desk", at=(1,)), "at is"),
    (lambda r: r.add("desk", width="wide"), "add: width is"),
    (lambda r: r.add("desk", seed=-1), "seed is -1; give a whole number of at least 0"),
]


@pytest.mark.parametrize("call, text", WRONG, ids=[text for _, text in WRONG])
def test_errors_are_one_line(room, call, text):
    with pytest.raises(sw.InputError) as error:
        call(room)
    assert text in str(error.value) and "\n" not in str(error.value)


def test_a_call_that_fails_changes_nothing(room):
    desk = room.add("desk")
    before = room.scene()
    for call in (
        lambda: room.add("office chair", facing=desk, near="nobody"),
        lambda: room.add_many(2, "plant", name="plant"),
        lambda: room.relate(desk, "near", [desk.id]),
    ):
        with pytest.raises(sw.InputError):
            call()
        assert room.scene() is before
    assert room.notes == []


def test_doors_and_windows_can_come_later(room):
    room.add("desk", against="north")
    assert room.add_door("west", name="back door", swing="slide") == "back door"
    assert room.add_window("north") == "window-1" and len(room.scene().room.windows) == 2
    assert [r.type for r in room.scene().relations] == ["against_wall"]
