"""Stated relations grounded in the objects that stand for what a request names: which of them is related to which, by
which relations of the catalogue.

Sides are turned here: a request means those of who looks at a thing's front, the catalogue those of the thing itself,
so that what stands to the right of a bed is on the bed's own left.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from sceneweaver.rules.relation import VIEWED
from sceneweaver.rules.stated import number as number_of

from .model import PLACES, SceneGraph, StatedRelation
from .pairs import Thing, of_pair, of_place

FURTHEST: float = number_of("furthest")
"""Most distance [m] where none is given."""

SIDED = {"left_of": "left", "right_of": "right", "in_front_of": "front", "behind": "back"}
"""Stated relations that name a side of their target."""


@dataclass(frozen=True)
class Grounded:
    """A relation of the catalogue between objects.

    ``said`` is the id of the stated relation; ``target`` the id of an object, two of them, a place (`PLACES`), or None.
    What is not ``hard`` only makes it look as it is usually meant.
    """

    said: str
    type: str
    subject: str
    target: str | tuple[str, str] | None = None
    params: dict[str, Any] = field(default_factory=dict)
    hard: bool = True


@dataclass(frozen=True)
class _Pair:
    """One subject and one target, with the side of the target in its own frame; the ``k``-th of ``n`` there."""

    subject: Thing
    target: Thing
    side: str | None = None
    k: int = 0
    n: int = 1


def grounded(graph: SceneGraph, things: Mapping[str, Sequence[Thing]]) -> tuple[list[Grounded], list[StatedRelation]]:
    """The relations of a graph between the things that stand for its entities, given by the entities' ids.

    Returns:
        The relations, and the stated ones that nothing in the catalogue says or that lack something to relate to.
        What stands on something and what hangs from walls and ceilings do so by what holds them: no relation says it.
    """
    known = {thing.id: thing for several in things.values() for thing in several}
    taken: dict[str, int] = {}
    sides: dict[str, int] = {}
    found: list[Grounded] = []
    unsaid: list[StatedRelation] = []
    along = {(said.subject, said.targets) for said in graph.relations if said.type == "along"}
    for said in named(graph):
        if said.type == "around" and (said.subject, said.targets) in along:
            continue  # "surrounded by six chairs along its long sides": there, and nowhere else
        if said.type in ("on", "inside") and not _is_place(said):
            rows = list(_held(said, things, known))
        elif _is_place(said):
            rows = list(_in_place(said, things, known, taken))
        else:
            rows = list(_between_things(said, things, known, taken, sides))
        if not rows and not _holds_anyway(said, things):
            unsaid.append(said)
        found += [row for row in rows if row.type]
    return _once(found), unsaid


def named(graph: SceneGraph) -> list[StatedRelation]:
    """The stated relations of a graph, each with an id: that of a graph made by hand may have none."""
    return [
        said if said.id else said.model_copy(update={"id": f"relation-{k}"}) for k, said in enumerate(graph.relations)
    ]


def _is_place(said: StatedRelation) -> bool:
    return said.targets[:1] != () and said.targets[0].partition(":")[0] in PLACES


def carrier_of(said: StatedRelation, things: Mapping[str, Sequence[Thing]], number: int) -> Thing | None:
    """The thing that carries the ``number``-th subject of a stated "on" or "inside": each target in turn."""
    pool = [thing for name in said.targets for thing in things.get(name, ())]
    if not pool:
        return None
    if said.nth:
        return one_in_order(pool, said.nth)
    subjects = len(things.get(said.subject, ()))
    share = max(1, -(-subjects // len(pool))) if said.each else 1
    return pool[(number // share) % len(pool)]


def one_in_order(pool: Sequence[Thing], nth: int) -> Thing | None:
    """The ``nth`` of some things along their row, -1 for the last; None where there are fewer.

    A row is set out about its middle one, which is the first of the things.
    """
    first = len(pool) // 2
    row = [*pool[1 : first + 1], *pool[:1], *pool[first + 1 :]]
    at = nth - 1 if nth > 0 else len(row) + nth
    return row[at] if 0 <= at < len(row) else None


def _held(
    said: StatedRelation, things: Mapping[str, Sequence[Thing]], known: Mapping[str, Thing]
) -> Iterator[Grounded]:
    """What is on or in something by its support; on a rug, or on what carries nothing, it is over it."""
    for number, subject in enumerate(_chosen(said, things.get(said.subject, ()), {})):
        target = carrier_of(said, things, number)
        if target is None or target is subject:
            continue
        if subject.carrier is not None:
            if subject.carrier == target.id:
                yield Grounded(said.id, "", subject.id)
            continue
        yield from _rows(said, _Pair(subject, target), known)


def _in_place(
    said: StatedRelation, things: Mapping[str, Sequence[Thing]], known: Mapping[str, Thing], taken: dict[str, int]
) -> Iterator[Grounded]:
    subjects = _chosen(said, things.get(said.subject, ()), taken)
    for subject in subjects:
        root = _root(subject, known)
        for type_, target, params in of_place(said, root, len(subjects)):
            yield Grounded(said.id, type_, root.id, target, {**params, **said.params})


def _between_things(
    said: StatedRelation,
    things: Mapping[str, Sequence[Thing]],
    known: Mapping[str, Thing],
    taken: dict[str, int],
    sides: dict[str, int],
) -> Iterator[Grounded]:
    groups = [list(things.get(name, ())) for name in said.targets]
    everything = things.get(said.subject, ())
    if not everything or not groups or not all(groups):
        return
    if said.type == "between":
        pool = [thing for group in groups for thing in group]
        ends = (pool[0], pool[-1])
        for subject in _chosen(said, everything, taken):
            if len({subject.id, ends[0].id, ends[1].id}) == 3:
                yield Grounded(said.id, "between", subject.id, (ends[0].id, ends[1].id), dict(said.params))
        return
    for group in groups:
        if said.nth and (one := one_in_order(group, said.nth)) is not None:
            group = [one]
        pairs = _paired(said, everything, group, taken, sides)
        for pair in pairs:
            yield from _rows(said, pair, known)


def _chosen(said: StatedRelation, subjects: Sequence[Thing], taken: dict[str, int]) -> list[Thing]:
    """The subjects that are meant: all, or the next so many of which no other such relation has spoken."""
    if said.count is None or said.count[0] >= len(subjects):
        return list(subjects)
    first = taken.get(said.subject, 0)
    taken[said.subject] = first + said.count[0]
    return [subjects[(first + k) % len(subjects)] for k in range(max(1, said.count[0]))]


def _paired(
    said: StatedRelation,
    everything: Sequence[Thing],
    group: Sequence[Thing],
    taken: dict[str, int],
    sides: dict[str, int],
) -> list[_Pair]:
    """Subjects with their targets: each target in turn, each side of it in turn."""
    wanted = _sides_of(said, group[0])
    if said.type == "flanking" and len(everything) > len(wanted) and everything[0].is_seat and group[0].is_table:
        wanted = _sides_of(said.model_copy(update={"type": "along"}), group[0])  # more chairs than a table has ends
    if said.type == "around" and not said.each and len(everything) >= 4 and _is_long(everything[0], group[0]):
        wanted = _all_sides(group[0], len(everything))
    if said.each and said.count is not None:
        many = said.count[0] * len(group if not wanted else [(t, s) for t in group for s in wanted])
        subjects = list(everything)[:many]
    else:
        subjects = _chosen(said, everything, taken)
    subjects = [s for s in subjects if s not in group or len(group) > 1]
    if said.subject in said.targets:  # "two sofas facing each other": each to the next
        pairs = [_Pair(a, group[(i + 1) % len(group)]) for i, a in enumerate(group)]
        return pairs[:-1] if said.type in ("side_by_side", "parallel", "aligned", "next_to") else pairs
    share = 1 if len(subjects) <= len(group) or not said.each else -(-len(subjects) // len(group))
    share = len(subjects) if len(group) == 1 else share
    rows: list[tuple[Thing, Thing, str | None]] = []
    for number, subject in enumerate(subjects):
        target = group[(number // share) % len(group)] if share > 1 else group[number % len(group)]
        side = None
        if wanted:
            at = sides.get(target.id, 0) if said.type == "flanking" else sum(t is target for _, t, _ in rows)
            side = wanted[at % len(wanted)]
            if said.type == "flanking":
                sides[target.id] = at + 1
        rows.append((subject, target, side))
    spots: dict[tuple[str, str | None], int] = {}
    numbered = []
    for subject, target, side in rows:
        k = spots[target.id, side] = spots.get((target.id, side), -1) + 1
        numbered.append(_Pair(subject, target, side, k))
    return [replace(pair, n=spots[pair.target.id, pair.side] + 1) for pair in numbered]


def _is_long(subject: Thing, target: Thing) -> bool:
    """Whether seats go around a table that is much longer than deep: even angles would leave its ends crowded."""
    return subject.is_seat and target.is_table and max(target.size[:2]) > number_of("long_table") * min(target.size[:2])


def _all_sides(target: Thing, count: int) -> list[str]:
    """The side of a long table for each of so many seats: one at each end from six on, the others along its sides."""
    depth, width = target.size[:2]
    long, short = (["front", "back"], ["left", "right"]) if width >= depth else (["left", "right"], ["front", "back"])
    ends = short if count >= 6 and min(depth, width) >= number_of("deep_table") else []
    return [long[k % 2] for k in range(count - len(ends))] + ends


def _sides_of(said: StatedRelation, target: Thing) -> list[str]:
    """The sides of a target, in its own frame, that a relation speaks of; none when of any."""
    depth, width = target.size[:2]
    long, short = (["front", "back"], ["left", "right"]) if width >= depth else (["left", "right"], ["front", "back"])
    if said.side in ("left", "right"):
        return [VIEWED[said.side]]
    if said.side == "long" or (said.type == "along" and said.side is None):
        return long
    if said.side == "short" or (said.type in ("at_head", "at_foot") and target.is_table):
        return short
    if said.type == "flanking" or (said.type == "around" and target.mount == "wall"):
        return ["left", "right"]
    return [VIEWED[SIDED[said.type]]] if said.type in SIDED else []


def _rows(said: StatedRelation, pair: _Pair, known: Mapping[str, Thing]) -> Iterator[Grounded]:
    """The relations of one pair; what stands on different things is related through these."""
    subject, target = pair.subject, pair.target
    meant = said.each and (subject.carrier is None) != (target.carrier is None)  # glasses in front of each chair
    if subject.carrier != target.carrier:
        subject, target = _root(subject, known), _root(target, known)
        if subject is target:
            yield Grounded(said.id, "", subject.id)
            return
    for row in of_pair(said.type, subject, target, pair.side, pair.k, pair.n):
        first, second = (target, subject) if row.swapped else (subject, target)
        if said.params and row.type in ("distance", "near"):
            low, high = said.params.get("min") or 0.0, said.params.get("max") or FURTHEST
            row = row._replace(type="distance", params={"min": low, "max": high})
            if not low:
                row = row._replace(type="near", params={"max": high})
        yield Grounded(said.id, row.type, first.id, second.id, dict(row.params), row.hard and not meant)


def _root(thing: Thing, known: Mapping[str, Thing]) -> Thing:
    """What carries a thing in the end: itself where it stands on the floor or hangs."""
    for _ in range(len(known)):
        if thing.carrier is None or thing.carrier not in known:
            return thing
        thing = known[thing.carrier]
    return thing


def _holds_anyway(said: StatedRelation, things: Mapping[str, Sequence[Thing]]) -> bool:
    """Whether a place needs no relation: what hangs on a wall or from the ceiling, what stands in the room."""
    subjects, place = things.get(said.subject, ()), said.targets[0] if said.targets else ""
    if not subjects:
        return False
    mounts = {thing.mount for thing in subjects}
    return (
        place in ("floor", "room")
        or (place == "ceiling" and mounts == {"ceiling"})
        or (place == "wall" and mounts == {"wall"})
    )


def _once(rows: Sequence[Grounded]) -> list[Grounded]:
    """The relations without those that another says already, a hard one before a soft one."""
    kept: dict[tuple[str, str, Any], Grounded] = {}
    for row in rows:
        key = (row.type, row.subject, row.target)
        if key not in kept or (row.hard and not kept[key].hard):
            kept[key] = row
    return list(itertools.chain(kept.values()))
