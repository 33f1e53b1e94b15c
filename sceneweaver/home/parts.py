"""The parts of a home: storeys, rooms, doors, windows and stairs.

All rooms of all storeys share one frame: metres, right-handed, z up, the floor of the ground floor at z = 0. A room
keeps its `Scene`, in the same x and y; the z of that scene is counted from the floor of the room's storey.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.scene import Scene
from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.fields import Flag, Id, Index, Length, Name, Number, Offset, Outline
from sceneweaver.scene.messages import FieldError

from .grid import on_grid

DoorKind = Literal["hinged", "double", "sliding", "open"]
"""One leaf, two leaves of half the width, a leaf that slides along the wall, or a passage without a leaf."""


def _gridded(points: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    for k, point in enumerate(points):
        for axis, value in enumerate(point):
            _check_grid(value, (k, axis))
    return points


def _check_grid(value: float, loc: tuple[int, ...] = ()) -> float:
    if not on_grid(value):
        raise FieldError(loc, f"is {value:.9g}; homes lie on a grid of 1 mm, round it to {round(value, 3):g}")
    return value


Mm = Annotated[Length, AfterValidator(_check_grid)]
"""A positive length of whole millimetres [m]."""
MmOffset = Annotated[Offset, AfterValidator(_check_grid)]
"""A length of whole millimetres that may be 0 [m]."""
MmOutline = Annotated[Outline, AfterValidator(_gridded)]
"""A simple counter-clockwise polygon whose corners are whole millimetres [m]."""


class Storey(FrozenModel):
    """A storey: its floor lies ``elevation`` metres above the ground floor's, its ceiling ``height`` above that."""

    id: Id = Field(description="Unique among storeys")
    elevation: Number = Field(default=0.0, description="Of its floor above the ground floor's [m]")
    height: Length = Field(default=2.7, description="From floor to ceiling [m]")


class WallThickness(FrozenModel):
    """How thick walls are [m]: between rooms of a storey, and around it."""

    inner: Mm = 0.1
    outer: Mm = 0.3


class HomeRoom(FrozenModel):
    """A room: the clear floor between the faces of its walls, and what stands in it."""

    id: Id = Field(description="Unique in the home")
    type: Name = Field(default="room", description="Kind of room, such as bedroom; stairs is a stairwell")
    storey: Id = Field(description="The storey that it is on")
    outline: MmOutline = Field(description="Clear floor, corners [x, y] counter-clockwise, in the home's frame [m]")
    outdoor: Flag = Field(default=False, description="A balcony or terrace: no ceiling, railings for walls")
    scene: Scene | None = Field(default=None, description="The furnished room, in the home's x and y; null: empty")

    @property
    def walls(self) -> tuple[Wall, ...]:
        """Its walls in order; wall i runs from corner i to i + 1."""
        return walls_of(self.outline)


class HomeDoor(FrozenModel):
    """A door or passage straight through the wall ``wall`` of ``room``, to another room or out of the home.

    ``hinge`` is the side of the leaf for somebody who comes into ``opens_into``, as in a room's ``in-left``.
    """

    id: Id = Field(description="Unique among doors and windows")
    room: Id = Field(description="The room whose wall it is given by")
    wall: Index = Field(description="Number of the wall of that room's outline")
    offset: MmOffset = Field(description="From that wall's first corner to the opening [m]")
    width: Mm = Field(description="Clear width along the wall [m]")
    height: Length = Field(default=2.0, description="From the floor [m]")
    to: Id | None = Field(default=None, description="The room behind it; null: out of the home")
    kind: DoorKind = Field(default="hinged", description="How it closes")
    opens_into: Id | None = Field(default=None, description="The room into which leaves swing; null: outwards, or none")
    hinge: Literal["left", "right"] = Field(default="left", description="Side of the leaf, coming into opens_into")


class HomeWindow(FrozenModel):
    """A window in an outer wall; ``sill`` is the height of its lower edge above the floor of the storey."""

    id: Id = Field(description="Unique among doors and windows")
    room: Id = Field(description="The room that it lights")
    wall: Index = Field(description="Number of the wall of that room's outline")
    offset: MmOffset = Field(description="From that wall's first corner to the opening [m]")
    width: Mm = Field(description="Along the wall [m]")
    sill: Offset = Field(default=0.9, description="Height of the lower edge [m]")
    height: Length = Field(default=1.3, description="Height of the window itself [m]")


class Stair(FrozenModel):
    """A stair between two stairwells that lie one above the other: rooms of type stairs with the same outline.

    The first flight begins at the edge of ``outline`` that lies against ``up`` and rises along it. ``risers`` steps
    of equal height join the two floors; ``going`` is the depth of a tread.
    """

    id: Id = Field(description="Unique among stairs")
    lower: Id = Field(description="The stairwell in which it begins")
    upper: Id = Field(description="The stairwell in which it ends")
    outline: MmOutline = Field(description="Footprint, counter-clockwise [m]")
    up: tuple[Number, Number] = Field(description="Unit vector of the first flight")
    shape: Literal["straight", "l", "u"] = Field(default="straight", description="One flight, two at an angle, or back")
    width: Mm = Field(description="Of a flight [m]")
    risers: Annotated[int, Field(strict=True, ge=2, le=60)] = Field(description="How many steps")
    going: Mm = Field(description="Depth of a tread [m]")
