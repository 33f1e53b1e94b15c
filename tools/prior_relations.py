"""The relations of a room's items and of a request, between the objects that stand for them."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence

from sceneweaver.brief import Meaning, SceneGraph, meaning
from sceneweaver.brief.wall_names import direction_of
from sceneweaver.geometry.angles import cross, dot
from sceneweaver.knowledge import Place
from sceneweaver.scene import CATALOGUE, InputError, Relation, Room

from .prior_program import Wanted
from .prior_rows import run_of
from .prior_seats import seat_relations

CONFLICTS: dict[str, frozenset[str]] = {
    "against_wall": frozenset(("against_wall", "in_corner", "at_window")),
    "side_against_wall": frozenset(("against_wall", "in_corner", "at_window")),
    "in_corner": frozenset(("at_window", "centered_on")),
    "at_window": frozenset(("in_corner", "centered_on")),
    "between": frozenset(("in_corner", "at_window", "near")),
    "middle": frozenset(("against_wall", "side_against_wall", "in_corner", "at_window", "near", "centered_on")),
}
"""What a room's own relations of a thing give way to: the type that was asked for, and the types that it replaces."""

CEILING = 0.15
"""Height [m] that is left free above what hangs over something."""

SYMMETRIC = CATALOGUE.with_role("symmetric")


def of_items(wanted: Sequence[Wanted], room: Room, but: Mapping[str, frozenset[str]]) -> list[Relation]:
    """The relations that the items say, each for its instances; ``but`` has types that do not hold for some ids."""
    by_item: dict[str, list[Wanted]] = {}
    for one in wanted:
        if one.item is not None:
            by_item.setdefault(one.item.id, []).append(one)
    found: list[Relation] = []
    for one in wanted:
        for place in one.item.place if one.item else ():
            if place.type in but.get(one.id, ()):
                continue
            relation = _of_place(one, place, by_item, room)
            if relation is None:
                continue
            found.append(relation)
            if relation.type in ("front_against", "around") and one.parent is not None:
                found.append(_squared(one, one.parent))
            if relation.type == "above" and one.mount == "wall":  # at the wall behind it, not at the one opposite
                found.append(
                    Relation(
                        type="near", subject=one.id, target=relation.target, params={"max": 0.3}, hard=relation.hard
                    )
                )
    return _cornered(_without_doubles([*found, *seat_relations(wanted), *_beside(wanted)]), room)


def _beside(wanted: Sequence[Wanted]) -> list[Relation]:
    """The pieces of a run stand side by side, over the corner too; so they may reach into each other's free space."""
    return [
        Relation(type="side_by_side", subject=b.id, target=a.id, hard=False, weight=0.5)
        for a, b in itertools.pairwise(run_of(wanted))
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
    target: str | None = None
    if one.support is not None and place.type in CATALOGUE.with_role("edge"):
        return None
    if kind.startswith("window"):
        if not room.windows:
            return None
        target = room.windows[one.number % len(room.windows)].id
        width = room.windows[one.number % len(room.windows)].width
        if one.mount == "wall" and "overlap" not in params:  # a curtain hangs before the middle of its window
            params["overlap"] = max(0.1, round(0.95 * min(1.0, width / one.asset.size[1]), 2))
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
    if place.type == "around" and "n" not in params:
        params["n"] = sum(w.parent is one.parent for w in by_item[one.item.id]) if one.item else 1
        if params["n"] < 2:
            return Relation(type="front_against", subject=one.id, target=target, hard=not place.soft)
    return Relation(
        type=place.type, subject=one.id, target=target, params=params, hard=not place.soft, weight=place.weight
    )


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
    return pool[one.number % len(pool)] if pool else None


def of_brief(
    brief: SceneGraph, wanted: Sequence[Wanted], room: Room
) -> tuple[list[Relation], dict[str, frozenset[str]], list[str]]:
    """The relations that were asked for.

    Returns the relations (hard), by id the types of a room's own relations that they replace, and what could not be
    said as relations.
    """
    made: dict[str, list[Wanted]] = {}
    for one in wanted:
        if one.asked is not None:
            made.setdefault(one.asked, []).append(one)
    found: list[Relation] = []
    placed: dict[str, frozenset[str]] = {}
    unmet: list[str] = []
    for said in brief.relations:
        subjects = made.get(said.subject, [])
        meant = meaning(said, brief)
        if meant is None:
            unmet.append(f"{said.words}: no relation can say it")
            continue
        if meant.target == "middle":
            found += _in_the_middle([w for w in subjects if w.mount == "floor"])
            placed.update({w.id: CONFLICTS["middle"] for w in subjects})
            continue
        for number, one in enumerate(subjects):
            if meant.type in ("on_top", "inside") and one.support is not None:
                continue  # true by its support
            try:
                relation = _of_asked(meant, one, number, len(subjects), made, room)
            except InputError as error:
                unmet.append(f"{said.words or said.type}: {error}")
                continue
            if relation is None:
                unmet.append(f"{said.words or said.type}: there is nothing to relate {one.id} to")
                continue
            found.append(relation)
            placed[one.id] = placed.get(one.id, frozenset()) | CONFLICTS.get(meant.type, frozenset())
    return _without_doubles(found), placed, unmet


def _in_the_middle(wanted: Sequence[Wanted]) -> list[Relation]:
    """What stands in the middle of the room: one thing right there, several around it."""
    most = sum(max(w.asset.size[:2]) for w in wanted)
    offset = 0.1 if len(wanted) == 1 else round(0.3 + most / 2, 2)
    return [Relation(type="in_middle", subject=w.id, params={"offset": offset}, asked=True) for w in wanted]


def _of_asked(
    meant: Meaning, one: Wanted, number: int, count: int, made: dict[str, list[Wanted]], room: Room
) -> Relation | None:
    kind = CATALOGUE[meant.type].target
    params = dict(meant.params)
    target: str | tuple[str, str] | None = None
    if kind.startswith("wall"):
        if isinstance(meant.target, str) and ":" in meant.target:
            target = f"wall:{wall_named(meant.target.split(':', 1)[1], room)}"
    elif kind.startswith("window"):
        if not room.windows:
            return None
        target = room.windows[number % len(room.windows)].id
    elif kind == "objects":
        names = meant.target if isinstance(meant.target, tuple) else ()
        pool = [made.get(name, []) for name in names]
        if len(pool) == 1 and len(pool[0]) > 1:
            pair = pool[0][:2]
        elif len(pool) == 2 and all(pool):
            pair = [pool[0][0], pool[1][-1]]
        else:
            return None
        if pair[0] is pair[1]:
            return None
        target = (pair[0].id, pair[1].id)
    elif kind.startswith("object"):
        others = [w for w in made.get(str(meant.target), []) if w is not one]
        if not others:
            return None
        target = others[number % len(others)].id
    if meant.type == "around":
        params["n"] = count
        if count < 2:
            return Relation(type="front_against", subject=one.id, target=target)
    return Relation(type=meant.type, subject=one.id, target=target, params=params)


def wall_named(name: str, room: Room) -> int:
    """The wall that "left", "right", "far", "near" (seen from the door) or a compass point names, or a number.

    Raises:
        InputError: for another name.
    """
    if name.isdigit():
        if int(name) >= len(room.walls):
            raise InputError(f"wall {name}: the room has walls 0 to {len(room.walls) - 1}")
        return int(name)
    way = direction_of(name, room)
    if way is None:
        raise InputError(f"wall '{name}' is unknown; say left, right, far, near, north, south, east or west")
    return max((round(dot(wall.outward, way), 1), wall.length, wall.index) for wall in room.walls)[2]


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
