"""Words of place: participles, sides of who sits, sides and halves of the room."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules

PLACED = [
    ("a vise on a bench, a plank clamped in the vise", "inside", "vise"),
    ("a bedroom with a shirt thrown over the armchair", "on", "armchair"),
    ("a study with a map pinned to the wall", "on", "wall"),
    ("a cellar with a ladder wedged between the freezer and the wardrobe", "between", "freezer"),
    ("a library where the armchairs stand back to back with the bookcases", "back_to_back", "bookcase"),
    ("a stove with three mugs hanging from a line", "hanging_from", "clothes_line"),
    ("a hall with a long table down the middle", "at", "middle"),
    ("a playroom with a tent by the way in", "near", "door"),
    ("a cabin with lockers on the starboard side", "against", "wall:right"),
    ("a hall with ten chairs along the same wall as the door", "along", "wall:door"),
    ("a kitchen with a stove and a fridge, all port side", "against", "wall:left"),
    ("a barn. Gate far end.", "against", "wall:far"),
    ("a diner with four tables in the east half", "at", "half:east"),
]


@pytest.mark.parametrize(("text", "kind", "target"), PLACED)
def test_words_of_place_are_read(text, kind, target):
    graph = read_by_rules(text)
    assert (kind, target) in {(r.type, r.targets[0]) for r in graph.relations}
    assert not graph.unread


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("a recliner and a side table at its right hand", "left_of"),
        ("a toilet and a grab bar on his left as he sits on it", "right_of"),
        ("a grab bar on her right as she sits on the toilet", "left_of"),
        ("a side table to the right of the recliner", "right_of"),
    ],
)
def test_sides_of_who_sits_are_not_those_of_who_looks_at_the_seat(text, kind):
    """Relations have the sides of who looks at a thing's front: the right hand of who sits there is at its left."""
    (said,) = read_by_rules(text).relations
    assert said.type == kind


def test_a_hand_without_a_seat_is_told():
    graph = read_by_rules("a basin at his right hand")
    assert not graph.relations
    assert [u.words for u in graph.unread] == ["at his right hand"]


def test_the_other_side_is_that_of_the_same_thing():
    graph = read_by_rules("A chair to one side of the fireplace and a piano to the other.")
    assert {(r.type, r.subject, r.targets) for r in graph.relations} == {
        ("next_to", "chair", ("fireplace",)),
        ("next_to", "upright_piano", ("fireplace",)),
    }


def test_what_people_are_on_is_under_no_thing():
    graph = read_by_rules("A desk with a lamp facing the clerk, who sits on a raised platform.")
    assert all("stage_platform" not in r.targets for r in graph.relations)


def test_where_another_room_is_says_nothing_of_furniture():
    graph = read_by_rules("A restaurant; the kitchen in the east half, four tables in the west half.")
    assert [r.targets for r in graph.relations] == [("half:west",)]


def test_doors_at_both_ends_are_in_both_short_walls():
    graph = read_by_rules("A ward with a door at both ends.")
    assert graph.doors == 2
    assert [(o.part, o.wall, o.opposite) for o in graph.openings] == [
        ("door", "short", ""),
        ("door", "any", "opening-0"),
    ]


def test_a_spot_is_told_of_by_what_is_there():
    graph = read_by_rules("A pot on the stove. One very tidy spot in the middle, a round table.")
    assert ("at", "round_dining_table", ("middle",)) in {(r.type, r.subject, r.targets) for r in graph.relations}


@pytest.mark.parametrize(
    ("text", "target"),
    [
        ("a wardrobe on the left side of the room", "wall:left"),
        ("a piano at the right side of the room", "wall:right"),
        ("a bench to one side of the room", "wall:side"),
    ],
)
def test_sides_of_the_room_are_its_walls(text, target):
    assert [(r.type, r.targets) for r in read_by_rules(text).relations] == [("against", (target,))]


def test_the_other_end_is_of_the_room_too():
    graph = read_by_rules("A stove at one end, a piano at the other.")
    assert {(r.type, r.subject, r.targets) for r in graph.relations} == {
        ("against", "wood_stove", ("wall:short",)),
        ("against", "upright_piano", ("wall:short",)),
    }
