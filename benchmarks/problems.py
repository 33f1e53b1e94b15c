"""``python -m benchmarks problems``: freeze the zoo, measure how hard it is, write the page's table."""

from __future__ import annotations

import argparse
import re
import time
from collections.abc import Sequence
from typing import Any

import numpy as np

from benchmarks.console import console
from benchmarks.problem_list import made
from benchmarks.settings import ROOT
from sceneweaver.layout import refine
from sceneweaver.problems import ProblemCase, families, layout_bench, load, names, verify
from sceneweaver.problems.store import freeze, manifest, measured, record
from sceneweaver.verify import check

PAGE = ROOT / "docs" / "problems.md"
RUNS = (("search", "random"), ("adam", "random"), ("projection", "perturbed"))
LARGE = 150  # objects, from which on fewer layouts are tried
SEEDS = 4  # of the search, where the witness has energy left
LIMIT = 30.0  # [s] of a run
BEGIN, END = "<!-- zoo: written by a command -->", "<!-- end -->"


def main(words: Sequence[str]) -> int:
    """Do what was asked for; 1 when a problem is not in order."""
    p = argparse.ArgumentParser(prog="python -m benchmarks problems", description=__doc__)
    p.add_argument("--freeze", action="store_true", help="make every problem anew and write the zoo")
    p.add_argument("--measure", nargs="*", metavar="NAME", help="measure difficulty and best energy (default: of all)")
    p.add_argument("--missing", action="store_true", help="measure only what was not measured yet")
    p.add_argument("--candidates", type=int, default=32, help="layouts a run (default: 32)")
    p.add_argument("--device", default="cpu", help="cpu, cuda or cuda:k (default: cpu)")
    p.add_argument("--page", action="store_true", help="write the table of docs/problems.md")
    options = p.parse_args(words)
    if options.freeze:
        freeze(made())
    if options.measure is not None:
        known = {name: row for name, row in measured().items() if manifest().get(name, {}).get("hash") == row["hash"]}
        for name in options.measure or names():
            if not (options.missing and name in known):
                known[name] = measure(load(name), options.candidates, options.device)
                record(known)
                console.print(name, summary(known[name]), markup=False, highlight=False)
    if options.page:
        text = PAGE.read_text("utf-8")
        table = "\n".join([BEGIN, "", *page_lines(), "", END])
        PAGE.write_text(
            re.sub(f"{re.escape(BEGIN)}.*{re.escape(END)}", lambda _: table, text, flags=re.DOTALL), "utf-8"
        )
    for name in names():
        verify(load(name))
    return 0


def measure(case: ProblemCase, candidates: int, device: str) -> dict[str, Any]:
    """Share of valid layouts by some optimisers, and the lowest energy of a layout that the judge finds valid."""
    count = candidates if len(case.scene.objects) < LARGE else max(candidates // 8, 1)
    difficulty: dict[str, Any] = {}
    best: tuple[float, np.ndarray] | None = None
    problem = case.compile(device)
    tries: list[tuple[str, str, np.ndarray | None]]
    tries = [(optimizer, start, case.start(start, count, 0)) for optimizer, start in RUNS if start in case.starts]
    if case.witness is not None:
        best = (float(problem.energy(case.witness[None])[0]), np.array(case.witness))
        if best[0] > 0:  # there is something to gain, from the witness as well
            tries += [("search", "", case.start("random", count, seed)) for seed in range(1, SEEDS)]
            tries += [(optimizer, "", None) for optimizer in ("adam", "langevin", "search")]
    for optimizer, start, poses in tries:
        if poses is None:  # from the best layout so far
            assert best is not None
            poses = np.repeat(best[1][None], count, axis=0)
        began = time.process_time()
        found = refine(case.scene, init=poses, candidates=count, optimizer=optimizer, device=device, time_limit=LIMIT)
        seconds = time.process_time() - began
        valid = found.status == 0
        if start:
            difficulty[optimizer] = {
                "start": start,
                "candidates": count,
                "valid": round(float(valid.mean()), 3),
                "seconds": round(seconds, 2),
            }
        if valid.any():
            layouts = np.asarray(found.poses)[valid].astype(np.float32)
            energy = np.asarray(problem.energy(layouts))
            lowest = int(energy.argmin())
            if (best is None or energy[lowest] < best[0]) and check(case.layout(layouts[lowest]), walkable=False).valid:
                best = (float(energy[lowest]), layouts[lowest])
    row: dict[str, Any] = {"hash": case.hash, "difficulty": difficulty}
    if best is not None:
        row["best_energy"] = round(best[0], 6)
        if case.witness is not None and not np.array_equal(best[1], case.witness):
            row["best"] = [[float(str(np.float32(v))) for v in pose] for pose in best[1]]
    return row


def summary(row: dict[str, Any]) -> str:
    """A line about what was measured."""
    shares = [f"{name} {r['valid']:.0%} in {r['seconds']:.1f} s" for name, r in row["difficulty"].items()]
    return ", ".join(shares) + (f"; best {row['best_energy']:.4g} m" if "best_energy" in row else "")


def zoo_names(family: str | None = None) -> tuple[str, ...]:
    """Names of the problems, of one family or all, that are measured here: Layout Bench has a protocol of its own."""
    apart = set(layout_bench.names())
    return tuple(name for name in names(family) if name not in apart)


def page_lines() -> list[str]:
    """The families and all problems but those of Layout Bench, as tables in Markdown."""
    lines = ["| family | problems | objects | what it is |", "| --- | ---: | ---: | --- |"]
    for family, about in families().items():
        sizes = [manifest()[name]["objects"] for name in zoo_names(family)]
        if sizes:
            lines.append(f"| {family} | {len(sizes)} | {min(sizes)} to {max(sizes)} | {about} |")
    kinds = [optimizer for optimizer, _ in RUNS]
    lines += ["", "| problem | objects | tightness | relations | best energy [m] | " + " | ".join(kinds) + " |"]
    lines.append("| --- | ---: | ---: | ---: | ---: |" + " ---: |" * len(kinds))
    for name in zoo_names():
        case = load(name)
        best = "-" if case.best_energy is None else f"{case.best_energy:.4g}"
        shares = [f"{case.difficulty[k]['valid']:.0%}" if k in case.difficulty else "-" for k in kinds]
        tightness = f"{case.facts['tightness']:.2f}" if case.feasible else case.certificate["kind"].replace("_", " ")
        cells = [name, str(len(case.scene.objects)), tightness, str(len(case.scene.relations)), best, *shares]
        lines.append(f"| {' | '.join(cells)} |")
    return lines
