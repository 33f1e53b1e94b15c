"""Plants that stand on the floor."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .plants_parts import BROAD, OVAL, Clumps, crown_points, fronds, leaves, pot, randoms, sectors, stem


def _green(b: Builder, *names: str):
    return b.material("leaves", *(names or ("leaf", "dark leaf", "pale leaf")))


def _ball_crown(b, rng, count, size, width, foliage, z0: float, z1: float, outline=OVAL, other=None) -> None:
    """A round crown of leaves that fills the box of the plant between two heights."""
    d, w, _ = b.size
    at, turn = crown_points(rng, count)
    k = Clumps()
    points = at * np.array([d / 2, w / 2, (z1 - z0) / 2]) * 0.86
    rise = rng.uniform(-0.5, 0.5, count) + 0.7 * at[:, 2]
    made = leaves(
        points,
        turn + rng.uniform(-0.5, 0.5, count),
        rise,
        rng.uniform(0.3, 0.9, count),
        size * rng.uniform(0.75, 1.2, count),
        width,
        outline,
    )
    clump = sectors(turn, 6) + 6 * (at[:, 2] > 0)
    shade = rng.uniform(size=count) < 0.35
    k.add((made[0][~shade], made[1]), foliage, clump[~shade])
    if shade.any():
        k.add((made[0][shade], made[1]), other or foliage, clump[shade])
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (z0, z1))


@draws("potted_plant")
def potted_plant(b: Builder) -> None:
    """A ficus with a crown on a stem, a plant of big split leaves on long stalks, or a bush of broad leaves."""
    d, w, h = b.size
    rng = randoms(b)
    kind = b.pick("kind", ["ficus", "split", "broad", "fiddle"])
    high = h * b.uniform("pot height", 0.2, 0.27)
    soil = pot(b, min(d, w) * b.uniform("pot radius", 0.27, 0.33), high)
    green = _green(b)
    if kind in ("ficus", "fiddle"):
        trunks = 1 if kind == "fiddle" else b.whole("trunks", 1, 3)
        z0 = h * (0.4 if kind == "ficus" else 0.36)
        with b.solid("trunk"):
            for n in range(trunks):
                a = n * 2 * math.pi / trunks
                lean = 0.02 if trunks > 1 else 0.0
                b.tube(
                    [
                        (lean * math.cos(a), lean * math.sin(a), soil - 0.03),
                        (0.4 * lean * math.cos(a + 2), 0.4 * lean * math.sin(a + 2), (soil + z0) / 2),
                        (0.06 * d * math.cos(a), 0.06 * d * math.sin(a), z0 + (h - z0) * 0.55),
                    ],
                    0.012 + 0.003 * h,
                    "bark",
                    8,
                )
        if kind == "ficus":
            _ball_crown(b, rng, 170, 0.11, 0.045, green, z0, h, OVAL, "dark leaf")
        else:
            _ball_crown(b, rng, 64, 0.26, 0.16, green, z0, h, (0.2, 0.55, 0.9, 1.0, 0.7, 0.05), "leaf")
        return
    count = 16 if kind == "split" else 30
    yaw = np.arange(count) * 2.399 + rng.uniform(-0.3, 0.3, count)
    lean = np.linspace(0.15, 1.0, count)
    tall = (h - soil) * (1.0 - 0.55 * lean)
    out = 0.3 * min(d, w) * (0.25 + 0.75 * lean)
    tips = np.c_[out * np.cos(yaw), out * np.sin(yaw), soil + tall * 0.85]
    k = Clumps()
    for n in range(count):
        foot = np.array([0.03 * math.cos(yaw[n]), 0.03 * math.sin(yaw[n]), soil - 0.02])
        middle = (
            foot * 0.5
            + tips[n] * 0.5
            - np.array([out[n] * 0.25 * math.cos(yaw[n]), out[n] * 0.25 * math.sin(yaw[n]), 0])
        )
        k.shape(stem([foot, middle, tips[n]], 0.005), green, int(sectors(yaw[n : n + 1])[0]))
    if kind == "split":
        made = _split(tips, yaw, 0.28 * math.sqrt(h), rng)
    else:
        made = [leaves(tips, yaw, rng.uniform(0.1, 0.7, count), 1.1, 0.25 * math.sqrt(h), 0.13, BROAD, 0.3)]
    for n, part in enumerate(made):
        k.add(part, green, sectors(yaw) if len(part[0]) == count else sectors(yaw[n : n + 1]))
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.02, h))


def _split(tips, yaw, length: float, rng) -> list:
    """Heart-shaped leaves cut into fingers: a spine with five pairs of lobes that overlap near it."""
    found = []
    for n in range(len(tips)):
        rise, t = rng.uniform(-0.1, 0.5), np.linspace(0.0, 0.8, 5)
        points = (
            tips[n]
            + length
            * t[:, None]
            * np.array([math.cos(yaw[n]) * math.cos(rise), math.sin(yaw[n]) * math.cos(rise), math.sin(rise) - 0.35])
            * 0.9
        )
        lobe = length * np.array([0.5, 0.62, 0.6, 0.5, 0.38])
        parts = [
            leaves(
                points,
                yaw[n] + sign * np.array([1.9, 1.45, 1.15, 0.85, 0.4]),
                0.25 * rise + 0.1,
                0.6,
                lobe,
                length * 0.26,
                (0.5, 1.0, 1.0, 0.3),
                0.0,
                0.0018,
                rib=False,
            )
            for sign in (-1, 1)
        ]
        found.append((np.concatenate([p for p, _ in parts]), parts[0][1]))
    return found


@draws("palm")
def palm(b: Builder) -> None:
    """Feathered fronds that arch from several canes, or from one trunk with rings."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * b.uniform("pot radius", 0.22, 0.27), h * b.uniform("pot height", 0.17, 0.22))
    green = _green(b, "leaf", "pale leaf", "dark leaf")
    k = Clumps()
    count = b.whole("fronds", 11, 15)
    yaw = np.arange(count) * 2.399
    lift = np.linspace(1.4, 0.75, count)
    trunk = b.chance("trunk", 0.4)
    base = np.zeros((count, 3))
    base[:, 2] = soil + (h * 0.28 if trunk else 0.0)
    long = (h - base[0, 2]) * rng.uniform(0.85, 1.1, count)
    if not trunk:
        base[:, :2] = 0.035 * np.c_[np.cos(yaw), np.sin(yaw)]
    pieces = fronds(base, yaw, lift, np.linspace(0.6, 1.5, count), long, 0.34, 15, 0.05)
    for n, part in enumerate(pieces):
        k.add(part, green, sectors(yaw[n // 3 : n // 3 + 1], 8))
    if trunk:
        with b.solid("trunk"):
            steps = 7
            top = base[0, 2] + 0.03
            for n in range(steps):
                z0, z1 = soil - 0.02 + (top - soil) * n / steps, soil - 0.02 + (top - soil + 0.02) * (n + 1) / steps
                b.frustum(0.026, 0.034, (z0, z1), "bark", 12)
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.005 if not trunk else base[0, 2], h))


@draws("snake_plant")
def snake_plant(b: Builder) -> None:
    """Stiff upright blades with pale edges, out of a pot."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.46, h * b.uniform("pot height", 0.28, 0.36))
    count = b.whole("blades", 13, 20)
    yaw = np.arange(count) * 2.399
    share = np.sqrt((np.arange(count) + 0.5) / count)
    base = np.c_[share * 0.22 * d * np.cos(yaw), share * 0.22 * w * np.sin(yaw), np.full(count, soil - 0.01)]
    rise = 1.5 - 0.3 * share + rng.uniform(-0.06, 0.06, count)
    long = (h - soil) * rng.uniform(0.6, 1.0, count)
    wide = 0.05 + 0.02 * h
    k = Clumps()
    outline = (0.7, 0.95, 1.0, 0.85, 0.6, 0.04)
    # The pale blade lies a little lower in the fold, wider, behind the dark one.
    edge, faces = leaves(base, yaw, rise, 0.06, long, wide, outline, 0.5, 0.002)
    k.add((edge, faces), "pale leaf", sectors(yaw, 4))
    front = leaves(base, yaw, rise, 0.06, long * 0.985, wide * 0.72, outline, 0.5, 0.0045)
    k.add(front, "dark leaf", sectors(yaw, 4))
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil - 0.01, h))


@draws("bamboo_plant")
def bamboo_plant(b: Builder) -> None:
    """Jointed canes with narrow leaves on short twigs."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.34, h * b.uniform("pot height", 0.18, 0.23))
    canes = b.whole("canes", 5, 8)
    k = Clumps()
    with b.solid("canes"):
        for n in range(canes):
            a, out = n * 2.399, 0.03 + 0.05 * math.sqrt(n / canes)
            top = h * rng.uniform(0.72, 0.95)
            foot = np.array([out * math.cos(a), out * math.sin(a), soil - 0.01])
            head = foot + np.array([0.06 * math.cos(a), 0.06 * math.sin(a), top - soil])
            b.bar(foot, head, 0.008, "pale leaf", 8)
            joints = int(top / 0.14)
            for j in range(2, joints):
                p = foot + (head - foot) * j / joints
                k.shape(shapes.ball((0.011, 0.011, 0.005), tuple(p), 8), "leaf", 6 + n)
                if p[2] > soil + 0.3 * (h - soil):
                    yaw = rng.uniform(0, 6.28) + np.arange(4) * 1.6
                    made = leaves(
                        np.repeat(p[None], 4, axis=0), yaw, rng.uniform(0.0, 0.8, 4), 1.0, 0.2, 0.024, OVAL, 0.2
                    )
                    k.add(made, "leaf" if j % 2 else "dark leaf", 6 + n)
    with b.solid("crown"):
        k.draw(b, (-d / 2, d / 2), (-w / 2, w / 2), (soil + 0.25 * (h - soil), h))


@draws("olive_tree")
def olive_tree(b: Builder) -> None:
    """A bent trunk that forks, and a loose crown of small silvery leaves with olives."""
    d, w, h = b.size
    rng = randoms(b)
    soil = pot(b, min(d, w) * 0.3, h * b.uniform("pot height", 0.2, 0.26))
    z0 = h * 0.5
    with b.solid("trunk"):
        fork = soil + (z0 - soil) * 0.8
        b.tube([(0, 0, soil - 0.02), (0.015, 0.01, soil + 0.3 * (fork - soil)), (-0.01, -0.01, fork)], 0.022, "bark", 8)
        for a in (0.3, 2.4, 4.5):
            b.bar(
                (-0.01, -0.01, fork - 0.01),
                (0.18 * d * math.cos(a), 0.18 * w * math.sin(a), z0 + (h - z0) * 0.5),
                0.009,
                "bark",
                7,
            )
    _ball_crown(b, rng, 250, 0.09, 0.026, "silver leaf", z0, h, (0.3, 1.0, 0.9, 0.08), "leaf")


@draws("christmas_tree")
def christmas_tree(b: Builder) -> None:
    """Tiers of branches that hang a little, balls, lights, a star; on a stand."""
    d, w, h = b.size
    rng = randoms(b)
    rx, ry = d / 2, w / 2
    stand = b.material("stand", "oak", "wicker", "iron", "red paint")
    green = _green(b, "dark leaf", "leaf")
    ball = b.material("balls", "red petal", "brass", "blue paint", "white paint", "copper")
    with b.solid("stand"):
        b.lathe([(0.15, 0.0), (0.15, 0.02), (0.13, 0.03), (0.1, 0.11), (0.1, 0.12)], stand, 20)
        b.frustum(0.035, 0.03, (0.11, 0.3), "bark", 12)
    star = 0.12
    low, top = 0.2, h - star * 0.9
    tiers = 11
    k = Clumps()
    for n in range(tiers):
        share = n / tiers
        z = low + (top - low) * (0.1 + 0.9 * share)
        reach = 1.02 - 0.96 * share
        count = max(6, round(22 * (1 - 0.72 * share)))
        yaw = np.arange(count) * 2 * math.pi / count + 0.4 * n
        wide = 0.2 * (0.35 + 0.65 * reach)
        made = leaves(
            np.tile((0.0, 0.0, z), (count, 1)),
            yaw,
            0.12 + rng.uniform(-0.1, 0.1, count),
            0.7,
            reach * rng.uniform(0.9, 1.02, count),
            wide,
            (0.3, 0.8, 1.0, 0.85, 0.1),
            -0.5,
            0.004,
        )
        made[0][..., 0] *= rx
        made[0][..., 1] *= ry
        k.add(made, green if n % 2 else "dark leaf", n // 2)
        for m in range(max(2, count // 4)):
            a, u = yaw[m * 3 % count] + 0.1, reach * 0.86
            at = (u * rx * math.cos(a), u * ry * math.sin(a), z - 0.2 * reach * rx)
            if (m + n) % 3:
                k.shape(shapes.ball((0.028, 0.028, 0.028), at, 8), ball if (m + n) % 2 else "brass", n // 2)
            else:
                k.shape(shapes.ball((0.014, 0.014, 0.018), at, 6), "lamp glow", n // 2)
    with b.solid("crown"):
        k.draw(b, (-rx, rx), (-ry, ry), (low - 0.06, top))
        b.frustum(0.07, 0.01, (h - 0.5, top), green, 10)
    with b.solid("star"):
        points = [
            (u * math.sin(a), top + star * 0.42 + u * math.cos(a))
            for a, u in ((i * math.pi / 5, (0.5 if i % 2 == 0 else 0.2) * star) for i in range(10))
        ]
        star_shape = _upright(np.array(points))
        b.add(star_shape, "brass", [shapes.hull(star_shape[0])])


def _upright(points: np.ndarray):
    """A polygon in the yz plane, 16 mm thick; counter-clockwise seen from the front."""
    flat = (
        points
        if np.sum(points[:, 0] * np.roll(points[:, 1], -1) - points[:, 1] * np.roll(points[:, 0], -1)) > 0
        else (points[::-1])
    )
    vertices, faces = shapes.extrusion(flat, (-0.008, 0.008))
    return vertices[:, [2, 0, 1]], faces


@draws("planter_box")
def planter_box(b: Builder) -> None:
    """A long box on feet, full of ornamental grass and low leaves."""
    d, w, h = b.size
    rng = randoms(b)
    high = h * b.uniform("box height", 0.42, 0.55)
    look = b.material("box", "concrete", "oak", "black steel", "white paint", "walnut", "terracotta", "grey paint")
    with b.solid("pot"):
        for sy in (-1, 1):
            y = sy * (w / 2 - 0.08)
            b.box((-d / 2 + 0.02, d / 2 - 0.02), (y - 0.03, y + 0.03), (0.0, 0.02), look)
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (0.02, high - 0.025), look, bevel=0.004)
        for s in (-1, 1):
            x = s * (d / 2 - 0.01)
            b.box((x - 0.01, x + 0.01), (-w / 2, w / 2), (high - 0.03, high), look)
            y = s * (w / 2 - 0.01)
            b.box((-d / 2 + 0.02, d / 2 - 0.02), (y - 0.01, y + 0.01), (high - 0.03, high), look)
        b.box(
            (-d / 2 + 0.02, d / 2 - 0.02), (-w / 2 + 0.02, w / 2 - 0.02), (high - 0.03, high - 0.02), "soil", bevel=0.0
        )
    count = int(w * 190)
    x = rng.uniform(-0.28, 0.28, count) * d
    y = (np.arange(count) + 0.5) / count * (w - 0.12) - w / 2 + 0.06
    base = np.c_[x, y, np.full(count, high - 0.025)]
    yaw = rng.uniform(0, 2 * np.pi, count)
    tall = (h - high) * rng.uniform(0.55, 1.05, count)
    made = leaves(
        base,
        yaw,
        rng.uniform(1.15, 1.5, count),
        rng.uniform(0.3, 1.1, count),
        tall,
        0.014,
        (0.8, 1.0, 0.8, 0.1),
        0.0,
        0.0016,
        rib=False,
    )
    parts = max(3, round(w / 0.25))
    clump = np.minimum(((y + w / 2) / w * parts).astype(int), parts - 1)
    tone = rng.integers(0, 3, count)
    k = Clumps()
    for n, name in enumerate(("leaf", "pale leaf", "dark leaf")):
        k.add((made[0][tone == n], made[1]), name, clump[tone == n])
    with b.solid("crown"):
        k.draw(b, (-d / 2 + 0.005, d / 2 - 0.005), (-w / 2 + 0.005, w / 2 - 0.005), (high - 0.025, h))
