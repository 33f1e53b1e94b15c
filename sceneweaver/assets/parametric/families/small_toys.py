"""Toys."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from .small_kit import Look, decal, ellipse, loft, lofted, orb, rect, slab, small, spot, target

BRIGHT = ("red plastic", "blue plastic", "yellow plastic", "green plastic", "orange plastic")


def wheel(b: Builder, x: float, y: float, r: float, wide: float, tyre: Look, hub: Look) -> None:
    """A wheel that stands on the ground at (x, y), turning about y."""
    with b.frame(x, y, r, roll=np.pi / 2):
        b.frustum(r, r, (-wide / 2, wide / 2), tyre, 18, bevel=0.15 * wide)
        b.add(shapes.frustum(0.55 * r, 0.55 * r, (-wide / 2 - 0.0003, wide / 2 + 0.0003), 14), hub, [])


@small("building_blocks")
def building_blocks(b: Builder) -> None:
    """A tower and some loose wooden blocks: cubes, an arch, a roof, a pillar."""
    d, w, h = b.size
    s = h / 3.0
    c = [
        b.pick(f"c{k}", ["red paint", "blue paint", "yellow paint", "green paint", "beech", "teal paint"])
        for k in range(9)
    ]
    b.material("body", "beech", "pine")
    x, y = -d / 2, -w / 2
    b.box((x, x + s), (y, y + s), (0.0, s), c[0])
    b.box((x, x + s), (y + 1.5 * s, y + 2.5 * s), (0.0, s), c[1])
    b.box((x + 0.05 * s, x + 0.95 * s), (y + 0.2 * s, y + 2.3 * s), (s, 1.5 * s), c[2])
    with b.frame(x + 0.5 * s, y + 1.25 * s, 1.5 * s):
        b.frustum(0.42 * s, 0.42 * s, (0.0, 0.8 * s), c[3], 20, bevel=0.002)
        b.frustum(0.45 * s, 0.03 * s, (0.8 * s, 1.5 * s), c[4], 20)
    with b.frame(d / 2 - 0.6 * s, y + 0.8 * s, 0, yaw=0.5):
        b.box((-0.45 * s, 0.45 * s), (-0.45 * s, 0.45 * s), (0.0, 0.9 * s), c[5])
        decal(b, (-0.1 * s, 0.45 * s + 0.0003), (-0.25 * s, 0.25 * s), (0.2 * s, 0.7 * s), "paper")
    with b.frame(d / 2 - 0.8 * s, y + 2.5 * s, 0, yaw=-0.35):
        b.hull(
            [
                (px, py, z)
                for px in (-0.45 * s, 0.45 * s)
                for py, z in ((-0.7 * s, 0.0), (0.7 * s, 0.0), (0.0, 0.75 * s))
            ],
            c[6],
        )
    with b.frame(x + 0.5 * s, w / 2 - 0.7 * s, 0, yaw=0.2):
        for side in (-1, 1):
            b.box((-0.3 * s, 0.3 * s), (side * 0.5 * s - 0.2 * s, side * 0.5 * s + 0.2 * s), (0.0, 0.5 * s), c[7])
        b.box((-0.3 * s, 0.3 * s), (-0.7 * s, 0.7 * s), (0.5 * s, 0.9 * s), c[7])
    with b.frame(d / 2 - 0.42 * s, w / 2 - 0.5 * s, 0.42 * s, pitch=np.pi / 2, yaw=2.0):
        b.frustum(0.42 * s, 0.42 * s, (-0.5 * s, 0.5 * s), c[8], 20, bevel=0.002)


@small("toy_car")
def toy_car(b: Builder) -> None:
    """A car with a cabin, windows, lamps and fat wheels; some are trucks."""
    d, w, h = b.size
    look = b.material("body", *BRIGHT, "mint plastic")
    r = 0.22 * h if b.chance("flat", 0.4) else 0.26 * h
    z = 0.75 * r
    half = w / 2 - 0.004
    loft(
        b,
        [
            rect((-d / 2 + e, d / 2 - e), (-half + f, half - f), zz, 0.16 * d)
            for e, f, zz in (
                (0.02 * d, 0.02 * w, z),
                (0.0, 0.0, z + 0.08 * h),
                (0.01 * d, 0.01 * w, 0.52 * h),
                (0.05 * d, 0.05 * w, 0.6 * h),
            )
        ],
        look,
        convex=True,
    )
    if b.chance("truck", 0.35):
        b.box((0.05 * d, 0.34 * d), (-half * 0.9, half * 0.9), (0.5 * h, h), b.pick("cab", list(BRIGHT)), 0.006)
        decal(b, (0.2 * d, 0.34 * d + 0.0003), (-half * 0.7, half * 0.7), (0.68 * h, 0.86 * h), "black glass")
        for s in (-1, 1):
            decal(
                b,
                (0.12 * d, 0.28 * d),
                (s * half * 0.9 - 0.0003, s * half * 0.9 + 0.0003),
                (0.68 * h, 0.86 * h),
                "black glass",
            )
        for y in (-0.85, 0.85):
            b.box(
                (-0.47 * d, 0.03 * d),
                (y * half - 0.003, y * half + 0.003),
                (0.55 * h, 0.82 * h),
                "yellow plastic",
                0.001,
            )
        b.box((-0.48 * d, -0.45 * d), (-0.88 * half, 0.88 * half), (0.55 * h, 0.82 * h), "yellow plastic", 0.001)
        for k in range(3):
            orb(
                b,
                (0.14 * d / 2, 0.3 * half, 0.16 * h),
                ((-0.36 + 0.15 * k) * d, (0.3 - 0.3 * (k % 2)) * half, 0.66 * h),
                "cardboard",
                8,
            )
    else:
        cuts = ((-0.4, 0.26, 0.86, 0.58), (-0.34, 0.14, 0.76, 0.93), (-0.3, 0.09, 0.66, 1.0))
        loft(
            b,
            [rect((a * d, c * d), (-half * f, half * f), zz * h, 0.05 * d) for a, c, f, zz in cuts],
            look,
            convex=True,
        )
        low, high = (
            rect((a * d + e, c * d + g), (-half * f, half * f), zz * h, 0.05 * d)
            for a, c, f, zz, e, g in (
                (-0.392, 0.248, 0.87, 0.62, 0.001, 0.001),
                (-0.347, 0.155, 0.785, 0.9, 0.0005, 0.0),
            )
        )
        b.add(lofted([low, high]), "black glass")
    for s in (-1, 1):
        with b.frame(d / 2 - 0.012, s * 0.3 * w, 0.42 * h, pitch=np.pi / 2):
            b.frustum(0.09 * h, 0.08 * h, (0.0, 0.0115), "lamp glow", 12)
        for x in (-0.3 * d, 0.3 * d):
            wheel(b, x, s * (w / 2 - 0.1 * w), r, 0.2 * w, "rubber", "steel")


@small("toy_train")
def toy_train(b: Builder) -> None:
    """An engine with a chimney and two wagons with a load."""
    d, w, h = b.size
    c = [b.material("body", *BRIGHT), b.pick("second", list(BRIGHT)), b.pick("third", list(BRIGHT))]
    part = d / 3
    r = 0.16 * h
    for k in range(3):
        x = d / 2 - (k + 0.5) * part
        long = part * 0.86
        with b.frame(x):
            b.box((-long / 2, long / 2), (-0.4 * w, 0.4 * w), (1.2 * r, 1.2 * r + 0.1 * h), "beech", 0.002)
            for s in (-1, 1):
                for wx in (-0.3 * long, 0.3 * long):
                    wheel(b, wx, s * (0.5 * w - 0.08 * w), r, 0.16 * w, c[(k + 1) % 3], "beech")
            if k < 2:
                b.bar((-long / 2 - 0.14 * part, 0, 1.5 * r), (-long / 2 + 0.002, 0, 1.5 * r), 0.003, "steel", 6)
            z = 1.2 * r + 0.1 * h
            if k == 0:
                with b.frame(-0.14 * long, 0, z + 0.22 * h, pitch=np.pi / 2):
                    b.frustum(0.22 * h, 0.22 * h, (0.0, 0.62 * long), c[0], 20, bevel=0.003)
                    b.frustum(0.15 * h, 0.15 * h, (0.62 * long, 0.635 * long), "yellow plastic", 16)
                b.box((-0.5 * long, -0.14 * long), (-0.4 * w, 0.4 * w), (z, 0.86 * h), c[0], 0.003)
                b.box((-0.53 * long, -0.08 * long), (-0.46 * w, 0.46 * w), (0.86 * h, 0.92 * h), c[1], 0.003)
                for s in (-1, 1):
                    decal(
                        b,
                        (-0.42 * long, -0.22 * long),
                        (s * 0.4 * w - 0.0003, s * 0.4 * w + 0.0003),
                        (0.62 * h, 0.8 * h),
                        "black glass",
                    )
                with b.frame(0.32 * long, 0, 0):
                    b.lathe([(0.07 * h, z + 0.4 * h), (0.07 * h, 0.86 * h), (0.12 * h, h)], c[1], 16)
            else:
                b.box((-long / 2, long / 2), (-0.42 * w, 0.42 * w), (z, z + 0.22 * h), c[k], 0.002)
                if k == 1:
                    for j in range(3):
                        with b.frame(0, (j - 1) * 0.24 * w, z + 0.26 * h, pitch=np.pi / 2):
                            b.frustum(0.11 * w, 0.11 * w, (-0.44 * long, 0.44 * long), "bark", 10)
                else:
                    for j in range(2):
                        b.box(
                            ((-0.42 + 0.44 * j) * long, (-0.02 + 0.44 * j) * long),
                            (-0.3 * w, 0.3 * w),
                            (z + 0.2 * h, z + (0.42 - 0.1 * j) * h),
                            c[(j + 1) % 3],
                            0.003,
                        )


def _eyes(b: Builder, x: float, y: float, z: float, r: float) -> None:
    for s in (-1, 1):
        orb(b, (0.5 * r, r, r), (x, s * y, z), "ink pigment", 8)


@small("doll")
def doll(b: Builder) -> None:
    """A rag doll that sits: dress, plaits, a smiling face."""
    d, w, h = b.size
    dress = b.material("dress", "rose fabric", "blue fabric", "mustard fabric", "red fabric", "green fabric")
    hair = b.material("hair", "brown leather", "mustard fabric", "rust fabric", "black fabric")
    skin = "skin tone"
    r = 0.2 * h
    back = -0.12 * d
    loft(
        b,
        [
            ellipse(e * 0.45 * d, e * 0.4 * w, z * h, 18, x=back)
            for e, z in ((1.0, 0.0), (1.05, 0.06), (0.62, 0.36), (0.5, 0.52), (0.3, 0.58))
        ],
        dress,
    )
    for s in (-1, 1):
        b.bar(
            (back + 0.1 * d, s * 0.16 * w, 0.07 * h), (0.36 * d, s * 0.24 * w, 0.06 * h), 0.055 * h, "white fabric", 10
        )
        orb(b, (0.08 * d, 0.05 * h, 0.085 * h), (0.42 * d, s * 0.25 * w, 0.085 * h), "red plastic", 10)
        b.bar((back, s * 0.16 * w, 0.5 * h), (0.04 * d, s * 0.4 * w, 0.3 * h), 0.04 * h, dress, 10)
        orb(b, (0.045 * h, 0.045 * h, 0.045 * h), (0.07 * d, s * 0.43 * w, 0.265 * h), skin, 10)
        orb(b, (0.06 * h, 0.055 * h, 0.11 * h), (back - 0.03 * d, s * (r + 0.035 * h), 0.62 * h), hair, 10)
        orb(b, (0.03 * h, 0.03 * h, 0.03 * h), (back, s * (r + 0.02 * h), 0.74 * h), dress, 8)
    b.ball((0.9 * r, r, r), (back, 0, 0.77 * h), skin, 18)
    b.ball((0.9 * r, 1.06 * r, 1.0 * r), (back - 0.15 * r, 0, 0.8 * h), hair, 18)
    b.cushion(
        (back + 0.3 * r, back + 0.85 * r),
        (-0.75 * r, 0.75 * r),
        (0.77 * h + 0.5 * r, 0.77 * h + 0.95 * r),
        hair,
        radius=0.3 * r,
    )
    _eyes(b, back + 0.84 * r, 0.34 * r, 0.78 * h, 0.09 * r)
    orb(b, (0.03 * r, 0.22 * r, 0.05 * r), (back + 0.84 * r, 0, 0.77 * h - 0.45 * r), "red plastic", 8)


@small("plush_toy")
def plush_toy(b: Builder) -> None:
    """A soft rabbit, bear or elephant that sits, with a ribbon."""
    d, w, h = b.size
    fur = b.material(
        "fur", "beige fabric", "white fabric", "grey fabric", "brown leather", "rose fabric", "blue fabric"
    )
    pale = b.material("belly", "white fabric", "sand pigment")
    ribbon = b.material("ribbon", "red fabric", "blue fabric", "mustard fabric", "green fabric")
    kind = b.pick("kind", ["rabbit", "bear", "elephant"])
    ear = 0.3 if kind == "rabbit" else 0.05
    top = h * (1 - ear)
    r = 0.26 * top
    x = -0.12 * d
    b.ball((0.36 * d, 0.36 * w, 0.3 * top), (x, 0, 0.3 * top), fur, 18)
    b.ball((0.3 * d, 0.26 * w, 0.22 * top), (x + 0.1 * d, 0, 0.28 * top), pale, 16)
    zc = top - r
    b.ball((0.95 * r, 1.05 * r, r), (x + 0.02 * d, 0, zc), fur, 18)
    b.ball((0.45 * r, 0.5 * r, 0.38 * r), (x + 0.75 * r, 0, zc - 0.25 * r), pale, 14)
    orb(b, (0.12 * r, 0.16 * r, 0.1 * r), (x + 1.18 * r, 0, zc - 0.12 * r), "ink pigment", 10)
    _eyes(b, x + 0.86 * r, 0.42 * r, zc + 0.22 * r, 0.1 * r)
    for s in (-1, 1):
        b.ball((0.24 * d, 0.15 * w, 0.13 * top), (0.25 * d, s * 0.3 * w, 0.13 * top), fur, 14)
        b.ball((0.03 * d, 0.08 * w, 0.07 * top), (0.475 * d, s * 0.3 * w, 0.13 * top), pale, 10)
        with b.frame(x + 0.1 * d, s * 0.36 * w, 0.4 * top, roll=s * 0.5, pitch=0.5):
            b.ball((0.1 * d, 0.1 * w, 0.17 * top), (0, 0, -0.06 * top), fur, 14)
        if kind == "rabbit":
            with b.frame(x, s * 0.4 * r, zc + 0.7 * r, roll=-s * 0.16):
                b.ball((0.16 * r, 0.3 * r, 0.6 * (h - zc - 0.7 * r)), (0, 0, 0.42 * (h - zc - 0.7 * r)), fur, 14)
                b.ball(
                    (0.08 * r, 0.17 * r, 0.45 * (h - zc - 0.7 * r)),
                    (0.1 * r, 0, 0.42 * (h - zc - 0.7 * r)),
                    "rose fabric",
                    12,
                )
        elif kind == "bear":
            b.ball((0.2 * r, 0.36 * r, 0.36 * r), (x, s * 0.8 * r, zc + 0.75 * r), fur, 14)
            b.ball((0.12 * r, 0.22 * r, 0.22 * r), (x + 0.13 * r, s * 0.8 * r, zc + 0.75 * r), pale, 12)
        else:
            b.ball((0.12 * r, 0.6 * r, 0.65 * r), (x - 0.1 * r, s * 1.15 * r, zc + 0.1 * r), fur, 16)
    if kind == "elephant":
        b.tube(
            [
                (x + 0.8 * r, 0, zc - 0.2 * r),
                (x + 1.3 * r, 0, zc - 0.6 * r),
                (x + 1.45 * r, 0, zc - 1.1 * r),
                (x + 1.7 * r, 0, zc - 1.25 * r),
            ],
            0.2 * r,
            fur,
            10,
        )
    neck = zc - 0.9 * r
    for s in (-1, 1):
        orb(b, (0.1 * r, 0.32 * r, 0.2 * r), (x + 0.75 * r, s * 0.3 * r, neck), ribbon, 10)
    orb(b, (0.14 * r, 0.12 * r, 0.13 * r), (x + 0.8 * r, 0, neck), ribbon, 8)


@small("ball", fit="cube")
def ball(b: Builder) -> None:
    """A ball: a football, a basketball or a striped beach ball."""
    d, _, _ = target(b)
    r = d / 2
    kind = b.pick("kind", ["football", "basketball", "beach"])
    look = b.material(
        "body", *{"football": ("white plastic",), "basketball": ("orange plastic",), "beach": ("white plastic",)}[kind]
    )
    n = 24
    if kind == "beach":
        colors = ("red plastic", "white plastic", "blue plastic", "white plastic", "yellow plastic", "white plastic")
        t = np.linspace(-np.pi / 2, np.pi / 2, 11)
        whole = shapes.containing_hull(shapes.ball((r, r, r), (0, 0, r), 48)[0])
        for k, c in enumerate(colors):
            a = np.linspace(k, k + 1, 5) * np.pi / 3
            rings = [
                np.r_[
                    [(0.0, 0.0, r + r * np.sin(s))],
                    np.c_[r * np.cos(s) * np.cos(a), r * np.cos(s) * np.sin(a), 0 * a + r + r * np.sin(s)],
                ]
                for s in t[1:-1]
            ]
            shape = shapes.hull(np.concatenate([*rings, [(0, 0, 0), (0, 0, 2 * r)]]))
            b.add(shape, c, [whole] if k == 0 else [])
        return
    b.ball((r, r, r), (0, 0, r), look, n)
    if kind == "football":
        phi = (1 + 5**0.5) / 2
        corners = np.array(
            [(0, s, t * phi) for s in (-1, 1) for t in (-1, 1)]
            + [(s, t * phi, 0) for s in (-1, 1) for t in (-1, 1)]
            + [(t * phi, 0, s) for s in (-1, 1) for t in (-1, 1)]
        )
        corners /= np.linalg.norm(corners, axis=1, keepdims=True)
        for q in corners:
            yaw, pitch = float(np.arctan2(q[1], q[0])), float(np.arccos(q[2]))
            with b.frame(0, 0, r, yaw=yaw, pitch=pitch):
                m = 0.36
                t = np.arange(5) * 2 * np.pi / 5
                pts = [
                    np.c_[k * r * np.cos(t), k * r * np.sin(t), 0 * t + z * r]
                    for k, z in ((m, (1 - m * m) ** 0.5 - 0.004), (0.5 * m, 0.984))
                ]
                b.add(shapes.hull(np.concatenate([*pts, [(0, 0, 0.8 * r)]])), "black plastic", [])
    else:
        for roll, yaw in ((0, 0), (np.pi / 2, 0), (np.pi / 2, np.pi / 2)):
            t = np.arange(24) * 2 * np.pi / 24
            with b.frame(0, 0, r, yaw=yaw, roll=roll):
                shape = shapes.sweep(np.c_[0.985 * r * np.cos(t), 0.985 * r * np.sin(t), 0 * t], 0.012 * r, 6, True)
                b.add(shape, "black plastic", [])


@small("puzzle_box")
def puzzle_box(b: Builder) -> None:
    """A flat box with a landscape and the lines of the pieces on its lid."""
    d, w, h = b.size
    look = b.material("body", "blue paint", "red paint", "green paint", "yellow paint", "teal paint")
    b.box((-d / 2 + 0.002, d / 2 - 0.002), (-w / 2 + 0.002, w / 2 - 0.002), (0.0, 0.6 * h), "paper", 0.001)
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.2 * h, h), look, 0.001)
    z = h + 0.0001
    decal(b, (-0.42 * d, 0.42 * d), (-0.46 * w, 0.3 * w), (h - 0.002, z), "sky pigment")
    decal(b, (0.0, 0.42 * d), (-0.46 * w, 0.3 * w), (h - 0.002, z + 0.00005), "moss pigment")
    for k, (y, s) in enumerate(((-0.3, 0.16), (-0.05, 0.22), (0.16, 0.12))):
        b.add(
            shapes.hull(
                np.array(
                    [
                        (0.0, (y - s) * w, h - 0.002),
                        (0.0, (y + s) * w, h - 0.002),
                        (-s * 1.4 * d, y * w, h - 0.002),
                        (0.0, (y - s) * w, z + 0.0001),
                        (0.0, min(0.3, y + s) * w, z + 0.0001),
                        (-s * 1.4 * d, y * w, z + 0.0001),
                    ]
                )
            ),
            ("sea pigment", "night pigment")[k % 2],
            [],
        )
    with b.frame(-0.3 * d, 0.18 * w, h):
        spot(b, 0.06 * w, (-0.002, 0.0003), "ochre pigment")
    for k in range(1, 6):
        x, y = (-0.42 + 0.14 * k) * d, (-0.46 + 0.127 * k) * w
        decal(b, (x - 0.0005, x + 0.0005), (-0.46 * w, 0.3 * w), (h - 0.002, h + 0.0004), "chalk pigment")
        decal(b, (-0.42 * d, 0.42 * d), (y - 0.0005, y + 0.0005), (h - 0.002, h + 0.0004), "chalk pigment")
    decal(b, (-0.36 * d, 0.3 * d), (0.36 * w, 0.42 * w), (h - 0.002, h + 0.0003), "chalk pigment")
    decal(b, (d / 2 - 0.002, d / 2 + 0.0003), (-0.36 * w, 0.2 * w), (0.42 * h, 0.8 * h), "chalk pigment")


@small("board_game")
def board_game(b: Builder) -> None:
    """A chess board with its pieces in the middle of a game."""
    d, w, h = b.size
    frame = b.material("frame", "walnut", "oak", "mahogany", "black paint")
    dark, pale = (
        b.material("dark", "walnut", "wenge", "ink pigment"),
        b.material("pale", "birch", "light oak", "cream paint"),
    )
    t = 0.022
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, t), frame, 0.003)
    sx, sy = 0.88 * d / 8, 0.88 * w / 8
    decal(b, (-4 * sx, 4 * sx), (-4 * sy, 4 * sy), (t - 0.002, t + 0.0002), pale)
    for i in range(8):
        for j in range(8):
            x, y = (i - 4) * sx, (j - 4) * sy
            if (i + j) % 2:
                decal(b, (x, x + sx), (y, y + sy), (t - 0.002, t + 0.0003), dark)
    u = h - t
    r = 0.36 * min(sx, sy)
    for side, look in ((0, pale), (7, dark)):
        for j in range(8):
            tall = (0.62, 0.7, 0.78, 0.95, 1.0, 0.78, 0.7, 0.62)[j] * u
            for row, size in ((side, tall), (1 if side == 0 else 6, 0.5 * u)):
                if row in (1, 6) and b.chance(f"moved {side} {j}", 0.3):
                    row += 2 if side == 0 else -2
                if row in (0, 7) and 0 < j < 7 and b.chance(f"taken {side} {j}", 0.2) and j != 4:
                    continue
                with b.frame((row - 3.5) * sx, (j - 3.5) * sy, t):
                    neck = 0.62 * size
                    b.lathe(
                        [
                            (r, 0.0),
                            (r, 0.06 * u),
                            (0.45 * r, 0.2 * size),
                            (0.34 * r, neck),
                            (0.62 * r, neck + 0.02 * u),
                            (0.5 * r, 0.86 * size),
                            (0.15 * r, size),
                        ],
                        look,
                        10,
                    )


@small("puzzle_cube", fit="cube")
def puzzle_cube(b: Builder) -> None:
    """A cube of 26 small ones with coloured faces, one layer turned."""
    d, _, _ = target(b)
    b.material("body", "black plastic", "white plastic")
    body = b.material("body", "black plastic")
    colors = ["red plastic", "orange plastic", "white plastic", "yellow plastic", "blue plastic", "green plastic"]
    s = d / 3
    for layer in range(3):
        with b.frame(0, 0, layer * s):
            b.box((-d / 2, d / 2), (-d / 2, d / 2), (0.0003, s - 0.0003), body, 0.001)
            for side in range(4):
                with b.frame(yaw=side * np.pi / 2):
                    for j in range(3):
                        c = colors[side] if b.chance("solved", 0.3) else b.pick(f"f{layer}{side}{j}", colors)
                        y = (j - 1.5) * s
                        decal(b, (d / 2 - 0.002, d / 2 + 0.0002), (y + 0.08 * s, y + 0.92 * s), (0.08 * s, 0.92 * s), c)
            for j in range(1, 3):
                y = (j - 1.5) * s
                decal(
                    b, (-d / 2 - 0.00005, d / 2 + 0.00005), (y - 0.0004, y + 0.0004), (0.002, s - 0.002), "ink pigment"
                )
    for i in range(3):
        for j in range(3):
            x, y = (i - 1.5) * s, (j - 1.5) * s
            c = colors[4] if b.chance("solved", 0.3) else b.pick(f"t{i}{j}", colors)
            decal(b, (x + 0.08 * s, x + 0.92 * s), (y + 0.08 * s, y + 0.92 * s), (d - 0.002, d + 0.0), c)


@small("robot_toy")
def robot_toy(b: Builder) -> None:
    """A tin robot with a chest panel, claws, lamps for eyes, and aerials."""
    d, w, h = b.size
    look = b.material("body", "steel", "red plastic", "blue plastic", "mint plastic", "yellow plastic")
    trim = b.material("trim", "grey plastic", "red plastic", "orange plastic", "black plastic")
    for s in (-1, 1):
        b.box((-0.4 * d, d / 2), (s * 0.17 * w - 0.12 * w, s * 0.17 * w + 0.12 * w), (0.0, 0.1 * h), trim, 0.006)
        b.box((-0.2 * d, 0.2 * d), (s * 0.17 * w - 0.08 * w, s * 0.17 * w + 0.08 * w), (0.1 * h, 0.33 * h), look, 0.003)
        with b.frame(0, s * 0.36 * w, 0.6 * h, roll=s * np.pi / 2):
            b.frustum(0.07 * h, 0.07 * h, (-0.06 * w, 0.02 * w), trim, 16)
        b.bar((0, s * 0.44 * w, 0.6 * h), (0.1 * d, s * 0.44 * w, 0.42 * h), 0.05 * w, look, 10)
        b.bar((0.1 * d, s * 0.44 * w, 0.42 * h), (0.3 * d, s * 0.44 * w, 0.36 * h), 0.045 * w, look, 10)
        for k in (-1, 1):
            b.box(
                (0.28 * d, 0.46 * d),
                (s * 0.44 * w + k * 0.045 * w - 0.012 * w, s * 0.44 * w + k * 0.045 * w + 0.012 * w),
                (0.33 * h, 0.39 * h),
                trim,
                0.002,
            )
        b.bar((-0.02 * d, s * 0.14 * w, 0.9 * h), (-0.02 * d, s * 0.18 * w, 0.98 * h), 0.004, "steel", 6)
        orb(b, (0.016 * h, 0.016 * h, 0.016 * h), (-0.02 * d, s * 0.18 * w, h - 0.016 * h), "red plastic", 8)
        with b.frame(0.33 * d, s * 0.11 * w, 0.84 * h, pitch=np.pi / 2):
            b.frustum(0.035 * h, 0.032 * h, (-0.01, 0.006), "lamp glow", 14)
    b.box((-0.36 * d, 0.36 * d), (-0.32 * w, 0.32 * w), (0.32 * h, 0.69 * h), look, 0.008)
    x = 0.36 * d
    decal(b, (x - 0.002, x + 0.0003), (-0.22 * w, 0.22 * w), (0.4 * h, 0.62 * h), "black plastic")
    for k, c in enumerate(("red plastic", "yellow plastic", "green plastic")):
        with b.frame(x, (-0.14 + 0.14 * k) * w, 0.56 * h, pitch=np.pi / 2):
            b.frustum(0.025 * h, 0.02 * h, (-0.001, 0.004), c, 10)
        decal(
            b,
            (x - 0.002, x + 0.0004),
            (-0.18 * w, (0.0 + 0.07 * k) * w),
            ((0.42 + 0.035 * k) * h, (0.44 + 0.035 * k) * h),
            "sky pigment",
        )
    b.frustum(0.1 * w, 0.1 * w, (0.69 * h, 0.73 * h), trim, 14)
    b.box((-0.3 * d, 0.33 * d), (-0.23 * w, 0.23 * w), (0.73 * h, 0.92 * h), look, 0.006)
    for k in range(5):
        y = (-0.1 + 0.05 * k) * w
        decal(
            b,
            (0.33 * d - 0.002, 0.33 * d + 0.0003),
            (y - 0.012 * w, y + 0.012 * w),
            (0.77 * h, 0.795 * h),
            "black plastic",
        )


@small("toy_dinosaur")
def toy_dinosaur(b: Builder) -> None:
    """A long-necked dinosaur with a row of plates on its back."""
    d, w, h = b.size
    look = b.material(
        "body", "green plastic", "blue plastic", "orange plastic", "grey plastic", "mint plastic", "lilac plastic"
    )
    spots = b.material("plates", "yellow plastic", "red plastic", "green plastic", "orange plastic")
    path = [
        (-0.5, 0.12, 0.02),
        (-0.4, 0.2, 0.05),
        (-0.26, 0.36, 0.1),
        (-0.12, 0.46, 0.16),
        (0.04, 0.48, 0.19),
        (0.16, 0.46, 0.16),
        (0.25, 0.56, 0.1),
        (0.32, 0.72, 0.07),
        (0.36, 0.86, 0.06),
    ]
    n = 12
    a = np.arange(n) * 2 * np.pi / n
    pts = np.array([(x * d, z * h) for x, z, _ in path])
    rings = []
    for k, (_, _, s) in enumerate(path):
        way = pts[min(k + 1, len(pts) - 1)] - pts[max(k - 1, 0)]
        way /= np.linalg.norm(way)
        q = np.array([-way[1], way[0]])
        rings.append(
            np.c_[
                pts[k, 0] + s * h * np.sin(a) * q[0] * 1.25,
                1.25 * min(s * h, 0.4 * w) * np.cos(a),
                pts[k, 1] + 1.25 * s * h * np.sin(a) * q[1],
            ][::-1]
        )
    shape = lofted([r[::-1] for r in rings])
    b.add(shape, look, [shapes.hull(np.concatenate(p)) for p in zip(rings[:-1], rings[1:], strict=True)])
    orb(b, (0.11 * d, 0.24 * w, 0.085 * h), (0.4 * d, 0, 0.905 * h), look, 12)
    _eyes(b, 0.44 * d, 0.19 * w, 0.935 * h, 0.016 * h)
    for s in (-1, 1):
        for x in (-0.12, 0.14):
            with b.frame(x * d, s * 0.3 * w):
                b.lathe(
                    [
                        (0.07 * d * 0.8, 0.0),
                        (0.062 * d * 0.8, 0.03 * h),
                        (0.05 * d * 0.8, 0.2 * h),
                        (0.06 * d * 0.8, 0.4 * h),
                    ],
                    look,
                    12,
                )
    for k in range(7):
        x = -0.36 + 0.09 * k
        z = float(np.interp(x, [p[0] for p in path], [p[1] + 1.2 * p[2] for p in path]))
        size = 0.1 * h * (1 - abs(k - 3) * 0.16)
        b.hull(
            [
                (x * d + px * size, py, (z - 0.03) * h + pz * size)
                for px, pz in ((-0.7, 0), (0.7, 0), (0.1, 1.3))
                for py in (-0.004, 0.004)
            ],
            spots,
        )


@small("stacking_rings", fit="round")
def stacking_rings(b: Builder) -> None:
    """Rings in the colours of the rainbow on a peg, a ball on top."""
    d, _, h = target(b)
    base = b.material("base", "beech", "white plastic", "pine")
    b.frustum(0.5 * d, 0.46 * d, (0.0, 0.08 * h), base, 28)
    colors = ["red plastic", "orange plastic", "yellow plastic", "green plastic", "blue plastic", "lilac plastic"]
    count = 5
    step = 0.74 * h / count
    for k in range(count):
        r, z = d * (0.46 - 0.055 * k), 0.08 * h + k * step
        b.lathe(
            [
                (r - 0.4 * step, z),
                (r - 0.1 * step, z + 0.2 * step),
                (r, z + 0.5 * step),
                (r - 0.1 * step, z + 0.8 * step),
                (r - 0.4 * step, z + step),
            ],
            colors[k + (1 if b.chance("shift", 0.5) else 0)],
            24,
        )
    b.frustum(0.05 * d, 0.05 * d, (0.8 * h, 0.88 * h), base, 12)
    orb(b, (0.09 * h, 0.09 * h, 0.09 * h), (0, 0, 0.91 * h), "red plastic", 12)


@small("crayon_box")
def crayon_box(b: Builder) -> None:
    """An open carton with two rows of crayons in all colours."""
    d, w, h = b.size
    look = b.material("body", "yellow plastic", "green plastic", "blue plastic", "red plastic", "orange plastic")
    low = 0.62 * h
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, low), look, 0.0008)
    b.box((-d / 2, -d / 2 + 0.001), (-w / 2, w / 2), (low - 0.002, 0.86 * h), look, 0.0)
    colors = [
        "red plastic",
        "orange plastic",
        "yellow plastic",
        "green plastic",
        "teal paint",
        "blue plastic",
        "lilac plastic",
        "pink plastic",
        "black plastic",
    ]
    n = 7
    r = 0.4 * w / n
    for row in range(2):
        for k in range(n):
            c = colors[(k + 4 * row + b.whole("start", 0, 8)) % 9]
            top = (0.9 if row else 1.0) * h - 0.004 * ((k * 3 + row) % 3)
            with b.frame(d * (0.22 if row else -0.2), (k - (n - 1) / 2) * 0.94 * w / n, 0.0):
                b.frustum(r, r, (low - 0.002, top - 2.2 * r), c, 10)
                b.frustum(0.9 * r, 0.3 * r, (top - 2.2 * r, top), c, 10)
    x = (0.0, d / 2 + 0.0003)
    decal(b, x, (-0.44 * w, 0.44 * w), (0.36 * h, 0.54 * h), "chalk pigment")
    for k in range(7):
        y = (-0.36 + 0.105 * k) * w
        decal(b, (0.0, d / 2 + 0.0004), (y, y + 0.07 * w), (0.08 * h, (0.22 + 0.03 * (k % 3)) * h), colors[k])
    decal(b, (0.0, d / 2 + 0.0004), (-0.3 * w, 0.3 * w), (0.42 * h, 0.48 * h), "ink pigment")


@small("toy_airplane")
def toy_airplane(b: Builder) -> None:
    """A propeller plane on its wheels."""
    d, w, h = b.size
    look = b.material(
        "body", "red plastic", "yellow plastic", "blue plastic", "white plastic", "orange plastic", "beech"
    )
    wing = b.material("wings", "white plastic", "red plastic", "yellow plastic", "blue plastic", "light oak")
    r = 0.2 * h
    zc = 0.45 * h
    with b.frame(0, 0, zc, pitch=np.pi / 2):
        b.lathe(
            [
                (0.25 * r, -0.5 * d + 0.02),
                (0.8 * r, -0.1 * d),
                (r, 0.12 * d),
                (r, 0.28 * d),
                (0.8 * r, 0.4 * d),
                (0.3 * r, 0.44 * d),
            ],
            look,
            18,
        )
        b.frustum(0.3 * r, 0.08 * r, (0.44 * d, 0.5 * d), "black plastic", 14)
    for turn in (0.4, 0.4 + np.pi / 2):
        with b.frame(0.465 * d, 0, zc, roll=turn):
            b.box((-0.002, 0.002), (-0.42 * h, 0.42 * h), (-0.007, 0.007), "black plastic", 0.001)
    slab(b, (0.05 * d, 0.27 * d), (-w / 2, w / 2), (zc - 0.5 * r, zc - 0.5 * r + 0.008), wing, 0.06 * d, 0.002)
    slab(b, (-0.49 * d, -0.38 * d), (-0.2 * w, 0.2 * w), (zc, zc + 0.006), wing, 0.03 * d, 0.002)
    b.hull(
        [
            (x * d, y, z)
            for y in (-0.003, 0.003)
            for x, z in ((-0.5, zc), (-0.34, zc), (-0.44, h - 0.001), (-0.5, h - 0.001))
        ],
        wing,
    )
    b.ball((0.1 * d, 0.7 * r, 0.75 * r), (0.08 * d, 0, zc + 0.75 * r), "black glass", 14)
    for s in (-1, 1):
        b.bar((0.2 * d, s * 0.1 * w, zc - 0.4 * r), (0.22 * d, s * 0.14 * w, 0.15 * h), 0.004, "steel", 6)
        wheel(b, 0.22 * d, s * 0.14 * w, 0.15 * h, 0.012, "rubber", "yellow plastic")
    b.bar((-0.42 * d, 0, zc - 0.1 * r), (-0.44 * d, 0, 0.05 * h), 0.004, "steel", 6)
    wheel(b, -0.44 * d, 0, 0.06 * h, 0.008, "rubber", "yellow plastic")


@small("xylophone")
def xylophone(b: Builder) -> None:
    """Eight coloured bars on two rails, and a beater."""
    d, w, h = b.size
    wood = b.material("body", "beech", "pine", "birch")
    colors = [
        "red plastic",
        "orange plastic",
        "yellow plastic",
        "green plastic",
        "teal paint",
        "blue plastic",
        "lilac plastic",
        "pink plastic",
    ]
    for s in (-1, 1):
        b.hull(
            [
                (s * x * d, y * w, z)
                for y, x0 in ((-0.5, 0.36), (0.5, 0.2))
                for x in (x0 - 0.05, x0 + 0.05)
                for z in (0.0, 0.5 * h)
            ],
            wood,
        )
    for y in (-0.47, 0.47):
        long = 0.36 if y < 0 else 0.2
        b.box((-long * d, long * d), (y * w - 0.012, y * w + 0.012), (0.0, 0.45 * h), wood, 0.002)
    for k in range(8):
        y = (-0.44 + 0.125 * k) * w
        long = 0.5 - 0.026 * k
        b.box((-long * d, long * d), (y - 0.045 * w, y + 0.045 * w), (0.5 * h, 0.66 * h), colors[k], 0.002)
        for s in (-1, 1):
            with b.frame(s * (long - 0.1) * d, y):
                b.add(shapes.frustum(0.004, 0.003, (0.6 * h, 0.66 * h + 0.0003), 8), "steel", [])
    r = 0.17 * h
    b.bar((0.1 * d, -0.3 * w, 0.66 * h + 0.8 * r), (-0.05 * d, 0.34 * w, 0.66 * h + r), 0.0035, wood, 8)
    orb(b, (r, r, r), (-0.05 * d, 0.34 * w, 0.66 * h + r), "red plastic", 12)
