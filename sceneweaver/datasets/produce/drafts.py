"""From a request to a room that is not laid out yet, and from a layout to a scene that may pass the gates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from sceneweaver.agent.design import chosen_room, design
from sceneweaver.agent.executor import Executor, Outcome
from sceneweaver.agent.lived_in import lived_in
from sceneweaver.agent.loop import empty_scene
from sceneweaver.agent.openability import opened
from sceneweaver.agent.settings import Settings
from sceneweaver.assets import Library
from sceneweaver.language import read_request
from sceneweaver.scene import Scene
from sceneweaver.tools.base import Context, Proposal
from sceneweaver.tools.init_prior import InitPrior

from ..gates import Gates, passed
from ..requests import Request
from ..spec import Spec


@dataclass(frozen=True)
class Draft:
    """A room with all that it is to hold.

    Attributes:
        request: what it answers.
        proposal: the room, its furniture and relations, none of them placed.
        executor: judges and searches for this room.
        context: what tools may look at.
        notes: what was assumed.
    """

    request: Request
    proposal: Proposal
    executor: Executor
    context: Context
    notes: tuple[str, ...]

    @property
    def scene(self) -> Scene:
        """The scene of the proposal; its poses mean nothing."""
        assert self.proposal.scene is not None
        return self.proposal.scene

    @property
    def seed(self) -> int:
        """What all draws of this attempt follow from."""
        return self.context.seed


def drafted(spec: Spec, request: Request, seed: int, library: Library, device: str) -> Draft:
    """The room that a request asks for, drawn from a seed.

    Raises:
        InputError: a request that says nothing, or is too long.
    """
    brief = read_request(request.prompt)
    room_type, remarks = chosen_room(brief)
    settings = Settings(
        seed=seed,
        candidates=spec.rooms.candidates,
        device=device,
        seconds=None,
        clutter=request.clutter,
        generations=0,
    )
    context = Context(brief, room_type, empty_scene(brief, room_type), library, seed, clutter=request.clutter)
    proposal = InitPrior().propose(context)
    return Draft(request, proposal, Executor(room_type, brief, settings, library), context, remarks)


@dataclass(frozen=True)
class Finished:
    """A furnished scene with its judgement.

    Attributes:
        outcome: the scene, its report and its review.
        seed: what its attempt followed from.
        unmet: what was asked for and is not so.
        gates: by name, whether it is through them.
    """

    outcome: Outcome
    seed: int
    unmet: tuple[str, ...]
    gates: dict[str, bool]

    @property
    def reason(self) -> str:
        """Why it is not delivered; empty where it is."""
        missed = [name for name, passed in self.gates.items() if not passed]
        if "valid" in missed:
            faults = [v.detail for v in self.outcome.report.violations if v.hard]
            return f"not valid: {faults[0]}" + (f" and {len(faults) - 1} more" if len(faults) > 1 else "")
        return f"gate: {', '.join(missed)}" if missed else ""


def finished(draft: Draft, layout: Outcome, seed: int, gates: Gates) -> Finished:
    """A layout of a room as a scene.

    Args:
        draft: the room.
        layout: the layout with its judgement.
        seed: decides which small things lie where.
        gates: what the scene has to be.
    """
    context = replace(draft.context, scene=layout.scene, seed=seed)
    outcome = lived_in(layout, draft.executor, context)
    outcome, _ = opened(outcome, draft.executor)
    return _gated(outcome, draft.seed, (*draft.proposal.unmet, *outcome.unmet), gates, draft.executor.library)


def designed(spec: Spec, request: Request, seed: int, library: Library, device: str) -> Finished:
    """The scene that the agent makes of a request when it may reflect: slower by far, and it seldom fails."""
    made = design(
        request.prompt,
        seed=seed,
        candidates=spec.rooms.candidates,
        clutter=request.clutter,
        device=device,
        time_limit=None,
        library=library,
    )
    return _gated(Outcome(made.scene, made.report, made.review), seed, made.unmet, spec.gates, library)


def _gated(outcome: Outcome, seed: int, unmet: Sequence[str], gates: Gates, library: Library) -> Finished:
    asked = [fault.reason for fault in outcome.review.faults if fault.criterion == "alignment"]
    unmet = tuple(dict.fromkeys((*unmet, *asked)))
    return Finished(outcome, seed, unmet, passed(gates, lambda name: _measured(outcome, unmet, library, name)))


def _measured(outcome: Outcome, unmet: Sequence[str], library: Library, name: str) -> Any:
    """What a scene has of the measure of a gate; None where there is nothing to measure."""
    if name == "unmet":
        return unmet
    if name == "grade":
        return outcome.review.total
    if name == "shift":
        from sceneweaver.physics import stability

        return max(stability(outcome.scene, library.load)["moved"].values(), default=0.0)
    return outcome.review.grades[name] if name in outcome.review.grades else getattr(outcome.report, name)
