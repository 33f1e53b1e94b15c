"""Checks of polygons: simple, counter-clockwise, convex. Plain Python: the polygons of a scene are small."""

from __future__ import annotations

import math

from sceneweaver.geometry.polygons import signed_area

from .messages import FieldError

Vec2 = tuple[float, float]
Points = tuple[Vec2, ...]

MIN_EDGE = 1e-6
"""Shortest edge [m]: what is shorter counts as a repeated corner."""

MIN_AREA = 1e-10
"""Least area [m2] of a polygon."""

CONVEX_TOLERANCE = 1e-9
"""Least sine of the turn at a corner of a convex polygon, negated."""

_MANY = 64


def check_simple(points: Points) -> None:
    """Refuse a polygon with repeated corners, crossing or touching edges, or no area.

    Raises:
        FieldError: with the corner, and what to do.
    """
    n = len(points)
    for i, (x, y) in enumerate(points):
        j = (i + 1) % n
        if math.hypot(points[j][0] - x, points[j][1] - y) < MIN_EDGE:
            if j == 0:
                raise FieldError((i,), "repeats corner 0; leave the closing corner out")
            raise FieldError((j,), f"repeats corner {i}; remove one of them")
    for i in range(n):
        (ax, ay), (bx, by), (cx, cy) = points[i - 1], points[i], points[(i + 1) % n]
        ux, uy, vx, vy = bx - ax, by - ay, cx - bx, cy - by
        if ux * vx + uy * vy < 0 and abs(ux * vy - uy * vx) <= 1e-12 * math.hypot(ux, uy) * math.hypot(vx, vy):
            raise FieldError((i,), "is a spike where the outline doubles back on itself; remove the corner")
    _check_crossing(points)
    if abs(signed_area(points)) < MIN_AREA:
        raise FieldError((), "has no area; give corners that enclose some")


def counter_clockwise(points: Points) -> Points:
    """The same simple polygon, counter-clockwise, from the same first corner.

    Raises:
        FieldError: when it is not simple.
    """
    check_simple(points)
    return points if signed_area(points) > 0 else (points[0], *reversed(points[1:]))


def convex(points: Points) -> Points:
    """The same simple polygon, counter-clockwise.

    Raises:
        FieldError: when it is not simple or not convex.
    """
    points = counter_clockwise(points)
    n = len(points)
    for i in range(n):
        (ax, ay), (bx, by), (cx, cy) = points[i - 1], points[i], points[(i + 1) % n]
        ux, uy, vx, vy = bx - ax, by - ay, cx - bx, cy - by
        if ux * vy - uy * vx < -CONVEX_TOLERANCE * math.hypot(ux, uy) * math.hypot(vx, vy):
            where = f"({bx:g}, {by:g})"
            raise FieldError((), f"is not convex at corner {where}; split it into convex parts")
    return points


def _check_crossing(points: Points) -> None:
    n = len(points)
    if n > _MANY:
        from shapely.geometry import Polygon  # noqa: PLC0415 - heavy, and few outlines are this long
        from shapely.validation import explain_validity

        reason = explain_validity(Polygon(points))
        if reason != "Valid Geometry":
            raise FieldError((), f"crosses itself ({reason}); list the corners in order around the shape")
        return
    for i in range(n):
        for j in range(i + 2, n - (i == 0)):
            if _touch(points[i], points[i + 1], points[j], points[(j + 1) % n]):
                raise FieldError(
                    (), f"crosses itself: edges {i} and {j} meet; list the corners in order around the shape"
                )


def _turn(a: Vec2, b: Vec2, c: Vec2) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _between(a: Vec2, b: Vec2, c: Vec2) -> bool:
    """Whether c, on the line through a and b, lies between them."""
    return min(a[0], b[0]) <= c[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= c[1] <= max(a[1], b[1])


def _touch(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> bool:
    """Whether the segments ab and cd share a point."""
    abc, abd, cda, cdb = _turn(a, b, c), _turn(a, b, d), _turn(c, d, a), _turn(c, d, b)
    if ((abc > 0 and abd < 0) or (abc < 0 and abd > 0)) and ((cda > 0 and cdb < 0) or (cda < 0 and cdb > 0)):
        return True
    return (
        (abc == 0 and _between(a, b, c))
        or (abd == 0 and _between(a, b, d))
        or (cda == 0 and _between(c, d, a))
        or (cdb == 0 and _between(c, d, b))
    )
