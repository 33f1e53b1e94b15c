"""Layouts found in another way, put into a solution and judged as its own."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from sceneweaver.kernels import load
from sceneweaver.optimizers import Batch, load_poses
from sceneweaver.optimizers.verdict import judge

from .batch import make_batch
from .compile import CompiledScene, LayoutProblem, compile_scene
from .measure import energy_of
from .solution import Solution
from .surfaces import BROKEN, surfaces_hold


class Judged(NamedTuple):
    """Status [B], relations [B, R] and energy [B] of layouts."""

    status: np.ndarray
    relations: np.ndarray
    energy: np.ndarray


def judged(compiled: CompiledScene, batch: Batch) -> Judged:
    """The engine's verdict on a batch of layouts of one scene, surfaces and the energy included."""
    load(batch.device, "verdict", "bookkeeping")
    room, relations = compiled.room, len(compiled.scene.relations)
    verdict = judge(batch)
    status = verdict.status.copy()
    status[(status == 0) & (room.faulty | ~surfaces_hold(compiled, batch, 0, batch.size))] = BROKEN
    holds = verdict.holds[:, :relations].copy()
    for rider, relation in room.riders.items():
        holds[:, relation] &= verdict.holds[:, rider]
    return Judged(status, holds, energy_of(batch)[0].numpy().copy())


def replaced(solution: Solution, compiled: CompiledScene, candidates: np.ndarray, bodies: np.ndarray) -> Solution:
    """A solution with other layouts [K, N, 4] of all bodies in some of its candidates [K], where these are valid."""
    if not len(candidates):
        return solution
    batch = make_batch([compiled.room], np.zeros(len(candidates), dtype=np.int32), solution.device)
    load_poses(batch, np.ascontiguousarray(bodies, dtype=np.float32))
    found = judged(compiled, batch)
    good = found.status == 0
    rows, objects = candidates[good], len(solution.source.objects)
    after = {name: getattr(solution, name).copy() for name in ("poses", "status", "relations", "energy")}
    after["poses"][rows] = bodies[good][:, :objects]
    for name in ("status", "relations", "energy"):
        after[name][rows] = getattr(found, name)[good]
    if solution.free_floor is not None:
        after["free_floor"] = solution.free_floor.copy()
        after["free_floor"][rows] = bodies[good][:, objects:]
    return replace(solution, **after)


def without_soft(compiled: CompiledScene) -> CompiledScene | None:
    """A scene as if nothing soft had been said of it; None where there is nothing."""
    if all(relation.fault for relation in compiled.room.relations):
        return None
    scene = compiled.scene.model_copy(update={"relations": tuple(r for r in compiled.scene.relations if r.hard)})
    bare = compile_scene(scene)
    domains = [replace(domain, problem=_hard(domain.problem)) for domain in bare.domains]
    return replace(bare, room=_hard(bare.room), domains=domains)


def _hard(problem: LayoutProblem) -> LayoutProblem:
    """A problem without the soft conditions that belong to no relation: a user's terms."""
    return replace(problem, relations=[relation for relation in problem.relations if relation.fault])
