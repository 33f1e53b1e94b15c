"""``python -m benchmarks layout_bench``: freeze Layout Bench, measure its tiers, take over better layouts from results.

``--tiers`` runs the search in processes side by side, first for a second of two cores, then for longer, and tells the
tier of each problem; ``--best`` takes the best layouts that the judge finds valid out of result files; ``--freeze``
makes every split anew and writes the manifest. The problems of "test" need ``--seed-file``.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.console import console
from sceneweaver import bench
from sceneweaver.bench.quality import quality_of
from sceneweaver.problems import ProblemCase, layout_bench

COUNTS = (16, 64)  # candidates that the search is given for the first tier
SECOND = 2.0  # [s] of processor time: a second of two cores
LONG = 60.0  # [s] of processor time, after which a problem is open
SEEDS = 2
WITHIN = 0.05  # of the best known objective: solved


def main(words: Sequence[str]) -> int:
    """Do what was asked for."""
    p = argparse.ArgumentParser(prog="python -m benchmarks layout_bench", description=__doc__)
    p.add_argument("--seed-file", type=Path, help="the secret of the problems that are held back")
    p.add_argument("--best", type=Path, nargs="+", default=[], help="folders of results to take better layouts from")
    p.add_argument("--tiers", type=Path, help="folder of the runs that tell the tiers; begun or gone on with")
    p.add_argument("--long", type=float, default=LONG, help=f"CPU seconds of the longer runs (default: {LONG:g})")
    p.add_argument("--long-methods", default="search", help="methods of the longer runs (default: search)")
    p.add_argument("--jobs", type=int, default=1, help="processes side by side (default: 1)")
    p.add_argument("--freeze", action="store_true", help="write the manifest of Layout Bench")
    options = p.parse_args(words)
    splits = {split: layout_bench.make(split) for split in ("dev", "tuning")}
    if options.seed_file is not None:
        splits["test"] = layout_bench.make("test", options.seed_file)
    for folder in options.best:
        splits = {split: improved(cases, folder) for split, cases in splits.items()}
    tiers = {name: row["tier"] for split in ("dev", "test") for name, row in layout_bench.rows(split).items()}
    if options.tiers is not None:
        tiers |= measured(splits, options)
    if options.freeze:
        if "test" not in splits:
            p.error("--freeze needs --seed-file: the hash of test is part of the manifest")
        layout_bench.freeze(splits, tiers)
    for split in ("dev", "test"):
        found = [tiers.get(case.name, "open") for case in splits.get(split, []) if case.feasible]
        console.print(split, {tier: found.count(tier) for tier in layout_bench.TIERS if tier in found})
    return 0


def improved(cases: list[ProblemCase], folder: Path) -> list[ProblemCase]:
    """The problems with the best layouts of a folder of results, where the judge finds those valid."""
    found = {case.name: case for case in cases}
    for run in bench.read_runs(folder):
        case = found.get(run.key[1])
        if case is None or not case.objective or not run.last("layout") or run.last("problem_hash") != case.hash:
            continue
        layout = np.frombuffer(run.last("layout"), dtype="<f4").reshape(-1, 4)
        valid, value = case.judge(layout)
        if valid and value is not None and value < (case.best_objective or np.inf):
            found[case.name] = replace(case, best_objective=value, best_layout=layout)
    return list(found.values())


def measured(splits: dict[str, list[ProblemCase]], options: Any) -> dict[str, str]:
    """Tiers: "solved" by the search in a second of two cores, "hard" in a longer run of some method, else "open"."""
    cases = [case for split in ("dev", "test") for case in splits.get(split, []) if case.feasible]
    found: dict[str, str] = {case.name: "open" for case in cases}
    rounds = [("solved", ["search"], count, SECOND, f"{count}") for count in COUNTS]
    rounds.append(("hard", options.long_methods.split(","), COUNTS[0], options.long, f"long-{options.long:g}"))
    for tier, methods, count, seconds, folder in rounds:
        left = [case for case in cases if found[case.name] == "open"]
        if not left or seconds <= 0:
            continue
        settings = bench.Settings(candidates=count, seconds=seconds, clock="cpu", limit=20 * seconds + 120)
        path = options.tiers / folder
        bench.run(methods, left, path, seeds=SEEDS, settings=settings, isolate=True, jobs=options.jobs, progress=say)
        known = {case.name: case for case in cases}
        for run in bench.read_runs(path):
            case = known.get(run.key[1])
            if case is not None and run.last("problem_hash") == case.hash and quality_of(run, case) >= 1.0 - WITHIN:
                found[case.name] = tier if found[case.name] == "open" else found[case.name]
    return found


def say(done: int, total: int, row: Any) -> None:
    """A line for each run."""
    value = "" if row.best_objective is None else f", objective {row.best_objective:.1f} of {row.known_objective:.1f}"
    text = f"{done}/{total} {row.method} {row.problem} {row.seed}: {row.valid:.0%} valid{value} {row.reason}"
    console.print(text, markup=False, highlight=False)
