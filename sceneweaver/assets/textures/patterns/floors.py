"""Floors of wood: boards and parquet in several patterns."""

from __future__ import annotations

import numpy as np

from ..noise import grid, step
from ..registry import pattern
from ..relief import Relief
from .woods import plank


def _laid(n: int, size: float, x: np.ndarray, y: np.ndarray, board: tuple[float, float], number: np.ndarray) -> Relief:
    """Boards: ``x`` along and ``y`` across each [m], whose length and width are ``board``; joints where they meet."""
    wood = plank(n, x, y, number, 17)
    edge = np.minimum(np.minimum(x, board[0] - x), np.minimum(y, board[1] - y))
    pixel, width = size / n, 0.0014
    wide = max(width, 0.9 * pixel)
    gap = (1.0 - step(0.3 * wide, wide, edge)) * min(1.0, 1.3 * width / wide)
    bevel = 1.0 - step(0.0, 0.004, edge)
    rough = np.ones((n, n)) if wood.roughness is None else wood.roughness
    return Relief(wood.tint * (1.0 - 0.6 * gap)[:, :, None], wood.height - 3e-4 * gap - 2e-4 * bevel, rough + 0.3 * gap)


def _rows(n: int, size: tuple[float, float], rows: int, each: int, seed: int) -> Relief:
    """Rows of ``each`` boards, moved against each other."""
    u, v = grid(n)
    row = np.floor(v * rows).astype(int)
    rng = np.random.default_rng(seed)
    move = (np.arange(rows) * 0.382 + 0.1 * rng.random(rows)) % 1.0
    along = u * each + move[row]
    board = np.floor(along).astype(int)
    length, width = size[0] / each, size[1] / rows
    x, y = (along - board) * length, (v * rows - row) * width
    return _laid(n, size[1], x, y, (length, width), row * each + board % each)


@pattern("floorboards", (2.4, 1.44), kind="wood", pixels=1024)
def _floorboards(n: int) -> Relief:
    """Wide boards of 0.18 m by 1.2 m."""
    return _rows(n, (2.4, 1.44), 8, 2, 5)


@pattern("strip parquet", (1.5, 1.05), kind="wood", pixels=1024)
def _strip(n: int) -> Relief:
    """Strips of 70 mm by 0.5 m."""
    return _rows(n, (1.5, 1.05), 15, 3, 7)


@pattern("herringbone", (1.44, 1.44), kind="wood", pixels=1024)
def _herringbone(n: int) -> Relief:
    """Blocks of 90 mm by 0.36 m, set at right angles to each other in steps."""
    (u, v), width, long = grid(n), 0.09, 4
    across = 16
    i, j = np.floor(u * across).astype(int), np.floor(v * across).astype(int)
    fx, fy = u * across - i, v * across - j
    step_ = np.mod(i - j, 2 * long)
    flat = step_ < long
    rest = 2 * long - 1 - step_
    x = np.where(flat, step_ + fx, rest + fy) * width
    y = np.where(flat, fy, fx) * width
    first = np.where(flat, i - step_, i) % across, np.where(flat, j, j - rest) % across
    number = (first[0] * across + first[1]) * 2 + flat
    return _laid(n, 1.44, x, y, (long * width, width), number)


@pattern("basket weave", (1.2, 1.2), kind="wood", pixels=1024)
def _basket(n: int) -> Relief:
    """Squares of five strips of 60 mm, every other one turned."""
    (u, v), side = grid(n), 0.30
    i, j = np.floor(u * 4).astype(int), np.floor(v * 4).astype(int)
    fx, fy = (u * 4 - i) * side, (v * 4 - j) * side
    turned = (i + j) % 2 == 1
    x, across = np.where(turned, fy, fx), np.where(turned, fx, fy)
    strip = np.floor(across / 0.06).astype(int)
    return _laid(n, 1.2, x, across - strip * 0.06, (side, 0.06), (i * 4 + j) * 5 + strip)
