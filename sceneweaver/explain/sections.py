"""Horizontal sections of prisms: what an object covers at a height."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

import numpy as np
import shapely

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.polygons import union
from sceneweaver.geometry.se2 import SE2
from sceneweaver.layout.shapes import Points, Prism

PENETRATION = 1.0e-3  # [m] that bodies may sink into each other and into walls
INTRUSION = 5.0e-3  # [m] that they may reach into the clearance of a door or window


def hull(solids: Sequence[Prism]) -> Points:
    """The convex hull of solids, seen from above."""
    return convex_hull(np.concatenate([p.polygon for p in solids]))


def extent(prisms: Sequence[Prism]) -> tuple[float, float]:
    """Lowest and highest point of an object above its origin."""
    return min(p.z[0] for p in prisms), max(p.z[1] for p in prisms)


def levels_between(prisms: Iterable[Prism]) -> list[float]:
    """Heights in the middle between any two neighbouring ends of prisms."""
    ends = sorted({round(z, 4) for p in prisms for z in p.z})
    return [0.5 * (a + b) for a, b in itertools.pairwise(ends) if b - a > 4 * PENETRATION]


def section(prisms: Iterable[Prism], z: float, shrink: float = PENETRATION):
    """The section of prisms at height z, each smaller by what may sink in."""
    shapes = [
        shapely.Polygon(p.polygon).buffer(-shrink, join_style="mitre")
        for p in prisms
        if p.z[0] + PENETRATION < z < p.z[1] - PENETRATION
    ]
    return union(shapes)


def moved(prisms: Iterable[Prism], pose: np.ndarray) -> list[Prism]:
    """Prisms of an object, in the room that it has this pose [x, y, z, yaw] in."""
    x, y, z, yaw = (float(value) for value in pose)
    return [Prism(SE2(x, y, yaw).to_world(p.polygon), (p.z[0] + z, p.z[1] + z)) for p in prisms]
