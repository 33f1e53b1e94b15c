"""The shape of a thing as seen from above, from the outline of its solid parts."""

from __future__ import annotations

from typing import Any

from sceneweaver.geometry.polygons import union
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.solids import Body

SHAPES = fault_kind("wrong_shape").limits
"""Quotients of sides and shares of boxes and hulls that tell shapes apart; a disc fills 0.785 of its square."""


def plan_shape(body: Body) -> str:
    """round, oval, square, rectangular, l_shaped or other; what hangs on a wall is round by its name alone."""
    import shapely

    if body.item.mount == "wall":
        return "round" if "round" in body.item.category else "rectangular"
    outline: Any = union([shapely.Polygon(p.polygon) for p in body.item.solids])
    hull = outline.convex_hull
    depth, width = body.size[:2]
    box = max(1e-9, depth * width)
    if outline.area < SHAPES["bent"] * hull.area:
        return "l_shaped"
    ratio = max(depth, width) / max(1e-9, min(depth, width))
    if hull.area > SHAPES["filled"] * box:
        return "square" if ratio < SHAPES["square"] else "rectangular"
    if hull.area > SHAPES["round"] * box:
        return "round" if ratio < SHAPES["square"] else "oval"
    return "other"
