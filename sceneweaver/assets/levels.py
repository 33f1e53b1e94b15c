"""The heights at which furniture is used: where people sit on it, and the top that they work and eat at."""

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


__all__ = ["used_level"]
