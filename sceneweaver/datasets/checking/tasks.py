"""Work that checks a data set piece by piece, in this process or in others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from sceneweaver.runtime.processes import pool
from sceneweaver.scene import InputError

from ..reading import Span, scenes_of
from .findings import Findings
from .scene import Judge, content_of
from .tables import check_digests


class Task(Protocol):
    """Some work; it can be sent to another process."""

    def run(self) -> Findings:
        """Do it."""
        ...


@dataclass(frozen=True)
class Digests:
    """Files whose SHA-256 is known to begin with something."""

    root: Path
    files: tuple[tuple[Path, str], ...]

    def run(self) -> Findings:
        """Hash them."""
        found = Findings()
        check_digests(self.root, self.files, found)
        return found


@dataclass(frozen=True)
class Scenes:
    """Scenes of a shard.

    Attributes:
        judge: how they are judged.
        span: where they lie.
        rows: their rows, by key; scenes without one are passed over.
        judged: keys of those that are judged; of the others only the content is hashed.
        simulated: keys of those that are compiled by MuJoCo, and how long they are let loose [s].
    """

    judge: Judge
    span: Span
    rows: dict[str, dict[str, Any]]
    judged: frozenset[str]
    simulated: dict[str, float]

    def run(self) -> Findings:
        """Judge them."""
        found = Findings()
        try:
            for key, files in scenes_of(self.span):
                if (row := self.rows.get(key)) is None:
                    continue
                digest, size = content_of(files)
                if (digest, size) != (row["content_hash"], row["bytes"]):
                    found.fault("content", key, "is not what was delivered: its content hash differs from the index")
                if key in self.judged:
                    self.judge.judge(row, files, found)
                if key in self.simulated and "xml" in files:
                    self.judge.simulate(key, files["xml"], self.simulated[key], found)
        except (OSError, EOFError, InputError) as error:
            found.fault("shard", self.span.path.name, f"cannot be read: {error}")
        return found


def results(tasks: Iterable[Task], workers: int) -> Iterator[Findings]:
    """What tasks find, as they end; no more than two a worker wait at a time.

    Raises:
        InputError: a process was killed, as where memory runs out.
    """
    if workers <= 1:
        yield from (task.run() for task in tasks)
        return
    try:
        yield from _shared_out(tasks, workers)
    except BrokenProcessPool:
        raise InputError("a process that judges was killed; is there memory for so many? use fewer --workers") from None


def _shared_out(tasks: Iterable[Task], workers: int) -> Iterator[Findings]:
    with pool(workers) as processes:
        waiting: set[Future[Findings]] = set()
        for task in tasks:
            waiting.add(processes.submit(task.run))
            if len(waiting) >= 2 * workers:
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                yield from (future.result() for future in done)
        while waiting:
            done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            yield from (future.result() for future in done)
