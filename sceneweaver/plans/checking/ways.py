"""Measures of ways: what the entrance reaches without crossing rooms that are no way."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from fractions import Fraction

from ..profile import Rule
from ..room_types import selects
from .facts import PlanFacts
from .parts import DoorFacts, RoomFacts
from .readings import Reading, fault, measure
from .rooms import turning_square

ACCESSIBLE_TOILET = 5
"""Floor of a toilet for wheelchairs [m2] (profile row accessible-bath)."""


@measure("entrances")
def entrances(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Doors from outside into the entrance's room."""
    doors = plan.entrances
    where = f" into {plan.programme.entrance}" if plan.programme is not None else ""
    line = f"there is no door from outside{where} (its ``to`` is null): add one"
    yield Reading(tuple(d.room.id for d in doors), Fraction(len(doors)), line.replace("``", ""))


@measure("unreached")
def unreached(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Rooms that no way leads to."""
    if not plan.entrances:
        return  # told by the row about entrances
    seen = reached(plan)
    physical = reached(plan, anywhere=True)
    for room in plan.rooms:
        if room.id in seen:
            continue
        beside = [n for n in neighbours(plan)[room.id] if n.id in physical]
        crossed = sorted({n.id for n in beside if n.id in seen})
        if not beside:
            line = f"{room.id}: no doors lead from the entrance to it; add a door"
        elif crossed:
            line = f"{room.id}: the way to it crosses {', '.join(crossed)}, which is no way; give it a door to a hall"
        else:
            line = f"{room.id}: it lies behind {', '.join(sorted({n.id for n in beside}))}, which is not reached itself"
        yield fault((room.id,), line)


def neighbours(plan: PlanFacts) -> dict[str, list[RoomFacts]]:
    """Rooms that doors, passages and stairs join, by room."""
    found: dict[str, list[RoomFacts]] = {room.id: [] for room in plan.rooms}
    joints = [(door.room, door.other) for door in plan.doors if door.other is not None]
    joints += [(plan.by_id[stair.lower], plan.by_id[stair.upper]) for stair in plan.stairs]
    for a, b in joints:
        found[a.id].append(b)
        found[b.id].append(a)
    return found


def reached(plan: PlanFacts, *, anywhere: bool = False, closed: Iterable[str] = ()) -> set[str]:
    """Ids of the rooms that the entrances reach.

    Args:
        plan: where.
        anywhere: through all rooms; else as `may_pass` says.
        closed: roles of rooms that are not crossed at all.
    """
    shut = tuple(closed)
    around = neighbours(plan)
    seen = {door.room.id for door in plan.entrances}
    queue = deque(sorted(seen))
    while queue:
        room = plan.by_id[queue.popleft()]
        if any(room.has(role) for role in shut):
            continue
        for other in around[room.id]:
            if other.id not in seen and (anywhere or may_pass(plan, room, other)):
                seen.add(other.id)
                queue.append(other.id)
    return seen


def may_pass(plan: PlanFacts, room: RoomFacts, other: RoomFacts) -> bool:
    """Whether the way to ``other`` may lead through ``room``.

    Through halls, living rooms and such to anything; through a room with a suite to its annexes: with a programme, to
    those that it joins to that room, and to annexes that it joins to none; through any room to what is outdoors.
    """
    if room.kind.transit == "all":
        return True
    if plan.programme is not None:
        joined = joined_by_programme(plan).get(other.id, set())
        if joined:
            return room.id in joined
    if room.kind.transit == "none":
        return other.outdoor
    return other.has("annex") or other.outdoor


def joined_by_programme(plan: PlanFacts) -> dict[str, set[str]]:
    """Rooms that a door or passage of the programme joins, by room."""
    found: dict[str, set[str]] = {}
    for adjacency in plan.programme.adjacencies if plan.programme is not None else ():
        if adjacency.kind in ("door", "open"):
            found.setdefault(adjacency.a, set()).add(adjacency.b)
            found.setdefault(adjacency.b, set()).add(adjacency.a)
    return found


@measure("shared_toilets")
def shared_toilets(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Toilets that are reached without crossing a bedroom; with at most one bedroom, all that are reached."""
    bedrooms = [room for room in plan.rooms if room.has("sleeping") and not room.has("living")]
    seen = reached(plan, closed=("sleeping",) if len(bedrooms) > 1 else ())
    toilets = [room for room in plan.rooms if room.has("toilet")]
    found = tuple(room.id for room in toilets if room.id in seen)
    behind = any(room.id in reached(plan) for room in toilets)
    line = "every toilet lies behind a bedroom; one opens to a hall" if behind else "the entrance reaches no toilet"
    line = line if toilets else "there is no toilet; add a bathroom"
    yield Reading(found, Fraction(len(found)), line)


@measure("accessible_toilets")
def accessible_toilets(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Toilets with room to turn on a storey with an entrance."""
    storeys = {door.room.storey for door in plan.entrances}
    found = [
        room.id
        for room in plan.rooms
        if room.has("toilet")
        and room.storey in storeys
        and room.area >= ACCESSIBLE_TOILET
        and turning_square(plan, room) >= 1500
    ]
    line = f"no toilet on the entrance's storey has {ACCESSIBLE_TOILET} m2 and 1.5 x 1.5 m to turn in"
    yield Reading(tuple(found), Fraction(len(found)), line)


@measure("door_between")
def door_between(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Doors from a room straight to one of the others."""
    around = neighbours(plan)
    for room in plan.selected(rule.of):
        others = [other for other in around[room.id] if selects(rule.to, other.kind) and other is not room]
        names = ", ".join(other.id for other in others) or f"none of {', '.join(rule.to)}"
        yield Reading((room.id, *(o.id for o in others)), Fraction(len(others)), f"{room.id}: it opens to {names}")


@measure("nearer_entrance")
def nearer_entrance(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Ways along the axes from the middle of the entrance's door to the middle of the first door of the rooms.

    Doors to annexes, and between two of the rooms, lead on from there and do not count; a room with the entrance's door
    in it is at 0.
    """
    for entrance in plan.entrances[:1]:
        here = door_middle(entrance)
        near: list[tuple[Fraction, str]] = []
        for words in (rule.of, rule.to):
            ways = [
                (abs(here[0] - x) + abs(here[1] - y), room.id)
                for room in plan.selected(words)
                if room.storey == entrance.room.storey
                for door in plan.doors_of(room)
                if leads_in(door, room, words)
                for x, y in [door_middle(door)]
            ]
            near += [min(ways)] if ways else []
        if len(near) == 2:
            (first, room), (second, other) = near
            line = f"{room}: its lead over {other} on the way in"
            yield Reading((room, other), (second - first) / 1000, line, "m")


def door_middle(door: DoorFacts) -> tuple[Fraction, Fraction]:
    """The middle of an opening on the face of the wall of its own room, to half a millimetre where that is straight."""
    (ax, ay), (bx, by) = door.wall.at(door.offset), door.wall.at(door.offset + door.width)
    return Fraction(round(ax + bx), 2), Fraction(round(ay + by), 2)


def leads_in(door: DoorFacts, room: RoomFacts, words: Iterable[str]) -> bool:
    """Whether one comes into a room by a door: from outdoors, or from a room that is no annex and none of ``words``."""
    other = door.other if door.room is room else door.room
    return other is None or not (other.has("annex") or other.outdoor or selects(words, other.kind))
