"""Where an optimiser starts: the given poses, or drawn as the search draws its own."""

from __future__ import annotations

import warp as wp

from sceneweaver.kernels.plan import Plan, SearchRun
from sceneweaver.kernels.starts import start_attempt
from sceneweaver.kernels.tables import State

from .base import Start
from .batch import Batch, threads_per_candidate
from .launches import Launches

STARTS = {"given": 0, "random": 1, "sample": 2, "drawn": 3}
BLOCK = 32  # threads of a block on a GPU: one warp, so that a block ends with its candidate


def new_run(batch: Batch) -> SearchRun:
    """A run before its first round, all candidates active."""
    run, device, count = SearchRun(), batch.device, batch.size
    for name, length in (("clock", 1), ("left", 2), ("more", 1), ("cut", 1)):
        setattr(run, name, wp.zeros(length, dtype=wp.int32, device=device))
    run.active = wp.full(count, 1, dtype=wp.int32, device=device)
    run.total = wp.zeros(count, dtype=wp.float32, device=device)
    run.best = wp.empty_like(batch.state.poses)
    run.hard = wp.zeros(count, dtype=wp.float32, device=device)
    run.best_total, run.best_hard = (wp.full(count, float("inf"), dtype=wp.float32, device=device) for _ in range(2))
    return run


def add_start(block: Launches, batch: Batch, state: State, plan: Plan, run: SearchRun) -> None:
    """Append the start of an attempt, where one is due."""
    dim = batch.size * threads_per_candidate(batch.device)
    block.add(start_attempt, dim, [batch.problems, plan, run], [state], block=BLOCK)


def draw_starts(batch: Batch, start: Start) -> None:
    """Draw the poses that an optimiser starts from, in place."""
    if start in ("given", "drawn"):
        return
    plan = Plan()
    plan.start, plan.steps, plan.rounds = STARTS[start], 1, 1
    block = Launches(batch.device)
    add_start(block, batch, batch.state, plan, new_run(batch))
    block.run()
