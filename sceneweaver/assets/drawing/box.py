"""Boxes: the places that parts of a drawing fill, and how one is found from another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

Interval = tuple[float, float]
Vec3 = tuple[float, float, float]
Axis = Literal["x", "y", "z"]

_SIDES: dict[str, tuple[Axis, int]] = {
    "back": ("x", 0),
    "front": ("x", 1),
    "right": ("y", 0),
    "left": ("y", 1),
    "bottom": ("z", 0),
    "top": ("z", 1),
}


@dataclass(frozen=True)
class Box:
    """A place along the axes [m]: x from back to front, y from right to left, z from bottom to top.

    Everything that finds another box from it returns a new one.

    Examples:
        >>> case = Box.sized(0.4, 1.0, 0.8)
        >>> case.top(0.02).z
        (0.78, 0.8)
        >>> [round(door.width, 3) for door in case.columns(2, gap=0.004)]
        [0.498, 0.498]
        >>> case.anchor("top front left")
        (0.2, 0.5, 0.8)
    """

    x: Interval
    y: Interval
    z: Interval

    @classmethod
    def sized(cls, depth: float, width: float, height: float, at: Vec3 = (0.0, 0.0, 0.0)) -> Box:
        """A box of a size that stands centred on a point."""
        x, y, z = at
        return cls((x - depth / 2, x + depth / 2), (y - width / 2, y + width / 2), (z, z + height))

    @classmethod
    def around(cls, point: Vec3, depth: float, width: float, height: float) -> Box:
        """A box of a size with its middle at a point."""
        x, y, z = point
        return cls.sized(depth, width, height, (x, y, z - height / 2))

    @property
    def depth(self) -> float:
        """Extent along x [m]."""
        return self.x[1] - self.x[0]

    @property
    def width(self) -> float:
        """Extent along y [m]."""
        return self.y[1] - self.y[0]

    @property
    def height(self) -> float:
        """Extent along z [m]."""
        return self.z[1] - self.z[0]

    @property
    def size(self) -> Vec3:
        """Depth, width, height [m]."""
        return self.depth, self.width, self.height

    @property
    def center(self) -> Vec3:
        """The middle."""
        return sum(self.x) / 2, sum(self.y) / 2, sum(self.z) / 2

    # Slabs at its sides

    def top(self, thick: float) -> Box:
        """The slab of that thickness under its top; a negative one lies on top of it, outside. So for all sides."""
        return self._slab("top", thick)

    def bottom(self, thick: float) -> Box:
        """The slab at its bottom; negative: below it."""
        return self._slab("bottom", thick)

    def front(self, thick: float) -> Box:
        """The slab at its front; negative: before it."""
        return self._slab("front", thick)

    def back(self, thick: float) -> Box:
        """The slab at its back; negative: behind it."""
        return self._slab("back", thick)

    def left(self, thick: float) -> Box:
        """The slab at its left; negative: beside it."""
        return self._slab("left", thick)

    def right(self, thick: float) -> Box:
        """The slab at its right; negative: beside it."""
        return self._slab("right", thick)

    def _slab(self, side: str, thick: float) -> Box:
        axis, end = _SIDES[side]
        face = getattr(self, axis)[end]
        other = face - thick if end else face + thick
        return replace(self, **{axis: (min(face, other), max(face, other))})

    def walls(self, thick: float) -> list[Box]:
        """The slabs at its front and back, and those at its left and right between them."""
        inner = self.inset(x=thick)
        return [self.front(thick), self.back(thick), inner.left(thick), inner.right(thick)]

    # Smaller, larger, elsewhere

    def inset(
        self,
        all: float = 0.0,  # noqa: A002  (it reads as a word in a drawing: ``seat.inset(all=0.01)``)
        *,
        x: float = 0.0,
        y: float = 0.0,
        z: float = 0.0,
        front: float = 0.0,
        back: float = 0.0,
        left: float = 0.0,
        right: float = 0.0,
        top: float = 0.0,
        bottom: float = 0.0,
    ) -> Box:
        """Moved in by so much on all sides, on both of an axis, or on one; negative: out."""
        return Box(
            (self.x[0] + all + x + back, self.x[1] - all - x - front),
            (self.y[0] + all + y + right, self.y[1] - all - y - left),
            (self.z[0] + all + z + bottom, self.z[1] - all - z - top),
        )

    def move(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Box:
        """The same box elsewhere."""
        return Box(*((a + by, b + by) for (a, b), by in zip((self.x, self.y, self.z), (x, y, z), strict=True)))

    def to(self, x: Interval | None = None, y: Interval | None = None, z: Interval | None = None) -> Box:
        """With other intervals on some axes."""
        return Box(x or self.x, y or self.y, z or self.z)

    def share(self, x: Interval = (0.0, 1.0), y: Interval = (0.0, 1.0), z: Interval = (0.0, 1.0)) -> Box:
        """A part of it by shares of its extents: ``share(z=(0.5, 1))`` is its upper half."""
        spans = zip((self.x, self.y, self.z), (x, y, z), strict=True)
        return Box(*((a + s * (b - a), a + t * (b - a)) for (a, b), (s, t) in spans))

    def place(
        self, depth: float | None = None, width: float | None = None, height: float | None = None, at: str = ""
    ) -> Box:
        """A box of a size inside at an anchor, as ``place(0.1, 0.1, at="front left")``; None keeps an extent."""
        spans = []
        for axis, size in (("x", depth), ("y", width), ("z", height)):
            low, high = getattr(self, axis)
            if size is not None:
                end = next((e for word in at.split() for a, e in [_SIDES[word]] if a == axis), None)
                low = (low + high - size) / 2 if end is None else low if end == 0 else high - size
                high = low + size
            spans.append((low, high))
        return Box(*spans)

    def anchor(self, words: str = "") -> Vec3:
        """A point by words such as "top front left"; in the middle of an axis that no word names."""
        point = list(self.center)
        for word in words.split():
            axis, end = _SIDES[word]
            point["xyz".index(axis)] = getattr(self, axis)[end]
        x, y, z = point
        return x, y, z

    def point(self, x: float = 0.5, y: float = 0.5, z: float = 0.5) -> Vec3:
        """A point by shares of its extents: (0, 0, 0) is its back right bottom corner."""
        at = (span[0] + s * (span[1] - span[0]) for span, s in zip((self.x, self.y, self.z), (x, y, z), strict=True))
        px, py, pz = at
        return px, py, pz

    def __or__(self, other: Box) -> Box:
        """The smallest box that holds both."""
        spans = zip((self.x, self.y, self.z), (other.x, other.y, other.z), strict=True)
        return Box(*((min(a[0], b[0]), max(a[1], b[1])) for a, b in spans))

    # Parts beside each other

    def split(self, axis: Axis, parts: int | Sequence[float], gap: float = 0.0) -> list[Box]:
        """Equal parts along an axis, or parts of these weights, with gaps between them; from its lower end on."""
        weights = [1.0] * parts if isinstance(parts, int) else list(parts)
        low, high = getattr(self, axis)
        unit = (high - low - gap * (len(weights) - 1)) / sum(weights)
        found = []
        for weight in weights:
            found.append(replace(self, **{axis: (low, low + weight * unit)}))
            low += weight * unit + gap
        return found

    def columns(self, parts: int | Sequence[float], gap: float = 0.0) -> list[Box]:
        """Parts beside each other, from right to left."""
        return self.split("y", parts, gap)

    def rows(self, parts: int | Sequence[float], gap: float = 0.0) -> list[Box]:
        """Parts on top of each other, from the bottom up."""
        return self.split("z", parts, gap)
