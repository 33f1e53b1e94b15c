"""Relations of several things at once: flanking, around, between, in the middle of the room."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

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


def of_between(survey: Survey, body: Body, shapes: Sequence[Any], alike: bool) -> Measurements:
    """For the most part within the hull of some things, and of two on the middle of the way from one to the other, near
    one of them at least; of two that are ``alike``, such as beds, near both."""
    import shapely

    footprint = survey.footprint(body)
    hull = shapely.buffer(shapely.convex_hull(shapely.geometrycollections(list(shapes))), number("hull"))
    share = float(shapely.area(shapely.intersection(footprint, hull)) / max(1e-9, shapely.area(footprint)))
    inside = at_least("share of it between them", share, number("between")["share"], "")
    if len(shapes) != 2:
        return (inside,)
    (ax, ay), (bx, by) = (shapely.get_coordinates(shapely.centroid(s))[0] for s in shapes)
    length = (bx - ax) ** 2 + (by - ay) ** 2
    x, y = body.centre
    part = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / max(1e-9, length)
    low, high = number("between")["along"]
    gaps = sorted(float(shapely.distance(footprint, s)) for s in shapes if shapely.area(s) > 0.0)
    limits = number("between")["near"], number("between")["alike" if alike else "far"]
    apart = [at_most("gap", gap, most) for gap, most in zip(gaps, limits, strict=False)]
    return (inside, Measurement("part of the way between them", float(part), low, high, "", 1e-6), *apart)


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


def _across(survey: Survey, body: Body, target: Target, axis: int) -> tuple[float, float]:
    """Where the middle of a subject is along an axis of a target, and half the extent of that [m]."""
    low, high = spans(survey, body, target)[axis]
    return (low + high) / 2, extent(target, axis) / 2


def of_around(survey: Survey, subjects: Sequence[Body], target: Target) -> Verdict:
    """All about a thing, with steps that are even but for those over the ends of a long one; about what hangs on a wall
    to both sides of it."""
    if not subjects:
        return Verdict(False)
    if len(subjects) == 1 or not isinstance(target, Body):
        return Verdict(True)
    if target.item.mount == "wall":
        return of_flanking(survey, subjects, target)
    (x, y), n = target.centre, len(subjects)
    bearings = np.sort([math.degrees(math.atan2(b.centre[1] - y, b.centre[0] - x)) for b in subjects])
    step = float(np.diff(bearings, append=bearings[0] + 360.0).max())
    return decide([(at_most("largest step around it", step, 360.0 / n + number("uneven"), "deg", slack=1e-6),)])
