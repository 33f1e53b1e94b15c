"""From blocks to a data set: layouts in shards by split, and the table of programs."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.io import InputError, open_writable, sweep

from ..files.packing import finish, seconds_rows
from ..files.planned import SECONDS_TABLE, final_place, packing_began
from ..folder import Folder
from ..requests import Requests
from ..samples import read_rows, whole_folder
from ..spec import Spec
from ..tables import arrow, open_table, schema_of, write_table
from .block import width
from .tables import COMPRESSION, RowGroup, row_groups, schema, tables

if TYPE_CHECKING:
    import pyarrow as pa

SIDES = 0.25
"""Grid [m] of sizes in which two programs of the same furniture count as near-duplicates."""


def pack(folder: Folder, requests: Requests) -> None:
    """Write the files of a data set of the blocks, which go; does nothing where all is there.

    Programs of the same furniture in rooms of the same size are of one group, and a group lies in one split.

    Raises:
        InputError: when a block is missing.
        OSError: when the disk is full; called again, it goes on.
    """
    if not folder.checksums.exists():
        for place in (folder.path, folder.plan.parent):
            sweep(place)
        if not packing_began(folder):
            _write(folder, requests)
        _take(folder)
        shutil.rmtree(folder.blocks, ignore_errors=True)
        finish(folder, requests.spec)
    shutil.rmtree(folder.plan, ignore_errors=True)  # with its seal, which is of use until then


def _write(folder: Folder, requests: Requests) -> None:
    """Write shards and tables into the plan, which is there whole or not at all."""
    blocks = [folder.block(number) for number in range(requests.blocks)]
    missing = [path.name for path in blocks if not path.exists()]
    if missing:
        raise InputError(f"{folder.path}: block {missing[0]} of {len(blocks)} is missing; resume the data set")
    with whole_folder(folder.plan) as plan:
        shards = _Shards(plan / "data", schema(width(requests)), requests.spec.shard * 10**6)
        rows: list[dict[str, Any]] = []
        groups: dict[str, int] = {}
        for block in blocks:
            groups_of = _of_programs(block)
            for row in read_rows(block):
                row |= {"program": row["room"], "shards": [], "layouts": row.get("layouts", 0), "split": None}
                if row["layouts"]:
                    row["near_duplicate_group"] = groups.setdefault(furniture(row["scene"]), row["room"])
                    row["split"] = split_of(requests.spec, row["near_duplicate_group"])
                    row["shards"] = shards.add(row["split"], groups_of[row["room"]])
                rows.append(row)
        shards.close()
        write_table(plan / SECONDS_TABLE, seconds_rows(blocks), schema_of("seconds"))
        write_table(plan / folder.programs.name, rows, schema_of("programs"))


def _take(folder: Folder) -> None:
    """Bring what is in the plan to where it is to be; the table of programs comes last."""
    for place in (folder.data, folder.meta):
        place.mkdir(parents=True, exist_ok=True)
    shards = sorted((folder.plan / "data").glob("*.parquet"))
    for path in (*shards, folder.plan / SECONDS_TABLE, folder.plan / folder.programs.name):
        if path.exists():
            os.replace(path, final_place(folder, path.relative_to(folder.plan).as_posix()))


def split_of(spec: Spec, group: int) -> str:
    """The split of a group of programs."""
    digest = hashlib.sha256(f"{spec.seed}:{group}".encode()).digest()
    names = sorted(spec.splits)
    ends = np.cumsum([spec.splits[name] for name in names])
    share = int.from_bytes(digest[:8]) / 2**64
    return names[min(int(np.searchsorted(ends, share * ends[-1], side="right")), len(names) - 1)]


def furniture(scene: str) -> str:
    """What near-duplicates of programs share: sizes of room and furniture on a grid, and categories."""
    data = json.loads(scene)
    corners = np.array(data["room"]["outline"])
    sides = np.round(np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1) / SIDES).astype(int).tolist()
    things = sorted([o["category"], *(round(side / SIDES) for side in o["size"])] for o in data["objects"])
    return json.dumps([sides, things])


def _of_programs(block: Path) -> dict[int, list[RowGroup]]:
    """The row groups of each program of a block, in their order."""
    found: dict[int, list[RowGroup]] = {}
    for path, groups in groupby(row_groups(block), lambda one: one[0]):
        with open_table(path) as file:
            for _, number in groups:
                program = file.metadata.row_group(number).column(0).statistics.min
                found.setdefault(program, []).append((path, number))
    return found


class _Shards:
    """Files of one size or a little more, by split, with row groups as they were."""

    def __init__(self, folder: Path, schema: pa.Schema, size: int):
        folder.mkdir()
        self._folder, self._schema, self._size = folder, schema, size
        self._open: dict[str, tuple[Any, Any, str]] = {}
        self._count: dict[str, int] = {}

    def add(self, split: str, found: list[RowGroup]) -> list[str]:
        """Append the layouts of a program; the shards that they lie in."""
        used: list[str] = []
        for table in tables(found):
            if split not in self._open:
                number = self._count[split] = self._count.get(split, -1) + 1
                name = f"{split}-{number:06d}.parquet"
                file = open_writable(self._folder / name, "xb")
                self._open[split] = file, arrow().parquet.ParquetWriter(file, self._schema, **COMPRESSION), name
            file, writer, name = self._open[split]
            writer.write_table(table, row_group_size=len(table))
            used += [f"data/{name}"] if f"data/{name}" not in used else []
            if file.tell() >= self._size:
                self._end(split)
        return used

    def _end(self, split: str) -> None:
        file, writer, _ = self._open.pop(split)
        writer.close()
        file.close()

    def close(self) -> None:
        """End all files."""
        for split in list(self._open):
            self._end(split)
