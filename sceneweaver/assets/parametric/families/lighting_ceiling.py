"""Lamps that hang from the ceiling or on the wall, and fans."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from .lighting_parts import CLOTHS, globe, rose, shade, shell

PENDANTS = {"dome": 1.0, "drum": 0.9, "globe": 2.0, "cone": 1.25, "basket": 1.15, "slats": 1.2}
"""How high the shades of pendants are, in their radius."""


@draws("pendant", whole=True, even="round")
def pendant(d: Drawing) -> None:
    """A cord from a rose, and a bell, drum, globe, cone, woven basket or slats around a light."""
    box = d.even("round")
    r, h = box.width / 2, box.height
    kind = d.pick("kind", list(PENDANTS))
    names = "black steel, brass, copper, white steel, brushed steel, teal paint, sage paint, mustard fabric"
    metal = d.material("metal", names)
    tall = min(0.6 * h, r * PENDANTS[kind])
    own = box.bottom(tall)
    with d.part("cord"):
        rose(d, h, 0.05, "black steel" if kind == "globe" else metal)
        d.bar((0, 0, tall - 0.01), (0, 0, h - 0.04), 0.0035, "black plastic", 8)
        cap = [(0.024, tall - 0.012), (0.024, tall + 0.02), (0.014, tall + 0.05), (0.007, tall + 0.056)]
        d.revolve(cap, metal, 16)
    with d.part("shade"):
        if kind in ("dome", "cone"):
            bell = [(r, 0.0), (0.94 * r, 0.08 * tall), (0.035, tall)]
            if kind == "dome":
                bell = shapes.dome(r, 0.0, tall, 8, 0.03)
            shell(d, bell, metal, 0.003)
            with d.no_colliders():
                d.revolve([(bell[1][0] - 0.006, bell[1][1]), (0.5 * r, 0.4 * tall)], "lamp glow")
        elif kind == "drum":
            shade(d, own, d.material("shade", CLOTHS), d.uniform("taper", 0.8, 1.0))
        elif kind == "globe":
            ball = min(2 * r, tall)
            globe(d, own.place(ball, ball), 24)
            d.revolve([(0.25 * ball, 0.93 * tall), (0.15 * ball, 0.985 * tall), (0.03, tall + 0.01)], metal, 20)
            if ball < 2 * r:
                d.cylinder(own.place(height=0.012), metal, segments=32)
        elif kind == "basket":
            basket(d, own, d.material("weave", "rattan, wicker, black paint"))
        else:
            wood = d.material("slats", "light oak, walnut, white paint, birch")
            for k, level in enumerate(own.rows(7)):
                share = 1.0 if k == 3 else math.sin(math.pi * (0.16 + 0.62 * (k + 0.5) / 7)) ** 0.8
                wide = share * 2 * r
                d.cylinder(level.place(wide, wide, 0.016), wood, ends=(1.0, 0.9), segments=28)
            d.cylinder(own.place(0.84 * r, 0.84 * r), "lamp glow", ends=(1.0, 0.86))


def basket(d: Drawing, box: Box, weave: Look) -> None:
    """A round basket of ribs and rings around a glowing ball."""
    r = box.width / 2
    angles = np.linspace(-0.35, 1.35, 8)
    rise = (np.sin(angles) - math.sin(-0.35)) / (math.sin(1.35) - math.sin(-0.35))
    curve = np.c_[np.cos(angles) * (r - 0.004), 0 * angles, 0.004 + (box.height - 0.008) * rise]
    with d.ring(12):
        d.sweep(curve[[0, 2, 4, 6, 7]], 0.004, weave, 6)
    for u, _, z in curve[[0, 2, 3, 5, 7]]:
        turns = np.arange(24) * (math.pi / 12)
        wire = shapes.sweep(np.c_[u * np.cos(turns), u * np.sin(turns), np.full(24, z)], 0.004, 6, True)
        d.add(wire, weave, [shapes.frustum(u + 0.004, u + 0.004, (z - 0.0045, z + 0.0045), 24)])
    globe(d, Box.around((0, 0, 0.45 * box.height), 0.76 * r, 0.76 * r, 0.76 * r), 16)


@draws("chandelier", whole=True, even="round")
def chandelier(d: Drawing) -> None:
    """A turned stem with curved arms and candles of light or globes; or a ring of light on wires."""
    box = d.even("round")
    r, h = box.width / 2, box.height
    metal = d.material("metal", "brass, black steel, bronze, chrome")
    kind = d.pick("kind", ["candles", "ring", "globes"])
    count = d.integer("arms", 5, 8)
    with d.part("stem"):
        rose(d, h, 0.06, metal)
        d.bar((0, 0, 0.5 * h), (0, 0, h - 0.04), 0.006, metal, 8)
        if kind == "ring":
            d.cylinder(Box.sized(0.032, 0.032, 0.16 * h, (0, 0, 0.5 * h)), metal, bevel=0.004, segments=16)
    if kind == "ring":
        with d.part("ring"):
            turns = np.arange(32) * (math.pi / 16)
            inner = r - 0.013
            path = np.c_[inner * np.cos(turns), inner * np.sin(turns), np.full(32, 0.03)]
            d.sweep(path, shapes.rectangle((-0.012, 0.012), (-0.022, 0.022), 0.0, 0.0, 1)[::2, :2], metal, closed=True)
            with d.no_colliders():
                light = shapes.rectangle((-0.0124, 0.0124), (-0.0224, 0.002), 0.0, 0.0, 1)[::2, :2]
                d.sweep(path, light, "lamp glow", closed=True)
            with d.ring(4, 0.0, math.pi / 4):
                d.bar((inner, 0, 0.03), (0, 0, 0.62 * h), 0.002, metal, 6)
        return
    body = min(0.42, 0.5 * h)
    k = body / 0.42
    bulb = 0.014 if kind == "candles" else min(0.07, 0.2 * r)
    out, cup = r - (0.034 if kind == "candles" else bulb), 0.42 * body
    with d.part("body"):
        low = [(0.0, 0.0), (0.02, 0.012), (0.016, 0.03), (0.05 * k, 0.07), (0.062 * k, 0.11)]
        balls = ((0.03, 0.16), (0.018, 0.2), (0.032, 0.27), (0.02, 0.34))
        d.revolve([*low, *((q, z * k + 0.02) for q, z in balls), (0.012, 0.5 * h + 0.02)], metal, 20)
        with d.ring(count, 0.0, math.pi / count):
            arm = [(0.03, 0.12 * k), (0.3 * out, 0.035), (0.62 * out, 0.03), (0.9 * out, 0.09 * k), (out, cup)]
            d.sweep([(x, 0, z) for x, z in arm], 0.006, metal, 8)
            with d.at(out, 0.0, cup):
                if kind == "candles":
                    d.revolve([(0.008, -0.016), (0.034, 0.0), (0.034, 0.006)], metal, 14)
                    d.cylinder(Box.sized(0.026, 0.026, 0.085), "candle wax", segments=10)
                    d.revolve([(0.008, 0.085), (bulb, 0.105), (0.006, 0.14), (0.0, 0.155)], "lamp glow", 10)
                else:
                    d.revolve([(0.01, -0.02), (0.6 * bulb, 0.0), (0.6 * bulb, 0.012)], metal, 14)
                    globe(d, Box.sized(2 * bulb, 2 * bulb, 2 * bulb, (0, 0, 0.004)), 14)


@draws("ceiling_light", whole=True, even="round")
def ceiling_light(d: Drawing) -> None:
    """A flush light: an opal bowl, a flat disc in a metal ring, a drum of cloth, or a square."""
    box = d.even("round")
    metal = d.material("rim", "brushed steel, brass, white steel, black steel, oak")
    kind = d.pick("kind", ["bowl", "disc", "drum", "square"])
    if kind == "bowl":
        turns = np.linspace(0, math.pi / 2, 8)
        d.turned(box.inset(top=0.03), [(0.93 * math.sin(a), 1 - math.cos(a)) for a in turns], "lamp glow", 32)
        d.cylinder(box.top(0.032), metal, bevel=0.005, segments=32)
        d.turned(Box.sized(0.024, 0.024, 0.018, (0, 0, -0.012)), [(0.0, 0.0), (1.0, 0.45), (0.8, 1.0)], metal, 12)
    elif kind == "disc":
        d.cylinder(box.share(z=(0.62, 1.0)), metal, bevel=0.004, segments=32)
        glass = box.share((0.02, 0.98), (0.02, 0.98), (0.0, 0.7))
        d.cylinder(glass, "lamp glow", ends=(0.9, 1.0), bevel=0.006, segments=32)
    elif kind == "drum":
        shade(d, box.inset(top=0.012), d.material("shade", CLOTHS))
        d.cylinder(box.share((0.25, 0.75), (0.25, 0.75)).top(0.02), metal)
    else:
        d.box(box.share(z=(0.7, 1.0)), metal, bevel=0.004)
        d.box(box.share((0.035, 0.965), (0.035, 0.965), (0.0, 0.72)), "lamp glow", bevel=0.012)


@draws("track_light", whole=True)
def track_light(d: Drawing) -> None:
    """A rail with three to five spots turned each its own way."""
    box = d.bounds
    metal = d.material("rail", "black steel, white steel, brushed steel")
    rail = box.top(0.025)
    with d.part("rail"):
        d.box(rail.place(0.036), metal)
    # A spot is a can that stays in the box however it is turned.
    r = min(0.04, 0.3 * box.depth)
    long = min(rail.z[0] - 0.05, 2.4 * r)
    with d.part("spots"):
        for k, cell in enumerate(box.columns(max(3, min(5, round(box.width / 0.3))))):
            with d.at(0, cell.center[1], rail.z[0]):
                d.cylinder(Box.sized(0.028, 0.028, 0.03, (0, 0, -0.03)), metal, segments=12)
                d.bar((0, 0, -0.02), (0, 0, -0.05), 0.006, metal, 8)
                roll = d.uniform(f"turn {k}", -0.5, 0.5) if k else 0.0
                pitch = d.uniform(f"tip {k}", -0.4, 0.4) if k else 0.0
                with d.at(0, 0, -0.04, pitch=pitch, roll=roll):
                    d.cylinder(Box.sized(2 * r, 2 * r, long, (0, 0, -long)), metal, ends=(1.0, 0.86), bevel=0.004)
                    light = Box.sized(1.6 * r, 1.6 * r, 0.012, (0, 0, -long - 0.002))
                    d.cylinder(light, "lamp glow", segments=18)
        feed = box.inset(y=0.01).right(0.08)
        d.box(feed.top(0.0175).inset(top=0.002), metal)


@draws("ceiling_fan", whole=True, even="round")
def ceiling_fan(d: Drawing) -> None:
    """A rod, a motor, three to five pitched blades, and often a light below."""
    box = d.even("round")
    r, h = box.width / 2, box.height
    metal = d.material("motor", "brushed steel, white steel, black steel, bronze")
    blades = d.material("blades", "walnut, oak, white paint, black paint, wenge")
    count = d.pick("blades", [3, 4, 5])
    lit = d.chance("light", 0.7)
    low = 0.09 if lit else 0.0
    with d.part("motor"), d.at(z=low):
        d.revolve([(0.05, 0.0), (0.1, 0.012), (0.115, 0.05), (0.11, 0.09), (0.06, 0.125), (0.02, 0.15)], metal, 28)
        if lit:
            bowl = [(0.1 * math.sin(a), 0.088 * (1 - math.cos(a)) - 0.09) for a in np.linspace(0, math.pi / 2, 6)]
            d.revolve([*bowl, (0.1, 0.012)], "lamp glow", 28)
    with d.part("rod"):
        d.bar((0, 0, low + 0.14), (0, 0, h - 0.03), 0.012, metal, 12)
        d.revolve([(0.02, h - 0.075), (0.055, h - 0.05), (0.065, h - 0.02), (0.065, h)], metal)
    wide, reach = d.uniform("blade width", 0.055, 0.07), r - 0.012
    with d.part("blades"), d.ring(count), d.at(z=low + 0.055, roll=0.2):
        d.box(Box((0.09, 0.24), (-0.02, 0.02), (-0.004, 0.004)), metal)
        side = [(0.19, 0.7 * wide), (reach - 0.03, wide), (reach, 0.6 * wide)]
        d.extrude([*((x, -y) for x, y in side), *side[::-1]], (0.003, 0.011), blades, bevel=0.002)


@draws("wall_sconce", whole=True)
def wall_sconce(d: Drawing) -> None:
    """A plate on the wall with an arm and a shade or a globe; or a cylinder that lights up and down."""
    box = d.bounds
    depth, width, h = box.size
    metal = d.material("metal", "brass, black steel, brushed steel, bronze, white steel")
    kind = d.pick("kind", ["shade", "globe", "updown"])
    r = min(width / 2, 0.4 * depth)
    own = box.front(2 * r).place(width=2 * r)
    x, wall = own.center[0], box.x[0]
    if kind == "updown":
        d.box(box.back(0.018).share(y=(0.2, 0.8), z=(0.3, 0.7)), metal)
        d.box(Box((wall + 0.01, x), (-0.015, 0.015), (0.47 * h, 0.53 * h)), metal)
        with d.at(x):
            shell(d, [(r, 0.0), (r, h)], metal, 0.004)
            with d.no_colliders():
                d.cylinder(Box.sized(2 * r - 0.008, 2 * r - 0.008, h - 0.024, (0, 0, 0.012)), "lamp glow")
        return
    plate = min(0.05, 0.2 * h)
    d.cylinder(box.back(0.016).to(y=(-plate, plate), z=(0.0, 2 * plate)), metal, "x", ends=(1.0, 0.94), bevel=0.003)
    arm = ((wall + 0.01, plate), (x - 0.04, 0.2 * h), (x - 0.01, 0.22 * h), (x, 0.3 * h))
    d.sweep([(at, 0, z) for at, z in arm], 0.007, metal)
    with d.at(x):
        d.revolve([(0.012, 0.26 * h), (0.028, 0.32 * h), (0.028, 0.34 * h)], metal, 16)
        d.cylinder(Box.sized(0.024, 0.024, 0.14 * h, (0, 0, 0.32 * h)), "white plastic", segments=12)
    if kind == "shade":
        shade(d, own.to(z=(0.42 * h, h)), d.material("shade", CLOTHS), 0.66)
    else:
        globe(d, own.top(min(2 * r, 0.66 * h)))
