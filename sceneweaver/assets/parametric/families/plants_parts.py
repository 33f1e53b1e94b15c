"""How plants are made: many leaves and stems at once, gathered in clumps, fitted to a box; and pots."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look
from ...shapes.convex import Shape

OVAL = (0.12, 0.8, 1.0, 0.72, 0.04)
BROAD = (0.3, 0.95, 1.0, 0.6, 0.03)
SMALL = (0.15, 1.0, 0.05)
GOLDEN = 2.399
"""The golden angle [rad]: leaves that follow each other at it never lie over one another."""

Leaves = tuple[np.ndarray, np.ndarray]  # vertices [L, V, 3] of each leaf, and the faces of one


@cache
def _pattern(n: int, m: int) -> np.ndarray:
    grid = np.stack(np.meshgrid(np.arange(n), np.arange(m), [0], indexing="ij"), axis=-1)[:, :, 0].astype(float)
    return shapes.sheet(grid, 0.1)[1]


def leaves(
    base, yaw, rise, bend, length, width, outline=OVAL, fold: float = 0.25, thickness: float = 0.0016, rib: bool = True
) -> Leaves:
    """Many leaves.

    Args:
        base: Points [L, 3] where they begin.
        yaw: Where each points [rad]; this and the next four are one number or [L].
        rise: The angle above the horizon at which it begins [rad].
        bend: How far it bends down to its tip [rad].
        length: Along it [m].
        width: Across it, where it is widest [m].
        outline: Widths from its foot to its tip, as shares.
        fold: How steeply its halves rise from the rib.
        thickness: Of a leaf [m].
        rib: Whether it is folded along a rib at all.

    Returns:
        Vertices [L, V, 3] and the faces of one leaf.
    """
    base = np.asarray(base, dtype=np.float64)
    count, n = len(base), len(outline)
    figures = (yaw, rise, bend, length, width)
    yaw, rise, bend, length, width = (np.broadcast_to(np.asarray(v, float), count) for v in figures)
    t = np.linspace(0, 1, n)
    middle = rise[:, None] - bend[:, None] * (t[:-1] + t[1:]) / 2
    step, start = (length / (n - 1))[:, None], np.zeros((count, 1))
    r = np.concatenate([start, np.cumsum(np.cos(middle) * step, axis=1)], axis=1)
    z = np.concatenate([start, np.cumsum(np.sin(middle) * step, axis=1)], axis=1)
    at = (rise[:, None] - bend[:, None] * t)[:, :, None]
    across = np.array([-1.0, 0.0, 1.0]) if rib else np.array([-1.0, 1.0])
    side = width[:, None, None] / 2 * np.asarray(outline)[None, :, None] * across
    up = fold * np.abs(side) if rib else np.zeros_like(side)
    c, s = np.cos(yaw)[:, None, None], np.sin(yaw)[:, None, None]
    layers = []
    for lift in (up + thickness / 2, up - thickness / 2):
        rr, zz = r[:, :, None] - lift * np.sin(at), z[:, :, None] + lift * np.cos(at)
        layers.append(np.stack([rr * c - side * s, rr * s + side * c, zz], axis=-1).reshape(count, -1, 3))
    return np.concatenate(layers, axis=1) + base[:, None], _pattern(n, len(across))


def frond(
    base, yaw: float, rise: float, bend: float, length: float, leaflet: float, pairs: int, width: float
) -> list[Leaves]:
    """A feathered leaf: its rib and two rows of leaflets, ``leaflet`` of its length long and ``width`` wide [m]."""
    t, fine = np.linspace(0.12, 1.0, pairs), np.linspace(0, 1, 25)
    angle = rise - bend * fine
    r = np.concatenate([[0], np.cumsum(np.cos(angle[:-1]) / 24)]) * length
    z = np.concatenate([[0], np.cumsum(np.sin(angle[:-1]) / 24)]) * length
    reach, high, at = np.interp(t, fine, r), np.interp(t, fine, z), np.interp(t, fine, angle)
    points = np.asarray(base) + np.c_[reach * math.cos(yaw), reach * math.sin(yaw), high]
    long = leaflet * length * np.sin(np.pi * (0.15 + 0.85 * t)) ** 0.6 * (1 - 0.75 * t * t) + 0.02
    # Leaflets point outward and forward, and follow the rib's rise a little.
    turns, at, long = np.r_[0.75 * t - 1.15, 1.15 - 0.75 * t], np.r_[at, at], np.r_[long, long]
    rows = leaves(np.r_[points, points], yaw + turns, 0.5 * at - 0.1, 0.5, long, width, SMALL, 0.0, rib=False)
    outline = (1, 1, 0.9, 0.8, 0.6, 0.4)
    return [rows, leaves([base], yaw, rise, bend, length, 0.008, outline, 0.0, 0.006, rib=False)]


def stem(path, radius: float, segments: int = 6) -> Shape:
    """A stem along points, thinner toward its tip."""
    path = np.asarray(path, dtype=np.float64)
    points, faces = shapes.sweep(path, 1.0, segments)
    middle, size = path[:, None, :], np.linspace(radius, radius * 0.6, len(path))[:, None, None]
    return (middle + (points.reshape(len(path), segments, 3) - middle) * size).reshape(-1, 3), faces


class Foliage:
    """Leaves and stems gathered in clumps, each with one convex part, drawn together to fill a box.

    ``rng`` gives random numbers for what is too many to be drawn by name.
    """

    def __init__(self, d: Drawing) -> None:
        self.d = d
        self.rng = np.random.default_rng(d.integer("leaves", 0, 2**31 - 1))
        self._pieces: list[tuple[np.ndarray, np.ndarray, Look, int]] = []

    def add(self, made: Leaves, material: Look, clump, only: np.ndarray | None = None) -> None:
        """Leaves, or those of them that a mask [L] takes; ``clump`` is a number or one for each leaf."""
        points, faces = made
        clump = np.broadcast_to(np.asarray(clump, int), len(points))
        for c in np.unique(clump):
            mine = points[(clump == c) if only is None else (clump == c) & only]
            offsets = (np.arange(len(mine)) * mine.shape[1])[:, None, None]
            if len(mine):
                self._pieces.append((mine.reshape(-1, 3), (faces[None] + offsets).reshape(-1, 3), material, int(c)))

    def shape(self, made: Shape, material: Look, clump: int) -> None:
        """A closed shape, such as a stem or a fruit."""
        self._pieces.append((*made, material, clump))

    def draw(self, z: tuple[float, float], reach: Box | None = None, part: str = "crown") -> None:
        """All pieces, stretched to fill the bounds of the drawing, or a box in plan, between two heights."""
        box = (reach or self.d.bounds).to(z=z)
        everything = np.concatenate([p for p, *_ in self._pieces])
        low, size = everything.min(axis=0), np.ptp(everything, axis=0)
        start = np.array([box.x[0], box.y[0], box.z[0]])
        clumps: dict[int, list[np.ndarray]] = {}
        placed = []
        for points, faces, material, clump in self._pieces:
            points = start + (points - low) / size * np.array(box.size)
            clumps.setdefault(clump, []).append(points)
            placed.append((points, faces.astype(np.int32), material, clump))
        with self.d.part(part):
            for points, faces, material, clump in placed:
                own = clumps.pop(clump, None)
                self.d.add((points, faces), material, [shapes.hull(np.concatenate(own))] if own else [])


def sectors(yaw, count: int = 6) -> np.ndarray:
    """The clump of each leaf by the direction in which it points."""
    return (np.mod(yaw, 2 * np.pi) / (2 * np.pi) * count).astype(int) % count


def around(yaw, radius, z) -> np.ndarray:
    """Points [L, 3] around the z axis."""
    return np.c_[radius * np.cos(yaw), radius * np.sin(yaw), np.broadcast_to(z, np.shape(yaw))]


def crown_points(rng: np.random.Generator, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Points spread evenly over and in a ball of radius 1, and their directions."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 1.85 * k / count), math.pi * (1 + 5**0.5) * k
    way = np.c_[np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)]
    return way * rng.uniform(0.45, 1.0, (count, 1)) ** 0.5, turn


_GLAZES = "terracotta, white ceramic, grey ceramic, concrete, blue ceramic, cream ceramic, black paint, rattan"
_POTS = {
    "belly": [(0.62, 0.0), (0.68, 0.02), (0.92, 0.25), (1.0, 0.48), (0.98, 0.68), (0.86, 0.9), (0.84, 1.0)],
    "rim": [(0.66, 0.0), (0.9, 0.76), (0.9001, 0.78), (1.0, 0.785), (1.0, 1.0)],
    "taper": [(0.72, 0.0), (0.75, 0.02), (0.98, 0.97), (0.98, 1.0)],
}
"""Profiles of pots: radii and heights, as shares."""


def pot(d: Drawing, radius: float, h: float, styles: Sequence[str] = ("taper", "belly", "cube", "rim")) -> float:
    """A pot about the z axis with soil in it, one part; returns the height of the soil."""
    look, style = d.material("pot", _GLAZES), d.pick("pot style", styles)
    soil, wall = h - max(0.006, 0.06 * h), max(0.004, 0.05 * radius)
    with d.part("pot"):
        if style == "cube":
            box = Box.sized(1.88 * radius, 1.88 * radius, h)
            d.box(box.to(z=(0.0, soil - 0.001)), look, bevel=0.004)
            rim = box.to(z=(soil - 0.01, h))
            for side in (rim.front(wall), rim.back(wall), rim.left(wall).inset(x=wall), rim.right(wall).inset(x=wall)):
                d.box(side, look, bevel=0.001)
            d.box(box.to(z=(soil - 0.005, soil)).inset(x=wall, y=wall), "soil", bevel=0.0)
            return soil
        profile = [(radius * r, h * z) for r, z in _POTS[style]]
        inside = profile[-1][0] - wall
        d.revolve([*profile, (inside, h), (inside * 0.97, soil)], look, 28, hollow=True)
        d.add(shapes.frustum(inside, inside, (soil - 0.01, soil + 0.001), 28), "soil", [])
    return soil
