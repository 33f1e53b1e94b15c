"""What stands in a bathroom or on a dressing table."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from .small_kit import Look, decal, ellipse, loft, orb, rect, slab, small, spot, spun, target

GLAZES = ("white ceramic", "cream ceramic", "grey ceramic", "blue ceramic", "concrete", "marble", "amber glass")
PASTELS = (
    "white plastic",
    "pink plastic",
    "mint plastic",
    "lilac plastic",
    "blue plastic",
    "clear plastic",
    "orange plastic",
)


def pump(b: Builder, z: float, h: float, reach: float, look: Look) -> None:
    """A pump head on a bottle's neck at height z, up to h, its spout to the front."""
    b.frustum(0.016, 0.016, (z, z + 0.2 * (h - z)), look, 16)
    b.frustum(0.006, 0.006, (z + 0.2 * (h - z), h - 0.012), look, 10)
    b.frustum(0.013, 0.012, (h - 0.016, h), look, 14)
    b.hull(
        [
            (x, y, zz)
            for x, y, zz in (
                (0.0, 0.006, h - 0.012),
                (0.0, -0.006, h - 0.012),
                (0.0, 0.006, h - 0.002),
                (0.0, -0.006, h - 0.002),
                (reach, 0.004, h - 0.014),
                (reach, -0.004, h - 0.014),
                (reach, 0.004, h - 0.006),
                (reach, -0.004, h - 0.006),
            )
        ],
        look,
    )


@small("soap_bar")
def soap_bar(b: Builder) -> None:
    """A bar of soap on a dish."""
    d, w, h = b.size
    dish = b.material("dish", "white ceramic", "bamboo", "grey ceramic", "oak", "concrete")
    soap = b.material("soap", "candle wax", "pink icing", "pale leaf", "lilac plastic", "sky pigment")
    loft(
        b,
        [
            rect((-d / 2 + e, d / 2 - e), (-w / 2 + e, w / 2 - e), z, 0.03, 4)
            for e, z in ((0.012, 0.0), (0.002, 0.3 * h), (0.0, 0.38 * h), (0.004, 0.38 * h), (0.012, 0.16 * h))
        ],
        dish,
        hollow=2,
    )
    b.cushion((-0.33 * d, 0.33 * d), (-0.36 * w, 0.36 * w), (0.15 * h, h), soap, radius=0.4 * h, puff=0.25)


@small("toothbrush_cup", fit="round")
def toothbrush_cup(b: Builder) -> None:
    """A cup with two toothbrushes and a tube of toothpaste."""
    d, _, h = target(b)
    r = 0.44 * d
    look = b.material("body", *GLAZES[:6], "glass", "bamboo")
    cup = 0.55 * h
    b.lathe(
        [(0.88 * r, 0.0), (0.92 * r, 0.003), (r, cup), (r - 0.003, cup), (0.86 * r, 0.008), (0.0, 0.007)],
        look,
        24,
        hollow=True,
    )
    for k in range(2):
        c = b.pick(f"brush {k}", ["blue plastic", "red plastic", "green plastic", "bamboo", "pink plastic"])
        with b.frame(-0.4 * r, (0.3 - 0.6 * k) * r, 0.008, yaw=(-0.5 + 1.0 * k), pitch=0.16 + 0.05 * k):
            long = (0.98 - 0.04 * k) * h - 0.006
            b.box((-0.003, 0.003), (-0.0045, 0.0045), (0.0, long), c, 0.0015)
            b.box((0.003, 0.012), (-0.005, 0.005), (long - 0.028, long - 0.003), "paper", 0.001)
    with b.frame(-0.1 * r, -0.1 * r, 0.012, yaw=2.6, pitch=0.14):
        tube(b, 0.8 * h, 0.3 * r, "white plastic", "blue plastic")
    b.frustum(0.05 * r, 0.05 * r, (0.004, 0.02), look, 6)


def tube(b: Builder, long: float, r: float, look: Look, cap: Look) -> None:
    """A squeezed tube up along z, its cap on top."""
    b.hull(
        np.concatenate(
            [
                [(x, y, 0.0) for x in (-0.0015, 0.0015) for y in (-1.15 * r, 1.15 * r)],
                ellipse(0.9 * r, 0.95 * r, 0.82 * long, 16),
                ellipse(0.5 * r, 0.5 * r, 0.88 * long, 16),
            ]
        ),
        look,
    )
    b.frustum(0.62 * r, 0.56 * r, (0.87 * long, long), cap, 14)


@small("toothpaste")
def toothpaste(b: Builder) -> None:
    """A lying tube of toothpaste with stripes and a cap."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "mint plastic", "blue plastic")
    cap = b.material("cap", "red plastic", "blue plastic", "green plastic", "white plastic")
    n = 16
    r = h / 2
    b.hull(
        np.concatenate(
            [
                [(-d / 2, y, z) for y in (-w / 2, w / 2) for z in (0.0, 0.002)],
                [(0.3 * d, y, z + r) for y, z, _ in ellipse(r, r, 0, n)],
                [(0.36 * d, 0.6 * y, 0.6 * z + r) for y, z, _ in ellipse(r, r, 0, n)],
            ]
        ),
        look,
    )
    with b.frame(0.34 * d, 0, r, pitch=np.pi / 2):
        b.frustum(0.75 * r, 0.66 * r, (0.0, 0.16 * d), cap, 16, bevel=0.0)
    for k, c in enumerate(("red plastic", "blue plastic")):
        x0, x1 = (-0.24 + 0.2 * k) * d, (-0.12 + 0.2 * k) * d
        rings = []
        for x in (x0, x1):
            t = (x + d / 2) / (0.8 * d)
            y, z = (1 - t) * w / 2 + t * r, (1 - t) * 0.001 + t * r
            mid = (1 - t) * 0.001 + t * r
            rings.append([(x, 0.55 * y * s, mid + zz) for s in (-1, 1) for zz in (0.0, 0.83 * z + 0.0002)])
        b.add(shapes.hull(np.concatenate(rings)), c, [])


@small("perfume")
def perfume(b: Builder) -> None:
    """A glass flacon with scent in it and a big stopper."""
    d, w, h = b.size
    glass = b.material("body", "glass")
    cap = b.material("cap", "brass", "black plastic", "chrome", "glass", "copper")
    scent = b.pick("scent", ["pink icing", "lemon peel", "amber glass", "sky pigment"])
    top = 0.64 * h
    if b.chance("round", 0.4):
        r = w / 2
        with b.frame(0, 0, top / 2, pitch=np.pi / 2):
            b.add(shapes.frustum(0.98 * top / 2, 0.98 * top / 2, (-d / 2, d / 2), 24, 0.004), glass)
            b.add(shapes.frustum(0.8 * top / 2, 0.8 * top / 2, (-d / 2 + 0.005, d / 2 - 0.005), 24), scent, [])
        slab(b, (-0.4 * d, 0.4 * d), (-0.7 * r, 0.7 * r), (0.0, 0.1 * top), glass, 0.004)
        b.box((-0.3 * d, 0.3 * d), (-w / 2, w / 2), (0.45 * top, 0.55 * top), glass, 0.003)
    else:
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, top), glass, 0.006)
        b.add(
            shapes.box((-d / 2 + 0.006, d / 2 - 0.006), (-w / 2 + 0.006, w / 2 - 0.006), (0.01, 0.8 * top), 0.002),
            scent,
            [],
        )
        decal(b, (0.3 * d, d / 2 + 0.0003), (-0.22 * w, 0.22 * w), (0.35 * top, 0.65 * top), "paper")
        decal(b, (0.3 * d, d / 2 + 0.0004), (-0.14 * w, 0.14 * w), (0.46 * top, 0.52 * top), "ink pigment")
    b.frustum(0.2 * d, 0.2 * d, (top - 0.001, top + 0.06 * h), "brass", 16)
    if b.chance("ball", 0.4):
        q = (h - top - 0.05 * h) / 2
        orb(b, (q, q, q), (0, 0, h - q), cap, 12)
    else:
        b.frustum(0.32 * d, 0.36 * d, (top + 0.06 * h, h), cap, 8 if b.chance("cut", 0.5) else 20, bevel=0.0)


@small("tissue_box")
def tissue_box(b: Builder) -> None:
    """A box of tissues, one of them sticking out."""
    d, w, h = b.size
    look = b.material(
        "body",
        "sky pigment",
        "blush pigment",
        "sage paint",
        "sand pigment",
        "oak",
        "white paint",
        "bamboo",
        "navy paint",
    )
    top = 0.58 * h
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, top), look, 0.0015)
    t = (np.arange(20) + 0.5) * np.pi / 10
    b.add(shapes.extrusion(np.c_[0.22 * d * np.cos(t), 0.33 * w * np.sin(t)], (top - 0.002, top + 0.0003)), "paper", [])
    for k in range(6):
        y = (-0.42 + 0.15 * k) * w
        with b.frame(d / 2, y, (0.3 + 0.25 * (k % 2)) * top, pitch=np.pi / 2):
            b.add(
                shapes.frustum(0.05 * w, 0.05 * w, (-0.001, 0.0003), 12),
                "chalk pigment" if look.name != "white paint" else "sky pigment",
                [],
            )
    for x, lean, s in ((-0.012, -0.25, 1.0), (0.01, 0.2, 0.8)):
        long = (h - top) * s
        b.hull(
            [(x + e, y * w, top - 0.004) for y in (-0.18, 0.2) for e in (-0.003, 0.003)]
            + [(x + lean * 0.5 * long + e, y * w, top + 0.5 * long) for y in (-0.12, 0.15) for e in (-0.006, 0.006)],
            "paper",
        )
        b.hull(
            [(x + lean * 0.5 * long + e, y * w, top + 0.5 * long) for y in (-0.12, 0.15) for e in (-0.006, 0.006)]
            + [
                (x + lean * 1.3 * long + e, y * w, top + zz * long)
                for y, zz in ((-0.16, 0.8), (0.02, 1.0), (0.17, 0.86))
                for e in (-0.001, 0.001)
            ],
            "paper",
        )


def roll_of_paper(b: Builder, r: float, z0: float, z1: float) -> None:
    """A standing toilet roll with its core of cardboard and a loose end."""
    b.lathe(
        [
            (0.98 * r, z0),
            (r, z0 + 0.003),
            (r, z1 - 0.003),
            (0.98 * r, z1),
            (0.4 * r, z1),
            (0.38 * r, z1 - 0.02),
            (0.0, z1 - 0.02),
        ],
        "paper",
        26,
        hollow=True,
    )
    b.add(
        shapes.lathe(
            [
                (0.36 * r, z1 - 0.03),
                (0.42 * r, z1 - 0.03),
                (0.42 * r, z1 + 0.0002),
                (0.36 * r, z1 + 0.0002),
                (0.36 * r, z1 - 0.03),
            ],
            20,
        ),
        "cardboard",
        [],
    )


@small("toilet_paper_roll", fit="round")
def toilet_paper_roll(b: Builder) -> None:
    """A standing roll of toilet paper."""
    d, _, h = target(b)
    b.material("body", "paper")
    roll_of_paper(b, 0.48 * d, 0.0, h)
    b.box((0.36 * d, 0.5 * d), (-0.12 * d, 0.14 * d), (0.001, h - 0.001), "paper", 0.001)


@small("toilet_paper_stack", fit="round")
def toilet_paper_stack(b: Builder) -> None:
    """Spare rolls on an upright holder with a foot."""
    d, _, h = target(b)
    metal = b.material("stand", "chrome", "black steel", "brass", "oak")
    b.frustum(d / 2, 0.48 * d, (0.0, 0.014), metal, 28, bevel=0.003)
    count = 3 if h < 0.5 else 4
    top = h - 0.05
    for k in range(count):
        z = 0.014 + k * (top - 0.014) / count
        roll_of_paper(b, 0.38 * d, z, z + (top - 0.014) / count - 0.001)
    b.frustum(0.008, 0.008, (0.01, h - 0.012), metal, 12)
    orb(b, (0.018, 0.018, 0.018), (0, 0, h - 0.018), metal, 12)


TOWELS = (
    "white fabric",
    "beige fabric",
    "grey fabric",
    "blue fabric",
    "green fabric",
    "rose fabric",
    "navy fabric",
    "mustard fabric",
)


def towel(
    b: Builder, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], cloth: Look, hem: Look
) -> None:
    """A folded towel: round layers with the fold to the front, and a woven stripe near its end."""
    layers = 2
    t = (z[1] - z[0]) / layers
    for k in range(layers):
        e = 0.004 * k
        b.cushion(
            (x[0] + e, x[1] - e),
            y,
            (z[0] + k * t, z[0] + (k + 1) * t + (0.002 if k == 0 else 0.0)),
            cloth,
            radius=0.48 * t,
            puff=0.12,
        )
    for s in (0.7, 0.78):
        px = x[0] + s * (x[1] - x[0])
        b.box((px - 0.004, px + 0.004), (y[0] + 0.012, y[1] - 0.012), (z[1] - 0.008, z[1] + 0.0008), hem, 0.001)


@small("folded_towel")
def folded_towel(b: Builder) -> None:
    """A folded towel with a woven stripe."""
    d, w, h = b.size
    towel(
        b,
        (-d / 2, d / 2),
        (-w / 2, w / 2),
        (0.0, h),
        b.material("cloth", *TOWELS),
        b.material("hem", "white fabric", "charcoal fabric", "beige fabric"),
    )


@small("towel_stack")
def towel_stack(b: Builder) -> None:
    """Folded towels on each other in matching colours."""
    d, w, h = b.size
    cloths = (b.material("cloth", *TOWELS), b.material("second", *TOWELS))
    hem = b.material("hem", "white fabric", "charcoal fabric", "beige fabric")
    count = max(2, round(h / 0.06))
    t = h / count
    for k in range(count):
        e = 0.012 * (k >= count - 1) + b.uniform(f"e{k}", 0.0, 0.006) * (k > 0)
        towel(b, (-d / 2 + e, d / 2 - e), (-w / 2 + 2 * e, w / 2 - 2 * e), (k * t, (k + 1) * t), cloths[k % 2], hem)


@small("towel_roll")
def towel_roll(b: Builder) -> None:
    """Three rolled towels, one on two, their spirals to the front."""
    d, w, h = b.size
    cloths = [b.material("cloth", *TOWELS), b.pick("second", list(TOWELS)), b.pick("third", list(TOWELS))]
    r = 0.29 * h
    for k, (y, z) in enumerate(((-w / 2 + r * 1.05, r), (w / 2 - r * 1.05, r), (0.0, h - r))):
        with b.frame(0, y, z, pitch=np.pi / 2):
            b.frustum(
                1.04 * r if k < 2 else r,
                1.04 * r if k < 2 else r,
                (-d / 2 + 0.01 * k, d / 2 - 0.01 * k),
                cloths[k],
                20,
                bevel=0.15 * r,
            )
            for s, c in (
                (0.82, "charcoal fabric"),
                (0.76, cloths[k]),
                (0.52, "charcoal fabric"),
                (0.46, cloths[k]),
                (0.22, "charcoal fabric"),
                (0.15, cloths[k]),
            ):
                b.add(shapes.frustum(s * r, s * r, (0.0, d / 2 - 0.01 * k + 0.0012 - s * 0.001), 18), c, [])
    b.box((-0.2 * d, 0.2 * d), (-w / 2 + r, w / 2 - r), (0.002, 0.25 * h), cloths[0], 0.003)


@small("hair_dryer")
def hair_dryer(b: Builder) -> None:
    """A dryer on its side's stand: barrel, nozzle, grip with a switch."""
    d, w, h = b.size
    look = b.material(
        "body", "black plastic", "white plastic", "pink plastic", "grey plastic", "red plastic", "lilac plastic"
    )
    trim = b.material("trim", "black plastic", "grey plastic", "brass")
    r = 0.46 * d
    zc = h - r - 0.002
    with b.frame(0, 0, zc, roll=np.pi / 2):
        # The frame's z axis points to -y.
        b.lathe(
            [
                (0.55 * r, -w / 2),
                (0.9 * r, -w / 2 + 0.012),
                (1.08 * r, -0.3 * w),
                (1.0 * r, 0.0),
                (0.72 * r, 0.3 * w),
                (0.72 * r, 0.36 * w),
            ],
            look,
            24,
        )
        b.frustum(0.7 * r, 0.62 * r, (0.36 * w, 0.5 * w), trim, 20)
        spot(b, 0.5 * r, (-w / 2 - 0.0003, -w / 2 + 0.01), trim, 20)
        spot(b, 0.52 * r, (0.4 * w, 0.5 * w + 0.0003), "black steel", 16)
    loft(
        b,
        [
            ellipse(0.036, 0.042, 0.0, 16, y=0.12 * w),
            ellipse(0.032, 0.034, 0.01, 16, y=0.12 * w),
            ellipse(0.015, 0.02, 0.02, 16, y=0.12 * w),
            ellipse(0.016, 0.021, 0.5 * zc, 16, y=0.12 * w),
            ellipse(0.02, 0.026, zc - 0.5 * r, 16, y=0.12 * w),
        ],
        look,
    )
    b.box((0.012, 0.019), (0.12 * w - 0.006, 0.12 * w + 0.006), (0.45 * zc, 0.62 * zc), trim, 0.002)


@small("hairbrush")
def hairbrush(b: Builder) -> None:
    """A brush with a cushion of bristles up."""
    d, w, h = b.size
    look = b.material("body", "beech", "walnut", "black plastic", "pink plastic", "bamboo")
    t = 0.45 * h
    with b.frame(-0.22 * d, 0, 0):
        spun(b, [(0.9, 0.0), (1.0, 0.25 * t), (1.0, 0.7 * t), (0.9, t)], look, 0.28 * d, w / 2, 20)
        spun(b, [(0.82, t), (0.6, 1.25 * t)], "black plastic", 0.28 * d, w / 2, 18)
        shape = shapes.lathe([(0.82, t), (0.76, h)], 14)
        part = (shape[0] * [0.28 * d, w / 2, 1.0], shape[1])
        first = True
        for i in range(-4, 5):
            for j in range(-2, 3):
                x, y = i / 4.6, j / 2.9
                if x * x + y * y < 0.52:
                    px, py = x * 0.28 * d * 0.95, y * w / 2 * 0.95
                    b.add(
                        shapes.box(
                            (px - 0.001, px + 0.001), (py - 0.001, py + 0.001), (t, h - 0.0002 * (i * i + j * j))
                        ),
                        "steel",
                        [part] if first else [],
                    )
                    first = False
    b.hull(
        [
            (x * d, s * y * w, z)
            for s in (-1, 1)
            for x, y in ((-0.02, 0.3), (0.06, 0.13), (0.3, 0.15))
            for z in (0.1 * t, 0.9 * t)
        ],
        look,
    )
    b.cushion((0.2 * d, d / 2), (-0.16 * w, 0.16 * w), (0.05 * t, 0.95 * t), look, radius=0.4 * t)


@small("makeup_bag")
def makeup_bag(b: Builder) -> None:
    """A soft bag with a zip and a tassel."""
    d, w, h = b.size
    cloth = b.material(
        "cloth", "rose fabric", "black leather", "navy fabric", "beige fabric", "green fabric", "tan leather"
    )
    loft(
        b,
        [
            rect((-e * d / 2, e * d / 2), (-f * w / 2, f * w / 2), z * h, 0.3 * d * e, 4)
            for e, f, z in (
                (0.86, 0.92, 0.0),
                (1.0, 1.0, 0.12),
                (0.92, 0.98, 0.5),
                (0.5, 0.9, 0.86),
                (0.16, 0.84, 0.95),
            )
        ],
        cloth,
        convex=False,
    )
    b.box((-0.006, 0.006), (-0.42 * w, 0.42 * w), (0.93 * h, h), "brass", 0.002)
    b.box((-0.004, 0.004), (0.4 * w, 0.46 * w), (0.74 * h, 0.97 * h), b.pick("tassel", ["brass", "red fabric"]), 0.002)
    for s in (-1, 1):
        b.box((-0.41 * d, 0.41 * d), (s * 0.3 * w - 0.003, s * 0.3 * w + 0.003), (0.28 * h, 0.34 * h), "brass", 0.001)


@small("makeup_set")
def makeup_set(b: Builder) -> None:
    """A tray with lipsticks, a palette of powders, nail polish and brushes in a cup."""
    d, w, h = b.size
    tray = b.material("tray", "marble", "brass", "white ceramic", "mirror", "oak")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.01), tray, 0.02, 0.002, 4)
    for k, (c, open_) in enumerate((("red plastic", True), ("pink plastic", True), ("plum pigment", False))):
        with b.frame((0.3 - 0.06 * (k % 2)) * d, (-0.42 + 0.09 * k) * w, 0.01):
            b.frustum(0.009, 0.009, (0.0, 0.3 * h), "black plastic", 14)
            b.frustum(0.0075, 0.0075, (0.3 * h, 0.45 * h), "brass", 14)
            if open_:
                b.hull(
                    np.concatenate(
                        [
                            ellipse(0.0062, 0.0062, 0.45 * h, 12),
                            ellipse(0.0062, 0.0062, 0.6 * h, 12) + [0, 0, 0],
                            [(-0.005, 0, 0.68 * h), (-0.004, 0.002, 0.68 * h), (-0.004, -0.002, 0.68 * h)],
                        ]
                    ),
                    c,
                )
            else:
                b.frustum(0.0092, 0.0092, (0.32 * h, 0.7 * h), "black plastic", 14)
    with b.frame(0.2 * d, 0.22 * w, 0.01):
        b.box((-0.04, 0.04), (-0.05, 0.05), (0.0, 0.009), "black plastic", 0.001)
        for i in range(2):
            for j in range(3):
                c = ("blush pigment", "sand pigment", "plum pigment", "terracotta pigment", "pink icing", "bark")[
                    3 * i + j
                ]
                decal(
                    b,
                    (-0.034 + 0.036 * i, -0.002 + 0.036 * i),
                    (-0.045 + 0.031 * j, -0.017 + 0.031 * j),
                    (0.005, 0.0093),
                    c,
                )
        with b.frame(-0.04, 0, 0.009, pitch=-0.35):
            b.box((-0.006, 0.0), (-0.05, 0.05), (0.0, 0.075), "black plastic", 0.001)
            decal(b, (-0.003, 0.0003), (-0.045, 0.045), (0.006, 0.07), "mirror")
    for k, c in enumerate(("red plastic", "pink plastic")):
        with b.frame(-0.05 * d + 0.02 * k, (-0.32 + 0.12 * k) * w, 0.01):
            b.lathe([(0.012, 0.0), (0.013, 0.025), (0.006, 0.03)], c, 14)
            b.frustum(0.0065, 0.0045, (0.03, 0.062), "black plastic", 12)
    with b.frame(-0.28 * d, -0.22 * w, 0.01):
        b.frustum(0.028, 0.03, (0.0, 0.5 * h), b.pick("cup", ["glass", "white ceramic", "brass"]), 20)
        for k in range(4):
            with b.frame(yaw=1.57 * k + 0.4), b.frame(-0.008, 0, 0.35 * h, pitch=0.2):
                top = (0.62 - 0.05 * k) * h
                b.bar(
                    (0, 0, 0),
                    (0, 0, top - 0.03),
                    0.0028,
                    b.pick(f"stick {k}", ["black plastic", "beech", "brass"]),
                    8,
                )
                b.lathe(
                    [(0.004, top - 0.034), (0.009, top - 0.014), (0.004, top)],
                    "bark" if k % 2 else "blush pigment",
                    10,
                )


@small("razor")
def razor(b: Builder) -> None:
    """A shaving stand with a razor, a brush and a bowl of soap."""
    d, w, h = b.size
    metal = b.material("stand", "chrome", "black steel", "brass")
    grip = b.material("grips", "walnut", "white plastic", "black plastic", "chrome")
    loft(
        b,
        [ellipse(e * d / 2, e * w / 2, z, 24) for e, z in ((1.0, 0.0), (1.0, 0.006), (0.9, 0.012))],
        metal,
        convex=True,
    )
    b.bar((0, 0, 0.01), (0, 0, 0.9 * h), 0.004, metal, 10)
    b.bar((0, -0.3 * w, 0.9 * h), (0, 0.3 * w, 0.9 * h), 0.004, metal, 8)
    with b.frame(0, -0.28 * w, 0):
        b.lathe([(0.006, 0.18 * h), (0.009, 0.24 * h), (0.006, 0.5 * h), (0.008, 0.7 * h), (0.005, 0.9 * h)], grip, 12)
        b.box((-0.012, 0.012), (-0.2 * w, 0.2 * w), (0.93 * h, h), "chrome", 0.003)
        b.frustum(0.005, 0.005, (0.88 * h, 0.95 * h), "chrome", 10)
    with b.frame(0, 0.28 * w, 0):
        b.lathe([(0.022, 0.16 * h), (0.017, 0.42 * h), (0.01, 0.52 * h)], "sand pigment", 14)
        b.lathe([(0.011, 0.5 * h), (0.016, 0.62 * h), (0.012, 0.78 * h), (0.008, 0.92 * h)], grip, 14)


@small("toilet_brush", fit="round")
def toilet_brush(b: Builder) -> None:
    """A brush in its holder."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "white ceramic", "brushed steel", "black steel", "white plastic", "concrete")
    metal = b.material("handle", "chrome", "black steel", "white plastic", "bamboo")
    top = 0.4 * h
    b.lathe([(0.9 * r, 0.0), (r, 0.01), (0.9 * r, top - 0.01), (0.86 * r, top)], look, 24)
    b.frustum(0.7 * r, 0.6 * r, (top, top + 0.015), metal, 20)
    b.lathe(
        [(0.01, top + 0.01), (0.008, 0.6 * h), (0.008, 0.8 * h), (0.013, 0.86 * h), (0.013, 0.97 * h), (0.008, h)],
        metal,
        14,
    )


@small("plunger", fit="round")
def plunger(b: Builder) -> None:
    """A rubber cup on a stick."""
    d, _, h = target(b)
    r = d / 2
    cup = b.material("cup", "red plastic", "rubber", "terracotta pigment")
    wood = b.material("stick", "beech", "pine", "blue plastic")
    b.lathe(
        [
            (0.92 * r, 0.0),
            (r, 0.008),
            (0.97 * r, 0.02),
            (0.9 * r, 0.05),
            (0.62 * r, 0.085),
            (0.28 * r, 0.1),
            (0.24 * r, 0.13),
        ],
        cup,
        24,
    )
    b.lathe([(0.013, 0.12), (0.013, h - 0.03), (0.015, h - 0.012), (0.008, h)], wood, 14)


@small("rubber_duck")
def rubber_duck(b: Builder) -> None:
    """A yellow duck with an orange beak."""
    d, w, h = b.size
    look = b.material("body", "yellow plastic", "yellow plastic", "pink plastic", "mint plastic")
    loft(
        b,
        [
            ellipse(e * 0.44 * d, f * w / 2, z * h, 20, x=-0.06 * d + s * d)
            for e, f, z, s in (
                (0.7, 0.7, 0.0, 0.0),
                (0.95, 0.95, 0.12, 0.0),
                (1.0, 1.0, 0.28, 0.0),
                (0.9, 0.88, 0.44, 0.0),
                (0.6, 0.55, 0.55, 0.06),
            )
        ],
        look,
        convex=True,
    )
    b.hull(
        [
            (x * d, y * w, z * h)
            for x, y, z in (
                (-0.2, -0.2, 0.3),
                (-0.2, 0.2, 0.3),
                (-0.36, 0.14, 0.3),
                (-0.36, -0.14, 0.3),
                (-0.5, 0.05, 0.62),
                (-0.5, -0.05, 0.62),
                (-0.2, 0.1, 0.5),
                (-0.2, -0.1, 0.5),
            )
        ],
        look,
    )
    r = 0.27 * h
    b.ball((r, r, r), (0.16 * d, 0, h - r), look, 18)
    b.cushion(
        (0.16 * d + 0.75 * r, d / 2),
        (-0.42 * r, 0.42 * r),
        (h - 1.35 * r, h - 0.95 * r),
        "orange plastic",
        radius=0.2 * r,
    )
    for s in (-1, 1):
        orb(b, (0.1 * r, 0.12 * r, 0.14 * r), (0.16 * d + 0.78 * r, s * 0.5 * r, h - 0.68 * r), "ink pigment", 8)
        with b.frame(-0.08 * d, s * 0.42 * w, 0.36 * h, pitch=-0.4):
            orb(b, (0.2 * d, 0.08 * w, 0.12 * h), (0, 0, 0), look, 12)


@small("first_aid_kit")
def first_aid_kit(b: Builder) -> None:
    """A case with a cross, clasps and a handle."""
    d, w, h = b.size
    look = b.material("body", "red plastic", "white plastic", "green plastic")
    mark = "red plastic" if look.name == "white plastic" else "white plastic"
    top = h - 0.03
    with b.frame(0, 0, top / 2, pitch=np.pi / 2):
        slab(b, (-top / 2, top / 2), (-w / 2, w / 2), (-d / 2, d / 2), look, 0.022, 0.004, 4)
        for e, f in ((0.3, 0.1), (0.1, 0.3)):
            b.add(
                shapes.box((-e * top, e * top), (-f * top, f * top), (0.0, d / 2 + 0.0003 + (0.00005 if e > f else 0))),
                mark,
                [],
            )
        b.add(
            shapes.box((-top / 2 + 0.03, top / 2 - 0.03), (-w / 2 - 0.0003, w / 2 + 0.0003), (-0.002, 0.002)),
            "black plastic",
            [],
        )
    for s in (-1, 1):
        b.box(
            (0.0, 0.014),
            (s * 0.32 * w - 0.012, s * 0.32 * w + 0.012),
            (top - 0.006, top + 0.006),
            "grey plastic",
            0.002,
        )
    n = np.array([[-0.009, -0.004], [0.009, -0.004], [0.009, 0.004], [-0.009, 0.004]])
    b.tube(
        [(0, -0.2 * w, top - 0.004), (0, -0.18 * w, h - 0.004), (0, 0.18 * w, h - 0.004), (0, 0.2 * w, top - 0.004)],
        n,
        "black plastic",
    )


@small("sponge")
def sponge(b: Builder) -> None:
    """A sponge with a rough side."""
    d, w, h = b.size
    look = b.material("body", "foam", "pink icing", "sky pigment", "foam")
    b.cushion((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.74 * h), look, radius=0.006)
    slab(
        b,
        (-d / 2 + 0.0005, d / 2 - 0.0005),
        (-w / 2 + 0.0005, w / 2 - 0.0005),
        (0.72 * h, h),
        b.pick("pad", ["dark leaf", "green fabric", "navy fabric"]),
        0.006,
        0.001,
    )
    for k in range(24):
        x, y = (b.uniform(f"x{k}", -0.42, 0.42)) * w, b.uniform(f"z{k}", 0.27, 0.48) * h
        s = b.uniform(f"s{k}", 0.001, 0.0026)
        decal(
            b,
            (d / 2 - 0.002, d / 2 + 0.0002),
            (x - s, x + s),
            (y - s, y + s),
            "ochre pigment" if look.name == "foam" else "grey paint",
        )
