"""Doors and windows of a room that is drawn: in which walls, where on them, and of what kind."""

from __future__ import annotations

import contextlib
import math
import random
from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.seen import are_opposite, is_wall
from sceneweaver.geometry.walls import Wall
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.shells import first_group, shells
from sceneweaver.language import SceneGraph
from sceneweaver.language.model import StatedOpening
from sceneweaver.language.told_openings import doors_stated, leads_on
from sceneweaver.scene import Door, InputError, Room, Window

from .outline import Plan
from .relations import wall_named
from .stated_openings import (
    Opened,
    Told,
    door_height,
    door_swing,
    door_width,
    place,
    window_shape,
)

FROM_CORNER = (((0.12, 0.3), 6.0), ((0.65, 1.0), 3.0), ((9.0, 9.0), 1.0))
"""Distances [m] of a door from a corner, and how often: close to it, a place beside it, in the middle of its wall."""

ENTRY = 1.3
"""Length [m] of a wall that a door may be in."""

BESIDE = 0.3
"""Wall [m] on each side of a window: its curtain is so much wider, and a little more."""

SWING = 0.15
"""Wall [m] between the leaf of an open door and a window in the next wall."""

MIDDLE = 0.45
"""Share of single windows that are in the middle of their wall."""

LOW_SILL, FRENCH = (0.35, 0.5), (2.1, 2.2)
"""Sills [m] of low windows, and heights [m] of windows down to the floor."""


@dataclass(frozen=True)
class Pane:
    """Width, sill and height [m] of the windows of a room."""

    width: float
    sill: float
    height: float


def doors_of(
    room_type: RoomType,
    brief: SceneGraph,
    plan: Plan,
    walls: Sequence[Wall],
    height: float,
    rng: random.Random,
    told: Told | None = None,
) -> tuple[list[Door], list[str]]:
    """The doors of a room, that which one comes in by first, and what does not fit.

    ``told`` are the walls of those that the request describes.
    """
    stated = doors_stated(brief)
    count = brief.doors if brief.doors is not None else max(1, room_type.doors.count.least)
    fitting = [k for k in plan.entries if walls[k].length >= ENTRY] or [0]
    entry = rng.choices(fitting, [walls[k].length for k in fitting])[0]
    if stated and told is not None:
        return _stated_doors(room_type, stated, max(count, len(stated)), walls, height, rng, told)
    entry = told.entry if told is not None else entry
    doors: list[Door] = []
    notes: list[str] = []
    taken: set[int] = set()
    for k in range(min(count, len(walls))):
        left = [wall for wall in walls if wall.index not in taken]
        wall = walls[entry] if k == 0 else max(left, key=lambda wall: wall.length)
        width = min(round(rng.uniform(*room_type.doors.width), 2), wall.length - 0.3)
        if width < 0.6:
            notes.append(f"wall {wall.index} is too short for a door")
            continue
        taken.add(wall.index)
        play = wall.length - width
        offset = rng.uniform(*rng.choices([row for row, _ in FROM_CORNER], [share for _, share in FROM_CORNER])[0])
        offset = offset if play > 2 * offset else play / 2
        near = rng.random() < 0.5
        swing = room_type.doors.swing
        if swing == "in-left" and not near:
            swing = "in-right"  # the leaf opens against the wall beside it
        doors.append(
            Door(
                id=f"door-{k}",
                wall=wall.index,
                offset=round(offset if near else play - offset, 3),
                width=width,
                height=round(min(rng.uniform(*room_type.doors.height), height - 0.05), 2),
                swing=swing,
            )
        )
    return doors, notes


def _stated_doors(
    room_type: RoomType,
    stated: Sequence[StatedOpening],
    count: int,
    walls: Sequence[Wall],
    height: float,
    rng: random.Random,
    told: Told,
) -> tuple[list[Door], list[str]]:
    """The doors that a request describes, each where it is said to be, and those that it only counts."""
    doors, taken, notes = list[Door](), list[Opened](), list[str]()
    plain = [StatedOpening(part="door")] * (count - len(stated))
    for one in [*plain, *stated] if leads_on(stated[0]) else [*stated, *plain]:
        free = max(walls, key=lambda wall: (all(row.wall != wall.index for row in taken), wall.length))
        wall = walls[told.where.get(one.id, free.index if doors else told.entry)]
        usual = round(rng.uniform(*room_type.doors.width), 2)
        width = round(min(door_width(one, usual), wall.length - 0.3), 2)
        if width < 0.6:
            notes.append(f"wall {wall.index} is too short for a door")
            continue
        aside = rng.uniform(*FROM_CORNER[0][0]) if rng.random() < 0.5 else (wall.length - width) / 2
        offset = place(one, wall, width, taken, aside if rng.random() < 0.5 else wall.length - width - aside, 0, 1)
        if offset is None and one.wall == "any" and not one.opposite:
            wall = free
            offset = place(one, wall, width, taken, (wall.length - width) / 2, 0, 1)
        if offset is None:
            notes.append(f"wall {wall.index} has no room for another door")
            continue
        taken.append(Opened(wall.index, offset, width))
        near = offset < (wall.length - width) / 2
        swing = door_swing(one, room_type.doors.swing)
        if swing == "in-left" and not near:
            swing = "in-right"
        tall = door_height(one, rng.uniform(*room_type.doors.height))
        doors.append(
            Door(
                id=f"door-{len(doors)}",
                wall=wall.index,
                offset=offset,
                width=width,
                height=round(min(tall, height - 0.05), 2),
                swing=swing,
            )
        )
    return doors, notes


def pane_of(room_type: RoomType, brief: SceneGraph, height: float, rng: random.Random, like: Room | None) -> Pane:
    """The size of a room's windows; like those of another room where one is given."""
    spec = room_type.windows
    width = round(rng.uniform(*spec.width), 2)
    sill = rng.uniform(*spec.sill)
    tall = rng.uniform(*spec.height)
    varied = shells().windows
    kind = rng.choices([*varied.kinds], [*varied.kinds.values()])[0]
    stands = any("window" in said.targets for said in brief.relations)
    if first_group(room_type.name) in varied.groups and not stands and sill < 1.0:
        if kind == "low":
            sill, tall = rng.uniform(*LOW_SILL), sill + tall - LOW_SILL[0]
        elif kind == "french":
            sill, tall = 0.0, rng.uniform(*FRENCH)
    if like is not None and like.windows:
        width, sill, tall = like.windows[0].width, like.windows[0].sill, like.windows[0].height
    sill = round(min(sill, height - 0.8), 2)
    return Pane(width, sill, round(min(tall, height - 0.15 - sill), 2))


def windows_of(
    room_type: RoomType,
    brief: SceneGraph,
    plan: Plan,
    room: Room,
    rng: random.Random,
    like: Room | None,
    told: Told | None = None,
) -> tuple[tuple[Window, ...], list[str]]:
    """The windows of a room that has its doors, and what does not fit.

    They are in the wall of a bay, else most often in walls that look at the door, and in two walls in some rooms.
    Walls that the request wants something against come last.
    """
    walls, notes = room.walls, list[str]()
    spec = room_type.windows
    count = brief.windows if brief.windows is not None else spec.count.of(0.0, 0, rng.random())
    if brief.windows is None and any("window" in said.targets for said in brief.relations):
        count = max(count, 1)
    pane = pane_of(room_type, brief, room.height, rng, like)
    if like is not None:
        count = len(like.windows)
    order = _wall_order(brief, plan, room, pane.width, rng)
    shared = rng.random() < 0.5
    windows, unfit = _stated_windows(brief, room, pane, rng, told) if told is not None else ([], [])
    notes += unfit
    count -= len(windows)
    if windows and brief.windows is not None and not unfit:
        count = max(count, 0)
    order = [wall for wall in order if all(one.wall != wall for one in windows)] if count > 0 else []
    placed: dict[int, int] = {}
    width = pane.width
    for k in range(count):
        fits = [i for i in order if _room_for(room, i, placed.get(i, 0) + 1, width)]
        if not fits:
            if order and not placed:
                widest = max(order, key=lambda i: walls[i].length)
                placed[widest], width = 1, round(max(0.4, min(width, walls[widest].length - 0.6)), 2)
                continue
            if brief.windows is not None:
                notes.append(f"{count - k} of {count} windows do not fit in the walls")
            break
        fresh = [i for i in fits if i not in placed]
        best = fits[0] if k == 0 or shared or not fresh else fresh[0]
        placed[best] = placed.get(best, 0) + 1
    for wall, many in placed.items():
        for offset in _offsets(room, wall, many, width, wall == plan.bay, rng):
            made = Window(
                id=f"window-{len(windows)}",
                wall=wall,
                offset=round(offset, 3),
                width=width,
                sill=pane.sill,
                height=pane.height,
            )
            windows.append(made)
    return tuple(windows), notes


def _stated_windows(
    brief: SceneGraph, room: Room, pane: Pane, rng: random.Random, told: Told
) -> tuple[list[Window], list[str]]:
    """The windows that a request describes, each where it is said to be."""
    walls, notes, windows = room.walls, list[str](), list[Window]()
    stated = [one for one in brief.openings if one.part == "window"]
    taken = [Opened(door.wall, door.offset, door.width) for door in room.doors]
    if not stated:
        return windows, notes
    entry = room.doors[0].wall if room.doors else 0
    for one in stated:
        wall = walls[told.where[one.id]]
        several = one.wall == "any" and one.at == "along" and one.count > 1
        others = sorted((w for w in walls if w.index != entry), key=lambda w: -w.length)
        rows = [(w, 0, 1) for w in (others + [walls[entry]])[: one.count]] if several else []
        for on, number, many in rows or [(wall, k, one.count) for k in range(one.count)]:
            width, sill, tall = window_shape(one, pane.width, pane.sill, pane.height, room.height)
            most = (on.length - 2 * BESIDE - (many - 1) * BESIDE) / many
            width = round(most if one.at == "along" else min(width, most), 2)
            usual = (
                (on.length - width) / 2
                if rng.random() < MIDDLE
                else rng.uniform(BESIDE, max(BESIDE, on.length - width - BESIDE))
            )
            offset = place(one, on, width, taken, usual, number, many) if width >= 0.3 else None
            if offset is None and (one.at == "along" or (one.at == "any" and one.width is None)):
                most = width  # beside the door of that wall
                width, offset = _beside_doors(on, taken)
                width = width if one.at == "along" else min(width, most)
            if offset is None:
                notes.append(f"a window does not fit in wall {on.index}")
                continue
            taken.append(Opened(on.index, offset, width))
            windows.append(
                Window(id=f"window-{len(windows)}", wall=on.index, offset=offset, width=width, sill=sill, height=tall)
            )
    return windows, notes


def _beside_doors(wall: Wall, taken: Sequence[Opened]) -> tuple[float, float | None]:
    """Width and beginning [m] of the longest stretch of a wall that nothing takes; no beginning where it is short."""
    edges = sorted((row.offset - BESIDE, row.offset + row.width + BESIDE) for row in taken if row.wall == wall.index)
    starts = [BESIDE, *(high for _, high in edges)]
    ends = [*(low for low, _ in edges), wall.length - BESIDE]
    low, high = max(zip(starts, ends, strict=True), key=lambda row: row[1] - row[0])
    return round(high - low, 2), round(low, 3) if high - low >= 0.5 else None


def _wall_order(brief: SceneGraph, plan: Plan, room: Room, width: float, rng: random.Random) -> list[int]:
    """The walls that windows may be in, the first choice first."""
    walls, entries = room.walls, {door.wall for door in room.doors}
    ahead = walls[room.doors[0].wall].inward if room.doors else (0.0, 1.0)
    free = [w for w in walls if w.index not in entries and w.length >= 1.0]
    if not free:
        return []

    def weight(wall: Wall) -> float:
        facing = -dot(wall.inward, ahead)
        short = 0.3 if wall.length < width + 2 * BESIDE else 1.0
        return short * wall.length * (2.2 if facing > 0.5 else 1.0 if facing > -0.5 else 0.25)

    order = sorted(free, key=lambda wall: -(rng.random() ** (1.0 / weight(wall))))
    spoken = _spoken_for(brief, room)
    ranked = sorted(order, key=lambda wall: (wall.index in spoken, wall.index != plan.bay))
    if any(wall.index not in spoken for wall in ranked):
        ranked = [wall for wall in ranked if wall.index not in spoken]
    return [wall.index for wall in ranked]


def _spoken_for(brief: SceneGraph, room: Room) -> set[int]:
    """The walls that something was asked to stand against."""
    found: set[int] = set()
    for name in (target for said in brief.relations for target in said.targets if target.startswith("wall:")):
        with contextlib.suppress(InputError):  # said later, with the relation itself
            found.add(wall_named(name.removeprefix("wall:"), room))
    entry = room.walls[room.doors[0].wall] if room.doors else None
    for niche in (one for one in brief.openings if one.part == "niche" and entry is not None):
        for wall in room.walls:
            across = niche.opposite == "door" and entry is not None and are_opposite(wall, entry)
            if across or (niche.wall != "any" and is_wall(niche.wall, wall, room.walls, entry)):
                found.add(wall.index)
    return found


def _margins(room: Room, wall: int) -> tuple[float, float]:
    """Wall [m] to leave at the two ends of a wall: for a curtain, more where a door opens beside the corner."""
    walls, ends = room.walls, [BESIDE, BESIDE]
    before, after = (wall - 1) % len(walls), (wall + 1) % len(walls)
    for door in room.doors:
        swept = door.width + SWING if door.swing.startswith("in") else BESIDE
        if door.wall == before and walls[before].length - door.offset - door.width < 0.6:
            ends[0] = max(ends[0], swept)
        if door.wall == after and door.offset < 0.6:
            ends[1] = max(ends[1], swept)
    return ends[0], ends[1]


def _room_for(room: Room, wall: int, many: int, width: float) -> bool:
    """Whether so many windows, with their curtains, have room in a wall."""
    return many * width + (many - 1) * 2 * BESIDE + sum(_margins(room, wall)) <= room.walls[wall].length + 1e-9


def _offsets(room: Room, wall: int, many: int, width: float, bay: bool, rng: random.Random) -> list[float]:
    """Where the windows of a wall begin [m]: at even distances, or a single one off the middle."""
    length, (low, high) = room.walls[wall].length, _margins(room, wall)
    even = (length - many * width) / (many + 1)
    aside = many == 1 and not bay and rng.random() > MIDDLE
    at = rng.uniform(low, length - high - width) if length - high - width > low else even
    if not _room_for(room, wall, many, width):
        return [even + k * (width + even) for k in range(many)]
    if aside:
        return [at]
    first = min(max(even, low), length - high - many * width - (many - 1) * 2 * BESIDE)
    last = min(length - even, length - high) - width
    step = (last - first) / (many - 1) if many > 1 else math.inf
    return [first + k * step for k in range(many)] if many > 1 else [first]
