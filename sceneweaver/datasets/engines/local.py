"""Blocks made by processes of this machine, each of which may crash or hang without an end to the run."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import time
from collections.abc import Iterable, Sequence
from multiprocessing.connection import Connection, wait
from pathlib import Path

from sceneweaver.runtime import processes
from sceneweaver.runtime.processes import cores
from sceneweaver.scene import SceneWeaverError

from ..work import Produce
from .manifest import Dataset, open_dataset
from .schedule import Job, Message, Schedule, Task, attempt

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
    """Make blocks until the connection is closed."""
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


TICK = 1.0
"""Seconds between checks of silent workers and of a full disk."""

FALSE_STARTS = 3
"""How many workers may end before they are ready, one after the other."""


class LocalEngine:
    """Workers of this machine, with a block each until all are made.

    Args:
        job: what is asked for.
        devices: where they lay out rooms, in turns.
    """

    def __init__(self, job: Job, devices: Sequence[str]):
        self._job, self._devices, self._count = job, devices, job.options.workers or cores()
        self._workers: list[Worker] = []
        self._false_starts = 0
        self.began = 0.0
        """When it was asked to run [s since 1970]."""

    def run(self, numbers: Iterable[int]) -> None:
        """Make these blocks.

        Raises:
            DiskFullError: the disk is full, and the engine is not patient. MissingDependencyError: of a worker.
            SceneWeaverError: workers do not even begin.
        """
        self.began = time.time()
        schedule = Schedule(self._job, numbers, self._count)
        try:
            for index in range(min(self._count, schedule.waiting)):
                self._workers.append(self._worker(index))
            while not schedule.over:
                self._step(schedule)
        finally:
            for worker in self._workers:
                worker.close()

    def _worker(self, index: int) -> Worker:
        return Worker(index, self._job.dataset, self._devices[index % len(self._devices)], self._job.produce)

    def _step(self, schedule: Schedule) -> None:
        ends = {worker.end: worker for worker in self._workers}
        for end in wait(list(ends), TICK):
            worker = ends[end]  # pyright: ignore[reportArgumentType]
            try:
                message = worker.end.recv()
            except (EOFError, OSError):
                self._ended(worker, worker.close(5.0), schedule)
            else:
                self._heard(worker, message, schedule)
        for worker in self._workers:
            if worker.hung:
                self._ended(worker, worker.close(), schedule)
        for worker in list(self._workers):
            if worker.ready and worker.task is None:
                self._give(worker, schedule)

    def _give(self, worker: Worker, schedule: Schedule) -> None:
        task = schedule.take()
        if task is None:
            return
        if task.deaths and worker.used:  # what ended one worker gets its next chance in one that nothing has touched
            worker = self._replace(worker)
        worker.give(task)

    def _heard(self, worker: Worker, message: Message, schedule: Schedule) -> None:
        worker.alive()
        kind, value = message
        if kind == "ready":
            worker.ready, self._false_starts = True, 0
        elif kind != "alive" and worker.task is not None:
            task, worker.task = worker.task, None
            who = {"worker": worker.index, "host": socket.gethostname(), "pid": worker.pid}
            schedule.heard(task, message, who)
            most = self._job.options.memory
            heavy = kind == "done" and most is not None and value["rss"] > most
            if kind == "error" or (heavy and schedule.waiting):  # after an error its process is not to be trusted
                self._replace(worker)

    def _ended(self, worker: Worker, reason: str, schedule: Schedule) -> None:
        """Replace a worker whose process is no more."""
        if worker.task is not None:
            schedule.died(worker.task, reason)
        elif not worker.ready:
            self._false_starts += 1
        if not worker.ready and self._false_starts >= FALSE_STARTS:
            raise SceneWeaverError(f"workers end before they begin ({reason}); set SCENEWEAVER_DEBUG=1 to see why")
        self._replace(worker)

    def _replace(self, worker: Worker) -> Worker:
        worker.close()
        fresh = self._workers[worker.index] = self._worker(worker.index)
        return fresh
