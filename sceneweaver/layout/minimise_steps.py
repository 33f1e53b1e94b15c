"""The search with an objective as a `StepOptimizer`: better layouts for as long as somebody waits."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.optimizers import Monitor, streams
from sceneweaver.optimizers.objective import Schedule

from .arrays import Array
from .compile import CompiledScene, compile_scene
from .minimise import MODULES, SALT, anneal_room, movable_roots
from .objective import ObjectiveTerm
from .problem import Problem
from .stepwise import BuiltIn, BuiltInRun

FIRST = 100
"""Moves of a candidate for each root in the first annealing."""

LEAST = 4
"""The same where the time is known: what it tells of the time that moves take has to fit into the time itself."""

SPENT, TRIAL = 0.85, 0.15
"""Shares of the time left that an annealing is planned for: the last one, and one before it that tells what moves take.
Cold moves take longer than hot ones, so less than all."""


@dataclass
class MinimiseRun:
    """A search, and annealings of what it found."""

    problem: Problem
    compiled: CompiledScene
    roots: list[int]
    search: BuiltInRun
    key: int
    began: float
    searches: bool = True
    annealings: int = 0
    moves: int = 0
    last: tuple[int, float] | None = None  # moves and seconds of the annealing before
    done: bool = False


@dataclass(frozen=True)
class MinimiseSteps:
    """The search, then annealings of an objective from the best layouts so far.

    Where it is known how long the whole may take, the last annealing takes most of what short ones leave; else each
    takes twice as long as the last, so that half of the time at least goes into the last one that ends.

    Attributes:
        objective: what is minimised.
        seconds: how long the whole may take, of processor time on a CPU; None: as long as somebody waits.
        search: finds the layouts to begin with.
    """

    objective: Sequence[ObjectiveTerm]
    seconds: float | None = None
    search: BuiltIn = BuiltIn("search")
    steps: None = None  # until nobody waits any longer

    def init(self, problem: Problem, poses: Array, key: int) -> MinimiseRun:
        """The run before its first step; the problem is that of one scene."""
        compiled = compile_scene(problem.scenes[0])
        began, search = _clock(problem.device), self.search.init(problem, poses, key)
        return MinimiseRun(problem, compiled, movable_roots(compiled.room), search, key, began)

    def warm_up(self, problem: Problem, poses: Array, key: int) -> MinimiseRun:
        """A round of the search and a short annealing, so that what comes later has nothing to compile or to load."""
        state = self.init(problem, poses, key)
        state.search.advance()
        return replace(self, seconds=0.0).step(state)  # no time is left for more than the shortest

    def step(self, state: MinimiseRun) -> MinimiseRun:
        """A round of the search, or the next annealing."""
        batch, before = state.search.batch, _clock(state.problem.device)
        if state.searches and not state.search.done and not self._late(state, before):
            state.search.advance()
            return state
        if state.searches:
            wp.copy(batch.state.poses, state.search.best())
            wp.launch(set_turns, batch.state.poses.shape, [batch.state.poses], [batch.state.turns], device=batch.device)
            state.searches = False
        valid = state.problem.feasible(batch.state.poses.numpy())
        moves = self._moves(state, before)
        if moves == 0 or not state.roots or (state.annealings and not valid.any()):
            state.done = True
            return state
        seeds = streams(state.key ^ SALT ^ state.annealings << 20, np.arange(batch.size))
        schedule, monitor = Schedule(moves), Monitor(batch.size)
        anneal_room(batch, state.compiled, self.objective, schedule, state.roots, valid, seeds, monitor)
        state.annealings, state.moves = state.annealings + 1, state.moves + moves
        state.last = moves, _clock(state.problem.device) - before
        return state

    def _late(self, state: MinimiseRun, now: float) -> bool:
        """Whether half of the time is over: some candidates may never get valid, and the others wait for them."""
        return self.seconds is not None and now - state.began > 0.5 * self.seconds

    def _moves(self, state: MinimiseRun, now: float) -> int:
        """How many moves of a candidate the next annealing takes; 0: there is no time for more than the first took."""
        first = (FIRST if self.seconds is None else LEAST) * max(len(state.roots), 1)
        if state.last is None:
            return first
        moves, took = state.last
        if self.seconds is None:
            return 2 * moves
        left = self.seconds - (now - state.began)
        share = SPENT if took > 0.5 * TRIAL * left else TRIAL
        fits = int(share * left * moves / max(took, 1e-6))
        return fits if fits > first else 0

    def best(self, state: MinimiseRun) -> Array:
        """The best poses of each candidate so far."""
        return state.search.best() if state.searches else wp.clone(state.search.batch.state.poses)

    def done(self, state: MinimiseRun) -> bool:
        """Whether no time is left for another annealing, or nothing may move."""
        return state.done

    def counts(self, state: MinimiseRun) -> tuple[int, int]:
        """Energies measured of each candidate so far, and of all; a move costs an object's share of one."""
        energies = state.search.energies + state.moves // max(len(state.roots), 1)
        return energies, energies * state.search.batch.size

    def modules_on(self, device: str) -> tuple[str, ...]:
        """The kernel modules that it launches on a device."""
        return (*self.search.modules_on(device), *MODULES)


def _clock(device: str) -> float:
    """Seconds of the processor on a CPU, of the wall clock elsewhere."""
    if device == "cpu":
        return time.process_time()
    wp.synchronize_device(device)
    return time.perf_counter()
