"""What is wanted beside what is not: "no desk, just a bench", "no lamps except three on the shelf".

A word that turns from what is not wanted to what is ends the exclusion, and what is left of an excluded kind is that
many of it and no more. The words stay where they stand for the readers after this one.
"""

from __future__ import annotations

import re
from functools import cache

from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import vocabulary, words
from .phrases import NUMBER, Edits, number_of, one_of

_WORD = r"[a-z][a-z'-]*"
_PLACE = r"(?: (?:on|in|at|by|along|from) (?:the |any |our )?[a-z]+)?"
_QUALITIES = rf"(?:{_WORD} ){{0,2}}?"


def contrasts(source: Source, parsed: Parsed) -> None:
    """Read what is left of an excluded kind, and where an exclusion ends with what is there in its place."""
    for m in reversed([*_all_but().finditer(source.text)]):
        _leaves(m, source, parsed)
    edits = Edits(source)
    for m in _turning().finditer(source.text):
        _turns(m, edits)


@cache
def _all_but() -> re.Pattern[str]:
    data = words("unwanted")
    negation, but = one_of(data["before_kind"]), one_of([*data["except"], *data["all_but"]])
    return re.compile(
        rf"\b(?P<no>{negation} (?:any |other |more )?(?P<noun>(?:{_WORD} )?{_WORD}){_PLACE},? {but}(?: for)?)\s+"
        rf"(?:(?:just|only|exactly) )?(?P<n>{NUMBER})(?=\s+(?P<next>{_WORD})|\s*(?:[,.)]|$))"
    )


@cache
def _turning() -> re.Pattern[str]:
    data = words("unwanted")
    return re.compile(
        rf"\b{one_of(data['before_kind'])} (?P<noun>{_QUALITIES}{_WORD}){_PLACE}"
        rf"(?P<turn>(?:,? ?(?:but )?){one_of(data['instead'])}) (?={_WORD})"
    )


def _is_noun(word: str) -> bool:
    kinds = vocabulary().get(word, {}).keys() | vocabulary().get(singular(word), {}).keys()
    return "noun" in kinds and match_of(singular(word)).how != "generic"


def _leaves(m: re.Match[str], source: Source, parsed: Parsed) -> None:
    """ "No chairs except two by the door" are two chairs by the door, and no more; "no chairs but one stool" is read as
    an exclusion."""
    noun, count = m["noun"], number_of(m["n"])
    if not _is_noun(noun.split()[-1]) or (m["next"] and _names(m["next"])) or not count:
        return
    start, end = m.start("no"), m.end("n")
    parsed.referred.append(source.span(start, m.start("n")))
    parsed.bounds.append(((noun,), count, count))
    if m["next"] == "of":  # "except two of them"
        return
    left = f", {m['n']} {noun if count > 1 else singular(noun)}"
    source.text = source.text[:start] + left.rjust(end - start) + source.text[end:]


def _names(word: str) -> bool:
    """Whether a word after a number is what it counts, or tells what that is like."""
    kinds = vocabulary().get(word, {}).keys() | vocabulary().get(singular(word), {}).keys()
    return bool(kinds & {"noun", "color", "material", "scale", "adjective"}) and not kinds & {"preposition", "stop"}


def _turns(m: re.Match[str], edits: Edits) -> None:
    """ "No chairs just stools": what comes after is there, be it one kind or several."""
    if edits.free(*m.span("turn")):
        edits.take(*m.span("turn"), " but")


__all__ = ["contrasts"]
