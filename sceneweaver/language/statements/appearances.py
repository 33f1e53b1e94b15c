"""Colours and materials of things that stand behind their nouns, of some of them, or of their parts.

"Three armchairs, one red and two blue", "a bed in emerald velvet and brass lamps", "a square table, oak", "with a black
marble top and brass legs": each is said of one thing, and none names another.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from sceneweaver.assets.materials import color_words, print_words
from sceneweaver.assets.roles import groups_above

from ..alternatives import first_words, names_begin
from ..model import Attribute, AttributeKind
from ..parsed import Parsed, Told
from ..source import Source
from ..things import match_of
from ..told_states import EACH_OF
from ..vocabulary import vocabulary, words
from .phrases import NUMBER, Edits, noun_before, number_of, one_of
from .resolve import is_thing, thing_before

_KINDS: tuple[AttributeKind, ...] = ("color", "material", "finish")
_LEAD = re.compile(r"(?:(?:,\s{0,3})?\b(?:with|has|have|having|and|its|the|an?|on|plus)\s{1,3}){1,3}$|,\s{0,3}$")
_ENDS = (
    r"(?=\s*(?:[,.;:)]|$|and\b|with\b|but\b|in\s(?:the|a|an|my|our)\b|around\b|at\b|by\b|on\b|near\b|under\b|beside\b))"
)


def read_appearances(source: Source, parsed: Parsed) -> None:
    """Adds what is said so of things, and takes its words out."""
    edits = Edits(source)
    for found in list(_varied().finditer(source.text)):
        _vary(source, parsed, edits, found)
    readers = [(_printed(), _print)]
    if names_begin(source.text, _first_words()):  # most requests name no look, and these patterns take long to compile
        shared, behind, trailing, part = _patterns()
        readers += [(shared, _shared), (part, _part), (behind, _whole), (trailing, _whole)]
    for pattern, read in readers:
        for found in list(pattern.finditer(source.text)):
            if edits.free(*found.span()):
                _add(source, parsed, edits, found, list(read(found)))


def _vary(source: Source, parsed: Parsed, edits: Edits, found: re.Match[str]) -> None:
    """Things that have several colours between them: those that are listed, or as many as there are."""
    noun = noun_before(source.text, found.start())
    noun = noun if is_thing(noun) else thing_before(source.text, found.start())
    if not is_thing(noun) or _goes_on(source.text, found.end()):
        return
    listed = re.findall(one_of(list(color_words())), found["list"] or "") or words("states")["rainbow"]
    said = " ".join(found[0].split()).strip(" ,:(")
    span = edits.take(*found.span())
    what = Attribute(kind="other", value=f"{EACH_OF} {', '.join(listed)}", words=said, span=span)
    parsed.appearances.append(Told(what, noun, after=False, named=True))


@cache
def _varied() -> re.Pattern[str]:
    """ "Each a different colour", "all in different colours", "in red, yellow, green and blue"."""
    color, hue = r"colou?rs?", rf"\b{one_of(list(color_words()))}\b"
    other = r"(?:a\s|an\s)?(?:different|another|other|separate|unique|own)(?:\sone)?"
    has, many = r"(?:(?:in|is|has|with|painted|of)\s)*(?:its\s)?", "different|various|mixed|assorted|many|several|all"
    each = rf"(?:each|every)(?:\sone)?(?:\sof\s(?:them|these))?\s{has}{other}\s{color}"
    mixed = rf"(?:(?:are|is|come|all)\s)*(?:in|of)\s(?:all\s)?(?:{many})\s{color}"
    bow = rf"(?:in\s)?(?:(?:the\s)?rainbow\s{color}|(?:all\s)?(?:the\s)?{color}\sof\sthe\srainbow)"
    some = rf"in\s(?P<list>{hue}(?:\s*,\s*{hue}){{1,6}}\s*,?\s+and\s+{hue})"
    sorted_ = (
        rf"(?:sorted|arranged|ordered|graded|grouped|organi[sz]ed|lined\sup|shelved)"
        rf"\s(?:by|according\sto|in\sorder\sof)\s(?:their\s)?{color}|(?:sorted\s|arranged\s|ordered\s)?(?:like|as|in)\sa\srainbow|in\srainbow\sorder|"
        rf"{color}\s(?:sorted|coded)"
    )
    ends = rf"(?:{_ENDS}|(?=\s(?:because|cause|so|as|for|to)\b))"
    return re.compile(
        rf"(?:,\s*)?\b(?:{each}|{mixed}|{bow}|{sorted_}|{some}(?:\s(?:mixed|jumbled|alternating))?)\b{ends}"
    )


@cache
def _printed() -> re.Pattern[str]:
    """ "With red stripes", "in a floral pattern"."""
    rows, colors = words("states"), one_of(list(color_words()))
    known, nouns, kinds = one_of(rows["prints"]), one_of(rows["printed"]), one_of(print_words())
    big = r"(?:(?:big|large|small|little|tiny|bold|wide|broad|narrow|thin|all\sover)\s)?"
    return re.compile(
        rf"(?:,\s*)?\b(?:with|in|has|have|having)\s(?:an?\s|the\s)?{big}(?:(?P<look>{colors})\s)?"
        rf"(?:(?P<print>{known})|(?P<kind>{kinds})\s{nouns})\b(?:\son\s(?:it|them))?{_ENDS}"
    )


def _print(found: re.Match[str]) -> Iterator[dict[str, Any]]:
    if found["look"]:
        yield {"kind": "color", "value": found["look"], "words": found["look"]}
    said = found["print"] or found["kind"]
    yield {"kind": "material", "value": words("states")["prints"].get(said, said), "words": said}


def _add(source: Source, parsed: Parsed, edits: Edits, found: re.Match[str], said: list[dict[str, Any]]) -> None:
    text, start = source.text, found.start()
    if "of_part" in found.re.groupindex and (lead := _LEAD.search(text[:start])) is not None:
        start = lead.start()
    noun = noun_before(text, start)
    noun = noun if is_thing(noun) else thing_before(text, start)
    if not said or not is_thing(noun) or _goes_on(text, found.end()):
        return
    if any(one["value"].endswith(" fronts") for one in said) and not _has_fronts(noun):
        return  # "cushions and green doors"
    span = edits.take(start, found.end())
    for one in said:
        attribute = Attribute(span=span, **one)
        parsed.appearances.append(Told(attribute, noun, after=False, named=True))


def _has_fronts(noun: str) -> bool:
    """Whether a thing has doors or drawers."""
    return bool(groups_above(match_of(noun).category) & {"storage", "appliance", "table_group", "bed_group"})


def _goes_on(text: str, end: int) -> bool:
    """Whether a noun follows at once, of which the words would be said, or goes on: a red stand mixer has no stand."""
    follows = re.match(r"\s+([a-z]+)", text[end:])
    last = re.search(r"[a-z]+$", text[:end])
    if follows is not None and last is not None and "noun" in vocabulary().get(f"{last[0]} {follows[1]}", {}):
        return True
    kinds = vocabulary().get(follows[1], {}).keys() if follows is not None else set[str]()
    return bool(kinds & {"noun", "plural"}) and not kinds & {"preposition", "verb"}


def _shared(found: re.Match[str]) -> Iterator[dict[str, Any]]:
    """So many of them in one look, and so many in another."""
    for one in re.finditer(rf"(?P<many>{NUMBER}|a)\s(?:of\sthem\s|is\s|are\s|in\s)*(?P<look>{_look()})", found[0]):
        many = 1 if one["many"] == "a" else number_of(one["many"])
        for row in _words_of(one["look"]):
            yield {**row, "count": (many, many)}


def _whole(found: re.Match[str]) -> Iterator[dict[str, Any]]:
    yield from _words_of(found["look"])


def _part(found: re.Match[str]) -> Iterator[dict[str, Any]]:
    name = next(name for name, nouns in words("states")["part_nouns"].items() if found["of_part"] in nouns)
    yield {"kind": "part", "value": f"{found['look']} {name}", "words": found[0]}


def _words_of(look: str) -> Iterator[dict[str, Any]]:
    """The words of a look, each known phrase with its kind."""
    table, spoken, at = vocabulary(), look.split(), 0
    while at < len(spoken):
        for length in range(min(3, len(spoken) - at), 0, -1):
            phrase = " ".join(spoken[at : at + length])
            kind = next((kind for kind in _KINDS if kind in table.get(phrase, {})), None)
            if kind is not None:
                value = words("nouns")["made_of"].get(phrase, str(table[phrase][kind]))
                yield {"kind": kind, "value": value, "words": phrase}
                at += length - 1
                break
        at += 1


@cache
def _known() -> tuple[str, ...]:
    """Words for colours and materials."""
    kinds = set(_KINDS)
    return tuple(phrase for phrase, known in vocabulary().items() if known.keys() & kinds and phrase[0].isalpha())


@cache
def _first_words() -> frozenset[str]:
    return first_words(_known())


@cache
def _look() -> str:
    """A pattern of colours and materials one after the other."""
    shades = r"(?:(?:dark|light|pale|deep|bright|matte|polished|brushed|bare|natural|solid|raw|untreated)\s)?"
    one = rf"{shades}{one_of(_known())}(?![\w-])"
    return rf"{one}(?:\s{one}){{0,2}}"


@cache
def _patterns() -> tuple[re.Pattern[str], ...]:
    look = _look()
    item = rf"(?:{NUMBER}|a)\s(?:of\sthem\s)?(?:(?:is|are|in)\s)?{look}(?:\sone)?"
    parts = one_of([noun for nouns in words("states")["part_nouns"].values() for noun in nouns])
    return (
        re.compile(rf"[,:(]?\s{{0,3}}\b{item}(?:\s*(?:,\s*and|,|and)\s+{item}){{1,5}}{_ENDS}"),
        re.compile(rf"\bin\s(?P<look>{look}){_ENDS}"),
        re.compile(rf",\s(?:all\s)?(?:in\s|of\s)?(?P<look>{look})(?=\s*(?:[,.;)]|$))"),
        re.compile(rf"\b(?P<look>{look})\s(?P<of_part>{parts})\b"),
    )


__all__ = ["read_appearances"]
