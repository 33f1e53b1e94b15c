"""Whether a scene is what was asked for, item by item of the scene graph."""

from __future__ import annotations

from collections.abc import Sequence

from . import (
    asked_arrangements,
    asked_capacity,
    asked_entities,
    asked_free,
    asked_measures,
    asked_relations,
    asked_room,
    asked_states,
)
from .asked_clauses import doubted
from .grade import Finding, finding
from .model import USE, Alignment
from .survey import Survey
from .verdict import Asked

PARTS = (
    asked_entities.outcomes,
    asked_measures.outcomes,
    asked_states.outcomes,
    asked_relations.outcomes,
    asked_capacity.outcomes,
    asked_arrangements.outcomes,
    asked_free.outcomes,
    asked_room.outcomes,
)


def measured(survey: Survey) -> tuple[Asked, ...]:
    """Every item of the request: things and what they are like, exclusions, relations, people, arrangements, free
    floor, the room, and words that are not known."""
    return doubted([item for part in PARTS for item in part(survey)], survey.brief)


def alignment(items: Sequence[Asked]) -> Alignment:
    """What became of the items."""
    return Alignment(items=tuple(item.outcome for item in items))


def findings(items: Sequence[Asked]) -> list[Finding]:
    """A fault for each item that is unmet, and one where no item was understood, as nothing is met then."""
    stated = [item.outcome.status for item in items if item.outcome.item != USE]
    if stated and set(stated) == {"not_understood"}:
        reason = "nothing of the request was understood, so nothing of it is known to be met"
        fix = "ask in plain English, or let a model read the request"
        return [finding("alignment", "not_understood", (), reason, fix, grave=True)]
    return [item.finding for item in items if item.finding is not None]
