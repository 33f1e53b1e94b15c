"""Floors, walls, doors and windows of a storey in plan, as architects draw them: walls cut and filled, leaves open."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
import shapely

from sceneweaver.geometry.walls import Wall
from sceneweaver.home import Home, HomeDoor, HomeRoom, WallOpening, wall_openings, wall_polygons

from .. import palette
from ..canvas import Point
from ..palette import Rgb
from ..shapes import Plan

POCHE: Rgb = (52, 49, 46)
"""The fill of walls that are cut."""

LINE: Rgb = (74, 70, 66)
"""Lines of doors, windows and stairs."""

_TINTS: tuple[tuple[str, Rgb], ...] = (
    ("bath toilet wc shower wet laundry utility", (232, 240, 243)),
    ("kitchen pantry dining", (246, 241, 228)),
    ("bed nursery guest", (241, 239, 245)),
    ("hall corridor entrance stairs landing lobby storage closet", (244, 243, 240)),
    ("balcony terrace porch patio loggia garden", (237, 242, 232)),
)
_PLAIN: Rgb = (247, 243, 235)
_WET = _TINTS[0][0].split()
_TILE = 0.3  # side of the tiles of wet rooms [m]
_RAIL = 0.06  # thickness of a railing [m]
_LEAF = 0.04  # thickness of a leaf [m]
_ARC = 24  # chords of a quarter circle


def tint_of(room: HomeRoom) -> Rgb:
    """The pale colour of a room's floor, by its kind."""
    words = palette.words_of(room.type)
    for names, color in _TINTS:
        if any(word.startswith(name) for name in names.split() for word in words):
            return color
    return _TINTS[-1][1] if room.outdoor else _PLAIN


def draw_floors(plan: Plan, rooms: Iterable[HomeRoom]) -> None:
    """The floors of rooms in their tints; those of wet rooms and balconies with tiles."""
    for room in rooms:
        tint, points = tint_of(room), plan.points(room.outline)
        plan.polygon(points, fill=tint)
        wet = any(word.startswith(name) for name in _WET for word in palette.words_of(room.type))
        if (wet or room.outdoor) and _TILE * plan.scale >= 7 * plan.unit:
            for ends in _tiles(room.outline):
                plan.line(plan.points(ends), palette.darker(tint, 0.09), 0.6)


def _tiles(outline: Sequence[tuple[float, float]]) -> Iterable[list[tuple[float, float]]]:
    """The joints of tiles in an outline, laid from its lower left corner."""
    floor = shapely.Polygon(outline)
    x0, y0, x1, y1 = floor.bounds
    lines = [shapely.LineString([(x, y0), (x, y1)]) for x in np.arange(x0 + _TILE, x1 - 0.02, _TILE)]
    lines += [shapely.LineString([(x0, y), (x1, y)]) for y in np.arange(y0 + _TILE, y1 - 0.02, _TILE)]
    for part in shapely.get_parts(shapely.intersection(lines, floor)):
        if part.length > 0.02:
            yield [(float(x), float(y)) for x, y in part.coords]


def corners_of(ring: shapely.LinearRing) -> list[tuple[float, float]]:
    """The corners of a ring, the first one once."""
    return [(float(x), float(y)) for x, y, *_ in ring.coords[:-1]]


def draw_walls(plan: Plan, home: Home, storey: str) -> None:
    """The walls, filled; rooms have to be drawn after it, as they lie in its holes."""
    for wall in sorted(wall_polygons(home, storey), key=lambda p: -shapely.Polygon(p.exterior).area):
        plan.polygon(plan.points(corners_of(wall.exterior)), fill=POCHE)
        for hole in wall.interiors:
            plan.polygon(plan.points(corners_of(hole)), fill=palette.PAPER)


def draw_railings(plan: Plan, home: Home, storey: str) -> None:
    """What bounds balconies where no wall does: two thin lines."""
    solid = shapely.union_all(wall_polygons(home, storey)).buffer(_RAIL / 4, join_style="mitre")
    for room in home.rooms_of(storey):
        if not room.outdoor:
            continue
        free = shapely.LinearRing(room.outline).difference(solid)
        rail = shapely.line_merge(free).buffer(_RAIL, cap_style="flat", join_style="mitre")
        for part in shapely.get_parts(rail.intersection(shapely.Polygon(room.outline))):
            if isinstance(part, shapely.Polygon) and part.area > 1e-4:
                plan.polygon(plan.points(corners_of(part.exterior)), palette.PAPER, LINE, 1.1)


def draw_openings(plan: Plan, home: Home, storey: str) -> None:
    """The doors and windows of a storey in its walls."""
    for found in wall_openings(home, storey):
        wall = home.room(found.opening.room).walls[found.opening.wall]
        if isinstance(found.opening, HomeDoor):
            _draw_door(plan, home, wall, found.opening, found.thickness)
        else:
            _draw_window(plan, wall, found)


def swept(home: Home, found: WallOpening) -> list[list[tuple[float, float]]]:
    """The quarter discs [m] that the leaves of a door sweep; none for a window and for what does not swing."""
    door = found.opening
    if not isinstance(door, HomeDoor) or door.kind not in ("hinged", "double"):
        return []
    wall = home.room(door.room).walls[door.wall]
    return [
        [wall.point(hinge, face), *_arc(wall, hinge, tip, face, into)]
        for hinge, tip, face, into in _leaves(door, found.thickness)
    ]


def _draw_window(plan: Plan, wall: Wall, found: WallOpening) -> None:
    a, w, t = found.opening.offset, found.opening.width, found.thickness
    plan.polygon(plan.points(wall.strip(a, w, -t, 0.0)), fill=(255, 255, 255))
    for depth in (0.0, -t):
        plan.line(plan.points((wall.point(a, depth), wall.point(a + w, depth))), LINE, 1.2)
    frame = 0.05 if t > 0.15 else 0.03
    middle = -t / 2
    plan.polygon(plan.points(wall.strip(a, w, middle - frame / 2, middle + frame / 2)), palette.GLASS, LINE, 1.0)
    for s in (a, a + w):
        plan.line(plan.points((wall.point(s, 0.0), wall.point(s, -t))), POCHE, 1.4)


def _draw_door(plan: Plan, home: Home, wall: Wall, door: HomeDoor, t: float) -> None:
    a, b = door.offset, door.offset + door.width
    floor = tint_of(home.room(door.room))
    plan.polygon(plan.points(wall.strip(a, door.width, -t - 0.004, 0.004)), fill=floor)
    for s in (a, b):
        plan.line(plan.points((wall.point(s, 0.0), wall.point(s, -t))), POCHE, 1.4)
    faces = [plan.points((wall.point(a, depth), wall.point(b, depth))) for depth in (0.0, -t)]
    outside = door.to is None or home.room(door.to).outdoor or home.room(door.room).outdoor
    if door.kind == "open":
        for face in faces:
            plan.dashed(face, (*LINE, 150), 1.0, (5.0, 4.0))
    elif door.kind == "sliding":
        for face in faces if outside else ():
            plan.line(face, LINE, 1.0)
        (_draw_patio_door if outside else _draw_sliding)(plan, wall, door, t)
    else:
        for face in faces if outside else faces[:1] if door.opens_into != door.room else faces[1:]:
            plan.line(face, (*LINE, 150), 0.9)
        for hinge, tip, face, into in _leaves(door, t):
            _draw_leaf(plan, wall, hinge, tip, face, into)


def _leaves(door: HomeDoor, t: float) -> list[tuple[float, float, float, float]]:
    """Each leaf by the offsets of its hinge and of its other end when closed, the depth of its face, and whether it
    swings into the room of the door (1) or the other way (-1)."""
    a, b = door.offset, door.offset + door.width
    into = 1.0 if door.opens_into == door.room else -1.0
    face = 0.0 if into > 0 else -t
    if door.kind == "double":
        return [(a, (a + b) / 2, face, into), (b, (a + b) / 2, face, into)]
    # Somebody who comes in has the first corner of the wall at the left; who goes out, at the right.
    first = (door.hinge == "left") == (into > 0)
    return [(a, b, face, into) if first else (b, a, face, into)]


def _arc(wall: Wall, hinge: float, tip: float, face: float, into: float) -> list[tuple[float, float]]:
    """The way of a leaf's end, from closed to open."""
    reach = tip - hinge
    turns = [math.pi / 2 * k / _ARC for k in range(_ARC + 1)]
    return [wall.point(hinge + reach * math.cos(q), face + into * abs(reach) * math.sin(q)) for q in turns]


def _draw_leaf(plan: Plan, wall: Wall, hinge: float, tip: float, face: float, into: float) -> None:
    reach = abs(tip - hinge)
    plan.line(plan.points(_arc(wall, hinge, tip, face, into)), (*LINE, 170), 0.9)
    near, far = sorted((face, face + into * reach))
    thick = min(_LEAF, reach / 12)
    panel = wall.strip(hinge if tip > hinge else hinge - thick, thick, near, far)
    plan.polygon(plan.points(panel), (255, 255, 255), POCHE, 1.1)


def _draw_patio_door(plan: Plan, wall: Wall, door: HomeDoor, t: float) -> None:
    """Two panes that slide past each other within the wall."""
    for share, depth in ((0.0, -0.5), (0.46, -0.5 - 0.05 / max(t, 0.1))):
        pane = wall.strip(door.offset + share * door.width, 0.54 * door.width, depth * t, depth * t + 0.045)
        plan.polygon(plan.points(pane), palette.GLASS, LINE, 1.0)


def _draw_sliding(plan: Plan, wall: Wall, door: HomeDoor, t: float) -> None:
    """A leaf that is half open, along the face of the wall, on the side where there is more of it."""
    after = wall.length - door.offset - door.width >= door.offset
    shift = (0.55 if after else -0.55) * door.width
    face = 0.012 if door.opens_into in (None, door.room) else -t - 0.012 - _LEAF
    panel = wall.strip(door.offset + shift, door.width, face, face + _LEAF)
    plan.polygon(plan.points(panel), (255, 255, 255), POCHE, 1.1)
    middle = door.offset + door.width / 2
    depth = face + (0.1 if face > 0 else -0.06)
    ends = plan.points((wall.point(middle - 0.12 * np.sign(shift), depth), wall.point(middle + shift / 2, depth)))
    plan.line(ends, LINE, 0.8)
    draw_head(plan, ends[0], ends[1], 5 * plan.unit)


def draw_head(plan: Plan, tail: Point, tip: Point, size: float) -> None:
    """The filled head [pixels] of an arrow at its tip."""
    length = math.dist(tail, tip)
    if length < 1e-6:
        return
    x, y = (tip[0] - tail[0]) / length, (tip[1] - tail[1]) / length
    base = (tip[0] - size * 1.8 * x, tip[1] - size * 1.8 * y)
    side = 0.6 * size
    plan.polygon((tip, (base[0] - side * y, base[1] + side * x), (base[0] + side * y, base[1] - side * x)), fill=LINE)


def draw_entrances(plan: Plan, home: Home, storey: str) -> None:
    """A filled triangle before each door that leads into the home."""
    entrances = {door.id for door in home.entrances}
    for found in wall_openings(home, storey):
        if found.opening.id not in entrances:
            continue
        wall = home.room(found.opening.room).walls[found.opening.wall]
        x, y = plan.point(wall.point(found.opening.offset + found.opening.width / 2, -found.thickness))
        nx, ny = wall.outward[0], -wall.outward[1]
        near, far, half = 7 * plan.unit, 21 * plan.unit, 9 * plan.unit
        corners = [(near, 0.0), (far, half), (far, -half)]
        plan.polygon([(x + d * nx - s * ny, y + d * ny + s * nx) for d, s in corners], fill=POCHE)
