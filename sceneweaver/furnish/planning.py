"""From a programme to the plan that is furnished: solved, the best of several by soft rules and by its walls."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from sceneweaver.home import Home
from sceneweaver.plans import Envelope, PlanReport, Profile, Programme, check_plan
from sceneweaver.plans.solve import solve_plans
from sceneweaver.scene import InputError

from .demands import short_walls
from .outside import has_outside_door, with_outside_doors
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
    profile: Profile | str = "base",
    candidates: int = 4096,
    device: str = "auto",
    time_limit: float | None = None,
    prompt: str = "",
    outside: Collection[str] = (),
) -> ChosenPlan:
    """Solve a programme, and choose of the valid plans the one that is best to live in and to furnish.

    Soft rules count as the profile weighs them; a wall that is too short for the furniture of its room counts besides,
    and so does a door outside that is missing in one of the rooms ``outside``.

    Raises:
        InputError: no plan is valid; it says which rules stand against it.
    """
    options: dict[str, Any] = {"profile": profile, "candidates": candidates, "device": device, "time_limit": time_limit}
    return rank_plans(programme, envelope, seed=seed, prompt=prompt, outside=outside, **options)[0]


def rank_plans(
    programme: Programme,
    envelope: Envelope,
    *,
    seed: int = 0,
    profile: Profile | str = "base",
    candidates: int = 4096,
    device: str = "auto",
    time_limit: float | None = None,
    prompt: str = "",
    outside: Collection[str] = (),
) -> list[ChosenPlan]:
    """The valid plans among the best of each topology, best first by the measure of `plan_home`.

    Raises:
        InputError: as `plan_home`.
    """
    solution = solve_plans(
        programme, envelope, candidates=candidates, seed=seed, profile=profile, device=device, time_limit=time_limit
    )
    found, broken = list[tuple[float, int, Home, PlanReport, dict[str, float]]](), ""
    for number, (plain, judged) in enumerate(solution.ranked()[:COMPARED]):
        home = with_sills(plain)
        report = judged if home == plain else check_plan(home, programme, profile)
        if not report.valid:  # the window is lower than the furniture likes, but the room has light
            home, report = plain, judged
        if not report.valid:
            broken = broken or "; ".join(v.detail for v in report.violations[:3])
            continue
        if outside:
            home = with_outside_doors(home, outside, programme, profile, envelope)
            report = check_plan(home, programme, profile)
        without = sum(not has_outside_door(home, name) for name in outside)
        lacking = short_walls(home)
        cost = report.cost + SHORT * (sum(lacking.values()) + without)
        found.append((round(cost, 6), number, home, report, lacking))
    if not found:
        raise InputError(f"programme: no plan keeps all rules: {broken or solution.explanation or 'none was found'}")
    seconds = round(float(solution.elapsed), 3)
    made = {"tool": "solve_plans", "seed": seed}
    return [
        ChosenPlan(
            home.with_changes(prompt=prompt, provenance={**home.provenance, **made}),
            report,
            lacking,
            len(solution.valid),
            len(found),
            envelope,
            seconds,
        )
        for _, _, home, report, lacking in sorted(found, key=lambda row: row[:2])
    ]
