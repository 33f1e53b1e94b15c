"""Bars, cafes and restaurants: counters, display cases, espresso machines, tills, host stands."""

from __future__ import annotations

import math

from ..builder import Builder
from ..registry import draws

_WOODS = ("oak", "walnut", "mahogany", "wenge", "cherry", "light oak", "ash grey wood", "pine")


@draws("bar_counter")
def bar_counter(b: Builder) -> None:
    """A front of panels or battens under a broad top, a foot rail on brackets, a lower worktop and shelves behind."""
    d, w, h = b.size
    wood = b.material("front", *_WOODS, "navy paint", "teal paint", "black paint", "white paint")
    top = b.material("top", "walnut", "oak", "marble", "dark marble", "granite", "mahogany", "copper")
    rail = b.material("rail", "brass", "steel", "black steel")
    # Guests stand at +x, the keeper at -x.
    y = (-w / 2, w / 2)
    f = d / 2 - 0.16
    back = -d / 2
    t = 0.045
    with b.solid("front"):
        b.box((f - 0.03, f), (y[0] + 0.02, y[1] - 0.02), (0.0, h - t), wood, bevel=0.001)
        b.box((f - 0.001, f + 0.012), (y[0] + 0.02, y[1] - 0.02), (0.0, 0.1), wood, bevel=0.002)
        b.box((f - 0.001, f + 0.012), (y[0] + 0.02, y[1] - 0.02), (h - t - 0.08, h - t), wood, bevel=0.002)
        if b.style in ("classic", "rustic"):
            n = max(3, round(w / 0.55))
            step = (w - 0.04) / n
            for k in range(n + 1):
                a = min(max(y[0] + 0.02 + k * step, y[0] + 0.055), y[1] - 0.055)
                b.box((f - 0.001, f + 0.014), (a - 0.035, a + 0.035), (0.1, h - t - 0.08), wood, bevel=0.002)
                if k < n:
                    m = y[0] + 0.02 + (k + 0.5) * step
                    b.box(
                        (f - 0.001, f + 0.009),
                        (m - step / 2 + 0.075, m + step / 2 - 0.075),
                        (0.15, h - t - 0.13),
                        wood,
                        bevel=0.007,
                    )
        else:
            n = round(w / 0.07)
            step = (w - 0.04) / n
            for k in range(n):
                a = y[0] + 0.02 + (k + 0.5) * step
                b.box((f - 0.001, f + 0.018), (a - 0.016, a + 0.016), (0.1, h - t - 0.08), wood, bevel=0)
        zr, xr = 0.2, f + 0.1
        b.bar((xr, y[0] + 0.06, zr), (xr, y[1] - 0.06, zr), 0.022, rail, 12)
        for s in (-1, 1):
            b.ball((0.03, 0.03, 0.03), (xr, s * (w / 2 - 0.055), zr), rail, 12)
        for k in range(max(2, round(w / 0.8)) + 1):
            a = y[0] + 0.14 + k * (w - 0.28) / max(2, round(w / 0.8))
            b.tube([(f, a, zr - 0.04), (f + 0.05, a, zr - 0.05), (xr, a, zr - 0.015)], 0.011, rail, 8)
    with b.solid("top"):
        b.box((f - 0.22, d / 2), y, (h - t, h), top, bevel=0.006)
    hw = 0.88
    inner = (back + 0.03, f - 0.03)
    with b.solid("worktop"):
        b.box((back, f - 0.03), (y[0] + 0.02, y[1] - 0.02), (hw - 0.03, hw), "brushed steel", bevel=0.002)
    for s, name in ((-1, "right"), (1, "left")):
        with b.solid(name):
            ys = (y[0] + 0.02, y[0] + 0.045) if s < 0 else (y[1] - 0.045, y[1] - 0.02)
            b.box(inner, ys, (0.0, hw - 0.03), wood, bevel=0.001)
            b.box((f - 0.2, f - 0.03), ys, (hw, h - t), wood, bevel=0.001)
    for k, z in enumerate((0.12, 0.48)):
        with b.solid(f"shelf {k}"):
            b.box(inner, (y[0] + 0.045, y[1] - 0.045), (z - 0.022, z), wood, bevel=0.001)
        up = (0.48 - 0.025 if k == 0 else hw - 0.035) - z
        b.surface(
            f"shelf-{k}", (inner[0] + 0.01, inner[1] - 0.01), (y[0] + 0.06, y[1] - 0.06), z, headroom=round(up, 3)
        )
    b.surface("worktop", (back + 0.01, f - 0.24), (y[0] + 0.06, y[1] - 0.06), hw)
    b.surface("top", (f - 0.21, d / 2 - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
    b.fit()


_CAKES = ("cake sponge", "chocolate", "pink icing", "icing", "bread crust", "lemon peel")


def _pastry(b: Builder, x: float, y: float, z: float, k: int) -> None:
    """A cake on a plate, or a tray of rolls: one part each."""
    r = 0.095
    look = _CAKES[k % 6]
    with b.frame(x, y, z):
        if k % 3 == 0:
            b.frustum(r + 0.015, r + 0.02, (0.0, 0.008), "white ceramic", segments=20)
            b.frustum(r, r * 0.97, (0.008, 0.06), look, segments=20)
            b.frustum(r * 0.97, r * 0.9, (0.06, 0.072), _CAKES[(k + 2) % 6], segments=20)
            b.ball((0.014, 0.014, 0.014), (0.0, 0.0, 0.083), "red apple", 8)
        else:
            b.box((-0.12, 0.12), (-0.1, 0.1), (0.0, 0.01), "white ceramic" if k % 2 else "beech", bevel=0.002)
            for i in range(3):
                for j in range(2):
                    px, py = (i - 1) * 0.075, (j - 0.5) * 0.085
                    if k % 3 == 1:
                        b.ball((0.034, 0.04, 0.026), (px, py, 0.033), "bread crust", 10)
                    else:
                        b.frustum(0.023, 0.032, (0.01, 0.045), look, segments=10)
                        b.frustum(0.034, 0.014, (0.045, 0.065), _CAKES[(k + i + j) % 6], segments=10)


@draws("display_case")
def display_case(b: Builder) -> None:
    """A glass front that leans or stands over a panelled base; cakes on two lit boards; a top for a till."""
    d, w, h = b.size
    body = b.material("base", "oak", "white paint", "black paint", "walnut", "sage paint", "grey paint", "navy paint")
    metal = b.material("frame", "brushed steel", "black steel", "brass")
    low = 0.46
    x, y = (-d / 2, d / 2 - 0.015), (-w / 2, w / 2)
    lean = b.pick("lean", [0.0, 0.1, 0.16])
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.05), (y[0] + 0.03, y[1] - 0.03), (0.0, 0.09), "black plastic", bevel=0)
        b.box(x, y, (0.08, low), body, bevel=0.002)
        n = max(2, round(w / 0.4))
        for k in range(n):
            a, c = y[0] + 0.03 + k * (w - 0.06) / n, y[0] + 0.03 + (k + 1) * (w - 0.06) / n
            b.box((x[1] - 0.001, x[1] + 0.008), (a + 0.02, c - 0.02), (0.13, low - 0.06), body, bevel=0.005)
        b.box((x[0], x[1] + 0.015), y, (low, low + 0.03), metal, bevel=0.003)
        xt = x[1] - lean
        b.box((x[0], xt + 0.012), y, (h - 0.03, h), metal, bevel=0.003)
        z0, z1 = low + 0.03, h - 0.03
        b.hull(
            [
                (px + o, s * (w / 2 - 0.002), z)
                for px, z in ((x[1], z0), (xt, z1))
                for o in (-0.01, 0.0)
                for s in (-1, 1)
            ],
            "glass",
        )
        for s in (-1, 1):
            b.hull(
                [
                    (px, s * (w / 2 - 0.003) + o, z)
                    for px, z in ((x[0] + 0.02, z0), (x[0] + 0.02, z1), (x[1] - 0.011, z0), (xt - 0.011, z1))
                    for o in (-0.003, 0.003)
                ],
                "glass",
            )
            b.box(
                (x[0], x[0] + 0.02),
                (s * (w / 2 - 0.012) - 0.012, s * (w / 2 - 0.012) + 0.012),
                (z0, z1),
                metal,
                bevel=0,
            )
        for k, ys in enumerate(((y[0] + 0.024, 0.01), (-0.01, y[1] - 0.024))):
            b.box((x[0] + 0.002 + 0.009 * k, x[0] + 0.008 + 0.009 * k), ys, (z0, z1), "glass", bevel=0)
        zm = (z0 + z1) / 2 + 0.02
        xm = x[1] - lean * (zm - z0) / (z1 - z0) - 0.07
        b.box((x[0] + 0.025, xm), (y[0] + 0.01, y[1] - 0.01), (zm - 0.008, zm), "glass", bevel=0)
        for z, xs in ((z1 - 0.014, xt - 0.03), (zm - 0.022, xm - 0.005)):
            b.box((xs - 0.02, xs), (y[0] + 0.02, y[1] - 0.02), (z, z + 0.0135), "lamp glow", bevel=0)
        n = int((w - 0.1) / 0.27)
        for row, (z, xs) in enumerate(((z0, (x[0] + x[1]) / 2 + 0.04), (zm, (x[0] + xm) / 2))):
            for k in range(n):
                py = y[0] + 0.05 + (k + 0.5) * (w - 0.1) / n
                _pastry(b, xs, py, z, k * 2 + row + b.whole("first", 0, 5))
    b.surface("top", (x[0] + 0.02, xt - 0.01), (y[0] + 0.02, y[1] - 0.02), h)
    b.fit()


@draws("espresso_machine")
def espresso_machine(b: Builder) -> None:
    """Two or three groups with handles over a drip tray, steam wands, gauges, and cups on top."""
    d, w, h = b.size
    body = b.material("body", "brushed steel", "chrome", "red paint", "black paint", "white paint", "copper")
    grip = b.material("handles", "black plastic", "walnut")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    n = 2 if w < 0.8 else 3
    rail = h - 0.03
    top = rail - 0.045
    with b.solid("machine"):
        feet = [(px, py) for px in (x[0] + 0.06, x[1] - 0.1) for py in (y[0] + 0.06, y[1] - 0.06)]
        for px, py in feet:
            with b.frame(px, py):
                b.frustum(0.022, 0.018, (0.0, 0.06), "chrome", segments=14)
        b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), (0.055, 0.11), "brushed steel", bevel=0.004)
        b.box((x[0] + 0.19, x[1] - 0.03), (y[0] + 0.035, y[1] - 0.035), (0.1095, 0.113), "black plastic", bevel=0)
        for k in range(12):
            a = y[0] + 0.05 + k * (w - 0.1) / 12
            b.box((x[0] + 0.2, x[1] - 0.04), (a, a + 0.012), (0.112, 0.116), "chrome", bevel=0)
        b.box((x[0] + 0.02, x[0] + 0.19), (y[0] + 0.03, y[1] - 0.03), (0.105, top - 0.05), body, bevel=0.004)
        b.box((x[0], x[1] - 0.09), y, (top - 0.14, top), body, bevel=0.012)
        for s in (-1, 1):
            ys = (s * (w / 2 - 0.014) - 0.012, s * (w / 2 - 0.014) + 0.012)
            b.hull(
                [
                    (px, py, z)
                    for px, z in (
                        (x[0] + 0.01, 0.06),
                        (x[0] + 0.01, top - 0.05),
                        (x[0] + 0.27, top - 0.05),
                        (x[0] + 0.17, 0.06),
                    )
                    for py in ys
                ],
                body,
            )
        f = x[1] - 0.09
        for k in range(n):
            c = (k - (n - 1) / 2) * (w - 0.24) / max(1, n - 1) if n == 3 else (k - 0.5) * w * 0.42
            gx = x[1] - 0.17
            with b.frame(gx, c, 0.0):
                b.frustum(0.036, 0.042, (top - 0.2, top - 0.135), "chrome", segments=18)
                b.frustum(0.034, 0.034, (top - 0.228, top - 0.2), "chrome", segments=18)
                b.box((-0.012, 0.012), (-0.018, 0.018), (top - 0.25, top - 0.226), "chrome", bevel=0.003)
            b.bar((gx + 0.03, c, top - 0.213), (gx + 0.065, c, top - 0.216), 0.008, "chrome", 8)
            b.bar((gx + 0.06, c, top - 0.215), (x[1], c, top - 0.235), 0.0145, grip, 10)
            for j in range(4):
                a = c - 0.036 + j * 0.024
                b.box(
                    (f - 0.01, f + 0.0025),
                    (a - 0.008, a + 0.008),
                    (top - 0.07, top - 0.052),
                    "black plastic" if j else "lamp glow",
                    bevel=0,
                )
        with b.frame(f - 0.002, 0.0 if n == 2 else (w - 0.24) / 4, top - 0.075, pitch=math.pi / 2):
            b.frustum(0.026, 0.025, (0.0, 0.012), "chrome", segments=20)
            b.frustum(0.021, 0.021, (0.01, 0.0125), "white plastic", segments=18)
        for s in (-1, 1):
            sy = s * (w / 2 - 0.045)
            b.tube(
                [
                    (f - 0.01, sy, top - 0.11),
                    (f + 0.03, sy, top - 0.12),
                    (f + 0.045, sy - s * 0.01, top - 0.17),
                    (f + 0.02, sy - s * 0.02, 0.15),
                ],
                0.006,
                "chrome",
                8,
            )
            knob_x = f - 0.002
            with b.frame(knob_x, sy, top - 0.06, pitch=math.pi / 2):
                b.frustum(0.02, 0.018, (0.0, 0.035), grip, segments=12, bevel=0.003)
        r = 0.004
        c0, c1 = (x[0] + 0.015, f - 0.015), (y[0] + 0.015, y[1] - 0.015)
        for a, e in (
            ((c0[0], c1[0]), (c0[1], c1[0])),
            ((c0[1], c1[0]), (c0[1], c1[1])),
            ((c0[1], c1[1]), (c0[0], c1[1])),
            ((c0[0], c1[1]), (c0[0], c1[0])),
        ):
            b.bar((*a, rail), (*e, rail), r, "chrome", 6)
            b.bar((*a, top - 0.01), (*a, rail), r, "chrome", 6)
        k = 0
        rows, cols = 3, int((w - 0.1) / 0.085)
        for i in range(rows):
            for j in range(cols):
                k += 1
                if k % 7 == 3:
                    continue
                with b.frame(c0[0] + 0.05 + i * 0.085, c1[0] + 0.055 + j * (w - 0.12) / cols, top):
                    two = h - top > 0.07 and (i + j) % 3 == 0
                    b.frustum(0.024, 0.036, (0.0, 0.05), "white ceramic", segments=12)
                    if two:
                        b.frustum(0.027, 0.036, (0.05, h - top), "white ceramic", segments=12)
    b.fit()


@draws("cash_register")
def cash_register(b: Builder) -> None:
    """A drawer under a body with keys or a touch screen, a printer and a display for the customer."""
    d, w, h = b.size
    body = b.material("body", "black plastic", "white plastic", "grey plastic")
    x, y = (-d / 2, d / 2 - 0.012), (-w / 2, w / 2)
    z = 0.1
    with b.solid("register"):
        b.box((x[0], x[1] - 0.02), y, (0.0, z), body, bevel=0.004)
        with b.slide("drawer", limits=(0.0, 0.28)):
            b.box((x[1] - 0.0195, x[1]), (y[0] + 0.006, y[1] - 0.006), (0.008, z - 0.008), body, bevel=0.003)
            with b.frame(x[1] - 0.001, 0.0, 0.06, pitch=math.pi / 2):
                b.frustum(0.013, 0.012, (0.0, 0.013), "chrome", segments=14)
        touch = b.chance("touch", 0.55)
        if touch:
            with b.frame(-0.02, 0.0, z):
                b.box((-0.1, 0.07), (-0.1, 0.1), (0.0, 0.02), body, bevel=0.005)
                b.hull(
                    [
                        (px, py, pz)
                        for px, pz in ((-0.08, 0.015), (-0.02, 0.015), (-0.06, 0.13), (-0.03, 0.13))
                        for py in (-0.03, 0.03)
                    ],
                    body,
                )
            up = h - z
            a = 0.42
            with b.frame(0.0, 0.0, z + 0.035, pitch=-a):
                long = (up - 0.035 - 0.02) / math.cos(a)
                b.box((-0.03, 0.0), (-w * 0.42, w * 0.42), (0.0, long), body, bevel=0.006)
                b.box((-0.002, 0.0015), (-w * 0.39, w * 0.39), (0.014, long - 0.014), "screen", bevel=0)
                tints = (
                    "blue plastic",
                    "green plastic",
                    "orange plastic",
                    "yellow plastic",
                    "grey plastic",
                    "red plastic",
                )
                for i in range(3):
                    for j in range(4):
                        cy, cz = -w * 0.33 + j * w * 0.105, 0.035 + i * (long - 0.06) / 3
                        b.box(
                            (0.0, 0.002),
                            (cy, cy + w * 0.09),
                            (cz, cz + (long - 0.08) / 3),
                            tints[(i * 4 + j) % 6],
                            bevel=0,
                        )
                b.box((0.0, 0.002), (w * 0.12, w * 0.36), (0.035, long - 0.03), "white plastic", bevel=0)
        else:
            b.hull(
                [
                    (px, py, pz)
                    for px, pz in (
                        (x[0] + 0.01, z),
                        (x[1] - 0.02, z),
                        (x[1] - 0.02, z + 0.03),
                        (x[0] + 0.12, z + 0.13),
                        (x[0] + 0.01, z + 0.13),
                    )
                    for py in (y[0] + 0.01, y[1] - 0.01)
                ],
                body,
            )
            run = x[1] - 0.02 - x[0] - 0.12
            tilt = math.atan2(0.1, run)
            with b.frame(x[1] - 0.02, 0.0, z + 0.03, pitch=tilt):
                size = math.hypot(run, 0.1)
                for i in range(5):
                    for j in range(7):
                        look = "red plastic" if j == 6 and i == 0 else "grey plastic" if j < 4 else "white plastic"
                        cx, cy = -0.03 - i * (size - 0.03) / 5, y[0] + 0.05 + j * (w - 0.1) / 6.4
                        b.box((cx - 0.018, cx), (cy - 0.016, cy + 0.016), (-0.004, 0.008), look, bevel=0)
            b.box((x[0] + 0.015, x[0] + 0.1), (y[0] + 0.03, y[0] + 0.13), (z + 0.125, z + 0.17), body, bevel=0.006)
            b.box((x[0] + 0.045, x[0] + 0.048), (y[0] + 0.05, y[0] + 0.11), (z + 0.165, z + 0.215), "paper", bevel=0)
            b.bar((x[0] + 0.05, 0.08, z + 0.12), (x[0] + 0.05, 0.08, h - 0.05), 0.012, body, 10)
            b.box((x[0] + 0.02, x[0] + 0.06), (-0.03, 0.15), (h - 0.075, h), body, bevel=0.006)
            b.box((x[0] + 0.058, x[0] + 0.0615), (-0.015, 0.135), (h - 0.062, h - 0.012), "screen", bevel=0)
    b.fit()


@draws("host_stand")
def host_stand(b: Builder) -> None:
    """A panelled stand with a sloped top and a ledge, open shelves on the host's side; guests come from +x."""
    d, w, h = b.size
    wood = b.material("body", *_WOODS, "black paint", "navy paint")
    trim = b.material("trim", "brass", "black steel", "steel")
    x, y = (-d / 2 + 0.03, d / 2 - 0.03), (-w / 2 + 0.025, w / 2 - 0.025)
    low = h - 0.13
    t = 0.022
    with b.solid("foot"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.06), wood, bevel=0.006)
    with b.solid("front"):
        b.box((x[1] - t, x[1]), y, (0.06, low), wood, bevel=0.001)
        b.box((x[1] - 0.001, x[1] + 0.008), (y[0] + 0.06, y[1] - 0.06), (0.14, low - 0.08), wood, bevel=0.006)
        b.box((x[1] + 0.006, x[1] + 0.01), (-0.07, 0.07), (low - 0.32, low - 0.18), trim, bevel=0.001)
    for k, ys in enumerate(((y[0], y[0] + t), (y[1] - t, y[1]))):
        with b.solid(f"side {k}"):
            b.box((x[0], x[1] - t), ys, (0.06, low), wood, bevel=0.001)
    with b.solid("shelf"):
        zm = 0.52
        b.box((x[0] + 0.01, x[1] - t), (y[0] + t, y[1] - t), (zm - t, zm), wood, bevel=0.001)
    with b.solid("desk"):
        b.box((x[0], x[1]), y, (low - t, low), wood, bevel=0.001)
        # The slope rises toward the guests; a ledge keeps the book.
        b.hull(
            [
                (px, py, z)
                for px, z in ((-d / 2, low), (-d / 2, low + 0.03), (d / 2 - 0.06, h), (d / 2, h), (d / 2, low))
                for py in (-w / 2, w / 2)
            ],
            wood,
        )
        a = math.atan2(h - low - 0.03, d - 0.06)
        with b.frame(-d / 2, 0.0, low + 0.03, pitch=-a):
            b.box((0.006, 0.022), (-w / 2 + 0.03, w / 2 - 0.03), (-0.004, 0.016), trim, bevel=0.002)
            b.box((0.06, 0.30), (-0.17, 0.17), (-0.001, 0.004), "paper", bevel=0)
            b.box((0.06, 0.30), (-0.0015, 0.0015), (0.003, 0.0045), "grey plastic", bevel=0)
            for s in (-1, 1):
                for k in range(6):
                    b.box(
                        (0.09 + 0.033 * k, 0.094 + 0.033 * k),
                        (s * 0.085 - 0.06, s * 0.085 + 0.06),
                        (0.0035, 0.0044),
                        "grey plastic",
                        bevel=0,
                    )
    for k, (z, up) in enumerate(((0.06, zm - t), (zm, low - t))):
        b.surface(
            f"shelf-{k}",
            (x[0] + 0.02, x[1] - t - 0.01),
            (y[0] + t + 0.01, y[1] - t - 0.01),
            z,
            headroom=round(up - z - 0.005, 3),
        )
    b.fit()
