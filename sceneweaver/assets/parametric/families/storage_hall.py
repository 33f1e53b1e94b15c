"""Of the hall: racks and stands for coats, shoes, umbrellas and papers."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import leg, walls
from ...drawing.drawing import Look
from .small_parts import BARE

WOODS = ("oak", "walnut", "white paint", "black paint", "beech", "light oak")
COVERS = ("paper", "red plastic", "blue plastic", "yellow plastic", "sea pigment", "blush pigment")


@draws("coat_rack")
def coat_rack(d: Drawing) -> None:
    """A pole on a foot with arms that curve up and out around its head."""
    frame = d.material("frame", "walnut", "oak", "black steel", "white paint", "beech", "brass")
    tips = d.material("tips", "brass", "black steel", "oak") if d.chance("tips", 0.4) else frame
    top, pole, arms = d.size.height, 0.019, d.pick("arms", [4, 6, 8])
    reach = min(d.size[:2]) / 2
    with d.part("foot"):
        if d.chance("disc", 0.4):
            d.revolve([(0.75 * reach, 0.0), (0.75 * reach, 0.012), (0.05, 0.03), (pole, 0.06)], frame, 32)
        else:
            curve = ((0.0, 0.19), (0.45, 0.13), (0.8, 0.05), (0.9, 0.013))
            with d.ring(4, 0.0, math.pi / 4):
                d.sweep([(share * reach, 0, z) for share, z in curve], 0.013, frame)
    with d.part("pole"):
        head = ((1.0, 0.09), (1.25, 0.085), (1.25, 0.07), (0.7, 0.06), (1.15, 0.03), (0.3, 0.0))
        d.revolve([(pole, 0.02), *((share * pole, top - below) for share, below in head)], frame, 20)
    with d.part("arms"):
        for start, below in ((0.0, 0.14), (2 * math.pi / arms, 0.32)):
            curve = ((0.0, -0.08), (0.5, -0.07), (0.85, -0.02), (0.95, 0.05))
            with d.ring(arms // 2, 0.0, start):
                d.sweep([(share * reach, 0, top - below + z) for share, z in curve], 0.009, frame, 8)
                d.ball(Box.around((0.95 * reach, 0.0, top - below + 0.055), 0.03, 0.03, 0.03), tips, 12)
    d.fit()


@draws("clothes_rack")
def clothes_rack(d: Drawing) -> None:
    """Two posts and a rail over a low shelf, sometimes clothes on hangers."""
    metal = d.material("frame", "black steel", "chrome", "white steel", "oak", "walnut")
    wood = d.material("shelf", "oak", "walnut", "white paint", "pine")
    radius, bounds = 0.014, d.bounds
    wheeled = d.chance("castors", 0.5)
    low = 0.055 if wheeled else 0.0
    foot = bounds.inset(bottom=low).bottom(0.032)
    with d.part("foot"):
        with d.mirror("y"):
            bar = d.box(foot.left(0.032).move(y=-0.034), metal)
            for end in (bar.back(0.06), bar.front(0.06)) if wheeled else ():
                d.cylinder(Box.sized(0.055, 0.024, 0.055, (*end.center[:2], 0.0)), "black plastic", "y", segments=14)
        board = d.box(foot.inset(x=0.08, y=0.034).bottom(0.018).move(z=0.08), wood)
    y, rail = bounds.y[1] - 0.05, bounds.z[1] - radius
    for k, side in enumerate((-y, y)):
        with d.part(f"upright-{k}"):
            d.bar((0, side, foot.z[0]), (0, side, rail), radius, metal, 12)
    with d.part("rail"):
        d.bar((0, bounds.y[0], rail), (0, bounds.y[1], rail), radius, metal, 12)
        if d.request.shape != BARE and d.chance("clothes", 0.65):
            _clothes(d, min(bounds.depth / 2 - 0.005, 0.21), y, rail)
    d.surface("shelf", board, 0.25, inset=0.03)


def _clothes(d: Drawing, half: float, y: float, rail: float) -> None:
    """Some garments that fall in folds from hangers over a rail along y; they are up to ``half`` wide to each side."""
    dyes = ["grey fabric", "navy fabric", "beige fabric", "rust fabric", "green fabric", "white fabric", "rose fabric"]
    for k in range(d.integer("garments", 4, 8)):
        at = (d.uniform(f"at {k}", -0.06, 0.06) + k * 0.1 - 0.35) * 1.7 * y
        wide, long = half * d.uniform(f"wide {k}", 0.88, 1.0), d.uniform(f"long {k}", 0.62, 0.95)
        top, phase = rail - 0.075, d.uniform(f"fold {k}", 0.0, 6.3)
        across = np.linspace(-1.0, 1.0, 13)
        shoulder = 0.1 * np.clip((np.abs(across) - 0.25) / 0.75, 0, 1)
        rows = []
        for share in (0.0, 0.25, 0.6, 1.0):
            fold = 0.008 * share**0.7 * np.sin(9 * across + phase)
            x = wide * across * (1 - 0.12 * math.sin(math.pi * share))
            rows.append(np.c_[x, at + fold, top - shoulder * (1 - share) - long * share])
        d.sheet(np.array(rows), 0.03, d.pick(f"dye {k}", dyes), (1, 4))
        d.bar((0, at, top - 0.005), (0, at, rail + 0.005), 0.003, "chrome", 6)


@draws("hall_stand")
def hall_stand(d: Drawing) -> None:
    """A bench for shoes, a panel with hooks and mirror above it, a hat shelf on top."""
    wood = d.material("body", "oak", "walnut", "white paint", "pine", "sage paint", "ash grey wood")
    metal = d.material("hooks", "black steel", "brass", "bronze")
    bounds, board = d.bounds, 0.022
    bench, wall = bounds.to(z=(0.0, 0.46)), bounds.inset(bottom=0.46)
    box = bench.inset(y=board, top=0.025)
    for k, side in enumerate((bench.right(board), bench.left(board))):
        with d.part(f"side-{k}"):
            d.box(side.inset(front=0.01, top=0.025), wood)
    with d.part("shelf"):
        shelf = d.box(box.inset(front=0.02).bottom(0.12).top(0.02), wood)
        d.box(box.inset(front=0.05).bottom(0.1).front(0.02), wood, bevel=0.0)
    with d.part("seat"):
        d.box(bench.top(0.025), wood, bevel=0.004)
    with d.part("back"):
        d.box(box.inset(bottom=0.12).back(0.018), wood, bevel=0.0)
    with d.part("panel"):
        for post in (wall.right(0.06), wall.left(0.06)):
            d.box(post.back(0.03), wood)
        field = wall.inset(y=0.06)
        d.box(field.back(0.012), wood, bevel=0.0)
        tongue = field.inset(back=0.012, top=0.03).back(0.006)
        for strip in tongue.columns(max(4, round(field.width / 0.11)), gap=0.006):
            d.box(strip, wood, bevel=0.002)
        rail = d.box(field.inset(back=0.018).back(0.012).top(0.36).bottom(0.1), wood)
        if d.chance("mirror", 0.5):
            half = min(0.2, 0.28 * bounds.width)
            frame = tongue.front(-0.01).inset(bottom=0.22, top=0.40).place(width=2 * half + 0.05)
            d.box(frame, wood)
            d.box(frame.inset(y=0.025, z=0.025).front(-0.003), "mirror", bevel=0.0)
    with d.part("hooks"):
        for place in bounds.columns(max(3, round(bounds.width / 0.2))):
            with d.at(rail.x[1], place.center[1], rail.z[0] + 0.04):
                d.sweep([(0, 0, 0), (0.036, 0, -0.015), (0.06, 0, 0.01), (0.06, 0, 0.045)], 0.006, metal, 8)
                d.ball(Box.around((0.06, 0.0, 0.05), 0.022, 0.022, 0.022), metal, 10)
    with d.part("hat shelf"):
        hats = d.box(wall.inset(back=0.03).back(min(0.3, 0.75 * bounds.depth) - 0.03).top(0.19).bottom(board), wood)
    d.surface("shoes", shelf.inset(back=0.02), round(box.z[1] - shelf.z[1] - 0.004, 4), inset=0.005)
    d.surface("seat", bench.inset(back=0.1), 0.7, inset=0.01)
    d.surface("hats", hats, inset=0.01)


@draws("shoe_rack")
def shoe_rack(d: Drawing) -> None:
    """Two to four tiers of slats between ladder sides."""
    frame = d.material("frame", "bamboo", "oak", "black steel", "walnut", "white paint")
    slat = d.material("boards", "bamboo", "oak", "pine", "walnut") if d.chance("two", 0.4) else frame
    post, bounds = 0.026, d.bounds
    tiers = max(2, min(4, round(bounds.height / 0.23)))
    for k, side in enumerate((bounds.right(post), bounds.left(post))):
        with d.part(f"side-{k}"):
            for own in (side.back(post), side.front(post)):
                d.box(own, frame)
            rung = side.inset(x=post, y=0.004)
            for z in ((bounds.z[1] - 0.03, bounds.z[1] - 0.002), (0.07, 0.098)):
                d.box(rung.to(z=z), frame)
    levels = np.linspace(0.1, bounds.z[1] - 0.002, tiers).tolist()
    for k, z in enumerate(levels):
        tier = bounds.inset(x=0.002, y=post).to(z=(z - 0.012, z))
        with d.part(f"tier-{k}"):
            d.box(tier.inset(x=0.028, bottom=-0.004, top=0.001), slat, bevel=0.0)
            for own in tier.split("x", 5, gap=0.003):
                d.box(own, slat, bevel=0.001)
        name, room = ("top", None) if k == tiers - 1 else (f"shelf-{k}", round(levels[k + 1] - 0.019 - z, 4))
        d.surface(name, tier, room, inset=0.006)


@draws("umbrella_stand")
def umbrella_stand(d: Drawing) -> None:
    """A tall open vessel with umbrellas in it."""
    body = d.material("body", "black steel", "brass", "white ceramic", "wicker", "copper", "blue ceramic")
    top, radius, rim = d.size.height, min(d.size[:2]) / 2, 0.52 + 0.06 * d.uniform("tall", -1, 1)
    with d.part("body"):
        pot = Box.sized(2 * radius, 2 * radius, rim)
        if d.chance("round body", 0.6):
            profile = ((0.86, 0.0), (0.9, 0.04), (0.84, 0.09), (0.9, 0.945), (1.0, 0.97), (1.0, 1.0))
            d.turned(pot, profile, body, 28)
            d.cylinder(pot.inset(x=0.12 * radius, y=0.12 * radius).top(-0.0005), "black paint")
        else:
            wall = 0.012
            walls(d, pot, body, wall, 0.001)
            d.box(pot.inset(x=wall, y=wall, top=0.1), "black paint", bevel=0.0)
        count = d.integer("umbrellas", 2, 3)
        for k in range(count):
            cloth = d.pick(f"cloth {k}", [f"{dye} fabric" for dye in ("black", "navy", "red", "green", "mustard")])
            grip = d.pick(f"grip {k}", ["walnut", "beech", "black plastic"])
            with d.at(yaw=2 * math.pi * k / count + 0.6):
                _umbrella(d, radius, rim - 0.05, top - 0.03 * k, cloth, grip)
    d.fit()


def _umbrella(d: Drawing, radius: float, low: float, high: float, cloth: Look, grip: Look) -> None:
    """A rolled umbrella that leans outward, from the rim of a stand of a radius up to its crook."""
    long, out = high - low, 0.15 * radius
    with d.at(0.42 * radius, 0.0, low, pitch=math.atan2(out, long)):
        d.cylinder(Box.sized(0.06, 0.06, 0.5 * long), cloth, ends=(1.0, 0.47), segments=12)
        d.cylinder(Box.sized(0.012, 0.012, 0.22 * long, (0.0, 0.0, 0.5 * long)), "chrome", segments=8)
    x = 0.42 * radius + out
    turn = np.linspace(0.0, math.pi, 7)
    bend = np.c_[np.full(7, x), 0.028 - 0.028 * np.cos(turn), high - 0.042 + 0.028 * np.sin(turn)]
    d.sweep(np.concatenate([[(x - 0.004, 0.0, low + 0.68 * long)], bend]), 0.01, grip, 8)


@draws("magazine_rack")
def magazine_rack(d: Drawing) -> None:
    """A V of two slatted sides on crossed legs, with magazines between them."""
    wood = d.material("frame", "oak", "walnut", "black steel", "brass", "beech")
    bounds, thick = d.bounds, 0.012
    top, half = bounds.height, bounds.depth / 2
    with d.part("body"):
        floor = d.box(bounds.place(depth=0.1).to(z=(0.075, 0.09)).inset(y=0.02), wood)
        lean = math.atan2(half - thick - 0.04, top - 0.09)
        with d.mirror("x"):
            with d.at(0.04, 0.0, floor.z[1], pitch=lean):
                side = Box((0.0, thick), bounds.y, (0.0, (top - 0.09) / math.cos(lean) - 0.012))
                for rail in (side.bottom(0.04), side.share(z=(0.5, 0.6)), side.top(0.035)):
                    d.box(rail, wood)
                with d.mirror("y"):
                    d.box(side.back(-0.012).inset(left=0.022).left(0.016), wood, bevel=0.001)
            with d.mirror("y"):
                y = bounds.y[1] - 0.03
                leg(d, (half - 0.011, y, 0.0), (0.044, y, 0.09), 0.018, 0.018, wood, sides=4)
        for k in range(d.integer("papers", 4, 6)):
            paper = floor.back(0.008).move(x=0.016 + 0.012 * k).inset(y=0.02 + 0.003 * k)
            high = top + d.uniform(f"high {k}", -0.1, -0.02)
            d.box(paper.to(z=(floor.z[1] + 0.001, high)), d.pick(f"cover {k}", COVERS), bevel=0.001)
    d.fit()


@draws("newspaper_stand")
def newspaper_stand(d: Drawing) -> None:
    """Steps of tilted pockets one over another, papers and magazines in them."""
    frame = d.material("frame", "black steel", "oak", "white steel", "red paint", "walnut")
    bounds, board = d.bounds, 0.016
    (x0, x1), top = bounds.x, bounds.z[1]
    tiers = 3 if top < 1.25 else 4
    inks = ["black paint", "red paint", "navy paint"]
    with d.part("body"):
        outline = ((x0, 0.0), (x1, 0.0), (x1, 0.14), (x0 + 0.07, top), (x0, top))
        for side in (bounds.right(board), bounds.left(board)):
            d.hull([(x, y, z) for x, z in outline for y in side.y], frame)
        for k, tier in enumerate(bounds.inset(y=board, bottom=0.1, top=0.02).rows(tiers)):
            low = tier.z[0]
            front = x1 - 0.03 + (0.1 - bounds.depth) * (low + 0.07) / top
            d.box(Box((x0 + 0.01, front), tier.y, (low - 0.015, low)), frame)
            d.box(Box((front - 0.012, front), tier.y, (low, low + 0.06)), frame)
            with d.at(front - 0.02, 0.0, low, pitch=-0.2):
                d.box(Box((-0.016, -0.008), tier.y, (0.0, 0.93 * tier.height)), frame, bevel=0.0)
                cells = tier.inset(y=0.01).columns(max(2, round(tier.width / 0.26)), gap=0.012)
                for j, cell in enumerate(cells):
                    thick, share = d.uniform(f"thick {k} {j}", 0.004, 0.016), d.uniform(f"high {k} {j}", 0.72, 0.88)
                    paper = Box((-0.008, thick - 0.008), cell.y, (0.003, share * tier.height))
                    d.box(paper, d.pick(f"cover {k} {j}", ("paper", *COVERS)), bevel=0.001)
                    title = paper.front(0.0).inset(y=0.012).share(z=(0.8, 0.92))
                    d.print(title, d.pick(f"title {k} {j}", inks))
                    d.print(paper.front(0.0).inset(y=0.02).share(z=(0.25, 0.72)), d.pick(f"photo {k} {j}", COVERS[3:]))


@draws("room_divider")
def room_divider(d: Drawing) -> None:
    """A folding screen: framed panels in a zigzag, of cloth, paper or slats."""
    wood = d.material("frame", "walnut", "oak", "black paint", "white paint", "bamboo")
    fill = d.material("panels", "paper", "rattan", "white fabric", "green fabric", "frosted glass")
    shoji = d.chance("shoji", 0.5)
    (depth, width, top), thick, post = d.size, 0.022, 0.032
    count = 3 if width < 1.45 else 4
    run, fall = width / count, depth - thick
    turn = math.atan2(fall, run)
    panel = Box.sized(thick, math.hypot(run, fall) - 0.012, top)
    for k in range(count):
        with d.at(0.0, -width / 2 + (k + 0.5) * run, yaw=turn if k % 2 == 0 else -turn), d.part(f"panel-{k}"):
            for side in (panel.right(post), panel.left(post)):
                d.box(side, wood)
            inner = panel.inset(y=post)
            middle = 0.32 * top
            for z in ((0.06, 0.11), (top - 0.045, top - 0.01), (middle, middle + 0.025)):
                d.box(inner.inset(x=0.002).to(z=z), wood, bevel=0.001)
            field = inner.to(z=(0.11, top - 0.045))
            d.box(field.place(depth=0.006), fill, bevel=0.0)
            if shoji:
                d.box(field.place(0.014, 0.012), wood, bevel=0.0)
                for z in np.linspace(middle, field.z[1], 6)[1:-1].tolist():
                    d.box(field.place(depth=0.014).to(z=(z - 0.006, z + 0.006)), wood, bevel=0.0)
    d.fit()
