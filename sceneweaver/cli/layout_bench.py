"""``sceneweaver bench layout-bench``: the protocol of Layout Bench as commands."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .exit_codes import NOT_VALID, UNFINISHED
from .options import Device, Json
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.problems import ProblemCase

app = typer.Typer(name="layout-bench", help="Layout Bench: run, tune, compare, verify and the page of its protocol.")

Results = Annotated[Path, typer.Argument(metavar="DIR", help="The folder of results.", show_default=False)]
Out = Annotated[Path, typer.Option("--out", "-o", metavar="DIR", help="Folder for the results.", show_default=False)]
Optimizers = Annotated[
    str, typer.Option(metavar="A,B", help="As for `sceneweaver bench run`; several with commas.", show_default=False)
]
Only = Annotated[str, typer.Option(metavar="A,B", help="Only these names, families or tiers.", show_default=False)]
Split = Annotated[str, typer.Option(metavar="dev|test", help="Which problems.")]
SeedFile = Annotated[
    Path | None, typer.Option(metavar="FILE", help="The secret of the problems of test.", show_default=False)
]
Seeds = Annotated[int, typer.Option(min=1, help="How many seeds, from 0.")]
Jobs = Annotated[int, typer.Option(min=1, help="Processes side by side.")]
Minutes = Annotated[
    float | None, typer.Option(help="Minutes after which it ends; started again it goes on.", show_default=False)
]
Candidates = Annotated[
    int | None, typer.Option(min=1, help="Layouts moved at once (default: 16, on a GPU 1024).", show_default=False)
]


@app.command("run")
def run(
    out: Out,
    optimizers: Optimizers = "search,adam,langevin,tempering,lbfgs,projection",
    split: Split = "dev",
    seed_file: SeedFile = None,
    only: Only = "",
    budgets: Annotated[str, typer.Option(metavar="S,S", help="Seconds of a run.")] = "1,10,60",
    seeds: Seeds = 5,
    candidates: Candidates = None,
    tuned: Annotated[
        Path | None, typer.Option(metavar="FILE", help="The tuned.json of `tune`.", show_default=False)
    ] = None,
    jobs: Jobs = 1,
    minutes: Minutes = None,
    device: Device = "cpu",
) -> int:
    """Run methods with every budget; 5 when the time was over before all was done. What is there is not run again."""
    from sceneweaver.bench.protocol import problems_of, run_protocol

    sys.path.insert(0, os.getcwd())
    cases = problems_of(split, seed_file, _words(only))
    with open(os.dup(2), "w", encoding="utf-8") as terminal, no_chatter():
        complete = run_protocol(
            _words(optimizers),
            cases,
            out,
            budgets=_numbers(budgets),
            seeds=seeds,
            device=device,
            candidates=candidates,
            jobs=jobs,
            minutes=minutes,
            tuned=tuned,
            progress=_teller(terminal),
        )
    typer.echo("all runs are done" if complete else "not all runs are done; the same command goes on")
    return 0 if complete else UNFINISHED


@app.command("tune")
def tune(
    out: Out,
    optimizers: Optimizers = "search,adam,langevin,tempering,lbfgs,projection",
    only: Only = "",
    trials: Annotated[int, typer.Option(min=1, help="Settings tried of each method, its own among them.")] = 16,
    seconds: Annotated[float, typer.Option(help="Budget of a run.")] = 10.0,
    seeds: Seeds = 1,
    candidates: Candidates = None,
    jobs: Jobs = 1,
    device: Device = "cpu",
) -> int:
    """Choose settings of each method on problems that no split has, with the same budget for all: tuned.json."""
    from sceneweaver.bench.protocol import problems_of
    from sceneweaver.bench.tuning import tune as tune_all

    sys.path.insert(0, os.getcwd())
    cases = problems_of("tuning", None, _words(only))
    with open(os.dup(2), "w", encoding="utf-8") as terminal, no_chatter():
        path = tune_all(
            _words(optimizers),
            cases,
            out,
            trials=trials,
            seconds=seconds,
            seeds=seeds,
            candidates=candidates,
            jobs=jobs,
            device=device,
            progress=_teller(terminal),
        )
    from .output import list_files

    list_files([path])
    return 0


@app.command("compare")
def compare(source: Results, seed_file: SeedFile = None, as_json: Json = False) -> int:
    """Print the leaderboard of results; every layout is judged anew."""
    from sceneweaver.bench.board import board_markdown, leaderboard

    with no_chatter():
        data = leaderboard(source, _cases(seed_file))
    if as_json:
        from .output import print_json

        print_json(data)
    else:
        typer.echo(board_markdown(data))
    return 0


@app.command("verify")
def verify(source: Results, seed_file: SeedFile = None, as_json: Json = False) -> int:
    """Judge the layouts of results anew; 3 when a run says what is not so."""
    from sceneweaver.bench.protocol import read_protocol, verdicts

    with no_chatter():
        found = verdicts(source, read_protocol(source), _cases(seed_file))
    faults = [
        {"seconds": seconds, "method": key[0], "problem": key[1], "seed": key[2], "fault": one.fault}
        for seconds, rows in found.items()
        for key, one in rows.items()
        if one.fault
    ]
    total = sum(map(len, found.values()))
    if as_json:
        from .output import print_json

        print_json({"runs": total, "faults": faults})
    else:
        typer.echo(f"{total - len(faults)} of {total} runs are as they say")
        for row in faults:
            typer.echo(f"  {row['method']} {row['problem']} seed {row['seed']}, {row['seconds']:g} s: {row['fault']}")
    return NOT_VALID if faults else 0


@app.command("page")
def page(
    source: Results,
    into: Annotated[Path, typer.Option(metavar="FILE", help="A page with marks for the leaderboard.")],
    picture: Annotated[
        Path | None, typer.Option(metavar="PNG", help="Where the curves over time go.", show_default=False)
    ] = None,
    seed_file: SeedFile = None,
) -> int:
    """Write the leaderboard of results into a page, between its marks, and draw the curves over time."""
    from sceneweaver.bench.board import board_markdown, leaderboard, plot_anytime, write_page

    with no_chatter():
        text = board_markdown(leaderboard(source, _cases(seed_file)))
        if picture is not None:
            plot_anytime(source, picture)
            text += f"\n\n![Quality over time]({os.path.relpath(picture, into.parent)})"
        write_page(into, text)
    from .output import list_files

    list_files([into, *([picture] if picture is not None else [])])
    return 0


def _cases(seed_file: Path | None) -> dict[str, ProblemCase]:
    """The problems that results may be on: those published, and with the secret those of test."""
    from sceneweaver.bench.protocol import problems_of

    splits = ["dev", "tuning", *(["test"] if seed_file is not None else [])]
    return {case.name: case for split in splits for case in problems_of(split, seed_file)}


def _words(text: str) -> list[str]:
    return [word for word in text.replace(",", " ").split() if word]


def _numbers(text: str) -> list[float]:
    from sceneweaver.scene import InputError

    try:
        found = [float(word) for word in _words(text)]
    except ValueError:
        found = []
    if not found or not all(0 < value < float("inf") for value in found):
        raise InputError(f'budgets: "{text}" are no seconds above 0, with commas between them')
    return found


def _teller(terminal: Any) -> Any:
    def progress(done: int, total: int, row: Any) -> None:
        value = (
            "" if row.best_objective is None else f", objective {row.best_objective:.5g} ({row.known_objective:.5g})"
        )
        how = row.reason or f"{row.valid:.0%} valid{value}"
        text = f"{done}/{total} {row.method} {row.problem} seed {row.seed}: {how}, {row.seconds:.2f} s"
        print(text, file=terminal, flush=True)

    return progress
