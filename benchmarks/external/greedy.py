"""Objects one by one on a grid, each where the energy is lowest: what solvers behind language models do.

A step puts every object once at the best of some places of a grid and four directions, large objects first; where it
stands already is one of them. It sees energies only. Written from what such solvers have in common.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem


@dataclass
class Placed:
    problem: Problem
    given: np.ndarray
    x: np.ndarray
    rng: np.random.Generator
    order: list[np.ndarray]


@dataclass(frozen=True)
class Greedy:
    cell: float = 0.1  # [m]
    places: int = 24  # that are tried of one object
    at_once: int = 4  # objects in one step of the protocol

    SETTINGS: ClassVar[dict[str, list[Any]]] = {"cell": [0.05, 0.1, 0.25], "places": [8, 24, 96]}

    steps = None  # the budget says how many

    def init(self, problem: Problem, poses: Any, key: int) -> Placed:
        return Placed(problem, poses.numpy(), poses.numpy(), np.random.default_rng(key), [])

    def step(self, state: Placed) -> Placed:
        for _ in range(self.at_once):
            if not state.order:
                free = state.problem.free.any(axis=2)
                sizes = np.array([np.prod(o.size[:2]) for o in state.problem.metadata[0].objects])
                movable = np.flatnonzero(free[0])
                state.order = list(movable[np.argsort(-sizes[movable], kind="stable")])
            if state.order:
                self._place(state, state.order.pop(0))
        return state

    def best(self, state: Placed) -> np.ndarray:
        return state.x

    def _place(self, state: Placed, k: int) -> None:
        problem, x = state.problem, state.x
        count, low, high = len(x), problem.lower[0, k], problem.upper[0, k]
        drawn = state.rng.uniform(low, high, (count, self.places, 4))
        drawn[..., :2] = np.round(drawn[..., :2] / self.cell) * self.cell
        drawn[..., 3] = np.pi / 2 * state.rng.integers(0, 4, (count, self.places))
        tried = np.repeat(x[:, None], self.places + 1, axis=1)
        tried[:, 1:, k] = np.where(problem.free[0, k], drawn, tried[:, 1:, k])
        flat = problem.carry(tried.reshape(-1, *x.shape[1:]), like=np.repeat(state.given, self.places + 1, axis=0))
        energy = problem.energy(flat).reshape(count, -1)
        state.x = flat.reshape(tried.shape)[np.arange(count), energy.argmin(axis=1)]
