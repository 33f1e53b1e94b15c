"""The files of a comparison: whole or not at all, and what lets a run go on where it was stopped."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from sceneweaver.datasets.tables import arrow, write_table
from sceneweaver.io import InputError, lines_unpacked, open_writable, parse_json, reason, whole, write_atomic
from sceneweaver.io.messages import clean
from sceneweaver.runtime.deadline import Deadline

from .compare import Comparison
from .judge import SceneRow
from .metrics import METRICS
from .page import page

ROWS = "scenes.jsonl"
"""A line for each scene that was judged, as it was: with these a run goes on."""


def read_known(folder: Path) -> dict[str, SceneRow]:
    """The rows that an earlier run into a folder left, by their keys; a line that was being written is left out."""
    path, found = folder / ROWS, dict[str, SceneRow]()
    if not path.is_file():
        return found
    for line in lines_unpacked(path):
        try:
            row = SceneRow.from_dict(parse_json(line, unique=False))
        except (InputError, AttributeError, TypeError, ValueError, KeyError):  # cut off while it was written
            continue
        if row.key and not row.error:
            found[row.key] = row
    return found


@contextmanager
def row_file(folder: Path) -> Iterator[IO[bytes]]:
    """The file that rows are added to, a line at a time; one that was cut off is ended first.

    Raises:
        InputError: it cannot be written.
    """
    path = folder / ROWS
    try:
        with open_writable(path, "ab") as file:
            if path.stat().st_size:
                file.write(b"\n")
            yield file
    except OSError as error:
        raise InputError(f"{clean(str(path))}: cannot be written ({reason(error)}); choose another place") from None


def add_row(file: IO[bytes], row: SceneRow) -> None:
    """Write a row at once."""
    file.write(json.dumps(row.to_dict(), ensure_ascii=False, allow_nan=False).encode() + b"\n")


def write_comparison(found: Comparison, folder: Path, stem: str, deadline: Deadline | None = None) -> list[Path]:
    """Write ``<stem>.json``, ``<stem>.parquet`` and ``<stem>.html``; each is whole or the one before.

    Args:
        found: what is written.
        folder: where; it must be there.
        stem: the first part of the names.
        deadline: after which no more pictures are drawn.

    Raises:
        InputError: a file cannot be written.
        MissingDependencyError: pyarrow is missing, which Parquet needs.
    """
    paths = [folder / f"{stem}.{suffix}" for suffix in ("json", "parquet", "html")]
    write_atomic(paths[0], found.to_json())
    with whole(paths[1]) as draft:
        write_table(draft, table_rows(found), schema())
    write_atomic(paths[2], page(found, deadline))
    return paths


def schema() -> Any:
    """The columns of the table: one row a scene, a column a figure (its value in the scene), and why it is missing."""
    pa = arrow()
    texts = [(name, pa.string()) for name in ("system", "scene", "format", "room", "prompt", "error")]
    figures = [(metric.key, pa.float64()) for metric in METRICS if not metric.of_set]
    lists = [
        ("depths_mm", pa.list_(pa.float64())),
        ("categories", pa.list_(pa.struct([("name", pa.string()), ("count", pa.int32())]))),
        ("missing", pa.list_(pa.struct([("figure", pa.string()), ("reason", pa.string())]))),
        ("notes", pa.list_(pa.string())),
    ]
    more = [("sizes_assumed", pa.int32()), ("seconds", pa.float64())]
    return pa.schema([*texts, *figures, *lists, *more])


def table_rows(found: Comparison) -> Iterator[dict[str, Any]]:
    """The rows of the table."""
    for system in found.systems:
        for row in system.rows:
            yield {
                **{name: getattr(row, name) for name in ("system", "scene", "format", "room", "prompt", "error")},
                **{metric.key: row.value(metric.key) for metric in METRICS if not metric.of_set},
                "depths_mm": list(row.depths),
                "categories": [{"name": name, "count": count} for name, count in row.categories.items()],
                "missing": [{"figure": key, "reason": why} for key, why in row.missing.items()],
                "notes": list(row.notes),
                "sizes_assumed": row.guessed,
                "seconds": row.seconds,
            }
