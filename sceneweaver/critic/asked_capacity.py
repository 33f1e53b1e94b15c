"""Whether as many people as a request says have their places: seats at tables, beds, desks; counted in the scene.

A seat at a table counts when it is within reach of it and turned to it, and where the table's edge has room for it. No
place counts that nobody gets to from the door, nor a seat that is of no use where it stands: a bar stool without a bar.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sceneweaver.assets.levels import used_level
from sceneweaver.assets.roles import groups_above, has_role
from sceneweaver.knowledge.capacity import edge_places, number, seat_places, sleeping_places
from sceneweaver.language.model import Capacity
from sceneweaver.language.vocabulary import words
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.solids import Body
from sceneweaver.verify.stated import seat_top, worktop
from sceneweaver.verify.walkable import measure

from . import kinds
from .group_measures import nearest_point
from .partners import own_partners
from .survey import Survey, turn_to
from .verdict import Asked, counted, met, not_understood, partly, unmet

DOES = {
    "sit": "sit",
    "eat": "eat",
    "sleep": "sleep",
    "work": "work",
    "wait": "wait",
    "stand": "stand",
    "use": "are there",
}

LONG = ("bench", "booth_seat", "banquette", "pew", "jury_box", "theater_seat")
"""What the names of seats for several end with, beside sofas."""


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each number of people, and what each of them has for their own."""
    for k, said in enumerate(survey.brief.capacities):
        item = said.id or f"capacity-{k}"
        if said.own:
            yield _own(survey, said, item)
        elif said.people:
            yield _places(survey, said, item)
        else:
            yield not_understood("capacity", item, (), f"'{said.words}': of how many people is not said")


def _own(survey: Survey, said: Capacity, item: str) -> Asked:
    """Whether each of the people has so many of each thing; the scarcest tells."""
    if not said.people:
        return not_understood("capacity", item, (), f"'{said.words}': of how many people is not said")
    worst: tuple[float, int, int, str] = (math.inf, 0, 0, "")
    ids: list[str] = []
    for name, each in said.own:
        bodies, least = survey.standing_for(name), each * said.people
        ids += [b.id for b in bodies]
        entity = survey.brief.entity(name)
        worst = min(worst, (len(bodies) / max(1, least), len(bodies), least, entity.noun if entity else name))
    share, have, least, noun = worst
    number_ = counted("number", have, least)
    if share >= 1.0 and (alone := _without_own(survey, said)):
        return partly("capacity", item, ids, alone, number_)
    if share >= 1.0:
        return met("capacity", item, ids, f"each of {said.people} has their own {noun}", number_)
    reason = f"{have} '{noun}' for {said.people} people, {least} were asked for"
    return unmet("capacity", item, ids, reason, number_, fault="too_few_places", share=1.0 - share)


def _without_own(survey: Survey, said: Capacity) -> str:
    """Whose place has none of what each has for their own on it or beside it, in words; empty where all have. What
    stands on the floor, such as wardrobes, may be anywhere."""
    reach = fault_kind("too_few_places").limits["own"]
    seats = [seat for table in survey.bodies if is_table(table) for seat in used_seats(survey, table)]
    places = seats or [b for b in survey.bodies if sleeping_places(b.item.category)]
    for name, each in said.own:
        things = {b.id for b in survey.standing_for(name) if b.item.mount == "surface"}
        if not things or not places:
            continue
        near = {p.id: [b.id for b, _ in survey.near(p, reach) if b.id in things] for p in places}
        served = sum(len(own) >= each for own in own_partners(near, each).values())
        if served < min(said.people, len(places)):
            entity = survey.brief.entity(name)
            return f"{served} of {len(places)} places have their own {entity.noun if entity else name}"
    return ""


def _places(survey: Survey, said: Capacity, item: str) -> Asked:
    """The places of so many people at what they were asked for, or in the room."""
    targets = survey.standing_for(said.target) if said.target else []
    if said.target and not targets:
        reason = f"there is nothing for {said.people} people to be at"
        return unmet("capacity", item, (), reason, counted("places", 0, said.people), fault="too_few_places")
    found = _found(survey, said, targets)
    if found is None:
        return not_understood("capacity", item, (), f"places for {said.people} people here cannot be counted")
    ids, have = found
    measure = counted("places", have, said.people)
    where = "at each" if said.each else "in all"
    reason = f"{have} people {DOES[said.activity]} {where}, {said.people} were asked for"
    if have >= said.people:
        vague = said.activity == "use" and not said.target  # what they do there is not said
        return met("capacity", item, ids, f"places for {have} people", measure, assumed=vague)
    share = (said.people - have) / said.people
    return unmet(
        "capacity",
        item,
        ids,
        reason,
        measure,
        fault="too_few_places",
        share=share,
        suggestion=f"add {said.people - have} places",
        grave=share > 0.5,
    )


def _found(survey: Survey, said: Capacity, targets: list[Body]) -> tuple[list[str], int] | None:
    """The ids of what has places, and how many those are; at the poorest target where each is meant."""
    cut_off = _cut_off(survey)
    if said.activity == "sleep":
        beds = [b for b in (targets or survey.bodies) if sleeping_places(b.item.category) and b.id not in cut_off]
        return [b.id for b in beds], sum(sleeping_places(b.item.category) for b in beds)
    if targets:
        each = [_at(survey, said, target) for target in targets]
        ids = [i for found, _ in each for i in found]
        return ids, min(n for _, n in each) if said.each else sum(n for _, n in each)
    usable = [b for b in survey.bodies if _is_seat(b) and not _is_covered(survey, b) and b.id not in cut_off]
    own = [b for b in usable if b.item.intent.request is not None or not has_role(b.item.category, "footrest")]
    seats = _of_size(survey, own)
    if said.activity in ("eat", "work"):
        tables = [b for b in survey.bodies if is_table(b)]
        left, ids, have = {seat.id for seat in seats}, list[str](), 0
        for table in tables:
            own = [seat for seat in used_seats(survey, table) if seat.id in left]
            left -= {seat.id for seat in own}
            ids += [seat.id for seat in own]
            have += min(_on_all(own), _edge(survey, table))
        return ids, have
    beds = sum(sleeping_places(b.item.category) for b in survey.bodies)
    if said.activity == "use" and not seats and not beds:
        return None
    return [b.id for b in seats], max(_in_room(survey, seats, said), beds if said.activity == "use" else 0)


def _cut_off(survey: Survey) -> frozenset[str]:
    """The ids of what nobody gets to from the door."""
    access = measure(survey.placed)
    return frozenset(access.unreached if access is not None else ())


def _of_size(survey: Survey, seats: list[Body]) -> list[Body]:
    """The seats of those that the room is for: children's chairs are none where it is for grown-ups."""
    if not set(words("people")["grown_up"].split()).intersection(survey.brief.for_whom):
        return seats
    return [b for b in seats if (used_level(b.item.solids, b.item.surfaces) or b.size[2]) > number("grown_up")]


def _in_room(survey: Survey, seats: Sequence[Body], said: Capacity) -> int:
    """The people that sit somewhere in the room: at each table as many as its edge has room for. Elsewhere nobody sits
    on a seat that is too high without its bar; and where most sit at tables a chair that stands at none is a spare."""
    left, have = {seat.id: seat for seat in seats}, 0
    for table in (b for b in survey.bodies if is_table(b) and b.item.category not in kinds.COFFEE):
        own = [left.pop(seat.id) for seat in used_seats(survey, table) if seat.id in left]
        have += min(_on_all(own), _edge(survey, table))
    alone = [b for b in left.values() if b.item.category not in kinds.HIGH_SEATS]
    chairs = [b for b in alone if has_role(b.item.category, "table_seat")]
    if said.activity != "wait" and have > len(chairs):
        alone = [b for b in alone if b not in chairs]
    return have + _on_all(alone)


def _at(survey: Survey, said: Capacity, target: Body) -> tuple[list[str], int]:
    """The people at one thing: on a seat, or on the seats at a table, as far as its edge goes."""
    if _is_seat(target) and not used_seats(survey, target):
        return [target.id], 0 if target.id in _cut_off(survey) else _on(target)
    cut_off = _cut_off(survey)
    seats = [seat for seat in used_seats(survey, target) if seat.id not in cut_off]
    edge = _edge(survey, target)
    if said.activity == "work" and has_role(target.item.category, "desk"):
        edge = max(1, int(target.size[1] / number("edge") + 1e-6))
    named = [
        e
        for e in survey.brief.entities
        if e.count and {b.id for b in survey.standing_for(e.id)} & {s.id for s in seats}
    ]
    fewer = named and not named[0].implied and named[0].count and named[0].count[1] < said.people and not said.each
    have = edge if fewer else min(edge, _on_all(seats))  # "a table for three but only two chairs"
    return [target.id, *(s.id for s in seats)], have


def _edge(survey: Survey, table: Body) -> int:
    """The people that a table's edge has room for; a side that stands at a wall has none."""
    room = number("behind_edge")
    open_ = {side for side in ("front", "back", "left", "right") if survey.clear_ahead(table, side) >= room}
    return edge_places(table.size[0], table.size[1], open_, round_="round" in table.item.category)


def used_seats(survey: Survey, table: Body) -> list[Body]:
    """The seats within reach of a table that look at it; what has no front counts however it is turned."""
    limits = fault_kind("too_few_places").limits
    found = []
    for other, gap in survey.near(table, limits["reach"]):
        if not _is_seat(other) or _is_covered(survey, other) or not _fits_under(other, table):
            continue
        point = nearest_point(table, other.centre)
        inside = gap <= 1e-6 and point == other.centre
        backless = has_role(other.item.category, "backless_seat")
        if (
            backless
            or inside
            or math.degrees(min(turn_to(other, point), turn_to(other, table.centre))) <= limits["turned"]
        ):
            found.append(other)
    return found


def _is_seat(body: Body) -> bool:
    category = body.item.category
    seat = has_role(category, "sits_at_table", "lounge_seat", "backless_seat") or "seating" in groups_above(category)
    return body.item.mount == "floor" and seat


def _is_covered(survey: Survey, seat: Body) -> bool:
    """Whether so much stands on a seat that nobody sits there: a basket, but no cushion."""
    things = [b for b in survey.carried.get(seat.id, ()) if "textile" not in groups_above(b.item.category)]
    share = sum(b.size[0] * b.size[1] for b in things) / max(1e-6, seat.size[0] * seat.size[1])
    return share > fault_kind("too_few_places").limits["covered"]


def _fits_under(seat: Body, table: Body) -> bool:
    """Whether who sits on a seat without a back has the table at a height to use it."""
    limits, rise = fault_kind("too_few_places").limits, worktop(table) - seat_top(seat)
    return not has_role(seat.item.category, "backless_seat") or limits["knees"] <= rise <= limits["chest"]


def is_table(body: Body) -> bool:
    """Whether people sit at it."""
    return body.item.category in kinds.SEATED_AT or has_role(body.item.category, "pulled_up_to")


def _on_all(seats: Sequence[Body]) -> int:
    """The people that sit on some seats; benches beside each other are as one that is so long."""
    benches = [s for s in seats if _is_long(s)]
    return sum(_on(s) for s in seats if s not in benches) + (
        seat_places(sum(max(s.size[:2]) for s in benches)) if benches else 0
    )


def _is_long(seat: Body) -> bool:
    """Whether several people sit beside each other on a seat that is no sofa."""
    return seat.item.category.endswith(LONG) and not seat.item.category.startswith("piano")


def _on(seat: Body) -> int:
    """The people that sit on a seat."""
    limits, (depth, width, _) = fault_kind("too_few_places").limits, seat.size
    if not has_role(seat.item.category, "sofa") and not _is_long(seat):
        return 1
    if seat.item.category == "sectional_sofa":
        return seat_places(width - limits["arms"]) + max(0, int((depth - limits["corner"]) / number("seat_width")))
    return seat_places(max(depth, width) - (limits["arms"] if has_role(seat.item.category, "sofa") else 0.0))
