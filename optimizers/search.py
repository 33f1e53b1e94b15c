"""Search (default): guided moves, annealing, polish, judge, and failures start again."""

from __future__ import annotations

import numpy as np
import warp as wp

from sceneweaver.kernels.cells import CELLS, CROWD
from sceneweaver.kernels.search import Budget, search
from sceneweaver.kernels.tables import State, Weights
from sceneweaver.kernels.track import keep_best

from .base import Monitor, Outcome, Start, register
from .batch import Batch, judge

ATTEMPTS = 10
ROUNDS = 8
MOVES = 4  # in a round, for each movable object
PROPOSALS = 5
POLISH = 6
LINGER = 2
HOT = 0.3  # [m]
HOT_AT_HOME = 0.05  # the same when little should move
AT_HOME = 3  # attempts from the given poses before anything is drawn anew
STARTS = {"given": 0, "random": 1, "sample": 2}
FROM_ANCHORS = 3


def _with_cells(batch: Batch) -> State:
    """The batch's state, with cells when there are enough objects for them to pay; only searches keep them current."""
    state = State()
    for name in ("poses", "turns", "options", "anchors", "rng", "mark", "cell_head", "cell_next", "cell_of"):
        setattr(state, name, getattr(batch.state, name))
    if batch.objects > CROWD:
        state.cell_head = wp.zeros((batch.size, CELLS), dtype=wp.int32, device=batch.device)
        state.cell_next = wp.zeros((batch.size, batch.objects), dtype=wp.int32, device=batch.device)
        state.cell_of = wp.zeros_like(state.cell_next)
    return state


def _without_pull(weights: Weights) -> Weights:
    copy = Weights()
    for name in ("collision", "bounds", "zone", "opening", "relation", "knee"):
        setattr(copy, name, getattr(weights, name))
    return copy


def _budget(round_: int, start: int, stay: bool) -> Budget:
    budget = Budget()
    budget.round, budget.rounds = round_, ROUNDS
    budget.moves, budget.proposals, budget.polish, budget.linger = MOVES, PROPOSALS, POLISH, LINGER
    budget.hot = HOT_AT_HOME if stay else HOT
    budget.stay = int(stay)
    budget.start = start if round_ == 0 else 0
    return budget


@register("search")
def run_search(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> Outcome:
    """Search every candidate until it is valid; ``budget`` is the number of attempts (default 10).

    The first attempt begins as ``start`` says, later ones by drawing from the relations. A candidate that never gets
    valid ends at the lowest energy found.
    """
    device = batch.device
    state, trial, best = _with_cells(batch), batch.scratch(), batch.scratch()
    for name in ("rng", "mark", "cell_head", "cell_next", "cell_of"):  # one for a candidate, whoever draws
        setattr(trial, name, getattr(state, name))
    energy = wp.zeros((batch.size, max(batch.objects, 1)), dtype=wp.float32, device=device)
    total = wp.zeros(batch.size, dtype=wp.float32, device=device)
    best_total = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
    left = np.arange(batch.size, dtype=np.int32)
    stay, weights = start == "given", batch.weights
    if stay:  # what is in order already is left alone
        status = judge(batch).status
        left = left[status != 0]
        monitor.add(batch.size - left.size, batch.size - left.size, 0.0)
        best_total.assign(np.where(status == 0, 0.0, np.inf).astype(np.float32))
    for attempt in range(ATTEMPTS if budget is None else budget):
        mode = STARTS[start] if attempt == 0 else STARTS["sample"]
        if stay and attempt < AT_HOME:
            mode = STARTS["given"] if attempt == 0 else FROM_ANCHORS
        elif stay:  # little movement was not enough: any layout is better than none
            stay, weights = False, _without_pull(weights)
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
                    weights,
                    _budget(round_, mode, stay),
                    batch.problem,
                    active,
                    state,
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
