"""What the learned analysis says of the room itself where no rule read it: its sides, and what is not its shape."""

from __future__ import annotations

import re

from .free_floor import lengths_of
from .matched import Matched

SIDES = (1.0, 60.0)
"""Least and largest side [m] of a room that is told by two lengths."""

_NUMBER = re.compile(r"\d{1,2}(?:[.,]\d{1,2})?")


def tell_of_room(both: Matched, sure: float) -> None:
    """Gives the room the sides that two measures of it tell; takes a shape from it that is told of something else."""
    source, parsed = both.source, both.parsed
    if source.size is None and source.area is None and not parsed.sides:
        told = [both.words(number) for number in _of_room(both, "measure", sure)]
        lengths = [length for words in told for length in lengths_of(words) or _bare(words, told)]
        lengths = [length for length in lengths if SIDES[0] <= length <= SIDES[1]]
        if len(lengths) == 2:
            source.size = (max(lengths), min(lengths))
    if parsed.shape is not None:
        words = [k for k, n in enumerate(both.found.named) if n.kind == "quality" and both.words(k) in _shapes(both)]
        if words and not set(words) & {*_of_room(both, "quality", 1.0 - sure)}:
            parsed.shape = None


def _bare(words: str, told: list[str]) -> list[float]:
    """A number without a unit is of metres where another measure is: "4 m broad, 7 long"."""
    found = _NUMBER.match(words)
    metres = any(re.search(r"\d\s?m\b", other) for other in told)
    return [float(found[0].replace(",", "."))] if found and metres else []


def _shapes(both: Matched) -> set[str]:
    """Words by which the room may have got its shape."""
    shape = (both.parsed.shape or "").lower()
    return {shape, shape.replace("_", " "), shape.replace("_", "-")}


def _of_room(both: Matched, kind: str, sure: float) -> list[int]:
    """Mentions of a kind that belong to the room, in order."""
    room = {-1, *(k for k, named in enumerate(both.found.named) if named.kind == "room")}
    links = [link for link in both.found.links if link.name == "of" and link.other in room and link.sure >= sure]
    return sorted({link.one for link in links if both.kind(link.one) == kind})
