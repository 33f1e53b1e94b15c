"""What a home holds (``sceneweaver.home/1``), and how its parts are found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Annotated, Any, Literal

from pydantic import Field

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote, suggest
from sceneweaver.scene.fields import JsonDict, Name, Text
from sceneweaver.scene.limits import MAX_DOORS, MAX_WINDOWS

from .io import SCHEMA, HomeFile
from .limits import MAX_ROOMS, MAX_STAIRS, MAX_STOREYS
from .parts import HomeDoor, HomeRoom, HomeWindow, Stair, Storey, WallThickness


class HomeContent(HomeFile):
    """What a home holds; `Home` checks it as a whole and adds what is derived."""

    schema_: Literal["sceneweaver.home/1"] = Field(default=SCHEMA, alias="schema")
    id: Name = Field(description="Name of the home")
    prompt: Text = Field(default="", description="The request that it answers")
    storeys: Annotated[tuple[Storey, ...], Field(min_length=1, max_length=MAX_STOREYS, fail_fast=True)] = Field(
        default=(Storey(id="ground"),), description="From below"
    )
    walls: WallThickness = Field(default=WallThickness(), description="Thickness of walls [m]")
    rooms: Annotated[tuple[HomeRoom, ...], Field(min_length=1, max_length=MAX_ROOMS, fail_fast=True)] = Field(
        description="Rooms of all storeys"
    )
    doors: Annotated[tuple[HomeDoor, ...], Field(fail_fast=True, max_length=MAX_DOORS)] = ()
    windows: Annotated[tuple[HomeWindow, ...], Field(fail_fast=True, max_length=MAX_WINDOWS)] = ()
    stairs: Annotated[tuple[Stair, ...], Field(fail_fast=True, max_length=MAX_STAIRS)] = ()
    provenance: JsonDict = Field(default_factory=dict, description="Free data: where the home comes from")

    @classmethod
    def _prefix(cls, data: Any) -> str:
        return ""

    @cached_property
    def _positions(self) -> Mapping[str, int]:
        return {room.id: k for k, room in enumerate(self.rooms)}

    def room(self, room_id: str) -> HomeRoom:
        """The room of that id; InputError when there is none."""
        if room_id not in self._positions:
            raise InputError(f"{quote(room_id)} is no room of home {quote(self.id)}{suggest(room_id, self._positions)}")
        return self.rooms[self._positions[room_id]]

    def storey(self, storey_id: str) -> Storey:
        """The storey of that id; InputError when there is none."""
        known = {storey.id: storey for storey in self.storeys}
        if storey_id not in known:
            raise InputError(f"{quote(storey_id)} is no storey of home {quote(self.id)}{suggest(storey_id, known)}")
        return known[storey_id]

    def storey_of(self, room_id: str) -> Storey:
        """The storey that a room is on."""
        return self.storey(self.room(room_id).storey)

    def rooms_of(self, storey_id: str) -> tuple[HomeRoom, ...]:
        """The rooms of a storey, in order."""
        return tuple(room for room in self.rooms if room.storey == self.storey(storey_id).id)

    def doors_of(self, room_id: str) -> Iterator[HomeDoor]:
        """The doors on either side of which a room lies, in order."""
        return (door for door in self.doors if room_id in (door.room, door.to))

    @property
    def entrances(self) -> tuple[HomeDoor, ...]:
        """The doors that lead out of the home, not to a balcony of its own."""
        return tuple(d for d in self.doors if d.to is None and not self.room(d.room).outdoor)
