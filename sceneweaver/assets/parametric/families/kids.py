"""Toys, and furniture for small children."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import CORNERS, knob, legs, lip, open_box, tub, vessel, wheel
from .small_toys import ball

BRIGHT = tuple(f"{tone} plastic" for tone in ("red", "blue", "yellow", "green", "orange", "mint", "pink"))
WOODS = "birch, white paint, light oak, pine, sage paint"


@draws("toy_chest", whole=True)
def toy_chest(d: Drawing) -> None:
    """A wooden box with a lid, low feet, coloured stars and handles, or an open one."""
    wood = d.material("wood", WOODS)
    box = d.bounds
    if d.request.shape == "open":
        open_box(d, box, wood, 0.018, floor=0.02)
        return
    opens = d.chance("opens", 0.5)  # else things stand on it
    lid = box.top(0.04).inset(front=0.022 if opens else 0.0)
    case = lid.to(z=box.z).inset(x=0.012, y=0.01)
    legs(d, case.bottom(0.05).inset(x=0.005, y=0.005), wood, width=0.05)
    paint = d.material("lid", *BRIGHT, WOODS)
    if opens:
        tub(d, case.inset(bottom=0.04, top=0.042), wood, 0.018)
        with d.hinge("lid", lid.anchor("back top"), axis=(0.0, -1.0, 0.0), limits=(0.0, 1.4), role="lid"):
            d.box(lid, paint, 0.012)
            lip(d, lid.front(-0.022).place(width=0.09, height=0.016), wood)
    else:
        d.box(case.inset(bottom=0.04, top=0.045), wood, 0.004)
        d.box(lid, paint, 0.012)
        d.surface("top", lid, inset=0.02)
    for s in (-1, 1):  # handles
        y = case.y[(s + 1) // 2]
        d.arch((-0.07, y, 0.62 * box.height), (0.07, y, 0.62 * box.height), (0, s * 0.0095, 0), 0.004, "brass")
    turn = np.arange(10) * math.pi / 5
    reach = np.where(np.arange(10) % 2, 0.22, 0.5)
    star = 0.5 + np.c_[reach * np.sin(turn), reach * np.cos(turn)]
    size = min(0.13, 0.28 * box.height)
    for k, cell in enumerate(case.share(z=(0.25, 0.65)).columns(4)):
        badge = cell.front(0.01).inset(front=-0.008).place(None, size, size)
        if k % 2:
            d.cylinder(badge, BRIGHT[k], "x")
        else:
            d.silhouette(badge, star, BRIGHT[k + 2], "x")


@draws("play_kitchen", whole=True)
def play_kitchen(d: Drawing) -> None:
    """A small kitchen: hob, sink with tap, oven with window, cupboard, back with shelf and hooks."""
    wood = d.material("body", WOODS)
    front = d.material("fronts", "pink plastic, mint plastic, white paint, sage paint, sky pigment")
    box = d.bounds
    level = 0.52 * box.height
    with d.part("unit"):
        case = d.box(box.bottom(level - 0.02).inset(front=0.02), wood, 0.004)
        top = d.box(case.top(-0.02).inset(front=-0.01, bottom=-0.005), "birch", 0.004)
        cells = case.inset(y=0.01, bottom=0.04, top=0.07).columns(2, gap=0.02)
        for cell in cells:
            d.box(cell.front(-0.008).inset(back=-0.003), front, 0.004)
        oven = cells[1].front(-0.012).inset(y=0.045, bottom=0.08, top=0.1)
        d.box(oven, "black glass")
        x, _, z = oven.point(1.0, 0.5, 1.18)
        d.bar((x, oven.y[0], z), (x, oven.y[1], z), 0.007, "steel", 8)
        knob(d, cells[0].share(y=(0.88, 0.88)).inset(front=-0.008), "steel", 0.015, 0.016)
        for k, cell in enumerate(case.top(0.075).share(y=(0.56, 0.94)).columns(4)):
            knob(d, cell, BRIGHT[k], 0.017, 0.012, "white plastic")
    with d.part("back"):
        for x in (0.36, 0.72):
            plate = d.cylinder(Box.sized(0.11, 0.11, 0.006, top.point(x, 0.75, 1.0)).move(z=-0.001), "black glass")
            for inset, tone, proud in ((0.015, "red plastic", 0.0003), (0.02, "black glass", 0.0004)):
                d.print(plate.top(0.0).inset(x=inset, y=inset), tone, proud, oval=True)
        pan = Box.sized(0.09, 0.09, 0.055, plate.point(0.5, 0.5, 1.0))
        d.turned(pan, [(0.88, 0), (1, 0.9), (1, 1), (0.92, 1), (0.85, 0.15), (0, 0.15)], "red plastic", 16, hollow=True)
        d.bar(pan.point(0.5, 0.0, 0.8), (pan.center[0], pan.y[0] - 0.09, pan.z[1]), 0.007, "birch", 8)
        sink = Box.sized(0.2, 0.2, 0.006, top.point(0.5, 0.25, 1.0)).move(z=-0.001)
        d.turned(sink, [(1, 0), (1, 1), (0.86, 1), (0.8, 0.3), (0, 0.3)], "steel", hollow=True)
        tap = [(0.06, 0.0), (0.06, 0.13), (0.11, 0.16), (0.16, 0.12)]
        d.sweep([(top.x[0] + x + 0.02, sink.center[1], level + z) for x, z in tap], 0.011, "chrome", 8)
        wall = d.box(box.inset(bottom=level - 0.01).back(0.018), wood)
        frame = wall.inset(front=-0.122)
        shelf = frame.share(z=(0.54, 0.57))
        for part in (frame.left(0.018), frame.right(0.018), frame.top(0.02), shelf):
            d.box(part, wood)
        for k, cell in enumerate(frame.share(y=(0.15, 0.85), z=(0.2, 0.5)).columns(4)):
            x, y, z = cell.point(0.12, 0.5, 0.85)
            d.bar((x, y, z - 0.1), (x, y, z), 0.008, BRIGHT[k], 6)
            d.cylinder(Box.around((x, y, z - 0.12), 0.01, 0.056, 0.056), BRIGHT[k], "x", segments=12)


@draws("doll_house", whole=True)
def doll_house(d: Drawing) -> None:
    """A house without a front: papered rooms with tiny furniture, side windows, a tiled roof, a chimney, steps."""
    wall = d.material("walls", "pink plastic, white paint, mint plastic, cream paint, sky pigment")
    tiles = d.material("roof", "red paint, teal paint, lilac plastic, navy paint")
    box = d.bounds
    d.box(box.bottom(0.02), "moss pigment")
    house = box.inset(bottom=0.02, y=0.05).share(z=(0.0, 0.62)).inset(front=0.05)
    d.box(house.back(0.008), wall, 0.0)
    trim = "white paint" if not wall.called("white paint") else "sky pigment"
    middle = house.share(y=(0.54, 0.54)).inset(y=-0.005)
    for side in (house.left(0.01), house.right(0.01), middle):
        d.box(side.inset(back=0.008), wall, 0.001)
        d.box(side.front(-0.006).inset(y=-0.003), trim, 0.001)
    for z in (0.0, 0.5, 1.0):
        floor = d.box(house.share(z=(z, z)).inset(bottom=-0.005, top=-0.005, back=0.008), "birch", 0.001)
        d.box(floor.front(-0.007).inset(z=-0.002), trim, 0.001)
    papers = ("ochre pigment", "blush pigment", "sky pigment", "sage paint")
    inner = house.inset(y=0.01, bottom=0.005)
    rooms = [half for storey in inner.rows(2, gap=0.01) for half in storey.columns([0.54, 0.46], gap=0.01)]
    for room, paper in zip(rooms, papers, strict=True):
        back = room.back(0.008).front(0.0)
        d.print(back, paper)
        _window(d, back.share(y=(0.32, 0.68), z=(0.4, 0.85)), trim)
    for side in (house.left(0.0), house.right(0.0)):
        for x, z in ((0.25, 0.15), (0.75, 0.15), (0.25, 0.65), (0.75, 0.65)):
            _window(d, side.share(x=(x - 0.13, x + 0.13), z=(z, z + 0.22)), trim)
    _dolls_rooms(d, rooms)
    roof = box.to(z=(house.z[1], box.z[1]))
    attic = house.share(y=(0.03, 0.97)).to(z=(house.z[1], box.z[1] - 0.03))
    gable = d.silhouette(attic.back(0.01), [(0, 0), (1, 0), (0.5, 1)], wall, "x")
    d.print(gable.front(0.0).share(y=(0.38, 0.62), z=(0.2, 0.62)), trim, 0.0003, oval=True)
    d.print(gable.front(0.0).share(y=(0.41, 0.59), z=(0.25, 0.57)), "sky pigment", 0.0004, oval=True)
    d.ball(Box.sized(0.05, 0.05, 0.05, attic.point(0.4, 0.35, 0.0)), "brown leather", segments=10)
    run, rise = roof.width / 2, roof.height
    slope, pitch = math.hypot(run, rise), math.atan2(rise, run)
    with d.mirror("y"), d.at(0.0, run, house.z[1] - 0.004, roll=-pitch):
        # Along its own -y a slope rises to the ridge.
        board = Box(roof.x, (-slope, 0.0), (-0.012, 0.0))
        d.box(board, tiles, 0.001)
        for k, row in enumerate(board.columns(7)):
            d.box(row.top(-0.004).inset(right=-0.004, left=0.002 * k, back=-0.002, front=-0.002), tiles, 0.0015)
    d.box(roof.share((0.25, 0.45), (0.68, 0.78), (0.35, 0.97)), "terracotta")
    d.box(roof.share((0.22, 0.48), (0.665, 0.795), (0.93, 1.0)), "white paint", 0.002)
    for k, step in enumerate(box.front(0.05).share(y=(0.62, 0.8)).split("x", 2)):
        d.box(step.bottom(0.016 - 0.008 * k).move(z=0.02), "granite", 0.001)


def _window(d: Drawing, place: Box, frame: Look) -> None:
    """A printed window with a cross of bars on a wall."""
    flat = place.size.index(min(place.size))
    d.print(place, frame)
    y, x = (((0.08, 0.46), (0.54, 0.92)), ((0.0, 1.0),)) if flat == 0 else (((0.0, 1.0),), ((0.08, 0.46), (0.54, 0.92)))
    for xs in x:
        for ys in y:
            for zs in ((0.06, 0.48), (0.54, 0.94)):
                d.print(place.share(xs, ys, zs), "sea pigment", 0.0004)


def _dolls_rooms(d: Drawing, rooms: list[Box]) -> None:
    """Kitchen and living room below, bathroom and bedroom above, each with what tells it."""
    kitchen, living, bath, bedroom = (room.inset(back=0.012, y=0.006) for room in rooms)
    d.box(kitchen.share((0.0, 0.24), (0.0, 0.5), (0.0, 0.4)), "white paint", 0.002)
    d.box(kitchen.share((0.0, 0.26), (0.0, 0.5), (0.4, 0.44)), "walnut", 0.001)
    d.box(kitchen.share((0.0, 0.24), (0.55, 0.75), (0.0, 0.75)), "mint plastic", 0.003)
    table = kitchen.share((0.45, 0.85), (0.25, 0.75), (0.0, 0.36))
    d.cylinder(table.top(0.008), "red plastic")
    d.cylinder(table.inset(top=0.008).place(0.02, 0.02), "birch", segments=10)
    with d.at(*table.center[:2]), d.ring(2, 0.5 * table.width, math.pi / 2):
        d.cylinder(Box.sized(0.04, 0.04, 0.2 * kitchen.height, (0.02, 0, kitchen.z[0])), "blue plastic", segments=12)
    sofa = living.share((0.0, 0.36), (0.1, 0.75))
    d.box(sofa.share(z=(0.0, 0.2)), "yellow plastic", 0.004)
    d.box(sofa.share(x=(0.0, 0.3), z=(0.2, 0.45)), "yellow plastic", 0.004)
    for arm in (sofa.left(0.012), sofa.right(0.012)):
        d.box(arm.share(z=(0.0, 0.32)), "yellow plastic", 0.004)
    d.slab(living.share((0.3, 0.9), (0.1, 0.8)).bottom(0.002), "rose fabric", 0.02)
    d.cylinder(living.share(x=(0.2, 0.2), y=(0.9, 0.9), z=(0.0, 0.6)).inset(x=-0.004, y=-0.004), "brass", segments=8)
    lamp = living.share(x=(0.2, 0.2), y=(0.9, 0.9), z=(0.55, 0.75)).inset(x=-0.02, y=-0.02)
    d.cylinder(lamp, "lit shade", ends=(1.0, 0.6))
    tub = bath.share((0.15, 0.5), (0.1, 0.75), (0.0, 0.32))
    d.sections(tub, [(0.8, 0.85, 0), (1, 1, 1), (0.85, 0.9, 1), (0.7, 0.8, 0.3)], "white ceramic", 0.4, hollow=2)
    d.box(bath.share((0.0, 0.15), (0.8, 0.98), (0.0, 0.4)), "white ceramic", 0.004)
    bed = bedroom.share((0.1, 0.62), (0.05, 0.8))
    d.box(bed.share(z=(0.0, 0.16)), "pine", 0.002)
    d.box(bed.right(0.008).share(z=(0.0, 0.5)), "pine", 0.002)
    d.cushion(bed.share((0.05, 0.95), (0.06, 0.96), (0.14, 0.3)), "white fabric", 0.006)
    d.cushion(bed.share((0.0, 1.0), (0.36, 1.0), (0.2, 0.33)), "blue fabric", 0.006)
    d.cushion(bed.share((0.2, 0.8), (0.08, 0.3), (0.28, 0.4)), "rose fabric", 0.008)
    d.box(bedroom.share((0.0, 0.25), (0.86, 1.0), (0.0, 0.6)), "lilac plastic", 0.003)


@draws("rocking_horse", whole=True)
def rocking_horse(d: Drawing) -> None:
    """A wooden horse with mane, saddle and handle bar on two curved runners."""
    wood = d.material("wood", "light oak, birch, pine, white paint")
    hair = d.material("hair", "mahogany, black fabric, cream paint, brown leather")
    box = d.bounds
    deep, wide, high = box.size
    with d.mirror("y"):
        t = np.linspace(-1, 1, 9)
        d.sweep([(0.5 * deep * u, 0.4 * wide, 0.02 + 0.1 * u**4) for u in t], 0.02, wood, 8)
        for hip, foot in ((0.18, 0.3), (-0.2, -0.3)):
            d.bar((hip * deep, 0.2 * wide, 0.48 * high), (foot * deep, 0.4 * wide, 0.05), (0.045, 0.045), wood)
        d.silhouette(box.share((0.7, 0.76), (0.55, 0.62), (0.91, 1.0)), [(0, 0), (1, 0), (0.5, 1)], wood)  # an ear
        ball(d, (0.32 * deep, 0.056, 0.85 * high), (0.012, 0.003, 0.012), "black plastic", 8)
        d.bar((0.22 * deep, 0, 0.76 * high), (0.22 * deep, 0.38 * wide, 0.76 * high), 0.014, "red plastic", 8)
    for x in (-0.3, 0.3):
        d.bar((x * deep, -0.4 * wide, 0.07), (x * deep, 0.4 * wide, 0.07), 0.014, wood, 8)
    z = 0.52 * high
    body = Box((-0.28 * deep, 0.26 * deep), (-0.27 * wide, 0.27 * wide), (z - 0.1, z + 0.08))
    d.cushion(body, wood, 0.07)
    core = box.place(width=0.11)
    neck = [(0.6, 0.52), (0.76, 0.52), (0.83, 0.82), (0.76, 0.92), (0.67, 0.9)]
    d.silhouette(core.inset(y=0.005), neck, wood, bevel=0.015)
    d.silhouette(core, [(0.72, 0.78), (0.94, 0.7), (0.97, 0.78), (0.8, 0.95), (0.7, 0.95)], wood, bevel=0.015)
    d.silhouette(core.inset(y=0.035), [(0.56, 0.62), (0.63, 0.62), (0.71, 0.97), (0.65, 0.95)], hair, bevel=0.008)
    d.sweep([(-0.26 * deep, 0, z + 0.03), (-0.38 * deep, 0, z + 0.02), (-0.42 * deep, 0, z - 0.16)], 0.03, hair, 8)
    saddle = d.cushion(body.share(x=(0.22, 0.63)).inset(y=-0.02 * wide).to(z=(z, z + 0.1)), "red plastic", 0.04)
    d.box(saddle.back(0.025).share(y=(0.15, 0.85)).to(z=(z + 0.05, z + 0.2)), wood, 0.012)


@draws("play_tent", whole=True, even="round")
def play_tent(d: Drawing) -> None:
    """A tipi of cloth on crossed poles, open in front, with flags and a mat."""
    cloth = d.material("cloth", "white fabric, beige fabric, grey fabric, rose fabric, sky pigment")
    box = d.even("round")
    high = box.height
    apex, k = 0.82 * high, box.depth / 2 - 0.02  # where the poles cross, half of their spread on the floor
    for sx in (-1, 1):
        for sy in (-1, 1):
            over = 1 - high / apex
            d.bar((sx * k, sy * k, 0.0), (sx * k * over, sy * k * over, high), 0.012, "pine", 6)
    top, q, t = 0.92 * apex, 0.08 * k, 0.012

    def wall(low: list[tuple[float, float]], head: list[tuple[float, float]]) -> None:
        d.hull([(x, y, 0.01) for x, y in low] + [(x, y, top) for x, y in head], cloth)

    wall([(x, s * k) for x in (-k, t - k) for s in (-1, 1)], [(x, s * q) for x in (-q, t - q) for s in (-1, 1)])
    with d.mirror("y"):
        wall([(x, y) for x in (-k, k) for y in (k, k - t)], [(x, y) for x in (-q, q) for y in (q, q - t)])
        wall([(x, y) for x in (k, k - t) for y in (k, 0.5 * k)], [(x, y) for x in (q, q - t) for y in (q, 0)])
    d.cushion(Box.sized(1.7 * k, 1.7 * k, 0.05), "grey fabric", 0.02)
    x = k * (1 - 0.42 / 0.82) + 0.004
    for j, cell in enumerate(Box((x, x + 0.003), (-0.5 * k, 0.5 * k), (0.34 * high, 0.34 * high + 0.08)).columns(5)):
        d.silhouette(cell.inset(y=0.01), [(0, 1), (1, 1), (0.5, 0)], BRIGHT[j], "x")


@draws("slide", whole=True)
def slide(d: Drawing) -> None:
    """A ladder, a platform and a curved chute with raised edges; children come down to the front."""
    chute = d.material("chute", *BRIGHT)
    frame = d.material("frame", *BRIGHT, "pine")
    box = d.bounds
    deep, wide, high = box.size
    level, x = 0.72 * high, box.x[0] + 0.24 * deep
    path = [(x, level), (x + 0.14 * deep, 0.93 * level), (x + 0.5 * deep, 0.32 * level)]
    path += [(box.x[1] - 0.14, 0.09), (box.x[1], 0.07)]
    for (xa, za), (xc, zc) in zip(path[:-1], path[1:], strict=True):
        for y0, y1, low, top in ((-0.38, 0.38, -0.03, 0.0), (0.36, 0.44, -0.035, 0.09), (-0.44, -0.36, -0.035, 0.09)):
            ends = [(px, y * wide, pz + e) for px, pz in ((xa, za), (xc, zc)) for y in (y0, y1) for e in (low, top)]
            d.hull(ends, chute)
    foot = box.x[0] + 0.03
    bar = (0.05, 0.05)
    with d.mirror("y"):
        y = 0.42 * wide
        d.bar((foot, wide / 2 - 0.03, 0.01), (x - 0.04, y, level), bar, frame)
        d.bar((x + 0.12 * deep, wide / 2 - 0.03, 0.01), (x, y, level - 0.03), bar, frame)
        rail = [(-0.05, level - 0.02), (-0.06, high - 0.03), (0.03, high - 0.018), (0.12 * deep, level + 0.04)]
        d.sweep([(x + px, y, pz) for px, pz in rail], 0.018, frame, 8)
    for u in (0.3, 0.6, 0.9):
        rung = Box.around((foot + u * (x - 0.04 - foot), 0, u * level), 0.1, 0.84 * wide, 0.03)
        d.box(rung, frame, 0.006)
    d.box(box.front(0.3).back(0.1).bottom(0.08).share(y=(0.08, 0.92)), chute, 0.01)


@draws("toy_shelf", whole=True)
def toy_shelf(d: Drawing) -> None:
    """A low frame with three rows of tilted coloured bins."""
    wood = d.material("frame", WOODS)
    box = d.bounds
    deep, wide, high = box.size
    sides = [(0, 0), (1, 0), (1, 0.25), (0.1 / deep, 1), (0, 1)]
    for side in (box.left(0.02), box.right(0.02)):
        d.silhouette(side, sides, wood)
    tall = min(0.14, (high - 0.2) / 3 - 0.06)
    for k in range(3):
        x, z = box.x[1] - 0.03 - k * (deep - 0.32) / 2.75, 0.08 + k * (high - 0.16) / 3
        for e in (0.06, 0.24):
            d.cylinder(Box.around((x - e, 0, z + 0.02 + e / 4), 0.024, wide - 0.02, 0.024), wood, "y", segments=8)
        with d.at(x - 0.28, 0.0, z + 0.095, pitch=0.24):
            row = Box((0.0, 0.28), (0.03 - wide / 2, wide / 2 - 0.03), (0.0, tall))
            for i, cell in enumerate(row.columns(3 if wide < 0.8 else 4, gap=0.014)):
                low, inner = cell.inset(x=0.02, y=0.01), cell.inset(x=0.008, y=0.008)
                floor = low.inset(x=0.008, y=0.008).move(z=0.006)
                rims = [(low, low.z[0]), (cell, tall), (inner, tall), (floor, floor.z[0])]
                rings = [shapes.rectangle(one.x, one.y, z, 0.02) for one, z in rims]
                vessel(d, rings[:2], rings[2:], BRIGHT[(i + 2 * k) % 7], CORNERS)
                for j, y in enumerate((0.24, 0.5, 0.76)):
                    at = cell.point(0.25 + 0.2 * j, y, 0.85)
                    ball(d, at, 0.035, BRIGHT[(i + k + j + 3) % 7], 8)


@draws("easel", whole=True)
def easel(d: Drawing) -> None:
    """A child's A-frame easel: a white board with a drawing, a blackboard behind, a tray of paints."""
    wood = d.material("wood", "pine, birch, light oak, white paint")
    box = d.bounds
    deep, wide, high = box.size
    level = 0.42 * high
    lean = math.atan2(deep / 2 - 0.03, high)
    with d.mirror("x", "y"):
        d.bar((deep / 2 - 0.02, wide / 2 - 0.02, 0.01), (0.015, wide / 2 - 0.02, high - 0.01), (0.03, 0.03), wood)
    for sign, look in ((1, "white plastic"), (-1, "forest pigment")):
        x = sign * ((deep / 2 - 0.02) * (1 - level / high) + 0.01)
        with d.at(x, 0.0, level, pitch=-lean * sign):
            board = d.box(Box.sized(0.012, wide - 0.07, 0.95 * (high - level)), look, 0.002)
            if sign < 0:
                for k, z in enumerate((0.3, 0.42, 0.54)):  # chalk
                    d.print(board.back(0.0).share(y=(0.2, 0.6 + 0.1 * k), z=(z, z + 0.02)), "chalk pigment")
                continue
            sheet = d.box(board.front(-0.002).share(y=(0.08, 0.92), z=(0.08, 0.92)), "paper", 0.0).front(0.0)
            d.print(sheet.share(z=(0.0, 0.22)), "green plastic")
            d.print(sheet.share(y=(0.22, 0.5), z=(0.22, 0.52)), "red plastic")
            with d.no_colliders():
                roof = sheet.share(y=(0.16, 0.56), z=(0.52, 0.74)).inset(front=-0.0004, back=-0.001)
                d.silhouette(roof, [(0, 0), (1, 0), (0.5, 1)], "blue plastic", "x")
            d.print(sheet.share(y=(0.7, 0.7), z=(0.76, 0.76)).inset(y=-0.05, z=-0.05), "yellow petal", oval=True)
    tray = d.box(box.share(x=(0.25, 0.92)).inset(y=0.03).to(z=(level - 0.05, level - 0.03)), wood)
    for k, cell in enumerate(tray.front(0.07).share(y=(0.12, 0.88)).columns(5)):
        pot = cell.top(-0.06).place(0.054, 0.054)
        d.cylinder(pot, BRIGHT[k], segments=12)
        d.cylinder(pot.top(-0.01).inset(0.006, z=-0.006), "white plastic", segments=12)


@draws("activity_table", whole=True)
def activity_table(d: Drawing) -> None:
    """A small round-legged table with blocks, arches of wire with beads, and gears."""
    wood = d.material("wood", WOODS)
    box = d.bounds
    table = box.inset(top=0.2)
    deep, wide, level = table.depth, table.width, table.z[1]
    with d.part("table"):
        d.slab(table.top(0.03), wood, 0.04, 0.006)
        for k, (x, y) in enumerate(((-1, -1), (-1, 1), (1, -1), (1, 1))):
            leg = Box.sized(0.06, 0.06, level - 0.03, (x * (deep / 2 - 0.05), y * (wide / 2 - 0.05), 0.0))
            d.cylinder(leg, BRIGHT[k], ends=(0.66, 1.0), segments=14)
    with d.part("toys"):
        t = np.linspace(0, 1, 13)
        for k, y in enumerate((-0.06, 0.06)):
            wave = 0.16 * np.sin(np.pi * t) + 0.02 * np.sin(18 * t + k) * np.sin(np.pi * t)
            path = np.c_[(0.6 * t - 0.3) * deep, 0 * t + y, level + 0.005 + wave]
            d.sweep(path, 0.004, BRIGHT[k + 3], 6)
            for j in (3, 4, 8, 9):
                ball(d, tuple(path[j]), 0.02, BRIGHT[(j + k) % 7], 8)
        for x, y, r, tone in ((0.0, 0.3, 0.07, "red plastic"), (0.1, 0.36, 0.045, "blue plastic")):
            with d.at(x, y * wide, level):
                d.cylinder(Box.sized(1.7 * r, 1.7 * r, 0.02), tone, segments=12)
                with d.ring(8, 0.85 * r):
                    d.box(Box.sized(0.3 * r, 0.22 * r, 0.018), tone, 0.002)
        for k in range(5):
            x, y, z = -0.08 + 0.06 * (k // 2 % 2), -0.34 * wide + 0.055 * (k % 2), level + (0.05 if k == 4 else 0.0)
            d.box(Box((x, x + 0.05), (y, y + 0.05), (z, z + 0.05) if k < 4 else (z, box.z[1])), BRIGHT[k], 0.004)


@draws("play_mat", whole=True)
def play_mat(d: Drawing) -> None:
    """Puzzle tiles of foam in bright colours."""
    sets = [("red", "yellow", "blue", "green"), ("mint", "white", "grey", "pink")]
    looks = [f"{tone} plastic" for tone in d.pick("set", sets)]
    d.material("tiles", looks[0])
    for i, row in enumerate(d.bounds.split("x", max(2, round(d.size.depth / 0.33)))):
        for j, tile in enumerate(row.columns(max(2, round(d.size.width / 0.33)))):
            d.box(tile.inset(front=0.001, left=0.001), looks[(i + 2 * j) % 4], 0.002)


@draws("ball_pit", whole=True, even="round")
def ball_pit(d: Drawing) -> None:
    """A padded round pool full of bright balls."""
    cloth = d.material("rim", "grey fabric, beige fabric, rose fabric, blue fabric")
    box = d.even("round")
    r, top = box.depth / 2, 0.97 * box.height
    d.turned(box.bottom(top), [(0.97, 0), (1, 0.05), (1, 0.93), (0.98, 1), (0.86, 1)], cloth, 28)
    for ring, (share, count) in enumerate(((0.12, 4), (0.28, 10), (0.46, 15), (0.63, 20), (0.78, 24))):
        for j in range(count):
            a = j * 2 * math.pi / count + 7 * share
            ball(d, (r * share * math.cos(a), r * share * math.sin(a), top), 0.038, BRIGHT[(ring * 5 + j * 3) % 7], 6)


@draws("kids_car", whole=True)
def kids_car(d: Drawing) -> None:
    """A ride-on car: body, bonnet, wheels, steering wheel, seat, headlights."""
    paint = d.material("body", *BRIGHT)
    box = d.bounds
    deep, wide, high = box.size
    z = 0.55 * high
    d.cushion(box.share(y=(0.08, 0.92)).to(z=(0.09, 0.8 * z)), paint, 0.05)
    d.cushion(box.share((0.62, 0.96), (0.12, 0.88)).to(z=(0.5 * z, z)), paint, 0.05)
    d.cushion(box.share((0.04, 0.3), (0.12, 0.88)).to(z=(0.5 * z, 0.72 * high)), paint, 0.05)
    d.cushion(box.share((0.28, 0.56), (0.24, 0.76)).to(z=(0.7 * z, 0.84 * z)), "black plastic", 0.02)
    with d.mirror("y"):
        for x in (0.2, 0.8):
            wheel(d, box.left(0.08).bottom(0.21).share(x=(x, x)).inset(x=-0.105), "rubber", "white plastic")
        d.cylinder(Box.around((0.46 * deep, 0.25 * wide, 0.78 * z), 0.03, 0.08, 0.08), "lamp glow", "x")
        d.box(Box.around((-0.455 * deep, 0.25 * wide, 0.64 * high), 0.01, 0.06, 0.03), "red petal", 0.003)
    d.bar((0.14 * deep, 0, 0.9 * z), (0.06 * deep, 0, high - 0.07), 0.014, "black plastic", 8)
    with d.at(0.05 * deep, 0.0, high - 0.075, pitch=-0.6):
        d.hoop(Box.around((0, 0, 0), 0.2, 0.2, 0.0), 0.014, "black plastic", steps=16)
        d.box(Box.around((0, 0, 0), 0.2, 0.028, 0.016), "black plastic")
    d.box(Box((0.45 * deep, deep / 2 + 0.004), (-0.2 * wide, 0.2 * wide), (0.16, 0.24)), "black plastic", 0.006)
