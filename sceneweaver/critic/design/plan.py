"""Measures between things in plan: gaps, angles, offsets, shared area, and which seats go with which table.

Where a measure takes several things, it gives the least of them, infinite of none. A thing is a body, an opening, or
a shape that another measure gives.
"""

from __future__ import annotations

import math
from typing import Any

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.walls import Wall
from sceneweaver.verify.solids import Body, Opening

from .. import seats
from ..survey import FLAT, Survey, turn_to
from . import measure as shapes
from .measure import shape_of, spot
from .query import listed
from .registry import Span, measure

# ---- distances and angles --------------------------------------------------------------------------------------------


@measure
def gap(survey: Survey, o: Any, others: Any) -> float:
    """Distance [m] in plan between boxes or shapes, to the nearest of some others than the thing itself."""
    own = shape_of(survey, o)
    return min((float(own.distance(shape_of(survey, b))) for b in listed(others) if b is not o), default=math.inf)


@measure
def distance(survey: Survey, o: Body, others: Any) -> float:
    """Distance [m] between footprints, to the nearest of several."""
    return min((survey.placed.distance(o, b) for b in listed(others)), default=math.inf)


@measure
def away(_: Survey, o: Any, others: Any) -> float:
    """Distance [m] between middles, to the nearest of several."""
    return min((math.dist(spot(o), spot(b)) for b in listed(others)), default=math.inf)


@measure
def bearing(_: Survey, o: Body, others: Any) -> float:
    """Angle [deg] in 0..180 between the front of a body and the way to another, the least of several."""
    return min((math.degrees(turn_to(o, spot(other))) for other in listed(others)), default=math.inf)


@measure
def turned(_: Survey, a: Body, b: Body, period: float = 360.0) -> float:
    """Angle [deg] between two fronts, modulo a period."""
    return abs(math.degrees(wrap_angle(b.yaw - a.yaw, math.radians(period))))


@measure
def forward(_: Survey, base: Body, o: Any) -> float:
    """How far [m] the middle of a thing is ahead of a body's."""
    return base.local(spot(o))[0]


@measure
def sideways(_: Survey, base: Body, o: Any) -> float:
    """How far [m] the middle of a thing is to the left of a body's."""
    return base.local(spot(o))[1]


@measure
def span(_: Survey, base: Body | Opening | Wall, things: Any) -> Span:
    """The interval [m] that things take together across the axis of a body or along a wall, and ahead of either.

    It is counted from the middle of a body or an opening, and from the start of a wall.
    """
    corners = [c for b in listed(things) for c in b.corners]
    if isinstance(base, Body):
        vs, us = zip(*map(base.local, corners), strict=True)
        return Span(min(us), max(us), min(vs), max(vs))
    wall = base.wall if isinstance(base, Opening) else base
    start = base.item.offset + base.item.width / 2 if isinstance(base, Opening) else 0.0
    us, vs = zip(*map(wall.coordinates, corners), strict=True)
    return Span(min(us) - start, max(us) - start, min(vs), max(vs))


@measure
def lateral(survey: Survey, base: Body, o: Any) -> float:
    """How far [m] a body, or the middle of several, is off the axis of another."""
    return abs(base.local(o.centre)[1] if isinstance(o, Body) else span(survey, base, o).middle)


@measure
def mirrored(_: Survey, one: Body, other: Body, base: Body) -> float | None:
    """How far [m] two bodies are from mirroring each other about the axis of a third; None on one side of it."""
    (ahead, left), (ahead_2, right) = base.local(one.centre), base.local(other.centre)
    return None if left * right > 0.0 else max(abs(ahead - ahead_2), abs(left + right))


# ---- shapes and areas ------------------------------------------------------------------------------------------------


@measure
def strip(_: Survey, o: Body, side: str, depth: float, width: float = 0.95) -> Any:
    """The rectangle of some depth [m] before a side of a body, as wide as a share of the side."""
    return shapes.strip(o, side, depth, width)


@measure
def footprint(survey: Survey, o: Body) -> Any:
    """The outline of a body in plan."""
    return survey.footprint(o)


@measure
def leaf(_: Survey, door: Opening) -> Any:
    """What the leaf of a door sweeps in plan; None where it opens outward or slides."""
    return shapes.swing(door)


@measure
def within(survey: Survey, shape: Any, reach: float) -> tuple[Body, ...]:
    """What is within a gap [m] of a shape, in the order of the scene."""
    rows = survey.tree.query(shape, predicate="dwithin", distance=reach) if shape is not None else ()
    return tuple(survey.bodies[int(row)] for row in rows)


@measure
def overlap(survey: Survey, a: Any, b: Any) -> float:
    """Area [m2] in plan that two boxes or shapes share."""
    return float(shape_of(survey, a).intersection(shape_of(survey, b)).area)


@measure
def cover(survey: Survey, area: Any, things: Any) -> float:
    """Share of a box or shape that the outlines of some bodies take, added up."""
    return sum(survey.taken(shape_of(survey, area), listed(things)))


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


# ---- what goes with what ---------------------------------------------------------------------------------------------


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
    return tuple(seats.seats_at(survey, table))


@measure
def table_at(survey: Survey, seat: Body) -> Body | None:
    """The table that a seat belongs to."""
    return seats.table_of(survey, seat)


@measure
def on(survey: Survey, o: Body) -> tuple[Body, ...]:
    """What stands on it."""
    return tuple(survey.carried.get(o.id, ()))
