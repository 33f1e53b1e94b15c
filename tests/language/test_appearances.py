"""Colours and materials behind their nouns, of some of several, and of parts."""

import pytest

from sceneweaver.language.read import read_by_rules
from sceneweaver.language.told_states import colors_as_told

SAID = [
    (
        "a lounge with three stools, one green and two grey, by the bar",
        "stool",
        [("color", "green", (1, 1)), ("color", "grey", (2, 2))],
    ),
    ("a den with a sofa in navy linen and oak shelves", "sofa", [("color", "navy", None), ("material", "linen", None)]),
    ("a hall with a bench, walnut", "bench", [("material", "walnut", None)]),
    (
        "a den, coffee table with a white marble top and brass legs",
        "coffee_table",
        [("part", "white marble top", None), ("part", "brass legs", None)],
    ),
    ("a study, desk, steel legs, oak top", "desk", [("part", "steel legs", None), ("part", "oak top", None)]),
]


@pytest.mark.parametrize(("text", "category", "wanted"), SAID)
def test_a_look_is_of_its_thing(text, category, wanted):
    graph = read_by_rules(text)
    (entity,) = [e for e in graph.entities if e.category == category]
    assert [(a.kind, a.value, a.count) for a in entity.attributes] == wanted
    assert not graph.unread
    assert not any("marble" in e.category for e in graph.entities)


@pytest.mark.parametrize("text", ["a den with walls in pale blue", "a den, blue, white and airy"])
def test_colours_of_rooms_are_of_no_thing(text):
    assert not read_by_rules(text).entities


@pytest.mark.parametrize(
    ("text", "category", "colors"),
    [
        ("a changing room with six lockers, each in another colour", "locker", ("red", "orange", "yellow")),
        ("a playroom, four stools all in different colours", "stool", ("red", "orange", "yellow")),
        ("a hall with three armchairs in red, white and navy", "armchair", ("red", "white", "navy")),
    ],
)
def test_things_have_several_colors_between_them(text, category, colors):
    entity = read_by_rules(text).entity(category)
    assert entity is not None and entity.color is None
    (told,) = [found for one in entity.attributes if (found := colors_as_told(one))]
    assert told[:3] == colors


def test_the_colors_of_a_team_are_the_rooms():
    brief = read_by_rules("a den in the club colours orange and navy, a sofa")
    assert brief.colors == ("orange", "navy") and [e.category for e in brief.entities] == ["sofa"]
