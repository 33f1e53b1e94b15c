"""Which kind of room of the knowledge base a room of a plan is furnished as."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from sceneweaver.io.packaged import yaml_data
from sceneweaver.knowledge import RoomType, match_room
from sceneweaver.knowledge.learned import all_rooms

UNKNOWN = "storage_room"
"""What a room is furnished as whose type says nothing."""


@cache
def _told() -> Mapping[str, str | None]:
    return yaml_data("sceneweaver.furnish", "kinds.yaml")


def kind_of(plan_type: str) -> RoomType | None:
    """The kind of room that a type of rooms in plans is furnished as; None: it stays empty, as a stairwell.

    Examples:
        >>> from sceneweaver.furnish.kinds import kind_of
        >>> kind_of("hall").name, kind_of("stairs")
        ('hallway', None)
    """
    known, told = all_rooms(), _told()
    name = plan_type.lower().replace(" ", "_")
    if name in told:
        chosen = told[name]
        return None if chosen is None else known[chosen]
    if name in known:
        return known[name]
    found = match_room(name.replace("_", " "))
    return known[found[0] if found is not None else UNKNOWN]
