"""Sculptures, statues, globes, clocks, boxes and other things to look at."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import clock_face, lip, tub
from .small_parts import GOLDEN

STONES = "marble, white ceramic, bronze, dark marble, concrete, brass, terracotta"


@draws("sculpture", whole=True)
def sculpture(d: Drawing) -> None:
    """An abstract piece on a block: a ring, stacked stones, a twisted column, or two leaning shapes."""
    look = d.material("body", STONES)
    base = d.material("base", "black paint, walnut, marble, dark marble, oak")
    kind = d.pick("kind", ["ring", "stones", "twist", "arcs"])
    foot = d.bounds.bottom(min(0.035, 0.12 * d.bounds.height))
    d.box(foot.share(y=(0.2, 0.8)) if kind == "ring" else foot, base)
    room = d.bounds.inset(bottom=foot.height - 0.004)
    depth, w, h = room.size
    if kind == "ring":
        thick = min(0.3 * depth, 0.12 * w)
        d.hoop(Box.around(room.center, 0.0, w - 2 * thick, h - 2 * thick), thick, look, "x", steps=28)
    elif kind == "stones":
        for k, stone in enumerate(room.rows([0.36, 0.3, 0.22, 0.16], gap=-0.0133 * h)):
            side = 0.86 - 0.155 * k
            own = stone.place(side * depth, side * w).move(0.03 * depth * (-1) ** k, 0.05 * w * (-1) ** k)
            d.ball(own, base if k % 2 else look, 18)
    elif kind == "twist":
        rings = []
        for t in np.linspace(0.0, 1.0, 15):
            turn, size = 2.2 * t, 0.36 * min(depth, w) * (1.0 - 0.44 * abs(2 * t - 1) ** 1.5)
            ring = size * np.array([(1, 0.6), (-1, 0.6), (-1, -0.6), (1, -0.6)])
            c, s = math.cos(turn), math.sin(turn)
            rings.append(np.c_[ring @ np.array([[c, s], [-s, c]]), np.full(4, room.z[0] + t * h)])
        d.loft(rings, look)
    else:
        t = np.linspace(0, 1, 8)
        section = shapes.rectangle((-0.02, 0.02), (-0.2 * depth, 0.2 * depth), 0.0, 0.006, 1)[:, 1::-1][::-1]
        for side, tall, one in ((1, 1.0, look), (-1, 0.78, base)):
            bend = side * (0.16 + 0.2 * np.sin(np.pi * t) - 0.26 * t) * w
            d.sweep(np.c_[0 * t, bend, room.z[0] + (tall * h - 0.012) * t], section, one)
        d.ball(Box.sized(0.2 * w, 0.2 * w, 0.2 * w, (0, 0, room.z[0])), "brass", 16)


def head(d: Drawing, size: float, look: Look) -> None:
    """A head of a height [m] with its chin on the frame's origin: skull, jaw, nose, ears, curls and neck."""
    bodies = (
        ((-0.03, 0.0, 0.6), (0.72, 0.6, 0.8), 18),  # skull
        ((0.08, 0.0, 0.33), (0.5, 0.44, 0.68), 14),  # jaw
        ((0.315, 0.0, 0.24), (0.1, 0.18, 0.05), 8),  # mouth
        *(((-0.02, 0.295 * s, 0.5), (0.1, 0.06, 0.18), 8) for s in (-1, 1)),  # ears
        *(((0.27, 0.11 * s, 0.62), (0.18, 0.2, 0.06), 8) for s in (-1, 1)),  # brows
    )
    for at, extent, segments in bodies:
        point = (size * at[0], size * at[1], size * at[2])
        d.ball(Box.around(point, *(size * v for v in extent)), look, segments)
    nose = ((0.3, 0.0, 0.62), (0.43, 0.045, 0.4), (0.43, -0.045, 0.4), (0.26, 0.07, 0.38), (0.26, -0.07, 0.38))
    d.hull([(size * x, size * y, size * z) for x, y, z in nose], look)
    for k in range(18):
        turn, rise = GOLDEN * k, 0.15 + 1.3 * (k + 0.5) / 18
        x, z = -0.06 + 0.34 * math.cos(turn) * math.cos(rise), 0.62 + 0.37 * math.sin(rise)
        if x <= 0.2 or z >= 0.8:
            curl = size * (0.16 + 0.04 * (k % 3) / 2)
            point = (size * x, 0.29 * size * math.sin(turn) * math.cos(rise), min(size * z, 0.99 * size - curl / 2))
            d.ball(Box.around(point, curl, curl, curl), look, 8)
    d.cylinder(Box.sized(0.4 * size, 0.4 * size, 0.6 * size, (0, 0, -0.3 * size)), look, ends=(1.0, 0.85), segments=16)


@draws("bust", whole=True)
def bust(d: Drawing) -> None:
    """A head and shoulders of stone on a turned foot."""
    look = d.material("stone", "marble, white ceramic, bronze, concrete, terracotta")
    box = d.bounds
    size = min(0.46 * box.height, 1.05 * box.depth)
    foot, chest = box.share(z=(0.0, 0.2)), box.share(z=(0.2, 1.0)).inset(top=size)
    d.turned(foot.place(width=box.depth), [(0.72, 0.0), (0.72, 0.2), (0.5, 0.4), (0.4, 0.8), (0.5, 1.0)], look)
    rows = [
        (0.56, 0.44, 0.0),
        (0.9, 0.78, 0.3),
        (1.0, 0.96, 0.55),
        (0.92, 1.0, 0.7),
        (0.72, 0.8, 0.86),
        (0.5, 0.36, 1.0),
    ]
    d.sections(chest, rows, look)
    with d.at(0.02 * box.depth, 0.0, chest.z[1] - 0.005):
        head(d, 0.99 * size, look)


@draws("statue", whole=True)
def statue(d: Drawing) -> None:
    """A draped standing figure on a plinth."""
    look = d.material("stone", "marble, bronze, concrete, terracotta")
    base = d.material("plinth", "marble, dark marble, granite, concrete")
    plinth, figure = d.bounds.share(z=(0.0, 0.3)), d.bounds.share(z=(0.3, 1.0))
    with d.part("plinth"):
        for share, block in zip((1.0, 0.84, 0.96), plinth.rows([0.14, 0.74, 0.12]), strict=True):
            d.box(block.place(share * plinth.depth, share * plinth.width), base, bevel=0.005)
    r = 0.4 * min(figure.depth, figure.width)
    own, low = figure.place(1.44 * r, 2 * r), figure.z[0]
    high = figure.height
    with d.part("figure"):
        d.cylinder(figure.bottom(0.02).place(2 * r, 2 * r), look, bevel=0.004)
        skirt = [(0.8, 0.02), (0.66, 0.2), (0.6, 0.42), (0.66, 0.5)]
        d.turned(own, [*skirt, (0.46, 0.64), (0.6, 0.76), (0.56, 0.82), (0.2, 0.85)], look, 16)
        for k in range(11):  # folds
            a = -1.5 + 0.3 * k
            foot = (0.57 * r * math.cos(a), 0.8 * r * math.sin(a), low + 0.02 * high)
            d.bar(foot, (0.35 * r * math.cos(a), 0.48 * r * math.sin(a), low + 0.62 * high), 0.07 * r, look, 6)
        for side, reach in ((1, 0.62), (-1, 0.54)):
            hand = (0.5 * r, 0.3 * side * r, low + reach * high)
            elbow = (0.1 * r, 0.86 * side * r, low + 0.6 * high)
            d.sweep([(0, 0.56 * side * r, low + 0.79 * high), elbow, hand], 0.13 * r, look)
            d.ball(Box.around(hand, 0.3 * r, 0.26 * r, 0.26 * r), look, 10)
        with d.at(0, 0, low + 0.85 * high):
            head(d, 0.1495 * high, look)


@draws("pedestal", whole=True)
def pedestal(d: Drawing) -> None:
    """A plinth or a fluted column that carries a piece."""
    look = d.material("stone", "marble, white paint, concrete, oak, dark marble, black paint")
    box = d.bounds
    if d.chance("column", 0.55):
        r = 0.37 * min(box.depth, box.width)
        for slab in (box.bottom(0.05), box.top(0.045)):
            d.box(slab, look, bevel=0.004)
        shaft = Box.sized(2 * r, 2 * r, box.height - 0.095, (0, 0, 0.05))
        base, capital = shaft.bottom(0.05), shaft.top(0.045)
        d.turned(base, [(1.16, 0.0), (1.16, 0.5), (1.02, 1.0)], look, 32)
        d.turned(capital, [(0.98, 0.0), (1.14, 0.67), (1.14, 1.0)], look, 32)
        t = np.arange(48)
        radii = np.where(t % 3 == 0, r, 0.95 * r)  # a flute between two ridges
        ring = np.c_[np.cos(t * math.pi / 24), np.sin(t * math.pi / 24)] * radii[:, None]
        z = (base.z[1], capital.z[0])
        d.add(shapes.extrusion(ring, z), look, [shapes.extrusion(ring[::3], z)])
    else:
        low, high = box.bottom(0.06), box.top(0.035)
        d.box(box.share((0.05, 0.95), (0.05, 0.95)).inset(bottom=0.06, top=0.035), look)
        for slab in (low, high):
            d.box(slab, look, bevel=0.005)
    d.surface("top", box, inset=0.008)


CONTINENTS = (
    *((0.4, 0.6, 0.5), (0.1, -0.5, 0.42), (1.5, 0.5, 0.55), (2.2, 0.1, 0.4), (3.3, 0.6, 0.45), (3.6, -0.4, 0.45)),
    *((5.0, 0.2, 0.5), (5.6, 0.7, 0.4), (4.5, -0.5, 0.35), (0.0, 1.5, 0.3), (0.0, -1.5, 0.35)),
)
"""Longitude, latitude and radius [rad] of the lands on a globe."""


@draws("desk_globe", whole=True)
def desk_globe(d: Drawing) -> None:
    """A globe with continents, tilted in a half ring on a turned foot."""
    metal = d.material("stand", "brass, walnut, oak, black steel, chrome")
    sea = d.material("sea", "sea pigment, sky pigment, night pigment, sand pigment")
    old = sea.called("sand pigment")
    land = d.named("wicker") if old else d.material("land", "moss pigment, ochre pigment, forest pigment")
    r = min(d.bounds.width / 2 - 0.012, (d.bounds.height - 0.07) / 2.14)
    z, tilt = d.bounds.height - r - 0.012, 0.41
    d.revolve([(0.62 * r, 0.0), (0.62 * r, 0.008), (0.5 * r, 0.016), (0.014, 0.03), (0.012, z - r - 0.006)], metal, 28)
    rng = np.random.default_rng(d.integer("lands", 0, 9))
    with d.at(0, 0, z, roll=tilt):
        d.ball(Box.around((0, 0, 0), 2 * r, 2 * r, 2 * r), sea, 24)
        t = 0.2 * np.pi * np.arange(10)
        for east, north, size in CONTINENTS:
            wide = size * rng.uniform(0.6, 1.1, 10)
            lon, lat = east + wide * np.cos(t) / max(0.3, math.cos(north)), north + 0.8 * wide * np.sin(t)
            rim = r * np.c_[np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)]
            middle = rim.mean(axis=0, keepdims=True)
            inner = (rim + middle) / 2
            inner, middle = (p * r / np.linalg.norm(p, axis=1, keepdims=True) for p in (inner, middle))
            d.hull(np.concatenate([0.97 * rim, 1.0025 * rim, 1.003 * inner, 1.003 * middle]), land)
    a = np.linspace(-math.pi / 2, math.pi / 2, 13) - tilt
    d.sweep(np.c_[0 * a, (r + 0.007) * np.cos(a), z + (r + 0.007) * np.sin(a)], 0.0045, metal, 8)


@draws("table_clock", whole=True)
def table_clock(d: Drawing) -> None:
    """A mantel clock: an arched or square wooden case with a dial."""
    wood = d.material("case", "walnut, oak, cherry, black paint, marble")
    base = d.box(d.bounds.bottom(0.018), wood, bevel=0.004)
    case = d.bounds.inset(bottom=0.018, y=0.012, back=0.008, front=0.012)
    half = case.width / 2
    if d.chance("arch", 0.6):
        t = np.linspace(0, np.pi, 17)
        spring = max(case.z[1] - half, 0.03)
        arch = np.c_[half * np.cos(t), spring + (case.z[1] - spring) * np.sin(t)]
        d.extrude([(-half, base.z[1]), (half, base.z[1]), *arch], case.x, wood, axis="x", bevel=0.002)
    else:
        d.box(case, wood)
    r = 0.8 * min(half, case.height / 2)
    face = Box.around(case.anchor("front"), 0.008, 2 * r, 2 * r)
    d.cylinder(face.inset(y=-0.006, z=-0.006), "brass", "x", segments=32)
    clock_face(d, face.front(-0.0055).inset(back=-0.006), "cream paint", "black steel")


@draws("alarm_clock", whole=True)
def alarm_clock(d: Drawing) -> None:
    """A round clock with two bells and a hammer on two skids."""
    look = d.material("case", "red paint, black steel, brass, teal paint, white steel, copper")
    depth, w, h = d.bounds.size
    r = min(w / 2, 0.4 * h)
    z = 0.008 + r
    with d.mirror("y"):
        d.bar((0, 0.45 * r, z - 0.7 * r), (0, 0.72 * r, 0.005), 0.005, look, 8)
        # Skids as deep as the case: on two points it would tip.
        d.box(Box.sized(0.84 * depth, 0.012, 0.007, (0, 0.72 * r, 0)), look, bevel=0.002)
        with d.at(0, 0.52 * r, z + 0.84 * r, roll=-0.5):
            d.revolve([(0.4 * r, 0.0), (0.36 * r, 0.16 * r), (0.16 * r, 0.28 * r), (0.0, 0.3 * r)], "chrome", 18)
            d.bar((0, 0, -0.2 * r), (0, 0, 0.002), 0.003, "chrome", 6)
    d.bar((0, 0, z + 0.9 * r), (0, 0, h - 0.006), 0.0025, "chrome", 6)
    d.ball(Box.around((0, 0, h - 0.006), 0.012, 0.018, 0.012), "chrome", 8)
    with d.at(-depth / 2, 0, z, pitch=math.pi / 2):
        d.revolve([(0.8 * r, 0.0), (r, 0.01), (r, depth - 0.008)], look, 32)
    dial = Box.around((depth / 2 - 0.006, 0, z), 0.012, 1.8 * r, 1.8 * r)
    clock_face(d, dial, "cream paint", "black steel")
    d.hoop(dial.inset(y=-0.02 * r, z=-0.02 * r).move(x=-0.003), 0.04 * r, look, "x", steps=24)
    d.bar((0, -w / 2, z), (0, w / 2, z), 0.004, "chrome", 8)


@draws("music_box", "jewelry_box", whole=True)
def lidded_box(d: Drawing) -> None:
    """A small box with a lid that opens, inlaid, with a clasp; a music box has a crank."""
    wood = d.material("box", "walnut, mahogany, cherry, white paint, rose fabric, navy paint, tan leather")
    metal = d.material("clasp", "brass, copper, chrome")
    music = d.category.name == "music_box"
    box = d.bounds.inset(front=0.023, left=0.03 if music else 0.0)
    with d.corners(box, inset=0.01):
        d.cylinder(Box.sized(0.016, 0.016, 0.008), metal, ends=(0.75, 1.0), segments=10)
    case = box.share(z=(0.0, 0.7)).inset(bottom=0.008)
    tub(d, case, wood, 0.007)
    d.box(case.front(-0.002).inset(y=0.02).share(z=(0.15, 0.19)), metal, bevel=0.0)
    if music:
        y, z = box.y[1], 0.4 * box.height
        d.sweep([(0, y - 0.005, z), (0, y + 0.018, z), (0.02, y + 0.018, z + 0.012)], 0.003, metal, 8)
        d.bar((0.02, y + 0.016, z + 0.012), (0.02, y + 0.03, z + 0.012), 0.005, wood)
    lid = box.share(z=(0.7, 1.0)).inset(bottom=0.001)
    y, z = lid.center[1], lid.z[0]
    with d.hinge("lid", lid.anchor("back top"), axis=(0.0, -1.0, 0.0), limits=(0.0, 1.5), role="lid"):
        edge = (1 - 0.024 / lid.depth, 1 - 0.024 / lid.width)
        d.sections(lid.inset(top=0.002), [(1, 1, 0.0), (1, 1, 0.6), (*edge, 1.0)], wood, radius=0.0, convex=True)
        d.box(lid.inset(x=0.03, y=0.03).top(0.006), metal, bevel=0.0)
        tab = Box((box.x[1], box.x[1] + 0.022), (y - 0.01, y + 0.01), (z + 0.003, z + 0.017))
        lip(d, tab, metal, (0.0, 1.0, 0.0), bevel=0.002)
