"""Which kind of room words of a purpose mean: names of kinds, and what people do in them (``purposes.yaml``)."""

from __future__ import annotations

import difflib
import math
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

from sceneweaver.assets.wordnet import noun_named

from .load import check_known, data_of, room_types, room_words

_WORD = re.compile(r"[^\W\d_]+(?:'s)?")
_ALIKE = 0.84
"""Likeness of a misspelt word to the one that is meant, as `difflib` measures it."""


NAMED = 1.15
"""How much more a name of a kind tells than what people do there."""

APART = 2
"""Words that may stand between those of a phrase."""


class Found(NamedTuple):
    """A kind of room that words mean."""

    kind: str
    score: float
    """Rarity of the words that told it, in nats, weighed by where they stood."""
    told: frozenset[str]
    """The stems that told it."""
    named: bool
    """Whether it is a name of the kind, not only what people do there."""


@cache
def _listed(name: str) -> frozenset[str]:
    """Words of a list of the data."""
    return frozenset(data_of("purposes.yaml")[name])


def stem(word: str) -> str:
    """A word without its endings, so that "repairing bikes" is "repair bike"."""
    word = word.removesuffix("'s").removesuffix("'")
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    for ending in ("ing", "ed", "es", "s", "e"):
        base = word.removesuffix(ending)
        least = 4 if ending in ("ed", "es", "e") and not base.endswith(("x", "sh", "ch")) else 3
        if base != word and len(base) >= least and not word.endswith("ss"):
            if ending == "ing" and base[-1] == base[-2] and base[-1] not in "slz":
                base = base[:-1]
            return base.removesuffix("e") if len(base) > 4 else base
    return word


def stems(text: str) -> list[str]:
    """The stems of the words of a text that tell something."""
    return [stem(word) for word in _WORD.findall(text.lower()) if word not in _listed("empty")]


@cache
def _phrases() -> Mapping[frozenset[str], tuple[tuple[str, bool], ...]]:
    """By the stems of a phrase the kinds of rooms that it may mean, and whether it is a name of the kind."""
    data = data_of("purposes.yaml")["purposes"]
    check_known("purposes.yaml", data, room_types(), "kind of room")
    found: dict[frozenset[str], dict[str, bool]] = {}
    for phrase, kind in room_words().items():
        told = frozenset(stems(phrase)) - stemmed_heads()
        if told:
            found.setdefault(told, {}).setdefault(kind, True)
    for kind, phrases in data.items():
        for phrase in phrases:
            told = frozenset(stems(phrase))
            told = told - stemmed_heads() or told
            if not told:
                raise ValueError(f"purposes.yaml: '{phrase}' of {kind} tells nothing")
            found.setdefault(told, {}).setdefault(kind, False)
    return {told: tuple(kinds.items()) for told, kinds in found.items()}


@cache
def stemmed_heads() -> frozenset[str]:
    """The stems of words for a room of any kind."""
    return frozenset(stem(word) for word in _listed("heads"))


@cache
def _rarity() -> Mapping[str, float]:
    """How much each stem tells: the logarithm of how few kinds of rooms use it."""
    kinds = Counter(s for s, _ in {(s, k) for told, of in _phrases().items() for k, _ in of for s in told})
    return {s: math.log(1.0 + len(room_types()) / n) for s, n in kinds.items()}


def kinds_meant(parts: Sequence[tuple[str, float]]) -> list[Found]:
    """The kinds of rooms that parts of a phrase may mean, the likeliest first.

    A phrase counts where all its words are there, in any order and form, misspelt ones as well.

    Args:
        parts: texts with their weights, such as what a room is for before where it is.
    """
    weight: dict[str, float] = {}
    places: dict[str, list[int]] = {}
    at = 0
    for text, much in parts:
        for word, after in pairwise((*_WORD.findall(text.lower()), "")):
            at += 1
            for known in () if word in _listed("empty") else _read(word, after):
                weight[known] = max(weight.get(known, 0.0), much)
                places.setdefault(known, []).append(at)
    found: dict[str, Found] = {}
    there = set(weight)
    for told, kinds in _phrases().items():
        if not told <= there or not _together([places[s] for s in told]):
            continue
        score = sum(_rarity()[s] * weight[s] for s in told)
        whole = min(weight[s] for s in told) >= 1.0
        for kind, named in kinds:
            one = Found(kind, score * (NAMED if named and whole else 1.0), told, named)
            if kind not in found or one.score > found[kind].score:
                found[kind] = one
    return sorted(found.values(), key=lambda one: (-one.score, one.kind))


def _together(places: Sequence[Sequence[int]]) -> bool:
    """Whether words stand so near each other that they are one phrase."""
    if len(places) < 2:
        return True
    starts = [place for places_of in places for place in places_of]
    return any(
        all(any(start <= place < start + len(places) + APART for place in places_of) for places_of in places)
        for start in starts
    )


@cache
def _read(word: str, after: str) -> tuple[str, ...]:
    """The stems that a word means: of one that is run together both parts, and what it is with the next one."""
    one, both = stem(word), stem(word + after) if after else ""
    found = [both] if both in _rarity() else []
    head = next((h for h in _listed("heads") if word.endswith(h) and len(word) > len(h) + 2), "")
    if one not in _rarity() and head and stem(word.removesuffix(head)) in _rarity():
        return (*found, stem(word.removesuffix(head)))
    return (*found, one if noun_named(word) is not None else _known(one))  # concrete is no slip of a concert


@cache
def _known(one: str) -> str:
    """A stem, or the one that is meant where it is misspelt."""
    if one in _rarity() or len(one) < 6:
        return one
    near = difflib.get_close_matches(one, _long_stems(), n=1, cutoff=_ALIKE)
    return near[0] if near else one


@cache
def _long_stems() -> tuple[str, ...]:
    return tuple(s for s in _rarity() if len(s) >= 5)


def core_of(kind: str, most: int = 3) -> Iterable[tuple[str, int]]:
    """The furniture that makes a kind of room what it is: categories with the least number of each, at most so many."""
    room = room_types()[kind]
    chosen: list[str] = []
    for item in room.items:
        if item.need != "needed" or len(chosen) == most or (item.with_ is not None and item.with_ not in chosen):
            continue
        chosen.append(item.id)
        yield item.what[0], 1


__all__ = ["Found", "core_of", "kinds_meant", "stem", "stemmed_heads", "stems"]
