"""Machines, carts and cabinets of offices, schools and libraries."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import button, castors, legs, oval, vessel

_CASES = "white plastic, grey plastic, black plastic"


@draws("desk_printer", whole=True)
def desk_printer(d: Drawing) -> None:
    """A low printer: scanner lid, slot with a sheet on its tray, small panel."""
    body = d.material("body", _CASES)
    box = d.bounds.inset(front=0.08)
    case = d.box(box.share(z=(0.0, 0.78)), body, 0.012)
    d.box(box.share(z=(0.72, 0.84)).inset(x=0.012, y=0.008), "black plastic")
    d.box(box.share(z=(0.77, 1.0)).inset(x=0.006, y=0.005), body, 0.015)
    face = case.front(0.0)
    slot = d.print(face.share(y=(0.17, 0.83), z=(0.2, 0.56)), "black plastic")
    tray = d.box(slot.bottom(0.03 * box.height).inset(y=0.015).to(x=(face.x[1] - 0.03, d.bounds.x[1])), "grey plastic")
    d.box(tray.top(-0.002).place(width=0.21).inset(front=0.02), "paper", bevel=0.0)
    panel = d.box(face.front(-0.012).share(y=(0.1, 0.65), z=(0.67, 0.95)).inset(back=-0.02), "black plastic", 0.005)
    d.print(panel.front(0.0).share(y=(0.15, 0.5), z=(0.2, 0.8)), "screen")
    for key, tone in zip(panel.share(y=(0.6, 0.95)).columns(3), ("green", "white", "red"), strict=True):
        button(d, key, f"{tone} plastic", 0.008)


@draws("photocopier", whole=True)
def photocopier(d: Drawing) -> None:
    """A floor copier: paper drawers, output slot, scanner, feeder, tilted panel."""
    body = d.material("body", "white plastic, light grey paint, grey plastic")
    box = d.bounds.inset(front=0.03)
    castors(d, box.bottom(0.05).inset(x=0.05, y=0.05), wheel="black plastic")
    tower = box.inset(bottom=0.045, top=0.12)
    base, gap, scanner = tower.rows([0.67, 0.16, 0.17])
    d.box(base, body, 0.01)
    for cell in base.inset(y=0.03, bottom=0.02, top=0.06).front(-0.012).rows(3, gap=0.02):
        tray = d.box(cell.inset(back=-0.01), body)
        d.print(tray.front(0.0).share(z=(0.65, 0.82)).place(width=0.18), "black plastic")
    d.box(gap.back(0.45 * box.depth).inset(z=-0.005), body, 0.006)
    d.box(gap.right(0.14).inset(z=-0.005), body, 0.006)
    tray = d.box(gap.bottom(0.02).inset(back=0.1, front=0.05, right=0.16, left=0.04), "grey plastic")
    d.box(tray.top(-0.01).inset(back=0.1, front=0.03).place(width=0.25), "paper", bevel=0.0)
    d.box(scanner, body, 0.01)
    d.print(scanner.front(0.0).inset(y=0.02).share(z=(0.35, 0.42)), "black plastic")
    lid = d.box(scanner.top(-0.06).inset(back=0.02, front=0.06, y=0.02), "grey plastic", 0.012)
    d.box(lid.top(-0.06).inset(x=0.06, left=0.01, bottom=-0.005).share(y=(0.6, 1.0)), body, 0.015)
    feeder = d.box(lid.top(-0.015).inset(x=0.08).share(y=(0.15, 0.6)), body)
    d.box(feeder.top(-0.01).inset(x=0.04, right=0.03), "paper", bevel=0.0)
    with d.at(box.x[1] - 0.005, -0.12 * box.width, scanner.z[1] - 0.1, pitch=-0.6):
        face = d.box(Box((-0.02, 0.03), (-0.22, 0.22), (0.0, 0.16)), "black plastic", 0.008).front(0.0)
        d.print(face.share(y=(0.25, 0.87), z=(0.2, 0.82)), "screen")
        d.print(face.share(y=(0.07, 0.16), z=(0.3, 0.55)), "green plastic")


@draws("phone_booth", whole=True)
def phone_booth(d: Drawing) -> None:
    """A soundproof office booth: glass door, felt inside, a shelf desk, a seat and a lamp."""
    shell = d.material("shell", "white paint, black paint, grey paint, sage paint, light oak, navy paint")
    felt = d.material("felt", "grey fabric, charcoal fabric, blue fabric, mustard fabric")
    box = d.bounds.inset(front=0.03)
    d.box(box.bottom(0.1), shell, 0.012)
    d.box(box.top(0.12), shell, 0.02)
    walls = box.inset(bottom=0.09, top=0.1)
    room = box.inset(y=0.07, bottom=0.1, top=0.12)
    for wall in (walls.left(0.07), walls.right(0.07)):
        d.box(wall, shell, 0.02)
    for lining in (room.left(0.012), room.right(0.012), room.back(0.05)):
        d.box(lining.inset(front=0.06 if lining.depth > 0.1 else 0.0), felt, bevel=0.0)
    seat = room.inset(back=0.05, y=0.02).back(0.27).to(z=(0.4, 0.46))
    d.cushion(seat, felt, 0.025)
    d.box(seat.bottom(-0.3).place(0.22, 0.3), shell)
    d.box(room.left(0.3).to(x=(room.x[0] + 0.4, room.x[1] - 0.1), z=(0.72, 0.745)), "light oak")
    d.cylinder(Box.sized(0.14, 0.14, 0.02, (0.0, 0.0, room.z[1] - 0.015)), "lamp glow", segments=20)
    leaf = room.front(0.04).move(x=-0.005).inset(y=0.003, z=0.004)
    with d.hinge("door", leaf.anchor("front right bottom"), limits=(-1.7, 0.0)):
        rails = [rail.inset(y=0.05) for rail in (leaf.top(0.056), leaf.bottom(0.056))]
        for side in (leaf.left(0.05), leaf.right(0.05), *rails):
            d.box(side, "black steel")
        d.box(leaf.inset(y=0.05, z=0.056).place(depth=0.01), "glass", bevel=0.0)
        x, y = d.bounds.x[1] - 0.008, leaf.y[1] - 0.025
        d.bar((x, y, 0.95), (x, y, 1.25), 0.008, "steel", 8)
        for z in (0.97, 1.23):
            d.bar((leaf.x[1] - 0.002, y, z), (x, y, z), 0.006, "steel", 8)


@draws("server_rack", whole=True)
def server_rack(d: Drawing) -> None:
    """A tall black rack full of servers with lights, patch panels and blanks, its front open."""
    case = d.material("case", "black steel, black steel, grey paint")
    box = d.bounds
    castors(d, box.bottom(0.032).inset(x=0.05, y=0.05))
    body = box.inset(bottom=0.03)
    d.box(body.inset(front=0.04), case, 0.006)
    frame = body.front(0.04)
    for rail in (frame.left(0.05), frame.right(0.05), frame.top(0.06).inset(y=0.05), frame.bottom(0.06).inset(y=0.05)):
        d.box(rail, case)
    bay, z = frame.inset(y=0.055, front=0.012, back=-0.01), 0.1
    for k in range(60):
        if z > box.z[1] - 0.15:
            break
        high = min(0.0445 * d.pick(f"units {k}", (1, 1, 2, 2, 3)), box.z[1] - 0.07 - z)
        kind = d.pick(f"unit {k}", ("server", "disks", "patch", "blank"))
        look = "grey plastic" if kind in ("disks", "server") else "black plastic"
        face = d.box(bay.to(z=(z, z + high - 0.004)), look, 0.002).front(0.0)
        line = face.place(height=0.014)
        if kind == "disks":
            for slot in face.inset(y=0.02, z=0.008).columns(8, gap=0.012):
                d.print(slot, "black plastic")
                d.print(slot.place(width=0.008, height=0.006), "green plastic", 0.00035)
        elif kind == "patch":
            for j, port in enumerate(line.inset(y=0.02).columns(12, gap=0.018)):
                d.print(port, "blue plastic" if j % 3 else "yellow plastic")
        elif kind == "server":
            d.print(line.share(y=(0.2, 0.95)), "black plastic")
            lamps = line.share(y=(0.04, 0.16)).columns(3, gap=0.012)
            for lamp, tone in zip(lamps, ("green", "blue", "orange"), strict=True):
                d.print(lamp.place(height=0.008), f"{tone} plastic")
        z += high


@draws("water_cooler", whole=True)
def water_cooler(d: Drawing) -> None:
    """A slim body with two taps and a big blue bottle on top."""
    body = d.material("body", _CASES)
    box = d.bounds
    case = box.inset(front=0.02).share(z=(0.0, 0.7))
    low = d.box(case.share(z=(0.0, 0.76)), body, 0.015)
    d.box(case.share(z=(0.75, 0.93)).inset(front=0.1), body, 0.01)
    head = d.box(case.share(z=(0.92, 1.0)), body, 0.015)
    d.box(low.front(0.1).top(0.02).inset(front=-0.02, top=-0.002).share(y=(0.15, 0.85)), "grey plastic")
    for y, tone in ((-0.06, "red"), (0.06, "blue")):
        spout = Box.around((case.x[1] - 0.07, y, head.z[0] - 0.02), 0.08, 0.028, 0.03)
        d.box(spout, "white plastic")
        d.box(spout.top(-0.014).front(0.03), f"{tone} plastic")
    door = low.front(0.0).share(y=(0.14, 0.86), z=(0.1, 0.92))
    d.print(door, "grey plastic")
    d.print(door.inset(y=0.003, z=0.003), body, 0.00035)
    r = 0.84 * min(box.depth, box.width)
    bottle = Box.sized(r, r, box.z[1] - head.z[1] + 0.004, (-0.01, 0.0, head.z[1] - 0.004))
    look = d.material("bottle", "sky pigment, clear plastic")
    ribs = [(e, z + 0.02 * s) for z in (0.4, 0.6, 0.8) for e, s in ((1.0, -2), (0.94, -1), (0.94, 1), (1.0, 2))]
    d.turned(bottle, [(0.4, 0.0), (0.45, 0.1), (0.85, 0.2), (1.0, 0.28), *ribs, (1.0, 0.94), (0.85, 1.0)], look)


@draws("shredder", whole=True)
def shredder(d: Drawing) -> None:
    """A bin with a window and a cutting head, a sheet half way in."""
    body = d.material("body", "black plastic, grey plastic, white plastic")
    box = d.bounds.inset(top=0.06)
    bin_box, head = box.rows([0.78, 0.22])
    d.sections(bin_box, [(0.86, 0.86, 0.0), (0.95, 0.95, 1.0)], body, 0.05, convex=True)
    dark = "black plastic" if body.name != "black plastic" else "grey plastic"
    top = d.box(head, dark, 0.015)
    d.print(top.top(0.0).place(0.016, 0.68 * box.width), "black glass")
    d.box(Box.sized(0.003, 0.21, d.bounds.z[1] - top.z[1] + 0.02, (0.0, 0.0, top.z[1] - 0.02)), "paper", bevel=0.0)
    d.print(top.front(0.0).place(width=0.04, height=0.012), "green plastic")
    lean = math.atan2(0.045 * box.depth, bin_box.height)
    with d.at(0.4525 * box.depth, 0.0, bin_box.center[2], pitch=lean):
        d.box(Box.around((-0.003, 0.0, 0.0), 0.012, 0.4 * box.width, 0.6 * bin_box.height), "black glass", 0.002)


@draws("wastebasket", whole=True, even="round")
def wastebasket(d: Drawing) -> None:
    """A small round paper bin with crumpled paper in it."""
    look = d.material("bin", "black steel, white steel, grey plastic, blue plastic, wicker, green plastic")
    box = d.even("round").inset(top=0.02)
    r, top = box.depth / 2, box.z[1]
    foot = (1 - d.uniform("foot", 0.7, 0.9)) * r
    outer = [(foot, 0.0), (0.05 * r, top - 0.012), (0.0, top - 0.01), (0.0, top)]
    inner = [(0.05 * r, top), (foot + 0.006, 0.008)]
    shell, inside = ([oval(box.inset(x=e, y=e), z) for e, z in side] for side in (outer, inner))
    vessel(d, shell, inside, look, 16)
    q = 0.27 * r
    heap = Box.sized(1.84 * r, 1.84 * r, top - 2 * q - 0.01, (0.0, 0.0, 0.01))
    fill = d.cylinder(heap, "paper", ends=((r - foot) / r, 0.98), segments=20)
    for k, angle in enumerate(1.7 * np.arange(4) + 0.4):
        middle = (0.42 * r * math.cos(angle), 0.42 * r * math.sin(angle), fill.z[1] + 0.7 * q)
        d.ball(Box.around(middle, 2 * q, 1.8 * q, 1.6 * q - 0.008 * k), "paper", 8)
    d.ball(Box.around((0.0, 0.0, d.bounds.z[1] - 0.8 * q), 2 * q, 1.8 * q, 1.6 * q), "paper", 8)


@draws("book_return_cart", whole=True)
def book_return_cart(d: Drawing) -> None:
    """A library trolley: two shelves of books on both sides between end panels, on castors."""
    frame = d.material("ends", "grey paint, oak, beech, teal paint, red paint, black steel")
    looks = [f"{tone} fabric" for tone in ("red", "navy", "green", "mustard", "beige", "rust", "charcoal")]
    box = d.bounds
    castors(d, box.bottom(0.102).inset(x=0.02))
    body = box.inset(bottom=0.1)
    outline = ((0.0, body.z[0]), (0.0, box.z[1] - 0.12), (0.08, box.z[1]))
    with d.mirror("y"):
        end = body.left(0.022)
        d.hull([(s * (box.x[1] - e), y, z) for e, z in outline for s in (-1, 1) for y in end.y], frame)
    shelf = body.inset(x=0.02, y=0.02)
    for k, level in enumerate((0.16, 0.16 + 0.55 * (box.height - 0.3))):
        floor = d.box(shelf.to(z=(level - 0.02, level)), frame, 0.002)
        d.box(floor.top(-0.2).place(depth=0.02), frame, 0.002)
        for e in (-1, 1):
            y, j = floor.y[0] + 0.01, 0
            end_y = floor.y[1] * d.uniform(f"full {k} {e}", 0.3, 0.95)
            while y < end_y:
                thick = d.uniform(f"t {k} {e} {j}", 0.025, 0.055)
                deep = min(shelf.x[1] - 0.02, d.uniform(f"d {k} {e} {j}", 0.13, 0.17))
                top = level + d.uniform(f"h {k} {e} {j}", 0.19, 0.27)
                x = (0.01, 0.01 + deep) if e > 0 else (-0.01 - deep, -0.01)
                d.box(Box(x, (y, y + thick - 0.001), (level, top)), d.pick(f"l {k} {e} {j}", looks))
                y, j = y + thick, j + 1


@draws("card_catalog", whole=True)
def card_catalog(d: Drawing) -> None:
    """A library cabinet of many small drawers with brass label holders and pulls, on legs."""
    wood = d.material("wood", "oak, walnut, mahogany, cherry, light oak")
    box = d.bounds.inset(front=0.026)
    foot = 0.3 * box.height
    legs(d, box.bottom(foot + 0.001).inset(x=0.01, y=0.01), wood, "tapered", 0.055)
    case = d.box(box.inset(bottom=foot, top=0.025, front=0.004), wood)
    top = d.box(box.top(0.028).inset(front=-0.016, y=-0.01), wood, 0.006)
    front = case.front(-0.004).inset(y=0.025, bottom=0.02, top=0.015)
    d.print(front.back(0.0).inset(y=-0.01, z=-0.01), "wenge", 0.0002)
    rows, columns = max(4, round((box.height - foot) / 0.13)), max(4, round(box.width / 0.17))
    for level in front.rows(rows, gap=0.008):
        for cell in level.columns(columns, gap=0.008):
            face = d.box(cell.inset(back=-0.002), wood, 0.001).front(0.0)
            holder = d.print(face.share(y=(0.18, 0.82), z=(0.5, 0.86)), "brass")
            d.print(holder.inset(y=0.006, z=0.006), "paper", 0.00045)
            d.print(face.share(z=(0.18, 0.38)).place(width=0.024), "brass")
    d.surface("top", top, inset=0.012)


@draws("globe", whole=True, even="round")
def globe(d: Drawing) -> None:
    """A floor globe in a wooden ring on turned legs."""
    wood = d.material("stand", "mahogany, walnut, oak, cherry")
    sea = d.material("sea", "sea pigment, sky pigment, sand pigment")
    land = "terracotta pigment" if "sand" in sea.name else "sand pigment"
    box = d.even("round")
    r = 0.4 * box.depth
    z = box.z[1] - r - 0.02
    d.ball(Box.around((0.0, 0.0, z), 2 * r, 2 * r, 2 * r), sea, 28)
    # Continents: longitude, latitude, size, and how their coast runs.
    continents = [(0.3, 0.4, 0.4), (0.8, -0.3, 0.3), (2.2, 0.5, 0.45), (2.5, -0.1, 0.3)]
    continents += [(3.6, 0.5, 0.4), (4.2, -0.35, 0.35), (5.2, 0.3, 0.35), (5.6, -0.5, 0.25)]
    t = np.arange(14) * 2 * math.pi / 14
    for east, north, size in continents:
        coast = size * (1 + 0.25 * np.sin(3 * t + east) + 0.15 * np.cos(5 * t))
        lon, lat = east + 0.9 * coast * np.cos(t), north + 0.8 * coast * np.sin(t)
        edge = np.c_[np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)]
        middle = np.array([math.cos(north) * math.cos(east), math.cos(north) * math.sin(east), math.sin(north)])
        inner = (edge + middle) / np.linalg.norm(edge + middle, axis=1, keepdims=True)
        skin = np.concatenate([1.006 * edge, 1.006 * inner, [1.006 * middle, 0.8 * middle]])
        d.hull(r * skin + (0.0, 0.0, z), land if size < 0.42 else "moss pigment")
    circle = 0.45 * box.depth * np.c_[np.cos(t), np.sin(t), 0 * t] + (0.0, 0.0, z)
    wide = 0.05 * box.depth
    d.sweep(circle, np.array([(wide, -0.012), (wide, 0.012), (-wide, 0.012), (-wide, -0.012)]), wood, closed=True)
    d.hoop(Box.around((0.0, 0.0, z), 2.09 * r, 0.0, 2.09 * r), 0.008, "brass", "y", 24)
    with d.ring(4, start=math.pi / 4):
        with d.at(0.44 * box.depth):
            turning = ((0.014, 0.0), (0.022, 0.07), (0.015, 0.14), (0.026, 0.5), (0.016, 0.75), (0.022, 1.0))
            d.revolve([(radius, share * (z - 0.01)) for radius, share in turning], wood, 12)
        d.bar((0.44 * box.depth, 0.0, 0.16), (0.0, 0.0, 0.13), 0.012, wood, 8)
    d.cylinder(Box.sized(0.08, 0.08, 0.07, (0.0, 0.0, 0.1)), wood, ends=(0.75, 1.0), segments=12)


@draws("mailboxes", whole=True)
def mailboxes(d: Drawing) -> None:
    """A wall of small numbered post boxes with slots and locks."""
    case = d.material("case", "aluminium, grey paint, white steel, black steel, brass")
    box = d.bounds
    d.box(box.inset(front=0.004), case)
    front = box.front(0.006).inset(y=0.024, z=0.024)
    for level in front.rows(max(2, round(box.height / 0.17)), gap=0.008):
        for cell in level.columns(max(2, round(box.width / 0.3)), gap=0.008):
            face = d.box(cell, case, 0.0012).front(0.0)
            d.print(face.share(y=(0.2, 0.8), z=(0.72, 0.82)), "black plastic")
            d.print(face.share(y=(0.3, 0.62), z=(0.4, 0.55)), "paper")
            d.print(face.share(y=(0.78, 0.84), z=(0.42, 0.52)), "black steel")


@draws("turnstile", whole=True)
def turnstile(d: Drawing) -> None:
    """A gate of three turning arms on a steel body, with a card reader."""
    steel = d.material("body", "brushed steel, steel, black steel")
    box = d.bounds
    case = d.box(box.right(0.26).inset(top=0.004), steel, 0.02)
    d.box(case.top(-0.004).inset(x=0.03, y=0.02, bottom=-0.005), "black glass", bevel=0.0)
    reader = d.print(case.front(0.0).place(width=0.1).top(0.18).inset(top=0.08), "black glass")
    d.print(reader.inset(y=0.03, z=0.03), "green plastic", 0.00045)
    x, y, z = 0.0, case.y[1] + 0.01, case.z[1] - 0.16
    d.cylinder(Box.around((x, y, z), 0.14, 0.06, 0.14), "chrome", "y", bevel=0.01, segments=20)
    for end in ((x, box.y[1] - 0.02, z), (0.3, y + 0.15, z - 0.26), (-0.3, y + 0.15, z - 0.26)):
        d.bar((x, y, z), end, 0.019, "chrome")
