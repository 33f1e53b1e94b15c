"""Angles in the plane, in radians; all functions take floats, `wrap_angle` arrays of any shape as well."""

from __future__ import annotations

import math
from typing import Any


def wrap_angle(angle: Any, period: float = math.tau) -> Any:
    """The angle less whole periods, in [-period / 2, period / 2]; which of the two ends is not defined."""
    if isinstance(angle, float | int):
        return math.remainder(angle, period)
    import numpy as np

    return angle - period * np.round(np.asarray(angle) / period)


def heading(yaw: float) -> tuple[float, float]:
    """The unit vector in the direction of a yaw: (cos, sin)."""
    return math.cos(yaw), math.sin(yaw)


def bearing(start: Any, end: Any) -> float:
    """The yaw in (-pi, pi] of the way from one point [2 or more] to another."""
    return math.atan2(end[1] - start[1], end[0] - start[0])


def dot(a: Any, b: Any) -> Any:
    """The inner product of the first two coordinates of two vectors."""
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Any, b: Any) -> Any:
    """The outer product of the first two coordinates of two vectors: of unit vectors, the sine of the turn to b."""
    return a[0] * b[1] - a[1] * b[0]
