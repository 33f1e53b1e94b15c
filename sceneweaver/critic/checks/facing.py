"""Measures of where things look: seats, screens, beds, and fronts that look at a wall."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.assets import categories
from sceneweaver.geometry.angles import bearing, wrap_angle
from sceneweaver.scene import CATALOGUE
from sceneweaver.verify.solids import Body

from ..design.query import listed
from ..design.registry import measure
from ..survey import QUARTER, Survey, turn_to


@measure
def off_front(survey: Survey, o: Body, others: Any, reach: float) -> float:
    """Least angle [deg] by which a front misses some targets; 0 where it meets one within a reach [m], inf without."""
    return min((_off_front(survey, o, target, reach) for target in listed(others)), default=math.inf)


def _off_front(survey: Survey, body: Body, target: Body, reach: float) -> float:
    import shapely

    where = target.centre
    shape, spot = survey.boxes[target.index], shapely.Point(body.centre)
    (x, y), (fx, fy) = body.centre, body.front
    ahead = body.size[0] / 2 + reach
    if shapely.LineString([(x, y), (x + ahead * fx, y + ahead * fy)]).intersects(survey.footprint(target)):
        return 0.0
    if not shape.contains(spot):
        near = shape.exterior.interpolate(shape.exterior.project(spot))
        where = (near.x, near.y)
    # A seat between the legs of its table, or at its corner, looks at the table when it looks at its middle.
    return math.degrees(min(turn_to(body, where), turn_to(body, target.centre)))


@measure
def turned_from(survey: Survey, seat: Body, table: Body, reach: float) -> float:
    """`off_front` of a seat and its table; 0 where a relation holds that puts its front against the table."""
    ties = {kind for kind, other in survey.ties.get(seat.id, ()) if other == table.id}
    broken = survey.violated.get("relation", set()) | survey.violated.get("soft_relation", set())
    if ties & CATALOGUE.with_role("seat") and frozenset((seat.id, table.id)) not in broken:
        return 0.0
    return _off_front(survey, seat, table, reach)


@measure
def off_middle(survey: Survey, o: Body) -> float:
    """Angle [deg] between a front and the way to the middle of the floor."""
    return math.degrees(turn_to(o, _middle(survey)))


@measure
def yaw_to_middle(survey: Survey, o: Body) -> float:
    """The yaw [rad] with which a body looks at the middle of the floor."""
    return round(bearing(o.position, _middle(survey)), 4)


def _middle(survey: Survey) -> tuple[float, float]:
    centroid = survey.placed.floor.centroid
    return float(centroid.x), float(centroid.y)


@measure
def quarters(_: Survey, o: Body, turns: int) -> float:
    """The yaw [rad] of a body after some quarter turns."""
    return round(wrap_angle(o.yaw + turns * QUARTER), 4)


@measure
def base_of(survey: Survey, o: Body) -> Body | None:
    """What carries a body."""
    return survey.placed.by_id.get(o.item.support.object) if o.item.support is not None else None


@measure
def sides_used(_: Survey, o: Body) -> tuple[str, ...]:
    """The sides at which such a thing is used."""
    row = categories().get(o.item.category)
    return tuple(row.sides) if row is not None else ()


@measure
def hides(survey: Survey, seat: Body, screen: Body, eyes: float) -> Body | None:
    """What stands or hangs higher than the line of sight [m] between a seat and a screen."""
    import shapely

    line = shapely.LineString([seat.centre, screen.centre])
    for row in survey.tree.query(line, predicate="intersects"):
        other = survey.bodies[int(row)]
        if other in (seat, screen, base_of(survey, screen)) or other.item.mount in ("surface", "ceiling"):
            continue
        if other.z[0] <= eyes and other.z[1] > max(eyes, screen.z[0]):
            return other
    return None


# ---- free spaces beyond walls ----------------------------------------------------------------------------------------


class ShutZone(NamedTuple):
    """A free space outside of the room: its name, its share there, and what turning the body on the spot would gain."""

    name: str
    share: float
    quarters: int
    gain: float


@measure
def shut_zones(survey: Survey, o: Body, beyond: float, even: float) -> list[ShutZone]:
    """The first free space of a body of which more than a share lies outside of the room.

    A box whose sides differ by no more than ``even`` [m] may turn by any quarter, as it fills the same floor.
    """
    zones = survey.placed.zones
    shares = survey.__dict__.get("_outside")
    if shares is None:
        shares = survey.__dict__["_outside"] = _outside(survey, zones.polygons)
    own = [k for k, owner in enumerate(zones.owner) if owner == o.index]
    k = next((k for k in own if shares[k] > beyond), None)
    if k is None:
        return []
    square = abs(o.size[0] - o.size[1]) <= even
    turns = {q: _turned_out(survey, own, o, q) for q in ((1, 2, 3) if square else (2,))}
    best = min(turns, key=lambda q: (round(turns[q], 3), q))
    return [ShutZone(zones.names[k], float(shares[k]), best, _turned_out(survey, own, o, 0) - turns[best])]


def _turned_out(survey: Survey, zones: Sequence[int], o: Body, turns: int) -> float:
    """Share of a body's zones outside of the room after quarter turns on the spot; the sum over the zones."""
    from shapely.affinity import rotate

    polygons = survey.placed.zones.polygons
    shapes = [rotate(polygons[k], turns * QUARTER, origin=o.centre, use_radians=True) for k in zones]
    return sum(_outside(survey, shapes).tolist())


def _outside(survey: Survey, shapes: Any) -> Any:
    """Share of each of some polygons outside of the room [n]."""
    import shapely

    area = np.maximum(shapely.area(shapes), 1e-9)
    return 1.0 - shapely.area(shapely.intersection(shapes, survey.placed.floor)) / area
