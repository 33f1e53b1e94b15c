"""Measures of the room and its shell: its kind, doors and windows, what is on and before its walls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from sceneweaver.geometry.walls import Wall, wall_behind
from sceneweaver.knowledge import small_things
from sceneweaver.rules.design import room_groups
from sceneweaver.verify.solids import Body, Opening

from ..survey import Survey
from .measure import along, middle
from .query import kind_set
from .registry import Span, measure

FLUSH = 0.25
"""Distance [m] from a wall up to which a unit stands or hangs along it."""

SLIM = 0.8
"""Depth [m] from a wall up to which a unit belongs to what runs along it."""

# ---- the room --------------------------------------------------------------------------------------------------------


@measure
def room(survey: Survey) -> Survey:
    """The room: area, room_type, placed, scene, brief."""
    return survey


@measure
def in_rooms(survey: Survey, group: str) -> bool:
    """Whether the room is of a kind, or of a group of kinds."""
    return survey.room_type.name in room_groups().get(group, (group,))


@measure
def sparse_walls(survey: Survey) -> bool:
    """Whether walls of such a room are for use, and may be bare."""
    return small_things.sparse_walls(survey.room_type.name)


@measure
def lean(survey: Survey) -> bool:
    """Whether the request leaves things out: by "only", or by "sparse"."""
    return bool(survey.brief.only) or survey.brief.density == "sparse"


@measure
def doors(survey: Survey) -> Sequence[Opening]:
    """The doors of the room."""
    return survey.placed.doors


@measure
def windows(survey: Survey) -> Sequence[Opening]:
    """The windows of the room."""
    return survey.placed.windows


@measure
def has_doors(survey: Survey) -> bool:
    """Whether the room has a door and things that stand in it."""
    return bool(survey.placed.doors and survey.standing)


@measure
def point_before(_: Survey, opening: Opening, depth: float) -> Any:
    """The point at a depth [m] before the middle of a door or window, as a shape."""
    import shapely

    return shapely.Point(middle(opening, depth))


# ---- walls -----------------------------------------------------------------------------------------------------------


class Back(NamedTuple):
    """The wall that a back looks at, the gap [m] and the angle [deg] between them."""

    wall: Wall
    gap: float
    angle: float


@measure
def back_wall(survey: Survey, o: Body) -> Back | None:
    """The wall behind a body; None where there is none."""
    found = survey.back_wall(o)
    return Back(found[0], found[1], math.degrees(found[2])) if found is not None else None


@measure
def wall_of(survey: Survey, o: Body) -> Wall:
    """The wall that something hangs on."""
    return survey.placed.walls[wall_behind(survey.placed.walls, o.position, o.front)]


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
def below(survey: Survey, o: Body, kinds_: str) -> Body | None:
    """The furniture of a set of categories that something hangs over."""
    for other, _ in survey.near(o, 0.3):
        lower = other.item.category in kind_set(kinds_) and other.item.mount == "floor" and other.z[1] < o.z[1]
        if lower and abs(other.local(o.centre)[1]) < other.size[1] / 2:
            return other
    return None


def spans_of(survey: Survey, wall: Wall, tall: float, close: float) -> list[Span]:
    """Stretches of a wall with an opening, something hung, or furniture of a height [m] within a gap [m]; in order."""
    openings = (*survey.placed.doors, *survey.placed.windows)
    spans = [Span(o.item.offset, o.item.offset + o.item.width) for o in openings if o.wall.index == wall.index]
    for body in survey.bodies:
        hung = body.item.mount == "wall"
        if not hung and not (body.item.mount == "floor" and body.size[2] >= tall):
            continue
        (start, end), (near, _) = along(wall, body)
        if near > close or end < 0.0 or start > wall.length:
            continue
        if hung and wall_of(survey, body).index != wall.index:
            continue
        spans.append(Span(max(0.0, start), min(wall.length, end)))
    return merged(spans)


def merged(spans: Sequence[Span]) -> list[Span]:
    """The union of some intervals, in order."""
    found: list[Span] = []
    for span in sorted(spans):
        if found and span.start <= found[-1].end:
            found[-1] = Span(found[-1].start, max(found[-1].end, span.end))
        else:
            found.append(span)
    return found


@measure
def free_runs(survey: Survey, wall: Wall, tall: float, close: float) -> list[Span]:
    """Stretches of a wall with nothing on them and no furniture of a height [m] within a gap [m] before them."""
    at, runs = 0.0, []
    for span in [*spans_of(survey, wall, tall, close), Span(wall.length, wall.length)]:
        if span.start > at:
            runs.append(Span(at, span.start))
        at = max(at, span.end)
    return runs


@measure
def hung_share(survey: Survey, units: Sequence[Body], hung: Sequence[Body], hoods: Sequence[Body]) -> float:
    """Share of the wall over a run of units, but for hoods and windows, that has something of ``hung`` on it."""
    free = covered = 0.0
    for wall in survey.placed.walls:

        def spans(bodies: Sequence[Body], wall: Any = wall) -> list[Span]:
            rows = [along(wall, b) for b in bodies]
            return [Span(*u) for u, v in rows if v[0] < FLUSH and u[1] - u[0] > 0.05 and v[1] < SLIM]

        if run := spans(units):
            windows_ = (w.item for w in survey.placed.windows if w.wall.index == wall.index)
            gone = [Span(w.offset, w.offset + w.width) for w in windows_]
            free += _length(run) - _shared(run, gone + spans(hoods))
            covered += _shared(run, spans(hung))
    return covered / free if free > 0.5 else 1.0


def _length(spans: Sequence[Span]) -> float:
    """Length [m] of the union of some intervals."""
    return sum(s.length for s in merged(spans))


def _shared(a: Sequence[Span], b: Sequence[Span]) -> float:
    """Length [m] of what two sets of intervals share."""
    parts = [Span(max(x.start, y.start), min(x.end, y.end)) for x in a for y in b]
    return _length([p for p in parts if p.length > 0.0])
