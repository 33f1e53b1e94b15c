"""Round and nesting tables, and those for children, plants and babies."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import REACH, carcass, doors, drawer, feet, leg, legs, oval, walls
from .tables_parts import drawer_case, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "cherry", "ash grey wood", "pine")


@draws("nesting_tables")
def nesting_tables(d: Drawing) -> None:
    """Two tables of one form, the smaller one drawn out from under the larger."""
    round_tops = d.chance("round", 0.5)
    top = d.material("top", "oak", "walnut", "marble", "white paint", "light oak", "glass")
    metal = d.material("legs", "brass", "black steel", "oak", "white steel")
    bar, bounds = 0.03 if metal.called("oak") else 0.018, d.bounds
    depth, width, _ = bounds.size
    big = depth if round_tops else min(depth, 0.74 * width)
    small = max(0.62 * big, min(0.78 * big, width - 0.5 * big)) if round_tops else 0.78 * big
    larger, smaller = bounds.right(big), bounds.left(small).inset(top=0.09)
    smaller = smaller.place(depth=small if round_tops else 0.8 * depth)
    for name, own in (("large", larger), ("small", smaller)):
        plate = own.top(0.012 if top.called("glass") else 0.02)
        under = own.to(z=(0.0, plate.z[0]))
        with d.part(name):
            tabletop(d, plate, top, 0.015, 2.0 if round_tops else None, name="top" if name == "large" else None)
        if round_tops:
            with d.at(*plate.center[:2], 0.0), d.ring(3, 0.0, math.pi), d.part(f"{name} leg"):
                foot = 0.41 * own.width
                leg(d, (foot, 0, 0), (0.9 * foot, 0, under.height), 0.8 * bar, bar, metal)
            continue
        inner = under.inset(x=bar / 2, y=0.01)
        for k, side in enumerate((inner.back(bar), inner.front(bar))):
            with d.part(f"{name} side {k}"):
                for post in (side.left(bar), side.right(bar)):
                    d.box(post, metal)
                for rail in (side.top(bar), side.bottom(bar))[: 1 if name == "large" else 2]:
                    d.box(rail.inset(y=bar), metal)


@draws("kids_table")
def kids_table(d: Drawing) -> None:
    """A low table for small children with round corners and thick legs in bright colours."""
    top = d.material("top", "white paint", "birch", "beech", "light oak", "yellow paint", "blue paint")
    bright = ("red paint", "blue paint", "yellow paint", "green paint", "teal paint")
    kind, several, look = d.pick("kind", ["pegs", "square", "splayed"]), d.chance("several colours", 0.5), None
    look = d.material("legs", *bright, "birch")
    plate, under = d.bounds.top(0.022), d.bounds.inset(top=0.022)
    with d.part("top"):
        tabletop(d, plate, top, d.pick("corner", [0.06, 0.12]))
        walls(d, under.inset(x=0.06, y=0.06).top(0.05), top)
    out = 0.035 if kind == "splayed" else 0.0
    for k, (sx, sy) in enumerate(((-1, -1), (-1, 1), (1, -1), (1, 1))):
        own = d.material(f"leg {k}", bright[k]) if several else look
        x, y = sx * (under.x[1] - 0.07), sy * (under.y[1] - 0.07)
        with d.part(f"leg {k}"):
            if kind == "square":
                d.box(Box.sized(0.052, 0.052, under.height, (x, y, 0.0)), own, bevel=0.008)
            else:
                leg(d, (x + sx * out, y + sy * out, 0), (x, y, under.height), 0.044, 0.06, own, 16)
    d.clear(d.bounds.inset(y=0.13).to(z=(0.0, 0.36)))


@draws("train_table")
def train_table(d: Drawing) -> None:
    """A low table with a rim, a painted landscape, an oval of wooden track, trees, houses and a train."""
    wood = d.material("frame", "pine", "beech", "birch", "white paint", "light oak")
    bounds = d.bounds
    depth, width, _ = bounds.size
    floor = bounds.z[1] - 0.11
    land = bounds.inset(x=0.02, y=0.02).to(z=(floor - 0.02, floor))
    with d.part("top"):
        d.box(land, "green paint", bevel=0.0)
        walls(d, bounds.to(z=(floor - 0.08, floor + 0.035)), wood)
        lake = land.place(0.32 * depth, 0.26 * width).move(0.06 * depth, 0.12 * width)
        d.cylinder(lake.top(0.001).move(z=0.001), "blue paint")
        track = oval(land.place(0.72 * depth, 0.76 * width), floor + 0.006, 2.6, count=28)
        d.sweep(track, np.array([(-0.02, -0.006), (0.02, -0.006), (0.02, 0.006), (-0.02, 0.006)]), "beech", closed=True)
        with d.no_colliders():
            for x, y, z in track[::2].tolist():
                d.box(Box.around((x, y, z + 0.005), 0.012, 0.012, 0.0026), "walnut", bevel=0.0)
        for k, look in enumerate(("red paint", "yellow paint", "blue paint", "green paint")):
            x, y = -0.36 * depth, 0.068 * k - 0.12
            car = d.box(Box.sized(0.034, 0.056, 0.027, (x, y, floor + 0.018)), look, bevel=0.004)
            with d.at(x, y, floor + 0.018), d.mirror("x", "y"):
                d.cylinder(Box((0.012, 0.019), (0.01, 0.024), (-0.006, 0.008)), "black plastic", "x", segments=10)
            if k == 3:
                d.cylinder(
                    Box.sized(0.02, 0.02, 0.021, car.move(y=0.012).anchor("top")), "black plastic", ends=(0.8, 1.0)
                )
                d.box(car.inset(x=0.001, y=0.001).right(0.021).top(-0.02), "blue paint")
    with d.part("trees"):
        for k in range(8):
            x, y = d.uniform(f"tree x {k}", -0.24, 0.24) * depth, d.uniform(f"tree y {k}", -0.26, 0.0) * width
            with d.at(x, y, floor):
                d.cylinder(Box.sized(0.012, 0.012, 0.03), "bark", segments=8)
                crown = Box.sized(0.06, 0.06, d.uniform(f"tree {k}", 0.05, 0.08), (0, 0, 0.025))
                d.cylinder(crown, "leaf" if k % 3 == 2 else "dark leaf", ends=(1.0, 0.13), segments=12)
    with d.part("houses"):
        for k, (x, y, roof) in enumerate(((-0.16, 0.17, "red paint"), (-0.02, 0.27, "blue paint"))):
            with d.at(x * depth, y * width, floor, yaw=0.3 * k):
                house = d.box(Box.sized(0.06, 0.07, 0.05), "cream paint", bevel=0.0)
                eaves = house.inset(x=-0.006, y=-0.006).top(0.0)
                ridge = [(0.0, y, 0.09) for y in eaves.y]
                d.hull([(x, y, 0.05) for x in eaves.x for y in eaves.y] + ridge, roof)
    legs(d, bounds.inset(x=0.02, y=0.02).to(z=(0.0, floor - 0.02)), wood, "square", 0.06)


@draws("plant_stand")
def plant_stand(d: Drawing) -> None:
    """A small round top on three slim legs with a ring or a shelf, or on a turned column."""
    kind = d.pick("kind", ["legs", "column", "wire", "two tiers"])
    top = d.material("top", *WOODS, "white paint", "black steel", "brass", "rattan")
    wide, height = min(d.size[:2]), d.size.height
    plate, radius = Box.sized(wide, wide, height).top(0.02), wide / 2
    low = plate.z[0]
    with d.part("top"):
        tabletop(d, plate, top, power=2.0)
    if kind == "column":
        foot = [(0.9 * radius, 0.0), (0.9 * radius, 0.015), (0.84 * radius, 0.025), (0.5 * radius, 0.035)]
        foot += [(0.032, 0.06), (0.02, 0.1), (0.03, 0.108), (0.03, 0.118), (0.018, 0.13)]
        shaft = ((0.016, 0.36), (0.024, 0.44), (0.033, 0.52), (0.035, 0.57), (0.03, 0.62), (0.017, 0.68))
        rings = ((0.028, 0.69), (0.028, 0.705), (0.017, 0.72), (0.019, 0.86))
        head = [(0.04, low - 0.015), (0.55 * radius, low - 0.006), (0.55 * radius, low)]
        with d.part("foot"):
            d.revolve([*foot, *((r, z * height) for r, z in (*shaft, *rings)), *head], top)
        return
    plain = top.called("black steel", "brass", "white paint") or d.chance("plain", 0.33)
    metal = top if plain else d.material("legs", "black steel", "brass")
    tiers = kind == "two tiers"
    count, foot, head = (4, 0.82, 0.82) if tiers else (3, 0.93, 0.62)
    with d.ring(count, 0.0, math.pi / count), d.part("leg"):
        leg(d, (foot * radius, 0, 0), (head * radius, 0, low), 0.016, 0.022, metal)
    z = 0.3 * height if tiers else 0.45 * height
    at = (foot + (head - foot) * z / low) * wide
    with d.part("middle"):
        if kind == "wire":
            d.hoop(Box.around((0.0, 0.0, z), at, at, 0.0), 0.006, metal, steps=24)
        else:
            board = d.cylinder(Box.sized(at, at, 0.015, (0, 0, z - 0.015)), top, bevel=0.003, segments=32)
    if tiers:
        d.surface("shelf", board.place(radius, radius), round(low - z - 0.005, 4))


@draws("changing_table")
def changing_table(d: Drawing) -> None:
    """A chest of drawers, doors under a drawer, or open shelves with baskets, under a padded mat with raised sides."""
    kind, style = d.pick("kind", ["drawers", "shelves", "doors"]), d.pick("pull style", ["knob", "cup", "bar"])
    wood = d.material("body", "white paint", "light oak", "beech", "birch", "sage paint", "light grey paint")
    fronts = d.material("fronts", "white paint", "birch", "light oak") if d.chance("two tone", 0.4) else wood
    soft = d.material("mat", "white fabric", "beige fabric", "grey fabric", "rose fabric", "green fabric")
    case = d.bounds.inset(front=0.0 if kind == "shelves" else REACH[style], top=0.1)
    plate, rim, board = case.top(0.02), case.top(-0.1), 0.018
    with d.part("rim"):
        d.box(plate, wood)
        for side in (rim.inset(front=0.01).left(board), rim.inset(front=0.01).right(board)):
            d.box(side, wood, bevel=0.005)
        d.box(rim.inset(y=board).back(board), wood, bevel=0.005)
        mat = rim.inset(back=0.025, front=0.01, y=0.025)
        d.cushion(mat.bottom(0.045), soft, 0.02)
        for side in (mat.left(0.1), mat.right(0.1)):
            d.cushion(side.inset(bottom=0.02, top=0.015), soft, 0.03)
        d.pillow(mat.inset(back=0.02).back(0.16).place(width=0.26).bottom(0.05).move(z=0.035), "white fabric")
    under = case.inset(top=0.02)
    if kind == "shelves":
        legs(d, under.inset(front=0.01), wood, "square", 0.045)
        basket = d.material("basket", "rattan", "wicker", "grey fabric")
        for k, z in enumerate((0.14, 0.48)):
            shelf = under.inset(back=0.01, front=0.02, y=0.01).to(z=(z - 0.02, z))
            with d.part(f"shelf {k}"):
                d.box(shelf, wood)
            if k:
                d.surface("shelf", shelf, round(under.z[1] - z - 0.005, 4), inset=0.04)
                continue
            with d.part("baskets"):
                for cell in shelf.top(-0.19).inset(x=0.05, y=0.06).columns(2, gap=0.04):
                    walls(d, cell, basket, 0.02, 0.008)
                    d.box(cell.inset(x=0.02, y=0.02).bottom(0.14), "white fabric", bevel=0.03)
        return
    pull = d.material("pulls", "brass", "beech", "brushed steel", "black steel")
    body = under.inset(bottom=0.08, back=0.005, front=0.004, y=0.005)
    with d.part("body"):
        feet(d, under.bottom(0.08), wood, "tapered")
        if kind == "drawers":
            drawer_case(d, body, wood, fronts, pull, style, 3)
        else:
            room = carcass(d, body.inset(front=0.019), wood, 0.012)
            d.box(room.inset(front=0.03).place(height=0.012).move(z=-0.08), wood, bevel=0.0)
            drawer(d, "drawer", body.top(0.2).inset(back=0.006), fronts, pull, style, overlay=0.012)
            doors(d, body.inset(top=0.2).front(0.018), 2, fronts, pull, "knob" if style == "cup" else style)
