"""Hard before soft: candidates that a search leaves invalid, once more without anything soft."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sceneweaver.optimizers import Monitor, load_poses

from .access import walkable_shares
from .batch import make_batch
from .compile import CompiledScene, compile_scene
from .devices import WALKED
from .job import Job
from .rejudge import judged
from .solution import Solution, best_of


def failed_for_softness(
    jobs: Sequence[Job], worlds: Sequence[np.ndarray], solutions: Sequence[Solution]
) -> dict[int, Job]:
    """For each job with soft rows and invalid candidates, by its place: these candidates as a job without soft rows.

    Args:
        jobs: what was solved.
        worlds: the poses [B, N, 4] that each began with.
        solutions: what came of them.
    """
    again = {}
    for i, (job, world, solution) in enumerate(zip(jobs, worlds, solutions, strict=True)):
        failed = np.flatnonzero(solution.status != 0)
        bare = without_soft(job.compiled) if failed.size else None
        if bare is not None:
            again[i] = replace(
                job, compiled=bare, world=world[failed], chosen=job.numbers[failed], into=None, pools=None, walk=False
            )
    return again


def without_soft(compiled: CompiledScene) -> CompiledScene | None:
    """A scene compiled as if it had no soft relations and the user no terms; None where nothing is soft in it."""
    places = [compiled.room, *(domain.problem for domain in compiled.domains)]
    if all(relation.fault for place in places for relation in place.relations):
        return None
    hard = tuple(relation for relation in compiled.scene.relations if relation.hard)
    return compile_scene(compiled.scene.model_copy(update={"relations": hard}), terms=False)


def with_rescued(
    job: Job, solution: Solution, again: Job, bare: Solution, device: str, monitor: Monitor, elapsed: float
) -> Solution:
    """A solution with the valid ones of those candidates that were searched again, measured with all that is soft."""
    rows = np.flatnonzero(np.isin(job.numbers, again.numbers))[bare.status == 0]
    if not rows.size:
        return replace(solution, elapsed=elapsed, timed_out=monitor.timed_out)
    room, scene, valid = job.compiled.room, job.compiled.scene, bare.status == 0
    batch = make_batch([room], np.zeros(rows.size, dtype=int), device)
    load_poses(batch, bare.bodies[valid])
    found = judged(job.compiled, batch)
    fine = found.status == 0
    rows, kept = rows[fine], np.flatnonzero(valid)[fine]
    status, relations, energies = solution.status.copy(), solution.relations.copy(), solution.energy.copy()
    status[rows], relations[rows], energies[rows] = 0, found.relations[fine], found.energy[fine]
    solution.poses[rows] = bare.poses[kept]  # in place: the layouts of several devices lie in one array
    if solution.free_floor is not None and bare.free_floor is not None:
        solution.free_floor[rows] = bare.free_floor[kept]
    moved = None
    if solution.moved is not None and bare.moved is not None:
        moved = solution.moved.copy()
        moved[rows] = bare.moved[kept]
    walkable = np.full(len(status), np.nan, dtype=np.float32)
    if job.walk:
        order = best_of(WALKED, scene, status, relations, energies, moved)
        best = make_batch([room], np.zeros(len(order), dtype=int), device)
        load_poses(best, solution.bodies[order])
        walkable[order] = walkable_shares(best, room, np.arange(len(order)), monitor)
    return replace(
        solution,
        status=status,
        relations=relations,
        energy=energies,
        moved=moved,
        walkable=walkable,
        elapsed=elapsed,
        timed_out=monitor.timed_out,
    )
