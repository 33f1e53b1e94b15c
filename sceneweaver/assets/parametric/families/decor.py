"""Vases, candles, bowls and trays, frames and bookends."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box
from ...drawing.components import art
from ..builder import Builder
from ..registry import draws
from .lighting_parts import across

_GLAZES = (
    "white ceramic",
    "blue ceramic",
    "terracotta",
    "grey ceramic",
    "cream ceramic",
    "glass",
    "sage paint",
    "dark marble",
    "black paint",
    "rust fabric",
)
_PROFILES = (
    [(0.5, 0.0), (0.56, 0.02), (0.9, 0.3), (1.0, 0.5), (0.86, 0.72), (0.42, 0.88), (0.4, 0.92), (0.52, 1.0)],
    [(0.7, 0.0), (0.74, 0.02), (1.0, 0.18), (0.98, 0.34), (0.55, 0.58), (0.3, 0.72), (0.28, 0.92), (0.4, 1.0)],
    [(0.66, 0.0), (0.7, 0.02), (0.72, 0.5), (0.8, 0.75), (1.0, 1.0)],
    [(0.6, 0.0), (0.64, 0.02), (0.84, 0.22), (1.0, 0.5), (0.96, 0.68), (0.66, 0.86), (0.5, 0.94), (0.58, 1.0)],
    [(0.86, 0.0), (0.92, 0.02), (1.0, 0.1), (1.0, 0.86), (0.9, 0.93), (0.6, 0.96), (0.6, 1.0)],
)


def _vessel(b: Builder, r: float, h: float) -> None:
    look = b.material("glaze", *_GLAZES[:-1])
    profile = [(r * u, h * v) for u, v in b.pick("profile", _PROFILES)]
    lip = profile[-1][0] - max(0.004, 0.04 * r)
    radii, heights = [u for u, _ in profile], [v for _, v in profile]
    rr = float(np.interp(np.linspace(0.86, 1.0, 15) * h, heights, radii).min()) - 0.005
    inner = [(rr, 0.97 * h), (rr, 0.86 * h)]
    with b.solid("vase"):
        b.lathe([*profile, (lip, h), *inner], look, 32, hollow=True)
        if b.chance("band", 0.35) and look.name != "glass":
            (r0, z0), (r1, z1) = profile[1], profile[2]
            b.lathe(
                [(r0 + 0.0004, z0), (r1 + 0.0004, z1)], b.material("band", "brass", "white ceramic", "ink pigment"), 32
            )


@draws("vase")
def vase(b: Builder) -> None:
    """A vase turned in one of five profiles."""
    _vessel(b, across(b) / 2, b.size.height)


@draws("floor_vase")
def floor_vase(b: Builder) -> None:
    """A tall vase for the floor with dry pampas stalks."""
    r, h = across(b) / 2, b.size.height
    from .plants_parts import Clumps, leaves, stem

    tall = h * 0.56
    _vessel(b, r, tall)
    k = Clumps()
    for n in range(7):
        a, u = n * 2.399, 0.55 * r + 0.35 * r * (n % 3) / 2
        tip = np.array([u * math.cos(a), u * math.sin(a), h * (0.98 - 0.03 * n)])
        k.shape(stem([(0.0, 0.0, tall * 0.85), tip * [0.5, 0.5, 0.86], tip * [0.9, 0.9, 0.95]], 0.003, 5), "wicker", n)
        count = 26
        t = np.linspace(0.72, 1.0, count)
        at = np.c_[tip[0] * t, tip[1] * t, tip[2] * (0.78 + 0.2 * (t - 0.72) / 0.28)]
        k.add(
            leaves(at, np.arange(count) * 2.4, 1.1, 0.9, 0.1, 0.018, (0.4, 1, 0.2), 0.0, 0.003, rib=False),
            "sand pigment",
            n,
        )
    with b.solid("stalks"):
        k.draw(b, (-r * 0.95, r * 0.95), (-r * 0.95, r * 0.95), (tall * 0.9, h))


def _flame(b: Builder, z: float, size: float = 0.03) -> None:
    b.bar((0, 0, z - 0.002), (0, 0, z + 0.006), 0.0012, "black plastic", 6)
    b.lathe(
        [(0.001, z + 0.003), (size * 0.24, z + size * 0.4), (size * 0.16, z + size * 0.68), (0.0, z + size)],
        "flame",
        10,
    )


@draws("candle")
def candle(b: Builder) -> None:
    """A pillar candle, or one in a glass or a tin, that burns."""
    r, h = across(b) / 2, b.size.height
    kind = b.pick("kind", ["pillar", "jar", "group"])
    wax = b.material("wax", "candle wax", "white paint", "rose fabric", "sage paint")
    with b.solid("candle"):
        if kind == "jar":
            z = h * 0.8
            b.lathe(
                [(r * 0.94, 0.0), (r, 0.004), (r, z), (r - 0.003, z), (r - 0.003, z * 0.75)],
                b.material("jar", "glass", "grey ceramic", "brass", "white ceramic"),
                28,
                hollow=True,
            )
            b.frustum(r - 0.004, r - 0.004, (0.006, z * 0.76), wax, 24)
            _flame(b, z * 0.76, h - z * 0.76)
        elif kind == "pillar":
            z = h - 0.035
            b.frustum(r, r, (0.0, 0.008), b.material("plate", "brass", "black steel", "oak"), 28, bevel=0.003)
            b.frustum(r * 0.8, r * 0.8, (0.008, z), wax, 24, bevel=0.004)
            _flame(b, z, 0.035)
        else:
            b.frustum(r, r, (0.0, 0.01), b.material("plate", "oak", "marble", "black steel"), 32, bevel=0.003)
            for a, share, size in ((0.4, 1.0, 0.4), (2.5, 0.72, 0.36), (4.6, 0.5, 0.38)):
                z = (h - 0.035) * share
                with b.frame(0.52 * r * math.cos(a), 0.52 * r * math.sin(a)):
                    b.frustum(size * r, size * r, (0.009, z), wax, 20, bevel=0.003)
                    _flame(b, z, 0.035)


@draws("candlestick")
def candlestick(b: Builder) -> None:
    """A turned stick with a slim candle, or an arm with three."""
    r, h = across(b) / 2, b.size.height
    metal = b.material("metal", "brass", "black steel", "chrome", "oak", "copper")
    z = h * b.uniform("stick", 0.45, 0.58)
    with b.solid("candlestick"):
        b.lathe(
            [
                (r, 0.0),
                (r, 0.006),
                (r * 0.82, 0.014),
                (r * 0.3, 0.03),
                (r * 0.18, z * 0.35),
                (r * 0.34, z * 0.45),
                (r * 0.2, z * 0.55),
                (r * 0.16, z * 0.85),
                (r * 0.44, z * 0.94),
                (r * 0.44, z),
            ],
            metal,
            28,
        )
        top = h - 0.03
        b.frustum(0.011, 0.009, (z - 0.005, top), b.material("candle", "candle wax", "white paint", "red paint"), 14)
        _flame(b, top)


@draws("decorative_bowl")
def decorative_bowl(b: Builder) -> None:
    """A wide bowl on a foot ring, empty or with wooden balls."""
    r, h = across(b) / 2, b.size.height
    look = b.material("bowl", *_GLAZES[:5], "oak", "walnut", "brass")
    low = h * 0.86
    with b.solid("bowl"):
        outer = [(r * 0.36, 0.0), (r * 0.38, h * 0.08), (r * 0.72, low * 0.4), (r * 0.93, low * 0.78), (r, low)]
        inner = [(r - 0.005, low), (r * 0.9, low * 0.78), (r * 0.68, low * 0.44), (r * 0.3, h * 0.16)]
        b.lathe([*outer, *inner], look, 36, hollow=True)
        ball = b.material("balls", "moss pigment", "brass", "bark", "walnut")  # pale ones look like eggs
        k = r * 0.3
        for a in (0.3, 2.4, 4.5):
            b.ball((k, k, k), (k * 1.2 * math.cos(a), k * 1.2 * math.sin(a), h - k - 0.006), ball, 14)
        b.ball((k * 0.7, k * 0.7, k * 0.7), (0.0, 0.0, h - k * 0.7), ball, 14)


@draws("decorative_tray")
def decorative_tray(b: Builder) -> None:
    """A tray with a rim and two handles."""
    d, w, h = b.size
    look = b.material("tray", "walnut", "oak", "white paint", "black paint", "rattan", "marble")
    metal = b.material("handles", "brass", "black steel", "copper")
    lip = h * 0.62
    with b.solid("tray"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.008), look, bevel=0.002)
    for s in (-1, 1):
        x = sorted((s * (d / 2 - 0.008), s * d / 2))
        y = sorted((s * (w / 2 - 0.008), s * w / 2))
        with b.solid(f"long rim {s}"):
            b.box((x[0], x[1]), (-w / 2, w / 2), (0.006, lip), look, bevel=0.002)
        with b.solid(f"rim {s}"):
            b.box((-d / 2 + 0.008, d / 2 - 0.008), (y[0], y[1]), (0.006, lip), look, bevel=0.002)
            c = s * (w / 2 - 0.004)
            b.tube(
                [
                    (-d * 0.2, c, lip - 0.004),
                    (-d * 0.18, c, h - 0.0045),
                    (d * 0.18, c, h - 0.0045),
                    (d * 0.2, c, lip - 0.004),
                ],
                0.0038,
                metal,
                8,
            )
    b.surface("top", (-d / 2 + 0.012, d / 2 - 0.012), (-w / 2 + 0.012, w / 2 - 0.012), 0.008)


@draws("picture_frame")
def picture_frame(b: Builder) -> None:
    """A small framed photograph that leans on its own foot."""
    d, w, h = b.size
    wood = b.material("frame", "brass", "oak", "black paint", "white paint", "walnut", "chrome")
    rng = np.random.default_rng(b.whole("art", 0, 2**31 - 1))
    lean = math.atan2(d * 0.42, h)
    thick, bar = 0.014, b.uniform("bar", 0.012, 0.02)
    tall = (h - thick * math.sin(lean)) / math.cos(lean)
    with b.solid("frame"):
        with b.frame(d / 2 - thick, 0.0, 0.0, pitch=-lean):
            x = (0.0, thick)
            b.box(x, (-w / 2, w / 2), (0.0, bar), wood)
            b.box(x, (-w / 2, w / 2), (tall - bar, tall), wood)
            b.box(x, (-w / 2, -w / 2 + bar), (bar, tall - bar), wood)
            b.box(x, (w / 2 - bar, w / 2), (bar, tall - bar), wood)
            y, z = (-w / 2 + bar, w / 2 - bar), (bar, tall - bar)
            sheet = b.box(Box((0.0, thick * 0.5), y, z), "paper", bevel=0.0)
            art(b, sheet.front(-0.003).inset(y=0.014, z=0.014), rng, b.pick("photo", ["hills", "sea", "leaves"]))
        top = h * 0.6
        foot, head = -d / 2 + 0.004, d / 2 - thick - math.tan(lean) * top
        b.hull(
            [(xx + u, v, zz) for xx, zz in ((foot, 0.0), (head, top)) for u in (-0.003, 0.003) for v in (-0.02, 0.02)],
            "black paint",
        )


@draws("bookend")
def bookend(b: Builder) -> None:
    """An angle with a weight on it: an arch, a ball on steps, or a block cut aslant."""
    d, w, h = b.size
    look = b.material("body", "marble", "brass", "black steel", "walnut", "concrete", "dark marble")
    kind = b.pick("kind", ["arch", "ball", "wedge"])
    with b.solid("bookend"):
        if kind == "ball":
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.016), look)
            b.box((-d / 2, d / 2), (-w / 2, -w / 2 + 0.014), (0.016, h), look)
            r = min(d / 2, (w - 0.016) / 2) * 0.94
            b.ball((r, r, r), (0.0, -w / 2 + 0.014 + r, 0.015 + r), b.material("ball", "brass", "marble", "oak"), 20)
        elif kind == "wedge":
            b.hull(
                [
                    (x, y, z)
                    for x in (-d / 2, d / 2)
                    for y, z in ((-w / 2, 0), (w / 2, 0), (-w / 2, h), (-w / 2 + 0.03, h), (w / 2, h * 0.3))
                ],
                look,
            )
        else:
            b.box((-d / 2, d / 2), (-w / 2, -w / 2 + 0.02), (0.0, h), look)
            a = np.linspace(0, np.pi / 2, 9)
            r0, r1 = w - 0.02, (w - 0.02) * 0.5
            high = h * 0.92
            for p, q in zip(a[:-1], a[1:], strict=True):
                b.hull(
                    [
                        (x, -w / 2 + 0.02 + r * math.cos(t), high * r / r0 * math.sin(t))
                        for x in (-d / 2 + 0.01, d / 2 - 0.01)
                        for r in (r0, r1)
                        for t in (p, q)
                    ],
                    look,
                )
