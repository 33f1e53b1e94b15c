"""Whose two sides are: of every "a x b" in a request, which one is the room's.

Each pair of sides may be the room's, of floor to keep free, of a thing that is named beside it, or of nothing that is
known. The nearest noun of the same phrase decides; sides that stand alone are the room's where they may be, by where
they stand and by how large rooms of the kind are. What is no one's is told, never taken for a room.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Literal

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge.load import room_types, room_words

from ..nothings import is_word
from ..parsed import Parsed
from ..source import FOOT, Source, metres
from ..vocabulary import category_of, vocabulary, words

Owner = Literal["room", "other room", "floor", "thing", "unknown", "alone"]

TIGHT = 0.4
"""Share of the least floor that rooms of a kind have, below which sides that stand alone are not the room's."""

WIDE = 3.0
"""Multiple of the largest floor of a kind, beyond which they are not either."""

LEAST = 1.0
"""Side [m] that a room has at least where its sides are told one by one."""

LONGEST = 12.0
"""Side [m] of a thing up to which a number without a unit may be metres."""

MOST_STEPS = 6
"""Words between sides and the noun that they are of."""

_NUMBER = r"\d{1,4}(?:[.,]\d{1,3})?"
_PAIR = re.compile(
    rf"§|(?<![\w.,])(?<!grid of )(?<!array of )(?P<a>{_NUMBER})\s?(?:x|×|by|\*)\s?(?P<b>{_NUMBER})"
    rf"(?:\s?(?:x|×|by|\*)\s?(?P<c>{_NUMBER}))?"
    r"(?![\w.]\w|\w|\s?(?:mm|in(?!\s(?:front|the|a|each|every|between|all|my|our)\b)|grid|array|matrix|pattern|formation|raster|rows?|block|layout)\b)"
)
_WORD = re.compile(r"[a-z][a-z'/-]*")
_NEXT = re.compile(r"[ -]{1,40}([a-z][a-z'-]*)")
"""The next word of a clause; what was blanked out before it are spaces."""

_CLAUSE = re.compile(r"[.,()§]")
_GOES_ON = re.compile(r"\s*(?:is|are|be|stays?|remains?|must|should|has|have|needs?|to|kept|left|all|completely)\b")
"""Where a clause goes on behind what was put between commas."""

_FEET = re.compile(r"\d\s?(?:ft|feet|foot|')(?![a-z])")
_METRES = re.compile(r"\d\s?(?:m|cm|meters?|metres?)(?![a-z])")


@dataclass(frozen=True)
class _Sides:
    """Two or three sides [m], where they stand, whose they seem to be and how likely they are the room's."""

    start: int
    end: int
    values: tuple[float, ...]
    bare: bool
    owner: Owner
    noun: str
    first: bool
    free: bool


def room_sides(source: Source, parsed: Parsed) -> None:
    """Gives the room its sides; those of floor to keep free are marked, those of things stay for the clauses."""
    name = _own_name(source.spoken)
    kind = room_words()[name] if name else ""
    if source.size is None and not parsed.sides:
        _one_by_one(source, name)
    found = list(_found(source, name, kind))
    if not parsed.sides and source.size is None:
        likely = [(score, -sides.start, sides) for sides in found if (score := _score(sides, kind)) > 0]
        if likely:
            room = max(likely)[2]
            _give(room, source)
            for _, _, sides in likely:
                found.remove(sides)
                if set(sides.values[:2]) != set(room.values[:2]):
                    said = f"{sides.values[0]:g} x {sides.values[1]:g} m"
                    source.notes.append(f"{said}: the room has other sides already; it was left out")
                if sides is not room:
                    _put(source, sides, " ")
    for sides in found:
        if sides.free and sides.owner != "thing":
            source.sides[sides.start] = sides.values
            source.free.add(sides.start)
        if sides.bare and (sides.free or sides.owner == "thing"):
            source.sides[sides.start] = sides.values
            _put(source, sides, "§")


_LENGTH = rf"({_NUMBER})\s{{0,2}}(m|cm|mm|meters?|metres?|ft|feet|foot|')(?![a-z])"
_ABOUT = r"(?:(?:of|is|about|around|roughly|only|just|:|=|at least|at most)\s{0,2}){0,3}"
_EXTENT = re.compile(
    rf"\b(?P<name>width|length|breadth|depth)\s{{0,2}}{_ABOUT}{_LENGTH}(?:\s(?:inside|overall|in all))?"
    rf"|{_LENGTH}\s{{0,2}}-?(?P<axis>long|wide|deep|broad|in length|in width|front to back|side to side|across)\b"
)
_LONG = ("length", "depth", "long", "deep", "in length", "front to back")


def _one_by_one(source: Source, own: str) -> None:
    """Sides that are told apart from each other: "inside width 1.85 m, 3.2 m long"; one alone is not enough."""
    text = source.text
    found: dict[bool, tuple[float, re.Match[str]]] = {}
    for m in _EXTENT.finditer(text):
        owner, _ = _owner(text, m.start(), m.end(), own)
        first = text.count(". ", 0, m.start()) <= 1
        if owner == "room" or (owner in ("alone", "floor") and first and not _is_free(text, m.start())):
            number, unit = (m[2], m[3]) if m["name"] else (m[4], m[5])
            found.setdefault((m["name"] or m["axis"]) in _LONG, (metres(number, unit), m))
    if len(found) < 2 or min(length for length, _ in found.values()) < LEAST:
        return
    source.size = (max(length for length, _ in found.values()), min(length for length, _ in found.values()))
    for _, m in found.values():
        source.text = source.text[: m.start()] + " " * len(m[0]) + source.text[m.end() :]


def _give(room: _Sides, source: Source) -> None:
    source.size = (max(room.values[:2]), min(room.values[:2]))
    if len(room.values) > 2 and source.height is None:
        source.height = room.values[2]
    if room.bare:
        said = " ".join(source.text[room.start : room.end].split())
        feet = source.size[0] not in (float(n.replace(",", ".")) for n in re.findall(_NUMBER, said))
        source.notes.append(f"'{said}' was read as {'feet' if feet else 'metres'}")
    _put(source, room, " ")


def _put(source: Source, sides: _Sides, filler: str) -> None:
    source.text = source.text[: sides.start] + filler.ljust(sides.end - sides.start) + source.text[sides.end :]


def _found(source: Source, own: str, kind: str) -> Iterator[_Sides]:
    """All pairs of sides of a text about a room of a name and a kind ("" where none is named)."""
    text = source.text
    feet = _FEET.search(source.spoken) is not None and _METRES.search(source.spoken) is None
    for m in _PAIR.finditer(text):
        owner, noun = _owner(text, m.start(), m.end(), own)
        if m["a"] is None:
            values = source.sides.get(m.start())
        else:
            spoken = [float(number.replace(",", ".")) for number in m.group("a", "b", "c") if number]
            values = _scaled(spoken, owner, noun, feet, kind)
        if values is None or len(values) < 2:
            continue
        first = ". " not in text[: m.start()].strip() or not text[: m.start()].strip(" .")
        yield _Sides(m.start(), m.end(), values, m["a"] is not None, owner, noun, first, _is_free(text, m.start()))


def _score(sides: _Sides, kind: str) -> int:
    """How likely sides are the room's; nothing where they cannot be."""
    low, high = min(sides.values[:2]), max(sides.values[:2])
    if low < 0.8 or high > 100 or (sides.bare and (low < 1.2 or high > 60)):
        return 0
    if sides.owner == "room":
        return 4
    if sides.owner in ("thing", "unknown", "other room") or sides.free:
        return 0
    known = room_types().get(kind)
    if known is not None and not TIGHT * known.area[0] <= low * high <= WIDE * known.area[2]:
        return 1 if sides.first and sides.owner == "alone" else 0
    if sides.owner == "floor":
        return 2 if sides.first else 0
    return 3 if sides.first else 2


@cache
def _names() -> dict[str, list[str]]:
    """The names of kinds of rooms by their first words, the longest first."""
    found: dict[str, list[str]] = {}
    for name in sorted(room_words(), key=lambda name: -len(name)):
        found.setdefault(name.split()[0], []).append(name)
    return found


def _own_name(text: str) -> str:
    """The first name of a kind of room in a text; "" where there is none."""
    for m in _WORD.finditer(text):
        for name in _names().get(m[0], ()):
            if text.startswith(name, m.start()) and not text[m.start() + len(name) :][:1].isalpha():
                return name
    return ""


def _owner(text: str, start: int, end: int, own: str) -> tuple[Owner, str]:
    """What the noun beside two sides names, the one behind them first: "a 2 x 3 m rug", "a rug of 2 x 3 m"."""
    behind = _noun_behind(text, end)
    if behind:
        return _class(behind, own, last=behind.split()[-1]), behind
    before = _noun_before(text, start)
    if before == "":
        return "alone", ""
    return _class(before, own, last=before.split()[-1]), before


def _noun_behind(text: str, end: int) -> str:
    """The words of a noun that follow at once, "" where a clause ends or goes on with another word."""
    found: list[str] = []
    at = end
    while len(found) < MOST_STEPS:
        m = _NEXT.match(text, at)
        if m is None or _is_closed(m[1]):
            break
        if m[1] not in _set("between"):
            found.append(m[1])
        at = m.end()
    return " ".join(found)


def _noun_before(text: str, start: int) -> str:
    """The words of a noun before sides, where they are of the same phrase."""
    spoken = text[max(0, start - 120) : start]
    cut = [m.end() for m in _CLAUSE.finditer(spoken)]
    bracket = spoken.rstrip().endswith("(")
    phrase = spoken[(cut[-2] if len(cut) > 1 else 0) :].rstrip(" (") if bracket else spoken[cut[-1] if cut else 0 :]
    found: list[str] = []
    own = ""
    for word in reversed(_WORD.findall(phrase)):
        if not found and word in _set("between"):
            own = own or (word if word in _set("room") else "")
            continue
        if _is_closed(word):
            found = [] if word == "for" else found  # whom or what the room is for
            break
        found.insert(0, word)
        if len(found) == 3:
            break
    return " ".join(found) or own


def _class(noun: str, own: str, last: str) -> Owner:
    """What a noun names: the room, another room, floor, a thing, or something that is not known."""
    if own and (noun.endswith(own) or own.endswith(noun)):
        return "room"
    if "noun" in vocabulary().get(noun, {}):
        return "thing"
    if last in _set("floor") and noun not in _set("room"):
        return "room" if noun in ("floor", "total floor", "floor area", "floor space", "total area") else "floor"
    if last in _set("room"):
        return "room"
    for phrase in (noun, " ".join(noun.split()[-2:]), last):
        kinds = vocabulary().get(phrase, {})
        if "noun" in kinds or "group" in kinds:
            return "thing"
        if "room" in kinds:
            return "room" if not own else "other room"
    if last in vocabulary() and not is_word(last):
        return "alone"
    return "unknown"


def _scaled(spoken: list[float], owner: Owner, noun: str, feet: bool, kind: str) -> tuple[float, ...] | None:
    """Numbers without a unit in metres, by what may have such sides; None where nothing may."""
    a, b = spoken[:2]
    if owner == "thing":
        entry = vocabulary().get(noun, vocabulary().get(noun.split()[-1], {})).get("noun")
        size = category_named(category_of(entry)).size if isinstance(entry, str) else None
        reach = sorted((size.reach[0], size.reach[1]), key=lambda r: r[1]) if size is not None else []
        for unit in (1.0, 0.01, FOOT):
            sides = sorted((a * unit, b * unit))
            if reach and all(0.8 * low <= side <= 1.25 * high for side, (low, high) in zip(sides, reach, strict=True)):
                return tuple(side * unit for side in spoken)
        unit = 0.01 if min(a, b) >= 20 else 1.0
        return tuple(side * unit for side in spoken) if max(a, b) * unit <= LONGEST else None
    known = room_types().get(kind)
    if feet and known is not None and a * b * FOOT**2 < TIGHT * known.area[0] <= a * b <= WIDE * known.area[2]:
        feet = False  # a table in feet in a room in metres
    unit = FOOT if feet else 1.0
    return tuple(round(side * unit, 4) for side in spoken) if max(a, b) <= 150 else None


def _is_free(text: str, start: int) -> bool:
    """Whether the sentence up to the end of the clause with the sides, or to where that clause goes on behind a comma,
    speaks of floor to keep free."""
    begin = text.rfind(". ", 0, start) + 1
    stop = _CLAUSE.search(text, start + 1)
    if stop is not None and stop[0] == "," and (on := _GOES_ON.match(text, stop.end())) is not None:
        stop = _CLAUSE.search(text, on.end())
    return _free().search(text, begin, stop.start() if stop is not None else len(text)) is not None


def _is_closed(word: str) -> bool:
    kinds = vocabulary().get(word, {})
    nouns = {"noun", "room", "group", "place", "region", "abstract", "matter", "number"}
    return not nouns & kinds.keys() and bool(
        {"preposition", "with", "det", "and", "while", "neg", "verb", "modal", "person", "pron", "stop"} & kinds.keys()
    )


@cache
def _set(name: str) -> frozenset[str]:
    return frozenset(words("room_sides")[name].split())


@cache
def _free() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?:{'|'.join(words('room_sides')['free'].split())})(?!\w)")


__all__ = ["room_sides"]
