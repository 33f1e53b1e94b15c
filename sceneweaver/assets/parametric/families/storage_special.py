"""Lockers, chests, racks for wine, bar furniture, carts, safes and trophies."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from ..joinery import door
from ..registry import draws
from .storage_parts import SHADOW, case, feet, pulls, split


@draws("locker")
def locker(b: Builder) -> None:
    """Steel doors with slots for air, one or two over each other, on feet."""
    d, w, h = b.size
    steel = b.material("body", "grey paint", "light grey paint", "blue paint", "navy paint")
    fronts = b.material("doors", "blue paint", "red paint", "green paint", "teal paint", "yellow paint", "grey paint")
    metal = b.material("locks", "brushed steel", "chrome")
    x, y = (-d / 2, d / 2 - 0.022), (-w / 2, w / 2)
    columns, rows = max(1, round(w / 0.32)), b.pick("rows", [1, 1, 2])
    with b.solid("body"):
        feet(b, x, y, 0.1, steel, "square" if b.chance("legs", 0.4) else "plinth")
        _, fy, fz = case(b, x, y, (0.1, h), steel, 0.014)
        for k, ys in enumerate(split(fy, columns, 0.004)):
            for j, zs in enumerate(split(fz, rows, 0.006)):
                side = (ys[0] + ys[1]) / 2
                wide = 0.3 * (ys[1] - ys[0])
                at = (x[1], ys[1], zs[0])
                with b.hinge(f"door-{k}-{j}", at, limits=(0.0, 1.92)):
                    b.box(
                        (x[1] - 0.018, x[1]),
                        (ys[0] + 0.002, ys[1] - 0.002),
                        (zs[0] + 0.002, zs[1] - 0.002),
                        fronts,
                        bevel=0.002,
                    )
                    for z in (zs[1] - 0.08, zs[0] + 0.07):
                        slot = (x[1], x[1] + 0.0025), (side - wide, side + wide)
                        cover = shapes.box(*slot, (z, z + 0.06), 0.0)
                        for s in range(4):
                            low = z + 0.018 * s
                            b.add(shapes.box(*slot, (low, low + 0.006), 0.0), SHADOW, hulls=[] if s else [cover])
                    high = (zs[0] + zs[1]) / 2 if rows == 2 else 1.05
                    b.box(
                        (x[1], x[1] + 0.006),
                        (ys[0] + 0.012, ys[0] + 0.042),
                        (high - 0.06, high + 0.06),
                        metal,
                        bevel=0.002,
                    )
                    b.box(
                        (x[1] + 0.006, x[1] + 0.022), (ys[0] + 0.02, ys[0] + 0.034), (high - 0.03, high + 0.03), metal
                    )
                    b.box(
                        (x[1], x[1] + 0.003),
                        (side - 0.03, side + 0.03),
                        (zs[1] - 0.14, zs[1] - 0.11),
                        "paper",
                        bevel=0.0,
                    )


@draws("chest")
def chest(b: Builder) -> None:
    """A blanket chest with a flat lid or a trunk with a round one, bands and handles."""
    d, w, h = b.size
    wood = b.material("body", "oak", "pine", "walnut", "brown leather", "navy paint", "white paint")
    metal = b.material("fittings", "iron", "brass", "bronze")
    domed = b.chance("domed", 0.5)
    x, y = (-d / 2 + 0.004, d / 2 - 0.012), (-w / 2 + 0.018, w / 2 - 0.018)
    low = h - (0.28 * h if domed else 0.05)
    bands = (-w * 0.3, w * 0.3)
    with b.solid("body"):
        b.box((x[0], x[1]), y, (0.03, low - 0.003), wood)
        b.box((x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), (low - 0.003, low), SHADOW, bevel=0.0)
        for xs in ((x[0], x[0] + 0.07), (x[1] - 0.07, x[1])):
            for ys in ((y[0], y[0] + 0.07), (y[1] - 0.07, y[1])):
                b.box(xs, ys, (0.0, 0.03), wood)
        if domed:
            for at in bands:
                b.box((x[1], x[1] + 0.003), (at - 0.02, at + 0.02), (0.03, low - 0.003), metal, bevel=0.0)
        else:
            b.box((x[0], x[1] + 0.006), (y[0] - 0.006, y[1] + 0.006), (0.03, 0.09), wood)
            for ys in split((y[0] + 0.05, y[1] - 0.05), 3, 0.05):
                b.box((x[1], x[1] + 0.006), ys, (0.13, low - 0.05), wood)
        b.box((x[1], x[1] + 0.008), (-0.03, 0.03), (low - 0.07, low - 0.006), metal, bevel=0.002)
        for sy in (-1, 1):
            with b.frame(0.0, sy * y[1], yaw=sy * np.pi / 2):
                b.bar((0.012, -0.06, low * 0.7), (0.012, 0.06, low * 0.7), 0.006, metal, segments=8)
                for py in (-0.055, 0.055):
                    b.box((0.0, 0.014), (py - 0.01, py + 0.01), (low * 0.7 - 0.012, low * 0.7 + 0.012), metal)
        if domed:
            with b.hinge("lid", (x[0], 0.0, low), axis=(0.0, -1.0, 0.0), limits=(0.0, 1.6)):
                arc = np.linspace(0, np.pi, 13)
                mid, rx = (x[0] + x[1]) / 2, (x[1] - x[0]) / 2

                def dome(ys: tuple[float, float], grow: float, look) -> None:
                    rim = [
                        (mid + (rx + grow) * np.cos(v), low + 0.04 + (h - low - 0.044 + grow) * np.sin(v)) for v in arc
                    ]
                    rim += [(x[0], low), (x[1] + grow, low)]
                    b.hull([(px, py, pz) for px, pz in rim for py in ys], look)

                dome(y, 0.0, wood)
                for at in bands:
                    dome((at - 0.02, at + 0.02), 0.004, metal)
                b.box((x[1] + 0.004, x[1] + 0.012), (-0.02, 0.02), (low, low + 0.05), metal, bevel=0.002)
        else:
            b.box((-d / 2 + 0.004, d / 2), (-w / 2, w / 2), (low, h), wood, bevel=0.008)
    if not domed:
        b.surface("top", (-d / 2 + 0.02, d / 2 - 0.02), (-w / 2 + 0.02, w / 2 - 0.02), h)
    b.fit()


@draws("safe")
def safe(b: Builder) -> None:
    """A steel block with a thick door, a dial or keys, and a turning handle."""
    d, w, h = b.size
    steel = b.material("body", "grey paint", "black paint", "navy paint", "green paint", "light grey paint")
    metal = b.material("handle", "chrome", "brass", "brushed steel")
    x, y = (-d / 2, d / 2 - 0.055), (-w / 2, w / 2)
    with b.solid("body"):
        b.box((x[0] + 0.03, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (0.0, 0.025), "rubber", bevel=0.0)
        b.box(x, y, (0.025, h), steel, bevel=0.008)
        b.box((x[1], x[1] + 0.003), (y[0] + 0.03, y[1] - 0.03), (0.055, h - 0.03), SHADOW, bevel=0.0)
        inner = (y[0] + 0.035, y[1] - 0.035)
        with b.hinge("door", (x[1] + 0.021, inner[0], 0.06), limits=(-1.92, 0.0)):
            f = x[1] + 0.021
            b.box((x[1] + 0.003, f), inner, (0.06, h - 0.035), steel, bevel=0.004)
            middle = 0.55 * h
            with b.frame(f, 0.12 * w, middle, pitch=np.pi / 2):
                b.lathe([(0.035, 0.0), (0.035, 0.006), (0.024, 0.01), (0.02, 0.026)], metal, segments=20)
            with b.frame(f, -0.14 * w, middle, pitch=np.pi / 2):
                b.frustum(0.018, 0.014, (0.0, 0.026), metal, segments=14)
                for k in range(3):
                    with b.frame(yaw=k * 2 * np.pi / 3 + 0.5):
                        b.bar((0.0, 0.0, 0.022), (0.07, 0.0, 0.022), 0.006, metal, segments=8)
            b.box((f, f + 0.002), (-0.06, 0.06), (h - 0.12, h - 0.09), metal, bevel=0.0)
        for z in (0.12, h - 0.14):
            with b.frame(x[1] + 0.012, y[0] + 0.022, z):
                b.frustum(0.012, 0.012, (0.0, 0.06), metal, segments=12)
    b.surface("top", (x[0] + 0.015, x[1] - 0.015), (y[0] + 0.015, y[1] - 0.015), h)
    b.fit()


@draws("wine_rack")
def wine_rack(b: Builder) -> None:
    """A case of crossed or square pigeonholes with bottles lying in them."""
    d, w, h = b.size
    wood = b.material("body", "oak", "walnut", "pine", "black paint", "mahogany")
    t = 0.02
    with b.solid("body"):
        for ys in ((-w / 2, -w / 2 + t), (w / 2 - t, w / 2)):
            b.box((-d / 2, d / 2 - 0.03), ys, (0.0, h), wood)
        inner = (-w / 2 + t, w / 2 - t)
        b.box((-d / 2, d / 2 - 0.03), inner, (h - t, h), wood)
        b.box((-d / 2, d / 2 - 0.05), inner, (0.0, 0.05), wood)
        columns, rows = max(3, round((w - 2 * t) / 0.115)), max(3, round((h - 0.07) / 0.115))
        ys, zs = split(inner, columns, 0.012), split((0.062, h - t), rows, 0.012)
        b.box((-d / 2, -d / 2 + 0.008), inner, (0.05, h - t), wood, bevel=0.0)
        for k in range(rows):
            b.box((-d / 2 + 0.008, d / 2 - 0.034), inner, (zs[k][0] - 0.012, zs[k][0]), wood, bevel=0.0)
        for k in range(1, columns):
            b.box((-d / 2 + 0.008, d / 2 - 0.036), (ys[k][0] - 0.012, ys[k][0]), (0.062, h - t), wood, bevel=0.0)
        left = 26
        for k in range(columns):
            for j in range(rows):
                if left and b.chance(f"bottle {k} {j}", min(0.6, 24 / (columns * rows))):
                    left -= 1
                    r = min(0.037, (ys[k][1] - ys[k][0]) / 2 - 0.002, (zs[j][1] - zs[j][0]) / 2 - 0.002)
                    glass = b.pick(f"glass {k} {j}", ["green glass", "black glass", "amber glass"])
                    foil = b.pick(f"foil {k} {j}", ["red paint", "brass", "black paint", "navy paint"])
                    with b.frame(-d / 2 + 0.012, (ys[k][0] + ys[k][1]) / 2, zs[j][0] + r + 0.001, pitch=np.pi / 2):
                        long = d - 0.014
                        profile = [(r, 0.0), (r, long * 0.62), (0.015, long * 0.8), (0.0145, long * 0.87)]
                        body = shapes.lathe(profile, 12)
                        neck = shapes.frustum(0.0155, 0.0155, (long * 0.87, long), 12, 0.0)
                        b.add(body, glass, hulls=[shapes.hull(np.concatenate([body[0], neck[0]]))])
                        b.add(neck, foil, hulls=[])
    b.surface("top", (-d / 2 + 0.01, d / 2 - 0.04), (-w / 2 + 0.01, w / 2 - 0.01), h)
    b.fit()


def _bottle(b: Builder, x: float, y: float, z: float, k: int, high: float = 0.29) -> None:
    """A bottle of some spirit with a label."""
    glass = b.pick(f"spirit {k}", ["amber glass", "green glass", "glass", "black glass"])
    r = b.uniform(f"girth {k}", 0.03, 0.038)
    with b.frame(x, y, z):
        b.lathe([(r, 0.0), (r, high * 0.58), (0.013, high * 0.74), (0.013, high * 0.92)], glass, segments=14)
        b.frustum(0.015, 0.015, (high * 0.92, high), b.pick(f"cap {k}", ["cork", "black paint", "brass"]), segments=10)
        b.frustum(r + 0.0006, r + 0.0006, (high * 0.15, high * 0.45), "paper", segments=14)


@draws("bar_cabinet")
def bar_cabinet(b: Builder) -> None:
    """Two doors below, an open niche with bottles and a rack of glasses above."""
    d, w, h = b.size
    wood = b.material("body", "walnut", "mahogany", "oak", "black paint", "navy paint")
    style, pull, reach = pulls(b, wood, "knob", "bar")
    x, y = (-d / 2, d / 2 - reach), (-w / 2, w / 2)
    niche = 0.44
    with b.solid("body"):
        feet(b, x, y, 0.14, wood, b.pick("base", ["tapered", "square", "splayed"]))
        _, fy, fz = case(b, x, y, (0.14, h - niche), wood)
        for k, ys in enumerate(split(fy, 2)):
            door(
                b,
                f"door-{k}",
                (x[1] - 0.018, x[1]),
                ys,
                fz,
                wood,
                pull,
                hung="right" if k == 0 else "left",
                style=style,
                panel="rattan" if b.style in ("scandinavian", "rustic") else wood,
            )
    for k, ys in enumerate(((y[0], y[0] + 0.018), (y[1] - 0.018, y[1]))):
        with b.solid(f"side-{k}"):
            b.box(x, ys, (h - niche, h - 0.02), wood)
    inner = (y[0] + 0.018, y[1] - 0.018)
    with b.solid("back"):
        b.box((x[0], x[0] + 0.006), inner, (h - niche, h - 0.02), "mirror", bevel=0.0)
        count = max(3, int((inner[1] - inner[0]) / 0.12))
        for k in range(count):
            if b.chance(f"bottle {k}", 0.75):
                _bottle(
                    b,
                    x[0] + 0.06,
                    inner[0] + (k + 0.5) * (inner[1] - inner[0]) / count,
                    h - niche,
                    k,
                    b.uniform(f"high {k}", 0.24, 0.32),
                )
    with b.solid("top"):
        b.box(x, y, (h - 0.02, h), wood, bevel=0.004)
    b.surface(
        "counter", (x[0] + 0.12, x[1] - 0.01), (inner[0] + 0.005, inner[1] - 0.005), h - niche, headroom=niche - 0.025
    )
    b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)


def _castor(b: Builder, x: float, y: float, r: float = 0.03) -> None:
    """A small wheel under a corner."""
    with b.frame(x, y, r, roll=np.pi / 2):
        b.frustum(r, r, (-0.011, 0.011), "black plastic", segments=16)
    b.box((x - 0.012, x + 0.012), (y - 0.016, y + 0.016), (r, 2 * r + 0.012), "brushed steel", bevel=0.001)


@draws("bar_cart")
def bar_cart(b: Builder) -> None:
    """Two trays in a round-tube frame with a handle, on castors."""
    d, w, h = b.size
    metal = b.material("frame", "brass", "black steel", "chrome", "copper")
    tray = b.material("trays", "glass", "walnut", "dark marble", "marble", "oak")
    r, x, y = 0.009, d / 2 - 0.009, w / 2 - 0.05
    for k, sy in enumerate((-1, 1)):
        with b.solid(f"frame-{k}"):
            for sx in (-1, 1):
                _castor(b, sx * (x - 0.012), sy * y)
                b.bar((sx * x, sy * y, 0.06), (sx * x, sy * y, h - 0.05), r, metal)
            b.tube(
                [
                    (-x, sy * y, h - 0.05),
                    (-x, sy * (y + 0.041), h - r),
                    (x, sy * (y + 0.041), h - r),
                    (x, sy * y, h - 0.05),
                ],
                r,
                metal,
            )
    levels = (0.2, h - 0.16)
    for k, z in enumerate(levels):
        with b.solid(f"tray-{k}"):
            b.box((-x, x), (-y, y), (z - 0.012, z), tray)
        with b.solid(f"rail-{k}"):
            b.bar((-x, -y, z + 0.05), (-x, y, z + 0.05), 0.005, metal, segments=8)
            if k == 0:
                for j in range(b.whole("bottles", 2, 4)):
                    _bottle(b, -x + 0.06, -y + 0.09 + 0.1 * j, z, j, 0.27 + 0.02 * (j % 3))
        room = None if k else round(levels[1] - 0.016 - z, 4)
        b.surface(
            "top" if k else "shelf-0", (-x + (0.02 if k else 0.11), x - 0.015), (-y + 0.02, y - 0.02), z, headroom=room
        )
    b.fit()


@draws("storage_cart")
def storage_cart(b: Builder) -> None:
    """Three trays with rims between four posts, on castors."""
    d, w, h = b.size
    steel = b.material("frame", "white steel", "black steel", "teal paint", "grey paint", "yellow paint", "blue paint")
    post, lip, t = 0.016, 0.045, 0.003
    for k, sy in enumerate((-1, 1)):
        with b.solid(f"side-{k}"):
            for sx in (-1, 1):
                cx, cy = sx * (d / 2 - post / 2), sy * (w / 2 - post / 2)
                b.box((cx - post / 2, cx + post / 2), (cy - post / 2, cy + post / 2), (0.06, h - 0.01), steel)
                _castor(b, sx * (d / 2 - 0.035), sy * (w / 2 - 0.018), 0.028)
            ys = sorted((sy * w / 2, sy * (w / 2 - post)))
            b.box((-d / 2, d / 2), (ys[0], ys[1]), (h - 0.016, h), steel)
    x, y = (-d / 2 + 0.004, d / 2 - 0.004), (-w / 2 + 0.016, w / 2 - 0.016)
    levels = [0.1 + k * (h - 0.2) / 2 for k in range(3)]
    for k, z in enumerate(levels):
        with b.solid(f"tray-{k}"):
            b.box(x, y, (z - t, z), steel, bevel=0.0)
        with b.solid("rims-front"):
            b.box((x[1] - t, x[1]), y, (z, z + lip), steel, bevel=0.0)
        with b.solid("rims-back"):
            b.box((x[0], x[0] + t), y, (z, z + lip), steel, bevel=0.0)
        with b.solid("side-0"):
            b.box((x[0] + t, x[1] - t), (y[0], y[0] + t), (z - t, z + lip), steel, bevel=0.0)
        with b.solid("side-1"):
            b.box((x[0] + t, x[1] - t), (y[1] - t, y[1]), (z - t, z + lip), steel, bevel=0.0)
        room = None if k == 2 else round(levels[k + 1] - z - t - 0.004, 4)
        b.surface(
            "top" if k == 2 else f"shelf-{k}",
            (x[0] + 0.01, x[1] - 0.01),
            (y[0] + 0.025, y[1] - 0.025),
            z,
            headroom=room,
        )


@draws("trophy_case")
def trophy_case(b: Builder) -> None:
    """A wide glass case on a wooden foot with cups on its boards."""
    d, w, h = b.size
    wood = b.material("body", "oak", "walnut", "mahogany", "black paint")
    x, y = (-d / 2, d / 2 - 0.025), (-w / 2, w / 2)
    foot, roof, t = 0.45, h - 0.08, 0.03
    levels = [foot + k * (roof - foot) / 2 for k in range(2)]
    with b.solid("case"):
        b.box((x[0] + 0.01, x[1] - 0.03), (y[0] + 0.02, y[1] - 0.02), (0.0, 0.07), SHADOW, bevel=0.0)
        b.box(x, y, (0.07, foot), wood)
        for ys in split((y[0] + 0.05, y[1] - 0.05), 3, 0.05):
            b.box((x[1], x[1] + 0.006), ys, (0.13, foot - 0.05), wood)
        b.box(x, y, (roof, h), wood)
        b.box((x[0], x[0] + 0.008), y, (foot, roof), wood, bevel=0.0)
        for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
            b.box((x[1] - t, x[1] - 0.02), ys, (foot, roof), wood, bevel=0.001)
            middle = (ys[0] + ys[1]) / 2
            b.box((x[0] + 0.008, x[1] - t), (middle - 0.003, middle + 0.003), (foot, roof), "glass", bevel=0.0)
        b.box((x[0] + 0.008, x[1] - t), (y[0] + t, y[1] - t), (levels[1] - 0.008, levels[1]), "glass", bevel=0.0)
        count = max(3, round(w / 0.36))
        for j, z in enumerate(levels):
            for k in range(count):
                at = y[0] + 0.05 + (k + 0.5) * (w - 0.1) / count
                _trophy(b, (x[0] + x[1] - t) / 2, at, z, min(0.85 * (levels[1] - foot) - 0.02, 0.42), f"{j} {k}")
        for k, ys in enumerate(split(y, 2)):
            door(
                b,
                f"door-{k}",
                (x[1] - 0.02, x[1]),
                ys,
                (foot, roof),
                wood,
                "brass",
                hung="right" if k == 0 else "left",
                style="knob",
                panel="glass",
            )
    b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
    b.fit()


def _trophy(b: Builder, x: float, y: float, z: float, most: float, name: str) -> None:
    """A metal cup on a dark foot."""
    high = most * b.uniform(f"high {name}", 0.55, 1.0)
    metal = b.pick(f"metal {name}", ["brass", "chrome", "bronze"])
    r = min(0.07, 0.26 * high)
    with b.frame(x, y, z):
        b.frustum(r * 0.8, r * 0.7, (0.0, high * 0.15), "black paint", segments=14)
        b.lathe(
            [
                (r * 0.5, high * 0.15),
                (r * 0.18, high * 0.24),
                (r * 0.2, high * 0.4),
                (r * 0.75, high * 0.55),
                (r, high),
            ],
            metal,
            segments=16,
        )
