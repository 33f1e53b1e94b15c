"""Run every method on every problem from every seed, here or in processes that may crash or hang."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from sceneweaver.layout.devices import pick_devices
from sceneweaver.runtime import processes
from sceneweaver.scene import InputError, Scene

from .entries import Method, Task, find_methods, find_tasks
from .execute import Prepared, execute
from .results import Folder, Row
from .settings import Settings
from .worker import OutOfTime, Worker

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
            cores. Use it with ``clock="cpu"``, which does not see the others; on GPUs each has one of its own.
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
    if jobs < 1:
        raise InputError(f"jobs: {jobs!r} is not at least 1")
    devices = devices_of(settings.device, jobs)
    settings = replace(settings, device=devices[0])
    methods, tasks = find_methods(optimizers), find_tasks(problems)
    numbers = list(range(seeds)) if isinstance(seeds, int) else list(seeds)
    if not numbers:
        raise InputError("seeds: give at least one")
    folder = Folder(Path(out), settings)
    order = [(method, task, seed) for task in tasks for method in methods for seed in numbers]
    left = [each for each in order if (each[0].name, each[1].name, each[2]) not in folder.done]
    crew = _Crew(folder, settings, len(order) - len(left), len(order), until, progress)
    try:
        if isolate or jobs > 1 or until < math.inf:
            crew.share(Queue(left), devices)
        else:
            prepared = Prepared(most=1)
            for each in left:
                crew.add(list(execute(*each, settings, prepared)))
    finally:
        path = folder.close()
    return path


def devices_of(name: str, jobs: int) -> list[str]:
    """The device of each of so many workers: the CPU for all, or GPUs from the first on, one for each.

    Raises:
        InputError: more workers than GPUs, or a device named by number for several.
    """
    found = pick_devices("cuda:all" if name == "cuda" else name)
    if found == ["cpu"]:
        return found * jobs
    if jobs > len(found):
        raise InputError(f'jobs: {jobs} do not fit on {", ".join(found)}; a GPU has one worker, give device "cuda"')
    return found[:jobs]


@dataclass
class Queue:
    """What is left to run. A worker stays with a problem that it has begun, as long as there is one to each.

    All runs of a seed come before those of the next, so that what was interrupted is whole for some seeds.
    """

    left: list[tuple[Method, Task, int]]
    owners: dict[str, int] = field(default_factory=dict)  # the worker that began with a problem
    now: dict[int, str] = field(default_factory=dict)  # what each worker is at

    def __post_init__(self) -> None:
        self._rows: dict[int, dict[str, list[tuple[Method, Task, int]]]] = {}
        for each in reversed(self.left):
            self._rows.setdefault(each[2], {}).setdefault(each[1].name, []).append(each)
        self._seeds = sorted(self._rows)
        self._places = {name: k for k, name in enumerate(dict.fromkeys(each[1].name for each in self.left))}

    def take(self, worker: int) -> tuple[Method, Task, int] | None:
        """The next run of a worker; None: all were taken."""
        while self._seeds and not self._rows[self._seeds[0]]:
            self._seeds.pop(0)
        if not self._seeds:
            return None
        rows = self._rows[self._seeds[0]]

        def rank(name: str) -> tuple[int, int]:
            if name == self.now.get(worker):
                return 0, 0
            owner = self.owners.get(name)
            if owner in (worker, None):
                return (1 if owner == worker else 2), self._places[name]
            return 3, -len(rows[name])

        name = min(rows, key=rank)
        self.owners.setdefault(name, worker)
        self.now[worker] = name
        found = rows[name].pop()
        if not rows[name]:
            del rows[name]
        return found


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

    def share(self, queue: Queue, devices: Sequence[str]) -> None:
        """Run all, a worker on each device; an error or an interrupt here ends all of them."""
        with ThreadPoolExecutor(len(devices)) as pool:
            waiting = [pool.submit(self._serve, queue, k, device, len(devices)) for k, device in enumerate(devices)]
            try:
                for each in as_completed(waiting):
                    each.result()
            finally:
                self._over.set()

    def _ended(self) -> bool:
        return self._over.is_set() or time.monotonic() >= self.until

    def _serve(self, queue: Queue, k: int, device: str, jobs: int) -> None:
        threads = max(processes.cores() // jobs, 1) if jobs > 1 else None
        worker, settings = Worker(threads, self._ended), replace(self.settings, device=device)
        try:
            while not self._ended():
                with self._lock:
                    each = queue.take(k)
                if each is None:
                    return
                self.add(list(worker.execute(*each, settings)))
        except OutOfTime:
            return
        finally:
            worker.close()
