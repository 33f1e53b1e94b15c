"""How many people things have place for: beds, benches and sofas, tables; the data is ``capacity.yaml``."""

from __future__ import annotations

import math
from collections.abc import Set
from functools import cache
from typing import Any

from sceneweaver.assets.roles import groups_above

from .load import data_of


@cache
def _data() -> dict[str, Any]:
    return data_of("capacity.yaml")


def number(name: str) -> float:
    """A number of the file; KeyError for one that it has not."""
    return float(_data()[name])


def sleeping_places(category: str) -> int:
    """The people that sleep in one thing of a category; 0 where nobody does."""
    places: dict[str, int] = _data()["sleep"]
    if category in places:
        return places[category]
    above = [places[name] for name in groups_above(category) if name in places]
    return max(above, default=0)


def owned() -> frozenset[str]:
    """The categories of which everybody has one for their own where several are named."""
    return frozenset(_data()["own"])


def seat_places(width: float) -> int:
    """The people that sit beside each other on a seat of a width [m]; at least one."""
    return max(1, int(width / number("seat_width") + 1e-6))


def long_enough(people: int) -> float:
    """The width [m] of a seat that so many sit on beside each other."""
    return round(people * number("seat_width") + 0.01, 3)


SIDES = frozenset(("front", "back", "left", "right"))


def edge_places(depth: float, width: float, free: Set[str] = SIDES, *, round_: bool = False) -> int:
    """The people that sit at a table of two sides [m], one at each end where that is wide enough.

    Args:
        depth, width: its extents, from front to back and from left to right.
        free: its sides that one can sit at; all of a table that stands free.
        round_: whether it is sat around evenly.
    """
    short, long = sorted((depth, width))
    if free >= SIDES and long <= number("square") * short:
        if round_:
            return max(4, int(math.pi * short / number("ring") + 1e-6))
        return max(4, 2 * _along(short, long - number("corner"), 2, 0))
    lengthwise, across = (("front", "back"), ("left", "right"))
    if depth > width:
        lengthwise, across = across, lengthwise
    ends = sum(side in free for side in across) if long > number("square") * short else 0
    return _along(short, long, sum(side in free for side in lengthwise), ends)


def _along(short: float, long: float, sides: int, ends: int) -> int:
    sides = min(sides, 2 if short >= number("two_sided") else 1)
    ends = ends if short >= max(number("end"), number("two_sided")) else 0
    return sides * int(long / number("edge") + 1e-6) + ends
