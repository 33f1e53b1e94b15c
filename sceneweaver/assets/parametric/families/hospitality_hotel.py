"""Hotels and break rooms: luggage racks and carts, minibars, ice and vending machines, coffee stations."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..joinery import handle
from ..registry import draws
from .kitchen_parts import cabinet, castors, feet, oval, vessel


@draws("luggage_rack")
def luggage_rack(b: Builder) -> None:
    """Crossed legs with straps between two rails, and a guard at the wall's side in some."""
    d, w, h = b.size
    wood = b.material("frame", "walnut", "oak", "mahogany", "chrome", "brass", "beech")
    strap = b.material("straps", "brown leather", "black fabric", "navy fabric", "tan leather")
    r = 0.013
    guard = b.chance("guard", 0.5)
    top = h - (0.12 if guard else 0.004)
    x, y = d / 2 - r, w / 2 - r
    with b.solid("rack"):
        for s, py in ((1, y - 0.03), (-1, y - 0.06)):
            for t in (-1, 1):
                b.bar((-s * x, t * py, r), (s * x, t * py, top - r), r, wood, 10)
            b.bar((s * x, -y, top - r), (s * x, y, top - r), r, wood, 10)
            b.bar((-s * x * 0.86, -py, 0.1), (-s * x * 0.86, py, 0.1), r * 0.8, wood, 8)
        b.bar((0.0, -y + 0.02, (top) / 2), (0.0, y - 0.02, top / 2), r * 0.8, wood, 8)
        n = 4
        for k in range(n):
            c = (k - (n - 1) / 2) * (w - 0.12) / n
            b.box((-x - 0.012, x + 0.012), (c - 0.027, c + 0.027), (top - 0.002, top + 0.002), strap, bevel=0)
            for s in (-1, 1):
                b.box(
                    (s * (x + 0.002) - 0.0145, s * (x + 0.002) + 0.0145),
                    (c - 0.027, c + 0.027),
                    (top - 2 * r - 0.003, top - 0.001),
                    strap,
                    bevel=0.004,
                )
    if guard:
        with b.solid("guard"):
            for t in (-1, 1):
                b.bar((-x, t * (y - 0.06), top - r), (-x, t * (y - 0.06), h - r), r * 0.8, wood, 8)
            b.bar((-x, -y + 0.03, h - r), (-x, y - 0.03, h - r), r, wood, 10)
            b.bar((-x, -y + 0.03, top + 0.06), (-x, y - 0.03, top + 0.06), r * 0.6, wood, 8)
    b.fit()


@draws("luggage_cart")
def luggage_cart(b: Builder) -> None:
    """A brass birdcage: a carpeted deck on four wheels, posts that bend to a crown, and a bar for clothes."""
    d, w, h = b.size
    metal = b.material("frame", "brass", "chrome", "brass", "brushed steel", "black steel")
    carpet = b.material("carpet", "red fabric", "navy fabric", "black fabric", "green fabric")
    z, r = 0.24, 0.019
    x, y = d / 2 - 0.055, w / 2 - 0.055
    with b.solid("deck"):
        b.box(
            (-d / 2 + 0.018, d / 2 - 0.018), (-w / 2 + 0.018, w / 2 - 0.018), (z - 0.045, z - 0.012), metal, bevel=0.004
        )
        b.box((-d / 2 + 0.035, d / 2 - 0.035), (-w / 2 + 0.035, w / 2 - 0.035), (z - 0.013, z), carpet, bevel=0.004)
        bump = [
            (-d / 2 + 0.018, -w / 2 + 0.018),
            (d / 2 - 0.018, -w / 2 + 0.018),
            (d / 2 - 0.018, w / 2 - 0.018),
            (-d / 2 + 0.018, w / 2 - 0.018),
        ]
        for a, e in zip(bump, bump[1:] + bump[:1], strict=True):
            b.bar((*a, z - 0.03), (*e, z - 0.03), 0.018, "rubber", 8)
        castors(b, (-x + 0.04, x - 0.04), (-y + 0.06, y - 0.06), z - 0.045, 0.085, metal)
    crown = h - 0.05
    bend = 0.28
    bends: list = []
    for t in (-1, 1):
        with b.solid(f"frame {t}"):
            for s in (-1, 1):
                b.bar((s * x, t * y, z - 0.02), (s * x, t * y, crown - bend), r, metal, 10)
                path = [(s * x, t * y, crown - bend - 0.01), (s * x, t * y, crown - bend)]
                for a in np.linspace(0.2, 1.0, 5):
                    q = a * math.pi / 2
                    path.append(
                        (
                            s * x * (1 - (1 - math.cos(q)) * 0.92),
                            t * y * (1 - (1 - math.cos(q)) * 0.42),
                            crown - bend * (1 - math.sin(q)),
                        )
                    )
                bends.append(path)
                with b.frame(s * x, t * y, z - 0.012):
                    b.frustum(0.034, 0.026, (0.0, 0.03), metal, segments=14)
            b.bar((-x, t * y, z + 0.35), (x, t * y, z + 0.35), 0.013, metal, 10)
    with b.solid("crown"):
        for path in bends:
            b.tube(path, r, metal, 10)
        b.bar((0.0, -y * 0.6, crown), (0.0, y * 0.6, crown), r, metal, 12)
        for t in (-1, 1):
            b.bar((-x * 0.12, t * y * 0.58, crown), (x * 0.12, t * y * 0.58, crown), r, metal, 12)
        with b.frame(0.0, 0.0, crown):
            b.lathe(
                [(0.024, -0.022), (0.024, 0.02), (0.012, 0.03), (0.02, 0.04), (0.006, h - crown)], metal, segments=14
            )
    b.surface(
        "deck",
        (-d / 2 + 0.11, d / 2 - 0.11),
        (-w / 2 + 0.11, w / 2 - 0.11),
        z,
        headroom=round(crown - bend * 0.5 - z - 0.3, 2),
    )
    b.fit()


@draws("minibar")
def minibar(b: Builder) -> None:
    """A low refrigerator with a solid or a glass door, and bottles behind the glass."""
    d, w, h = b.size
    coat = b.material("body", "black paint", "white paint", "brushed steel", "red paint", "cream paint", "sage paint")
    x, y = (-d / 2, d / 2 - 0.07), (-w / 2, w / 2)
    glass = b.chance("glass", 0.5)
    leaf = (x[1] + 0.002, x[1] + 0.042)
    hung = b.pick("hung", ["left", "right"])
    t = 0.035
    with b.solid("body"):
        feet(b, x, y, 0.02)
        if glass:
            for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
                b.box(x, ys, (0.018, h), coat, bevel=0.002)
            inner = (y[0] + t, y[1] - t)
            b.box(x, inner, (0.018, 0.06), coat, bevel=0)
            b.box(x, inner, (h - t, h), coat, bevel=0)
            b.box((x[0], x[0] + t), inner, (0.06, h - t), "white plastic", bevel=0)
            b.box(
                (x[1] - 0.05, x[1] - 0.02),
                (inner[0] + 0.03, inner[1] - 0.03),
                (h - t - 0.007, h - t),
                "lamp glow",
                bevel=0,
            )
            looks = ("green glass", "amber glass", "red plastic", "blue plastic", "clear plastic", "orange plastic")
            for k, z in enumerate((0.06, 0.06 + (h - 0.1) / 2)):
                if k:
                    b.box((x[0] + t, x[1] - 0.02), inner, (z - 0.006, z), "glass", bevel=0)
                for j in range(4):
                    py = inner[0] + (j + 0.5) * (inner[1] - inner[0]) / 4
                    look = looks[(j + 3 * k + b.whole("first", 0, 5)) % 6]
                    for px in (x[1] - 0.09, x[1] - 0.19):
                        with b.frame(px, py, z):
                            if (j + k) % 2:
                                b.frustum(0.03, 0.03, (0.0, 0.115), look, segments=12, bevel=0.004)
                            else:
                                b.lathe([(0.031, 0.0), (0.031, 0.12), (0.012, 0.17), (0.012, 0.2)], look, segments=12)
        else:
            b.box(x, y, (0.018, h), coat, bevel=0.006)
        b.box((x[1] - 0.001, x[1] + 0.003), (y[0] + 0.012, y[1] - 0.012), (0.035, 0.045), "rubber", bevel=0)
        at = y[1] if hung == "left" else y[0]
        py = y[0] + 0.035 if hung == "left" else y[1] - 0.035
        with b.hinge("door", (leaf[1], at, 0.03), limits=(0.0, 1.9) if hung == "left" else (-1.9, 0.0)):
            if glass:
                f = 0.05
                for ys, zs in (
                    (y, (0.03, 0.03 + f)),
                    (y, (h - f, h)),
                    ((y[0], y[0] + f), (0.03 + f, h - f)),
                    ((y[1] - f, y[1]), (0.03 + f, h - f)),
                ):
                    b.box(leaf, ys, zs, coat, bevel=0.001)
                b.box((leaf[0] + 0.015, leaf[0] + 0.022), (y[0] + f, y[1] - f), (0.03 + f, h - f), "glass", bevel=0)
            else:
                b.box(leaf, (y[0] + 0.001, y[1] - 0.001), (0.03, h - 0.002), coat, bevel=0.01)
                b.box((leaf[1] - 0.001, leaf[1] + 0.0015), (-0.03, 0.03), (h - 0.075, h - 0.062), "chrome", bevel=0)
            handle(b, leaf[1], py, h * 0.68, "chrome", "bar", 0.22, upright=True)
    b.surface("top", (x[0] + 0.015, x[1] - 0.015), (y[0] + 0.015, y[1] - 0.015), h)
    b.fit()


@draws("ice_machine")
def ice_machine(b: Builder) -> None:
    """A steel machine with a grille over a bin whose flap opens to the ice, with a scoop on its side."""
    d, w, h = b.size
    steel = b.material("body", "brushed steel", "steel", "aluminium")
    x, y = (-d / 2, d / 2 - 0.05), (-w / 2, w / 2)
    m = h * 0.58
    leg = 0.12
    with b.solid("body"):
        for px in (x[0] + 0.06, x[1] - 0.06):
            for py in (y[0] + 0.06, y[1] - 0.06):
                with b.frame(px, py):
                    b.frustum(0.014, 0.022, (0.0, leg + 0.002), "chrome", segments=14)
        b.box(x, y, (leg, m), steel, bevel=0.004)
        b.box((x[0], x[1] - 0.02), (y[0] + 0.006, y[1] - 0.006), (m - 0.001, h), steel, bevel=0.004)
        b.hull(
            [
                (px, py, z)
                for px, z in (
                    (x[1] - 0.021, m),
                    (x[1] - 0.021, h - 0.004),
                    (x[1] + 0.02, h - 0.03),
                    (x[1] + 0.02, m + 0.004),
                )
                for py in (y[0] + 0.006, y[1] - 0.006)
            ],
            steel,
        )
        f = x[1] + 0.02
        n = max(5, int((h - m - 0.14) / 0.022))
        for k in range(n):
            z = m + 0.05 + k * (h - m - 0.15) / n
            b.box((f - 0.004, f + 0.004), (y[0] + 0.06, y[1] - 0.06), (z, z + 0.011), "black plastic", bevel=0)
        b.box((f - 0.003, f + 0.002), (y[1] - 0.2, y[1] - 0.06), (h - 0.085, h - 0.05), "screen", bevel=0)
        b.box((f - 0.003, f + 0.0015), (y[0] + 0.05, y[0] + 0.2), (h - 0.085, h - 0.05), "blue plastic", bevel=0)
        zt = m - 0.03
        with b.hinge("flap", (x[1], 0.0, zt), axis=(0.0, 1.0, 0.0), limits=(-1.4, 0.0)):
            b.hull(
                [
                    (px, py, z)
                    for px, z in (
                        (x[1] + 0.0005, zt),
                        (x[1] + 0.0005, zt - 0.23),
                        (x[1] + 0.045, zt - 0.23),
                        (x[1] + 0.015, zt),
                    )
                    for py in (y[0] + 0.04, y[1] - 0.04)
                ],
                "black plastic" if b.chance("dark flap", 0.6) else "grey plastic",
            )
            b.box((x[1] + 0.04, d / 2), (-0.09, 0.09), (zt - 0.23, zt - 0.2), "chrome", bevel=0.005)
        # Ice cubes as a sign on the front.
        for px, pz in ((0.0, 0.0), (0.06, 0.012), (0.028, 0.06)):
            z = leg + 0.06 + pz
            b.box((x[1] - 0.002, x[1] + 0.0025), (-0.06 + px, -0.015 + px), (z, z + 0.045), "blue ceramic", bevel=0)
            b.box(
                (x[1] - 0.002, x[1] + 0.003), (-0.053 + px, -0.03 + px), (z + 0.02, z + 0.038), "white plastic", bevel=0
            )
    b.fit()


@draws("vending_machine")
def vending_machine(b: Builder) -> None:
    """A tall case with a window on rows of snacks and bottles, a panel with keys and slots, and a flap below."""
    d, w, h = b.size
    coat = b.material("body", "black paint", "red paint", "blue paint", "white paint", "grey paint", "navy paint")
    x, y = (-d / 2, d / 2 - 0.012), (-w / 2, w / 2)
    # Seen from its front, the panel is to the viewer's right: +y.
    cut = y[1] - 0.25
    low, top = 0.5, h - 0.17
    f = x[1]
    win = (y[0] + 0.05, cut - 0.02)
    with b.solid("body"):
        feet(b, x, y, 0.05, r=0.025)
        b.box((x[0], f - 0.3), y, (0.045, h), coat, bevel=0.004)
        b.box((f - 0.3, f), y, (0.045, low), coat, bevel=0)
        b.box((f - 0.3, f), y, (top, h), coat, bevel=0)
        b.box((f - 0.3, f), (y[0], win[0]), (low, top), coat, bevel=0)
        b.box((f - 0.3, f), (win[1], y[1]), (low, top), coat, bevel=0)
        b.box((f - 0.012, f - 0.004), win, (low, top), "glass", bevel=0)
        b.box((f - 0.002, f + 0.004), (y[0] + 0.05, y[1] - 0.05), (top + 0.03, h - 0.03), "lamp glow", bevel=0)
        b.box(
            (f + 0.0035, f + 0.0055),
            (y[0] + 0.12, y[0] + 0.12 + 0.45 * w),
            (top + 0.06, h - 0.06),
            "red plastic",
            bevel=0,
        )
        b.box((f - 0.03, f - 0.015), win, (top - 0.008, top), "lamp glow", bevel=0)
        rows = 6
        looks = (
            "red plastic",
            "yellow plastic",
            "blue plastic",
            "orange plastic",
            "green plastic",
            "pink plastic",
            "chocolate",
            "white plastic",
            "lilac plastic",
            "mint plastic",
        )
        step = (top - low) / rows
        cols = max(4, int((win[1] - win[0]) / 0.095))
        wide = (win[1] - win[0]) / cols
        first = b.whole("first", 0, 9)
        for i in range(rows):
            z = low + i * step
            b.box((f - 0.3, f - 0.02), win, (z, z + 0.008), "grey plastic", bevel=0)
            b.box((f - 0.024, f - 0.016), win, (z + 0.0005, z + 0.022), "white plastic", bevel=0)
            for j in range(cols):
                c = win[0] + (j + 0.5) * wide
                look = looks[(first + i * 3 + j * (2 if i % 2 else 1)) % 10]
                up = step - 0.035
                if i < 2:
                    with b.frame(f - 0.075, c, z + 0.008):
                        b.lathe(
                            [(0.03, 0.0), (0.031, up * 0.62), (0.012, up * 0.84), (0.014, up * 0.95)], look, segments=10
                        )
                elif (i + j // 2) % 2:
                    b.cushion(
                        (f - 0.1, f - 0.04),
                        (c - wide * 0.4, c + wide * 0.4),
                        (z + 0.008, z + 0.008 + up * 0.85),
                        look,
                        0.012,
                        0.5,
                    )
                else:
                    b.box(
                        (f - 0.1, f - 0.06),
                        (c - wide * 0.32, c + wide * 0.32),
                        (z + 0.008, z + 0.008 + up * 0.8),
                        look,
                        bevel=0.004,
                    )
        m = (cut + y[1]) / 2
        b.box((f - 0.001, f + 0.003), (cut + 0.02, y[1] - 0.03), (0.85, 1.55), "black plastic", bevel=0)
        b.box((f + 0.002, f + 0.0045), (m - 0.075, m + 0.065), (1.43, 1.51), "screen", bevel=0)
        for i in range(4):
            for j in range(3):
                cy, cz = m - 0.005 + (j - 1) * 0.042, 1.37 - i * 0.04
                b.box(
                    (f + 0.002, f + 0.008), (cy - 0.015, cy + 0.015), (cz - 0.014, cz + 0.014), "grey plastic", bevel=0
                )
        b.box((f + 0.002, f + 0.01), (m - 0.05, m + 0.04), (1.12, 1.17), "chrome", bevel=0.002)
        b.box((f + 0.009, f + 0.0105), (m - 0.035, m + 0.025), (1.14, 1.148), "black plastic", bevel=0)
        b.box((f + 0.002, f + 0.006), (m - 0.04, m - 0.01), (1.02, 1.07), "blue plastic", bevel=0)
        b.box((f + 0.002, f + 0.009), (m - 0.045, m + 0.035), (0.88, 0.95), "chrome", bevel=0.003)
        with b.hinge("flap", (f, 0.0, 0.4), axis=(0.0, 1.0, 0.0), limits=(-0.9, 0.0)):
            b.box((f + 0.0005, f + 0.009), (win[0] + 0.02, win[1] - 0.02), (0.2, 0.4), "black plastic", bevel=0.002)
            b.box((f + 0.008, f + 0.012), (win[0] + 0.1, win[1] - 0.1), (0.355, 0.375), "grey plastic", bevel=0.001)
        b.box((f - 0.001, f + 0.002), (y[0] + 0.03, y[1] - 0.03), (0.07, 0.15), "black plastic", bevel=0)
    b.fit()


@draws("coffee_station")
def coffee_station(b: Builder) -> None:
    """A cabinet with a counter, over it an open shelf with mugs and jars against a panelled back."""
    d, w, h = b.size
    leaf = b.material(
        "fronts", "sage paint", "white paint", "oak", "navy paint", "walnut", "black paint", "cream paint", "light oak"
    )
    shell = b.material("body", "white paint", "oak", "walnut") if leaf.name.endswith("paint") else leaf
    top = b.material("top", "oak", "walnut", "marble", "beech", "dark marble")
    pull = b.material("pulls", "brass", "black steel", "steel")
    looks = (shell, leaf, pull, b.pick("pull style", ["bar", "knob", "cup"]))
    z, t = 0.9, 0.03
    x, y = (-d / 2, d / 2 - 0.027), (-w / 2, w / 2)
    with b.solid("body"):
        b.box((x[0] + 0.02, x[1] - 0.06), (y[0] + 0.01, y[1] - 0.01), (0.0, 0.08), "black plastic", bevel=0)
        n = 2
        for k in range(n):
            layout = b.pick(f"layout {k}", ["drawers", "mixed", "doors"])
            cabinet(
                b,
                f"unit-{k}",
                x,
                (y[0] + k * w / n, y[0] + (k + 1) * w / n),
                (0.08, z - t),
                layout,
                looks,
                b.style in ("classic", "rustic"),
            )
        b.box((-d / 2, d / 2 - 0.004), y, (z - t, z), top, bevel=0.003)
    with b.solid("back"):
        b.box((-d / 2, -d / 2 + 0.018), y, (z, h), leaf, bevel=0.002)
        n = round(w / 0.1)
        for k in range(n):
            a = y[0] + k * w / n
            b.box(
                (-d / 2 + 0.0175, -d / 2 + 0.022),
                (a + 0.003, a + w / n - 0.003),
                (z + 0.01, h - 0.01),
                leaf,
                bevel=0.001,
            )
    zs = h - 0.16
    xs = (-d / 2 + 0.022, -d / 2 + 0.2)
    with b.solid("shelf"):
        b.box(xs, (y[0] + 0.02, y[1] - 0.02), (zs - 0.022, zs), top, bevel=0.002)
        for s in (-1, 1):
            py = s * w * 0.36
            b.box((xs[0], xs[1] - 0.03), (py - 0.006, py + 0.006), (zs - 0.034, zs - 0.022), pull, bevel=0)
            b.box((xs[0], xs[0] + 0.008), (py - 0.006, py + 0.006), (zs - 0.12, zs - 0.022), pull, bevel=0)
        m = 5
        for k in range(m):
            a = (k - (m - 1) / 2) * 0.12
            look = ("white ceramic", "blue ceramic", "terracotta", "cream ceramic", "grey ceramic")[
                (k + b.whole("mug", 0, 4)) % 5
            ]
            b.bar((xs[1] - 0.05, a, zs - 0.021), (xs[1] - 0.05, a, zs - 0.038), 0.003, pull, 6)
            with b.frame(xs[1] - 0.05, a, zs - 0.125):
                vessel(
                    b,
                    [oval(0.032, 0.032, 0.0, n=12), oval(0.036, 0.036, 0.085, n=12)],
                    [oval(0.032, 0.032, 0.085, n=12), oval(0.028, 0.028, 0.005, n=12)],
                    look,
                    3,
                )
                b.tube(
                    [(0.0, 0.033, 0.07), (0.0, 0.055, 0.068), (0.0, 0.055, 0.03), (0.0, 0.032, 0.02)], 0.005, look, 6
                )
    with b.solid("jars"):
        for k in range(3):
            a = y[0] + 0.12 + k * 0.12
            with b.frame((xs[0] + xs[1]) / 2, a, zs):
                b.frustum(0.045, 0.045, (0.0, 0.1), "glass", segments=18, bevel=0.006)
                b.add(*_beans(k))
                b.frustum(0.047, 0.045, (0.1, 0.118), "cork", segments=18)
    b.surface("top", (-d / 2 + 0.215, d / 2 - 0.014), (y[0] + 0.01, y[1] - 0.01), z)
    b.surface("shelf", (xs[0] + 0.01, xs[1] - 0.01), (y[0] + 0.45, y[1] - 0.03), zs)
    b.fit()


def _beans(k: int):
    from sceneweaver.assets import shapes

    look = ("coffee", "chocolate", "icing")[k]
    return shapes.frustum(0.04, 0.04, (0.004, 0.055 + 0.012 * k), 16), look, []
