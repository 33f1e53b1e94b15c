"""What a worker is asked to do: a block in one piece, or room by room after it ended a worker."""

from __future__ import annotations

import shutil
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..blocks import read_rows, read_samples, write_block
from ..requests import Request
from ..sample import Sample
from ..spec import Spec
from ..store import AssetStore
from ..work import Produce, failed_samples, make_block, usual
from .manifest import Dataset
from .records import memory

CHANCES = 2
"""How often a room may end its worker before it counts as failed."""

Say = Callable[..., None]
"""``say(kind, value)``: "room", its number, before it is made on its own; "scene", its status, when one is done."""


@dataclass
class Task:
    """A block to make.

    Attributes:
        number: of the block.
        alone: whether its rooms are made one by one.
        deaths: of these rooms, how often each ended its worker.
        failed: why rooms are given up.
        room: the one that is being made, where they are made one by one.
    """

    number: int
    alone: bool = False
    deaths: Counter[int] = field(default_factory=Counter)
    failed: dict[int, str] = field(default_factory=dict)
    room: int | None = None

    def died(self, reason: str) -> str:
        """Take note that the worker of this task ended; what happens now, in words."""
        if not self.alone:
            self.alone = True
            return f"block {self.number}: {reason}; its rooms are made one by one"
        if self.room is None:
            return f"block {self.number}: {reason}; it is made again"
        self.deaths[self.room] += 1
        if self.deaths[self.room] < CHANCES:
            return f"room {self.room}: {reason}; it is made again"
        self.failed[self.room] = reason
        return f"room {self.room}: {reason}; it has failed"

    def patience(self, spec: Spec) -> float:
        """Seconds without a scene after which its worker counts as hung.

        Rooms of a block are laid out together, so its first scene may take longer than any other.
        """
        scenes = spec.rooms.layouts * (1 if self.alone else spec.block)
        return spec.time_limit * (1 + scenes / 8)


def carry_out(dataset: Dataset, task: Task, device: str, produce: Produce | None, say: Say) -> dict[str, Any]:
    """Make the block of a task, unless it is there; its record."""
    start, folder = time.time(), dataset.folder

    produce = produce or usual()

    def watched(spec: Spec, requests: Sequence[Request], store: AssetStore, device: str = "auto") -> Iterator[Sample]:
        for sample in produce(spec, requests, store, device):
            say("scene", sample.status)
            yield sample

    if task.alone:
        _make_alone(dataset, task, device, watched, say)
    else:
        make_block(folder, dataset.requests, task.number, device, watched)
    block = folder.block(task.number)
    counts = Counter(row["status"] for row in read_rows(block))
    rss, peak = memory()
    return {
        "block": task.number,
        "start": start,
        "end": time.time(),
        "rss": rss,
        "peak_rss": peak,
        "bytes": sum(path.stat().st_size for path in block.iterdir()),
        "rooms": len(dataset.requests.block(task.number)),
        **{status: counts[status] for status in ("ok", "rejected", "failed")},
    }


def _make_alone(dataset: Dataset, task: Task, device: str, produce: Produce, say: Say) -> None:
    """Make a block room by room; each is kept as soon as it is there, for the next worker if this one ends."""
    place, block = dataset.folder.rooms(task.number), dataset.folder.block(task.number)
    layouts = dataset.spec.product == "layouts"
    requests = [] if block.exists() else dataset.requests.block(task.number)
    paths = [place / f"{request.room:010d}" for request in requests]
    for request, path in zip(requests, paths, strict=True):
        if path.exists():
            continue
        if layouts:
            _programs_alone(dataset, task, path, request, device, say)
        elif request.room in task.failed:
            write_block(path, failed_samples(request, task.failed[request.room]))
        else:
            say("room", request.room)
            write_block(path, produce(dataset.spec, [request], AssetStore(dataset.folder.path), device))
    if paths and layouts:
        from ..layouts import join

        join(block, dataset.requests, paths)
    elif paths:
        write_block(block, (sample for path in paths for sample in read_samples(path)))
    shutil.rmtree(place, ignore_errors=True)


def _programs_alone(dataset: Dataset, task: Task, path: Path, request: Request, device: str, say: Say) -> None:
    """Make a program of layouts on its own, or say why it has failed."""
    from ..layouts import write_programs

    failed = {room: reason for room, reason in task.failed.items() if room == request.room}
    if not failed:
        say("room", request.room)
    write_programs(path, dataset.requests, [request], device, failed)
