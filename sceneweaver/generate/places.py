"""A place at its table for every seat that a request has there: a side of the table, and which part of that side.

A relation such as "around" or "at" says that seats are at a table, and a search that moves them one by one ends with
some of them elsewhere. Here each gets the middle of its part of a side that is free.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from sceneweaver.assets.roles import has_role
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.language.model import Arrangement, StatedRelation
from sceneweaver.scene import CATALOGUE

from .focus import faced_from
from .program import Wanted
from .seats import ELBOW, own_side

SEATED = ("around", "along", "at")
"""Stated relations of seats to what they are at."""

BESIDE = ("near", "next_to", "in_front_of", "facing")
"""Relations that mean the same of a seat where they only follow from "with", or hold of each of several."""

END = 0.7
"""Length [m] of an end of a table that somebody sits at."""

_OTHERS = ("back", "left", "right")
"""Sides of a table at which nobody of one row sits."""

RING = 4
"""Seats at a round table from which on they are evenly around it, at no sides."""

PAIR = 1.15
"""Length [m] up to which a table for two is sat at from its ends, where it stands at a wall."""

TOLD = CATALOGUE.with_role("placing", "turning", "seat") | {"distance"}
"""Types of relations that a seat with its place at a table has no more to that table."""


def seats_at_tables(rows: Sequence[Grounded], brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What is stated, with a place at its table for every seat that is told to be at one.

    Args:
        rows: what the request states.
        brief: the request.
        wanted: the objects to be.
    """
    kept, lined = list(rows), lined_at(brief, wanted)
    for table, seats in _sets(rows, brief, wanted, lined):
        ids = {seat.id: said for seat, said in seats}
        kept = [r for r in kept if not (r.subject in ids and r.target == table.id and r.type in TOLD)]
        closed = _closed(table, rows, brief)
        if faced_from(table, brief):  # all look the same way, across their tables
            closed = frozenset(("front", "left", "right"))
        if any(seat.asked in lined for seat, _ in seats):
            closed = frozenset(_OTHERS)
        placed = list(shared_out(table, [seat for seat, _ in seats], closed))
        kept += [
            Grounded(ids[seat.id], "seated_at", seat.id, table.id, {"side": side, "k": k, "n": n})
            for seat, side, k, n in placed
        ]
        kept += [
            Grounded(ids[seat.id], "front_against", seat.id, table.id, hard=False)
            for seat, side, _, _ in placed
            if kept_clear(table, side)
        ]
    return kept


def kept_clear(table: Wanted, side: str) -> bool:
    """Whether a side of a table is kept clear, for others than its seats: the front of a bar, where guests stand."""
    return any(zone.name == side and zone.hard for zone in table.asset.zones)


def lined_at(brief: SceneGraph, wanted: Sequence[Wanted]) -> frozenset[str]:
    """The entities of seats in one row that are told to be at one table or counter: the row is along its front."""
    rows = {a.entity for a in brief.arrangements if a.pattern == "row" and not a.facing and a.spacing is None}
    found = set[str]()
    for said in brief.relations:
        if said.subject not in rows or len(said.targets) != 1:
            continue
        seats = [one for one in wanted if one.asked == said.subject]
        tables = [one for one in wanted if one.asked == said.targets[0]]
        if len(tables) == 1 and len(seats) > 1 and all(_means_at(said, seat, tables[0]) for seat in seats):
            found.add(said.subject)
    return frozenset(found)


def _sets(
    rows: Sequence[Grounded], brief: SceneGraph, wanted: Sequence[Wanted], lined: Collection[str]
) -> Iterator[tuple[Wanted, list[tuple[Wanted, str]]]]:
    """Tables with the seats that are told to be at them, each seat with the statement behind it."""
    things = {one.id: one for one in wanted}
    told = {said.id or f"relation-{k}": said for k, said in enumerate(brief.relations)}
    set_out = {a.entity for a in brief.arrangements}
    found: dict[str, dict[str, str]] = {}
    for row in rows:
        seat, table = things.get(row.subject), things.get(row.target) if isinstance(row.target, str) else None
        said = told.get(row.said)
        if seat is None or table is None or said is None or not _means_at(said, seat, table):
            continue
        if (seat.asked in set_out and seat.asked not in lined) or any(row.subject in seats for seats in found.values()):
            continue
        found.setdefault(table.id, {})[seat.id] = row.said
    for name, seats in found.items():
        table = things[name]
        if not ("round" in table.category and len(seats) > RING):
            yield table, [(things[seat], said) for seat, said in seats.items()]


def _means_at(said: StatedRelation, seat: Wanted, table: Wanted) -> bool:
    """Whether a statement has a seat at a table."""
    if said.side is not None or seat.mount != "floor" or not has_role(seat.category, "upright_seat"):
        return False
    if table.mount != "floor" or not table.thing.is_table or not has_role(table.category, "seated_at"):
        return False
    return means_at(said)


def means_at(said: StatedRelation) -> bool:
    """Whether a statement of a seat and a table means that it is at it."""
    return said.type in SEATED or (said.type in BESIDE and said.implied)


def _closed(table: Wanted, rows: Sequence[Grounded], brief: SceneGraph) -> frozenset[str]:
    """The sides of a table at which nobody sits: that at a wall or a window, of a U all but the outer one, and of
    tables that look at a board all but the one from which people see it."""
    if any(a.entity == table.asked and (a.pattern == "u" or _looks_ahead(a, brief)) for a in brief.arrangements):
        return frozenset(("front", "left", "right"))
    edges = CATALOGUE.with_role("edge")
    stated = any(r.subject == table.id and r.type in edges and r.type != "in_corner" for r in rows)
    return frozenset(("back",) if stated or table.wall > 0.0 else ())


def _looks_ahead(said: Arrangement, brief: SceneGraph) -> bool:
    """Whether rows look at one thing, such as a board, so that all sit on the far side of their tables."""
    told = {r.subject for r in brief.relations if r.type == "facing" and not r.implied and r.targets}
    return said.pattern in ("row", "rows", "grid") and (
        said.facing not in ("", "each other") or (said.entity in told and not said.facing)
    )


def shared_out(
    table: Wanted, seats: Sequence[Wanted], closed: Collection[str] = ()
) -> Iterator[tuple[Wanted, str, int, int]]:
    """Each seat with its side of a table, its place there and the number of places; none at one that is closed.

    Guests sit before a counter and who works at a desk before its front. Seats are on both long sides of a table, at
    the ends where the sides are full and the ends wide enough; what has no place even so makes the table longer.
    """
    own = {seat.id: side for seat in seats if (side := own_side(seat)) is not None}
    others = [seat for seat in seats if seat.id not in own]
    counts = _counts(table, seats, len(others), {*closed, *own.values()})
    sides: dict[str, list[Wanted]] = {}
    for seat in seats:
        if seat.id in own:
            sides.setdefault(own[seat.id], []).append(seat)
    left = iter(others)
    for side, count in counts.items():
        sides.setdefault(side, []).extend(seat for _, seat in zip(range(count), left, strict=False))
    for side, row in sides.items():
        for k, seat in enumerate(row):
            yield seat, side, k, len(row)


def _counts(table: Wanted, seats: Sequence[Wanted], count: int, closed: Collection[str]) -> Mapping[str, int]:
    """How many of some seats are at each side of a table."""
    if not count:
        return {}
    d, w, _ = table.asset.size
    wide = max(seat.asset.size[1] for seat in seats) + ELBOW
    if has_role(table.category, "staffed", "desk", "from_front"):
        return {"front": count}
    long, ends = (("front", "back"), ("left", "right")) if w >= d else (("left", "right"), ("front", "back"))
    long, ends = (tuple(side for side in group if side not in closed) for group in (long, ends))
    long, ends = (long, ends) if long else (ends, ())
    if "back" in closed and count == 2 and len(ends) == 2 and max(d, w) <= PAIR:
        return dict.fromkeys(ends, 1)
    room = max(1, int(max(d, w) / wide + 1e-6))
    found = dict.fromkeys((*long, *ends), 0)
    first = min(count, room * len(long))
    rest = count - first
    if min(d, w) >= END:
        for side in ends[: min(rest, len(ends))]:
            found[side] = 1
        rest -= min(rest, len(ends))
    first += rest
    for k, side in enumerate(long):
        found[side] = (first + len(long) - 1 - k) // len(long)
    return {side: number for side, number in found.items() if number}


__all__ = ["SEATED", "kept_clear", "lined_at", "means_at", "seats_at_tables", "shared_out"]
