"""Rooms that are unions of rectangles, cut into cells of one unit of furniture each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely

from sceneweaver.geometry.walls import Wall

Box = tuple[float, float, float, float]  # x0, y0, x1, y1 [m]

SHAPES: dict[str, tuple[Box, ...]] = {  # in units of the box around the room; the first one holds the origin
    "rectangle": ((0, 0, 1, 1),),
    "L": ((0, 0, 1, 0.5), (0, 0.5, 0.55, 1)),
    "T": ((0, 0, 1, 0.5), (0.28, 0.5, 0.72, 1)),
    "U": ((0, 0, 1, 0.45), (0, 0.45, 0.35, 1), (0.65, 0.45, 1, 1)),
    "S": ((0, 0, 0.65, 0.5), (0.35, 0.5, 1, 1)),
}
DOOR_WIDTH = 0.9  # [m], also the depth that its leaf needs
DOOR_OFFSET = 0.1
PORCH = 1.02  # [m] side of the square that is left to the door
MOST_ASPECT = 2.6
CUTS = 3  # that are looked at
FEW = 12  # units among which other cuts are tried where the first one does not do


class NoFit(Exception):
    """A unit does not fit into its cell; another draw may do."""


@dataclass(frozen=True)
class Cell:
    """A rectangle of floor. ``walls`` are the outward directions (0 east, 1 north, 2 west, 3 south) with a wall."""

    box: Box
    walls: tuple[int, ...] = ()

    def local(self, facing: int) -> tuple[float, float]:
        """Depth along a direction, and width [m]."""
        dx, dy = self.box[2] - self.box[0], self.box[3] - self.box[1]
        return (dx, dy) if facing % 2 == 0 else (dy, dx)

    def world(self, facing: int, u: float, v: float) -> tuple[float, float]:
        """The world point ``u`` from the back and ``v`` from the right-hand side, as seen along the direction."""
        x0, y0, x1, y1 = self.box
        return ((x0 + u, y0 + v), (x1 - v, y0 + u), (x1 - u, y1 - v), (x0 + v, y1 - u))[facing]


def rectangles(shape: str, area: float, aspect: float) -> list[Box]:
    """The rectangles of a room of some area [m2] and ratio of width to depth; the sides are rounded to 1 cm."""
    parts = SHAPES[shape]
    unit = sum((b[2] - b[0]) * (b[3] - b[1]) for b in parts)
    depth = math.sqrt(area / unit / aspect)
    xs, ys = depth * aspect, depth
    return [(round(a * xs, 2), round(b * ys, 2), round(c * xs, 2), round(d * ys, 2)) for a, b, c, d in parts]


def outline_of(boxes: Sequence[Box]) -> list[list[float]]:
    """The corners of a union of rectangles, counter-clockwise, the origin first."""
    union: Any = shapely.unary_union([shapely.box(*b) for b in boxes]).simplify(1e-6)
    corners = [[round(x, 4), round(y, 4)] for x, y in shapely.geometry.polygon.orient(union).exterior.coords[:-1]]
    first = corners.index([0.0, 0.0])
    return corners[first:] + corners[:first]


def cut(boxes: Sequence[Box], areas: Sequence[float], rng: np.random.Generator) -> list[Box]:
    """Cut rectangles into as many cells as there are ``areas``, in about their proportion and order.

    The first rectangle keeps the square of the door at the origin free.
    """
    free = _without_porch(boxes, sum(areas) / len(areas))
    sizes = np.array([(b[2] - b[0]) * (b[3] - b[1]) for b in free])
    ends = np.cumsum(sizes) / sizes.sum() * sum(areas)
    middles = np.cumsum(areas) - np.array(areas) / 2
    owner = np.searchsorted(ends, middles)
    found: list[Box] = []
    for k, box in enumerate(free):
        share = [a for a, o in zip(areas, owner, strict=True) if o == k]
        if share:
            found += split(box, share, rng)
    return found


def _without_porch(boxes: Sequence[Box], area: float) -> list[Box]:
    """The rectangles without the corner of the door; the strip beyond it is as wide as a cell of some area."""
    x0, y0, x1, y1 = boxes[0]
    if x1 - x0 < 2 * PORCH or y1 - y0 < PORCH + 0.5:
        raise NoFit("the room is too small for its door")
    strip = min(max(PORCH, 0.9 * math.sqrt(area)), (x1 - x0) / 2)
    return [(x0, y0 + PORCH, x0 + strip, y1), (x0 + strip, y0, x1, y1), *boxes[1:]]


def split(box: Box, areas: list[float], rng: np.random.Generator) -> list[Box]:
    """Guillotine cuts into cells that are as square as can be, with some chance."""
    x0, y0, x1, y1 = box
    if len(areas) == 1:
        if _aspect(box) > MOST_ASPECT:
            raise NoFit("a cell is too narrow")
        return [box]
    shares = np.cumsum(areas)[:-1] / sum(areas)
    nearest = np.argsort(np.abs(shares - rng.uniform(0.35, 0.65)), kind="stable")[:CUTS]
    cuts: list[tuple[float, int, Box, Box]] = []
    for k in nearest:
        x, y = x0 + (x1 - x0) * float(shares[k]), y0 + (y1 - y0) * float(shares[k])
        for one, two in (((x0, y0, x, y1), (x, y0, x1, y1)), ((x0, y0, x1, y), (x0, y, x1, y1))):
            leaves = max(_aspect(one) * (k == 0), _aspect(two) * (k == len(shares) - 1))
            if leaves <= MOST_ASPECT:
                worst = max(leaves, 0.6 * _aspect(one), 0.6 * _aspect(two), 1.5)
                cuts.append((worst * float(rng.uniform(1.0, 1.3)), int(k) + 1, one, two))
    for _, k, one, two in sorted(cuts)[: None if len(areas) <= FEW else 1]:
        try:
            return split(one, areas[:k], rng) + split(two, areas[k:], rng)
        except NoFit:
            continue
    raise NoFit("a cell is too narrow")


def _aspect(box: Box) -> float:
    dx, dy = box[2] - box[0], box[3] - box[1]
    return max(dx, dy) / max(min(dx, dy), 1e-9)


def with_walls(box: Box, walls: Sequence[Wall]) -> Cell:
    """The cell of a rectangle: which of its sides lie wholly on a wall."""
    x0, y0, x1, y1 = box
    sides = (((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0)), ((x0, y0), (x1, y0)))
    return Cell(box, tuple(k for k, side in enumerate(sides) if any(_on(wall, side) for wall in walls)))


def _on(wall: Wall, side: Any) -> bool:
    spans = [wall.coordinates(p) for p in side]
    return all(abs(d) < 1e-6 and -1e-6 <= s <= wall.length + 1e-6 for s, d in spans)
