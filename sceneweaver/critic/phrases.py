"""Where in the text of a request its items stand, with what became of them."""

from __future__ import annotations

import re
from dataclasses import dataclass

from sceneweaver.language import SceneGraph, Span

from .model import Alignment, ItemOutcome


@dataclass(frozen=True)
class Phrase:
    """The words of one item; ``span`` is None where nobody noted where they stand."""

    words: str
    span: Span | None
    outcome: ItemOutcome


def phrases(graph: SceneGraph, found: Alignment) -> tuple[Phrase, ...]:
    """The words of every item that has an outcome, in the order of the outcomes."""
    words = _words(graph)
    rows = []
    for outcome in found.items:
        said, span = words.get(outcome.item, ("", None))
        if outcome.kind == "room" and span is None:
            said, span = _of_room(graph, outcome.item)
        if span is not None and not 0 <= span.start < span.end <= len(graph.text):
            span = None
        rows.append(Phrase(graph.text[span.start : span.end] if span is not None else said, span, outcome))
    return tuple(rows)


def spans_of(graph: SceneGraph) -> dict[str, Span]:
    """Where the items of a graph stand in its text, by id; items without a place are left out."""
    return {item: span for item, (_, span) in _words(graph).items() if span is not None}


def _words(graph: SceneGraph) -> dict[str, tuple[str, Span | None]]:
    """Words and span by id of item; the names of items without an id are those of their outcomes."""
    found: dict[str, tuple[str, Span | None]] = {}
    for entity in graph.entities:
        found[entity.id] = entity.noun, entity.span
        for key in ("color", "material", "style", "size", "metres"):
            found[f"{entity.id}.{key}"] = f"{getattr(entity, key, None) or key} {entity.noun}", None
        for attribute in entity.attributes:
            found[attribute.id] = f"{attribute.words or attribute.value} {entity.noun}", attribute.span
    for k, said in enumerate(graph.relations):
        words = f"{said.subject} {said.words or said.type} {' and '.join(said.targets)}".replace("_", " ")
        found[said.id or f"relation-{k}"] = words, said.span
    for k, excluded in enumerate(graph.exclusions):
        words = excluded.words if excluded.relation else f"no {excluded.words}"
        found[excluded.id or f"exclusion-{k}"] = words.replace("_", " "), excluded.span
    for several in (graph.openings, graph.free_areas, graph.capacities, graph.arrangements):
        found |= {f"room.{one.id}": (one.words, one.span) for one in several}
    found |= {one.id: (one.words, one.span) for one in graph.measures}
    for k, unread in enumerate(graph.unread):
        found[f"unread-{k}"] = unread.words, unread.span
    return found


def _of_room(graph: SceneGraph, item: str) -> tuple[str, Span | None]:
    """Facts about the room have no span of their own: the kind of room stands where its words do."""
    name = item.partition(".")[2]
    if name == "room_type" and graph.room_words:
        words = re.escape(graph.room_words)  # some scripts have no blanks between words
        found = re.search(rf"\b{words}\b", graph.text, re.IGNORECASE) or re.search(words, graph.text, re.IGNORECASE)
        return graph.room_words, Span(*found.span()) if found else None
    return name.replace("_", " "), None


__all__ = ["Phrase", "phrases", "spans_of"]
