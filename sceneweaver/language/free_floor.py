"""Free floor that a request states, as a free area of a scene: entities become the objects that stand for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sceneweaver.scene import FreeArea as SceneArea
from sceneweaver.scene import Room

from .model import PLACES, FreeArea, SceneGraph
from .things import singular


def alike(brief: SceneGraph, entity_id: str) -> tuple[str, ...]:
    """The ids of all entities that a noun names: of "two copiers", read as one and one, both."""
    own = brief.entity(entity_id)
    if own is None:
        return (entity_id,)
    noun = singular(own.noun).split()[-1]
    return tuple(e.id for e in brief.entities if e.category == own.category and singular(e.noun).split()[-1] == noun)


def scene_area(asked: FreeArea, ids_of: Callable[[str], Sequence[str]], room: Room) -> SceneArea | None:
    """The free area of a scene that a stated one means; None where all that it names is missing.

    Args:
        asked: with ids of entities.
        ids_of: the ids of the objects that stand for an entity.
        room: whose doors and windows are meant.
    """
    named = [_ends(name, ids_of, room) for name in asked.targets]
    if any(not ends for ends in named):
        if asked.kind != "path":
            return None
        named = []  # to what is not there, or not known: all ways are meant
    first = named[0] if named else ()
    rest = tuple(name for ends in named[1:] for name in ends)
    split = asked.kind in ("gap", "path") and len(named) > 1
    return SceneArea(
        id=asked.id,
        kind=asked.kind,
        size=asked.size,
        most=asked.most,
        targets=first if split else (*first, *rest),
        others=rest if split else (),
        side=asked.side,
        request=asked.id,
    )


def _ends(name: str, ids_of: Callable[[str], Sequence[str]], room: Room) -> tuple[str, ...]:
    """The things of a scene that a target of a request means."""
    place, _, which = name.partition(":")
    if place == "door":
        doors = [door.id for door in room.doors]
        at = int(which) - 1 if which.isdigit() else 0
        return tuple(doors[at : at + 1])
    if place == "window":
        return tuple(window.id for window in room.windows[:1])
    return (place,) if place in PLACES else tuple(ids_of(name))


__all__ = ["alike", "scene_area"]
