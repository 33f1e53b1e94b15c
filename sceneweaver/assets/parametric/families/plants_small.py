"""Plants for tables, shelves and the ceiling, and flowers."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .plants_parts import BROAD, OVAL, SMALL, Clumps, crown_points, fronds, leaves, pot, randoms, sectors, stem


@draws("fern")
def fern(b: Builder) -> None:
    """Arching feathered fronds all around a low pot."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.27, h * b.uniform("pot height", 0.36, 0.44), styles=("taper", "belly", "rim"))
    green = b.material("leaves", "leaf", "pale leaf")
    count = 20
    yaw = np.arange(count) * 2.399
    share = np.arange(count) / count
    base = np.c_[0.02 * np.cos(yaw), 0.02 * np.sin(yaw), np.full(count, soil)]
    made = fronds(
        base,
        yaw,
        1.45 - 0.8 * share,
        1.5 + 0.6 * share,
        (h - soil) * rng.uniform(1.0, 1.3, count),
        0.22,
        11,
        0.016,
        0.0016,
    )
    k = Clumps()
    for n, part in enumerate(made):
        k.add(part, green if n % 2 else "leaf", sectors(yaw[n // 3 : n // 3 + 1], 8))
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (min(soil - 0.01, h * 0.3), h))


@draws("cactus")
def cactus(b: Builder) -> None:
    """A ribbed column with arms, a ribbed ball with a flower, or flat pads; with pale spines."""
    r, h = b.size.width / 2, b.size.height
    kind = b.pick("kind", ["arms", "ball", "column"])
    styles = ("taper", "rim", "belly")
    wide = 0.86 if kind == "arms" else 1 / 0.98 if b.pick("pot style", styles) == "taper" else 1.0
    soil = pot(b, r * wide, h * (0.5 if kind == "ball" else 0.3), styles=styles)
    green = b.material("body", "leaf", "dark leaf", "silver leaf")
    high = h - soil
    with b.solid("crown"):
        if kind == "ball":
            thick = min(r * 0.7, high / 2.1)
            _ribbed(b, thick, soil - thick * 0.3, h - 0.012, green, 12)
            for n in range(5):
                a = n * 1.257
                with b.frame(0, 0, h - 0.02, yaw=a):
                    petal = _petal(0.03, 0.016, 0.5)
                    look = b.material("flower", "pink petal", "red petal", "yellow petal")
                    b.add(petal, look, [shapes.hull(petal[0])])
            b.ball((0.006, 0.006, 0.006), (0, 0, h - 0.006), "yellow petal", 8)
            return
        thick = min(r * 0.36, high * 0.16)
        _ribbed(b, thick, soil - 0.02, h, green, 9)
        if kind == "arms":
            for side, share in ((1, 0.35), (-1, 0.5)):
                out = r - thick * 0.62
                z = soil + share * high
                tip = min(h * 0.97, z + high * 0.36)
                arm = thick * 0.58
                path = [
                    (0, side * thick * 0.6, z),
                    (0, side * out * 0.8, z + 0.1 * high * 0.3),
                    (0, side * out, z + arm * 1.4),
                    (0, side * out, tip - arm),
                ]
                b.tube(path, arm, green, 10)
                b.ball((arm, arm, arm * 1.2), (0, side * out, tip - arm * 1.1), green, 12)
        for n in range(9):
            a = (n + 0.5) * 2 * math.pi / 9
            for m in range(2, 10):
                z = soil + high * m / 11
                x, y = thick * 1.0 * math.cos(a), thick * 1.0 * math.sin(a)
                b.add(
                    shapes.box((x - 0.003, x + 0.003), (y - 0.003, y + 0.003), (z - 0.003, z + 0.003)),
                    "paper",
                    hulls=[],
                )


def _petal(length: float, width: float, rise: float):
    points, faces = leaves([[0.0, 0.0, 0.0]], 0.0, rise, 0.3, length, width, SMALL, 0.2)
    return points[0], faces


def _ribbed(b: Builder, radius: float, z0: float, z1: float, material, ribs: int) -> None:
    """A column or ball with upright ribs and a round head."""
    tall = z1 - z0
    cap = min(tall * 0.48, radius * 1.2)
    profile = [(radius * 0.82, z0), (radius, z0 + min(cap, tall * 0.3))]
    profile += [(radius * math.cos(a), z1 - cap + cap * math.sin(a)) for a in np.linspace(0.05, 1.4, 6)]
    n = ribs * 2
    shape, faces = shapes.lathe([*profile, (0.0, z1)], n)
    rings = np.arctan2(shape[:, 1], shape[:, 0])
    inner = np.round(rings / (2 * np.pi / n) - 0.5).astype(int) % 2 == 1
    moved = shape.copy()
    moved[inner, :2] *= 0.8
    b.add((moved, faces), material, [shapes.hull(shape)])


@draws("succulent")
def succulent(b: Builder) -> None:
    """A rosette of thick pointed leaves in a small pot."""
    d, w, h = b.size
    soil = pot(b, min(d, w) * 0.46, h * b.uniform("pot height", 0.5, 0.6))
    tone = b.material("leaves", "silver leaf", "pale leaf", "leaf", "pink petal")
    count = 34
    yaw = np.arange(count) * 2.399
    share = np.arange(count) / (count - 1)
    base = np.c_[0.006 * np.cos(yaw), 0.006 * np.sin(yaw), soil + 0.012 * (1 - share)]
    made = leaves(
        base,
        yaw,
        1.45 - 1.25 * share,
        -0.5,
        min(d, w) * (0.16 + 0.34 * share),
        0.026,
        (0.5, 0.9, 1.0, 0.7, 0.06),
        0.3,
        0.004,
    )
    k = Clumps()
    inner = share < 0.5
    k.add((made[0][inner], made[1]), "pale leaf" if b.chance("pale heart", 0.6) else tone, 0)
    k.add((made[0][~inner], made[1]), tone, sectors(yaw[~inner], 4) + 1)
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.004, h))


@draws("bonsai")
def bonsai(b: Builder) -> None:
    """A twisted trunk with pads of leaves over a flat tray on feet."""
    d, w, h = b.size
    rng = randoms(b)
    tray = h * 0.16
    glaze = b.material("tray", "blue ceramic", "terracotta", "grey ceramic", "dark marble")
    tw, td = w * 0.38, min(d * 0.42, w * 0.3)
    with b.solid("pot"):
        for sx in (-1, 1):
            for sy in (-1, 1):
                b.box(
                    *_span(sx * (td - 0.035), sx * (td - 0.012)),
                    *_span(sy * (tw - 0.05), sy * (tw - 0.015)),
                    (0.0, 0.012),
                    glaze,
                )
        b.hull(
            [(sx * td * u, sy * tw * u, z) for sx in (-1, 1) for sy in (-1, 1) for u, z in ((0.9, 0.01), (1.0, tray))],
            glaze,
        )
        b.box((-td * 0.9, td * 0.9), (-tw * 0.92, tw * 0.92), (tray - 0.01, tray + 0.004), "soil", bevel=0.003)
        b.ball((0.018, 0.024, 0.014), (td * 0.4, -tw * 0.55, tray + 0.004), "granite", 10)
    bend = w * 0.12 * (1 if b.chance("lean left", 0.5) else -1)
    spine = np.array(
        [
            (0, -bend * 0.6, tray - 0.01),
            (0.01, bend * 0.5, h * 0.34),
            (-0.01, -bend * 0.7, h * 0.52),
            (0.0, bend * 0.3, h * 0.7),
            (0.0, 0.0, h * 0.84),
        ]
    )
    pads = [
        ((0.0, 0.0, h * 0.86), 0.26),
        ((0.0, bend * 2.6, h * 0.6), 0.24),
        ((0.0, -bend * 2.7, h * 0.68), 0.2),
        ((d * 0.2, bend * 0.4, h * 0.52), 0.18),
        ((-d * 0.2, -bend * 0.6, h * 0.74), 0.18),
    ]
    with b.solid("trunk"):
        made = stem(spine, 0.02 + 0.012 * h, 8)
        b.add(made, "bark", shapes.sweep_hulls(spine, 0.02 + 0.012 * h, 8))
        for at, _ in pads[1:]:
            near = spine[np.argmin(np.linalg.norm(spine - np.array(at), axis=1))]
            b.bar(near, at, 0.006, "bark", 6)
    k = Clumps()
    foliage = b.material("leaves", "leaf", "dark leaf")
    for n, (at, size) in enumerate(pads):
        count = int(260 * size)
        way, turn = crown_points(rng, count)
        points = np.array(at) + way * np.array([size * 0.75, size, 0.1]) * w * 0.75
        made = leaves(points, turn, rng.uniform(0.0, 1.2, count), 0.4, 0.035 + 0.03 * w, 0.03, SMALL, 0.2)
        k.add(made, foliage if n % 2 else "leaf", n)
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (h * 0.42, h))


def _span(a: float, b: float) -> tuple[tuple[float, float]]:
    return ((min(a, b), max(a, b)),)


@draws("orchid")
def orchid(b: Builder) -> None:
    """Two bowed stems with a row of blossoms, and broad leaves at the foot."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.3, h * 0.24, styles=("taper", "cube", "belly"))
    petal = b.material("petals", "white petal", "pink petal", "purple petal", "yellow petal")
    k = Clumps()
    yaw = np.array([0.4, 2.2, 3.6, 5.2, 1.3])
    k.add(leaves(np.tile((0, 0, soil), (5, 1)), yaw, 0.7, 1.2, w * 0.5, w * 0.2, OVAL, 0.25, 0.003), "dark leaf", 0)
    for n, side in enumerate((1, -1) if b.chance("two stems", 0.7) else (1,)):
        t = np.linspace(0, 1, 9)
        path = np.c_[
            0.2 * d * t * (0.5 - n), side * 0.42 * w * t**2.2, soil - 0.01 + (h - soil) * (1.25 * t - 0.3 * t**4)
        ]
        k.shape(stem(path, 0.0035), "leaf", 1 + n)
        for m in range(6):
            at = np.array([np.interp(0.5 + 0.1 * m, t, path[:, c]) for c in range(3)])
            turn = rng.uniform(-0.4, 0.4) + (0.35 if m % 2 else -0.35)
            five = np.arange(5) * 1.2566 + 0.3
            r = w * 0.15
            # Petals stand in a plane that faces the front: drawn flat, then turned up.
            flat, faces = leaves(np.zeros((5, 3)), five, 0.25, 0.3, r * 0.62, r * 0.5, (0.3, 1.0, 0.8, 0.15), 0.1)
            up = flat[..., [2, 1, 0]] * np.array([1, -1, 1])
            c, s = math.cos(turn), math.sin(turn)
            up = np.stack([up[..., 0] * c - up[..., 1] * s, up[..., 0] * s + up[..., 1] * c, up[..., 2]], axis=-1)
            k.add((up + at + np.array([0.012, 0, -0.01]), faces), petal, 1 + n)
            k.shape(
                shapes.ball((0.006, 0.005, 0.006), tuple(at + np.array([0.02, 0, -0.01])), 6), "yellow petal", 1 + n
            )
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.01, h))


@draws("flower_vase")
def flower_vase(b: Builder) -> None:
    """A bunch of roses, tulips or daisies with leaves, in a vase of glass or glaze."""
    d, w, h = b.size
    rng = randoms(b)
    look = b.material("vase", "white ceramic", "blue ceramic", "glass", "cream ceramic", "terracotta", "grey ceramic")
    r, tall = min(d, w) * 0.23, h * 0.46
    shape = b.pick(
        "vase shape",
        [
            [(0.7, 0), (0.75, 0.02), (1.0, 0.35), (0.85, 0.65), (0.5, 0.84), (0.62, 1.0)],
            [(0.75, 0), (0.8, 0.02), (0.72, 0.4), (0.95, 1.0)],
            [(0.6, 0), (0.95, 0.2), (1.0, 0.42), (0.7, 0.72), (0.46, 0.8), (0.5, 1.0)],
        ],
    )
    with b.solid("vase"):
        outer = [(r * u, tall * v) for u, v in shape]
        lip = outer[-1][0] - 0.005
        b.lathe([*outer, (lip, tall), (lip * 0.9, tall * 0.86)], look, 24, hollow=True)
    petal = b.material(
        "petals", "red petal", "pink petal", "yellow petal", "white petal", "purple petal", "orange petal"
    )
    kind = b.pick("flowers", ["rose", "daisy", "tulip"])
    count = b.whole("count", 9, 13)
    k = Clumps()
    for n in range(count):
        a, u = n * 2.399, math.sqrt((n + 0.3) / count)
        tip = np.array([0.36 * d * u * math.cos(a), 0.36 * w * u * math.sin(a), h * (0.93 - 0.24 * u * u)])
        foot = np.array([0.012 * math.cos(a), 0.012 * math.sin(a), tall * 0.8])
        middle = foot * 0.5 + tip * 0.5 + np.array([0, 0, 0.04 * u])
        k.shape(stem([foot, middle, tip], 0.0028, 5), "leaf", n % 6)
        out = np.array([math.cos(a), math.sin(a)]) * u * 0.6
        size = min(d, w) * rng.uniform(0.11, 0.14) * (1.0 if kind == "daisy" else 1.3)
        color = petal if n % 3 else ("white petal" if kind != "daisy" else petal)
        for made, look_of in _blossom(kind, size, color):
            points = made[0] @ _tilt(out).T + tip
            k.add((points, made[1]), look_of, n % 6)
        k.add(
            leaves(middle[None], a + 1.0, 0.7, 1.0, 0.26 * h, 0.03 + 0.02 * h, OVAL),
            "leaf" if n % 2 else "dark leaf",
            n % 6,
        )
    with b.solid("flowers"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (tall * 0.78, h))


def _tilt(out: np.ndarray) -> np.ndarray:
    """The turn that leans a blossom outward."""
    z = np.array([out[0], out[1], 1.0])
    z /= np.linalg.norm(z)
    x = np.cross([0.0, 1.0, 0.0], z)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z], axis=1)


def _blossom(kind: str, size: float, petal) -> list:
    """A blossom about z at the origin: its leaves and finishes."""
    zero = np.zeros((1, 3))
    if kind == "daisy":
        a = np.arange(11) * 2 * np.pi / 11
        heart = leaves(
            np.tile(zero, (6, 1)) + [0, 0, 0.004],
            np.arange(6) * 1.047,
            0.35,
            0.8,
            size * 0.4,
            size * 0.36,
            SMALL,
            0.0,
            0.008,
            rib=False,
        )
        return [
            (leaves(np.tile(zero, (11, 1)), a, 0.15, 0.3, size, size * 0.4, (0.4, 1.0, 0.3), 0.1), petal),
            (heart, "yellow petal"),
        ]
    if kind == "tulip":
        a = np.arange(6) * 1.047
        return [
            (
                leaves(
                    np.tile(zero, (6, 1)),
                    a,
                    0.5 + 0.15 * (np.arange(6) % 2),
                    -1.3,
                    size * 1.15,
                    size * 0.75,
                    (0.5, 1.0, 0.95, 0.15),
                    0.2,
                ),
                petal,
            )
        ]
    rows = [(5, 0.35, -0.9, 0.95), (5, 0.75, -0.8, 0.9), (4, 1.1, -0.5, 0.8), (3, 1.4, -0.2, 0.7)]
    return [
        (
            leaves(
                np.tile(zero, (c, 1)),
                np.arange(c) * 2 * np.pi / c + 0.6 * i,
                rise,
                bend,
                size * long,
                size * 0.85,
                (0.4, 1.0, 0.9, 0.4),
                0.15,
            ),
            petal,
        )
        for i, (c, rise, bend, long) in enumerate(rows)
    ]


@draws("herb_pot")
def herb_pot(b: Builder) -> None:
    """A bushy kitchen herb in a small pot."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.38, h * 0.42, styles=("taper", "rim", "cube"))
    kind = b.pick("herb", ["basil", "chives", "rosemary"])
    green = b.material(
        "leaves", *{"basil": ("leaf", "pale leaf"), "chives": ("leaf",), "rosemary": ("silver leaf", "dark leaf")}[kind]
    )
    k = Clumps()
    _bush(k, rng, kind, green, soil, h, min(d, w))
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.01, h))


def _bush(k: Clumps, rng, kind: str, green, soil: float, h: float, wide: float) -> None:
    if kind == "chives":
        count = 90
        yaw = rng.uniform(0, 2 * np.pi, count)
        out = rng.uniform(0, 0.22, count) * wide
        base = np.c_[out * np.cos(yaw), out * np.sin(yaw), np.full(count, soil - 0.008)]
        k.add(
            leaves(
                base,
                yaw,
                rng.uniform(1.2, 1.55, count),
                0.4,
                (h - soil) * rng.uniform(0.7, 1.0, count),
                0.005,
                (1, 1, 0.2),
                0.0,
                0.003,
                rib=False,
            ),
            green,
            sectors(yaw, 4),
        )
        return
    stems = 14
    for n in range(stems):
        a, u = n * 2.399, math.sqrt((n + 0.5) / stems)
        foot = np.array([0.2 * wide * u * math.cos(a), 0.2 * wide * u * math.sin(a), soil - 0.008])
        tip = np.array([0.4 * wide * u * math.cos(a), 0.4 * wide * u * math.sin(a), h - 0.3 * u * (h - soil)])
        k.shape(stem([foot, tip], 0.0022, 5), "leaf", n % 5)
        rows = 5 if kind == "basil" else 9
        t = np.repeat(np.linspace(0.3, 1.0, rows), 2)
        yaw = a + np.arange(2 * rows) * 1.5708 + np.repeat(np.arange(rows), 2) * 0.8
        size = (wide * 0.2, wide * 0.14) if kind == "basil" else (wide * 0.16, 0.005)
        k.add(
            leaves(
                foot + t[:, None] * (tip - foot),
                yaw,
                0.5,
                0.8,
                size[0] * rng.uniform(0.7, 1.1, 2 * rows),
                size[1],
                (0.3, 1.0, 0.8, 0.06),
                0.25,
            ),
            green if n % 3 else "leaf",
            n % 5,
        )


@draws("small_plant")
def small_plant(b: Builder) -> None:
    """A little leafy plant for desk or shelf: upright oval leaves, or a fountain of stripes."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.34, h * b.uniform("pot height", 0.38, 0.46))
    green = b.material("leaves", "leaf", "dark leaf", "pale leaf")
    kind = b.pick("kind", ["oval", "spider", "heart"])
    k = Clumps()
    count = 34 if kind == "spider" else 30
    yaw = np.arange(count) * 2.399
    share = np.arange(count) / count
    base = np.c_[0.012 * np.cos(yaw), 0.012 * np.sin(yaw), np.full(count, soil - 0.006)]
    if kind == "spider":
        made = leaves(
            base, yaw, 1.5 - 0.8 * share, 1.6 + 0.5 * share, (h - soil) * 1.5, 0.018, (0.8, 1, 0.9, 0.7, 0.1), 0.3
        )
        stripe = leaves(
            base + [0, 0, 0.0012],
            yaw,
            1.5 - 0.8 * share,
            1.6 + 0.5 * share,
            (h - soil) * 1.48,
            0.006,
            (0.8, 1, 0.9, 0.7, 0.1),
            0.3,
            0.003,
        )
        k.add(stripe, "paper", sectors(yaw))
        k.add(made, green, sectors(yaw))
    else:
        long = (h - soil) * rng.uniform(0.35, 0.8, count)
        rise = 1.5 - 0.9 * share
        tips = base + long[:, None] * np.c_[np.cos(yaw) * np.cos(rise), np.sin(yaw) * np.cos(rise), np.sin(rise)]
        for n in range(count):
            k.shape(stem([base[n], tips[n]], 0.002, 5), green, int(sectors(yaw[n : n + 1])[0]))
        k.add(
            leaves(tips, yaw, rise - 0.5, 0.9, w * 0.3, w * 0.17, BROAD if kind == "heart" else OVAL),
            green,
            sectors(yaw),
        )
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.006, h))


@draws("hanging_plant")
def hanging_plant(b: Builder) -> None:
    """A pot in three cords from a hook, with tendrils that hang far down."""
    d, w, h = b.size
    rng = randoms(b)
    r = min(d, w) * 0.32
    low, high = h * 0.36, h * 0.36 + r * 1.5
    with b.frame(z=low):
        soil = low + pot(b, r, r * 1.5, styles=("belly", "taper"))
    cord = b.material("cord", "cork", "black steel", "brass", "white fabric")
    with b.solid("cords"):
        for n in range(3):
            a = n * 2.094 + 0.5
            b.bar((r * 0.94 * math.cos(a), r * 0.94 * math.sin(a), high - 0.02), (0, 0, h - 0.04), 0.0035, cord, 6)
        b.frustum(0.012, 0.02, (h - 0.05, h), cord, 12)
    green = b.material("leaves", "leaf", "pale leaf", "dark leaf")
    k = Clumps()
    vines = 13
    for n in range(vines):
        a = n * 2.399
        drop = rng.uniform(0.35, 1.0) * soil
        out = r * rng.uniform(1.05, 1.3)
        way = np.array([math.cos(a), math.sin(a), 0.0])
        path = np.array(
            [
                way * r * 0.4 + [0, 0, soil],
                way * r * 0.85 + [0, 0, soil + 0.05],
                way * out + [0, 0, soil - 0.02],
                way * out * 1.08 + [0, 0, soil - drop * 0.5],
                way * out + [0, 0, soil - drop],
            ]
        )
        k.shape(stem(path, 0.0025, 5), "leaf", n % 6)
        t = np.linspace(0.5, 4.0, 11)
        at = np.stack([np.interp(t, np.arange(5), path[:, c]) for c in range(3)], axis=1)
        yaw = a + np.where(np.arange(11) % 2, 0.9, -0.9) + rng.uniform(-0.3, 0.3, 11)
        k.add(leaves(at, yaw, 0.2, 1.4, rng.uniform(0.05, 0.075, 11), 0.05, (0.35, 1.0, 0.8, 0.05), 0.25), green, n % 6)
    count = 26
    yaw = np.arange(count) * 2.399
    out = r * 0.5 * np.sqrt(np.arange(count) / count)
    base = np.c_[out * np.cos(yaw), out * np.sin(yaw), np.full(count, soil)]
    k.add(leaves(base, yaw, rng.uniform(0.5, 1.3, count), 1.0, 0.12, 0.06, BROAD), green, 6)
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (0.0, min(soil + 0.1, h - 0.1)))


@draws("terrarium")
def terrarium(b: Builder) -> None:
    """Little plants, stones and moss under glass: a dome, or a house of panes with brass edges."""
    r, h = b.size.width / 2, b.size.height
    rng = randoms(b)
    metal = b.material("frame", "brass", "black steel", "copper", "light oak")
    floor = h * 0.2
    kind = b.pick("kind", ["dome", "house"])
    with b.solid("glass"):
        if kind == "dome":
            b.frustum(r, r, (0.0, 0.018), metal, 28, bevel=0.004)
            curve = [
                ((r - 0.008) * math.cos(a), h * 0.5 + (h * 0.5 - 0.02) * math.sin(a)) for a in np.linspace(0, 1.5, 7)
            ]
            b.lathe([(r - 0.008, 0.018), *curve, (0.0, h - 0.02)], "glass", 28)
            b.ball((0.012, 0.012, 0.012), (0, 0, h - 0.012), metal, 10)
            b.frustum(r - 0.014, r - 0.014, (0.018, floor), "soil", 24)
        else:
            k, eave = r - 0.004, h * 0.62
            b.box((-k, k), (-k, k), (0.004, eave), "glass", bevel=0.0)
            b.hull(
                [(sx * k, sy * k, eave) for sx in (-1, 1) for sy in (-1, 1)]
                + [(0.0, -k, h - 0.005), (0.0, k, h - 0.005)],
                "glass",
            )
            for sy in (-1, 1):
                y = sy * k
                for sx in (-1, 1):
                    b.bar((sx * k, y, 0.004), (sx * k, y, eave), 0.004, metal, 6)
                    b.bar((sx * k, y, eave), (0, y, h - 0.005), 0.004, metal, 6)
                for z in (0.004, eave):
                    b.bar((-k, y, z), (k, y, z), 0.004, metal, 6)
            for x, z in ((-k, 0.004), (k, 0.004), (-k, eave), (k, eave), (0.0, h - 0.005)):
                b.bar((x, -k, z), (x, k, z), 0.004, metal, 6)
            b.box((-k + 0.006, k - 0.006), (-k + 0.006, k - 0.006), (0.008, floor), "soil", bevel=0.0)
        k = Clumps()
        count = 40
        yaw = np.arange(count) * 2.399
        spot = np.array([(0.25, 0.2), (-0.3, 0.25), (-0.05, -0.35), (0.3, -0.25)])[np.arange(count) % 4] * r
        base = np.c_[spot, np.full(count, floor - 0.003)]
        made = leaves(
            base, yaw, rng.uniform(0.5, 1.4, count), 0.7, (h - floor) * rng.uniform(0.25, 0.5, count), 0.022, OVAL
        )
        for n, name in enumerate(("leaf", "pale leaf", "dark leaf", "silver leaf")):
            k.add((made[0][np.arange(count) % 4 == n], made[1]), name, n)
        reach = r * 0.6
        k.draw(b, (-reach, reach), (-reach, reach), (floor - 0.003, floor + (h - floor) * 0.5))
        for x, y, s in ((0.45, 0.0, 0.13), (-0.42, -0.1, 0.1), (0.0, 0.45, 0.08)):
            b.ball((s * r, s * r * 1.2, s * r * 0.8), (x * r, y * r, floor), "granite", 8)
