"""The tables of a data set: columns as ``columns.yaml`` says, rows of Parquet or lines of JSON, some at a time."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from importlib import resources
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.assets.category import read_yaml
from sceneweaver.io import InputError, MissingDependencyError, load_json_lines, open_parquet, write_atomic
from sceneweaver.io.messages import clean
from sceneweaver.runtime.package import missing_extra

from .gates import gate_names
from .seals import MOST, open_own

if TYPE_CHECKING:
    import pyarrow as pa
    import pyarrow.parquet as pq

GROUP = 1024
"""Rows in memory at a time: one of a large room names a thousand files."""

DICTIONARY = 2**24
"""Most bytes of the different values of a column, up to which each is written once."""


def arrow():
    """The module pyarrow.

    Raises:
        MissingDependencyError: when it is not installed.
    """
    try:
        import pyarrow
        import pyarrow.parquet
    except ModuleNotFoundError:
        raise MissingDependencyError(missing_extra("datasets", "data sets need pyarrow")) from None
    return pyarrow


@cache
def schema_of(table: str) -> pa.Schema:
    """The columns of a table: "index", "homes", "programs", "assets" or "seconds"."""
    columns = read_yaml(resources.files(__package__ or "").joinpath("columns.yaml"))[table]
    return arrow().schema([(name, _type(kind)) for name, kind in columns.items()])


def _type(kind: Any) -> pa.DataType:
    pa = arrow()
    if kind == "gates":
        kind = dict.fromkeys(gate_names(), "bool")
    if isinstance(kind, list):
        return pa.list_(_type(kind[0]))
    if isinstance(kind, dict):
        return pa.struct([(name, _type(field)) for name, field in kind.items()])
    return pa.type_for_alias(kind)


@contextmanager
def open_table(path: Path, *, dictionaries: Sequence[str] = ()) -> Iterator[pq.ParquetFile]:
    """A Parquet file of a data set, as `open_parquet`.

    Raises:
        InputError: as `open_parquet`, and for a link.
    """
    open_own(path).close()
    with open_parquet(path, dictionaries=dictionaries) as file:
        yield file


def read_schema(path: Path) -> pa.Schema:
    """The columns of a Parquet file.

    Raises:
        InputError: as `open_table`.
    """
    with open_table(path) as file:
        return file.schema_arrow


def write_table(path: Path, rows: Iterable[dict[str, Any]], schema: pa.Schema) -> None:
    """Write rows to a Parquet file, some thousands at a time; keys that are no columns are left out."""
    pa, left = arrow(), iter(rows)
    with pa.parquet.ParquetWriter(path, schema, compression="zstd", dictionary_pagesize_limit=DICTIONARY) as writer:
        while some := list(islice(left, GROUP)):
            writer.write_table(pa.Table.from_pylist(some, schema=schema))


def read_table(path: Path, columns: Sequence[str] | None = None) -> Iterator[dict[str, Any]]:
    """The rows of a Parquet file, in order, some thousands in memory at a time; columns that it lacks are left out.

    Raises:
        InputError: as `open_table`.
    """
    with open_table(path) as file:
        names = None if columns is None else [name for name in columns if name in file.schema_arrow.names]
        for some in file.iter_batches(GROUP, columns=names):
            yield from some.to_pylist()


def write_lines(path: Path, rows: Iterable[dict[str, Any]]) -> None:
    """Write rows to a file, a line of JSON each."""
    write_atomic(path, "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows))


def read_lines(path: Path) -> Iterator[dict[str, Any]]:
    """The rows of a file with a line of JSON each.

    Raises:
        InputError: as `load_json_lines`, and for a link or a line that is no object.
    """
    open_own(path).close()
    for number, row in enumerate(load_json_lines(path, max_bytes=MOST), start=1):
        if not isinstance(row, dict):
            raise InputError(f"{clean(str(path))}: line {number} is no JSON object")
        yield row
