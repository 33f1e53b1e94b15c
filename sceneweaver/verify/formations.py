"""Judges of what stands in rows, runs and even places, or across from others: one function a relation type."""

from __future__ import annotations

import math

from sceneweaver.geometry.spread import even_places
from sceneweaver.scene.catalogue import sides_named
from sceneweaver.verify.case import Case
from sceneweaver.verify.contacts import turn
from sceneweaver.verify.measure import TOLERANCE, Judgement, Measurement, Measurements, at_most, judge
from sceneweaver.verify.solids import Point

OPPOSITE = {"front": "back", "back": "front", "left": "right", "right": "left"}


def seated_at(case: Case) -> Judgement:
    """Front against one side of the target, in the middle of the k-th of n equal parts of that side."""
    return judge([_before(case, str(case.spec.value(case.relation, "side")))], "")


def across_from(case: Case) -> Judgement:
    """Front before one side of the target, across a gap, in the middle of the k-th of n equal parts of that side."""
    sides = sides_named(str(case.spec.value(case.relation, "side")), case.other.size)
    return judge([_before(case, side) for side in sides], "")


def next_to(case: Case) -> Judgement:
    """Beyond one side of the target, turned as it is, in line with it."""
    return judge([_straight(case, str(case.spec.value(case.relation, "side")))], "")


def run_on(case: Case) -> Judgement:
    """Straight on beyond one side of the target, or around the corner there: before it, its back in line with that
    side."""
    subject, other = case.subject, case.other
    side = str(case.spec.value(case.relation, "side"))
    low, high = case.spec.gap_range(case.relation, subject.size[0])
    end = other.face(side)
    ahead = (-end.normal[0], -end.normal[1])  # where the subject looks
    flank = subject.face(OPPOSITE[side])
    front = other.face("front")
    around = (
        at_most("turned", turn(subject.front, ahead), case.number("degrees"), "deg"),
        Measurement(
            "gap around the corner", _along(front.centre, flank.centre, front.normal), low, high, "m", TOLERANCE
        ),
        at_most("back off", abs(_along(end.centre, subject.face("back").centre, end.normal)), *_offset(case)),
    )
    return judge([_straight(case, side), around], "")


def on_grid(case: Case) -> Judgement:
    """Centre near the k-th of n places that are spread evenly over the floor, along its first wall and across."""
    places = even_places(case.placed.scene.room.outline, int(case.number("n")))
    if case.number("k") >= len(places):
        return judge([], f"there are {len(places)} places")
    wall, place = case.placed.walls[0], places[int(case.number("k"))]
    offs = (("off its place along the wall", wall.along), ("off its place across", wall.inward))
    centre = case.subject.centre
    return judge([[at_most(name, abs(_along(place, centre, way)), *_offset(case)) for name, way in offs]], "")


def in_middle(case: Case) -> Judgement:
    """Centre near the middle of the floor along x and y."""
    import shapely

    floor = shapely.Polygon(case.placed.scene.room.outline)
    middle = shapely.centroid(floor)
    if not shapely.contains(floor, middle):
        middle = shapely.point_on_surface(floor)
    x, y = case.subject.centre
    offs = (("off the middle along x", x - middle.x), ("off the middle along y", y - middle.y))
    return judge([[at_most(name, abs(off), *_offset(case)) for name, off in offs]], "")


def _before(case: Case, side: str) -> Measurements:
    """Measurements of a front before a part of one side of the target."""
    face, front = case.other.face(side), case.subject.face("front")
    (nx, ny), across = face.normal, (-face.normal[1], face.normal[0])
    place = -face.half + (case.number("k") + 0.5) * 2 * face.half / case.number("n")
    low, high = case.spec.gap_range(case.relation, case.subject.size[0])
    return (
        at_most("turned", turn(front.normal, (-nx, -ny)), case.number("degrees"), "deg"),
        Measurement("gap", _along(face.centre, front.centre, face.normal), low, high, "m", TOLERANCE),
        at_most("off its place", abs(_along(face.centre, front.centre, across) - place), *_offset(case)),
    )


def _straight(case: Case, side: str) -> Measurements:
    """Measurements of the next beyond a side: of left and right neighbours the backs are in line, else the middles."""
    subject, other = case.subject, case.other
    low, high = case.spec.gap_range(case.relation, subject.size[0])
    face = other.face(side)
    near = subject.face(OPPOSITE[side]).centre
    off = math.degrees(subject.yaw - other.yaw)
    if side in ("left", "right"):
        aside = _along(other.face("back").centre, subject.face("back").centre, other.front)
    else:
        aside = other.local(subject.centre)[1]
    return (
        at_most("turned", abs((off + 180.0) % 360.0 - 180.0), case.number("degrees"), "deg"),
        Measurement("gap", _along(face.centre, near, face.normal), low, high, "m", TOLERANCE),
        at_most("out of line", abs(aside), *_offset(case)),
    )


def _along(start: Point, end: Point, direction: Point) -> float:
    """How far one point lies beyond another along a unit vector [m]."""
    return (end[0] - start[0]) * direction[0] + (end[1] - start[1]) * direction[1]


def _offset(case: Case) -> tuple[float, str, float]:
    """The most offset with its unit and slack."""
    return case.number("offset"), "m", TOLERANCE
