"""Which kind of room of the knowledge base a room of a plan is furnished as."""

from __future__ import annotations

from sceneweaver.knowledge import RoomType, match_room
from sceneweaver.knowledge.learned import all_rooms
from sceneweaver.plans.room_types import room_types

UNKNOWN = "storage_room"
"""What a room is furnished as whose type says nothing."""


def kind_of(plan_type: str) -> RoomType | None:
    """The kind of room that a type of rooms in plans is furnished as; None: it stays empty, as a stairwell.

    Types that plans do not know, as homes of other systems have them, are looked up by their words.

    Examples:
        >>> from sceneweaver.furnish.kinds import kind_of
        >>> kind_of("entrance_hall").name, kind_of("stairs"), kind_of("sitting room").name
        ('hallway', None, 'living_room')
    """
    known, name = all_rooms(), plan_type.lower().replace(" ", "_")
    if name in room_types():
        chosen = room_types()[name].furnish
        return None if chosen is None else known[chosen]
    if name in known:
        return known[name]
    found = match_room(name.replace("_", " "))
    return known[found[0] if found is not None else UNKNOWN]
