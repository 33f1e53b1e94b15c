"""Buffets, salad bars, signs, trolleys and beer taps."""

from __future__ import annotations

import math

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import castors, loft, oval


def _warmer(b: Builder, x: float, y: float, z: float, h: float, wide: float, deep: float, metal, dome: bool) -> None:
    """A chafing dish: frame, burner, water pan, and a lid with a grip up to height h."""
    with b.frame(x, y, z):
        for s in (-1, 1):
            for t in (-1, 1):
                b.box(
                    (s * (deep / 2 - 0.015) - 0.008, s * (deep / 2 - 0.015) + 0.008),
                    (t * (wide / 2 - 0.02) - 0.008, t * (wide / 2 - 0.02) + 0.008),
                    (0.0, 0.12),
                    metal,
                    bevel=0,
                )
        b.box((-deep / 2 + 0.02, deep / 2 - 0.02), (-wide / 2 + 0.02, wide / 2 - 0.02), (0.02, 0.028), metal, bevel=0)
        for t in (-1, 1):
            with b.frame(0.0, t * wide * 0.22, 0.027):
                b.frustum(0.04, 0.036, (0.0, 0.05), "copper", segments=14)
        b.box(
            (-deep / 2 + 0.01, deep / 2 - 0.01), (-wide / 2 + 0.012, wide / 2 - 0.012), (0.1, 0.16), metal, bevel=0.006
        )
        b.box((-deep / 2, deep / 2), (-wide / 2, wide / 2), (0.155, 0.168), metal, bevel=0.003)
        p = 5.0 if not dome else 2.6
        zl = 0.168
        up = h - z - zl - 0.03
        rings = [
            oval(deep / 2 * s, wide / 2 * s, zl + up * f, power=p)
            for s, f in ((0.96, 0.0), (0.94, 0.35), (0.8, 0.75), (0.55, 1.0))
        ]
        loft(b, rings, metal, whole=True)
        b.bar((0.0, -0.05, zl + up + 0.02), (0.0, 0.05, zl + up + 0.02), 0.009, "black plastic", 8)
        for t in (-1, 1):
            b.bar((0.0, t * 0.045, zl + up - 0.01), (0.0, t * 0.045, zl + up + 0.02), 0.006, "black plastic", 6)


@draws("buffet_table")
def buffet_table(b: Builder) -> None:
    """A clothed table with two or three food warmers in a row, and room for plates at both ends and in front."""
    d, w, h = b.size
    cloth = b.material(
        "cloth", "white fabric", "navy fabric", "black fabric", "red fabric", "beige fabric", "green fabric"
    )
    metal = b.material("warmers", "chrome", "brushed steel", "brass", "steel")
    z = 0.84
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    n = 2 if w < 2.0 else 3
    with b.solid("table"):
        b.box((x[0] + 0.025, x[1] - 0.025), (y[0] + 0.025, y[1] - 0.025), (0.0, z - 0.004), cloth, bevel=0.01)
        # Folds of the skirt.
        for s in (-1, 1):
            m = int(w / 0.09)
            for k in range(m):
                a = y[0] + 0.04 + (k + 0.5) * (w - 0.08) / m
                b.hull(
                    [
                        (s * (d / 2 - 0.026 + o), a + q, v)
                        for o, q in ((0.0, -0.028), (0.0, 0.028), (0.014, 0.0))
                        for v in (0.004, z - 0.05)
                    ],
                    cloth,
                )
            m = int(d / 0.09)
            for k in range(m):
                a = x[0] + 0.04 + (k + 0.5) * (d - 0.08) / m
                b.hull(
                    [
                        (a + q, s * (w / 2 - 0.026 + o), v)
                        for o, q in ((0.0, -0.028), (0.0, 0.028), (0.014, 0.0))
                        for v in (0.004, z - 0.05)
                    ],
                    cloth,
                )
        over = (
            "white fabric"
            if cloth.name != "white fabric"
            else b.material("runner", "red fabric", "navy fabric", "mustard fabric")
        )
        b.box(x, y, (z - 0.06, z), over, bevel=0.006)
    room = w - 0.66
    wide = min(0.56, room / n - 0.06)
    for k in range(n):
        with b.solid(f"warmer {k}"):
            _warmer(b, -0.1, (k - (n - 1) / 2) * room / n, z, h, wide, 0.37, metal, b.style in ("classic", "rustic"))
    plates = y[0] + 0.17
    with b.solid("plates"):
        for s in (0, 1):
            with b.frame(-0.16 + 0.3 * s, plates, z):
                b.frustum(0.075, 0.13, (0.0, 0.012), "white ceramic", segments=24)
                for k in range(1, 9):
                    b.frustum(0.128, 0.13, (0.0005 + k * 0.0115, 0.0115 + k * 0.0115), "white ceramic", segments=24)
    b.surface("front", (0.11, x[1] - 0.02), (y[0] + 0.33, y[1] - 0.02), z)
    b.surface("end", (x[0] + 0.02, 0.105), (y[1] - 0.31, y[1] - 0.02), z)
    b.fit()


@draws("salad_bar")
def salad_bar(b: Builder) -> None:
    """A panelled counter with a cold well of pans under a glass guard on posts, and a tray rail in front."""
    d, w, h = b.size
    body = b.material("body", "oak", "walnut", "white paint", "sage paint", "brushed steel", "light oak")
    rail = 0.14
    x, y = (-d / 2, d / 2 - rail), (-w / 2, w / 2)
    z = 0.86
    with b.solid("body"):
        b.box((x[0] + 0.05, x[1] - 0.05), (y[0] + 0.05, y[1] - 0.05), (0.0, 0.1), "black plastic", bevel=0)
        b.box((x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), (0.1, z - 0.06), body, bevel=0.002)
        n = max(3, round(w / 0.45))
        for k in range(n):
            a, c = y[0] + 0.02 + k * (w - 0.04) / n, y[0] + 0.02 + (k + 1) * (w - 0.04) / n
            b.box((x[1] - 0.011, x[1] - 0.002), (a + 0.015, c - 0.015), (0.14, z - 0.1), body, bevel=0.005)
        b.box((x[0], x[0] + 0.07), y, (z - 0.06, z), "brushed steel", bevel=0)
        b.box((x[1] - 0.07, x[1]), y, (z - 0.06, z), "brushed steel", bevel=0)
        for s in (-1, 1):
            b.box(
                (x[0] + 0.07, x[1] - 0.07),
                (s * (w / 2 - 0.035) - 0.035, s * (w / 2 - 0.035) + 0.035),
                (z - 0.06, z),
                "brushed steel",
                bevel=0,
            )
        foods = (
            "lettuce",
            "tomato",
            "carrot",
            "cheese",
            "egg shell",
            "green apple",
            "aubergine",
            "bread crust",
            "grape",
            "lemon peel",
        )
        cols = max(3, round((w - 0.14) / 0.34))
        wide, deep = (w - 0.14) / cols, (x[1] - x[0] - 0.14) / 2
        first = b.whole("first", 0, 9)
        for i in range(2):
            for j in range(cols):
                px, py = x[0] + 0.07 + i * deep, y[0] + 0.07 + j * wide
                look = foods[(first + i * 4 + j * 3) % 10]
                b.box((px, px + deep), (py, py + wide), (z - 0.06, z - 0.045), "steel", bevel=0)
                b.box((px, px + deep), (py, py + 0.008), (z - 0.045, z - 0.002), "steel", bevel=0)
                b.box((px, px + 0.008), (py + 0.008, py + wide), (z - 0.045, z - 0.002), "steel", bevel=0)
                b.cushion(
                    (px + 0.012, px + deep - 0.004),
                    (py + 0.012, py + wide - 0.004),
                    (z - 0.05, z - 0.002),
                    look,
                    0.02,
                    0.35,
                )
                for k in range(6):
                    qx, qy = px + deep * (0.25 + 0.25 * (k % 3)), py + wide * (0.3 + 0.4 * (k // 3))
                    b.ball((0.028, 0.032, 0.016), (qx + 0.01 * ((k * 7) % 3 - 1), qy, z - 0.003), look, 6)
    for k in range(3):
        px = x[1] + 0.03 + k * 0.048
        b.bar((px, y[0] + 0.02, z - 0.07), (px, y[1] - 0.02, z - 0.07), 0.012, "chrome", 8)
    with b.solid("rail"):
        for s in (-1, 1):
            b.hull(
                [
                    (px, s * w * 0.36 + o, v)
                    for px, v in (
                        (x[1] - 0.012, z - 0.1),
                        (x[1] - 0.012, z - 0.2),
                        (d / 2 - 0.014, z - 0.082),
                        (d / 2 - 0.014, z - 0.1),
                    )
                    for o in (-0.012, 0.012)
                ],
                "brushed steel",
            )
    with b.solid("guard"):
        m = (x[0] + x[1]) / 2
        for s in (-1, 1):
            for t in (-1, 1):
                b.bar(
                    (m + t * 0.02, s * (w / 2 - 0.035), z - 0.01),
                    (m + t * 0.02, s * (w / 2 - 0.035), h - 0.03),
                    0.012,
                    "chrome",
                    10,
                )
        b.box((m - 0.17, m + 0.17), y, (h - 0.03, h), body, bevel=0.003)
        b.box((m - 0.03, m + 0.03), (y[0] + 0.06, y[1] - 0.06), (h - 0.034, h - 0.028), "lamp glow", bevel=0)
        for t in (-1, 1):
            b.hull(
                [
                    (m + t * px, py, v)
                    for px, v in ((0.155, h - 0.03), (0.161, h - 0.03), (0.305, h - 0.2), (0.311, h - 0.2))
                    for py in (y[0] + 0.02, y[1] - 0.02)
                ],
                "glass",
            )
    b.fit()


@draws("menu_board")
def menu_board(b: Builder) -> None:
    """Two framed blackboards hinged at their tops, with chalk writing, held apart by chains."""
    d, w, h = b.size
    wood = b.material("frame", "oak", "pine", "walnut", "beech", "black paint", "white paint")
    lean = math.atan2(d / 2 - 0.028, h)
    long = (h - 0.004) / math.cos(lean) - 0.02
    for s in (1, -1):
        with b.solid(f"board {s}"), b.frame(s * 0.004, 0.0, h - 0.002, yaw=0.0 if s > 0 else math.pi, pitch=-lean):
            y = (-w / 2, w / 2)
            f, x = 0.05, (0.0, 0.022)
            b.box(x, y, (-0.06, 0.0), wood, bevel=0.003)
            b.box(x, y, (-long + 0.08, -long + 0.13), wood, bevel=0.003)
            for t in (-1, 1):
                ys = (y[0], y[0] + f) if t < 0 else (y[1] - f, y[1])
                b.box(x, ys, (-long, -0.06), wood, bevel=0.003)
            top, low = -0.06, -long + 0.13
            b.box((0.006, 0.014), (y[0] + f, y[1] - f), (low, top), "ink pigment", bevel=0)
            c = 0.0145
            wide = w / 2 - f - 0.04
            b.box((0.0135, c), (-wide * 0.7, wide * 0.7), (top - 0.085, top - 0.055), "chalk pigment", bevel=0)
            b.box((0.0135, c), (-wide * 0.4, wide * 0.4), (top - 0.108, top - 0.103), "ochre pigment", bevel=0)
            rows = 6
            for k in range(rows):
                z = top - 0.16 - k * (top - low - 0.24) / rows
                name = 0.55 + 0.4 * b.uniform(f"long {s} {k}", 0.0, 1.0)
                b.box((0.0135, c), (-wide, -wide + name * wide), (z, z + 0.014), "chalk pigment", bevel=0)
                b.box(
                    (0.0135, c),
                    (wide * 0.72, wide),
                    (z, z + 0.014),
                    "ochre pigment" if k % 2 else "chalk pigment",
                    bevel=0,
                )
            # A cup in chalk.
            z = low + 0.03
            b.hull(
                [
                    (px, q, v)
                    for px in (0.0135, c)
                    for q, v in ((-0.022, z), (0.022, z), (0.034, z + 0.045), (-0.034, z + 0.045))
                ],
                "chalk pigment",
            )
    z = 0.35 * h
    half = (h - z) * math.tan(lean) - 0.004
    with b.solid("board 1"):
        for t in (-1, 1):
            b.bar((-half, t * (w / 2 - 0.025), z), (half, t * (w / 2 - 0.025), z), 0.003, "brass", 6)
    b.clear((-half, half), (-w / 2, w / 2), (0.0, z))
    b.fit()


@draws("serving_trolley")
def serving_trolley(b: Builder) -> None:
    """Two or three trays in a frame of tube, with a push bar and four wheels."""
    d, w, h = b.size
    metal = b.material("frame", "brass", "black steel", "chrome", "copper", "white steel")
    board = b.material("trays", "glass", "walnut", "oak", "marble", "mirror", "black glass")
    r = 0.011
    x, y = (-d / 2 + r, d / 2 - r), (-w / 2 + r + 0.01, w / 2 - r - 0.10)
    zs = (0.16, h - 0.12) if h < 0.85 else (0.15, 0.15 + (h - 0.28) / 2, h - 0.13)
    for i, py in enumerate(y):
        with b.solid(f"end {i}"):
            for px in x:
                b.bar((px, py, 0.085), (px, py, zs[-1] + 0.045), r, metal, 10)
            if i == 1:
                for px in x:
                    b.tube([(px, py, zs[-1] + 0.03), (px, py + 0.03, h - 0.03), (px, w / 2 - r, h - r)], r, metal, 10)
                b.bar((x[0] - r, w / 2 - r, h - r), (x[1] + r, w / 2 - r, h - r), r, metal, 10)
    for k, z in enumerate(zs):
        with b.solid(f"tray {k}"):
            b.box((x[0], x[1]), (y[0], y[1]), (z - 0.012, z), board, bevel=0.001)
            for px in x:
                b.box((px - 0.008, px + 0.008), y, (z - 0.02, z - 0.004), metal, bevel=0)
            for py in y:
                b.box(x, (py - 0.008, py + 0.008), (z - 0.02, z - 0.004), metal, bevel=0)
        for i, px in enumerate(x):
            with b.solid(f"rail {i} {k}" if len(zs) < 3 else f"tray {k}"):
                if len(zs) < 3:
                    b.bar((px, y[0], z + 0.04), (px, y[1], z + 0.04), 0.005, metal, 6)
        up = None if k == len(zs) - 1 else round(zs[k + 1] - 0.025 - z, 3)
        b.surface(f"shelf-{k}" if up else "top", (x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), z, headroom=up)
    with b.solid("tray 0"):
        castors(b, x, y, 0.09, 0.035, metal)
        for px in x:
            for py in y:
                b.bar((px, py, 0.08), (px, py, zs[0]), r, metal, 10)
    b.fit()


@draws("beer_tap")
def beer_tap(b: Builder) -> None:
    """A column or a bridge with two to four taps and tall handles, and a drip tray below."""
    d, w, h = b.size
    metal = b.material("tower", "chrome", "brass", "copper", "black steel", "brushed steel")
    n = 2 if w < 0.38 else 3 if w < 0.46 else 4
    x = -d / 2 + 0.075
    top = h - 0.14
    span = 0.085 * (n - 1)
    with b.solid("tap"):
        b.box((-d / 2 + 0.01, d / 2), (-w / 2, w / 2), (0.0, 0.022), "brushed steel", bevel=0.003)
        for k in range(9):
            a = -w / 2 + 0.02 + k * (w - 0.04) / 9
            b.box((x + 0.06, d / 2 - 0.015), (a, a + 0.6 * (w - 0.04) / 9), (0.0215, 0.0245), "black steel", bevel=0)
        r = 0.045
        if n == 2 or b.chance("bridge", 0.5) and n > 2:
            for s in (-1, 1) if n > 2 else (0,):
                with b.frame(x, s * span / 2, 0.0):
                    b.frustum(0.065, 0.055, (0.02, 0.045), metal, segments=24)
                    b.frustum(r * 0.9, r * 0.9, (0.04, top), metal, segments=24)
            b.bar((x, -span / 2 - 0.05, top - 0.01), (x, span / 2 + 0.05, top - 0.01), r, metal, 20)
            for s in (-1, 1):
                b.ball((r, r * 0.6, r), (x, s * (span / 2 + 0.05), top - 0.01), metal, 16)
        else:
            with b.frame(x, 0.0, 0.0):
                b.frustum(0.085, 0.075, (0.02, 0.045), metal, segments=24)
                b.frustum(0.055, 0.055, (0.04, top - 0.06), metal, segments=24)
            b.box(
                (x - 0.045, x + 0.045),
                (-span / 2 - 0.06, span / 2 + 0.06),
                (top - 0.075, top + 0.02),
                metal,
                bevel=0.012,
            )
        colors = ("red plastic", "yellow plastic", "green plastic", "black plastic", "blue plastic", "orange plastic")
        for k in range(n):
            y = (k - (n - 1) / 2) * 0.085
            z = top - 0.015
            b.bar((x + 0.03, y, z), (x + 0.095, y, z), 0.011, "chrome", 10)
            b.bar((x + 0.085, y, z + 0.012), (x + 0.105, y, z - 0.085), 0.009, "chrome", 10)
            look = colors[(k + b.whole("first", 0, 5)) % 6]
            with b.frame(x + 0.085, y, z):
                b.frustum(0.007, 0.007, (0.0, 0.045), "chrome", segments=10)
                up = h - z
                b.lathe([(0.011, 0.04), (0.014, 0.06), (0.021, up - 0.03), (0.018, up - 0.008), (0.008, up)], look, 14)
    b.fit()
