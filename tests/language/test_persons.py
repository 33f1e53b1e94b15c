"""People by any noun for them, together and in wheelchairs, and what so many of them need."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    ("text", "people", "activity"),
    [
        ("a bookbindery for two gilders", 2, "work"),
        ("a sleeping car with four porters", 4, "sleep"),
        ("a weaving studio for me and one apprentice", 2, "work"),
        ("a waiting room for a plumber, two painters and a mason", 0, "wait"),
        ("a tailor shop where three furriers and a milliner work", 4, "work"),
        ("a great hall. Thirty-four warriors eat there", 34, "eat"),
        ("a sauna, six of us", 6, "sit"),
        ("we are nine, a dining room", 9, "eat"),
    ],
)
def test_who_is_counted_is_somebody(text: str, people: int, activity: str) -> None:
    graph = read_by_rules(text)
    if people:
        assert (graph.people, graph.capacities[-1].activity) == (people, activity), graph.capacities
        assert not graph.unread, graph.unread
    assert not any(entity.generic for entity in graph.entities)


@pytest.mark.parametrize(
    ("text", "category", "count"),
    [
        ("a study with two runners", "rug", None),
        ("an office with one nurse station", "reception_desk", (1, 1)),
        ("a bedroom with two single beds", "single_bed", (2, 2)),
        ("a den for eight card players, two of them in wheelchairs", "wheelchair", (2, 2)),
        ("a potting shed with somewhere for Ann to sit and rest", "armchair", (1, 1)),
        ("a banquet hall with 7 rounds of 8", "round_dining_table", (7, 7)),
        ("a milking parlour, five a side", "milking_stall", (10, 10)),
    ],
)
def test_what_is_no_person_and_what_people_need(text: str, category: str, count: tuple[int, int] | None) -> None:
    graph = read_by_rules(text)
    found = [e for e in graph.entities if e.category == category]
    assert count is None or [e.count for e in found] == [count], graph.entities


def test_words_of_people_are_those_of_the_request() -> None:
    (said,) = read_by_rules("an interrogation room, one sheriff and one burglar at a table").capacities
    assert (said.people, said.target) == (2, "interview_table")
    assert said.words.startswith("one sheriff and one burglar")


def test_so_many_a_side_of_a_table() -> None:
    (said,) = read_by_rules("a meeting room with a table, four a side").capacities
    assert (said.people, said.activity, said.target) == (8, "sit", "dining_table")


def test_hundreds_of_small_things_leave_room_for_others() -> None:
    graph = read_by_rules("a wine shop with 900 bottles and two racks")
    assert [(e.category, e.count) for e in graph.entities][1:] == [("wine_rack", (2, 2))]
    assert any("900 x bottles was brought to" in note for note in graph.notes)


@pytest.mark.parametrize(
    ("text", "people"),
    [
        ("a flight simulator for a pilot and a navigator", 2),
        ("a cafe with a table for a widow and two lodgers", 3),
        ("a bedroom for my nephew and his rival", 2),
        ("a music room for a brass quintet", 5),
        ("a theatre foyer, forty critics standing", 40),
    ],
)
def test_people_who_are_named_one_by_one_are_counted(text: str, people: int) -> None:
    assert read_by_rules(text).people == people


def test_animals_and_vehicles_are_nobody() -> None:
    for text in ("a stable for four ponies", "a garage for two tractors"):
        graph = read_by_rules(text)
        assert graph.people is None
        assert graph.unread
