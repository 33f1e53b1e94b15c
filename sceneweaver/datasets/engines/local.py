"""Blocks made by processes of this machine."""

from __future__ import annotations

import socket
import time
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from multiprocessing.connection import wait
from typing import Any

from sceneweaver.scene import MissingDependencyError, SceneWeaverError

from ..disk import LEAST, Wait, waiting
from ..work import Produce
from .manifest import Dataset
from .tasks import Task
from .worker import Message, Worker

TICK = 1.0
"""Seconds between looks at silent workers and at a full disk."""

FALSE_STARTS = 3
"""How many workers may end before they are ready, one after the other."""


@dataclass(frozen=True)
class Listener:
    """Who wants to hear of a run.

    Attributes:
        block: told of each block's record.
        notice: told in one line what else happens.
    """

    block: Callable[[dict[str, Any]], None]
    notice: Callable[[str], None]


class LocalEngine:
    """Workers of this machine, with a block each until all are made.

    Args:
        dataset: what they make.
        devices: where they lay out rooms, in turns.
        workers: how many.
        produce: what makes scenes.
        listener: hears of blocks and troubles.
        memory: resident bytes above which a worker is replaced between two blocks; None: any number.
        patient: wait when the disk is full, or end.
    """

    def __init__(
        self,
        dataset: Dataset,
        devices: Sequence[str],
        workers: int,
        produce: Produce | None,
        listener: Listener,
        *,
        memory: int | None = None,
        patient: bool = True,
    ):
        self._dataset, self._devices, self._count, self._produce = dataset, devices, workers, produce
        self._listener, self._memory, self._patient = listener, memory, patient
        self._tasks: deque[Task] = deque()
        self._workers: list[Worker] = []
        self._pause: Wait | None = None
        self._false_starts = 0
        self._largest = 0  # block so far [bytes]
        self.began = 0.0
        """When it was asked to run [s since 1970]."""

    def run(self, numbers: Iterable[int]) -> None:
        """Make these blocks.

        Raises:
            DiskFullError: the disk is full, and the engine is not patient. MissingDependencyError: of a worker.
            SceneWeaverError: workers do not even begin.
        """
        self.began = time.time()
        self._tasks.extend(Task(number) for number in numbers)
        try:
            for index in range(min(self._count, len(self._tasks))):
                self._workers.append(self._worker(index))
            while self._tasks or any(worker.task for worker in self._workers):
                self._step()
        finally:
            for worker in self._workers:
                worker.close()

    def _worker(self, index: int) -> Worker:
        return Worker(index, self._dataset, self._devices[index % len(self._devices)], self._produce)

    def _step(self) -> None:
        ends = {worker.end: worker for worker in self._workers}
        for end in wait(list(ends), TICK):
            worker = ends[end]  # pyright: ignore[reportArgumentType]
            try:
                message = worker.end.recv()
            except (EOFError, OSError):
                self._ended(worker, worker.close(5.0))
            else:
                self._heard(worker, message)
        for worker in self._workers:
            if worker.hung:
                self._ended(worker, worker.close())
        self._go_on()

    def _go_on(self) -> None:
        if self._pause is not None and self._pause.over:
            self._pause = None
            self._listener.notice("trying again")
        for worker in self._workers:
            if self._tasks and self._pause is None and worker.ready and worker.task is None:
                worker.give(self._tasks.popleft())

    def _heard(self, worker: Worker, message: Message) -> None:
        kind, value = message
        if kind == "ready":
            worker.ready, self._false_starts = True, 0
        elif kind == "room" and worker.task is not None:
            worker.task.room = value
        elif kind == "done":
            self._done(worker, value)
        elif kind == "full":
            self._full(worker)
        elif kind == "missing":
            raise MissingDependencyError(value)
        elif kind == "error":  # what such a process does next is not to be trusted
            worker.close()
            self._ended(worker, value)
            return
        worker.alive()

    def _done(self, worker: Worker, record: dict[str, Any]) -> None:
        worker.task = None
        self._largest = max(self._largest, record["bytes"])
        self._listener.block({**record, "worker": worker.index, "host": socket.gethostname(), "pid": worker.pid})
        if self._memory is not None and record["rss"] > self._memory and self._tasks:
            worker.close()
            self._replace(worker)

    def _full(self, worker: Worker) -> None:
        if worker.task is not None:
            self._tasks.appendleft(worker.task)
            worker.task = None
        if self._pause is None:
            needed = max(LEAST, 2 * self._largest * len(self._workers))
            self._pause = waiting(self._dataset.folder.path, needed, wait=self._patient)
            self._listener.notice(f"{self._pause}; waiting")

    def _ended(self, worker: Worker, reason: str) -> None:
        """Replace a worker whose process is no more; its block is made again."""
        if worker.task is not None:
            self._listener.notice(worker.task.died(reason))
            self._tasks.appendleft(worker.task)
        elif not worker.ready:
            self._false_starts += 1
            if self._false_starts >= FALSE_STARTS:
                raise SceneWeaverError(f"workers end before they begin ({reason}); set SCENEWEAVER_DEBUG=1 to see why")
        self._replace(worker)

    def _replace(self, worker: Worker) -> None:
        self._workers[worker.index] = self._worker(worker.index)
