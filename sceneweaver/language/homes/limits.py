"""Floor that is not to be gone above or below: "max 90 m2", "not over", "at least", "70 m2 or less"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal

from .parts import Named, Reading
from .tokens import Token

Limit = Literal["most", "least", ""]

REACH = 5
"""Tokens before an area in which a word for a limit may stand."""

ROOM = 0.88
"""Share of the most that a home may have from which on it may have it: walls and modules play as well."""

ABOVE = 1.1
"""Share of the least that a home has to have up to which it may have it."""

LIMITS = (
    "no",
    "not",
    "more",
    "less",
    "larger",
    "smaller",
    "bigger",
    "than",
    "over",
    "under",
    "above",
    "below",
    "max",
    "min",
)
"""Words between the name of a room and its area that say a limit."""

_MORE = r"(?:more|larger|bigger|greater|over|above|exceed(?:ing)?)(?: than)?"
_LESS = r"(?:less|smaller|lower|under|below)(?: than)?"
_NOT = r"\b(?:no|not|never|don't go|mustn't|must not|nothing|shouldn't|cannot|can't)(?: (?:be|go|get|exceed))?"
_TAIL = r"(?: (?:of|is|be|floor|area|size|floor area|the|a|total|total of|at|to))*$"
_MOST = re.compile(
    rf"(?:{_NOT} {_MORE}|\bat (?:the )?most|\bup to|\bmax(?:imum)?|\bwithin"
    rf"|\bnot exceed(?:ing)?|\bcap(?:ped)?|\blimit(?:ed)?){_TAIL}"
)
_LEAST = re.compile(rf"(?:{_NOT} {_LESS}|\bat (?:the )?least|\bmin(?:imum)?|\bupwards?){_TAIL}")
_UNDER, _OVER = (
    re.compile(rf"\b{_LESS}{_TAIL}"),
    re.compile(rf"\b(?:more than|over|above|larger than|bigger than){_TAIL}"),
)
_MOST_BEHIND = re.compile(
    r"^(?:(?:as )?(?:an? |the )?(?:max(?:imum)?|tops|at most|limit|upper limit)"
    r"|or (?:less|under|below|smaller))\b"
)
_LEAST_BEHIND = re.compile(
    r"^(?:(?:as )?(?:an? |the )?(?:min(?:imum)?|at least)|or (?:more|over|larger|bigger|above)|and up)\b"
)

_BEFORE: tuple[tuple[Limit, re.Pattern[str]], ...] = (
    ("most", _MOST),
    ("least", _LEAST),
    ("most", _UNDER),
    ("least", _OVER),
)
_BEHIND: tuple[tuple[Limit, re.Pattern[str]], ...] = (("most", _MOST_BEHIND), ("least", _LEAST_BEHIND))
"""Patterns for words before an area, and behind it, in the order in which they are tried."""


def limit_of(tokens: Sequence[Token], at: int) -> tuple[Limit, range]:
    """Whether an area is the most or the least that there is to be, and the tokens that say so.

    Examples:
        >>> from sceneweaver.language.homes.limits import limit_of
        >>> from sceneweaver.language.homes.tokens import spoken
        >>> tokens = spoken("a flat of no more than 90 m2").tokens
        >>> limit_of(tokens, len(tokens) - 1)[0]
        'most'
    """
    start = at
    while start > 0 and at - start < REACH and not tokens[start - 1].breaks:
        start -= 1
    before = " ".join(t.text for t in tokens[start:at])
    for limit, pattern in _BEFORE:
        found = pattern.search(before)
        if found is not None:
            return limit, range(_begin(tokens, start, at, found.start()), at)
    stop = at + 1
    while stop < len(tokens) and stop - at < 4 and not tokens[stop].breaks:
        stop += 1
    behind = " ".join(t.text for t in tokens[at + 1 : stop])
    for limit, pattern in _BEHIND:
        found = pattern.search(behind)
        if found is not None:
            words, last = len(found[0].split()), at
            while words > 0 and last + 1 < stop:
                last += 1
                words -= len(tokens[last].text.split())
            return limit, range(at + 1, last + 1)
    return "", range(at, at)


def say_limit(reading: Reading, room: Named, at: int) -> None:
    """ "At most 5 m2", of a room; "no bedroom under 9 m2" is the least of each."""
    tokens = reading.tokens
    limit, words = limit_of(tokens, at)
    low, high = tokens[at].get("area")
    no = next((k for k in range(room.first - 1, max(-1, room.first - 3), -1) if tokens[k].has("no")), None)
    if limit and no is not None and not tokens[no].done:
        limit = "least" if limit == "most" else "most"
        reading.did(no, "area")
        room.all, room.count, room.told = True, None, ""
    if limit == "most":
        room.most, room.area = high, (round(0.75 * high, 1), high)
    elif limit == "least":
        room.least, room.area = low, (low, round(1.35 * low, 1))
    for k in words:
        reading.did(k, "area")


def _begin(tokens: Sequence[Token], start: int, at: int, offset: int) -> int:
    """The number of the token in which a character of the words before an area stands."""
    seen = 0
    for k in range(start, at):
        seen += len(tokens[k].text) + 1
        if offset < seen:
            return k
    return at
