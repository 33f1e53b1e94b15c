"""Run an optimiser over a whole batch: in one piece on a GPU, in pieces over threads on a CPU."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, wait

import numpy as np
import warp as wp

from sceneweaver.kernels import load

from .base import OPTIMIZERS, Monitor, OptimizerResult, Start
from .batch import Batch
from .verdict import Verdict, judge

BROKEN = 1  # the verdict's status of bodies that are in each other's way
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
    return [batch.part(*rows) for rows in _cuts(batch)] if batch.device == "cpu" else [batch]


def _cuts(batch: Batch) -> list[tuple[int, int]]:
    """The first candidate of each piece that a CPU thread takes, and the one after its last."""
    piece = max(1, min(PIECE, -(-batch.size // cpu_threads()), PIECE_PAIRS // max(1, batch.objects**2)))
    return [(i, min(i + piece, batch.size)) for i in range(0, batch.size, piece)]


def run(batch: Batch, optimizer: str, start: Start, budget: int | None, monitor: Monitor) -> OptimizerResult:
    """Move the batch's poses in place. Pieces do not know of each other, so threads do not change the result.

    On a CPU the caller waits and looks at the clock while threads work, so that neither a signal nor the end of the
    time waits for a kernel. What is not begun when kernels break off stays at its poses, with an infinite energy.
    """
    solve = OPTIMIZERS[optimizer]
    if not batch.size or not batch.objects:
        monitor.add(batch.size, batch.size, 0.0)
        return OptimizerResult(np.zeros(batch.size, dtype=np.float32))
    if batch.device != "cpu":
        with wp.ScopedDevice(batch.device):
            return solve(batch, start, budget, monitor)
    energy = np.full(batch.size, np.inf, dtype=np.float32)

    def piece(rows: tuple[int, int]) -> None:
        if rows[0] and monitor.broken_off:  # late or not, the first piece begins
            monitor.add(rows[1] - rows[0], 0, float("inf"))
            return
        energy[slice(*rows)] = solve(batch.part(*rows), start, budget, monitor).energy

    load(batch.device, *OPTIMIZERS[optimizer].modules_on(batch.device), "bookkeeping")
    on_threads(piece, _cuts(batch), monitor)
    return OptimizerResult(energy)


def judge_in_time(batch: Batch, monitor: Monitor) -> Verdict:
    """Verdict on every candidate, as by `judge`; those that there is no time for count as at fault."""
    if batch.device != "cpu" or batch.size <= PIECE or not batch.objects:
        return judge(batch)
    load(batch.device, "verdict")
    status = np.full(batch.size, BROKEN, dtype=np.int8)
    fault = np.zeros((batch.size, batch.objects), dtype=np.int8)
    holds = np.zeros((batch.size, max(batch.relations, 1)), dtype=bool)

    def piece(rows: tuple[int, int]) -> None:
        if not rows[0] or not monitor.broken_off:
            found = judge(batch.part(*rows))
            mine = slice(*rows)
            status[mine], fault[mine], holds[mine] = found.status, found.fault, found.holds

    on_threads(piece, _cuts(batch), monitor)
    return Verdict(status, fault, holds)


def on_threads(work: Callable[[tuple[int, int]], None], cuts: Sequence[tuple[int, int]], monitor: Monitor) -> None:
    """Do pieces of work on the threads of a CPU, side by side: on two cores there are two.

    Their kernels have to be loaded. After an exception of the caller the pieces that are under way end at once, and no
    other begins.
    """
    if not cuts:
        return
    began = time.monotonic()
    with ThreadPoolExecutor(min(cpu_threads(), len(cuts))) as pool:
        try:
            for future in [pool.submit(work, rows) for rows in cuts]:
                while not future.done():
                    wait([future], TICK)
                    monitor.watch(began)
                future.result()
        except BaseException:
            monitor.break_off()
            pool.shutdown(wait=False, cancel_futures=True)
            raise
