"""Plants that stand on the floor."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, Look, draws
from .plants_parts import BROAD, GOLDEN, OVAL, Foliage, Leaves, around, crown_points, frond, leaves, pot, sectors, stem


def _ball_crown(
    f: Foliage, count: int, size: float, width: float, looks: tuple[Look, Look], low: float, outline=OVAL
) -> None:
    """A round crown of leaves that fills the box of the plant above a height; a third has the second finish."""
    d, rng = f.d, f.rng
    high = d.size.height - low
    at, turn = crown_points(rng, count)
    points = at * np.array([d.size.depth, d.size.width, high]) * 0.43
    rise = rng.uniform(-0.5, 0.5, count) + 0.7 * at[:, 2]
    yaw, long = turn + rng.uniform(-0.5, 0.5, count), size * rng.uniform(0.75, 1.2, count)
    made = leaves(points, yaw, rise, rng.uniform(0.3, 0.9, count), long, width, outline)
    clump = sectors(turn) + 6 * (at[:, 2] > 0)
    shade = rng.uniform(size=count) < 0.35
    for look, only in zip(looks, (~shade, shade), strict=True):
        f.add(made, look, clump, only)
    f.draw((low, d.size.height))


_CROWNS = {  # share of the height where it begins, leaves, their length and width [m], finishes, outline
    "ficus": (0.4, 170, 0.11, 0.045, ("", "dark leaf"), OVAL),
    "fiddle": (0.36, 64, 0.26, 0.16, ("", "leaf"), (0.2, 0.55, 0.9, 1.0, 0.7, 0.05)),
    "olive": (0.5, 250, 0.09, 0.026, ("silver leaf", "leaf"), (0.3, 1.0, 0.9, 0.08)),
}


@draws("potted_plant", "olive_tree")
def potted_plant(d: Drawing) -> None:
    """A ficus, a fiddle leaf fig, an olive that forks, or big split or broad leaves on long stalks."""
    (depth, w, h), f, olive = d.size, Foliage(d), d.category.name == "olive_tree"
    wide, rng, kind = min(depth, w), f.rng, "olive" if olive else d.pick("kind", ["ficus", "split", "broad", "fiddle"])
    soil = pot(d, wide * d.uniform("pot radius", 0.27, 0.33), h * d.uniform("pot height", 0.2, 0.27))
    green = "leaf" if olive else d.material("leaves", "leaf, dark leaf, pale leaf")
    if kind in _CROWNS:
        share, count, size, width, looks, outline = _CROWNS[kind]
        low, trunks = share * h, d.integer("trunks", 1, 3) if kind == "ficus" else 3 if olive else 1
        fork, lean = soil + 0.8 * (low - soil), 0.02 if trunks > 1 and not olive else 0.0
        with d.part("trunk"):
            if olive:
                path = [(0, 0, soil - 0.02), (0.015, 0.01, 0.7 * soil + 0.3 * fork), (-0.01, -0.01, fork)]
                d.sweep(path, 0.022, "bark", 8)
            for a in np.arange(trunks) * (2 * math.pi / trunks) + 0.3 * olive:
                reach, heights = (
                    [lean, 0.4 * lean, 0.06 * depth],
                    [soil - 0.03, (soil + low) / 2, 0.45 * low + 0.55 * h],
                )
                if olive:
                    reach, heights = [0.0, 0.09 * wide, 0.18 * wide], [fork - 0.01, (fork + 0.75 * h) / 2, 0.75 * h]
                thick = 0.009 if olive else 0.012 + 0.003 * h
                d.sweep(around(a + np.array([0, 2 * (not olive), 0]), reach, heights), thick, "bark", 8)
        _ball_crown(f, count, size, width, (looks[0] or green, looks[1]), low, outline)
        return
    count = 16 if kind == "split" else 30
    yaw = np.arange(count) * GOLDEN + rng.uniform(-0.3, 0.3, count)
    lean = np.linspace(0.15, 1.0, count)
    out = 0.3 * wide * (0.25 + 0.75 * lean)
    tips = around(yaw, out, soil + 0.85 * (h - soil) * (1.0 - 0.55 * lean))
    feet = around(yaw, 0.03, soil - 0.02)
    clump = sectors(yaw)
    for foot, tip, back, n in zip(feet, tips, around(yaw, 0.25 * out, 0.0), clump, strict=True):
        f.shape(stem([foot, (foot + tip) / 2 - back, tip], 0.005), green, int(n))
    if kind == "split":
        for tip, turn, n in zip(tips, yaw, clump, strict=True):
            f.add(_split(tip, turn, 0.28 * math.sqrt(h), rng.uniform(-0.1, 0.5)), green, n)
    else:
        f.add(leaves(tips, yaw, rng.uniform(0.1, 0.7, count), 1.1, 0.25 * math.sqrt(h), 0.13, BROAD, 0.3), green, clump)
    f.draw((soil - 0.02, h))


def _split(tip: np.ndarray, yaw: float, length: float, rise: float) -> Leaves:
    """A heart-shaped leaf cut into fingers: a spine with five pairs of lobes that overlap near it."""
    way = np.array([math.cos(yaw) * math.cos(rise), math.sin(yaw) * math.cos(rise), math.sin(rise) - 0.35])
    points = tip + 0.9 * length * np.linspace(0.0, 0.8, 5)[:, None] * way
    lobe, turn = length * np.array([0.5, 0.62, 0.6, 0.5, 0.38]), np.array([1.9, 1.45, 1.15, 0.85, 0.4])
    yaws, points, lobe = np.r_[yaw - turn, yaw + turn], np.r_[points, points], np.r_[lobe, lobe]
    outline = (0.5, 1.0, 1.0, 0.3)
    return leaves(points, yaws, 0.25 * rise + 0.1, 0.6, lobe, 0.26 * length, outline, 0.0, 0.0018, rib=False)


@draws("palm", "fern")
def palm(d: Drawing) -> None:
    """Feathered fronds that arch all around: from several canes, from one trunk with rings, or from a low pot."""
    (depth, w, h), f, fern = d.size, Foliage(d), d.category.name == "fern"
    green, trunk = (
        d.material("leaves", "leaf, pale leaf", *(() if fern else ("dark leaf",))),
        not fern and d.chance("trunk", 0.4),
    )
    if fern:
        soil = pot(d, 0.27 * min(depth, w), h * d.uniform("pot height", 0.36, 0.44), ("taper", "belly", "rim"))
    else:
        soil = pot(d, min(depth, w) * d.uniform("pot radius", 0.22, 0.27), h * d.uniform("pot height", 0.17, 0.22))
    count, head = 20 if fern else d.integer("fronds", 11, 15), soil + (0.28 * h if trunk else 0.0)
    leaflet = (0.22, 11, 0.016) if fern else (0.34, 15, 0.05)
    for n, share in enumerate((np.arange(count) / count).tolist()):
        yaw, long = n * GOLDEN, (h - head) * f.rng.uniform(*((1.0, 1.3) if fern else (0.85, 1.1)))
        base = around(yaw, 0.02 if fern else 0.0 if trunk else 0.035, head)[0]
        rise, bend = (1.45 - 0.8 * share, 1.5 + 0.6 * share) if fern else (1.4 - 0.65 * share, 0.6 + 0.9 * share)
        for k, made in enumerate(frond(base, yaw, rise, bend, long, *leaflet)):
            f.add(made, "leaf" if fern and not k else green, sectors(yaw, 8))
    if trunk:
        with d.part("trunk"):
            for ring in Box.sized(0.068, 0.068, 1.0).to(z=(soil - 0.02, head + 0.03)).rows(7):
                d.cylinder(ring, "bark", ends=(0.76, 1.0), segments=12)
    f.draw((head if trunk else soil - 0.01, h))


@draws("snake_plant")
def snake_plant(d: Drawing) -> None:
    """Stiff upright blades with pale edges, out of a pot."""
    (depth, w, h), f = d.size, Foliage(d)
    soil = pot(d, 0.46 * min(depth, w), h * d.uniform("pot height", 0.28, 0.36))
    count = d.integer("blades", 13, 20)
    yaw, share = np.arange(count) * GOLDEN, np.sqrt((np.arange(count) + 0.5) / count)
    base = around(yaw, 0.22 * share, soil - 0.01) * (depth, w, 1.0)
    rise = 1.5 - 0.3 * share + f.rng.uniform(-0.06, 0.06, count)
    long, wide = (h - soil) * f.rng.uniform(0.6, 1.0, count), 0.05 + 0.02 * h
    outline = (0.7, 0.95, 1.0, 0.85, 0.6, 0.04)
    # The pale blade lies a little lower in the fold, wider, behind the dark one.
    f.add(leaves(base, yaw, rise, 0.06, long, wide, outline, 0.5, 0.002), "pale leaf", sectors(yaw, 4))
    f.add(leaves(base, yaw, rise, 0.06, 0.985 * long, 0.72 * wide, outline, 0.5, 0.0045), "dark leaf", sectors(yaw, 4))
    f.draw((soil - 0.01, h))


@draws("bamboo_plant")
def bamboo_plant(d: Drawing) -> None:
    """Jointed canes with narrow leaves on short twigs."""
    (depth, w, h), f = d.size, Foliage(d)
    rng, soil = f.rng, pot(d, 0.34 * min(depth, w), h * d.uniform("pot height", 0.18, 0.23))
    canes = d.integer("canes", 5, 8)
    for n in range(canes):
        yaw, top = n * GOLDEN, h * rng.uniform(0.72, 0.95)
        foot = around(yaw, 0.03 + 0.05 * math.sqrt(n / canes), soil - 0.01)[0]
        head = foot + around(yaw, 0.06, top - soil)[0]
        with d.part("canes"):
            d.bar(tuple(foot), tuple(head), 0.008, "pale leaf", 8)
        joints = int(top / 0.14)
        for j in range(2, joints):
            p = foot + (head - foot) * j / joints
            f.shape(shapes.ball((0.011, 0.011, 0.005), tuple(p), 8), "leaf", n)
            if p[2] > soil + 0.3 * (h - soil):
                turn, rise = rng.uniform(0, 6.28) + np.arange(4) * 1.6, rng.uniform(0.0, 0.8, 4)
                f.add(leaves([p] * 4, turn, rise, 1.0, 0.2, 0.024, OVAL, 0.2), "leaf" if j % 2 else "dark leaf", n)
    f.draw((soil + 0.25 * (h - soil), h))


@draws("christmas_tree")
def christmas_tree(d: Drawing) -> None:
    """Tiers of branches that hang a little, balls, lights, a star; on a stand."""
    (depth, w, h), f = d.size, Foliage(d)
    rng, plan = f.rng, np.array([depth / 2, w / 2, 1.0])
    stand, green = d.material("stand", "oak, wicker, iron, red paint"), d.material("leaves", "dark leaf, leaf")
    ball = d.material("balls", "red petal, brass, blue paint, white paint, copper")
    with d.part("stand"):
        d.revolve([(0.15, 0.0), (0.15, 0.02), (0.13, 0.03), (0.1, 0.11), (0.1, 0.12)], stand, 20)
        d.cylinder(Box.sized(0.07, 0.07, 0.19, (0.0, 0.0, 0.11)), "bark", ends=(1.0, 0.86), segments=12)
    star, low, tiers = 0.12, 0.2, 11
    top = h - 0.9 * star
    for n in range(tiers):
        z = low + (top - low) * (0.1 + 0.9 * n / tiers)
        reach, count = 1.02 - 0.96 * n / tiers, max(6, round(22 * (1 - 0.72 * n / tiers)))
        yaw = np.arange(count) * 2 * math.pi / count + 0.4 * n
        rise, long = 0.12 + rng.uniform(-0.1, 0.1, count), reach * rng.uniform(0.9, 1.02, count)
        outline, wide = (0.3, 0.8, 1.0, 0.85, 0.1), 0.2 * (0.35 + 0.65 * reach)
        made, faces = leaves(around(yaw, 0.0, z), yaw, rise, 0.7, long, wide, outline, -0.5, 0.004)
        f.add((made * plan, faces), green if n % 2 else "dark leaf", n // 2)
        for m in range(max(2, count // 4)):
            at = tuple((around(yaw[m * 3 % count] + 0.1, 0.86 * reach, z - 0.1 * reach * depth) * plan)[0])
            if (m + n) % 3:
                f.shape(shapes.ball((0.028, 0.028, 0.028), at, 8), ball if (m + n) % 2 else "brass", n // 2)
            else:
                f.shape(shapes.ball((0.014, 0.014, 0.018), at, 6), "lamp glow", n // 2)
    f.draw((low - 0.06, top))
    with d.part("crown"):
        d.cylinder(Box.sized(0.14, 0.14, top - h + 0.5, (0.0, 0.0, h - 0.5)), green, ends=(1.0, 0.15), segments=10)
    with d.part("star"):
        turn = np.arange(10) * math.pi / 5
        points = np.where(np.arange(10) % 2, 0.2, 0.5)[:, None] * np.c_[np.sin(turn), np.cos(turn)]
        d.silhouette(Box.sized(0.016, star, star, (0.0, 0.0, top - 0.08 * star)), points + 0.5, "brass", "x")


@draws("planter_box")
def planter_box(d: Drawing) -> None:
    """A long box on feet, full of ornamental grass."""
    (_, w, h), f = d.size, Foliage(d)
    rng, high = f.rng, h * d.uniform("box height", 0.42, 0.55)
    look = d.material("box", "concrete, oak, black steel, white paint, walnut, terracotta, grey paint")
    box = d.bounds.to(z=(0.02, high))
    with d.part("pot"):
        with d.mirror("y"):
            d.box(box.left(0.06).move(y=-0.05).bottom(-0.02).inset(x=0.02), look)
        d.box(box.inset(top=0.025), look, bevel=0.004)
        rim = box.top(0.03)
        for side in (rim.front(0.02), rim.back(0.02), rim.left(0.02).inset(x=0.02), rim.right(0.02).inset(x=0.02)):
            d.box(side, look)
        d.box(rim.inset(x=0.02, y=0.02, top=0.02), "soil", bevel=0.0)
    count = int(w * 190)
    y = (np.arange(count) + 0.5) / count * (w - 0.12) - w / 2 + 0.06
    base = np.c_[rng.uniform(-0.28, 0.28, count) * d.size.depth, y, np.full(count, high - 0.025)]
    yaw, rise, bend = rng.uniform(0, 2 * np.pi, count), rng.uniform(1.15, 1.5, count), rng.uniform(0.3, 1.1, count)
    tall, tone = (h - high) * rng.uniform(0.55, 1.05, count), rng.integers(0, 3, count)
    made = leaves(base, yaw, rise, bend, tall, 0.014, (0.8, 1.0, 0.8, 0.1), 0.0, rib=False)
    parts = max(3, round(w / 0.25))
    clump = np.minimum(((y + w / 2) / w * parts).astype(int), parts - 1)
    for n, name in enumerate(("leaf", "pale leaf", "dark leaf")):
        f.add(made, name, clump, tone == n)
    f.draw((high - 0.025, h), d.bounds.inset(x=0.005, y=0.005))
