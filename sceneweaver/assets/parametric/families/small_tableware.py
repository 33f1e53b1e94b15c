"""What stands on a laid table: plates, bowls, cups, glasses, jugs, bottles, cutlery."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from .small_kit import PROUD, Look, arch, band, decal, dome, loft, orb, slab, small, spot, spun, target

GLAZES = ("white ceramic", "cream ceramic", "blue ceramic", "grey ceramic", "terracotta")


def disc_plate(b: Builder, r: float, h: float, glaze: Look, rim: Look | None = None, z: float = 0.0) -> None:
    """A plate: foot, well, sloping rim with an edge in another glaze."""
    with b.frame(z=z):
        b.lathe(
            [
                (0.55 * r, 0.0),
                (0.6 * r, 0.1 * h),
                (0.66 * r, 0.32 * h),
                (0.97 * r, 0.86 * h),
                (r, h),
                (0.98 * r, h),
                (0.69 * r, 0.48 * h),
                (0.64 * r, 0.3 * h),
                (0.0, 0.27 * h),
            ],
            glaze,
            32,
            hollow=True,
        )
        if rim is not None:
            b.add(_ring_band(0.93 * r, 0.985 * r, 0.86 * h, h + PROUD), rim, [])


def _ring_band(inner: float, outer: float, low: float, high: float):
    return shapes.lathe([(inner, low), (outer, high - 0.0008), (outer, high), (inner, low + 0.0012), (inner, low)], 32)


def fork(b: Builder, x: float, y: float, length: float, metal: Look, z: float = 0.0) -> None:
    """A fork that lies along x, its tines forward."""
    with b.frame(x, y, z):
        _handle(b, length, metal)
        n = length / 0.2
        b.hull(
            [
                (px * n, py, pz)
                for px, w, lo, hi in (
                    (0.125, 0.003, 0.001, 0.004),
                    (0.145, 0.011, 0.0, 0.003),
                    (0.155, 0.0115, 0.0, 0.003),
                )
                for py in (-w, w)
                for pz in (lo, hi)
            ],
            metal,
        )
        for k in range(4):
            ty = -0.0095 + k * 0.0063
            b.hull(
                [
                    (px * n, ty + s * wy, pz)
                    for px, wy, lo, hi in (
                        (0.154, 0.002, 0.0, 0.003),
                        (0.18, 0.0018, 0.0, 0.003),
                        (0.2, 0.0008, 0.003, 0.005),
                    )
                    for s in (-1, 1)
                    for pz in (lo, hi)
                ],
                metal,
            )


def knife(b: Builder, x: float, y: float, length: float, metal: Look, z: float = 0.0, grip: Look | None = None) -> None:
    """A table knife that lies along x."""
    n = length / 0.2
    with b.frame(x, y, z):
        b.hull(
            [
                (px * n, py, pz)
                for px, w in ((0.0, 0.006), (0.004, 0.008), (0.085, 0.006))
                for py in (-w, w)
                for pz in (0.0, 0.006)
            ],
            grip or metal,
        )
        outline = [(0.085, -0.006), (0.195, -0.004), (0.2, 0.002), (0.19, 0.0085), (0.1, 0.0095), (0.085, 0.006)]
        b.hull([(px * n, py, pz) for px, py in outline for pz in (0.001, 0.003)], metal)


def spoon(b: Builder, x: float, y: float, length: float, metal: Look, z: float = 0.0) -> None:
    """A spoon that lies along x, its bowl forward."""
    n = length / 0.2
    with b.frame(x, y, z):
        _handle(b, length, metal)
        with b.frame(x=0.172 * n):
            spun(
                b,
                [(0.006, 0.0), (0.015, 0.0035), (0.0195, 0.008), (0.0183, 0.0078), (0.013, 0.004), (0.0, 0.002)],
                metal,
                1.45 * n,
                1.0,
                16,
                hollow=True,
            )


def _handle(b: Builder, length: float, metal: Look) -> None:
    n = length / 0.2
    cuts = [(0.0, 0.0075, 0.0), (0.012, 0.009, 0.0), (0.05, 0.006, 0.003), (0.11, 0.0028, 0.005), (0.15, 0.0035, 0.002)]
    for (x0, w0, z0), (x1, w1, z1) in zip(cuts[:-1], cuts[1:], strict=True):
        b.hull(
            [
                (px * n, s * w, pz + t)
                for px, w, pz in ((x0, w0, z0), (x1, w1, z1))
                for s in (-1, 1)
                for t in (0.0, 0.0025)
            ],
            metal,
        )


def goblet(b: Builder, r: float, h: float, foot: float, stem: float, drink: Look | None = None, flute: float = 0.9):
    """A stemmed glass: foot, stem, bowl, and perhaps some wine in it."""
    bowl = h - stem
    b.lathe(
        [
            (foot, 0.0),
            (foot, 0.002),
            (0.3 * foot, 0.006),
            (0.0038, 0.016),
            (0.0035, stem - 0.012),
            (0.007, stem - 0.002),
            (0.55 * r, stem + 0.09 * bowl),
            (0.9 * r, stem + 0.3 * bowl),
            (r, stem + 0.5 * bowl),
            (0.97 * r, stem + 0.72 * bowl),
            (flute * r, h),
            (flute * r - 0.0015, h),
            (0.96 * r - 0.0015, stem + 0.72 * bowl),
            (r - 0.0018, stem + 0.5 * bowl),
            (0.9 * r - 0.002, stem + 0.3 * bowl),
            (0.5 * r, stem + 0.1 * bowl),
            (0.0, stem + 0.03 * bowl),
        ],
        "glass",
        24,
        hollow=True,
    )
    if drink is not None:
        b.add(_wine(r, stem, bowl), drink, [])


def _wine(r: float, stem: float, bowl: float):
    return shapes.lathe(
        [
            (0.45 * r, stem + 0.11 * bowl),
            (0.87 * r - 0.002, stem + 0.3 * bowl),
            (0.94 * r - 0.003, stem + 0.4 * bowl),
            (0.0, stem + 0.4 * bowl),
        ],
        24,
    )


def tumbler(b: Builder, r: float, h: float, low: float = 0.82, drink: Look | None = None, look: Look = "glass") -> None:
    """A drinking glass with a thick foot."""
    b.lathe(
        [(low * r - 0.002, 0.0), (low * r, 0.002), (r, h), (r - 0.0018, h), (low * r - 0.002, 0.01), (0.0, 0.009)],
        look,
        24,
        hollow=True,
    )
    if drink is not None:
        level = 0.7 * h
        at = low * r + (r - low * r) * 0.7
        b.add(shapes.frustum(low * r - 0.0025, at - 0.0025, (0.011, level), 24), drink, [])


def cup(b: Builder, r: float, h: float, glaze: Look, drink: Look | None, grip: float, foot: float = 0.55) -> None:
    """A tea cup with a small handle at -y."""
    b.lathe(
        [
            (foot * r, 0.0),
            (foot * r, 0.003),
            (0.86 * r, 0.35 * h),
            (0.97 * r, 0.7 * h),
            (r, h),
            (r - 0.002, h),
            (0.97 * r - 0.003, 0.7 * h),
            (0.83 * r, 0.36 * h),
            (0.5 * r, 0.06 * h + 0.002),
            (0.0, 0.06 * h),
        ],
        glaze,
        24,
        hollow=True,
    )
    if drink is not None:
        spot(b, 0.94 * r - 0.003, (0.66 * h, 0.72 * h), drink, 24)
    arch(b, (0, -0.985 * r, 0.82 * h), (0, -0.88 * r, 0.34 * h), (0, -grip, 0), 0.0032, glaze)


@small("plate", fit="round")
def plate(b: Builder) -> None:
    """A dinner plate."""
    d, _, h = target(b)
    glaze = b.material("body", *GLAZES)
    rim = b.material("rim", "blue ceramic", "grey ceramic", "brass", "terracotta") if b.chance("rim", 0.5) else None
    disc_plate(b, d / 2, h, glaze, rim)


@small("plate_stack", fit="round")
def plate_stack(b: Builder) -> None:
    """Plates in a pile, smaller ones on top."""
    d, _, h = target(b)
    glaze, other = b.material("body", *GLAZES), b.material("other", *GLAZES)
    count = max(3, round((h - 0.015) / 0.0075))
    step = (h - 0.022) / (count - 1)
    for k in range(count):
        small_one = k >= count * 0.6
        disc_plate(b, d / 2 * (0.78 if small_one else 1.0), 0.022, other if small_one else glaze, None, k * step)


@small("bowl", fit="round")
def bowl(b: Builder) -> None:
    """An open bowl on a foot ring, in some a band of another glaze or cereals."""
    d, _, h = target(b)
    r = d / 2
    glaze = b.material("body", *GLAZES)
    inside = b.material("inside", "white ceramic", "cream ceramic", "blue ceramic")
    f = b.uniform("foot", 0.42, 0.55)
    b.lathe(
        [
            (f * r, 0.0),
            (f * r, 0.06 * h),
            (0.72 * r, 0.26 * h),
            (0.92 * r, 0.6 * h),
            (r, h),
            (r - 0.003, h),
            (0.9 * r - 0.003, 0.6 * h),
            (0.68 * r, 0.29 * h),
            (0.4 * r, 0.14 * h),
            (0.0, 0.13 * h),
        ],
        glaze,
        28,
        hollow=True,
    )
    if b.chance("full", 0.35):
        food = b.pick("food", ["bread crust", "carrot", "lettuce", "tomato"])
        b.add(
            shapes.lathe([(0.6 * r, 0.3 * h), (0.9 * r - 0.003, 0.62 * h), (0.7 * r, 0.7 * h), (0.0, 0.74 * h)], 24),
            food,
            [],
        )
    else:
        spot(b, 0.45 * r, (0.14 * h, 0.16 * h), inside, 24)


@small("mug")
def mug(b: Builder) -> None:
    """A straight mug with a big handle, half full of coffee."""
    d, w, h = b.size
    r = d / 2
    glaze = b.material("body", *GLAZES, "white ceramic")
    low = b.uniform("taper", 0.82, 1.0)
    b.lathe(
        [
            (low * r - 0.004, 0.0),
            (low * r, 0.004),
            (r, 0.97 * h),
            (r - 0.0015, h),
            (r - 0.0035, h),
            (low * r - 0.004, 0.008),
            (0.0, 0.007),
        ],
        glaze,
        28,
        hollow=True,
    )
    if b.chance("drink", 0.6):
        spot(b, 0.9 * r, (0.8 * h, 0.84 * h), "coffee", 24)
    if b.chance("band", 0.4):
        stripe = b.material("stripe", "blue ceramic", "grey ceramic", "terracotta", "white ceramic")
        at = b.uniform("stripe at", 0.15, 0.3)
        lo, hi = (low * r + (r - low * r) * s for s in (at, at + 0.2))
        band(b, lo, hi, (at * h, (at + 0.2) * h), stripe, 28)
    n = np.array([[-0.004, -0.003], [0.004, -0.003], [0.0055, 0.0], [0.004, 0.003], [-0.004, 0.003], [-0.0055, 0.0]])
    arch(
        b,
        (0, -0.95 * r, 0.84 * h),
        (0, -0.92 * low * r - 0.001, 0.2 * h),
        (0, -(w - d) + 0.002 - 0.04 * r, 0),
        n,
        glaze,
        8,
    )


@small("cup_and_saucer", fit="round")
def cup_and_saucer(b: Builder) -> None:
    """A cup with tea or coffee on its saucer, and a little spoon."""
    d, _, h = target(b)
    glaze = b.material("body", "white ceramic", "cream ceramic", "blue ceramic", "grey ceramic")
    rim = b.material("rim", "brass", "blue ceramic") if b.chance("rim", 0.5) else None
    disc_plate(b, d / 2, 0.018, glaze, rim)
    with b.frame(z=0.0055):
        cup(b, 0.29 * d, h - 0.0055, glaze, b.pick("drink", ["coffee", "amber glass"]), 0.13 * d)
    spoon(b, -0.3 * d, 0.36 * d, 0.6 * d, "steel", z=0.011)


@small("drinking_glass", fit="round")
def drinking_glass(b: Builder) -> None:
    """A tumbler, in some with water or juice."""
    d, _, h = target(b)
    look = b.material("body", "glass")
    drink = b.pick("drink", [None, "frosted glass", "orange peel", None])
    tumbler(b, d / 2, h, b.uniform("taper", 0.72, 0.95), drink, look)


@small("wine_glass", fit="round")
def wine_glass(b: Builder) -> None:
    """A stemmed glass, in some with red or white wine."""
    d, _, h = target(b)
    b.material("body", "glass")
    drink = b.pick("drink", [None, "aubergine", "lemon peel"])
    goblet(b, d / 2, h, 0.44 * d, b.uniform("stem", 0.42, 0.5) * h, drink, b.uniform("mouth", 0.72, 0.85))


@small("champagne_flute", fit="round")
def champagne_flute(b: Builder) -> None:
    """A tall slim glass on a stem."""
    d, _, h = target(b)
    b.material("body", "glass")
    r = d / 2
    s = 0.36 * h
    b.lathe(
        [
            (r, 0.0),
            (r, 0.002),
            (0.3 * r, 0.006),
            (0.0035, 0.014),
            (0.0032, s - 0.01),
            (0.006, s),
            (0.6 * r, s + 0.12 * h),
            (0.82 * r, s + 0.3 * h),
            (0.8 * r, h),
            (0.8 * r - 0.0013, h),
            (0.82 * r - 0.0015, s + 0.3 * h),
            (0.58 * r - 0.001, s + 0.125 * h),
            (0.0, s + 0.02 * h),
        ],
        "glass",
        24,
        hollow=True,
    )
    if b.chance("drink", 0.6):
        b.add(
            shapes.lathe(
                [
                    (0.1 * r, s + 0.035 * h),
                    (0.56 * r - 0.001, s + 0.125 * h),
                    (0.8 * r - 0.003, s + 0.3 * h),
                    (0.8 * r - 0.003, s + 0.45 * h),
                    (0.0, s + 0.45 * h),
                ],
                24,
            ),
            "lemon peel",
            [],
        )


@small("teapot")
def teapot(b: Builder) -> None:
    """A round pot with spout, handle, and lid with a knob."""
    d, w, h = b.size
    r = d / 2
    glaze = b.material("body", *GLAZES, "iron")
    knob = b.material("knob", "bamboo", "white ceramic", "brass") if b.chance("knob other", 0.4) else glaze
    top = 0.74 * h
    b.lathe(
        [
            (0.6 * r, 0.0),
            (0.62 * r, 0.02 * h),
            (0.88 * r, 0.14 * h),
            (r, 0.36 * h),
            (0.93 * r, 0.55 * h),
            (0.7 * r, 0.69 * h),
            (0.52 * r, top),
        ],
        glaze,
        28,
    )
    b.lathe(
        [
            (0.54 * r, top),
            (0.54 * r, top + 0.025 * h),
            (0.3 * r, top + 0.1 * h),
            (0.08 * r, top + 0.12 * h),
            (0.07 * r, top + 0.15 * h),
        ],
        glaze,
        24,
    )
    with b.frame(z=top + 0.14 * h):
        b.lathe([(0.07 * r, 0.0), (0.14 * r, 0.05 * h), (0.11 * r, 0.1 * h), (0.04 * r, 0.12 * h)], knob, 16)
    reach = (w - d) / 2
    n = 16
    sizes, rings = [(0.9, 0.2, 0.32), (1.1, 0.36, 0.2), (1.35, 0.56, 0.13), (1.52, 0.74, 0.1)], []
    for t, z, s in sizes:
        y = r + (t - 1) / 0.52 * reach * 1.0
        a = np.arange(n) * 2 * np.pi / n
        # Sections lean with the spout, which is cut level at its mouth.
        lean = 0.0 if t > 1.5 else 0.6
        rings.append(np.c_[s * r * np.cos(a), y + s * r * np.sin(a), z * h - lean * s * r * np.sin(a)])
    for lo, hi in zip(rings[:-1], rings[1:], strict=True):
        b.hull(np.concatenate([lo, hi]), glaze)
    arch(b, (0, -0.72 * r, 0.64 * h), (0, -0.92 * r, 0.2 * h), (0, -reach - 0.14 * r, 0.04 * h), 0.07 * r, glaze, 8)


def _jug(b: Builder, look: Look, drink: Look | None) -> None:
    d, w, h = b.size
    r = d / 2
    n = 28
    wall = 0.004
    profile = [(0.72, 0.0), (0.86, 0.1), (0.93, 0.3), (0.8, 0.6), (0.66, 0.82), (0.74, 1.0)]
    rings = []
    for s, z in profile + [(p, q) for p, q in profile[::-1][:-1]] + [(0.5, 0.05)]:
        inner = len(rings) >= len(profile)
        rr = s * r - (wall if inner else 0.0)
        t = (np.arange(n) + 0.5) * 2 * np.pi / n
        lip = 0.34 * r * max(0.0, (z - 0.8) / 0.2) * np.exp(-((np.minimum(t, 2 * np.pi - t) - 0.0) ** 2) / 0.06)
        lip = np.roll(lip, n // 4)
        ring = np.c_[(rr + lip) * np.cos(t), (rr + lip) * np.sin(t), np.full(n, z * h)]
        rings.append(ring)
    loft(b, rings, look, hollow=len(profile))
    if drink is not None:
        spot(b, 0.8 * r - 0.006, (0.06 * h, 0.55 * h), drink, 24)
    arch(b, (0, -0.66 * r, 0.9 * h), (0, -0.88 * r, 0.34 * h), (0, -(w - d) * 0.8, 0.03 * h), 0.0075, look, 8)


@small("pitcher")
def pitcher(b: Builder) -> None:
    """A jug with a lip and a handle."""
    look = b.material("body", *GLAZES, "glass", "glass")
    _jug(b, look, b.pick("drink", ["lemon peel", "orange peel", "frosted glass"]) if look.opacity < 1 else None)


@small("carafe", fit="round")
def carafe(b: Builder) -> None:
    """A glass bottle with a waist, water in it, and a cork in some."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "glass")
    b.lathe(
        [
            (0.86 * r, 0.0),
            (r, 0.03 * h),
            (0.97 * r, 0.25 * h),
            (0.5 * r, 0.62 * h),
            (0.4 * r, 0.78 * h),
            (0.56 * r, 0.95 * h),
            (0.54 * r, 0.95 * h),
            (0.38 * r, 0.78 * h),
            (0.47 * r, 0.62 * h),
            (0.93 * r, 0.25 * h),
            (0.93 * r, 0.04 * h),
            (0.0, 0.03 * h),
        ],
        look,
        24,
        hollow=True,
    )
    b.add(
        shapes.lathe([(0.9 * r, 0.035 * h), (0.92 * r, 0.25 * h), (0.62 * r, 0.5 * h), (0.0, 0.5 * h)], 24),
        b.pick("drink", ["frosted glass", "aubergine", "frosted glass"]),
        [],
    )
    b.frustum(0.39 * r, 0.5 * r, (0.8 * h, h), "cork", 20, bevel=0.003)


@small("bottle", fit="round")
def bottle(b: Builder) -> None:
    """A bottle with a label and a cap."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "green glass", "clear plastic", "amber glass", "glass")
    cap = b.material("cap", "blue plastic", "white plastic", "black plastic", "red plastic", "brass")
    shoulder = b.uniform("shoulder", 0.55, 0.66)
    b.lathe(
        [
            (0.85 * r, 0.0),
            (r, 0.025 * h),
            (r, shoulder * h),
            (0.85 * r, (shoulder + 0.08) * h),
            (0.36 * r, (shoulder + 0.2) * h),
            (0.33 * r, 0.95 * h),
        ],
        look,
        24,
    )
    b.frustum(0.4 * r, 0.4 * r, (0.93 * h, h), cap, 20, bevel=0.002)
    paper = b.material("label", "paper", "navy paint", "sage paint", "yellow plastic")
    band(b, r, r, (0.2 * h, 0.45 * h), paper)
    band(b, r + 0.0001, r + 0.0001, (0.3 * h, 0.35 * h), cap)


@small("wine_bottle", fit="round")
def wine_bottle(b: Builder) -> None:
    """A dark bottle with shoulders, a long neck in foil, and a paper label."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "green glass", "green glass", "amber glass")
    foil = b.material("foil", "red paint", "black paint", "brass", "navy paint")
    if b.chance("slender", 0.4):
        body = [
            (0.9 * r, 0.0),
            (r, 0.015 * h),
            (r, 0.42 * h),
            (0.8 * r, 0.55 * h),
            (0.42 * r, 0.72 * h),
            (0.38 * r, 0.98 * h),
        ]
    else:
        body = [
            (0.9 * r, 0.0),
            (r, 0.015 * h),
            (r, 0.58 * h),
            (0.88 * r, 0.64 * h),
            (0.42 * r, 0.72 * h),
            (0.38 * r, 0.98 * h),
        ]
    b.lathe(body, look, 24)
    b.frustum(0.41 * r, 0.39 * r, (0.76 * h, h), foil, 24, bevel=0.001)
    b.frustum(0.43 * r, 0.43 * r, (0.955 * h, 0.985 * h), foil, 24)
    band(b, r, r, (0.12 * h, 0.38 * h), "paper")
    band(b, r + 0.0001, r + 0.0001, (0.3 * h, 0.33 * h), foil)
    band(b, r + 0.0001, r + 0.0001, (0.15 * h, 0.16 * h), foil)


@small("beer_bottle", fit="round")
def beer_bottle(b: Builder) -> None:
    """A brown bottle with a crown cap."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "amber glass", "amber glass", "green glass")
    paper = b.material("label", "red plastic", "yellow plastic", "blue plastic", "paper", "green plastic")
    b.lathe(
        [
            (0.88 * r, 0.0),
            (r, 0.02 * h),
            (r, 0.52 * h),
            (0.85 * r, 0.62 * h),
            (0.48 * r, 0.76 * h),
            (0.4 * r, 0.975 * h),
        ],
        look,
        24,
    )
    b.frustum(0.5 * r, 0.42 * r, (0.965 * h, h), "steel", 21, bevel=0.001)
    band(b, r, r, (0.18 * h, 0.44 * h), paper)
    band(b, r + 0.0001, r + 0.0001, (0.27 * h, 0.35 * h), "paper")
    band(b, 0.465 * r, 0.42 * r, (0.8 * h, 0.9 * h), paper)


@small("salt_and_pepper")
def salt_and_pepper(b: Builder) -> None:
    """Two shakers or mills side by side."""
    d, w, h = b.size
    r = d / 2
    mill = b.chance("mill", 0.5)
    looks = (
        b.material("salt", "beech", "walnut") if mill else b.material("salt", "glass", "white ceramic"),
        b.material("pepper", "wenge", "walnut") if mill else b.material("pepper", "amber glass", "black paint"),
    )
    for side, look in zip((1, -1), looks, strict=True):
        with b.frame(0, side * (w / 2 - r)):
            if mill:
                b.lathe(
                    [
                        (r, 0.0),
                        (r, 0.08 * h),
                        (0.72 * r, 0.16 * h),
                        (0.6 * r, 0.45 * h),
                        (0.85 * r, 0.62 * h),
                        (0.7 * r, 0.7 * h),
                        (0.5 * r, 0.71 * h),
                        (0.5 * r, 0.73 * h),
                        (0.85 * r, 0.76 * h),
                        (0.8 * r, 0.88 * h),
                        (0.4 * r, 0.94 * h),
                    ],
                    look,
                    20,
                )
                b.ball((0.2 * r, 0.2 * r, 0.04 * h), (0, 0, 0.96 * h), "steel", 12)
            else:
                b.lathe([(0.9 * r, 0.0), (r, 0.04 * h), (0.8 * r, 0.72 * h)], look, 20)
                b.lathe(
                    [(0.84 * r, 0.72 * h), (0.84 * r, 0.82 * h), *dome(0.8 * r, 0.84 * h, h, 4, 0.1 * r)], "steel", 20
                )
                spot(b, 0.12 * r, (0.99 * h, h), "black plastic", 8)


@small("cutlery_set")
def cutlery_set(b: Builder) -> None:
    """Fork, knife and spoon lying side by side."""
    d, w, _ = b.size
    metal = b.material("body", "steel", "brushed steel", "brass", "black steel")
    grip = b.material("grip", "oak", "white plastic", "black plastic") if b.chance("grip", 0.3) else None
    fork(b, -d / 2, w / 2 - 0.012, d, metal)
    knife(b, -d / 2, 0.0, d, metal, grip=grip)
    spoon(b, -d / 2, -w / 2 + 0.02, d * 0.96, metal)


@small("place_setting")
def place_setting(b: Builder) -> None:
    """Placemat, plate, bowl or napkin, fork, knife, spoon and a glass, laid for one."""
    d, w, h = b.size
    mat = b.material("mat", "beige fabric", "grey fabric", "navy fabric", "green fabric", "rattan", "rust fabric")
    glaze = b.material("plate", "white ceramic", "cream ceramic", "blue ceramic", "grey ceramic")
    metal = b.material("cutlery", "steel", "brass", "black steel")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.003), mat, 0.012, 0.0008)
    # The guest sits at +x and looks to -x: the fork lies at -y, knife and spoon at +y.
    r = min(0.135, 0.4 * d)
    with b.frame(0.02, 0, 0.003):
        disc_plate(b, r, 0.022, glaze, "brass" if b.chance("gold", 0.3) else None)
        if b.chance("bowl", 0.5):
            with b.frame(z=0.006):
                b.lathe(
                    [
                        (0.3 * r, 0.0),
                        (0.45 * r, 0.012),
                        (0.6 * r, 0.045),
                        (0.58 * r, 0.045),
                        (0.42 * r, 0.016),
                        (0.0, 0.01),
                    ],
                    glaze,
                    24,
                    hollow=True,
                )
        else:
            cloth = b.material("napkin", "white fabric", "mustard fabric", "rose fabric", "blue fabric")
            slab(b, (-0.06, 0.06), (-0.03, 0.03), (0.005, 0.017), cloth, 0.008, 0.004)
            slab(
                b,
                (-0.006, 0.006),
                (-0.032, 0.032),
                (0.006, 0.019),
                "brass" if b.chance("ring", 0.5) else mat,
                0.003,
                0.001,
            )
    for tool, y in ((fork, -r - 0.03), (knife, r + 0.03), (spoon, r + 0.062)):
        with b.frame(0.11, y, 0.003, yaw=np.pi):
            tool(b, 0.0, 0.0, 0.2, metal)
    with b.frame(-d / 2 + 0.045, min(r * 0.9, w / 2 - 0.05), 0.003):
        if b.chance("wine", 0.5):
            goblet(b, 0.037, h - 0.003, 0.033, 0.45 * h, b.pick("drink", [None, "aubergine"]), 0.8)
        else:
            tumbler(b, 0.036, h - 0.003, 0.85, "frosted glass")


@small("placemat")
def placemat(b: Builder) -> None:
    """A mat of cloth or rattan with a hem."""
    d, w, h = b.size
    look = b.material("body", "beige fabric", "grey fabric", "navy fabric", "rattan", "rust fabric", "green fabric")
    hem = b.material("hem", "white fabric", "charcoal fabric", "wicker")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), look, 0.012, 0.001)
    for k in (-1, 1):
        for e in (0.018, 0.026):
            y = k * (w / 2 - e)
            decal(b, (-d / 2 + 0.012, d / 2 - 0.012), (y - 0.002, y + 0.002), (h / 2, h + 0.0004), hem)
            x = k * (d / 2 - e)
            decal(b, (x - 0.002, x + 0.002), (-w / 2 + 0.012, w / 2 - 0.012), (h / 2, h + 0.0004), hem)


@small("napkin_holder")
def napkin_holder(b: Builder) -> None:
    """Napkins between two upright boards on a foot."""
    d, w, h = b.size
    look = b.material("body", "oak", "walnut", "black steel", "white steel", "bamboo")
    napkins = b.material("napkins", "white fabric", "mustard fabric", "blue fabric", "rose fabric")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.01), look, 0.002)
    top = h - 0.012
    for side in (-1, 1):
        x = side * (d / 2 - 0.008)
        with b.frame(x, 0, 0, pitch=np.pi / 2):
            arc = [(-0.01, w / 2), (-0.01, -w / 2)] + [
                (-top + 0.35 * w - 0.35 * w * np.sin(t), -w / 2 * np.cos(t)) for t in np.linspace(0, np.pi, 9)
            ]
            b.extrude(np.array(arc[::-1]), (-0.003, 0.003), look)
    count = b.whole("napkins", 8, 14)
    room = d - 0.024
    for k in range(count):
        x = -room / 2 + (k + 0.5) * room / count
        b.box(
            (x - room / count * 0.46, x + room / count * 0.46),
            (-w / 2 + 0.008, w / 2 - 0.008),
            (0.01, h - 0.004 * (k % 3)),
            napkins,
            0.001,
        )


@small("serving_tray", opened=True)
def serving_tray(b: Builder) -> None:
    """A tray with a low rim and two handles; things may stand in it."""
    d, w, h = b.size
    look = b.material("body", "oak", "walnut", "bamboo", "white paint", "black paint", "brushed steel")
    grip = b.material("handles", "brass", "black steel") if b.chance("metal", 0.5) else look
    t = 0.01
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    rim = min(0.045, 0.8 * h)
    with b.solid("floor"):
        b.box(x, y, (0.0, 0.01), look, 0.002)
    for name, xs, ys in (
        ("left", x, (y[1] - t, y[1])),
        ("right", x, (y[0], y[0] + t)),
        ("front", (x[1] - t, x[1]), (y[0] + t, y[1] - t)),
        ("back", (x[0], x[0] + t), (y[0] + t, y[1] - t)),
    ):
        with b.solid(name):
            b.box(xs, ys, (0.01, rim), look, 0.002)
            if name in ("left", "right"):
                ym = (ys[0] + ys[1]) / 2
                arch(b, (-0.06, ym, rim - 0.005), (0.06, ym, rim - 0.005), (0, 0, h - rim), 0.005, grip, 6)
    b.surface("top", (x[0] + t + 0.004, x[1] - t - 0.004), (y[0] + t + 0.004, y[1] - t - 0.004), 0.01)


@small("cake_stand", fit="round", opened=True)
def cake_stand(b: Builder) -> None:
    """A round plate on a turned foot."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("body", "white ceramic", "cream ceramic", "blue ceramic", "oak", "marble")
    with b.solid("all"):
        b.lathe(
            [
                (0.42 * r, 0.0),
                (0.42 * r, 0.006),
                (0.3 * r, 0.014),
                (0.09 * r, 0.18 * h),
                (0.07 * r, 0.4 * h),
                (0.11 * r, 0.55 * h),
                (0.08 * r, 0.66 * h),
                (0.2 * r, h - 0.016),
                (0.96 * r, h - 0.012),
                (r, h - 0.008),
                (r, h - 0.002),
                (r - 0.002, h),
            ],
            look,
            32,
        )
        if b.chance("dots", 0.5):
            for k in range(16):
                a = k * np.pi / 8
                b.ball((0.006, 0.006, 0.006), (0.97 * r * np.cos(a), 0.97 * r * np.sin(a), h - 0.013), look, 8)
    t = (np.arange(16) + 0.5) * np.pi / 8
    b.surface("top", (0, 0), (0, 0), h, polygon=[(0.95 * r * np.cos(a), 0.95 * r * np.sin(a)) for a in t])


@small("sugar_bowl")
def sugar_bowl(b: Builder) -> None:
    """A small lidded bowl with two ears."""
    d, w, h = b.size
    r = d / 2
    glaze = b.material("body", *GLAZES)
    top = 0.68 * h
    b.lathe([(0.6 * r, 0.0), (0.62 * r, 0.04 * h), (0.96 * r, 0.25 * h), (r, 0.42 * h), (0.9 * r, top)], glaze, 24)
    b.lathe(
        [(0.93 * r, top), (0.93 * r, top + 0.03 * h), (0.4 * r, top + 0.15 * h), (0.1 * r, top + 0.17 * h)], glaze, 24
    )
    orb(b, (0.15 * r, 0.15 * r, 0.09 * h), (0, 0, 0.91 * h), b.pick("knob", ["brass", "white ceramic"]))
    for s in (-1, 1):
        arch(b, (0, s * 0.9 * r, 0.62 * h), (0, s * 0.95 * r, 0.3 * h), (0, s * (w - d) * 0.5, 0), 0.0035, glaze, 6)


@small("egg_cup", fit="round")
def egg_cup(b: Builder) -> None:
    """A boiled egg in its cup."""
    d, _, h = target(b)
    r = d / 2
    glaze = b.material("body", *GLAZES, "beech")
    b.lathe(
        [
            (0.8 * r, 0.0),
            (0.75 * r, 0.05 * h),
            (0.35 * r, 0.2 * h),
            (0.4 * r, 0.28 * h),
            (0.9 * r, 0.45 * h),
            (r, 0.62 * h),
        ],
        glaze,
        24,
    )
    b.ball((0.86 * r, 0.86 * r, 0.33 * h), (0, 0, 0.67 * h), "egg shell", 16)


@small("coaster_set", fit="round")
def coaster_set(b: Builder) -> None:
    """Round coasters in a pile."""
    d, _, h = target(b)
    look = b.material("body", "cork", "oak", "marble", "grey fabric", "black leather", "bamboo")
    count = max(3, round(h / 0.007))
    step = h / count
    for k in range(count):
        with b.frame(b.uniform(f"x{k}", -0.02, 0.02) * d, b.uniform(f"y{k}", -0.02, 0.02) * d, k * step):
            b.frustum(0.47 * d, 0.47 * d, (0.0, step * 0.94), look, 28, bevel=0.0012)
