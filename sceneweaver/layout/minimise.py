"""Minimise an objective over the valid layouts that a search found."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.kernels import load
from sceneweaver.kernels.objective import measure_objective
from sceneweaver.kernels.tables import FREE_PLANE, FREE_YAW, FREE_Z
from sceneweaver.optimizers import Batch, Monitor, load_poses, streams
from sceneweaver.optimizers.objective import Schedule, minimise_batch
from sceneweaver.optimizers.run import judge_in_time

from .batch import make_batch
from .compile import CompiledScene, LayoutProblem
from .measure import energy_of
from .objective import ObjectiveTerm
from .objective_pack import pack_objective
from .packing import blocks_of
from .solution import Solution
from .surfaces import surfaces_hold

SALT = 0x0B1E
MOVES = 1_500
"""Moves of a candidate for each root that may move, where nothing is said."""

AT_ONCE = 16_384  # candidates that a GPU anneals at once


def minimised(
    solution: Solution,
    compiled: CompiledScene,
    terms: Sequence[ObjectiveTerm],
    moves: int | None,
    monitor: Monitor,
    began: float,
) -> Solution:
    """A solution whose valid candidates were led to lower values of an objective, with these values.

    A candidate that was valid is valid after it, and its total of objective and soft relations is no higher.
    """
    room, device = compiled.room, solution.device
    roots = movable_roots(room)
    wanted = MOVES * max(len(roots), 1) if moves is None else moves
    parts = [
        _minimise(solution, compiled, terms, Schedule(wanted), roots, rows, monitor)
        for rows in np.array_split(np.arange(solution.candidates), range(AT_ONCE, solution.candidates, AT_ONCE))
    ]
    bodies, status, relations, energy, value = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    objects = len(solution.source.objects)
    return replace(
        solution,
        poses=bodies[:, :objects],
        free_floor=None if solution.free_floor is None else bodies[:, objects:],
        status=status,
        relations=relations,
        energy=energy,
        objective=np.where(status == 0, value, np.nan),
        device=device,
        elapsed=time.monotonic() - began,
        timed_out=solution.timed_out or monitor.timed_out,
    )


def movable_roots(room: LayoutProblem) -> list[int]:
    """The roots of a problem that may move."""
    movable = FREE_PLANE | FREE_YAW | FREE_Z
    return [i for i in range(room.size) if room.roots[i] == i and room.free[i] & movable]


def measured_objective(
    compiled: CompiledScene, terms: Sequence[ObjectiveTerm], bodies: np.ndarray, device: str
) -> np.ndarray:
    """The value [B] float64 of an objective at layouts [B, N, 4] of all bodies, by the kernels."""
    batch = make_batch([compiled.room], np.zeros(len(bodies), dtype=np.int32), device)
    load_poses(batch, np.ascontiguousarray(bodies, dtype=np.float32))
    return _values(batch, compiled, terms)


def _values(batch: Batch, compiled: CompiledScene, terms: Sequence[ObjectiveTerm]) -> np.ndarray:
    load(batch.device, "objective")
    packed = pack_objective(compiled.scene, terms, compiled.room.size, batch.device)
    value = wp.zeros((batch.size, max(len(terms), 1)), dtype=wp.float32, device=batch.device)
    shape = (batch.size, len(terms))
    wp.launch(measure_objective, shape, [batch.problems, packed, batch.state], [value], device=batch.device)
    return value.numpy().astype(np.float64).sum(axis=1)


def _minimise(
    solution: Solution,
    compiled: CompiledScene,
    terms: Sequence[ObjectiveTerm],
    schedule: Schedule,
    roots: Sequence[int],
    rows: np.ndarray,
    monitor: Monitor,
) -> tuple[np.ndarray, ...]:
    """Poses of all bodies, status, relations, energy and objective of some candidates, minimised."""
    room, device, scene = compiled.room, solution.device, compiled.scene
    before = np.ascontiguousarray(solution.bodies[rows], dtype=np.float32)
    batch = make_batch([room], np.zeros(len(rows), dtype=np.int32), device)
    load_poses(batch, before)
    status, relations = solution.status[rows].copy(), solution.relations[rows].copy()
    packed = pack_objective(scene, terms, room.size, device)
    soft = any(not relation.fault for relation in room.relations)
    seeds = streams(solution.seed ^ SALT, rows)
    blocks = blocks_of(room, roots)
    minimise_batch(batch, packed, roots, blocks, schedule, schedule, status == 0, seeds, soft, monitor)
    verdict = judge_in_time(batch, monitor.inner(len(rows)))
    found = verdict.status.copy()
    found[(found == 0) & ~surfaces_hold(compiled, batch, 0, len(rows))] = 1
    holds = verdict.holds[:, : len(scene.relations)].copy()
    for rider, relation in room.riders.items():
        holds[:, relation] &= verdict.holds[:, rider]
    after = batch.state.poses.numpy()[:, : room.size].copy()
    better = found == 0
    after[~better] = before[~better]
    relations[better] = holds[better]
    status[better] = 0
    load_poses(batch, after)
    energy = energy_of(batch)[0].numpy()
    return after, status, relations, np.where(better, energy, solution.energy[rows]), _values(batch, compiled, terms)
