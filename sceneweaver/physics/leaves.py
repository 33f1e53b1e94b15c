"""The moving leaves of a room's doors, as boxes on a hinge or a slide; at 0 they are closed.

Left and right are those of somebody who comes in: an ``in-left`` leaf hangs at the door's offset, an ``in-right``
leaf at its other end, an ``out`` leaf at its offset again. A leaf that swings stands in the opening, flush with the
wall's face on the side to which it opens, and its axis is in that face: so it clears the wall at every angle. A leaf
that slides hangs before the outer face of the wall, where no furniture is, and goes to the side that has more room.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Literal

import numpy as np

from sceneweaver.assets import Grasp
from sceneweaver.geometry.polygons import rectangle, union
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Door, Room

from .inertia import Inertia, inertia_of, shares_of
from .shell import wall_ends
from .solids import Solid
from .things import Joint

THICK = 0.04
"""Thickness of a leaf [m]."""

Vector = tuple[float, float, float]
Box = tuple[Vector, Vector]
"""Centre [3] and half extents [3] in the leaf's frame [m]."""

_FOOT = 0.005  # [m] between leaf and floor
_GAP = 0.003  # [m] between leaf and jambs, where nothing asks for more
_OPEN = math.pi / 2  # [rad]; farther, the leaf would leave the door's zone
_OUT = 0.055  # [m] by which a handle stands out of the leaf; with the leaf it stays within the wall's thickness
_PER_AREA = 12.0  # [kg/m2] of a leaf: a hollow wooden one
_STEP = 0.01  # [m] or [rad] between the positions that are looked at for a wall in the way


@dataclass(frozen=True)
class Leaf:
    """A door leaf.

    Its frame: origin ``position`` (world [m], at the floor) on the hinge's axis, for a slide at the leaf's first end;
    +x along the closed leaf, z up, turned by ``yaw`` [rad] in the world. ``axis`` is a unit vector of that frame,
    ``limits`` are (closed, open) in radians or metres, ``full`` is how far it would open if no wall were in its way;
    ``mass`` [kg]. ``boxes``: the leaf, then its handles. ``grasps`` are those of its handles, one on each side.
    """

    door: str
    name: str
    position: Vector
    yaw: float
    joint: Literal["hinge", "slide"]
    axis: Vector
    limits: tuple[float, float]
    mass: float
    boxes: tuple[Box, ...]
    grasps: tuple[Grasp, ...]
    full: float = _OPEN

    @property
    def hold(self) -> float:
        """Friction and damping [N m] or [N] that keep it where it is, about 1 and 6; a pull at the handle is more."""
        return (0.05 if self.joint == "hinge" else 0.3) * self.mass

    @property
    def moves(self) -> Joint:
        """How it moves, in its frame."""
        return Joint(self.joint, np.asarray(self.axis), np.zeros(3), self.limits, self.hold)

    @property
    def solids(self) -> list[Solid]:
        """Its boxes as parts."""
        boxes = [(np.asarray(centre), np.asarray(half)) for centre, half in self.boxes]
        return [Solid(np.stack([c - h, c + h]), float(8 * np.prod(h)), box=(c, h)) for c, h in boxes]

    @property
    def inertia(self) -> Inertia:
        """In its frame, the mass spread over the boxes by volume."""
        solids = self.solids
        return inertia_of(solids, shares_of(solids, self.mass))

    @property
    def stuck(self) -> bool:
        """Whether a wall is in its way from the start, as in an acute corner; it can as good as not be opened."""
        return self.limits[1] <= _STEP


def leaves(room: Room) -> list[Leaf]:
    """One leaf for each door, in their order."""
    return list(_leaves(room.outline, room.doors))


@lru_cache(maxsize=64)
def _leaves(outline: tuple[tuple[float, float], ...], doors: tuple[Door, ...]) -> tuple[Leaf, ...]:
    """The leaves of some doors; a scene is measured and written many times with one room."""
    room = Room.model_construct(outline=outline, doors=doors)
    return tuple(_sliding(room, door) if door.swing == "slide" else _swinging(room, door) for door in doors)


def _swinging(room: Room, door: Door) -> Leaf:
    out, wall = door.swing == "out", room.walls[door.wall]
    span, names = (door.offset, door.width), (door.id, f"room:door:{door.id}")
    leaf = swinging(
        wall, span, door.height, names, -WALL_THICKNESS if out else 0.0, out=out, far=door.swing == "in-right"
    )
    return limited(leaf, _walls(room))


def swinging(
    wall: Wall,
    span: tuple[float, float],
    height: float,
    names: tuple[str, str],
    face: float,
    *,
    out: bool = False,
    far: bool = False,
) -> Leaf:
    """A leaf on a hinge, which opens by a right angle.

    Args:
        wall: In which it is.
        span: Where it begins along the wall, and how wide the opening is for it [m].
        height: Of the opening [m].
        names: Id of the door, and name of the leaf.
        face: Depth [m] of the wall's face on the side to which it opens: 0, or less.
        out: Whether it opens out of the wall's room.
        far: Whether it hangs at the end of the span.
    """
    offset, wide = span
    # At its far end the leaf's outer edge is farther from the axis than the leaf is wide.
    gap = min(_GAP + THICK**2 / (2 * wide), wide / 8)
    width, top = wide - 2 * gap, max(height - _GAP, 2 * _FOOT)
    turn = wall.yaw + (math.pi if far else 0.0)
    x, y = wall.point(offset + wide - gap if far else offset + gap, face)
    # +y of the leaf's frame is into the room at its offset and out of it at the other end.
    opens = -1.0 if out != far else 1.0
    body = ((width / 2, -opens * THICK / 2, (_FOOT + top) / 2), (width / 2, THICK / 2, (top - _FOOT) / 2))
    long, high = min(0.12, 0.3 * width), min(1.02, 0.55 * top)
    end = width - min(0.05, 0.1 * width)
    boxes: list[Box] = [body]
    grasps: list[Grasp] = []
    for surface, side in ((0.0, opens), (-opens * THICK, -opens)):
        neck = surface + side * (_OUT - 0.015) / 2
        boxes.append(((end - 0.01, neck, high), (0.01, (_OUT - 0.015) / 2, 0.01)))
        lever = (end - long / 2, surface + side * (_OUT - 0.0075), high)
        boxes.append((lever, (long / 2, 0.0075, 0.01)))
        name = "inside" if side * math.cos(turn - wall.yaw) > 0 else "outside"
        grasps.append(Grasp(name, 0, lever, (0.0, -side, 0.0), (0.0, 0.0, 1.0), 0.02, long))
    return Leaf(
        *names,
        (x, y, 0.0),
        turn,
        "hinge",
        (0.0, 0.0, opens),
        (0.0, _OPEN),
        _PER_AREA * width * top,
        tuple(boxes),
        tuple(grasps),
    )


def _sliding(room: Room, door: Door) -> Leaf:
    walls = _walls(room)
    wall, span, names = room.walls[door.wall], (door.offset, door.width), (door.id, f"room:door:{door.id}")
    before = (-WALL_THICKNESS, -0.01 - THICK / 2)
    # The leaf covers the opening and a little more where no other wall begins.
    plans = [
        sliding(wall, span, door.height, names, before, over, far=far)
        for over in (0.03, 0.0, -0.01)
        for far in (False, True)
    ]
    clear = [leaf for leaf in plans if not _hits(leaf, [0.0], walls)[0]] or plans[-2:]
    ways = [(_way(leaf, walls, leaf.limits[1]), leaf) for leaf in clear[:2]]
    travel, best = max(ways, key=lambda pair: pair[0])
    return _limited(best, travel)


def sliding(
    wall: Wall,
    span: tuple[float, float],
    height: float,
    names: tuple[str, str],
    depths: tuple[float, float],
    over: float,
    *,
    far: bool = False,
) -> Leaf:
    """A leaf that slides along a wall, away from its start, or with ``far`` back towards it.

    Args:
        wall, span, height, names: As for `swinging`.
        depths: Of the leaf's frame in the wall, and from there on of the middle of the leaf [m]: 0, or less.
        over: By how much it is wider than the opening at each end [m].
        far: Whether it slides back.
    """
    offset, wide = span
    width, top = wide + 2 * over, height + max(over, -0.002)
    turn = wall.yaw + (math.pi if far else 0.0)
    x, y = wall.point(offset + (wide + over if far else -over), depths[0])
    middle = -depths[1] if far else depths[1]
    at = over + min(0.06, 0.15 * wide)  # of the handle, near the end that is left when it opens
    tall, high = min(0.15, 0.3 * top), min(1.05, 0.55 * top)
    boxes: list[Box] = [((width / 2, middle, (_FOOT + top) / 2), (width / 2, THICK / 2, (top - _FOOT) / 2))]
    grasps = []
    for side in (1.0, -1.0):
        boxes.append(((at, middle + side * (THICK + 0.045) / 2, high), (0.01, 0.0225, tall)))
        name = "inside" if side * math.cos(turn - wall.yaw) > 0 else "outside"
        place = (at, middle + side * (THICK / 2 + 0.03), high)
        grasps.append(Grasp(name, 0, place, (0.0, -side, 0.0), (1.0, 0.0, 0.0), 0.02, 2 * tall))
    # Open, the handle in the opening stands just before the jamb.
    travel = max(over + wide - 0.015 - (at + 0.01), _STEP)
    return Leaf(
        *names,
        (x, y, 0.0),
        turn,
        "slide",
        (1.0, 0.0, 0.0),
        (0.0, travel),
        _PER_AREA * width * top,
        tuple(boxes),
        tuple(grasps),
        travel,
    )


def limited(leaf: Leaf, walls: Any) -> Leaf:
    """The leaf, opening as far as no wall is in its way; ``walls`` is a plan of them less the doorways."""
    return _limited(leaf, _way(leaf, walls, leaf.limits[1]))


def _limited(leaf: Leaf, most: float) -> Leaf:
    return replace(leaf, limits=(0.0, round(max(most, _STEP), 4)))


def _way(leaf: Leaf, walls: Any, most: float) -> float:
    """How far it opens before it meets a wall, ``most`` at most, in steps."""
    count = math.ceil(most / _STEP)
    hits = np.flatnonzero(_hits(leaf, [most * k / count for k in range(1, count + 1)], walls))
    # One step back from the last that was free.
    return most * max(int(hits[0]) - 1, 0) / count if len(hits) else most


def _hits(leaf: Leaf, positions: Sequence[float], walls: Any) -> Any:
    """Whether the leaf, opened by each of some positions, and a wall share a plan: bool [positions]."""
    import shapely

    slides = leaf.joint == "slide"
    x, y = leaf.position[:2]
    frames = [SE2(x, y, leaf.yaw + (0.0 if slides else at * leaf.axis[2])).axis for at in positions]
    c, s = np.array(frames).T[:, :, None, None]
    slid = np.asarray(positions)[:, None, None] if slides else 0.0
    corners = np.array([rectangle(2 * hx, 2 * hy) for _, (hx, hy, _) in leaf.boxes])
    u, v = np.array([(bx, by) for (bx, by, _), _ in leaf.boxes]).T[:, :, None] + corners.transpose(2, 0, 1)
    u = u + slid
    plans: Any = shapely.polygons(np.stack([x + c * u - s * v, y + s * u + c * v], axis=-1))
    near = shapely.intersects(walls, plans)
    shared = np.zeros(plans.shape)
    shared[near] = shapely.area(shapely.intersection(plans[near], walls))
    return (shared > 1e-7).any(axis=1)


def _walls(room: Room) -> Any:
    """The walls from above, less their doorways, as one plan, prepared for many questions."""
    import shapely
    from shapely import Polygon

    def strip(wall: Wall, low: float, high: float) -> Any:
        return Polygon(wall.strip(low, high - low, -WALL_THICKNESS, 0.0))

    slabs: list[Any] = [strip(wall, *wall_ends(room, wall.index)) for wall in room.walls]
    for door in room.doors:
        doorway = strip(room.walls[door.wall], door.offset, door.offset + door.width)
        slabs[door.wall] = slabs[door.wall].difference(doorway)
    made = union(slabs)
    shapely.prepare(made)
    return made
