"""Minimising an objective over the valid layouts of a batch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels import load
from sceneweaver.kernels.anneal import ANNEALING, Annealing, Cooling, anneal, begin_annealing, end_annealing
from sceneweaver.kernels.objective import Objective

from .base import Monitor
from .batch import Batch
from .run import on_threads

MODULES = ("anneal", "objective")
PIECE = 4
"""Candidates that one CPU thread anneals at a time, to the end: what time leaves over is as it was."""

LOOK = 2_000
"""Moves between two looks at the clock on a CPU."""

LOOK_GPU = 500
SOFT = 1.0
"""What a metre of a soft relation's energy costs in units of the objective."""


@dataclass(frozen=True)
class Schedule:
    """Moves of a candidate, and the temperatures of an annealing in mean changes of a move."""

    moves: int
    hot: float = 0.5
    cold: float = 0.002


def cooling_of(schedule: Schedule, soft: bool) -> Cooling:
    """The schedule as kernels take it."""
    cooling = Cooling()
    cooling.moves, cooling.hot, cooling.cold = schedule.moves, schedule.hot, schedule.cold
    cooling.soft = SOFT if soft else 0.0
    return cooling


def anneal_batch(
    batch: Batch,
    objective: Objective,
    roots: Sequence[int],
    schedule: Schedule,
    valid: np.ndarray,
    seeds: np.ndarray,
    soft: bool,
    monitor: Monitor,
) -> None:
    """Anneal the valid candidates of a batch of one problem in place; each ends at the best layout that it passed.

    Args:
        batch: the candidates.
        objective: what is minimised.
        roots: objects that may move, with what they carry.
        schedule: how long, and how hot.
        valid: which candidates [B] are; the others are left alone.
        seeds: of the candidates' random streams [B] uint32.
        soft: whether the problem has soft relations.
        monitor: says when time is up.
    """
    device = batch.device
    if not len(roots) or not valid.any():
        return
    load(device, *MODULES)
    root = wp.array(np.asarray(roots, dtype=np.int32), dtype=wp.int32, device=device)
    cooling = cooling_of(schedule, soft)
    chosen = np.flatnonzero(valid)
    size = PIECE if device == "cpu" else max(len(chosen), 1)
    look = LOOK if device == "cpu" else LOOK_GPU
    # Pieces are ranges of candidates, which share the batch's memory.
    cuts = [(int(chosen[i]), int(chosen[min(i + size, len(chosen)) - 1]) + 1) for i in range(0, len(chosen), size)]

    def piece(rows: tuple[int, int]) -> None:
        part = batch.part(*rows)
        run = _new_run(part, objective.terms, root, valid[slice(*rows)], seeds[slice(*rows)])
        wp.launch(begin_annealing, part.size, [part.problems, objective, cooling], [part.state, run], device=device)
        for first in range(0, schedule.moves, look):
            if monitor.expired() or monitor.broken_off:
                break
            last = min(first + look, schedule.moves)
            inputs = [part.problems, objective, cooling, first, last]
            wp.launch(anneal, part.size, inputs, [part.state, run], device=device)
            if device != "cpu" and monitor.deadline is not None:
                wp.synchronize_device(device)
        wp.launch(end_annealing, part.state.poses.shape, [part.problems, run], [part.state], device=device)

    if device == "cpu":
        on_threads(piece, cuts, monitor)
    else:
        with wp.ScopedDevice(device):
            for rows in cuts:
                piece(rows)


def _new_run(part: Batch, terms: int, root: wp.array, valid: np.ndarray, seeds: np.ndarray) -> Annealing:
    counts = {"candidate": part.size, "object": max(part.objects, 1), "term": max(terms, 1)}
    run = Annealing()
    for table in ANNEALING:
        if table.name != "root":
            shape = tuple(counts[dimension] for dimension in table.shape)
            setattr(run, table.name, wp.zeros(shape, dtype=table.dtype, device=part.device))
    run.root = root
    run.active.assign(valid.astype(np.int32))
    run.rng.assign(seeds)
    return run
