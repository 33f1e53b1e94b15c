"""The learned prior against the engine's own starts: valid layouts and their quality against time, in unseen rooms."""

from __future__ import annotations

import os
import time
from typing import Any

import numpy as np

from benchmarks.drafts import Draft, draft
from benchmarks.judging import Judge
from benchmarks.parallel import each
from benchmarks.prior_memory import spread
from benchmarks.prior_rooms import problems_of_known_kinds, problems_of_new_kinds
from benchmarks.results import Column, Plot, Result
from benchmarks.settings import Settings
from sceneweaver.layout import QualityTerm
from sceneweaver.layout.compile import CompiledScene, compile_scene
from sceneweaver.layout.devices import pick_devices
from sceneweaver.layout.engine import refine
from sceneweaver.layout.rate import rated
from sceneweaver.layout.solution import Solution
from sceneweaver.prior import LayoutPrior
from sceneweaver.scene import Scene

KNOWN, NEW, SEEDS = 40, 10, 3
SIZES = {"cpu": (4, 16, 64), "gpu": (64, 512, 4096)}
BUDGETS = {"cpu": (0.1, 0.3, 1.0), "gpu": (0.05, 0.1, 0.3)}
"""Seconds at which best layouts are compared."""

GPU_SECONDS = 70.0
"""After which on a GPU, where rooms are tried one after the other, no more of them is begun."""

CASE_SECONDS = 40.0
"""After which no further seed is tried in a room."""

RATED = 256
"""Valid candidates of which the median is taken: of more, the free floor is not measured."""

STARTS = ("sample", "prior")

COLUMNS = (
    Column("rooms", "rooms"),
    Column("init", "starts"),
    Column("size", "candidates", "count"),
    Column("problems", "problems", "count"),
    Column("drawing", "drawing [s]", "number"),
    Column("seconds", "seconds", "number"),
    Column("valid", "valid", "share"),
    Column("layouts", "valid layouts", "number"),
    Column("rate", "valid / s", "number"),
    Column("energy", "energy, median [m]", "number"),
    Column("best", "points lost, best", "number"),
    Column("median", "points lost, median", "number"),
    Column("spread", "spread [m]", "number"),
)

EQUAL = (
    Column("rooms", "rooms"),
    Column("budget", "seconds", "number"),
    Column("both", "both have a layout", "count"),
    Column("sample_solved", "solved, sample", "share"),
    Column("prior_solved", "solved, prior", "share"),
    Column("sample_valid", "valid, sample", "number"),
    Column("prior_valid", "valid, prior", "number"),
    Column("sample_best", "points lost, sample", "number"),
    Column("prior_best", "points lost, prior", "number"),
    Column("wins", "prior better", "share"),
    Column("losses", "prior worse", "share"),
)

GRADES = (
    Column("rooms", "rooms"),
    Column("init", "starts"),
    Column("layouts", "layouts", "count"),
    Column("grade", "grade, mean", "number"),
    Column("low", "grade, lowest", "number"),
    Column("judged", "judge: valid", "share"),
)

Case = tuple[str, str, int]


def cases(settings: Settings) -> list[Case]:
    """What rooms are tried: known or new kinds, the kind, the seed."""
    known, new = (4, 2) if settings.quick else (KNOWN, NEW)
    found = [("known kinds", *one) for one in problems_of_known_kinds(known)]
    # Every fifth is of a new kind, so that what is left out where time is short is some of both.
    for k, one in enumerate(problems_of_new_kinds(new, 1)):
        found.insert(5 * k + 4, ("new kinds", *one))
    return found


def run(settings: Settings, judge: Judge) -> Result:
    """Solve held-out rooms from both starts, with several seeds and numbers of candidates."""
    device = pick_devices(settings.device)[0]
    about = (
        "Rooms of 40 kinds that the prior was trained on, with seeds that it was not, and of 10 kinds that it never "
        "saw. `sample`: the engine's own starts, drawn from the relations; `prior`: poses that the network draws, "
        "whose time is in the seconds. Points are what terms of design quality take off that the agent chooses by, of "
        "the best layout and of the median valid one; spread is how far apart the same object stands in two layouts. "
        "Both are brought to the exact values of their relations at the end (`snap=True`), as the agent does."
    )
    result = Result("prior", "A learned prior", about)
    kind = "cpu" if device == "cpu" else "gpu"
    sizes = tuple(s for s in SIZES[kind] if settings.most is None or s <= settings.most)
    sizes = sizes[:2] if settings.quick else sizes
    seeds = tuple(range(settings.seed, settings.seed + (1 if settings.quick else SEEDS)))
    wanted = cases(settings)
    jobs = settings.jobs if device == "cpu" else 1
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # of the processes: many threads for small matrices only wait
    if device == "cpu":
        found = each(_case, [(case, sizes, seeds, device, "cpu") for case in wanted], jobs)
    else:
        drawing, found, began = _drawing_device(device, result), [], time.perf_counter()
        for case in wanted:
            if time.perf_counter() - began < GPU_SECONDS:
                found.append(_case(case, sizes, seeds, device, drawing))
        if len(found) < len(wanted):
            result.notes.append(f"{len(found)} of {len(wanted)} rooms: time was up.")
    rows = [row for rows, _ in found for row in rows]
    table = result.add("prior", "From both starts", list(COLUMNS), keys=3)
    table.rows += [_row(rooms, init, size, rows) for rooms in _groups(rows) for init in STARTS for size in sizes]
    equal = result.add("equal", "At equal time", list(EQUAL), keys=2)
    equal.rows += [_at(rooms, budget, rows) for rooms in _groups(rows) for budget in BUDGETS[kind]]
    graded = result.add("grades", "Grades of the critic for the best layouts", list(GRADES), keys=2)
    grades = [grade for _, grades in found for grade in grades]
    graded.rows += [_graded(rooms, init, grades) for rooms in _groups(rows) for init in STARTS]
    detail = result.add("detail", "Every call", [Column(k, k, "number") for k in rows[0]], keys=3)
    detail.detail = True
    detail.rows += rows
    result.plots += [
        Plot(name, f"{title} against seconds", "prior", "seconds", (key,), "line", log_x=True)
        for name, title, key in (("valid", "Valid layouts", "layouts"), ("points", "Points lost", "best"))
    ]
    wrong = [g for g in grades if not g["valid"]]
    result.failures += [f"{g['kind']} {g['seed']}: the judge finds {g['faults']} in a valid layout" for g in wrong]
    result.notes.append(f"Prior: {LayoutPrior.load().about}.")
    return result


def _drawing_device(device: str, result: Result) -> str:
    """Where the network draws: the GPU where it agrees there with NumPy."""
    scene = draft("bedroom", 0).plain
    here = LayoutPrior.load().sample(scene, 64, 0)
    try:
        there = LayoutPrior.load().sample(scene, 64, 0, device=device)
        off = float(np.abs(there[..., :2] - here[..., :2]).max())
        result.notes.append(f"Poses that the GPU draws differ from those of NumPy by at most {off:.2g} m.")
    except Exception as error:
        off = np.inf
        result.failures.append(f"drawing on {device}: {type(error).__name__}: {' '.join(str(error).split())[:300]}")
    return device if off < 1e-2 else "cpu"


def _groups(rows: list[dict[str, Any]]) -> list[str]:
    return list(dict.fromkeys(row["rooms"] for row in rows))


def _case(case: Case, sizes: tuple[int, ...], seeds: tuple[int, ...], device: str, drawn_on: str) -> tuple[list, list]:
    """All calls for one room: rows, and grades of the best layouts of the first seed."""
    rooms, kind, own = case
    made = draft(kind, own)
    scene = made.plain
    prior, compiled = LayoutPrior.load(), compile_scene(scene)
    for init in STARTS:
        for size in sizes[:1] if device == "cpu" else sizes:
            _solved(scene, compiled, prior, init, size, 12345, device, drawn_on)
    rows, grades = [], []
    began = time.perf_counter()
    for seed in seeds:
        if time.perf_counter() - began > CASE_SECONDS:
            break
        for init in STARTS:
            for size in sizes:
                solution, drawing, seconds = _solved(scene, compiled, prior, init, size, seed, device, drawn_on)
                quality, row = _measured(solution, compiled, made.terms, scene)
                rows.append(
                    {"rooms": rooms, "init": init, "size": size, "kind": kind, "room": own, "seed": seed}
                    | {"drawing": drawing, "seconds": seconds}
                    | row
                )
                if seed == seeds[0] and size == sizes[-1] and quality is not None:
                    best = quality.scene(int(quality.ranked[0]))
                    grades.append({"rooms": rooms, "init": init, **_grade(made, best)})
                    grades[-1] |= {"kind": kind, "seed": own}
    return rows, grades


def _solved(
    scene: Scene,
    compiled: CompiledScene,
    prior: LayoutPrior,
    init: str,
    size: int,
    seed: int,
    device: str,
    drawn_on: str,
) -> tuple[Solution, float, float]:
    """A solution, the seconds that drawing its starts took, and those of all."""
    began = time.perf_counter()
    start = prior.sample(scene, size, seed, device=drawn_on) if init == "prior" else "sample"
    drawing = time.perf_counter() - began
    options = {"device": device, "compiled": compiled, "walk": False, "snap": True}
    found = refine(scene, candidates=size, seed=seed, init=start, **options)
    return found, drawing, time.perf_counter() - began


def _measured(
    solution: Solution, compiled: CompiledScene, terms: list[QualityTerm], scene: Scene
) -> tuple[Solution | None, dict[str, Any]]:
    """The rated solution, and what is measured of it."""
    valid = np.flatnonzero(solution.status == 0)
    row: dict[str, Any] = {"valid": len(valid), "energy": None, "best": None, "median": None, "spread": None}
    if not len(valid):
        return None, row
    quality = rated(solution, compiled, terms)
    points = -np.asarray(quality.quality, dtype=np.float64)
    row |= {"best": float(np.nanmin(points)), "energy": float(np.median(solution.energy[valid]))}
    few = points[valid[:RATED]] if len(valid) <= RATED else _few(solution, compiled, terms, valid[:RATED])
    row |= {"median": float(np.median(few)), "spread": spread(scene, solution.poses[valid[:64]])}
    return quality, row


def _few(solution: Solution, compiled: CompiledScene, terms: list[QualityTerm], rows: np.ndarray) -> np.ndarray:
    """Points lost of some candidates, the free floor measured in all of them."""
    from sceneweaver.layout import rate

    return -rate(compiled.scene, solution.poses[rows], terms, device=solution.device)


def _grade(made: Draft, layout: Scene) -> dict[str, Any]:
    report, review = made.judged(layout)
    return {"grade": float(review.total), "valid": report.valid, "faults": [v.kind for v in report.violations][:3]}


def _row(rooms: str, init: str, size: int, rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Means over problems and seeds."""
    mine = [r for r in rows if (r["rooms"], r["init"], r["size"]) == (rooms, init, size)]
    seconds = float(np.mean([r["seconds"] for r in mine]))
    valid = float(np.mean([r["valid"] for r in mine]))

    def mean(key: str) -> float | None:
        values = [r[key] for r in mine if r[key] is not None]
        return float(np.mean(values)) if values else None

    return {"rooms": rooms, "init": init, "size": size, "problems": len({(r["kind"], r["room"]) for r in mine})} | {
        "seconds": seconds,
        "drawing": mean("drawing"),
        "valid": valid / size,
        "layouts": valid,
        "line": f"{rooms}, {'own starts' if init == 'sample' else init}",
        "rate": valid / seconds,
        **{key: mean(key) for key in ("energy", "best", "median", "spread")},
    }


def _at(rooms: str, budget: float, rows: list[dict[str, Any]]) -> dict[str, Any]:
    """What there is after so many seconds: of each problem and seed the largest call that takes no longer."""
    found: dict[str, dict[tuple, dict[str, Any]]] = {init: {} for init in STARTS}
    every = {(r["kind"], r["room"], r["seed"]) for r in rows if r["rooms"] == rooms}
    for r in rows:
        if r["rooms"] == rooms and r["seconds"] <= budget:
            key = (r["kind"], r["room"], r["seed"])
            if r["size"] >= found[r["init"]].get(key, {"size": 0})["size"]:
                found[r["init"]][key] = r
    solved = {init: {k: r for k, r in found[init].items() if r["valid"]} for init in STARTS}
    both = sorted(solved["sample"].keys() & solved["prior"].keys())
    pairs = np.array([[solved[init][k]["best"] for init in STARTS] for k in both]).reshape(-1, 2)
    better, worse = pairs[:, 1] < pairs[:, 0] - 0.01, pairs[:, 1] > pairs[:, 0] + 0.01
    row: dict[str, Any] = {"rooms": rooms, "budget": budget, "both": len(both)}
    for k, init in enumerate(STARTS):
        row[f"{init}_solved"] = len(solved[init]) / max(1, len(every))
        row[f"{init}_valid"] = sum(r["valid"] for r in solved[init].values()) / max(1, len(every))
        row[f"{init}_best"] = float(pairs[:, k].mean()) if len(both) else None
    return row | {
        "wins": float(better.mean()) if len(both) else None,
        "losses": float(worse.mean()) if len(both) else None,
    }


def _graded(rooms: str, init: str, grades: list[dict[str, Any]]) -> dict[str, Any]:
    mine = [g for g in grades if (g["rooms"], g["init"]) == (rooms, init)]
    values = [g["grade"] for g in mine]
    return {
        "rooms": rooms,
        "init": init,
        "layouts": len(mine),
        "grade": float(np.mean(values)) if mine else None,
        "low": float(np.min(values)) if mine else None,
        "judged": float(np.mean([g["valid"] for g in mine])) if mine else None,
    }
