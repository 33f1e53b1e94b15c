"""Objectives: wire length of blocks beside sequence-pair annealing, and rooms."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from benchmarks.audit import audit
from benchmarks.blocks import block_problem
from benchmarks.external.sequence_pair import anneal
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.timing import timed, warm
from sceneweaver.layout import ObjectiveTerm, objective_of
from sceneweaver.scene import Scene

SEARCH, OURS, RIVAL = "search alone", "sceneweaver", "sequence-pair annealing"
RIVAL_SECONDS = 40.0
CPU, GPU = (8, 750_000), (4_096, 40_000)  # candidates and moves of each: less than the time of the rival
ROOMS = {
    "bedroom": [
        ObjectiveTerm("wire_length", ("bed", "wardrobe", "door")),
        ObjectiveTerm("exposed_wall", weight=0.5),
        ObjectiveTerm("light", ("armchair", "floor-lamp"), weight=5.0),
    ],
}

BLOCKS = (
    Column("problem", "problem"),
    Column("method", "method"),
    Column("seconds", "seconds", "number"),
    Column("processor", "CPU seconds", "number"),
    Column("candidates", "candidates", "count"),
    Column("moves", "moves in all", "count"),
    Column("valid", "valid", "share"),
    Column("mean", "mean of the seeds [m]", "number"),
    Column("best", "best of the seeds [m]", "number"),
)
IN_ROOMS = (
    Column("room", "room"),
    Column("before", "search: best", "number"),
    Column("after", "minimised: best", "number"),
    Column("mean_before", "search: mean", "number"),
    Column("mean_after", "minimised: mean", "number"),
    Column("seconds", "seconds", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Measure."""
    result = Result(
        "objectives",
        "Objectives",
        "What is minimised over valid layouts: quality next to time, with a rival in the same run.",
    )
    _blocks(settings, judge, result)
    _rooms(settings, judge, result)
    return result


def _blocks(settings: Settings, judge: Judge, result: Result) -> None:
    table = result.add("blocks", "Wire length of 30 blocks with 45 nets at 70 % of the floor", BLOCKS, keys=2)
    candidates, moves = GPU if settings.device.startswith("cuda") else CPU
    candidates, moves = settings.size(candidates, 2), 2_000 if settings.quick else moves
    seconds, seeds = (1.0, 1) if settings.quick else (RIVAL_SECONDS, settings.count or 3)
    for number in range(1 if settings.quick else 2):
        problem = block_problem(settings.seed + number)
        scene, terms, name = problem.scene, problem.terms, f"blocks {settings.seed + number}"
        warm(scene, settings, objective=terms, moves=100)
        for method, options in ((SEARCH, {}), (OURS, {"objective": terms, "moves": moves})):
            found, valid, began, worked = [], [], time.perf_counter(), time.process_time()
            for seed in range(seeds):
                solution, _ = timed(scene, settings, candidates=candidates, seed=seed, **options)
                audit(solution, judge, result, f"{name} {method} seed {seed}", settings.out)
                value = objective_of(scene, terms, solution.poses)[solution.status == 0]
                found.append(float(value.min(initial=np.inf)))
                valid.append(len(value) / candidates)
            spent = (time.perf_counter() - began, time.process_time() - worked)
            many = candidates * (moves + moves // 5) if options else 0
            table.rows.append(_row(name, method, spent, seeds, candidates, many, float(np.mean(valid)), found))
        packings, began, worked = [], time.perf_counter(), time.process_time()
        for seed in range(seeds):
            packings.append(anneal(problem, seed, seconds, time.process_time))
        spent = (time.perf_counter() - began, time.process_time() - worked)
        good = [np.isfinite(p.length) and judge(scene, p.poses[None])[0].valid for p in packings]
        many, lengths = sum(p.moves for p in packings) // seeds, [p.length for p in packings]
        table.rows.append(_row(name, RIVAL, spent, seeds, 1, many, float(np.mean(good)), lengths))
    result.notes.append(
        f"The rival gets {seconds:g} s of processor time for each seed, on one core, and all of its time is annealing; "
        "seconds are for one seed, with the search for valid layouts. Kernels are compiled before."
    )


def _row(
    name: str,
    method: str,
    spent: tuple[float, float],
    seeds: int,
    candidates: int,
    moves: int,
    valid: float,
    found: list,
) -> dict[str, Any]:
    return {
        "problem": name,
        "method": method,
        "seconds": spent[0] / seeds,
        "processor": spent[1] / seeds,
        "candidates": candidates,
        "moves": moves,
        "valid": valid,
        "mean": float(np.mean(found)),
        "best": float(np.min(found)),
    }


def _rooms(settings: Settings, judge: Judge, result: Result) -> None:
    table = result.add("rooms", "Objectives of rooms", IN_ROOMS)
    candidates = settings.size(64, 4)
    for name, terms in ROOMS.items():
        scene = Scene.example(name)
        warm(scene, settings, objective=terms, moves=100)
        plain, _ = timed(scene, settings, candidates=candidates, seed=settings.seed)
        before = objective_of(scene, terms, plain.poses)[plain.status == 0]
        options = {"objective": terms} | ({"moves": 500} if settings.quick else {"moves": 100_000})
        solution, seconds = timed(scene, settings, candidates=candidates, seed=settings.seed, **options)
        audit(solution, judge, result, name, settings.out)
        after = solution.objective
        row = {"room": name, "before": float(before.min()), "after": float(np.nanmin(after)), "seconds": seconds}
        table.rows.append(row | {"mean_before": float(before.mean()), "mean_after": float(np.nanmean(after))})
