"""Free stretches of walls, and what is in the way there: rectangles along a wall and in height."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

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
    for obj in objects:
        along, deep = extent(obj, wall)
        hung = obj.mount == "wall" and wall_behind(room.walls, obj.pose.position, obj.pose.frame.axis) == wall.index
        tall = obj.mount == "floor" and obj.size[2] >= TALL
        if (hung or tall) and deep[0] <= CLOSE and deep[1] > 0.0 and along[1] > 0.0 and along[0] < wall.length:
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
    corners = [wall.coordinates(obj.pose.frame.world(x, y)) for x, y in ((d, w), (d, -w), (-d, -w), (-d, w))]
    along, deep = zip(*corners, strict=True)
    return (min(along), max(along)), (min(deep), max(deep))


def obstacles(room: Room, objects: Iterable[SceneObject], wall: Wall, depth: float) -> list[Rectangle]:
    """What is in the way of something of that depth [m] on a wall: things, what they need free, doors and windows."""
    found = [Rectangle((o.offset, o.offset + o.width), heights(o)) for o in room.openings_of(wall.index)]
    for opening in room.openings:
        if opening.wall != wall.index:
            corners = [wall.coordinates(corner) for corner in clear_zone(opening, room.walls)]
            found += _before(corners, (0.0, heights(opening)[1]), depth + LEAF)
    for obj in objects:
        z = obj.pose.position[2]
        for polygon, low, high in _parts(obj):
            corners = [wall.coordinates(obj.pose.frame.world(*corner)) for corner in polygon]
            found += _before(corners, (z + low, z + high), depth + MARGIN / 2)
            if obj.mount == "floor" and PASSED[0] <= min(v for _, v in corners):
                near = _before(corners, (0.0, UNDER), sum(PASSED) + depth)
                found += [Rectangle((r.along[0] - AROUND, r.along[1] + AROUND), r.high) for r in near]
        for zone in obj.zones or ():
            if zone.hard:
                corners = [wall.coordinates(obj.pose.frame.world(*corner)) for corner in zone.polygon]
                found += _before(corners, (z + zone.z[0], z + zone.z[1]), depth)
    return found


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
