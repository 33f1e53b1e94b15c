"""Chairs for tables, schools, children; folding and rocking ones."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import leg, legs, slats
from .seating_parts import COVERS, PLASTICS, WOODS, arc_panel, bent


@draws("dining_chair", whole=True)
def dining_chair(d: Drawing) -> None:
    """A wooden frame with a padded or plain seat and a back of slats, ladder, cross, cane or upholstery."""
    wood = d.material("frame", WOODS)
    cover = d.material("cover", COVERS) if d.chance("padded", 0.7) else wood
    style = d.pick("back", ["spindles", "ladder", "cross", "panel", "upholstered", "upholstered"])
    if style == "upholstered" and cover == wood:
        style = "ladder"
    seat, lean, h = d.uniform("seat height", 0.44, 0.47), 0.08, d.size.height
    box = d.bounds.inset(back=lean, front=0.01)
    x, front, y = box.x[0] + 0.02, box.x[1] - 0.03, box.y[1] - 0.02
    inner = y - 0.01
    with d.part("seat"):
        with d.mirror("y"):
            leg(d, (front, y, 0.0), (front, y, seat - 0.02), 0.026, 0.036, wood, 4)
            leg(d, (x - 0.35 * lean, y, 0.0), (x, y, seat - 0.02), 0.028, 0.036, wood, 4)
            d.box(Box((x + 0.01, front - 0.01), (y - 0.009, y + 0.009), (seat - 0.085, seat - 0.02)), wood)
        for at in (x, front):
            d.box(Box((at - 0.009, at + 0.009), (-inner, inner), (seat - 0.085, seat - 0.02)), wood)
        if cover == wood:
            d.box(d.bounds.to(x=(x - 0.005, d.bounds.x[1]), z=(seat - 0.022, seat)), wood, bevel=0.006)
        else:
            pad = d.bounds.to(x=(x - 0.015, d.bounds.x[1]), z=(seat - 0.035, seat + 0.025))
            d.cushion(pad.inset(y=0.003), cover, 0.029)
    with d.part("back"):
        if style == "upholstered":
            angle = math.atan2(lean, h - seat)
            with d.at(x, z=seat - 0.02, pitch=-angle):
                rest = Box((-0.03, 0.03), d.bounds.inset(y=0.005).y, (0.0, (h - seat + 0.02) / math.cos(angle)))
                d.cushion(rest, cover, 0.029)
        else:
            with d.mirror("y"):
                leg(d, (x, y, seat - 0.025), (x - lean, y, h), 0.036, 0.026, wood, 4)
            _back(d, x, inner, seat, lean, style, wood)


def _back(d: Drawing, x: float, inner: float, seat: float, lean: float, style: str, wood: Look) -> None:
    """What is between the posts of a dining chair's back."""
    h = d.size.height

    def at(z: float) -> float:
        return x - lean * (z - seat) / (h - seat)

    def rail(z: float, high: float, bow: float = 0.02) -> None:
        y = np.linspace(-inner, inner, 7)
        path = np.c_[at(z) - bow * (1 - (y / inner) ** 2), y, np.full(7, z)]
        d.sweep(path, (0.018, high), wood)

    rail(h - 0.045, 0.08)
    if style == "spindles":
        low, high = seat + 0.13, h - 0.07
        rail(low, 0.03, 0.012)
        for y in np.linspace(-0.72, 0.72, 5).tolist():
            bow = 1 - y * y
            d.bar((at(low) - 0.012 * bow, y * inner, low), (at(high) - 0.02 * bow, y * inner, high), 0.007, wood, 8)
    elif style == "ladder":
        for k in range(1, 3 if h < 0.92 else 4):
            rail(h - 0.045 - 0.115 * k, 0.055)
    elif style == "cross":
        low, high = seat + 0.1, h - 0.08
        rail(low, 0.03, 0.0)
        for s in (-1, 1):
            d.bar((at(low), -s * inner, low), (at(high) - 0.004, 0.95 * s * inner, high), 0.009, wood, segments=8)
    else:
        weave = d.material("cane", "rattan, wicker") if d.chance("cane", 0.5) else wood
        low, high = seat + 0.1, h - 0.07
        rows = [(at(z) - 0.018, z, inner, 0.018, 0.0) for z in (low, high)]
        d.sheet(bent(rows).swapaxes(0, 1), 0.012, weave, (3, 1))


@draws("chair", whole=True)
def chair(d: Drawing) -> None:
    """A moulded shell on wooden, wire or tube legs, a bent-wood chair with a round seat, or a plank chair."""
    d.pick("kind", [_shell_chair, _shell_chair, _bentwood_chair, _plank_chair])(d)


def _shell_chair(d: Drawing) -> None:
    body, under, seat = d.material("shell", PLASTICS), d.pick("under", ["wood", "wire", "tube"]), 0.445
    metal = d.material("legs", "beech, oak, walnut" if under == "wood" else "black steel, chrome, white steel")
    (depth, w, h), splay = d.size, 0.05 if under == "tube" else 0.09
    with d.part("seat"):
        stand = d.bounds.bottom(seat - 0.012).inset(x=0.015, y=0.01)
        legs(d, stand, metal, "splayed", 0.034 if under == "wood" else 0.02, splay)
        rail = stand.inset(x=0.21 * depth, y=0.21 * w)
        for a, b in (("back", "front"), ("right", "left")):
            for end in (a, b):
                side = ("right", "left") if a == "back" else ("back", "front")
                d.bar(rail.anchor(f"top {end} {side[0]}"), rail.anchor(f"top {end} {side[1]}"), 0.009, metal, 8)
        if under != "tube":
            cross = stand.inset(x=0.62 * splay, y=0.62 * splay).share(z=(0.0, 0.62))
            for s in ("left", "right"):
                other = "right" if s == "left" else "left"
                d.bar(cross.anchor(f"top back {s}"), cross.anchor(f"top front {other}"), 0.006, metal, 6)
    x1, x0 = depth / 2 - 0.03, -depth / 2
    rows = [  # from the front edge of the seat to the top of the back
        (x1, seat - 0.025, 0.4, -0.02, 0.0),
        (x1 - 0.05, seat + 0.004, 0.455, 0.0, 0.012),
        (x1 - 0.2, seat - 0.006, 0.485, 0.0, 0.035),
        (x0 + 0.16, seat + 0.002, 0.485, 0.03, 0.055),
        (x0 + 0.1, seat + 0.06, 0.475, 0.06, 0.06),
        (x0 + 0.065, seat + 0.18, 0.46, 0.075, 0.0),
        (x0 + 0.03, h - 0.1, 0.42, 0.06, 0.0),
        (x0, h, 0.28, 0.04, -0.03),
    ]
    grid = bent([(x, z, w * half, *turn) for x, z, half, *turn in rows], 2.2, 9)
    with d.part("seat"):
        d.sheet(grid[:5], 0.009, body, (4, 8))
    with d.part("back"):
        d.sheet(grid[4:], 0.009, body, (3, 8))
    if d.chance("pad", 0.35):
        with d.part("seat"):
            pad = d.bounds.to(z=(seat - 0.006, seat + 0.03)).inset(back=0.15, front=0.08, y=0.17 * w)
            d.cushion(pad, d.material("pad", "@fabric"), 0.016)


def _bentwood_chair(d: Drawing) -> None:
    wood, seat, h = d.material("frame", WOODS), 0.445, d.size.height
    weave = wood if d.chance("wooden seat", 0.33) else d.material("seat", "rattan, wicker")
    r = 0.46 * min(d.size.depth, d.size.width)
    with d.part("seat"):
        profile = [(r - 0.02, seat - 0.035), (r, seat - 0.03), (r, seat - 0.006), (r - 0.01, seat)]
        d.revolve(profile, wood, 32)
        d.cylinder(Box.sized(2 * r - 0.09, 2 * r - 0.09, 0.006, (0.0, 0.0, seat - 0.002)), weave, segments=32)
        with d.mirror("y"):
            leg(d, (0.74 * r, 0.74 * r, 0.0), (0.62 * r, 0.62 * r, seat - 0.03), 0.024, 0.036, wood)
            leg(d, (-0.95 * r, 0.62 * r, 0.0), (-0.78 * r, 0.56 * r, seat - 0.03), 0.024, 0.034, wood)
        d.hoop(Box.around((0.0, 0.0, 0.24), 1.4 * r, 1.4 * r, 0.0), 0.008, wood, steps=18)
    with d.part("back"):
        t = np.linspace(-1.0, 1.0, 17)
        for size, radius in ((1.0, 0.014), (0.62, 0.009)):
            y = np.sign(t) * 0.8 * r * size * np.cos((1 - np.abs(t)) ** 1.6 * np.pi / 2) ** 0.7
            rise = h - seat - 0.005 - (1 - size) * 0.28
            z = seat - 0.02 + rise * np.sin((1 - np.abs(t)) * np.pi / 2) ** 0.8
            d.sweep(np.c_[-0.78 * r - 0.16 * (z - seat), y, z], radius, wood, 8)


def _plank_chair(d: Drawing) -> None:
    wood, seat, (depth, w, h) = d.material("frame", WOODS), 0.445, d.size
    with d.part("seat"):
        plan = [(0.08, 0.1), (0.96, 0.0), (1.0, 0.06), (1.0, 0.94), (0.96, 1.0), (0.08, 0.9)]
        d.silhouette(d.bounds.to(z=(seat - 0.028, seat)), plan, wood, "z", bevel=0.006)
        legs(d, d.bounds.bottom(seat - 0.026).inset(x=0.01, y=0.02), wood, "splayed", 0.04, 0.07)
    with d.part("back"), d.at(-depth / 2 + 0.075):
        arc_panel(d, 0.98 * w, (h - 0.12, h), 0.018, 0.05, wood, 0.015)
        for share in np.linspace(-0.8, 0.8, 6).tolist():
            forward = 0.05 * (1 - math.cos(1.2 * share)) / (1 - math.cos(1.2))
            y = share * w / 2
            d.bar((0.015 + 0.4 * forward, 0.86 * y, seat - 0.01), (forward, y, h - 0.1), 0.008, wood, 8)


@draws("school_chair", whole=True)
def school_chair(d: Drawing) -> None:
    """A plywood or plastic seat and back on a frame of steel tube, stackable."""
    body = d.material("seat", "plywood, beech", PLASTICS)
    metal = d.material("frame", "chrome, grey plastic, black steel, blue paint, red paint")
    (depth, w, h), r = d.size, 0.011
    seat, y, x0, x1 = 0.56 * h, w / 2 - 0.011, -depth / 2, depth / 2
    low = seat - 0.025
    with d.part("seat"):
        with d.mirror("y"):
            foot = [(x1 - 0.03, y, 0.0), (x1 - 0.07, y - 0.03, seat - 0.06)]
            d.sweep([*foot, (x1 - 0.1, y - 0.03, low), (x0 + 0.12, y - 0.03, low)], r, metal, 8)
            d.bar((x0 + 0.02, y, 0.0), (x0 + 0.15, y - 0.03, seat - 0.03), r, metal, 8)
        for x in (x0 + 0.16, x1 - 0.1):
            d.bar((x, -y + 0.03, low - 0.002), (x, y - 0.03, low - 0.002), 0.8 * r, metal, 8)
        profile = [(x1, -0.03, 0.42), (x1 - 0.05, -0.006, 0.455), (x1 - 0.17, 0.0, 0.46)]
        profile += [(x0 + 0.17, -0.01, 0.45), (x0 + 0.09, 0.015, 0.4)]
        d.sheet(bent([(x, seat + z, w * half, 0.0, 0.008) for x, z, half in profile], 2.0, 5), 0.01, body, (4, 2))
    with d.part("back"):
        with d.mirror("y"):
            post = [(x0 + 0.14, y - 0.03, low), (x0 + 0.085, y - 0.03, seat + 0.02), (x0 + 0.02, y - 0.04, h - 0.04)]
            d.sweep(post, r, metal, 8)
        with d.at(x0 + 0.035):
            arc_panel(d, 0.9 * w, (h - 0.19, h), 0.01, 0.03, body, 0.025, 0.94)


@draws("kids_chair", whole=True)
def kids_chair(d: Drawing) -> None:
    """A small chair of wood or bright plastic; its back is round, of slats, or a bear's head."""
    wood = d.material("seat", "birch, pine, beech, red paint, blue paint, yellow paint, green paint, white paint")
    under = d.material("legs", "birch, beech, white paint") if d.chance("two tone", 0.6) else wood
    box, (_, w, h), kind = d.bounds, d.size, d.pick("back", ["ears", "slats", "round"])
    seat = 0.52 * h
    with d.part("seat"):
        d.cushion(box.inset(back=0.03).to(z=(seat - 0.025, seat)), wood, 0.012)
        legs(d, box.bottom(seat - 0.02).inset(front=0.01), under, "splayed", 0.036, 0.04)
    with d.part("back"), d.at(box.x[0] + 0.05, pitch=-0.1):
        if kind == "slats":
            with d.mirror("y"):
                d.bar((0.03, w / 2 - 0.025, seat - 0.02), (0.03, w / 2 - 0.025, h - 0.01), 0.012, under, 8)
            for z in (h - 0.09, h - 0.175):
                d.cushion(Box((0.02, 0.038), box.y, (z, z + 0.07)), wood, 0.008)
        else:
            with d.mirror("y"):
                d.bar((0.03, 0.25 * w, seat - 0.02), (0.03, 0.25 * w, h - 0.15), 0.011, under, 8)
            r = 0.38 * w
            head = Box.around((0.03, 0.0, h - (0.03 if kind == "round" else 0.05) - 0.3 * w), 0.016, 2 * r, 2 * r)
            d.cylinder(head, wood, "x", bevel=0.004, segments=28)
            if kind == "ears":
                _bear(d, head, wood)


def _bear(d: Drawing, head: Box, wood: Look) -> None:
    """Ears and a face on a round disc."""
    x, _, z = head.anchor("front")
    r = head.width / 2
    with d.mirror("y"):
        ear = Box.around((head.center[0], 0.72 * r, z + 0.72 * r), 0.014, 0.6 * r, 0.6 * r)
        d.cylinder(ear, wood, "x", bevel=0.003, segments=18)
        d.print(ear.front(0.0).share(y=(0.22, 0.78), z=(0.22, 0.78)), "pink plastic", oval=True)
        d.print(Box.around((x, 0.35 * r, z + 0.15 * r), 0.0, 0.16 * r, 0.16 * r), "black plastic", oval=True)
    d.ball(Box.around((x, 0.0, z - 0.15 * r), 0.012, 0.32 * r, 0.24 * r), "black plastic", segments=10)


@draws("folding_chair", whole=True)
def folding_chair(d: Drawing) -> None:
    """Crossed legs of tube or wooden slats; seat and back of plastic or wood."""
    (depth, w, h), wooden, seat = d.size, d.chance("wooden", 0.45), 0.45
    frame = d.material("frame", "beech, oak, walnut" if wooden else "black steel, white steel, chrome")
    body = frame if wooden else d.material("seat", "black plastic, white plastic, grey plastic, blue plastic")
    x0, x1, y = -depth / 2, depth / 2, w / 2
    section = (0.018, 0.032) if wooden else 0.011
    knee, tip = (0.35 * (x0 + 0.1) - 0.03, seat + 0.02), (x0 + 0.02, h - 0.02)
    place = Box((x0 + 0.1, x1 - 0.04), (-y + 0.045, y - 0.045), (seat - 0.03, seat))
    with d.mirror("y"):
        with d.part("seat"):
            d.bar((x1 - 0.03, y - 0.012, 0.01), (knee[0], y - 0.012, knee[1]), section, frame, 8)
            d.bar((x0 + 0.03, y - 0.04, 0.01), (x1 - 0.1, y - 0.04, seat - 0.03), section, frame, 8)
        with d.part("back"):
            d.bar((knee[0], y - 0.012, knee[1]), (tip[0], y - 0.012, tip[1]), section, frame, 8)
    with d.part("seat"):
        for x, half in ((x1 - 0.055, y - 0.012), (x0 + 0.06, y - 0.04)):
            d.bar((x, -half, 0.07), (x, half, 0.07), 0.009, frame, 8)
        if wooden:
            for slat in place.top(0.018).split("x", 5, gap=0.012):
                d.box(slat, frame)
            with d.mirror("y"):
                d.box(place.left(0.024).bottom(0.033).move(y=-0.005, z=-0.02), frame)
        else:
            d.bar((0.02, -y + 0.01, seat - 0.11), (0.02, y - 0.01, seat - 0.11), 0.008, frame, 8)
            d.cushion(place.inset(y=-0.02), body, 0.014)
    slope = (tip[0] - knee[0]) / (tip[1] - knee[1])
    with d.part("back"):
        for k in range(2 if wooden else 1):
            top = h - 0.005 - 0.12 * k
            heights = (top - (0.075 if wooden else 0.2), top)
            edges = [(tip[0] - slope * (tip[1] - z) + t, z) for z in heights for t in (-0.009, 0.009)]
            d.hull([(x, s * (y - 0.006), z) for x, z in edges for s in (-1, 1)], body)


@draws("high_chair", whole=True)
def high_chair(d: Drawing) -> None:
    """A child's seat with a tray and a foot rest on four long splayed legs."""
    wood = d.material("legs", "beech, oak, white paint, walnut, birch")
    body = d.material("seat", "white plastic, grey plastic, mint plastic, pink plastic, blue plastic")
    box, h, seat, tray = d.bounds, d.size.height, 0.56, 0.73
    with d.part("legs"):
        legs(d, box.bottom(seat).inset(x=0.02), wood, "splayed", 0.042, 0.12)
        d.cushion(Box((-0.17, 0.14), (-0.17, 0.17), (seat - 0.03, seat + 0.02)), body, 0.02)
        d.box(Box((0.12, 0.26), (-0.13, 0.13), (0.27, 0.29)), wood, bevel=0.005)
        with d.mirror("y"):
            d.bar((0.13, 0.12, seat - 0.02), (0.19, 0.12, 0.28), 0.01, wood, 8)
    with d.part("back"), d.at(-0.17, z=seat - 0.02, pitch=-0.14):
        d.cushion(Box((-0.03, 0.015), (-0.17, 0.17), (0.0, h - seat + 0.02)), body, 0.022)
        d.cushion(Box((0.005, 0.03), (-0.13, 0.13), (0.03, h - seat - 0.06)), d.material("pad", "@fabric"), 0.012)
    with d.mirror("y"), d.part("side"):
        d.cushion(Box((-0.19, 0.12), (0.15, 0.19), (seat - 0.02, tray)), body, 0.018)
    board = Box((-0.02, 0.27), (-0.225, 0.225), (tray, tray + 0.02))
    lip = board.inset(bottom=0.01, top=-0.015)
    with d.part("tray"):
        d.cushion(board, "white plastic", 0.01)
        d.bar((0.1, 0.0, seat + 0.01), (0.12, 0.0, tray + 0.005), 0.016, body, 8)
    with d.part("lip"):
        d.box(lip.front(0.02).inset(y=0.02), "white plastic", bevel=0.006)
    with d.mirror("y"), d.part("lip side"):
        d.box(lip.left(0.02).inset(x=0.01), "white plastic", bevel=0.006)
    d.surface("tray", board.inset(back=0.05, front=0.035, y=0.035))


@draws("rocking_chair", whole=True)
def rocking_chair(d: Drawing) -> None:
    """A wooden armchair with a high back on two bent runners."""
    wood, cover = d.material("frame", "oak, walnut, cherry, white paint, beech, mahogany"), d.material("cover", COVERS)
    (depth, w, h), seat = d.size, 0.43
    y = w / 2 - 0.03
    with d.mirror("y"), d.part("side"), d.at(y=y):
        s = np.linspace(-1.0, 1.0, 11)
        runner = np.c_[s * depth / 2, 0 * s, 0.022 + 0.3 * np.clip(np.abs(s) - 0.45, 0.0, None) ** 2]
        d.sweep(runner, (0.032, 0.044), wood)
        for x, top in ((0.2, 0.64), (-0.22, 0.63)):
            leg(d, (x, 0.0, 0.035), (x + 0.02, 0.0, top), 0.034, 0.034, wood, 4)
        arm = Box((-0.3, 0.27), (-0.035, 0.035), (0.625, 0.665))
        d.silhouette(arm, [(0.0, 0.0), (1.0, 0.4), (1.0, 1.0), (0.0, 0.5)], wood, bevel=0.006)
        d.bar((-0.21, 0.0, 0.25), (0.21, 0.0, 0.25), 0.01, wood, 8)
    with d.part("seat"):
        for x in (-0.2, 0.21):
            d.bar((x, -y, 0.365), (x, y, 0.365), 0.014, wood, 8)
        with d.at(z=seat, pitch=-0.07):
            d.box(Box((-0.24, 0.26), (-y + 0.01, y - 0.01), (-0.07, -0.045)), wood, bevel=0.005)
            d.cushion(Box((-0.22, 0.26), (-y + 0.02, y - 0.02), (-0.046, 0.02)), cover, 0.032)
    with d.part("back"), d.at(-0.21, z=0.36, pitch=-0.3):
        long, wide = (h - 0.36) / math.cos(0.3), y - 0.03
        with d.mirror("y"):
            d.bar((0.0, wide, 0.0), (0.0, wide, long), 0.016, wood)
        rest = Box((-0.012, 0.012), (-wide, wide), (0.07, long - 0.01))
        d.box(rest.top(0.11), wood, bevel=0.006)
        d.box(rest.bottom(0.04), wood)
        if d.chance("padded back", 0.45):
            d.cushion(rest.to(x=(0.0, 0.06)).inset(y=0.02, bottom=0.03, top=0.09), cover, 0.029)
        else:
            slats(d, rest.inset(bottom=0.03, top=0.1), wood, 0.07, 0.014, "y", True)
