"""Aisles in words: a way through the middle of rows, or between two of them."""

from __future__ import annotations

import re

from .lengths import PLAIN, plain_length

WIDE = 1.2
"""Width [m] of an aisle of which no width is said."""

ROWS = ("rows", "grid", "sides", "walls")
"""Patterns that an aisle parts."""

_ABOUT = "(?:about |around |at least |roughly )?"
_LEAD = r"\s*,?\s*(?:and |with |w/ |leaving |separated by |split by )*(?:the |an? |its |their )?"

AISLE = re.compile(
    rf"{_LEAD}(?:{_ABOUT}(?P<before>{PLAIN})[ -](?:wide )?)?"
    r"(?:(?:clear|free|central|centre|center|middle|wide|narrow|open) )*"
    r"\b(?:aisle|gangway|walkway|corridor)s?\b"
    rf"(?:,? (?:of |is |at least |about )*{_ABOUT}(?P<after>{PLAIN})(?: (?:wide|across))?)?"
    r"(?: (?:in )?between(?: (?:them|the rows|the two|each|both|the two rows))?"
    r"| (?:down|in|through|along|up) the (?:middle|centre|center))?"
    rf"(?:,? (?:of |is |at least |about )*{_ABOUT}(?P<last>{PLAIN})(?: (?:wide|across))?)?"
)
"""An aisle with its width, if one is said, and where it is."""


def aisle_at(text: str, at: int) -> re.Match[str] | None:
    """The aisle that is told of at a place in a text; None where there is none, or it is a way from one place to
    another."""
    found = AISLE.match(text, at)
    return None if found is None or leads(text, found.end()) else found


def leads(text: str, at: int) -> bool:
    """Whether what goes before a place is a way from somewhere to somewhere."""
    return re.match(r"\s*(?:from|to|into|towards)\b", text[at:]) is not None


def width_of(found: re.Match[str]) -> float:
    """The width [m] of what `AISLE` matched."""
    width = found["before"] or found["after"] or found["last"]
    return plain_length(width) if width else WIDE


__all__ = ["AISLE", "ROWS", "WIDE", "aisle_at", "leads", "width_of"]
