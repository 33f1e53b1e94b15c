"""Run every method on every problem from every seed, here or in a process that may crash or hang."""

from __future__ import annotations

import itertools
import math
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field, replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from sceneweaver.layout.devices import pick_devices
from sceneweaver.runtime import processes
from sceneweaver.runtime.memory import resident
from sceneweaver.scene import InputError, Scene

from .entries import Method, Task, find_methods, find_tasks
from .execute import Prepared, blank, execute, settle
from .results import Folder, Row
from .settings import Settings

LOOK = 0.5  # [s] between looks at what a process takes


class OutOfTime(Exception):
    """The time of the whole comparison is over; the run that was under way is not one of its results."""


class Worker:
    """A process that runs one method on one problem at a time; a new one takes its place where it had to end.

    Args:
        threads: how many threads its libraries may use; None: as many as here.
        over: asked twice a second whether it is to be killed whatever it does.
    """

    def __init__(self, threads: int | None = None, over: Callable[[], bool] = lambda: False) -> None:
        self._process: processes.Worker | None = None
        self._threads, self._over = threads, over

    def execute(self, method: Method, task: Task, seed: int, settings: Settings) -> Iterator[Row]:
        """Rows as of `execute.execute`; the last one says so where the process was killed or crashed.

        Raises:
            OutOfTime: all has to end now.
        """
        row, limit = blank(method, task, seed, settings), time.monotonic() + settings.limit
        end = self._send((method, task, seed, settings))
        most = math.inf if settings.memory is None else settings.memory * 2**30
        while True:
            if not end.poll(max(min(limit - time.monotonic(), LOOK), 0.0)):
                taken = self._resident()
                if self._over():
                    self.close()
                    raise OutOfTime
                if time.monotonic() < limit and taken <= most:
                    continue
                self.close()
                reason = f"killed after {settings.limit:g} s"
                if taken > most:
                    reason = f"killed at {taken / 2**30:.1f} GiB of memory, {settings.memory:g} are allowed"
                break
            try:
                found = end.recv()
            except (EOFError, ConnectionError):
                reason = f"the process ended by itself, exit code {self.close()}"
                break
            if isinstance(found, bool):
                if not found:
                    self.close()
                return
            row = found
            yield row
        yield replace(row, checkpoint=row.checkpoint + 1, outcome="killed", reason=reason)

    def _send(self, order: tuple[Method, Task, int, Settings]) -> Connection:
        if self._process is None or not self._process.alive:
            self.close()
            self._process = processes.Worker(serve, threads=self._threads)
        self._process.connection.send(order)
        return self._process.connection

    def _resident(self) -> int:
        return resident(self._process.pid) if self._process is not None else 0

    def close(self) -> int | None:
        """End the process; its exit code."""
        process, self._process = self._process, None
        return process.end(1.0) if process is not None else None


def serve(end: Connection) -> None:
    """Do what is asked for until nobody asks any more. Whether the device still works follows the last row of a run."""
    prepared = Prepared()
    while True:
        try:
            method, task, seed, settings = end.recv()
        except EOFError:
            return
        for row in execute(method, task, seed, settings, prepared):
            end.send(row)
        end.send(works(settings.device))


def works(device: str) -> bool:
    """Whether a device still works for this process: an error of CUDA stays for good."""
    try:
        settle(device)
    except Exception:  # Warp and PyTorch raise their own
        return False
    return True


Progress = Callable[[int, int, Row], None]
"""``progress(done, total, last row)``, after every run."""


def run(
    optimizers: Sequence[Any],
    problems: Sequence[str | Scene | Task],
    out: Path | str,
    *,
    seeds: int | Sequence[int] = 3,
    settings: Settings | None = None,
    isolate: bool = False,
    jobs: int = 1,
    until: float = math.inf,
    progress: Progress | None = None,
) -> Path:
    """Compare optimisers; runs that the folder holds already are not made again.

    Args:
        optimizers: see `find_methods`.
        problems: see `find_tasks`.
        out: folder of the results, see `results`.
        seeds: how many, from 0, or which.
        settings: the same for all runs.
        isolate: run in a process of its own, which a hung or crashed optimiser ends alone. Optimisers that are objects
            have to be picklable for that. Without it the limit of a run is not kept.
        jobs: how many processes run side by side; more than one isolates, and the threads of each are its share of the
            cores. Use it with ``clock="cpu"``, which does not see the others.
        until: when all ends, by the monotonic clock [s]: what is under way then is given up, and the rest is left for
            another time.
        progress: told of every run that is done.

    Returns:
        The Parquet file with all runs.

    Raises:
        InputError: a name, or settings other than the folder's. MissingDependencyError: pyarrow or the device.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> sorted(line.method for line in bench.compare(bench.read_runs(path)))
        ['adam', 'langevin']
    """
    settings = settings or Settings()
    devices = pick_devices(settings.device)
    if len(devices) > 1:
        raise InputError(f'device: "{settings.device}" is several; a run has one')
    settings = replace(settings, device=devices[0])
    methods, tasks = find_methods(optimizers), find_tasks(problems)
    numbers = list(range(seeds)) if isinstance(seeds, int) else list(seeds)
    if not numbers:
        raise InputError("seeds: give at least one")
    if jobs < 1:
        raise InputError(f"jobs: {jobs!r} is not at least 1")
    folder = Folder(Path(out), settings)
    order = [(method, task, seed) for task in tasks for method in methods for seed in numbers]
    left = [each for each in order if (each[0].name, each[1].name, each[2]) not in folder.done]
    crew = _Crew(folder, settings, len(order) - len(left), len(order), until, progress)
    try:
        if isolate or jobs > 1 or until < math.inf:
            # What one process does in a row is of one problem: it is compiled once, and its kernels are loaded.
            rows = itertools.groupby(left, lambda each: (each[0].name, each[1].name))
            crew.share([list(group) for _, group in rows], jobs)
        else:
            prepared = Prepared()
            for each in left:
                crew.add(list(execute(*each, settings, prepared)))
    finally:
        path = folder.close()
    return path


@dataclass
class _Crew:
    """Processes that share what is to be run."""

    folder: Folder
    settings: Settings
    done: int
    total: int
    until: float
    progress: Progress | None
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _over: threading.Event = field(default_factory=threading.Event)

    def add(self, rows: list[Row]) -> None:
        """Keep a run that is done."""
        with self._lock:
            self.folder.add(rows)
            self.done += 1
            if self.progress is not None:
                self.progress(self.done, self.total, rows[-1])

    def share(self, groups: list[list[tuple[Method, Task, int]]], jobs: int) -> None:
        """Run all; an error or an interrupt here ends all of them."""
        with ThreadPoolExecutor(jobs) as pool:
            queue = iter(groups)
            waiting = [pool.submit(self._serve, queue, jobs) for _ in range(jobs)]
            try:
                for each in as_completed(waiting):
                    each.result()
            finally:
                self._over.set()

    def _ended(self) -> bool:
        return self._over.is_set() or time.monotonic() >= self.until

    def _serve(self, queue: Iterator[list[tuple[Method, Task, int]]], jobs: int) -> None:
        threads = max(processes.cores() // jobs, 1) if jobs > 1 else None
        worker = Worker(threads, self._ended)
        try:
            while not self._ended():
                with self._lock:
                    group = next(queue, None)
                if group is None:
                    return
                for method, task, seed in group:
                    if self._ended():
                        return
                    self.add(list(worker.execute(method, task, seed, self.settings)))
        except OutOfTime:
            return
        finally:
            worker.close()
