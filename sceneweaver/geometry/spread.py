"""Places spread evenly over a floor, in rows along its walls: where the lamps of a ceiling hang."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

from .walls import Point

FILLED = 0.5
"""Share of a cell of the grid that must be floor for a place to be in it."""

EMPTY = 1.25
"""What a cell of the grid that stays empty counts as; one for a cell that is e times as long as wide."""

NEAR = 0.18
"""What each place more or fewer than wanted counts as, in the same measure."""


def even_places(outline: Sequence[Point], count: int) -> tuple[Point, ...]:
    """``count`` places [m] on a floor: the middles of the cells of a grid along its first wall, whose cells are as
    nearly square as can be; of a cell that is partly outside, the middle of what is floor. A single place is the middle
    of the floor.

    Args:
        outline: corners of the floor in order.
        count: at least 1.

    Returns:
        The places, row after row.
    """
    return _grid(tuple((float(x), float(y)) for x, y in outline), count)[1]


def even_count(outline: Sequence[Point], wanted: int) -> int:
    """The number of places near a wanted one that makes the most regular grid: six rather than five or seven."""
    corners = tuple((float(x), float(y)) for x, y in outline)
    span = range(max(1, wanted - 1), wanted + 3) if wanted > 2 else (wanted,)
    return min(span, key=lambda n: (_grid(corners, n)[0] + NEAR * abs(n - wanted), n))


@lru_cache(maxsize=512)
def _grid(outline: tuple[Point, ...], count: int) -> tuple[float, tuple[Point, ...]]:
    """How irregular the grid is, and its places."""
    import shapely
    from shapely import affinity

    floor = shapely.Polygon(outline)
    (ax, ay), (bx, by) = outline[0], outline[1]
    turned = math.atan2(by - ay, bx - ax)
    level = affinity.rotate(floor, -turned, origin=(0.0, 0.0), use_radians=True)
    least, cells = math.inf, [level]
    x0, y0, x1, y1 = level.bounds
    for columns in range(1, 2 * count + 1 if count > 1 else 1):
        for rows in range(math.ceil(count / columns), 2 * count // columns + 1):
            dx, dy = (x1 - x0) / columns, (y1 - y0) / rows
            boxes = [
                shapely.box(x0 + i * dx, y0 + j * dy, x0 + (i + 1) * dx, y0 + (j + 1) * dy)
                for j in range(rows)
                for i in range(columns)
            ]
            kept = [c for c in shapely.intersection(boxes, level) if c.area >= FILLED * dx * dy]
            score = abs(math.log(dx / dy)) + EMPTY * (len(kept) - count)
            if len(kept) >= count and score < least - 1e-9:
                least, cells = score, kept[:count]
    middles = [c.centroid if c.contains(c.centroid) else c.representative_point() for c in cells]
    c, s = math.cos(turned), math.sin(turned)
    return least, tuple((m.x * c - m.y * s, m.x * s + m.y * c) for m in middles)
