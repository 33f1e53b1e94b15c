"""The scene while a tool adds to it: lookup by any name, fresh ids, and how much of what is tied to what."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache

from sceneweaver.assets import categories, resolve
from sceneweaver.assets.roles import groups_above
from sceneweaver.assets.taxonomy import members
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.scene import Relation, Room, Scene, SceneObject

CRAMMED = (0.7, 0.85)
"""Shares of the floor and of the walls, less doors, that are furnished at most, whatever is asked for or needed."""

KNOWN = ("exact", "synonym", "plural", "spelling", "group")
"""How a noun may be understood for it to name what is in a scene."""


@cache
def groups_of(category: str) -> frozenset[str]:
    """A category and the groups that it belongs to."""
    return groups_above(category) | {category}


def area_of(room: Room) -> float:
    """Floor [m2] of a room."""
    return signed_area(room.outline)


def walls_of(room: Room) -> float:
    """Length [m] of the walls of a room, less doors."""
    return sum(wall.length for wall in room.walls) - sum(d.width for d in room.doors)


@dataclass
class Draft:
    """Objects and relations that are there or about to be."""

    room: Room
    objects: dict[str, SceneObject] = field(default_factory=dict)
    relations: list[Relation] = field(default_factory=list)

    @classmethod
    def of(cls, scene: Scene) -> Draft:
        """A draft that holds what a scene holds."""
        return cls(scene.room, {o.id: o for o in scene.objects}, list(scene.relations))

    def fresh(self, category: str) -> str:
        """An id ``category-k`` that nothing has."""
        taken = {*self.objects, *(d.id for d in self.room.doors), *(w.id for w in self.room.windows)}
        stem = category.replace(" ", "_")
        k = sum(o.category == category for o in self.objects.values())
        while f"{stem}-{k}" in taken:
            k += 1
        return f"{stem}-{k}"

    def named(self, word: str) -> list[str]:
        """Ids of the objects that a word names: an id, an item of the room, a category, or a noun for one."""
        if word in self.objects:
            return [word]
        there = self.objects.values()
        found = [o.id for o in there if o.intent.program_item == word]
        found = found or [o.id for o in there if o.intent.request == word] or self.of_category(word)
        if found:
            return found
        match = resolve(word)
        if match.generic:
            return self.of_category(match.category)
        if match.how not in KNOWN:
            return []
        found = self.of_category(match.category)
        return found or self.of_group(word)

    def of_category(self, category: str) -> list[str]:
        """Ids of the objects of exactly that category."""
        return [o.id for o in self.objects.values() if o.category.replace(" ", "_") == category.replace(" ", "_")]

    def of_group(self, noun: str) -> list[str]:
        """Ids of the objects whose category is a wider or narrower form of a noun: a king bed is a bed."""
        match = resolve(noun)
        known = categories()
        wider = known[match.category].parent if match.category in known else None
        pool = set(members(noun.replace(" ", "_")))
        head = noun.lower().replace("_", " ").rpartition(" ")[2]
        if wider is not None:
            pool |= {name for name in members(wider) if name.rpartition("_")[2] == head.removesuffix("s")}
        return [o.id for o in self.objects.values() if o.category in pool]

    def crammed(self, size: tuple[float, float, float], category: str) -> bool:
        """Whether the floor, or the walls where such things stand at them, cannot hold one more of that size [m]."""
        standing = [o for o in self.objects.values() if o.mount == "floor" and o.size[2] > 0.02]
        walled = {r.subject for r in self.relations if r.type == "against_wall" and r.hard}
        along = [o for o in standing if o.id in walled]
        floor = sum(o.size[0] * o.size[1] for o in standing) + size[0] * size[1]
        wall = sum(o.size[1] for o in along) + size[1]
        at_walls = any(o.category == category for o in along)
        return floor > CRAMMED[0] * area_of(self.room) or (at_walls and wall > CRAMMED[1] * walls_of(self.room))

    def load(self, target: str, subject: SceneObject, types: Iterable[str] = ()) -> int:
        """How many objects like ``subject`` are tied to a target, by relations of some types or of any."""
        kinds = set(types)
        item = subject.intent.program_item
        count = 0
        for r in self.relations:
            if target not in r.targets or (kinds and r.type not in kinds) or r.subject == subject.id:
                continue
            other = self.objects.get(r.subject)
            if other is None:
                continue
            if other.category == subject.category or (item is not None and other.intent.program_item == item):
                count += 1
        return count
