"""Stairs of a plan: a stairwell with two flights that turn back, its size by the storey's height and the rules."""

from __future__ import annotations

import math
from dataclasses import dataclass

Rect = tuple[int, int, int, int]

FLIGHT = 920
"""Width of a flight [mm]."""
EYE = 60
"""Between the flights [mm]."""
GOING = 255
LANDING = 920
"""Depth of the landing halfway [mm]."""
FLOOR = 1100
"""Depth of the floor before the first and after the last step [mm]: a passage and the wall beside it."""
SLAB = 300
"""Between a ceiling and the floor over it [mm]."""


@dataclass(frozen=True)
class Stairwell:
    """Two flights side by side with a landing halfway, and the floor before them.

    Attributes:
        width, length: of the stairwell, clear [mm].
        floor: depth of the floor before the first and after the last step [mm].
        risers: how many steps join two storeys.
        going: depth of a tread [mm].
        flight: width of a flight [mm].
    """

    width: int
    length: int
    floor: int
    risers: int
    going: int = GOING
    flight: int = FLIGHT

    @classmethod
    def between(cls, rise: int, most_riser: int, least_going: int, least_width: int, least_way: int) -> Stairwell:
        """The stairs that rise by so many mm between two floors, by the rules' bounds [mm]."""
        half = math.ceil(rise / most_riser / 2)
        going = max(GOING, least_going)
        flight = max(FLIGHT, least_width)
        floor = max(FLOOR, least_way)
        length = floor + (half - 1) * going + max(LANDING, flight)
        return cls(2 * flight + EYE, length, floor, 2 * half, going, flight)

    def parts(self, shaft: Rect, axis: int, sign: int) -> tuple[tuple[Rect, bool], tuple[Rect, bool]]:
        """The floor before the steps (where doors may be) and the flights, in a shaft; stairs go up along ``sign``."""
        floor, flights = list(shaft), list(shaft)
        if sign > 0:
            at = shaft[axis] + self.floor
            floor[axis + 2], flights[axis] = at, at
        else:
            at = shaft[axis + 2] - self.floor
            floor[axis], flights[axis + 2] = at, at
        return (_rect(floor), True), (_rect(flights), False)


def _rect(values: list[int]) -> Rect:
    return values[0], values[1], values[2], values[3]
