"""The relations of a room's items and of a request, between the objects that stand for them."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sceneweaver.geometry.angles import cross, dot
from sceneweaver.knowledge import Place
from sceneweaver.language import Grounded, SceneGraph, StatedRelation, Thing, grounded
from sceneweaver.language.model import PLACES
from sceneweaver.language.wall_names import PARTS, direction_of, walls_meant
from sceneweaver.scene import CATALOGUE, InputError, Relation, Room, Window

from .arrange import DROPPED, led, patterned
from .conflicts import reconciled
from .hanging import place_along
from .program import Wanted
from .run import has_place, run_of
from .seats import seat_relations
from .under import set_under

_EDGE = frozenset(("against_wall", "side_against_wall", "in_corner", "at_window"))

CONFLICTS: dict[str, frozenset[str]] = {
    "against_wall": frozenset(("against_wall", "in_corner", "at_window")),
    "in_corner": frozenset(("at_window", "centered_on", "near")),
    "at_window": frozenset(("in_corner", "centered_on")),
    "between": frozenset(("in_corner", "at_window", "near")),
    "in_middle": _EDGE | {"near", "centered_on", "over", "on_grid"},
    "over": _EDGE | {"near", "centered_on", "on_grid"},
    "near_window": frozenset(("in_corner", "at_window", "away_from_door", "on_grid")),
    "near_door": frozenset(("in_corner", "at_window", "away_from_door", "on_grid")),
    "facing": frozenset(("facing",)),
    "arranged": DROPPED | {"off_walls", "on_grid"},
}
"""What a room's own relations of a thing give way to: the type that was asked for, and the types that it replaces."""

TOGETHER = (CATALOGUE.with_role("placing") | CATALOGUE.with_role("turning") | {"distance", "on_grid"}) - _EDGE
"""Types that say where a thing is by another; asked for one, it is not bound to a third thing."""

BEHIND_IT = frozenset(("behind", "around"))
"""Types whose target stands free of the walls."""

FREE_STANDING = _EDGE | {"facing_door"}
"""What a room says of things that does not hold for those which have something asked for behind them: a desk with
visitors there looks away from the door, as its owner looks at it."""

CLOSE = 0.1
"""Gap [m] between the pieces of a run that are wanted close to each other."""

CEILING = 0.15
"""Height [m] that is left free above what hangs over something."""

WALL_BEHIND = 0.3
"""Most distance [m] of what hangs at the wall behind a thing."""

FRAME = 0.15
"""Gap [m] that furniture keeps from the frame of a door."""

STAFF = (0.7, 1.6)
"""Gap [m] to the wall behind a counter for those who work there."""

CENTRED = 0.03
"""Most distance [m] of a curtain from the middle of its window."""

SYMMETRIC = CATALOGUE.with_role("symmetric")


def of_items(wanted: Sequence[Wanted], room: Room, but: Mapping[str, frozenset[str]]) -> list[Relation]:
    """The relations that the items say, each for its instances; ``but`` has types that do not hold for some ids."""
    by_item: dict[str, list[Wanted]] = {}
    by_category: dict[str, list[Wanted]] = {}
    for one in wanted:
        by_category.setdefault(one.category, []).append(one)
        if one.item is not None:
            by_item.setdefault(one.item.id, []).append(one)
    found: list[Relation] = []
    centred: set[tuple[str, Any]] = set()  # items with what one of each hangs over the middle of
    for one in wanted:
        for place in one.item.place if one.item else ():
            if place.type in but.get(one.id, ()):
                continue
            if place.type in _EDGE and _worked_behind(one):
                params = {"gap": STAFF}
                found.append(Relation(type="against_wall", subject=one.id, params=params, hard=False))
                continue
            relation = _of_place(one, place, by_item, room) or _instead(one, place, by_category)
            if relation is None:
                continue
            if one.item is not None and _centred(one, relation):
                if (one.item.id, relation.target) in centred:
                    continue
                centred.add((one.item.id, relation.target))
            found.append(relation)
            if relation.type in ("front_against", "around") and one.parent is not None:
                found.append(_squared(one, one.parent))
            if relation.type == "above" and one.mount == "wall":  # at the wall behind it, not at the one opposite
                found.append(behind_it(relation))
    return _cornered(
        _without_doubles(
            [
                *found,
                *of_usual(wanted, by_category, room, but),
                *(r for r in seat_relations(wanted) if r.type not in but.get(r.subject, ())),
                *_beside(wanted),
                *_off_doors(wanted, room),
            ]
        ),
        room,
    )


def _worked_behind(one: Wanted) -> bool:
    """Whether something that takes the place of a thing of the room, which goes to a wall, is worked at from behind: a
    bar where such a room has a kitchen counter."""
    other = one.asked is not None and one.item is not None and one.category not in one.item.what
    return other and any(zone.name == "back" and zone.hard for zone in one.asset.zones)


def behind_it(above: Relation) -> Relation:
    """What keeps a thing that hangs above another at the wall behind that: it is near it."""
    near = {"max": WALL_BEHIND}
    return Relation(type="near", subject=above.subject, target=above.target, params=near, hard=above.hard)


def of_usual(
    wanted: Sequence[Wanted], by_category: Mapping[str, list[Wanted]], room: Room, but: Mapping[str, frozenset[str]]
) -> Iterator[Relation]:
    """Where things that were asked for and are no item of the room usually go; what is by another thing is a wish."""
    for one in wanted:
        for place in one.usual:
            edge = place.type in CATALOGUE.with_role("edge") - {"at_window"}
            if place.type in but.get(one.id, ()) or (edge and one.mount != "floor"):
                continue
            named = bool(place.instead)
            relation = _instead(one, place, by_category) if named else _of_place(one, place, {}, room)
            if relation is not None:
                yield relation


def _instead(one: Wanted, place: Place, by_category: Mapping[str, list[Wanted]]) -> Relation | None:
    """What a relation means where the other item is not there: a sofa looks at the fire, without a screen.

    A wish of one thing to the first others that are there; each of several has another where there are as many.
    """
    for name in place.instead:
        others = [w for w in by_category.get(name, ()) if w is not one and w.support is None]
        if others:
            target, params = others[one.number % len(others)].id, dict(place.params)
            return Relation(
                type=place.type, subject=one.id, target=target, params=params, hard=False, weight=place.weight
            )
    return None


def _centred(one: Wanted, relation: Relation) -> bool:
    """Whether something on a wall has to hang so near the middle of its target that another like it cannot."""
    lateral = relation.params.get("lateral")
    return relation.type == "above" and one.mount == "wall" and lateral is not None and 2 * lateral < one.asset.size[1]


def _beside(wanted: Sequence[Wanted]) -> list[Relation]:
    """The pieces of a run stand close to each other. No relation that lets them into each other's free space: around a
    corner that would shut doors and drawers."""
    return [
        Relation(type="near", subject=b.id, target=a.id, params={"max": CLOSE}, hard=False, weight=0.5)
        for a, b in itertools.pairwise(run_of(wanted))
        if not has_place(a, "in_corner") and not has_place(b, "in_corner")
    ]


def _off_doors(wanted: Sequence[Wanted], room: Room) -> list[Relation]:
    """What stands at walls keeps off the frames of doors where its item says nothing of doors."""
    if not room.doors:
        return []
    said = {"near_door", "away_from_door", *CATALOGUE.with_role("seat")}
    return [
        Relation(type="away_from_door", subject=one.id, params={"min": FRAME}, hard=False, weight=0.5)
        for one in wanted
        if one.item is not None and one.mount == "floor" and one.support is None
        if (types := {p.type for p in one.item.place}) & _EDGE and not types & said
    ]


def _squared(seat: Wanted, table: Wanted) -> Relation:
    """Seats look at the middle of a round table, and stand square to any other."""
    if "round" in table.category:
        return Relation(type="facing", subject=seat.id, target=table.id, hard=False, weight=0.5)
    return Relation(type="aligned", subject=seat.id, target=table.id, hard=False, weight=0.5)


def _cornered(relations: list[Relation], room: Room) -> list[Relation]:
    """No more things bound to corners than there are corners free of doors; the others stand at a wall if they can."""
    left = free_corners(room)
    keep: set[str] = set()
    for hard in (True, False):
        for r in relations:
            if r.type == "in_corner" and r.hard is hard and r.subject not in keep and left > 0:
                keep.add(r.subject)
                left -= 1
    return _without_doubles(
        Relation(type="against_wall", subject=r.subject, hard=False, weight=0.3)
        if r.type == "in_corner" and r.subject not in keep
        else r
        for r in relations
    )


def free_corners(room: Room) -> int:
    """Convex corners of a room that no door opens beside."""
    walls, free = room.walls, 0
    for wall in walls:
        before = walls[wall.index - 1]
        if cross(before.along, wall.along) <= 0:
            continue
        first = any(d.offset < 0.6 for d in room.doors if d.wall == wall.index)
        last = any(before.length - d.offset - d.width < 0.6 for d in room.doors if d.wall == before.index)
        free += not (first or last)
    return free


def _of_place(one: Wanted, place: Place, by_item: dict[str, list[Wanted]], room: Room) -> Relation | None:
    if place.type == "against_wall" and one.mounted_from_behind:
        place = place.model_copy(update={"type": "side_against_wall"})
    kind = CATALOGUE[place.type].target
    params = dict(place.params)
    if place.type == "side_against_wall" and "side" not in params:
        params |= _closed_side(one)
    if params.get("door_walls") == "avoided" and not _free_wall(room, one.asset.size[1]):
        del params["door_walls"]
    target: str | None = None
    other: Wanted | None = None
    if one.support is not None and place.type in CATALOGUE.with_role("edge"):
        return None
    if kind.startswith("window"):
        if not room.windows:
            return None
        target = room.windows[one.number % len(room.windows)].id
        if one.mount == "wall":
            window = room.windows[one.number % len(room.windows)]
            params.setdefault("offset", round(CENTRED + _squeezed(window, room, one.asset.size[1]), 3))
    elif kind.startswith("door"):
        if not room.doors:
            return None
    elif kind.startswith("wall") and place.to not in (None, "wall"):
        target = f"wall:{wall_named(place.to.removeprefix('wall:'), room)}"
    elif kind.startswith("object"):
        other = _instance(one, place.to, by_item)
        if other is None:
            return None
        target = other.id
        if place.type == "above" and other.asset.size[2] + one.asset.size[2] + CEILING > room.height:
            return None
    if place.type == "over" and other is not None and one.mount == "ceiling" and _in_cluster(other):
        pair = by_item[place.to or ""][2 * one.number : 2 * one.number + 2]
        if not pair:
            return None
        target, params = pair[0].id, {**params, "forward": -0.5 * (len(pair) - 1), "offset": 0.1}
    elif place.type == "over" and one.item is not None and other is not None and one.mount == "ceiling":
        lamps = [w for w in by_item[one.item.id] if w.parent is one.parent]
        params = place_along(other.asset.size, lamps.index(one), len(lamps)) | params
    if place.type == "across_from" and one.item is not None and one.parent is not None and "n" not in params:
        beside = [w for w in by_item[one.item.id] if w.parent is one.parent]
        params |= {"k": beside.index(one), "n": len(beside)}
    if place.type == "on_grid" and one.item is not None:
        if one.mount != "ceiling":
            return None
        params |= {"k": by_item[one.item.id].index(one), "n": len(by_item[one.item.id])}
    if place.type == "around" and "n" not in params:
        params["n"] = sum(w.parent is one.parent for w in by_item[one.item.id]) if one.item else 1
        if params["n"] < 2:
            return Relation(type="front_against", subject=one.id, target=target, hard=not place.soft)
    return Relation(
        type=place.type, subject=one.id, target=target, params=params, hard=not place.soft, weight=place.weight
    )


def _closed_side(one: Wanted) -> dict[str, str]:
    """Which side of a thing that is entered from its left or right alone is at the wall: not that of a ladder."""
    entered = {zone.name for zone in one.asset.zones if zone.hard} & {"left", "right"}
    return {"side": "right" if entered == {"left"} else "left"} if len(entered) == 1 else {}


def _in_cluster(one: Wanted) -> bool:
    """Whether a thing stands back to back with the next of its item."""
    return one.item is not None and one.item.row == "cluster"


def _free_wall(room: Room, width: float) -> bool:
    """Whether a wall without a door is wide enough [m] for something with its back to it."""
    doors = {door.wall for door in room.doors}
    return any(wall.length > width and wall.index not in doors for wall in room.walls)


def _squeezed(window: Window, room: Room, width: float) -> float:
    """How far [m] something of a width has to hang off the middle of a window, as its wall ends beside it."""
    middle = window.offset + window.width / 2
    return max(0.0, width / 2 - min(middle, room.walls[window.wall].length - middle))


def _instance(one: Wanted, name: str | None, by_item: dict[str, list[Wanted]]) -> Wanted | None:
    """Which instance of an item is meant: its own parent, the one before it in a chain, or one by its number."""
    others = by_item.get(name or "", [])
    if one.item is not None and name == one.item.id:
        earlier = [w for w in others if w.number == one.number - 1]
        return earlier[0] if earlier else None
    for kin in (one.parent, one.parent and one.parent.parent, one.support):
        if kin is not None and kin in others:
            return kin
    siblings = [w for w in others if w.parent is not None and w.parent is one.parent]
    pool = siblings or others
    alike = len(by_item[one.item.id]) if one.item is not None and one.parent is None else 1
    if 1 < alike < len(pool):  # few among many are spread: a bin for each cluster of desks
        return pool[one.number * len(pool) // alike % len(pool)]
    return pool[one.number % len(pool)] if pool else None


def stated_rows(brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What the request states of the objects to be, to the letter."""
    return grounded(brief, _made(wanted))[0]


def rows_of(brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What the request states of the objects to be."""
    return set_under(patterned(reconciled(stated_rows(brief, wanted), wanted), brief, wanted), wanted)


def _made(wanted: Sequence[Wanted]) -> dict[str, list[Thing]]:
    """The objects that stand for each entity of the request."""
    made: dict[str, list[Thing]] = {}
    for one in wanted:
        if one.asked is not None:
            made.setdefault(one.asked, []).append(one.thing)
    return made


def of_brief(
    brief: SceneGraph, wanted: Sequence[Wanted], room: Room, failed: Sequence[Grounded] = ()
) -> tuple[list[Relation], dict[str, frozenset[str]], list[str]]:
    """The relations that were asked for.

    Args:
        brief: the request.
        wanted: the objects to be.
        room: the empty room.
        failed: what was stated of small things and found no place; it stays wished for.

    Returns:
        The relations (hard), by id the types of a room's own relations that they replace, and what could not be said
        as relations.
    """
    made = _made(wanted)
    rows, unsaid = grounded(brief, made)
    rows = set_under(patterned(reconciled(rows, wanted), brief, wanted), wanted)
    rows = [replace(row, hard=False) if row in failed else row for row in rows]
    found: list[Relation] = []
    placed: dict[str, frozenset[str]] = led(brief, wanted)
    unmet = [f"{_said(said)}: {_lack(said, made)}" for said in unsaid if not said.implied]
    for row, relation in in_room(rows, room, unmet):
        found.append(relation)
        if not row.hard:
            continue
        replaced = CONFLICTS.get(relation.type, frozenset())
        if relation.type in TOGETHER:
            replaced |= TOGETHER
        if isinstance(row.target, str) and row.target.partition(":")[2] in PARTS:  # an alcove has room for it alone
            replaced |= CONFLICTS["arranged"] | TOGETHER
        placed[row.subject] = placed.get(row.subject, frozenset()) | replaced
        if relation.type in BEHIND_IT or (relation.type == "seated_at" and relation.params.get("side") == "back"):
            for target in relation.targets:
                placed[target] = placed.get(target, frozenset()) | FREE_STANDING
    return _without_doubles(found), placed, unmet


def in_room(rows: Iterable[Grounded], room: Room, unmet: list[str]) -> Iterator[tuple[Grounded, Relation]]:
    """Grounded relations with the walls and openings of a room; of those that it has not ``unmet`` is told."""
    rows = list(rows)
    number: dict[tuple[str, str], int] = {}
    # What stands below windows along their walls takes one after the other, whichever sentence says so.
    below = [row.subject for row in rows if row.target == "window" and CATALOGUE[row.type].target_kind == "wall"]
    for row in rows:
        named = isinstance(row.target, str) and row.target.startswith("wall:")
        key = (str(row.target), "") if named else (row.said, row.type)  # at one end, at the other end
        k = number[key] = number.get(key, -1) + 1
        if row.subject in below and row.type in ("at_window", "against_wall"):
            k = below.index(row.subject)
        try:
            relation = _in_room(row, room, k)
        except InputError as error:
            unmet.append(f"{row.said}: {error}")
            continue
        if relation is None:
            unmet.append(f"{row.said}: there is nothing to relate {row.subject} to")
        else:
            yield row, relation


def _in_room(row: Grounded, room: Room, number: int) -> Relation | None:
    """A grounded relation with the walls and openings of a room; None where the room has no such thing.

    Raises:
        InputError: for a wall that the room has not.
    """
    target, kind = row.target, CATALOGUE[row.type].target_kind
    if kind == "wall" and target == "window":
        if not room.windows:
            return None
        target = f"wall:{room.windows[number % len(room.windows)].wall}"
    elif kind == "wall" and isinstance(target, str):
        target = f"wall:{wall_named(target.split(':', 1)[1], room, number)}"
    elif kind == "window":
        if not room.windows:
            return None
        target = room.windows[number % len(room.windows)].id if row.type == "at_window" else None
    elif kind == "door":
        if not room.doors:
            return None
        target = None
    return Relation(
        type=row.type,
        subject=row.subject,
        target=target,
        params=row.params,
        hard=row.hard,
        weight=1.0 if row.hard else 0.5,
        asked=True,
        request=row.said,
    )


def _said(said: StatedRelation) -> str:
    return f"{said.id} '{said.words}'" if said.words else said.id or said.type


def _lack(said: StatedRelation, made: Mapping[str, Sequence[Thing]]) -> str:
    """Why a stated relation has no objects to hold between."""
    for name in (said.subject, *said.targets):
        if name.partition(":")[0] not in PLACES and not made.get(name):
            return f"there is no {name.replace('_', ' ')} in the room"
    return "no relation can say it"


def wall_named(name: str, room: Room, number: int = 0) -> int:
    """The wall that "left", "right", "far", "near" (seen from the door), a compass point, "long" or "short" names, or a
    number; of several walls that are meant one without a door, the next one for each ``number``.

    Raises:
        InputError: for another name.
    """
    meant = walls_meant(name, room)
    if not meant and name.isdigit():
        raise InputError(f"wall {name}: the room has walls 0 to {len(room.walls) - 1}")
    way = direction_of(name, room)
    if way is not None:
        return max((round(dot(wall.outward, way), 1), wall.length, wall.index) for wall in room.walls)[2]
    if not meant:
        raise InputError(
            f"wall '{name}' is unknown; say left, right, far, near, north, south, east, west, long or short"
        )
    doors = {door.wall for door in room.doors}
    shut = [k for k in meant if k not in doors] or meant
    return sorted(shut, key=lambda k: -room.walls[k].length)[number % len(shut)]


def _without_doubles(relations: Iterable[Relation]) -> list[Relation]:
    seen: set[tuple] = set()
    kept = []
    for r in relations:
        names = (r.subject, *r.targets)
        key = (r.type, tuple(sorted(names)) if r.type in SYMMETRIC else names)
        if key not in seen:
            seen.add(key)
            kept.append(r)
    return kept
