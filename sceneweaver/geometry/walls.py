"""Walls of a room: the edges of its outline, each with coordinates of its own."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .se2 import SE2

Point = tuple[float, float]
Quad = tuple[Point, Point, Point, Point]


@dataclass(frozen=True)
class Wall:
    """The inner face of wall ``index``: from corner ``start`` to ``end``, ``length`` metres along a unit vector.

    ``inward`` is the unit normal into the room. A point has an offset along the wall and a depth into the room [m].
    """

    index: int
    start: Point
    end: Point
    along: Point
    inward: Point
    length: float

    @property
    def outward(self) -> Point:
        """Unit normal out of the room."""
        return -self.inward[0], -self.inward[1]

    @property
    def yaw(self) -> float:
        """Direction [rad] of ``along``, in (-pi, pi]."""
        return math.atan2(self.along[1], self.along[0])

    @property
    def frame(self) -> SE2:
        """The frame at the first corner with +x along the wall and +y into the room."""
        return SE2(*self.start, self.yaw)

    def point(self, offset: Any, depth: Any = 0.0) -> tuple[Any, Any]:
        """The world point at an offset and a depth [m]; floats, or arrays of one shape."""
        (x, y), (tx, ty), (nx, ny) = self.start, self.along, self.inward
        return x + tx * offset + nx * depth, y + ty * offset + ny * depth

    def coordinates(self, point: Any) -> tuple[Any, Any]:
        """Offset and depth [m] of a world point (x, y); floats, or arrays of one shape."""
        dx, dy = point[0] - self.start[0], point[1] - self.start[1]
        return dx * self.along[0] + dy * self.along[1], dx * self.inward[0] + dy * self.inward[1]

    def strip(self, offset: float, width: float, near: float, far: float) -> Quad:
        """The rectangle along the wall between two depths [m]; counter-clockwise where near < far."""
        end = offset + width
        return self.point(offset, near), self.point(end, near), self.point(end, far), self.point(offset, far)


def walls_of(outline: Sequence[Sequence[float]] | Any) -> tuple[Wall, ...]:
    """The walls of a counter-clockwise outline [n, 2] without repeated corners; wall i runs from corner i to i + 1."""
    corners: list[Point] = [(float(x), float(y)) for x, y in outline]
    walls = []
    for i, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1], strict=True)):
        length = math.dist(a, b)
        along = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        walls.append(Wall(i, a, b, along, (-along[1], along[0]), length))
    return tuple(walls)


def wall_behind(walls: Sequence[Wall], point: Sequence[float], front: Sequence[float]) -> int:
    """The wall that something hangs on at a point (x, y, ...) and that looks along a unit vector (x, y).

    It is the nearest one; half a metre is added for one that it faces, as near a corner another wall may be nearer.
    """

    def gap(wall: Wall) -> tuple[float, int]:
        offset, depth = wall.coordinates(point)
        beyond = offset - min(max(offset, 0.0), wall.length)
        turned = max(0.0, 1.0 - front[0] * wall.inward[0] - front[1] * wall.inward[1])
        return math.hypot(beyond, depth) + 0.5 * turned, wall.index

    return min(map(gap, walls))[1]
