"""Numbers of people as things: seats at a table for ten, beds where eight sleep, desks for a class of 24.

What follows is added to the request as things that it implies, or as counts of what it names without a number, so that
it goes before what such a room usually has.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.capacity import long_enough, seat_places, sleeping_places
from sceneweaver.knowledge.kin import excluded_kinds, kin
from sceneweaver.language import Entity, SceneGraph, StatedRelation
from sceneweaver.language.model import Arrangement, Capacity, RelationType
from sceneweaver.language.vocabulary import family

from .program import matches
from .stacks import rows_for

USUAL_SEATS = {"desk": "office_chair", "bar": "bar_stool", "work": "stool"}
"""Seats at tables that a kind of room has none for, by a part of the table's name; chairs else."""

LOW = {"dining_table": "coffee_table", "round_dining_table": "round_coffee_table"}
"""What a plain table is that has armchairs around it."""

ARMS = 0.4
"""Width [m] of both arms of a sofa."""

FOR_TWO = "cafe_table"
SIZE_FOR_TWO = (0.7, 0.75, None)
"""What a plain table for two is, and its depth and width [m]."""

EDGE, SPARE = 0.6, 0.2
"""Length [m] of table edge for each of those who sit beside each other, and what a table has beyond that."""

COVERED = 0.85
"""Share of a wall that things cover which are said to be a whole wall of it."""

STACKS = 3
"""Stacks that there are where the request says how high they are and not how many."""

CHILDREN = frozenset(("child", "children", "kid", "kids", "boys", "girls", "boy", "girl", "toddlers", "twins"))


@dataclass
class _Draft:
    """The things and relations of a request as they grow."""

    brief: SceneGraph
    room: RoomType
    entities: list[Entity]
    relations: list[StatedRelation] = field(default_factory=list[StatedRelation])

    def change(self, entity: Entity, **changed: object) -> None:
        """Something that the request names, with what follows of it."""
        at = next(k for k, one in enumerate(self.entities) if one.id == entity.id)
        self.entities[at] = entity.model_copy(update=changed)

    def now(self, name: str) -> Entity:
        """A thing as it has become."""
        return next(one for one in self.entities if one.id == name)

    def add(self, category: str, count: int) -> Entity | None:
        """A thing that the request implies; None where it wants no such thing."""
        if category in excluded_kinds(self.brief.without):
            return None
        taken = {one.id for one in self.entities}
        name = next(n for n in (category, *(f"{category}-{k}" for k in range(2, 99))) if n not in taken)
        noun = category.replace("_", " ") + ("s" if count > 1 else "")
        entity = Entity(id=name, noun=noun, category=category, count=(count, count), implied=True)
        self.entities.append(entity)
        return entity


def with_people(brief: SceneGraph, room_type: RoomType) -> SceneGraph:
    """A request with the places that its people need."""
    draft = _Draft(brief, room_type, list(brief.entities), list(brief.relations))
    _lounge_tables(draft)
    _work_benches(draft)
    named = {one.target for one in brief.capacities if one.target}
    for one in brief.capacities:
        target = next((e for e in draft.entities if e.id == one.target), None)
        if one.own:
            _set_out(draft, one)
        if one.own or not one.people:
            continue
        bench = _only_long_seat(draft) if target is None and not named else None
        if one.activity == "sleep":
            _beds(draft, one, target)
        elif bench is not None:
            _long_seat(draft, one, bench)
        elif target is not None and family(target.category) == "seat" and not _is_worked_at(draft, target):
            _long_seat(draft, one, target)
        elif target is not None:
            _seats_at(draft, one, target)
        elif not named and one.activity != "use":
            _seats(draft, one)
    for said in brief.arrangements:
        _stacks(draft, said)
        _full_wall(draft, said)
    return brief.model_copy(update={"entities": tuple(draft.entities), "relations": tuple(draft.relations)})


def _lounge_tables(draft: _Draft) -> None:
    """A plain table that armchairs are around, or that is between them, is a low one."""
    lounge = {e.id for e in draft.entities if has_role(e.category, "lounge_seat")}
    low = {r.targets[0] for r in draft.relations if r.type == "around" and r.subject in lounge and r.targets}
    low |= {r.subject for r in draft.relations if r.type == "between" and r.targets and lounge.issuperset(r.targets)}
    low |= {a.entity for a in draft.brief.arrangements if a.pattern == "between" and a.around in lounge}
    for entity in [e for e in draft.entities if e.id in low and e.category in LOW and "dining" not in e.noun]:
        category = LOW[entity.category]
        draft.change(entity, category=category, noun=category.replace("_", " "))


def _work_benches(draft: _Draft) -> None:
    """A bench that people sit at, on seats of their own, is one to work at."""
    for said in draft.brief.capacities:
        bench = next((e for e in draft.entities if e.id == said.target and e.category == "bench"), None)
        if bench is None or _seats_named(draft, bench) is None:
            continue
        known = (c for item in draft.room.items for c in item.what if c.endswith("bench") and family(c) != "seat")
        draft.change(bench, category=next(known, "workbench"))


def _stacks(draft: _Draft, said: Arrangement) -> None:
    """As many things as stacks of that height take, where the request does not say how many."""
    entity = next((e for e in draft.entities if e.id == said.entity), None)
    if said.pattern != "stack" or entity is None or not (said.height or said.groups) or not _vague(entity):
        return
    rows = rows_for(said, entity.category, entity.count[1] if entity.count else 2)
    count = rows * (said.groups or STACKS)
    draft.change(entity, count=(count, count))


def _full_wall(draft: _Draft, said: Arrangement) -> None:
    """As many things as cover most of a wall of the floor that is asked for, or of a usual one."""
    entity = next((e for e in draft.entities if e.id == said.entity), None)
    size = category_named(entity.category).size if entity is not None else None
    if said.pattern != "wall" or entity is None or size is None or not _vague(entity):
        return
    brief = draft.brief
    area = brief.area or draft.room.area[1]
    wall = max(brief.size) if brief.size is not None else math.sqrt(1.2 * area)
    width = entity.size[1] or (size.width[0] + size.width[1]) / 2
    count = max(2, int(COVERED * wall / width))
    draft.change(entity, count=(count, count))


def _set_out(draft: _Draft, said: Capacity) -> None:
    """Small things of each person's own are on the table that people are at, unless the request says where they are."""
    tables = [e.target for e in draft.brief.capacities if e.target and not e.own]
    names = {e.id for e in draft.entities if has_role(e.category, "pulled_up_to")}
    table = next((name for name in tables if name in names), None)
    if table is None:
        return
    carried = {r.subject for r in draft.relations if r.type in ("on", "inside") and r.targets[:1] != ("wall",)}
    for name, _ in said.own:
        entity = next(e for e in draft.entities if e.id == name)
        if name not in carried and category_named(entity.category).mount[0] == "surface":
            draft.relations = [r for r in draft.relations if r.subject != name]
            kind = f"relation-{len(draft.brief.relations) + len(draft.relations)}"
            draft.relations.append(StatedRelation(id=kind, type="on", subject=name, targets=(table,), implied=True))


def _vague(entity: Entity) -> bool:
    """Whether a request names several without saying how many."""
    return (entity.count is None and entity.noun.endswith("s")) or (
        entity.count is not None and entity.count[0] < entity.count[1]
    )


def _beds(draft: _Draft, said: Capacity, target: Entity | None) -> None:
    """As many beds as so many people sleep in; those that the request counts stay as they are."""
    beds = [target] if target is not None else [e for e in draft.entities if sleeping_places(e.category)]
    if beds:
        if len(beds) == 1 and _vague(beds[0]):
            count = math.ceil(said.people / sleeping_places(beds[0].category))
            draft.change(beds[0], count=(count, count))
        return
    item = next((i for i in draft.room.items if any(map(sleeping_places, i.what))), None)
    if item is None:
        return
    children = bool(CHILDREN & set(draft.brief.for_whom))
    wide = sleeping_places(item.what[0]) > 1
    category = item.what[0]
    if wide and (children or said.people == 1 or said.people > 2):
        category = "single_bed"
    draft.add(category, math.ceil(said.people / max(1, sleeping_places(category))))


def _only_long_seat(draft: _Draft) -> Entity | None:
    """The benches or pews of a request that names no other seats and no table to sit at: all sit there."""
    seats = [e for e in draft.entities if family(e.category) == "seat"]
    at_table = any(has_role(e.category, "pulled_up_to", "any_bed") for e in draft.entities)
    size = category_named(seats[0].category).size if len(seats) == 1 and not at_table else None
    long = size is not None and size.width[1] >= 2 * long_enough(1) and not has_role(seats[0].category, "sofa")
    return seats[0] if long and not _is_worked_at(draft, seats[0]) else None


def _is_worked_at(draft: _Draft, seat: Entity) -> bool:
    """Whether a bench is one to work at: in a room with benches to work at, or one that seats are named for."""
    if seat.category != "bench":
        return False
    names = {name for item in draft.room.items for name in item.what}
    works = any(name.endswith("bench") and family(name) != "seat" for name in names)
    waits = any(has_role(name, "waiting_seat") for name in names)
    return (works and not waits) or _seats_named(draft, seat) is not None


def _long_seat(draft: _Draft, said: Capacity, seat: Entity) -> None:
    """A sofa as long as so many need; seats for one are as many as people."""
    known = category_named(seat.category).size
    if known is None:
        return
    if known.width[1] < 2 * long_enough(1):
        if seat.count is None or _vague(seat):
            draft.change(seat, count=(said.people, said.people))
    elif seat.size[1] is None:
        corner = has_role(seat.category, "sofa") and "sectional" in seat.category
        longest = known.reach[1][1]
        count = 1 if seat.count is None and not _vague(seat) else seat.count[0] if seat.count else 1
        if _vague(seat):  # as many as hold them at a usual length
            usual = (known.width[0] + known.width[1]) / 2
            count = max(2, math.ceil(said.people / max(1, seat_places(usual))))
            draft.change(seat, count=(count, count))
        people = said.people if said.each else math.ceil(said.people / count)
        arms = ARMS if has_role(seat.category, "sofa") else 0.0
        width = min(long_enough(people - (1 if corner else 0)) + arms, longest)
        if width > known.width[0]:
            draft.change(draft.now(seat.id), size=(seat.size[0], round(max(width, known.width[0]), 3), seat.size[2]))


def _seats_at(draft: _Draft, said: Capacity, table: Entity) -> None:
    """Seats for so many at a table, or at each of several."""
    tables = table.count[0] if table.count else 1
    people = said.people * (tables if said.each else 1)
    table = _of_their_size(draft, table, math.ceil(people / tables))
    named = _seats_named(draft, table)
    if named is not None:
        if _vague(named):
            count = people
            if named.category == "bench":
                known = category_named("bench").size
                assert known is not None
                side = long_enough(math.ceil(said.people / (2 if said.people > 2 else 1)))
                parts = math.ceil(side / known.reach[1][1])  # long sides have several benches
                count = tables * parts * (2 if said.people > 2 else 1)
                width = max(round(side / parts, 3), known.width[0])
                draft.change(named, size=(named.size[0], width, named.size[2]), count=(count, count))
                _told(draft, named, table, "along", math.ceil(count / tables), tables > 1)
                return
            draft.change(named, count=(count, count))
            _told(draft, named, table, _place_at(draft, table, said), math.ceil(count / tables), tables > 1)
        return
    seat = draft.add(_seat_for(draft.room, table), people)
    if seat is not None:
        _told(
            draft,
            seat,
            table,
            _place_at(draft, table, said),
            said.people if said.each else math.ceil(people / tables),
            tables > 1,
        )


def _of_their_size(draft: _Draft, table: Entity, people: int) -> Entity:
    """A plain table as long as so many need, and a small one for two; what the request says of its size stays."""
    known = category_named(table.category).size
    plain = table.category == "dining_table" and table.noun.rstrip("s").split()[-1:] == ["table"]
    if not plain or known is None or any(table.size) or table.scale != 1.0:
        return table
    if any(a.entity == table.id for a in draft.brief.arrangements):  # they sit beside each other at each of a row
        length = min(max(people * EDGE + SPARE / 2, known.reach[1][0]), known.reach[1][1])
        draft.change(table, size=(None, round(length, 3), None))
    elif people <= 2 and table.style is None:
        draft.change(table, category=FOR_TWO, size=SIZE_FOR_TWO)
    elif people > 2:
        side = max(1, math.ceil((people - 2) / 2)) if people > 4 else 2
        length = min(max(side * EDGE + SPARE, known.reach[1][0]), known.reach[1][1])
        draft.change(table, size=(None, round(length, 3), None))
    return draft.now(table.id)


def _place_at(draft: _Draft, table: Entity, said: Capacity) -> RelationType:
    """Where seats are at a table: around one to eat at, along the long sides of a bench, at a desk."""
    if table.category.endswith("bench"):
        return "along"
    in_line = any(a.entity == table.id and a.pattern != "cluster" for a in draft.brief.arrangements)
    return "at" if said.activity == "work" or in_line else "around"


def _told(draft: _Draft, seat: Entity, table: Entity, kind: RelationType, count: int, each: bool) -> None:
    """Says that seats are at a table, unless the request says where they are."""
    if any(r.subject == seat.id and table.id in r.targets for r in draft.relations):
        return
    numbers = {"count": (count, count), "each": True} if each else {}
    said = StatedRelation(
        id=f"relation-{len(draft.relations)}", type=kind, subject=seat.id, targets=(table.id,), implied=True, **numbers
    )
    draft.relations.append(said)


def _seats_named(draft: _Draft, table: Entity) -> Entity | None:
    """The seats that the request names for a table: told to be at it, or told nothing else."""
    seats = [e for e in draft.entities if family(e.category) == "seat" and e.id != table.id]
    at = {r.subject for r in draft.relations if table.id in r.targets}
    placed = {r.subject for r in draft.relations if r.targets and table.id not in r.targets and not r.implied}
    placed |= {e.id for e in seats if e.implied and e.id not in at}  # those that another table was given
    upright = [e for e in seats if has_role(e.category, "sits_at_table") and e.category != "wheelchair"]
    return next((e for e in upright if e.id in at), None) or next((e for e in upright if e.id not in placed), None)


def _seat_for(room: RoomType, table: Entity) -> str:
    """The kind of seat that is usual at a table in a kind of room."""
    for item in room.items:
        host = room.item(item.with_) if item.with_ else None
        if host is not None and family(item.what[0]) == "seat" and kin(table.category) & set(host.what):
            return item.what[0]
    return next((seat for part, seat in USUAL_SEATS.items() if part in table.category), "dining_chair")


def _seats(draft: _Draft, said: Capacity) -> None:
    """Seats for the people of a room, with the tables that such a room has for them."""
    tables = [e for e in draft.entities if has_role(e.category, "pulled_up_to")]
    elsewhere = [e for e in draft.entities if e.id in {a.entity for a in draft.brief.arrangements} and e not in tables]
    desks = any("desk" in e.category for e in draft.entities)
    seated = [e for e in draft.entities if family(e.category) == "seat" and e.count and e.count[0] == e.count[1]]
    rest = said.people - sum(e.count[0] for e in seated if e.count)
    if len(tables) == 1 and seated and rest > 0 and not any(_at(draft, e, tables[0]) for e in seated):
        _seats_more(draft, said, tables[0], rest)
        return
    if len(tables) == 1 and (said.activity == "eat" or elsewhere or (said.activity == "work" and not desks)):
        rest = said.people - sum(e.count[0] for e in elsewhere if e.count and family(e.category) != "seat")
        if rest == said.people or _seats_named(draft, tables[0]) is None:
            _seats_at(draft, said.model_copy(update={"people": max(1, rest)}), tables[0])
        else:
            named = _seats_named(draft, tables[0])
            if named is not None and _vague(named):
                draft.change(named, count=(said.people, said.people))
        return
    if elsewhere:
        return
    seats = [e for e in draft.entities if family(e.category) == "seat"]
    pairs = [(i, draft.room.item(i.with_) if i.with_ else None) for i in draft.room.items]
    pairs = [(i, host) for i, host in pairs if family(i.what[0]) == "seat" and i.need != "optional"]
    if not pairs or any(not _vague(e) and (e.count or (1, 1))[1] > 1 for e in seats):
        return
    usual = draft.room.area[1]
    seat, host = max(pairs, key=lambda p: _places(p[0], p[1], usual, said.people))
    own = next((e for e in seats if matches(e.category, seat)), None)
    if host is None:
        width = category_named(seat.what[0]).size
        each = seat_places(width.width[0]) if width is not None and width.width[0] > 1.0 else 1
        _counted(draft, own, seat, math.ceil(said.people / each))
        return
    table = next((e for e in draft.entities if matches(e.category, host) or kin(e.category) & set(host.what)), None)
    if table is not None and not _vague(table):
        _seats_at(draft, said, table)
        return
    if host.count.most == 1 and host.with_ is None:
        _counted(draft, own, seat, said.people)
        return
    each = max(1, seat.count.of(usual, said.people, 0.5))
    _counted(draft, table, host, math.ceil(said.people / each))


def _at(draft: _Draft, seat: Entity, table: Entity) -> bool:
    return any(r.subject == seat.id and table.id in r.targets for r in draft.relations)


def _seats_more(draft: _Draft, said: Capacity, table: Entity, people: int) -> None:
    """Seats at a table for those of whom the request names no seats: two of eight potters work at the table."""
    seat = draft.add(_seat_for(draft.room, table), people)
    if seat is not None:
        _told(draft, seat, table, _place_at(draft, table, said), people, False)


def _counted(draft: _Draft, named: Entity | None, item: Item, count: int) -> None:
    """So many of an item of the room: of what the request names for it without a number, or implied."""
    if named is None:
        draft.add(item.what[0], count)
    elif _vague(named):
        draft.change(named, count=(count, count))


def _places(seat: Item, host: Item | None, area: float, people: int) -> int:
    """The seats that a room usually has of an item."""
    return seat.count.of(area, people, 0.5) * (host.count.of(area, people, 0.5) if host is not None else 1)


__all__ = ["with_people"]
