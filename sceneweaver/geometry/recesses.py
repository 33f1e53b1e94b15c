"""Parts of walls that stand back or forward, by their corners: niches, bays, chimney breasts, and what is beside these.

A niche is a wall set back between two sides that lead out of the room, a breast one set forward between two that lead
into it.
"""

from __future__ import annotations

from collections.abc import Sequence

from .angles import cross, dot
from .walls import Wall

SIDE = (0.15, 2.6)
"""Lengths [m] of the sides of what stands back or forward."""

WIDEST = 4.0
"""Width [m] up to which it is a part of a wall, and not of the room."""

_TURN = 0.3
"""Least sine of the turns at its corners: the sides of a bay may be slanted."""

_ALONG = 0.95
"""Least cosine between its wall and the walls on both sides of it."""


def set_back(walls: Sequence[Wall]) -> list[int]:
    """The walls at the back of niches and bays, by their numbers."""
    return [wall.index for wall in walls if _stands(wall, walls, -1.0)]


def set_forward(walls: Sequence[Wall]) -> list[int]:
    """The fronts of chimney breasts, by their numbers."""
    return [wall.index for wall in walls if _stands(wall, walls, 1.0)]


def beside_forward(walls: Sequence[Wall]) -> list[int]:
    """The short walls on both sides of a chimney breast, from it to a corner of the room, by their numbers."""
    many, found = len(walls), list[int]()
    for front in set_forward(walls):
        for beside, beyond in ((front - 2, front - 3), (front + 2, front + 3)):
            wall, other = walls[beside % many], walls[beyond % many]
            turn = cross(other.along, wall.along) if beside < front else cross(wall.along, other.along)
            if turn > _TURN and wall.length <= WIDEST:
                found.append(wall.index)
    return found


def between_forward(walls: Sequence[Wall]) -> list[int]:
    """The walls between two that stand forward: what is open in a chimney breast, by their numbers."""
    fronts, many = set(set_forward(walls)), len(walls)
    return [w.index for w in walls if {(w.index - 2) % many, (w.index + 2) % many} <= fronts and w.length <= WIDEST]


def sides_of(index: int, walls: Sequence[Wall]) -> tuple[Wall, Wall]:
    """The two sides of a wall that stands back or forward."""
    return walls[index - 1], walls[(index + 1) % len(walls)]


def _stands(wall: Wall, walls: Sequence[Wall], sign: float) -> bool:
    """Whether a wall stands forward (sign 1) or back (-1) of those on both sides of it."""
    if len(walls) <= 4 or wall.length > WIDEST:
        return False
    before, after = sides_of(wall.index, walls)
    first, last = walls[wall.index - 2], walls[(wall.index + 2) % len(walls)]
    own = -sign * cross(before.along, wall.along), -sign * cross(wall.along, after.along)
    outer = sign * cross(first.along, before.along), sign * cross(after.along, last.along)
    along = min(dot(first.along, wall.along), dot(last.along, wall.along))
    deep = all(SIDE[0] <= side.length <= SIDE[1] for side in (before, after))
    return deep and min(*own, *outer) > _TURN and along > _ALONG


__all__ = ["beside_forward", "between_forward", "set_back", "set_forward", "sides_of"]
