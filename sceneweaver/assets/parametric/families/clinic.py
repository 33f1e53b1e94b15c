"""Examination rooms, dentists, hospitals."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, draws
from ...drawing.components import bottle, castors, drawer, legs, unit, walls

_STEELS = "white steel, steel, brushed steel, light grey paint"
_PADS = "black leather, white leather, teal paint, blue plastic, mint plastic"


@draws("examination_table", whole=True)
def examination_table(d: Drawing) -> None:
    """A padded couch with a raised head end and a roll of paper, on a cabinet or a frame."""
    pad, metal = d.material("pad", _PADS), d.material("frame", _STEELS)
    box, (deep, w, h) = d.bounds, d.size
    (x0, x1), z, head = box.x, h - 0.28, box.x[0] + 0.32 * deep
    stand = box.to(z=(0.0, z - 0.05))
    if d.chance("cabinet", 0.5):
        d.box(stand.bottom(0.07).inset(x=0.12, y=0.08), "black plastic", 0.0)
        case = d.box(stand.inset(x=0.08, y=0.04, bottom=0.06, top=0.03), metal, 0.006)
        with d.mirror("y"):
            for panel in case.left(-0.012).inset(right=-0.002, x=0.05, z=0.06).split("x", 3, gap=0.02):
                d.box(panel, metal)
    else:
        frame = stand.inset(x=0.1, y=0.04)
        legs(d, frame, metal, "round", 0.04)
        walls(d, frame.inset(x=0.008, y=0.008).to(z=(0.186, 0.214)), metal, 0.024)
    d.box(box.to(z=(z - 0.09, z - 0.05)).inset(x=0.05, y=0.03), metal)
    seat = d.cushion(box.to(x=(head + 0.01, x1), z=(z - 0.055, z + 0.04)), pad, 0.025)
    long = math.hypot(head - x0, h - z - 0.05)
    rise = math.asin(min(0.9, (h - z - 0.04) / long))
    with d.at(head, 0.0, z - 0.05, pitch=rise):
        d.cushion(Box((-long, 0.0), box.y, (0.0, 0.09)), pad, 0.025)
    foot = (head - 0.6 * long * math.cos(rise), 0.0, z - 0.05 + 0.6 * long * math.sin(rise))
    d.bar((head - 0.25, 0.0, z - 0.07), foot, (0.04, 0.04), metal)
    d.box(seat.top(-0.002).inset(bottom=-0.002, back=0.01, front=0.002, y=0.1 * w), "paper", 0.001)
    d.cylinder(Box.around((x1 - 0.03, 0.0, z - 0.1), 0.08, 0.8 * w, 0.08), "paper", "y", segments=14)


@draws("medical_cabinet", whole=True)
def medical_cabinet(d: Drawing) -> None:
    """A white cabinet with glazed doors above, solid ones below, a red cross, bottles inside."""
    steel = d.material("case", "white steel, light grey paint, sage paint")
    low, high = d.bounds.inset(front=0.027).rows([0.42, 0.58])
    unit(d, "low", low, "doors", steel, steel, "steel")
    room = unit(d, "high", high, "doors", steel, steel, "steel", panel="glass", boards=0)
    looks = ("amber glass", "white plastic", "blue plastic", "green glass", "clear plastic")
    levels = room.inset(front=0.03).rows(3, gap=0.008)  # full of bottles
    for level in levels[1:]:
        d.box(level.bottom(-0.008), "glass", bevel=0.0015)
    for k, shelf in enumerate(levels):
        for j, cell in enumerate(shelf.inset(y=0.02).columns(int(room.width / 0.11))):
            look, tall = d.pick(f"look {k} {j}", looks), shelf.height * d.uniform(f"t {k} {j}", 0.35, 0.7)
            bottle(d, cell.place(0.06, 0.06, tall, at="bottom"), look)
    cross = low.front(0.0).share(y=(0.68, 0.84)).place(height=0.1)
    for wide, tall in ((0.1, 0.032), (0.032, 0.1)):
        d.print(cross.place(width=wide, height=tall), "red plastic")


@draws("iv_stand", whole=True)
def iv_stand(d: Drawing) -> None:
    """A pole on five castors with hooks, a bag of fluid and its line; a pump on some."""
    h, reach, black = d.size.height, d.size.depth / 2 - 0.03, "black plastic"
    with d.ring(5):
        d.bar((0.0, 0.0, 0.1), (reach, 0.0, 0.08), 0.014, "steel", 8)
        d.cylinder(Box.around((reach, 0.0, 0.03), 0.06, 0.02, 0.06), black, "y", segments=14)
        d.bar((reach, 0.0, 0.05), (reach, 0.0, 0.085), 0.01, black, 8)
    poles = ((0.014, 0.08, 0.6 * h, "steel"), (0.009, 0.55 * h, h - 0.03, "chrome"), (0.022, 0.58 * h, 0.62 * h, black))
    for radius, low, high, look in poles:
        d.bar((0.0, 0.0, low), (0.0, 0.0, high), radius, look, 12)
    with d.ring(4):
        d.sweep([(0.0, 0.0, h - 0.04), (0.09, 0.0, h - 0.06), (0.1, 0.0, h - 0.005)], 0.005, "chrome", 6)
    look = d.material("bag", "clear plastic, yellow plastic, red plastic")
    d.cushion(Box((-0.02, 0.02), (0.03, 0.15), (h - 0.36, h - 0.1)), look, 0.015, 0.3)
    d.bar((0.0, 0.09, h - 0.11), (0.0, 0.09, h - 0.055), 0.004, "white plastic", 6)
    line = [(0.0, 0.09, h - 0.355), (0.02, 0.09, h - 0.5), (0.05, 0.08, 0.5 * h), (0.04, 0.04, 0.6 * h)]
    d.sweep(line, 0.003, "clear plastic", 5)
    if d.chance("pump", 0.5):
        pump = d.box(Box((0.012, 0.09), (-0.06, 0.06), (0.45 * h, 0.45 * h + 0.18)), "white plastic", 0.012)
        d.print(pump.front(0.0).share(y=(0.16, 0.84), z=(0.45, 0.85)), "screen")


@draws("medical_scale", whole=True)
def medical_scale(d: Drawing) -> None:
    """A platform scale with a column, sliding weights and a height rod."""
    body = d.material("body", "white steel, grey paint, light grey paint")
    box, (_, w, h) = d.bounds, d.size
    base = d.box(box.bottom(0.06), body, 0.01)
    d.box(base.top(-0.02).inset(bottom=-0.005, back=0.14, front=0.02, y=0.02), "rubber")
    x, z = box.x[0] + 0.06, min(1.35, h - 0.3)
    d.box(Box.sized(0.07, 0.08, z - 0.05, (x, 0.0, 0.05)), body, 0.008)
    head = d.box(Box.sized(0.07, 0.92 * w, 0.05, (x + 0.005, 0.0, z)), body, 0.008)
    with d.mirror("y"):
        d.box(Box.sized(0.03, 0.024, 0.08, (x, 0.44 * w, z + 0.04)), body)
    for lift, y in ((0.065, 0.15 * w), (0.1, -0.22 * w)):
        d.box(head.to(x=(x - 0.01, x + 0.01), z=(z + lift, z + lift + 0.015)), "brushed steel", 0.002)
        d.box(Box.around((x + 0.002, y, z + lift + 0.008), 0.04, 0.05, 0.035), "black plastic")
    d.box(Box((x - 0.012, x), (-0.02, 0.02), (z, h)), "aluminium", 0.002)
    d.box(Box((x - 0.014, x + 0.22), (-0.03, 0.03), (h - 0.05, h - 0.04)), "aluminium", 0.002)


@draws("privacy_screen", whole=True)
def privacy_screen(d: Drawing) -> None:
    """A folding ward screen: three framed panels of gathered cloth on castors, the outer ones turned forward."""
    cloth = d.material("cloth", "blue fabric, mint plastic, white fabric, green fabric, sheer fabric")
    metal, (deep, w, h) = d.material("frame", "steel, white steel, chrome"), d.size
    long = 0.4 * w
    turn = math.asin(min(0.9, (deep - 0.06) / long))
    wide = w - 2 * long * math.cos(turn)
    places = ((-wide / 2, 0.0, wide), (wide / 2, -turn, long), (-wide / 2, math.pi + turn, long))
    for name, (start, yaw, length) in zip(("middle", "left", "right"), places, strict=True):
        with d.part(name), d.at(0.0, start, yaw=yaw):
            with d.along((0.0, 0.0, 0.0), (0.0, length, 0.0), 2):
                d.bar((0.0, 0.0, 0.045), (0.0, 0.0, h), 0.013, metal, 8)
                d.cylinder(Box.around((0.0, 0.0, 0.03), 0.022, 0.06, 0.06), "black plastic", "x", segments=14)
            for z in (0.2, h - 0.02):
                d.bar((0.0, 0.0, z), (0.0, length, z), 0.012, metal, 8)
            sheet = d.box(Box((-0.003, 0.003), (0.015, length - 0.015), (0.22, h - 0.04)), cloth, 0.0)
            for fold in sheet.columns(max(4, round(length / 0.06)), gap=0.035):
                d.box(fold.inset(x=-0.005), cloth, 0.004)


@draws("dental_chair", whole=True)
def dental_chair(d: Drawing) -> None:
    """A reclined chair on a foot, with a lamp on an arm, an instrument tray and a spittoon."""
    pad, shell, (deep, w, h) = d.material("pad", _PADS), "white plastic", d.size
    y, long = w / 2 - 0.16, (deep / 2 - 0.3) / math.cos(0.55)
    with d.part("chair"):
        d.box(Box.sized(0.7, 0.5, 0.06), shell, 0.02)
        d.sections(Box.sized(0.52, 0.4, 0.38, (0.0, 0.0, 0.05)), [(1, 1, 0), (0.65, 0.65, 1)], shell, 0.2, True)
        d.cushion(Box((-0.2, 0.3), (-0.27, 0.27), (0.42, 0.54)), pad, 0.05)
        with d.at(0.28, 0.0, 0.48, pitch=0.25):
            d.cushion(Box((0.0, deep / 2 - 0.25), (-0.23, 0.23), (-0.05, 0.06)), pad, 0.045)
        with d.at(-0.17, 0.0, 0.48, pitch=0.55):
            d.cushion(Box((-long, 0.02), (-0.26, 0.26), (-0.04, 0.08)), pad, 0.045)
            d.cushion(Box((-long - 0.17, -long + 0.02), (-0.13, 0.13), (-0.01, 0.1)), pad, 0.04)
        with d.mirror("y"):
            d.box(Box((-0.2, 0.15), (0.265, 0.335), (0.66, 0.7)), shell, 0.012)
            d.box(Box((-0.16, -0.1), (0.28, 0.32), (0.46, 0.67)), shell, 0.008)
    with d.part("unit"):
        d.box(Box((0.0, 0.3), (y - 0.1, y + 0.14), (0.0, 0.75)), shell, 0.03)
        d.cylinder(Box.around((0.2, y, 0.77), 0.22, 0.22, 0.06), "white ceramic", ends=(0.8, 1.0), bevel=0.01)
        d.box(Box((0.0, 0.3), (0.2, y), (0.1, 0.2)), shell, 0.02)
    with d.part("lamp"):
        d.sweep([(0.05, y, 0.7), (0.05, y, h - 0.02), (-0.05, y - 0.02, h - 0.02), (-0.2, 0.05, h - 0.12)], 0.02, shell)
        lamp = d.box(Box((-0.28, -0.14), (-0.12, 0.16), (h - 0.24, h - 0.14)), shell, 0.02)
        d.print(lamp.bottom(0.0).inset(x=0.02, y=0.04), "lamp glow")
    with d.part("tray"):
        d.sweep([(0.1, y, 0.72), (0.25, 0.5 * y, 0.84), (0.3, -0.2 * w, 0.86)], 0.018, shell, 8)
        tray = d.box(Box((0.16, 0.46), (-w / 2, 0.45 - w / 2), (0.86, 0.9)), shell, 0.012)
        d.print(tray.top(0.0).inset(x=0.02, y=0.02), "steel")
        for k, place in enumerate(tray.top(-0.012).inset(x=0.06, y=0.05).columns(5, gap=0.058)):
            d.cylinder(place, ("blue plastic", "steel")[k % 2], "x", segments=6)


@draws("stretcher", whole=True)
def stretcher(d: Drawing) -> None:
    """A mattress on a wheeled frame with fold-down rails and a raised back."""
    pad = d.material("pad", "blue plastic, black leather, green plastic, grey plastic")
    metal = d.material("frame", "white steel, steel, grey paint")
    box, (deep, w, h), z = d.bounds, d.size, d.size.height - 0.3
    castors(d, box.bottom(0.17).inset(x=0.2, y=0.05))
    base = d.box(box.to(z=(0.16, 0.26)).inset(x=0.2, y=0.12), metal, 0.02)
    with d.mirror("x"):
        d.cylinder(Box.sized(0.14, 0.14, z - 0.3, (0.18 * deep, 0.0, base.z[1] - 0.01)), metal, segments=20)
    d.box(box.to(z=(z - 0.09, z - 0.04)).inset(x=0.03, y=0.05), metal, 0.01)
    head, mat = box.x[0] + 0.36 * deep, box.inset(y=0.07)
    d.cushion(mat.to(x=(head, box.x[1] - 0.05), z=(z - 0.04, z + 0.06)), pad, 0.03)
    long = (head - box.x[0] - 0.05) / math.cos(0.35)
    with d.at(head, 0.0, z - 0.04, pitch=0.35):
        d.cushion(mat.to(x=(-long, 0.02), z=(0.0, 0.1)), pad, 0.03)
        d.pillow(Box((0.02 - long, 0.3 - long), (-0.28 * w, 0.28 * w), (0.09, 0.18)), "white fabric")
    with d.mirror("y"):
        y = w / 2 - 0.02
        rail = [(-0.2 * deep, z - 0.08), (-0.17 * deep, h - 0.02), (0.2 * deep, h - 0.02), (0.23 * deep, z - 0.08)]
        d.sweep([(x, y, k) for x, k in rail], 0.014, "chrome", 8)
        with d.along((-0.1 * deep, y, z - 0.07), (0.13 * deep, y, z - 0.07), 4):
            d.bar((0.0, 0.0, 0.0), (0.0, 0.0, h - z + 0.05), 0.008, "chrome", 6)
        d.box(Box((-0.22 * deep, 0.25 * deep), (y - 0.012, y + 0.012), (z - 0.1, z - 0.06)), metal)
        d.box(Box((-0.1 * deep, 0.1 * deep), (y - 0.08, y), (z - 0.09, z - 0.05)), metal)
    with d.mirror("x"):
        bail = [(-0.06, -0.3, -0.06), (-0.014, -0.3, 0.1), (-0.014, 0.3, 0.1), (-0.06, 0.3, -0.06)]
        d.sweep([(box.x[1] + e, s * w, z + k) for e, s, k in bail], 0.013, "black plastic", 8)


@draws("instrument_trolley", whole=True)
def instrument_trolley(d: Drawing) -> None:
    """A steel trolley: shelves with rims, a drawer, castors, bowls and instruments on top."""
    metal, box, h = d.material("frame", "steel, brushed steel, white steel"), d.bounds, d.size.height
    plan, top = box.inset(x=0.01, y=0.01), h - 0.06
    with d.part("low"):
        castors(d, box.bottom(0.09))
        shelf = d.box(plan.to(z=(0.2, 0.22)), metal, 0.002)
    for name, y in (("right", box.y[0] + 0.02), ("left", box.y[1] - 0.02)):
        with d.part(name), d.mirror("x"):
            d.bar((box.x[1] - 0.02, y, 0.07), (box.x[1] - 0.02, y, h), 0.012, metal, 8)
    with d.part("top"):
        board = d.box(plan.to(z=(top - 0.012, top)), metal, 0.002)
        if d.chance("drawer", 0.6):
            place = board.bottom(-0.12).inset(back=0.02, front=0.012, y=0.05)
            drawer(d, "drawer", place, metal, "black plastic", "cup", inside="steel")
        (x0, x1), (y0, y1), z = plan.x, plan.y, h - 0.012
        d.sweep([(x1 - 0.01, y0, z), (x0, y0, z), (x0, y1, z), (x1 - 0.01, y1, z)], 0.008, metal, 6)
        dish = Box.sized(0.18, 0.18, 0.05, (0.0, 0.25 * box.width, top))
        d.turned(dish, [(0.55, 0.0), (0.9, 0.6), (1.0, 1.0)], "chrome", 20)
        for tool in board.top(-0.012).share(x=(0.3, 0.7), y=(0.13, 0.5)).columns(5, gap=0.036):
            d.cylinder(tool, "chrome", "x", segments=6)
        d.box(Box((-0.25 * box.depth, 0.15 * box.depth), (0.02, 0.1), (top, top + 0.05)), "blue plastic")
    d.surface("shelf-0", shelf, 0.4, inset=0.04)


@draws("hand_sanitizer_stand", whole=True)
def hand_sanitizer_stand(d: Drawing) -> None:
    """A slim post with a dispenser, a drip tray and a sign."""
    metal = d.material("post", "white steel, aluminium, black steel")
    box, h = d.bounds, d.size.height
    d.box(box.bottom(0.015), metal)
    d.box(Box((-0.03, 0.0), (-0.05, 0.05), (0.01, h - 0.3)), metal, 0.006)
    sign = d.box(box.to(x=(-0.02, -0.008), z=(h - 0.32, h)).share(y=(0.14, 0.86)), metal, 0.002)
    face = d.print(sign.front(0.0).inset(y=0.012, z=0.02), "blue plastic")
    d.print(face.place(width=0.12, height=0.04), "white plastic", 0.0004)
    d.print(face.place(width=0.04, height=0.12), "white plastic", 0.0004)
    case = d.box(Box((-0.002, 0.1), (-0.06, 0.06), (h - 0.6, h - 0.35)), "white plastic", 0.015)
    d.print(case.front(0.0).share(y=(0.25, 0.75), z=(0.28, 0.8)), "sky pigment")
    d.box(case.bottom(-0.02).inset(top=-0.01).place(0.04, 0.03).move(x=0.01), "grey plastic")
    d.box(case.bottom(-0.2).bottom(0.015).to(x=(-0.002, box.x[1] - 0.01)).inset(y=-0.01), "grey plastic")
