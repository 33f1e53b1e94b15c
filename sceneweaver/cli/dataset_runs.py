"""``sceneweaver dataset make`` and ``resume``: a run, what it says on the way, and how it ends."""

from __future__ import annotations

import json
import os
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from .exit_codes import UNFINISHED
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.datasets.engines import Dataset

QUIET = 30.0
"""Seconds between two lines of progress where there is no terminal."""

STATUSES = ("ok", "rejected", "failed")


@dataclass(frozen=True)
class Run:
    """The options of a run."""

    workers: int | None
    device: str
    shard: tuple[int, int] | None
    engine: str
    address: str | None
    memory: int | None
    patient: bool
    as_json: bool
    time_limit: float | None = None
    full_check: bool = False


def run_make(source: Path, out: Path, run: Run) -> int:
    """Make a data set."""
    with handles() as (stdout, stderr):
        from sceneweaver.datasets.engines import begin

        return _go_on(begin(source, out, run.device), run, stdout, stderr)


def run_resume(path: Path, run: Run) -> int:
    """Go on with a data set."""
    with handles() as (stdout, stderr):
        from sceneweaver.datasets.engines import open_dataset

        return _go_on(open_dataset(path), run, stdout, stderr)


def run_merge(sources: list[Path], out: Path, run: Run) -> int:
    """Join data sets, and go on with what they are together."""
    with handles() as (stdout, stderr):
        from sceneweaver.datasets.engines import merge

        return _go_on(merge(sources, out), run, stdout, stderr)


def _go_on(dataset: Dataset, run: Run, stdout: IO[str], stderr: IO[str]) -> int:
    from sceneweaver.datasets.engines import Listener, Options, missing, resume

    path, begun = dataset.folder.path, time.monotonic()
    progress = Progress(stdout if run.as_json else None, stderr, dataset.spec.product)
    options = Options(
        run.workers,
        run.device,
        run.shard,
        run.engine,
        run.address,
        run.memory,
        run.patient,
        run.time_limit,
        run.full_check,
    )
    try:
        whole = resume(dataset, options, Listener(progress.block, progress.notice, progress.begun))
    except (KeyboardInterrupt, SystemExit):
        progress.notice(f"stopped; nothing is lost; go on with: sceneweaver dataset resume {path}")
        raise
    finally:
        progress.close()
    seconds = time.monotonic() - begun
    over = not whole and (run.shard is None or bool(missing(dataset, run.shard)))
    if run.as_json:
        facts = {
            "folder": str(path),
            "whole": whole,
            "blocks": progress.blocks,
            **progress.counts,
            "seconds": round(seconds, 3),
        }
        print(json.dumps(facts), file=stdout)
        return UNFINISHED if over else 0
    scenes = ", ".join(f"{progress.counts[status]} {status}" for status in STATUSES)
    print(f"{path}: {progress.blocks} blocks in {seconds:.1f} s: {scenes}", file=stdout)
    if over:
        print(f"the time is over; go on with: sceneweaver dataset resume {path}", file=stdout)
    elif not whole:
        print(f"when all shards are made: sceneweaver dataset resume {path}", file=stdout)
    return UNFINISHED if over else 0


class Progress:
    """What a run says: a line of JSON a block, a line on a terminal that moves, or a line now and then.

    Args:
        lines: where lines of JSON go; None: there are none.
        stderr: where the others go.
        product: what is made. A home takes so long that each block of homes has a line.
    """

    def __init__(self, lines: IO[str] | None, stderr: IO[str], product: str = "scenes"):
        self.blocks, self._lines, self._stderr = 0, lines, stderr
        self._begun = self._said = time.monotonic()
        self._moving = lines is None and stderr.isatty()
        self._done = 0
        self._noun, self._quiet = product, 0.0 if product == "homes" else QUIET
        self.counts: Counter[str] = Counter({status: 0 for status in STATUSES})

    def block(self, record: dict[str, Any]) -> None:
        """Hear of a block."""
        self._done += 1
        self.counts.update({status: record[status] for status in STATUSES})
        if self._lines is not None:
            print(json.dumps({**record, "done": self._done, "of": self.blocks}), file=self._lines, flush=True)
        elif self._moving:
            self._stderr.write(f"\r\x1b[K{self._line()}")
            self._stderr.flush()
        elif time.monotonic() - self._said >= self._quiet:
            self._said = time.monotonic()
            print(self._line(), file=self._stderr, flush=True)

    def begun(self, count: int) -> None:
        """Hear how many blocks are made next."""
        self.blocks += count

    def notice(self, text: str) -> None:
        """Say something in a line of its own."""
        print(f"{self._erase()}sceneweaver: {text}", file=self._stderr, flush=True)

    def close(self) -> None:
        """Take the moving line away."""
        self._stderr.write(self._erase())
        self._stderr.flush()

    def _erase(self) -> str:
        return "\r\x1b[K" if self._moving else ""

    def _line(self) -> str:
        seconds = time.monotonic() - self._begun
        left = seconds / self._done * (self.blocks - self._done)
        troubles = self.counts["rejected"] + self.counts["failed"]
        rate = self.counts.total() / seconds
        return (
            f"{self._done}/{self.blocks} blocks, {self.counts.total()} {self._noun}, {rate:.2f} a second, "
            f"{troubles} not delivered, {duration(left)} left"
        )


def duration(seconds: float) -> str:
    """A time for people."""
    hours, minutes = divmod(round(seconds) // 60, 60)
    return f"{hours} h {minutes:02d} min" if hours else f"{minutes} min {round(seconds) % 60:02d} s"


@contextmanager
def handles() -> Iterator[tuple[IO[str], IO[str]]]:
    """Handles of stdout and stderr of our own: `no_chatter` takes the usual ones away."""
    sys.stdout.flush()
    with (
        open(os.dup(1), "w", encoding="utf-8") as stdout,
        open(os.dup(2), "w", encoding="utf-8") as stderr,
        no_chatter(),
    ):
        yield stdout, stderr
