"""Shelves, hooks, planters and small devices on walls and ceilings; blinds."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.components import art
from .plants_parts import OVAL, leaves, sectors


@draws("wall_shelf", whole=True)
def wall_shelf(d: Drawing) -> None:
    """A board on the wall on brackets of metal or wood."""
    wood = d.material("board", "oak, walnut, white paint, pine, black paint, light oak")
    metal = d.material("brackets", "black steel, brass, white steel")
    kind, box = d.pick("brackets", ["corbel", "angle", "rail"]), d.bounds
    board = d.box(box.top(0.025), wood)
    with d.mirror("y"):
        low = box.inset(top=0.025)
        bracket = Box.around((0.0, box.y[1] - min(0.12, 0.18 * box.width), low.center[2]), box.depth, 0.03, low.height)
        if kind == "corbel":
            d.silhouette(bracket.inset(y=0.004, front=0.02), [(0.0, 0.0), (0.12, 0.0), (1.0, 1.0), (0.0, 1.0)], wood)
        else:
            for strip in (bracket.back(0.005), bracket.top(0.005).inset(front=0.01)):
                d.box(strip, metal, 0.001)
            if kind == "rail":
                d.bar(bracket.point(0.03, 0.5, 0.06), bracket.point(0.85, 0.5, 0.97), 0.004, metal, 6)
    d.surface("top", board, inset=0.003)


@draws("coat_hooks", whole=True)
def coat_hooks(d: Drawing) -> None:
    """A board with four to seven double hooks or pegs."""
    wood = d.material("board", "oak, white paint, walnut, pine, black paint")
    metal = d.material("hooks", "black steel, brass, chrome, iron")
    box, h, pegs = d.bounds, d.size.height, d.chance("pegs", 0.35)
    board = d.box(box.back(0.018).inset(bottom=0.25 * h), wood, 0.004)
    d.box(box.back(0.004).place(width=0.02).bottom(0.3 * h), wood, 0.0)
    x, out = board.x[1], box.x[1] - 0.009
    with d.grid(board.to(z=(0.0, h)), y=max(4, min(7, round(box.width / 0.14)))), d.at(-board.center[0]):
        if pegs:
            d.bar((x - 0.004, 0.0, 0.5 * h), (out - 0.003, 0.0, 0.62 * h), 0.009, wood)
            d.ball(Box.around((out - 0.003, 0.0, 0.62 * h), 0.024, 0.024, 0.024), wood, 10)
            return_hook = [(x, 0.36 * h), (x + 0.012, 0.1 * h), (x + 0.03, 0.08 * h), (x + 0.036, 0.22 * h)]
        else:
            d.box(Box((x, x + 0.005), (-0.01, 0.01), (0.3 * h, 0.9 * h)), metal)
            d.sweep([(x, 0.0, 0.66 * h), (out - 0.02, 0.0, 0.7 * h), (out, 0.0, 0.9 * h)], 0.005, metal, 8)
            d.ball(Box.around((out, 0.0, 0.9 * h), 0.018, 0.018, 0.018), metal, 8)
            return_hook = [(x, 0.4 * h), (x + 0.015, 0.08 * h + 0.006), (x + 0.035, 0.08 * h), (x + 0.042, 0.25 * h)]
        d.sweep([(px, 0.0, z) for px, z in return_hook], 0.005, metal, 8)


@draws("key_holder", whole=True)
def key_holder(d: Drawing) -> None:
    """A small board with a tray on top, hooks and keys."""
    wood = d.material("board", "walnut, oak, white paint, black steel")
    metal = d.material("hooks", "brass, black steel, chrome")
    box, h = d.bounds, d.size.height
    board = d.box(box.back(0.014).inset(bottom=0.35 * h), wood)
    tray = d.box(box.inset(back=0.014).to(z=(0.6 * h, 0.6 * h + 0.01)), wood)
    d.box(tray.front(0.008).top(-0.18 * h + 0.01), wood)
    x = board.x[1]
    for k, cell in enumerate(board.columns(max(3, round(box.width / 0.06)))):
        y = cell.center[1]
        d.sweep([(x, y, 0.48 * h), (x + 0.016, y, 0.44 * h), (x + 0.02, y, 0.52 * h)], 0.0025, metal, 6)
        if k % 2 == 0:
            d.cylinder(Box.around((x + 0.012, y, 0.36 * h), 0.003, 0.024, 0.024), "brass", "x", segments=14)
            blade = d.box(Box((x + 0.0105, x + 0.0135), (y - 0.003, y + 0.003), (0.0, 0.33 * h)), "brass", 0.0)
            d.box(blade.bottom(0.02).inset(bottom=0.004).left(-0.005), "brass", 0.0)


@draws("tapestry", whole=True)
def tapestry(d: Drawing) -> None:
    """A woven hanging on a rod, with a pattern and fringes."""
    wood = d.material("rod", "light oak, walnut, brass, bark")
    cloth = d.material("cloth", "beige fabric, white fabric, rust fabric, navy fabric, green fabric")
    box, r, fringe = d.bounds, d.size.depth / 2, 0.14 * d.size.height
    d.cylinder(box.top(2 * r), wood, "y", segments=12)
    sheet = box.back(0.006).inset(y=0.03, top=r)
    woven = sheet.inset(bottom=fringe)
    d.add(shapes.box(woven.x, woven.y, woven.z), cloth, [shapes.box(sheet.x, sheet.y, sheet.z)])
    rng = np.random.default_rng(d.integer("art", 0, 2**31 - 1))
    page = woven.front(-0.003).inset(y=0.03, bottom=0.04, top=r + 0.05)
    art(d, page, rng, d.pick("art", ["arches", "waves", "hills", "blocks"]))
    count = int(sheet.width / 0.014)
    with d.no_colliders():
        for k, cell in enumerate(sheet.inset(front=0.001).columns(count, gap=0.005)):
            low = 0.9 * fringe * abs(2 * (k + 0.5) / count - 1)
            d.box(cell.to(z=(low, fringe + 0.002)), cloth, 0.0)


@draws("wall_planter")
def wall_planter(d: Drawing) -> None:
    """A half-round pot on a plate, with leaves that hang over its lip."""
    look = d.material("pot", "terracotta, white ceramic, black steel, copper, grey ceramic")
    green = d.material("leaves", "leaf, pale leaf, dark leaf")
    box, (deep, w, h) = d.bounds, d.size
    low, high, r, x = 0.25 * h, 0.66 * h, 0.32 * w, box.x[0]
    turn, reach = np.linspace(-np.pi / 2, np.pi / 2, 13), min(0.8 * deep, r)
    with d.part("pot"):
        ring = np.c_[reach * np.cos(turn), r * np.sin(turn)]
        rims = [np.c_[s * ring + (x, 0.0), 0 * turn + z] for s, z in ((0.6, low), (1.0, high))]
        d.hull(np.concatenate(rims), look)
        d.box(box.back(0.008).to(y=(-r, r), z=(low, high + 0.04)), look)
        d.extrude(0.93 * ring + (x, 0.0), (high - 0.01, high + 0.002), "soil")
    rng = np.random.default_rng(d.integer("leaves", 0, 2**31 - 1))
    count = 34
    yaw, out = rng.uniform(-1.5, 1.5, count), rng.uniform(0.2, 0.8, count)
    base = np.c_[x + 0.012 + 0.6 * reach * out * np.cos(yaw), 0.8 * r * out * np.sin(yaw), np.full(count, high)]
    rise, bend = rng.uniform(0.5, 1.4, count), rng.uniform(1.0, 2.2, count)
    points, faces = leaves(base, yaw, rise, bend, 0.36 * h, 0.045, OVAL)
    # They fill the box before the wall, one part for each direction.
    start, end = points.min(axis=(0, 1)), points.max(axis=(0, 1))
    room = np.array([(x + 0.004, box.x[1]), box.y, (min(0.1 * h, low), h)])
    points = room[:, 0] + (points - start) / (end - start) * (room[:, 1] - room[:, 0])
    sector = sectors(yaw + 1.6, 6)
    with d.part("crown"):
        for k in np.unique(sector):
            mine = points[sector == k]
            every = faces[None] + (np.arange(len(mine)) * mine.shape[1])[:, None, None]
            skin = mine.reshape(-1, 3)
            d.add((skin, every.reshape(-1, 3).astype(np.int32)), green, [shapes.hull(skin)])
        d.box(box.back(0.006).place(width=0.02).to(z=(0.0, low + 0.02)), look)
    d.fit()


@draws("air_conditioner", whole=True)
def air_conditioner(d: Drawing) -> None:
    """A split unit: a rounded body with a louvre, a grille on top and a small display."""
    body = d.material("body", "white plastic, white paint, light grey paint")
    box, (deep, w, h) = d.bounds, d.size
    foot, front = 0.72, 1 - 0.02 / deep
    outline = [(0.0, 0.0), (foot, 0.0), (front, 0.3), (1.0, 0.5), (1.0, 0.9), (1 - 0.03 / deep, 1.0), (0.0, 1.0)]
    d.silhouette(box, outline, body)
    slope = math.atan2(0.3 * h, (front - foot) * deep)
    with d.at(*box.point((foot + front) / 2, 0.5, 0.15), pitch=-slope):  # its louvre lies on the slope below
        long = 0.4 * math.hypot(0.3 * h, (front - foot) * deep)
        vent = d.print(Box((-long, long), (-0.45 * w, 0.45 * w), (0.0, 0.0)), "black plastic", 0.0002)
        for blade in vent.inset(x=0.1 * long).split("x", 3, gap=0.35 * long):
            d.print(blade, body)
    d.print(Box.around((box.x[1] - 0.0005, 0.38 * w, 0.55 * h), 0.0, 0.08 * w, 0.06 * h), "screen")
    for slot in box.top(0.0).inset(y=0.05 * w).share(x=(0.15, 0.75)).split("x", 6, gap=0.06 * deep):
        d.print(slot, "grey plastic")


@draws("smoke_detector", whole=True, even="round")
def smoke_detector(d: Drawing) -> None:
    """A white disc with slots and a small lamp."""
    body, box = d.material("body", "white plastic"), d.even("round")
    r, h = box.width / 2, box.height
    profile = [(0.6 * r, 0.0), (0.8 * r, 0.1 * h), (0.92 * r, 0.45 * h), (r, 0.6 * h), (r, h)]
    d.add(shapes.lathe(profile, 32), body, [shapes.frustum(r, r, (0.0, h), 32)])
    with d.no_colliders():
        with d.ring(18):
            d.box(Box((0.84 * r, 0.895 * r), (-0.004, 0.004), (0.18 * h, 0.4 * h)), "black plastic", 0.0)
        d.cylinder(Box.sized(0.008, 0.008, 0.004, (0.4 * r, 0.0, 0.0)), "red plastic", segments=10)


@draws("ceiling_speaker", whole=True, even="round")
def ceiling_speaker(d: Drawing) -> None:
    """A round flat grille in a ring."""
    body, box = d.material("ring", "white plastic, black plastic, white steel"), d.even("round")
    d.turned(box, [(0.94, 0.0), (1.0, 0.4), (1.0, 1.0)], body, 36)
    with d.no_colliders():
        grille = box.place(0.86 * box.depth, 0.86 * box.width).bottom(0.5 * box.height)
        d.cylinder(grille.move(z=-0.0002), "grey plastic", segments=36)
        for k in range(1, 6):
            size = 0.14 * k
            d.hoop(box.place(size * box.depth, size * box.width).to(z=(0.0004, 0.0012)), 0.001, body)


@draws("thermostat", whole=True, even="round")
def thermostat(d: Drawing) -> None:
    """A round dial, or a square plate, with a dark display."""
    body, box = d.material("body", "white plastic, brushed steel, black plastic, brass"), d.even("round")
    if d.chance("round", 0.5):
        d.cylinder(box.inset(front=0.001), body, "x", ends=(1.0, 0.94), bevel=0.003, segments=32)
        dial = box.share(x=(0.5, 1.0), y=(0.11, 0.89), z=(0.11, 0.89))
        glass = d.cylinder(dial, "black glass", "x", segments=32)
        d.print(glass.front(0.0).place(width=0.028, height=0.012), "lamp glow")
        return
    d.box(box.inset(front=0.001), body, 0.004)
    d.box(box.front(0.004).share(y=(0.14, 0.86), z=(0.42, 0.86)), "screen", 0.0)
    for key in box.front(0.004).share(y=(0.2, 0.8), z=(0.16, 0.28)).columns(3, gap=0.012):
        d.box(key, "grey plastic", 0.001)


@draws("light_switch", whole=True)
def light_switch(d: Drawing) -> None:
    """A plate with one or two rockers."""
    plate, box = d.material("plate", "white plastic, brushed steel, black plastic, brass"), d.bounds
    d.box(box.share(x=(0.0, 0.55)), plate, 0.002)
    for rocker in box.share(y=(0.16, 0.84), z=(0.16, 0.84)).columns(d.pick("rockers", [1, 1, 2]), gap=0.002):
        d.silhouette(rocker, [(0.0, 0.0), (0.7, 0.03), (1.0, 0.97), (0.0, 1.0)], "white plastic")


@draws("window_blind", whole=True)
def window_blind(d: Drawing) -> None:
    """Slats on cords under a head rail, or a roller blind let down."""
    look = d.material("blind", "white paint, beige fabric, oak, grey fabric, light grey paint, walnut, sage paint")
    box, h, deep = d.bounds, d.size.height, d.size.depth
    if look.kind == "fabric":
        roll = d.cylinder(box.top(deep).inset(x=0.003, y=0.012, top=0.003, bottom=0.003), look, "y", segments=16)
        with d.mirror("y"):
            d.box(box.top(deep).left(0.012), "white steel")
        sheet = d.box(roll.front(0.003).to(z=(0.02, h - deep / 2)).inset(y=0.002), look, 0.0)
        d.box(sheet.bottom(0.025).move(z=-0.02).inset(x=-0.004, y=-0.002), "white steel", 0.002)
        return
    d.box(box.top(0.045), look)
    d.box(box.bottom(0.018).inset(x=0.15 * deep, y=0.01), look)
    room = box.inset(x=0.001, y=0.01, bottom=0.018, top=0.045)
    count = int((h - 0.08) / 0.045)
    with d.no_colliders(), d.along((0.0, 0.0, 0.045), (0.0, 0.0, h - 0.055), count), d.at(pitch=0.6):
        d.box(Box((-0.44 * deep, 0.44 * deep), room.y, (-0.0014, 0.0014)), look, 0.0)
    cords = [room.place(0.003, 0.003).move(y=share * box.width) for share in (-0.36, 0.0, 0.36)]
    for k, cord in enumerate(cords):
        d.add(shapes.box(cord.x, cord.y, cord.z), "white fabric", [] if k else [shapes.box(room.x, room.y, room.z)])
