"""Floor plans of several rooms: which room a point is in, and which walls a line lies on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from .model import SourceOpening

Outline = Sequence[tuple[float, float]]

REACH = 0.5
"""Farthest [m] from a room that an object's centre may lie to be taken as its own: hung in a wall, or on a sill."""


def room_at(outlines: Mapping[str, Outline], x: float, y: float, reach: float = REACH) -> str | None:
    """The room whose outline holds a point, or else the nearest one within ``reach`` [m]; None: there is none."""
    import shapely

    point = shapely.Point(x, y)
    far = {name: float(shapely.Polygon(outline).distance(point)) for name, outline in outlines.items()}
    best = min(far, key=lambda name: far[name], default=None)
    return best if best is not None and far[best] <= reach else None


def holds(outline: Outline, x: float, y: float) -> bool:
    """Whether an outline holds a point."""
    import shapely

    return bool(shapely.Polygon(outline).contains(shapely.Point(x, y)))


def on_wall(outline: Outline, start: Sequence[float], end: Sequence[float], reach: float = 0.05) -> bool:
    """Whether a segment lies along one wall of an outline, both of its ends within ``reach`` [m] of that wall."""
    ring = np.asarray(outline, dtype=float)
    ends = np.array((start, end), dtype=float)
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        along = b - a
        length = float(np.hypot(*along))
        if length < 1e-9:
            continue
        along = along / length
        t = (ends - a) @ along
        across = np.abs((ends - a) @ np.array((-along[1], along[0])))
        if across.max() <= reach and t.min() >= -reach and t.max() <= length + reach:
            return True
    return False


def rectangle(x: float, y: float, left: float = 0.0, below: float = 0.0) -> tuple[tuple[float, float], ...]:
    """The outline of a room of ``x`` by ``y`` [m] with its least corner at (left, below), counter-clockwise."""
    return (left, below), (left + x, below), (left + x, below + y), (left, below + y)


def along(a: Sequence[float], b: Sequence[float], low: float, high: float) -> tuple[tuple[float, float], ...]:
    """The points at ``low`` and ``high`` [m] from ``a`` on the way to ``b``, which lies elsewhere."""
    p, q = np.asarray(a, dtype=float)[:2], np.asarray(b, dtype=float)[:2]
    step = (q - p) / np.hypot(*(q - p))
    first, last = p + low * step, p + high * step
    return (float(first[0]), float(first[1])), (float(last[0]), float(last[1]))


def opening_of_box(
    name: str,
    window: bool,
    middle: Sequence[float] | np.ndarray,
    rotation: np.ndarray,
    size: Sequence[float],
    leads_to: str | None = None,
) -> SourceOpening:
    """A door or window of a system that has them as objects: as wide as the longer horizontal side of its box.

    Args:
        name: its name.
        window: whether it is one; a door begins at the floor.
        middle: of the box [3] [m].
        rotation: of the box [3, 3].
        size: its sides [m] along its own x, y, z.
        leads_to: the room behind it.
    """
    depth, width, height = size
    half = rotation @ ((depth / 2, 0.0, 0.0) if depth >= width else (0.0, width / 2, 0.0))
    start, end = (np.asarray(middle, dtype=float) + sign * half for sign in (-1.0, 1.0))
    return SourceOpening(
        name,
        "window" if window else "door",
        (float(start[0]), float(start[1])),
        (float(end[0]), float(end[1])),
        max(0.0, float(middle[2]) - height / 2) if window else 0.0,
        height,
        leads_to=leads_to,
    )
