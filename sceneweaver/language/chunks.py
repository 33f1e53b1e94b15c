"""Pieces of sentences: noun phrases, words of place, verbs and what binds them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

from .tokens import Token, looks_adjective

Kind = Literal[
    "noun",
    "place",
    "verb",
    "with",
    "without",
    "and",
    "while",
    "comma",
    "stop",
    "bracket",
    "adjective",
    "purpose",
    "word",
    "only",
    "aside",
]

QUALITIES = (
    *("color", "material", "finish", "styles", "scale", "shape", "moods", "dim", "density", "room_scale"),
    "adjective",
)
"""Kinds of words that say what a thing is like."""

OPEN = (
    *QUALITIES,
    *("noun", "room", "group", "abstract", "parts", "region", "containers", "collective", "whom", "people_words"),
    *("place", "matter"),
)
"""Kinds of words that a noun phrase is made of."""

CLOSED = (
    *("break", "preposition", "and", "with", "while", "neg", "pron", "det", "place_adverb", "mutual", "each", "both"),
    *("partial", "rest", "aside"),
)
"""Kinds of words that end a noun phrase, or begin the next."""

EACH = ("each", "every")
"""Articles that speak of every single one."""

_HEADS = (
    *("noun", "room", "group", "place", "region", "parts", "abstract", "people_words", "whom", "collective"),
    *("containers", "matter"),
)


@dataclass
class NounPhrase:
    """What a noun phrase says.

    ``what`` is thing, pronoun, place (of the room), room, group (a part of a room that stands for things), region
    (of a thing), part, abstract, matter (no object), people, number (nothing but a number).
    """

    what: str
    text: str = ""
    start: int = 0
    end: int = 0
    value: Any = None
    determiner: str = ""
    count: tuple[int, int] | None = None
    bound: str | None = None
    plural: bool = False
    paired: bool = False
    """Whether it is counted in pairs: "a pair of"."""
    both: bool = False
    """Whether it is "both" of two."""
    of_group: bool = False
    """Whether it is each of a group, with the number of the group: "each of the five benches"."""
    qualities: list[Token] = field(default_factory=list)
    length: float | None = None
    sides: tuple[float, ...] | None = None
    of: NounPhrase | None = None
    """What it is of: "the top of the desk", "a bowl of fruit", and "its" as a pronoun."""

    @property
    def definite(self) -> bool:
        """Whether it is something that was named before."""
        return self.determiner in ("the", "this", "that", "these", "those", "their", "its")


@dataclass
class Chunk:
    """A piece of a sentence; ``value`` is a `NounPhrase`, a `Place`, a `Verb` or a word."""

    kind: Kind
    text: str
    start: int
    end: int
    value: Any = None
    bare: bool = False
    """Of a place: whether it may stand without a target."""
    mutual: bool = False
    passive: bool = False
    """Of a verb: whether it is a participle with "by", "with" and the like."""


def nominal(token: Token) -> bool:
    """Whether a token can be the head of a noun phrase."""
    if token.has(*_HEADS):
        return True
    if set(token.kinds) == {"verb"} and token.kinds["verb"].form == "base":  # "the stand"
        return True
    return not token.kinds and not looks_adjective(token.text) and not token.text.endswith("ly")


def bounded(value: tuple[int, int], bound: str | None) -> tuple[int, int]:
    """The interval of a number with "at least" and the like."""
    n = value[1]
    return {
        "least": (value[0], max(n, min(400, n + 4))),
        "above": (n + 1, n + 5),
        "most": (min(1, n), n),
        "below": (min(1, max(0, n - 1)), max(0, n - 1)),
        "about": value,
        None: value,
    }[bound]
