"""Many layouts of a room let loose at once, beside MuJoCo C on one core: how fast, and do they agree?"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from benchmarks.layouts import Case
from benchmarks.results import Column, Result
from sceneweaver.physics.batch import run
from sceneweaver.physics.settle import LITTLE
from sceneweaver.physics.worlds import SimulationResult, Template, merged, run_c, shifts, steps_of

GOALS = {"box": 40.0, "hull": 20.0}
AGREEMENT = 0.98


COLUMNS = (
    Column("shapes", "bodies"),
    Column("backend", "by"),
    Column("worlds", "worlds", "count"),
    Column("bodies", "free", "count"),
    Column("geoms", "parts", "count"),
    Column("seconds", "seconds", "number"),
    Column("each", "ms a world", "number"),
    Column("core", "MuJoCo C, ms", "number"),
    Column("timed", "timed", "count"),
    Column("speedup", "times faster", "number"),
    Column("goal", "goal", "number"),
    Column("sample", "compared", "count"),
    Column("agree", "agree", "share"),
    Column("far", "moved > 1 cm", "share"),
    Column("far_both", "of those, both", "share"),
    Column("agree_product", "agree with settle", "share"),
    Column("contacts", "contacts a world", "number"),
    Column("constraints", "rows, most", "count"),
    Column("grown", "grown", "count"),
    Column("overflow", "overflow", "count"),
    Column("diverged", "diverged", "count"),
    Column("call", "call [s]", "number"),
    Column("first", "first call [s]", "number"),
)


def measure(
    case: Case,
    device: str,
    sample: int = 64,
    seconds: float = 3.0,
    threads: int = 1,
    budget: float = 40.0,
) -> Iterator[dict[str, Any]]:
    """Rows of results, one for each of ``GOALS``.

    Args:
        case: Models and poses.
        device: Where the batch is stepped.
        sample: How many worlds MuJoCo C steps too; those of them that fit into ``budget`` seconds on one core with
            nothing beside them are timed, the others are shared by ``threads``.
        seconds: Simulated time.
        threads: Of MuJoCo C.
        budget: See ``sample``.
    """
    steps, start = steps_of(seconds), case.poses
    some = np.sort(np.random.default_rng(0).permutation(len(start))[:sample])
    hulls = case.template("hull")
    truth = shifts(hulls, start[some], run_c(hulls, start[some], steps, threads).poses)
    for shapes, goal in GOALS.items():
        template = case.template(shapes)
        began = time.perf_counter()
        run(template, start, min(steps, 60), device, None, threads)
        first = time.perf_counter() - began
        began = time.perf_counter()
        batch, kind, _ = run(template, start, steps, device, None, threads)
        call = time.perf_counter() - began
        alone, core, timed = _alone(template, start[some], steps, threads, budget)
        moved = shifts(template, start, batch.poses)
        theirs = shifts(template, start[some], alone.poses)
        sound = ~(batch.overflow | batch.diverged)[some]
        ours = np.where(sound[:, None], moved[some], np.inf) > LITTLE
        c, agreed = theirs > LITTLE, _agreed(ours, theirs > LITTLE)
        yield {
            "shapes": shapes,
            "backend": kind,
            "worlds": len(start),
            "bodies": len(case.free),
            "geoms": int(template.model.ngeom),
            "dofs": int(template.model.nv),
            "seconds": batch.seconds,
            "each": 1e3 * batch.seconds / len(start),
            "core": 1e3 * core,
            "timed": timed,
            "speedup": core * len(start) / batch.seconds,
            "goal": goal,
            "sample": len(some),
            "agree": agreed,
            "agree_product": _agreed(ours, truth > LITTLE),
            "c_agrees_product": _agreed(c, truth > LITTLE),
            "far": float(c.mean()),
            "far_both": float((c & ours).sum() / (c | ours).sum()) if (c | ours).any() else 1.0,
            "apart": float(np.median(np.abs(moved[some] - theirs)[sound])) if sound.any() else None,
            "contacts": batch.contacts,
            "constraints": batch.constraints,
            "room": batch.room,
            "grown": batch.grown,
            "overflow": int(batch.overflow.sum()),
            "diverged": int(batch.diverged.sum()),
            "c_diverged": int(alone.diverged.sum()),
            "first": first,
            "call": call,
            "problem": batch.problem,
        }


def _alone(
    template: Template, start: np.ndarray, steps: int, threads: int, budget: float
) -> tuple[SimulationResult, float, int]:
    """(outcome of all, seconds a world on one core that has nothing else to do, worlds timed)."""
    run_c(template, start[:1], min(steps, 10))
    parts, spent, done = [], 0.0, 0
    while done < len(start) and (done == 0 or spent + spent / done < budget):
        parts.append(run_c(template, start[done : done + 1], steps))
        spent, done = spent + parts[-1].seconds, done + 1
    if done < len(start):
        parts.append(run_c(template, start[done:], steps, threads))
    return merged(parts), spent / done, done


def _agreed(one: np.ndarray, two: np.ndarray) -> float:
    return float((one == two).mean()) if one.size else 1.0


def tabulate(rows: Iterator[dict[str, Any]] | Sequence[dict[str, Any]]) -> Result:
    """The rows of ``measure`` as a result of the family ``physics``."""
    result = Result(
        "physics",
        "Physics of many layouts",
        "Layouts of one designed bedroom let loose for 3 s; in every second one, one free thing in five is lifted by "
        "up to 4 cm. MuJoCo C steps a sample of the same worlds with the same settings; what is timed of it runs "
        "alone on one core. Agree: both say, or neither says, that a thing moved more than 1 cm. Agree with settle: "
        "the same against convex hulls by MuJoCo C, which is what `settle_many` runs on a CPU. On a CPU both sides are "
        "MuJoCo C, one of them on all cores.",
    )
    table = result.add("worlds", "Boxes and convex hulls", COLUMNS)
    for row in rows:
        table.rows.append(row)
        if row["agree"] < AGREEMENT:
            result.failures.append(f"{row['shapes']}: agrees in {row['agree']:.1%} of the cases, goal {AGREEMENT:.0%}")
        if row["problem"]:
            result.notes.append(row["problem"])
    result.notes.append(
        "Grown: how often the run began anew with room for more contacts. Times are of stepping, with copies "
        "to and from the device; call: with bringing the model there, too; first call: before anything is compiled."
    )
    return result
