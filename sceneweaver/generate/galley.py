"""Kitchens in two runs: one washes at the first, cooks at the one along the wall opposite, with a way between."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterator, Sequence

from sceneweaver.geometry.angles import dot
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import CATALOGUE, Relation, Room

from .kitchen_runs import at_wall, in_two_runs
from .program import Wanted
from .run import TIGHT, Variant, has_place, run_of, windows_from

COOKED = ("stove", "fridge", "counter", "cabinet", "hood")
"""Items of the run at which one cooks; the others go with the sink."""

WAY = 0.95
"""Least way [m] between the two runs."""

OPPOSITE = -0.98
"""Cosine between the ways out of two walls that are opposite each other."""

OFF_WINDOW = 0.5
"""What it counts against a wall that a sink for which a window is wanted has none there."""


def parted(brief: SceneGraph, pieces: Sequence[Wanted]) -> tuple[list[Wanted], list[Wanted]]:
    """The pieces of the run of the sink and those of the run opposite, each in order.

    What the request has opposite another piece, or at a wall, is where it says; the rest goes with what is used
    together.
    """
    side: dict[str, int] = {}
    walls: dict[str, int] = {}
    usual = {one.id: int(_name(one) in COOKED) for one in pieces}
    for said in brief.relations:
        for one in (w for w in pieces if w.asked == said.subject and said.targets):
            if at_wall(said.targets):
                wall = said.targets[0]
                if wall not in walls:
                    walls[wall] = usual[one.id] if not walls else 1 - next(iter(walls.values()))
                side[one.id] = walls[wall]
    for said in brief.relations:
        others = [w for w in pieces if w.asked in said.targets]
        for one in (w for w in pieces if w.asked == said.subject and others and said.type == "opposite"):
            side.setdefault(others[0].id, usual[others[0].id])
            side.setdefault(one.id, 1 - side[others[0].id])
    groups = {k: [side[w.id] for w in pieces if usual[w.id] == k and w.id in side] for k in (0, 1)}
    flipped = any(groups[k] and all(at != k for at in groups[k]) for k in (0, 1))
    for one in pieces:
        side.setdefault(one.id, 1 - usual[one.id] if flipped else usual[one.id])
    return [w for w in pieces if side[w.id] == 0], [w for w in pieces if side[w.id] == 1]


def galley_runs(brief: SceneGraph, pieces: Sequence[Wanted], room: Room) -> tuple[list[Variant], float]:
    """The two runs at each two walls that are opposite each other and long enough, the best first, and what speaks
    against the best: infinite where no walls are."""
    first, second = parted(brief, pieces)
    found: list[tuple[float, int, Variant]] = []
    for one, two in _opposite_walls(room):
        if not first or not second:
            break
        if not (_holds(room, one, first) and _holds(room, two, second)):
            continue
        eyed = any(has_place(w, "at_window") for w in first)
        cost = OFF_WINDOW * (eyed and not windows_from(room, one, True))
        cost += 0.1 * (room.walls[one].length < max(wall.length for wall in room.walls) - 0.01)
        found.append((cost, len(found), (*_along(first, one), *_along(second, two))))
    found.sort(key=lambda way: way[:2])
    return [way for _, _, way in found], found[0][0] if found else math.inf


def without_runs(rows: Sequence[Grounded], brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What is stated, without what says of one piece of two runs where it is to another, or at just any wall."""
    pieces = run_of(wanted)
    if not in_two_runs(brief, {one.category for one in pieces}):
        return list(rows)
    run = {one.id for one in pieces}
    types = CATALOGUE.with_role("placing", "turning") | {"distance", "near"}
    return [
        row
        for row in rows
        if row.subject not in run
        or not (
            (row.type in types and row.target in run)
            or (row.type in ("against_wall", "side_against_wall") and row.target in (None, "wall"))
        )
    ]


def _name(one: Wanted) -> str:
    return one.item.id if one.item is not None else one.category


def _opposite_walls(room: Room) -> Iterator[tuple[int, int]]:
    for one, two in itertools.permutations(room.walls, 2):
        if dot(one.outward, two.outward) < OPPOSITE and _apart(room, one.index, two.index) >= WAY:
            yield one.index, two.index


def _apart(room: Room, one: int, two: int) -> float:
    """Way [m] between what is at two opposite walls."""
    a, b = room.walls[one], room.walls[two]
    return abs(a.coordinates(b.start)[1]) - 2 * 0.62


def _holds(room: Room, wall: int, pieces: Collection[Wanted]) -> bool:
    """Whether a wall has a stretch without doors that is long enough for some pieces."""
    length = room.walls[wall].length
    doors = sorted((d.offset, d.offset + d.width) for d in room.doors if d.wall == wall)
    ends = [0.0, *(x for door in doors for x in door), length]
    free = max(b - a for a, b in zip(ends[::2], ends[1::2], strict=True))
    return sum(one.asset.size[1] + TIGHT["gap"][1] for one in pieces) <= free - 0.02  # type: ignore[index]


def _along(pieces: Sequence[Wanted], wall: int) -> Variant:
    """The relations of a run along a wall."""
    leader = pieces[0].id
    params = {"gap": TIGHT["gap"], "degrees": TIGHT["degrees"]}
    found = [Relation(type="against_wall", subject=leader, target=f"wall:{wall}", params=params)]
    for a, b in itertools.pairwise(pieces):
        found.append(Relation(type="run_on", subject=b.id, target=a.id, params={"side": "right", **TIGHT}))
    return tuple(found)


__all__ = ["galley_runs", "parted", "without_runs"]
