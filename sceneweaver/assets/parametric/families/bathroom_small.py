"""Bathroom accessories: towels, mirrors, paper, mats, hampers, bars, dispensers."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, Vec3, draws
from ...drawing.components import carcass, compartments, lip, open_box, oval, perimeter, walls
from .small_parts import BARE

_METALS = "chrome, black steel, brass, brushed steel"
_TERRY = ", ".join(f"{tone} fabric" for tone in ["white", "blue", "green", "rose", "grey", "mustard", "beige", "navy"])


def _hung_towel(d: Drawing, bar: Vec3, radius: float, width: float, front: float, back: float) -> None:
    """A towel over a bar along y whose middle is at a point; it hangs down by ``front`` and ``back`` [m]."""
    cloth = d.material("towel", _TERRY)
    r, over = radius + 0.005, np.linspace(math.pi, 0.0, 5)
    path = [(-r - 0.004, -back), *np.c_[r * np.cos(over), r * np.sin(over)], (r, -0.5 * front)]
    path = np.array([*path, (r + 0.006, -front + 0.08), (r + 0.006, -front + 0.05), (r + 0.007, -front)])
    across = np.linspace(-width / 2, width / 2, 13)
    fold = 0.004 * np.sin(9 * np.pi * (across / width + 0.5)) * np.clip(-path[:, 1:] / front, 0, 1)
    x = bar[0] + path[:, :1] + np.sign(path[:, :1]) * fold
    grid = np.stack(np.broadcast_arrays(x, bar[1] + across, bar[2] + path[:, 1:]), axis=-1)
    d.sheet(grid, 0.008, cloth, (5, 1))
    stripe = grid[-3:-1] + (0.004, 0.0, 0.0)
    d.sheet(stripe, 0.002, "white fabric" if not cloth.called("white fabric") else "grey fabric")


def _rosette(d: Drawing, at: Vec3, radius: float, metal: Look, thick: float = 0.009) -> None:
    """The round plate of a fitting on the wall; the point lies on the wall."""
    with d.at(*at, pitch=math.pi / 2):
        d.cylinder(Box.sized(2 * radius, 2 * radius, thick), metal, ends=(1.0, 0.92), segments=20)


def _roll(d: Drawing, at: Vec3, radius: float, length: float) -> None:
    """A paper roll with its core lying along y about a point."""
    d.cylinder(Box.around(at, 2 * radius, length, 2 * radius), "paper", "y", segments=28)
    d.cylinder(Box.around(at, 0.04, length + 0.001, 0.04), "cardboard", "y", segments=16)


@draws("towel_rail", whole=True)
def towel_rail(d: Drawing) -> None:
    """A bar on two brackets with a hung towel."""
    metal = d.material("bar", _METALS)
    box = d.bounds
    x, z = box.x[1] - 0.025, box.z[1] - 0.022
    d.bar((x, box.y[0], z), (x, box.y[1], z), 0.009, metal)
    with d.mirror("y"):
        end = box.y[1] - 0.03
        d.bar((box.x[0], end, z), (x, end, z), 0.009, metal)
        _rosette(d, (box.x[0], end, z), 0.025, metal)
    width = min(0.4, 0.6 * box.width)
    _hung_towel(d, (x, d.uniform("at", -0.12, 0.12) * box.width, z), 0.009, width, z, z - 0.07)


@draws("towel_radiator", whole=True)
def towel_radiator(d: Drawing) -> None:
    """Two uprights and tubes in groups, on brackets, with valves below; a towel on some."""
    metal, box = d.material("body", "white steel, white steel, chrome, black steel"), d.bounds
    x, y, h = box.x[1] - 0.03, box.y[1] - 0.016, box.z[1]
    tubes = max(12, int((h - 0.14) / 0.042))
    gaps = [int(tubes * share) for share in ((0.33, 0.66) if h < 1.2 else (0.25, 0.5, 0.78))]
    levels = np.linspace(0.1, h - 0.025, tubes).tolist()
    for z in (z for k, z in enumerate(levels) if k not in gaps and k - 1 not in gaps):
        d.cylinder(Box.around((x + 0.006, 0.0, z), 0.022, box.width - 0.03, 0.022), metal, "y", segments=10)
    with d.mirror("y"):
        d.cylinder(Box.sized(0.032, 0.032, h - 0.055, (x - 0.008, y, 0.055)), metal, bevel=0.004, segments=12)
        d.cylinder(Box.sized(0.026, 0.026, 0.07, (x - 0.008, y, 0.0)), "chrome", segments=12)
        for z, reach, look in ((0.2, y - 0.02, metal), (h - 0.15, y - 0.02, metal), (0.03, y, "chrome")):
            d.bar((box.x[0], reach, z), (x - 0.008, reach, z), 0.01, look, 8)
            _rosette(d, (box.x[0], reach, z), 0.02, look)
    d.cylinder(Box.around((x + 0.01, y, 0.03), 0.05, 0.028, 0.028), "white plastic", "x", segments=14)
    if d.request.shape != BARE and d.chance("towel", 0.5):
        _hung_towel(d, (x + 0.006, 0.0, levels[gaps[-1] - 1]), 0.011, 0.6 * box.width, 0.42, 0.3)


@draws("medicine_cabinet", whole=True)
def medicine_cabinet(d: Drawing) -> None:
    """A shallow cupboard whose one, two or three doors are mirrors; boards inside, a lamp above some."""
    shell, box = d.material("body", "white paint, aluminium, oak, walnut, light grey paint"), d.bounds
    lamp = d.chance("lamp", 0.5)
    case = box.inset(top=0.03 if lamp else 0.0, front=0.042)
    rooms = carcass(d, case, shell, board=0.014).inset(front=0.01).rows(3, gap=0.006)
    for level in rooms[1:]:
        d.box(level.bottom(-0.006), "glass", bevel=0.0)
    compartments(d, rooms)
    rim = 0.016 if shell.called("oak", "walnut") else 0.003
    cells = case.front(-0.018).columns(1 if box.width < 0.55 else 2 if box.width < 0.78 else 3)
    for k, leaf in enumerate(cell.inset(y=0.0015, z=0.0015) for cell in cells):
        last = k == len(cells) - 1
        hung, free, limits = ("left", "right", (0.0, 1.7)) if last else ("right", "left", (-1.7, 0.0))
        with d.hinge(f"door-{k}", leaf.anchor(f"front {hung} bottom"), limits=limits):
            d.box(leaf.inset(front=0.004), shell, bevel=0.001)
            d.box(leaf.front(0.006).inset(y=rim, z=rim), "mirror", bevel=0.0025)
            grip = leaf.inset(y=0.04).share(z=(0.3, 0.4)).place(width=0.01, at=free)
            lip(d, grip.to(x=(leaf.x[1], box.x[1] - 0.002)), "chrome", (0.0, 1.0, 0.0), bevel=0.002)
    if lamp:
        light = d.box(box.top(0.03).inset(y=0.03), "chrome", bevel=0.004)
        d.print(light.front(0.0).inset(y=0.02, z=0.005), "lamp glow")


@draws("toilet_paper_stand", even="round")
def toilet_paper_stand(d: Drawing) -> None:
    """A rod on a round foot with an arm that holds a roll, and spare ones on the foot."""
    metal, box = d.material("rod", _METALS), d.even("round")
    r, top = box.depth / 2, box.z[1] - 0.008
    with d.part("stand"):
        foot = d.cylinder(box.bottom(0.014), metal, bevel=0.003, segments=28)
        d.sweep([(0.0, 0.03 - r, 0.01), (0.0, 0.03 - r, top), (0.0, r - 0.012, top)], 0.008, metal)
        _roll(d, (0.0, 0.012, top - 0.02), 0.05, 0.09)
        d.box(Box((0.0475, 0.0495), (-0.03, 0.055), (top - 0.14, top - 0.02)), "paper", bevel=0.0)
    with d.part("spare"):
        for roll in Box.sized(0.096, 0.096, 0.182, (0.0, 0.025, foot.z[1] + 0.001)).rows(2, gap=0.001):
            d.cylinder(roll, "paper", bevel=0.003, segments=24)
            d.print(roll.top(0.0).inset(x=0.028, y=0.028), "cardboard", oval=True)
    d.fit(box.size)


@draws("toilet_paper_holder", whole=True)
def toilet_paper_holder(d: Drawing) -> None:
    """A bent bar, on some under a flap, and a roll with a hanging leaf."""
    metal, box = d.material("bar", _METALS), d.bounds
    h, r = box.height, box.depth / 2 - 0.008
    x, y, z = box.x[1] - r, 0.02 - box.width / 2, h - 0.054
    _roll(d, (x, 0.0, z), r, 0.1)
    d.box(Box((box.x[1] - 0.003, box.x[1] - 0.001), (-0.05, 0.05), (0.0, z)), "paper", bevel=0.0)
    _rosette(d, (box.x[0], y, h - 0.025), 0.021, metal, 0.012)
    end = (x, box.y[1] - 0.007, z)
    d.sweep([(box.x[0], y, h - 0.025), (x, y, h - 0.025), (x, y - 0.009, z), end], 0.006, metal)
    d.ball(Box.around(end, 0.02, 0.014, 0.02), metal, 12)
    if d.chance("flap", 0.6):
        drop = np.radians([90, 70, 50, 30])
        curve = [(box.x[0], h - 0.004), *np.c_[x + r * np.cos(drop), z + 0.05 * np.sin(drop)]]
        d.sheet(np.array([[(px, py, pz) for py in (-0.055, 0.055)] for px, pz in curve]), 0.003, metal, (4, 1))


@draws("bathroom_shelf")
def bathroom_shelf(d: Drawing) -> None:
    """Two or three glass or wooden boards with rails, between wall strips."""
    metal, box = d.material("metal", _METALS), d.bounds
    look = d.material("board", "glass, oak, bamboo, white paint, frosted glass")
    thick, count = 0.008 if look.kind == "glass" else 0.015, 2 if box.height < 0.42 else 3
    with d.part("wall"), d.mirror("y"):
        d.box(box.back(0.01).left(0.02).move(y=-0.03), metal, bevel=0.002)
    levels = np.linspace(0.02, box.z[1] - thick - 0.045, count).tolist()
    for k, (z, above) in enumerate(zip(levels, [*levels[1:], None], strict=True)):
        with d.part(f"board {k}"):
            shelf = d.box(box.inset(back=0.0105, front=0.012).to(z=(z, z + thick)), look, bevel=0.002)
            with d.mirror("y"):
                d.box(shelf.bottom(-0.012).left(0.014).inset(front=0.01).move(y=-0.033), metal, bevel=0.0)
        with d.part(f"rail {k}"):
            x, y, rail = box.x[1] - 0.006, box.y[1] - 0.008, z + thick + 0.03
            d.sweep([(x, -y, z), (x, -y, rail), (x, y, rail), (x, y, z)], 0.004, metal, 8)
        room = None if above is None else round(above - 0.014 - z - thick, 4)
        d.surface(f"shelf-{k}", shelf.inset(back=0.004, front=0.006, y=0.01), room)
    d.fit()


@draws("bath_mat", whole=True)
def bath_mat(d: Drawing) -> None:
    """A tufted mat with a hem and rows of pile, square or oval, or a slatted wooden one."""
    box, (_, w, h) = d.bounds, d.size
    if d.chance("slats", 0.25, matched=True):
        wood = d.material("mat", "bamboo, oak, walnut")
        with d.mirror("x"):
            d.box(box.share(x=(0.78, 0.87), z=(0.0, 0.5)).inset(y=0.01), wood, bevel=0.001)
        for slat in box.share(z=(0.45, 1.0)).columns(int(w / 0.055), gap=0.008):
            d.box(slat, wood, bevel=0.002)
        return
    cloth = d.material("mat", _TERRY)
    if d.chance("oval", 0.3, matched=True):
        for rows in ([(0.004, 0.0), (0.0, 0.4), (0.006, 0.75)], [(0.05, 0.7), (0.055, 1.0)]):
            d.loft([oval(box.inset(x=e, y=e), s * h) for e, s in rows], cloth, convex=True)
        return
    d.slab(box.share(z=(0.0, 0.5)), cloth, 0.03, 0.003)
    for row in box.inset(x=0.03, y=0.03).share(z=(0.45, 1.0)).columns(int((w - 0.06) / 0.03), gap=0.002):
        d.box(row, cloth, bevel=0.006)


def _weave(base: Box, rim: Box, radius: float, wall: float, depth: float = 0.007):
    """A woven body between two plans, open above: strands over and under the stakes of its wall [m], and grooves.

    Returns it and its convex parts.
    """
    strands = 2 * round((rim.depth + rim.width) / 0.052)
    rows = max(4, round((rim.z[1] - base.z[0]) / 0.038))
    # Each strand has a groove and two edges, near enough to it that the groove is seen as a crease.
    at = (np.arange(strands)[:, None] + (0.0, 0.1, 0.9)).ravel() / strands
    levels = [(k + v, k if v else None) for k in range(rows) for v in (0.0, 0.12, 0.88)] + [(rows, None)]
    (low, out), (high, beyond) = perimeter(base, radius, at), perimeter(rim, radius, at)
    groove, strand = np.arange(len(at)) % 3 == 0, np.arange(len(at)) // 3
    rings = []
    for level, row in levels:
        share = level / rows
        over = np.where((strand + (row or 0)) % 2 == 0, 0.0, 0.45)
        sunk = depth * np.where(groove | (row is None), 1.0, over)
        plane = low + share * (high - low) - out * sunk[:, None]
        rings.append(np.c_[plane, np.full(len(at), base.z[0] + share * (rim.z[1] - base.z[0]))])
    plans = [(high, beyond, rim.z[1]), (low, out, base.z[0] + 0.01)]  # and down again inside
    inner = [np.c_[plan - wall * normal, np.full(len(at), z)] for plan, normal, z in plans]
    outer = [np.c_[plan, np.full(len(at), z)] for plan, z in ((low, base.z[0]), (high, rim.z[1]))]
    ends = np.linspace(0, len(at), 13).round().astype(int).tolist()
    return shapes.lofted([*rings, *inner]), shapes.staved_hulls(outer, inner, ends)


@draws("laundry_hamper")
def laundry_hamper(d: Drawing) -> None:
    """A woven box with a lid, a liner that is folded over its rim, and grips; or an open one."""
    weave, box = d.material("body", "wicker, rattan"), d.bounds
    if d.request.shape == "open":
        open_box(d, box, weave, 0.012, 0.03)
        d.fit()
        return
    lid, body = box.top(0.034), box.inset(bottom=0.02, top=0.035, x=0.008, y=0.008)
    foot = body.inset(x=0.06 * box.depth, y=0.06 * box.width)
    with d.part("hamper"):
        skin, staves = _weave(foot, body, 0.035, 0.02)
        d.add(skin, weave, staves)
        d.interior("inside", foot.inset(x=0.03, y=0.03).to(z=(0.034, body.z[1])))
        with d.corners(foot, inset=0.03):
            d.cylinder(Box.sized(0.03, 0.03, 0.022), "oak", ends=(0.85, 1.0), segments=10)
        walls(d, body.top(0.055).inset(x=-0.002, y=-0.002), "white fabric", 0.02, 0.006)
        d.slab(foot.to(z=(0.018, 0.034)).inset(x=-0.003, y=-0.003), weave, 0.038, 0.004)
        with d.hinge("lid", lid.anchor("back top"), axis=(0.0, 1.0, 0.0), limits=(-1.4, 0.0), role="lid"):
            d.slab(lid.inset(top=0.008), weave, 0.04, 0.004)
            d.slab(lid.top(0.014).inset(x=0.012, y=0.012), weave, 0.03, 0.006)
            lip(d, lid.front(-0.022).place(width=0.06).bottom(0.008).move(z=0.004), "brown leather", bevel=0.001)
        with d.mirror("y"):
            y, z, rope = body.y[1] - 0.012, body.z[1] - 0.1, "rattan" if weave.called("wicker") else "wicker"
            d.arch((-0.07, y, z), (0.07, y, z), (0.0, 0.018, 0.03), 0.008, rope)
    d.fit()


@draws("scale", whole=True)
def scale(d: Drawing) -> None:
    """A plate on feet with a display and steel contacts; its user stands with the toes toward the display, at -x."""
    look = d.material("plate", "black glass, white plastic, frosted glass, grey plastic, white plastic, bamboo")
    box = d.bounds
    with d.corners(box, inset=0.04):
        d.cylinder(Box.sized(0.044, 0.044, 0.0085), "black plastic", ends=(0.9, 1.0), segments=14)
    d.box(box.inset(x=0.02, y=0.02, bottom=0.008, top=0.009), "grey plastic", bevel=0.002)
    top = d.slab(box.top(0.009), look, 0.03, 0.002).top(0.0)
    window = d.print(top.inset(back=0.025).back(0.05).place(width=0.1), "black glass")
    for digit in window.inset(y=0.02, x=0.012).columns(3, gap=0.008):
        d.print(digit, "lamp glow", 0.00045)
    with d.grid(top.share(x=(0.3, 0.85)), x=2, y=2):
        d.print(Box.sized(0.05, 0.07, 0.0), "brushed steel")


@draws("shower_stool", whole=True)
def shower_stool(d: Drawing) -> None:
    """A slatted or holed seat on four splayed legs with rubber feet."""
    wood = d.chance("wood", 0.5)
    look = d.material("seat", "bamboo, oak, walnut" if wood else "white plastic, grey plastic")
    frame: Look = look if wood else d.material("legs", "aluminium, chrome, white steel")
    seat = d.bounds.top(0.028)
    x, y, under = seat.x[1] - 0.042, seat.y[1] - 0.053, seat.z[0] - 0.11
    with d.corners(d.bounds, inset=0.018):
        d.bar((0.0, 0.0, 0.02), (0.032, 0.042, seat.z[0] + 0.004), 0.013, frame, 12)
        d.cylinder(Box.sized(0.036, 0.036, 0.03), "rubber", ends=(1.0, 0.85), segments=12)
    for start, end in (((x, -y), (x, y)), ((-x, -y), (-x, y)), ((-x, 0.0), (x, 0.0))):
        d.bar((*start, under), (*end, under), 0.008, frame, 8)
    if wood:
        with d.mirror("y"):
            d.box(seat.bottom(-0.02).inset(x=0.02).left(0.03).move(y=-0.045), look)
        for slat in seat.split("x", 6, gap=0.006):
            d.box(slat, look, bevel=0.004)
        return
    d.slab(seat, look, 0.06, 0.008)
    with d.grid(seat.top(0.0).place(0.18, 0.3), x=3, y=5):
        d.print(Box.sized(0.016, 0.016, 0.0), "black plastic", oval=True)
    d.surface("top", seat, inset=0.05)


@draws("grab_bar", whole=True)
def grab_bar(d: Drawing) -> None:
    """A thick bar bent to the wall at both ends, with round plates."""
    metal = d.material("bar", "brushed steel", "chrome", "white steel", "black steel")
    box = d.bounds
    x, z, end = box.x[1] - 0.016, box.center[2], box.y[1] - box.height / 2
    bend = [(box.x[0], end, z), (x - 0.025, end, z), (x - 0.007, end - 0.008, z), (x, end - 0.03, z)]
    d.sweep([*bend, *((px, -py, pz) for px, py, pz in reversed(bend))], 0.016, metal, 12)
    with d.mirror("y"):
        _rosette(d, (box.x[0], end, z), box.height / 2, metal)


@draws("hand_dryer", whole=True)
def hand_dryer(d: Drawing) -> None:
    """A rounded case with a nozzle below, a sensor, a grille and a sign."""
    coat, box = d.material("body", "white plastic, brushed steel, chrome, black plastic, white steel"), d.bounds
    face = d.cushion(box.inset(bottom=0.04), coat, radius=min(0.06, 0.4 * box.depth)).front(0.0)
    mouth = Box((-0.01, box.x[1] - 0.02), (-0.08, 0.08), (0.0, 0.07))
    d.sections(mouth, [(0.8, 0.75, 0.0), (1.0, 1.0, 1.0)], "chrome", 0.15, convex=True)
    d.print(mouth.bottom(0.0).share(x=(0.2, 0.8), y=(0.2, 0.8)), "black plastic")
    window = d.print(face.place(width=0.09, height=0.05), "black glass")
    d.print(window.place(width=0.012, height=0.012), "lamp glow", 0.00045)
    for line in face.bottom(0.05).move(z=0.05).place(width=0.1).rows(4, gap=0.008):
        d.print(line, "grey plastic")


@draws("paper_towel_dispenser", whole=True)
def paper_towel_dispenser(d: Drawing) -> None:
    """A case with a bowed front, a window, a lock, a slot below and a towel that hangs out."""
    coat, box = d.material("body", "white plastic, brushed steel, black plastic, grey plastic"), d.bounds
    case = box.inset(bottom=0.06)
    rows = ((0.14, case.z[0]), (0.0, case.z[0] + 0.06), (0.0, case.z[1] - 0.03), (0.1, case.z[1]))
    rings = [oval(box.inset(front=e * box.depth), z, 3.2, 8.0, box.x[0] + 1e-4, 24) for e, z in rows]
    d.loft(rings, coat, convex=True)
    mouth = case.bottom(-0.003).to(x=(0.0, box.x[1] - 0.024)).place(width=0.17)
    d.box(mouth.inset(top=-0.01), "black plastic", bevel=0.0)
    for near, low in ((0.012, 0.0), (0.026, 0.015)):
        fall = [[(near + 0.012 * s, y, z) for y in (-0.075, 0.075)] for s, z in ((0.0, case.z[0]), (1.0, low))]
        d.sheet(np.array(fall), 0.002, "paper")
    window = case.inset(bottom=0.08, top=0.12, front=-0.0005).front(0.02).place(width=0.04)
    d.print(d.box(window, "black glass", bevel=0.0).front(0.0).share(z=(0.01, 0.65)).inset(y=0.0015), "paper")
    d.cylinder(Box.around((box.x[1], 0.0, case.z[1] - 0.07), 0.006, 0.024, 0.024), "chrome", "x", segments=14)
