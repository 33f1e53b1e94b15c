"""Tools, machines and vehicles of a garage or workshop."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import band, beam, castors, door, drawer

_LOUD = ("red paint", "blue paint", "yellow paint", "green paint", "black steel", "grey paint")


@draws("tool_chest", whole=True)
def tool_chest(d: Drawing) -> None:
    """A rolling chest of drawers in loud paint, with a mat on top and a handle at its side."""
    paint = d.material("paint", *_LOUD)
    box = d.bounds.inset(left=0.03, right=0.03)
    castors(d, box.bottom(0.11).inset(x=0.02, y=0.01))
    case = box.inset(bottom=0.11, front=0.016)
    top = d.box(case.top(0.025), "black plastic", 0.005)
    hull = case.inset(top=0.025)
    for side in (hull.left(0.02), hull.right(0.02), hull.inset(y=0.02).back(0.01), hull.inset(y=0.02).bottom(0.02)):
        d.box(side, paint)
    count = d.integer("drawers", 5, 7)
    front = case.inset(bottom=0.02, top=0.03, y=0.02, back=0.012)
    for k, cell in enumerate(front.rows([1.9, 1.9] + [1.0] * (count - 2))):
        drawer(d, f"drawer-{k}", cell, paint, "aluminium", "lip", round(0.7 * box.depth, 3), "grey plastic")
    y, z = box.y[1], case.z[1] - 0.09
    ends = (case.x[0] + 0.08, case.x[1] - 0.1)
    reach = [(x, yy, z) for x, yy in ((ends[0], y), (ends[0], y + 0.018), (ends[1], y + 0.018), (ends[1], y))]
    d.sweep(reach, 0.012, "chrome", 8)
    d.surface("top", top, inset=0.01)


@draws("tool_cabinet", whole=True)
def tool_cabinet(d: Drawing) -> None:
    """A tall steel cupboard with two doors, louvres and a lock."""
    paint = d.material("paint", *_LOUD)
    box = d.bounds
    d.box(box.inset(front=0.045), paint, 0.005)
    leaves = box.inset(front=0.025, bottom=0.06, top=0.01).front(0.02)
    for hung, leaf in zip(("right", "left"), leaves.columns(2), strict=True):
        door(d, f"door-{hung}", leaf, paint, "black plastic", hung, "none")  # type: ignore[arg-type]
        for z in (0.2, box.z[1] - 0.3):
            for slot in leaf.front(0.0).to(z=(z, z + 0.1)).share(y=(0.3, 0.7)).rows(5, gap=0.014):
                d.print(slot, "black plastic")
        side = "left" if hung == "right" else "right"
        grip = leaf.inset(y=0.03).place(width=0.024, height=0.14, at=side)
        d.box(grip.front(-0.025).move(x=-0.001), "black plastic", 0.006)


@draws("pegboard", whole=True)
def pegboard(d: Drawing) -> None:
    """A perforated board with hammer, saw, wrenches, screwdrivers, pliers and a roll of tape."""
    tones = ("plywood", "white steel", "grey paint", "blue paint", "black steel")
    board = d.box(d.bounds.back(0.015), d.material("board", *tones))
    x, w, h = board.x[1], board.width, board.height
    with d.grid(board.front(0.0), y=int(w / 0.06), z=int(h / 0.06)):
        d.print(Box.around((0.0, 0.0, 0.03), 0.0, 0.008, 0.008), "black plastic")
    hammer = 0.1 - w / 2
    d.bar((x + 0.02, hammer, 0.55 * h), (x + 0.02, hammer, 0.55 * h + 0.26), 0.014, "beech", 8)
    d.box(Box.around((x + 0.02, hammer - 0.005, 0.55 * h + 0.26), 0.032, 0.11, 0.04), "iron", 0.006)
    saw = [(-0.18, 0.1), (0.14, 0.02), (0.14, 0.14), (-0.18, 0.14)]
    d.extrude([(y, 0.55 * h + z) for y, z in saw], (x + 0.006, x + 0.009), "steel", axis="x")
    d.box(Box((x, x + 0.025), (0.12, 0.22), (0.55 * h + 0.01, 0.55 * h + 0.16)), "beech", 0.01)
    for k in range(5):
        wrench = Box.sized(0.01, 0.018, 0.22 - 0.025 * k, (x + 0.005, w / 2 - 0.08 - 0.05 * k, 0.12 * h))
        d.box(wrench, "chrome")
        for end in ("top", "bottom"):
            d.cylinder(Box.around(wrench.anchor(end), 0.012, 0.034, 0.034).move(x=0.001), "chrome", "x", segments=12)
        y = 0.07 - w / 2 + 0.055 * k
        d.bar((x + 0.014, y, 0.06), (x + 0.014, y, 0.2), 0.004, "steel", 6)
        grip = ("red plastic", "yellow plastic", "blue plastic")[k % 3]
        d.bar((x + 0.018, y, 0.19), (x + 0.018, y, 0.29), 0.014, grip, 8)
    d.cylinder(Box.around((x + 0.02, w / 2 - 0.1, 0.78 * h), 0.04, 0.1, 0.1), "yellow plastic", "x")
    d.box(Box((x, d.bounds.x[1]), (-0.06, 0.08), (0.1, 0.18)), "blue plastic", 0.006)


@draws("bicycle", whole=True)
def bicycle(d: Drawing) -> None:
    """Two spoked wheels, a diamond frame, saddle, handlebar, cranks and chain, on its stand."""
    tones = ("red", "blue", "black", "teal", "yellow", "white", "green")
    paint = d.material("frame", *(f"{tone} paint" for tone in tones))
    (deep, w, h), r = d.size, 0.34
    rear, front = r - deep / 2, deep / 2 - r
    metal, dark = "aluminium", "black steel"
    with d.along((rear, 0.0, r), (front, 0.0, r), 2):
        d.hoop(Box.around((0.0, 0.0, 0.0), 2 * r - 0.038, 0.0, 2 * r - 0.038), 0.019, "rubber", "y", 24)
        d.hoop(Box.around((0.0, 0.0, 0.0), 2 * r - 0.08, 0.0, 2 * r - 0.08), 0.008, metal, "y", 20)
        d.cylinder(Box.around((0.0, 0.0, 0.0), 0.05, 0.1, 0.05), metal, "y", segments=12)
        for angle in np.arange(6) * math.pi / 6:
            x, z = (r - 0.036) * math.cos(angle), (r - 0.036) * math.sin(angle)
            d.bar((-x, 0.0, -z), (x, 0.0, z), 0.0015, "steel", 4)
    bottom, seat, head = (rear + 0.43, 0.0, 0.28), (rear + 0.27, 0.0, 0.76 * h), (front - 0.17, 0.0, 0.8 * h)
    crown, stem = (front - 0.12, 0.0, 0.66 * h), (front - 0.19, 0.0, 0.86 * h)
    for start, end, radius in (
        (bottom, seat, 0.016),
        (seat, head, 0.015),
        (bottom, crown, 0.019),
        (crown, stem, 0.019),
    ):
        d.bar(start, end, radius, paint, 10)
    for s in (-1, 1):
        d.bar((bottom[0], 0.02 * s, bottom[2]), (rear, 0.055 * s, r), 0.009, paint, 6)
        d.bar((seat[0], 0.02 * s, seat[2] - 0.03), (rear, 0.055 * s, r), 0.008, paint, 6)
        d.sweep([crown, (crown[0], 0.055 * s, crown[2] - 0.03), (front, 0.055 * s, r)], 0.011, paint, 6)
        pedal = (bottom[0] + 0.12 * s, 0.12 * s, bottom[2] - 0.11 * s)
        d.bar((bottom[0], 0.06 * s, bottom[2]), (pedal[0], 0.075 * s, pedal[2]), 0.01, metal, 6)
        d.box(Box.around(pedal, 0.09, 0.08, 0.024), "black plastic")
        bar = [(front - 0.12, 0.0, h - 0.03), (front - 0.14, s * (w / 2 - 0.12), h - 0.015)]
        d.sweep([*bar, (front - 0.22, s * (w / 2 - 0.008), h - 0.015)], 0.012, metal, 8)
        grip = (front - 0.16, s * (w / 2 - 0.1), h - 0.016)
        d.bar(grip, (front - 0.225, s * w / 2, h - 0.016), 0.016, "rubber", 10)
        d.bar((bottom[0] - 0.06, 0.03 * s, 0.27), (bottom[0] - 0.08, 0.3 * s * w, 0.013), 0.008, dark, 6)
        d.bar((rear, -0.05, r + 0.038 * s), (bottom[0], -0.05, bottom[2] + 0.088 * s), 0.004, dark, 4)
    d.cylinder(Box.around(bottom, 0.036, 0.13, 0.036), metal, "y", segments=10)
    d.cylinder(Box.around((bottom[0], -0.05, bottom[2]), 0.18, 0.004, 0.18), dark, "y")
    d.cylinder(Box.around((rear, -0.05, r), 0.08, 0.012, 0.08), dark, "y", segments=14)
    post = (seat[0] - 0.04, 0.0, h - 0.07)
    d.bar(seat, post, 0.013, metal, 8)
    plan = [(-0.13, 0.08), (-0.03, 0.07), (0.14, 0.02)]
    levels = ((0.8, -0.01), (1.0, 0.02), (0.85, 0.05))
    saddle = [(post[0] + q * x, s * q * y, post[2] + z) for x, y in plan for s in (-1, 1) for q, z in levels]
    d.hull(saddle, "black leather")
    d.sweep(
        [(front - 0.19, 0.0, 0.85 * h), (front - 0.2, 0.0, h - 0.03), (front - 0.12, 0.0, h - 0.03)], 0.014, metal, 8
    )


@draws("ladder", whole=True)
def ladder(d: Drawing) -> None:
    """A step ladder with flat treads, a platform and rubber feet."""
    rail = d.material("rails", "aluminium", "pine", "yellow paint", "red paint")
    deep, w, h = d.size
    top = h - 0.02
    front, back = (deep / 2 - 0.04, w / 2 - 0.025), (0.03 - deep / 2, w / 2 - 0.025)
    head, rear = (0.05 * deep, 0.34 * w), (-0.05 * deep, 0.34 * w)
    with d.mirror("y"):
        beam(d, (*front, 0.02), (*head, top), rail, 0.03, 0.06)
        beam(d, (*back, 0.02), (*rear, top - 0.05), rail, 0.025, 0.035)
        for x, y in (front, back):
            d.box(Box.sized(0.06, 0.05, 0.05, (x, y, 0.0)), "rubber", 0.005)

    def between(low: tuple[float, float], high: tuple[float, float], share: float) -> tuple[float, float]:
        return low[0] + share * (high[0] - low[0]), low[1] + share * (high[1] - low[1])

    steps = max(3, round(h / 0.27))
    for share in np.arange(1, steps) / steps:
        x, y = between(front, head, float(share))
        d.box(Box.around((x, 0.0, share * top), 0.095, 2 * y, 0.024), rail)
    platform = d.bounds.top(0.035).place(0.26, 0.76 * w)
    d.box(platform, rail if rail.name == "pine" else "black plastic", 0.008)
    for share in (0.25, 0.6):
        x, y = between(back, rear, share)
        d.bar((x, -y, share * top), (x, y, share * top), 0.01, rail, 8)


@draws("tire_stack", whole=True, even="round")
def tire_stack(d: Drawing) -> None:
    """Tyres one upon another, with slanting shoulders, and a rim in the uppermost of some."""
    box = d.even("round")
    r = box.depth / 2
    tyres = box.rows(max(2, round(box.height / 0.21)))
    t = tyres[0].height
    angle = np.arange(28) * 2 * np.pi / 28
    circle = 0.81 * r * np.c_[np.cos(angle), np.sin(angle), 0 * angle]
    # Its section as seen along the way around: the inner side lies to the left.
    shape = ((0.19, -0.5), (-0.12, -0.48), (-0.19, -0.32), (-0.19, 0.32), (-0.12, 0.48), (0.19, 0.5))
    section = np.array([(r * x, t * z) for x, z in reversed(shape)])
    for tyre in tyres:
        d.sweep(circle + (0.0, 0.0, tyre.center[2]), section, "rubber", closed=True)
    if d.chance("rim", 0.5):
        rim = tyres[-1].share(z=(0.45, 0.75)).inset(x=0.44 * r, y=0.44 * r)
        d.cylinder(rim, d.material("rim", "aluminium", "black steel"))
        with d.at(z=rim.z[1]), d.ring(5):
            d.box(Box((0.03, 0.54 * r), (-0.02, 0.02), (-0.01, 0.1 * t)), "steel")


@draws("sawhorse", whole=True)
def sawhorse(d: Drawing) -> None:
    """A beam on four splayed legs with a rail between each two."""
    wood = d.material("wood", "pine", "yellow paint", "plywood", "red paint")
    box = d.bounds
    (deep, w, h) = box.size
    d.box(box.top(0.09).place(depth=0.09), wood)
    with d.mirror("x", "y"):
        beam(d, (deep / 2 - 0.03, w / 2 - 0.03, 0.01), (0.05, w / 2 - 0.14, h - 0.03), wood, 0.035, 0.07)
    with d.mirror("y"):
        d.box(Box.around((0.0, w / 2 - 0.08, 0.45 * h), 0.64 * deep, 0.024, 0.07), wood)


@draws("drill_press", whole=True)
def drill_press(d: Drawing) -> None:
    """A cast foot, column, table, head with belt cover, chuck and three-arm lever."""
    paint = d.material("paint", *_LOUD)
    deep, w, h = d.size
    x, chuck = -0.22 * deep, 0.18 * deep
    d.box(d.bounds.bottom(0.05).inset(y=0.05 * w), "iron", 0.01)
    d.cylinder(Box.sized(0.07, 0.07, h - 0.24, (x, 0.0, 0.04)), "steel", segments=16)
    table = min(0.28, 0.9 * w)
    d.box(Box((x, x + 0.15), (-0.06, 0.06), (0.55 * h - 0.09, 0.55 * h - 0.02)), "iron", 0.01)
    d.cylinder(Box.around((chuck, 0.0, 0.55 * h), table, table, 0.03), "iron", bevel=0.004)
    d.box(Box((x - 0.1, 0.3 * deep), (-0.1, 0.1), (h - 0.3, h - 0.1)), paint, 0.02)
    d.box(Box((x - 0.12, 0.34 * deep), (-0.11, 0.11), (h - 0.11, h)), paint, 0.03)
    d.cylinder(Box.around((x - 0.1, 0.0, h - 0.2), 0.16, 0.16, 0.16), "grey plastic", "x", bevel=0.01)
    with d.at(chuck):
        profile = [(0.004, 0.52), (0.006, 0.44), (0.022, 0.43), (0.03, 0.36), (0.03, 0.29)]
        d.revolve([(r, h - z) for r, z in profile], "steel", 14)
    hub = (0.1 * deep, -0.12, h - 0.22)
    d.cylinder(Box.around(hub, 0.06, 0.06, 0.06), "black plastic", "y", segments=14)
    for angle in 0.5 + np.arange(3) * 2 * math.pi / 3:
        end = (hub[0] + 0.15 * math.cos(angle), 0.025 - w / 2, hub[2] + 0.15 * math.sin(angle))
        d.bar(hub, end, 0.007, "steel", 6)
        d.ball(Box.around(end, 0.04, 0.04, 0.04), "black plastic", 8)
    d.print(Box((0.3 * deep, 0.3 * deep), (-0.04, 0.04), (h - 0.22, h - 0.17)), "yellow plastic")


@draws("table_saw", whole=True)
def table_saw(d: Drawing) -> None:
    """A steel top with a blade, guard, fence and mitre slots, on a cabinet stand."""
    paint = d.material("paint", *_LOUD)
    deep, w, h = d.size
    z = h - 0.12
    stand = Box.sized(0.76 * deep, 0.63 * w, z - 0.05)
    ends = [
        shapes.rectangle(b.x, b.y, level, 0.01) for b, level in ((stand, 0.0), (stand.inset(x=0.05, y=0.05), z - 0.05))
    ]
    d.loft(ends, paint, convex=True)
    top = d.box(d.bounds.to(z=(z - 0.05, z)), "steel", 0.005)
    flat = top.top(0.0)
    with d.mirror("y"):
        d.print(flat.inset(x=0.01).to(y=(0.12, 0.14)), "black plastic")
    d.print(flat.place(0.4, 0.08), "red paint")
    d.cylinder(Box.around((0.0, 0.0, z - 0.02), 0.24, 0.004, 0.24), "chrome", "y", segments=28)
    guard = Box((-0.16, 0.12), (-0.025, 0.025), (z + 0.07, h))
    for plate in (guard.left(0.015), guard.right(0.015), guard.top(0.015).inset(y=0.013)):
        d.box(plate, "yellow plastic")
    d.box(Box((-0.2, -0.16), (-0.012, 0.012), (z - 0.01, h)), "steel")
    d.box(flat.top(-0.06).to(y=(0.28 * w - 0.025, 0.28 * w + 0.025)), "aluminium")
    d.cylinder(Box.around((0.36 * deep, -0.1 * w, 0.6 * z), 0.03, 0.16, 0.16), "black plastic", "x", bevel=0.005)
    d.bar((0.37 * deep, -0.1 * w, 0.6 * z + 0.06), (0.44 * deep, -0.1 * w, 0.6 * z + 0.06), 0.01, "steel", 8)
    d.box(Box((0.32 * deep, 0.38 * deep), (0.12 * w, 0.2 * w), (0.7 * z, 0.85 * z)), "red plastic", 0.006)


@draws("air_compressor", whole=True)
def air_compressor(d: Drawing) -> None:
    """A lying tank with domed ends, motor and pump on top, wheels, handle, gauges."""
    paint = d.material("tank", *_LOUD)
    deep, w, h = d.size
    r = min(0.27 * h, 0.42 * w)
    z, long = r + 0.09, deep - 0.12
    with d.at(0.02 - deep / 2, 0.0, z, pitch=math.pi / 2):
        dome = [(0.4, 0.0), (0.8, 0.03), (0.95, 0.06), (1.0, 0.09)]
        d.revolve([(r * s, x) for s, x in dome] + [(r * s, long - x) for s, x in reversed(dome)], paint)
    axle = (-0.32 * deep, 0.0, 0.1)
    for wide, size, look in ((0.05, 0.2, "rubber"), (0.056, 0.1, "grey plastic")):
        with d.mirror("y"):
            wheel = Box.around((axle[0], w / 2 - 0.03, axle[2]), size, wide, size)
            d.cylinder(wheel, look, "y", bevel=0.006, segments=20)
    d.cylinder(Box.around(axle, 0.024, w - 0.06, 0.024), "steel", "y", segments=8)
    d.box(Box((0.24 * deep, 0.3 * deep), (-0.08, 0.08), (0.0, 0.2)), "black steel")
    t = z + r
    d.box(Box((-0.3 * deep, 0.25 * deep), (-0.3 * w, 0.3 * w), (t - 0.06, t + 0.01)), "black steel")
    d.cylinder(Box.around((-0.14 * deep, 0.0, t + 0.1), 0.3 * deep, 0.19, 0.19), "black plastic", "x", bevel=0.015)
    pump = d.box(Box((0.08 * deep, 0.2 * deep), (-0.07, 0.07), (t, h)), "aluminium", 0.012)
    for fin in pump.inset(x=-0.01 * deep, y=-0.01, bottom=0.05, top=0.03).rows(6, gap=0.02):
        d.box(fin.place(height=0.008), "aluminium", bevel=0.0)
    with d.mirror("y"):
        d.cylinder(Box.around((0.3 * deep, 0.06, t - 0.01), 0.03, 0.06, 0.06), "white plastic", "x", segments=16)
    x, y = (0.3 * deep, deep / 2 - 0.016), 0.12
    grip = [(x[0], -y, t - 0.08), (x[1], -y, t + 0.06), (x[1], y, t + 0.06), (x[0], y, t - 0.08)]
    d.sweep(grip, 0.016, "rubber", 8)


@draws("fire_extinguisher", whole=True)
def fire_extinguisher(d: Drawing) -> None:
    """A red cylinder with label, valve, lever, hose and a wall bracket."""
    red = d.material("tank", "red plastic", "red paint")
    deep, w, h = d.size
    r, t = min(deep, w) / 2 - 0.015, h - 0.11
    d.revolve(
        [(0.95 * r, 0.0), (r, 0.02), (r, t - 0.06), (0.88 * r, t - 0.03), (0.7 * r, t - 0.015), (0.3 * r, t)], red
    )
    d.cylinder(Box.sized(0.04, 0.04, 0.06, (0.0, 0.0, t - 0.01)), "brass", segments=12)
    beam(d, (-0.02, 0.0, h - 0.043), (0.09, 0.0, h - 0.043), "black plastic", 0.024, 0.012)
    beam(d, (-0.02, 0.0, h - 0.024), (0.09, 0.0, h - 0.006), "black plastic", 0.024, 0.012)
    d.box(Box((-0.025, 0.01), (-0.014, 0.014), (h - 0.07, h - 0.015)), "steel")
    d.cylinder(Box.around((0.02, 0.0, h - 0.075), 0.02, 0.036, 0.036), "white plastic", "x", segments=14)
    y = r + 0.008
    d.sweep(
        [(0.0, 0.015, h - 0.065), (0.0, 0.8 * r, h - 0.08), (0.0, y, 0.8 * t), (0.0, y, 0.45 * t)], 0.009, "rubber", 8
    )
    tank = Box.sized(2 * r, 2 * r, t)
    band(d, tank.share(z=(0.4, 0.68)), "white plastic", proud=0.0002)
    band(d, tank.share(z=(0.55, 0.6)), red, proud=0.00035)
    d.box(Box((-r - 0.015, 0.01 - r), (-0.03, 0.03), (0.2 * t, 0.9 * t)), "black steel")


@draws("electrical_panel", whole=True)
def electrical_panel(d: Drawing) -> None:
    """A wall box with a door, a lock, a warning sign and conduits above."""
    paint = d.material("case", "grey paint", "white steel", "light grey paint")
    box = d.bounds
    case = box.inset(top=0.1)
    d.box(case.inset(front=0.02), paint, 0.006)
    leaf = d.box(case.inset(y=0.015, z=0.015, front=0.005).front(0.016), paint)
    x, z = leaf.x[1], 0.68 * case.height
    sign: tuple[tuple[Look, float, list], ...] = (
        ("yellow plastic", 0.0003, [(-0.06, 0.0), (0.06, 0.0), (0.0, 0.1)]),
        ("black plastic", 0.00045, [(0.004, 0.07), (-0.014, 0.035), (-0.004, 0.01), (0.012, 0.04)]),
    )
    for look, proud, points in sign:
        corners = np.array([(px, y, z + dz) for px in (x - 0.002, x + proud) for y, dz in points])
        d.add(shapes.hull(corners), look, [])
    lock = leaf.front(-0.005).share(y=(0.84, 0.9), z=(0.4, 0.52))
    d.box(lock.inset(back=-0.002), "black plastic", 0.002)
    for share in (-0.25, 0.0, 0.25):
        d.cylinder(
            Box.sized(0.036, 0.036, 0.11, (0.0, share * box.width, case.z[1] - 0.01)), "grey plastic", segments=12
        )


@draws("jerry_can", whole=True)
def jerry_can(d: Drawing) -> None:
    """A fuel can with pressed sides, three handles and a cap."""
    paint = d.material("can", "red plastic", "green paint", "blue plastic", "yellow plastic")
    box = d.bounds
    deep, w, h = box.size
    t = h - 0.05
    x0, x1 = box.x
    outline = [
        (x0, 0.02),
        (x0 + 0.02, 0.0),
        (x1 - 0.02, 0.0),
        (x1, 0.02),
        (x1, t - 0.06),
        (x1 - 0.07, t),
        (x0 + 0.02, t),
    ]
    profile = [(z, x) for x, z in reversed([*outline, (x0, t - 0.02)])]
    d.extrude(profile, box.y, paint, axis="y", bevel=0.008)
    for k in (-1, 1):
        with d.mirror("y"):
            y, rise = w / 2 - 0.004, 0.3 * k * t
            d.bar((-0.34 * deep, y, t / 2 + rise), (0.34 * deep, y, t / 2 - rise), 0.008, paint, 6)
    for y in (-0.3 * w, 0.0, 0.3 * w):
        ends = ((-0.36 * deep, t - 0.01), (-0.3 * deep, h - 0.01), (0.08 * deep, h - 0.01), (0.14 * deep, t - 0.01))
        d.sweep([(x, y, z) for x, z in ends], 0.009, paint, 8)
    d.bar((x1 - 0.04, 0.0, t - 0.05), (x1 - 0.012, 0.0, t - 0.012), 0.026, "black plastic", 12)
