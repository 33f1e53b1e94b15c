"""Refine a scene: compile, solve surfaces, solve the room, judge the whole, choose."""

from __future__ import annotations

import math
import time

import numpy as np
import warp as wp

from sceneweaver.optimizers import OPTIMIZERS, Batch, Monitor, judge, load_poses, new_state, run, streams
from sceneweaver.optimizers.batch import Progress
from sceneweaver.scene import InputError, MissingDependencyError, Scene

from .compile import CompiledScene, absolute, compile_scene, relative
from .pack import margins, pack, weights
from .solution import Solution

INITS = ("sample", "random", "current")


def pick_device(device: str) -> str:
    """The Warp device that a name stands for; "auto" takes the first GPU, else the CPU.

    Raises:
        InputError: not a device name. MissingDependencyError: a GPU that is not there.
    """
    quiet()
    if device == "auto":
        return "cuda:0" if wp.is_cuda_available() else "cpu"
    if device == "cpu":
        return device
    name, _, index = device.partition(":")
    if name != "cuda" or not (index.isdigit() or index == ""):
        raise InputError(f'device: "{device}" is not one of auto, cpu, cuda, cuda:0, cuda:1 ...')
    count = wp.get_cuda_device_count()
    if int(index or 0) >= count:
        found = f"{count} CUDA devices found" if count else "no CUDA device found"
        raise MissingDependencyError(f'device: "{device}" is not there ({found}); use device="cpu"')
    return f"cuda:{int(index or 0)}"


def quiet() -> None:
    """Keep Warp's start-up notes off the terminal."""
    wp.config.quiet = True
    wp.init()


def refine(
    scene: Scene,
    *,
    candidates: int = 1024,
    seed: int = 0,
    init: str | np.ndarray = "sample",
    device: str = "auto",
    optimizer: str = "search",
    time_limit: float | None = None,
    steps: int | None = None,
    progress: Progress | None = None,
) -> Solution:
    """Refine many candidate layouts of a scene at once.

    Args:
        scene: what to lay out; its poses matter to ``init="current"`` and for fixed objects.
        candidates: how many layouts B to refine.
        seed: with the same seed and kind of device, the same bits.
        init: "sample" draws starts from the relations, "random" anywhere, "current" begins with the scene's poses;
            an array [B, N, 4] of world poses (x, y, z, yaw) begins with those.
        device: "auto", "cpu", "cuda" or "cuda:k".
        optimizer: a name in ``sceneweaver.optimizers.OPTIMIZERS``.
        time_limit: seconds after which to stop with what there is; the result says that it was cut off.
        steps: the optimiser's budget in its own work units (search: attempts, adam: steps).
        progress: called now and then as ``progress(done, total, valid, lowest energy)``.

    Raises:
        InputError: an argument is out of range. MissingDependencyError: the device is not there.
    """
    began = time.monotonic()
    given = _check_arguments(scene, candidates, seed, init, optimizer, time_limit, steps)
    where = pick_device(device)
    compiled = compile_scene(scene)
    count = candidates if given is None else len(given)
    monitor = Monitor(count, None if time_limit is None else began + time_limit, progress)
    start = init if isinstance(init, str) and init != "current" else "given"
    world = np.repeat(compiled.room.home[None], count, axis=0) if given is None else given
    locals_, broken = _solve_domains(compiled, world, start, seed, where, monitor.deadline)
    world = _carry(compiled, world, locals_)
    batch = _batch(compiled, world, seed, where)
    outcome = run(batch, optimizer, start, steps, monitor)
    verdict = judge(batch)
    poses = batch.state.poses.numpy()[:, : compiled.room.size].copy()
    status = verdict.status.copy()
    status[(status != 3) & (broken | compiled.room.faulty)] = 1
    poses = _exact(compiled, poses)
    solution = Solution(
        source=scene,
        poses=poses,
        status=status,
        relations=verdict.holds[:, : len(scene.relations)],
        energy=outcome.energy.astype(np.float32),
        seed=seed,
        device=where,
        elapsed=time.monotonic() - began,
        timed_out=monitor.timed_out,
    )
    return solution


def _check_arguments(scene, candidates, seed, init, optimizer, time_limit, steps) -> np.ndarray | None:
    """Raise InputError on anything out of range; the poses to start from when ``init`` is an array."""
    for name, value in (("candidates", candidates), ("steps", steps)):
        if value is not None and (not isinstance(value, int | np.integer) or isinstance(value, bool) or value < 1):
            raise InputError(f"{name}: {value!r} is not a whole number of at least 1")
    if not isinstance(seed, int | np.integer) or not 0 <= seed < 2**32:
        raise InputError(f"seed: {seed!r} is not a whole number from 0 to 2**32 - 1")
    if optimizer not in OPTIMIZERS:
        raise InputError(f'optimizer: "{optimizer}" is not one of {", ".join(sorted(OPTIMIZERS))}')
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit!r} is not a positive number of seconds")
    if isinstance(init, str):
        if init not in INITS:
            raise InputError(f'init: "{init}" is not one of {", ".join(INITS)} or an array of poses [B, N, 4]')
        return None
    poses = np.asarray(init, dtype=np.float64)
    if poses.ndim != 3 or poses.shape[1:] != (len(scene.objects), 4) or not len(poses):
        raise InputError(f"init: an array of shape {poses.shape}; poses are [B, {len(scene.objects)}, 4]")
    if not np.isfinite(poses).all():
        raise InputError("init: poses must be finite numbers")
    return poses


def _batch(compiled: CompiledScene, world: np.ndarray, seed: int, device: str) -> Batch:
    """The room's batch, ready to run."""
    packed = pack([compiled.room], device)
    count = len(world)
    batch = Batch(
        packed.tables,
        margins(),
        weights(),
        wp.zeros(count, dtype=wp.int32, device=device),
        new_state(count, packed.objects, packed.relations, device),
        packed.objects,
        packed.relations,
        device,
    )
    load_poses(batch, world)
    batch.state.rng.assign(streams(seed, np.arange(count)))
    return batch


def _solve_domains(
    compiled: CompiledScene, world: np.ndarray, start: str, seed: int, device: str, deadline: float | None
) -> tuple[list[np.ndarray], np.ndarray]:
    """Lay out every support surface for every candidate, all in shared launches.

    Returns the local poses [B, members, 4] of each domain and which candidates have a surface that is not in order.
    """
    count, domains = len(world), compiled.domains
    broken = np.zeros(count, dtype=bool)
    if not domains:
        return [], broken
    packed = pack([d.problem for d in domains], device)
    kinds = np.tile(np.arange(len(domains), dtype=np.int32), count)  # a candidate's domains lie together
    poses = np.zeros((count, len(domains), packed.objects, 4))
    for k, domain in enumerate(domains):
        local = relative(world[:, domain.members], world[:, None, domain.supporter])
        local[..., 2] = 0.0
        poses[:, k, : len(domain.members)] = local
    batch = Batch(
        packed.tables,
        margins(),
        weights(),
        wp.array(kinds, dtype=wp.int32, device=device),
        new_state(len(kinds), packed.objects, packed.relations, device),
        packed.objects,
        packed.relations,
        device,
    )
    load_poses(batch, poses.reshape(len(kinds), packed.objects, 4))
    batch.state.rng.assign(streams(seed ^ 0x5EED, np.arange(len(kinds))))
    run(batch, "search", start, None, Monitor(len(kinds), deadline))
    verdict = judge(batch)
    solved = batch.state.poses.numpy().reshape(count, len(domains), packed.objects, 4).astype(np.float64)
    for k, domain in enumerate(domains):
        fixed = [i for i, m in enumerate(domain.members) if compiled.scene.objects[m].fixed]
        solved[:, k, fixed] = poses[:, k, fixed]
    broken = np.any(verdict.status.reshape(count, len(domains)) == 1, axis=1)
    return [solved[:, k, : len(d.members)] for k, d in enumerate(domains)], broken


def _carry(compiled: CompiledScene, world: np.ndarray, locals_: list[np.ndarray]) -> np.ndarray:
    """World poses with everything on a surface put back onto its supporter."""
    world = world.copy()
    for domain, local in zip(compiled.domains, locals_, strict=True):
        placed = absolute(local, world[:, None, domain.supporter])
        placed[..., 2] = world[:, None, domain.supporter, 2] + domain.height
        world[:, domain.members] = placed
    for i, obj in enumerate(compiled.scene.objects):
        if obj.mount in ("floor", "ceiling") and not obj.fixed:
            world[:, i, 2] = compiled.room.home[i, 2]
    return world


def _exact(compiled: CompiledScene, poses: np.ndarray) -> np.ndarray:
    """Poses with yaw in (-pi, pi]."""
    poses[..., 3] = (poses[..., 3] + math.pi) % (2 * math.pi) - math.pi
    return poses
