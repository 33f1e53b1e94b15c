"""Electronics that stand on desks, tables and media furniture."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from ...drawing.box import Axis
from ...drawing.components import button

CASES = "black plastic, white plastic, grey plastic"
ICONS = ("sea pigment", "sky pigment", "ochre pigment", "moss pigment", "terracotta pigment", "chalk pigment")


def other(look: Look, *names: str) -> str:
    """The first of some finishes that shows on another one."""
    return next(name for name in names if name != getattr(look, "name", look))


def window(d: Drawing, face: Box) -> None:
    """A lit picture on the front of a box: a title bar, panels, lines of text."""
    place = d.print(face.front(0.0), "screen")
    panels = [(0.4, 0.96, 0.1, "night"), (0.4, 0.96, 0.8, "sea"), (0.04, 0.34, 0.5, "sea"), (0.04, 0.34, 0.1, "plum")]
    for y0, y1, z0, tone in panels:
        d.print(place.share(y=(y0, y1), z=(z0, 0.44 if tone == "plum" else 0.9)), f"{tone} pigment", 0.0004)
    for k in range(5):
        long, z = 0.28 + 0.07 * (k * 7 % 3), 0.66 - 0.11 * k
        d.print(place.share(y=(0.92 - long, 0.92), z=(z, z + 0.03)), "sky pigment", 0.00045)


def vents(d: Drawing, place: Box, count: int, material: Look, axis: Axis = "x") -> None:
    """Slots side by side along an axis of a flat place, as wide as what is between them."""
    for cell in place.split(axis, count):
        d.print(cell.share(**{axis: (0.25, 0.75)}), material)


@draws("monitor", whole=True)
def monitor(d: Drawing) -> None:
    """A flat screen with a thin frame, a neck and a foot."""
    look = d.material("body", "black plastic, black plastic, grey plastic, white plastic, aluminium")
    stand = d.material("stand", "black plastic, aluminium, grey plastic") if d.chance("other stand", 0.5) else look
    deep, wide, high = d.size
    tall = min(wide * d.uniform("ratio", 0.56, 0.62), high - 0.09)
    panel = d.bounds.top(tall).to(x=(0.12 * deep - 0.008, 0.12 * deep))
    d.slab(panel.inset(front=-0.012), look, 0.004, 0.002)
    with d.at(panel.x[0] + 0.002, 0.0, panel.center[2], pitch=-math.pi / 2):  # its back swells backward
        rear = Box.sized(0.77 * panel.height, 0.84 * wide, 0.03)
        d.sections(rear, [(1, 1, 0), (0.55, 0.6, 1)], look, 0.1, convex=True)
    front = panel.inset(front=-0.012)
    d.print(front.front(0.0).inset(y=0.008, top=0.008, bottom=0.016), "black glass", 0.0001)
    window(d, front.inset(y=0.01, top=0.01, bottom=0.02))
    d.print(front.front(0.0).bottom(0.01).inset(bottom=0.006).share(y=(0.94, 0.95)), "lamp glow")
    neck = 0.06 if d.chance("slim", 0.5) else 0.1
    spine = Box((-0.5 * deep, panel.x[0]), (-neck / 2, neck / 2), (0.01, panel.z[0] + 0.55 * panel.height))
    d.silhouette(spine, [(0.3, 0.0), (0.48, 0.0), (1.0, 1.0), (0.94, 1.0)], stand)
    foot = d.bounds.bottom(0.012).place(width=min(0.31, 0.53 * wide))
    if d.chance("round foot", 0.4):
        d.cylinder(foot, stand, bevel=0.003)
    else:
        d.slab(foot, stand, 0.02, 0.003)


@draws("laptop", whole=True)
def laptop(d: Drawing) -> None:
    """An open laptop: keys, touch pad, a bright screen that leans back."""
    deep, wide, high = d.size
    look = d.material("body", "aluminium, grey plastic, black plastic, white plastic")
    keys = d.material("keys", "black plastic, grey plastic")
    lean = d.uniform("lean", 0.22, 0.42)
    base = d.bounds.bottom(0.014).inset(back=(high - 0.008) * math.tan(lean) + 0.006)
    d.slab(base, look, 0.012, 0.003)
    board = d.print(base.top(0.0).share(x=(0.08, 0.56), y=(0.05, 0.95)), "black steel", 0.0002)
    *rows, last = board.split("x", 5)
    for row in rows:
        for key in row.columns(12):
            d.print(key.inset(x=0.002, y=0.002), keys)
    for key in last.columns([1, 1, 1, 5, 1, 1, 1, 1]):
        d.print(key.inset(x=0.002, y=0.002), keys)
    d.print(base.top(0.0).share(x=(0.62, 0.94), y=(0.33, 0.67)), "grey plastic")
    hinge = base.point(0.0, 0.1, 0.7)
    d.bar(hinge, base.point(0.0, 0.9, 0.7), 0.005, "black plastic", 8)
    with d.at(hinge[0], 0.0, 0.008, pitch=-lean):
        lid = d.box(Box((-0.007, 0.0), base.y, (0.0, (high - 0.008) / math.cos(lean) - 0.002)), look, 0.002)
        d.print(lid.front(0.0).share(y=(0.015, 0.985), z=(0.03, 0.97)), "black glass", 0.0002)
        window(d, lid.share(y=(0.03, 0.97), z=(0.07, 0.94)))


@draws("keyboard", whole=True)
def keyboard(d: Drawing) -> None:
    """Rows of keys, a block of numbers, on a board that rises to the back."""
    deep, wide, high = d.size
    look = d.material("body", "black plastic, white plastic, grey plastic, aluminium")
    keys = d.material("keys", "black plastic, white plastic, grey plastic, mint plastic")
    accent = d.pick("accent", ["orange plastic", "grey plastic", "teal paint"])
    low, key = 0.4 * high, 0.24 * high
    top = high - key - 0.001
    d.silhouette(d.bounds, [(0, 0), (1, 0), (1, low / high), (0, top / high)], look)
    with d.at(-deep / 2, 0.0, top, pitch=math.atan2(top - low, deep)):
        board = Box((0.007, deep - 0.007), (-wide / 2 + 0.008, wide / 2 - 0.008), (0.0, key))
        well, hull = board.bottom(0.0001).inset(0.003, z=-0.003), board.inset(top=-0.0002)
        d.add(shapes.box(well.x, well.y, well.z), look, [shapes.box(hull.x, hull.y, hull.z)])  # one for all keys
        with d.no_colliders():
            for i, row in enumerate(board.split("x", [1.3, 1, 1, 1, 1])):
                letters, numbers = row.columns([14, 4], 0.03 * wide)
                cells = [*letters.columns([1] * 14 if i < 4 else [1, 1, 1, 1, 6, 1, 1, 1, 1]), *numbers.columns(4)]
                for j, cell in enumerate(cells):
                    d.box(cell.inset(x=0.002, y=0.0012), accent if (i, j) in ((0, 0), (2, 13)) else keys, 0.0)


@draws("mouse", whole=True)
def mouse(d: Drawing) -> None:
    """A rounded mouse whose wheel points away from the user, to -x."""
    look = d.material("body", "black plastic, white plastic, grey plastic, pink plastic")
    dark = other(look, "black plastic", "grey plastic")
    shell = d.bounds
    rows = [(0.9, 0.86, 0.0), (1, 1, 0.15), (0.97, 0.97, 0.45), (0.85, 0.83, 0.72), (0.62, 0.58, 0.92), (0.3, 0.3, 1)]
    d.sections(shell, [(a, b, z, 0.04 * z) for a, b, z in rows], look, convex=True)
    x, y, z = shell.point(0.24, 0.5, 0.8)
    d.cylinder(Box.around((x, y, z), 0.014, 0.007, 0.014), dark, "y", bevel=0.001)


@draws("mouse_pad", whole=True)
def mouse_pad(d: Drawing) -> None:
    """A thin mat with round corners and a stitched edge."""
    look = d.material("body", "charcoal fabric, black fabric, grey fabric, navy fabric, brown leather, green fabric")
    d.slab(d.bounds, d.material("edge", "black fabric, red fabric, grey fabric"), 0.015, 0.0006)
    with d.no_colliders():
        d.slab(d.bounds.inset(x=0.004, y=0.004, top=-0.0003), look, 0.012, 0.0)


@draws("computer", whole=True)
def computer(d: Drawing) -> None:
    """A tower with a grille, bars or lit fans, a power button and ports; some have a window in their side."""
    look = d.material("body", "black steel, white steel, grey paint, aluminium")
    with d.corners(d.bounds, inset=0.02):
        d.box(Box((0.02, 0.06), (0.0, 0.03), (0.0, 0.016)), "rubber")
    case = d.box(d.bounds.inset(bottom=0.015, front=0.015), look)
    front = d.box(d.bounds.inset(bottom=0.02, y=0.003, top=0.004).front(0.015), "black plastic", 0.004)
    face = front.front(0.0)
    style = d.pick("front", ["mesh", "bars", "lit"])
    if style == "lit":
        glow = d.pick("glow", ["sea pigment", "plum pigment", "red plastic"])
        for cell in face.share(z=(0.04, 0.73)).rows(3):
            r = 0.48 * min(cell.width, cell.height)
            ring = cell.place(None, 2 * r, 2 * r)
            d.print(ring, glow, 0.0002, oval=True)
            d.print(ring.inset(y=0.1 * r, z=0.1 * r), "black plastic", oval=True)
            with d.at(*ring.center, pitch=math.pi / 2), d.ring(5):  # a fan
                d.print(Box((0.08 * r, 0.85 * r), (-0.1 * r, 0.1 * r), (0.0, 0.0)), "grey plastic", 0.0004)
    else:
        vents(d, face.share(y=(0.12, 0.88), z=(0.1, 0.68)), 14 if style == "bars" else 26, "grey plastic", "z")
        for bay in face.share(y=(0.08, 0.92), z=(0.8, 0.94)).rows(2, gap=0.01):
            d.print(bay, "black steel")
            d.print(bay.share(y=(0.78, 0.92), z=(0.3, 0.5)), "grey plastic", 0.0004)
    power = face.share(z=(0.75, 0.75)).place(None, 0.0, 0.0).move(y=-0.3 * face.width)
    d.print(power.inset(y=-0.01, z=-0.01), "steel", oval=True)
    d.print(power.inset(y=-0.004, z=-0.004), "lamp glow", 0.0004, oval=True)
    vents(d, face.share(y=(0.4, 0.85), z=(0.744, 0.756)), 3, "grey plastic", "y")
    if d.chance("window", 0.5):
        d.print(case.left(0.0).share(x=(0.1, 0.88), z=(0.1, 0.92)), "black glass")
    vents(d, case.top(0.0).share(x=(0.3, 0.68), y=(0.14, 0.86)), 9, "black plastic")


@draws("tablet", "phone", whole=True)
def tablet(d: Drawing) -> None:
    """A flat screen with icons, the size of a book or of a hand."""
    hand = d.category.name == "phone"
    paints = "black plastic, aluminium, blue plastic, pink plastic, mint plastic" if hand else f"aluminium, {CASES}"
    d.slab(d.bounds, d.material("body", paints), 0.012, 0.0022, steps=4)
    with d.no_colliders():
        d.slab(d.bounds.inset(x=0.0035, y=0.0035, top=-0.0002), "black glass", 0.0085, 0.0)
    place = d.print(d.bounds.top(0.0).inset(x=0.009, y=0.009), "screen")
    rows, columns = (6, 4) if hand else (4, 6)
    for i, row in enumerate(place.share(x=(0.14, 0.97), y=(0.08, 0.92)).split("x", rows)):
        for j, cell in enumerate(row.columns(columns)):
            if i == rows - 1 or d.chance(f"icon {i} {j}", 0.75):
                side = 0.62 * min(cell.depth, cell.width)
                d.print(cell.place(side, side), d.pick(f"colour {i} {j}", ICONS), 0.0004)


@draws("desk_phone", whole=True)
def desk_phone(d: Drawing) -> None:
    """A landline telephone: sloping body, keys, display, receiver on its cradles and a curled cord."""
    deep, wide, high = d.size
    look = d.material("body", "black plastic, grey plastic, white plastic, cream paint, red plastic")
    d.silhouette(d.bounds.inset(bottom=0.0), [(0, 0), (1, 0), (1, 0.3), (0.2, 0.78), (0, 0.78)], look, bevel=0.003)
    tilt = math.atan2(0.48 * high, 0.8 * deep)
    slope = Box((-0.8 * deep / math.cos(tilt), 0.0), (-wide / 2, wide / 2), (0.0, 0.0))
    with d.at(deep / 2, 0.0, 0.3 * high, pitch=tilt):
        d.print(slope.share(x=(0.05, 0.26), y=(0.42, 0.94)), "mint plastic")
        pad = slope.share(x=(0.36, 0.93), y=(0.46, 0.92))
        for row in pad.split("x", 4, gap=0.006):
            for key in row.columns(3, gap=0.008):
                d.box(key.inset(z=-0.004), other(look, "white plastic", "grey plastic"), 0.001)
        rest = slope.share(x=(0.02, 0.98), y=(0.06, 0.34))
        for end in (rest.share(x=(0.0, 0.24)), rest.share(x=(0.76, 1.0))):
            d.box(end.inset(0.012, z=-0.014), look)
            d.box(end.inset(y=0.002).top(-0.034).inset(bottom=0.012), look, 0.01)
        d.box(rest.share(x=(0.1, 0.9), y=(0.14, 0.86)).top(-0.042).inset(bottom=0.022), look, 0.009)
    cord = [(0.92, -0.004, 0.05), (0.86, -0.03, 0.12), (0.8, -0.045, 0.1), (0.72, -0.04, 0.16), (0.64, -0.004, 0.3)]
    d.sweep([d.bounds.point(*p) for p in cord], 0.004, "black plastic", 6)


@draws("game_controller", whole=True)
def game_controller(d: Drawing) -> None:
    """Two grips, two sticks, a cross, four bright buttons and triggers behind."""
    deep, wide, high = d.size
    look = d.material("body", "black plastic, white plastic, grey plastic, red plastic, blue plastic")
    dark = d.material("sticks", "black plastic, grey plastic")
    top = 0.72 * high
    body = d.bounds.to(z=(0.3 * high, top)).share(x=(0.06, 0.66), y=(0.1, 0.9))
    d.slab(body, look, 0.03, 0.008, 4)
    grip = [(0.28, 0.126, 0, 0.26, 0.4), (0.54, 0.21, 0.12, 0.22, 0.395), (0.92, 0.27, 0.45, 0.02, 0.36)]
    grip += [(0.64, 0.28, 0.66, -0.12, 0.33), (0.48, 0.216, 0.72, -0.14, 0.32)]
    with d.mirror("y"):
        d.sections(d.bounds, grip, look)
        d.box(d.bounds.share(x=(0.0, 0.2), y=(0.68, 0.92), z=(0.0, 0.66)), dark, 0.006)
    lift = high - top
    stick = [(0.1, -0.002), (0.05, 0.002), (0.045, 0.58 * lift), (0.085, 0.68 * lift), (0.08, lift)]
    for x, y in ((-0.17, -0.32), (0.06, 0.13)):
        with d.at(x * deep, y * wide, top):
            d.revolve([(r * deep, z) for r, z in stick], dark, 16)
    cross = Box.sized(0.18 * deep, 0.06 * deep, 0.004, (0.04 * deep, -0.14 * wide, top))
    for arm in (cross, cross.place(cross.width, cross.depth)):
        d.box(arm, dark, 0.001)
    with d.at(-0.16 * deep, 0.32 * wide, top):
        for k, tone in enumerate(("yellow", "red", "green", "blue")):
            at = (0.085 * deep * math.cos(k * math.pi / 2), 0.085 * deep * math.sin(k * math.pi / 2), 0.0)
            d.cylinder(Box.sized(0.084 * deep, 0.084 * deep, 0.005, at), f"{tone} plastic", bevel=0.001, segments=12)


@draws("remote_control", whole=True)
def remote_control(d: Drawing) -> None:
    """A slim remote with a red power key, a ring, and rows of keys."""
    look = d.material("body", CASES)
    body = d.slab(d.bounds.inset(top=0.003), look, 0.35 * d.size.width, 0.005, 5)
    face, side = body.top(0.0), 0.19 * d.size.width

    def key(x: float, y: float, material: Look) -> None:
        px, py, pz = face.point(x, y)
        d.print(Box.around((px, py, pz), side, side, 0.0), material, 0.00035, oval=True)

    key(0.1, 0.75, "red plastic")
    with d.at(*face.point(0.3)):
        for r, top, tone in ((0.36, 0.0025, "black steel"), (0.14, 0.003, "grey plastic")):
            d.revolve([(q * r * d.size.width, z * top) for q, z in ((1, 0), (1, 0.6), (0.9, 1))], tone)
    colors, pale = ("green plastic", "yellow plastic", "blue plastic"), other(look, "white plastic", "grey plastic")
    for j in range(3):
        key(0.17, 0.23 + 0.27 * j, "grey plastic")
        for i in range(5):
            key(0.53 + 0.082 * i, 0.24 + 0.26 * j, colors[j] if i == 4 else pale)


@draws("router", whole=True)
def router(d: Drawing) -> None:
    """A flat box with lights and two to four aerials."""
    look = d.material("body", CASES)
    body = d.slab(d.bounds.bottom(0.034).inset(back=0.012, bottom=0.004), look, 0.018, 0.006, 4)
    d.slab(body.bottom(-0.004).inset(x=0.018, y=0.1 * body.width, top=-0.004), "rubber", 0.01)
    top = body.top(0.0)
    for k, light in enumerate(top.front(0.028).inset(front=0.022).share(y=(0.25, 0.81)).columns(6)):
        d.print(light.place(width=0.006), "lamp glow" if k < 3 else "green plastic")
    vents(d, top.share(x=(0.25, 0.65), y=(0.2, 0.8)), 5, "grey plastic")
    count = d.integer("aerials", 2, 4)
    for k in range(count):
        y = k / (count - 1) - 0.5
        with d.at(d.bounds.x[0] + 0.008, 0.86 * y * body.width, 0.02, roll=-0.18 * y):
            d.bar((0, 0, 0), (0.012, 0, 0), 0.006, "black plastic", 8)
            d.box(Box.sized(0.012, 0.014, d.size.height - 0.022), look, 0.004)


@draws("conference_phone", whole=True)
def conference_phone(d: Drawing) -> None:
    """A three-armed phone for meetings, with keys, a display and lights."""
    look = d.material("body", "black plastic, grey plastic, black steel")
    r, high = 0.5 * min(d.size[:2]), d.size.height
    profile = [(0, 0.5, 0), (1.1, 0.22, 0), (1.12, 0.2, 0.2), (1.08, 0.18, 0.4), (0.2, 0.45, 0.85), (-0.2, 0.4, 0.85)]
    with d.ring(3):
        d.hull([(x * r, s * y * r, z * high) for s in (-1, 1) for x, y, z in profile], look)
        with d.at(0.72 * r, 0.0, 0.61 * high, pitch=0.28):
            d.box(Box.sized(0.48 * r, 0.34 * r, 0.14 * high, (0, 0, -0.1 * high)), "charcoal fabric", 0.004)
        d.box(Box.sized(0.024, 0.04, 0.08 * high, (1.08 * r, 0, 0.3 * high)), "green plastic", 0.001)
    face = Box.sized(0.92 * r, 0.92 * r, 0.12 * high, (0, 0, 0.8 * high))
    d.cylinder(face, other(look, "grey plastic", "black plastic"), ends=(1.0, 0.92))
    d.box(Box.sized(0.26 * r, 0.52 * r, 0.08 * high, (-0.21 * r, 0, 0.88 * high)), "screen", 0.002)
    keys = Box((0.0, 0.28 * r), (-0.24 * r, 0.22 * r), (0.9 * high, high))
    for row in keys.split("x", 2, gap=0.04 * r):
        for key in row.columns(3, gap=0.05 * r):
            d.box(key, "white plastic", 0.001)


@draws("vr_headset", whole=True)
def vr_headset(d: Drawing) -> None:
    """Goggles with a strap over and around the head."""
    deep, wide, high = d.size
    look = d.material("body", CASES)
    strap = d.material("strap", "charcoal fabric, grey fabric, black fabric")
    visor = d.cushion(d.bounds.front(0.09).share(z=(0.0, 0.8)), look, 0.03)
    with d.mirror("y"):
        button(d, visor.share(y=(0.72, 0.72)), "black glass", 0.012, 0.0008)
    d.slab(visor.back(-0.02).share(y=(0.05, 0.95), z=(0.05, 0.95)).inset(front=-0.01), "black fabric", 0.01, 0.008)
    t = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 9)
    start = 0.5 * deep - 0.06
    d.sweep(
        np.c_[start - (deep - 0.065) * np.cos(t), 0.46 * wide * np.sin(t), 0.4 * high + 0 * t], (0.005, 0.026), strap
    )
    over = [(0.8, 0.79), (0.68, 0.96), (0.4, 0.98), (0.15, 0.85), (0.015, 0.45)]
    d.sweep([d.bounds.point(x, 0.5, z) for x, z in over], (0.026, 0.005), strap)
