"""Whether places for people, and arrangements, are measured as people mean them."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sceneweaver.language.model import Arrangement, Capacity, Entity
from sceneweaver.scene import Part, SceneObject, Surface
from tests.critic.measuring import CHAIR, TABLE, aligned, box, carrier, graph, on

BUNK = (2.05, 1.0, 1.7)


def chair(x: float, y: float, yaw: float, k: int) -> SceneObject:
    return box(f"dining_chair-{k}", CHAIR, x, y, yaw)


table = box("dining_table-0", TABLE, 3.0, 2.5)
"""0.9 x 1.8 m, its long sides at x = 2.55 and 3.45."""

AT = [chair(2.4, 2.0, 0, 0), chair(2.4, 3.0, 0, 1), chair(3.6, 2.0, 180, 2), chair(3.6, 3.0, 180, 3)]
"""Four chairs that look at the table."""


def of(objects: list[SceneObject], said: Capacity | Arrangement, *more: str) -> Any:
    """What became of a statement; ``more`` are categories that the request names and nothing is of."""
    key = "capacities" if isinstance(said, Capacity) else "arrangements"
    brief = graph(tuple(objects), **{key: (said.model_dump(),)})
    missing = tuple(Entity(id=name, noun=name, category=name) for name in more if brief.entity(name) is None)
    named = tuple(e.model_copy(update={"count": None}) for e in brief.entities)
    brief = brief.model_copy(update={"entities": (*named, *missing)})
    return aligned(tuple(objects), brief).of(said.id)


def seated(people: int, **more: Any) -> Capacity:
    return Capacity(id="capacity-0", people=people, activity="sit", target="dining_table", **more)


def test_seats_at_a_table_are_counted():
    assert of([table, *AT], seated(4), "dining_table", "dining_chair").status == "met"
    short = of([table, *AT], seated(6), "dining_table", "dining_chair")
    assert short.status == "unmet" and short.measured == 4.0


@pytest.mark.parametrize(
    "spoilt", [chair(2.4, 2.0, 180, 0), chair(1.2, 2.0, 0, 0)], ids=["turned away", "out of reach"]
)
def test_a_seat_that_nobody_can_use_at_the_table_does_not_count(spoilt: SceneObject):
    found = of([table, spoilt, *AT[1:]], seated(4), "dining_table", "dining_chair")
    assert found.status == "unmet" and found.measured == 3.0


def test_a_table_too_short_for_its_seats_has_fewer_places():
    small = box("dining_table-0", (0.5, 0.7, 0.75), 3.0, 2.5)
    seats = [chair(2.6, 2.5, 0, 0), chair(3.4, 2.5, 180, 1), chair(3.0, 2.0, 90, 2), chair(3.0, 3.0, -90, 3)]
    assert of([small, *seats], seated(4), "dining_table", "dining_chair").status == "unmet"


def test_beds_count_who_sleeps_in_them():
    beds = [box(f"bunk_bed-{k}", BUNK, 1.5 + 2.5 * k, 2.5) for k in range(2)]
    said = Capacity(id="capacity-0", people=4, activity="sleep")
    assert of(beds, said, "bunk_bed").status == "met"
    assert of(beds[:1], said, "bunk_bed").measured == 2.0


def test_what_is_each_ones_own_is_counted():
    said = Capacity(id="capacity-0", people=3, activity="use", own=(("locker", 2),))
    lockers = [box(f"locker-{k}", (0.5, 0.4, 1.8), 0.5 + 0.5 * k, 0.5) for k in range(6)]
    assert of(lockers, said, "locker").status == "met"
    assert of(lockers[:5], said, "locker").measured == 5.0


def test_own_things_of_nobody_knows_how_many_are_not_met():
    said = Capacity(id="capacity-0", people=0, activity="use", own=(("locker", 1),))
    lockers = [box(f"locker-{k}", (0.5, 0.4, 1.8), 0.5 + 0.5 * k, 0.5) for k in range(2)]
    assert of(lockers, said, "locker").status == "not_understood"
    assert of(lockers, Capacity(id="capacity-0", people=0, activity="sit")).status == "not_understood"


def arranged(pattern: Any, name: str = "locker", **more: Any) -> Arrangement:
    return Arrangement(id="arrangement-0", entity=name, pattern=pattern, words=pattern, **more)


def lockers(*places: tuple[float, float, float]) -> list[SceneObject]:
    return [box(f"locker-{k}", (0.5, 0.4, 1.8), x, y, yaw) for k, (x, y, yaw) in enumerate(places)]


ROWS = [(1.0 + 0.5 * k, 1.0 + 2.0 * row, 90.0 + 180.0 * row) for row in range(2) for k in range(3)]
"""Two rows of three, looking at each other."""

CIRCLE = [
    (3.0 + 1.2 * math.cos(math.radians(a)), 2.5 + 1.2 * math.sin(math.radians(a)), a + 180.0) for a in range(0, 360, 60)
]


@pytest.mark.parametrize(
    ("said", "places", "spoilt"),
    [
        (arranged("rows", rows=2, columns=3), ROWS, (1.0, 1.6, 90.0)),
        (arranged("rows", rows=2, columns=3, facing="each other"), ROWS, (2.0, 3.0, 90.0)),
        (arranged("row", rows=1), ROWS[:3], (2.0, 1.5, 90.0)),
        (arranged("circle"), CIRCLE, (3.0, 2.0, 90.0)),
        (arranged("back_to_back"), [(2.0, 2.0, 0.0), (1.45, 2.0, 180.0)], (1.45, 2.0, 90.0)),
        (arranged("islands"), [(2.0, 2.5, 0.0), (4.0, 2.5, 0.0)], (0.4, 2.5, 0.0)),
        (arranged("cluster", groups=2, columns=2), [(1, 1, 0), (1, 1.6, 0), (4, 3, 0), (4, 3.6, 0)], (2.5, 3, 0)),
    ],
)
def test_a_pattern_holds_until_one_stands_elsewhere(
    said: Arrangement, places: list[tuple[float, float, float]], spoilt: tuple[float, float, float]
):
    assert of(lockers(*places), said, "locker").status == "met"
    assert of(lockers(*places[:-1], spoilt), said, "locker").status == "unmet"


def test_the_gap_that_was_asked_for_is_measured():
    said = arranged("row", rows=1, spacing=1.0)
    assert of(lockers((1, 1, 90), (2.4, 1, 90), (3.8, 1, 90)), said, "locker").status == "met"
    assert of(lockers((1, 1, 90), (1.9, 1, 90), (2.8, 1, 90)), said, "locker").measured == pytest.approx(0.5)


def test_two_chairs_on_one_side_and_one_on_the_other():
    said = arranged("sides", "dining_chair", sides=(2, 1), around="dining_table")
    three = [AT[0], AT[1], AT[2]]
    assert of([table, *three], said, "dining_table", "dining_chair").status == "met"
    assert of([table, AT[0], AT[1], chair(2.4, 2.5, 0, 2)], said, "dining_table", "dining_chair").status == "unmet"


def test_a_stack_is_what_carries_each_other():
    base = carrier(box("cardboard_box-0", (0.4, 0.4, 0.4), 1.0, 1.0))
    top = on(base, "cardboard_box-1", (0.4, 0.4, 0.4))
    beside = box("cardboard_box-1", (0.4, 0.4, 0.4), 2.0, 1.0)
    said = arranged("stack", "cardboard_box", rows=2)
    assert of([base, top], said, "cardboard_box").status == "met"
    assert of([base, beside], said, "cardboard_box").status == "unmet"


def test_things_that_are_not_there_are_not_arranged():
    assert of([], arranged("row", rows=1), "locker").status == "unmet"


HIGH = (0.42, 0.42, 0.75)


def in_all(objects: list[SceneObject], people: int, *named: str) -> Any:
    return of(objects, Capacity(id="capacity-0", people=people, activity="sit"), *named)


def test_a_bar_stool_is_a_place_at_a_bar_alone():
    bar = box("bar_table-0", (0.55, 1.4, 1.05), 3.0, 2.5)
    at = [box(f"bar_stool-{k}", HIGH, 3.45, 2.2 + 0.6 * k, 180) for k in range(2)]
    alone = [box(f"bar_stool-{k}", HIGH, 5.5, 2.2 + 0.6 * k, 180) for k in range(2)]
    assert in_all([bar, *at], 2).status == "met"
    found = in_all([bar, *alone], 2)
    assert found.status == "unmet" and found.measured == 0.0


def test_where_people_sit_at_a_table_a_chair_beside_is_no_place_but_an_armchair_is():
    spare = chair(5.4, 4.4, 180, 4)
    assert in_all([table, *AT, spare], 5).measured == 4.0
    armchair = box("armchair-0", (0.8, 0.8, 0.8), 5.3, 4.3, 180)
    assert in_all([table, *AT, armchair], 5).status == "met"
    assert in_all([spare, chair(5.4, 3.2, 180, 5)], 2).status == "met"  # without a table chairs are to sit on


def test_a_seat_that_nobody_gets_to_is_no_place():
    shut_in = [box(f"armchair-{k}", (0.8, 0.8, 0.8), 5.5, 0.6 + 0.9 * k, 180) for k in range(2)]
    wall = box("bookcase-0", (0.3, 5.0, 2.0), 3.4, 2.5)
    assert in_all(shut_in, 2).status == "met"
    assert in_all([*shut_in, wall], 2).measured == 0.0
    beds = [box("single_bed-0", (2.0, 0.9, 0.5), 4.8, 1.0)]
    said = Capacity(id="capacity-0", people=1, activity="sleep")
    assert of(beds, said).status == "met" and of([*beds, wall], said).measured == 0.0


def test_the_back_of_a_stool_is_not_its_seat():
    bar = box("bar_table-0", (0.55, 1.4, 1.05), 3.0, 2.5)
    seat = Part(polygon=((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)), z=(0.0, 0.75))
    back = Part(polygon=((-0.2, -0.2), (-0.15, -0.2), (-0.15, 0.2), (-0.2, 0.2)), z=(0.75, 1.0))
    stool = box("bar_stool-0", (0.4, 0.4, 1.0), 3.45, 2.5, 180, parts=(seat, back))
    assert in_all([bar, stool], 1).status == "met"


def test_a_bench_with_a_rack_over_its_top_is_sat_at():
    top = Surface(name="top", polygon=((-0.3, -0.5), (0.3, -0.5), (0.3, 0.5), (-0.3, 0.5)), z=0.8, headroom=0.2)
    bench = box("workbench-0", (0.6, 1.2, 1.1), 3.0, 2.5, surfaces=(top,))
    stool = box("stool-0", (0.35, 0.35, 0.45), 3.4, 2.5, 180)
    said = Capacity(id="capacity-0", people=1, activity="work")
    assert of([bench, stool], said).status == "met"
