"""Numbers that are names: "gate 14", "table 5", "counter no. 3", "room 2".

A number behind a singular noun counts nothing. It names one thing, and the same number again names the same thing.
"""

from __future__ import annotations

import re
from functools import cache

from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import vocabulary, words
from .phrases import one_of

_LABEL = re.compile(
    r"(?<![\w'-])(?P<noun>[a-z]{3,})(?P<mark> (?:no\.?|nr\.?|number|#) ?| #| )(?P<n>\d{1,3}(?![\d.,]\d))"
    r"(?P<after>[a-d](?!\w))?(?=\s*(?P<next>(?:by \d|[a-z§%\"'×]*)))"
)
_COUNTED = re.compile(
    r"(?:^|[,.] ?|\band )(?P<noun>[a-z]+(?: [a-z]+)?)[:.]? (?:[x×] ?)?(?P<n>\d{1,3})\s*(?=[,.]|and\b|$)"
)


def labels(source: Source, parsed: Parsed) -> None:
    """Take numbers that name a thing or a room out of the source; what they name is one."""
    named: set[tuple[str, str]] = set()
    counts = _counts(source.text)
    at = 0
    while (m := _LABEL.search(source.text, at)) is not None:
        at = m.end("noun")
        noun, number = m["noun"], f"{m['n']}{m['after'] or ''}"
        if not _may_be_named(noun) or _is_measure(m["next"]) or (m["mark"] == " " and m.start() in counts):
            continue
        parsed.referred.append(source.span(m.end("noun"), m.end()))
        source.replace(m.end("noun"), m.end())
        if _is_room(noun) or _has_article(source.text, m.start()):
            continue
        article = "the " if (noun, number) in named else "a "
        named.add((noun, number))
        source.insert(m.start(), article, m.start())
        at += len(article)
        counts = {k + len(article) * (k >= m.start()) for k in counts}


def _counts(text: str) -> set[int]:
    """Where nouns stand with their counts behind them: items of a list in which another noun has one as well."""
    found = [*_COUNTED.finditer(text)]
    nouns = {m["noun"] for m in found}
    return {m.end("noun") - len(m["noun"].split()[-1]) for m in found} if len(nouns) > 1 else set()


def _may_be_named(noun: str) -> bool:
    """Whether a noun is one thing or room that may bear a number."""
    if singular(noun) != noun or noun in words("labels")["never"]:
        return False
    kinds = vocabulary().get(noun, {}).keys()
    if _is_room(noun):
        return True
    return "noun" in kinds and not kinds & {"preposition", "number", "unit"} and match_of(noun).how != "generic"


def _is_room(noun: str) -> bool:
    return noun in words("labels")["places"] or "room" in vocabulary().get(noun, {})


def _has_article(text: str, at: int) -> bool:
    before = re.search(r"([a-z']+)\s+$", text[max(0, at - 20) : at])
    return before is not None and before[1] not in words("labels")["before"]


@cache
def _units() -> re.Pattern[str]:
    return re.compile(rf"(?:{one_of(words('labels')['units'])}\b|by \d|[§%\"'×])")


def _is_measure(after: str) -> bool:
    """Whether a number goes on with a unit, or counts what comes after it."""
    return bool(after) and (_units().match(after) is not None or _counts_next(after))


def _counts_next(word: str) -> bool:
    """ "With the table 4 chairs": a plural after a number is what it counts."""
    kinds = vocabulary().get(word, {}).keys() | vocabulary().get(singular(word), {}).keys()
    verb = "verb" in vocabulary().get(word, {}) and word not in words("labels")["nouns"]
    return word not in ("is", "has") and "noun" in kinds and singular(word) != word and not verb


__all__ = ["labels"]
