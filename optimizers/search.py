"""Search (default): guided moves, annealing, polish, judge, and failures start again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import (
    advance_clock,
    check_continue,
    keep_best,
    release,
    retire,
    set_turns,
    take_best_found,
)
from sceneweaver.kernels.cells import CELLS, CROWD, enter_cells
from sceneweaver.kernels.jobs import BACK_STEPS, JobResult, Jobs, Proposals, SearchState
from sceneweaver.kernels.plan import Plan, SearchRun
from sceneweaver.kernels.proposals import draw, rate, take_gradients
from sceneweaver.kernels.rounds import advance, start_rounds
from sceneweaver.kernels.search import search
from sceneweaver.kernels.tables import STATE, State
from sceneweaver.kernels.verdict import DeviceVerdict

from .base import Blocks, Checkpoint, Monitor, OptimizerResult, Start, register_blocks
from .batch import Batch, threads_per_candidate
from .launches import Launches, repeat_while, repeatable
from .starts import STARTS, add_start, new_run
from .verdict import add_verdict, new_device_verdict, write_verdict

CLOSE = 0.1  # [m] energy below which further attempts are worth their time
HOPEFUL, EARLY = 0.6, 3
"""Of a single attempt on a CPU, after so many rounds, the energy [m] above which a candidate is given up. Measured on
rooms of data sets: half of those that would stay invalid, and a tenth of the others."""

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
    plan.eases_from = 0 if first == 1 else effort.rounds * max(first // 8, 1)
    plan.eases_over = effort.rounds * first
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


def gives_up(device: str, start: Start, budget: int | None) -> bool:
    """Whether what is far from valid is not followed to the end of its attempt: where there is one alone."""
    return device == "cpu" and start != "given" and budget == 1


def energies_of_round(plan: Plan) -> int:
    """About how many energies a round costs a candidate.

    Every movable object has ``moves``, each rates the pose that it has and some proposals, and a rating costs that
    object's share of an energy; beside that a survey, the polish and the verdict.
    """
    return plan.moves * (1 + plan.proposals) + plan.polish * (1 + plan.tries) + 2


def best_found(batch: Batch, run: SearchRun, verdict: DeviceVerdict) -> wp.array:
    """The valid poses of each candidate, else those of the lowest energy so far [B, N], copied."""
    found = batch.scratch()
    wp.copy(found.poses, batch.state.poses)
    wp.launch(take_best_found, found.poses.shape, [batch.problems, run, verdict], [found], device=batch.device)
    return found.poses


def extend_state(batch: Batch) -> State:
    """The batch's state with what only a search keeps: ratings, what was released, and cells where they pay."""
    state = State()
    for table in STATE:
        setattr(state, table.name, getattr(batch.state, table.name))
    state.released, state.rating = (
        wp.zeros_like(state.mark),
        wp.zeros(state.mark.shape, dtype=wp.float32, device=batch.device),
    )
    if batch.objects > CROWD:
        state.cell_head = wp.zeros((batch.size, CELLS), dtype=wp.int32, device=batch.device)
        state.cell_next = wp.zeros((batch.size, batch.objects), dtype=wp.int32, device=batch.device)
        state.cell_of = wp.zeros_like(state.cell_next)
    return state


def new_jobs(batch: Batch) -> tuple[Jobs, Jobs]:
    """The jobs of a batch twice, with the two queues swapped: what follows a job of one is a job of the other."""
    one, other = Jobs(), Jobs()
    one.state = wp.zeros(batch.size, dtype=SearchState, device=batch.device)  # pyright: ignore[reportArgumentType]
    one.result = wp.zeros(batch.size, dtype=JobResult, device=batch.device)  # pyright: ignore[reportArgumentType]
    one.queue, one.next_queue = (wp.zeros(batch.size, dtype=wp.int32, device=batch.device) for _ in range(2))
    one.queued, one.next_queued = (wp.zeros(1, dtype=wp.int32, device=batch.device) for _ in range(2))
    other.state, other.result = one.state, one.result
    other.queue, other.queued = one.next_queue, one.next_queued
    other.next_queue, other.next_queued = one.queue, one.queued
    return one, other


class Rounds:
    """One round of every active candidate: in one launch, or in three for every job, for as long as anyone has one."""

    def __init__(
        self, batch: Batch, state: State, plan: Plan, run: SearchRun, block: Launches, in_one: bool | None = None
    ) -> None:
        """Append a round to a block. ``in_one``: all jobs of a candidate in one launch (default: on a CPU)."""
        tried = (batch.size, max(1 + plan.proposals, plan.tries, int(BACK_STEPS)))
        self.batch, self.state, self.plan = batch, state, plan
        self.proposals = Proposals()
        self.proposals.poses = wp.zeros(tried, dtype=wp.vec4, device=batch.device)
        self.proposals.drafts = wp.zeros(tried, dtype=wp.int32, device=batch.device)
        add_start(block, batch, state, plan, run)
        if batch.objects > CROWD:
            block.add(enter_cells, batch.size, [batch.problems, run], [state])
        common = [batch.problems, plan]
        if in_one or (in_one is None and batch.device == "cpu"):
            block.add(search, batch.size, common, [state, self.proposals, run])
            return
        one, other = new_jobs(batch)
        block.add(start_rounds, batch.size, [*common, run], [state, one])
        two_jobs = Launches(batch.device)
        self._add_job(two_jobs, one, run)
        self._add_job(two_jobs, other, run)
        block.add_loop(one.queued, two_jobs)

    def _add_job(self, block: Launches, jobs: Jobs, run: SearchRun) -> None:
        """Append the next job of every candidate."""
        batch, state, common = self.batch, self.state, [self.batch.problems, self.plan]
        lanes = threads_per_candidate(batch.device)
        threads = 128 if batch.objects <= CROWD else 64  # in a crowd warps of a block take unlike times
        drawers = min(1 + self.plan.proposals, lanes)
        block.add(draw, (batch.size, drawers), common, [state, self.proposals, jobs], 128)
        block.add(rate, batch.size * lanes, [*common, self.proposals], [state, jobs], threads)
        if self.plan.polish:
            block.add(take_gradients, batch.size * lanes, [batch.problems, state], [jobs], 64)
        block.add(advance, batch.size, common, [state, jobs, run], 64)


@register_blocks("search", ("starts", "cells", "search"), ("starts", "cells", "rounds", "proposals"))
def search_blocks(batch: Batch, start: Start, budget: int | None, monitor: Monitor, whole: bool) -> Blocks:
    """Search every candidate until it is valid; ``budget`` is the number of attempts (default 10, on a GPU, whose
    attempts are shorter, 40; three times as many for those that are close to valid by then). Of a single one on a CPU
    those candidates see no end that are far from valid early on.

    The first attempt begins as ``start`` says, later ones by drawing from the relations. A candidate that never gets
    valid ends at the lowest energy found. On a GPU the whole run is one graph: nothing comes back to the host until
    all are valid or the attempts are used up, unless there is a deadline or progress to report, or checkpoints are
    wanted (not ``whole``), which come after every round.
    """
    device = batch.device
    plan = plan_for(effort_for(device, start, batch.objects), start, budget)
    early = gives_up(device, start, budget)
    if early:
        plan.first_steps = EARLY
    state, run, verdict = extend_state(batch), new_run(batch), new_device_verdict(batch)
    if device == "cpu":
        run.cut = monitor.cut
    block, common = Launches(device), [batch.problems]
    solved = 0
    if start == "given":  # what is in order already is left alone
        write_verdict(batch, verdict, run.active)
        status = verdict.status.numpy()
        run.active.assign((status != 0).astype(np.int32))
        for best in (run.best_total, run.best_hard):
            best.assign(np.where(status == 0, 0.0, np.inf).astype(np.float32))
        solved = int(np.sum(status == 0))
        monitor.add(solved, solved, 0.0)
        block.add(release, batch.size, [*common, plan, run, verdict], [state])
    Rounds(batch, state, plan, run, block)
    block.add(keep_best, batch.size, [*common, state], [run])
    block.add(set_turns, state.poses.shape, [state.poses], [state.turns])
    add_verdict(block, batch, verdict, run.active)
    block.add(advance_clock, 1, [], [run])
    block.add(retire, batch.size, [plan, HOPEFUL if early else CLOSE, verdict], [run])

    if solved < batch.size and (monitor.done == 0 or not monitor.expired()):  # late or not, one layout comes out of it
        if device == "cpu" or monitor.watched or not whole:
            one_round = repeatable(device, block)
            best = partial(best_found, batch, run, verdict)
            for rounds in range(1, plan.steps + 1):
                one_round()
                left = run.left.numpy()
                done = batch.size - int(left.sum())
                if done > solved:
                    monitor.add(done - solved, done - solved, 0.0)
                    solved = done
                yield Checkpoint(best, rounds * energies_of_round(plan))
                if left[0] == 0 or monitor.expired():
                    break
        else:
            block.add(check_continue, 1, [plan], [run])
            run.more.fill_(1)
            repeat_while(device, run.more, block)
            done = batch.size - int(run.left.numpy().sum())
            monitor.add(done - solved, done - solved, 0.0)
            solved = done
    energies = run.best_total.numpy()
    if solved < batch.size:
        wp.launch(take_best_found, state.poses.shape, [*common, run, verdict], [batch.state], device=device)
        unsolved = (run.active.numpy() != 0) | (verdict.status.numpy() != 0)
        monitor.add(batch.size - solved, 0, float(energies[unsolved].min()))
    return OptimizerResult(energies)
