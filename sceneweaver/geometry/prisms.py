"""Upright prisms as points and triangles: a polygon in the plane times an interval of height."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Faces = NDArray[np.int32]


def prism_vertices(polygon: ArrayLike, z: tuple[float, float]) -> Array:
    """The vertices [2 n, 3] of the prism of a polygon [n, 2] and ``z`` [m]: its lower ring, then its upper one."""
    plan = np.asarray(polygon, dtype=float).reshape(-1, 2)
    return np.concatenate([np.column_stack([plan, np.full(len(plan), float(level))]) for level in z])


def ring_faces(low: int, high: int, n: int) -> Faces:
    """The faces [2 n, 3] between two closed rings of n vertices that start at ``low`` and ``high``: outward when the
    rings run counter-clockwise and ``high`` is above; side by side first all lower triangles, then all upper ones."""
    around, above = _ring(n)
    return around + np.where(above, np.int32(high), np.int32(low))


@cache
def _ring(n: int) -> tuple[Faces, NDArray[np.bool_]]:
    """The faces of `ring_faces` by their places in the rings, and which corners are in the upper one; not to change."""
    i = np.arange(n, dtype=np.int32)
    j = (i + 1) % n
    around = np.concatenate([np.stack([i, j, j], axis=1), np.stack([i, j, i], axis=1)]).astype(np.int32)
    above = np.repeat([[False, False, True], [False, True, True]], n, axis=0)
    return around, above


def prism_mesh(polygon: ArrayLike, z: tuple[float, float]) -> tuple[Array, Faces]:
    """The closed mesh of a prism of a convex counter-clockwise polygon [n, 2]: vertices [2 n, 3], outward faces.

    Its faces are the n - 2 of the bottom, the n - 2 of the top, then the sides as `ring_faces` has them.
    """
    vertices = prism_vertices(polygon, z)
    n = len(vertices) // 2
    fan = np.array([(0, k, k + 1) for k in range(1, n - 1)], dtype=np.int32).reshape(-1, 3)
    return vertices, np.concatenate([fan[:, ::-1], fan + n, ring_faces(0, n, n)]).astype(np.int32)
