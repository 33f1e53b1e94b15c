"""Numbers of people and arrangements, as requests say them."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.language import SceneGraph
from sceneweaver.language.read import read_by_rules


def entity(graph: SceneGraph, category: str) -> Any:
    return next(e for e in graph.entities if e.category == category)


PEOPLE = [
    ("a dining room with a table for ten", 10, "sit", "dining_table"),
    ("a hostel dorm that sleeps 12 in bunks", 12, "sleep", ""),
    ("a classroom for 24 pupils", 24, "work", ""),
    ("a formal dining room, the table seats eight", 8, "sit", "dining_table"),
    ("a break room, staff of five, with a fridge", 5, "sit", ""),
    ("an office with three engineers side by side at a desk", 3, "work", "desk"),
    ("a bedroom for my two boys with a desk wide enough for both", 2, "work", "desk"),
    ("a living room for a family of five, a sofa where all of us fit", 5, "sit", "sofa"),
    ("a bedroom for a couple", 2, "sleep", ""),
    ("a room with five workbenches, four pupils each on stools", 4, "work", "workbench"),
]


@pytest.mark.parametrize(("text", "people", "activity", "target"), PEOPLE)
def test_people_do_something_somewhere(text: str, people: int, activity: str, target: str) -> None:
    graph = read_by_rules(text)
    assert (people, activity, target) in [(c.people, c.activity, c.target) for c in graph.capacities]


def test_people_at_each_of_several_tables_are_counted_together() -> None:
    graph = read_by_rules("a restaurant with six tables for four and a bar")
    assert graph.people == 24
    assert [(c.people, c.each) for c in graph.capacities if c.target] == [(4, True)]
    assert entity(graph, "dining_table").count == (6, 6)


OWN = [
    ("a podcast room, four people at a round table, a microphone and headphones for each", "headphones", 4),
    ("an office for six, two lockers per person", "locker", 12),
    ("a dorm for four students, everybody must have an own wardrobe and own lamp", "wardrobe", 4),
]


@pytest.mark.parametrize(("text", "category", "count"), OWN)
def test_what_is_each_ones_own_is_as_many_as_people(text: str, category: str, count: int) -> None:
    assert entity(read_by_rules(text), category).count == (count, count)


def test_the_table_that_all_are_at_is_nobodys_own() -> None:
    graph = read_by_rules("a podcast room, four people at a round table, a microphone and headphones for each")
    assert entity(graph, "round_dining_table").count == (1, 1)


ARRANGED: list[tuple[str, dict[str, Any], int]] = [
    ("a server room, 3 rows of 4 racks", {"pattern": "rows", "rows": 3, "columns": 4}, 12),
    ("two rows of six lockers, fronts facing each other, 1.2 m apart", {"facing": "each other", "spacing": 1.2}, 12),
    ("a gym with 12 mats laid out in a 3 x 4 grid with 50 cm between them", {"pattern": "grid", "spacing": 0.5}, 12),
    ("a waiting room with three bins in a row", {"pattern": "row", "rows": 1}, 3),
    ("eight armchairs in two groups of four", {"pattern": "cluster", "groups": 2, "columns": 4}, 8),
    ("a meeting room with 12 chairs in a U", {"pattern": "u"}, 12),
    ("a circle of eight chairs", {"pattern": "circle"}, 8),
    ("ten chairs in a semicircle around the fireplace", {"pattern": "semicircle", "around": "fireplace"}, 10),
    ("four benches from oak, two and two back to back", {"pattern": "back_to_back"}, 4),
    ("a store with two stacks of three crates", {"pattern": "stack", "groups": 2, "rows": 3}, 6),
    ("a room with six pews on each side of the aisle", {"pattern": "sides", "sides": (6, 6)}, 12),
    ("a table, two chairs on one side, one on the other", {"pattern": "sides", "sides": (2, 1)}, 3),
    ("a control room, screens four wide and three high", {"pattern": "grid", "upright": True}, 12),
    ("a shop with four parallel shelves, 1 m between them", {"rows": 4, "columns": 1, "spacing": 1.0}, 4),
]


@pytest.mark.parametrize(("text", "said", "count"), ARRANGED)
def test_arrangements_say_how_many_and_how(text: str, said: dict[str, Any], count: int) -> None:
    graph = read_by_rules(text)
    (one,) = graph.arrangements
    assert {name: getattr(one, name) for name in said} == said
    named = graph.entity(one.entity)
    assert named is not None and named.count == (count, count)
    assert not any(e.generic for e in graph.entities)


def test_each_group_is_around_its_own_table() -> None:
    graph = read_by_rules("a lounge, two groups of four armchairs, each group around a small table")
    (one,) = graph.arrangements
    assert entity(graph, "dining_table").count == (2, 2) and one.around == "dining_table"
    (said,) = [r for r in graph.relations if r.subject == "armchair"]
    assert (said.type, said.targets, said.count, said.each) == ("around", ("dining_table",), (4, 4), True)


@pytest.mark.parametrize(
    ("text", "category", "count"),
    [
        ("a lounge with plants everywhere (min. 15)", "potted_plant", (15, 19)),
        ("a waiting room with min. 20 chairs", "chair", (20, 24)),
        ("a kitchen, bottles on the counter, at least 30 of them", "bottle", (30, 34)),
    ],
)
def test_bounds_stand_behind_their_nouns(text: str, category: str, count: tuple[int, int]) -> None:
    assert entity(read_by_rules(text), category).count == count


def test_a_grid_of_so_many_by_so_many_is_no_measure_of_the_room() -> None:
    assert read_by_rules("a yoga studio with 15 mats in a 3 x 5 grid").size is None


@pytest.mark.parametrize("text", ["a table for ten", "three bins in a row", "two groups of four armchairs"])
def test_spans_name_the_words(text: str) -> None:
    graph = read_by_rules(f"A room with {text}, please.")
    said = [*graph.arrangements, *(c for c in graph.capacities if c.span)]
    assert said
    for one in said:
        assert one.span is not None
        assert one.words.startswith(graph.text[one.span.start : one.span.end].strip(" ,"))
