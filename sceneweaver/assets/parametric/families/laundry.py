"""Washing, drying, ironing and cleaning."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import (
    bar_pull,
    bottle,
    bowl,
    button,
    castors,
    drain,
    feet,
    knob,
    lip,
    oval,
    tap,
    vessel,
    wheel,
)
from .small_parts import BARE

_CLOTHS = [f"{tone} fabric" for tone in ("white", "blue", "rose", "grey", "green", "mustard")]
_BRIGHT = "red plastic, blue plastic, black plastic, green plastic, orange plastic, grey plastic"


@draws("washing_machine", "dryer", whole=True)
def washing_machine(d: Drawing) -> None:
    """A box with a drum behind a round glass door, a panel with dial and display, a drawer or a filter flap."""
    coat = d.material("body", "white paint, white paint, white paint, grey paint, black paint")
    rim = d.material("rim", "chrome, black plastic, grey plastic, white plastic")
    trim = "light grey paint" if coat.called("white paint") else "black plastic"
    box = d.bounds.inset(front=0.062)
    feet(d, box.bottom(0.015), "black plastic")
    case = box.inset(bottom=0.012, top=0.028, y=0.002)
    x, z, r = case.x[1], 0.45, d.uniform("door", 0.205, 0.225)
    with d.at(case.x[0], pitch=math.pi / 2):  # +z is forward, and +x down
        around, hole = Box((-case.z[1], -case.z[0]), case.y, case.x), Box.sized(1.7 * r, 1.7 * r, 0.0, (-z, 0.0, 0.0))
        outer = [oval(around, level, 60.0) for level in (0.0, case.depth)]
        back = 0.17 if case.depth > 0.55 else 0.13
        vessel(d, outer, [oval(hole, case.depth), oval(hole.inset(x=-0.05, y=-0.05), back)], coat)
        d.cylinder(hole.to(z=(back - 0.005, back + 0.01)).inset(x=-0.04, y=-0.04), "steel")
    d.surface("top", d.box(box.top(0.03), coat, 0.006), inset=0.02)
    face = d.box(case.front(-0.006).inset(y=0.004, back=-0.001).top(0.115), trim, 0.002).front(0.0)
    place = face.right(0.19).inset(right=0.015, z=0.012)
    if d.category.name == "dryer":
        d.print(place.inset(y=0.02, z=0.02), "grey plastic")
    else:
        with d.slide("soap drawer", limits=(0.0, 0.15)):
            tray = d.box(place.front(-0.005), coat)
            lip(d, tray.front(-0.022).share(y=(0.25, 0.75), z=(0.1, 0.28)), "grey plastic", bevel=0.002)
    knob(d, face.move(y=d.pick("dial", [-0.02, 0.0, 0.02])), "chrome", 0.033, 0.026, name="dial")
    d.print(face.to(y=(0.07, 0.2)).place(height=0.05), "screen")
    for key in face.to(y=(0.21, 0.28)).columns(3):
        button(d, key, "chrome", 0.006, 0.003)
    with d.hinge("door", (x + 0.02, box.y[1] - 0.06, z), limits=(0.0, 2.2)):
        with d.at(x, 0.0, z, pitch=math.pi / 2):
            ring = ((0.0, 0.0005), (0.0, 0.022), (0.015, 0.036), (0.05, 0.04), (0.055, 0.03), (0.05, 0.0005))
            glass = ((0.05, 0.012), (0.05, 0.036), (0.09, 0.047), (0.14, 0.05))
            d.revolve([(r - e, u) for e, u in ring], rim, 40, hollow=True)
            d.revolve([(r - e, u) for e, u in glass], "black glass", 36)
        bar_pull(d, (x + 0.03, 0.024 - r, z - 0.07), (x + 0.03, 0.024 - r, z + 0.07), "grey plastic", 0.007, 0.025, 0.2)
    d.print(case.front(0.0).right(0.17).inset(right=0.05).to(z=(0.05, 0.14)), trim)


@draws("laundry_sink")
def laundry_sink(d: Drawing) -> None:
    """A deep tub on four legs with a tall tap and its waste below."""
    look = d.material("tub", "white plastic, brushed steel, white ceramic, grey plastic")
    leg = d.material("legs", "white steel, steel, black steel")
    h, low = 0.86, 0.5
    box = d.bounds.to(z=(low, h))
    with d.part("tub"):
        outer = ((0.8, 0.82, low), (0.94, 0.94, h - 0.03), (1.0, 1.0, h - 0.03), (1.0, 1.0, h))
        inner = ((0.87, 0.88, h), (0.72, 0.78, low + 0.015))
        bowl(d, box, outer, inner, look, 12.0, 16, (1, 0))
        drain(d, (0.0, 0.0, low + 0.015), 0.035)
    with d.part("legs"):
        with d.corners(box.to(z=(0.0, 0.1)), inset=0.035):
            d.bar((0.0, 0.0, 0.0), (0.02, 0.02, low + 0.09), 0.017, leg)
        trap = [(0.0, low), (0.0, 0.36), (-0.02, 0.31), (-0.07, 0.31), (-0.09, 0.36), (box.x[0] + 0.02, 0.37)]
        d.sweep([(x, 0.0, z) for x, z in trap], 0.019, "white plastic")
    with d.part("tap"), d.at(box.x[0] + 0.05, 0.0, h):
        tap(d, d.material("tap", "chrome, brass, brushed steel"), 0.19, d.size.height - h)
    d.fit()


@draws("ironing_board")
def ironing_board(d: Drawing) -> None:
    """A padded, pointed board on crossed legs, with a rest for the iron at its end."""
    cloth = d.material("cover", "blue fabric, grey fabric, green fabric, rose fabric, mustard fabric, white fabric")
    metal = d.material("legs", "white steel, steel, black steel, aluminium")
    deep, _, h = d.size
    board = d.bounds.inset(right=0.24).top(0.03)
    (y0, y1), long, end = board.y, board.width, d.bounds.y[0] + 0.008
    half = np.array([(0.45, 0.0), (0.5, 0.02), (0.5, 0.58), (0.4, 0.74), (0.31, 0.86), (0.2, 0.95), (0.09, 0.99)])
    outline = np.concatenate([half * (1, 1), [(0.0, 1.0)], half[::-1] * (-1, 1)])
    with d.part("board"):
        rings = []
        for e, z in ((0.02, h - 0.03), (0.0, h - 0.022), (0.0, h - 0.008), (0.012, h)):
            plan = (outline - (0.0, 0.5)) * (deep - 2 * e, long - 2 * e) + (0.0, board.center[1])
            rings.append(np.c_[plan, np.full(len(plan), z)])
        d.loft(rings, cloth, convex=True)
        d.box(Box((-0.1, 0.1), (y0 + 0.05, y1 - 0.35), (h - 0.045, h - 0.028)), metal, 0.002)
    with d.part("rest"):
        for x in (-0.11, 0.11):
            d.bar((x, y0 + 0.08, h - 0.035), (x, end, h - 0.035), 0.007, metal, 8)
        d.bar((-0.117, end, h - 0.035), (0.117, end, h - 0.035), 0.007, metal, 8)
        with d.along((-0.08, 0.0, h - 0.032), (0.08, 0.0, h - 0.032), 5):
            d.bar((0.0, y0 + 0.03, 0.0), (0.0, end, 0.0), 0.004, metal, 6)
    a, c = y0 + 0.06, y1 - 0.38
    with d.part("legs"):
        for low, high, apart, foot in ((a, c, 0.08, deep / 2 - 0.03), (c + 0.06, a + 0.08, 0.055, 0.17)):
            d.bar((-foot, low, 0.0145), (foot, low, 0.0145), 0.0125, metal, 8)
            with d.mirror("x"):
                d.bar((apart, low, 0.02), (apart, high, h - 0.04), 0.011, metal, 8)
                d.bar((foot - 0.03, low, 0.0145), (foot + 0.012, low, 0.0145), 0.0145, "rubber", 8)
        middle = (a + c) / 2 + 0.02
        d.bar((-0.09, middle, h / 2 - 0.01), (0.09, middle, h / 2 - 0.01), 0.008, metal, 8)
    d.surface("top", board.inset(x=0.03, right=0.03, left=0.44 * long))
    d.fit()


@draws("drying_rack")
def drying_rack(d: Drawing) -> None:
    """A winged airer on crossed legs with many rods, and some things hung on it."""
    metal = d.material("frame", "white steel, aluminium, steel, black steel")
    deep, w, h = d.size
    half, x, level = 0.26 * w, deep / 2 - 0.012, 0.86 * h
    foot, tip = 1.05 * half, (w / 2 - 0.009, h - 0.009)

    def rods(start: tuple[float, float], end: tuple[float, float], count: int, radius: float = 0.0045) -> None:
        """Rods along x from one place (y, z) to another."""
        with d.along((0.0, *start), (0.0, *end), count):
            d.bar((-x, 0.0, 0.0), (x, 0.0, 0.0), radius, metal, 6)

    with d.part("legs"):
        for t in (-1, 1):
            with d.mirror("x"):
                at = x - 0.025 + 0.009 * t
                d.bar((at, -t * foot, 0.012), (at, t * half, level), 0.009, metal, 8)
                d.bar((x - 0.05, t * foot, 0.013), (x + 0.006, t * foot, 0.013), 0.013, "grey plastic", 8)
        rods((-foot, 0.013), (foot, 0.013), 2, 0.012)
        rods((0.0, level / 2), (0.0, level / 2), 1, 0.007)
    for name, start, end, count in (
        ("middle", (-half, level), (half, level), 9),
        ("left wing", (half, level), tip, 7),
        ("right wing", (-half, level), (-tip[0], tip[1]), 7),
    ):
        with d.part(name):
            with d.mirror("x"):
                d.bar((x, *start), (x, *end), 0.009, metal, 8)
            rods(start, end, count)
    fall = np.array([(-9, -1.0), (-8, -0.5), (-7, 0.0), (0, 0.02), (7, 0.0), (8, -0.5), (9, -0.85)]) * (0.001, 1.0)
    for k in range(d.integer("pieces", 2, 4) if d.request.shape != BARE and d.chance("washing", 0.7) else 0):
        across = np.linspace(-1, 1, 9)
        sway = 0.005 * np.sin(4.7 * across + k) * np.abs(fall[:, 1:]) * np.sign(fall[:, :1])
        y = (2 * k + 1) * half / 4 - half + fall[:, :1] + sway
        z = level + d.uniform(f"long {k}", 0.25, 0.42) * fall[:, 1:] + 0 * y
        cloth = np.stack([d.uniform(f"wide {k}", 0.16, 0.23) * across + 0 * y, y, z], axis=-1)
        with d.part("middle"):
            d.sheet(cloth, 0.005, d.pick(f"cloth {k}", _CLOTHS[:5]), (6, 4))
    d.fit()


@draws("laundry_basket", whole=True)
def laundry_basket(d: Drawing) -> None:
    """A tapered basket with rows of slots, a rolled rim, and clothes in it."""
    look = d.material("body", "white plastic, grey plastic, blue plastic, wicker, rattan")
    box = d.bounds.inset(top=0.05)
    rim = box.z[1]
    outer = ((0.78, 0.78, 0.0), (0.95, 0.95, rim - 0.03), (1.0, 1.0, rim - 0.025), (1.0, 1.0, rim))
    bowl(d, box, outer, ((0.95, 0.95, rim), (0.92, 0.92, rim - 0.03), (0.75, 0.75, 0.012)), look, 7.0, inside=None)
    dark = "grey plastic" if look.called("white plastic") else "black plastic"
    lean = math.atan2(0.17 * box.depth / 2, rim - 0.03)
    with d.mirror("x"), d.at(0.39 * box.depth, pitch=lean):
        face = Box((0.0, 0.0), (-0.3 * box.width, 0.3 * box.width), (0.25 * rim, 0.75 * rim))
        for slot in (s for row in face.rows(2, gap=0.03) for s in row.columns(8, gap=0.025)):
            d.print(slot, dark, 0.0001)
    heap = box.inset(x=0.12 * box.depth, y=0.12 * box.width)
    d.cushion(heap.to(z=(0.04, rim - 0.012)), "white fabric", 0.05)
    for k, (u, v) in enumerate(((0.2, 0.2), (0.75, 0.22), (0.3, 0.52), (0.75, 0.55), (0.25, 0.82), (0.72, 0.85))):
        x, y, _ = heap.point(u, v)
        high = d.bounds.z[1] if k == 2 else rim + d.uniform(f"up {k}", 0.012, 0.04)
        with d.at(x, y, rim - 0.06, yaw=0.5 * k):
            d.cushion(Box.sized(0.16, 0.17, high - rim + 0.06), d.pick(f"cloth {k}", _CLOTHS), 0.03, 0.5)


@draws("water_heater", whole=True)
def water_heater(d: Drawing) -> None:
    """A hung drum with domed ends, a dial, a lamp, pipes with a valve below."""
    coat = d.material("body", "white steel, white steel, brushed steel, grey paint")
    box, r, low = d.bounds, d.size.width / 2, 0.12
    x, h, front = box.x[1] - r, box.z[1], box.x[1]
    with d.at(x):
        dome = [(0.5, 0.0), (0.85, 0.015), (0.96, 0.035), (1.0, 0.07)]
        d.revolve([(r * s, low + z) for s, z in dome] + [(r * s, h - z) for s, z in reversed(dome)], coat, 40)
        d.cylinder(Box.sized(0.84 * r, 0.84 * r, 0.03, (0.0, 0.0, low - 0.025)), "grey plastic")
    for z in (low + 0.14, h - 0.16):
        d.box(Box((box.x[0], x - 0.1), (-0.6 * r, 0.6 * r), (z - 0.02, z + 0.02)), "steel", 0.0)
    plate = d.box(Box((front - 0.06, front - 0.0005), (-0.062, 0.062), (low + 0.09, low + 0.2)), "grey plastic", 0.01)
    d.print(Box.around((plate.x[1], -0.02, low + 0.135), 0.0, 0.046, 0.046), "black plastic", 0.0004, oval=True)
    d.print(Box.around((plate.x[1], 0.032, low + 0.17), 0.0, 0.025, 0.01), "lamp glow")
    for y, look in ((-0.09, "blue plastic"), (0.09, "red plastic")):
        d.bar((x, y, 0.0), (x, y, low + 0.01), 0.011, "copper")
        d.bar((x, y, low - 0.03), (x, y, low + 0.006), 0.016, look)
    d.bar((x, -0.09, 0.05), (x + 0.04, -0.09, 0.05), 0.01, "brass", 8)
    d.box(Box.around((x + 0.041, -0.09, 0.05), 0.012, 0.03, 0.016), "red plastic", 0.002)


@draws("vacuum_cleaner")
def vacuum_cleaner(d: Drawing) -> None:
    """A low body on wheels, a hose that rises to a tube, and a floor head in front."""
    look, dark = d.material("body", _BRIGHT), "black plastic"
    box, h = d.bounds, d.size.height
    body = box.back(0.4).place(width=min(box.width, 0.28), height=0.24, at="bottom")
    x, front, tube = body.center[0], body.x[1], box.x[1] - 0.12
    with d.part("body"):
        low = [(0.96, 0.86, 0.125), (0.99, 0.95, 0.3), (0.95, 0.93, 0.54)]
        d.sections(body, [*low, (0.78, 0.74, 0.79, -0.03), (0.48, 0.45, 0.9, -0.06)], look, convex=True)
        with d.mirror("y"):
            wheel(d, Box.around((body.x[0] + 0.1, 0.96 * body.y[1], 0.085), 0.17, 0.036, 0.17), dark, "grey plastic")
        d.cylinder(Box.sized(0.06, 0.06, 0.04, (front - 0.06, 0.0, 0.0)), dark, ends=(0.7, 1.0), segments=14)
        d.arch((x - 0.13, 0.0, 0.2), (x + 0.03, 0.0, 0.2), (0.0, 0.0, 0.05), 0.012, dark)
    with d.part("tube"):
        top = (front + 0.04, 0.0, h - 0.07)
        hose = [(-0.06, 0.0, 0.13), (-0.02, 0.0, 0.14), (0.02, -0.03, 0.25), (-0.03, -0.06, 0.45), (-0.11, -0.06, 0.7)]
        hose += [(-0.07, -0.03, h - 0.07), (-0.01, 0.0, h - 0.03), (0.05, 0.0, h - 0.09)]
        d.sweep([(front + u, y, z) for u, y, z in hose], 0.02, dark)
        d.bar((tube, 0.0, 0.08), top, 0.0165, "chrome", 12)
        d.bar(top, (top[0] + 0.18 * (tube - top[0]), 0.0, top[2] - 0.18 * (top[2] - 0.08)), 0.022, dark, 12)
    with d.part("head"):
        d.box(box.front(0.17).bottom(0.045), dark, 0.012)
        d.bar((tube + 0.03, 0.0, 0.035), (tube - 0.004, 0.0, 0.11), 0.026, dark, 12)
    d.fit()


@draws("mop_bucket")
def mop_bucket(d: Drawing) -> None:
    """A bucket with a wringer and a bail, water in it, and a mop that stands in it."""
    look = d.material("bucket", "yellow plastic, blue plastic, red plastic, grey plastic, green plastic")
    pole = d.material("pole", "beech, aluminium, blue plastic")
    box, top, low = d.bounds, 0.32, 0.06 if d.chance("wheels", 0.5) else 0.0
    deep, w, h = box.size
    with d.part("bucket"):
        outer = ((0.74, 0.74, low), (0.95, 0.95, top - 0.025), (1.0, 1.0, top - 0.02), (1.0, 1.0, top))
        bowl(d, box, outer, ((0.93, 0.93, top), (0.71, 0.71, low + 0.012)), look, 3.0)
        water = [oval(box.place(s * deep, s * w), low + z, 3.0) for s, z in ((0.72, 0.01), (0.81, 0.13))]
        d.loft(water, "blue ceramic", convex=True)
        if low:
            castors(d, box.bottom(low + 0.004).place(0.6 * deep, 0.6 * w))
        wringer = Box((-0.36 * deep, 0.36 * deep), (0.2 * w, 0.44 * w), (top - 0.12, top - 0.02))
        for slat in wringer.split("x", 6, gap=0.02):
            d.silhouette(slat, [(0.0, 1.0), (1.0, 1.0), (0.65, 0.0), (0.1, 0.0)], "grey plastic", "x")
        for bar in (wringer.top(-0.03).right(0.018), wringer.top(-0.03).left(0.012)):
            d.box(bar.inset(bottom=-0.008), "grey plastic")
        y, z = -0.1 * w, top - 0.01
        d.arch((-0.485 * deep, y, z), (0.485 * deep, y, z), (0.0, -0.12, 0.1), 0.005, "steel", 8)
    with d.part("mop"):
        d.bar((0.0, -0.14 * w, low + 0.15), (-0.2 * deep, -0.34 * w, h - 0.012), 0.0125, pole, 12)
        d.ball(Box.around((-0.2 * deep, -0.34 * w, h - 0.0145), 0.03, 0.03, 0.029), "grey plastic", 12)
        with d.at(0.0, -0.14 * w, low):
            d.revolve([(0.1, 0.1), (0.085, 0.17), (0.035, 0.26)], "white fabric", 18)
            d.cylinder(Box.sized(0.064, 0.064, 0.09, (0.0, 0.0, 0.24)), look, ends=(1.0, 0.62), segments=14)
            with d.ring(12):
                d.bar((0.03, 0.0, 0.255), (0.1, 0.0, 0.12), 0.011, "white fabric", 6)
    d.fit()


@draws("cleaning_cart")
def cleaning_cart(d: Drawing) -> None:
    """A cart with shelves of bottles and cloths, a waste sack at one end, and castors."""
    body = d.material("body", "grey plastic, blue plastic, black plastic, green plastic")
    look = d.material("sack", "yellow plastic, green plastic, navy fabric, red plastic")
    box, h, grey = d.bounds.inset(left=0.02), d.size.height, "grey plastic"
    shelf, low, middle, high = box.inset(left=0.38), 0.16, 0.5, h - 0.16
    boards = [plan.to(z=(z - 0.035, z)) for plan, z in ((box, low), (shelf, middle), (shelf, high))]
    for k, board in enumerate(boards):
        with d.part(f"shelf {k}"):
            d.box(board, body, 0.005)
            if not k:
                castors(d, box.bottom(0.127))
    between = shelf.to(z=(low, high - 0.03))
    with d.part("end"), d.mirror("x"):
        d.box(between.front(0.036).right(0.05).inset(right=0.02).move(x=-0.012), grey)
    with d.part("wall"):
        d.box(between.left(0.025).inset(x=0.01), body)
    with d.part("sack"):
        sack = box.left(0.38).inset(x=0.05, y=0.03).to(z=(low, high))
        d.sections(sack, [(0.8, 0.86, 0.0), (0.95, 0.98, 0.35), (0.95, 0.95, 1.0)], look, 0.3)
        d.slab(sack.top(-0.025).inset(bottom=-0.01), body, 0.08, 0.006)
        x, y, z, start = sack.x[1] - 0.01, d.bounds.y[1] - 0.012, h - 0.012, sack.center[1] + 0.05
        d.sweep([(-x, start, high), (-x, y, z), (x, y, z), (x, start, high)], 0.011, grey, 8)
    with d.part("bottles"):
        for k, tone in enumerate(("red", "yellow", "blue", "green")):
            spray = Box.sized(0.06, 0.06, 0.145, (box.x[0] + 0.09, box.y[0] + 0.09 + 0.085 * k, high))
            bottle(d, spray, f"{tone} plastic")
            d.box(spray.top(-0.016).place(0.044, 0.016).move(x=0.01), "red plastic", 0.002)
    with d.part("shelf 1"):
        for k, cloth in enumerate(
            Box((-0.18, 0.02), (box.y[0] + 0.09, box.y[0] + 0.34), (middle, middle + 0.14)).rows(4)
        ):
            d.cushion(cloth, "white fabric" if k % 2 else "blue fabric", 0.012)
        for x, size, tall in ((-0.1, 0.1, 0.1), (0.0, 0.08, 0.19), (0.1, 0.1, 0.1)):
            d.cylinder(Box.sized(size, size, tall, (x, shelf.y[1] - 0.1, middle)), "paper", segments=16)
    d.surface("top", boards[2].inset(back=0.16, front=0.03, y=0.03))
    d.surface("shelf-0", boards[0].inset(x=0.04, right=0.07, left=0.42), round(middle - 0.04 - low, 3))
    d.fit()
