"""Numbers behind their nouns: "plants everywhere (min. 15)", "bottles and cups, at least 30 of them"."""

from __future__ import annotations

import re

from ..chunks import bounded
from ..parsed import Parsed
from ..source import Source
from .phrases import NUMBER, Edits, noun_before, number_of

_LEAST = r"(?P<least>min(?:imum)?(?: of)?\.?|at least|no fewer than|not less than)"
_MOST = r"(?P<most>max(?:imum)?(?: of)?\.?|at most|up to|no more than)"
_BOUND = re.compile(
    rf"(?:(?P<open>\() ?(?:{_LEAST}|{_MOST}|about|around|roughly) (?P<n>{NUMBER})"
    rf"(?! ?(?:m|cm|mm|ft|feet|foot|inch(?:es)?|met(?:er|re)s?)\b)(?P<close> ?\))?"
    rf"|,? (?:{_LEAST.replace('least>', 'low>')}|{_MOST.replace('most>', 'high>')}|about|around) "
    rf"(?P<m>{NUMBER}) of them\b"
    rf"|,? (?:i mean|say|like|ideally|preferably|maybe|that is|we need|i want|i need) "
    rf"(?:{_LEAST.replace('least>', 'lower>')}|{_MOST.replace('most>', 'upper>')}|about|around|roughly) (?P<k>{NUMBER})"
    rf"(?=\s*(?:[.,;)]|$)))"
)
_NO_MORE = re.compile(r"\b(?:and|but|or) no more than\b")
_AHEAD = re.compile(rf"\b(?P<word>min|max)(?:imum)?\.? (?={NUMBER} [a-z])")


def bounds(source: Source, parsed: Parsed) -> None:
    """Reads the least and most of what is named before or right behind them."""
    edits = Edits(source)
    source.blank(_NO_MORE, lambda m: "and at most")
    for m in _AHEAD.finditer(source.text):
        number = re.compile(NUMBER).match(source.text, m.end())
        assert number is not None
        noun = source.text[number.end() :].split(",")[0].split(".")[0]
        first = re.match(r"\s*((?:[a-z'-]+ ){0,2}?[a-z'-]+s)\b", noun)
        if first is not None:
            parsed.referred.append(edits.take(m.start(), m.end()))
            bound = "least" if m["word"] == "min" else "most"
            parsed.bounds.append(((first[1],), *_bounds(number_of(number[0]), bound)))
        elif m["word"] == "min":
            edits.take(m.start(), m.end(), "over" if len(m[0]) < 9 else "at least")
    for m in _BOUND.finditer(source.text):
        if not edits.free(m.start(), m.end()):
            continue
        value = number_of(m["n"] or m["m"] or m["k"])
        least, most = m["least"] or m["low"] or m["lower"], m["most"] or m["high"] or m["upper"]
        bound = "least" if least else "most" if most else None
        nouns = _nouns(source.text, m.start())
        if not nouns:
            continue
        low, high = _bounds(value, bound)
        parsed.bounds.append((nouns, low, high))
        edits.take(m.start(), m.end(), "(" if m["open"] and not m["close"] else "")


def _bounds(value: int, bound: str | None) -> tuple[int, int]:
    """Least and most of a number with a bound."""
    return bounded((value, value), bound)


def _nouns(text: str, at: int) -> tuple[str, ...]:
    """The nouns that a number behind them counts: all that "and" joins right before it."""
    clause = text[max(text.rfind(c, 0, at) for c in ".,(") + 1 : at]
    clause = re.sub(r"\b(?:absolutely|almost|simply|everywhere|all over(?: the place)?)\b", "", clause)
    parts = [part for part in re.split(r"\band\b", clause) if part.strip()]
    return tuple(noun for part in parts if (noun := noun_before(part, len(part))))


__all__ = ["bounds"]
