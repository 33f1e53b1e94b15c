"""Built parts of a room that are only named: alcoves, chimney breasts; slopes, pits and skylights, which are not built.

A part of a wall that the request names is there, whether or not more is said of it; its words stay, as things are put
in it and at it. What cannot be built is told, with the place that is named by it ("under the slope").
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any, cast

from ..model import StatedOpening
from ..parsed import Parsed
from ..source import Source
from ..told_openings import is_bay
from ..vocabulary import words
from .phrases import NUMBER, Edits, number_of, one_of

_COUNTED = rf"(?:(?P<count>{NUMBER})\s(?:[a-z]+\s){{0,2}}?)?"
_PLACED = (
    r"(?:(?P<at>under|underneath|below|beneath|in|into|inside|within|on|at|against|along|around|over|above|by|near|"
    r"beside|from|of|with|has|and)\s)?(?P<det>(?:the|a|an|its|one|both|each)\s)?(?:(?:low|small|"
    r"large|big|old|deep|round|square|brick|exposed|steep|central|sunken|sunk|two|three|four|\d)\s){0,2}"
)
_IN_BAY = re.compile(r"\b(?:in|into|inside|within|flanking)\s(?:the|a)\s(?P<bay>bay)\b(?!\s[a-z]*(?:of|no|number)\b)")
_DIVIDES = re.compile(
    r"(?P<verb>\b(?:(?:that|which|to)\s)?(?:divides?|dividing|separates?|separating)\b)\s(?:off\s)?"
    r"(?:the|a|my|our|one)\s(?:[a-z]+\s){1,3}?(?P<from>from)\s(?:the|a|my|our|its)\s"
)
_HEIGHT = re.compile(
    r"^(?:\s(?:is|of|at|down|to|about|only|just|on|the|one|both|left|right|far|side|sides|end|back|towards|wall|high|"
    r"low|as|tall|\d+(?:[.,]\d+)?\s?(?:metres?|meters?|cm|m|ft|feet)\b))*"
)


_SEVERAL = ("niches", "wall niches", "alcoves", "recesses")


def built_parts(source: Source, parsed: Parsed) -> None:
    """Reads which built parts a request names; those that are not built are blanked."""
    _not_built(source, parsed)
    _meant_for(source)
    _dividing(source)
    bay = _IN_BAY.search(source.text)
    if bay is not None and not any(map(is_bay, parsed.stated_openings)):
        span = source.span(*bay.span("bay"))
        parsed.stated_openings.append(StatedOpening(part="window", features=("bay",), words=bay["bay"], span=span))
        parsed.openings["window"] = max(1, parsed.openings.get("window", 0))
    for part in ("breast", "niche"):
        if any(one.part == part for one in parsed.stated_openings):
            continue
        found = next((m for m in _named(part).finditer(source.text) if not _is_absent(source.text, m)), None)
        if found is None or (part == "niche" and parsed.wing is not None):
            continue
        text, noun = source.text, found["noun"]
        count = number_of(found["count"]) if found["count"] else 2 if noun in _SEVERAL else 1
        beside = part == "niche" and any(one.part == "breast" for one in parsed.stated_openings)
        sentence = text[text.rfind(".", 0, found.start()) + 1 : (text.find(".", found.end()) + 1) or len(text)]
        beside = beside and _beside().search(sentence) is not None
        span = source.span(found.start("noun"), found.end("noun"))
        features = ("beside",) if beside else ()
        parsed.stated_openings.append(
            StatedOpening(part=cast(Any, part), count=count, features=features, words=noun, span=span)
        )


def _meant_for(source: Source) -> None:
    """ "A niche for a scroll" has one: "for" is put as "with"."""
    for found in list(_for_something().finditer(source.text)):
        Edits(source).take(*found.span("for"), "w/")


def _dividing(source: Source) -> None:
    """ "A low wall divides the bed from the desk" is between them."""
    for found in list(_DIVIDES.finditer(source.text)):
        edits = Edits(source)
        edits.take(*found.span("verb"), "between")
        edits.take(*found.span("from"), "and")


def _not_built(source: Source, parsed: Parsed) -> None:
    edits = Edits(source)
    for part, row in words("built_parts")["not_built"].items():
        for found in list(_unbuilt(part).finditer(source.text)):
            if not edits.free(*found.span()) or _is_absent(source.text, found):
                continue
            placed = found["at"] not in (None, "of", "with", "has", "and")
            start = found.start("at") if placed or not found["at"] else found.end("at") + 1
            start = max(start, found.start())
            end = found.end()
            if part in ("slope", "sunk_floor"):
                end += len(_HEIGHT.match(source.text[end:])[0].rstrip())  # type: ignore[index]
            said = source.text[start:end].strip()
            many = re.search(rf"\b{NUMBER}(?= )", said)
            count = number_of(many[0]) if many is not None else 1
            span = edits.take(start, end)
            parsed.stated_openings.append(
                StatedOpening(part=cast(Any, part), count=count, features=(row["because"],), words=said, span=span)
            )


def _is_absent(text: str, found: re.Match[str]) -> bool:
    before = text[: found.start("noun")]
    return _absent().search(before) is not None


@cache
def _beside() -> re.Pattern[str]:
    return re.compile(rf"\b{one_of(words('built_parts')['beside'])}\b")


@cache
def _for_something() -> re.Pattern[str]:
    names = one_of([*words("built_parts")["niche"], *words("built_parts")["breast"]])
    return re.compile(rf"\b{names}\s(?P<for>for)\s(?!me\b|us\b)")


@cache
def _absent() -> re.Pattern[str]:
    return re.compile(rf"\b{one_of(words('built_parts')['absent'])}\s(?:[a-z]+\s)?$")


@cache
def _named(part: str) -> re.Pattern[str]:
    return re.compile(rf"\b{_COUNTED}(?P<noun>{one_of(words('built_parts')[part])})\b(?!\s(?:shelf|bath|tub))")


@cache
def _unbuilt(part: str) -> re.Pattern[str]:
    names = one_of(words("built_parts")["not_built"][part]["words"]).replace(r"\ ", r"[\s-]")
    return re.compile(rf"\b{_PLACED}{_COUNTED}(?P<noun>{names})\b")


__all__ = ["built_parts"]
