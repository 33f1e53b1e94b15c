"""Convex parts: what a simulator is given of a thing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sceneweaver.geometry.hulls import hull_of

THINNEST = 1e-4
"""[m]; thinner parts become boxes of this thickness."""


@dataclass(frozen=True, eq=False)
class Solid:
    """A convex part in the object's frame: ``points`` [V, 3], its ``volume`` [m3] and the number of its link.

    One of a ``handle`` is merged with no other. ``box`` is (centre [3], half extents [3]) where the part is a box
    along the axes of the object.
    """

    points: np.ndarray
    volume: float
    link: int = 0
    box: tuple[np.ndarray, np.ndarray] | None = None
    handle: bool = False

    @cached_property
    def planes(self) -> np.ndarray:
        """The faces as outward normal and offset, [F, 4]."""
        if self.box is None:
            hull = hull_of(self.points)
            assert hull is not None  # what is flat is a box
            return hull.planes
        (centre, half), turns = self.box, np.concatenate([np.eye(3), -np.eye(3)])
        return np.column_stack([turns, -turns @ centre - np.tile(half, 2)])


def solid_of(points: np.ndarray, link: int, handle: bool = False) -> Solid:
    """The part of these points; a box when it fills its own bounds, or is too thin for a hull."""
    low, high = points.min(axis=0), points.max(axis=0)
    extent = np.maximum(high - low, THINNEST)
    bounds = float(np.prod(extent))
    box = ((low + high) / 2, extent / 2)
    if float((high - low).min()) < THINNEST:
        return Solid(points, bounds, link, box, handle)
    hull = hull_of(points)
    if hull is None:
        return Solid(points, bounds, link, box, handle)
    full = hull.volume > bounds * (1 - 1e-3)
    return Solid(points[hull.vertices], hull.volume, link, box if full else None, handle)
