"""From a request to a home: its plan, and its furniture where that is wanted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sceneweaver.assets import Library
from sceneweaver.furnish.planning import plan_home
from sceneweaver.home import Home
from sceneweaver.language.homes import read_home
from sceneweaver.plans import PlanReport, Programme, envelope_for

from ..requests import Request
from ..spec import Spec


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
    """The home of a request: the best of many plans in an envelope that is drawn from the seed, furnished by
    `sceneweaver.design_home` where that is asked for.

    Raises:
        InputError: the request says nothing, or no plan keeps all rules.
    """
    asked = spec.of_homes
    programme = Programme.example(request.kind) if request.kind else None
    if not asked.furnished:
        programme = read_home(request.prompt).programme if programme is None else programme
        envelope = envelope_for(programme, seed)
        found = plan_home(programme, envelope, seed=seed, profile=asked.profile, candidates=asked.plans, device="cpu")
        return MadeHome(found.home, found.report)
    from sceneweaver.furnish import design_home

    made = design_home(
        request.prompt,
        programme=programme,
        envelope=None if programme is None else envelope_for(programme, seed),
        seed=seed,
        profile=asked.profile,
        device="cpu",
        workers=1,
        plans=asked.plans,
        candidates=spec.rooms.candidates,
        clutter=request.clutter,
        time_limit=None,
        pictures="none",
        library=library,
    )
    return MadeHome(made.home, made.plan_report, made.unmet)
