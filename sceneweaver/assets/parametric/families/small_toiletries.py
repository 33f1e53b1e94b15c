"""What stands in a bathroom or on a dressing table."""

from __future__ import annotations

import math
from contextlib import nullcontext

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import towel
from .small_parts import CERAMICS, PLASTICS, open_vessel, pump, spread, wrap

TOWELS = "white fabric, beige fabric, grey fabric, blue fabric, green fabric, rose fabric, navy fabric, mustard fabric"
HEMS = "white fabric, charcoal fabric, beige fabric"


@draws("toothbrush_cup", whole=True, even="round")
def toothbrush_cup(d: Drawing) -> None:
    """A cup with two toothbrushes and a tube of toothpaste."""
    box = d.even("round")
    cup = box.share((0.06, 0.94), (0.06, 0.94), (0.0, 0.55))
    look = d.material("body", CERAMICS, "glass, bamboo")
    open_vessel(d, cup, [(0.88, 0.0), (0.92, 0.04), (1.0, 1.0)], look, holds=False)
    r, h = cup.width / 2, box.height
    for k, s in enumerate((1, -1)):
        look = d.pick(f"brush {k}", ["blue plastic", "red plastic", "green plastic", "bamboo", "pink plastic"])
        with d.at(-0.4 * r, 0.3 * s * r, 0.008, yaw=-0.5 * s, pitch=0.16 + 0.05 * k):
            stick = Box.sized(0.006, 0.009, (0.98 - 0.04 * k) * h - 0.006)
            d.sections(stick, [(1, 1, 0.0), (1, 1, 0.5), (0.6, 0.5, 0.8), (1, 1.1, 0.86), (0.8, 1, 1.0)], look)
            d.box(stick.front(-0.009).inset(top=0.003).top(0.025), "paper", bevel=0.001)
    with d.at(-0.1 * r, -0.1 * r, 0.012, yaw=2.6, pitch=0.14):
        tube(d, 0.8 * h, 0.3 * r, "white plastic", "blue plastic")


def tube(d: Drawing, long: float, r: float, look: Look, cap: Look) -> None:
    """A tube up along z, flat at its closed end, its cap on top."""
    box = Box.sized(2 * r, 2.3 * r, long)
    d.sections(box, [(0.1, 1.0, 0.0), (0.9, 0.92, 0.8), (0.5, 0.45, 0.88)], look)
    d.cylinder(box.share(z=(0.87, 1.0)).place(1.24 * r, 1.24 * r), cap, ends=(1.0, 0.9), segments=16)


@draws("toothpaste", whole=True)
def toothpaste(d: Drawing) -> None:
    """A lying tube of toothpaste with bands and a cap."""
    look = d.material("body", "white plastic, mint plastic, blue plastic")
    cap = d.material("cap", "red plastic, blue plastic, green plastic, white plastic")
    box, r = d.bounds, d.bounds.height / 2
    rings = []
    for x in (-0.5, -0.24, -0.12, -0.04, 0.08, 0.3):  # from its flat end to where it is round
        t = (x + 0.5) / 0.8
        ring = shapes.ellipse((1 - t) * box.width / 2 + t * r, (1 - t) * 0.001 + t * r, 0.0, 16)
        rings.append(np.c_[np.full(16, x * box.depth), ring[:, 0], ring[:, 1] - ring[:, 1].min()])
    bands = (look, "red plastic", look, "blue plastic", look)
    for low, high, color in zip(rings[:-1], rings[1:], bands, strict=True):
        d.loft([low, high], color, convex=True)
    with d.at(0.3 * box.depth, 0.0, r, pitch=math.pi / 2):
        d.cylinder(Box.sized(2 * r, 2 * r, 0.06 * box.depth), look, ends=(1.0, 0.6), segments=16)
        d.cylinder(Box.sized(1.5 * r, 1.5 * r, 0.2 * box.depth), cap, ends=(1.0, 0.88), segments=16)


@draws("tissue_box", whole=True)
def tissue_box(d: Drawing) -> None:
    """A box of tissues, one of them sticking out in folds."""
    names = "sky pigment, blush pigment, sage paint, sand pigment, oak, white paint, bamboo, navy paint"
    look = d.material("body", names)
    box = d.box(d.bounds.share(z=(0.0, 0.58)), look, bevel=0.0015)
    dots = "sky pigment" if look.called("white paint") else "chalk pigment"
    with d.no_colliders():
        d.cylinder(Box.around(box.anchor("top"), 0.44 * box.depth, 0.66 * box.width, 0.0006), "charcoal fabric")
        for k, cell in enumerate(box.front(-0.0003).share(y=(0.02, 0.98)).columns(6)):
            at = (cell.center[0], cell.center[1], (0.3 + 0.35 * (k % 2)) * box.height)
            d.cylinder(Box.around(at, 0.0006, 0.1 * box.width, 0.1 * box.width), dots, "x", segments=12)
    long = d.bounds.height - box.height
    t = np.linspace(-1.0, 1.0, 9)
    rows = []
    levels = ((-0.05, 0.2, 0.006, 0.0), (0.4, 0.17, 0.014, 0.1), (0.8, 0.22, 0.02, 0.3), (1.0, 0.2, 0.014, 0.5))
    for z, width, depth, lean in levels:
        x = lean * 0.4 * long + depth * np.sin(2.2 * np.pi * t)
        tip = box.z[1] + z * long - (0.25 * long * np.abs(t - 0.2) if z == 1.0 else 0.0)
        rows.append(np.c_[x, width * box.width * t, tip + 0 * t])
    d.sheet(np.array(rows), 0.0015, "paper", (3, 2))


def paper_roll(d: Drawing, box: Box) -> None:
    """A standing toilet roll with its core of cardboard."""
    edge, deep = 0.003 / box.height, 1 - 0.02 / box.height
    outside = [(0.98, 0.0), (1.0, edge), (1.0, 1 - edge), (0.98, 1.0)]
    d.turned(box, [*outside, (0.42, 1.0), (0.42, deep), (0.0, deep)], "paper", hollow=True)
    with d.no_colliders():
        core = [(0.42, deep - 0.01), (0.42, 1.0), (0.36, 1.0), (0.36, deep + 0.01), (0.0, deep + 0.01)]
        d.turned(box, core, "cardboard", hollow=True)


@draws("folded_towel", whole=True)
def folded_towel(d: Drawing) -> None:
    """A folded towel with a woven stripe."""
    towel(d, d.bounds, d.material("cloth", TOWELS), d.material("hem", HEMS))


@draws("towel_stack", whole=True)
def towel_stack(d: Drawing) -> None:
    """Folded towels on each other in matching colours."""
    cloths = (d.material("cloth", TOWELS), d.material("second", TOWELS))
    hem = d.material("hem", HEMS)
    layers = d.bounds.rows(max(2, round(d.bounds.height / 0.06)))
    for k, own in enumerate(layers):
        less = 0.012 * (k == len(layers) - 1) + d.uniform(f"e{k}", 0.0, 0.006) * (k > 0)
        with d.item(f"towel-{k}", "folded_towel") if k else nullcontext(), d.convex():
            towel(d, own.inset(x=less, y=2 * less), cloths[k % 2], hem)


@draws("towel_roll", whole=True)
def towel_roll(d: Drawing) -> None:
    """Three rolled towels, one on two, their spirals to the front."""
    cloths = [d.material("cloth", TOWELS), *(d.pick(role, TOWELS.split(", ")) for role in ("second", "third"))]
    box, r = d.bounds, 0.29 * d.bounds.height
    own = box.place(width=2.04 * r, height=2 * r, at="bottom")
    places = (own.move(y=box.y[0] - own.y[0]), own.move(y=box.y[1] - own.y[1]), own.move(z=box.height - 2 * r))
    turns = np.linspace(0, 6 * np.pi, 49)
    for k, (roll, cloth) in enumerate(zip(places, cloths, strict=True)):
        roll = d.cylinder(roll.inset(x=0.01 * k), cloth, "x", bevel=0.15 * r, segments=20)
        x, y, z = roll.anchor("front")
        radius = (0.12 + 0.7 * turns / turns[-1]) * r
        with d.no_colliders():
            spiral = np.c_[np.full(49, x - 0.0008), y + radius * np.cos(turns), z + radius * np.sin(turns)]
            d.sweep(spiral, 0.0012, "charcoal fabric", 4)
    d.box(box.share((0.3, 0.7), (0.25, 0.75), (0.01, 0.25)), cloths[0])


@draws("hairbrush", whole=True)
def hairbrush(d: Drawing) -> None:
    """A brush with a cushion of bristles up."""
    look = d.material("body", "beech, walnut, black plastic, pink plastic, bamboo")
    box = d.bounds
    head, body = box.share(x=(0.0, 0.56)), box.share(z=(0.0, 0.45))
    d.turned(head, [(0.9, 0.0), (1.0, 0.12), (1.0, 0.32), (0.9, 0.45)], look, 20)
    d.turned(head, [(0.82, 0.45), (0.6, 0.56)], "black plastic", 18)
    x0, half = head.center[0], (head.depth / 2, head.width / 2)
    with d.no_colliders():
        for x, y in spread(30, 0.68):
            high = (1 - 0.1 * (x * x + y * y)) * box.height
            bristle = Box.sized(0.002, 0.002, 0.55 * high, (x0 + x * half[0], y * half[1], 0.45 * high))
            d.box(bristle, "steel", bevel=0.0)
    points, faces = shapes.lathe([(0.82, 0.45 * box.height), (0.76, box.height)], 14)
    middle = Box.sized(0.002, 0.002, box.height, (x0, 0.0, 0.0))
    d.add(shapes.box(middle.x, middle.y, middle.z), "steel", [(points * (*half, 1.0) + (x0, 0.0, 0.0), faces)])
    neck = ((0.48, 0.3), (0.56, 0.13), (0.8, 0.15))
    ends = [body.share(x=(x, x)).anchor(level) for x, _ in neck for level in ("bottom", "top")]
    widths = [y for _, y in neck for _ in range(2)]
    d.hull([(x, s * y * box.width, z) for (x, _, z), y in zip(ends, widths, strict=True) for s in (-1, 1)], look)
    d.cushion(body.share((0.7, 1.0), (0.34, 0.66), (0.05, 0.95)), look, 0.4 * body.height)


@draws("makeup_set", whole=True)
def makeup_set(d: Drawing) -> None:
    """A tray with lipsticks, a palette of powders, nail polish and brushes in a cup."""
    tray = d.material("tray", "marble, brass, white ceramic, mirror, oak")
    depth, width, h = d.bounds.size
    d.slab(d.bounds.bottom(0.01), tray, 0.02, 0.002, 4)
    for k, look in enumerate(("red plastic", "pink plastic", "plum pigment")):
        own = Box.sized(0.018, 0.018, 0.7 * h, ((0.3 - 0.06 * (k % 2)) * depth, (-0.42 + 0.09 * k) * width, 0.01))
        d.turned(own, [(1.0, 0.0), (1.0, 0.45), (0.82, 0.46), (0.82, 0.66)], "black plastic" if k < 2 else "brass", 14)
        d.turned(own, [(0.68, 0.64), (0.68, 0.86), (0.4, 0.94), (0.1, 1.0)], look, 12)
    with d.at(0.2 * depth, 0.22 * width, 0.01):
        case = d.box(Box.sized(0.08, 0.1, 0.009), "black plastic", bevel=0.001)
        powders = ("blush pigment", "sand pigment", "plum pigment", "terracotta pigment", "pink icing", "bark")
        rows = case.top(0.0).inset(x=0.005, y=0.005).split("x", 2, 0.004)
        cells = [pan for row in rows for pan in row.columns(3, 0.004)]
        for pan, look in zip(cells, powders, strict=True):
            d.print(pan, look)
        with d.at(-0.04, 0.0, 0.009, pitch=-0.35):
            lid = d.box(Box((-0.006, 0.0), (-0.05, 0.05), (0.0, 0.075)), "black plastic", bevel=0.001)
            d.print(lid.front(0.0).inset(y=0.005, z=0.005), "mirror")
    for k, look in enumerate(("red plastic", "pink plastic")):
        own = Box.sized(0.026, 0.026, 0.062, (-0.05 * depth + 0.02 * k, (-0.32 + 0.12 * k) * width, 0.01))
        d.turned(own, [(0.92, 0.0), (1.0, 0.4), (0.46, 0.48)], look, 14)
        d.turned(own, [(0.5, 0.48), (0.35, 1.0)], "black plastic", 12)
    with d.at(-0.28 * depth, -0.22 * width, 0.01):
        cup = Box.sized(0.06, 0.06, 0.5 * h)
        open_vessel(
            d, cup, [(0.93, 0.0), (1.0, 1.0)], d.pick("cup", ["glass", "white ceramic", "brass"]), 0.002, holds=False
        )
        for k in range(4):
            long = (0.95 - 0.05 * k) * h
            with d.at(yaw=1.57 * k + 0.4), d.at(-0.01, 0.0, 0.03 * h, pitch=0.2):
                stick = d.pick(f"stick {k}", ["black plastic", "beech", "brass"])
                d.bar((0, 0, 0), (0, 0, long - 0.03), 0.0028, stick, 8)
                tip = Box.sized(0.018, 0.018, 0.034, (0, 0, long - 0.034))
                d.turned(tip, [(0.45, 0.0), (1.0, 0.6), (0.45, 1.0)], "bark" if k % 2 else "blush pigment", 10)


@draws("sponge", whole=True)
def sponge(d: Drawing) -> None:
    """A sponge full of holes with a rough side."""
    look = d.material("body", "foam, pink icing, sky pigment, foam")
    body = d.cushion(d.bounds.share(z=(0.0, 0.74)), look, radius=0.006)
    pad = d.pick("pad", ["dark leaf", "green fabric", "navy fabric"])
    d.slab(d.bounds.share(z=(0.72, 1.0)).inset(x=0.0005, y=0.0005), pad, 0.006)
    hole = "ochre pigment" if look.called("foam") else "grey paint"
    with d.no_colliders():
        for k in range(28):
            side = (body.front(0.0), body.left(0.0))[k % 2]
            u, v = d.uniform(f"x{k}", 0.1, 0.9), d.uniform(f"z{k}", 0.36, 0.7)
            size = d.uniform(f"s{k}", 0.002, 0.004)
            at = side.share((u, u), (u, u), (v, v)).center
            d.ball(Box.around(at, min(side.depth, size), min(side.width, size), size).inset(-0.0002), hole, 6)


@draws("soap_dispenser", "lotion_bottle", whole=True, even="round")
def pump_bottle(d: Drawing) -> None:
    """A round or square bottle with a pump and a label."""
    box = d.even("round")
    soap = d.category.name == "soap_dispenser"
    look = d.material("body", CERAMICS + ", concrete, marble" if soap else PLASTICS, "amber glass")
    head = d.material("pump", "steel, brass, black steel, chrome" if soap else "white plastic, black plastic, steel")
    bottle = box.share(z=(0.0, 0.68))
    paper = d.pick("label", ["paper", "sand pigment", "white paint" if soap else "blush pigment"])
    if soap and d.chance("square", 0.3):
        rows = [(0.94, 0.94, 0.0), (1.0, 1.0, 0.03), (1.0, 1.0, 0.9), (0.5, 0.5, 1.0)]
        d.sections(bottle, rows, look, radius=0.12, convex=True)
        d.print(bottle.front(0.0).share(y=(0.25, 0.75), z=(0.3, 0.65)), paper)
        d.print(bottle.front(0.0).share(y=(0.32, 0.68), z=(0.5, 0.54)), "ink pigment", 0.0004)
    else:
        body = [(0.92, 0.0), (1.0, 0.03), (1.0, 0.84), (0.8, 0.94), (0.42, 1.0)]
        d.turned(bottle, body, look)
        wrap(d, bottle, body, 0.2, 0.64, paper)
        wrap(d, bottle, body, 0.46, 0.5, "ink pigment", 1)
    pump(d, bottle.z[1] - 0.002, box.z[1], 0.48 * box.depth, head)


@draws("cotton_jar", "cookie_jar", whole=True, even="round")
def filled_jar(d: Drawing) -> None:
    """A glass jar with a lid, full of cotton balls or biscuits."""
    box = d.even("round")
    glass, lid = d.material("body", "glass"), d.material("lid", "oak, steel, bamboo, walnut, red plastic")
    r, h = box.width / 2, box.height
    knob = [(0.16, 0.88), (0.14, 0.92), (0.24, 0.96), (0.16, 1.0)]
    if d.category.name == "cotton_jar":
        d.turned(box, [(0.95, 0.0), (1.0, 0.03), (1.0, 0.76)], glass)
        d.turned(box, [(1.0, 0.76), (1.0, 0.85), (0.97, 0.86), (0.16, 0.86), *knob], lid)
    else:
        d.turned(box, [(0.7, 0.0), (0.95, 0.1), (1.0, 0.35), (0.92, 0.6), (0.68, 0.76)], glass)
        d.turned(box, [(0.74, 0.76), (0.74, 0.83), (0.6, 0.86), *knob], lid)
    with d.no_colliders():
        for level in range(5):
            with d.at(z=0.04 * h + 0.13 * level * h, yaw=1.2 * level):
                for k, (x, y) in enumerate(spread(7, (0.62 if d.category.name == "cotton_jar" else 0.5) * r)):
                    if d.category.name == "cotton_jar":
                        d.ball(Box.sized(0.58 * r, 0.58 * r, 0.58 * r, (x, y, 0.0)), "icing", 8)
                    else:
                        biscuit = Box.sized(0.54 * r, 0.54 * r, 0.07 * h, (x, y, 0.0))
                        d.cylinder(biscuit, "cake sponge" if (level + k) % 3 else "chocolate", bevel=0.003, segments=12)


@draws("detergent_bottle", whole=True)
def detergent_bottle(d: Drawing) -> None:
    """A big bottle with a handle, a measuring cap and a bright label."""
    box = d.bounds
    look = d.material("body", "blue plastic, orange plastic, white plastic, green plastic, lilac plastic, red plastic")
    cap = d.material("cap", "white plastic, blue plastic, yellow plastic")
    low, shoulder = box.share(z=(0.0, 0.5)), box.share(z=(0.495, 0.82))
    d.sections(low, [(0.95, 0.97, 0.0), (1, 1, 0.03), (1, 1, 1)], look, radius=0.35, convex=True)
    slope = [(1.0, 0.7, 0.0, 0.0, -0.15), (0.8, 0.58, 0.57, 0.0, -0.15), (0.48, 0.36, 1.0, 0.0, -0.17)]
    d.sections(shoulder, slope, look, radius=0.35)
    h, w = box.height, box.width
    grip = [(0, 0.06 * w, 0.75 * h), (0, 0.28 * w, 0.745 * h), (0, 0.42 * w, 0.66 * h), (0, 0.42 * w, 0.48 * h)]
    d.sweep(grip, 0.014, look, 8)
    mouth = Box.sized(0.6 * box.depth, 0.6 * box.depth, 0.18 * h + 0.004, (0.0, -0.17 * w, 0.82 * h - 0.004))
    d.cylinder(mouth, cap, ends=(1.0, 0.93), bevel=0.003)
    front = low.front(0.0)
    d.print(
        front.share(y=(0.3, 0.7), z=(0.2, 0.84)), "blue plastic" if look.called("white plastic") else "white plastic"
    )
    sun = d.pick("sun", ["yellow plastic", "pink plastic", "green plastic"])
    with d.no_colliders():
        place = Box.around(front.anchor(), 0.0008, 0.32 * w, 0.32 * w).move(z=0.03 * h)
        d.cylinder(place, sun, "x", segments=20)
    d.print(front.share(y=(0.31, 0.69), z=(0.5, 0.6)), "navy paint", 0.0005)
