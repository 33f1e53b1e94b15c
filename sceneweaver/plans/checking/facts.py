"""A home in whole millimetres, as measures read it: floors, openings through walls, leaves, stairs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, Stair
from sceneweaver.io import InputError

from ..envelope import Envelope
from ..programme import Programme, RoomSpec
from ..room_types import RoomType, room_types, selects
from .quarters import Quarter
from .regions import Box, Point, Region, doubled_area, is_rectilinear

if TYPE_CHECKING:
    from shapely import Polygon

THICKEST = 800
"""Thickest wall [mm] that a door goes through, as of homes."""

FREE_BEFORE_WINDOW = 1000
"""What a window has before the outer wall [mm] (profile row windows-outside)."""

FREE_BEFORE_ENTRANCE = 600
"""What the door of an entrance has before the outer wall [mm]."""

FACING = 1e-9
"""Walls face each other where the cosine of their angle is this near to -1, as for homes: oblique ones are rounded."""

OPEN_WIDTH = 1200
"""An open passage of this width [mm] makes two rooms one for light (profile row daylight)."""


def mm(value: float) -> int:
    """A length [m] in whole millimetres."""
    return round(value * 1000)


def metres(value: int) -> Fraction:
    """Millimetres as exact metres."""
    return Fraction(value, 1000)


@dataclass(frozen=True)
class Wall:
    """A wall of a room's outline: from ``start`` to ``end``, the room to the left of the way."""

    start: Point
    end: Point

    @property
    def straight(self) -> bool:
        """Whether it runs along x or y."""
        return self.start[0] == self.end[0] or self.start[1] == self.end[1]

    @cached_property
    def length(self) -> float:
        """[mm], a whole number where it is straight."""
        return math.dist(self.start, self.end)

    @property
    def along(self) -> tuple[float, float]:
        """Unit vector from start to end."""
        return (self.end[0] - self.start[0]) / self.length, (self.end[1] - self.start[1]) / self.length

    @property
    def outward(self) -> tuple[float, float]:
        """Unit vector out of the room."""
        x, y = self.along
        return y, -x

    def at(self, offset: float, out: float = 0.0) -> tuple[float, float]:
        """The point ``offset`` along the wall and ``out`` beyond its face."""
        (x, y), (nx, ny) = self.along, self.outward
        return self.start[0] + x * offset + nx * out, self.start[1] + y * offset + ny * out

    def strip(self, offset: int, width: int, near: int, far: int) -> Strip:
        """What lies ``near`` to ``far`` beyond the face over ``width`` from ``offset`` on."""
        corners = [self.at(offset, near), self.at(offset + width, near), self.at(offset + width, far)]
        return Strip((*corners, self.at(offset, far)))


@dataclass(frozen=True)
class Strip:
    """A rectangle, corners in order [mm]; along the axes they are whole numbers."""

    corners: tuple[tuple[float, float], ...]

    @cached_property
    def box(self) -> Box | None:
        """As a box where it lies along the axes."""
        xs, ys = sorted({round(x, 6) for x, _ in self.corners}), sorted({round(y, 6) for _, y in self.corners})
        if len(xs) != 2 or len(ys) != 2:
            return None
        return round(xs[0]), round(ys[0]), round(xs[1]), round(ys[1])

    def polygon(self) -> Polygon:
        """For what is oblique."""
        import shapely

        return shapely.Polygon(self.corners)


@dataclass(frozen=True, eq=False)
class RoomFacts:
    """A room: ``outline`` in millimetres, ``region`` what it encloses (from inside where a wall is oblique)."""

    id: str
    kind: RoomType
    storey: int
    outdoor: bool
    outline: tuple[Point, ...]
    height: Fraction
    spec: RoomSpec | None

    @cached_property
    def straight(self) -> bool:
        """Whether all its walls run along x or y."""
        return is_rectilinear(self.outline)

    @cached_property
    def region(self) -> Region:
        """Its floor."""
        return Region.of_outline(self.outline)

    @cached_property
    def rectangles(self) -> list[tuple[int, int]]:
        """(width, depth) of the rectangles along the axes that fit and grow no further [mm]."""
        return self.region.largest_rectangles()

    @cached_property
    def area(self) -> Fraction:
        """[m2]"""
        return Fraction(doubled_area(self.outline), 2_000_000)

    @cached_property
    def walls(self) -> tuple[Wall, ...]:
        """In order."""
        n = len(self.outline)
        return tuple(Wall(self.outline[i], self.outline[(i + 1) % n]) for i in range(n))

    @cached_property
    def box(self) -> Box:
        """The rectangle around it."""
        xs, ys = [x for x, _ in self.outline], [y for _, y in self.outline]
        return min(xs), min(ys), max(xs), max(ys)

    @cached_property
    def polygon(self) -> Polygon:
        """For what is oblique."""
        import shapely

        polygon = shapely.Polygon(self.outline)
        shapely.prepare(polygon)
        return polygon

    def has(self, role: str) -> bool:
        """Whether its type has a role."""
        return role in self.kind.roles

    @property
    def needs_daylight(self) -> bool:
        """As the programme says, else its type."""
        return self.spec.needs_daylight if self.spec is not None else self.has("daylight")

    def meets(self, strip: Strip) -> bool:
        """Whether its inside meets the inside of a strip."""
        if strip.box is not None:
            x0, y0, x1, y1 = strip.box
            bx0, by0, bx1, by1 = self.box
            if x0 >= bx1 or x1 <= bx0 or y0 >= by1 or y1 <= by0:
                return False
            if self.straight:
                return any(x0 < b[2] and b[0] < x1 and y0 < b[3] and b[1] < y1 for b in self.region.boxes)
        return self.polygon.intersection(strip.polygon()).area > 1.0


@dataclass(frozen=True, eq=False)
class OpeningFacts:
    """A door or window with its wall, and where it lies along it [mm]."""

    part: HomeDoor | HomeWindow
    room: RoomFacts
    wall: Wall
    offset: int
    width: int
    bottom: Fraction
    top: Fraction

    @property
    def id(self) -> str:
        """Of the door or window."""
        return self.part.id


@dataclass(frozen=True, eq=False)
class DoorFacts(OpeningFacts):
    """A door; ``other`` is the room behind it, ``far`` its wall there and ``gap`` how thick the wall between is."""

    part: HomeDoor
    other: RoomFacts | None
    far: tuple[int, int, int] | None
    """Number of the wall in the other room, the offset along it, and the thickness of the wall [mm]."""

    @property
    def rooms(self) -> tuple[str, ...]:
        """Ids of the rooms on its sides."""
        return (self.room.id, self.other.id) if self.other is not None else (self.room.id,)

    @property
    def leads_out(self) -> bool:
        """Whether it leads out of the home, not onto a balcony."""
        return self.other is None and not self.room.outdoor

    @property
    def swings_into(self) -> RoomFacts | None:
        """The room into which its leaves swing."""
        if self.part.kind not in ("hinged", "double") or self.part.opens_into is None:
            return None
        return self.room if self.part.opens_into == self.room.id else self.other

    def place_in(self, room: RoomFacts) -> tuple[Wall, int]:
        """The wall of a room that it goes through, and the offset along it."""
        if room is self.room or self.far is None:
            return self.wall, self.offset
        return room.walls[self.far[0]], self.far[1]

    def leaves(self) -> list[tuple[Quarter | None, Wall, int, int, bool]]:
        """Each leaf: its quarter (None where the wall is oblique), wall, hinge's offset, radius, towards the end?"""
        room = self.swings_into
        if room is None:
            return []
        wall, offset = self.place_in(room)
        width = self.width
        # Seen by somebody coming in, the wall runs from left to right: its start is on the left.
        if self.part.kind == "double":
            half = width // 2
            hung = [(offset, width - half, True), (offset + width, half, False)]
        elif self.part.hinge == "left":
            hung = [(offset, width, True)]
        else:
            hung = [(offset + width, width, False)]
        return [(_quarter(wall, at, r, forward), wall, at, r, forward) for at, r, forward in hung]


def _quarter(wall: Wall, at: int, radius: int, forward: bool) -> Quarter | None:
    if not wall.straight:
        return None
    x, y = wall.at(at)
    (ax, ay), (nx, ny) = wall.along, wall.outward
    sign = 1 if forward else -1
    return Quarter((round(x), round(y)), radius, (round(ax * sign - nx), round(ay * sign - ny)))


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


def facing(wall: Wall, offset: int, width: int, other: RoomFacts) -> tuple[int, int, int] | None:
    """The wall of another room that lies behind an opening over its whole width, nearest first.

    Returns:
        Its number, the offset of the opening along it and the distance between the faces [mm]; None: there is none.
    """
    found: list[tuple[int, int, int]] = []
    ends = wall.at(offset), wall.at(offset + width)
    for number, far in enumerate(other.walls):
        (ax, ay), (bx, by) = wall.along, far.along
        if ax * bx + ay * by > -1 + FACING:
            continue
        gap = (far.start[0] - ends[0][0]) * wall.outward[0] + (far.start[1] - ends[0][1]) * wall.outward[1]
        start = (ends[1][0] - far.start[0]) * bx + (ends[1][1] - far.start[1]) * by
        # An oblique wall is as long as its root says: a rounding of a micrometre is none.
        if -1e-3 <= gap <= THICKEST + 1e-3 and start >= -1e-3 and start + width <= far.length + 1e-3:
            found.append((round(gap), number, round(start)))
    if not found:
        return None
    gap, number, start = min(found)
    return number, start, gap


def exact(value: float) -> Fraction:
    """A number as its shortest decimal says it, exactly."""
    return Fraction(repr(round(float(value), 9)))


def require_home(home: Any) -> Home:
    """``home`` itself; InputError where it is none."""
    if not isinstance(home, Home):
        raise InputError(f"home is of type {type(home).__name__}; give a Home, such as sw.Home.load(path)")
    return home
