"""L-BFGS: each candidate by its own quasi-Newton steps, pushed on from minima that are no solution."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels.lbfgs import SLOTS, History, Line, make_trial, search_line
from sceneweaver.kernels.step import Gradients
from sceneweaver.kernels.tables import State

from .base import Monitor, OptimizerResult, Start, register
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
from .launches import Launches
from .starts import draw_starts

STEPS = 400
PUSH = {"given": 0.3, "random": 0.9, "sample": 0.9}  # [m] out of a minimum, at the start of the run
UNROLL = 20  # steps in one graph


@dataclass
class Workspace:
    """What L-BFGS keeps beside the batch; ``trial`` is the layout that is measured next."""

    trial: State
    measured: Gradients
    history: History
    line: Line


def workspace(batch: Batch) -> Workspace:
    """A workspace before the first step: the first trial is the batch's poses."""
    shape, device = (int(SLOTS), max(batch.objects, 1), batch.size), batch.device
    trial = batch.scratch()
    trial.anchors = batch.state.anchors
    wp.copy(trial.poses, batch.state.poses)
    wp.copy(trial.turns, batch.state.turns)
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
    return Workspace(trial, new_gradients(batch), history, line)


def one_step(block: Launches, batch: Batch, work: Workspace, push: float, steps: int) -> None:
    """Append one step: measure the trial, decide on it, make the next."""
    trial, measured = work.trial, work.measured
    add_choice(block, batch, trial, [trial.options, trial.options])
    add_measure(block, batch, trial, measured)
    block.add(search_line, batch.size, [batch.problems, measured], [work.history, work.line])
    inputs = [batch.problems, push, steps, measured]
    block.add(make_trial, threads(batch, batch.objects), inputs, [work.line, batch.state, trial])


@register("lbfgs", modules=(*MEASURED, "lbfgs"), on_gpu=(*MEASURED_ON_GPU, "lbfgs"))
def run_lbfgs(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
    """Refine every candidate by ``budget`` steps (default 400), one energy each; it ends at the lowest it passed."""
    draw_starts(batch, start)
    steps = budget or STEPS
    work, block = workspace(batch), Launches(batch.device, UNROLL)
    one_step(block, batch, work, PUSH[start], steps)
    block.play(monitor, steps + 1)  # the first only measures the start
    total = finish(batch, batch.state.poses, work.line.energy, work.line.best, work.line.lowest)
    return outcome(batch, total, monitor)
