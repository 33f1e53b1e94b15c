"""The one terminal that everything prints to."""

from __future__ import annotations

from rich.console import Console
from rich.table import Table as Grid

from benchmarks.markdown import show
from benchmarks.results import Result

console = Console(highlight=False)


def say(text: str) -> None:
    """Print a line of progress."""
    console.print(text, style="dim", markup=False)


def print_result(result: Result) -> None:
    """Print tables, notes and failures of a family."""
    for table in result.tables:
        if table.detail:
            continue
        grid = Grid(title=table.title, title_justify="left")
        for column in table.columns:
            grid.add_column(column.label, justify="left" if column.form == "text" else "right")
        for row in table.rows:
            grid.add_row(*(show(row.get(c.key), c.form) for c in table.columns))
        console.print(grid)
    for note in result.notes:
        console.print(note, markup=False)
    for failure in result.failures:
        console.print(f"WRONG: {failure}", style="bold red", markup=False)
