"""Bathtubs and showers."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import CORNERS, bar_pull, bowl, drain, vessel

_METALS = "chrome, black steel, brushed steel, brass"


@draws("bathtub")
def bathtub(d: Drawing) -> None:
    """A hollow tub behind a panelled apron, with rim, drain, overflow and a mixer on its end."""
    white = d.material("tub", "white ceramic")
    metal = d.material("tap", _METALS)
    apron = d.material("apron", "white paint, white ceramic, oak, sage paint, marble, grey paint")
    end, power = d.pick("end", [-1, 1]), d.pick("shape", [4.0, 6.0, 3.0])
    box = d.bounds.inset(top=0.118)
    h, room = box.z[1], box.inset(x=0.055, y=0.07)
    with d.part("tub"):
        deep, wide = box.depth, box.width
        shell = ((1 - 0.024 / deep, 1 - 0.024 / wide, 0.04), (1 - 0.024 / deep, 1 - 0.024 / wide, h - 0.035))
        plan = (room.depth / deep, room.width / wide)
        inner = ((1.0, 1.0, h), (0.97, 0.985, h - 0.05), (0.84, 0.9, 0.17), (0.6, 0.8, 0.11, 3.0))
        inside = [(u * plan[0], v * plan[1], z, *(own or [power])) for u, v, z, *own in inner]
        bowl(d, box, (*shell, (1.0, 1.0, h - 0.03), (1.0, 1.0, h)), inside, white, 24.0, 20)
        front = d.box(box.front(0.02).inset(y=0.004, top=0.036).move(x=-0.005), apron, 0.002)
        d.box(box.bottom(0.05).inset(x=0.03, y=0.016), "white plastic", 0.0)
        if d.chance("panels", 0.7):
            field = front.front(-0.005).inset(back=-0.001, y=0.03, z=0.02)
            columns = field.columns(4 if box.width > 1.6 else 3)
            for stile in [cell.right(0.044).move(y=-0.022 if k else 0.0) for k, cell in enumerate(columns)]:
                d.box(stile, apron, 0.001)
            for rail in (field.top(0.045), field.bottom(0.045), field.left(0.044)):
                d.box(rail.inset(front=0.0004), apron, 0.001)
        drain(d, (0.0, end * 0.45 * room.width / 2, 0.11), 0.032)
        overflow = (0.0, end * 0.455 * room.width, h - 0.12)
        d.cylinder(Box.around(overflow, 0.072, 0.05, 0.072), "chrome", "y", segments=18)
    with d.part("tap"), d.at(0.0, end * (box.width / 2 - 0.035), h, yaw=-end * math.pi / 2):
        with d.mirror("y"), d.at(0.0, 0.075):
            d.cylinder(Box.sized(0.044, 0.044, 0.035), metal, ends=(1.0, 0.82), segments=14)
            d.cylinder(Box.sized(0.026, 0.026, 0.03, (0.0, 0.0, 0.035)), metal, segments=12)
            d.bar((0.0, -0.028, 0.065), (0.0, 0.028, 0.065), 0.008, metal, 8)
        d.cylinder(Box.sized(0.048, 0.048, 0.05), metal, ends=(1.0, 0.85), segments=14)
        spout = ((0.0, 0.045), (0.01, 0.085), (0.06, 0.11), (0.12, 0.1), (0.14, 0.075))
        d.sweep([(x, 0.0, z) for x, z in spout], 0.014, metal)
    d.fit()


@draws("freestanding_bathtub")
def freestanding_bathtub(d: Drawing) -> None:
    """An egg-shaped shell, or one with a rolled rim on four feet; a filler on the floor at its back."""
    box, (deep, w, total) = d.bounds, d.size
    h = total - 0.28
    footed = d.style in ("classic", "rustic") or d.chance("feet", 0.2)
    low, rim = (0.13, 0.055) if footed else (0.0, 0.035)
    with d.part("tub"):
        outer = ((0.72, 0.78, 0.0), (0.76, 0.81, 0.04), (0.88, 0.91, 0.3), (1.0, 1.0, h))
        if footed:
            outer = ((0.55, 0.66, low), (0.8, 0.84, low + 0.06), (0.92, 0.94, 0.35), (0.945, 0.965, h - 0.03))
            outer += ((1.0, 1.0, h - 0.026), (1.0, 1.0, h - 0.008), (1 - 0.02 / deep, 1 - 0.02 / w, h))
            metal = d.material("feet", "brass, chrome, black steel, bronze")
            with d.mirror("x", "y"), d.at(0.29 * deep, 0.31 * w):
                claw = ((0.0, 0.0, low + 0.12), (0.045, 0.05, low + 0.05), (0.03, 0.035, 0.06), (0.055, 0.06, 0.028))
                d.sweep(claw, 0.018, metal, 8)
                d.ball(Box.around((0.055, 0.06, 0.02), 0.056, 0.056, 0.04), metal, 12)
        edge = (1 - 2 * rim / deep, 1 - 2 * rim / w, h)
        inner = (edge, (0.82, 0.88, 0.55 * h), (0.66, 0.72, low + 0.12), (0.5, 0.6, low + 0.08))
        bowl(d, box, outer, inner, d.material("tub", "white ceramic"), 2.5, 20, (2, 1))
        drain(d, (0.0, 0.0, low + 0.08), 0.032 if footed else 0.05)
    # Beside the oval there is room for a filler in a corner of the box; it pours over the rim.
    end = d.pick("end", [-1, 1])
    with d.part("tap"), d.at(0.035 - deep / 2, end * (w / 2 - 0.09), yaw=math.atan2(-0.2 * end, 0.16)):
        metal = d.material("tap", _METALS)
        d.cylinder(Box.sized(0.066, 0.066, 0.012), metal, segments=18)
        pipe = ((0.0, 0.01), (0.0, total - 0.06), (0.025, total - 0.02), (0.07, total - 0.013), (0.2, total - 0.013))
        d.sweep([(x, 0.0, z) for x, z in pipe], 0.013, metal, 12)
        d.bar((0.19, 0.0, total - 0.06), (0.19, 0.0, total - 0.012), 0.012, metal, 12)
        d.bar((-0.03, 0.0, h + 0.08), (0.03, 0.0, h + 0.08), 0.02, metal, 12)
        d.bar((0.0, 0.0, h + 0.08), (0.0, 0.06 * end, h + 0.09), 0.006, metal, 8)
    d.fit()


def _column(d: Drawing, h: float, metal: Look) -> None:
    """A riser on a wall behind the frame's origin: a mixer, a rain head at height ``h``, a hand shower on a hose."""
    with d.part("column"):
        d.box(Box((0.0, 0.045), (-0.14, 0.14), (1.02, 1.06)), metal, 0.008)
        with d.mirror("y"):
            d.cylinder(Box.around((0.0225, 0.157, 1.04), 0.04, 0.036, 0.04), metal, "y", segments=14)
        riser = ((0.03, 1.05), (0.03, h - 0.14), (0.06, h - 0.07), (0.12, h - 0.05), (0.32, h - 0.05))
        d.sweep([(x, 0.0, z) for x, z in riser], 0.011, metal)
        d.cylinder(Box.sized(0.22, 0.22, 0.012, (0.32, 0.0, h - 0.085)), metal)
        d.cylinder(Box.sized(0.06, 0.06, 0.023, (0.32, 0.0, h - 0.073)), metal, ends=(1.0, 0.5), segments=12)
        d.bar((0.03, 0.0, 1.5), (0.085, -0.02, 1.5), 0.012, metal, 8)
        d.bar((0.075, -0.02, 1.38), (0.1, -0.02, 1.58), 0.011, metal)
        with d.at(0.105, -0.02, 1.6, pitch=1.9):
            d.cylinder(Box.around((0.0, 0.0, 0.0), 0.09, 0.09, 0.024), metal, ends=(1.0, 0.7), segments=16)
        hose = [(0.075, -0.02, 1.385), (0.07, -0.04, 1.15), (0.06, -0.06, 0.85), (0.05, -0.05, 0.75)]
        d.sweep([*hose, (0.035, -0.02, 0.8), (0.03, -0.005, 1.02)], 0.007, "steel", 6)


def _grip(d: Drawing, x: float, y: float, metal: Look) -> None:
    """An upright handle before a pane at (x, y)."""
    bar_pull(d, (x, y, 0.95), (x, y, 1.25), metal, 0.009, 0.028, 0.1)


@draws("shower")
def shower(d: Drawing) -> None:
    """A tray between two walls, panes with a door in front and a shower column; open above."""
    white = d.material("tray", "white ceramic, white ceramic, dark marble, concrete")
    metal = d.material("frame", "chrome, black steel, brushed steel, brass")
    box, rail = d.bounds.inset(front=0.03), 0.025
    h, tray = box.z[1], box.bottom(0.06)
    with d.part("tray"):
        rows = ((0.0, 0.0, 0.01), (0.0, 0.06, 0.01), (0.04, 0.06, 0.03), (0.06, 0.03, 0.03))
        rings = [shapes.rectangle(box.inset(x=e).x, box.inset(y=e).y, z, r) for e, z, r in rows]
        vessel(d, rings[:2], rings[2:], white, CORNERS)
        drain(d, (tray.center[0], 0.0, 0.03), 0.045)
    room = box.inset(bottom=0.06)
    with d.part("back"):
        wall = d.box(room.back(0.012), d.material("wall", "white paint, marble, light grey paint"), 0.0)
        for z in np.arange(0.36, h - 0.1, 0.3).tolist():
            d.print(wall.front(0.0).to(z=(z - 0.0015, z + 0.0015)), "grey plastic")
    cage = room.inset(back=0.012, front=0.005)
    left = d.chance("left pane", 0.75)
    for name, side in (("right pane", cage.right(rail)), ("left pane", cage.left(rail)))[: 1 + left]:
        with d.part(name):
            for bar in (side.front(rail), side.back(0.018), side.top(rail), side.bottom(rail)):
                d.box(bar, metal, 0.0)
            d.box(side.inset(x=rail, z=rail).place(width=0.008), "glass", 0.0)
    front = cage.front(rail).inset(right=rail, left=rail if left else 0.0)
    with d.part("front"):
        for bar in (front.top(rail), front.bottom(rail)):
            d.box(bar, metal, 0.002)
        opening, fixed = front.inset(z=rail), 0.4 * front.width if front.width > 0.9 else 0.0
        if fixed:
            d.box(opening.right(fixed).place(depth=0.008), "glass", 0.0)
            d.box(opening.right(fixed + 0.008).left(0.016), metal, 0.002)
        leaf = opening.inset(right=fixed + 0.01 if fixed else 0.003, left=0.002, bottom=0.004, top=0.004)
        with d.hinge("door", opening.anchor("front left bottom"), limits=(0.0, 1.7)):
            glass = d.box(leaf.place(depth=0.008), "glass", 0.0)
            _grip(d, glass.x[1], glass.y[0] + 0.06, metal)
    with d.at(cage.x[0], 0.0):
        _column(d, h, metal)
    d.fit()


@draws("corner_shower")
def corner_shower(d: Drawing) -> None:
    """A quadrant tray with round sliding panes toward the room; the corner of the walls is at -x, +y."""
    metal = d.material("frame", "chrome, black steel, brushed steel")
    white = d.material("tray", "white ceramic, white ceramic, dark marble")
    (x0, x1), (y0, y1), (_, h) = d.bounds.x, d.bounds.y, d.bounds.z
    radius, turn = 0.62, np.linspace(-math.pi / 2, 0.0, 9)

    def line(inset: float) -> list[tuple[float, float]]:
        """From the right wall along the front to the left wall's end."""
        r = radius - inset
        curve = np.c_[x1 - radius + r * np.cos(turn), y0 + radius + r * np.sin(turn)]
        return [(x0 + inset, y0 + inset), *curve.tolist(), (x1 - inset, y1 - inset)]

    with d.part("tray"):
        rows = ((0.0, 0.0), (0.0, 0.09), (0.06, 0.09), (0.08, 0.05))
        plans = [(np.array([*line(e), (x0 + e, y1 - e)]), z) for e, z in rows]
        rings = [np.c_[plan, np.full(len(plan), z)] for plan, z in plans]
        vessel(d, rings[:2], rings[2:], white, range(len(rings[0]) + 1))
        drain(d, (0.0, 0.0, 0.05), 0.045)
    path = line(0.03)
    flat = np.array([(-0.012, -0.015), (0.012, -0.015), (0.012, 0.015), (-0.012, 0.015)])
    names = ["right pane", *(f"curve {k // 4}" for k in range(len(path) - 3)), "left pane"]
    for k, (start, end) in enumerate(zip(path[:-1], path[1:], strict=True)):
        with d.part(names[k]):
            for z in (0.105, h - 0.015):
                d.bar((*start, z), (*end, z), flat, metal)
            (ax, ay), (bx, by) = start, end
            with d.at(ax, ay, yaw=math.atan2(by - ay, bx - ax)):
                pane = d.box(Box((0.0, math.hypot(bx - ax, by - ay)), (-0.004, 0.004), (0.12, h - 0.03)), "glass", 0.0)
                if "pane" in names[k]:
                    for post in (pane.front(0.016), pane.back(0.016)):
                        d.box(post.inset(y=-0.008), metal, 0.0)
    with d.part("curve 0"), d.at(*path[len(path) // 2], yaw=-math.pi / 4), d.mirror("y"):
        d.bar((0.0, 0.04, 0.12), (0.0, 0.04, h - 0.03), 0.008, metal, 8)
        _grip(d, 0.0, 0.04, metal)
    with d.part("column"):
        corner = [(x0, y1), (x0, y1 - 0.1), (x0 + 0.1, y1)]
        d.hull([(x, y, z) for x, y in corner for z in (0.72, h - 0.1)], d.material("panel", "white plastic"))
    with d.at(x0 + 0.051, y1 - 0.051, yaw=-math.pi / 4):
        _column(d, h - 0.02, metal)
    d.fit()
