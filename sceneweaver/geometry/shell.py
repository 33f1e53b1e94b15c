"""The shell around a room: how thick it is, how its walls meet at the corners, what is left of them by openings.

The engine and the judge know only the inner faces of walls, which are the outline; exports, physics and pictures build
the shell outside of it with the same numbers.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol

from .walls import Point, Quad, Wall

WALL_THICKNESS = 0.1
"""Thickness of the walls [m], outside the outline."""

FLOOR_THICKNESS = 0.05
"""Thickness of the floor slab [m], under z = 0."""

PANE_THICKNESS = 0.01
"""Thickness of what closes a window for things that fall or are thrown [m]."""

DOOR_CLEARANCE = 0.6
"""Depth [m] to keep free before a door that slides or opens outward; one that swings in needs its own width."""

WINDOW_CLEARANCE = 0.3
"""Depth [m] to keep free before a window, from its sill to its upper edge."""

LONGEST_MITRE = 4.0
"""Greatest distance of an outer corner from its inner one, in wall thicknesses; sharper corners are cut straight."""

_LEAST = 1e-6
"""Length or height [m] of a wall's piece that is none."""

Span = tuple[float, float]


class Opening(Protocol):
    """A door or window in wall ``wall``, ``width`` metres wide from ``offset`` metres after its first corner."""

    @property
    def wall(self) -> int: ...  # noqa: D102 - said above
    @property
    def offset(self) -> float: ...  # noqa: D102
    @property
    def width(self) -> float: ...  # noqa: D102
    @property
    def height(self) -> float: ...  # noqa: D102


def heights(opening: Opening) -> Span:
    """Lower and upper end of a door or window [m]: what has a sill begins there."""
    sill = float(getattr(opening, "sill", 0.0))
    return sill, sill + opening.height


def clearance(opening: Opening) -> float:
    """Depth [m] of the floor that a door or window needs free."""
    swing = getattr(opening, "swing", None)
    if swing is None:
        return WINDOW_CLEARANCE
    return opening.width if swing.startswith("in") else DOOR_CLEARANCE


def clear_zone(opening: Opening, walls: Sequence[Wall]) -> Quad:
    """The floor that a door or window needs free, counter-clockwise from its first end at the wall."""
    return walls[opening.wall].strip(opening.offset, opening.width, 0.0, clearance(opening))


def outer_corner(before: Wall, after: Wall) -> Point | None:
    """Where the outer faces of two walls meet that share a corner [m]; None where that is too far away."""
    (ax, ay), (bx, by), (x, y) = before.outward, after.outward, after.start
    share = 1 + ax * bx + ay * by
    if share < 2 / LONGEST_MITRE**2:
        return None
    return x + (ax + bx) / share * WALL_THICKNESS, y + (ay + by) / share * WALL_THICKNESS


def wall_plan(walls: Sequence[Wall], index: int) -> Quad:
    """A wall from above, counter-clockwise: first corner, the two outer ones, second corner; mitred where it can be."""
    wall = walls[index]
    straight = wall.point(0.0, -WALL_THICKNESS), wall.point(wall.length, -WALL_THICKNESS)
    first = outer_corner(walls[index - 1], wall) or straight[0]
    last = outer_corner(wall, walls[(index + 1) % len(walls)]) or straight[1]
    if wall.coordinates(last)[0] - wall.coordinates(first)[0] < 1e-3:
        # A short wall between two corners that lean towards each other: mitred, it would turn over.
        first, last = straight
    return wall.start, first, last, wall.end


def outer_outline(walls: Sequence[Wall]) -> tuple[Point, ...]:
    """The outer face of the walls, counter-clockwise: one corner where it is mitred, two where it is cut straight."""
    found: list[Point] = []
    for before, after in zip((walls[-1], *walls[:-1]), walls, strict=True):
        corner = outer_corner(before, after)
        cut = (before.point(before.length, -WALL_THICKNESS), after.point(0.0, -WALL_THICKNESS))
        found += cut if corner is None else (corner,)
    return tuple(found)


def wall_pieces(
    length: float, openings: Sequence[Opening], height: float, ends: Span | None = None
) -> Iterator[tuple[Span, Span, Opening | None]]:
    """A wall cut into rectangles, from its first corner on and upward: (along it, in height, what opening or None).

    ``openings`` are those of this wall, ``ends`` where it begins and ends [m] if not at its corners.
    """
    holes = [(o.offset, o.offset + o.width, *heights(o), o) for o in openings]
    inside = (min(max(x, 0.0), length) for hole in holes for x in hole[:2])
    cuts = sorted({*(ends or (0.0, length)), *inside})
    for a, b in zip(cuts, cuts[1:], strict=False):
        if b - a < _LEAST:
            continue
        z = 0.0
        for _, _, low, high, opening in sorted((h for h in holes if h[0] < (a + b) / 2 < h[1]), key=lambda h: h[2:4]):
            low, high = min(low, height), min(high, height)
            if low - z > _LEAST:
                yield (a, b), (z, low), None
            if high - low > _LEAST:
                yield (a, b), (low, high), opening
            z = max(z, high)
        if height - z > _LEAST:
            yield (a, b), (z, height), None
