"""Where two rooms of a home lie along each other, and where an opening finds a place."""

from __future__ import annotations

from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, quote, show

from .content import HomeContent
from .limits import THICKEST
from .parts import HomeRoom

ROUNDED = 1e-6
"""Length [m] that counts as none."""


def shared_stretches(a: HomeRoom, b: HomeRoom) -> list[tuple[int, float, float]]:
    """Wall of ``a``, first and last offset [m] along it, where a wall of ``b`` runs behind; the longest first."""
    found = []
    for wall in a.walls:
        for other in b.walls:
            if wall.along[0] * other.along[0] + wall.along[1] * other.along[1] > -1 + 1e-9:
                continue
            (low, depth), (high, _) = wall.coordinates(other.end), wall.coordinates(other.start)
            low, high = max(0.0, low), min(wall.length, high)
            if -ROUNDED <= -depth <= THICKEST and high - low > ROUNDED:
                found.append((wall.index, round(low, 3), round(high, 3)))
    return sorted(found, key=lambda f: (f[1] - f[2], f[0]))


def place_between(home: HomeContent, a: str, b: str, at: float, width: float) -> tuple[int, float]:
    """Wall of ``a`` and offset [m] of an opening to ``b``: at a share 0 to 1 of what they share.

    Raises:
        InputError: they share no wall that is as long.
    """
    stretches = shared_stretches(home.room(a), home.room(b))
    if not stretches:
        raise InputError(f"{quote(a)} and {quote(b)} share no wall; only rooms side by side are joined by a door")
    wall, low, high = stretches[0]
    return wall, _offset(f"{quote(a)} and {quote(b)} share", low, high, at, width)


def place_in_wall(room: HomeRoom, wall: int, at: float, width: float) -> float:
    """Offset [m] of an opening in a wall: at a share 0 to 1 of it; InputError where the wall is shorter."""
    return _offset(f"wall {wall} of {quote(room.id)} has", 0.0, room.walls[wall].length, at, width)


def _offset(what: str, low: float, high: float, at: float, width: float) -> float:
    if not is_number(at) or not 0 <= at <= 1:
        raise InputError(f"at is {show(at)}; give a share of the wall, 0 to 1")
    if not is_number(width) or width <= 0:
        raise InputError(f"width is {show(width)}; give metres")
    if width > high - low + ROUNDED:
        raise InputError(f"width is {width:g} m, but {what} {high - low:g} m of wall")
    return round(low + max(0.0, high - low - width) * at, 3)
