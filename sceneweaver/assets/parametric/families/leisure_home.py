"""Warmth, air, hobbies and pets."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import handle, knob
from .small_toys import ball


@draws("aquarium", whole=True)
def aquarium(d: Drawing) -> None:
    """A tank of water with plants, stones and fish on a cabinet."""
    wood = d.material("cabinet", "black paint, walnut, white paint, light oak")
    box = d.bounds
    cabinet, tank = box.share(z=(0.0, 0.55)), box.share(z=(0.55, 1.0))
    d.box(cabinet.inset(front=0.016), wood, 0.004)
    leaves = cabinet.inset(y=0.003, bottom=0.05, top=0.03).front(0.018).columns(2, gap=0.004)
    for leaf, hung in zip(leaves, (0.9, 0.1), strict=True):
        d.box(leaf, wood)
        handle(d, leaf.share(y=(hung, hung)), "steel", "bar", 0.12, upright=True)
    d.box(tank.bottom(0.02).inset(bottom=-0.005), "black plastic")
    d.box(tank.top(0.055), "black plastic", 0.006)
    d.box(tank.inset(x=0.004, y=0.004, bottom=0.02, top=0.05), "glass", 0.0)
    water = tank.inset(x=0.015, y=0.015, bottom=0.06, top=0.07)
    with d.no_colliders():
        d.box(water.bottom(-0.039), "sand pigment", 0.0)
        d.box(water.back(0.004), "sea pigment", 0.0)
        for k, cell in enumerate(water.share(y=(0.05, 0.95)).columns(10)):
            x, tall = d.uniform(f"x {k}", 0.15, 0.65), d.uniform(f"tall {k}", 0.3, 0.9)
            foot, look = cell.point(x, 0.5, 0.0), ("leaf", "pale leaf", "dark leaf")[k % 3]
            with d.at(*foot), d.ring(4, 0.0, k):
                t = np.array([0.0, 0.4, 0.75, 0.98])
                side = 0.02 * (1 - t)
                rows = [np.c_[0.06 * t**2, sign * side, t * tall * water.height] for sign in (-1, 1)]
                d.sheet(np.stack(rows, axis=1), 0.0015, look)
        for k in range(4):
            r = 0.03 + 0.012 * k
            ball(d, water.point(0.65, 0.2 + 0.2 * k, 0.0), (r, 1.3 * r, 0.8 * r), "granite", 8)
        for k in range(7):
            at = water.point(0.55 + 0.03 * k, d.uniform(f"fy {k}", 0.1, 0.9), d.uniform(f"fz {k}", 0.3, 0.8))
            look = ("orange plastic", "yellow plastic", "blue plastic", "red plastic")[k % 4]
            ball(d, at, (0.012, 0.035, 0.02), look, 10)
            tail = Box.around(at, 0.006, 0.036, 0.044).move(y=0.044 * (-1) ** k)
            d.silhouette(tail, [(k % 2, 0.5), (1 - k % 2, 0), (1 - k % 2, 1)], look, "x")


@draws("fireplace", whole=True)
def fireplace(d: Drawing) -> None:
    """A mantelpiece on pilasters around an opening with logs and flames."""
    stone = d.material("stone", "marble, dark marble, white paint, granite, concrete, oak")
    inner = d.material("lining", "terracotta, iron, granite")
    box = d.bounds
    wide, high = box.width, box.height
    with d.part("hearth"):
        d.box(box.bottom(0.05), stone, 0.006)
    case = box.inset(bottom=0.05, front=0.12)
    opening = case.place(width=0.6 * wide).to(z=(0.05, 0.66 * high))
    with d.part("body"):
        d.box(opening.back(0.05), inner, 0.0)
        d.box(case.inset(front=0.03, top=0.1).to(y=opening.y, z=(opening.z[1], high - 0.1)), stone, 0.004)
        with d.mirror("y"):
            jamb = case.to(y=(opening.y[1], box.y[1] - 0.05))
            d.box(jamb.inset(front=0.03, top=0.1), stone, 0.004)
            d.box(jamb.right(0.0).inset(right=-0.012, back=0.05, front=0.04).to(z=opening.z), inner, 0.0)
            pilaster = case.inset(top=0.12).left(0.22).inset(left=0.06)
            d.box(pilaster, stone, 0.008)
            ends = pilaster.inset(y=-0.015, front=-0.02)
            for end in (ends.bottom(0.12), ends.top(0.08)):
                d.box(end, stone, 0.01)
            for flute in pilaster.inset(y=0.02, bottom=0.17, top=0.13).front(0.01).columns(3, gap=0.02):
                d.box(flute.inset(front=-0.008), stone, 0.004)
        frieze = case.inset(front=0.015).front(0.025).to(z=(opening.z[1] + 0.06, high - 0.14))
        d.box(frieze.place(width=0.5 * opening.width), stone, 0.008)
        d.box(case.inset(front=-0.03, y=0.03).to(z=(high - 0.12, high - 0.06)), stone, 0.012)
        mantel = d.box(case.inset(front=-0.07).top(0.06), stone, 0.008)
        x, reach = case.center[0] + 0.03, 0.31 * opening.width
        for y in (-0.25 * opening.width, 0.25 * opening.width):  # the dogs that carry the logs
            d.bar((x - 0.1, y, 0.09), (x + 0.12, y, 0.09), 0.012, "iron", 8)
            d.box(Box.sized(0.03, 0.024, 0.17, (x + 0.115, y, 0.05)), "iron", 0.004)
        for px, z, r in ((-0.05, 0.15, 0.05), (0.06, 0.15, 0.045), (0.0, 0.23, 0.045)):
            log = Box.around((x + px, 0, z), 2 * r, 2 * reach, 2 * r)
            d.cylinder(log, "bark", "y", segments=10)
            for end in (log.left(0.0), log.right(0.0)):
                d.print(end.inset(x=0.15 * r, z=0.15 * r), "pine", oval=True)
        for k in range(5):
            tall = d.uniform(f"flame {k}", 0.12, 0.28)
            y = (0.2 * k - 0.4) * opening.width / 2
            for look, size in (("flame", 1.0), ("yellow petal", 0.6)):
                flame = Box.sized(0.09 * size, 0.09 * size, tall * size, (x + 0.05 * (1 - size), y, 0.2))
                d.turned(flame, [(0.2, 0), (1, 0.25), (0.5, 0.65), (0, 1)], look, 8)
    d.surface("mantel", mantel.inset(x=0.01, y=0.02))


@draws("wood_stove", whole=True)
def wood_stove(d: Drawing) -> None:
    """An iron stove with a glazed door, fire within, legs, a stack of logs below and a flue pipe."""
    iron = d.material("body", "iron, black steel, forest pigment, grey paint")
    box = d.bounds
    deep, wide, high = box.size
    top = min(0.95, 0.46 * high) if d.chance("tall", 0.6) else 0.72
    case = box.inset(front=0.03)
    front = case.x[1]
    with d.part("stove"):
        with d.corners(case, inset=0.05):
            d.cylinder(Box((0, 0.064), (0, 0.064), (0, 0.15)), iron, ends=(0.56, 1.0), segments=10)
        d.box(case.inset(back=0.01, y=0.02).to(z=(0.14, top - 0.02)), iron, 0.012)
        d.box(case.inset(front=-0.02).to(z=(top - 0.035, top)), iron, 0.01)
        d.box(case.inset(back=0.01, y=0.01, front=-0.015).to(z=(0.14, 0.17)), iron, 0.006)
        low = top - 0.5 if top > 0.8 else 0.24
        leaf = d.box(Box((front - 0.01, front + 0.016), (-0.38 * wide, 0.38 * wide), (low, top - 0.08)), iron, 0.006)
        glass = d.box(leaf.inset(front=-0.003, y=0.09 * wide, bottom=0.06, top=0.05).front(0.01), "black glass", 0.001)
        for k, cell in enumerate(glass.inset(y=0.005, bottom=0.01).columns(6)):
            tall = d.uniform(f"flame {k}", 0.3, 0.75)
            flame = cell.front(0.0).inset(front=-0.0004, back=-0.001).share(z=(0.0, tall))
            with d.no_colliders():
                d.silhouette(flame, [(0.1, 0), (0.9, 0), (1, 0.3), (0.5, 1), (0, 0.3)], "flame", "x")
        x, y, z = leaf.point(1.0, 0.05, 0.5)
        d.bar((x + 0.014, y, z - 0.06), (x + 0.014, y, z + 0.06), 0.01, "brass", 8)
        d.box(Box.around((x, y, z), 0.025, 0.016, 0.02), "brass", 0.0)
        if low > 0.35:
            store = Box((front, front), (-0.36 * wide, 0.36 * wide), (0.2, low - 0.05))
            d.print(store, "black glass")
            for row in store.inset(0.0, y=0.01, z=0.005).rows(2):
                for log in row.columns(5):
                    size = 0.92 * min(log.width, log.height)
                    d.print(log.place(None, size, size), "pine", 0.0004, oval=True)
    with d.part("flue"), d.at(-0.12 * deep):
        d.cylinder(Box.sized(0.132, 0.132, high - top, (0, 0, top)), iron, segments=20)
        d.cylinder(Box.sized(0.16, 0.16, 0.05, (0, 0, top)), iron, ends=(1.0, 0.87), segments=20)
        d.cylinder(Box.sized(0.14, 0.14, 0.04, (0, 0, 0.75 * high)), iron, segments=20)


@draws("radiator", whole=True)
def radiator(d: Drawing) -> None:
    """A ribbed panel with a grille, or a row of columns; with brackets, pipes and a valve."""
    paint = d.material("paint", "white steel, white paint, black paint, grey paint")
    box = d.bounds
    wide, high = box.width, box.height
    if d.chance("columns", 0.4):
        for column in box.inset(back=0.02).columns(max(6, round(wide / 0.055))):
            step = column.width
            for end in (column.bottom(0.05), column.top(0.05)):
                d.box(end.inset(y=0.1 * step), paint, 0.014)
            tubes = column.inset(y=0.22 * step, z=0.03)
            for tube in (tubes.back(0.028), tubes.front(0.028)):
                d.cylinder(tube, paint, segments=10)
        for z in (0.03, high - 0.03):
            d.bar((0.01, 0.01 - wide / 2, z), (0.01, wide / 2 - 0.01, z), 0.014, paint, 8)
    else:
        panel = d.box(box.inset(back=0.02, front=0.008, right=0.02), paint, 0.012)
        count = max(8, int(wide / 0.035))
        for rib in panel.inset(y=0.03, z=0.03).front(0.002).inset(front=-0.008).columns(count):
            d.box(rib.share(y=(0.2, 0.8)), paint, 0.004)
        for slot in panel.top(0.0).inset(x=0.015, y=0.03).columns(count):
            d.print(slot.share(y=(0.0, 0.5)), "grey plastic")
    for y in (0.15, 0.85):
        d.box(box.back(0.04).share(y=(y, y)).inset(y=-0.02, z=0.06), paint, 0.002)
    valve = Box.around((0.0, 0.015 - wide / 2, 0.85 * high), 0.036, 0.03, 0.036)
    d.cylinder(valve, "white plastic", "y", bevel=0.003)


@draws("air_purifier", whole=True)
def air_purifier(d: Drawing) -> None:
    """A rounded tower with slits below, an outlet grille above and a small display."""
    look = d.material("body", "white plastic, black plastic, grey plastic")
    box = d.bounds
    high = box.height
    if abs(box.depth - box.width) < 0.05:
        d.turned(box, [(0.92, 0), (1, 0.02), (1, 0.94), (0.95, 0.99), (0.9, 1)], look, 32)
        with d.no_colliders():
            for k in range(10):
                z = 0.08 + 0.05 * k
                d.cylinder(box.inset(x=-0.0003, y=-0.0003).share(z=(z, z + 0.02)), "grey plastic", segments=32)
        top = d.print(box.top(0.0).share((0.12, 0.88), (0.12, 0.88)), "black plastic", oval=True)
        for share in (0.3, 0.5, 0.7):
            d.hoop(top.share((0.5 - share / 2, 0.5 + share / 2), (0.5 - share / 2, 0.5 + share / 2)), 0.004, look)
        return
    d.cushion(box, look, 0.03)
    face = box.front(0.0).share(y=(0.14, 0.86))
    for slot in face.share(z=(0.12, 0.66)).rows(12):
        d.print(slot.share(z=(0.0, 0.5)), "grey plastic")
    for r, tone, proud in ((0.035, "screen", 0.0003), (0.012, "green plastic", 0.0004)):
        d.print(face.place(None, 0.0, 0.0).move(z=0.3 * high).inset(y=-r, z=-r), tone, proud, oval=True)
    for slot in box.top(0.0).share((0.18, 0.77), (0.14, 0.86)).split("x", 7):
        d.print(slot.share(x=(0.0, 0.5)), "black plastic")


@draws("fan", whole=True)
def fan(d: Drawing) -> None:
    """A standing fan: round foot, pole, wire cage with blades."""
    metal = d.material("stand", "white plastic, black plastic, chrome, grey plastic")
    deep, wide, high = d.size
    r = wide / 2
    z = high - r
    foot = Box.sized(0.9 * deep, 0.9 * deep, 0.07, (-0.02, 0, 0))
    d.turned(foot, [(1, 0), (1, 0.2), (0.133 / deep, 0.5), (0.056 / deep, 1)], metal, 28)
    d.cylinder(Box.sized(0.034, 0.034, z - 0.03, (-0.02, 0, 0.03)), metal, ends=(1.0, 0.82), segments=12)
    d.box(Box.sized(0.04, 0.06, 0.06, (-0.02, 0, 0.55 * z)), metal, 0.01)
    with d.at(0.0, 0.0, z, pitch=math.pi / 2):  # +z is forward
        d.cylinder(Box.sized(0.11, 0.11, 0.16, (0, 0, -0.14)), metal, bevel=0.02, segments=20)
        d.cylinder(Box.sized(0.1, 0.1, 0.014, (0, 0, 0.113)), metal, bevel=0.004, segments=20)
        cage = [(0.05, 0.02), (0.8 * (r - 0.007), 0.03), (r - 0.007, 0.07), (0.8 * (r - 0.007), 0.11), (0.05, 0.12)]
        for q, x in cage[1:4]:
            d.hoop(Box.around((0, 0, x), 2 * q, 2 * q, 0), 0.006, metal, steps=24)
        with d.ring(16):
            d.sweep([(q, 0, x) for q, x in cage], 0.0025, metal, 4)
        blade = [(0.03, -0.02, 0.06), (0.03, 0.02, 0.08), (0.6 * r, -0.07, 0.045), (0.7 * r, 0.07, 0.09)]
        with d.ring(4, 0.0, 0.3):
            thick = [(x, y, zz + e) for x, y, zz in blade for e in (-0.003, 0.003)]
            d.hull(thick, "blue plastic" if metal.called("white plastic") else "grey plastic")


@draws("sewing_machine_table", whole=True)
def sewing_machine_table(d: Drawing) -> None:
    """A table on an iron frame with a treadle, and a sewing machine on it."""
    wood = d.material("top", "oak, walnut, light oak, cherry")
    paint = d.material("machine", "black paint, white plastic, sage paint, red paint")
    box = d.bounds
    deep, wide, high = box.size
    level = high - 0.3
    with d.part("top"):
        d.box(box.to(z=(level - 0.03, level)), wood, 0.006)
        case = box.inset(back=0.03, front=0.06).left(0.25).inset(left=0.05).to(z=(level - 0.13, level - 0.03))
        d.box(case, wood, 0.004)
        knob(d, case, "brass", 0.012, 0.014)
    for s in (-1, 1):
        with d.part(f"leg {s}"), d.at(y=s * (wide / 2 - 0.12)):
            d.box(Box((0.02 - deep / 2, deep / 2 - 0.03), (-0.015, 0.015), (0, 0.035)), "iron", 0.004)
            for k in (-1, 1):
                d.bar((0.4 * k * deep, 0, 0.02), (-0.32 * k * deep, 0, level - 0.03), 0.013, "iron", 8)
            d.hoop(Box.around((0, 0, level / 2), 0.18, 0, 0.18), 0.009, "iron", "y", steps=14)
    with d.part("treadle"):
        d.bar((-0.05, 0.12 - wide / 2, 0.1), (-0.05, wide / 2 - 0.12, 0.1), 0.01, "iron", 8)
        tread = d.box(Box((-0.14, 0.1), (-0.17, 0.17), (0.09, 0.11)), "iron", 0.004).top(0.0)
        for slot in tread.inset(x=0.02, y=0.02).columns(7):
            d.print(slot.share(y=(0.3, 0.7)), "black steel")
    with d.part("machine"):
        machine = Box((-0.09, 0.09), (-0.32, 0.08), (level, high))
        d.box(machine.bottom(0.045), paint, 0.01)
        d.cushion(machine.left(0.1).inset(x=0.04).to(z=(level + 0.04, high - 0.02)), paint, 0.025)
        arm = d.cushion(machine.inset(x=0.045).to(z=(high - 0.12, high - 0.03)), paint, 0.025)
        d.cushion(machine.right(0.08).inset(x=0.05).to(z=(level + 0.13, high - 0.04)), paint, 0.015)
        d.bar((0, -0.28, level + 0.05), (0, -0.28, level + 0.14), 0.006, "steel", 8)
        wheel = Box.around((0, 0.09, high - 0.08), 0.13, 0.025, 0.13)
        d.cylinder(wheel, "steel", "y", bevel=0.004, segments=20)
        d.print(arm.front(0.0).share(y=(0.35, 0.68), z=(0.35, 0.65)), "brass")
        d.cylinder(Box.sized(0.03, 0.03, 0.044, (0, -0.07, high - 0.044)), "red fabric", segments=12)
    d.clear(Box((-0.05, deep / 2), (0.2 - wide / 2, wide / 2 - 0.28), (0.13, level - 0.05)))


@draws("pet_bed", whole=True)
def pet_bed(d: Drawing) -> None:
    """A plump rim of cloth around a cushion, lower in front, with a bone upon it."""
    cloth = d.material("rim", "grey fabric, charcoal fabric, rust fabric, blue fabric, beige fabric, wicker")
    pad = d.material("cushion", "white fabric, beige fabric")
    deep, wide, high = d.size
    t = np.arange(28) * 2 * np.pi / 28
    r = 0.3 * high
    out = np.c_[np.cos(t), np.sin(t)] * (deep / 2 - r, wide / 2 - r)
    dip = 0.34 * high * np.clip((np.cos(t) - 0.45) / 0.55, 0, 1) ** 0.7  # the way in
    d.extrude(1.06 * out, (0.0, 0.32 * high), cloth)
    for share, sink in ((1.0, 0.0), (1.02, 0.42 * high)):
        level = np.maximum(high - r - dip - sink, r)
        d.sweep(np.c_[share * out, level], r, cloth, 12, closed=True)
    d.ball(Box.around((0, 0, 0.42 * high), 1.7 * out[:, 0].max(), 1.8 * out[:, 1].max(), 0.4 * high), pad)
    d.extrude(0.8 * out, (0.3 * high, 0.55 * high), pad)
    z = 0.64 * high
    d.bar((0, -0.06, z), (0.03, 0.06, z), 0.013, "paper", 8)
    for y in (-0.065, 0.065):
        for e in (-0.016, 0.016):
            ball(d, (0.015 + 0.23 * y + e, y, z), 0.019, "paper", 8)


@draws("cat_tree", whole=True)
def cat_tree(d: Drawing) -> None:
    """Posts wound with rope, carpeted boards, a house with a round door, a nest, a hanging ball."""
    felt = d.material("felt", "beige fabric, grey fabric, charcoal fabric, rust fabric")
    toy = d.material("ball", "red fabric, blue fabric, mustard fabric")
    box = d.bounds
    (x0, x1), (y0, y1), high = box.x, box.y, box.height
    shelf = 0.55 * high
    d.box(box.bottom(0.04), felt, 0.01)
    house = d.box(Box((x0 + 0.02, x1 - 0.06), (y0 + 0.02, 0.02), (0.04, 0.4)), felt, 0.015)
    for r, tone, proud in ((0.115, "wicker", 0.0003), (0.1, "black fabric", 0.0004)):
        d.print(house.front(0.0).place(None, 2 * r, 2 * r), tone, proud, oval=True)
    posts = ((0.1, 0.12, 0.4, shelf), (box.depth - 0.14, box.width - 0.12, 0.04, shelf))
    for x, y, low, top in (*posts, (0.12, box.width - 0.12, 0.04, high - 0.1)):
        post = Box.sized(0.09, 0.09, top - low, (x0 + x, y0 + y, low))
        d.cylinder(post, "rattan", segments=14)
        with d.no_colliders():  # turns of the rope
            for turn in post.inset(x=-0.0003, y=-0.0003).rows(int(post.height / 0.03)):
                d.cylinder(turn.share(z=(0.35, 0.65)), "wicker", segments=14)
    d.box(Box((x0 + 0.02, x1 - 0.02), (y0 + 0.04, y1 - 0.02), (shelf, shelf + 0.035)), felt, 0.01)
    q = 1.24 * min(x1, y1)
    nest = Box((x0 + 0.02, x0 + 0.02 + q), (y1 - 0.02 - q, y1 - 0.02), (high - 0.11, high))
    d.turned(nest, [(0.8, 0), (0.95, 0.4), (1, 0.85), (0.96, 1), (0.84, 1), (0.8, 0.55), (0, 0.5)], felt, hollow=True)
    d.cylinder(nest.share((0.1, 0.9), (0.1, 0.9), (0.45, 0.62)), "white fabric")
    d.bar((x1 - 0.06, y0 + 0.12, shelf), (x1 - 0.06, y0 + 0.12, shelf - 0.14), 0.004, "wicker", 6)
    ball(d, (x1 - 0.06, y0 + 0.12, shelf - 0.16), 0.03, toy, 10)
