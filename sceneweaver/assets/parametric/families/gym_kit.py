"""What gym, office, play, workshop, leisure and clinic drawings share: discs, side profiles, fitting to size."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import wraps

import numpy as np

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval
from ..registry import Maker, draws

Look = Material | str


def gear(*names: str, square: bool = False) -> Callable[[Maker], Maker]:
    """Register a drawing that is one prism except for its own solids, stretched to its size at the end.

    A ``square`` one is as wide as deep, as far as the ranges allow.
    """

    def register(draw: Maker) -> Maker:
        @wraps(draw)
        def maker(b: Builder) -> None:
            with b.solid("all"):
                draw(b)
            d, w, h = b.size
            if square and b.category.size and b.request.size[1] is None:
                low, high = b.category.size.width
                w = min(max(d, low), high)
            b.fit((d, w, h))

        draws(*names)(maker)
        return maker

    return register


def disc(
    b: Builder,
    at: Sequence[float],
    r: float,
    t: float,
    look: Look,
    axis: str = "y",
    segments: int = 24,
    bevel: float = 0.0,
    head: float | None = None,
) -> None:
    """A wheel, weight or knob of thickness ``t`` centred at a point; ``head`` is the radius of its other end."""
    turn = {"x": {"pitch": math.pi / 2}, "y": {"roll": -math.pi / 2}, "z": {}}[axis]
    with b.frame(at[0], at[1], at[2], **turn):
        b.frustum(r, r if head is None else head, (-t / 2, t / 2), look, segments, bevel)


def ring(
    b: Builder,
    at: Sequence[float],
    r: float,
    thick: float,
    look: Look,
    axis: str = "y",
    n: int = 20,
    segments: int = 8,
) -> None:
    """A tyre or hoop: a round bar in a circle of middle radius ``r``."""
    t = (np.arange(n) + 0.5) * (2 * np.pi / n)
    c, s, o = r * np.cos(t), r * np.sin(t), 0 * t
    path = {"x": np.c_[o, c, s], "y": np.c_[c, o, s], "z": np.c_[c, s, o]}[axis]
    b.tube(np.asarray(at) + path, thick, look, segments, closed=True)


def side(b: Builder, points: Sequence[tuple[float, float]], y: Interval, look: Look, bevel: float = 0.0) -> None:
    """A polygon of (x, z), seen from the right, drawn from y[0] to y[1]; counter-clockwise in x, z."""
    with b.frame(roll=math.pi / 2):
        b.extrude(np.array(points), (-y[1], -y[0]), look, bevel)


def face(b: Builder, points: Sequence[tuple[float, float]], x: Interval, look: Look, bevel: float = 0.0) -> None:
    """A polygon of (y, z), seen from the front, drawn from x[0] to x[1]; counter-clockwise in y, z."""
    with b.frame(yaw=math.pi / 2, roll=math.pi / 2):
        b.extrude(np.array(points), x, look, bevel)


def post(b: Builder, a: Sequence[float], c: Sequence[float], look: Look, wide: float = 0.06, deep: float = 0.0) -> None:
    """A straight bar of rectangular section between two points."""
    p, q = wide / 2, (deep or wide) / 2
    b.bar(np.asarray(a, float), np.asarray(c, float), np.array([(p, -q), (p, q), (-p, q), (-p, -q)]), look)


def inlay(b: Builder, x: Interval, y: Interval, z: Interval, look: Look) -> None:
    """A print, key or groove without a part of its own: it lies in another part, proud by less than 0.4 mm."""
    b.add(shapes.box(x, y, z), look, [])


def castors(b: Builder, x: Interval, y: Interval, look: Look = "black plastic", r: float = 0.035) -> None:
    """Four castors with their axles along y, on the floor under the corners of a rectangle."""
    for px in x:
        for py in y:
            disc(b, (px, py, r), r, 0.024, look, segments=16, bevel=0.003)
            b.box((px - 0.014, px + 0.014), (py - 0.018, py + 0.018), (r * 1.3, 2 * r + 0.012), "grey plastic", 0.002)


def loop(points: Sequence[Sequence[float]]) -> np.ndarray:
    """Points as an array."""
    return np.array(points, dtype=np.float64)
