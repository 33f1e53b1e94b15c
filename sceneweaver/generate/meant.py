"""What a request means by its words in a kind of room: which items things stand for, which kinds it has decided."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sceneweaver.assets.plurals import singular
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named, members
from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.kin import excluded_kinds, kin, other_meanings
from sceneweaver.knowledge.stations import own_on_wall
from sceneweaver.language import Entity, SceneGraph

from .draft import groups_of
from .kitchen_runs import galley_spared
from .written import roles_written

GENERAL = (
    "table",
    "chair",
    "bed",
    "desk",
    "lamp",
    "shelf",
    "cabinet",
    "sink",
    "light",
    "seat",
    "plant",
    "rack",
    "sofa",
    "mat",
    "bench",
)
"""Words of a request that leave the kind to the room."""


def named_kinds(brief: SceneGraph) -> frozenset[str]:
    """The categories of all kinds that a request names: of these there is what it asks for, and no more."""
    named = (one for one in brief.entities if not _is_bar_of_stools(one, brief))
    return frozenset(c for one in named for c in kin(one.category, one.noun))


def _is_bar_of_stools(one: Entity, brief: SceneGraph) -> bool:
    """Whether a thing is the bar that stools at a window need: the tables of the room are there besides."""
    below = any(r.type == "below" and r.subject == one.id and r.targets == ("window",) for r in brief.relations)
    return one.implied and below and has_role(one.category, "counter")


def decided_kinds(brief: SceneGraph, room_type: RoomType) -> frozenset[str]:
    """The categories of which nothing is added of our own: those that a request names, those that it excludes, and
    those that do not belong in such a room or are not of its time."""
    return named_kinds(brief) | excluded_kinds((*brief.without, *room_type.never)) | room_type.absent


def roles_of(room_type: RoomType, brief: SceneGraph) -> dict[str, tuple[str, ...]]:
    """For each thing asked for the items of the room that it stands for: of its category, of a general word, or, where
    there is none of these and nothing else has it, of its kind: a daybed takes the place of the bed."""
    if room_type.for_request:
        return roles_written(room_type, {one.id: _alike(one, room_type, brief) for one in brief.entities}, brief)
    found = {one.id: tuple(item.id for item in room_type.items if meant_by(one, item, brief)) for one in brief.entities}
    bars = {one.id for one in brief.entities if _is_bar_of_stools(one, brief)}
    for one in brief.entities:
        found[one.id] = () if one.id in bars else _with_their_hosts(one, found, room_type, brief)
    taken = {name for items in found.values() for name in items}
    for one in brief.entities:
        if one.id in bars or any(room_type.item(name).need == "needed" for name in found[one.id]):
            continue
        own = kin(one.category)
        needed = [i.id for i in room_type.items if i.need == "needed" and i.id not in taken and set(i.what) <= own]
        if needed:
            found[one.id] = (needed[0],)
            taken.add(needed[0])
        if found[one.id]:
            continue
        own = frozenset(name for name in own if may_mean(one, name, brief))
        free = [item.id for item in room_type.items if item.id not in taken and own & set(item.what)]
        if not free and has_role(one.category, "seated_at"):
            free = _tables_like(one, room_type, taken)
        if free:
            found[one.id] = (free[0],)
            taken.add(free[0])
    return found


def _tables_like(one: Entity, room_type: RoomType, taken: set[str]) -> list[str]:
    """The items of a room of whose places a table of another kind takes charge: those with seats, of the same last
    word. Else the seats that are asked for would be strewn beside tables that nobody sits at."""
    hosts = {item.with_ for item in room_type.items if "seating" in groups_of(item.what[0])}
    word = one.category.rpartition("_")[2]
    return [
        item.id
        for item in room_type.items
        if item.id in hosts and item.id not in taken and any(name.rpartition("_")[2] == word for name in item.what)
    ]


def _with_their_hosts(
    one: Entity, found: Mapping[str, tuple[str, ...]], room_type: RoomType, brief: SceneGraph
) -> tuple[str, ...]:
    """Of the items that a thing may stand for those that go with what the request says it is at, if there are any: the
    chairs of a salon's mirrors are no clerks' chairs."""
    hosts = {item for r in brief.relations if r.subject == one.id for name in r.targets for item in found.get(name, ())}
    own = tuple(name for name in found[one.id] if room_type.item(name).with_ in hosts)
    return own or found[one.id]


def desks_spared(room_type: RoomType, brief: SceneGraph, roles: Mapping[str, Sequence[str]]) -> frozenset[str]:
    """The desks of a room that are not needed, with their seats: a table at which people are said to work or sit takes
    the place of one where the request names no desk."""
    if room_type.for_request or any("desk" in e.category for e in brief.entities):
        return frozenset()
    taken = {name for items in roles.values() for name in items}
    desks = [i for i in room_type.items if i.id not in taken and any("desk" in name for name in i.what)]
    desks = [i for i in desks if all(has_role(name, "seated_at") for name in i.what)]
    at = {one.target for one in brief.capacities if one.target and not one.own}
    seats = {e.id for e in brief.entities if has_role(e.category, "upright_seat")}
    placed = {r.subject for r in brief.relations if r.targets and not r.implied}
    at |= {t for r in brief.relations if r.subject in seats for t in r.targets}
    tables = [e for e in brief.entities if has_role(e.category, "seated_at") and (e.id in at or seats - placed)]
    if not tables:
        return frozenset()
    spared = {desk.id for desk in desks}
    return frozenset(spared | {item.id for item in room_type.items if item.with_ in spared})


SET_OUT = ("u", "rows", "circle", "semicircle", "cluster", "grid", "sides", "back_to_back")
"""Arrangements of seats or tables that are the places of all people in a room."""

AUDIENCE = 6
"""Seats that a request counts from which on they are those of the room."""


def places_spared(
    room_type: RoomType, brief: SceneGraph, roles: Mapping[str, Sequence[str]], area: float, people: int
) -> frozenset[str]:
    """The desks and tables of a room at which several people have their places, with their seats: none where the
    request sets out places of its own, such as tables in a U or seats in rows. What one person is at stays."""
    if room_type.for_request:
        return frozenset()
    set_out = {a.entity for a in brief.arrangements if a.pattern in SET_OUT}
    own = [e for e in brief.entities if "seating" in groups_of(e.category) or has_role(e.category, "seated_at")]
    many = sum(e.count[0] for e in own if e.count and "seating" in groups_of(e.category))
    if not any(e.id in set_out for e in own) and many < max(AUDIENCE, brief.people or 0):
        return frozenset()
    taken = {name for items in roles.values() for name in items}
    hosts = {item.with_ for item in room_type.items if item.with_ and "seating" in groups_of(item.what[0])}
    spared = {
        item.id
        for item in room_type.items
        if item.id not in taken
        and item.id in hosts
        and any(has_role(name, "seated_at") for name in item.what)
        and item.count.of(area, max(people, 2), 0.5) > 1
    }
    kept = {room_type.item(name).with_ for one, items in roles.items() if one not in set_out for name in items}
    spared -= {name for name in kept if name}
    return frozenset(spared | {item.id for item in room_type.items if item.with_ in spared})


def stations_spared(room_type: RoomType, brief: SceneGraph, roles: Mapping[str, Sequence[str]]) -> frozenset[str]:
    """What seats of a room usually stand at, where those of the request have a place of their own: each its mirror."""
    own = {station.seats for said in brief.relations if (station := own_on_wall(said, brief)) is not None}
    seats = {name for one in own for name in roles.get(one, ())}
    taken = {name for items in roles.values() for name in items}
    hosts = {room_type.item(name).with_ for name in seats} | {
        item.id for item in room_type.items if item.with_ in seats and not {*groups_of(item.what[0])} & {"lighting"}
    }
    return frozenset(name for name in hosts if name and name not in taken)


def spared_kinds(brief: SceneGraph, room_type: RoomType) -> frozenset[str]:
    """The categories that stand in a room only for items whose place the request's own things take."""
    roles = roles_of(room_type, brief)
    spared = desks_spared(room_type, brief, roles) | stations_spared(room_type, brief, roles)
    spared |= galley_spared(room_type, brief, roles)
    left = {name for item in room_type.items if item.id not in spared for name in item.what}
    return frozenset(name for item in room_type.items if item.id in spared for name in item.what) - left


def _alike(one: Entity, room_type: RoomType, brief: SceneGraph) -> list[Item]:
    """The items that a thing asked for may stand for: those of its category or of a general word, then those of its
    kind."""
    own = kin(one.category)
    alike = [item for item in room_type.items if meant_by(one, item, brief)]
    return [*alike, *(item for item in room_type.items if item not in alike and own & set(item.what))]


def matches(category: str, item: Item) -> bool:
    """Whether a category is what an item of the room stands for."""
    return category in item.what or any(category in members(name) for name in item.what)


def meant_by(asked: Entity, item: Item, brief: SceneGraph) -> bool:
    """Whether something asked for is what an item of the room stands for; a "table" is a conference table, too."""
    if matches(asked.category, item):
        return True
    names = [name for name in item.what if may_mean(asked, name, brief)]
    if not loose(asked, brief) or not any(name.endswith("_" + singular(asked.noun)) for name in names):
        return False
    return bool(kin(asked.category) & set(names)) or not _sat_at(asked, brief)


def may_mean(asked: Entity, category: str, brief: SceneGraph) -> bool:
    """Whether a general word may mean a category: no table is a pool table, and a chair at a desk is no armchair."""
    if category in other_meanings(asked.noun):
        return False
    if category == asked.category or "chair_group" not in groups_of(asked.category):
        return True
    related = {name for r in brief.relations if asked.id in (r.subject, *r.targets) for name in (r.subject, *r.targets)}
    at_table = any(e.id in related and has_role(e.category, "seated_at") for e in brief.entities)
    return not at_table or has_role(category, "upright_seat")


def _sat_at(asked: Entity, brief: SceneGraph) -> bool:
    """Whether chairs are said to be at something: then "table" means one to sit at."""
    seats = {e.id for e in brief.entities if "chair_group" in groups_of(e.category) or e.category in ("stool", "bench")}
    return any(r.subject in seats and asked.id in r.targets for r in brief.relations)


def sat_elsewhere(seat: Item, room_type: RoomType, brief: SceneGraph) -> bool:
    """Whether the seats of a table or desk of the room stand at another one that the request names."""
    if seat.with_ is None or not any("seating" in groups_of(name) for name in seat.what):
        return False
    host = room_type.item(seat.with_)
    named = {e.id: e for e in brief.entities if matches(e.category, seat) or kin(e.category) & set(seat.what)}
    at = {t for r in brief.relations if r.subject in named for t in r.targets}
    tables = [e for e in brief.entities if e.id in at and has_role(e.category, "seated_at")]
    return bool(tables) and not any(matches(e.category, host) for e in tables)


def loose(asked: Entity, brief: SceneGraph) -> bool:
    """Whether a request used a general word ("chair"), which each kind of room has its own kind of.

    What it puts on something is small: a lamp on a sideboard is no floor lamp. Shelves on the wall do not
    stand before it.
    """
    carried = any(r.subject == asked.id and r.type in ("on", "inside") and r.targets for r in brief.relations)
    if carried and "surface" in category_named(asked.category).mount:
        return False
    if "wall" in category_named(asked.category).mount and _hangs(asked, brief):
        return False
    return singular(asked.noun) in GENERAL and not asked.style and not any(asked.size)


def _hangs(asked: Entity, brief: SceneGraph) -> bool:
    """Whether a request says of something that it hangs: on a wall, or over another thing."""
    said = [r for r in brief.relations if r.subject == asked.id and r.targets]
    return any(r.type == "above" or (r.type in ("on", "hanging_from") and "wall" in r.targets[0]) for r in said)


def is_plural(asked: Entity) -> bool:
    """Whether something is named in the plural: a "shoes rack" is one."""
    last = asked.noun.lower().split()[-1:]
    return any(singular(word) != word for word in last)
