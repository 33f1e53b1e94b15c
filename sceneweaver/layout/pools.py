"""Layouts of what stands on each surface, solved beforehand; equal surfaces are solved once in a process."""

from __future__ import annotations

import hashlib
import pickle
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import fields
from itertools import count
from threading import Lock
from typing import Any

import numpy as np

from sceneweaver.kernels.tables import FEATURE_USER
from sceneweaver.optimizers import Monitor, judge, load_poses, run, streams
from sceneweaver.optimizers.base import Moment
from sceneweaver.optimizers.search import effort_for

from .batch import make_batch, stacked
from .compile import LayoutProblem
from .job import Job

POOL = 64  # layouts solved beforehand for every support surface
POOL_SALT = 0x5EED
KEPT = 1024  # surfaces whose layouts are kept
NAMES = {"ids", "relation_ids", "packed"}  # fields of a problem that its layouts do not depend on

_Key = tuple[bytes, int, int, str]
_known: OrderedDict[_Key, np.ndarray] = OrderedDict()
_lock = Lock()
_unique = count()


def surface_pools(jobs: Sequence[Job], device: str, deadline: Moment | None) -> list[list[np.ndarray]]:
    """For every surface of every job, POOL layouts [POOL, members, 4] of its surface, all solved in shared launches."""
    wanted = [
        (_key(domain.problem, job.seed, number, device), domain.problem, job.seed, number)
        for job in jobs
        if job.pools is None
        for number, domain in enumerate(job.compiled.domains)
    ]
    with _lock:
        found = {key: _known[key] for key, *_ in wanted if key in _known}
    new = {key: surface for key, *surface in wanted if key not in found}
    monitor = Monitor(POOL * len(new), deadline)
    solved = dict(zip(new, _solved(list(new.values()), device, monitor), strict=True)) if new else {}
    found |= solved
    with _lock:
        if not monitor.timed_out:
            _known.update(solved)
        for key in found.keys() & _known.keys():
            _known.move_to_end(key)
        while len(_known) > KEPT:
            _known.popitem(last=False)
    keys = iter([key for key, *_ in wanted])
    return [[found[next(keys)] for _ in job.compiled.domains] if job.pools is None else job.pools for job in jobs]


def _solved(surfaces: Sequence[Sequence[Any]], device: str, monitor: Monitor) -> list[np.ndarray]:
    """The layouts of some surfaces (problem, seed, number in its scene)."""
    problems = [problem for problem, *_ in surfaces]
    batch = make_batch(problems, np.repeat(np.arange(len(problems)), POOL), device)
    load_poses(batch, stacked([np.repeat(problem.home[None], POOL, axis=0) for problem in problems], batch.objects))
    seeds = [streams(seed ^ POOL_SALT, number * POOL + np.arange(POOL)) for _, seed, number in surfaces]
    batch.state.rng.assign(np.concatenate(seeds))
    attempts = effort_for(device, "random", batch.objects).attempts  # some good layouts are enough
    run(batch, "search", "random", attempts, monitor)
    status = judge(batch).status.reshape(-1, POOL)
    poses = batch.state.poses.numpy().reshape(len(problems), POOL, batch.objects, 4)
    pools = []
    for problem, verdict, layouts in zip(problems, status, poses, strict=True):
        good = np.flatnonzero(verdict == 0)
        entries = np.resize(good, POOL) if good.size else np.arange(POOL)
        pools.append(layouts[entries, : problem.size])
        pools[-1].flags.writeable = False
    return pools


def _key(problem: LayoutProblem, seed: int, number: int, device: str) -> _Key:
    """What the layouts of a surface depend on; a key of its own where a relation of a user is among it."""
    rows = (row for relation in problem.relations for option in relation.options for row in option)
    if any(row.feature >= FEATURE_USER for row in rows):
        return str(next(_unique)).encode(), seed, number, device
    content = [getattr(problem, field.name) for field in fields(problem) if field.name not in NAMES]
    return hashlib.sha256(pickle.dumps(content)).digest(), seed, number, device
