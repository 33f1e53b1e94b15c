"""Sentences about a scene, each with the facts that it states."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from .nouns import sentence


@dataclass(frozen=True)
class Statement:
    """One fact that a text states.

    Attributes:
        predicate: a relation of the catalogue that holds with its own numbers (``against_wall``, ``facing``,
            ``between``, ...), or one of: ``room_type``, ``floor_area`` [m2], ``extent`` (sides of a rectangular room
            [m], the longer first), ``corners``, ``doors``, ``windows``, ``window_side`` (of who comes in), ``count``
            (objects of a category), ``color``, ``material``, ``rests_on``, ``rests_in`` (an upper or an inner surface
            of the second object), ``along_wall``, ``on_wall``, ``on_floor``, ``on_ceiling``, ``left_from_door``,
            ``right_from_door`` (over 25 degrees aside for who looks straight in), ``ahead_of_door`` (under 10).
        objects: ids, the subject first.
        value: what is said of them, where the predicate needs it.
    """

    predicate: str
    objects: tuple[str, ...] = ()
    value: Any = None

    def to_dict(self) -> dict[str, Any]:
        """JSON data."""
        data: dict[str, Any] = {"predicate": self.predicate, "objects": list(self.objects)}
        return data if self.value is None else {**data, "value": self.value}


@dataclass(frozen=True)
class Text:
    """Some words and the facts that they state."""

    words: str
    statements: tuple[Statement, ...] = field(default=())

    def to_dict(self) -> dict[str, Any]:
        """JSON data."""
        return {"text": self.words, "statements": [s.to_dict() for s in self.statements]}


def joined(texts: Iterable[Text], between: str = " ") -> Text:
    """Several sentences as one text."""
    parts = list(texts)
    facts = dict.fromkeys(_key(s) for t in parts for s in t.statements)
    by_key = {_key(s): s for t in parts for s in t.statements}
    return Text(between.join(t.words for t in parts), tuple(by_key[k] for k in facts))


def said(words: str, *statements: Statement) -> Text:
    """A sentence with its facts."""
    return Text(sentence(words), statements)


def _key(statement: Statement) -> str:
    return f"{statement.predicate} {statement.objects} {statement.value}"
