"""How people ask for free floor: the templates of ``lexicon/free_floor.yaml`` as patterns."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, Literal

from ..vocabulary import words

_DETERMINERS = (
    "the|a|an|all|each|every|any|both|either|of|two|three|four|five|six|our|my|its|this|that|these|those|their|"
    r"\d{1,2}"
)
_THINGS = ("a", "b", "way_to")
"""Groups of the words for a thing."""


@dataclass(frozen=True)
class Phrase:
    """One way of asking for free floor.

    ``says`` is its pattern as text, ``width`` [m] what is meant where no measure is given (None: one has to be), and
    ``side`` that of its target.
    """

    kind: Literal["rectangle", "circle", "clearance", "gap", "path"]
    says: str
    width: float | None = None
    side: str = "any"

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """Its pattern, compiled when a text is first looked through for it: most requests give no measure."""
        return re.compile(self.says)


@cache
def phrases() -> tuple[Phrase, ...]:
    """All of them, in the order in which they are tried."""
    data = words("free_floor")
    return tuple(
        Phrase(
            row["kind"],
            _pattern(row["says"], data),
            data["widths"][row["width"]] if "width" in row else None,
            row.get("side", "any"),
        )
        for row in data["phrases"]
    )


@cache
def place_words() -> dict[str, str]:
    """Parts of the room by the last word of how they are called."""
    return {word: place for place, spoken in words("free_floor")["places"].items() for word in spoken}


def _pattern(template: str, data: dict[str, Any]) -> str:
    text = template
    for _ in range(2):  # words have words in them
        for name, meant in data["words"].items():
            text = text.replace(f"<{name}>", meant)
    text = text.replace(" ", r"\s+").replace(r"\s+?", r"\s*").replace("¤", r"¤\s*")
    for name in _THINGS:
        text = text.replace(f"<{name.upper()}>", _thing(name, data["stop"]))
    return rf"(?<![\w-]){text}(?![\w-])"


def _thing(name: str, stop: list[str]) -> str:
    word = rf"(?!(?:{'|'.join(stop)})\b)[a-z][a-z'/-]{{0,24}}"
    return (
        rf"(?:(?:{_DETERMINERS})\s+){{0,3}}(?P<{name}>chest\s+of\s+drawers|{word}(?:\s+{word}){{0,3}})"
        r"(?:\s+of\s+the\s+(?:room|floor))?"
    )


_LEADS = re.compile(
    r"(?:\b(?:please|keep|leave|allow|provide|reserve|have|make|sure|with|and|but|so|want|wants|get|gets|plus|give|also|"
    r"only|just|still|there|there's|is|are|should|must|be|i|we|you|they|a|an|some|the|enough|nice|clean|proper|to|it|"
    r"comfortable|comfortably|possible|straight|direct|one|of|at|least|needs?|requires?|requiring|staff|people|has|"
    r"which|that|would|like|for|as|left|around|walkers?|wheelchairs?|customers?|door|stays?|where)\s+)+$"
)
"""Words before a phrase that say no more than that it is wanted."""

_ENDS = re.compile(
    r"\s{0,2},?\s{0,2}(?:at\s+(?:the\s+very\s+)?least|(?:as\s+a\s+)?minimum|min\b\.?|or\s+(?:more|wider|so)\b|wide\b|"
    r"across\b|in\s+(?:width|diameter|total)\b|deep\b|please\b|because\s+of\s+[a-z' -]{2,40}(?=[.,;)]|$)|"
    r"(?:for|so)\s+(?:the\s+|a\s+)?(?:staff|safety|wheelchairs?|people|customers?|walkers?|prams?|strollers?|trolleys?)\b|"
    r"and\s+to\s+(?:these|those|the)\s+[a-z]{2,20}\b(?=\s*[.,;)]|$)|"
    r"(?:for\s+[a-z]{2,12}\s+)?to\s+(?:pass|walk|get\s+(?:by|past|through)|move)\b)"
)
"""Words behind a phrase that belong to it."""

_BEFORE = 120
"""Characters before a phrase that may belong to it."""


def widened(text: str, start: int, end: int) -> tuple[int, int]:
    """The place of a phrase with the words before and behind it that say nothing else."""
    before = _LEADS.search(text, max(0, start - _BEFORE), start)
    while (behind := _ENDS.match(text, end)) is not None:
        end = behind.end()
    return (before.start() if before is not None else start), end


__all__ = ["Phrase", "phrases", "place_words", "widened"]
