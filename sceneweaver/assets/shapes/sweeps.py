"""Tubes and mouldings: a round or any other convex section drawn along a path."""

from __future__ import annotations

from functools import cache

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from .convex import Shape, hull


def sweep(path: np.ndarray, section: float | np.ndarray, segments: int = 10, closed: bool = False) -> Shape:
    """A section drawn along points [N, 3]: a radius, or a convex polygon [K, 2], counter-clockwise.

    The section's y is turned up as far as the path allows and its x to the left of the way; it never twists.
    """
    rings = _rings(np.asarray(path, dtype=np.float64), _section(section, segments), closed)
    n, k = rings.shape[:2]
    return rings.reshape(-1, 3), _sweep_faces(n, k, closed).copy()


@cache
def _sweep_faces(n: int, k: int, closed: bool) -> np.ndarray:
    """The faces of a sweep of k points along n; not to change."""
    faces = [ring_faces(i * k, (i + 1) * k, k) for i in range(n - 1)]
    if closed:
        faces.append(ring_faces((n - 1) * k, 0, k))
    else:
        fan = np.arange(1, k - 1)
        faces.append(np.c_[np.zeros(k - 2, dtype=int), fan + 1, fan])
        faces.append(np.c_[np.zeros(k - 2, dtype=int), fan, fan + 1] + (n - 1) * k)
    return np.concatenate(faces).astype(np.int32)


def sweep_hulls(path: np.ndarray, section: float | np.ndarray, segments: int = 10, closed: bool = False) -> list[Shape]:
    """The convex parts of a sweep: one hull for each stretch that is straight, or nearly so."""
    if len(path) == 2 and not closed:
        return [sweep(path, section, segments)]  # convex itself
    rings = _rings(np.asarray(path, dtype=np.float64), _section(section, segments), closed)
    n = len(rings)
    ends = range(n if closed else n - 1)
    return [hull(np.concatenate([rings[i], rings[(i + 1) % n]])) for i in ends]


def _section(section: float | np.ndarray, segments: int) -> np.ndarray:
    if isinstance(section, int | float):
        angle = (np.arange(segments) + 0.5) * (2 * np.pi / segments)
        return section * np.c_[np.cos(angle), np.sin(angle)]
    return np.asarray(section, dtype=np.float64)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The cross product of two vectors: that of NumPy takes ten times as long for so few numbers."""
    (x, y, z), (u, v, w) = a.tolist(), b.tolist()
    return np.array([y * w - z * v, z * u - x * w, x * v - y * u])


def _rings(path: np.ndarray, section: np.ndarray, closed: bool) -> np.ndarray:
    """The section at each point of the path, in the plane that halves the bend; [N, K, 3]."""
    after = np.roll(path, -1, axis=0) - path
    before = path - np.roll(path, 1, axis=0)
    if not closed:
        after[-1] = before[-1]
        before[0] = after[0]
    u = before / np.linalg.norm(before, axis=1, keepdims=True)
    v = after / np.linalg.norm(after, axis=1, keepdims=True)
    along = u + v
    along /= np.maximum(1e-9, np.linalg.norm(along, axis=1, keepdims=True))
    rings = []
    left = None
    for i in range(len(path)):
        if left is None:
            up = np.array([0.0, 0.0, 1.0]) if abs(along[i, 2]) < 0.9 else np.array([1.0, 0.0, 0.0])
            left = _cross(up, along[i])
        left = left - along[i] * (left @ along[i])  # carried along with the least twist
        left /= np.linalg.norm(left)
        up = _cross(along[i], left)
        # A bend makes the section longer across it (a mitre), so that straight stretches keep their width.
        bend = v[i] - u[i]
        size = np.linalg.norm(bend)
        ring = section[:, :1] * left + section[:, 1:] * up
        if size > 1e-9:
            bend /= size
            stretch = min(2.0, 1.0 / max(0.5, float(along[i] @ u[i])))
            ring = ring + np.outer(ring @ bend, bend) * (stretch - 1.0)
        rings.append(path[i] + ring)
    return np.stack(rings)
