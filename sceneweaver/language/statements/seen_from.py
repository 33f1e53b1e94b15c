"""Openings that are told by what is at them: "a window over the sink", "a door beside the wardrobe".

Such words say where the thing is as well as the opening: they are turned about ("the sink under window"), so that the
clauses read one relation of the thing.
"""

from __future__ import annotations

import re

from ..parsed import Parsed
from ..source import Source
from .phrases import Edits, noun_after, one_of
from .resolve import is_thing

_TURNED = {
    "opposite": ("opposite", "facing"),
    "across from": ("opposite", "facing"),
    "facing": ("facing",),
    "beside": ("beside", "by"),
    "next to": ("next to", "by"),
    "by": ("by",),
    "near": ("near", "by"),
    "over": ("under", "at"),
    "above": ("under", "at"),
    "behind": ("at",),
}
"""What a word between an opening and a thing says of the thing, the best word first."""

_PHRASE = re.compile(
    rf"(?:\b(?:an?|one|the)\s+)?\b(?P<opening>windows?|doors?)\s(?:is\s|that is\s)?(?P<word>{one_of(list(_TURNED))})\s"
    r"(?:the|my|our|his|her)\s"
)
_REFERRED = re.compile(
    r"\b(?:in|on|at|under|below|above|over|by|near|beside|next to|opposite|facing|behind|to|of|from|between|no)\s+$"
)


def seen_from(source: Source, parsed: Parsed) -> None:
    """Turns about what is said of openings by things, and counts these openings."""
    edits = Edits(source)
    for found in list(_PHRASE.finditer(source.text)):
        noun, end = noun_after(source.text, found.end())
        while noun and not is_thing(noun):
            noun = noun.rpartition(" ")[0]
        if not noun or _REFERRED.search(source.text[: found.start()]) is not None:
            continue
        end = found.end() + len(noun)
        opening = found["opening"]
        turned = (f"the {noun} {word} {opening}" for word in _TURNED[found["word"]])
        fits = next((text for text in turned if len(text) <= end - found.start()), None)
        if fits is None:
            continue
        part = opening.rstrip("s")
        parsed.openings.setdefault(part, 2 if opening.endswith("s") else 1)
        parsed.referred.append(edits.take(found.start(), end, fits))


__all__ = ["seen_from"]
