"""Processes that work on a data set: one for each core, with one thread each, which end when their parent does."""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

SPAWN = get_context("spawn")  # a fork of a process that has used CUDA or JAX is of no use

THREADS = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
"""One thread a process: there is one for each core, and sums of BLAS may differ with the number of threads."""

PR_SET_PDEATHSIG = 1


def cores() -> int:
    """How many cores this process may use; a worker has one thread, whatever OMP_NUM_THREADS says."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextlib.contextmanager
def one_thread_each() -> Iterator[None]:
    """Processes that are started in the block have one thread; who starts them keeps its own setting."""
    before = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(THREADS)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


@contextlib.contextmanager
def pool(workers: int) -> Iterator[ProcessPoolExecutor]:
    """So many processes for small pieces of work."""
    with (
        one_thread_each(),
        ProcessPoolExecutor(workers, mp_context=SPAWN, initializer=end_with_parent) as processes,
    ):
        yield processes


def end_with_parent() -> None:
    """Ask Linux to kill this process when the one that started it is gone, also by SIGKILL."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
