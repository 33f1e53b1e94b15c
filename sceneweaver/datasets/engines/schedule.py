"""What workers are asked to do, and in which order: troubles of a worker or a disk never change the outcome."""

from __future__ import annotations

import json
import math
import os
import socket
import time
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Literal

from sceneweaver.io import InputError, MissingDependencyError, open_writable
from sceneweaver.runtime.memory import memory

from ..folder import LEAST, Folder, Wait, disk_full, waiting
from ..requests import Request
from ..samples import Sample, read_rows
from ..seals import open_own, opened_row, sealed_row
from ..spec import Spec
from ..store import AssetStore
from ..work import Produce, join_rooms, make_block, make_rooms, usual
from .manifest import Dataset

Message = tuple[Literal["ready", "alive", "done", "full", "missing", "error"], Any]
"""What a worker says: it is ready or alive; its task is done, with a record; the disk is full; something that it needs
is missing, or another error, in words."""


@dataclass
class Task:
    """A piece of work.

    Attributes:
        number: of the block.
        room: the one room to make, by its place in the block; None: all.
        join: whether to join the rooms of the block, which are made.
        failed: of rooms that are given up, by their place in the block, why.
        deaths: how often it ended its worker.
    """

    number: int
    room: int | None = None
    join: bool = False
    failed: dict[int, str] = field(default_factory=dict)
    deaths: int = 0

    def patience(self, spec: Spec) -> float:
        """Seconds without a scene after which its worker counts as hung.

        Rooms of a block are laid out together, so its first scene may take longer than any other.
        """
        scenes = spec.rooms.layouts * (spec.block if self.room is None else 1)
        return spec.time_limit * (1 + scenes / 8)


def attempt(dataset: Dataset, task: Task, device: str, produce: Produce | None, alive: Callable[[], None]) -> Message:
    """Carry out a task; how it went.

    Args:
        dataset: what it is a part of.
        task: what to do.
        device: where rooms are laid out.
        produce: what makes scenes, if not `produce`.
        alive: called after each scene.
    """
    try:
        return "done", _carry_out(dataset, task, device, produce, alive)
    except Exception as error:
        if disk_full(error):
            return "full", None
        if isinstance(error, MissingDependencyError):
            return "missing", str(error)
        return "error", f"{type(error).__name__}: {' '.join(str(error).split())[:300]}"


def _carry_out(
    dataset: Dataset, task: Task, device: str, produce: Produce | None, alive: Callable[[], None]
) -> dict[str, Any]:
    start, folder, whole = time.time(), dataset.folder, dataset.folder.block(task.number)

    def watched(spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "auto") -> Iterator[Sample]:
        for sample in (produce or usual(spec))(spec, requests, store, device):
            alive()
            yield sample

    if task.join:
        join_rooms(folder, dataset.requests, task.number, task.failed)
    elif task.room is None:
        make_block(folder, dataset.requests, task.number, device, watched)
    elif not whole.exists():
        request = dataset.requests.block(task.number)[task.room]
        make_rooms(folder, dataset.requests, folder.room(task.number, task.room), [request], device, watched)
    rss, peak = memory()
    record = {"block": task.number, "start": start, "end": time.time(), "rss": rss, "peak_rss": peak}
    if not whole.exists():  # a room alone is no news yet
        return record
    counts = Counter(row["status"] for row in read_rows(whole))
    return record | {
        "bytes": sum(path.stat().st_size for path in whole.iterdir()),
        "rooms": len(dataset.requests.block(task.number)),
        **{status: counts[status] for status in ("ok", "rejected", "failed")},
    }


class Records:
    """The file that a run adds its records to."""

    def __init__(self, folder: Folder):
        self._path = folder.records / f"{socket.gethostname()}-{os.getpid()}.jsonl"

    def add(self, record: dict[str, Any]) -> None:
        """Write one record; without room on the disk it is lost, as nothing depends on it."""
        with suppress(OSError):
            self._path.parent.mkdir(parents=True, exist_ok=True)
            with open_writable(self._path, "ab") as file:
                file.write((json.dumps(sealed_row(record)) + "\n").encode())


def read_records(folder: Folder) -> list[dict[str, Any]]:
    """The records of all runs of a data set, in order of their end.

    Each has ``block``, ``start`` and ``end`` [s since 1970], ``worker``, ``host``, ``pid``, ``rss`` and ``peak_rss``
    [bytes], ``bytes`` (of the block), ``rooms``, and how many scenes were ``ok``, ``rejected`` and ``failed``.
    """
    found = []
    for path in sorted(folder.records.glob("*.jsonl")):
        with suppress(InputError), open_own(path) as file:
            rows = filter(None, map(opened_row, file))  # the last line of a run that was killed may be torn
            found += [row for row in rows if isinstance(row.get("end"), float)]
    return sorted(found, key=lambda record: record["end"])


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
        begun: told how many blocks are made next.
    """

    block: Callable[[dict[str, Any]], None]
    notice: Callable[[str], None]
    begun: Callable[[int], None] = lambda count: None


@dataclass(frozen=True)
class Options:
    """How a run works. What comes out depends on none of it.

    Attributes:
        workers: processes; None: one for each core.
        device: where rooms are laid out: auto, cpu, cuda, cuda:k, or cuda:all for all GPUs in turns.
        shard: (i, N) makes the blocks i, i + N, i + 2 N ... only, and does not pack them.
        engine: "local" for processes of this machine, "ray" for a cluster.
        address: of the cluster; None: one of this machine.
        memory: resident bytes above which a worker is replaced between two blocks.
        patient: wait when the disk is full, or end.
        time_limit: seconds after which a run ends with whole blocks and leaves the rest to another; None: none.
        full_check: whether all files of a data set that is whole are read; else there is a look at their sizes only.
    """

    workers: int | None = None
    device: str = "auto"
    shard: tuple[int, int] | None = None
    engine: str = "local"
    address: str | None = None
    memory: int | None = None
    patient: bool = True
    time_limit: float | None = None
    full_check: bool = False


@dataclass(frozen=True)
class Job:
    """What an engine is asked for.

    Attributes:
        dataset: what it makes.
        listener: hears of blocks and troubles.
        options: how to work.
        produce: what makes scenes, if not `produce`.
        until: when to end at the latest, by `time.monotonic` [s]; nothing begins that would not be made by then.
    """

    dataset: Dataset
    listener: Listener
    options: Options = Options()
    produce: Produce | None = None
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
        """How many tasks are not taken."""
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
            DiskFullError: the disk is full, and the job is not patient.
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
            self._pause = waiting(self._dataset.folder.path, needed, wait=self._job.options.patient)
            self._listener.notice(f"{self._pause}; waiting")
