"""Items that are so, beside words that were not understood: nobody knows whether they are so as it was meant."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.language import Span

from .asked_words import Doubt, is_so, swallowed
from .phrases import spans_of
from .survey import Survey
from .verdict import Asked

_END = re.compile(r"[.;:!?\n](?!\d)|,(?!\d)|\s-\s|[()]")

_DOUBTED = ("entity", "relation", "exclusion")
"""Kinds of items that are told by whole clauses; what a thing is like is told by its own words."""

_WITHIN = ("arrangement", "capacity", "free_area", "room")
"""Kinds of items whose words are a clause of their own."""


def doubted(items: Sequence[Asked], survey: Survey) -> tuple[Asked, ...]:
    """The items, of which those met count as partly met where their clause has words that nothing which was read speaks
    for."""
    graph = survey.brief
    ends = [match.start() for match in _END.finditer(graph.text)]
    doubts = [Doubt(left.words, left.span, _DOUBTED) for left in graph.unread if left.span is not None]
    doubts += swallowed(graph)
    if not doubts:
        return tuple(items)
    spans = spans_of(graph)
    return tuple(_one(survey, item, spans.get(item.outcome.item), ends, doubts) for item in items)


def _one(survey: Survey, item: Asked, span: Span | None, ends: Sequence[int], doubts: Sequence[Doubt]) -> Asked:
    outcome = item.outcome
    if outcome.status != "met" or span is None:
        return item
    clause = bisect_right(ends, span.start)
    # A length may be that of something else, or an area that of a part of the floor.
    kind = "entity" if outcome.item.endswith((".metres", "room.area", "room.height")) else outcome.kind
    for doubt in doubts:
        beside = kind in doubt.kinds and (
            bisect_right(ends, doubt.span.start) == clause or doubt.span.start < span.start < doubt.until
        )
        inside = outcome.kind in _WITHIN and span.start <= doubt.span.start < span.end
        if (beside or inside) and not is_so(survey, doubt, outcome):
            reason = f"{outcome.reason}; '{doubt.words}' beside it was not understood"
            return replace(item, outcome=outcome.model_copy(update={"status": "partly", "reason": reason}))
    return item


__all__ = ["doubted"]
