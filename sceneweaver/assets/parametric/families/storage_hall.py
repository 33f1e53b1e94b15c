"""Of the hall: racks and stands for coats, shoes, umbrellas and papers."""

from __future__ import annotations

import numpy as np

from ..builder import Builder
from ..registry import draws
from .storage_parts import split

WOODS = ("oak", "walnut", "white paint", "black paint", "beech", "light oak")


def _hook(b: Builder, x: float, y: float, z: float, metal, yaw: float = 0.0, reach: float = 0.06) -> None:
    """A coat hook at a place on an upright, pointing away from it."""
    with b.frame(x, y, z, yaw=yaw):
        b.tube([(0, 0, 0), (reach * 0.6, 0, -0.015), (reach, 0, 0.01), (reach, 0, 0.045)], 0.006, metal, segments=8)
        b.ball((0.011, 0.011, 0.011), (reach, 0, 0.05), metal, segments=10)


@draws("coat_rack")
def coat_rack(b: Builder) -> None:
    """A pole on a foot with arms that curve up and out around its head."""
    d, w, h = b.size
    frame = b.material("frame", "walnut", "oak", "black steel", "white paint", "beech", "brass")
    tips = b.material("tips", "brass", "black steel", "oak") if b.chance("tips", 0.4) else frame
    r, arms = 0.019, b.pick("arms", [4, 6, 8])
    reach = min(d, w) / 2
    with b.solid("foot"):
        if b.chance("disc", 0.4):
            b.lathe([(reach * 0.75, 0.0), (reach * 0.75, 0.012), (0.05, 0.03), (r, 0.06)], frame, segments=32)
        else:
            for k in range(4):
                with b.frame(yaw=np.pi / 4 + k * np.pi / 2):
                    b.tube(
                        [(0.0, 0, 0.19), (reach * 0.45, 0, 0.13), (reach * 0.8, 0, 0.05), (reach * 0.9, 0, 0.013)],
                        0.013,
                        frame,
                        segments=10,
                    )
    with b.solid("pole"):
        b.lathe(
            [
                (r, 0.02),
                (r, h - 0.09),
                (r * 1.25, h - 0.085),
                (r * 1.25, h - 0.07),
                (r * 0.7, h - 0.06),
                (r * 1.15, h - 0.03),
                (0.006, h),
            ],
            frame,
            segments=20,
        )
    with b.solid("arms"):
        for k in range(arms):
            high = h - 0.14 if k % 2 == 0 else h - 0.32
            with b.frame(yaw=k * 2 * np.pi / arms):
                b.tube(
                    [
                        (0, 0, high - 0.08),
                        (reach * 0.5, 0, high - 0.07),
                        (reach * 0.85, 0, high - 0.02),
                        (reach * 0.95, 0, high + 0.05),
                    ],
                    0.009,
                    frame,
                    segments=8,
                )
                b.ball((0.015, 0.015, 0.015), (reach * 0.95, 0, high + 0.055), tips, segments=12)
    b.fit()


@draws("clothes_rack")
def clothes_rack(b: Builder) -> None:
    """Two side frames and a rail, a low shelf, sometimes clothes on hangers."""
    d, w, h = b.size
    metal = b.material("frame", "black steel", "chrome", "white steel", "oak", "walnut")
    r = 0.014
    castors = b.chance("castors", 0.5)
    low = 0.075 if castors else 0.02
    with b.solid("foot"):
        for sy in (-1, 1):
            y = sy * (w / 2 - 0.05)
            b.box((-d / 2, d / 2), (y - 0.016, y + 0.016), (low - 0.02, low + 0.012), metal)
            if castors:
                for sx in (-1, 1):
                    with b.frame(sx * (d / 2 - 0.03), y, 0.0275, roll=np.pi / 2):
                        b.frustum(0.0275, 0.0275, (-0.012, 0.012), "black plastic", segments=14)
        b.box(
            (-d / 2 + 0.08, d / 2 - 0.08),
            (-w / 2 + 0.034, w / 2 - 0.034),
            (low + 0.06, low + 0.078),
            b.material("shelf", "oak", "walnut", "white paint", "pine"),
        )
    y = w / 2 - 0.05
    for k, sy in enumerate((-1, 1)):
        with b.solid(f"upright-{k}"):
            b.bar((0, sy * y, low), (0, sy * y, h - r), r, metal, segments=12)
    with b.solid("rail"):
        b.bar((0, -w / 2, h - r), (0, w / 2, h - r), r, metal, segments=12)
        if b.chance("clothes", 0.65):
            _clothes(b, d, y, h - r)
    z = low + 0.078
    b.surface("shelf", (-d / 2 + 0.085, d / 2 - 0.085), (-w / 2 + 0.075, w / 2 - 0.075), z, headroom=0.25)


def _clothes(b: Builder, d: float, y: float, rail: float) -> None:
    """Some garments, thin and wide, on hangers over a rail along y."""
    dyes = ["grey fabric", "navy fabric", "beige fabric", "rust fabric", "green fabric", "white fabric", "rose fabric"]
    for k in range(b.whole("garments", 4, 8)):
        at = (b.uniform(f"at {k}", -0.06, 0.06) + k * 0.1 - 0.35) * 1.7 * y
        cloth = b.pick(f"dye {k}", dyes)
        wide = min(d / 2 - 0.005, 0.21) * b.uniform(f"wide {k}", 0.88, 1.0)
        long = b.uniform(f"long {k}", 0.62, 0.95)
        t = 0.018
        top = rail - 0.075
        section = [
            (-wide, top - 0.1),
            (-0.06, top),
            (0.06, top),
            (wide, top - 0.1),
            (wide * 0.96, top - long),
            (-wide * 0.96, top - long),
        ]
        b.hull([(px, at + s * t, pz) for px, pz in section for s in (-1, 1)], cloth)
        b.bar((0, at, top - 0.005), (0, at, rail + 0.005), 0.003, "chrome", segments=6)


@draws("hall_stand")
def hall_stand(b: Builder) -> None:
    """A bench for shoes, a panel with hooks and mirror above it, a hat shelf on top."""
    d, w, h = b.size
    wood = b.material("body", "oak", "walnut", "white paint", "pine", "sage paint", "ash grey wood")
    metal = b.material("hooks", "black steel", "brass", "bronze")
    seat, t = 0.46, 0.022
    x0, deep = -d / 2, min(0.3, 0.75 * d)
    inner = (-w / 2 + t, w / 2 - t)
    for k, ys in enumerate(((-w / 2, inner[0]), (inner[1], w / 2))):
        with b.solid(f"side-{k}"):
            b.box((x0, d / 2 - 0.01), ys, (0.0, seat - 0.025), wood)
    with b.solid("shelf"):
        b.box((x0, d / 2 - 0.02), inner, (0.1, 0.12), wood)
        b.box((x0, d / 2 - 0.05), inner, (0.0, 0.1), wood, bevel=0.0)
    with b.solid("seat"):
        b.box((x0, d / 2), (-w / 2, w / 2), (seat - 0.025, seat), wood, bevel=0.004)
    with b.solid("back"):
        b.box((x0, x0 + 0.018), inner, (0.12, seat - 0.025), wood, bevel=0.0)
    with b.solid("panel"):
        for sy in (-1, 1):
            ys = sorted((sy * w / 2, sy * (w / 2 - 0.06)))
            b.box((x0, x0 + 0.03), (ys[0], ys[1]), (seat, h), wood)
        middle = (-w / 2 + 0.06, w / 2 - 0.06)
        b.box((x0, x0 + 0.012), middle, (seat, h), wood, bevel=0.0)
        for ys in split(middle, max(4, round(w / 0.11)), 0.006):
            b.box((x0 + 0.012, x0 + 0.018), ys, (seat, h - 0.03), wood, bevel=0.002)
        b.box((x0 + 0.018, x0 + 0.03), middle, (h - 0.36, h - 0.26), wood)
    with b.solid("hooks"):
        for k in range(count := max(3, round(w / 0.2))):
            _hook(b, x0 + 0.03, -w / 2 + (k + 0.5) * w / count, h - 0.32, metal)
    with b.solid("panel"):
        if b.chance("mirror", 0.5):
            half = min(0.2, 0.28 * w)
            b.box((x0 + 0.018, x0 + 0.028), (-half - 0.025, half + 0.025), (seat + 0.22, h - 0.43), wood)
            b.box((x0 + 0.028, x0 + 0.031), (-half, half), (seat + 0.245, h - 0.455), "mirror", bevel=0.0)
    with b.solid("hat shelf"):
        b.box((x0 + 0.03, x0 + deep), (-w / 2, w / 2), (h - 0.19, h - 0.168), wood, bevel=0.003)
    room = round(seat - 0.025 - 0.12 - 0.004, 4)
    b.surface("shoes", (x0 + 0.025, d / 2 - 0.025), (inner[0] + 0.005, inner[1] - 0.005), 0.12, headroom=room)
    b.surface("seat", (x0 + 0.1, d / 2 - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), seat, headroom=0.7)
    b.surface("hats", (x0 + 0.04, x0 + deep - 0.01), (-w / 2 + 0.01, w / 2 - 0.01), h - 0.168)


@draws("shoe_rack")
def shoe_rack(b: Builder) -> None:
    """Two to four low tiers between ladder sides."""
    d, w, h = b.size
    frame = b.material("frame", "bamboo", "oak", "black steel", "walnut", "white paint")
    boards = b.material("boards", "bamboo", "oak", "pine", "walnut") if b.chance("two", 0.4) else frame
    post, tiers = 0.026, max(2, min(4, round(h / 0.23)))
    for k, sy in enumerate((-1, 1)):
        ys = sorted((sy * w / 2, sy * (w / 2 - post)))
        with b.solid(f"side-{k}"):
            for xs in ((-d / 2, -d / 2 + post), (d / 2 - post, d / 2)):
                b.box(xs, (ys[0], ys[1]), (0.0, h), frame, bevel=0.003)
            b.box((-d / 2 + post, d / 2 - post), (ys[0] + 0.004, ys[1] - 0.004), (h - 0.03, h - 0.002), frame)
            b.box((-d / 2 + post, d / 2 - post), (ys[0] + 0.004, ys[1] - 0.004), (0.07, 0.098), frame)
    y = (-w / 2 + post, w / 2 - post)
    levels = [0.1 + k * (h - 0.102) / (tiers - 1) for k in range(tiers)]
    for k, z in enumerate(levels):
        with b.solid(f"tier-{k}"):
            b.box((-d / 2 + 0.03, d / 2 - 0.03), y, (z - 0.016, z - 0.001), boards, bevel=0.0)
            for xs in split((-d / 2 + 0.002, d / 2 - 0.002), 5, 0.003):
                b.box(xs, y, (z - 0.012, z), boards, bevel=0.001)
        room = None if k == tiers - 1 else round(levels[k + 1] - 0.019 - z, 4)
        b.surface(
            "top" if room is None else f"shelf-{k}",
            (-d / 2 + 0.008, d / 2 - 0.008),
            (y[0] + 0.005, y[1] - 0.005),
            z,
            headroom=room,
        )


@draws("umbrella_stand")
def umbrella_stand(b: Builder) -> None:
    """A tall open vessel with umbrellas in it."""
    d, w, h = b.size
    body = b.material("body", "black steel", "brass", "white ceramic", "wicker", "copper", "blue ceramic")
    r, tall = min(d, w) / 2, 0.52 + 0.06 * b.uniform("tall", -1, 1)
    square = not b.chance("round body", 0.6)
    with b.solid("body"):
        if square:
            for k in range(4):
                with b.frame(yaw=k * np.pi / 2):
                    b.box((r - 0.012, r), (-r, r - 0.012), (0.0, tall), body, bevel=0.001)
            b.box((-r + 0.012, r - 0.012), (-r + 0.012, r - 0.012), (0.0, tall - 0.1), "black paint", bevel=0.0)
        else:
            b.lathe(
                [
                    (r * 0.86, 0.0),
                    (r * 0.9, 0.02),
                    (r * 0.84, 0.05),
                    (r * 0.9, tall - 0.03),
                    (r, tall - 0.015),
                    (r, tall),
                ],
                body,
                segments=28,
            )
            b.frustum(r * 0.88, r * 0.88, (tall, tall + 0.0005), "black paint", segments=28)
        for k in range(count := b.whole("umbrellas", 2, 3)):
            cloth = b.pick(
                f"cloth {k}", ["black fabric", "navy fabric", "red fabric", "green fabric", "mustard fabric"]
            )
            grip = b.pick(f"grip {k}", ["walnut", "beech", "black plastic"])
            with b.frame(yaw=2 * np.pi * k / count + 0.6):
                _umbrella(b, r * 0.42, tall - 0.05, h - 0.03 * k, r * 0.3, cloth, grip)
    b.fit()


def _umbrella(b: Builder, x: float, low: float, high: float, lean: float, cloth, grip) -> None:
    """A rolled umbrella that leans outward, from the rim of its stand up to its crook."""
    long = high - low
    head = x + lean * 0.5
    with b.frame(x, 0.0, low, pitch=float(np.arctan2(lean * 0.5, long))):
        b.frustum(0.03, 0.014, (0.0, long * 0.5), cloth, segments=12)
        b.frustum(0.006, 0.006, (long * 0.5, long * 0.72), "chrome", segments=8)
    turn = np.linspace(0.0, np.pi, 7)
    crook = [
        (head - 0.004, 0, low + long * 0.68),
        *((head, 0.028 - 0.028 * np.cos(v), high - 0.042 + 0.028 * np.sin(v)) for v in turn),
    ]
    b.tube(crook, 0.01, grip, segments=8)


@draws("magazine_rack")
def magazine_rack(b: Builder) -> None:
    """A V of two slatted sides on feet, with magazines between them."""
    d, w, h = b.size
    wood = b.material("frame", "oak", "walnut", "black steel", "brass", "beech")
    t = 0.012
    with b.solid("body"):
        b.box((-0.05, 0.05), (-w / 2 + 0.02, w / 2 - 0.02), (0.075, 0.09), wood)
        for sx in (-1, 1):
            for z0, z1 in ((0.09, 0.13), (h * 0.5, h * 0.5 + 0.035), (h - 0.035, h)):
                lean = (d / 2 - t - 0.04) / (h - 0.09)
                b.hull(
                    [
                        (sx * (0.04 + lean * (z - 0.09) + a), y, z)
                        for z in (z0, z1)
                        for a in (0.0, t)
                        for y in (-w / 2, w / 2)
                    ],
                    wood,
                )
            for sy in (-1, 1):
                y = sy * (w / 2 - 0.03)
                b.hull(
                    [
                        (sx * a, y + c, z)
                        for z, p in ((0.0, d / 2), (0.09, 0.055))
                        for a in (p - 0.022, p)
                        for c in (-0.008, 0.008)
                    ],
                    wood,
                )
                b.hull(
                    [
                        (sx * a, y + c, z)
                        for z, p in ((0.085, 0.04), (h - 0.005, d / 2 - t))
                        for a in (p - 0.012, p)
                        for c in (-0.008, 0.008)
                    ],
                    wood,
                )
        covers = ["paper", "red plastic", "blue plastic", "yellow plastic", "sea pigment", "blush pigment"]
        for k in range(b.whole("papers", 4, 6)):
            high = h + b.uniform(f"high {k}", -0.1, -0.02)
            x = -0.034 + 0.012 * k
            ys = (-w / 2 + 0.035 + 0.006 * k, w / 2 - 0.05)
            b.box((x, x + 0.008), ys, (0.091, high), b.pick(f"cover {k}", covers), bevel=0.001)


@draws("newspaper_stand")
def newspaper_stand(b: Builder) -> None:
    """Steps of tilted pockets one over another, papers and magazines in them."""
    d, w, h = b.size
    frame = b.material("frame", "black steel", "oak", "white steel", "red paint", "walnut")
    tiers = 3 if h < 1.25 else 4
    t = 0.016
    covers = ["paper", "paper", "red plastic", "blue plastic", "yellow plastic", "green plastic", "chalk pigment"]
    with b.solid("body"):
        for ys in ((-w / 2, -w / 2 + t), (w / 2 - t, w / 2)):
            b.hull(
                [
                    (x, y, z)
                    for x, z in ((-d / 2, 0), (d / 2, 0), (d / 2, 0.14), (-d / 2 + 0.07, h), (-d / 2, h))
                    for y in ys
                ],
                frame,
            )
        inner = (-w / 2 + t, w / 2 - t)
        step = (h - 0.12) / tiers
        for k in range(tiers):
            low = 0.1 + k * step
            x = d / 2 - 0.03 + (0.1 - d) * (low + 0.07) / h
            b.box((-d / 2 + 0.01, x), inner, (low - 0.015, low), frame)
            b.box((x - 0.012, x), inner, (low, low + 0.06), frame)
            with b.frame(x - 0.02, 0.0, low, pitch=-0.2):
                b.box((-0.016, -0.008), inner, (0.0, step * 0.93), frame, bevel=0.0)
                columns = max(2, round(w / 0.26))
                for j, ys in enumerate(split((inner[0] + 0.01, inner[1] - 0.01), columns, 0.012)):
                    thick = b.uniform(f"thick {k} {j}", 0.004, 0.016)
                    high = step * b.uniform(f"high {k} {j}", 0.72, 0.88)
                    cover = b.pick(f"cover {k} {j}", covers)
                    b.box((-0.008, -0.008 + thick), ys, (0.003, high), cover, bevel=0.001)
                    b.box(
                        (-0.008 + thick, -0.007 + thick),
                        (ys[0] + 0.012, ys[1] - 0.012),
                        (high * 0.8, high * 0.92),
                        b.pick(f"title {k} {j}", ["black paint", "red paint", "navy paint"]),
                        bevel=0.0,
                    )


@draws("room_divider")
def room_divider(b: Builder) -> None:
    """A folding screen: framed panels in a zigzag, of cloth, paper or slats."""
    d, w, h = b.size
    wood = b.material("frame", "walnut", "oak", "black paint", "white paint", "bamboo")
    fill = b.material("panels", "paper", "rattan", "white fabric", "green fabric", "frosted glass")
    shoji = b.chance("shoji", 0.5)
    count = 3 if w < 1.45 else 4
    t = 0.022
    run, fall = w / count, d - t
    wide, turn = float(np.hypot(run, fall)), float(np.arctan2(fall, run))
    for k in range(count):
        y, sign = -w / 2 + (k + 0.5) * run, 1 if k % 2 == 0 else -1
        with b.frame(0.0, y, yaw=sign * turn), b.solid(f"panel-{k}"):
            half = wide / 2 - 0.006
            post = 0.032
            for ys in ((-half, -half + post), (half - post, half)):
                b.box((-t / 2, t / 2), ys, (0.0, h), wood)
            inner = (-half + post, half - post)
            for zs in ((0.06, 0.11), (h - 0.045, h - 0.01), (0.32 * h, 0.32 * h + 0.025)):
                b.box((-t / 2 + 0.002, t / 2 - 0.002), inner, zs, wood, bevel=0.001)
            b.box((-0.003, 0.003), inner, (0.11, h - 0.045), fill, bevel=0.0)
            if shoji:
                middle = (inner[0] + inner[1]) / 2
                b.box((-0.007, 0.007), (middle - 0.006, middle + 0.006), (0.11, h - 0.045), wood, bevel=0.0)
                for z in np.linspace(0.32 * h, h - 0.045, 6)[1:-1]:
                    b.box((-0.007, 0.007), inner, (z - 0.006, z + 0.006), wood, bevel=0.0)
    b.fit()
