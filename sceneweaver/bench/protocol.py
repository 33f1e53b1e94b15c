"""The protocol of Layout Bench: seeds, budgets, limits; runs of methods on its problems that can be gone on with."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sceneweaver.io import load_json
from sceneweaver.problems import ProblemCase, layout_bench, load
from sceneweaver.scene import InputError

from .entries import Method, find_methods
from .quality import Judged, judge_all
from .results import Key, Run, read_about, read_runs
from .runner import Progress, run
from .settings import Settings

BUDGETS = (0.1, 0.3, 1.0)
"""Seconds at which a run is read, the last its length: of processor time on a CPU, of the wall clock on a GPU."""
SEEDS = 5
CANDIDATES, ON_GPU = 16, 1024
MEMORY = 8.0  # [GiB] that a run may take
LIMIT = 20.0, 10.0
"""After which a run is killed, with what compiles [s]: so much, and so many times its budget."""
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


def methods_without(optimizers: Sequence[Any], names: Sequence[str]) -> list[Method]:
    """The methods without some of them, by name.

    Raises:
        InputError: as for `find_methods`; no method has such a name.
    """
    methods = find_methods(optimizers)
    for name in names:
        if name not in {method.name for method in methods}:
            raise InputError(f'without: no method is called "{name}"')
    return [method for method in methods if method.name not in names]


def tuned_methods(optimizers: Sequence[Any], tuned: Path | str | None = None) -> list[Method]:
    """The methods, with the settings that tuning wrote into a file; those that are not in it keep their own."""
    methods = find_methods(optimizers)
    chosen = {} if tuned is None else load_json(Path(tuned))["methods"]
    return [Method(m.name, m.source, chosen.get(m.name, {}).get("settings", {})) for m in methods]


def settings_of(budgets: Sequence[float], device: str, candidates: int | None = None) -> Settings:
    """What a run of the protocol is made with."""
    gpu, longest = device.startswith("cuda"), max(budgets)
    return Settings(
        candidates=candidates or (ON_GPU if gpu else CANDIDATES),
        seconds=longest,
        budgets=tuple(sorted(budgets)),
        enough=True,
        clock="wall" if gpu else "cpu",
        device=device,
        limit=LIMIT[0] + LIMIT[1] * longest,
        memory=None if gpu else MEMORY,
    )


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
    """Run methods on problems, the first seed of all first; what is there is not run again.

    Args:
        optimizers: see `find_methods`.
        cases: see `problems_of`.
        out: folder of the results.
        budgets: where each run is read [s]; it goes on until the longest.
        seeds, device, candidates: of the protocol unless said.
        jobs: processes side by side; on GPUs one to each, or times are not those of a method alone.
        minutes: after which it ends with what is done; started again it goes on.
        tuned: the file that `tune` wrote.
        progress: told of every run.

    Returns:
        Whether all runs are done.

    Raises:
        InputError: as for `run`.
    """
    until = math.inf if minutes is None else time.monotonic() + 60.0 * minutes
    methods = tuned_methods(optimizers, tuned)
    _compile_kernels(device)
    run(
        methods, cases, out, seeds=seeds, settings=settings_of(budgets, device, candidates), isolate=True, jobs=jobs,
        until=until, progress=progress,
    )  # fmt: skip
    there = {r.key for r in read_protocol(out, required=False)}
    return all((m.name, c.name, seed) in there for m in methods for c in cases for seed in range(seeds))


def _compile_kernels(device: str) -> None:
    """Compile what optimisers launch before any run: workers side by side would do it within the limits of theirs."""
    from sceneweaver.layout.devices import pick_devices
    from sceneweaver.layout.warming import kernel_modules
    from sceneweaver.runtime.compiling import load

    name = pick_devices(device)[0]
    load(name, kernel_modules(name))


def read_protocol(out: Path | str, *, required: bool = True) -> list[Run]:
    """The runs of a folder.

    Raises:
        InputError: there are none.
    """
    try:
        return read_runs(out)
    except InputError:
        if not required:
            return []
        raise InputError(f"{out}: no results of Layout Bench; sceneweaver bench layout-bench run writes some") from None


def read_budgets(out: Path | str) -> list[float]:
    """The budgets [s] at which the runs of a folder are read, the shortest first."""
    settings = read_about(out)["settings"]
    return sorted({*settings.get("budgets", ()), settings["seconds"]})


def whole_seeds(runs: Sequence[Run]) -> list[Run]:
    """The runs of the seeds that every method has of every problem; all of them, where there is no such seed."""
    rows: dict[int, set[tuple[str, str]]] = {}
    for each in runs:
        rows.setdefault(each.key[2], set()).add(each.key[:2])
    everything = set().union(*rows.values())
    whole = {seed for seed, there in rows.items() if len(there) == len(everything)}
    return [each for each in runs if each.key[2] in whole or not whole]


def verdicts(
    out: Path | str, runs: Sequence[Run], budgets: Sequence[float], cases: Mapping[str, ProblemCase]
) -> dict[float, dict[Key, Judged]]:
    """What the judge says of the runs at each budget."""
    return {budget: judge_all([each.at(budget) for each in runs], cases, out) for budget in budgets}
