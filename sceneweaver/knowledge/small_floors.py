"""What a kind of room holds where its floor is small and given: fewer and smaller things, all that it is for."""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Any

from pydantic import Field

from sceneweaver.scene.base import FrozenModel

from .load import data_of
from .model import Item, RoomType


class SmallFloor(FrozenModel):
    """A row of ``small_floors.yaml``."""

    rooms: tuple[str, ...] = Field(description="Kinds of rooms")
    below: float = Field(gt=0, description="Floor [m2] under which it holds")
    leave_out: tuple[str, ...] = Field(default=(), description="Items that are not there, nor what goes with them")
    items: dict[str, dict[str, Any]] = Field(default={}, description="What of an item is otherwise, by its id")
    add: tuple[Item, ...] = Field(default=(), description="Items in the place of others of the same id")


@cache
def small_floors() -> tuple[SmallFloor, ...]:
    """All rows, in their order."""
    return tuple(SmallFloor(**row) for row in data_of("small_floors.yaml"))


def on_floor(room_type: RoomType, area: float) -> RoomType:
    """A kind of room as it is furnished on a floor of some area [m2] that cannot grow.

    Examples:
        >>> from sceneweaver.knowledge import room_types
        >>> from sceneweaver.knowledge.small_floors import on_floor
        >>> bath = room_types()["bathroom"]
        >>> [item.id for item in on_floor(bath, 4.0).items if item.id in ("tub", "shower")]
        ['shower']
    """
    items = room_type.items
    for row in small_floors():
        if room_type.name in row.rooms and area < row.below:
            items = _changed(_left(items, {*row.leave_out, *(item.id for item in row.add)}), row.items) + row.add
    return room_type if items == room_type.items else room_type.model_copy(update={"items": items})


def _left(items: tuple[Item, ...], gone: Collection[str]) -> tuple[Item, ...]:
    """The items without some, and without what goes with those or is told to be at them."""
    names = set(gone)
    while more := {i.id for i in items if i.with_ in names} - names:
        names |= more
    kept = [item for item in items if item.id not in names]
    ids = {item.id for item in kept}
    return tuple(
        item.model_copy(
            update={
                "place": tuple(p for p in item.place if p.to is None or p.to not in names),
                "on": tuple(name for name in item.on if name in ids),
            }
        )
        if names & {*(p.to for p in item.place), *item.on}
        else item
        for item in kept
    )


def _changed(items: tuple[Item, ...], changes: dict[str, dict[str, Any]]) -> tuple[Item, ...]:
    known = {name: Item.model_validate({"id": name, "what": "x", **change}) for name, change in changes.items()}
    return tuple(
        item.model_copy(update={key: getattr(known[item.id], key) for key in changes[item.id]})
        if item.id in changes
        else item
        for item in items
    )
