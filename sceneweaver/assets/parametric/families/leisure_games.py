"""Tables and machines to play at."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from .small_toys import ball, chessmen

BALLS = [f"{tone} plastic" for tone in ("yellow", "blue", "red", "lilac", "orange", "green", "pink", "black")]


@draws("pool_table", whole=True)
def pool_table(d: Drawing) -> None:
    """Cloth between cushions and wooden rails, six pockets, balls, cue, heavy legs."""
    wood = d.material("rails", "mahogany, walnut, black paint, oak, cherry")
    cloth = d.material("cloth", "green paint, green fabric, blue fabric, red fabric, green fabric")
    box = d.bounds
    high, level = box.height, box.height - 0.045
    with d.part("bed"):
        d.box(box.inset(x=0.04, y=0.04).to(z=(high - 0.24, level - 0.03)), wood, 0.01)
        field = d.box(box.inset(x=0.13, y=0.13).to(z=(level - 0.03, level)), cloth, 0.0)
        for rail in box.top(0.12).walls(0.13):
            d.box(rail, wood, 0.015)
        nose = field.top(-0.041).inset(bottom=-0.001)
        for side in (nose.front(0.045), nose.back(0.045)):
            for half in side.inset(y=0.06).columns(2, gap=0.14):
                d.box(half, cloth, 0.01)
        for side in (nose.left(0.045), nose.right(0.045)):
            d.box(side.inset(x=0.06), cloth, 0.01)
        for sx in (-1, 1):
            for sy in (-1, 0, 1):
                at = (sx * (field.x[1] - 0.015 + 0.05 * (sy == 0)), sy * (field.y[1] - 0.015), high - 0.01)
                for r, tall, look in ((0.062, 0.024, "black leather"), (0.045, 0.0254, "black plastic")):
                    d.cylinder(Box.around(at, 2 * r, 2 * r, tall), look, segments=20)
            for k in (-3, -2, -1, 1, 2, 3):
                x, y = sx * (box.x[1] - 0.06), k * box.y[1] / 4
                d.print(Box.around((x, y, high), 0.018, 0.018, 0.0), "chalk pigment", oval=True)
        r, y = 0.028, box.y[1]
        rack = [((k - row / 2) * 2 * r, 0.36 * y + row * 1.75 * r) for row in range(5) for k in range(row + 1)]
        for n, (px, py) in enumerate(rack):
            ball(d, (px, py, level + r), r, BALLS[n % 8], 10)
        ball(d, (0.05, -0.5 * y, level + r), r, "white plastic", 10)
        d.bar((0.16, -0.85 * y, high + 0.012), (0.09, -0.02 * y, level + 0.03), 0.01, "light oak", 8)
    turned = d.pick("legs", ["block", "turned"]) == "turned"
    leg = [(0.6, 0), (0.7, 0.08), (0.45, 0.17), (0.9, 0.5), (0.75, 0.7), (0.5, 0.77), (1, 1)]
    for k, (sx, sy) in enumerate(((-1, -1), (-1, 1), (1, -1), (1, 1))):
        with d.part(f"leg {k}"):
            post = Box.sized(0.2, 0.2, high - 0.22, (sx * (box.x[1] - 0.16), sy * (box.y[1] - 0.2), 0.0))
            if turned:
                d.turned(post, leg, wood, 16)
            else:
                d.sections(post, [(0.6, 0.6, 0), (1, 1, 1)], wood, 0.06)


@draws("table_football", whole=True)
def table_football(d: Drawing) -> None:
    """A box with a green field, eight rods with men in two colours, goals and handles."""
    wood = d.material("case", "walnut, black paint, light oak, grey paint, mahogany")
    pairs = [("red", "blue"), ("yellow", "black"), ("white", "red")]
    teams = [f"{tone} plastic" for tone in d.pick("teams", pairs)]
    deep, wide, high = d.size
    level = high - 0.22
    case = d.bounds.place(0.74)
    with d.part("case"):
        field = d.box(case.to(z=(level - 0.03, level)), wood, 0.004).top(0.0)
        d.print(field.inset(x=0.02, y=0.02), "green fabric")
        d.print(field.inset(x=0.02).place(width=0.01), "white plastic", 0.0004)
        for wall in case.to(z=(level - 0.05, high - 0.01)).walls(0.03):
            d.box(wall, wood, 0.004)
        for s, team in ((-1, teams[0]), (1, teams[1])):
            d.print(Box.sized(0.2, 0.0, 0.09, (0, s * (wide / 2 - 0.03), level)), "black plastic")
            rail = Box.sized(0.36, 0.012, 0.01, (0, s * (wide / 2 - 0.07), high - 0.02))
            d.box(rail, "black steel", 0.0)
            for bead in rail.top(-0.01).inset(bottom=-0.002, x=0.02).split("x", 6, gap=0.015):  # the score
                d.box(bead.inset(y=0.002), team, 0.002)
        rods = case.inset(y=0.08).to(z=(level + 0.115, level + 0.115)).columns(8)
        for k, (rod, count) in enumerate(zip(rods, (1, 2, 3, 5, 5, 3, 2, 1), strict=True)):
            (_, y, z), mine = rod.center, (0, 0, 1, 0, 1, 0, 1, 1)[k]
            push, way = d.uniform(f"rod {k}", -0.08, 0.08), 1 - 2 * mine
            d.bar((-way * 0.51 + push, y, z), (way * deep / 2, y, z), 0.008, "chrome", 6)
            d.bar((way * deep / 2, y, z), (way * (deep / 2 - 0.12), y, z), 0.017, "black plastic", 8)
            for m in range(count):
                x = (m - (count - 1) / 2) * 0.6 / max(2, count) + 0.5 * push
                man = Box.sized(0.04, 0.028, 0.12, (x, y, z - 0.09))
                d.silhouette(man, [(0.2, 0), (0.8, 0), (1, 0.7), (1, 1), (0, 1), (0, 0.7)], teams[mine])
                ball(d, (x, y, z + 0.044), (0.014, 0.014, 0.017), "skin tone", 8)
        ball(d, (0.05, 0.02, level + 0.017), 0.017, "white plastic", 10)
    for s in (-1, 1):
        with d.part(f"legs {s}"), d.at(y=s * (wide / 2 - 0.1)):
            for x in (-0.31, 0.31):
                d.box(Box.sized(0.1, 0.1, level - 0.03, (x, 0, 0.03)), wood, 0.006)
                d.cylinder(Box.sized(0.06, 0.06, 0.03, (x, 0, 0)), "rubber", segments=12)
            d.box(Box.sized(0.54, 0.04, 0.1, (0, 0, 0.2)), wood, 0.004)


@draws("table_tennis", whole=True)
def table_tennis(d: Drawing) -> None:
    """Two blue or green halves with white lines, a net, bats and a ball; the players stand left and right."""
    look = d.material("top", "blue paint, green paint, navy paint")
    metal = d.material("legs", "black steel, white steel, steel")
    deep, wide, high = d.size
    level, x = high - 0.1525, 0.7625  # of the sport's rules
    post = 0.02 * np.array([(1, -1), (1, 1), (-1, 1), (-1, -1)])
    with d.part("top"):
        for half in Box.sized(2 * x, wide, 0.022, (0, 0, level - 0.022)).columns(2, gap=0.004):
            top = d.box(half, look, 0.0).top(0.0)
            d.box(half.inset(x=0.03, y=0.03).bottom(-0.043).inset(top=-0.002), metal, 0.004)
            end = top.left(0.02) if half.y[0] > 0 else top.right(0.02)
            for line in (top.front(0.02), top.back(0.02), top.place(0.006), end):
                d.print(line, "white plastic")
        for s, tone in ((-1, "red plastic"), (1, "black plastic")):
            with d.at(0.3 * s, 0.32 * s * wide, level, yaw=0.6 * s):
                d.cylinder(Box.sized(0.156, 0.156, 0.014, (0, 0, 0.001)), tone, segments=20)
                d.box(Box((-0.17, -0.06), (-0.013, 0.013), (0.001, 0.02)), "light oak", 0.005)
        ball(d, (0.1, -0.2 * wide, level + 0.02), 0.02, "orange plastic", 10)
    with d.part("net"):
        net = Box((0.01 - deep / 2, deep / 2 - 0.01), (-0.002, 0.002), (level + 0.01, high))
        d.box(net.inset(top=0.015), "sheer fabric", 0.0)
        d.box(net.inset(y=-0.002).top(0.015), "white fabric", 0.0)
        with d.mirror("x"):
            d.box(Box.sized(0.02, 0.02, high - level + 0.05, (deep / 2 - 0.01, 0, level - 0.05)), metal)
            d.box(Box((x - 0.05, deep / 2), (-0.03, 0.03), (level - 0.05, level - 0.022)), metal)
    for s in (-1, 1):
        with d.part(f"legs {s}"):
            with d.mirror("x"):
                at = x - 0.14
                d.bar((at, 0.42 * s, level - 0.05), (at, 0.3 * s, 0.06), post, metal)
                d.bar((at, s * (wide / 2 - 0.25), level - 0.05), (at, s * (wide / 2 - 0.3), 0.0), post, metal)
                d.cylinder(Box.around((at, 0.3 * s, 0.05), 0.1, 0.03, 0.1), "black plastic", "y", segments=16)
            d.box(Box.sized(2 * x - 0.28, 0.04, 0.04, (0, 0.3 * s, 0.12)), metal)


@draws("air_hockey", whole=True)
def air_hockey(d: Drawing) -> None:
    """A white rink with rounded rails, red and blue lines, goals, strikers and a puck."""
    case = d.material("case", "black paint, blue paint, red paint, navy paint")
    box = d.bounds
    level, y = box.height - 0.05, box.y[1]
    with d.part("top"):
        rink = d.box(box.inset(x=0.05, y=0.05).to(z=(level - 0.16, level)), "white plastic", 0.0).top(0.0).inset(x=0.04)
        d.box(box.inset(x=0.03, y=0.03).to(z=(level - 0.2, level - 0.02)), case, 0.01)
        for rail in box.to(z=(level - 0.08, box.height)).walls(0.09):
            d.box(rail, case, 0.02)
        d.print(rink.place(width=0.012), "red plastic")
        for size, tone, proud in ((0.32, "red plastic", 0.0003), (0.3, "white plastic", 0.0004)):
            d.print(rink.place(size, size), tone, proud, oval=True)
        for s in (-1, 1):
            d.print(Box.sized(0.34, 0.0, 0.028, (0, s * (y - 0.09), level)), "black plastic")
            d.print(rink.place(width=0.012).move(y=0.35 * s * y), "blue plastic")
            striker = Box.sized(0.096, 0.096, 0.05, (0.12 * s, 0.6 * s * y, level))
            d.turned(striker, [(1, 0), (1, 0.3), (0.9, 0.4), (0.42, 0.42), (0.42, 0.9), (0.3, 1)], "red plastic")
        d.cylinder(Box.sized(0.064, 0.064, 0.008, (-0.1, 0.12 * y, level)), "green plastic", segments=20)
    for s in (-1, 1):
        with d.part(f"leg {s}"), d.at(y=s * (y - 0.3)):
            d.box(Box(box.inset(x=0.14).x, (-0.08, 0.08), (0.05, level - 0.18)), case, 0.015)
            d.box(Box(box.inset(x=0.06).x, (-0.12, 0.12), (0.0, 0.06)), "black plastic", 0.01)


@draws("arcade_machine", whole=True)
def arcade_machine(d: Drawing) -> None:
    """Shaped side panels, lit marquee, slanted screen, control panel with sticks and buttons, coin door."""
    case = d.material("sides", "black paint, red paint, blue paint, yellow paint, teal paint")
    trim = d.material("trim", "yellow plastic, red plastic, blue plastic, orange plastic")
    box = d.bounds
    (x0, x1), high = box.x, box.height
    k, i = high / 1.75, box.width / 2 - 0.02
    front = [(0.1, 0), (0.1, 0.75), (0, 0.88), (0, 0.98), (0.26, 1.05), (0.36, 1.45), (0.1, 1.52)]
    shape = [(x0, 0), *((x1 - x, z * k) for x, z in front), (x1 - 0.1, high), (x0 + 0.12, high), (x0, high - 0.25)]
    metres = Box((0, 1), (-i, i), (0, 1))  # shares of it are metres
    for side in (box.left(0.025), box.right(0.025)):
        d.silhouette(metres.to(y=side.y), shape, case)
        outer = side.y[1] if side.y[1] > 0 else side.y[0]
        for stripe in Box((x0 + 0.05, x1 - 0.15), (outer, outer), (0.25 * k, 0.46 * k)).rows(3):
            d.print(stripe.share(z=(0.0, 0.5)), trim)

    def block(xs: tuple[float, float], zs: tuple[float, float], look, inset: float = 0.0) -> Box:
        return d.box(Box(xs, (inset - i, i - inset), zs), look, 0.004)

    block((x0 + 0.02, x1 - 0.13), (0.02, 0.8 * k), "black plastic")
    block((x0 + 0.02, x1 - 0.42), (0.7 * k, high - 0.26), "black plastic")
    block((x0 + 0.12, x1 - 0.12), (1.5 * k, high - 0.01), "black plastic")
    marquee = block((x1 - 0.14, x1 - 0.11), (1.54 * k, high - 0.02), "lit shade", 0.02)
    d.print(marquee.front(0.0).share(y=(0.15, 0.85), z=(0.3, 0.7)), trim)
    panel = [(-0.42, 0.8), (-0.14, 0.8), (-0.03, 0.9), (-0.03, 0.945), (-0.29, 1.02), (-0.42, 1.02)]
    glass = [(-0.44, 1.0), (-0.3, 1.03), (-0.4, 1.43), (-0.44, 1.43)]
    for outline, look in ((panel, trim), (glass, "black glass")):
        d.silhouette(metres, [(x1 + x, z * k) for x, z in outline], look)
    with d.at(x1 - 0.3, 0.0, 1.035 * k, pitch=-0.245):
        screen = d.box(Box((-0.03, 0.004), (0.05 - i, i - 0.05), (0.05, 0.36 * k)), "screen", 0.004).front(0.0)
        for row, tone in zip(screen.share(y=(0.2, 0.8), z=(0.45, 0.85)).rows(4), BALLS, strict=False):
            for cell in row.columns(6):
                d.print(cell.share(y=(0.2, 0.75), z=(0.2, 0.7)), tone)
        d.print(screen.share(y=(0.42, 0.58), z=(0.1, 0.14)), "white plastic")
    for s, tone in ((-1, "red plastic"), (1, "blue plastic")):
        with d.at(x1 - 0.16, 0.22 * s * box.width, 0.9825 * k, pitch=math.atan2(0.075 * k, 0.26)):
            d.bar((0, -0.08, -0.003), (0, -0.08, 0.055), 0.007, "steel", 8)
            ball(d, (0, -0.08, 0.065), 0.02, tone, 10)
            with d.grid(Box((-0.04, 0.04), (-0.0275, 0.0775), (-0.005, 0.011)), x=2, y=3):
                d.cylinder(Box.sized(0.026, 0.026, 0.016), tone, segments=10)
    coins = d.box(Box((x1 - 0.14, x1 - 0.115), (-0.13, 0.13), (0.25 * k, 0.62 * k)), "black steel", 0.004).front(0.0)
    for y in (0.27, 0.73):
        d.print(coins.share(y=(y - 0.06, y + 0.06), z=(0.54, 0.73)), "orange plastic")


@draws("pinball_machine", whole=True)
def pinball_machine(d: Drawing) -> None:
    """A sloping glazed playfield on steel legs with a lit back box."""
    case = d.material("case", "black paint, red paint, blue paint, navy paint")
    box = d.bounds
    deep, wide, high = box.size
    (x0, x1), y = box.x, 0.4 * wide
    i, slope = y - 0.03, math.atan2(0.18, deep - 0.05)
    long = (deep - 0.05) / math.cos(slope)
    with d.part("table"):
        for s in (-1, 1):
            plank = Box((x0 + 0.05, x1), (y - 0.03, y) if s > 0 else (-y, 0.03 - y), (0.6, 1.05))
            d.silhouette(plank, [(0, 0.18), (1, 0), (1, 0.6), (0, 1)], case)
            face = plank.left(0.0) if s > 0 else plank.right(0.0)
            d.print(face.inset(x=0.15).to(z=(0.72, 0.78)), "yellow plastic")
            d.print(face.inset(back=0.25, front=0.4).to(z=(0.8, 0.84)), "orange plastic")
        with d.at(x1, 0.0, 0.87, pitch=slope):
            d.box(Box((-long, 0), (-i, i), (-0.2, -0.05)), "navy paint", 0.0)
            d.box(Box((-long, 0), (-i, i), (-0.004, 0.0)), "glass", 0.0)
            with d.at(z=-0.05):

                def disc(share: float, py: float, r: float, z: tuple[float, float], look: str) -> None:
                    d.cylinder(Box.sized(2 * r, 2 * r, z[1] - z[0], (-share * long, py, z[0])), look, segments=16)

                disc(0.2, 0.0, 0.1, (0.0, 0.0025), "yellow plastic")
                for share, py, tone in ((0.6, -0.1, "red"), (0.62, 0.1, "green"), (0.72, 0.0, "orange")):
                    disc(share, py, 0.045, (0.0, 0.04), "white plastic")
                    disc(share, py, 0.05, (0.03, 0.042), f"{tone} plastic")
                lights = [(0.4, -0.14, "red"), (0.42, 0.15, "blue"), (0.85, -0.12, "blue"), (0.84, 0.13, "yellow")]
                for share, py, tone in [*lights, (0.33, 0.0, "red"), (0.5, 0.0, "green")]:
                    disc(share, py, 0.022, (0.0, 0.004), f"{tone} plastic")
                with d.mirror("y"):
                    with d.at(-0.14 * long, 0.1, yaw=1.0):
                        d.box(Box((-0.01, 0.01), (-0.08, 0.0), (0.0, 0.02)), "white plastic", 0.004)
                    d.bar((-0.25 * long, 0.2, 0.01), (-0.17 * long, 0.11, 0.01), 0.008, "red plastic", 6)
        front = Box((x1 - 0.03, x1), (-y, y), (0.6, 0.86))
        d.box(front, case)
        d.box(front.inset(y=-0.004, back=0.01, front=-0.008).to(z=(0.82, 0.885)), "chrome", 0.006)
        d.box(front.front(0.01).inset(front=-0.006).place(width=0.24).to(z=(0.64, 0.8)), "black steel")
        d.bar((x1, y - 0.1, 0.75), (x1 + 0.03, y - 0.1, 0.75), 0.012, "chrome")
        d.box(Box((x0 + 0.05, x1 - 0.03), (-y, y), (0.66, 0.68)), case, 0.0)
    with d.part("back box"):
        head = d.box(box.back(0.26).to(z=(1.08, high)), case, 0.008)
        d.box(Box((x0 + 0.03, x0 + 0.2), (0.05 - y, y - 0.05), (0.9, 1.1)), case, 0.0)
        sign = d.box(head.front(0.005).inset(front=-0.004, y=0.03).to(z=(1.3, high - 0.04)), "lit shade", 0.002)
        at = (sign.x[1], 0.0, sign.center[2])
        for r, tone, out in ((0.19, "red plastic", 0.002), (0.14, "yellow plastic", 0.003)):
            d.cylinder(Box.around(at, 2 * out, 2 * r, 2 * r), tone, "x", segments=28)
        d.silhouette(Box.around(at, 0.008, 0.22, 0.21).move(z=0.025), [(0, 0), (1, 0), (0.5, 1)], "blue plastic", "x")
        score = d.box(head.front(0.005).inset(front=-0.002, y=0.06).to(z=(1.13, 1.25)), "black glass", 0.002).front(0.0)
        for digit in score.share(y=(0.1, 0.9), z=(0.3, 0.7)).columns(4):
            d.print(digit.share(y=(0.2, 0.8)), "orange plastic")
    for name, x, top in (("back", x0 + 0.08, 0.72), ("front", x1 - 0.02, 0.68)):
        with d.part(f"legs {name}"):
            for s in (-1, 1):
                leg = Box.sized(0.056, 0.056, top - 0.02, (x, s * (y + 0.01), 0.02))
                d.sections(leg, [(0.64, 0.64, 0), (1, 1, 1)], "chrome", 0.05)
                d.cylinder(leg.bottom(-0.02).inset(x=0.003, y=0.003, top=-0.004), "black plastic", segments=12)


@draws("dartboard")
def dartboard(d: Drawing) -> None:
    """Twenty black and cream sectors with red and green rings and a bull."""
    deep, _, high = d.size
    r, x = high / 2, deep - 0.012
    with d.part("board"), d.at(z=r):
        d.cylinder(Box((0, x), (-r, r), (-r, r)), "black plastic", "x", segments=40)
        face = Box((x, x), (0, 0), (0, 0))
        for k in range(20):
            a = (k - 0.5) * math.pi / 10 + np.array([0.0, math.pi / 10])
            plain, ring = (("black plastic", "red plastic"), ("beige fabric", "green plastic"))[1 - k % 2]
            for low, top, look in ((0.07, 0.42, plain), (0.42, 0.47, ring), (0.47, 0.7, plain), (0.7, 0.755, ring)):
                if look == "black plastic":
                    continue
                rim = [(q * r * math.sin(t), q * r * math.cos(t)) for q in (low, top) for t in a]
                d.hull([(px, *p) for p in rim for px in (x - 0.002, x + 0.0005)], look)
            turn = k * math.pi / 10
            number = face.move(y=0.87 * r * math.sin(turn), z=0.87 * r * math.cos(turn))
            d.print(number.inset(y=-0.006, z=-0.01), "white plastic")
        for share, look, proud in ((0.07, "green plastic", 0.0005), (0.032, "red plastic", 0.001)):
            d.cylinder(Box.around((x, 0, 0), 2 * proud, 2 * share * r, 2 * share * r), look, "x", segments=16)
        d.hoop(Box.around((x - 0.002, 0, 0), 0, 1.97 * r, 1.97 * r), 0.015 * r, "black steel", "x", steps=32)
        for y, z in ((0.2, 0.3), (-0.1, 0.52), (0.02, -0.1))[: d.integer("darts", 0, 3)]:
            d.bar((x, y * r, z * r), (deep - 0.001, y * r, z * r), 0.003, "brass", 6)
    d.fit((deep, high, high))


@draws("chess_table", whole=True)
def chess_table(d: Drawing) -> None:
    """A pedestal table whose top is a chessboard, with the pieces set up."""
    wood = d.material("wood", "walnut, mahogany, oak, wenge")
    box = d.bounds
    deep, wide, high = box.size
    level, side = high - 0.085, min(deep, wide)
    with d.part("top"):
        top = d.box(box.to(z=(level - 0.04, level)), wood, 0.008).top(0.0)
        cells = [row.columns(8) for row in top.place(0.8 * side, 0.8 * side).split("x", 8)]
        for i, row in enumerate(cells):
            for j, cell in enumerate(row):
                d.print(cell, "birch" if (i + j) % 2 else "wenge")
        chessmen(d, list(zip(*cells, strict=True)), 0.085, "cream paint", "black paint", False)
    with d.part("foot"):
        stem = Box.sized(0.16, 0.16, level - 0.12, (0, 0, 0.08))
        d.turned(stem, [(0.62, 0), (0.56, 0.1), (0.94, 0.3), (0.5, 0.45), (0.5, 0.86), (0.9, 0.93), (1, 1)], wood, 20)
        leg = [(0.0, 0.5), (0.54, 0.15), (0.95, 0.0), (1.0, 0.15), (0.56, 0.45), (0.0, 1.0)]
        with d.ring(4, 0.0, math.pi / 4):
            d.silhouette(Box((0.03, 0.44 * side), (-0.02, 0.02), (0.0, 0.2)), leg, wood)
    for knees in (box.inset(left=wide / 2 + 0.2), box.inset(right=wide / 2 + 0.2)):
        d.clear(knees.to(z=(0.1, level - 0.05)))


@draws("poker_table", whole=True)
def poker_table(d: Drawing) -> None:
    """An oval of green felt with a padded rim, chips and cards, on two pedestals."""
    wood = d.material("wood", "mahogany, walnut, black paint")
    felt = d.material("felt", "green fabric, red fabric, navy fabric")
    box = d.bounds
    level, (_, x), (_, y) = box.height - 0.025, box.x, box.y

    def stadium(inset: float) -> np.ndarray:
        """Straight sides along y with round ends."""
        t = np.linspace(-math.pi / 2, math.pi / 2, 14)
        end = np.c_[-(x - inset) * np.sin(t), y - x + (x - inset) * np.cos(t)]
        return np.concatenate([end, -end])

    with d.part("top"):
        d.extrude(stadium(0.05), (level - 0.06, level - 0.02), wood)
        d.extrude(stadium(0.1), (level - 0.025, level), felt)
        a = (np.arange(8) + 0.5) * math.pi / 4
        rim = np.c_[stadium(0.06), np.full(28, level - 0.004)]
        d.sweep(rim, np.c_[0.06 * np.cos(a), 0.03 * np.sin(a)], "black leather", closed=True)
        tones = ("red", "blue", "white", "green", "black")
        for j in range(4):
            px, py = (x - 0.32) * math.cos(1.57 * j + 0.5), (y - 0.35) * math.sin(1.57 * j + 0.5)
            for k, tone in enumerate(tones):
                at = (px + 0.045 * (k % 3), py + 0.045 * (k // 3), level)
                d.cylinder(Box.sized(0.04, 0.04, 0.024 + 0.008 * k, at), f"{tone} plastic", segments=12)
        for k, card in enumerate(Box.sized(0.09, 0.4, 0.001, (0.015, 0, level)).columns(5, gap=0.017)):
            d.box(card, "paper", 0.0)
            d.print(card.top(0.0).share((0.35, 0.6), (0.3, 0.7)), "red plastic" if k % 2 else "black plastic")
    for s in (-1, 1):
        with d.part(f"foot {s}"):
            at = (0.0, s * (y - 0.75 * x), 0.0)
            d.box(Box.sized(2 * x - 0.4, 0.12, 0.08, at), wood, 0.012)
            stem = Box.sized(0.22, 0.22, level - 0.14, at).move(z=0.08)
            d.turned(stem, [(0.82, 0), (0.55, 0.13), (0.77, 0.55), (0.64, 0.87), (1, 1)], wood, 20)
