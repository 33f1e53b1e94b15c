"""Office seats: task, gaming and conference chairs."""

from __future__ import annotations

from ..builder import Builder
from ..registry import draws
from .seating_parts import arc_panel, star_base


@draws("office_chair")
def office_chair(b: Builder) -> None:
    """Star base on castors, gas lift, upholstered seat, curved back rest, arms and a head rest in some."""
    d, w, h = b.size
    cover = b.material("cover", "@fabric", "black leather", "brown leather")
    frame = b.material("frame", "black plastic", "grey plastic", "white plastic")
    metal = b.material("base", "chrome", "black plastic", "aluminium")
    seat = b.uniform("seat height", 0.43, 0.49)
    with b.solid("base"):
        star_base(b, w / 2, seat - 0.07, metal)
        b.box((-0.12, 0.1), (-0.08, 0.08), (seat - 0.1, seat - 0.06), "black plastic", bevel=0.01)
    sd, sw = 0.48, min(0.5, w - 0.12)
    x0 = -sd / 2 + 0.03
    with b.solid("seat"):
        b.cushion((x0, x0 + sd), (-sw / 2, sw / 2), (seat - 0.065, seat + 0.02), cover, radius=0.04)
    mesh = b.chance("mesh back", 0.4)
    rest = h > 1.08
    top = h - 0.17 if rest else h
    low = seat + 0.13
    lean = 0.16 * (top - low)
    bw = sw * b.uniform("back width", 0.86, 0.98)
    with b.solid("back"):
        path = [
            (-0.1, 0, seat - 0.08),
            (x0 - 0.01, 0, seat - 0.07),
            (x0 - 0.05, 0, seat + 0.02),
            (x0 - 0.06, 0, low + 0.1),
        ]
        b.tube(path, 0.02, frame, segments=8)
        with b.frame(x0 - 0.03, 0, 0):
            arc_panel(
                b,
                bw,
                (low, top),
                0.018 if mesh else 0.05,
                0.07,
                "charcoal fabric" if mesh else cover,
                lean=lean,
                narrow=0.86,
            )
        with b.frame(x0 - 0.06, 0, 0):
            b.bar((0.005, 0, low + 0.02), (0.005 - 0.55 * lean, 0, low + 0.55 * (top - low)), 0.018, frame, segments=8)
            if mesh:
                b.cushion((0.0, 0.05), (-0.14, 0.14), (low + 0.04, low + 0.15), frame, radius=0.02)
    if rest:
        with b.solid("head"):
            x = x0 - 0.03 - lean
            b.bar((x - 0.01, 0, top - 0.03), (x - 0.01, 0, h - 0.07), 0.012, frame, segments=8)
            with b.frame(x - 0.005, 0, 0):
                arc_panel(b, 0.29, (h - 0.13, h), 0.045, 0.04, cover, count=5)
    if rest or b.chance("arms", 0.7):
        style = b.pick("arm style", ["post", "loop"])
        for side in (-1, 1):
            y = side * (sw / 2 + 0.025)
            with b.solid(f"arm {side}"):
                if style == "post":
                    b.box((-0.035, 0.035), (y - 0.012, y + 0.012), (seat - 0.04, seat + 0.2), frame, bevel=0.006)
                else:
                    b.tube(
                        [
                            (0.1, y, seat - 0.03),
                            (0.14, y, seat + 0.19),
                            (-0.09, y, seat + 0.19),
                            (-0.05, y, seat - 0.03),
                        ],
                        0.011,
                        frame,
                        segments=8,
                        closed=True,
                    )
                b.bar((0.0, y - side * 0.1, seat - 0.05), (0.0, y, seat - 0.02), 0.012, frame, segments=6)
                b.cushion(
                    (-0.12, 0.14), (y - 0.038, y + 0.038), (seat + 0.19, seat + 0.222), "black plastic", radius=0.012
                )
    b.fit()


@draws("gaming_chair")
def gaming_chair(b: Builder) -> None:
    """A racing seat: high back with wings and shoulder holes, contrast stripes, pillows, star base."""
    d, w, h = b.size
    cover = b.material("cover", "black leather", "white leather", "charcoal fabric")
    accent = b.material("accent", "red plastic", "blue plastic", "green plastic", "orange plastic", "pink plastic")
    metal = b.material("base", "black plastic", "aluminium")
    seat = 0.46
    with b.solid("base"):
        star_base(b, w / 2, seat - 0.1, metal)
        b.box((-0.14, 0.14), (-0.1, 0.1), (seat - 0.13, seat - 0.09), "black plastic", bevel=0.01)
    x0, sw = -0.24, 0.52
    with b.solid("seat"):
        b.cushion((x0, 0.28), (-0.17, 0.17), (seat - 0.1, seat + 0.01), cover, radius=0.035)
        for side in (-1, 1):
            ys = (0.17, 0.26) if side > 0 else (-0.26, -0.17)
            b.cushion((x0, 0.26), ys, (seat - 0.09, seat + 0.06), cover, radius=0.04)
            inner = side * 0.172
            b.box((x0 + 0.04, 0.27), (inner - 0.008, inner + 0.008), (seat - 0.05, seat + 0.014), accent, bevel=0.004)
    high = h - seat + 0.02
    with b.solid("back"), b.frame(x0 + 0.02, 0, seat - 0.02, pitch=-0.2):
        b.box((-0.06, 0.0), (-0.2, 0.2), (0.0, 0.1), "black plastic", bevel=0.01)
        b.cushion((-0.06, 0.04), (-0.15, 0.15), (0.03, high - 0.06), cover, radius=0.035)
        for side in (-1, 1):
            with b.frame(0.0, side * 0.2, 0.0, yaw=-side * 0.45):
                b.cushion((-0.05, 0.05), (-0.075, 0.075), (0.1, high * 0.68), cover, radius=0.035)
            with b.frame(0.0, side * 0.16, high * 0.84, yaw=-side * 0.35):
                b.cushion((-0.05, 0.05), (-0.055, 0.055), (-0.11, 0.12), cover, radius=0.035)
            y = side * 0.13
            b.box((0.0, 0.0425), (y - 0.012, y + 0.012), (0.12, high - 0.2), accent, bevel=0.004)
        b.cushion((-0.05, 0.035), (-0.13, 0.13), (high - 0.12, high), cover, radius=0.035)
        b.cushion((0.03, 0.1), (-0.14, 0.14), (0.14, 0.3), accent, radius=0.03, puff=0.4)
        b.cushion((0.03, 0.09), (-0.11, 0.11), (high - 0.25, high - 0.12), accent, radius=0.03, puff=0.4)
    for side in (-1, 1):
        y = side * (sw / 2 + 0.03)
        with b.solid(f"arm {side}"):
            b.box((-0.06, 0.06), (y - 0.014, y + 0.014), (seat - 0.1, seat + 0.2), "black plastic", bevel=0.008)
            b.bar((0.0, side * 0.09, seat - 0.1), (0.0, y, seat - 0.085), 0.015, "black plastic", segments=8)
            b.cushion((-0.12, 0.15), (y - 0.04, y + 0.04), (seat + 0.19, seat + 0.225), "black plastic", radius=0.012)
    b.fit()


@draws("conference_chair")
def conference_chair(b: Builder) -> None:
    """An upholstered seat and back on a cantilever of steel tube, or on four legs with arms."""
    d, w, h = b.size
    cover = b.material("cover", "black leather", "@fabric", "tan leather", "brown leather")
    metal = b.material("frame", "chrome", "black steel", "brushed steel")
    seat, r = 0.45, 0.0125
    x0, x1 = -d / 2, d / 2
    cantilever = b.chance("cantilever", 0.6)
    arm = 0.66
    y = w / 2 - 0.02
    with b.solid("legs"):
        for side in (-1, 1):
            ys = side * y
            if cantilever:
                path = [
                    (x0 + 0.05, ys, r),
                    (x1 - 0.05, ys, r),
                    (x1 - 0.02, ys, 0.05),
                    (x1 - 0.06, ys, arm - 0.05),
                    (x1 - 0.1, ys, arm),
                    (x0 + 0.07, ys, arm),
                ]
                b.tube(path, r, metal, segments=8)
            else:
                b.tube(
                    [(x1 - 0.03, ys, 0), (x1 - 0.06, ys, arm - 0.03), (x1 - 0.09, ys, arm), (x0 + 0.07, ys, arm)],
                    r,
                    metal,
                    segments=8,
                )
                b.bar((x0 + 0.02, ys, 0), (x0 + 0.07, ys, arm), r, metal, segments=8)
            b.cushion(
                (x0 + 0.12, x1 - 0.11), (ys - 0.02, ys + 0.02), (arm + 0.008, arm + 0.032), "black plastic", radius=0.01
            )
        if cantilever:
            b.bar((x0 + 0.05, -y, r), (x0 + 0.05, y, r), r, metal, segments=8)
        for x in (x0 + 0.14, x1 - 0.16):
            b.bar((x, -y, seat - 0.075), (x, y, seat - 0.075), r * 0.9, metal, segments=8)
        for side in (-1, 1):
            at = x1 - 0.05 if cantilever else x1 - 0.05
            b.bar((at, side * y, seat - 0.075), (x0 + 0.06, side * y, seat - 0.075), r * 0.9, metal, segments=8)
            b.bar((x0 + 0.06, side * y, seat - 0.08), (x0 + 0.07, side * y, arm), r * 0.9, metal, segments=8)
        b.cushion((x0 + 0.07, x1 - 0.03), (-y + 0.03, y - 0.03), (seat - 0.07, seat + 0.01), cover, radius=0.03)
    with b.solid("back"):
        for side in (-1, 1):
            top = (x0 + 0.035, side * (y - 0.09), h - 0.08)
            b.bar((x0 + 0.08, side * (y - 0.06), seat - 0.06), top, r * 0.8, metal, segments=8)
        with b.frame(x0 + 0.085, 0, 0):
            arc_panel(b, 2 * (y - 0.03), (seat + 0.1, h), 0.045, 0.035, cover, lean=0.06, count=7)
    b.fit()
