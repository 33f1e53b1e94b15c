"""What packing is to write: the index with split, shard and near-duplicate group of each scene, and the times.

The plan is a function of the rows of all blocks. It is there whole or not at all, and packing goes by it to the end.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from scipy.cluster.hierarchy import DisjointSet

from sceneweaver.scene import InputError
from sceneweaver.scene.files import temporary_folder

from ..blocks import SECONDS, read_rows
from ..columns import arrow, index_schema
from ..folder import Folder
from ..requests import Requests
from ..spec import Spec
from ..store import AssetStore
from .fingerprint import Layout
from .near_duplicates import join_near_duplicates, smallest
from .splits import assign_splits
from .tables import write_table

INDEX, SECONDS_TABLE, ASSETS = "index.parquet", "seconds.parquet", "assets.parquet"


def packing(folder: Folder) -> bool:
    """Whether packing has begun: then blocks may be gone, and none is to be made."""
    return folder.plan.exists() or folder.index.exists()


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
    with temporary_folder(folder.plan.parent) as parent:
        draft = parent / folder.plan.name
        draft.mkdir()
        write_table(draft / INDEX, _indexed(blocks, placed), index_schema())
        write_table(draft / SECONDS_TABLE, seconds_rows(blocks), seconds_schema())
        write_table(draft / ASSETS, _assets(folder, blocks), _assets_schema())
        os.rename(draft, folder.plan)


def _placed(spec: Spec, blocks: list[Path]) -> Iterator[dict[str, Any]]:
    """Split, shard and near-duplicate group of each delivered scene, in order."""
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
    for path in blocks:
        yield from read_rows(path)


def _delivered(blocks: list[Path]) -> Iterator[dict[str, Any]]:
    return (row for row in _rows(blocks) if row["status"] == "ok")


def seconds_rows(blocks: list[Path]) -> Iterator[dict[str, Any]]:
    """The times of some blocks, a row a stage."""
    for path in blocks:
        with open(path / SECONDS, encoding="utf-8") as file:
            for line in file:
                row = json.loads(line)
                index = row.pop("index")
                yield from ({"index": index, "stage": stage, "seconds": took} for stage, took in row.items())


def _assets(folder: Folder, blocks: list[Path]) -> Iterator[dict[str, Any]]:
    """What is known of each asset that a delivered scene has, by id; others were drawn in vain."""
    from ..store.scene_files import asset_rows  # which loads all exporters

    used = {asset_id for row in _delivered(blocks) for asset_id in row.get("asset_ids") or ()}
    return (row for row in asset_rows(AssetStore(folder.path)) if row["asset"] in used)


def _assets_schema():
    pa = arrow()
    columns = [(name, pa.string()) for name in ("asset", "category", "source", "licence", "attribution")]
    return pa.schema([*columns, ("files", pa.list_(pa.string())), ("bytes", pa.int64())])


def seconds_schema():
    """What ``meta/seconds.parquet`` holds."""
    pa = arrow()
    return pa.schema([("index", pa.int64()), ("stage", pa.string()), ("seconds", pa.float64())])
