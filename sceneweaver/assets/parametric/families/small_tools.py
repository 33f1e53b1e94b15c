"""Tools of a workshop, and what cleans a house."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.components import band


@draws("screwdriver_set", whole=True)
def screwdriver_set(d: Drawing) -> None:
    """Six screwdrivers upright in a stand, from large to small."""
    look = d.material("stand", "black plastic, oak, grey plastic, red plastic")
    grip = d.material("grips", "red plastic, yellow plastic, blue plastic, orange plastic, green plastic")
    box = d.bounds
    d.box(box.share(z=(0.0, 0.06)), look)
    legs = box.share(x=(0.2, 0.8), z=(0.06, 0.42))
    for leg in (legs.left(0.012), legs.right(0.012)):
        d.box(leg, look, 0.002)
    d.box(box.share(x=(0.08, 0.92), z=(0.42, 0.48)), look)
    for k, cell in enumerate(box.share(y=(0.04, 0.96)).columns(6)):
        s = 1.0 - 0.07 * k
        d.bar(cell.point(z=0.1 + 0.03 * k), cell.point(z=0.5), 0.0032 * s, "steel", 8)
        side = 0.13 * box.width * s
        own = cell.share(z=(0.48, 0.5 + 0.5 * s)).place(side, side)
        d.turned(own, [(0.6, 0), (0.75, 0.1), (0.65, 0.16), (1, 0.36), (0.95, 0.94), (0.6, 1)], grip, 8)
        d.cylinder(own.share((0.19, 0.81), (0.19, 0.81), (0.11, 0.16)), "black plastic", segments=10)


@draws("paint_can", whole=True, even="round")
def paint_can(d: Drawing) -> None:
    """A tin of paint with a label, a drip, a wire handle, and a brush on its lid."""
    label = d.material("label", "white paint, navy paint, yellow paint, sage paint")
    tones = ["teal paint", "red paint", "yellow paint", "sage paint", "blue paint", "terracotta pigment"]
    paint = d.pick("paint", tones)
    box = d.even("round")
    tin = box.inset(x=0.03 * box.depth, y=0.03 * box.width).share(z=(0.0, 0.86))
    r, top = tin.depth / 2, tin.height
    d.cylinder(tin.inset(top=0.008), "steel")
    rim = tin.top(0.012)
    d.turned(rim, [(1.03, 0), (1.03, 1), (0.94, 1), (0.93, 0.5), (0.0, 0.5)], "steel", 28, hollow=True)
    band(d, tin.share(z=(0.1, 0.82)), label)
    band(d, tin.share(z=(0.34, 0.62)), paint, proud=0.0004)
    for turn, low in ((0.4, 0.56), (0.96, 0.74), (-0.2, 0.7)):
        with d.at(yaw=turn):
            d.box(Box((0.96 * r, 1.045 * r), (-0.045 * r, 0.045 * r), (low * top, top)), paint, 0.002)
    with d.no_colliders():
        d.cylinder(tin.inset(x=0.3 * r, y=0.3 * r).top(0.01).inset(top=0.003), paint)
    t = np.linspace(0, np.pi, 9)
    d.sweep(np.c_[1.05 * r * np.sin(t), 1.04 * r * np.cos(t), (0.86 - 0.34 * np.sin(t)) * top], 0.0025, "steel", 6)
    with d.at(-0.72 * r, 0.1 * r, top - 0.002, yaw=0.2):
        brush = Box((0.0, 1.3 * r), (-0.03, 0.03), (0.0, 0.018))
        d.box(brush.share(x=(0.0, 0.4), y=(0.3, 0.7)).to(z=(0.0, box.height - top)), "beech", 0.005)
        d.box(brush.share(x=(0.38, 0.58)), "steel", 0.001)
        d.box(brush.share(x=(0.58, 1.0), y=(0.03, 0.97), z=(0.05, 0.9)), paint)


@draws("wrench", whole=True)
def wrench(d: Drawing) -> None:
    """A spanner with an open jaw and a ring."""
    steel = d.material("body", "steel, brushed steel, black steel, chrome")
    box = d.bounds
    wide, high = box.width, box.height
    d.silhouette(box.share(z=(0.1, 0.9)), [(0.14, 0.34), (0.8, 0.3), (0.8, 0.7), (0.14, 0.66)], steel, "z", bevel=0.001)
    d.print(box.share((0.26, 0.7), (0.41, 0.59), (0.9, 0.9)), "iron")
    t = np.arange(16) * 2 * np.pi / 16
    x = box.x[0] + 0.36 * wide
    d.sweep(
        np.c_[x + 0.24 * wide * np.cos(t), 0.24 * wide * np.sin(t), 0 * t + high / 2],
        (0.24 * wide, high),
        steel,
        closed=True,
    )
    jaw = [(0.78, 0.5), (0.86, 0.5), (0.88, 0.7), (1.0, 0.76), (0.97, 0.94), (0.88, 1.0), (0.8, 0.9)]
    d.silhouette(box, jaw, steel, "z")
    d.silhouette(box, [(x, 1 - y) for x, y in jaw], steel, "z")


@draws("spray_bottle", whole=True)
def spray_bottle(d: Drawing) -> None:
    """A bottle with a trigger head."""
    look = d.material("body", "clear plastic, blue plastic, green plastic, amber glass, white plastic, pink plastic")
    head = d.material("head", "white plastic, black plastic, red plastic, grey plastic")
    box = d.bounds
    deep, wide, _ = box.size
    bottle = box.place(0.7 * deep).move(x=-0.14 * deep)
    d.turned(bottle, [(0.94, 0), (1, 0.02), (1, 0.46), (0.8, 0.56), (0.34, 0.66)], look)
    if look.opacity < 1:
        with d.no_colliders():
            d.turned(bottle, [(0.9, 0.015), (0.94, 0.03), (0.94, 0.4)], "sky pigment")
    cap = bottle.place(0.8 * wide / 2, 0.8 * wide / 2)
    d.cylinder(cap.share(z=(0.65, 0.74)), head, ends=(1.0, 0.9))
    d.cylinder(cap.share((0.2, 0.8), (0.2, 0.8), (0.73, 0.86)), head, segments=12)
    print_ = d.pick("print", ["green plastic", "blue plastic", "orange plastic"])
    band(d, bottle.share(z=(0.12, 0.4)), "paper")
    band(d, bottle.share(z=(0.24, 0.32)), print_, proud=0.0004)
    nose = [(0.08, 0.9), (0.2, 0.82), (0.8, 0.87), (0.86, 0.9), (0.86, 0.97), (0.4, 1.0), (0.14, 0.98)]
    d.silhouette(box.share(y=(0.33, 0.67)), nose, head, bevel=0.002)
    d.box(box.share((0.84, 1.0), (0.37, 0.63), (0.885, 0.975)), head)
    trigger = "grey plastic" if not head.called("grey plastic") else "red plastic"
    d.silhouette(box.share(y=(0.4, 0.6)), [(0.56, 0.87), (0.68, 0.88), (0.8, 0.72), (0.74, 0.71), (0.58, 0.8)], trigger)


@draws("bucket", whole=True, even="round")
def bucket(d: Drawing) -> None:
    """A pail of water with a wire handle, and in some a cloth over its rim."""
    box = d.even("round")
    tones = "blue plastic, red plastic, grey plastic, brushed steel, yellow plastic, green plastic, white plastic"
    look = d.material("body", tones)
    r, high = 0.485 * box.depth, box.height
    shape = [(0.72, 0), (0.74, 0.03), (0.97, 0.93), (1, 0.94), (1, 0.99), (0.96, 1), (0.94, 1), (0.7, 0.04), (0, 0.03)]
    pail = box.place(2 * r, 2 * r)
    d.turned(pail, shape, look, 30, hollow=True)
    with d.no_colliders():
        d.cylinder(pail.inset(x=0.08 * r, y=0.08 * r).share(z=(0.05, 0.88)), "sky pigment", ends=(0.78, 1.0))
    ears = high - 0.04
    with d.mirror("y"):
        d.cylinder(Box.around((0, 0.97 * r, ears), 0.034, 0.1 * r, 0.034), look, "y", segments=14)
    t = np.linspace(0, np.pi, 10)
    d.sweep(np.c_[r * np.sin(t), r * np.cos(t), ears - 0.16 * high * np.sin(t)], 0.003, "steel", 6)
    d.cylinder(Box.around((r, 0, ears - 0.16 * high), 0.016, 0.32 * r, 0.016), "black plastic", "y", segments=10)
    if d.chance("cloth", 0.5):
        cloth = d.pick("cloth colour", ["mustard fabric", "blue fabric", "rose fabric"])
        with d.at(yaw=2.4):
            over = [(0.86, 0.7), (0.9, 1.0), (1.0, 1.0), (1.03, 0.7), (1.04, 0.6)]
            path = np.array([[(x * r, y * r, z * high + 0.003) for y in np.linspace(-0.25, 0.25, 4)] for x, z in over])
            d.sheet(path, 0.004, cloth, (4, 1))


@draws("extension_cord", whole=True)
def extension_cord(d: Drawing) -> None:
    """A strip of four or five sockets with a switch and its cord."""
    look = d.material("body", "white plastic, black plastic, grey plastic")
    dark = "grey plastic" if not look.called("grey plastic") else "black plastic"
    box = d.bounds
    strip = d.slab(box.share(x=(0.14, 0.86)).inset(left=0.07), look, 0.012, 0.004)
    face = strip.top(0.0).inset(right=0.012, left=0.038)
    for cell in face.columns(5 if box.width > 0.36 else 4):
        size = min(0.6 * box.depth, 0.88 * cell.width)
        socket = d.print(cell.place(size, size), dark, oval=True)
        for y in (0.33, 0.67):
            d.print(socket.share((0.44, 0.56), (y - 0.06, y + 0.06)), "ink pigment", 0.0004, oval=True)
    d.print(strip.top(0.0).left(0.036).inset(left=0.012).share(x=(0.33, 0.67)), "red plastic")
    y, deep = strip.y[1], box.depth
    plan = [(0.5, y - 0.01, 0.02), (0.5, y + 0.03, 0.012), (0.8, y + 0.05, 0.006), (0.96, 0.2 * box.width, 0.006)]
    plan += [(0.96, -0.3 * box.width, 0.006)]
    back = [(0.8, y + 0.05, 0.006), (0.4, y + 0.064, 0.006), (0.04, y - 0.02, 0.006), (0.04, -0.3 * box.width, 0.006)]
    for path in (plan, back):
        d.sweep([((x - 0.5) * deep, py, z) for x, py, z in path], 0.0045, look, 6)


@draws("watering_can", whole=True)
def watering_can(d: Drawing) -> None:
    """A can with a long spout and rose to the left, a handle behind and above."""
    look = d.material("body", "green paint, copper, brushed steel, mint plastic, yellow plastic, white steel")
    deep, wide, high = d.size
    r, y, top = deep / 2, -0.16 * wide, 0.62 * high
    can = Box.sized(deep, deep, top, (0.0, y, 0.0))
    d.turned(can, [(0.96, 0), (1, 0.03), (0.86, 1), (0.8, 1), (0.8, 0.9), (0, 0.9)], look, hollow=True)
    with d.no_colliders():
        d.cylinder(can.inset(x=0.2 * r, y=0.2 * r).share(z=(0.85, 0.94)), "sea pigment")
    for share, z in ((0.985, 0.04), (0.87, top - 0.006)):
        d.hoop(Box.around((0, y, z), 2 * share * r, 2 * share * r, 0), 0.003, look, steps=16)
    d.arch((0, y - 0.6 * r, top - 0.01), (0, y + 0.62 * r, top - 0.01), (0, 0, high - top + 0.004), 0.008, look, 8)
    reach = (0.0, 0.94 * r - wide / 2 - y + 0.02, 0.0)
    d.arch((0, y - 0.84 * r, top - 0.02), (0, y - 0.94 * r, 0.16 * high), reach, 0.007, look)
    low, tip = np.array([0.0, y + 0.84 * r, 0.16 * high]), np.array([0.0, wide / 2 - 0.04, 0.82 * high])
    d.sweep([low, tip], 0.015, look, 12)
    turn = -math.atan2(tip[1] - low[1], tip[2] - low[2])
    with d.at(*tip.tolist(), roll=turn):
        d.revolve([(0.014, -0.012), (0.036, 0.035)], look, 18)
        d.revolve([(0.036, 0.035), (0.03, 0.042)], "brass", 18)
    d.sweep([(0, y + 0.8 * r, top - 0.02), low + 0.55 * (tip - low)], 0.005, look, 8)


@draws("handsaw", whole=True)
def handsaw(d: Drawing) -> None:
    """A lying saw: a tapered blade with teeth and a closed grip."""
    grip = d.material("grip", "beech, walnut, red plastic, black plastic, yellow plastic")
    box = d.bounds
    high = box.height
    blade = box.share(z=(0.05, 0.17))
    edge = np.linspace(0.22, 0.99, 52)
    teeth = [(x, 0.08 - 0.04 * (k % 2)) for k, x in enumerate(edge)]
    outline = [(0.2, 0.92), (0.2, 0.08), *teeth, (1.0, 0.08), (1.0, 0.5)]
    plan = np.array([blade.point(x, y)[:2] for x, y in outline])
    around = [blade.point(x, y, z) for x, y in ((0.2, 0.92), (0.2, 0.04), (1, 0.04), (1, 0.5)) for z in (0, 1)]
    d.add(shapes.extrusion(plan, blade.z), "steel", [shapes.hull(np.array(around))])
    ring = [(0.25, 0.1), (0.05, 0.08), (0.01, 0.5), (0.06, 0.86), (0.2, 0.96), (0.26, 0.7)]
    d.sweep([box.point(x, y) for x, y in ring], (0.028, 0.98 * high), grip, closed=True)
    for y in (0.3, 0.65):
        d.cylinder(Box.around(box.point(0.245, y), 0.012, 0.012, 0.4 * high), "brass", segments=10)


@draws("small_parts_box", whole=True)
def small_parts_box(d: Drawing) -> None:
    """A flat case with compartments of screws and nails under a clear lid."""
    look = d.material("body", "blue plastic, red plastic, black plastic, grey plastic, yellow plastic")
    box = d.bounds
    case = d.slab(box.share(z=(0.0, 0.8)), look, 0.012)
    d.slab(box.inset(x=0.003, y=0.003).share(z=(0.79, 1.0)), "clear plastic", 0.01)
    fill = ("steel", "brass", "iron", "copper", "grey plastic", "red plastic")
    tray = case.top(0.0).share((0.07, 0.93), (0.05, 0.95))
    with d.no_colliders():
        for i, row in enumerate(tray.split("x", 3, gap=0.004)):
            for j, cell in enumerate(row.columns(5, gap=0.004)):
                d.box(cell.inset(z=-0.0005), "white plastic", 0.0)
                for k in range(7):
                    at = cell.point(d.uniform(f"{i}{j}{k}x", 0.1, 0.9), d.uniform(f"{i}{j}{k}y", 0.1, 0.9))
                    long = (0.13, 0.05) if k % 2 else (0.04, 0.15)
                    part = Box.around(at, long[0] * cell.depth, long[1] * cell.width, 0.12 * box.height + 0.0008 * k)
                    d.box(part, fill[(5 * i + j) % 6], 0.0)
    for y in (0.18, 0.82):
        d.box(box.front(0.006).inset(front=-0.004).share(y=(y, y), z=(0.3, 0.92)).inset(y=-0.018), look, 0.002)


@draws("flashlight", whole=True)
def flashlight(d: Drawing) -> None:
    """A torch that lies, its wide head with a glowing lens to the front."""
    look = d.material("body", "black steel, yellow plastic, red plastic, aluminium, blue plastic")
    deep, r = d.size.depth, d.size.height / 2
    body = [(0.52, -0.5), (0.62, -0.48), (0.62, 0.16), (1, 0.3), (1, 0.5), (0.88, 0.5), (0.8, 0.46), (0.0, 0.46)]
    with d.at(z=r, pitch=math.pi / 2):
        d.revolve([(q * r, x * deep) for q, x in body], look, 20, hollow=True)
        for k in range(6):
            low = (-0.36 + 0.07 * k) * deep
            d.revolve([(0.66 * r, low), (0.66 * r, low + 0.03 * deep)], "rubber", 16)
        with d.no_colliders():
            d.revolve([(0.8 * r, 0.46 * deep), (0.82 * r, 0.475 * deep)], "lamp glow", 20)
    switch = "red plastic" if not look.called("red plastic") else "black plastic"
    d.box(Box((0.06 * deep, 0.14 * deep), (-0.2 * r, 0.2 * r), (1.5 * r, 1.75 * r)), switch, 0.001)
    d.box(Box((-0.49 * deep, -0.46 * deep), (-0.5 * r, 0.5 * r), (0.0, 0.6 * r)), look, 0.001)
