"""Washing, drying and ironing."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import feet, knob, loft, oval, rounded, tap, vessel


@draws("washing_machine", "dryer")
def washing_machine(b: Builder) -> None:
    """A white box with a round glass door, a panel with dial and display, and a drawer or a filter flap."""
    d, w, h = b.size
    dry = b.category.name == "dryer"
    coat = b.material("body", "white paint", "white paint", "white paint", "grey paint", "black paint")
    rim = b.material("rim", "chrome", "black plastic", "grey plastic", "white plastic")
    x, y = (-d / 2, d / 2 - 0.05), (-w / 2, w / 2)
    f = x[1]
    with b.solid("body"):
        feet(b, x, y, 0.015, r=0.022)
        b.box(x, (y[0] + 0.002, y[1] - 0.002), (0.012, h - 0.028), coat, bevel=0.008)
        b.box(x, y, (h - 0.03, h), coat, bevel=0.006)
        top = h - 0.032
        b.box(
            (f - 0.001, f + 0.006),
            (y[0] + 0.004, y[1] - 0.004),
            (top - 0.115, top - 0.004),
            "light grey paint" if coat.name == "white paint" else "black plastic",
            bevel=0.002,
        )
        g = f + 0.006
        if dry:
            b.box(
                (g - 0.001, g + 0.0015), (y[0] + 0.03, y[0] + 0.16), (top - 0.09, top - 0.03), "grey plastic", bevel=0
            )
        else:
            with b.slide("soap drawer", limits=(0.0, 0.15)):
                b.box(
                    (g - 0.0009, g + 0.005), (y[0] + 0.015, y[0] + 0.19), (top - 0.107, top - 0.012), coat, bevel=0.003
                )
                b.box(
                    (g + 0.004, g + 0.012),
                    (y[0] + 0.06, y[0] + 0.145),
                    (top - 0.1, top - 0.085),
                    "grey plastic",
                    bevel=0.002,
                )
        knob(b, g, b.pick("dial", [-0.02, 0.0, 0.02]), top - 0.06, "chrome", 0.033, 0.026)
        b.box((g - 0.001, g + 0.001), (0.07, 0.2), (top - 0.085, top - 0.035), "screen", bevel=0)
        for k in range(3):
            a = 0.215 + k * 0.022
            b.box((g - 0.001, g + 0.003), (a, a + 0.013), (top - 0.066, top - 0.054), "chrome", bevel=0)
        z = 0.46 if not dry else 0.45
        r = b.uniform("door", 0.205, 0.225)
        with b.hinge("door", (f + 0.02, y[1] - 0.06, z), limits=(0.0, 2.2)):
            with b.frame(f, 0.0, z, pitch=math.pi / 2):
                b.lathe([(r, 0.0005), (r, 0.022), (r - 0.015, 0.036), (r - 0.05, 0.04)], rim, segments=40)
                b.lathe(
                    [(r - 0.048, 0.03), (r - 0.052, 0.042), (r - 0.09, 0.049), (r - 0.14, 0.05)],
                    "black glass",
                    segments=36,
                )
            b.box((f + 0.03, f + 0.042), (-r + 0.006, -r + 0.03), (z - 0.05, z + 0.05), "grey plastic", bevel=0.003)
        b.box(
            (f - 0.002, f + 0.002),
            (y[0] + 0.05, y[0] + 0.17),
            (0.05, 0.14),
            "light grey paint" if coat.name == "white paint" else coat,
            bevel=0,
        )
        b.box((f - 0.002, f + 0.0012), (y[0] + 0.003, y[1] - 0.003), (0.028, 0.032), "grey plastic", bevel=0)
    b.surface("top", (x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), h)
    b.fit()


@draws("laundry_sink")
def laundry_sink(b: Builder) -> None:
    """A deep tub on four legs with a wall-high tap and its waste below."""
    d, w, total = b.size
    tub = b.material("tub", "white plastic", "brushed steel", "white ceramic", "grey plastic")
    leg = b.material("legs", "white steel", "steel", "black steel")
    h = 0.86
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    deep = 0.36
    with b.solid("tub"):
        low = rounded((x[0] + 0.05, x[1] - 0.05), (y[0] + 0.05, y[1] - 0.05), 0.04, h - deep)
        outer = [
            low,
            rounded((x[0] + 0.018, x[1] - 0.018), (y[0] + 0.018, y[1] - 0.018), 0.03, h - 0.03),
            rounded(x, y, 0.03, h - 0.03),
            rounded(x, y, 0.03, h),
        ]
        inner = [
            rounded((x[0] + 0.1, x[1] - 0.035), (y[0] + 0.035, y[1] - 0.035), 0.04, h),
            rounded((x[0] + 0.11, x[1] - 0.065), (y[0] + 0.065, y[1] - 0.065), 0.05, h - deep + 0.015),
        ]
        vessel(b, outer, inner, tub, 16)
        with b.frame(0.02, 0.0, h - deep + 0.0145):
            b.frustum(0.035, 0.033, (0.0, 0.004), "chrome", segments=18)
    with b.solid("legs"):
        for sx in (-1, 1):
            for sy in (-1, 1):
                px, py = sx * (d / 2 - 0.055), sy * (w / 2 - 0.055)
                b.bar((px + sx * 0.02, py + sy * 0.02, 0.0), (px, py, h - deep + 0.09), 0.017, leg, 10)
        b.bar((0.02, 0.0, 0.35), (0.02, 0.0, h - deep), 0.02, "white plastic", 12)
        b.tube(
            [(0.02, 0, 0.36), (0.0, 0, 0.31), (-0.05, 0, 0.31), (-0.07, 0, 0.36), (-d / 2 + 0.02, 0, 0.37)],
            0.019,
            "white plastic",
            10,
        )
    tap(b, x[0] + 0.05, 0.0, h, b.material("tap", "chrome", "brass", "brushed steel"), total - h, 0.19)
    b.fit()


@draws("ironing_board")
def ironing_board(b: Builder) -> None:
    """A padded, pointed board on crossed legs, with a rest for the iron at its end."""
    d, w, h = b.size
    cloth = b.material(
        "cover", "blue fabric", "grey fabric", "green fabric", "rose fabric", "mustard fabric", "white fabric"
    )
    metal = b.material("legs", "white steel", "steel", "black steel", "aluminium")
    rest = 0.24
    y0, y1 = -w / 2 + rest, w / 2
    long = y1 - y0
    outline = [
        (-d / 2, y0 + 0.02),
        (-d / 2 + 0.02, y0),
        (d / 2 - 0.02, y0),
        (d / 2, y0 + 0.02),
        (d / 2, y0 + 0.58 * long),
    ]
    tip = [(0.40, 0.74), (0.31, 0.86), (0.2, 0.95), (0.09, 0.99)]
    right = [(s * d, y0 + t * long) for s, t in tip]
    outline += [*right, (0.0, y1), *[(-px, py) for px, py in reversed(right)], (-d / 2, y0 + 0.58 * long)]
    ring = np.array(outline)

    def at(inset: float, z: float) -> np.ndarray:
        m = np.array([0.0, y0 + long / 2])
        s = 1.0 - inset / np.array([d / 2, long / 2])
        return np.c_[m + (ring - m) * s, np.full(len(ring), z)]

    with b.solid("board"):
        loft(b, [at(0.02, h - 0.03), at(0.0, h - 0.022), at(0.0, h - 0.008), at(0.012, h)], cloth, whole=True)
        b.box((-0.1, 0.1), (y0 + 0.05, y1 - 0.35), (h - 0.045, h - 0.028), metal, bevel=0.002)
    with b.solid("rest"):
        for px in (-0.11, 0.11):
            b.bar((px, y0 + 0.08, h - 0.035), (px, -w / 2 + 0.008, h - 0.035), 0.007, metal, 8)
        b.bar((-0.117, -w / 2 + 0.008, h - 0.035), (0.117, -w / 2 + 0.008, h - 0.035), 0.007, metal, 8)
        for k in range(5):
            px = -0.08 + k * 0.04
            b.bar((px, y0 + 0.03, h - 0.032), (px, -w / 2 + 0.01, h - 0.032), 0.004, metal, 6)
        b.box((-0.117, 0.117), (y0 - 0.06, y0 - 0.045), (h - 0.034, h - 0.026), "rubber", bevel=0.001)
    a, c = y0 + 0.06, y1 - 0.38
    with b.solid("legs"):
        for lo, hi, half, foot in ((a, c, 0.08, d / 2 - 0.03), (c + 0.06, a + 0.08, 0.055, 0.17)):
            for s in (-1, 1):
                b.bar((s * half, lo, 0.02), (s * half, hi, h - 0.04), 0.011, metal, 8)
            b.bar((-foot, lo, 0.014), (foot, lo, 0.014), 0.0125, metal, 8)
            for s in (-1, 1):
                b.bar((s * foot - s * 0.03, lo, 0.0145), (s * foot + s * 0.012, lo, 0.0145), 0.0145, "rubber", 8)
        m = (a + c) / 2 + 0.02
        b.bar((-0.09, m, h / 2 - 0.01), (0.09, m, h / 2 - 0.01), 0.008, metal, 8)
    b.surface("top", (-d / 2 + 0.03, d / 2 - 0.03), (y0 + 0.03, y0 + 0.56 * long), h)
    b.fit()


@draws("drying_rack")
def drying_rack(b: Builder) -> None:
    """A winged airer on crossed legs with many rods, and some things hung on it."""
    d, w, h = b.size
    metal = b.material("frame", "white steel", "aluminium", "steel", "black steel")
    half = w * 0.26
    x = d / 2 - 0.012
    zc = h * 0.86
    with b.solid("legs"):
        for s in (-1, 1):
            px = s * (x - 0.025)
            for t in (-1, 1):
                b.bar((px + t * 0.009, -t * half * 1.05, 0.012), (px + t * 0.009, t * half, zc), 0.009, metal, 8)
        for t in (-1, 1):
            b.bar((-x, t * half * 1.05, 0.012), (x, t * half * 1.05, 0.012), 0.012, metal, 8)
            for s in (-1, 1):
                b.bar(
                    (s * x - s * 0.05, t * half * 1.05, 0.013),
                    (s * (x + 0.006), t * half * 1.05, 0.013),
                    0.013,
                    "grey plastic",
                    8,
                )
        b.bar((-x, 0.0, zc / 2 + 0.005), (x, 0.0, zc / 2 + 0.005), 0.007, metal, 8)
    with b.solid("middle"):
        for s in (-1, 1):
            b.bar((s * x, -half, zc), (s * x, half, zc), 0.009, metal, 8)
        for k in range(9):
            py = -half + k * half / 4
            b.bar((-x, py, zc), (x, py, zc), 0.0045, metal, 6)
    for t in (-1, 1):
        with b.solid(f"wing {t}"):
            end = (t * (w / 2 - 0.009), h - 0.009)
            for s in (-1, 1):
                b.bar((s * x, t * half, zc), (s * x, *end), 0.009, metal, 8)
            for k in range(1, 7):
                f = k / 6
                py, pz = t * half + f * (end[0] - t * half), zc + f * (end[1] - zc)
                b.bar((-x, py, pz), (x, py, pz), 0.0045 if k < 6 else 0.009, metal, 6)
            pz = zc - 0.25
            b.bar((-x + 0.02, t * half * 0.72, pz), (-x, t * (w / 2 - 0.2), (zc + h) / 2 - 0.01), 0.005, metal, 6)
    if b.chance("washing", 0.7):
        cloths = ("white fabric", "blue fabric", "rose fabric", "grey fabric", "green fabric")
        for k in range(b.whole("pieces", 2, 4)):
            py = -half + (2 * k + 1) * half / 4
            long = b.uniform(f"long {k}", 0.25, 0.42)
            wide = b.uniform(f"wide {k}", 0.16, 0.23)
            with b.solid("middle"):
                look = b.pick(f"cloth {k}", cloths)
                b.hull(
                    [(s * wide, py + t * 0.009, z) for s in (-1, 1) for t in (-1, 1) for z in (zc - 0.01, zc + 0.006)],
                    look,
                )
                for t, f in ((-1, 1.0), (1, 0.85)):
                    b.box(
                        (-wide, wide),
                        (py + t * 0.007 - 0.003, py + t * 0.007 + 0.003),
                        (zc - long * f, zc - 0.005),
                        look,
                        bevel=0.001,
                    )
    b.fit()


@draws("laundry_basket")
def laundry_basket(b: Builder) -> None:
    """A tapered basket with rows of slots, a rolled rim with grips, and clothes in it."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "grey plastic", "blue plastic", "wicker", "rattan")
    with b.solid("basket"):

        def ring(f: float, z: float, t: float = 0.0):
            return oval(d / 2 * f - t, w / 2 * f - t, z, power=4.0)

        rim = h - 0.05
        vessel(
            b,
            [ring(0.78, 0.0), ring(0.95, rim - 0.03), ring(1.0, rim - 0.025), ring(1.0, rim)],
            [ring(0.93, rim), ring(0.75, 0.012)],
            look,
            32,
        )
        dark = "white plastic" if look.name != "white plastic" else "grey plastic"
        for s in (-1, 1):
            for j in range(2):
                z = 0.06 + j * (rim - 0.11) / 2
                f = 0.78 + 0.17 * (z / (rim - 0.03))
                for k in range(5):
                    a = (k - 2) * w * 0.085
                    b.hull(
                        [
                            (s * (d / 2 * (f + e) + o), a + q * 0.012, z + u)
                            for e, u in ((0.0, 0.0), (0.17 * 0.035 / (rim - 0.03), 0.035))
                            for o in (-0.009, 0.0009)
                            for q in (-1, 1)
                        ],
                        dark,
                    )
        cloths = ("white fabric", "blue fabric", "rose fabric", "mustard fabric", "grey fabric", "green fabric")
        b.cushion((-d * 0.42, d * 0.42), (-w * 0.43, w * 0.43), (0.05, rim - 0.01), "white fabric", radius=0.05)
        spots = ((-0.17, -0.24), (0.14, -0.2), (-0.1, 0.05), (0.16, 0.1), (-0.14, 0.27), (0.13, 0.28))
        for k, (px, py) in enumerate(spots):
            up = h if k == 2 else rim + b.uniform(f"up {k}", 0.012, 0.045)
            with b.frame(px * d, py * w, 0.0):
                b.cushion(
                    (-0.105, 0.105),
                    (-0.11, 0.11),
                    (rim - 0.07, up),
                    b.pick(f"cloth {k}", cloths),
                    radius=0.03,
                    puff=0.4,
                )
    b.fit()


@draws("water_heater")
def water_heater(b: Builder) -> None:
    """A hung drum with domed ends, a dial, a lamp, pipes with a valve below."""
    d, w, h = b.size
    coat = b.material("body", "white steel", "white steel", "brushed steel", "grey paint")
    r = w / 2
    x = d / 2 - r
    z0 = 0.12
    with b.solid("tank"):
        with b.frame(x, 0.0, 0.0):
            b.lathe(
                [
                    (r * 0.55, z0),
                    (r * 0.85, z0 + 0.015),
                    (r * 0.985, z0 + 0.05),
                    (r, z0 + 0.07),
                    (r, h - 0.07),
                    (r * 0.985, h - 0.05),
                    (r * 0.85, h - 0.015),
                    (r * 0.5, h),
                ],
                coat,
                segments=40,
            )
            b.frustum(r * 0.42, r * 0.42, (z0 - 0.025, z0 + 0.005), "grey plastic", segments=24)
        for z in (z0 + 0.14, h - 0.16):
            b.box((-d / 2, x - 0.1), (-w * 0.3, w * 0.3), (z - 0.02, z + 0.02), "steel", bevel=0)
        f = d / 2
        b.box((f - 0.06, f - 0.0005), (-0.062, 0.062), (z0 + 0.09, z0 + 0.2), "grey plastic", bevel=0.01)
        with b.frame(f - 0.0015, -0.02, z0 + 0.135, pitch=math.pi / 2):
            b.frustum(0.024, 0.022, (0.0, 0.0015), "black plastic", segments=18)
        b.box((f - 0.002, f), (0.02, 0.045), (z0 + 0.165, z0 + 0.175), "lamp glow", bevel=0)
        for y, look in ((-0.09, "blue plastic"), (0.09, "red plastic")):
            b.bar((x, y, 0.0), (x, y, z0 + 0.01), 0.011, "copper", 10)
            b.bar((x, y, z0 - 0.03), (x, y, z0 + 0.006), 0.016, look, 10)
        b.bar((x, -0.09, 0.05), (x + 0.04, -0.09, 0.05), 0.01, "brass", 8)
        b.box((x + 0.035, x + 0.047), (-0.105, -0.075), (0.042, 0.058), "red plastic", bevel=0.002)
    b.fit()
