"""What grows: leaves, bark, soil, cork and moss."""

from __future__ import annotations

import numpy as np

from ..noise import blurred, cells, field, grid, spread, step
from ..registry import pattern
from ..relief import Relief


@pattern("leaf", (0.10, 0.06), kind="leaf", grain=True, pixels=256)
def _leaf(n: int) -> Relief:
    """A middle vein along u with veins to both sides, and a net between them."""
    u, v = grid(n)
    v = v - 0.5
    middle = np.exp(-((v / 0.010) ** 2))
    side = np.mod(u * 8 - np.abs(v) * 6.0, 1.0) - 0.5
    veins = np.exp(-((side / 0.06) ** 2)) * (1.0 - step(0.36, 0.5, np.abs(v)))
    net = 1.0 - step(0.0, 0.012, cells(n, 601, 26).border)
    light = np.clip(0.9 * middle + 0.55 * veins + 0.18 * net, 0.0, 1.0)
    tone = 1.0 + 0.10 * field(n, 603, 0.25, 1.8)
    tint = tone[:, :, None] * (1.0 + light[:, :, None] * np.array([0.45, 0.30, 0.30]))
    height = 1.5e-4 * blurred(-light, 0.006) + 6e-5 * blurred(step(0.0, 0.03, np.abs(side)), 0.01)
    return Relief(tint, height, 1.0 + 0.1 * light)


@pattern("bark", (0.4, 0.2), kind="wood", grain=True, pixels=256)
def _bark(n: int) -> Relief:
    """Ridges along u with deep dark furrows."""
    ridge = field(n, 611, (0.35, 0.06), 1.5)
    furrow = 1.0 - step(0.0, 0.55, np.abs(ridge))
    rough = field(n, 613, (0.03, 0.012), 1.1)
    tint = (1.0 + 0.16 * rough + 0.12 * ridge) * (1.0 - 0.62 * furrow)
    return Relief(np.clip(tint, 0.05, None), 2.5e-3 * (0.3 * rough - furrow), 1.0 + 0.05 * rough)


@pattern("soil", (0.2, 0.2), pixels=256)
def _soil(n: int) -> Relief:
    """Crumbs of several sizes."""
    height = np.zeros((n, n))
    tint = np.ones((n, n))
    for seed, rows, share in ((621, 18, 1.0), (623, 40, 0.5)):
        near = cells(n, seed, rows)
        crumb = np.clip(1.0 - near.first * rows * 1.1, 0.0, 1.0) ** 0.6
        height += 2e-3 * share * crumb
        tint *= 0.45 + (0.55 + 0.5 * spread(near.number, seed + 1)) * crumb
    return Relief(tint, height, np.ones((n, n)))


@pattern("cork", (0.2, 0.2), pixels=256)
def _cork(n: int) -> Relief:
    """Pressed granules, some dark."""
    near = cells(n, 631, 34)
    tone = spread(near.number, 633)
    tint = 0.78 + 0.34 * tone - 0.30 * (tone < 0.10) + 0.06 * field(n, 635, 0.01, 1.0)
    seam = 1.0 - step(0.0, 0.006, near.border)
    return Relief(tint * (1.0 - 0.25 * seam), -1.5e-4 * seam, np.ones((n, n)))


@pattern("grass", (0.5, 0.5), kind="leaf")
def _grass(n: int) -> Relief:
    """A lawn from above, or moss: short blades in all directions."""
    blade = field(n, 641, (0.03, 0.006), 1.1) + field(n, 643, (0.006, 0.03), 1.1) + field(n, 645, 0.008, 1.0)
    patch = field(n, 647, 0.2, 1.5)
    tone = np.clip(1.0 + 0.24 * blade + 0.05 * patch, 0.15, None)
    return Relief(tone[:, :, None] * (1 + 0.06 * patch[:, :, None] * np.array([1, 0.2, -1])), 4e-3 * blade / 3)
