"""Figures of a set of scenes: how its categories differ from those of another, and how its scenes differ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from .intervals import of_weights
from .judge import PLAN

Array = NDArray[np.float64]

LITTLE = 1e-6
"""Added to frequencies before their logarithm, as PhyScene does."""

MOST_PAIRS = 2000
"""Pairs of scenes that are compared, drawn where there are more."""


def category_kl(
    reference: Sequence[Mapping[str, int]], scenes: Sequence[Mapping[str, int]]
) -> tuple[float, tuple[float, float] | None] | None:
    """KL divergence [nat] of the categories of some scenes from those of a reference set, and its interval.

    Args:
        reference: how many objects there are of each category, by scene.
        scenes: the same of the system.

    Returns:
        None where one of them has no object.

    Examples:
        >>> value, _ = category_kl([{"bed": 1, "desk": 1}], [{"bed": 1, "desk": 1}])
        >>> round(value, 6)
        0.0
        >>> round(category_kl([{"bed": 1}], [{"desk": 3}])[0], 2)
        13.82
    """
    names = sorted({name for one in (*reference, *scenes) for name in one})
    ours, wanted = _table(scenes, names), _table(reference, names).sum(axis=0)
    if not wanted.sum() or not ours.sum():
        return None
    p = wanted / wanted.sum()

    def figure(weights: Array) -> Array:
        counts = weights @ ours
        q = counts / np.maximum(counts.sum(axis=1, keepdims=True), 1.0)
        return (p * (np.log(p + LITTLE) - np.log(q + LITTLE))).sum(axis=1)

    return float(figure(np.ones((1, len(ours))))[0]), of_weights(figure, len(ours))


def _table(scenes: Sequence[Mapping[str, int]], names: Sequence[str]) -> Array:
    """How many objects of each category, by scene [scenes, categories]."""
    column = {name: k for k, name in enumerate(names)}
    table = np.zeros((len(scenes), len(names)))
    for row, counts in enumerate(scenes):
        for name, count in counts.items():
            table[row, column[name]] = count
    return table


def pairs_of(count: int, seed: int = 0) -> NDArray[np.intp]:
    """Pairs [n, 2] of scenes: all of them, or `MOST_PAIRS` that are drawn."""
    first, second = np.triu_indices(count, 1)
    if len(first) > MOST_PAIRS:
        chosen = np.sort(np.random.default_rng(seed).choice(len(first), MOST_PAIRS, replace=False))
        first, second = first[chosen], second[chosen]
    return np.stack([first, second], axis=1)


def category_diversity(scenes: Sequence[Mapping[str, int]]) -> float | None:
    """Mean over pairs of scenes of 1 - shared objects over objects of either; None for fewer than two.

    Examples:
        >>> category_diversity([{"bed": 1}, {"bed": 1}]), category_diversity([{"bed": 1}, {"desk": 1}])
        (0.0, 1.0)
    """
    names = sorted({name for one in scenes for name in one})
    return _mean_distance(_table(scenes, names))


def layout_diversity(plans: Sequence[Sequence[int]]) -> float | None:
    """Mean over pairs of scenes of 1 - intersection over union of their plans; None for fewer than two."""
    bits = [[(row >> k) & 1 for row in plan for k in range(PLAN)] for plan in plans]
    return _mean_distance(np.array(bits, dtype=float).reshape(len(bits), -1))


def _mean_distance(rows: Array) -> float | None:
    """Mean over pairs of 1 - (sum of least) / (sum of largest); two empty rows are the same."""
    if len(rows) < 2:  # noqa: PLR2004 - a pair
        return None
    total = []
    for pair in np.array_split(pairs := pairs_of(len(rows)), max(1, len(pairs) // 256)):
        a, b = rows[pair[:, 0]], rows[pair[:, 1]]
        either = np.maximum(a, b).sum(axis=1)
        total.append(np.where(either > 0, 1 - np.minimum(a, b).sum(axis=1) / np.maximum(either, 1e-12), 0.0))
    return float(np.concatenate(total).mean())
