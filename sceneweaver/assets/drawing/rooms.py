"""The room inside hollow bodies, from their inner profile or rings."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .box import Box

SHALLOWEST, FLATTEST, NARROWEST = 0.012, 0.15, 0.012
"""What is hollow by less than this depth [m] or share of its width, or less wide than this [m], holds nothing."""

_LEVEL = 0.25
"""A room is as wide as what is hollow is everywhere above this share of its depth: walls lean in near the floor."""


def staves_of(room: Box) -> int:
    """How many parts in a ring are the wall around a room: more around a wide one."""
    return 6 if room.width < 0.06 else 8 if room.width < 0.25 else 12


def lathed_room(inner: Sequence[tuple[float, float]], scale: np.ndarray) -> Box | None:
    """The room in a lathed body whose inside falls from the first of these points (radius, z) to the last.

    ``scale`` [3] is what it is stretched by. None: there is too little to hold anything.
    """
    if len(inner) < 3:
        return None
    rim, floor = inner[0][1], inner[-1][1]
    falling = inner[1:][::-1]
    levels, radii = [z for _, z in falling], [r for r, _ in falling]
    start = floor + _LEVEL * (rim - floor)
    radius = min([float(np.interp(start, levels, radii)), *[r for r, z in falling if z > start]])
    depth, width = 2 * radius * scale[:2]
    room = Box.sized(float(depth), float(width), rim - floor, (0.0, 0.0, floor))
    return room if holds(room) and np.diff(levels).min() > -1e-9 else None


def holds(room: Box) -> bool:
    """Whether a room is deep and wide enough to hold something."""
    return room.height >= max(SHALLOWEST, FLATTEST * room.width) and min(room.depth, room.width) >= NARROWEST


def lofted_room(inner: Sequence[np.ndarray]) -> tuple[Box, bool]:
    """The room inside rings [K, 3] that fall from a rim to a floor, and whether its plan is an oval."""
    levels = np.array([ring[:, 2].mean() for ring in inner])
    floor, rim = levels.min(), levels.max()
    start = floor + _LEVEL * (rim - floor)
    under = int(np.flatnonzero(levels <= start)[0])
    share = (start - levels[under]) / (levels[under - 1] - levels[under])
    rings = [*inner[:under], inner[under] + share * (inner[under - 1] - inner[under])]
    low = np.max([r[:, :2].min(axis=0) for r in rings], axis=0).tolist()
    high = np.min([r[:, :2].max(axis=0) for r in rings], axis=0).tolist()
    x, y = rings[-1][:, 0], rings[-1][:, 1]
    area = abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2
    fill = area / max(float(np.ptp(x) * np.ptp(y)), 1e-12)
    return Box((low[0], high[0]), (low[1], high[1]), (float(floor), float(rim))), fill < 0.9
