"""Layouts as Parquet: the columns, and files that are written by threads of their own."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..columns import arrow

if TYPE_CHECKING:
    import pyarrow as pa

FILES = 4
"""Files of a block, each written by a thread of its own; the program's number says which."""

GROUP = 16384
"""Rows of a row group, which holds layouts of one program only."""

COMPRESSION: dict[str, Any] = {
    "compression": "zstd",
    "compression_level": 1,
    "use_dictionary": ["program"],
    "use_byte_stream_split": ["poses.list.element", "energy"],
    "write_page_index": True,
}
"""How the files are written: bytes of floats by their place, then Zstandard at its fastest."""


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
    """The files of a block, `FILES` of them, in a folder. What is handed over is written later, in order."""

    def __init__(self, folder: Path, schema: pa.Schema):
        self._schema = schema
        self.paths = [folder / f"layouts-{k}.parquet" for k in range(FILES)]
        self._files = [arrow().parquet.ParquetWriter(path, schema, **COMPRESSION) for path in self.paths]
        self._threads = [ThreadPoolExecutor(1) for _ in range(FILES)]
        self._pending: list[Future[None]] = []

    def write(self, program: int, columns: dict[str, np.ndarray]) -> None:
        """Hand over layouts of one program: a row group."""
        which = program % FILES
        done = [f for f in self._pending if f.done()]
        for future in done:
            future.result()
        self._pending = [f for f in self._pending if f not in done]
        self._pending.append(self._threads[which].submit(self._write, which, columns))

    def _write(self, which: int, columns: dict[str, np.ndarray]) -> None:
        self._files[which].write_table(table(self._schema, columns), row_group_size=len(columns["layout"]))

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
