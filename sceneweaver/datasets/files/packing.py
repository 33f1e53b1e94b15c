"""From blocks to the files of a data set, in steps that may each be cut off and go on.

Samples are copied in order into shards; blocks go when what they held is safe. The state of a packing that was killed
follows from the plan and from what is there: of each shard, the scenes that are as they were delivered count, whatever
else is in it is cut off, and the next ones are copied from their blocks.

The plan says what is to be written: the index with split, shard and near-duplicate group of each scene, and the times.
It is a function of the rows of all blocks, there whole or not at all, and packing goes by it to the end. Its seal stays
until the checksums are there.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Iterator
from contextlib import ExitStack
from itertools import chain, groupby
from pathlib import Path
from typing import IO, Any

import numpy as np

from sceneweaver.io import own_folder, sweep, temporary_folder, write_atomic
from sceneweaver.io.tars import content, ending, members
from sceneweaver.scene import InputError

from ..digests import checksums_of, content_of, write_checksums
from ..folder import Folder
from ..requests import Requests
from ..samples import SAMPLES, SECONDS, read_rows, whole_folder
from ..seals import DamagedError, kind_fault, open_own, remove
from ..spec import Spec
from ..statistics import statistics
from ..store import AssetStore
from ..tables import read_lines, read_schema, read_table, schema_of, write_table
from .card import card, croissant, licences, licences_text
from .fingerprint import Layout, join_near_duplicates, smallest
from .planned import ASSETS, INDEX, SECONDS_TABLE, Planned, packing_began, planned, there


def write_plan(folder: Folder, requests: Requests) -> None:
    """Plan the packing of a data set.

    Raises:
        InputError: when a block is missing.
    """
    blocks = [folder.block(number) for number in range(requests.blocks)]
    missing = [path.name for path in blocks if not path.exists()]
    if missing:
        raise InputError(f"{folder.path}: block {missing[0]} of {len(blocks)} is missing; resume the data set")
    placed = _placed(requests.spec, blocks)
    with whole_folder(folder.plan) as draft:
        write_table(draft / INDEX, _indexed(blocks, placed), schema_of(requests.spec.table))
        write_table(draft / SECONDS_TABLE, seconds_rows(blocks), schema_of("seconds"))
        write_table(draft / ASSETS, _assets(folder, blocks), schema_of("assets"))


def _placed(spec: Spec, blocks: list[Path]) -> Iterator[dict[str, Any]]:
    """Split, shard and near-duplicate group of each delivered scene, in order."""
    from scipy.cluster.hierarchy import DisjointSet

    index, rooms, sizes, layouts = [], [], [], []
    for row in _delivered(blocks):
        layouts.append((len(rooms), row["layout_signature"], Layout.from_row(row["furniture"])))
        index.append(row["index"])
        rooms.append(row["room"])
        sizes.append(row["bytes"])
    sets = DisjointSet(range(len(rooms)))
    join_near_duplicates(sets, layouts)
    groups = np.array(index, dtype=np.int64)[smallest(sets)]
    first: dict[int, int] = {}
    for number, room in enumerate(rooms):
        sets.merge(first.setdefault(room, number), number)
    names = sorted(spec.splits)
    filled, shard = dict.fromkeys(names, 0), dict.fromkeys(names, 0)
    for size, group, split in zip(sizes, groups, assign_splits(spec, smallest(sets)), strict=True):
        name = names[split]
        if filled[name] and filled[name] + size > spec.shard * 10**6:
            filled[name], shard[name] = 0, shard[name] + 1
        filled[name] += size
        yield {
            "split": name,
            "shard": f"data/{name}-{shard[name]:06d}.tar",
            "near_duplicate_group": int(group),
        }


def _indexed(blocks: list[Path], placed: Iterator[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    for row in _rows(blocks):
        yield {**row, **next(placed)} if row["status"] == "ok" else row


def _rows(blocks: list[Path]) -> Iterator[dict[str, Any]]:
    return chain.from_iterable(map(read_rows, blocks))


def _delivered(blocks: list[Path]) -> Iterator[dict[str, Any]]:
    return (row for row in _rows(blocks) if row["status"] == "ok")


def seconds_rows(blocks: list[Path]) -> Iterator[dict[str, Any]]:
    """The times of some blocks, a row a stage."""
    for path in blocks:
        for row in read_lines(path / SECONDS):
            index = row.pop("index")
            yield from ({"index": index, "stage": stage, "seconds": took} for stage, took in row.items())


def _assets(folder: Folder, blocks: list[Path]) -> Iterator[dict[str, Any]]:
    """What is known of each asset that a delivered scene has, by id; others were drawn for scenes that failed."""
    from ..store.scene_files import asset_rows  # which loads all exporters

    used = {asset_id for row in _delivered(blocks) for asset_id in row.get("asset_ids") or ()}
    return (row for row in asset_rows(AssetStore(folder.path)) if row["asset"] in used)


def assign_splits(spec: Spec, families: np.ndarray) -> np.ndarray:
    """The split of each scene, as its place among the names of the splits in ascending order.

    Families lie in the order of a hash; each is in the split within whose share of all scenes its middle falls. So the
    shares are as exact as whole families allow, and no family is in two splits.

    Args:
        spec: says the shares.
        families: a number for each scene; scenes of one family share a split. Shape [scene].
    """
    names, places, sizes = np.unique(families, return_inverse=True, return_counts=True)
    order = np.array(sorted(range(len(names)), key=lambda i: _hash(spec.seed, int(names[i]))), dtype=int)
    middles = np.cumsum(sizes[order]) - sizes[order] / 2
    shares = np.array([spec.splits[name] for name in sorted(spec.splits)])
    ends = np.cumsum(shares / shares.sum())[:-1] * len(families)
    split = np.empty(len(names), dtype=int)
    split[order] = np.searchsorted(ends, middles, side="right")
    return split[places]


def _hash(seed: int, family: int) -> bytes:
    return hashlib.sha256(f"{seed} {family}".encode()).digest()


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
        DamagedError: when a block does not hold what was planned.
        OSError: when the disk is full; called again, it goes on.
    """
    if not folder.checksums.exists():
        for place in (folder.path, folder.plan.parent, *folder.blocks.glob("*")):
            sweep(place)
        if not packing_began(folder):
            write_plan(folder, requests)
        write_shards(folder, requests)
        own_folder(folder.meta)
        for name in (SECONDS_TABLE, ASSETS, INDEX):
            if (folder.plan / name).exists():
                os.replace(folder.plan / name, folder.meta / name)
        shutil.rmtree(folder.blocks, ignore_errors=True)
        _prune(folder)
        finish(folder, requests.spec)
    shutil.rmtree(folder.plan, ignore_errors=True)  # with its seal, which is of use until then


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
    if spec.product != "layouts":
        return statistics(read_table(table, names))
    rows = ({**row, "room": row["program"]} for row in read_table(table, names))
    size = sum(path.stat().st_size for path in folder.data.glob("*.parquet"))
    layouts = sum(row["layouts"] or 0 for row in read_table(table, ["layouts"]))
    return {**statistics(rows), "layouts": layouts, "bytes": size}


def _json(data: object) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def write_shards(folder: Folder, requests: Requests) -> None:
    """Copy the samples of all blocks that are left into shards, and remove the blocks."""
    own_folder(folder.data)
    wanted = planned(folder)
    copied, done = 0, []
    with ExitStack() as stack:
        shards = Shards(folder, stack, wanted)
        for number in range(requests.blocks):
            block = folder.block(number)
            if not block.exists():
                continue
            copied += _copy(block / SAMPLES, shards)
            done.append(block)
            if copied > SAFE:
                shards.sync()
                _remove(done)
                copied, done = 0, []
        shards.finish()
        _remove(done)


class Shards:
    """The shards of a data set, one open for each split.

    Args:
        folder: the data set.
        stack: closes the files.
        wanted: the scenes of each shard, in order.
    """

    def __init__(self, folder: Folder, stack: ExitStack, wanted: dict[str, list[Planned]]):
        self._folder, self._stack, self._wanted = folder, stack, wanted
        self._places = {one.key: (shard, k) for shard, scenes in wanted.items() for k, one in enumerate(scenes)}
        self._open: dict[str, tuple[IO[bytes], int]] = {}

    def add(self, key: str, files: dict[str, bytes], raw: bytes) -> int:
        """Append a scene to its shard, unless it is there.

        Args:
            key: its name.
            files: what it holds, by suffix.
            raw: the same as it stands in a tar file.

        Returns:
            How many bytes were written.

        Raises:
            DamagedError: it is not what was planned.
        """
        shard, place = self._places.get(key, ("", 0))
        if not shard:
            raise DamagedError(f"{self._folder.path}: scene {key} is in no shard of the plan; {_ANEW}")
        planned = self._wanted[shard][place]
        if content_of(files) != (planned.digest, planned.size):
            raise DamagedError(
                f"{self._folder.path}: scene {key} is not what was planned when it was first made; {_ANEW}"
            )
        if (self._folder.path / shard).exists():
            return 0
        file, count = self._opened(shard)
        if place < count:
            return 0
        self._require(shard, place)
        file.write(raw)
        self._open[shard] = file, count + 1
        return len(raw)

    def sync(self) -> None:
        """Write what was appended to the disk."""
        for file, _ in self._open.values():
            file.flush()
            os.fsync(file.fileno())

    def finish(self) -> None:
        """End all shards."""
        for shard in sorted(self._wanted):
            if not (self._folder.path / shard).exists():
                self._opened(shard)
                self._finish(shard)

    def _opened(self, shard: str) -> tuple[IO[bytes], int]:
        if shard not in self._open:
            split = shard.rpartition("-")[0]
            for other in [name for name in self._open if name.rpartition("-")[0] == split]:
                self._finish(other)
            path = self._draft(shard)
            count, end = there(path, self._wanted[shard])
            if kind_fault(path):
                remove(path)
                path.touch()
            file = self._stack.enter_context(path.open("r+b"))
            file.truncate(end)
            file.seek(end)
            self._open[shard] = file, count
        return self._open[shard]

    def _finish(self, shard: str) -> None:
        self._require(shard, len(self._wanted[shard]))
        file, _ = self._open.pop(shard)
        file.write(ending(file.tell()))
        file.flush()
        os.fsync(file.fileno())
        file.close()
        os.replace(self._draft(shard), self._folder.path / shard)

    def _require(self, shard: str, count: int) -> None:
        """Raise InputError where a shard has not so many scenes yet: the block of the next one is missing."""
        so_far = self._open[shard][1]
        if so_far < count:
            key = self._wanted[shard][so_far].key
            raise InputError(f"{self._folder.path}: the block of scene {key} is missing; resume the data set")

    def _draft(self, shard: str) -> Path:
        return self._folder.plan / Path(shard).name


_ANEW = "make the data set anew in another folder"


def _copy(path: Path, shards: Shards) -> int:
    """Append the samples of a block to their shards; returns their bytes."""
    copied, name = 0, str(path)
    with open_own(path) as source:
        for key, some in groupby(members(source, name), lambda member: member.name.partition(".")[0]):
            found = list(some)
            files = {member.name.partition(".")[2]: content(source, member, name) for member in found}
            source.seek(found[0].start)
            copied += shards.add(key, files, source.read(found[-1].end - found[0].start))
    return copied


def _remove(blocks: list[Path]) -> None:
    """Remove blocks in order; each is there whole or not at all."""
    for path in blocks:
        with temporary_folder(path.parent) as folder:
            os.rename(path, folder / path.name)
