"""Run an optimiser over a whole batch: in one piece on a GPU, in pieces over threads on a CPU."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor, wait

import numpy as np
import warp as wp

from .base import OPTIMIZERS, Monitor, OptimizerResult, Start
from .batch import Batch

PIECE = 32  # candidates that one CPU thread takes at a time: small enough to share work, large enough to pay a launch
TICK = 0.1  # [s] after which who waits for the threads looks up
PIECE_PAIRS = 2**17  # pairs of objects in those candidates: no launch should go on for seconds when time is up


def cpu_threads() -> int:
    """Threads worth starting: the cores that this process may use; no more than OMP_NUM_THREADS, where it is set."""
    count = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    limit = os.environ.get("OMP_NUM_THREADS", "")
    return min(count, int(limit)) if limit.isdigit() and int(limit) else count


def pieces(batch: Batch) -> list[Batch]:
    """The batch in the pieces that CPU threads take, on a GPU as it is."""
    if batch.device != "cpu":
        return [batch]
    piece = max(1, min(PIECE, -(-batch.size // cpu_threads()), PIECE_PAIRS // max(1, batch.objects**2)))
    return [batch.part(i, min(i + piece, batch.size)) for i in range(0, batch.size, piece)]


def run(batch: Batch, optimizer: str, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
    """Move the batch's poses in place. Pieces do not know of each other, so threads do not change the result."""
    solve = OPTIMIZERS[optimizer]
    if not batch.size or not batch.objects:
        monitor.add(batch.size, batch.size, 0.0)
        return OptimizerResult(np.zeros(batch.size, dtype=np.float32))
    if batch.device != "cpu":
        with wp.ScopedDevice(batch.device):
            return solve(batch, start, budget, monitor)
    parts = pieces(batch)
    if cpu_threads() == 1:
        return OptimizerResult(np.concatenate([solve(part, start, budget, monitor).energy for part in parts]))
    if len(parts) == 1:
        return solve(parts[0], start, budget, monitor)
    outcomes = [solve(parts[0], start, budget, monitor)]  # the first alone: it compiles what is not compiled yet
    with ThreadPoolExecutor(cpu_threads()) as pool:
        futures = [pool.submit(solve, part, start, budget, monitor) for part in parts[1:]]
        try:
            for future in futures:
                while not future.done():  # an interrupt can end the wait at each turn
                    wait([future], TICK)
                outcomes.append(future.result())
        except BaseException:
            monitor.timed_out = True  # the other threads end as well, when they look at it next
            raise
    return OptimizerResult(np.concatenate([o.energy for o in outcomes]))
