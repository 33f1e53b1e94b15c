"""Sofas and other upholstered seats."""

from __future__ import annotations

from typing import NamedTuple

from ...body import Material
from ...materials import finish
from ..builder import Builder, Interval
from ..registry import draws
from .seating_parts import pillow, splayed

_COVERS = ("@fabric", "brown leather", "tan leather", "black leather")
_THROWS = (
    "beige fabric",
    "mustard fabric",
    "rust fabric",
    "white fabric",
    "navy fabric",
    "green fabric",
    "rose fabric",
)


def _contrast(cover: Material) -> tuple[str, ...]:
    """Cloths for loose things that do not vanish on the cover."""
    return tuple(
        name
        for name in _THROWS
        if max(abs(a - c) for a, c in zip(finish(name).material.color, cover.color, strict=True)) > 0.2
    )


class _Look(NamedTuple):
    """The heights and thicknesses of a sofa."""

    arms: str
    arm: float
    arm_top: float
    legs: float
    base: float
    seat: float
    back: float
    legs_style: str


def _look(b: Builder, narrow: bool = False) -> _Look:
    arms = b.pick("arms", ["block", "round", "slim", "flared", "wood"])
    arm = {"block": 0.17, "round": 0.19, "slim": 0.09, "flared": 0.13, "wood": 0.07}[arms]
    if narrow:
        arm = min(arm, 0.15)
    seat = b.uniform("seat height", 0.42, 0.46)
    legs = b.uniform("leg height", 0.09, 0.15) if b.chance("long legs", 0.7) else 0.05
    return _Look(
        arms,
        arm,
        b.uniform("arm height", 0.58, 0.64),
        legs,
        0.27,
        seat,
        b.uniform("back", 0.13, 0.17),
        b.pick("leg style", ["tapered", "block", "metal"]),
    )


def _feet(b: Builder, x: Interval, y: Interval, top: float, style: str) -> None:
    """Four feet (six under a long sofa), a little in from the edges."""
    wood = (
        b.material("legs", "oak", "walnut", "black paint")
        if style != "metal"
        else b.material("metal legs", "black steel", "chrome", "brass")
    )
    with b.solid("base"):
        if style == "tapered" and top > 0.07:
            splayed(b, (x[0] + 0.03, x[1] - 0.03), (y[0] + 0.04, y[1] - 0.04), (0, top), wood, 0.02, 0.011, 0.021)
            return
        half = 0.014 if style == "metal" else 0.03
        spots = [y[0] + 0.08, y[1] - 0.08] + ([(y[0] + y[1]) / 2] if y[1] - y[0] > 1.8 else [])
        for cx in (x[0] + 0.07, x[1] - 0.07):
            for cy in spots:
                b.box((cx - half, cx + half), (cy - half, cy + half), (0.0, top + 0.001), wood)


def _arm(b: Builder, x: Interval, side: int, edge: float, look: _Look, cover: Material, name: str) -> None:
    """An arm whose outer face lies at y = ``edge``, to the left (1) or right (-1)."""
    inner = edge - side * look.arm
    ys = (min(inner, edge), max(inner, edge))
    middle = (inner + edge) / 2
    with b.solid(name):
        if look.arms == "round":
            r = look.arm / 2
            b.cushion(x, (ys[0] + 0.015, ys[1] - 0.015), (look.legs, look.arm_top - r), cover, radius=0.025)
            with b.frame(x[0] + 0.005, middle, look.arm_top - r, pitch=1.5707963):
                b.frustum(r, r, (0.0, x[1] - x[0] - 0.01), cover, segments=20, bevel=0.012)
        elif look.arms == "flared":
            lean = -side * 0.13
            with b.frame(0, inner + side * 0.05, look.legs + 0.01, roll=lean):
                b.cushion(x, (-0.05, 0.05), (0.0, look.arm_top - look.legs - 0.02), cover, radius=0.035)
        elif look.arms == "wood":
            wood = b.material("legs", "oak", "walnut", "black paint")
            for cx in (x[0] + 0.06, x[1] - 0.06):
                b.box((cx - 0.022, cx + 0.022), (middle - 0.018, middle + 0.018), (0.0, look.arm_top - 0.03), wood)
            b.box(x, ys, (look.arm_top - 0.03, look.arm_top), wood, bevel=0.008)
            b.box(
                (x[0] + 0.08, x[1] - 0.08), (middle - 0.012, middle + 0.012), (look.legs + 0.06, look.legs + 0.13), wood
            )
        else:
            radius = 0.03 if look.arms == "slim" else 0.04
            b.cushion(x, ys, (look.legs, look.arm_top), cover, radius=radius)


def _seats(
    b: Builder,
    x: Interval,
    y: Interval,
    look: _Look,
    count: int,
    cover: Material,
    height: float,
    pillows: tuple[int, ...] = (),
    lean: float = 0.14,
    buttons: bool = False,
) -> None:
    """Base, back frame, and ``count`` seat and back cushions between the arms, with loose pillows on some seats."""
    front = x[0] + look.back
    with b.solid("base"):
        b.cushion((x[0] + 0.01, x[1] - 0.015), y, (look.legs, look.base + 0.01), cover, radius=0.02)
    with b.solid("back"):
        b.cushion((x[0], front), y, (look.legs, height - 0.07), cover, radius=0.04)
    step = (y[1] - y[0]) / count
    for k in range(count):
        ys = (y[0] + k * step + 0.002, y[0] + (k + 1) * step - 0.002)
        with b.solid("base"):
            b.cushion((front - 0.02, x[1]), ys, (look.base - 0.005, look.seat), cover, radius=0.045)
        thick = 0.15
        with b.solid("back"), b.frame(front + 0.035, 0.0, look.seat - 0.005, pitch=-lean):
            high = height - look.seat + 0.005
            b.cushion((-0.02, thick - 0.02), (ys[0] + 0.004, ys[1] - 0.004), (0.02, high), cover, radius=0.05, puff=0.3)
            if buttons:
                for row in (0.4, 0.72):
                    for t in (0.25, 0.5, 0.75):
                        yb = ys[0] + t * (ys[1] - ys[0])
                        b.ball((0.009, 0.013, 0.013), (thick - 0.023, yb, high * row), cover, segments=8)
        start = front + 0.035 + thick + 0.01
        if k in pillows:
            throw = b.material(f"pillow {k % 2}", *_contrast(cover))
            where = ys[0] + 0.24 if k == 0 else ys[1] - 0.24
            turn = 0.25 if k == 0 else -0.25
            with b.solid(f"pillow {k}"):
                tilt = 1.15
                with b.frame(start + 0.005, where, look.seat + 0.2, yaw=-turn, pitch=tilt):
                    pillow(b, 0.42, 0.42, 0.13, throw, lift=-0.1)
            start += 0.2
        b.surface(
            f"seat-{k}" if count > 1 else "seat", (start + 0.02, x[1] - 0.055), (ys[0] + 0.05, ys[1] - 0.05), look.seat
        )


@draws("sofa", "loveseat")
def sofa(b: Builder) -> None:
    """Base on feet, arms of five kinds, seat and back cushions, loose pillows."""
    d, w, h = b.size
    cover = b.material("cover", *_COVERS)
    look = _look(b)
    x, y = (-d / 2, d / 2), (-w / 2 + look.arm - 0.005, w / 2 - look.arm + 0.005)
    count = 2 if b.category.name == "loveseat" else b.pick("seats", [3, 3, 2])
    loose = b.pick("pillows", [(0,), (0, count - 1), (0, count - 1), ()])
    _seats(b, x, y, look, count, cover, h, loose, buttons=b.chance("buttons", 0.25))
    for side in (-1, 1):
        _arm(b, (x[0], x[1] - 0.02), side, side * w / 2, look, cover, f"arm {side}")
    if look.arms != "wood":
        _feet(b, x, (-w / 2, w / 2), look.legs + 0.01, look.legs_style)
    b.fit()


@draws("armchair")
def armchair(b: Builder) -> None:
    """One upholstered seat between arms; with wings in some."""
    d, w, h = b.size
    cover = b.material("cover", *_COVERS)
    look = _look(b, narrow=True)
    wing = h > 0.92
    if wing:
        look = look._replace(arms="round" if look.arms in ("slim", "wood") else look.arms, arm=0.12)
    x, y = (-d / 2, d / 2), (-w / 2 + look.arm - 0.005, w / 2 - look.arm + 0.005)
    _seats(b, x, y, look, 1, cover, h, lean=0.16, buttons=b.chance("buttons", 0.35))
    for side in (-1, 1):
        _arm(b, (x[0], x[1] - 0.02), side, side * w / 2, look, cover, f"arm {side}")
        if wing:
            inner, outer = sorted((side * w / 2 - side * 0.1, side * w / 2 - side * 0.02))
            with b.solid(f"wing {side}"):
                b.cushion(
                    (x[0] + 0.02, x[0] + 0.3), (inner, outer), (look.arm_top - 0.06, h - 0.03), cover, radius=0.035
                )
    if look.arms != "wood":
        _feet(b, x, (-w / 2, w / 2), look.legs + 0.01, look.legs_style)
    b.fit()


@draws("sectional_sofa")
def sectional_sofa(b: Builder) -> None:
    """A sofa whose seat at one end runs out to a chaise."""
    d, w, h = b.size
    cover = b.material("cover", *_COVERS)
    look = _look(b)
    if look.arms == "wood":
        look = look._replace(arms="block", arm=0.17)
    end = 1 if b.chance("chaise left", 0.5) else -1
    deep = 0.95
    x = (-d / 2, -d / 2 + deep)
    chaise = min(0.95, 0.36 * w)
    long = (
        (-w / 2 + look.arm - 0.005, w / 2 - look.arm - chaise)
        if end > 0
        else (-w / 2 + look.arm + chaise, w / 2 - look.arm + 0.005)
    )
    couch, loose = b.whole("seats", 2, 2), b.pick("pillows", [(0,), (1,), (0, 1)])
    _seats(b, x, long, look, couch, cover, h, loose)
    a, c = sorted((end * (w / 2 - look.arm + 0.005), end * (w / 2 - look.arm - chaise)))
    front = x[0] + look.back
    with b.solid("chaise"):
        b.cushion((x[0] + 0.01, d / 2 - 0.015), (a, c), (look.legs, look.base + 0.01), cover, radius=0.02)
        b.cushion((front - 0.02, d / 2), (a + 0.002, c - 0.002), (look.base - 0.005, look.seat), cover, radius=0.045)
    with b.solid("back"):
        b.cushion((x[0], front), (a, c), (look.legs, h - 0.07), cover, radius=0.04)
        with b.frame(front + 0.035, 0.0, look.seat - 0.005, pitch=-0.14):
            b.cushion(
                (-0.02, 0.13), (a + 0.006, c - 0.006), (0.02, h - look.seat + 0.005), cover, radius=0.05, puff=0.3
            )
    b.surface("chaise", (front + 0.21, d / 2 - 0.06), (a + 0.06, c - 0.06), look.seat)
    if b.chance("throw", 0.5):
        cloth = b.material("throw", *_contrast(cover))
        with b.solid("throw"):
            xs = (d / 2 - 0.52, d / 2 - 0.2)
            b.box(xs, (a - 0.006, c + 0.006), (look.base - 0.02, look.seat + 0.008), cloth, bevel=0.012)
        last = b.unsurface()
        b.resurface(last, [(min(px, xs[0] - 0.02), py) for px, py in last.polygon])
    _arm(b, (x[0], x[1] - 0.02), -end, -end * w / 2, look, cover, "arm")
    _arm(b, (x[0], x[1] - 0.02), end, end * w / 2, look, cover, "chaise arm")
    y = (-w / 2, long[1]) if end > 0 else (long[0], w / 2)
    _feet(b, x, y, look.legs + 0.01, "block" if look.legs_style == "tapered" else look.legs_style)
    wood = b.material("metal legs" if look.legs_style == "metal" else "legs", "oak", "walnut", "black steel")
    with b.solid("chaise"):
        for cy in (a + 0.06, c - 0.06):
            b.box((d / 2 - 0.1, d / 2 - 0.06), (cy - 0.02, cy + 0.02), (0, look.legs + 0.005), wood)
    b.fit()


@draws("sofa_bed")
def sofa_bed(b: Builder) -> None:
    """A fold-down sofa: a tufted mattress for seat and back, a bedding drawer below, arms."""
    d, w, h = b.size
    cover = b.material("cover", "@fabric")
    wooden = b.chance("wooden frame", 0.5)
    wood = b.material("legs", "oak", "walnut", "light oak", "pine", "white paint")
    arm = 0.07 if wooden else 0.13
    x, y = (-d / 2, d / 2), (-w / 2 + arm, w / 2 - arm)
    seat = 0.43
    with b.solid("base"):
        b.box((x[0] + 0.1, x[1] - 0.05), y, (0.07, 0.24), wood)
        for k in range(2):
            half = (y[1] - y[0]) / 2
            ys = (y[0] + k * half + 0.012, y[0] + (k + 1) * half - 0.012)
            b.box((x[1] - 0.051, x[1] - 0.03), ys, (0.08, 0.23), wood)
            middle = (ys[0] + ys[1]) / 2
            b.box(
                (x[1] - 0.031, x[1] - 0.015), (middle - 0.06, middle + 0.06), (0.15, 0.175), "black steel", bevel=0.004
            )
        for cx in (x[0] + 0.16, x[1] - 0.12):
            for cy in (y[0] + 0.06, y[1] - 0.06):
                b.box((cx - 0.03, cx + 0.03), (cy - 0.03, cy + 0.03), (0, 0.075), wood)
    count = 3
    for k in range(count):
        step = (y[1] - y[0]) / count
        ys = (y[0] + k * step + 0.003, y[0] + (k + 1) * step - 0.003)
        with b.solid("base"):
            b.cushion((x[0] + 0.22, x[1]), ys, (0.24, seat), cover, radius=0.055)
        with b.solid("back"), b.frame(x[0] + 0.24, 0, 0.29, pitch=-0.2):
            b.cushion((-0.1, 0.08), ys, (0.0, h - 0.29 + 0.01), cover, radius=0.055)
            for row in (0.45, 0.78):
                for t in (0.25, 0.75):
                    b.ball((0.012, 0.014, 0.014), (0.08, ys[0] + t * step, row * (h - 0.28)), cover, segments=8)
    b.surface("seat-0", (x[0] + 0.36, x[1] - 0.06), (y[0] + 0.06, y[0] + step - 0.06), seat)
    b.surface("seat-1", (x[0] + 0.36, x[1] - 0.06), (y[0] + step + 0.06, y[0] + 2 * step - 0.06), seat)
    for side in (-1, 1):
        edge, inner = side * w / 2, side * (w / 2 - arm)
        ys = (min(edge, inner), max(edge, inner))
        with b.solid(f"arm {side}"):
            if not wooden:
                b.cushion((x[0] + 0.08, x[1] - 0.02), ys, (0.06, 0.62), cover, radius=0.05)
                for cx in (x[0] + 0.16, x[1] - 0.1):
                    b.box((cx - 0.025, cx + 0.025), (ys[0] + 0.03, ys[1] - 0.03), (0, 0.07), wood)
                continue
            for cx in (x[0] + 0.14, x[1] - 0.06):
                b.box((cx - 0.03, cx + 0.03), (ys[0] + 0.015, ys[1] - 0.015), (0, 0.6), wood)
            b.box((x[0] + 0.08, x[1] - 0.01), ys, (0.6, 0.63), wood, bevel=0.006)
            b.box((x[0] + 0.16, x[1] - 0.08), (ys[0] + 0.02, ys[1] - 0.02), (0.12, 0.18), wood)
            for k in range(5):
                cx = x[0] + 0.24 + k * (d - 0.4) / 4
                b.box((cx - 0.018, cx + 0.018), (ys[0] + 0.025, ys[1] - 0.025), (0.18, 0.6), wood, bevel=0.002)
    throw = b.material("pillow", *_contrast(cover))
    with b.solid("pillow"), b.frame(x[0] + 0.39, y[1] - 0.26, seat + 0.19, pitch=1.1, yaw=-0.3):
        pillow(b, 0.42, 0.42, 0.13, throw, lift=-0.06)
    b.fit()


@draws("recliner")
def recliner(b: Builder) -> None:
    """A thickly padded chair that leans back, its foot rest raised."""
    d, w, h = b.size
    cover = b.material("cover", "brown leather", "black leather", "tan leather", "grey fabric", "beige fabric")
    arm = 0.2
    x0 = -d / 2
    body = x0 + 0.98
    y = w / 2 - arm
    with b.solid("base"):
        b.box((x0 + 0.2, body - 0.1), (-w / 2 + 0.05, w / 2 - 0.05), (0.0, 0.06), "black plastic")
        b.cushion((x0 + 0.14, body), (-y, y), (0.06, 0.34), cover, radius=0.03)
        with b.frame(body - 0.26, 0, 0.38, pitch=-0.06):
            b.cushion((-0.34, 0.3), (-y + 0.002, y - 0.002), (-0.08, 0.1), cover, radius=0.07)
    for side in (-1, 1):
        inner, outer = sorted((side * y, side * w / 2))
        with b.solid(f"arm {side}"):
            b.cushion((x0 + 0.14, body - 0.01), (inner + 0.012, outer - 0.012), (0.04, 0.54), cover, radius=0.05)
            b.cushion((x0 + 0.1, body + 0.015), (inner, outer), (0.48, 0.64), cover, radius=0.075)
    with b.solid("back"), b.frame(x0 + 0.36, 0, 0.34, pitch=-0.42):
        long = (h - 0.34) / 0.913 - 0.05
        b.cushion((-0.17, -0.04), (-y - 0.05, y + 0.05), (0.0, long - 0.02), cover, radius=0.05)
        cuts = (0.06, 0.36 * long, 0.66 * long, long)
        for k in range(3):
            wide = y + (0.0, 0.0, 0.04)[k]
            b.cushion((-0.08, 0.1 - 0.01 * k), (-wide, wide), (cuts[k], cuts[k + 1] + 0.012), cover, radius=0.07)
    with b.solid("foot rest"):
        with b.frame(body + 0.02, 0, 0.36, pitch=-0.12):
            b.cushion((0.0, d - 0.98 - 0.01), (-y + 0.01, y - 0.01), (-0.03, 0.1), cover, radius=0.06)
        for side in (-1, 1):
            b.bar(
                (body - 0.06, side * (y - 0.06), 0.22),
                (body + 0.14, side * (y - 0.06), 0.37),
                0.013,
                "black steel",
                segments=6,
            )
    if b.chance("lever", 0.7):
        with b.solid("arm -1"):
            b.bar(
                (body - 0.24, -w / 2 - 0.0, 0.3),
                (body - 0.12, -w / 2 - 0.0, 0.36),
                0.011,
                b.material("lever", "walnut", "black plastic", "chrome"),
                segments=8,
            )
    b.fit()


@draws("chaise_longue")
def chaise_longue(b: Builder) -> None:
    """A long seat with a raised back at its head and, in some, an arm along one side."""
    d, w, h = b.size
    cover = b.material("cover", *_COVERS)
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    legs, seat = b.uniform("legs", 0.12, 0.18), 0.42
    style = b.pick("leg style", ["tapered", "metal", "turned"])
    wood = b.material("legs", "oak", "walnut", "black steel", "brass")
    with b.solid("base"):
        if style == "turned":
            for cx in (x[0] + 0.12, x[1] - 0.12):
                for cy in (y[0] + 0.06, y[1] - 0.06):
                    with b.frame(cx, cy):
                        b.lathe(
                            [(0.012, 0), (0.018, 0.03), (0.028, legs * 0.55), (0.02, legs * 0.7), (0.03, legs + 0.01)],
                            wood,
                            segments=12,
                        )
        else:
            splayed(
                b,
                (x[0] + 0.05, x[1] - 0.05),
                (y[0] + 0.02, y[1] - 0.02),
                (0, legs + 0.01),
                wood,
                0.03,
                0.008 if style == "metal" else 0.011,
                0.01 if style == "metal" else 0.022,
            )
        b.cushion((x[0] + 0.06, x[1] - 0.02), (y[0] + 0.01, y[1] - 0.01), (legs, 0.28), cover, radius=0.025)
        b.cushion((x[0] + 0.2, x[1]), y, (0.27, seat), cover, radius=0.05)
    lean = 0.3
    with b.solid("back"), b.frame(x[0] + 0.29, 0, 0.24, pitch=-lean):
        long = (h - 0.24) / 0.9553 - 0.02
        b.cushion((-0.09, 0.07), y, (0.0, long), cover, radius=0.06)
        if b.chance("buttons", 0.6):
            for row in (0.45, 0.7, 0.9):
                for t in (-0.6, -0.2, 0.2, 0.6):
                    b.ball((0.01, 0.013, 0.013), (0.07, t * w / 2, row * long), cover, segments=8)
    if b.chance("roll", 0.75):
        accent = b.material("roll", "@fabric", "tan leather")
        with b.solid("back"), b.frame(x[0] + 0.39, 0, seat + 0.07, roll=1.5707963):
            b.frustum(0.08, 0.08, (-w / 2 + 0.05, w / 2 - 0.05), accent, segments=20, bevel=0.02)
    b.surface("seat", (x[0] + 0.52, x[1] - 0.06), (y[0] + 0.06, y[1] - 0.1), seat)
    if b.chance("arm", 0.5):
        with b.solid("arm"):
            b.cushion((x[0] + 0.2, x[0] + 0.6 * d), (y[1] - 0.09, y[1]), (0.3, 0.62), cover, radius=0.04)
        b.unsurface()
        b.surface("seat", (x[0] + 0.52, x[1] - 0.06), (y[0] + 0.06, y[1] - 0.12), seat)
    b.fit()


@draws("booth_seat")
def booth_seat(b: Builder) -> None:
    """A diner's bench: plinth, thick seat, a high back in upright channels."""
    d, w, h = b.size
    cover = b.material(
        "cover", "red fabric", "brown leather", "black leather", "green fabric", "navy fabric", "tan leather"
    )
    panel = b.material("panel", "walnut", "oak", "black paint", "white paint")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    seat = 0.46
    with b.solid("seat"):
        b.box((x[0] + 0.02, x[1] - 0.08), (y[0] + 0.03, y[1] - 0.03), (0.0, 0.08), "black paint")
        b.box((x[0], x[1] - 0.04), y, (0.08, 0.34), panel)
        b.cushion((x[0] + 0.1, x[1]), (y[0] + 0.005, y[1] - 0.005), (0.33, seat), cover, radius=0.045)
    with b.solid("back"):
        b.box((x[0], x[0] + 0.05), y, (0.34, h - 0.02), panel)
        count = max(4, round(w / b.pick("channel", [0.14, 0.2, 0.28])))
        step = (w - 0.01) / count
        with b.frame(x[0] + 0.11, 0, seat - 0.03, pitch=-0.07):
            for k in range(count):
                ys = (y[0] + 0.005 + k * step, y[0] + 0.005 + (k + 1) * step)
                b.cushion((-0.07, 0.06), ys, (0.0, h - seat - 0.05), cover, radius=0.05)
        b.box((x[0], x[0] + 0.09), y, (h - 0.06, h), panel, bevel=0.01)
    b.surface("seat", (x[0] + 0.21, x[1] - 0.055), (y[0] + 0.06, y[1] - 0.06), seat)
    b.fit()
