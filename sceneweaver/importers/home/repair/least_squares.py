"""Weighted least squares under linear inequalities: the nearest point of a polyhedron."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

SWEEPS = 4000
CLOSE = 0.02
"""How far a row may be from its bound, in the unit of the unknowns."""


@dataclass(frozen=True)
class Row:
    """``sum(factors[i] * x[i]) >= bound``, for what ``name`` says."""

    factors: Mapping[int, float]
    bound: float
    name: str = ""


def nearest(start: np.ndarray, weights: np.ndarray, rows: Sequence[Row]) -> tuple[np.ndarray, list[Row]]:
    """The point that keeps all rows and is nearest to ``start``, and the rows that it does not keep.

    Minimises ``sum(weights * (x - start)**2)`` by coordinate ascent in the dual, a row at a time (Hildreth, A quadratic
    programming procedure, 1957). Where the rows contradict each other, some are not kept.

    Args:
        start: [n].
        weights: positive [n].
        rows: with no factors: left out.

    Examples:
        >>> x, left = nearest(np.array([0.0, 1.0]), np.ones(2), [Row({0: -1.0, 1: 1.0}, 3.0)])
        >>> x.tolist(), left
        ([-1.0, 2.0], [])
    """
    x = start.astype(float).copy()
    listed = [(np.array([*r.factors]), np.array([*r.factors.values()]), r) for r in rows if r.factors]
    steps = [a / weights[i] for i, a, _ in listed]
    norms = [float((a * step).sum()) for (_, a, _), step in zip(listed, steps, strict=True)]
    multipliers = np.zeros(len(listed))
    for _ in range(SWEEPS):
        worst = 0.0
        for k, (index, factors, row) in enumerate(listed):
            lack = row.bound - float(x[index] @ factors)
            change = max(-multipliers[k], lack / norms[k])
            if change:
                multipliers[k] += change
                x[index] += change * steps[k]
                worst = max(worst, abs(change) * norms[k])
        if worst < CLOSE / 10:
            break
    left = [row for index, factors, row in listed if float(x[index] @ factors) < row.bound - CLOSE]
    return x, left
