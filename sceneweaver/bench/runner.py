"""Run every method on every problem from every seed, here or in a process that may crash or hang."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from sceneweaver.layout.devices import pick_devices
from sceneweaver.runtime import processes
from sceneweaver.scene import InputError, Scene

from .entries import Method, Task, find_methods, find_tasks
from .execute import Prepared, blank, execute, settle
from .results import Folder, Row
from .settings import Settings


class Worker:
    """A process that runs one method on one problem at a time; a new one takes its place where it had to end."""

    def __init__(self) -> None:
        self._process: processes.Worker | None = None

    def execute(self, method: Method, task: Task, seed: int, settings: Settings) -> Iterator[Row]:
        """Rows as of `execute.execute`; the last one says so where the process was killed or crashed."""
        row, limit = blank(method, task, seed, settings), time.monotonic() + settings.limit
        end = self._send((method, task, seed, settings))
        while True:
            if not end.poll(max(limit - time.monotonic(), 0.0)):
                self.close()
                reason = f"killed after {settings.limit:g} s"
                break
            try:
                found = end.recv()
            except EOFError:
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
            self._process = processes.Worker(serve, threads=None)
        self._process.connection.send(order)
        return self._process.connection

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
    folder, prepared, worker = Folder(Path(out), settings), Prepared(), Worker()
    order = [(method, task, seed) for task in tasks for method in methods for seed in numbers]
    try:
        for done, (method, task, seed) in enumerate(order, 1):
            if (method.name, task.name, seed) in folder.done:
                continue
            rows = list(
                worker.execute(method, task, seed, settings)
                if isolate
                else execute(method, task, seed, settings, prepared)
            )
            folder.add(rows)
            if progress is not None:
                progress(done, len(order), rows[-1])
    finally:
        worker.close()
        path = folder.close()
    return path
