"""Items that are so, beside words that were not understood: nobody knows whether they are so as it was meant."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.language import SceneGraph, Span

from .phrases import spans_of
from .verdict import Asked

_END = re.compile(r"[.;:!?\n](?!\d)|,(?!\d)|\s-\s|[()]")

_DOUBTED = ("entity", "relation", "exclusion")
"""Kinds of items that are told by whole clauses; what a thing is like is told by its own words."""


def doubted(items: Sequence[Asked], graph: SceneGraph) -> tuple[Asked, ...]:
    """The items, of which those met count as partly met where their clause has words that were not understood."""
    ends = [match.start() for match in _END.finditer(graph.text)]
    lost: dict[int, str] = {}
    for unread in graph.unread:
        if unread.span is not None:
            lost.setdefault(bisect_right(ends, unread.span.start), unread.words)
    if not lost:
        return tuple(items)
    spans = spans_of(graph)
    return tuple(_one(item, spans.get(item.outcome.item), ends, lost) for item in items)


def _one(item: Asked, span: Span | None, ends: Sequence[int], lost: dict[int, str]) -> Asked:
    outcome = item.outcome
    if outcome.status != "met" or outcome.kind not in _DOUBTED or span is None:
        return item
    words = lost.get(bisect_right(ends, span.start))
    if words is None:
        return item
    reason = f"{outcome.reason}; '{words}' beside it was not understood"
    return replace(item, outcome=outcome.model_copy(update={"status": "partly", "reason": reason}))


__all__ = ["doubted"]
