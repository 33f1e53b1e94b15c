"""Seats at the tables of a request, and tables as long as those need who sit at them."""

from __future__ import annotations

import math

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.capacity import edge_places, long_enough
from sceneweaver.knowledge.kin import kin
from sceneweaver.language import Entity
from sceneweaver.language.model import Capacity, RelationType
from sceneweaver.language.vocabulary import family

from .people_draft import CHILDREN, PeopleDraft, is_vague, told

USUAL_SEATS = {"kids": "kids_chair", "desk": "office_chair", "bar": "bar_stool", "work": "stool"}
"""Seats at tables that a kind of room has none for, by a part of the table's name; chairs else."""

FOR_TWO = "cafe_table"
SIZE_FOR_TWO = (0.7, 0.75, None)
"""What a plain table for two is, and its depth and width [m]."""

EDGE, SPARE = 0.6, 0.2
"""Length [m] of table edge for each of those who sit beside each other, and what a table has beyond that."""

BESIDE, ABOUT = 2, 4
"""People at each of several tables in a row, and at each that stands by itself."""


def seats_at(draft: PeopleDraft, said: Capacity, table: Entity) -> None:
    """Seats for so many at a table, or at each of several."""
    if is_vague(table) and not said.each:
        in_line = any(a.entity == table.id for a in draft.brief.arrangements)
        tables = max(2, math.ceil(said.people / (BESIDE if in_line else ABOUT)))
        draft.change(table, count=(tables, tables))
        table = draft.now(table.id)
    tables = table.count[0] if table.count else 1
    people = said.people * (tables if said.each else 1)
    table = of_their_size(draft, table, math.ceil(people / tables))
    named = seats_named(draft, table)
    if named is not None:
        if is_vague(named):
            count = people
            if named.category == "bench":
                known = category_named("bench").size
                assert known is not None
                side = long_enough(math.ceil(said.people / (2 if said.people > 2 else 1)))
                parts = math.ceil(side / known.reach[1][1])  # long sides have several benches
                count = tables * parts * (2 if said.people > 2 else 1)
                width = max(round(side / parts, 3), known.width[0])
                draft.change(named, size=(named.size[0], width, named.size[2]), count=(count, count))
                told(draft, named, table, "along", math.ceil(count / tables), tables > 1)
                return
            draft.change(named, count=(count, count))
            told(draft, named, table, place_at(draft, table, said), math.ceil(count / tables), tables > 1)
        return
    each = said.people if said.each else math.ceil(people / tables)
    seat = draft.add(seat_for(draft.room, table), each * tables)  # sets of one size, with a seat or two to spare
    if seat is not None:
        told(draft, seat, table, place_at(draft, table, said), each, tables > 1)


def of_their_size(draft: PeopleDraft, table: Entity, people: int) -> Entity:
    """A plain table as long as so many need, and a small one for two; what the request says of its size stays."""
    known = category_named(table.category).size
    if has_role(table.category, "coffee_table") and CHILDREN & set(draft.brief.for_whom):
        draft.change(table, category="kids_table")  # children eat and paint at it
        return draft.now(table.id)
    plain = table.category == "dining_table" and table.noun.rstrip("s").split()[-1:] == ["table"]
    if not plain or known is None or any(table.size) or table.scale < 1.0:
        return table
    if any(a.entity == table.id for a in draft.brief.arrangements):  # they sit beside each other at each of a row
        _lengthened(draft, table, people * EDGE + SPARE / 2)
    elif people <= 2 and table.style is None and table.scale == 1.0:
        draft.change(table, category=FOR_TWO, size=SIZE_FOR_TWO)
    elif people > 2:
        side = max(1, math.ceil((people - 2) / 2)) if people > 4 else 2
        _lengthened(draft, table, side * EDGE + SPARE)
    return draft.now(table.id)


def _lengthened(draft: PeopleDraft, table: Entity, length: float) -> None:
    """A table of a length [m], as far as such tables are built; one that is said to be large is no shorter for it."""
    known = category_named(table.category).size
    assert known is not None
    large = table.scale > 1.0
    if large and length <= known.width[1]:
        return  # as large as the words make it
    least, most = known.built[1]
    draft.change(table, size=(None, round(min(max(length, least), most), 3), None))


def place_at(draft: PeopleDraft, table: Entity, said: Capacity) -> RelationType:
    """Where seats are at a table: around one to eat at, along the long sides of a bench, at a desk."""
    if table.category.endswith("bench"):
        return "along"
    in_line = any(a.entity == table.id and a.pattern != "cluster" for a in draft.brief.arrangements)
    return "at" if said.activity == "work" or in_line else "around"


def seats_named(draft: PeopleDraft, table: Entity) -> Entity | None:
    """The seats that the request names for a table: told to be at it, or told nothing else."""
    seats = [e for e in draft.entities if family(e.category) == "seat" and e.id != table.id]
    at = {r.subject for r in draft.relations if table.id in r.targets}
    placed = {r.subject for r in draft.relations if r.targets and table.id not in r.targets and not r.implied}
    placed |= {e.id for e in seats if e.implied and e.id not in at}  # those that another table was given
    upright = [e for e in seats if has_role(e.category, "sits_at_table") and e.category != "wheelchair"]
    placed |= {e.id for e in upright if has_role(e.category, "lounge_seat") and not is_vague(e)}  # one to read in
    return next((e for e in upright if e.id in at), None) or next((e for e in upright if e.id not in placed), None)


def seat_for(room: RoomType, table: Entity) -> str:
    """The kind of seat that is usual at a table in a kind of room; a child's table has children's."""
    if "kids" in table.category:
        return USUAL_SEATS["kids"]
    for item in room.items:
        host = room.item(item.with_) if item.with_ else None
        if host is not None and family(item.what[0]) == "seat" and kin(table.category) & set(host.what):
            return item.what[0]
    return next((seat for part, seat in USUAL_SEATS.items() if part in table.category), "dining_chair")


def seats_more(draft: PeopleDraft, said: Capacity, table: Entity, people: int) -> None:
    """Seats at a table, or in equal parts at several, for those of whom the request names no seats: two of eight
    potters work at the table."""
    tables = table.count[0] if table.count else 1
    each = math.ceil(people / tables)
    seat = draft.add(seat_for(draft.room, table), each * tables)
    if seat is not None:
        told(draft, seat, table, place_at(draft, table, said), each, tables > 1)


def tables_of_seats(draft: PeopleDraft) -> None:
    """Tables of which no number is said, and counted seats of which nothing is: as many tables as those fill."""
    tables = [e for e in draft.entities if has_role(e.category, "dining_table")]
    at = {t for r in draft.relations if family_of(draft, r.subject) == "seat" for t in r.targets}
    free = [e for e in tables if is_vague(e) and e.id not in at]
    placed = {r.subject for r in draft.relations if r.targets} | {a.entity for a in draft.brief.arrangements}
    seats = [e for e in draft.entities if has_role(e.category, "table_seat") and e.id not in placed]
    seats = [e for e in seats if e.count and e.count[0] == e.count[1] > 2]
    if len(free) != 1 or len(tables) != 1 or len(seats) != 1 or seats[0].count is None:
        return
    (table,), (seat,), people = free, seats, seats[0].count[0]
    each = BESIDE if people <= 2 * ABOUT or table.category == FOR_TWO or table.scale < 1.0 else ABOUT
    count = max(2, math.ceil(people / each))
    draft.change(table, count=(count, count))
    of_their_size(draft, draft.now(table.id), each)
    told(draft, seat, table, "around", each, True)


def family_of(draft: PeopleDraft, name: str) -> str:
    """The family of an entity; empty where there is no such thing."""
    return next((family(e.category) or "" for e in draft.entities if e.id == name), "")


def can_seat(table: Entity, people: int) -> bool:
    """Whether such tables are built for so many: a dozen chairs do not belong to a child's table."""
    known = category_named(table.category).size
    if known is None:
        return False
    depth, width = (table.size[k] or known.built[k][1] for k in range(2))
    return edge_places(depth, width, round_="round" in table.category) >= people
