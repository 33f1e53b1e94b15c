"""What is wrong with a room that a model wrote down: words that are not known, sizes, relations, a floor too full."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sceneweaver.assets import categories
from sceneweaver.assets.taxonomy import category_named, members
from sceneweaver.io.messages import shorten, suggest
from sceneweaver.knowledge import Item, Place, RoomType
from sceneweaver.knowledge.kin import kin
from sceneweaver.knowledge.surfaces import arrangements, crowds
from sceneweaver.language import SceneGraph
from sceneweaver.scene import CATALOGUE, InputError
from sceneweaver.scene.messages import FieldError

from .draft import groups_of

FULL, CRAMMED = 0.55, 0.65
"""Shares of the usual floor under what is needed and usual, and of the largest under what is needed, at most."""

WALLED = 0.8
"""Share of the walls of a square room of the usual floor behind what stands at them, at most."""

MOST = 150
"""Objects of all items together, at most."""

LEAST = 3
"""Items that a room has at least."""

TOLERANCE = 0.02
"""Share by which a size may be outside what such things measure."""

_AXES = ("depth", "width", "height")


def check_room(room: RoomType) -> None:
    """Refuse a room that cannot be drawn.

    Raises:
        InputError: one line with all that is wrong, at most eight things.
    """
    refuse([*_wrong_items(room), *_wrong_floor(room)])


def refuse(problems: Sequence[str]) -> None:
    """InputError with the first of some problems, where there are any."""
    if problems:
        more = f"; and {len(problems) - 8} more" if len(problems) > 8 else ""
        raise InputError("; ".join(problems[:8]) + more)


def missing(room: RoomType, usual: RoomType | None, brief: SceneGraph) -> list[str]:
    """What a room lacks: of the request, and of what such a room needs; and what it holds that is not wanted.

    Args:
        room: the room as it is written.
        usual: the kind of room as it is known, if it is.
        brief: the request.
    """
    held = {name for item in room.items for c in item.what for name in (*kin(c), c)}
    found = [
        f"the request asks for {shorten(e.noun)} (category {e.category}), and no item is one"
        for e in brief.entities
        if e.category not in held and not set(kin(e.category, e.noun)) & held
    ]
    banned = {name for word in brief.without for name in (*kin(word), *members(word))}
    unwanted = {i.id for i in (usual.items if usual is not None else ()) if all(c in banned for c in i.what)}
    for item in usual.items if usual is not None else ():
        if item.need != "needed" or item.with_ is not None or item.id in unwanted or brief.only:
            continue
        served = any(c in held for c in item.what)
        users = (
            {other.id for other in usual.items if item.id in (other.with_, *other.on)} if usual is not None else set()
        )
        if not served and not users & unwanted:  # what is there for something unwanted is not needed, either
            found.append(f"such a room needs {item.what[0]}, and no item is one")
    for item in room.items:
        if all(c in banned or groups_of(c) & set(brief.without) for c in item.what):
            found.append(f"{item.id}: the request wants no {item.what[0].replace('_', ' ')}; leave it out")
    return found


def _wrong_items(room: RoomType) -> Iterator[str]:
    ids = {item.id for item in room.items}
    known = [name for name, one in categories().items() if one.size is not None]
    longest = math.sqrt(room.area[2] * max(room.aspect)) if room.area[2] > 0 < max(room.aspect) else 0.0
    for item in room.items:
        if item.group is not None:  # ours
            continue
        if not 0 <= item.count.least <= item.count.most:
            yield f"{item.id}.count is [{item.count.least}, {item.count.most}]; give [least, most]"
        strange = [c for c in item.what if c not in categories() or categories()[c].size is None]
        for noun in strange:
            yield f"{item.id}.what names {shorten(noun)}, which nothing draws{suggest(noun, known)}"
        if strange:
            continue
        yield from _wrong_size(item)
        yield from _wrong_support(item)
        for place in item.place:
            yield from _wrong_place(item, place, ids)
            least = place.params.get("min")
            if isinstance(least, int | float) and not place.soft and least > longest:
                yield f"{item.id}.place {place.type} wants {least:g} m, and such a room is {longest:.1f} m long at most"
        for field, name, table in (("top", item.top, arrangements()), ("fill", item.fill, crowds())):
            if name is not None and name not in table:
                yield f"{item.id}.{field} is {shorten(name)}{suggest(name, table)}"


def _wrong_size(item: Item) -> Iterator[str]:
    for category in dict.fromkeys(item.what):
        known = categories()[category].size
        for axis, given, (low, high) in zip(_AXES, item.size, known.ranges if known else (), strict=False):
            if given is None:
                continue
            if given[0] > given[1]:
                yield f"{item.id}.{axis} is [{given[0]:g}, {given[1]:g}]; the first must not be more than the second"
            elif given[1] < low * (1 - TOLERANCE) or given[0] > high * (1 + TOLERANCE):
                yield f"{item.id}.{axis} is [{given[0]:g}, {given[1]:g}]; a {category} has {low:g} to {high:g} m"


def _wrong_support(item: Item) -> Iterator[str]:
    held = item.mount or ("surface" if item.on else None)
    for category in item.what:
        mounts = category_named(category).mount
        if held is not None and held not in mounts:
            yield f"{item.id}: a {category} is not held by a {held}, but by {' or '.join(mounts)}"
            return
    if (held or category_named(item.what[0]).mount[0]) == "surface" and not item.on:
        yield f"{item.id}: say with `on` which items carry it, or leave it to the top or fill of one"


def _wrong_place(item: Item, place: Place, ids: set[str]) -> Iterator[str]:
    where, spec = f"{item.id}.place {place.type}", CATALOGUE[place.type]
    kind = spec.target.removesuffix("?")
    if kind == "objects":
        yield f"{where} needs two targets, which an item cannot give; use another relation"
    elif kind == "object" and (place.to not in ids or place.to == item.id):
        yield f"{where}: `to` is {place.to}; give the id of another item"
    elif kind == "wall" and place.to not in (None, "wall", "wall:far"):
        yield f"{where}: `to` is {place.to}; leave it out, or give wall:far"
    elif kind in ("window", "door") and place.to not in (None, kind):
        yield f"{where}: `to` is {place.to}; leave it out, or give {kind}"
    elif kind == "none" and place.to is not None:
        yield f"{where} takes no target; leave `to` out"
    try:
        spec.check_params(place.params)
    except FieldError as error:
        path = "".join(f".{part}" for part in error.loc)
        yield f"{where}: params{path} {error.text.removeprefix(': ')}"


def _wrong_floor(room: RoomType) -> Iterator[str]:
    least, usual, largest = room.area
    if not 2 <= least <= usual <= largest <= 500:
        yield f"area is [{least:g}, {usual:g}, {largest:g}]; give least, usual and largest floor of 2 to 500 m2"
        return
    low, high = room.aspect
    if not 1.0 <= low <= high <= 6.0:
        yield f"aspect is [{low:g}, {high:g}]; give length by width, least and most, from 1 to 6"
    counts = _counts(room, usual)
    if len(room.items) < LEAST:
        yield f"there are {len(room.items)} items; name at least {LEAST}"
    if sum(counts.values()) > MOST:
        yield f"all items together are {sum(counts.values())} objects; at most {MOST}"
    standing = [item for item in room.items if _stands(item)]
    if not any(item.need == "needed" for item in standing):
        yield "no furniture on the floor is needed; say which piece makes the room what it is"
    needed = sum(_footprint(item) * counts[item.id] for item in standing if item.need == "needed")
    all_ = needed + sum(_footprint(item) * counts[item.id] for item in standing if item.need == "usual")
    if needed > CRAMMED * largest or all_ > FULL * usual:
        size, share = (largest, needed) if needed > CRAMMED * largest else (usual, all_)
        yield f"furniture takes {share:.1f} m2 of {size:g} m2 of floor; name less, or give a larger area"
    along = sum(
        _extent(item, 1) * counts[item.id]
        for item in standing
        if item.need != "optional" and any(p.type == "against_wall" and not p.soft for p in item.place)
    )
    if along > WALLED * 4 * usual**0.5:
        yield f"{along:.1f} m of furniture want a wall, and a room of {usual:g} m2 has {4 * usual**0.5:.1f} m of walls"


def _counts(room: RoomType, area: float) -> dict[str, int]:
    """How many of each item there are as a rule; those that go with others are for each of these."""
    found: dict[str, int] = {}
    for item in room.items:
        found[item.id] = item.count.of(area, room.people, 0.0) * found.get(item.with_ or "", 1)
    return found


def _stands(item: Item) -> bool:
    known = category_named(item.what[0])
    return (item.mount or ("surface" if item.on else known.mount[0])) == "floor"


def _extent(item: Item, axis: int) -> float:
    """A usual size [m] of an item."""
    known, given = categories()[item.what[0]].size if item.what[0] in categories() else None, item.size[axis]
    low, high = given or (known.ranges[axis] if known is not None else (0.5, 0.5))
    return 0.5 * (low + high)


def _footprint(item: Item) -> float:
    """Floor [m2] under one of an item; half for a seat, nothing for a rug."""
    if _extent(item, 2) < 0.03:
        return 0.0
    seat = item.with_ is not None and "seating" in groups_of(item.what[0])
    return _extent(item, 0) * _extent(item, 1) * (0.5 if seat else 1.0)
