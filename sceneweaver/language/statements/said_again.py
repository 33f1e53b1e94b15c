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

_OF_WHOM = re.compile(
    r"\b(?P<det>the|each|every|this|that) (?P<noun>[a-z]+(?: [a-z]+)?)'s (?P<part>(?:[a-z]+ )?[a-z]+)\b"
)

_ONE_A = re.compile(r"(?:^|[,.(]|\band\b) ?one of (?:them|these|those|which) (?=an? [a-z])")


def said_again(source: Source, parsed: Parsed) -> None:
    """Put pointing words into plain ones."""
    for m in reversed([*_ONE_A.finditer(source.text)]):
        source.insert(m.end(), "is ", m.end())  # "six chairs, one of them a high chair"
    source.blank(_pointing(), lambda m: _plain(m, source.text))
    for m in reversed([*_OF_WHOM.finditer(source.text)]):
        _of_whom(m, source)


@cache
def _pointing() -> re.Pattern[str]:
    data = words("said_again")
    return re.compile(
        rf"\b{one_of(data['places'])} (?P<that>that|this|those|these)(?= (?P<next>[a-z']+)|\s*(?:[,.)]|$))"
    )


def _plain(m: re.Match[str], text: str) -> str | None:
    """ "On that shelf" is on the shelf; "beside that a bin" is beside it a bin."""
    ahead, word = m[0][: -len(m["that"])], m["next"] or ""
    kinds = vocabulary().get(word, {}).keys() | vocabulary().get(singular(word), {}).keys()
    if word in ("one", "ones", "time", "way") or word in words("said_again")["no_noun"]:
        return None
    closed = not word or kinds & {"det", "number", "preposition", "and", "with", "while", "verb", "amount", "stop"}
    if closed and "noun" not in kinds:
        return f"{ahead}{'it' if m['that'] in ('that', 'this') else 'them'}"
    if m["that"] == "that" and "noun" in kinds and re.match(rf"{word}s? (?:is|are|of)\b", text[m.end() + 1 :]):
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
        source.text = source.text[:at] + "  " + source.text[at + 2 :]
        source.insert(at, " with its", at)
        return
    end = m.end("noun") + len("'s ") + len(spoken)
    source.text = source.text[: m.end("noun")] + " " * (end - m.end("noun")) + source.text[end:]
    source.insert(m.start(), f"the {spoken} of ", m.start())


__all__ = ["said_again"]
