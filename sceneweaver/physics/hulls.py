"""Collision parts for a simulator: few, convex, and boxes where they are boxes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.scene import Part, SceneObject

MOST = 40
"""Parts of one asset that a simulator is given at most, where merging can reach that."""

_SLACK = 1e-4  # [m] by which a part may stand out of a prism and still belong to it
_THINNEST = 1e-4  # [m]; thinner parts become boxes of this thickness
_WASTE = 0.01  # share of volume that a merge may add when it is not forced


@dataclass(frozen=True)
class Solid:
    """A convex part in the object's frame: ``points`` [V, 3], its ``volume`` [m3] and the number of its link.

    ``box`` is (centre [3], half extents [3]) where the part is a box along the axes of the object.
    """

    points: np.ndarray
    volume: float
    link: int = 0
    box: tuple[np.ndarray, np.ndarray] | None = None


def solids_of(thing: SceneObject, asset: Asset | None, scale: np.ndarray) -> list[Solid]:
    """The parts of an object; of an asset its hulls, ``scale`` [3] times as large, else the object's own prisms."""
    if asset is None or not asset.hulls:
        return [_solid(_corners(part), 0) for part in thing.solids]
    prisms = [_corners(part) for part in asset.parts]
    found = [_solid(np.asarray(hull.vertices, dtype=float), hull.link) for hull in asset.hulls]
    merged = reduce(found, [part for part in asset.parts], MOST) if len(found) > MOST and prisms else found
    if np.allclose(scale, 1.0, atol=1e-9):
        return merged
    return [_solid(solid.points * scale, solid.link) for solid in merged]


def reduce(solids: Sequence[Solid], parts: Sequence[Part], most: int) -> list[Solid]:
    """Merge parts until at most ``most`` are left, as far as that goes.

    Two parts are merged only when both lie in one prism (and belong to one link): a prism is convex, so their common
    hull stays in it, and what was free in the scene stays free. Those go first whose hull adds the least volume.
    """
    import heapq

    home = [_homes(solid.points, parts) for solid in solids]
    live: dict[int, Solid] = dict(enumerate(solids))
    homes = dict(enumerate(home))
    heap: list[tuple[float, int, int, Solid]] = []

    def offer(i: int, j: int) -> None:
        one, two = live[i], live[j]
        if one.link != two.link or not homes[i] & homes[j]:
            return
        both = _solid(np.concatenate([one.points, two.points]), one.link)
        heapq.heappush(heap, (both.volume - one.volume - two.volume, i, j, both))

    numbers = sorted(live)
    for a, i in enumerate(numbers):
        for j in numbers[a + 1 :]:
            offer(i, j)
    fresh = len(numbers)
    total = sum(s.volume for s in solids)
    while heap:
        added, i, j, both = heapq.heappop(heap)
        if i not in live or j not in live:
            continue
        if len(live) <= most and added > _WASTE * total:
            break
        common = homes[i] & homes[j]
        del live[i], live[j]
        live[fresh], homes[fresh] = both, common
        for k in [k for k in live if k != fresh]:
            offer(k, fresh)
        fresh += 1
    return [live[k] for k in sorted(live)]


def _homes(points: np.ndarray, parts: Sequence[Part]) -> frozenset[int]:
    """The prisms that contain all points."""
    found = []
    for k, part in enumerate(parts):
        plan = np.asarray(part.polygon, dtype=float)
        edge = np.roll(plan, -1, axis=0) - plan
        normal = np.stack([edge[:, 1], -edge[:, 0]], axis=1)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
        beyond = (points[:, :2] @ normal.T - (normal * plan).sum(axis=1)).max()
        if max(beyond, part.z[0] - points[:, 2].min(), points[:, 2].max() - part.z[1]) <= _SLACK:
            found.append(k)
    return frozenset(found)


def _corners(part: Part) -> np.ndarray:
    plan = np.asarray(part.polygon, dtype=float)
    return np.concatenate([np.column_stack([plan, np.full(len(plan), z)]) for z in part.z])


def _solid(points: np.ndarray, link: int) -> Solid:
    """The part of these points; a box when it fills its own bounds, or is too thin for a hull."""
    from scipy.spatial import ConvexHull, QhullError

    low, high = points.min(axis=0), points.max(axis=0)
    extent = np.maximum(high - low, _THINNEST)
    bounds = float(np.prod(extent))
    box = ((low + high) / 2, extent / 2)
    if float((high - low).min()) < _THINNEST:
        return Solid(points, bounds, link, box)
    try:
        hull = ConvexHull(points)
    except QhullError:
        return Solid(points, bounds, link, box)
    kept = points[hull.vertices]
    volume = float(hull.volume)
    return Solid(kept, volume, link, box if volume > bounds * (1 - 1e-3) else None)


__all__ = ["MOST", "Solid", "reduce", "solids_of"]
