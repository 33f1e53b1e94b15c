"""From blocks to the files of a data set, in steps that may each be cut off and go on.

Samples are copied in order into shards; blocks go when what they held is safe. The state of a packing that was killed
follows from the first block that is left: what came before it is in shards that are finished or in the beginnings of
others. These are cut after the last sample of a block that is gone, and go on.
"""

from __future__ import annotations

import json
import os
import shutil
import tarfile
from contextlib import ExitStack
from pathlib import Path
from typing import IO, Any

from sceneweaver.scene import write_atomic
from sceneweaver.scene.files import sweep, temporary_folder

from ..digests import checksums_of, write_checksums
from ..folder import Folder
from ..requests import Requests
from ..samples import SAMPLES
from ..spec import Spec
from ..statistics import statistics
from ..tables import read_schema, read_table
from .card import card
from .croissant import croissant, licences, licences_text
from .plan import ASSETS, INDEX, SECONDS_TABLE, packing_began, write_plan

SAFE = 256 * 10**6
"""Bytes after which what was copied is written to the disk for good, so that its blocks may go."""

LONG = ("assets", "asset_ids", "scene")
"""Columns that statistics leave out, and that most of a table consists of."""


def pack(folder: Folder, requests: Requests) -> None:
    """Make shards, tables, card and checksums of the blocks of a data set; does nothing where all is there.

    The plan comes first, shards next, then tables and texts, checksums last. Killed in between, it goes on when it is
    called again, to the same bytes. Only one process at a time may run it.

    Raises:
        InputError: when a block is missing.
        OSError: when the disk is full; called again, it goes on.
    """
    if folder.checksums.exists():
        return
    for place in (folder.path, folder.plan.parent, *folder.blocks.glob("*")):
        sweep(place)
    if not packing_began(folder):
        write_plan(folder, requests)
    if (folder.plan / INDEX).exists():
        write_shards(folder, requests)
        folder.meta.mkdir(exist_ok=True)
        for name in (SECONDS_TABLE, ASSETS, INDEX):
            if (folder.plan / name).exists():
                os.replace(folder.plan / name, folder.meta / name)
    for place in (folder.plan, folder.blocks):
        shutil.rmtree(place, ignore_errors=True)
    _prune(folder)
    finish(folder, requests.spec)


def _prune(folder: Folder) -> None:
    """Remove files from the store that no scene needs: what a run that was killed wrote for scenes that then failed."""
    columns = ((folder.index, "assets"), (folder.asset_table, "files"))
    used = {name for table, column in columns for row in read_table(table, [column]) for name in row[column] or ()}
    for place in folder.assets.glob("*"):
        for name in os.listdir(place) if place.is_dir() else ():
            if f"{folder.assets.name}/{place.name}/{name}" not in used:
                (place / name).unlink()


def finish(folder: Folder, spec: Spec) -> None:
    """Write what every data set has beside its data: statistics, licences, card, Croissant metadata, checksums.

    All of it is a function of data, index and specification, without times. Checksums come last.
    """
    numbers = _numbers(folder, spec)
    used = licences(folder)
    write_atomic(folder.statistics, _json(numbers))
    write_atomic(folder.path / "LICENSES.md", licences_text(spec, used))
    write_atomic(folder.path / "README.md", card(folder, spec, numbers, used))
    sums = checksums_of(folder)
    write_atomic(folder.path / "croissant.json", _json(croissant(folder, spec, numbers, used, sums)))
    write_checksums(folder, sums)


def _numbers(folder: Folder, spec: Spec) -> dict[str, Any]:
    """Statistics of the scenes; of layouts those of their programs, and how many layouts there are."""
    table = folder.table(spec.product)
    names = [name for name in read_schema(table).names if name not in LONG]
    if spec.product == "scenes":
        return statistics(read_table(table, names))
    rows = ({**row, "room": row["program"]} for row in read_table(table, names))
    size = sum(path.stat().st_size for path in folder.data.glob("*.parquet"))
    layouts = sum(row["layouts"] or 0 for row in read_table(table, ["layouts"]))
    return {**statistics(rows), "layouts": layouts, "bytes": size}


def _json(data: object) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def write_shards(folder: Folder, requests: Requests) -> None:
    """Copy the samples of all blocks that are left into shards, and remove the blocks."""
    folder.data.mkdir(exist_ok=True)
    blocks = [n for n in range(requests.blocks) if folder.block(n).exists()]
    plan = read_table(folder.plan / INDEX, ["index", "key", "shard"])
    places = {row["key"]: (row["index"], row["shard"]) for row in plan if row["shard"] is not None}
    first = requests.block(blocks[0])[0].index if blocks else requests.spec.count
    copied, done = 0, []
    with ExitStack() as stack:
        shards = Shards(folder, stack, {key for key, (index, _) in places.items() if index < first})
        for number in blocks:
            copied += _copy(folder.block(number) / SAMPLES, places, shards)
            done.append(folder.block(number))
            if copied > SAFE:
                shards.sync()
                _remove(done)
                copied, done = 0, []
        shards.finish({shard for _, shard in places.values()})
        _remove(done)


class Shards:
    """The shards of a data set, one open for each split.

    Args:
        folder: the data set.
        stack: closes the files.
        safe: keys of the samples whose block is gone.
    """

    def __init__(self, folder: Folder, stack: ExitStack, safe: set[str]):
        self._folder, self._stack, self._safe = folder, stack, safe
        self._open: dict[str, IO[bytes]] = {}

    def file(self, shard: str) -> IO[bytes] | None:
        """Where samples of a shard are appended; None when it is finished already."""
        if shard not in self._open:
            if (self._folder.path / shard).exists():
                return None
            split = shard.rpartition("-")[0]
            for other in [name for name in self._open if name.rpartition("-")[0] == split]:
                self._finish(other)
            self._open[shard] = self._begun(self._draft(shard))
        return self._open[shard]

    def sync(self) -> None:
        """Write what was appended to the disk."""
        for file in self._open.values():
            file.flush()
            os.fsync(file.fileno())

    def finish(self, shards: set[str]) -> None:
        """End all shards."""
        for shard in sorted(shards):
            if self.file(shard) is not None:
                self._finish(shard)

    def _begun(self, path: Path) -> IO[bytes]:
        end = _end_of(path, self._safe) if path.exists() else 0
        path.touch()
        file = self._stack.enter_context(path.open("r+b"))
        file.truncate(end)
        file.seek(end)
        return file

    def _finish(self, shard: str) -> None:
        file = self._open.pop(shard)
        file.write(bytes(2 * tarfile.BLOCKSIZE))
        file.write(bytes(-file.tell() % tarfile.RECORDSIZE))
        file.flush()
        os.fsync(file.fileno())
        file.close()
        os.replace(self._draft(shard), self._folder.path / shard)

    def _draft(self, shard: str) -> Path:
        return self._folder.plan / Path(shard).name


def _end_of(path: Path, safe: set[str]) -> int:
    """Where in a beginning of a shard the samples end that are in no block any more [bytes]."""
    end = 0
    try:
        with tarfile.open(path, "r:") as tar:
            for member in tar:
                if member.name.partition(".")[0] not in safe:
                    break
                end = member.offset_data + _padded(member.size)
    except tarfile.ReadError:  # it ends within a header
        pass
    return end


def _copy(path: Path, places: dict[str, tuple[int, str]], shards: Shards) -> int:
    """Append the samples of a block to their shards; returns their bytes."""
    copied = 0
    with open(path, "rb") as source, tarfile.open(path, "r:") as tar:
        for member in tar:
            file = shards.file(places[member.name.partition(".")[0]][1])
            if file is not None:
                source.seek(member.offset)
                size = member.offset_data - member.offset + _padded(member.size)
                file.write(source.read(size))
                copied += size
    return copied


def _remove(blocks: list[Path]) -> None:
    """Remove blocks in order; each is there whole or not at all."""
    for path in blocks:
        with temporary_folder(path.parent) as folder:
            os.rename(path, folder / path.name)


def _padded(size: int) -> int:
    return -(-size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE
