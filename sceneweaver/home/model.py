"""The home itself: rooms on storeys, and the doors, windows and stairs that join them."""

from __future__ import annotations

from typing import Any, Self

from pydantic import model_validator

from sceneweaver.scene import Room, Scene

from .content import HomeContent
from .references import check_references
from .shells import room_shell


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
