"""Stone, concrete, tiles and bricks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..noise import Cells, blurred, cells, field, grid, spread, step, warped
from ..registry import pattern
from ..relief import Relief


def _veins(n: int, seed: int, wave: float, width: float) -> np.ndarray:
    """Thin bent lines of uneven strength, in 0..1."""
    bend = 0.03 * field(n, seed, 0.16, 1.2), 0.03 * field(n, seed + 1, 0.16, 1.2)
    level = warped(field(n, seed + 2, (wave, 0.6 * wave), 2.6), *bend)
    slope = np.hypot(np.gradient(level, axis=0), np.gradient(level, axis=1)) * n
    strength = step(-0.6, 1.4, field(n, seed + 3, 0.25))
    line = np.exp(-np.abs(level) / np.maximum(slope, 0.8 * float(slope.mean())) / (width * (0.4 + 0.6 * strength)))
    return line * (0.15 + 0.85 * strength)


@pattern("marble", (1.2, 1.2), kind="stone")
def _marble(n: int) -> Relief:
    """White marble with grey veins and clouds."""
    veins = 0.50 * _veins(n, 201, 0.7, 0.006) + 0.30 * _veins(n, 211, 0.35, 0.0035) + 0.22 * _veins(n, 217, 0.8, 0.035)
    cloud = 0.045 * field(n, 221, 0.3, 1.7)
    dark = np.clip(veins + cloud + 0.02, 0.0, 0.85)
    tint = 1.0 - dark[:, :, None] * np.array([0.56, 0.53, 0.48])
    return Relief(tint, np.zeros((n, n)), 1.0 + 0.15 * veins)


@pattern("dark marble", (1.2, 1.2), kind="stone")
def _dark_marble(n: int) -> Relief:
    """Dark marble with white veins."""
    veins = _veins(n, 233, 1.2, 0.005) + 0.5 * _veins(n, 243, 0.7, 0.0025) + 0.35 * _veins(n, 247, 0.4, 0.0018)
    tint = 1.0 + 0.10 * field(n, 251, 0.2, 1.6) + 1.7 * np.clip(veins, 0.0, 1.0)
    return Relief(tint, np.zeros((n, n)), 1.0 + 0.1 * veins)


@pattern("travertine", (1.0, 1.0), kind="stone")
def _travertine(n: int) -> Relief:
    """Bands along u with small holes in rows."""
    bands = field(n, 261, (0.7, 0.05), 1.6) + 0.4 * field(n, 263, (0.3, 0.012), 1.3)
    holes = step(1.5, 2.2, field(n, 267, (0.016, 0.006), 2.0)) * step(0.2, 1.4, bands)
    tint = (1.0 + 0.075 * bands)[:, :, None] * (1.0 - 0.45 * holes[:, :, None] * np.array([0.8, 0.9, 1.0]))
    return Relief(tint, -6e-4 * holes, 1.0 + 0.6 * holes)


def _chips(n: int, seed: int, rows: int, fill: float) -> tuple[np.ndarray, Cells]:
    """Where angular chips lie, in 0..1, and the cells that they are in."""
    near = cells(n, seed, rows)
    size = 0.15 + 0.85 * spread(near.number, seed + 1)
    inside = near.border * rows - (0.46 - 0.42 * fill * size)
    return step(-0.02, 0.03, inside) * (spread(near.number, seed + 2) < 0.55 + 0.45 * fill), near


@pattern("terrazzo", (0.6, 0.6), kind="stone")
def _terrazzo(n: int) -> Relief:
    """Chips of several stones and sizes in a pale ground, polished."""
    tint = np.ones((n, n, 3)) * (1.0 + 0.012 * field(n, 271, 0.004, 1.0))[:, :, None]
    colours = np.array(
        [[0.36, 0.34, 0.33], [0.72, 0.55, 0.42], [0.80, 0.78, 0.74], [0.55, 0.57, 0.55], [1.12, 1.10, 1.06]]
    )
    for seed, rows, fill in ((281, 64, 0.75), (291, 32, 0.9), (301, 18, 0.95)):
        chip, near = _chips(n, seed, rows, fill)
        pick = np.minimum((spread(near.number, seed + 3) * len(colours)).astype(int), len(colours) - 1)
        colour = colours[pick] * (0.9 + 0.2 * spread(near.number, seed + 4))[:, :, None]
        tint = tint + chip[:, :, None] * (colour - tint)
    return Relief(tint, np.zeros((n, n)), np.ones((n, n)))


@pattern("granite", (0.4, 0.4), kind="stone")
def _granite(n: int) -> Relief:
    """Crystals of dark mica, grey quartz and pale feldspar."""
    bend = 0.006 * field(n, 311, 0.02), 0.006 * field(n, 312, 0.02)
    tint = np.zeros((n, n, 3))
    colours = np.array([[0.18, 0.18, 0.19], [0.75, 0.74, 0.73], [1.15, 1.10, 1.04], [1.35, 1.34, 1.32]])
    for seed, rows, share in ((313, 60, 0.55), (317, 110, 0.45)):
        near = cells(n, seed, rows)
        kind = spread(near.number, seed + 1)
        pick = np.digitize(kind, [0.20, 0.50, 0.80])
        layer = colours[pick] * (0.88 + 0.24 * spread(near.number, seed + 2))[:, :, None]
        tint += share * np.stack([warped(layer[:, :, k], *bend) for k in range(3)], 2)
    tint *= (1.0 + 0.05 * field(n, 319, 0.2))[:, :, None]
    return Relief(tint, np.zeros((n, n)), np.ones((n, n)))


@pattern("quartz", (0.5, 0.5), kind="stone")
def _quartz(n: int) -> Relief:
    """Pale composite with a fine grain and faint clouds."""
    tint = 1.0 + 0.03 * field(n, 321, 0.004, 1.2) + 0.025 * field(n, 323, 0.3, 1.8)
    return Relief(tint, np.zeros((n, n)), np.ones((n, n)))


@pattern("concrete", (1.5, 1.5), kind="stone")
def _concrete(n: int) -> Relief:
    """Smooth concrete: clouds, fine sand and some pores."""
    cloud = 0.6 * field(n, 331, 0.35, 1.5) + 0.4 * field(n, 333, 0.06, 1.4)
    sand = field(n, 337, 0.003, 0.8)
    pore = step(2.5, 3.0, field(n, 339, 0.007, 2.4))
    tint = (1.0 + 0.065 * cloud + 0.02 * sand) * (1.0 - 0.5 * pore)
    return Relief(tint, 1.2e-4 * cloud + 4e-5 * sand - 1.2e-3 * pore, 1.0 + 0.08 * cloud)


@pattern("limestone", (1.0, 1.0), kind="stone")
def _limestone(n: int) -> Relief:
    """Soft clouds, small fossils, a sandy face."""
    cloud, sand = field(n, 341, 0.25, 1.5), field(n, 343, 0.003, 0.9)
    fossil = step(1.9, 2.5, np.abs(field(n, 347, (0.018, 0.010), 2.2)))
    tint = 1.0 + 0.045 * cloud + 0.03 * sand + 0.07 * fossil
    return Relief(tint, 1e-4 * cloud + 5e-5 * sand, np.ones((n, n)))


@pattern("slate", (1.0, 1.0), kind="stone")
def _slate(n: int) -> Relief:
    """Split slate: flat layers that end in steps."""
    level = 2.2 * field(n, 351, (0.5, 0.3), 2.0) + 0.5 * field(n, 353, 0.05, 1.5)
    layer = np.floor(level) + step(0.88, 1.0, level - np.floor(level))
    fine = field(n, 357, (0.03, 0.01), 1.2)
    tint = 1.0 + 0.06 * blurred(layer, 0.002) / 2 + 0.06 * field(n, 359, 0.2) + 0.03 * fine
    return Relief(np.clip(tint, 0.4, 2.0), 6e-4 * layer + 6e-5 * fine, 1.0 + 0.05 * fine)


def _tiled(n: int, size: float, edge: np.ndarray, number: np.ndarray, seed: int, joint: float, **more: float) -> Relief:
    """Glazed tiles: ``edge`` is the distance [m] to the border of each, half a ``joint`` [m] of which is grout."""
    soft = 0.8 * size / n
    face = step(joint / 2 - soft / 2, joint / 2 + soft, edge)
    pillow = 1.0 - np.exp(-np.clip(edge - joint / 2, 0.0, None) / 0.0022)
    tone = 1.0 + more.get("tone", 0.03) * (2 * spread(number, seed) - 1) + more.get("cloud", 0.01) * field(n, seed, 0.1)
    sand = field(n, seed + 2, 0.003, 0.8)
    wave = more.get("wave", 0.0) * field(n, seed + 3, 0.05, 2.5)
    grout = more.get("grout", 0.62) * (1.0 + 0.05 * sand)
    height = face * (7e-4 + 5e-4 * pillow + wave) + (1 - face) * 4e-5 * sand
    rough = face + (1 - face) * more.get("rough", 2.6)
    return Relief(face * tone + (1 - face) * grout, height, rough, shade=0.15, reach=0.006)


@pattern("square tiles", (1.2, 1.2), kind="stone")
def _square(n: int) -> Relief:
    """Floor tiles of 0.3 m with joints of 3 mm."""
    u, v = grid(n)
    i, j = np.floor(u * 4), np.floor(v * 4)
    x, y = (u * 4 - i) * 0.3, (v * 4 - j) * 0.3
    edge = np.minimum(np.minimum(x, 0.3 - x), np.minimum(y, 0.3 - y))
    return _tiled(n, 1.2, edge, i * 4 + j, 401, 0.004, tone=0.035, cloud=0.018, grout=0.66)


@pattern("large tiles", (1.2, 1.2), kind="stone")
def _large(n: int) -> Relief:
    """Stone slabs of 0.6 m with narrow joints and clouds."""
    u, v = grid(n)
    i, j = np.floor(u * 2), np.floor(v * 2)
    x, y = (u * 2 - i) * 0.6, (v * 2 - j) * 0.6
    edge = np.minimum(np.minimum(x, 0.6 - x), np.minimum(y, 0.6 - y))
    return _tiled(n, 1.2, edge, i * 2 + j, 411, 0.0032, tone=0.02, cloud=0.035, grout=0.72)


@pattern("wall tiles", (0.6, 0.6), kind="stone")
def _wall(n: int) -> Relief:
    """Glazed tiles of 0.15 m with joints of 2 mm."""
    u, v = grid(n)
    i, j = np.floor(u * 4), np.floor(v * 4)
    x, y = (u * 4 - i) * 0.15, (v * 4 - j) * 0.15
    edge = np.minimum(np.minimum(x, 0.15 - x), np.minimum(y, 0.15 - y))
    return _tiled(n, 0.6, edge, i * 4 + j, 421, 0.0026, tone=0.018, wave=2.5e-5, grout=0.74)


@pattern("metro tiles", (0.6, 0.6), kind="stone")
def _metro(n: int) -> Relief:
    """Glazed tiles of 0.2 m by 0.1 m in running bond."""
    u, v = grid(n)
    j = np.floor(v * 6)
    along = u * 3 + 0.5 * (j % 2)
    i = np.floor(along)
    x, y = (along - i) * 0.2, (v * 6 - j) * 0.1
    edge = np.minimum(np.minimum(x, 0.2 - x), np.minimum(y, 0.1 - y))
    return _tiled(n, 0.6, edge, (i % 3) * 6 + j, 431, 0.0026, tone=0.022, wave=6e-5, grout=0.70)


@pattern("hexagon tiles", (0.6, 0.52), kind="stone")
def _hexagon(n: int) -> Relief:
    """Hexagons of 0.1 m across in rows."""
    from scipy.spatial import KDTree

    u, v = grid(n)
    pitch, rows = 0.1, 6
    points = np.array([[(i + 0.5 * (j % 2)) * pitch, j * 0.52 / rows] for j in range(rows) for i in range(6)])
    tree = KDTree(points, boxsize=[0.6, 0.52])
    near, number = (np.asarray(x) for x in tree.query(np.stack([u.ravel() * 0.6, v.ravel() * 0.52], 1), k=2))
    edge = ((near[:, 1] - near[:, 0]) * 0.55).reshape(n, n)
    return _tiled(n, 0.6, edge, number[:, 0].reshape(n, n), 441, 0.003, tone=0.05, grout=0.6)


def _bond(
    v: np.ndarray, along: Callable[[np.ndarray], np.ndarray], columns: int, size: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray]:
    """Eight courses of blocks: how far [m] each texel is from the edge of its block, and the block's number.

    Args:
        v: up the wall, 0 to 1.
        along: by the number of a course how many blocks there are to the left, shifted from course to course.
        columns: blocks of a course.
        size: width and height of a block with its joint [m].
    """
    j = np.floor(v * 8)
    left = along(j)
    i = np.floor(left)
    x, y = (left - i) * size[0], (v * 8 - j) * size[1]
    edge = np.minimum(np.minimum(x, size[0] - x), np.minimum(y, size[1] - y))
    return edge, np.mod(i, columns) * 8 + np.mod(j, 8)


@pattern("rubble", (2.4, 1.6), kind="stone", pixels=1024)
def _rubble(n: int) -> Relief:
    """Roughly hewn blocks of about 0.4 m by 0.2 m, each in a tone of its own, with wide joints."""
    u, v = grid(n)
    u = u + 0.009 * field(n, 461, 0.12, 1.8)
    v = v + 0.014 * field(n, 462, 0.12, 1.8)
    edge, number = _bond(v, lambda j: u * 6 + 0.38 * np.mod(j * 3, 8) / 1.9, 6, (0.4, 0.2))
    face = step(0.006, 0.02, edge)
    tone, warm = spread(number, 463) - 0.5, spread(number, 464) - 0.5
    sand, cloud = field(n, 467, 0.006, 0.9), field(n, 468, 0.08, 1.5)
    shade = 1.0 + 0.38 * tone + 0.10 * cloud + 0.06 * sand
    stone = shade[:, :, None] * (1.0 + warm[:, :, None] * np.array([0.08, 0.0, -0.12]))
    tint = face[:, :, None] * stone + (1 - face)[:, :, None] * (0.62 + 0.08 * sand)[:, :, None]
    height = face * (7e-3 + 1.5e-3 * cloud) + 4e-4 * sand
    return Relief(tint, height, 1.0 + 0.05 * sand, shade=0.1, reach=0.012)


@pattern("brick", (1.0, 0.6), kind="stone")
def _brick(n: int) -> Relief:
    """Bricks of 0.24 m by 67 mm in running bond with sandy mortar."""
    u, v = grid(n)
    u = u + 0.0016 * field(n, 451, 0.04, 1.6)
    v = v + 0.0030 * field(n, 452, 0.04, 1.6)
    edge, number = _bond(v, lambda j: u * 4 + 0.5 * (np.mod(j, 2)), 4, (0.25, 0.075))
    face = step(0.0045, 0.0065, edge)
    tone, warm = spread(number, 453) - 0.5, spread(number, 454) - 0.5
    sand, cloud = field(n, 457, 0.005, 0.9), field(n, 458, 0.06, 1.5)
    shade = 1.0 + 0.42 * tone + 0.07 * cloud + 0.05 * sand
    clay = shade[:, :, None] * (1.0 + warm[:, :, None] * np.array([0.06, -0.14, -0.20]))
    mortar = (1.55 + 0.10 * sand)[:, :, None] * np.array([0.66, 1.85, 2.7])
    tint = face[:, :, None] * clay + (1 - face)[:, :, None] * mortar
    height = face * (2.2e-3 + 2e-4 * cloud) + 1.5e-4 * sand
    return Relief(tint, height, 1.0 + 0.05 * sand, shade=0.06, reach=0.006)
