"""What the report reads of a data set of layouts: its programs as rows, and some layouts of each as scenes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.geometry.rotations import from_yaw

from ..blocks import read_rows
from ..columns import arrow
from ..folder import Folder
from ..layouts.pack import PROGRAMS
from ..reading import block_folders

LAYOUTS = 16
"""How many layouts of a row group are read as scenes."""


def programs_packed(folder: Folder) -> bool:
    """Whether the table of programs is written."""
    return (folder.meta / PROGRAMS).is_file()


def program_rows(folder: Folder) -> Iterator[dict[str, Any]]:
    """The programs as rows like those of scenes, with ``key``; without the scene itself."""
    for row in _programs(folder):
        row["key"] = _key(row["program"])
        row["index"] = row["room"] = row["program"]
        row["bytes"] = None
        del row["scene"]
        yield row


def program_layouts(folder: Folder) -> Iterator[tuple[str, str]]:
    """Key of the program and JSON of the scene of some layouts of each."""
    pq = arrow().parquet
    scenes = {row["program"]: row["scene"] for row in _programs(folder) if row.get("scene")}
    for path in layout_files(folder):
        file = pq.ParquetFile(path)
        for number in range(file.metadata.num_row_groups):
            table = file.read_row_group(number, columns=["program", "poses"])
            rows = np.unique(np.linspace(0, len(table) - 1, min(LAYOUTS, len(table))).astype(int))
            for row in table.take(rows).to_pylist():
                if row["program"] in scenes:
                    yield _key(row["program"]), _posed(scenes[row["program"]], row["poses"])


def layout_files(folder: Folder) -> list[Path]:
    """The files with layouts: shards, or those of blocks."""
    packed = programs_packed(folder)
    return sorted(folder.data.glob("*.parquet") if packed else folder.blocks.glob("*/*/layouts-*.parquet"))


def _programs(folder: Folder) -> Iterator[dict[str, Any]]:
    if programs_packed(folder):
        yield from arrow().parquet.read_table(folder.meta / PROGRAMS).to_pylist()
    else:
        for block in block_folders(folder):
            yield from (row | {"program": row["room"]} for row in read_rows(block))


def _posed(text: str, poses: list[float]) -> str:
    scene = json.loads(text)
    for obj, (x, y, z, yaw) in zip(scene["objects"], np.reshape(poses, (-1, 4)).tolist(), strict=False):
        if not obj.get("fixed"):
            obj["pose"] = {"position": [x, y, z], "quaternion": list(from_yaw(yaw))}
    return json.dumps(scene)


def _key(program: int) -> str:
    return f"{program:08d}"
