"""The heights at which furniture is used: where people sit on it, the top that they work at, and their knees."""

from __future__ import annotations

from collections.abc import Sequence

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.scene import Part, Surface


def used_level(parts: Sequence[Part], surfaces: Sequence[Surface]) -> float | None:
    """The height [m] of the largest surface above the bottom of a thing, of equal ones the highest; without a surface,
    as on a chair, that of its largest part; None for what has neither."""
    if surfaces:
        most = max(abs(signed_area(s.polygon)) for s in surfaces)
        return max(s.z for s in surfaces if abs(signed_area(s.polygon)) > 0.8 * most)
    if not parts:
        return None
    return max(parts, key=lambda part: abs(signed_area(part.polygon))).z[1]


KNEES = 0.25
"""How far in [m] from the edge of a top the knees of who sits at it are."""


def clear_below(parts: Sequence[Part], size: Sequence[float]) -> float | None:
    """The clear height [m] below a top for the knees of who sits at the middle of a side, where there is most; None
    where nothing is above them.

    Args:
        parts: prisms of a thing, about its middle in plan.
        size: depth, width and height of the thing [m].
    """
    depth, width = size[0] / 2, size[1] / 2
    sides = ((depth - KNEES, 0.0), (KNEES - depth, 0.0), (0.0, width - KNEES), (0.0, KNEES - width))
    above = [[part.z[0] for part in parts if _covers(part.polygon, x, y)] for x, y in sides]
    return max((min(lows) for lows in above if lows), default=None)


def _covers(polygon: Sequence[Sequence[float]], x: float, y: float) -> bool:
    """Whether a point is in a polygon: a ray from it crosses the edges an odd number of times."""
    inside = False
    for (ax, ay), (bx, by) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


__all__ = ["clear_below", "used_level"]
