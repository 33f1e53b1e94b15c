"""How far apart neighbours are: "1.6 m between centres", "centre to centre 1.5 m", "gaps of 20 cm", "60 cm apart"."""

from __future__ import annotations

import re
from bisect import bisect_left

from ..model import Arrangement, FreeArea
from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from .lengths import LENGTH, length_of
from .phrases import Edits, noun_before

LINED = ("row", "rows", "grid", "walls", "sides", "cluster", "back_to_back")
"""Patterns whose neighbours are so far apart."""

BACK = 14
"""Characters before a distance in which "at least" stands."""

_AT_LEAST = re.compile(r"\b(?:at least|no less than|not less than|minimum|min\b)")
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

_GAPS = r"(?:(?:clear |equal |even |regular |free )?(?:gaps?|spaces?|spacing|intervals))"
_EACH = r"(?:each other|each of them|each one|each|them|one another|neighbou?rs)"
_CLEAR = tuple(
    re.compile(rf",? ?(?:\b(?:and|with|at|are|is|all|stand|standing|placed|set|kept|must be|should be) ){{0,4}}{form}")
    for form in (
        rf"{_GAPS} of {LENGTH}(?: (?:in )?between {_EACH}\b)?",
        rf"\bspaced (?:out )?(?:at |by |every )?{LENGTH}(?: apart)?",
        rf"{LENGTH} {_GAPS}(?: (?:in )?between {_EACH})?\b(?! between| for| to| in| of)",
        rf"\bno (?:closer|nearer)(?: together| to {_EACH})? than {LENGTH}",
        rf"{LENGTH} apart\b(?: from {_EACH})?",
        rf"{LENGTH} (?:of (?:space|room|floor) )?between {_EACH}\b(?! and)",
    )
)
"""Clear distances between things of one kind, which are named before."""


def spacings(source: Source, parsed: Parsed) -> None:
    """Reads distances between the middles of neighbours into their arrangement; a row where they have none.

    Clear gaps go into the arrangement as well; where things have none they are floor to keep free between them.
    """
    edits = Edits(source)
    for pattern in _PATTERNS:
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                _read(m, edits, parsed)
    for pattern in _CLEAR:
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                _read_clear(m, edits, parsed)


def _read_clear(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """A clear gap between the things of one kind that were named before it in the sentence."""
    text, length = edits.source.text, length_of(m)[0]
    said = edits.source.span(m.start(), m.end())
    lined = [
        (k, a)
        for k, a in enumerate(parsed.arrangements)
        if a.pattern in LINED and a.spacing is None and a.pitch is None and a.span is not None
        and a.span.end <= said.start and "." not in text[_behind(edits, a.span.end) : m.start()]
    ]  # fmt: skip
    if lined:
        k, own = lined[-1]
        span = edits.take(m.start(), m.end())
        parsed.arrangements[k] = own.model_copy(update={"spacing": length, "more": (*own.more, span)})
        return
    noun = noun_before(text, m.start())
    last = noun.split()[-1] if noun else ""
    if singular(last) == last or match_of(singular(noun)).how == "generic":
        return
    words = m[0].strip(" ,")
    span = edits.take(m.start(), m.end(), "," if m[0].startswith(",") else "")
    area = FreeArea(kind="gap", size=(length, length), targets=(noun,), words=words, span=span)
    parsed.free_areas.append(area)


def _behind(edits: Edits, end: int) -> int:
    """The character of the source that stands in the request at ``end`` or behind it."""
    return bisect_left(edits.source.origin, end)


def _read(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    groups = m.groupdict()
    named = groups.get("noun") or groups.get("of") or ""
    named = named if named and match_of(singular(named)).how != "generic" else ""
    told = [a for a in parsed.arrangements if a.pattern in LINED]
    alike = [a for a in told if not named or singular(a.entity).split()[-1] == singular(named)]
    spoken = edits.source.spoken[max(0, m.start() - BACK) : m.end()]  # a reader before may have taken "at least" out
    pitch, least = length_of(m)[0], bool(groups["least"] or _AT_LEAST.search(spoken))
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
