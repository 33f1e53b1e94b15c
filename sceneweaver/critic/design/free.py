"""Measures of free room: depths before sides, distances from walls, and what stands in the way."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sceneweaver.verify.solids import Body

from .. import kinds
from ..seats import table_of
from ..survey import FLAT, Survey
from .measure import HEAD, clear_depth, strip
from .measure import movable as is_movable
from .query import listed
from .registry import Reading, measure


@measure
def wall_gap(survey: Survey, o: Body) -> float:
    """Distance [m] of a box from the nearest wall."""
    return float(survey.wall_gaps[o.index])


@measure
def wall_angle(survey: Survey, o: Body) -> float:
    """Least angle [deg] between the axes of a box and a wall's."""
    return math.degrees(float(survey.wall_angles[o.index]))


@measure
def wall_ahead(survey: Survey, o: Body, side: str) -> float:
    """Distance [m] from the middle of a side to the wall ahead of it."""
    return survey.clear_ahead(o, side)


@measure
def end_at_wall(survey: Survey, table: Body, seats: list[Body], least: float) -> bool:
    """Whether only a short end of a table is at a wall, and its seats are at the long sides alone."""
    ends = ("front", "back") if table.size[0] > table.size[1] else ("left", "right")
    sides = tuple(s for s in ("front", "back", "left", "right") if s not in ends)
    if any(survey.clear_ahead(table, s) < least for s in sides):
        return False
    axis, half = 0 if ends[0] == "front" else 1, max(table.size[:2]) / 2
    return not any(abs(table.local(b.centre)[axis]) > half - 0.15 for b in seats)


@measure
def clear(survey: Survey, o: Body, side: str, most: float, low: float | None = None) -> Reading:
    """Free depth [m] before a side up to ``most``; light seats, or all that is lower than ``low``, do not end it."""
    passes = is_movable if low is None else lambda b: b.z[1] < low
    free, other = clear_depth(survey, o, side, most, passes)
    return Reading.of(free, (other,) if other is not None else ())


@measure
def behind(survey: Survey, seat: Body, most: float, step: float = 0.2) -> Reading:
    """Free depth [m] behind a seat; neither its table nor what is stepped over ends it."""
    kept = survey.__dict__.setdefault("_behind", {})
    if (seat.index, most) not in kept:
        table = table_of(survey, seat)
        free, other = clear_depth(survey, seat, "back", most, lambda b: b is table or b.z[1] < step)
        kept[seat.index, most] = Reading.of(free, (other,) if other is not None else ())
    return kept[seat.index, most]


@measure
def in_way_behind(survey: Survey, seats: Sequence[Body], most: float) -> tuple[Body, ...]:
    """What stands behind some seats."""
    return tuple(b for s in seats for b in behind(survey, s, most).by)


@measure
def in_way(_: Survey, o: Body, low: float = FLAT) -> bool:
    """Whether a body takes room between a height [m] and that of a head."""
    return o.z[1] > low and o.z[0] <= HEAD


@measure
def taken_by(survey: Survey, others: Any, o: Body, deep: float, wide: float) -> float:
    """Share of the room before the front of a body that others take."""
    return sum(survey.taken(strip(o, "front", deep, wide), listed(others)))


@measure
def box_share(survey: Survey, other: Body, o: Body, deep: float, wide: float) -> float:
    """Share of the room before the front of a body that another's box takes."""
    area = strip(o, "front", deep, wide)
    return float(area.intersection(survey.boxes[other.index]).area) / float(area.area)


@measure
def hidden(survey: Survey, o: Body, wedged: float = 0.06) -> tuple[Any, ...]:
    """The table above a bin, or what a hamper is wedged between: another thing and a wall, or two things."""
    box = survey.boxes[o.index]
    for other, _ in survey.near(o, 0.0):
        if other.item.category in kinds.DINING and box.intersection(survey.boxes[other.index]).area > 0.5 * box.area:
            return (other,)
    if o.item.category != "laundry_hamper":
        return ()  # a bin stands well between others
    found: list[Any] = []
    for side in ("left", "right"):
        free, other = clear_depth(survey, o, side, 0.3, lambda b: b.z[1] < 0.6 * o.z[1])
        if free > wedged:
            return ()
        found.append("the wall" if other is None else other)
    return () if found[0] is found[1] or found[0] == found[1] else tuple(found)


@measure
def tightest(survey: Survey, machines: Sequence[Body], least: float, at_wall: float) -> Reading:
    """The least gap [m] between machines that are closer than ``least``, or from a bench to a wall."""
    close: list[tuple[float, tuple[Body, ...]]] = []
    for body in machines:
        if body.item.category == "weight_bench" and wall_gap(survey, body) < at_wall:
            close.append((wall_gap(survey, body), (body,)))
        near = survey.near(body, least)
        close += [(g, (body, b)) for b, g in near if b in machines and b.index > body.index and g < least]
    ids = dict.fromkeys(b for _, row in close for b in row)
    found = Reading.of(min((g for g, _ in close), default=math.inf), ids)
    found.pairs = len(close)  # type: ignore[attr-defined]
    return found
