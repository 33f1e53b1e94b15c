"""Desks: tables with room for knees at the front (+x) and a back that goes to the wall."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, draws
from ...drawing.components import REACH
from .tables import KNEES
from .tables_parts import drawer_case, end_frame, pedestal_of_drawers, tabletop

BOARDS = ("oak", "light oak", "walnut", "white paint", "birch", "ash grey wood", "wenge")
METALS = ("black steel", "white steel", "brushed steel", "iron")


@draws("corner_desk")
def corner_desk(d: Drawing) -> None:
    """An L: a wing along the back, one along a side, panel ends or steel, drawers at the end of the side wing."""
    top, bounds = d.material("top", *BOARDS), d.bounds
    deep, wing = d.uniform("depth", 0.6, 0.68), d.uniform("wing", 0.5, 0.58)
    s, steel = d.pick("side", [-1, 1]), d.chance("steel", 0.45)
    look = d.material("legs", *METALS) if steel else top
    pull = d.material("pulls", "black steel", "brass", "brushed steel")
    fronts = d.material("fronts", "white paint", "light grey paint") if d.chance("two tone", 0.3) else top
    plate = bounds.top(0.025)
    low, (x0, x1), half = plate.z[0], bounds.x, bounds.width / 2
    edge, bend = x0 + deep, half - wing  # the wing lies at y > bend, mirrored if it is at the right

    def beside(y0: float, y1: float, box: Box) -> Box:
        """A box between two places, told from the wing's side."""
        return box.to(y=(y0, y1) if s > 0 else (-y1, -y0))

    main, side = plate.back(deep), beside(bend, half, plate.inset(back=deep))
    with d.part("main top"):
        d.box(main, top)
    with d.part("wing top"):
        d.box(side, top)
    m = 0.01
    ring = [(x0 + m, -half + m), (edge - m, -half + m), (edge - m, bend + m), (x1 - m, bend + m), (x1 - m, half - m)]
    ring.append((x0 + m, half - m))
    d.surface("top", plate, polygon=ring if s > 0 else [(x, -y) for x, y in ring[::-1]])
    under = bounds.to(z=(0.0, low))
    if steel:
        with d.part("end"):
            end_frame(d, beside(0.0175 - half, 0.0625 - half, under.back(deep).inset(x=0.03)), look, "loop")
        with d.part("corner leg"):
            d.box(beside(half - 0.0825, half - 0.0375, under.inset(back=0.03).back(0.045)), look)
        with d.part("rail"):
            d.box(under.inset(back=0.04, y=0.06).back(0.02).top(0.08), look)
    else:
        with d.part("side"):
            d.box(beside(0.0275 - half, 0.0525 - half, under.back(deep).inset(back=0.02, front=0.03)), look)
        with d.part("back"):
            d.box(under.inset(back=0.03, y=0.045, bottom=0.2).back(0.018), look, bevel=0.0)
        with d.part("wing back"):
            d.box(beside(half - 0.039, half - 0.021, under.inset(back=0.05, front=0.45)), look, bevel=0.0)
    # The stack opens toward the sitter, across the wing.
    with d.at(x1 - 0.23, s * (half - 0.02), 0.0, yaw=-s * math.pi / 2):
        stack = Box((0.0, wing - 0.045), (-0.21, 0.21), (0.0, low - 0.001))
        pedestal_of_drawers(d, stack, top, fronts, pull, d.pick("pull style", ["bar", "knob"]))
    d.clear(beside(0.1 - half, bend, bounds.to(x=(x0 + 0.1, edge), z=(0.0, KNEES))))
    d.clear(beside(-half, bend - 0.02, bounds.inset(back=deep)))


@draws("standing_desk")
def standing_desk(d: Drawing) -> None:
    """A top on two telescopic columns with long feet, a cross rail, a control panel and a tray for cables."""
    top = d.material("top", "oak", "white paint", "walnut", "black paint", "bamboo", "light oak")
    metal = d.material("frame", "black steel", "white steel", "grey paint")
    bounds, cut = d.bounds, d.uniform("cut", 0.5, 0.56)
    plate, at = bounds.top(0.026), bounds.y[1] - 0.25
    low = plate.z[0]
    with d.part("top"):
        tabletop(d, plate, top, d.pick("corner", [0.02, 0.06]))
        with d.mirror("y"):
            d.box(plate.bottom(-0.03).inset(x=0.08).to(y=(at - 0.03, at + 0.03)), metal)
        d.box(plate.bottom(-0.045).inset(y=0.28).to(x=(-0.06, -0.02)), metal)
        panel = d.box(plate.bottom(-0.018).inset(front=0.005, left=0.13).front(0.045).left(0.11), "black plastic")
        for key in panel.inset(y=0.008).columns(4):
            d.print(key.place(width=0.014, height=0.008).front(0.0), "grey plastic")
    with d.mirror("y"):
        foot = bounds.inset(x=0.06).to(y=(at - 0.035, at + 0.035))
        with d.part("foot"):
            profile = [(x, z) for x in foot.x for z in (0.012, 0.03)] + [(-0.06, 0.055), (0.03, 0.055)]
            d.hull([(x, y, z) for x, z in profile for y in foot.y], metal)
            for x in (foot.x[0] + 0.03, foot.x[1] - 0.03):
                d.cylinder(Box.sized(0.04, 0.04, 0.012, (x, at, 0.0)), "rubber", segments=12)
        with d.part("column"):
            tube = d.box(foot.to(x=(-0.08, 0.02), z=(0.05, cut)), metal, bevel=0.004)
            d.box(tube.inset(x=0.007, y=0.006).to(z=(cut, low - 0.03)), metal, bevel=0.004)
    with d.part("tray"):
        tray = plate.bottom(-0.09).inset(back=0.06).back(0.14).place(width=0.6 * bounds.width)
        d.box(tray.bottom(0.006), metal, bevel=0.001)
        d.box(tray.inset(bottom=0.006).back(0.005), metal, bevel=0.0)
        d.box(tray.inset(bottom=0.006, top=0.05).front(0.005), metal, bevel=0.0)
    d.clear(bounds.inset(y=0.35).to(x=(0.06, bounds.x[1]), z=(0.0, KNEES)))


@draws("school_desk")
def school_desk(d: Drawing) -> None:
    """A single or double top on a frame of steel tube, with a tray for books and a hook for the bag."""
    top = d.material("top", "beech", "birch", "light oak", "light grey paint", "plywood")
    metal = d.material("frame", "grey paint", "blue paint", "black steel", "red paint", "green paint", "chrome")
    bounds, radius, kind = d.bounds, 0.0175, d.pick("legs", ["c", "four"])
    plate, (x0, x1), at = bounds.top(0.022), bounds.x, bounds.y[1] - 0.06
    low = plate.z[0]
    with d.part("top"):
        tabletop(d, plate, top, 0.04)
        d.print(plate.top(0.0).inset(back=0.03, y=0.12).back(0.015), metal)
    if kind == "c":
        back, front = (x0 + 0.15, x0 + 0.15), (x0 + 0.08, x1 - 0.05)
        tubes = ((*back, 0.0, low - 0.01), (*front, radius, radius), (*front, low - 0.02, low - 0.02))
    else:
        across = (x0 + 0.06, x1 - 0.06)
        tubes = [(x, x, 0.0, low) for x in across] + [(*across, z, z) for z in (low - 0.03, 0.1)]
    with d.mirror("y"), d.part("end"):
        for start, end, z0, z1 in tubes:
            d.bar((start, at, z0), (end, at, z1), radius, metal, 12)
    with d.part("tray"):
        tray = plate.bottom(-0.08).inset(back=0.05, front=0.1, y=0.09)
        d.box(tray.bottom(0.008), metal, bevel=0.001)
        walls = tray.inset(bottom=0.008)
        for wall in (walls.back(0.008), walls.inset(back=0.008).left(0.008), walls.inset(back=0.008).right(0.008)):
            d.box(wall, metal, bevel=0.0)
    with d.part("rail"):
        d.bar((x0 + 0.14, -at, 0.36), (x0 + 0.14, at, 0.36), 0.8 * radius, metal)
    d.bar((0.02, at, low - 0.1), (0.02, at + 0.03, low - 0.115), 0.004, metal, 6)
    d.clear(bounds.inset(back=0.2, y=0.1).to(z=(0.0, min(KNEES, low - 0.088))))
    d.fit()


@draws("teacher_desk")
def teacher_desk(d: Drawing) -> None:
    """A heavy desk with two stacks of drawers, a drawer between them, panelled back and a leather inlay."""
    wood = d.material("body", "mahogany", "walnut", "cherry", "oak", "wenge")
    pull, style = d.material("pulls", "brass", "bronze", "black steel"), d.pick("pull style", ["knob", "cup", "bar"])
    bounds = d.bounds
    plate = bounds.top(0.032)
    with d.part("top"):
        tabletop(d, plate, wood)
        if d.chance("inlay", 0.6):
            leather = d.material("inlay", "brown leather", "black leather", "green paint")
            d.print(plate.top(0.0).inset(back=0.1, front=0.06, y=0.14), leather, 0.0004)
        d.box(plate.bottom(-0.012).inset(x=0.015, y=0.015), wood, bevel=0.005)
    under = bounds.inset(back=0.035, front=0.01 + REACH[style], y=0.03).to(z=(0.0, plate.z[0] - 0.012))
    wide = min(0.44, 0.28 * bounds.width)
    for name, stack in (("right", under.right(wide)), ("left", under.left(wide))):
        pedestal_of_drawers(d, stack, wood, wood, pull, style, 3, name, 0.07)
        with d.part(f"{name} stack"):
            d.box(stack.bottom(0.07).inset(front=0.015, back=-0.01, y=-0.008), wood, bevel=0.01)
            panel = stack.to(z=(0.13, stack.z[1] - 0.06))
            d.box(panel.inset(y=0.05).back(-0.008), wood)
            outer = panel.inset(x=0.08)
            d.box(outer.right(-0.008) if name == "right" else outer.left(-0.008), wood)
    middle = under.inset(y=wide)
    with d.part("middle"):
        # A knob, as a hand has no room over a wider pull.
        drawer_case(d, middle.inset(back=0.08, front=0.005).top(0.075), wood, wood, pull, "knob", name="middle")
    with d.part("modesty"):
        board = d.box(middle.inset(back=0.015, bottom=0.08).back(0.02), wood, bevel=0.0)
        d.box(board.inset(y=0.06, z=0.06).back(-0.008), wood)
    d.clear(middle.inset(back=0.06, y=0.01).to(z=(0.0, KNEES)))
    d.fit()
