"""How far apart the middles of neighbours are: "1.6 m between centres", "centre to centre 1.5 m"."""

from __future__ import annotations

import re

from ..model import Arrangement
from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from .lengths import LENGTH, length_of
from .phrases import Edits, noun_before

LINED = ("row", "rows", "grid", "walls", "sides", "cluster", "back_to_back")
"""Patterns whose neighbours are so far apart."""

_LEAST = r"(?P<least>at least |no less than |minimum |min\.? |not less than )?(?:about |around |roughly |exactly )?"
_MIDDLES = r"(?:cent(?:re|er)s?|middles|axes|axis)"
_FORMS = (
    rf"{_LEAST}{LENGTH},? ?(?:apart,? )?(?:measured )?(?:between|from) (?:the |their )?(?:(?P<noun>[a-z]+?)s? )?"
    rf"{_MIDDLES}\b(?: of (?:the )?(?P<of>[a-z]+)| to {_MIDDLES})?",
    rf"{_LEAST}{LENGTH},? ?(?:apart,? )?(?:from )?(?:{_MIDDLES}[ -]to[ -]{_MIDDLES}|on {_MIDDLES}|{_MIDDLES})\b",
    rf"\b(?:the |their )?(?:{_MIDDLES}[ -]to[ -]{_MIDDLES}|(?:(?P<noun>[a-z]+?) )?{_MIDDLES}) "
    r"(?:are |is |of |distance )*"
    rf"{_LEAST}{LENGTH}(?: apart| from each other)?",
)
_PATTERNS = tuple(re.compile(rf",? ?(?:and |with )?{form}") for form in _FORMS)


def spacings(source: Source, parsed: Parsed) -> None:
    """Reads distances between the middles of neighbours into their arrangement; a row where they have none."""
    edits = Edits(source)
    for pattern in _PATTERNS:
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                _read(m, edits, parsed)


def _read(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    groups = m.groupdict()
    named = groups.get("noun") or groups.get("of") or ""
    named = named if named and match_of(singular(named)).how != "generic" else ""
    told = [a for a in parsed.arrangements if a.pattern in LINED]
    alike = [a for a in told if not named or singular(a.entity).split()[-1] == singular(named)]
    pitch, least = length_of(m)[0], bool(groups["least"])
    if alike:
        k = parsed.arrangements.index(alike[-1])
        more = (*alike[-1].more, edits.take(m.start(), m.end()))
        update = {"pitch": pitch, "at_least": least, "more": more}
        parsed.arrangements[k] = alike[-1].model_copy(update=update)
        return
    noun = named or noun_before(edits.source.text, m.start())
    if not noun or match_of(singular(noun)).how == "generic":
        return
    words = m[0].strip(" ,")
    span = edits.take(m.start(), m.end())
    parsed.arrangements.append(
        Arrangement(entity=noun, pattern="row", rows=1, pitch=pitch, at_least=least, words=words, span=span)
    )


__all__ = ["spacings"]
