"""A home in whole millimetres, with the programme that it answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cached_property
from typing import Any

from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, Stair
from sceneweaver.io import InputError

from ..envelope import Envelope
from ..programme import Programme
from ..room_specs import RoomSpec
from ..room_types import room_types, selects
from .parts import DoorFacts, OpeningFacts, RoomFacts, facing
from .walls import exact, mm


class PlanFacts:
    """All of a home in whole millimetres, with the programme that it answers.

    Raises:
        InputError: a coordinate of a room is no whole millimetre (homes refuse it before).
    """

    def __init__(self, home: Home, programme: Programme | None, envelope: Envelope | None) -> None:
        self.home, self.programme, self.envelope = home, programme, envelope
        self.inner, self.outer = mm(home.walls.inner), mm(home.walls.outer)
        order = {storey.id: k for k, storey in enumerate(home.storeys)}
        self.elevations = [exact(s.elevation) for s in home.storeys]
        self.heights = [exact(s.height) for s in home.storeys]
        specs = {spec.id: spec for spec in programme.rooms} if programme is not None else {}
        self.rooms = tuple(self._room(room, order[room.storey], specs.get(room.id)) for room in home.rooms)
        self.by_id = {room.id: room for room in self.rooms}
        self.doors = tuple(self._door(door) for door in home.doors)
        self.windows = tuple(self._opening(window) for window in home.windows)
        self.stairs: tuple[Stair, ...] = home.stairs

    @property
    def use(self) -> str:
        """Of the programme; without one a house where there are several storeys, an office or clinic by its rooms."""
        if self.programme is not None:
            return self.programme.use
        if any(room.has("care") for room in self.rooms):
            return "clinic"
        if any(room.has("sleeping") or room.has("living") for room in self.rooms):
            return "house" if len({room.storey for room in self.rooms}) > 1 else "flat"
        return "office" if any(room.has("work") for room in self.rooms) else "flat"

    def _room(self, room: HomeRoom, storey: int, spec: RoomSpec | None) -> RoomFacts:
        # A type that plans do not know is a room without roles: only what holds for all rooms is asked of it.
        kind = room_types().get(room.type, room_types()["room"])
        outline = tuple((mm(x), mm(y)) for x, y in room.outline)
        return RoomFacts(room.id, kind, storey, room.outdoor, outline, self.heights[storey], spec)

    def _opening(self, part: HomeWindow) -> OpeningFacts:
        room = self.by_id[part.room]
        sill = exact(part.sill)
        width, offset = mm(part.width), mm(part.offset)
        return OpeningFacts(part, room, room.walls[part.wall], offset, width, sill, sill + exact(part.height))

    def _door(self, part: HomeDoor) -> DoorFacts:
        room = self.by_id[part.room]
        other = self.by_id[part.to] if part.to is not None else None
        wall, offset, width = room.walls[part.wall], mm(part.offset), mm(part.width)
        far = None if other is None else facing(wall, offset, width, other)
        return DoorFacts(part, room, wall, offset, width, Fraction(0), exact(part.height), other, far)

    # ---- what measures ask

    def selected(self, of: Iterable[str]) -> Iterator[RoomFacts]:
        """The rooms that a selector means."""
        words = tuple(of)
        return (room for room in self.rooms if selects(words, room.kind))

    def on_storey(self, storey: int, *, outdoor: bool = True) -> list[RoomFacts]:
        """The rooms of a storey, with or without balconies."""
        return [room for room in self.rooms if room.storey == storey and (outdoor or not room.outdoor)]

    def doors_of(self, room: RoomFacts) -> list[DoorFacts]:
        """The doors on whose sides a room lies."""
        return self._doors_by_room.get(room.id, [])

    def windows_of(self, room: RoomFacts) -> list[OpeningFacts]:
        """The windows of a room."""
        return [window for window in self.windows if window.room is room]

    @cached_property
    def _doors_by_room(self) -> dict[str, list[DoorFacts]]:
        found: dict[str, list[DoorFacts]] = {}
        for door in self.doors:
            for room_id in door.rooms:
                found.setdefault(room_id, []).append(door)
        return found

    @cached_property
    def entrances(self) -> list[DoorFacts]:
        """Doors out of the home in the entrance's room, or, without a programme, in rooms that are ways."""
        out = [door for door in self.doors if door.leads_out]
        if self.programme is not None:
            return [door for door in out if door.room.id == self.programme.entrance]
        return [door for door in out if door.room.kind.transit == "all"]


def require_home(home: Any) -> Home:
    """``home`` itself; InputError where it is none."""
    if not isinstance(home, Home):
        raise InputError(f"home is of type {type(home).__name__}; give a Home, such as sw.Home.load(path)")
    return home
