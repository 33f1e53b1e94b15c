"""Refine a scene: compile, solve surfaces, solve the room, judge the whole, choose."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.kernels import load
from sceneweaver.kernels.bookkeeping import broadcast_poses, set_turns
from sceneweaver.kernels.cells import CROWD
from sceneweaver.optimizers import OPTIMIZERS, Batch, Monitor, judge, load_poses, run, streams
from sceneweaver.optimizers.base import Moment
from sceneweaver.optimizers.batch import Progress
from sceneweaver.optimizers.run import judge_in_time
from sceneweaver.optimizers.snap import MODULES as SNAP_MODULES
from sceneweaver.optimizers.snap import snap_batch
from sceneweaver.runtime.deadline import ending
from sceneweaver.scene import InputError, Scene

from .access import walkable_shares
from .batch import make_batch, stacked
from .compile import CompiledScene, LayoutProblem, compile_scene
from .devices import WALKED, pick_devices, solve_on
from .hard_first import failed_for_softness, with_rescued
from .job import Job
from .minimise import minimised
from .objective import ObjectiveTerm, check_objective
from .pack import PULL, weights
from .pools import POOL_SALT, surface_pools
from .problem import Problem
from .quality import QualityTerm, check_terms
from .rate import rated, walked
from .solution import Solution, best_of
from .stepwise import StepOptimizer, find_optimizer, modules_of, run_stepwise
from .surfaces import BROKEN, surfaces_hold
from .yaw_domain import into_domains

INITS = ("sample", "random", "current")
DIVERGED = 3
SIDE_BY_SIDE = (
    4096  # candidates that a GPU searches at once, whatever the sizes of their rooms: one wait instead of four
)
DOMAIN_STRIDE = 2**24  # candidates of one surface, for the numbers of their random streams
ROUNDING = 2.0e-6  # [m] and [rad] that a pose loses on the way into a surface's frame and back


def refine(
    scene: Scene,
    *,
    candidates: int = 1024,
    seed: int = 0,
    init: str | np.ndarray = "sample",
    device: str = "auto",
    optimizer: str | StepOptimizer = "search",
    time_limit: float | None = None,
    steps: int | None = None,
    progress: Progress | None = None,
    snap: bool = False,
    quality: Sequence[QualityTerm] = (),
    objective: Sequence[ObjectiveTerm] = (),
    moves: int | None = None,
    compiled: CompiledScene | None = None,
    walk: bool = True,
) -> Solution:
    """Refine many candidate layouts of a scene at once.

    Arguments and errors as for `sceneweaver.refine`, which this does the work of; no explanation is looked for.
    ``compiled`` is the scene, if that has been compiled before; without ``walk`` walkable floor is not measured.
    """
    began = time.monotonic()
    given = _check_arguments(scene, candidates, seed, init, optimizer, time_limit, steps, compiled, moves)
    where = pick_devices(device)
    compiled = compiled or compile_scene(scene)
    check_terms(scene, quality)
    check_objective(scene, objective)
    world = _begin(compiled, given, candidates)
    start = init if isinstance(init, str) and init != "current" else "given"
    keep = start == "given" and given is None and not objective
    job = Job(compiled, world, start, seed, keep=keep, walk=walk and not quality and not objective)
    monitor = Monitor(len(world), _until(began, time_limit, bool(objective)), progress)
    jobs = _prepared([job], where, optimizer, monitor)
    found = solve_on(where, jobs, lambda jobs, device: hard_first(jobs, optimizer, steps, device, monitor, began, snap))
    found = _minimised(found, [compiled], [objective], moves, began, time_limit)
    return _rated(found, [compiled], [quality], began, walk)[0]


def refine_many(
    scenes: Sequence[Scene],
    *,
    candidates: int | Sequence[int] = 64,
    seed: int | Sequence[int] = 0,
    init: str | Sequence[np.ndarray] = "sample",
    device: str = "auto",
    optimizer: str | StepOptimizer = "search",
    time_limit: float | None = None,
    steps: int | None = None,
    progress: Progress | None = None,
    snap: bool = False,
    quality: Sequence[Sequence[QualityTerm]] | None = None,
    objective: Sequence[Sequence[ObjectiveTerm]] | None = None,
    moves: int | None = None,
) -> list[Solution]:
    """Refine many scenes in shared launches; each gets what ``refine`` would give it alone.

    Arguments and errors as for ``refine``; ``time_limit`` is for all scenes together, ``init`` is a name or an array of
    poses for each scene, ``candidates`` and ``seed`` are for all scenes or one for each, and ``quality`` and
    ``objective`` have the terms of each scene.
    """
    began = time.monotonic()
    where = pick_devices(device)
    terms = [()] * len(scenes) if quality is None else quality
    if len(terms) != len(scenes):
        raise InputError(f"quality: terms of {len(terms)} scenes, but there are {len(scenes)}")
    aims = [()] * len(scenes) if objective is None else objective
    if len(aims) != len(scenes):
        raise InputError(f"objective: terms of {len(aims)} scenes, but there are {len(scenes)}")
    counts, seeds = (_each(value, len(scenes), name) for name, value in (("candidates", candidates), ("seed", seed)))
    inits = [init] * len(scenes) if isinstance(init, str) else list(init)
    if len(inits) != len(scenes):
        raise InputError(f"init: poses of {len(inits)} scenes, but there are {len(scenes)}")
    jobs = []
    for scene, wanted, aim, count, own, first in zip(scenes, terms, aims, counts, seeds, inits, strict=True):
        compiled = compile_scene(scene)
        given = _check_arguments(scene, count, own, first, optimizer, time_limit, steps, compiled, moves)
        check_terms(scene, wanted)
        check_objective(scene, aim)
        world = _begin(compiled, given, count)
        start = first if isinstance(first, str) and first != "current" else "given"
        keep = start == "given" and given is None and not aim
        jobs.append(Job(compiled, world, start, own, keep=keep, walk=not wanted and not aim))
    monitor = Monitor(sum(len(job.world) for job in jobs), _until(began, time_limit, any(aims)), progress)
    jobs = _prepared(jobs, where, optimizer, monitor)
    found = solve_on(where, jobs, lambda jobs, device: hard_first(jobs, optimizer, steps, device, monitor, began, snap))
    found = _minimised(found, [job.compiled for job in jobs], aims, moves, began, time_limit)
    return _rated(found, [job.compiled for job in jobs], terms, began)


def _minimised(
    found: Sequence[Solution],
    compiled: Sequence[CompiledScene],
    objectives: Sequence[Sequence[ObjectiveTerm]],
    moves: int | None,
    began: float,
    time_limit: float | None,
) -> list[Solution]:
    """The solutions of some scenes, those with an objective led to lower values of it, and their floor measured."""
    solutions = list(found)
    for k, terms in enumerate(objectives):
        if terms:
            monitor = Monitor(solutions[k].candidates, _until(began, time_limit))
            solutions[k] = minimised(solutions[k], compiled[k], terms, moves, monitor, began)
    return solutions


def _each(value: int | Sequence[int], count: int, name: str) -> list[int]:
    """What holds for each of so many scenes: its own, or the same for all."""
    if not isinstance(value, Sequence):
        return [value] * count
    if len(value) != count:
        raise InputError(f"{name}: {len(value)} numbers, but there are {count} scenes")
    return list(value)


def _rated(
    found: Sequence[Solution],
    compiled: Sequence[CompiledScene],
    terms: Sequence[Sequence[QualityTerm]],
    began: float,
    walk: bool = True,
) -> list[Solution]:
    """The solutions of some scenes, rated where there are terms for that."""
    solutions = []
    for solution, room, wanted in zip(found, compiled, terms, strict=True):
        if wanted:
            solution = rated(solution, room, wanted)
            solution = walked(solution, room) if walk else solution
            solution = replace(solution, elapsed=time.monotonic() - began)
        solutions.append(solution)
    return solutions


def _until(began: float, time_limit: float | None, half: bool = False) -> Moment | None:
    """When to stop, by ``time.monotonic()`` [s]: after the time limit, or ``half`` of it, and with the deadline of the
    caller."""
    share = 0.5 if half else 1.0
    block, own = ending(), math.inf if time_limit is None else began + share * time_limit
    if block is None:
        return None if math.isinf(own) else own
    return lambda: min(own, block())


def _check_arguments(
    scene,
    candidates,
    seed,
    init,
    optimizer,
    time_limit,
    steps,
    compiled: CompiledScene | None = None,
    moves: int | None = None,
) -> np.ndarray | None:
    """Raise InputError on anything out of range; the poses to start from when ``init`` is an array."""
    for name, value in (("candidates", candidates), ("steps", steps), ("moves", moves)):
        if value is not None and (not isinstance(value, int | np.integer) or isinstance(value, bool) or value < 1):
            raise InputError(f"{name}: {value!r} is not a whole number of at least 1")
    if not isinstance(seed, int | np.integer) or not 0 <= seed < 2**32:
        raise InputError(f"seed: {seed!r} is not a whole number from 0 to 2**32 - 1")
    find_optimizer(optimizer)
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit!r} is not a positive number of seconds")
    if isinstance(init, str):
        if init not in INITS:
            raise InputError(f'init: "{init}" is not one of {", ".join(INITS)} or an array of poses [B, N, 4]')
        return None
    poses = np.asarray(init, dtype=np.float64)
    bodies = len(compiled.room.ids) if compiled is not None else len(scene.objects)
    if poses.ndim != 3 or poses.shape[1:] not in ((len(scene.objects), 4), (bodies, 4)) or not len(poses):
        raise InputError(f"init: an array of shape {poses.shape}; poses are [B, {len(scene.objects)}, 4]")
    if not np.isfinite(poses).all():
        raise InputError("init: poses must be finite numbers")
    return poses


def hard_first(
    jobs: Sequence[Job],
    optimizer: str | StepOptimizer,
    steps: int | None,
    device: str,
    monitor: Monitor,
    began: float,
    snap: bool = False,
) -> list[Solution]:
    """Solve jobs, so that no soft row makes a search lose a hard one.

    A candidate that its search leaves invalid is searched once more as if nothing soft were there, from the same start
    with the same random stream: so it is valid wherever it would be without soft rows. Whoever says how often to try
    (``steps``) gets that and no more.
    """
    worlds = [job.world for job in jobs]
    solutions = solve(jobs, optimizer, steps, device, monitor, began, snap)
    if optimizer != "search" or steps is not None:
        return solutions
    again = failed_for_softness(jobs, worlds, solutions)
    if not again or monitor.expired():
        return solutions
    rescue = monitor.inner(sum(len(job.world) for job in again.values()))
    found = solve(list(again.values()), optimizer, steps, device, rescue, began, snap)
    monitor.timed_out |= rescue.timed_out
    merged = list(solutions)
    for i, bare in zip(again, found, strict=True):
        merged[i] = with_rescued(jobs[i], solutions[i], again[i], bare, device, monitor, time.monotonic() - began)
    return merged


def solve(
    jobs: Sequence[Job],
    optimizer: str | StepOptimizer,
    steps: int | None,
    device: str,
    monitor: Monitor,
    began: float,
    snap: bool = False,
) -> list[Solution]:
    """Solve jobs in shared launches, rooms of like size together."""
    method = find_optimizer(optimizer)
    load(device, *_modules(jobs, optimizer, device), *(SNAP_MODULES if snap else ()))
    pools = surface_pools(jobs, device, monitor.deadline)
    buckets: dict[tuple[str, int, bool], list[int]] = {}
    few = device != "cpu" and sum(len(job.world) for job in jobs) <= SIDE_BY_SIDE
    for i, job in enumerate(jobs):
        size = job.compiled.room.size  # a crowd is searched in another way than a few
        like = 0 if few else int(math.log2(max(size, 1)))
        buckets.setdefault((job.start, like, size > CROWD), []).append(i)
    solutions: dict[int, Solution] = {}
    for (start, *_), members in buckets.items():
        group = [jobs[i] for i in members]
        if start == "given":
            for job in group:
                mend_surfaces(job, optimizer, device, monitor)
        sizes = [len(job.world) for job in group]
        batch = make_batch(
            [j.compiled.room for j in group],
            np.repeat(np.arange(len(group)), sizes),
            device,
            [pools[i] for i in members],
        )
        if start == "given":
            batch = replace(batch, weights=weights(pull=PULL))
        _load_worlds(batch, [job.world for job in group])
        batch.state.rng.assign(np.concatenate([streams(job.seed, job.numbers) for job in group]))
        if isinstance(method, StepOptimizer):
            compiled = [job.compiled for job in group]
            problem = Problem(
                [c.scene for c in compiled], [c.room for c in compiled], device, compiled, [pools[i] for i in members]
            )
            outcome = run_stepwise(method, problem, batch, start, group[0].seed, steps, monitor)
        else:
            outcome = run(batch, method, start, steps, monitor)
        if snap:
            batch = replace(batch, weights=weights())
            snap_batch(batch, _orders([job.compiled.room for job in group], batch.objects))
        verdict = judge_in_time(batch, monitor)
        layouts = _layouts(batch, group)
        first = 0
        for i, job, final, n in zip(members, group, layouts, sizes, strict=True):
            rows = slice(first, first + n)
            room, scene = job.compiled.room, job.compiled.scene
            status = verdict.status[rows].copy()
            broken = room.faulty | ~surfaces_hold(job.compiled, batch, first, n, monitor)
            status[(status != DIVERGED) & broken] = BROKEN
            holds = verdict.holds[rows, : len(scene.relations)].copy()
            for rider, relation in room.riders.items():
                holds[:, relation] &= verdict.holds[rows, rider]
            energy = outcome.energy[rows].astype(np.float32)
            moved = None
            if job.keep:
                things = slice(len(scene.objects))
                in_order = _in_order(batch, first, job)[things]
                moved = _movement(job.world[:, things], final[:, things], in_order)
            walkable = np.full(n, np.nan, dtype=np.float32)
            if job.walk:
                order = best_of(WALKED, scene, status, holds, energy, moved)
                walkable[order] = walkable_shares(batch, room, first + order, monitor)
            solutions[i] = Solution(
                source=scene,
                poses=final[:, : len(scene.objects)],
                free_floor=final[:, len(scene.objects) :] if job.compiled.stand_ins.objects else None,
                floors=tuple(job.compiled.stand_ins.area),
                status=status,
                relations=holds,
                energy=energy,
                walkable=walkable,
                moved=moved,
                seed=job.seed,
                device=device,
                elapsed=time.monotonic() - began,
                timed_out=monitor.timed_out,
            )
            first += n
    return [solutions[i] for i in range(len(jobs))]


def _orders(problems: Sequence[LayoutProblem], objects: int) -> np.ndarray:
    """The objects [problem, object] of each problem, parents before those that are placed by them."""
    orders = np.zeros((len(problems), max(objects, 1)), dtype=np.int32)
    for row, problem in zip(orders, problems, strict=True):
        depths = np.zeros(problem.size, dtype=np.int32)
        for i, parent in enumerate(problem.parents):
            while parent >= 0:
                depths[i] += 1
                parent = problem.parents[parent]
        row[: problem.size] = np.argsort(depths, kind="stable")
    return orders


def _modules(jobs: Sequence[Job], optimizer: str | StepOptimizer, device: str) -> list[str]:
    """The kernel modules that these jobs need."""
    method = find_optimizer(optimizer)
    own = modules_of(method, device) if isinstance(method, StepOptimizer) else OPTIMIZERS[method].modules_on(device)
    names = ["bookkeeping", "verdict", "walk", *own]
    if any(job.compiled.domains or job.start != "given" for job in jobs):
        # What stands on surfaces is searched, whatever lays out the room, and so starts are drawn.
        names += OPTIMIZERS["search"].modules_on(device)
    return list(dict.fromkeys(names))


def _same(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Which poses [..., 4] differ by rounding only: [..., 1]. Heights may by a quarter of the judge's tolerance."""
    d = np.abs(b - a)
    d[..., 3] = np.abs(wrap_angle(d[..., 3]))
    return np.all(d < (ROUNDING, ROUNDING, 5e-4, ROUNDING), axis=-1, keepdims=True)


def _begin(compiled: CompiledScene, given: np.ndarray | None, candidates: int) -> np.ndarray:
    """World poses [B, N, 4] to begin with: those given, or the scene's own for all candidates."""
    if given is None:
        return _all_at(compiled.room.home, candidates)
    room = compiled.room
    return into_domains(room.yaws, room.free != 0, room.roots, compiled.bodies(given))


def _all_at(home: np.ndarray, candidates: int) -> np.ndarray:
    """The same poses [N, 4] for all candidates: [B, N, 4], read-only, without copies."""
    return np.broadcast_to(home, (candidates, *home.shape))


def _in_order(batch: Batch, candidate: int, job: Job) -> np.ndarray:
    """Which objects [N] of a job's scene, as it is given, no violation names, with what carries and is carried.

    ``candidate`` is one of the job's in the batch.
    """
    room, part = job.compiled.room, batch.part(candidate, candidate + 1)
    part = replace(part, state=part.scratch())
    load_poses(part, room.home[None])
    verdict = judge(part)
    faulty = verdict.fault[0, : room.size] != 0
    for relation, holds in zip(room.relations, verdict.holds[0], strict=False):
        if relation.fault and not holds:
            faulty[[i for i in relation.objects if i >= 0]] = True
    return ~np.isin(room.roots, room.roots[faulty])


def _movement(before: np.ndarray, after: np.ndarray, in_order: np.ndarray) -> np.ndarray:
    """How much a layout [B, N, 4] moved: metres and half metres per radian, and a price for every object at all.

    The price is 5 m for what was in order [N], 5 cm for the others.
    """
    d = after - before
    turned = np.abs(wrap_angle(d[..., 3]))
    moved = np.linalg.norm(d[..., :3], axis=-1) + 0.5 * turned
    return np.sum(moved + np.where(in_order, 5.0, 0.05) * (moved > 0.01), axis=-1)


def _load_worlds(batch: Batch, worlds: Sequence[np.ndarray]) -> None:
    """Set the poses to begin with, those of one scene after the other. What is the same for all goes over once."""
    if any(world.strides[0] for world in worlds):
        load_poses(batch, stacked(worlds, batch.objects))
        return
    homes = wp.array(
        stacked([world[:1] for world in worlds], max(batch.objects, 1)), dtype=wp.vec4, device=batch.device
    )
    state = batch.state
    wp.launch(
        broadcast_poses,
        state.poses.shape,
        [batch.problem, homes],
        [state.poses, state.anchors],
        device=batch.device,
    )
    wp.launch(set_turns, state.poses.shape, [state.poses], [state.turns], device=batch.device)


def _layouts(batch: Batch, jobs: Sequence[Job]) -> list[np.ndarray]:
    """Every job's layouts [B, N, 4] on the host, each in its own memory: a solution must not keep those of others."""
    found, shapes = batch.state.poses, [(len(job.world), job.compiled.room.size) for job in jobs]
    if found.shape == shapes[0]:  # one job alone: from the device to where they belong
        if batch.device == "cpu" and jobs[0].into is None:
            return [found.numpy()]
        into = np.empty((*shapes[0], 4), dtype=np.float32) if jobs[0].into is None else jobs[0].into
        wp.copy(wp.array(into, dtype=wp.vec4, device="cpu", copy=False), found)
        wp.synchronize_device(batch.device)
        return [into]
    cuts = np.split(found.numpy(), np.cumsum([n for n, _ in shapes])[:-1])
    layouts = [poses[:, :size].copy() for poses, (_, size) in zip(cuts, shapes, strict=True)]
    for job, mine in zip(jobs, layouts, strict=True):
        if job.into is not None:
            job.into[:] = mine
    return layouts


def _prepared(
    jobs: Sequence[Job], devices: Sequence[str], optimizer: str | StepOptimizer, monitor: Monitor
) -> list[Job]:
    """The jobs with their surfaces solved, when several devices would all solve them."""
    if len(devices) == 1:
        return list(jobs)
    load(devices[0], *_modules(jobs, optimizer, devices[0]))
    pools = surface_pools(jobs, devices[0], monitor.deadline)
    return [replace(job, pools=mine) for job, mine in zip(jobs, pools, strict=True)]


def _locals(compiled: CompiledScene, world: np.ndarray) -> list[np.ndarray]:
    """Poses [B, members, 4] of what stands on each surface, in the supporter's frame, on the surface."""
    poses = []
    for domain in compiled.domains:
        members, supporter = world[:, domain.surface.members], world[:, None, domain.surface.supporter]
        local = relative(members.astype(np.float64), supporter.astype(np.float64))
        local[..., 2] = 0.0
        room = domain.problem
        poses.append(into_domains(room.yaws, room.free != 0, room.roots, local))
    return poses


def _domain_batch(compiled: CompiledScene, world: np.ndarray, seed: int, own: np.ndarray, device: str) -> Batch:
    """Every surface of every candidate (with numbers [B] of its own) of one scene as a batch, surface by surface."""
    which = np.repeat(np.arange(len(compiled.domains)), len(world))
    batch = make_batch([d.problem for d in compiled.domains], which, device)
    load_poses(batch, stacked(_locals(compiled, world), batch.objects))
    numbers = which * DOMAIN_STRIDE + np.tile(own, len(compiled.domains))
    batch.state.rng.assign(streams(seed ^ ~POOL_SALT & 0xFFFFFFFF, numbers))
    return batch


def mend_surfaces(job: Job, optimizer: str | StepOptimizer, device: str, monitor: Monitor) -> None:
    """Put what the given poses have on a surface back on it, with as little change as that takes."""
    how = "projection" if optimizer == "projection" else "search"
    compiled, world = job.compiled, job.world.copy()
    for i, obj in enumerate(compiled.scene.objects):
        if obj.mount in ("floor", "ceiling") and not obj.fixed:
            world[:, i, 2] = compiled.room.home[i, 2]
    if compiled.domains:
        batch = _domain_batch(compiled, world, job.seed, job.numbers, device)
        batch = replace(batch, weights=weights(pull=PULL))
        run(batch, how, "given", None, monitor.inner(batch.size))
        poses = batch.state.poses.numpy().reshape(len(compiled.domains), len(world), batch.objects, 4)
        for domain, solved in zip(compiled.domains, poses.astype(np.float64), strict=True):
            surface = domain.surface
            placed = absolute(solved[:, : len(surface.members)], world[:, None, surface.supporter])
            placed[..., 2] = world[:, None, surface.supporter, 2] + surface.height
            free = [not compiled.scene.objects[m].fixed for m in surface.members]
            members = np.asarray(surface.members)[free]
            world[:, members] = np.where(_same(world[:, members], placed[:, free]), world[:, members], placed[:, free])
    job.world = world
