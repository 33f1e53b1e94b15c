"""Search (default): guided moves, annealing, polish, judge, and failures start again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import advance_clock, check_continue, keep_best, release, retire, set_turns
from sceneweaver.kernels.cells import CELLS, CROWD, enter_cells
from sceneweaver.kernels.jobs import BACK_STEPS, JobResult, SearchState
from sceneweaver.kernels.proposals import draw, rate, take_gradients
from sceneweaver.kernels.rounds import advance, start_rounds
from sceneweaver.kernels.search import search
from sceneweaver.kernels.starts import Plan, start_attempt
from sceneweaver.kernels.tables import STATE, State

from .base import Monitor, OptimizerResult, Start, register
from .batch import Batch, launch_verdict, new_device_verdict, threads_per_candidate
from .launches import repeat_while, repeatable
from .starts import STARTS, launch_warps

CLOSE = 0.1  # [m] energy below which further attempts are worth their time
SOFT_MOVES = 2
TEMPERATURE = 0.3  # [m]
ANCHORED_TEMPERATURE = 0.05  # the same when little should move


@dataclass(frozen=True)
class Effort:
    """How a search spends its time; what it stands for is said in ``Plan``."""

    attempts: int
    most_attempts: int
    rounds: int
    moves: int
    proposals: int
    slide: float
    whole: float
    rates: bool
    polish: int
    tries: int
    anchored_attempts: int = 4


CPU = Effort(
    attempts=10, most_attempts=30, rounds=8, moves=4, proposals=5, slide=0.35, whole=0.5, rates=True, polish=6, tries=3
)
# A GPU tries many poses in the time of one, so that it needs fewer moves; measured on one H200 (docs/gpu.md).
GPU = Effort(
    attempts=40,
    most_attempts=120,
    rounds=1,
    moves=6,
    proposals=15,
    slide=0.2,
    whole=0.8,
    rates=False,
    polish=0,
    tries=4,
)
GPU_CROWD = replace(GPU, proposals=7)
GPU_ANCHORED = replace(GPU, rounds=2, moves=3, slide=0.35, whole=0.5, rates=True, polish=1, anchored_attempts=8)


def effort_for(device: str, start: Start, objects: int) -> Effort:
    """The effort that suits a kind of device, a start and a number of objects."""
    if device == "cpu":
        return CPU
    if start == "given":
        return GPU_ANCHORED
    return GPU if objects <= CROWD else GPU_CROWD


def plan_for(effort: Effort, start: Start, attempts: int | None) -> Plan:
    """The plan of a search; ``attempts`` replaces those of the effort."""
    plan = Plan()
    plan.rounds = effort.rounds
    first = effort.attempts if attempts is None else attempts
    most = first if attempts is not None or start == "given" else effort.most_attempts
    plan.first_steps, plan.steps = effort.rounds * first, effort.rounds * most
    plan.start, plan.anchored_attempts = STARTS[start], effort.anchored_attempts
    plan.moves, plan.proposals, plan.tries = effort.moves, effort.proposals, effort.tries
    plan.slide, plan.whole, plan.rates = effort.slide, effort.whole, int(effort.rates)
    plan.polish, plan.soft_moves, plan.temperature, plan.anchored_temperature = (
        effort.polish,
        SOFT_MOVES,
        TEMPERATURE,
        ANCHORED_TEMPERATURE,
    )
    return plan


def extend_state(batch: Batch) -> State:
    """The batch's state with what only a search keeps: the objects released so far, and cells where they pay."""
    state = State()
    for table in STATE:
        setattr(state, table.name, getattr(batch.state, table.name))
    state.released = wp.zeros_like(state.mark)
    if batch.objects > CROWD:
        state.cell_head = wp.zeros((batch.size, CELLS), dtype=wp.int32, device=batch.device)
        state.cell_next = wp.zeros((batch.size, batch.objects), dtype=wp.int32, device=batch.device)
        state.cell_of = wp.zeros_like(state.cell_next)
    return state


class Rounds:
    """One round of every active candidate: in one launch, or in three for every job, for as long as anyone has one."""

    def __init__(
        self, batch: Batch, state: State, plan: Plan, active: wp.array, clock: wp.array, in_one: bool | None = None
    ) -> None:
        """``in_one``: all jobs of a candidate in one launch (default: on a CPU)."""
        device, tried = batch.device, max(1 + plan.proposals, plan.tries, int(BACK_STEPS))
        self.batch, self.state, self.plan, self.active, self.clock = batch, state, plan, active, clock
        self.common = [batch.problems, plan]
        self.energy = wp.zeros((batch.size, max(batch.objects, 1)), dtype=wp.float32, device=device)
        self.total = wp.zeros(batch.size, dtype=wp.float32, device=device)
        # the poses that are tried, and whether they take surfaces laid out anew
        self.proposals = [wp.zeros((batch.size, tried), dtype=dtype, device=device) for dtype in (wp.vec4, wp.int32)]
        self.in_one = device == "cpu" if in_one is None else in_one
        if not self.in_one:
            self.search_state = wp.zeros(batch.size, dtype=SearchState, device=device)  # pyright: ignore[reportArgumentType]
            self.result = wp.zeros(batch.size, dtype=JobResult, device=device)  # pyright: ignore[reportArgumentType]
            self.busy = wp.zeros(1, dtype=wp.int32, device=device)

    def launch(self) -> None:
        """Start the attempt where one is due, then search."""
        batch, state = self.batch, self.state
        launch_warps(start_attempt, batch, [*self.common, self.active, self.clock], [state])
        if batch.objects > CROWD:
            wp.launch(enter_cells, batch.size, [batch.problems, self.active], [state], device=batch.device)
        if self.in_one:
            self._launch(
                search, batch.size, [self.active, self.clock, state], [self.energy, *self.proposals, self.total]
            )
        else:
            self._launch(start_rounds, batch.size, [self.active, self.clock, state], [self.search_state, self.busy])
            wp.capture_while(self.busy, self._job)

    def _job(self) -> None:
        """The next job of every candidate."""
        size, seen = self.batch.size, [self.search_state, self.state]
        lanes = threads_per_candidate(self.batch.device)
        drawers = min(1 + self.plan.proposals, lanes)
        self._launch(draw, (size, drawers), seen, [*self.proposals, self.busy], 128)
        self._launch(rate, size * lanes, [*seen, *self.proposals], [self.energy, self.result], 64)
        if self.plan.polish:
            self._launch(take_gradients, size * lanes, seen, [self.result], 64)
        self._launch(
            advance,
            size,
            [self.result, self.state],
            [self.energy, self.search_state, self.total, self.busy],
            64,
        )

    def _launch(self, kernel: Any, dim: Any, inputs: list, outputs: list, block: int = 256) -> None:
        wp.launch(kernel, dim, [*self.common, *inputs], outputs, device=self.batch.device, block_dim=block)


@register("search", modules=("starts", "cells", "search"), on_gpu=("starts", "cells", "rounds", "proposals"))
def run_search(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
    """Search every candidate until it is valid; ``budget`` is the number of attempts (default 10, on a GPU, whose
    attempts are shorter, 40; three times as many for those that are close to valid by then).

    The first attempt begins as ``start`` says, later ones by drawing from the relations. A candidate that never gets
    valid ends at the lowest energy found. On a GPU the whole run is one graph: nothing comes back to the host until
    all are valid or the attempts are used up, unless there is a deadline or progress to report.
    """
    device = batch.device
    plan = plan_for(effort_for(device, start, batch.objects), start, budget)
    state, best, verdict = extend_state(batch), batch.scratch(), new_device_verdict(batch)
    best_total = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
    active = wp.full(batch.size, 1, dtype=wp.int32, device=device)
    clock, left, more = (wp.zeros(n, dtype=wp.int32, device=device) for n in (1, 2, 1))
    rounds = Rounds(batch, state, plan, active, clock)
    solved = 0
    if start == "given":  # what is in order already is left alone
        launch_verdict(batch, verdict, active)
        status = verdict.status.numpy()
        active.assign((status != 0).astype(np.int32))
        best_total.assign(np.where(status == 0, 0.0, np.inf).astype(np.float32))
        solved = int(np.sum(status == 0))
        monitor.add(solved, solved, 0.0)

    release_inputs = [batch.problems, plan.rounds, plan.anchored_attempts]

    def step() -> None:
        """One round of every active candidate, and the verdict on it."""
        if start == "given":
            wp.launch(
                release,
                batch.size,
                [*release_inputs, active, clock, verdict.fault, verdict.holds],
                [state.released],
                device=device,
            )
        rounds.launch()
        wp.launch(
            keep_best,
            batch.size,
            [batch.problems, active, batch.state, rounds.total],
            [best, best_total],
            device=device,
        )
        wp.launch(set_turns, state.poses.shape, [state.poses], [state.turns], device=device)
        launch_verdict(batch, verdict, active)
        wp.launch(advance_clock, 1, [], [clock, left], device=device)
        wp.launch(
            retire,
            batch.size,
            [batch.problems, plan.first_steps, CLOSE, clock, verdict.status, best, best_total],
            [active, batch.state, left],
            device=device,
        )
        wp.launch(check_continue, 1, [clock, left, plan.steps], [more], device=device)

    if solved < batch.size and not monitor.expired():
        if device == "cpu" or monitor.watched:
            advance = repeatable(device, step)
            for _ in range(plan.steps):
                advance()
                done = batch.size - int(left.numpy().sum())
                if done > solved:
                    monitor.add(done - solved, done - solved, 0.0)
                    solved = done
                if left.numpy()[0] == 0 or monitor.expired():
                    break
        else:
            more.fill_(1)
            repeat_while(device, more, step)
            done = batch.size - int(left.numpy().sum())
            monitor.add(done - solved, done - solved, 0.0)
            solved = done
    if solved < batch.size:  # the others get the best layout that they had
        again = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
        wp.launch(
            keep_best,
            batch.size,
            [batch.problems, active, best, best_total],
            [batch.state, again],
            device=device,
        )
    energies = best_total.numpy()
    if solved < batch.size:
        unsolved = (active.numpy() != 0) | (verdict.status.numpy() != 0)
        monitor.add(batch.size - solved, 0, float(energies[unsolved].min()))
    return OptimizerResult(energies)
