"""The empty room: outline, doors and windows from a kind of room and a request."""

from __future__ import annotations

import random

from sceneweaver.geometry.walls import walls_of
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Room

from .draft import area_of
from .free_floor import kept_free, people_of
from .openings import ENTRY, doors_of, windows_of
from .outline import LARGEST, SMALLEST, Plan, asked_outline, drawn_shape, mirrored, outline, sides_of, turned, winged
from .setup import Setup
from .stated_openings import walls_stated
from .wall_parts import with_wall_parts

NARROW = 0.25
"""How much longer some rooms are than is usual, in widths."""

LOWEST = 2.4
"""Least height [m] of a ceiling that is drawn."""

HEIGHTS = (-0.1, 0.0, 0.0, 0.0, 0.1, 0.2, 0.35)
"""By how much [m] ceilings differ from the usual height of a kind of room."""

EACH_MORE = 2.0
"""Floor [m2] for each of those who are more than such a room usually has, where its kind does not say it."""

FEW = 3
"""Things that a request may name while the shape of the room is still drawn."""


def floor_area(
    room_type: RoomType, brief: SceneGraph, seed: int, room: Room | None = None
) -> tuple[float, int, bool, list[str]]:
    """Floor [m2], people, whether the request or a room that is given fixes the floor, and what was assumed."""
    rng, notes = random.Random(f"floor area {room_type.name} {seed}"), []
    told = people_of(brief)
    people = told if told is not None else room_type.people
    if room is not None:
        return area_of(room), people, True, notes
    if brief.size is not None:
        more = brief.wing[0] * brief.wing[1] if brief.wing is not None else 0.0
        return brief.size[0] * brief.size[1] + more, people, True, notes
    if brief.area is not None:
        return brief.area, people, True, notes
    area = room_type.area[1] * brief.scale * rng.uniform(0.92, 1.14)
    if told is not None and room_type.area_per_person:
        area = max(area, room_type.area_per_person * people)
    elif told is not None:
        area += EACH_MORE * max(0, people - room_type.people)
    free = kept_free(brief)
    area += free
    return min(max(area, 0.8 * room_type.area[0]), max(room_type.area[2], 1.0) + free), people, False, notes


def shell_of(setup: Setup, area: float, vary: int = 0) -> tuple[Room, list[str]]:
    """The room that is given, of that kind, or else one that is drawn, see `shell`."""
    if setup.room is not None:
        return setup.room.model_copy(update={"type": setup.room_type.name}), []
    return shell(setup.room_type, setup.brief, area, setup.seed, vary)


def shell(
    room_type: RoomType, brief: SceneGraph, area: float, seed: int, vary: int = 0, like: Room | None = None
) -> tuple[Room, list[str]]:
    """A room of that floor area [m2]: the outline that was asked for or one that is drawn, doors and windows.

    Args:
        room_type: the kind of room.
        brief: the request.
        area: of the floor [m2].
        seed: decides what is drawn.
        vary: another room of the same seed for every number.
        like: a room whose height is the same, and whose windows are as many, and as large.
    """
    rng, notes = random.Random(f"shell {room_type.name} {seed} {vary}"), []
    height = brief.height or max(LOWEST, round(room_type.height + rng.choice(HEIGHTS), 2))
    if like is not None:
        height = like.height
    if not 2.0 <= height <= 8.0:
        notes.append(f"a ceiling of {height:g} m was brought to {min(max(height, 2.0), 8.0):g} m")
        height = min(max(height, 2.0), 8.0)
    plan = _plan(room_type, brief, area, rng, notes)
    corners = tuple((round(x, 3), round(y, 3)) for x, y in plan.corners)
    walls = walls_of(corners)
    entries = [k for k in plan.entries if walls[k].length >= ENTRY] or [0]
    told = walls_stated(brief, walls, entries, rng) if brief.openings else None
    doors, lost = doors_of(room_type, brief, plan, walls, height, rng, told)
    bare = Room(type=room_type.name, outline=corners, height=height, doors=tuple(doors))
    windows, unfit = windows_of(room_type, brief, plan, bare, rng, like, told)
    made, narrow = with_wall_parts(bare.model_copy(update={"windows": windows}), brief)
    return made, [*notes, *lost, *unfit, *narrow]


PARTS = ("door", "window")


def left_to_us(brief: SceneGraph) -> bool:
    """Whether the request leaves the shape of the room open: it says nothing of it, nor of places in it."""
    told = brief.shape or brief.size or brief.area or brief.relations or brief.openings or brief.free_areas
    return not (told or len(brief.entities) > FEW)


def _plan(room_type: RoomType, brief: SceneGraph, area: float, rng: random.Random, notes: list[str]) -> Plan:
    free = left_to_us(brief)
    apart = max((sum(o.part == part and "apart" in o.features for o in brief.openings) for part in PARTS), default=0)
    plain = "rectangle" if apart <= 4 else "L"  # more walls than four for more openings than that in walls of their own
    shape = drawn_shape(room_type, area, rng) if free else brief.shape or plain
    if brief.size is not None:
        width, depth = _within(brief.size, notes)
        if brief.wing is not None:
            plan = winged(width, depth, brief.wing)
            return mirrored(plan) if rng.random() < 0.5 else plan
        return asked_outline(shape, width, depth, rng)
    low, high = room_type.aspect
    aspect = rng.uniform(low, high) if rng.random() < 0.75 else rng.uniform(high, high + NARROW)
    aspect = max(1.0, min(aspect, area / SMALLEST**2))
    width, depth = _within(sides_of(shape, area, aspect), notes)
    if brief.shape is None and rng.random() < 0.5:
        width, depth = depth, width
    plan = (outline if free else asked_outline)(shape, width, depth, rng)
    return turned(plan, rng.randrange(4)) if free else plan


def _within(sides: tuple[float, float], notes: list[str]) -> tuple[float, float]:
    """Sides [m] that can be built; what was asked is brought in between, with a note."""
    kept = [min(max(side, SMALLEST), LARGEST) for side in sides]
    notes += [
        f"a side of {side:.2f} m was brought to {one:g} m; rooms have {SMALLEST:g} to {LARGEST:g} m"
        for side, one in zip(sides, kept, strict=True)
        if side != one
    ]
    return round(kept[0], 2), round(kept[1], 2)
