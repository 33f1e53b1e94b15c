"""Racks, benches, weight machines and weights."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import beam
from .gym_parts import FRAMES, barbell, disc, dumbbell, plate, plates

TUBE = 0.07
"""Width of the square tubes of racks [m]."""


@draws("weight_bench", whole=True)
def weight_bench(d: Drawing) -> None:
    """A padded bench, its back rest raised at the rear, on a steel frame."""
    (depth, w, h), x0, x1 = d.size, -d.size.depth / 2, d.size.depth / 2
    frame, pad = d.material("frame", FRAMES), d.material("pad", "black leather, brown leather, white leather")
    for x, reach in ((x0 + 0.12, w / 2), (x1 - 0.06, 0.4 * w)):
        beam(d, (x, -reach, 0.03), (x, reach, 0.03), frame, 0.06)
        with d.mirror("y"):
            d.box(Box.sized(0.07, 0.05, 0.065, (x, reach - 0.025, 0.0)), "rubber", 0.004)
    hinge = x1 - 0.3 * depth - 0.02
    long, rise = hinge - x0, h - 0.45
    angle = math.asin(min(0.98, rise / (long + 0.05))) if rise > 0.03 else 0.0
    length = long / max(0.35, math.cos(angle))
    d.cushion(Box((hinge + 0.02, x1), (-0.32 * w, 0.32 * w), (0.4, 0.47)), pad, 0.025)
    with d.at(hinge, z=0.42, pitch=angle):
        d.cushion(Box((-length, -0.01), (-0.3 * w, 0.3 * w), (-0.02, 0.05)), pad, 0.025)
        d.box(Box((-0.8 * length, 0.0), (-0.03, 0.03), (-0.06, -0.01)), frame)
    middle = (hinge - 0.5 * length * math.cos(angle), 0.38 + 0.5 * length * math.sin(angle))
    tubes = [
        ((x0 + 0.12, 0.05), (x1 - 0.06, 0.05), 0.06, frame),
        ((x1 - 0.06, 0.03), (x1 - 0.2, 0.4), 0.06, frame),
        ((hinge - 0.13, 0.05), (hinge + 0.04, 0.4), 0.06, frame),
        ((x0 + 0.25, 0.05), middle, 0.045, "steel"),
    ]
    for (a, low), (b, high), wide, look in tubes:
        beam(d, (a, 0.0, low), (b, 0.0, high), look, wide)


def _uprights(d: Drawing, x: float, gauge: float, frame: Look) -> None:
    """Two square posts with holes front and back, and a beam between their heads."""
    h = d.size.height
    with d.mirror("y"):
        post = d.box(Box.sized(TUBE, TUBE, h, (x, gauge / 2 - TUBE / 2, 0.0)), frame, 0.004)
        for face in (post.front(0.0), post.back(0.0)):
            for cell in face.inset(z=0.25).rows(12):
                d.print(cell.place(width=0.02, height=0.02), "black plastic", oval=True)
    d.box(Box.around((x, 0.0, h - 0.05), 0.06, gauge, 0.06), frame, 0.004)


@draws("squat_rack", whole=True)
def squat_rack(d: Drawing) -> None:
    """A power cage of four uprights with cross beams, hooks and a loaded barbell."""
    frame, box, h = d.material("frame", FRAMES), d.bounds, d.size.height
    x0, x1 = box.x[0] + 0.04, box.x[1] - 0.3
    cage = min(1.24, 0.6 * box.width)
    for name, x in (("back", x0), ("front", x1)):
        with d.part(name):
            _uprights(d, x, cage, frame)
    with d.part("back"):
        d.box(Box.around((x0, 0.0, 0.28), 0.06, cage, 0.06), frame, 0.004)
    y = cage / 2 - TUBE / 2
    with d.mirror("y"):
        with d.part("foot"):
            d.box(Box(box.x, (y - 0.035, y + 0.035), (0.0, TUBE)), frame, 0.004)
            d.box(Box((x0, x1), (y - 0.02, y + 0.02), (0.48, 0.54)), "yellow plastic", 0.006)
        with d.part("top"):
            d.box(Box((x0, x1), (y - 0.03, y + 0.03), (h - 0.08, h - 0.02)), frame, 0.004)
    with d.part("front"):
        d.bar((x1 - 0.1, -y, h - 0.05), (x1 - 0.1, y, h - 0.05), 0.016, "chrome")
    z = d.uniform("bar height", 1.25, 1.45)
    with d.part("barbell"):
        hook = [(0, 0), (1, 0.53), (1, 1), (0.82, 1), (0.82, 0.7), (0, 0.7)]
        with d.mirror("y"):
            d.silhouette(Box((x1, x1 + 0.11), (y - 0.03, y + 0.03), (z - 0.12, z + 0.03)), hook, "black plastic")
        barbell(d, x1 + 0.06, z, box.width, plates(d, d.integer("plates each side", 1, 3)), 0.225)
    d.zone("inside", (x0, box.x[1]), (-cage / 2, cage / 2))


@draws("smith_machine", whole=True)
def smith_machine(d: Drawing) -> None:
    """A frame with two guide rods on which a barbell runs up and down."""
    frame, box, h = d.material("frame", FRAMES), d.bounds, d.size.height
    x, gauge = box.x[0] + 0.3, 0.56 * box.width
    y, z = gauge / 2 - 0.04, d.uniform("bar height", 1.0, 1.4)
    with d.part("frame"):
        _uprights(d, x, gauge, frame)
        d.box(Box.sized(TUBE, gauge, TUBE, (x, 0.0, 0.0)), frame, 0.004)
        with d.mirror("y"):
            d.bar((x + 0.1, y, 0.06), (x + 0.1, y, h - 0.04), 0.014, "chrome")
            for at in (0.12, h - 0.1):
                d.box(Box.around((x + 0.06, y, at), 0.12, 0.06, 0.06), frame, 0.004)
    with d.mirror("y"), d.part("foot"):
        d.box(Box(box.x, (y - 0.04, y + 0.04), (0.0, TUBE)), frame, 0.004)
        beam(d, (x, y, 0.7), (box.x[0] + 0.05, y, 0.05), frame, 0.05)
    with d.part("bar"):
        with d.mirror("y"):
            d.box(Box.around((x + 0.13, y, z), 0.12, 0.06, 0.12), "black plastic", 0.006)
        barbell(d, x + 0.16, z, box.width, plates(d, 2), 0.225)


@draws("dumbbell_rack", whole=True)
def dumbbell_rack(d: Drawing) -> None:
    """Two or three sloping tiers full of dumbbells, larger ones below."""
    frame, box = d.material("frame", FRAMES), d.bounds
    head = d.material("heads", "rubber, black plastic, iron, grey plastic")
    depth, w, h = d.size
    with d.mirror("y"):
        side = d.box(box.left(0.06).bottom(0.06), frame, 0.004)
        y = side.center[1]
        beam(d, (depth / 2 - 0.16, y, 0.04), (-depth / 2 + 0.06, y, h - 0.04), frame, 0.06)
    tiers = 2 if h < 0.9 else 3
    for share in (k / (tiers - 1) for k in range(tiers)):
        z, size = 0.24 + share * (h - 0.42), 0.31 - 0.07 * share
        x = depth / 2 - 0.07 - (z - 0.04) / (h - 0.08) * (depth - 0.22)
        count = min(10, int((w - 0.14) / (size * 0.55)))
        with d.at(x, z=z, pitch=0.35):
            tray = Box((-0.14, 0.12), (-w / 2 + 0.03, w / 2 - 0.03), (-0.012, 0.012))
            for rail in (tray.front(0.06), tray.inset(front=0.18).front(0.06), tray.back(0.04).inset(bottom=-0.038)):
                d.box(rail, frame)
            reach = (count - 1) / 2 * (w - 0.2) / count
            at = 0.012 + 0.2 * size
            with d.along((0.0, -reach, at), (0.0, reach, at), count), d.at(yaw=math.pi / 2):
                dumbbell(d, size, head)


@draws("weight_plate_rack", whole=True)
def weight_plate_rack(d: Drawing) -> None:
    """A tree with pegs on both sides, weight plates on them."""
    frame, (depth, w, h) = d.material("frame", FRAMES), d.size
    reach = depth / 2 - TUBE / 2
    beam(d, (-reach, 0.0, 0.05), (reach, 0.0, 0.05), frame, TUBE)
    with d.mirror("x"):
        beam(d, (reach, -0.4 * w, TUBE / 2), (reach, 0.4 * w, TUBE / 2), frame, TUBE)
        beam(d, (0.09, 0.0, 0.05), (0.045, 0.0, h), frame, 0.06)
    step = (h - 0.42) / 2
    for k, look in enumerate(plates(d, 3)):
        z, radius = 0.3 + k * step, min(0.22 - 0.035 * k, 0.49 * step)
        with d.mirror("y"):
            d.bar((0.0, 0.0, z), (0.0, w / 2, z), 0.022, "chrome", segments=12)
            for i in range(d.integer(f"plates {k}", 2, 3)):
                plate(d, (0.0, 0.09 + 0.047 * i, z), radius, 0.04, look)


def _kettlebell(d: Drawing, r: float, look: Look) -> None:
    body = [(0.6, 0.0), (0.84, 0.1), (0.97, 0.32), (1.0, 0.52), (0.93, 0.74), (0.75, 0.9), (0.5, 1.0)]
    d.sections(Box.sized(2 * r, 2 * r, 1.75 * r), [(a, a, z) for a, z in body], look, convex=True)
    d.arch((0.0, -0.55 * r, 1.5 * r), (0.0, 0.55 * r, 1.5 * r), (0.0, 0.0, 1.2 * r), 0.17 * r, "black steel", 7)


@draws("kettlebell", whole=True)
def kettlebell(d: Drawing) -> None:
    """One kettlebell."""
    look = d.material("bell", "iron, black steel, red plastic, blue plastic, green plastic, rubber")
    _kettlebell(d, 0.1, look)


@draws("kettlebell_rack", whole=True)
def kettlebell_rack(d: Drawing) -> None:
    """Two shelves with kettlebells."""
    frame, box, h = d.material("frame", FRAMES), d.bounds, d.size.height
    colors = ("rubber", "red plastic", "blue plastic", "yellow plastic", "green plastic", "orange plastic")
    colored = d.chance("coloured", 0.4)
    with d.mirror("y"):
        end = box.left(0.04)
        d.silhouette(end, [(0, 0), (1, 0), (1, 0.06 / h), (0.16 / box.depth, 1), (0, 1)], frame)
    for k, r in enumerate((0.1, 0.075)):
        shelf = box.inset(y=0.04, back=0.01, front=0.1 + 0.3 * k * box.depth).bottom(0.03).move(z=0.11 + k * (h - 0.46))
        d.box(shelf, frame)
        d.box(shelf.front(0.015).inset(top=-0.025), frame)
        for i, cell in enumerate(shelf.columns(int(shelf.width / (2.3 * r)))):
            with d.at(*cell.anchor("top")):
                _kettlebell(d, r, colors[i % 6] if colored else "iron")


@draws("dumbbell", whole=True)
def one_dumbbell(d: Drawing) -> None:
    """One hexagonal or round dumbbell."""
    _, w, h = d.size
    look = d.material("heads", "rubber, iron, blue plastic, grey plastic, red plastic")
    if d.chance("hexagonal", 0.6):
        with d.at(z=0.2 * w):
            dumbbell(d, w, look)
        return
    d.bar((0.0, -0.25 * w, h / 2), (0.0, 0.25 * w, h / 2), 0.016, "chrome", segments=12)
    with d.mirror("y"):
        for k in range(3):
            plate(d, (0.0, w * (0.24 + 0.085 * k), h / 2), h / 2 * (1 - 0.12 * k), 0.08 * w, look)
        disc(d, (0.0, w / 2 - 0.005, h / 2), 0.022, 0.01, "chrome", sides=12)


@draws("barbell", whole=True)
def one_barbell(d: Drawing) -> None:
    """A long bar with bumper plates, on the floor."""
    _, w, h = d.size
    barbell(d, 0.0, h / 2, w, plates(d, d.integer("plates each side", 1, 3)), h / 2)


@draws("cable_machine", whole=True)
def cable_machine(d: Drawing) -> None:
    """Two towers with weight stacks, a beam with pull-up grips, pulleys and handles."""
    frame, box, h = d.material("frame", FRAMES), d.bounds, d.size.height
    z = d.uniform("carriage", 0.5, h - 0.7)
    with d.mirror("y"):
        with d.part("tower"):
            tower = box.left(0.26)
            d.box(tower.bottom(0.07), frame, 0.008)
            d.box(tower.top(0.12).inset(x=0.05, y=0.01), frame, 0.008)
            d.box(tower.inset(back=0.06, bottom=0.07, top=0.1).back(0.04), "grey plastic", 0.004)
            with d.at(0.0, tower.center[1]):
                with d.mirror("y"):
                    d.bar((-0.1, 0.08, 0.07), (-0.1, 0.08, h - 0.1), 0.013, "chrome", segments=8)
                stack = Box.sized(0.16, 0.22, 0.54, (-0.1, 0.0, 0.12))
                for slab in stack.rows(12, gap=0.003):
                    d.box(slab, "iron")
                d.box(stack.front(-0.008).place(width=0.03, height=0.02), "yellow plastic")
                d.bar((-0.1, 0.0, 0.66), (-0.1, 0.0, h - 0.08), 0.006, "black plastic", segments=6)
                d.box(Box.sized(0.06, 0.06, h - 0.13, (0.13, 0.0, 0.07)), frame)
                d.box(Box.around((0.13, 0.0, z), 0.14, 0.1, 0.18), "black plastic", 0.008)
                disc(d, (0.2, 0.0, z), 0.055, 0.025, "grey plastic", sides=16)
                d.bar((0.25, 0.0, z - 0.02), (0.26, 0.0, z - 0.2), 0.005, "black plastic", segments=6)
                grip = [(0.26, 0.0, z - 0.2), (0.26, -0.06, z - 0.3), (0.26, 0.06, z - 0.3)]
                d.sweep(grip, 0.008, "rubber", segments=8, closed=True)
        with d.part("beam"):
            d.sweep([(0.12, 0.2, h - 0.06), (0.3, 0.25, h - 0.06), (0.34, 0.5, h - 0.1)], 0.016, "rubber")
    with d.part("beam"):
        d.box(Box.around((0.12, 0.0, h - 0.05), 0.08, box.width - 0.2, 0.08), frame, 0.004)


@draws("leg_press", whole=True)
def leg_press(d: Drawing) -> None:
    """A reclined seat that faces a large foot plate on a sled; it slides up inclined rails, discs on its pegs."""
    frame, pad = d.material("frame", FRAMES), d.material("pad", "black leather, brown leather")
    box, (_, w, h) = d.bounds, d.size
    gauge, x0, x1 = 0.3 * w, box.x[0], box.x[1]
    low, high = (x0 + 0.72, 0.2), (x1 - 0.06, h - 0.1)
    with d.mirror("y"):
        d.box(Box(box.x, (gauge - 0.03, gauge + 0.03), (0.0, 0.06)), frame)
        d.bar((low[0], gauge, low[1]), (high[0], gauge, high[1]), 0.026, "chrome", segments=12)
        beam(d, (high[0], gauge, 0.05), (high[0], gauge, h - 0.05), frame, 0.06)
        beam(d, (low[0], gauge, 0.05), (low[0], gauge, low[1] + 0.03), frame, 0.06)
        beam(d, (low[0] + 0.1, gauge, 0.05), (high[0], gauge, 0.6 * h), frame, 0.05)
        d.bar((x0 + 0.6, gauge, 0.06), (x0 + 0.6, gauge + 0.04, 0.52), 0.014, frame, segments=8)
        d.bar((x0 + 0.6, gauge + 0.04, 0.52), (x0 + 0.74, gauge + 0.04, 0.56), 0.019, "rubber", segments=8)
    for x, z in ((x0 + 0.03, 0.03), (x1 - 0.06, 0.03), (high[0], h - 0.08)):
        d.box(Box.around((x, 0.0, z), 0.06, 2 * gauge, 0.06), frame)
    d.box(Box((x0 + 0.03, x0 + 0.95), (-0.04, 0.04), (0.02, 0.1)), frame)
    beam(d, (x0 + 0.18, 0.0, 0.05), (x0 + 0.32, 0.0, 0.56), frame, 0.07)
    d.box(Box((x0 + 0.6, x0 + 0.92), (-0.06, 0.06), (0.06, 0.2)), frame)
    with d.at(x0 + 0.64, z=0.24, pitch=0.8):  # the back rest, with a head pad
        rest = Box((-0.72, 0.0), (-0.8 * gauge, 0.8 * gauge), (0.0, 0.08))
        d.cushion(rest, pad, 0.03)
        d.box(rest.bottom(-0.03).inset(x=0.06, y=0.1), frame)
        d.cushion(Box((-0.94, -0.74), (-0.16, 0.16), (0.0, 0.08)), pad, 0.03)
        d.box(Box((-0.9, -0.6), (-0.03, 0.03), (-0.03, 0.005)), frame)
    with d.at(x0 + 0.6, z=0.19, pitch=-0.22):
        d.cushion(Box((0.0, 0.38), (-0.8 * gauge, 0.8 * gauge), (0.0, 0.08)), pad, 0.03)
    share, angle = 0.55, math.atan2(high[1] - low[1], high[0] - low[0])
    looks = plates(d, 2)
    with d.at(low[0] + share * (high[0] - low[0]), z=low[1] + share * (high[1] - low[1]), pitch=-angle):
        d.box(Box((-0.1, 0.18), (-gauge - 0.05, gauge + 0.05), (0.03, 0.09)), "black steel", 0.006)
        foot = d.box(Box((-0.13, -0.1), (-1.1 * gauge, 1.1 * gauge), (0.03, 0.6)), "steel", 0.008)
        for rib in foot.back(0.0).inset(y=0.05, z=0.05).rows(9):
            d.print(rib.inset(z=0.014), "rubber")
        with d.mirror("y"):
            beam(d, (0.14, 0.8 * gauge, 0.07), (-0.1, 0.8 * gauge, 0.5), "black steel", 0.05)
            d.bar((0.04, gauge, 0.12), (0.04, w / 2, 0.12), 0.024, "chrome")
            for k, look in enumerate(looks):
                plate(d, (0.04, gauge + 0.11 + 0.05 * k, 0.12), 0.21, 0.042, look)


@draws("pull_up_bar", whole=True)
def pull_up_bar(d: Drawing) -> None:
    """A tower with a pull-up bar, dip handles and a back pad."""
    frame, box, h = d.material("frame", FRAMES), d.bounds, d.size.height
    x, y, mid = box.x[0] + 0.25, 0.36 * box.width, h / 2
    with d.mirror("y"):
        with d.part("side"):
            d.box(Box(box.x, (y + 0.03, y + 0.09), (0.0, 0.06)), frame)
            beam(d, (x, y + 0.06, 0.03), (x, y, mid), frame, 0.06)
            beam(d, (x, y, mid), (x, y, h - 0.02), frame, 0.055)
        with d.part("dips"):
            d.box(Box((x, box.x[1] - 0.06), (y - 0.025, y + 0.025), (mid - 0.03, mid + 0.02)), frame)
            d.cushion(Box((x + 0.03, x + 0.33), (y - 0.06, y + 0.06), (mid + 0.015, mid + 0.06)), "black leather", 0.02)
            d.bar((box.x[1] - 0.1, y, mid), (box.x[1] - 0.1, y, mid + 0.16), 0.017, "rubber")
    with d.part("back"):
        d.box(Box.around((x, 0.0, mid), 0.06, 2 * y, 0.06), frame)
        d.box(Box.sized(0.04, 0.08, 0.18 * h, (x, 0.0, mid)), frame)
        d.cushion(Box((x + 0.02, x + 0.08), (-0.14, 0.14), (0.52 * h, 0.68 * h)), "black leather", 0.025)
    with d.part("bar"):
        half = [(x + 0.12, -box.width / 2, h - 0.13), (x + 0.08, -1.05 * y, h - 0.03), (x, -0.8 * y, h - 0.02)]
        d.sweep([*half, *((px, -py, z) for px, py, z in reversed(half))], 0.017, "rubber")
    with d.part("brace"):
        d.box(box.back(0.06).bottom(0.06).place(width=2 * y + 0.12), frame)


@draws("gym_bench", whole=True)
def gym_bench(d: Drawing) -> None:
    """A locker room bench: slats on steel legs."""
    wood = d.material("slats", "beech, oak, pine, white plastic")
    metal = d.material("legs", "steel, black steel, white steel, grey paint")
    box, h = d.bounds, d.size.height
    for slat in box.top(0.03).split("x", 3 if box.depth < 0.36 else 4, gap=0.002):
        d.box(slat, wood, 0.001)
    y = box.width / 2 - 0.15
    with d.along((0.0, -y, 0.0), (0.0, y, 0.0), 2 if box.width < 1.5 else 3):
        with d.mirror("x"):
            d.box(Box.sized(0.04, 0.04, h - 0.03, (box.x[1] - 0.04, 0.0, 0.0)), metal)
        d.box(Box.sized(box.depth - 0.08, 0.04, 0.04, (0.0, 0.0, h - 0.07)), metal)
    d.box(Box.sized(0.03, 2 * y, 0.03, (0.0, 0.0, h - 0.065)), metal)
    d.surface("top", box.inset(x=0.015, y=0.01))
