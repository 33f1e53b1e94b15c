"""From a layout to a scene: small things, doors that open, the last judgement, and the gates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from sceneweaver.agent.design import design
from sceneweaver.agent.executor import Outcome
from sceneweaver.agent.lived_in import lived_in
from sceneweaver.agent.openability import opened
from sceneweaver.assets import Library

from ..requests import Request
from ..spec import Gates, Spec
from .drafts import Draft


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
    """The scene that the agent makes of a request when it may reflect: slower by far, and seldom in vain."""
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
    return Finished(outcome, seed, unmet, _passed(outcome, unmet, gates, library))


def _passed(outcome: Outcome, unmet: Sequence[str], gates: Gates, library: Library) -> dict[str, bool]:
    """By gate, whether a scene is through it."""
    found = {"valid": outcome.report.valid}
    if gates.grade > 0:
        found["grade"] = outcome.review.total >= gates.grade
    if gates.unmet is not None:
        found["unmet"] = len(unmet) <= gates.unmet
    if gates.openable > 0:
        share = outcome.report.openable_share
        found["openable"] = share is None or share >= gates.openable
    if gates.walkable > 0:
        share = outcome.report.walkable_share
        found["walkable"] = share is None or share >= gates.walkable
    if gates.still is not None and outcome.report.valid:
        from sceneweaver.physics import stability

        moved = stability(outcome.scene, library.load)["moved"].values()
        found["still"] = max(moved, default=0.0) <= gates.still
    return found
