"""The look that a request wants of its whole room, and what follows of it for what stands there: what the time does not
know is not added, other things do its work, and a few carry the theme."""

from __future__ import annotations

from collections.abc import Iterable

from sceneweaver.assets import categories
from sceneweaver.assets.roles import groups_above, with_role
from sceneweaver.assets.taxonomy import category_named, members
from sceneweaver.knowledge import Item, Place, RoomType
from sceneweaver.knowledge.looks import Look, joined, looks
from sceneweaver.knowledge.model import Count
from sceneweaver.knowledge.since import form_of, is_too_young, out_of_time, since, stand_in
from sceneweaver.language import SceneGraph

from .quantity import is_plain

ELECTRIC = 1880
"""Year from which on there are electric lamps; `only: flame` leaves out all that came after."""

MOST = 6
"""Things that carry a look at most, and one for every so many square metres of the usual floor."""

FLOOR = 4.0

FEW_LAMPS = Count(least=1, most=4, per_area=0.05)
"""How many lamps of another time take the place of those of a room."""


def look_of(brief: SceneGraph) -> Look | None:
    """The rows that a request names as one look; None where it says nothing of it."""
    rows = [looks()[name] for name in dict.fromkeys(said.name for said in brief.looks) if name in looks()]
    if not rows:
        return None
    look, glow = joined(rows), next((said.color for said in brief.looks if said.color), None)
    return look if glow is None else look.model_copy(update={"light": look.light.model_copy(update={"glow": glow})})


def is_electric(brief: SceneGraph) -> bool:
    """Whether the room has switches, sockets and radiators."""
    year, look = brief.year, look_of(brief)
    return (year is None or year >= ELECTRIC) and not (look is not None and look.only == "flame" and year is not None)


def absent_kinds(brief: SceneGraph) -> frozenset[str]:
    """The categories that the look has nothing of by itself."""
    year, look = brief.year, look_of(brief)
    found = set(out_of_time(year)) if year is not None else set[str]()
    if (every := brief.finish_of("everything")) is not None and "green" not in f"{every.color} {every.second}":
        found |= set(members("plant_group"))  # they cannot be dyed
    if (floor := brief.finish_of("floor")) is not None and floor.material == "carpet" and floor.pattern is not None:
        found |= with_role("rug")  # the carpet is to be seen
    if look is not None:
        found |= {name for word in look.never for name in (word, *members(word))} - set(look.things)
        if look.only == "named":
            found |= set(members("lighting")) - {one.category for one in brief.entities}
        if look.only == "flame":
            found |= {name for name, first in since().items() if first >= ELECTRIC and _is_lamp(name)}
    return frozenset(found)


def _is_lamp(category: str) -> bool:
    return "lighting" in groups_above(category)


def in_time(brief: SceneGraph) -> SceneGraph:
    """The request with things that it names by what they do in the form of its time: a television of 1962."""
    year = brief.year
    if year is None:
        return brief
    gone = out_of_time(year)
    entities = []
    for one in brief.entities:
        other = form_of(one.category, gone)
        entities.append(one if other is None else one.model_copy(update={"category": other}))
    return brief.model_copy(update={"entities": tuple(entities)})


def suited(room_type: RoomType, brief: SceneGraph) -> RoomType:
    """A kind of room as it is in the look: without what that does not have, with what carries it."""
    absent = absent_kinds(brief)
    look = look_of(brief)
    if not absent and look is None:
        return room_type
    items, hung = list[Item](), False
    for item in room_type.items:
        made = _in_look(item, absent)
        if made is not item and _hangs_as_lamp(made):
            if hung:
                continue  # a few lamps of the time hang in a room, not one for each that ours would have
            hung = True
        items.append(made)
    extra = () if look is None or is_plain(brief) else tuple(_carriers(look, room_type, brief, absent))
    return room_type.model_copy(update={"items": (*items, *extra), "absent": absent})


def _in_look(item: Item, absent: frozenset[str]) -> Item:
    """An item with what does its work there in place of what is not there."""
    left = tuple(name for name in item.what if name not in absent)
    if left or not item.what:
        return item
    others = stand_in(item.what, absent)
    usual = category_named(item.what[0]).mount[0]
    alike = tuple(name for name in others if category_named(name).mount[0] == usual)
    if not alike:
        return item
    update: dict[str, object] = {"what": alike, "size": (None, None, None), "mount": None, "top": None, "fill": None}
    if usual == "ceiling" and _is_lamp(item.what[0]):
        update |= {"count": FEW_LAMPS, "place": (), "with_": None}
    return item.model_copy(update=update)


def _hangs_as_lamp(item: Item) -> bool:
    return _is_lamp(item.what[0]) and category_named(item.what[0]).mount[0] == "ceiling"


def _carriers(look: Look, room_type: RoomType, brief: SceneGraph, absent: frozenset[str]) -> Iterable[Item]:
    """Items of the things that carry a look, as many as the room has place for."""
    named = {one.category for one in brief.entities} | set(brief.without)
    there = {name for item in room_type.items if item.need != "optional" for name in item.what[:1]}
    wanted = [c for c in dict.fromkeys(look.things) if c not in named | there | absent and c in categories()]
    most = min(MOST, max(2, round(room_type.area[1] / FLOOR)))
    on = tuple(i.id for i in room_type.items if any("table_group" in groups_above(name) for name in i.what))
    floor = 0
    for name in wanted:
        mount = category_named(name).mount[0]
        floor += mount == "floor"
        if most == 0 or (mount == "floor" and floor > 2):
            continue
        most -= 1
        place = () if mount != "floor" else (Place.model_validate("soft against_wall"),)
        yield Item(
            id=f"look_{name}",
            what=(name,),
            need="needed",
            place=place,
            on=on if mount == "surface" else (),
        )


def too_young(brief: SceneGraph, category: str) -> bool:
    """Whether a thing came into use after the time of the room."""
    return brief.year is not None and is_too_young(category, brief.year)
