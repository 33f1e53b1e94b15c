"""What beds share: bedding, head boards, slatted sides, ladders."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...body import Material
from ..builder import Builder, Interval
from .seating_parts import pillow, ring_shape

Finish = Material | str

SHEETS = ("white fabric", "beige fabric", "white fabric")
BLANKETS = (
    "blue fabric",
    "navy fabric",
    "green fabric",
    "mustard fabric",
    "rust fabric",
    "rose fabric",
    "grey fabric",
    "charcoal fabric",
    "red fabric",
)


def bedding(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    group: str = "bed",
    pillows: int = 2,
    rail: float | None = None,
    surface: str | None = "top",
    overhang: float = 0.0,
    runner: bool = False,
    thick: float = 0.15,
) -> None:
    """A mattress that fills the box, pillows at its head (-x), and a blanket with a folded edge over the rest.

    The blanket hangs down to ``rail`` at the sides and stands out there by ``overhang``.
    """
    sheet = b.material("sheet", *SHEETS)
    cover = b.material("blanket", *BLANKETS)
    d = x[1] - x[0]
    with b.solid(group):
        b.cushion(x, y, z, sheet, radius=0.045)
        start = x[0] + (0.62 if d > 1.7 else 0.42)
        low = z[0] + 0.4 * (z[1] - z[0]) if rail is None else rail
        top = z[1] + 0.032
        swing = min(0.024, max(0.0, overhang - 0.008))
        grow = overhang
        ys = (y[0] - grow, y[1] + grow)
        end = x[1] + (grow if grow else 0.004)
        phase = b.uniform(f"{group} folds", 0, 6)
        shape = ring_shape((start, end), ys, (low, top), 0.05, swing, phase)
        b.add(shape, cover, [shapes.containing_hull(shape[0])])
        fold = ring_shape(
            (start + 0.004, start + 0.24),
            (ys[0] + swing - 0.006, ys[1] - swing + 0.006),
            (top - 0.16 if grow else low + 0.02, top + 0.014),
            0.05,
        )
        with b.solid(f"{group} pillows"):
            b.add(fold, sheet, [shapes.containing_hull(fold[0])])
        finish = end - 0.07
        if runner:
            accent = b.material("runner", "@fabric")
            band = ring_shape(
                (end - 0.62, end - 0.2), (ys[0] + swing - 0.004, ys[1] - swing + 0.004), (top - 0.14, top + 0.01), 0.04
            )
            with b.solid(f"{group} runner"):
                b.add(band, accent, [shapes.containing_hull(band[0])])
            finish = end - 0.66
        if surface:
            b.surface(surface, (start + 0.27, finish), (ys[0] + 0.08, ys[1] - 0.08), top)
    head_pillows(b, x[0], y, z[1], pillows, 0.46 if d > 1.7 else 0.32, thick, group)


def head_pillows(
    b: Builder, x: float, y: Interval, z: float, count: int, depth: float, thick: float, group: str = "bed"
) -> None:
    """Pillows side by side at the head, propped up a little, with a smaller one in front in some."""
    sheet, cover = b.material("sheet", *SHEETS), b.material("blanket", *BLANKETS)
    case = b.material("pillows", "white fabric") if b.chance("white pillows", 0.4) else sheet
    w = y[1] - y[0]
    wide = min(0.78 if count == 2 else 0.66, (w - 0.06) / count - 0.03)
    middle = (y[0] + y[1]) / 2
    double = b.chance("double pillows", 0.6) and thick > 0.145
    with b.solid(f"{group} pillows"):
        for k in range(count):
            at = middle + (k - (count - 1) / 2) * (wide + 0.04)
            with b.frame(x + 0.03 + depth / 2, at, z, pitch=0.12):
                pillow(b, depth, wide, thick, case, lift=0.01)
            if double:
                with b.frame(x + 0.2, at, z + 0.19, pitch=0.85):
                    pillow(b, depth * 0.9, wide * 0.96, thick * 0.9, cover, lift=0.0)


def slats(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Finish,
    pitch: float,
    size: float = 0.016,
    round_: bool = False,
) -> None:
    """Upright bars along the longer of x and y, about ``pitch`` apart, between two heights."""
    along_x = x[1] - x[0] > y[1] - y[0]
    a, c = x if along_x else y
    middle = sum(y) / 2 if along_x else sum(x) / 2
    count = max(1, round((c - a) / pitch) - 1)
    half = size / 2
    for k in range(count):
        s = a + (c - a) * (k + 1) / (count + 1)
        px, py = (s, middle) if along_x else (middle, s)
        if round_:
            b.bar((px, py, z[0]), (px, py, z[1]), half, material, segments=6)
        else:
            b.box((px - half, px + half), (py - half, py + half), z, material, bevel=0.002)


def head_board(b: Builder, x: float, y: Interval, z: Interval, style: str, cover: Finish, wood: Finish) -> None:
    """A head board 3 to 9 cm thick whose back lies at x: "panel", "channels", "tufted", "slats", "arch", "rails"."""
    low, high = z
    w = y[1] - y[0]
    with b.solid("head board"):
        if style == "panel":
            b.box((x, x + 0.035), y, (0.0, high), wood, bevel=0.006)
            b.box((x + 0.034, x + 0.045), (y[0] + 0.07, y[1] - 0.07), (low, high - 0.07), wood, bevel=0.004)
        elif style == "channels":
            b.box((x, x + 0.04), y, (0.0, high - 0.01), cover, bevel=0.01)
            count = max(5, round(w / 0.17))
            for k in range(count):
                b.cushion(
                    (x + 0.02, x + 0.095),
                    (y[0] + k * w / count, y[0] + (k + 1) * w / count),
                    (low, high),
                    cover,
                    radius=0.035,
                )
        elif style == "tufted":
            b.cushion((x, x + 0.085), y, (0.0, high), cover, radius=0.035)
            for i in range(2 if high - low < 0.55 else 3):
                count = max(4, round(w / 0.22)) - i % 2
                for k in range(count):
                    at = y[0] + (k + (0.5 if not i % 2 else 1.0)) * w / (count + i % 2)
                    b.ball((0.009, 0.014, 0.014), (x + 0.083, at, high - 0.1 - 0.14 * i), cover, segments=8)
        elif style == "arch":
            count = 16
            angle = np.linspace(0, math.pi, count)
            spring = high - min(0.35, 0.45 * (high - low))
            ring = np.c_[-np.cos(angle) * w / 2 + (y[0] + y[1]) / 2, spring + np.sin(angle) * (high - spring)]
            ring = np.concatenate([ring, [(y[1], 0.0), (y[0], 0.0)]])
            points = np.concatenate([np.c_[np.full(len(ring), px), ring] for px in (x, x + 0.05)])
            b.hull(points, cover)
            inner = (ring - (sum(y) / 2, low)) * (0.86, 0.8) + (sum(y) / 2, low + 0.04)
            inner[:, 1] = np.maximum(inner[:, 1], low)
            b.hull(np.concatenate([np.c_[np.full(len(inner), px), inner] for px in (x + 0.03, x + 0.062)]), cover)
        else:
            post = 0.05
            for ys in ((y[0], y[0] + post), (y[1] - post, y[1])):
                b.box((x, x + post), ys, (0.0, high), wood, bevel=0.005)
            b.box((x + 0.006, x + 0.044), (y[0] + post, y[1] - post), (high - 0.11, high - 0.02), wood)
            b.box((x + 0.01, x + 0.04), (y[0] + post, y[1] - post), (low - 0.08, low + 0.02), wood)
            if style == "slats":
                slats(
                    b, (x + 0.015, x + 0.035), (y[0] + post, y[1] - post), (low + 0.02, high - 0.11), wood, 0.12, 0.02
                )
            else:
                for k in range(2):
                    at = low + 0.02 + (high - 0.13 - low) * (k + 1) / 3
                    b.box((x + 0.012, x + 0.038), (y[0] + post, y[1] - post), (at - 0.045, at + 0.045), wood)


def ladder(b: Builder, x: Interval, y: float, z: Interval, material: Finish, lean: float, rungs: int) -> None:
    """A ladder with stiles at both ends of x, its head at y and its foot ``lean`` further out."""
    for cx in x:
        points = [
            (cx + s, y + o + t, h) for s in (-0.016, 0.016) for t in (0, 0.05) for o, h in ((lean, z[0]), (0.0, z[1]))
        ]
        b.hull(points, material)
    for k in range(rungs):
        t = (k + 1) / (rungs + 1)
        h = z[0] + t * (z[1] - z[0])
        at = y + lean * (1 - t) + 0.025
        b.box((x[0] + 0.014, x[1] - 0.014), (at - 0.03, at + 0.03), (h - 0.012, h + 0.012), material)
