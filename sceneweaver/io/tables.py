"""Tables that somebody else wrote: CSV, and Parquet whose statements about itself are checked before it is read."""

from __future__ import annotations

import contextlib
import csv
import io
import os
from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from sceneweaver.runtime.package import missing_extra

from .errors import InputError, MissingDependencyError
from .messages import path_name
from .reading import MAX_UNPACKED, Place, open_regular, read_bytes, reason

if TYPE_CHECKING:
    import pyarrow.parquet

MAX_CELLS = 10_000_000
"""Cells of a CSV file."""

MAX_TABLE = 2**40
"""Largest Parquet file [bytes]: it is read some rows at a time."""

MAX_GROUP = 2**31
"""Most bytes that a row group may unpack to."""

MAX_COLUMNS = 10_000

MAX_FIELD = 2**24
"""Characters of one field of a CSV file that is read row by row."""


def load_csv(path: Place) -> list[dict[str, str]]:
    """The rows of a CSV file with a header.

    Raises:
        InputError: as `read_bytes`; not UTF-8, damaged, too many cells.
    """
    name = path_name(os.path.basename(os.fspath(path)))
    try:
        text = read_bytes(path, max_bytes=MAX_UNPACKED).decode("utf-8-sig")
        if text.count(",") + text.count("\n") > MAX_CELLS:
            raise ValueError(f"over {MAX_CELLS} cells; split it")
        return list(csv.DictReader(io.StringIO(text, newline="")))
    except InputError:
        raise
    except (ValueError, csv.Error) as error:
        raise InputError(f"{name}: not readable as CSV ({reason(error)})") from error


@contextlib.contextmanager
def open_csv(path: Place, *, max_bytes: int = MAX_TABLE) -> Iterator[csv.DictReader[str]]:
    """The rows of a CSV file with a header, one by one, so that it may be larger than the memory.

    Args:
        path: the file; what is no UTF-8 in it is read as replacement characters.
        max_bytes: a larger one is refused.

    Raises:
        InputError: as `open_regular`; a field of more than `MAX_FIELD` characters, damaged.
    """
    csv.field_size_limit(MAX_FIELD)
    with open_regular(path, max_bytes) as binary:
        try:
            yield csv.DictReader(line.decode("utf-8", "replace") for line in binary)
        except csv.Error as error:
            raise InputError(f"{path_name(path)}: not readable as CSV ({reason(error)})") from error


@contextlib.contextmanager
def open_parquet(path: Place, *, dictionaries: Sequence[str] = ()) -> Iterator[pyarrow.parquet.ParquetFile]:
    """A Parquet file.

    Args:
        path: the file.
        dictionaries: columns of which each different value is held once.

    Raises:
        InputError: as `open_regular`; damaged, or it says that it unpacks to more than memory should hold.
        MissingDependencyError: pyarrow is not installed.
    """
    pyarrow, name = _pyarrow(), path_name(os.path.basename(os.fspath(path)))
    with open_regular(path, MAX_TABLE) as file:
        try:
            with pyarrow.parquet.ParquetFile(file, read_dictionary=list(dictionaries) or None) as table:
                about = table.metadata
                if about.num_columns > MAX_COLUMNS:
                    raise InputError(f"{name}: {about.num_columns} columns; at most {MAX_COLUMNS} are read")
                for group in range(about.num_row_groups):
                    _require_small(name, about.row_group(group))
                yield table
        except (pyarrow.ArrowException, OSError, ValueError, MemoryError) as error:
            if isinstance(error, InputError):
                raise
            raise InputError(f"{name}: not readable as Parquet ({reason(error)})") from error


def parquet_rows(path: Place, columns: Sequence[str] | None, filters: list[tuple[str, str, int]]) -> pyarrow.Table:
    """The rows of a Parquet file that some conditions hold for; its statistics say which parts need not be read.

    Raises:
        InputError: as `open_parquet`.
    """
    with open_parquet(path):
        return _pyarrow().parquet.read_table(path, columns=columns, filters=filters)


def _require_small(name: str, group: Any) -> None:
    """Sizes as stated; a run of equal values may unpack to more, but never to more than a value for each row."""
    if not 0 <= group.total_byte_size <= MAX_GROUP or not 0 <= group.num_rows * group.num_columns <= MAX_GROUP:
        raise InputError(
            f"{name}: a row group of {group.num_rows} rows, {group.total_byte_size >> 20} MiB; it is too large"
        )


def _pyarrow() -> Any:
    try:
        import_module("pyarrow.parquet")
        return import_module("pyarrow")
    except ModuleNotFoundError:
        raise MissingDependencyError(missing_extra("datasets", "Parquet files need pyarrow")) from None
