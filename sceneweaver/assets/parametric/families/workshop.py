"""Tools, machines and vehicles of a garage or workshop."""

from __future__ import annotations

import math
from contextlib import nullcontext

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import band, beam, carcass, castors, doors, drawer, shelves, wheel

_LOUD = "red paint, blue paint, yellow paint, green paint, black steel, grey paint"


@draws("tool_chest", whole=True)
def tool_chest(d: Drawing) -> None:
    """A rolling chest of drawers in loud paint, with a mat on top and a handle at its side."""
    paint = d.material("paint", _LOUD)
    box = d.bounds.inset(left=0.03, right=0.03)
    castors(d, box.bottom(0.11).inset(x=0.02, y=0.01))
    case = box.inset(bottom=0.11, front=0.024)
    top = d.box(case.top(0.025), "black plastic", 0.005)
    room = carcass(d, case.inset(top=0.025), paint, 0.02, 0.012)
    rows = [1.9, 1.9] + [1.0] * (d.integer("drawers", 5, 7) - 2)
    for k, cell in enumerate(room.rows(rows)):
        drawer(d, f"drawer-{k}", cell, paint, "aluminium", "lip", round(0.7 * box.depth, 3), "grey plastic")
    (x0, x1), y, z = case.inset(x=0.09).x, box.y[1], case.z[1] - 0.09
    d.sweep([(x0, y, z), (x0, y + 0.018, z), (x1, y + 0.018, z), (x1, y, z)], 0.012, "chrome", 8)
    d.surface("top", top, inset=0.01)


@draws("tool_cabinet", whole=True)
def tool_cabinet(d: Drawing) -> None:
    """A tall steel cupboard with two doors, louvres, handles and boards inside."""
    paint = d.material("paint", _LOUD)
    box = d.bounds.inset(front=0.025)
    room = carcass(d, box.inset(front=0.02), paint, 0.02)
    shelves(d, room, 4, paint, inset=0.01, name=None)
    leaves = box.front(0.02).inset(bottom=0.02, top=0.01)
    doors(d, leaves, 2, paint, "black plastic", "bar")
    for leaf in leaves.columns(2):
        for z in (0.2, box.z[1] - 0.3):
            for slot in leaf.front(0.0).to(z=(z, z + 0.1)).share(y=(0.3, 0.7)).rows(5, gap=0.014):
                d.print(slot, "black plastic")


@draws("pegboard", whole=True)
def pegboard(d: Drawing) -> None:
    """A perforated board with hammer, saw, wrenches, screwdrivers, a box and a roll of tape."""
    look = d.material("board", "plywood, white steel, grey paint, blue paint, black steel")
    board = d.box(d.bounds.back(0.015), look)
    (_, w, h), x = board.size, board.x[1]
    with d.grid(board.front(0.0), y=int(w / 0.06), z=int(h / 0.06)):
        d.print(Box.around((0.0, 0.0, 0.03), 0.0, 0.008, 0.008), "black plastic")
    with d.at(x, 0.1 - w / 2, 0.55 * h):
        d.bar((0.02, 0.0, 0.0), (0.02, 0.0, 0.26), 0.014, "beech", 8)
        d.box(Box.around((0.02, -0.005, 0.26), 0.032, 0.11, 0.04), "iron", 0.006)
    blade = Box((x + 0.006, x + 0.009), (-0.18, 0.14), (0.55 * h + 0.02, 0.55 * h + 0.14))
    d.silhouette(blade, [(0.0, 0.67), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], "steel", "x")
    d.box(blade.left(0.02).inset(x=-0.008, left=-0.08, z=-0.015), "beech", 0.01)
    for k, tone in enumerate(("red", "yellow", "blue", "red", "yellow")):
        wrench = Box.sized(0.01, 0.018, 0.22 - 0.025 * k, (x + 0.005, w / 2 - 0.08 - 0.05 * k, 0.12 * h))
        d.box(wrench, "chrome")
        for end in ("top", "bottom"):
            d.cylinder(Box.around(wrench.anchor(end), 0.012, 0.034, 0.034).move(x=0.001), "chrome", "x", segments=12)
        y = 0.07 - w / 2 + 0.055 * k
        d.bar((x + 0.016, y, 0.06), (x + 0.016, y, 0.2), 0.004, "steel", 6)
        d.bar((x + 0.018, y, 0.19), (x + 0.018, y, 0.29), 0.014, f"{tone} plastic", 8)
    d.cylinder(Box.around((x + 0.02, w / 2 - 0.1, 0.78 * h), 0.04, 0.1, 0.1), "yellow plastic", "x")
    d.box(Box((x, d.bounds.x[1]), (-0.06, 0.08), (0.1, 0.18)), "blue plastic", 0.006)


@draws("bicycle", whole=True)
def bicycle(d: Drawing) -> None:
    """A bicycle on its stand."""
    _bicycle(d, *d.size, stand=True)


@draws("wall_bicycle", whole=True)
def wall_bicycle(d: Drawing) -> None:
    """A bicycle along a wall, whose top tube lies in the arms of a hanger."""
    wood, (deep, w, h) = d.material("hanger", "oak, walnut, black steel"), d.size
    back = d.bounds.x[0]
    with d.at(yaw=-math.pi / 2):
        _bicycle(d, w, deep, h, stand=False)
    d.box(Box((back, back + 0.03), (-0.16, 0.16), (0.6 * h, 0.78 * h)), wood, 0.006)
    with d.mirror("y"):
        d.bar((back + 0.02, 0.12, 0.72 * h), (0.05, 0.12, 0.72 * h), 0.014, "black steel", 8)
        d.bar((0.05, 0.12, 0.72 * h), (0.05, 0.12, 0.77 * h), 0.014, "black steel", 8)


def _bicycle(d: Drawing, deep: float, w: float, h: float, stand: bool) -> None:
    """Two spoked wheels, a diamond frame, saddle, handlebar, cranks and chain, of a length, width and height [m]."""
    tones = "red paint, blue paint, black paint, teal paint, yellow paint, white paint, green paint"
    paint = d.material("frame", tones)
    r, metal, dark = 0.34, "aluminium", "black steel"
    rear, front = r - deep / 2, deep / 2 - r
    with d.along((rear, 0.0, r), (front, 0.0, r), 2):
        for size, thick, look in ((0.642, 0.019, "rubber"), (0.6, 0.008, metal)):
            d.hoop(Box.around((0.0, 0.0, 0.0), size, 0.0, size), thick, look, "y", 24)
        d.cylinder(Box.around((0.0, 0.0, 0.0), 0.05, 0.1, 0.05), metal, "y", segments=12)
        for angle in np.arange(6) * math.pi / 6:
            x, z = 0.304 * math.cos(angle), 0.304 * math.sin(angle)
            d.bar((-x, 0.0, -z), (x, 0.0, z), 0.0015, "steel", 4)
    crank, hub, seat = (rear + 0.43, 0.0, 0.28), (rear, 0.055, r), (rear + 0.27, 0.0, 0.76 * h)
    head, crown, stem = (front - 0.17, 0.0, 0.8 * h), (front - 0.12, 0.0, 0.66 * h), (front - 0.19, 0.0, 0.86 * h)
    post = (seat[0] - 0.04, 0.0, h - 0.07)
    tubes = ((crank, seat, 0.016), (seat, head, 0.015), (crank, crown, 0.019), (crown, stem, 0.019))
    for start, end, radius in tubes:
        d.bar(start, end, radius, paint)
    d.bar(seat, post, 0.013, metal, 8)
    for s in (-1, 1):
        pedal = (crank[0] + 0.12 * s, 0.12 * s, crank[2] - 0.11 * s)
        d.bar((crank[0], 0.06 * s, crank[2]), (pedal[0], 0.075 * s, pedal[2]), 0.01, metal, 6)
        d.box(Box.around(pedal, 0.09, 0.08, 0.024), "black plastic")
        d.bar((rear, -0.05, r + 0.038 * s), (crank[0], -0.05, crank[2] + 0.088 * s), 0.004, dark, 4)
    with d.mirror("y"):
        for start in ((crank[0], 0.02, crank[2]), (seat[0], 0.02, seat[2] - 0.03)):
            d.bar(start, hub, 0.009, paint, 6)
        d.sweep([crown, (crown[0], 0.055, crown[2] - 0.03), (front, 0.055, r)], 0.011, paint, 6)
        bar = [(-0.19, 0.0, 0.85 * h), (-0.2, 0.0, h - 0.03), (-0.12, 0.0, h - 0.03), (-0.14, w / 2 - 0.12, h - 0.015)]
        d.sweep([(front + x, y, z) for x, y, z in [*bar, (-0.22, w / 2 - 0.008, h - 0.015)]], 0.012, metal, 8)
        d.bar((front - 0.16, w / 2 - 0.1, h - 0.016), (front - 0.225, w / 2, h - 0.016), 0.016, "rubber")
        if stand:
            d.bar((crank[0] - 0.06, 0.03, 0.27), (crank[0] - 0.08, 0.3 * w, 0.013), 0.008, dark, 6)
    d.cylinder(Box.around(crank, 0.036, 0.13, 0.036), metal, "y", segments=10)
    d.cylinder(Box.around((crank[0], -0.05, crank[2]), 0.18, 0.004, 0.18), dark, "y")
    d.cylinder(Box.around((rear, -0.05, r), 0.08, 0.012, 0.08), dark, "y", segments=14)
    saddle = Box.sized(0.27, 0.16, 0.06, (post[0] + 0.005, 0.0, post[2] - 0.01))
    d.sections(saddle, [(0.8, 0.8, 0.0), (1.0, 1.0, 0.5), (0.85, 0.85, 1.0)], "black leather", convex=True)


@draws("ladder", whole=True)
def ladder(d: Drawing) -> None:
    """A step ladder with flat treads, a platform and rubber feet."""
    rail = d.material("rails", "aluminium, pine, yellow paint, red paint")
    (deep, w, h), top = d.size, d.size.height - 0.02
    # Feet and heads of the front and of the rear rails, in (x, y).
    front = np.array([(deep / 2 - 0.04, w / 2 - 0.025), (0.05 * deep, 0.34 * w)])
    rear = np.array([(0.03 - deep / 2, w / 2 - 0.025), (-0.05 * deep, 0.34 * w)])
    with d.mirror("y"):
        for (foot, head), wide, thick in ((front, 0.03, 0.06), (rear, 0.025, 0.035)):
            beam(d, (*foot, 0.02), (*head, top - 0.03), rail, wide, thick)
            d.box(Box.sized(0.06, 0.05, 0.05, (*foot, 0.0)), "rubber", 0.005)
    steps = max(3, round(h / 0.27))
    for share in np.arange(1, steps) / steps:
        x, y = front[0] + share * (front[1] - front[0])
        d.box(Box.around((x, 0.0, share * top), 0.095, 2 * y, 0.024), rail)
    d.box(d.bounds.top(0.035).place(0.26, 0.76 * w), rail if rail.called("pine") else "black plastic", 0.008)
    for share in (0.25, 0.6):
        x, y = rear[0] + share * (rear[1] - rear[0])
        d.bar((x, -y, share * top), (x, y, share * top), 0.01, rail, 8)


@draws("tire_stack", whole=True, even="round")
def tire_stack(d: Drawing) -> None:
    """Tyres one upon another, with slanting shoulders, and a rim in the uppermost of some."""
    box = d.even("round")
    r, tyres = box.depth / 2, box.rows(max(2, round(box.height / 0.21)))
    t, angle = tyres[0].height, np.arange(28) * 2 * np.pi / 28
    # The section across the way around, in shares of radius and height.
    section = [(0.19, 0.5), (-0.12, 0.48), (-0.19, 0.32), (-0.19, -0.32), (-0.12, -0.48), (0.19, -0.5)]
    for k, tyre in enumerate(tyres):
        circle = 0.81 * r * np.c_[np.cos(angle), np.sin(angle), 0 * angle] + (0.0, 0.0, tyre.center[2])
        with d.item(f"tyre-{k}", "tyre") if k else nullcontext():
            d.sweep(circle, np.array(section) * (r, t), "rubber", closed=True)
            if tyre is tyres[-1] and d.chance("rim", 0.5):
                rim = tyre.share(z=(0.45, 0.75)).inset(x=0.44 * r, y=0.44 * r)
                d.cylinder(rim, d.material("rim", "aluminium, black steel"))
                with d.at(z=rim.z[1]), d.ring(5):
                    d.box(Box((0.03, 0.54 * r), (-0.02, 0.02), (-0.01, 0.1 * t)), "steel")


@draws("sawhorse", whole=True)
def sawhorse(d: Drawing) -> None:
    """A beam on four splayed legs with a rail between each two."""
    wood = d.material("wood", "pine, yellow paint, plywood, red paint")
    box, (deep, w, h) = d.bounds, d.size
    d.box(box.top(0.09).place(depth=0.09), wood)
    with d.mirror("x", "y"):
        beam(d, (deep / 2 - 0.03, w / 2 - 0.03, 0.01), (0.05, w / 2 - 0.14, h - 0.03), wood, 0.035, 0.07)
    with d.mirror("y"):
        d.box(Box.around((0.0, w / 2 - 0.08, 0.45 * h), 0.64 * deep, 0.024, 0.07), wood)


@draws("drill_press", whole=True)
def drill_press(d: Drawing) -> None:
    """A cast foot, column, table, head with belt cover, chuck and three-arm lever."""
    paint = d.material("paint", _LOUD)
    (deep, w, h), table = d.size, min(0.28, 0.9 * d.size.width)
    x, chuck = -0.22 * deep, 0.18 * deep
    d.box(d.bounds.bottom(0.05).inset(y=0.05 * w), "iron", 0.01)
    d.cylinder(Box.sized(0.07, 0.07, h - 0.24, (x, 0.0, 0.04)), "steel", segments=16)
    d.box(Box((x, x + 0.15), (-0.06, 0.06), (0.55 * h - 0.09, 0.55 * h - 0.02)), "iron", 0.01)
    d.cylinder(Box.around((chuck, 0.0, 0.55 * h), table, table, 0.03), "iron", bevel=0.004)
    d.box(Box((x - 0.1, 0.3 * deep), (-0.1, 0.1), (h - 0.3, h - 0.1)), paint, 0.02)
    d.box(Box((x - 0.12, 0.34 * deep), (-0.11, 0.11), (h - 0.11, h)), paint, 0.03)
    d.cylinder(Box.around((x - 0.1, 0.0, h - 0.2), 0.16, 0.16, 0.16), "grey plastic", "x", bevel=0.01)
    tool = Box.sized(0.06, 0.06, 0.23, (chuck, 0.0, h - 0.52))
    d.turned(tool, [(0.13, 0.0), (0.2, 0.35), (0.73, 0.4), (1.0, 0.7), (1.0, 1.0)], "steel", 14)
    hub = Box.around((0.1 * deep, -0.12, h - 0.22), 0.06, 0.06, 0.06)
    d.cylinder(hub, "black plastic", "y", segments=14)
    for angle in 0.5 + np.arange(3) * 2 * math.pi / 3:
        end = (hub.center[0] + 0.15 * math.cos(angle), 0.025 - w / 2, hub.center[2] + 0.15 * math.sin(angle))
        d.bar(hub.center, end, 0.007, "steel", 6)
        d.ball(Box.around(end, 0.04, 0.04, 0.04), "black plastic", 8)
    d.print(Box((0.3 * deep, 0.3 * deep), (-0.04, 0.04), (h - 0.22, h - 0.17)), "yellow plastic")


@draws("table_saw", whole=True)
def table_saw(d: Drawing) -> None:
    """A steel top with a blade, guard, fence and mitre slots, on a cabinet stand."""
    paint = d.material("paint", _LOUD)
    (deep, w, h), z = d.size, d.size.height - 0.12
    d.sections(Box.sized(0.76 * deep, 0.63 * w, z - 0.05), [(1.0, 1.0, 0.0), (0.86, 0.84, 1.0)], paint, 0.02, True)
    flat = d.box(d.bounds.to(z=(z - 0.05, z)), "steel", 0.005).top(0.0)
    with d.mirror("y"):
        d.print(flat.inset(x=0.01).to(y=(0.12, 0.14)), "black plastic")
    d.print(flat.place(0.4, 0.08), "red paint")
    d.cylinder(Box.around((0.0, 0.0, z - 0.02), 0.24, 0.004, 0.24), "chrome", "y", segments=28)
    guard = Box((-0.16, 0.12), (-0.025, 0.025), (z + 0.07, h))
    for plate in (guard.left(0.015), guard.right(0.015), guard.top(0.015).inset(y=0.013)):
        d.box(plate, "yellow plastic")
    d.box(Box((-0.2, -0.16), (-0.012, 0.012), (z - 0.01, h)), "steel")
    d.box(flat.top(-0.06).to(y=(0.28 * w - 0.025, 0.28 * w + 0.025)), "aluminium")
    crank = Box.around((0.36 * deep, -0.1 * w, 0.6 * z), 0.03, 0.16, 0.16)
    d.cylinder(crank, "black plastic", "x", bevel=0.005)
    d.bar(crank.point(z=0.85), crank.move(x=0.07).point(z=0.85), 0.01, "steel", 8)
    d.box(Box((0.32 * deep, 0.38 * deep), (0.12 * w, 0.2 * w), (0.7 * z, 0.85 * z)), "red plastic", 0.006)


@draws("air_compressor", whole=True)
def air_compressor(d: Drawing) -> None:
    """A lying tank with domed ends, motor and pump on top, wheels, handle, gauges."""
    paint = d.material("tank", _LOUD)
    deep, w, h = d.size
    r = min(0.27 * h, 0.42 * w)
    z, long, t = r + 0.09, deep - 0.12, 2 * r + 0.09
    with d.at(0.02 - deep / 2, 0.0, z, pitch=math.pi / 2):
        dome = [(0.4, 0.0), (0.8, 0.03), (0.95, 0.06), (1.0, 0.09)]
        d.revolve([(r * s, x) for s, x in dome] + [(r * s, long - x) for s, x in reversed(dome)], paint)
    x = -0.32 * deep
    with d.mirror("y"):
        wheel(d, Box.around((x, w / 2 - 0.03, 0.1), 0.2, 0.05, 0.2), "rubber", "grey plastic")
        d.cylinder(Box.around((0.3 * deep, 0.06, t - 0.01), 0.03, 0.06, 0.06), "white plastic", "x", segments=16)
    d.bar((x, 0.03 - w / 2, 0.1), (x, w / 2 - 0.03, 0.1), 0.012, "steel", 8)
    d.box(Box((0.24 * deep, 0.3 * deep), (-0.08, 0.08), (0.0, 0.2)), "black steel")
    d.box(Box((-0.3 * deep, 0.25 * deep), (-0.3 * w, 0.3 * w), (t - 0.06, t + 0.01)), "black steel")
    d.cylinder(Box.around((-0.14 * deep, 0.0, t + 0.1), 0.3 * deep, 0.19, 0.19), "black plastic", "x", bevel=0.015)
    pump = d.box(Box((0.08 * deep, 0.2 * deep), (-0.07, 0.07), (t, h)), "aluminium", 0.012)
    for fin in pump.inset(x=-0.01 * deep, y=-0.01, bottom=0.05, top=0.03).rows(6, gap=0.02):
        d.box(fin.place(height=0.008), "aluminium", bevel=0.0)
    (x0, x1), y = (0.3 * deep, deep / 2 - 0.016), 0.12
    d.sweep([(x0, -y, t - 0.08), (x1, -y, t + 0.06), (x1, y, t + 0.06), (x0, y, t - 0.08)], 0.016, "rubber", 8)


@draws("fire_extinguisher", whole=True)
def fire_extinguisher(d: Drawing) -> None:
    """A red cylinder with label, valve, lever, hose and a wall bracket."""
    red = d.material("tank", "red plastic, red paint")
    h, r = d.size.height, min(d.size[:2]) / 2 - 0.015
    t, y = h - 0.11, r + 0.008
    tank = Box.sized(2 * r, 2 * r, t)
    d.turned(tank, [(0.95, 0.0), (1.0, 0.04), (1.0, 0.87), (0.88, 0.94), (0.7, 0.97), (0.3, 1.0)], red)
    band(d, tank.share(z=(0.4, 0.68)), "white plastic", proud=0.0002)
    band(d, tank.share(z=(0.55, 0.6)), red, proud=0.00035)
    d.cylinder(Box.sized(0.04, 0.04, 0.06, (0.0, 0.0, t - 0.01)), "brass", segments=12)
    for start, end in ((h - 0.043, h - 0.043), (h - 0.024, h - 0.006)):
        beam(d, (-0.02, 0.0, start), (0.09, 0.0, end), "black plastic", 0.024, 0.012)
    d.box(Box((-0.025, 0.01), (-0.014, 0.014), (h - 0.07, h - 0.015)), "steel")
    d.cylinder(Box.around((0.02, 0.0, h - 0.075), 0.02, 0.036, 0.036), "white plastic", "x", segments=14)
    hose = [(0.015, h - 0.065), (0.8 * r, h - 0.08), (y, 0.8 * t), (y, 0.45 * t)]
    d.sweep([(0.0, u, z) for u, z in hose], 0.009, "rubber", 8)
    d.box(Box((-r - 0.015, 0.01 - r), (-0.03, 0.03), (0.2 * t, 0.9 * t)), "black steel")


@draws("electrical_panel", whole=True)
def electrical_panel(d: Drawing) -> None:
    """A wall box with a door, a lock, a warning sign and conduits above."""
    paint = d.material("case", "grey paint, white steel, light grey paint")
    case = d.bounds.inset(top=0.1)
    d.box(case.inset(front=0.02), paint, 0.006)
    leaf = d.box(case.inset(y=0.015, z=0.015, front=0.005).front(0.016), paint)
    sign = leaf.front(0.002).place(width=0.12, height=0.1).move(z=0.24 * case.height)
    flash = [(0.53, 0.7), (0.38, 0.35), (0.47, 0.1), (0.6, 0.4)]
    with d.no_colliders():
        d.silhouette(sign.inset(front=-0.0003), [(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)], "yellow plastic", "x")
        d.silhouette(sign.inset(front=-0.00045), flash, "black plastic", "x")
    lock = leaf.front(-0.005).share(y=(0.84, 0.9), z=(0.4, 0.52))
    d.box(lock.inset(back=-0.002), "black plastic", 0.002)
    for y in (-0.25 * case.width, 0.0, 0.25 * case.width):
        d.cylinder(Box.sized(0.036, 0.036, 0.11, (0.0, y, case.z[1] - 0.01)), "grey plastic", segments=12)


@draws("jerry_can", whole=True)
def jerry_can(d: Drawing) -> None:
    """A fuel can with pressed sides, three handles and a cap."""
    paint = d.material("can", "red plastic, green paint, blue plastic, yellow plastic")
    box = d.bounds.inset(top=0.05)
    deep, w, t = box.size
    outline = [(0.0, 0.05), (0.06, 0.0), (0.94, 0.0), (1.0, 0.05), (1.0, 0.86), (0.77, 1.0), (0.06, 1.0), (0.0, 0.95)]
    d.silhouette(box, outline, paint, bevel=0.008)
    with d.mirror("y"):
        for rise in (-0.3 * t, 0.3 * t):
            x, y = 0.34 * deep, w / 2 - 0.004
            d.bar((-x, y, t / 2 + rise), (x, y, t / 2 - rise), 0.008, paint, 6)
    for y in (-0.3 * w, 0.0, 0.3 * w):
        grip = ((-0.36, t - 0.01), (-0.3, t + 0.04), (0.08, t + 0.04), (0.14, t - 0.01))
        d.sweep([(x * deep, y, z) for x, z in grip], 0.009, paint, 8)
    d.bar((box.x[1] - 0.04, 0.0, t - 0.05), (box.x[1] - 0.012, 0.0, t - 0.012), 0.026, "black plastic", 12)
