"""Machines to run, ride, row and climb on; the user looks toward +x."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import beam
from .gym_parts import console, disc

_BODIES = "black plastic, grey plastic, white plastic"
_METALS = "black steel, steel, white steel"
_ACCENTS = "red plastic, blue plastic, orange plastic"


@draws("treadmill", whole=True)
def treadmill(d: Drawing) -> None:
    """A belt between side rails, a motor hood, two uprights with handrails and a console."""
    body, metal = d.material("body", _BODIES), d.material("frame", _METALS, "grey paint")
    accent = d.material("accent", _ACCENTS, "yellow plastic")
    box, w = d.bounds, d.size.width
    with d.part("deck"):
        d.box(box.to(z=(0.03, 0.15)).inset(back=0.03, front=0.1, y=0.03), metal, 0.01)
        d.box(box.to(z=(0.14, 0.165)).inset(back=0.08, front=0.35).place(width=0.62 * w), "rubber", 0.004)
        disc(d, (box.x[0] + 0.06, 0.0, 0.12), 0.045, 0.7 * w, "rubber", sides=16)
        with d.mirror("y"):
            rail = d.box(box.left(0.18 * w).to(z=(0.1, 0.185)).inset(front=0.3), body, 0.012)
            d.print(rail.top(0.0).inset(back=0.1, front=0.2).place(width=0.04), accent)
            for x in (box.x[0] + 0.12, box.x[1] - 0.15):
                disc(d, (x, box.y[1] - 0.08, 0.035), 0.035, 0.05, "rubber", sides=12)
        hood = box.front(0.36).to(z=(0.04, 0.27)).inset(y=0.02)
        d.silhouette(hood, [(0, 0), (1, 0), (1, 0.7), (0.83, 1), (0.33, 1), (0, 0.57)], body, bevel=0.012)
        d.print(hood.top(0.0).share(x=(0.42, 0.74), y=(0.2, 0.8)), accent)
    x, top = box.x[1], box.height - 0.25
    with d.part("console"):
        with d.mirror("y"):
            y = box.y[1] - 0.045
            beam(d, (x - 0.12, y, 0.1), (x - 0.36, y, top), metal, 0.06, 0.09)
            d.sweep([(x - 0.3, y, top - 0.04), (x - 0.5, y, top - 0.06), (x - 0.75, y, top - 0.12)], 0.021, "rubber")
            disc(d, (x - 0.4, 0.3 * w, top + 0.031), 0.045, 0.012, "black plastic", "z", sides=16)
        tray = d.box(box.inset(y=0.03).to(x=(x - 0.48, x - 0.32), z=(top - 0.06, top + 0.03)), body, 0.015)
        d.box(tray.back(-0.012).place(width=0.06, height=0.04), "red plastic", 0.005)
        console(d, (x - 0.37, 0.0, top), 0.62 * w, 0.24)


def _feet(d: Drawing, metal: Look) -> None:
    """A beam along the machine, and a round foot across it at each end."""
    reach, y = d.size.depth / 2 - 0.05, 0.46 * d.size.width
    beam(d, (-reach, 0.0, 0.07), (reach, 0.0, 0.07), metal, 0.07)
    with d.mirror("x"):
        d.bar((reach, -y, 0.04), (reach, y, 0.04), 0.03, metal, segments=12)
        with d.mirror("y"):
            disc(d, (reach, y, 0.04), 0.04, 0.08 * d.size.width, "rubber", bevel=0.005, sides=16)


def _cranks(d: Drawing, x: float, z: float, y: float, reach: float) -> None:
    """A pedal crank on each side of an axle, one forward and one back."""
    d.bar((x, -y, z), (x, y, z), 0.02, "steel")
    for side in (-1, 1):
        end = (x + side * 0.75 * reach, side * y, z - side * 0.65 * reach)
        beam(d, (x, side * y, z), end, "steel", 0.014, 0.03)
        d.box(Box.around((end[0], end[1] + side * 0.05, end[2]), 0.1, 0.1, 0.024), "black plastic", 0.005)


def _saddle(d: Drawing, x: float, z: float, long: float, wide: float) -> None:
    """A saddle whose nose points forward."""
    half = [(-0.5, -0.42), (-0.1, -0.5), (0.2, -0.2), (0.5, -0.11)]
    outline = [*half, *((u, -v) for u, v in reversed(half))]
    points = []
    for scale, rise, tail in ((0.8, 0.0, 0.0), (1.0, 0.035, 0.0), (0.85, 0.06, 0.015)):
        points += [(x + scale * u * long, scale * v * wide, z + rise + tail * (u < 0)) for u, v in outline]
    d.hull(points, "black leather")


@draws("exercise_bike", whole=True)
def exercise_bike(d: Drawing) -> None:
    """An upright bike: round drive housing, saddle on a post, handlebar, console."""
    body, accent = d.material("body", _BODIES), d.material("accent", _ACCENTS, "green plastic")
    metal = d.material("frame", _METALS)
    (depth, _, h), y = d.size, 0.46 * d.size.width
    _feet(d, metal)
    for thick, radius, look in ((0.13, 0.27, body), (0.142, 0.2, accent), (0.15, 0.16, body)):
        disc(d, (0.12, 0.0, 0.36), radius, thick, look, bevel=0.012, sides=28)
    shell = Box((-0.2, 0.3), (-0.06, 0.06), (0.08, 0.6))
    d.silhouette(shell, [(0, 0), (1, 0), (1, 0.54), (0.6, 1), (0.2, 0.92), (0, 0.52)], body, bevel=0.015)
    _cranks(d, 0.02, 0.3, 0.11, 0.16)
    beam(d, (-0.13, 0.0, 0.25), (-0.25 * depth, 0.0, 0.66 * h), metal, 0.05)
    _saddle(d, -0.25 * depth, 0.66 * h, 0.26, 0.24)
    beam(d, (0.2, 0.0, 0.45), (0.27, 0.0, h - 0.2), metal, 0.06)
    with d.at(0.27, z=h - 0.24):
        grips = [(-0.28, y - 0.03, 0.05), (-0.084, y, 0.02), (0.0, 0.4 * y, 0.0)]
        d.sweep([*grips, *((px, -py, pz) for px, py, pz in reversed(grips))], 0.016, "rubber")
    console(d, (0.24, 0.0, h - 0.22), 0.26, 0.2)


@draws("spin_bike", whole=True)
def spin_bike(d: Drawing) -> None:
    """A racing frame with a heavy bare flywheel in front."""
    metal = d.material("frame", "black steel, red paint, white steel, yellow paint, grey paint")
    depth, _, h = d.size
    axle, crank = (0.24 * depth, 0.34), (-0.04, 0.33)
    _feet(d, metal)
    disc(d, (axle[0], 0.0, axle[1]), 0.235, 0.03, "steel", bevel=0.006, sides=32)
    disc(d, (axle[0], 0.0, axle[1]), 0.13, 0.05, "black plastic", bevel=0.006)
    head = (axle[0] - 0.06, 0.74)
    with d.mirror("y"):
        beam(d, (axle[0], 0.045, axle[1]), (head[0], 0.045, head[1]), metal, 0.018, 0.05)
        beam(d, (axle[0], 0.045, axle[1]), (axle[0] + 0.08, 0.045, 0.07), metal, 0.018, 0.05)
    disc(d, (crank[0], 0.05, crank[1]), 0.1, 0.03, "black plastic", bevel=0.005)
    guard = [(x, y, z + s) for x, z in (crank, axle) for y in (0.04, 0.065) for s in (-0.045, 0.045)]
    d.hull(guard, "black plastic")
    _cranks(d, *crank, 0.09, 0.17)
    back = -0.22 * depth
    tubes = [  # from and to, in x and z, and how wide
        (head, crank, 0.06, metal),
        ((crank[0], 0.07), (back, 0.62), 0.06, metal),
        ((back, 0.6), (back - 0.05 * depth, 0.78 * h), 0.035, "steel"),
        ((back - 0.12 * depth, 0.78 * h), (back + 0.04 * depth, 0.78 * h), 0.035, "steel"),
        (head, (head[0] - 0.03, 0.9 * h), 0.04, "steel"),
        ((head[0] - 0.14, 0.9 * h), (head[0] + 0.08, 0.9 * h), 0.035, "steel"),
    ]
    for (x0, z0), (x1, z1), wide, look in tubes:
        beam(d, (x0, 0.0, z0), (x1, 0.0, z1), look, wide)
    _saddle(d, back - 0.04 * depth, 0.79 * h, 0.27, 0.18)
    y, top = min(d.size.width / 2, 0.24), h - 0.05
    with d.at(axle[0]), d.mirror("y"):
        horn = [(0.0, 0.0, 0.91 * h), (0.0, y, 0.92 * h), (0.14, y, top), (0.22, 0.7 * y, top + 0.03)]
        d.sweep(horn, 0.015, "rubber")


@draws("elliptical", whole=True)
def elliptical(d: Drawing) -> None:
    """Housing at the back, two long foot bars with treads, swinging handles, console."""
    body, metal = d.material("body", _BODIES), d.material("frame", "black steel, steel, grey paint")
    accent = d.material("accent", _ACCENTS)
    depth, w, h = d.size
    _feet(d, metal)
    x, px = -depth / 2 + 0.38, 0.28 * depth
    for radius, thick, look in ((0.33, 0.17, body), (0.22, 0.182, accent), (0.19, 0.186, body)):
        disc(d, (x, 0.0, 0.39), radius, thick, look, bevel=0.01, sides=28)
    beam(d, (px + 0.1, 0.0, 0.07), (px - 0.02, 0.0, h - 0.25), metal, 0.09)
    d.bar((px, -0.4 * w, 0.55 * h), (px, 0.4 * w, 0.55 * h), 0.025, metal)
    for s in (-1, 1):  # the cranks stand opposite each other, and so do the handles
        y, outer = s * (w / 2 - 0.15), s * 0.4 * w
        crank, foot = (x + s * 0.13, y, 0.39 + s * 0.09), (px - 0.02 + s * 0.1, y, 0.3)
        beam(d, (x, 0.0, 0.39), (x, y, 0.39), "steel", 0.04)
        beam(d, (x, y, 0.39), crank, "steel", 0.03, 0.05)
        beam(d, crank, foot, metal, 0.05)
        at = [0.55 * a + 0.45 * b for a, b in zip(crank, foot, strict=True)]
        with d.at(at[0], y, at[2] + 0.035, pitch=math.atan2(crank[2] - 0.3, foot[0] - crank[0])):
            tread = d.box(Box.around((0.0, 0.0, 0.0), 0.4, 0.17, 0.04), "rubber", 0.01)
            d.box(tread.front(0.03).top(-0.04).inset(bottom=-0.02), "rubber", 0.01)
        grip = [(px - s * 0.1 - 0.02, outer, 0.82 * h), (px - 0.22 - s * 0.12, s * (w / 2 - 0.03), h - 0.03)]
        d.sweep([(foot[0], y, foot[2] - 0.01), (px, outer, 0.55 * h), *grip], 0.02, metal)
        d.bar(grip[0], grip[1], 0.026, "rubber")
    console(d, (px - 0.08, 0.0, h - 0.3), 0.32, 0.24)


@draws("rowing_machine", whole=True)
def rowing_machine(d: Drawing) -> None:
    """A fan housing in front, a long rail, sliding seat, foot plates, handle."""
    metal, body = d.material("rail", "aluminium, black steel, oak, walnut"), d.material("body", _BODIES)
    (depth, w, h), x0 = d.size, -d.size.depth / 2
    r = min(0.27, 0.28 * h)
    fan = (depth / 2 - r - 0.04, 0.0, r + 0.1)
    x, _, z = fan
    with d.part("fan"):
        disc(d, fan, r, 0.19, body, bevel=0.03, sides=28)
        with d.no_colliders():  # rings of its grille
            for k, share in enumerate((0.8, 0.75, 0.58, 0.53, 0.36, 0.31)):
                disc(d, fan, share * r, 0.1901 + 0.0001 * k, body if k % 2 else "steel", sides=28)
        d.bar((x + 0.05, -w / 2 + 0.02, 0.03), (x + 0.05, w / 2 - 0.02, 0.03), 0.03, "black steel", 12)
        beam(d, (x + 0.05, 0.0, 0.03), fan, "black steel", 0.06)
        beam(d, (x - 0.1, 0.0, z), (x - 0.3, 0.0, h - 0.06), "black steel", 0.04)
        console(d, (x - 0.32, 0.0, h - 0.2), 0.22, 0.19)
    with d.part("rail"):
        beam(d, (x0 + 0.03, 0.0, 0.34), (x, 0.0, 0.3), metal, 0.07, 0.09)
        beam(d, (x0 + 0.06, 0.0, 0.33), (x0 + 0.06, 0.0, 0.03), "black steel", 0.05)
        d.bar((x0 + 0.06, -w / 2 + 0.05, 0.025), (x0 + 0.06, w / 2 - 0.05, 0.025), 0.025, "rubber", 12)
        seat = Box.sized(0.26, 0.34, 0.055, (x0 + depth * d.uniform("seat", 0.25, 0.42), 0.0, 0.405))
        d.box(seat.inset(x=0.03, y=0.09).bottom(-0.035), "black plastic", 0.008)
        d.cushion(seat, "black leather", 0.025)
        toe = x - r - 0.12
        with d.mirror("y"), d.at(toe, 0.13, 0.33, pitch=-0.8):
            d.box(Box.around((0.0, 0.0, 0.0), 0.3, 0.11, 0.024), "grey plastic", 0.006)
            d.box(Box((-0.02, 0.03), (-0.06, 0.06), (-0.016, 0.03)), "rubber", 0.006)
        d.bar((toe, -0.16, 0.31), (toe, 0.16, 0.31), 0.015, "black steel")
        d.bar((toe + 0.14, -0.25, 0.5), (toe + 0.14, 0.25, 0.5), 0.017, "rubber")
        d.bar((toe + 0.14, 0.0, 0.5), (x, 0.0, z + 0.06), 0.008, "steel", segments=6)


@draws("stair_climber", whole=True)
def stair_climber(d: Drawing) -> None:
    """Four turning steps between side panels, handrails and a console above."""
    body = d.material("body", _BODIES, "grey paint")
    box, h = d.bounds, d.size.height
    x0, x1, y = box.x[0], box.x[1], box.y[1]
    with d.mirror("y"):
        panel = box.left(0.09).inset(back=0.1, top=0.42 * h)
        high = 0.2 / 0.58
        d.silhouette(panel, [(0, 0), (1, 0), (1, 1), (1 - 0.3 / panel.depth, 1), (0, high)], body, bevel=0.02)
        rail = y - 0.045
        beam(d, (x1 - 0.15, rail, 0.5 * h), (x1 - 0.25, rail, h - 0.26), "black steel", 0.06)
        path = [(x0 + 0.2, 0.24), (x0 + 0.28, 0.48), (x1 - 0.25, 0.72), (x1 - 0.2, 0.8)]
        d.sweep([(px, rail, share * h) for px, share in path], 0.022, "steel")
    inside = box.inset(y=0.08)
    for k in range(4):
        x, z = x0 + 0.02 + 0.24 * k, 0.08 + 0.21 * k
        tread = d.box(inside.to(x=(x, x + 0.27), z=(z - 0.06, z)), "rubber", 0.008)
        d.print(tread.back(0.0).inset(y=0.02, z=0.02), "yellow plastic")
        riser = inside.inset(y=0.01).to(x=(x + 0.2, x + 0.26), z=(max(0.0, z - 0.1), z + 0.16))
        d.box(riser, "black plastic", 0.004)
    d.box(inside.inset(front=0.02).front(0.38).bottom(0.5 * h), "black plastic", 0.01)
    d.box(box.inset(y=0.02).to(x=(x1 - 0.32, x1 - 0.16), z=(h - 0.33, h - 0.25)), body, 0.02)
    console(d, (x1 - 0.24, 0.0, h - 0.27), 0.6 * box.width, 0.28)
