"""Hotels and break rooms: luggage racks and carts, minibars, ice and vending machines, coffee stations."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import bottle, bowl, castors, cavity, compartments, door, feet, legs, lip, pulls, rack, unit

_DRINKS = ("green glass", "amber glass", "red plastic", "blue plastic", "clear plastic", "orange plastic")
_SNACKS = [f"{tone} plastic" for tone in ("red", "yellow", "blue", "orange", "green", "pink", "white", "mint")]


@draws("luggage_rack", whole=True)
def luggage_rack(d: Drawing) -> None:
    """Crossed legs with straps between two rails, and a guard at the wall's side in some."""
    wood = d.material("frame", "walnut, oak, mahogany, chrome, brass, beech")
    strap = d.material("straps", "brown leather, black fabric, navy fabric, tan leather")
    r, guard = 0.013, d.chance("guard", 0.5)
    box = d.bounds.inset(x=0.013, y=0.013, bottom=0.013, top=0.12 if guard else 0.017)
    x, y, top = box.x[1], box.y[1], box.z[1]
    for s, end in ((1, y - 0.03), (-1, y - 0.06)):
        with d.mirror("y"):
            d.bar((-s * x, end, r), (s * x, end, top), r, wood)
        d.bar((s * x, -y, top), (s * x, y, top), r, wood)
        d.bar((-0.86 * s * x, -end, 0.1), (-0.86 * s * x, end, 0.1), 0.8 * r, wood, 8)
    d.bar((0.0, 0.02 - y, 0.5 * top), (0.0, y - 0.02, 0.5 * top), 0.8 * r, wood, 8)
    for cell in box.inset(y=0.05).columns(4):
        band = cell.place(width=0.054).inset(x=-r).top(-0.004).move(z=r - 0.002)
        d.box(band, strap, bevel=0.0)
        with d.mirror("x"):
            d.box(band.front(0.029).move(x=0.004).inset(top=0.002, bottom=-2 * r), strap, bevel=0.005)
    if guard:
        rail = d.bounds.z[1] - r
        with d.mirror("y"):
            d.bar((-x, y - 0.06, top), (-x, y - 0.06, rail), 0.8 * r, wood, 8)
        for z, thick in ((rail, r), (0.5 * (top + rail), 0.6 * r)):
            d.bar((-x, 0.03 - y, z), (-x, y - 0.03, z), thick, wood)


@draws("luggage_cart")
def luggage_cart(d: Drawing) -> None:
    """A birdcage: a carpeted platform on four wheels, posts that bend to a crown, and a bar for clothes."""
    metal = d.material("frame", "brass, chrome, brass, brushed steel, black steel")
    carpet = d.material("carpet", "red fabric, navy fabric, black fabric, green fabric")
    box, r, bend = d.bounds, 0.019, 0.28
    base = box.to(z=(0.195, 0.24))
    with d.part("platform"):
        for inset, top, look in ((0.0, 0.0, "rubber"), (0.012, 0.004, metal), (0.03, 0.01, carpet)):
            floor = d.slab(base.inset(x=inset, y=inset, top=-top), look, 0.05 - inset, 0.006)
        castors(d, box.bottom(0.195).inset(x=0.05, y=0.05), metal, "rubber")
    (x, y, _), crown, low = box.inset(x=0.055, y=0.055).anchor("front left"), box.z[1] - 0.05, floor.z[1]
    for name, side in (("right", -y), ("left", y)):
        with d.part(name):
            with d.mirror("x"):
                d.bar((x, side, low - 0.03), (x, side, crown - bend), r, metal)
                d.cylinder(Box.sized(0.068, 0.068, 0.03, (x, side, low - 0.004)), metal, ends=(1.0, 0.75))
            d.bar((-x, side, low + 0.35), (x, side, low + 0.35), 0.013, metal)
    with d.part("crown"):
        gone = 1 - np.cos(np.linspace(0.0, math.pi / 2, 7))
        rise = crown - bend + bend * np.sin(np.linspace(0.0, math.pi / 2, 7))
        with d.mirror("x", "y"):
            d.sweep(np.c_[x * (1 - 0.92 * gone), y * (1 - 0.42 * gone), rise], r, metal)
        d.bar((0.0, -0.6 * y, crown), (0.0, 0.6 * y, crown), r, metal)
        with d.mirror("y"):
            d.bar((-0.12 * x, 0.58 * y, crown), (0.12 * x, 0.58 * y, crown), r, metal)
        d.revolve([(0.024, crown - 0.022), (0.012, crown + 0.03), (0.02, crown + 0.04), (0.006, box.z[1])], metal, 14)
    d.surface("deck", floor, round(crown - 0.5 * bend - low - 0.3, 2), inset=0.08)
    d.fit()


def _bottles(d: Drawing, shelf: Box, count: int, height: float, first: int) -> None:
    """Bottles and cans in two rows on the bottom of a box, in the colours of drinks."""
    for k, cell in enumerate(shelf.columns(count)):
        look = _DRINKS[(k + first) % len(_DRINKS)]
        for x in (shelf.x[1] - 0.05, shelf.x[1] - 0.14):
            place = Box.sized(0.062, 0.062, height, (x, cell.center[1], shelf.z[0]))
            if (k + first) % 2:
                d.cylinder(place.share(z=(0.0, 0.65)), look, bevel=0.004, segments=12)
            else:
                bottle(d, place, look)


@draws("minibar", whole=True)
def minibar(d: Drawing) -> None:
    """A low refrigerator with a solid or a glass door, and bottles on a rack."""
    coat = d.material("body", "black paint, white paint, brushed steel, red paint, cream paint, sage paint")
    box = d.bounds.inset(front=0.026)
    feet(d, box.bottom(0.018), "black plastic")
    case = box.inset(bottom=0.018, front=0.042)
    room = cavity(d, case, coat, 0.035, 0.004, None)
    d.box(room.back(0.002).inset(back=-0.001), "white plastic", bevel=0.0)
    d.box(room.top(0.007).front(0.03).move(x=-0.02).inset(y=0.03), "lamp glow", bevel=0.0)
    first = d.integer("first", 0, 5)
    for k, level in enumerate(room.inset(front=0.02).rows(2, gap=0.006)):
        if k:
            rack(d, level.bottom(-0.006))
        _bottles(d, level, 4, 0.85 * level.height, first + 3 * k)
        compartments(d, [level.inset(back=0.09)], f"shelf-{k}")
    glass = d.chance("glass", 0.5)
    leaf = case.front(-0.04).move(x=0.002).inset(bottom=0.012)
    door(d, "door", leaf, coat, "chrome", d.pick("hung", ["left", "right"]), panel="glass" if glass else None)
    d.surface("top", case, inset=0.015)


@draws("ice_machine", whole=True)
def ice_machine(d: Drawing) -> None:
    """A steel machine with a grille over a bin whose flap opens to the ice."""
    steel = d.material("body", "brushed steel, steel, aluminium")
    box = d.bounds.inset(front=0.068)
    middle = 0.58 * box.height
    legs(d, box.bottom(0.13).inset(x=0.04, y=0.04), "chrome", "tapered", 0.036)
    store = box.to(z=(0.12, middle))
    room = store.inset(x=0.03, y=0.04).inset(bottom=0.03, top=0.03)  # for the ice, behind the flap
    sides = [side.inset(bottom=0.03, top=0.03) for side in (store.left(0.04), store.right(0.04))]
    for board in (store.bottom(0.03), store.top(0.03), *sides):
        d.box(board, steel, bevel=0.001)
    for board in (store.back(0.03).to(z=room.z), store.front(0.03).to(z=(room.z[0], middle - 0.23))):
        d.box(board.inset(y=0.04), steel, bevel=0.0)
    compartments(d, [room])
    head = d.box(box.to(z=(middle - 0.001, box.z[1])).inset(y=0.006, front=-0.02), steel, 0.015)
    face = head.front(0.0)
    for slot in face.inset(y=0.06, bottom=0.05, top=0.1).rows(max(5, int((head.height - 0.14) / 0.022)), gap=0.01):
        d.box(slot.front(-0.004).inset(back=-0.003), "black plastic", bevel=0.0)
    strip = face.top(0.085).inset(top=0.05)
    d.print(strip.left(0.2).inset(left=0.06), "screen")
    d.print(strip.right(0.2).inset(right=0.05), "blue plastic")
    x, top = store.x[1], middle - 0.03
    with d.hinge("flap", (x, 0.0, top), axis=(0.0, 1.0, 0.0), limits=(-1.4, 0.0), role="lid"):
        profile = ((x + 0.0005, top), (x + 0.0005, top - 0.23), (x + 0.045, top - 0.23), (x + 0.015, top))
        look = "black plastic" if d.chance("dark flap", 0.6) else "grey plastic"
        d.hull([(px, y, z) for px, z in profile for y in box.inset(y=0.04).y], look)
        lip(d, Box((x + 0.045, x + 0.067), (-0.09, 0.09), (top - 0.23, top - 0.2)), "chrome", bevel=0.005)
    for y, z in ((-0.04, 0.0), (0.02, 0.012), (-0.012, 0.06)):  # ice cubes as a sign on the front
        cube = Box.around((x, y, store.z[0] + 0.08 + z), 0.0, 0.045, 0.045)
        d.print(cube, "blue ceramic")
        d.print(cube.share(y=(0.15, 0.65), z=(0.45, 0.85)), "white plastic", 0.00045)


@draws("vending_machine", whole=True)
def vending_machine(d: Drawing) -> None:
    """A tall case with a window on rows of snacks and bottles, a panel with keys and slots, and a flap below."""
    coat = d.material("body", "black paint, red paint, blue paint, white paint, grey paint, navy paint")
    box = d.bounds.inset(front=0.032)
    feet(d, box.bottom(0.045), "black plastic")
    case, f, top = box.inset(bottom=0.045), box.x[1], box.z[1] - 0.17
    window = box.to(z=(0.5, top)).inset(right=0.05, left=0.27)  # the panel is to the viewer's right: +y
    d.box(case.inset(front=0.3), coat)
    front, beside = case.front(0.3), case.front(0.3).to(z=window.z)
    rest = [front.to(z=(case.z[0], 0.5)), front.to(z=(top, box.z[1])), beside.left(0.27), beside.right(0.05)]
    for part in rest:
        d.box(part, coat, bevel=0.0)
    d.box(window.front(0.008).move(x=-0.004), "glass", bevel=0.0)
    sign = d.box(box.front(-0.004).top(0.14).inset(y=0.05, top=0.03), "lamp glow", bevel=0.0)
    d.print(sign.front(0.0).share(y=(0.1, 0.6), z=(0.25, 0.75)), "red plastic")
    first, count = d.integer("first", 0, 7), max(4, int(window.width / 0.095))
    for i, row in enumerate(window.inset(front=0.02).front(0.28).rows(6)):
        d.box(row.bottom(0.008), "grey plastic", bevel=0.0)
        d.box(row.front(0.006).bottom(0.022), "white plastic", bevel=0.0)
        for j, cell in enumerate(row.inset(bottom=0.008, top=0.035, front=0.02).front(0.06).columns(count, gap=0.02)):
            look = _SNACKS[(first + 3 * i + j * (2 if i % 2 else 1)) % len(_SNACKS)]
            if i < 2:
                bottle(d, cell.place(0.06, 0.06), look)
            elif (i + j // 2) % 2:
                d.cushion(cell.share(z=(0.0, 0.85)), look, 0.012, 0.5)
            else:
                d.box(cell.inset(back=0.02).share(z=(0.0, 0.8)), look)
    panel = d.box(Box((f - 0.001, f + 0.003), (window.y[1] + 0.04, box.y[1] - 0.03), (0.85, 1.55)), "black plastic")
    face = panel.front(0.0).inset(y=0.02)
    d.print(face.share(z=(0.84, 0.95)), "screen")
    for key in (k for line in face.share(z=(0.54, 0.78)).inset(y=0.03).rows(4, 0.012) for k in line.columns(3, 0.012)):
        d.box(key.front(-0.005).inset(back=-0.001), "grey plastic", bevel=0.0)
    for share, look in (((0.38, 0.46), "chrome"), ((0.24, 0.31), "blue plastic"), ((0.04, 0.14), "chrome")):
        d.box(face.share(z=share).inset(y=0.02).front(-0.007).inset(back=-0.001), look, bevel=0.001)
    with d.hinge("flap", (f, 0.0, 0.4), axis=(0.0, 1.0, 0.0), limits=(-0.9, 0.0), role="lid"):
        flap = d.box(window.to(x=(f + 0.0005, f + 0.009), z=(0.2, 0.4)).inset(y=0.02), "black plastic")
        lip(d, flap.front(-0.022).bottom(0.016).inset(y=0.08), "grey plastic", bevel=0.002)
    d.print(box.front(0.0).inset(y=0.03).to(z=(0.07, 0.15)), "black plastic")


@draws("coffee_station")
def coffee_station(d: Drawing) -> None:
    """A cabinet with a counter, over it an open shelf with mugs and jars against a panelled back."""
    leaf = d.material("fronts", "sage paint, white paint, oak, navy paint, walnut, black paint, cream paint, light oak")
    shell = d.material("body", "white paint, oak, walnut") if leaf.kind == "paint" else leaf
    top = d.material("top", "oak, walnut, marble, beech, dark marble")
    style, metal, reach = pulls(d, leaf)
    box, panel = d.bounds, leaf if d.style in ("classic", "rustic") else None
    low, high = box.bottom(0.9), box.inset(bottom=0.9)
    with d.part("body"):
        feet(d, box.bottom(0.08), "black plastic")
        for k, cell in enumerate(low.inset(bottom=0.08, top=0.03, front=reach).columns(2)):
            layout = d.pick(f"layout {k}", ["drawers", "mixed", "doors"])
            unit(d, f"unit-{k}", cell, layout, shell, leaf, metal, style, panel)  # type: ignore[arg-type]
        slab = d.box(low.top(0.03), top)
    with d.part("back"):
        back = d.box(high.back(0.018), leaf)
        for plank in back.front(-0.004).inset(back=-0.001, z=0.01).columns(round(box.width / 0.1), gap=0.006):
            d.box(plank, leaf, bevel=0.001)
    with d.part("shelf"):
        shelf = d.box(high.inset(top=0.16, back=0.022, y=0.02).top(0.022).back(0.178), top)
        with d.mirror("y"):
            bracket = shelf.bottom(-0.1).share(y=(0.86, 0.88))
            for strip in (bracket.top(0.012).inset(front=0.03), bracket.back(0.008)):
                d.box(strip, metal, bevel=0.0)
        first, x = d.integer("mug", 0, 4), shelf.x[1] - 0.05
        for k, y in enumerate(np.linspace(-0.24, 0.24, 5).tolist()):
            d.bar((x, y, shelf.z[0] + 0.001), (x, y, shelf.z[0] - 0.03), 0.003, metal, 6)
            tone = ("white", "blue", "cream", "grey", "white")[(k + first) % 5]
            mug = Box.sized(0.072, 0.072, 0.085, (x, y, shelf.z[0] - 0.103))
            inner = ((0.9, 0.9, mug.z[1]), (0.8, 0.8, mug.z[0] + 0.005))
            outer = ((0.9, 0.9, mug.z[0]), (1.0, 1.0, mug.z[1]))
            bowl(d, mug, outer, inner, f"{tone} ceramic", staves=6, inside=None)
            grip = mug.left(0.003)
            d.arch(grip.point(z=0.76), grip.point(z=0.24), (0.0, 0.022, 0.0), 0.005, f"{tone} ceramic", 4)
    with d.part("jars"):
        for k, look in enumerate(("coffee", "chocolate", "icing")):
            jar = Box.sized(0.09, 0.09, 0.1, (shelf.center[0], box.y[0] + 0.12 * (k + 1), shelf.z[1]))
            d.cylinder(jar, "glass", bevel=0.006, segments=18)
            d.cylinder(jar.top(-0.018), "cork", segments=18)
            with d.no_colliders():
                d.cylinder(jar.inset(x=0.004, y=0.004, bottom=0.004).share(z=(0.0, 0.5 + 0.1 * k)), look, segments=16)
    d.surface("top", slab.inset(back=0.215, front=0.01, y=0.01))
    d.surface("shelf", shelf.inset(x=0.01, right=0.43, left=0.01))
    d.fit()
