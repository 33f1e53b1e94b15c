"""Lengths of things: which thing, which extent or part, which interval."""

import pytest

from sceneweaver.language.read import read_by_rules

SAID = [
    ("a study with a desk 1.5 m wide, with a depth of 65 cm", "desk", {"width": (1.5, 1.5), "depth": (0.65, 0.65)}),
    ("a hall with a 35 cm deep bench", "bench", {"depth": (0.35, 0.35)}),
    ("a den with a round coffee table, 3 ft across", "round_coffee_table", {"diameter": (0.9144, 0.9144)}),
    ("a shed, workbench with its top at 92 cm", "workbench", {"top": (0.92, 0.92)}),
    ("a foyer with a mirror hung with its centre at 1.45 m", "wall_mirror", {"centre": (1.45, 1.45)}),
    ("a den with a bookcase between 1.6 and 1.8 m high", "bookcase", {"height": (1.6, 1.8)}),
    ("a den, the sideboard at most 70 cm high", "sideboard", {"height": (None, 0.7)}),
    ("a bedroom with a wardrobe up to the ceiling", "wardrobe", {"ceiling": (0.0, 0.0)}),
    ("a canteen with a table 2.4 x 0.9 m", "dining_table", {"length": (2.4, 2.4), "width": (0.9, 0.9)}),
    ("a hall with coat hooks at shoulder height", "coat_hooks", {"placed": (1.3, 1.5)}),
]


@pytest.mark.parametrize(("text", "category", "wanted"), SAID)
def test_a_length_is_of_its_thing(text, category, wanted):
    graph = read_by_rules(text)
    assert {m.quantity: (m.low, m.high) for m in graph.measures if m.entity == category} == wanted
    assert not graph.unread


@pytest.mark.parametrize(
    "text",
    [
        "a den with a sofa 2 m away from the window",
        "a den with an aisle 1.2 m wide between two bookcases",
        "a den 4 m long",
    ],
)
def test_distances_and_rooms_are_no_lengths_of_things(text):
    assert not read_by_rules(text).measures


def test_a_plain_table_becomes_one_of_the_height():
    graph = read_by_rules("a bar with two tables, tops at 1.05 m")
    assert [e.category for e in graph.entities] == ["bar_table"]
    assert graph.entities[0].size[2] == 1.05


def test_worktops_without_a_thing_are_those_of_the_room():
    (measure,) = read_by_rules("a kitchen with the worktops at 84 cm").measures
    assert (measure.entity, measure.quantity, measure.low) == ("", "top", 0.84)
