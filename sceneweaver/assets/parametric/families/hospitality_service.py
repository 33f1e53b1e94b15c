"""Buffets, salad bars, signs, trolleys and beer taps."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import castors, frame, oval, perimeter, walls


def _warmer(d: Drawing, box: Box, metal: Look, power: float) -> None:
    """A chafing dish that fills a box: frame, burners, water pan, and a lid with a grip."""
    low = box.z[0] + 0.168
    with d.corners(box.inset(x=0.007, y=0.012)):
        d.box(Box((0.0, 0.016), (0.0, 0.016), (0.0, 0.12)), metal, 0.0)
    with d.at(*box.anchor("bottom")), d.mirror("y"):
        d.cylinder(Box.sized(0.08, 0.08, 0.05, (0.0, 0.22 * box.width, 0.027)), "copper", segments=14)
    for inset, under, top in ((0.02, 0.148, 0.14), (0.01, 0.068, 0.008), (0.0, 0.013, 0.0)):
        d.box(box.to(z=(low - under, low - top)).inset(x=inset, y=inset), metal)
    lid = box.to(z=(low, box.z[1] - 0.03))
    levels = ((0.96, 0.0), (0.94, 0.35), (0.86, 0.62), (0.72, 0.85), (0.48, 1.0))
    rings = [oval(lid.place(e * lid.depth, e * lid.width), low + s * lid.height, power) for e, s in levels]
    d.loft(rings, metal, convex=True)
    x, y, z = lid.anchor("top")
    d.arch((x, y - 0.05, z - 0.01), (x, y + 0.05, z - 0.01), (0.0, 0.0, 0.034), 0.007, "black plastic")


@draws("buffet_table")
def buffet_table(d: Drawing) -> None:
    """A clothed table with two or three food warmers in a row, and room for plates at both ends and in front."""
    cloth = d.material("cloth", "white fabric, navy fabric, black fabric, red fabric, beige fabric, green fabric")
    metal, white = d.material("warmers", "chrome, brushed steel, brass, steel"), "white fabric"
    cover = d.material("runner", "red fabric, navy fabric, mustard fabric") if cloth.called(white) else white
    top, w = d.bounds.to(z=(0.78, 0.84)), d.size.width
    with d.part("table"):
        steps = np.arange(6 * round((top.depth + w) / 0.055))
        points, out = perimeter(top.inset(x=0.006, y=0.006), 0.03, steps / len(steps))
        wave = (0.5 - 0.5 * np.cos(steps * math.pi / 3))[:, None]
        skirt = [np.c_[points - swing * wave * out, 0 * steps + z] for z, swing in ((0.0, 0.03), (0.81, 0.012))]
        d.add(shapes.lofted(skirt), cloth, [shapes.hull(np.concatenate(skirt))])
        d.slab(top, cover, 0.03, 0.008)
    row = top.inset(y=0.33).to(x=(-0.285, 0.085), z=(top.z[1], d.bounds.z[1]))
    for k, cell in enumerate(row.columns(2 if w < 2.0 else 3)):
        with d.part(f"warmer {k}"):
            dish = cell.place(width=min(0.56, cell.width - 0.06))
            _warmer(d, dish, metal, 2.6 if d.style in ("classic", "rustic") else 5.0)
    with d.part("plates"), d.along((-0.16, top.y[0] + 0.17, top.z[1]), (0.14, top.y[0] + 0.17, top.z[1]), 2):
        d.cylinder(Box.sized(0.26, 0.26, 0.012), "white ceramic", ends=(0.6, 1.0))
        for plate in Box.sized(0.26, 0.26, 0.092, (0.0, 0.0, 0.012)).rows(8, gap=0.0005):
            d.cylinder(plate, "white ceramic", ends=(0.98, 1.0))
    d.surface("front", top.inset(front=0.02, right=0.33, left=0.02).to(x=(0.11, top.x[1] - 0.02)))
    d.surface("end", top.left(0.31).inset(left=0.02).to(x=(top.x[0] + 0.02, 0.105)))
    d.fit()


_FOODS = ["lettuce", "tomato", "carrot", "cheese", "egg shell", "green apple", "aubergine", "bread crust", "grape"]


@draws("salad_bar")
def salad_bar(d: Drawing) -> None:
    """A panelled counter with a cold well of pans under a glass guard on posts, and a tray rail in front."""
    body = d.material("body", "oak, walnut, white paint, sage paint, brushed steel, light oak")
    steel, box, z, middle = "brushed steel", d.bounds.inset(front=0.14), 0.86, -0.07
    with d.part("body"):
        d.box(box.bottom(0.1).inset(x=0.05, y=0.05), "black plastic", 0.0)
        case = d.box(box.to(z=(0.1, z - 0.06)).inset(x=0.01, y=0.01), body, 0.002)
        panels = case.front(-0.008).inset(back=-0.001, y=0.025, z=0.04)
        for panel in panels.columns(max(3, round(box.width / 0.45)), gap=0.03):
            d.box(panel, body, 0.005)
        top = box.to(z=(z - 0.06, z))
        walls(d, top, steel, 0.07, 0.0)
        well = top.inset(x=0.07, y=0.07)
        d.box(well.bottom(0.015), steel, 0.0)
        first, columns = d.integer("first", 0, 8), max(3, round(well.width / 0.34))
        for i, row in enumerate(well.inset(bottom=0.015, top=0.002).split("x", 2)):
            for j, pan in enumerate(row.columns(columns)):
                look = _FOODS[(first + 4 * i + 3 * j) % len(_FOODS)]
                walls(d, pan, steel, 0.005, 0.0)
                food = d.cushion(pan.inset(all=0.005, top=-0.005), look, 0.02, 0.35)
                with d.grid(food.top(0.0), x=2, y=2):
                    d.ball(Box.around((0.0, 0.0, -0.004), 0.06, 0.066, 0.03), look, 6)
    for x in (0.03, 0.078, 0.126):
        d.bar((box.x[1] + x, box.y[0] + 0.02, z - 0.07), (box.x[1] + x, box.y[1] - 0.02, z - 0.07), 0.012, "chrome", 8)
    with d.part("rail"), d.mirror("y"):
        arm = Box((box.x[1] - 0.012, d.bounds.x[1] - 0.014), box.share(y=(0.85, 0.87)).y, (z - 0.2, z - 0.082))
        d.silhouette(arm, [(0.0, 0.0), (1.0, 0.85), (1.0, 1.0), (0.0, 0.85)], steel)
    with d.part("guard"):
        top_z = box.z[1]
        roof = d.box(Box((middle - 0.17, middle + 0.17), box.y, (top_z - 0.03, top_z)), body)
        d.box(roof.bottom(-0.004).inset(top=-0.002, x=0.14, y=0.06), "lamp glow", 0.0)
        with d.at(middle), d.mirror("x"):
            with d.mirror("y"):
                d.bar((0.02, box.y[1] - 0.035, z - 0.01), (0.02, box.y[1] - 0.035, top_z - 0.03), 0.012, "chrome")
            pane = Box((0.155, 0.311), box.inset(y=0.02).y, (top_z - 0.2, top_z - 0.03))
            d.silhouette(pane, [(0.0, 1.0), (0.04, 1.0), (1.0, 0.0), (0.96, 0.0)], "glass")
    d.fit()


@draws("menu_board")
def menu_board(d: Drawing) -> None:
    """Two framed blackboards hinged at their tops, with chalk writing, held apart by chains."""
    wood = d.material("frame", "oak, pine, walnut, beech, black paint, white paint")
    deep, w, h = d.size
    lean, chain = math.atan2(deep / 2 - 0.028, h), 0.35 * h
    half = (h - chain) * math.tan(lean) - 0.004
    leaf = Box((0.0, 0.022), (-w / 2, w / 2), (0.02 - (h - 0.004) / math.cos(lean), 0.0))
    for s in (1, -1):
        with d.part(f"board {s}"), d.at(0.004 * s, 0.0, h - 0.002, yaw=0.0 if s > 0 else math.pi, pitch=-lean):
            inner = frame(d, leaf.inset(bottom=0.08), wood, 0.05)
            for foot in (leaf.left(0.05), leaf.right(0.05)):
                d.box(foot.bottom(0.08), wood)
            page = d.box(inner.inset(front=0.008, back=0.006), "ink pigment", 0.0).front(0.0).inset(y=0.04)
            d.print(page.top(0.085).bottom(0.03).share(y=(0.15, 0.85)), "chalk pigment")
            d.print(page.top(0.108).bottom(0.005).share(y=(0.3, 0.7)), "ochre pigment")
            for k, line in enumerate(page.inset(top=0.15, bottom=0.09).rows(6)):
                text = line.top(0.014)
                d.print(text.share(y=(0.0, 0.28 + 0.2 * d.uniform(f"long {s} {k}", 0.0, 1.0))), "chalk pigment")
                d.print(text.share(y=(0.86, 1.0)), "ochre pigment" if k % 2 else "chalk pigment")
    with d.part("board 1"), d.mirror("y"):
        d.bar((-half, w / 2 - 0.025, chain), (half, w / 2 - 0.025, chain), 0.003, "brass", 6)
    d.clear(Box((-half, half), (-w / 2, w / 2), (0.0, chain)))
    d.fit()


@draws("serving_trolley")
def serving_trolley(d: Drawing) -> None:
    """Two or three trays in a frame of tube, with a push bar and four castors."""
    metal = d.material("frame", "brass, black steel, chrome, copper, white steel")
    look = d.material("trays", "glass, walnut, oak, marble, mirror, black glass")
    box, r = d.bounds, 0.011
    plan = box.inset(x=r, right=r + 0.01, left=r + 0.1)
    (x0, x1), (y0, y1), h, end = plan.x, plan.y, box.z[1], box.y[1] - r
    levels = (0.16, h - 0.12) if h < 0.85 else (0.15, 0.15 + (h - 0.28) / 2, h - 0.13)
    for name, y in (("right", y0), ("left", y1)):
        with d.part(name):
            for x in (x0, x1):
                d.bar((x, y, 0.085), (x, y, levels[-1] + 0.045), r, metal)
                if name == "left":
                    d.sweep([(x, y, levels[-1] + 0.03), (x, y + 0.03, h - 0.03), (x, end, h - r)], r, metal)
            if name == "left":
                d.bar((x0 - r, end, h - r), (x1 + r, end, h - r), r, metal)
    for k, (z, above) in enumerate(zip(levels, [*levels[1:], None], strict=True)):
        with d.part(f"tray {k}"):
            tray = d.box(plan.to(z=(z - 0.012, z)), look, 0.001)
            walls(d, tray.inset(bottom=-0.008, top=0.004), metal, 0.008, 0.0)
            if not k:
                castors(d, box.bottom(0.09).to(x=(x0, x1), y=(y0 - 0.02, y1 + 0.03)), metal)
        for name, x in (("front", x1), ("back", x0)):
            if len(levels) < 3:
                with d.part(f"rail {name} {k}"):
                    d.bar((x, y0, z + 0.04), (x, y1, z + 0.04), 0.005, metal, 6)
        room = None if above is None else round(above - 0.027 - z, 3)
        d.surface(f"shelf-{k}" if room else "top", tray, room, inset=0.02)
    d.fit()


@draws("beer_tap", whole=True)
def beer_tap(d: Drawing) -> None:
    """A column or a bridge with two to four taps and tall handles, and a drip tray below."""
    metal = d.material("tower", "chrome, brass, copper, black steel, brushed steel")
    box = d.bounds
    count = 2 if box.width < 0.38 else 3 if box.width < 0.46 else 4
    x, top, span = box.x[0] + 0.075, box.z[1] - 0.14, 0.085 * (count - 1)
    tray = d.box(box.bottom(0.022).inset(back=0.01), "brushed steel")
    for slat in tray.top(-0.002).inset(bottom=-0.001, back=0.12, front=0.015, y=0.02).columns(9, gap=0.016):
        d.box(slat, "black steel", 0.0)
    columns = ((-span / 2, span / 2) if count > 2 else (0.0,)) if count == 2 or d.chance("bridge", 0.5) else ()
    for y in columns:
        d.cylinder(Box.sized(0.13, 0.13, 0.025, (x, y, 0.02)), metal, ends=(1.0, 0.85))
        d.cylinder(Box.sized(0.081, 0.081, top - 0.04, (x, y, 0.04)), metal)
    if columns:
        bridge = Box.around((x, 0.0, top - 0.01), 0.09, span + 0.1, 0.09)
        d.cylinder(bridge, metal, "y", segments=20)
        for end in ("left", "right"):
            d.ball(Box.around(bridge.anchor(end), 0.09, 0.054, 0.09), metal, 16)
    else:
        d.cylinder(Box.sized(0.17, 0.17, 0.025, (x, 0.0, 0.02)), metal, ends=(1.0, 0.88))
        d.cylinder(Box.sized(0.11, 0.11, top - 0.1, (x, 0.0, 0.04)), metal)
        d.box(Box.around((x, 0.0, top - 0.028), 0.09, span + 0.12, 0.095), metal, 0.012)
    tones, first = ("red", "yellow", "green", "black", "blue", "orange"), d.integer("first", 0, 5)
    for k in range(count):
        y, z = 0.085 * (k - (count - 1) / 2), top - 0.015
        d.bar((x + 0.03, y, z), (x + 0.095, y, z), 0.011, "chrome")
        d.bar((x + 0.085, y, z + 0.012), (x + 0.105, y, z - 0.085), 0.009, "chrome")
        d.cylinder(Box.sized(0.014, 0.014, 0.045, (x + 0.085, y, z)), "chrome", segments=10)
        grip = Box.sized(0.042, 0.042, box.z[1] - z - 0.04, (x + 0.085, y, z + 0.04))
        shape = [(0.52, 0.0), (0.66, 0.18), (1.0, 0.75), (0.86, 0.94), (0.4, 1.0)]
        d.turned(grip, shape, f"{tones[(k + first) % 6]} plastic", 14)
