"""Hulls of few vertices, as simulators on a GPU want them."""

from __future__ import annotations

import numpy as np

MOST_VERTICES = 64
"""Vertices of a hull at most: the limit of PhysX and of Newton."""

_LEVEL = 1e-5  # [m] within which vertices lie in the plane of the underside, or of the top
_AT_ONCE = 4  # vertices that are added before the hull is found anew
_IN_PLANE = 20  # vertices that a top has at most
_STANDS_ON = 8  # the same of an underside: with more, contacts jump from one to the next, and things walk


def fewer_vertices(points: np.ndarray, most: int = MOST_VERTICES) -> np.ndarray:
    """At most ``most`` of the vertices [V, 3] of a convex hull, so that their hull differs little from the whole one.

    It lies within the whole, as its vertices are among those. Undersides and tops stay level and nearly as wide, for
    things stand on them. Of all else those come next that stand out farthest of the hull of those chosen.
    """
    under = np.flatnonzero(points[:, 2] <= points[:, 2].min() + _LEVEL)
    if len(under) > _STANDS_ON:
        points = np.delete(points, np.setdiff1d(under, _widest(points[:, :2], under, _STANDS_ON)), axis=0)
    if len(points) <= most:
        return points
    chosen = [int(k) for k in (*points.argmin(axis=0), *points.argmax(axis=0))]
    for level in (points[:, 2].min(), points[:, 2].max()):
        chosen += _widest(points[:, :2], np.flatnonzero(np.abs(points[:, 2] - level) <= _LEVEL), _IN_PLANE)
    chosen = list(dict.fromkeys(chosen))
    while len(chosen) < most:
        planes = _planes(points[chosen])
        if planes is None:  # all in one plane so far
            middle = points[chosen].mean(axis=0)
            out = np.abs((points - middle) @ np.linalg.svd(points[chosen] - middle)[2][-1:].T)
        else:
            out = points @ planes[:, :3].T + planes[:, 3]
        out[chosen] = -np.inf
        farthest = out.argmax(axis=0)  # of each face
        order = np.argsort(-out[farthest, np.arange(len(farthest))])
        chosen += list(dict.fromkeys(farthest[order].tolist()))[: min(_AT_ONCE, most - len(chosen))]
    return points[sorted(chosen)]


def _planes(points: np.ndarray) -> np.ndarray | None:
    """The faces of their hull as outward normal and offset [F, 4]; None for points in one plane."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return ConvexHull(points).equations
    except QhullError:
        return None


def _widest(plan: np.ndarray, level: np.ndarray, most: int) -> list[int]:
    """At most ``most`` of those numbers of points [V, 2], so that their polygon is nearly as large."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        ring = level[ConvexHull(plan[level]).vertices]  # counter-clockwise
    except (QhullError, ValueError):
        return level.tolist()[:2]
    if len(ring) <= most:
        return ring.tolist()
    corners = plan[ring]
    kept = [0, int(np.linalg.norm(corners - corners[0], axis=1).argmax())]
    while len(kept) < most:
        kept.sort()
        worst, at = -1.0, 0
        for k, end in zip(kept, [*kept[1:], len(ring)], strict=True):
            chord = corners[end % len(ring)] - corners[k]
            off = corners[k + 1 : end] - corners[k]
            if len(off):
                far = np.abs(chord[0] * off[:, 1] - chord[1] * off[:, 0]) / max(float(np.hypot(*chord)), 1e-12)
                if far.max() > worst:
                    worst, at = float(far.max()), k + 1 + int(far.argmax())
        kept.append(at)
    return ring[sorted(kept)].tolist()
