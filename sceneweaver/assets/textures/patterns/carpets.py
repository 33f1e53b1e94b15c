"""Carpets and rugs."""

from __future__ import annotations

import numpy as np

from ..noise import blurred, cells, field, grid, spread, strands
from ..registry import pattern
from ..relief import Relief


@pattern("loop carpet", (0.25, 0.25), kind="fabric")
def _loop(n: int) -> Relief:
    """Loops of 4 mm in rows, as of office carpet, in mixed yarn."""
    near = cells(n, 901, 62, jitter=0.55)
    loop = np.sqrt(np.clip(1.0 - (near.first * 62 / 0.72) ** 2, 0.0, 1.0))
    yarn = spread(near.number, 903) - 0.5
    tint = (0.42 + 0.58 * loop) * (1.0 + 0.30 * yarn + 0.02 * field(n, 905, 0.15))
    return Relief(tint, 1.4e-3 * loop, np.ones((n, n)))


@pattern("cut pile", (0.4, 0.4), kind="fabric")
def _pile(n: int) -> Relief:
    """Soft carpet: tufts, and patches where the pile leans another way."""
    tuft, lean = field(n, 911, 0.008, 1.1), field(n, 913, 0.22, 1.8)
    return Relief(np.clip(1.0 + 0.16 * tuft + 0.025 * lean, 0.2, None), 7e-4 * tuft, np.ones((n, n)))


@pattern("shaggy", (0.3, 0.3), kind="fabric")
def _shaggy(n: int) -> Relief:
    """Long pile and fur: strands that lie in all directions."""
    hair = blurred(0.75 * strands(n, 921, 0.16, 0.06, 1.6) + 0.5 * strands(n, 923, 0.10, 0.05, 1.6), 0.0012)
    return Relief(np.clip(1.0 + 0.17 * hair, 0.25, None), 3e-4 * hair, np.ones((n, n)))


@pattern("woven rug", (0.8, 0.8), kind="fabric")
def _rug(n: int) -> Relief:
    """Flat weave with bands of lozenges and steps in three tones."""
    u, v = grid(n)
    stitches = 80
    x, y = np.floor(u * stitches), np.floor(v * stitches)
    band, row = np.floor(y / 20), np.mod(y, 20)
    near = np.abs(np.mod(x, 20) - 9.5) / 10 + np.abs(row - 9.5) / 10
    lozenge = np.where(near < 0.32, 2, np.where(near < 0.58, 0, np.where(near < 0.80, 1, 0)))
    chevron = np.mod(np.floor((row + np.abs(np.mod(x, 10) - 4.5)) / 2.5), 2).astype(int)
    pick = np.where(band % 2 == 0, lozenge, chevron * (1 + (np.floor(x / 20) % 2 == 0)))
    pick = np.where((row < 1) | (row > 18), 2, pick)
    tones = np.array([[1.15, 1.12, 1.05], [0.62, 0.58, 0.55], [0.36, 0.38, 0.42]])
    rib = np.abs(np.sin(np.pi * v * stitches)) ** 0.6 * (0.8 + 0.2 * np.abs(np.sin(np.pi * u * stitches)))
    wool = 1.0 + 0.06 * field(n, 931, (0.03, 0.006), 1.0) + 0.05 * field(n, 933, (0.5, 0.012), 1.2)
    return Relief(tones[pick] * ((0.62 + 0.38 * rib) * wool)[:, :, None], 7e-4 * rib, np.ones((n, n)))


@pattern("sisal", (0.2, 0.2), kind="fabric")
def _sisal(n: int) -> Relief:
    """Coarse mats of jute, sisal and seagrass: ribs of twisted cord."""
    u, v = grid(n)
    ribs = 28
    across = np.mod(v * ribs, 1.0) - 0.5
    shift = 0.5 * (np.floor(v * ribs) % 2)
    twist = np.mod(u * 20 + shift + 0.2 * across, 1.0) - 0.5
    cord = np.sqrt(np.clip(1.0 - (across / 0.5) ** 2, 0, 1)) * np.sqrt(np.clip(1.0 - (twist / 0.52) ** 2, 0, 1))
    straw = field(n, 941, (0.03, 0.005), 1.1)
    tone = spread(np.floor(v * ribs) * 100 + np.floor(u * 20 + shift + 0.2 * across) % 20, 943) - 0.5
    tint = (0.40 + 0.60 * cord) * (1.0 + 0.12 * straw + 0.22 * tone)
    return Relief(tint, 1.8e-3 * cord + 6e-5 * straw, np.ones((n, n)))
