"""Walls of a room by what people call them: long or short, left or far as seen from the door, by compass."""

from __future__ import annotations

from collections.abc import Sequence

from .angles import dot
from .recesses import set_back, set_forward
from .walls import Point, Wall

SAME_WAY = 0.7
"""Least dot product of two directions that count as the same."""

LONG = 0.9
"""Share of the longest wall from which on a wall is a long one."""

_COMPASS = {"south": (0.0, -1.0), "east": (1.0, 0.0), "north": (0.0, 1.0), "west": (-1.0, 0.0)}


def ahead_of(entry: Wall, told: str = "any") -> Point:
    """The way (a unit vector) in which left, right and far are seen by who comes in by a wall.

    Args:
        entry: the wall of the first door.
        told: the side that the request itself gives this wall, as on a plan; then it is at that side.
    """
    (x, y), (u, v) = entry.inward, entry.outward
    return {"left": (v, -u), "right": (-v, u), "far": (u, v)}.get(told, (x, y))


def is_wall(
    name: str, wall: Wall, walls: Sequence[Wall], entry: Wall | None, ahead: Point | None = None, run: str = "any"
) -> bool:
    """Whether a wall is what a name says: left, right, far or near, a compass point, long, short, or "any".

    Args:
        name: of the wall; "side" is left or right.
        wall: which one is looked at.
        walls: all of the room.
        entry: the wall of the first door, from which left, right, far and near are seen; None: they name none.
        ahead: the way in which they are seen where it is not straight in, see `ahead_of`.
        run: "long" or "short" where the wall is one as well.
    """
    if run != "any" and not is_wall(run, wall, walls, entry):
        return False
    if name == "any":
        return True
    if name in ("long", "short") and (set_back(walls) or set_forward(walls)):
        return _runs(name, wall, walls)
    longest = max(one.length for one in walls)
    main = [one for one in walls if one.length > 0.4 * longest]
    if name == "long":
        return wall.length >= LONG * longest
    if name == "short":
        shortest = min(one.length for one in main)
        return wall in main and wall.length <= shortest / LONG
    if name in _COMPASS:
        return dot(wall.outward, _COMPASS[name]) > SAME_WAY
    if entry is None:
        return False
    ahead = ahead or entry.inward
    ways = {
        "far": ahead,
        "near": (-ahead[0], -ahead[1]),
        "left": (-ahead[1], ahead[0]),
        "right": (ahead[1], -ahead[0]),
    }
    names = ("left", "right") if name == "side" else (name,)
    return any(dot(wall.outward, ways[one]) > SAME_WAY for one in names)


def _runs(name: str, wall: Wall, walls: Sequence[Wall]) -> bool:
    """Whether a wall runs along the long or the short sides of a room of which parts of walls stand back or forward."""
    spans = [max(w.start[k] for w in walls) - min(w.start[k] for w in walls) for k in (0, 1)]
    own = spans[0 if abs(wall.along[0]) > abs(wall.along[1]) else 1]
    return own >= LONG * max(spans) if name == "long" else own <= min(spans) / LONG


def are_opposite(one: Wall, other: Wall) -> bool:
    """Whether two walls look at each other."""
    return dot(one.outward, other.outward) < -SAME_WAY


__all__ = ["ahead_of", "are_opposite", "is_wall"]
