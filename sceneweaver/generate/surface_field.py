"""The mechanism by which all surfaces are laid: candidates of places, tried in order against the free space.

What stands on furniture comes from three sources: the slots of an arrangement, the rows of a theme and the relations
that a request states. Each says what stands together and where it would best be; a `Field` finds the first place that
is inside the surface and clear of what is there, for many candidates at once.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.polygons import counter_clockwise, normals
from sceneweaver.geometry.se2 import SE2

Array = NDArray[np.float64]

LEAST = 1e-8
"""Area [m2] up to which a notch in a surface is none."""

GAP = 0.006
"""Free space [m] kept between things on one surface."""

EDGE = 0.004
"""Free space [m] kept to the edge of a surface."""

FIRST = 128
"""Candidates of a batch that are tested first, all at once."""


@dataclass(frozen=True, eq=False)
class Prism:
    """A convex polygon [n, 2], counter-clockwise, from ``low`` to ``high`` [m] above the surface."""

    polygon: Array
    low: float
    high: float

    def moved(self, x: float, y: float, yaw: float) -> Prism:
        """The prism turned by ``yaw`` [rad] about the origin, then moved [m]."""
        return Prism(turned(self.polygon, yaw) + (x, y), self.low, self.high)

    @cached_property
    def box(self) -> tuple[float, float, float, float]:
        """Bounds in the plane: x0, y0, x1, y1 [m]."""
        return (*self.polygon.min(axis=0).tolist(), *self.polygon.max(axis=0).tolist())

    @cached_property
    def normals(self) -> Array:
        """Outward unit normals of its edges [m, 2]."""
        return normals(self.polygon)

    @cached_property
    def reach(self) -> Array:
        """How far it reaches along its own normals [m]."""
        return (self.polygon @ self.normals.T).max(axis=0)

    def meets(self, box: tuple[float, float, float, float], other: Prism) -> bool:
        """Whether its bounds meet a box in the plane, and its heights those of another prism."""
        x0, y0, x1, y1 = self.box
        level = self.low < other.high - 1e-4 and self.high > other.low + 1e-4
        return level and x1 >= box[0] and y1 >= box[1] and x0 <= box[2] and y0 <= box[3]


class Turned(NamedTuple):
    """The prisms of a shape that is turned, all their corners [n, 2], and the least and largest x, y of these [m]."""

    prisms: tuple[Prism, ...]
    points: Array
    low: Array
    high: Array


@dataclass(frozen=True, eq=False)
class Shape:
    """What an object covers, in its own frame: prisms that stand on the surface; ``size`` is its box [m]."""

    prisms: tuple[Prism, ...]
    size: tuple[float, float, float]
    _turned: dict[float, Turned] = field(default_factory=dict, init=False, repr=False)

    def turned(self, yaw: float) -> Turned:
        """The shape turned by ``yaw`` [rad] about the origin."""
        found = self._turned.get(yaw)
        if found is None:
            prisms = tuple(Prism(turned(p.polygon, yaw), p.low, p.high) for p in self.prisms)
            points = np.concatenate([p.polygon for p in prisms])
            found = self._turned[yaw] = Turned(prisms, points, points.min(axis=0), points.max(axis=0))
        return found

    def extent(self, yaw: float) -> tuple[Array, Array]:
        """Least and largest x, y [m] about the origin when turned by ``yaw``."""
        placed = self.turned(yaw)
        return placed.low, placed.high

    @property
    def area(self) -> float:
        """Area [m2] of its box."""
        return self.size[0] * self.size[1]


@dataclass(frozen=True)
class Piece:
    """A shape turned by ``yaw`` [rad], at the place [2] about the origin of what it stands together with [m]."""

    shape: Shape
    yaw: float = 0.0
    at: Array = field(default_factory=lambda: np.zeros(2))

    @property
    def box(self) -> tuple[Array, Array]:
        """Least and largest corner [m] about that origin."""
        low, high = self.shape.extent(self.yaw)
        return low + self.at, high + self.at


def bounds(pieces: Iterable[Piece]) -> tuple[Array, Array]:
    """Least and largest corner [m] of pieces about their common origin."""
    low, high = zip(*(piece.box for piece in pieces), strict=True)
    return np.min(low, axis=0), np.max(high, axis=0)


def turned(points: Array, yaw: float) -> Array:
    """Points [n, 2] turned by ``yaw`` [rad] about the origin."""
    return points if yaw == 0.0 else SE2(yaw=yaw).to_world(points)


@dataclass
class Field:
    """A surface to set things on: its polygon, and the prisms that are there already.

    ``polygon`` is simple, in the frame of the surface [m]; heights of prisms are above the surface, ``headroom`` [m] is
    the free height (infinite where open).
    """

    polygon: Array
    headroom: float = math.inf
    taken: list[Prism] = field(default_factory=list)
    edge: float = EDGE

    def __post_init__(self) -> None:
        import shapely

        outline = shapely.Polygon(self.polygon)
        inner: Any = outline.buffer(-self.edge, join_style="mitre")
        if inner.geom_type == "MultiPolygon":
            inner = max(inner.geoms, key=lambda g: g.area)
        inner = inner.simplify(5e-4) if len(self.polygon) > 12 and not inner.is_empty else inner
        self.empty = bool(inner.is_empty)
        self.area = float(outline.area)
        if self.empty:
            self.low = self.high = self.centre = np.zeros(2)
            return
        hull: Any = inner.convex_hull
        ring = counter_clockwise(np.asarray(hull.exterior.coords)[:-1])
        self._normals = normals(ring)
        self._limit = (ring @ self._normals.T).max(axis=0)
        notched = hull.area - inner.area > LEAST
        self._notches = [Prism(t, 0.0, 0.0) for t in _triangles(hull.difference(inner))] if notched else []
        self.low, self.high = ring.min(axis=0), ring.max(axis=0)
        self.centre = np.asarray(inner.centroid.coords[0])

    def free(self, shape: Shape, yaw: float, at: Array, gap: float = GAP) -> NDArray[np.bool_]:
        """Whether a shape turned by ``yaw`` [rad] may stand at each of the offsets ``at`` [k, 2]."""
        good = np.zeros(len(at), dtype=bool)
        if self.empty or shape.size[2] > self.headroom - 1e-3:
            return good
        placed = shape.turned(yaw)
        reach = (placed.points @ self._normals.T).max(axis=0)
        good = (at @ self._normals.T <= self._limit - reach).all(axis=1)
        if not good.any():
            return good
        first, last = (at[0], at[0]) if len(at) == 1 else (at.min(axis=0), at.max(axis=0))
        low, high = placed.low + first - gap, placed.high + last + gap
        box = (*low.tolist(), *high.tolist())
        left = np.flatnonzero(good)  # only these are looked at further
        ways = at[left].T
        for prism in placed.prisms:
            near = [(other, gap) for other in self.taken if other.meets(box, prism)]
            near += [(notch, 0.0) for notch in self._notches]
            along = prism.normals @ ways if near else ways
            for other, least in near:
                apart = _apart(prism, other, ways, along) >= least
                if not apart.all():
                    good[left[~apart]] = False
                    left, ways, along = left[apart], ways[:, apart], along[:, apart]
                if not len(left):
                    return good
        return good

    def put(self, piece: Piece, at: Sequence[float] | Array) -> None:
        """Take the space of a piece whose group has its origin at ``at`` [2]."""
        x, y = np.asarray(at, dtype=float) + piece.at
        self.taken.extend(p.moved(float(x), float(y), piece.yaw) for p in piece.shape.prisms)

    def place(self, pieces: Sequence[Piece], candidates: Iterable[Array], gap: float = GAP) -> Array | None:
        """The first candidate place [2] of a group of pieces at which all of them are free; None where none is.

        Args:
            pieces: what stands together, each about the origin of the group.
            candidates: batches [k, 2] of places of that origin, the best first; a batch is only made when those before
                it hold no free place.
            gap: free space [m] kept to what is there.
        """
        for batch in candidates:
            for part in _parts(batch):
                for piece in pieces:
                    part = part[self.free(piece.shape, piece.yaw, part + piece.at, gap)]
                    if not len(part):
                        break
                else:
                    return part[0]
        return None

    def near(self, goal: Sequence[float] | Array, reach: float) -> Iterator[Array]:
        """Candidates at a goal [2], then about it within ``reach`` [m] and on the way to the middle, nearest first."""
        target = np.asarray(goal, dtype=float)
        yield target[None]
        if reach > 0:
            way = np.linspace(0.1, 1, 10)[:, None] * self._in(target)
            spots = np.concatenate([target + _disc(round(reach, 2)), target + way])
            yield spots[np.argsort(np.hypot(*(spots - target).T), kind="stable")]

    def inside(self, shape: Shape, yaw: float, share: tuple[float, float]) -> Array:
        """The place [2] at ``share`` of depth (0 back, 1 front) and width (-1 to 1), kept in the surface's box."""
        low, high = shape.extent(yaw)
        least, most = self.low - low, self.high - high
        middle = (least + most) / 2
        least, most = np.minimum(least, middle), np.maximum(most, middle)
        part = np.array([share[0], (share[1] + 1) / 2])
        return least + np.clip(part, 0, 1) * (most - least) + np.array([1e-6, 0]) * (0.5 - part)

    def _in(self, goal: Array) -> Array:
        way = self.centre - goal
        length = float(np.hypot(*way))
        return way if length < 0.3 else way * (0.3 / length)


def _parts(batch: Array) -> Iterator[Array]:
    """A batch [k, 2] in parts, each twice as long as the one before: mostly the first ones hold a free place."""
    start, length = 0, FIRST
    while start < len(batch):
        yield batch[start : start + length]
        start, length = start + length, 2 * length


def _apart(a: Prism, b: Prism, ways: Array, along: Array) -> Array:
    """Largest separation [k] of ``a`` moved by each of the offsets ``ways`` [2, k] and ``b``, over the normals of both;
    ``along`` [m, k] are the offsets along those of ``a``."""
    one = ((a.polygon @ b.normals.T).min(axis=0) - b.reach)[:, None] + b.normals @ ways
    two = ((b.polygon @ a.normals.T).min(axis=0) - a.reach)[:, None] - along
    return np.maximum(one.max(axis=0), two.max(axis=0))


_DISCS: dict[float, Array] = {}


def _disc(radius: float) -> Array:
    """Offsets [k, 2] in rings about the origin, 2.5 cm apart."""
    if radius not in _DISCS:
        rings = np.arange(0.0125, radius + 1e-9, 0.025)
        angles = np.linspace(0, 2 * math.pi, 16, endpoint=False)
        _DISCS[radius] = np.concatenate(
            [np.zeros((1, 2)), *(r * np.column_stack([np.cos(angles), np.sin(angles)]) for r in rings)]
        )
    return _DISCS[radius]


def _triangles(region: Any) -> list[Array]:
    """Counter-clockwise triangles [3, 2] that make up a region (shapely)."""
    import shapely

    pieces = shapely.get_parts(shapely.constrained_delaunay_triangles(region))
    return [
        counter_clockwise(np.asarray(t.exterior.coords)[:-1])
        for t in pieces
        if t.geom_type == "Polygon" and t.area > LEAST
    ]
