"""What stands on a laid table: plates, bowls, cups, glasses, jugs, cutlery."""

from __future__ import annotations

import math
from contextlib import nullcontext
from functools import partial

import numpy as np

from ... import shapes
from ...drawing import PROUD, Box, Drawing, Look, draws
from ...drawing.components import open_box
from .small_parts import CERAMICS, filling, open_vessel

DISH = [(0.55, 0.0), (0.6, 0.1), (0.68, 0.34), (0.97, 0.86), (1.0, 1.0)]
CUP = [(0.5, 0.0), (0.55, 0.04), (0.86, 0.35), (0.97, 0.7), (1.0, 1.0)]


def dish(d: Drawing, box: Box, glaze: Look, rim: Look | None = None) -> None:
    """A plate that fills a box, with a sloping rim; its edge may have another glaze."""
    open_vessel(d, box, DISH, glaze, 0.006, 0.27, staves=8)
    if rim is not None:
        (x, y, z), r, turn = box.anchor("bottom"), box.width / 2, np.arange(28) * (2 * np.pi / 28)
        edge = np.array([(0.03, 0.8), (0.03, 0.9), (-0.03, 1.0), (-0.03, 0.96)]) * (r, box.height)
        with d.no_colliders(), d.at(x, y, z + PROUD):
            d.sweep(np.c_[0.96 * r * np.cos(turn), 0.96 * r * np.sin(turn), 0 * turn], edge, rim, closed=True)


@draws("plate", whole=True, even="round")
def plate(d: Drawing) -> None:
    """A dinner plate, in some with an edge in another glaze."""
    glaze = d.material("body", CERAMICS)
    rim = d.material("rim", "blue ceramic, grey ceramic, brass, terracotta") if d.chance("rim", 0.5) else None
    dish(d, d.even("round"), glaze, rim)


@draws("plate_stack", whole=True, even="round")
def plate_stack(d: Drawing) -> None:
    """Plates in a pile, smaller ones on top."""
    box = d.even("round")
    glaze, other = d.material("body", CERAMICS), d.material("other", CERAMICS)
    count = max(3, 1 + int((box.height - 0.022) / 0.006))  # the floor of each is 6 mm thick
    step = (box.height - 0.022) / (count - 1)
    for k in range(count):
        share, look = (0.78, other) if k >= 0.6 * count else (1.0, glaze)
        with d.item(f"plate-{k}", "plate") if 0 < k >= count - 4 else nullcontext():
            dish(d, Box.sized(share * box.depth, share * box.width, 0.022, (0.0, 0.0, k * step)), look)


@draws("bowl", whole=True, even="round")
def bowl(d: Drawing) -> None:
    """An open bowl on a foot ring, in another glaze inside or full of cereals."""
    box = d.even("round")
    glaze = d.material("body", CERAMICS)
    inside = d.material("inside", "white ceramic, cream ceramic, blue ceramic")
    foot = d.uniform("foot", 0.42, 0.55)
    shape = [(foot, 0.0), (foot, 0.06), (0.72, 0.26), (0.92, 0.6), (1.0, 1.0)]
    open_vessel(d, box, shape, glaze, floor=0.14)
    if d.chance("full", 0.35):
        food = d.pick("food", ["bread crust", "carrot", "lettuce", "tomato"])
        filling(d, box, [*shape[:4], (0.7, 0.7), (0.3, 0.74)], 0.2, 0.74, food)
    else:
        filling(d, box, shape, 0.13, 0.165, inside, 0.006)


@draws("cup_and_saucer", whole=True, even="round")
def cup_and_saucer(d: Drawing) -> None:
    """A cup with tea or coffee on its saucer, and a little spoon."""
    box = d.even("round")
    glaze = d.material("body", "white ceramic, cream ceramic, blue ceramic, grey ceramic")
    rim = d.material("rim", "brass, blue ceramic") if d.chance("rim", 0.5) else None
    dish(d, box.to(z=(0.0, 0.018)), glaze, rim)
    foot = 0.27 * 0.018  # on the floor of the saucer
    cup = Box.sized(0.58 * box.depth, 0.58 * box.width, box.height - foot, (0.0, 0.0, foot))
    with d.item("cup"):
        open_vessel(d, cup, CUP, glaze, 0.0025, 0.08, d.pick("drink", ["coffee", "amber glass"]), 0.75)
        r, h = cup.width / 2, box.height
        d.arch((0, -0.985 * r, 0.8 * h), (0, -0.87 * r, 0.4 * h), (0, -0.13 * box.width, 0), 0.0032, glaze)
    with d.at(-0.3 * box.depth, 0.36 * box.width, 0.011):
        spoon(d, 0.6 * box.depth, "steel")


@draws("drinking_glass", whole=True, even="round")
def drinking_glass(d: Drawing) -> None:
    """A tumbler, in some with water or juice."""
    d.material("body", "glass")
    tumbler(d, d.even("round"), d.uniform("taper", 0.72, 0.95), d.pick("drink", [None, "frosted glass", "orange peel"]))


def tumbler(d: Drawing, box: Box, taper: float, drink: Look | None) -> None:
    """A drinking glass with a thick foot."""
    open_vessel(d, box, [(taper - 0.04, 0.0), (taper, 0.02), (1.0, 1.0)], "glass", 0.0018, 0.08, drink)


@draws("wine_glass", whole=True, even="round")
def wine_glass(d: Drawing) -> None:
    """A stemmed glass, in some with red or white wine."""
    d.material("body", "glass")
    drink = d.pick("drink", [None, "aubergine", "lemon peel"])
    goblet(d, d.even("round"), d.uniform("stem", 0.42, 0.5), d.uniform("mouth", 0.72, 0.85), drink)


def goblet(d: Drawing, box: Box, stem: float, mouth: float, drink: Look | None) -> None:
    """A wine glass whose stem and mouth are these shares of its height and width."""
    foot = [(0.88, 0.0), (0.88, 0.012), (0.27, 0.035), (0.09, 0.09), (0.085, stem - 0.05), (0.17, stem - 0.01)]
    sides = [(0.55, 0.09), (0.9, 0.3), (1.0, 0.5), (0.97, 0.72), (mouth, 1.0)]
    shape = [*foot, *((r, stem + z * (1 - stem)) for r, z in sides)]
    open_vessel(d, box, shape, "glass", 0.0018, stem + 0.03, drink, stem + 0.42 * (1 - stem))


@draws("champagne_flute", whole=True, even="round")
def champagne_flute(d: Drawing) -> None:
    """A tall slim glass on a stem."""
    d.material("body", "glass")
    foot = [(1.0, 0.0), (1.0, 0.01), (0.3, 0.03), (0.1, 0.07), (0.09, 0.31), (0.17, 0.36)]
    drink = "lemon peel" if d.chance("drink", 0.6) else None
    open_vessel(d, d.even("round"), [*foot, (0.6, 0.48), (0.82, 0.66), (0.8, 1.0)], "glass", 0.0015, 0.39, drink, 0.82)


@draws("pitcher", whole=True)
def pitcher(d: Drawing) -> None:
    """A jug with a lip and a handle; those of glass are half full."""
    look = d.material("body", CERAMICS, "glass, glass")
    box = d.bounds.place(width=d.bounds.depth)
    r, h, reach = box.width / 2, box.height, d.bounds.width - box.width
    shape = [(0.72, 0.0), (0.86, 0.1), (0.93, 0.3), (0.8, 0.6), (0.66, 0.82), (0.74, 1.0)]
    rings = []
    for wall, levels in ((0.0, shape), (0.004, [*shape[:0:-1], (0.76, 0.05)])):
        for share, z in levels:
            ring = shapes.ellipse(share * r - wall, share * r - wall, z * h, 28)
            turn = np.arctan2(ring[:, 1], ring[:, 0]) - np.pi / 2
            lip = 0.34 * r * max(0.0, (z - 0.8) / 0.2) * np.exp(-(np.arctan2(np.sin(turn), np.cos(turn)) ** 2) / 0.06)
            ring[:, :2] *= 1 + (lip / np.linalg.norm(ring[:, :2], axis=1))[:, None]
            rings.append(ring)
    d.loft(rings, look, hollow=len(shape))
    if look.opacity < 1:
        filling(d, box, shape, 0.07, 0.55, d.pick("drink", ["lemon peel", "orange peel", "frosted glass"]), 0.0045)
    d.arch((0, -0.66 * r, 0.9 * h), (0, -0.88 * r, 0.34 * h), (0, -0.8 * reach, 0.03 * h), 0.0075, look, 8)


def strip(d: Drawing, rows, look: Look, thick: float = 0.0025) -> None:
    """A flat bar along x through rows of (x, half its width, height of its underside)."""
    for pair in zip(rows[:-1], rows[1:], strict=True):
        d.hull([(x, s * w, z + t) for x, w, z in pair for s in (-1, 1) for t in (0.0, thick)], look)


SHANK = [(0.0, 0.0075, 0.0), (0.012, 0.009, 0.0), (0.05, 0.006, 0.003), (0.11, 0.0028, 0.005), (0.15, 0.0035, 0.002)]
BLADE = [(0.085, -0.006), (0.195, -0.004), (0.2, 0.002), (0.19, 0.0085), (0.1, 0.0095), (0.085, 0.006)]


def fork(d: Drawing, metal: Look) -> None:
    """A fork of 0.2 m that lies along x from the origin, its tines forward."""
    strip(d, SHANK, metal)
    strip(d, [(0.125, 0.003, 0.001), (0.145, 0.011, 0.0), (0.156, 0.0115, 0.0)], metal, 0.003)
    with d.along((0, -0.0095, 0), (0, 0.0095, 0), 4):
        strip(d, [(0.154, 0.002, 0.0), (0.18, 0.0018, 0.0), (0.2, 0.0008, 0.003)], metal)


def knife(d: Drawing, metal: Look, grip: Look | None = None) -> None:
    """A table knife of 0.2 m that lies along x from the origin."""
    strip(d, [(0.0, 0.006, 0.0), (0.004, 0.008, 0.0), (0.085, 0.006, 0.0)], grip or metal, 0.006)
    d.extrude(BLADE, (0.0, 0.002), metal)


def spoon(d: Drawing, length: float, metal: Look) -> None:
    """A spoon that lies along x from the origin, its bowl forward."""
    n = length / 0.2
    strip(d, [(x * n, w * n, z * n) for x, w, z in SHANK], metal)
    bowl = Box.sized(0.056 * n, 0.039 * n, 0.008, (0.172 * n, 0.0, 0.0))
    open_vessel(d, bowl, [(0.3, 0.0), (0.77, 0.44), (1.0, 1.0)], metal, 0.0013, 0.25)


@draws("cutlery_set", whole=True)
def cutlery_set(d: Drawing) -> None:
    """Fork, knife and spoon lying side by side."""
    metal = d.material("body", "steel, brushed steel, brass, black steel")
    grip = d.material("grip", "oak, white plastic, black plastic") if d.chance("grip", 0.3) else None
    start, w = -d.bounds.depth / 2, d.bounds.width
    with d.at(start, w / 2 - 0.012):
        fork(d, metal)
    with d.item("knife"), d.convex(box=True), d.at(start):
        knife(d, metal, grip)
    with d.item("spoon"), d.convex(box=True), d.at(start, -w / 2 + 0.02):
        spoon(d, 0.195, metal)


@draws("place_setting", whole=True)
def place_setting(d: Drawing) -> None:
    """Placemat, plate, bowl or napkin, fork, knife, spoon and a glass, laid for one who sits at +x."""
    mat = d.material("mat", "beige fabric, grey fabric, navy fabric, green fabric, rattan, rust fabric")
    glaze = d.material("plate", "white ceramic, cream ceramic, blue ceramic, grey ceramic")
    metal = d.material("cutlery", "steel, brass, black steel")
    depth, width, height = d.bounds.size
    d.box(d.bounds.bottom(0.003), mat, 0.0)
    r = min(0.135, 0.4 * depth)
    with d.at(0.02, 0.0, 0.003):
        with d.item("plate"):
            dish(d, Box.sized(2 * r, 2 * r, 0.022), glaze, "brass" if d.chance("gold", 0.3) else None)
        floor = 0.27 * 0.022  # of the plate
        if d.chance("bowl", 0.5):
            with d.item("bowl"):
                open_vessel(d, Box.sized(1.2 * r, 1.2 * r, 0.045, (0, 0, floor)), CUP, glaze, floor=0.2)
        else:
            cloth = d.material("napkin", "white fabric, mustard fabric, rose fabric, blue fabric")
            with d.item("napkin"), d.convex(box=True):
                d.cushion(Box.sized(0.12, 0.06, 0.014, (0, 0, floor)), cloth, radius=0.006)
                band = Box.sized(0.012, 0.064, 0.016, (0, 0, floor))
                d.slab(band, "brass" if d.chance("ring", 0.5) else mat, 0.003)
    tools = ("fork", fork, -r - 0.03), ("knife", knife, r + 0.03), ("spoon", partial(spoon, length=0.2), r + 0.062)
    for name, tool, y in tools:
        with d.item(name), d.convex(box=True), d.at(0.11, y, 0.003, yaw=math.pi):
            tool(d, metal=metal)
    corner = (-depth / 2 + 0.045, min(r * 0.9, width / 2 - 0.05), 0.003)
    wine = d.chance("wine", 0.5)
    with d.item("glass", "wine_glass" if wine else "drinking_glass"):
        if wine:
            goblet(d, Box.sized(0.074, 0.074, height - 0.003, corner), 0.45, 0.8, d.pick("drink", [None, "aubergine"]))
        else:
            tumbler(d, Box.sized(0.072, 0.072, 0.75 * height, corner), 0.85, "frosted glass")


@draws("napkin_holder", whole=True)
def napkin_holder(d: Drawing) -> None:
    """Napkins between two arched boards on a foot."""
    look = d.material("body", "oak, walnut, black steel, white steel, bamboo")
    napkins = d.material("napkins", "white fabric, mustard fabric, blue fabric, rose fabric")
    box, foot = d.bounds, d.bounds.bottom(0.01)
    d.box(foot, look, bevel=0.002)
    half, low = box.width / 2, box.height - 0.012 - 0.35 * box.width
    t = np.linspace(0, np.pi, 9)
    arch = [(-half, 0.008), (half, 0.008), *zip(half * np.cos(t), low + 0.35 * box.width * np.sin(t), strict=True)]
    for board in (box.inset(x=0.005).front(0.006), box.inset(x=0.005).back(0.006)):
        d.extrude(arch, board.x, look, axis="x")
    room = box.inset(x=0.012, y=0.008, bottom=0.01)
    for k, own in enumerate(room.split("x", d.integer("napkins", 8, 14), gap=0.0005)):
        d.cushion(own.inset(top=0.004 * (k % 3)), napkins, radius=0.0015)


@draws("serving_tray", whole=True)
def serving_tray(d: Drawing) -> None:
    """A tray with a low rim and two handles; things may stand in it."""
    look = d.material("body", "oak, walnut, bamboo, white paint, black paint, brushed steel")
    grip = d.material("handles", "brass, black steel") if d.chance("metal", 0.5) else look
    box = d.bounds
    rim = min(0.045, 0.8 * box.height)
    open_box(d, box.bottom(rim), look, 0.01, name="top")
    for side in ("left", "right"):
        _, y, _ = getattr(box, side)(0.01).center
        with d.part(f"wall {side}"):
            d.arch((-0.06, y, rim - 0.005), (0.06, y, rim - 0.005), (0, 0, box.height - rim), 0.005, grip)


@draws("cake_stand", whole=True, even="round")
def cake_stand(d: Drawing) -> None:
    """A round plate on a turned foot; some have beads around its edge."""
    box = d.even("round")
    look = d.material("body", "white ceramic, cream ceramic, blue ceramic, oak, marble")
    foot = [(0.42, 0.0), (0.42, 0.04), (0.3, 0.1), (0.09, 0.2), (0.07, 0.4), (0.11, 0.55), (0.08, 0.66), (0.2, 0.86)]
    d.turned(box, [*foot, (0.96, 0.9), (1.0, 0.93), (1.0, 0.985), (0.98, 1.0)], look, 32)
    if d.chance("dots", 0.5):
        with d.ring(16, 0.97 * box.width / 2):
            d.ball(Box.around((0, 0, 0.9 * box.height), 0.012, 0.012, 0.012), look, 8)
    t = (np.arange(16) + 0.5) * np.pi / 8
    d.surface("top", box, polygon=0.95 * box.width / 2 * np.c_[np.cos(t), np.sin(t)])


@draws("coaster_set", whole=True, even="round")
def coaster_set(d: Drawing) -> None:
    """Round coasters in a pile."""
    box = d.even("round")
    look = d.material("body", "cork, oak, marble, grey fabric, black leather, bamboo")
    for k, own in enumerate(box.inset(x=0.03 * box.depth, y=0.03 * box.width).rows(max(3, round(box.height / 0.007)))):
        shift = [d.uniform(f"{axis}{k}", -0.02, 0.02) * box.width for axis in "xy"]
        with d.item(f"coaster-{k}", "coaster") if k else nullcontext():
            d.cylinder(own.move(*shift), look, bevel=0.0012, segments=28)
