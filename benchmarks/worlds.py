"""Many layouts of a room let loose at once, beside MuJoCo C on one core: how fast, and do they agree?

``python -m benchmarks.worlds make FILE.npz`` writes a case: models and initial poses. ``python -m benchmarks.worlds run
FILE.npz --device cuda --out DIR`` measures it; that needs numpy, mujoco, mujoco-warp, pydantic and pyyaml only.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.layouts import Case, designed, small
from benchmarks.results import Column, Result
from sceneweaver.physics.batch import run
from sceneweaver.physics.settle import LITTLE
from sceneweaver.physics.worlds import PRODUCT, SimulationResult, Solver, Template, merged, run_c, shifts, steps_of

ROWS: tuple[tuple[str, str, Solver], ...] = (
    ("box", "product", PRODUCT),
    ("hull", "product", PRODUCT),
    ("box", "sweep and prune", Solver(broadphase="sap")),
    ("hull", "sweep and prune", Solver(broadphase="sap")),
    ("box", "conjugate gradients", Solver(method="cg")),
    ("hull", "conjugate gradients", Solver(method="cg")),
)
"""(shapes, name of the solver's settings, settings): those of ``settle``, and others to see what they would bring."""

USUAL = (0, 1)

GOALS = {"box": 40.0, "hull": 20.0}
AGREEMENT = 0.98


COLUMNS = (
    Column("shapes", "bodies"),
    Column("solver", "solver"),
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
    backend: str | None = None,
    rows: Sequence[int] = USUAL,
) -> Iterator[dict[str, Any]]:
    """Rows of results, one for each of ``ROWS``.

    Args:
        case: Models and poses.
        device: Where the batch is stepped.
        sample: How many worlds MuJoCo C steps too; those of them that fit into ``budget`` seconds on one core with
            nothing beside them are timed, the others are shared by ``threads``.
        seconds: Simulated time.
        threads: Of MuJoCo C.
        budget: See ``sample``.
        backend: As in ``settle_many``.
        rows: Numbers of the rows wanted.
    """
    steps, start = steps_of(seconds), case.poses
    some = np.sort(np.random.default_rng(0).permutation(len(start))[:sample])
    product = case.template("hull", PRODUCT)
    truth = None
    for number in rows:
        shapes, name, solver = ROWS[number]
        template = case.template(shapes, solver)
        began = time.perf_counter()
        run(template, start, min(steps, 60), device, backend, threads)  # type: ignore[arg-type]
        first = time.perf_counter() - began
        began = time.perf_counter()
        batch, kind, _ = run(template, start, steps, device, backend, threads)  # type: ignore[arg-type]
        call = time.perf_counter() - began
        alone, core, timed = _alone(template, start[some], steps, threads, budget)
        if shapes == "hull" or truth is None:
            one = alone if shapes == "hull" else run_c(product, start[some], steps, threads)
            truth = shifts(product, start[some], one.poses)
        moved = shifts(template, start, batch.poses)
        theirs = shifts(template, start[some], alone.poses)
        sound = ~(batch.overflow | batch.diverged)[some]
        ours = np.where(sound[:, None], moved[some], np.inf) > LITTLE
        c, agreed = theirs > LITTLE, _agreed(ours, theirs > LITTLE)
        yield {
            "shapes": shapes,
            "solver": name,
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
            "goal": GOALS[shapes],
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
            "unfinished": _count(batch.unfinished),
            "inexact": _count(batch.inexact),
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


def _count(mask: np.ndarray | None) -> int:
    return 0 if mask is None else int(mask.sum())


def tabulate(rows: Iterator[dict[str, Any]] | Sequence[dict[str, Any]]) -> Result:
    """The rows of ``measure`` as a result of the family ``physics``."""
    result = Result(
        "physics",
        "Physics of many layouts",
        "Layouts of one designed bedroom let loose for 3 s; in every second one, one free thing in five is lifted by "
        "up to 4 cm. MuJoCo C steps a sample of the same worlds with the same settings; what is timed of it runs "
        "alone on one core. Agree: both say, or neither says, that a thing moved more than 1 cm. Agree with settle: "
        "the same against convex hulls by MuJoCo C, which is what settle runs. On a CPU both sides are MuJoCo C, one "
        "of them on all cores.",
    )
    table = result.add("worlds", "Boxes and convex hulls", COLUMNS, keys=2)
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


def main(arguments: Sequence[str] | None = None) -> int:
    """Make or measure a case."""
    from benchmarks.machine import facts
    from benchmarks.settings import Settings, cores

    p = argparse.ArgumentParser(prog="python -m benchmarks.worlds", description=__doc__)
    p.add_argument("action", choices=("make", "run"))
    p.add_argument("file", type=Path)
    p.add_argument("--device", default="cpu")
    p.add_argument("--backend", choices=("c", "warp"))
    p.add_argument("--worlds", type=int, default=1024)
    p.add_argument("--sample", type=int, default=64)
    p.add_argument("--seconds", type=float, default=3.0)
    p.add_argument("--budget", type=float, default=40.0, help="seconds of MuJoCo C on one core, for each row")
    p.add_argument("--rows", default="0,1", help=f"some of {[f'{k}: {r[0]}, {r[1]}' for k, r in enumerate(ROWS)]}")
    p.add_argument("--small", action="store_true", help="make: a desk instead of a designed room")
    p.add_argument("--out", type=Path, default=Path("."))
    o = p.parse_args(arguments)
    if o.action == "make":
        case = small(o.worlds) if o.small else designed(o.worlds, o.device)
        case.save(o.file)
        print(f"{o.file}: {len(case.poses)} layouts of {len(case.free)} free and {len(case.fixed)} fixed objects")
        return 0
    case = Case.load(o.file)
    case = replace(case, poses=case.poses[: o.worlds])
    began, machine = time.perf_counter(), facts(Settings(device=o.device))
    found = []
    o.out.mkdir(parents=True, exist_ok=True)
    rows = [int(k) for k in o.rows.split(",")]
    for row in measure(case, o.device, o.sample, o.seconds, cores(), o.budget, o.backend, rows):
        found.append(row)
        print(json.dumps(row), flush=True)
        result = replace(tabulate(found), machine=machine, seconds=time.perf_counter() - began)
        result.save(o.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
