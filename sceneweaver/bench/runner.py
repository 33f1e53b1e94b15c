"""Run every method on every problem from every seed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from sceneweaver.layout.devices import pick_devices
from sceneweaver.scene import InputError, Scene

from .execute import Prepared, execute
from .methods import find_methods
from .results import Folder
from .schema import Row
from .settings import Settings
from .tasks import Task, find_tasks
from .worker import Worker

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
