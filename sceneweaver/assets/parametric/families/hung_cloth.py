"""What hangs from hooks and rails: towels, coats, garments on hangers, and rails to hang things from."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.drawing import Look

DYES = "grey fabric, navy fabric, beige fabric, rust fabric, green fabric, white fabric, rose fabric, charcoal fabric"
"""Cloths of clothes."""


def _fall(d: Drawing, box: Box, cloth: Look, widths: tuple[tuple[float, float], ...], folds: float) -> None:
    """Cloth that falls in folds down a box: ``widths`` are shares of its width at shares of its height from the top."""
    thick = min(0.4 * box.depth, 0.03)
    deep = 0.5 * (box.depth - thick)
    across, phase = np.linspace(-1.0, 1.0, 17), d.uniform("fold", 0.0, 6.3)
    rows = []
    for share, width in widths:
        wave = deep * min(1.0, 0.25 + share) * np.sin(folds * across + phase)
        # to the full height: the top of the cloth is where it is held
        rows.append(np.c_[box.center[0] + wave, box.center[1] + 0.5 * box.width * width * across,
                          np.full(17, box.z[1] - share * box.height)])  # fmt: skip
    d.sheet(np.array(rows), thick, cloth, (1, 4))


@draws("hung_towel", whole=True)
def hung_towel(d: Drawing) -> None:
    """A towel that hangs flat, with a woven stripe at its hem."""
    cloth = d.material("cloth", "white fabric, grey fabric, beige fabric, navy fabric, green fabric, rose fabric")
    box = d.bounds
    _fall(d, box, cloth, ((0.0, 1.0), (0.3, 1.0), (0.7, 1.0), (1.0, 1.0)), 5.0)
    with d.no_colliders():
        stripe = box.share(x=(0.3, 0.7), z=(0.09, 0.13))
        d.box(stripe, "white fabric" if not cloth.called("white fabric") else "grey fabric", bevel=0.0)


@draws("hung_coat", whole=True)
def hung_coat(d: Drawing) -> None:
    """A coat that hangs by its loop: narrow at the collar, two sleeves, a placket with buttons."""
    cloth, box = d.material("cloth", DYES), d.bounds
    _fall(d, box, cloth, ((0.0, 0.22), (0.07, 0.5), (0.16, 0.78), (0.55, 0.82), (1.0, 0.9)), 7.0)
    with d.mirror("y"):
        arm = box.share(x=(0.25, 0.75), y=(0.84, 1.0), z=(0.32, 0.86))
        d.box(arm, cloth, bevel=0.02)
    with d.no_colliders():
        for k in range(4):
            z = box.z[0] + (0.3 + 0.15 * k) * box.height
            d.ball(Box.around((box.x[1] - 0.012, box.center[1] + 0.02, z), 0.016, 0.022, 0.022), "charcoal fabric", 8)


@draws("hung_garment", whole=True)
def hung_garment(d: Drawing) -> None:
    """A shirt or dress on a hanger with a hook."""
    cloth, box = d.material("cloth", DYES), d.bounds
    hook, top = 0.07, box.z[1]
    x, y, _ = box.center
    low = box.to(z=(box.z[0], top - hook))
    _fall(d, low, cloth, ((0.0, 0.3), (0.08, 0.7), (0.14, 1.0), (0.4, 0.86), (1.0, 0.96)), 8.0)
    d.bar((x, y, top - hook - 0.01), (x, y, top), 0.004, "chrome", 6)
    with d.no_colliders(), d.mirror("y"):
        end = y + 0.42 * box.width
        d.bar((x, y, top - hook + 0.005), (x, end, top - hook - 0.14 * low.height), 0.006, "oak", 6)


@draws("bare_hanger", whole=True)
def bare_hanger(d: Drawing) -> None:
    """A clothes hanger with nothing on it."""
    wood, box = d.material("wood", "oak, walnut, white plastic, black plastic"), d.bounds
    (x, y, _), top, drop = box.center, box.z[1], 0.45 * box.height
    d.bar((x, y, top), (x, y, top - drop), 0.004, "chrome", 6)
    with d.mirror("y"):
        d.bar((x, y, top - drop), (x, box.y[1] - 0.008, box.z[0] + 0.008), 0.008, wood, 8)
    d.bar((x, box.y[0] + 0.008, box.z[0] + 0.008), (x, box.y[1] - 0.008, box.z[0] + 0.008), 0.005, wood, 8)


@draws("wall_rail", whole=True)
def wall_rail(d: Drawing) -> None:
    """A round rail on two or three brackets before the wall."""
    metal, box = d.material("rail", "black steel, brass, steel, oak, chrome"), d.bounds
    radius = min(0.016, box.height / 4)
    x, z = box.x[1] - radius, box.z[1] - radius
    d.bar((x, box.y[0], z), (x, box.y[1], z), radius, metal, 14)
    for y in np.linspace(box.y[0] + 0.05, box.y[1] - 0.05, 3 if box.width > 1.3 else 2).tolist():
        d.bar((box.x[0] + 0.004, y, z), (x, y, z), 0.8 * radius, metal, 8)
        with d.at(box.x[0], y, z - 0.2 * radius, pitch=math.pi / 2):
            side = min(0.05, 1.4 * box.height)
            d.cylinder(Box.sized(side, side, 0.008), metal, segments=18)


@draws("cut_flowers", whole=True)
def cut_flowers(d: Drawing) -> None:
    """A bunch of stems that spread to their blossoms."""
    petals = d.material("petals", "blush pigment, ochre pigment, terracotta pigment, sea pigment")
    stem, box = d.material("stem", "moss pigment"), d.bounds
    (x, y, _), low, high = box.center, box.z[0], box.z[1]
    spread = 0.5 * min(box.depth, box.width) - 0.025
    for k in range(9):
        turn, far = 2.4 * k, spread * math.sqrt((k + 0.5) / 9)
        top = high - 0.03 - 0.05 * d.uniform(f"low {k}", 0.0, 1.0) * (k > 0)
        at = (x + far * math.cos(turn), y + far * math.sin(turn), top)
        d.bar((x + 0.2 * (at[0] - x), y + 0.2 * (at[1] - y), low), at, 0.004, stem, 6)
        d.ball(Box.around(at, 0.045, 0.045, 0.055), petals, 10)


@draws("rolled_mat", whole=True)
def rolled_mat(d: Drawing) -> None:
    """A mat that is rolled up, with the spiral of its end."""
    foam, box = d.material("foam", "blue plastic, green plastic, pink plastic, grey plastic"), d.bounds
    roll = d.cylinder(box, foam, "y", bevel=0.004, segments=24)
    _, y, z = roll.anchor("left")
    turns = np.linspace(0, 8 * np.pi, 65)
    radius = (0.1 + 0.8 * turns / turns[-1]) * 0.5 * min(box.depth, box.height)
    with d.no_colliders():
        line = np.c_[box.center[0] + radius * np.cos(turns), np.full(65, y - 0.001), z + radius * np.sin(turns)]
        d.sweep(line, 0.0012, "charcoal fabric", 4)


@draws("umbrella", whole=True)
def umbrella(d: Drawing) -> None:
    """A closed umbrella on its tip: furled cloth and a handle."""
    cloth = d.material("cloth", "black fabric, navy fabric, red fabric, green fabric, charcoal fabric")
    wood, box = d.material("handle", "walnut, oak, black plastic"), d.bounds
    d.turned(box, [(0.12, 0.0), (0.3, 0.06), (0.55, 0.12), (1.0, 0.5), (0.8, 0.68), (0.3, 0.7)], cloth, 14)
    d.turned(box, [(0.2, 0.68), (0.2, 0.9), (0.42, 0.92), (0.42, 0.99), (0.2, 1.0)], wood, 12)
