"""Bars, cafes and restaurants: counters, display cases, espresso machines, tills, host stands."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, draws
from ...drawing.components import button, drawer, knob

_WOODS = "oak, walnut, mahogany, wenge, cherry, light oak, ash grey wood, pine"


@draws("bar_counter")
def bar_counter(d: Drawing) -> None:
    """A front of panels or battens under a broad top, a foot rail, a lower worktop and shelves behind; guests at +x."""
    wood = d.material("front", _WOODS + ", navy paint, teal paint, black paint, white paint")
    look = d.material("top", "walnut, oak, marble, dark marble, granite, mahogany, copper")
    metal = d.material("rail", "brass, steel, black steel")
    box, work = d.bounds, 0.88
    top = box.top(0.045)
    case = box.inset(front=0.16, y=0.02, top=0.045)
    with d.part("front"):
        panel = d.box(case.front(0.03), wood, 0.001)
        face = panel.front(-0.012).inset(back=-0.001)
        for rail in (face.bottom(0.1), face.top(0.08)):
            d.box(rail, wood, 0.002)
        between, panelled = face.inset(bottom=0.1, top=0.08), d.style in ("classic", "rustic")
        for cell in between.columns(max(3, round(box.width / (0.55 if panelled else 0.07)))):
            if panelled:
                d.box(cell.inset(y=0.04, z=0.05, front=0.003), wood, 0.007)
            else:
                d.box(cell.inset(y=0.019, front=-0.006), wood, 0.0)
        x, y, z = panel.x[1] + 0.1, case.y[1] - 0.04, 0.2
        d.bar((x, -y, z), (x, y, z), 0.022, metal, 12)
        with d.mirror("y"):
            d.ball(Box.around((x, y, z), 0.06, 0.06, 0.06), metal, 12)
        with d.along((panel.x[1], 0.08 - y, z), (panel.x[1], y - 0.08, z), max(2, round(box.width / 0.8)) + 1):
            d.sweep([(0.0, 0.0, -0.04), (0.05, 0.0, -0.05), (0.1, 0.0, -0.015)], 0.011, metal, 8)
    with d.part("top"):
        d.box(top.front(0.38), look, 0.006)
    with d.part("worktop"):
        counter = d.box(case.inset(front=0.03).to(z=(work - 0.03, work)), "brushed steel", 0.002)
    room = case.inset(front=0.03, back=0.03).to(z=(0.0, work - 0.03))
    for name, side in (("right", room.right(0.025)), ("left", room.left(0.025))):
        with d.part(name):
            d.box(side, wood, 0.001)
            d.box(side.front(0.17).to(z=(work, top.z[0])), wood, 0.001)
    for k, (z, end) in enumerate(((0.12, 0.455), (0.48, work - 0.035))):
        with d.part(f"shelf {k}"):
            shelf = d.box(room.inset(y=0.025).to(z=(z - 0.022, z)), wood, 0.001)
        d.surface(f"shelf-{k}", shelf, round(end - z, 3), inset=0.012)
    d.surface("worktop", counter.inset(back=0.01, front=0.21, y=0.04))
    d.surface("top", top.front(0.37), inset=0.01)
    d.fit()


_CAKES = ("cake sponge", "chocolate", "pink icing", "icing", "bread crust", "lemon peel")


def _pastry(d: Drawing, number: int) -> None:
    """A cake on a plate, or a tray of rolls or of small cakes, at the frame's origin."""
    look, other = _CAKES[number % 6], _CAKES[(number + 2) % 6]
    if number % 3 == 0:
        for size, low, high, finish in ((0.23, 0, 8, "white ceramic"), (0.19, 8, 60, look), (0.184, 60, 72, other)):
            layer = Box.sized(size, size, 0.001 * (high - low), (0.0, 0.0, 0.001 * low))
            d.cylinder(layer, finish, bevel=0.002, segments=20)
        d.ball(Box.around((0.0, 0.0, 0.083), 0.028, 0.028, 0.028), "red apple", 8)
        return
    d.box(Box.sized(0.24, 0.2, 0.01), "white ceramic" if number % 2 else "beech", 0.002)
    with d.grid(Box.sized(0.225, 0.17, 0.05, (0.0, 0.0, 0.01)), x=3, y=2):
        if number % 3 == 1:
            d.ball(Box.sized(0.068, 0.08, 0.05, (0.0, 0.0, -0.003)), "bread crust", 10)
        else:
            cake = Box.sized(0.068, 0.068, 0.055)
            d.cylinder(cake.share(z=(0.0, 0.64)), look, ends=(0.68, 0.94), segments=10)
            d.cylinder(cake.share(z=(0.64, 1.0)), other, ends=(1.0, 0.4), segments=10)


@draws("display_case", whole=True)
def display_case(d: Drawing) -> None:
    """A glass front that leans or stands over a panelled base; cakes on two lit boards; a top for a till."""
    body = d.material("base", "oak, white paint, black paint, walnut, sage paint, grey paint, navy paint")
    metal = d.material("frame", "brushed steel, black steel, brass")
    box, lean = d.bounds.inset(front=0.015), d.pick("lean", [0.0, 0.1, 0.16])
    base, room = box.to(z=(0.08, 0.46)), box.to(z=(0.49, box.z[1] - 0.03))
    d.box(box.bottom(0.09).inset(back=0.02, front=0.05, y=0.03), "black plastic", 0.0)
    d.box(base, body, 0.002)
    for panel in base.front(-0.008).inset(back=-0.001, y=0.04, z=0.05).columns(max(2, round(box.width / 0.4)), 0.04):
        d.box(panel, body, 0.005)
    d.box(base.top(-0.03).inset(front=-0.015), metal)
    top = d.box(box.top(0.03).inset(front=lean - 0.012), metal)
    cut = 1 - lean / box.depth
    d.silhouette(room.inset(y=0.002), [(0.98, 0.0), (1.0, 0.0), (cut, 1.0), (cut - 0.02, 1.0)], "glass")
    with d.mirror("y"):
        d.silhouette(room.left(0.006), [(0.03, 0.0), (0.98, 0.0), (cut - 0.02, 1.0), (0.03, 1.0)], "glass")
        d.box(room.back(0.02).left(0.024), metal, 0.0)
    for k, slider in enumerate(room.inset(y=0.012).columns(2, gap=-0.02)):
        d.box(slider.back(0.006).move(x=0.002 + 0.009 * k), "glass", 0.0)
    middle = room.center[2] + 0.02
    board = room.inset(back=0.025, front=0.5 * lean + 0.08, y=0.01).to(z=(middle - 0.008, middle))
    d.box(board, "glass", 0.0)
    for front, z in ((top.x[1] - 0.04, top.z[0] - 0.014), (board.x[1] - 0.005, board.z[0] - 0.014)):
        d.box(room.inset(y=0.02).to(x=(front - 0.02, front), z=(z, z + 0.0135)), "lamp glow", 0.0)
    first = d.integer("first", 0, 5)
    for row, (x, z) in enumerate(((room.center[0] + 0.04, room.z[0]), (board.center[0], middle))):
        for k, cell in enumerate(room.inset(y=0.05).columns(int((box.width - 0.1) / 0.27))):
            with d.at(x, cell.center[1], z):
                _pastry(d, 2 * k + row + first)
    d.surface("top", top.inset(back=0.02, front=0.022, y=0.02))


@draws("espresso_machine", whole=True)
def espresso_machine(d: Drawing) -> None:
    """Two or three groups with handles over a drip tray, steam wands, a gauge, and cups on top."""
    body = d.material("body", "brushed steel, chrome, red paint, black paint, white paint, copper")
    grip, steel = d.material("handles", "black plastic, walnut"), "chrome"
    box, w = d.bounds, d.size.width
    rail = box.z[1] - 0.03
    top = rail - 0.045
    with d.corners(box, inset=0.07):
        d.cylinder(Box.sized(0.044, 0.044, 0.06), steel, ends=(1.0, 0.8), segments=14)
    base = d.box(box.inset(x=0.02, y=0.02).to(z=(0.055, 0.11)), "brushed steel")
    tray = d.print(base.top(0.0).inset(back=0.17, front=0.01, y=0.015), "black plastic")
    for slat in tray.inset(x=0.01, y=0.01).columns(12, gap=0.04 * w):
        d.box(slat.top(-0.006).inset(bottom=-0.002), steel, 0.0)
    d.box(base.back(0.17).inset(y=0.01).to(z=(0.105, top - 0.05)), body)
    head = d.box(box.inset(front=0.09).to(z=(top - 0.14, top)), body, 0.012)
    x, front = head.x[1], box.x[1]
    with d.mirror("y"):
        cheek = Box((box.x[0] + 0.01, box.x[0] + 0.27), box.left(0.024).move(y=-0.002).y, (0.06, top - 0.05))
        d.silhouette(cheek, [(0.0, 0.0), (0.62, 0.0), (1.0, 1.0), (0.0, 1.0)], body)
        wand = [(-0.01, 0.0, top - 0.11), (0.03, 0.0, top - 0.12), (0.045, -0.01, top - 0.17), (0.02, -0.02, 0.15)]
        d.sweep([(x + u, w / 2 - 0.045 + v, z) for u, v, z in wand], 0.006, steel, 8)
        knob(d, Box.around((x, w / 2 - 0.045, top - 0.06), 0.0, 0.0, 0.0), grip, 0.02, 0.035)
    groups = box.inset(y=0.1).columns(2 if w < 0.8 else 3)
    for y in (cell.center[1] for cell in groups):
        for size, low, high in ((0.084, 0.2, 0.135), (0.068, 0.228, 0.2), (0.03, 0.25, 0.226)):
            d.cylinder(Box.sized(size, size, low - high, (front - 0.17, y, top - low)), steel, segments=18)
        d.bar((front - 0.14, y, top - 0.213), (front - 0.1, y, top - 0.216), 0.008, steel, 8)
        d.bar((front - 0.11, y, top - 0.215), (front, y, top - 0.235), 0.0145, grip)
        for k, key in enumerate(Box.around((x, y, top - 0.061), 0.0, 0.088, 0.018).columns(4, gap=0.008)):
            d.box(key.front(-0.0025).inset(back=-0.004), "black plastic" if k else "lamp glow", 0.0)
    gauge = Box.around((x, (groups[-1].y[0] + groups[-2].y[1]) / 2, top - 0.075), 0.0, 0.0, 0.0)
    button(d, gauge, steel, 0.026, 0.012)
    button(d, gauge.move(x=0.012), "white plastic", 0.021, 0.0004)
    fence = head.inset(x=0.015, y=0.015)
    (x0, x1), (y0, y1) = fence.x, fence.y
    d.sweep([(x0, y0, rail), (x1, y0, rail), (x1, y1, rail), (x0, y1, rail)], 0.004, steel, 6, closed=True)
    with d.corners(fence.top(0.01)):
        d.bar((0.0, 0.0, 0.0), (0.0, 0.0, rail - top + 0.01), 0.004, steel, 6)
    columns = int((w - 0.1) / 0.085)
    for k, cell in enumerate(c for row in fence.inset(x=0.005, y=0.01).split("x", 3) for c in row.columns(columns)):
        stack = 0 if k % 7 == 2 else 2 if box.z[1] - top > 0.07 and (k + k // columns) % 3 == 0 else 1
        for low, high in ((0.0, 0.05), (0.05, box.z[1] - top))[:stack]:
            cup = Box.sized(0.072, 0.072, high - low, (*cell.center[:2], top + low))
            d.cylinder(cup, "white ceramic", ends=(0.68, 1.0), segments=12)


@draws("cash_register", whole=True)
def cash_register(d: Drawing) -> None:
    """A drawer under a touch screen on a foot, or under keys, a printer and a display for the customer."""
    body = d.material("body", "black plastic, white plastic, grey plastic")
    box, z, w = d.bounds.inset(front=0.025), 0.1, d.size.width
    till = box.bottom(z)
    case = till.inset(front=0.02)
    for board in (case.top(0.008), case.bottom(0.006), case.left(0.006), case.right(0.006), case.back(0.01)):
        d.box(board, body)
    drawer(d, "drawer", till.inset(y=0.004, bottom=0.006, top=0.006), body, "chrome", "knob", 0.28, "grey plastic")
    if d.chance("touch", 0.55):
        d.box(Box((-0.12, 0.05), (-0.1, 0.1), (z, z + 0.02)), body, 0.005)
        neck = Box((-0.1, -0.04), (-0.03, 0.03), (z + 0.015, z + 0.13))
        d.silhouette(neck, [(0, 0), (1, 0), (0.8, 1), (0.3, 1)], body)
        with d.at(0.0, 0.0, z + 0.035, pitch=-0.42):
            long = (box.height - z - 0.055) / math.cos(0.42)
            face = d.box(Box((-0.03, 0.0), (-0.42 * w, 0.42 * w), (0.0, long)), body, 0.006).front(0.0)
            shown = d.print(face.inset(y=0.03 * w, z=0.014), "screen").inset(z=0.02)
            tones = ("blue", "green", "orange", "yellow", "grey", "red")
            keys = [key for row in shown.share(y=(0.05, 0.6)).rows(3, 0.01) for key in row.columns(4, 0.01)]
            for k, key in enumerate(keys):
                d.print(key, f"{tones[k % 6]} plastic", 0.00045)
            d.print(shown.share(y=(0.65, 0.95)), "white plastic", 0.00045)
        return
    desk = case.inset(back=0.01, y=0.01).to(z=(z, z + 0.13))
    run = 1 - 0.11 / desk.depth
    d.silhouette(desk, [(0.0, 0.0), (1.0, 0.0), (1.0, 0.23), (1 - run, 1.0), (0.0, 1.0)], body)
    with d.at(desk.x[1], 0.0, z + 0.03, pitch=math.atan2(0.1, run * desk.depth)):
        keys = Box((0.02 - math.hypot(run * desk.depth, 0.1), -0.02), (0.04 - w / 2, w / 2 - 0.04), (-0.004, 0.008))
        for i, row in enumerate(keys.split("x", 5, gap=0.008)):
            for j, key in enumerate(row.columns(7, gap=0.008)):
                d.box(key, "red plastic" if (i, j) == (4, 6) else "grey plastic" if j < 4 else "white plastic", 0.0)
    printer = d.box(Box.sized(0.085, 0.1, 0.045, (box.x[0] + 0.06, 0.08 - w / 2, z + 0.125)), body, 0.006)
    d.box(printer.inset(y=0.02).place(depth=0.003).top(-0.045).inset(bottom=-0.005), "paper", 0.0)
    d.bar((box.x[0] + 0.05, 0.08, z + 0.12), (box.x[0] + 0.05, 0.08, box.z[1] - 0.05), 0.012, body)
    shown = d.box(Box((box.x[0] + 0.02, box.x[0] + 0.06), (-0.03, 0.15), (box.z[1] - 0.075, box.z[1])), body, 0.006)
    d.print(shown.front(0.0).inset(y=0.015, z=0.012), "screen")


@draws("host_stand")
def host_stand(d: Drawing) -> None:
    """A panelled stand with a sloped top and a ledge, open shelves on the host's side; guests come from +x."""
    wood = d.material("body", _WOODS + ", black paint, navy paint")
    trim = d.material("trim", "brass, black steel, steel")
    box, board, middle, low = d.bounds, 0.022, 0.52, d.size.height - 0.13
    case = box.inset(x=0.03, y=0.025).to(z=(0.06, low))
    room = case.inset(front=board)
    inner = room.inset(y=board)
    with d.part("front"):
        panel = d.box(case.front(board), wood, 0.001)
        field = d.box(panel.front(-0.008).inset(back=-0.001, y=0.06, z=0.08), wood, 0.006)
        d.box(field.front(-0.003).inset(back=-0.002).place(width=0.14).top(0.24).inset(top=0.1), trim, 0.001)
    shelf = inner.inset(back=0.01).to(z=(middle - board, middle))
    boards = (("foot", box.bottom(0.06)), ("right", room.right(board)), ("left", room.left(board)), ("shelf", shelf))
    for name, place in boards:
        with d.part(name):
            d.box(place, wood, 0.006 if name == "foot" else 0.001)
    with d.part("desk"):
        d.box(case.top(board), wood, 0.001)
        desk, flat = box.to(z=(low, box.z[1])), 1 - 0.06 / box.depth
        d.silhouette(desk, [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (flat, 1.0), (0.0, 0.23)], wood)
        with d.at(box.x[0], 0.0, low + 0.03, pitch=-math.atan2(0.1, flat * box.depth)):
            d.box(Box((0.006, 0.022), box.inset(y=0.03).y, (-0.004, 0.016)), trim, 0.002)
            with d.mirror("y"):
                page = d.box(Box((0.06, 0.3), (0.001, 0.17), (-0.001, 0.004)), "paper", 0.0).top(0.0)
                for line in page.inset(x=0.03, y=0.02).split("x", 6, gap=0.028):
                    d.print(line, "grey plastic")
    for k, (z, end) in enumerate(((0.06, middle - board), (middle, low - board))):
        floor = inner.inset(back=0.02, front=0.01, y=0.01).to(z=(z - 0.01, z))
        d.surface(f"shelf-{k}", floor, round(end - z - 0.005, 3))
    d.fit()
