"""Bathtubs and showers."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import Finish, oval, rounded, vessel


def _inside(rx: float, ry: float, h: float, power: float) -> list[np.ndarray]:
    return [
        oval(rx, ry, h, power=power, n=40),
        oval(rx * 0.97, ry * 0.985, h - 0.05, power=power, n=40),
        oval(rx * 0.84, ry * 0.90, 0.17, power=power, n=40),
        oval(rx * 0.6, ry * 0.80, 0.11, power=3.0, n=40),
    ]


def _mixer(b: Builder, y: float, z: float, metal: Finish) -> None:
    """A bath filler that stands on the rim at the end y and pours toward the middle."""
    s = -1 if y > 0 else 1
    with b.solid("tap"):
        for px in (-0.075, 0.075):
            with b.frame(px, y, z):
                b.frustum(0.022, 0.018, (0.0, 0.035), metal, segments=14)
                b.frustum(0.013, 0.013, (0.035, 0.06), metal, segments=12)
            b.bar((px - 0.028, y, z + 0.065), (px + 0.028, y, z + 0.065), 0.008, metal, 8)
        with b.frame(0.0, y, z):
            b.frustum(0.024, 0.02, (0.0, 0.05), metal, segments=14)
            b.tube(
                [(0, 0, 0.045), (0, s * 0.01, 0.085), (0, s * 0.06, 0.11), (0, s * 0.12, 0.1), (0, s * 0.14, 0.075)],
                0.014,
                metal,
                10,
            )


@draws("bathtub")
def bathtub(b: Builder) -> None:
    """A hollow tub behind a panelled apron, with rim, drain, overflow and a mixer on its end."""
    d, w, total = b.size
    white = b.material("tub", "white ceramic")
    metal = b.material("tap", "chrome", "brass", "brushed steel", "black steel")
    apron = b.material("apron", "white paint", "white ceramic", "oak", "sage paint", "marble", "grey paint")
    h = total - 0.118
    end = b.pick("end", [-1, 1])
    p = b.pick("shape", [4.0, 6.0, 3.0])
    rx, ry = d / 2 - 0.055, w / 2 - 0.07
    with b.solid("tub"):
        n = 40
        outer = [
            oval(d / 2 - 0.012, w / 2 - 0.012, 0.04, power=24, n=n),
            oval(d / 2 - 0.012, w / 2 - 0.012, h - 0.035, power=24, n=n),
            oval(d / 2, w / 2, h - 0.03, power=24, n=n),
            oval(d / 2, w / 2, h, power=24, n=n),
        ]
        vessel(b, outer, _inside(rx, ry, h, p), white, 20)
        # The apron in front and at both ends, framed.
        f = d / 2 - 0.013
        b.box((f - 0.02, f + 0.008), (-w / 2 + 0.004, w / 2 - 0.004), (0.0, h - 0.036), apron, bevel=0.002)
        b.box((-d / 2 + 0.01, d / 2 - 0.035), (-w / 2 + 0.016, w / 2 - 0.016), (0.0, 0.05), "white plastic", bevel=0)
        if b.chance("panels", 0.7):
            m = 4 if w > 1.6 else 3
            step = (w - 0.06) / m
            for k in range(m + 1):
                at = -w / 2 + 0.03 + k * step
                b.box((f + 0.007, f + 0.012), (at - 0.022, at + 0.022), (0.02, h - 0.04), apron, bevel=0.001)
            for z in (0.02, h - 0.085):
                b.box((f + 0.007, f + 0.0115), (-w / 2 + 0.03, w / 2 - 0.03), (z, z + 0.045), apron, bevel=0.001)
        with b.frame(0.0, end * ry * 0.45, 0.109):
            b.frustum(0.032, 0.03, (0.0, 0.004), "chrome", segments=18)
        yo = ry * (0.97 - (0.13 * (h - 0.05 - (h - 0.12)) / (h - 0.22)) * 0.5)
        with b.frame(0.0, end * (yo + 0.004), h - 0.12, roll=end * math.pi / 2):
            b.frustum(0.036, 0.034, (0.0, 0.022), "chrome", segments=18)
    _mixer(b, end * (w / 2 - 0.035), h, metal)
    b.fit()


@draws("freestanding_bathtub")
def freestanding_bathtub(b: Builder) -> None:
    """An egg-shaped shell on a plinth, or one with a rolled rim on four feet; a filler on the floor at its back."""
    d, w, total = b.size
    h = total - 0.28
    white = b.material("tub", "white ceramic")
    feet = b.style in ("classic", "rustic") or b.chance("feet", 0.2)
    n = 40
    low = 0.13 if feet else 0.0
    p = 2.5
    t = 0.035
    with b.solid("tub"):
        if feet:
            metal = b.material("feet", "brass", "chrome", "black steel", "bronze")
            outer = [(0.55, 0.66, low), (0.80, 0.84, low + 0.06), (0.92, 0.94, 0.35), (0.945, 0.965, h - 0.03)]
            for sx in (-1, 1):
                for sy in (-1, 1):
                    cx, cy = sx * d * 0.29, sy * w * 0.31
                    pts = [
                        (cx, cy, low + 0.12),
                        (cx + sx * 0.045, cy + sy * 0.05, low + 0.05),
                        (cx + sx * 0.03, cy + sy * 0.035, 0.06),
                        (cx + sx * 0.055, cy + sy * 0.06, 0.028),
                    ]
                    b.tube(pts, 0.018, metal, 8)
                    b.ball((0.028, 0.028, 0.02), (cx + sx * 0.055, cy + sy * 0.06, 0.02), metal, 12)
            rings = [oval(d / 2 * a, w / 2 * c, z, power=p, n=n) for a, c, z in outer]
            rings += [
                oval(d / 2, w / 2, h - 0.026, power=p, n=n),
                oval(d / 2, w / 2, h - 0.008, power=p, n=n),
                oval(d / 2 - 0.01, w / 2 - 0.01, h, power=p, n=n),
            ]
            t = 0.055
        else:
            outer = [(0.72, 0.78, 0.0), (0.76, 0.81, 0.04), (0.88, 0.91, 0.3), (1.0, 1.0, h)]
            rings = [oval(d / 2 * a, w / 2 * c, z, power=p, n=n) for a, c, z in outer]
        inner = [
            oval(d / 2 - t, w / 2 - t, h, power=p, n=n),
            oval(d / 2 * 0.82, w / 2 * 0.88, h * 0.55, power=p, n=n),
            oval(d / 2 * 0.66, w / 2 * 0.72, low + 0.12, power=p, n=n),
            oval(d / 2 * 0.5, w / 2 * 0.6, low + 0.08, power=p, n=n),
        ]
        vessel(b, rings, inner, white, 20, (2, 1))
        with b.frame(0.0, 0.0, low + 0.079):
            b.frustum(0.032, 0.03, (0.0, 0.004), "chrome", segments=18)
        if not feet:
            with b.frame(0.0, 0.0, low + 0.079):
                b.frustum(0.05, 0.05, (0.0, 0.002), "chrome", segments=18)
    # Beside the oval there is room for a filler in a corner of the box; it pours over the rim.
    end = b.pick("end", [-1, 1])
    x, y = -d / 2 + 0.035, end * (w / 2 - 0.09)
    with b.solid("tap"), b.frame(x, y, 0.0, yaw=math.atan2(-end * 0.2, 0.16)):
        filler = b.material("tap", "chrome", "brass", "brushed steel", "black steel")
        b.frustum(0.033, 0.033, (0.0, 0.012), filler, segments=18)
        b.tube(
            [
                (0, 0, 0.01),
                (0, 0, total - 0.06),
                (0.025, 0, total - 0.02),
                (0.07, 0, total - 0.013),
                (0.2, 0, total - 0.013),
            ],
            0.013,
            filler,
            12,
        )
        b.bar((0.19, 0.0, total - 0.06), (0.19, 0.0, total - 0.012), 0.012, filler, 12)
        b.bar((-0.03, 0.0, h + 0.08), (0.03, 0.0, h + 0.08), 0.02, filler, 12)
        b.bar((0.0, 0.0, h + 0.08), (0.0, end * 0.06, h + 0.09), 0.006, filler, 8)
    b.fit()


def _tray(b: Builder, rings: list[np.ndarray], inner: list[np.ndarray], white: Finish, cuts) -> None:
    vessel(b, rings, inner, white, cuts)
    low = inner[-1].mean(axis=0)
    with b.frame(low[0], low[1], low[2] - 0.0005):
        b.frustum(0.045, 0.043, (0.0, 0.004), "chrome", segments=20)


def _column(b: Builder, x: float, y: float, h: float, metal: Finish, yaw: float = 0.0) -> None:
    """A riser on the wall at (x, y) with a mixer, a rain head and a hand shower on a hose."""
    with b.solid("column"), b.frame(x, y, 0.0, yaw=yaw):
        b.box((0.0, 0.045), (-0.14, 0.14), (1.02, 1.06), metal, bevel=0.008)
        for s in (-1, 1):
            with b.frame(0.0225, s * 0.14, 1.04, roll=-s * math.pi / 2):
                b.frustum(0.02, 0.018, (0.0, 0.035), metal, segments=14)
        b.tube(
            [(0.03, 0, 1.05), (0.03, 0, h - 0.14), (0.06, 0, h - 0.07), (0.12, 0, h - 0.05), (0.32, 0, h - 0.05)],
            0.011,
            metal,
            10,
        )
        with b.frame(0.32, 0.0, h - 0.085):
            b.frustum(0.11, 0.11, (0.0, 0.012), metal, segments=24)
            b.frustum(0.03, 0.014, (0.012, 0.035), metal, segments=12)
        b.bar((0.03, 0.0, 1.5), (0.085, -0.02, 1.5), 0.012, metal, 8)
        b.bar((0.075, -0.02, 1.38), (0.1, -0.02, 1.58), 0.011, metal, 10)
        with b.frame(0.105, -0.02, 1.6, pitch=1.9):
            b.frustum(0.045, 0.03, (-0.012, 0.012), metal, segments=16)
        hose = [
            (0.075, -0.02, 1.385),
            (0.07, -0.04, 1.15),
            (0.06, -0.06, 0.85),
            (0.05, -0.05, 0.75),
            (0.035, -0.02, 0.8),
            (0.03, -0.005, 1.02),
        ]
        b.tube(hose, 0.007, "steel", 6)


@draws("shower")
def shower(b: Builder) -> None:
    """A tray between two walls, panes with a door in front and a shower column; open above."""
    d, w, h = b.size
    white = b.material("tray", "white ceramic", "white ceramic", "dark marble", "concrete")
    metal = b.material("frame", "chrome", "black steel", "brushed steel", "brass")
    x, y = (-d / 2, d / 2 - 0.03), (-w / 2, w / 2)
    with b.solid("tray"):
        o = rounded(x, y, 0.01, 0.0)
        e = 0.04
        ins = ((x[0] + e, x[1] - e), (y[0] + e, y[1] - e))
        _tray(
            b,
            [o, o + (0, 0, 0.06)],
            [
                rounded(*ins, 0.03, 0.06),
                rounded((ins[0][0] + 0.02, ins[0][1] - 0.02), (ins[1][0] + 0.02, ins[1][1] - 0.02), 0.03, 0.03),
            ],
            white,
            (0, 3, 4, 7, 8, 11, 12, 15, 16),
        )
    g, t = 0.008, 0.025
    xf = x[1] - 0.03
    with b.solid("back"):
        b.box(
            (x[0], x[0] + 0.012), y, (0.06, h), b.material("wall", "white paint", "marble", "light grey paint"), bevel=0
        )
        for z in np.arange(0.36, h - 0.1, 0.3):
            b.box((x[0] + 0.0118, x[0] + 0.0126), y, (float(z) - 0.0015, float(z) + 0.0015), "grey plastic", bevel=0)
    left = b.chance("left pane", 0.75)
    for name, py, there in (("right pane", y[0], True), ("left pane", y[1] - t, left)):
        if not there:
            continue
        with b.solid(name):
            b.box((x[0] + 0.012, xf + t), (py, py + t), (0.06, 0.085), metal, bevel=0.002)
            b.box((x[0] + 0.012, xf + t), (py, py + t), (h - 0.03, h), metal, bevel=0.002)
            b.box((xf, xf + t), (py, py + t), (0.085, h - 0.03), metal, bevel=0.002)
            b.box((x[0] + 0.013, x[0] + 0.03), (py, py + t), (0.085, h - 0.03), metal, bevel=0)
            b.box((x[0] + 0.03, xf), (py + t / 2 - g / 2, py + t / 2 + g / 2), (0.085, h - 0.03), "glass", bevel=0)
    # In front a fixed pane and a door beside it.
    y1 = y[1] - (t if left else 0.0)
    wide = y1 - y[0] - t
    cut = y[0] + t + (0.4 * wide if wide > 0.9 else 0.0)
    with b.solid("front"):
        b.box((xf, xf + t), (y[0] + t, y1), (h - 0.03, h), metal, bevel=0.002)
        b.box((xf, xf + t), (y[0] + t, y1), (0.06, 0.085), metal, bevel=0.002)
        if cut > y[0] + 0.1:
            b.box((xf + 0.004, xf + 0.004 + g), (y[0] + t, cut - 0.008), (0.085, h - 0.03), "glass", bevel=0)
            b.box((xf, xf + t), (cut - 0.008, cut + 0.008), (0.085, h - 0.03), metal, bevel=0.002)
            cut += 0.008
        else:
            cut += 0.001
        with b.hinge("door", (xf + t, y1, 0.09), limits=(0.0, 1.7)):
            b.box((xf + 0.009, xf + 0.009 + g), (cut + 0.002, y1 - 0.002), (0.09, h - 0.034), "glass", bevel=0)
            hx = xf + 0.009 + g
            at = cut + 0.06
            b.bar((hx + 0.028, at, 0.95), (hx + 0.028, at, 1.25), 0.009, metal, 10)
            for z in (0.98, 1.22):
                b.bar((hx - 0.001, at, z), (hx + 0.028, at, z), 0.007, metal, 8)
    _column(b, x[0] + 0.012, 0.0, h, metal)
    b.fit()


@draws("corner_shower")
def corner_shower(b: Builder) -> None:
    """A quadrant tray with round sliding panes toward the room; the corner of the walls is at -x, +y."""
    d, w, h = b.size
    metal = b.material("frame", "chrome", "black steel", "brushed steel")
    white = b.material("tray", "white ceramic", "white ceramic", "dark marble")
    n = 8
    r = 0.62

    def front(inset: float) -> list[tuple[float, float]]:
        """From the right wall's end of the curve to the left one's."""
        x1, y0 = d / 2 - inset, -w / 2 + inset
        cx, cy = x1 - r + inset, y0 + r - inset
        q = r - inset
        return [
            (
                cx + q * math.cos(-math.pi / 2 + k * math.pi / (2 * n)),
                cy + q * math.sin(-math.pi / 2 + k * math.pi / (2 * n)),
            )
            for k in range(n + 1)
        ]

    def outline(inset: float, z: float) -> np.ndarray:
        pts = [
            (-d / 2 + inset, -w / 2 + inset),
            *front(inset),
            (d / 2 - inset, w / 2 - inset),
            (-d / 2 + inset, w / 2 - inset),
        ]
        return np.array([(px, py, z) for px, py in pts])

    m = n + 4
    with b.solid("tray"):
        o = outline(0.0, 0.0)
        _tray(b, [o, o + (0, 0, 0.09)], [outline(0.06, 0.09), outline(0.08, 0.05)], white, list(range(m + 1)))
    line = [(-d / 2 + 0.03, -w / 2 + 0.03), *front(0.03), (d / 2 - 0.03, w / 2 - 0.03)]
    t = 0.012
    section = np.array([(-t, -0.015), (t, -0.015), (t, 0.015), (-t, 0.015)])
    groups = ["right pane"] + ["curve"] * n + ["left pane"]
    for z, s in ((0.105, section), (h - 0.015, section)):
        path = [(px, py, z) for px, py in line]
        for k in range(len(path) - 1):
            with b.solid(groups[k] if groups[k] != "curve" else f"curve {k // 5}"):
                b.bar(path[k], path[k + 1], s, metal)
    for k in range(len(line) - 1):
        (ax, ay), (bx, by) = line[k], line[k + 1]
        long = math.hypot(bx - ax, by - ay)
        name = groups[k] if groups[k] != "curve" else f"curve {k // 5}"
        with b.solid(name), b.frame(ax, ay, 0.0, yaw=math.atan2(by - ay, bx - ax)):
            b.box((0.0, long), (-0.004, 0.004), (0.12, h - 0.03), "glass", bevel=0)
            if k in (0, len(line) - 2):
                b.box(
                    (0.0 if k == 0 else long - 0.02, 0.02 if k == 0 else long),
                    (-0.012, 0.012),
                    (0.12, h - 0.03),
                    metal,
                    bevel=0,
                )
                b.box(
                    (long - 0.012, long) if k == 0 else (0.0, 0.012),
                    (-0.012, 0.012),
                    (0.12, h - 0.03),
                    metal,
                    bevel=0,
                )
    a = line[1 + n // 2]
    c = math.sqrt(0.5)
    with b.solid("curve 0"):
        for s in (-1, 1):
            px, py = a[0] + s * 0.04 * c, a[1] + s * 0.04 * c
            b.bar((px, py, 0.12), (px, py, h - 0.03), 0.008, metal, 8)
            b.bar((px, py, 1.0), (px + 0.028 * c, py - 0.028 * c, 1.0), 0.007, metal, 8)
            b.bar((px, py, 1.2), (px + 0.028 * c, py - 0.028 * c, 1.2), 0.007, metal, 8)
            b.bar((px + 0.028 * c, py - 0.028 * c, 0.97), (px + 0.028 * c, py - 0.028 * c, 1.23), 0.008, metal, 8)
    with b.solid("column"):
        b.hull(
            [(-d / 2 + dx, w / 2 - dy, z) for dx, dy in ((0.0, 0.1), (0.1, 0.0), (0.0, 0.0)) for z in (0.72, h - 0.1)],
            b.material("panel", "white plastic"),
        )
    _column(b, -d / 2 + 0.051, w / 2 - 0.051, h - 0.02, metal, yaw=-math.pi / 4)
    b.fit()
