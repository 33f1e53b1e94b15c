"""What other packages add to the command line: relations, terms and checks of theirs."""

from __future__ import annotations

from importlib.metadata import entry_points

import typer

GROUP = "sceneweaver.extensions"
"""Entry points whose functions are called, without arguments, before a command runs."""


def load_extensions() -> None:
    """Call them all, by name; one that is broken costs a line on stderr."""
    for point in sorted(entry_points(group=GROUP), key=lambda p: p.name):
        try:
            point.load()()
        except Exception as error:
            typer.echo(f"sceneweaver: extension '{point.name}' is left out: {error}", err=True)
