"""What time leaves on any surface: stains, and the marks of use."""

from __future__ import annotations

import numpy as np

from ..noise import field, step
from ..registry import pattern
from ..relief import Relief


@pattern("stained", (0.7, 0.7))
def _stained(n: int) -> Relief:
    """Dark blots with darker rims, and specks between them."""
    broad, fine = field(n, 861, 0.16, 2.2), field(n, 863, 0.012, 1.2)
    blot = step(0.35, 0.6, broad)
    rim = np.exp(-(((broad - 0.42) / 0.12) ** 2))
    speck = step(1.9, 2.2, fine)
    return Relief(1.0 - 0.28 * blot - 0.18 * rim - 0.3 * speck + 0.03 * fine, 2e-5 * fine, 1.0 + 0.08 * blot)


@pattern("scuffed", (0.6, 0.6))
def _scuffed(n: int) -> Relief:
    """Bald patches that are lighter, dark smudges, and scratches this way and that."""
    broad, smudge = field(n, 871, 0.14, 2.0), field(n, 873, 0.2, 2.4)
    long, across = field(n, 875, (0.5, 0.002), 1.0), field(n, 877, (0.002, 0.4), 1.0)
    scratch = step(2.3, 2.6, long) + step(2.4, 2.7, across)
    bald = step(0.7, 1.1, broad)
    return Relief(
        1.0 + 0.2 * bald - 0.14 * step(0.8, 1.4, smudge) + 0.22 * np.minimum(scratch, 1.0),
        -3e-5 * scratch,
        1.0 - 0.06 * bald,
    )
