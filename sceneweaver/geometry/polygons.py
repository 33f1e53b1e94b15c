"""Simple polygons in the plane [m]: area, order, convexity, convex pieces, union.

A polygon is its corners in order without the first one again, as tuples or as an array [n, 2].
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

Points = Any  # [n, 2]


def signed_area(points: Sequence[Sequence[float]] | Points) -> float:
    """Area [m2] of a polygon, positive when it runs counter-clockwise."""
    listed = getattr(points, "tolist", None)
    points = points if listed is None else listed()  # an array's numbers are slow one by one
    x0, y0 = points[0]
    total = 0.0
    for (ax, ay), (bx, by) in zip(points[1:], points[2:], strict=False):
        total += (ax - x0) * (by - y0) - (bx - x0) * (ay - y0)
    return float(total / 2)


def counter_clockwise(points: Points) -> Points:
    """The polygon as an array [n, 2] in counter-clockwise order."""
    import numpy as np

    array = np.asarray(points, dtype=float)
    return array if signed_area(array) >= 0 else array[::-1].copy()


def rectangle(depth: float, width: float) -> tuple[tuple[float, float], ...]:
    """The rectangle of that extent along x and y [m] about the origin, counter-clockwise from its least corner."""
    d, w = depth / 2, width / 2
    return (-d, -w), (d, -w), (d, w), (-d, w)


def normals(points: Points) -> Points:
    """Outward unit normals [m, 2] of a counter-clockwise polygon's edges, those of no length left out."""
    import numpy as np

    edge = np.concatenate((points[1:], points[:1])) - points
    length = np.hypot(edge[:, 0], edge[:, 1])
    if length.min() <= 1e-9:
        edge, length = edge[length > 1e-9], length[length > 1e-9]
    return edge[:, ::-1] * (1.0, -1.0) / length[:, None]


def tidy(points: Points, tolerance: float = 1e-9) -> Points:
    """The polygon counter-clockwise, without repeated and collinear corners; ``tolerance`` is a sine."""
    import numpy as np

    ring = counter_clockwise(points)
    ring = ring[np.abs(ring - np.roll(ring, 1, axis=0)).max(axis=1) > 1e-12]
    before, after = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    scale = np.hypot(before[:, 0], before[:, 1]) * np.hypot(after[:, 0], after[:, 1])
    keep = np.abs(cross) > tolerance * np.maximum(1e-12, scale)
    return ring[keep] if keep.sum() >= 3 else ring


def is_convex(points: Points, tolerance: float = 1e-9) -> bool:
    """Whether a counter-clockwise polygon [n, 2] never turns right by more than ``tolerance`` [m2]."""
    import numpy as np

    a = np.roll(points, -1, axis=0) - points
    b = np.roll(a, -1, axis=0)
    return bool(np.all(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] >= -tolerance))


def convex_pieces(points: Points) -> list[Points]:
    """A simple polygon as few convex ones: triangles, merged while they stay convex (after Hertel and Mehlhorn)."""
    import shapely

    ring = tidy(points)
    if is_convex(ring):
        return [ring]
    pieces = [p for p in shapely.constrained_delaunay_triangles(shapely.Polygon(ring)).geoms if p.area > 1e-10]
    at = 0
    while at < len(pieces):
        joined = next((j for j in range(at + 1, len(pieces)) if _joins(pieces[at], pieces[j])), None)
        if joined is None:
            at += 1
        else:
            pieces[at], at = pieces[at].union(pieces.pop(joined)), 0
    return [tidy(shapely.get_coordinates(p)[:-1]) for p in pieces]


def _joins(a: Any, b: Any) -> bool:
    """Whether two convex polygons share an edge and are convex together."""
    if a.intersection(b).length < 1e-9:
        return False
    union = a.union(b)
    return union.geom_type == "Polygon" and union.convex_hull.area - union.area < 1e-9


def union(shapes: Iterable[Any]) -> Any:
    """The union of shapely geometries; where edges nearly coincide, of those rounded to a micrometre.

    GEOS gives up on some edges that differ by the last digits of a float64 ("found non-noded intersection").
    """
    import shapely

    found = list(shapes)
    try:
        return shapely.union_all(found)
    except shapely.errors.GEOSException:
        return shapely.union_all(found, grid_size=1e-6)
