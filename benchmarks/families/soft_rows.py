"""Whether what is soft makes what is hard lose: twenty mixes of soft rows, an objective, and searches without them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from benchmarks.audit import audit
from benchmarks.console import say
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.rooms import chosen, load
from benchmarks.settings import Settings
from benchmarks.soft_mixes import MIXES, TERMS, bare, defined, judgeable, mixed, movable, pairs_of
from benchmarks.timing import timed, warm
from sceneweaver.layout import ObjectiveTerm, Solution
from sceneweaver.scene import Scene

ROOMS = ("bedroom-tight", "living", "dining-round", "studio-U")
QUICK_ROOMS, QUICK_MIXES = ("bedroom-tight",), ("ten wires of weight 10", "out of the room")
CANDIDATES = 128
WIRES, WEIGHT, MOVES = 10, 10.0, 5_000
"""Of the objective: two-pin nets, what a metre of them costs, and moves of a candidate."""

COLUMNS = (
    Column("mix", "mix"),
    Column("rows", "soft rows a room", "number"),
    Column("layouts", "layouts", "count"),
    Column("without", "valid without", "share"),
    Column("with", "valid with", "share"),
    Column("lost", "valid without alone", "count"),
    Column("held", "soft rows that hold", "share"),
    Column("seconds_without", "seconds without", "number"),
    Column("seconds", "seconds with", "number"),
)
OBJECTIVES = (
    Column("room", "room"),
    Column("wires", "wires", "count"),
    Column("layouts", "layouts", "count"),
    Column("without", "valid without", "share"),
    Column("with", "valid with", "share"),
    Column("lost", "valid without alone", "count"),
    Column("seconds", "seconds with", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Refine rooms with each mix and without it, from the same starts; a candidate that the mix loses is a failure."""
    result = Result(
        "soft_rows",
        "Hard before soft",
        "Twenty mixes of soft rows that pull against what is hard: heavy nears, wires and rows that imply overlap, by "
        "relations and a term of the user's own with a scale of 1, rows that contradict each other or lead out of the "
        "room. Each room is searched with the mix and without it, with default settings and the same seeds. All that "
        "is called valid in the first run of a room is judged. A candidate that is valid without the mix alone must "
        "not be. The same for an objective, the length of ten heavy wires in each room.",
    )
    table = result.add("mixes", "Validity by mix", COLUMNS)
    rooms = chosen(settings, QUICK_ROOMS if settings.quick else ROOMS)
    seeds = range(settings.seed, settings.seed + (settings.count or 1))
    plain = {(name, seed): _solved(bare(load(name)), settings, seed) for name in rooms for seed in seeds}
    kinds = {o.category for name in rooms for o in load(name).objects if o.mount == "floor"}
    mixes = QUICK_MIXES if settings.quick else tuple(MIXES)
    for term in dict.fromkeys(map(TERMS.get, mixes)):
        with defined(term, kinds):
            for mix in mixes:
                if TERMS.get(mix) == term:
                    table.rows.append(_compared(mix, plain, settings, judge, result))
    wires = result.add("objectives", "Validity with an objective", OBJECTIVES)
    for name in rooms:
        wires.rows.append(_minimised(name, plain[name, settings.seed][0], settings, judge, result))
    result.notes.append(
        f"Rooms: {', '.join(rooms)}; {len(seeds)} seeds. A term is taken for all pairs of floor objects."
    )
    return result


def _solved(scene: Scene, settings: Settings, seed: int) -> tuple[Solution, float]:
    warm(scene, settings, "sample")
    return timed(scene, settings, candidates=settings.size(CANDIDATES, 16), seed=seed)


def _compared(
    mix: str, plain: dict[tuple[str, int], tuple[Solution, float]], settings: Settings, judge: Judge, result: Result
) -> dict[str, Any]:
    """The row of one mix; what it loses is a failure."""
    runs = []
    for (name, seed), without in plain.items():
        solution, seconds = _solved(mixed(load(name), mix), settings, seed)
        runs.append((without, (solution, seconds)))
        say(f"  {mix}, {name}, seed {seed}: {seconds:.1f} s")
        if seed == settings.seed:
            hard = replace(solution, source=judgeable(solution.source))
            audit(hard, judge, result, f"{name} with {mix}", settings.out)
    row = _row(mix, runs)
    if row["lost"] or row["with"] < row["without"]:
        result.failures.append(f"{mix}: {row['lost']} layouts are valid only without its soft rows")
    return row


def _minimised(name: str, plain: Solution, settings: Settings, judge: Judge, result: Result) -> dict[str, Any]:
    """The row of one room whose wires are to be short; what that loses is a failure."""
    scene = bare(load(name))
    terms = [ObjectiveTerm("wire_length", pair, WEIGHT) for pair in pairs_of(movable(scene), WIRES)]
    options = {"objective": terms, "moves": 500 if settings.quick else MOVES}
    warm(scene, settings, objective=terms, moves=100)
    solution, seconds = timed(scene, settings, candidates=settings.size(CANDIDATES, 16), seed=settings.seed, **options)
    audit(solution, judge, result, f"{name} with an objective", settings.out)
    before, after = plain.status == 0, solution.status == 0
    lost = int((before & ~after).sum())
    if lost:
        result.failures.append(f"{name}: {lost} layouts are valid only without an objective")
    shares = {"without": float(before.mean()), "with": float(after.mean()), "lost": lost, "seconds": seconds}
    return {"room": name, "wires": len(terms), "layouts": len(before), **shares}


def _row(mix: str, runs: list[tuple[tuple[Solution, float], tuple[Solution, float]]]) -> dict[str, Any]:
    before = np.concatenate([plain.status == 0 for (plain, _), _ in runs])
    after = np.concatenate([solution.status == 0 for _, (solution, _) in runs])
    soft = [[not r.hard for r in solution.source.relations] for _, (solution, _) in runs]
    held = np.concatenate(
        [
            solution.relations[:, rows][solution.status == 0].ravel()
            for rows, (_, (solution, _)) in zip(soft, runs, strict=True)
        ]
    )
    return {
        "mix": mix,
        "rows": float(np.mean([sum(rows) for rows in soft])),
        "layouts": len(before),
        "without": float(before.mean()),
        "with": float(after.mean()),
        "lost": int((before & ~after).sum()),
        "held": float(held.mean()) if held.size else 0.0,
        "seconds_without": sum(seconds for (_, seconds), _ in runs),
        "seconds": sum(seconds for _, (_, seconds) in runs),
    }
