"""How plants are made: many leaves and stems at once, gathered in clumps, fitted to a box; and pots."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval

OVAL = (0.12, 0.8, 1.0, 0.72, 0.04)
BROAD = (0.3, 0.95, 1.0, 0.6, 0.03)
SMALL = (0.15, 1.0, 0.05)


@cache
def _pattern(n: int, m: int) -> np.ndarray:
    grid = np.stack(np.meshgrid(np.arange(n), np.arange(m), [0], indexing="ij"), axis=-1)[:, :, 0].astype(float)
    return shapes.sheet(grid, 0.1)[1]


def leaves(
    base, yaw, rise, bend, length, width, outline=OVAL, fold: float = 0.25, thickness: float = 0.0016, rib: bool = True
) -> tuple[np.ndarray, np.ndarray]:
    """Many leaves: from points ``base`` [L, 3], turned by ``yaw``, rising at ``rise``, bending down by ``bend`` [rad].

    The other figures are one number or [L]. Returns vertices [L, V, 3] and the faces of one leaf.
    """
    base = np.asarray(base, dtype=np.float64)
    count = len(base)
    yaw, rise, bend, length, width = (
        np.broadcast_to(np.asarray(v, float), count) for v in (yaw, rise, bend, length, width)
    )
    n = len(outline)
    t = np.linspace(0, 1, n)
    middle = rise[:, None] - bend[:, None] * (t[:-1] + t[1:]) / 2
    step = (length / (n - 1))[:, None]
    r = np.concatenate([np.zeros((count, 1)), np.cumsum(np.cos(middle) * step, axis=1)], axis=1)
    z = np.concatenate([np.zeros((count, 1)), np.cumsum(np.sin(middle) * step, axis=1)], axis=1)
    at = rise[:, None] - bend[:, None] * t
    normal_r, normal_z = -np.sin(at), np.cos(at)
    across = np.array([-1.0, 0.0, 1.0]) if rib else np.array([-1.0, 1.0])
    side = width[:, None, None] / 2 * np.asarray(outline)[None, :, None] * across
    up = fold * np.abs(side) if rib else np.zeros_like(side)
    layers = []
    for half in (thickness / 2, -thickness / 2):
        lift = up + half
        rr = r[:, :, None] + lift * normal_r[:, :, None]
        zz = z[:, :, None] + lift * normal_z[:, :, None]
        c, s = np.cos(yaw)[:, None, None], np.sin(yaw)[:, None, None]
        points = np.stack([rr * c - side * s, rr * s + side * c, zz], axis=-1)
        layers.append(points.reshape(count, -1, 3))
    return np.concatenate(layers, axis=1) + base[:, None], _pattern(n, len(across))


def fronds(
    base,
    yaw,
    rise,
    bend,
    length,
    leaflet: float,
    pairs: int,
    width: float,
    thickness: float = 0.0016,
    taper: float = 0.75,
) -> list[tuple[np.ndarray, np.ndarray]]:
    """Feathered leaves: of each frond the rib and two rows of leaflets, as vertices [k, V, 3] and faces."""
    base = np.asarray(base, dtype=np.float64)
    count = len(base)
    yaw, rise, bend, length = (np.broadcast_to(np.asarray(v, float), count) for v in (yaw, rise, bend, length))
    found = []
    t = np.linspace(0.12, 1.0, pairs)
    fine = np.linspace(0, 1, 25)
    for k in range(count):
        angle = rise[k] - bend[k] * fine
        r = np.concatenate([[0], np.cumsum(np.cos(angle[:-1]) / 24)]) * length[k]
        z = np.concatenate([[0], np.cumsum(np.sin(angle[:-1]) / 24)]) * length[k]
        pr, pz, at = np.interp(t, fine, r), np.interp(t, fine, z), np.interp(t, fine, angle)
        points = base[k] + np.c_[pr * np.cos(yaw[k]), pr * np.sin(yaw[k]), pz]
        long = leaflet * length[k] * np.sin(np.pi * (0.15 + 0.85 * t)) ** 0.6 * (1 - taper * t * t) + 0.02
        for sign in (-1, 1):
            # Leaflets point outward and forward, and follow the rib's rise a little.
            found.append(
                leaves(
                    points,
                    yaw[k] + sign * (1.15 - 0.75 * t),
                    0.5 * at - 0.1,
                    0.5,
                    long,
                    width,
                    SMALL,
                    0.0,
                    thickness,
                    rib=False,
                )
            )
        found.append(
            leaves(
                base[k : k + 1],
                yaw[k],
                rise[k],
                bend[k],
                length[k],
                0.008,
                (1, 1, 0.9, 0.8, 0.6, 0.4),
                0.0,
                0.006,
                rib=False,
            )
        )
    return found


class Clumps:
    """Leaves and stems gathered in clumps, each with one convex part, drawn together to fill a box."""

    def __init__(self) -> None:
        self._pieces: list[tuple[np.ndarray, np.ndarray, Material | str, int]] = []

    def add(self, made: tuple[np.ndarray, np.ndarray], material: Material | str, clump) -> None:
        """Leaves [L, V, 3] with their faces; ``clump`` is a number or one for each leaf."""
        points, faces = made
        clump = np.broadcast_to(np.asarray(clump, int), len(points))
        for c in np.unique(clump):
            mine = points[clump == c]
            offsets = np.arange(len(mine)) * mine.shape[1]
            self._pieces.append(
                (mine.reshape(-1, 3), (faces[None] + offsets[:, None, None]).reshape(-1, 3), material, int(c))
            )

    def shape(self, made: tuple[np.ndarray, np.ndarray], material: Material | str, clump: int) -> None:
        """A closed shape, such as a stem or a fruit."""
        self._pieces.append((made[0], made[1], material, clump))

    def draw(self, b: Builder, x: Interval | None = None, y: Interval | None = None, z: Interval | None = None) -> None:
        """All pieces, moved and scaled so that they fill these ends (None leaves an axis alone); a hull per clump."""
        everything = np.concatenate([p for p, *_ in self._pieces])
        low, high = everything.min(axis=0), everything.max(axis=0)
        scale, shift = np.ones(3), np.zeros(3)
        for k, ends in enumerate((x, y, z)):
            if ends is not None:
                scale[k] = (ends[1] - ends[0]) / (high[k] - low[k])
                shift[k] = ends[0] - low[k] * scale[k]
        clumps: dict[int, list[np.ndarray]] = {}
        for points, _, _, clump in self._pieces:
            clumps.setdefault(clump, []).append(points * scale + shift)
        done = set()
        for points, faces, material, clump in self._pieces:
            first = clump not in done
            done.add(clump)
            hulls = [shapes.hull(np.concatenate(clumps[clump]))] if first else []
            b.add((points * scale + shift, faces.astype(np.int32)), material, hulls)


def sectors(yaw: np.ndarray, count: int = 6) -> np.ndarray:
    """The clump of each leaf by the direction in which it points."""
    return (np.mod(yaw, 2 * np.pi) / (2 * np.pi) * count).astype(int) % count


def randoms(b: Builder, name: str = "leaves") -> np.random.Generator:
    """Random numbers for what is too many to be drawn by name."""
    return np.random.default_rng(b.whole(name, 0, 2**31 - 1))


def pot(b: Builder, radius: float, h: float, role: str = "pot", styles=("taper", "belly", "cube", "rim")) -> float:
    """A pot about the z axis with soil in it; returns the height of the soil. One prism "pot"."""
    look = b.material(
        role,
        "terracotta",
        "white ceramic",
        "grey ceramic",
        "concrete",
        "blue ceramic",
        "cream ceramic",
        "black paint",
        "rattan",
        "sage paint",
    )
    style = b.pick(f"{role} style", styles)
    soil = h - max(0.006, 0.06 * h)
    wall = max(0.004, 0.05 * radius)
    with b.solid("pot"):
        if style == "cube":
            k = radius * 0.94
            b.box((-k, k), (-k, k), (0.0, soil - 0.001), look, bevel=0.004)
            for s in (-1, 1):
                b.box(*_ends(s * (k - wall), s * k), (-k, k), (soil - 0.01, h), look, bevel=0.001)
                b.box((-k + wall, k - wall), *_ends(s * (k - wall), s * k), (soil - 0.01, h), look, bevel=0.001)
            b.box((-k + wall, k - wall), (-k + wall, k - wall), (soil - 0.005, soil), "soil", bevel=0.0)
            return soil
        if style == "belly":
            outer = [(0.62, 0.0), (0.68, 0.02), (0.92, 0.25), (1.0, 0.48), (0.98, 0.68), (0.86, 0.9), (0.84, 1.0)]
        elif style == "rim":
            outer = [(0.66, 0.0), (0.9, 0.76), (0.9001, 0.78), (1.0, 0.785), (1.0, 1.0)]
        else:
            outer = [(0.72, 0.0), (0.75, 0.02), (0.98, 0.97), (0.98, 1.0)]
        profile = [(radius * r, h * z) for r, z in outer]
        inside = profile[-1][0] - wall
        b.lathe([*profile, (inside, h), (inside * 0.97, soil)], look, 28, hollow=True)
        b.add(shapes.frustum(inside, inside, (soil - 0.01, soil + 0.001), 28), "soil", hulls=[])
    return soil


def _ends(a: float, b: float) -> tuple[Interval]:
    return ((min(a, b), max(a, b)),)


def stem(path, radius, segments: int = 6) -> tuple[np.ndarray, np.ndarray]:
    """A stem along points, thinner toward its tip."""
    path = np.asarray(path, dtype=np.float64)
    points, faces = shapes.sweep(path, 1.0, segments)
    rings = points.reshape(len(path), segments, 3)
    size = np.linspace(radius, radius * 0.6, len(path))[:, None, None]
    middle = path[:, None, :]
    return (middle + (rings - middle) * size).reshape(-1, 3), faces


def crown_points(rng: np.random.Generator, count: int, flat: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    """Points spread evenly over and in a ball of radius 1, and their directions."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 1.85 * k / count), math.pi * (1 + 5**0.5) * k
    way = np.c_[np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar) * flat]
    return way * rng.uniform(0.45, 1.0, (count, 1)) ** 0.5, turn
