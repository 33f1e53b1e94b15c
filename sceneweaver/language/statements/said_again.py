"""Words that point back: "on that shelf", "next to that", "the chair's left side", "the sofa's back".

They are put into the words that the reader of clauses follows: "the shelf", "it", "the left side of the chair". Nothing
new is named by them.
"""

from __future__ import annotations

import re
from functools import cache

from ..parsed import Parsed
from ..source import Source
from ..things import singular
from ..vocabulary import vocabulary, words
from .phrases import one_of

_OF_WHOM = re.compile(r"\b(?:the|each|every|this|that) (?P<noun>[a-z]+(?: [a-z]+)?)'s (?P<part>(?:[a-z]+ )?[a-z]+)\b")

_BARE_LENGTH = re.compile(
    r"(?<=[a-z]) ?\((?:[a-z -]+, ?)?(?:about |around |approx |ca )?\d+(?:\.\d+)? ?"
    r"(?:m|cm|ft|feet|inch(?:es)?|met(?:er|re)s)(?=[,)])"
)
_DOWN = re.compile(
    r"\bdown (?=(?:the|one|each|both|its|that) (?:(?:left|right|long|short|far|whole) )?(?:side|wall|length)s?\b)"
)

_FIRST = re.compile(
    r"\b(?:the first(?: one)?|one(?: of them)?) "
    r"(?P<verb>holds|has|carries|contains|gets|shows|displays|with) (?P<rest>[^.]+)"
)
_THEN = re.compile(
    r"(?<=next to )[^.]{2,60}?, ?(?:and )?(?P<then>then)(?= (?:an? |the )[a-z]+(?: [a-z]+)?\s*(?:[,.]|and\b|$))"
)
_NEXT = re.compile(r"\bthe (?:second|third|fourth|other|last)(?: one)? (?=(?P<word>[a-z]+))")

_EACH_A = re.compile(r"(?:^|[,.] ?|\band )each (?P<noun>[a-z]+) (?=(?:an?|two|three|four) [a-z])")
_HEADING = re.compile(r"(?:^|[.,]\s*)(?P<place>[a-z][a-z' -]{3,60})$")

_ONE_A = re.compile(r"(?:^|[,.(]|\band\b) ?one of (?:them|these|those|which) (?=an? [a-z])")


def said_again(source: Source, parsed: Parsed) -> None:
    """Put pointing words into plain ones."""
    for m in reversed([*_ONE_A.finditer(source.text)]):
        source.insert(m.end(), "is ", m.end())  # "six chairs, one of them a high chair"
    for m in reversed([*_BARE_LENGTH.finditer(source.text)]):
        source.insert(m.end(), " wide", m.end() - 1)  # "a sofa (about 2 m, grey)"
    for m in reversed([*_DOWN.finditer(source.text)]):
        source.replace(*m.span(), "along ")  # "lockers down the left side"
    for m in reversed([*_THEN.finditer(source.text)]):
        source.replace(*m.span("then"), " next to that")  # "a fridge, next to it a sink, then a stove"
    for m in reversed([*_FIRST.finditer(source.text)]):
        _gapped(m, source)
    for k in sorted(source.colons, reverse=True):
        _heads_list(k, source)
    for m in reversed([*_EACH_A.finditer(source.text)]):
        kinds = vocabulary().get(m["noun"], {}).keys()
        if "noun" in kinds and not kinds & {"with", "preposition", "verb"}:
            source.insert(m.end(), "has ", m.end())  # "each desk a lamp"
    source.blank(_pointing(), lambda m: _plain(m, source.text))
    for m in reversed([*_OF_WHOM.finditer(source.text)]):
        _of_whom(m, source)


@cache
def _pointing() -> re.Pattern[str]:
    data = words("said_again")
    ahead = one_of(data["places"])
    named = r"(?= (?:an?|one|two|three|four|some|another|the) )"
    that = (
        rf"(?P<that>(?:that|this|those|these|which|it|them)(?: there)? (?:is|are){named}|that|this|those|these|which)"
    )
    return re.compile(rf"(?P<gap>^|(?<!,) |\b){ahead} {that}(?= (?P<next>[a-z']+)|\s*(?:[,.)]|$))")


def _gapped(m: re.Match[str], source: Source) -> None:
    """ "The first holds books, the second plants": the verb is said once for all."""
    for one in reversed([*_NEXT.finditer(source.text, m.start("rest"), m.end())]):
        kinds = vocabulary().get(one["word"], {}).keys()
        named = kinds | vocabulary().get(singular(one["word"]), {}).keys()
        if not kinds & {"verb", "preposition", "with"} and named & {"noun", "det", "number", "matter"}:
            source.insert(one.end(), f"{m['verb']} ", one.start())


def _heads_list(at: int, source: Source) -> None:
    """ "On the desk: a lamp and a cup": what stands before a colon says where all of the list is."""
    if source.text[at : at + 1] != ".":
        return
    m = _HEADING.search(source.text[max(0, at - 80) : at])
    if m is None or not _of_place().match(m["place"]):
        return
    spoken = m["place"].split()
    if any({"verb", "and", "with"} & vocabulary().get(word, {}).keys() - {"noun"} for word in spoken[1:]):
        return
    source.text = source.text[:at] + " " + source.text[at + 1 :]
    if spoken[-1] in ("left", "right") and len(spoken) == 3:
        source.insert(at, " wall", at)  # "on the left: three beds" is of the room


@cache
def _of_place() -> re.Pattern[str]:
    return re.compile(rf"{one_of(words('said_again')['places'])} (?:the|my|our|her|his|one|each|every|both) ")


def _plain(m: re.Match[str], text: str) -> str | None:
    """ "On that shelf" is on the shelf; "beside that a bin" is beside it a bin."""
    ahead, word, that = m[0][: -len(m["that"])], m["next"] or "", m["that"].split()[0]
    kinds = vocabulary().get(word, {}).keys() | vocabulary().get(singular(word), {}).keys()
    if word in ("one", "ones", "time", "way") or word in words("said_again")["no_noun"]:
        return None
    closed = not word or kinds & {"det", "number", "preposition", "and", "with", "while", "verb", "amount", "stop"}
    if closed and ("noun" not in kinds or that == "which"):
        ahead = f",{ahead.strip()} " if that == "which" and m["gap"] == " " else ahead
        return f"{ahead}{'them' if m['that'] in ('those', 'these') else 'it'}"
    if that == "that" and "noun" in kinds and re.match(rf"{word}s? (?:is|are|of)\b", text[m.end() + 1 :]):
        return None
    if that == "which":
        return None
    return f"{ahead}the" if kinds & {"noun", "color", "scale", "material", "adjective", "room", "place"} else None


def _of_whom(m: re.Match[str], source: Source) -> None:
    """ "The chair's left side" is the left side of the chair, where the chair was named and has such a side."""
    part = m["part"].split()
    if part[-1] not in words("said_again")["sides"]:
        part = part[:1]
    if part[-1] not in words("said_again")["sides"] or (len(part) > 1 and part[0] not in words("said_again")["which"]):
        return
    if re.search(rf"\b{re.escape(singular(m['noun'].split()[-1]))}(?:s|es)?\b", source.text[: m.start()]) is None:
        return
    spoken = " ".join(part)
    if re.match(r" (?:to|against|turned|facing|is)\b", source.text[m.end("noun") + 3 + len(spoken) :]):
        at = m.end("noun")  # "the sofa's back to the door"
        source.replace(at, at + len("'s"), " with its")
        return
    end = m.end("noun") + len("'s ") + len(spoken)
    source.replace(m.end("noun"), end)
    source.insert(m.start(), f"the {spoken} of ", m.start())


__all__ = ["said_again"]
