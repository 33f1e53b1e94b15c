"""Where a robot gets about, and which things it can get at: navigability and accessibility as SceneEval has them."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.verify.grid import Grid
from sceneweaver.verify.solids import Body, Placed
from sceneweaver.verify.walkable import MOST_CELLS, STEP, free_for

BASE = 0.25
"""Diameter of the robot's base [m]; PhyScene takes 0.3, SceneEval 0.2."""

STRIP = 0.2
"""Depth [m] of the strip before a side that should be free."""

OFFSET = 0.05
"""Its distance [m] from that side."""

OVERHEAD = 2.0
"""Height [m] of a box's middle from which on it is in nobody's way."""

_SIDES = ("front", "back", "left", "right")


def navigability(placed: Placed) -> float | None:
    """Largest connected free area over all free area; None for a room too large for the grid, 0 without free area."""
    from scipy.ndimage import label

    grid = Grid(placed)
    if grid.cells > MOST_CELLS:
        return None
    regions, count = label(free_for(placed, grid, BASE / 2), structure=np.ones((3, 3)))
    if not count:
        return 0.0
    sizes = np.bincount(np.asarray(regions).ravel())[1:]
    return float(sizes.max() / sizes.sum())


def accessibility(placed: Placed) -> list[float]:
    """Of each thing on the floor that is used from a side, the share of the strip before it that is free (the best of
    several sides)."""
    import shapely

    boxes = np.array([shapely.Polygon(_box(body)) for body in placed.bodies], dtype=object)
    low = np.array([sum(body.z) / 2 <= OVERHEAD and body.z[1] > STEP for body in placed.bodies], dtype=bool)
    obstacles = boxes[low]
    found = []
    for body in placed.bodies:
        sides = [s for s in category_named(body.item.category).sides if s in _SIDES]
        if body.item.mount != "floor" or not sides:
            continue
        found.append(max(_free_share(placed, obstacles, _strip(body, side)) for side in sides))
    return found


def _free_share(placed: Placed, obstacles: Any, strip: Any) -> float:
    import shapely

    inside = shapely.intersection(strip, placed.floor)
    near = obstacles[shapely.intersects(obstacles, strip)]
    free = shapely.difference(inside, shapely.union_all(near)) if len(near) else inside
    return float(free.area / strip.area)


def _strip(body: Body, side: str) -> Any:
    import shapely

    (x, y), (nx, ny), half = body.face(side)
    a, b = OFFSET, OFFSET + STRIP
    corners = [(u, v) for v, us in ((a, (-half, half)), (b, (half, -half))) for u in us]
    return shapely.Polygon([(x - ny * u + nx * v, y + nx * u + ny * v) for u, v in corners])


def _box(body: Body) -> list[tuple[float, float]]:
    """The four corners of an upright box; of a tilted one those of the box about its outline."""
    if len(body.corners) == 4:  # noqa: PLR2004 - corners of a box
        return list(body.corners)
    points = np.asarray(body.corners)
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
