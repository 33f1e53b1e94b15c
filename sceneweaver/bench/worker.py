"""A process that makes runs, which may crash, hang or take too much memory."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from multiprocessing.connection import Connection

from sceneweaver.runtime import processes
from sceneweaver.runtime.memory import memory, resident

from .course import settle
from .entries import Method, Task
from .execute import Prepared, blank, execute
from .results import Row
from .settings import Settings

LOOK = 0.5  # [s] between looks at what a process takes
PATIENCE = 6.0  # wall seconds for a second of processor time, on a machine with other work to do
KEPT = 0.25  # of the memory that a run may take


class OutOfTime(Exception):
    """The time of the whole comparison is over; the run that was under way is not one of its results."""


class Worker:
    """A process that makes one run after another; a new one takes its place where it had to end.

    What it keeps is what costs time alone: imports, kernels, compiled problems, optimisers that are warm. It is
    replaced as well where that has grown to a quarter of the memory that a run may take.

    Args:
        threads: how many threads its libraries may use; None: as many as here.
        over: asked twice a second whether it is to be killed whatever it does.
    """

    def __init__(self, threads: int | None = None, over: Callable[[], bool] = lambda: False) -> None:
        self._process: processes.Worker | None = None
        self._sent: set[str] = set()  # hashes of the problems that the process has been given
        self._threads, self._over = threads, over

    def execute(self, method: Method, task: Task, seed: int, settings: Settings) -> Iterator[Row]:
        """Rows as of `execute.execute`; the last one says so where the process was killed or crashed.

        Raises:
            OutOfTime: all has to end now.
        """
        row, began = blank(method, task, seed, settings), time.monotonic()
        end = self._send(method, task, seed, settings)
        before, spent = self._resident(), self._spent()
        most = math.inf if settings.memory is None else settings.memory * 2**30
        by_processor = settings.clock == "cpu"
        while True:
            if not end.poll(LOOK):
                taken, wall = self._resident() - before, time.monotonic() - began
                if self._over():
                    self.close()
                    raise OutOfTime
                late = wall > (PATIENCE if by_processor else 1.0) * settings.limit
                if by_processor and self._spent() - spent > settings.limit:
                    late = True
                if not late and taken <= most:
                    continue
                self.close()
                reason = f"killed after {settings.limit:g} s"
                if taken > most:
                    reason = f"killed at {taken / 2**30:.1f} GiB of memory, {settings.memory:g} are allowed"
                break
            try:
                found = end.recv()
            except (EOFError, ConnectionError):
                reason = f"the process ended by itself, exit code {self.close()}"
                break
            if isinstance(found, bool):
                if not found:
                    self.close()
                return
            row = found
            yield row
        yield replace(row, checkpoint=row.checkpoint + 1, outcome="killed", reason=reason)

    def _send(self, method: Method, task: Task, seed: int, settings: Settings) -> Connection:
        if self._process is None or not self._process.alive:
            self.close()
            self._process = processes.Worker(serve, threads=self._threads)
        known = task.hash in self._sent  # to read a large scene takes as long as a short run
        self._process.connection.send((method, task.hash, None if known else task, seed, settings))
        self._sent.add(task.hash)
        return self._process.connection

    def _spent(self) -> float:
        return processes.processor_seconds(self._process.pid) if self._process is not None else 0.0

    def _resident(self) -> int:
        return resident(self._process.pid) if self._process is not None else 0

    def close(self) -> int | None:
        """End the process; its exit code."""
        process, self._process, self._sent = self._process, None, set()
        return process.end(1.0) if process is not None else None


def serve(end: Connection) -> None:
    """Do what is asked for until nobody asks any more. After the last row of a run follows whether another may come."""
    prepared, tasks = Prepared(), {}
    while True:
        try:
            method, name, task, seed, settings = end.recv()
        except EOFError:
            return
        task = tasks.setdefault(name, task)
        for row in execute(method, task, seed, settings, prepared):
            end.send(row)
        end.send(works(settings.device) and not _grown(settings))


def _grown(settings: Settings) -> bool:
    """Whether what this process keeps has grown too large."""
    return settings.memory is not None and memory()[0] > KEPT * settings.memory * 2**30


def works(device: str) -> bool:
    """Whether a device still works for this process: an error of CUDA stays for good."""
    try:
        settle(device)
    except Exception:  # Warp and PyTorch raise their own
        return False
    return True
