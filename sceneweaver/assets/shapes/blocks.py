"""Boxes with cut edges, and polygons drawn upward."""

from __future__ import annotations

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from .convex import Shape

Interval = tuple[float, float]

_BOX_FACES = np.array(
    [
        [0, 2, 3],
        [0, 3, 1],
        [4, 5, 7],
        [4, 7, 6],
        [0, 1, 5],
        [0, 5, 4],
        [2, 6, 7],
        [2, 7, 3],
        [0, 4, 6],
        [0, 6, 2],
        [1, 3, 7],
        [1, 7, 5],
    ],
    dtype=np.int32,
)


def box(x: Interval, y: Interval, z: Interval, bevel: float = 0.0) -> Shape:
    """A box between two ends on each axis; ``bevel`` metres are cut off its edges at 45 degrees (it stays convex)."""
    low, high = np.array([x[0], y[0], z[0]], dtype=np.float64), np.array([x[1], y[1], z[1]], dtype=np.float64)
    if not (high > low).all():
        raise ValueError(f"a box needs room on each axis, not {x}, {y}, {z}")
    bevel = min(bevel, 0.45 * float((high - low).min()))
    if bevel <= 0:
        corners = np.array([(i & 1, i >> 1 & 1, i >> 2 & 1) for i in range(8)])
        return low + corners * (high - low), _BOX_FACES.copy()
    middle, half = (low + high) / 2, (high - low) / 2
    vertices, faces = _bevelled()
    # Each vertex of the pattern lies on one face (its axis has the full half size) and back by the bevel on the others.
    return middle + np.sign(vertices) * np.where(np.abs(vertices) > 1.5, half, half - bevel), faces


def _bevelled() -> Shape:
    """The pattern of a box with cut edges: 24 vertices, 2 on the axis of their face and 1 on the others."""
    global _pattern
    if _pattern is None:
        from .convex import hull

        corners = 2.0 * np.array(list(np.ndindex(2, 2, 2))) - 1.0
        _pattern = hull(np.concatenate([corners * np.where(np.arange(3) == axis, 2.0, 1.0) for axis in range(3)]))
    return _pattern[0], _pattern[1].copy()


_pattern: Shape | None = None


def extrusion(polygon: np.ndarray, z: Interval, bevel: float = 0.0) -> Shape:
    """A simple polygon [V, 2], counter-clockwise, times a z interval; ``bevel`` cuts the edges of a convex one."""
    points = np.asarray(polygon, dtype=np.float64)
    n = len(points)
    inner = _inset(points, bevel) if bevel > 0 else None
    if inner is None:
        rings = [np.c_[points, np.full(n, z[0])], np.c_[points, np.full(n, z[1])]]
    else:
        rings = [
            np.c_[inner, np.full(n, z[0])],
            np.c_[points, np.full(n, z[0] + bevel)],
            np.c_[points, np.full(n, z[1] - bevel)],
            np.c_[inner, np.full(n, z[1])],
        ]
    cap = _triangles(rings[0][:, :2])
    faces = [cap[:, ::-1], cap + n * (len(rings) - 1)]
    for k in range(len(rings) - 1):
        faces.append(ring_faces(k * n, (k + 1) * n, n))
    return np.concatenate(rings), np.concatenate(faces).astype(np.int32)


def _inset(points: np.ndarray, distance: float) -> np.ndarray | None:
    """A convex polygon with all edges moved inward; None when it is not convex or too small."""
    before = points - np.roll(points, 1, axis=0)
    after = np.roll(points, -1, axis=0) - points
    if (before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0] <= 1e-12).any():
        return None
    u = before / np.linalg.norm(before, axis=1, keepdims=True)
    v = after / np.linalg.norm(after, axis=1, keepdims=True)
    if min(np.linalg.norm(after, axis=1)) < 2.5 * distance:
        return None
    inward = np.c_[-(u[:, 1] + v[:, 1]), u[:, 0] + v[:, 0]]
    scale = distance / np.maximum(1e-9, 1 + np.einsum("ij,ij->i", u, v))
    return points + inward * scale[:, None]


def _triangles(points: np.ndarray) -> np.ndarray:
    """A simple polygon as triangles of its own vertices, counter-clockwise."""
    n = len(points)
    a = np.roll(points, -1, axis=0) - points
    b = np.roll(a, -1, axis=0)
    if (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] >= -1e-12).all():
        i = np.arange(1, n - 1)
        return np.c_[np.zeros(n - 2, dtype=int), i, i + 1].astype(np.int32)
    import manifold3d

    return np.asarray(manifold3d.triangulate([points]), dtype=np.int32)
