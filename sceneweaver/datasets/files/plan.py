"""What packing is to write: the index with split, shard and near-duplicate group of each scene, and the times.

The plan is a function of the rows of all blocks. It is there whole or not at all, and packing goes by it to the end.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from scipy.cluster.hierarchy import DisjointSet

from sceneweaver.scene import InputError

from ..folder import Folder
from ..requests import Requests
from ..samples import SECONDS, read_rows, whole_folder
from ..spec import Spec
from ..store import AssetStore
from ..tables import read_lines, schema_of, write_table
from .fingerprint import Layout, join_near_duplicates, smallest

INDEX, SECONDS_TABLE, ASSETS = "index.parquet", "seconds.parquet", "assets.parquet"


def packing_began(folder: Folder) -> bool:
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
    with whole_folder(folder.plan) as draft:
        write_table(draft / INDEX, _indexed(blocks, placed), schema_of("index"))
        write_table(draft / SECONDS_TABLE, seconds_rows(blocks), schema_of("seconds"))
        write_table(draft / ASSETS, _assets(folder, blocks), schema_of("assets"))


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
    """What is known of each asset that a delivered scene has, by id; others were drawn in vain."""
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
