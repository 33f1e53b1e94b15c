"""Walls moved as little as a profile's rules need: lines of walls, by projected least squares, in whole millimetres."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.home import Home
from sceneweaver.plans import Rule

from .least_squares import nearest
from .reseat import reseated
from .wall_lines import WallLines
from .wall_rows import door_rows, order_rows, rule_rows

ROUNDS = 6
"""Times that floors, which are products, are taken as linear anew."""


def moved_walls(home: Home, rules: Sequence[Rule]) -> Home | None:
    """The home with its walls moved so that rooms keep the rules about sides, floors and ways; None: nothing moves.

    Rules that contradict each other or the order of the walls are kept as far as they go; the judge says what is left.
    Whole millimetres: rows of two lines have whole bounds, and to round all lines down keeps such rows exactly.
    """
    lines = WallLines.of(home)
    if not len(lines.start):
        return None
    places = lines.start
    fixed = [*order_rows(lines, home), *door_rows(lines, home, rules)]
    for _ in range(ROUNDS):
        before = places
        places, _ = nearest(lines.start, lines.weight, [*fixed, *rule_rows(lines, rules, places)])
        if np.abs(places - before).max() < 0.5:
            break
    whole = np.floor(places + 0.05)
    whole[np.abs(places - lines.start) < 0.05] = lines.start[np.abs(places - lines.start) < 0.05]
    if (whole == lines.start).all():
        return None
    outlines = [
        tuple((round(x / 1000, 3), round(y / 1000, 3)) for x, y in lines.outline(k, whole))
        for k in range(len(home.rooms))
    ]
    return reseated(home, outlines)
