"""Walls: plaster and wall paint, and wallpapers."""

from __future__ import annotations

import numpy as np

from ..noise import field, grid, step, warped
from ..registry import pattern
from ..relief import Relief


@pattern("plaster", (0.6, 0.6))
def _plaster(n: int) -> Relief:
    """Wall paint put on with a roller: small soft bumps."""
    bump, broad = field(n, 801, 0.010, 2.2), field(n, 803, 0.25, 1.8)
    return Relief(1.0 + 0.006 * bump + 0.008 * broad, 4.5e-5 * bump + 1e-4 * broad, 1.0 + 0.02 * bump)


@pattern("rough plaster", (1.0, 1.0))
def _rough(n: int) -> Relief:
    """Lime plaster with the marks of the trowel."""
    stroke = 1.4 * warped(field(n, 811, (0.20, 0.07), 1.7), 0.02 * field(n, 812, 0.3), 0.025 * field(n, 814, 0.3))
    sand = field(n, 813, 0.003, 0.9)
    return Relief(1.0 + 0.025 * stroke + 0.015 * sand, 3e-4 * stroke + 3e-5 * sand, 1.0 + 0.04 * stroke, shade=0.05)


@pattern("stripes", (0.6, 0.6))
def _stripes(n: int) -> Relief:
    """Wallpaper of stripes 0.1 m wide with thin lines beside them."""
    x = np.mod(grid(n)[0] * 3, 1.0)
    band = step(0.0, 0.006, x) - step(0.5, 0.506, x)
    line = np.exp(-(((x - 0.56) / 0.008) ** 2)) + np.exp(-(((x - 0.94) / 0.008) ** 2))
    fibre = field(n, 821, 0.004, 1.0)
    return Relief(1.0 - 0.20 * band - 0.16 * line + 0.010 * fibre, 8e-6 * fibre + 1e-5 * band, 1.0 - 0.12 * band)


@pattern("dots", (0.3, 0.3))
def _dots(n: int) -> Relief:
    """Wallpaper of dots of 14 mm in a staggered grid."""
    u, v = grid(n)
    x, y = np.mod(u * 4, 1.0) - 0.5, np.mod(v * 4, 1.0) - 0.5
    near = np.minimum(np.hypot(x, y), np.hypot(np.abs(x) - 0.5, np.abs(y) - 0.5))
    dot = 1.0 - step(0.088, 0.10, near)
    fibre = field(n, 831, 0.006, 1.0)
    return Relief(1.0 - 0.30 * dot + 0.010 * fibre, 8e-6 * fibre, np.ones((n, n)))


@pattern("damask", (0.53, 0.71))
def _damask(n: int) -> Relief:
    """Wallpaper with an ornament of leaves, mirrored and staggered, in satin on matt."""
    u, v = grid(n)
    shape = np.zeros((n, n))
    for mu, mv in ((0.0, 0.0), (0.5, 0.5)):
        x, y = np.mod(u + mu, 1.0) - 0.5, np.mod(v + mv, 1.0) - 0.5
        shape = np.maximum(shape, _ornament(np.abs(x) * 0.72, y * 1.0))
    fibre = field(n, 841, 0.004, 1.0)
    return Relief(1.0 - 0.17 * shape + 0.010 * fibre, 2e-5 * shape + 8e-6 * fibre, 1.0 - 0.35 * shape)


def _petal(x: np.ndarray, y: np.ndarray, at: tuple[float, float], long: float, wide: float, turn: float) -> np.ndarray:
    """A pointed leaf from ``at`` in the direction ``turn`` [rad], in 0..1."""
    c, s = np.cos(turn), np.sin(turn)
    a, b = (x - at[0]) * c + (y - at[1]) * s, -(x - at[0]) * s + (y - at[1]) * c
    t = np.clip(a / long, 0.0, 1.0)
    half = wide * np.sin(np.pi * t**0.8) * (1.0 - 0.35 * t)
    inside = np.minimum(half - np.abs(b), np.minimum(a, long - a))
    rib = np.exp(-((b / 0.0035) ** 2)) * (t < 0.85)
    return step(0.0, 0.004, inside) * (1.0 - 0.8 * rib)


def _ornament(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """One half of the ornament, for x >= 0; it is mirrored at x = 0."""
    shape = _petal(x, y, (0.0, -0.02), 0.24, 0.050, np.pi / 2)
    for at, long, wide, turn in (
        ((0.0, -0.04), 0.19, 0.034, 0.95),
        ((0.0, -0.08), 0.20, 0.034, 0.40),
        ((0.0, -0.13), 0.15, 0.028, -0.05),
        ((0.0, -0.18), 0.11, 0.022, -0.45),
        ((0.105, 0.10), 0.10, 0.020, 1.9),
        ((0.15, -0.02), 0.09, 0.018, 1.35),
        ((0.0, -0.34), 0.12, 0.018, 1.1),
        ((0.0, -0.34), 0.07, 0.014, 0.3),
    ):
        shape = np.maximum(shape, _petal(x, y, at, long, wide, turn))
    stem = step(0.0, 0.003, 0.0045 - np.abs(x)) * step(0.0, 0.01, y + 0.36) * (1.0 - step(-0.03, 0.0, y))
    ball = 1.0 - step(0.016, 0.020, np.hypot(x, y - 0.245))
    arc = np.abs(np.hypot(x - 0.0, y + 0.04) - 0.315) - 0.0045
    ogee = step(0.0, 0.003, -arc) * step(0.03, 0.05, x)
    return np.maximum.reduce([shape, stem, ball, 0.6 * ogee])


@pattern("botanical", (0.53, 0.53))
def _botanical(n: int) -> Relief:
    """Wallpaper with sprigs that climb to and fro, leaves in two tones."""
    u, v = grid(n)
    tint = np.ones((n, n, 3))
    for column, lean in ((0.25, 1), (0.75, -1)):
        swing = 0.045 * np.sin(2 * np.pi * (v + 0.25 * column))
        x = np.mod(u - column - lean * swing + 0.5, 1.0) - 0.5
        stem = step(0.0, 0.003, 0.005 - np.abs(x))
        leaves, pale = np.zeros((n, n)), np.zeros((n, n))
        for k in range(8):
            side = 1 if k % 2 == 0 else -1
            y = np.mod(v - k / 8 - 0.06 * column + 0.5, 1.0) - 0.5
            leaf = _petal(side * x, y, (0.0, 0.0), 0.15, 0.030, 0.75)
            if k % 3 == 2:
                pale = np.maximum(pale, leaf)
            else:
                leaves = np.maximum(leaves, leaf)
        for mask, colour in ((stem, (0.50, 0.56, 0.46)), (pale, (0.72, 0.78, 0.64)), (leaves, (0.46, 0.58, 0.44))):
            tint = tint + mask[:, :, None] * (np.array(colour) - tint)
    fibre = field(n, 851, 0.004, 1.0)
    return Relief(tint * (1.0 + 0.012 * fibre[:, :, None]), 8e-6 * fibre, np.ones((n, n)))
