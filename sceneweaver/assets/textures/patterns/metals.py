"""Metals: brushed, polished, hammered and cast."""

from __future__ import annotations

import numpy as np

from ..noise import cells, field, spread, step
from ..registry import pattern
from ..relief import Relief


@pattern("brushed", (0.3, 0.15), kind="metal", grain=True)
def _brushed(n: int) -> Relief:
    """Fine scratches along u."""
    scratch = 0.7 * field(n, 501, (0.4, 0.003), 1.0) + 0.3 * field(n, 503, (0.08, 0.002), 0.8)
    return Relief(1.0 + 0.05 * scratch, 1.6e-6 * scratch, 1.0 + 0.16 * scratch)


@pattern("polished", (0.4, 0.4), kind="metal", pixels=256)
def _polished(n: int) -> Relief:
    """Nearly a mirror: faint waves and wiping marks that show in the gloss only."""
    wipe = field(n, 511, (0.25, 0.10), 1.6) + 0.5 * field(n, 513, 0.03, 1.4)
    return Relief(np.ones((n, n)), 3e-6 * field(n, 515, 0.25, 3.0), 1.0 + 0.16 * wipe)


@pattern("hammered", (0.2, 0.2), kind="metal", pixels=256)
def _hammered(n: int) -> Relief:
    """Shallow dents of 12 mm side by side."""
    near = cells(n, 521, 16, jitter=0.8)
    dent = (near.first * 16) ** 2
    return Relief(0.94 + 0.12 * dent, 1.6e-3 * dent, 1.0 + 0.1 * dent)


@pattern("cast", (0.2, 0.2), kind="metal", pixels=256)
def _cast(n: int) -> Relief:
    """The grainy skin of cast iron and of powder-coated steel."""
    grain = field(n, 531, 0.010, 1.8)
    return Relief(1.0 + 0.035 * grain, 1.8e-5 * grain, 1.0 + 0.05 * grain)


@pattern("galvanised", (0.4, 0.4), kind="metal", pixels=256)
def _galvanised(n: int) -> Relief:
    """Spangles of zinc in several greys."""
    near = cells(n, 541, 24)
    tone = spread(near.number, 543)
    tint = 0.85 + 0.3 * tone + 0.02 * field(n, 545, 0.01)
    return Relief(tint, 4e-6 * step(0.0, 0.004, near.border), 0.8 + 0.4 * tone)
