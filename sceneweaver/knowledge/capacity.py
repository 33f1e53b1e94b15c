"""How many people things have place for: beds, benches and sofas, tables; the data is ``capacity.yaml``."""

from __future__ import annotations

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


def seat_places(width: float) -> int:
    """The people that sit beside each other on a seat of a width [m]; at least one."""
    return max(1, int(width / number("seat_width") + 1e-6))


def long_enough(people: int) -> float:
    """The width [m] of a seat that so many sit on beside each other."""
    return round(people * number("seat_width") + 0.01, 3)


def edge_places(depth: float, width: float) -> int:
    """The people that sit at a free-standing table of two sides [m], one at each end where that is wide enough."""
    short, long = sorted((depth, width))
    sides = 2 if short >= number("two_sided") else 1
    ends = 2 if sides == 2 and short >= number("end") and long > 1.12 * short else 0
    round_ = 4 if long <= 1.12 * short and long < 1.2 else 0
    return max(round_, sides * int(long / number("edge") + 1e-6) + ends)
