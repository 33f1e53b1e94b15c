"""The shape of a thing as seen from above, from the outline of its solid parts."""

from __future__ import annotations

from typing import Any

from sceneweaver.geometry.polygons import union
from sceneweaver.verify.solids import Body

SQUARE = 1.12
"""Most quotient of two sides of what passes for square or round."""

FILLED, ROUND = 0.92, 0.74
"""Share of its rectangle that an angular outline fills, and that a round one fills at least (a disc fills 0.785)."""

BENT = 0.85
"""Share of its convex hull that an L or a U fills at most."""


def plan_shape(body: Body) -> str:
    """round, oval, square, rectangular, l_shaped or other; what hangs on a wall is round by its name alone."""
    import shapely

    if body.item.mount == "wall":
        return "round" if "round" in body.item.category else "rectangular"
    outline: Any = union([shapely.Polygon(p.polygon) for p in body.item.solids])
    hull = outline.convex_hull
    depth, width = body.size[:2]
    box = max(1e-9, depth * width)
    if outline.area < BENT * hull.area:
        return "l_shaped"
    ratio = max(depth, width) / max(1e-9, min(depth, width))
    if hull.area > FILLED * box:
        return "square" if ratio < SQUARE else "rectangular"
    if hull.area > ROUND * box:
        return "round" if ratio < SQUARE else "oval"
    return "other"
