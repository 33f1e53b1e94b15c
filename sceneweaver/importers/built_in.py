"""What is left of counters, housings and cabinets around what is built into them, as boxes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .fixtures import Fixture

TOP = 0.03
"""Thickness [m] of a counter's top."""

SIDE = 0.2
"""Thickness [m] of the sides of a counter that is open to sit at."""

Box = tuple[np.ndarray, np.ndarray]
"""Least and largest corner [3] [m]."""


def carved(box: Box, hole: Box) -> list[Box]:
    """What is left of a box [m] around another one, as at most six boxes."""
    low, high = box[0].copy(), box[1].copy()
    if (np.minimum(high, hole[1]) - np.maximum(low, hole[0])).min() <= 1e-6:
        return [box]
    left: list[Box] = []
    for axis in (2, 0, 1):
        if hole[0][axis] > low[axis] + 1e-6:
            top = high.copy()
            top[axis] = hole[0][axis]
            left.append((low.copy(), top))
            low[axis] = hole[0][axis]
        if hole[1][axis] < high[axis] - 1e-6:
            bottom = low.copy()
            bottom[axis] = hole[1][axis]
            left.append((bottom, high.copy()))
            high[axis] = hole[1][axis]
    return left


def solid(fixture: Fixture, local: Sequence[tuple[Fixture, Box]]) -> list[Box]:
    """The boxes that a fixture consists of, in its own frame about its box centre.

    ``local`` are the other fixtures of its group with their boxes there. A counter over cabinets is its top only; what
    is let into a counter, a housing or a cabinet is cut out of it.
    """
    whole: Box = (-fixture.size / 2, fixture.size / 2)
    boxes = [whole]
    opened = [v.value is True for v in fixture.entry.listed("base_opening")][:2]
    if fixture.type == "counter" and any(opened):
        boxes = _opened(whole, front=opened[0])
    elif fixture.type == "counter" and any(_in(whole, box) and not _let(other) for other, box in local):
        boxes = [(np.array([*whole[0][:2], whole[1][2] - TOP]), whole[1])]
    if fixture.type in ("counter", "stack", "housing_cabinet") or fixture.type.endswith("_cabinet"):
        for other, box in local:
            if _let(other) or (fixture.type == "housing_cabinet" and other.type not in ("counter", "stack")):
                boxes = [piece for one in boxes for piece in carved(one, box)]
    return [b for b in boxes if (b[1] - b[0]).min() > 1e-4]


def _opened(whole: Box, front: bool) -> list[Box]:
    """A counter to sit at: its top, its sides, and its base in the half that is not open."""
    low, high = whole
    under = high[2] - TOP
    middle = (low[1] + high[1]) / 2
    side = min(SIDE, (high[0] - low[0]) / 2)
    half = (middle, high[1]) if front else (low[1], middle)
    open_half = (low[1], middle) if front else (middle, high[1])
    boxes = [(np.array([low[0], low[1], under]), high)]
    boxes.append((np.array([low[0], half[0], low[2]]), np.array([high[0], half[1], under])))
    for x0, x1 in ((low[0], low[0] + side), (high[0] - side, high[0])):
        boxes.append((np.array([x0, open_half[0], low[2]]), np.array([x1, open_half[1], under])))
    return boxes


def built_into(fixture: Fixture, local: Sequence[tuple[Fixture, Box]]) -> list[tuple[Fixture, Box]]:
    """Those of the other fixtures that a counter or a housing holds within itself, with their boxes in its frame."""
    whole: Box = (-fixture.size / 2, fixture.size / 2)
    within = [(other, box) for other, box in local if _in(whole, box)]
    if fixture.type == "counter":
        return [(other, box) for other, box in within if _let(other)]
    if fixture.type == "housing_cabinet":
        return [(other, box) for other, box in within if other.type not in ("counter", "stack")]
    return []


def _let(other: Fixture) -> bool:
    return other.type in ("sink", "stovetop")


def _in(box: Box, other: Box) -> bool:
    """Whether boxes share more than a litre."""
    shared = np.minimum(box[1], other[1]) - np.maximum(box[0], other[0])
    return bool(shared.min() > 0 and shared.prod() > 1e-3)
