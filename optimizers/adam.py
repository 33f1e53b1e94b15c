"""Adam with annealed noise: the plain gradient method, good near a solution."""

from __future__ import annotations

from sceneweaver.kernels.adam import Schedule, adam_step

from .base import Monitor, OptimizerResult, Start, register
from .batch import Batch
from .descent import MEASURED, MEASURED_ON_GPU, descend, outcome, schedule_of
from .starts import draw_starts

STEPS = 400


def _schedule(steps: int, start: Start) -> Schedule:
    if start == "given":
        return schedule_of(steps, rate=0.04, rate_end=0.0005, noise=0.01, quiet=0.6)
    return schedule_of(steps, rate=0.12, rate_end=0.0005, noise=0.06, quiet=0.6)


@register("adam", modules=(*MEASURED, "adam"), on_gpu=(*MEASURED_ON_GPU, "adam"))
def run_adam(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
    """Refine every candidate by ``budget`` steps (default 400); each ends at the lowest energy it passed."""
    draw_starts(batch, start)
    total = descend(batch, adam_step, _schedule(budget or STEPS, start), 2, monitor)
    return outcome(batch, total, monitor)
