"""The rules for offices, meetings, waiting rooms, restaurants and gyms: kept by one room, broken by another."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.scene import SceneObject
from tests.critic.breaches import box, broken, hung, on, room, top

Boxes = list[SceneObject]

HALL = room(9.0, 8.0, door=0.3, window=3.0)
DESK, CHAIR, BENCH, TREADMILL = (0.7, 1.4, 0.75), (0.6, 0.6, 1.0), (1.2, 0.5, 0.5), (1.8, 0.85, 1.5)
RACK = (1.6, 2.1, 2.2)


def reception(*more: SceneObject, clerk: float = 3.9) -> Boxes:
    """A desk that looks at the door wall, its clerk behind it, and what else there is."""
    return [
        box("reception_desk-0", (0.8, 2.0, 1.1), 2.0, 3.2, -90),
        box("office_chair-0", CHAIR, 2.0, clerk, -90),
        *more,
    ]


def meeting(yaw: float, *taken: tuple[float, float, float]) -> Boxes:
    """A long table with seats, and a screen on the wall x = 9."""
    table = top(box("conference_table-0", (1.2, 3.0, 0.75), 4.0, 3.0, yaw))
    seats = [box(f"office_chair-{k}", CHAIR, x, y, turn) for k, (x, y, turn) in enumerate(taken)]
    return [table, *seats, hung("tv-0", (0.06, 1.6, 0.9), 8.97, 3.0, 180, 1.0)]


def row(kind: str, size: tuple[float, float, float], step: float, count: int = 3) -> Boxes:
    """Things side by side along the wall y = 0, at a distance [m] from middle to middle."""
    return [box(f"{kind}-{k}", size, 2.0 + step * k, size[0] / 2 + 0.01, 90) for k in range(count)]


def cardio(*spots: tuple[float, float, float]) -> Boxes:
    return [box(f"treadmill-{k}", TREADMILL, x, y, yaw) for k, (x, y, yaw) in enumerate(spots)]


def mats(*spots: tuple[float, float, float]) -> Boxes:
    return [box(f"yoga_mat-{k}", (1.8, 0.65, 0.01), x, y, yaw) for k, (x, y, yaw) in enumerate(spots)]


def round_table(*turns: float) -> Boxes:
    """A round table with chairs at some angles [deg]."""
    from math import cos, radians, sin

    seats = [
        box(f"dining_chair-{k}", CHAIR, 4 + 0.9 * cos(radians(t)), 4 + 0.9 * sin(radians(t)), t + 180)
        for k, t in enumerate(turns)
    ]
    return [top(box("round_dining_table-0", (1.2, 1.2, 0.75), 4.0, 4.0)), *seats]


def laid(*things: str) -> Boxes:
    """A table for two with things on it."""
    table, *seats = round_table(0, 180)
    return [table, *seats, *(on(table, f"{name}-{k}", (0.2, 0.2, 0.1)) for k, name in enumerate(things))]


def chairs(*places: float) -> Boxes:
    return [box(f"chair-{k}", (0.5, 0.5, 0.9), x, 0.27, 90) for k, x in enumerate(places)]


SIT = [(x, y, 90.0 if y < 3 else -90.0) for x in (3.2, 4.8) for y in (2.1, 3.9)]
ROW = [(2.0 + 1.2 * k, 6.9, 90.0) for k in range(3)]
GRID = [box(f"cafe_table-{k}", (0.7, 0.7, 0.75), 2 + 2 * (k % 2), 2 + 2 * (k // 2)) for k in range(4)]
BIN = (0.3, 0.3, 0.4)

BREACHES: list[tuple[str, str, Boxes, Boxes, set[str]]] = [
    (
        "staff_and_visitors_apart",
        "waiting_room",
        reception(box("chair-0", CHAIR, 2.0, 0.4, 90)),
        reception(box("chair-0", CHAIR, 1.0, 4.6, -90)),
        {"chair-0"},
    ),
    (
        "staff_and_visitors_apart",
        "waiting_room",
        reception(),
        reception(clerk=2.4),
        {"office_chair-0", "reception_desk-0"},
    ),
    (
        "desk_looks_at_door",
        "restaurant",
        [box("host_stand-0", (0.5, 0.6, 1.1), 1.6, 2.0, -90)],
        [box("host_stand-0", (0.5, 0.6, 1.1), 8.0, 7.0, -90)],
        {"host_stand-0"},
    ),
    (
        "desk_looks_at_door",
        "waiting_room",
        reception(),
        [box("reception_desk-0", (0.8, 2.0, 1.1), 2.0, 3.2, 90)],
        {"reception_desk-0"},
    ),
    ("seats_in_order", "waiting_room", chairs(2.0, 2.8, 3.6, 4.4), chairs(2.0, 2.55, 3.9, 4.4), {"chair-0", "chair-3"}),
    (
        "coffee_table_distance",
        "waiting_room",
        [*chairs(2.0, 2.7), box("coffee_table-0", (0.5, 1.0, 0.4), 2.4, 1.2, 90)],
        [*chairs(2.0, 2.7), box("coffee_table-0", (0.5, 1.0, 0.4), 6.4, 3.2, 90)],
        {"coffee_table-0"},
    ),
    (
        "piece_in_a_group",
        "waiting_room",
        [*chairs(2.0, 2.7), box("magazine_rack-0", BIN, 3.4, 0.2, 90)],
        [*chairs(2.0, 2.7), box("magazine_rack-0", BIN, 8.4, 5.0, 180)],
        {"magazine_rack-0"},
    ),
    (
        "row_contiguous",
        "gym",
        row("locker", (0.45, 0.45, 1.8), 0.46),
        row("locker", (0.45, 0.45, 1.8), 1.0),
        {"locker-0", "locker-1", "locker-2"},
    ),
    (
        "desk_clusters",
        "office",
        [box(f"desk-{k}", DESK, 3 + 0.71 * (k % 2), 2 + 1.42 * (k // 2)) for k in range(4)],
        [box(f"desk-{k}", DESK, 2 + 2.5 * (k % 2), 2 + 2.5 * (k // 2)) for k in range(4)],
        {"desk-0", "desk-3"},
    ),
    ("table_end_to_screen", "meeting_room", meeting(90, *SIT), meeting(0, *SIT), {"conference_table-0", "tv-0"}),
    (
        "back_to_focus",
        "meeting_room",
        meeting(90, *SIT),
        meeting(90, *SIT, (5.9, 3.0, 180)),
        {"office_chair-4", "tv-0"},
    ),
    (
        "board_seen",
        "meeting_room",
        [*meeting(90, *SIT), box("flip_chart-0", (0.6, 0.7, 1.8), 1.0, 3.0)],
        [*meeting(90, *SIT), box("flip_chart-0", (0.6, 0.7, 1.8), 1.0, 3.0, 90)],
        {"flip_chart-0"},
    ),
    (
        "board_seen",
        "restaurant",
        [box("menu_board-0", (0.5, 0.6, 1.0), 2.0, 0.5, 90)],
        [box("menu_board-0", (0.5, 0.6, 1.0), 2.0, 0.5, -90)],
        {"menu_board-0"},
    ),
    (
        "by_the_door",
        "office",
        [box("coat_rack-0", BIN, 2.0, 0.3)],
        [box("coat_rack-0", BIN, 8.5, 7.5)],
        {"coat_rack-0"},
    ),
    (
        "bin_at_desk",
        "office",
        [box("desk-0", DESK, 3, 3), box("wastebasket-0", BIN, 3.3, 4.0)],
        [box("desk-0", DESK, 3, 3), box("wastebasket-0", BIN, 6.0, 4.0)],
        {"wastebasket-0"},
    ),
    ("seats_even", "kitchen", round_table(0, 90, 180, 270), round_table(0, 60, 180, 250), {"round_dining_table-0"}),
    (
        "plates_equal_seats",
        "restaurant",
        laid("place_setting", "place_setting"),
        laid("place_setting"),
        {"round_dining_table-0"},
    ),
    (
        "plates_equal_seats",
        "meeting_room",
        laid("pitcher", "drinking_glass"),
        laid("pitcher"),
        {"round_dining_table-0"},
    ),
    (
        "tables_on_grid",
        "restaurant",
        GRID,
        [*GRID[:3], box("cafe_table-3", (0.7, 0.7, 0.75), 5.4, 5.4)],
        {"cafe_table-3"},
    ),
    ("machines_in_rows", "gym", cardio(*ROW), cardio(*ROW[:2], (7.0, 3.0, 180)), {"treadmill-2"}),
    ("cardio_view", "gym", cardio(*ROW), cardio((5.0, 1.0, -90), (6.2, 1.0, -90)), {"treadmill-0", "treadmill-1"}),
    (
        "cardio_clear_behind",
        "gym",
        cardio(*ROW),
        [*cardio(*ROW), box("dumbbell_rack-0", BIN, 2.0, 5.2)],
        {"treadmill-0"},
    ),
    (
        "rack_usable",
        "gym",
        [box("squat_rack-0", RACK, 5.0, 4.0)],
        [box("squat_rack-0", RACK, 1.6, 1.06, 0)],
        {"squat_rack-0"},
    ),
    (
        "rack_usable",
        "gym",
        [box("squat_rack-0", RACK, 5.0, 4.0), box("trash_can-0", BIN, 7.0, 4.0)],
        [box("squat_rack-0", RACK, 5.0, 4.0), box("trash_can-0", BIN, 5.0, 4.2)],
        {"squat_rack-0", "trash_can-0"},
    ),
    (
        "weights_at_mirror",
        "gym",
        [box(f"weight_bench-{k}", BENCH, 3 + 2 * k, 4.0, 90) for k in range(2)],
        [box(f"weight_bench-{k}", BENCH, 3 + 2 * k, 4.0, 90 * k) for k in range(2)],
        {"weight_bench-0", "weight_bench-1"},
    ),
    (
        "weights_at_mirror",
        "gym",
        [hung("wall_mirror-0", (0.03, 3.0, 1.8), 0.02, 4.0, 0, 0.2)],
        [hung("wall_mirror-0", (0.03, 0.8, 1.8), 0.02, 4.0, 0, 0.2)],
        {"wall_mirror-0"},
    ),
    (
        "pieces_apart",
        "gym",
        [box("leg_press-0", (2.0, 1.4, 1.4), 3, 3), box("elliptical-0", (1.6, 0.6, 1.5), 3, 5)],
        [box("leg_press-0", (2.0, 1.4, 1.4), 3, 3), box("elliptical-0", (1.6, 0.6, 1.5), 3, 4.05)],
        {"leg_press-0", "elliptical-0"},
    ),
    ("mats_together", "gym", mats((3, 3, 0), (3, 3.8, 0)), mats((3, 3, 0), (3, 3.8, 20)), {"yoga_mat-1"}),
    (
        "mats_together",
        "gym",
        [*mats((3, 3, 0), (3, 3.8, 0)), box("cable_machine-0", (1.0, 2.0, 2.2), 6, 3, 180)],
        [*mats((3, 3, 0), (3, 3.8, 0)), box("cable_machine-0", (1.0, 2.0, 2.2), 4.3, 3, 180)],
        {"yoga_mat-0"},
    ),
    (
        "gym_things_stored",
        "gym",
        [
            box("kettlebell_rack-0", BENCH, 2, 7.7, -90),
            box("medicine_ball-0", BIN, 2.9, 7.7),
            box("medicine_ball-1", BIN, 3.3, 7.7),
        ],
        [box("medicine_ball-0", BIN, 2.9, 7.7), box("medicine_ball-1", BIN, 8.0, 4.0)],
        {"medicine_ball-0", "medicine_ball-1"},
    ),
]


@pytest.mark.parametrize(
    ("rule", "kind", "good", "bad", "objects"), BREACHES, ids=[f"{k}-{line[0]}" for k, line in enumerate(BREACHES)]
)
def test_a_room_keeps_the_rule_and_another_breaks_it(rule, kind, good, bad, objects) -> None:
    assert not broken(rule, kind, good, HALL)
    assert objects <= broken(rule, kind, bad, HALL)


def test_knees_have_room_around_a_corner() -> None:
    def corner(x: float) -> Any:
        seats = [box("armchair-0", (0.8, 0.8, 0.9), x, 0.45, 90), box("armchair-1", (0.8, 0.8, 0.9), 0.45, 1.5)]
        return broken("seats_in_order", "waiting_room", seats, room(6.0, 5.0, door=4.5))

    assert not corner(1.6) and corner(0.8) == {"armchair-0", "armchair-1"}


def test_a_bench_inside_a_rack_is_where_it_is_used() -> None:
    assert not broken("rack_usable", "gym", [box("squat_rack-0", RACK, 5, 4), box("weight_bench-0", BENCH, 5, 4)], HALL)


def test_rules_of_one_kind_of_room_do_not_bind_another() -> None:
    assert not broken("desk_clusters", "study", [box(f"desk-{k}", DESK, 2 + 2 * k, 3) for k in range(4)], HALL)
    assert not broken("machines_in_rows", "living_room", cardio(*ROW[:2], (7.0, 3.0, 180)), HALL)


def test_what_stands_far_from_the_door_or_looks_away_from_it_is_tied_to_it() -> None:
    from sceneweaver.critic.design import faults
    from tests.critic.breaches import survey

    things = [box("host_stand-0", (0.5, 0.6, 1.1), 8.0, 7.0, -90), box("coat_rack-0", BIN, 8.5, 7.5)]
    found = {f.fault.rule: f.fault for f in faults(survey("restaurant", things, HALL))}
    for rule, types in (("desk_looks_at_door", {"facing_door", "near_door"}), ("by_the_door", {"near_door"})):
        rows = found[rule].inputs["relations"]
        assert found[rule].tool == "add_relation" and {row["type"] for row in rows} == types
        assert {(row["subject"], row["target"]) for row in rows} == {(found[rule].objects[0], "door-0")}


def test_shelves_in_aisles_and_books_without_number_are_no_fault() -> None:
    aisles = [box(f"metal_shelf-{k}", (0.5, 1.2, 1.8), 3.0, 2.0 + 1.6 * k, 90) for k in range(3)]
    assert not broken("row_contiguous", "library", aisles, HALL)
    shelf = top(box("bookcase-0", (0.4, 1.0, 1.8), 4.0, 0.25, 90))
    few = [on(shelf, f"standing_books-{k}") for k in range(4)]
    assert broken("not_cloned", "study", [shelf, *few], HALL) >= {"standing_books-0"}
    assert not broken("not_cloned", "library", [shelf, *(on(shelf, f"standing_books-{k}") for k in range(40))], HALL)
