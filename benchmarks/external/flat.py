"""One layout as a function of a vector, for optimisers that call a function: value, gradient, box, clock."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sceneweaver.layout import Problem

from .objectives import nets_of, slope
from .quarter_turns import quarter_turns


class TimeUp(Exception):  # noqa: N818 - no error: it ends a solver that knows no clock
    """The time of a run is over."""


class Flat:
    """The free coordinates of a layout [D]: energy times ``weight`` and what the problem asks to be minimised [m].

    The energy's gradient is carried over to roots. The lowest value is kept in ``lowest``, with its vector ``best``.
    """

    def __init__(
        self, problem: Problem, given: np.ndarray, until: Callable[[], bool], terms: Sequence[Any], weight: float
    ) -> None:
        self.problem, self.given, self.until = problem, np.asarray(given, dtype=np.float64), until
        self.free = problem.free[0]
        self.start = self.given[self.free]
        self.low, self.high = problem.lower[0][self.free].astype(float), problem.upper[0][self.free].astype(float)
        self.start = np.clip(self.start, self.low, self.high)
        self.nets, self.view = nets_of(problem, terms), quarter_turns(problem)
        self.weight = weight if self.nets else 1.0
        self.mending = False  # the energy counts alone
        self.best, self.lowest, self.calls = self.start, np.inf, 0

    def poses(self, vector: np.ndarray) -> np.ndarray:
        """Layouts [..., N, 4] of vectors [..., D]."""
        found = np.broadcast_to(self.given, (*vector.shape[:-1], *self.given.shape)).copy()
        found[..., self.free] = vector
        flat = found.reshape(-1, *self.given.shape)
        if (self.problem.roots[0] != np.arange(self.problem.objects)).any():
            like = np.broadcast_to(self.given, flat.shape)
            flat = self.problem.carry(flat.astype(np.float32), like=like.astype(np.float32))
        return flat.reshape(found.shape)

    def __call__(self, vector: np.ndarray) -> tuple[float, np.ndarray]:
        """Value and gradient [D]. Raises `TimeUp`."""
        if self.until():
            raise TimeUp
        poses = self.poses(np.asarray(vector))[None]
        energy, gradient = self.problem.energy_and_grad(poses.astype(np.float32))
        self.calls += 1
        if self.mending:
            return float(energy[0]), self._on_roots(gradient[0].astype(float), poses[0])[self.free]
        value, total = self.weight * float(energy[0]), self.weight * self._on_roots(gradient[0].astype(float), poses[0])
        if self.nets:
            extra, by_pose = slope(self.nets, self.view, poses[0])
            value, total = value + extra, total + by_pose
        if value < self.lowest:
            self.best, self.lowest = np.array(vector), value
        return value, total[self.free]

    def value(self, vector: np.ndarray) -> float:
        """The value alone. Raises `TimeUp`."""
        return self(vector)[0]

    def _on_roots(self, gradient: np.ndarray, poses: np.ndarray) -> np.ndarray:
        """What moves with a root pulls on it."""
        roots, total = self.problem.roots[0], gradient.copy()
        for j in np.flatnonzero(roots != np.arange(len(roots))):
            root, arm = roots[j], poses[j, :2] - poses[roots[j], :2]
            total[root] += gradient[j]
            total[root, 3] += arm[0] * gradient[j, 1] - arm[1] * gradient[j, 0]
        return total
