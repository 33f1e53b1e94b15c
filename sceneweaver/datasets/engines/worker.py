"""A worker: a process that makes one block after the other, and may crash or hang without an end to the run."""

from __future__ import annotations

import contextlib
import os
import signal
import time
from multiprocessing.connection import Connection
from pathlib import Path

from sceneweaver.runtime import processes

from ..work import Produce
from .manifest import Dataset, open_dataset
from .tasks import Task, attempt

START = 300.0
"""Seconds that a worker gets to load what it needs."""


class Worker:
    """The near end of a worker."""

    def __init__(self, index: int, dataset: Dataset, device: str, produce: Produce | None):
        self.index, self.ready, self.used = index, False, False
        self.task: Task | None = None
        self._spec = dataset.spec
        self._process = processes.Worker(serve, dataset.folder.path, device, produce)
        self.end, self.pid = self._process.connection, self._process.pid
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
        code = self._process.end(wait)
        if code is None:
            return "worker hung: no scene for too long"
        return f"worker killed by signal {-code}" if code < 0 else f"worker ended with exit code {code}"


def serve(end: Connection, path: Path, device: str, produce: Produce | None) -> None:
    """Make blocks until nobody asks any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches the whole group; the run ends its workers itself
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
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


def _be_quiet() -> None:
    """Keep what libraries say off the output of the run."""
    if not os.environ.get("SCENEWEAVER_DEBUG"):
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), 1)
            os.dup2(nowhere.fileno(), 2)
