"""What every data set has beside its data: statistics, licences, card, Croissant metadata, checksums."""

from __future__ import annotations

import json
from typing import Any

from sceneweaver.scene import write_atomic

from ..folder import Folder
from ..spec import Spec
from ..statistics import statistics
from .card import card
from .checksums import checksums_of, write_checksums
from .croissant import croissant
from .licences import licences, licences_text
from .tables import read_schema, read_table, table_of

LONG = ("assets", "asset_ids", "scene")
"""Columns that statistics leave out, and that most of a table consists of."""


def finish(folder: Folder, spec: Spec) -> None:
    """Write what follows from the data and the index of a data set; checksums come last.

    All of it is a function of these files and the specification, without times.
    """
    numbers = _numbers(folder, spec)
    used = licences(folder)
    write_atomic(folder.meta / "statistics.json", _json(numbers))
    write_atomic(folder.path / "LICENSES.md", licences_text(spec, used))
    write_atomic(folder.path / "README.md", card(folder, spec, numbers, used))
    sums = checksums_of(folder)
    write_atomic(folder.path / "croissant.json", _json(croissant(folder, spec, numbers, used, sums)))
    write_checksums(folder, sums)


def _numbers(folder: Folder, spec: Spec) -> dict[str, Any]:
    """Statistics of the scenes; of layouts those of their programs, and how many layouts there are."""
    table = table_of(folder, spec)
    names = [name for name in read_schema(table).names if name not in LONG]
    if spec.product == "scenes":
        return statistics(read_table(table, names))
    rows = ({**row, "room": row["program"]} for row in read_table(table, names))
    size = sum(path.stat().st_size for path in folder.data.glob("*.parquet"))
    layouts = sum(row["layouts"] or 0 for row in read_table(table, ["layouts"]))
    return {**statistics(rows), "layouts": layouts, "bytes": size}


def _json(data: object) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"
