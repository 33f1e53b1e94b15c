"""Plans as lines: rooms are what the walls enclose, with what is written in them; openings lie on the walls."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .model import SourceOpening, SourceRoom
from .outlines import holds, near_wall, of_walls

MOST_LINES = 5000
"""Lines, shapes and texts of a plan."""

LEAST = 0.25
"""Least area [m2] that walls enclose to be a room; less is within a wall."""


@dataclass(frozen=True)
class Label:
    """A word for a room, and a point of the room."""

    text: str
    point: tuple[float, float]


def enclosed(walls: np.ndarray, tolerance: float) -> list[np.ndarray]:
    """The rooms that walls [n, 4] enclose, as corners [k, 2]: each face, without those within a wall."""
    from sceneweaver.geometry.polygons import signed_area

    return [ring for ring in of_walls(walls, tolerance) if signed_area(ring) >= LEAST]


def labelled(rings: Sequence[np.ndarray], labels: Sequence[Label]) -> list[list[str]]:
    """The words that stand in each room, in order."""
    return [[label.text for label in labels if holds(ring, label.point)] for ring in rings]


def rooms_of(
    rooms: Sequence[tuple[str, str, np.ndarray]],
    openings: Sequence[SourceOpening],
    reach: float,
    notes: Sequence[str] = (),
    *,
    height: float | None = None,
    house: str = "",
    storey: str = "",
) -> list[SourceRoom]:
    """Rooms with the openings in their walls.

    Args:
        rooms: name, type and corners [k, 2] in metres of each.
        openings: of the plan.
        reach: farthest [m] of an opening's middle line from the face of its wall.
        notes: of the plan, for each room.
        height: of the ceiling [m], as `SourceRoom` has it; house and storey likewise.
    """
    return [
        SourceRoom(
            name=name,
            type=kind,
            outline=tuple((float(x), float(y)) for x, y in ring),
            openings=tuple(o for o in openings if near_wall(ring, o.start, o.end, reach)),
            notes=tuple(notes),
            height=height,
            house=house,
            storey=storey,
        )
        for name, kind, ring in rooms
    ]


def numbered(kinds: Sequence[str]) -> list[str]:
    """Names of rooms by their types: bedroom, bedroom_1, ..."""
    counts: dict[str, int] = {}
    names = []
    for kind in kinds:
        stem = kind or "room"
        names.append(f"{stem}_{counts.setdefault(stem, 0)}")
        counts[stem] += 1
    return names
