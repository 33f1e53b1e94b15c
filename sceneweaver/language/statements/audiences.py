"""Seats for an audience: many of them that look at one thing stand in rows before it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..model import PLACES, Arrangement, Capacity, Entity, FreeArea, StatedRelation
from ..vocabulary import family

MANY = 6
"""Seats, or people on benches, from which on those that look at one thing are in rows."""

SHOWN = ("facing", "opposite", "in_front_of")
"""Stated relations of an audience to what it looks at."""

LOUNGE = ("sofa", "armchair", "recliner", "loveseat", "stool")
"""Parts of the names of seats that stand in groups, or at something, rather than in rows."""


def audiences(
    entities: Mapping[str, Entity],
    relations: Sequence[StatedRelation],
    arrangements: Sequence[Arrangement],
    capacities: Sequence[Capacity],
    free: Sequence[FreeArea],
    people: int | None,
) -> tuple[tuple[Arrangement, ...], list[StatedRelation]]:
    """The arrangements with rows of what looks at one thing and has no arrangement yet, and the relations that they do
    not say."""
    set_out = {a.entity for a in arrangements} | {a.around for a in arrangements}
    at_other = {
        r.subject for r in relations if r.type in ("at", "around", "along", "against", "behind", "next_to", "on")
    }
    found, said = list(arrangements), set[str]()
    for row in relations:
        seat = entities.get(row.subject)
        if seat is None or row.type not in SHOWN or len(row.targets) != 1 or row.targets[0] == row.subject or row.each:
            continue
        if row.targets[0].partition(":")[0] in PLACES or seat.id in set_out | at_other:
            continue
        if family(seat.category) != "seat" or any(part in seat.category for part in LOUNGE):
            continue
        if family(entities[row.targets[0]].category) == "seat" or _many(seat, capacities, people) < MANY:
            continue
        aisle = next((area.size[0] for area in free if area.kind == "path" and "aisle" in area.words), None)
        found.append(
            Arrangement(
                id=f"arrangement-{len(found)}",
                entity=seat.id,
                pattern="rows",
                facing=row.targets[0],
                aisle=aisle,
                words=row.words,
                span=row.span,
            )
        )
        set_out.add(seat.id)
        said.add(row.id or row.words)
    return tuple(found), [r for r in relations if (r.id or r.words) not in said or r.subject not in set_out]


def _many(seat: Entity, capacities: Sequence[Capacity], people: int | None) -> int:
    """How many seats there are, or how many people sit on those of which no number is said."""
    if seat.count is not None and seat.count[0] == seat.count[1] > 1:
        return seat.count[0]
    told = max((c.people for c in capacities if c.target == seat.id and not c.own), default=0)
    return (told or people or 0) if seat.count is not None else 0


__all__ = ["audiences"]
