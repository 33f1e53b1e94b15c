"""Results as Markdown, with lines of at most 120 characters."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from typing import Any

from benchmarks.results import Column, Result, Table

WIDTH = 120
NOTHING = "-"


def _share(value: float) -> str:
    """Per cent; only what is exactly all is 100 %, only what is exactly nothing is 0 %."""
    if value in (0.0, 1.0):
        return f"{value * 100:.0f} %"
    return f"{min(99.9, max(0.1, value * 100)):.1f} %"


def _number(value: float) -> str:
    """Three significant digits."""
    if value == 0:
        return "0"
    if abs(value) >= 100:
        return f"{value:,.0f}"
    return f"{value:#.3g}".rstrip(".") if abs(value) >= 0.001 else f"{value:.1e}"


def _millimetres(value: float) -> str:
    """Metres as millimetres; what is below a micrometre is not told apart."""
    return "< 0.001" if 0 < abs(value) < 1e-6 else _number(value * 1000)


FORMS: dict[str, Callable[[Any], str]] = {
    "text": str,
    "count": lambda v: f"{v:,d}",
    "share": _share,
    "number": _number,
    "mm": _millimetres,
    "mib": lambda v: f"{v:,.1f}",
}


def show(value: Any, form: str) -> str:
    """A cell as text."""
    return NOTHING if value is None else FORMS[form](value)


def _lines(columns: list[Column], rows: list[list[str]]) -> list[str]:
    head = "| " + " | ".join(c.label for c in columns) + " |"
    rule = "| " + " | ".join("---" if c.form == "text" else "--:" for c in columns) + " |"
    return [head, rule, *("| " + " | ".join(row) + " |" for row in rows)]


def blocks(table: Table, width: int = WIDTH) -> list[tuple[list[Column], list[list[str]]]]:
    """Columns and cells of a table; one that is too wide is continued in others that repeat its key columns."""
    cells = [[show(row.get(c.key), c.form) for c in table.columns] for row in table.rows]
    widths = [max(len(c.label), 3, *(len(r[i]) for r in cells), 0) for i, c in enumerate(table.columns)]
    keys = list(range(table.keys))
    found, block = [], list(keys)
    for i in range(table.keys, len(table.columns)):
        if len(block) > table.keys and sum(widths[j] + 3 for j in (*block, i)) + 1 > width:
            found.append(block)
            block = list(keys)
        block.append(i)
    found.append(block)
    return [([table.columns[j] for j in block], [[row[j] for j in block] for row in cells]) for block in found]


def table_lines(table: Table) -> list[str]:
    """A table as Markdown."""
    lines: list[str] = []
    for columns, cells in blocks(table):
        lines += [*_lines(columns, cells), ""]
    return lines[:-1]


def wrapped(text: str, indent: str = "") -> list[str]:
    """A paragraph or list item in short lines."""
    return textwrap.wrap(
        text,
        WIDTH,
        initial_indent=indent,
        subsequent_indent=" " * len(indent),
        break_long_words=False,
        break_on_hyphens=False,
    )


def result_lines(result: Result, level: int = 2) -> list[str]:
    """A family as Markdown, headings from ``level`` on."""
    lines = ["#" * level + f" {result.title}", "", *wrapped(result.about), ""]
    if result.failures:
        lines += [f"**{len(result.failures)} answers were wrong:**", ""]
        lines += [line for f in result.failures[:20] for line in wrapped(f, "- ")] + [""]
    for table in result.tables:
        if not table.detail and table.rows:
            lines += [*wrapped(f"{table.title}:"), "", *table_lines(table), ""]
    lines += [line for note in result.notes for line in wrapped(note, "- ")]
    return lines[:-1] if not lines[-1] else lines
