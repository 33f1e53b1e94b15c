"""Relations as keywords: ``facing=desk``, ``against="north"``, ``between=(a, b)``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sceneweaver.io.messages import show, suggest
from sceneweaver.scene import CATALOGUE, InputError, Room, id_of

SHORT = {"against": "against_wall"}
"""Short names of relation types."""

CARRIED = ("on", "inside")
"""Keywords that say what carries an object; it stands on a surface then, and needs no relation."""


def relation_type(name: str) -> str:
    """The relation type that a keyword names; InputError for an unknown one."""
    found = SHORT.get(name, name)
    if found not in CATALOGUE:
        known = [*CARRIED, *SHORT, *CATALOGUE]
        raise InputError(f"{show(name)} is no relation{suggest(name, known, what='some are')}")
    return found


def require_frame(type: str, params: Mapping[str, Any]) -> None:  # noqa: A002
    """Refuse a left or right that may be either the thing's own or that of who looks at its front.

    Args:
        type: a relation type.
        params: its numbers and words, as given.

    Raises:
        InputError: it names the left or right of a thing, and not whose.
    """
    spec = CATALOGUE[type]
    if "frame" not in spec.params or params.get("frame") is not None:
        return
    side = params.get("side", spec.params["side"].default) if "side" in spec.params else None
    sides = spec.target_sides if side is None else (side,)
    if {"left", "right"} & set(sides):
        raise InputError(
            f'{type}: say whose left and right it is: frame "own" (the thing\'s) or "viewer" (who looks at its front)'
        )


def targets_of(type: str, value: Any, room: Room) -> Iterator[str | tuple[str, str] | None]:  # noqa: A002
    """The targets that the value of a keyword names; several of a list.

    Args:
        type: a relation type.
        value: an object (its handle or id), two of them for ``between``, the id of a door or window, the name of a wall
            (`Room.wall`; "wall" for any), True where no target is needed, None or False for no relation, or a list.
        room: whose walls are meant.

    Raises:
        InputError: a value that is none of these.
    """
    spec = CATALOGUE[type]
    if value is None or value is False:
        return
    if value is True:
        if not spec.target_optional:
            raise InputError(f"{type}: say of what ({spec.target_kind}); True is no target")
        yield None
    elif spec.target_kind == "objects":
        if not isinstance(value, list | tuple) or len(value) != 2:
            raise InputError(f"{type} is {show(value)}; give two objects")
        yield id_of(value[0]), id_of(value[1])
    elif isinstance(value, list | tuple):
        for each in value:
            yield from targets_of(type, each, room)
    elif spec.target_kind == "wall":
        yield None if value == "wall" and spec.target_optional else f"wall:{room.wall(value)}"
    else:
        yield id_of(value)
