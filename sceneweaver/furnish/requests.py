"""What the rooms of a home are furnished with where nobody says it: each so that the home as a whole has it once.

A room by itself is furnished as such rooms usually are, with a table to eat at in each kitchen. In a home one room is
for that: the one that is by its type, else a kitchen that has the floor for it, else the living room, else the kitchen
with a small one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.home import Home, HomeRoom
from sceneweaver.language import read_request
from sceneweaver.plans.room_types import room_types

from .kinds import kind_of

EAT_IN, EAT_LIVING = 13.5, 20.0
"""Floors [m2] from which on a kitchen, and a living room, have a table for all."""

DOUBLE = (9.0, 2.55)
"""Floor [m2] and least side [m] from which on a bedroom has a bed for two."""

NARROW = 1.15
"""Width [m] of a hall up to which nothing stands on its floor: the way needs it."""

PEOPLE = (4, 6)
"""Fewest and most people that a table is laid for where nobody says how many live there."""

APART = 1.2
"""Distance [m] between the seats around a television and a table to eat at."""

LIVED_IN = "a sofa, a coffee table and a tv"
"""What a kitchen to eat in holds as well where it is the living room."""

BEDROOMS = ("bedroom", "master_bedroom", "guest_room")
"""Kinds of rooms in which the bed is for one or two, as the floor allows."""


@dataclass(frozen=True)
class _Place:
    """A room with what decides what it may hold: its kind, floor [m2] and least clear side [m]."""

    room: HomeRoom
    kind: str
    area: float
    side: float


def room_requests(home: Home, told: Mapping[str, str] | None = None) -> dict[str, str]:
    """By id, in words, what each room of a home is to hold; rooms that stay empty are left out.

    Args:
        home: its rooms with their types and outlines.
        told: by id, what was asked for; it is taken as it is, and the other rooms make up what it leaves open.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.furnish import room_requests
        >>> room_requests(sw.Home.example("flat"), {"bath": "a bathroom with a bathtub"})["bath"]
        'a bathroom with a bathtub'
    """
    told = told or {}
    places = [place for room in home.rooms if (place := _place(room)) is not None]
    beds = {p.room.id: _sleepers(p) for p in places if p.kind in BEDROOMS}
    people = min(max(2 * round(sum(beds.values()) / 2), PEOPLE[0]), PEOPLE[1])
    table = _eaten_in(places, told)
    return {p.room.id: told.get(p.room.id) or _usual(p, beds, table, people) for p in places}


def _place(room: HomeRoom) -> _Place | None:
    kind = kind_of(room.type)
    if kind is None:
        return None
    return _Place(room, kind.name, signed_area(room.outline), least_side(room))


def least_side(room: HomeRoom) -> float:
    """The width [m] of the widest square, along the walls, that lies in a room: its clear width."""
    import shapely

    floor, low, high = shapely.Polygon(room.outline), 0.0, 50.0
    xs, ys = sorted({p[0] for p in room.outline}), sorted({p[1] for p in room.outline})
    while high - low > 0.01:
        side = (low + high) / 2
        starts = [(x + dx, y + dy) for x in xs for y in ys for dx in (0.0, -side) for dy in (0.0, -side)]
        if any(floor.buffer(1e-6).covers(shapely.box(x, y, x + side, y + side)) for x, y in starts):
            low = side
        else:
            high = side
    return round(low, 2)


def _sleepers(place: _Place) -> int:
    return 2 if place.area >= DOUBLE[0] and place.side >= DOUBLE[1] else 1


def _eaten_in(places: list[_Place], told: Mapping[str, str]) -> str:
    """The id of the room with the table to eat at; empty where a dining room or a request has it."""
    if any(p.kind in ("dining_room", "kitchen_diner", "break_room") for p in places):
        return ""
    for text in told.values():
        if any(has_role(e.category, "seated_at") and "dining" in e.category for e in read_request(text).entities):
            return ""
    free = [p for p in places if p.room.id not in told]
    meant = [p for p in free if p.room.type in room_types() and "eating" in room_types()[p.room.type].roles]
    for kind, least in (("kitchen", EAT_IN), ("living_room", EAT_LIVING), ("kitchen", 0.0), ("living_room", 0.0)):
        fitting = meant or [p for p in free if p.kind == kind and p.area >= least]
        if fitting:
            return max(fitting, key=lambda p: (p.area, p.room.id)).room.id
    return ""


def _usual(place: _Place, beds: Mapping[str, int], table: str, people: int) -> str:
    words = place.kind.replace("_", " ")
    text = f"{'an' if words[0] in 'aeiou' else 'a'} {words}"
    if place.kind in BEDROOMS:
        return f"{text} with a double bed" if beds[place.room.id] == 2 else f"{text} with a single bed"
    if place.kind == "kitchen":
        if table != place.room.id:
            return f"{text} without a dining table"
        return text if place.area >= EAT_IN else f"{text} with a small dining table and 2 chairs"
    if place.kind == "living_room" and table == place.room.id:
        return f"{text} with a dining table for {people} people at least {APART:g} m away from the coffee table"
    planned = room_types().get(place.room.type)
    if place.kind == "kitchen_diner" and planned is not None and "living" in planned.roles:
        return f"{text} with {LIVED_IN}"
    if place.kind == "hallway" and place.side <= NARROW:
        return f"{text} with only ceiling lights and pictures"
    return text
