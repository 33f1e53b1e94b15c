"""Many calls side by side, each process with cores to itself."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import TypeVar

T = TypeVar("T")


def each(function: Callable[..., T], arguments: Iterable[tuple], jobs: int) -> list[T]:
    """``function(*a)`` for each ``a`` of ``arguments``, in their order, at most ``jobs`` at a time.

    The function has to be a module's own, its arguments and what it returns such that they can be pickled. Processes
    are spawned, as a fork would take along Warp's threads and the GPU, and share the cores out among them: what one
    measures does not depend on the others.
    """
    calls = list(arguments)
    shares = core_shares(min(jobs, len(calls)))
    if len(shares) < 2:
        return [function(*a) for a in calls]
    context = multiprocessing.get_context("spawn")
    queue = context.SimpleQueue()
    for share in shares:
        queue.put(share)
    with ProcessPoolExecutor(len(shares), mp_context=context, initializer=_pin, initargs=(queue,)) as pool:
        return [future.result() for future in [pool.submit(function, *a) for a in calls]]


def core_shares(count: int) -> list[list[int]]:
    """The cores of this process in ``count`` shares of equal size; fewer where there are fewer cores."""
    if not hasattr(os, "sched_getaffinity"):
        return [[] for _ in range(max(1, min(count, os.cpu_count() or 1)))]
    cores = sorted(os.sched_getaffinity(0))
    count = max(1, min(count, len(cores)))
    size = len(cores) // count
    return [cores[k * size : (k + 1) * size] for k in range(count)]


def _pin(queue: multiprocessing.SimpleQueue[Sequence[int]]) -> None:
    cores = queue.get()
    if cores:
        os.sched_setaffinity(0, cores)
