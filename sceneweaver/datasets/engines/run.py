"""A run: from a data set that is begun to one that is whole, wherever it was interrupted."""

from __future__ import annotations

import math
import random
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

from sceneweaver.io import TEMPORARY, locked, sweep, write_atomic
from sceneweaver.scene import InputError

from .. import work
from ..folder import Folder, disk_full, waiting
from .local import TICK, LocalEngine
from .manifest import Dataset, agreed_device, devices
from .schedule import Job, Listener, Options, Records

ONLY_MAKING = ("rooms", "journal")
"""What lies in ``work/`` and is of no use once all blocks are made: gigabytes, where there are many scenes."""

Pack = Callable[[Dataset], None]
"""What makes the files of a data set of its blocks; killed at any moment, it goes on when called again."""


def resume(
    dataset: Dataset,
    options: Options,
    listener: Listener,
    *,
    produce: work.Produce | None = None,
    pack: Pack | None = None,
) -> bool:
    """Make what a data set still lacks.

    Args:
        dataset: from `begin` or `open_dataset`.
        options: how to work.
        listener: hears of blocks and troubles.
        produce: what makes scenes, if not `produce`; a function that can be pickled.
        pack: makes the files of a data set of its blocks, if not `pack`.

    Returns:
        Whether it is whole now.

    Raises:
        InputError: another run is at work there, or the device is of another kind.
        DiskFullError: the disk is full, and the run is not patient.
    """
    if whole(dataset):
        return True
    until = math.inf if options.time_limit is None else time.monotonic() + options.time_limit
    device = agreed_device(dataset, options.device)
    with run_lock(dataset.folder, options.shard):
        clean(dataset)
        try:
            if not dataset.folder.complete.exists():
                _make(dataset, options, device, listener, produce, until)
            clean(dataset)  # before what is there is counted
            complete = dataset.folder.complete.exists()
            if options.shard is not None:
                return complete
            if time.monotonic() >= until or (not complete and missing(dataset)):
                return False
            finish(dataset, pack, listener, patient=options.patient)
        finally:  # also of processes that were still dying when this run began
            clean(dataset)
    return True


def _make(
    dataset: Dataset,
    options: Options,
    device: str,
    listener: Listener,
    produce: work.Produce | None,
    until: float,
) -> None:
    numbers = missing(dataset, options.shard)
    if not numbers:
        return
    records = Records(dataset.folder)

    def block(record: dict[str, Any]) -> None:
        records.add(record)
        listener.block(record)

    told = Listener(block, listener.notice)
    job = Job(dataset, told, options, produce, until)
    if options.engine == "ray":
        from .cluster import RayEngine

        engine = RayEngine(job)
    else:
        engine = LocalEngine(job, devices(device, dataset.spec))
    engine.run(numbers)


def whole(dataset: Dataset) -> bool:
    """Whether nothing is left to do."""
    return dataset.folder.packed.exists() or dataset.folder.checksums.exists()


def missing(dataset: Dataset, shard: tuple[int, int] | None = None) -> list[int]:
    """The blocks of a data set, or of a shard of the work, that are not made yet."""
    first, step = shard or (0, 1)
    return [n for n in range(first, dataset.requests.blocks, step) if not dataset.folder.block(n).exists()]


def finish(dataset: Dataset, pack: Pack | None, listener: Listener, *, patient: bool) -> None:
    """Pack the blocks of a data set that has them all."""
    while True:
        try:
            if not dataset.folder.complete.exists():
                for name in ONLY_MAKING:
                    shutil.rmtree(dataset.folder.work / name, ignore_errors=True)
                write_atomic(dataset.folder.complete, "")
            (pack or _pack)(dataset)
            write_atomic(dataset.folder.packed, "")
            return
        except (OSError, InputError) as error:
            if not disk_full(error):
                raise
        pause = waiting(dataset.folder.path, wait=patient)
        listener.notice(f"{pause}; waiting")
        while not pause.over:
            time.sleep(TICK)


def _pack(dataset: Dataset) -> None:
    work.pack(dataset.folder, dataset.requests)


def clean(dataset: Dataset) -> None:
    """Remove what killed processes have left half-written."""
    folder = dataset.folder
    for place in (folder.path, folder.work, *_folders(folder.blocks), *_folders(folder.assets)):
        sweep(place)


def _folders(path: Path) -> Iterator[Path]:
    yield path
    with suppress(FileNotFoundError):
        yield from (place for place in path.iterdir() if place.is_dir())


PATIENCE = 5.0
"""Seconds that a shard waits for others which look, as it does, whether a whole run is at work."""


@contextmanager
def run_lock(folder: Folder, shard: tuple[int, int] | None) -> Iterator[None]:
    """Keep other runs out while the block goes on; runs of other shards may work beside one of a shard.

    Raises:
        InputError: another run is at work, with its process number.
    """
    what, shards = f"--out: {folder.path}", folder.work / "shards"
    with ExitStack() as held:
        if shard is None:
            held.enter_context(locked(folder.manifest, what))
            for lock in shards.glob(f"{TEMPORARY}*.lock"):
                with locked(shards / lock.name.removeprefix(TEMPORARY).removesuffix(".lock"), what):
                    pass
        else:
            shards.mkdir(parents=True, exist_ok=True)
            held.enter_context(locked(shards / f"{shard[0]}-of-{shard[1]}", f"{what}, shard {shard[0]}/{shard[1]}"))
            _require_no_whole_run(folder.manifest, what)
        yield


def _require_no_whole_run(manifest: Path, what: str) -> None:
    until = time.monotonic() + PATIENCE
    while True:
        try:
            with locked(manifest, what):
                return
        except InputError:
            if time.monotonic() > until:
                raise
        time.sleep(random.uniform(0.02, 0.2))
