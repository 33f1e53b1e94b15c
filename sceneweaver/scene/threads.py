"""Work over several threads, for what releases the interpreter's lock."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_EXCEPTION, ThreadPoolExecutor, wait
from typing import TypeVar

Item = TypeVar("Item")
Found = TypeVar("Found")

TICK = 0.1
"""Seconds after which who waits looks up: an interrupt can end the wait there."""


def cores() -> int:
    """How many cores this process may use; no more than OMP_NUM_THREADS says, where it is set."""
    count = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    limit = os.environ.get("OMP_NUM_THREADS", "")
    return min(count, int(limit)) if limit.isdigit() and int(limit) else count


def map_threads(work: Callable[[Item], Found], items: Iterable[Item], threads: int) -> list[Found]:
    """What ``work`` returns for each item, in their order.

    After an exception, or an interrupt of the caller, no further item is begun, and those that were are done before it
    goes on: nothing works in the background on what the caller may free.
    """
    pool = ThreadPoolExecutor(threads)
    try:
        futures = [pool.submit(work, item) for item in items]
        waiting = set(futures)
        while waiting:
            done, waiting = wait(waiting, TICK, FIRST_EXCEPTION)
            for future in done:
                future.result()
        return [future.result() for future in futures]
    finally:
        pool.shutdown(cancel_futures=True)
