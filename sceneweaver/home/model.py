"""The home itself: rooms on storeys, and the doors, windows and stairs that join them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, Self

from pydantic import model_validator

from sceneweaver.io import InputError
from sceneweaver.io.messages import show
from sceneweaver.scene import Room, Scene

from .content import HomeContent
from .joints import place_between, place_in_wall
from .parts import DoorKind, HomeDoor, HomeRoom, HomeWindow, WallThickness
from .references import check_references
from .shells import room_shell

Rectangle = tuple[float, float, float, float]
"""Least x, least y, greatest x, greatest y [m]."""


class Home(HomeContent):
    """A whole home. Immutable: what changes it returns a new one.

    Making one checks what its parts refer to; whether it is a good plan `sceneweaver.plans.check_plan` says.

    Examples:
        >>> import sceneweaver as sw
        >>> home = sw.Home.example("flat")
        >>> [room.type for room in home.rooms][:3], len(home.doors)
        (['hall', 'living_room', 'kitchen'], 6)
        >>> home.shell("bath").doors[0].swing, home.loads(home.dumps()) == home
        ('in-left', True)
    """

    @model_validator(mode="after")
    def _check(self) -> Self:
        check_references(self)
        return self

    def __repr__(self) -> str:
        furnished = sum(room.scene is not None for room in self.rooms)
        return f"Home({self.id!r}: {len(self.rooms)} rooms, {furnished} furnished, {len(self.doors)} doors)"

    __str__ = __repr__

    @classmethod
    def of_rooms(
        cls,
        rooms: Mapping[str, Rectangle | Sequence[tuple[float, float]]],
        *,
        kinds: Mapping[str, str] | None = None,
        name: str = "home",
        walls: tuple[float, float] = (0.1, 0.3),
    ) -> Self:
        """A home of one storey whose rooms have no openings yet.

        Args:
            rooms: by id the clear floor: (least x, least y, greatest x, greatest y) or corners counter-clockwise [m].
            kinds: by id the kind of room; a room that is not named is of the kind of its id up to a "-".
            name: id of the home.
            walls: thickness [m] between rooms and around them.

        Examples:
            >>> import sceneweaver as sw
            >>> home = sw.Home.of_rooms({"hall": (0, 0, 1.5, 4), "bedroom": (1.6, 0, 5, 4)})
            >>> home = home.with_door("hall", None, wall="south").with_door("hall", "bedroom", width=0.8, at=0.2)
            >>> home = home.with_window("bedroom", "east", width=1.6)
            >>> home.shell("bedroom").doors[0].swing, home.windows[0].offset
            ('in-left', 1.2)
        """
        kinds = kinds or {}
        parts = [
            HomeRoom(id=key, type=kinds.get(key, key.split("-")[0]), storey="ground", outline=_outline(key, given))
            for key, given in rooms.items()
        ]
        return cls(id=name, rooms=tuple(parts), walls=WallThickness(inner=walls[0], outer=walls[1]))

    def with_door(
        self,
        room: str,
        to: str | None,
        *,
        wall: int | str | None = None,
        at: float = 0.5,
        width: float = 0.9,
        height: float = 2.0,
        kind: DoorKind = "hinged",
        opens_into: str | None = None,
        hinge: Literal["left", "right"] = "left",
        name: str | None = None,
    ) -> Self:
        """The home with one door more.

        Args:
            room: the room whose wall it is given by.
            to: the room behind it, beside ``room``; None: out of the home, which needs ``wall``.
            wall: for a door out: number, "wall:k" or a compass point, as in `Room.wall`.
            at: where along the wall, or along what the two rooms share of it: 0 to 1.
            width, height: of the opening [m].
            kind: hinged, double, sliding or open.
            opens_into: the room into which it swings; None: ``to``, and ``room`` for a door out.
            hinge: side of the leaf for somebody who comes into ``opens_into``.
            name: its id; None: door-0, door-1 ...

        Raises:
            InputError: the rooms share no wall, or none that is as long.
        """
        if to is None:
            index = self._wall(room, wall)
            offset = place_in_wall(self.room(room), index, at, width)
        else:
            index, offset = place_between(self, room, to, at, width)
        swings = kind in ("hinged", "double")
        door = HomeDoor(
            id=self._fresh("door") if name is None else name,
            room=room,
            wall=index,
            offset=offset,
            width=width,
            height=height,
            to=to,
            kind=kind,
            opens_into=(opens_into or to or room) if swings else None,
            hinge=hinge,
        )
        return self.with_changes(doors=(*self.doors, door))

    def with_window(
        self,
        room: str,
        wall: int | str,
        *,
        at: float = 0.5,
        width: float = 1.2,
        height: float = 1.3,
        sill: float = 0.9,
        name: str | None = None,
    ) -> Self:
        """The home with one window more in a wall of a room: number, "wall:k" or a compass point; else as a door."""
        index = self._wall(room, wall)
        window = HomeWindow(
            id=self._fresh("window") if name is None else name,
            room=room,
            wall=index,
            offset=place_in_wall(self.room(room), index, at, width),
            width=width,
            sill=sill,
            height=height,
        )
        return self.with_changes(windows=(*self.windows, window))

    def _wall(self, room: str, wall: int | str | None) -> int:
        if wall is None:
            raise InputError("a door out of the home needs wall; give its number or a compass point")
        return self.shell(room).wall(wall)

    def _fresh(self, noun: str) -> str:
        taken = {o.id for o in (*self.doors, *self.windows)}
        return next(name for k in range(len(taken) + 1) if (name := f"{noun}-{k}") not in taken)

    def shell(self, room_id: str) -> Room:
        """A room with its doors, also those given by the other room, and windows, as a `Room` in the home's frame.

        Ids of openings are those of the home. A door swings ``in-left`` or ``in-right`` in the room into which it
        opens and ``out`` in the other; sliding doors and open passages ``slide`` in both.
        """
        return room_shell(self, room_id)

    def with_scene(self, room_id: str, scene: Scene | None) -> Self:
        """The home with a room furnished, or emptied; InputError where the scene's room is not the home's."""
        self.room(room_id)
        rooms = tuple(r.model_copy(update={"scene": scene}) if r.id == room_id else r for r in self.rooms)
        return self.with_changes(rooms=rooms)

    def with_changes(self, **changes: Any) -> Self:
        """The home with some fields changed, checked as a new one."""
        kept = {name: getattr(self, name) for name in type(self).model_fields if name != "schema_"}
        return type(self)(**{**kept, **changes})

    def graph(self) -> dict[str, list[tuple[str, str]]]:
        """For each room the (room, door or stair) pairs that one can go on to, in order; doors out are left out."""
        found: dict[str, list[tuple[str, str]]] = {room.id: [] for room in self.rooms}
        joints = [(d.room, d.to, d.id) for d in self.doors if d.to is not None]
        for a, b, name in [*joints, *((s.lower, s.upper, s.id) for s in self.stairs)]:
            found[a].append((b, name))
            found[b].append((a, name))
        return found


def _outline(name: str, given: Rectangle | Sequence[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    if len(given) == 4 and all(isinstance(v, int | float) for v in given):
        x0, y0, x1, y1 = map(float, given)  # pyright: ignore[reportArgumentType] - four numbers
        if not (x0 < x1 and y0 < y1):
            raise InputError(f"room {name}: is {show(tuple(given))}; give least x, least y, greatest x, greatest y")
        return (x0, y0), (x1, y0), (x1, y1), (x0, y1)
    try:
        return tuple((float(x), float(y)) for x, y in given)  # pyright: ignore[reportGeneralTypeIssues]
    except (TypeError, ValueError):
        raise InputError(f"room {name}: is {show(given)}; give four numbers, or corners (x, y)") from None
