"""Hulls that PhysX takes, on a GPU as well: of few vertices, and cut until none is oblong."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sceneweaver.physics.solids import Solid
from sceneweaver.physics.vertices import fewer_vertices

FEW_VERTICES = 48
"""Vertices of a hull at most. PhysX allows 64, but vases whose hull had 60 tilted on the spot and fell."""

LONGEST = 90.0
"""Extent of a hull in radii of a ball inside of it, at most; PhysX allows 100."""

_SLIM = 20.0  # times as long as thick, below which no hull is oblong
_DEEP = 4  # cuts of one part after each other


def sliced(solid: Solid) -> list[Solid]:
    """A part as slices of few vertices that are not oblong, itself where it is so already; boxes are never cut."""
    if solid.box is not None:
        return [solid]
    pieces = [_limited(piece) for piece in _sliced(solid.points, _DEEP)]
    return [replace(solid, points=points) for points in pieces]


def _limited(points: np.ndarray) -> np.ndarray:
    return points if len(points) <= FEW_VERTICES else fewer_vertices(points, FEW_VERTICES)


def _sliced(points: np.ndarray, cuts: int) -> list[np.ndarray]:
    from scipy.spatial import ConvexHull

    _, axes = np.linalg.eigh(np.cov(points.T))
    extents = np.ptp(points @ axes, axis=0)
    if not cuts or extents[2] < _SLIM * extents.min():
        return [points]
    hull = ConvexHull(points)
    within = points.mean(axis=0)
    radius = -(hull.equations[:, :3] @ within + hull.equations[:, 3]).max()
    if np.ptp(points, axis=0).max() < LONGEST * radius:
        return [points]
    along = points @ axes[:, int(extents.argmax())]
    side = along - (along.min() + along.max()) / 2
    ends = np.unique(np.sort(hull.simplices[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    i, j = ends[side[ends[:, 0]] * side[ends[:, 1]] < 0].T
    share = (side[i] / (side[i] - side[j]))[:, None]
    cut = points[i] * (1 - share) + points[j] * share
    halves = (np.concatenate([points[side <= 0], cut]), np.concatenate([points[side >= 0], cut]))
    return [piece for half in halves for piece in _sliced(half[np.unique(ConvexHull(half).vertices)], cuts - 1)]
