"""Relations of things to each other: "two desks facing each other, each with a chair"."""

from __future__ import annotations

from copy import deepcopy

from .parser_state import Mention, ParsedRelation, ParsedRequest

EACH_OTHER = "each other"
"""Target of a relation among its own subjects."""

MOST = 6
"""Things of one kind that are told apart, so that each can be related to the next."""


def pairs(kind: str, subjects: list[Mention]) -> list[tuple[Mention, Mention]]:
    """Who is related to whom: two that face each other both do, a row goes from one to the next."""
    if kind == "facing":
        couples = list(zip(subjects[::2], subjects[1::2], strict=False))
        return [pair for a, b in couples for pair in ((a, b), (b, a))]
    return list(zip(subjects, subjects[1:], strict=False))


def split_mutual(parsed: ParsedRequest) -> None:
    """Turns "two desks" that face each other into a desk and a desk, and what belongs to them likewise."""
    for said in list(parsed.said):
        if said.target == EACH_OTHER and len(said.subjects) == 1:
            _split(parsed, said.subjects[0])


def _split(parsed: ParsedRequest, one: Mention, parts: int | None = None) -> list[Mention]:
    low, high = one.count or (2, 2)
    parts = parts or low
    if low != high or not 2 <= parts <= MOST or low % parts:
        return []
    halves = [deepcopy(one) for _ in range(parts)]
    for half in halves:
        half.count = (low // parts, low // parts)
    at = next(k for k, m in enumerate(parsed.mentions) if m is one)
    parsed.mentions[at : at + 1] = halves
    new: list[ParsedRelation] = []
    for said in parsed.said:
        if any(m is one for m in said.subjects):
            said.subjects = [h for m in said.subjects for h in (halves if m is one else [m])]
        if isinstance(said.target, tuple):
            first, second = said.target
            said.target = (halves[0] if first is one else first, halves[-1] if second is one else second)
        if said.target is not one:
            new.append(said)
            continue
        new += _shared(parsed, said, halves)
    parsed.said = new
    return halves


def _shared(parsed: ParsedRequest, said: ParsedRelation, halves: list[Mention]) -> list[ParsedRelation]:
    """What is said of both desks: a chair for each when the chairs can be shared out."""
    (subject, *others) = said.subjects
    count = subject.count
    if not others and count and count[0] == count[1] and count[0] >= len(halves) and count[0] % len(halves) == 0:
        parts = _split(parsed, subject, len(halves))
        if parts:
            return [ParsedRelation(said.kind, [p], h, said.words) for p, h in zip(parts, halves, strict=True)]
    said.target = halves[0]
    return [said]
