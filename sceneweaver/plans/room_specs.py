"""Rooms of a programme, and what two of them are to each other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import BeforeValidator, model_validator

from sceneweaver.io.messages import is_number, show, suggest
from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.fields import Flag, Id, Index, Length, Name, Weight
from sceneweaver.scene.messages import FieldError

from .room_types import RoomType, room_type, room_types

SPREAD = (0.8, 1.3)
"""Least and most area by the target, where only the target is given."""

AdjacencyKind = Literal["door", "open", "near", "apart"]


def _area(value: Any) -> Any:
    """[least, target, most] of one number (the target), two (least and most) or three."""
    if is_number(value):
        return (round(value * SPREAD[0], 2), float(value), round(value * SPREAD[1], 2))
    if isinstance(value, list | tuple) and all(map(is_number, value)):
        if len(value) == 2:
            return (float(value[0]), (value[0] + value[1]) / 2, float(value[1]))
        if len(value) == 3:
            return tuple(map(float, value))
    raise FieldError((), f"is {show(value)}; give the target, or [least, most], or [least, target, most] in m2")


Area = Annotated[tuple[Length, Length, Length], BeforeValidator(_area)]


class RoomSpec(FrozenModel):
    """A room of a programme.

    Attributes:
        id: of the room, also in the home that is planned.
        type: of the room, see `sceneweaver.plans.room_types`.
        area: (least, target, most) floor between the walls [m2]; of the type where it is not given.
        side: least clear width [m]; None: what the profile asks for.
        storey: 0 is the ground floor; None: any.
        daylight: whether it needs a window; None: as its type.
    """

    _noun = "room"

    id: Id
    type: Name
    area: Area
    side: Length | None = None
    storey: Index | None = None
    daylight: Flag | None = None

    @model_validator(mode="before")
    @classmethod
    def _filled(cls, data: Any) -> Any:
        if isinstance(data, Mapping) and data.get("area") is None:
            kind = room_types().get(str(data.get("type")))
            return {**data, "area": kind.area if kind else (1.0, 1.0, 1.0)}
        return data

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.type not in room_types():
            raise FieldError(("type",), f"is {show(self.type)}{suggest(self.type, room_types(), what='types are')}")
        least, target, most = self.area
        if not least <= target <= most:
            raise FieldError(("area",), f"is [{least:g}, {target:g}, {most:g}]; least, target and most must rise")
        if self.side is not None and self.side**2 > most:
            raise FieldError(("side",), f"is {self.side:g} m, but area is at most {most:g} m2; make one fit the other")
        return self

    def at_storey(self, storey: int) -> Self:
        """The room on a storey."""
        return type(self)(**{**{name: getattr(self, name) for name in type(self).model_fields}, "storey": storey})

    @property
    def kind(self) -> RoomType:
        """What its type is to a plan."""
        return room_type(self.type)

    @property
    def needs_daylight(self) -> bool:
        """Whether it needs a window of its own or an open passage to a room with one."""
        return "daylight" in self.kind.roles if self.daylight is None else self.daylight


class Adjacency(FrozenModel):
    """What two rooms ``a`` and ``b`` are to each other.

    ``door``: a door or an open passage joins them. ``open``: an open passage does. ``near``: they share a wall.
    ``apart``: they neither share a wall nor a door. Those that are not ``hard`` cost ``weight`` where they fail.
    """

    _noun = "adjacency"

    a: Id
    b: Id
    kind: AdjacencyKind = "door"
    hard: Flag = True
    weight: Weight = 1.0

    @model_validator(mode="before")
    @classmethod
    def _from_list(cls, data: Any) -> Any:
        if isinstance(data, list | tuple) and 2 <= len(data) <= 3:
            return dict(zip(("a", "b", "kind"), data, strict=False))
        return data
