"""What lamps share: shades, thin bells, globes, ceiling roses."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look

CLOTHS = "lit shade, white fabric, beige fabric, rust fabric, green fabric, charcoal fabric"
Profile = list[tuple[float, float]]


def shell(d: Drawing, outer: Profile, look: Look, wall: float = 0.002, sectors: int | None = None) -> None:
    """A thin round wall about z, open at both ends: a profile of (radius, z) [m] from bottom to top.

    Its collision part is its whole hull, or those of so many ``sectors`` where it has to stay open.
    """
    n = 24
    profile = [*outer, *((max(0.002, r - wall), z) for r, z in outer[::-1])]
    turns = (np.arange(n) + 0.5) * (2 * np.pi / n)
    circle = np.c_[np.cos(turns), np.sin(turns)] / math.cos(math.pi / n)
    rings = [np.c_[circle * r, np.full(n, z)] for r, z in profile]
    points, around = np.concatenate(rings), np.arange(n)
    faces = []
    for k in range(len(rings)):
        low, high = k * n, (k + 1) % len(rings) * n
        after = (around + 1) % n
        faces += [np.c_[low + around, low + after, high + after], np.c_[low + around, high + after, high + around]]
    hulls = [shapes.hull(points)]
    if sectors:
        step, last = n // sectors, len(rings) - 1
        hulls = []
        for k in range(len(outer) - 1):
            around = [rings[m] for m in (k, k + 1, last - k, last - k - 1)]
            for first in range(0, n, step):
                own = np.arange(first, first + step + 1) % n
                hulls.append(shapes.hull(np.concatenate([ring[own] for ring in around])))
    d.add((points, np.concatenate(faces).astype(np.int32)), look, hulls)


def shade(d: Drawing, box: Box, look: Look, top: float = 1.0) -> Box:
    """A shade of cloth or metal that fills a box, its upper end ``top`` times as wide; light comes out of both ends."""
    r, (low, high) = box.width / 2, box.z
    x, y, _ = box.center
    rim = min(0.018, 0.1 * box.height)
    with d.at(x, y):
        shell(d, [(r, low), (r * top, high)], look)
        with d.no_colliders():
            inner = Box.sized(2 * r, 2 * r, box.height, (0, 0, low)).inset(x=0.002, y=0.002)
            part = rim / box.height
            ends = [(1 + (top - 1) * s - 0.004 / r, s) for s in (part, 1 - part)]
            d.turned(inner, ends, "lamp glow")
    return box


def globe(d: Drawing, box: Box, segments: int = 20) -> Box:
    """A glowing ball that fills a box."""
    return d.ball(box, "lamp glow", segments)


def rose(d: Drawing, top: float, radius: float, metal: Look) -> None:
    """The cap at the ceiling, at the height ``top``."""
    box = Box.sized(2 * radius, 2 * radius, 0.045, (0.0, 0.0, top - 0.045))
    d.turned(box, [(0.012 / radius, 0.0), (0.75, 0.22), (1.0, 0.6), (1.0, 1.0)], metal)


def flat_foot(d: Drawing, radius: float, thick: float, look: Look) -> None:
    """A round flat foot with a raised middle."""
    rim = [(radius - 0.004, 0.0), (radius, 0.004), (radius, 0.6 * thick), (radius - 0.008, 0.8 * thick)]
    d.revolve([*rim, (0.03, thick), (0.018, thick + 0.012)], look, 32)


def finial(d: Drawing, top: float, metal: Look) -> None:
    """A small knob on top of a shade that ends at the height ``top``."""
    d.revolve([(0.006, top - 0.024), (0.012, top - 0.008), (0.0, top)], metal, 12)
