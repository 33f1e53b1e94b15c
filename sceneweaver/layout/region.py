"""The place in which objects stand, as half planes and static prisms: a room, or a support surface.

The inside of a simple outline is the convex hull's half planes less its pockets (the parts of the hull outside of the
outline, as convex prisms), so reflex corners need nothing special.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.polygons import convex_pieces, tidy
from sceneweaver.geometry.shell import clear_zone, heights
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.kernels.geometry import OUTSIDE_TOP
from sceneweaver.scene import Room

from .shapes import Prism

EVERYWHERE = (-OUTSIDE_TOP, OUTSIDE_TOP)


@dataclass
class Region:
    """Half planes [K, 3] as (n, c) with n . x >= c inside; prisms that stand for the outside; opening clearances.

    ``middle`` is the centroid, or a point inside where the centroid is not.
    """

    planes: np.ndarray
    solids: list[Prism]
    height: float
    openings: list[Prism] = field(default_factory=list)
    walls: tuple[Wall, ...] = ()
    doors: dict[str, Prism] = field(default_factory=dict)
    box: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
    middle: tuple[float, float] = (0.0, 0.0)


def enclosure(outline, height: float) -> Region:
    """Half planes and pockets of a simple outline."""
    import shapely

    inside = shapely.Polygon(np.asarray(outline, dtype=np.float64))
    hull = tidy(shapely.get_coordinates(inside.convex_hull)[:-1])
    planes = [(*wall.inward, dot(wall.inward, wall.start)) for wall in walls_of(hull)]
    solids: list[Prism] = []
    outside = shapely.Polygon(hull).difference(inside)
    border = inside.exterior
    for part in getattr(outside, "geoms", [outside]):
        if part.is_empty or part.area < 1e-9:
            continue
        for piece in convex_pieces(shapely.get_coordinates(part)[:-1]):
            middles = 0.5 * (piece + np.roll(piece, -1, axis=0))
            solids.append(Prism(piece, EVERYWHERE, tuple(border.distance(shapely.Point(m)) < 1e-6 for m in middles)))
    middle = inside.centroid if inside.contains(inside.centroid) else inside.representative_point()
    return Region(np.asarray(planes), solids, height, box=inside.bounds, middle=(middle.x, middle.y))


def room_region(room: Room) -> Region:
    """The room with the floor that its doors and windows need free."""
    region = enclosure(room.outline, room.height)
    region.walls = room.walls
    region.openings = [Prism(np.array(clear_zone(o, room.walls)), heights(o)) for o in room.openings]
    region.doors = {door.id: zone for door, zone in zip(room.doors, region.openings, strict=False)}
    return region
