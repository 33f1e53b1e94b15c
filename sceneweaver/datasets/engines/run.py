"""A run: from a data set that is begun to one that is whole, wherever it was interrupted."""

from __future__ import annotations

import math
import os
import random
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

from sceneweaver.io import TEMPORARY, locked, reason, require_no_link, require_unlocked, sweep, write_atomic
from sceneweaver.scene import InputError

from .. import work
from ..files import packing_began
from ..folder import Folder, disk_full, waiting
from ..seals import DamagedError, read_seal, remove
from .local import TICK, LocalEngine
from .manifest import Dataset, agreed_device, begun_with, devices, input_faults, require_inputs
from .mending import NAMED, lost, mend, missing, reopen, seal_whole
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
        InputError: another run is at work there, the device is of another kind, or what the data set was begun with is
            not there any more.
        DamagedError: what is damaged cannot be made anew.
        DiskFullError: the disk is full, and the run is not patient.
    """
    folder, notice = dataset.folder, listener.notice
    if _untouched(dataset, full=options.full_check):
        return True
    until = math.inf if options.time_limit is None else time.monotonic() + options.time_limit
    device = agreed_device(dataset, options.device)
    with run_lock(folder, options.shard):
        clean(dataset)
        require_inputs(dataset, notice)
        if whole(dataset) and _holds(dataset, notice, full=options.full_check):
            return True
        try:
            mend(dataset, notice, full=options.shard is None)
            for _ in range(ROUNDS):
                numbers = missing(dataset, options.shard)
                if numbers:
                    _require_made_here(dataset, numbers)
                    if packing_began(folder):
                        notice(f"blocks made again, as what was packed of them is gone: {_listed(numbers)}")
                    listener.begun(len(numbers))
                    _make(dataset, numbers, options, device, listener, produce, until)
                    clean(dataset)  # before what is there is counted
                if options.shard is not None:
                    return folder.complete.exists()
                if time.monotonic() >= until or (numbers and missing(dataset)):
                    return False
                if not mend(dataset, notice):
                    finish(dataset, pack, listener, patient=options.patient)
                    return True
        finally:  # also of processes that were still dying when this run began
            clean(dataset)
    raise DamagedError(f"{folder.path}: what is made anew is damaged each time; check the disk, then resume")


ROUNDS = 5
"""How often a run makes anew what was damaged before it gives up."""


def _untouched(dataset: Dataset, *, full: bool) -> bool:
    """Whether a data set is whole, by its seals, which nothing is written for."""
    begun = begun_with(dataset.folder)
    try:
        read_seal(dataset.folder.packed)
    except DamagedError:
        return False
    if begun is None:
        return False
    return not any(input_faults(dataset, begun)) and not lost(dataset, full=full)


def _holds(dataset: Dataset, notice: Callable[[str], None], *, full: bool) -> bool:
    """Whether all files of a data set that was whole are as they were; what is not is to be made anew then."""
    damaged = lost(dataset, full=full)
    if damaged:
        reopen(dataset, damaged, notice)
        return False
    path = dataset.folder.packed
    try:
        read_seal(path)
    except DamagedError as error:
        notice(f"{path.relative_to(dataset.folder.path)}: {reason(error).partition(': ')[2]}; it is written again")
    remove(path)
    seal_whole(dataset.folder)
    remove(dataset.folder.plan)
    return True


def _listed(numbers: list[int]) -> str:
    more = f" and {len(numbers) - NAMED} more" if len(numbers) > NAMED else ""
    return ", ".join(map(str, numbers[:NAMED])) + more


def _require_made_here(dataset: Dataset, numbers: list[int]) -> None:
    if os.path.lexists(dataset.folder.joined):
        raise InputError(
            f"{dataset.folder.path}: block {numbers[0]} is missing or damaged, and was joined of other data sets; "
            "merge them again, then resume"
        )


def _make(
    dataset: Dataset,
    numbers: list[int],
    options: Options,
    device: str,
    listener: Listener,
    produce: work.Produce | None,
    until: float,
) -> None:
    records = Records(dataset.folder)

    def block(record: dict[str, Any]) -> None:
        records.add(record)
        listener.block(record)

    told = Listener(block, listener.notice, listener.begun)
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


def finish(dataset: Dataset, pack: Pack | None, listener: Listener, *, patient: bool) -> None:
    """Pack the blocks of a data set that has them all."""
    while True:
        try:
            if not dataset.folder.complete.exists():
                for name in ONLY_MAKING:
                    shutil.rmtree(dataset.folder.work / name, ignore_errors=True)
                write_atomic(dataset.folder.complete, "")
            (pack or _pack)(dataset)
            seal_whole(dataset.folder)
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
        InputError: another run is at work, with its process number; or a folder of the set is a link to elsewhere.
    """
    what, shards = f"--out: {folder.path}", folder.work / "shards"
    own = (folder.work, shards, folder.plan, folder.records, folder.work / "blocks")
    for place in (*own, folder.data, folder.meta, folder.path / "assets"):
        require_no_link(place)
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


def require_free(folder: Folder, what: str = "") -> None:
    """Refuse a data set that a run is at work on.

    Args:
        folder: the data set.
        what: goes before its path in the error.

    Raises:
        InputError: with the number of the process, and its host where that is another one.
    """
    require_unlocked(folder.manifest, f"{what}{folder.path}")
    for lock in (folder.work / "shards").glob(f"{TEMPORARY}*.lock"):
        shard = lock.with_name(lock.name.removeprefix(TEMPORARY).removesuffix(".lock"))
        require_unlocked(shard, f"{what}{folder.path}")


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
