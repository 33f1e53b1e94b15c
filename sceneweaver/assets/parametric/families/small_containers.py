"""Boxes, baskets, bags, shoes and folded clothes."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import PROUD, Box, Drawing, Look, draws
from ...drawing.components import open_box
from .small_parts import CLOTHS, OPEN

SHIRTS = CLOTHS + ", white fabric, beige fabric, rose fabric"


@draws("storage_box", whole=True)
def storage_box(d: Drawing) -> None:
    """A box of card, cloth or plastic: lidded, with a label in a frame and loops at its ends, or open."""
    names = "grey fabric, beige fabric, white plastic, navy fabric, sage paint, cardboard, rose fabric"
    look = d.material("body", names)
    if d.request.shape == OPEN:
        open_box(d, d.bounds, look, 0.006)
        return
    cover = d.material("lid", "grey fabric, white plastic, oak, beige fabric") if d.chance("other lid", 0.4) else look
    lip = min(0.05, 0.25 * d.bounds.height)
    body = d.box(d.bounds.inset(0.004, bottom=-0.004), look)
    d.box(d.bounds.top(lip), cover)
    frame = Box.around((body.x[1], 0.0, 0.4 * (d.bounds.height - lip)), 0.005, 0.09, 0.044)
    d.box(frame, "steel" if d.chance("metal", 0.5) else "brass", bevel=0.001)
    d.print(frame.front(0.0).inset(y=0.007, z=0.006), "paper")
    y, z = body.y[1] - 0.004, frame.z[1]
    with d.mirror("y"):
        d.arch((-0.04, y, z), (0.04, y, z), (0, 0, 0.02), 0.004, "tan leather", 5)


@draws("basket", whole=True)
def basket(d: Drawing) -> None:
    """A basket of woven strands, open above, with two handles."""
    look = d.material("body", "wicker, rattan, beige fabric, grey fabric")
    dark = d.material("bands", "bark, wicker, white fabric, charcoal fabric")
    box = d.bounds.inset(top=0.045)
    lean = 0.06 * box.depth
    open_box(d, box, look, 0.012, lean, 0.012, core=0.002)
    rows = max(6, round(box.height / 0.022))
    high = box.height / rows
    strand = shapes.ellipse(0.0029, 0.46 * high, 0.0, 6)[:, :2]
    with d.no_colliders():
        for k, row in enumerate(box.rows(rows)):
            inner = box.inset(x=(middle := 0.006 + lean * (1 - (k + 0.5) / rows)), y=middle)
            path = _around(inner, row.center[2], 0.03)
            # Strands pass before and behind the stakes by turns.
            path[:, :2] += 0.0018 * (-1.0) ** (np.arange(len(path)) + k)[:, None] * _outward(path)
            d.sweep(path, strand, dark if k in (1, rows - 2) else look, closed=True)
        d.sweep(_around(box.inset(x=0.0065, y=0.0065), box.z[1] - 0.0047, 0.06), 0.0047, dark, 6, closed=True)
    for side, y in (("left", box.y[1] - 0.007), ("right", box.y[0] + 0.007)):
        with d.part(f"wall {side}"):
            d.arch((-0.07, y, box.z[1] - 0.004), (0.07, y, box.z[1] - 0.004), (0, 0, 0.04), 0.006, dark)


def _around(box: Box, z: float, step: float) -> np.ndarray:
    """Points [N, 3] around a box with its corners cut, about ``step`` apart."""
    ring = shapes.rectangle(box.x, box.y, z, 0.006, 1)
    sides = []
    for start, end in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        count = max(1, round(float(np.linalg.norm(end - start)) / step))
        sides.append(start + (end - start) * (np.arange(count) / count)[:, None])
    return np.concatenate(sides)


def _outward(path: np.ndarray) -> np.ndarray:
    """Level directions [N, 2] out of a closed path that runs counter-clockwise."""
    along = np.roll(path, -1, axis=0)[:, :2] - np.roll(path, 1, axis=0)[:, :2]
    along /= np.linalg.norm(along, axis=1)[:, None]
    return np.c_[along[:, 1], -along[:, 0]]


@draws("plastic_bin", whole=True)
def plastic_bin(d: Drawing) -> None:
    """An open tub with a rim and grips."""
    names = "white plastic, grey plastic, blue plastic, red plastic, clear plastic, mint plastic, yellow plastic"
    look = d.material("body", names)
    grip = d.pick("grip", ["grey plastic", "white plastic", "black plastic"])
    box = d.bounds
    open_box(d, box.inset(x=0.015, y=0.015), look, 0.004, 0.08 * box.depth, 0.006)
    rim, ends = box.top(0.014), box.inset(x=0.02).top(0.014)
    for side in ("front", "back", "left", "right"):
        with d.part(f"wall {side}"):
            edge = d.box(getattr(rim if side in ("front", "back") else ends, side)(0.022), look, bevel=0.004)
            if side in ("left", "right"):
                d.box(getattr(edge, side)(0.012).bottom(-0.026).inset(top=-0.002).place(0.12), grip)


@draws("shopping_bag", whole=True)
def shopping_bag(d: Drawing) -> None:
    """A paper bag with cord handles; bread and leeks stick out of some."""
    names = "cardboard, paper, red paint, navy paint, black paint, sage paint, blush pigment"
    look = d.material("body", names)
    plain = look.called("cardboard", "paper")
    bag = d.bounds.share(z=(0.0, 0.78))
    depth, width, top, high = bag.depth, bag.width, bag.z[1], d.bounds.height - bag.z[1]
    d.sections(bag, [(1, 1, 0.0), (0.92, 1, 1.0)], look, radius=0.0, convex=True)
    d.print(bag.top(0.0).inset(x=0.06 * depth, y=0.006), "bark")
    with d.no_colliders():
        mark = Box.around((0, 0, 0), 0.0008, 0.4 * width, 0.4 * width)
        with d.at(0.48 * depth, 0.0, 0.5 * top, pitch=-math.atan(0.04 * depth / top)):
            d.cylinder(mark, "moss pigment" if plain else "chalk pigment", "x")
    if not (plain and d.chance("groceries", 0.6)):
        with d.mirror("x"):
            ends = ((0.44 * depth, -0.18 * width, top - 0.006), (0.44 * depth, 0.18 * width, top - 0.006))
            d.arch(*ends, (-0.1 * depth, 0, high), 0.003, "white fabric", 8)
        return
    with d.at(-0.1 * depth, -0.2 * width, top - 0.05, roll=0.12):
        loaf = Box.sized(0.068, 0.068, high + 0.045)
        d.turned(loaf, [(0.94, 0.0), (1.0, 0.6), (0.76, 0.9), (0.3, 1.0)], "bread crust", 12)
    for k in range(3):
        with d.at(0.1 * depth, (0.1 + 0.07 * k) * width, top - 0.02, roll=0.15 * (1 - k)):
            d.cylinder(Box.sized(0.032, 0.032, 0.05), "pale leaf", ends=(0.75, 1.0), segments=8)
            d.cylinder(Box.sized(0.06, 0.03, 0.6 * high, (0, 0, 0.05)), "leaf", ends=(0.4, 1.0), segments=8)
    d.ball(Box.around((-0.12 * depth, 0.26 * width, top + 0.012), 0.072, 0.072, 0.072), "red apple", 12)


def shoe(d: Drawing, long: float, wide: float, h: float, look: Look, sole: Look) -> None:
    """A shoe, or a boot where it is high, along x about the frame's origin."""
    boot = h > 0.135

    def ring(share: float, z: float, heel: float = -0.5, toe: float = 0.5) -> np.ndarray:
        t = (np.arange(20) + 0.5) * np.pi / 10
        x = (heel + toe) / 2 + (toe - heel) / 2 * np.cos(t)
        waist = 1 - 0.22 * np.exp(-((x + 0.05) ** 2) / 0.03) - 0.14 * (x < -0.2)
        y = share * wide / 2 * np.sign(np.sin(t)) * np.abs(np.sin(t)) ** 0.7 * waist
        return np.c_[x * long, y, np.full(20, z)]

    base, low = (0.14 * h, 0.4 * h) if boot else (0.22 * h, 0.55 * h)
    d.loft([ring(1.0, 0.0), ring(1.0, base)], sole, convex=True)
    neck = ring(0.8, low, -0.48, 0.2)
    d.loft([ring(0.96, base, -0.49, 0.49), ring(0.94, 0.72 * low, -0.49, 0.46), neck], look)
    d.loft([neck, ring(0.7, 0.85 * h, -0.48, 0.0), ring(0.74, h, -0.49, -0.04)], look)
    with d.no_colliders():
        d.extrude(ring(0.5, 0, -0.44, -0.08)[:, :2], (h - 0.01, h + PROUD), "charcoal fabric")
    for k in range(4):
        lace = (long * (0.22 - 0.065 * k), 0.0, low - 0.005 + (h - low) * 0.17 * k)
        d.box(Box.around(lace, 0.006, 0.4 * wide, 0.018), "white fabric", bevel=0.002)


@draws("shoe_pair", whole=True)
def shoe_pair(d: Drawing) -> None:
    """A pair of trainers, leather shoes or boots, toes to the front."""
    names = "white leather, brown leather, black leather, tan leather, red fabric, blue fabric, grey fabric"
    look = d.material("upper", names)
    sole = d.material("sole", "rubber, white plastic, tan leather")
    depth, width, h = d.bounds.size
    with d.mirror("y"), d.at(0.0, 0.27 * width, 0.0, yaw=0.04):
        shoe(d, 0.99 * depth, 0.42 * width, h, look, sole)


@draws("slippers", whole=True)
def slippers(d: Drawing) -> None:
    """A pair of open slippers."""
    cloth = d.material("cloth", "grey fabric, rose fabric, beige fabric, navy fabric, brown leather, red fabric")
    lining = d.material("lining", "white fabric, beige fabric, sand pigment")
    depth, width, h = d.bounds.size
    with d.mirror("y"), d.at(0.0, 0.27 * width):
        own = Box.sized(depth, 0.42 * width, h)
        d.sections(own.bottom(0.022), [(0.97, 0.97, 0.0), (1, 1, 0.5), (0.98, 0.98, 1.0)], "rubber", convex=True)
        d.sections(own.to(z=(0.02, 0.03)), [(0.94, 0.94, 0.0), (0.92, 0.92, 1.0)], lining, convex=True)
        # The upper is a half tube over the toes, open to the heel, thicker than a finger.
        t = np.linspace(0.0, np.pi, 11)
        rows = []
        for x, wide, high in (
            (-0.02, 0.98, 0.9),
            (0.2, 1.0, 1.0),
            (0.4, 0.7, 0.78),
            (0.46, 0.44, 0.6),
            (0.488, 0.2, 0.0),
        ):
            y, z = wide * own.width / 2 * np.cos(t), 0.016 + max(0.003, high * h - 0.022) * np.sin(t) ** 0.7
            rows.append(np.c_[0 * t + x * depth, y, z])
        d.sheet(np.array(rows)[:, ::-1], 0.008, cloth, (3, 5))
        d.ball(Box.around((0.12 * depth, 0.0, 0.97 * h), 0.04, 0.06, 0.024), lining, 10)


@draws("cap", whole=True)
def cap(d: Drawing) -> None:
    """A cap with a peak, a badge and a button."""
    names = "navy fabric, red fabric, black fabric, green fabric, grey fabric, white fabric"
    cloth = d.material("cloth", names)
    two = d.chance("two", 0.4)
    peak = d.material("peak", "navy fabric, red fabric, black fabric, mustard fabric") if two else cloth
    box, h, r = d.bounds, d.bounds.height, d.bounds.width / 2
    x = box.x[0] + r
    crown = box.back(2 * r).inset(top=0.006)
    d.turned(crown, [(1.0, 0.0), (1.0, 0.25), *shapes.dome(0.99, 0.3, 1.0, 5, 0.05)], cloth)
    d.turned(crown.top(0.006).place(0.024, 0.024).inset(top=-0.006), [(1.0, 0.0), (0.6, 1.0)], peak, 12)
    t = np.linspace(-0.42 * np.pi, 0.42 * np.pi, 11)
    edge = np.c_[x + 0.3 * r + (box.depth - 1.3 * r) * np.cos(t) ** 0.7, 0.98 * r * np.sin(t)]
    bend = 0.012 * np.cos(2.0 * t).clip(0)
    inner = [(x + 0.2 * r, s * 0.9 * r, 0.02) for s in (-1, 1)]
    d.hull(np.concatenate([np.c_[edge, 0.002 + bend], np.c_[edge, 0.007 + bend], inner]), peak)
    badge = ((0.8, 0.36), (0.985, 0.36), (0.8, 0.62), (0.89, 0.62))
    d.hull([(out * r + x, s * 0.2 * r, z * h) for out, z in badge for s in (-1, 1)], "white fabric")


@draws("folded_clothes", whole=True)
def folded_clothes(d: Drawing) -> None:
    """Folded shirts and jumpers in a pile; the top one has a collar and buttons."""
    box, w = d.bounds, d.bounds.width
    layers = box.inset(top=0.004).rows(max(2, round(box.height / 0.04)))
    cloth = d.material("cloth", SHIRTS)
    for k, layer in enumerate(layers):
        if k:
            cloth = d.pick(f"c{k}", SHIRTS.split(", "))
            less, shift = d.uniform(f"e{k}", 0.0, 0.02), d.uniform(f"y{k}", -0.008, 0.008)
            layer = layer.inset(back=less, front=less / 2, y=less + 0.008, top=-0.001).move(y=shift)
        d.cushion(layer, cloth, 0.48 * layer.height, 0.15)
    x, y, z = layers[-1].anchor("top")
    depth = box.depth
    for s in (-1, 1):
        collar = ((-0.44 * depth, 0.02), (-0.44 * depth, 0.2 * w), (-0.22 * depth, 0.07 * w))
        d.hull([(px, s * py, level) for px, py in collar for level in (z - 0.006, box.z[1])], cloth)
    placket = Box((-0.2 * depth, 0.36 * depth), (y - 0.01, y + 0.01), (z - 0.004, z + 0.0005))
    d.box(placket, cloth, bevel=0.0)
    with d.no_colliders():
        for cell in placket.split("x", 4):
            d.cylinder(Box.around(cell.anchor("top"), 0.01, 0.01, 0.002), "chalk pigment", segments=10)
