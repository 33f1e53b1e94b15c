"""Seats around their tables as relations, at even places, and tables long enough for the seats that are told of."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from sceneweaver.assets import Library
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge.capacity import number
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import CATALOGUE, InputError, Relation

from .program import Program, Wanted

ELBOW = 0.08
"""Length [m] of table edge that a seat takes beside its own width."""

EDGE = 0.6
"""Least length [m] of table edge for each of those who sit beside each other."""

SQUARE = 1.12
"""Tables whose length is less than so many times their depth, and which are round by name, are sat around."""

TUCKED = 0.2
"""How much [m] narrower than the table the ring is on which the fronts of pulled-up seats stand."""

_SIDES = {"front_to_front": "front", "in_front_of": "front", "behind": "back"}
"""Sides of a table by the relation of a seat to it."""

EDGES = 8
"""Edges of the collision part of a round table. Seats are pulled up to these, to every other one if that is enough."""


def seat_relations(wanted: Sequence[Wanted]) -> Iterator[Relation]:
    """The places of all seats that share a table, soft: where one is taken the seat may be anywhere at its table."""
    for table, seats in _tables(wanted).values():
        if len(seats) < 2 and not (table.item and table.item.row == "grid"):
            continue
        if _is_round(table) and len(seats) not in (2, 4):
            for seat in seats:
                yield Relation(type="around", subject=seat.id, target=table.id, hard=False, weight=0.5)
            continue
        for seat, side, k, n in _places(table, seats):
            params = {"side": side, "k": k, "n": n}
            yield Relation(type="seated_at", subject=seat.id, target=table.id, params=params, hard=False)


def seat_sides(table: Wanted, wanted: Sequence[Wanted]) -> dict[str, float]:
    """The sides of a table where seats have their places, with the depth [m] of the deepest."""
    _, seats = _tables(wanted).get(table.id, (table, []))
    sides: dict[str, float] = {}
    for seat, side, _, _ in _places(table, seats) if seats else ():
        sides[side] = max(sides.get(side, 0.0), seat.asset.size[0])
    return sides


def _tables(wanted: Sequence[Wanted]) -> dict[str, tuple[Wanted, list[Wanted]]]:
    """Tables with the seats that go with them, by id."""
    tables: dict[str, tuple[Wanted, list[Wanted]]] = {}
    for one in wanted:
        if one.parent is not None and one.mount == "floor" and _seated(one):
            tables.setdefault(one.parent.id, (one.parent, []))[1].append(one)
    return tables


def _seated(seat: Wanted) -> bool:
    """Whether a thing is pulled up to the table that it goes with."""
    with_ = seat.item.with_ if seat.item else None
    return any(p.type in CATALOGUE.with_role("seat") and p.to == with_ for p in _item_places(seat))


def _item_places(one: Wanted):
    return one.item.place if one.item else ()


def _places(table: Wanted, seats: Sequence[Wanted]) -> Iterator[tuple[Wanted, str, int, int]]:
    """Each seat with its side of the table, its place there and the number of places: the long sides in turn, the
    ends when those are full. What belongs to a side shares that side, and nothing else sits between table and wall."""
    own = {s.id: side for s in seats if (side := own_side(s)) is not None}
    others = [s for s in seats if s.id not in own]
    d, w, _ = table.asset.size
    wide = max(s.asset.size[1] for s in seats) + ELBOW
    at_wall = table.wall > 0.0
    sides, ends = (("front", "back"), ("left", "right")) if w >= d else (("left", "right"), ("front", "back"))
    if "round" in table.category:
        wide = max(d, w)
    free = {s: max(1, int(max(d, w) / wide)) for s in sides} | {s: max(1, int(min(d, w) / wide)) for s in ends}
    free |= dict.fromkeys(own.values(), 0)
    if at_wall:
        free["back"] = 0
    shared: dict[str, list[Wanted]] = {side: [] for side in (*sides, *ends)}
    for seat in seats:
        if seat.id in own:
            shared[own[seat.id]].append(seat)
    for group in (sides, ends):
        while others and any(len(shared[s]) < free[s] for s in group):
            side = min((s for s in group if len(shared[s]) < free[s]), key=lambda s: len(shared[s]))
            shared[side].append(others.pop(0))
    for side, row in shared.items():
        for k, seat in enumerate(row):
            yield seat, side, k, len(row)


def own_side(seat: Wanted) -> str | None:
    """The side of its table that a seat's kind of room gives it: a clerk's chair stands behind the counter."""
    with_ = seat.item.with_ if seat.item else None
    return next((_SIDES[p.type] for p in _item_places(seat) if p.type in _SIDES and p.to == with_), None)


def lengthened(program: Program, rows: Sequence[Grounded], library: Library, brief: SceneGraph) -> bool:
    """Exchange tables that are too short for the seats at them for longer ones; whether any was.

    Those whose size the request gives stay as they are.
    """
    sized = {entity.id for entity in brief.entities if any(entity.size)}
    changed = False
    for table in program.wanted:
        if table.wish is None or table.asked in sized or not table.thing.is_table:
            continue
        depth, width, _ = table.asset.size
        length = _needed(table, program, rows)
        if length <= max(depth, width):
            continue
        size = _longer(table, length)
        if size is None:
            continue
        try:
            wish = replace(table.wish, size=(*size, table.wish.size[2]), beyond=True)
            table.asset = library.choose(table.category, 1, wish)[0]
        except InputError:
            continue
        changed = True
    return changed


def _needed(table: Wanted, program: Program, rows: Sequence[Grounded]) -> float:
    """Length of a table, or diameter of a round one [m], that its seats need; 0 where there are none."""
    seats = {one.id: one for one in program.wanted if one.thing.is_seat}
    own = [row for row in rows if row.target == table.id and row.subject in seats]
    wide = max((seats[row.subject].asset.size[1] for row in own), default=0.0)
    ring = len({row.subject for row in own if row.type == "around"})
    along = max((row.params["n"] for row in own if row.type == "seated_at"), default=0)
    if not own:
        _, around = _tables(program.wanted).get(table.id, (table, []))
        if not around or len(list(_places(table, around))) == len(around):
            return 0.0  # all have their places
        wide, ring = max(s.asset.size[1] for s in around), len(around)
        along = ring if table.wall > 0.0 else 0
    if ring > 2 and _is_round(table):
        edges = EDGES if ring > EDGES // 2 else EDGES // 2
        tucked = math.ceil(ring / edges) * wide / math.tan(math.pi / edges) + TUCKED
        return max(tucked, ring * number("ring") / math.pi + 0.01)
    if ring > 2:
        along = max(along, math.ceil((ring - 2) / 2))
    return along * max(EDGE, wide + ELBOW) if along else 0.0


def _is_round(table: Wanted) -> bool:
    depth, width, _ = table.asset.size
    return "round" in table.category and max(depth, width) < SQUARE * min(depth, width)


def _longer(table: Wanted, length: float) -> tuple[float, float] | None:
    """Depth and width [m] of a table of some length, as far as such tables go; None where it is that long already."""
    known = category_named(table.category).size
    if known is None:
        return None
    depth, width, _ = table.asset.size
    at = 1 if width >= depth else 0
    most = known.built[at][1]
    if _is_round(table):
        most = min(most, known.reach[0][1], known.reach[1][1])
    length = round(min(length, most), 3)
    if length <= max(depth, width) + 1e-3:
        return None
    return (length, length) if _is_round(table) else (depth, length) if at else (length, width)
