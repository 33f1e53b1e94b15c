"""Warm throughput: distinct fully valid layouts a second, and the time to the first valid one."""

from __future__ import annotations

import statistics
from typing import Any

from benchmarks import rooms
from benchmarks.audit import audit
from benchmarks.families import tenbox
from benchmarks.families.quality import OURS
from benchmarks.judging import Judge
from benchmarks.results import Column, Plot, Result
from benchmarks.rivals import Rival, batch_size, present, solve
from benchmarks.settings import Settings
from benchmarks.signature import count_distinct
from benchmarks.starts import blind, random_poses
from benchmarks.timing import timed, warm
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import Scene

USUAL = ("bedroom-small", "office-20", "restaurant-60")
RUNS = 3
TRIES = 20  # calls until there is a valid layout

COLUMNS = (
    Column("room", "room"),
    Column("system", "system"),
    Column("seconds", "seconds", "number"),
    Column("valid", "fully valid", "share"),
    Column("distinct", "distinct", "count"),
    Column("distinct_rate", "distinct / s", "number"),
    Column("rate", "valid / s", "number"),
    Column("first", "first valid [s]", "number"),
    Column("candidates", "candidates", "count"),
    Column("slowest", "slowest run [s]", "number"),
    Column("claimed", "status valid", "share"),
    Column("judged", "judged", "count"),
    Column("exceptions", "exceptions", "count"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Time warm calls; all that they call valid is judged outside of the time."""
    about = (
        "Warm calls from starts drawn from the relations: the best of three runs with different seeds, and what that "
        "run reached. Distinct layouts differ by their signature (see Quality). Judging is not in the time. First "
        "valid: the time until a call with few candidates has returned a valid layout (median of three)."
    )
    result = Result("throughput", "Throughput", about)
    table = result.add("throughput", "Throughput by room", COLUMNS, keys=2)
    rivals = present(settings, result.notes)
    for name in rooms.chosen(settings, USUAL):
        table.rows.append(_ours(result, settings, judge, name))
        table.rows += [_theirs(rival, settings, judge, name) for rival in rivals]
    result.notes.append(
        f"First valid: {_few(settings)} candidates a call. Judged and exceptions are of all three runs."
    )
    result.notes.append("Rivals: one run from random starts, with as many candidates as suit them.")
    tenbox.add_table(result, settings, judge, rivals)
    title = "Distinct fully valid layouts per second"
    result.plots.append(Plot("throughput", title, "throughput", "room", ("distinct_rate",), "system", log=True))
    return result


def _few(settings: Settings) -> int:
    return settings.size(max(16, 2 * cores()), 8)


def _ours(result: Result, settings: Settings, judge: Judge, name: str) -> dict[str, Any]:
    scene, count = blind(rooms.load(name)), rooms.candidates(settings, name)
    warm(scene, settings)
    seeds = range(settings.seed, settings.seed + RUNS)
    runs = [timed(scene, settings, candidates=count, seed=seed) for seed in seeds]
    firsts = [t for t in (_first(settings, scene, seed) for seed in seeds) if t is not None]
    rows = []
    for (solution, seconds), seed in zip(runs, seeds, strict=True):
        found = audit(solution, judge, result, f"{name} sample seed {seed}", settings.out)
        good = found.agreed
        distinct, _ = count_distinct(scene, solution.poses[good])
        row = {"room": name, "system": OURS, "candidates": count, "seconds": seconds}
        row |= {"claimed": len(found.valid) / count, "judged": len(found.judged), "exceptions": found.exceptions}
        row |= {"valid": len(good) / count, "rate": len(good) / seconds}
        rows.append(row | {"distinct": distinct, "distinct_rate": distinct / seconds})
    best = max(rows, key=lambda row: row["distinct_rate"])
    totals = {key: sum(row[key] for row in rows) for key in ("judged", "exceptions")}
    slowest = max(row["seconds"] for row in rows)
    return best | totals | {"slowest": slowest, "first": statistics.median(firsts) if len(firsts) == RUNS else None}


def _first(settings: Settings, scene: Scene, seed: int) -> float | None:
    """Seconds until a call has returned a valid layout; None when none did."""
    taken = 0.0
    for k in range(TRIES):
        solution, seconds = timed(scene, settings, candidates=_few(settings), seed=seed + 1000 * (k + 1))
        taken += seconds
        if (solution.status == 0).any():
            return taken
    return None


def _theirs(rival: Rival, settings: Settings, judge: Judge, name: str) -> dict[str, Any]:
    scene = rooms.load(name)
    count = batch_size(rival, settings, len(scene.objects))
    poses, seconds = solve(rival, scene, random_poses(scene, count, settings.seed), settings.seed, settings.device)
    good = [i for i, o in enumerate(judge(scene, poses)) if o.valid]
    distinct, _ = count_distinct(scene, poses[good])
    return {
        "room": name,
        "system": rival.name,
        "candidates": count,
        "seconds": seconds,
        "judged": count,
        "valid": len(good) / count,
        "distinct": distinct,
        "distinct_rate": distinct / seconds,
        "rate": len(good) / seconds,
    }
