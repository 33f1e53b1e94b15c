"""Whole solvers as `StepOptimizer`s: a step solves one candidate for a limited time, with a seed of its own.

The layout that a candidate starts from is a hint. What is kept is the better of what was found and what was there: a
valid one first, then that of the lower objective, then of the lower energy.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from sceneweaver.layout import Problem

from .objectives import objective_of

FITS, POLISHED = 0.9, 0.6  # of the time that is left: what a step takes beyond its limit fits in as well
WARM = 0.02  # [s] of a step that loads what there is to load


@dataclass
class Solving:
    """A run. ``poses`` [B, N, 4] are the best so far, ``given`` those to begin with, ``turn`` how many were solved."""

    problem: Problem
    given: np.ndarray
    poses: np.ndarray
    key: int
    turn: int = 0
    notes: dict[str, Any] = field(default_factory=dict)
    spent: float = 0.0  # processor time of all steps [s]


class Solver(Protocol):
    """What solves one layout."""

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray | None:
        """A layout [N, 4], or layouts [K, N, 4] to choose from, from ``given`` [N, 4]; None: nothing was found.

        ``until`` says that the time is over.
        """
        ...


@dataclass(frozen=True)
class OneByOne:
    """The protocol for a `Solver`; candidates take turns.

    Attributes:
        limit: processor time of a step [s].
        seconds: processor time of all steps [s]; the last one is cut to fit, as a step that ends late is worth nothing.
        polish: whether what was found goes to the engine's projection, and the better is kept.
        objective: terms (kind, objects, weight, params) that are to be minimised, see `configure`.
    """

    limit: float = 1.0
    seconds: float = math.inf
    polish: bool = False
    objective: tuple[Any, ...] = ()

    steps = None

    def configure(self, objective: Sequence[Any], seconds: float) -> Any:
        """The solver for an objective and a budget [s].

        Where something is to be minimised a candidate gets half of the budget: the best layout is what counts then.
        """
        limit = 0.5 * seconds if objective else min(self.limit, seconds)
        return replace(self, objective=tuple(objective), limit=limit, seconds=seconds)

    def init(self, problem: Problem, poses: Any, key: int) -> Solving:
        given = np.asarray(poses.numpy(), dtype=np.float32)
        return Solving(problem, given, given.copy(), key)

    def warm_up(self: Any, problem: Problem, poses: Any, key: int) -> Solving:
        """A step that is cut short: it loads what there is to load."""
        return replace(self, limit=WARM).step(self.init(problem, poses, key))

    def step(self: Any, state: Solving) -> Solving:
        row = state.turn % len(state.given)
        began = time.process_time()
        left = (POLISHED if self.polish else FITS) * (self.seconds - state.spent)
        ends = began + (min(self.limit, left) if left > 0 else self.limit)
        seed = (state.key * 7919 + state.turn) % 2**31
        found = self.solve(state.problem, state.given[row].astype(np.float64), seed, lambda: time.process_time() > ends)
        if found is not None:
            keep_best(state, row, found, self.objective)
        if self.polish and not state.problem.feasible(state.poses[row : row + 1])[0]:
            keep_best(state, row, state.problem.project(state.poses[row : row + 1]), self.objective)
        state.turn += 1
        state.spent += time.process_time() - began
        return state

    def best(self, state: Solving) -> np.ndarray:
        return state.poses

    def done(self, state: Solving) -> bool:
        """All were solved once; an objective can always be tried for again."""
        return state.turn >= len(state.given) and not self.objective


def keep_best(state: Solving, row: int, found: np.ndarray, objective: Sequence[Any] = ()) -> None:
    """Put the best of layouts [N, 4] or [K, N, 4] and the candidate's own into its place."""
    problem = state.problem
    many = np.nan_to_num(np.asarray(found, dtype=np.float64)).reshape(-1, *state.given.shape[1:])
    like = np.repeat(state.given[row : row + 1], len(many), axis=0)
    which = np.full(len(many), problem.scene_of(len(state.given))[row])
    many = np.where(problem.free[which], many, like).astype(np.float32)
    many = np.concatenate([state.poses[row : row + 1], problem.carry(many, which, like=like)])
    which = np.append(which, which[0])
    state.poses[row] = many[ranking(problem, many, which, objective)[0]]


def ranking(problem: Problem, poses: np.ndarray, which: np.ndarray, objective: Sequence[Any]) -> np.ndarray:
    """The order of layouts [B, N, 4]: valid ones first, then by objective, then by energy."""
    valid, energy = problem.feasible(poses, which), problem.energy(poses, which)
    value = objective_of(problem, objective, poses) if objective else np.zeros(len(poses))
    return np.lexsort((energy, np.where(valid, value, 0.0), ~valid))
