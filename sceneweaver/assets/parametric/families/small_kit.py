"""What drawings of small objects share: one prism each, stretched to their size, and a few shapes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import wraps
from typing import Literal

import numpy as np

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval
from ..registry import Maker, draws

Look = Material | str

OPEN = "open"
"""The shape asked of a box that things are put into: without a lid, with a surface inside."""

PROUD = 0.0003
"""How far [m] prints, labels and buttons stand out of what they lie on: less than the rules for parts notice."""


def small(*names: str, fit: Literal["box", "round", "cube"] = "box", opened: bool = False) -> Callable[[Maker], Maker]:
    """Register a drawing of a small object: one prism (unless ``opened``), stretched to exactly its size.

    A "round" one is as wide as deep and a "cube" as high too, unless the request says otherwise.
    """

    def register(draw: Maker) -> Maker:
        @wraps(draw)
        def maker(b: Builder) -> None:
            if opened:
                draw(b)
            else:
                with b.solid("all"):
                    draw(b)
            b.fit(target(b, fit))

        draws(*names)(maker)
        return maker

    return register


def target(b: Builder, fit: str = "round") -> tuple[float, float, float]:
    """The size to draw: that of the builder, with equal sides where ``fit`` asks for them."""
    size, asked = list(b.size), b.request.size
    axes = {"box": [], "round": [0, 1], "cube": [0, 1, 2]}[fit]
    lead = next((size[k] for k in axes if asked[k] is not None), size[0])
    for k in axes:
        if asked[k] is None:
            low, high = b.category.size.ranges[k] if b.category.size else (lead, lead)
            size[k] = min(max(lead, low), high)
    return size[0], size[1], size[2]


def ellipse(rx: float, ry: float, z: float, n: int = 20, x: float = 0.0, y: float = 0.0) -> np.ndarray:
    """A level ring [n, 3]."""
    t = (np.arange(n) + 0.5) * (2 * np.pi / n)
    return np.c_[x + rx * np.cos(t), y + ry * np.sin(t), np.full(n, z)]


def rect(x: Interval, y: Interval, z: float, radius: float, n: int = 3) -> np.ndarray:
    """A level rectangle with round corners as a ring [4 n + 4, 3], counter-clockwise."""
    radius = min(radius, 0.499 * (x[1] - x[0]), 0.499 * (y[1] - y[0]))
    t = np.linspace(0, np.pi / 2, n + 1)
    points = []
    for k, (cx, cy) in enumerate([(x[1], y[1]), (x[0], y[1]), (x[0], y[0]), (x[1], y[0])]):
        mx = cx - radius if cx == x[1] else cx + radius
        my = cy - radius if cy == y[1] else cy + radius
        a = t + k * np.pi / 2
        points.append(np.c_[mx + radius * np.cos(a), my + radius * np.sin(a), np.full(n + 1, z)])
    return np.concatenate(points)


def lofted(rings: Sequence[np.ndarray]) -> shapes.convex.Shape:
    """A closed skin over rings of as many points each, from foot to head; the first and last are capped."""
    n, k = len(rings[0]), len(rings)
    i = np.arange(n)
    j = (i + 1) % n
    faces = []
    for r in range(k - 1):
        a, c = r * n, (r + 1) * n
        faces += [np.c_[a + i, a + j, c + j], np.c_[a + i, c + j, c + i]]
    fan = np.arange(1, n - 1)
    faces += [np.c_[0 * fan, fan + 1, fan], np.c_[0 * fan, fan, fan + 1] + (k - 1) * n]
    return np.concatenate(rings), np.concatenate(faces).astype(np.int32)


def loft(b: Builder, rings: Sequence[np.ndarray], material: Look, convex: bool = False, hollow: int = 0) -> None:
    """A skin over convex rings; its parts are hulls of two neighbours, or one hull when it is convex.

    The last ``hollow`` rings run down again inside, and need no part.
    """
    outer = list(rings[: len(rings) - hollow])
    pairs = [outer] if convex else [list(p) for p in zip(outer[:-1], outer[1:], strict=True)]
    pairs = [p for p in pairs if np.ptp(np.concatenate(p)[:, 2]) > 1e-6 or len(p) > 2]
    b.add(lofted(rings), material, [shapes.hull(np.concatenate(p)) for p in pairs])


def slab(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Look,
    radius: float = 0.01,
    bevel: float = 0.001,
    n: int = 3,
) -> None:
    """A slab with round corners in the plan and cut edges."""
    c = min(bevel, 0.45 * (z[1] - z[0]), 0.6 * radius)
    rings = [
        rect((x[0] + e, x[1] - e), (y[0] + e, y[1] - e), h, radius - e, n)
        for e, h in ((c, z[0]), (0.0, z[0] + c), (0.0, z[1] - c), (c, z[1]))
    ]
    loft(b, rings, material, convex=True)


def decal(b: Builder, x: Interval, y: Interval, z: Interval, material: Look, own: bool = False) -> None:
    """A print, a label or a key: a box that stands 0.3 mm out of a part, or farther as a part of its ``own``."""
    b.add(shapes.box(x, y, z), material, None if own else [])


def spot(b: Builder, radius: float, z: Interval, material: Look, segments: int = 16) -> None:
    """A round thing about z without a part: what fills a cup, a button, a printed band on a can."""
    b.add(shapes.frustum(radius, radius, z, segments), material, [])


def band(b: Builder, low: float, high: float, z: Interval, material: Look, segments: int = 24) -> None:
    """A printed band around a round body of these radii."""
    b.add(shapes.frustum(low + PROUD, high + PROUD, z, segments), material, [])


def arch(b: Builder, start, end, out, radius, material: Look, n: int = 6, segments: int = 8) -> None:
    """A handle: a half ellipse from ``start`` to ``end`` that reaches ``out`` from their middle."""
    a, c = np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64)
    t = np.linspace(0, np.pi, n + 1)[:, None]
    b.tube((a + c) / 2 + (a - c) / 2 * np.cos(t) + np.asarray(out) * np.sin(t), radius, material, segments)


def hoop(b: Builder, radius: float, z: float, thick: float, material: Look, n: int = 16, squash: float = 1.0) -> None:
    """A level ring of round wire about z."""
    t = np.arange(n) * (2 * np.pi / n)
    path = np.c_[radius * np.cos(t), squash * radius * np.sin(t), np.full(n, z)]
    b.tube(path, thick, material, 6, closed=True)


def spun(
    b: Builder,
    profile: list[tuple[float, float]],
    material: Look,
    sx: float = 1.0,
    sy: float = 1.0,
    segments: int = 20,
    hollow: bool = False,
    parts: bool = True,
) -> None:
    """A lathed profile, stretched along x and y."""
    scale = np.array([sx, sy, 1.0])
    points, faces = shapes.lathe(profile, segments)
    hulls = []
    if parts:
        top = max(range(len(profile)), key=lambda i: (profile[i][1], -i))
        rising = profile[: top + 1] if hollow else profile
        hulls = [(v * scale, f) for v, f in shapes.lathe_hulls(rising, segments)]
    b.add((points * scale, faces), material, hulls)


def dome(radius: float, low: float, high: float, n: int = 4, tip: float = 0.0) -> list[tuple[float, float]]:
    """Profile points of a round top, from (radius, low) to (tip, high)."""
    t = np.linspace(0, np.pi / 2, n + 1)
    return [(float(tip + (radius - tip) * np.cos(a)), float(low + (high - low) * np.sin(a))) for a in t]


def orb(b: Builder, radii: Sequence[float], center: Sequence[float], material: Look, segments: int = 12) -> None:
    """A small ball whose part is the ball itself."""
    b.ball((radii[0], radii[1], radii[2]), (center[0], center[1], center[2]), material, segments)
