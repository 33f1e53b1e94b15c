"""Rooms, doors and windows in whole millimetres, as measures read them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from sceneweaver.home import HomeDoor, HomeWindow

from ..room_specs import RoomSpec
from ..room_types import RoomType
from .quarters import Quarter
from .regions import Box, Point, Region, doubled_area, is_rectilinear
from .walls import Strip, Wall

if TYPE_CHECKING:
    from shapely import Polygon

THICKEST = 800
"""Thickest wall [mm] that a door goes through, as of homes."""

OBLIQUE = 1
"""Corners of oblique walls are rounded to the grid: by how much [mm] what lies along them may be off."""

FACING = 1e-9
"""Walls face each other where the cosine of their angle is this near to -1, as for homes: oblique ones are rounded."""


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
        shape = strip.polygon()
        return self.polygon.intersection(shape).area > OBLIQUE * shape.length


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
        slack = 0 if wall.straight and far.straight else OBLIQUE
        if -slack <= gap <= THICKEST + slack and start >= -slack and start + width <= far.length + slack:
            found.append((round(gap), number, round(start)))
    if not found:
        return None
    gap, number, start = min(found)
    return number, start, gap
