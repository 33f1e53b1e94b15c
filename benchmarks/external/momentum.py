"""Gradient descent with momentum (Polyak 1964): the example of docs/research.md, with the best of each layout kept."""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.layout import Problem


class Momentum:
    steps = 300

    def init(self, problem: Problem, poses: Any, key: int) -> tuple:
        x = poses.numpy()
        return problem, x, np.zeros_like(x), x, np.full(len(x), np.inf), x

    def step(self, state: tuple) -> tuple:
        problem, x, speed, best, lowest, given = state
        energy, gradient = problem.energy_and_grad(x)
        best = np.where((energy < lowest)[:, None, None], x, best)
        speed = 0.9 * speed - 0.01 * gradient * problem.free[problem.scene_of(len(x))]
        return problem, problem.carry(x + speed, like=given), speed, best, np.minimum(energy, lowest), given

    def best(self, state: tuple) -> np.ndarray:
        return state[3]
