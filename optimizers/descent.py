"""The loop that update rules share: gradients and a step, two buffers, the best of each candidate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels import gradients, gradients_gpu
from sceneweaver.kernels.descent import Schedule, UpdateRule
from sceneweaver.kernels.step import add_up, choose, measure, take_best
from sceneweaver.kernels.tables import STATE, State
from sceneweaver.kernels.warp_primitives import WARP_SIZE

from .base import Monitor, OptimizerResult
from .batch import Batch
from .launches import Launches
from .verdict import judge

BLOCK = 64  # threads: the fastest of 32, 64, 128 and 256 on an H200
# Modules of the kernels that are launched here.
MEASURED, MEASURED_ON_GPU = ("step", "gradients"), ("step", "gradients_gpu")
REASSIGN = 20  # steps between two looks at which wall or side each relation means; even: both buffers had their turn


@dataclass(frozen=True)
class Settings:
    """What a schedule is made of; units as in ``kernels.descent.Schedule``."""

    rate: float
    rate_end: float
    noise: float
    quiet: float

    def schedule(self, steps: int) -> Schedule:
        """The schedule of a run of so many steps."""
        schedule = Schedule()
        schedule.steps = steps
        for name, value in asdict(self).items():
            setattr(schedule, name, value)
        return schedule


def threads(batch: Batch, each: int) -> tuple[int, int, int]:
    """Launch dimensions of kernels that take ``each`` objects or relations of every candidate: groups, each, lanes."""
    return -(-batch.size // WARP_SIZE), each, WARP_SIZE


def per_object(batch: Batch, dtype: type, fill: float = 0.0) -> wp.array:
    """An array [object, candidate], the order in which warps read what is private to an optimiser."""
    return wp.full((max(batch.objects, 1), batch.size), dtype(fill), dtype=dtype, device=batch.device)


def by_object(state: State) -> State:
    """The same layouts stored object by object, in which order warps read an object of neighbouring candidates."""
    found = State()
    for table in STATE:
        setattr(found, table.name, getattr(state, table.name))
    for name in ("poses", "turns", "options", "anchors"):
        rows = getattr(state, name)
        columns = wp.empty(rows.shape[::-1], dtype=rows.dtype, device=rows.device).transpose()
        wp.copy(columns, rows)
        setattr(found, name, columns)
    return found


def descend(batch: Batch, rule: UpdateRule, schedule: Schedule, monitor: Monitor) -> wp.array:
    """Take all of a schedule's steps in place; every candidate ends at the lowest energy that it passed.

    Args:
        batch: the candidates, at the poses to start from.
        rule: how a step is taken.
        schedule: step sizes and the number of steps.
        monitor: may stop the descent before its end.

    Returns:
        The candidates' energies [B] float32, on the device.
    """
    device, state = batch.device, by_object(batch.state)
    other = by_object(batch.state)  # time may run out before the first step
    mean = per_object(batch, wp.vec4) if rule.keeps_mean else wp.zeros((1, 1), dtype=wp.vec4, device=device)
    square = per_object(batch, wp.vec4)
    best = per_object(batch, wp.vec4).transpose()
    share = [per_object(batch, wp.float32, np.inf) for _ in range(2)]
    lowest = [wp.full(batch.size, np.inf, dtype=wp.float32, device=device) for _ in range(2)]
    clock = [wp.zeros(1, dtype=wp.int32, device=device) for _ in range(2)]
    layout = [state, other]

    block = Launches(device)
    add_choice(block, batch, state, [state.options, other.options])
    chosen = len(block)  # launches before the steps: none without relations
    part, each = per_object(batch, wp.float32), per_object(batch, wp.vec4)
    for k in range(REASSIGN):
        a, b = k % 2, (k + 1) % 2
        add_gradients(block, batch, layout[a], lowest[a], part, each)
        block.add(
            rule.kernel,
            threads(batch, batch.objects),
            [
                *(batch.problems, schedule),
                *(clock[a], layout[a], share[b], lowest[a], part, each, mean, square, layout[b].poses),
            ],
            [layout[b].turns, best, share[a], lowest[b], clock[b]],
            block=BLOCK,
        )
    each = (len(block) - chosen) // REASSIGN
    times, rest = divmod(schedule.steps + 1, REASSIGN)  # the last step is there to measure where the one before led
    done = block.play(monitor, times, chosen + each * rest if rest else 0)
    a = (rest + 1) % 2 if done else 1  # the buffers of the last step
    total = wp.zeros(batch.size, dtype=wp.float32, device=device)
    wp.launch(add_up, batch.size, [batch.problems, share[a]], [total], device=device)
    return finish(batch, layout[a].poses, total, best, lowest[1 - a])


def finish(batch: Batch, last: wp.array, total: wp.array, best: wp.array, lowest: wp.array) -> wp.array:
    """Give the batch the better of two layouts of each candidate, with their energies; the energies [B] of those."""
    wp.launch(
        take_best,
        (batch.size, batch.objects),
        [batch.problems, last, total, best, lowest],
        [batch.state.poses, batch.state.turns],
        device=batch.device,
    )
    return energy_of(batch)


def add_choice(block: Launches, batch: Batch, state: State, options: Sequence[wp.array]) -> None:
    """Let every relation take its best option at the state's poses; ``options``: the two arrays to write it to."""
    block.add(choose, threads(batch, batch.relations), [batch.problems, state], options)


def add_gradients(
    block: Launches, batch: Batch, state: State, lowest: wp.array, part: wp.array, gradient: wp.array
) -> None:
    """Measure every object's share of the energy and its gradient, [object, candidate], at the state's poses.

    Candidates whose ``lowest`` energy so far is that of rest are left out.
    """
    wanted = (gradients.WHOLE,) if batch.device == "cpu" else gradients_gpu.GROUPS
    inputs = [batch.problems, state, lowest]
    for kinds, kernel in wanted:
        if kinds & batch.terms:
            block.add(kernel, threads(batch, batch.objects), inputs, [part, gradient], block=BLOCK)


def add_measure(block: Launches, batch: Batch, state: State, share: wp.array, gradient: wp.array) -> None:
    """Measure every root's share of the energy and its scaled gradient, [object, candidate], at the state's poses."""
    restless = wp.full(batch.size, np.inf, dtype=wp.float32, device=batch.device)
    part, each = per_object(batch, wp.float32), per_object(batch, wp.vec4)
    add_gradients(block, batch, state, restless, part, each)
    inputs = [batch.problems, state.poses, part, each]
    block.add(measure, threads(batch, batch.objects), inputs, [share, gradient], block=BLOCK)


def energy_of(batch: Batch) -> wp.array:
    """Choose every relation's best option in place; energies [B] float32 of the batch's poses, on the device."""
    state, device = batch.state, batch.device
    share, gradient = per_object(batch, wp.float32), per_object(batch, wp.vec4)
    total = wp.zeros(batch.size, dtype=wp.float32, device=device)
    now = Launches(device)
    add_choice(now, batch, state, [state.options, state.options])
    add_measure(now, batch, state, share, gradient)
    now.add(add_up, batch.size, [batch.problems, share], [total])
    now.play(Monitor(0))
    return total


def outcome(batch: Batch, total: wp.array, monitor: Monitor) -> OptimizerResult:
    """Report a refined batch and hand over its energies."""
    energy = total.numpy()
    monitor.add(batch.size, int(np.sum(judge(batch).status == 0)), float(energy.min(initial=np.inf)))
    return OptimizerResult(energy)
