"""The room of a request for a kind that nobody described: what was asked for with what that needs, and light.

Nothing of another kind of room is put into it. From the kind in which such things are likeliest it takes doors and
windows, the floor, and where each thing that the request names usually stands.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sceneweaver.assets.roles import groups_above
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge import Item, RoomType, room_types
from sceneweaver.knowledge.load import plain_room
from sceneweaver.knowledge.model import PLACES
from sceneweaver.knowledge.room_files import LONGEST
from sceneweaver.language import SceneGraph

from .free_floor import people_of
from .meant import roles_of

NAMELESS = "room"
"""Name of a room of which the request gives no kind."""

LIGHT = "light"
"""The item that is there where the request names no lamp."""

SHARE = 0.3
"""Share of the floor under what is asked for."""

AROUND = 1.0
"""Least floor [m2] around each thing that stands on it."""

SMALLEST, LARGEST = 8.0, 400.0
"""Floor [m2] that such a room has where nobody gives it."""

EACH = 1.2
"""Floor [m2] for each person that a request speaks of."""

_END = re.compile(r"[.,;:!?\n]")


def asked_room(brief: SceneGraph, words: str, like: RoomType | None = None) -> RoomType:
    """The kind of room that words name and nobody described.

    Args:
        brief: the request.
        words: what it calls the room, empty where it does not.
        like: the known kind of room in which such things are likeliest, if any.
    """
    base, floor = like or plain_room(), floor_needed(brief)
    return base.model_copy(
        update={
            "name": _name(words),
            "words": (),
            "description": f"What is asked for, in a room called '{words}'" if words else "What is asked for",
            "sources": ("the request",),
            "area": (min(floor, SMALLEST), floor, 2.0 * floor),
            "people": people_of(brief) or 1,
            "palettes": None,
            "never": (),
            "names": {},
            "made_of": (),
            "items": _items(brief, base),
        }
    )


def headline(brief: SceneGraph) -> str:
    """The words that a request begins with and that were not understood, as it calls its room; else none."""
    first = min((e.span.start for e in brief.entities if e.span is not None), default=len(brief.text))
    for unread in brief.unread:
        if unread.span is not None and unread.span.start < first:
            before = brief.text[: unread.span.start].strip()
            if not _END.search(before) and re.search(r"[a-z]{3}", unread.words.lower()):
                return unread.words
    return ""


def floor_needed(brief: SceneGraph) -> float:
    """The floor [m2] for what is asked for, with ways around it and what is to stay free."""
    area = 0.0
    for one in brief.entities:
        known = category_named(one.category)
        if known.size is None or known.mount[0] != "floor":
            continue
        usual = [0.5 * (low + high) for low, high in known.size.ranges[:2]]
        depth, width = (said or side for said, side in zip(one.size[:2], usual, strict=True))
        count = one.count[0] if one.count is not None else 1
        if one.generic:  # of what it is nothing is known, not even whether it stands on the floor
            area += AROUND
            continue
        area += count * max(depth * width / SHARE, depth * width + AROUND)
    return round(min(max(area + EACH * (people_of(brief) or 0), SMALLEST), LARGEST), 1)


def _name(words: str) -> str:
    """The name of the room, fit for a file, and none of a known kind."""
    name = "_".join(re.findall(r"[a-z0-9]+", words.lower()))[:LONGEST].strip("_")
    return name if re.match(r"[a-z]", name) and name not in room_types() else NAMELESS


def _items(brief: SceneGraph, base: RoomType) -> tuple[Item, ...]:
    """The items of a room that stand for what the request names, what these need, and light."""
    meant = {name for names in roles_of(base, brief).values() for name in names}
    named = {one.category for one in brief.entities}
    kept = [item for item in base.items if item.id in meant - {LIGHT}]
    plain = plain_room().items
    hosts: dict[str, str] = {}
    for item in plain:
        alike = [k.id for k in kept if set(k.what) & set(item.what)]
        if item.with_ is None and named & set(item.what):
            hosts[item.id] = alike[0] if alike else item.id
            kept += [] if alike else [item]
        elif item.with_ in hosts and not alike:
            kept.append(_hosted(item, item.with_, hosts[item.with_]))
        elif item.id == LIGHT and not any("lighting" in groups_above(one.category) for one in brief.entities):
            kept.append(item)
    return tuple(_alone(item, [k.id for k in kept]) for item in kept)


def _hosted(item: Item, old: str, new: str) -> Item:
    """An item that goes with another one than its file says."""
    place = tuple(p.model_copy(update={"to": new}) if p.to == old else p for p in item.place)
    return item.model_copy(update={"with_": new, "place": place})


def _alone(item: Item, ids: Sequence[str]) -> Item:
    """An item without what it has to do with items that are not there."""
    place = tuple(p for p in item.place if p.to is None or p.to in ids or p.to in PLACES)
    update: dict[str, object] = {"place": place, "on": tuple(name for name in item.on if name in ids)}
    if item.with_ not in ids:
        update |= {"with_": None, "when": (), "beyond": (None, None), "spans": None}
    return item.model_copy(update=update)
