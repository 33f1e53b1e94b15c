"""Convex hulls of points, in the plane by shapely and in space by scipy."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .polygons import counter_clockwise

Array = NDArray[np.float64]


def convex_hull(points: ArrayLike) -> Array:
    """Corners [m, 2] of the convex hull of points [n, 2]: counter-clockwise, from the one with the least x, then y.

    Collinear corners are left out. Of points on one line it is the two ends, of equal points the one.
    """
    import shapely

    hull: Any = shapely.convex_hull(shapely.multipoints(np.asarray(points, dtype=float)))
    found = shapely.get_coordinates(hull)
    if hull.geom_type != "Polygon":
        return np.unique(found, axis=0)
    ring = counter_clockwise(found[:-1])
    first = int(np.lexsort((ring[:, 1], ring[:, 0]))[0])
    return np.concatenate([ring[first:], ring[:first]])


def hull_faces(points: Array) -> NDArray[np.int32]:
    """Triangles [f, 3] of the convex hull of points [n, 3], counter-clockwise seen from outside.

    Raises:
        ValueError: they are fewer than four or lie in one plane.
    """
    array = np.ascontiguousarray(points, dtype=float)
    return np.frombuffer(_faces(array.tobytes()), dtype=np.int32).reshape(-1, 3).copy()


@lru_cache(maxsize=8192)
def _faces(content: bytes) -> bytes:
    """Of float64 points [n, 3]; the same furniture has the same points in every finish."""
    from scipy.spatial import ConvexHull, QhullError

    points = np.frombuffer(content).reshape(-1, 3)
    try:
        hull = ConvexHull(points)
    except QhullError as error:
        raise ValueError("the points lie in one plane or are fewer than four") from error
    faces = hull.simplices.astype(np.int32)
    a, b, c = points[faces.T]
    u, v = (b - a).T, (c - a).T
    cross = np.stack([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], axis=1)
    inward = np.einsum("ij,ij->i", cross, hull.equations[:, :3]) < 0
    faces[inward] = faces[inward][:, ::-1]
    return faces.tobytes()


def hull_mesh(points: ArrayLike) -> tuple[Array, NDArray[np.int32]]:
    """The convex hull of points [n, 3] as vertices [v, 3] and outward triangles [f, 3]; errors of `hull_faces`."""
    array = np.asarray(points, dtype=float)
    used, packed = np.unique(hull_faces(array), return_inverse=True)
    return array[used], packed.reshape(-1, 3).astype(np.int32)
