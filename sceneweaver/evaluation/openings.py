"""What stands before doors and windows: opening clearance as SceneEval has it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sceneweaver.assets.roles import with_role
from sceneweaver.geometry.shell import heights
from sceneweaver.scene import Door
from sceneweaver.verify.solids import Opening, Placed
from sceneweaver.verify.walkable import STEP

BEFORE_WINDOW = 0.5
"""Depth [m] of the space before a window; before a door it is the door's width."""

LEAST = 1e-3
"""Length [m] by which a thing may reach into that space, as it may touch a wall."""


class Covered(NamedTuple):
    """An opening: its id, the share of its area that is covered by what is before it, and the ids of that."""

    id: str
    share: float
    by: tuple[str, ...]


def openings(placed: Placed) -> list[Covered]:
    """Each door and window of a room, with what is in the space before it."""
    return [_covered(placed, opening) for opening in placed.openings]


def _covered(placed: Placed, opening: Opening) -> Covered:
    import shapely

    item, wall = opening.item, opening.wall
    depth = item.width if isinstance(item, Door) else BEFORE_WINDOW
    low, high = heights(item)
    space = shapely.Polygon(wall.strip(item.offset + LEAST, item.width - 2 * LEAST, LEAST, depth - LEAST))
    parts, dressing = placed.parts, with_role("window_dressing")
    rows = np.flatnonzero((parts.z[:, 0] < high - LEAST) & (parts.z[:, 1] > max(low, STEP) + LEAST))
    rows = rows[shapely.intersects(parts.polygons[rows], space)]
    rectangles, names = [], dict[str, None]()
    for row in rows:
        body = placed.bodies[int(parts.owner[row])]
        clipped = shapely.intersection(parts.polygons[row], space)
        if float(shapely.area(clipped)) <= LEAST * LEAST or body.item.category in dressing:
            continue
        along, _ = wall.coordinates(shapely.get_coordinates(clipped).T)
        z0, z1 = parts.z[row]
        rectangles.append(shapely.box(along.min(), max(z0, low), along.max(), min(z1, high)))
        names[body.id] = None
    whole = item.width * (high - low)
    area = float(shapely.area(shapely.union_all(rectangles))) if rectangles else 0.0
    return Covered(item.id, min(1.0, area / whole), tuple(names))
