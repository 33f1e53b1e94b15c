"""Adam with annealed noise: the plain gradient method, good near a solution."""

from __future__ import annotations

import numpy as np
import warp as wp

from sceneweaver.kernels.adam import Schedule, adam_step, choose, tick
from sceneweaver.kernels.track import keep_best

from .base import Monitor, Outcome, Start, register
from .batch import Batch, judge
from .search import draw_starts

STEPS = 400
REASSIGN = 20  # steps between two looks at which wall or side each relation means


def _schedule(steps: int, start: Start) -> Schedule:
    schedule = Schedule()
    schedule.steps = steps
    schedule.rate = 0.05 if start != "given" else 0.02
    schedule.rate_end = 0.0005
    schedule.noise = 0.03 if start != "given" else 0.005
    schedule.quiet = 0.6
    return schedule


@register("adam")
def run_adam(batch: Batch, start: Start, budget: int | None, monitor: Monitor) -> Outcome:
    """Refine every candidate by ``budget`` steps (default 400); each ends at the lowest energy it passed."""
    device, steps = batch.device, budget or STEPS
    draw_starts(batch, start)
    state, other, best = batch.state, batch.scratch(), batch.scratch()
    other.rng, other.anchors = state.rng, state.anchors
    wp.copy(other.poses, state.poses)
    wp.copy(other.turns, state.turns)
    shape = (batch.size, max(batch.objects, 1))
    mean = wp.zeros(shape, dtype=wp.vec4, device=device)
    square = wp.zeros(shape, dtype=wp.vec4, device=device)
    share = wp.zeros(shape, dtype=wp.float32, device=device)
    total = wp.zeros(batch.size, dtype=wp.float32, device=device)
    best_total = wp.full(batch.size, float("inf"), dtype=wp.float32, device=device)
    clock = wp.zeros(1, dtype=wp.int32, device=device)
    everyone = wp.full(batch.size, 1, dtype=wp.int32, device=device)
    schedule = _schedule(steps, start)
    here, there = state, other
    for step in range(steps + 1):
        if step % REASSIGN == 0:
            if monitor.expired():
                break
            wp.launch(
                choose,
                (batch.size, batch.relations),
                [batch.tables, batch.weights, batch.problem, here],
                [here.options, there.options],
                device=device,
            )
        wp.launch(
            adam_step,
            (batch.size, batch.objects),
            [batch.tables, batch.margins, batch.weights, schedule, batch.problem, clock, here, mean, square],
            [there, share],
            device=device,
        )
        wp.launch(tick, batch.size, [batch.tables, batch.problem, share], [clock, total], device=device)
        wp.launch(
            keep_best,
            batch.size,
            [batch.tables, batch.problem, everyone, here, total],
            [best, best_total],
            device=device,
        )
        here, there = there, here
    for name in ("poses", "turns", "options"):
        wp.copy(getattr(state, name), getattr(best, name))
    energy = best_total.numpy()
    status = judge(batch).status
    monitor.add(batch.size, int(np.sum(status == 0)), float(energy.min(initial=np.inf)))
    return Outcome(energy)
