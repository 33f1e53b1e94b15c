"""From a programme to the plan that is furnished: solved, the best of several by soft rules and by its walls."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sceneweaver.home import Home
from sceneweaver.plans import Envelope, PlanReport, Programme, check_plan
from sceneweaver.plans.solve import solve_plans
from sceneweaver.scene import InputError

from .demands import short_walls
from .windows import with_sills

COMPARED = 24
"""Plans whose walls are compared, of those that soft rows cost least."""

SHORT = 2.0
"""How much a metre of wall that furniture lacks counts, beside the cost of soft rules."""


@dataclass(frozen=True)
class ChosenPlan:
    """A plan without furniture.

    Attributes:
        home: the plan.
        report: the verdict of the exact checker on it.
        lacking: by room, wall [m] that its furniture lacks.
        valid: how many valid plans there were.
        distinct: how many of them were compared.
        envelope: what it fits into.
        seconds: that the solver took [s].
    """

    home: Home
    report: PlanReport
    lacking: Mapping[str, float]
    valid: int
    distinct: int
    envelope: Envelope
    seconds: float


def plan_home(
    programme: Programme,
    envelope: Envelope,
    *,
    seed: int = 0,
    profile: str = "base",
    candidates: int = 4096,
    device: str = "auto",
    time_limit: float | None = None,
    prompt: str = "",
) -> ChosenPlan:
    """Solve a programme, and choose of the valid plans the one that is best to live in and to furnish.

    Soft rules count as the profile weighs them; a wall that is too short for the furniture of its room counts besides.

    Raises:
        InputError: no plan is valid; it says which rules stand against it.
    """
    solution = solve_plans(
        programme, envelope, candidates=candidates, seed=seed, profile=profile, device=device, time_limit=time_limit
    )
    found, broken = list[tuple[float, int, Home, PlanReport, dict[str, float]]](), ""
    for number, (plain, _) in enumerate(solution.ranked()[:COMPARED]):
        home = with_sills(plain)
        report = check_plan(home, programme, profile)
        if not report.valid and home != plain:  # the window is lower than the furniture likes, but the room has light
            home, report = plain, check_plan(plain, programme, profile)
        if not report.valid:
            broken = broken or "; ".join(v.detail for v in report.violations[:3])
            continue
        lacking = short_walls(home)
        found.append((round(report.cost + SHORT * sum(lacking.values()), 6), number, home, report, lacking))
    if not found:
        raise InputError(f"programme: no plan keeps all rules: {broken or solution.explanation or 'none was found'}")
    _, _, home, report, lacking = min(found, key=lambda row: row[:2])
    changes = {"prompt": prompt, "provenance": {**home.provenance, "tool": "solve_plans", "seed": seed}}
    return ChosenPlan(
        home.with_changes(**changes),
        report,
        lacking,
        len(solution.valid),
        len(found),
        envelope,
        round(float(solution.elapsed), 3),
    )
