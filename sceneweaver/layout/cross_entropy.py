"""The cross-entropy method over a box: draws, and what their ranks make of the next draws."""

from __future__ import annotations

import numpy as np

SMOOTHING = 0.6
"""How much of the elite's mean and spread the next generation takes over."""

FLOOR = 0.15
"""Least spread of the first generation, as a share of the box; it falls with every one by `COOLING`."""

COOLING = 0.7

ALONG = 0.5
"""Share of later draws that leave the best point along one axis: where lengths compete, the normal draws of all of them
together are seldom all in order, and one alone can still shrink."""

SHORTEST, LONGEST = 1e-3, 0.2
"""Of those ways, as shares of the box."""


class CrossEntropy:
    """Normal draws in the unit box, with mean and spread of the best of the last generation.

    After Rubinstein and Kroese, The Cross-Entropy Method (2004), with smoothed updates, a least spread that falls
    geometrically, and the best point so far kept among the elite. Some draws are steps of a pattern search, from the
    best point along an axis.
    """

    def __init__(self, dimensions: int, seed: int, elite: float) -> None:
        self._rng = np.random.default_rng([seed, dimensions])
        self._elite = elite
        self._mean, self._spread = np.full(dimensions, 0.5), np.full(dimensions, 0.3)
        self._best: np.ndarray | None = None
        self._generation = 0

    def draw(self, count: int) -> np.ndarray:
        """Points [count, V] in the unit box: first a Latin hypercube, then normal draws and ways along axes."""
        dimensions = len(self._mean)
        if self._best is None:
            ranks = np.stack([self._rng.permutation(count) for _ in range(dimensions)], axis=1)
            return (ranks + self._rng.random((count, dimensions))) / count
        points = self._mean + self._spread * self._rng.normal(size=(count, dimensions))
        along = round(ALONG * count) if dimensions > 1 else 0
        ways = np.exp(self._rng.uniform(np.log(SHORTEST), np.log(LONGEST), along)) * self._rng.choice((-1, 1), along)
        points[:along] = self._best
        points[np.arange(along), self._rng.integers(dimensions, size=along)] += ways
        return np.clip(points, 0.0, 1.0)

    def learn(self, points: np.ndarray, order: np.ndarray, best: np.ndarray) -> None:
        """Take in a generation's points [count, V], their order (best first), and the best point of all so far."""
        count = max(2, round(self._elite * len(points)))
        elite = np.concatenate([points[order[:count]], best[None]])
        self._generation += 1
        weight = 1.0 if self._best is None else SMOOTHING
        self._mean = (1 - weight) * self._mean + weight * elite.mean(axis=0)
        least = FLOOR * COOLING**self._generation
        self._spread = np.maximum((1 - weight) * self._spread + weight * elite.std(axis=0), least)
        self._best = best
