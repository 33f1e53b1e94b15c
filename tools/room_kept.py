"""What became of a room as a model wrote it: items and hard relations of it that a drawn room does not have."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sceneweaver.generate.program import roles_of
from sceneweaver.generate.setup import Proposal
from sceneweaver.io.messages import shorten
from sceneweaver.knowledge import Item, Place, RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Relation, SceneObject


def not_kept(room: RoomType, made: Proposal, brief: SceneGraph) -> list[str]:
    """What was written and is not there, each with the reason.

    Args:
        room: the room as it was written for a request.
        made: the room as it was drawn.
        brief: the request.
    """
    objects = made.scene.objects if made.scene is not None else ()
    drawn = {item.id: [o for o in objects if o.intent.program_item == item.id] for item in room.items}
    stated = [*(made.scene.relations if made.scene is not None else ()), *(r for v in made.variants for r in v)]
    asked = {i: brief.entity(name) for name, items in roles_of(room, brief).items() for i in items}
    found: list[str] = []
    for item in room.items:
        there = len(drawn[item.id])
        written = item.count.least * (len(drawn[item.with_]) if item.with_ is not None else 1)
        if there < max(written, min(1, item.count.most)):
            found.append(f"{_number(item, there, written)}, {_why(item, room, drawn, asked.get(item.id) is not None)}")
        if there:
            found += _relations(item, drawn, stated)
    return found


def _number(item: Item, there: int, written: int) -> str:
    return f"{there} of {written} {item.id}" if there else f"no {item.id}"


def _why(item: Item, room: RoomType, drawn: dict[str, list[SceneObject]], asked: bool) -> str:
    """Why there are fewer of an item than were written."""
    if asked:
        return "as the request says how many"
    if item.with_ is not None and not drawn[item.with_]:
        return f"as there is no {item.with_}"
    if item.on and not any(drawn[name] for name in item.on if name in drawn):
        return f"as there is no {' or '.join(item.on)}"
    return "as there is no place"


def _relations(item: Item, drawn: dict[str, list[SceneObject]], stated: Sequence[Relation]) -> Iterator[str]:
    """The hard relations of an item that none of its objects has."""
    own = {o.id for o in drawn[item.id]}
    held = [r for r in stated if r.hard and r.subject in own]
    for place in item.place:
        others = {o.id for o in drawn.get(place.to or "", ())}
        if place.soft or any(r.type == place.type and (not others or others.intersection(r.targets)) for r in held):
            continue
        said = f"{item.id} {place.type}{f' {place.to}' if place.to else ''}"
        gone = place.to in drawn and not drawn[place.to or ""]
        yield f"{said} is not kept, {f'as there is no {place.to}' if gone else _unsaid(place)}"


def _unsaid(place: Place) -> str:
    return f"as {shorten(place.type, 40)} cannot be said of such a thing there, or the request says otherwise"
