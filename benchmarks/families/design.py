"""From a sentence to a room: the ten kinds of rooms of the SceneWeaver paper, each with several seeds."""

from __future__ import annotations

from statistics import fmean
from typing import Any

from benchmarks import parallel
from benchmarks.designs import PAPER, designed, dominance, needed_reached, on_meshes, relations_per_object
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings

GRADES = ("realism", "functionality", "layout", "completion")

COLUMNS = (
    Column("room", "room"),
    Column("objects", "#Obj", "number"),
    Column("paper", "paper", "number"),
    Column("out", "#OB", "number"),
    Column("colliding", "#CN", "number"),
    Column("dropped", "dropped", "number"),
    Column("hard", "hard", "share"),
    Column("soft", "soft", "share"),
    Column("relations", "rel./obj", "number"),
    Column("top", "largest kind", "share"),
    Column("walkable", "walkable", "share"),
    Column("reachable", "needed reached", "share"),
    *(Column(name, name.capitalize(), "number") for name in GRADES),
    Column("seconds", "seconds", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Design every room, judge it on its true meshes, and put the means beside the paper's counts."""
    del judge  # works on meshes, which its processes do not have
    result = Result(
        "design",
        "From a sentence to a room",
        '"Design me a <room>" for the ten kinds of rooms of the SceneWeaver paper; means over seeds. #OB and #CN are '
        "objects out of bounds and colliding pairs on the true meshes; grades are the symbolic critic's.",
    )
    means = result.add("rooms", "Means", COLUMNS)
    each = result.add("seeds", "Each seed", (COLUMNS[0], Column("seed", "seed", "count"), *COLUMNS[1:]), keys=2)
    each.detail = True
    names = settings.kinds or tuple(PAPER)[: 1 if settings.quick else None]
    seeds = range(settings.seed, settings.seed + (1 if settings.quick else 3))
    each.rows += parallel.each(_row, [(name, settings, seed) for name in names for seed in seeds], settings.jobs)
    for name in names:
        rows = [row for row in each.rows if row["room"] == name]
        keys = [c.key for c in COLUMNS if c.key not in ("room", "paper")]
        means.rows.append(
            {"room": name, "paper": PAPER.get(name), **{key: fmean(row[key] for row in rows) for key in keys}}
        )
    result.failures += [f"{row['room']} {row['seed']}: {row['fault']}" for row in each.rows if row["fault"]]
    return result


def _row(name: str, settings: Settings, seed: int) -> dict[str, Any]:
    made, seconds = designed(name, settings, seed)
    report = on_meshes(made.scene)
    contradicts = made.report.valid and not report.valid
    hard, soft = report.relations.hard, report.relations.soft
    return {
        "room": name,
        "seed": seed,
        "objects": float(report.placed),
        "paper": PAPER.get(name),
        "out": report.out_of_bounds,
        "colliding": report.collisions,
        "dropped": report.dropped,
        "hard": hard.satisfied / max(1, hard.total),
        "soft": soft.satisfied / max(1, soft.total),
        "relations": relations_per_object(made.scene),
        "top": dominance(made.scene),
        "walkable": report.walkable_share or 0.0,
        "reachable": needed_reached(made.scene),
        **{grade: made.review.grades.get(grade, 0.0) for grade in GRADES},
        "seconds": seconds,
        "fault": "valid by parts, not by meshes" if contradicts else "",
    }
