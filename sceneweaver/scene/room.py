"""The room of a scene with its doors and windows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from sceneweaver.geometry.shell import heights
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, quote, show, suggest

from .base import FrozenModel
from .fields import Id, Index, Length, Name, Offset, Outline
from .finish import RoomFinish, RoomLight
from .limits import MAX_DOORS, MAX_WINDOWS
from .messages import FieldError

FIT_TOLERANCE = 1e-6
"""How far [m] an opening may stand over its wall's end or the ceiling: rounding, no more."""

SHARED = 1e-3
"""How far [m] two openings of one wall may reach into each other, or differ and still fill the same place."""


Swing = Literal["in-left", "in-right", "out", "slide"]


class Door(FrozenModel):
    """A door in wall ``wall``, starting ``offset`` metres after the wall's first corner."""

    id: Id = Field(description="Unique among doors, windows and objects")
    wall: Index = Field(description="Number of the wall, from 0; wall i runs from corner i to corner i + 1")
    offset: Offset = Field(description="Distance from the wall's first corner to the opening [m]")
    width: Length = Field(description="Width along the wall [m]")
    height: Length = Field(description="Height from the floor [m]")
    swing: Swing = Field(
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


COMPASS = {"south": (0.0, -1.0), "east": (1.0, 0.0), "north": (0.0, 1.0), "west": (-1.0, 0.0)}
"""Names of walls, and which way out of the room they lie: north is +y, east +x."""


class Room(FrozenModel):
    """The room: a simple outline, counter-clockwise; wall i runs from corner i to corner i + 1.

    Corners are [x, y] in metres. An opening outside of its wall or partly where another one is, or an outline that is
    not simple, is an `InputError`.

    Examples:
        >>> import sceneweaver as sw
        >>> room = sw.Room.rectangle(4, 5, height=2.6, kind="bedroom").with_door("south", at=0.2).with_window("north")
        >>> room.doors[0].offset, room.wall("north")
        (0.62, 2)
    """

    type: Name = Field(default="room", description="Kind of room, such as bedroom")
    outline: Outline = Field(description="Corners [x, y] of the floor in counter-clockwise order [m]")
    height: Length = Field(default=2.7, description="Height of the ceiling above the floor [m]")
    doors: Annotated[tuple[Door, ...], Field(fail_fast=True, max_length=MAX_DOORS)] = Field(
        default=(), description="Doors in its walls"
    )
    windows: Annotated[tuple[Window, ...], Field(fail_fast=True, max_length=MAX_WINDOWS)] = Field(
        default=(), description="Windows in its walls"
    )
    finish: RoomFinish | None = Field(default=None, description="Of walls and floor; null: by the kind of room")
    light: RoomLight | None = Field(default=None, description="The light it is shown in; null: an even day")

    @classmethod
    def rectangle(cls, width: float, depth: float, *, height: float = 2.7, kind: str = "room") -> Self:
        """A rectangular room: ``width`` metres along x, ``depth`` along y, its first corner at the origin."""
        return cls.polygon([(0, 0), (width, 0), (width, depth), (0, depth)], height=height, kind=kind)

    @classmethod
    def l_shape(
        cls,
        width: float,
        depth: float,
        *,
        cut: tuple[float, float],
        corner: Literal["south-west", "south-east", "north-east", "north-west"] = "north-east",
        height: float = 2.7,
        kind: str = "room",
    ) -> Self:
        """A rectangle without one of its corners.

        Args:
            width, depth: of the whole rectangle along x and y [m].
            cut: width and depth [m] of what is missing.
            corner: which one is missing; north is +y, east +x.
            height: of the ceiling [m].
            kind: of room, such as bedroom.
        """
        if not isinstance(cut, list | tuple) or len(cut) != 2:
            raise InputError(f"cut is {show(cut)}; give width and depth of what is missing")
        sides = (*cut, width, depth)
        if not all(map(is_number, sides)):
            raise InputError(f"width, depth and cut are {show(width)}, {show(depth)} and {show(cut)}; give metres")
        a, b, w, d = sides
        if not (0 < a < w and 0 < b < d):
            raise InputError(f"cut is {show(cut)}; it must be smaller than the room, {w:g} x {d:g} m, and above 0")
        notches = {
            "south-west": [(0, b), (a, b), (a, 0), (w, 0), (w, d), (0, d)],
            "south-east": [(0, 0), (w - a, 0), (w - a, b), (w, b), (w, d), (0, d)],
            "north-east": [(0, 0), (w, 0), (w, d - b), (w - a, d - b), (w - a, d), (0, d)],
            "north-west": [(0, 0), (w, 0), (w, d), (a, d), (a, d - b), (0, d - b)],
        }
        if corner not in notches:
            raise InputError(f"corner is {show(corner)}{suggest(corner, notches)}")
        return cls.polygon(notches[corner], height=height, kind=kind)

    @classmethod
    def polygon(cls, outline: Sequence[Sequence[float]], *, height: float = 2.7, kind: str = "room") -> Self:
        """A room of any simple outline: corners (x, y) [m], counter-clockwise."""
        try:
            corners = tuple((float(x), float(y)) for x, y in outline)
        except (TypeError, ValueError):
            raise InputError(f"outline is {show(outline)}; give corners (x, y)") from None
        return cls(type=kind, outline=corners, height=height)

    def with_door(
        self,
        wall: int | str = 0,
        *,
        at: float = 0.5,
        width: float = 0.9,
        height: float = 2.0,
        swing: Swing = "in-left",
        name: str | None = None,
    ) -> Self:
        """The room with one door more.

        Args:
            wall: its number, "wall:k", or a compass point, see `wall`.
            at: where along the wall, 0 to 1: in its first corner, in the middle (0.5), in its second.
            width, height: of the opening [m].
            swing: how it opens; in-left and in-right need a square of its width free inside.
            name: its id; None: door-0, door-1 ...
        """
        where = self._opening("door", wall, at, width, name)
        return self._rebuilt(doors=(*self.doors, Door(**where, height=height, swing=swing)))

    def with_window(
        self,
        wall: int | str = 0,
        *,
        at: float = 0.5,
        width: float = 1.2,
        height: float = 1.2,
        sill: float = 0.9,
        name: str | None = None,
    ) -> Self:
        """The room with one window more, its lower edge ``sill`` metres above the floor; else as `with_door`."""
        where = self._opening("window", wall, at, width, name)
        return self._rebuilt(windows=(*self.windows, Window(**where, sill=sill, height=height)))

    def wall(self, name: int | str) -> int:
        """The number of a wall by a name: a number, "wall:k", or north (+y), south, east (+x) or west.

        Of several walls on one side the longest is meant.

        Raises:
            InputError: no such wall.
        """
        known = [*COMPASS, *(f"wall:{k}" for k in range(len(self.outline)))]
        if isinstance(name, int) and not isinstance(name, bool) and 0 <= name < len(self.outline):
            return name
        if isinstance(name, str) and name.startswith("wall:") and name in known:
            return known.index(name) - len(COMPASS)
        if isinstance(name, str) and name in COMPASS:
            x, y = COMPASS[name]
            fitting = [w for w in self.walls if w.outward[0] * x + w.outward[1] * y > 0.7]
            if fitting:
                return max(fitting, key=lambda w: round(w.length, 6)).index
        raise InputError(f"there is no wall {show(name)}{suggest(str(name), known, what='the walls are')}")

    def _opening(self, noun: str, wall: int | str, at: float, width: float, name: str | None) -> dict[str, Any]:
        """What doors and windows have in common."""
        number = self.wall(wall)
        if not is_number(at) or not 0 <= at <= 1:
            raise InputError(f"{noun}: at is {show(at)}; give a share of the wall, 0 to 1")
        if not is_number(width):
            raise InputError(f"{noun}: width is {show(width)}; give metres")
        free = self.walls[number].length - width
        if free < -FIT_TOLERANCE:
            raise InputError(f"{noun}: width is {width:g} m, but wall {number} is {width + free:.6g} m long")
        taken = {o.id for o in self.openings}
        numbered = (f"{noun}-{k}" for k in range(len(taken) + 1))
        fresh = next(text for text in numbered if text not in taken) if name is None else name
        return {"id": fresh, "wall": number, "offset": round(max(0.0, free * at), 6), "width": width}

    def _rebuilt(self, **changes: Any) -> Self:
        """The room with some fields changed, checked as a new one."""
        return type(self)(**{**{name: getattr(self, name) for name in type(self).model_fields}, **changes})

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
        for first, second in self._in_one_place():
            if not _same(first, second):
                key, known = ("doors", self.doors) if second in self.doors else ("windows", self.windows)
                there = f"{quote(first.id)} is partly in the same place of wall {second.wall}"
                raise FieldError((key, known.index(second)), f": {there}; move one of them")
        return self

    @property
    def doubled(self) -> list[tuple[Door | Window, Door | Window]]:
        """Openings that fill the very same place of their wall, as one that is listed twice; the later one second."""
        return [pair for pair in self._in_one_place() if _same(*pair)]

    def _in_one_place(self) -> Iterator[tuple[Door | Window, Door | Window]]:
        """Pairs of openings that reach into each other, in the order in which they are listed."""
        order = {id(opening): k for k, opening in enumerate(self.openings)}
        open_ones: list[Door | Window] = []
        for opening in sorted(self.openings, key=lambda o: (o.wall, o.offset)):
            open_ones = [
                o for o in open_ones if o.wall == opening.wall and o.offset + o.width > opening.offset + SHARED
            ]
            low, high = heights(opening)
            for other in open_ones:
                bottom, top = heights(other)
                if min(top, high) - max(low, bottom) > SHARED and opening.width > SHARED:
                    first, second = sorted((other, opening), key=lambda o: order[id(o)])
                    yield first, second
            open_ones.append(opening)


def _same(a: Door | Window, b: Door | Window) -> bool:
    """Whether two openings of a wall fill the same place."""
    ends = ((o.offset, o.offset + o.width, *heights(o)) for o in (a, b))
    return all(abs(x - y) <= SHARED for x, y in zip(*ends, strict=True))
