"""Free stretches of walls, and what is in the way there: rectangles along a wall and in height."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.geometry.polygons import rectangle
from sceneweaver.geometry.shell import clear_zone, heights
from sceneweaver.geometry.walls import Wall, wall_behind
from sceneweaver.scene import Room, SceneObject

TALL = 1.2
"""Height [m] from which furniture covers the wall behind it."""

CLOSE = 0.35
"""Gap [m] to a wall up to which furniture stands before it."""

CORNER, FRAME, HUNG, BESIDE = 0.3, 0.2, 0.2, 0.1
"""Wall [m] that stays free beside a corner, a door or window, what hangs there already, and tall furniture."""

LEAF = 0.06
"""Gap [m] between a thing on a wall and the leaf of a door that opens beside it."""

MARGIN = 0.04
"""Gap [m] between things on a wall and what is before it."""

PASSED, AROUND, UNDER = (0.4, 0.12), 0.3, 1.8
"""Width [m] of the least way between a wall and furniture, how much more it has to be beside a thing on that wall; how
far before and after the furniture; and the height [m] from which such a thing does not narrow it."""

Span = tuple[float, float]


class Rectangle(NamedTuple):
    """Along a wall and in height [m]."""

    along: Span
    high: Span

    def meets(self, other: Rectangle) -> bool:
        """Whether two have a point in common, with a margin."""
        return all(a[0] < b[1] + MARGIN and b[0] < a[1] + MARGIN for a, b in zip(self, other, strict=True))


def free_runs(room: Room, objects: Iterable[SceneObject], wall: Wall, least: float) -> list[Span]:
    """Stretches [m] of a wall of which ``least`` [m] or more is bare, less what stays free at their ends."""
    taken: list[tuple[float, float, float]] = [(0.0, 0.0, CORNER), (wall.length, wall.length, CORNER)]
    taken += [(o.offset, o.offset + o.width, FRAME) for o in room.openings_of(wall.index)]
    walls = room.walls
    for obj in objects:
        hung = obj.mount == "wall" and wall_behind(walls, obj.pose.position, obj.pose.frame.axis) == wall.index
        tall = obj.mount == "floor" and obj.size[2] >= TALL
        if not (hung or tall):
            continue
        along, deep = extent(obj, wall)
        if deep[0] <= CLOSE and deep[1] > 0.0 and along[1] > 0.0 and along[0] < wall.length:
            taken.append((*along, HUNG if hung else BESIDE))
    runs: list[Span] = []
    at, gap = 0.0, CORNER
    for start, end, beside in sorted(taken):
        if start - at >= least:
            runs.append((at + gap, start - beside))
        if end >= at:
            at, gap = end, beside
    return runs


def extent(obj: SceneObject, wall: Wall) -> tuple[Span, Span]:
    """From and to of a thing along a wall and away from it [m]."""
    d, w = obj.size[0] / 2, obj.size[1] / 2
    frame = obj.pose.frame
    corners = [wall.coordinates(frame.world(x, y)) for x, y in ((d, w), (d, -w), (-d, -w), (-d, w))]
    along, deep = zip(*corners, strict=True)
    return (min(along), max(along)), (min(deep), max(deep))


class Outlines:
    """The parts and hard zones of some objects from above, read once for all walls."""

    def __init__(self, objects: Iterable[SceneObject]) -> None:
        """``objects`` in any order; `add` takes more."""
        self._rings: list[Any] = []
        self._rows: list[tuple[float, float, float, bool]] = []  # low, high, margin [m], whether one passes before it
        for obj in objects:
            self.add(obj)

    def add(self, obj: SceneObject) -> None:
        """Take one more object."""
        z, frame, stands = obj.pose.position[2], obj.pose.frame, obj.mount == "floor"
        found = [(ring, low, high, MARGIN / 2, stands) for ring, low, high in _parts(obj)]
        found += [(zone.polygon, *zone.z, 0.0, False) for zone in obj.zones if zone.hard]
        for ring, low, high, margin, passed in found:
            u, v = np.array(ring, dtype=float).T
            self._rings.append(np.stack(frame.world(u, v)))
            self._rows.append((z + low, z + high, margin, passed))

    def before(self, wall: Wall, depth: float) -> list[Rectangle]:
        """Those in the way of something of that depth [m] on a wall, with the ways that have to stay."""
        if not self._rings:
            return []
        starts = np.cumsum([0, *(ring.shape[1] for ring in self._rings[:-1])])
        along, deep = wall.coordinates(np.concatenate(self._rings, axis=1))
        ends = np.stack([np.minimum.reduceat(along, starts), np.maximum.reduceat(along, starts)], axis=1).tolist()
        nearest, farthest = np.minimum.reduceat(deep, starts), np.maximum.reduceat(deep, starts)
        margins = np.array([margin for _, _, margin, _ in self._rows])
        passed = np.array([passed for *_, passed in self._rows]) & (nearest >= PASSED[0])
        inside = farthest > 0.0
        met = inside & (nearest < depth + margins)
        narrowed = inside & passed & (nearest < sum(PASSED) + depth)
        found = [Rectangle((ends[k][0], ends[k][1]), self._rows[k][:2]) for k in np.flatnonzero(met)]
        return found + [
            Rectangle((ends[k][0] - AROUND, ends[k][1] + AROUND), (0.0, UNDER)) for k in np.flatnonzero(narrowed)
        ]


def obstacles(room: Room, outlines: Outlines, wall: Wall, depth: float) -> list[Rectangle]:
    """What is in the way of something of that depth [m] on a wall: things, what they need free, doors and windows."""
    found = [Rectangle((o.offset, o.offset + o.width), heights(o)) for o in room.openings_of(wall.index)]
    walls = room.walls
    for opening in room.openings:
        if opening.wall != wall.index:
            corners = [wall.coordinates(corner) for corner in clear_zone(opening, walls)]
            found += _before(corners, (0.0, heights(opening)[1]), depth + LEAF)
    return found + outlines.before(wall, depth)


def _parts(obj: SceneObject) -> Iterator[tuple[Sequence[Sequence[float]], float, float]]:
    """The outlines of a thing's parts in its frame, with their heights [m]: of its box where it has none."""
    for part in obj.parts or ():
        yield part.polygon, part.z[0], part.z[1]
    if not obj.parts:
        yield rectangle(obj.size[0], obj.size[1]), 0.0, obj.size[2]


def _before(corners: list[Span], high: Span, depth: float) -> Iterator[Rectangle]:
    """The rectangle of a polygon in a wall's coordinates, if it comes as near to the wall as a depth [m]."""
    along, deep = zip(*corners, strict=True)
    if min(deep) < depth and max(deep) > 0.0:
        yield Rectangle((min(along), max(along)), high)
