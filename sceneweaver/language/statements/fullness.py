"""How much is in a room beside what a request names: nothing else, little else, or things that lie all over it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache

from ..model import Amount
from ..parsed import Parsed
from ..source import Source
from ..vocabulary import words
from .phrases import REACH, Edits, listed, noun_before
from .resolve import is_thing

_CLAUSE = re.compile(r"[.;:!?\n(]|,\s*(?=\w+\s+\w+\s+(?:is|are)\b)")
_AND = re.compile(r"\s*(?:,|/|&|\band\b|\bor\b|\bplus\b)\s*")
_WORD = re.compile(r"[a-z][a-z'-]*")

_BEHIND = re.compile(r" (?:and|or|with|on|in|at|by|under|over|above|beside|near|from|for|to|that|which|the|is|are)$")
"""A word behind a noun that is no part of its name."""

_SAID_OF_THING = re.compile(r"\b(?:hold(?:s|ing)?|carr(?:y|ies|ying)|with|bear(?:s|ing)?|display(?:s|ing)?|has)\s+$")
_THERE = re.compile(
    r"\s+(?:on|in|under|underneath|beneath|inside|near|by|beside|behind|above|over|around)\s+"
    r"(?:it|them|its|the|this|that|my|our|his|her|their|each|any)\b(?!\s(?:room|space|place|floor)\b)"
)
"""Where nothing else is, and what that is of."""

_EMPTY_BUT = re.compile(
    r"\b(?:(?:is|are|be|stays?|remains?|left|kept|otherwise|quite|all|completely|entirely|still) ){0,3}"
    r"(?:empty|bare|clear),? (?:but for|except for|except|apart from|save for|save|other than)(?= )"
)

LONGEST = 3
"""Words of a noun before its spread that are looked at."""


_DEFINITE = ("the", "its", "her", "his", "my", "our", "their")


def fullness(source: Source, parsed: Parsed) -> None:
    """Read what a request says of how full its room is; what is understood goes out of the source."""

    def nothing(match: re.Match[str]) -> str | None:
        of_things = match[0].startswith("nothing but") and (
            _SAID_OF_THING.search(source.text[: match.start()]) or source.spoken[slice(*match.span())] != match[0]
        )
        if of_things or _THERE.match(source.text, match.end()):
            return None  # "a shelf that holds nothing but books", "nothing else on it": of a thing, not of the room
        parsed.only = True
        return ""

    def little(_: re.Match[str]) -> str:
        parsed.density = "sparse"
        return ""

    source.blank(_any_of("nothing"), nothing)
    source.blank(_any_of("little"), little)
    for pattern, least in _many():
        for match in pattern.finditer(source.text):
            parsed.amounts += _amounts(
                [_BEHIND.sub("", match["noun"])], "many", least, match[0], source.span(*match.span())
            )
    for spread, pattern in _spread():

        def spread_out(match: re.Match[str], spread: str = spread) -> str | None:
            found = list(_before(source.text[: match.start()]))
            if not found:
                return None
            parsed.amounts += _amounts(found, spread, None, match[0], source.span(*match.span()))
            return ""

        source.blank(pattern, spread_out)


def emptied(source: Source, parsed: Parsed) -> None:
    """ "The bench is bare but for a lamp": nothing but that is on the bench. Of a room it is read by `fullness`."""
    edits = Edits(source)
    for match in list(_EMPTY_BUT.finditer(source.text)):
        noun = noun_before(source.text, match.start())
        if noun and is_thing(noun):
            edits.take(*match.span(), "nothing but")


def _before(text: str) -> Iterator[str]:
    """The nouns at the end of a text: of its last clause, as far as they are listed."""
    no_noun = words("fullness")["no_noun"]
    clause = _CLAUSE.split(text[-REACH:])[-1]
    clause = re.split(r"(?<!\s)\s{2,},", clause)[-1]  # what was said of a thing before has been read: it is no list
    for k, part in enumerate(reversed(_AND.split(clause.rstrip(" ,")))):
        spoken = _WORD.findall(part)
        noun: list[str] = []
        for word in reversed(spoken):
            if word in no_noun and noun:
                break
            if word not in no_noun:
                noun.insert(0, word)
        before = spoken[-len(noun) - 1 : len(spoken) - len(noun)]
        if not noun or (k and before and before[0] in (*_DEFINITE, *listed("prepositions"))):
            return  # "paper around the bin, cups everywhere": no list
        yield " ".join(noun[-LONGEST:])
        if len(noun) < len(spoken):  # what comes before is no list any more
            return


def _amounts(nouns: Sequence[str], spread: str, least: int | None, said: str, span) -> list[Amount]:
    return [Amount(entity=noun, spread=spread, least=least, words=said, span=span) for noun in nouns]  # type: ignore[arg-type]


@cache
def _any_of(kind: str) -> re.Pattern[str]:
    return _pattern(words("fullness")[kind])


@cache
def _spread() -> tuple[tuple[str, re.Pattern[str]], ...]:
    return tuple((name, _pattern(phrases)) for name, phrases in words("fullness")["spread"].items())


@cache
def _many() -> tuple[tuple[re.Pattern[str], int], ...]:
    found = []
    for least, phrases in words("fullness")["before"].items():
        either = "|".join(map(re.escape, sorted(phrases, key=len, reverse=True)))
        found.append((re.compile(rf"\b(?:{either})\s+(?P<noun>[a-z'-]+(?: [a-z'-]+)?)"), int(least)))
    return tuple(found)


def _pattern(phrases: Sequence[str]) -> re.Pattern[str]:
    either = "|".join(map(re.escape, sorted(phrases, key=len, reverse=True)))
    return re.compile(rf"\b(?:{either})\b")
