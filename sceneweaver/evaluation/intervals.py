"""Intervals by bootstrap over scenes: what another draw of as many scenes of the same system might have given."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

DRAWS = 2000
"""Resamples of the scenes."""

LEVEL = 0.95
"""Share of the draws between the two ends."""

FEWEST = 2
"""Scenes from which on there is an interval."""

_CELLS = 4_000_000  # of weights at a time


def ratio_of_sums(top: Array, bottom: Array) -> float:
    """Sum of ``top`` [n] over the sum of ``bottom`` [n]; NaN where that is 0."""
    total = float(bottom.sum())
    return float(top.sum()) / total if total > 0 else float("nan")


def interval(top: Array, bottom: Array, *, seed: int = 0) -> tuple[float, float] | None:
    """The percentile interval of a ratio of sums over scenes.

    Args:
        top: numerators of the scenes [n].
        bottom: their denominators [n].
        seed: of the draws.

    Returns:
        Its ends at `LEVEL`; None for fewer than `FEWEST` scenes that count.
    """
    if np.count_nonzero(bottom) < FEWEST:
        return None

    def figure(weights: Array) -> Array:
        below = weights @ bottom
        return np.where(below > 0, weights @ top, np.nan) / np.where(below > 0, below, 1.0)

    return of_weights(figure, len(top), seed=seed)


def of_weights(figure: Callable[[Array], Array], count: int, *, seed: int = 0) -> tuple[float, float] | None:
    """The interval of a figure of weighted scenes.

    Args:
        figure: from weights [draws, n], how often each scene was drawn, to figures [draws].
        count: n, the scenes.
        seed: of the draws.
    """
    if count < FEWEST:
        return None
    generator = np.random.default_rng(seed)
    found, left = list[Array](), DRAWS
    while left:
        some = max(1, min(left, _CELLS // count))
        found.append(figure(generator.multinomial(count, np.full(count, 1.0 / count), size=some).astype(float)))
        left -= some
    values = np.concatenate(found)
    values = values[np.isfinite(values)]
    if not len(values):
        return None
    low, high = np.quantile(values, [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return float(low), float(high)
