"""Toys."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.box import Vec3
from ...drawing.components import wheel
from ...drawing.tree import pose

BRIGHT = ("red plastic", "blue plastic", "yellow plastic", "green plastic", "orange plastic")
RAINBOW = (*(f"{c} plastic" for c in ("red", "orange", "yellow", "green", "blue", "lilac", "pink")), "teal paint")


def ball(d: Drawing, at: Vec3, radii: Vec3 | float, look: Look, segments: int = 12) -> Box:
    """An ellipsoid of these half axes about a point."""
    x, y, z = (radii, radii, radii) if isinstance(radii, float) else radii
    return d.ball(Box.around(at, 2 * x, 2 * y, 2 * z), look, segments=segments)


def eyes(d: Drawing, x: float, y: float, z: float, r: float) -> None:
    """Two black eyes that look to the front."""
    with d.mirror("y"):
        ball(d, (x, y, z), (0.5 * r, r, r), "ink pigment", 8)


@draws("building_blocks", whole=True)
def building_blocks(d: Drawing) -> None:
    """A tower and some loose wooden blocks: cubes, an arch, a roof, a pillar."""
    s = d.size.height / 3
    tones = ["red paint", "blue paint", "yellow paint", "green paint", "beech", "teal paint"]
    c = [d.pick(f"c{k}", tones) for k in range(9)]
    d.material("body", "beech, pine")
    floor = d.bounds.bottom(0.0)
    tower = floor.place(s, 2.5 * s, at="back right").inset(top=-s)
    d.box(tower.right(s), c[0])
    with d.item("cube-1", "block"):
        d.box(tower.left(s), c[1])
    with d.item("beam", "block"):
        beam = d.box(tower.top(-0.5 * s).inset(x=0.05 * s, y=0.2 * s), c[2])
    with d.item("pillar", "block"):
        d.cylinder(beam.top(-0.8 * s).place(0.84 * s, 0.84 * s), c[3], bevel=0.002)
    with d.item("roof", "block"):
        d.cylinder(beam.top(-1.5 * s).place(0.9 * s, 0.9 * s).inset(bottom=0.8 * s), c[4], ends=(1.0, 0.06))
    (x0, x1), (y0, y1) = floor.x, floor.y
    with d.item("cube-2", "block"), d.at(x1 - 0.6 * s, y0 + 0.8 * s, yaw=0.5):
        cube = d.box(Box.sized(0.9 * s, 0.9 * s, 0.9 * s), c[5])
        d.print(cube.front(0.0).share(y=(0.25, 0.75), z=(0.25, 0.75)), "paper")
    with d.item("gable", "block"), d.at(x1 - 0.8 * s, y0 + 2.5 * s, yaw=-0.35):
        d.silhouette(Box.sized(0.9 * s, 1.4 * s, 0.75 * s), [(0, 0), (1, 0), (0.5, 1)], c[6], "x")
    with d.item("arch", "block"), d.at(x0 + 0.5 * s, y1 - 0.7 * s, yaw=0.2):
        t = np.linspace(0, np.pi, 9)
        arch = [(0, 0), *np.c_[0.5 - 0.26 * np.cos(t), 0.6 * np.sin(t)], (1, 0), (1, 1), (0, 1)]
        d.silhouette(Box.sized(0.6 * s, 1.4 * s, 0.9 * s), arch, c[7], "x")
    with d.at(x1 - 0.42 * s, y1 - 0.5 * s, yaw=2.0):
        d.cylinder(Box.sized(s, 0.84 * s, 0.84 * s), c[8], "x", bevel=0.002)


@draws("toy_car", whole=True)
def toy_car(d: Drawing) -> None:
    """A car with a cabin, windows, lamps and fat wheels; some are trucks."""
    look = d.material("body", *BRIGHT, "mint plastic")
    deep, wide, high = d.size
    r = (0.22 if d.chance("flat", 0.4) else 0.26) * high
    body = d.bounds.inset(y=0.004, bottom=0.75 * r)
    low, top = 0.08 * high / body.height, (0.6 * high - 0.75 * r) / body.height
    rows = [(0.96, 0.96, 0), (1, 1, low), (0.98, 0.98, 0.85 * top), (0.9, 0.9, top)]
    d.sections(body, rows, look, 0.3, convex=True)
    d.box(body.front(0.0).inset(front=-0.001, back=-0.02, z=-0.001).share(y=(0.2, 0.8), z=(0.18, 0.3)), "chrome", 0.001)
    if d.chance("truck", 0.35):
        cab = d.box(d.bounds.share((0.55, 0.84), (0.06, 0.94), (0.5, 1.0)), d.pick("cab", BRIGHT), 0.006)
        d.print(cab.front(0.0).share(y=(0.12, 0.88), z=(0.36, 0.74)), "black glass")
        for side in (cab.left(0.0), cab.right(0.0)):
            d.print(side.share(x=(0.2, 0.8), z=(0.36, 0.74)), "black glass")
        bed = d.bounds.share((0.02, 0.53), (0.06, 0.94), (0.55, 0.82))
        for side in (bed.left(0.006), bed.right(0.006), bed.back(0.03 * deep)):
            d.box(side, "yellow plastic", 0.001)
        for k, sack in enumerate(bed.inset(front=0.02).split("x", 3)):
            d.ball(sack.place(width=0.5 * bed.width, at="left" if k % 2 else "right"), "cardboard", segments=8)
    else:
        cabin = d.bounds.share(x=(0.1, 0.76), z=(0.55, 1.0))
        shape = [(1, 0.86, 0), (0.73, 0.76, 0.78, -0.06, 0), (0.6, 0.64, 1, -0.07, 0)]
        d.sections(cabin, shape, look, 0.1, convex=True)
        d.sections(cabin, [(0.93, 0.865, 0.16, -0.01, 0), (0.77, 0.79, 0.7, -0.05, 0)], "black glass", 0.1)
    with d.mirror("y"):
        lamp = body.front(0.012).share((0, 1), (0.8, 0.8), (0.4, 0.4))
        d.cylinder(lamp.inset(y=-0.09 * high, z=-0.09 * high), "lamp glow", "x")
        for x in (0.2, 0.8):
            tyre = d.bounds.left(0.2 * wide).bottom(2 * r).share(x=(x, x)).inset(x=-r)
            wheel(d, tyre)


@draws("toy_train", whole=True)
def toy_train(d: Drawing) -> None:
    """An engine with a chimney and two wagons with a load."""
    c = [d.material("body", *BRIGHT), d.pick("second", BRIGHT), d.pick("third", BRIGHT)]
    r = 0.16 * d.size.height
    for k, cell in enumerate(reversed(d.bounds.split("x", 3))):
        car = cell.share(x=(0.07, 0.93))
        floor = d.box(car.share(y=(0.1, 0.9)).bottom(1.2 * r).top(-0.1 * car.height), "beech", 0.002)
        with d.mirror("y"):
            for x in (0.2, 0.8):
                tyre = car.left(0.16 * car.width).bottom(2 * r).share(x=(x, x)).inset(x=-r)
                wheel(d, tyre, c[(k + 1) % 3], "beech")
        if k < 2:
            x, y, z = floor.anchor("back")
            d.bar((x + 0.002, y, z), (x - 0.16 * cell.depth, y, z), 0.003, "steel", 6)
        room = car.inset(bottom=floor.z[1])
        if k == 0:
            boiler = room.share((0.34, 1.0), (0.0, 1.0), (0.0, 0.62)).place(width=0.62 * room.height)
            d.cylinder(boiler.inset(front=0.01), c[0], "x", bevel=0.003)
            d.cylinder(boiler.front(0.012).inset(y=0.03 * car.width, z=0.1 * room.height), "yellow plastic", "x")
            cab = d.box(room.share((0.0, 0.38), (0.1, 0.9), (0.0, 0.82)), c[0])
            d.box(cab.top(-0.08 * room.height).inset(x=-0.05 * car.depth, y=-0.06 * car.width), c[1])
            for side in (cab.left(0.0), cab.right(0.0)):
                d.print(side.share(x=(0.2, 0.8), z=(0.5, 0.86)), "black glass")
            chimney = room.share(x=(0.82, 0.82), z=(0.55, 1.0)).place(0.24 * car.height, 0.24 * car.height)
            d.turned(chimney, [(0.55, 0), (0.55, 0.6), (1, 1)], c[1], 16)
            continue
        tub = d.box(room.share(y=(0.08, 0.92), z=(0.0, 0.36)), c[k], 0.002)
        if k == 1:
            for log in tub.share(x=(0.06, 0.94)).top(-0.22 * car.width).inset(y=0.06 * car.width).columns(3):
                d.cylinder(log.move(z=-0.03 * car.width), "bark", "x", segments=10)
        else:
            for j, crate in enumerate(tub.share((0.08, 0.92), (0.15, 0.85)).split("x", 2, gap=0.004)):
                d.box(crate.top(-(0.2 - 0.08 * j) * car.height), c[(j + 1) % 3])


@draws("plush_toy", "teddy_bear", whole=True)
def plush_toy(d: Drawing) -> None:
    """A soft rabbit, bear or elephant that sits, with a ribbon; or a big bear."""
    deep, wide, high = d.size
    fur = d.material("fur", "beige fabric, white fabric, grey fabric, brown leather, rose fabric, blue fabric")
    pale = d.material("belly", "white fabric, sand pigment")
    ribbon = d.material("ribbon", "red fabric, blue fabric, mustard fabric, green fabric")
    kind = "bear" if d.category.name == "teddy_bear" else d.pick("kind", ["rabbit", "bear", "elephant"])
    top = high * (0.7 if kind == "rabbit" else 0.95)
    r, x = 0.26 * top, -0.12 * deep
    z = top - r
    ball(d, (x, 0, 0.3 * top), (0.36 * deep, 0.36 * wide, 0.3 * top), fur, 18)
    ball(d, (x + 0.1 * deep, 0, 0.28 * top), (0.3 * deep, 0.26 * wide, 0.22 * top), pale, 16)
    ball(d, (x + 0.02 * deep, 0, z), (0.95 * r, 1.05 * r, r), fur, 18)
    ball(d, (x + 0.75 * r, 0, z - 0.25 * r), (0.45 * r, 0.5 * r, 0.38 * r), pale, 14)
    ball(d, (x + 1.18 * r, 0, z - 0.12 * r), (0.12 * r, 0.16 * r, 0.1 * r), "ink pigment", 10)
    eyes(d, x + 0.86 * r, 0.42 * r, z + 0.22 * r, 0.1 * r)
    ear = 0.5 * (high - z - 0.7 * r)
    neck, bow = z - 0.9 * r, x + max(0.8 * r, 0.28 * deep)
    with d.mirror("y"):
        ball(d, (0.25 * deep, 0.3 * wide, 0.13 * top), (0.24 * deep, 0.15 * wide, 0.13 * top), fur, 14)
        ball(d, (0.475 * deep, 0.3 * wide, 0.13 * top), (0.03 * deep, 0.08 * wide, 0.07 * top), pale, 10)
        with d.at(x + 0.1 * deep, 0.36 * wide, 0.4 * top, roll=0.5, pitch=0.5):
            ball(d, (0, 0, -0.06 * top), (0.1 * deep, 0.1 * wide, 0.17 * top), fur, 14)
        if kind == "rabbit":
            with d.at(x, 0.4 * r, z + 0.7 * r, roll=-0.16):
                ball(d, (0, 0, 0.84 * ear), (0.16 * r, 0.3 * r, 1.2 * ear), fur, 14)
                ball(d, (0.1 * r, 0, 0.84 * ear), (0.08 * r, 0.17 * r, 0.9 * ear), "rose fabric")
        elif kind == "bear":
            ball(d, (x, 0.8 * r, z + 0.75 * r), (0.2 * r, 0.36 * r, 0.36 * r), fur, 14)
            ball(d, (x + 0.13 * r, 0.8 * r, z + 0.75 * r), (0.12 * r, 0.22 * r, 0.22 * r), pale)
        else:
            ball(d, (x - 0.1 * r, 1.15 * r, z + 0.1 * r), (0.12 * r, 0.6 * r, 0.65 * r), fur, 16)
        ball(d, (bow, 0.3 * r, neck), (0.1 * r, 0.32 * r, 0.2 * r), ribbon, 10)
    ball(d, (bow + 0.05 * r, 0, neck), (0.14 * r, 0.12 * r, 0.13 * r), ribbon, 8)
    if kind == "elephant":
        trunk = [(0.8, -0.2), (1.3, -0.6), (1.45, -1.1), (1.7, -1.25)]
        d.sweep([(x + u * r, 0, z + v * r) for u, v in trunk], 0.2 * r, fur)


@draws("ball", whole=True, even="cube")
def play_ball(d: Drawing) -> None:
    """A ball: a football, a basketball or a striped beach ball."""
    box = d.even("cube")
    r = box.depth / 2
    kind = d.pick("kind", ["football", "basketball", "beach"])
    look = d.material("body", "orange plastic" if kind == "basketball" else "white plastic")
    whole = shapes.containing_hull(shapes.ball((r, r, r), (0, 0, r), 48)[0])
    if kind == "beach":
        lift, k = np.linspace(-np.pi / 2, np.pi / 2, 13), np.linspace(0, np.pi / 3, 5)
        gore = [(np.cos(t) * np.cos(a), np.cos(t) * np.sin(a), 1 + np.sin(t)) for t in lift[1:-1] for a in (*k, *k[:0])]
        points = r * np.array([*gore, *((0, 0, 1 + np.sin(t)) for t in lift)])
        for n, tone in enumerate(("red plastic", look, "blue plastic", look, "yellow plastic", look)):
            with d.at(yaw=n * math.pi / 3):
                d.add(shapes.hull(points), tone, [] if n else [whole])
        return
    inner = (0.97 if kind == "football" else 0.985) * r
    d.add(shapes.ball((inner, inner, inner), (0, 0, r), 24), look, [whole])  # what is printed stands out of it
    if kind == "basketball":
        for roll, yaw in ((0.0, 0.0), (math.pi / 2, 0.0), (math.pi / 2, math.pi / 2)):
            with d.at(z=r, yaw=yaw, roll=roll), d.no_colliders():
                d.hoop(Box.around((0, 0, 0), 1.97 * r, 1.97 * r, 0.0), 0.014 * r, "black plastic", steps=24)
        return
    # Black pentagons lie at the corners of an icosahedron.
    level, turn = math.atan(0.5), np.arange(5) * 2 * np.pi / 5
    rings = [(0.36, math.sqrt(1 - 0.36**2)), (0.2, math.sqrt(1 - 0.2**2)), (0.3, 0.8)]
    patch = np.concatenate([np.c_[s * np.cos(turn), s * np.sin(turn), 0 * turn + c] for s, c in rings])
    patch = shapes.hull(1.001 * r * np.concatenate([patch, [(0.0, 0.0, 1.0)]]))
    tips = [(k * math.pi / 5, math.pi / 2 - (1 - 2 * (k % 2)) * level) for k in range(10)]
    for yaw, pitch in [(0.0, 0.0), (0.0, math.pi), *tips]:
        with d.at(z=r, yaw=yaw, pitch=pitch):
            d.add(patch, "black plastic", [])


@draws("puzzle_box", whole=True)
def puzzle_box(d: Drawing) -> None:
    """A flat box with a landscape and the lines of the pieces on its lid."""
    look = d.material("body", "blue paint, red paint, green paint, yellow paint, teal paint")
    d.box(d.bounds.inset(x=0.002, y=0.002).share(z=(0.0, 0.6)), "paper", 0.001)
    lid = d.box(d.bounds.share(z=(0.2, 1.0)), look, 0.001)
    top = lid.top(0.0)
    photo = d.print(top.share((0.08, 0.92), (0.04, 0.8)), "sky pigment", 0.0001)
    d.print(photo.share(x=(0.5, 1.0)), "moss pigment", 0.00015)
    with d.no_colliders():
        for k, (y, s) in enumerate(((0.24, 0.2), (0.53, 0.28), (0.84, 0.15))):
            hill = photo.share(x=(0.5 - 1.5 * s, 0.5), y=(y - s, min(1.0, y + s))).inset(bottom=-0.001, top=-0.0002)
            d.silhouette(hill, [(1, 0), (1, 1), (0, 0.5)], ("sea pigment", "night pigment")[k % 2], "z")
    d.print(photo.share((0.1, 0.26), (0.76, 0.88)), "ochre pigment", oval=True)
    for k in range(1, 6):
        d.print(photo.share(x=(k / 6, k / 6)).inset(x=-0.0003), "chalk pigment", 0.0004)
        d.print(photo.share(y=(k / 6, k / 6)).inset(y=-0.0003), "chalk pigment", 0.0004)
    d.print(top.share((0.14, 0.8), (0.86, 0.92)), "chalk pigment")
    d.print(lid.front(0.0).share(y=(0.14, 0.7), z=(0.28, 0.75)), "chalk pigment")


CHESSMAN = ((1.0, 0.0), (1.0, 0.07), (0.45, 0.2), (0.34, 0.62), (0.62, 0.65), (0.5, 0.86), (0.15, 1.0))
"""The profile of a chessman: shares of its radius and height."""
HEIGHTS = (0.62, 0.7, 0.78, 0.95, 1.0, 0.78, 0.7, 0.62)
"""Of the pieces of the first rank, as shares of the king's."""


def chessmen(d: Drawing, cells: Sequence[Sequence[Box]], king: float, pale: Look, dark: Look, played: bool) -> None:
    """Two ranks of chessmen at either end of a board of 8 x 8 cells; ``played``: some have moved or been taken."""
    for side, look in ((0, pale), (7, dark)):
        places: dict[float, list[Box]] = {}
        for j, share in enumerate(HEIGHTS):
            for rank, size in ((side, share), (1 if side == 0 else 6, 0.5)):
                if played and rank == side and j not in (0, 4, 7) and d.chance(f"taken {side} {j}", 0.2):
                    continue
                if played and rank != side and d.chance(f"moved {side} {j}", 0.3):
                    rank += 2 if side == 0 else -2
                places.setdefault(size, []).append(cells[rank][j])
        for k, (size, found) in enumerate(places.items()):
            name = f"{'dark' if side else 'pale'}-{k}"
            with d.copies([pose(*cell.center) for cell in found]), d.item(name, "chessman"), d.convex():
                d.turned(Box.sized(0.72 * found[0].depth, 0.72 * found[0].width, size * king), CHESSMAN, look, 10)


@draws("board_game", whole=True)
def board_game(d: Drawing) -> None:
    """A chess board with its pieces in the middle of a game."""
    frame = d.material("frame", "walnut, oak, mahogany, black paint")
    dark, pale = d.material("dark", "walnut, wenge, ink pigment"), d.material("pale", "birch, light oak, cream paint")
    board = d.box(d.bounds.bottom(0.022), frame)
    field = d.print(board.top(0.0).share((0.06, 0.94), (0.06, 0.94)), pale, 0.0002)
    cells = [row.columns(8) for row in field.split("x", 8)]
    for i, row in enumerate(cells):
        for cell in row[1 - i % 2 :: 2]:
            d.print(cell, dark, 0.0003)
    chessmen(d, cells, d.size.height - 0.022, pale, dark, True)


@draws("puzzle_cube", whole=True, even="cube")
def puzzle_cube(d: Drawing) -> None:
    """A cube of small ones with coloured faces."""
    box = d.even("cube")
    body = d.material("body", "black plastic, white plastic")
    colors = [f"{c} plastic" for c in ("red", "orange", "white", "yellow", "blue", "green")]
    solved = d.chance("solved", 0.3)
    for level in box.rows(3):
        d.box(level.inset(z=0.0003), body, 0.001)
    faces = [box.front(0.0), box.back(0.0), box.left(0.0), box.right(0.0), box.top(0.0)]
    for k, face in enumerate(faces):
        cells = [c for a in face.split("x", 3) for b in a.columns(3) for c in b.rows(3)]
        cells = list(dict.fromkeys(cells))  # its flat axis gave each three times
        for j, cell in enumerate(cells):
            place = cell.share((0.09, 0.91), (0.09, 0.91), (0.09, 0.91))
            d.print(place, colors[k] if solved else d.pick(f"f{k}{j}", colors), 0.0001)


@draws("toy_dinosaur", whole=True)
def toy_dinosaur(d: Drawing) -> None:
    """A long-necked dinosaur with a row of plates on its back."""
    deep, wide, high = d.size
    look = d.material("body", "green plastic, blue plastic, orange plastic, grey plastic, mint plastic, lilac plastic")
    plates = d.material("plates", "yellow plastic, red plastic, green plastic, orange plastic")
    x = np.array([-0.5, -0.4, -0.26, -0.12, 0.04, 0.16, 0.25, 0.32, 0.36]) * deep
    spine = np.c_[x, np.array([0.12, 0.2, 0.36, 0.46, 0.48, 0.46, 0.56, 0.72, 0.86]) * high]
    thick = 1.25 * high * np.array([0.02, 0.05, 0.1, 0.16, 0.19, 0.16, 0.1, 0.07, 0.06])
    way = np.gradient(spine, axis=0)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    turn = np.arange(14) * 2 * np.pi / 14
    rings = []
    for (x, z), (u, v), r in zip(spine, way, thick, strict=True):
        up, across = r * np.sin(turn), min(r, 0.5 * wide) * np.cos(turn)
        rings.append(np.c_[x - v * up, across, z + u * up])
    d.add(shapes.lofted(rings), look, [shapes.hull(np.concatenate(p)) for p in zip(rings[:-1], rings[1:], strict=True)])
    ball(d, (0.4 * deep, 0, 0.905 * high), (0.11 * deep, 0.24 * wide, 0.085 * high), look)
    eyes(d, 0.44 * deep, 0.19 * wide, 0.935 * high, 0.016 * high)
    with d.mirror("y"):
        for x in (-0.12, 0.14):
            leg = Box.sized(0.112 * deep, 0.112 * deep, 0.4 * high, (x * deep, 0.3 * wide, 0.0))
            d.turned(leg, [(1.0, 0), (0.88, 0.08), (0.72, 0.5), (0.86, 1)], look, 12)
    for k in range(7):
        x = (-0.36 + 0.09 * k) * deep
        z = float(np.interp(x, spine[:, 0], spine[:, 1] + 0.94 * thick)) - 0.03 * high
        size = 0.1 * high * (1 - 0.16 * abs(k - 3))
        d.silhouette(Box.sized(1.4 * size, 0.008, 1.3 * size, (x, 0, z)), [(0, 0), (1, 0), (0.57, 1)], plates)


@draws("crayon_box", whole=True)
def crayon_box(d: Drawing) -> None:
    """An open carton with two rows of crayons in all colours."""
    look = d.material("body", "yellow plastic, green plastic, blue plastic, red plastic, orange plastic")
    carton = d.box(d.bounds.share(z=(0.0, 0.62)), look, 0.0008)
    d.box(d.bounds.back(0.001).share(z=(0.6, 0.86)), look, 0.0)
    start = d.integer("start", 0, 7)
    for row, line in enumerate(d.bounds.share(x=(0.12, 0.88)).split("x", 2)):
        for k, cell in enumerate(line.share(y=(0.03, 0.97)).columns(7)):
            size = 0.85 * min(cell.width, cell.depth)
            top = (0.9 if row else 1.0) * cell.height - 0.004 * ((k * 3 + row) % 3)
            crayon = cell.place(size, size).to(z=(carton.z[1] - 0.002, top))
            tip = min(0.5, 1.1 * size / crayon.height)
            d.turned(crayon, [(1, 0), (1, 1 - tip), (0.9, 1 - tip), (0.3, 1)], RAINBOW[(k + 4 * row + start) % 8], 10)
    face = carton.front(0.0)
    label = d.print(face.share(y=(0.06, 0.94), z=(0.58, 0.88)), "chalk pigment")
    d.print(label.share(y=(0.16, 0.84), z=(0.34, 0.66)), "ink pigment", 0.0004)
    for k, stripe in enumerate(face.share(y=(0.14, 0.86), z=(0.12, 0.45)).columns(7)):
        d.print(stripe.share(y=(0.0, 0.7), z=(0.0, 0.6 + 0.2 * (k % 3))), RAINBOW[k])


@draws("toy_airplane", whole=True)
def toy_airplane(d: Drawing) -> None:
    """A propeller plane on its wheels."""
    deep, wide, high = d.size
    look = d.material("body", "red plastic, yellow plastic, blue plastic, white plastic, orange plastic, beech")
    wing = d.material("wings", "white plastic, red plastic, yellow plastic, blue plastic, light oak")
    r, level = 0.22 * high, 0.45 * high
    hull = [(0.25, -0.48), (0.8, -0.1), (1, 0.12), (1, 0.28), (0.8, 0.4), (0.3, 0.44)]
    with d.at(z=level, pitch=math.pi / 2):
        d.revolve([(q * r, x * deep) for q, x in hull], look, 18)
        d.revolve([(0.3 * r, 0.44 * deep), (0.08 * r, 0.5 * deep)], "black plastic", 14)
    for turn in (0.4, 0.4 + math.pi / 2):
        with d.at(0.465 * deep, 0, level, roll=turn):
            d.box(Box.around((0, 0, 0), 0.004, 0.84 * high, 0.016), "black plastic", 0.001)
    d.slab(Box.sized(0.26 * deep, wide, 0.01, (0.16 * deep, 0, level - 0.5 * r)), wing, 0.06 * deep, 0.003)
    d.slab(Box.sized(0.13 * deep, 0.4 * wide, 0.007, (-0.425 * deep, 0, level)), wing, 0.03 * deep, 0.002)
    fin = Box((-0.5 * deep, -0.34 * deep), (-0.004, 0.004), (level, high - 0.001))
    d.silhouette(fin, [(0, 0), (1, 0), (0.4, 1), (0, 1)], wing)
    ball(d, (0.08 * deep, 0, level + 0.75 * r), (0.1 * deep, 0.7 * r, 0.75 * r), "black glass", 14)
    with d.mirror("y"):
        axle = (0.22 * deep, 0.14 * wide, 0.15 * high)
        d.bar((0.2 * deep, 0.1 * wide, level - 0.4 * r), axle, 0.004, "steel", 6)
        wheel(d, Box.around(axle, 0.3 * high, 0.014, 0.3 * high), "rubber", "yellow plastic")
    d.bar((-0.42 * deep, 0, level - 0.1 * r), (-0.44 * deep, 0, 0.05 * high), 0.004, "steel", 6)
    wheel(d, Box.around((-0.44 * deep, 0, 0.06 * high), 0.12 * high, 0.009, 0.12 * high), "rubber", "yellow plastic")


@draws("xylophone", whole=True)
def xylophone(d: Drawing) -> None:
    """Eight coloured bars on two rails, and a beater."""
    wood = d.material("body", "beech, pine, birch")
    box = d.bounds
    rails = box.share(z=(0.0, 0.5))
    with d.mirror("x"):
        d.silhouette(rails, [(0.81, 0.0), (0.91, 0.0), (0.75, 1.0), (0.65, 1.0)], wood, "z")
    for end, reach in ((rails.right(0.03), 0.14), (rails.left(0.03), 0.3)):
        d.box(end.inset(y=0.004).share(x=(reach, 1 - reach), z=(0.0, 0.9)), wood, 0.002)
    for k, cell in enumerate(box.share(z=(0.5, 0.66)).columns(8)):
        key = d.box(cell.share((0.026 * k, 1 - 0.026 * k), (0.14, 0.86)), RAINBOW[k], 0.002)
        for x in (0.12, 0.88):
            d.print(key.top(0.0).share((x, x), (0.5, 0.5)).inset(x=-0.004, y=-0.004), "steel", oval=True)
    r = 0.17 * box.height
    tip = (-0.05 * box.depth, 0.34 * box.width, 0.66 * box.height + r)
    d.bar((0.1 * box.depth, -0.3 * box.width, tip[2] - 0.2 * r), tip, 0.0035, wood, 8)
    ball(d, tip, r, "red plastic")
