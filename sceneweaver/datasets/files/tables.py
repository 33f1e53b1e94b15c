"""Tables in Parquet, read and written some rows at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from ..columns import arrow
from ..folder import Folder
from ..spec import Spec

GROUP = 1024
"""Rows in memory at a time: one of a large room names a thousand files."""

DICTIONARY = 2**24
"""Most bytes of the different values of a column, up to which each is written once."""


def table_of(folder: Folder, spec: Spec) -> Path:
    """The table with a row a request: scenes, or programs that have many layouts."""
    return folder.index if spec.product == "scenes" else folder.meta / "programs.parquet"


def read_schema(path: Path) -> Any:
    """The columns of a table."""
    return arrow().parquet.read_schema(path)


def write_table(path: Path, rows: Iterable[dict[str, Any]], schema: Any) -> None:
    """Write rows to a Parquet file, some thousands at a time; keys that are no columns are left out."""
    pa = arrow()
    with pa.parquet.ParquetWriter(path, schema, compression="zstd", dictionary_pagesize_limit=DICTIONARY) as writer:
        for some in _batches(rows, GROUP):
            writer.write_table(pa.Table.from_pylist(some, schema=schema))


def read_table(path: Path, columns: list[str] | None = None) -> Iterator[dict[str, Any]]:
    """The rows of a Parquet file, in order, some thousands in memory at a time."""
    with arrow().parquet.ParquetFile(path) as file:
        for some in file.iter_batches(GROUP, columns=columns):
            yield from some.to_pylist()


def _batches(rows: Iterable[Any], size: int) -> Iterator[list[Any]]:
    some = []
    for row in rows:
        some.append(row)
        if len(some) == size:
            yield some
            some = []
    if some:
        yield some
