"""Words that change what a clause says, such as "each" or "the long wall", and that nothing which was read covers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from sceneweaver.assets.plurals import singular
from sceneweaver.language import Entity, SceneGraph, Span
from sceneweaver.language.coverage import function_words
from sceneweaver.language.vocabulary import NUMBERS, words
from sceneweaver.rules.faults import number

from .model import ItemOutcome
from .survey import Survey

_WORD = re.compile(r"[^\W\d_]{3,}")

SIDED, OF_EACH = ("relation", "arrangement"), ("entity", "relation", "capacity", "arrangement")
"""Kinds of items that are doubted beside words of sides, and beside those that say for how many it holds."""


class Doubt(NamedTuple):
    """Words, where they stand, the kinds of items beside them that may not mean what was asked, and the place in the
    text up to which those come after them: "each" is said of a whole list."""

    words: str
    span: Span
    kinds: tuple[str, ...]
    until: int = 0


def swallowed(graph: SceneGraph) -> Iterator[Doubt]:
    """Each such word."""
    for match in _sides().finditer(graph.text):
        span = Span(*match.span(1))
        if not _read(graph, span) and not _meant(graph, match[1].lower()):
            yield Doubt(match[0], span, SIDED)
    for match in _distributive().finditer(graph.text):
        span = Span(*match.span())
        if not _read(graph, span) and not _of_each(graph, span):
            yield Doubt(match[0], span, OF_EACH, _sentence(graph, span)[1])


def of_each(text: str) -> str:
    """The word of some words that says that they hold of each of several; empty where none does."""
    found = _distributive().search(text)
    return found[0].lower() if found else ""


def of_its_own(graph: SceneGraph, entity: Entity) -> str:
    """The first word within the noun phrase of a thing that nothing which was read speaks for: "crate" of "a crate
    table" that became a coffee table; empty where all are read, or the thing is named in another language."""
    if entity.span is None or entity.implied:
        return ""
    phrase, start = graph.text[entity.span.start : entity.span.end], entity.span.start
    told = " ".join((entity.noun, *entity.words, *(f"{a.words} {a.value}" for a in entity.attributes)))
    told += " ".join(("", *(one.words for one in (*graph.arrangements, *graph.looks))))
    told += f" {entity.category} {entity.color} {entity.material} {entity.style}"
    known = {form for word in _WORD.findall(told.lower()) for form in (word, singular(word))}
    spoken = [(m[0].lower(), Span(start + m.start(), start + m.end())) for m in _WORD.finditer(phrase)]
    if not any(word in known or singular(word) in known for word, _ in spoken):
        return ""
    for word, span in spoken:
        if word in known or singular(word) in known or word in function_words() or word in NUMBERS:
            continue
        if not _read(graph, span):
            return word
    return ""


def is_so(survey: Survey, doubt: Doubt, outcome: ItemOutcome) -> bool:
    """Whether what the words say is so all the same: all that it is about is at one long wall, or at one short one."""
    word = doubt.words.split()[0].lower()
    bodies = [survey.placed.by_id[name] for name in outcome.objects if name in survey.placed.by_id]
    if outcome.kind != "relation" or word not in ("long", "short") or not bodies:
        return False
    walls = survey.placed.walls
    longest, shortest = (pick(wall.length for wall in walls) for pick in (max, min))
    at = {min(walls, key=lambda w: abs(w.coordinates(body.centre)[1])).index for body in bodies}
    wall = walls[at.pop()]
    fits = (wall.length - shortest > longest - wall.length) == (word == "long")
    return fits and not at and longest > shortest * number("long_wall")


@cache
def _sides() -> re.Pattern[str]:
    rows = words("bearing_words")
    before, after = "|".join(rows["sides"]), "|".join(rows["places"].split())
    return re.compile(rf"\b({before})\s+(?:{after})\b", re.IGNORECASE)


@cache
def _distributive() -> re.Pattern[str]:
    return re.compile(rf"\b(?:{'|'.join(words('bearing_words')['distributive'].split())})\b", re.IGNORECASE)


def _read(graph: SceneGraph, span: Span) -> bool:
    """Whether an item other than the noun phrase of a thing stands there."""
    rows = (
        *(attribute for entity in graph.entities for attribute in entity.attributes),
        *graph.exclusions,
        *graph.openings,
        *graph.free_areas,
        *graph.capacities,
        *graph.arrangements,
        *graph.views,
        *graph.amounts,
        *graph.unread,
        *graph.relations,
    )
    return any(r.span is not None and r.span.start <= span.start and span.end <= r.span.end for r in rows)


def _meant(graph: SceneGraph, word: str) -> bool:
    """Whether some relation is about such a side."""
    names = set(words("bearing_words")["sides"][word].split())
    said: set[str] = set()
    for relation in graph.relations:
        said |= {relation.side or "", *(target.partition(":")[2] for target in relation.targets)}
    return bool(names & said)


def _sentence(graph: SceneGraph, span: Span) -> tuple[int, int]:
    """Where the sentence of some words begins and ends."""
    ends = [m.start() for m in re.finditer(r"[.;!?\n](?!\d)", graph.text)]
    before = max((e for e in ends if e < span.start), default=-1)
    return before, min((e for e in ends if e >= span.end), default=len(graph.text))


def _of_each(graph: SceneGraph, span: Span) -> bool:
    """Whether something in its sentence is read as of each, or the noun phrase that it stands in has a number."""
    before, after = _sentence(graph, span)
    for entity in graph.entities:
        at = entity.span
        if at is not None and at.start <= span.start < at.end and entity.count is not None and entity.count[0] > 1:
            return True
    read = (*(r for r in graph.relations if r.each), *(c for c in graph.capacities if c.each or c.own))
    return any(r.span is not None and before < r.span.start < after for r in read)


__all__ = ["Doubt", "is_so", "of_each", "of_its_own", "swallowed"]
