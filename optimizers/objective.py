"""Minimising an objective over the valid layouts of a batch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels import load
from sceneweaver.kernels.anneal import ANNEALING, Annealing, Cooling, anneal, begin_annealing, end_annealing
from sceneweaver.kernels.objective import Objective
from sceneweaver.kernels.sequence_pair import PACKING, Packing, anneal_packing, begin_packing

from .base import Monitor
from .batch import Batch
from .run import on_threads

MODULES = ("anneal", "objective", "sequence_pair")
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


@dataclass(frozen=True)
class Blocks:
    """What may be packed as rectangles, in a rectangular room or the rectangle around it.

    Attributes:
        roots: objects of the blocks, with what they carry.
        rectangles: [blocks, 4, 4] for each quarter turn the lowest x and y, width and height [m] from the root's
            origin, along the room's axes.
        turns: [blocks] bits of the quarters that each may be turned by.
        origin: corner of the room [m]; ``angle``: direction of its x axis [rad]; ``extent``: its size [m].
    """

    roots: np.ndarray
    rectangles: np.ndarray
    turns: np.ndarray
    origin: tuple[float, float]
    angle: float
    extent: tuple[float, float]


def minimise_batch(
    batch: Batch,
    objective: Objective,
    roots: Sequence[int],
    blocks: Blocks | None,
    schedule: Schedule,
    packing: Schedule,
    valid: np.ndarray,
    seeds: np.ndarray,
    soft: bool,
    monitor: Monitor,
) -> None:
    """Lead the candidates of a batch of one problem to lower values of an objective, in place.

    Each ends at the best valid layout that it passed; one that was not valid may become so by packing.

    Args:
        batch: the candidates.
        objective: what is minimised.
        roots: objects that may move, with what they carry.
        blocks: the same as rectangles, where the problem is one of packing; they are packed first.
        schedule: how long, and how hot; ``packing``: the same for that.
        valid: which candidates [B] are.
        seeds: of the candidates' random streams [B] uint32.
        soft: whether the problem has soft relations.
        monitor: says when time is up.
    """
    device = batch.device
    if not len(roots) or not (valid.any() or blocks is not None):
        return
    load(device, *MODULES)
    root = wp.array(np.asarray(roots, dtype=np.int32), dtype=wp.int32, device=device)
    size = PIECE if device == "cpu" else batch.size
    cuts = [(i, min(i + size, batch.size)) for i in range(0, batch.size, size)]
    look = LOOK if device == "cpu" else LOOK_GPU
    shared = None if blocks is None else _shared(blocks, device)

    def piece(rows: tuple[int, int]) -> None:
        part = batch.part(*rows)
        run = _new_run(part, objective.terms, root, valid[slice(*rows)], seeds[slice(*rows)])
        common = [part.problems, objective]
        if blocks is not None:
            cooling, pairs = cooling_of(packing, soft), _pairs(shared, blocks, part)
            wp.launch(begin_packing, part.size, [*common, cooling, run.active], [part.state, pairs, run], device=device)
            for first, last in _stretches(packing.moves, look, monitor, device):
                inputs = [*common, cooling, first, last]
                wp.launch(anneal_packing, part.size, inputs, [part.state, pairs, run], device=device)
            run.active.fill_(1)
            wp.launch(end_annealing, part.state.poses.shape, [part.problems, run], [part.state], device=device)
            run.active.assign(np.isfinite(run.least.numpy()).astype(np.int32))
        cooling = cooling_of(schedule, soft)
        wp.launch(begin_annealing, part.size, [*common, cooling], [part.state, run], device=device)
        for first, last in _stretches(schedule.moves, look, monitor, device):
            wp.launch(anneal, part.size, [*common, cooling, first, last], [part.state, run], device=device)
        wp.launch(end_annealing, part.state.poses.shape, [part.problems, run], [part.state], device=device)

    if device == "cpu":
        on_threads(piece, cuts, monitor)
    else:
        with wp.ScopedDevice(device):
            for rows in cuts:
                piece(rows)


def _stretches(moves: int, look: int, monitor: Monitor, device: str) -> Iterator[tuple[int, int]]:
    """The moves in stretches between which the clock is looked at; no more once time is up."""
    for first in range(0, moves, look):
        if device != "cpu" and monitor.deadline is not None:
            wp.synchronize_device(device)
        if monitor.expired() or monitor.broken_off:
            return
        yield first, min(first + look, moves)


def _shared(blocks: Blocks, device: str) -> dict[str, wp.array]:
    """The tables of blocks that all candidates share."""
    yaws = blocks.angle + 0.5 * np.pi * np.arange(4)
    heading = np.stack([np.cos(yaws), np.sin(yaws), np.arctan2(np.sin(yaws), np.cos(yaws))], axis=-1)
    return {
        "block": wp.array(blocks.roots.astype(np.int32), dtype=wp.int32, device=device),
        "rectangle": wp.array(blocks.rectangles.reshape(-1, 4).astype(np.float32), dtype=wp.vec4, device=device),
        "turns": wp.array(blocks.turns.astype(np.int32), dtype=wp.int32, device=device),
        "heading": wp.array(heading.astype(np.float32), dtype=wp.vec3, device=device),
    }


def _pairs(shared: dict[str, wp.array] | None, blocks: Blocks, part: Batch) -> Packing:
    """Room for the sequence pairs of some candidates."""
    pairs = Packing()
    for table in PACKING:
        if shared is not None and table.name in shared:
            setattr(pairs, table.name, shared[table.name])
        else:
            array = wp.zeros((part.size, len(blocks.roots)), dtype=table.dtype, device=part.device)
            setattr(pairs, table.name, array)
    pairs.origin, pairs.extent = wp.vec2(*blocks.origin), wp.vec2(*blocks.extent)
    pairs.axis = wp.vec2(float(np.cos(blocks.angle)), float(np.sin(blocks.angle)))
    return pairs


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
