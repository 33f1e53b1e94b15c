"""Simulated annealing (Kirkpatrick et al. 1983) by moves of one object, as generators of rooms use it.

A move shifts an object, turns it by a right angle, or puts it anywhere in the room; Metropolis accepts. It sees
energies only. Written from what such solvers have in common, not from any one of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

INNER = 20  # moves in one step of the protocol


@dataclass
class Chain:
    problem: Problem
    given: np.ndarray
    x: np.ndarray
    energy: np.ndarray
    best: np.ndarray
    lowest: np.ndarray
    rng: np.random.Generator
    moves: int = 0


@dataclass(frozen=True)
class Annealing:
    hottest: float = 0.5  # [m] of energy
    coldest: float = 0.005
    steps: int = 150

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"hottest": [0.1, 0.5, 2.0], "coldest": [0.001, 0.005, 0.02]}

    def init(self, problem: Problem, poses: Any, key: int) -> Chain:
        x = poses.numpy()
        energy = problem.energy(x)
        return Chain(problem, x, x, energy, x, energy, np.random.default_rng(key))

    def step(self, state: Chain) -> Chain:
        for _ in range(INNER):
            done = state.moves / (INNER * self.steps)
            temperature = self.hottest * (self.coldest / self.hottest) ** done
            x = state.problem.carry(self._moved(state, done), like=state.given)
            energy = state.problem.energy(x)
            with np.errstate(over="ignore"):
                taken = state.rng.random(len(x)) < np.exp((state.energy - energy) / temperature)
            state.x = np.where(taken[:, None, None], x, state.x)
            state.energy = np.where(taken, energy, state.energy)
            better = state.energy < state.lowest
            state.best = np.where(better[:, None, None], state.x, state.best)
            state.lowest, state.moves = np.minimum(state.energy, state.lowest), state.moves + 1
        return state

    def best(self, state: Chain) -> np.ndarray:
        return state.best

    def _moved(self, state: Chain, done: float) -> np.ndarray:
        """Every layout with one object moved: half are shifted, a quarter turned, a quarter put anywhere."""
        problem, rng, x = state.problem, state.rng, state.x.copy()
        scene, rows = problem.scene_of(len(x)), np.arange(len(x))
        free = problem.free[scene]
        chosen = np.argmax(rng.random(free.shape[:2]) * free.any(axis=2), axis=1)
        now, may = x[rows, chosen], free[rows, chosen]
        shift = rng.normal(0.0, 0.05 + 0.45 * (1 - done), now.shape) * (1, 1, 1, 0.3)
        turn = np.stack([0 * now[:, 0]] * 3 + [np.pi / 2 * rng.integers(1, 4, len(x))], axis=1)
        anywhere = rng.uniform(problem.lower[scene][rows, chosen], problem.upper[scene][rows, chosen])
        kind = rng.random(len(x))[:, None]
        new = np.where(kind < 0.5, now + shift, np.where(kind < 0.75, now + turn, anywhere))
        x[rows, chosen] = np.where(may, new, now)
        return x
