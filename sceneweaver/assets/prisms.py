"""Convex hulls as the few prisms that the engine moves: at most eight, of at most eight corners, containing all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.scene import Part

from .body import Hull

MAX_PRISMS = 8
MAX_CORNERS = 8

Box = tuple[tuple[float, float], tuple[float, float], tuple[float, float]]

_SLACK = 0.5e-3
"""Volume [m3] that one merge may add unasked: half a litre, as under a chair's stretcher."""

_ROUND = 6
"""Decimals of a corner; prisms are first made larger by one unit of it, so that they still contain the hulls."""


@dataclass
class _Lump:
    """Some hulls together: their points in the plane and their z interval."""

    points: np.ndarray
    z: tuple[float, float]
    area: float
    low: np.ndarray
    high: np.ndarray

    @property
    def volume(self) -> float:
        return self.area * (self.z[1] - self.z[0])


def prisms_of(
    hulls: Sequence[Hull],
    groups: Sequence[str | None] | None = None,
    clear: Sequence[Box] = (),
    limit: int = MAX_PRISMS,
) -> tuple[Part, ...]:
    """Prisms that contain the hulls, at most ``limit``.

    Hulls of one group become one prism. The rest are merged, cheapest first, while a merge adds next to nothing or
    there are too many. ``clear`` boxes, such as the space over a shelf board, are entered only if there is no other
    way.
    """
    keyed: dict[object, list[np.ndarray]] = {}
    for i, hull in enumerate(hulls):
        name = groups[i] if groups is not None else None
        keyed.setdefault(("group", name) if name is not None else i, []).append(hull.vertices)
    lumps = [_lump(np.concatenate(points)) for points in keyed.values()]
    boxes = np.array(clear, dtype=np.float64).reshape(-1, 3, 2)
    while len(lumps) > 1:
        cost = _costs(lumps, boxes)
        i, j = divmod(int(np.argmin(cost)), len(lumps))
        merged = _join(lumps[i], lumps[j])
        if len(lumps) <= limit:
            exact = merged.volume - lumps[i].volume - lumps[j].volume
            if cost[i, j] > 1.0 or max(exact, 0.0) > _SLACK:
                break
        lumps = [lump for k, lump in enumerate(lumps) if k not in (i, j)] + [merged]
    return tuple(
        Part(polygon=_corners(lump.points), z=(_floor(lump.z[0]), _ceil(lump.z[1])))
        for lump in sorted(lumps, key=lambda lump: (-round(lump.volume, 9), *np.round(lump.low, 6)))
    )


def _lump(points: np.ndarray) -> _Lump:
    z = (float(points[:, 2].min()), float(points[:, 2].max()))
    plane = outline(points[:, :2])
    low, high = plane.min(axis=0), plane.max(axis=0)
    return _Lump(plane, z, signed_area(plane), np.r_[low, z[0]], np.r_[high, z[1]])


def _join(a: _Lump, b: _Lump) -> _Lump:
    plane = outline(np.concatenate([a.points, b.points]))
    low, high = np.minimum(a.low, b.low), np.maximum(a.high, b.high)
    return _Lump(plane, (float(low[2]), float(high[2])), signed_area(plane), low, high)


def _costs(lumps: list[_Lump], clear: np.ndarray) -> np.ndarray:
    """Volume that each merge adds, by boxes, plus one m3 and more for entering a box to keep clear; [n, n]."""
    low, high = np.stack([lump.low for lump in lumps]), np.stack([lump.high for lump in lumps])
    own = np.array([lump.volume for lump in lumps])
    span_low, span_high = np.minimum(low[:, None], low[None]), np.maximum(high[:, None], high[None])
    shared = np.clip(np.minimum(high[:, None], high[None]) - np.maximum(low[:, None], low[None]), 0, None).prod(axis=2)
    cost = (span_high - span_low).prod(axis=2) - (high - low).prod(axis=1)[:, None] - (high - low).prod(axis=1)[None]
    cost = cost + shared + 1e-6 * (own[:, None] + own[None])
    for box in clear:
        inside = (np.minimum(span_high, box[:, 1]) - np.maximum(span_low, box[:, 0])).min(axis=2) > 1e-4
        already = (np.minimum(high, box[:, 1]) - np.maximum(low, box[:, 0])).min(axis=1) > 1e-4
        cost = cost + 10.0 * (inside & ~(already[:, None] | already[None]))
    cost[np.tril_indices(len(lumps))] = np.inf
    return cost


def outline(points: np.ndarray) -> np.ndarray:
    """The convex hull of points [N, 2], counter-clockwise, without collinear corners."""
    return convex_hull(np.round(points, 9) + 0.0)  # without the noise of upright edges


def _corners(points: np.ndarray) -> tuple[tuple[float, float], ...]:
    """At most eight corners around a convex polygon: its own, or where eight lines at 45 degrees touch it."""
    if len(points) > MAX_CORNERS:
        points = _octagon(points)
    middle = points.mean(axis=0)
    # Rounded away from the middle, so that the prism contains what it stands for.
    grown = np.where(points > middle, np.ceil(points * 10**_ROUND - 1e-3), np.floor(points * 10**_ROUND + 1e-3))
    ring = outline(grown / 10**_ROUND)
    return tuple((float(x), float(y)) for x, y in ring)


def _octagon(points: np.ndarray) -> np.ndarray:
    angle = np.arange(8) * (np.pi / 4)
    normal = np.c_[np.cos(angle), np.sin(angle)]
    reach = (points @ normal.T).max(axis=0)
    corners = []
    for k in range(8):
        a, b = normal[k], normal[(k + 1) % 8]
        corners.append(np.linalg.solve(np.stack([a, b]), [reach[k], reach[(k + 1) % 8]]))
    ring = np.array(corners)
    keep = np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1) > 1e-5
    return outline(ring[keep])


def _floor(value: float) -> float:
    return float(np.floor(value * 10**_ROUND + 1e-3) / 10**_ROUND)


def _ceil(value: float) -> float:
    return float(np.ceil(value * 10**_ROUND - 1e-3) / 10**_ROUND)
