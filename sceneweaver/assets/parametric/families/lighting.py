"""Lamps that stand on the floor or on furniture."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.components import leg
from .lighting_parts import CLOTHS, finial, flat_foot, globe, shade, shell


@draws("floor_lamp", whole=True, even="round")
def floor_lamp(d: Drawing) -> None:
    """A pole on a round foot with a cloth shade, a globe, a bowl that lights the ceiling, or a paper column."""
    box = d.even("round")
    r, h = box.width / 2, box.height
    kind = d.pick("kind", ["drum", "cone", "globe", "bowl", "column"])
    metal = d.material("pole", "black steel, brass, chrome, white steel, bronze")
    if kind == "column":
        return paper_column(d, box)
    tall = min(0.3, h * d.uniform("shade height", 0.15, 0.19))
    cloth = kind in ("drum", "cone")
    top = h - tall - 0.02 if cloth else h - 2 * r if kind == "globe" else h - 0.1
    with d.part("foot"):
        flat_foot(d, min(r, 0.14 if kind == "bowl" else 0.155), 0.025, metal)
    with d.part("pole"):
        d.cylinder(Box.sized(0.022, 0.022, top + 0.01, (0, 0, 0.02)), metal, ends=(1.0, 0.8), segments=16)
        d.cylinder(Box.sized(0.032, 0.032, 0.03, (0, 0, 0.5 * top)), metal, bevel=0.003, segments=16)
    with d.part("shade"):
        if cloth:
            taper = 1.0 if kind == "drum" else d.uniform("taper", 0.5, 0.72)
            shade(d, box.to(z=(h - tall - 0.012, h - 0.012)), d.material("shade", CLOTHS), taper)
            d.cylinder(Box.sized(0.02, 0.02, tall - 0.01, (0, 0, top)), metal, segments=12)
            finial(d, h, metal)
        elif kind == "globe":
            globe(d, box.top(2 * r))
            d.revolve([(0.012, top - 0.03), (0.42 * r, top + 0.005), (0.55 * r, top + 0.15 * r)], metal, 20)
        else:
            look = d.material("bowl", "frosted glass, white steel, brass, black steel")
            outside = [(0.014, h - 0.16), (0.05, h - 0.13), (0.75 * r, h - 0.05), (r, h - 0.004), (r, h)]
            d.revolve([*outside, (r - 0.006, h), (r - 0.012, h - 0.01), (0.0, h - 0.02)], look, 32, hollow=True)
            with d.no_colliders():
                glow = 0.85 * r
                d.cylinder(box.place(2 * glow, 2 * glow).to(z=(h - 0.02, h - 0.012)), "lamp glow")


def paper_column(d: Drawing, box: Box) -> None:
    """A glowing column of paper in a frame of wood."""
    wood = d.material("frame", "walnut, oak, black steel")
    low, high = box.bottom(0.03), box.top(0.025)
    with d.part("column"):
        d.box(low, wood)
        d.box(high, wood)
        body = box.inset(bottom=0.03, top=0.025)
        d.box(body.inset(x=0.012, y=0.012), "lit shade", bevel=0.0)
        with d.corners(body):
            d.box(Box((0.0, 0.018), (0.0, 0.018), (0.0, body.height)), wood, bevel=0.001)
        for field in body.rows(d.integer("bars", 3, 6))[1:]:
            d.box(field.inset(x=0.004, y=0.004).bottom(0.012).move(z=-0.006), wood, bevel=0.001)


@draws("arc_lamp", whole=True)
def arc_lamp(d: Drawing) -> None:
    """A heavy foot at the back, an upright, a wide arc, and a bell that hangs far in front."""
    depth, width, h = d.bounds.size
    metal = d.material("arc", "chrome, brass, black steel, brushed steel")
    stone = d.material("foot", "marble, dark marble, concrete")
    bell = width / 2 * d.uniform("bell", 0.7, 0.84)
    foot = Box((0.0, width), (-width / 2, width / 2), (0.0, 0.115))
    # The arc is a quarter and more of an ellipse from the upright to the bell.
    start, end = foot.center[0], depth - bell
    rise = h * d.uniform("upright", 0.42, 0.55)
    with d.part("foot"):
        if d.chance("round foot", 0.5):
            d.cylinder(foot, stone, bevel=0.006)
        else:
            d.box(foot, stone, bevel=0.005)
    with d.part("upright"):
        d.bar((start, 0, 0.1), (start, 0, rise), 0.013, metal, 14)
        for z, high in ((0.1, 0.06), (rise - 0.04, 0.06)):
            d.cylinder(Box.sized(0.04, 0.04, high, (start, 0, z)), metal, bevel=0.003, segments=16)
    last = math.radians(18)
    along, up = (end - start) / (1 + math.cos(last)), h - 0.009 - rise
    turns = np.linspace(0, math.pi - last, 15)
    path = [(start + along * (1 - math.cos(a)), 0.0, rise + up * math.sin(a)) for a in turns]
    for name, piece in (("rise", path[:8]), ("reach", path[7:])):
        with d.part(name):
            d.sweep(piece, 0.009, metal)
    x, _, tip = path[-1]
    high = bell * d.uniform("depth", 0.75, 0.95)
    with d.part("bell"), d.at(x, 0.0, tip - high - 0.06):
        d.cylinder(Box.sized(0.012, 0.012, 0.068, (0, 0, high)), metal, segments=10)
        d.revolve([(0.3 * bell, high - 0.012), (0.03, high + 0.012), (0.016, high + 0.035)], metal, 20)
        curve = [(bell * math.cos(a), high * math.sin(a)) for a in np.linspace(0, math.radians(75), 5)]
        shell(d, curve, metal, sectors=12)
        globe(d, Box.around((0, 0, 0.45 * high), 0.09, 0.09, 0.1), 12)
        d.cylinder(Box.sized(0.04, 0.04, 0.4 * high, (0, 0, 0.6 * high)), "black plastic", segments=12)


@draws("tripod_lamp", whole=True, even="round")
def tripod_lamp(d: Drawing) -> None:
    """Three leaning wooden legs that meet in a hub, with a drum of cloth on it."""
    box = d.even("round")
    width, h = box.width, box.height
    wood = d.material("legs", "oak, walnut, beech, black steel, light oak")
    metal = d.material("hub", "brass, black steel, brushed steel")
    cloth = d.material("shade", CLOTHS)
    spread = (width - 0.02) / 1.7321
    tall = d.uniform("shade height", 0.24, 0.30)
    hub = h - tall - d.uniform("neck", 0.04, 0.1)
    with d.part("legs"):
        with d.ring(3):
            leg(d, (spread, 0, 0), (0.032, 0, hub), 0.02, 0.028, wood, 8)
            if d.chance("brace", 0.6):
                d.bar((0, 0, 0.38 * hub), (0.62 * spread + 0.012, 0, 0.38 * hub), 0.005, metal, 8)
        d.cylinder(Box.sized(0.11, 0.11, 0.032, (0, 0, hub - 0.02)), metal, bevel=0.003, segments=20)
        d.cylinder(Box.sized(0.024, 0.024, h - 0.5 * tall - hub, (0, 0, hub)), metal, segments=12)
    with d.part("shade"):
        drum = 2 * width * d.uniform("shade", 0.36, 0.43)
        shade(d, Box.sized(drum, drum, tall, (0, 0, h - tall)), cloth, d.uniform("taper", 0.82, 1.0))


GOURD = [(0.62, 0.0), (0.66, 0.03), (0.95, 0.2), (1.0, 0.34), (0.86, 0.5), (0.52, 0.62), (0.42, 0.68), (0.5, 0.78)]
BALL = [(0.7, 0.0), (0.7, 0.05), (0.34, 0.11), (0.75, 0.24), (1.0, 0.45), (1.0, 0.58), (0.78, 0.8), (0.4, 0.93)]
STICK = [(1.0, 0.0), (1.0, 0.06), (0.9, 0.085), (0.2, 0.15), (0.22, 0.5), (0.32, 0.54), (0.22, 0.6), (0.2, 0.92)]
LAMP_BODIES = {
    "gourd": [*GOURD, (0.22, 1.0)],
    "bottle": [(0.8, 0.0), (0.86, 0.03), (0.9, 0.4), (0.86, 0.55), (0.6, 0.7), (0.32, 0.8), (0.24, 1.0)],
    "sphere": [*BALL, (0.2, 1.0)],
    "stick": [*STICK, (0.26, 1.0)],
}
MUSHROOM = [(0.62, 0.0), (0.66, 0.03), (0.3, 0.14), (0.2, 0.5), (0.24, 0.6)]


@draws("table_lamp", whole=True, even="round")
def table_lamp(d: Drawing) -> None:
    """A turned, ceramic or metal body under a cloth shade; or a mushroom of glass."""
    box = d.even("round")
    r, h = box.width / 2, box.height
    kind = d.pick("kind", [*LAMP_BODIES, "mushroom", "stack"])
    if kind == "mushroom":
        body = d.material("body", "brass, white steel, black steel, orange plastic, teal paint")
        d.turned(box, MUSHROOM, body, 28)
        d.turned(box, [(0.86, 0.56), (0.9, 0.585)], "lamp glow")
        dome = [(0.97, 0.57), (1.0, 0.585), *shapes.dome(1.0, 0.59, 1.0, 7)]
        d.turned(box, dome, "lit shade" if d.chance("lit", 0.5) else body, 28)
        return
    body = d.material("body", "@ceramic, oak, walnut, brass, glass, concrete, bronze")
    metal = d.material("fittings", "brass, black steel, brushed steel")
    tall = h * d.uniform("shade height", 0.38, 0.46)
    neck = h - tall - 0.02
    wide = 2 * r * d.uniform("girth", 0.5, 0.66)
    stand = Box.sized(wide, wide, neck - 0.03)
    if kind == "stack":
        d.box(stand.bottom(0.022), metal)
        for ball, share in zip(stand.inset(bottom=0.022).rows([0.34, 0.34, 0.3]), (0.62, 0.85, 0.55), strict=True):
            d.ball(ball.place(share * wide, share * wide), body)
    else:
        d.turned(stand, LAMP_BODIES[kind], body, 28)
    d.cylinder(Box.sized(0.04, 0.04, 0.022, (0, 0, stand.z[1] - 0.004)), metal, ends=(1.0, 0.9), segments=16)
    d.cylinder(Box.sized(0.016, 0.016, tall + 0.01, (0, 0, stand.z[1])), metal, segments=12)
    shade(d, box.to(z=(h - tall - 0.012, h - 0.012)), d.material("shade", CLOTHS), d.uniform("taper", 0.55, 1.0))
    finial(d, h, metal)


@draws("desk_lamp", whole=True)
def desk_lamp(d: Drawing) -> None:
    """A weighted foot, two arms with springs and joints, and a bell that looks down in front."""
    depth, width, h = d.bounds.size
    metal = d.material("lamp", "black steel, white steel, red paint, teal paint, aluminium, yellow paint, sage paint")
    joint = d.material("joints", "chrome, black plastic, brass")
    base = width / 2
    bell = base * d.uniform("bell", 0.62, 0.8)
    start, elbow = (-0.2 * base, 0.055), (-0.6 * base, h - 0.0115)
    tip = (depth - base - 1.54 * bell, h * d.uniform("head", 0.74, 0.84))
    with d.part("foot"):
        rim = [(base - 0.003, 0), (base, 0.004), (base, 0.026), (base - 0.006, 0.033), (0.03, 0.036), (0.018, 0.05)]
        d.revolve(rim, metal, 32)
    with d.part("arms"):
        for (x0, z0), (x1, z1) in ((start, elbow), (elbow, tip)):
            with d.mirror("y"):
                d.bar((x0, 0.011, z0), (x1, 0.011, z1), 0.0042, metal, 8)
        d.bar((-0.1 * base, 0, 0.03), (start[0], 0, start[1]), 0.009, metal)
        low, up = np.array((start[0], 0.0, start[1])), np.array((elbow[0] - start[0], 0.0, elbow[1] - start[1]))
        d.sweep([low + 0.05 * up, low + 0.4 * up], 0.006, joint, 8)
        for x, z in (start, elbow, tip):
            d.cylinder(Box.around((x, 0, z), 0.023, 0.034, 0.023), joint, "y", bevel=0.002, segments=14)
    with d.part("head"), d.at(tip[0], 0.0, tip[1], pitch=-0.45):
        long = 1.45 * bell
        curve = [(bell, -long), (0.88 * bell, -0.62 * long), (0.5 * bell, -0.28 * long), (0.02, -0.2 * long)]
        shell(d, curve, metal, sectors=12)
        d.revolve([(0.024, -0.24 * long), (0.022, 0.018), (0.014, 0.024)], metal, 20)
        globe(d, Box.around((0, 0, -0.5 * long), 0.84 * bell, 0.84 * bell, 0.84 * bell), 12)


@draws("lantern", whole=True, even="round")
def lantern(d: Drawing) -> None:
    """A square or six-sided lantern of glass between posts, with a roof, a ring, and a candle that burns."""
    box = d.even("round")
    h = box.height
    metal = d.material("frame", "black steel, white paint, copper, iron, oak")
    body = h * d.uniform("body", 0.6, 0.66)
    sides = d.pick("sides", [4, 4, 6])
    r = box.width / 2 * (1.0 if sides == 4 else 0.866)

    def ring(radius: float) -> np.ndarray:
        # Flats stand across x and y, so that the lantern is two radii deep.
        turns = (np.arange(sides) + 0.5) * (2 * np.pi / sides)
        return np.c_[np.cos(turns), np.sin(turns)] * radius / math.cos(math.pi / sides)

    d.extrude(ring(r), (0.0, 0.016), metal, bevel=0.003)
    d.extrude(ring(0.97 * r), (body, body + 0.014), metal, bevel=0.003)
    corners = ring(0.86 * r)
    d.extrude(corners, (0.016, body), "glass")
    rail = 0.016 + 0.72 * (body - 0.016)
    for (x, y), (to_x, to_y) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        d.box(Box.sized(0.012, 0.012, body - 0.016, (x, y, 0.016)), metal, bevel=0.001)
        d.bar((x, y, rail), (to_x, to_y, rail), 0.003, metal, 6)
    candle = Box.sized(0.72 * r, 0.72 * r, 0.45 * body - 0.017, (0, 0, 0.017))
    d.cylinder(candle, "candle wax", bevel=0.003, segments=20)
    d.revolve([(0.001, 0.45 * body), (0.008, 0.5 * body), (0.005, 0.55 * body), (0.0, 0.62 * body)], "flame", 10)
    roof = body + 0.52 * (h - body)
    d.loft([np.c_[ring(s), np.full(sides, z)] for s, z in ((0.92 * r, body + 0.014), (0.02, roof))], metal, convex=True)
    d.cylinder(Box.sized(0.036, 0.036, 0.016, (0, 0, roof)), metal, segments=12)
    loop = h - roof - 0.012
    d.hoop(Box.sized(0.0, loop - 0.006, loop - 0.006, (0, 0, roof + 0.015)), 0.003, metal, "x", steps=12)


@draws("string_lights", whole=True)
def string_lights(d: Drawing) -> None:
    """A hanging cord with many small bulbs, in bows along the wall."""
    box, h = d.bounds, d.bounds.height
    cord = d.material("cord", "black plastic, white plastic, green plastic")
    r = box.depth / 2
    bows = box.inset(y=r).columns(max(2, round(box.width)))
    sag = h - 3.1 * r - 0.008
    for k, bow in enumerate(bows):
        t = np.linspace(0, 1, 9)
        path = np.c_[0 * t, bow.y[0] + t * bow.width, h - 0.006 - 4 * sag * t * (1 - t)]
        d.sweep(path, 0.003, cord, 6)
        for _, y, z in path[1 if k else 0 :: 2]:
            with d.at(0, y, z):
                socket = shapes.frustum(0.5 * r, 0.5 * r, (-1.2 * r, 0.004), 8)
                bulb = shapes.ball((r, r, 1.25 * r), (0, 0, -1.75 * r), 10)
                d.add(socket, cord, [])
                d.add(bulb, "lamp glow", [shapes.hull_of([socket, bulb])])
    for y in (bows[0].y[0], *(bow.y[1] for bow in bows)):
        d.bar((box.x[0], y, h - 0.006), (0.003, y, h - 0.006), 0.006, "white plastic", 8)
