"""Which objects of a scene stand for which items of its kind of room and of the request."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

from sceneweaver.assets.roles import has_role
from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.kin import excluded_kinds, serves
from sceneweaver.language import Entity, SceneGraph
from sceneweaver.language.standing import stood_at
from sceneweaver.rules.faults import number
from sceneweaver.scene import Scene, SceneObject


@dataclass(frozen=True)
class Need:
    """An item that the room should hold, how many at least, and the ids of those that it does.

    ``core`` of them any such room needs; ``least`` grows with the floor and the people.
    """

    item: Item
    least: int
    core: int
    have: tuple[str, ...]
    asked: bool

    @property
    def missing(self) -> int:
        """How many are not there."""
        return max(0, self.least - len(self.have))


@dataclass(frozen=True)
class Program:
    """Objects by item and by what was asked.

    ``item_of``: object id to item id of the room type; ``asked_of``: object id to id of the request; ``needs``: what
    the room should hold; ``people``: for how many it is.
    """

    item_of: dict[str, str]
    asked_of: dict[str, str]
    needs: tuple[Need, ...]
    people: int

    @classmethod
    def of(cls, scene: Scene, room_type: RoomType, brief: SceneGraph, area: float) -> Program:
        """Match the objects of a scene; ``area`` is its floor [m2]."""
        people = brief.people if brief.people is not None else room_type.people
        asked_of = _match_asked(scene, brief)
        item_of: dict[str, str] = {}
        known = {item.id for item in room_type.items}
        for o in scene.objects:
            if o.intent.program_item in known:
                item_of[o.id] = o.intent.program_item
        banned = excluded_kinds(brief.without)
        needs: list[Need] = []
        by_item: dict[str, list[str]] = defaultdict(list)
        for object_id, name in item_of.items():
            by_item[name].append(object_id)
        loose = [o for o in scene.objects if o.id not in item_of]
        for level in (2, 1):  # what is named first, then what may stand in for it
            for item in room_type.items:
                if all(o.id in item_of for o in loose):
                    break
                least = _least(item, by_item, scene, area, people)
                for o in loose:
                    if (
                        o.id not in item_of
                        and len(by_item[item.id]) < max(least, item.count.most)
                        and (serves(o.category, item.what) >= level and _mounted_as(o, item))
                    ):
                        item_of[o.id] = item.id
                        by_item[item.id].append(o.id)
        for o in loose:  # more of an item than it counts is still of that item
            if o.id not in item_of:
                fits = [i for i in room_type.items if serves(o.category, i.what)]
                if fits:
                    best = max(fits, key=lambda i: serves(o.category, i.what))
                    item_of[o.id] = best.id
                    by_item[best.id].append(o.id)
        for item in room_type.items:
            need = _need(item, brief, banned, by_item, scene, area, people)
            if need is not None:
                needs.append(need)
        return cls(item_of, asked_of, tuple(needs), people)


def _mounted_as(o: SceneObject, item: Item) -> bool:
    return item.mount is None or o.mount == item.mount


def _hosts(item: Item, by_item: dict[str, list[str]], scene: Scene) -> int:
    """How many there are of what an item goes with, of the categories that it is for."""
    ids = by_item.get(item.with_ or "", ())
    return sum(not item.when or scene.object(object_id).category in item.when for object_id in ids)


def _least(item: Item, by_item: dict[str, list[str]], scene: Scene, area: float, people: int) -> int:
    least = item.count.of(area, people, 0.0)
    return least if item.with_ is None else least * _hosts(item, by_item, scene)


def _need(
    item: Item,
    brief: SceneGraph,
    banned: frozenset[str],
    by_item: dict[str, list[str]],
    scene: Scene,
    area: float,
    people: int,
) -> Need | None:
    names = tuple(c for c in item.what if c not in banned)
    meant = [a for a in brief.entities if serves(a.category, item.what)]
    have = tuple(by_item.get(item.id, ()))
    if not names or (item.need == "optional" and not meant):
        return None
    if not meant and brief.only and (item.need != "needed" or brief.entities):
        return None
    least = item.count.of(area, people, 0.0)
    if item.count.per_area is not None or item.count.per_person is not None:
        least = max(item.count.least, int(number("count_by_area") * least))
    core = min(least, max(1, item.count.least))
    if item.with_ is not None:
        hosts = _hosts(item, by_item, scene)
        if has_role(item.what[0], "table_seat"):
            standing = stood_at(brief)
            hosts -= sum(scene.object(name).intent.request in standing for name in by_item.get(item.with_, ()))
        least, core = least * hosts, core * hosts
    if "at_window" in {p.type for p in item.place if not p.soft} and not scene.room.windows:
        least = 0
    limits = [a.count[1] for a in meant if a.count is not None]
    if limits:
        least = min(least, sum(limits))
    if brief.density == "sparse" and item.need != "needed":
        return None
    return Need(item, least, core, have, bool(meant)) if least > 0 else None


def _match_asked(scene: Scene, brief: SceneGraph) -> dict[str, str]:
    """Object id to id of the request: as the objects say, then by category up to the count that was asked."""
    ids = {a.id: a for a in brief.entities}
    found: dict[str, str] = {}
    for o in scene.objects:
        if o.intent.request in ids:
            found[o.id] = o.intent.request
    for level in (3, 2, 1):
        for asked in brief.entities:
            have = sum(1 for name in found.values() if name == asked.id)
            most = asked.count[1] if asked.count is not None else 10**6
            for o in scene.objects:
                if have >= most:
                    break
                if o.id not in found and _fits(o, asked, level) and (asked.count is not None or not have or level > 1):
                    found[o.id] = asked.id
                    have += 1
    return found


def _fits(o: SceneObject, asked: Entity, level: int) -> bool:
    """How an object may be what was asked: 3 category and colour, 2 category or a member of it, 1 its kin."""
    score = serves(o.category, (asked.category,))
    if level == 3:
        return score == 2 and (asked.color is None or o.attributes.get("color") == asked.color)
    return score >= level
