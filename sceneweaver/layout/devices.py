"""Which devices a run uses, and its candidates split over several of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.runtime.compiling import start_warp
from sceneweaver.runtime.threads import map_threads
from sceneweaver.scene import InputError, MissingDependencyError

from .job import Job
from .solution import Solution, best_of

WALKED = 8  # of the best candidates, how many are measured for walkable floor


def pick_devices(device: str) -> list[str]:
    """The Warp devices that a name stands for: "auto" takes the first GPU, else the CPU; "cuda:all" every GPU.

    Raises:
        InputError: not a device name. MissingDependencyError: a GPU that is not there.
    """
    start_warp()
    if device == "auto":
        return ["cuda:0" if wp.is_cuda_available() else "cpu"]
    if device == "cpu":
        return [device]
    name, _, index = device.partition(":")
    if name != "cuda" or not (index.isdigit() or index in ("", "all")):
        raise InputError(f'device: "{device}" is not one of auto, cpu, cuda, cuda:0, cuda:1 ..., cuda:all')
    count = wp.get_cuda_device_count()
    needed = 0 if index == "all" else int(index or 0)
    if needed >= count:
        found = f"{count} CUDA devices found" if count else "no CUDA device found"
        raise MissingDependencyError(f'device: "{device}" is not there ({found}); use device="cpu"')
    return [f"cuda:{i}" for i in range(count)] if index == "all" else [f"cuda:{needed}"]


def solve_on(
    devices: Sequence[str], jobs: Sequence[Job], solve: Callable[[Sequence[Job], str], list[Solution]]
) -> list[Solution]:
    """Solve jobs on several devices at once, each with its share of every job's candidates.

    A candidate is the same wherever it is solved, so the result is that of one device of the kind.
    """
    if len(devices) == 1:
        return solve(jobs, devices[0])
    layouts = [np.empty((len(job.world), job.compiled.room.size, 4), dtype=np.float32) for job in jobs]
    jobs = [replace(job, into=into) for job, into in zip(jobs, layouts, strict=True)]
    shares = [[_part(job, k, len(devices)) for job in jobs] for k in range(len(devices))]
    busy = [(share, device) for share, device in zip(shares, devices, strict=True) if any(len(j.world) for j in share)]
    found = map_threads(lambda task: solve([j for j in task[0] if len(j.world)], task[1]), busy, len(busy))
    parts: list[list[Solution]] = [[] for _ in jobs]
    for (share, _), solutions in zip(busy, found, strict=True):
        owners = [i for i, job in enumerate(share) if len(job.world)]
        for i, solution in zip(owners, solutions, strict=True):
            parts[i].append(solution)
    return [_joined(pieces, poses) for pieces, poses in zip(parts, layouts, strict=True)]


def _part(job: Job, k: int, of: int) -> Job:
    """The k-th of so many shares of a job's candidates."""
    cuts = np.linspace(0, len(job.world), of + 1).astype(int)
    mine = slice(cuts[k], cuts[k + 1])
    into = None if job.into is None else job.into[mine]
    return replace(job, world=job.world[mine], first=job.first + int(cuts[k]), into=into)


def _joined(parts: Sequence[Solution], poses: np.ndarray) -> Solution:
    """One solution of the shares of its candidates, in order; their layouts are in place already."""

    def join(name: str) -> np.ndarray:
        return np.concatenate([getattr(part, name) for part in parts])

    status, relations, energy, walkable = (join(name) for name in ("status", "relations", "energy", "walkable"))
    moved = None if parts[0].moved is None else join("moved")
    best = best_of(WALKED, parts[0].source, status, relations, energy, moved)
    measured = walkable[best]
    walkable[:] = np.nan  # as if all had been ranked at once
    walkable[best] = measured
    return replace(
        parts[0],
        poses=poses[:, : len(parts[0].source.objects)],
        free_floor=None if parts[0].free_floor is None else poses[:, len(parts[0].source.objects) :],
        status=status,
        relations=relations,
        energy=energy,
        walkable=walkable,
        moved=moved,
        elapsed=max(part.elapsed for part in parts),
        timed_out=any(part.timed_out for part in parts),
    )
