"""Where walls have room for another opening: to the outside, or to another room."""

from __future__ import annotations

from collections.abc import Iterator

import shapely

from sceneweaver.geometry.walls import Wall
from sceneweaver.home import Home, HomeRoom, place_in
from sceneweaver.home.shells import FACING

BEFORE = 1.0
"""What a window has before the outer wall [m], without a room in it."""

CORNER = 0.1
"""Distance [m] of a new opening from the ends of its wall and from other openings."""

Span = tuple[float, float]


def outer_spans(home: Home, room: HomeRoom) -> Iterator[tuple[Wall, Span]]:
    """The parts [m] of a room's walls that look outdoors and have no opening, longest first."""
    others = [
        shapely.Polygon(r.outline) for r in home.rooms if r.storey == room.storey and r.id != room.id and not r.outdoor
    ]
    rest = shapely.union_all([*others, shapely.Polygon(room.outline)])
    found: list[tuple[Wall, Span]] = []
    for wall in room.walls:
        strip = shapely.Polygon(wall.strip(0.0, wall.length, -(home.walls.outer + BEFORE), -1e-3))
        taken = [_extent(wall, part) for part in shapely.get_parts(strip.intersection(rest)) if part.area > 1e-6]
        found += [(wall, span) for span in _free(wall, [*taken, *openings_of(home, room, wall)])]
    return iter(sorted(found, key=lambda f: f[1][0] - f[1][1]))


def shared_spans(home: Home, room: HomeRoom, other: HomeRoom) -> list[tuple[Wall, Span]]:
    """The parts [m] of a room's walls behind which another room lies and neither has an opening, longest first."""
    found: list[tuple[Wall, Span]] = []
    for wall in room.walls:
        for back in other.walls:
            if wall.along[0] * back.along[0] + wall.along[1] * back.along[1] > FACING:
                continue
            (a, depth), (b, _) = wall.coordinates(back.end), wall.coordinates(back.start)
            low, high = max(0.0, min(a, b)), min(wall.length, max(a, b))
            if high - low < 0.5 or not -0.5 <= depth <= 1e-6 or _crossed(home, room, other, wall, low, high, depth):
                continue
            taken = openings_of(home, room, wall)
            for p, q in openings_of(home, other, back):
                ends = [wall.coordinates(back.point(t))[0] for t in (p, q)]
                taken.append((min(ends), max(ends)))
            outside = [(-1.0, low), (high, wall.length + 1.0)]
            found += [(wall, span) for span in _free(wall, [*taken, *outside])]
    return sorted(found, key=lambda f: f[1][0] - f[1][1])


def _crossed(home: Home, room: HomeRoom, other: HomeRoom, wall: Wall, low: float, high: float, depth: float) -> bool:
    if depth > -1e-3:
        return False
    strip = shapely.Polygon(wall.strip(low, high - low, depth + 1e-4, -1e-4))
    return any(
        strip.intersection(shapely.Polygon(r.outline)).area > 1e-4
        for r in home.rooms
        if r.storey == room.storey and r.id not in (room.id, other.id)
    )


def openings_of(home: Home, room: HomeRoom, wall: Wall) -> list[Span]:
    """What of a wall its openings take [m]."""
    spans = [(w.offset, w.offset + w.width) for w in home.windows if w.room == room.id and w.wall == wall.index]
    for door in home.doors_of(room.id):
        number, offset = place_in(home, door, room.id)
        if number == wall.index:
            spans.append((offset, offset + door.width))
    return spans


def _extent(wall: Wall, part: shapely.Geometry) -> Span:
    along = [wall.coordinates(p)[0] for p in shapely.get_coordinates(part)]
    return min(along), max(along)


def _free(wall: Wall, taken: list[Span]) -> list[Span]:
    spans, at = [], CORNER
    for low, high in sorted(taken):
        if low - CORNER > at:
            spans.append((at, low - CORNER))
        at = max(at, high + CORNER)
    if wall.length - CORNER > at:
        spans.append((at, wall.length - CORNER))
    return spans
