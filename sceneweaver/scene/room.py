"""The room of a scene with its doors and windows."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from sceneweaver.geometry.shell import heights
from sceneweaver.geometry.walls import Wall, walls_of

from .base import FrozenModel
from .fields import Id, Index, Length, Name, Offset, Outline
from .finish import RoomFinish
from .messages import FieldError

FIT_TOLERANCE = 1e-6
"""How far [m] an opening may stand over its wall's end or the ceiling: rounding, no more."""


class Door(FrozenModel):
    """A door in wall ``wall``, starting ``offset`` metres after the wall's first corner."""

    id: Id = Field(description="Unique among doors, windows and objects")
    wall: Index = Field(description="Number of the wall, from 0; wall i runs from corner i to corner i + 1")
    offset: Offset = Field(description="Distance from the wall's first corner to the opening [m]")
    width: Length = Field(description="Width along the wall [m]")
    height: Length = Field(description="Height from the floor [m]")
    swing: Literal["in-left", "in-right", "out", "slide"] = Field(
        default="in-left", description="How it opens; in-left and in-right need a square of its width free inside"
    )


class Window(FrozenModel):
    """A window in wall ``wall``; ``sill`` is the height of its lower edge."""

    id: Id = Field(description="Unique among doors, windows and objects")
    wall: Index = Field(description="Number of the wall, from 0; wall i runs from corner i to corner i + 1")
    offset: Offset = Field(description="Distance from the wall's first corner to the opening [m]")
    width: Length = Field(description="Width along the wall [m]")
    sill: Offset = Field(description="Height of the lower edge above the floor [m]")
    height: Length = Field(description="Height of the window itself [m]")


class Room(FrozenModel):
    """The room: a simple outline, counter-clockwise; wall i runs from corner i to corner i + 1.

    Corners are [x, y] in metres. An opening outside of its wall, or an outline that is not simple, is an `InputError`.

    Examples:
        >>> import sceneweaver as sw
        >>> door = {"id": "door", "wall": 0, "offset": 0.5, "width": 0.9, "height": 2.0}
        >>> room = sw.Room(outline=[(0, 0), (4, 0), (4, 3), (0, 3)], doors=[door])
        >>> [wall.length for wall in room.walls], room.height
        ([4.0, 3.0, 4.0, 3.0], 2.7)
    """

    type: Name = Field(default="room", description="Kind of room, such as bedroom")
    outline: Outline = Field(description="Corners [x, y] of the floor in counter-clockwise order [m]")
    height: Length = Field(default=2.7, description="Height of the ceiling above the floor [m]")
    doors: Annotated[tuple[Door, ...], Field(fail_fast=True)] = Field(default=(), description="Doors in its walls")
    windows: Annotated[tuple[Window, ...], Field(fail_fast=True)] = Field(
        default=(), description="Windows in its walls"
    )
    finish: RoomFinish | None = Field(default=None, description="Of walls and floor; null: by the kind of room")

    @property
    def walls(self) -> tuple[Wall, ...]:
        """The walls in order."""
        return walls_of(self.outline)

    @property
    def openings(self) -> tuple[Door | Window, ...]:
        """Doors, then windows."""
        return *self.doors, *self.windows

    def openings_of(self, wall: int) -> list[Door | Window]:
        """The doors, then the windows of one wall."""
        return [o for o in self.openings if o.wall == wall]

    @model_validator(mode="after")
    def _check(self) -> Self:
        """Doors, windows and finishes are in a wall that exists, openings within its length and height."""
        walls = self.walls
        for part, wall in self.finish.named_walls if self.finish is not None else ():
            if wall >= len(walls):
                known = f"the outline has walls 0 to {len(walls) - 1}"
                raise FieldError(("finish", part, "walls"), f": there is no wall {wall}; {known}")
        for key, openings in (("doors", self.doors), ("windows", self.windows)):
            for i, opening in enumerate(openings):
                if opening.wall >= len(walls):
                    known = f"the outline has walls 0 to {len(walls) - 1}"
                    raise FieldError((key, i, "wall"), f"is {opening.wall}; {known}")
                length = walls[opening.wall].length
                end = opening.offset + opening.width
                if end > length + FIT_TOLERANCE:
                    fix = f"wall {opening.wall} is {length:.6g} m long; move it or make it narrower"
                    raise FieldError((key, i), f": offset + width is {end:.6g} m, but {fix}")
                _, top = heights(opening)
                if top > self.height + FIT_TOLERANCE:
                    what = "sill + height" if key == "windows" else "height"
                    fix = f"the room is {self.height:.6g} m high; make it lower"
                    raise FieldError((key, i), f": {what} is {top:.6g} m, but {fix}")
        return self
