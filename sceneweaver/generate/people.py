"""Numbers of people as things: seats at a table for ten, beds where eight sleep, desks for a class of 24.

What follows is added to the request as things that it implies, or as counts of what it names without a number, so that
it goes before what such a room usually has.
"""

from __future__ import annotations

import math

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge import RoomType
from sceneweaver.language import Entity, SceneGraph, StatedRelation
from sceneweaver.language.model import Arrangement, Capacity
from sceneweaver.language.vocabulary import family

from .meant import matches
from .people_beds import beds, one_each
from .people_draft import PeopleDraft, is_vague, told
from .people_seats import is_worked_at, long_seat, only_long_seat, seats
from .people_tables import can_seat, of_their_size, seats_at, seats_named, tables_of_seats
from .people_windows import bars_at_windows
from .stacks import rows_for

LOW = {"dining_table": "coffee_table", "round_dining_table": "round_coffee_table"}
"""What a plain table is that has armchairs around it."""

LOW_SET = ("playroom", "kindergarten", "childrens_room", "nursery", "nursery_school", "tea_house")
"""Kinds of rooms where people sit at low tables on chairs or cushions."""

COVERED = 0.85
"""Share of a wall that things cover which are said to be a whole wall of it."""

STACKS = 3
"""Stacks that there are where the request says how high they are and not how many."""


def with_people(brief: SceneGraph, room_type: RoomType) -> SceneGraph:
    """A request with the places that its people need."""
    draft = PeopleDraft(brief, room_type, list(brief.entities), list(brief.relations))
    _lounge_tables(draft)
    _work_benches(draft)
    named = {one.target for one in brief.capacities if one.target}
    for one in brief.capacities:
        target = next((e for e in draft.entities if e.id == one.target), None)
        if one.own:
            _set_out(draft, one)
        if one.own or not one.people:
            continue
        bench = only_long_seat(draft) if target is None and not named else None
        table = _only_table(draft) if target is None and not named and one.activity == "use" else None
        if one.activity == "sleep":
            beds(draft, one, target)
        elif table is not None:
            seats_at(draft, one, table)
        elif bench is not None:
            long_seat(draft, one, bench)
        elif target is not None and family(target.category) == "seat" and not is_worked_at(draft, target):
            long_seat(draft, one, target)
        elif target is not None:
            seats_at(draft, one, target)
        elif not named and one.activity != "use":
            seats(draft, one)
    _seats_of_the_table(draft)
    tables_of_seats(draft)
    bars_at_windows(draft)
    one_each(draft)
    for said in brief.arrangements:
        _stacks(draft, said)
        _full_wall(draft, said)
    return brief.model_copy(update={"entities": tuple(draft.entities), "relations": tuple(draft.relations)})


def _lounge_tables(draft: PeopleDraft) -> None:
    """A plain table that armchairs are around, or that is between them, is a low one."""
    lounge = {e.id for e in draft.entities if has_role(e.category, "lounge_seat")}
    low = {r.targets[0] for r in draft.relations if r.type == "around" and r.subject in lounge and r.targets}
    low |= {r.subject for r in draft.relations if r.type == "between" and r.targets and lounge.issuperset(r.targets)}
    low |= {a.entity for a in draft.brief.arrangements if a.pattern == "between" and a.around in lounge}
    for entity in [e for e in draft.entities if e.id in low and e.category in LOW and "dining" not in e.noun]:
        category = LOW[entity.category]
        draft.change(entity, category=category, noun=category.replace("_", " "))


def _work_benches(draft: PeopleDraft) -> None:
    """A bench that people sit at, on seats of their own, is one to work at."""
    for said in draft.brief.capacities:
        bench = next((e for e in draft.entities if e.id == said.target and e.category == "bench"), None)
        if bench is None or seats_named(draft, bench) is None:
            continue
        known = (c for item in draft.room.items for c in item.what if c.endswith("bench") and family(c) != "seat")
        draft.change(bench, category=next(known, "workbench"))


def _seats_of_the_table(draft: PeopleDraft) -> None:
    """Chairs of which nothing is said, and the only table to sit at, of which nothing else is: they belong together."""
    tables = [e for e in draft.entities if has_role(e.category, "dining_table", "coffee_table")]
    low = bool(tables) and has_role(tables[0].category, "coffee_table")
    set_out = {a.entity for a in draft.brief.arrangements} | {r.subject for r in draft.relations if r.targets}
    seats = [e for e in draft.entities if has_role(e.category, "table_seat") and e.id not in set_out]
    seats = [e for e in seats if e.count and e.count[0] == e.count[1] > 1]
    alone = len(tables) == len(seats) == 1 and (tables[0].count or (1, 1))[1] == 1
    if not alone or (low and draft.room.name not in LOW_SET):
        return
    count = seats[0].count[0] if seats[0].count else 1
    if not low and (not can_seat(tables[0], count) or _stand_by_themselves(draft, seats[0])):
        return
    told(draft, seats[0], tables[0], "around", count, False)
    if not low:
        of_their_size(draft, draft.now(tables[0].id), count)


def _stand_by_themselves(draft: PeopleDraft, seats: Entity) -> bool:
    """Whether such a room has such seats at no table: those of a waiting room are not around its magazines."""
    own = [item for item in draft.room.items if matches(seats.category, item)]
    return bool(own) and all(item.with_ is None for item in own)


def _stacks(draft: PeopleDraft, said: Arrangement) -> None:
    """As many things as stacks of that height take, where the request does not say how many."""
    entity = next((e for e in draft.entities if e.id == said.entity), None)
    if said.pattern != "stack" or entity is None or not (said.height or said.groups) or not is_vague(entity):
        return
    rows = rows_for(said, entity.category, entity.count[1] if entity.count else 2)
    count = rows * (said.groups or STACKS)
    draft.change(entity, count=(count, count))


def _full_wall(draft: PeopleDraft, said: Arrangement) -> None:
    """As many things as cover most of a wall of the floor that is asked for, or of a usual one."""
    entity = next((e for e in draft.entities if e.id == said.entity), None)
    size = category_named(entity.category).size if entity is not None else None
    if said.pattern != "wall" or entity is None or size is None or not is_vague(entity):
        return
    brief = draft.brief
    area = brief.area or draft.room.area[1]
    wall = max(brief.size) if brief.size is not None else math.sqrt(1.2 * area)
    width = entity.size[1] or (size.width[0] + size.width[1]) / 2
    count = max(2, int(COVERED * wall / width))
    draft.change(entity, count=(count, count))


def _set_out(draft: PeopleDraft, said: Capacity) -> None:
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


def _only_table(draft: PeopleDraft) -> Entity | None:
    """The table of a request that names one to sit at, and neither beds nor other seats: all sit there."""
    tables = [e for e in draft.entities if has_role(e.category, "dining_table")]
    other = any(has_role(e.category, "any_bed", "lounge_seat") for e in draft.entities)
    return tables[0] if len(tables) == 1 and not other else None


__all__ = ["with_people"]
