"""Plants for tables, shelves and the ceiling, and flowers."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from .plants_parts import (
    BROAD,
    GOLDEN,
    OVAL,
    SMALL,
    Foliage,
    Leaves,
    around,
    crown_points,
    leaves,
    pot,
    sectors,
    stem,
)

_GREENS = "leaf, dark leaf, pale leaf"


@draws("cactus")
def cactus(d: Drawing) -> None:
    """A ribbed column with arms, a ribbed ball with a flower, or a column alone; with pale spines."""
    r, h, kind = d.size.width / 2, d.size.height, d.pick("kind", ["arms", "ball", "column"])
    styles = ("taper", "rim", "belly")
    wide = 0.86 if kind == "arms" else 1 / 0.98 if d.pick("pot style", styles) == "taper" else 1.0
    soil = pot(d, r * wide, h * (0.5 if kind == "ball" else 0.3), styles)
    green, high = d.material("body", "leaf, dark leaf, silver leaf"), h - soil
    with d.part("crown"):
        if kind == "ball":
            thick = min(0.7 * r, high / 2.1)
            _ribbed(d, thick, soil - 0.3 * thick, h - 0.012, green, 12)
            points, faces = leaves([[0.0, 0.0, 0.0]], 0.0, 0.5, 0.3, 0.03, 0.016, SMALL, 0.2)
            with d.at(z=h - 0.02), d.ring(5):
                flower = d.material("flower", "pink petal, red petal, yellow petal")
                d.add((points[0], faces), flower, [shapes.hull(points[0])])
            d.ball(Box.around((0.0, 0.0, h - 0.006), 0.012, 0.012, 0.012), "yellow petal", 8)
            return
        thick = min(0.36 * r, 0.16 * high)
        _ribbed(d, thick, soil - 0.02, h, green, 9)
        for side, share in ((1, 0.35), (-1, 0.5)) if kind == "arms" else ():
            out, z, arm = side * (r - 0.62 * thick), soil + share * high, 0.58 * thick
            tip = min(0.97 * h, z + 0.36 * high)
            elbow = [(0, side * 0.6 * thick, z), (0, 0.8 * out, z + 0.03 * high), (0, out, z + 1.4 * arm)]
            d.sweep([*elbow, (0, out, tip - arm)], arm, green)
            d.ball(Box.around((0, out, tip - 1.1 * arm), 2 * arm, 2 * arm, 2.4 * arm), green, 12)
        low, top = (0, 0, soil + 0.18 * high), (0, 0, soil + 0.82 * high)
        with d.no_colliders(), d.ring(9, thick, math.pi / 9), d.along(low, top, 8):
            d.box(Box.around((0.0, 0.0, 0.0), 0.006, 0.006, 0.006), "paper", bevel=0.0)


def _ribbed(d: Drawing, radius: float, low: float, high: float, material: Look, ribs: int) -> None:
    """A column or ball with upright ribs and a round head."""
    tall = high - low
    cap = min(0.48 * tall, 1.2 * radius)
    profile = [(0.82 * radius, low), (radius, low + min(cap, 0.3 * tall))]
    profile += [(radius * math.cos(a), high - cap + cap * math.sin(a)) for a in np.linspace(0.05, 1.4, 6)]
    points, faces = shapes.lathe([*profile, (0.0, high)], 2 * ribs)
    turn = np.arctan2(points[:, 1], points[:, 0]) / (np.pi / ribs)
    inner = np.round(turn - 0.5).astype(int) % 2 == 1
    skin = points * np.where(inner, 0.8, 1.0)[:, None] ** (1, 1, 0)
    d.add((skin, faces), material, [shapes.hull(points)])


@draws("succulent")
def succulent(d: Drawing) -> None:
    """A rosette of thick pointed leaves in a small pot."""
    wide, f, count = min(d.size.depth, d.size.width), Foliage(d), 34
    soil = pot(d, 0.46 * wide, d.size.height * d.uniform("pot height", 0.5, 0.6))
    tone = d.material("leaves", "silver leaf, pale leaf, leaf, pink petal")
    yaw, share = np.arange(count) * GOLDEN, np.arange(count) / (count - 1)
    base, long = around(yaw, 0.006, soil + 0.012 * (1 - share)), wide * (0.16 + 0.34 * share)
    made = leaves(base, yaw, 1.45 - 1.25 * share, -0.5, long, 0.026, (0.5, 0.9, 1.0, 0.7, 0.06), 0.3, 0.004)
    f.add(made, "pale leaf" if d.chance("pale heart", 0.6) else tone, 0, share < 0.5)
    f.add(made, tone, sectors(yaw, 4) + 1, share >= 0.5)
    f.draw((soil - 0.004, d.size.height))


@draws("bonsai")
def bonsai(d: Drawing) -> None:
    """A twisted trunk with pads of leaves over a flat tray on feet."""
    (depth, w, h), f = d.size, Foliage(d)
    glaze = d.material("tray", "blue ceramic, terracotta, grey ceramic, dark marble")
    tray = Box.sized(2 * min(0.42 * depth, 0.3 * w), 0.76 * w, 0.16 * h)
    top = tray.z[1]
    with d.part("pot"):
        with d.corners(tray, inset=0.012):
            d.box(Box((0.0, 0.025), (0.0, 0.035), (0.0, 0.012)), glaze)
        d.sections(tray.inset(bottom=0.01), [(0.9, 0.9, 0.0), (1.0, 1.0, 1.0)], glaze, radius=0.12, convex=True)
        d.box(tray.share(x=(0.05, 0.95), y=(0.04, 0.96)).to(z=(top - 0.01, top + 0.004)), "soil", bevel=0.003)
        d.ball(Box.around((0.2 * tray.depth, -0.27 * tray.width, top + 0.004), 0.036, 0.048, 0.028), "granite", 10)
    bend = 0.12 * w * (1 if d.chance("lean left", 0.5) else -1)
    knots = [(0.0, -0.6, (top - 0.01) / h), (0.01, 0.5, 0.34), (-0.01, -0.7, 0.52), (0.0, 0.3, 0.7), (0.0, 0.0, 0.84)]
    spine = np.array([(x, bend * y, h * z) for x, y, z in knots])
    pads = [(0.0, 0.0, 0.86, 0.26), (0.0, 2.6, 0.6, 0.24), (0.0, -2.7, 0.68, 0.2), (0.2, 0.4, 0.52, 0.18)]
    pads.append((-0.2, -0.6, 0.74, 0.18))
    thick, foliage = 0.02 + 0.012 * h, d.material("leaves", "leaf, dark leaf")
    with d.part("trunk"):
        d.add(stem(spine, thick, 8), "bark", shapes.sweep_hulls(spine, thick, 8))
        for n, (x, y, z, size) in enumerate(pads):
            at = np.array([x * depth, y * bend, z * h])
            near = spine[np.argmin(np.linalg.norm(spine - at, axis=1))]
            if n:
                d.bar(tuple(near), tuple(at), 0.006, "bark", 6)
            way, turn = crown_points(f.rng, int(260 * size))
            points, rise = at + way * np.array([0.75 * size, size, 0.1]) * 0.75 * w, f.rng.uniform(0.0, 1.2, len(way))
            made = leaves(points, turn, rise, 0.4, 0.035 + 0.03 * w, 0.03, SMALL, 0.2)
            f.add(made, foliage if n % 2 else "leaf", n)
    f.draw((0.42 * h, h))


@draws("orchid")
def orchid(d: Drawing) -> None:
    """Bowed stems with a row of blossoms, and broad leaves at the foot."""
    (depth, w, h), f = d.size, Foliage(d)
    soil = pot(d, 0.3 * min(depth, w), 0.24 * h, ("taper", "cube", "belly"))
    petal = d.material("petals", "white petal, pink petal, purple petal, yellow petal")
    yaw = np.array([0.4, 2.2, 3.6, 5.2, 1.3])
    f.add(leaves(around(yaw, 0.0, soil), yaw, 0.7, 1.2, 0.5 * w, 0.2 * w, OVAL, 0.25, 0.003), "dark leaf", 0)
    # Petals stand in a plane that faces the front: drawn flat, then turned up.
    five = np.arange(5) * 1.2566 + 0.3
    flat, faces = leaves(np.zeros((5, 3)), five, 0.25, 0.3, 0.093 * w, 0.075 * w, (0.3, 1.0, 0.8, 0.15), 0.1)
    up = flat[..., [2, 1, 0]] * np.array([1, -1, 1])
    t = np.linspace(0, 1, 9)
    for n, side in enumerate((1, -1) if d.chance("two stems", 0.7) else (1,), start=1):
        x, y = 0.2 * depth * t * (1.5 - n), side * 0.42 * w * t**2.2
        z = soil - 0.01 + (h - soil) * (1.25 * t - 0.3 * t**4)
        f.shape(stem(np.c_[x, y, z], 0.0035), "leaf", n)
        for m in range(6):
            at = np.array([np.interp(0.5 + 0.1 * m, t, v) for v in (x + 0.012, y, z - 0.01)])
            turn = f.rng.uniform(-0.4, 0.4) + (0.35 if m % 2 else -0.35)
            c, s = math.cos(turn), math.sin(turn)
            f.add((up @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + at, faces), petal, n)
            f.shape(shapes.ball((0.006, 0.005, 0.006), tuple(at + (0.008, 0.0, 0.0)), 6), "yellow petal", n)
    f.draw((soil - 0.01, h))


_VASES = (
    [(0.7, 0), (0.75, 0.02), (1.0, 0.35), (0.85, 0.65), (0.5, 0.84), (0.62, 1.0)],
    [(0.75, 0), (0.8, 0.02), (0.72, 0.4), (0.95, 1.0)],
    [(0.6, 0), (0.95, 0.2), (1.0, 0.42), (0.7, 0.72), (0.46, 0.8), (0.5, 1.0)],
)


@draws("flower_vase")
def flower_vase(d: Drawing) -> None:
    """A bunch of roses, tulips or daisies with leaves, in a vase of glass or glaze."""
    (depth, w, h), f, wide = d.size, Foliage(d), min(d.size.depth, d.size.width)
    look = d.material("vase", "white ceramic, blue ceramic, glass, cream ceramic, terracotta, grey ceramic")
    tall = 0.46 * h
    with d.part("vase"):
        outer = [(0.23 * wide * u, tall * v) for u, v in d.pick("vase shape", _VASES)]
        lip = outer[-1][0] - 0.005
        d.revolve([*outer, (lip, tall), (0.9 * lip, 0.86 * tall)], look, 24, hollow=True, holds=False)
    petal = d.material("petals", "red petal, pink petal, yellow petal, white petal, purple petal, orange petal")
    kind, count = d.pick("flowers", ["rose", "daisy", "tulip"]), d.integer("count", 9, 13)
    for n in range(count):
        yaw, u, clump = n * GOLDEN, math.sqrt((n + 0.3) / count), n % 6
        tip = around(yaw, 0.36 * u, h * (0.93 - 0.24 * u * u))[0] * (depth, w, 1.0)
        foot = around(yaw, 0.012, 0.8 * tall)[0]
        middle = (foot + tip) / 2 + (0.0, 0.0, 0.04 * u)
        f.shape(stem([foot, middle, tip], 0.0028, 5), "leaf", clump)
        size = wide * f.rng.uniform(0.11, 0.14) * (1.0 if kind == "daisy" else 1.3)
        color = petal if n % 3 or kind == "daisy" else "white petal"
        for (points, faces), of in _blossom(kind, size, color):
            f.add((points @ _tilt(0.6 * u * math.cos(yaw), 0.6 * u * math.sin(yaw)).T + tip, faces), of, clump)
        leaf = leaves([middle], yaw + 1.0, 0.7, 1.0, 0.26 * h, 0.03 + 0.02 * h, OVAL)
        f.add(leaf, "leaf" if n % 2 else "dark leaf", clump)
    f.draw((0.78 * tall, h), part="flowers")


def _tilt(x: float, y: float) -> np.ndarray:
    """The turn [3, 3] that leans a blossom outward."""
    up = np.array([x, y, 1.0]) / math.sqrt(x * x + y * y + 1)
    right = np.cross([0.0, 1.0, 0.0], up)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(up, right), up], axis=1)


def _blossom(kind: str, size: float, petal: Look) -> list[tuple[Leaves, Look]]:
    """A blossom about z at the origin: its leaves and finishes."""

    def whorl(count: int, rise, bend: float, long: float, wide: float, outline, fold: float, turn=0.0) -> Leaves:
        yaw = np.arange(count) * (2 * np.pi / count) + turn
        return leaves(np.zeros((count, 3)), yaw, rise, bend, size * long, size * wide, outline, fold)

    if kind == "daisy":
        heart, yaw = np.tile((0.0, 0.0, 0.004), (6, 1)), np.arange(6) * 1.047
        middle = leaves(heart, yaw, 0.35, 0.8, 0.4 * size, 0.36 * size, SMALL, 0.0, 0.008, rib=False)
        return [(whorl(11, 0.15, 0.3, 1.0, 0.4, (0.4, 1.0, 0.3), 0.1), petal), (middle, "yellow petal")]
    if kind == "tulip":
        return [(whorl(6, 0.5 + 0.15 * (np.arange(6) % 2), -1.3, 1.15, 0.75, (0.5, 1.0, 0.95, 0.15), 0.2), petal)]
    rows = [(5, 0.35, -0.9, 0.95), (5, 0.75, -0.8, 0.9), (4, 1.1, -0.5, 0.8), (3, 1.4, -0.2, 0.7)]
    outline = (0.4, 1.0, 0.9, 0.4)
    return [(whorl(*row, 0.85, outline, 0.15, 0.6 * k), petal) for k, row in enumerate(rows)]


@draws("herb_pot")
def herb_pot(d: Drawing) -> None:
    """A bushy kitchen herb in a small pot."""
    h, f, wide = d.size.height, Foliage(d), min(d.size.depth, d.size.width)
    soil = pot(d, 0.38 * wide, 0.42 * h, ("taper", "rim", "cube"))
    kind, rng = d.pick("herb", ["basil", "chives", "rosemary"]), f.rng
    greens = {"basil": "leaf, pale leaf", "chives": "leaf", "rosemary": "silver leaf, dark leaf"}
    green = d.material("leaves", greens[kind])
    if kind == "chives":
        yaw = rng.uniform(0, 2 * np.pi, 90)
        base = around(yaw, rng.uniform(0, 0.22, 90) * wide, soil - 0.008)
        rise, long = rng.uniform(1.2, 1.55, 90), (h - soil) * rng.uniform(0.7, 1.0, 90)
        f.add(leaves(base, yaw, rise, 0.4, long, 0.005, (1, 1, 0.2), 0.0, 0.003, rib=False), green, sectors(yaw, 4))
    rows, size = (5, (0.2, 0.14 * wide)) if kind == "basil" else (9, (0.16, 0.005))
    for n in range(0 if kind == "chives" else 14):
        a, u = n * GOLDEN, math.sqrt((n + 0.5) / 14)
        foot, tip = around(a, 0.2 * wide * u, soil - 0.008)[0], around(a, 0.4 * wide * u, h - 0.3 * u * (h - soil))[0]
        f.shape(stem([foot, tip], 0.0022, 5), "leaf", n % 5)
        level = np.repeat(np.arange(rows), 2)
        yaw, long = a + np.arange(2 * rows) * 1.5708 + 0.8 * level, wide * size[0] * rng.uniform(0.7, 1.1, 2 * rows)
        base = foot + (0.3 + 0.7 * level / (rows - 1))[:, None] * (tip - foot)
        f.add(leaves(base, yaw, 0.5, 0.8, long, size[1], (0.3, 1.0, 0.8, 0.06)), green if n % 3 else "leaf", n % 5)
    f.draw((soil - 0.01, h))


@draws("small_plant")
def small_plant(d: Drawing) -> None:
    """A little leafy plant for desk or shelf: upright oval or heart-shaped leaves, or a fountain of stripes."""
    (depth, w, h), f = d.size, Foliage(d)
    soil = pot(d, 0.34 * min(depth, w), h * d.uniform("pot height", 0.38, 0.46))
    green, kind = d.material("leaves", _GREENS), d.pick("kind", ["oval", "spider", "heart"])
    count = 34 if kind == "spider" else 30
    yaw, share = np.arange(count) * GOLDEN, np.arange(count) / count
    base = around(yaw, 0.012, soil - 0.006)
    if kind == "spider":
        rise, bend, outline, long = 1.5 - 0.8 * share, 1.6 + 0.5 * share, (0.8, 1, 0.9, 0.7, 0.1), h - soil
        stripe = leaves(base + (0, 0, 0.0012), yaw, rise, bend, 1.48 * long, 0.006, outline, 0.3, 0.003)
        f.add(stripe, "paper", sectors(yaw))
        f.add(leaves(base, yaw, rise, bend, 1.5 * long, 0.018, outline, 0.3), green, sectors(yaw))
    else:
        long, rise = (h - soil) * f.rng.uniform(0.35, 0.8, count), 1.5 - 0.9 * share
        tips = base + around(yaw, long * np.cos(rise), long * np.sin(rise))
        for foot, tip, n in zip(base, tips, sectors(yaw), strict=True):
            f.shape(stem([foot, tip], 0.002, 5), green, int(n))
        outline = BROAD if kind == "heart" else OVAL
        f.add(leaves(tips, yaw, rise - 0.5, 0.9, 0.3 * w, 0.17 * w, outline), green, sectors(yaw))
    f.draw((soil - 0.006, h))


@draws("hanging_plant")
def hanging_plant(d: Drawing) -> None:
    """A pot in three cords from a hook, with tendrils that hang far down."""
    (depth, w, h), f = d.size, Foliage(d)
    r, rng = 0.32 * min(depth, w), f.rng
    low, high = 0.36 * h, 0.36 * h + 1.5 * r
    with d.at(z=low):
        soil = low + pot(d, r, 1.5 * r, ("belly", "taper"))
    cord = d.material("cord", "cork, black steel, brass, white fabric")
    with d.part("cords"):
        with d.ring(3, start=0.5):
            d.bar((0.94 * r, 0.0, high - 0.02), (0.0, 0.0, h - 0.04), 0.0035, cord, 6)
        d.cylinder(Box.sized(0.04, 0.04, 0.05, (0.0, 0.0, h - 0.05)), cord, ends=(0.6, 1.0), segments=12)
    green = d.material("leaves", "leaf, pale leaf, dark leaf")
    for n in range(13):
        yaw, drop, out = n * GOLDEN, rng.uniform(0.35, 1.0) * soil, rng.uniform(1.05, 1.3)
        reach = r * np.array([0.4, 0.85, out, 1.08 * out, out])
        path = around(np.full(5, yaw), reach, soil + np.array([0.0, 0.05, -0.02, -0.5 * drop, -drop]))
        f.shape(stem(path, 0.0025, 5), "leaf", n % 6)
        t = np.linspace(0.5, 4.0, 11)
        at = np.stack([np.interp(t, np.arange(5), path[:, c]) for c in range(3)], axis=1)
        turn = yaw + np.where(np.arange(11) % 2, 0.9, -0.9) + rng.uniform(-0.3, 0.3, 11)
        f.add(leaves(at, turn, 0.2, 1.4, rng.uniform(0.05, 0.075, 11), 0.05, (0.35, 1.0, 0.8, 0.05)), green, n % 6)
    yaw = np.arange(26) * GOLDEN
    base = around(yaw, 0.5 * r * np.sqrt(np.arange(26) / 26), soil)
    f.add(leaves(base, yaw, rng.uniform(0.5, 1.3, 26), 1.0, 0.12, 0.06, BROAD), green, 6)
    f.draw((0.0, min(soil + 0.1, h - 0.1)))


@draws("terrarium")
def terrarium(d: Drawing) -> None:
    """Little plants, stones and soil under glass: a dome, or a house of panes with brass edges."""
    r, h, f = d.size.width / 2, d.size.height, Foliage(d)
    metal, floor = d.material("frame", "brass, black steel, copper, light oak"), 0.2 * d.size.height
    with d.part("glass"):
        if d.pick("kind", ["dome", "house"]) == "dome":
            d.cylinder(Box.sized(2 * r, 2 * r, 0.018), metal, bevel=0.004, segments=28)
            turn = np.linspace(0, 1.5, 7).tolist()
            curve = [((r - 0.008) * math.cos(a), 0.5 * h + (0.5 * h - 0.02) * math.sin(a)) for a in turn]
            d.revolve([(r - 0.008, 0.018), *curve, (0.0, h - 0.02)], "glass", 28)
            d.ball(Box.around((0.0, 0.0, h - 0.012), 0.024, 0.024, 0.024), metal, 10)
            d.cylinder(Box.sized(2 * r - 0.028, 2 * r - 0.028, 1.0).to(z=(0.018, floor)), "soil")
        else:
            box = Box.sized(2 * r - 0.008, 2 * r - 0.008, h - 0.009, (0.0, 0.0, 0.004))
            eave = 0.62
            outline = [(0, 0), (1, 0), (1, eave), (0.5, 1), (0, eave)]
            d.silhouette(box, outline, "glass", "y")
            with d.mirror("y"):
                gable = [box.point(u, 1.0, z) for u, z in outline]
                for a, b in zip(gable, [*gable[1:], gable[0]], strict=True):
                    d.bar(a, b, 0.004, metal, 6)
                d.bar(gable[4], gable[2], 0.004, metal, 6)
            for u, z in outline:
                d.bar(box.point(u, 0.0, z), box.point(u, 1.0, z), 0.004, metal, 6)
            d.box(box.inset(x=0.006, y=0.006).to(z=(0.008, floor)), "soil", bevel=0.0)
        n = np.arange(40)
        spot = np.array([(0.25, 0.2), (-0.3, 0.25), (-0.05, -0.35), (0.3, -0.25)])[n % 4] * r
        rise, long = f.rng.uniform(0.5, 1.4, 40), (h - floor) * f.rng.uniform(0.25, 0.5, 40)
        made = leaves(np.c_[spot, np.full(40, floor)], n * GOLDEN, rise, 0.7, long, 0.022, OVAL)
        for k, name in enumerate(("leaf", "pale leaf", "dark leaf", "silver leaf")):
            f.add(made, name, k, n % 4 == k)
        f.draw((floor - 0.003, 0.5 * (floor + h)), Box.sized(1.2 * r, 1.2 * r, h), "glass")
        for x, y, s in ((0.45, 0.0, 0.26), (-0.42, -0.1, 0.2), (0.0, 0.45, 0.16)):
            d.ball(Box.around((x * r, y * r, floor), s * r, 1.2 * s * r, 0.8 * s * r), "granite", 8)
