"""The empty room: outline, doors and windows from a kind of room and a request."""

from __future__ import annotations

import contextlib
import math
import random

from sceneweaver.brief import SceneGraph
from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.walls import walls_of
from sceneweaver.knowledge import RoomType
from sceneweaver.scene import Door, InputError, Room, Window

from .prior_relations import wall_named

Point = tuple[float, float]

FROM_CORNER = ((0.12, 0.3), (0.65, 1.0), (9.0, 9.0))
"""Distances [m] of a door from the corner by how a shell varies: close to it, a place beside it, in the middle."""

ASPECTS = ((1.0, 1.2), (1.3, 1.6), (1.8, 2.2))
"""Proportions of rooms, by how a shell varies."""

SMALLEST, LARGEST = 1.5, 60.0
"""Sides [m] of a room that are built at least and at most; what was asked is brought in between, with a note."""


def floor_area(room_type: RoomType, brief: SceneGraph, seed: int) -> tuple[float, int, bool, list[str]]:
    """Floor [m2], people, whether the request fixes the floor, and what was assumed."""
    rng, notes = random.Random(seed ^ 0xA2EA), []
    people = brief.people if brief.people is not None else room_type.people
    if brief.size is not None:
        return brief.size[0] * brief.size[1], people, True, notes
    if brief.area is not None:
        return brief.area, people, True, notes
    area = room_type.area[1] * brief.scale * rng.uniform(0.96, 1.08)
    if brief.people is not None and room_type.area_per_person:
        area = max(area, room_type.area_per_person * people)
    return min(max(area, 0.8 * room_type.area[0]), max(room_type.area[2], 1.0)), people, False, notes


def shell(
    room_type: RoomType, brief: SceneGraph, area: float, seed: int, vary: int = 0, like: Room | None = None
) -> tuple[Room, list[str]]:
    """A room of that floor area [m2]: the outline that was asked for, the door near a corner, windows opposite.

    Args:
        room_type: the kind of room.
        brief: the request.
        area: of the floor [m2].
        seed: decides what is drawn.
        vary: 0 for the usual openings; other numbers put doors further from the corner or in the middle, and windows
            into other walls.
        like: a room whose windows are as many, and as large.
    """
    rng, notes = random.Random((seed + 7919 * vary) ^ 0x5E11), []
    width, depth = _sides(room_type, brief, area, rng, notes, ASPECTS[vary % len(ASPECTS)] if vary else None)
    outline = _outline(brief.shape, width, depth)
    height = brief.height or room_type.height
    if not 2.0 <= height <= 8.0:
        notes.append(f"a ceiling of {height:g} m was brought to {min(max(height, 2.0), 8.0):g} m")
        height = min(max(height, 2.0), 8.0)
    walls = [wall.length for wall in walls_of(outline)]
    count = brief.doors if brief.doors is not None else max(1, room_type.doors.count.least)
    entry = 0
    doors, taken = [], set()
    for k in range(min(count, len(walls))):
        wall = entry if k == 0 else max((i for i in range(len(walls)) if i not in taken), key=lambda i: walls[i])
        size = min(round(rng.uniform(*room_type.doors.width), 2), walls[wall] - 0.3)
        if size < 0.6:
            notes.append(f"wall {wall} is too short for a door")
            continue
        taken.add(wall)
        play = walls[wall] - size
        offset = rng.uniform(*FROM_CORNER[vary % len(FROM_CORNER)])
        offset = offset if play > 2 * offset else play / 2
        near = rng.random() < 0.5
        swing = room_type.doors.swing
        if swing == "in-left" and not near:
            swing = "in-right"  # the leaf opens against the wall beside it
        doors.append(
            Door(
                id=f"door-{k}",
                wall=wall,
                offset=round(offset if near else play - offset, 3),
                width=size,
                height=round(min(rng.uniform(*room_type.doors.height), height - 0.05), 2),
                swing=swing,
            )
        )
    bare = Room(type=room_type.name, outline=tuple(outline), height=height, doors=tuple(doors))
    taken_walls = _spoken_for(brief, bare)
    windows = _windows(room_type, brief, outline, walls, entry, height, rng, notes, taken_walls, vary, like)
    return Room(type=room_type.name, outline=tuple(outline), height=height, doors=tuple(doors), windows=windows), notes


def _spoken_for(brief: SceneGraph, room: Room) -> set[int]:
    """The walls that something was asked to stand against."""
    found: set[int] = set()
    for name in (target for said in brief.relations for target in said.targets if target.startswith("wall:")):
        with contextlib.suppress(InputError):  # said later, with the relation itself
            found.add(wall_named(name.removeprefix("wall:"), room))
    return found


def _sides(
    room_type: RoomType,
    brief: SceneGraph,
    area: float,
    rng: random.Random,
    notes: list[str],
    aspects: tuple[float, float] | None,
) -> tuple[float, float]:
    if brief.size is not None:
        sides = list(brief.size)
    else:
        aspect = rng.uniform(*(aspects or room_type.aspect))
        share = {"L": 0.80, "T": 0.76, "U": 0.80}.get(brief.shape or "", 1.0)
        depth = math.sqrt(area / share / aspect)
        sides = [depth * aspect, depth]
    for k in (0, 1):
        kept = min(max(sides[k], SMALLEST), LARGEST)
        if kept != sides[k]:
            notes.append(
                f"a side of {sides[k]:.2f} m was brought to {kept:g} m; rooms have {SMALLEST:g} to {LARGEST:g} m"
            )
        sides[k] = round(kept, 2)
    return sides[0], sides[1]


def _outline(shape: str | None, w: float, d: float) -> list[Point]:
    """Counter-clockwise corners; wall 0 is the one at y = 0."""
    if shape == "L":
        return [
            (0, 0),
            (w, 0),
            (w, round(0.55 * d, 2)),
            (round(0.55 * w, 2), round(0.55 * d, 2)),
            (round(0.55 * w, 2), d),
            (0, d),
        ]
    if shape == "T":
        a, b, c = round(0.25 * w, 2), round(0.75 * w, 2), round(0.5 * d, 2)
        return [(a, 0), (b, 0), (b, c), (w, c), (w, d), (0, d), (0, c), (a, c)]
    if shape == "U":
        a, b, c = round(0.35 * w, 2), round(0.65 * w, 2), round(0.45 * d, 2)
        return [(0, 0), (w, 0), (w, d), (b, d), (b, c), (a, c), (a, d), (0, d)]
    if shape == "round":
        r = min(w, d) / 2
        turn = [2 * math.pi * (k + 0.5) / 12 - math.pi / 2 - 2 * math.pi / 12 for k in range(12)]
        return [(round(r + r * math.cos(t), 3), round(r + r * math.sin(t), 3)) for t in turn]
    return [(0, 0), (w, 0), (w, d), (0, d)]


def _windows(
    room_type: RoomType,
    brief: SceneGraph,
    outline: list[Point],
    walls: list[float],
    entry: int,
    height: float,
    rng: random.Random,
    notes: list[str],
    taken: set[int],
    vary: int,
    like: Room | None,
) -> tuple[Window, ...]:
    """Windows in walls that look away from the door, then in those beside it, centred; ``taken`` walls come last."""
    spec = room_type.windows
    count = brief.windows if brief.windows is not None else spec.count.of(0.0, 0, rng.random())

    sides = walls_of(outline)
    facing = {wall.index: dot(wall.inward, sides[entry].inward) for wall in sides}
    free = [i for i in facing if i != entry and walls[i] >= 1.0]
    choice = sorted(free, key=lambda i: (i in taken, round(facing[i]), -walls[i]))
    if any(i not in taken for i in choice):
        choice = [i for i in choice if i not in taken]
    turned = (vary // len(FROM_CORNER)) % max(1, len(choice))
    choice = choice[turned:] + choice[:turned]
    windows: list[Window] = []
    used: dict[int, int] = {}
    if brief.windows is None and any("window" in said.targets for said in brief.relations):
        count = max(count, 1)
    width = round(rng.uniform(*spec.width), 2)
    sill = round(min(rng.uniform(*spec.sill), height - 0.8), 2)
    tall = round(min(rng.uniform(*spec.height), height - 0.15 - sill), 2)
    if like is not None and like.windows:
        count, one = len(like.windows), like.windows[0]
        width, sill, tall = one.width, min(one.sill, height - 0.8), min(one.height, height - 0.15 - one.sill)
    plan: dict[int, int] = {}
    for k in range(count):
        fits = [i for i in choice if (plan.get(i, 0) + 1) * (width + 0.5) <= walls[i]]
        if not fits:
            if walls and choice and not plan:
                plan[choice[0]], width = 1, round(walls[choice[0]] - 0.6, 2)
                continue
            notes.append(f"{count - k} of {count} windows do not fit in the walls")
            break
        best = fits[0] if k == 0 or walls[fits[0]] > 2.2 * width * (plan.get(fits[0], 0) + 1) else fits[-1]
        plan[best] = plan.get(best, 0) + 1
    for wall, many in plan.items():
        gap = (walls[wall] - many * width) / (many + 1)
        for _ in range(many):
            at = used.get(wall, 0)
            used[wall] = at + 1
            windows.append(
                Window(
                    id=f"window-{len(windows)}",
                    wall=wall,
                    offset=round(gap + at * (width + gap), 3),
                    width=width,
                    sill=sill,
                    height=tall,
                )
            )
    return tuple(windows)
