"""What a worker is asked to do: a block; or one room of a block that ended its worker; at last, to join the rooms."""

from __future__ import annotations

import json
import os
import resource
import socket
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from sceneweaver.scene import MissingDependencyError

from ..folder import Folder, disk_full
from ..requests import Request
from ..samples import Sample, read_rows
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
        for sample in (produce or usual())(spec, requests, store, device):
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
            with open(self._path, "a", encoding="utf-8") as file:
                file.write(json.dumps(record) + "\n")


def read_records(folder: Folder) -> list[dict[str, Any]]:
    """The records of all runs of a data set, in order of their end.

    Each has ``block``, ``start`` and ``end`` [s since 1970], ``worker``, ``host``, ``pid``, ``rss`` and ``peak_rss``
    [bytes], ``bytes`` (of the block), ``rooms``, and how many scenes were ``ok``, ``rejected`` and ``failed``.
    """
    found = []
    for path in sorted(folder.records.glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
            with suppress(ValueError):  # the last line of a run that was killed may be torn
                found.append(json.loads(line))
    return sorted(found, key=lambda record: record["end"])


def memory() -> tuple[int, int]:
    """Resident memory of this process now and at its peak [bytes]."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return peak, peak
    return pages * resource.getpagesize(), peak
