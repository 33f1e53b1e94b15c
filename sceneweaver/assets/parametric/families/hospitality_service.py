"""Buffets, salad bars, signs, trolleys and beer taps."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import castors, oval, perimeter


def _warmer(d: Drawing, box: Box, metal: Look, power: float) -> None:
    """A chafing dish that fills a box: frame, burners, water pan, and a lid with a grip."""
    frame = box.inset(x=0.007, y=0.012)
    with d.corners(frame):
        d.box(Box((0.0, 0.016), (0.0, 0.016), (0.0, 0.12)), metal, 0.0)
    d.box(frame.bottom(0.028).inset(x=0.013, y=0.008, bottom=0.02), metal, 0.0)
    with d.at(*box.anchor("bottom")), d.mirror("y"):
        d.cylinder(Box.sized(0.08, 0.08, 0.05, (0.0, 0.22 * box.width, 0.027)), "copper", segments=14)
    low = box.z[0] + 0.168
    d.box(box.to(z=(low - 0.068, low - 0.008)).inset(x=0.01, y=0.012), metal, 0.006)
    d.box(box.to(z=(low - 0.013, low)), metal)
    lid = box.to(z=(low, box.z[1] - 0.03))
    levels = ((0.02, 0.0), (0.03, 0.35), (0.07, 0.62), (0.14, 0.85), (0.26, 1.0))
    rings = [oval(lid.inset(x=e * lid.depth, y=e * lid.width), low + s * lid.height, power) for e, s in levels]
    d.loft(rings, metal, convex=True)
    x, y, z = lid.anchor("top")
    d.arch((x, y - 0.05, z - 0.01), (x, y + 0.05, z - 0.01), (0.0, 0.0, 0.034), 0.007, "black plastic")


@draws("buffet_table")
def buffet_table(d: Drawing) -> None:
    """A clothed table with two or three food warmers in a row, and room for plates at both ends and in front."""
    cloth = d.material("cloth", "white fabric, navy fabric, black fabric, red fabric, beige fabric, green fabric")
    metal = d.material("warmers", "chrome, brushed steel, brass, steel")
    top, w = d.bounds.to(z=(0.78, 0.84)), d.size.width
    with d.part("table"):
        folds = round((top.depth + w) / 0.055)
        points, out = perimeter(top.inset(x=0.006, y=0.006), 0.03, np.arange(6 * folds) / (6 * folds))
        wave = 0.5 - 0.5 * np.cos(np.arange(6 * folds) * math.pi / 3)
        skirt = [
            np.c_[points - out * (swing * wave)[:, None], 0 * wave + z]
            for z, swing in ((0.0, 0.03), (top.z[0] + 0.03, 0.012))
        ]
        d.add(shapes.lofted(skirt), cloth, [shapes.hull(np.concatenate(skirt))])
        cover = (
            d.material("runner", "red fabric, navy fabric, mustard fabric")
            if cloth.name == "white fabric"
            else "white fabric"
        )
        d.slab(top, cover, 0.03, 0.008)
    count = 2 if w < 2.0 else 3
    row = top.inset(y=0.33).to(x=(-0.285, 0.085), z=(top.z[1], d.bounds.z[1]))
    for k, cell in enumerate(row.columns(count)):
        with d.part(f"warmer {k}"):
            dish = cell.place(width=min(0.56, cell.width - 0.06))
            _warmer(d, dish, metal, 2.6 if d.style in ("classic", "rustic") else 5.0)
    with d.part("plates"), d.along((-0.16, top.y[0] + 0.17, top.z[1]), (0.14, top.y[0] + 0.17, top.z[1]), 2):
        d.cylinder(Box.sized(0.26, 0.26, 0.012), "white ceramic", ends=(0.6, 1.0))
        for k in range(1, 9):
            d.cylinder(Box.sized(0.26, 0.26, 0.011, (0.0, 0.0, 0.0005 + 0.0115 * k)), "white ceramic", ends=(0.98, 1.0))
    d.surface("front", top.inset(front=0.02, right=0.33, left=0.02).to(x=(0.11, top.x[1] - 0.02)))
    d.surface("end", top.left(0.31).inset(left=0.02).to(x=(top.x[0] + 0.02, 0.105)))
    d.fit()


_FOODS = ["lettuce", "tomato", "carrot", "cheese", "egg shell", "green apple", "aubergine", "bread crust", "grape"]


@draws("salad_bar")
def salad_bar(d: Drawing) -> None:
    """A panelled counter with a cold well of pans under a glass guard on posts, and a tray rail in front."""
    body = d.material("body", "oak, walnut, white paint, sage paint, brushed steel, light oak")
    steel, box = "brushed steel", d.bounds.inset(front=0.14)
    z = 0.86
    case = box.to(z=(0.1, z - 0.06)).inset(x=0.01, y=0.01)
    with d.part("body"):
        d.box(box.bottom(0.1).inset(x=0.05, y=0.05), "black plastic", 0.0)
        d.box(case, body, 0.002)
        panels = case.front(-0.008).inset(back=-0.001, y=0.025, bottom=0.04, top=0.04)
        for panel in panels.columns(max(3, round(box.width / 0.45)), gap=0.03):
            d.box(panel, body, 0.005)
        deck = box.to(z=(z - 0.06, z))
        well = deck.inset(x=0.07, y=0.07)
        ends = deck.inset(x=0.07)
        for rim in (deck.front(0.07), deck.back(0.07), ends.left(0.07), ends.right(0.07)):
            d.box(rim, steel, 0.0)
        d.box(well.bottom(0.015), steel, 0.0)
        first, columns = d.integer("first", 0, 8), max(3, round(well.width / 0.34))
        for i, row in enumerate(well.inset(bottom=0.015, top=0.002).split("x", 2)):
            for j, pan in enumerate(row.columns(columns)):
                look = _FOODS[(first + 4 * i + 3 * j) % len(_FOODS)]
                d.box(pan.right(0.008), steel, 0.0)
                d.box(pan.back(0.008).inset(right=0.008), steel, 0.0)
                food = d.cushion(pan.inset(all=0.004, back=0.006, right=0.006), look, 0.02, 0.35)
                with d.grid(food.top(0.0), x=2, y=2):
                    d.ball(Box.around((0.0, 0.0, -0.004), 0.06, 0.066, 0.03), look, 6)
    for k in range(3):
        x = box.x[1] + 0.03 + 0.048 * k
        d.bar((x, box.y[0] + 0.02, z - 0.07), (x, box.y[1] - 0.02, z - 0.07), 0.012, "chrome", 8)
    with d.part("rail"), d.mirror("y"):
        x, tip = box.x[1] - 0.012, d.bounds.x[1] - 0.014
        outline = ((x, z - 0.1), (x, z - 0.2), (tip, z - 0.082), (tip, z - 0.1))
        d.hull([(px, 0.36 * box.width + o, v) for px, v in outline for o in (-0.012, 0.012)], steel)
    with d.part("guard"):
        middle, top = box.center[0], box.z[1]
        with d.at(middle), d.mirror("x", "y"):
            d.bar((0.02, box.y[1] - 0.035, z - 0.01), (0.02, box.y[1] - 0.035, top - 0.03), 0.012, "chrome")
        roof = d.box(Box((middle - 0.17, middle + 0.17), box.y, (top - 0.03, top)), body)
        d.box(roof.bottom(-0.004).inset(top=-0.002, x=0.14, y=0.06), "lamp glow", 0.0)
        with d.at(middle), d.mirror("x"):
            pane = ((0.155, top - 0.03), (0.161, top - 0.03), (0.305, top - 0.2), (0.311, top - 0.2))
            d.hull([(px, y, v) for px, v in pane for y in box.inset(y=0.02).y], "glass")
    d.fit()


@draws("menu_board")
def menu_board(d: Drawing) -> None:
    """Two framed blackboards hinged at their tops, with chalk writing, held apart by chains."""
    wood = d.material("frame", "oak, pine, walnut, beech, black paint, white paint")
    deep, w, h = d.size
    lean = math.atan2(deep / 2 - 0.028, h)
    long = (h - 0.004) / math.cos(lean) - 0.02
    chain = 0.35 * h
    half = (h - chain) * math.tan(lean) - 0.004
    for s in (1, -1):
        with d.part(f"board {s}"):
            with d.at(0.004 * s, 0.0, h - 0.002, yaw=0.0 if s > 0 else math.pi, pitch=-lean):
                leaf = Box((0.0, 0.022), (-w / 2, w / 2), (-long, 0.0))
                for rail in (leaf.top(0.06), leaf.bottom(0.13).inset(bottom=0.08)):
                    d.box(rail, wood)
                for stile in (leaf.left(0.05), leaf.right(0.05)):
                    d.box(stile.inset(top=0.06), wood)
                slate = d.box(leaf.inset(y=0.05, top=0.06, bottom=0.13, front=0.008, back=0.006), "ink pigment", 0.0)
                page = slate.front(0.0).inset(y=0.04)
                d.print(page.top(0.085).bottom(0.03).share(y=(0.15, 0.85)), "chalk pigment")
                d.print(page.top(0.108).bottom(0.005).share(y=(0.3, 0.7)), "ochre pigment")
                for k, line in enumerate(page.inset(top=0.15, bottom=0.09).rows(6)):
                    text = line.top(0.014)
                    d.print(text.share(y=(0.0, 0.28 + 0.2 * d.uniform(f"long {s} {k}", 0.0, 1.0))), "chalk pigment")
                    d.print(text.share(y=(0.86, 1.0)), "ochre pigment" if k % 2 else "chalk pigment")
                cup = page.bottom(0.075).inset(bottom=0.03).place(width=0.05)
                d.print(cup, "chalk pigment")
            if s > 0:
                with d.mirror("y"):
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
    (x0, x1), (y0, y1), h = plan.x, plan.y, box.z[1]
    levels = (0.16, h - 0.12) if h < 0.85 else (0.15, 0.15 + (h - 0.28) / 2, h - 0.13)
    for name, y in (("right", y0), ("left", y1)):
        with d.part(name):
            for x in (x0, x1):
                d.bar((x, y, 0.085), (x, y, levels[-1] + 0.045), r, metal)
                if y == y1:
                    push = [(x, y, levels[-1] + 0.03), (x, y + 0.03, h - 0.03), (x, box.y[1] - r, h - r)]
                    d.sweep(push, r, metal)
            if y == y1:
                d.bar((x0 - r, box.y[1] - r, h - r), (x1 + r, box.y[1] - r, h - r), r, metal)
    for k, z in enumerate(levels):
        tray = plan.to(z=(z - 0.012, z))
        with d.part(f"tray {k}"):
            d.box(tray, look, 0.001)
            frame = tray.inset(bottom=-0.008, top=0.004)
            for side in (frame.front(0.008), frame.back(0.008), frame.left(0.008), frame.right(0.008)):
                d.box(side, metal, 0.0)
            if not k:
                castors(d, box.bottom(0.09).to(x=(x0 - 0.03, x1 + 0.03), y=(y0 - 0.02, y1 + 0.03)).inset(x=0.03), metal)
        if len(levels) < 3:
            for name, x in (("front", x1), ("back", x0)):
                with d.part(f"rail {name} {k}"):
                    d.bar((x, y0, z + 0.04), (x, y1, z + 0.04), 0.005, metal, 6)
        last = k == len(levels) - 1
        d.surface(
            "top" if last else f"shelf-{k}", tray, None if last else round(levels[k + 1] - 0.027 - z, 3), inset=0.02
        )
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
        d.turned(
            grip,
            [(0.52, 0.0), (0.66, 0.18), (1.0, 0.75), (0.86, 0.94), (0.4, 1.0)],
            f"{tones[(k + first) % 6]} plastic",
            14,
        )
