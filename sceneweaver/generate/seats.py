"""Seats around their tables as relations: as many on one side as on the other, at even places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sceneweaver.scene import CATALOGUE, Relation

from .program import Wanted

ELBOW = 0.08
"""Length [m] of table edge that a seat takes beside its own width."""

SQUARE = 1.12
"""Tables whose length is less than so many times their depth, and which are round by name, are sat around."""


def seat_relations(wanted: Sequence[Wanted]) -> Iterator[Relation]:
    """The places of all seats that share a table, soft: where one is taken the seat may be anywhere at its table."""
    for table, seats in _tables(wanted).values():
        if len(seats) < 2 and not (table.item and table.item.row == "grid"):
            continue
        d, w, _ = table.asset.size
        round_ = "round" in table.category and max(d, w) < SQUARE * min(d, w)
        if round_ and len(seats) not in (2, 4):
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
    ends when those are full. What belongs to the front shares the front, and nothing sits between table and wall."""
    front = [s for s in seats if any(p.type == "front_to_front" for p in _item_places(s))]
    others = [s for s in seats if s not in front]
    d, w, _ = table.asset.size
    wide = max(s.asset.size[1] for s in seats) + ELBOW
    at_wall = table.wall > 0.0
    sides, ends = (("front", "back"), ("left", "right")) if w >= d else (("left", "right"), ("front", "back"))
    if "round" in table.category:
        wide = max(d, w)
    free = {s: max(1, int(max(d, w) / wide)) for s in sides} | {s: max(1, int(min(d, w) / wide)) for s in ends}
    if front:
        free["front"] = 0
    if at_wall:
        free["back"] = 0
    shared: dict[str, list[Wanted]] = {side: [] for side in (*sides, *ends)}
    shared["front"] += front
    for group in (sides, ends):
        while others and any(len(shared[s]) < free[s] for s in group):
            side = min((s for s in group if len(shared[s]) < free[s]), key=lambda s: len(shared[s]))
            shared[side].append(others.pop(0))
    for side, row in shared.items():
        for k, seat in enumerate(row):
            yield seat, side, k, len(row)
