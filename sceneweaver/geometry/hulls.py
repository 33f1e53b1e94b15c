"""Convex hulls of points, in the plane by shapely and in space by scipy."""

from __future__ import annotations

from functools import cached_property, lru_cache
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


def hull_faces(points: ArrayLike) -> NDArray[np.int32]:
    """Triangles [f, 3] of the convex hull of points [n, 3], counter-clockwise seen from outside.

    Raises:
        ValueError: they are fewer than four or lie in one plane.
    """
    return _solid_hull(points).faces.copy()


class Hull:
    """The convex hull of points [n, 3]; its arrays are shared and cannot be written to.

    Attributes:
        vertices: numbers of the points that are its corners, ascending.
        planes: its faces as outward normals and offsets [f, 4].
        volume: its volume, in the cubed unit of the points.
    """

    def __init__(self, content: bytes) -> None:
        from scipy.spatial import ConvexHull

        hull = ConvexHull(np.frombuffer(content).reshape(-1, 3))
        self._content, self._simplices = content, hull.simplices
        self.vertices, self.planes, self.volume = hull.vertices, hull.equations, float(hull.volume)
        for array in (self.vertices, self.planes):
            array.flags.writeable = False

    @cached_property
    def faces(self) -> NDArray[np.int32]:
        """Its triangles [f, 3], counter-clockwise seen from outside."""
        points, faces = np.frombuffer(self._content).reshape(-1, 3), self._simplices.astype(np.int32)
        a, b, c = points[faces.T]
        u, v = (b - a).T, (c - a).T
        cross = np.stack([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], axis=1)
        inward = np.einsum("ij,ij->i", cross, self.planes[:, :3]) < 0
        faces[inward] = faces[inward][:, ::-1]
        faces.flags.writeable = False
        return faces


def hull_of(points: ArrayLike) -> Hull | None:
    """The convex hull of points [n, 3]; None where they are fewer than four or lie in one plane."""
    return _hull(np.ascontiguousarray(points, dtype=float).tobytes())


@lru_cache(maxsize=8192)
def _hull(content: bytes) -> Hull | None:
    """Of float64 points [n, 3].

    A part of furniture has the same points as it is drawn, given to a simulator and weighed, and in every finish.
    """
    from scipy.spatial import QhullError

    try:
        return Hull(content)
    except QhullError:
        return None


def hull_mesh(points: ArrayLike) -> tuple[Array, NDArray[np.int32]]:
    """The convex hull of points [n, 3] as vertices [v, 3] and outward triangles [f, 3]; errors of `hull_faces`."""
    hull = _solid_hull(points)
    used = hull.vertices
    return np.asarray(points, dtype=float)[used], np.searchsorted(used, hull.faces).astype(np.int32)


def _solid_hull(points: ArrayLike) -> Hull:
    hull = hull_of(points)
    if hull is None:
        raise ValueError("the points lie in one plane or are fewer than four")
    return hull
