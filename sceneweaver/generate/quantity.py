"""How much a request wants of what it names, and whether it wants anything beside that."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.assets.roles import groups_above
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge import Item
from sceneweaver.language import Entity, SceneGraph
from sceneweaver.language.vocabulary import words

LARGE = 0.3
"""Floor [m2] under a thing from which on `FEW` of it are many."""

FEW = 4
"""How many large things are many."""

MANY: Mapping[str, int] = {"floor": 10, "wall": 8, "ceiling": 8, "surface": 14}
"""How many other things are many, by what holds them."""

SOME, DETAILED, COMPLETE = 4, 6, 10
"""Things that a request names from which on nothing optional, nothing usual, and nothing on walls is added."""

ON_FLOOR = 3
"""Of small things all over a room every so many lies on the floor."""

DECORATION = frozenset(("decor", "plant_group", "textile"))
"""Groups of what a sparse room goes without."""


def is_plain(brief: SceneGraph) -> bool:
    """Whether a request wants little or nothing beside what it names: no pictures, plants, rugs and small things."""
    return brief.only or brief.density == "sparse"


def is_detailed(brief: SceneGraph) -> bool:
    """Whether a request names so many things that it describes the room: nothing is added but what the room needs."""
    return len(brief.entities) >= DETAILED


def is_plain_item(item: Item) -> bool:
    """Whether an item of a room is there in a sparse one: what the room needs, and its light."""
    if item.need == "needed":
        return not all(groups_above(name) & DECORATION for name in item.what)
    return item.need == "usual" and all("lighting" in groups_above(name) for name in item.what)


def spread_of(entity: str | None, brief: SceneGraph) -> str | None:
    """Over what part of the room a thing is said to be spread, or "many"; None where nothing such is said."""
    return next((amount.spread for amount in brief.amounts if amount.entity == entity), None)


def least_of(asked: Entity, brief: SceneGraph) -> int:
    """How many there are at least of a thing of which a request says that there are many; 0 where it does not."""
    told = [amount.least or 0 for amount in brief.amounts if amount.entity == asked.id]
    if not told or (asked.count is not None and asked.count[0] == asked.count[1]):
        return 0
    known = category_named(asked.category)
    if known.size is not None and known.mount[0] == "floor":
        depth, width = (0.5 * (low + high) for low, high in known.size.ranges[:2])
        if depth * width >= LARGE and small_kind(asked.category) is None:
            return FEW
    return max(*told, MANY[known.mount[0]]) if spread_of(asked.id, brief) != "many" else max(told)


def small_kind(category: str) -> str | None:
    """The category of the same thing where it stands on something: a small plant; None where there is no other."""
    kinds: dict[str, Any] = words("nouns")["hung"]["surface"]
    return kinds.get(category)


def lies_on_floor(number: int, spread: str | None) -> bool:
    """Whether the ``number``-th of small things that are spread so lies on the floor."""
    return spread == "floor" or (spread == "everywhere" and number % ON_FLOOR == ON_FLOOR - 1)
