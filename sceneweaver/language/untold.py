"""What a request says and nothing was read of, in the phrases of the request, as it is told to the user."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import pairwise

from .coverage import BREAK, WORD, function_words, marked, spans_read
from .model import SceneGraph, Span, Unread
from .vocabulary import words

_SENTENCE = re.compile(r"[.;!?\n](?!\d)")
MOST_BETWEEN = 4
"""Words of grammar within a phrase that was not understood at most."""


def in_phrases(left: Iterable[Unread], graph: SceneGraph) -> tuple[Unread, ...]:
    """What was not understood, in the phrases of the request: neighbours with nothing between them but words of grammar
    are one ("touch of brass"); what stands alone keeps its words."""
    read = marked(graph, (*spans_read(graph, unread=False), *(entity.span for entity in graph.entities)))
    found: list[Unread] = []
    for one in left:
        last = found[-1].span if found else None
        span = _with_negation(one, graph.text)
        if span is None or last is None or not _joins(graph.text, read, last, span):
            found.append(one.model_copy(update={"span": span}))
        else:
            found[-1] = _phrase(graph.text, Span(last.start, max(last.end, span.end)))
    return tuple(_named_again(one, graph.text) for one in found)


def _with_negation(one: Unread, text: str) -> Span | None:
    """Where words stand, with the first of them where that is told before its place: the "no" of "no flash"."""
    if one.span is None:
        return None
    first, _, rest = one.words.partition(" ")
    before = text[: one.span.start].rstrip()
    if rest and rest == text[one.span.start : one.span.end].lower() and before.lower().endswith(first):
        return Span(len(before) - len(first), one.span.end)
    return one.span


def _named_again(one: Unread, text: str) -> Unread:
    """Words in which the name of the room gave way to "room", as they are in the request."""
    if one.span is None or "room" not in one.words.split() or "room" in text[one.span.start : one.span.end].lower():
        return one
    end = next((m.end() for m in WORD.finditer(text, one.span.start) if m.end() >= one.span.end), one.span.end)
    return _phrase(text, Span(one.span.start, end))


def _phrase(text: str, span: Span) -> Unread:
    return Unread(words=" ".join(text[span.start : span.end].lower().split()), span=span)


def _joins(text: str, read: Sequence[int], one: Span, other: Span) -> bool:
    """Whether nothing stands between two places but a few words of grammar of which nothing was read."""
    between = text[one.end : other.start]
    if not one.start <= other.start <= len(text) or any(read[one.end : other.start]) or BREAK.search(between):
        return False
    spoken = [match[0].lower() for match in WORD.finditer(between)]
    return len(spoken) <= MOST_BETWEEN and all(word in function_words() for word in spoken)


def empty_sentences(graph: SceneGraph, left: Iterable[Unread], referred: Iterable[Span]) -> tuple[Unread, ...]:
    """Sentences that name again what was named, or deny something, and say nothing that was read: "the dog may not sit
    on the sofa". The words of such a sentence are all known, and what they say together is lost.

    Args:
        graph: what was read.
        left: what is told anyway.
        referred: where what was named before is named again.
    """
    spans = (*spans_read(graph), *(entity.span for entity in graph.entities), *(one.span for one in left))
    read, again = marked(graph, spans), marked(graph, referred)
    ends = [-1, *(match.start() for match in _SENTENCE.finditer(graph.text)), len(graph.text)]
    facts = _facts_of_room(graph)
    found: list[Unread] = []
    for before, end in pairwise(ends):
        start = before + 1
        spoken = [(match[0].lower().replace("’", "'"), match) for match in WORD.finditer(graph.text, start, end)]
        if any(read[start:end]) or any(word in facts or word[0].isdecimal() for word, _ in spoken):
            continue
        denies = any(word in words("bearing_words")["denying"] for word, _ in spoken)
        if spoken and (denies or any(again[start:end])) and len(spoken) > 2:
            found.append(_phrase(graph.text, Span(spoken[0][1].start(), spoken[-1][1].end())))
    return tuple(found)


def _facts_of_room(graph: SceneGraph) -> frozenset[str]:
    """Words that tell something of the whole room, which has no place of its own."""
    said = [graph.room_words, graph.style or "", graph.shape or "", *graph.colors]
    said += [name.replace("_", " ") for name in (*graph.other_rooms, graph.room_type or "")]
    told = {word for text in said for word in WORD.findall(text.lower())}
    return frozenset(told | {*words("bearing_words")["of_room"].split()})


__all__ = ["empty_sentences", "in_phrases"]
