"""Results of a family: tables, plots made from them, notes, and what was wrong; as JSON files."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

SCHEMA = "sceneweaver.benchmark/1"


@dataclass(frozen=True)
class Column:
    """A column: key in the rows, heading, and how to write it (a name in ``markdown.FORMS``)."""

    key: str
    label: str
    form: str = "text"


@dataclass
class Table:
    """Rows of plain numbers and texts. The first ``keys`` columns say what a row is about.

    ``detail``: for the JSON file only, too long to print.
    """

    name: str
    title: str
    columns: list[Column]
    rows: list[dict[str, Any]] = field(default_factory=list)
    keys: int = 1
    detail: bool = False


@dataclass(frozen=True)
class Plot:
    """A picture of a table: columns ``y`` over column ``x`` as lines, or as bars when ``x`` is a text.

    ``series``: a column whose values each get a line of their own. ``log``: both axes are logarithmic; ``log_x``: x is.
    ``page``: the page of results shows it.
    """

    name: str
    title: str
    table: str
    x: str
    y: tuple[str, ...]
    series: str | None = None
    log: bool = False
    log_x: bool = False
    page: bool = False


@dataclass
class Result:
    """What a family found. Any entry in ``failures`` means that an answer was wrong."""

    family: str
    title: str
    about: str
    tables: list[Table] = field(default_factory=list)
    plots: list[Plot] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    machine: dict[str, Any] = field(default_factory=dict)
    options: dict[str, Any] = field(default_factory=dict)
    seconds: float = 0.0

    def add(self, name: str, title: str, columns: Sequence[Column], **options: Any) -> Table:
        """Start a table."""
        self.tables.append(Table(name, title, list(columns), **options))
        return self.tables[-1]

    def table(self, name: str) -> Table:
        """The table of that name."""
        return next(t for t in self.tables if t.name == name)

    def save(self, folder: Path) -> Path:
        """Write ``<family>.json``."""
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{self.family}.json"
        path.write_text(json.dumps({"schema": SCHEMA, **asdict(self)}, indent=1, allow_nan=False) + "\n", "utf-8")
        return path

    @classmethod
    def load(cls, path: Path) -> Result:
        """Read what `save` wrote.

        Raises:
            ValueError: the file is something else.
        """
        data = json.loads(path.read_text("utf-8"))
        if not isinstance(data, dict) or data.pop("schema", None) != SCHEMA:
            raise ValueError(f"{path.name} is no result of a benchmark ({SCHEMA})")
        data["tables"] = [Table(**{**t, "columns": [Column(**c) for c in t["columns"]]}) for t in data["tables"]]
        data["plots"] = [Plot(**{**p, "y": tuple(p["y"])}) for p in data["plots"]]
        return cls(**data)
