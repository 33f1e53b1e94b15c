"""What a noun of several meanings means in a request: by the kind of the room and the words around it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import resolve

from .source import Source
from .vocabulary import vocabulary, words

BESIDE = 32
"""Characters before and after a noun within which words stand beside it."""


NOTHING = ""
"""What a noun means that is no thing where it stands: the glass of a window."""


def sense_of(noun: str, source: Source, start: int, end: int, scale: float, bare: bool = False) -> str | None:
    """The category that a noun at characters [start, end) means; None where it has its usual sense, `NOTHING` where
    it is no thing. ``bare``: whether it has no "a", no number and no plural.

    A compound that is known by itself has no other sense.
    """
    head = singular(noun.partition(" of ")[0].split()[-1])
    rows = words("senses").get(head) if head != "scenes" else None
    if rows is None or _is_compound(noun):
        return None
    around = source.spoken[max(0, start - BESIDE) : end + BESIDE]
    for row in rows:
        if row.get("bare", bare) == bare and _fits(row, source.spoken, around, scale):
            return next((name for name in row["means"] if _is_known(name)), None if row["means"] else NOTHING)
    return None


def _is_known(name: str) -> bool:
    """Whether a name is that of a category, or of what the body of one stands for."""
    return name in categories() or resolve(name).how == "like"


def _is_compound(noun: str) -> bool:
    """Whether a noun, or the end of it, is a compound that is known by itself: "crystal wine glasses"."""
    parts = noun.partition(" of ")[0].split()
    return any("noun" in vocabulary().get(" ".join(parts[k:]), {}) for k in range(len(parts) - 1))


def _fits(row: Mapping[str, Any], text: str, around: str, scale: float) -> bool:
    if scale < row.get("scale", 0.0):
        return False
    if "unless" in row and _any_of(tuple(row["unless"])).search(text):
        return False
    if "apart" in row and _any_of(tuple(row["apart"])).search(around):
        return False
    near = "near" not in row or _any_of(tuple(row["near"])).search(text)
    return bool(near and ("beside" not in row or _any_of(tuple(row["beside"])).search(around)))


@cache
def _any_of(names: Sequence[str]) -> re.Pattern[str]:
    """A pattern for any of some words; "=music" stands for the words of a scene."""
    scenes = words("senses")["scenes"]
    phrases = [word for name in names for word in (scenes[name[1:]] if name.startswith("=") else (name,))]
    return re.compile(rf"\b(?:{'|'.join(map(re.escape, phrases))})\b")
