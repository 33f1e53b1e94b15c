"""Bunk, loft, wall, hospital and baby beds, and massage tables."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import blanket, castors, frame, leg, lip
from .beds_parts import SHEETS, barred, bedding, ladder

_WOODS = "pine, white paint, oak, birch, light grey paint, ash grey wood"


@draws("bunk_bed", "loft_bed", whole=True)
def bunk_bed(d: Drawing) -> None:
    """Two beds one above the other, or one on high posts, with guard rails and a ladder at the left side."""
    loft = d.category.name == "loft_bed"
    metal = loft and d.chance("metal", 0.35)
    wood = d.material("frame", "black steel, white steel, brushed steel" if metal else _WOODS)
    post = 0.045 if metal else 0.06
    wide, top = d.size.width - 0.11, d.size.height
    box = Box.sized(d.size.depth, wide, top)
    levels = {"bed": top - 0.36} if loft else {"lower": 0.3, "upper": top - 0.34}
    high = max(levels.values())
    inner = box.inset(x=post, y=post)
    rail = 0.25 * post  # rails lie that far behind the faces of the posts
    with d.at(y=-0.055):
        with d.mirror("x"), d.part("end"):
            end = box.front(post)
            for side in (end.left(post), end.right(post)):
                d.box(side, wood, bevel=0.005)
            for z in levels.values():
                barred(d, end.inset(y=post).to(z=(z, min(z + 0.38, top))), wood, z - 0.06, 0.0, 0.06, 0.13)
        for name, z in levels.items():
            with d.part(name):
                for side in (box.left(post).inset(y=rail), box.right(post).inset(y=rail)):
                    d.box(side.inset(x=post).to(z=(z - 0.07, z + 0.07)), wood)
                d.box(inner.inset(y=-rail).to(z=(z - 0.03, z - 0.01)), wood, bevel=0.002)
            place = inner.inset(x=0.005, y=-0.008).to(z=(z - 0.012, z + 0.12))
            bedding(d, place, name, 1, z + 0.02, None, thick=0.11)
        steps = Box((inner.x[1] - 0.5, inner.x[1] - 0.12), (box.y[1] - 0.004, box.y[1] + 0.101), (0.0, top - 0.06))
        for side, span in ((box.right(post), inner.x), (box.left(post), (inner.x[0], steps.x[0]))):
            guard = side.inset(y=rail).to(x=span, z=(high + 0.13, top - 0.02))
            with d.part("guard"):
                for board in guard.rows(2, gap=0.05):
                    d.box(board, wood, bevel=0.005)
                d.box(guard.front(0.05).to(z=(high + 0.06, top - 0.02)).inset(y=-0.004), wood)
        with d.part("ladder"):
            ladder(d, steps, wood, 6 if loft else 5)
        if loft:
            d.clear(inner.to(z=(0.05, high - 0.1)))


@draws("crib", whole=True)
def crib(d: Drawing) -> None:
    """A baby's bed with bars all around, a small mattress, a blanket and a pillow roll."""
    wood = d.material("frame", "white paint, birch, beech, light grey paint, oak, sage paint")
    box, t, low = d.bounds, 0.035, 0.2
    fill = "panel" if d.chance("solid ends", 0.4) else "rods"
    with d.mirror("x"), d.part("end"):
        barred(d, box.front(t), wood, low, t, pitch=0.075, bar=0.014, fill=fill)
    with d.mirror("y"), d.part("side"):
        side = box.left(t).inset(x=t, top=0.006)
        barred(d, side, wood, low, 0.0, 0.055, 0.078, 0.014, "rods", "x")
    sheet = d.material("sheet", SHEETS)
    cover = d.material("blanket", "rose fabric, blue fabric, green fabric, mustard fabric, white fabric")
    inside = box.inset(x=t, y=t).to(z=(low + 0.05, 0.4))
    with d.part("bed"):
        d.box(inside.bottom(0.025), wood, bevel=0.002)
        d.cushion(inside.inset(bottom=0.024), sheet, 0.03)
        cloth = inside.inset(all=0.004).share(x=(0.5, 1.0)).to(z=(0.34, 0.418))
        blanket(d, cloth, cover, 0.035)
        blanket(d, cloth.back(0.13).inset(y=-0.001, bottom=0.01, top=-0.008), sheet, 0.035)
    with d.part("pillow"):
        d.pillow(inside.place(0.2, 0.36, at="back").move(x=0.03).to(z=(0.395, 0.46)), cover)


@draws("murphy_bed", whole=True)
def murphy_bed(d: Drawing) -> None:
    """A cupboard whose large front folds down to a bed; drawn folded up."""
    wood = d.material("body", "white paint, oak, walnut, light grey paint, ash grey wood")
    front = d.material("front", "oak, walnut, white paint, sage paint") if d.chance("two tone", 0.4) else wood
    pull = d.material("pulls", "black steel, brass, brushed steel")
    box, t = d.bounds.inset(top=0.06, front=0.01), 0.03
    door = box.front(0.018).inset(y=t + 0.003, bottom=0.085, top=0.125)
    with d.part("cupboard"):
        for side in (box.left(t), box.right(t)):
            d.box(side, wood)
        inner = box.inset(y=t)
        d.box(inner.inset(front=0.02), wood)
        d.box(inner.front(0.02).top(0.12), wood)
        d.box(inner.front(0.02).bottom(0.08).inset(front=0.01), "black paint")
        d.box(d.bounds.top(0.06), wood, bevel=0.012)
    columns, rows = d.pick("panels", [(2, 1), (2, 2), (2, 3), (3, 1)])
    framed = d.chance("framed", 0.6)
    with d.hinge("bed", door.anchor("front bottom"), (0.0, 1.0, 0.0), (0.0, math.pi / 2)), d.part("cupboard"):
        d.box(door.inset(front=0.007), front)
        for cell in (c for column in door.front(0.008).columns(columns) for c in column.rows(rows)):
            field = cell.inset(y=0.002, z=0.002)
            if framed:
                frame(d, field, front, 0.068)
            else:
                d.box(field, front, bevel=0.002)
        with d.mirror("y"):  # a pull, and a folded foot: a sign that this is a bed
            (_, y, z), x = door.anchor("top"), door.x[1]
            lip(d, Box.around((x + 0.014, y + 0.25 * box.width, z - 0.31), 0.028, 0.2, 0.018), pull)
            d.box(Box.around((x + 0.003, y + 0.36 * box.width, z - 0.46), 0.006, 0.044, 0.32), pull)
    d.surface("top", d.bounds.inset(back=0.02, front=0.048, y=0.03))


@draws("hospital_bed", whole=True)
def hospital_bed(d: Drawing) -> None:
    """A bed on castors with a raised head part, side rails, boards at both ends, and two lifting columns."""
    panel = d.material("boards", "white plastic, beech, light grey paint, blue plastic")
    metal = d.material("frame", "white steel, grey plastic, light grey paint")
    sheet = d.material("sheet", "white fabric")
    cover = d.material("blanket", "blue fabric, green fabric, white fabric, grey fabric")
    box, base, top = d.bounds, 0.46, 0.6
    split = box.x[0] + 0.8
    bed = box.inset(x=0.055, y=0.065).to(z=(base, top))
    with d.part("bed"):
        castors(d, box.bottom(0.155).inset(back=0.16, front=0.2, y=0.1), metal, "grey plastic")
        chassis = box.to(z=(0.15, 0.2)).inset(back=0.19, front=0.23, y=0.1)
        for bar in (chassis.back(0.07), chassis.front(0.07), chassis.place(width=0.4)):
            d.box(bar, metal, bevel=0.01)
        with d.mirror("x"):
            d.box(Box.sized(0.14, 0.18, base - 0.25, (0.4, 0.0, 0.2)), "brushed steel", bevel=0.006)
        d.box(bed.bottom(-0.06), metal, bevel=0.01)
        d.cushion(bed.to(x=(split - 0.03, bed.x[1])), sheet, 0.035)
        cloth = bed.to(x=(split + 0.14, bed.x[1] + 0.003)).inset(y=-0.004, bottom=0.02, top=-0.02)
        blanket(d, cloth, cover, 0.045)
    d.surface("top", cloth.inset(back=0.22, front=0.068, y=0.064))
    with d.part("head part"):
        blanket(d, cloth.back(0.19).inset(y=-0.002, bottom=0.02, top=-0.01), sheet, 0.045)
        with d.at(split, z=base, pitch=0.42):
            rest = Box((-0.74, 0.05), bed.y, (-0.004, top - base))
            d.box(rest.inset(back=0.02, front=0.05, y=0.01).bottom(-0.026), metal, bevel=0.005)
            d.cushion(rest, sheet, 0.035)
            d.pillow(Box.sized(0.42, 0.62, 0.15, (-0.47, 0.0, top - base - 0.008)), sheet)
    for name, board in (("head board", box.back(0.045)), ("foot board", box.front(0.045).inset(top=box.height - 0.86))):
        with d.part(name):
            own = d.cushion(board.inset(y=0.03, bottom=0.4), panel, 0.022)
            d.box(own.top(0.05).move(z=-0.1).place(width=0.48), "grey plastic", bevel=0.002)
    rails = {"head rail": (box.x[0] + 0.16, box.x[0] + 0.86, 0.88), "foot rail": (box.x[0] + 1.0, box.x[0] + 1.6, 0.8)}
    tube = panel if panel.called("white plastic") else metal
    for name, (x0, x1, high) in rails.items():
        with d.mirror("y"), d.part(name), d.at(y=box.y[1] - 0.038):
            low = base - 0.03
            path = [(x0, 0.0, low), (x0 + 0.06, 0.0, high), (x1 - 0.06, 0.0, high), (x1, 0.0, low)]
            d.sweep(path, 0.0145, tube, segments=8)
            for z in np.arange(0.6, high - 0.05, 0.09).tolist():
                reach = 0.06 * (z - base) / (high - base)
                d.bar((x0 + reach, 0.0, z), (x1 - reach, 0.0, z), 0.011, metal, segments=6)
            d.box(Box((x0 + 0.03, x1 - 0.03), (-0.037, 0.018), (base - 0.05, base - 0.02)), metal)
            plate = Box.around(((x0 + x1) / 2, 0.013, high - 0.045), 0.2, 0.05, 0.05)
            d.box(plate, "grey plastic", bevel=0.008)


@draws("massage_table", whole=True)
def massage_table(d: Drawing) -> None:
    """A padded top with a face cradle at its head, on folding wooden legs with braces, or on a cabinet."""
    cover = d.material("cover", "white leather, black leather, brown leather, tan leather, teal paint, navy fabric")
    wood = d.material("frame", "beech, oak, walnut, white paint")
    box, pad = d.bounds.inset(back=0.26), 0.075
    halves = box.split("x", 2, gap=0.004)
    with d.part("top"):
        for half in halves:
            d.box(half.top(0.14).inset(x=0.003, y=0.006, top=pad - 0.003), wood, bevel=0.004)
            d.cushion(half.top(pad), cover, 0.03)
    with d.part("cradle"), d.at(box.x[0], z=box.height):
        turn = np.radians(np.linspace(45, 315, 13))
        d.sweep(np.c_[0.105 * np.cos(turn) - 0.135, 0.11 * np.sin(turn), 0 * turn - 0.045], 0.042, cover)
        d.cushion(Box((-0.2, -0.08), (-0.11, 0.11), (-0.1, -0.08)), wood, 0.008)
        with d.mirror("y"):
            d.bar((0.05, 0.09, -0.1), (-0.14, 0.09, -0.085), 0.012, "brushed steel", segments=8)
    under = box.inset(top=0.13)
    if d.chance("cabinet", 0.3):
        with d.part("cabinet"):
            d.box(under.bottom(0.07).inset(x=0.16, y=0.1), "black paint")
            body = d.box(under.inset(bottom=0.07, x=0.1, y=0.06), wood)
            with d.mirror("y"):
                for door in body.left(-0.016).inset(x=0.02, z=0.02).split("x", 3, gap=0.008):
                    d.box(door, wood)
                    d.box(door.left(-0.015).top(0.12).move(z=-0.05).front(0.012).move(x=-0.04), "brushed steel")
    else:
        with d.at(box.center[0]), d.mirror("x"), d.part("legs"):
            x = box.depth / 2 - 0.12
            with d.mirror("y"):
                y = box.y[1] - 0.06
                leg(d, (x + 0.05, y, 0.012), (x, y, under.height), 0.035, 0.04, wood, 4)
                d.box(Box.sized(0.044, 0.044, 0.02, (x + 0.05, y, 0.0)), "rubber")
                d.bar((x + 0.03, y, 0.33), (x - 0.42, y, under.height), 0.012, wood, segments=6)
            d.box(Box((x + 0.024, x + 0.046), (-y, y), (0.2, 0.25)), wood)
    for name, half in zip(("top-head", "top"), halves, strict=True):
        d.surface(name, half, inset=0.045)
