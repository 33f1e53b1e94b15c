"""Projection: the feasible layout nearest to given poses."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace
from functools import partial
from typing import TypeVar

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.kernels.inequality import ROWS, Inequality, InequalitySystem
from sceneweaver.kernels.linearise import linearise
from sceneweaver.kernels.projection import NearestLayout, Perturbation, choose_options, project, restore, start_try
from sceneweaver.kernels.tables import STATE

from .base import Blocks, Checkpoint, Monitor, OptimizerResult, Start, register_blocks, to_the_end
from .batch import Batch, new_state
from .search import search_blocks
from .starts import draw_starts

TRIES = 2  # of a candidate from the first feasible one on
MOST = 40  # tries before the search takes over, or half as many as there are objects
STEPS = 16  # of a try: rows are taken anew so often
SWEEPS = 30  # over the rows of a step, at most
REACH = 0.12  # [m] clearance below which a pair gets rows
# Kicks, one a try: radius [m] around the object in trouble, share of the roots there, how far off they start [m].
# Small ones choose another side for a pair, large ones begin from elsewhere in the room.
PERTURBATIONS = ((1.2, 0.4, 0.1), (1.2, 0.4, 0.2), (1.2, 0.4, 0.3), (2.4, 0.3, 0.3), (1.2, 0.4, 0.5), (100.0, 0.3, 0.3))
MEMORY = 2**30  # [bytes] of rows at once

_Result = TypeVar("_Result")


def new_system(batch: Batch, monitor: Monitor) -> tuple[InequalitySystem, NearestLayout]:
    """Arrays for a batch: no rows, nothing found yet, all roots at their anchors."""
    system, best, device, shape = InequalitySystem(), NearestLayout(), batch.device, (batch.size, max(batch.objects, 1))
    slots = (shape[0], shape[1] * int(ROWS))
    system.reach = REACH
    system.rows = wp.zeros(slots, dtype=Inequality, device=device)  # pyright: ignore[reportArgumentType]
    for name in ("keys", "last_keys"):
        setattr(system, name, wp.zeros(slots, dtype=wp.int32, device=device))
    for name in ("force", "last_force"):
        setattr(system, name, wp.zeros(slots, dtype=wp.float32, device=device))
    system.count = wp.zeros(shape, dtype=wp.int32, device=device)
    system.missed, best.fault = (wp.zeros(shape, dtype=wp.float32, device=device) for _ in range(2))
    system.shift, system.scratch, best.shift = (wp.zeros(shape, dtype=wp.vec4, device=device) for _ in range(3))
    system.live = wp.zeros(batch.size, dtype=wp.int32, device=device)
    system.cut = monitor.cut if device == "cpu" else wp.zeros(1, dtype=wp.int32, device=device)
    system.last_step, best.lack, best.moved = (
        wp.full(batch.size, float("inf"), dtype=wp.float32, device=device) for _ in range(3)
    )
    return system, best


@register_blocks("projection", ("linearise", "projection", "starts", "search"))
def projection_blocks(batch: Batch, start: Start, budget: int | None, monitor: Monitor, whole: bool) -> Blocks:
    """Move every candidate as little as makes it feasible; ``budget`` is the number of its tries (default 2).

    The movement is the sum over roots of dx^2 + dy^2 + dz^2 + (0.5 m/rad dyaw)^2, from where the start has them. A
    try is a local minimum of it; each but the first begins with some objects elsewhere, near one that is in trouble
    or moved far. Tries go on until one is feasible, up to 40; then the search takes over, and a last projection
    leads back what it found. A candidate that is feasible at the start stays as it is, to the bit. The energy of the
    outcome is what a candidate misses of the verdict's limits [m].
    """
    most = max(1, MEMORY // (max(batch.objects, 1) * int(ROWS) * 96))
    if batch.size > most:
        energy = np.zeros(batch.size, dtype=np.float32)
        for rows in np.split(np.arange(batch.size), range(most, batch.size, most)):
            part = projection_blocks(batch.part(rows[0], rows[-1] + 1), start, budget, monitor, whole)
            energy[rows] = (yield from _for_whole(batch, rows, part)).energy
        return OptimizerResult(energy)
    if start != "given":
        draw_starts(batch, start)
        wp.copy(batch.state.anchors, batch.state.poses)
    (system, best), tries = new_system(batch, monitor), TRIES if budget is None else budget
    everyone, most = np.arange(batch.size), max(MOST, batch.objects // 2)
    lost = yield from _improve(batch, system, best, everyone, tries, most, monitor)
    _restored(batch, best)
    lack = best.lack.numpy()
    monitor.add(batch.size - lost.size, batch.size - lost.size, 0.0)
    if lost.size and not monitor.expired():
        lack[lost] = yield from _search(batch, lost, tries, monitor, whole, most * STEPS)
    if lost.size:
        monitor.add(lost.size, int(np.sum(lack[lost] == 0)), float(lack[lost].min()))
    return OptimizerResult(lack)


def nearest_feasible(batch: Batch, tries: int) -> tuple[np.ndarray, np.ndarray]:
    """Project every candidate of a batch, without a search where that fails.

    Args:
        batch: poses and anchors where the candidates begin; its poses are moved to the best layout found.
        tries: of a candidate that is not feasible.

    Returns:
        What each candidate misses [B] of the verdict's limits [m], 0 where it is feasible, and its squared movement.
    """
    monitor = Monitor(batch.size)
    system, best = new_system(batch, monitor)
    to_the_end(_improve(batch, system, best, np.arange(batch.size), 1, tries, monitor))
    _restored(batch, best)
    return best.lack.numpy(), best.moved.numpy()


def _improve(
    batch: Batch,
    system: InequalitySystem,
    best: NearestLayout,
    left: np.ndarray,
    tries: int,
    most: int,
    monitor: Monitor,
) -> Generator[Checkpoint, None, np.ndarray]:
    """Give candidates ``left`` so many tries from the first feasible one on; returns those that are not feasible."""
    feasible = np.zeros(batch.size, dtype=np.int32)  # tries since, the first one included
    everyone = left
    for attempt in range(most):
        if not left.size or monitor.expired():
            break
        _try(batch, system, best, left, attempt, monitor)
        yield Checkpoint(partial(_restored, batch, best), (attempt + 1) * STEPS)
        lack, moved = best.lack.numpy(), best.moved.numpy()
        feasible[left] += lack[left] == 0
        left = left[(lack[left] > 0) | ((feasible[left] < tries) & (moved[left] > 0))]
    return everyone[best.lack.numpy()[everyone] > 0]


def _for_whole(
    batch: Batch, rows: np.ndarray, blocks: Generator[Checkpoint, None, _Result], energies: int = 0
) -> Generator[Checkpoint, None, _Result]:
    """A run of some candidates with checkpoints of the whole batch; ``energies``: measured before it began."""

    def best(part: Checkpoint) -> wp.array:
        poses = batch.state.poses.numpy().copy()  # on a CPU it is the state itself
        poses[rows] = part.best().numpy()
        return wp.array(poses, dtype=wp.vec4, device=batch.device)

    while True:
        try:
            part = next(blocks)
        except StopIteration as end:
            return end.value
        yield Checkpoint(partial(best, part), energies + part.energies)


def _restored(batch: Batch, best: NearestLayout) -> wp.array:
    """The batch's poses, which are the nearest layouts found so far."""
    wp.launch(restore, (batch.size, batch.objects), [batch.problems, best, batch.state], device=batch.device)
    return batch.state.poses


def _perturbation(attempt: int) -> Perturbation:
    perturbation = Perturbation()
    perturbation.attempt = attempt
    perturbation.radius, perturbation.share, perturbation.spread = PERTURBATIONS[(attempt - 1) % len(PERTURBATIONS)]
    return perturbation


def _try(
    batch: Batch, system: InequalitySystem, best: NearestLayout, left: np.ndarray, attempt: int, monitor: Monitor
) -> None:
    """One try of the candidates ``left``: begin, choose options, then rows and projection in turn.

    One that is broken off has changed nothing but the poses, which are put back to the best at the end.
    """
    device, n, state = batch.device, left.size, batch.state
    selected = wp.array(left.astype(np.int32), dtype=wp.int32, device=device)
    inputs = [batch.problems, _perturbation(attempt), selected, best]
    wp.launch(start_try, (n, batch.objects), inputs, [state, system], device=device)
    wp.launch(choose_options, (n, batch.relations), [batch.problems, selected], [state], device=device)
    for _ in range(STEPS):
        system.keys, system.last_keys = system.last_keys, system.keys
        system.force, system.last_force = system.last_force, system.force
        wp.launch(linearise, (n, batch.objects), [batch.problems, selected, state], [system], device=device)
        if monitor.broken_off:
            break
        wp.launch(project, n, [batch.problems, SWEEPS, selected], [state, system, best], device=device)


def _search(
    batch: Batch, lost: np.ndarray, tries: int, monitor: Monitor, whole: bool, energies: int
) -> Generator[Checkpoint, None, np.ndarray]:
    """Search the candidates ``lost`` from where they are, and lead back what is found; returns what they lack [m]."""
    few = _subset(batch, lost)
    inner = monitor.inner(few.size)
    found = (yield from _for_whole(batch, lost, search_blocks(few, "given", None, inner, whole), energies)).energy
    monitor.timed_out |= inner.timed_out
    poses = few.state.poses.numpy().copy()  # on a CPU it is the state itself
    system, best = new_system(few, monitor)
    with np.errstate(invalid="ignore"):  # poses that are no numbers stay what they are
        shift = poses - few.state.anchors.numpy()
        shift[..., 3] -= 2 * np.pi * np.round(shift[..., 3] / (2 * np.pi))
    best.shift.assign(np.nan_to_num(shift, posinf=0.0, neginf=0.0))
    to_the_end(_improve(few, system, best, np.arange(few.size), tries, tries, monitor))
    _restored(few, best)
    lack = best.lack.numpy()
    kept = np.where((lack == 0)[:, None, None], few.state.poses.numpy(), poses)
    everyone = batch.state.poses.numpy()
    everyone[lost] = kept
    batch.state.poses.assign(everyone)
    wp.launch(set_turns, everyone.shape[:2], [batch.state.poses], [batch.state.turns], device=batch.device)
    return np.where(lack == 0, 0.0, found).astype(np.float32)


def _subset(batch: Batch, chosen: np.ndarray) -> Batch:
    """Some candidates of a batch, copied."""
    state = new_state(chosen.size, batch.objects, batch.relations, batch.device)
    for table in STATE:
        getattr(state, table.name).assign(getattr(batch.state, table.name).numpy()[chosen])
    problem = wp.array(batch.problem.numpy()[chosen], dtype=wp.int32, device=batch.device)
    return replace(batch, problem=problem, state=state)
