"""Tables for children, plants and babies."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..joinery import door, drawer
from ..registry import draws
from .tables_parts import apron, cone_leg, corner_legs, ellipse, pedestal, proud, rounded, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "cherry", "ash grey wood", "pine")
PAINTS = ("white paint", "cream paint", "sage paint", "light grey paint")


@draws("round_coffee_table")
def round_coffee_table(b: Builder) -> None:
    """A low round top on splayed legs, a drum of slats, a steel basket, or two discs on posts with a shelf."""
    d, w, h = b.size
    r = min(d, w) / 2
    kind = b.pick("kind", ["splayed", "drum", "wire", "shelf", "cross"])
    tops = {"wire": ("marble", "oak", "glass", "walnut"), "cross": ("marble", "oak", "dark marble")}
    top = b.material("top", *tops.get(kind, (*WOODS, "white paint", "black paint")))
    low = h - (0.014 if top.name == "glass" else 0.026)
    plan = ellipse(r, r, 48)
    with b.solid("all" if kind in ("drum", "wire") else "top"):
        tabletop(b, plan, (low, h), top, edge="soft" if top.name == "glass" else b.pick("edge", ["soft", "knife"]))
    if kind == "splayed":
        with b.solid("top"):
            b.frustum(0.62 * r, 0.62 * r, (low - 0.035, low), top, segments=32)
        corner_legs(
            b,
            (-0.66 * r, 0.66 * r),
            (-0.66 * r, 0.66 * r),
            low,
            top,
            "splayed",
            0.044,
            cap=b.pick("cap", [None, "brass", "white paint"]),
        )
    elif kind == "drum":
        with b.solid("all"):
            count = 36
            for k in range(count):
                with b.frame(yaw=2 * math.pi * k / count):
                    b.box((0.8 * r, 0.86 * r), (-0.026 * r / 0.45, 0.026 * r / 0.45), (0.02, low), top, bevel=0.004)
            b.frustum(0.79 * r, 0.79 * r, (0.0, low), top, segments=36)
    elif kind == "wire":
        metal = b.material("legs", "black steel", "brass", "copper", "white steel")
        with b.solid("all"):
            turn = np.arange(18) * (2 * math.pi / 18)
            for radius, z in ((0.62 * r, 0.006), (0.9 * r, low - 0.006)):
                ring = np.c_[radius * np.cos(turn), radius * np.sin(turn), np.full(18, z)]
                b.tube(ring, 0.006, metal, 6, closed=True)
            for k in range(12):
                for s in (-1, 1):
                    a, c = k * math.pi / 6, k * math.pi / 6 + s * 0.35
                    b.bar(
                        (0.62 * r * math.cos(a), 0.62 * r * math.sin(a), 0.006),
                        (0.9 * r * math.cos(c), 0.9 * r * math.sin(c), low - 0.003),
                        0.004,
                        metal,
                        segments=5,
                    )
    elif kind == "shelf":
        z = 0.12
        with b.solid("shelf"):
            b.extrude(plan * 0.86, (z - 0.02, z), top, bevel=0.004)
        for k in range(4):
            a = math.pi / 4 + k * math.pi / 2
            with b.solid(f"leg {k}"):
                b.bar(
                    (0.8 * r * math.cos(a), 0.8 * r * math.sin(a), 0),
                    (0.8 * r * math.cos(a), 0.8 * r * math.sin(a), low),
                    0.018,
                    top,
                    segments=14,
                )
        b.surface("shelf", (-0.5 * r, 0.5 * r), (-0.5 * r, 0.5 * r), z, round(low - z - 0.005, 4))
    else:
        pedestal(b, low, 0.7 * r, b.material("foot", "black steel", "brass", "oak"), "drum")


@draws("nesting_tables")
def nesting_tables(b: Builder) -> None:
    """Two or three tables of one form, the smaller ones drawn out from under the largest."""
    d, w, h = b.size
    round_tops = b.chance("round", 0.5)
    top = b.material("top", "oak", "walnut", "marble", "white paint", "light oak", "glass")
    metal = b.material("legs", "brass", "black steel", "oak", "white steel")
    bar = 0.03 if metal.name == "oak" else 0.018
    big = min(d, 0.74 * w)
    small = big * 0.78
    if round_tops:
        big = d
        small = max(0.62 * big, min(0.78 * big, w - 0.5 * big))
    for name, size, at, high in (("large", big, -w / 2, h), ("small", small, w / 2 - small, h - 0.09)):
        r = size / 2
        low = high - (0.012 if top.name == "glass" else 0.02)
        with b.frame(0, at + r):
            with b.solid(name):
                if round_tops:
                    tabletop(b, ellipse(r, r, 40), (low, high), top, name=None)
                else:
                    deep = d / 2 if name == "large" else 0.4 * d
                    tabletop(b, rounded((-deep, deep), (-r, r), 0.015, 3), (low, high), top, name=None)
            if name == "large":
                if round_tops:
                    b.surface("top", (0, 0), (0, 0), high, polygon=ellipse(r - 0.012, r - 0.012, 20))
                else:
                    b.surface("top", (-d / 2 + 0.01, d / 2 - 0.01), (-r + 0.01, r - 0.01), high)
            if round_tops:
                for k in range(3):
                    a = math.pi + k * 2 * math.pi / 3
                    px, py = 0.82 * r * math.cos(a), 0.82 * r * math.sin(a)
                    with b.solid(f"{name} leg {k}"):
                        cone_leg(b, (px, py, 0), (px * 0.9, py * 0.9, low), bar * 0.4, bar * 0.5, metal, 10)
            else:
                deep = d / 2 if name == "large" else 0.4 * d
                for k, px in enumerate((-deep + bar, deep - bar)):
                    with b.solid(f"{name} side {k}"):
                        xs = (px - bar / 2, px + bar / 2)
                        b.box(xs, (-r + 0.01, -r + 0.01 + bar), (0, low), metal)
                        b.box(xs, (r - 0.01 - bar, r - 0.01), (0, low), metal)
                        b.box(xs, (-r + 0.01 + bar, r - 0.01 - bar), (low - bar, low), metal)
                        if name == "large":
                            continue
                        b.box(xs, (-r + 0.01 + bar, r - 0.01 - bar), (0, bar), metal)


@draws("kids_table")
def kids_table(b: Builder) -> None:
    """A low table for small children with round corners, thick legs in bright colours, and a rail for a paper roll."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", "white paint", "birch", "beech", "light oak", "yellow paint", "blue paint")
    bright = ("red paint", "blue paint", "yellow paint", "green paint", "teal paint")
    low = h - 0.022
    kind = b.pick("kind", ["pegs", "square", "splayed"])
    with b.solid("top"):
        tabletop(b, rounded(x, y, b.pick("corner", [0.06, 0.12]), 6), (low, h), top)
        apron(b, (x[0] + 0.06, x[1] - 0.06), (y[0] + 0.06, y[1] - 0.06), (low - 0.05, low), top)
    legs = b.material("legs", *bright, "birch")
    several = b.chance("several colours", 0.5)
    for k, (sx, sy) in enumerate(((-1, -1), (-1, 1), (1, -1), (1, 1))):
        look = b.material(f"leg {k}", bright[k]) if several else legs
        px, py = sx * (d / 2 - 0.07), sy * (w / 2 - 0.07)
        with b.solid(f"leg {k}"):
            if kind == "square":
                b.box((px - 0.026, px + 0.026), (py - 0.026, py + 0.026), (0, low), look, bevel=0.008)
            else:
                out = 0.035 if kind == "splayed" else 0.0
                cone_leg(b, (px + sx * out, py + sy * out, 0), (px, py, low), 0.022, 0.03, look, 16)
    b.clear(x, (y[0] + 0.13, y[1] - 0.13), (0, 0.36))


@draws("train_table")
def train_table(b: Builder) -> None:
    """A low table with a rim, a painted landscape, an oval of wooden track with a bridge, trees, houses and a train."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wood = b.material("frame", "pine", "beech", "birch", "white paint", "light oak")
    floor, rim = h - 0.11, h - 0.075
    with b.solid("top"):
        b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), (floor - 0.02, floor), "green paint", bevel=0.0)
        apron(b, x, y, (floor - 0.08, rim), wood)
        b.extrude(ellipse(0.16 * d, 0.13 * w, 24) + (0.06 * d, 0.12 * w), (floor - 0.001, floor + 0.001), "blue paint")
        a, c, n = 0.36 * d, 0.38 * w, 28
        ring = np.c_[ellipse(a, c, n, 2.6), np.full(n, floor + 0.006)]
        b.tube(ring, np.array([(-0.02, -0.006), (0.02, -0.006), (0.02, 0.006), (-0.02, 0.006)]), "beech", closed=True)
        tr = np.c_[ellipse(a, c, n, 2.6), np.full(n, floor + 0.013)]
        for k in range(0, n, 2):
            sleeper = shapes.box(
                (tr[k, 0] - 0.005, tr[k, 0] + 0.005),
                (tr[k, 1] - 0.005, tr[k, 1] + 0.005),
                (floor + 0.01, floor + 0.0124),
            )
            b.add(sleeper, "walnut", hulls=[])
        for k in range(4):
            at = -0.12 + 0.068 * k
            look = ("red paint", "yellow paint", "blue paint", "green paint")[k]
            px = -a
            car = shapes.box((px - 0.017, px + 0.017), (at - 0.028, at + 0.028), (floor + 0.018, floor + 0.045), 0.004)
            room = shapes.box((px - 0.02, px + 0.02), (at - 0.028, at + 0.028), (floor + 0.012, floor + 0.045))
            b.add(car, look, hulls=[room])
            for s in (-1, 1):
                wheel = shapes.box(
                    (px - 0.02, px + 0.02),
                    (at + s * 0.017 - 0.007, at + s * 0.017 + 0.007),
                    (floor + 0.012, floor + 0.024),
                    0.003,
                )
                b.add(wheel, "black plastic", hulls=[])
            if k == 3:
                with b.frame(px, at + 0.012):
                    b.frustum(0.008, 0.01, (floor + 0.045, floor + 0.066), "black plastic", segments=10)
                b.box((px - 0.016, px + 0.016), (at - 0.027, at - 0.006), (floor + 0.045, floor + 0.065), "blue paint")
    for k in range(7):
        px, py = b.uniform(f"tree x {k}", -0.24, 0.24) * d, b.uniform(f"tree y {k}", -0.26, 0.0) * w
        with b.solid("trees"), b.frame(px, py, floor):
            b.frustum(0.006, 0.006, (0, 0.03), "bark", segments=8)
            high = b.uniform(f"tree {k}", 0.07, 0.1)
            b.frustum(0.03, 0.004, (0.025, high), "dark leaf", segments=12)
    for k, (px, py, roof) in enumerate(((-0.16, 0.17, "red paint"), (-0.02, 0.27, "blue paint"))):
        with b.solid("houses"), b.frame(px * d, py * w, floor, yaw=0.3 * k):
            b.box((-0.03, 0.03), (-0.035, 0.035), (0, 0.05), "cream paint", bevel=0.0)
            b.hull(
                [(px2, py2, 0.05) for px2 in (-0.036, 0.036) for py2 in (-0.041, 0.041)]
                + [(0, -0.041, 0.09), (0, 0.041, 0.09)],
                roof,
            )
    with b.solid("trees"), b.frame(-0.1 * d, -0.05 * w, floor):
        b.frustum(0.007, 0.007, (0, 0.03), "bark", segments=8)
        b.frustum(0.034, 0.003, (0.025, 0.11), "leaf", segments=12)
    corner_legs(b, (x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), floor - 0.02, wood, "square", 0.06)


@draws("plant_stand")
def plant_stand(b: Builder) -> None:
    """A small round top on three slim legs, a tripod with a ring, or a turned column."""
    d, w, h = b.size
    r = min(d, w) / 2
    kind = b.pick("kind", ["legs", "column", "wire", "two tiers"])
    top = b.material("top", *WOODS, "white paint", "black steel", "brass", "rattan")
    low = h - 0.02
    with b.solid("top"):
        tabletop(b, ellipse(r, r, 36), (low, h), top)
    if kind == "column":
        with b.solid("foot"):
            b.lathe(
                [
                    (r * 0.9, 0.0),
                    (r * 0.9, 0.015),
                    (r * 0.84, 0.025),
                    (r * 0.5, 0.035),
                    (0.032, 0.06),
                    (0.02, 0.1),
                    (0.03, 0.108),
                    (0.03, 0.118),
                    (0.018, 0.13),
                    (0.016, 0.36 * h),
                    (0.024, 0.44 * h),
                    (0.033, 0.52 * h),
                    (0.035, 0.57 * h),
                    (0.03, 0.62 * h),
                    (0.017, 0.68 * h),
                    (0.028, 0.69 * h),
                    (0.028, 0.705 * h),
                    (0.017, 0.72 * h),
                    (0.019, 0.86 * h),
                    (0.04, low - 0.015),
                    (r * 0.55, low - 0.006),
                    (r * 0.55, low),
                ],
                top,
                segments=24,
            )
        return
    plain = top.name in ("black steel", "brass", "white paint") or b.chance("plain", 0.33)
    metal = top if plain else b.material("legs", "black steel", "brass")
    count = 3 if kind != "two tiers" else 4
    for k in range(count):
        a = math.pi / count + k * 2 * math.pi / count
        c, s = math.cos(a), math.sin(a)
        foot, head = (0.93 if kind != "two tiers" else 0.82) * r, (0.62 if kind != "two tiers" else 0.82) * r
        with b.solid(f"leg {k}"):
            cone_leg(b, (foot * c, foot * s, 0), (head * c, head * s, low), 0.008, 0.011, metal, 10)
    z = 0.3 * h if kind == "two tiers" else 0.45 * h
    at = 0.82 * r if kind == "two tiers" else (0.93 - 0.31 * z / low) * r
    with b.solid("middle"):
        if kind == "wire":
            turn = np.arange(24) * (math.pi / 12)
            b.tube(np.c_[at * np.cos(turn), at * np.sin(turn), np.full(24, z)], 0.006, metal, 6, closed=True)
        else:
            b.extrude(ellipse(at, at, 32), (z - 0.015, z), top, bevel=0.003)
    if kind == "two tiers":
        q = 0.5 * r
        b.surface("shelf", (-q, q), (-q, q), z, round(low - z - 0.005, 4))


@draws("changing_table")
def changing_table(b: Builder) -> None:
    """A chest of drawers, or two open shelves with baskets, under a padded mat with raised sides."""
    d, w, h = b.size
    kind = b.pick("kind", ["drawers", "shelves", "doors"])
    style = b.pick("pull style", ["knob", "cup", "bar"])
    wood = b.material("body", "white paint", "light oak", "beech", "birch", "sage paint", "light grey paint")
    front = b.material("fronts", "white paint", "birch", "light oak") if b.chance("two tone", 0.4) else wood
    out = 0.0 if kind == "shelves" else proud(style)
    x, y = (-d / 2, d / 2 - out), (-w / 2, w / 2)
    deck = h - 0.1
    with b.solid("rim"):
        b.box((x[0], x[1]), y, (deck - 0.02, deck), wood)
        for ys in ((y[0], y[0] + 0.018), (y[1] - 0.018, y[1])):
            b.box((x[0], x[1] - 0.01), ys, (deck, h), wood, bevel=0.005)
        b.box((x[0], x[0] + 0.018), (y[0] + 0.018, y[1] - 0.018), (deck, h), wood, bevel=0.005)
        mat = b.material("mat", "white fabric", "beige fabric", "grey fabric", "rose fabric", "green fabric")
        xs, ys = (x[0] + 0.025, x[1] - 0.01), (y[0] + 0.025, y[1] - 0.025)
        b.cushion(xs, ys, (deck, deck + 0.045), mat, radius=0.02)
        b.cushion(xs, (ys[0], ys[0] + 0.1), (deck + 0.02, deck + 0.085), mat, radius=0.03)
        b.cushion(xs, (ys[1] - 0.1, ys[1]), (deck + 0.02, deck + 0.085), mat, radius=0.03)
        b.cushion(
            (xs[0] + 0.02, xs[0] + 0.16), (-0.13, 0.13), (deck + 0.04, deck + 0.075), "white fabric", radius=0.015
        )
    z = (0.08, deck - 0.02)
    face = x[1] - 0.004
    if kind == "shelves":
        corner_legs(b, (x[0], x[1] - 0.01), y, deck - 0.02, wood, "square", 0.045)
        basket = b.material("basket", "rattan", "wicker", "grey fabric")
        for k, level in enumerate((0.14, 0.48)):
            with b.solid(f"shelf {k}"):
                b.box((x[0] + 0.01, x[1] - 0.02), (y[0] + 0.01, y[1] - 0.01), (level - 0.02, level), wood)
            if k == 0:
                with b.solid("baskets"):
                    for s in (-1, 1):
                        at = s * 0.22 * w
                        ys, xs = (at - 0.18 * w, at + 0.18 * w), (x[0] + 0.06, x[1] - 0.06)
                        b.box(xs, ys, (level, level + 0.19), basket, bevel=0.02)
                        b.box(
                            (xs[0] - 0.006, xs[1] + 0.006),
                            (ys[0] - 0.006, ys[1] + 0.006),
                            (level + 0.17, level + 0.195),
                            basket,
                            bevel=0.008,
                        )
            else:
                b.surface(
                    "shelf",
                    (x[0] + 0.05, x[1] - 0.06),
                    (y[0] + 0.05, y[1] - 0.05),
                    level,
                    round(z[1] - level - 0.005, 4),
                )
        return
    pull = b.material("pulls", "brass", "beech", "brushed steel", "black steel")
    with b.solid("body"):
        b.box((x[0] + 0.005, face - 0.019), (y[0] + 0.005, y[1] - 0.005), z, wood)
        corner_legs(b, (x[0] + 0.02, face - 0.03), (y[0] + 0.02, y[1] - 0.02), 0.08, wood, "tapered", 0.045, "body")
        ys = (y[0] + 0.005, y[1] - 0.005)
        if kind == "drawers":
            count = 3
            step = (z[1] - z[0]) / count
            for k in range(count):
                drawer(
                    b,
                    f"drawer-{k}",
                    (x[0] + 0.03, face),
                    ys,
                    (z[0] + k * step, z[0] + (k + 1) * step),
                    front,
                    pull,
                    style,
                )
        else:
            drawer(b, "drawer", (x[0] + 0.03, face), ys, (z[1] - 0.2, z[1]), front, pull, style)
            for s in (-1, 1):
                half = (0.0, ys[1]) if s > 0 else (ys[0], 0.0)
                door(
                    b,
                    f"door {s}".replace(" ", ""),
                    (face - 0.018, face),
                    half,
                    (z[0], z[1] - 0.2),
                    front,
                    pull,
                    hung="left" if s > 0 else "right",
                    style="knob" if style == "cup" else style,
                )
