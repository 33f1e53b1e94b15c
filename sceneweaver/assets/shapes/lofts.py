"""Skins over rings, and rings to put into them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from .convex import Shape, hull

Interval = tuple[float, float]


def ellipse(rx: float, ry: float, z: float, count: int = 20, x: float = 0.0, y: float = 0.0) -> np.ndarray:
    """A level ring [count, 3] about (x, y)."""
    t = (np.arange(count) + 0.5) * (2 * np.pi / count)
    return np.c_[x + rx * np.cos(t), y + ry * np.sin(t), np.full(count, z)]


def rectangle(x: Interval, y: Interval, z: float, radius: float, steps: int = 3) -> np.ndarray:
    """A level rectangle with round corners as a ring [4 steps + 4, 3], counter-clockwise."""
    radius = max(0.0, min(radius, 0.499 * (x[1] - x[0]), 0.499 * (y[1] - y[0])))
    t = np.linspace(0, np.pi / 2, steps + 1)
    points = []
    for k, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        mx, my = (x[1] if sx > 0 else x[0]) - sx * radius, (y[1] if sy > 0 else y[0]) - sy * radius
        a = t + k * np.pi / 2
        points.append(np.c_[mx + radius * np.cos(a), my + radius * np.sin(a), np.full(steps + 1, z)])
    return np.concatenate(points)


def lofted(rings: Sequence[np.ndarray]) -> Shape:
    """A closed skin over rings [K, 3] of as many points each, from bottom to top; the first and last are capped."""
    n, k = len(rings[0]), len(rings)
    faces = [ring_faces(r * n, (r + 1) * n, n) for r in range(k - 1)]
    fan = np.arange(1, n - 1)
    faces += [np.c_[0 * fan, fan + 1, fan], np.c_[0 * fan, fan, fan + 1] + (k - 1) * n]
    return np.concatenate(rings), np.concatenate(faces).astype(np.int32)


def dome(radius: float, low: float, high: float, steps: int = 4, tip: float = 0.0) -> list[tuple[float, float]]:
    """Profile points (radius, z) of a round top, from (radius, low) to (tip, high)."""
    t = np.linspace(0, np.pi / 2, steps + 1)
    return [(float(tip + (radius - tip) * np.cos(a)), float(low + (high - low) * np.sin(a))) for a in t]


def staved_hulls(
    outer: Sequence[np.ndarray],
    inner: Sequence[np.ndarray],
    ends: Sequence[int],
    split: tuple[int, int] | None = None,
) -> list[Shape]:
    """Convex parts of a hollow loft: a floor, and staves around it between the points ``ends`` of its rings [K, 3].

    ``outer`` rises to the rim, ``inner`` falls from it; the staves of a bellied body are cut at the ``split`` rings,
    one of each.
    """
    n = len(outer[0])
    hulls = [hull(np.concatenate([outer[0], inner[-1]]))]
    layers = [[*outer, *inner]]
    if split is not None:
        low, high = split
        layers = [[*outer[: low + 1], *inner[high:]], [*outer[low:], *inner[: high + 1]]]
    for a, e in zip(ends[:-1], ends[1:], strict=True):
        index = np.arange(a, e + 1) % n
        hulls += [hull(np.concatenate([ring[index] for ring in layer])) for layer in layers]
    return hulls
