"""Relations of things to each other: "two desks facing each other, each with a chair"."""

from __future__ import annotations

from dataclasses import replace

from .parsed import Mention, Parsed, Said

MOST = 6
"""Things of one kind that are told apart, so that each can be related to the next."""


def split_mutual(parsed: Parsed) -> None:
    """Turns "two desks" that face each other into a desk and a desk, and what belongs to them likewise."""
    for said in list(parsed.said):
        if said.targets == ("each other",) and len(said.subjects) == 1:
            _split(parsed, said.subjects[0])


def _split(parsed: Parsed, one: Mention, parts: int | None = None) -> list[Mention]:
    low, high = one.count or (2, 2)
    parts = parts or low
    if low != high or not 2 <= parts <= MOST or low % parts or one not in parsed.mentions:
        return []
    halves = [one.copied(count=(low // parts, low // parts)) for _ in range(parts)]
    shared = [s for s in parsed.said if len(s.targets) == 1 and s.targets[0] is one]
    parsed.replace(one, halves)
    for said in shared:
        _share(parsed, said, halves)
    return halves


def _share(parsed: Parsed, said: Said, halves: list[Mention]) -> None:
    """What is said of both desks: a chair for each when the chairs can be shared out."""
    (subject, *others) = said.subjects
    count = subject.count
    if others or not count or count[0] != count[1] or count[0] < len(halves) or count[0] % len(halves):
        return
    parts = _split(parsed, subject, len(halves))
    if not parts:
        return
    if said in parsed.said:
        at = parsed.said.index(said)
        parsed.said[at : at + 1] = [
            replace(said, subjects=[p], targets=(h,), count=None, params={}) for p, h in zip(parts, halves, strict=True)
        ]
