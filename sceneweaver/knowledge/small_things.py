"""Things of which nobody speaks: which belong to which kind of room, what hangs on its walls and lies on its floor.

From ``small_things.yaml``, ``wall_things.yaml`` and ``lived_in.yaml``.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Literal

from pydantic import Field, field_validator

from sceneweaver.assets import categories
from sceneweaver.scene.base import FrozenModel

from .load import check_known, data_of, room_types
from .model import Range
from .palettes import groups_of

CLUTTER = 0.4
"""How lived-in a room is by default: from 0, a show room, to 1."""


def belongs(category: str, room: str) -> bool:
    """Whether people have a thing in a kind of room when nobody asks for it."""
    rooms = _rooms_of().get(category)
    return rooms is None or room in rooms


def most_of(category: str, room: str) -> int | None:
    """How many of a thing a kind of room has at most when nobody asks for more; None: as many as there is room for."""
    return _most().get(category) if belongs(category, room) else 0


def rooms_named(names: Iterable[str]) -> frozenset[str]:
    """The kinds of rooms of some groups of ``small_things.yaml`` and kinds of rooms."""
    groups = data_of("small_things.yaml")["groups"]
    wanted = set(names)
    members = {name for name, room in room_types().items() if wanted & set(room.things)}
    return frozenset(room for name in wanted for room in groups.get(name, (name,))) | members


@cache
def _rooms_of() -> Mapping[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for row in data_of("small_things.yaml")["belongs"]:
        rooms = rooms_named(row["rooms"])
        found |= {category: rooms | found.get(category, frozenset()) for category in row["what"]}
    check_known("small_things.yaml", found, categories())
    return MappingProxyType(found)


@cache
def _most() -> Mapping[str, int]:
    rows = data_of("small_things.yaml")["most"]
    found = {category: int(count) for count, names in rows.items() for category in names}
    check_known("small_things.yaml", found, categories())
    return MappingProxyType(found)


def wall_things(room: str) -> Mapping[str, float]:
    """Categories that hang on free walls of a kind of room, each with how often it is taken."""
    data = data_of("wall_things.yaml")
    return data["rooms"].get(room) or data["kinds"][groups_of(room)[0]]


def sparse_walls(room: str) -> bool:
    """Whether twice as much of the walls of a kind of room may stay bare as of others."""
    return not {room, groups_of(room)[0]}.isdisjoint(data_of("wall_things.yaml")["sparse"])


def most_on_walls(category: str) -> int | None:
    """How many of a thing hang in a room at most; None: as many as there is room for."""
    return data_of("wall_things.yaml")["most"].get(category)


class Trace(FrozenModel):
    """Something that people leave on the floor beside furniture in a room that is lived in."""

    what: tuple[str, ...] = Field(description="Things, one of which is drawn")
    beside: tuple[str, ...] = Field(description="Categories or groups of furniture that they lie beside, or door")
    sides: tuple[Literal["front", "back", "left", "right"], ...] = ("front",)
    rooms: tuple[str, ...] = Field(default=(), description="Kinds of rooms; none: all")
    clutter: float = Field(ge=0, le=1, description="Clutter from which on there are such traces")
    chance: float = Field(default=1.0, ge=0, le=1)
    count: int = Field(default=1, ge=1)
    gap: Range = (0.03, 0.2)
    turn: float = Field(default=20.0, description="Most the yaw strays at full clutter [degrees]")

    @field_validator("rooms")
    @classmethod
    def _named(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(sorted(rooms_named(value)))


@cache
def traces() -> tuple[Trace, ...]:
    """All traces, in the order of the file."""
    found = tuple(Trace(**row) for row in data_of("lived_in.yaml"))
    check_known("lived_in.yaml", (name for trace in found for name in trace.what), categories())
    return found


@cache
def left_about(category: str, room: str) -> bool:
    """Whether people leave such a thing on the floor of a kind of room."""
    return any(category in t.what and (not t.rooms or room in t.rooms) for t in traces())
