"""The one terminal that everything prints to."""

from __future__ import annotations

import sys

from rich.console import Console
from rich.table import Table as Grid
from rich.text import Text

from benchmarks.markdown import WIDTH, blocks
from benchmarks.results import Result

console = Console(highlight=False, width=None if sys.stdout.isatty() else WIDTH)
SHOWN = 20  # failures of a family


def say(text: str) -> None:
    """Print a line of progress."""
    console.print(text, style="dim", markup=False)


def print_result(result: Result) -> None:
    """Print tables, notes and failures of a family."""
    for table in result.tables:
        if table.detail:
            continue
        title = table.title
        for columns, cells in blocks(table, console.width):
            grid = Grid(title=Text(title), title_justify="left")
            for column in columns:
                grid.add_column(Text(column.label), justify="left" if column.form == "text" else "right", no_wrap=True)
            for row in cells:
                grid.add_row(*map(Text, row))
            console.print(grid)
            title = f"{table.title} (continued)"
    for note in result.notes:
        console.print(note, markup=False)
    for failure in result.failures[:SHOWN]:
        console.print(f"WRONG: {failure}", style="bold red", markup=False)
    if len(result.failures) > SHOWN:
        console.print(f"... and {len(result.failures) - SHOWN} more", style="bold red")
