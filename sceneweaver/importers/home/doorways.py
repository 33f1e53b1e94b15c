"""The doors, windows and open passages of a storey, as a home has them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

from sceneweaver.geometry.walls import Point, Wall
from sceneweaver.home import DoorKind, HomeDoor, HomeWindow
from sceneweaver.home.limits import THICKEST
from sceneweaver.io.messages import clean

from ..model import SourceOpening
from ..outline import DOOR, SILL, WINDOW
from ..plan_types import OPENS_FROM, OUTDOOR
from . import floors
from .openings import Opening, Placed, Walls, place, unified
from .storeys import PlanRoom

DOUBLE = 1.3
"""Doors wider than this [m] have two leaves."""

SLIDES = 1.2
"""Doors to a balcony that are wider than this [m] slide."""

PASSAGE = 0.4
"""Least length [m] along which two rooms without a wall between them touch for a passage to be there."""


def open_up(
    rooms: Sequence[PlanRoom],
    height: float,
    angle: float,
    used: set[str],
    doors: list[HomeDoor],
    windows: list[HomeWindow],
    notes: list[str],
) -> None:
    """Puts the doors and windows of a storey into its walls."""
    walls = Walls.of([room.outline for room in rooms])
    found = unified((k, _turned(o, angle)) for k, room in enumerate(rooms) for o in room.source.openings)
    found.sort(key=lambda o: (o.source.kind == "window", -len(o.rooms)))
    plain = [o for o in found if o.source.kind == "door" and o.source.height is None]
    glazed = [o for o in found if o.source.kind == "window" and o.source.height is None]
    if plain:
        notes.append(f"the file has no heights of doors; {min(DOOR, height):g} m is assumed")
    if glazed:
        notes.append(f"the file has no heights of windows; {WINDOW:g} m from {SILL:g} m on is assumed")
    for opening in found:
        source = opening.source
        placed = place(opening, walls)
        if isinstance(placed, str):
            notes.append(f"{source.kind} {source.name} left out: {placed}")
            continue
        name = free_id(source.name or source.kind, used)
        if source.kind != "window":
            doors.append(_door(name, placed, rooms, walls, height))
            continue
        room = placed.room
        if placed.to is not None:
            outside = [k for k in (placed.room, placed.to) if rooms[k].type in OUTDOOR]
            if len(outside) != 1:
                notes.append(f"window {source.name} left out: it lies between two rooms")
                continue
            if room in outside:
                placed = _other_side(placed, walls)
                room = placed.room
        sill = round(min(max(0.0, source.bottom if source.height is not None else SILL), height - 0.2), 3)
        tall = round(min(source.height or WINDOW, height - sill), 3)
        windows.append(
            HomeWindow(
                id=name,
                room=rooms[room].name,
                wall=placed.wall,
                offset=placed.offset,
                width=placed.width,
                sill=sill,
                height=tall,
            )
        )
    _passages(rooms, walls, height, used, doors, notes)


def _turned(opening: SourceOpening, angle: float) -> SourceOpening:
    if not angle:
        return opening
    a, b = floors.turned([opening.start, opening.end], angle)
    return replace(opening, start=(float(a[0]), float(a[1])), end=(float(b[0]), float(b[1])))


def _other_side(placed: Placed, walls: Walls) -> Placed:
    """A placed opening as the room behind has it."""
    here = walls.rooms[placed.room][placed.wall]
    first, last = here.point(placed.offset), here.point(placed.offset + placed.width)
    assert placed.to is not None
    for wall in walls.rooms[placed.to]:
        (a, near), (b, _) = wall.coordinates(last), wall.coordinates(first)
        if b > a and a >= -1e-6 and b <= wall.length + 1e-6 and -THICKEST <= near <= 1e-6:
            return Placed(placed.source, placed.to, wall.index, round(max(a, 0.0), 3), placed.width, placed.room)
    return placed


def _door(name: str, placed: Placed, rooms: Sequence[PlanRoom], walls: Walls, height: float) -> HomeDoor:
    source = placed.source
    room, to = rooms[placed.room], None if placed.to is None else rooms[placed.to]
    outside = to is not None and (to.type in OUTDOOR or room.type in OUTDOOR)
    kind: DoorKind = "hinged"
    if source.kind == "passage":
        kind = "open"
    elif source.swing == "slide" or (outside and placed.width > SLIDES):
        kind = "sliding"
    elif placed.width > DOUBLE:
        kind = "double"
    tall = round(min(source.height or (height if kind == "open" else DOOR), height), 3)
    into = placed.room
    if to is not None and placed.to is not None:
        given = source.swing == "out"
        if given or (source.swing is None and _last(room, to) is to):
            into = placed.to
    swings = kind in ("hinged", "double")
    return HomeDoor(
        id=name,
        room=room.name,
        wall=placed.wall,
        offset=placed.offset,
        width=placed.width,
        height=tall,
        to=None if to is None else to.name,
        kind=kind,
        opens_into=rooms[into].name if swings else None,
        hinge=_hinge(placed, into, walls) if swings else "left",
    )


def _last(a: PlanRoom, b: PlanRoom) -> PlanRoom:
    """Which of two rooms a door between them opens into: not the hall, not the balcony, else the smaller."""
    for test in (lambda r: r.type not in OPENS_FROM, lambda r: r.type not in OUTDOOR):
        if test(a) != test(b):
            return a if test(a) else b
    import shapely

    return min((a, b), key=lambda r: shapely.Polygon(r.outline).area)


def _hinge(placed: Placed, into: int, walls: Walls) -> Literal["left", "right"]:
    """The side of a leaf towards the nearer end of the wall, for somebody who comes into a room."""
    if placed.source.swing in ("in-left", "in-right") and into == placed.room:
        return "left" if placed.source.swing == "in-left" else "right"
    wall = walls.rooms[placed.room][placed.wall]
    before, after = placed.offset, wall.length - placed.offset - placed.width
    if into != placed.room:
        other = _other_side(replace(placed), walls)
        wall = walls.rooms[other.room][other.wall]
        before, after = other.offset, wall.length - other.offset - other.width
    # coming in one looks along the wall's inward normal, with its first corner to the left
    return "left" if before <= after else "right"


def _passages(
    rooms: Sequence[PlanRoom], walls: Walls, height: float, used: set[str], doors: list[HomeDoor], notes: list[str]
) -> None:
    """Open passages wherever two rooms touch: nothing is drawn between them."""
    for k, room in enumerate(rooms):
        for other in range(k + 1, len(rooms)):
            for a, b in _touching(walls.rooms[k], walls.rooms[other]):
                placed = place(Opening(SourceOpening("", "passage", a, b), (k, other)), walls, only=True)
                if isinstance(placed, str) or placed.to is None:
                    continue
                name = free_id(f"{room.name}-{rooms[other].name}", used)
                doors.append(_door(name, placed, rooms, walls, height))
                notes.append(f"{room.name} and {rooms[other].name} have no wall between them: an open passage")


def _touching(here: Sequence[Wall], there: Sequence[Wall]) -> list[tuple[Point, Point]]:
    """Where walls of two rooms lie on one line, as the two ends of each."""
    found = []
    for wall in here:
        for back in there:
            if wall.along[0] * back.along[0] + wall.along[1] * back.along[1] > -0.9999:
                continue
            if not -floors.TOUCH <= wall.coordinates(back.start)[1] <= floors.TOUCH:
                continue
            a, b = sorted((wall.coordinates(back.start)[0], wall.coordinates(back.end)[0]))
            a, b = max(0.0, a), min(wall.length, b)
            if b - a >= PASSAGE:
                found.append((wall.point(a), wall.point(b)))
    return found


def free_id(name: str, used: set[str]) -> str:
    """A name as an id that is not in ``used`` yet, and put there."""
    stem = clean(str(name)).strip().removeprefix("wall:") or "opening"
    key, k = stem, 2
    while key in used:
        key, k = f"{stem}_{k}", k + 1
    used.add(key)
    return key
