"""The shell of a room as boxes that collide: the floor, and the walls around their openings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.geometry.angles import cross
from sceneweaver.geometry.shell import PANE_THICKNESS, WALL_THICKNESS, Span, wall_pieces
from sceneweaver.scene import Door, Room

FLOOR_FRICTION, LEAF_FRICTION = 0.8, 0.5
"""Of the floor and the walls, and of the leaves of doors."""

_DEEP = 0.5  # [m] of the floor: nothing falls through it in one step
_NEAR = 1.2 * WALL_THICKNESS  # [m] from a corner, a door is in the way of the next wall's slab


@dataclass(frozen=True, eq=False)
class Slab:
    """A box by its ``centre`` [3] and ``half`` extents [3] [m]; ``pane``: it closes a window.

    With ``points`` [N, 3] it is their hull, and the box is around it.
    """

    centre: np.ndarray
    half: np.ndarray
    pane: bool = False
    points: np.ndarray | None = None


def floor_slab(room: Room) -> Slab:
    """The floor under room and walls, its top at z = 0, in the world."""
    low, high = np.min(room.outline, axis=0) - WALL_THICKNESS, np.max(room.outline, axis=0) + WALL_THICKNESS
    return Slab(np.array([*(low + high) / 2, -_DEEP / 2]), np.array([*(high - low) / 2, _DEEP / 2]))


def wall_slabs(room: Room, wall: int) -> list[Slab]:
    """A wall around its openings, in its frame: at its first corner, +x along it, +y into the room.

    Windows have a pane, doorways are open.
    """
    pieces = wall_pieces(room.walls[wall].length, room.openings_of(wall), room.height, wall_ends(room, wall))
    return [wall_slab(x, z, opening is not None) for x, z, opening in pieces if not isinstance(opening, Door)]


def wall_slab(x: Span, z: Span, pane: bool = False) -> Slab:
    """The box of a piece of wall, from and to along it and in height, its inner face flush with the room."""
    thick = PANE_THICKNESS if pane else WALL_THICKNESS
    centre = np.array([(x[0] + x[1]) / 2, -thick / 2, (z[0] + z[1]) / 2])
    return Slab(centre, np.array([(x[1] - x[0]) / 2, thick / 2, (z[1] - z[0]) / 2]), pane)


def wall_ends(room: Room, wall: int) -> tuple[float, float]:
    """Where the slab of a wall begins and ends [m] along the wall, from its first corner.

    At a convex corner it goes on, so that no slit is left outside; at a reflex one that would stand in the room. Where
    a door of the next wall is in that corner, the slab leaves its doorway free.
    """
    walls = room.walls
    one, following = walls[wall], walls[(wall + 1) % len(walls)]
    length, before = one.length, walls[wall - 1].length
    first, last = cross(walls[wall - 1].along, one.along), cross(one.along, following.along)  # sines of the turns
    near = [d.offset + d.width > before - _NEAR for d in room.doors if walls[d.wall] is walls[wall - 1]]
    next_ = [d.offset < _NEAR for d in room.doors if d.wall == following.index]
    return -_over(first, any(near)), length + _over(last, any(next_))


def _over(turn: float, doorway: bool) -> float:
    """How far a slab goes on beyond a corner with this sine of its turn [m]; less than 0: it ends before."""
    if turn > 0:
        return 0.0 if doorway else WALL_THICKNESS
    return -WALL_THICKNESS / max(-turn, 0.25) if doorway and turn < -1e-6 else 0.0
