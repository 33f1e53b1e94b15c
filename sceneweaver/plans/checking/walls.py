"""Walls of rooms and strips before them, in whole millimetres."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from .regions import Box, Point

if TYPE_CHECKING:
    from shapely import Polygon


def mm(value: float) -> int:
    """A length [m] in whole millimetres."""
    return round(value * 1000)


def metres(value: int) -> Fraction:
    """Millimetres as exact metres."""
    return Fraction(value, 1000)


def exact(value: float) -> Fraction:
    """A number as its shortest decimal says it, exactly."""
    return Fraction(repr(round(float(value), 9)))


@dataclass(frozen=True)
class Wall:
    """A wall of a room's outline: from ``start`` to ``end``, the room to the left of the way."""

    start: Point
    end: Point

    @property
    def straight(self) -> bool:
        """Whether it runs along x or y."""
        return self.start[0] == self.end[0] or self.start[1] == self.end[1]

    @cached_property
    def length(self) -> float:
        """[mm], a whole number where it is straight."""
        return math.dist(self.start, self.end)

    @property
    def along(self) -> tuple[float, float]:
        """Unit vector from start to end."""
        return (self.end[0] - self.start[0]) / self.length, (self.end[1] - self.start[1]) / self.length

    @property
    def outward(self) -> tuple[float, float]:
        """Unit vector out of the room."""
        x, y = self.along
        return y, -x

    def at(self, offset: float, out: float = 0.0) -> tuple[float, float]:
        """The point ``offset`` along the wall and ``out`` beyond its face."""
        (x, y), (nx, ny) = self.along, self.outward
        return self.start[0] + x * offset + nx * out, self.start[1] + y * offset + ny * out

    def strip(self, offset: int, width: int, near: int, far: int) -> Strip:
        """What lies ``near`` to ``far`` beyond the face over ``width`` from ``offset`` on."""
        corners = [self.at(offset, near), self.at(offset + width, near), self.at(offset + width, far)]
        return Strip((*corners, self.at(offset, far)))


@dataclass(frozen=True)
class Strip:
    """A rectangle, corners in order [mm]; along the axes they are whole numbers."""

    corners: tuple[tuple[float, float], ...]

    @cached_property
    def box(self) -> Box | None:
        """As a box where it lies along the axes."""
        xs, ys = sorted({round(x, 6) for x, _ in self.corners}), sorted({round(y, 6) for _, y in self.corners})
        if len(xs) != 2 or len(ys) != 2:
            return None
        return round(xs[0]), round(ys[0]), round(xs[1]), round(ys[1])

    def polygon(self) -> Polygon:
        """For what is oblique."""
        import shapely

        return shapely.Polygon(self.corners)
