"""Plans: thirty programmes in envelopes of their own; valid plans a second, topologies, the exact checker, a rival."""

from __future__ import annotations

import time
from collections.abc import Sequence
from importlib.util import find_spec
from typing import Any

from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver.plans import Programme, check_plan, envelope_for, programme_names, solve_plans
from sceneweaver.plans.solve_problem import compile_plan
from sceneweaver.plans.solve_solution import PlanSolution

CPU, GPU, QUICK = 384, 65536, 16
"""Candidates of a programme."""
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
        "where one storey in a rectangle is asked for.",
    )
    table = result.add("programmes", "By programme", COLUMNS)
    names = settings.kinds or (programme_names()[:2] if settings.quick else programme_names())
    for name in names:
        table.rows.append(_row(name, settings, result))
    total = _total(table.rows)
    table.rows.append(total)
    for row in table.rows:
        goal = GOAL_GPU if settings.device.startswith("cuda") else GOAL_CPU
        if row["programme"] in EIGHT and not settings.quick and row["rate"] < goal:
            result.notes.append(f"{row['programme']}: {row['rate']:.0f} valid plans a second, goal {goal}")
    if find_spec("ortools") is None:
        result.notes.append("No rival: OR-Tools is not installed.")
    return result


def _row(name: str, settings: Settings, result: Result) -> dict[str, Any]:
    programme = Programme.example(name)
    envelope = envelope_for(programme, settings.seed)
    options = {"device": settings.device, "seed": settings.seed}
    solve_plans(programme, envelope, candidates=16, rounds=1, moves=1, **options)  # kernels are compiled
    count = settings.size(GPU if settings.device.startswith("cuda") else CPU, QUICK)
    began, cpu = time.perf_counter(), time.process_time()
    solution = solve_plans(programme, envelope, candidates=count, **options)
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
    return {
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
