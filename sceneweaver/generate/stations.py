"""Stations in a line: seats each of which has something of its own on the wall before it, such as a mirror."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sceneweaver.language import Grounded, SceneGraph, StatedRelation
from sceneweaver.language.model import Arrangement

from .meant import own_on_wall
from .program import Wanted

REACH = 0.75
"""Gap [m] between the front of a seat and what hangs on the wall before it: somebody stands or leans there."""

ROOM = 0.75
"""Gap [m] between neighbours that somebody works around."""

NARROW = 0.5
"""Width [m] of a seat up to which neighbours have a usual gap: stools at a counter."""

WITHIN = 0.06
"""Most distance [m] of what hangs from its place."""


def rows_before_walls(brief: SceneGraph, wanted: Sequence[Wanted]) -> Iterator[Arrangement]:
    """Rows of seats that are told to have something of their own on a wall and have no arrangement yet."""
    set_out = {a.entity for a in brief.arrangements}
    for said, seats, _ in _stations(brief, wanted):
        if said.subject not in set_out:
            width = seats[0].asset.size[1]
            pitch = width + (ROOM if width > NARROW else width)
            yield Arrangement(id=said.id, entity=said.subject, pattern="row", rows=1, pitch=pitch, at_least=True)


def of_their_own(
    brief: SceneGraph, wanted: Sequence[Wanted], patterns: Sequence[tuple[str, Sequence[Wanted]]]
) -> Iterator[Grounded]:
    """The place of what each seat of a row has for its own on the wall: in the middle before it.

    Args:
        brief: the request.
        wanted: the objects to be.
        patterns: the rows, each as the entity and its things.
    """
    rows = {entity: seats for entity, seats in patterns}
    for said, _, hung in _stations(brief, wanted):
        for seat, one in zip(rows.get(said.subject, ()), hung, strict=False):
            ahead = (seat.asset.size[0] + one.asset.size[0]) / 2 + REACH
            at = {"ahead": round(ahead, 4), "left": 0.0, "turn": 180.0, "offset": WITHIN, "degrees": 2.0}
            yield Grounded(said.id, "arranged", one.id, seat.id, at)


def _stations(
    brief: SceneGraph, wanted: Sequence[Wanted]
) -> Iterator[tuple[StatedRelation, list[Wanted], list[Wanted]]]:
    """The statements that give each seat something on a wall, with the seats and those things."""
    for said in brief.relations:
        if not own_on_wall(said, brief):
            continue
        seats = [w for w in wanted if w.asked == said.subject and w.mount == "floor" and w.support is None]
        hung = [w for w in wanted if w.asked == said.targets[0] and w.mount == "wall"]
        if len(seats) > 1 and len(seats) == len(hung):
            yield said, seats, hung


__all__ = ["of_their_own", "rows_before_walls"]
