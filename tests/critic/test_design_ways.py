"""The rules for ways, doors, the room that things need, and light: a room that keeps each, and one that breaks it."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.scene import SceneObject
from tests.critic.breaches import box, broken, hung, lamp, on, room, top

Boxes = list[SceneObject]

TABLE, CHAIR, DESK, WARDROBE = (0.9, 1.6, 0.75), (0.5, 0.5, 0.9), (0.7, 1.4, 0.75), (0.6, 1.2, 2.1)


def seated(x: float, y: float, lifted: float = 0.0) -> Boxes:
    """A table along x with four chairs at its long sides, pushed off its middle along y."""
    spots = [(dx, dy) for dx in (-0.4, 0.4) for dy in (-1, 1)]
    chairs = [
        box(f"dining_chair-{k}", CHAIR, x + dx, y + 0.6 * dy + lifted, -90.0 * dy) for k, (dx, dy) in enumerate(spots)
    ]
    return [top(box("dining_table-0", TABLE, x, y + lifted, 90)), *chairs]


def bar(y: float) -> Boxes:
    """A bar whose front looks into the room, its middle some way off the wall y = 0."""
    return [box("bar_counter-0", (0.6, 2.4, 1.1), 3.5, y, 90)]


def window_side(height: float) -> Boxes:
    return [box("cabinet-0", (0.4, 1.0, height), 2.8, 4.78, -90)]


def bed(*lamps: SceneObject) -> Boxes:
    stands = [top(box(f"nightstand-{k}", (0.4, 0.45, 0.5), 0.25, y)) for k, y in enumerate((1.2, 3.3))]
    return [box("bed-0", (2.0, 1.6, 0.5), 1.05, 2.25), *stands, *lamps]


STANDS = [b for b in bed() if b.category == "nightstand"]
WALLED = room(6.0, 5.0, window=None)
NARROW = [box("bookcase-0", (0.4, 2.6, 1.8), 4.3, 2.5, 90), box("bookcase-1", (0.4, 2.3, 1.8), 1.25, 2.5, 90)]

BREACHES: list[tuple[str, str, Any, Any, set[str]]] = [
    (
        "door_frame",
        "bedroom",
        [box("dresser-0", (0.45, 1.0, 0.9), 2.2, 0.25, 90)],
        [box("dresser-0", (0.45, 1.0, 0.9), 1.75, 0.25, 90)],
        {"dresser-0", "door-0"},
    ),
    (
        "swing_free",
        "bedroom",
        [box("dresser-0", (0.45, 0.9, 0.9), 0.25, 1.6)],
        [box("dresser-0", (0.45, 0.9, 0.9), 0.25, 1.37)],
        {"dresser-0", "door-0"},
    ),
    (
        "way_to_group",
        "bedroom",
        [box("bed-0", (2.0, 1.6, 0.5), 3.0, 3.95, -90), NARROW[0]],
        [box("bed-0", (2.0, 1.6, 0.5), 3.0, 3.95, -90), *NARROW],
        {"bed-0"},
    ),
    ("way_to_window", "bedroom", NARROW[:1], NARROW, {"window-0"}),
    (
        "reachable",
        "bathroom",
        [box("laundry_hamper-0", (0.4, 0.5, 0.6), 5.7, 4.7, 180)],
        [
            box("laundry_hamper-0", (0.4, 0.5, 0.6), 5.7, 4.7, 180),
            box("bathtub-0", (0.8, 1.7, 0.6), 5.1, 3.55, 90),
            box("linen_cabinet-0", (0.5, 0.9, 1.8), 5.15, 4.45, 180),
        ],
        {"laundry_hamper-0"},
    ),
    (
        "reachable",
        "bathroom",
        [box("laundry_hamper-0", (0.4, 0.5, 0.6), 5.7, 4.0, 180)],
        [
            box("laundry_hamper-0", (0.4, 0.5, 0.6), 5.78, 4.73, 180),
            box("linen_cabinet-0", (0.5, 0.9, 1.8), 5.73, 4.0, 180),
        ],
        {"laundry_hamper-0", "linen_cabinet-0"},
    ),
    (
        "reachable",
        "office",
        [*seated(3.0, 2.5), box("wastebasket-0", (0.28, 0.28, 0.3), 5.0, 2.5)],
        [*seated(3.0, 2.5), box("wastebasket-0", (0.28, 0.28, 0.3), 3.0, 2.5)],
        {"wastebasket-0"},
    ),
    ("behind_seats", "kitchen", seated(3.0, 2.5), seated(3.0, 2.5, 1.5), {"dining_chair-1", "dining_chair-3"}),
    ("behind_counter", "restaurant", bar(1.3), bar(0.6), {"bar_counter-0"}),
    (
        "before_use",
        "bedroom",
        [box("wardrobe-0", WARDROBE, 5.7, 2.5, 180)],
        [box("wardrobe-0", WARDROBE, 5.7, 2.5, 180), box("bed-0", (2.0, 1.6, 0.5), 4.0, 2.5)],
        {"wardrobe-0", "bed-0"},
    ),
    (
        "before_use",
        "meeting_room",
        [hung("whiteboard-0", (0.05, 1.8, 1.1), 3.0, 4.97, -90, 0.9)],
        [
            hung("whiteboard-0", (0.05, 1.8, 1.1), 3.0, 4.97, -90, 0.9),
            box("cabinet-0", (0.45, 1.0, 0.8), 3.2, 4.76, -90),
        ],
        {"whiteboard-0", "cabinet-0"},
    ),
    (
        "before_focus",
        "meeting_room",
        [hung("projector_screen-0", (0.1, 2.0, 1.2), 5.95, 2.5, 180, 1.1)],
        [
            hung("projector_screen-0", (0.1, 2.0, 1.2), 5.95, 2.5, 180, 1.1),
            box("cabinet-0", (0.4, 0.7, 1.1), 5.78, 2.9, 180),
        ],
        {"projector_screen-0", "cabinet-0"},
    ),
    ("low_below_windows", "office", window_side(0.8), window_side(1.0), {"cabinet-0", "window-0"}),
    ("table_off_walls", "kitchen", seated(3.0, 2.5), seated(3.0, 0.6), {"dining_table-0"}),
    (
        "pieces_apart",
        "childrens_room",
        [box("desk-0", DESK, 3.0, 4.6, -90), box("activity_table-0", (0.6, 0.6, 0.5), 3.2, 2.5)],
        [box("desk-0", DESK, 3.0, 4.6, -90), box("activity_table-0", (0.6, 0.6, 0.5), 3.2, 3.85)],
        {"desk-0", "activity_table-0"},
    ),
    (
        "lamp_over_table",
        "kitchen",
        [*seated(3.0, 2.5), lamp("pendant-0", 3.0, 2.5, 1.5)],
        [*seated(3.0, 2.5), lamp("pendant-0", 3.5, 2.6, 1.5)],
        {"dining_table-0", "pendant-0"},
    ),
    (
        "lamp_over_table",
        "office",
        [
            *(box(f"desk-{k}", DESK, 1.5, 1 + 1.6 * k) for k in range(3)),
            lamp("ceiling_light-0", 1.5, 2.0),
            lamp("ceiling_light-1", 1.5, 4.0),
        ],
        [*(box(f"desk-{k}", DESK, 1.5, 1 + 1.6 * k) for k in range(3)), lamp("ceiling_light-0", 1.5, 1.0)],
        {"desk-1", "desk-2"},
    ),
    (
        "lamp_at_bed_side",
        "bedroom",
        bed(*(on(b, f"table_lamp-{k}") for k, b in enumerate(STANDS))),
        bed(on(STANDS[0], "table_lamp-0")),
        {"bed-0"},
    ),
    (
        "pendant_over_dining_table",
        "kitchen",
        [*seated(3.0, 2.5), lamp("pendant-0", 3.0, 2.5, 1.5)],
        [*seated(3.0, 2.5), lamp("pendant-0", 3.0, 2.5, 1.95)],
        {"pendant-0", "dining_table-0"},
    ),
    (
        "pendant_clear",
        "living_room",
        [lamp("pendant-0", 3.0, 2.5, 2.15)],
        [lamp("pendant-0", 3.0, 2.5, 1.7)],
        {"pendant-0"},
    ),
    (
        "ceiling_lights_spread",
        "office",
        [lamp(f"ceiling_light-{k}", 1.5 + 3 * k, 2.5) for k in range(2)],
        [lamp(f"ceiling_light-{k}", 0.6 + 0.6 * k, 0.8) for k in range(2)],
        {"ceiling_light-0", "ceiling_light-1"},
    ),
]


@pytest.mark.parametrize(
    ("rule", "kind", "good", "bad", "objects"), BREACHES, ids=[f"{k}-{row[0]}" for k, row in enumerate(BREACHES)]
)
def test_a_room_keeps_the_rule_and_another_breaks_it(rule, kind, good, bad, objects) -> None:
    assert not broken(rule, kind, good)
    assert objects <= broken(rule, kind, bad)


def test_a_single_ceiling_light_hangs_in_the_middle_of_a_small_room() -> None:
    small = room(3.0, 2.6, door=0.3, window=None)
    assert not broken("ceiling_lights_spread", "bathroom", [lamp("ceiling_light-0", 1.5, 1.3)], small)
    assert broken("ceiling_lights_spread", "bathroom", [lamp("ceiling_light-0", 2.75, 1.3)], small) == {
        "ceiling_light-0"
    }


def test_a_long_table_has_lamps_along_it() -> None:
    table = top(box("conference_table-0", (1.2, 3.2, 0.75), 3.0, 2.5, 90))
    seats = [box(f"office_chair-{k}", (0.6, 0.6, 1.0), 2.0 + k, 1.75, 90) for k in range(3)]
    pair = [lamp(f"pendant-{k}", 2.2 + 1.6 * k, 2.5, 1.6) for k in range(2)]
    assert not broken("lamp_over_table", "meeting_room", [table, *seats, *pair])
    one = broken("lamp_over_table", "meeting_room", [table, *seats, lamp("pendant-0", 3.0, 2.5, 1.6)])
    assert one == {"conference_table-0", "pendant-0"}


def test_seats_and_what_is_low_may_stand_below_a_board_and_a_window() -> None:
    board = hung("whiteboard-0", (0.05, 1.8, 1.1), 3.0, 4.97, -90, 0.9)
    assert not broken("before_use", "meeting_room", [board, box("chair-0", CHAIR, 3.0, 4.5, 90)])
    assert not broken("low_below_windows", "living_room", [box("snake_plant-0", (0.4, 0.4, 1.2), 2.8, 4.7)])


def test_what_is_measured_and_allowed_stands_in_the_fault() -> None:
    from sceneweaver.critic.design import faults
    from tests.critic.breaches import survey

    found = [f.fault for f in faults(survey("restaurant", bar(0.6))) if f.fault.rule == "behind_counter"]
    assert len(found) == 1 and found[0].measured == pytest.approx(0.3, abs=0.01) and found[0].allowed == (0.9, None)


def test_a_table_may_have_its_short_end_at_a_wall_where_nobody_sits_at_an_end() -> None:
    assert not broken("table_off_walls", "kitchen", seated(0.85, 2.5))
    end = box("dining_chair-4", CHAIR, 1.85, 2.5, 180)
    assert broken("table_off_walls", "kitchen", [*seated(0.85, 2.5), end]) == {"dining_table-0"}
