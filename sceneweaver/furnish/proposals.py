"""Plans to choose from for a request in words or a programme, before anything is furnished."""

from __future__ import annotations

import time
from dataclasses import dataclass

from sceneweaver.plans import Envelope, Profile, Programme
from sceneweaver.scene import InputError

from .asked import Asked
from .planning import ChosenPlan, rank_plans


@dataclass(frozen=True)
class PlanProposals:
    """What `propose_plans` found.

    Attributes:
        plans: best first, each of another topology, all of them valid.
        programme: what was asked for.
        profile: the rules that they keep.
        notes: what was assumed, and what furniture asked of the rooms.

    Examples:
        >>> from sceneweaver.furnish import PlanProposals
        >>> from sceneweaver.plans import Profile, Programme
        >>> PlanProposals((), Programme.example("flat-2-bedrooms"), Profile.named("base")).plans
        ()
    """

    plans: tuple[ChosenPlan, ...]
    programme: Programme
    profile: Profile
    notes: tuple[str, ...] = ()


def propose_plans(
    prompt: str = "",
    *,
    programme: Programme | None = None,
    envelope: Envelope | None = None,
    profile: str | None = None,
    seed: int = 0,
    plans: int = 1024,
    count: int = 4,
    device: str = "auto",
    time_limit: float | None = None,
) -> PlanProposals:
    """The best plans for a request or a programme, their rooms large enough for what they are to hold.

    Args:
        prompt: the request, in English; may be empty where a programme is given.
        programme: the rooms, instead of those that the request names.
        envelope: what the plans have to fit into; None: as the request says, or chosen for the programme.
        profile: rules that they keep, such as "accessible"; None: as the request says.
        seed: equal seeds give equal plans.
        plans: how many are searched for at once.
        count: how many are kept.
        device: "auto", "cpu", "cuda" or "cuda:k".
        time_limit: seconds that the search may take. None: as long as it takes.

    Raises:
        InputError: for a request that says nothing, arguments out of range, or where no plan keeps all rules.

    Examples:
        >>> from sceneweaver.furnish import propose_plans
        >>> found = propose_plans("a studio flat", plans=64, count=2, device="cpu")
        >>> len(found.plans) <= 2 and all(plan.report.valid for plan in found.plans)
        True
    """
    if not prompt.strip() and programme is None:
        raise InputError("prompt: is empty; say what home is wanted, or give a programme")
    if count < 1:
        raise InputError(f"count: {count} is too few; give at least 1")
    asked = Asked.of(prompt, programme, envelope, profile)
    began = time.monotonic()
    wanted, raises = asked.possible()

    def ranked(fit: Envelope) -> list[ChosenPlan]:
        left = None if time_limit is None else max(1.0, time_limit - (time.monotonic() - began))
        options = {"candidates": plans, "device": device, "time_limit": left, "outside": asked.outside}
        return rank_plans(wanted, fit, seed=seed, profile=asked.profile, prompt=asked.prompt, **options)

    found = asked.fitted(wanted, seed, ranked)
    return PlanProposals(tuple(found[:count]), asked.programme, asked.profile, (*asked.notes, *raises))
