"""A home from the rooms that a reader gives of one house."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import median
from typing import Literal

import numpy as np

from sceneweaver.geometry.walls import Point, Wall
from sceneweaver.home import DoorKind, Home, HomeDoor, HomeRoom, HomeWindow, Storey, WallThickness
from sceneweaver.home.limits import THICKEST
from sceneweaver.io import InputError
from sceneweaver.io.messages import clean, quote

from ..model import SourceOpening, SourceRoom
from ..outline import DOOR, HEIGHT, SILL, WINDOW
from ..plan_types import OPENS_FROM, OUTDOOR, plan_type
from . import floors
from .floors import Drawn
from .leaves import faults_of, hang
from .model import ImportedHome
from .openings import Opening, Placed, Walls, place, unified

DOUBLE = 1.3
"""Doors wider than this [m] have two leaves."""

SLIDES = 1.2
"""Doors to a balcony that are wider than this [m] slide."""

CEILING = 0.3
"""Thickness [m] of a ceiling between two storeys that no file states."""

PASSAGE = 0.4
"""Least length [m] along which two rooms without a wall between them touch for a passage to be there."""


@dataclass(frozen=True, eq=False)
class _Room:
    """A room on its way: id, type, storey, the outline in the home's frame, and what the file says of it."""

    name: str
    type: str
    storey: int
    outline: tuple[tuple[float, float], ...]
    source: SourceRoom


def home_of(rooms: Sequence[SourceRoom], format_name: str, *, name: str, drawn: Drawn = "auto") -> ImportedHome:
    """The home that the rooms of one house make.

    Args:
        rooms: of one house, as a reader gives them.
        format_name: of their format.
        name: id of the home.
        drawn: whether outlines are the "faces" of walls or their "middles"; "auto": as the gaps between rooms say.

    Raises:
        InputError: no room of it has an outline.
    """
    notes = list(dict.fromkeys(note for room in rooms for note in room.notes))
    named = _named(rooms, notes)
    if not named:
        raise InputError("no room has an outline; a home needs at least one")
    rings = {key: np.asarray(source.outline, dtype=float) for key, (source, _) in named.items()}
    angle = floors.turn_of(list(rings.values()))
    if angle:
        notes.append(f"the plan is turned by {math.degrees(-angle):.2f} degrees, its walls along the axes")
    levels = _levels([source for source, _ in named.values()])
    thick = WallThickness()
    made: list[_Room] = []
    inner: list[float] = []
    for level, storey in enumerate(levels):
        mine = {k: v for k, v in named.items() if v[0].storey == storey}
        outlines, walls = _outlines({k: floors.turned(rings[k], angle) for k in mine}, drawn, thick, notes)
        inner.append(walls)
        for key, outline in outlines.items():
            source, kind = mine[key]
            made.append(_Room(key, kind, level, outline, source))
    if not made:
        raise InputError("nothing is left of its rooms; are the outlines closed and in metres?")
    made = _stacked(made, levels, notes)
    storeys = _storeys(made, levels, notes)
    doors: list[HomeDoor] = []
    windows: list[HomeWindow] = []
    used: set[str] = set()
    for level in range(len(levels)):
        here = [room for room in made if room.storey == level]
        _open_up(here, storeys[level].height, angle, used, doors, windows, notes)
    said = {o.name for room in made for o in room.source.openings if o.swing is not None}
    home = Home(
        id=name,
        prompt=next((room.text for room in rooms if room.text), ""),
        storeys=tuple(storeys),
        walls=WallThickness(inner=round(min(inner), 3), outer=thick.outer),
        rooms=tuple(
            HomeRoom(
                id=room.name,
                type=room.type,
                storey=storeys[room.storey].id,
                outline=room.outline,
                outdoor=room.type in OUTDOOR,
            )
            for room in made
        ),
        doors=tuple(doors),
        windows=tuple(windows),
        provenance={"imported": {"format": format_name, "rooms": {r.name: r.source.name for r in made}}},
    )
    free = {door.id for door in home.doors if door.id not in said}
    if free and any(faults_of(home).values()):
        home = home.with_changes(doors=hang(home, free))
        stuck = {name for name, faults in faults_of(home).items() if faults and name in free}
        stuck = _sliding(home, stuck)
        if stuck:
            notes.append(f"doors that have no room to swing are taken to slide: {', '.join(sorted(stuck))}")
            slid = {"kind": "sliding", "opens_into": None}
            doors = [d.model_copy(update=slid) if d.id in stuck else d for d in home.doors]
            home = home.with_changes(doors=tuple(doors))
    return ImportedHome(home, format_name, tuple(dict.fromkeys(notes)), tuple(rooms))


def _sliding(home: Home, stuck: set[str]) -> set[str]:
    """Of doors whose leaves meet something those that are to slide: one after another, while some still meet."""
    found: set[str] = set()
    inner = [d.id for d in home.doors if d.id in stuck and d.to is not None]
    for name in inner:
        doors = [
            d.model_copy(update={"kind": "sliding", "opens_into": None}) if d.id in found else d for d in home.doors
        ]
        if faults_of(home.with_changes(doors=tuple(doors))).get(name):
            found.add(name)
    return found


def _named(rooms: Sequence[SourceRoom], notes: list[str]) -> dict[str, tuple[SourceRoom, str]]:
    """Rooms of a plan by an id of their own, with their types; shafts and rooms without an outline left out."""
    found: dict[str, tuple[SourceRoom, str]] = {}
    for room in rooms:
        kind = plan_type(room.type or re.sub(r"[\W_]*\d+$", "", room.name))
        if kind is None:
            notes.append(f"{room.name}: {quote(room.type)} is no room; it stays wall")
            continue
        if room.outline is None or len(room.outline) < 3:
            notes.append(f"{room.name}: the file has no outline of it; left out")
            continue
        if not np.isfinite(np.asarray(room.outline, dtype=float)).all():
            raise InputError(f"room {room.name}: outline: a corner is not finite; give metres")
        stem = clean(room.name).strip().removeprefix("wall:") or kind
        key, k = stem, 2
        while key in found:
            key, k = f"{stem}_{k}", k + 1
        found[key] = room, kind
    return found


def _levels(rooms: Sequence[SourceRoom]) -> list[str]:
    """The names of storeys from below: in order of the numbers in them, then as the file has them."""
    names = list(dict.fromkeys(room.storey for room in rooms))

    def number(name: str) -> tuple[int, float]:
        found = re.search(r"-?\d+(?:\.\d+)?", name)
        return (0, float(found[0])) if found else (1, names.index(name))

    return sorted(names, key=number)


def _outlines(
    rings: dict[str, np.ndarray], drawn: Drawn, thick: WallThickness, notes: list[str]
) -> tuple[dict[str, tuple[tuple[float, float], ...]], float]:
    """Clear floors of a storey by room, and the thickness [m] of the walls between them."""
    keys = list(rings)
    cleaned = dict(zip(keys, floors.clean([rings[k] for k in keys]), strict=True))
    notes += [f"{key}: {note}" for key, floor in cleaned.items() if floor is not None for note in floor.notes]
    kept = {key: floor.ring for key, floor in cleaned.items() if floor is not None}
    notes += [f"{key}: nothing is left of it" for key in keys if key not in kept]
    found = floors.gaps(list(kept.values()))
    middles = drawn == "middles" or (drawn == "auto" and floors.on_middles(found))
    if middles:
        notes.append(f"rooms share lines: each wall is moved inwards by {thick.inner / 2:g} m, half its thickness")
    outlines = {}
    for key, ring in kept.items():
        ring = floors.inset(ring, thick.inner / 2) if middles else ring
        outline = None if ring is None else floors.on_grid(ring)
        if outline is None:
            notes.append(f"{key}: nothing is left of it between its walls")
            continue
        outlines[key] = outline
    outlines = floors.apart(outlines)
    return outlines, floors.thickness(list(outlines.values()), thick.inner)


def _stacked(rooms: list[_Room], levels: Sequence[str], notes: list[str]) -> list[_Room]:
    """Storeys that a file draws beside each other laid over each other, by their stairs or least corners."""
    if len(levels) < 2:
        return rooms
    below = [room for room in rooms if room.storey == 0]
    moved = list(below)
    for level in range(1, len(levels)):
        here = [room for room in rooms if room.storey == level]
        base, own = _box(below), _box(here)
        if not below or not here or (base[0] < own[2] and own[0] < base[2] and base[1] < own[3] and own[1] < base[3]):
            moved += here
            continue
        stairs = [[r for r in part if r.type == "stairs"] for part in (below, here)]
        anchor = [_middle(_box(part[:1])) for part in stairs] if all(stairs) else [base[:2], own[:2]]
        dx, dy = (round(anchor[0][k] - anchor[1][k], 3) for k in (0, 1))
        moved += [_shifted(room, dx, dy) for room in here]
        notes.append(
            f"storey {quote(levels[level])} is drawn beside the lowest: laid over it by their "
            f"{'stairs' if all(stairs) else 'least corners'}, moved by ({dx:g}, {dy:g}) m"
        )
    return moved


def _box(rooms: Sequence[_Room]) -> tuple[float, float, float, float]:
    points = np.concatenate([np.asarray(r.outline) for r in rooms]) if rooms else np.zeros((1, 2))
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return float(x0), float(y0), float(x1), float(y1)


def _middle(box: tuple[float, float, float, float]) -> tuple[float, float]:
    return (box[0] + box[2]) / 2, (box[1] + box[3]) / 2


def _shifted(room: _Room, dx: float, dy: float) -> _Room:
    def point(p: tuple[float, float]) -> tuple[float, float]:
        return p[0] + dx, p[1] + dy

    openings = tuple(replace(o, start=point(o.start), end=point(o.end)) for o in room.source.openings)
    outline = tuple((round(x + dx, 3), round(y + dy, 3)) for x, y in room.outline)
    return replace(room, outline=outline, source=replace(room.source, openings=openings))


def _storeys(rooms: Sequence[_Room], levels: Sequence[str], notes: list[str]) -> list[Storey]:
    found, elevation = [], 0.0
    for level, name in enumerate(levels):
        heights = [r.source.height for r in rooms if r.storey == level and r.source.height]
        height = round(median(heights), 3) if heights else HEIGHT
        if not heights:
            notes.append(f"the file has no height of the ceiling; {height:g} m is assumed")
        found.append(Storey(id=name or "ground", elevation=round(elevation, 3), height=height))
        elevation += height + CEILING
    return found


def _open_up(
    rooms: Sequence[_Room],
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
        name = _free_id(source.name or source.kind, used)
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


def _door(name: str, placed: Placed, rooms: Sequence[_Room], walls: Walls, height: float) -> HomeDoor:
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


def _last(a: _Room, b: _Room) -> _Room:
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
    rooms: Sequence[_Room], walls: Walls, height: float, used: set[str], doors: list[HomeDoor], notes: list[str]
) -> None:
    """Open passages wherever two rooms touch: nothing is drawn between them."""
    for k, room in enumerate(rooms):
        for other in range(k + 1, len(rooms)):
            for a, b in _touching(walls.rooms[k], walls.rooms[other]):
                placed = place(Opening(SourceOpening("", "passage", a, b), (k, other)), walls, only=True)
                if isinstance(placed, str) or placed.to is None:
                    continue
                name = _free_id(f"{room.name}-{rooms[other].name}", used)
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


def _free_id(name: str, used: set[str]) -> str:
    stem = clean(str(name)).strip().removeprefix("wall:") or "opening"
    key, k = stem, 2
    while key in used:
        key, k = f"{stem}_{k}", k + 1
    used.add(key)
    return key
