"""Leaves of doors: quarters of a disc along the axes, compared exactly in whole millimetres."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .regions import Box, Point


@dataclass(frozen=True)
class Quarter:
    """What a leaf sweeps: |p - hinge| <= radius where (p - hinge) * way >= 0 on both axes; ``way`` is of +-1."""

    hinge: Point
    radius: int
    way: Point

    @property
    def box(self) -> Box:
        """The square around it."""
        (x, y), r, (dx, dy) = self.hinge, self.radius, self.way
        return min(x, x + dx * r), min(y, y + dy * r), max(x, x + dx * r), max(y, y + dy * r)

    def meets_box(self, box: Box) -> bool:
        """Whether its inside meets the inside of a box: the nearest corner of what they could share is near enough."""
        own = self.box
        x0, y0, x1, y1 = max(own[0], box[0]), max(own[1], box[1]), min(own[2], box[2]), min(own[3], box[3])
        if x0 >= x1 or y0 >= y1:
            return False
        dx = min(abs(x0 - self.hinge[0]), abs(x1 - self.hinge[0]))
        dy = min(abs(y0 - self.hinge[1]), abs(y1 - self.hinge[1]))
        return dx * dx + dy * dy < self.radius * self.radius

    def meets_any(self, boxes: Iterable[Box]) -> bool:
        """Whether its inside meets the inside of one of the boxes."""
        return any(self.meets_box(box) for box in boxes)

    def meets(self, other: Quarter) -> bool:
        """Whether the insides of two quarters meet.

        Both are convex, so they do where this one, cut to the box of the other, has an inside, and its point that is
        nearest to the other's hinge is less than the other's radius away from it.
        """
        a, b = self.box, other.box
        x0, y0, x1, y1 = max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])
        if not self.meets_box((x0, y0, x1, y1)):
            return False
        hx, hy = other.hinge
        # Nearest point of the shared box to the other's hinge. If this disc holds it in its inside, that is all.
        qx, qy = min(max(hx, x0), x1), min(max(hy, y0), y1)
        if self._squared(qx, qy) <= self.radius**2:
            return (qx - hx) ** 2 + (qy - hy) ** 2 < other.radius**2
        # Else it lies on the arc: at an end of the arc within the shared box, or on the line of both hinges.
        return self._arc_within((x0, y0, x1, y1), other)

    def _arc_within(self, box: Box, other: Quarter) -> bool:
        x0, y0, x1, y1 = box
        (cx, cy), (hx, hy), r, s = self.hinge, other.hinge, self.radius, other.radius
        # Ends of the arc in the box: where it crosses a side. On x = X its y is cy +- sqrt(r2 - (X - cx)2).
        for value in (x0, x1):
            rest = r * r - (value - cx) ** 2
            if rest >= 0 and _between(cy, self.way[1], rest, y0, y1):
                left = s * s - (value - hx) ** 2
                if left > 0 and _nearer(cy - hy, self.way[1], rest, left):
                    return True
        for value in (y0, y1):
            rest = r * r - (value - cy) ** 2
            if rest >= 0 and _between(cx, self.way[0], rest, x0, x1):
                left = s * s - (value - hy) ** 2
                if left > 0 and _nearer(cx - hx, self.way[0], rest, left):
                    return True
        # On the line of the hinges: the point c + r (h - c) / |h - c| in the box, | |h - c| - r | away from h.
        dx, dy = hx - cx, hy - cy
        squared = dx * dx + dy * dy
        if squared == 0 or squared >= (r + s) ** 2 or (r > s and squared <= (r - s) ** 2):
            return False
        return _scaled_within(r, dx, squared, x0 - cx, x1 - cx) and _scaled_within(r, dy, squared, y0 - cy, y1 - cy)

    def _squared(self, x: int, y: int) -> int:
        return (x - self.hinge[0]) ** 2 + (y - self.hinge[1]) ** 2


def _between(start: int, way: int, squared: int, low: int, high: int) -> bool:
    """Whether low <= start + way * sqrt(squared) <= high."""
    low, high = (low - start, high - start) if way > 0 else (start - high, start - low)
    above = low <= 0 or low * low <= squared
    return above and high >= 0 and squared <= high * high


def _nearer(gap: int, way: int, squared: int, left: int) -> bool:
    """Whether (gap + way * sqrt(squared))**2 < left: gap2 + squared - left < -2 * gap * way * sqrt(squared)."""
    a, b = gap * gap + squared - left, -2 * gap * way
    return _less_than_root(a, b, squared)


def _less_than_root(a: int, b: int, squared: int) -> bool:
    """Whether a < b * sqrt(squared)."""
    if b >= 0:
        return a < 0 or a * a < b * b * squared
    return a < 0 and a * a > b * b * squared


def _scaled_within(r: int, d: int, squared: int, low: int, high: int) -> bool:
    """Whether low <= r * d / sqrt(squared) <= high."""
    value = r * d

    def at_most(bound: int) -> bool:  # value <= bound * sqrt(squared)
        return _less_than_root(value, bound, squared) or (
            (value >= 0) == (bound >= 0) and value * value == bound * bound * squared
        )

    def at_least(bound: int) -> bool:
        return _less_than_root(-value, -bound, squared) or (
            (value >= 0) == (bound >= 0) and value * value == bound * bound * squared
        )

    return at_least(low) and at_most(high)
