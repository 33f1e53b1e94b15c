"""Sculptures, statues, globes, clocks, boxes and other things to look at."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box
from ...drawing.components import clock_face
from ..builder import Builder
from ..registry import draws
from .lighting_parts import across

_STONES = ("marble", "white ceramic", "bronze", "dark marble", "concrete", "brass", "terracotta")


@draws("sculpture")
def sculpture(b: Builder) -> None:
    """An abstract piece on a block: a ring, stacked stones, a twisted column, or two leaning shapes."""
    d, w, h = b.size
    look = b.material("body", *_STONES)
    base = b.material("base", "black paint", "walnut", "marble", "dark marble", "oak")
    kind = b.pick("kind", ["ring", "stones", "twist", "arcs"])
    foot = min(0.035, h * 0.12)
    with b.solid("sculpture"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2) if kind != "ring" else (-w * 0.3, w * 0.3), (0.0, foot), base)
        if kind == "ring":
            thick = min(d * 0.3, w * 0.12)
            a = np.arange(24) * (math.pi / 12)
            ry, rz = w / 2 - thick, (h - foot) / 2 - thick + 0.003
            path = np.c_[np.zeros(24), ry * np.cos(a), foot + rz + thick - 0.006 + rz * np.sin(a)]
            b.tube(path, thick, look, 12, closed=True)
        elif kind == "stones":
            z = foot - 0.004
            room = h - z
            for k, share in enumerate((0.36, 0.3, 0.22, 0.16)):
                high = room * share
                r = 0.5 - 0.09 * k
                at = (0.03 * d * (-1) ** k, 0.05 * w * (-1) ** k, z + high / 2)
                b.ball((d * r * 0.86, w * r * 0.86, high / 2), at, look if k % 2 == 0 else base, 18)
                z += high - room * 0.0133
        elif kind == "twist":
            n, k = 14, min(d, w) * 0.36
            for i in range(n):
                rings = []
                for j in (i, i + 1):
                    t = j / n
                    turn, s = 2.2 * t, k * (1.0 - 0.55 * abs(2 * t - 1) ** 1.5 * 0.8)
                    c, q = math.cos(turn), math.sin(turn)
                    rings += [
                        (s * (u * c - v * q), s * (u * q + v * c), foot + (h - foot) * t)
                        for u, v in ((1, 0.6), (-1, 0.6), (-1, -0.6), (1, -0.6))
                    ]
                b.hull(rings, look)
        else:
            for s, tall, one in ((1, 1.0, look), (-1, 0.78, base)):
                top = foot + (h - foot) * tall
                t = np.linspace(0, 1, 8)
                path = np.c_[
                    np.zeros(8), s * (0.16 + 0.2 * np.sin(np.pi * t) - 0.26 * t) * w, foot - 0.006 + (top - foot) * t
                ]
                flat = np.array([[-0.02, -d * 0.2], [0.02, -d * 0.2], [0.02, d * 0.2], [-0.02, d * 0.2]])[:, ::-1][::-1]
                path[-1, 2] = top - 0.012
                b.tube(path, flat, one)
            b.ball((0.1 * w, 0.1 * w, 0.1 * w), (0.0, 0.0, foot + 0.09 * w), "brass", 16)


def _head(b: Builder, x: float, z: float, s: float, look) -> None:
    """A head of height s with its chin at z: skull, jaw, nose, hair and neck."""
    b.ball((s * 0.36, s * 0.3, s * 0.4), (x - s * 0.03, 0, z + s * 0.6), look, 18)
    b.ball((s * 0.25, s * 0.22, s * 0.34), (x + s * 0.08, 0, z + s * 0.33), look, 14)
    b.hull(
        [
            (x + s * u, s * v, z + s * q)
            for u, v, q in (
                (0.3, 0.0, 0.62),
                (0.43, 0.045, 0.4),
                (0.43, -0.045, 0.4),
                (0.26, 0.07, 0.38),
                (0.26, -0.07, 0.38),
            )
        ],
        look,
    )
    for sy in (-1, 1):
        b.ball((s * 0.05, s * 0.03, s * 0.09), (x - s * 0.02, sy * s * 0.295, z + s * 0.5), look, 8)
        b.ball((s * 0.09, s * 0.1, s * 0.03), (x + s * 0.27, sy * s * 0.11, z + s * 0.62), look, 8)
    b.ball((s * 0.05, s * 0.09, s * 0.025), (x + s * 0.315, 0, z + s * 0.24), look, 8)
    rng = np.random.default_rng(3)
    for k in range(18):
        a, e = k * 2.399, 0.15 + 1.3 * (k + 0.5) / 18
        p = np.array(
            [-0.06 + 0.34 * math.cos(a) * math.cos(e), 0.29 * math.sin(a) * math.cos(e), 0.62 + 0.37 * math.sin(e)]
        )
        if p[0] > 0.2 and p[2] < 0.8:
            continue
        r = s * rng.uniform(0.08, 0.1)
        b.ball((r, r, r), (x + s * p[0], s * p[1], z + s * min(p[2], 0.99 - r / s)), look, 8)
    b.frustum(s * 0.2, s * 0.17, (z - s * 0.3, z + s * 0.3), look, 16)


@draws("bust")
def bust(b: Builder) -> None:
    """A head and shoulders of stone on a turned foot."""
    d, w, h = b.size
    look = b.material("stone", "marble", "white ceramic", "bronze", "concrete", "terracotta")
    s = min(h * 0.46, d * 1.05)
    foot = h * 0.2
    with b.solid("bust"):
        k = d * 0.36
        b.lathe([(k, 0.0), (k, foot * 0.2), (k * 0.7, foot * 0.4), (k * 0.55, foot * 0.8), (k * 0.7, foot)], look, 24)
        z1 = h - s
        y = np.array(
            [
                (0.3, foot),
                (0.46, foot + 0.3 * (z1 - foot)),
                (0.5, foot + 0.6 * (z1 - foot)),
                (0.36, z1 - 0.12 * s),
                (0.14, z1),
            ]
        )
        b.hull(
            [
                (d * u * q, sy * w * v * r, z)
                for v, z in y
                for sy in (-1, 1)
                for u, q, r in (
                    (0.5, 0.55 + 0.45 * (v > 0.3), 0.55),
                    (0.3, 1.0, 1.0),
                    (-0.3, 1.0, 1.0),
                    (-0.5, 0.8, 0.55),
                )
            ],
            look,
        )
        with b.frame(d * 0.02):
            _head(b, 0.0, z1 - 0.005, s * 0.99, look)
    b.fit()


@draws("statue")
def statue(b: Builder) -> None:
    """A draped standing figure on a plinth."""
    d, w, h = b.size
    look = b.material("stone", "marble", "bronze", "concrete", "terracotta")
    base = b.material("plinth", "marble", "dark marble", "granite", "concrete")
    p = h * 0.3
    with b.solid("plinth"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, p * 0.14), base, bevel=0.006)
        b.box((-d * 0.42, d * 0.42), (-w * 0.42, w * 0.42), (p * 0.14, p * 0.88), base)
        b.box((-d * 0.48, d * 0.48), (-w * 0.48, w * 0.48), (p * 0.88, p), base, bevel=0.005)
    f = h - p
    head = f * 0.15
    r = min(d, w) * 0.4
    with b.solid("figure"):
        b.frustum(r, r, (p, p + 0.02), look, 24, bevel=0.004)
        rows = [
            (0.8, 0.02),
            (0.66, 0.2),
            (0.6, 0.42),
            (0.66, 0.5),
            (0.46, 0.64),
            (0.6, 0.76),
            (0.56, 0.82),
            (0.2, 0.85),
        ]
        folds = 12
        for (u0, v0), (u1, v1) in zip(rows[:-1], rows[1:], strict=True):
            b.hull(
                [
                    (r * u * 0.72 * math.cos(a), r * u * math.sin(a), p + f * v)
                    for u, v in ((u0, v0), (u1, v1))
                    for a in np.arange(folds) * 2 * math.pi / folds
                ],
                look,
            )
        for k in range(9):
            a = -1.2 + 0.3 * k
            b.bar(
                (0.72 * r * 0.8 * math.cos(a), r * 0.8 * math.sin(a), p + f * 0.02),
                (0.72 * r * 0.5 * math.cos(a), r * 0.5 * math.sin(a), p + f * 0.6),
                0.07 * r,
                look,
                6,
            )
        for s in (-1, 1):
            elbow = (r * 0.1, s * r * 0.86, p + f * 0.6)
            hand = (r * 0.5, s * r * 0.3, p + f * (0.62 if s > 0 else 0.54))
            b.tube([(0, s * r * 0.56, p + f * 0.79), elbow, hand], r * 0.13, look, 10)
            b.ball((r * 0.15, r * 0.13, r * 0.13), hand, look, 10)
        _head(b, 0.0, h - head, head * 0.995, look)


@draws("pedestal")
def pedestal(b: Builder) -> None:
    """A plinth or a fluted column that carries a piece."""
    d, w, h = b.size
    look = b.material("stone", "marble", "white paint", "concrete", "oak", "dark marble", "black paint")
    with b.solid("pedestal"):
        if b.chance("column", 0.55):
            r = min(d, w) * 0.37
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.05), look, bevel=0.004)
            b.lathe([(r * 1.16, 0.05), (r * 1.16, 0.075), (r * 1.02, 0.1)], look, 32)
            t = np.arange(32)
            ring = (
                np.c_[np.cos(t * math.pi / 16), np.sin(t * math.pi / 16)] * np.where(t % 2 == 0, r, r * 0.93)[:, None]
            )
            b.add(shapes.extrusion(ring, (0.1, h - 0.09)), look, [shapes.extrusion(ring[::2], (0.1, h - 0.09))])
            b.lathe([(r * 0.98, h - 0.09), (r * 1.14, h - 0.06), (r * 1.14, h - 0.045)], look, 32)
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.045, h), look, bevel=0.004)
        else:
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.06), look, bevel=0.005)
            b.box((-d * 0.45, d * 0.45), (-w * 0.45, w * 0.45), (0.06, h - 0.035), look)
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.035, h), look, bevel=0.005)
    b.surface("top", (-d / 2 + 0.008, d / 2 - 0.008), (-w / 2 + 0.008, w / 2 - 0.008), h)


@draws("hourglass")
def hourglass(b: Builder) -> None:
    """Two bulbs of glass with sand between wooden discs and posts."""
    r, h = across(b) / 2, b.size.height
    wood = b.material("frame", "walnut", "oak", "brass", "black paint", "mahogany")
    sand = b.material("sand", "sand pigment", "sea pigment", "chalk pigment", "terracotta pigment")
    t = 0.014
    k, m = r * 0.66, h / 2
    with b.solid("hourglass"):
        for z in ((0.0, t), (h - t, h)):
            b.frustum(r, r, z, wood, 28, bevel=0.003)
        for n in range(3):
            a = n * 2.094 + 0.5
            with b.frame(r * 0.82 * math.cos(a), r * 0.82 * math.sin(a)):
                b.lathe([(0.005, t), (0.004, m * 0.6), (0.007, m), (0.004, h - m * 0.6), (0.005, h - t)], wood, 10)
        bulb = [(k * 0.7, t), (k, t + 0.2 * (m - t)), (k * 0.9, t + 0.55 * (m - t)), (k * 0.16, m - 0.003)]
        b.lathe(bulb, "glass", 24)
        b.lathe([(u, h - z) for u, z in reversed(bulb)], "glass", 24)
        b.frustum(k * 0.16, k * 0.16, (m - 0.004, m + 0.004), "glass", 12)
        b.lathe([(k * 0.66, t + 0.001), (k * 0.9, t + 0.2 * (m - t)), (k * 0.1, t + 0.5 * (m - t))], sand, 20)
        b.lathe([(k * 0.1, m + 0.004), (k * 0.72, m + 0.4 * (m - t))], sand, 20)


@draws("desk_globe")
def desk_globe(b: Builder) -> None:
    """A globe with continents, tilted in a half ring on a turned foot."""
    w, h = b.size.width, b.size.height
    metal = b.material("stand", "brass", "walnut", "oak", "black steel", "chrome")
    sea = b.material("sea", "sea pigment", "sky pigment", "night pigment", "sand pigment")
    land = (
        b.material("land", "moss pigment", "ochre pigment", "forest pigment")
        if sea.name != "sand pigment"
        else "wicker"
    )
    r = min(w / 2 - 0.012, (h - 0.07) / 2.14)
    z = h - r - 0.012
    with b.solid("globe"):
        b.lathe(
            [(r * 0.62, 0.0), (r * 0.62, 0.008), (r * 0.5, 0.016), (0.014, 0.03), (0.012, z - r - 0.006)], metal, 28
        )
        with b.frame(0, 0, z, roll=0.41):
            b.ball((r, r, r), (0, 0, 0), sea, 24)
            rng = np.random.default_rng(b.whole("lands", 0, 9))
            spots = [
                (0.4, 0.6, 0.5),
                (0.1, -0.5, 0.42),
                (1.5, 0.5, 0.55),
                (2.2, 0.1, 0.4),
                (3.3, 0.6, 0.45),
                (3.6, -0.4, 0.45),
                (5.0, 0.2, 0.5),
                (5.6, 0.7, 0.4),
                (4.5, -0.5, 0.35),
                (0.0, 1.5, 0.3),
                (0.0, -1.5, 0.35),
            ]
            for lon, lat, size in spots:
                t = np.arange(10) * 0.628
                wide = size * rng.uniform(0.6, 1.1, 10)
                east, north = lon + wide * np.cos(t) / max(0.3, math.cos(lat)), lat + wide * 0.8 * np.sin(t)
                rim = np.c_[np.cos(north) * np.cos(east), np.cos(north) * np.sin(east), np.sin(north)] * r
                heart = rim.mean(axis=0)
                heart *= r / np.linalg.norm(heart)
                middle = (rim + heart) / 2
                middle *= r / np.linalg.norm(middle, axis=1, keepdims=True)
                rings = [rim * 0.97, rim * 1.0025, middle * 1.003, heart[None] * 1.003]
                points = np.concatenate(rings)
                b.add(shapes.hull(points), land)
        a = np.linspace(-math.pi / 2 - 0.41, math.pi / 2 - 0.41, 13)
        ring = r + 0.007
        b.tube(np.c_[np.zeros(13), ring * np.cos(a), z + ring * np.sin(a)], 0.0045, metal, 8)


@draws("table_clock")
def table_clock(b: Builder) -> None:
    """A mantel clock: an arched or square wooden case with a dial and small feet."""
    d, w, h = b.size
    wood = b.material("case", "walnut", "oak", "cherry", "black paint", "marble")
    with b.solid("clock"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.018), wood, bevel=0.004)
        k = w / 2 - 0.012
        if b.chance("arch", 0.6):
            a = np.linspace(0, np.pi, 17)
            top = max(h - k, 0.03)
            ring = np.concatenate([[(-k, 0.018), (k, 0.018)], np.c_[k * np.cos(a), top + (h - top) * np.sin(a)]])
        else:
            ring = np.array([(-k, 0.018), (k, 0.018), (k, h), (-k, h)])
        vertices, faces = shapes.extrusion(ring, (-d / 2 + 0.008, d / 2 - 0.012))
        b.add((vertices[:, [2, 0, 1]], faces), wood)
        r = min(k, (h - 0.018) / 2) * 0.8
        with b.frame(d / 2 - 0.012, 0.0, 0.018 + (h - 0.018) * 0.5, pitch=math.pi / 2):
            b.frustum(r + 0.006, r + 0.006, (-0.004, 0.004), "brass", 32)
        face = Box.around((d / 2 - 0.0065, 0.0, 0.018 + (h - 0.018) * 0.5), 0.019, 2 * r, 2 * r)
        clock_face(b, face, "cream paint", "black steel")


@draws("alarm_clock")
def alarm_clock(b: Builder) -> None:
    """A round clock with two bells and a hammer on two skids."""
    d, w, h = b.size
    look = b.material("case", "red paint", "black steel", "brass", "teal paint", "white steel", "copper")
    r = min(w / 2, h * 0.4)
    z = 0.008 + r
    with b.solid("clock"):
        for s in (-1, 1):
            b.bar((0, s * r * 0.45, z - r * 0.7), (0, s * r * 0.72, 0.005), 0.005, look, 8)
            # Skids as deep as the case: on two points it would tip.
            y = s * r * 0.72
            b.box((-0.42 * d, 0.42 * d), (y - 0.006, y + 0.006), (0.0, 0.007), look, bevel=0.002)
            with b.frame(0, s * r * 0.52, z + r * 0.84, roll=-s * 0.5):
                b.lathe([(r * 0.4, 0.0), (r * 0.36, r * 0.16), (r * 0.16, r * 0.28), (0.0, r * 0.3)], "chrome", 18)
                b.bar((0, 0, -r * 0.2), (0, 0, 0.002), 0.003, "chrome", 6)
        b.bar((0, 0, z + r * 0.9), (0, 0, h - 0.006), 0.0025, "chrome", 6)
        b.ball((0.006, 0.009, 0.006), (0, 0, h - 0.006), "chrome", 8)
        with b.frame(-d / 2, 0, z, pitch=math.pi / 2):
            b.lathe([(r * 0.8, 0.0), (r, 0.01), (r, d - 0.006)], look, 32)
        face = Box.around((d / 4, 0, z), d / 2, 1.8 * r, 1.8 * r)
        clock_face(b, face, "cream paint", "black steel")
        b.bar((0, -w / 2, z), (0, w / 2, z), 0.004, "chrome", 8)


@draws("trophy")
def trophy(b: Builder) -> None:
    """A cup with two handles on a block with a plate."""
    d, w, h = b.size
    metal = b.material("cup", "brass", "chrome", "copper")
    base = b.material("base", "black paint", "marble", "mahogany", "walnut")
    k = d / 2
    f = h * 0.2
    with b.solid("trophy"):
        b.box((-k * 0.8, k * 0.8), (-k * 0.8, k * 0.8), (0.0, f), base, bevel=0.005)
        b.box((k * 0.8 - 0.001, k * 0.8 + 0.001), (-k * 0.5, k * 0.5), (f * 0.25, f * 0.75), metal, bevel=0.0)
        top = [
            (0.6, 0.0),
            (0.56, 0.04),
            (0.16, 0.1),
            (0.12, 0.2),
            (0.22, 0.26),
            (0.14, 0.32),
            (0.5, 0.42),
            (0.84, 0.6),
            (0.94, 0.85),
            (1.0, 1.0),
        ]
        profile = [(k * u, f + (h - f) * v) for u, v in top]
        b.lathe(
            [*profile, (k * 0.93, h), (k * 0.86, f + (h - f) * 0.85), (k * 0.4, f + (h - f) * 0.6)],
            metal,
            28,
            hollow=True,
        )
        z0 = f + (h - f) * 0.5
        z1 = f + (h - f) * 0.9
        for s in (-1, 1):
            out = w / 2 - 0.004
            b.tube(
                [
                    (0, s * k * 0.6, z0),
                    (0, s * (k * 0.6 + out) / 2, z0 + 0.06 * h),
                    (0, s * out, (z0 + z1) / 2 + 0.03 * h),
                    (0, s * out * 0.96, z1),
                    (0, s * k * 0.9, z1 - 0.02 * h),
                ],
                0.004,
                metal,
                8,
            )


@draws("snow_globe")
def snow_globe(b: Builder) -> None:
    """A ball of glass with snow, a fir and a small house, on a wooden foot."""
    r, h = across(b) / 2, b.size.height
    wood = b.material("foot", "walnut", "red paint", "black paint", "brass", "mahogany")
    f = h * 0.26
    z, k = h - r, r
    with b.solid("globe"):
        b.lathe([(r * 0.9, 0.0), (r * 0.92, f * 0.3), (r * 0.74, f * 0.5), (r * 0.7, f), (r * 0.6, f + 0.01)], wood, 28)
        b.ball((k, k, k), (0, 0, z), "glass", 24)
        low = z - k * 0.55
        b.lathe([(k * 0.5, low - k * 0.2), (k * 0.78, low), (k * 0.3, low + k * 0.14)], "white paint", 20)
        with b.frame(-0.2 * k, 0.25 * k):
            for n, (u, v) in enumerate(((0.3, 0.1), (0.24, 0.4), (0.16, 0.68))):
                b.frustum(k * u, 0.002, (low + k * v, low + k * (v + 0.42)), "dark leaf" if n else "leaf", 12)
        with b.frame(0.15 * k, -0.28 * k):
            s = k * 0.2
            b.box((-s, s), (-s, s), (low, low + s * 1.7), "red paint", bevel=0.0)
            b.hull(
                [(x, y, low + s * 1.7) for x in (-s * 1.2, s * 1.2) for y in (-s * 1.2, s * 1.2)]
                + [(x, 0, low + s * 2.8) for x in (-s * 1.2, s * 1.2)],
                "white paint",
            )


@draws("music_box", "jewelry_box")
def lidded_box(b: Builder) -> None:
    """A small box with a lid that opens, inlaid, with a clasp; a music box has a crank."""
    d, w, h = b.size
    wood = b.material("box", "walnut", "mahogany", "cherry", "white paint", "rose fabric", "navy paint", "tan leather")
    metal = b.material("clasp", "brass", "copper", "chrome")
    music = b.category.name == "music_box"
    y = (-w / 2, w / 2 - (0.03 if music else 0.0))
    foot = 0.008
    lid = h * 0.7
    x = (-d / 2, d / 2 - 0.006)
    middle = (y[0] + y[1]) / 2
    with b.solid("box"):
        for px in (x[0] + 0.01, x[1] - 0.01):
            for py in (y[0] + 0.01, y[1] - 0.01):
                with b.frame(px, py):
                    b.frustum(0.006, 0.008, (0.0, foot), metal, 10)
        b.box(x, y, (foot, lid), wood, bevel=0.003)
        b.box((x[1], x[1] + 0.002), (y[0] + 0.02, y[1] - 0.02), (foot + 0.1 * h, foot + 0.13 * h), metal, bevel=0.0)
        if music:
            z = h * 0.4
            b.bar((0, y[1] - 0.005, z), (0, y[1] + 0.018, z), 0.003, metal, 8)
            b.bar((0, y[1] + 0.018, z), (0.02, y[1] + 0.018, z + 0.012), 0.003, metal, 8)
            b.bar((0.02, y[1] + 0.016, z + 0.012), (0.02, y[1] + 0.03, z + 0.012), 0.005, wood, 10)
        with b.hinge("lid", (x[0], middle, lid), axis=(0.0, -1.0, 0.0), limits=(0.0, 1.7)):
            b.hull(
                [
                    (px, py, z)
                    for z, m in ((lid + 0.001, 0.0), (lid + 0.6 * (h - lid), 0.0), (h - 0.002, 0.012))
                    for px in (x[0] + m, x[1] - m)
                    for py in (y[0] + m, y[1] - m)
                ],
                wood,
            )
            b.box((x[0] + 0.03, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (h - 0.006, h), metal, bevel=0.0)
            b.box((x[1] - 0.004, d / 2), (middle - 0.01, middle + 0.01), (lid + 0.004, lid + 0.018), metal, bevel=0.002)
