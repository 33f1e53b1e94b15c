"""L-BFGS: each candidate by its own quasi-Newton steps, pushed on from minima that are no solution."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels.lbfgs import SLOTS, History, Line, make_trial, search_line
from sceneweaver.kernels.step import Gradients
from sceneweaver.kernels.tables import State

from .base import Blocks, Checkpoint, Monitor, Start, register_blocks
from .batch import Batch
from .descent import (
    MEASURED,
    MEASURED_ON_GPU,
    add_choice,
    add_measure,
    finish,
    new_gradients,
    outcome,
    per_object,
    threads,
)
from .launches import Launches, blocks_of
from .starts import draw_starts

STEPS = 400
PUSH_GIVEN, PUSH = 0.3, 0.9  # [m] out of a minimum at the start of the run, from given poses and from drawn ones
UNROLL = 20  # steps in one graph


@dataclass
class Workspace:
    """What L-BFGS keeps beside the batch: the layouts where it is, and ``trial``, those that are measured next."""

    layout: State
    trial: State
    measured: Gradients
    history: History
    line: Line


def workspace(batch: Batch) -> Workspace:
    """A workspace before the first step: the first trial is the batch's poses."""
    shape, device = (int(SLOTS), max(batch.objects, 1), batch.size), batch.device
    layout, trial = batch.scratch(), batch.scratch()
    layout.rng = batch.state.rng
    trial.anchors = batch.state.anchors
    for state in (layout, trial):
        wp.copy(state.poses, batch.state.poses)
        wp.copy(state.turns, batch.state.turns)
    history, line = History(), Line()
    history.steps = wp.zeros(shape, dtype=wp.vec4, device=device)
    history.gradient_changes = wp.zeros(shape, dtype=wp.vec4, device=device)
    for name in ("count", "head"):
        setattr(history, name, wp.zeros(batch.size, dtype=wp.int32, device=device))
    for name in ("energy", "lowest"):
        setattr(line, name, wp.full(batch.size, np.inf, dtype=wp.float32, device=device))
    for name in ("step_length", "slope"):
        setattr(line, name, wp.zeros(batch.size, dtype=wp.float32, device=device))
    for name in ("tries", "idle", "state"):
        setattr(line, name, wp.zeros(batch.size, dtype=wp.int32, device=device))
    line.gradient, line.direction = per_object(batch, wp.vec4), per_object(batch, wp.vec4)
    line.clock, line.best = wp.zeros(1, dtype=wp.int32, device=device), wp.zeros_like(trial.poses)
    return Workspace(layout, trial, new_gradients(batch), history, line)


def one_step(block: Launches, batch: Batch, work: Workspace, push: float, steps: int) -> None:
    """Append one step: measure the trial, decide on it, make the next."""
    trial, measured = work.trial, work.measured
    add_choice(block, batch, trial, [trial.options, trial.options])
    add_measure(block, batch, trial, measured)
    block.add(search_line, batch.size, [batch.problems, measured], [work.history, work.line])
    inputs = [batch.problems, push, steps, measured]
    block.add(make_trial, threads(batch, batch.objects), inputs, [work.line, work.layout, trial])


@register_blocks("lbfgs", (*MEASURED, "lbfgs"), (*MEASURED_ON_GPU, "lbfgs"))
def lbfgs_blocks(batch: Batch, start: Start, budget: int | None, monitor: Monitor, whole: bool) -> Blocks:
    """Refine every candidate by ``budget`` steps (default 400), one energy each; it ends at the lowest it passed."""
    draw_starts(batch, start)
    steps = budget or STEPS
    work, block = workspace(batch), Launches(batch.device, UNROLL)
    one_step(block, batch, work, PUSH_GIVEN if start == "given" else PUSH, steps)

    def energies_of_best() -> wp.array:
        return finish(batch, work.layout.poses, work.line.energy, work.line.best, work.line.lowest)

    def best() -> wp.array:
        energies_of_best()
        return batch.state.poses

    for done in blocks_of(steps + 1, UNROLL, whole, block, monitor):  # the first step only measures the start
        yield Checkpoint(best, done)
    return outcome(batch, energies_of_best(), monitor)
