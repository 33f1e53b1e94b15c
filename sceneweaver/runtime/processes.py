"""Processes that do work: pools for many small pieces, and workers that may crash or hang.

All are spawned, have one thread each, and end when the process that started them does.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

SPAWN = get_context("spawn")  # a fork of a process that has used CUDA or JAX is of no use

THREADS = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
"""One thread a process: there is one for each core, and sums of BLAS may differ with the number of threads."""

SAFE_PATH = "PYTHONSAFEPATH"
"""Keeps the current folder off the path of modules while Python starts: it may be that of a user's scenes."""

PR_SET_PDEATHSIG = 1


def cores() -> int:
    """How many cores this process may use; a worker has one thread, whatever OMP_NUM_THREADS says."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def processor_seconds(pid: int) -> float:
    """Processor time of a process in all its threads [s]; 0 where the system does not say, or the process is gone."""
    try:
        after_name = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return (int(after_name[11]) + int(after_name[12])) / os.sysconf("SC_CLK_TCK")
    except (OSError, IndexError, ValueError):
        return 0.0


@contextlib.contextmanager
def pool(workers: int, *, deaf: bool = False) -> Iterator[ProcessPoolExecutor]:
    """So many processes for small pieces of work, for as long as the block runs.

    Args:
        workers: how many.
        deaf: whether they do not hear Ctrl-C, as who started them ends them.
    """
    begin = _begin_deaf if deaf else _begin
    with ProcessPoolExecutor(workers, mp_context=SPAWN, initializer=begin) as processes:
        with _environment(THREADS):
            for _ in range(workers):  # each spawns one, as long as none is idle
                processes.submit(int)
        yield processes


def _begin() -> None:
    """The first that a process of a pool does; one that was spawned late has not seen the variables yet."""
    os.environ.update(THREADS)
    end_with_parent()


def _begin_deaf() -> None:
    """As `_begin`, of a process that its parent ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _begin()


class Worker:
    """A process at the other end of a connection, which may crash or hang without harm to the one that started it.

    Args:
        serve: what the process does, given its end of the connection and ``arguments``; it should return when the
            connection is closed. Found by name, as ``pickle`` finds functions.
        arguments: what else it is given.
        threads: how many threads its libraries may use; None: as many as here.
        killed_with_parent: whether it is killed when this process is gone; a worker that hears of that by its
            connection can end in order instead.
        starts_others: whether it may start processes of its own; whoever started it has to `end` it then.
    """

    def __init__(
        self,
        serve: Callable[..., None],
        *arguments: Any,
        threads: int | None = 1,
        killed_with_parent: bool = True,
        starts_others: bool = False,
    ) -> None:
        self.connection, theirs = SPAWN.Pipe()
        limits = {} if threads is None else dict.fromkeys(THREADS, str(threads))
        self._process = SPAWN.Process(
            target=_serve,
            args=(serve, theirs, killed_with_parent, SAFE_PATH not in os.environ, arguments),
            daemon=not starts_others,
        )
        with theirs, _environment({**limits, SAFE_PATH: "1"}):
            self._process.start()
        self.pid = self._process.pid or 0

    @property
    def alive(self) -> bool:
        """Whether the process runs."""
        return self._process.is_alive()

    def end(self, wait: float = 0.0) -> int | None:
        """Close the connection, and end the process if it has not ended by itself after so many seconds.

        Returns:
            Its exit code, negative for the signal that killed it; None where it had to be killed here.
        """
        self.connection.close()
        self._process.join(wait)
        by_itself = not self._process.is_alive()
        self._process.kill()
        self._process.join()
        return self._process.exitcode if by_itself else None


def _serve(
    serve: Callable[..., None], connection: Connection, killed_with_parent: bool, unsafe: bool, arguments: tuple
) -> None:
    if killed_with_parent:
        end_with_parent()
    if unsafe:
        os.environ.pop(SAFE_PATH, None)  # was meant for this process alone, not for those that it starts
    serve(connection, *arguments)


@contextlib.contextmanager
def _environment(values: dict[str, str]) -> Iterator[None]:
    """Processes that are started in the block see these variables; who starts them keeps its own."""
    before = {name: os.environ.get(name) for name in values}
    os.environ.update(values)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def end_with_parent() -> None:
    """Ask Linux to kill this process when the one that started it is gone, also by SIGKILL."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
