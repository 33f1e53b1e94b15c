"""Bars, cafes and restaurants: counters, display cases, stands, buffets, signs, trolleys."""

from __future__ import annotations

import math

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import castors, loft, oval

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
                    b.box((f - 0.001, f + 0.009), (m - step / 2 + 0.075, m + step / 2 - 0.075), (0.15, h - t - 0.13), wood, bevel=0.007)
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
        b.surface(f"shelf-{k}", (inner[0] + 0.01, inner[1] - 0.01), (y[0] + 0.06, y[1] - 0.06), z, headroom=round(up, 3))
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
        b.hull([(px + o, s * (w / 2 - 0.002), z) for px, z in ((x[1], z0), (xt, z1)) for o in (-0.01, 0.0) for s in (-1, 1)], "glass")
        for s in (-1, 1):
            b.hull([(px, s * (w / 2 - 0.003) + o, z) for px, z in ((x[0] + 0.02, z0), (x[0] + 0.02, z1), (x[1] - 0.011, z0), (xt - 0.011, z1))
                    for o in (-0.003, 0.003)], "glass")  # fmt: skip
            b.box((x[0], x[0] + 0.02), (s * (w / 2 - 0.012) - 0.012, s * (w / 2 - 0.012) + 0.012), (z0, z1), metal, bevel=0)
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
            b.hull([(px, py, z) for px, z in ((x[0] + 0.01, 0.06), (x[0] + 0.01, top - 0.05), (x[0] + 0.27, top - 0.05), (x[0] + 0.17, 0.06))
                    for py in ys], body)  # fmt: skip
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
                b.box((f - 0.01, f + 0.0025), (a - 0.008, a + 0.008), (top - 0.07, top - 0.052), "black plastic" if j else "lamp glow",
                      bevel=0)  # fmt: skip
        with b.frame(f - 0.002, 0.0 if n == 2 else (w - 0.24) / 4, top - 0.075, pitch=math.pi / 2):
            b.frustum(0.026, 0.025, (0.0, 0.012), "chrome", segments=20)
            b.frustum(0.021, 0.021, (0.01, 0.0125), "white plastic", segments=18)
        for s in (-1, 1):
            sy = s * (w / 2 - 0.045)
            b.tube([(f - 0.01, sy, top - 0.11), (f + 0.03, sy, top - 0.12), (f + 0.045, sy - s * 0.01, top - 0.17),
                    (f + 0.02, sy - s * 0.02, 0.15)], 0.006, "chrome", 8)  # fmt: skip
            knob_x = f - 0.002
            with b.frame(knob_x, sy, top - 0.06, pitch=math.pi / 2):
                b.frustum(0.02, 0.018, (0.0, 0.035), grip, segments=12, bevel=0.003)
        r = 0.004
        c0, c1 = (x[0] + 0.015, f - 0.015), (y[0] + 0.015, y[1] - 0.015)
        for a, e in (((c0[0], c1[0]), (c0[1], c1[0])), ((c0[1], c1[0]), (c0[1], c1[1])), ((c0[1], c1[1]), (c0[0], c1[1])), ((c0[0], c1[1]),
                     (c0[0], c1[0]))):  # fmt: skip
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
                b.hull([(px, py, pz) for px, pz in ((-0.08, 0.015), (-0.02, 0.015), (-0.06, 0.13), (-0.03, 0.13)) for py in (-0.03, 0.03)], body)
            up = h - z
            a = 0.42
            with b.frame(0.0, 0.0, z + 0.035, pitch=-a):
                long = (up - 0.035 - 0.02) / math.cos(a)
                b.box((-0.03, 0.0), (-w * 0.42, w * 0.42), (0.0, long), body, bevel=0.006)
                b.box((-0.002, 0.0015), (-w * 0.39, w * 0.39), (0.014, long - 0.014), "screen", bevel=0)
                tints = ("blue plastic", "green plastic", "orange plastic", "yellow plastic", "grey plastic", "red plastic")
                for i in range(3):
                    for j in range(4):
                        cy, cz = -w * 0.33 + j * w * 0.105, 0.035 + i * (long - 0.06) / 3
                        b.box((0.0, 0.002), (cy, cy + w * 0.09), (cz, cz + (long - 0.08) / 3), tints[(i * 4 + j) % 6], bevel=0)
                b.box((0.0, 0.002), (w * 0.12, w * 0.36), (0.035, long - 0.03), "white plastic", bevel=0)
        else:
            b.hull([(px, py, pz) for px, pz in ((x[0] + 0.01, z), (x[1] - 0.02, z), (x[1] - 0.02, z + 0.03), (x[0] + 0.12, z + 0.13),
                    (x[0] + 0.01, z + 0.13)) for py in (y[0] + 0.01, y[1] - 0.01)], body)  # fmt: skip
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
        b.hull([(px, py, z) for px, z in ((-d / 2, low), (-d / 2, low + 0.03), (d / 2 - 0.06, h), (d / 2, h), (d / 2, low))
                for py in (-w / 2, w / 2)], wood)  # fmt: skip
        a = math.atan2(h - low - 0.03, d - 0.06)
        with b.frame(-d / 2, 0.0, low + 0.03, pitch=-a):
            b.box((0.006, 0.022), (-w / 2 + 0.03, w / 2 - 0.03), (-0.004, 0.016), trim, bevel=0.002)
            b.box((0.06, 0.30), (-0.17, 0.17), (-0.001, 0.004), "paper", bevel=0)
            b.box((0.06, 0.30), (-0.0015, 0.0015), (0.003, 0.0045), "grey plastic", bevel=0)
            for s in (-1, 1):
                for k in range(6):
                    b.box((0.09 + 0.033 * k, 0.094 + 0.033 * k), (s * 0.085 - 0.06, s * 0.085 + 0.06), (0.0035, 0.0044), "grey plastic", bevel=0)
    for k, (z, up) in enumerate(((0.06, zm - t), (zm, low - t))):
        b.surface(f"shelf-{k}", (x[0] + 0.02, x[1] - t - 0.01), (y[0] + t + 0.01, y[1] - t - 0.01), z, headroom=round(up - z - 0.005, 3))
    b.fit()


def _warmer(b: Builder, x: float, y: float, z: float, h: float, wide: float, deep: float, metal, dome: bool) -> None:
    """A chafing dish: frame, burner, water pan, and a lid with a grip up to height h."""
    with b.frame(x, y, z):
        for s in (-1, 1):
            for t in (-1, 1):
                b.box((s * (deep / 2 - 0.015) - 0.008, s * (deep / 2 - 0.015) + 0.008), (t * (wide / 2 - 0.02) - 0.008, t * (wide / 2 - 0.02) + 0.008),
                      (0.0, 0.12), metal, bevel=0)  # fmt: skip
        b.box((-deep / 2 + 0.02, deep / 2 - 0.02), (-wide / 2 + 0.02, wide / 2 - 0.02), (0.02, 0.028), metal, bevel=0)
        for t in (-1, 1):
            with b.frame(0.0, t * wide * 0.22, 0.027):
                b.frustum(0.04, 0.036, (0.0, 0.05), "copper", segments=14)
        b.box((-deep / 2 + 0.01, deep / 2 - 0.01), (-wide / 2 + 0.012, wide / 2 - 0.012), (0.1, 0.16), metal, bevel=0.006)
        b.box((-deep / 2, deep / 2), (-wide / 2, wide / 2), (0.155, 0.168), metal, bevel=0.003)
        p = 5.0 if not dome else 2.6
        zl = 0.168
        up = h - z - zl - 0.03
        rings = [oval(deep / 2 * s, wide / 2 * s, zl + up * f, power=p) for s, f in ((0.96, 0.0), (0.94, 0.35), (0.8, 0.75), (0.55, 1.0))]
        loft(b, rings, metal, whole=True)
        b.bar((0.0, -0.05, zl + up + 0.02), (0.0, 0.05, zl + up + 0.02), 0.009, "black plastic", 8)
        for t in (-1, 1):
            b.bar((0.0, t * 0.045, zl + up - 0.01), (0.0, t * 0.045, zl + up + 0.02), 0.006, "black plastic", 6)


@draws("buffet_table")
def buffet_table(b: Builder) -> None:
    """A clothed table with two or three food warmers in a row, and room for plates at both ends and in front."""
    d, w, h = b.size
    cloth = b.material("cloth", "white fabric", "navy fabric", "black fabric", "red fabric", "beige fabric", "green fabric")
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
                b.hull([(s * (d / 2 - 0.026 + o), a + q, v) for o, q in ((0.0, -0.028), (0.0, 0.028), (0.014, 0.0)) for v in (0.004, z - 0.05)],
                       cloth)  # fmt: skip
            m = int(d / 0.09)
            for k in range(m):
                a = x[0] + 0.04 + (k + 0.5) * (d - 0.08) / m
                b.hull([(a + q, s * (w / 2 - 0.026 + o), v) for o, q in ((0.0, -0.028), (0.0, 0.028), (0.014, 0.0)) for v in (0.004, z - 0.05)],
                       cloth)  # fmt: skip
        over = "white fabric" if cloth.name != "white fabric" else b.material("runner", "red fabric", "navy fabric", "mustard fabric")
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
            b.box((x[0] + 0.07, x[1] - 0.07), (s * (w / 2 - 0.035) - 0.035, s * (w / 2 - 0.035) + 0.035), (z - 0.06, z), "brushed steel", bevel=0)
        foods = ("lettuce", "tomato", "carrot", "cheese", "egg shell", "green apple", "aubergine", "bread crust", "grape", "lemon peel")
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
                b.cushion((px + 0.012, px + deep - 0.004), (py + 0.012, py + wide - 0.004), (z - 0.05, z - 0.002), look, 0.02, 0.35)
                for k in range(6):
                    qx, qy = px + deep * (0.25 + 0.25 * (k % 3)), py + wide * (0.3 + 0.4 * (k // 3))
                    b.ball((0.028, 0.032, 0.016), (qx + 0.01 * ((k * 7) % 3 - 1), qy, z - 0.003), look, 6)
    for k in range(3):
        px = x[1] + 0.03 + k * 0.048
        b.bar((px, y[0] + 0.02, z - 0.07), (px, y[1] - 0.02, z - 0.07), 0.012, "chrome", 8)
    with b.solid("rail"):
        for s in (-1, 1):
            b.hull([(px, s * w * 0.36 + o, v) for px, v in ((x[1] - 0.012, z - 0.1), (x[1] - 0.012, z - 0.2), (d / 2 - 0.014, z - 0.082),
                    (d / 2 - 0.014, z - 0.1)) for o in (-0.012, 0.012)], "brushed steel")  # fmt: skip
    with b.solid("guard"):
        m = (x[0] + x[1]) / 2
        for s in (-1, 1):
            for t in (-1, 1):
                b.bar((m + t * 0.02, s * (w / 2 - 0.035), z - 0.01), (m + t * 0.02, s * (w / 2 - 0.035), h - 0.03), 0.012, "chrome", 10)
        b.box((m - 0.17, m + 0.17), y, (h - 0.03, h), body, bevel=0.003)
        b.box((m - 0.03, m + 0.03), (y[0] + 0.06, y[1] - 0.06), (h - 0.034, h - 0.028), "lamp glow", bevel=0)
        for t in (-1, 1):
            b.hull([(m + t * px, py, v) for px, v in ((0.155, h - 0.03), (0.161, h - 0.03), (0.305, h - 0.2), (0.311, h - 0.2)) for py in
                    (y[0] + 0.02, y[1] - 0.02)], "glass")  # fmt: skip
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
                b.box((0.0135, c), (wide * 0.72, wide), (z, z + 0.014), "ochre pigment" if k % 2 else "chalk pigment", bevel=0)
            # A cup in chalk.
            z = low + 0.03
            b.hull([(px, q, v) for px in (0.0135, c) for q, v in ((-0.022, z), (0.022, z), (0.034, z + 0.045), (-0.034, z + 0.045))], "chalk pigment")
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
            b.box((x - 0.045, x + 0.045), (-span / 2 - 0.06, span / 2 + 0.06), (top - 0.075, top + 0.02), metal, bevel=0.012)
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
