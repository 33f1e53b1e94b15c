"""Minimise an objective over the valid layouts that a search found."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.kernels import load
from sceneweaver.kernels.objective import Objective, measure_objective
from sceneweaver.kernels.objective_walk import measure_walking
from sceneweaver.kernels.quality_floor import measure_clearance
from sceneweaver.kernels.tables import FREE_PLANE, FREE_YAW, FREE_Z
from sceneweaver.optimizers import Batch, Monitor, load_poses, streams
from sceneweaver.optimizers.objective import Schedule, minimise_batch

from .batch import make_batch
from .compile import CompiledScene, LayoutProblem
from .floor_grid import Grid
from .objective import ObjectiveTerm
from .objective_pack import pack_objective
from .packing import blocks_of
from .rejudge import judged
from .shortest_ways import detour
from .solution import Solution

WAYS_AT_ONCE = 8_192
MODULES = ("anneal", "objective", "objective_walk", "sequence_pair")
"""Kernel modules of a minimisation."""

SALT = 0x0B1E
MOVES = 1_500
"""Moves of a candidate for each root that may move, where nothing is said."""

PACKED = Schedule(0, 0.3, 0.01)
SLIDING = Schedule(0, 0.02, 0.002)
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
    values = value.numpy().astype(np.float64)
    on_foot = [t for t, term in enumerate(terms) if term.kind == "walking"]
    if on_foot:
        values[:, on_foot] = _ways(batch, compiled, packed, on_foot)
    return values.sum(axis=1)


def _ways(batch: Batch, compiled: CompiledScene, packed: Objective, on_foot: Sequence[int]) -> np.ndarray:
    """Weighted lengths [B, W] of the ways of walking terms over the free floor, some candidates at a time."""
    device, grid = batch.device, Grid(compiled.room.region.box)
    load(device, "quality_floor", "objective_walk")
    floor, cells, around = grid.floor, math.prod(grid.shape), detour(compiled.scene)
    numbers = wp.array(np.asarray(on_foot, dtype=np.int32), dtype=wp.int32, device=device)
    found = np.zeros((batch.size, len(on_foot)))
    many = max(1, WAYS_AT_ONCE // len(on_foot))
    for first in range(0, batch.size, many):
        chosen = np.arange(first, min(first + many, batch.size), dtype=np.int32)
        slots = wp.array(chosen, dtype=wp.int32, device=device)
        level = wp.zeros((len(chosen), cells), dtype=wp.int32, device=device)
        way = wp.zeros((len(chosen) * len(on_foot), cells), dtype=wp.float32, device=device)
        value = wp.zeros((len(chosen), len(on_foot)), dtype=wp.float32, device=device)
        inputs = [batch.problems, floor, slots, batch.state]
        wp.launch(measure_clearance, level.shape, inputs, [level], device=device)
        inputs = [batch.problems, packed, floor, numbers, around, slots, batch.state, level]
        wp.launch(measure_walking, value.shape, inputs, [way, value], device=device)
        found[chosen] = value.numpy()
    return found


def anneal_room(
    batch: Batch,
    compiled: CompiledScene,
    terms: Sequence[ObjectiveTerm],
    schedule: Schedule,
    roots: Sequence[int],
    valid: np.ndarray,
    seeds: np.ndarray,
    monitor: Monitor,
) -> None:
    """Lead the candidates of a batch of one scene to lower values of an objective, in place.

    Where the scene is one of packing, orders of its blocks are annealed first, which may make valid what was not.
    ``roots`` may move, ``valid`` [B] says which candidates are valid, ``seeds`` [B] are of their random streams.
    """
    room = compiled.room
    packed = pack_objective(compiled.scene, terms, room.size, batch.device)
    soft = any(not relation.fault for relation in room.relations)
    blocks, packing = blocks_of(room, roots), schedule
    if blocks is not None:  # what is packed only has to slide a little afterwards
        packing, schedule = replace(PACKED, moves=schedule.moves), replace(SLIDING, moves=schedule.moves // 5)
    minimise_batch(batch, packed, roots, blocks, schedule, packing, valid, seeds, soft, monitor)


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
    room = compiled.room
    before = np.ascontiguousarray(solution.bodies[rows], dtype=np.float32)
    batch = make_batch([room], np.zeros(len(rows), dtype=np.int32), solution.device)
    load_poses(batch, before)
    status, relations = solution.status[rows].copy(), solution.relations[rows].copy()
    seeds = streams(solution.seed ^ SALT, rows)
    anneal_room(batch, compiled, terms, schedule, roots, status == 0, seeds, monitor)
    after = batch.state.poses.numpy()[:, : room.size].copy()
    found = judged(compiled, batch)
    better = found.status == 0
    after[~better] = before[~better]
    relations[better] = found.relations[better]
    status[better] = 0
    load_poses(batch, after)
    energy = np.where(better, found.energy, solution.energy[rows])
    return after, status, relations, energy, _values(batch, compiled, terms)
