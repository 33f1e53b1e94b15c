"""Vacuum cleaners, mops and cleaning carts."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import castors, egg, loft, oval, vessel


@draws("vacuum_cleaner")
def vacuum_cleaner(b: Builder) -> None:
    """A low body on wheels, a hose that rises to a tube, and a floor head in front."""
    d, w, h = b.size
    body = b.material(
        "body", "red plastic", "blue plastic", "black plastic", "green plastic", "orange plastic", "grey plastic"
    )
    dark = "black plastic"
    x0 = -d / 2
    long = 0.40
    xc = x0 + long / 2
    hw = min(w, 0.28) / 2
    tx = d / 2 - 0.12
    with b.solid("body"):
        n = 28
        loft(
            b,
            [
                egg(long / 2 * 0.96, long / 2 * 0.96, hw * 0.86, 0.03, xc, n=n),
                egg(long / 2 * 0.99, long / 2 * 0.99, hw * 0.95, 0.07, xc, n=n),
                egg(long / 2 * 0.95, long / 2 * 0.97, hw * 0.93, 0.13, xc, n=n),
                egg(long / 2 * 0.7, long / 2 * 0.86, hw * 0.74, 0.19, xc, n=n),
                egg(long / 2 * 0.36, long / 2 * 0.6, hw * 0.45, 0.215, xc, n=n),
            ],
            body,
            whole=True,
        )
        for s in (-1, 1):
            with b.frame(x0 + 0.1, s * (hw - 0.004), 0.085, roll=-s * math.pi / 2):
                b.frustum(0.085, 0.08, (-0.02, 0.016), dark, segments=24, bevel=0.006)
                b.frustum(0.05, 0.048, (0.015, 0.021), "grey plastic", segments=20)
        with b.frame(x0 + long - 0.06, 0.0, 0.0):
            b.frustum(0.02, 0.03, (0.0, 0.04), dark, segments=14)
        b.tube([(xc - 0.13, 0, 0.2), (xc - 0.11, 0, 0.24), (xc - 0.02, 0, 0.245), (xc + 0.03, 0, 0.21)], 0.012, dark, 8)
        for s in (-1, 1):
            with b.frame(xc - 0.14, s * 0.045, 0.195):
                b.frustum(0.018, 0.016, (0.0, 0.014), "grey plastic", segments=12)
    with b.solid("tube"):
        hx = x0 + long - 0.01
        b.bar((hx - 0.05, 0, 0.13), (hx, 0, 0.14), 0.03, dark, 12)
        hose = [
            (hx - 0.01, 0, 0.14),
            (hx + 0.03, -0.03, 0.25),
            (hx - 0.02, -0.06, 0.45),
            (hx - 0.1, -0.06, 0.7),
            (hx - 0.06, -0.03, h - 0.07),
            (hx, 0.0, h - 0.03),
            (hx + 0.06, 0.0, h - 0.09),
        ]
        b.tube(hose, 0.02, dark, 10)
        top = (hx + 0.05, 0.0, h - 0.07)
        b.bar((tx, 0, 0.08), top, 0.0165, "chrome", 12)
        at = [t + 0.18 * (u - t) for t, u in zip(top, (tx, 0, 0.08), strict=True)]
        b.bar(top, at, 0.022, dark, 12)
    with b.solid("head"):
        b.box((tx - 0.05, d / 2), (-w / 2, w / 2), (0.008, 0.045), dark, bevel=0.012)
        b.box((tx - 0.045, d / 2 - 0.005), (-w / 2 + 0.005, w / 2 - 0.005), (0.0, 0.015), "grey plastic", bevel=0)
        b.bar((tx + 0.03, 0, 0.035), (tx - 0.004, 0, 0.11), 0.026, dark, 12)
    b.fit()


@draws("mop_bucket")
def mop_bucket(b: Builder) -> None:
    """A bucket with a wringer and a bail, water in it, and a mop that stands in it."""
    d, w, h = b.size
    look = b.material("bucket", "yellow plastic", "blue plastic", "red plastic", "grey plastic", "green plastic")
    pole = b.material("pole", "beech", "aluminium", "blue plastic")
    top = 0.32
    wheels = b.chance("wheels", 0.5)
    low = 0.06 if wheels else 0.0
    with b.solid("bucket"):

        def ring(f: float, z: float):
            return oval(d / 2 * f, w / 2 * f, z, power=3.0)

        vessel(
            b,
            [ring(0.74, low), ring(0.95, top - 0.025), ring(1.0, top - 0.02), ring(1.0, top)],
            [ring(0.93, top), ring(0.71, low + 0.012)],
            look,
        )
        loft(b, [ring(0.72, low + 0.01), ring(0.81, low + 0.13)], "blue ceramic", whole=True)
        if wheels:
            castors(b, (-d * 0.27, d * 0.27), (-w * 0.27, w * 0.27), low + 0.004, 0.026)
        # The wringer on one end.
        y = w / 2 * 0.42
        for k in range(6):
            px = -d * 0.3 + k * d * 0.12
            b.hull(
                [
                    (px + s * 0.012, py, z)
                    for s in (-1, 1)
                    for py, z in (
                        (y, top - 0.02),
                        (w * 0.44, top - 0.02),
                        (y + 0.02, top - 0.12),
                        (w * 0.36, top - 0.12),
                    )
                ],
                "grey plastic",
            )
        b.box((-d * 0.36, d * 0.36), (y - 0.012, y + 0.006), (top - 0.03, top + 0.012), "grey plastic", bevel=0.003)
        b.box((-d * 0.36, d * 0.36), (w * 0.425, w * 0.45), (top - 0.02, top + 0.012), "grey plastic", bevel=0.003)
        hoop = [
            (
                -d / 2 + 0.008 + (d - 0.016) * (0.5 - 0.5 * math.cos(t)),
                -w * 0.1 - 0.12 * math.sin(t),
                top - 0.01 + 0.1 * math.sin(t),
            )
            for t in np.linspace(0, math.pi, 8)
        ]
        b.tube(hoop, 0.005, "steel", 6)
    foot, head = np.array([0.0, -w * 0.14, low + 0.15]), np.array([-d * 0.2, -w * 0.34, h - 0.012])
    with b.solid("mop"):
        b.bar(foot, head, 0.0125, pole, 12)
        b.ball((0.015, 0.015, 0.0145), tuple(head - (0, 0, 0.0015)), "grey plastic", 12)
        with b.frame(0.0, -w * 0.14, 0.0):
            b.lathe([(0.105, low + 0.1), (0.085, low + 0.17), (0.035, low + 0.26)], "white fabric", segments=18)
            b.frustum(0.032, 0.02, (low + 0.24, low + 0.33), look, segments=14)
            for k in range(12):
                a = k * math.pi / 6
                c, s = math.cos(a), math.sin(a)
                b.bar((0.03 * c, 0.03 * s, low + 0.255), (0.1 * c, 0.1 * s, low + 0.12), 0.011, "white fabric", 6)
    b.fit()


@draws("cleaning_cart")
def cleaning_cart(b: Builder) -> None:
    """A cart with shelves of bottles and cloths, a waste sack at one end, a broom and castors."""
    d, w, h = b.size
    body = b.material("body", "grey plastic", "blue plastic", "black plastic", "green plastic")
    sack = b.material("sack", "yellow plastic", "green plastic", "navy fabric", "red plastic")
    x, y0 = d / 2, -w / 2
    cut = w / 2 - 0.40
    ys = (y0, cut)
    zs = (0.16, 0.50, h - 0.16)
    for k, z in enumerate(zs):
        with b.solid("base" if k == 0 else f"shelf {k}"):
            b.box((-x, x), ys if k else (y0, w / 2 - 0.02), (z - 0.035, z), body, bevel=0.005)
    with b.solid("end"):
        for s in (-1, 1):
            b.box(
                (s * (x - 0.03) - 0.018, s * (x - 0.03) + 0.018),
                (y0 + 0.02, y0 + 0.05),
                (0.16, h - 0.19),
                "grey plastic",
            )
    with b.solid("wall"):
        b.box((-x + 0.01, x - 0.01), (cut - 0.025, cut), (0.16, h - 0.19), body, bevel=0.003)
    with b.solid("base"):
        castors(b, (-x + 0.05, x - 0.05), (y0 + 0.07, w / 2 - 0.1), 0.127, 0.05)
    with b.solid("sack"):
        m, hw = (cut + w / 2 - 0.02) / 2 + 0.01, (w / 2 - cut) / 2 - 0.035
        rings = [
            oval(0.16, hw * 0.86, 0.16, 0, m, 3.0, 20),
            oval(0.19, hw * 0.98, 0.4, 0, m, 3.0, 20),
            oval(0.19, hw * 0.95, h - 0.16, 0, m, 4.0, 20),
        ]
        loft(b, rings, sack)
        loft(b, [oval(0.2, hw, h - 0.17, 0, m, 4.0, 20), oval(0.2, hw, h - 0.135, 0, m, 4.0, 20)], body, whole=True)
        b.bar((-0.2, w / 2 - 0.012, h - 0.012), (0.2, w / 2 - 0.012, h - 0.012), 0.012, "grey plastic", 10)
        for s in (-1, 1):
            b.bar((s * 0.19, w / 2 - 0.012, h - 0.012), (s * 0.19, m + 0.05, h - 0.15), 0.011, "grey plastic", 8)
    with b.solid("bottles"):
        tools = ("red plastic", "yellow plastic", "blue plastic", "green plastic", "pink plastic")
        z = zs[2]
        for k in range(4):
            with b.frame(-x + 0.09, y0 + 0.09 + 0.085 * k, z):
                b.lathe([(0.03, 0.0), (0.03, 0.09), (0.012, 0.125)], tools[k % 5], segments=12)
                b.frustum(0.013, 0.013, (0.12, 0.145), "white plastic", segments=8)
                b.box((-0.012, 0.035), (-0.008, 0.008), (0.138, 0.158), "red plastic", bevel=0.002)
    with b.solid("shelf 1"):
        z = zs[1]
        for k in range(4):
            b.cushion(
                (-0.18, 0.02),
                (y0 + 0.09, y0 + 0.34),
                (z + k * 0.035, z + (k + 1) * 0.035),
                "white fabric" if k % 2 else "blue fabric",
                radius=0.012,
            )
        for k in range(3):
            with b.frame(-0.08 + 0.09 * k, cut - 0.1, z):
                r, up = (0.04, 0.19) if k == 1 else (0.05, 0.1)
                b.frustum(r, r, (0.0, up), "paper", segments=16)
    b.surface("top", (-x + 0.16, x - 0.03), (y0 + 0.03, cut - 0.03), zs[2], headroom=None)
    b.surface("shelf-0", (-x + 0.04, x - 0.04), (y0 + 0.07, cut - 0.04), zs[0], headroom=round(zs[1] - 0.04 - zs[0], 3))
    b.fit()
