"""Measures of the plan as a whole: circulation, rooms with water, distances between rooms."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations

from ..profile import Rule
from ..room_types import selects
from .facts import PlanFacts
from .geometry import facing_span
from .parts import RoomFacts
from .readings import Reading, measure
from .walls import metres

SHARED_WALL, THICK = 300, 400
"""Rooms share a wall where faces lie at most `THICK` apart over at least `SHARED_WALL` [mm]."""

STOREY_WAY = 3000
"""What a storey counts as distance [mm]."""


@measure("circulation_share")
def circulation_share(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Floor of halls by floor of all rooms indoors; stairs count in neither."""
    rooms = [room for room in plan.rooms if not room.outdoor and not room.has("stairs")]
    halls = [room for room in rooms if room.has("circulation")]
    whole = sum((room.area for room in rooms), Fraction(0))
    if whole:
        share = sum((room.area for room in halls), Fraction(0)) / whole
        yield Reading(tuple(r.id for r in halls), share, "halls and corridors: share of the floor", "%")


def share_wall(a: RoomFacts, b: RoomFacts) -> bool:
    """Whether two rooms of a storey lie on both sides of a wall."""
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a.box, b.box
    if max(ax0 - bx1, bx0 - ax1) > THICK or max(ay0 - by1, by0 - ay1) > THICK:
        return False
    if a.straight and b.straight:
        spans = (facing_span(wall, far) for wall in a.walls for far in b.walls)
        return any(span is not None and span[0] <= THICK and span[2] - span[1] >= SHARED_WALL for span in spans)
    return a.polygon.buffer(THICK / 2).intersection(b.polygon.buffer(THICK / 2)).length >= 2 * SHARED_WALL + 2 * THICK


@measure("wet_groups")
def wet_groups(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Groups of rooms with water that share walls, or stand one over the other in storeys that follow."""
    wet = [room for room in plan.rooms if room.has("wet") and not room.outdoor]
    group = list(range(len(wet)))
    for i, j in combinations(range(len(wet)), 2):
        a, b = wet[i], wet[j]
        apart = abs(a.storey - b.storey)
        if apart <= 1 and (share_wall(a, b) if apart == 0 else (a.region & b.region).area > 0):
            old, new = group[j], group[i]
            group = [new if g == old else g for g in group]
    ids = tuple(room.id for room in wet)
    parts = [" + ".join(wet[i].id for i in range(len(wet)) if group[i] == g) for g in sorted(set(group))]
    yield Reading(ids, Fraction(len(parts)), f"rooms with water ({'; '.join(parts)}): groups", "")


@measure("distance")
def distance(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """From a room to the nearest of the others along the axes; a storey counts 3 m. A room that is both is at 0."""
    others = list(plan.selected(rule.to))
    for room in plan.selected(rule.of) if others else ():
        if selects(rule.to, room.kind):
            continue
        found = min(((gap(room, other), other.id) for other in others), default=None)
        if found is not None:
            yield Reading((room.id, found[1]), metres(found[0]), f"{room.id} to {found[1]}: distance", "m")


def gap(a: RoomFacts, b: RoomFacts) -> int:
    """Least distance along the axes between two floors, with `STOREY_WAY` for each storey between [mm].

    Where a wall is oblique it is the straight distance.
    """
    if a.straight and b.straight:
        flat = min(
            max(p[0] - q[2], q[0] - p[2], 0) + max(p[1] - q[3], q[1] - p[3], 0)
            for p in a.region.boxes
            for q in b.region.boxes
        )
    else:
        flat = round(a.polygon.distance(b.polygon))
    return flat + STOREY_WAY * abs(a.storey - b.storey)
