"""Racks, benches and weights."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder, span
from .gym_cardio import dumbbell_at, plate
from .gym_kit import Look, disc, gear, inlay, post, ring, side

_FRAMES = ("black steel", "white steel", "red paint", "grey paint", "yellow paint")


@gear("weight_bench")
def weight_bench(b: Builder) -> None:
    """A padded bench, its back rest raised at the rear, on a steel frame."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    pad = b.material("pad", "black leather", "brown leather", "white leather")
    x0, x1 = -d / 2, d / 2
    for x, wide in ((x0 + 0.12, w / 2), (x1 - 0.06, w * 0.4)):
        post(b, (x, -wide, 0.03), (x, wide, 0.03), frame, 0.06)
        for s in (-1, 1):
            b.box((x - 0.035, x + 0.035), span(s * wide, s * (wide - 0.05)), (0, 0.065), "rubber", 0.004)
    post(b, (x0 + 0.12, 0, 0.05), (x1 - 0.06, 0, 0.05), frame, 0.06)
    post(b, (x1 - 0.06, 0, 0.03), (x1 - 0.2, 0, 0.4), frame, 0.06)
    sx = x1 - d * 0.3
    b.cushion((sx, x1), (-w * 0.32, w * 0.32), (0.4, 0.47), pad, 0.025)
    hinge = (sx - 0.02, 0.42)
    long, rise = sx - 0.02 - x0, h - 0.45
    angle = math.asin(min(0.98, rise / (long + 0.05))) if rise > 0.03 else 0.0
    length = long / max(0.35, math.cos(angle))
    with b.frame(hinge[0], 0, hinge[1], pitch=angle):
        b.cushion((-length, -0.01), (-w * 0.3, w * 0.3), (-0.02, 0.05), pad, 0.025)
        b.box((-length * 0.8, 0), (-0.03, 0.03), (-0.06, -0.01), frame, 0.004)
    mid = (hinge[0] - length * 0.5 * math.cos(angle), hinge[1] - 0.04 + length * 0.5 * math.sin(angle))
    post(b, (x0 + 0.25, 0, 0.05), (mid[0], 0, mid[1]), "steel", 0.045)
    post(b, (sx - 0.15, 0, 0.05), (sx + 0.02, 0, 0.4), frame, 0.06)


def _upright_pair(b: Builder, x: float, w: float, h: float, frame: Look) -> None:
    for s in (-1, 1):
        b.box((x - 0.035, x + 0.035), (s * (w / 2 - 0.035) - 0.035, s * (w / 2 - 0.035) + 0.035), (0, h), frame, 0.004)
        for k in range(12):
            z = 0.25 + k * (h - 0.5) / 11
            for e in (-1, 1):
                inlay(
                    b,
                    (x + e * 0.0345 - 0.0008, x + e * 0.0345 + 0.0008),
                    (s * (w / 2 - 0.035) - 0.009, s * (w / 2 - 0.035) + 0.009),
                    (z - 0.009, z + 0.009),
                    "black plastic",
                )


def _barbell(b: Builder, x: float, z: float, length: float, looks: list[Look], r: float = 0.2) -> None:
    b.bar((x, -length / 2, z), (x, length / 2, z), 0.014, "steel", 10)
    for s in (-1, 1):
        inner = length * 0.33
        b.bar((x, s * inner, z), (x, s * length / 2, z), 0.024, "chrome", 12)
        y = inner + 0.03
        for k, look in enumerate(looks):
            t = 0.04
            plate(b, (x, s * (y + t / 2), z), r * (1 - 0.17 * k), t, look)
            y += t + 0.004


def _bumper(b: Builder, count: int) -> list[Look]:
    kind = b.pick(
        "plates",
        [
            ("black plastic",) * 4,
            ("red plastic", "blue plastic", "yellow plastic", "green plastic"),
            ("rubber", "rubber", "grey plastic", "grey plastic"),
        ],
    )
    return list(kind[:count])


@gear("squat_rack")
def squat_rack(b: Builder) -> None:
    """A power cage of four uprights with cross beams, hooks and a loaded barbell."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    x0, x1 = -d / 2 + 0.04, d / 2 - 0.3
    cage = min(1.24, w * 0.6)
    for x in (x0, x1):
        with b.solid(f"uprights {x > 0}"):
            _upright_pair(b, x, cage, h, frame)
            b.box((x - 0.03, x + 0.03), (-cage / 2, cage / 2), (h - 0.08, h - 0.02), frame, 0.004)
    with b.solid("back"):
        b.box((x0 - 0.03, x0 + 0.03), (-cage / 2, cage / 2), (0.25, 0.31), frame, 0.004)
    for s in (-1, 1):
        with b.solid(f"foot {s}"):
            y = s * (cage / 2 - 0.035)
            b.box((-d / 2, d / 2), (y - 0.035, y + 0.035), (0, 0.07), frame, 0.004)
            b.box((x0, x1), (y - 0.02, y + 0.02), (0.48, 0.54), "yellow plastic", 0.006)
    with b.solid("top"):
        for s in (-1, 1):
            y = s * (cage / 2 - 0.035)
            b.box((x0, x1), (y - 0.03, y + 0.03), (h - 0.08, h - 0.02), frame, 0.004)
        b.bar((x1 - 0.1, -cage / 2 + 0.03, h - 0.05), (x1 - 0.1, cage / 2 - 0.03, h - 0.05), 0.016, "chrome", 10)
    z = b.uniform("bar height", 1.25, 1.45)
    with b.solid("barbell"):
        for s in (-1, 1):
            y = s * (cage / 2 - 0.035)
            side(
                b,
                [
                    (x1, z - 0.12),
                    (x1 + 0.11, z - 0.04),
                    (x1 + 0.11, z + 0.03),
                    (x1 + 0.09, z + 0.03),
                    (x1 + 0.09, z - 0.015),
                    (x1, z - 0.015),
                ],
                (y - 0.03, y + 0.03),
                "black plastic",
            )
        _barbell(b, x1 + 0.06, z, w, _bumper(b, b.whole("plates each side", 1, 3)), 0.225)
    b.zone("inside", (x0, d / 2), (-cage / 2, cage / 2))


@gear("smith_machine")
def smith_machine(b: Builder) -> None:
    """A frame with two guide rods on which a barbell runs up and down."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    x = -d / 2 + 0.3
    gauge = w * 0.56
    with b.solid("frame"):
        _upright_pair(b, x, gauge, h, frame)
        b.box((x - 0.035, x + 0.035), (-gauge / 2, gauge / 2), (h - 0.09, h - 0.01), frame, 0.004)
        b.box((x - 0.035, x + 0.035), (-gauge / 2, gauge / 2), (0, 0.07), frame, 0.004)
    for s in (-1, 1):
        y = s * (gauge / 2 - 0.04)
        with b.solid(f"foot {s}"):
            b.box((-d / 2, d / 2), (y - 0.04, y + 0.04), (0, 0.07), frame, 0.004)
            post(b, (x, y, 0.7), (-d / 2 + 0.05, y, 0.05), frame, 0.05)
        with b.solid("frame"):
            b.bar((x + 0.1, y, 0.06), (x + 0.1, y, h - 0.04), 0.014, "chrome", 10)
            for z in (0.12, h - 0.1):
                b.box((x, x + 0.12), (y - 0.03, y + 0.03), (z - 0.03, z + 0.03), frame, 0.004)
    with b.solid("bar"):
        z = b.uniform("bar height", 1.0, 1.4)
        for s in (-1, 1):
            y = s * (gauge / 2 - 0.04)
            b.box((x + 0.07, x + 0.19), (y - 0.03, y + 0.03), (z - 0.06, z + 0.06), "black plastic", 0.006)
        _barbell(b, x + 0.16, z, w, _bumper(b, 2), 0.225)


@gear("dumbbell_rack")
def dumbbell_rack(b: Builder) -> None:
    """Two or three sloping tiers full of dumbbells, larger ones below."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    head = b.material("heads", "rubber", "black plastic", "iron", "grey plastic")
    tiers = 2 if h < 0.9 else 3
    for s in (-1, 1):
        y = s * (w / 2 - 0.03)
        b.box((-d / 2, d / 2), (y - 0.03, y + 0.03), (0, 0.06), frame, 0.004)
        post(b, (d / 2 - 0.16, y, 0.04), (-d / 2 + 0.06, y, h - 0.04), frame, 0.06)
    for k in range(tiers):
        share = k / max(1, tiers - 1)
        z = 0.24 + share * (h - 0.42)
        x = d / 2 - 0.2 + (z - 0.04) / (h - 0.08) * (-d + 0.22) + 0.13
        size = 0.31 - 0.07 * share
        with b.frame(x, 0, z, pitch=0.35):
            for e in (-0.09, 0.09):
                b.box((e - 0.03, e + 0.03), (-w / 2 + 0.03, w / 2 - 0.03), (-0.012, 0.012), frame, 0.003)
            b.box((-0.14, -0.1), (-w / 2 + 0.03, w / 2 - 0.03), (-0.05, 0.012), frame, 0.003)
            count = min(10, int((w - 0.14) / (size * 0.55)))
            for i in range(count):
                y = (i - (count - 1) / 2) * (w - 0.2) / max(1, count)
                with b.frame(0, y, 0.012 + size * 0.2, yaw=math.pi / 2):
                    dumbbell_at(b, np.zeros(3), size, head)


@gear("weight_plate_rack")
def weight_plate_rack(b: Builder) -> None:
    """A tree with pegs on both sides, weight plates on them."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    for x in (-d / 2 + 0.035, d / 2 - 0.035):
        post(b, (x, -w * 0.4, 0.035), (x, w * 0.4, 0.035), frame, 0.07)
    post(b, (-d / 2 + 0.035, 0, 0.05), (d / 2 - 0.035, 0, 0.05), frame, 0.07)
    for x in (-0.09, 0.09):
        post(b, (x, 0, 0.05), (x * 0.5, 0, h), frame, 0.06)
    looks = _bumper(b, 4)
    rows = 3
    for k in range(rows):
        z = 0.3 + k * (h - 0.42) / (rows - 1) if h > 0.8 else 0.25 + k * (h - 0.37) / (rows - 1)
        r = min(0.22 - 0.035 * k, (h - 0.42) / (rows - 1) * 0.49)
        for s in (-1, 1):
            b.bar((0, 0, z), (0, s * w / 2, z), 0.022, "chrome", 12)
            for i in range(b.whole(f"plates {k} {s}", 2, 3)):
                plate(b, (0, s * (0.09 + 0.047 * i), z), r, 0.04, looks[k])


@gear("kettlebell_rack")
def kettlebell_rack(b: Builder) -> None:
    """Two or three shelves with kettlebells."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    tiers = 2
    for s in (-1, 1):
        y = s * (w / 2 - 0.025)
        side(b, [(-d / 2, 0), (d / 2, 0), (d / 2, 0.06), (-d / 2 + 0.16, h), (-d / 2, h)], (y - 0.02, y + 0.02), frame)
    for k in range(tiers):
        z = 0.14 + k * (h - 0.46)
        deep = d - 0.1 - k * (d * 0.3)
        x0, x1 = -d / 2 + 0.01, -d / 2 + deep
        b.box((x0, x1), (-w / 2 + 0.04, w / 2 - 0.04), (z - 0.03, z), frame, 0.004)
        b.box((x1 - 0.015, x1), (-w / 2 + 0.04, w / 2 - 0.04), (z - 0.03, z + 0.025), frame, 0.003)
        r = (0.1, 0.075)[k]
        count = int((w - 0.1) / (2.3 * r))
        looks = ("rubber", "red plastic", "blue plastic", "yellow plastic", "green plastic", "orange plastic")
        for i in range(count):
            look = looks[i % 6] if b.chance("coloured", 0.4) else "iron"
            _kettlebell(b, (x0 + x1) / 2, (i - (count - 1) / 2) * (w - 0.1) / count, z, r, look)


def _kettlebell(b: Builder, x: float, y: float, z: float, r: float, look: Look) -> None:
    with b.frame(x, y, z):
        b.lathe([(r * 0.6, 0), (r * 0.9, r * 0.35), (r, r * 0.85), (r * 0.85, r * 1.4), (r * 0.45, r * 1.75)], look, 20)
        b.tube(
            [
                (0, -r * 0.5, r * 1.5),
                (0, -r * 0.72, r * 2.1),
                (0, -r * 0.5, r * 2.6),
                (0, r * 0.5, r * 2.6),
                (0, r * 0.72, r * 2.1),
                (0, r * 0.5, r * 1.5),
            ],
            r * 0.17,
            "black steel",
            10,
        )


@gear("kettlebell")
def kettlebell(b: Builder) -> None:
    """One kettlebell."""
    look = b.material("bell", "iron", "black steel", "red plastic", "blue plastic", "green plastic", "rubber")
    _kettlebell(b, 0, 0, 0, 0.1, look)
    b.add(_band(0.1), "yellow plastic", [])


def _band(r: float):
    from ... import shapes

    return shapes.frustum(r * 0.983, r * 0.983, (r * 0.78, r * 0.92), 20)


@gear("dumbbell")
def dumbbell(b: Builder) -> None:
    """One hexagonal or round dumbbell."""
    d, w, h = b.size
    look = b.material("heads", "rubber", "iron", "blue plastic", "grey plastic", "red plastic")
    if b.chance("hexagonal", 0.6):
        with b.frame(0, 0, w * 0.2):
            dumbbell_at(b, np.zeros(3), w, look)
        return
    b.bar((0, -w * 0.25, h / 2), (0, w * 0.25, h / 2), 0.016, "chrome", 12)
    for s in (-1, 1):
        for k in range(3):
            plate(b, (0, s * (w * 0.24 + w * 0.085 * k), h / 2), h / 2 * (1 - 0.12 * k), w * 0.08, look)
        disc(b, (0, s * (w / 2 - 0.005), h / 2), 0.022, 0.01, "chrome", segments=12)


@gear("barbell")
def barbell(b: Builder) -> None:
    """A long bar with bumper plates, on the floor."""
    d, w, h = b.size
    _barbell(b, 0, h / 2, w, _bumper(b, b.whole("plates each side", 1, 3)), h / 2)


@gear("cable_machine")
def cable_machine(b: Builder) -> None:
    """Two towers with weight stacks, a beam with pull-up grips, pulleys and handles."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    for s in (-1, 1):
        y = s * (w / 2 - 0.13)
        with b.solid(f"tower {s}"):
            b.box((-d / 2, d / 2), (y - 0.13, y + 0.13), (0, 0.07), frame, 0.008)
            b.box((-d / 2 + 0.06, -d / 2 + 0.1), (y - 0.13, y + 0.13), (0.07, h - 0.1), "grey plastic", 0.004)
            for e in (-0.1, 0.1):
                b.bar((-0.1, y + e * 0.8, 0.07), (-0.1, y + e * 0.8, h - 0.1), 0.013, "chrome", 8)
            top = 0.12
            for _ in range(12):
                b.box((-0.18, -0.02), (y - 0.11, y + 0.11), (top, top + 0.042), "iron", 0.003)
                top += 0.045
            b.box((-0.025, -0.015), (y - 0.012, y + 0.012), (0.4, 0.42), "yellow plastic", 0.002)
            b.bar((-0.1, y, top), (-0.1, y, h - 0.08), 0.006, "black plastic", 6)
            b.box((0.1, 0.16), (y - 0.03, y + 0.03), (0.07, h - 0.06), frame, 0.004)
            z = b.uniform(f"carriage {s}", 0.5, h - 0.7)
            b.box((0.06, 0.2), (y - 0.05, y + 0.05), (z - 0.09, z + 0.09), "black plastic", 0.008)
            disc(b, (0.2, y, z), 0.055, 0.025, "grey plastic", segments=16)
            b.bar((0.25, y, z - 0.02), (0.26, y, z - 0.2), 0.005, "black plastic", 6)
            b.tube(
                [(0.26, y, z - 0.2), (0.26, y - 0.06, z - 0.3), (0.26, y + 0.06, z - 0.3)],
                0.008,
                "rubber",
                8,
                closed=True,
            )
            b.box((-d / 2 + 0.05, d / 2 - 0.05), (y - 0.12, y + 0.12), (h - 0.12, h), frame, 0.008)
    with b.solid("beam"):
        b.box((0.08, 0.16), (-w / 2 + 0.1, w / 2 - 0.1), (h - 0.09, h - 0.01), frame, 0.004)
        for s in (-1, 1):
            b.tube(
                [(0.12, s * 0.2, h - 0.06), (0.3, s * 0.25, h - 0.06), (0.34, s * 0.5, h - 0.1)], 0.016, "rubber", 10
            )


@gear("leg_press")
def leg_press(b: Builder) -> None:
    """A reclined seat facing a sled on inclined rails, plates on its pegs."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    pad = b.material("pad", "black leather", "brown leather")
    x0, x1 = -d / 2, d / 2
    gauge = w * 0.3
    for s in (-1, 1):
        b.box((x0, x1), (s * gauge - 0.035, s * gauge + 0.035), (0, 0.07), frame, 0.004)
        post(b, (x0 + 0.8, s * gauge, 0.15), (x1 - 0.06, s * gauge, h - 0.12), frame, 0.07)
        post(b, (x1 - 0.06, s * gauge, 0.05), (x1 - 0.06, s * gauge, h - 0.1), frame, 0.07)
        post(b, (x0 + 0.75, s * gauge, 0.05), (x0 + 0.8, s * gauge, 0.2), frame, 0.07)
        b.bar((x0 + 0.78, s * gauge, 0.35), (x0 + 0.62, s * (gauge + 0.05), 0.52), 0.016, "rubber", 8)
    for x in (x0 + 0.035, x1 - 0.06):
        b.box((x - 0.03, x + 0.03), (-gauge, gauge), (0, 0.065), frame, 0.004)
    b.box((x1 - 0.09, x1 - 0.03), (-gauge, gauge), (h - 0.16, h - 0.09), frame, 0.004)
    post(b, (x0 + 0.15, 0, 0.05), (x0 + 0.35, 0, 0.45), frame, 0.07)
    b.box((x0 + 0.12, x0 + 0.8), (-0.04, 0.04), (0.03, 0.1), frame, 0.004)
    with b.frame(x0 + 0.68, 0, 0.2, pitch=0.85):
        b.cushion((-0.85, 0), (-gauge * 0.9, gauge * 0.9), (0.0, 0.09), pad, 0.03)
        b.box((-0.8, -0.05), (-0.15, 0.15), (-0.03, 0.01), frame, 0.004)
    with b.frame(x0 + 0.62, 0, 0.16, pitch=-0.25):
        b.cushion((0, 0.4), (-gauge * 0.85, gauge * 0.85), (0, 0.08), pad, 0.03)
    b.box((x0 + 0.6, x0 + 0.95), (-0.05, 0.05), (0.05, 0.17), frame, 0.004)
    # The sled rides a good half up the rails.
    a, c = np.array([x0 + 0.8, 0.15]), np.array([x1 - 0.06, h - 0.12])
    m = a + 0.62 * (c - a)
    with b.frame(m[0], 0, m[1], pitch=-math.atan2(c[1] - a[1], c[0] - a[0])):
        b.box((-0.1, 0.16), (-gauge - 0.06, gauge + 0.06), (0.02, 0.1), "black steel", 0.006)
        b.box((-0.13, -0.09), (-gauge, gauge), (0.02, 0.5), "black plastic", 0.01)
        for k in range(5):
            inlay(
                b, (-0.1303, -0.12), (-gauge * 0.8, gauge * 0.8), (0.12 + 0.07 * k, 0.13 + 0.07 * k), "yellow plastic"
            )
        looks = _bumper(b, 2)
        for s in (-1, 1):
            b.bar((0.04, s * gauge, 0.1), (0.04, s * w / 2, 0.1), 0.024, "chrome", 10)
            for k in range(2):
                plate(b, (0.04, s * (gauge + 0.1 + 0.05 * k), 0.1), 0.19, 0.042, looks[k])


@gear("pull_up_bar")
def pull_up_bar(b: Builder) -> None:
    """A tower with a pull-up bar, dip handles and a back pad."""
    d, w, h = b.size
    frame = b.material("frame", *_FRAMES)
    x = -d / 2 + 0.25
    half = w * 0.36
    for s in (-1, 1):
        y = s * half
        with b.solid(f"side {s}"):
            b.box((-d / 2, d / 2), (s * (half + 0.06) - 0.03, s * (half + 0.06) + 0.03), (0, 0.06), frame, 0.004)
            post(b, (x, s * (half + 0.06), 0.03), (x, s * half, h * 0.5), frame, 0.06)
            post(b, (x, s * half, h * 0.5), (x, s * half, h - 0.02), frame, 0.055)
        with b.solid("dips"):
            b.box((x, d / 2 - 0.06), (y - 0.025, y + 0.025), (h * 0.5 - 0.03, h * 0.5 + 0.02), frame, 0.004)
            b.cushion(
                (x + 0.03, x + 0.33), (y - 0.06, y + 0.06), (h * 0.5 + 0.015, h * 0.5 + 0.06), "black leather", 0.02
            )
            b.bar((d / 2 - 0.1, y, h * 0.5), (d / 2 - 0.1, y, h * 0.5 + 0.16), 0.017, "rubber", 10)
    with b.solid("dips"):
        b.box((x - 0.03, x + 0.03), (-half, half), (h * 0.5 - 0.03, h * 0.5 + 0.03), frame, 0.004)
        b.box((x - 0.02, x + 0.02), (-0.04, 0.04), (h * 0.5, h * 0.68), frame, 0.004)
        b.cushion((x + 0.02, x + 0.08), (-0.14, 0.14), (h * 0.52, h * 0.68), "black leather", 0.025)
    with b.solid("bar"):
        y = w / 2
        b.tube(
            [
                (x + 0.12, -y, h - 0.13),
                (x + 0.08, -half * 1.05, h - 0.03),
                (x, -half * 0.8, h - 0.02),
                (x, half * 0.8, h - 0.02),
                (x + 0.08, half * 1.05, h - 0.03),
                (x + 0.12, y, h - 0.13),
            ],
            0.017,
            "rubber",
            10,
        )
    with b.solid("brace"):
        b.box((-d / 2, -d / 2 + 0.06), (-half - 0.06, half + 0.06), (0, 0.06), frame, 0.004)


@gear("gym_bench")
def gym_bench(b: Builder) -> None:
    """A locker room bench: slats on steel legs."""
    d, w, h = b.size
    wood = b.material("slats", "beech", "oak", "pine", "white plastic")
    metal = b.material("legs", "steel", "black steel", "white steel", "grey paint")
    count = 3 if d < 0.36 else 4
    step = d / count
    for k in range(count):
        x = -d / 2 + k * step
        b.box((x + 0.001, x + step - 0.001), (-w / 2, w / 2), (h - 0.03, h), wood, 0.001)
    n = 2 if w < 1.5 else 3
    for k in range(n):
        y = -w / 2 + 0.15 + k * (w - 0.3) / (n - 1)
        for x in (-d / 2 + 0.04, d / 2 - 0.04):
            b.box((x - 0.02, x + 0.02), (y - 0.02, y + 0.02), (0, h - 0.03), metal, 0.003)
        b.box((-d / 2 + 0.04, d / 2 - 0.04), (y - 0.02, y + 0.02), (h - 0.07, h - 0.03), metal, 0.003)
    b.box((-0.015, 0.015), (-w / 2 + 0.15, w / 2 - 0.15), (h - 0.065, h - 0.035), metal, 0.003)
    b.surface("top", (-d / 2 + 0.015, d / 2 - 0.015), (-w / 2 + 0.01, w / 2 - 0.01), h)


@gear("punching_bag", square=True)
def punching_bag(b: Builder) -> None:
    """A bag on a weighted foot, or one that hangs from a stand."""
    d, w, h = b.size
    skin = b.material("skin", "red plastic", "black leather", "blue plastic", "brown leather")
    r = min(d, w) / 2
    b.lathe([(r, 0), (r, 0.02), (r * 0.93, 0.2), (r * 0.6, 0.3), (r * 0.3, 0.34)], "black plastic", 28)
    b.frustum(0.05, 0.05, (0.33, 0.52), "steel", 16)
    bag = min(0.19, r * 0.68)
    z = 0.5
    b.lathe([(bag * 0.85, z), (bag, z + 0.03), (bag, h - 0.05), (bag * 0.8, h)], skin, 28)
    for share in (0.12, 0.85):
        m = z + share * (h - z)
        b.frustum(bag + 0.0004, bag + 0.0004, (m, m + 0.05), "white leather", 28)
    _patch = bag * 0.6
    b.frustum(bag * 0.4, bag * 0.4, (h - 0.01, h), "black leather", 16)


@gear("heavy_bag", square=True)
def heavy_bag(b: Builder) -> None:
    """A long leather bag on four chains under the ceiling."""
    d, w, h = b.size
    skin = b.material("skin", "black leather", "brown leather", "red plastic")
    r = min(d, w) / 2
    top = h - 0.4
    with b.solid("bag"):
        b.lathe([(r * 0.9, 0), (r, 0.03), (r, top - 0.03), (r * 0.9, top)], skin, 28)
        for share in (0.15, 0.8):
            b.frustum(r + 0.0004, r + 0.0004, (share * top, share * top + 0.06), "white leather", 28)
    with b.solid("chains"):
        for k in range(4):
            a = math.pi / 4 + k * math.pi / 2
            b.bar((r * 0.85 * math.cos(a), r * 0.85 * math.sin(a), top - 0.01), (0, 0, h - 0.15), 0.006, "steel", 6)
        b.bar((0, 0, h - 0.16), (0, 0, h - 0.02), 0.01, "steel", 8)
        ring(b, (0, 0, h - 0.14), 0.025, 0.007, "steel", n=10, segments=6)
        b.frustum(0.06, 0.06, (h - 0.02, h), "black steel", 20)
