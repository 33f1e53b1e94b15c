"""What two readers read differently, and how it is said in a line."""

from __future__ import annotations

import re
from typing import Any, Literal

from sceneweaver.scene.base import FrozenModel

from ..model import Entity, SceneGraph, Span

FOREIGN = 0.3
"""Share of a request that the offline reader left unread from which on it does not count where the model says that the
language is none that it reads."""


class Disagreement(FrozenModel):
    """What two readers read differently.

    ``item`` is the id of an entity, relation or exclusion of the graph that is used, or of the offline one where it has
    none, or "room"; ``used`` says whose reading is in the graph.
    """

    item: str
    field: str
    offline: str
    model: str
    used: Literal["offline", "model"] = "model"
    span: Span | None = None

    def __str__(self) -> str:
        if self.field == "language":
            return f"the request is in {self.model}; the offline reader reads English only and was not compared"
        said = f"{self.offline or 'nothing'} offline, {self.model or 'nothing'} by the model"
        return f"{self.item}, {self.field}: {said}; the {self.used} reading is used"

    @classmethod
    def of_language(cls, language: str) -> Disagreement:
        """The one row about a request that the offline reader cannot read."""
        return cls(item="request", field="language", offline="", model=language)


def is_foreign(offline: SceneGraph, language: str) -> bool:
    """Whether the offline reader's graph says nothing because the request is in another language than English."""
    nothing = offline.room_type is None and all(entity.generic for entity in offline.entities)
    if nothing and any("only English" in note for note in offline.notes):
        return True
    if any("word by word" in note for note in offline.notes):
        return True  # names of things at best, no sentences
    if language.strip().lower()[:2] in ("", "en"):
        return False
    if nothing:
        return True
    unread = sum(len(left.words) for left in offline.unread)
    return unread >= FOREIGN * len(offline.text)


def head_of(span: Span | None, text: str) -> Span | None:
    """Where the noun stands in a noun phrase of English: its last word."""
    if span is None:
        return None
    words = list(re.finditer(r"\w+", text[span.start : span.end]))
    return Span(span.start + words[-1].start(), span.start + words[-1].end()) if words else span


def overlap(one: Span | None, other: Span | None) -> bool:
    """Whether two spans have characters in common."""
    return one is not None and other is not None and one.start < other.end and other.start < one.end


def thing_of(thing: Entity) -> str:
    """A thing in few words: how many of which category."""
    return f"{count_of(thing.count)} {thing.category}".strip()


def count_of(count: tuple[int, int] | None) -> str:
    """A count; nothing where none was given."""
    return "" if count is None else f"{count[0]}" if count[0] == count[1] else f"{count[0]} to {count[1]}"


def size_of(size: tuple[float | None, ...]) -> str:
    """Lengths in metres; nothing where none was given."""
    return "" if size == (None, None, None) else " x ".join("?" if s is None else f"{s:g}" for s in size) + " m"


def fact_of(value: Any) -> str:
    """A fact about the room."""
    if isinstance(value, tuple):
        return ", ".join(fact_of(v) for v in value)
    return f"{value:g}" if isinstance(value, float) else str(value).replace("_", " ") if value is not True else "yes"
