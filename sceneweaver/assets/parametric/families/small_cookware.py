"""What stands on a kitchen counter: pots and pans, kettles, small machines, boards, racks."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import knob
from .small_parts import CERAMICS, filling, open_vessel

METALS = "steel, brushed steel, black steel, copper, red paint, blue paint, iron"
SHELLS = "steel, black plastic, white plastic, red plastic, cream paint, brushed steel, mint plastic"
POT = [(0.88, 0.0), (0.93, 0.06), (0.97, 0.94), (1.0, 1.0)]
PAN = [(0.75, 0.0), (0.8, 0.1), (0.97, 0.92), (1.0, 1.0)]


def lid(d: Drawing, box: Box, look: Look, grip: Look) -> None:
    """A domed lid with a rim and a knob that fills a box."""
    d.turned(box, [(1.0, 0.0), (1.0, 0.06), *shapes.dome(0.95, 0.08, 0.5, 4, 0.12)], look)
    on_top = box.share(z=(0.48, 1.0)).place(0.04, 0.04)
    d.turned(on_top, [(0.4, 0.0), (0.35, 0.42), (1.0, 0.65), (0.9, 0.92), (0.4, 1.0)], grip, 14)


def long_grip(d: Drawing, start: float, reach: float, z: float, look: Look) -> None:
    """A pan's handle along +y from its wall at ``start``, rising a little, on a steel bracket."""
    with d.at(0.0, start, z, roll=0.13 - math.pi / 2):
        d.bar((0, 0, -0.006), (0, 0, 0.06), 0.007, "steel", 8)
        own = Box.sized(0.026, 0.02, reach - start - 0.035, (0.0, 0.0, 0.035))
        d.sections(own, [(0.7, 0.7, 0.0), (0.92, 0.92, 0.25), (1, 1, 0.7), (0.92, 0.92, 0.95), (0.5, 0.5, 1.0)], look)


def filter_machine(d: Drawing, look: Look, dark: Look) -> None:
    """A tank at the back, a head over the pot, a pot of coffee on a plate."""
    box = d.bounds
    d.slab(box.bottom(0.035), look, 0.03, 0.004)
    d.slab(box.inset(bottom=0.03, top=0.01).back(0.34 * box.depth), look, 0.025, 0.004)
    head = d.slab(box.share((0.0, 0.97), z=(0.7, 1.0)), look, 0.03, 0.006)
    r = min(0.3 * box.depth, 0.42 * box.width)
    pot = Box.sized(2 * r, 2 * r, 0.7 * box.height - 0.05, (box.x[1] - r - 0.012, 0.0, 0.035))
    d.cylinder(pot.bottom(0.001), "black steel")
    glass = [(0.82, 0.0), (1.0, 0.25), (0.92, 0.6), (0.62, 0.86)]
    d.turned(pot, glass, "glass")
    filling(d, pot, glass, 0.02, 0.5, "coffee")
    d.turned(pot, [(0.66, 0.84), (0.66, 0.9), (0.56, 1.0)], dark)
    x, _, z = pot.anchor("bottom")
    ends = ((x + 0.6 * r, 0, z + 0.92 * pot.height), (x + 0.92 * r, 0, z + 0.3 * pot.height))
    d.arch(*ends, (0.55 * r, 0, 0), 0.007, dark)
    d.print(head.front(0.0).share(y=(0.36, 0.64), z=(0.4, 0.7)), "screen")


def espresso_machine(d: Drawing, look: Look, dark: Look) -> None:
    """A tray for drops with a cup on it, a group with a portafilter, a gauge between two dials."""
    box = d.bounds
    base, body = box.bottom(0.06), box.inset(top=0.03)
    d.slab(base, look, 0.012, 0.004)
    d.print(base.top(0.0).inset(y=0.015, front=0.012).share(x=(0.48, 1.0)), "black steel")
    d.slab(body.inset(bottom=0.055).back(0.45 * box.depth), look, 0.012, 0.004)
    head = d.slab(body.inset(front=0.06 * box.depth).top(0.31 * box.height), look, 0.012, 0.005)
    for cup in body.top(-0.03).share(x=(0.0, 0.5)).columns(2):
        open_vessel(d, cup.place(0.07, 0.07), [(0.7, 0.0), (0.9, 0.5), (1.0, 1.0)], "white ceramic")
    x, h = box.x[1] - 0.3 * box.depth, box.height
    group = Box.sized(0.072, 0.072, head.z[0] - 0.5 * h, (x, 0.0, 0.5 * h))
    d.turned(group, [(0.76, 0.0), (0.9, 0.15), (1.0, 0.4), (1.0, 0.55), (0.88, 0.6), (0.88, 1.0)], "chrome", 20)
    d.bar((x + 0.03, 0, 0.53 * h), (box.x[1] - 0.012, 0, 0.51 * h), 0.011, dark)
    cup = Box.sized(0.064, 0.064, 0.06, (x, 0.0, 0.06))
    open_vessel(d, cup, [(0.7, 0.0), (0.9, 0.5), (1.0, 1.0)], "white ceramic", drink="coffee", level=0.8)
    left, middle, right = head.share(z=(0.3, 0.6)).columns(3)
    for k, face in enumerate((left, right)):
        knob(d, face, "chrome", 0.016, 0.02, name=f"knob-{k}")
    knob(d, middle, "chrome", 0.02, 0.005)
    with d.no_colliders():
        d.cylinder(Box.around((head.x[1] + 0.005, 0.0, middle.center[2]), 0.0006, 0.026, 0.026), "paper", "x")


@draws("knife_block", whole=True)
def knife_block(d: Drawing) -> None:
    """A leaning block with the handles of seven knives."""
    wood = d.material("body", "beech, oak, walnut, black paint, bamboo")
    grip = d.material("grips", "black plastic, steel, walnut")
    depth, width, h = d.bounds.size
    # It leans back; its face with the slots looks to the front and up.
    low, high = np.array([0.32 * depth, 0.34 * h]), np.array([-0.12 * depth, 0.8 * h])
    side = [(-0.5 * depth, 0.0), (0.28 * depth, 0.0), low, high, (-0.5 * depth, 0.62 * h)]
    d.hull([(x, s * width / 2, z) for x, z in side for s in (-1, 1)], wood)
    tilt = math.atan2(high[1] - low[1], low[0] - high[0])
    for share, count, long, thick in ((0.2, 2, 0.5, 0.018), (0.52, 2, 0.43, 0.018), (0.84, 3, 0.34, 0.013)):
        x, z = high + share * (low - high)
        with d.at(x, 0.0, z, pitch=tilt):
            for own in Box.sized(thick, 0.9 * width, long * h, (0, 0, -0.005)).columns(count, gap=0.012):
                d.box(own.bottom(0.018).place(width=0.02), "steel", bevel=0.001)
                d.slab(own.inset(bottom=0.016).place(width=0.022), grip, 0.005, 0.002)


@draws("utensil_holder", whole=True, even="round")
def utensil_holder(d: Drawing) -> None:
    """A crock with wooden spoons, a ladle, a spatula and a whisk."""
    box = d.even("round")
    look = d.material("body", CERAMICS, "steel, copper")
    wood = d.material("spoons", "beech, walnut, bamboo")
    crock = box.share((0.1, 0.9), (0.1, 0.9), (0.0, 0.48))
    open_vessel(d, crock, [(0.88, 0.0), (0.95, 0.04), (0.95, 0.9), (1.0, 0.93), (1.0, 1.0)], look, 0.004, 0.05)
    r, h, turn = crock.width / 2, box.height, d.uniform("turn", 0, 1.2)
    for k, kind in enumerate(("spoon", "spatula", "whisk", "ladle", "spoon")):
        a = 2 * math.pi * k / 5 + turn
        long, head = h * (1.0 - 0.05 * (k % 3)) - 0.016, 0.2 * h
        look = "steel" if kind in ("whisk", "ladle") else wood
        x, y = -0.5 * r * math.cos(a), -0.5 * r * math.sin(a)
        with d.at(x, y, 0.014, yaw=a, pitch=0.8 * math.atan2(0.56 * box.width, long)):
            d.bar((0, 0, 0.1 * h), (0, 0, long - 0.9 * head), 0.0045, look, 8)
            if kind == "spatula":
                blade = Box.sized(0.006, 0.056, head, (0, 0, long - head))
                d.sections(blade, [(1, 0.4, 0.0), (1, 0.9, 0.2), (1, 1, 1)], look, radius=0.3, convex=True)
            elif kind == "whisk":
                for yaw in (0.0, math.pi / 3, 2 * math.pi / 3):
                    with d.at(z=long - head, yaw=yaw):
                        t = np.linspace(0, math.pi, 9)
                        loop = np.c_[0 * t, 0.028 * np.cos(t) * np.sin(t) ** 0.5, (head - 0.004) * np.sin(t)]
                        d.sweep(loop, 0.0014, look, 5)
            else:
                deep = 0.036 if kind == "ladle" else 0.014
                d.ball(Box.sized(deep, 0.046, 0.86 * head, (0, 0, long - 0.88 * head)), look, 12)


@draws("colander", whole=True)
def colander(d: Drawing) -> None:
    """A bowl with holes, two ears, and a foot ring."""
    look = d.material("body", "steel, white steel, red paint, mint plastic, brushed steel, cream paint")
    box = d.bounds.place(width=d.bounds.depth)
    shape = [(0.5, 0.0), (0.5, 0.1), (0.72, 0.26), (0.9, 0.55), (0.96, 0.9), (1.0, 0.97), (1.0, 1.0)]
    open_vessel(d, box, shape, look, 0.004, 0.14)
    r, h = box.width / 2, box.height
    for row in range(4):
        z = 0.3 + 0.14 * row
        lean = math.atan2(0.18 * r, 0.29 * h) if z < 0.55 else math.atan2(0.06 * r, 0.35 * h)
        radius = float(np.interp(z, [0.26, 0.55, 0.9], [0.72, 0.9, 0.96])) * r
        with d.no_colliders(), d.ring(20, radius, 0.157 * (row % 2)), d.at(z=z * h, pitch=lean):
            d.cylinder(Box.around((-0.002, 0, 0), 0.0036, 0.0072, 0.0072), "black steel", "x", segments=6)
    reach = d.bounds.width / 2 - 0.86 * r
    with d.mirror("y"):
        d.arch((-0.05, 0.86 * r, 0.95 * h), (0.05, 0.86 * r, 0.95 * h), (0, reach, 0), 0.005, look)


@draws("baking_tray", whole=True)
def baking_tray(d: Drawing) -> None:
    """A flat tray with a rim, with biscuits or buns."""
    look = d.material("body", "black steel, brushed steel, iron, aluminium")
    box = d.bounds
    rim = min(box.height, 0.025)
    levels = ((0.014, 0.0), (0.003, rim - 0.002), (0.0, rim), (0.004, rim), (0.016, 0.002))
    d.loft([shapes.rectangle(box.inset(x=e).x, box.inset(y=e).y, z, 0.02, 3) for e, z in levels], look, hollow=2)
    bun = d.chance("buns", 0.5)
    cells = [cell for row in box.inset(x=0.06 * box.depth, y=0.06 * box.width).split("x", 3) for cell in row.columns(4)]
    for k, cell in enumerate(cells):
        own = cell.place(0.07, 0.07).inset(bottom=0.002)
        if bun:
            d.turned(own, [(0.85, 0.0), (1.0, 0.3), (0.9, 0.7), (0.6, 0.93), (0.3, 1.0)], "bread crust", 14)
        else:
            biscuit = "cake sponge" if k % 3 else "chocolate"
            d.cylinder(own.inset(x=0.005, y=0.005), biscuit, ends=(1.0, 0.87), bevel=0.003, segments=14)


@draws("oven_mitt", whole=True)
def oven_mitt(d: Drawing) -> None:
    """A quilted glove with a thumb and a cuff, lying flat."""
    cloth = d.material("cloth", "red fabric, navy fabric, mustard fabric, grey fabric, green fabric")
    hem = d.material("hem", "white fabric, charcoal fabric")
    box = d.bounds
    h = box.height
    d.cushion(box.inset(back=0.05).share(y=(0.14, 0.86)), cloth, radius=0.03, puff=0.25)
    with d.at(-0.08 * box.depth, 0.25 * box.width, 0.0, yaw=0.75):
        d.cushion(Box((-0.06, 0.1), (-0.035, 0.035), (0.002, 0.85 * h)), cloth, radius=0.02, puff=0.3)
    d.cushion(box.back(0.07).share(y=(0.12, 0.88), z=(0.0, 0.92)), hem, radius=0.012)
    with d.no_colliders(), d.grid(box.inset(back=0.09, front=0.06, y=0.18 * box.width).top(0.0), x=4, y=3):
        d.ball(Box.around((0, 0, -0.004), 0.006, 0.006, 0.006), hem, 8)
