"""Seats on the two sides of a desk as relations: who works there sits at its front, who comes to see them at its back.

A desk that is told to look somewhere does so from its owner's seat.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from sceneweaver.knowledge.desk_sides import desk_side, is_desk, owner_of
from sceneweaver.language import Grounded, SceneGraph, StatedRelation
from sceneweaver.language.pairs import of_pair

from .program import Wanted

TOWARD_DOOR = 20.0
"""Most angle [deg] between the way out and where who sits at a desk that faces the door looks."""


def at_desks(rows: Sequence[Grounded], brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What a request states, with the places of seats behind and before desks on the sides that people mean.

    Args:
        rows: the grounded relations.
        brief: the request.
        wanted: the objects to be.
    """
    made: dict[str, list[Wanted]] = {}
    for one in wanted:
        if one.mount == "floor" and one.support is None:
            made.setdefault(one.asked or "", []).append(one)
    kept = list(rows)
    placed: set[str] = set()
    for said in brief.relations:
        found = list(_seated(said, brief, made))
        ids = {row.subject for row in found}
        if not found:
            continue
        kept = [row for row in kept if not (row.said == said.id and row.subject in ids)]
        kept += [row for row in found if row.subject not in placed]
        placed |= ids
    for said in brief.relations:
        if said.type == "facing" and said.targets == ("door",) and is_desk(brief.entity(said.subject)):
            kept += _looking_out(said, brief, made)
    return kept


def _seated(said: StatedRelation, brief: SceneGraph, made: Mapping[str, Sequence[Wanted]]) -> Iterator[Grounded]:
    """The places of the seats of one statement, shared out among the desks in turn."""
    meant = desk_side(said, brief)
    if meant is None:
        return
    desks, seats = made.get(meant.desk, ()), made.get(said.subject, ())
    if not desks or not all(is_desk(desk.thing) for desk in desks):
        return
    share = -(-len(seats) // len(desks))
    for number, seat in enumerate(seats):
        desk, k = desks[number // share], number % share
        n = min(share, len(seats) - share * (number // share))
        for row in of_pair(meant.side, seat.thing, desk.thing, None, k, n):
            yield Grounded(said.id, row.type, seat.id, desk.id, dict(row.params), row.hard)


def _looking_out(said: StatedRelation, brief: SceneGraph, made: Mapping[str, Sequence[Wanted]]) -> Iterator[Grounded]:
    """Who sits at a desk that faces the door looks at it."""
    owner = owner_of(said.subject, brief)
    seats = made.get(owner, ()) if owner is not None else ()
    own = [
        seat for desk in made.get(said.subject, ()) for many in made.values() for seat in many if seat.parent is desk
    ]
    for seat in [one for one in (*seats, *own) if "seating" in one.thing.roles][: len(made.get(said.subject, ()))]:
        yield Grounded(said.id, "facing_door", seat.id, None, {"degrees": TOWARD_DOOR})


__all__ = ["at_desks"]
