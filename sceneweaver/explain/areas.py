"""What arithmetic can prove about areas by horizontal sections of prisms: an object that fits at no yaw, a floor or
surface that is too small."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

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


def fits_turned(points: Points, planes: np.ndarray) -> bool:
    """Whether a convex hull may fit between half planes at some yaw; False is certain."""
    reach = float(np.max(np.hypot(points[:, 0], points[:, 1])))
    steps = 360
    slack = 2 * PENETRATION + reach * math.pi / steps
    for angle in np.arange(steps) * (2 * math.pi / steps):
        turned = SE2(yaw=angle).to_world(points)
        room = 1e4 * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        for nx, ny, offset in planes:
            need = offset - float((turned @ np.array([nx, ny])).min()) - slack
            room = _clip(room, nx, ny, need)
            if not len(room):
                break
        if len(room):
            return True
    return False


def _clip(polygon: Points, nx: float, ny: float, offset: float) -> Points:
    """The part of a convex polygon with n . x >= offset."""
    height = polygon @ np.array([nx, ny]) - offset
    if np.all(height >= 0):
        return polygon
    kept = []
    for a, b, ha, hb in zip(polygon, np.roll(polygon, -1, axis=0), height, np.roll(height, -1), strict=True):
        if ha >= 0:
            kept.append(a)
        if (ha >= 0) != (hb >= 0):
            kept.append(a + (b - a) * (ha / (ha - hb)))
    return np.asarray(kept)


@dataclass(frozen=True)
class Fullness:
    """Footprints on a floor or surface at the height where they need most, against what there is [m2]."""

    need: float
    free: float
    count: int


def fullest(
    solids: Sequence[Sequence[Prism]], floor, blocked: Sequence[tuple[Prism, float]], most: int = 8
) -> Fullness | None:
    """The height at which sections exceed the free area most; None when they do nowhere.

    Sections at one height must not overlap, so their sum over the free area proves that there is not enough.
    """
    levels = levels_between(p for s in solids for p in s)
    if not levels:
        return None
    needs = np.zeros(len(levels))
    counts = np.zeros(len(levels), dtype=int)
    for prisms in solids:
        areas: dict[tuple[int, ...], float] = {}
        for i, z in enumerate(levels):
            there = tuple(j for j, p in enumerate(prisms) if p.z[0] < z < p.z[1])
            if there and there not in areas:
                areas[there] = section([prisms[j] for j in there], z).area
            needs[i] += areas.get(there, 0.0)
            counts[i] += bool(there)
    worst = None
    for i in np.argsort(-needs)[:most]:
        taken = [
            shapely.Polygon(p.polygon).buffer(-give, join_style="mitre")
            for p, give in blocked
            if p.z[0] + PENETRATION < levels[i] < p.z[1] - PENETRATION
        ]
        free = floor.buffer(PENETRATION, join_style="mitre").difference(union(taken)).area
        if needs[i] > free and (worst is None or needs[i] - free > worst.need - worst.free):
            worst = Fullness(float(needs[i]), float(free), int(counts[i]))
    return worst
