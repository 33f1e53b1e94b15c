"""What stands on a kitchen counter: pots and pans, kettles, small machines, boards, jars."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ...drawing import Box
from ..builder import Builder, Interval
from .small_kit import Look, arch, decal, dome, loft, lofted, orb, rect, slab, small, spot, target
from .small_tableware import dish

METALS = ("steel", "brushed steel", "black steel", "copper", "red paint", "blue paint", "iron")
SHELLS = ("steel", "black plastic", "white plastic", "red plastic", "cream paint", "brushed steel", "mint plastic")


def vessel(b: Builder, r: float, h: float, look: Look, inside: Look | None = None, low: float = 0.94) -> None:
    """The open body of a pot or pan."""
    b.lathe(
        [
            (low * r - 0.006, 0.0),
            (low * r, 0.006),
            (r, h - 0.004),
            (r + 0.003, h),
            (r - 0.002, h),
            (low * r - 0.003, 0.01),
            (0.0, 0.007),
        ],
        look,
        28,
        hollow=True,
    )
    if inside is not None:
        spot(b, low * r - 0.004, (0.007, 0.0085), inside, 28)


def lid(b: Builder, r: float, z: float, high: float, look: Look, knob: Look) -> None:
    """A domed lid with a rim and a knob, that ends at ``z + high``."""
    b.lathe(
        [
            (r + 0.003, z),
            (r + 0.003, z + 0.004),
            *[(q, p) for q, p in dome(0.97 * r, z + 0.004, z + 0.5 * high, 4, 0.12 * r)],
        ],
        look,
        28,
    )
    b.lathe(
        [
            (0.008, z + 0.48 * high),
            (0.007, z + 0.7 * high),
            (0.02, z + 0.82 * high),
            (0.018, z + 0.96 * high),
            (0.008, z + high),
        ],
        knob,
        14,
    )


@small("pot")
def pot(b: Builder) -> None:
    """A pot with a lid and two side handles."""
    d, w, h = b.size
    r = d / 2 - 0.003
    look = b.material("body", *METALS)
    cover = b.material("lid", "glass", "steel") if b.chance("other lid", 0.4) else look
    knob = b.material("knob", "black plastic", "steel", "beech")
    wall = 0.72 * h
    vessel(b, r, wall, look)
    lid(b, r, wall, h - wall, cover, knob)
    for s in (-1, 1):
        y = s * (r - 0.002)
        path = np.array(
            [
                (-0.05, y, 0.8 * wall),
                (-0.045, s * (w / 2 - 0.006), 0.83 * wall),
                (0.045, s * (w / 2 - 0.006), 0.83 * wall),
                (0.05, y, 0.8 * wall),
            ]
        )
        path[[0, 3], 1] = s * np.sqrt(max(1e-6, r * r - 0.0025)) - s * 0.004
        b.tube(path, 0.006, knob if knob is not look and b.chance("dark grips", 0.4) else look, 8)


def _long_grip(b: Builder, start: float, reach: float, z: float, look: Look, metal: Look) -> None:
    """A pan's handle along +y from the wall at ``start``, rising a little."""
    n = 10
    a = np.arange(n) * 2 * np.pi / n
    b.bar((0, start - 0.006, z), (0, start + 0.05, z + 0.012), 0.007, metal, 8)
    rings = []
    for y, wide, zz in (
        (start + 0.035, 0.009, z + 0.009),
        (start + 0.07, 0.012, z + 0.017),
        (reach - 0.05, 0.013, z + 0.03),
        (reach - 0.008, 0.012, z + 0.034),
        (reach, 0.006, z + 0.035),
    ):
        rings.append(np.c_[wide * np.cos(a), np.full(n, y), zz + 0.75 * wide * np.sin(a)][::-1])
    b.add(lofted(rings), look, [shapes.hull(np.concatenate(p)) for p in zip(rings[:-1], rings[1:], strict=True)])


@small("frying_pan")
def frying_pan(b: Builder) -> None:
    """A shallow pan with a long handle, in some two fried eggs."""
    d, w, h = b.size
    r = d / 2 - 0.003
    look = b.material("body", "black steel", "iron", "brushed steel", "copper", "red paint")
    grip = b.material("grip", "black plastic", "beech", "walnut", "brushed steel")
    with b.frame(0, -w / 2 + r + 0.003):
        wall = min(0.05, 0.62 * h)
        vessel(b, r, wall, look, "black steel", 0.8)
        _long_grip(b, r - 0.002, w - r - 0.003, 0.72 * wall, grip, "steel")
        if b.chance("eggs", 0.5):
            for k, (ex, ey) in enumerate([(0.025, 0.025), (-0.025, -0.022)]):
                with b.frame(ex, ey, 0.0085):
                    b.add(shapes.lathe([(0.045, 0.0), (0.04, 0.003), (0.0, 0.005)], 14), "icing", [])
                    b.add(
                        shapes.lathe([(0.017, 0.003), (0.013, 0.009), (0.0, 0.012)], 12),
                        "banana peel" if k else "cheese",
                        [],
                    )


@small("saucepan")
def saucepan(b: Builder) -> None:
    """A deep pan with a long handle and a lid."""
    d, w, h = b.size
    r = d / 2 - 0.003
    look = b.material("body", "steel", "brushed steel", "copper", "white steel", "blue paint")
    grip = b.material("grip", "black plastic", "steel", "beech")
    with b.frame(0, -w / 2 + r + 0.003):
        wall = 0.74 * h
        vessel(b, r, wall, look, "brushed steel")
        lid(b, r, wall, h - wall, "glass" if b.chance("glass lid", 0.5) else look, grip)
        _long_grip(b, r - 0.002, w - r - 0.003, 0.66 * wall, grip, "steel")


@small("kettle")
def kettle(b: Builder) -> None:
    """An electric kettle on its base, or one for the hob with a bow handle."""
    d, w, h = b.size
    r = d / 2
    look = b.material("body", *SHELLS)
    dark = b.material("grip", "black plastic", "walnut", "grey plastic")
    with b.frame(0, -w / 2 + r + 0.35 * (w - d)):
        if b.chance("electric", 0.6):
            b.frustum(r, 0.97 * r, (0.0, 0.022), dark, 28, bevel=0.003)
            top = 0.86 * h
            b.lathe([(0.92 * r, 0.022), (0.95 * r, 0.05), (0.86 * r, 0.45 * h), (0.68 * r, top)], look, 28)
            b.lathe([(0.68 * r, top), *dome(0.62 * r, top + 0.01, 0.93 * h, 3, 0.1 * r)], dark, 24)
            orb(b, (0.14 * r, 0.14 * r, 0.035 * h), (0, 0, 0.955 * h), dark)
            b.hull(
                [(sx * 0.3 * r, 0.5 * r, 0.8 * h - 0.06) for sx in (-1, 1)]
                + [(sx * 0.24 * r, 0.5 * r, top) for sx in (-1, 1)]
                + [(sx * 0.06 * r, w - r - 0.62 * (w - d) - 0.3 * r + 0.1 * r, top - 0.004) for sx in (-1, 1)]
                + [(0, 0.8 * r, 0.72 * h)],
                look,
            )
            n = np.array([[-0.011, -0.006], [0.011, -0.006], [0.011, 0.006], [-0.011, 0.006]])
            out = -(0.65 * (w - d)) - 0.0
            path = [
                (0, -0.6 * r, 0.9 * h),
                (0, -r + 0.6 * out, 0.92 * h),
                (0, -r + out + 0.006, 0.84 * h),
                (0, -r + out + 0.01, 0.35 * h),
                (0, -0.85 * r, 0.22 * h),
            ]
            b.tube(path, n, dark)
            decal(b, (0.7 * r, 0.93 * r), (-0.004, 0.004), (0.16 * h, 0.19 * h), "screen")
        else:
            top = 0.62 * h
            b.lathe(
                [(0.9 * r, 0.0), (r, 0.03 * h), (0.98 * r, 0.16 * h), (0.72 * r, 0.45 * h), (0.42 * r, 0.57 * h)],
                look,
                28,
            )
            b.lathe([(0.44 * r, 0.57 * h), (0.42 * r, 0.6 * h), (0.1 * r, top)], look, 20)
            orb(b, (0.15 * r, 0.15 * r, 0.04 * h), (0, 0, top + 0.03 * h), dark)
            b.bar((0, 0.7 * r, 0.2 * h), (0, r + 0.6 * (w - d), 0.5 * h), 0.17 * r, look, 12)
            arch(b, (0, -0.82 * r, 0.36 * h), (0, 0.82 * r, 0.36 * h), (0, 0, 0.6 * h), 0.006, "steel", 10)
            b.tube(
                [
                    (0, 0.4 * r * np.cos(t) * 1.1, 0.36 * h + 0.6 * h * np.sin(np.arccos(0.536 * np.cos(t))))
                    for t in np.linspace(0, np.pi, 6)
                ],
                0.011,
                dark,
                8,
            )


@small("toaster")
def toaster(b: Builder) -> None:
    """Two slots with toast, a lever and a dial."""
    d, w, h = b.size
    look = b.material("body", *SHELLS)
    dark = b.material("trim", "black plastic", "grey plastic")
    x, y = (-d / 2, d / 2), (-w / 2 + 0.012, w / 2 - 0.02)
    slab(b, (x[0] + 0.008, x[1] - 0.008), (y[0] - 0.004, y[1] + 0.004), (0.0, 0.02), dark, 0.02)
    body = 0.86 * h
    rings = [
        rect((x[0] + e, x[1] - e), (y[0] + e, y[1] - e), z, rr, 4)
        for e, z, rr in (
            (0.004, 0.015, 0.03),
            (0.0, 0.022, 0.034),
            (0.0, body - 0.02, 0.034),
            (0.006, body - 0.006, 0.03),
            (0.02, body, 0.02),
        )
    ]
    loft(b, rings, look, convex=True)
    for s in (-1, 1):
        xm = s * 0.2 * d
        decal(b, (xm - 0.016, xm + 0.016), (y[0] + 0.04, y[1] - 0.04), (body - 0.01, body + 0.0003), "black steel")
        if b.chance("toast", 0.6):
            slab_y = (y[0] + 0.06, y[1] - 0.06)
            b.box((xm - 0.007, xm + 0.007), slab_y, (body - 0.01, h), "bread crust", 0.004)
    ym = y[1]
    b.box((-0.006, 0.006), (ym - 0.005, ym + 0.012), (0.6 * body, 0.6 * body + 0.01), "steel", 0.001)
    b.box((-0.016, 0.016), (ym + 0.008, w / 2), (0.57 * body, 0.7 * body), dark, 0.004)
    with b.frame(0.25 * d, ym - 0.002, 0.3 * body, roll=-np.pi / 2):
        b.frustum(0.014, 0.012, (0.0, 0.012), dark, 14, bevel=0.002)


@small("coffee_maker")
def coffee_maker(b: Builder) -> None:
    """A filter machine with a glass pot, or an espresso machine with a portafilter."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "steel", "white plastic", "red plastic", "brushed steel")
    dark = b.material("trim", "black plastic", "grey plastic")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    if b.chance("filter", 0.5):
        slab(b, x, y, (0.0, 0.035), look, 0.03, 0.004)
        slab(b, (x[0], x[0] + 0.34 * d), y, (0.03, h - 0.01), look, 0.025, 0.004)
        slab(b, (x[0], x[1] - 0.03 * d), y, (0.7 * h, h), look, 0.03, 0.006)
        r = min(0.3 * d, 0.42 * w)
        with b.frame(x[1] - r - 0.012, 0, 0.035):
            spot(b, 0.9 * r, (-0.004, 0.0003), "black steel", 24)
            jug = 0.7 * h - 0.05
            b.lathe([(0.82 * r, 0.0), (r, 0.25 * jug), (0.92 * r, 0.6 * jug), (0.62 * r, 0.86 * jug)], "glass", 24)
            b.add(
                shapes.lathe([(0.78 * r, 0.004), (0.96 * r, 0.25 * jug), (0.93 * r, 0.5 * jug), (0.0, 0.5 * jug)], 24),
                "coffee",
                [],
            )
            b.frustum(0.66 * r, 0.6 * r, (0.84 * jug, jug), dark, 24)
            arch(b, (0.6 * r, 0, 0.92 * jug), (0.9 * r, 0, 0.3 * jug), (0.55 * r, 0, 0), 0.007, dark, 6)
        decal(b, (x[1] - 0.05 * d, x[1] - 0.03 * d + 0.0003), (-0.035, 0.035), (0.82 * h, 0.9 * h), "screen")
    else:
        slab(b, x, y, (0.0, 0.06), look, 0.012, 0.004)
        decal(b, (x[0] + 0.48 * d, x[1] - 0.012), (y[0] + 0.015, y[1] - 0.015), (0.05, 0.0603), "black steel")
        slab(b, (x[0], x[0] + 0.45 * d), y, (0.055, h - 0.03), look, 0.012, 0.004)
        slab(b, (x[0], x[1] - 0.06 * d), y, (0.66 * h, h - 0.03), look, 0.012, 0.005)
        for k in range(2):
            with b.frame(x[0] + 0.25 * d, (k - 0.5) * 0.45 * w, h - 0.035):
                b.lathe([(0.03, 0.0), (0.034, 0.03), (0.036, 0.035)], "white ceramic", 16)
        group = x[1] - 0.3 * d
        with b.frame(group, 0, 0):
            b.frustum(0.032, 0.032, (0.58 * h, 0.67 * h), "steel", 20)
            b.frustum(0.028, 0.036, (0.5 * h, 0.58 * h), "chrome", 20, bevel=0.003)
            b.bar((0.03, 0, 0.545 * h), (x[1] - group - 0.012, 0, 0.52 * h), 0.011, dark, 10)
            b.frustum(0.028, 0.036, (0.06, 0.06 + 0.06), "white ceramic", 20)
            spot(b, 0.031, (0.11, 0.1203), "coffee", 16)
        for k in (-1, 1):
            with b.frame(x[1] - 0.06 * d, k * 0.32 * w, 0.8 * h, pitch=np.pi / 2):
                b.frustum(0.016, 0.014, (0.0, 0.018), "chrome", 14, bevel=0.003)
        with b.frame(x[1] - 0.06 * d, 0, 0.8 * h, pitch=np.pi / 2):
            b.frustum(0.02, 0.02, (0.0, 0.004), "chrome", 16)
            spot(b, 0.017, (0.002, 0.0043), "paper")


@small("blender", fit="round")
def blender(b: Builder) -> None:
    """A jug with a lid on a motor base."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", *SHELLS)
    foot = 0.34 * h
    loft(
        b,
        [rect((-e * r, e * r), (-e * r, e * r), z, 0.4 * r, 4) for e, z in ((1.0, 0.0), (1.0, 0.02), (0.7, foot))],
        look,
        convex=True,
    )
    with b.frame(0.88 * r, 0, 0.13 * h, pitch=np.pi / 2 - 0.2):
        b.frustum(0.24 * r, 0.22 * r, (-0.01, 0.008), "chrome", 16, bevel=0.002)
    b.frustum(0.62 * r, 0.66 * r, (foot, foot + 0.03), "black plastic", 24)
    jug, top = foot + 0.03, 0.9 * h
    b.lathe(
        [(0.6 * r, jug), (0.82 * r, top), (0.79 * r, top), (0.57 * r, jug + 0.006), (0.0, jug + 0.005)],
        "glass",
        24,
        hollow=True,
    )
    if b.chance("full", 0.6):
        drink = b.pick("drink", ["tomato", "lettuce", "pink icing", "orange peel"])
        b.add(shapes.frustum(0.56 * r, 0.69 * r, (jug + 0.007, jug + 0.55 * (top - jug)), 24), drink, [])
    b.frustum(0.85 * r, 0.82 * r, (top, top + 0.05 * h), "black plastic", 24, bevel=0.003)
    b.frustum(0.34 * r, 0.3 * r, (top + 0.05 * h, h), "black plastic", 16, bevel=0.003)
    n = np.array([[-0.009, -0.005], [0.009, -0.005], [0.009, 0.005], [-0.009, 0.005]])
    arch(b, (0, -0.78 * r, 0.86 * h), (0, -0.66 * r, jug + 0.06), (0, -0.42 * r, 0), n, "black plastic", 5)


@small("stand_mixer")
def stand_mixer(b: Builder) -> None:
    """A mixer with a long head over a steel bowl."""
    d, w, h = b.size
    look = b.material("body", "red paint", "cream paint", "black paint", "white paint", "mint plastic", "grey paint")
    # Its head points to -y: seen from the front in profile, like on a shop's picture.
    y0, y1 = -w / 2, w / 2
    slab(b, (-0.5 * d, 0.5 * d), (y0, y1), (0.0, 0.035), look, 0.09, 0.008, 5)
    loft(
        b,
        [
            rect((-e, e), (y1 - s, y1 - 0.01), z, 0.04, 3)
            for e, s, z in ((0.3 * d, 0.42 * w, 0.03), (0.2 * d, 0.27 * w, 0.2 * h), (0.2 * d, 0.27 * w, 0.66 * h))
        ],
        look,
    )
    n, rings = 16, []
    a = np.arange(n) * 2 * np.pi / n
    zc, zr = 0.8 * h, 0.2 * h
    for t, s in ((0.0, 0.45), (0.04, 0.75), (0.15, 0.95), (0.4, 1.0), (0.75, 0.93), (0.92, 0.75), (1.0, 0.5)):
        y = y1 - t * (w - 0.02)
        rings.append(np.c_[0.42 * d * s * np.cos(a), np.full(n, y), zc + zr * s * np.sin(a)])
    b.add(lofted(rings), look, [shapes.hull(np.concatenate(rings))])
    yb = y0 + 0.33 * w
    hub = zc - zr * 0.95
    r = min(0.46 * d, 0.3 * w)
    with b.frame(0, yb, 0):
        b.frustum(0.04, 0.03, (hub - 0.03, hub + 0.02), "chrome", 16)
        b.lathe(
            [
                (0.5 * r, 0.035),
                (0.5 * r, 0.045),
                (0.8 * r, 0.1 * h + 0.035),
                (r, 0.34 * h),
                (1.0 * r, 0.46 * h),
                (0.985 * r, 0.46 * h),
                (0.97 * r, 0.34 * h),
                (0.75 * r, 0.1 * h + 0.04),
                (0.0, 0.055),
            ],
            "steel",
            28,
            hollow=True,
        )
        b.bar((0, 0, 0.4 * h), (0, 0, hub - 0.02), 0.006, "chrome", 8)
    with b.frame(0.39 * d, y0 + 0.45 * w, zc, pitch=np.pi / 2):
        b.frustum(0.018, 0.018, (0.0, 0.02), "chrome", 14, bevel=0.003)


@small("food_scale")
def food_scale(b: Builder) -> None:
    """A flat scale with a weighing plate and a display."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "black plastic", "brushed steel", "mint plastic")
    plate = b.material("plate", "glass", "brushed steel", "black glass")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.7 * h), look, 0.015, 0.003)
    r = min(0.46 * w, 0.37 * d)
    with b.frame(-d / 2 + r + 0.008):
        b.frustum(0.3 * r, 0.3 * r, (0.7 * h, 0.85 * h), look, 20)
        b.frustum(r, r, (0.82 * h, h), plate, 32, bevel=0.001)
    decal(b, (d / 2 - 0.035, d / 2 - 0.012), (-0.03, 0.03), (0.5 * h, 0.7 * h + 0.0004), "screen")
    for s in (-1, 1):
        with b.frame(d / 2 - 0.024, s * 0.052):
            spot(b, 0.007, (0.5 * h, 0.7 * h + 0.0004), "grey plastic", 12)


@small("cutting_board", fit="box")
def cutting_board(b: Builder) -> None:
    """A board with a grip hole, in some a knife and slices of a vegetable on it."""
    d, w, h = b.size
    wood = b.material("body", "beech", "oak", "walnut", "bamboo", "marble")
    t = h if not b.chance("busy", 0.6) else min(h, 0.022)
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, t), wood, 0.02, 0.003, 4)
    slot = (w / 2 - 0.035, w / 2 - 0.018)
    b.add(shapes.box((-0.04, 0.04), slot, (0.002, t + 0.0003), 0.0), "wenge", [])
    for s in (-1, 1):
        decal(
            b,
            (s * (d / 2 - 0.012) - 0.002, s * (d / 2 - 0.012) + 0.002),
            (-w / 2 + 0.012, w / 2 - 0.05),
            (t / 2, t + 0.0003),
            "wenge",
        )
    if t < h:
        food = b.pick("food", ["carrot", "tomato", "lettuce"])
        r = (h - t) / 2
        if food == "carrot":
            with b.frame(-0.02, -0.3 * w, t + r, pitch=np.pi / 2, yaw=0.3):
                b.frustum(r, 0.35 * r, (-0.02, 0.09), food, 12, bevel=0.003)
        else:
            orb(b, (r, r, r), (-0.02, -0.25 * w, t + r), food, 12)
        for k in range(4):
            with b.frame(-0.05 + 0.006 * k, -0.1 * w + 0.03 * k, t + 0.0):
                b.frustum(0.9 * r, 0.9 * r, (0.0, 0.005), food, 14, bevel=0.001)
        _chef(b, 0.28 * d, -0.3 * w, t, 0.6 * w)


def _chef(b: Builder, x: float, y: float, z: float, length: float) -> None:
    with b.frame(x, y, z, yaw=np.pi / 2 - 0.15):
        b.box((0.0, 0.38 * length), (-0.011, 0.011), (0.0, 0.014), "black plastic", 0.004)
        b.hull(
            [
                (px * length, py, pz)
                for px, py in ((0.38, -0.013), (0.6, -0.019), (0.85, -0.014), (1.0, 0.008), (0.38, 0.012))
                for pz in (0.005, 0.007)
            ],
            "steel",
        )


@small("knife_block")
def knife_block(b: Builder) -> None:
    """A leaning block with the handles of five to seven knives."""
    d, w, h = b.size
    wood = b.material("body", "beech", "oak", "walnut", "black paint", "bamboo")
    grip = b.material("grips", "black plastic", "steel", "walnut")
    # Side outline of the block in x and z: it leans back, its face with the slots looks to the front and up.
    side = [(-0.5, 0.0), (0.28, 0.0), (0.32, 0.34), (-0.12, 0.8), (-0.5, 0.62)]
    b.hull([(px * d, s * (w / 2), pz * h) for px, pz in side for s in (-1, 1)], wood)
    along = np.array([0.32 * d + 0.12 * d, 0.34 * h - 0.8 * h])
    norm = np.array([-along[1], along[0]]) / np.linalg.norm(along)
    for row, share in enumerate((0.22, 0.55, 0.85)):
        count = 2 if row < 2 else 3
        for k in range(count):
            y = (k - (count - 1) / 2) * w / count * 0.9
            at = np.array([-0.12 * d, 0.8 * h]) + along * share
            long = (0.11, 0.095, 0.075)[row] * h / 0.22
            thick = 0.009 if row < 2 else 0.006
            pitch = float(np.arctan2(norm[0], norm[1]))
            with b.frame(float(at[0]), y, float(at[1]), pitch=pitch):
                b.box((-0.4 * w / count * 0.5, 0.4 * w / count * 0.5), (-thick, thick), (-0.01, 0.012), "steel", 0.002)
                b.box((-0.011, 0.011), (-thick, thick), (0.012, long), grip, 0.004)


@small("utensil_holder", fit="round")
def utensil_holder(b: Builder) -> None:
    """A crock with wooden spoons, a ladle, a spatula and a whisk."""
    d, _, h = target(b)
    r = 0.4 * d
    look = b.material("body", "white ceramic", "cream ceramic", "grey ceramic", "steel", "copper", "blue ceramic")
    wood = b.material("spoons", "beech", "walnut", "bamboo")
    pot_high = 0.48 * h
    b.lathe(
        [
            (0.92 * r, 0.0),
            (r, 0.01),
            (r, pot_high - 0.012),
            (1.05 * r, pot_high - 0.008),
            (1.05 * r, pot_high),
            (0.97 * r, pot_high),
            (0.92 * r, 0.012),
            (0.0, 0.01),
        ],
        look,
        24,
        hollow=True,
    )
    kinds = ["spoon", "spatula", "whisk", "ladle", "spoon"]
    for k, kind in enumerate(kinds):
        a = 2 * np.pi * k / len(kinds) + b.uniform("turn", 0, 1.2)
        tip = 0.34 * d
        long = h - 0.012 - 0.05 * h * (k % 3)
        with b.frame(
            -0.55 * r * np.cos(a),
            -0.55 * r * np.sin(a),
            0.012,
            yaw=a,
            pitch=float(np.arctan2(0.22 * d + tip, long)) * 0.8,
        ):
            head = 0.2 * h
            metal = kind in ("whisk", "ladle")
            b.bar((0, 0, 0.1 * h), (0, 0, long - head), 0.0045, "steel" if metal else wood, 8)
            top = long - 0.004
            if kind == "spatula":
                b.hull(
                    [
                        (x, y, z)
                        for z, wy in ((long - head, 0.012), (long - head + 0.02, 0.026), (top, 0.028))
                        for y in (-wy, wy)
                        for x in (-0.003, 0.003)
                    ],
                    "black plastic" if k % 2 else wood,
                )
            elif kind == "whisk":
                for turn in range(3):
                    with b.frame(yaw=turn * np.pi / 3):
                        t = np.linspace(0, np.pi, 8)
                        b.tube(
                            np.c_[
                                0 * t, 0.028 * np.cos(t) * np.sin(t) ** 0.5, long - head + (head - 0.006) * np.sin(t)
                            ],
                            0.0013,
                            "steel",
                            5,
                        )
            else:
                rz, ry = 0.42 * head, 0.022
                orb(b, (0.007 if kind == "spoon" else 0.018, ry, rz), (0, 0, top - rz), "steel" if metal else wood, 12)


@small("colander")
def colander(b: Builder) -> None:
    """A bowl with holes, two ears, and a foot ring."""
    d, w, h = b.size
    r = d / 2 - 0.003
    look = b.material("body", "steel", "white steel", "red paint", "mint plastic", "brushed steel", "cream paint")
    b.lathe(
        [
            (0.5 * r, 0.0),
            (0.5 * r, 0.1 * h),
            (0.72 * r, 0.26 * h),
            (0.9 * r, 0.55 * h),
            (0.98 * r, 0.9 * h),
            (1.02 * r, 0.97 * h),
            (1.02 * r, h),
            (0.96 * r, h),
            (0.87 * r, 0.55 * h),
            (0.68 * r, 0.28 * h),
            (0.0, 0.14 * h),
        ],
        look,
        28,
        hollow=True,
    )
    for row in range(4):
        s = 0.3 + 0.14 * row
        rr = np.interp(s, [0.26, 0.55, 0.9], [0.72, 0.9, 0.98]) * r
        count = 20
        tilt = np.arctan2(*((0.18 * r, 0.29 * h) if s < 0.55 else (0.08 * r, 0.35 * h)))
        for k in range(count):
            a = 2 * np.pi * (k + 0.5 * (row % 2)) / count
            with b.frame(rr * np.cos(a), rr * np.sin(a), s * h, yaw=a, pitch=np.pi / 2 + tilt):
                b.add(shapes.frustum(0.0036, 0.0036, (-0.004, 0.0), 6), "black steel", [])
    for s in (-1, 1):
        arch(
            b,
            (-0.05, s * 0.86 * r, 0.95 * h),
            (0.05, s * 0.86 * r, 0.95 * h),
            (0, s * (w / 2 - 0.86 * r), 0),
            0.005,
            look,
            6,
        )


@small("baking_tray")
def baking_tray(b: Builder) -> None:
    """A flat tray with a rim, and in some of them biscuits or buns."""
    d, w, h = b.size
    look = b.material("body", "black steel", "brushed steel", "iron", "aluminium")
    rim = min(h, 0.025)
    rings = [
        rect((-d / 2 + e, d / 2 - e), (-w / 2 + e, w / 2 - e), z, 0.02, 3)
        for e, z in ((0.014, 0.0), (0.003, rim - 0.002), (0.0, rim), (0.004, rim), (0.016, 0.002))
    ]
    loft(b, rings, look, hollow=2)
    bun = b.chance("buns", 0.5)
    for i in range(3):
        for j in range(4):
            px, py = (i - 1) * 0.27 * d, (j - 1.5) * 0.2 * w
            with b.frame(px + 0.01 * ((i + j) % 2), py, 0.002):
                if bun:
                    b.lathe(
                        [(0.03, 0.0), (0.036, 0.012), (0.03, max(0.018, 0.72 * h)), (0.012, h - 0.002)],
                        "bread crust",
                        14,
                    )
                else:
                    b.frustum(
                        0.03, 0.026, (0.0, h - 0.002), "cake sponge" if (i + j) % 3 else "chocolate", 14, bevel=0.003
                    )


@small("rice_cooker", fit="round")
def rice_cooker(b: Builder) -> None:
    """A round cooker with a glass lid or a hinged one, a switch, and two ears."""
    d, _, h = target(b)
    r = 0.44 * d
    look = b.material("body", "white plastic", "steel", "cream paint", "red paint", "black plastic")
    dark = b.material("trim", "black plastic", "grey plastic")
    b.lathe([(0.86 * r, 0.0), (0.9 * r, 0.02), (r, 0.3 * h), (r, 0.6 * h), (0.97 * r, 0.68 * h)], look, 28)
    b.frustum(1.02 * r, 1.02 * r, (0.68 * h, 0.71 * h), "steel", 28)
    b.lathe(dome(0.98 * r, 0.71 * h, 0.9 * h, 5, 0.1 * r), "glass" if b.chance("glass", 0.5) else look, 28)
    b.lathe([(0.012, 0.89 * h), (0.011, 0.93 * h), (0.022, 0.96 * h), (0.018, h)], dark, 14)
    slab(b, (0.85 * r, r + 0.012), (-0.3 * r, 0.3 * r), (0.12 * h, 0.42 * h), dark, 0.006, 0.003)
    b.box((r + 0.01, r + 0.02), (-0.012, 0.012), (0.17 * h, 0.21 * h), "white plastic", 0.002)
    decal(b, (r, r + 0.0123), (-0.01, 0.01), (0.33 * h, 0.36 * h), "orange plastic")
    for s in (-1, 1):
        b.box(
            (-0.035, 0.035),
            (s * d / 2 - (0.08 * d if s > 0 else 0), s * d / 2 + (0.08 * d if s < 0 else 0)),
            (0.53 * h, 0.59 * h),
            dark,
            0.005,
        )
    b.box((-d / 2, -0.9 * r), (-0.02, 0.02), (0.1 * h, 0.3 * h), dark, 0.004)


@small("air_fryer")
def air_fryer(b: Builder) -> None:
    """An egg-shaped fryer with a basket drawer, its handle, and a display."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "white plastic", "grey plastic", "cream paint", "mint plastic")
    dark = b.material("drawer", "black plastic", "black steel")
    x1 = d / 2 - 0.07
    cuts = [(0.86, 0.0), (0.95, 0.02), (1.0, 0.35), (0.97, 0.65), (0.82, 0.88), (0.62, 0.96), (0.45, 1.0)]
    mx, hx = (-d / 2 + x1) / 2, (x1 + d / 2) / 2
    rings = [rect((mx - hx * e, mx + hx * e), (-w / 2 * e, w / 2 * e), z * h, 0.4 * w * e, 5) for e, z in cuts]
    loft(b, rings, look, convex=True)
    wide = 0.62 * w
    slab(b, (0.0, x1 + 0.004), (-wide / 2, wide / 2), (0.1 * h, 0.5 * h), dark, 0.02, 0.004)
    slab(b, (x1 - 0.01, d / 2), (-0.022, 0.022), (0.3 * h, 0.4 * h), dark, 0.018, 0.006)
    decal(b, (d / 2 - 0.034, d / 2 - 0.016), (-0.009, 0.009), (0.39 * h, 0.4 * h + 0.0003), "chrome")
    with b.frame(mx + 0.93 * hx, 0, 0.66 * h, pitch=-0.35):
        b.box((-0.02, 0.006), (-0.22 * w, 0.22 * w), (-0.06 * h, 0.11 * h), "black glass", 0.004)
        for k in range(3):
            decal(b, (0.0, 0.0063), (-0.03 + 0.024 * k, -0.018 + 0.024 * k), (0.02 * h, 0.06 * h), "lamp glow")


@small("paper_towel_roll", fit="round")
def paper_towel_roll(b: Builder) -> None:
    """A roll of paper towels on an upright holder."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("holder", "steel", "oak", "black steel", "bamboo", "walnut")
    b.frustum(r, r, (0.0, 0.014), look, 28, bevel=0.003)
    b.frustum(0.78 * r, 0.78 * r, (0.014, 0.86 * h), "paper", 28, bevel=0.001)
    b.frustum(0.26 * r, 0.26 * r, (0.8 * h, 0.86 * h + 0.002), "cardboard", 16)
    # The end of the paper hangs off the roll.
    b.box((0.7 * r, 0.79 * r), (-0.3 * r, 0.35 * r), (0.02, 0.86 * h - 0.001), "paper", 0.001)
    b.frustum(0.006, 0.006, (0.86 * h, 0.97 * h), look, 10)
    orb(b, (0.014, 0.014, 0.03 * h), (0, 0, 0.97 * h), look)


@small("dish_rack")
def dish_rack(b: Builder) -> None:
    """A rack of wire with plates upright in it, a mug, and a tray for drops."""
    d, w, h = b.size
    wire = b.material("wire", "chrome", "white steel", "black steel")
    tray = b.material("tray", "white plastic", "grey plastic", "black plastic", "bamboo")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.018), tray, 0.02, 0.004)
    x0, x1, y0, y1 = -d / 2 + 0.012, d / 2 - 0.012, -w / 2 + 0.012, w / 2 - 0.012
    rail = 0.42 * h
    for z in (0.035, rail):
        for a, c in (((x0, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0))):
            b.bar((*a, z), (*c, z), 0.0028, wire, 6)
    for px, py in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), ((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1)):
        b.bar((px, py, 0.012), (px, py, rail), 0.0028, wire, 6)
    glaze = b.material("plates", "white ceramic", "blue ceramic", "cream ceramic")
    count = 6
    r = min((h - 0.03) / 2, 0.42 * d)
    for k in range(count):
        y = y0 + 0.05 + k * 0.5 * w / count
        b.bar((x0, y - 0.012, 0.035), (x1, y - 0.012, 0.035), 0.002, wire, 5)
        if k % 3 != 2:
            rr = r if k < 4 else 0.75 * r
            with b.frame(-0.01, y, 0.033 + rr, roll=np.pi / 2 - 0.08):
                dish(b, Box.sized(2 * rr, 2 * rr, 0.02), glaze)
    rm = min(0.04, 0.12 * w)
    for k, mug in enumerate(("red paint", "sage paint")):
        with b.frame((0.5 - k) * 0.45 * d, y1 - 0.09, 0.037):
            b.frustum(
                rm,
                0.9 * rm,
                (0.0, 0.085),
                b.material(f"cup {k}", "white ceramic", "blue ceramic", "terracotta", mug),
                20,
                bevel=0.003,
            )
            arch(
                b,
                (0, -0.93 * rm, 0.07),
                (0, -0.95 * rm, 0.015),
                (0, -0.025, 0),
                0.004,
                b.material(f"cup {k}", "white ceramic"),
                5,
            )


def loft_label(b: Builder, d: float, w: float, z: Interval, look: Look = "paper") -> None:
    """A label in front of an oval bottle."""
    decal(b, (0.3 * d, 0.487 * d), (-0.16 * w, 0.16 * w), z, look, own=True)
    decal(
        b,
        (0.3 * d, 0.489 * d),
        (-0.12 * w, 0.12 * w),
        (z[0] + 0.4 * (z[1] - z[0]), z[0] + 0.65 * (z[1] - z[0])),
        "blue plastic",
        own=True,
    )


@small("oven_mitt")
def oven_mitt(b: Builder) -> None:
    """A quilted glove with a thumb and a cuff, lying flat."""
    d, w, h = b.size
    cloth = b.material("cloth", "red fabric", "navy fabric", "mustard fabric", "grey fabric", "green fabric")
    hem = b.material("hem", "white fabric", "charcoal fabric")
    b.cushion((-d / 2 + 0.05, d / 2), (-0.34 * w, 0.34 * w), (0.0, h), cloth, radius=0.03, puff=0.25)
    with b.frame(-0.08 * d, 0.25 * w, 0.0, yaw=0.75):
        b.cushion((-0.06, 0.1), (-0.035, 0.035), (0.002, 0.85 * h), cloth, radius=0.02, puff=0.3)
    b.cushion((-d / 2, -d / 2 + 0.07), (-0.36 * w, 0.36 * w), (0.0, 0.92 * h), hem, radius=0.012)


@small("electric_grill")
def electric_grill(b: Builder) -> None:
    """A contact grill, closed, with a big handle."""
    d, w, h = b.size
    look = b.material("body", "brushed steel", "black plastic", "steel", "red plastic")
    x, y = (-d / 2, d / 2 - 0.03), (-w / 2, w / 2)
    slab(b, x, y, (0.015, 0.42 * h), "black plastic", 0.025, 0.006)
    for px in (x[0] + 0.04, x[1] - 0.04):
        for py in (y[0] + 0.05, y[1] - 0.05):
            b.box((px - 0.012, px + 0.012), (py - 0.012, py + 0.012), (0.0, 0.02), "rubber")
    b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), (0.42 * h, 0.5 * h), "iron", 0.002)
    rings = [
        rect((x[0] + e, x[1] - e), (y[0] + e, y[1] - e), z * h, 0.025, 3)
        for e, z in ((0, 0.5), (0, 0.72), (0.02, 0.84), (0.05, 0.88))
    ]
    loft(b, rings, look, convex=True)
    for s in (-1, 1):
        b.bar((x[1] - 0.06, s * 0.3 * w, 0.8 * h), (d / 2 - 0.012, s * 0.3 * w, h - 0.012), 0.009, "black plastic", 8)
    b.bar((d / 2 - 0.013, -0.36 * w, h - 0.013), (d / 2 - 0.013, 0.36 * w, h - 0.013), 0.013, "black plastic", 12)
    decal(b, (0.0, x[1] + 0.0003), (-0.03, 0.03), (0.22 * h, 0.36 * h), "grey plastic")
    for k, c in enumerate(("red plastic", "green plastic")):
        decal(b, (0.0, x[1] + 0.0004), (-0.02 + 0.025 * k, -0.008 + 0.025 * k), (0.26 * h, 0.32 * h), c)


@small("mixing_bowl", fit="round")
def mixing_bowl(b: Builder) -> None:
    """A deep bowl with a whisk in it."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "steel", "white ceramic", "mint plastic", "cream ceramic", "glass", "red plastic")
    rim = 0.82 * h
    b.lathe(
        [
            (0.5 * r, 0.0),
            (0.55 * r, 0.03 * h),
            (0.82 * r, 0.3 * rim),
            (0.96 * r, 0.7 * rim),
            (r, rim),
            (r - 0.004, rim),
            (0.93 * r, 0.7 * rim),
            (0.78 * r, 0.3 * rim),
            (0.0, 0.05 * h),
        ],
        look,
        28,
        hollow=True,
    )
    dough = b.pick("dough", ["cake sponge", "icing", "chocolate"])
    spot(b, 0.8 * r, (0.3 * h, 0.45 * h), dough, 24)
    b.bar((-0.2 * r, 0.1 * r, 0.35 * h), (0.0, 0.88 * r, h - 0.008), 0.006, "beech", 8)
