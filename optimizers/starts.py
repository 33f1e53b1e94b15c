"""Where an optimiser starts: the given poses, or drawn as the search draws its own."""

from __future__ import annotations

from typing import Any

import warp as wp

from sceneweaver.kernels.starts import Plan, start_attempt

from .base import Start
from .batch import Batch, threads_per_candidate

STARTS = {"given": 0, "random": 1, "sample": 2}
BLOCK = 32  # threads of a block on a GPU: one warp, so that a block ends with its candidate


def launch_warps(kernel: Any, batch: Batch, inputs: list, outputs: list) -> None:
    """Launch a kernel whose lanes work together on a candidate."""
    dim = batch.size * threads_per_candidate(batch.device)
    wp.launch(kernel, dim, inputs, outputs, device=batch.device, block_dim=BLOCK)


def draw_starts(batch: Batch, start: Start) -> None:
    """Draw the poses that an optimiser starts from, in place."""
    if STARTS[start] == 0:
        return
    plan = Plan()
    plan.start, plan.steps, plan.rounds = STARTS[start], 1, 1
    everyone = wp.full(batch.size, 1, dtype=wp.int32, device=batch.device)
    clock = wp.zeros(1, dtype=wp.int32, device=batch.device)
    inputs = [batch.problems, plan, everyone, clock]
    launch_warps(start_attempt, batch, inputs, [batch.state])
