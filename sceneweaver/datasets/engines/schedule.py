"""What is to be made next, whoever makes it: troubles of a worker or a disk change the order, never the outcome."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from sceneweaver.scene import MissingDependencyError

from ..folder import LEAST, Wait, waiting
from ..work import Produce
from .manifest import Dataset
from .tasks import Message, Task

CHANCES = 2
"""How often a room may end its worker before it counts as failed."""

RECENT = 64
"""Of how many blocks made last the longest says how long the next may take."""


@dataclass(frozen=True)
class Listener:
    """Who wants to hear of a run.

    Attributes:
        block: told of each block's record.
        notice: told in one line what else happens.
    """

    block: Callable[[dict[str, Any]], None]
    notice: Callable[[str], None]


@dataclass(frozen=True)
class Job:
    """What an engine is asked for.

    Attributes:
        dataset: what it makes.
        listener: hears of blocks and troubles.
        workers: how many tasks at a time; of a cluster None: one for each of its cores.
        produce: what makes scenes, if not `produce`.
        memory: resident bytes above which a worker is replaced between two tasks; None: any number.
        patient: wait when the disk is full, or end.
        until: when to end at the latest, by `time.monotonic` [s]; nothing begins that would not be made by then.
    """

    dataset: Dataset
    listener: Listener
    workers: int | None = None
    produce: Produce | None = None
    memory: int | None = None
    patient: bool = True
    until: float = math.inf


@dataclass
class _Apart:
    """A block whose rooms are made one by one: how many are left, and why others are given up."""

    left: int
    failed: dict[int, str]


class Schedule:
    """The tasks of a run.

    Args:
        job: what is asked for.
        numbers: the blocks that the data set lacks.
        workers: how many there are, for the room on the disk that they need.
    """

    def __init__(self, job: Job, numbers: Iterable[int], workers: int):
        self._dataset, self._listener, self._job = job.dataset, job.listener, job
        self._tasks = deque(Task(number) for number in numbers)
        self._apart: dict[int, _Apart] = {}
        self._taken = 0
        self._pause: Wait | None = None
        self._workers, self._largest = workers, 0
        self._seconds: deque[float] = deque(maxlen=RECENT)

    @property
    def over(self) -> bool:
        """Whether all is made, or the time is over: what is in hand then is dropped."""
        if time.monotonic() >= self._job.until:
            return True
        return not self._taken and (not self._tasks or self._late)

    @property
    def _late(self) -> bool:
        """Whether a block that begins now would not be made in time."""
        return time.monotonic() + max(self._seconds, default=0.0) > self._job.until

    @property
    def waiting(self) -> int:
        """How many tasks nobody works at."""
        return len(self._tasks)

    def take(self) -> Task | None:
        """The next task; None when there is none now, or no time for it."""
        if self._pause is not None and self._pause.over:
            self._pause = None
            self._listener.notice("trying again")
        if self._pause is not None or not self._tasks or self._late:
            return None
        self._taken += 1
        return self._tasks.popleft()

    def heard(self, task: Task, message: Message, who: dict[str, Any]) -> None:
        """Take note of how a task ended.

        Args:
            task: it.
            message: "done", "full", "missing" or "error".
            who: of the worker, for the record.

        Raises:
            MissingDependencyError: a worker lacks something that all lack.
            DiskFullError: the disk is full, and nobody wants to wait.
        """
        kind, value = message
        if kind == "missing":
            raise MissingDependencyError(value)
        if kind == "error":
            self.died(task, value)
            return
        self._taken -= 1
        if kind == "full":
            self._tasks.appendleft(task)
            self._wait()
        elif task.room is not None:
            self._room_over(task)
        else:
            self._largest = max(self._largest, value["bytes"])
            self._seconds.append(value["end"] - value["start"])
            self._listener.block({**value, **who})

    def died(self, task: Task, reason: str) -> None:
        """Take note that a task ended its worker: its block is made room by room, its room again, or given up."""
        self._taken -= 1
        task.deaths += 1
        if task.join:
            self._tasks.appendleft(task)
        elif task.room is None:
            self._listener.notice(f"block {task.number}: {reason}; its rooms are made one by one")
            rooms = len(self._dataset.requests.block(task.number))
            self._apart[task.number] = _Apart(rooms, {})
            self._tasks.extendleft(Task(task.number, room) for room in reversed(range(rooms)))
        elif task.deaths < CHANCES:
            self._listener.notice(f"{self._name(task)}: {reason}; it is made again")
            self._tasks.appendleft(task)
        else:
            self._listener.notice(f"{self._name(task)}: {reason}; it has failed")
            self._apart[task.number].failed[task.room] = reason
            self._room_over(task)

    def _room_over(self, task: Task) -> None:
        apart = self._apart[task.number]
        apart.left -= 1
        if not apart.left:
            self._tasks.appendleft(Task(task.number, join=True, failed=apart.failed))
            del self._apart[task.number]

    def _name(self, task: Task) -> str:
        return f"room {self._dataset.requests.block(task.number)[task.room or 0].room}"

    def _wait(self) -> None:
        if self._pause is None:
            needed = max(LEAST, 2 * self._largest * self._workers)
            self._pause = waiting(self._dataset.folder.path, needed, wait=self._job.patient)
            self._listener.notice(f"{self._pause}; waiting")
