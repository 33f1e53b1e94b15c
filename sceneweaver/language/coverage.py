"""Which words of a request nothing in its graph accounts for.

Every content word is part of something that was read (a thing, what it is like, where it is, what the room is) or is
told to the user as not understood. Words of grammar and of politeness need no account; they are data
(``lexicon/function_words.yaml``).
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from .model import SceneGraph, Span, Unread
from .vocabulary import words

_WORD = re.compile(r"[^\W\d_]+(?:['’&-][^\W\d_]+)*|\d+(?:[.,]\d+)?", re.UNICODE)
_JOIN = re.compile(r"[\s'’\"-]*")


def silent_words(graph: SceneGraph) -> tuple[Unread, ...]:
    """The words of the text that no item of the graph accounts for, neighbours together, in order.

    Time grows with the length of the text.
    """
    covered = bytearray(len(graph.text) + 1)
    for span in _spans(graph):
        covered[span.start : span.end] = b"\x01" * (min(span.end, len(graph.text)) - span.start)
    known = _known_elsewhere(graph)
    found: list[list[int]] = []
    for match in _WORD.finditer(graph.text):
        word = match[0].lower().replace("’", "'")
        if any(covered[match.start() : match.end()]) or word in function_words() or word in known:
            continue
        if word[0].isdecimal() and _is_measure(graph, match):
            continue
        if found and _JOIN.fullmatch(graph.text, found[-1][1], match.start()):
            found[-1][1] = match.end()
        else:
            found.append([match.start(), match.end()])
    return tuple(Unread(words=graph.text[a:b].lower(), span=Span(a, b)) for a, b in found)


@cache
def function_words() -> frozenset[str]:
    """Words that say nothing of what is in a room: articles, pronouns, auxiliaries, politeness."""
    return frozenset(word for group in words("function_words").values() for word in group.split())


def _spans(graph: SceneGraph) -> Iterable[Span]:
    """Where everything that was read stands."""
    rows = (graph.entities, graph.relations, graph.exclusions, graph.openings, graph.free_areas, graph.capacities)
    for row in (item for several in (*rows, graph.arrangements, graph.unread) for item in several):
        if row.span is not None:
            yield row.span
    for entity in graph.entities:
        yield from (attribute.span for attribute in entity.attributes if attribute.span is not None)


def _known_elsewhere(graph: SceneGraph) -> frozenset[str]:
    """Words of facts about the room, which have no place of their own."""
    said = [graph.room_words, graph.style or "", graph.shape or "", *graph.colors, *graph.for_whom]
    said += [name.replace("_", " ") for name in graph.other_rooms]
    said += [word for relation in graph.relations for word in (relation.words,)]
    said += [word for excluded in graph.exclusions for word in (excluded.words,)]
    said += [word for entity in graph.entities for word in (entity.noun, *entity.words)]
    said += [a.words for entity in graph.entities for a in entity.attributes]
    spoken = frozenset(word for text in said for word in _WORD.findall(text.lower()))
    if graph.scale != 1.0 or graph.density != "normal" or graph.only:
        spoken |= frozenset(" ".join(words("function_words").get("room_quality", "").split()).split())
    return spoken


def _is_measure(graph: SceneGraph, match: re.Match[str]) -> bool:
    """Whether a number is one of the room's sides, its area, its height or a count that was read."""
    value = float(match[0].replace(",", "."))
    have = [*(graph.size or ()), graph.area or 0.0, graph.height or 0.0, float(graph.people or 0)]
    have += [float(n) for entity in graph.entities for n in entity.count or ()]
    have += [float(s) for entity in graph.entities for s in entity.size if s is not None]
    have += [float(value) for relation in graph.relations for value in relation.params.values() if value is not None]
    units = (1.0, 0.01, 0.001, 0.3048, 0.0254, 0.092903)
    return any(abs(value * unit - other) <= 0.006 * max(1.0, other) for unit in units for other in have if other)


__all__ = ["function_words", "silent_words"]
