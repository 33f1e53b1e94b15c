"""What a stated relation between an object and a part of the room asks for, as measurements.

A place is "wall", "window", "door", "corner", "ceiling", "floor" or "room", a wall with the name of a side as well
("wall:left"). Walls, windows and doors are seen from within the room: right of a window is the right-hand side of who
looks out of it. Lengths are metres, angles degrees.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from sceneweaver.assets import categories
from sceneweaver.geometry.angles import cross, dot, wrap_angle
from sceneweaver.geometry.walls import Wall
from sceneweaver.language.wall_names import direction_of
from sceneweaver.scene import Room
from sceneweaver.verify.measure import TOLERANCE, Measurement, Measurements, at_least, at_most
from sceneweaver.verify.solids import Body

from .pair_measures import ABREAST, FACING, NEAR, NEXT, OFF_MIDDLE, OVER, Alternatives, turned_to, ways_of
from .survey import Survey

AT_WALL = 0.3
"""Gap [m] up to which something is against a wall."""

HUNG, OFF_FLOOR = 0.07, 0.05
"""Gap [m] up to which something hangs on a wall, and its least height above the floor."""

IN_CORNER = 0.6
"""Gap [m] to both walls of a corner up to which something is in it."""

CORNER = 0.5
"""Least sine of the turn at a corner of the room that people would call one."""

AWAY = 1.0
"""Gap [m] from which something is away from a wall, a window or a door."""

ACROSS, ACROSS_ANGLE = 1.5, 60.0
"""Gap [m] from which something is across the room from a window or a door, and most angle [deg] from the way in."""

OBLONG = 1.2
"""Quotient of two sides from which one of them is the long one."""

BEHIND_DOOR = 1.0
"""Gap [m] up to which something is behind a door."""


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


def segments(survey: Survey, place: str) -> list[Segment]:
    """The walls, windows or doors that a place names."""
    room = survey.scene.room
    if place.startswith("wall"):
        wanted = walls_named(place.partition(":")[2], room)
        return [
            Segment(f"wall:{w.index}", w, 0.0, w.length, (0.0, room.height))
            for w in survey.placed.walls
            if w.index in wanted
        ]
    openings = {"window": survey.placed.windows, "door": survey.placed.doors}.get(place, ())
    return [Segment(o.item.id, o.wall, o.item.offset, o.item.offset + o.item.width, o.z) for o in openings]


def walls_named(name: str, room: Room) -> list[int]:
    """The walls that "left", "right", "far", "near" (seen from the door), a compass point or a number name."""
    if name.isdigit():
        return [int(name)] if int(name) < len(room.walls) else []
    way = direction_of(name, room)
    return [wall.index for wall in room.walls if way is None or dot(wall.outward, way) > 0.7]


def corners(survey: Survey) -> list[tuple[Wall, Wall]]:
    """The two walls of each convex corner of the room; of a round room there are none."""
    walls = survey.placed.walls
    return [(walls[w.index - 1], w) for w in walls if cross(walls[w.index - 1].along, w.along) > CORNER]


def of_corner(survey: Survey, body: Body, corner: tuple[Wall, Wall]) -> Measurements:
    """Near both walls of a corner."""
    return tuple(
        at_most(f"gap to wall {w.index}", _gap(survey, body, _whole(w)), IN_CORNER, slack=TOLERANCE) for w in corner
    )


def of_ceiling(survey: Survey, body: Body) -> Measurements:
    """Hanging from the ceiling."""
    return (at_most("gap to the ceiling", survey.scene.room.height - body.z[1], 0.05, slack=TOLERANCE),)


def of_floor(body: Body) -> Measurements:
    """Standing on the floor."""
    return (at_most("height above the floor", body.z[0], 0.03, slack=TOLERANCE),)


def of_segment(survey: Survey, body: Body, kind: str, segment: Segment, params: dict[str, Any]) -> Alternatives | None:
    """The ways in which a relation to a wall, window or door may hold; None for one that says nothing of such."""
    table = _WALL if segment.id.startswith("wall:") else _OPENING
    return table[kind](survey, body, segment, params) if kind in table else None


def _whole(wall: Wall) -> Segment:
    return Segment(f"wall:{wall.index}", wall, 0.0, wall.length, (0.0, math.inf))


def _gap(survey: Survey, body: Body, segment: Segment) -> float:
    """Distance [m] in plan."""
    import shapely

    return float(shapely.distance(survey.footprint(body), segment.line))


def _lateral(survey: Survey, body: Body, segment: Segment) -> tuple[float, float]:
    """Extent [m] of the footprint along the wall, from the middle of the segment."""
    u, _ = segment.wall.coordinates(survey.outline(body).T)
    middle = (segment.start + segment.end) / 2
    return float(u.min()) - middle, float(u.max()) - middle


def _before(survey: Survey, body: Body, segment: Segment, of_segment: bool = False) -> Measurement:
    """How much of the narrower, or of the segment, lies side by side."""
    low, high = _lateral(survey, body, segment)
    half = (segment.end - segment.start) / 2
    least = half if of_segment else min(half, (high - low) / 2)
    return at_least("shared width", min(high, half) - max(low, -half), least, slack=TOLERANCE)


def _centred(survey: Survey, body: Body, segment: Segment) -> Measurement:
    low, high = _lateral(survey, body, segment)
    return at_most("off centre", abs(low + high) / 2, OFF_MIDDLE, slack=TOLERANCE)


def _faces(body: Body, segment: Segment) -> Alternatives:
    """Turned to a window or door, or square to a wall; of a desk who sits at it may be."""
    if segment.id.startswith("wall:"):
        turned = math.degrees(math.acos(max(-1.0, min(1.0, dot(body.front, segment.wall.outward)))))
        offs = (turned if way > 0 else 180.0 - turned for way in ways_of(body))
        return [(at_most("turned away by", off, FACING, "deg", slack=1e-6),) for off in offs]
    return [(turned_to(body, segment.line, segment.middle, way),) for way in ways_of(body)]


Rule = Callable[[Survey, Body, Segment, dict[str, Any]], Alternatives]


def _close(most: float, least: float = 0.0) -> Rule:
    def within(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
        low, high = float(params.get("min", least)), float(params.get("max", most))
        return [(Measurement("gap", _gap(survey, body, segment), low, high, "m", TOLERANCE),)]

    return within


def _hung(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    """Hanging there; what never hangs stands against it: the wardrobe "on the left wall"."""
    row = categories().get(body.item.category)
    if body.item.mount != "wall" and row is not None and "wall" not in row.mount:
        return _close(AT_WALL)(survey, body, segment, params)
    return [
        (
            at_most("gap", _gap(survey, body, segment), HUNG, slack=TOLERANCE),
            at_least("height above the floor", body.z[0], OFF_FLOOR, slack=TOLERANCE),
        )
    ]


def _facing(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    return _faces(body, segment)


def _parallel(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    off = abs(math.degrees(float(wrap_angle(body.yaw - segment.wall.yaw, math.pi / 2))))
    return [(at_most("turned", off, ABREAST, "deg", slack=1e-6),)]


def _along_wall(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    """Against it with a long side."""
    close = _close(AT_WALL)(survey, body, segment, params)[0]
    depth, width = body.size[:2]
    if max(depth, width) < OBLONG * min(depth, width):
        return [close]
    long = body.yaw + (math.pi / 2 if width > depth else 0.0)
    off = abs(math.degrees(float(wrap_angle(long - segment.wall.yaw, math.pi))))
    return [(*close, at_most("long side turned", off, FACING, "deg", slack=1e-6))]


def _centred_at_wall(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    return [(*_close(AT_WALL)(survey, body, segment, params)[0], _centred(survey, body, segment))]


def _centred_at_opening(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    return [(*_close(NEAR)(survey, body, segment, params)[0], _centred(survey, body, segment))]


def _below(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    lower = at_most("top over its middle", body.z[1] - sum(segment.z) / 2, 0.0, slack=TOLERANCE)
    return [(*_close(NEXT)(survey, body, segment, params)[0], _before(survey, body, segment), lower)]


def _above(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    higher = at_least("height over its top", body.z[1] - segment.z[1], 0.0, slack=TOLERANCE)
    return [(*_close(OVER)(survey, body, segment, params)[0], _before(survey, body, segment), higher)]


def _in_front(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    return [(*_close(NEAR)(survey, body, segment, params)[0], _before(survey, body, segment))]


def _on_opening(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    return [(*_close(OVER)(survey, body, segment, params)[0], _before(survey, body, segment, of_segment=True))]


def beside(sign: float) -> Rule:
    """Left (-1) or right (1) of a window or door as seen from within the room."""

    def at_side(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
        low, high = _lateral(
            survey, body, segment
        )  # walls run counter-clockwise: who looks out has the end at the left
        past = -sign * (low + high) / 2 - (segment.end - segment.start) / 2
        close = _close(NEAR)(survey, body, segment, params)[0]
        return [(at_least(f"middle past its {'right' if sign > 0 else 'left'}", past, 0.0, slack=TOLERANCE), *close)]

    return at_side


def _opposite(survey: Survey, body: Body, segment: Segment, params: dict[str, Any]) -> Alternatives:
    x, y = segment.middle
    way = body.centre[0] - x, body.centre[1] - y
    off = abs(math.degrees(math.atan2(cross(segment.wall.inward, way), dot(segment.wall.inward, way))))
    apart = at_least("gap", _gap(survey, body, segment), float(params.get("min", ACROSS)), slack=TOLERANCE)
    return [
        (apart, at_most("off the way across the room", off, ACROSS_ANGLE, "deg", slack=1e-6)),
        *_faces(body, segment),
    ]


_WALL: dict[str, Rule] = {
    **dict.fromkeys(("against", "at", "leaning_on", "behind"), _close(AT_WALL)),
    "along": _along_wall,
    **dict.fromkeys(("next_to", "side_by_side", "in_front_of", "below"), _close(NEXT)),
    **dict.fromkeys(("on", "hanging_from", "above", "inside"), _hung),
    "near": _close(NEAR),
    "far_from": _close(math.inf, AWAY),
    "facing": _facing,
    "opposite": _opposite,
    "parallel": _parallel,
    "aligned": _parallel,
    "centered_on": _centred_at_wall,
}

_OPENING: dict[str, Rule] = {
    **dict.fromkeys(("next_to", "at", "against", "along", "side_by_side", "leaning_on"), _close(NEXT)),
    "near": _close(NEAR),
    "far_from": _close(math.inf, AWAY),
    "in_front_of": _in_front,
    "behind": _close(BEHIND_DOOR),
    "below": _below,
    "above": _above,
    **dict.fromkeys(("on", "hanging_from"), _on_opening),
    "facing": _facing,
    "opposite": _opposite,
    "parallel": _parallel,
    "aligned": _parallel,
    "centered_on": _centred_at_opening,
    "left_of": beside(-1.0),
    "right_of": beside(1.0),
}


def instances(survey: Survey, place: str) -> Iterator[str]:
    """Names of the single walls, openings or corners that "each" means."""
    if place == "corner":
        yield from (f"corner {w.index}" for _, w in corners(survey))
    else:
        yield from (segment.id for segment in segments(survey, place))
