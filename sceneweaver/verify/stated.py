"""What requests state, measured: distances of solids and outlines, in float64, by the rows of ``rules/stated.yaml``.

Unlike the relations of scenes these are about the bodies themselves and not their boxes: a word holds for a round table
as people would see it. Lengths are metres, angles degrees.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple, Protocol

import numpy as np

from sceneweaver.assets.carrying import is_hook
from sceneweaver.assets.levels import used_level
from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.angles import cross, dot, wrap_angle
from sceneweaver.geometry.walls import Wall
from sceneweaver.rules.relation import Row, Way, own_side
from sceneweaver.rules.stated import Word, at_side, number
from sceneweaver.verify.measure import TOLERANCE, Measurement, Measurements
from sceneweaver.verify.measures import Reading
from sceneweaver.verify.solids import Array, Body, Placed

RAY = 1000.0
"""Length [m] of a ray: more than any room has."""

INSIDE = "inside"
"""The surface within a box or basket without a lid."""

_SLACK = {"m": TOLERANCE, "deg": 1e-6, "": 0.0}
_AXES = {"front": (0, 1.0), "back": (0, -1.0), "left": (1, 1.0), "right": (1, -1.0)}
_NAMES = {"front": "front", "back": "back", "left": "left side", "right": "right side"}


class Outlines(Protocol):
    """A placed scene with what is kept of its bodies between questions."""

    @property
    def placed(self) -> Placed:
        """The bodies."""
        ...

    def kept_gaps(self) -> dict[tuple[int, int], float]:
        """Distances of pairs that are known, by their indices."""
        ...

    def footprint(self, body: Body) -> Any:
        """The union of a body's parts in plan."""
        ...

    def outline(self, body: Body) -> Array:
        """The corners of the hull of that [n, 2]."""
        ...


class Segment(NamedTuple):
    """A wall, or the part of it that a window or a door takes: offsets along it [m] and heights [m]."""

    id: str
    wall: Wall
    start: float
    end: float
    z: tuple[float, float]

    @property
    def line(self) -> Any:
        """It in plan, as a shapely geometry."""
        import shapely

        return shapely.linestrings([self.wall.point(self.start), self.wall.point(self.end)])

    @property
    def middle(self) -> tuple[float, float]:
        """The point of the floor under its middle."""
        return self.wall.point((self.start + self.end) / 2)

    @property
    def is_wall(self) -> bool:
        """Whether it is a whole wall."""
        return self.id.startswith("wall:")


Target = Body | Segment


def gap(view: Outlines, a: Body, b: Body) -> float:
    """Least distance [m] between the solids of two objects, heights included."""
    import shapely

    kept, key = view.kept_gaps(), (min(a.index, b.index), max(a.index, b.index))
    if key not in kept:
        parts = view.placed.parts
        rows, columns = view.placed.part_rows(a), view.placed.part_rows(b)
        flat = shapely.distance(parts.polygons[rows][:, None], parts.polygons[columns][None, :])
        low, high = parts.z[rows], parts.z[columns]
        upright = np.maximum(low[:, None, 0] - high[None, :, 1], high[None, :, 0] - low[:, None, 1])
        kept[key] = float(np.hypot(flat, np.maximum(upright, 0.0)).min())
    return kept[key]


def spans(view: Outlines, subject: Body, target: Target) -> tuple[tuple[float, float], tuple[float, float]]:
    """Extents [m] of the subject's outline in the target's frame, ahead of it and to its own left; of a segment those
    away from its wall and along that, from its middle."""
    if isinstance(target, Segment):
        u, v = target.wall.coordinates(view.outline(subject).T)
        u = u - (target.start + target.end) / 2
        return (float(v.min()), float(v.max())), (float(u.min()), float(u.max()))
    x, y = (view.outline(subject) - target.centre).T
    c, s = target.front
    ahead, left = c * x + s * y, c * y - s * x
    return (float(ahead.min()), float(ahead.max())), (float(left.min()), float(left.max()))


def extent(target: Target, axis: int) -> float:
    """Size [m] of a target along an axis of its frame."""
    return target.end - target.start if isinstance(target, Segment) else target.size[axis]


def carried_by(view: Outlines, subject: Body, target: Body) -> bool:
    """Whether the target carries the subject, directly or with something between."""
    return _chain(view, subject, target) is not None


def _chain(view: Outlines, subject: Body, target: Body) -> Body | None:
    """What of the things that carry the subject stands on the target itself; None where nothing does."""
    body: Body | None = subject
    for _ in view.placed.bodies:
        if body is None or body.item.support is None:
            return None
        if body.item.support.object == target.id:
            return body
        body = view.placed.by_id.get(body.item.support.object)
    return None


def shared(view: Outlines, s: Body, t: Body) -> float:
    """Share of the subject's outline that lies within the target's, as seen from above."""
    import shapely

    mine, theirs = (shapely.convex_hull(view.footprint(b)) for b in (s, t))
    area = float(shapely.area(mine))
    return float(shapely.area(shapely.intersection(mine, theirs))) / area if area > 0.0 else 0.0


def off_front(body: Body, point: tuple[float, float], way: float = 1.0) -> float:
    """Angle [deg] between a body's front, or with ``way`` -1 its back, and the way from its centre to a point."""
    ahead, aside = body.local(point)
    off = 0.0 if math.hypot(ahead, aside) < 1e-6 else math.degrees(abs(math.atan2(aside, ahead)))
    return off if way > 0 else 180.0 - off


def worktop(body: Body) -> float:
    """The height [m] of the largest surface of a table that nothing is above, without taps and screens on it; under a
    rack of tools the highest that there is; that of its largest part where nothing is put on it, such as a sewing table
    without its machine."""
    import shapely

    open_ = [s for s in body.item.surfaces if s.headroom is None]
    if not open_:
        if body.item.surfaces:
            return body.z[0] + max(s.z for s in body.item.surfaces)
        parts = body.item.parts
        if not parts:
            return body.z[1]
        largest = max(parts, key=lambda part: float(shapely.Polygon(part.polygon).area))
        return body.item.pose.position[2] + largest.z[1]
    return body.z[0] + max(open_, key=lambda s: float(shapely.Polygon(s.polygon).area)).z


def seat_top(body: Body) -> float:
    """The height [m] of what one sits on: a bar stool's low back is above it."""
    level = used_level(body.item.solids, body.item.surfaces)
    return body.z[1] if level is None else body.z[0] + level


# ---- measures --------------------------------------------------------------------------------------------------------


class Asked(NamedTuple):
    """A row of two things, or of a thing and a part of the room; ``side`` of the target in its own frame."""

    view: Outlines
    s: Body
    t: Any
    row: Row
    side: str | None


def _space(q: Asked) -> Reading | None:
    if isinstance(q.t, Segment):
        return _plan_gap(q)
    return Reading(gap(q.view, q.s, q.t))


def _plan_gap(q: Asked) -> Reading | None:
    import shapely

    if isinstance(q.t, Segment):
        return Reading(float(shapely.distance(q.view.footprint(q.s), q.t.line)))
    return Reading(q.view.placed.distance(q.s, q.t))


def _past(q: Asked) -> Reading | None:
    # walls run counter-clockwise: the left of a window as seen from within, its frame's own right, is its end
    axis, sign = _AXES[q.side or "front"]
    low, high = spans(q.view, q.s, q.t)[axis]
    sign = -sign if isinstance(q.t, Segment) else sign
    return Reading(sign * (low + high) / 2 - extent(q.t, axis) / 2)


def _shared_width(q: Asked) -> Reading | None:
    axis = 1 if isinstance(q.t, Segment) else 1 - _AXES[q.side or "front"][0]
    half = q.row.options.get("by", 1.0) * extent(q.t, axis) / 2
    low, high = spans(q.view, q.s, q.t)[axis]
    least = 2 * half if q.row.of == "site" else min(high - low, 2 * half)
    return Reading(min(high, half) - max(low, -half), scale=least)


def _centred(q: Asked) -> Reading | None:
    (a0, a1), (l0, l1) = spans(q.view, q.s, q.t)
    ahead, left = (a0 + a1) / 2, (l0 + l1) / 2
    return Reading({"ahead": ahead, "left": left, "nearest": min(abs(ahead), abs(left))}[q.row.of or "left"])


def _share_over(q: Asked) -> Reading | None:
    share = shared(q.view, q.s, q.t)
    return Reading(max(share, shared(q.view, q.t, q.s)) if q.row.of == "either" else share, "")


def _share_within(q: Asked) -> Reading | None:
    low, high = max(q.s.z[0], q.t.z[0]), min(q.s.z[1], q.t.z[1])
    return Reading(max(0.0, high - low) / max(1e-9, q.s.z[1] - q.s.z[0]) * shared(q.view, q.s, q.t), "")


def _held(q: Asked) -> Reading | None:
    """Nothing where the target carries nothing: what is not carried may still lie in or on it."""
    found = _chain(q.view, q.s, q.t)
    if q.row.of == "either":
        return Reading(1.0, "") if found is not None or carried_by(q.view, q.t, q.s) else None
    if found is None:
        return None
    if q.row.of == "outer":
        support = found.item.support
        return Reading(float(support is not None and support.surface not in _inner(q.t)), "")
    if q.row.of == "hook":
        support = found.item.support
        return Reading(float(support is not None and is_hook(support.surface)), "")
    return Reading(float(q.row.of != "inner" or _is_within(found, q.t)), "")


def _inner(target: Body) -> set[str]:
    """The surfaces of a thing that are within it."""
    return {
        s.name for s in target.item.surfaces if (s.headroom is not None and not is_hook(s.name)) or s.name == INSIDE
    }


def _is_within(held: Body, target: Body) -> bool:
    """Whether what stands on a thing is in it: on a board or the floor within it, in a bowl or on a dish, in bedding.

    On the lid of a chest or beside the bowl of a sink it is not.
    """
    support = held.item.support
    inner = _inner(target)
    if support is None or support.surface in inner or inner:
        return support is not None and support.surface in inner
    return target.item.mount == "surface" or has_role(target.item.category, "soft_top")


def _shape(view: Outlines, target: Target) -> tuple[Any, tuple[float, float]]:
    """What is looked at, in plan, and its middle."""
    import shapely

    if isinstance(target, Segment):
        return target.line, target.middle
    return shapely.convex_hull(view.footprint(target)), target.centre


def _looks_away(q: Asked) -> Reading | None:
    import shapely

    way = -1.0 if q.row.of == "back" else 1.0
    if isinstance(q.t, Segment) and q.t.is_wall:
        turned = math.degrees(math.acos(max(-1.0, min(1.0, dot(q.s.front, q.t.wall.outward)))))
        return Reading(turned if way > 0 else 180.0 - turned, "deg")
    shape, middle = _shape(q.view, q.t)
    (x, y), (fx, fy) = q.s.centre, q.s.front
    if q.s.centre == middle:
        return Reading(90.0, "deg")
    if shapely.intersects(shapely.linestrings([(x, y), (x + RAY * way * fx, y + RAY * way * fy)]), shape):
        return Reading(0.0, "deg")
    return Reading(off_front(q.s, middle, way), "deg")


def _end_on(q: Asked) -> Reading | None:
    """Angle [deg] by which neither the back nor a long side of the subject looks at the wall."""
    if not isinstance(q.t, Segment):
        return None
    depth, width = q.s.size[:2]
    faces = ("back", "left", "right") if depth > width else ("back", "front")
    turned = [dot(q.s.face(name).normal, q.t.wall.outward) for name in faces]
    return Reading(math.degrees(math.acos(max(-1.0, min(1.0, max(turned))))), "deg")


def _seat_away(q: Asked) -> Reading | None:
    import shapely

    here, hull = shapely.points(q.s.centre), shapely.convex_hull(q.view.footprint(q.t))
    if shapely.intersects(hull, here):
        return None
    x, y = shapely.get_coordinates(shapely.shortest_line(here, hull))[1]
    return Reading(min(off_front(q.s, (float(x), float(y))), off_front(q.s, q.t.centre)), "deg")


def _off_front(q: Asked) -> Reading | None:
    return Reading(off_front(q.s, q.t.centre), "deg")


def _turn(q: Asked) -> Reading | None:
    other = q.t.wall.yaw if isinstance(q.t, Segment) else q.t.yaw
    modulo, by = (math.radians(q.row.options.get(name, value)) for name, value in (("modulo", 360.0), ("by", 0.0)))
    return Reading(math.degrees(float(wrap_angle(q.s.yaw - other - by, modulo))), "deg")


def _to_wall(q: Asked) -> Reading | None:
    import shapely

    return Reading(min(float(shapely.distance(q.view.footprint(q.s), _line(w))) for w in q.view.placed.walls))


def _line(wall: Wall) -> Any:
    import shapely

    return shapely.linestrings([wall.point(0.0), wall.point(wall.length)])


def _long_side_turned(q: Asked) -> Reading | None:
    long = q.s.yaw + (math.pi / 2 if q.s.size[1] > q.s.size[0] else 0.0)
    return Reading(abs(math.degrees(float(wrap_angle(long - q.t.wall.yaw, math.pi)))), "deg")


def _off_way_in(q: Asked) -> Reading | None:
    x, y = q.t.middle
    way, inward = (q.s.centre[0] - x, q.s.centre[1] - y), q.t.wall.inward
    return Reading(abs(math.degrees(math.atan2(cross(inward, way), dot(inward, way)))), "deg")


MEASURED: dict[str, Callable[[Asked], Reading | None]] = {
    "space": _space,
    "plan_gap": _plan_gap,
    "past": _past,
    "shared_width": _shared_width,
    "centred": _centred,
    "share_over": _share_over,
    "share_within": _share_within,
    "held": _held,
    "top_over_top": lambda q: Reading(q.s.z[1] - q.t.z[1]),
    "top_over_middle": lambda q: Reading(q.s.z[1] - sum(q.t.z) / 2),
    "bottom_over_top": lambda q: Reading(q.s.z[0] - q.t.z[1]),
    "middle_over_middle": lambda q: Reading(sum(q.s.z) / 2 - sum(q.t.z) / 2),
    "bottom_over_bottom": lambda q: Reading(q.s.z[0] - q.t.z[0]),
    "below_ceiling": lambda q: Reading(q.view.placed.scene.room.height - q.s.z[1]),
    "height": lambda q: Reading(q.s.z[0]),
    "looks_away": _looks_away,
    "end_on": _end_on,
    "seat_away": _seat_away,
    "top_over_seat": lambda q: Reading(worktop(q.t) - seat_top(q.s)),
    "off_front": _off_front,
    "turn": _turn,
    "to_wall": _to_wall,
    "long_side_turned": _long_side_turned,
    "off_way_in": _off_way_in,
}
"""What each measure is; None where there is nothing to measure."""


# ---- rows ------------------------------------------------------------------------------------------------------------


def sides_named(target: Body, name: str) -> tuple[str, ...]:
    """The sides of a target, as its viewer calls them, that "long", "short", "left" and "right" mean; all four of a
    square one for the first two."""
    if name in ("left", "right"):
        return (name,)
    depth, width = target.size[:2]
    if math.isclose(depth, width, rel_tol=number("square")):
        return ("front", "back", "left", "right")
    return ("front", "back") if (width > depth) == (name == "long") else ("left", "right")


def stated(
    word: Word,
    view: Outlines,
    subject: Body,
    target: Target | None,
    scope: Mapping[str, Any],
    params: Mapping[str, Any],
    side: str | None = None,
) -> Iterator[Measurements]:
    """The measurements of each way in which a word may hold.

    Args:
        word: a word of requests.
        view: the scene.
        subject, target: the two things; a part of the room, or None for floor and ceiling.
        scope: the names of the rows' expressions, with subject and target as ``a`` and ``b``.
        params: ``min`` and ``max`` [m] where the request says them.
        side: a side of the target, as its viewer calls it, that the request names as well.
    """
    for way in word.holds:
        if way.when is not None and not way.when.value(scope):
            continue
        s, t, names = (target, subject, {**scope, "a": scope["b"], "b": scope["a"]}) if way.swap else (
            subject, target, scope)  # fmt: skip
        sides = way.sides
        if isinstance(sides, str):
            sides = sides_named(t, sides) if isinstance(t, Body) else ()
        for named in sides or (None,):
            found = [*_measured(way, word.frame, view, s, t, names, params, named)]
            if side is not None:
                found += _measured(at_side(), "viewer", view, subject, target, scope, {}, side)
            if found:
                yield found


def _measured(  # noqa: PLR0913 - one row needs all of what is asked
    way: Way,
    frame: str,
    view: Outlines,
    s: Any,
    t: Any,
    scope: Mapping[str, Any],
    params: Mapping[str, Any],
    side: str | None,
) -> Iterator[Measurement]:
    for row in way.rows:
        if not row.counts(scope):
            continue
        named = side or row.options.get("side")
        first, second = (t, s) if row.options.get("swap") else (s, t)
        reading = MEASURED[row.measure](Asked(view, first, second, row, named and own_side(named, frame)))
        if reading is None:
            continue
        low, high = (end * reading.scale for end in row.interval(scope) or (-math.inf, math.inf))
        value = reading.value - float(row.start.value(scope))
        if row.about:
            value, low = abs(value), -math.inf
        if row.options.get("said"):
            low = float(params.get("min", low)) if low > -math.inf else low
            high = float(params.get("max", high)) if high < math.inf or row.kind == "within" else high
        name = getattr(t, "id", "").replace(":", " ")
        text = row.text.format(a=s.id, b=getattr(t, "id", ""), side=_NAMES.get(named or "", ""), name=name)
        slack = 0.0 if row.strict else _SLACK[reading.unit]
        yield Measurement(text, value, low, high, reading.unit, slack)
