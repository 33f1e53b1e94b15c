"""Results of commands: files that appear whole or not at all, progress on stderr, a few lines on stdout."""

from __future__ import annotations

import contextlib
import json
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sceneweaver.io import locked, sweep, temporary_folder
from sceneweaver.io.messages import printable_line
from sceneweaver.runtime.compiling import watched_by
from sceneweaver.scene import InputError

if TYPE_CHECKING:
    from sceneweaver.verify import Report

Progress = Callable[[int, int, int, float], None]

LONGEST = 1000
"""Characters of a line about what is wrong, from "sceneweaver: " on."""

MOST_LISTED = 20
"""Violations that are listed on a terminal; files and --json have them all."""


@contextlib.contextmanager
def staged(folder: Path, names: Sequence[str]) -> Iterator[Path]:
    """A temporary folder whose files ``names`` are moved to ``folder`` when the block ends without an error.

    Before the block runs, it is certain that ``folder`` is there, can be written to, and is written by nobody else.
    After an error it is as before.

    Raises:
        InputError: when ``folder`` is a file or another process writes there, one of the names is a folder, or nothing
            can be written.
    """
    new = [place for place in (folder, *folder.parents) if not place.exists()]
    if not (new[-1].parent if new else folder).is_dir():
        raise InputError(f"{folder}: there is a file of this name, or of a folder above; choose another place")
    for name in names:
        if (folder / name).is_dir():
            raise InputError(f"{folder / name}: this is a folder; remove it or choose another place")
    done = False
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with locked(folder / names[0], f"--out: {folder}"):
            sweep(folder)
            with temporary_folder(folder) as temporary:
                yield temporary
                for name in names:
                    if (temporary / name).exists():
                        (folder / name).parent.mkdir(parents=True, exist_ok=True)
                        os.replace(temporary / name, folder / name)
        done = True
    except OSError as error:
        raise InputError(f"{folder}: cannot be written ({error.strerror or error}); choose another place") from None
    finally:
        if not done:
            with contextlib.suppress(OSError):
                for place in new:
                    place.rmdir()


@contextlib.contextmanager
def progress_bar(text: str, total: int) -> Iterator[Progress | None]:
    """A bar on stderr for a terminal; None, which means no progress, for anything else."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[valid]} valid"),
        TimeElapsedColumn(),
    )
    # A handle of its own: `no_chatter` takes the usual one away.
    with open(os.dup(sys.stderr.fileno()), "w", encoding="utf-8") as terminal:
        console = Console(file=terminal)
        with Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False) as bar:
            task = bar.add_task(text, total=total, valid=0)

            def report(done: int, total: int, valid: int, best: float) -> None:
                bar.update(task, completed=done, total=total, valid=valid, description=text)

            with watched_by(lambda state: bar.update(task, description=str(state))):
                yield report


def complain(text: str) -> str:
    """Say what is wrong as one printable line on stderr, whatever the file says that it quotes; gives the line."""
    line = printable_line(text, LONGEST - len("sceneweaver: "))
    typer.echo(f"sceneweaver: {line}", err=True)
    return line


def print_json(data: dict[str, Any]) -> None:
    """One JSON object on stdout."""
    typer.echo(json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False))


def headline(name: str, valid: bool, facts: str) -> None:
    """The line that says whether a scene is valid."""
    typer.secho("valid" if valid else "not valid", fg="green" if valid else "red", bold=True, nl=False)
    typer.echo(f"  {name}: {facts}")


def relations_line(report: Report) -> str:
    """How many relations hold."""
    hard, soft = report.relations.hard, report.relations.soft
    text = f"{hard.satisfied} of {hard.total} hard relations hold"
    return text + (f", {soft.satisfied} of {soft.total} soft" if soft.total else "")


def list_violations(report: Report) -> None:
    """What is wrong, a line each; soft relations last."""
    found = sorted(report.violations, key=lambda v: not v.hard)
    for violation in found[:MOST_LISTED]:
        typer.echo(f"  {violation.kind:<15}  {violation.detail or ', '.join(violation.objects)}")
    if len(found) > MOST_LISTED:
        typer.echo(f"  and {len(found) - MOST_LISTED} more")


def list_files(paths: Sequence[Path]) -> None:
    """Where the results are."""
    for path in paths:
        typer.echo(f"  {path}")
