"""Whether a scene is what was asked for, item by item of the scene graph."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from . import (
    asked_arrangements,
    asked_capacity,
    asked_entities,
    asked_free,
    asked_measures,
    asked_relations,
    asked_room,
    asked_states,
    asked_use,
    asked_views,
)
from .asked_clauses import doubted
from .grade import Finding, finding
from .model import USE, Alignment, Fault
from .survey import Survey
from .verdict import Asked

PARTS = (
    asked_entities.outcomes,
    asked_measures.outcomes,
    asked_states.outcomes,
    asked_relations.outcomes,
    asked_capacity.outcomes,
    asked_arrangements.outcomes,
    asked_views.outcomes,
    asked_free.outcomes,
    asked_room.outcomes,
)


def measured(survey: Survey, faults: Iterable[Fault] = ()) -> tuple[Asked, ...]:
    """Every item of the request: things and what they are like, exclusions, relations, people, arrangements, free
    floor, the room, words that are not known, and whether the room can be used, where ``faults`` are in the way."""
    found = [item for part in PARTS for item in part(survey)]
    told = doubted(_of_stand_ins(found, survey), survey)
    return (*told, *asked_use.outcomes(survey, told, faults))


def _of_stand_ins(items: Sequence[Asked], survey: Survey) -> list[Asked]:
    """The items, of which relations that hold of what only stands for what was asked are so in part."""
    stood = {i.outcome.item: i.outcome.reason for i in items if i.outcome.status == "substituted"}
    ends = {said.id or f"relation-{k}": (said.subject, *said.targets) for k, said in enumerate(survey.brief.relations)}
    found = []
    for item in items:
        of = next((stood[name] for name in ends.get(item.outcome.item, ()) if name in stood), None)
        if of is not None and item.outcome.status == "met":
            told = {"status": "partly", "reason": f"{item.outcome.reason}; {of}"}
            item = replace(item, outcome=item.outcome.model_copy(update=told))
        found.append(item)
    return found


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
