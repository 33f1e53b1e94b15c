"""Floor that is to stay free, as the learned analysis finds it where no rule read it."""

from __future__ import annotations

import re

from ..model import FreeArea, Span
from ..statements.lengths import LENGTH, length_of
from .matched import Matched, overlap

WIDTHS = {"circle": 1.5, "path": 0.9, "rectangle": 1.5, "gap": 0.9, "clearance": 0.7}
"""What is kept free [m] where no measure is told."""

LENGTHS = (0.1, 20.0)
"""Least and largest length [m] of free floor."""

PHRASE = 60
"""Characters of the words about a free floor and its measure that are shown together, at most."""

_TURN = re.compile(r"\bturn|circle|spin|pivot")
_WAY = re.compile(r"\b(?:(?:way|path|aisle|route|passage|corridor|lane|walkway|gangway)s?|access|get|walk|pass)\b")
_BREAK = re.compile(r"[.;!?)](?:\s|$)|\n")
_LENGTH = re.compile(LENGTH)
_PLACES = {"corner": "corner", "middle": "middle", "centre": "middle", "center": "middle", "wall": "wall"}
_BESIDE = {"around": "around", "front": "front", "behind": "back", "beside": "sides"}
"""Sides of what a clearance is kept at, by links."""


def keep_free(both: Matched, sure: float) -> None:
    """Adds free floor that is found with such a certainty and overlaps no free floor of the rules."""
    taken = [area.span for area in both.parsed.free_areas]
    found = [k for k, named in enumerate(both.found.named) if named.kind == "free" and named.sure >= sure]
    tied = [sum(link.one == k for link in both.found.links) for k in range(len(both.found.named))]
    # of "clear 90 cm way" the noun, and of two nouns that which tells more
    for number in sorted(found, key=lambda k: (-round(both.found.named[k].sure, 1), -tied[k])):
        area = _area(both, number)
        if not any(overlap(span, area.span) for span in taken) and not _is_of_room(both, area):
            both.parsed.free_areas.append(area)
            taken.append(area.span)


def _area(both: Matched, number: int) -> FreeArea:
    links = both.found.links
    measures = [link.one for link in links if link.name == "of" and link.other == number]
    measures = [one for one in measures if not _BREAK.search(_between(both, one, number))]
    size, told = _size(both, measures)
    spans = [both.span(k) for k in (number, *told)]
    span = Span(min(s.start for s in spans), max(s.end for s in spans))
    span = span if span.end - span.start <= PHRASE else both.span(number)
    words = both.text[span.start : span.end].lower()
    kind, names, side = _shape(both, number, words, len(size))
    width = size[0] if size else WIDTHS[kind]
    sides = (width, size[1]) if len(size) > 1 and kind == "rectangle" else (width, width)
    return FreeArea(kind=kind, size=sides, targets=names, side=side, words=words, span=span)  # type: ignore[arg-type]


def _between(both: Matched, one: int, other: int) -> str:
    """The text between two mentions."""
    first, second = sorted((both.span(one), both.span(other)))
    return both.text[first.end : second.start]


def _is_of_room(both: Matched, area: FreeArea) -> bool:
    """Whether it is the floor of the room that has such sides: "floor 6 x 5 m"."""
    sides = [both.source.size, *both.parsed.sides]
    return area.kind == "rectangle" and any(s is not None and sorted(s[:2]) == sorted(area.size) for s in sides)


def _shape(both: Matched, number: int, words: str, lengths: int) -> tuple[str, tuple[str, ...], str]:
    """The kind of a free floor, what it is at, and on which side of that."""
    own = [link for link in both.found.links if link.one == number and link.other >= 0]
    at = {link.name: name for link in own if (name := _name(both, both.found.meant(link.other)))}
    if "from" in at or "to" in at:
        both_ends = sorted((link for link in own if link.name in ("from", "to")), key=lambda link: link.name)
        ends = [name for link in both_ends if (name := _name(both, both.found.meant(link.other)))]
        ends = list(dict.fromkeys(ends))[:2]
        ends = ends if len(ends) == 2 else ["door", *(end for end in ends if end != "door")]
        return "path", tuple(ends) if len(set(ends)) == 2 else (), "any"
    if "between" in at:
        return "gap", (at["between"],), "any"
    for name, side in _BESIDE.items():
        if name in at:
            of_room = at[name] in ("door", "window", *_PLACES.values())
            return ("rectangle", (at[name],), "front") if of_room else ("clearance", (at[name],), side)
    if _TURN.search(words):
        return "circle", (), "any"
    if _WAY.search(words) and lengths < 2:
        return "path", (), "any"
    return "rectangle", (at["in"],) if at.get("in") in ("middle", "corner") else (), "any"


def _size(both: Matched, measures: list[int]) -> tuple[tuple[float, ...], list[int]]:
    """Lengths [m] of measures, and the measures that tell them."""
    for number in measures:
        known = tuple(length for length in lengths_of(both.words(number)) if LENGTHS[0] <= length <= LENGTHS[1])
        if both.kind(number) == "measure" and known:
            return known[:2], [number]
    return (), []


def lengths_of(words: str) -> list[float]:
    """The lengths [m] that a measure tells, in order."""
    lengths = [length_of(found)[0] for found in _LENGTH.finditer(words)]
    return [length for length in lengths if length is not None]


def _name(both: Matched, number: int) -> str:
    """A mention in the words by which statements name things and parts of the room."""
    kind, words = both.kind(number), both.words(number)
    if kind == "thing":
        return both.things[number].noun if number in both.things else ""
    if kind == "opening":
        return "window" if "window" in words else "door"
    if (place := next((name for word, name in _PLACES.items() if word in words), "")) or kind != "place":
        return place
    of = [link.other for link in both.found.links if link.one == number and link.other >= 0]
    return next((_name(both, one) for one in map(both.found.meant, of) if both.kind(one) == "thing"), "")  # its side
