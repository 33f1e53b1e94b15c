"""Plans: thirty programmes in envelopes of their own; valid plans a second, topologies, the exact checker, a rival, and
what a strict architect objects to in the plans that are chosen."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from typing import Any

from benchmarks.judging import Judge
from benchmarks.plan_faults import plan_faults, strict
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.plans import Programme, check_plan, envelope_for, programme_names, solve_plans
from sceneweaver.plans.solve_problem import compile_plan
from sceneweaver.plans.solve_solution import PlanSolution

CPU, GPU, QUICK = 384, 262_144, 16
"""Candidates of a programme."""
ATTEMPTS = {"cpu": 16, "cuda": 4}
"""Attempts of a candidate: a GPU finds more valid plans a second among many candidates that are given up early."""
CHECKED = 100
"""Plans of a programme that the exact checker looks at: the best, the worst and those evenly in between; on a GPU as
many."""
GOAL_CPU, GOAL_GPU = 100, 10_000
"""Valid plans a second of programmes of eight rooms on one storey: on two cores, on one H200."""
EIGHT = ("flat-2-bedrooms", "flat-2-bedrooms-ensuite", "flat-3-bedrooms-open")
"""Those programmes."""
PATIENCE = 30.0
"""Seconds that the rival gets for a programme."""

COLUMNS = (
    Column("programme", "programme"),
    Column("rooms", "rooms", "count"),
    Column("storeys", "storeys", "count"),
    Column("candidates", "candidates", "count"),
    Column("valid", "valid", "share"),
    Column("rate", "valid / s", "number"),
    Column("cpu_rate", "valid / CPU s", "number"),
    Column("topologies", "topologies", "count"),
    Column("checked", "checked", "count"),
    Column("agreed", "checker agrees", "share"),
    Column("first", "first valid [s]", "number"),
    Column("rival", "rival's first [s]", "number"),
    Column("how", "rival"),
)

CHOICES = {"chosen": "chosen", "energy": "by energy alone", "usual": "any valid one"}
"""Plans whose faults are counted: that of `PlanSolution.ranked`, that of least energy, that of median energy."""
FAULTS = (Column("kind", "fault"), Column("says", "what holds"), *(Column(k, v, "count") for k, v in CHOICES.items()))


def run(settings: Settings, judge: Judge) -> Result:
    """Solve every programme; what the solver calls valid the exact checker has to call valid."""
    del judge  # of furniture; plans have a checker of their own
    result = Result(
        "plans",
        "Floor plans",
        "Programmes that ship with the library, each in the envelope that `envelope_for` chooses: how many of the "
        "candidates keep all hard rules of the base profile, how many a second (of the clock, and of processor time of "
        "all threads), how many topologies among them (rooms of one kind are not told apart), and what the exact "
        "checker says of them. First: seconds of a call for 16 candidates. The rival is CP-SAT, one plan at a time, "
        "where one storey in a rectangle is asked for. Faults: what a strict architect objects to in one plan of each "
        "programme (benchmarks/data/plan_faults.yaml).",
    )
    table = result.add("programmes", "By programme", COLUMNS)
    names = settings.programmes or (programme_names()[:2] if settings.quick else programme_names())
    faults: dict[str, Counter[str]] = {choice: Counter() for choice in CHOICES}
    for name in names:
        row, solution = _row(name, settings, result)
        table.rows.append(row)
        for choice, more in _faults(solution).items():
            faults[choice].update(more)
    result.add("faults", "What a strict architect objects to, by kind", FAULTS).rows += [
        {"kind": row.id, "says": row.says, **{choice: found[row.id] for choice, found in faults.items()}}
        for row in strict().rows
    ]
    total = _total(table.rows)
    table.rows.append(total)
    for row in table.rows:
        goal = GOAL_GPU if settings.device.startswith("cuda") else GOAL_CPU
        if row["programme"] in EIGHT and not settings.quick and row["rate"] < goal:
            result.notes.append(f"{row['programme']}: {row['rate']:.0f} valid plans a second, goal {goal}")
    if find_spec("ortools") is None:
        result.notes.append("No rival: OR-Tools is not installed.")
    return result


def _row(name: str, settings: Settings, result: Result) -> tuple[dict[str, Any], PlanSolution]:
    programme = Programme.example(name)
    envelope = envelope_for(programme, settings.seed)
    kind = "cuda" if settings.device.startswith("cuda") else "cpu"
    options = {"device": settings.device, "seed": settings.seed}
    solve_plans(programme, envelope, candidates=16, rounds=1, moves=1, **options)  # kernels are compiled
    count = settings.size(GPU if kind == "cuda" else CPU, QUICK)
    began, cpu = time.perf_counter(), time.process_time()
    solution = solve_plans(programme, envelope, candidates=count, rounds=ATTEMPTS[kind], **options)
    seconds, cpu = time.perf_counter() - began, time.process_time() - cpu
    began = time.perf_counter()
    few = solve_plans(programme, envelope, candidates=16, **options)
    first = time.perf_counter() - began if len(few.valid) else None
    good = len(solution.valid)
    checked, wrong = _checked(solution)
    result.failures += [f"{name}: {line}" for line in wrong]
    if not good:
        result.notes.append(f"{name}: {solution.explanation}")
    rival, how = _rival(name, settings)
    row = {
        "programme": name,
        "rooms": len(solution.plan.programme.rooms),
        "storeys": programme.storeys,
        "candidates": count,
        "valid": good / count,
        "good": good,
        "rate": good / seconds,
        "cpu_rate": good / cpu,
        "topologies": len({int(code) for code in solution.topologies()[solution.valid]}),
        "checked": checked,
        "agreed": 1 - len(wrong) / checked if checked else None,
        "first": first,
        "rival": rival,
        "how": how,
    }
    return row, solution


def _faults(solution: PlanSolution) -> Mapping[str, Counter[str]]:
    """Faults of the plans of `CHOICES`; nothing where no plan is valid."""
    valid = solution.valid
    if not len(valid):
        return {}
    homes = solution.ranked()[0][0], solution.best, solution.home(int(valid[len(valid) // 2]))
    programme = solution.plan.programme
    return {choice: plan_faults(home, programme) for choice, home in zip(CHOICES, homes, strict=True)}


def _checked(solution: PlanSolution) -> tuple[int, list[str]]:
    """How many plans the exact checker looked at, and what it has against them."""
    valid = solution.valid
    some = [int(valid[k * len(valid) // min(CHECKED, len(valid))]) for k in range(min(CHECKED, len(valid)))]
    wrong: list[str] = []
    for k in some:
        plan = solution.plan
        report = check_plan(solution.home(k), plan.programme, plan.profile, envelope=plan.envelope)
        if not report.valid:
            wrong.append(f"candidate {k}: {report.violations[0].detail}")
    return len(some), wrong


def _rival(name: str, settings: Settings) -> tuple[float | None, str]:
    if find_spec("ortools") is None or (settings.rivals is not None and "plan_cp_sat" not in settings.rivals):
        return None, ""
    from benchmarks.rivals import plan_cp_sat

    programme = Programme.example(name)
    plan = compile_plan(programme, envelope_for(programme, settings.seed))
    if not plan_cp_sat.suits(plan):
        return None, "not its shape"
    seconds, how = plan_cp_sat.first_valid(plan, 5.0 if settings.quick else PATIENCE, settings.seed)
    return seconds, how


def _total(rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    candidates, good = sum(row["candidates"] for row in rows), sum(row["good"] for row in rows)
    checked = sum(row["checked"] for row in rows)
    agreed = sum(row["checked"] * (row["agreed"] or 0) for row in rows)
    return {
        "programme": "all",
        "rooms": sum(row["rooms"] for row in rows),
        "storeys": sum(row["storeys"] for row in rows),
        "candidates": candidates,
        "valid": good / candidates,
        "good": good,
        "rate": good / sum(row["good"] / row["rate"] if row["rate"] else 0.0 for row in rows) if good else 0.0,
        "cpu_rate": good / sum(row["good"] / row["cpu_rate"] if row["cpu_rate"] else 0.0 for row in rows)
        if good
        else 0.0,
        "topologies": sum(row["topologies"] for row in rows),
        "checked": checked,
        "agreed": agreed / checked if checked else None,
        "first": None,
        "rival": None,
        "how": "",
    }
