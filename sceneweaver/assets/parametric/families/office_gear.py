"""Machines, carts and cabinets of offices, schools and libraries."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import bowl, button, castors, frame, legs

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
    sides, room = box.inset(bottom=0.09, top=0.1), box.inset(y=0.07, bottom=0.1, top=0.12)
    for board in (box.bottom(0.1), box.top(0.12), sides.left(0.07), sides.right(0.07)):
        d.box(board, shell, 0.015)
    lined = room.inset(front=0.06)
    for lining in (lined.left(0.012), lined.right(0.012), lined.back(0.05)):
        d.box(lining, felt, bevel=0.0)
    seat = d.cushion(lined.inset(back=0.05, y=0.02).back(0.27).to(z=(0.4, 0.46)), felt, 0.025)
    d.box(seat.bottom(-0.3).place(0.22, 0.3), shell)
    d.box(room.left(0.3).inset(back=0.4, front=0.1).to(z=(0.72, 0.745)), "light oak")
    d.cylinder(room.top(0.005).inset(top=-0.015).place(0.14, 0.14), "lamp glow", segments=20)
    leaf = room.front(0.04).move(x=-0.005).inset(y=0.003, z=0.004)
    with d.hinge("door", leaf.anchor("front right bottom"), limits=(-1.7, 0.0)):
        d.box(frame(d, leaf, "black steel", 0.05).place(depth=0.01), "glass", bevel=0.0)
        x, y = leaf.x[1], leaf.y[1] - 0.025
        reach = d.bounds.x[1] - 0.008
        with d.handle("bar", (reach, y, 1.1), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.016, 0.28):
            d.sweep([(x, y, 0.95), (reach, y, 0.95), (reach, y, 1.25), (x, y, 1.25)], 0.008, "steel", 8)


@draws("server_rack", whole=True)
def server_rack(d: Drawing) -> None:
    """A tall black rack full of servers with lights, patch panels and blanks, its front open."""
    case, box = d.material("case", "black steel, black steel, grey paint"), d.bounds
    castors(d, box.bottom(0.032).inset(x=0.05, y=0.05))
    body = box.inset(bottom=0.03)
    d.box(body.inset(front=0.04), case, 0.006)
    bay = frame(d, body.front(0.04), case, 0.05).inset(y=0.005, front=0.012, back=-0.01)
    z, k, top = bay.z[0] + 0.01, 0, bay.z[1] - 0.1
    while z < top:
        high, k = min(0.0445 * d.pick(f"units {k}", (1, 1, 2, 2, 3)), bay.z[1] - 0.01 - z), k + 1
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
            lamps = line.share(y=(0.04, 0.16)).columns(3, 0.012)
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
    dark = "black plastic" if not body.called("black plastic") else "grey plastic"
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
    box, foot = d.even("round").inset(top=0.02), d.uniform("foot", 0.7, 0.9)
    r, top = box.depth / 2, box.z[1]
    q = 0.27 * r
    outer = ((foot, foot, 0.0), (0.95, 0.95, top - 0.012), (1.0, 1.0, top - 0.01), (1.0, 1.0, top))
    bowl(d, box, outer, ((0.95, 0.95, top), (foot - 0.05, foot - 0.05, 0.008)), look)
    heap = Box.sized(1.84 * r, 1.84 * r, top - 2 * q - 0.01, (0.0, 0.0, 0.01))
    d.cylinder(heap, "paper", ends=(foot, 0.98), segments=20)
    balls = [(0.42 * r * math.cos(a), 0.42 * r * math.sin(a), heap.z[1] + 0.7 * q) for a in (0.4, 2.1, 3.8, 5.5)]
    for middle in [*balls, (0.0, 0.0, d.bounds.z[1] - 0.8 * q)]:
        d.ball(Box.around(middle, 2 * q, 1.8 * q, 1.6 * q), "paper", 8)


@draws("book_return_cart", whole=True)
def book_return_cart(d: Drawing) -> None:
    """A library trolley: two shelves of books on both sides between end panels, on castors."""
    look, box = d.material("ends", "grey paint, oak, beech, teal paint, red paint, black steel"), d.bounds
    covers = [f"{tone} fabric" for tone in ("red", "navy", "green", "mustard", "beige", "rust", "charcoal")]
    castors(d, box.bottom(0.102).inset(x=0.02))
    body = box.inset(bottom=0.1)
    with d.mirror("y"):
        outline = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.88), (0.83, 1.0), (0.17, 1.0), (0.0, 0.88)]
        d.silhouette(body.left(0.022), outline, look)
    shelf = body.inset(x=0.02, y=0.02)
    for k, level in enumerate((0.16, 0.16 + 0.55 * (box.height - 0.3))):
        floor = d.box(shelf.to(z=(level - 0.02, level)), look, 0.002)
        d.box(floor.top(-0.2).place(depth=0.02), look, 0.002)
        for side in ("front", "back"):
            y, j, end = floor.y[0] + 0.01, 0, floor.y[1] * d.uniform(f"full {k} {side}", 0.3, 0.95)
            while y < end:
                key = f"{k} {side} {j}"
                thick, deep = d.uniform(f"t {key}", 0.025, 0.055), d.uniform(f"d {key}", 0.13, 0.17)
                x, z = (0.01, min(0.01 + deep, shelf.x[1] - 0.01)), (level, level + d.uniform(f"h {key}", 0.19, 0.27))
                book = Box(x, (y, y + thick - 0.001), z)
                d.box(book if side == "front" else book.move(x=-book.x[0] - book.x[1]), d.pick(f"l {key}", covers))
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
    sea, box = d.material("sea", "sea pigment, sky pigment, sand pigment"), d.even("round")
    land = "terracotta pigment" if "sand" in sea.name else "sand pigment"
    r, ring = 0.4 * box.depth, 0.45 * box.depth
    z = box.z[1] - r - 0.02
    d.ball(Box.around((0.0, 0.0, z), 2 * r, 2 * r, 2 * r), sea, 28)
    # Continents: longitude, latitude, size.
    continents = [(0.3, 0.4, 0.4), (0.8, -0.3, 0.3), (2.2, 0.5, 0.45), (2.5, -0.1, 0.3)]
    continents += [(3.6, 0.5, 0.4), (4.2, -0.35, 0.35), (5.2, 0.3, 0.35), (5.6, -0.5, 0.25)]
    t = np.arange(14) * 2 * math.pi / 14
    for east, north, size in continents:
        coast = size * (1 + 0.25 * np.sin(3 * t + east) + 0.15 * np.cos(5 * t))
        lon, lat = np.r_[east + 0.9 * coast * np.cos(t), east], np.r_[north + 0.8 * coast * np.sin(t), north]
        edge = np.c_[np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)]
        between = edge + edge[-1:]
        between /= np.linalg.norm(between, axis=1, keepdims=True)
        skin = np.concatenate([1.006 * edge, 1.006 * between, 0.8 * edge[-1:]])
        d.hull(r * skin + (0.0, 0.0, z), land if size < 0.42 else "moss pigment")
    d.sweep(np.c_[ring * np.cos(t), ring * np.sin(t), 0 * t + z], (0.1 * box.depth, 0.024), wood, closed=True)
    d.hoop(Box.around((0.0, 0.0, z), 2.09 * r, 0.0, 2.09 * r), 0.008, "brass", "y", 24)
    turning = [(0.54, 0.0), (0.85, 0.07), (0.58, 0.14), (1.0, 0.5), (0.62, 0.75), (0.85, 1.0)]
    with d.ring(4, start=math.pi / 4):
        d.turned(Box.sized(0.052, 0.052, z - 0.01, (0.98 * ring, 0.0, 0.0)), turning, wood, 12)
        d.bar((0.98 * ring, 0.0, 0.16), (0.0, 0.0, 0.13), 0.012, wood, 8)
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
