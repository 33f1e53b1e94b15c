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
        between = face.inset(bottom=0.1, top=0.08)
        if d.style in ("classic", "rustic"):
            for cell in between.columns(max(3, round(box.width / 0.55))):
                for stile in (cell.left(0.035), cell.right(0.035)):
                    d.box(stile.inset(front=-0.002), wood, 0.002)
                d.box(cell.inset(y=0.075, z=0.05, front=0.003), wood, 0.007)
        else:
            for batten in between.columns(round(box.width / 0.07), gap=0.038):
                d.box(batten.inset(front=-0.006), wood, 0.0)
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
    look = _CAKES[number % 6]
    if number % 3 == 0:
        levels = (
            (0.23, 0.0, 0.008, "white ceramic"),
            (0.19, 0.008, 0.06, look),
            (0.184, 0.06, 0.072, _CAKES[(number + 2) % 6]),
        )
        for size, low, high, finish in levels:
            d.cylinder(Box.sized(size, size, high - low, (0.0, 0.0, low)), finish, bevel=0.002, segments=20)
        d.ball(Box.around((0.0, 0.0, 0.083), 0.028, 0.028, 0.028), "red apple", 8)
        return
    d.box(Box.sized(0.24, 0.2, 0.01), "white ceramic" if number % 2 else "beech", 0.002)
    with d.grid(Box.sized(0.225, 0.17, 0.05, (0.0, 0.0, 0.01)), x=3, y=2):
        if number % 3 == 1:
            d.ball(Box.sized(0.068, 0.08, 0.05, (0.0, 0.0, -0.003)), "bread crust", 10)
        else:
            d.cylinder(Box.sized(0.064, 0.064, 0.035), look, ends=(0.72, 1.0), segments=10)
            d.cylinder(
                Box.sized(0.068, 0.068, 0.02, (0.0, 0.0, 0.035)), _CAKES[(number + 1) % 6], ends=(1.0, 0.4), segments=10
            )


@draws("display_case", whole=True)
def display_case(d: Drawing) -> None:
    """A glass front that leans or stands over a panelled base; cakes on two lit boards; a top for a till."""
    body = d.material("base", "oak, white paint, black paint, walnut, sage paint, grey paint, navy paint")
    metal = d.material("frame", "brushed steel, black steel, brass")
    box = d.bounds.inset(front=0.015)
    lean = d.pick("lean", [0.0, 0.1, 0.16])
    base, room = box.inset(bottom=0.08).to(z=(0.08, 0.46)), box.to(z=(0.49, box.z[1] - 0.03))
    d.box(box.bottom(0.09).inset(back=0.02, front=0.05, y=0.03), "black plastic", 0.0)
    d.box(base, body, 0.002)
    for panel in (
        base.front(-0.008)
        .inset(back=-0.001, y=0.04, bottom=0.05, top=0.06)
        .columns(max(2, round(box.width / 0.4)), 0.04)
    ):
        d.box(panel, body, 0.005)
    d.box(base.top(-0.03).inset(front=-0.015), metal)
    top = d.box(box.top(0.03).inset(front=lean - 0.012), metal)
    (x, _), (y0, y1), (z0, z1) = room.x, room.y, room.z
    low, high = room.x[1], room.x[1] - lean
    d.hull(
        [(px + o, y, z) for px, z in ((low, z0), (high, z1)) for o in (-0.01, 0.0) for y in (y0 + 0.002, y1 - 0.002)],
        "glass",
    )
    ends = ((x + 0.02, z0), (x + 0.02, z1), (low - 0.011, z0), (high - 0.011, z1))
    with d.mirror("y"):
        d.hull([(px, y1 - 0.003 + o, z) for px, z in ends for o in (-0.003, 0.003)], "glass")
        d.box(room.back(0.02).left(0.024), metal, 0.0)
    for k, slider in enumerate(room.inset(y=0.012).columns(2, gap=-0.02)):
        d.box(slider.back(0.006).move(x=0.002 + 0.009 * k), "glass", 0.0)
    middle = room.center[2] + 0.02
    reach = low - lean * (middle - z0) / room.height - 0.07
    d.box(Box((x + 0.025, reach), (y0 + 0.01, y1 - 0.01), (middle - 0.008, middle)), "glass", 0.0)
    for px, z in ((high - 0.03, z1 - 0.014), (reach - 0.005, middle - 0.022)):
        d.box(Box((px - 0.02, px), (y0 + 0.02, y1 - 0.02), (z, z + 0.0135)), "lamp glow", 0.0)
    first = d.integer("first", 0, 5)
    for row, (z, px) in enumerate(((z0, room.center[0] + 0.04), (middle, (x + reach) / 2))):
        for k, cell in enumerate(room.inset(y=0.05).columns(int((box.width - 0.1) / 0.27))):
            with d.at(px, cell.center[1], z):
                _pastry(d, 2 * k + row + first)
    d.surface("top", top.inset(back=0.02, front=0.022, y=0.02))


@draws("espresso_machine", whole=True)
def espresso_machine(d: Drawing) -> None:
    """Two or three groups with handles over a drip tray, steam wands, gauges, and cups on top."""
    body = d.material("body", "brushed steel, chrome, red paint, black paint, white paint, copper")
    grip = d.material("handles", "black plastic, walnut")
    box = d.bounds
    rail = box.z[1] - 0.03
    top = rail - 0.045
    with d.corners(box, inset=0.07):
        d.cylinder(Box.sized(0.044, 0.044, 0.06), "chrome", ends=(1.0, 0.8), segments=14)
    base = d.box(box.inset(x=0.02, y=0.02).to(z=(0.055, 0.11)), "brushed steel")
    tray = d.print(base.top(0.0).inset(back=0.17, front=0.01, y=0.015), "black plastic")
    for slat in tray.inset(x=0.01, y=0.01).columns(12, gap=0.04 * box.width):
        d.box(slat.top(-0.006).inset(bottom=-0.002), "chrome", 0.0)
    d.box(base.back(0.17).inset(y=0.01).to(z=(0.105, top - 0.05)), body)
    head = d.box(box.inset(front=0.09).to(z=(top - 0.14, top)), body, 0.012)
    back, face = box.x[0], head.front(0.0)
    outline = ((back + 0.01, 0.06), (back + 0.01, top - 0.05), (back + 0.27, top - 0.05), (back + 0.17, 0.06))
    with d.mirror("y"):
        cheek = box.left(0.024).move(y=-0.002)
        d.hull([(x, y, z) for x, z in outline for y in cheek.y], body)
        x, y = face.x[1], box.y[1] - 0.045
        wand = [
            (x - 0.01, y, top - 0.11),
            (x + 0.03, y, top - 0.12),
            (x + 0.045, y - 0.01, top - 0.17),
            (x + 0.02, y - 0.02, 0.15),
        ]
        d.sweep(wand, 0.006, "chrome", 8)
        knob(d, Box.around((x, y, top - 0.06), 0.0, 0.0, 0.0), grip, 0.02, 0.035)
    count = 2 if box.width < 0.8 else 3
    groups = box.inset(y=0.12 if count == 3 else 0.08).columns(count)
    for cell in groups:
        x, y = box.x[1] - 0.17, cell.center[1]
        for size, low, high in ((0.084, 0.2, 0.135), (0.068, 0.228, 0.2), (0.03, 0.25, 0.226)):
            d.cylinder(Box.sized(size, size, low - high, (x, y, top - low)), "chrome", segments=18)
        d.bar((x + 0.03, y, top - 0.213), (x + 0.065, y, top - 0.216), 0.008, "chrome", 8)
        d.bar((x + 0.06, y, top - 0.215), (box.x[1], y, top - 0.235), 0.0145, grip, 10)
        for k, key in enumerate(Box.around((face.x[1], y, top - 0.061), 0.0, 0.088, 0.018).columns(4, gap=0.008)):
            d.box(key.front(-0.0025).inset(back=-0.004), "black plastic" if k else "lamp glow", 0.0)
    gauge = Box.around(
        (face.x[1], 0.0 if count == 2 else (groups[1].center[1] + groups[2].center[1]) / 2, top - 0.075), 0.0, 0.0, 0.0
    )
    button(d, gauge, "chrome", 0.026, 0.012)
    button(d, gauge.move(x=0.012), "white plastic", 0.021, 0.0004)
    fence = head.inset(x=0.015, y=0.015)
    (x0, x1), (y0, y1) = fence.x, fence.y
    for start, end in (((x0, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0))):
        d.bar((*start, rail), (*end, rail), 0.004, "chrome", 6)
        d.bar((*start, top - 0.01), (*start, rail), 0.004, "chrome", 6)
    columns = int((box.width - 0.1) / 0.085)
    cups = [c for row in fence.inset(x=0.005, y=0.01).split("x", 3) for c in row.columns(columns)]
    for k, cell in enumerate(cups, start=1):
        if k % 7 != 3:
            x, y, _ = cell.center
            stacked = box.z[1] - top > 0.07 and (k + k // columns) % 3 == 0
            for low, high in ((0.0, 0.05), (0.05, box.z[1] - top))[: 1 + stacked]:
                d.cylinder(
                    Box.sized(0.072, 0.072, high - low, (x, y, top + low)),
                    "white ceramic",
                    ends=(0.68, 1.0),
                    segments=12,
                )


@draws("cash_register", whole=True)
def cash_register(d: Drawing) -> None:
    """A drawer under a body with a touch screen, or with keys, a printer and a display for the customer."""
    body = d.material("body", "black plastic, white plastic, grey plastic")
    box = d.bounds.inset(front=0.025)
    z, w = 0.1, box.width
    till = box.bottom(z)
    case = till.inset(front=0.02)
    for board in (case.top(0.008), case.bottom(0.006), case.left(0.006), case.right(0.006), case.back(0.01)):
        d.box(board, body)
    drawer(d, "drawer", till.inset(y=0.004, bottom=0.006, top=0.006), body, "chrome", "knob", 0.28, "grey plastic")
    if d.chance("touch", 0.55):
        with d.at(-0.02, 0.0, z):
            d.box(Box((-0.1, 0.07), (-0.1, 0.1), (0.0, 0.02)), body, 0.005)
            d.hull(
                [
                    (x, y, h)
                    for x, h in ((-0.08, 0.015), (-0.02, 0.015), (-0.06, 0.13), (-0.03, 0.13))
                    for y in (-0.03, 0.03)
                ],
                body,
            )
        lean = 0.42
        with d.at(0.0, 0.0, z + 0.035, pitch=-lean):
            long = (box.height - z - 0.055) / math.cos(lean)
            face = d.box(Box((-0.03, 0.0), (-0.42 * w, 0.42 * w), (0.0, long)), body, 0.006).front(0.0)
            shown = d.print(face.inset(y=0.03 * w, z=0.014), "screen")
            tones = ("blue", "green", "orange", "yellow", "grey", "red")
            for i, row in enumerate(shown.share(y=(0.05, 0.6)).inset(z=0.02).rows(3, gap=0.01)):
                for j, key in enumerate(row.columns(4, gap=0.01)):
                    d.print(key, f"{tones[(4 * i + j) % 6]} plastic", 0.00045)
            d.print(shown.share(y=(0.65, 0.95)).inset(z=0.02), "white plastic", 0.00045)
        return
    back, front = box.x[0], box.x[1] - 0.02
    outline = ((back + 0.01, z), (front, z), (front, z + 0.03), (back + 0.12, z + 0.13), (back + 0.01, z + 0.13))
    d.hull([(x, y, h) for x, h in outline for y in till.inset(y=0.01).y], body)
    run = front - back - 0.12
    with d.at(front, 0.0, z + 0.03, pitch=math.atan2(0.1, run)):
        keys = Box((-math.hypot(run, 0.1) + 0.02, -0.02), (0.04 - w / 2, w / 2 - 0.04), (-0.004, 0.008))
        for i, row in enumerate(keys.split("x", 5, gap=0.008)):
            for j, key in enumerate(row.columns(7, gap=0.008)):
                tone = "red" if (i, j) == (4, 6) else "grey" if j < 4 else "white"
                d.box(key, f"{tone} plastic", 0.0)
    printer = d.box(Box((back + 0.015, back + 0.1), (0.03 - w / 2, 0.13 - w / 2), (z + 0.125, z + 0.17)), body, 0.006)
    d.box(printer.inset(y=0.02).place(depth=0.003).top(-0.045).inset(bottom=-0.005), "paper", 0.0)
    d.bar((back + 0.05, 0.08, z + 0.12), (back + 0.05, 0.08, box.z[1] - 0.05), 0.012, body)
    pole = d.box(Box((back + 0.02, back + 0.06), (-0.03, 0.15), (box.z[1] - 0.075, box.z[1])), body, 0.006)
    d.print(pole.front(0.0).inset(y=0.015, z=0.012), "screen")


@draws("host_stand")
def host_stand(d: Drawing) -> None:
    """A panelled stand with a sloped top and a ledge, open shelves on the host's side; guests come from +x."""
    wood = d.material("body", _WOODS + ", black paint, navy paint")
    trim = d.material("trim", "brass, black steel, steel")
    box, board, middle = d.bounds, 0.022, 0.52
    low = box.z[1] - 0.13
    case = box.inset(x=0.03, y=0.025).to(z=(0.06, low))
    with d.part("foot"):
        d.box(box.bottom(0.06), wood, 0.006)
    with d.part("front"):
        panel = d.box(case.front(board), wood, 0.001)
        field = d.box(panel.front(-0.008).inset(back=-0.001, y=0.06, bottom=0.08, top=0.08), wood, 0.006)
        d.box(field.front(-0.003).inset(back=-0.002).place(width=0.14).top(0.24).inset(top=0.1), trim, 0.001)
    room = case.inset(front=board)
    for name, side in (("right", room.right(board)), ("left", room.left(board))):
        with d.part(name):
            d.box(side, wood, 0.001)
    inner = room.inset(y=board)
    with d.part("shelf"):
        d.box(inner.inset(back=0.01).to(z=(middle - board, middle)), wood, 0.001)
    with d.part("desk"):
        d.box(case.top(board), wood, 0.001)
        (x0, x1), high = box.x, box.z[1]
        slope = ((x0, low), (x0, low + 0.03), (x1 - 0.06, high), (x1, high), (x1, low))
        d.hull([(x, y, z) for x, z in slope for y in box.y], wood)
        with d.at(x0, 0.0, low + 0.03, pitch=-math.atan2(high - low - 0.03, box.depth - 0.06)):
            d.box(Box((0.006, 0.022), (box.y[0] + 0.03, box.y[1] - 0.03), (-0.004, 0.016)), trim, 0.002)
            with d.mirror("y"):
                page = d.box(Box((0.06, 0.3), (0.001, 0.17), (-0.001, 0.004)), "paper", 0.0).top(0.0)
                for line in page.inset(x=0.03, y=0.02).split("x", 6, gap=0.028):
                    d.print(line, "grey plastic")
    for k, (z, end) in enumerate(((0.06, middle - board), (middle, low - board))):
        d.surface(
            f"shelf-{k}", inner.inset(back=0.02, front=0.01, y=0.01).to(z=(z - 0.01, z)), round(end - z - 0.005, 3)
        )
    d.fit()
