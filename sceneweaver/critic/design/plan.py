"""Measures between bodies in plan: gaps, angles, offsets, shared area, and which seats go with which table."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.verify.solids import Body, Opening

from ..seats import seats_at as seats_of
from ..seats import table_of
from ..survey import FLAT, Survey, turn_to
from .query import kind_set, listed
from .registry import measure, spot


@measure
def gap(survey: Survey, a: Body, b: Body) -> float:
    """Distance [m] between two boxes in plan."""
    return float(survey.boxes[a.index].distance(survey.boxes[b.index]))


@measure
def distance(survey: Survey, o: Body, others: Any) -> float:
    """Distance [m] between two footprints, or to the nearest of several; infinite to none."""
    return min((survey.placed.distance(o, b) for b in listed(others)), default=math.inf)


@measure
def nearest(survey: Survey, o: Body, others: Sequence[Body]) -> float:
    """Gap [m] in plan to the nearest of some others; infinite without."""
    return min((gap(survey, o, b) for b in others if b is not o), default=math.inf)


@measure
def near_count(survey: Survey, o: Body, others: Sequence[Body], reach: float) -> int:
    """How many of some others are within a gap [m]."""
    ids = {b.index for b in others}
    return sum(b.index in ids for b, _ in survey.near(o, reach))


@measure
def smallest_gap(survey: Survey, bodies: Sequence[Body], others: Sequence[Body], most: float) -> float:
    """The least gap [m] from any of some bodies to any other of a set, up to a distance."""
    return min((min(most, nearest(survey, b, others)) for b in bodies), default=most)


@measure
def away(_: Survey, a: Body, b: Body) -> float:
    """Distance [m] between two middles."""
    return math.dist(a.centre, b.centre)


@measure
def least_away(_: Survey, o: Body, others: Sequence[Body | Opening]) -> float:
    """Distance [m] from the middle of a body to the nearest middle of some others; infinite without."""
    return min((math.dist(o.centre, spot(b)) for b in others), default=math.inf)


@measure
def bearing(_: Survey, o: Body, others: Any) -> float:
    """Angle [deg] in 0..180 between the front of a body and the way to another, the least of several."""
    return min(math.degrees(turn_to(o, spot(other))) for other in listed(others))


@measure
def turned(_: Survey, a: Body, b: Body, period: float = 360.0) -> float:
    """Angle [deg] between two fronts, modulo a period."""
    return abs(math.degrees(wrap_angle(b.yaw - a.yaw, math.radians(period))))


@measure
def forward(_: Survey, base: Body, o: Body) -> float:
    """How far [m] a body is ahead of another's middle."""
    return base.local(o.centre)[0]


@measure
def sideways(_: Survey, base: Body, o: Body) -> float:
    """How far [m] a body is to the left of another's middle."""
    return base.local(o.centre)[1]


@measure
def lateral(_: Survey, base: Body, o: Any) -> float:
    """How far [m] a body, or the middle of several, is off the axis of another."""
    if isinstance(o, Body):
        return abs(base.local(o.centre)[1])
    low, high = _sides(base, o)
    return abs((low + high) / 2)


@measure
def extent(_: Survey, base: Body, bodies: Sequence[Body]) -> float:
    """Width [m] that some bodies take together across the axis of another."""
    low, high = _sides(base, bodies)
    return high - low


def _sides(base: Body, bodies: Sequence[Body]) -> tuple[float, float]:
    ends = [base.local(b.centre)[1] + s * b.size[1] / 2 for b in bodies for s in (-1, 1)]
    return min(ends), max(ends)


@measure
def mirrored(_: Survey, one: Body, other: Body, base: Body) -> float | None:
    """How far [m] two bodies are from mirroring each other about the axis of a third; None on one side of it."""
    (ahead, left), (ahead_2, right) = base.local(one.centre), base.local(other.centre)
    return None if left * right > 0.0 else max(abs(ahead - ahead_2), abs(left + right))


@measure
def over(_: Survey, bases: Any, bodies: Any, slack: float) -> bool:
    """Whether the middle of any of some bodies is over the box of any of some others, widened by a slack [m]."""
    for base in listed(bases):
        for o in listed(bodies):
            ahead, aside = base.local(o.centre)
            if abs(ahead) <= base.size[0] / 2 + slack and abs(aside) <= base.size[1] / 2 + slack:
                return True
    return False


@measure
def overlap(survey: Survey, a: Body, b: Body) -> float:
    """Area [m2] in plan that two boxes share."""
    return float(survey.boxes[a.index].intersection(survey.boxes[b.index]).area)


@measure
def carried_share(survey: Survey, rug: Body, o: Body) -> float:
    """Share of a box in plan that is on a rug."""
    box = survey.boxes[o.index]
    return float(survey.footprint(rug).intersection(box).area) / max(1e-9, float(box.area))


@measure
def rim(survey: Survey, rug: Body, table: Body) -> float:
    """Least distance [m] from the edge of a rug to a table."""
    import shapely

    return float(shapely.distance(survey.footprint(rug).exterior, survey.boxes[table.index]))


def _turned_extent(base: Body, body: Body) -> tuple[float, float]:
    """Depth and width [m] of a body's box in the axes of another."""
    turn = abs(math.cos(body.yaw - base.yaw)), abs(math.sin(body.yaw - base.yaw))
    d, w = body.size[:2]
    return d * turn[0] + w * turn[1], d * turn[1] + w * turn[0]


@measure
def beside(_: Survey, rug: Body, bed: Body) -> float:
    """How far [m] a rug reaches beyond the sides of a bed, the lesser of both."""
    aside, (_d, w) = bed.local(rug.centre)[1], _turned_extent(bed, rug)
    return min(w / 2 + s * aside - bed.size[1] / 2 for s in (1, -1))


@measure
def under_foot(_: Survey, rug: Body, bed: Body) -> float:
    """Share of the length of a bed, from its foot, that a rug lies under."""
    ahead, (d, _w) = bed.local(rug.centre)[0], _turned_extent(bed, rug)
    return min(1.0, (bed.size[0] / 2 - (ahead - d / 2)) / bed.size[0])


@measure
def tied(survey: Survey, a: Body, b: Body) -> bool:
    """Whether a relation names both."""
    return frozenset((a.id, b.id)) in survey.pairs


@measure
def together(survey: Survey, a: Body, b: Body) -> bool:
    """Whether two things stand together on purpose: tied, or equals in a row; or one is walked on."""
    flat = min(a.z[1], b.z[1]) <= FLAT / 2
    return flat or a.item.category == b.item.category or tied(survey, a, b)


@measure
def seats_at(survey: Survey, table: Body) -> tuple[Body, ...]:
    """The seats of a table."""
    return tuple(seats_of(survey, table))


@measure
def table_at(survey: Survey, seat: Body) -> Body | None:
    """The table that a seat belongs to."""
    return table_of(survey, seat)


@measure
def tables_of(survey: Survey, seats: Sequence[Body]) -> tuple[Body, ...]:
    """The tables of some seats, each once."""
    found = {t.id: t for t in (table_of(survey, s) for s in seats) if t is not None}
    return tuple(found.values())


@measure
def holder(survey: Survey, screen: Body, reach: float, kinds_: str) -> Body | None:
    """What a screen stands on, or hangs over within a gap [m], of a set of categories."""
    wanted_ = kind_set(kinds_)
    if screen.item.support is not None:
        found = survey.placed.by_id.get(screen.item.support.object)
        return found if found is not None and found.item.category in wanted_ else None
    if screen.item.mount != "wall":
        return None
    return next((b for b, _ in survey.near(screen, reach) if b.item.category in wanted_), None)


@measure
def blocker(survey: Survey, seat: Body, focus: Body, eye: float) -> Body | None:
    """What is higher than the eyes [m] of a seated person, on the line from a seat to a screen."""
    import shapely

    line = shapely.LineString([seat.centre, focus.centre])
    base = focus.item.support.object if focus.item.support else None
    for row in survey.tree.query(line, predicate="intersects"):
        other = survey.bodies[int(row)]
        if other in (seat, focus) or other.item.mount != "floor" or other.id == base:
            continue
        ahead, aside = other.local(focus.centre)
        holds = abs(ahead) < other.size[0] / 2 + 0.05 and abs(aside) < other.size[1] / 2
        if other.z[1] > max(eye, focus.z[0]) and not holds:
            return other
    return None


@measure
def on_staff_side(_: Survey, desk: Body, o: Body, deep: float, beside_: float) -> bool:
    """Whether a body is behind a counter: up to a depth [m], and a distance beyond its ends."""
    d, w, _h = desk.size
    ahead, aside = desk.local(o.centre)
    return -d / 2 - deep < ahead < (0.0 if abs(aside) < w / 2 else d / 2) and abs(aside) < w / 2 + beside_


@measure
def off_long_axis(_: Survey, table: Body, o: Body, long: float) -> float:
    """Angle [deg] in 0..90 between the long axis of a table and the way to a body."""
    ahead, aside = table.local(o.centre)
    along_, across_ = (ahead, aside) if table.size[0] > long * table.size[1] else (aside, ahead)
    return math.degrees(math.atan2(abs(across_), abs(along_)))
