"""Tools of a workshop, and what cleans a house."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ...textures import kind_of
from ..builder import Builder
from .small_kit import arch, band, decal, hoop, loft, rect, slab, small, spot, spun, target


@small("hammer")
def hammer(b: Builder) -> None:
    """A claw hammer lying on its side."""
    d, w, h = b.size
    grip = b.material("grip", "beech", "red plastic", "black plastic", "blue plastic", "oak")
    z = h / 2
    b.cushion((-d / 2, -0.08 * d), (-0.13 * w, 0.13 * w), (0.1 * h, 0.9 * h), grip, radius=0.3 * h)
    b.cushion(
        (-0.12 * d, 0.46 * d),
        (-0.08 * w, 0.08 * w),
        (0.2 * h, 0.8 * h),
        "beech" if kind_of(grip.texture) == "wood" else "steel",
        radius=0.2 * h,
    )
    with b.frame(0.43 * d, 0, z, roll=-np.pi / 2):
        b.lathe(
            [
                (0.32 * h, -0.16 * w),
                (0.42 * h, -0.1 * w),
                (0.42 * h, 0.16 * w),
                (0.3 * h, 0.24 * w),
                (0.3 * h, 0.3 * w),
                (0.48 * h, 0.34 * w),
                (0.48 * h, 0.48 * w),
                (0.42 * h, 0.5 * w),
            ],
            "brushed steel",
            16,
        )
    for s in (-1, 1):
        b.hull(
            [
                (x * d, y * w, z + s * zz * h)
                for x, y, zz in (
                    (0.40, -0.14, 0.04),
                    (0.47, -0.14, 0.04),
                    (0.40, -0.14, 0.36),
                    (0.47, -0.14, 0.36),
                    (0.39, -0.36, 0.1),
                    (0.42, -0.36, 0.1),
                    (0.39, -0.36, 0.42),
                    (0.42, -0.36, 0.42),
                    (0.32, -0.5, 0.2),
                    (0.33, -0.5, 0.4),
                )
            ],
            "brushed steel",
        )


@small("screwdriver_set")
def screwdriver_set(b: Builder) -> None:
    """Six screwdrivers upright in a stand, from large to small."""
    d, w, h = b.size
    look = b.material("stand", "black plastic", "oak", "grey plastic", "red plastic")
    grip = b.material("grips", "red plastic", "yellow plastic", "blue plastic", "orange plastic", "green plastic")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.06 * h), look, 0.003)
    for s in (-1, 1):
        b.box(
            (-0.3 * d, 0.3 * d),
            (s * (w / 2 - 0.006) - 0.006, s * (w / 2 - 0.006) + 0.006),
            (0.06 * h, 0.42 * h),
            look,
            0.002,
        )
    b.box((-0.42 * d, 0.42 * d), (-w / 2, w / 2), (0.42 * h, 0.48 * h), look, 0.003)
    for k in range(6):
        s = 1.0 - 0.07 * k
        with b.frame(0, (-0.38 + 0.152 * k) * w, 0):
            b.bar((0, 0, (0.1 + 0.03 * k) * h), (0, 0, 0.5 * h), 0.0032 * s, "steel", 8)
            top = 0.5 * h + 0.5 * h * s
            r = 0.065 * w * s
            b.lathe(
                [
                    (0.6 * r, 0.48 * h),
                    (0.75 * r, 0.53 * h),
                    (0.65 * r, 0.56 * h),
                    (r, 0.66 * h),
                    (0.95 * r, top - 0.03 * h),
                    (0.6 * r, top),
                ],
                grip,
                8,
            )
            b.frustum(0.62 * r, 0.62 * r, (0.535 * h, 0.56 * h), "black plastic", 10)


@small("drill")
def drill(b: Builder) -> None:
    """A cordless drill on its battery: motor, chuck, bit, grip, trigger."""
    d, w, h = b.size
    look = b.material("body", "yellow plastic", "blue plastic", "green plastic", "red plastic", "orange plastic")
    r = 0.4 * w
    zc = h - r * 1.1
    xb = -0.2 * d
    slab(b, (xb - 0.26 * d, xb + 0.3 * d), (-w / 2, w / 2), (0.0, 0.2 * h), "black plastic", 0.012, 0.004)
    slab(b, (xb - 0.22 * d, xb + 0.24 * d), (-0.44 * w, 0.44 * w), (0.19 * h, 0.26 * h), look, 0.01, 0.003)
    loft(
        b,
        [
            rect((xb + a * d, xb + c * d), (-e * w, e * w), z * h, 0.012)
            for a, c, e, z in ((-0.12, 0.12, 0.26, 0.25), (-0.11, 0.08, 0.24, 0.45), (-0.13, 0.14, 0.28, 0.66))
        ],
        look,
    )
    b.box((xb + 0.07 * d, xb + 0.16 * d), (-0.1 * w, 0.1 * w), (0.52 * h, 0.66 * h), "black plastic", 0.004)
    with b.frame(0, 0, zc, pitch=np.pi / 2):
        b.lathe([(0.8 * r, -0.5 * d), (1.05 * r, -0.44 * d), (1.1 * r, -0.1 * d), (0.95 * r, 0.12 * d)], look, 20)
        b.frustum(0.8 * r, 0.8 * r, (0.12 * d, 0.16 * d), "grey plastic", 20)
        b.lathe([(0.72 * r, 0.16 * d), (0.72 * r, 0.28 * d), (0.36 * r, 0.36 * d)], "black plastic", 14)
        b.frustum(0.003, 0.0025, (0.35 * d, 0.5 * d), "steel", 8)
        spot(b, 1.05 * r, (-0.44 * d, -0.40 * d), "black plastic", 20)
    decal(b, (-0.3 * d, -0.1 * d), (-1.07 * r, 1.07 * r), (zc - 0.004, zc + 0.004), "black plastic")


@small("paint_can", fit="round")
def paint_can(b: Builder) -> None:
    """A tin of paint with a label, a drip, a wire handle, and a brush on its lid."""
    d, _, h = target(b)
    r = 0.47 * d
    label = b.material("label", "white paint", "navy paint", "yellow paint", "sage paint")
    paint = b.pick(
        "paint", ["teal paint", "red paint", "yellow paint", "sage paint", "blue paint", "terracotta pigment"]
    )
    top = 0.86 * h
    b.frustum(r, r, (0.0, top - 0.008), "steel", 28)
    b.lathe(
        [(1.03 * r, top - 0.012), (1.03 * r, top), (0.94 * r, top), (0.93 * r, top - 0.006), (0.0, top - 0.006)],
        "steel",
        28,
        hollow=True,
    )
    band(b, r, r, (0.1 * top, 0.82 * top), label, 28)
    band(b, r + 0.0001, r + 0.0001, (0.34 * top, 0.62 * top), paint, 28)
    for y, low in ((0.1, 0.56), (0.24, 0.74), (-0.05, 0.7)):
        with b.frame(yaw=y * 4):
            b.box((0.96 * r, 1.045 * r), (-0.045 * r, 0.045 * r), (low * top, top), paint, 0.002)
    spot(b, 0.7 * r, (top - 0.01, top - 0.003), paint, 24)
    for s in (-1, 1):
        with b.frame(0, s * r, 0.86 * top, roll=-s * np.pi / 2):
            b.frustum(0.014, 0.01, (-0.002, 0.006), "steel", 12)
    t = np.linspace(0, np.pi, 9)
    b.tube(
        np.c_[0.55 * r * np.sin(t) + 0.5 * r * np.sin(t), 1.04 * r * np.cos(t), 0.86 * top - 0.34 * top * np.sin(t)],
        0.0025,
        "steel",
        6,
    )
    with b.frame(-0.72 * r, 0.1 * r, top - 0.002, yaw=0.2):
        b.box((0.0, 0.5 * r), (-0.012, 0.012), (0.0, h - top), "beech", 0.005)
        b.box((0.5 * r, 0.75 * r), (-0.03, 0.03), (0.0, 0.018), "steel", 0.001)
        b.box((0.75 * r, 1.3 * r), (-0.028, 0.028), (0.001, 0.016), paint, 0.003)


@small("flashlight")
def flashlight(b: Builder) -> None:
    """A torch that lies, its wide head with a glowing lens to the front."""
    d, w, h = b.size
    look = b.material("body", "black steel", "yellow plastic", "red plastic", "aluminium", "blue plastic")
    r = h / 2
    with b.frame(0, 0, r, pitch=np.pi / 2):
        b.lathe([(0.52 * r, -d / 2), (0.62 * r, -0.48 * d), (0.62 * r, 0.16 * d), (r, 0.3 * d), (r, d / 2)], look, 20)
        for k in range(6):
            z = -0.36 * d + 0.07 * d * k
            b.frustum(0.66 * r, 0.66 * r, (z, z + 0.03 * d), "rubber", 16)
        spot(b, 0.84 * r, (0.4 * d, d / 2 + 0.0003), "chrome", 20)
        spot(b, 0.74 * r, (0.4 * d, d / 2 + 0.0004), "lamp glow", 20)
    b.box(
        (0.06 * d, 0.14 * d),
        (-0.2 * r, 0.2 * r),
        (1.5 * r, 1.75 * r),
        "red plastic" if look.name != "red plastic" else "black plastic",
        0.001,
    )
    b.box((-0.49 * d, -0.46 * d), (-0.5 * r, 0.5 * r), (0.0, 0.6 * r), look, 0.001)


@small("tape_measure")
def tape_measure(b: Builder) -> None:
    """A round-cornered case with a bright disc, the tape's end pulled out."""
    d, w, h = b.size
    look = b.material("body", "yellow plastic", "orange plastic", "red plastic", "blue plastic", "green plastic")
    body = 0.88 * d
    with b.frame(-d / 2 + body / 2, 0, h / 2, roll=np.pi / 2):
        slab(b, (-body / 2, body / 2), (-h / 2, h / 2), (-w / 2, w / 2), look, 0.26 * h, 0.005, 4)
        b.add(shapes.frustum(0.36 * h, 0.36 * h, (-w / 2 - 0.0002, w / 2 + 0.0002), 24), "black plastic", [])
        b.add(shapes.frustum(0.28 * h, 0.28 * h, (-w / 2 - 0.0003, w / 2 + 0.0003), 24), "steel", [])
    b.box((0.2 * d, d / 2 - 0.002), (-0.3 * w, 0.3 * w), (0.06 * h, 0.1 * h), "yellow plastic", 0.0)
    b.box((d / 2 - 0.003, d / 2), (-0.34 * w, 0.34 * w), (0.0, 0.12 * h), "steel", 0.0005)


@small("wrench")
def wrench(b: Builder) -> None:
    """A spanner with an open jaw and a ring."""
    d, w, h = b.size
    steel = b.material("body", "steel", "brushed steel", "black steel", "chrome")
    z = (0.0, h)
    b.hull(
        [
            (x * d, y * w, zz * h)
            for x, y in ((-0.36, 0.16), (-0.36, -0.16), (0.3, 0.2), (0.3, -0.2))
            for zz in (0.1, 0.9)
        ],
        steel,
    )
    decal(b, (-0.24 * d, 0.2 * d), (-0.09 * w, 0.09 * w), (0.5 * h, 0.9 * h + 0.0003), "iron")
    t = np.arange(14) * 2 * np.pi / 14
    n = np.array([[-0.12 * w, -h / 2], [0.12 * w, -h / 2], [0.12 * w, h / 2], [-0.12 * w, h / 2]])
    b.tube(
        np.c_[-0.5 * d + 0.36 * w + 0.24 * w * np.cos(t), 0.24 * w * np.sin(t), 0 * t + h / 2], n, steel, closed=True
    )
    for s in (-1, 1):
        b.extrude(
            np.array(
                [
                    (0.28 * d, 0.0),
                    (0.36 * d, 0.0),
                    (0.38 * d, s * 0.2 * w),
                    (0.5 * d, s * 0.26 * w),
                    (0.47 * d, s * 0.44 * w),
                    (0.38 * d, s * 0.5 * w),
                    (0.3 * d, s * 0.4 * w),
                ]
            )[:: int(s)],
            z,
            steel,
        )


@small("spray_bottle")
def spray_bottle(b: Builder) -> None:
    """A bottle with a trigger head."""
    d, w, h = b.size
    look = b.material(
        "body", "clear plastic", "blue plastic", "green plastic", "amber glass", "white plastic", "pink plastic"
    )
    head = b.material("head", "white plastic", "black plastic", "red plastic", "grey plastic")
    r = 0.5 * w
    x = -0.14 * d
    top = 0.66 * h
    with b.frame(x):
        spun(
            b,
            [(0.94 * r, 0.0), (r, 0.01), (r, 0.46 * h), (0.8 * r, 0.56 * h), (0.34 * r, top)],
            look,
            0.7 * d / w,
            1.0,
            22,
        )
        if look.opacity < 1:
            spun(
                b,
                [(0.9 * r, 0.006), (0.94 * r, 0.012), (0.94 * r, 0.4 * h)],
                "sky pigment",
                0.7 * d / w,
                1.0,
                22,
                parts=False,
            )
        b.frustum(0.42 * r, 0.38 * r, (top - 0.004, 0.74 * h), head, 18)
        b.frustum(0.22 * r, 0.22 * r, (0.73 * h, 0.86 * h), head, 12)
        decal(b, (0.2 * d, 0.35 * d - 0.0015), (-0.22 * w, 0.22 * w), (0.14 * h, 0.4 * h), "paper", own=True)
        decal(
            b,
            (0.2 * d, 0.35 * d - 0.0012),
            (-0.16 * w, 0.16 * w),
            (0.26 * h, 0.32 * h),
            b.pick("print", ["green plastic", "blue plastic", "orange plastic"]),
            own=True,
        )
    b.hull(
        [
            (px * d, s * 0.17 * w, z * h)
            for s in (-1, 1)
            for px, z in (
                (-0.42, 0.9),
                (-0.3, 0.82),
                (0.3, 0.87),
                (0.36, 0.9),
                (0.36, 0.97),
                (-0.1, 1.0),
                (-0.36, 0.98),
            )
        ],
        head,
    )
    b.box((0.34 * d, 0.5 * d), (-0.13 * w, 0.13 * w), (0.885 * h, 0.975 * h), head, 0.003)
    b.hull(
        [
            (px * d, s * 0.1 * w, z * h)
            for s in (-1, 1)
            for px, z in ((0.06, 0.87), (0.18, 0.88), (0.3, 0.72), (0.24, 0.71), (0.08, 0.8))
        ],
        "grey plastic" if head.name != "grey plastic" else "red plastic",
    )


@small("bucket", fit="round")
def bucket(b: Builder) -> None:
    """A pail with a wire handle, and in some a cloth over its rim."""
    d, _, h = target(b)
    r = 0.485 * d
    look = b.material(
        "body",
        "blue plastic",
        "red plastic",
        "grey plastic",
        "brushed steel",
        "yellow plastic",
        "green plastic",
        "white plastic",
    )
    b.lathe(
        [
            (0.72 * r, 0.0),
            (0.74 * r, 0.01),
            (0.97 * r, h - 0.02),
            (r, h - 0.018),
            (r, h - 0.002),
            (0.96 * r, h),
            (0.94 * r, h),
            (0.7 * r, 0.012),
            (0.0, 0.01),
        ],
        look,
        30,
        hollow=True,
    )
    b.add(shapes.frustum(0.71 * r, 0.92 * r, (0.02 * h, 0.9 * h), 28), "sky pigment", [])
    for s in (-1, 1):
        with b.frame(0, s * 0.95 * r, h - 0.04, roll=-s * np.pi / 2):
            b.frustum(0.018, 0.014, (-0.01, 0.03 * r + 0.006), look, 14)
    t = np.linspace(0, np.pi, 10)
    b.tube(np.c_[r * 1.0 * np.sin(t), 1.0 * r * np.cos(t), h - 0.04 - 0.16 * h * np.sin(t)], 0.003, "steel", 6)
    b.box(
        (0.985 * r, 1.03 * r), (-0.16 * r, 0.16 * r), (h - 0.05 - 0.16 * h, h - 0.03 - 0.16 * h), "black plastic", 0.004
    )
    if b.chance("cloth", 0.5):
        c = b.pick("cloth colour", ["mustard fabric", "blue fabric", "rose fabric"])
        with b.frame(yaw=2.4):
            b.box((0.9 * r, 1.02 * r), (-0.24 * r, 0.24 * r), (h - 0.006, h + 0.004), c, 0.002)
            b.box((0.97 * r, 1.03 * r), (-0.24 * r, 0.26 * r), (0.6 * h, h + 0.002), c, 0.003)


@small("extension_cord")
def extension_cord(b: Builder) -> None:
    """A strip of four or five sockets with a switch and its cord."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "black plastic", "grey plastic")
    dark = "grey plastic" if look.name != "grey plastic" else "black plastic"
    y1 = w / 2 - 0.07
    slab(b, (-0.36 * d, 0.36 * d), (-w / 2, y1), (0.0, h), look, 0.012, 0.004)
    count = 5 if w > 0.36 else 4
    step = (y1 + w / 2 - 0.05) / count
    for k in range(count):
        with b.frame(0, -w / 2 + 0.012 + (k + 0.5) * step, h):
            spot(b, min(0.3 * d, 0.44 * step), (-0.01, 0.0003), dark, 20)
            for s in (-1, 1):
                with b.frame(0, s * 0.15 * step, 0):
                    spot(b, 0.003, (-0.01, 0.0004), "ink pigment", 8)
    decal(b, (-0.12 * d, 0.12 * d), (y1 - 0.036, y1 - 0.012), (h - 0.01, h + 0.0003), "red plastic")
    path = [
        (0, y1 - 0.01, 0.02),
        (0, y1 + 0.02, 0.012),
        (0.3 * d, y1 + 0.05, 0.006),
        (0.45 * d, 0.2 * w, 0.006),
        (0.45 * d, -0.3 * w, 0.006),
    ]
    b.tube(path, 0.0045, look, 6)
    b.tube(
        [
            (0.3 * d, y1 + 0.05, 0.006),
            (-0.1 * d, y1 + 0.064, 0.006),
            (-0.45 * d, y1 - 0.02, 0.006),
            (-0.45 * d, -0.3 * w, 0.006),
        ],
        0.0045,
        look,
        6,
    )


@small("watering_can")
def watering_can(b: Builder) -> None:
    """A can with a long spout and rose to the left, a handle behind and above."""
    d, w, h = b.size
    look = b.material(
        "body", "green paint", "copper", "brushed steel", "mint plastic", "yellow plastic", "white steel", "grey paint"
    )
    r = d / 2
    y = -0.16 * w
    top = 0.62 * h
    with b.frame(0, y):
        b.lathe([(0.96 * r, 0.0), (r, 0.02), (0.86 * r, top)], look, 24)
        hoop(b, 0.985 * r, 0.04, 0.003, look, 16)
        hoop(b, 0.87 * r, top - 0.006, 0.003, look, 16)
        with b.frame(0, 0, top):
            spot(b, 0.72 * r, (-0.01, 0.0003), "sea pigment", 20)
        arch(b, (0, -0.6 * r, top - 0.01), (0, 0.62 * r, top - 0.01), (0, 0, h - top + 0.004), 0.008, look, 8)
        arch(
            b,
            (0, -0.84 * r, top - 0.02),
            (0, -0.94 * r, 0.16 * h),
            (0, -(w / 2 + y - 0.94 * r) + 0.02, 0),
            0.007,
            look,
            6,
        )
    a, c = np.array([0.0, y + 0.84 * r, 0.16 * h]), np.array([0.0, w / 2 - 0.04, 0.82 * h])
    b.bar(a, c, 0.015, look, 12)
    way = (c - a) / np.linalg.norm(c - a)
    with b.frame(*[float(v) for v in c], roll=-float(np.arctan2(way[1], way[2]))):
        b.frustum(0.014, 0.036, (-0.012, 0.035), look, 18)
        b.frustum(0.036, 0.03, (0.035, 0.042), "brass", 18)
    b.bar(
        (0, y + 0.8 * r, top - 0.02),
        (0, float(a[1] + 0.55 * (c - a)[1]), float(a[2] + 0.55 * (c - a)[2])),
        0.005,
        look,
        8,
    )


@small("handsaw")
def handsaw(b: Builder) -> None:
    """A lying saw: a tapered blade with teeth and a closed grip."""
    d, w, h = b.size
    grip = b.material("grip", "beech", "walnut", "red plastic", "black plastic", "yellow plastic")
    z = (0.05 * h, 0.17 * h)
    b.hull(
        [(x * d, y * w, zz) for x, y in ((-0.3, 0.42), (-0.3, -0.42), (0.5, -0.42), (0.5, 0.0)) for zz in z], "steel"
    )
    n = 26
    for k in range(n):
        x = (-0.28 + 0.78 * k / n) * d
        b.add(
            shapes.hull(
                np.array(
                    [(x, -0.42 * w + 0.002, zz) for zz in z]
                    + [(x + 0.74 * d / n, -0.42 * w + 0.002, zz) for zz in z]
                    + [(x + 0.4 * d / n, -0.46 * w, zz) for zz in z]
                )
            ),
            "steel",
            [] if k else [shapes.box((-0.28 * d, 0.5 * d), (-0.46 * w, -0.41 * w), z)],
        )
    ring = [(-0.25, -0.4), (-0.45, -0.42), (-0.49, 0.0), (-0.44, 0.36), (-0.3, 0.46), (-0.24, 0.2)]
    sec = np.array([[-0.014, -h / 2], [0.014, -h / 2], [0.014, h / 2], [-0.014, h / 2]]) * [1, 0.98]
    b.tube([(x * d, y * w, h / 2) for x, y in ring], sec, grip, closed=True)
    for y in (-0.2, 0.15):
        with b.frame(-0.255 * d, y * w, 0):
            b.frustum(0.006, 0.006, (0.3 * h, 0.7 * h), "brass", 10)


@small("vise")
def vise(b: Builder) -> None:
    """A bench vise: foot, two jaws, screw and bar."""
    d, w, h = b.size
    look = b.material("body", "blue paint", "green paint", "grey paint", "iron", "red paint")
    b.hull(
        [(x * d, y * w, z) for x, y in ((-0.44, 0.5), (-0.44, -0.5), (0.1, 0.5), (0.1, -0.5)) for z in (0.0, 0.1 * h)],
        look,
    )
    b.hull(
        [
            (x * d, y * w, z * h)
            for x, y, z in (
                (-0.4, 0.34, 0.1),
                (-0.4, -0.34, 0.1),
                (0.06, 0.34, 0.1),
                (0.06, -0.34, 0.1),
                (-0.36, 0.26, 0.5),
                (-0.36, -0.26, 0.5),
                (0.02, 0.26, 0.5),
                (0.02, -0.26, 0.5),
            )
        ],
        look,
    )
    b.box((-0.44 * d, -0.06 * d), (-0.4 * w, 0.4 * w), (0.48 * h, h), look, 0.008)
    b.box((-0.06 * d, -0.03 * d), (-0.42 * w, 0.42 * w), (0.8 * h, 0.98 * h), "brushed steel", 0.002)
    b.box((-0.02 * d, 0.3 * d), (-0.2 * w, 0.2 * w), (0.46 * h, 0.7 * h), look, 0.005)
    b.box((0.07 * d, 0.26 * d), (-0.4 * w, 0.4 * w), (0.6 * h, h), look, 0.008)
    b.box((0.05 * d, 0.08 * d), (-0.42 * w, 0.42 * w), (0.8 * h, 0.98 * h), "brushed steel", 0.002)
    b.bar((-0.05 * d, 0, 0.56 * h), (0.48 * d, 0, 0.56 * h), 0.05 * h, "steel", 12)
    with b.frame(0.42 * d, 0, 0.56 * h, pitch=np.pi / 2):
        b.frustum(0.09 * h, 0.09 * h, (0.0, 0.08 * d), "brushed steel", 14)
    b.bar((0.46 * d, -0.32 * w, 0.42 * h), (0.46 * d, 0.36 * w, 0.72 * h), 0.025 * h, "steel", 8)
    for k in ((0.46, -0.32, 0.42), (0.46, 0.36, 0.72)):
        b.ball((0.04 * h, 0.04 * h, 0.04 * h), (k[0] * d, k[1] * w, k[2] * h), "steel", 10)


@small("spirit_level")
def spirit_level(b: Builder) -> None:
    """A bar with bubbles in green tubes."""
    d, w, h = b.size
    look = b.material("body", "yellow plastic", "red plastic", "aluminium", "orange plastic")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), look, 0.002)
    for s in (-1, 1):
        b.box(
            (-d / 2 - 0.0005, d / 2 + 0.0005),
            (s * (w / 2 - 0.008) - 0.008, s * (w / 2 - 0.008) + 0.0085),
            (-0.0003, h + 0.0004),
            "black plastic",
            0.002,
        )
        with b.frame(0, s * 0.3 * w, h):
            spot(b, 0.34 * d, (-0.01, 0.0004), "green apple", 18)
            spot(b, 0.08 * d, (-0.01, 0.00045), "chalk pigment", 10)
    decal(b, (-0.2 * d, 0.2 * d), (-0.06 * w, 0.06 * w), (h - 0.01, h + 0.0003), "green apple")
    for y in (-0.02, 0.02):
        decal(b, (-0.2 * d, 0.2 * d), (y * w - 0.001, y * w + 0.001), (h - 0.01, h + 0.0004), "ink pigment")
    for y in (-0.18, 0.18):
        decal(b, (-0.3 * d, 0.3 * d), (y * w - 0.03 * w, y * w + 0.03 * w), (h - 0.01, h + 0.0003), "ink pigment")


@small("dustpan")
def dustpan(b: Builder) -> None:
    """A dustpan with a hand brush in it."""
    d, w, h = b.size
    look = b.material("body", "blue plastic", "red plastic", "grey plastic", "green plastic", "mint plastic")
    x0 = -0.1 * d
    b.hull(
        [
            (x, y * w, z)
            for x, y, z in (
                (x0, 0.42, 0.0),
                (x0, -0.42, 0.0),
                (d / 2, 0.5, 0.0),
                (d / 2, -0.5, 0.0),
                (x0, 0.42, 0.006),
                (x0, -0.42, 0.006),
                (d / 2, 0.5, 0.002),
                (d / 2, -0.5, 0.002),
            )
        ],
        look,
    )
    for s in (-1, 1):
        b.hull(
            [
                (x, s * y * w, z)
                for x, y, z in (
                    (x0, 0.42, 0.0),
                    (x0, 0.405, 0.0),
                    (d / 2, 0.5, 0.0),
                    (d / 2, 0.485, 0.0),
                    (x0, 0.42, 0.5 * h),
                    (x0, 0.405, 0.5 * h),
                    (d / 2, 0.5, 0.01),
                    (d / 2, 0.485, 0.01),
                )
            ],
            look,
        )
    b.box((x0 - 0.004, x0), (-0.42 * w, 0.42 * w), (0.0, 0.55 * h), look, 0.001)
    b.cushion((-d / 2, x0), (-0.016, 0.016), (0.22 * h, 0.5 * h), look, radius=0.01)
    b.hull([(px * d, py * w, z * h) for px in (0.02, 0.16) for py in (-0.36, 0.3) for z in (0.52, 0.66)], look)
    b.hull(
        [
            (px * d, py * w, z)
            for px, py, z in (
                (0.0, -0.36, 0.008),
                (0.2, -0.36, 0.008),
                (0.0, 0.3, 0.008),
                (0.2, 0.3, 0.008),
                (0.03, -0.34, 0.53 * h),
                (0.15, -0.34, 0.53 * h),
                (0.03, 0.28, 0.53 * h),
                (0.15, 0.28, 0.53 * h),
            )
        ],
        "charcoal fabric",
    )
    with b.frame(0.08 * d, -0.3 * w, 0.6 * h, yaw=2.7, pitch=-0.1):
        b.cushion((0.0, 0.5 * d), (-0.014, 0.014), (0.0, 0.3 * h), look, radius=0.01)
    b.box((-0.48 * d, -0.44 * d), (-0.016, 0.016), (0.0, 0.3 * h), look, 0.003)


@small("hand_plane")
def hand_plane(b: Builder) -> None:
    """A hand plane: sole, body, knob, blade and rear grip."""
    d, w, h = b.size
    wood = b.material("body", "beech", "walnut", "cherry", "oak")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.08 * h), "brushed steel", 0.002)
    b.box((-0.48 * d, 0.48 * d), (-0.44 * w, 0.44 * w), (0.08 * h, 0.4 * h), wood, 0.004)
    with b.frame(0.34 * d, 0, 0.4 * h):
        b.lathe([(0.016, -0.01), (0.012, 0.1 * h), (0.022, 0.26 * h), (0.018, 0.34 * h), (0.006, 0.4 * h)], wood, 16)
    b.hull(
        [
            (x * d, y * 0.16 * w, z * h)
            for y in (-1, 1)
            for x, z in ((-0.4, 0.39), (-0.2, 0.39), (-0.24, 0.7), (-0.34, 1.0), (-0.46, 0.94), (-0.4, 0.6))
        ],
        wood,
    )
    b.hull(
        [
            (x * d, y * 0.3 * w, z * h)
            for y in (-1, 1)
            for x, z in ((0.04, 0.3), (0.07, 0.32), (-0.16, 0.84), (-0.19, 0.82))
        ],
        "steel",
    )
    with b.frame(-0.06 * d, 0, 0.5 * h, roll=np.pi / 2):
        b.frustum(0.06 * h, 0.06 * h, (-0.36 * w, 0.36 * w), "brass", 12)


@small("small_parts_box")
def small_parts_box(b: Builder) -> None:
    """A flat case with compartments of screws and nails under a clear lid."""
    d, w, h = b.size
    look = b.material("body", "blue plastic", "red plastic", "black plastic", "grey plastic", "yellow plastic")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.8 * h), look, 0.012, 0.003)
    slab(
        b, (-d / 2 + 0.003, d / 2 - 0.003), (-w / 2 + 0.003, w / 2 - 0.003), (0.79 * h, h), "clear plastic", 0.01, 0.003
    )
    fill = ("steel", "brass", "iron", "copper", "grey plastic", "red plastic")
    for i in range(3):
        for j in range(5):
            x, y = (-0.42 + 0.28 * i) * d, (-0.45 + 0.18 * j) * w
            decal(b, (x, x + 0.26 * d), (y, y + 0.165 * w), (0.7 * h, 0.81 * h), "white plastic")
            for k in range(7):
                px, py = x + b.uniform(f"{i}{j}{k}x", 0.03, 0.2) * d, y + b.uniform(f"{i}{j}{k}y", 0.02, 0.13) * w
                decal(
                    b,
                    (px, px + (0.035 if k % 2 else 0.01) * d),
                    (py, py + (0.008 if k % 2 else 0.024) * w),
                    (0.8 * h, 0.86 * h + 0.0004 * k),
                    fill[(i * 5 + j) % 6],
                )
    for s in (-1, 1):
        b.box(
            (d / 2 - 0.006, d / 2 + 0.004),
            (s * 0.32 * w - 0.018, s * 0.32 * w + 0.018),
            (0.3 * h, 0.92 * h),
            look,
            0.002,
        )
