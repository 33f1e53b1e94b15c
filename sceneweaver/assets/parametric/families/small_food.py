"""Food and its packets."""

from __future__ import annotations

import numpy as np

from ... import shapes
from ..builder import Builder
from .small_kit import Look, decal, ellipse, hoop, loft, lofted, orb, rect, slab, small, spot, target


def apple_at(b: Builder, r: float, look: Look, at=(0.0, 0.0, 0.0), stem: bool = True) -> None:
    """An apple whose foot is at ``at``: a waist at the stem, a stalk and a leaf."""
    with b.frame(*at):
        b.lathe(
            [
                (0.3 * r, 0.0),
                (0.62 * r, 0.12 * r),
                (0.88 * r, 0.5 * r),
                (r, 1.0 * r),
                (0.93 * r, 1.4 * r),
                (0.68 * r, 1.68 * r),
                (0.4 * r, 1.74 * r),
                (0.12 * r, 1.6 * r),
                (0.0, 1.5 * r),
            ],
            look,
            18,
            hollow=True,
        )
        if stem:
            b.bar((0, 0, 1.5 * r), (0.1 * r, 0.06 * r, 2.0 * r), 0.05 * r, "bark", 6)


def orange_at(b: Builder, r: float, at=(0.0, 0.0, 0.0), look: Look = "orange peel") -> None:
    """An orange or a lemon whose foot is at ``at``."""
    x, y, z = at
    long = 1.25 if look == "lemon peel" else 1.0
    orb(b, (r, long * r, r), (x, y, z + r), look, 12)
    with b.frame(x, y, z + 1.95 * r):
        b.add(shapes.frustum(0.09 * r, 0.07 * r, (-0.06 * r, 0.03 * r), 6), "dark leaf", [])


def banana_at(b: Builder, length: float, r: float) -> None:
    """A banana on the plane, bent about z, its stalk at the origin."""
    t = np.linspace(-0.75, 0.75, 8)
    big = length / 1.5
    path = np.c_[big * (np.cos(t) - np.cos(0.75)), big * (np.sin(t) + np.sin(0.75)), np.full(8, r)]
    n = 6
    a = np.arange(n) * 2 * np.pi / n
    rings = []
    for k, (p, s) in enumerate(zip(path, (0.32, 0.4, 0.92, 1.0, 1.0, 0.95, 0.7, 0.25), strict=True)):
        way = np.array([-np.sin(t[k]), np.cos(t[k]), 0.0])
        left = np.array([-way[1], way[0], 0.0])
        rings.append(p + s * r * (np.outer(np.cos(a), left) + np.outer(np.sin(a), [0, 0, 1])))
    for k, (lo, hi) in enumerate(zip(rings[:-1], rings[1:], strict=True)):
        look = "pale leaf" if k == 0 else "bark" if k == 6 else "banana peel"
        b.add(lofted([lo, hi]) if _turns(lo, hi) else lofted([hi, lo]), look, [shapes.hull(np.concatenate([lo, hi]))])


def _turns(lo: np.ndarray, hi: np.ndarray) -> bool:
    normal = np.cross(lo[1] - lo[0], lo[2] - lo[1])
    return float(normal @ (hi.mean(axis=0) - lo.mean(axis=0))) > 0


@small("fruit_bowl", fit="round")
def fruit_bowl(b: Builder) -> None:
    """A shallow bowl heaped with apples, oranges, lemons, and bananas or grapes."""
    d, _, h = target(b)
    r = d / 2
    look = b.material("bowl", "white ceramic", "walnut", "oak", "blue ceramic", "grey ceramic", "brass")
    rim = 0.55 * h
    b.lathe(
        [
            (0.4 * r, 0.0),
            (0.42 * r, 0.08 * h),
            (0.75 * r, 0.25 * rim + 0.03),
            (0.95 * r, 0.7 * rim),
            (r, rim),
            (r - 0.004, rim),
            (0.9 * r, 0.7 * rim),
            (0.7 * r, 0.3 * rim + 0.03),
            (0.0, 0.1 * h),
        ],
        look,
        28,
        hollow=True,
    )
    f = 0.255 * r
    order = ["red apple", "orange peel", "green apple", "lemon peel", "orange peel", "red apple"]
    turn = b.uniform("turn", 0, 6)
    for k in range(6):
        a = turn + k * np.pi / 3
        at = (0.6 * r * np.cos(a), 0.6 * r * np.sin(a), rim - 1.0 * f)
        if "apple" in order[k]:
            apple_at(b, f, order[k], at)
        else:
            orange_at(b, 0.95 * f, at, order[k])
    top = h - 2 * f
    apple_at(b, 0.97 * f, b.pick("top", ["red apple", "green apple"]), (0.1 * r, -0.05 * r, top))
    if b.chance("bananas", 0.6):
        for k in range(3):
            with b.frame(-0.5 * r + 0.1 * r * k, -0.62 * r, top + 0.1 * f, yaw=0.25 - 0.28 * k, pitch=0.1):
                banana_at(b, 1.15 * r, 0.15 * r)
    else:
        for k in range(14):
            a, q = 2.4 * k, 0.1 * r * np.sqrt(k)
            orb(
                b,
                (0.1 * r, 0.1 * r, 0.1 * r),
                (-0.42 * r + q * np.cos(a) * 0.7, 0.3 * r + q * np.sin(a), top + 0.22 * r - 0.004 * k),
                "grape",
                8,
            )


@small("apple", fit="round")
def apple(b: Builder) -> None:
    """An apple with a stalk and a leaf."""
    d, _, _ = target(b)
    r = d / 2
    apple_at(b, r, b.material("body", "red apple", "green apple", "lemon peel"))
    b.hull(
        [
            (0.05 * r, 0.05 * r, 1.8 * r),
            (0.4 * r, 0.26 * r, 1.86 * r),
            (0.3 * r, 0.46 * r, 1.9 * r),
            (0.75 * r, 0.6 * r, 1.82 * r),
            (0.4 * r, 0.36 * r, 1.94 * r),
        ],
        "dark leaf",
    )


@small("banana_bunch")
def banana_bunch(b: Builder) -> None:
    """Four or five bananas joined at their stalks."""
    _, w, _ = b.size
    b.material("body", "banana peel")
    count = b.whole("count", 4, 5)
    for k in range(count):
        up = max(0, k - 2)
        with b.frame(0.006 * k, 0, 0.012 * up, yaw=(0.6, 0.1, -0.4, 0.32, -0.12)[k], roll=-0.016 * up / w):
            banana_at(b, 0.9 * w, 0.017)
    b.hull([(x, y, z) for x in (-0.006, 0.02) for y in (-0.008, 0.014) for z in (0.012, 0.036)], "bark")


@small("orange", fit="cube")
def orange(b: Builder) -> None:
    """An orange."""
    d, _, _ = target(b)
    look = b.material("body", "orange peel")
    b.ball((d / 2, d / 2, d / 2), (0, 0, d / 2), look, 18)
    with b.frame(z=0.985 * d):
        b.add(shapes.frustum(0.07 * d, 0.05 * d, (-0.03 * d, 0.012 * d), 6), "dark leaf", [])


@small("bread_loaf")
def bread_loaf(b: Builder) -> None:
    """A loaf with cuts across its crust; of some, the first slices lie cut."""
    d, w, h = b.size
    crust = b.material("body", "bread crust")
    n = 18
    sliced = b.chance("sliced", 0.5)
    start = -w / 2 + (0.3 * w if sliced else 0.0)
    long = w / 2 - start
    _bread(b, d, h, start, start + long, crust, n, 0.0 if sliced else 0.6)
    if sliced:
        b.add(_slice(0.46 * d, 0.46 * h, h * 0.5, start - 0.0003, start + 0.004, n), "bread crumb", [])
        for k in range(3):
            y = -w / 2 + 0.005 + k * 0.1 * w
            with b.frame(0, y, 0.0):
                piece = _slice(0.5 * d, 0.5 * h, h * 0.5, 0.0, 0.055 * w, n)
                b.add(piece, crust, [shapes.hull(piece[0])])
                b.add(_slice(0.46 * d, 0.46 * h, h * 0.5, -0.0003, 0.0555 * w, n), "bread crumb", [])
    for k in range(4):
        y = start + long * (0.3 + 0.13 * k)
        with b.frame(0, y, 0.93 * h, yaw=0.5):
            b.box((-0.2 * d, 0.2 * d), (-0.006, 0.006), (-0.08 * h, 0.066 * h), "bread crumb", 0.003)


def _section(rx: float, rz: float, zc: float, y: float, n: int) -> np.ndarray:
    """A bread's upright section, flat below, clockwise in (x, z) so that it is counter-clockwise about +y."""
    t = np.arange(n) * 2 * np.pi / n
    x = rx * np.sign(np.cos(t)) * np.abs(np.cos(t)) ** 0.6
    z = zc + rz * np.sign(np.sin(t)) * np.abs(np.sin(t)) ** (0.5 + 0.35 * (np.sin(t) > 0))
    return np.c_[x, np.full(n, y), z][::-1]


def _slice(rx: float, rz: float, zc: float, y0: float, y1: float, n: int) -> shapes.convex.Shape:
    return lofted([_section(rx, rz, zc, y0, n), _section(rx, rz, zc, y1, n)])


def _bread(b: Builder, d: float, h: float, y0: float, y1: float, crust: Look, n: int, blunt: float) -> None:
    cuts = [
        (0.0, 1.0 if blunt == 0 else 0.55),
        (0.06, 1.0 if blunt == 0 else 0.82),
        (0.2, 1.0),
        (0.8, 1.0),
        (0.94, 0.82),
        (1.0, 0.55),
    ]
    rings = [_section(0.5 * d * s, 0.5 * h * s, 0.5 * h * s, y0 + t * (y1 - y0), n) for t, s in cuts]
    shape = lofted(rings)
    b.add(shape, crust, [shapes.hull(shape[0])])


@small("cake", fit="round")
def cake(b: Builder) -> None:
    """A round cake on a plate with icing, layers and berries; a wedge is cut out of some."""
    d, _, h = target(b)
    r = 0.42 * d
    base = b.material("body", "icing", "chocolate", "pink icing", "cake sponge")
    trim = b.material("trim", "icing", "pink icing", "chocolate")
    b.lathe(
        [(0.36 * d, 0.0), (0.5 * d, 0.008), (0.5 * d, 0.012), (0.36 * d, 0.01), (0.0, 0.01)],
        "white ceramic",
        32,
        hollow=True,
    )
    top = 0.84 * h
    cut = b.chance("cut", 0.6)
    n, a0 = 24, (0.55 if cut else 0.0)
    layers = [
        ("cake sponge", 0.01, 0.26),
        (trim, 0.26, 0.3),
        ("cake sponge", 0.3, 0.55),
        (trim, 0.55, 0.59),
        ("cake sponge", 0.59, 0.8),
    ]
    if cut:
        angles = np.linspace(a0, 2 * np.pi - a0 * 0.3, n)
        half = n // 2
        for part in (angles[: half + 1], angles[half:]):
            outline = np.r_[[(0.0, 0.0)], np.c_[r * np.cos(part), r * np.sin(part)]]
            inner = outline * 0.985
            for look, lo, hi in layers:
                b.extrude(inner, (max(0.01, lo * top), hi * top), look)
            skin = np.c_[r * np.cos(part), r * np.sin(part)]
            for k in range(len(part) - 1):
                quad = np.array([skin[k] * 0.97, skin[k], skin[k + 1], skin[k + 1] * 0.97])
                b.add(shapes.extrusion(quad, (0.01, top)), base, [])
            b.extrude(outline, (0.8 * top, top), base)
            _ghost(b, outline, (0.01, 0.8 * top))
    else:
        b.frustum(r, r, (0.01, top), base, 32, bevel=0.005)
        for z in (0.012, 0.5 * top):
            hoop(b, r * 0.99, z + 0.005, 0.005, trim, 24)
    count = 12
    for k in range(count):
        a = 2 * np.pi * (k + 0.5) / count
        if cut and (a < a0 + 0.12 or a > 2 * np.pi - 0.3 * a0 - 0.12):
            continue
        with b.frame(0.8 * r * np.cos(a), 0.8 * r * np.sin(a), top - 0.001):
            b.lathe([(0.1 * r, 0.0), (0.1 * r, 0.01), (0.0, 0.022)], trim, 8)
            b.ball(
                (0.075 * r, 0.075 * r, 0.5 * (h - top - 0.012)),
                (0, 0, h - top - 0.5 * (h - top - 0.012)),
                "red apple",
                8,
            )


def _ghost(b: Builder, outline: np.ndarray, z: tuple[float, float]) -> None:
    """A part without a look of its own: a thin core that brings the outline's part along."""
    core = shapes.extrusion(outline * 0.5, z)
    b.add(core, "cake sponge", [shapes.extrusion(p, z) for p in shapes.convex_pieces(outline)])


@small("pizza", fit="round")
def pizza(b: Builder) -> None:
    """A pizza on a board, with tomato, cheese, slices of salami and leaves of basil."""
    d, _, h = target(b)
    r = d / 2
    wood = b.material("board", "beech", "oak", "walnut", "white ceramic")
    b.frustum(r, r, (0.0, 0.45 * h), wood, 36, bevel=0.002)
    p = 0.9 * r
    low = 0.45 * h
    b.lathe(
        [
            (0.95 * p, low),
            (p, low + 0.2 * h),
            (0.97 * p, low + 0.42 * h),
            (0.9 * p, low + 0.42 * h),
            (0.86 * p, low + 0.25 * h),
            (0.0, low + 0.25 * h),
        ],
        "bread crust",
        32,
        hollow=True,
    )
    spot(b, 0.87 * p, (low, low + 0.3 * h), "tomato", 30)
    spot(b, 0.8 * p, (low, low + 0.34 * h), "cheese", 14)
    for k in range(9):
        a, q = 2.4 * k, (0.2 + 0.075 * k) * p
        with b.frame(q * np.cos(a), q * np.sin(a), low):
            spot(b, 0.1 * p, (0.0, 0.4 * h), "red apple", 12)
    for k in range(6):
        a, q = 1.2 + 2.4 * k * 1.3, (0.25 + 0.09 * k) * p
        with b.frame(q * np.cos(a), q * np.sin(a), low + 0.4 * h, yaw=a):
            b.add(
                shapes.hull(np.array([(-0.02, 0, 0), (0.02, 0, 0), (0, 0.01, 0), (0, -0.01, 0), (0, 0, 0.0007)])),
                "dark leaf",
                [],
            )
    for k in range(3):
        with b.frame(z=0.0, yaw=k * np.pi / 3):
            b.add(shapes.box((-0.97 * p, 0.97 * p), (-0.001, 0.001), (low, low + 0.41 * h)), "bread crumb", [])


@small("cheese_board")
def cheese_board(b: Builder) -> None:
    """A board with a wedge and a wheel of cheese, grapes, ham and a knife."""
    d, w, h = b.size
    wood = b.material("board", "oak", "walnut", "beech", "marble")
    t = 0.018
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, t), wood, 0.02, 0.003, 4)
    u = h - t
    # A wedge with holes, a soft wheel with a piece cut out.
    wedge = np.array([(-0.02, -0.02), (0.09, 0.005), (0.085, 0.05), (0.06, 0.08)]) * min(1.0, d / 0.24)
    with b.frame(-0.25 * d, -0.36 * w, t):
        b.extrude(wedge, (0.0, u), "cheese")
        for x, y, z in ((0.02, -0.0105, 0.6), (0.05, -0.004, 0.35), (0.075, 0.002, 0.7)):
            with b.frame(x * min(1.0, d / 0.24), y * min(1.0, d / 0.24), z * u, pitch=np.pi / 2, yaw=-1.347):
                b.add(shapes.frustum(0.005, 0.005, (-0.003, 0.0003), 8), "mustard fabric", [])
    with b.frame(-0.12 * d, 0.2 * w, t):
        rr = min(0.055, 0.2 * w)
        a = np.linspace(0.4, 2 * np.pi - 0.4, 18)
        for part in (a[:10], a[9:]):
            b.extrude(np.r_[[(0.0, 0.0)], np.c_[rr * np.cos(part), rr * np.sin(part)]], (0.0, 0.75 * u), "soft cheese")
    for k in range(14):
        a, q = 2.4 * k, 0.008 * np.sqrt(k)
        orb(
            b,
            (0.0095, 0.0095, 0.0095),
            (0.25 * d + q * np.cos(a), 0.06 * w + 1.5 * q * np.sin(a), t + 0.009 + 0.012 * (k < 5)),
            "grape",
            8,
        )
    for k in range(3):
        with b.frame(0.3 * d, -0.32 * w + 0.035 * k, t, yaw=0.3 * k):
            b.frustum(0.024, 0.022, (0.0, 0.006 + 0.003 * k), "ham", 12)
    with b.frame(0.1 * d, 0.36 * w, t, yaw=0.2):
        b.box((0.0, 0.09), (-0.008, 0.008), (0.0, 0.013), "walnut", 0.004)
        b.hull([(x, y, z) for x, y in ((0.085, -0.005), (0.085, 0.005), (0.0, 0.0)) for z in (0.004, 0.006)], "steel")
        b.hull(
            [
                (-x, y, z)
                for x, y in ((-0.005, -0.01), (0.085, -0.012), (0.1, 0.008), (-0.005, 0.009))
                for z in (0.003, 0.006)
            ],
            "steel",
        )


@small("cereal_box")
def cereal_box(b: Builder) -> None:
    """A bright carton with a bowl of cereals on its front."""
    d, w, h = b.size
    look = b.material("body", "yellow plastic", "red plastic", "blue plastic", "green plastic", "orange plastic")
    other = b.material("print", "white plastic", "red paint", "yellow paint", "navy paint")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, h), look, 0.001)
    x = (0.0, d / 2 + 0.0003)
    decal(b, x, (-0.4 * w, 0.4 * w), (0.72 * h, 0.9 * h), other)
    for k, (y0, y1) in enumerate(((-0.32, -0.18), (-0.12, 0.06), (0.1, 0.3))):
        decal(b, (0.0, d / 2 + 0.0004), (y0 * w, y1 * w), (0.77 * h, (0.84 + 0.02 * (k % 2)) * h), look)
    with b.frame(d / 2, 0, 0.3 * h, pitch=np.pi / 2):
        b.add(shapes.frustum(0.3 * w, 0.3 * w, (-0.002, 0.0002), 24), "white plastic", [])
        for k in range(14):
            a, q = 2.4 * k, 0.065 * w * np.sqrt(k)
            with b.frame(q * np.cos(a), q * np.sin(a)):
                b.add(
                    shapes.frustum(0.045 * w, 0.045 * w, (-0.001, 0.0004), 8), "bread crust" if k % 3 else "cheese", []
                )
    decal(b, (-d * 0.3, d * 0.3), (w / 2 - 0.002, w / 2 + 0.0003), (0.15 * h, 0.6 * h), other)
    decal(b, (-0.001, 0.001), (-w / 2 + 0.004, w / 2 - 0.004), (h - 0.001, h + 0.0003), "cardboard")


@small("milk_carton")
def milk_carton(b: Builder) -> None:
    """A carton with a gable top and a screw cap."""
    d, w, h = b.size
    look = b.material("body", "white plastic", "blue plastic", "cream paint")
    other = b.material("print", "blue plastic", "green plastic", "red plastic", "navy paint")
    eave, ridge = 0.78 * h, 0.93 * h
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.0, eave), look, 0.001)
    b.hull(
        [(x, y, eave) for x in (-d / 2, d / 2) for y in (-w / 2, w / 2)]
        + [(x, y, ridge) for x in (-0.003, 0.003) for y in (-w / 2, w / 2)],
        look,
    )
    b.box((-0.003, 0.003), (-w / 2, w / 2), (ridge - 0.004, h), look, 0.0)
    wave = (0.0, d / 2 + 0.0003)
    decal(b, wave, (-w / 2 + 0.001, w / 2 - 0.001), (0.05 * h, 0.4 * h), other)
    decal(b, (-d / 2 + 0.001, d / 2 - 0.001), (w / 2 - 0.01, w / 2 + 0.0003), (0.05 * h, 0.4 * h), other)
    decal(b, wave, (-0.3 * w, 0.3 * w), (0.52 * h, 0.66 * h), other)
    lean = float(np.arctan2(d / 2, ridge - eave))
    with b.frame(0.25 * d, 0, (eave + ridge) / 2 - 0.001, pitch=np.pi / 2 - lean):
        b.frustum(0.18 * d, 0.17 * d, (0.0, 0.012), other, 16, bevel=0.001)


@small("egg_carton")
def egg_carton(b: Builder) -> None:
    """An open carton with ten or twelve eggs."""
    d, w, h = b.size
    look = b.material("body", "cardboard", "grey fabric", "sage paint")
    low = 0.5 * h
    rings = [rect((-d / 2 + e, d / 2 - e), (-w / 2 + e, w / 2 - e), z, 0.012, 2) for e, z in ((0.01, 0.0), (0.0, low))]
    loft(b, rings, look, convex=True)
    cols = 6 if w > 0.27 else 5
    r = min(0.43 * w / cols, 0.21 * d)
    for i in (-1, 1):
        for j in range(cols):
            if b.chance(f"gone {i} {j}", 0.1):
                continue
            y = (j - (cols - 1) / 2) * w / cols
            egg = b.pick(f"egg {i} {j}", ["egg shell", "egg shell", "icing"])
            b.ball((r, r, 0.5 * h), (i * 0.24 * d, y, 0.5 * h), egg, 12)
    for j in range(cols - 1):
        with b.frame(0, (j - (cols - 2) / 2) * w / cols, low):
            b.frustum(0.012, 0.005, (-0.002, 0.6 * (h - low)), look, 8)


@small("vegetable_basket")
def vegetable_basket(b: Builder) -> None:
    """A basket of carrots, tomatoes, a lettuce, an aubergine and bread."""
    d, w, h = b.size
    look = b.material("basket", "wicker", "rattan", "oak", "pine")
    rim = 0.5 * h
    cuts = ((0.14, 0.0), (0.02, 0.9 * rim), (0.0, 0.92 * rim), (0.0, rim), (0.06, rim), (0.16, 0.012))
    rings = [
        rect((-d / 2 + e * d / 2, d / 2 - e * d / 2), (-w / 2 + e * d / 2, w / 2 - e * d / 2), z, 0.05, 3)
        for e, z in cuts
    ]
    loft(b, rings, look, hollow=2)
    for k in range(4):
        z = (0.14 + 0.2 * k) * rim
        e = float(np.interp(z, [0, 0.9 * rim], [0.14, 0.02])) * d / 2
        b.add(
            lofted(
                [
                    rect(
                        (-d / 2 + e - 0.0003, d / 2 - e + 0.0003),
                        (-w / 2 + e - 0.0003, w / 2 - e + 0.0003),
                        zz,
                        0.05,
                        3,
                    )
                    for zz in (z, z + 0.05 * rim)
                ]
            ),
            "bark",
            [],
        )
    u = h - rim
    orb(b, (0.2 * d, 0.2 * d, 0.75 * u), (-0.18 * d, 0.26 * w, rim + 0.25 * u), "lettuce", 10)
    for k in range(6):
        a = k * np.pi / 3
        with b.frame(
            -0.18 * d + 0.13 * d * np.cos(a), 0.26 * w + 0.13 * d * np.sin(a), rim + 0.15 * u, yaw=a, pitch=0.35
        ):
            orb(b, (0.04 * d, 0.12 * d, 0.6 * u), (0, 0, 0), "pale leaf" if k % 2 else "leaf", 8)
    for k, (x, y) in enumerate(((0.22, 0.32), (0.26, 0.12), (0.08, 0.2), (0.16, -0.06))):
        orange_at(b, 0.1 * d, (x * d, y * w, rim - 0.06 * d), "tomato" if k % 3 else "red apple")
    for k in range(4):
        with b.frame(
            -0.3 * d + 0.1 * d * k, -0.05 * w - 0.02 * w * k, rim + 0.1 * u, pitch=np.pi / 2 - 0.12, yaw=-1.3 + 0.16 * k
        ):
            b.lathe([(0.012 * d, 0.0), (0.055 * d, 0.3 * w), (0.045 * d, 0.34 * w)], "carrot", 10)
            b.frustum(0.012 * d, 0.04 * d, (0.33 * w, 0.42 * w), "leaf", 8)
    with b.frame(0.3 * d, -0.24 * w, rim + 0.16 * u, pitch=np.pi / 2, yaw=1.9):
        b.lathe(
            [
                (0.03 * d, -0.2 * w),
                (0.09 * d, -0.16 * w),
                (0.1 * d, -0.06 * w),
                (0.06 * d, 0.1 * w),
                (0.03 * d, 0.14 * w),
            ],
            "aubergine",
            12,
        )


@small("pumpkin", fit="round")
def pumpkin(b: Builder) -> None:
    """A ribbed pumpkin with a woody stalk."""
    d, _, h = target(b)
    look = b.material("body", "pumpkin skin", "pumpkin skin", "cream paint", "sage paint")
    body = 0.86 * h
    n = 9
    r = d / 2
    for k in range(n):
        a = k * 2 * np.pi / n
        shape = shapes.ball((0.42 * r, 0.4 * r, body / 2), (0.58 * r, 0, body / 2), 12)
        with b.frame(yaw=a):
            b.add(shape, look)
    with b.frame(z=body - 0.12 * h):
        b.lathe([(0.22 * r, 0.0), (0.1 * r, 0.06 * h), (0.07 * r, 0.2 * h)], "bark", 8)
        b.bar((0, 0, 0.18 * h), (0.1 * r, 0.06 * r, 0.26 * h), 0.07 * r, "bark", 8)


@small("sandwich")
def sandwich(b: Builder) -> None:
    """Two triangles of bread with ham, cheese, lettuce and tomato, on a plate."""
    d, w, h = b.size
    glaze = b.material("plate", "white ceramic", "blue ceramic", "grey ceramic", "oak")
    slab(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, 0.01), glaze, 0.03, 0.004, 4)
    u = h - 0.01
    layers = [
        ("bread crumb", 0.0, 0.26, 0.0),
        ("lettuce", 0.26, 0.36, -0.005),
        ("ham", 0.36, 0.46, 0.0),
        ("tomato", 0.46, 0.57, 0.004),
        ("cheese", 0.57, 0.67, -0.003),
        ("bread crumb", 0.67, 1.0, 0.0),
    ]
    s = 0.36 * min(d, w)
    for k in (-1, 1):
        with b.frame(0, k * 0.05 * w, 0.01, yaw=0.25 + (np.pi if k < 0 else 0)):
            for look, lo, hi, e in layers:
                q = s - e
                b.extrude(
                    np.array([(-q * 1.05, 0.006 + e), (q * 1.05, 0.006 + e), (0.0, 1.05 * q)]),
                    (lo * u, hi * u),
                    look,
                    0.001,
                )
                if look == "bread crumb":
                    for x0 in (-1, 1):
                        b.bar(
                            (x0 * q * 1.03, 0.008, (lo + hi) / 2 * u),
                            (0, 1.04 * q, (lo + hi) / 2 * u),
                            0.115 * u,
                            "bread crust",
                            6,
                        )


@small("croissant")
def croissant(b: Builder) -> None:
    """A bent roll of flaky dough on a plate."""
    d, w, h = b.size
    glaze = b.material("plate", "white ceramic", "cream ceramic", "blue ceramic")
    n = 24
    loft(
        b,
        [
            ellipse(e * d / 2, e * w / 2, z, n)
            for e, z in ((0.7, 0.0), (1.0, 0.01), (1.0, 0.013), (0.7, 0.008), (0.0001, 0.008))
        ],
        glaze,
        hollow=2,
    )
    t = np.linspace(-1.25, 1.25, 8)
    big = 0.27 * w
    u = h - 0.008
    fat = (0.34, 0.62, 0.86, 1.0, 0.86, 0.62, 0.34)
    for k in range(7):
        a = (t[k] + t[k + 1]) / 2
        p0, p1 = (
            np.array([big * np.cos(s) - 0.6 * big, 1.2 * big * np.sin(s)]) for s in (t[k] - 0.06, t[k + 1] + 0.06)
        )
        r = fat[k] * u / 2
        lo, hi = (0.8, 1.0) if a < 0 else (1.0, 0.8)
        way = p1 - p0
        with b.frame(float(p0[0]), float(p0[1]), 0.008 + r, yaw=float(np.arctan2(way[1], way[0])), pitch=np.pi / 2):
            b.frustum(
                lo * r, hi * r, (0.0, float(np.hypot(*way))), "bread crust" if k % 2 else "cake sponge", 12, bevel=0.003
            )
