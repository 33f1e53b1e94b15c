"""Measures of daylight: glazing by floor, rooms without a window, ways out of bedrooms, sun."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from sceneweaver.home import DoorKind

from ..profile import Rule
from .facts import PlanFacts
from .parts import DoorFacts, OpeningFacts, RoomFacts
from .readings import Reading, fault, measure
from .walls import exact, metres

OPEN_WIDTH = 1200
"""An open passage of this width [mm] makes two rooms one for light (profile row daylight)."""

ESCAPE_AREA, ESCAPE_WIDTH, ESCAPE_HEIGHT, ESCAPE_SILL = Fraction(53, 100), 510, Fraction(61, 100), Fraction(112, 100)
"""A window to climb out of: [m2], [mm], [m], [m] (profile row escape)."""


def glazed(plan: PlanFacts, room: RoomFacts) -> list[tuple[OpeningFacts, Fraction]]:
    """What lets light into a room with its area [m2]: windows, and doors onto balconies and gardens.

    The door of the entrance has no glass.
    """
    found = [(w, metres(w.width) * (w.top - w.bottom)) for w in plan.windows_of(room)]
    for door in plan.doors_of(room):
        to_garden = door.leads_out and door not in plan.entrances
        if (_onto_balcony(door) or to_garden) and not room.outdoor:
            found.append((door, metres(door.width) * door.top))
    return found


def open_group(plan: PlanFacts, room: RoomFacts, kinds: tuple[DoorKind, ...]) -> list[RoomFacts]:
    """The rooms that passages of these kinds, `OPEN_WIDTH` wide, join to a room, itself first."""
    group, queue = [room], [room]
    while queue:
        here = queue.pop()
        for door in plan.doors_of(here):
            other = door.other if door.room is here else door.room
            wide = door.part.kind in kinds and door.width >= OPEN_WIDTH
            if wide and other is not None and not other.outdoor and other not in group:
                group.append(other)
                queue.append(other)
    return group


@measure("dark")
def dark(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Rooms that need daylight and have no window, nor a wide passage to a room that has."""
    for room in plan.rooms:
        if room.outdoor or not room.needs_daylight:
            continue
        if not any(glazed(plan, other) for other in open_group(plan, room, rule.passages)):
            yield fault((room.id,), f"{room.id}: it has no window, nor an open passage of 1.2 m to a room with one")


@measure("glazing")
def glazing(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Windows by floor, of the room or of the habitable rooms that wide passages join to it, whichever is more.

    A room that needs no daylight as the programme says is left out.
    """
    for room in plan.selected(rule.of):
        if room.outdoor or (room.spec is not None and room.spec.daylight is False):
            continue
        group = open_group(plan, room, rule.passages)
        windows = sum((area for other in group for _, area in glazed(plan, other)), Fraction(0))
        floor = sum((other.area for other in group if other.has("habitable")), Fraction(0)) or room.area
        own = sum((area for _, area in glazed(plan, room)), Fraction(0)) / room.area
        yield Reading((room.id,), max(own, windows / floor), f"{room.id}: windows by floor", "%")


@measure("escape")
def escape(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Windows large and low enough to climb out of, and doors outdoors."""
    for room in plan.selected(rule.of):
        ways = [
            window.id
            for window in plan.windows_of(room)
            if window.width >= ESCAPE_WIDTH
            and window.top - window.bottom >= ESCAPE_HEIGHT
            and metres(window.width) * (window.top - window.bottom) >= ESCAPE_AREA
            and window.bottom <= ESCAPE_SILL
        ]
        ways += [d.id for d in plan.doors_of(room) if d.leads_out or _onto_balcony(d)]
        yield Reading(
            (room.id,),
            Fraction(len(ways)),
            f"{room.id}: no window of 0.53 m2, 0.51 x 0.61 m, with a sill of at most 1.12 m, and no door outdoors",
        )


def _onto_balcony(door: DoorFacts) -> bool:
    return door.other is not None and door.other.outdoor != door.room.outdoor


@measure("sun")
def sun(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Share of the glass that does not face north."""
    for room in plan.selected(rule.of):
        glass = glazed(plan, room)
        whole = sum((area for _, area in glass), Fraction(0))
        if whole:
            north = sum((area for opening, area in glass if _outward(opening, room)[1] > 0.7), Fraction(0))
            yield Reading((room.id,), 1 - north / whole, f"{room.id}: glass that does not face north", "%")


@measure("light_sides")
def light_sides(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Directions from which light comes into a room."""
    for room in plan.selected(rule.of):
        ways = {tuple(exact(v) for v in _outward(opening, room)) for opening, _ in glazed(plan, room)}
        yield Reading((room.id,), Fraction(len(ways)), f"{room.id}: sides with windows", "")


def _outward(opening: OpeningFacts, room: RoomFacts) -> tuple[float, float]:
    x, y = opening.wall.outward
    return (x, y) if opening.room is room else (-x, -y)
