"""From metres to pixels: the scale of a picture and where the room lies in it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.render.canvas import Point
from sceneweaver.render.shapes import Prism
from sceneweaver.scene import Room, Vec2


@dataclass(frozen=True)
class View:
    """A similarity from the plane in metres (y up) to pixels (y down)."""

    scale: float  # pixels a metre
    left: float  # x [m] of the picture's left edge
    top: float  # y [m] of the picture's upper edge

    def point(self, p: Vec2) -> Point:
        """The pixel of a point in metres."""
        return ((p[0] - self.left) * self.scale, (self.top - p[1]) * self.scale)

    def points(self, polygon: Iterable[Vec2]) -> list[Point]:
        """The pixels of several points."""
        return [self.point(p) for p in polygon]


@dataclass(frozen=True)
class Bounds:
    """An axis-aligned rectangle in metres."""

    x0: float
    y0: float
    x1: float
    y1: float

    @property
    def width(self) -> float:
        """Extent along x."""
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        """Extent along y."""
        return self.y1 - self.y0


def bounds_of(points: Sequence[Vec2]) -> Bounds:
    """The rectangle around some points."""
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return Bounds(min(xs), min(ys), max(xs), max(ys))


def content(room: Room, solids: Iterable[Prism]) -> Bounds:
    """What a picture shows: the room with its walls, and objects outside of it as long as they are near."""
    inner = bounds_of(room.outline)
    slack = max(1.5, 0.25 * max(inner.width, inner.height))
    x0, y0, x1, y1 = inner.x0, inner.y0, inner.x1, inner.y1
    for p in solids:
        b = bounds_of(p.polygon)
        x0, x1 = min(x0, max(b.x0, inner.x0 - slack)), max(x1, min(b.x1, inner.x1 + slack))
        y0, y1 = min(y0, max(b.y0, inner.y0 - slack)), max(y1, min(b.y1, inner.y1 + slack))
    for door in room.doors:
        if door.swing == "out":
            # An outward leaf needs room in the picture too.
            for px, py in room.walls[door.wall].strip(door.offset, door.width, 0.0, -door.width)[2:]:
                x0, x1, y0, y1 = min(x0, px), max(x1, px), min(y0, py), max(y1, py)
    t = WALL_THICKNESS
    return Bounds(x0 - t, y0 - t, x1 + t, y1 + t)


def step_for(scale: float, pixels: float) -> int:
    """The least of 1, 2, 5, 10, 20 ... metres that is at least ``pixels`` wide."""
    step = 1
    while step * scale < pixels:
        digit = str(step)[0]
        step = step * 5 // 2 if digit == "2" else step * 2
    return step
