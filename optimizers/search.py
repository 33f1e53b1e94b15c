"""Search (default): guided moves, annealing, polish, judge, and failures start again."""

from __future__ import annotations

import numpy as np
import warp as wp

from sceneweaver.kernels.search import Budget, search
from sceneweaver.kernels.track import keep_best

from .base import Monitor, Outcome, Start, register
from .batch import Batch, judge

ATTEMPTS = 6
ROUNDS = 8
MOVES = 4  # in a round, for each movable object
PROPOSALS = 8
POLISH = 6
LINGER = 2
HOT = 0.25  # [m]
STARTS = {"given": 0, "random": 1, "sample": 2}


def _budget(round_: int, start: int) -> Budget:
    budget = Budget()
    budget.round, budget.rounds = round_, ROUNDS
    budget.moves, budget.proposals, budget.polish, budget.linger = MOVES, PROPOSALS, POLISH, LINGER
    budget.hot = HOT
    budget.start = start if round_ == 0 else 0
    return budget


@register("search")
def run_search(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> Outcome:
    """Search every candidate until it is valid; ``budget`` is the number of attempts (default 6).

    The first attempt begins as ``start`` says, later ones by drawing from the relations. A candidate that never gets
    valid ends at the lowest energy found.
    """
    device = batch.device
    trial, best = batch.scratch(), batch.scratch()
    trial.rng = batch.state.rng  # one stream a candidate, whoever draws
    energy = wp.zeros((batch.size, max(batch.objects, 1)), dtype=wp.float32, device=device)
    total = wp.zeros(batch.size, dtype=wp.float32, device=device)
    best_total = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
    left = np.arange(batch.size, dtype=np.int32)
    for attempt in range(ATTEMPTS if budget is None else budget):
        mode = STARTS[start] if attempt == 0 else STARTS["sample"]
        for round_ in range(ROUNDS):
            if monitor.expired() or not left.size:
                break
            active = wp.array(left, dtype=wp.int32, device=device)
            wp.launch(
                search,
                left.size,
                [
                    batch.tables,
                    batch.margins,
                    batch.weights,
                    _budget(round_, mode),
                    batch.problem,
                    active,
                    batch.state,
                    trial,
                ],
                [energy, total],
                device=device,
            )
            wp.launch(
                keep_best,
                left.size,
                [batch.tables, batch.problem, active, batch.state, total],
                [best, best_total],
                device=device,
            )
            status = judge(batch, active).status[left]
            solved = int(np.sum(status == 0))
            if solved:
                monitor.add(solved, solved, float(total.numpy()[left[status == 0]].min()))
            left = left[status != 0]
    if left.size:
        _restore(batch, best, left)
        monitor.add(left.size, 0, float(best_total.numpy()[left].min()))
    return Outcome(best_total.numpy())


def _restore(batch: Batch, best, left: np.ndarray) -> None:
    """Give the unsolved candidates the best layout they had."""
    active = wp.array(left, dtype=wp.int32, device=batch.device)
    zero = wp.zeros(batch.size, dtype=wp.float32, device=batch.device)
    huge = wp.full(batch.size, float("inf"), dtype=wp.float32, device=batch.device)
    wp.launch(
        keep_best,
        left.size,
        [batch.tables, batch.problem, active, best, zero],
        [batch.state, huge],
        device=batch.device,
    )
