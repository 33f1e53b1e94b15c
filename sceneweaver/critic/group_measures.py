"""Relations of several things at once: flanking, around, between, in the middle of the room."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from sceneweaver.language.vocabulary import family
from sceneweaver.language.wall_names import direction_of
from sceneweaver.rules.stated import number, word_of_place
from sceneweaver.verify.measure import TOLERANCE, Measurement, Measurements, at_least, at_most
from sceneweaver.verify.solids import Body
from sceneweaver.verify.stated import Target, extent, gap, spans

from .survey import Survey
from .verdict import Verdict, counted, decide


def outline(survey: Survey, body: Body) -> Any:
    """The hull of a footprint as a shapely geometry."""
    import shapely

    return shapely.convex_hull(survey.footprint(body))


def of_middle(survey: Survey, subjects: Sequence[Body]) -> Measurement:
    """A group as a whole in the middle of the floor."""
    centroid = survey.placed.floor.centroid
    x, y = np.mean([b.centre for b in subjects], axis=0)
    away = math.hypot(float(x - centroid.x), float(y - centroid.y))
    row = word_of_place("at", "middle").holds[0].rows[0]
    _, most = row.interval({"area": survey.area}) or (0.0, math.inf)
    return at_most(row.text, away, most)


def of_half(survey: Survey, body: Body, side: str) -> Measurement:
    """A body on the side of the floor's middle where the wall of that name is."""
    centroid = survey.placed.floor.centroid
    ahead = direction_of(side, survey.scene.room) or (0.0, 0.0)
    beyond = (body.centre[0] - centroid.x) * ahead[0] + (body.centre[1] - centroid.y) * ahead[1]
    row = word_of_place("at", "half").holds[0].rows[0]
    least, _ = row.interval({}) or (0.0, math.inf)
    return at_least(row.text, float(beyond), least)


def apart(one: Body, other: Body) -> float:
    """The gap [m] between the boxes of two bodies, seen from above."""
    import shapely

    return float(shapely.distance(shapely.Polygon(one.corners), shapely.Polygon(other.corners)))


def nearest_point(body: Body, point: tuple[float, float]) -> tuple[float, float]:
    """The point of the box of a body that is nearest to another, seen from above."""
    ahead, aside = (max(-side / 2, min(side / 2, v)) for side, v in zip(body.size, body.local(point), strict=False))
    c, s = math.cos(body.yaw), math.sin(body.yaw)
    return body.centre[0] + c * ahead - s * aside, body.centre[1] + s * ahead + c * aside


def of_between(survey: Survey, body: Body, shapes: Sequence[Any], bodies: Sequence[Body | None] = ()) -> Measurements:
    """For the most part within the hull of some things, and of two on the middle of the way from one to the other.

    Between two ``bodies`` of a kind, such as two beds, a standing thing is within reach of both; between others of one
    at least. Of two at right angles it is before both.
    """
    import shapely

    pair = [b for b in bodies if b is not None]
    close = tuple(_reach(body, pair)) if len(pair) == 2 and len(shapes) == 2 else ()
    if close and abs(math.sin(pair[0].yaw - pair[1].yaw)) > number("corner") and all(m.ok() for m in close):
        ahead = min(b.local((body.centre[0], body.centre[1]))[0] for b in pair)
        return (*close, at_least("before both", ahead, 0.0))

    footprint = survey.footprint(body)
    hull = shapely.buffer(shapely.convex_hull(shapely.geometrycollections(list(shapes))), number("hull"))
    share = float(shapely.area(shapely.intersection(footprint, hull)) / max(1e-9, shapely.area(footprint)))
    inside = at_least("share of it between them", share, number("between")["share"], "")
    if len(shapes) != 2:
        return (inside,)
    inside_all = (inside, *close)
    (ax, ay), (bx, by) = (shapely.get_coordinates(shapely.centroid(s))[0] for s in shapes)
    length = (bx - ax) ** 2 + (by - ay) ** 2
    x, y = body.centre
    part = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / max(1e-9, length)
    low, high = number("between")["along"]
    return (*inside_all, Measurement("part of the way between them", float(part), low, high, "", 1e-6))


def _reach(body: Body, pair: Sequence[Body]) -> Iterator[Measurement]:
    """How far what stands between two things is from them."""
    if body.item.mount != "floor" or body.size[2] <= number("flat") or any(b.item.mount != "floor" for b in pair):
        return
    gaps = sorted(apart(body, b) for b in pair)
    if family(pair[0].item.category) == family(pair[1].item.category):
        yield at_most("gap to the farther of them", gaps[1], number("between_alike"))
    else:
        yield at_most("gap to the nearer of them", gaps[0], number("between_others"))


def shared_out(survey: Survey, subjects: Sequence[Body], targets: Sequence[Target], kind: str) -> list[list[Body]]:
    """For each target the subjects beside it; of what stands around things each belongs to the nearest one."""
    gaps = [[_gap(survey, s, t) for t in targets] for s in subjects]
    parts: list[list[Body]] = [[] for _ in targets]
    for body, row in zip(subjects, gaps, strict=True):
        for k, distance in enumerate(row):
            if distance <= number("beside") + TOLERANCE and (kind == "flanking" or k == int(np.argmin(row))):
                parts[k].append(body)
    return parts


def _gap(survey: Survey, body: Body, target: Target) -> float:
    if isinstance(target, Body):
        return math.inf if body is target else gap(survey, body, target)
    import shapely

    return float(shapely.distance(survey.footprint(body), target.line))


def of_flanking(survey: Survey, subjects: Sequence[Body], target: Target) -> Verdict:
    """On both of two opposite sides of a thing, each past that side."""
    ways = []
    for axis in (1, 0) if isinstance(target, Body) else (1,):
        sides = []
        for body in subjects:
            middle, half = _across(survey, body, target, axis)
            sides.append(0 if abs(middle) < half - TOLERANCE else 1 if middle > 0 else -1)
        fewer = min(sides.count(1), sides.count(-1))
        ways.append(
            (counted("objects on the emptier side", fewer, 1), counted("objects on no side", sides.count(0), 0, 0))
        )
    return decide(ways)


def _taken_about(survey: Survey, body: Body, target: Body) -> float:
    """The angle [deg] that a body takes up, seen from the middle of another; all of it where it holds that."""
    import shapely

    shape = shapely.convex_hull(survey.footprint(body))
    x, y = target.centre
    if shapely.intersects(shape, shapely.points(x, y)):
        return 360.0
    bearings = [math.degrees(math.atan2(b - y, a - x)) for a, b in shapely.get_coordinates(shape)]
    bearings.sort()
    steps = np.diff(bearings, append=bearings[0] + 360.0)
    return 360.0 - float(steps.max())


def _across(survey: Survey, body: Body, target: Target, axis: int) -> tuple[float, float]:
    """Where the middle of a subject is along an axis of a target, and half the extent of that [m]."""
    low, high = spans(survey, body, target)[axis]
    return (low + high) / 2, extent(target, axis) / 2


def of_around(survey: Survey, subjects: Sequence[Body], target: Target) -> Verdict:
    """All about a thing, with steps that are even but for those over the ends of a long one; about what hangs on a wall
    to both sides of it."""
    if not subjects:
        return Verdict(False)
    if not isinstance(target, Body):
        return Verdict(True)
    if len(subjects) == 1:
        return decide(
            [
                (
                    at_least(
                        "angle that it takes around it",
                        _taken_about(survey, subjects[0], target),
                        number("least_around"),
                        "deg",
                    ),
                )
            ]
        )
    if target.item.mount == "wall":
        return of_flanking(survey, subjects, target)
    (x, y), n = target.centre, len(subjects)
    bearings = np.sort([math.degrees(math.atan2(b.centre[1] - y, b.centre[0] - x)) for b in subjects])
    step = float(np.diff(bearings, append=bearings[0] + 360.0).max())
    return decide([(at_most("largest step around it", step, 360.0 / n + number("uneven"), "deg", slack=1e-6),)])
