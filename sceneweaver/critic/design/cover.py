"""Measures of the shell: what covers walls and windows, where lamps hang, how large the free floor is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.walls import Wall, wall_behind
from sceneweaver.knowledge.kin import at_home_in
from sceneweaver.rules.design import room_groups
from sceneweaver.verify.solids import Body, Opening

from ..space import floor_of
from ..survey import Survey
from .measure import along, end_of, strip
from .measure import overlap as shared
from .plan import over
from .query import kind_set
from .registry import Reading, measure

SPOTS = 300
"""Points of the floor at which its light is looked at."""

EATEN_AT = "=dining_table =round_dining_table =oval_table =cafe_table"


@measure
def lean(survey: Survey) -> bool:
    """Whether the request leaves things out: by "only", or by "sparse"."""
    return bool(survey.brief.only) or survey.brief.density == "sparse"


@measure
def in_rooms(survey: Survey, group: str) -> bool:
    """Whether the room is of a kind, or of a group of kinds."""
    return survey.room_type.name in room_groups().get(group, (group,))


@measure
def room_area(survey: Survey) -> float:
    """Floor [m2]."""
    return survey.area


@measure
def requested(survey: Survey, kinds_: str) -> bool:
    """Whether the request names a thing of a set of categories."""
    return any(e.category in kind_set(kinds_) for e in survey.brief.entities)


@measure
def windows(survey: Survey) -> Sequence[Opening]:
    """The windows of the room."""
    return list(survey.placed.windows)


# ---- walls -----------------------------------------------------------------------------------------------------------


class Span(NamedTuple):
    """A stretch along a wall [m]."""

    start: float
    end: float


def spans_of(survey: Survey, wall: Wall, tall: float, close: float) -> list[Span]:
    """Stretches of a wall with an opening, something hung, or furniture of a height [m] within a gap [m]; in order."""
    spans = [Span(o.item.offset, o.item.offset + o.item.width) for o in _openings(survey) if o.wall.index == wall.index]
    for body in survey.bodies:
        hung = body.item.mount == "wall"
        if not hung and not (body.item.mount == "floor" and body.size[2] >= tall):
            continue
        alongs, depths = zip(*(wall.coordinates(corner) for corner in body.corners), strict=True)
        if min(depths) > close or max(alongs) < 0.0 or min(alongs) > wall.length:
            continue
        if hung and wall_behind(survey.placed.walls, body.position, body.front) != wall.index:
            continue
        spans.append(Span(max(0.0, min(alongs)), min(wall.length, max(alongs))))
    merged: list[Span] = []
    for span in sorted(spans):
        if merged and span.start <= merged[-1].end:
            merged[-1] = Span(merged[-1].start, max(merged[-1].end, span.end))
        else:
            merged.append(span)
    return merged


def _openings(survey: Survey) -> list[Opening]:
    return [*survey.placed.doors, *survey.placed.windows]


def free_runs(survey: Survey, wall: Wall, tall: float, close: float) -> list[Span]:
    """Stretches of a wall with nothing on them."""
    at, runs = 0.0, []
    for span in [*spans_of(survey, wall, tall, close), Span(wall.length, wall.length)]:
        if span.start > at:
            runs.append(Span(at, span.start))
        at = max(at, span.end)
    return runs


@measure
def bare(survey: Survey, wall: Wall, run: float, tall: float, close: float) -> float:
    """Length [m] of a wall in stretches, longer than ``run`` [m], that have nothing on them."""
    return sum(r.end - r.start for r in free_runs(survey, wall, tall, close) if r.end - r.start > run)


@measure
def covered(survey: Survey, wall: Wall, tall: float, close: float) -> float:
    """Share of a wall with an opening, something hung, or tall furniture."""
    return 1.0 - sum(r.end - r.start for r in free_runs(survey, wall, tall, close)) / wall.length


@measure
def wall_of(survey: Survey, o: Body) -> Wall:
    """The wall that something hangs on."""
    return survey.placed.walls[wall_behind(survey.placed.walls, o.position, o.front)]


@measure
def corner_gap(survey: Survey, o: Body) -> float:
    """Distance [m] along its wall between what hangs there and the nearest end of the wall."""
    wall = wall_of(survey, o)
    at, _ = wall.coordinates(o.centre)
    return min(at, wall.length - at) - o.size[1] / 2


@measure
def below(survey: Survey, o: Body) -> Body | None:
    """The furniture that something hangs over."""
    for other, _ in survey.near(o, 0.3):
        lower = other.item.category in kind_set(OVER) and other.item.mount == "floor" and other.z[1] < o.z[1]
        if lower and abs(other.local(o.centre)[1]) < other.size[1] / 2:
            return other
    return None


OVER = "sofa any_bed =sideboard =dresser =console_table =desk"
"""What art is hung over."""


# ---- windows ---------------------------------------------------------------------------------------------------------


@measure
def curtains(survey: Survey, window: Opening) -> tuple[Body, ...]:
    """The curtains before a window."""
    found = []
    for body in survey.of_kind(kind_set("curtain")):
        at, depth = window.wall.coordinates(body.centre)
        middle = window.item.offset + window.item.width / 2
        if depth < 0.5 and abs(at - middle) < (window.item.width + body.size[1]) / 2:
            found.append(body)
    return tuple(found)


def _ends(window: Opening, bodies: Sequence[Body]) -> tuple[float, float]:
    """Where along the wall of a window [m] its curtains begin and end."""
    spots = [(float(window.wall.coordinates(b.centre)[0]), b.size[1] / 2) for b in bodies]
    return min(at - half for at, half in spots), max(at + half for at, half in spots)


@measure
def curtain_offset(_: Survey, window: Opening, bodies: Sequence[Body]) -> float:
    """How far [m] the middle of some curtains is off the middle of their window."""
    left, right = _ends(window, bodies)
    return abs((left + right) / 2 - window.item.offset - window.item.width / 2)


@measure
def curtain_beyond(_: Survey, window: Opening, bodies: Sequence[Body]) -> float:
    """How far [m] curtains reach beyond their window, the lesser side."""
    left, right = _ends(window, bodies)
    return min(window.item.offset - left, right - end_of(window))


@cache
def may_hide_kinds() -> frozenset[str]:
    """The categories that may stand or hang before a window."""
    return kind_set("see_through window_dressing any_bed") | at_home_in("gym")


@measure
def may_hide(_: Survey, o: Body) -> bool:
    """Whether it may stand or hang before a window."""
    return o.item.category in may_hide_kinds()


@measure
def across(_: Survey, window: Opening, o: Body, depth: float) -> float:
    """Width [m] that a body takes of the room before a window, up to a depth [m]."""
    u, (near, _far) = along(window, o)
    return shared((window.item.offset, end_of(window)), u) if near <= depth else 0.0


@measure
def shaded(survey: Survey, window: Opening, o: Body, depth: float) -> float:
    """Share of a window that a body before it covers."""
    high = max(0.0, min(o.z[1], window.z[1]) - window.z[0]) / (window.z[1] - window.z[0])
    return high * across(survey, window, o, depth) / window.item.width


# ---- light -----------------------------------------------------------------------------------------------------------


@measure
def middle_off(_: Survey, lamps: Sequence[Body], table: Body) -> float:
    """Distance [m] between the middle of some lamps and that of a table."""
    x, y = np.mean([b.centre for b in lamps], axis=0)
    return math.dist((float(x), float(y)), table.centre)


def _eaten_at(survey: Survey, lamp: Body) -> Body | None:
    tables = survey.standing
    return next((t for t in tables if t.item.category in kind_set(EATEN_AT) and over(survey, t, lamp, 0.1)), None)


@measure
def over_table(survey: Survey, lamp: Body) -> float:
    """Height [m] of the lower end of a lamp over the dining table below it; the usual one without a table."""
    table = _eaten_at(survey, lamp)
    if table is None:
        return 0.7
    return lamp.z[0] - (max(s.z for s in table.item.surfaces) if table.item.surfaces else 0.75)


@measure
def tables_under(survey: Survey, lamps: Sequence[Body]) -> tuple[Body, ...]:
    """The dining tables below some lamps."""
    return tuple(t for t in (_eaten_at(survey, lamp) for lamp in lamps) if t is not None)


@measure
def off_centre(survey: Survey, o: Body) -> float:
    """Distance [m] from the middle of the floor."""
    centroid = survey.placed.floor.centroid
    return math.dist(o.centre, (float(centroid.x), float(centroid.y)))


@measure
def unlit(survey: Survey, lamps: Sequence[Body], reach: float) -> float:
    """Share of the floor that is farther from any lamp than a distance [m]."""
    floor = floor_of(survey)
    rows, columns = np.nonzero(floor.inside)
    pick = slice(None, None, max(1, len(rows) // SPOTS))
    u = floor.origin[0] + (columns[pick] + 0.5) * floor.cell
    v = floor.origin[1] + (rows[pick] + 0.5) * floor.cell
    x, y = SE2(yaw=floor.turn).world(u, v)
    centres = np.array([b.centre for b in lamps])
    away = np.hypot(x[:, None] - centres[:, 0], y[:, None] - centres[:, 1]).min(axis=1)
    return float((away > reach).mean())


# ---- floor -----------------------------------------------------------------------------------------------------------


@measure
def free_square(survey: Survey, stand: float) -> Reading:
    """Side [m] of the largest square of floor, along the walls, with nothing on it; and its middle (x, y) [m]."""
    from scipy.ndimage import distance_transform_cdt

    floor = floor_of(survey)
    free = np.pad(floor.inside & ~floor.taken & ~_worked_on(survey, stand), 1)
    if not free.any():
        return Reading.of(0.0, (0.0, 0.0))
    distances: Any = distance_transform_cdt(free, metric="chessboard")
    steps = distances[1:-1, 1:-1]
    row, column = np.unravel_index(int(np.argmax(steps)), steps.shape)
    return Reading.of(2 * int(steps.max()) * floor.cell, floor.world(row + 0.5, column + 0.5))


@measure
def where(_: Survey, value: Reading) -> str:
    """The point of a reading in words."""
    x, y = value.by
    return f"({x:.1f}, {y:.1f})"


def _worked_on(survey: Survey, depth: float) -> NDArray[np.bool_]:
    """The floor of a home on which one enters, or stands to use something: a mask like those of `Floor`."""
    import shapely

    floor = floor_of(survey)
    if survey.room_type.name not in room_groups()["homelike"]:
        return np.zeros_like(floor.inside)
    areas = [shapely.Polygon(zone) for zone in survey.placed.opening_zones.xy[: len(survey.placed.doors)]]
    areas += [
        strip(body, "front", depth, 1.0)
        for body in survey.on_floor(kind_set("opened washbasin bathtub shower kitchen_unit"))
    ]
    rows, columns = np.indices(floor.inside.shape)
    x, y = floor.world(rows + 0.5, columns + 0.5)
    return np.asarray(shapely.contains_xy(shapely.union_all(areas), x, y))
