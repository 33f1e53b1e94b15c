"""Whether a plan keeps the rules: exact, in whole millimetres, and apart from everything that makes plans."""

from __future__ import annotations

from typing import Any

from sceneweaver.home import Home
from sceneweaver.io import InputError

from .checking import economy as _economy
from .checking import geometry as _geometry
from .checking import light as _light
from .checking import openings as _openings
from .checking import rooms as _rooms
from .checking import stairs as _stairs
from .checking import ways as _ways
from .checking.asked import asked
from .checking.facts import PlanFacts, require_home
from .checking.readings import broken, measures
from .envelope import Envelope
from .profile import MEASURES, Profile
from .programme import Programme
from .report import PlanReport, PlanViolation

_REGISTERED = (_economy, _geometry, _light, _openings, _rooms, _stairs, _ways)
"""Modules whose measures the rows name."""

_PLAN_MEASURES = ("circulation_share", "wet_groups", "entrances", "shared_toilets", "largest_area")
"""Measures of the whole plan that a report states."""


def check_plan(
    home: Home,
    programme: Programme | None = None,
    profile: Profile | str = "base",
    *,
    envelope: Envelope | None = None,
) -> PlanReport:
    """Judge the plan of a home by the rows of a profile, and by what a programme asks for.

    Lengths and areas are compared as exact fractions of whole millimetres, leaves as exact quarters of a disc. Where a
    room has oblique walls its floor's area is exact; squares and rectangles in it are those of cells of at most 50 mm
    that lie wholly inside, and what it shares with others is compared by floats, from 100 mm2 on.

    Args:
        home: the plan; furniture does not matter.
        programme: what it is to hold; None: only the rules are judged.
        profile: the rules, or the name of those that ship with the library.
        envelope: what it was to fit into; None: windows may be in any outer wall.

    Returns:
        The report: valid where no hard row and nothing hard of the programme is broken.

    Raises:
        InputError: an argument is of the wrong kind, or the profile is not known.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.plans import check_plan
        >>> report = check_plan(sw.Home.example("flat"))
        >>> report.valid, report.areas["bath"]
        (True, 3.36)
    """
    plan = PlanFacts(require_home(home), _of("programme", programme, Programme), _of("envelope", envelope, Envelope))
    rows = Profile.of(profile)
    known = measures()
    hard: list[PlanViolation] = []
    soft: list[PlanViolation] = []
    cost = 0.0
    values: dict[str, float] = {}
    for rule in rows.rows:
        if not rule.concerns(plan.use):
            continue
        readings = list(known[rule.measure](plan, rule))
        if rule.measure in _PLAN_MEASURES and readings:
            values[rule.measure] = float(readings[0].value)
        for reading, excess, line in broken(readings, rule):
            violation = PlanViolation(rule.id, reading.rooms, line, float(excess))
            if rule.hard:
                hard.append(violation)
            else:
                soft.append(violation)
                cost += rule.cost(float(excess))
    for is_hard, weight, violation in asked(plan):
        if is_hard:
            hard.append(violation)
        else:
            soft.append(violation)
            cost += weight * violation.amount
    return PlanReport(
        valid=not hard,
        violations=tuple(hard),
        soft=tuple(soft),
        areas={room.id: float(room.area) for room in plan.rooms},
        cost=round(cost, 9),
        measures=values,
    )


def _of(name: str, value: Any, kind: type) -> Any:
    if value is not None and not isinstance(value, kind):
        raise InputError(f"{name} is of type {type(value).__name__}; give a {kind.__name__}")
    return value


_missing = set(MEASURES) - set(measures())
if _missing:  # a row could name it, and nothing would be judged
    raise ValueError(f"no measure is registered for {', '.join(sorted(_missing))}")
