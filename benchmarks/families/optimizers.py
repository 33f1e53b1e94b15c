"""The optimisers against each other: how many candidates become valid for how much work."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from benchmarks import rooms
from benchmarks.audit import audit
from benchmarks.judging import Judge
from benchmarks.machine import resolve
from benchmarks.results import Column, Plot, Result
from benchmarks.settings import Settings
from benchmarks.starts import start
from benchmarks.tenbox import ten_boxes
from benchmarks.timing import timed
from sceneweaver.layout import refine
from sceneweaver.layout.batch import make_batch
from sceneweaver.layout.compile import compile_scene
from sceneweaver.optimizers import Monitor, load_poses, streams
from sceneweaver.optimizers import run as run_optimizer
from sceneweaver.optimizers.tempering import LEAD, POLISH, REPLICAS, parts

USUAL = ("bedroom-small", "living", "dining-round", "bedroom-tight", "office-20")
STARTS = ("random", "noisy")
BUDGETS = {
    "search": (1, 2, 4, 10),
    "adam": (50, 100, 200, 400, 1600),
    "langevin": (50, 100, 200, 400, 1600),
    "lbfgs": (50, 100, 200, 400, 1600),
    "tempering": (50, 100, 400, 1600),
}
STEPS = 400  # of ten boxes
JUDGED = 16  # of the valid ones of each run

START, OPTIMIZER = Column("start", "start"), Column("optimizer", "optimizer")
BUDGET = Column("budget", "budget", "count")
WORK = (
    Column("energies", "energies each", "count"),
    Column("valid", "status valid", "share"),
    Column("each", "ms each", "number"),
    Column("each_valid", "ms each valid one", "number"),
)
JUDGEMENT = (Column("judged", "judged", "count"), Column("exceptions", "exceptions", "count"))
OVERALL = (START, OPTIMIZER, BUDGET, *WORK, *JUDGEMENT)
MEDIAN = Column("energy", "median energy [m]", "number")
RATES = (
    OPTIMIZER,
    Column("candidates", "candidates", "count"),
    Column("steps", "steps", "count"),
    Column("energies", "energies each", "count"),
    Column("seconds", "seconds", "number"),
    Column("rate", "candidates / s", "number"),
    Column("per_second", "object energies / s", "number"),
)
BY_ROOM = (Column("room", "room"), START, OPTIMIZER, BUDGET, *WORK, MEDIAN, *JUDGEMENT)


def run(settings: Settings, judge: Judge) -> Result:
    """Refine some rooms by every optimiser with several budgets."""
    about = (
        "Candidates that become valid against the work put in, for every optimiser with several budgets (search: "
        "attempts, the others: steps), from random starts and from noisy ones (see Quality). Energies: how often the "
        "energy of all objects of a candidate is computed; the search computes those of moved objects only, so that "
        "time is what all have in common. Times are warm and hold everything from call to return."
    )
    result = Result("optimizers", "Optimizers", about)
    names = rooms.chosen(settings, USUAL)
    budgets = {name: some[:1] if settings.quick else some for name, some in BUDGETS.items()}
    cpu = resolve(settings.device) == "cpu"
    count = settings.size(128 if cpu else 4096, 8)
    rows = [
        _measure(result, settings, judge, name, kind, optimizer, budget, count)
        for kind in STARTS
        for name in names
        for optimizer, some in budgets.items()
        for budget in some
    ]
    result.add("overall", f"Over the rooms {', '.join(names)}", OVERALL, keys=3).rows = [
        _mean([r for r in rows if (r["start"], r["optimizer"], r["budget"]) == (kind, optimizer, budget)])
        for kind in STARTS
        for optimizer, some in budgets.items()
        for budget in some
    ]
    result.add("rates", "Ten boxes, optimiser alone", RATES).rows = _rates(settings, 256 if cpu else 65536)
    longest = [r for r in rows if r["budget"] == budgets[r["optimizer"]][-1]]
    result.add("rooms", "By room, the largest budgets", BY_ROOM, keys=4).rows = longest
    result.add("detail", "By room", BY_ROOM, keys=4, detail=True).rows = rows
    result.notes.append(
        f"{count} candidates a room; at most {JUDGED} valid ones of each run are judged. A step of tempering measures "
        f"{REPLICAS} replicas of a candidate; its first steps (at most {LEAD}) are a descent of each, its last "
        f"{100 * POLISH:.0f} % of the best."
    )
    result.notes.append(
        f"Ten boxes: a bedroom with 14 relations, {STEPS} steps from random starts, everything compiled and on the "
        "device. An object's energy is that of all terms that it takes part in, with its gradient."
    )
    for kind in STARTS:
        result.notes.append(_failures(longest, kind))
        _plot(result, kind)
    return result


def energies(optimizer: str, budget: int) -> int | None:
    """How often a budget computes the energy of a candidate; None for the search, which counts otherwise.

    Steps have both ends, and the layout that is kept is measured once more.
    """
    if optimizer == "search":
        return None
    if optimizer != "tempering":
        return budget + 2
    lead, tempered, polish = parts(budget)
    return REPLICAS * ((lead + 2 if lead else 0) + tempered + 1) + 1 + polish + 2


def _measure(
    result: Result, settings: Settings, judge: Judge, name: str, kind: str, optimizer: str, budget: int, count: int
) -> dict[str, Any]:
    scene, init = start(rooms.load(name), kind, count, settings.seed)
    few = init if isinstance(init, str) else init[:2]
    options = {"optimizer": optimizer, "seed": settings.seed}
    refine(scene, candidates=2, init=few, steps=1, device=settings.device, **options)
    solution, seconds = timed(scene, settings, candidates=count, init=init, steps=budget, **options)
    label = f"{name} {kind} {optimizer} {budget} seed {settings.seed}"
    found = audit(solution, judge, result, label, settings.out, most=JUDGED)
    return {
        "room": name,
        "start": kind,
        "optimizer": optimizer,
        "budget": budget,
        "energies": energies(optimizer, budget),
        "valid": len(found.valid) / count,
        "energy": float(np.median(solution.energy)),
        "each": 1e3 * seconds / count,
        "each_valid": 1e3 * seconds / len(found.valid) if len(found.valid) else None,
        "judged": len(found.judged),
        "exceptions": found.exceptions,
    }


def _rates(settings: Settings, full: int) -> list[dict[str, Any]]:
    """How fast the step-based optimisers are on ten boxes, without anything around them."""
    device, count = resolve(settings.device), settings.size(full, 8)
    steps = 20 if settings.quick else STEPS
    problem = compile_scene(ten_boxes()).room
    rows = []
    for optimizer in (name for name in BUDGETS if name != "search"):
        for budget in (20, steps):  # the first run compiles
            batch = make_batch([problem], np.zeros(count, dtype=int), device)
            load_poses(batch, np.repeat(problem.home[None], count, axis=0))
            batch.state.rng.assign(streams(settings.seed, np.arange(count)))
            began = time.perf_counter()
            run_optimizer(batch, optimizer, "random", budget, Monitor(count))  # returns energies, so all is done
            seconds = time.perf_counter() - began
        each = energies(optimizer, steps)
        row = {"optimizer": optimizer, "candidates": count, "steps": steps, "energies": each, "seconds": seconds}
        rows.append(row | {"rate": count / seconds, "per_second": count * problem.size * (each or 0) / seconds})
    return rows


def _mean(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """One budget over all rooms, each room counting the same."""
    valid, each = (float(np.mean([r[key] for r in rows])) for key in ("valid", "each"))
    return {
        **{key: rows[0][key] for key in ("start", "optimizer", "budget", "energies")},
        "valid": valid,
        "each": each,
        "each_valid": each / valid if valid else None,
        "judged": sum(r["judged"] for r in rows),
        "exceptions": sum(r["exceptions"] for r in rows),
    }


def _failures(rows: list[dict[str, Any]], kind: str) -> str:
    """Where an optimiser's largest budget leaves most candidates invalid."""
    poor = [r for r in rows if r["start"] == kind and r["valid"] < 0.5]
    if not poor:
        return f"From {kind} starts, the largest budgets solve at least half of the candidates in every room."
    texts = [f"{r['optimizer']} in {r['room']} ({100 * r['valid']:.0f} %)" for r in poor]
    return f"From {kind} starts, the largest budgets solve less than half of the candidates of: {', '.join(texts)}."


def _plot(result: Result, kind: str) -> None:
    """Success against time, one curve for each optimiser."""
    name, title = f"optimizers-{kind}", f"Valid candidates against time, from {kind} starts"
    rows = [r for r in result.table("overall").rows if r["start"] == kind]
    result.add(name, title, OVERALL, keys=3, detail=True).rows = rows
    result.plots.append(Plot(name, title, name, "each", ("valid",), series="optimizer", log_x=True, page=True))
