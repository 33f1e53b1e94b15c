"""What is looked at: painted compositions, and dials of clocks."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..box import Box
from ..drawing import Drawing, Look

SCHEMES = (
    "sand, terracotta, ochre, blush, night",
    "chalk, sea, sky, sand, night",
    "chalk, moss, forest, ochre, blush",
    "blush, plum, terracotta, chalk, ink",
    "chalk, ink, ochre, sea, terracotta",
    "sky, forest, moss, chalk, sea",
)
KINDS = ("hills", "blocks", "circles", "arches", "sea", "leaves", "waves")
OLD_KINDS, OLD_STYLES = ("hills", "sea", "portrait", "portrait"), ("classic", "rustic")
"""What hangs in rooms of old styles."""


def art(d: Drawing, box: Box, rng: np.random.Generator, kind: str | None = None) -> Box:
    """A composition of coloured shapes that fills a box, one of `KINDS` or a "portrait"; its paint lies in coats as
    thick as the box.

    It faces the front, and the box is its part.
    """
    import shapely

    kinds = OLD_KINDS if d.in_room and d.style in OLD_STYLES else KINDS
    kind = kind or kinds[int(rng.integers(len(kinds)))]
    tones = SCHEMES[int(rng.integers(len(SCHEMES)))].split(", ")
    w, h = box.width, box.height
    small, page = min(w, h), shapely.box(0.0, 0.0, w, h)
    t = np.linspace(0, 1, 13)

    def paint(shape, coat: int, tone: str) -> None:
        """Cut to the page and laid on it as one of ten coats."""
        x = box.x[0] + box.depth * (0.4 + 0.06 * coat)
        for part in shapely.get_parts(shape.intersection(page)):
            if part.geom_type == "Polygon" and part.area > 1e-6:
                ring = shapely.get_coordinates(shapely.orient_polygons(shapely.Polygon(part.exterior)))[:-1]
                points, faces = shapes.extrusion(ring + (box.y[0], box.z[0]), (box.x[0], x))
                d.add((points[:, [2, 0, 1]], faces), f"{tone} pigment", [])

    def disc(u: float, v: float, radius: float):
        return shapely.Point(u * w, v * h).buffer(radius, quad_segs=6)

    def below(line: np.ndarray):
        return shapely.Polygon([(0, 0), (w, 0), *np.c_[t * w, line * h][::-1]])

    points, faces = shapes.box((box.x[0], box.x[0] + 0.4 * box.depth), box.y, box.z)
    d.add((points, faces), f"{tones[0]} pigment", [shapes.box(box.x, box.y, box.z)])
    if kind in ("hills", "sea"):
        hills = kind == "hills"
        sun = disc(rng.uniform(0.25, 0.75), rng.uniform(0.68, 0.8), small * rng.uniform(0.1, 0.16))
        paint(sun, 1, tones[3] if hills else "ochre")
        swing = 0.1 if hills else 0.018
        for n, tone in enumerate(
            [tones[1 + (k + 1) % 4] for k in range(4)] if hills else ["sea", "sky", "night", "sand"]
        ):
            line = (0.62 - 0.15 * n) if hills else (0.48 - 0.12 * n)
            wave = np.sin(t * rng.uniform(3, 7) + rng.uniform(0, 6)) + 0.3 * np.sin(t * 14 + n)
            paint(below(line + swing * wave), 2 + n, tone)
    elif kind == "portrait":
        coat, hair = ("ink", "plum", "night")[int(rng.integers(3))], ("ink", "terracotta")[int(rng.integers(2))]
        paint(page, 1, ("forest", "night")[int(rng.integers(2))])
        wide = 0.36 * small
        paint(disc(0.5, 0.04, wide).union(shapely.box(0.5 * w - wide, 0.0, 0.5 * w + wide, 0.04 * h)), 2, coat)
        paint(disc(0.5, 0.63, 0.185 * small), 3, hair)
        paint(disc(0.5, 0.40, 0.09 * small), 4, "blush")
        paint(disc(0.5, 0.575, 0.135 * small), 5, "blush")
        paint(disc(0.5, 0.33, 0.06 * small), 6, "chalk")
    elif kind == "blocks":
        u = 0.0
        for n, share in enumerate(rng.dirichlet((5, 5, 5))):
            v = 0.0
            for m, high in enumerate(rng.dirichlet((4, 4, 4))):
                block = shapely.box((u + 0.012) * w, (v + 0.012) * h, (u + share - 0.012) * w, (v + high - 0.012) * h)
                paint(block, 1, tones[(n * 2 + m + int(rng.integers(3))) % 5])
                v += high
            u += share
    elif kind == "circles":
        for n in range(6):
            where = disc(rng.uniform(0.15, 0.85), rng.uniform(0.15, 0.85), small * rng.uniform(0.12, 0.3))
            paint(where, 1 + n, tones[1 + n % 4])
        paint(shapely.LineString([(0.1 * w, 0.2 * h), (0.9 * w, 0.75 * h)]).buffer(0.006), 8, "ink")
    elif kind == "arches":
        middle = rng.uniform(0.35, 0.65)
        ground = shapely.box(0.0, 0.12 * h, w, h)
        for n in range(4):
            r = small * (0.4 - 0.09 * n)
            pillar = shapely.box(middle * w - r, 0.12 * h, middle * w + r, 0.45 * h)
            paint(disc(middle, 0.45, r).union(pillar).intersection(ground), 1 + n, tones[(1 + n) % 5])
        paint(disc(0.8 if middle < 0.5 else 0.2, 0.86, 0.08 * small), 6, "ochre")
    elif kind == "leaves":
        s = np.linspace(0, 1, 8)
        paint(shapely.LineString([(w / 2, 0.1 * h), (w / 2, 0.86 * h)]).buffer(0.008 * small), 1, tones[2])
        for n, side in enumerate((-1, 1, -1, 1, -1, 1, 0)):
            turn, long = math.pi / 2 - 0.9 * side, small * (0.34 - 0.02 * n)
            half = 0.16 * long * np.sin(np.pi * s)
            line = np.concatenate([np.c_[s * long, half], np.c_[s[::-1] * long, -half[::-1]][1:-1]])
            c, k = math.cos(turn), math.sin(turn)
            leaf = line @ np.array([[c, k], [-k, c]]) + (w / 2, (0.25 + 0.1 * n) * h)
            paint(shapely.Polygon(leaf).buffer(0), 2 + n, tones[1 + n % 2])
    else:
        for n in range(6):
            line = 0.92 - 0.16 * n + 0.06 * np.sin(2.4 * np.pi * t + 0.7 * n + rng.uniform(0, 0.8))
            paint(below(line), 1 + n, tones[(n + 1) % 5])
    return box


def clock_face(d: Drawing, box: Box, dial: Look, hands: Look, numbers: bool = True) -> None:
    """A round dial with marks and hands that fills a box and faces the front; the hands are its last 4 mm."""
    r, z = min(box.width, box.height) / 2, box.depth - 0.004
    x, y, height = box.anchor("back")
    with d.at(x, y, height, pitch=math.pi / 2):  # +z is forward, and -x up
        d.cylinder(Box.sized(2 * r, 2 * r, z), dial, segments=36)
        for k in range(12 if numbers else 0):
            main = k % 3 == 0
            with d.at(yaw=k * math.pi / 6):
                long, wide = (0.2 if main else 0.12) * r, max(0.0024, (0.048 if main else 0.024) * r)
                d.print(Box.around((0.92 * r - long / 2, 0.0, z), long, wide, 0.0), hands)
        for turn, long, wide, lift in ((0.86, 0.5, 0.035, 0.002), (-1.05, 0.78, 0.022, 0.003)):
            with d.at(yaw=math.pi - turn):
                ends = ((-0.1 * r, wide * r), (long * r, 0.5 * wide * r))
                d.hull([(u, s * v, z + e) for u, v in ends for s in (-1, 1) for e in (0.0, lift)], hands)
        d.cylinder(Box.sized(0.1 * r, 0.1 * r, 0.004, (0.0, 0.0, z)), hands, segments=12)
