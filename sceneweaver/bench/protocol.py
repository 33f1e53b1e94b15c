"""The protocol of Layout Bench: seeds, budgets, limits; runs of methods on its problems that can be gone on with."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sceneweaver.io import load_json
from sceneweaver.problems import ProblemCase, layout_bench, load
from sceneweaver.scene import InputError

from .entries import Method, find_methods
from .quality import Judged, judge_all
from .results import Key, Run, read_runs
from .runner import Progress, run
from .settings import Settings

BUDGETS = (1.0, 10.0, 60.0)
"""Seconds of a run: of processor time on a CPU, of the wall clock on a GPU."""
SEEDS = 5
CANDIDATES, ON_GPU = 16, 1024
MEMORY = 8.0  # [GiB] of a run's process
SOLVED = (0.05, 0.01)
"""How far the objective of a valid layout may be above the best known for the problem to count as solved."""


def problems_of(split: str, seed_file: Path | str | None = None, only: Sequence[str] = ()) -> list[ProblemCase]:
    """The problems of a split that have a valid layout; ``only``: names, families and tiers.

    Raises:
        InputError: no such split, no secret, or nothing goes by a name of ``only``.
    """
    everything = (
        [load(name) for name in layout_bench.names()] if split == "dev" else layout_bench.make(split, seed_file)
    )
    cases = [case for case in everything if case.feasible]
    words = {case.name: {case.name, case.family, layout_bench.tier_of(case.name)} for case in cases}
    for word in only:
        if not any(word in each for each in words.values()):
            raise InputError(f'problems: nothing of {split} goes by "{word}"; give names, families or tiers')
    return [case for case in cases if not only or words[case.name] & set(only)]


def tuned_methods(optimizers: Sequence[Any], tuned: Path | str | None = None) -> list[Method]:
    """The methods, with the settings that tuning wrote into a file; those that are not in it keep their own."""
    methods = find_methods(optimizers)
    chosen = {} if tuned is None else load_json(Path(tuned))["methods"]
    return [Method(m.name, m.source, chosen.get(m.name, {}).get("settings", {})) for m in methods]


def settings_of(seconds: float, device: str, candidates: int | None = None) -> Settings:
    """What a run of the protocol is made with."""
    gpu = device.startswith("cuda")
    return Settings(
        candidates=candidates or (ON_GPU if gpu else CANDIDATES),
        seconds=seconds,
        clock="wall" if gpu else "cpu",
        device=device,
        limit=120.0 + 10.0 * seconds,
        memory=None if gpu else MEMORY,
    )


def folder_of(out: Path | str, seconds: float) -> Path:
    """The folder of a budget's results."""
    return Path(out) / f"{seconds:g}s"


def run_protocol(
    optimizers: Sequence[Any],
    cases: Sequence[ProblemCase],
    out: Path | str,
    *,
    budgets: Sequence[float] = BUDGETS,
    seeds: int = SEEDS,
    device: str = "cpu",
    candidates: int | None = None,
    jobs: int = 1,
    minutes: float | None = None,
    tuned: Path | str | None = None,
    progress: Progress | None = None,
) -> bool:
    """Run methods on problems with every budget, the smallest first; what is there is not run again.

    Args:
        optimizers: see `find_methods`.
        cases: see `problems_of`.
        out: folder of the results, one in it for each budget.
        budgets, seeds, device, candidates: of the protocol unless said.
        jobs: processes side by side; on a GPU one, or times are not those of a method alone.
        minutes: after which it ends with what is done; started again it goes on.
        tuned: the file that `tune` wrote.
        progress: told of every run.

    Returns:
        Whether all runs are done.

    Raises:
        InputError: as for `run`.
    """
    until = float("inf") if minutes is None else time.monotonic() + 60.0 * minutes
    methods, wanted = tuned_methods(optimizers, tuned), 0
    for seconds in sorted(budgets):
        settings, folder = settings_of(seconds, device, candidates), folder_of(out, seconds)
        wanted += len(methods) * len(cases) * seeds
        if time.monotonic() < until:
            run(
                methods, cases, folder, seeds=seeds, settings=settings, isolate=True, jobs=jobs, until=until,
                progress=progress,
            )  # fmt: skip
    names = {m.name for m in methods}, {c.name for c in cases}
    there = [r for runs in read_protocol(out, required=False).values() for r in runs]
    done = [r for r in there if r.key[0] in names[0] and r.key[1] in names[1] and r.key[2] < seeds]
    return len(done) >= wanted


def read_protocol(out: Path | str, *, required: bool = True) -> dict[float, list[Run]]:
    """The runs of each budget, the smallest first.

    Raises:
        InputError: there are none.
    """
    folders = {float(p.name[:-1]): p for p in Path(out).glob("*s") if p.is_dir() and _is_number(p.name[:-1])}
    found = {}
    for seconds, folder in sorted(folders.items()):
        try:
            found[seconds] = read_runs(folder)
        except InputError:
            continue  # begun, and nothing done
    if required and not found:
        raise InputError(f"{out}: no results of Layout Bench; sceneweaver bench layout-bench run writes some")
    return found


def _is_number(text: str) -> bool:
    try:
        return float(text) > 0
    except ValueError:
        return False


def verdicts(
    out: Path | str, results: Mapping[float, Sequence[Run]], cases: Mapping[str, ProblemCase]
) -> dict[float, dict[Key, Judged]]:
    """What the judge says of the runs of each budget."""
    return {seconds: judge_all(runs, cases, folder_of(out, seconds)) for seconds, runs in results.items()}
