"""Where a step-based optimiser starts: the given poses, or drawn as the search draws its own."""

from __future__ import annotations

import numpy as np
import warp as wp

from sceneweaver.kernels.search import Budget, search

from .base import Start
from .batch import Batch

STARTS = {"given": 0, "random": 1, "sample": 2}


def draw_starts(batch: Batch, start: Start) -> None:
    """Draw the poses that an optimiser starts from, in place."""
    if STARTS[start] == 0:
        return
    budget = Budget()
    budget.start, budget.rounds = STARTS[start], 1
    everyone = wp.array(np.arange(batch.size, dtype=np.int32), dtype=wp.int32, device=batch.device)
    trial = batch.scratch()
    trial.rng, trial.mark = batch.state.rng, batch.state.mark
    energy = wp.zeros((batch.size, max(batch.objects, 1)), dtype=wp.float32, device=batch.device)
    total = wp.zeros(batch.size, dtype=wp.float32, device=batch.device)
    inputs = [batch.tables, batch.margins, batch.weights, budget, batch.problem, everyone, batch.state, trial]
    wp.launch(search, batch.size, inputs, [energy, total], device=batch.device)
