"""A floor of two rectangles: "4 x 6 m plus a 3 x 1.5 m recess", "L-shaped, 6 x 4 m and 3 x 2 m"."""

from __future__ import annotations

import re
from functools import cache

from ..parsed import Left, Parsed
from ..source import Source
from ..vocabulary import words
from .phrases import one_of

APART = 60
"""Characters that may stand between the sides of the two parts."""

LEAST = 0.8
"""Side [m] from which on what sticks out is a part of the floor, and no niche in a wall."""


def wings(source: Source, parsed: Parsed) -> None:
    """Reads the sides of the main part and of what sticks out of it; the words about the latter are blanked."""
    m = _pattern().search(source.text)
    if m is None or not (m["part"] or _of_shape().search(source.spoken)):
        return
    main, wing = source.sides.get(m.start("main")), source.sides.get(m.start("wing"))
    if main is None or wing is None or min(*main[:2], *wing[:2]) < LEAST or max(wing[:2]) >= max(main[:2]):
        return
    parsed.shape, parsed.wing = "L", (wing[0], wing[1])
    parsed.sides.append(main)
    for start, end in (m.span("main"), m.span("rest")):
        source.text = source.text[:start] + " " * (end - start) + source.text[end:]
    if m["part"]:
        for again in list(re.finditer(rf"\b(?:in|inside|into|between) the {re.escape(m['part'])}\b", source.text)):
            parsed.unread.append(Left(again[0], *again.span()))  # no relation says that yet
            source.text = source.text[: again.start()] + " " * len(again[0]) + source.text[again.end() :]


@cache
def _of_shape() -> re.Pattern[str]:
    return re.compile(r"\bl[\s-]?(?:shaped?|form)\b|\bin (?:an )?l\b|\bl\b(?= room)")


@cache
def _pattern() -> re.Pattern[str]:
    parts = one_of(words("openings")["wings"])
    return re.compile(
        rf"(?P<main>§)[^.§]{{0,{APART}}}?(?P<rest>(?:\b(?:plus|and|with|,)\s+)?(?:an?\s+|the\s+|one\s+)?(?:small\s+|short\s+|other\s+)?"
        rf"(?:(?:{parts}|leg)\s+(?:of\s+)?)?(?P<wing>§)(?:\s+(?:large|big|deep))?(?:\s+(?P<part>{parts}))?"
        r"(?:\s(?:sticking out|at|on|off)\s(?:at\s)?(?:one|the|an?)\s(?:end|side|corner)(?:\sof\s(?:a|the|one)\s"
        r"(?:long|short|longer|shorter)\s(?:side|wall))?)?)"
    )


__all__ = ["wings"]
