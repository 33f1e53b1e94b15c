"""Measures of what a room should hold: what is missing, what goes with what, and what belongs elsewhere."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

from sceneweaver.assets import categories
from sceneweaver.assets.roles import has_role
from sceneweaver.knowledge import Item, RoomType, room_types
from sceneweaver.knowledge.complete import expected_of
from sceneweaver.knowledge.kin import fits_anywhere, may_stand_in, neighbouring, place_of, serves
from sceneweaver.knowledge.small_things import left_about, wall_things
from sceneweaver.rules.faults import fault_kind, number
from sceneweaver.verify.solids import Body

from .. import kinds
from ..design.query import kind_set
from ..design.registry import measure
from ..program import Need
from ..survey import Survey

# ---- what is missing -------------------------------------------------------------------------------------------------


class Missing(NamedTuple):
    """An item of which the room has too few.

    ``core`` of it any such room needs; ``kin``: something there may do its work; ``goes_with``: it belongs to another
    item; ``objects``: what ``add_objects`` takes.
    """

    category: str
    have: tuple[str, ...]
    least: int
    core: int
    missing: int
    needed: bool
    kin: bool
    goes_with: bool
    objects: list[dict[str, Any]]


@measure
def missing(survey: Survey, spare: float) -> list[Missing]:
    """The items of which there are too few, but for those that a room does without and nobody misses.

    These are usual ones of which more than half are there, and all that is absent where that is no more than a share.
    """
    usual = [n for n in survey.program.needs if n.item.need == "usual" and not n.asked]
    absent = [n.item.id for n in usual if not n.have]
    spared = {n.item.id for n in usual if n.have and 2 * n.missing <= n.least}
    spared |= set(absent if len(absent) <= spare * len(usual) else ())
    return [_missing(survey, n) for n in survey.program.needs if n.missing and n.item.id not in spared]


def _missing(survey: Survey, need: Need) -> Missing:
    item = need.item
    on = [object_id for object_id, of in survey.program.item_of.items() if of in item.on]
    objects = []
    for parent, count in _lacking(survey, need):
        place = placing(survey, item, parent)
        row = {"category": item.what[0], "count": count, "place": place, "on": on}
        objects.append({key: value for key, value in row.items() if value != []})
    kin = any(serves(b.item.category, item.what) for b in survey.bodies)
    goes_with, needed = item.with_ is not None, item.need == "needed"
    return Missing(
        item.what[0], need.have, need.least, need.core, need.missing, needed, kin, goes_with, objects
    )  # fmt: skip


def placing(survey: Survey, item: Item, parent: str | None = None) -> list[dict[str, Any]]:
    """The item's relations as ``add_objects`` takes them, with ids for items; ``parent`` is what it goes with."""
    found = []
    for place in item.place:
        row: dict[str, Any] = {"type": place.type, **place.params}
        if place.to not in (None, "wall", "window", "door"):
            ids = _of_item(survey, place.to)
            if not ids:
                continue
            row["to"] = parent if parent in ids else ids[0]
        elif place.to is not None and place.to != "wall":
            row["to"] = place.to
        if place.soft:
            row["soft"] = True
        found.append(row)
    return found


def _of_item(survey: Survey, name: str | None) -> list[str]:
    """The ids of what stands for an item of the room."""
    return [object_id for object_id, of in survey.program.item_of.items() if name is not None and of == name]


def _lacking(survey: Survey, need: Need) -> list[tuple[str | None, int]]:
    """With what the missing ones should go, and how many with each: the instances that have the fewest near them."""
    parents = _of_item(survey, need.item.with_)
    if len(parents) < 2:
        return [(parents[0] if parents else None, need.missing)]
    each, left, found = -(-need.least // len(parents)), need.missing, []
    have, reach = set(need.have), number("at_table")
    near = {p: sum(b.id in have for b, _ in survey.near(survey.placed.by_id[p], reach)) for p in parents}
    for parent in sorted(parents, key=lambda p: near[p]):
        count = min(left, max(0, each - near[parent]))
        if count:
            found.append((parent, count))
            left -= count
    return found if not left else [*found, (parents[0], left)]


@measure
def said_missing(survey: Survey, kinds_: str) -> bool:
    """Whether an item of which there are too few may be of a set of categories."""
    return any(c in kind_set(kinds_) for n in survey.program.needs if n.missing for c in n.item.what)


@measure
def needed(survey: Survey, o: Body) -> bool:
    """Whether a body stands for an item that the room needs."""
    return any(o.id in n.have for n in survey.program.needs if n.item.need == "needed")


@measure
def not_there_yet(survey: Survey, most: int, spare: str) -> list[dict[str, Any]]:
    """The first items of the room, optional ones last, that could stand on the floor and do not; else a spare one."""
    have, order = set(survey.program.item_of.values()), ("needed", "usual", "optional")
    absent = [i for i in survey.room_type.items if i.id not in have and i.with_ is None and not i.on and _stands(i)]
    absent.sort(key=lambda i: order.index(i.need))
    if not absent:
        return [{"category": spare, "count": 1, "place": [{"type": "in_corner"}]}]
    return [{"category": i.what[0], "count": 1, "place": placing(survey, i)} for i in absent[:most]]


def _stands(item: Item) -> bool:
    row = categories().get(item.what[0])
    return (item.mount or (row.mount[0] if row else "floor")) == "floor"


@measure
def expected_objects(survey: Survey) -> float:
    """How many objects such a room has: its items, and some small things on every support."""
    from ..design.looks import supports

    limits, items = fault_kind("few_objects").limits, 0.0
    for item in survey.room_type.items:
        count = item.count.of(survey.area, survey.program.people, limits["optional_share"])
        if item.with_ is not None:
            count *= len(_of_item(survey, item.with_))
        items += count * limits[item.need]
    return limits[survey.brief.density] * (items + limits["on_each"] * len(supports(survey)))


# ---- what goes with what ---------------------------------------------------------------------------------------------


@measure
def lacks_partner(survey: Survey, o: Body) -> bool:
    """Whether there are too few of an item that goes with that of a body."""
    item = survey.program.item_of.get(o.id)
    return item is not None and any(n.item.with_ == item and n.missing for n in survey.program.needs)


def _seat_items(room: RoomType) -> Iterator[Item]:
    return (item for item in room.items if any(has_role(c, "upright_seat") for c in item.what))


@measure
def usual_seat(survey: Survey, otherwise: str) -> str:
    """The category of the first seat that such a room lists, or another one."""
    return next((item.what[0] for item in _seat_items(survey.room_type)), otherwise)


@measure
def seats_elsewhere(survey: Survey, table: Body) -> bool:
    """Whether such a room lists seats, but none that go with the item of a table."""
    of = [item.with_ for item in _seat_items(survey.room_type)]
    return bool(of) and survey.program.item_of.get(table.id) not in of


@measure
def first_listed(survey: Survey, kinds_: str) -> str | None:
    """The first category of a set that such a room lists."""
    return next((c for item in survey.room_type.items for c in item.what if c in kind_set(kinds_)), None)


# ---- what belongs there ----------------------------------------------------------------------------------------------


@measure
def strangeness(survey: Survey, o: Body) -> str | None:
    """What is strange about a body in such a room: None for what it, its kin or the request names.

    "foreign": it belongs to other kinds of rooms; "neighbour": to one that such a room may be part of; "tool": sports
    and tools; "listed elsewhere": other rooms or none at all list such furniture; "rare": anything else.
    """
    category, room = o.item.category, survey.room_type
    own, places = _at_home(room)
    asked = {c for a in survey.brief.entities for c in may_stand_in(a.category)}
    if category in own or category in asked or o.id in survey.program.item_of:
        return None
    if left_about(category, room.name) or category in wall_things(room.name):
        return None
    if o.item.intent.request in {a.id for a in survey.brief.entities}:
        return None
    place, row, groups = place_of(category), categories().get(category), kinds.groups_of(category)
    if place is not None:
        near = place in places or any(neighbouring(place, other) for other in places)
        return "foreign" if not near else "neighbour" if place not in places else None
    if row is None or fits_anywhere(category) or o.item.mount == "surface":
        return None
    if "gym" in places and "sport" in groups:
        return None
    if groups & {"sport", "tool_group"}:
        return "tool"
    return "listed elsewhere" if category in _elsewhere(room.name) or row.parent == "furniture" else "rare"


def _at_home(room: RoomType) -> tuple[frozenset[str], frozenset[str]]:
    """Categories that a room lists with their kin, and the kinds of places that they come from."""
    looked_for = frozenset().union(*(row.what for row in expected_of(room.name)))
    return _with_kin(frozenset(name for item in room.items for name in item.what) | looked_for)


@cache
def _with_kin(names: frozenset[str]) -> tuple[frozenset[str], frozenset[str]]:
    own = frozenset().union(*(may_stand_in(name) for name in names))
    return own, frozenset(p for p in map(place_of, names) if p is not None)


@cache
def _elsewhere(room: str) -> frozenset[str]:
    """Categories that other kinds of rooms list."""
    return frozenset(c for name, r in room_types().items() if name != room for i in r.items for c in i.what)


@measure
def room_is_made_of(survey: Survey, o: Body) -> bool:
    """Whether a body stands for an item that makes up such a room, as desks do an office."""
    return survey.program.item_of.get(o.id) in survey.room_type.made_of


@measure
def counted_in_request(survey: Survey, o: Body) -> bool:
    """Whether a body is one of so many that the request wants."""
    asked = survey.brief.entity(survey.program.asked_of.get(o.id, ""))
    return asked is not None and asked.count is not None
