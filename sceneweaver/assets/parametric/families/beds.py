"""Beds for rooms of adults and children, and mattresses."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import drawer, legs, piping
from .beds_parts import BOARDS, barred, bedding, head_board, rods

_WOODS = "oak, walnut, pine, light oak, white paint, ash grey wood, black paint"
_METALS = "black steel, iron, brass, white steel"
_BUILT = {
    "platform_bed": ("plinth", ("panel", "slats")),
    "storage_bed": ("drawers", ("panel", "rails")),
    "metal_bed": ("tubes", ("arched rods", "rods")),
}
"""Frame and head boards of beds that are known by how they are built."""


def _frame(d: Drawing, box: Box, wood: Look, style: str) -> None:
    """Rails around the mattress, on legs, on a plinth, upholstered, or over drawers."""
    if style == "legs":
        legs(d, box.inset(top=0.13, back=0.06, front=0.03, y=0.03), wood, "splayed", 0.052, 0.03)
        d.box(box.top(0.14), wood, bevel=0.008)
    elif style == "tubes":
        legs(d, box.inset(top=0.04), wood, "round", 0.04)
        d.box(box.top(0.05), wood, bevel=0.01)
    elif style == "plinth":
        d.box(box.inset(top=0.11, x=0.1, y=0.1), "black paint")
        d.box(box.top(0.12), wood, bevel=0.01)
    elif style == "upholstered":
        d.box(box.bottom(0.05).inset(x=0.05, y=0.05), "black paint")
        d.cushion(box.inset(bottom=0.04), wood, 0.03)
    elif style == "padded legs":
        feet = d.material("legs", "oak, walnut, black paint")
        legs(d, box.bottom(0.14).inset(back=0.06, front=0.03, y=0.03), feet, "splayed", 0.048, 0.02)
        d.cushion(box.inset(bottom=0.13), wood, 0.03)
    else:
        d.box(box.bottom(0.05).inset(x=0.025, y=0.03), wood)
        case = box.inset(bottom=0.05, y=0.02)
        for board in (case.top(0.02), case.bottom(0.012), case.back(0.02), case.front(0.02)):
            d.box(board.inset(z=0.0 if board.depth > 0.1 else 0.02), wood, bevel=0.0)
        d.box(case.place(width=0.02).inset(x=0.02, bottom=0.012, top=0.02), wood, bevel=0.0)
        with d.mirror("y"):
            _bed_drawers(d, case.inset(bottom=0.012, top=0.02), wood)


def _bed_drawers(d: Drawing, case: Box, wood: Look) -> None:
    """Two drawers side by side that slide out to the left from under a bed, with the posts beside them."""
    half = case.to(y=(0.012, case.y[1]))
    cells = half.inset(x=0.026).split("x", 2, 0.012)
    for x in ((case.x[0] + 0.02, cells[0].x[0]), (cells[0].x[1], cells[1].x[0]), (cells[1].x[1], case.x[1] - 0.02)):
        d.box(half.left(0.02).to(x=x), wood, bevel=0.0)
    for k, cell in enumerate(cells):
        middle = (cell.x[0] + cell.x[1]) / 2
        with d.at(x=middle, y=half.y[1], yaw=math.pi / 2):  # seen from its side: +x is out
            own = Box((-min(0.6, half.width), 0.0), (-cell.depth / 2, cell.depth / 2), cell.z)
            drawer(d, f"drawer-{k}", own, wood, "black steel", "cup", round(0.7 * own.depth, 3))


@draws("bed", "king_bed", "single_bed", "platform_bed", "upholstered_bed", "storage_bed", "metal_bed", whole=True)
def bed(d: Drawing) -> None:
    """A head board of six kinds, a frame on legs, plinth or drawers, mattress, pillows, blanket, sometimes a foot."""
    name = d.category.name
    single = name == "single_bed"
    padded = name == "upholstered_bed" or (name not in _BUILT and d.chance("upholstered", 0.25 if single else 0.5))
    if padded:
        wood = d.material("cover", "@fabric, tan leather, brown leather")
        style = d.pick("padded frame", ["upholstered", "upholstered", "padded legs"])
        board = d.pick("padded board", ["channels", "tufted", "arch"])
    elif name in _BUILT:
        wood = d.material("frame", _METALS if name == "metal_bed" else _WOODS)
        style, boards = _BUILT[name]
        board = d.pick("board", boards)
    else:
        wood = d.material("frame", _WOODS)
        style = d.pick("frame", ["legs", "plinth", "drawers", "legs"])
        board = d.pick("board", ["panel", "slats", "rails"])
    rail = d.uniform("rail", 0.27, 0.33)
    top, thick = rail + d.uniform("mattress", 0.17, 0.22), BOARDS[board]
    head_board(d, d.bounds, rail, board, wood, wood)
    body = d.bounds.inset(back=thick - 0.005).to(z=(0.0, rail))
    with d.part("bed"):
        _frame(d, body, wood, style)
    foot = not padded and name != "platform_bed" and d.chance("foot board", 0.4)
    if foot:
        end = d.bounds.to(z=(0.0, rail + (0.28 if single else 0.2)))
        with d.part("foot board"):
            if board == "panel":
                d.box(end.front(0.035), wood, bevel=0.006)
            elif "rods" in board:
                rods(d, end.front(0.04), wood, rail - 0.02, arched=False)
            else:
                barred(d, end.front(0.05), wood, rail - 0.08)
    edge = 0.025 if foot or single else 0.05
    place = Box((body.x[0] + 0.005, body.x[1] - (0.055 if foot else edge)), body.inset(y=edge).y, (rail - 0.03, top))
    runner = not single and d.chance("runner", 0.35)
    bedding(d, place, "bed", 1 if single else 2, rail + 0.004, overhang=0.0 if foot else edge - 0.006, runner=runner)
    if not single and d.chance("throw pillow", 0.5):
        accent = d.material("throw pillow", "@fabric, tan leather")
        with d.part("bed pillows"), d.at(place.x[0] + 0.52, z=top + 0.17, pitch=0.95):
            d.pillow(Box.sized(0.32, 0.5, 0.13, (0.0, 0.0, -0.05)), accent)


@draws("canopy_bed", whole=True)
def canopy_bed(d: Drawing) -> None:
    """Four posts and a rail around their heads; curtains of thin cloth at the posts in some."""
    wood = d.material("frame", "oak, walnut, mahogany, black steel, white paint, black paint")
    metal = wood.called("black steel")
    box, post, rail = d.bounds, 0.04 if metal else 0.07, 0.3
    curtains = d.chance("curtains", 0.65)
    tie = 0.45  # of the height: where a curtain is drawn to its post
    with d.corners(box), d.part("post"):
        own = Box((0.0, post), (0.0, post), box.z)
        if not metal and d.style in ("classic", "rustic"):
            d.box(own.share(z=(0.0, 0.26)), wood, bevel=0.006)
            profile = [(0.55, 0.0), (0.95, 0.03), (0.6, 0.07), (0.9, 0.3), (0.7, 0.6), (0.5, 0.92), (0.85, 0.95)]
            d.turned(own.share(z=(0.26, 1.0)), [*profile, (0.85, 1.0)], wood, 14)
        else:
            d.box(own, wood, bevel=0.005)
    head = box.top(0.045).move(z=-0.015).inset(0.15 * post).to(z=(box.height - 0.06, box.height - 0.015))
    with d.part("canopy"):
        for beam in (head.left(0.7 * post), head.right(0.7 * post), head.front(0.7 * post), head.back(0.7 * post)):
            d.box(beam, wood)
    with d.part("bed"):
        d.box(box.to(z=(rail - 0.14, rail)).inset(x=0.02, y=0.015), wood, bevel=0.006)
    with d.part("head board"):
        cover = d.material("head", "@fabric") if d.chance("padded head", 0.4) else wood
        board = d.box(box.to(z=(rail - 0.05, 1.05)).inset(back=0.012, y=post).back(0.04), cover, bevel=0.008)
        d.box(board.front(-0.01).inset(y=0.08, z=0.08), cover, bevel=0.004)
    place = box.to(z=(rail - 0.03, 0.5)).inset(back=0.065, front=0.05, y=0.045)
    bedding(d, place, hem=rail + 0.004, runner=d.chance("runner", 0.4))
    if curtains:
        cloth, long = d.material("curtain", "sheer fabric"), box.height - 0.15
        t = np.linspace(0.0, 1.0, 19)
        heights = np.array([0.0, 0.2, tie - 0.06, tie, tie + 0.06, 0.7, 1.0])
        widths = np.interp(heights, [0.0, 0.2, tie, 0.7, 1.0], [0.22, 0.2, 0.07, 0.2, 0.27])
        y = box.y[1] - post / 2
        rows = [
            np.c_[box.x[0] + post + t * w, y + 0.014 * np.sin(t * 26 + h), np.full(19, 0.09 + h * long)]
            for h, w in zip(heights.tolist(), widths.tolist(), strict=True)
        ]
        with d.mirror("y"), d.part("curtain"):
            d.sheet(np.array(rows), 0.004, cloth, (3, 1))
            d.box(Box.around((box.x[0] + post + 0.03, y, 0.09 + tie * long), 0.09, 0.036, 0.03), cloth, bevel=0.008)


@draws("daybed", whole=True)
def daybed(d: Drawing) -> None:
    """A bed along the wall like a sofa: a barred back and two ends, bolsters, square cushions, a folded throw."""
    wood = d.material("frame", "white paint, oak, walnut, black steel, pine")
    metal = wood.called("black steel")
    box, t, rail, top = d.bounds, 0.03 if metal else 0.05, 0.24, 0.43
    fill = "rods" if metal else "panel" if d.chance("panels", 0.5) else "slats"
    with d.part("bed"):
        d.box(box.to(z=(rail - 0.11, rail)).inset(front=0.02, y=0.01), wood, bevel=0.005)
        if d.chance("trundle", 0.5):
            drawer = d.box(box.to(z=(0.025, rail - 0.118)).inset(back=0.06, front=0.015, y=0.08), wood)
            for half in drawer.columns(2):
                d.box(half.front(-0.013).place(width=0.12, height=0.02), "black steel", bevel=0.003)
    with d.part("back"):
        barred(d, box.back(t), wood, rail - 0.03, t, 0.07, 0.11, fill=fill)
    side = box.inset(back=t).to(z=(0.0, box.height - d.pick("step", [0.0, 0.1, 0.15])))
    with d.mirror("y"), d.part("end"):
        barred(d, side.left(t), wood, rail - 0.03, t, 0.07, 0.11, fill=fill, axis="x")
    cover, accent = d.material("cover", "@fabric"), d.material("cushions", "@fabric")
    place = side.inset(y=t, front=0.01).to(z=(rail - 0.01, top))
    with d.part("bed"):
        piping(d, d.cushion(place, cover, 0.045), cover, 0.045)
    d.surface("top", place.inset(back=0.38, front=0.06, y=0.36))
    with d.part("back cushions"):
        wide = (place.width - 0.36) / 3
        for k, cloth in enumerate((accent, cover, accent)):
            with d.at(place.x[0] + 0.13, (k - 1) * wide, top + 0.225, yaw=0.06 * (k - 1), pitch=1.25):
                d.pillow(Box.around((0.0, 0.0, 0.02), 0.48, min(0.56, 0.98 * wide), 0.18), cloth)
    with d.mirror("y"), d.part("bolster"):
        roll = place.inset(x=0.05).left(0.19).to(z=(top - 0.01, top + 0.18))
        d.cylinder(roll, accent, "x", bevel=0.03)
        d.cylinder(roll.front(-0.006).place(width=0.04, height=0.04), accent, "x", segments=12)


@draws("toddler_bed", whole=True)
def toddler_bed(d: Drawing) -> None:
    """A low bed with half rails at its head, a round-topped head board and a small foot board."""
    wood = d.material("frame", "white paint, birch, pine, light grey paint, beech, sage paint")
    box, rail = d.bounds, 0.2
    head_board(d, box, rail, d.pick("board", ["arch", "slats", "panel"]), wood, wood)
    with d.part("foot board"):
        d.box(box.front(0.025).to(z=(0.0, 0.4)), wood, bevel=0.01)
    with d.part("bed"):
        d.box(box.to(z=(rail - 0.1, rail)).inset(back=0.03, front=0.02, y=0.015), wood, bevel=0.004)
    bedding(d, box.inset(back=0.065, front=0.03, y=0.03).to(z=(rail - 0.02, 0.31)), "bed", 1, rail + 0.01, thick=0.1)
    guard = box.inset(back=0.03).to(x=(box.x[0] + 0.03, box.x[0] + 0.52 * box.depth), z=(rail - 0.09, 0.47))
    with d.mirror("y"), d.part("rail"):
        barred(d, guard.left(0.024), wood, rail - 0.09, 0.04, 0.04, 0.1, 0.016, axis="x")


@draws("mattress", whole=True)
def mattress_on_floor(d: Drawing) -> None:
    """A mattress on the floor, or a futon on a slatted base, with pillows and a blanket folded back."""
    box, low = d.bounds, 0.0
    if d.chance("pallet", 0.5):
        low = 0.08
        wood = d.material("base", "pine, oak, plywood")
        with d.part("bed"):
            for beam in box.bottom(0.062).inset(y=0.02).columns([1, 8, 1, 8, 1])[::2]:
                d.box(beam, wood)
            for slat in box.to(z=(0.06, low)).split("x", math.floor(box.depth / 0.15), 0.05):
                d.box(slat, wood)
    top = low + min(0.2, box.height - low - 0.1)
    place = box.inset(x=0.035, y=0.035).to(z=(low, top))
    bedding(d, place, "bed", 1 if box.width < 1.2 else 2, low + 0.05, overhang=0.033, thick=0.14)
