"""Kinds of rooms by what people call them: those that ship with the library, then those that were learned."""

from __future__ import annotations

import difflib

from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError

from .learned import all_rooms, learned_words
from .load import room_words
from .model import RoomType


def room_type(name: str) -> RoomType:
    """The kind of room of that name, one that was learned included; InputError when there is none."""
    known = all_rooms()
    if name not in known:
        raise InputError(f"room: '{name}' is unknown{suggest(name, known)}")
    return known[name]


def match_room(words: str) -> tuple[str, float] | None:
    """The kind of room that words name, and how surely (1 exact, less for a misspelt name); None when unknown."""
    asked = " ".join(words.lower().replace("_", " ").replace("-", " ").split())
    table = room_words()
    for known in (table, learned_words()):
        for form in (asked, asked.removesuffix("s")):
            if form in known:
                return known[form], 1.0
    alike = [form for form in difflib.get_close_matches(asked, table, n=5, cutoff=0.8) if _word_by_word(asked, form)]
    near = alike[:1]
    return (table[near[0]], difflib.SequenceMatcher(None, asked, near[0]).ratio()) if near else None


PARTS = frozenset(("area", "corner", "zone", "section", "counter", "part", "nook", "end", "side"))
"""Words for a part of a room: a bakery counter area is one of a bakery."""


def room_of_part(words: str) -> str | None:
    """The kind of room of which words name a part; None where they name none."""
    spoken = words.lower().replace("-", " ").split()
    while spoken and spoken[-1] in PARTS:
        spoken.pop()
        found = match_room(" ".join(spoken)) if spoken else None
        if found is not None:
            return found[0]
    return None


def _word_by_word(asked: str, known: str) -> bool:
    """Whether each word is a misspelling of its counterpart: a "boiler room" is no "toilet room".

    Hardly anybody misspells the first letter: a "visiting room" is no "sitting room"."""
    mine, theirs = asked.split(), known.split()
    return len(mine) != len(theirs) or all(
        a[:1] == b[:1] and difflib.SequenceMatcher(None, a, b).ratio() >= 0.75
        for a, b in zip(mine, theirs, strict=True)
    )
