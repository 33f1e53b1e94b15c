"""Chairs for tables, schools, children; folding and rocking ones."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..registry import draws
from .beds_parts import slats
from .seating_parts import arc_panel, bent, leg, shell, splayed, square_leg

_WOODS = ("oak", "walnut", "beech", "light oak", "white paint", "black paint", "birch", "cherry")
_COVERS = ("@fabric", "brown leather", "tan leather", "black leather")
_PLASTICS = (
    "white plastic",
    "black plastic",
    "blue plastic",
    "red plastic",
    "green plastic",
    "yellow plastic",
    "orange plastic",
    "grey plastic",
)


def _four_legs(b: Builder, d: float, w: float, seat: float, wood, lean: float) -> float:
    """Front legs, back legs that run on as posts of the back rest, apron, stretchers; returns where the posts stand."""
    x0, x1 = -d / 2 + lean, d / 2 - 0.01
    t = 0.036
    for side in (-1, 1):
        y = side * (w / 2 - 0.02)
        square_leg(b, (x1 - 0.03, y, 0), (x1 - 0.03, y, seat - 0.02), 0.026, t, wood)
        square_leg(b, (x0 - 0.35 * lean + 0.02, y, 0), (x0 + 0.02, y, seat - 0.02), 0.028, t, wood)
        b.box((x0 + 0.03, x1 - 0.04), (y - 0.009, y + 0.009), (seat - 0.085, seat - 0.02), wood)
    inner = w / 2 - 0.03
    for x in (x0 + 0.02, x1 - 0.03):
        b.box((x - 0.009, x + 0.009), (-inner, inner), (seat - 0.085, seat - 0.02), wood)
    return x0 + 0.02


def _posts(b: Builder, x: float, w: float, seat: float, h: float, wood, lean: float) -> None:
    for side in (-1, 1):
        y = side * (w / 2 - 0.02)
        square_leg(b, (x, y, seat - 0.025), (x - lean, y, h), 0.036, 0.026, wood)


@draws("dining_chair")
def dining_chair(b: Builder) -> None:
    """A wooden frame with a padded or plain seat and a back of slats, ladder, cross, cane or upholstery."""
    d, w, h = b.size
    wood = b.material("frame", *_WOODS)
    cover = b.material("cover", *_COVERS) if b.chance("padded", 0.7) else wood
    style = b.pick("back", ["spindles", "ladder", "cross", "panel", "upholstered", "upholstered"])
    if style == "upholstered" and cover is wood:
        style = "ladder"
    seat, lean = b.uniform("seat height", 0.44, 0.47), 0.08
    with b.solid("seat"):
        x = _four_legs(b, d, w, seat, wood, lean)
        if cover is wood:
            b.box((x - 0.005, d / 2), (-w / 2, w / 2), (seat - 0.022, seat), wood, bevel=0.006)
        else:
            b.cushion(
                (x - 0.015, d / 2), (-w / 2 + 0.003, w / 2 - 0.003), (seat - 0.035, seat + 0.025), cover, radius=0.025
            )
    with b.solid("back"):
        if style == "upholstered":
            angle = math.atan2(lean, h - seat)
            with b.frame(x, 0, seat - 0.02, pitch=-angle):
                b.cushion(
                    (-0.03, 0.03),
                    (-w / 2 + 0.005, w / 2 - 0.005),
                    (0.0, (h - seat + 0.02) / math.cos(angle)),
                    cover,
                    radius=0.028,
                )
            b.fit()
            return
        _posts(b, x, w, seat, h, wood, lean)
        inner = w / 2 - 0.03

        def at(z: float) -> float:
            return x - lean * (z - seat) / (h - seat)

        def rail(z: float, high: float, bow: float = 0.02) -> None:
            ys = np.linspace(-inner, inner, 7)
            path = [(at(z) - bow * (1 - (y / inner) ** 2), y, z) for y in ys]
            section = np.array([(0.009, high / 2), (-0.009, high / 2), (-0.009, -high / 2), (0.009, -high / 2)])
            b.tube(path, section, wood)

        rail(h - 0.045, 0.08)
        if style == "spindles":
            rail(seat + 0.13, 0.03, 0.012)
            for k in range(5):
                y = inner * (-0.72 + 0.36 * k)
                bow = 1 - (y / inner) ** 2
                b.bar(
                    (at(seat + 0.13) - 0.012 * bow, y, seat + 0.13),
                    (at(h - 0.07) - 0.02 * bow, y, h - 0.07),
                    0.007,
                    wood,
                    segments=8,
                )
        elif style == "ladder":
            for k in range(2 if h < 0.92 else 3):
                rail(h - 0.045 - (k + 1) * 0.115, 0.055)
        elif style == "cross":
            low, high = seat + 0.1, h - 0.08
            rail(low, 0.03, 0.0)
            for s in (-1, 1):
                b.bar((at(low), -s * inner, low), (at(high) - 0.004, s * inner * 0.95, high), 0.009, wood, segments=8)
        else:
            with b.frame(0, 0, 0):
                low, high = seat + 0.1, h - 0.07
                grid = np.array(
                    [
                        [(at(z) - 0.018 * (1 - (y / inner) ** 2), y, z) for z in (low, high)]
                        for y in np.linspace(-inner, inner, 7)
                    ]
                )
                weave = b.material("cane", "rattan", "wicker") if b.chance("cane", 0.5) else wood
                b.sheet(grid, 0.012, weave, cells=3)
    b.fit()


def _scoop(d: float, w: float, seat: float, h: float, arms: float) -> np.ndarray:
    """A shell from the seat's front edge to the top of the back; its sides turn up by ``arms``."""
    x1, x0 = d / 2 - 0.03, -d / 2
    profile = [
        (x1, seat - 0.025),
        (x1 - 0.05, seat + 0.004),
        (x1 - 0.2, seat - 0.004),
        (x0 + 0.16, seat + 0.004),
        (x0 + 0.1, seat + 0.06),
        (x0 + 0.065, seat + 0.18),
        (x0 + 0.03, h - 0.1),
        (x0, h),
    ]
    half = [w * k for k in (0.40, 0.455, 0.485, 0.485, 0.475, 0.46, 0.42, 0.28)]
    up = [0.0, 0.012, 0.035, 0.055, 0.06, 0.0, 0.0, -0.03]
    forward = [-0.02, 0.0, 0.0, 0.03, 0.06, 0.075, 0.06, 0.04]

    def lift(k: int, s: float) -> tuple[float, float]:
        bend = abs(s) ** 2.2
        return forward[k] * bend * (1 + arms), up[k] * bend * (1 + 1.5 * arms)

    return bent(profile, half, lift, 7)


@draws("chair")
def chair(b: Builder) -> None:
    """A moulded shell on wooden, wire or tube legs, or a bent-wood chair with a round seat."""
    d, w, h = b.size
    kind = b.pick("kind", ["shell", "shell", "bentwood", "plank"])
    seat = 0.445
    if kind == "shell":
        body = b.material("shell", *_PLASTICS)
        under = b.pick("under", ["wood", "wire", "tube"])
        metal = (
            b.material("legs", "beech", "oak", "walnut")
            if under == "wood"
            else b.material("legs", "black steel", "chrome", "white steel")
        )
        with b.solid("seat"):
            low, high = (0.011, 0.018) if under == "wood" else (0.009, 0.009)
            splayed(
                b,
                (-d / 2 + 0.02, d / 2 - 0.01),
                (-w / 2 + 0.01, w / 2 - 0.01),
                (0, seat - 0.012),
                metal,
                0.09 if under != "tube" else 0.05,
                low,
                high,
            )
            r, at = 0.006, 0.62
            for sx in (-1, 1):
                b.bar((sx * d * 0.28, -w * 0.28, seat - 0.02), (sx * d * 0.28, w * 0.28, seat - 0.02), 0.009, metal, 8)
                b.bar((-d * 0.28, sx * w * 0.27, seat - 0.02), (d * 0.28, sx * w * 0.27, seat - 0.02), 0.009, metal, 8)
            if under != "tube":
                zs = at * seat
                px, py = d / 2 - 0.02 - 0.09 * at, w / 2 - 0.02 - 0.09 * at
                for s in (-1, 1):
                    b.bar((-px + 0.02, s * py, zs), (px, -s * py, zs), r, metal, 6)
        grid = _scoop(d, w, seat, h, 0.0)
        with b.solid("seat"):
            shell(b, grid[:5], 0.009, body, 4, 6)
        with b.solid("back"):
            shell(b, grid[4:], 0.009, body, 3, 6)
        if b.chance("pad", 0.35):
            with b.solid("seat"):
                b.cushion(
                    (-d / 2 + 0.15, d / 2 - 0.08),
                    (-w * 0.33, w * 0.33),
                    (seat - 0.004, seat + 0.03),
                    b.material("pad", "@fabric"),
                    radius=0.015,
                )
    elif kind == "bentwood":
        wood = b.material("frame", *_WOODS)
        weave = wood if b.chance("wooden seat", 0.33) else b.material("seat", "rattan", "wicker")
        r = min(d, w) * 0.46
        with b.solid("seat"):
            b.lathe(
                [(r - 0.02, seat - 0.035), (r, seat - 0.03), (r, seat - 0.006), (r - 0.01, seat)], wood, segments=32
            )
            b.frustum(r - 0.045, r - 0.045, (seat - 0.002, seat + 0.004), weave, segments=32)
            for s in (-1, 1):
                leg(b, (r * 0.74, s * r * 0.74, 0), (r * 0.62, s * r * 0.62, seat - 0.03), 0.012, 0.018, wood)
                leg(b, (-r * 0.95, s * r * 0.62, 0), (-r * 0.78, s * r * 0.56, seat - 0.03), 0.012, 0.017, wood)
            angle = np.arange(14) * 2 * np.pi / 14
            b.tube(
                np.c_[0.7 * r * np.cos(angle), 0.7 * r * np.sin(angle), np.full(14, 0.24)], 0.008, wood, 6, closed=True
            )
        with b.solid("back"):
            for size, radius in ((1.0, 0.014), (0.62, 0.009)):
                t = np.linspace(-1, 1, 17)
                y = np.sign(t) * r * 0.8 * size * np.cos((1 - np.abs(t)) ** 1.6 * np.pi / 2) ** 0.7
                z = seat - 0.02 + (h - seat - 0.005 - (1 - size) * 0.28) * np.sin((1 - np.abs(t)) * np.pi / 2) ** 0.8
                x = -r * 0.78 - 0.16 * (z - seat)
                b.tube(np.c_[x, y, z], radius, wood, 8)
    else:
        wood = b.material("frame", *_WOODS)
        with b.solid("seat"):
            b.extrude(
                [
                    (-d / 2 + 0.04, -w * 0.4),
                    (d / 2 - 0.02, -w / 2),
                    (d / 2, -w / 2 + 0.03),
                    (d / 2, w / 2 - 0.03),
                    (d / 2 - 0.02, w / 2),
                    (-d / 2 + 0.04, w * 0.4),
                ],
                (seat - 0.028, seat),
                wood,
                bevel=0.006,
            )
            splayed(
                b,
                (-d / 2 + 0.01, d / 2 - 0.01),
                (-w / 2 + 0.02, w / 2 - 0.02),
                (0, seat - 0.026),
                wood,
                0.07,
                0.011,
                0.02,
            )
        with b.solid("back"):
            with b.frame(-d / 2 + 0.075, 0, 0):
                arc_panel(b, w * 0.98, (h - 0.12, h), 0.018, 0.05, wood, lean=0.015)
            for k in range(6):
                y = w * 0.4 * (-1 + 2 * k / 5)
                forward = 0.05 * (1 - math.cos(abs(y) / (w / 2) * 1.2)) / (1 - math.cos(1.2))
                b.bar(
                    (-d / 2 + 0.09 + 0.4 * forward, y * 0.86, seat - 0.01),
                    (-d / 2 + 0.075 + forward, y, h - 0.1),
                    0.008,
                    wood,
                    8,
                )
    b.fit()


@draws("school_chair")
def school_chair(b: Builder) -> None:
    """A plywood or plastic seat and back on a frame of steel tube, stackable."""
    d, w, h = b.size
    body = b.material("seat", "plywood", "beech", *_PLASTICS[:6])
    metal = b.material("frame", "chrome", "grey plastic", "black steel", "blue paint", "red paint")
    seat, r = 0.56 * h, 0.011
    y, x0, x1 = w / 2 - r, -d / 2, d / 2
    with b.solid("seat"):
        for s in (-1, 1):
            path = [
                (x1 - 0.03, s * y, 0),
                (x1 - 0.07, s * (y - 0.03), seat - 0.06),
                (x1 - 0.1, s * (y - 0.03), seat - 0.025),
                (x0 + 0.12, s * (y - 0.03), seat - 0.025),
            ]
            b.tube(path, r, metal, 8)
            b.bar((x0 + 0.02, s * y, 0), (x0 + 0.15, s * (y - 0.03), seat - 0.03), r, metal, 8)
        b.bar((x0 + 0.16, -y + 0.03, seat - 0.027), (x0 + 0.16, y - 0.03, seat - 0.027), r * 0.8, metal, 8)
        b.bar((x1 - 0.1, -y + 0.03, seat - 0.027), (x1 - 0.1, y - 0.03, seat - 0.027), r * 0.8, metal, 8)
        profile = [
            (x1, seat - 0.03),
            (x1 - 0.05, seat - 0.006),
            (x1 - 0.17, seat),
            (x0 + 0.17, seat - 0.01),
            (x0 + 0.09, seat + 0.015),
        ]
        grid = bent(profile, [w * 0.42, w * 0.455, w * 0.46, w * 0.45, w * 0.4], lambda k, s: (0.0, 0.008 * s * s), 5)
        shell(b, grid, 0.01, body, 4, 2)
    with b.solid("back"):
        for s in (-1, 1):
            b.tube(
                [
                    (x0 + 0.14, s * (y - 0.03), seat - 0.025),
                    (x0 + 0.085, s * (y - 0.03), seat + 0.02),
                    (x0 + 0.02, s * (y - 0.04), h - 0.04),
                ],
                r,
                metal,
                8,
            )
        with b.frame(x0 + 0.035, 0, 0):
            arc_panel(b, w * 0.9, (h - 0.19, h), 0.01, 0.03, body, lean=0.025, narrow=0.94)
    b.fit()


@draws("kids_chair")
def kids_chair(b: Builder) -> None:
    """A small chair of wood or bright plastic; the back has a round cut, slats, or bear's ears."""
    d, w, h = b.size
    wood = b.material(
        "seat", "birch", "pine", "beech", "red paint", "blue paint", "yellow paint", "green paint", "white paint"
    )
    under = b.material("legs", "birch", "beech", "white paint") if b.chance("two tone", 0.6) else wood
    seat = 0.52 * h
    kind = b.pick("back", ["ears", "slats", "round"])
    with b.solid("seat"):
        b.cushion((-d / 2 + 0.03, d / 2), (-w / 2, w / 2), (seat - 0.025, seat), wood, radius=0.012)
        splayed(b, (-d / 2, d / 2 - 0.01), (-w / 2, w / 2), (0, seat - 0.02), under, 0.04, 0.012, 0.018)
    x = -d / 2 + 0.05
    with b.solid("back"), b.frame(x, 0, 0, pitch=-0.1):
        if kind == "slats":
            for s in (-1, 1):
                b.bar((0.03, s * (w / 2 - 0.025), seat - 0.02), (0.03, s * (w / 2 - 0.025), h - 0.01), 0.012, under, 8)
            for k in range(2):
                b.cushion(
                    (0.02, 0.038), (-w / 2, w / 2), (h - 0.09 - 0.085 * k, h - 0.02 - 0.085 * k), wood, radius=0.008
                )
        else:
            for s in (-1, 1):
                b.bar((0.03, s * w * 0.25, seat - 0.02), (0.03, s * w * 0.25, h - 0.15), 0.011, under, 8)
            with b.frame(0.022, 0, h - 0.03 - 0.3 * w if kind == "round" else h - 0.05 - 0.3 * w, pitch=math.pi / 2):
                r = 0.38 * w
                b.frustum(r, r, (0, 0.016), wood, segments=28, bevel=0.004)
                if kind == "ears":
                    for s in (-1, 1):
                        with b.frame(-0.72 * r, s * 0.72 * r, 0.0):
                            b.frustum(0.3 * r, 0.3 * r, (0.001, 0.015), wood, segments=18, bevel=0.003)
                            b.frustum(0.17 * r, 0.17 * r, (0.012, 0.0165), "pink plastic", segments=14)
                    for s in (-1, 1):
                        with b.frame(-0.15 * r, s * 0.35 * r, 0):
                            b.frustum(0.07 * r, 0.07 * r, (0.01, 0.0175), "black plastic", segments=10)
                    b.ball((0.12 * r, 0.16 * r, 0.006), (0.15 * r, 0, 0.016), "black plastic", segments=10)
    b.fit()


@draws("folding_chair")
def folding_chair(b: Builder) -> None:
    """Crossed legs of tube or wooden slats; seat and back of plastic, wood or cloth."""
    d, w, h = b.size
    wooden = b.chance("wooden", 0.45)
    frame = (
        b.material("frame", "beech", "oak", "walnut")
        if wooden
        else b.material("frame", "black steel", "white steel", "chrome")
    )
    body = frame if wooden else b.material("seat", "black plastic", "white plastic", "grey plastic", "blue plastic")
    seat, r = 0.45, 0.011
    x0, x1, y = -d / 2, d / 2, w / 2
    section = np.array([(0.009, 0.016), (-0.009, 0.016), (-0.009, -0.016), (0.009, -0.016)])
    use = section if wooden else r

    def pole(a, c, g) -> None:
        with b.solid(g):
            b.bar(a, c, use, frame, 8)

    cross = (0.02, seat * 0.62)
    for s in (-1, 1):
        ya, yb = s * (y - 0.012), s * (y - 0.04)
        hinge_x = 0.0 + (x0 + 0.1) * 0.35
        pole((x1 - 0.03, ya, 0.01), (hinge_x - 0.03, ya, seat + 0.02), "seat")
        pole((hinge_x - 0.03, ya, seat + 0.02), (x0 + 0.02, ya, h - 0.02), "back")
        pole((x0 + 0.03, yb, 0.01), (x1 - 0.1, yb, seat - 0.03), "seat")
    with b.solid("seat"):
        for x, yy in ((x1 - 0.055, y - 0.012), (x0 + 0.06, y - 0.04)):
            b.bar((x, -yy, 0.07), (x, yy, 0.07), 0.009, frame, 8)
        b.bar(
            (cross[0], -y + 0.01, seat - 0.11), (cross[0], y - 0.01, seat - 0.11), 0.008, frame, 8
        ) if not wooden else None
        xs = (x0 + 0.1, x1 - 0.04)
        if wooden:
            for k in range(5):
                a = xs[0] + k * (xs[1] - xs[0]) / 5
                b.box((a, a + (xs[1] - xs[0]) / 5 - 0.012), (-y + 0.045, y - 0.045), (seat - 0.018, seat), frame)
            for s in (-1, 1):
                b.box(xs, (s * (y - 0.06) - 0.012, s * (y - 0.06) + 0.012), (seat - 0.05, seat - 0.017), frame)
        else:
            b.cushion(xs, (-y + 0.025, y - 0.025), (seat - 0.03, seat), body, radius=0.014)
    with b.solid("back"):
        lean = (x0 + 0.02) - ((x0 + 0.1) * 0.35 - 0.03)
        slope = lean / (h - seat - 0.04)

        def at(z: float) -> float:
            return x0 + 0.02 - slope * (h - 0.02 - z)

        for k in range(2 if wooden else 1):
            top = h - 0.005 - 0.12 * k
            high = 0.075 if wooden else 0.2
            points = [
                (at(z) + t, yy, z) for z in (top - high, top) for t in (-0.009, 0.009) for yy in (-y + 0.006, y - 0.006)
            ]
            b.hull(points, body)
    b.fit()


@draws("high_chair")
def high_chair(b: Builder) -> None:
    """A child's seat with a tray and a foot rest on four long splayed legs."""
    d, w, h = b.size
    wood = b.material("legs", "beech", "oak", "white paint", "walnut", "birch")
    body = b.material("seat", "white plastic", "grey plastic", "mint plastic", "pink plastic", "blue plastic")
    seat = 0.56
    with b.solid("legs"):
        splayed(b, (-d / 2 + 0.02, d / 2 - 0.02), (-w / 2, w / 2), (0, seat), wood, 0.12, 0.014, 0.02)
        b.cushion((-0.17, 0.14), (-0.17, 0.17), (seat - 0.03, seat + 0.02), body, radius=0.02)
        b.box((0.12, 0.26), (-0.13, 0.13), (0.27, 0.29), wood, bevel=0.005)
        for s in (-1, 1):
            b.bar((0.13, s * 0.12, seat - 0.02), (0.19, s * 0.12, 0.28), 0.01, wood, 8)
    with b.solid("back"), b.frame(-0.17, 0, seat - 0.02, pitch=-0.14):
        b.cushion((-0.03, 0.015), (-0.17, 0.17), (0.0, h - seat + 0.02), body, radius=0.022)
        b.cushion((0.01, 0.03), (-0.13, 0.13), (0.03, h - seat - 0.06), b.material("pad", "@fabric"), radius=0.01)
    for s in (-1, 1):
        with b.solid(f"side {s}"):
            b.cushion((-0.19, 0.12), (s * 0.17 - 0.02, s * 0.17 + 0.02), (seat - 0.02, seat + 0.17), body, radius=0.018)
    with b.solid("tray"):
        z = seat + 0.17
        b.cushion((-0.02, 0.27), (-0.225, 0.225), (z, z + 0.02), "white plastic", radius=0.01)
        b.bar((0.1, 0, seat + 0.01), (0.12, 0, z + 0.005), 0.016, body, 8)
    for k, (xs, ys) in enumerate(
        (((0.25, 0.27), (-0.2, 0.2)), ((0.0, 0.26), (0.205, 0.225)), ((0.0, 0.26), (-0.225, -0.205)))
    ):
        with b.solid(f"lip {k}"):
            b.box(xs, ys, (z + 0.01, z + 0.035), "white plastic", bevel=0.006)
    b.surface("tray", (0.03, 0.235), (-0.19, 0.19), z + 0.02)
    b.fit()


@draws("rocking_chair")
def rocking_chair(b: Builder) -> None:
    """A wooden armchair with a high back on two bent runners."""
    d, w, h = b.size
    wood = b.material("frame", "oak", "walnut", "cherry", "white paint", "beech", "mahogany")
    cover = b.material("cover", *_COVERS)
    seat = 0.43
    y = w / 2 - 0.03
    angle = np.linspace(-1, 1, 9)
    runner = [(s * d / 2, 0.022 + 0.3 * max(0.0, abs(s) - 0.45) ** 2) for s in angle]
    section = np.array([(0.016, 0.022), (-0.016, 0.022), (-0.016, -0.022), (0.016, -0.022)])
    for s in (-1, 1):
        ya = s * y
        with b.solid(f"side {s}"):
            b.tube([(px, ya, pz) for px, pz in runner], section, wood)
            square_leg(b, (0.2, ya, 0.035), (0.22, ya, 0.64), 0.034, 0.034, wood)
            square_leg(b, (-0.22, ya, 0.035), (-0.2, ya, 0.63), 0.034, 0.034, wood)
            b.hull(
                [
                    (px, ya + t, pz)
                    for t in (-0.035, 0.035)
                    for px, pz in ((-0.3, 0.625), (-0.3, 0.645), (0.27, 0.64), (0.27, 0.665))
                ],
                wood,
            )
            b.bar((-0.21, ya, 0.25), (0.21, ya, 0.25), 0.01, wood, 8)
    with b.solid("seat"):
        for px in (-0.2, 0.21):
            b.bar((px, -y, 0.36), (px, y, 0.37), 0.014, wood, 8)
        with b.frame(0, 0, seat, pitch=-0.07):
            b.box((-0.24, 0.26), (-y + 0.01, y - 0.01), (-0.07, -0.045), wood, bevel=0.005)
            b.cushion((-0.22, 0.26), (-y + 0.02, y - 0.02), (-0.046, 0.02), cover, radius=0.03)
    with b.solid("back"), b.frame(-0.21, 0, 0.36, pitch=-0.3):
        long = (h - 0.36) / math.cos(0.3)
        wide = y - 0.03
        for s in (-1, 1):
            b.bar((0, s * wide, 0), (0, s * wide, long), 0.016, wood, 10)
        b.box((-0.012, 0.012), (-wide, wide), (long - 0.12, long - 0.01), wood, bevel=0.006)
        b.box((-0.01, 0.01), (-wide, wide), (0.07, 0.11), wood)
        if b.chance("padded back", 0.45):
            b.cushion((0.0, 0.06), (-wide + 0.02, wide - 0.02), (0.1, long - 0.1), cover, radius=0.028)
        else:
            slats(b, (-0.007, 0.007), (-wide, wide), (0.1, long - 0.11), wood, 0.07, 0.014, True)
    b.fit()
