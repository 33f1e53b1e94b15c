"""A room that was written down for one request: which of its items a thing of the request is.

Whoever wrote it knew the request, so an item that stands for nothing in it is meant besides: of a classroom with "a
teacher's desk" the desks of the pupils stay.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from sceneweaver.assets.plurals import singular
from sceneweaver.knowledge import Item, RoomType
from sceneweaver.language import Entity, SceneGraph


def named_alike(asked: Entity, item: Item) -> bool:
    """Whether an item bears what the request says ahead of the noun: the "teacher's" of a teacher's desk."""
    ahead = _words(asked.noun)[:-1]
    return bool(set(ahead) & {word for name in (item.id, *item.what) for word in _words(name)})


def numbered_alike(asked: Entity, item: Item, room: RoomType) -> bool:
    """Whether an item may be as many as the request says, where it says how many."""
    least, most = written_count(item, room)
    low, high = asked.count or ((2, most) if singular(asked.noun) != asked.noun else (1, 1))
    return low <= most and least <= high


def written_count(item: Item, room: RoomType) -> tuple[int, int]:
    """Least and most of an item in the whole room; what goes with others is for each of them."""
    least, most = item.count.least, item.count.most
    if item.with_ is None:
        return least, most
    hosts = written_count(room.item(item.with_), room)
    return least * hosts[0], most * hosts[1]


def roles_written(room: RoomType, meant: Mapping[str, Sequence[Item]], brief: SceneGraph) -> dict[str, tuple[str, ...]]:
    """The items that each thing of the request stands for; none where it is meant besides them.

    Args:
        room: the room that was written for the request.
        meant: by id of a thing, the items of its category or kind, those that suit best first.
        brief: the request.
    """
    found = {one.id: tuple(i.id for i in meant[one.id] if named_alike(one, i)) for one in brief.entities}
    taken = {item for items in found.values() for item in items}
    for one in brief.entities:
        free = [item for item in meant[one.id] if item.id not in taken]
        if found[one.id] or not free:
            continue
        alike = [item for item in free if numbered_alike(one, item, room)]
        if alike:
            found[one.id] = (alike[0].id,)
            taken.add(alike[0].id)
        elif len(_words(one.noun)) == 1:  # "two desks", where 24 were written: the request is right
            found[one.id] = tuple(item.id for item in free)
    return found


def _words(name: str) -> list[str]:
    """The words of a name in the singular, without the "s" of whose it is."""
    return [singular(word) for word in re.findall(r"[^\W_]+", re.sub(r"'s?\b", "", name.lower()))]
