"""``python -m benchmarks layout_bench``: freeze Layout Bench, tell its tiers, take over better layouts from results.

``--best`` takes the best layouts that the judge finds valid out of folders of results, of `bench run` as well;
``--tiers`` tells the tier of each problem by folders of the protocol's results; ``--freeze`` makes every split anew and
writes the manifest. The problems of "test" need ``--seed-file``.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.console import console
from sceneweaver import bench
from sceneweaver.bench.protocol import BUDGETS, SOLVED, read_budgets
from sceneweaver.bench.quality import judge_all
from sceneweaver.problems import ProblemCase, layout_bench

SECOND = max(BUDGETS)  # [s] of processor time in which the search solves a problem of the first tier
SEARCH = "search"


def main(words: Sequence[str]) -> int:
    """Do what was asked for."""
    p = argparse.ArgumentParser(prog="python -m benchmarks layout_bench", description=__doc__)
    p.add_argument("--seed-file", type=Path, help="the secret of the problems that are held back")
    p.add_argument("--best", type=Path, nargs="+", default=[], help="folders of results to take better layouts from")
    p.add_argument("--tiers", type=Path, nargs="+", default=[], help="folders of the protocol's results")
    p.add_argument("--freeze", action="store_true", help="write the manifest of Layout Bench")
    options = p.parse_args(words)
    splits = {split: layout_bench.make(split) for split in ("dev", "tuning")}
    if options.seed_file is not None:
        splits["test"] = layout_bench.make("test", options.seed_file)
    for folder in options.best:
        splits = {split: improved(cases, folder) for split, cases in splits.items()}
    tiers = {name: row["tier"] for split in ("dev", "test") for name, row in layout_bench.rows(split).items()}
    if options.tiers:
        tiers |= measured(splits, options.tiers)
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
        claim, best = run.last("best_objective"), case.best_objective or np.inf
        if claim is None or not claim < best:
            continue
        layout = np.frombuffer(run.last("layout"), dtype="<f4").reshape(-1, 4)
        valid, value = case.judge(layout)
        if valid and value is not None and value < best:
            found[case.name] = replace(case, best_objective=value, best_layout=layout)
    return list(found.values())


def measured(splits: dict[str, list[ProblemCase]], folders: Sequence[Path]) -> dict[str, str]:
    """Tiers of the problems that there are results of.

    "solved": the search is near enough to the best known objective after `SECOND` of processor time, from any seed;
    "hard": some method is at the end of a run; else "open".
    """
    cases = {case.name: case for split in ("dev", "test") for case in splits.get(split, []) if case.feasible}
    near, found = 1.0 / (1.0 + max(SOLVED)), {}
    for folder in folders:
        runs = [run for run in bench.read_runs(folder) if run.key[1] in cases]
        in_a_second = bench.read_about(folder)["settings"]["clock"] == "cpu" and SECOND in read_budgets(folder)
        for budget in (SECOND, None):
            read = runs if budget is None else [run.at(budget) for run in runs if run.key[0] == SEARCH and in_a_second]
            for key, one in judge_all(read, cases, folder).items():
                tier = "open" if one.quality < near else "hard" if budget is None else "solved"
                found[key[1]] = min(found.get(key[1], "open"), tier, key=layout_bench.TIERS.index)
    return found
