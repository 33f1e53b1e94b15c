"""Whether objects rest on something, by what touches what, as SceneEval's support says it.

SceneEval lifts an object by 5 mm, casts rays down from its lowest vertices and faces, and takes hits closer than 1 cm:
so a gap below 5 mm counts, and so does sinking in by as much. It is supported when its middle lies over the hull of the
contacts. Here the contacts are the exact areas of convex parts. What hangs needs one contact with a wall or the
ceiling. A mount, which SceneEval asks a vision model for, is that of the scene.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.verify.solids import Body, Placed

REACH = 5e-3
"""Gap, or depth, of a contact [m] at most: the threshold of SceneEval less by how far it lifts."""

SLACK = 1e-6
"""Rounding [m] that does not matter."""

UNDERSIDE = 0.01
"""Parts that begin within this height [m] of the lowest point belong to the underside."""


def supported(placed: Placed) -> list[bool]:
    """Of each object whether something holds it."""
    return [_is_held(placed, body) for body in placed.bodies]


def _is_held(placed: Placed, body: Body) -> bool:
    if body.item.mount == "ceiling":
        return abs(placed.scene.room.height - body.z[1]) <= REACH + SLACK
    if body.item.mount == "wall":
        return _touches_wall(placed, body)
    return _rests(placed, body)


def _touches_wall(placed: Placed, body: Body) -> bool:
    """Whether its back is on a wall: it hangs by what is behind it."""
    (x, y), (nx, ny), half = body.face("back")
    ends = np.array([(x - ny * half, y + nx * half), (x + ny * half, y - nx * half)])
    for wall in placed.walls:
        offset, depth = wall.coordinates(ends.T)
        beside = offset.min() < wall.length and offset.max() > 0
        if beside and wall.inward[0] * nx + wall.inward[1] * ny < 0 and np.abs(depth).min() <= REACH + SLACK:
            return True
    return False


def _rests(placed: Placed, body: Body) -> bool:
    import shapely

    parts, own = placed.parts, placed.part_rows(body)
    low = float(parts.z[own, 0].min())
    under = parts.polygons[own][parts.z[own, 0] <= low + UNDERSIDE]
    feet = shapely.union_all(under)
    touched: list[Any] = []
    if abs(low) <= REACH + SLACK:
        touched.append(shapely.intersection(feet, placed.floor))
    near = np.abs(parts.z[:, 1] - low) <= REACH + SLACK
    near[own] = False
    if near.any():
        below = parts.polygons[near]
        touched.extend(shapely.intersection(feet, below[shapely.intersects(below, feet)]))
    touched = [shape for shape in touched if shape.area > 0.0]
    if not touched:
        return False
    hull = shapely.convex_hull(shapely.union_all(touched))
    return bool(shapely.dwithin(hull, _middle(placed, body), SLACK))


def _middle(placed: Placed, body: Body) -> Any:
    """The centroid of its solids, seen from above."""
    import shapely

    rows = placed.part_rows(body)
    shapes, z = placed.parts.polygons[rows], placed.parts.z[rows]
    weights = shapely.area(shapes) * (z[:, 1] - z[:, 0])
    centres = shapely.get_coordinates(shapely.centroid(shapes))
    total = float(weights.sum())
    return shapely.Point(weights @ centres / total if total > 0 else centres.mean(axis=0))
