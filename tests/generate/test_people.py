"""Places for the people of a request, and patterns of its things, in drafts and in layouts."""

from __future__ import annotations

import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.roles import has_role
from sceneweaver.critic.program import Program
from sceneweaver.knowledge import room_types
from sceneweaver.language import read_request
from sceneweaver.layout.engine import refine
from tests.generate.drafts import brief_of, drawn


@pytest.mark.parametrize(
    ("text", "category", "count"),
    [
        ("a dining room with a table for ten", "dining_chair", 10),
        ("a restaurant with six tables for four", "dining_chair", 24),
        ("a hostel dorm that sleeps 12 in bunks", "bunk_bed", 6),
        ("a classroom for 24 pupils", "school_desk", 24),
        ("a bedroom for my two boys", "single_bed", 2),
        ("an office for six people", "desk", 6),
    ],
)
def test_people_become_places(text: str, category: str, count: int) -> None:
    (entity,) = [e for e in brief_of(text).entities if e.category == category]
    assert entity.count == (count, count)


@pytest.mark.parametrize("text", ["a table for six but only two chairs", "a bedroom for two people, two single beds"])
def test_what_the_request_counts_stays(text: str) -> None:
    brief = read_request(text)
    assert [e.count for e in brief_of(text).entities][: len(brief.entities)] == [e.count for e in brief.entities]


def test_a_table_for_ten_is_long_enough(library: Library) -> None:
    scene = drawn("a dining room with a table for ten", library)
    seats = [o for o in scene.objects if o.category == "dining_chair"]
    (table,) = [o for o in scene.objects if o.intent.request == "dining_table"]
    assert len(seats) == 10
    assert max(table.size[:2]) >= 4 * max(o.size[1] for o in seats)


@pytest.mark.parametrize(("table", "seats"), [("high table", {"bar_stool"}), ("high standing table", set())])
def test_seats_are_as_high_as_their_table_asks(library: Library, table: str, seats: set[str]) -> None:
    scene = drawn(f"a bakery with a {table} and a counter", library)
    assert {o.category for o in scene.objects if has_role(o.category, "table_seat")} == seats
    (high,) = [o for o in scene.objects if o.category == "bar_table"]
    needs = Program.of(scene, room_types()["bakery"], read_request(f"a bakery with a {table}"), 30.0).needs
    assert (high.intent.request == "bar_table") and bool(seats) == any(n.item.id == "chair" for n in needs)


def test_stools_at_a_high_table_are_high(library: Library) -> None:
    scene = drawn("a hallway with a bar table and two stools at it", library)
    assert [o.category for o in scene.objects if o.intent.request == "stool"] == ["bar_stool"] * 2


def test_a_pattern_is_laid_out_about_its_first(library: Library) -> None:
    scene = drawn("a server room, 8 x 6 m, with 2 rows of 4 racks, fronts facing each other, 1.4 m apart", library)
    racks = [o for o in scene.objects if o.category == "server_rack"]
    told = [r for r in scene.relations if r.type == "arranged"]
    assert len(racks) == 8 and len(told) == 7 and len({r.target for r in told}) == 1
    across = [r for r in told if r.params["turn"] == 180.0]
    assert len(across) == 4
    assert [r.params["ahead"] - racks[0].size[0] for r in across] == pytest.approx([1.4] * 4, abs=1e-3)
    bare = scene.model_copy(
        update={"objects": tuple(racks), "relations": tuple(told)},
    )
    assert refine(bare, candidates=16, seed=0, device="cpu").best is not None


def test_stacks_carry_each_other(library: Library) -> None:
    scene = drawn("a storage room with two stacks of three cardboard boxes", library)
    boxes = [o for o in scene.objects if o.intent.request == "cardboard_box"]
    below = {o.id: o.support.object if o.support else None for o in boxes}
    assert len(boxes) == 6
    assert sorted(name is None for name in below.values()) == [False] * 4 + [True] * 2
    assert all(name is None or name in below for name in below.values())


def test_screens_hang_in_rows(library: Library) -> None:
    scene = drawn("an office with a wall of screens three wide and two high", library)
    screens = [o for o in scene.objects if o.intent.request == "monitor"]
    assert len(screens) == 6 and {o.mount for o in screens} == {"wall"}
    heights = [o.intent.mounting_height for o in screens]
    assert len(set(heights)) == 2 and all(heights.count(h) == 3 for h in heights)


def test_the_chairs_of_stations_are_theirs_and_not_the_clerks(library: Library) -> None:
    scene = drawn("a hair salon, four styling stations along the left wall, each with a chair and a trolley", library)
    asked = [o for o in scene.objects if o.intent.request == "chair"]
    assert [o.category for o in asked] == ["barber_chair"] * 4
    assert sum(o.category == "barber_chair" for o in scene.objects) == 4
