"""Wicker and rattan: rods that go around stakes, strips that go over and under."""

from __future__ import annotations

import numpy as np

from ..noise import field, grid, spread
from ..registry import pattern
from ..relief import Relief


def _around_stakes(n: int, rods: int, stakes: int, seed: int, tone: float) -> Relief:
    """Rods along u that pass before and behind upright stakes, each row the other way."""
    u, v = grid(n)
    row = np.floor(v * rods)
    across = np.mod(v * rods, 1.0) - 0.5
    phase = np.pi * (u * stakes + row)
    before = np.cos(phase)
    rod = np.sqrt(np.clip(1.0 - (across / 0.5) ** 2, 0.0, 1.0)) * (0.5 + 0.5 * before)
    x = np.mod(u * stakes + 0.0, 1.0) - 0.5
    stake = 0.52 * np.sqrt(np.clip(1.0 - (x / 0.22) ** 2, 0.0, 1.0)) * (before < 0.25)
    height = np.maximum(rod, stake)
    fibre = field(n, seed, (0.08, 0.006), 1.2)
    shade = spread(row, seed + 1) - 0.5
    gap = 0.22 + 0.78 * np.clip(height * 1.5, 0.0, 1.0)
    tint = (gap * (1.0 + 0.09 * fibre + tone * shade))[:, :, None] * (
        1.0 + 0.10 * shade[:, :, None] * np.array([0.0, -0.5, -1.0])
    )
    return Relief(tint, 2.6e-3 * height + 3e-5 * fibre, 1.15 - 0.15 * height)


@pattern("wicker", (0.16, 0.16), kind="fabric")
def _wicker(n: int) -> Relief:
    """Willow rods of 5 mm around stakes."""
    return _around_stakes(n, 32, 8, 1201, 0.28)


@pattern("rattan", (0.12, 0.12), kind="fabric")
def _rattan(n: int) -> Relief:
    """Split rattan: flat strips over and under in pairs."""
    u, v = grid(n)
    count = 24
    i, j = np.floor(u * count), np.floor(v * count)
    x, y = u * count - i - 0.5, v * count - j - 0.5
    over = np.mod(np.floor(i / 2) + np.floor(j / 2), 2) == 0
    flat = lambda d: np.clip(1.0 - np.abs(d / 0.47) ** 6, 0.0, 1.0)  # noqa: E731
    rise_u = np.cos(np.pi * (np.mod(u * count / 2, 1.0) - 0.5)) ** 0.4
    rise_v = np.cos(np.pi * (np.mod(v * count / 2, 1.0) - 0.5)) ** 0.4
    height = np.where(over, flat(y) * rise_u, flat(x) * rise_v)
    fibre = np.where(over, field(n, 1211, (0.08, 0.005), 1.1), field(n, 1213, (0.005, 0.08), 1.1))
    tone = np.where(over, spread(j, 1215), spread(i, 1217)) - 0.5
    tint = (0.30 + 0.70 * height) * (1.0 + 0.08 * fibre + 0.20 * tone)
    return Relief(tint, 9e-4 * height + 2e-5 * fibre, 1.2 - 0.2 * height)
