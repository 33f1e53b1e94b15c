"""``sceneweaver bench``: what the commands do."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import typer

from .output import list_files, print_json
from .streams import no_chatter


def run_bench(
    optimizers: str, problems: str, out: Path, *, seeds: int, isolate: bool, as_json: bool, **settings: Any
) -> int:
    """Run optimisers on problems into a folder; a run that failed is a row of the results."""
    from sceneweaver.bench import Settings, run
    from sceneweaver.layout.stepwise import OPTIMIZERS

    sys.path.insert(0, os.getcwd())  # for optimisers by import path, as `python -m` has it

    # A handle of its own: `no_chatter` takes the usual one away.
    with open(os.dup(2), "w", encoding="utf-8") as terminal, no_chatter():

        def progress(done: int, total: int, row: Any) -> None:
            how = row.reason or f"{row.valid:.0%} valid, {row.distinct} distinct"
            text = f"{done}/{total} {row.method} {row.problem} seed {row.seed}: {how}, {row.seconds:.2f} s"
            print(text, file=terminal, flush=True)

        path = run(
            _words(optimizers) or list(OPTIMIZERS),
            _words(problems),
            out,
            seeds=seeds,
            settings=Settings(**settings),
            isolate=isolate,
            progress=None if as_json else progress,
        )
    return _tables(out, None, as_json, [path])


def run_compare(source: Path, *, target: str, family: str | None, common: bool, as_json: bool) -> int:
    """Print the tables of results."""
    return _tables(source, target, as_json, [], family, common)


def run_plot(source: Path, out: Path, *, target: str, form: str, family: str | None, common: bool) -> int:
    """Draw curves and profiles of results."""
    from sceneweaver.bench import Target, plot

    list_files(plot(_runs(source, family, common), out, target=Target.parse(target), form=form))
    return 0


def _words(text: str) -> list[str]:
    return [word for word in text.replace(",", " ").split() if word]


def _runs(source: Path, family: str | None, common: bool) -> list[Any]:
    from sceneweaver.bench import read_runs
    from sceneweaver.bench.curves import in_common
    from sceneweaver.scene import InputError

    runs = [run for run in read_runs(source) if family is None or run.last("family") == family]
    if not runs:
        raise InputError(f'family: {source} has no runs of "{family}"')
    some = in_common(runs) if common else runs
    if not some:
        raise InputError(f"{source}: no problem was run by all methods")
    return some


def _tables(
    source: Path,
    target: str | None,
    as_json: bool,
    files: list[Path],
    family: str | None = None,
    common: bool = False,
) -> int:
    from sceneweaver.bench import Target, compare, markdown, read_about

    runs, aim = _runs(source, family, common), Target.parse(target or "valid:0.5")
    if as_json:
        lines = [line.to_dict() for line in compare(runs, aim)]
        print_json({**read_about(source), "target": str(aim), "methods": lines, "files": [str(f) for f in files]})
        return 0
    typer.echo(markdown(runs, aim))
    list_files(files)
    return 0
