"""The loop that update rules share: gradients and a step, two buffers, the best of each candidate."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import asdict, dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels import gradients, gradients_gpu
from sceneweaver.kernels.descent import DescentMemory, Schedule, StepBuffer, UpdateRule
from sceneweaver.kernels.step import Gradients, add_up, choose, measure, take_best
from sceneweaver.kernels.tables import STATE, State
from sceneweaver.kernels.warp_primitives import WARP_SIZE

from .base import Checkpoint, Monitor, OptimizerResult
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


def new_gradients(batch: Batch, fill: float = 0.0) -> Gradients:
    """Room for shares and gradients of a batch."""
    found = Gradients()
    found.share, found.gradient = per_object(batch, wp.float32, fill), per_object(batch, wp.vec4, fill)
    return found


class DescentRun:
    """A descent under way, in stretches of `REASSIGN` steps; every candidate ends at the lowest energy it passed."""

    def __init__(self, batch: Batch, rule: UpdateRule, schedule: Schedule) -> None:
        """Begin at the batch's poses; ``rule`` says how a step is taken, ``schedule`` step sizes and their number."""
        device, layouts = batch.device, [by_object(batch.state) for _ in range(2)]  # time may run out at once
        self.batch, self.memory = batch, DescentMemory()
        self.memory.mean = per_object(batch, wp.vec4) if rule.keeps_mean else wp.zeros((1, 1), wp.vec4, device=device)
        self.memory.square, self.memory.best = per_object(batch, wp.vec4), per_object(batch, wp.vec4).transpose()
        self.memory.rng = batch.state.rng
        self.buffers = [StepBuffer(), StepBuffer()]
        for buffer, state in zip(self.buffers, layouts, strict=True):
            buffer.poses, buffer.turns = state.poses, state.turns
            buffer.share = per_object(batch, wp.float32, np.inf)
            buffer.lowest = wp.full(batch.size, np.inf, dtype=wp.float32, device=device)
            buffer.clock = wp.zeros(1, dtype=wp.int32, device=device)
        self.block = Launches(device)
        add_choice(self.block, batch, layouts[0], [state.options for state in layouts])
        self._chosen = len(self.block)  # launches before the steps: none without relations
        each = new_gradients(batch)
        for k in range(REASSIGN):
            now, other = self.buffers[k % 2], self.buffers[(k + 1) % 2]
            add_gradients(self.block, batch, layouts[k % 2], now.lowest, each)
            inputs = [batch.problems, schedule, each]
            outputs = [self.memory, now, other]
            self.block.add(rule.kernel, threads(batch, batch.objects), inputs, outputs, block=BLOCK)
        self._last = 1  # the buffer of the last step

    def play(self, monitor: Monitor, steps: int) -> None:
        """Take so many steps, or fewer when time runs out. After an incomplete stretch no more may follow."""
        per_step = (len(self.block) - self._chosen) // REASSIGN
        times, rest = divmod(steps, REASSIGN)
        done = self.block.play(monitor, times, self._chosen + per_step * rest if rest else 0)
        self._last = (rest + 1) % 2 if done else 1

    def best(self) -> wp.array:
        """The batch's poses, which are each candidate's best so far."""
        self.finish()
        return self.batch.state.poses

    def finish(self) -> wp.array:
        """Give the batch each candidate's best poses so far; their energies [B] float32, on the device."""
        batch, last, before = self.batch, self.buffers[self._last], self.buffers[1 - self._last]
        total = wp.zeros(batch.size, dtype=wp.float32, device=batch.device)
        wp.launch(add_up, batch.size, [batch.problems, last.share], [total], device=batch.device)
        return finish(batch, last.poses, total, self.memory.best, before.lowest)


def descend(
    batch: Batch, rule: UpdateRule, schedule: Schedule, monitor: Monitor, whole: bool = True, energies: int = 0
) -> Generator[Checkpoint, None, wp.array]:
    """Take all of a schedule's steps in place, unless time runs out; the candidates' energies [B] on the device.

    ``energies``: of each candidate that were measured before.
    """
    run, left = DescentRun(batch, rule, schedule), schedule.steps + 1  # the last step measures where the one before led
    while left and not monitor.timed_out:
        steps = left if whole else min(REASSIGN, left)
        run.play(monitor, steps)
        left, energies = left - steps, energies + steps
        yield Checkpoint(run.best, energies)
    return run.finish()


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


def add_gradients(block: Launches, batch: Batch, state: State, lowest: wp.array, each: Gradients) -> None:
    """Measure every object's share of the energy and its gradient at the state's poses.

    Candidates whose ``lowest`` energy so far is that of rest are left out.
    """
    wanted = (gradients.WHOLE,) if batch.device == "cpu" else gradients_gpu.GROUPS
    for kinds, kernel in wanted:
        if kinds & batch.terms:
            block.add(kernel, threads(batch, batch.objects), [batch.problems, state, lowest], [each], block=BLOCK)


def add_measure(block: Launches, batch: Batch, state: State, roots: Gradients) -> None:
    """Measure every root's share of the energy and its scaled gradient at the state's poses."""
    restless = wp.full(batch.size, np.inf, dtype=wp.float32, device=batch.device)
    each = new_gradients(batch)
    add_gradients(block, batch, state, restless, each)
    block.add(measure, threads(batch, batch.objects), [batch.problems, state, each], [roots], block=BLOCK)


def energy_of(batch: Batch) -> wp.array:
    """Choose every relation's best option in place; energies [B] float32 of the batch's poses, on the device."""
    roots, block = new_gradients(batch), Launches(batch.device)
    total = wp.zeros(batch.size, dtype=wp.float32, device=batch.device)
    add_choice(block, batch, batch.state, [batch.state.options, batch.state.options])
    add_measure(block, batch, batch.state, roots)
    block.add(add_up, batch.size, [batch.problems, roots.share], [total])
    block.run()
    return total


def outcome(batch: Batch, total: wp.array, monitor: Monitor) -> OptimizerResult:
    """Report a refined batch and hand over its energies."""
    energy = total.numpy()
    monitor.add(batch.size, int(np.sum(judge(batch).status == 0)), float(energy.min(initial=np.inf)))
    return OptimizerResult(energy)
