"""Ways to part an envelope into bays: rectangles of clear floor, each of which a slicing tree cuts, and stairwells.

An envelope that is no rectangle is cut at its inward corners, in every way. The longer side of such a cut lies on the
face of the outer wall, the other gives way by the thickness of an inner wall. In a plan of several storeys a stairwell
stands at the same place on each; what is left of its rectangle is cut into bays around it.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

from shapely.geometry import LineString, MultiLineString, Point, Polygon, box
from shapely.ops import split

from .envelope import Envelope
from .solve_stairs import Stairwell

Rect = tuple[int, int, int, int]
"""x0, y0, x1, y1 in mm."""

MAX_FRAMES = 96
STEP = 450
"""How far [mm] the places of a stairwell are apart."""
LEAST_BAY = 1300
"""Least side [mm] of a bay beside a stairwell."""


@dataclass(frozen=True)
class Fixed:
    """A part of a stairwell: its rectangle, and whether doors may be in its walls."""

    rect: Rect
    doors: bool


@dataclass(frozen=True)
class Frame:
    """Bays of each storey, the parts of the stairwell, and how stairs lie in it.

    Attributes:
        bays: rectangles of clear floor, by storey.
        fixed: the landing and the flights of the stairwell; empty without stairs.
        up: direction of the first flight; (0, 0) without stairs.
    """

    bays: tuple[tuple[Rect, ...], ...]
    fixed: tuple[Fixed, ...] = ()
    up: tuple[int, int] = (0, 0)


def millimetres(points: tuple[tuple[float, float], ...]) -> list[tuple[int, int]]:
    """Corners in whole mm."""
    return [(round(1000 * x), round(1000 * y)) for x, y in points]


def frames_of(envelope: Envelope, stairwell: Stairwell | None) -> list[Frame]:
    """Frames of an envelope, those with few bays first, in a fixed order; at most `MAX_FRAMES`.

    Empty where the stairwell finds no place.
    """
    wall = round(1000 * envelope.inner_wall)
    parts = _partitions(Polygon(millimetres(envelope.inner)), wall)
    if stairwell is None:
        return [Frame((rects,)) for rects in parts]
    frames = [f for rects in parts for f in _with_stairwell(rects, stairwell, wall, envelope.storeys)]
    # each bay takes a room at least, and few rooms to a bay leave little choice
    frames.sort(key=lambda frame: sum(map(len, frame.bays)))
    kept = frames[:MAX_FRAMES]
    return sorted(kept, key=lambda frame: tuple(map(len, frame.bays)))


def _partitions(polygon: Polygon, wall: int) -> list[tuple[Rect, ...]]:
    """Ways to cut a rectilinear polygon into rectangles, from each of its inward corners on."""
    if polygon.area == polygon.envelope.area:
        return [_rect(polygon)]
    found: dict[tuple[Rect, ...], None] = {}
    points = [(round(x), round(y)) for x, y in polygon.exterior.coords[:-1]]
    for i, corner in enumerate(points):
        before, after = points[i - 1], points[(i + 1) % len(points)]
        cross = (corner[0] - before[0]) * (after[1] - corner[1]) - (corner[1] - before[1]) * (after[0] - corner[0])
        turn = cross if polygon.exterior.is_ccw else -cross
        if turn >= 0:
            continue
        for a, b in ((before, corner), (after, corner)):
            for pieces in _cut_on(polygon, a, b, wall):
                found.setdefault(pieces)
        break  # every way to cut comes about by one corner after the other
    return list(found)


def _cut_on(polygon: Polygon, a: tuple[int, int], b: tuple[int, int], wall: int) -> list[tuple[Rect, ...]]:
    """Cut along the wall from a to b, extended over b."""
    far = 10**6
    dx, dy = (b[0] > a[0]) - (b[0] < a[0]), (b[1] > a[1]) - (b[1] < a[1])
    crossed = LineString([b, (b[0] + dx * far, b[1] + dy * far)]).intersection(polygon)
    parts = crossed.geoms if isinstance(crossed, MultiLineString) else [crossed]
    line = min(parts, key=lambda part: part.distance(Point(b)))
    if not isinstance(line, LineString) or line.length == 0:
        return []
    pieces = [piece for piece in split(polygon, line).geoms if isinstance(piece, Polygon)]
    if len(pieces) != 2:
        return []
    normal = (-dy, dx)
    found: list[tuple[Rect, ...]] = []
    lengths = [p.boundary.intersection(_long(line, dx, dy, far)).length for p in pieces]
    for k, piece in enumerate(pieces):
        # the piece that ends where the cut does gives way to the wall
        if lengths[k] > line.length + 0.5:
            continue
        side = piece.representative_point()
        mid = line.interpolate(0.5, normalized=True)
        sign = 1 if (side.x - mid.x) * normal[0] + (side.y - mid.y) * normal[1] > 0 else -1
        (x0, y0), (x1, y1) = line.coords[0], line.coords[-1]
        shift = (sign * normal[0] * wall, sign * normal[1] * wall)
        strip = box(
            min(x0, x1, x0 + shift[0]),
            min(y0, y1, y0 + shift[1]),
            max(x0, x1, x0 + shift[0]),
            max(y0, y1, y0 + shift[1]),
        )
        smaller = piece.difference(strip)
        other = pieces[1 - k]
        if not isinstance(smaller, Polygon) or smaller.area <= 0:
            continue
        for first in _partitions(_clean(smaller), wall):
            found.extend((*first, *second) for second in _partitions(_clean(other), wall))
        break
    return found


def _long(line: LineString, dx: int, dy: int, far: int) -> LineString:
    x, y = line.coords[0]
    return LineString([(x - dx * far, y - dy * far), (x + dx * far, y + dy * far)])


def _clean(polygon: Polygon) -> Polygon:
    """Without corners on straight walls."""
    simple = polygon.simplify(0)
    assert isinstance(simple, Polygon)
    return simple


def _rect(polygon: Polygon) -> tuple[Rect, ...]:
    x0, y0, x1, y1 = polygon.bounds
    return ((round(x0), round(y0), round(x1), round(y1)),)


def _with_stairwell(rects: tuple[Rect, ...], stairwell: Stairwell, wall: int, storeys: int) -> list[Frame]:
    """Frames with the stairwell in one of the rectangles, lengthwise or across, near every wall and in between.

    What is left of that rectangle is cut one way or the other, in each storey by itself.
    """
    found: list[Frame] = []
    for k, host in enumerate(rects):
        rest = rects[:k] + rects[k + 1 :]
        for lengthwise in (False, True):
            size = (stairwell.length, stairwell.width) if lengthwise else (stairwell.width, stairwell.length)
            for x in _places(host[0], host[2], size[0], wall):
                for y in _places(host[1], host[3], size[1], wall):
                    shaft = (x, y, x + size[0], y + size[1])
                    axis = 0 if lengthwise else 1
                    around = [_around(host, shaft, wall, strips) for strips in (False, True)]
                    ways = list(dict.fromkeys(rest + bays for bays in around if bays is not None))
                    for sign in (1, -1):
                        parts = tuple(Fixed(rect, doors) for rect, doors in stairwell.parts(shaft, axis, sign))
                        up = (sign, 0) if axis == 0 else (0, sign)
                        found += [Frame(bays, parts, up) for bays in product(ways, repeat=storeys)]
    return found


def _places(low: int, high: int, size: int, wall: int) -> list[int]:
    """Where a side of so many mm may begin between two walls: flush with either, or a bay away from both."""
    spare = high - low - size
    if spare < 0:
        return []
    if spare == 0:
        return [low]
    first, last = low + LEAST_BAY + wall, high - size - LEAST_BAY - wall
    places = [low, high - size] if spare >= LEAST_BAY + wall else []
    if first <= last:
        count = (last - first) // STEP
        places += [first + k * (last - first) // max(count, 1) for k in range(count + 1)]
    return sorted(set(places))


def _around(host: Rect, shaft: Rect, wall: int, strips: bool) -> tuple[Rect, ...] | None:
    """Bays around a shaft: the whole length of the host to its left and right (``strips``), or below and above."""
    axis = 0 if strips else 1
    low, high = list(host), list(host)
    low[axis + 2] = shaft[axis] - wall
    high[axis] = shaft[axis + 2] + wall
    middle = list(host)
    middle[axis], middle[axis + 2] = shaft[axis], shaft[axis + 2]
    other = 1 - axis
    before, behind = list(middle), list(middle)
    before[other + 2] = shaft[other] - wall
    behind[other] = shaft[other + 2] + wall
    bays = [tuple(b) for b in (low, high, before, behind) if b[2] > b[0] and b[3] > b[1]]
    if any(min(b[2] - b[0], b[3] - b[1]) < LEAST_BAY for b in bays):
        return None
    return tuple(bays)  # pyright: ignore[reportReturnType]
