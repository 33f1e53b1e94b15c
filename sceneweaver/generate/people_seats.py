"""Seats for the people of a room, where the request does not say at what they sit."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge import Item
from sceneweaver.knowledge.capacity import long_enough, seat_places
from sceneweaver.knowledge.kin import kin
from sceneweaver.knowledge.likely import likeliest_room
from sceneweaver.language import Entity
from sceneweaver.language.model import Capacity
from sceneweaver.language.vocabulary import family

from .meant import matches
from .people_draft import PeopleDraft, is_vague, sits_at
from .people_tables import seats_at, seats_more, seats_named
from .people_windows import FEW

ARMS = 0.4
"""Width [m] of both arms of a sofa."""

SLACK = 0.1
"""Width [m] by which sofas give more room than their seats' sum: three sit on one of two metres."""

RESTING = ("sit", "wait")
"""What people do on seats without a table."""


def seats(draft: PeopleDraft, said: Capacity) -> None:
    """Seats for the people of a room, with the tables that such a room has for them."""
    tables = [e for e in draft.entities if has_role(e.category, "pulled_up_to")]
    elsewhere = [e for e in draft.entities if e.id in {a.entity for a in draft.brief.arrangements} and e not in tables]
    set_out = list[Entity]()
    if len(tables) > 1:  # those that are set out for many, else the one that is no desk
        set_out = [e for e in tables if any(a.entity == e.id for a in draft.brief.arrangements)]
        tables = set_out or [e for e in tables if has_role(e.category, "dining_table")] or tables
    desks = any("desk" in e.category for e in draft.entities)
    seated = [e for e in seats_for(draft, said) if e.count and e.count[0] == e.count[1]]
    rest = said.people - sum(places_of(e) for e in seated)
    if len(tables) == 1 and seated and rest > 0 and not any(sits_at(draft, e, tables[0]) for e in seated):
        seats_more(draft, said, tables[0], rest)
        return
    if len(tables) == 1 and (said.activity == "eat" or elsewhere or set_out or (said.activity == "work" and not desks)):
        rest = said.people - sum(e.count[0] for e in elsewhere if e.count and family(e.category) != "seat")
        if rest == said.people or seats_named(draft, tables[0]) is None:
            seats_at(draft, said.model_copy(update={"people": max(1, rest)}), tables[0])
        else:
            named = seats_named(draft, tables[0])
            if named is not None and is_vague(named):
                draft.change(named, count=(said.people, said.people))
        return
    if elsewhere:
        return
    named = seats_for(draft, said)
    open_ = [e for e in named if is_vague(e) and not tables]
    if open_ and said.activity in RESTING:
        rest = _shared_out(draft, said.people, named, open_)
        if rest > 0:
            _usual_seats(draft, said.model_copy(update={"people": rest}), [])
        return
    if any(not is_vague(e) and (e.count or (1, 1))[1] > 1 for e in named):
        return
    _usual_seats(draft, said, named)
    if said.activity in RESTING and not tables:
        _more_seats(draft, said)


def seats_for(draft: PeopleDraft, said: Capacity) -> list[Entity]:
    """The seats of a request that are places for what people do: nobody eats or works in a lounge chair in a corner."""
    found = [e for e in draft.entities if family(e.category) == "seat" and not has_role(e.category, "footrest")]
    if said.activity in RESTING:
        return found
    return [e for e in found if not has_role(e.category, "lounge_seat")]


def places_of(seat: Entity, count: int | None = None) -> int:
    """The people that sit on seats of a request, on sofas and benches at their usual length if none is said."""
    known, many = category_named(seat.category).size, count or (seat.count[0] if seat.count else 1)
    if known is None or known.width[1] < 2 * long_enough(1):
        return many
    sofa = has_role(seat.category, "sofa")
    width = seat.size[1] or (known.width[0] + known.width[1]) / 2
    return many * seat_places(width - (ARMS if sofa else 0.0) + (SLACK if sofa else 0.0))


def _shared_out(draft: PeopleDraft, people: int, named: Sequence[Entity], open_: Sequence[Entity]) -> int:
    """Counts of seats of which a request names several without a number, so that as many sit on all as there are
    people: two of each, then more of what seats one where that will do. Returns how many have no seat even so.

    At a window there are no more stools than usual where the room has other places.
    """
    left = people - sum(places_of(e) for e in named if e not in open_)
    at_window = {r.subject for r in draft.relations if r.targets == ("window",)}
    counts = {e.id: FEW if e.id in at_window else 2 for e in open_}
    left -= sum(places_of(e, counts[e.id]) for e in open_)
    more = [e for e in open_ if e.id not in at_window]
    while left > 0 and more:
        each = {e.id: places_of(e, 1) for e in more}
        best = min(more, key=lambda e: (each[e.id] < left, each[e.id]) if each[e.id] >= left else (True, -each[e.id]))
        counts[best.id] += 1
        left -= each[best.id]
    for entity in open_:
        draft.change(entity, count=(counts[entity.id], counts[entity.id]))
        if has_role(entity.category, "sofa") and entity.size[1] is None:
            width = long_enough(places_of(entity, 1)) + ARMS  # as long as was counted on
            draft.change(draft.now(entity.id), size=(entity.size[0], round(width, 3), entity.size[2]))
    return max(0, left)


def _more_seats(draft: PeopleDraft, said: Capacity) -> None:
    """What a request names one of, such as a sofa, is as long as such things are, and who has no place on it has a
    seat beside it."""
    named = seats_for(draft, said)
    left = said.people - sum(places_of(e) for e in named)
    if left <= 0 or not named or any(is_vague(e) for e in named):
        return
    lounge = has_role(named[0].category, "lounge_seat")
    items = [i for i in draft.room.items if family(i.what[0]) == "seat" and i.with_ is None]
    known = [n for i in items for n in i.what if has_role(n, "lounge_seat") == lounge and not has_role(n, "sofa")]
    single = next((n for n in known if n != named[0].category), "armchair" if lounge else named[0].category)
    if not any(e.category == single for e in draft.entities):
        draft.add(single, left)


def _usual_seats(draft: PeopleDraft, said: Capacity, named: Sequence[Entity]) -> None:
    """The seats that such a room has for people, with what they are at. A kind of room that nobody described has those
    of the kind in which such things are likeliest."""
    room = draft.room
    if not any(family(i.what[0]) == "seat" for i in room.items):
        room = likeliest_room((e.category for e in draft.entities), draft.brief.text) or room
    pairs = [(i, room.item(i.with_) if i.with_ else None) for i in room.items]
    pairs = [(i, host) for i, host in pairs if family(i.what[0]) == "seat" and i.need != "optional"]
    if not pairs:
        return
    usual = room.area[1]
    seat, host = max(pairs, key=lambda p: _places(p[0], p[1], usual, said.people))
    own = next((e for e in named if matches(e.category, seat)), None)
    if host is None:
        width = category_named(seat.what[0]).size
        each = seat_places(width.width[0]) if width is not None and width.width[0] > 1.0 else 1
        counted(draft, own, seat, math.ceil(said.people / each))
        return
    table = next((e for e in draft.entities if matches(e.category, host) or kin(e.category) & set(host.what)), None)
    if table is not None and not is_vague(table):
        seats_at(draft, said, table)
        return
    if host.count.most == 1 and host.with_ is None:
        counted(draft, own, seat, said.people)
        return
    each = max(1, seat.count.of(usual, said.people, 0.5))
    tables = counted(draft, table, host, math.ceil(said.people / each))
    if room is not draft.room and tables is not None:  # of its own this room has no seats at them
        seats_at(draft, said, tables)


def counted(draft: PeopleDraft, named: Entity | None, item: Item, count: int) -> Entity | None:
    """So many of an item of the room: of what the request names for it without a number, or implied."""
    if named is None:
        return draft.add(item.what[0], count)
    if is_vague(named):
        draft.change(named, count=(count, count))
    return draft.now(named.id)


def _places(seat: Item, host: Item | None, area: float, people: int) -> int:
    """The seats that a room usually has of an item."""
    return seat.count.of(area, people, 0.5) * (host.count.of(area, people, 0.5) if host is not None else 1)


def only_long_seat(draft: PeopleDraft) -> Entity | None:
    """The benches or pews of a request that names no other seats and no table to sit at: all sit there."""
    seats = [e for e in draft.entities if family(e.category) == "seat"]
    at_table = any(has_role(e.category, "pulled_up_to", "any_bed") for e in draft.entities)
    size = category_named(seats[0].category).size if len(seats) == 1 and not at_table else None
    long = size is not None and size.width[1] >= 2 * long_enough(1) and not has_role(seats[0].category, "sofa")
    return seats[0] if long and not is_worked_at(draft, seats[0]) else None


def is_worked_at(draft: PeopleDraft, seat: Entity) -> bool:
    """Whether a bench is one to work at: in a room with benches to work at, or one that seats are named for."""
    if seat.category != "bench":
        return False
    names = {name for item in draft.room.items for name in item.what}
    works = any(name.endswith("bench") and family(name) != "seat" for name in names)
    waits = any(has_role(name, "waiting_seat") for name in names)
    return (works and not waits) or seats_named(draft, seat) is not None


def long_seat(draft: PeopleDraft, said: Capacity, seat: Entity) -> None:
    """A sofa as long as so many need; seats for one are as many as people."""
    known = category_named(seat.category).size
    if known is None:
        return
    if known.width[1] < 2 * long_enough(1):
        if seat.count is None or is_vague(seat):
            draft.change(seat, count=(said.people, said.people))
    elif seat.size[1] is None:
        corner = has_role(seat.category, "sofa") and "sectional" in seat.category
        longest = known.reach[1][1]
        count = 1 if seat.count is None and not is_vague(seat) else seat.count[0] if seat.count else 1
        if is_vague(seat):  # as many as hold them at a usual length
            usual = (known.width[0] + known.width[1]) / 2
            count = max(2, math.ceil(said.people / max(1, seat_places(usual))))
            draft.change(seat, count=(count, count))
        elif count == 1 and not said.each and not has_role(seat.category, "sofa"):
            count = math.ceil(said.people / seat_places(longest))  # a bench for a whole team is of several in a row
            draft.change(seat, count=(count, count))
        people = said.people if said.each else math.ceil(said.people / count)
        arms = ARMS if has_role(seat.category, "sofa") else 0.0
        width = min(long_enough(people - (1 if corner else 0)) + arms, longest)
        if width > known.width[0]:
            draft.change(draft.now(seat.id), size=(seat.size[0], round(max(width, known.width[0]), 3), seat.size[2]))
