"""Openable: designs of the ten kinds of rooms of the SceneWeaver paper; how many doors, drawers and lids open."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any

from benchmarks import parallel
from benchmarks.designs import LIBRARY, PAPER, designed
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.verify import openable

GOAL = 0.95
"""Least share of doors, drawers and lids that open to 90 %; of those that are needed all do."""

COLUMNS = (
    Column("room", "room"),
    Column("links", "links", "count"),
    Column("open", "open", "count"),
    Column("share", "share", "share"),
    Column("needed", "needed, blocked", "count"),
    Column("seconds", "measured in [s]", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Design every room and open everything in it."""
    del judge  # how far things open is measured on its own
    result = Result(
        "openable",
        "What opens",
        "Designs of the ten kinds of rooms of the SceneWeaver paper: doors, drawers and lids of furniture, doors of "
        "rooms, that open to 90 % of their range before something is in their way, and how many do not that a "
        "room needs. Sums over seeds; seconds are of one measurement with drawn assets.",
    )
    table = result.add("rooms", "By room", COLUMNS)
    each = result.add("seeds", "Each seed", (COLUMNS[0], Column("seed", "seed", "count"), *COLUMNS[1:]), keys=2)
    each.detail = True
    names = settings.kinds or tuple(PAPER)[: 1 if settings.quick else None]
    seeds = range(settings.seed, settings.seed + (1 if settings.quick else 3))
    each.rows += parallel.each(_row, [(name, settings, seed) for name in names for seed in seeds], settings.jobs)
    table.rows += [_joined(name, [row for row in each.rows if row["room"] == name]) for name in names]
    table.rows.append(every := _joined("all", each.rows))
    for row in each.rows:
        result.failures += [f"{row['room']} {row['seed']}: {text}" for text in row["wrong"]]
    if not settings.quick and every["share"] < GOAL:
        result.failures.append(f"{every['share']:.1%} open, goal {GOAL:.0%}")
    return result


def _row(name: str, settings: Settings, seed: int) -> dict[str, Any]:
    scene = designed(name, settings, seed)[0].scene
    openable.measure(scene, LIBRARY.load)  # assets are drawn
    began = time.perf_counter()
    found = openable.measure(scene, LIBRARY.load)
    seconds = time.perf_counter() - began
    wrong = [violation.detail for violation in openable.violations(scene, found)]
    return {
        "room": name,
        "seed": seed,
        "wrong": wrong,
        **_counts(len(found), sum(x.opens for x in found)),
        "needed": len(wrong),
        "seconds": seconds,
    }


def _joined(name: str, rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    counts = _counts(sum(row["links"] for row in rows), sum(row["open"] for row in rows))
    seconds = sum(row["seconds"] for row in rows) / max(1, len(rows))
    return {"room": name, **counts, "needed": sum(row["needed"] for row in rows), "seconds": seconds}


def _counts(links: int, opened: int) -> dict[str, Any]:
    return {"links": links, "open": opened, "share": opened / links if links else 1.0}
