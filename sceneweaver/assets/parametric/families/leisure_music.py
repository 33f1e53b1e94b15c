"""Musical instruments and what plays music."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws

OCTAVES = 52
"""White keys of a piano."""


def keyboard(d: Drawing, box: Box) -> None:
    """White keys with dark gaps and black keys upon them, on top of a box; its depth is that of the white ones."""
    d.box(box.top(0.02), "white plastic", 0.0)
    keys = box.top(0.0).columns(OCTAVES)
    for k, key in enumerate(keys[1:], start=1):
        d.print(key.right(0.0).inset(y=-0.0003, x=0.0003), "black plastic")
        if k % 7 not in (0, 3):
            black = key.right(0.0).inset(y=-0.27 * key.width, top=-0.01, bottom=-0.0).back(0.36 * key.depth + 0.02)
            d.box(black.inset(bottom=-0.001), "black plastic", 0.0)


def pedals(d: Drawing, x: float, z: float) -> None:
    """Three brass pedals in a row."""
    with d.along((x, -0.07, z), (x, 0.07, z), 3):
        d.box(Box.sized(0.12, 0.024, 0.012), "brass", 0.005)


@draws("upright_piano", whole=True)
def upright_piano(d: Drawing) -> None:
    """A tall case with a key bed on consoles, fall, music rest, pedals."""
    wood = d.material("case", "black paint, mahogany, walnut, white paint, wenge, cherry")
    box = d.bounds
    deep, wide, high = box.size
    level = 0.72 if high > 1.05 else 0.67 * high
    case = box.back(0.58 * deep)
    front, (_, x1) = case.x[1], box.x
    d.box(case.inset(y=0.03, bottom=0.06, top=0.025), wood, 0.004)
    for side in (case.left(0.03), case.right(0.03)):
        d.box(side.inset(front=-0.01, top=0.025), wood, 0.004)
    lid = d.box(case.inset(front=-0.03).top(0.028), wood, 0.008)
    d.surface("top", lid, inset=0.01)
    face = case.front(0.01).inset(front=-0.006)
    for panel in (face.inset(y=0.12).to(z=(0.16, level - 0.16)), face.inset(y=0.08).to(z=(level + 0.14, high - 0.06))):
        d.box(panel, wood, 0.006)
    with d.at(front + 0.005, 0.0, level + 0.1, pitch=-0.2):
        d.box(Box.sized(0.014, 0.52 * wide, 0.22).move(x=0.007, z=0.02), wood, 0.004)
    bed = box.to(x=(front, x1))
    with d.part("keys"):
        d.box(bed.to(z=(level - 0.09, level - 0.02)), wood, 0.006)
        cheeks = bed.to(z=(level - 0.03, level + 0.1))
        for cheek in (cheeks.left(0.06), cheeks.right(0.06)):
            d.silhouette(cheek, [(0, 0), (1, 0), (1, 0.3), (0.85, 0.6), (0, 1)], wood, bevel=0.004)
        keyboard(d, bed.inset(back=0.05, front=0.03, y=0.065).to(z=(0.0, level + 0.012)))
        fall = d.box(bed.back(0.055).inset(back=-0.005, y=0.055).to(z=(level - 0.03, level + 0.1)), wood, 0.006)
        d.print(fall.front(0.0).place(width=0.18).share(z=(0.65, 0.75)), "brass")
    for k, side in enumerate((box.right(0.07), box.left(0.07))):
        with d.part(f"leg {k}"):
            post = Box.sized(0.08, 0.08, level - 0.15, (x1 - 0.07, side.center[1], 0.06))
            d.turned(post, [(0.75, 0), (0.55, 0.07), (0.85, 0.5), (0.65, 0.95), (1, 1)], wood, 16)
            d.box(side.bottom(0.07).to(x=(front - 0.05, x1 - 0.01)), wood, 0.006)
    with d.part("body"):
        pedals(d, front + 0.04, 0.05)
        d.box(face.to(z=(0.04, 0.12)).place(width=0.28), "brass", 0.004)
    d.clear(bed.inset(back=0.12, y=0.1).to(z=(0.0, level - 0.1)))


@draws("digital_piano", whole=True)
def digital_piano(d: Drawing) -> None:
    """A flat keyboard case on two side panels with a back board, music rest, pedals."""
    wood = d.material("case", "black paint, white paint, walnut, light oak, wenge")
    box = d.bounds
    deep, wide, _ = box.size
    case = box.inset(top=0.16)
    top = case.z[1]
    with d.part("case"):
        d.box(case.top(0.13).inset(top=0.045), wood, 0.008)
        panel = d.box(case.top(0.06).share(x=(0.0, 0.5)), wood, 0.008)
        for cheek in (case.left(0.045), case.right(0.045)):
            d.silhouette(cheek.top(0.08).share(x=(0.4, 1.0)), [(0, 0), (1, 0), (1, 0.5), (0.17, 1)], wood)
        keyboard(d, case.share(x=(0.5, 1.0)).inset(front=0.02, y=0.05, top=0.028))
        for k, key in enumerate(panel.top(0.0).share(x=(0.6, 0.68)).place(width=0.63).columns(9)):
            d.print(key.share(y=(0.3, 0.7)), "red plastic" if k == 0 else "grey plastic")
        knob_place = Box.sized(0.03, 0.03, 0.014, panel.point(0.64, 0.12, 1.0))
        d.cylinder(knob_place, "grey plastic", segments=16)
        with d.at(box.x[0] + 0.09, 0.0, top - 0.005, pitch=-0.3):
            d.box(Box.sized(0.012, 0.52 * wide, 0.16 / math.cos(0.3)), wood, 0.004)
    for k, side in enumerate((box.right(0.06), box.left(0.06))):
        with d.part(f"leg {k}"):
            d.box(side.place(width=0.036).share(x=(0.05, 0.55)).to(z=(0.04, top - 0.12)), wood, 0.004)
            d.box(side.bottom(0.05).inset(front=0.03), wood, 0.006)
    with d.part("back"):
        board = box.inset(y=0.03)
        d.box(board.back(0.05).front(0.02).to(z=(0.2, top - 0.25)), wood)
        d.box(board.back(0.16).front(0.1).to(z=(0.06, 0.12)), wood, 0.004)
        pedals(d, box.x[0] + 0.2, 0.075)
    d.clear(box.inset(back=0.26, y=0.08).to(z=(0.0, top - 0.14)))


@draws("grand_piano", whole=True)
def grand_piano(d: Drawing) -> None:
    """The curved case on three legs with its lid up, golden plate and strings inside; the player is in front."""
    wood = d.material("case", "black paint, black paint, mahogany, white paint, walnut")
    box = d.bounds
    deep, wide, high = box.size
    level, rim = 0.7, 1.0
    (x0, x1), y = box.x, wide / 2
    # Seen from above; its straight side is the bass, at the left of the player, who looks toward -x.
    t = np.linspace(0, 1, 10)
    bent = np.c_[x1 - 0.42 - t * (deep - 0.62), y - 0.527 * wide * (0.5 - 0.5 * np.cos(math.pi * t))]
    tail = [(x0 + 0.06, -0.28 * y), (x0, -0.42 * y), (x0, -0.72 * y), (x0 + 0.05, -0.93 * y), (x0 + 0.16, -y)]
    outline = np.concatenate([[(x1 - 0.42, -y)], bent, tail])
    with d.part("case"):
        d.extrude(outline, (level - 0.06, rim - 0.1), wood)
        d.extrude(outline * (0.95, 0.94) - (0.012, 0.004), (rim - 0.1, rim - 0.085), "brass")
        along = np.roll(outline, -1, axis=0) - outline
        inward = 0.035 * np.c_[-along[:, 1], along[:, 0]] / np.linalg.norm(along, axis=1)[:, None]
        for a, by, across in zip(outline, along, inward, strict=True):
            wall = [a, a + by, a + by + across, a + across]
            d.hull([(px, py, z) for px, py in wall for z in (rim - 0.11, rim)], wood)
        for k in range(24):
            at = -0.86 * y + k * 0.86 * wide / 24
            far = float(np.interp(at, bent[::-1, 1], bent[::-1, 0])) + 0.14
            d.print(Box((far, x1 - 0.5), (at - 0.001, at + 0.001), (rim - 0.085, rim - 0.085)), "steel")
    front = box.to(x=(x1 - 0.43, x1))
    with d.part("keys"):
        d.box(front.to(z=(level - 0.06, level - 0.005)), wood, 0.006)
        for cheek in (front.left(0.09), front.right(0.09)):
            d.box(cheek.inset(front=0.02).to(z=(level - 0.02, level + 0.09)), wood, 0.015)
            d.box(cheek.back(0.13).to(z=(level + 0.06, rim)), wood, 0.015)
        d.box(front.inset(back=0.01, front=0.19, y=0.08).to(z=(level - 0.01, level + 0.1)), wood, 0.006)
        keyboard(d, front.inset(back=0.23, front=0.035, y=0.095).to(z=(0.0, level + 0.03)))
        name = Box((x1 - 0.19, x1 - 0.19), (-0.12, 0.12), (level + 0.06, level + 0.08))
        d.print(name, "brass")
        with d.at(x1 - 0.42, 0.0, rim - 0.1, pitch=-0.35):
            d.box(Box((0.0, 0.012), (-0.36, 0.36), (0.0, 0.28)), wood, 0.006)
    with d.part("lid"):  # hinged on the straight side, propped open at the treble
        angle = math.asin(min(0.62, (high - rim - 0.02) / (0.98 * wide)))
        with d.at(0.0, -y, rim, roll=angle):
            d.extrude(outline + (0.0, y), (0.0, 0.018), wood)
        reach = 0.25 * wide
        tip = (x1 - 0.6, -y + 0.98 * 3 * reach, rim + math.tan(angle) * 0.98 * 3 * reach)
        d.bar((x1 - 0.6, y - reach, rim - 0.08), tip, 0.009, wood, 8)
    leg = [(0.39, 0), (0.56, 0.12), (0.5, 0.42), (0.83, 0.9), (1, 1)]
    for k, (px, py) in enumerate(((x1 - 0.32, 0.14 - y), (x1 - 0.32, y - 0.14), (x0 + 0.34, -0.5 * y))):
        with d.part(f"leg {k}"):
            d.turned(Box.sized(0.18, 0.18, level - 0.11, (px, py, 0.05)), leg, wood, 8)
            d.cylinder(Box.around((px, py, 0.03), 0.06, 0.03, 0.06), "brass", "y")
    with d.part("lyre"):
        with d.mirror("y"):
            d.bar((x1 - 0.45, 0.09, level - 0.06), (x1 - 0.45, 0.06, 0.12), 0.014, wood, 8)
        d.box(Box.sized(0.14, 0.26, 0.06, (x1 - 0.45, 0.0, 0.07)), wood, 0.008)
        pedals(d, x1 - 0.36, 0.085)


def body(d: Drawing, box: Box, halves: list[tuple[float, float]], look: Look, bevel: float = 0.0) -> None:
    """A body that is alike left and right: half widths at heights, as shares of a box, drawn through its depth."""
    right = [(0.5 + 0.5 * r, z) for z, r in halves]
    d.silhouette(box, right + [(1 - y, z) for y, z in reversed(right)], look, "x", bevel)


GUITAR = [(0, 0.45), (0.03, 0.75), (0.1, 0.95), (0.22, 1), (0.34, 0.95), (0.46, 0.76), (0.56, 0.62), (0.66, 0.62)]
GUITAR += [(0.78, 0.72), (0.88, 0.74), (0.95, 0.66), (1, 0.35)]
CELLO = [(0, 0.4), (0.05, 0.8), (0.16, 1), (0.3, 0.94), (0.38, 0.82), (0.42, 0.62), (0.5, 0.52), (0.58, 0.55)]
CELLO += [(0.63, 0.7), (0.72, 0.78), (0.86, 0.74), (0.95, 0.5), (1, 0.2)]


@draws("guitar_on_stand", whole=True)
def guitar_on_stand(d: Drawing) -> None:
    """An acoustic or electric guitar leaning in a tripod stand."""
    deep, wide, high = d.size
    electric = d.chance("electric", 0.4)
    paints = "red paint, blue paint, black paint, cream paint, yellow paint"
    top = d.material("body", paints if electric else "oak, light oak, cherry, walnut, black paint")
    sides = top if electric else d.material("sides", "mahogany, walnut")
    lean, half = 0.16, wide / 2
    with d.at(0.12 * deep, 0.0, 0.13, pitch=-lean):
        long = (high - 0.13) / math.cos(lean)
        box = Box((-0.05 if electric else -0.1, 0.0), (-half, half), (0.0, 0.48 * long))
        neck, nut = box.z[1], 0.86 * long
        body(d, box, GUITAR, sides, 0.004)
        body(d, box.front(0.004).inset(front=-0.002, y=0.0075 * wide, z=0.0075 * neck), GUITAR, top)
        if electric:
            for z in (0.35, 0.5, 0.65):
                d.box(Box((0, 0.009), (-0.04, 0.04), (neck * z - 0.01, neck * z + 0.01)), "black plastic", 0.002)
            for z in (0.18, 0.26):
                d.cylinder(Box.around((0.006, 0.55 * half, neck * z), 0.014, 0.028, 0.028), "chrome", "x")
        else:
            hole = Box.around((0.002, 0.0, 0.64 * neck), 0.0, 0.0, 0.0)
            d.print(hole.inset(y=-0.29 * half, z=-0.29 * half), "walnut", oval=True)
            d.print(hole.inset(y=-0.25 * half, z=-0.25 * half), "black plastic", 0.0004, oval=True)
            d.box(Box((0, 0.008), (-0.4 * half, 0.4 * half), (0.24 * neck, 0.275 * neck)), "wenge", 0.002)
            guard = Box((0.0005, 0.0023), (0.25 * half, 0.6 * half), (0.42 * neck, 0.62 * neck))
            d.silhouette(guard, [(0.1, 0), (1, 0.1), (0.7, 1), (0, 0.65)], "black plastic", "x")
        d.box(Box((-0.02, 0.0), (-0.028, 0.028), (neck - 0.06, nut)), "mahogany", 0.004)
        board = d.box(Box((0.0, 0.008), (-0.026, 0.026), (0.74 * neck, nut)), "wenge", 0.0)
        for k in range(1, 12):
            z = nut - (nut - 0.78 * neck) * (1 - 0.9**k) / (1 - 0.9**12)
            d.print(board.front(0.0).to(z=(z - 0.0007, z + 0.0007)).inset(y=0.0003), "brass")
        head = Box((-0.018, 0.0), (-0.038, 0.038), (nut, long))
        d.silhouette(head, [(0.13, 0), (0.87, 0), (1, 1), (0, 1)], sides, "x")
        with d.mirror("y"), d.along((-0.01, 0.03, 0.89 * long), (-0.01, 0.03, 0.962 * long), 3):
            d.bar((0, 0, 0), (0, 0.022, 0), 0.006, "chrome", 8)
        with d.along((0.01, -0.018, 0.26 * neck), (0.01, 0.018, 0.26 * neck), 6):
            d.bar((0, 0, 0), (-0.0005, 0, 0.87 * long - 0.26 * neck), 0.0009, "brass", 4)
    x = -0.28 * deep
    d.bar((0.3 * x, 0, 0.1), (0.55 * x, 0, 0.62 * high), 0.011, "black steel")
    d.bar((0.32 * x, 0, 0.12), (-deep / 2, 0, 0.01), 0.01, "black steel")
    with d.mirror("y"):
        fork = [(0.55 * x, 0, 0.61 * high), (0.2 * x, 0.05, 0.62 * high), (0.2 * x + 0.07, 0.05, 0.62 * high)]
        d.sweep(fork, 0.009, "rubber", 8)
        d.bar((0.32 * x, 0, 0.12), (0.42 * deep, 0.42 * wide, 0.01), 0.01, "black steel")
        f = 0.12 * deep
        cradle = [(0.32 * x, 0, 0.13), (f - 0.06, 0.09, 0.12), (f + 0.03, 0.09, 0.115), (f + 0.04, 0.09, 0.15)]
        d.sweep(cradle, 0.009, "rubber", 8)


@draws("cello", whole=True)
def cello(d: Drawing) -> None:
    """A cello in its stand."""
    wood = d.material("body", "cherry, mahogany, oak")
    deep, wide, high = d.size
    with d.at(0.05, 0.0, 0.14, pitch=-0.12):
        long = (high - 0.14) / math.cos(0.12)
        box = Box((-0.13, 0.0), (-wide / 2, wide / 2), (0.0, 0.62 * long))
        tall = box.z[1]
        body(d, box, CELLO, wood, 0.006)
        body(d, box.front(0.01).inset(front=-0.012, y=0.05 * wide, z=0.02 * tall), CELLO, wood, 0.006)
        with d.mirror("y"), d.no_colliders():  # f holes
            bend = [(0.36, 0.38), (0.41, 0.37), (0.42, 0.42), (0.38, 0.5), (0.39, 0.55), (0.44, 0.54)]
            d.sweep([(0.0095, y * wide / 2, z * tall) for y, z in bend], 0.003, "black plastic", 6)
        d.box(Box((0.01, 0.06), (-0.045, 0.045), (0.45 * tall, 0.46 * tall)), "light oak", 0.002)
        piece = [(0.012, 0.025, 0.12), (0.05, 0.035, 0.36), (0.03, 0.02, 0.36), (0.03, 0.01, 0.1)]
        d.hull([(x, s * y, z * tall) for x, y, z in piece for s in (-1, 1)], "wenge")
        board = ((0.055, 0.03, 0.6 * tall), (0.02, 0.02, 0.9 * long))
        d.hull([(x - e, s * y, z) for x, y, z in board for s in (-1, 1) for e in (0, 0.015)], "wenge")
        d.box(Box((-0.02, 0.01), (-0.018, 0.018), (tall - 0.03, 0.93 * long)), wood, 0.004)
        d.cylinder(Box.around((-0.02, 0, long - 0.04), 0.08, 0.04, 0.08), wood, "y", segments=16)
        d.box(Box((-0.035, 0.0), (-0.016, 0.016), (0.92 * long, long - 0.03)), wood, 0.004)
        for k in range(4):
            s, z, y = (-1) ** k, (0.91 + 0.015 * k) * long, -0.015 + 0.01 * k
            d.bar((-0.01, 0.01 * s, z), (-0.01, 0.07 * s, z), 0.006, "wenge", 8)
            string = [(0.05, 1.2 * y, 0.36 * tall), (0.061, y, 0.455 * tall), (0.02, 0.7 * y, 0.91 * long)]
            d.sweep(string, 0.001, "steel", 4)
        d.bar((-0.06, 0, 0.01), (-0.06, 0, -0.1), 0.006, "steel", 8)
    x = -0.25 * deep
    d.bar((x, 0, 0.05), (-0.32 * deep, 0, 0.4 * high), 0.014, "black steel")
    d.bar((x, 0, 0.06), (-deep / 2, 0, 0.012), 0.012, "black steel")
    with d.mirror("y"):
        d.bar((x, 0, 0.06), (deep / 2, 0.45 * wide, 0.012), 0.012, "black steel")
        d.bar((-0.3 * deep, 0, 0.38 * high), (-0.02, 0.32 * wide, 0.38 * high), 0.01, "rubber")
        d.bar((0.05 * deep, 0.11, 0.05), (0.05 * deep, 0.11, 0.18), 0.012, "rubber")
        d.bar((x, 0, 0.09), (0.07 * deep, 0.12, 0.09), 0.012, "black steel")


def _drum(d: Drawing, r: float, tall: float, shell: Look) -> None:
    """A drum about the frame's origin: white heads, chrome hoops and lugs."""
    box = Box.around((0, 0, 0), 2 * r, 2 * r, tall)
    d.cylinder(box, shell, segments=28)
    for hoop, head in ((box.top(0.022), box.top(0.0)), (box.bottom(0.022), box.bottom(0.0))):
        d.cylinder(hoop.inset(x=-0.008, y=-0.008), "chrome", segments=28)
        with d.no_colliders():
            d.cylinder(head.inset(x=0.04 * r, y=0.04 * r, z=-0.0004), "white plastic", segments=28)
    with d.ring(8, r + 0.003, math.pi / 8):
        d.box(Box.around((0, 0, 0), 0.014, 0.02, 0.5 * tall), "chrome", 0.0)


def _stand(d: Drawing, x: float, y: float, top: float, spread: float = 0.2) -> None:
    """A chrome pole on three legs."""
    with d.at(x, y):
        d.bar((0, 0, 0.2), (0, 0, top), 0.012, "chrome", 8)
        with d.ring(3, 0.0, 0.4):
            d.bar((0, 0, 0.3), (spread, 0, 0.012), 0.01, "chrome", 8)


CYMBAL = ((1.0, 0.0), (0.25, 0.4), (0.16, 0.8), (0.06, 1.0))


@draws("drum_kit", whole=True)
def drum_kit(d: Drawing) -> None:
    """Bass drum in front, toms on it, snare, floor tom, hi-hat, two cymbals, the drummer's stool behind."""
    shell = d.material("shells", "red plastic, black plastic, blue plastic, mahogany, oak, white plastic")
    deep, wide, high = d.size
    x = deep / 2
    with d.part("bass"):
        with d.at(x - 0.25, 0.0, 0.288, pitch=math.pi / 2):
            _drum(d, 0.28, 0.44, shell)
        with d.mirror("y"):
            d.bar((x - 0.12, 0.25, 0.25), (x - 0.03, 0.42, 0.012), 0.01, "chrome", 8)
        d.box(Box.sized(0.31, 0.1, 0.025, (x - 0.625, 0.0, 0.0)), "steel", 0.004)
        d.bar((x - 0.5, 0, 0.02), (x - 0.49, 0, 0.25), 0.01, "steel", 8)
    with d.part("toms"):
        for s, r in ((-1, 0.16), (1, 0.14)):
            with d.at(x - 0.36, 0.2 * s, 0.78, pitch=-0.25):
                _drum(d, r, 0.22, shell)
            d.bar((x - 0.22, 0.05 * s, 0.5), (x - 0.25, 0.12 * s, 0.74), 0.013, "chrome", 8)
    with d.part("snare"):
        with d.at(x - 0.85, 0.32, 0.6):
            _drum(d, 0.18, 0.15, "chrome")
        _stand(d, x - 0.85, 0.32, 0.53)
    with d.part("floor tom"), d.at(x - 0.75, 0.35 - wide / 2):
        with d.at(z=0.42):
            _drum(d, 0.2, 0.38, shell)
        with d.ring(3, 0.222):
            d.bar((0, 0, 0), (0, 0, 0.5), 0.009, "chrome", 8)
    with d.part("hi-hat"):
        y = wide / 2 - 0.3
        _stand(d, x - 0.62, y, 0.95)
        for z, turn in ((0.86, 0.0), (0.855, math.pi)):
            with d.at(x - 0.62, y, z, pitch=turn):
                d.turned(Box.sized(0.36, 0.36, 0.03), CYMBAL, "brass", 28)
    for s, r in ((-1, 0.25), (1, 0.21)):
        with d.part(f"cymbal {s}"):
            y = s * (wide / 2 - 0.26)
            _stand(d, x - 0.28, y, high - 0.06, 0.24)
            with d.at(x - 0.28, y, high - 0.1, pitch=-0.2):
                d.turned(Box.sized(2 * r, 2 * r, 0.034), CYMBAL, "brass", 28)
    with d.part("stool"):
        seat = Box.sized(0.34, 0.34, 0.1, (0.17 - deep / 2, 0.0, 0.44))
        d.turned(seat, [(0.88, 0), (1, 0.3), (0.97, 0.8), (0.76, 1)], "black leather", 28)
        _stand(d, seat.center[0], 0.0, 0.46)


@draws("music_stand", whole=True)
def music_stand(d: Drawing) -> None:
    """A tilted rest with sheets of music on a tripod."""
    metal = d.material("stand", "black steel, chrome, white steel, walnut")
    _, wide, high = d.size
    with d.ring(3, 0.0, math.pi / 3):
        d.bar((0, 0, 0.3), (0.26, 0, 0.01), 0.011, metal, 8)
    d.bar((0, 0, 0.12), (0, 0, high - 0.2), 0.012, metal)
    d.cylinder(Box.sized(0.04, 0.04, 0.05, (0, 0, 0.5 * high)), "black plastic", segments=12)
    with d.at(z=high - 0.36, pitch=-0.4):
        d.box(Box.sized(0.008, wide, 0.36), metal, 0.002)
        d.box(Box((0, 0.06), (-wide / 2, wide / 2), (-0.004, 0.006)), metal, 0.002)
        for y in (-0.115, 0.115):
            sheet = d.box(Box.sized(0.002, 0.216, 0.302, (0.005, y, 0.008)), "paper", 0.0).front(0.0)
            for staff in sheet.share(y=(0.08, 0.92), z=(0.08, 0.92)).rows(6):
                for k in range(4):  # lines of a staff, and a note
                    d.print(staff.share(z=(0.2 + 0.15 * k, 0.23 + 0.15 * k)), "ink pigment")
                d.print(staff.share(y=(0.2 + 0.1 * abs(y), 0.24), z=(0.3, 0.7)), "ink pigment", 0.0004)


@draws("record_player", whole=True)
def record_player(d: Drawing) -> None:
    """A wooden plinth with a record, tone arm and buttons, its clear lid raised in some."""
    wood = d.material("plinth", "walnut, black paint, oak, white paint, cherry")
    label = d.material("label", "red plastic, yellow plastic, blue plastic")
    box = d.bounds
    deep, wide, high = box.size
    with d.corners(box, inset=0.03):
        d.cylinder(Box((0, 0.04), (0, 0.04), (0, 0.02)), "rubber", segments=16)
    plinth = d.box(box.to(z=(0.018, 0.085)), wood, 0.005)
    z, y = plinth.z[1], -0.08 * wide
    r = min(0.42 * deep, 0.36 * wide)
    for share, top, look in ((1, 0.016, "steel"), (0.98, 0.019, "black plastic"), (0.33, 0.02, label)):
        d.cylinder(Box.sized(2 * share * r, 2 * share * r, top, (0, y, z)), look, segments=36)
    with d.no_colliders():
        for share in (0.5, 0.66, 0.82):  # grooves
            d.hoop(Box.around((0, y, z + 0.0188), 2 * share * r, 2 * share * r, 0), 0.0006, "black steel", steps=28)
    d.cylinder(Box.sized(0.008, 0.008, 0.014, (0, y, z + 0.015)), "chrome", segments=8)
    arm = wide / 2 - 0.065
    d.cylinder(Box.sized(0.07, 0.07, 0.03, (-0.28 * deep, arm, z)), "steel", segments=20)
    bend = [(-0.38, 0, 0.04), (-0.28, 0, 0.04), (0.14, -0.03, 0.032), (0.2, -0.085, 0.026)]
    d.sweep([(px * deep, arm + py, z + pz) for px, py, pz in bend], 0.005, "chrome", 8)
    d.cylinder(Box.around((-0.38 * deep, arm, z + 0.04), 0.03, 0.028, 0.028), "black plastic", "x", segments=12)
    d.box(Box.around((0.21 * deep, arm - 0.1, z + 0.024), 0.08 * deep, 0.03, 0.012), "black plastic")
    for k in range(2):
        d.cylinder(Box.sized(0.028, 0.028, 0.008, (0.4 * deep, -0.38 * wide + 0.05 * k, z)), "chrome", segments=12)
    if high > 0.25:
        with d.at(-deep / 2 + 0.004, 0.0, z, pitch=0.12):
            lid = Box((0.0, 0.045), box.y, (0.0, high - z))
            d.box(lid.back(0.004), "glass", 0.0)
            for side in (lid.left(0.004), lid.right(0.004)):
                d.box(side.inset(back=0.004, bottom=0.02), "glass", 0.0)
        return
    lid = box.to(z=(z, high))
    for pane in (lid.top(0.004), *lid.inset(top=0.004).walls(0.004)):
        d.box(pane, "glass", 0.0)


@draws("jukebox", whole=True)
def jukebox(d: Drawing) -> None:
    """A rounded cabinet with glowing arched tubes, a record window and a speaker grille."""
    wood = d.material("cabinet", "walnut, mahogany, cherry, red paint")
    glow = d.pick("glow", ["red petal", "yellow petal", "purple petal"])
    deep, wide, high = d.size
    x, r = deep / 2 - 0.06, wide / 2

    def arch(half: float, foot: float, xs: tuple[float, float], look: Look, steps: int = 12) -> None:
        t = np.linspace(0, math.pi, steps + 1)
        ring = np.c_[half * np.cos(t), high - r + half * np.sin(t)]
        d.extrude(np.concatenate([[(-half, foot), (half, foot)], ring]), xs, look, axis="x")

    arch(r, 0.06, (-deep / 2, x), wood)
    d.box(Box((0.02 - deep / 2, x + 0.03), (0.02 - r, r - 0.02), (0, 0.08)), "black plastic", 0.004)
    steps = ((0.97, 0.1, 0.02, "chrome"), (0.9, 0.12, 0.03, "orange plastic"), (0.76, 0.14, 0.038, wood))
    for share, foot, out, look in steps:
        arch(share * r, foot, (x - 0.01, x + out), look)
    t = np.linspace(0, math.pi, 11)
    for share, look in ((0.93, "lamp glow"), (0.83, glow)):
        over = np.c_[0 * t + x + 0.03, share * r * np.cos(t), high - r + share * r * np.sin(t)]
        d.sweep([(x + 0.03, share * r, 0.16), *over, (x + 0.03, -share * r, 0.16)], 0.026, look, 8)
    q = 0.62 * r
    arch(q, 0.62 * high, (x, x + 0.043), "screen", 8)
    for size, look in ((0.5, "black plastic"), (0.18, "red plastic")):
        d.cylinder(Box.around((x + 0.044, 0, 0.72 * high), 0.007, 2 * size * q, 2 * size * q), look, "x", segments=28)
    keys = d.box(Box((x, x + 0.06), (-q, q), (0.53 * high, 0.6 * high)), "chrome", 0.008)
    for k, key in enumerate(keys.front(0.0).share(y=(0.06, 0.94), z=(0.25, 0.75)).columns(8)):
        d.print(key.share(y=(0.12, 0.88)), "red plastic" if k % 2 else "white plastic")
    grille = d.box(Box((x, x + 0.048), (-q, q), (0.17, 0.5 * high)), "brass", 0.01)
    for k, slat in enumerate(grille.inset(y=0.06 * q, z=0.02).columns(7)):
        d.box(slat.front(0.008).inset(front=-0.008, y=0.02), "chrome" if k % 2 else glow)
