"""What the rules read of a request as evidence for the network: of words, and of pairs of mentions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import get_args

import numpy as np

from ..model import RelationType, Span
from ..parsed import Mention, Parsed

TYPES: tuple[str, ...] = get_args(RelationType)
RELATIONS = 2 * len(TYPES) + 1
"""Kinds of evidence for a pair: nothing, a type of relation as it was said, one that is implied."""

WORDS = ("nothing", "left", "placed", "room", "opening", "free", "barred", "thing")
"""Kinds of evidence for a word, what is later goes before."""


def of_words(parsed: Parsed, words: Sequence[tuple[int, int]]) -> np.ndarray:
    """The kind of evidence for each word of a text, which begins and ends at such characters (words,)."""
    found = np.zeros(len(words), np.int32)
    for kind, spans in enumerate(_spans(parsed)):
        for span in spans:
            if span is not None:
                found[[k for k, (start, end) in enumerate(words) if start < span.end and end > span.start]] = kind
    return found


def _spans(parsed: Parsed) -> tuple[Iterable[Span | None], ...]:
    return (
        (),
        (left.span for left in parsed.unread),
        (said.span for said in parsed.said if not said.implied),
        (zone.span for zone in parsed.zones),
        (opening.span for opening in parsed.stated_openings),
        (area.span for area in parsed.free_areas),
        (span for span in (*(one[2] for one in parsed.without), *(b.span for b in (*parsed.barred, *parsed.unwanted)))),
        (mention.span for mention in parsed.mentions),
    )


def of_pairs(parsed: Parsed, spans: Sequence[tuple[int, int]]) -> np.ndarray:
    """The kind of evidence for each pair of mentions, which stand at such characters: (mentions + 1, mentions + 1),
    where number 0 is the room.

    A relation speaks for the pair of what it is said of, and for pairs with what stands in its words, such as "it".
    """
    found = np.zeros((len(spans) + 1, len(spans) + 1), np.int32)
    for said in parsed.said:
        if said.type not in TYPES:
            continue
        kind = TYPES.index(said.type) + 1 + (len(TYPES) if said.implied else 0)
        targets = [target.span for target in said.targets if isinstance(target, Mention)]
        ones = _at(spans, [subject.span for subject in said.subjects])
        others = _at(spans, [*targets, None if said.implied else said.span])
        for one in ones:
            for other in others:
                if one != other and (found[one, other] == 0 or not said.implied):
                    found[one, other] = kind
    return found


def _at(spans: Sequence[tuple[int, int]], places: Iterable[Span | None]) -> list[int]:
    there = [place for place in places if place is not None]
    return [k for k, (start, end) in enumerate(spans, 1) if any(start < p.end and end > p.start for p in there)]
