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

Results = Annotated[
    list[Path], typer.Argument(metavar="DIR...", help="Folders of results, one a machine.", show_default=False)
]
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
    without: Annotated[
        str, typer.Option(metavar="A,B", help="Names of methods to leave out.", show_default=False)
    ] = "",
    split: Split = "dev",
    seed_file: SeedFile = None,
    only: Only = "",
    budgets: Annotated[
        str, typer.Option(metavar="S,S", help="Seconds at which a run is read, the last its length.")
    ] = "0.1,0.3,1",
    seeds: Seeds = 5,
    candidates: Candidates = None,
    tuned: Annotated[
        Path | None, typer.Option(metavar="FILE", help="The tuned.json of `tune`.", show_default=False)
    ] = None,
    jobs: Jobs = 1,
    minutes: Minutes = None,
    device: Device = "cpu",
) -> int:
    """Run methods, and read every run at each budget. What is there is not run again.

    It ends with 5 when the time was over before all was done.
    """
    from sceneweaver.bench.protocol import methods_without, problems_of, run_protocol

    sys.path.insert(0, os.getcwd())
    cases = problems_of(split, seed_file, _words(only))
    with open(os.dup(2), "w", encoding="utf-8") as terminal, no_chatter():
        complete = run_protocol(
            methods_without(_words(optimizers), [name.strip() for name in without.split(",") if name.strip()]),
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
    seconds: Annotated[float, typer.Option(help="Budget of a run.")] = 1.0,
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
def compare(sources: Results, seed_file: SeedFile = None, as_json: Json = False) -> int:
    """Print the leaderboard of each folder of results; every layout is judged anew."""
    from sceneweaver.bench.board import board_markdown, leaderboard

    with no_chatter():
        cases = _cases(seed_file)
        boards = [leaderboard(source, cases) for source in sources]
    if as_json:
        from .output import print_json

        print_json({"boards": boards})
    else:
        typer.echo("\n\n".join(board_markdown(data) for data in boards))
    return 0


@app.command("verify")
def verify(sources: Results, seed_file: SeedFile = None, as_json: Json = False) -> int:
    """Judge the layouts of results anew; 3 when a run says what is not so."""
    from sceneweaver.bench.protocol import read_budgets, read_protocol, verdicts

    faults, total = [], 0
    with no_chatter():
        cases = _cases(seed_file)
        for source in sources:
            runs = read_protocol(source)
            total += len(runs)
            for seconds, rows in verdicts(source, runs, read_budgets(source), cases).items():
                for (method, problem, seed), one in rows.items():
                    if one.fault:
                        row = {"method": method, "problem": problem, "seed": seed, "seconds": seconds}
                        faults.append({"source": str(source), **row, "fault": one.fault})
    wrong = len({(row["source"], row["method"], row["problem"], row["seed"]) for row in faults})
    if as_json:
        from .output import print_json

        print_json({"runs": total, "faults": faults})
    else:
        typer.echo(f"{total - wrong} of {total} runs are as they say")
        for row in faults:
            typer.echo(f"  {row['method']} {row['problem']} seed {row['seed']}, {row['seconds']:g} s: {row['fault']}")
    return NOT_VALID if faults else 0


@app.command("page")
def page(
    sources: Results,
    into: Annotated[Path, typer.Option(metavar="FILE", help="A page with marks for the leaderboard.")],
    pictures: Annotated[
        list[Path] | None,
        typer.Option(
            "--picture", metavar="PNG", help="Where the curves over time go; once for each folder.", show_default=False
        ),
    ] = None,
    seed_file: SeedFile = None,
) -> int:
    """Write the leaderboards of results into a page, between its marks, and draw the curves over time."""
    from sceneweaver.bench.board import board_markdown, leaderboard, plot_anytime, write_page
    from sceneweaver.scene import InputError

    if pictures and len(pictures) != len(sources):
        raise InputError(f"picture: {len(pictures)} for {len(sources)} folders; give one for each")
    parts = []
    with no_chatter():
        cases = _cases(seed_file)
        for k, source in enumerate(sources):
            parts.append(board_markdown(leaderboard(source, cases)))
            if pictures:
                plot_anytime(source, pictures[k], cases)
                parts.append(f"![Quality over time]({os.path.relpath(pictures[k], into.parent)})")
        write_page(into, "\n\n".join(parts))
    from .output import list_files

    list_files([into, *(pictures or [])])
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
