"""Food and its packets."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import PROUD, Box, Drawing, Look, draws
from .small_parts import GOLDEN, open_vessel, spread

_HOLLOW = 0.785
"""How much higher than three apples that touch an orange lies in their hollow, as a share of its width."""

APPLE_SIDE = [(0.3, 0.0), (0.62, 0.06), (0.88, 0.28), (1.0, 0.56), (0.93, 0.78), (0.68, 0.94), (0.4, 0.97)]


def apple_in(d: Drawing, box: Box, look: Look) -> None:
    """An apple with a stalk that fills a box."""
    fruit = box.share(z=(0.0, 0.9))
    d.turned(fruit, [*APPLE_SIDE, (0.12, 0.9), (0.0, 0.84)], look, hollow=True)
    x, y, z = fruit.anchor("top")
    r = box.width / 2
    d.bar((x, y, z - 0.3 * r), (x + 0.1 * r, y + 0.06 * r, box.z[1] - 0.04 * r), 0.05 * r, "bark", 6)


def citrus(d: Drawing, box: Box, look: Look, segments: int = 12) -> None:
    """An orange, or a lemon that is longer, with the mark of its stalk."""
    d.ball(box.inset(y=-0.12 * box.width) if look == "lemon peel" else box, look, segments)
    with d.no_colliders():
        mark = box.share(z=(0.95, 0.992)).place(0.08 * box.depth, 0.08 * box.width)
        d.cylinder(mark, "dark leaf", segments=6)


def banana(d: Drawing, length: float, r: float) -> None:
    """A banana that lies bent about z, its stalk at the frame's origin."""
    bend = np.linspace(-0.75, 0.75, 9)
    big = length / 1.5
    rings = []
    for turn, size in zip(bend, (0.3, 0.36, 0.75, 0.96, 1.0, 1.0, 0.9, 0.6, 0.24), strict=True):
        way = np.array([math.cos(turn), math.sin(turn), 0.0])
        ring = shapes.ellipse(size * r, size * r, 0.0, 6)
        middle = big * (way - (math.cos(0.75), -math.sin(0.75), 0.0)) + (0, 0, r)
        rings.append(middle + ring[:, :1] * -way + ring[:, 1:2] * (0, 0, 1))
    for k, look in enumerate(("pale leaf", *["banana peel"] * 6, "bark")):
        d.loft(rings[k : k + 2], look, convex=True)


@draws("fruit_bowl", whole=True, even="round")
def fruit_bowl(d: Drawing) -> None:
    """A wide bowl of seven apples on its floor and three oranges in their hollows."""
    box = d.even("round")
    look = d.material("bowl", "white ceramic, walnut, oak, blue ceramic, grey ceramic, brass")
    # Seven apples, which stand flat, touch each other on its floor; oranges lie in hollows between three of them.
    r, floor, up = box.width / 2, 0.006, _HOLLOW + 0.004
    size = min(0.53 * r, (box.height - floor) / (1 + up))
    wall = 1.6 * size / r
    rim = 0.6 * size + floor
    open_vessel(d, box.to(z=(0.0, rim)), [(0.82 * wall, 0.0), (wall, 0.4), (1.0, 1.0)], look, 0.004, floor / rim)
    places = [(0.0, 0.0, floor), *((size, k * math.pi / 3, floor) for k in range(6))]
    hollows = [(size / math.sqrt(3), (4 * k + 1) * math.pi / 6, floor + up * size) for k in range(3)]
    with d.at(yaw=d.uniform("turn", 0, 6)):
        for k, (far, turn, low) in enumerate([*places, *hollows]):
            own = Box.sized(size, size, size, (far * math.cos(turn), far * math.sin(turn), low))
            kind = "apple" if low == floor else "orange"
            with d.item(f"{kind}-{k}", kind), d.convex():
                if kind == "apple":
                    apple_in(d, own, "green apple" if d.chance(f"green {k}", 0.4) else "red apple")
                else:
                    citrus(d, own, "orange peel")


@draws("apple", whole=True, even="round")
def apple(d: Drawing) -> None:
    """An apple with a stalk and a leaf."""
    box = d.even("round")
    apple_in(d, box, d.material("body", "red apple, green apple, lemon peel"))
    leaf = ((0.52, 0.52, 0.88), (0.7, 0.63, 0.91), (0.65, 0.73, 0.93), (0.88, 0.8, 0.89), (0.7, 0.68, 0.96))
    d.hull([box.point(*share) for share in leaf], "dark leaf")


@draws("banana_bunch", whole=True)
def banana_bunch(d: Drawing) -> None:
    """Four or five bananas joined at their stalks."""
    width = d.bounds.width
    d.material("body", "banana peel")
    for k in range(d.integer("count", 4, 5)):
        up = max(0, k - 2)
        with d.at(0.006 * k, 0, 0.012 * up, yaw=(0.6, 0.1, -0.4, 0.32, -0.12)[k], roll=-0.016 * up / width):
            banana(d, 0.9 * width, 0.017)
    d.slab(Box((-0.006, 0.02), (-0.008, 0.014), (0.01, 0.038)), "bark", 0.006)


@draws("orange", whole=True, even="cube")
def orange(d: Drawing) -> None:
    """An orange."""
    citrus(d, d.even("cube"), d.material("body", "orange peel"), 20)


def loaf_section(box: Box, y: float) -> np.ndarray:
    """The outline of a loaf across y as a ring: flat below, domed above, as large as a box in x and z."""
    t = np.arange(18) * (-np.pi / 9)
    c, s = np.cos(t), np.sin(t)
    x, z = np.sign(c) * np.abs(c) ** 0.6, np.sign(s) * np.abs(s) ** np.where(s > 0, 0.85, 0.5)
    middle = box.center
    return np.c_[middle[0] + x * box.depth / 2, np.full(18, y), middle[2] + z * box.height / 2]


@draws("bread_loaf", whole=True)
def bread_loaf(d: Drawing) -> None:
    """A loaf with cuts across its crust; of some, the first slices lie cut."""
    crust = d.material("body", "bread crust")
    box = d.bounds
    sliced = d.chance("sliced", 0.5)
    loaf = box.inset(right=0.3 * box.width if sliced else 0.0)
    ends = [(0.0, 1.0)] if sliced else [(0.0, 0.55), (0.06, 0.82), (0.2, 1.0)]
    rings = []
    for along, size in [*ends, (0.8, 1.0), (0.94, 0.82), (1.0, 0.55)]:
        own = loaf.share(((1 - size) / 2, (1 + size) / 2), z=(0.0, size))
        rings.append(loaf_section(own, loaf.y[0] + along * loaf.width))
    d.loft(rings, crust, convex=True)
    cuts = [loaf.y[0]]
    if sliced:
        for k in range(3):
            y = box.y[0] + 0.005 + 0.1 * k * box.width
            d.loft([loaf_section(box, at) for at in (y, y + 0.055 * box.width)], crust, convex=True)
            cuts += [y, y + 0.055 * box.width]
        with d.no_colliders():
            for y in cuts:
                crumb = box.share((0.04, 0.96), z=(0.04, 0.96))
                d.loft([loaf_section(crumb, y - PROUD), loaf_section(crumb, y + PROUD)], "bread crumb")
    for k in range(4):
        with d.at(0.0, loaf.y[0] + loaf.width * (0.3 + 0.13 * k), 0.93 * box.height, yaw=0.5):
            d.box(Box.around((0, 0, 0), 0.4 * box.depth, 0.012, 0.13 * box.height), "bread crumb")


@draws("cake", whole=True, even="round")
def cake(d: Drawing) -> None:
    """A round cake on a plate with icing, layers and berries; a wedge is cut out of some."""
    box = d.even("round")
    base = d.material("body", "icing, chocolate, pink icing, cake sponge")
    trim = d.material("trim", "icing, pink icing, chocolate")
    plate = [(0.72, 0.0), (1.0, 0.67), (1.0, 1.0), (0.72, 0.85), (0.0, 0.85)]
    d.turned(box.bottom(0.012), plate, "white ceramic", hollow=True)
    body = box.share((0.08, 0.92), (0.08, 0.92), (0.0, 0.84)).inset(bottom=0.01)
    r, low, top = body.width / 2, body.z[0], body.z[1]
    cut = 0.55 if d.chance("cut", 0.6) else 0.0
    if cut:
        turns = np.linspace(cut, 2 * np.pi - 0.3 * cut, 25)
        for part in (turns[:13], turns[12:]):
            arc = np.c_[np.cos(part), np.sin(part)] * r
            wedge = np.concatenate([[(0.0, 0.0)], arc])
            with d.no_colliders():
                for k, layer in enumerate(body.share(z=(0.0, 0.95)).rows([6, 1, 6, 1, 5])):
                    d.extrude(0.985 * wedge, layer.z, trim if k % 2 else "cake sponge")
            d.extrude(np.concatenate([arc, 0.97 * arc[::-1]]), (low, top), base)
            d.extrude(wedge, (top - 0.05 * body.height, top), base)
            core = shapes.extrusion(0.5 * wedge, (low, top - 0.01))
            d.add(core, "cake sponge", [shapes.extrusion(piece, (low, top)) for piece in shapes.convex_pieces(wedge)])
    else:
        d.cylinder(body, base, bevel=0.005)
        for z in (low + 0.004, low + 0.5 * body.height):
            d.hoop(body.inset(x=0.001, y=0.001).to(z=(z, z)), 0.005, trim, steps=24)
    for k in range(12):
        a = 2 * math.pi * (k + 0.5) / 12
        if not cut or cut + 0.12 < a < 2 * math.pi - 0.3 * cut - 0.12:
            at = (0.8 * r * math.cos(a), 0.8 * r * math.sin(a), top - 0.001)
            own = Box.sized(0.2 * r, 0.2 * r, box.z[1] - top, at)
            d.turned(own, [(1.0, 0.0), (0.9, 0.3), (0.3, 0.5)], trim, 8)
            d.ball(own.share((0.14, 0.86), (0.14, 0.86), (0.3, 1.0)), "red apple", 8)


@draws("pizza", whole=True, even="round")
def pizza(d: Drawing) -> None:
    """A pizza on a board, with tomato, cheese, slices of salami and leaves of basil."""
    box = d.even("round")
    wood = d.material("board", "beech, oak, walnut, white ceramic")
    d.cylinder(box.share(z=(0.0, 0.45)), wood, bevel=0.002)
    own = box.share((0.05, 0.95), (0.05, 0.95), (0.45, 0.95))
    crust = [(0.95, 0.0), (1.0, 0.4), (0.97, 0.84), (0.9, 0.84), (0.86, 0.5), (0.0, 0.5)]
    d.turned(own, crust, "bread crust", 32, hollow=True)
    r = own.width / 2
    with d.no_colliders():
        d.cylinder(own.share((0.065, 0.935), (0.065, 0.935), (0.0, 0.6)), "tomato")
        d.cylinder(own.share((0.1, 0.9), (0.1, 0.9), (0.0, 0.68)), "cheese", segments=14)
        for k, (x, y) in enumerate(spread(17, 0.78 * r)):
            if k % 2:
                d.cylinder(own.share(z=(0.0, 0.8)).place(0.2 * r, 0.2 * r).move(x, y), "red apple", segments=12)
            elif k % 4:
                with d.at(x, y, own.z[0] + 0.75 * own.height, yaw=GOLDEN * k):
                    d.ball(Box.around((0, 0, 0), 0.036, 0.018, 0.002), "dark leaf", 8)
        for k in range(3):
            with d.at(yaw=k * math.pi / 3):
                d.box(own.share((0.015, 0.985), z=(0.0, 0.83)).place(width=0.002), "bread crumb", bevel=0.0)


@draws("cheese_board", whole=True)
def cheese_board(d: Drawing) -> None:
    """A board with a wedge and a wheel of cheese, grapes, ham and a knife."""
    wood = d.material("board", "oak, walnut, beech, marble")
    board = d.slab(d.bounds.bottom(0.018), wood, 0.02, 0.003, 4)
    depth, width, top = board.depth, board.width, board.z[1]
    high, small = d.bounds.height - top, min(1.0, depth / 0.24)
    with d.at(-0.25 * depth, -0.36 * width, top):
        d.extrude(small * np.array([(-0.02, -0.02), (0.09, 0.005), (0.085, 0.05), (0.06, 0.08)]), (0.0, high), "cheese")
        for x, z in ((0.02, 0.6), (0.05, 0.35), (0.075, 0.7)):
            with d.no_colliders(), d.at(small * x, small * (-0.0155 + 0.227 * x), z * high, yaw=0.223):
                d.ball(Box.around((0, 0, 0), 0.01, 0.0006, 0.01), "mustard fabric", 10)
    with d.at(-0.12 * depth, 0.2 * width, top):
        wheel = min(0.055, 0.2 * width)
        turns = np.linspace(0.4, 2 * np.pi - 0.4, 19)
        for part in (turns[:10], turns[9:]):
            arc = wheel * np.c_[np.cos(part), np.sin(part)]
            d.extrude(np.concatenate([[(0.0, 0.0)], arc]), (0.0, 0.75 * high), "soft cheese", bevel=0.002)
    for k, (x, y) in enumerate(spread(14, 0.03)):
        at = (0.25 * depth + x, 0.06 * width + 1.5 * y, top + 0.009 + 0.012 * (k < 5))
        d.ball(Box.around(at, 0.019, 0.019, 0.019), "grape", 8)
    for k in range(3):
        ham = Box.sized(0.048, 0.048, 0.006 + 0.003 * k, (0.3 * depth, -0.32 * width + 0.035 * k, top))
        d.cylinder(ham, "ham", ends=(1.0, 0.92), segments=12)
    with d.at(0.1 * depth, 0.36 * width, top, yaw=0.2):
        d.slab(Box((-0.005, 0.09), (-0.008, 0.008), (0.0, 0.013)), "walnut", 0.004)
        blade = ((0.005, -0.01), (-0.085, -0.012), (-0.1, 0.008), (0.005, 0.009))
        d.hull([(x, y, z) for x, y in blade for z in (0.003, 0.006)], "steel")


@draws("milk_carton", whole=True)
def milk_carton(d: Drawing) -> None:
    """A carton with a gable top and a screw cap."""
    look = d.material("body", "white plastic, blue plastic, cream paint")
    other = d.material("print", "blue plastic, green plastic, red plastic, navy paint")
    box = d.bounds
    body = d.box(box.share(z=(0.0, 0.78)), look, bevel=0.001)
    gable = box.share(z=(0.78, 0.93))
    d.sections(gable, [(1, 1, 0.0), (0.006 / box.depth, 1, 1.0)], look, radius=0.0, convex=True)
    d.box(box.share(z=(0.92, 1.0)).place(0.006), look, bevel=0.0)
    flat = body.inset(x=0.0015), body.inset(y=0.0015)
    for side in (flat[1].front(0.0), flat[0].left(0.0), flat[0].right(0.0)):
        d.print(side.share(z=(0.07, 0.5)), other)
    d.print(body.front(0.0).share(y=(0.2, 0.8), z=(0.67, 0.85)), other)
    lean = math.atan2(box.depth / 2, gable.height)
    with d.at(0.25 * box.depth, 0.0, gable.center[2] - 0.001, pitch=math.pi / 2 - lean):
        d.cylinder(Box.sized(0.36 * box.depth, 0.36 * box.depth, 0.012), other, ends=(1.0, 0.94), segments=16)


@draws("vegetable_basket", whole=True)
def vegetable_basket(d: Drawing) -> None:
    """A basket of carrots, tomatoes, a lettuce and an aubergine."""
    look = d.material("basket", "wicker, rattan, oak, pine")
    box = d.bounds
    depth, width, h = box.size
    basket = box.share(z=(0.0, 0.5))
    rim, up = basket.z[1], h - basket.z[1]
    rows = [(0.86, 0.9, 0.0), (0.98, 0.985, 0.9), (1, 1, 0.92), (1, 1, 1), (0.93, 0.95, 1.0), (0.83, 0.88, 0.1)]
    d.sections(basket, rows, look, radius=0.16, hollow=2, holds=False)
    with d.no_colliders():
        for low in (0.14, 0.34, 0.54, 0.74):
            ring = [(0.86 + 0.133 * z + 0.0006 / depth, 0.9 + 0.094 * z + 0.0006 / width, z) for z in (low, low + 0.07)]
            d.sections(basket, ring, "bark", radius=0.16)
    with d.at(-0.18 * depth, 0.26 * width, rim):
        d.ball(Box.around((0, 0, 0.25 * up), 0.4 * depth, 0.4 * depth, 1.5 * up), "lettuce")
        for k in range(6):
            with d.at(yaw=k * math.pi / 3), d.at(0.13 * depth, 0.0, 0.15 * up, pitch=0.35):
                d.ball(Box.around((0, 0, 0), 0.08 * depth, 0.24 * depth, 1.2 * up), "pale leaf" if k % 2 else "leaf", 8)
    for k, (x, y) in enumerate(((0.22, 0.32), (0.26, 0.12), (0.08, 0.2), (0.16, -0.06))):
        own = Box.sized(0.2 * depth, 0.2 * depth, 0.19 * depth, (x * depth, y * width, rim - 0.06 * depth))
        citrus(d, own, "tomato" if k % 3 else "red apple")
    for k in range(4):
        x, y = (-0.3 + 0.1 * k) * depth, (-0.05 - 0.02 * k) * width
        with d.at(x, y, rim + 0.1 * up, yaw=-1.3 + 0.16 * k, pitch=math.pi / 2 - 0.12):
            carrot = Box.sized(0.11 * depth, 0.11 * depth, 0.42 * width)
            d.turned(carrot, [(0.2, 0.0), (1.0, 0.72), (0.8, 0.8)], "carrot", 10)
            d.turned(carrot, [(0.2, 0.78), (0.7, 1.0)], "leaf", 8)
    with d.at(0.3 * depth, -0.24 * width, rim + 0.16 * up, yaw=1.9, pitch=math.pi / 2):
        aubergine = Box.sized(0.2 * depth, 0.2 * depth, 0.34 * width, (0, 0, -0.2 * width))
        d.turned(aubergine, [(0.3, 0.0), (0.9, 0.12), (1.0, 0.4), (0.6, 0.88), (0.3, 1.0)], "aubergine", 14)
        d.turned(aubergine, [(0.5, 0.9), (0.36, 1.0), (0.16, 1.02), (0.14, 1.14)], "leaf", 8)


@draws("pumpkin", whole=True, even="round")
def pumpkin(d: Drawing) -> None:
    """A ribbed pumpkin with a woody stalk."""
    look = d.material("body", "pumpkin skin, pumpkin skin, cream paint, sage paint")
    box = d.even("round")
    r, body = box.width / 2, box.share(z=(0.0, 0.86))
    for k in range(9):
        with d.at(yaw=2 * math.pi * k / 9):
            d.ball(Box.around((0.58 * r, 0.0, body.center[2]), 0.84 * r, 0.8 * r, body.height), look, 12)
    stalk = box.share(z=(0.74, 1.0))
    d.turned(stalk, [(0.22, 0.0), (0.1, 0.23), (0.07, 0.77)], "bark", 8)
    d.bar((0, 0, stalk.z[0] + 0.7 * stalk.height), (0.1 * r, 0.06 * r, box.z[1]), 0.07 * r, "bark", 8)


@draws("croissant", whole=True)
def croissant(d: Drawing) -> None:
    """A bent roll of flaky dough on a plate."""
    glaze = d.material("plate", "white ceramic, cream ceramic, blue ceramic")
    plate = d.bounds.bottom(0.013)
    d.turned(plate, [(0.7, 0.0), (1.0, 0.77), (1.0, 1.0), (0.7, 0.62), (0.0, 0.62)], glaze, hollow=True)
    big, high = 0.27 * plate.width, d.bounds.height - 0.008
    ends = np.linspace(-1.25, 1.25, 8)
    for k, size in enumerate((0.34, 0.62, 0.86, 1.0, 0.86, 0.62, 0.34)):
        turns = (ends[k] - 0.06, ends[k + 1] + 0.06)
        start, end = ((big * (math.cos(a) - 0.6), 1.2 * big * math.sin(a)) for a in turns)
        way, r = (end[0] - start[0], end[1] - start[1]), size * high / 2
        with d.at(*start, 0.008 + r, yaw=math.atan2(way[1], way[0]), pitch=math.pi / 2):
            taper = (0.8, 1.0) if k < 3 else (1.0, 0.8) if k > 3 else (0.95, 0.95)
            roll = Box.sized(2 * r, 2 * r, math.hypot(*way))
            d.cylinder(roll, "bread crust" if k % 2 else "cake sponge", ends=taper, bevel=0.004, segments=12)
