"""Reading a data set: its rows, and the files of its scenes straight from the shards, one after the other.

A set that is packed is read from ``meta/`` and ``data/``; one that is still made, from its blocks.
"""

from __future__ import annotations

import tarfile
from collections.abc import Container, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.scene import InputError

from .blocks import ROWS, SAMPLES, read_rows
from .columns import arrow
from .folder import Folder

INDEX = "index.parquet"


@dataclass(frozen=True)
class Span:
    """Some scenes that lie one behind the other in a shard.

    Attributes:
        path: the tar file.
        start: where the first member begins [bytes].
        keys: the keys of the scenes, in order.
    """

    path: Path
    start: int
    keys: tuple[str, ...]


def packed(folder: Folder) -> bool:
    """Whether the index of a data set is written."""
    return (folder.meta / INDEX).exists()


def block_folders(folder: Folder) -> list[Path]:
    """The blocks that are whole, in order."""
    return sorted(path.parent for path in folder.blocks.glob(f"*/*/{ROWS}"))


def rows_of(folder: Folder, columns: list[str] | None = None) -> Iterator[dict[str, Any]]:
    """The rows of the index, or of the blocks made so far; in order of index, a batch in memory at a time.

    Args:
        folder: the data set.
        columns: which; None: all.
    """
    if packed(folder):
        arrow()
        from pyarrow import parquet

        with parquet.ParquetFile(folder.meta / INDEX) as file:
            names = None if columns is None else [name for name in columns if name in file.schema_arrow.names]
            for batch in file.iter_batches(batch_size=4096, columns=names):
                yield from map(_plain, batch.to_pylist())
    else:
        for block in block_folders(folder):
            yield from read_rows(block)


def shards_of(folder: Folder) -> list[Path]:
    """The tar files with scenes, in order."""
    if packed(folder):
        return sorted(folder.data.glob("*.tar"))
    return [block / SAMPLES for block in block_folders(folder)]


def spans_of(path: Path, scenes: int) -> Iterator[Span]:
    """The scenes of a tar file by groups, from the headers of its members alone.

    Raises:
        InputError: no tar file, or a damaged one.
    """
    start, keys = 0, []
    try:
        with tarfile.open(path, "r:") as tar:
            for member in tar:
                key = split_name(member.name)[0]
                if not keys or key != keys[-1]:
                    if len(keys) == scenes:
                        yield Span(path, start, tuple(keys))
                        keys = []
                    if not keys:
                        start = member.offset
                    keys.append(key)
    except (tarfile.TarError, OSError) as error:
        raise InputError(f"{path}: no whole tar file: {error}") from None
    if keys:
        yield Span(path, start, tuple(keys))


def scenes_of(span: Span, suffixes: Container[str] | None = None) -> Iterator[tuple[str, dict[str, bytes]]]:
    """The key and the files (by suffix) of each scene of a span, one scene in memory at a time.

    Args:
        span: where they lie.
        suffixes: which files are read; None: all. A scene without any of them is passed over.
    """
    left, key, files = len(span.keys), "", {}
    with open(span.path, "rb") as file:
        file.seek(span.start)
        with tarfile.open(fileobj=file, mode="r:") as tar:
            for member in tar:
                name, suffix = split_name(member.name)
                if files and name != key:
                    yield key, files
                    files, left = {}, left - 1
                    if not left:
                        return
                if suffixes is None or suffix in suffixes:
                    content = tar.extractfile(member)
                    key, files[suffix] = name, content.read() if content else b""
    if files:
        yield key, files


def split_name(name: str) -> tuple[str, str]:
    """Key and suffix of a member of a shard: all before and all after its first dot."""
    key, _, suffix = name.rpartition("/")[2].partition(".")
    return key, suffix


def _plain(row: dict[str, Any]) -> dict[str, Any]:
    """A row with the fields of its structs that are there."""
    for name in ("grades", "gates"):
        if row.get(name) is not None:
            row[name] = {field: value for field, value in dict(row[name]).items() if value is not None}
    return row
