"""What the parts of a home refer to: rooms on storeys, openings in walls, stairwells one above the other."""

from __future__ import annotations

import math
from collections.abc import Iterable

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote, suggest
from sceneweaver.scene import Room
from sceneweaver.scene.messages import FieldError

from .content import HomeContent
from .shells import room_shell

SAME = 1e-6
"""How far [m] the room of a scene may be from the home's: rounding, no more."""


def check_references(home: HomeContent) -> None:
    """Refuse a home whose parts do not fit together.

    Raises:
        FieldError: with the part, and what to do.
    """
    for key, named in (("storeys", home.storeys), ("rooms", home.rooms), ("stairs", home.stairs)):
        _check_unique(key, (part.id for part in named))
    _check_unique("windows", [*(d.id for d in home.doors), *(w.id for w in home.windows)], len(home.doors))
    rooms, storeys = {r.id: r for r in home.rooms}, {s.id for s in home.storeys}
    for k, (below, above) in enumerate(zip(home.storeys, home.storeys[1:], strict=False)):
        if above.elevation < below.elevation + below.height - SAME:
            least = below.elevation + below.height
            raise FieldError(
                ("storeys", k + 1, "elevation"), f"is {above.elevation:g}; at least {least:g}, over the one below"
            )
    for k, room in enumerate(home.rooms):
        if room.storey not in storeys:
            raise FieldError(("rooms", k, "storey"), f"is {quote(room.storey)}{suggest(room.storey, storeys)}")
    for key, openings in (("doors", home.doors), ("windows", home.windows)):
        for k, opening in enumerate(openings):
            if opening.room not in rooms:
                raise FieldError((key, k, "room"), f"is {quote(opening.room)}{suggest(opening.room, rooms)}")
            if opening.wall >= len(rooms[opening.room].outline):
                most = len(rooms[opening.room].outline) - 1
                raise FieldError((key, k, "wall"), f"is {opening.wall}; {quote(opening.room)} has walls 0 to {most}")
    for k, door in enumerate(home.doors):
        if door.to is not None and (door.to not in rooms or door.to == door.room):
            raise FieldError(("doors", k, "to"), f"is {quote(door.to)}; give another room, or null for out of the home")
        if door.to is not None and rooms[door.to].storey != rooms[door.room].storey:
            raise FieldError(("doors", k, "to"), f"is {quote(door.to)}, on another storey; only stairs join storeys")
        if door.opens_into is not None and door.opens_into not in (door.room, door.to):
            raise FieldError(
                ("doors", k, "opens_into"), f"is {quote(door.opens_into)}; give a room of the door, or null"
            )
    _check_stairs(home)
    for k, room in enumerate(home.rooms):
        try:
            shell = room_shell(home, room.id)
        except InputError as error:
            raise FieldError(("rooms", k), f": {error}") from None
        if room.scene is not None:
            said = _difference(shell, room.scene.room)
            if said:
                raise FieldError(
                    ("rooms", k, "scene"), f"has another room than the home: {said}; start from home.shell({room.id!r})"
                )


def _check_unique(key: str, names: Iterable[str], skipped: int = 0) -> None:
    seen: set[str] = set()
    for k, name in enumerate(names):
        if name in seen:
            raise FieldError((key, max(0, k - skipped), "id"), f"is {quote(name)}, which is there before; rename one")
        seen.add(name)


def _check_stairs(home: HomeContent) -> None:
    rooms = {r.id: r for r in home.rooms}
    order = {s.id: k for k, s in enumerate(home.storeys)}
    for k, stair in enumerate(home.stairs):
        for end in ("lower", "upper"):
            name = getattr(stair, end)
            if name not in rooms or rooms[name].type != "stairs":
                raise FieldError(("stairs", k, end), f"is {quote(name)}; give a room of type stairs")
        if order[rooms[stair.upper].storey] != order[rooms[stair.lower].storey] + 1:
            raise FieldError(
                ("stairs", k, "upper"), f"is {quote(stair.upper)}; it lies on the storey over the lower one"
            )
        if abs(math.hypot(*stair.up) - 1) > 1e-6:
            raise FieldError(("stairs", k, "up"), f"has length {math.hypot(*stair.up):g}; give a unit vector")


def _difference(shell: Room, other: Room) -> str:
    """What of a scene's room is not as the home has it; empty: nothing."""
    if len(shell.outline) != len(other.outline) or any(
        math.dist(a, b) > SAME for a, b in zip(shell.outline, other.outline, strict=True)
    ):
        return "the outline differs"
    if abs(shell.height - other.height) > SAME:
        return f"it is {other.height:g} m high, the storey {shell.height:g} m"
    for noun, ours, theirs in (("door", shell.doors, other.doors), ("window", shell.windows, other.windows)):
        mine, given = {o.id: o for o in ours}, {o.id: o for o in theirs}
        for name in [*mine, *given]:
            if name not in mine or name not in given:
                return f"{noun} {quote(name)} is only in {'the home' if name in mine else 'the scene'}"
            a, b = mine[name].model_dump(), given[name].model_dump()
            for field, value in a.items():
                same = abs(value - b[field]) <= SAME if isinstance(value, float) else value == b[field]
                if not same:
                    return f"{field} of {noun} {quote(name)} is {b[field]}, not {value}"
    return ""
