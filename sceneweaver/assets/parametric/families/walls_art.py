"""Compositions of coloured shapes that look like art, and the frames around them."""

from __future__ import annotations

import math

import numpy as np
import shapely

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval

_SCHEMES = (
    ("sand pigment", "terracotta pigment", "ochre pigment", "blush pigment", "night pigment"),
    ("chalk pigment", "sea pigment", "sky pigment", "sand pigment", "night pigment"),
    ("chalk pigment", "moss pigment", "forest pigment", "ochre pigment", "blush pigment"),
    ("blush pigment", "plum pigment", "terracotta pigment", "chalk pigment", "ink pigment"),
    ("chalk pigment", "ink pigment", "ochre pigment", "sea pigment", "terracotta pigment"),
    ("sky pigment", "forest pigment", "moss pigment", "chalk pigment", "sea pigment"),
)
KINDS = ("hills", "blocks", "circles", "arches", "sea", "leaves", "waves")


def panel(b: Builder, polygon, x: Interval, material: Material | str) -> None:
    """A polygon (y to the right, z up, seen from the front) between two depths; it adds no collision part."""
    points = np.asarray(polygon, dtype=np.float64)
    vertices, faces = shapes.extrusion(points, x)
    b.add((vertices[:, [2, 0, 1]], faces), material, hulls=[])


def _cut(b: Builder, shape, page, x: float, level: int, material: str) -> None:
    """A shapely shape cut to the page, laid on it as one more coat of paint."""
    cut = shape.intersection(page)
    for part in getattr(cut, "geoms", [cut]):
        if part.geom_type == "Polygon" and part.area > 1e-6:
            ring = shapely.get_coordinates(shapely.orient_polygons(shapely.Polygon(part.exterior)))[:-1]
            panel(b, ring, (x - 0.002, x + 0.00035 * level), material)


def art(b: Builder, y: Interval, z: Interval, x: float, rng: np.random.Generator, kind: str | None = None) -> None:
    """A composition on the rectangle y, z at depth x; paint is up to 2.5 mm thick, so leave a part around it."""
    kind = kind or KINDS[int(rng.integers(len(KINDS)))]
    tones = list(_SCHEMES[int(rng.integers(len(_SCHEMES)))])
    page = shapely.box(y[0], z[0], y[1], z[1])
    w, h = y[1] - y[0], z[1] - z[0]
    t = np.linspace(0, 1, 13)

    def at(u: float, v: float) -> tuple[float, float]:
        return y[0] + u * w, z[0] + v * h

    def round_at(u: float, v: float, r: float):
        return shapely.Point(*at(u, v)).buffer(r, quad_segs=6)

    def below(line: np.ndarray):
        return shapely.Polygon([at(0, 0), at(1, 0), *[at(u, v) for u, v in zip(t[::-1], line[::-1], strict=True)]])

    _cut(b, page, page, x, 1, tones[0])
    small = min(w, h)
    if kind in ("hills", "sea"):
        _cut(
            b,
            round_at(rng.uniform(0.25, 0.75), rng.uniform(0.68, 0.8), small * rng.uniform(0.1, 0.16)),
            page,
            x,
            2,
            tones[3] if kind == "hills" else "ochre pigment",
        )
        for n in range(4):
            level = 0.62 - 0.15 * n if kind == "hills" else 0.48 - 0.12 * n
            swing = 0.1 if kind == "hills" else 0.018
            line = level + swing * np.sin(t * rng.uniform(3, 7) + rng.uniform(0, 6)) + 0.3 * swing * np.sin(t * 14 + n)
            _cut(
                b,
                below(line),
                page,
                x,
                3 + n,
                tones[1 + (n + 1) % 4]
                if kind == "hills"
                else ("sea pigment", "sky pigment", "night pigment", "sand pigment")[n],
            )
    elif kind == "blocks":
        u0 = 0.0
        for n, share in enumerate(rng.dirichlet((5, 5, 5))):
            v0 = 0.0
            for m, high in enumerate(rng.dirichlet((4, 4, 4))):
                box = shapely.box(*at(u0 + 0.012, v0 + 0.012), *at(u0 + share - 0.012, v0 + high - 0.012))
                _cut(b, box, page, x, 2, tones[(n * 2 + m + int(rng.integers(3))) % 5])
                v0 += high
            u0 += share
    elif kind == "circles":
        for n in range(6):
            r = small * rng.uniform(0.12, 0.3)
            _cut(
                b, round_at(rng.uniform(0.15, 0.85), rng.uniform(0.15, 0.85), r), page, x, 2 + n // 2, tones[1 + n % 4]
            )
        _cut(b, shapely.LineString([at(0.1, 0.2), at(0.9, 0.75)]).buffer(0.006), page, x, 6, "ink pigment")
    elif kind == "arches":
        c = rng.uniform(0.35, 0.65)
        for n in range(4):
            r = small * (0.4 - 0.09 * n)
            v = z[0] + h * 0.12
            top = z[0] + h * 0.45
            arch = (
                shapely.Point(at(c, 0)[0], top)
                .buffer(r, quad_segs=8)
                .union(shapely.box(at(c, 0)[0] - r, v, at(c, 0)[0] + r, top))
            )
            _cut(b, arch.intersection(shapely.box(y[0], v, y[1], z[1])), page, x, 2 + n, tones[(1 + n) % 5])
        _cut(b, round_at(0.8 if c < 0.5 else 0.2, 0.86, small * 0.08), page, x, 6, "ochre pigment")
    elif kind == "leaves":
        for n, side in enumerate((-1, 1, -1, 1, -1, 1, 0)):
            v = 0.25 + 0.1 * n
            base, turn = at(0.5, v), math.pi / 2 - side * 0.9
            long = small * (0.34 - 0.02 * n)
            s = np.linspace(0, 1, 8)
            half = 0.16 * long * np.sin(np.pi * s)
            line = np.concatenate([np.c_[s * long, half], np.c_[s[::-1] * long, -half[::-1]][1:-1]])
            c, k = math.cos(turn), math.sin(turn)
            leaf = shapely.Polygon(line @ np.array([[c, k], [-k, c]]) + base).buffer(0)
            _cut(b, leaf, page, x, 3 + n % 2, tones[1 + n % 2])
        _cut(b, shapely.LineString([at(0.5, 0.1), at(0.5, 0.86)]).buffer(small * 0.008), page, x, 2, tones[2])
    else:
        for n in range(6):
            line = 0.92 - 0.16 * n + 0.06 * np.sin(2 * np.pi * t * 1.2 + 0.7 * n + rng.uniform(0, 0.8))
            _cut(b, below(line), page, x, 2 + min(n, 4), tones[(n + 1) % 5])


def framed(
    b: Builder,
    y: Interval,
    z: Interval,
    depth: Interval,
    frame: Material | str,
    width: float,
    mat: float,
    rng: np.random.Generator,
    kind: str | None = None,
) -> None:
    """A picture in a frame of four bars, with a mat of paper ``mat`` wide (0 for none), between two depths."""
    x0, x1 = depth
    b.box(depth, y, (z[0], z[0] + width), frame, bevel=0.002)
    b.box(depth, y, (z[1] - width, z[1]), frame, bevel=0.002)
    b.box(depth, (y[0], y[0] + width), (z[0] + width, z[1] - width), frame, bevel=0.002)
    b.box(depth, (y[1] - width, y[1]), (z[0] + width, z[1] - width), frame, bevel=0.002)
    page = x1 - min(0.008, 0.4 * (x1 - x0))
    inner_y, inner_z = (y[0] + width, y[1] - width), (z[0] + width, z[1] - width)
    whole = shapes.box((x0, page + 0.003), inner_y, inner_z)
    b.add(shapes.box((x0, page - 0.001), inner_y, inner_z), "chalk pigment", hulls=[whole])
    art(b, (inner_y[0] + mat, inner_y[1] - mat), (inner_z[0] + mat, inner_z[1] - mat), page, rng, kind)
