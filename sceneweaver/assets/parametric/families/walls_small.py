"""Shelves, hooks, planters and small devices on walls and ceilings; blinds."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...textures import kind_of
from ..builder import Builder
from ..registry import draws
from .plants_parts import OVAL, Clumps, leaves, randoms, sectors
from .walls_art import art, panel


@draws("wall_shelf")
def wall_shelf(b: Builder) -> None:
    """A board on the wall: floating, or on brackets of metal or wood."""
    d, w, h = b.size
    wood = b.material("board", "oak", "walnut", "white paint", "pine", "black paint", "light oak")
    metal = b.material("brackets", "black steel", "brass", "white steel")
    thick = 0.025
    kind = b.pick("brackets", ["corbel", "angle", "rail"])
    with b.solid("shelf"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - thick, h), wood)
        low, z1 = 0.0, h - thick
        for sy in (-1, 1):
            y = sy * (w / 2 - min(0.12, 0.18 * w))
            if kind == "corbel":
                b.hull(
                    [
                        (x, y + v, z)
                        for v in (-0.011, 0.011)
                        for x, z in ((-d / 2, low), (-d / 2 + 0.02, low), (d / 2 - 0.02, z1), (-d / 2, z1))
                    ],
                    wood,
                )
            else:
                b.box((-d / 2, -d / 2 + 0.005), (y - 0.015, y + 0.015), (low, z1), metal, bevel=0.001)
                b.box((-d / 2, d / 2 - 0.01), (y - 0.015, y + 0.015), (z1 - 0.005, z1), metal, bevel=0.001)
                if kind == "rail":
                    b.bar((-d / 2 + 0.006, y, low + 0.01), (d / 2 - 0.03, y, z1 - 0.004), 0.004, metal, 6)
    b.surface("top", (-d / 2 + 0.003, d / 2 - 0.003), (-w / 2 + 0.003, w / 2 - 0.003), h)


@draws("coat_hooks")
def coat_hooks(b: Builder) -> None:
    """A board with four to seven double hooks or pegs."""
    d, w, h = b.size
    wood = b.material("board", "oak", "white paint", "walnut", "pine", "black paint")
    metal = b.material("hooks", "black steel", "brass", "chrome", "iron")
    count = max(4, min(7, round(w / 0.14)))
    pegs = b.chance("pegs", 0.35)
    with b.solid("hooks"):
        b.box((-d / 2, -d / 2 + 0.018), (-w / 2, w / 2), (h * 0.25, h), wood, bevel=0.004)
        for k in range(count):
            y = (k + 0.5) * w / count - w / 2
            x = -d / 2 + 0.018
            if pegs:
                b.bar((x - 0.004, y, h * 0.5), (d / 2 - 0.012, y, h * 0.62), 0.009, wood, 10)
                b.ball((0.012, 0.012, 0.012), (d / 2 - 0.012, y, h * 0.62), wood, 10)
                b.box((x - 0.002, x + 0.004), (y - 0.012, y + 0.012), (0.0, h * 0.5), metal)
            else:
                b.box((x, x + 0.005), (y - 0.01, y + 0.01), (h * 0.3, h * 0.9), metal)
                out = d / 2 - 0.009
                b.tube([(x, y, h * 0.66), (out - 0.02, y, h * 0.7), (out, y, h * 0.9)], 0.005, metal, 8)
                b.ball((0.009, 0.009, 0.009), (out, y, h * 0.9), metal, 8)
                b.tube(
                    [
                        (x, y, h * 0.4),
                        (x + 0.015, y, h * 0.08 + 0.006),
                        (x + 0.035, y, h * 0.08),
                        (x + 0.042, y, h * 0.25),
                    ],
                    0.005,
                    metal,
                    8,
                )
        b.box((-d / 2, -d / 2 + 0.004), (-0.01, 0.01), (0.0, h * 0.3), wood, bevel=0.0)


@draws("key_holder")
def key_holder(b: Builder) -> None:
    """A small board with a tray on top, hooks and keys."""
    d, w, h = b.size
    wood = b.material("board", "walnut", "oak", "white paint", "black steel")
    metal = b.material("hooks", "brass", "black steel", "chrome")
    count = max(3, round(w / 0.06))
    with b.solid("holder"):
        b.box((-d / 2, -d / 2 + 0.014), (-w / 2, w / 2), (h * 0.35, h), wood)
        b.box((-d / 2 + 0.014, d / 2), (-w / 2, w / 2), (h * 0.6, h * 0.6 + 0.01), wood)
        b.box((d / 2 - 0.008, d / 2), (-w / 2, w / 2), (h * 0.6 + 0.01, h * 0.78), wood)
        for k in range(count):
            y = (k + 0.5) * w / count - w / 2
            x = -d / 2 + 0.014
            b.tube([(x, y, h * 0.48), (x + 0.016, y, h * 0.44), (x + 0.02, y, h * 0.52)], 0.0025, metal, 6)
            if k % 2 == 0:
                with b.frame(x + 0.012, y, h * 0.36, pitch=math.pi / 2):
                    b.frustum(0.012, 0.012, (-0.0015, 0.0015), "brass", 14)
                b.box((x + 0.0105, x + 0.0135), (y - 0.003, y + 0.003), (0.0, h * 0.33), "brass", bevel=0.0)


@draws("tapestry")
def tapestry(b: Builder) -> None:
    """A woven hanging on a rod, with a pattern and fringes."""
    d, w, h = b.size
    wood = b.material("rod", "light oak", "walnut", "brass", "bark")
    cloth = b.material("cloth", "beige fabric", "white fabric", "rust fabric", "navy fabric", "green fabric")
    rng = np.random.default_rng(b.whole("art", 0, 2**31 - 1))
    r = d / 2
    fringe = h * 0.14
    y = (-w / 2 + 0.03, w / 2 - 0.03)
    with b.solid("tapestry"):
        b.bar((0.0, -w / 2, h - r), (0.0, w / 2, h - r), r * 0.98, wood, 12)
        b.add(shapes.box((-r, -r + 0.006), y, (fringe, h - r)), cloth, [shapes.box((-r, -r + 0.01), y, (0.0, h - r))])
        art(
            b,
            (y[0] + 0.03, y[1] - 0.03),
            (fringe + 0.04, h - 2 * r - 0.05),
            -r + 0.0065,
            rng,
            b.pick("art", ["arches", "waves", "hills", "blocks"]),
        )
        count = int((y[1] - y[0]) / 0.014)
        for k in range(count):
            c = y[0] + (k + 0.5) * (y[1] - y[0]) / count
            low = fringe * 0.9 * abs(2 * (k + 0.5) / count - 1)
            panel(
                b,
                [(c - 0.004, low), (c + 0.004, low), (c + 0.004, fringe + 0.002), (c - 0.004, fringe + 0.002)],
                (-r, -r + 0.005),
                cloth,
            )


@draws("wall_planter")
def wall_planter(b: Builder) -> None:
    """A half-round pot on a plate, with leaves that hang over its lip."""
    d, w, h = b.size
    look = b.material("pot", "terracotta", "white ceramic", "black steel", "copper", "grey ceramic")
    rng = randoms(b)
    z0, z1 = h * 0.25, h * 0.66
    r = w * 0.32
    a = np.linspace(-np.pi / 2, np.pi / 2, 13)
    deep = min(d * 0.8, r)
    with b.solid("pot"):
        low = [(-d / 2 + 0.6 * deep * math.cos(t), 0.6 * r * math.sin(t), z0) for t in a]
        high = [(-d / 2 + deep * math.cos(t), r * math.sin(t), z1) for t in a]
        b.hull(low + high, look)
        b.box((-d / 2, -d / 2 + 0.008), (-r, r), (z0, z1 + 0.04), look)
        ring = np.array([(-d / 2 + 0.93 * deep * math.cos(t), 0.93 * r * math.sin(t)) for t in a])
        b.extrude(ring, (z1 - 0.01, z1 + 0.002), "soil")
    count = 34
    yaw = rng.uniform(-1.5, 1.5, count)
    out = rng.uniform(0.2, 0.8, count)
    base = np.c_[-d / 2 + 0.012 + 0.6 * deep * out * np.cos(yaw), 0.8 * r * out * np.sin(yaw), np.full(count, z1)]
    k = Clumps()
    green = b.material("leaves", "leaf", "pale leaf", "dark leaf")
    k.add(
        leaves(base, yaw, rng.uniform(0.5, 1.4, count), rng.uniform(1.0, 2.2, count), h * 0.36, 0.045, OVAL),
        green,
        sectors(yaw + 1.6, 6),
    )
    with b.solid("crown"):
        k.draw(b, (-d / 2 + 0.004, d / 2), (-w / 2, w / 2), (min(0.1 * h, z0), h))
        b.box((-d / 2, -d / 2 + 0.006), (-0.01, 0.01), (0.0, z0 + 0.02), look)


@draws("air_conditioner")
def air_conditioner(b: Builder) -> None:
    """A split unit: a rounded body with a louvre, a grille on top and a small display."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "white paint", "light grey paint")
    with b.solid("unit"):
        profile = [
            (-d / 2, 0.0),
            (d * 0.22, 0.0),
            (d / 2 - 0.02, h * 0.3),
            (d / 2, h * 0.5),
            (d / 2 - 0.004, h * 0.9),
            (d / 2 - 0.03, h),
            (-d / 2, h),
        ]
        b.hull([(x, y, z) for x, z in profile for y in (-w / 2, w / 2)], body)
        slope = math.atan2(h * 0.3, d * 0.28 - 0.02)
        with b.frame((d * 0.22 + d / 2 - 0.02) / 2, 0.0, h * 0.15, pitch=-slope):
            long = 0.4 * math.hypot(h * 0.3, d * 0.28 - 0.02)
            b.add(shapes.box((-long, long), (-w * 0.45, w * 0.45), (-0.0002, 0.004)), "black plastic", hulls=[])
            b.add(shapes.box((-long, long), (-w * 0.45, w * 0.45), (0.002, 0.003)), body, hulls=[])
            for k in range(3):
                x = (k - 1) * long * 0.62
                b.add(shapes.box((x - 0.006, x + 0.006), (-w * 0.45, w * 0.45), (-0.0003, 0.003)), body, hulls=[])
        b.box(
            (d / 2 - 0.02, d / 2 + 0.0004),
            (-w / 2 + 0.005, w / 2 - 0.005),
            (h * 0.34, h * 0.345),
            "grey plastic",
            bevel=0.0,
        )
        b.box((d / 2 - 0.01, d / 2 + 0.0006), (w * 0.34, w * 0.42), (h * 0.52, h * 0.6), "screen", bevel=0.0)
        for k in range(6):
            x = -d * 0.35 + k * d * 0.1
            b.box((x, x + 0.008), (-w * 0.45, w * 0.45), (h - 0.004, h + 0.0004), "grey plastic", bevel=0.0)


def _upside(b: Builder, h: float, profile: list[tuple[float, float]], look, segments: int = 32) -> None:
    """A lathed body that hangs from the ceiling: heights run down from it."""
    b.lathe([(r, h - z) for r, z in reversed(profile)], look, segments)


@draws("smoke_detector")
def smoke_detector(b: Builder) -> None:
    """A white disc with slots and a small lamp."""
    r, h = b.size.width / 2, b.size.height
    with b.solid("body"):
        body = b.material("body", "white plastic")
        profile = [(r * 0.6, 0.0), (r * 0.8, h * 0.1), (r * 0.92, h * 0.45), (r, h * 0.6), (r, h)]
        b.add(shapes.lathe(profile, 32), body, [shapes.frustum(r, r, (0.0, h), 32)])
        for k in range(18):
            with b.frame(yaw=k * math.pi / 9):
                b.add(
                    shapes.box((r * 0.84, r * 0.895), (-0.004, 0.004), (h * 0.18, h * 0.4)), "black plastic", hulls=[]
                )
        with b.frame(r * 0.4):
            b.add(shapes.frustum(0.004, 0.004, (0.0, 0.004), 10), "red plastic", hulls=[])


@draws("ceiling_speaker")
def ceiling_speaker(b: Builder) -> None:
    """A round flat grille in a ring."""
    r, h = b.size.width / 2, b.size.height
    with b.solid("body"):
        body = b.material("ring", "white plastic", "black plastic", "white steel")
        _upside(b, h, [(r, 0.0), (r, h * 0.6), (r * 0.94, h)], body, 36)
        b.add(shapes.frustum(r * 0.86, r * 0.86, (0.0, h * 0.5), 36), "grey plastic", hulls=[])
        for k in range(1, 6):
            ring = np.arange(30) * (2 * np.pi / 30)
            u = r * 0.14 * k
            path = np.c_[u * np.cos(ring), u * np.sin(ring), np.full(30, 0.0012)]
            b.add(shapes.sweep(path, 0.001, 4, True), body, hulls=[])


@draws("thermostat")
def thermostat(b: Builder) -> None:
    """A round dial, or a square plate, with a dark display."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "brushed steel", "black plastic", "brass")
    with b.solid("body"):
        if b.chance("round", 0.5):
            r = w / 2
            with b.frame(-d / 2, 0.0, r, pitch=math.pi / 2):
                b.frustum(r, r * 0.94, (0.0, d - 0.001), body, 32, bevel=0.003)
                b.frustum(r * 0.78, r * 0.78, (d * 0.5, d), "black glass", 32)
                b.add(shapes.box((-0.006, 0.006), (-0.014, 0.014), (d - 0.002, d + 0.0004)), "lamp glow", hulls=[])
        else:
            b.box((-d / 2, d / 2 - 0.001), (-w / 2, w / 2), (0.0, h), body, bevel=0.004)
            b.box((0.0, d / 2), (-w * 0.36, w * 0.36), (h * 0.42, h * 0.86), "screen", bevel=0.0)
            for k in (-1, 0, 1):
                b.box((0.0, d / 2), (k * w * 0.24 - 0.006, k * w * 0.24 + 0.006), (h * 0.16, h * 0.28), "grey plastic")


@draws("light_switch")
def light_switch(b: Builder) -> None:
    """A plate with one, two or three rockers."""
    d, w, h = b.size
    plate = b.material("plate", "white plastic", "brushed steel", "black plastic", "brass")
    count = b.pick("rockers", [1, 1, 2])
    with b.solid("switch"):
        b.box((-d / 2, -d / 2 + d * 0.55), (-w / 2, w / 2), (0.0, h), plate, bevel=0.002)
        span = w * 0.68
        for k in range(count):
            y0 = -span / 2 + k * span / count + 0.001
            y1 = y0 + span / count - 0.002
            b.hull(
                [
                    (x, y, z)
                    for y in (y0, y1)
                    for x, z in ((-d / 2, h * 0.16), (-d / 2, h * 0.84), (d / 2, h * 0.82), (d / 2 - d * 0.3, h * 0.18))
                ],
                "white plastic",
            )


@draws("window_blind")
def window_blind(b: Builder) -> None:
    """Slats on cords under a head rail, or a roller blind half let down."""
    d, w, h = b.size
    look = b.material(
        "blind", "white paint", "beige fabric", "oak", "grey fabric", "light grey paint", "walnut", "sage paint"
    )
    with b.solid("blind"):
        if kind_of(look.texture) == "fabric":
            r = d / 2 - 0.003
            b.bar((0, -w / 2 + 0.012, h - d / 2), (0, w / 2 - 0.012, h - d / 2), r, look, 16)
            for sy in (-1, 1):
                y = sy * (w / 2 - 0.006)
                b.box((-d / 2, d / 2), (y - 0.006, y + 0.006), (h - d, h), "white steel")
            b.box((r - 0.003, r), (-w / 2 + 0.014, w / 2 - 0.014), (0.02, h - d / 2), look, bevel=0.0)
            b.box((r - 0.008, r + 0.003), (-w / 2 + 0.012, w / 2 - 0.012), (0.0, 0.025), "white steel", bevel=0.002)
            return
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.045, h), look)
        b.box((-d * 0.35, d * 0.35), (-w / 2 + 0.01, w / 2 - 0.01), (0.0, 0.018), look)
        count = int((h - 0.08) / 0.045)
        whole = shapes.box((-d / 2 + 0.001, d / 2 - 0.001), (-w / 2 + 0.01, w / 2 - 0.01), (0.018, h - 0.045))
        for k in range(count):
            z = 0.045 + k * (h - 0.1) / max(1, count - 1)
            with b.frame(0.0, 0.0, z, pitch=0.6):
                b.add(
                    shapes.box((-d * 0.44, d * 0.44), (-w / 2 + 0.01, w / 2 - 0.01), (-0.0014, 0.0014)), look, hulls=[]
                )
        for n, y in enumerate((-w * 0.36, 0.0, w * 0.36)):
            cord = shapes.box((-0.0015, 0.0015), (y - 0.0015, y + 0.0015), (0.018, h - 0.045))
            b.add(cord, "white fabric", [whole] if n == 0 else [])
