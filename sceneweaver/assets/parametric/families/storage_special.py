"""Chests, racks for wine, bar furniture, carts, safes and trophies."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import SWING, carcass, castors, cavity, doors, feet, lip, pulls, walls
from ...drawing.components.supports import SHADOW
from ...drawing.drawing import Look
from .bottles import bottle
from .storage_parts import inner_boards

CAPS = ("cork", "black paint", "brass")


@draws("chest")
def chest(d: Drawing) -> None:
    """A blanket chest with a flat lid or a trunk with a round one, bands and handles."""
    wood = d.material("body", "oak", "pine", "walnut", "brown leather", "navy paint", "white paint")
    metal = d.material("fittings", "iron", "brass", "bronze")
    domed = d.chance("domed", 0.5)
    case, top = d.bounds.inset(back=0.004, front=0.012, y=0.018), d.size.height
    rim = top - (0.28 * top if domed else 0.05)
    body = case.to(z=(0.03, rim))
    bands = [case.place(width=0.04).move(y=share * d.size.width).y for share in (-0.3, 0.3)]
    with d.part("body"):
        wall = 0.02
        d.box(body.bottom(wall), wood)
        sides = walls(d, body.inset(bottom=wall, top=0.003), wood, wall)
        if domed:
            d.interior("inside", body.inset(x=wall, y=wall, bottom=wall, top=0.003))
        for y in (case.y[0], case.y[1] - 0.07):
            for x in (case.x[0], case.x[1] - 0.07):
                d.box(Box((x, x + 0.07), (y, y + 0.07), (0.0, 0.03)), wood)
        face = sides.front(-0.006)
        if domed:
            for y in bands:
                d.box(face.to(y=y).back(0.003), metal, bevel=0.0)
        else:
            d.box(body.inset(front=-0.006, y=-0.006).bottom(0.06), wood)
            for cell in face.inset(y=0.05, bottom=0.08, top=0.05).columns(3, gap=0.05):
                d.box(cell, wood)
        d.box(
            body.front(-0.0008 if domed else -0.008).place(width=0.06).top(0.07).inset(top=0.006), metal, bevel=0.0005
        )
        with d.mirror("y"), d.at(0.0, case.y[1], 0.7 * rim, yaw=math.pi / 2):
            d.bar((0.012, -0.06, 0.0), (0.012, 0.06, 0.0), 0.006, metal, 8)
            for y in (-0.055, 0.055):
                d.box(Box.around((0.007, y, 0.0), 0.014, 0.02, 0.024), metal)
        if domed:
            hinge = (d.bounds.x[0], 0.0, top)  # nothing of it goes behind the chest, where a wall is
            with d.hinge("lid", hinge, axis=(0.0, -1.0, 0.0), limits=(0.0, 1.5), role="lid"):
                _dome(d, case.to(z=(rim, top - 0.004)), wood)
                for y in bands:
                    _dome(d, case.inset(x=-0.004).to(y=y, z=(rim, top)), metal)
                lip(d, case.front(-0.025).place(width=0.05).to(z=(rim + 0.012, rim + 0.026)), metal)
        else:
            d.box(d.bounds.inset(back=0.004).top(0.05), wood, bevel=0.008)
    if not domed:
        d.surface("top", d.bounds, inset=0.02)
    d.fit()


def _dome(d: Drawing, box: Box, look: Look) -> None:
    """A lid with a round top along y, which fills a box."""
    arc = np.linspace(0.0, math.pi, 13)
    x, z = box.center[0] + box.depth / 2 * np.cos(arc), box.z[0] + 0.04 + (box.height - 0.04) * np.sin(arc)
    outline = [*zip(x.tolist(), z.tolist(), strict=True), (box.x[0], box.z[0]), (box.x[1], box.z[0])]
    d.hull([(px, y, pz) for px, pz in outline for y in box.y], look)


@draws("safe")
def safe(d: Drawing) -> None:
    """A steel block with a thick door, a dial, and a handle of three spokes."""
    steel = d.material("body", "grey paint", "black paint", "navy paint", "green paint", "light grey paint")
    metal = d.material("handle", "chrome", "brass", "brushed steel")
    case = d.bounds.inset(front=0.055)
    with d.part("body"):
        d.box(case.inset(x=0.03, y=0.03).bottom(0.025), "rubber", bevel=0.0)
        block = case.inset(bottom=0.025)
        room = cavity(d, block, steel, 0.045, 0.008)
        d.box(room.back(0.002).inset(back=-0.001), SHADOW, bevel=0.0)
        leaf = block.inset(y=0.035, z=0.035).front(-0.021).inset(back=0.003)
        with d.hinge("door", leaf.anchor("front right bottom"), limits=(-SWING, 0.0)):
            d.box(leaf, steel, bevel=0.004)
            x, height = leaf.x[1], 0.55 * case.height
            with d.at(x, 0.12 * case.width, height, pitch=math.pi / 2):
                d.revolve([(0.035, 0.0), (0.035, 0.006), (0.024, 0.01), (0.02, 0.026)], metal, 20)
            with d.at(x, -0.14 * case.width, height, pitch=math.pi / 2):
                d.cylinder(Box.sized(0.036, 0.036, 0.026), metal, ends=(1.0, 0.78), segments=14)
                spoke = ("spoke", (0.05, 0.0, 0.022), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0), 0.012, 0.04)
                with d.at(yaw=0.5), d.handle(*spoke), d.ring(3):
                    d.bar((0.0, 0.0, 0.022), (0.07, 0.0, 0.022), 0.006, metal, 8)
            d.box(leaf.front(-0.002).place(width=0.12).top(0.055).bottom(0.03), metal, bevel=0.0)
        for z in (0.12, case.height - 0.14):
            d.cylinder(Box.sized(0.024, 0.024, 0.06, (block.x[1] + 0.012, case.y[0] + 0.022, z)), metal, segments=12)
    d.surface("top", case, inset=0.015)
    d.fit()


@draws("wine_rack")
def wine_rack(d: Drawing) -> None:
    """A case of square pigeonholes with bottles lying in them."""
    wood = d.material("body", "oak", "walnut", "pine", "black paint", "mahogany")
    case, board = d.bounds.inset(front=0.03), 0.012
    with d.part("body"):
        inner = carcass(d, case.inset(bottom=0.03), wood, 0.02, 0.008)
        d.box(case.bottom(0.03).inset(front=0.02, y=0.01), SHADOW, bevel=0.0)
        room = inner.inset(front=0.004)
        columns = max(3, round(room.width / 0.115))
        levels = room.rows(max(3, round(room.height / 0.115)), gap=board)
        for level in levels[1:]:
            d.box(level.bottom(-board), wood, bevel=0.0)
        for cell in room.columns(columns, gap=board)[1:]:
            d.box(cell.right(-board).inset(front=0.002), wood, bevel=0.0)
        left, share = 26, min(0.6, 24 / (columns * len(levels)))
        for j, level in enumerate(levels):
            for k, cell in enumerate(level.columns(columns, gap=board)):
                if left and d.chance(f"bottle {k} {j}", share):
                    left -= 1
                    radius = min(0.037, cell.width / 2 - 0.002, cell.height / 2 - 0.002)
                    glass = d.pick(f"glass {k} {j}", ["green glass", "black glass", "amber glass"])
                    foil = d.pick(f"foil {k} {j}", ["red paint", "brass", "black paint", "navy paint"])
                    x, y, z = cell.anchor("back bottom")
                    with d.at(x + 0.004, y, z + radius + 0.001, pitch=math.pi / 2):
                        bottle(d, radius, d.bounds.x[1] - x - 0.006, glass, foil)
    d.surface("top", case, inset=0.01)
    d.fit()


def _spirits(d: Drawing, row: Box, count: int, chance: float) -> None:
    """Bottles of spirits side by side on the floor of a box."""
    for k, place in enumerate(row.columns(count)):
        if d.chance(f"bottle {k}", chance):
            glass = d.pick(f"spirit {k}", ["amber glass", "green glass", "glass", "black glass"])
            with d.at(*place.anchor("bottom")):
                radius, height = d.uniform(f"girth {k}", 0.03, 0.038), d.uniform(f"high {k}", 0.25, 0.31)
                bottle(d, radius, height, glass, d.pick(f"cap {k}", CAPS), label=True)


@draws("bar_cabinet")
def bar_cabinet(d: Drawing) -> None:
    """Two doors below, an open niche with bottles before a mirror above."""
    wood = d.material("body", "walnut", "mahogany", "oak", "black paint", "navy paint")
    style, pull, reach = pulls(d, wood, "knob", "bar")
    case, board = d.bounds.inset(front=reach), 0.018
    niche = case.top(0.44).inset(top=0.02)
    panel = "rattan" if d.style in ("scandinavian", "rustic") else wood
    with d.part("body"):
        feet(d, case.bottom(0.14), wood, d.pick("base", ["tapered", "square", "splayed"]))
        room = carcass(d, case.to(z=(0.14, niche.z[0])), wood)
        inner_boards(d, room, 1, wood)
        doors(d, room.front(board), 2, wood, pull, style, panel, grip=0.7)
    for k, side in enumerate((niche.right(board), niche.left(board))):
        with d.part(f"side-{k}"):
            d.box(side, wood)
    inner = niche.inset(y=board)
    with d.part("back"):
        d.box(inner.back(0.006), wood, bevel=0.0)
        d.box(inner.inset(back=0.006).back(0.004), "mirror", bevel=0.0)
        _spirits(d, inner.inset(back=0.02).back(0.08), max(3, int(inner.width / 0.12)), 0.75)
    with d.part("top"):
        d.box(case.top(0.02), wood, bevel=0.004)
    d.surface("counter", inner.inset(back=0.12, front=0.01, y=0.005).bottom(0.0), niche.height - 0.005)
    d.surface("top", case, inset=0.01)


@draws("bar_cart")
def bar_cart(d: Drawing) -> None:
    """Two trays in a round-tube frame with a handle at each end, on castors."""
    metal = d.material("frame", "brass", "black steel", "chrome", "copper")
    look = d.material("trays", "glass", "walnut", "dark marble", "marble", "oak")
    radius, bounds = 0.009, d.bounds
    x, y, top = bounds.depth / 2 - radius, bounds.width / 2 - 0.05, bounds.z[1]
    for k, side in enumerate((-1, 1)):
        with d.part(f"frame-{k}"):
            base = Box((-x - 0.012, x + 0.012), (side * y - 0.024, side * y + 0.024), (0.0, 0.072))
            for end in (base.front(0.048), base.back(0.048)):
                with d.at(*end.anchor("bottom")):
                    _castor(d, metal)
            for end in (-x, x):
                d.bar((end, side * y, 0.06), (end, side * y, top - 0.05), radius, metal)
            high = (side * (y + 0.041), top - radius)
            d.sweep([(-x, side * y, top - 0.05), (-x, *high), (x, *high), (x, side * y, top - 0.05)], radius, metal)
    levels = (0.2, top - 0.16)
    for k, z in enumerate(levels):
        tray = Box((-x, x), (-y, y), (z - 0.012, z))
        with d.part(f"tray-{k}"):
            d.box(tray, look)
        with d.part(f"rail-{k}"):
            d.bar((-x, -y, z + 0.05), (-x, y, z + 0.05), 0.005, metal, 8)
            if k == 0:
                shelf = tray.top(-0.1).inset(back=0.02, right=0.04).back(0.08)
                count = d.integer("bottles", 2, 4)
                _spirits(d, shelf.right(0.1 * count), count, 1.0)
        free = tray.inset(back=0.02 if k else 0.11, front=0.015, y=0.02)
        d.surface("top" if k else "shelf-0", free, None if k else round(levels[1] - 0.016 - z, 4))
    d.fit()


def _castor(d: Drawing, metal: Look) -> None:
    """A small wheel under the frame's origin."""
    d.cylinder(Box.around((0.0, 0.0, 0.03), 0.06, 0.022, 0.06), "black plastic", "y", segments=16)
    d.box(Box.sized(0.024, 0.032, 0.042, (0.0, 0.0, 0.03)), metal, bevel=0.001)


@draws("storage_cart")
def storage_cart(d: Drawing) -> None:
    """Three trays with rims between four posts, on castors."""
    names = ("white steel", "black steel", "teal paint", "grey paint", "yellow paint", "blue paint")
    steel = d.material("frame", *names)
    post, lip, thin, bounds = 0.016, 0.045, 0.003, d.bounds
    for k, side in enumerate((bounds.right(post), bounds.left(post))):
        with d.part(f"side-{k}"):
            for own in (side.back(post), side.front(post)):
                d.box(own.inset(bottom=0.06, top=0.01), steel)
            d.box(side.top(post), steel)
    with d.part("tray-0"):
        castors(d, bounds.bottom(0.07).inset(x=0.004, y=0.004), steel)
    inner = bounds.inset(x=0.004, y=post)
    levels = np.linspace(0.1, bounds.z[1] - 0.1, 3).tolist()
    for k, z in enumerate(levels):
        with d.part(f"tray-{k}"):
            tray = d.box(inner.to(z=(z - thin, z)), steel, bevel=0.0)
        rim = tray.top(-lip)
        for name, wall in (("rims-front", rim.front(thin)), ("rims-back", rim.back(thin))):
            with d.part(name):
                d.box(wall, steel, bevel=0.0)
        for name, wall in (("side-0", rim.right(thin)), ("side-1", rim.left(thin))):
            with d.part(name):
                d.box(wall.inset(x=thin, bottom=-thin), steel, bevel=0.0)
        room = None if k == 2 else round(levels[k + 1] - z - thin - 0.004, 4)
        d.surface("top" if k == 2 else f"shelf-{k}", tray.inset(x=0.01, y=0.009), room)


@draws("trophy_case")
def trophy_case(d: Drawing) -> None:
    """A wide glass case on a wooden foot with cups on its boards."""
    wood = d.material("body", "oak", "walnut", "mahogany", "black paint")
    case, rim = d.bounds.inset(front=0.025), 0.03
    glazed = case.inset(bottom=0.45, top=0.08)
    with d.part("case"):
        d.box(case.inset(back=0.01, front=0.03, y=0.02).bottom(0.07), SHADOW, bevel=0.0)
        foot = d.box(case.to(z=(0.07, 0.45)), wood)
        for cell in foot.inset(y=0.05, bottom=0.06, top=0.05).columns(3, gap=0.05):
            d.box(cell.front(-0.006), wood)
        d.box(case.top(0.08), wood)
        d.box(glazed.back(0.008), wood, bevel=0.0)
        for side in (glazed.left(rim), glazed.right(rim)):
            d.box(side.inset(front=0.02).front(rim - 0.02), wood, bevel=0.001)
            d.box(side.inset(back=0.008, front=rim).place(width=0.006), "glass", bevel=0.0)
        room = glazed.inset(back=0.008, front=rim, y=rim)
        levels = room.rows(2, gap=0.008)
        d.box(levels[1].bottom(-0.008), "glass", bevel=0.0)
        for j, level in enumerate(levels):
            for k, cell in enumerate(level.columns(max(3, round(case.width / 0.36)))):
                with d.at(*cell.anchor("bottom")):
                    _trophy(d, min(0.85 * level.height, 0.42), f"{j} {k}")
        doors(d, glazed.front(0.02), 2, wood, "brass", "knob", "glass")
    d.surface("top", case, inset=0.01)
    d.fit()


def _trophy(d: Drawing, most: float, name: str) -> None:
    """A metal cup on a dark foot."""
    height = most * d.uniform(f"high {name}", 0.55, 1.0)
    metal = d.pick(f"metal {name}", ["brass", "chrome", "bronze"])
    radius = min(0.07, 0.26 * height)
    d.cylinder(Box.sized(1.6 * radius, 1.6 * radius, 0.15 * height), "black paint", ends=(1.0, 0.87), segments=14)
    cup = Box.sized(2 * radius, 2 * radius, 0.85 * height, (0.0, 0.0, 0.15 * height))
    d.turned(cup, ((0.5, 0.0), (0.18, 0.11), (0.2, 0.3), (0.75, 0.47), (1.0, 1.0)), metal, 16)
