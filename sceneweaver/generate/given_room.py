"""Doors and windows for a furnished room of somebody else that has none, where they are least in the way."""

from __future__ import annotations

import random

from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import InputError, Room, Scene

from .openings import ENTRY, doors_of, windows_of
from .outline import Plan
from .setup import Setup

DRAWS = 24
"""Ways to place them that are compared."""

BEFORE_DOOR, BEFORE_WINDOW = 0.9, 0.5
"""How deep [m] the floor before a door is looked at, and before a window, where only what is higher counts."""

SEEN = 0.3
"""How much a square metre of what stands before a window counts, beside one before a door."""


def with_openings(setup: Setup, scene: Scene) -> tuple[Scene, str]:
    """The scene with doors and windows as its kind of room usually has, where it has neither, and what was done.

    Files of many systems know no openings; a room without a door is none that one can walk into. Of some draws that is
    taken in which the least furniture stands before them.
    """
    room = scene.room
    if room.doors or room.windows:
        return scene, ""
    import shapely

    walls = walls_of(room.outline)
    plan = Plan("given", tuple(room.outline), tuple(w.index for w in walls if w.length >= ENTRY) or (0,))
    boxes = [
        (shapely.Polygon(o.pose.frame.to_world(_corners(o.size))), o.pose.position[2] + o.size[2])
        for o in scene.objects
        if o.mount == "floor" and o.size[2] > 0.05
    ]
    floor = shapely.Polygon(room.outline)

    def cost(made: Room) -> float:
        found = 0.0
        for door in made.doors:
            before = shapely.Polygon(walls[door.wall].strip(door.offset, door.width, 0.0, BEFORE_DOOR)) & floor
            found += sum(before.intersection(box).area for box, _ in boxes)
        for window in made.windows:
            before = shapely.Polygon(walls[window.wall].strip(window.offset, window.width, 0.0, BEFORE_WINDOW))
            found += SEEN * sum(before.intersection(box).area for box, top in boxes if top > window.sill)
        return round(found, 6)

    best: tuple[float, Room] | None = None
    for k in range(DRAWS):
        rng = random.Random(f"openings {setup.room_type.name} {setup.seed} {k}")
        try:
            doors, _ = doors_of(setup.room_type, setup.brief, plan, walls, room.height, rng)
            bare = Room.model_validate({**room.model_dump(), "doors": [d.model_dump() for d in doors]})
            windows, _ = windows_of(setup.room_type, setup.brief, plan, bare, rng, None)
            made = Room.model_validate({**bare.model_dump(), "windows": [w.model_dump() for w in windows]})
        except InputError:  # too low, or no wall takes them
            continue
        if best is None or cost(made) < best[0]:
            best = cost(made), made
        if best[0] == 0.0:
            break
    if best is None or not best[1].doors:
        return scene, "the room has no door, and no wall of it takes one"
    made = best[1]
    if best[0] > 0.0:  # its leaf would need floor that is taken
        out = tuple(d.model_copy(update={"swing": "out"}) for d in made.doors)
        made = made.model_copy(update={"doors": out})
    doors, windows = len(made.doors), len(made.windows)
    said = f"the room came without openings: {doors} door{'s' * (doors > 1)} and {windows} windows were added"
    return scene.model_copy(update={"room": made}), said


def _corners(size: tuple[float, float, float]) -> list[tuple[float, float]]:
    d, w = size[0] / 2, size[1] / 2
    return [(-d, -w), (d, -w), (d, w), (-d, w)]
