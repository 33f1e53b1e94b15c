"""Programs and layouts of a data set of layouts, packed or still being made."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.scene import InputError, Pose, Scene

from ..folder import Folder
from ..reading import block_folders
from ..samples import read_rows
from ..tables import arrow, read_table


def programs_of(folder: Folder) -> Iterator[dict[str, Any]]:
    """The programs as rows: of the table, or of the blocks made so far."""
    if folder.programs.exists():
        yield from read_table(folder.programs)
    else:
        for block in block_folders(folder):
            yield from (row | {"program": row["room"]} for row in read_rows(block))


def layout_files(folder: Folder) -> list[Path]:
    """The files with layouts: shards, or those of blocks."""
    packed = folder.programs.exists()
    return sorted(folder.data.glob("*.parquet") if packed else folder.blocks.glob("*/*/layouts-*.parquet"))


def load_program(folder: Path | str, program: int) -> Scene:
    """The scene of a program of a data set, in no particular layout.

    Raises:
        InputError: there is no such program.
    """
    return Scene.loads(_row(folder, program)["scene"])


def load_layout(folder: Path | str, program: int, layout: int) -> Scene:
    """One layout of a program as a scene.

    Args:
        folder: the data set.
        program: number of the program.
        layout: number of the layout, from 0.

    Raises:
        InputError: there is no such layout.
    """
    row, pq = _row(folder, program), arrow().parquet
    for shard in row["shards"]:
        chosen = [("program", "=", program), ("layout", "=", layout)]
        found = pq.read_table(Path(folder) / shard, columns=["poses"], filters=chosen)
        if len(found):
            return posed(Scene.loads(row["scene"]), np.array(found["poses"][0].as_py(), dtype=np.float32))
    raise InputError(f"layout: program {program} of {folder} has {row['layouts']} layouts, none of number {layout}")


def posed(scene: Scene, poses: np.ndarray) -> Scene:
    """A program's scene in a layout.

    Args:
        scene: the program's scene.
        poses: a row's poses [4 M] (x, y, z, yaw), of which those of the scene's objects come first.
    """
    each = np.asarray(poses, dtype=float).reshape(-1, 4)[: len(scene.objects)]
    return scene.replace_poses(
        {
            o.id: Pose.from_yaw(*(float(value) for value in pose))
            for o, pose in zip(scene.objects, each, strict=True)
            if not o.fixed
        }
    )


def _row(folder: Path | str, program: int) -> dict[str, Any]:
    path = Folder(Path(folder)).programs
    if not path.exists():
        raise InputError(f"{folder}: no data set of layouts, or not packed yet: {path} is missing")
    found = arrow().parquet.read_table(path, filters=[("program", "=", program)]).to_pylist()
    if not found or not found[0]["layouts"]:
        raise InputError(f"program: {folder} has no layouts of program {program}")
    return found[0]
