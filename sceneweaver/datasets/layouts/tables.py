"""Layouts as Parquet: the columns, files written by threads of their own, and reading programs and layouts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from itertools import groupby
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.io import parquet_rows
from sceneweaver.scene import InputError, Pose, Scene

from ..folder import Folder
from ..reading import block_folders
from ..samples import read_rows
from ..seals import open_own, require_inside
from ..tables import arrow, open_table, read_table

if TYPE_CHECKING:
    import pyarrow as pa


FILES = 4
"""Files of a block, each written by a thread of its own; the program's number says which."""

GROUP = 4096
"""Rows of a row group, which holds layouts of one program only."""

COMPRESSION: dict[str, Any] = {
    "compression": "zstd",
    "compression_level": 1,
    "use_dictionary": ["program"],
    "write_page_index": True,
}
"""How the files are written. A step of a chain leaves most things where they are, which Zstandard finds as it stands;
bytes of floats ordered by their place make files larger."""


def schema(objects: int) -> pa.Schema:
    """The columns of layouts.

    Args:
        objects: the most objects of any program of the data set. All rows have poses for so many; behind those of its
            program's objects they are NaN.
    """
    pa = arrow()
    return pa.schema(
        [
            ("program", pa.int32()),
            ("layout", pa.int32()),
            pa.field("poses", pa.list_(pa.field("element", pa.float32(), nullable=False), 4 * objects)),
            ("energy", pa.float32()),
            ("soft", pa.float32()),
            ("signature", pa.int64()),
            ("near_duplicate_group", pa.int64()),
        ],
        metadata={b"poses": b"x, y, z [m], yaw [rad] of each object, in the order of the program's scene"},
    )


def table(schema: pa.Schema, columns: dict[str, np.ndarray]) -> pa.Table:
    """Rows of the columns: ``poses`` [K, N, 4] is padded, the others are [K]."""
    pa = arrow()
    width = schema.field("poses").type.list_size
    poses = columns["poses"]
    padded = np.full((len(poses), width), np.nan, dtype=np.float32)
    padded[:, : 4 * poses.shape[1]] = poses.reshape(len(poses), -1)
    arrays = {name: pa.array(values) for name, values in columns.items() if name != "poses"}
    arrays["poses"] = pa.FixedSizeListArray.from_arrays(pa.array(padded.reshape(-1)), type=schema.field("poses").type)
    return pa.table([arrays[name] for name in schema.names], schema=schema)


class Writers:
    """The files of a block, `FILES` of them, in a folder.

    What is handed over, by any thread, is written later, each program's in order.
    """

    def __init__(self, folder: Path, schema: pa.Schema):
        self._schema = schema
        self.paths = [folder / f"layouts-{k}.parquet" for k in range(FILES)]
        self._files = [arrow().parquet.ParquetWriter(path, schema, **COMPRESSION) for path in self.paths]
        self._threads = [ThreadPoolExecutor(1) for _ in range(FILES)]
        self._pending: list[Future[None]] = []
        self._lock = Lock()

    def add(self, program: int, columns: dict[str, np.ndarray]) -> None:
        """Hand over layouts of the program at a position in the block: a row group."""
        self._submit(program, lambda: table(self._schema, columns))

    def write(self, program: int, rows: pa.Table) -> None:
        """The same for rows as they stand in files."""
        self._submit(program, lambda: rows)

    def path(self, program: int) -> Path:
        """The file of the program at a position in the block."""
        return self.paths[program % FILES]

    def _submit(self, program: int, rows: Callable[[], pa.Table]) -> None:
        which = program % FILES
        with self._lock:
            done = [future for future in self._pending if future.done()]
            self._pending = [future for future in self._pending if future not in done]
            self._pending.append(self._threads[which].submit(self._write, which, rows))
        for future in done:
            future.result()

    def _write(self, which: int, rows: Callable[[], pa.Table]) -> None:
        found = rows()
        self._files[which].write_table(found, row_group_size=len(found))

    def __enter__(self) -> Writers:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Write what is left.

        Raises:
            OSError: what went wrong in a thread.
        """
        try:
            for future in self._pending:
                future.result()
        finally:
            for thread, file in zip(self._threads, self._files, strict=True):
                thread.shutdown()
                file.close()


RowGroup = tuple[Path, int]
"""A file and the number of a row group in it."""


def row_groups(block: Path) -> list[RowGroup]:
    """The row groups of a block, file by file."""
    paths = [block / f"layouts-{k}.parquet" for k in range(FILES)]
    found = []
    for path in paths:
        with open_table(path) as file:
            found += [(path, k) for k in range(file.metadata.num_row_groups)]
    return found


def tables(found: Sequence[RowGroup]) -> Iterator[pa.Table]:
    """Row groups, read one after the other."""
    for path, some in groupby(found, lambda one: one[0]):
        with open_table(path) as file:
            for _, number in some:
                yield file.read_row_group(number)


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
    row = _row(folder, program)
    for shard in row["shards"]:
        require_inside(shard, Folder(Path(folder)).programs)
        found = _where(Path(folder) / shard, ["poses"], [("program", "=", program), ("layout", "=", layout)])
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
    found = _where(path, None, [("program", "=", program)]).to_pylist()
    if not found or not found[0]["layouts"]:
        raise InputError(f"program: {folder} has no layouts of program {program}")
    return found[0]


def _where(path: Path, columns: list[str] | None, filters: list[tuple[str, str, int]]) -> pa.Table:
    """The rows of a Parquet file that some conditions hold for; its statistics say which parts need not be read."""
    open_own(path).close()
    return parquet_rows(path, columns, filters)
