"""Measures of how the floor is filled."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..design.registry import measure
from ..space import floor_of, largest_rectangle
from ..survey import Survey


@measure
def covered_share(survey: Survey) -> float:
    """Share of the floor under furniture."""
    floor = floor_of(survey)
    return floor.share(floor.taken)


@measure
def used_share(survey: Survey) -> float:
    """Share of the floor within reach of furniture or a door."""
    floor = floor_of(survey)
    return floor.share(floor.used)


class Rectangle(NamedTuple):
    """A rectangle of floor: its area [m2], sides [m] and middle [m]."""

    area: float
    width: float
    length: float
    x: float
    y: float


@measure
def idle_rectangle(survey: Survey) -> Rectangle:
    """The largest rectangle of floor, along the walls, beyond the reach of all furniture."""
    kept = survey.__dict__.get("_idle")
    if kept is None:
        floor = floor_of(survey)
        cells, row, column, rows, columns = largest_rectangle(floor.inside & ~floor.used)
        x, y = floor.world(row + rows / 2, column + columns / 2)
        kept = Rectangle(cells * floor.cell**2, columns * floor.cell, rows * floor.cell, float(x), float(y))
        survey.__dict__["_idle"] = kept
    return kept


class Half(NamedTuple):
    """A half of the room, as seen along its longest wall, and its share of the furniture."""

    share: float
    side: str


@measure
def emptiest_half(survey: Survey) -> Half:
    """The half of the floor that has the least share of the furniture."""
    floor = floor_of(survey)
    total = int(floor.taken.sum())
    if total == 0:
        return Half(0.0, "whole")
    halves = []
    for axis, sides in ((1, ("left", "right")), (0, ("near", "far"))):
        area = np.cumsum(floor.inside.sum(axis=1 - axis))
        cut = int(np.searchsorted(area, area[-1] / 2)) + 1
        taken = floor.taken.sum(axis=1 - axis)
        halves += [
            Half(float(part.sum()) / total, side) for part, side in zip((taken[:cut], taken[cut:]), sides, strict=True)
        ]
    return min(halves, key=lambda half: half.share)
