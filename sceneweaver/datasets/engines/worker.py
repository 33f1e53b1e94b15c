"""A worker: a process that makes one block after the other, and may crash or hang without an end to the run."""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import sys
import time
from collections.abc import Iterator
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

from ..work import Produce
from .manifest import Dataset, open_dataset
from .tasks import Task, attempt

SPAWN = get_context("spawn")  # a fork of a process that has used CUDA or JAX is of no use

THREADS = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
"""One thread a worker: there is one for each core, and sums of BLAS may differ with the number of threads."""

START = 300.0
"""Seconds that a worker gets to load what it needs."""

PR_SET_PDEATHSIG = 1


class Worker:
    """The near end of a worker."""

    def __init__(self, index: int, dataset: Dataset, device: str, produce: Produce | None):
        self.index, self.ready, self.used = index, False, False
        self.task: Task | None = None
        self._spec = dataset.spec
        self.end, theirs = SPAWN.Pipe()
        with _environment(THREADS):
            arguments = (theirs, dataset.folder.path, device, produce)
            self._process = SPAWN.Process(target=serve, args=arguments, daemon=True)
            self._process.start()
        theirs.close()
        self.pid = self._process.pid or 0
        self._deadline = time.monotonic() + START

    def give(self, task: Task) -> None:
        """Ask for a block. A process that has just ended will be heard of as one that ended at it."""
        self.task, self.used = task, True
        with contextlib.suppress(OSError):
            self.end.send(task)
        self.alive()

    def alive(self) -> None:
        """A sign of life: from now on the worker may be silent as long as its task allows."""
        patience = START if self.task is None else self.task.patience(self._spec)
        self._deadline = time.monotonic() + patience + (0.0 if self.ready else START)

    @property
    def hung(self) -> bool:
        """Whether it was silent for too long."""
        return (self.task is not None or not self.ready) and time.monotonic() > self._deadline

    def close(self, wait: float = 0.0) -> str:
        """End the process, at once or when it has not ended by itself after some seconds; how it ended."""
        if self.end.closed:
            return ""
        self._process.join(wait)
        by_itself = not self._process.is_alive()
        self._process.kill()
        self._process.join()
        self.end.close()
        code = self._process.exitcode or 0
        if not by_itself:
            return "worker hung: no scene for too long"
        return f"worker killed by signal {-code}" if code < 0 else f"worker ended with exit code {code}"


def serve(end: Connection, path: Path, device: str, produce: Produce | None) -> None:
    """Make blocks until nobody asks any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches the whole group; the run ends its workers itself
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    _end_with_parent()
    _be_quiet()
    dataset = open_dataset(path)

    def alive() -> None:
        end.send(("alive", None))

    end.send(("ready", None))
    while True:
        try:
            task = end.recv()
        except EOFError:
            return
        end.send(attempt(dataset, task, device, produce, alive))


@contextlib.contextmanager
def _environment(values: dict[str, str]) -> Iterator[None]:
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


def _end_with_parent() -> None:
    """Ask Linux to kill this process when the run that started it is gone, also by SIGKILL."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def _be_quiet() -> None:
    """Keep what libraries say off the output of the run."""
    if not os.environ.get("SCENEWEAVER_DEBUG"):
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), 1)
            os.dup2(nowhere.fileno(), 2)
