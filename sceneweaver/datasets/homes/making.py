"""From a request to a home: its plan, and its furniture where that is wanted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from sceneweaver.assets import Library
from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.plans import PlanReport, Programme, check_plan, envelope_for
from sceneweaver.plans.solve import solve_plans

from ..requests import Request
from ..spec import Spec

COMPARED = 16
"""Distinct plans of a search that are compared by their soft rules."""


@dataclass(frozen=True)
class MadeHome:
    """A home, not judged yet.

    Attributes:
        home: the home.
        plan: the exact checker on its plan.
        unmet: what was asked for and is not so.
    """

    home: Home
    plan: PlanReport
    unmet: tuple[str, ...] = ()


MakeHome = Callable[[Spec, Request, int, Library], MadeHome]
"""What makes the home of a request: specification, request, the seed of an attempt, and the library of the data set.

Raises InputError where a request has no home; another seed may have one.
"""


def make_home(spec: Spec, request: Request, seed: int, library: Library) -> MadeHome:
    """The home of a request: of several valid plans the best by soft rules, furnished where that is asked for.

    The envelope is drawn from the seed.

    Raises:
        InputError: no plan keeps all rules, or a room cannot be furnished.
    """
    programme = programme_of(request)
    made = planned_home(spec, programme, seed)
    return furnished_home(spec, request, made, seed, library) if spec.of_homes.furnished else made


def programme_of(request: Request) -> Programme:
    """The programme of a request: the one that was drawn, or what its words say.

    Raises:
        InputError: nothing of it is understood.
    """
    if request.kind:
        return Programme.example(request.kind)
    from sceneweaver.language.homes import read_home

    return read_home(request.prompt).programme


def planned_home(spec: Spec, programme: Programme, seed: int) -> MadeHome:
    """The plan of a programme in an envelope that is drawn from a seed, without furniture.

    Raises:
        InputError: no plan keeps all rules.
    """
    asked = spec.of_homes
    solution = solve_plans(
        programme, envelope_for(programme, seed), candidates=asked.plans, seed=seed, profile=asked.profile, device="cpu"
    )
    found: list[tuple[float, int, Home, PlanReport]] = []
    for number, home in enumerate(solution.distinct(COMPARED)):
        report = check_plan(home, programme, asked.profile)
        if report.valid:
            found.append((round(report.cost, 6), number, home, report))
    if not found:
        raise InputError(f"programme: no plan keeps all rules: {solution.explanation or 'none was found'}")
    _, _, home, report = min(found, key=lambda row: row[:2])
    return MadeHome(home, report)


def furnished_home(spec: Spec, request: Request, made: MadeHome, seed: int, library: Library) -> MadeHome:
    """A planned home with all its rooms furnished, by this process alone."""
    from sceneweaver.furnish import furnish_home

    options: dict[str, Any] = {"candidates": spec.rooms.candidates, "clutter": request.clutter, "library": library}
    done = furnish_home(made.home, seed=seed, prompt=request.prompt, device="cpu", workers=1, **options)
    return MadeHome(done.home, made.plan, (*made.unmet, *done.unmet))
