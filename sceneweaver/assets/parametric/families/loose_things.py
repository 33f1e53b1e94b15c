"""What lies about, in heaps and flat on the ground: leaves, shavings, petals, shards, coal, clothes, spills, tape."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws
from .hung_cloth import DYES
from .small_parts import GOLDEN

FLAT = 0.00044
"""How high [m] what lies flat on a floor is: furniture stands on the floor through it, see rugs."""

Outline = list[tuple[float, float]]

LEAF: Outline = [(-1, 0), (-0.6, 0.34), (-0.1, 0.5), (0.4, 0.36), (1, 0), (0.4, -0.36), (-0.1, -0.5), (-0.6, -0.34)]
MAPLE: Outline = [(-1, 0.06), (-0.45, 0.1), (-0.6, 0.7), (-0.1, 0.45), (0.2, 0.95), (0.35, 0.35), (1, 0), (0.35, -0.35),
                  (0.2, -0.95), (-0.1, -0.45), (-0.6, -0.7), (-0.45, -0.1), (-1, -0.06)]  # fmt: skip
PETAL: Outline = [(-1, 0), (-0.5, 0.6), (0.3, 0.8), (0.9, 0.4), (0.7, 0), (0.9, -0.4), (0.3, -0.8), (-0.5, -0.6)]
SHARD: Outline = [(-1, -0.3), (-0.2, 0.7), (1, 0.2), (0.3, -0.5)]
SCRAP: Outline = [(-1, -0.7), (-0.95, 0.75), (0.2, 0.6), (1, 0.8), (0.9, -0.65), (0.1, -0.75)]
STRAW: Outline = [(-1, -0.05), (-1, 0.05), (1, 0.05), (1, -0.05)]
FEATHER: Outline = [(-1, 0.03), (-0.5, 0.05), (-0.4, 0.2), (0.2, 0.26), (0.75, 0.16), (1, 0), (0.75, -0.16),
                    (0.2, -0.26), (-0.4, -0.2), (-0.5, -0.05), (-1, -0.03)]  # fmt: skip
CURL: Outline = [
    *[(math.cos(t), math.sin(t)) for t in np.linspace(0.0, 4.6, 9)],
    *[(0.68 * math.cos(t), 0.68 * math.sin(t)) for t in np.linspace(4.6, 0.0, 9)],
]

SCATTERED: dict[str, tuple[tuple[Outline, ...], str, tuple[float, float], int]] = {
    "dead_leaves": (
        (LEAF, MAPLE),
        "rust fabric, ochre pigment, terracotta pigment, bark, chocolate",
        (0.03, 0.055),
        95,
    ),
    "flower_petals": ((PETAL,), "red petal, pink petal, white petal", (0.016, 0.028), 110),
    "confetti": ((SCRAP, PETAL), "red paint, yellow paint, blue paint, green paint, pink plastic", (0.008, 0.014), 150),
    "wood_shavings": ((CURL,), "beech, pine, light oak, birch", (0.02, 0.045), 110),
    "broken_glass": ((SHARD,), "frosted glass, glass, crystal", (0.015, 0.06), 60),
    "paper_scraps": ((SCRAP,), "paper, chalk pigment, white paint, cream paint", (0.03, 0.09), 50),
    "feathers": ((FEATHER,), "white petal, chalk pigment, icing, grey fabric", (0.04, 0.075), 60),
    "loose_straw": ((STRAW,), "mustard fabric, ochre pigment, sand pigment", (0.06, 0.15), 150),
    "fabric_scraps": ((SCRAP, SHARD), DYES, (0.03, 0.07), 70),
}
"""What lies scattered: outlines of its pieces, their finishes, half their lengths [m], and how many there are."""


def _places(d: Drawing, count: int) -> list[tuple[float, float, float]]:
    """Places about the middle of the bounds, closer together there, each with a turn; nearly all of them inside."""
    found = []
    for k in range(count):
        out = ((k + 0.5) / count) ** 0.62 + d.uniform(f"out {k}", -0.06, 0.06)
        turn = GOLDEN * k + d.uniform(f"way {k}", -0.5, 0.5)
        x, y = 0.5 * out * d.size.depth * math.cos(turn), 0.5 * out * d.size.width * math.sin(turn)
        found.append((x, y, d.uniform(f"turn {k}", 0.0, 2 * math.pi)))
    return found


@draws(*SCATTERED, whole=True)
def scattered(d: Drawing) -> None:
    """Many small flat pieces, denser in the middle, each turned as it fell."""
    outlines, finishes, (least, most), count = SCATTERED[d.category.name]
    d.material("body", finishes)
    looks = finishes.split(", ")
    high = d.size.height
    count = round(count * min(3.0, max(0.4, d.size.depth * d.size.width / 0.9)))
    for k, (x, y, turn) in enumerate(_places(d, count)):
        long = d.uniform(f"long {k}", least, most)
        c, s = math.cos(turn), math.sin(turn)
        outline = outlines[k % len(outlines)]
        plan = [(x + long * (c * u - s * v), y + long * (s * u + c * v)) for u, v in outline]
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(plan, [*plan[1:], plan[0]], strict=True))
        look = d.material("body", finishes) if k % len(looks) == 0 else d.pick(f"look {k}", looks)
        with d.convex():
            d.extrude(plan if area > 0 else plan[::-1], (0.0, high * (0.5 + 0.5 * (k + 1) / count)), look)
    d.fit()


def _blot(d: Drawing, name: str, size: float, wide: float = 1.0) -> Outline:
    """The outline of a puddle."""
    turns = np.linspace(0, 2 * math.pi, 28, endpoint=False)
    a, b = d.uniform(f"{name} a", 0, 6.3), d.uniform(f"{name} b", 0, 6.3)
    r = size * (0.8 + 0.13 * np.sin(2 * turns + a) + 0.07 * np.sin(5 * turns + b))
    return list(zip((r * np.cos(turns)).tolist(), (wide * r * np.sin(turns)).tolist(), strict=True))


@draws("puddle", "spill", whole=True)
def puddle(d: Drawing) -> None:
    """A pool with a few drops around it."""
    wet = "frosted glass, clear plastic" if d.category.name == "puddle" else "grape, smoked glass, coffee"
    look, high = d.material("body", wet), d.size.height
    d.extrude(_blot(d, "pool", 0.42 * d.size.depth, d.size.width / d.size.depth), (0.0, high), look)
    for k in range(5):
        turn, out = d.uniform(f"t{k}", 0, 6.3), d.uniform(f"o{k}", 0.44, 0.49)
        size = d.uniform(f"s{k}", 0.01, 0.03) * min(1.0, 2 * d.size.depth)
        drop = [(u + out * d.size.depth * math.cos(turn), v + out * d.size.width * math.sin(turn))
                for u, v in _blot(d, f"drop {k}", size)]  # fmt: skip
        d.extrude(drop, (0.0, high), look)
    d.fit()


@draws("floor_tape", "chalk_line", whole=True)
def floor_tape(d: Drawing) -> None:
    """A line on the floor: of tape, its strips torn off at their ends, or of chalk, a little broken."""
    box = d.bounds
    if d.category.name == "floor_tape":
        look = d.material("body", "yellow paint, red paint, blue paint, green paint, white paint, black paint")
        for cell in box.split("y", max(1, round(box.width / 0.9))):
            jag = [(0, 0), (0.3, 0.006), (0.5, 0), (0.8, 0.008), (1, 0)]
            d.silhouette(cell, [*jag, *[(x, 1 - y) for x, y in jag[::-1]]], look, "z")
        return
    look = d.material("body", "chalk pigment")
    for k, cell in enumerate(box.split("y", max(4, round(box.width / 0.12)))):
        thin = d.uniform(f"thin {k}", 0.0, 0.3)
        d.box(cell.share(x=(thin, 1.0 - d.uniform(f"edge {k}", 0.0, 0.2)), y=(0.0, 0.985)), look, 0.0)
    d.fit()


@draws("chalk_outline", whole=True)
def chalk_outline(d: Drawing) -> None:
    """The outline of a person who lay there, drawn on the floor."""
    look, box = d.material("body", "chalk pigment, white paint"), d.bounds
    half = [(0.0, 0.99), (0.09, 0.985), (0.16, 0.94), (0.16, 0.88), (0.08, 0.83), (0.22, 0.8), (0.48, 0.9), (0.5, 0.84),
            (0.28, 0.7), (0.2, 0.55), (0.24, 0.4), (0.36, 0.08), (0.3, 0.02), (0.2, 0.08), (0.04, 0.4)]  # fmt: skip
    line = [*half, *[(-x, y) for x, y in half[:0:-1]]]
    path = [box.point(0.5 + 0.96 * x, 0.01 + 0.98 * y, 0.5) for x, y in line]
    for a, b in zip(path, [*path[1:], path[0]], strict=True):
        d.bar(a, b, (0.018, box.height), look)
    d.fit()


HEAPED: dict[str, tuple[str, float, float]] = {
    "sawdust_heap": ("bread crumb, sand pigment", 0.0, 0.0),
    "sand_heap": ("sand pigment", 0.0, 0.0),
    "soil_heap": ("soil", 0.02, 0.35),
    "snow_heap": ("icing", 0.0, 0.0),
    "gravel_heap": ("grey ceramic, concrete, limestone", 0.035, 1.0),
    "coal_heap": ("black plastic, ink pigment", 0.04, 1.0),
    "rubble_heap": ("concrete, terracotta, limestone, grey paint", 0.06, 1.0),
    "coin_heap": ("gold, brass", 0.012, 1.0),
    "bone_heap": ("cream ceramic, cream wool", 0.1, 1.0),
    "potato_heap": ("ochre pigment, sand pigment", 0.042, 1.0),
    "paper_balls": ("paper, white paint", 0.035, 1.0),
}
"""What lies in heaps: finishes, half the size [m] of a piece, and the share of the surface that pieces cover."""


@draws(*HEAPED, whole=True)
def heaped(d: Drawing) -> None:
    """A heap: a low dome, covered with the pieces that it is of."""
    finishes, piece, covered = HEAPED[d.category.name]
    look, box = d.material("body", finishes), d.bounds
    piece = min(piece, (0.5 if d.category.name == "bone_heap" else 0.3) * box.height)
    inner = box.inset(x=0.5 * piece, y=0.5 * piece, top=0.6 * piece)
    profile = [(1.0, 0.0), (0.82, 0.2), (0.58, 0.55), (0.34, 0.84), (0.14, 0.97), (0.0, 1.0)]
    shape = d.category.name not in ("paper_balls", "bone_heap")
    if shape:
        d.turned(inner, profile, look, 18)
    elif d.category.name == "bone_heap":  # it lies on its dust
        d.cylinder(box.inset(x=0.2 * box.depth, y=0.2 * box.width).bottom(0.003), "sand pigment")
    looks, kind = finishes.split(", "), d.category.name
    count = (
        0
        if not piece
        else min(
            110,
            round(
                covered
                * (2.6 if d.category.name == "bone_heap" else 1.1)
                * box.depth
                * box.width
                / (2.2 * piece * piece)
            ),
        )
    )
    heights = np.interp(np.linspace(0, 1, 40), [r for r, _ in profile[::-1]], [z for _, z in profile[::-1]])
    for k in range(count):
        out = ((k + 0.5) / count) ** 0.5
        turn = GOLDEN * k + d.uniform(f"way {k}", -0.3, 0.3)
        reach = [0.5 * side - piece for side in box.size[:2]]
        x, y = out * reach[0] * math.cos(turn), out * reach[1] * math.sin(turn)
        low = float(np.interp(min(1.0, out * reach[0] / max(1e-6, inner.depth / 2)), np.linspace(0, 1, 40), heights))
        thick = 0.3 * piece if kind == "bone_heap" else 1.6 * piece
        z = low * inner.height if shape else (1 - out) * max(0.0, box.height - thick)
        size = piece * d.uniform(f"size {k}", 0.7, 1.0)
        mine = look if k % 2 == 0 else d.pick(f"look {k}", looks)
        ways = [d.uniform(f"{name}{k}", -0.5, 0.5) for name in ("pitch", "roll")]
        with d.convex(), d.at(x, y, max(0.0, z - 0.35 * size * shape), yaw=d.uniform(f"yaw {k}", 0, 6.3)):
            if kind == "coin_heap":
                with d.at(0, 0, 0.4 * size, pitch=0.6 * ways[0], roll=0.6 * ways[1]):
                    d.cylinder(Box.sized(2 * size, 2 * size, 0.002), mine, segments=12)
            elif kind == "bone_heap":
                r = 0.13 * size
                d.bar((0, -0.8 * size, r), (0, 0.8 * size, r), 0.8 * r, mine, 6)
                for s in (-1, 1):
                    for t in (-1, 1):
                        d.ball(Box.around((t * r, s * 0.85 * size, 1.1 * r), 2.2 * r, 2.2 * r, 2.2 * r), mine, 8)
            elif kind == "paper_balls":
                d.ball(Box.sized(1.8 * size, 1.7 * size, 1.6 * size), mine, 5)
            elif kind == "potato_heap":
                d.ball(Box.sized(2 * size, 1.5 * size, 1.3 * size), mine, 10)
            else:
                dice = [d.uniform(f"corner {k} {n}", 0.55, 1.0) for n in range(14)]
                points = [
                    (
                        size * q * math.cos(0.9 * n),
                        0.8 * size * q * math.sin(0.9 * n),
                        size * q * (0.1 if n % 2 else 1.3),
                    )
                    for n, q in enumerate(dice)
                ]
                d.hull(points, mine)
    d.fit()


def _garment(d: Drawing, box: Box, cloth: Look, name: str) -> None:
    """A garment that fell: crumpled cloth over the floor."""
    n = 13
    turns = np.linspace(0, 2 * math.pi, n, endpoint=False)
    a, b = d.uniform(f"{name} a", 0, 6.3), d.uniform(f"{name} b", 0, 6.3)
    rim = 0.86 + 0.14 * np.sin(3 * turns + a)
    rows = []
    for out, up in ((1.0, 0.0), (0.97, 0.3), (0.72, 0.62), (0.42, 0.8), (0.12, 0.95)):
        z = up * (0.72 + 0.28 * np.sin(4 * turns + b + 5 * out))
        rows.append(np.c_[0.5 * out * rim * np.cos(turns), 0.5 * out * rim * np.sin(turns), z])
    x, y, _ = box.center
    rings = [np.c_[x + r[:, 0] * box.depth, y + r[:, 1] * box.width, box.z[0] + r[:, 2] * box.height] for r in rows]
    d.loft(rings, cloth, convex=True)


@draws("scattered_clothes", whole=True)
def scattered_clothes(d: Drawing) -> None:
    """Clothes where they were dropped: shirts spread flat, jeans with their legs apart, socks."""
    box = d.bounds
    looks = DYES.split(", ")
    w, q = box.width, box.depth
    first = d.material("cloth", DYES)
    with d.at(-0.22 * q, 0.24 * w, yaw=d.uniform("shirt", -0.7, 0.7)):
        flat = 0.3 * box.height
        shirt = [(-0.3, -0.2), (-0.3, 0.2), (0.12, 0.2), (0.04, 0.37), (0.16, 0.42), (0.3, 0.2), (0.3, 0.08), (0.25, 0),
                 (0.3, -0.08), (0.3, -0.2), (0.14, -0.43), (0.02, -0.36), (0.12, -0.2)]  # fmt: skip
        d.extrude([(0.62 * x * 1.05, -0.62 * y * 1.05) for x, y in shirt][::1], (0.0, flat), first, bevel=0.002)
    with d.at(0.2 * q, -0.1 * w, yaw=d.uniform("jeans", -0.5, 0.5) + 1.2):
        jeans = d.pick("denim", ["navy fabric", "blue fabric", "charcoal fabric"])
        for s in (-1, 1):
            leg = [
                (-0.3, s * 0.03),
                (-0.3, s * 0.17),
                (0.05, s * 0.2),
                (0.34, s * 0.3),
                (0.36, s * 0.19),
                (0.1, s * 0.02),
            ]
            d.extrude(leg if s < 0 else leg[::-1], (0.0, 0.4 * box.height), jeans, bevel=0.003)
    for k, (x, y) in enumerate(((0.3, 0.36), (-0.3, -0.32), (0.05, 0.08))):
        own = Box.sized(0.24, 0.27, box.height * (1.0, 0.8, 0.9)[k], (x * q, y * w, 0.0))
        _garment(d, own, d.pick(f"heap {k}", looks), f"heap {k}")
    for k, (x, y) in enumerate(((-0.06, -0.36), (0.38, 0.06))):
        sock = d.pick("sock", ["white fabric", "grey fabric", "red fabric"])
        with d.at(x * q, y * w, yaw=2.0 * k + d.uniform("turn", 0, 3)):
            d.sweep([(-0.08, 0, 0.018), (0.02, 0, 0.018), (0.05, 0.03, 0.018), (0.1, 0.06, 0.018)], (0.07, 0.03), sock)
    d.fit()


@draws("clothes_heap", "crumpled_cloth", whole=True)
def clothes_heap(d: Drawing) -> None:
    """Clothes, or one cloth, thrown on a heap, with sleeves and hems hanging out."""
    box, one = d.bounds, d.category.name == "crumpled_cloth"
    first = d.material("cloth", DYES)
    count = 3 if one else 9
    for k in range(count):
        share = k / count
        wide = 1.0 - 0.55 * share
        size = (0.62 if k else 0.95) * wide
        turn, out = GOLDEN * k, 0.0 if k == 0 else 0.26 * (1.0 - 0.5 * share)
        low = 0.0 if k == 0 else 0.9 * share * box.height * 0.62
        own = Box.sized(size * box.depth, size * box.width, 0.38 * box.height,
                        (out * box.depth * math.cos(turn), out * box.width * math.sin(turn), low))  # fmt: skip
        _garment(d, own, first if one or k == 0 else d.pick(f"cloth {k}", DYES.split(", ")), f"g{k}")
    if not one:
        for k in range(4):
            cloth, a = d.pick(f"sleeve {k}", DYES.split(", ")), 1.5 * k + d.uniform(f"a{k}", 0, 1)
            path = [(t * box.depth * math.cos(a), t * box.width * math.sin(a), z * box.height)
                    for t, z in ((0.1, 0.62), (0.3, 0.48), (0.42, 0.2), (0.5, 0.06))]  # fmt: skip
            d.sweep(path, (0.09, 0.025), cloth)
    d.fit()


@draws("dust_sheet", whole=True)
def dust_sheet(d: Drawing) -> None:
    """A cloth over furniture: its back and seat show through, and it falls in folds to the floor."""
    cloth, box = d.material("cloth", "white cotton, natural linen, white fabric"), d.bounds
    n = 15
    across = np.linspace(-0.5, 0.5, n)
    rows = []
    for x, z, wide in (
        (-0.5, 0.0, 1.0),
        (-0.44, 0.5, 0.92),
        (-0.38, 0.97, 0.84),
        (-0.3, 1.0, 0.8),
        (-0.16, 0.94, 0.8),
        (-0.08, 0.62, 0.84),
        (0.1, 0.56, 0.88),
        (0.34, 0.55, 0.88),
        (0.43, 0.3, 0.94),
        (0.5, 0.0, 1.0),
    ):
        fold = 0.02 * np.sin(across * 40) * (1 - z)
        level = np.where(np.abs(across) > 0.42, z * 0.5, z) if z > 0.5 else np.full(n, z)
        rows.append(np.c_[(x + fold) * box.depth, across * wide * box.width, level * box.height])
    d.sheet(np.array(rows), 0.012, cloth, (3, 2))
    with d.mirror("y"):  # what hangs down at its sides
        side = [(-0.48, 0.0), (-0.36, 0.95), (-0.18, 0.9), (-0.08, 0.6), (0.36, 0.54), (0.48, 0.0)]
        own = box.share(y=(0.88, 0.93))
        d.silhouette(own, [(x + 0.5, z) for x, z in side], cloth, "y")
        for k in range(6):
            x = box.x[0] + (0.08 + 0.15 * k) * box.depth
            tall = (0.8 if k < 2 else 0.5) * box.height
            d.hull(
                [
                    (x, box.y[1] - 0.1 * box.width, tall),
                    (x - 0.05, box.y[1], 0),
                    (x + 0.05, box.y[1], 0),
                    (x + 0.02, box.y[1] - 0.12 * box.width, tall),
                    (x, box.y[1] - 0.14 * box.width, 0),
                ],
                cloth,
            )
    d.fit()
