"""Whole solvers as `StepOptimizer`s: a step solves one candidate for a limited time, with a seed of its own.

The layout that a candidate starts from is a hint. What is kept is the better of what was found and what was there: a
valid one first, then that of the lower objective, then of the lower energy.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from sceneweaver.layout import Problem

from .objectives import objective_of


@dataclass
class Solving:
    """A run. ``poses`` [B, N, 4] are the best so far, ``given`` those to begin with, ``turn`` how many were solved."""

    problem: Problem
    given: np.ndarray
    poses: np.ndarray
    key: int
    turn: int = 0
    notes: dict[str, Any] = field(default_factory=dict)


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
        polish: whether what was found goes to the engine's projection, and the better is kept.
        objective: terms (kind, objects, weight, params) that are to be minimised, see `configure`.
    """

    limit: float = 1.0
    polish: bool = False
    objective: tuple[Any, ...] = ()

    steps = None

    def configure(self, objective: Sequence[Any], seconds: float) -> Any:
        """The solver for an objective and a budget [s].

        Where something is to be minimised a candidate gets half of the budget: the best layout is what counts then.
        """
        limit = 0.5 * seconds if objective else min(self.limit, seconds)
        return replace(self, objective=tuple(objective), limit=limit)

    def init(self, problem: Problem, poses: Any, key: int) -> Solving:
        given = np.asarray(poses.numpy(), dtype=np.float32)
        return Solving(problem, given, given.copy(), key)

    def step(self: Any, state: Solving) -> Solving:
        row = state.turn % len(state.given)
        ends = time.process_time() + self.limit
        seed = (state.key * 7919 + state.turn) % 2**31
        found = self.solve(state.problem, state.given[row].astype(np.float64), seed, lambda: time.process_time() > ends)
        if found is not None:
            keep_best(state, row, found, self.objective)
        if self.polish and not state.problem.feasible(state.poses[row : row + 1])[0]:
            keep_best(state, row, state.problem.project(state.poses[row : row + 1]), self.objective)
        state.turn += 1
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
