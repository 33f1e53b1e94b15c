"""Rivals with an objective of their own (`benchmarks.rivals`) as `StepOptimizer`s: a step solves a few layouts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.rivals import RIVALS, numpy_descent, torch_positions
from sceneweaver.layout import Problem


@dataclass
class Solving:
    problem: Problem
    poses: np.ndarray
    key: int
    done: int = 0


@dataclass(frozen=True)
class Placement:
    """``each`` counts its energies of one layout, of its own objective."""

    name: str
    each: int
    at_once: int = 8

    steps = None  # it says itself when all are solved

    def init(self, problem: Problem, poses: Any, key: int) -> Solving:
        missing = RIVALS[self.name].missing(problem.device)
        if missing:
            raise ModuleNotFoundError(missing)
        return Solving(problem, poses.numpy().copy(), key)

    def step(self, state: Solving) -> Solving:
        rows = slice(state.done % len(state.poses), state.done % len(state.poses) + self.at_once)
        few = state.poses[rows].astype(np.float64)
        found = RIVALS[self.name].solve(state.problem.scenes[0], few, state.key + state.done, state.problem.device)
        state.poses[rows] = np.nan_to_num(found)
        state.done += len(few)
        return state

    def best(self, state: Solving) -> np.ndarray:
        return state.poses

    def counts(self, state: Solving) -> tuple[int, int]:
        return state.done * self.each // self.at_once, state.done * self.each


def NumpyDescent() -> Placement:
    return Placement("numpy descent", numpy_descent.RUNS * (numpy_descent.STEPS + 1), at_once=1)


def TorchPositions() -> Placement:
    return Placement("torch positions", torch_positions.STEPS)
