"""Search (default): guided moves, annealing, polish, judge, and failures start again."""

from __future__ import annotations

import numpy as np
import warp as wp

from sceneweaver.kernels.begin import Plan, begin
from sceneweaver.kernels.cells import CELLS, CROWD, enter_cells
from sceneweaver.kernels.search import search
from sceneweaver.kernels.tables import State
from sceneweaver.kernels.track import close, keep_best, proceed, set_turns, tick

from .base import Monitor, Outcome, Start, register
from .batch import STATE, Batch, judge, new_court, sit
from .launches import repeat_while
from .starts import STARTS, launch_lanes

ATTEMPTS = {"cpu": 10, "cuda": 40}
AT_HOME = 3  # attempts from the given poses before anything is drawn anew
LINGER = 2
HOT = 0.3  # [m]
HOT_AT_HOME = 0.05  # the same when little should move
# A GPU tries many poses in the time of one, so that it needs fewer moves; measured on one H200 (docs/gpu.md).
ROUNDS = {"cpu": 8, "cuda": 2}
MOVES = {"cpu": 4, "cuda": 3}  # in a round, for each movable object
PROPOSALS = {"cpu": 5, "cuda": 15}
POLISH = {"cpu": 6, "cuda": 1}
TRIES = {"cpu": 3, "cuda": 4}  # step lengths of one gradient step


def plan_for(device: str, start: Start, attempts: int | None) -> Plan:
    """The plan of a search on a kind of device."""
    kind = device.partition(":")[0]
    plan = Plan()
    plan.rounds, plan.steps = ROUNDS[kind], ROUNDS[kind] * (ATTEMPTS[kind] if attempts is None else attempts)
    plan.start, plan.at_home = STARTS[start], AT_HOME
    plan.moves, plan.proposals, plan.tries = MOVES[kind], PROPOSALS[kind], TRIES[kind]
    plan.polish, plan.linger, plan.hot, plan.hot_at_home = POLISH[kind], LINGER, HOT, HOT_AT_HOME
    return plan


def _with_cells(batch: Batch) -> State:
    """The batch's state, with cells when there are enough objects for them to pay; only searches keep them current."""
    state = State()
    for name in STATE:
        setattr(state, name, getattr(batch.state, name))
    if batch.objects > CROWD:
        state.cell_head = wp.zeros((batch.size, CELLS), dtype=wp.int32, device=batch.device)
        state.cell_next = wp.zeros((batch.size, batch.objects), dtype=wp.int32, device=batch.device)
        state.cell_of = wp.zeros_like(state.cell_next)
    return state


@register("search", modules=("begin", "cells", "search"))
def run_search(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> Outcome:
    """Search every candidate until it is valid; ``budget`` is the number of attempts (default 10, on a
    GPU, whose attempts are shorter, 40).

    The first attempt begins as ``start`` says, later ones by drawing from the relations. A candidate that never gets
    valid ends at the lowest energy found. On a GPU the whole run is one graph: nothing comes back to the host until
    all are valid or the attempts are used up, unless there is a deadline or progress to report.
    """
    device = batch.device
    plan = plan_for(device, start, budget)
    state, best, court = _with_cells(batch), batch.scratch(), new_court(batch)
    energy = wp.zeros((batch.size, max(batch.objects, 1)), dtype=wp.float32, device=device)
    total = wp.zeros(batch.size, dtype=wp.float32, device=device)
    best_total = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
    open_ = wp.full(batch.size, 1, dtype=wp.int32, device=device)
    clock, left, more = (wp.zeros(1, dtype=wp.int32, device=device) for _ in range(3))
    solved = 0
    if start == "given":  # what is in order already is left alone
        status = judge(batch).status
        open_.assign((status != 0).astype(np.int32))
        best_total.assign(np.where(status == 0, 0.0, np.inf).astype(np.float32))
        solved = int(np.sum(status == 0))
        monitor.add(solved, solved, 0.0)

    def step() -> None:
        """One round of every open candidate."""
        common = [batch.tables, batch.margins, batch.weights, plan, batch.problem, open_, clock]
        launch_lanes(begin, batch, common, [state])
        if batch.objects > CROWD:
            wp.launch(enter_cells, batch.size, [batch.tables, batch.problem, open_], [state], device=device)
        launch_lanes(search, batch, common, [state, energy, total])
        wp.launch(
            keep_best,
            batch.size,
            [batch.tables, batch.problem, open_, batch.state, total],
            [best, best_total],
            device=device,
        )
        wp.launch(set_turns, state.poses.shape, [state.poses], [state.turns], device=device)
        sit(batch, court, open_)
        wp.launch(tick, 1, [], [clock, left], device=device)
        wp.launch(close, batch.size, [court.status], [open_, left], device=device)
        wp.launch(proceed, 1, [clock, left, plan.steps], [more], device=device)

    if solved < batch.size and not monitor.expired():
        if device == "cpu" or monitor.watched:
            for _ in range(plan.steps):
                step()
                done = batch.size - int(left.numpy()[0])
                if done > solved:
                    monitor.add(done - solved, done - solved, 0.0)
                    solved = done
                if solved == batch.size or monitor.expired():
                    break
        else:
            more.fill_(1)
            repeat_while(device, more, step)
            done = batch.size - int(left.numpy()[0])
            monitor.add(done - solved, done - solved, 0.0)
            solved = done
    if solved < batch.size:  # the others get the best layout that they had
        again = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
        wp.launch(
            keep_best,
            batch.size,
            [batch.tables, batch.problem, open_, best, best_total],
            [batch.state, again],
            device=device,
        )
    energies = best_total.numpy()
    if solved < batch.size:
        monitor.add(batch.size - solved, 0, float(energies[open_.numpy() == 1].min()))
    return Outcome(energies)
