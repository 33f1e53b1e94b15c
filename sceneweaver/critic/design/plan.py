"""Measures in plan: gaps, angles and offsets between bodies, what stands before a side, and what a body is."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.verify.solids import Body, Opening

from .. import kinds
from ..needs import seat_like as likely_seat
from ..needs import seats_at as seats_of
from ..needs import table_of
from ..survey import FLAT, Survey, turn_to
from .measure import HEAD, along, clear_depth, end_of, middle, strip, swing
from .measure import movable as is_movable
from .query import kind_set, listed

MEASURES: dict[str, Callable[..., Any]] = {}
"""What expressions of rows may call, by name; each takes a survey first."""


class Reading(float):
    """A number and the objects that it is about."""

    by: tuple[Any, ...] = ()

    @classmethod
    def of(cls, value: float, by: Iterable[Any]) -> Reading:
        """A reading of some objects."""
        found = cls(value)
        found.by = tuple(by)
        return found


def measure(function: Callable[..., Any]) -> Callable[..., Any]:
    """Make a function of a survey one that rows may call by its name."""
    MEASURES[function.__name__] = function
    return function


def spot(thing: Body | Opening) -> tuple[float, float]:
    """The middle of a body, or of an opening at its wall."""
    return thing.centre if isinstance(thing, Body) else middle(thing)


# ---- what a body is --------------------------------------------------------------------------------------------------


@measure
def kind(_: Survey, o: Body, kinds_: str) -> bool:
    """Whether a body is of a set of categories."""
    return o.item.category in kind_set(kinds_)


@measure
def any_kind(_: Survey, bodies: Sequence[Body], kinds_: str) -> bool:
    """Whether any of some bodies is of a set of categories."""
    return any(o.item.category in kind_set(kinds_) for o in bodies)


@measure
def all_kind(_: Survey, bodies: Sequence[Body], kinds_: str) -> bool:
    """Whether all of some bodies are of a set of categories."""
    return all(o.item.category in kind_set(kinds_) for o in bodies)


@measure
def category(_: Survey, o: Body) -> str:
    """The category of a body."""
    return o.item.category


@measure
def words(_: Survey, o: Body) -> str:
    """The category of a body as a user would write it."""
    return kinds.words(o.item.category)


@measure
def movable(_: Survey, o: Body) -> bool:
    """Whether it is a seat that is moved aside with one hand."""
    return is_movable(o)


@measure
def seat_like(_: Survey, o: Body) -> bool:
    """Whether people may sit on it at a table."""
    return likely_seat(o)


@measure
def named_round(_: Survey, o: Body) -> bool:
    """Whether its category says that it is round."""
    return "round" in o.item.category


@measure
def wanted(survey: Survey, o: Body) -> bool:
    """Whether somebody asked for it, or the room needs it."""
    return o.id in survey.program.asked_of or o.item.intent.priority in ("needed", "asked")


@measure
def asked(survey: Survey, o: Body) -> bool:
    """Whether the request names it."""
    return o.id in survey.program.asked_of or o.item.intent.priority == "asked"


@measure
def width(_: Survey, o: Body) -> float:
    """Width [m] of its box."""
    return o.size[1]


@measure
def depth(_: Survey, o: Body) -> float:
    """Depth [m] of its box, along its front."""
    return o.size[0]


@measure
def tall(_: Survey, o: Body) -> float:
    """Height [m] of its box."""
    return o.size[2]


@measure
def bottom(_: Survey, o: Body | Opening) -> float:
    """Height [m] of its lower end above the floor."""
    return o.z[0]


@measure
def top(_: Survey, o: Any) -> float:
    """Height [m] of its upper end, or of the highest of several, above the floor."""
    return max(one.z[1] for one in ((o,) if isinstance(o, (Body, Opening)) else o))


@measure
def middle_height(_: Survey, o: Body) -> float:
    """Height [m] of its middle above the floor."""
    return (o.z[0] + o.z[1]) / 2


@measure
def number(_: Survey, o: Body) -> int:
    """Its place in the scene."""
    return o.index


@measure
def total_width(_: Survey, bodies: Sequence[Body]) -> float:
    """Width [m] of some bodies together."""
    return sum(b.size[1] for b in bodies)


# ---- lists -----------------------------------------------------------------------------------------------------------


@measure
def count(_: Survey, things: Sequence[Any]) -> int:
    """How many there are."""
    return len(things)


@measure
def rest(_: Survey, things: Sequence[Any], start: int, end: int | None = None) -> tuple[Any, ...]:
    """Those from a place on, up to another."""
    return tuple(things[start:end])


@measure
def first_two(_: Survey, things: Sequence[Any]) -> tuple[Any, ...]:
    """The first two."""
    return tuple(things[:2])


@measure
def largest(_: Survey, bodies: Sequence[Body]) -> Body | None:
    """The body with the largest box in plan."""
    return max(bodies, key=lambda b: (round(b.size[0] * b.size[1], 4), b.id), default=None)


@measure
def rank(_: Survey, value: float, o: Body) -> tuple[float, str]:
    """A key to order bodies by a number, and equal ones by id."""
    return round(value, 4), o.id


@measure
def by(_: Survey, value: Any) -> Any:
    """What ends a clear depth (None: a wall), or all objects that a reading is about."""
    found = getattr(value, "by", ())
    return found[0] if len(found) == 1 else found or None


@measure
def pairs_of(_: Survey, value: Any) -> int:
    """How many pairs a reading is about."""
    return getattr(value, "pairs", 0)


@measure
def more(_: Survey, number_: int, what: str) -> str:
    """The end of a sentence that names one of several."""
    return f", and {number_} more {what}" if number_ > 0 else ""


@measure
def joined(_: Survey, things: Sequence[Any], between: str) -> str:
    """Some words, or the first of each of some lists of words, in one."""
    return between.join(t if isinstance(t, str) else t[0] for t in things)


@measure
def all_of(_: Survey, *reasons: Any) -> str:
    """The reasons that hold, in one sentence."""
    return " and ".join(r for r in reasons if r and isinstance(r, str))


# ---- between two -----------------------------------------------------------------------------------------------------


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
def near_some(survey: Survey, o: Body, others: Sequence[Body], reach: float) -> bool:
    """Whether any of some others is within a gap [m]."""
    return near_count(survey, o, others, reach) > 0


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
def least_away(_: Survey, o: Body, others: Sequence[Body]) -> float:
    """Distance [m] to the nearest middle of some others; infinite without."""
    return min((math.dist(o.centre, b.centre) for b in others), default=math.inf)


@measure
def bearing(_: Survey, o: Body, other: Body | Opening) -> float:
    """Angle [deg] in 0..180 between the front of a body and the way to another."""
    return math.degrees(turn_to(o, spot(other)))


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
def arm_gap(_: Survey, seat: Body, table: Body) -> float:
    """Gap [m] between the arm of a seat and a table beside it."""
    return abs(seat.local(table.centre)[1]) - seat.size[1] / 2 - min(table.size[:2]) / 2


@measure
def across_angle(_: Survey, a: Body, b: Body) -> float:
    """Cosine of the angle between two fronts."""
    return math.cos(a.yaw - b.yaw)


@measure
def over(_: Survey, base: Body, o: Body, slack: float) -> bool:
    """Whether the middle of a body is over another's box, widened by a slack [m]."""
    ahead, aside = base.local(o.centre)
    return abs(ahead) <= base.size[0] / 2 + slack and abs(aside) <= base.size[1] / 2 + slack


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


# ---- seats and tables ------------------------------------------------------------------------------------------------


@measure
def seats_at(survey: Survey, table: Body) -> tuple[Body, ...]:
    """The seats of a table."""
    return tuple(seats_of(survey, table))


@measure
def has_table(survey: Survey, seat: Body) -> bool:
    """Whether a seat belongs to a table."""
    return table_of(survey, seat) is not None


@measure
def sits_at(survey: Survey, seat: Body, table: Body) -> bool:
    """Whether a seat belongs to this table."""
    return table_of(survey, seat) is table


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


# ---- free room -------------------------------------------------------------------------------------------------------


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


# ---- doors -----------------------------------------------------------------------------------------------------------


@measure
def has_doors(survey: Survey) -> bool:
    """Whether the room has a door and things that stand in it."""
    return bool(survey.placed.doors and survey.standing)


@measure
def first_door(survey: Survey) -> Opening:
    """The first door."""
    return survey.placed.doors[0]


@measure
def nearest_door(survey: Survey, o: Body) -> Opening:
    """The door nearest to a body."""
    return min(survey.placed.doors, key=lambda d: (round(math.dist(o.centre, middle(d)), 3), d.item.id))


@measure
def door_distance(survey: Survey, o: Body) -> float:
    """Distance [m] from the middle of a body to the nearest door; infinite without one."""
    return min((math.dist(o.centre, middle(door)) for door in survey.placed.doors), default=math.inf)


@measure
def door_bearing(survey: Survey, o: Body) -> float:
    """Least angle [deg] between the front of a body and the way to a door."""
    return min(bearing(survey, o, door) for door in survey.placed.doors)


AT_FRAME = 0.5
"""Distance [m] from the wall of a door within which things are beside its frame."""


@measure
def frame_gap(_: Survey, door: Opening, o: Body) -> float | None:
    """Gap [m] along the wall between the frame of a door and what stands beside it; None for what does not."""
    (u0, u1), (v0, v1) = along(door, o)
    free = max(u0 - end_of(door), door.item.offset - u1)
    return None if v0 > AT_FRAME or v1 < 0 or free <= -0.05 else free


@measure
def near_leaf(survey: Survey, door: Opening, reach: float) -> list[Body]:
    """What is within a gap [m] of the leaf of a door as it opens, and not beside its frame."""
    leaf, found = swing(door), []
    for row in survey.tree.query(leaf, predicate="dwithin", distance=reach) if leaf is not None else ():
        body = survey.bodies[int(row)]
        if body.item.mount in ("surface", "ceiling") or body.z[1] <= FLAT or body.z[0] > 2.0:
            continue
        (u0, u1), (v0, _v) = along(door, body)
        if v0 >= AT_FRAME or not (u1 < door.item.offset or u0 > end_of(door)):
            found.append(body)
    return found


@measure
def leaf_gap(survey: Survey, door: Opening, o: Body) -> float:
    """Gap [m] between a body and the leaf of a door as it opens."""
    import shapely

    return float(shapely.distance(swing(door), survey.footprint(o)))


@measure
def at_door(survey: Survey, rug: Body, least: float = 0.02) -> bool:
    """Whether a rug lies within the way that a door needs to open."""
    import shapely

    shape = survey.boxes[rug.index]
    return any(shapely.Polygon(door.polygon).intersection(shape).area > least for door in survey.placed.doors)


@measure
def head_at_door_wall(survey: Survey, bed: Body, reach: float, angle: float) -> bool:
    """Whether the head of a bed is within a gap [m] and an angle [deg] of a wall that has a door."""
    back = survey.back_wall(bed)
    if back is None or back[1] > reach or math.degrees(back[2]) > angle:
        return False
    return back[0].index in {door.wall.index for door in survey.placed.doors}
