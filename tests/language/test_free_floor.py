"""Free floor in requests: what is read as such, with which measure and about what, and what is not."""

from __future__ import annotations

import pytest

from sceneweaver.language import SceneGraph
from sceneweaver.language.read import read_by_rules

READ = [
    # ---- circles
    ("bathroom with a turning circle of 1.6 m for the wheelchair", "circle", 1.6, ()),
    ("accessible wc, 5 ft turning circle, grab rails by the toilet", "circle", 1.524, ()),
    ("An office with a desk and a turning radius of 75 cm in front of the desk", "circle", 1.5, ("desk",)),
    ("Kitchen with space to turn a wheelchair", "circle", 1.5, ()),
    ("A bathroom, 150cm of space for a wheelchair to turn", "circle", 1.5, ()),
    ("Study with a bookcase, keep the middle of the room clear", "circle", 1.5, ("middle",)),
    ("a dance studio with a mirror. The centre of the room stays empty", "circle", 1.5, ("middle",)),
    # ---- rectangles
    ("playroom with 2 x 1.5 m of free floor for the train set", "rectangle", 2.0, ()),
    ("gym with a mirror; an open area of 2 by 2 metres in front of the mirror", "rectangle", 2.0, ("wall_mirror",)),
    ("A nursery. Keep one by one metre free inside the door.", "rectangle", 1.0, ("door",)),
    ("living room, free floor space for yoga, about 200 x 90 cm", "rectangle", 2.0, ()),
    ("a bedroom with some open space to play, at least 6 x 5 ft", "rectangle", 1.8288, ()),
    # ---- ways
    ("shop with 2 shelves and a desk, aisle of 1.2 m from the entrance to the desk", "path", 1.2, ("door", "desk")),
    ("hall: keep a straight walkway of 1.1 m from door to door", "path", 1.1, ("door", "door:2")),
    ("an armchair, a path maybe 50-60 cm wide from the door to the armchair", "path", 0.5, ("door", "armchair")),
    ("A bed. Nothing may stand between the bed and the door, 90 cm wide at least.", "path", 0.9, ("bed", "door")),
    ("library, all aisles at least 36 inches wide", "path", 0.9144, ()),
    ("a clear path from the door to the window in a storage room", "path", 0.8, ("door", "window")),
    ("a bar with a sofa, a 1 m wide path to the sofa", "path", 1.0, ("door", "sofa")),
    ("workshop with a central aisle through the middle of the room", "path", 0.8, ()),
    # ---- gaps
    ("classroom with four desks, 1.2 m between the desks", "gap", 1.2, ("desk",)),
    ("Studio: five benches, 1 m between them, a mirror", "gap", 1.0, ("bench",)),
    ("an island and a fridge, 4 ft between the island and the fridge", "gap", 1.2192, ("kitchen_island", "fridge")),
    ("the gap between sofa and coffee table should be 45 cm. living room", "gap", 0.45, ("sofa", "coffee_table")),
    ("a bathtub that stands 50 cm off the walls", "gap", 0.5, ("bathtub", "wall")),
    ("Lounge. The sofa must be half a metre away from the wall!", "gap", 0.5, ("sofa", "wall")),
    # ---- beside things
    ("massage room, 80 cm every side of the massage table", "clearance", 0.8, ("massage_table",)),
    ("dining room. Keep 3 ft clear all around the table.", "clearance", 0.9144, ("dining_table",)),
    ("Study with two desks with 1.2 m clear in front of them", "clearance", 1.2, ("desk",)),
    ("a bed, half a metre of free space on both sides of the bed", "clearance", 0.5, ("bed",)),
    ("laundry, 900 mm clear in front of the washing machine", "clearance", 0.9, ("washing_machine",)),
    ("a sofa that can be reached from both long sides", "clearance", 0.7, ("sofa",)),
    ("dining room with a table and enough space to walk around the table", "clearance", 0.7, ("dining_table",)),
    ("a wardrobe with clearance of 3' 3\" in front of it", "clearance", 0.9906, ("wardrobe",)),
]  # fmt: skip

NOT_READ = [
    "a table 1.2 m wide between the windows",
    "a bookcase with a shelf between 1.0 and 1.4 m high",
    "a room 4 x 5 m with a bed",
    "a bedroom of 3.5 by 4 m, free of clutter",
    "Bed 1.6 m wide in front of the window",
    "a picture 1.5 m above the sofa",
    "a shelf 30 cm deep around the room",
    "rug 2 x 3 m in front of the sofa",
    "two chairs on each side of the table",
    "nightstands on both sides of the bed",
    "a lamp between the sofa and the chair",
    "6 ft table in front of the bench",
    "a 2 m sofa between two lamps",
    "a free-standing bathtub in the middle of the room",
    "an open shelf next to the desk",
]


def only_area(graph: SceneGraph):
    assert len(graph.free_areas) == 1, graph.free_areas
    return graph.free_areas[0]


@pytest.mark.parametrize(("text", "kind", "width", "about"), READ)
def test_phrase_is_read(text, kind, width, about):
    graph = read_by_rules(text)
    area = only_area(graph)
    first = tuple(name.rpartition("-")[0] if name[-1].isdigit() and "-" in name else name for name in area.targets)
    assert (area.kind, first) == (kind, about)
    assert area.size[0] == pytest.approx(width, abs=1e-3)
    assert area.span is not None and text[area.span.start : area.span.end].strip()
    assert not {e.noun for e in graph.entities} & {"aisle", "path", "walkway", "cm", "circle", "gap", "clearance"}


@pytest.mark.parametrize("text", NOT_READ)
def test_measures_of_things_are_left_to_things(text):
    assert not read_by_rules(text).free_areas


def test_a_thing_that_only_the_phrase_names_is_still_made():
    graph = read_by_rules("laundry, 90 cm clear in front of the washing machine")
    assert [e.category for e in graph.entities] == ["washing_machine"]


def test_sides_that_are_meant():
    sides = {
        "a bed with 60 cm free on both sides of the bed": "sides",
        "a bed with 60 cm free on both long sides of the bed": "long",
        "a bed with 60 cm free all around the bed": "around",
        "a bed with 60 cm clear behind the bed": "back",
        "a bed with 60 cm clear in front of it": "front",
    }
    assert {text: only_area(read_by_rules(text)).side for text in sides} == sides


def test_a_range_has_a_least_and_a_most():
    area = only_area(read_by_rules("an armchair and a path 50 to 60 cm wide from the door to the armchair"))
    assert (area.size[0], area.most) == (0.5, 0.6)


def test_free_floor_is_no_size_of_the_room():
    graph = read_by_rules("a bedroom with free floor for lego, say 1.5 by 1.5 m")
    assert graph.size is None
    assert only_area(graph).size == (1.5, 1.5)
    assert read_by_rules("a bedroom of 4 x 5 m with 2 x 1 m of free floor").size == (5.0, 4.0)


def test_one_phrase_may_say_two_things():
    graph = read_by_rules("a lounge with two sofas, 1.2 m between the sofas and to the door")
    assert [(a.kind, a.targets) for a in graph.free_areas] == [("gap", ("sofa",)), ("path", ("door", "sofa"))]


@pytest.mark.parametrize(
    ("text", "width"),
    [
        ("A tailor's shop, aisle at least 1.1 m wide.", 1.1),
        ("An archive with corridors no narrower than 85 cm", 0.85),
        ("a 1.5 m wide walkway and ten benches", 1.5),
    ],
)
def test_a_way_with_a_width_alone_is_one_through_the_room(text, width):
    (area,) = read_by_rules(text).free_areas
    assert (area.kind, area.size[0], area.targets) == ("path", width, ())


def test_a_corridor_with_its_length_is_a_room():
    assert not read_by_rules("a corridor 1.5 m wide and 6 m long with a bench").free_areas
