"""Counters, and benches to work at."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, draws
from ...drawing.components import legs, tap, unit
from .bottles import bottle
from .tables import KNEES
from .tables_parts import drawer_case, pedestal_of_drawers, planks


@draws("reception_desk")
def reception_desk(d: Drawing) -> None:
    """A high counter toward the visitors (+x) and a lower desk behind it, with a panelled or slatted front."""
    kind = d.pick("front", ["slats", "panels", "stone", "glow"])
    body = d.material("body", "white paint", "oak", "walnut", "light grey paint", "navy paint", "sage paint")
    counter = d.material("counter", "walnut", "oak", "marble", "white paint", "dark marble", "granite")
    pull = d.material("pulls", "black steel", "brushed steel")
    bounds, height = d.bounds, 0.74
    plate = bounds.top(0.035)
    wall = bounds.inset(front=0.07, top=0.035).front(0.1)
    with d.part("front"):
        d.box(wall.inset(bottom=0.08), body)
        d.box(wall.inset(x=0.025, y=0.03).bottom(0.08), "black steel")
        face = wall.inset(bottom=0.09, top=0.005).front(-0.022)
        if kind == "slats":
            slat = d.material("slats", "oak", "walnut", "light oak", "black paint")
            for cell in face.columns(round(bounds.width / 0.07)):
                d.box(cell.place(width=0.04), slat)
        elif kind == "panels":
            for cell in face.inset(top=0.02, front=0.004).columns(round(bounds.width / 0.6), gap=0.012):
                d.box(cell, body, bevel=0.004)
        else:
            stone = d.material("face", "marble", "dark marble", "concrete", "walnut")
            d.box(face.inset(y=0.02, z=0.035), stone)
            for strip in (face.top(0.03), face.bottom(0.03)) if kind == "glow" else ():
                d.box(strip.inset(y=0.02, z=0.002).back(0.008), "lamp glow", bevel=0.0)
    with d.part("counter"):
        d.box(plate.front(0.32), counter, bevel=0.004)
    d.surface("counter", plate.front(0.32), inset=0.01)
    desk = bounds.inset(y=0.03).to(x=(bounds.x[0], wall.x[0]), z=(0.0, height))
    with d.part("top"):
        d.box(desk.top(0.028), body if kind == "stone" else counter)
    d.surface("top", desk.inset(x=0.01, y=0.03), round(plate.z[0] - height - 0.005, 4))
    x0, x1 = bounds.x[0] + 0.02, wall.x[0]
    profile = [(x0, 0), (x0, height + 0.03), (x1, 0), (x1, plate.z[0]), (x1 - 0.1, plate.z[0])]
    with d.mirror("y"), d.part("side"):
        d.hull([(x, y, z) for y in bounds.left(0.03).y for x, z in profile], body)
    stack = desk.inset(right=0.05).right(0.4)
    with d.at(*stack.center[:2], 0.0, yaw=math.pi):
        own = Box.sized(stack.depth - 0.06, stack.width, height - 0.03, (-0.01, 0.0, 0.0))
        pedestal_of_drawers(d, own, body, body, pull, "cup")
    d.clear(desk.inset(front=0.02, right=0.47, left=0.02).to(z=(0.0, KNEES)))


@draws("workbench")
def workbench(d: Drawing) -> None:
    """A thick top on heavy legs with a shelf and a front vice and dog holes, or steel legs with drawers."""
    top = d.material("top", "beech", "pine", "plywood", "oak")
    joiner = d.pick("kind", ["joiner", "garage", "joiner"]) == "joiner"
    metal = d.material("vice", "iron", "black steel", "steel")
    look = top if joiner else d.material("legs", "grey paint", "blue paint", "red paint", "black steel")
    bench = d.bounds.inset(front=0.07)
    plate = bench.top(0.055)
    under = bench.inset(back=0.03, front=0.045, y=0.12).to(z=(0.0, plate.z[0]))
    x, low, width = bench.x[1], plate.z[0], 0.09 if joiner else 0.05
    with d.part("top"):
        planks(d, plate, top, wide=0.11)
        if joiner:
            d.box(plate.bottom(-0.05).inset(front=0.001, y=0.01).front(0.044), top)
            front_board = plate.split("x", max(3, round(plate.depth / 0.11)))[-1]
            holes = front_board.inset(right=0.1, left=0.65)
            for cell in holes.columns(6):
                d.print(cell.top(0.0).place(0.02, 0.02), "black plastic")
    if joiner:
        at, z = bench.y[1] - 0.32, low - 0.06
        with d.part("vice"):
            jaw = Box((x + 0.012, x + 0.062), (at - 0.22, at + 0.22), (low - 0.11, bench.z[1] - 0.001))
            d.box(jaw, top, bevel=0.006)
            for y, radius, end in ((at, 0.014, 0.066), (at - 0.14, 0.009, 0.05), (at + 0.14, 0.009, 0.05)):
                d.bar((x - 0.1, y, z), (x + end, y, z), radius, metal, 12)
            d.bar((x + 0.066, at - 0.11, z - 0.03), (x + 0.066, at + 0.08, z + 0.03), 0.004, "steel", 8)
            d.bar((x + 0.058, at, z), (x + 0.07, at, z), 0.017, metal, 12)
    legs(d, under, look, "square", width)
    shelf, between = 0.2, under.inset(y=width)
    with d.part("shelf"):
        for rail in (between.back(width), between.front(width)):
            d.box(rail.place(depth=0.04).to(z=(shelf - 0.09, shelf - 0.02)), look)
        board = d.box(between.inset(x=0.03).to(z=(shelf - 0.02, shelf)), top)
    free, headroom = board.inset(x=0.025, y=0.03), low - shelf - 0.115
    if not joiner:
        pull, stack = d.material("pulls", "black plastic", "steel"), between.inset(front=-0.02).top(0.36).right(0.42)
        with d.part("drawer stack"):
            drawer_case(d, stack, look, look, pull, "cup", 3)
            d.box(stack.inset(front=0.025).left(-0.018).to(z=(shelf, low)), look, bevel=0.0)
        free, headroom = free.to(y=(stack.y[1] + 0.03, free.y[1])), low - shelf - 0.005
    d.surface("shelf", free, round(headroom, 4))
    d.fit()


@draws("drafting_table")
def drafting_table(d: Drawing) -> None:
    """A tilted drawing board with a ledge, a parallel rule and a plan on it, on a steel or wooden trestle."""
    look = d.material("board", "birch", "beech", "white paint", "light oak", "plywood")
    steel = d.material("legs", "black steel", "oak", "white steel", "walnut", "grey paint")
    (depth, width, height), tilt = d.size, d.uniform("tilt", 0.26, 0.42)
    long = (depth - 0.06) / math.cos(tilt)
    middle = height - long * math.sin(tilt) / 2 - 0.03
    board = Box.sized(long, width, 0.02, (0.0, 0.0, -0.02))
    with d.part("board"), d.at(0.0, 0.0, middle, pitch=tilt):
        d.box(board, look)
        d.box(board.top(-0.014).inset(y=0.05, front=-0.012).front(0.042), steel)
        sheet = d.print(board.top(0.0).share(x=(0.2, 0.86), y=(0.2, 0.8)), "paper")
        plan = sheet.share(x=(0.15, 0.6), y=(0.12, 0.7))
        walls = [plan.front(0.003), plan.back(0.003), plan.left(0.003), plan.right(0.003)]
        walls += [plan.share(y=(0.4, 0.4)).left(-0.003), plan.share(x=(0.55, 0.55), y=(0.4, 1.0)).front(0.003)]
        for wall in walls:
            d.print(wall, "navy paint", 0.0004)
        rule = board.top(-0.008).inset(bottom=0.002, y=0.02).share(x=(0.64, 0.69))
        d.box(rule, "clear plastic", bevel=0.0)
        for end in (rule.left(0.032), rule.right(0.032)):
            d.box(end.inset(x=-0.01, bottom=-0.002, top=-0.005), "black plastic")
        square = [(0.05, 0.33 * width), (0.05, 0.45 * width), (-0.12, 0.45 * width)]
        d.hull([(x, y, z) for x, y in square for z in (0.0, 0.003)], "clear plastic")
    bar = 0.05 if steel.called("oak", "walnut") else 0.035
    at, hold = min(0.36 * width, width / 2 - 0.1), middle - 0.05
    foot = d.bounds.inset(x=0.04).to(y=(at - bar / 2, at + bar / 2))
    with d.mirror("y"), d.part("end"):
        d.box(foot.bottom(bar), steel)
        d.box(foot.place(depth=0.08).to(z=(bar, hold)), steel)
        ends = ((foot.x[0] + 0.1, 0.5 * bar), (-0.02, 0.45))
        d.hull([(x + dx, y, z) for x, z in ends for dx in (-0.015, 0.015) for y in foot.inset(y=0.15 * bar).y], steel)
        with d.at(0.0, 0.0, middle, pitch=tilt):
            d.box(foot.to(x=(-0.3 * long, 0.3 * long), z=(-0.06, -0.02)), steel)
        d.bar((0.0, foot.y[1], hold - 0.02), (0.0, foot.y[1] + 0.03, hold - 0.02), 0.025, "black plastic", 12)
    for name, z in (("low rail", 0.3), ("rail", hold - 0.14)):
        with d.part(name):
            d.box(Box.around((0.0, 0.0, z), 0.04, 2 * at - bar, 0.05), steel)
    d.fit()


@draws("lab_bench")
def lab_bench(d: Drawing) -> None:
    """A dark resistant top over cupboards and drawers with a gap for knees, a basin with a tap, a shelf above."""
    body = d.material("body", "white paint", "light grey paint", "blue paint", "sage paint")
    top = d.material("top", "black paint", "granite", "grey ceramic", "white ceramic")
    pull, s = d.material("pulls", "brushed steel", "black steel"), d.pick("sink side", [-1, 1])
    bounds, height = d.bounds, 0.9
    plate = bounds.to(z=(height - 0.03, height))
    y = s * (bounds.y[1] - 0.28)
    sink = Box((0.0, 0.3), (y - 0.2, y + 0.2), (height, height))
    with d.part("top"):
        d.box(plate, top, bevel=0.004)
    with d.part("sink"):
        rim = d.box(sink.top(-0.008), "brushed steel")
        d.print(rim.top(0.0).inset(x=0.02, y=0.02), "black steel")
        with d.at(-0.05, y, height):
            tap(d, "chrome", 0.18, 0.34)
            for k, look in ((-1, "blue plastic"), (1, "red plastic")):
                d.bar((0.0, 0.03 * k, 0.06), (0.0, 0.06 * k, 0.06), 0.012, look, 10)
    rack = bounds.back(0.24)
    clear = (bounds.y[0] + 0.01, y - 0.22) if s > 0 else (y + 0.22, bounds.y[1] - 0.01)
    d.surface("top", plate.to(x=(rack.x[1] + 0.02, plate.x[1] - 0.01), y=clear))
    under = bounds.inset(back=0.02, front=0.045, y=0.01).to(z=(0.0, plate.z[0]))
    wide = min(0.5, 0.3 * bounds.width)
    for k, cell in ((-1, under.right(wide)), (1, under.left(wide))):
        if k == s:
            with d.part("cupboard"):
                unit(d, "sink", cell.inset(bottom=0.09), "door", body, body, pull)
                d.box(cell.bottom(0.09).inset(back=0.02, front=0.06), "black plastic", bevel=0.0)
        else:
            pedestal_of_drawers(d, cell, body, body, pull, "bar", 4, foot=0.09)
    knees = under.inset(y=wide)
    with d.part("back"):
        d.box(knees.back(0.02), body, bevel=0.0)
    shelf = rack.to(z=(bounds.z[1] - 0.22, bounds.z[1] - 0.2))
    with d.mirror("y"), d.part("posts"):
        d.box(rack.inset(back=0.08, left=0.01).left(0.04).back(0.04).to(z=(height, shelf.z[0])), "brushed steel")
    with d.part("shelf"):
        d.box(shelf, body)
        d.box(shelf.bottom(-0.025).inset(back=0.04, y=0.1).back(0.12), "lamp glow")
    with d.part("bottles"):
        for k, look in enumerate(("amber glass", "green glass", "glass", "amber glass", "white plastic")):
            with d.at(rack.x[0] + 0.09, s * (bounds.y[1] - 0.1 - 0.11 * k), shelf.z[1]):
                tall = d.uniform(f"bottle {k}", 0.12, 0.17) if k else 0.2
                bottle(d, 0.038, tall, look, "blue plastic" if k % 2 else "black plastic", label=True)
    free = (bounds.y[0] + 0.02, bounds.y[1] - 0.68)
    d.surface("shelf", shelf.inset(x=0.02).to(y=free if s > 0 else (-free[1], -free[0])))
    d.clear(knees.inset(back=0.1, y=0.01, front=-0.045).to(z=(0.0, 0.8)))
    d.fit()
