"""Annealed Langevin dynamics: gradient and noise of one temperature, which falls to zero, then a quiet descent."""

from __future__ import annotations

from sceneweaver.kernels.adam import Schedule
from sceneweaver.kernels.langevin import langevin_step

from .base import Monitor, OptimizerResult, Start, register
from .batch import Batch
from .descent import MEASURED, MEASURED_ON_GPU, descend, outcome, schedule_of
from .starts import draw_starts

STEPS = 400


def _schedule(steps: int, start: Start) -> Schedule:
    if start == "given":
        return schedule_of(steps, rate=0.05, rate_end=0.0005, noise=0.003, quiet=0.6)
    return schedule_of(steps, rate=0.15, rate_end=0.0005, noise=0.1, quiet=0.7)


@register("langevin", modules=(*MEASURED, "langevin"), on_gpu=(*MEASURED_ON_GPU, "langevin"))
def run_langevin(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
    """Refine every candidate by ``budget`` steps (default 400); each ends at the lowest energy it passed."""
    draw_starts(batch, start)
    total = descend(batch, langevin_step, _schedule(budget or STEPS, start), 1, monitor)
    return outcome(batch, total, monitor)
