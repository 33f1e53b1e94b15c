"""Work over several threads, for what releases the interpreter's lock."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_EXCEPTION, ThreadPoolExecutor, wait
from typing import TypeVar

from . import processes
from .deadline import checkpoint

Item = TypeVar("Item")
Found = TypeVar("Found")

TICK = 0.1
"""Seconds between the checkpoints of the thread that waits."""


def cores() -> int:
    """How many threads this process should use: one for each core, no more than OMP_NUM_THREADS says."""
    limit = os.environ.get("OMP_NUM_THREADS", "")
    return min(processes.cores(), int(limit)) if limit.isdigit() and int(limit) else processes.cores()


def map_threads(work: Callable[[Item], Found], items: Iterable[Item], threads: int) -> list[Found]:
    """What ``work`` returns for each item, in their order.

    After an exception, or when the time of the caller is up, no further item is begun, and those that were are done
    before it goes on: nothing works in the background on what the caller may free.
    """
    pool = ThreadPoolExecutor(threads)
    try:
        futures = [pool.submit(work, item) for item in items]
        waiting = set(futures)
        while waiting:
            done, waiting = wait(waiting, TICK, FIRST_EXCEPTION)
            checkpoint()
            for future in done:
                future.result()
        return [future.result() for future in futures]
    finally:
        pool.shutdown(cancel_futures=True)
