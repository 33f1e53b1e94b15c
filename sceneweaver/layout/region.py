"""The place in which objects stand, as half planes and static prisms: a room, or a support surface.

The inside of a simple outline is the convex hull's half planes less its pockets (the parts of the hull outside of the
outline, as convex prisms), so reflex corners need nothing special.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sceneweaver.scene import Room

from .shapes import Points, Prism, convex_pieces, tidy

EVERYWHERE = (-1.0e3, 1.0e3)


@dataclass(frozen=True)
class Wall:
    """One wall: first corner p, direction t, inward normal n, length."""

    p: np.ndarray
    t: np.ndarray
    n: np.ndarray
    length: float


@dataclass
class Region:
    """Half planes [K, 3] as (n, c) with n . x >= c inside; prisms that stand for the outside; opening clearances."""

    planes: np.ndarray
    solids: list[Prism]
    height: float
    openings: list[Prism] = field(default_factory=list)
    walls: list[Wall] = field(default_factory=list)
    doors: dict[str, Prism] = field(default_factory=dict)
    box: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)


def walls_of(outline) -> list[Wall]:
    """Walls of a counter-clockwise outline."""
    points = np.asarray(outline, dtype=np.float64)
    walls = []
    for p, q in zip(points, np.roll(points, -1, axis=0), strict=True):
        length = float(np.hypot(*(q - p)))
        t = (q - p) / length
        walls.append(Wall(p, t, np.array([-t[1], t[0]]), length))
    return walls


def enclosure(outline, height: float) -> Region:
    """Half planes and pockets of a simple outline."""
    import shapely

    inside = shapely.Polygon(np.asarray(outline, dtype=np.float64))
    hull = tidy(shapely.get_coordinates(inside.convex_hull)[:-1])
    planes = [(*wall.n, float(wall.n @ wall.p)) for wall in walls_of(hull)]
    solids: list[Prism] = []
    outside = shapely.Polygon(hull).difference(inside)
    border = inside.exterior
    for part in getattr(outside, "geoms", [outside]):
        if part.is_empty or part.area < 1e-9:
            continue
        for piece in convex_pieces(shapely.get_coordinates(part)[:-1]):
            middles = 0.5 * (piece + np.roll(piece, -1, axis=0))
            solids.append(Prism(piece, EVERYWHERE, tuple(border.distance(shapely.Point(m)) < 1e-6 for m in middles)))
    return Region(np.asarray(planes), solids, height, box=inside.bounds)


def _rectangle(wall: Wall, start: float, end: float, depth: float) -> Points:
    corner = wall.p + start * wall.t
    along, into = (end - start) * wall.t, depth * wall.n
    return np.array([corner, corner + along, corner + along + into, corner + into])


def room_region(room: Room) -> Region:
    """The room with the clearances of its doors and windows (docs/conventions.md says how deep)."""
    region = enclosure(room.outline, room.height)
    region.walls = walls_of(room.outline)
    for door in room.doors:
        depth = door.width if door.swing.startswith("in") else 0.6
        polygon = _rectangle(region.walls[door.wall], door.offset, door.offset + door.width, depth)
        region.doors[door.id] = Prism(polygon, (0.0, door.height))
        region.openings.append(region.doors[door.id])
    for window in room.windows:
        polygon = _rectangle(region.walls[window.wall], window.offset, window.offset + window.width, 0.3)
        region.openings.append(Prism(polygon, (window.sill, window.sill + window.height)))
    return region
