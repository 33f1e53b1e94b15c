"""The room of an imported scene: its outline, and its openings in the walls that they lie in."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.scene import Door, InputError, Room, Window

from .model import SourceOpening, SourceRoom

Outline = tuple[tuple[float, float], ...]

HEIGHT = 2.7
"""Height [m] of a ceiling that no file states."""

AWAY = 0.5
"""Most distance [m] of an opening's ends from the wall that takes it: half of a thick outer wall, with tolerance."""

APART = 0.01
"""Least distance [m] of two openings of one wall, and of an opening from the ends of its wall."""

MARGIN = 0.02
"""Distance [m] from the objects of the walls that are drawn around them."""

SAME = 1e-4
"""Corners nearer than this [m] are one."""

DOOR, WINDOW, SILL = 2.05, 1.2, 0.9
"""Heights [m] of a door, of a window and of its sill that no file states; a passage reaches the ceiling."""


def outline_of(room: SourceRoom, footprints: Sequence[np.ndarray], notes: list[str]) -> tuple[Outline, bool]:
    """The outline [m] counter-clockwise, and whether the file has one; else the box around the objects.

    Raises:
        InputError: the outline of the file is no polygon, or there is neither an outline nor an object.
    """
    if room.outline is not None:
        return _simple(room.outline, notes), True
    if not footprints:
        raise InputError(f"room {room.name}: neither an outline nor an object; nothing tells where the room is")
    points = np.concatenate(footprints)
    (x0, y0), (x1, y1) = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    notes.append("the file has no outline of the room; its walls are drawn around the objects")
    return tuple((round(float(x), 6), round(float(y), 6)) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))), False


def _simple(outline: Outline, notes: list[str]) -> Outline:
    import shapely

    if not np.isfinite(np.asarray(outline, dtype=float)).all():
        raise InputError("outline: a corner is not finite; give metres")
    corners = _distinct([(float(x), float(y)) for x, y in outline])
    if len(corners) < 3:
        raise InputError(f"outline: {len(corners)} corners; a room needs three")
    shape = shapely.Polygon(corners)
    if not shape.is_valid:
        parts = shapely.make_valid(shape)
        polygons = [p for p in getattr(parts, "geoms", [parts]) if p.geom_type == "Polygon"]
        if not polygons:
            raise InputError("outline: it encloses no floor; give its corners in order")
        shape = max(polygons, key=lambda p: p.area)
        corners = _distinct([(float(x), float(y)) for x, y in shape.exterior.coords])
        notes.append("the outline crosses itself; its largest part is the room")
    if shape.area < 0.01:
        raise InputError(f"outline: it encloses {shape.area:.3g} m2; is the unit right?")
    return tuple(corners if signed_area(corners) > 0 else corners[::-1])


def _distinct(corners: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Corners without those that repeat the one before, the first after the last among them."""
    kept = [c for k, c in enumerate(corners) if math.dist(c, corners[k - 1]) > SAME]
    return kept


def room_of(room: SourceRoom, outline: Outline, top: float, kind: str, notes: list[str]) -> Room:
    """The room with its openings; what finds no place in a wall is told and left out.

    Args:
        room: what the file says.
        outline: counter-clockwise [m].
        top: height [m] that the objects reach.
        kind: of room.
        notes: gets a line for all that is assumed.
    """
    height = room.height
    if height is None:
        height = max(HEIGHT, round(top + 0.05, 2))
        notes.append(f"the file has no height of the ceiling; {height:g} m is assumed")
    walls = walls_of(outline)
    taken: dict[int, list[tuple[float, float]]] = {wall.index: [] for wall in walls}
    doors: list[Door] = []
    windows: list[Window] = []
    for opening in room.openings:
        place = _place(opening, walls, taken)
        if isinstance(place, str):
            notes.append(f"{opening.kind} {opening.name} left out: {place}")
            continue
        wall, offset, width = place
        taken[wall].append((offset, offset + width))
        name = _free_name(opening.name or opening.kind, {o.id for o in (*doors, *windows)})
        if opening.kind == "window":
            sill = min(max(0.0, opening.bottom or SILL), height - 0.1)
            tall = min(opening.height or WINDOW, height - sill)
            windows.append(Window(id=name, wall=wall, offset=offset, width=width, sill=sill, height=tall))
        else:
            tall = min(opening.height or (height if opening.kind == "passage" else DOOR), height)
            swing = opening.swing or ("slide" if opening.kind == "passage" else "in-left")
            doors.append(Door(id=name, wall=wall, offset=offset, width=width, height=tall, swing=swing))
    return Room(type=kind, outline=outline, height=height, doors=tuple(doors), windows=tuple(windows))


def _place(
    opening: SourceOpening, walls: Sequence[Wall], taken: dict[int, list[tuple[float, float]]]
) -> tuple[int, float, float] | str:
    """Wall, offset and width [m] of an opening; or why it has none."""
    best: tuple[float, Wall, float, float] | None = None
    for wall in walls:
        (s0, d0), (s1, d1) = wall.coordinates(opening.start), wall.coordinates(opening.end)
        if abs(s1 - s0) < 0.7 * math.dist(opening.start, opening.end):
            continue  # across this wall, not along it
        low, high = max(min(s0, s1), 0.0), min(max(s0, s1), wall.length)
        if high - low < 0.5 * abs(s1 - s0):
            continue
        away = max(abs(d0), abs(d1))
        if best is None or away < best[0]:
            best = (away, wall, low, high)
    if best is None or best[0] > AWAY:
        return "no wall of the outline is near it"
    _, wall, low, high = best
    for a, b in taken[wall.index]:
        if low < b + APART and high > a - APART:
            return "another opening is there"
    if high - low < 0.05:
        return f"it is {high - low:.2f} m wide"
    return wall.index, low, high - low


def _free_name(name: str, used: set[str]) -> str:
    if name not in used:
        return name
    k = 2
    while f"{name}_{k}" in used:
        k += 1
    return f"{name}_{k}"
