"""As many have places as a request says: seats, tables long enough, bars at windows, beds and desks of their own."""

from __future__ import annotations

from collections import Counter

import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.roles import has_role
from sceneweaver.generate.people_seats import places_of
from sceneweaver.language.vocabulary import family
from tests.generate.drafts import brief_of, drawn


def counts(text: str) -> Counter[str]:
    found = Counter[str]()
    for one in brief_of(text).entities:
        found[one.category] += one.count[0] if one.count else 1
    return found


@pytest.mark.parametrize("people", [5, 7, 10])
def test_seats_of_several_kinds_hold_all_together_and_hardly_more(people: int) -> None:
    brief = brief_of(f"a lounge with sofas and armchairs, seats for {people} people")
    seats = [e for e in brief.entities if family(e.category) == "seat"]
    assert all(e.count and e.count[0] == e.count[1] >= 2 for e in seats)
    assert people <= sum(places_of(e) for e in seats) <= max(people + 1, 8)  # two of each are eight places


def test_seats_of_a_room_that_nobody_described_have_tables() -> None:
    found = counts("a qwertz place, seats for 16, an espresso machine, a display case, bar stools along its window")
    assert found["bar_table"] == 1 and found["cafe_table"] >= 2
    assert found["bar_stool"] + found["dining_chair"] + found["chair"] >= 16


@pytest.mark.parametrize(("text", "bars"), [("two stools at the window", 1), ("a stool at the window", 0)])
def test_stools_at_a_window_have_a_bar(text: str, bars: int) -> None:
    brief = brief_of(f"a bakery with a counter and {text}")
    made = [e for e in brief.entities if e.category == "bar_table"]
    assert len(made) == bars
    for bar in made:
        assert bar.size[1] is not None and bar.size[1] >= 2 * 0.55
        assert {r.type for r in brief.relations if r.subject == bar.id and r.targets == ("window",)} == {"at", "below"}
        assert any(r.targets == (bar.id,) for r in brief.relations if r.subject == "stool")


def test_the_tables_of_the_room_are_there_beside_the_bar(library: Library) -> None:
    found = Counter(o.category for o in drawn("a cafe with high stools along the window", library).objects)
    assert found["bar_table"] == 1 and found["cafe_table"] >= 2 and found["bar_stool"] == 4
    assert found["chair"] + found["dining_chair"] >= 2 * found["cafe_table"]


def test_a_bed_in_a_room_with_a_stool_at_its_window_gets_no_bar() -> None:
    assert not counts("a bedroom with a bed and two stools at the window")["bar_table"]


def test_of_things_for_one_everybody_has_one() -> None:
    found = counts("a bedroom for three sisters with beds, desks and lockers")
    assert (found["single_bed"], found["desk"], found["locker"]) == (3, 3, 3)
    assert counts("a bedroom for three sisters with two beds")["bed"] == 2  # as it was said


def test_a_bench_for_a_team_is_of_several() -> None:
    (bench,) = [e for e in brief_of("a changing room with a bench for nine players").entities if "bench" in e.category]
    assert bench.count is not None and bench.count[0] > 1 and places_of(bench) >= 9


def test_a_lounge_chair_in_a_corner_is_no_place_of_a_pupil() -> None:
    brief = brief_of("a classroom for 16 pupils, eight tables in rows, and a reading corner with an armchair")
    (chairs,) = [e for e in brief.entities if has_role(e.category, "upright_seat")]
    assert chairs.count == (16, 16)
    (said,) = [r for r in brief.relations if r.subject == chairs.id]
    assert said.count == (2, 2) and said.each


def test_tables_are_as_many_as_the_seats_fill() -> None:
    found = counts("a tea room with 12 chairs and small round tables")
    assert (found["chair"], found["cafe_table"]) == (12, 6)


def test_a_table_is_as_long_as_the_chairs_that_are_counted_need(library: Library) -> None:
    scene = drawn("a dining room with a table and twelve chairs", library)
    (table,) = [o for o in scene.objects if o.intent.request == "dining_table"]
    assert max(table.size[:2]) >= 5 * 0.6


def test_chairs_of_a_waiting_room_are_not_put_around_a_childs_table() -> None:
    brief = brief_of("a dentist's waiting room with ten chairs and a small kids table")
    assert not [r for r in brief.relations if r.subject == "chair" and "kids_table" in r.targets]
    brief = brief_of("a doctor's waiting room with ten chairs and a table with magazines")
    assert not [r for r in brief.relations if r.subject == "chair" and "dining_table" in r.targets]


def test_children_sit_at_low_tables_on_small_chairs() -> None:
    found = counts("a room where ten children paint at low tables, with a sink")
    assert found["kids_table"] >= 2 and found["kids_chair"] >= 10 and not found["coffee_table"]


def test_who_looks_at_a_board_sits_on_the_far_side_of_the_table(library: Library) -> None:
    scene = drawn("a training room for eight, four tables in two rows facing the whiteboard", library)
    sides = {r.params["side"] for r in scene.relations if r.type == "seated_at"}
    assert sides == {"back"}


def test_more_people_have_more_floor(library: Library) -> None:
    few, many = (drawn(f"a living room for {n} people", library).room for n in (4, 9))
    assert _area(many.outline) > _area(few.outline) + 4.0


def _area(outline: tuple[tuple[float, float], ...]) -> float:
    pairs = zip(outline, (*outline[1:], outline[0]), strict=True)
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs)) / 2
