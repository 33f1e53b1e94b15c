"""Boxes, baskets, bags, shoes and folded clothes."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from .small_kit import OPEN, Look, arch, decal, dome, ellipse, loft, orb, rect, slab, small, spot

CLOTHS = (
    "navy fabric",
    "grey fabric",
    "charcoal fabric",
    "green fabric",
    "mustard fabric",
    "rust fabric",
    "red fabric",
    "blue fabric",
)
SHIRTS = (*CLOTHS, "white fabric", "beige fabric", "rose fabric")


def open_box(
    b: Builder,
    d: float,
    w: float,
    h: float,
    look: Look,
    wall: float,
    lean: float = 0.0,
    floor: float = 0.01,
    name: str = "inside",
) -> None:
    """Four walls on a floor, wider at the top by ``lean``, with a surface inside; each is a prism of its own."""
    x, y = d / 2, w / 2
    with b.solid("floor"):
        b.box((-x + lean, x - lean), (-y + lean, y - lean), (0.0, floor), look, 0.002)
    for k, (a, s) in enumerate((("x", 1), ("x", -1), ("y", 1), ("y", -1))):
        with b.solid(f"wall {k}"):
            long, far = (y, x) if a == "x" else (x, y)
            points = [
                (s * (far - e - q), t * (long - e), z)
                for z, e in ((0.0, lean), (h, 0.0))
                for q in (0.0, wall)
                for t in (-1, 1)
            ]
            b.hull(points if a == "x" else [(py, px, z) for px, py, z in points], look)
    e = lean + wall + 0.004
    b.surface(name, (-x + e, x - e), (-y + e, y - e), floor)


@small("storage_box", opened=True)
def storage_box(b: Builder) -> None:
    """A box of card, cloth or plastic: lidded, with a grip and a label, or open."""
    look = b.material(
        "body", "grey fabric", "beige fabric", "white plastic", "navy fabric", "sage paint", "cardboard", "rose fabric"
    )
    if b.request.shape == OPEN:
        open_box(b, *b.size, look, 0.006)
        return
    with b.solid("all"):
        _lidded(b, look)


def _lidded(b: Builder, look: Look) -> None:
    d, w, h = b.size
    cover = (
        b.material("lid", "grey fabric", "white plastic", "oak", "beige fabric") if b.chance("other lid", 0.4) else look
    )
    lip = min(0.05, 0.25 * h)
    b.box((-d / 2 + 0.004, d / 2 - 0.004), (-w / 2 + 0.004, w / 2 - 0.004), (0.0, h - 0.01), look, 0.003)
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - lip, h), cover, 0.003)
    x = d / 2 - 0.004
    z = 0.4 * (h - lip)
    b.box(
        (x - 0.002, x + 0.003),
        (-0.045, 0.045),
        (z - 0.022, z + 0.022),
        "steel" if b.chance("metal", 0.5) else "brass",
        0.001,
    )
    decal(b, (x - 0.002, x + 0.0033), (-0.038, 0.038), (z - 0.016, z + 0.016), "paper")
    for s in (-1, 1):
        arch(
            b,
            (-0.04, s * (w / 2 - 0.008), z + 0.02),
            (0.04, s * (w / 2 - 0.008), z + 0.02),
            (0, 0, 0.02),
            0.004,
            "tan leather",
            5,
            6,
        )


@small("cardboard_box")
def cardboard_box(b: Builder) -> None:
    """A closed carton with tape, a label and arrows; some are open, their flaps up."""
    d, w, h = b.size
    look = b.material("body", "cardboard")
    opened = b.chance("open", 0.35)
    top = 0.78 * h if opened else h
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, top), look, 0.002)
    x = (0.0, d / 2 + 0.0003)
    decal(b, x, (0.12 * w, 0.4 * w), (0.55 * top, 0.82 * top), "paper")
    for k in range(3):
        decal(
            b,
            (0.0, d / 2 + 0.0004),
            (0.16 * w, (0.36 - 0.05 * k) * w),
            ((0.75 - 0.06 * k) * top, (0.77 - 0.06 * k) * top),
            "ink pigment",
        )
    for k in range(2):
        y = (-0.36 + 0.12 * k) * w
        decal(b, x, (y - 0.01 * w, y + 0.01 * w), (0.08 * top, 0.22 * top), "ink pigment")
        b.add(
            shapes.hull(
                np.array(
                    [(px, y + s * 0.035 * w, 0.2 * top) for s in (-1, 1) for px in (0.0, x[1])]
                    + [(px, y, 0.29 * top) for px in (0.0, x[1])]
                    + [(0.0, y, 0.2 * top)]
                )
            ),
            "ink pigment",
            [],
        )
    if opened:
        for s in (-1, 1):
            b.hull(
                [
                    (s * (d / 2 - e), y, z)
                    for e, y, z in (
                        (0.0, 0.48 * w, top),
                        (0.004, 0.48 * w, top),
                        (0.0, -0.48 * w, top),
                        (0.004, -0.48 * w, top),
                    )
                ]
                + [(s * (d / 2 - e - 0.03), y * w, h) for e in (0.0, 0.004) for y in (-0.46, 0.46)],
                look,
            )
            b.hull(
                [(px, s * (w / 2 - e), top - 0.002) for e in (0.0, 0.004) for px in (-0.46 * d, 0.46 * d)]
                + [(px * d, s * (w / 2 - e - 0.02), 0.96 * h) for e in (0.0, 0.004) for px in (-0.44, 0.44)],
                look,
            )
        decal(b, (-d / 2 + 0.006, d / 2 - 0.006), (-w / 2 + 0.006, w / 2 - 0.006), (top - 0.01, top + 0.0003), "bark")
        for k in range(4):
            b.box(
                ((-0.35 + 0.18 * k) * d, (-0.2 + 0.18 * k) * d),
                (-0.3 * w, 0.3 * w),
                (top - 0.01, top + (0.03 + 0.02 * (k % 3))),
                b.pick(f"in{k}", list(CLOTHS)),
                0.004,
            )
    else:
        decal(b, (-0.03, 0.03), (-w / 2 + 0.003, w / 2 - 0.003), (top - 0.01, top + 0.0003), "sand pigment")
        for s in (-1, 1):
            decal(
                b,
                (-0.03, 0.03),
                (s * (w / 2 - 0.001) - 0.0013, s * (w / 2 - 0.001) + 0.0013),
                (0.82 * top, top - 0.003),
                "sand pigment",
            )
        decal(b, (-0.001, 0.001), (-w / 2 + 0.003, w / 2 - 0.003), (top - 0.01, top + 0.0004), "bark")


@small("basket", opened=True)
def basket(b: Builder) -> None:
    """A woven basket, open above, with bands of weave and two handles."""
    d, w, h = b.size
    look = b.material("body", "wicker", "rattan", "beige fabric", "grey fabric")
    dark = b.material("bands", "bark", "wicker", "white fabric", "charcoal fabric")
    lean = 0.06 * d
    top = h - 0.045
    open_box(b, d, w, top, look, 0.012, lean, 0.012)
    rows = 7
    for k in range(rows):
        z = (k + 0.3) * top / rows
        e = lean * (1 - z / top)
        with b.solid("wall 0"):
            for s in (-1, 1):
                a = np.arctan2(lean, top)
                for x, y, far, turn in (
                    (d / 2 - e, 0, w / 2 - e - 0.004, 0.0),
                    (w / 2 - e, 0, d / 2 - e - 0.004, np.pi / 2),
                ):
                    with b.frame(yaw=turn + (0 if s > 0 else np.pi)), b.frame(x, y, z, pitch=a):
                        b.add(shapes.box((-0.006, 0.0003), (-far, far), (0.0, 0.35 * top / rows)), dark, [])
    for s in (-1, 1):
        with b.solid("wall 2" if s > 0 else "wall 3"):
            arch(
                b,
                (-0.07, s * (w / 2 - 0.007), top - 0.004),
                (0.07, s * (w / 2 - 0.007), top - 0.004),
                (0, 0, 0.045 - 0.005),
                0.006,
                dark,
                6,
            )


@small("plastic_bin", opened=True)
def plastic_bin(b: Builder) -> None:
    """An open tub with a rim and grips."""
    d, w, h = b.size
    look = b.material(
        "body",
        "white plastic",
        "grey plastic",
        "blue plastic",
        "red plastic",
        "clear plastic",
        "mint plastic",
        "yellow plastic",
    )
    lean = 0.08 * d
    open_box(b, d - 0.03, w - 0.03, h, look, 0.004, lean, 0.006)
    for k, (x, y) in enumerate(
        (
            ((d / 2 - 0.022, d / 2), (-w / 2, w / 2)),
            ((-d / 2, -d / 2 + 0.022), (-w / 2, w / 2)),
            ((-d / 2 + 0.02, d / 2 - 0.02), (w / 2 - 0.022, w / 2)),
            ((-d / 2 + 0.02, d / 2 - 0.02), (-w / 2, -w / 2 + 0.022)),
        )
    ):
        with b.solid(f"wall {k}"):
            b.box(x, y, (h - 0.014, h), look, 0.004)
            if k > 1:
                ys = (y[1] - 0.012, y[1] + 0.0) if k == 2 else (y[0], y[0] + 0.012)
                b.box(
                    (-0.06, 0.06),
                    ys,
                    (h - 0.04, h - 0.012),
                    b.pick("grip", ["grey plastic", "white plastic", "black plastic"]),
                    0.003,
                )


@small("wooden_crate", opened=True)
def wooden_crate(b: Builder) -> None:
    """A crate of slats with gaps between them."""
    d, w, h = b.size
    wood = b.material("body", "pine", "oak", "ash grey wood", "birch", "walnut")
    t = 0.012
    with b.solid("floor"):
        for k in range(4):
            x0 = -d / 2 + k * d / 4
            b.box((x0 + 0.002, x0 + d / 4 - 0.002), (-w / 2 + 0.001, w / 2 - 0.001), (0.0, t), wood, 0.001)
    rows = 3
    slat = (h - t) / rows
    for k in range(4):
        with b.solid(f"wall {k}"):
            for r in range(rows):
                z = (t + r * slat + (0.004 if r else 0.0), t + (r + 1) * slat - 0.006 * (r < rows - 1))
                if k < 2:
                    s = 1 if k == 0 else -1
                    b.box(
                        (min(s * d / 2, s * (d / 2 - t)), max(s * d / 2, s * (d / 2 - t))),
                        (-w / 2, w / 2),
                        z,
                        wood,
                        0.0015,
                    )
                else:
                    s = 1 if k == 2 else -1
                    b.box(
                        (-d / 2 + t, d / 2 - t),
                        (min(s * w / 2, s * (w / 2 - t)), max(s * w / 2, s * (w / 2 - t))),
                        z,
                        wood,
                        0.0015,
                    )
            if k > 1:
                s = 1 if k == 2 else -1
                for px in (-1, 1):
                    xx = px * (d / 2 - t - 0.01)
                    yy = s * (w / 2 - t - 0.006)
                    b.box((xx - 0.01, xx + 0.01), (yy - 0.007, yy + 0.007), (t, h - 0.004), wood, 0.001)
                yo = s * (w / 2)
                decal(
                    b,
                    (-0.05, 0.05),
                    (yo - 0.0003 if s < 0 else yo - 0.004, yo + 0.0003 if s > 0 else yo + 0.004),
                    (h - slat * 0.62, h - slat * 0.32),
                    "bark",
                )
    b.surface("inside", (-d / 2 + t + 0.024, d / 2 - t - 0.024), (-w / 2 + t + 0.018, w / 2 - t - 0.018), t)


@small("gift_box")
def gift_box(b: Builder) -> None:
    """A wrapped present with a ribbon and a bow."""
    d, w, h = b.size
    wrap = b.material(
        "wrap",
        "red paint",
        "navy paint",
        "teal paint",
        "yellow paint",
        "blush pigment",
        "sage paint",
        "white paint",
        "plum pigment",
    )
    ribbon = b.material("ribbon", "white fabric", "brass", "red fabric", "mustard fabric", "green fabric")
    top = h - 0.05
    b.box((-d / 2 + 0.003, d / 2 - 0.003), (-w / 2 + 0.003, w / 2 - 0.003), (0.0, top - 0.01), wrap, 0.001)
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.78 * top, top), wrap, 0.001)
    r = 0.07 * max(d, w)
    b.box((-d / 2 - 0.001, d / 2 + 0.001), (-r, r), (0.0, top + 0.001), ribbon, 0.0005)
    b.box((-r, r), (-w / 2 - 0.001, w / 2 + 0.001), (0.0, top + 0.001), ribbon, 0.0005)
    for k in range(4):
        with b.frame(0, 0, top + 0.001, yaw=k * np.pi / 2 + np.pi / 4, pitch=-0.55):
            b.cushion(
                (0.0, 0.26 * min(d, w)),
                (-0.7 * r - 0.008, 0.7 * r + 0.008),
                (-0.004, 0.02),
                ribbon,
                radius=0.009,
                puff=0.4,
            )
    b.ball((0.018, 0.018, 0.016), (0, 0, top + 0.016), ribbon, 12)
    b.frustum(0.012, 0.008, (top + 0.02, h), ribbon, 12)


@small("suitcase")
def suitcase(b: Builder) -> None:
    """A trolley case: ribbed shells, wheels, a pull-out handle."""
    d, w, h = b.size
    look = b.material(
        "body",
        "black plastic",
        "grey plastic",
        "blue plastic",
        "red plastic",
        "teal paint",
        "aluminium",
        "pink plastic",
        "navy paint",
    )
    wheels = 0.045
    top = h - b.uniform("pull", 0.02, 0.12) if h > 0.6 else h - 0.02
    for px in (-0.32 * d, 0.32 * d):
        for s in (-1, 1):
            with b.frame(px, s * (w / 2 - 0.05), 0.024, roll=np.pi / 2):
                b.frustum(0.024, 0.024, (-0.014, 0.014), "rubber", 14)
            b.box(
                (px - 0.02, px + 0.02),
                (s * (w / 2 - 0.05) - 0.022, s * (w / 2 - 0.05) + 0.022),
                (0.034, wheels + 0.01),
                "black plastic",
                0.004,
            )
    zm = (wheels + top) / 2
    half = (top - wheels) / 2
    with b.frame(0, 0, zm, pitch=np.pi / 2):
        # Lying shells: its axis points to the front, x of this frame points down.
        for s in (-1, 1):
            zs = (0.003, d / 2) if s > 0 else (-d / 2, -0.003)
            slab(b, (-half, half), (-w / 2, w / 2), zs, look, 0.06, 0.02, 4)
        slab(
            b,
            (-half + 0.004, half - 0.004),
            (-w / 2 + 0.004, w / 2 - 0.004),
            (-0.004, 0.004),
            "black plastic",
            0.056,
            0.0,
        )
        for k in range(5):
            y = (-0.3 + 0.15 * k) * w
            b.add(
                shapes.box((-half + 0.06, half - 0.06), (y - 0.008, y + 0.008), (0.0, d / 2 + 0.0004), 0.0),
                "grey plastic" if look.name == "black plastic" else "black plastic",
                [],
            )
    for s in (-1, 1):
        b.bar((-0.3 * d, s * 0.2 * w, top - 0.05), (-0.3 * d, s * 0.2 * w, h - 0.012), 0.007, "aluminium", 8)
    b.box((-0.3 * d - 0.014, -0.3 * d + 0.014), (-0.24 * w, 0.24 * w), (h - 0.026, h), "black plastic", 0.008)
    arch(b, (0.04, -0.09, top - 0.006), (0.04, 0.09, top - 0.006), (0, 0, 0.022), 0.007, "black plastic", 5)


@small("backpack")
def backpack(b: Builder) -> None:
    """A school bag: body, front pocket, flap or zip, side pockets, straps behind."""
    d, w, h = b.size
    cloth = b.material("cloth", *CLOTHS, "black fabric")
    trim = b.material("trim", "brown leather", "black leather", "tan leather", "charcoal fabric", "mustard fabric")
    x0, x1 = -d / 2 + 0.025, d / 2 - 0.055
    top = h - 0.03
    b.cushion((x0, x1), (-w / 2 + 0.02, w / 2 - 0.02), (0.0, top), cloth, radius=0.075)
    b.cushion((x1 - 0.05, d / 2), (-0.34 * w, 0.34 * w), (0.03, 0.5 * h), cloth, radius=0.035)
    b.box((d / 2 - 0.03, d / 2 - 0.001), (-0.28 * w, 0.28 * w), (0.4 * h, 0.4 * h + 0.008), trim, 0.002)
    if b.chance("flap", 0.5):
        b.cushion((x0 + 0.04, x1 + 0.012), (-0.37 * w, 0.37 * w), (0.6 * h, top + 0.004), trim, radius=0.05)
        for s in (-1, 1):
            b.box(
                (x1 + 0.004, x1 + 0.016), (s * 0.2 * w - 0.012, s * 0.2 * w + 0.012), (0.46 * h, 0.66 * h), trim, 0.003
            )
            b.box(
                (x1 + 0.01, x1 + 0.019),
                (s * 0.2 * w - 0.014, s * 0.2 * w + 0.014),
                (0.52 * h, 0.56 * h),
                "brass",
                0.002,
            )
    else:
        t = np.linspace(0.15 * np.pi, 0.85 * np.pi, 7)
        b.tube(np.c_[0 * t + x1 - 0.014, (0.42 * w) * np.cos(t), 0.52 * h + 0.4 * h * np.sin(t)], 0.004, trim, 6)
        slab(b, (x1 - 0.01, x1 + 0.004), (-0.03, 0.03), (0.62 * h, 0.7 * h), trim, 0.004)
    for s in (-1, 1):
        b.cushion(
            (x0 + 0.02, x1 - 0.02),
            (s * (w / 2 - 0.03) - 0.03, s * (w / 2 - 0.03) + 0.03),
            (0.03, 0.34 * h),
            cloth,
            radius=0.022,
        )
        n = np.array([[-0.022, -0.006], [0.022, -0.006], [0.022, 0.006], [-0.022, 0.006]])
        b.tube(
            [
                (x0 + 0.03, s * 0.2 * w, 0.9 * h),
                (-d / 2 + 0.008, s * 0.24 * w, 0.78 * h),
                (-d / 2 + 0.008, s * 0.3 * w, 0.4 * h),
                (x0 + 0.03, s * 0.36 * w, 0.1 * h),
            ],
            n,
            trim,
        )
    arch(b, (x0 + 0.05, -0.04, top - 0.012), (x0 + 0.05, 0.04, top - 0.012), (0, 0, 0.035), 0.006, trim, 5)


@small("handbag")
def handbag(b: Builder) -> None:
    """A leather or cloth bag with two handles, a clasp and seams."""
    d, w, h = b.size
    look = b.material(
        "body",
        "brown leather",
        "black leather",
        "tan leather",
        "red fabric",
        "navy fabric",
        "beige fabric",
        "white leather",
    )
    metal = b.pick("metal", ["brass", "chrome"])
    body = 0.62 * h
    loft(
        b,
        [
            rect((-e * d / 2, e * d / 2), (-f * w / 2, f * w / 2), z * body, 0.25 * d * e, 3)
            for e, f, z in ((0.92, 0.92, 0.0), (1.0, 1.0, 0.06), (0.8, 0.96, 0.6), (0.34, 0.86, 1.0))
        ],
        look,
        convex=False,
    )
    for s in (-1, 1):
        n = np.array([[-0.008, -0.005], [0.008, -0.005], [0.008, 0.005], [-0.008, 0.005]])
        arch(
            b,
            (s * 0.14 * d, -0.22 * w, body - 0.012),
            (s * 0.14 * d, 0.22 * w, body - 0.012),
            (s * 0.05 * d, 0, h - body),
            n,
            look,
            8,
        )
        for y in (-0.22, 0.22):
            b.box(
                (s * 0.16 * d - 0.006, s * 0.16 * d + 0.006),
                (y * w - 0.012, y * w + 0.012),
                (body - 0.05, body - 0.004),
                look,
                0.002,
            )
    b.hull(
        [
            (x, y, z)
            for x, z in ((0.1 * d, body), (0.2 * d, body - 0.004), (0.33 * d, 0.72 * body))
            for y in (-0.09 * w, 0.09 * w)
        ]
        + [(0.26 * d, 0, 0.7 * body)],
        look,
    )
    orb(b, (0.006, 0.014, 0.014), (0.32 * d, 0, 0.76 * body), metal, 10)
    for s in (-1, 1):
        b.box((-0.3 * d, 0.42 * d), (s * 0.4 * w - 0.003, s * 0.4 * w + 0.003), (0.004, 0.5 * body), look, 0.001)


@small("shopping_bag")
def shopping_bag(b: Builder) -> None:
    """A paper bag with cord handles; bread and leeks stick out of some."""
    d, w, h = b.size
    look = b.material(
        "body", "cardboard", "paper", "red paint", "navy paint", "black paint", "sage paint", "blush pigment"
    )
    groceries = look.name in ("cardboard", "paper") and b.chance("groceries", 0.6)
    top = 0.78 * h
    b.hull(
        [(x * d, y, z) for y in (-w / 2, w / 2) for x, z in ((-0.5, 0.0), (0.5, 0.0), (-0.46, top), (0.46, top))], look
    )
    decal(b, (-0.44 * d, 0.44 * d), (-w / 2 + 0.006, w / 2 - 0.006), (top - 0.01, top + 0.0004), "bark")
    for s in (-1, 1):
        if not groceries:
            arch(
                b,
                (s * 0.44 * d, -0.18 * w, top - 0.006),
                (s * 0.44 * d, 0.18 * w, top - 0.006),
                (-s * 0.1 * d, 0, h - top),
                0.003,
                "white fabric",
                8,
                6,
            )
    with b.frame(0.48 * d, 0, 0.45 * h, pitch=np.pi / 2):
        b.add(
            shapes.frustum(0.2 * w, 0.2 * w, (-0.02, 0.0045), 24),
            "chalk pigment" if look.name not in ("paper", "cardboard") else "moss pigment",
            [],
        )
    if groceries:
        with b.frame(-0.1 * d, -0.2 * w, top - 0.05, roll=0.12):
            b.lathe(
                [(0.032, 0.0), (0.034, 0.5 * (h - top) + 0.03), (0.026, h - top + 0.03), (0.01, h - top + 0.045)],
                "bread crust",
                12,
            )
        for k in range(3):
            with b.frame(0.1 * d, (0.1 + 0.07 * k) * w, top - 0.02, roll=0.15 * (1 - k)):
                b.frustum(0.012, 0.016, (0.0, 0.05), "pale leaf", 8)
                b.frustum(0.012, 0.03, (0.05, 0.05 + 0.6 * (h - top)), "leaf", 8)
        orb(b, (0.036, 0.036, 0.036), (-0.12 * d, 0.26 * w, top + 0.012), "red apple", 10)


def _shoe(b: Builder, long: float, wide: float, h: float, look: Look, sole: Look, boot: bool) -> None:
    def outline(s: float, z: float, x0: float = -0.5, x1: float = 0.5) -> np.ndarray:
        t = (np.arange(20) + 0.5) * np.pi / 10
        x = (x0 + x1) / 2 + (x1 - x0) / 2 * np.cos(t)
        waist = 1 - 0.22 * np.exp(-((x + 0.05) ** 2) / 0.03) - 0.14 * (x < -0.2)
        return np.c_[x * long, s * wide / 2 * np.sign(np.sin(t)) * np.abs(np.sin(t)) ** 0.7 * waist, np.full(20, z)]

    base = 0.22 * h if not boot else 0.14 * h
    loft(b, [outline(1.0, 0.0), outline(1.0, base)], sole, convex=True)
    low = 0.55 * h if not boot else 0.4 * h
    loft(
        b,
        [outline(0.96, base, -0.49, 0.49), outline(0.94, 0.72 * low, -0.49, 0.46), outline(0.8, low, -0.48, 0.2)],
        look,
    )
    loft(b, [outline(0.8, low, -0.48, 0.2), outline(0.7, 0.85 * h, -0.48, 0.0), outline(0.74, h, -0.49, -0.04)], look)
    b.add(shapes.extrusion(outline(0.5, 0, -0.44, -0.08)[:, :2], (h - 0.01, h + 0.0003)), "charcoal fabric", [])
    for k in range(4):
        x, z = 0.22 - 0.065 * k, (low - 0.002) + (h - low) * 0.17 * k
        b.box(
            (x * long - 0.003, x * long + 0.003),
            (-0.2 * wide, 0.2 * wide),
            (z - 0.012, z + 0.006),
            "white fabric",
            0.002,
        )


@small("shoe_pair")
def shoe_pair(b: Builder) -> None:
    """A pair of trainers, leather shoes or boots, toes to the front."""
    d, w, h = b.size
    boot = h > 0.135
    look = b.material(
        "upper",
        "white leather",
        "brown leather",
        "black leather",
        "tan leather",
        "red fabric",
        "blue fabric",
        "grey fabric",
    )
    sole = b.material("sole", "rubber", "white plastic", "tan leather")
    for s in (-1, 1):
        with b.frame(0.0, s * 0.27 * w, 0.0, yaw=0.04 * s):
            _shoe(b, d * 0.99, 0.42 * w, h, look, sole, boot)


@small("slippers")
def slippers(b: Builder) -> None:
    """A pair of open slippers."""
    d, w, h = b.size
    cloth = b.material(
        "cloth", "grey fabric", "rose fabric", "beige fabric", "navy fabric", "brown leather", "red fabric"
    )
    lining = b.material("lining", "white fabric", "beige fabric", "sand pigment")
    for s in (-1, 1):
        with b.frame(0.0, s * 0.27 * w):
            loft(
                b,
                [ellipse(e * 0.5 * d, e * 0.21 * w, z, 20) for e, z in ((0.97, 0.0), (1.0, 0.01), (0.98, 0.022))],
                "rubber",
                convex=True,
            )
            loft(
                b, [ellipse(0.47 * d, 0.19 * w, 0.02, 20), ellipse(0.46 * d, 0.185 * w, 0.03, 20)], lining, convex=True
            )
            loft(
                b,
                [
                    ellipse(e * 0.24 * d, f * 0.21 * w, z * h, 20, x=0.25 * d)
                    for e, f, z in ((1.0, 1.0, 0.18), (1.0, 1.0, 0.5), (0.8, 0.86, 0.82), (0.42, 0.5, 1.0))
                ],
                cloth,
                convex=True,
            )
            orb(b, (0.02, 0.03, 0.012), (0.16 * d, 0, 0.86 * h), lining, 10)


@small("shoe_box")
def shoe_box(b: Builder) -> None:
    """A carton for shoes with an overlapping lid and a label."""
    d, w, h = b.size
    look = b.material("body", "cardboard", "orange plastic", "navy paint", "white paint", "black paint", "red paint")
    cover = b.material("lid", "cardboard", "white paint", "black paint", "red paint")
    b.box((-d / 2 + 0.002, d / 2 - 0.002), (-w / 2 + 0.002, w / 2 - 0.002), (0.0, h - 0.002), look, 0.001)
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.035, h), cover, 0.001)
    decal(b, (-0.02, 0.05), (w / 2 - 0.004, w / 2 - 0.0017), (0.2 * h, 0.6 * h), "paper")
    decal(b, (d / 2 - 0.004, d / 2 - 0.0017), (-0.06, 0.06), (0.2 * h, 0.6 * h), "paper")
    for k in range(3):
        decal(
            b,
            (d / 2 - 0.004, d / 2 - 0.0016),
            (-0.05, 0.045 - 0.02 * k),
            ((0.5 - 0.1 * k) * h, (0.53 - 0.1 * k) * h),
            "ink pigment",
        )
    decal(b, (-0.25 * d, 0.25 * d), (-0.16 * w, 0.16 * w), (h - 0.003, h + 0.0003), look)


@small("hat")
def hat(b: Builder) -> None:
    """A hat with a wide brim, a dented crown and a ribbon."""
    d, w, h = b.size
    felt = b.material(
        "felt", "rattan", "wicker", "charcoal fabric", "beige fabric", "brown leather", "navy fabric", "grey fabric"
    )
    ribbon = b.material("ribbon", "black fabric", "red fabric", "navy fabric", "white fabric", "rust fabric")
    n = 28
    loft(
        b,
        [
            ellipse(e * d / 2, e * w / 2, z, n)
            for e, z in ((0.6, 0.0), (0.94, 0.004), (1.0, 0.012), (0.995, 0.015), (0.56, 0.009))
        ],
        felt,
    )
    loft(
        b,
        [
            ellipse(e * d / 2, f * w / 2, z * h, n)
            for e, f, z in (
                (0.6, 0.58, 0.03),
                (0.57, 0.55, 0.5),
                (0.52, 0.5, 0.85),
                (0.42, 0.36, 0.98),
                (0.36, 0.2, 1.0),
            )
        ],
        felt,
    )
    loft(
        b,
        [ellipse(e * d / 2, f * w / 2, z * h, n) for e, f, z in ((0.606, 0.586, 0.1), (0.59, 0.57, 0.32))],
        ribbon,
        convex=True,
    )
    b.box((-0.02, 0.03), (0.54 * w / 2, 0.62 * w / 2), (0.11 * h, 0.3 * h), ribbon, 0.003)


@small("cap")
def cap(b: Builder) -> None:
    """A cap with a peak, seams and a button."""
    d, w, h = b.size
    cloth = b.material(
        "cloth", "navy fabric", "red fabric", "black fabric", "green fabric", "grey fabric", "white fabric"
    )
    peak = (
        b.material("peak", "navy fabric", "red fabric", "black fabric", "mustard fabric")
        if b.chance("two", 0.4)
        else cloth
    )
    r = w / 2
    x = -d / 2 + r
    b.add(_dome(x, r, h - 0.006), cloth, [shapes.containing_hull(_dome(x, r, h - 0.006)[0])])
    b.frustum(0.01, 0.006, (0.0, 0.006), cloth, 10)
    with b.frame(x, 0, h - 0.012):
        b.frustum(0.011, 0.007, (0.0, 0.012), peak, 12)
    t = np.linspace(-0.42 * np.pi, 0.42 * np.pi, 11)
    outer = np.c_[x + 0.3 * r + (d - r - 0.3 * r) * np.cos(t) ** 0.7, 0.98 * r * np.sin(t)]
    b.hull(
        np.concatenate(
            [
                np.c_[outer, 0.002 + 0.012 * np.cos(2.0 * t).clip(0)],
                np.c_[outer, 0.007 + 0.012 * np.cos(2.0 * t).clip(0)],
                [(x + 0.2 * r, s * 0.9 * r, 0.02) for s in (-1, 1)],
            ]
        ),
        peak,
    )
    b.hull(
        [(x + 0.8 * r, y, z) for y in (-0.2 * r, 0.2 * r) for z in (0.36 * h, 0.62 * h)]
        + [(x + (0.985 if z < 0.5 else 0.89) * r, y, z * h) for y in (-0.2 * r, 0.2 * r) for z in (0.36, 0.62)],
        "white fabric",
    )


def _dome(x: float, r: float, top: float) -> shapes.convex.Shape:
    points, faces = shapes.lathe([(r, 0.0), (1.0 * r, 0.25 * top), *dome(0.99 * r, 0.3 * top, top, 5, 0.05 * r)], 24)
    return points + np.array([x, 0.0, 0.0]), faces


@small("folded_clothes")
def folded_clothes(b: Builder) -> None:
    """Folded shirts and jumpers in a pile; the top one has a collar."""
    d, w, h = b.size
    count = max(2, round(h / 0.04))
    t = h / count
    for k in range(count):
        cloth = b.material("cloth", *SHIRTS) if k == 0 else b.pick(f"c{k}", SHIRTS)
        e = 0.0 if k == 0 else b.uniform(f"e{k}", 0.0, 0.02)
        y = 0.0 if k == 0 else b.uniform(f"y{k}", -0.008, 0.008)
        last = k == count - 1
        z1 = (k + 1) * t - (0.004 if last else -0.001)
        b.cushion(
            (-d / 2 + e, d / 2 - e / 2),
            (-w / 2 + e + 0.008 + y, w / 2 - e - 0.008 + y) if k else (-w / 2, w / 2),
            (k * t, z1),
            cloth,
            radius=0.48 * t,
            puff=0.15,
        )
        if last:
            for s in (-1, 1):
                b.hull(
                    [
                        (px, s * py + y, z)
                        for px, py in ((-0.44 * d, 0.02), (-0.44 * d, 0.2 * w), (-0.22 * d, 0.07 * w))
                        for z in (z1 - 0.006, h)
                    ],
                    cloth,
                )
            b.box((-0.2 * d, 0.4 * d), (y - 0.01, y + 0.01), (z1 - 0.004, z1 + 0.0008), cloth, 0.0005)
            for j in range(4):
                with b.frame((-0.14 + 0.14 * j) * d, y, z1):
                    spot(b, 0.005, (-0.002, 0.002), "chalk pigment", 10)


@small("piggy_bank")
def piggy_bank(b: Builder) -> None:
    """A round pig with a slot, ears, a snout and a curled tail."""
    d, w, h = b.size
    look = b.material("body", "pink plastic", "pink icing", "white ceramic", "blue ceramic", "mint plastic", "brass")
    zc, rz = 0.52 * h, 0.4 * h
    b.ball((0.4 * d, w / 2, rz), (0, 0, zc), look, 20)
    with b.frame(0.33 * d, 0, 0.98 * zc, pitch=np.pi / 2):
        b.frustum(0.17 * h, 0.14 * h, (0.0, 0.15 * d), look, 18)
    for s in (-1, 1):
        decal(
            b,
            (0.4 * d, 0.48 * d + 0.0003),
            (s * 0.06 * h - 0.022 * h, s * 0.06 * h + 0.022 * h),
            (0.94 * zc, 1.06 * zc),
            "rose fabric",
        )
        b.hull(
            [
                (0.2 * d, s * 0.2 * w, 0.84 * h),
                (0.26 * d, s * 0.12 * w, 0.84 * h),
                (0.27 * d, s * 0.34 * w, 0.74 * h),
                (0.19 * d, s * 0.3 * w, 0.78 * h),
                (0.3 * d, s * 0.27 * w, h),
            ],
            look,
        )
        orb(b, (0.018 * h, 0.03 * h, 0.03 * h), (0.35 * d, s * 0.2 * w, 0.68 * h), "ink pigment", 8)
        for x in (-0.2, 0.18):
            with b.frame(x * d, s * 0.24 * w):
                b.frustum(0.08 * h, 0.1 * h, (0.0, 0.3 * h), look, 14)
    decal(b, (-0.08 * d, 0.08 * d), (-0.03 * w, 0.03 * w), (zc, zc + 0.985 * rz), "ink pigment", own=False)
    t = np.linspace(0, 2.4 * np.pi, 9)
    b.tube(
        np.c_[-0.38 * d - 0.1 * d * t / t[-1], 0.05 * h * np.cos(t) - 0.05 * h, zc + 0.05 * h * np.sin(t)],
        0.012 * h,
        look,
        6,
    )


@small("lunch_box")
def lunch_box(b: Builder) -> None:
    """A food box with a clip lid."""
    d, w, h = b.size
    look = b.material("body", "clear plastic", "mint plastic", "blue plastic", "pink plastic", "steel", "white plastic")
    cover = b.material("lid", "bamboo", "grey plastic", "blue plastic", "white plastic", "green plastic")
    x, y = (-d / 2 + 0.006, d / 2 - 0.006), (-w / 2 + 0.006, w / 2 - 0.006)
    loft(
        b,
        [
            rect((x[0] + e, x[1] - e), (y[0] + e, y[1] - e), z * h, 0.025, 4)
            for e, z in ((0.01, 0.0), (0.006, 0.06), (0.0, 0.8))
        ],
        look,
        convex=True,
    )
    if look.opacity < 1:
        for k, c in enumerate(("lettuce", "bread crumb", "tomato")):
            y0 = y[0] + 0.012 + k * (w - 0.036) / 3
            b.add(
                shapes.box(
                    (x[0] + 0.015, x[1] - 0.015), (y0, y0 + (w - 0.036) / 3 - 0.006), (0.05 * h, 0.6 * h), 0.004
                ),
                c,
                [],
            )
    slab(b, (-d / 2 + 0.002, d / 2 - 0.002), (-w / 2 + 0.002, w / 2 - 0.002), (0.78 * h, h), cover, 0.03, 0.004, 4)
    for s in (-1, 1):
        b.box(
            (-0.03, 0.03),
            (min(s * w / 2, s * (w / 2 - 0.006)), max(s * w / 2, s * (w / 2 - 0.006))),
            (0.58 * h, 0.92 * h),
            cover,
            0.002,
        )
        b.box(
            (min(s * d / 2, s * (d / 2 - 0.006)), max(s * d / 2, s * (d / 2 - 0.006))),
            (-0.04, 0.04),
            (0.58 * h, 0.92 * h),
            cover,
            0.002,
        )


@small("toolbox")
def toolbox(b: Builder) -> None:
    """A metal or plastic box with a lid, clasps and a handle."""
    d, w, h = b.size
    look = b.material("body", "red paint", "blue paint", "black plastic", "yellow plastic", "green paint", "grey paint")
    dark = b.material("trim", "black plastic", "black steel")
    top = 0.84 * h
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.56 * h), look, 0.006)
    b.hull(
        [
            (x, y, z)
            for y in (-w / 2, w / 2)
            for x, z in (
                (-d / 2, 0.55 * h),
                (d / 2, 0.55 * h),
                (d / 2, 0.66 * h),
                (-d / 2, 0.66 * h),
                (0.3 * d, top),
                (-0.3 * d, top),
            )
        ],
        look,
    )
    for s in (-1, 1):
        b.box(
            (d / 2 - 0.004, d / 2 + 0.006),
            (s * 0.28 * w - 0.02, s * 0.28 * w + 0.02),
            (0.46 * h, 0.64 * h),
            "steel",
            0.002,
        )
        b.box((-0.02, 0.02), (s * 0.22 * w - 0.01, s * 0.22 * w + 0.01), (top - 0.01, h - 0.008), dark, 0.003)
        decal(
            b,
            (-0.5 * d + 0.012, 0.5 * d - 0.012),
            (s * w / 2 - 0.0003, s * w / 2 + 0.0003),
            (0.46 * h, 0.475 * h),
            dark,
        )
    decal(b, (0.0, d / 2 + 0.0003), (-w / 2 + 0.008, w / 2 - 0.008), (0.46 * h, 0.475 * h), dark)
    b.bar((0, -0.25 * w, h - 0.014), (0, 0.25 * w, h - 0.014), 0.0135, dark, 10)
    decal(b, (0.0, d / 2 + 0.0003), (-0.1 * w, 0.1 * w), (0.16 * h, 0.34 * h), dark)
