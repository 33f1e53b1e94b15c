"""Rate layouts by terms of design quality, all candidates at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.kernels import load
from sceneweaver.kernels.quality import add_up, measure
from sceneweaver.kernels.quality_floor import LEVELS, measure_clearance, measure_floor, widest_ways
from sceneweaver.optimizers import Batch, load_poses
from sceneweaver.scene import Scene

from .access import walkable_shares
from .batch import first_object, make_batch
from .compile import CompiledScene, LayoutProblem, compile_scene
from .devices import WALKED
from .floor_grid import Grid
from .quality import QualityTerm, check_terms, pack_terms
from .solution import Solution, missing_points

MODULES = ("bookkeeping", "quality", "quality_floor")
ON_FLOOR = 256
"""Candidates, the best by all other terms, whose free floor is measured."""

AT_ONCE = 65_536
"""Candidates that are rated in one launch."""

STEP = 0.5  # [m] inside of a door, where ways begin


def rate(
    scene: Scene, poses: np.ndarray, terms: Sequence[QualityTerm], *, device: str = "cpu", on_floor: int | None = None
) -> np.ndarray:
    """Design quality [B] of layouts of a scene: minus the points that the terms take off, 0 at best.

    Args:
        scene: what the layouts are of.
        poses: world poses (x, y, z, yaw) [B, N, 4], objects in the scene's order.
        terms: what is looked at.
        device: a Warp device.
        on_floor: of how many, the best by the other terms, the free floor is measured; the others lose all points of
            such terms. None: of all.
    """
    shape = (*np.shape(poses)[:1], len(scene.objects), 4)
    if np.shape(poses) != shape:
        raise ValueError(f"poses: an array of shape {np.shape(poses)} is not [B, {len(scene.objects)}, 4]")
    check_terms(scene, terms)
    compiled = compile_scene(scene)
    room = compiled.room
    points = [
        _points(_loaded(room, compiled.bodies(part), device), room, scene, terms, on_floor)[0]
        for part in np.array_split(poses, range(AT_ONCE, len(poses), AT_ONCE))
    ]
    return -np.concatenate(points)


def measures(
    scene: Scene, poses: np.ndarray, terms: Sequence[QualityTerm], device: str = "cpu"
) -> tuple[np.ndarray, list[QualityTerm]]:
    """The measure of every term [B, T] in layouts of a scene, and the terms in that order: those of a rule together."""
    check_terms(scene, terms)
    compiled = compile_scene(scene)
    room = compiled.room
    batch = _loaded(room, compiled.bodies(np.asarray(poses)), device)
    _, values, rows = _points(batch, room, scene, terms, None)
    return values, rows


def rated(solution: Solution, compiled: CompiledScene, terms: Sequence[QualityTerm]) -> Solution:
    """A solution whose valid candidates are rated."""
    scene, valid = solution.source, np.flatnonzero(solution.status == 0)
    quality = np.full(solution.candidates, np.nan, dtype=np.float32)
    lost = missing_points(scene, solution.relations)
    for part in np.array_split(valid, range(AT_ONCE, len(valid), AT_ONCE)) if len(valid) else ():
        batch = _loaded(compiled.room, solution.bodies[part], solution.device)
        quality[part] = -_points(batch, compiled.room, scene, terms, ON_FLOOR, lost[part])[0]
    return replace(solution, quality=quality)


def walked(solution: Solution, compiled: CompiledScene) -> Solution:
    """A rated solution whose best candidates are measured for walkable floor."""
    walkable = np.full(solution.candidates, np.nan, dtype=np.float32)
    best = replace(solution, walkable=walkable).ranked[: 2 * WALKED]
    if len(best):
        load(solution.device, "walk")
        batch = _loaded(compiled.room, solution.bodies[best], solution.device)
        walkable[best] = walkable_shares(batch, compiled.room, np.arange(len(best)))
    return replace(solution, walkable=walkable)


def _loaded(room: LayoutProblem, poses: np.ndarray, device: str) -> Batch:
    """A batch of layouts [B, N, 4] of one problem."""
    load(device, *MODULES)
    batch = make_batch([room], np.zeros(len(poses), dtype=np.int32), device, shared=True)
    load_poses(batch, np.ascontiguousarray(poses, dtype=np.float32))
    return batch


def _points(
    batch: Batch,
    room: LayoutProblem,
    scene: Scene,
    terms: Sequence[QualityTerm],
    on_floor: int | None,
    lost: np.ndarray | None = None,
) -> tuple[np.ndarray, np.ndarray, list[QualityTerm]]:
    """Points [B] that the terms take off, the measures [B, T], and the terms in their order there.

    The free floor is measured of the best ``on_floor`` alone, by these points and those ``lost`` [B] besides.
    """
    device, count = batch.device, batch.size
    packed, rows = pack_terms(scene, terms, device)
    packed.first = first_object(room, device)
    value = wp.zeros((count, len(rows)), dtype=wp.float32, device=device)
    points = wp.zeros(count, dtype=wp.float32, device=device)
    every = wp.array(np.arange(count, dtype=np.int32), dtype=wp.int32, device=device)
    wp.launch(measure, value.shape, [batch.problems, packed, every, batch.state], [value], device=device)
    on_grid = [k for k, term in enumerate(rows) if term.on_floor]
    wp.launch(add_up, count, [packed, 0, value], [points], device=device)
    total, values = points.numpy().copy(), value.numpy()
    if on_grid:
        rank = total if lost is None else total + lost
        best = np.sort(np.argsort(rank, kind="stable")[:on_floor])
        chosen = wp.array(best.astype(np.int32), dtype=wp.int32, device=device)
        some = wp.array(values[best], dtype=wp.float32, device=device)
        _measure_floor(batch, room, packed, on_grid, chosen, some)
        wp.launch(add_up, len(best), [packed, 1, some], [points[: len(best)]], device=device)
        total[best] = points.numpy()[: len(best)]
        values = values.copy()
        values[best] = some.numpy()
    return total, values, rows


def _measure_floor(batch: Batch, room: LayoutProblem, packed, on_grid: list[int], chosen: wp.array, value: wp.array):
    """The measures [K, T] of some rows on the free floor of the chosen candidates [K]."""
    floor = Grid(room.region.box).floor
    device, count, cells = batch.device, len(chosen), floor.nx * floor.ny
    level, way, work = (wp.zeros((count, cells), dtype=wp.int32, device=device) for _ in range(3))
    head = wp.zeros((count, int(LEVELS) + 1), dtype=wp.int32, device=device)
    wp.launch(measure_clearance, level.shape, [batch.problems, floor, chosen, batch.state], [level], device=device)
    starts = wp.array(_inside_doors(room), dtype=wp.vec2, device=device)
    wp.launch(widest_ways, count, [floor, starts, level, work, head], [way], device=device)
    rows = wp.array(np.array(on_grid, dtype=np.int32), dtype=wp.int32, device=device)
    inputs = [batch.problems, packed, floor, rows, chosen, batch.state, level, way, work]
    wp.launch(measure_floor, (count, len(on_grid)), inputs, [value], device=device)


def _inside_doors(room: LayoutProblem) -> np.ndarray:
    """Points [D, 2] a step inside of the doors."""
    points = []
    for zone in room.region.doors.values():
        first, second, _, last = zone.polygon[:4]
        inward = (last - first) / max(float(np.linalg.norm(last - first)), 1e-9)
        points.append((first + second) / 2 + STEP * inward)
    return np.array(points, dtype=np.float32).reshape(-1, 2)
