"""Office seats: task, gaming and conference chairs."""

from __future__ import annotations

from ...drawing import Box, Drawing, draws
from ...drawing.components import star_base
from .seating_parts import arc_panel

_DARK = "black plastic"


def _base(d: Drawing, seat: float, metal: str) -> None:
    with d.part("base"):
        star_base(d, d.size.width / 2, seat - 0.07, d.material("base", metal))
        d.box(Box.around((-0.01, 0.0, seat - 0.08), 0.22, 0.16, 0.04), _DARK, bevel=0.01)


@draws("office_chair", whole=True)
def office_chair(d: Drawing) -> None:
    """Star base on castors, gas lift, upholstered seat, curved back rest, arms and a head rest in some."""
    _, w, h = d.size
    cover = d.material("cover", "@fabric", "black leather", "brown leather")
    frame = d.material("frame", "black plastic, grey plastic, white plastic")
    height, mesh, rest = d.uniform("seat height", 0.43, 0.49), d.chance("mesh back", 0.4), h > 1.08
    _base(d, height, "chrome, black plastic, aluminium")
    seat = Box.sized(0.48, min(0.5, w - 0.12), 0.085, (0.03, 0.0, height - 0.065))
    x = seat.x[0]
    with d.part("seat"):
        d.cushion(seat, cover, 0.042)
        d.box(seat.inset(x=0.05, y=0.05).bottom(-0.015), frame, bevel=0.004)
    low, top = height + 0.13, h - 0.17 if rest else h
    lean = 0.16 * (top - low)
    with d.part("back"):
        spine = [(-0.1, 0.0, height - 0.08), (x - 0.01, 0.0, height - 0.07), (x - 0.05, 0.0, height + 0.02)]
        d.sweep([*spine, (x - 0.06, 0.0, low + 0.1)], 0.02, frame, segments=8)
        wide = seat.width * d.uniform("back width", 0.86, 0.98)
        with d.at(x - 0.03):
            cloth = "charcoal fabric" if mesh else cover
            arc_panel(d, wide, (low, top), 0.018 if mesh else 0.05, 0.07, cloth, lean, 0.86)
        with d.at(x - 0.06):
            d.bar((0.005, 0.0, low + 0.02), (0.005 - 0.55 * lean, 0.0, 0.45 * low + 0.55 * top), 0.018, frame, 8)
            if mesh:
                d.cushion(Box((0.0, 0.05), (-0.14, 0.14), (low + 0.04, low + 0.15)), frame, 0.02)
    if rest:
        with d.part("head"), d.at(x - 0.035 - lean):
            d.bar((-0.005, 0.0, top - 0.03), (-0.005, 0.0, h - 0.07), 0.012, frame, segments=8)
            arc_panel(d, 0.29, (h - 0.13, h), 0.045, 0.04, cover, count=5)
    if rest or d.chance("arms", 0.7):
        loop = d.pick("arm style", ["post", "loop"]) == "loop"
        with d.mirror("y"), d.part("arm"), d.at(y=seat.y[1] + 0.025, z=height):
            if loop:
                ring = [(0.1, 0.0, -0.03), (0.14, 0.0, 0.19), (-0.09, 0.0, 0.19), (-0.05, 0.0, -0.03)]
                d.sweep(ring, 0.011, frame, segments=8, closed=True)
            else:
                d.box(Box((-0.035, 0.035), (-0.012, 0.012), (-0.04, 0.2)), frame, bevel=0.006)
            d.bar((0.0, -0.1, -0.05), (0.0, 0.0, -0.02), 0.012, frame, segments=6)
            d.cushion(Box((-0.12, 0.14), (-0.04, 0.04), (0.19, 0.224)), _DARK, 0.015)


@draws("gaming_chair", whole=True)
def gaming_chair(d: Drawing) -> None:
    """A racing seat: high back with wings, contrast stripes, pillows, star base."""
    cover = d.material("cover", "black leather, white leather, charcoal fabric")
    accent = d.material("accent", "red plastic, blue plastic, green plastic, orange plastic, pink plastic")
    seat, x = 0.46, -0.24
    _base(d, seat - 0.03, "black plastic, aluminium")
    with d.part("seat"):
        middle = d.cushion(Box((x, 0.28), (-0.17, 0.17), (seat - 0.1, seat + 0.01)), cover, 0.035)
        with d.mirror("y"):
            d.cushion(Box((x, 0.26), (0.17, 0.26), (seat - 0.09, seat + 0.06)), cover, 0.04)
            d.box(middle.left(0.014).inset(back=0.04, bottom=0.05, top=-0.004, left=-0.008), accent, bevel=0.004)
    high = d.size.height - seat + 0.02
    with d.part("back"), d.at(x + 0.02, z=seat - 0.02, pitch=-0.2):
        d.box(Box((-0.06, 0.0), (-0.2, 0.2), (0.0, 0.1)), _DARK, bevel=0.01)
        d.cushion(Box((-0.06, 0.04), (-0.15, 0.15), (0.03, high - 0.06)), cover, 0.035)
        with d.mirror("y"):
            with d.at(y=0.2, yaw=-0.45):
                d.cushion(Box((-0.05, 0.05), (-0.075, 0.075), (0.1, 0.68 * high)), cover, 0.04)
            with d.at(y=0.16, z=0.84 * high, yaw=-0.35):
                d.cushion(Box((-0.05, 0.05), (-0.055, 0.055), (-0.11, 0.12)), cover, 0.04)
            d.box(Box((0.0, 0.0425), (0.118, 0.142), (0.12, high - 0.2)), accent, bevel=0.004)
        d.cushion(Box((-0.05, 0.035), (-0.13, 0.13), (high - 0.12, high)), cover, 0.035)
        d.cushion(Box((0.03, 0.1), (-0.14, 0.14), (0.14, 0.3)), accent, 0.03, 0.4)
        d.cushion(Box((0.03, 0.09), (-0.11, 0.11), (high - 0.25, high - 0.12)), accent, 0.03, 0.4)
    with d.mirror("y"), d.part("arm"), d.at(y=0.29, z=seat):
        d.box(Box((-0.06, 0.06), (-0.014, 0.014), (-0.1, 0.2)), _DARK, bevel=0.008)
        d.bar((0.0, -0.2, -0.1), (0.0, 0.0, -0.085), 0.015, _DARK, segments=8)
        d.cushion(Box((-0.12, 0.15), (-0.04, 0.04), (0.19, 0.225)), _DARK, 0.012)


@draws("conference_chair", whole=True)
def conference_chair(d: Drawing) -> None:
    """An upholstered seat and back on a cantilever of steel tube, or on four legs with arms."""
    cover = d.material("cover", "black leather", "@fabric", "tan leather", "brown leather")
    metal = d.material("frame", "chrome, black steel, brushed steel")
    (depth, w, h), seat, r, arm = d.size, 0.45, 0.0125, 0.66
    x0, x1, y = -depth / 2, depth / 2, w / 2 - 0.02
    cantilever = d.chance("cantilever", 0.6)
    low = seat - 0.075
    with d.part("legs"):
        with d.mirror("y"), d.at(y=y):
            head = [(x1 - 0.1, 0.0, arm), (x0 + 0.07, 0.0, arm)]
            if cantilever:
                foot = [(x0 + 0.05, 0.0, r), (x1 - 0.05, 0.0, r), (x1 - 0.02, 0.0, 0.05)]
                d.sweep([*foot, (x1 - 0.06, 0.0, arm - 0.05), *head], r, metal, segments=8)
            else:
                d.sweep([(x1 - 0.03, 0.0, 0.0), (x1 - 0.06, 0.0, arm - 0.03), *head], r, metal, segments=8)
                d.bar((x0 + 0.02, 0.0, 0.0), (x0 + 0.07, 0.0, arm), r, metal, segments=8)
            d.cushion(Box((x0 + 0.12, x1 - 0.11), (-0.02, 0.02), (arm + 0.008, arm + 0.032)), _DARK, 0.01)
            d.bar((x1 - 0.05, 0.0, low), (x0 + 0.06, 0.0, low), 0.9 * r, metal, segments=8)
            d.bar((x0 + 0.06, 0.0, low), (x0 + 0.07, 0.0, arm), 0.9 * r, metal, segments=8)
        rails = [(x0 + 0.14, low), (x1 - 0.16, low)] + ([(x0 + 0.05, r)] if cantilever else [])
        for x, z in rails:
            d.bar((x, -y, z), (x, y, z), 0.9 * r, metal, segments=8)
        d.cushion(Box((x0 + 0.07, x1 - 0.03), (-y + 0.03, y - 0.03), (seat - 0.07, seat + 0.01)), cover, 0.035)
    with d.part("back"):
        with d.mirror("y"):
            d.bar((x0 + 0.08, y - 0.06, seat - 0.06), (x0 + 0.035, y - 0.09, h - 0.08), 0.8 * r, metal, segments=8)
        with d.at(x0 + 0.085):
            arc_panel(d, 2 * (y - 0.03), (seat + 0.1, h), 0.045, 0.035, cover, 0.06, count=7)
