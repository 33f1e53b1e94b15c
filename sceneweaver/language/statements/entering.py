"""Sides as seen by who comes in: "a bench on the left as you enter, hooks on the right, a console straight ahead".

In a sentence that says so, left, right and ahead of nothing are those of the room. The words are put in the terms of
its walls, and the words about coming in are blanked.
"""

from __future__ import annotations

import re

from ..parsed import Parsed
from ..source import Source
from ..vocabulary import words
from .phrases import Edits, one_of

_SAID = words("entering")
_ROOM = r"(?:\s(?:the|this|my|our|a)\s(?:[a-z-]+\s){0,2}?(?:room|hall|shop|flat|space|house|kitchen|office))?"
_THROUGH = rf"(?:\s{one_of(_SAID['through'])}\s(?:the|its|a)\s(?:[a-z-]+\s)?{one_of(_SAID['openings'])})?"
_DOOR = rf"(?:the|its)\s(?:[a-z-]+\s)?{one_of(_SAID['openings'])}"
_ENTERING = re.compile(
    rf"\b(?:(?:{one_of(_SAID['when'])}\s)?(?:{one_of(_SAID['who'])}\s(?:first\s|just\s)?)?{one_of(_SAID['acts'])}"
    rf"(?!\s(?:from|into)?\s?(?:left|right))\b{_ROOM}{_THROUGH}|{one_of(_SAID['seen'])}\sfrom\s{_DOOR}|"
    rf"(?<!away )(?<!far )\bfrom\s(?:where you come in|{_DOOR})(?=\s?[,.]|$))"
    r"(?:\s(?:and\s)?you(?:'ll)?\s(?:see|find|face|get)\b)?"
)
_SIDE = re.compile(
    rf"\b(?:(?P<before>{one_of(_SAID['before'])})\s)?(?:the|your|its|one's)\s(?:very\s|far\s)?(?P<side>left|right)"
    rf"(?:[\s-]hand)?(?:\sside)?\b(?!\s{one_of(_SAID['nouns'])}\b)(?!\s[a-z]+\s?(?:wall|corner)\b)"
)
_AHEAD = re.compile(rf"\b{one_of(_SAID['ahead'])}\b")
_OF_DOOR = re.compile(rf"\b(?P<side>left|right)(?:[\s-]hand side)?\sof\s(?:{_DOOR})[\s,]*(?={_ENTERING.pattern})")
_LEAVES = re.compile(r"\b(?:leaves?|leaving|goe?s? out|out (?:by|through|at)|exits?)\b")
_SHORT = {"left": "lhs", "right": "rhs"}


def entering(source: Source, parsed: Parsed) -> None:
    """Puts sides as seen by who comes in in the terms of walls."""
    edits = Edits(source)
    for found in list(_OF_DOOR.finditer(source.text)):  # who looks at the door from within has it the other way
        entered = _ENTERING.match(source.text, found.end())
        if entered is not None:
            other = "right" if found["side"] == "left" else "left"
            edits.take(found.start(), entered.end(), f"{other} of the door")
    for found in list(_ENTERING.finditer(source.text)):
        start = max(source.text.rfind(c, 0, found.start()) for c in ".;") + 1
        ends = [k for c in ".;" if (k := source.text.find(c, found.end())) >= 0]
        end = min(ends, default=len(source.text))
        if _LEAVES.search(source.text, found.end(), end):
            continue  # "enter at the right, leave at the left" is said of two doors
        sides = [m for m in _SIDE.finditer(source.text, start, end) if edits.free(*m.span())]
        ahead = [m for m in _AHEAD.finditer(source.text, start, end) if edits.free(*m.span())]
        if not (sides or ahead):
            continue
        edits.take(*found.span())
        for side in sides:
            edits.take(*side.span(), f"on {_SHORT[side['side']]}")
        for one in ahead:
            edits.take(*one.span(), "on far wall")


__all__ = ["entering"]
