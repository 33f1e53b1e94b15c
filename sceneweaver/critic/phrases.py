"""Where in the text of a request its items stand, with what became of them."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from sceneweaver.language import SceneGraph, Span
from sceneweaver.language.coverage import UNITS
from sceneweaver.rules.faults import number

from .model import Alignment, ItemOutcome

_NUMBER = re.compile(r"\d+(?:[.,]\d+)?")


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
            span = entity.span if key == "metres" else None
            found[f"{entity.id}.{key}"] = f"{getattr(entity, key, None) or key} {entity.noun}", span
        for attribute in entity.attributes:
            found[attribute.id] = f"{attribute.words or attribute.value} {entity.noun}", attribute.span
    for k, said in enumerate(graph.relations):
        words = f"{said.subject} {said.words or said.type} {' and '.join(said.targets)}".replace("_", " ")
        found[said.id or f"relation-{k}"] = words, said.span
    for k, excluded in enumerate(graph.exclusions):
        whole = excluded.relation or excluded.colors or excluded.materials or excluded.styles
        words = excluded.words if whole else f"no {excluded.words}"
        found[excluded.id or f"exclusion-{k}"] = words.replace("_", " "), excluded.span
    found |= {f"room.{one.id}": (one.words, one.span) for one in graph.openings}
    for name in ("area", "height"):
        found[f"room.{name}"] = name, _of_length(graph, getattr(graph, name))
    for name in ("free_area", "capacity", "arrangement", "amount"):
        several = getattr(graph, {"capacity": "capacities"}.get(name, f"{name}s"))
        found |= {one.id or f"{name}-{k}": (one.words, one.span) for k, one in enumerate(several)}
    found |= {one.id: (one.words, one.span) for one in graph.measures}
    for k, unread in enumerate(graph.unread):
        found[f"unread-{k}"] = unread.words, unread.span
    return found


def _of_length(graph: SceneGraph, value: float | None) -> Span | None:
    """Where the first number stands that is a length or an area of the room, in some unit."""
    if not value:
        return None
    slack = number("spoken")
    for match in _NUMBER.finditer(graph.text):
        spoken = float(match[0].replace(",", "."))
        if any(math.isclose(spoken * unit, value, rel_tol=slack) for unit in UNITS):
            return Span(*match.span())
    return None


def _of_room(graph: SceneGraph, item: str) -> tuple[str, Span | None]:
    """Facts about the room have no span of their own: the kind of room stands where its words do."""
    name = item.partition(".")[2]
    if name == "room_type" and graph.room_words:
        words = re.escape(graph.room_words)  # some scripts have no blanks between words
        found = re.search(rf"\b{words}\b", graph.text, re.IGNORECASE) or re.search(words, graph.text, re.IGNORECASE)
        return graph.room_words, Span(*found.span()) if found else None
    return name.replace("_", " "), None


__all__ = ["Phrase", "phrases", "spans_of"]
