"""The rules for kitchens and baths: a room that keeps each, and one that breaks it."""

from __future__ import annotations

import pytest

from sceneweaver.scene import Part, SceneObject
from sceneweaver.scene.finish import RoomFinish, WallTiles
from tests.critic.breaches import box, broken, hung, room, top

Boxes = list[SceneObject]

KITCHEN = room(5.0, 4.0, door=4.0, window=2.6)
BATH = room(3.6, 3.0, door=2.4, window=0.5)


def run(stove: float = 0.9, dish: float = 0.9, *more: SceneObject, finish: str = "oak") -> Boxes:
    """Units along the wall y = 0 from its corner: sink, dishwasher, stove, counter; the fridge at the wall x = 0."""
    units = [
        ("kitchen_counter-0", 1.0, 0.9),
        ("dishwasher-0", 0.6, dish),
        ("sink_cabinet-0", 0.8, 0.9),
        ("stove-0", 0.6, stove),
    ]
    made, x = [], 0.65
    for name, width, height in units:
        look = {"material": finish if name.startswith("sink") else "oak"}
        made.append(top(box(name, (0.6, width, height), x + width / 2, 0.31, 90, **look)))
        x += width
    cabinet = top(box("kitchen_cabinet-9", (0.6, 0.4, 0.9), 0.31, 0.85, material="oak"))
    return [*made, cabinet, box("fridge-0", (0.6, 0.6, 1.8), 0.31, 1.9), *more]


def over(*places: tuple[float, float]) -> Boxes:
    """Wall cabinets over the run, each by its middle and width."""
    return [hung(f"wall_cabinet-{k}", (0.35, w, 0.7), x, 0.18, 90, 1.45) for k, (x, w) in enumerate(places)]


def vanity(mirror: float, category: str = "vanity", width: float = 0.9) -> Boxes:
    """A basin at the wall y = 3 and a mirror over it, some way off its middle."""
    return [
        box(f"{category}-0", (0.5, width, 0.85), 1.5, 2.74, -90),
        hung("wall_mirror-0", (0.03, 0.6, 0.9), 1.5 + mirror, 2.98, -90, 1.1),
    ]


def bath(tap: bool) -> Boxes:
    tub = box("bathtub-0", (0.8, 1.6, 0.6), 0.41, 0.9)

    def part(x: float, y: float, height: float) -> Part:
        return Part(polygon=((-x, -y), (x, -y), (x, y), (-x, y)), z=(0.0, height))

    parts = (part(0.4, 0.8, 0.5), part(0.08, 0.1, 0.6)) if tap else (part(0.4, 0.8, 0.6),)
    return [tub.model_copy(update={"parts": parts})]


def shower(*more: SceneObject, off: float = 0.0) -> Boxes:
    """A shower in the corner at (0, 3): its back to the wall x = 0, its right side to the other, some slot off it."""
    return [box("shower-0", (0.9, 0.9, 2.0), 0.455, 2.545 - off), *more]


def toilet(x: float, y: float) -> Boxes:
    """A toilet with its back to the wall y = 0, and its paper on a wall."""
    return [
        box("toilet-0", (0.7, 0.4, 0.8), 1.2, 0.36, 90),
        hung("toilet_paper_holder-0", (0.1, 0.1, 0.1), x, y, 0, 0.7),
    ]


MAT, STOOL, HAMPER = (0.5, 0.7, 0.01), (0.35, 0.35, 0.45), (0.4, 0.5, 0.6)
RAIL = hung("towel_rail-0", (0.1, 0.6, 0.4), 0.06, 1.6, 0, 0.8)

BREACHES: list[tuple[str, str, Boxes, Boxes, set[str]]] = [
    ("one_worktop_height", "kitchen", run(), run(dish=0.83), {"dishwasher-0"}),
    ("one_worktop_height", "kitchen", run(stove=0.91), run(stove=0.94), {"stove-0"}),
    ("one_worktop_finish", "kitchen", run(), run(finish="sage paint"), {"sink_cabinet-0"}),
    (
        "work_triangle",
        "kitchen",
        [*run()[:4], box("fridge-0", (0.6, 0.6, 1.8), 0.31, 2.6)],
        [*run()[:4], box("fridge-0", (0.6, 0.6, 1.8), 4.6, 3.6, 180)],
        {"stove-0", "fridge-0", "sink_cabinet-0"},
    ),
    (
        "sink_at_window",
        "kitchen",
        run(),
        [*run(), *(box(f"kitchen_cabinet-{k}", (0.6, 0.9, 0.85), 2.9 + 0.9 * k, 3.69, -90) for k in range(2))],
        {"sink_cabinet-0", "window-0"},
    ),
    (
        "no_stove_in_corner",
        "kitchen",
        run(),
        [*run(), box("kitchen_counter-1", (0.6, 1.0, 0.9), 3.35, 1.1)],
        {"stove-0", "kitchen_counter-1"},
    ),
    (
        "wall_cabinets_continuous",
        "kitchen",
        [*run(), *over((1.0, 1.2), (2.2, 1.2))],
        [*run(), *over((1.0, 0.6))],
        {"wall_cabinet-0"},
    ),
    (
        "bin_at_sink",
        "kitchen",
        [*run(), box("pedal_bin-0", (0.3, 0.3, 0.4), 3.0, 0.2, 90)],
        [*run(), box("pedal_bin-0", (0.3, 0.3, 0.4), 4.8, 3.8)],
        {"pedal_bin-0"},
    ),
    ("mirror_over_basin", "bathroom", vanity(0.0), vanity(0.5), {"vanity-0", "wall_mirror-0"}),
    (
        "mirror_over_basin",
        "bathroom",
        vanity(0.0, "vanity", 1.4),
        vanity(0.0, "double_vanity", 1.6),
        {"double_vanity-0"},
    ),
    ("tap_at_basin", "bathroom", bath(True), bath(False), {"bathtub-0"}),
    (
        "towel_in_reach",
        "bathroom",
        shower(RAIL),
        shower(hung("towel_rail-0", (0.1, 0.6, 0.4), 3.54, 0.6, 180, 1.0)),
        {"shower-0"},
    ),
    (
        "before_use",
        "bathroom",
        [RAIL],
        [RAIL, box("laundry_hamper-0", HAMPER, 0.21, 1.6)],
        {"towel_rail-0", "laundry_hamper-0"},
    ),
    ("paper_in_reach", "bathroom", toilet(1.75, 0.9), toilet(2.6, 0.05), {"toilet-0", "toilet_paper_holder-0"}),
    (
        "mat_at_exit",
        "bathroom",
        shower(box("bath_mat-0", MAT, 1.2, 2.5)),
        shower(box("bath_mat-0", MAT, 2.4, 1.2)),
        {"bath_mat-0", "shower-0"},
    ),
    ("flush_with_walls", "bathroom", shower(), shower(off=0.12), {"shower-0"}),
    (
        "stool_at_shower",
        "bathroom",
        shower(box("shower_stool-0", STOOL, 1.2, 2.5)),
        shower(box("shower_stool-0", STOOL, 2.4, 1.2)),
        {"shower_stool-0"},
    ),
    (
        "pieces_apart",
        "bathroom",
        [*toilet(1.75, 0.9), box("scale-0", (0.3, 0.3, 0.03), 2.0, 0.2)],
        [*toilet(1.75, 0.9), box("scale-0", (0.3, 0.3, 0.03), 1.56, 0.3)],
        {"scale-0", "toilet-0"},
    ),
]


@pytest.mark.parametrize(
    ("rule", "kind", "good", "bad", "objects"), BREACHES, ids=[f"{k}-{line[0]}" for k, line in enumerate(BREACHES)]
)
def test_a_room_keeps_the_rule_and_another_breaks_it(rule, kind, good, bad, objects) -> None:
    space = KITCHEN if kind == "kitchen" else BATH
    assert not broken(rule, kind, good, space)
    assert objects <= broken(rule, kind, bad, space)


def test_a_towel_out_of_reach_of_the_hand_does_not_count() -> None:
    high = hung("towel_rail-0", (0.1, 0.6, 0.4), 0.06, 1.6, 0, 1.8)
    assert "shower-0" in broken("towel_in_reach", "bathroom", shower(high), BATH)


def test_a_bath_without_window_or_tiles_is_not_complete() -> None:
    plain = room(3.0, 2.6, window=None)
    assert not broken("complete_for_its_kind", "bathroom", bath(True), BATH)
    assert broken("complete_for_its_kind", "bathroom", bath(True), plain) == {""}
    tiled = plain.model_copy(update={"finish": RoomFinish(tiles=WallTiles(color="white", high=2.0))})
    assert not broken("complete_for_its_kind", "bathroom", bath(True), tiled)
