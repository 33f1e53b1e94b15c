"""What each of several things has: counted out once, with a partner of its own for every one."""

from __future__ import annotations

import pytest

from sceneweaver.language import SceneGraph
from sceneweaver.language.read import read_by_rules
from tests.language.graphs import consistent


def counts(graph: SceneGraph) -> dict[str, int]:
    """How many there are of each category, where that is exact."""
    found: dict[str, int] = {}
    for entity in graph.entities:
        low, high = entity.count or (1, 1)
        assert low == high, entity
        found[entity.category] = found.get(entity.category, 0) + low
    return found


def apiece(graph: SceneGraph) -> set[tuple[str, str, str]]:
    """Relations that hold of each target."""
    return {(r.subject, r.type, r.targets[0]) for r in graph.relations if r.each and len(r.targets) == 1}


COUNTED = [
    (
        "Gallery: three plinths, and a vase and a table lamp on every plinth.",
        {"pedestal": 3, "vase": 3, "table_lamp": 3},
        {("vase", "on", "pedestal"), ("table_lamp", "on", "pedestal")},
    ),
    (
        "A den. Four armchairs, a side table next to each one.",
        {"armchair": 4, "side_table": 4},
        {("side_table", "next_to", "armchair")},
    ),
    (
        "Three desks, behind each desk an office chair and a trash can",
        {"desk": 3, "office_chair": 3, "trash_can": 3},
        {("office_chair", "behind", "desk"), ("trash_can", "behind", "desk")},
    ),
    (
        "Five desks. At each of them a chair.",
        {"desk": 5, "chair": 5},
        {("chair", "at", "desk")},
    ),
    (
        "Office with four desks, at each place a monitor and a keyboard",
        {"desk": 4, "monitor": 4, "keyboard": 4},
        {("monitor", "near", "desk"), ("keyboard", "near", "desk")},
    ),
    (
        "A den with two armchairs. Each armchair has its own floor lamp and its own ottoman.",
        {"armchair": 2, "floor_lamp": 2, "ottoman": 2},
        {("floor_lamp", "near", "armchair"), ("ottoman", "near", "armchair")},
    ),
    (
        "Two desks and four chairs at each desk, so to say.",
        {"desk": 2, "chair": 8},
        {("chair", "at", "desk")},
    ),
    (
        "Two single beds, every bed with a nightstand and a lamp on the nightstand",
        {"single_bed": 2, "nightstand": 2, "table_lamp": 2},
        {("nightstand", "next_to", "single_bed"), ("table_lamp", "on", "nightstand")},
    ),
    (
        "A pottery, seven wheels and at every wheel a stool and a small table",
        {"pottery_wheel": 7, "stool": 7, "bakers_table": 7},
        {("stool", "next_to", "pottery_wheel")},
    ),
    (
        "One stool per desk, five desks.",
        {"stool": 5, "desk": 5},
        {("stool", "at", "desk")},
    ),
    (
        "Six tables, two chairs apiece, one chess board on each.",
        {"dining_table": 6, "chair": 12, "board_game": 6},
        {("chair", "at", "dining_table"), ("board_game", "on", "dining_table")},
    ),
    (
        "For each of the five desks one stool and one trash can.",
        {"desk": 5, "stool": 5, "trash_can": 5},
        {("stool", "at", "desk")},
    ),
    ("Ten tables, four chairs to a table.", {"dining_table": 10, "chair": 40}, {("chair", "at", "dining_table")}),
    ("Every wall has a picture and there is a bed.", {"picture": 4, "bed": 1}, set()),
    ("In each corner a plant.", {"potted_plant": 4}, set()),
    ("A sofa with a floor lamp at each end.", {"sofa": 1, "floor_lamp": 2}, set()),
    ("A table with a chair at each end and three on each long side.", {"dining_table": 1, "chair": 8}, set()),
    ("12 desks and as many stools.", {"desk": 12, "stool": 12}, set()),
    ("Six desks, a bin beside every second desk.", {"desk": 6, "trash_can": 3}, set()),
    ("An armchair at each window, three windows.", {"armchair": 3}, set()),
    (
        "Six desks and six chairs, a chair at each desk.",
        {"desk": 6, "chair": 6},
        {("chair", "at", "desk")},
    ),
    (
        "A table with four chairs. Four place mats lie around a bowl, aligned with each chair.",
        {"dining_table": 1, "chair": 4, "placemat": 4, "bowl": 1},
        set(),
    ),
]


@pytest.mark.parametrize(("text", "count", "each"), COUNTED, ids=[text for text, *_ in COUNTED])
def test_each_has_its_own(text, count, each):
    graph = read_by_rules(text)
    consistent(graph)
    assert counts(graph) == count
    assert each <= apiece(graph)


def test_some_of_those_that_were_named_are_at_each():
    graph = read_by_rules("Three beds, three nightstands (one next to each bed), a wardrobe.")
    assert counts(graph) == {"bed": 3, "nightstand": 3, "wardrobe": 1}
    (said,) = (r for r in graph.relations if r.subject == "nightstand")
    assert (said.type, said.count, said.each) == ("next_to", (1, 1), True)


def test_a_place_said_first_may_follow_a_list():
    graph = read_by_rules("A hallway with a console table, over it a mirror.")
    assert ("wall_mirror", "above", "console_table") in {(r.subject, r.type, *r.targets) for r in graph.relations}


@pytest.mark.parametrize(
    "text",
    [
        "Three stations, each station with a stool, a trolley and a lamp",
        "A salon with three places, each with a stool, a trolley and a lamp",
    ],
)
def test_places_are_no_things_and_have_what_is_told_of_each(text):
    graph = read_by_rules(text)
    assert sorted(counts(graph).values()) == [3, 3, 3]
    stool = next(e.id for e in graph.entities if "stool" in e.category)
    others = {e.id for e in graph.entities} - {stool}
    assert {(r.subject, r.targets[0], r.each) for r in graph.relations} == {(other, stool, True) for other in others}


def test_what_each_working_place_has_is_counted():
    assert sorted(counts(read_by_rules("Three working places. Each place has a stool and a lamp")).values()) == [3, 3]


def test_places_that_have_nothing_are_told_as_not_understood():
    graph = read_by_rules("A table with six places")
    assert [e.category for e in graph.entities] == ["dining_table"]
    assert any("places" in u.words for u in graph.unread)


def test_a_list_of_each_ends_with_its_and():
    graph = read_by_rules("A den with two desks, each with a lamp, a chair and a bin, a sofa and a rug")
    assert counts(graph) == {"desk": 2, "table_lamp": 2, "chair": 2, "trash_can": 2, "sofa": 1, "rug": 1}


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Three work tables, on every table a lamp", {"workbench": 3, "table_lamp": 3}),
        ("Two desks (each with a monitor), two stools", {"desk": 2, "monitor": 2, "stool": 2}),
        ("Every bookcase has a floor lamp next to it, there are three bookcases", {"bookcase": 3, "floor_lamp": 3}),
    ],
)
def test_where_each_begins_and_ends(text, count):
    assert sorted(counts(read_by_rules(text)).values()) == sorted(count.values())


def test_what_each_has_ends_after_its_last_item() -> None:
    graph = read_by_rules("call centre: 5 desks, each has a phone and two chairs, 3 armchairs, a sofa")
    counts = {entity.category: entity.count for entity in graph.entities}
    assert (counts["phone"], counts["chair"]) == ((5, 5), (10, 10))
    assert (counts["armchair"], counts["sofa"]) == ((3, 3), (1, 1))
