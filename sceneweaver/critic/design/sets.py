"""Measures of sets: seats around a table, what is laid on it, rows and grids of equals, mats before what they serve."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from sceneweaver.assets.roles import with_role
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.walls import Wall
from sceneweaver.verify.solids import Body

from ..survey import Survey
from .measure import along, parts_of, top_of
from .plan import seats_at
from .query import kind_set, listed
from .registry import measure

EDGE = 0.1
"""Distance [m] from the edge of a table within which the top begins that one sits at."""


@measure
def uneven_angles(_: Survey, table: Body, seats: Sequence[Body]) -> float:
    """How far [deg] the steps between seats around a table are off equal ones, at most."""
    turns = sorted(math.degrees(math.atan2(*reversed(table.local(s.centre)))) % 360 for s in seats)
    steps = [b - a for a, b in pairwise([*turns, turns[0] + 360])]
    return max(abs(step - 360 / len(seats)) for step in steps)


@measure
def uneven_sides(_: Survey, table: Body, seats: Sequence[Body], enough: float) -> float:
    """How far [m] the seats of two opposite sides are off each other or the middle, of the first beyond ``enough``."""
    sides, shift = _sides(table, seats), 0.0
    for one, other in (("front", "back"), ("left", "right")):
        a, b = sorted(sides[one]), sorted(sides[other])
        if len(a) == len(b) and a:
            shift = max(*(abs(x - y) for x, y in zip(a, b, strict=True)), abs(float(np.mean([*a, *b]))))
        elif a or b:
            shift = max(abs(float(np.mean(s))) for s in (a, b) if s)
        if shift > enough:
            break
    return shift


def _sides(table: Body, seats: Sequence[Body]) -> dict[str, list[float]]:
    """By side of a table the places [m] of the seats along it."""
    found: dict[str, list[float]] = {"front": [], "back": [], "left": [], "right": []}
    for seat in seats:
        ahead, aside = table.local(seat.centre)
        u, v = ahead / table.size[0], aside / table.size[1]
        if abs(u) > abs(v):
            found["front" if u > 0 else "back"].append(aside)
        else:
            found["left" if v > 0 else "right"].append(ahead)
    return found


@measure
def lacks(survey: Survey, table: Body) -> str:
    """What a laid table lacks: plates for its seats, cutlery, glasses; glasses to a pitcher. Empty: nothing."""
    seats = len(seats_at(survey, table))
    on = Counter(b.item.category for b in survey.carried.get(table.id, ()))
    plates, cutlery, glasses, poured = (
        sum(on[c] for c in with_role(role)) for role in ("laid_plate", "laid_cutlery", "laid_glass", "poured_from")
    )
    wrong = {
        f"{plates} plates for {seats} seats": plates and plates != seats,
        "no cutlery": plates and not cutlery,
        "no glass": plates and not glasses,
        "something to pour from and no glass": seats and poured and not glasses,
    }
    return ", ".join(what for what, holds in wrong.items() if holds)


@measure
def rise(_: Survey, table: Body, seat: Body, low: float, high: float) -> float | None:
    """Height [m] from the seat of a chair to the top of its table; None where no wide part is at such heights [m]."""
    tops = [top for share, top in parts_of(seat) if share > 0.3 and low < top < high]
    return _top_at(table, seat) - max(tops) if tops else None


def _top_at(table: Body, seat: Body) -> float:
    """Height [m] of the top of a table at the side where a seat is: a shelf along its other side does not count."""
    x, y = table.local(seat.centre)
    axis = 0 if abs(x) * table.size[1] > abs(y) * table.size[0] else 1
    sign = 1.0 if (x, y)[axis] > 0 else -1.0
    edge = table.size[axis] / 2 - EDGE
    tops = [s.z for s in table.item.surfaces if max(sign * p[axis] for p in s.polygon) > edge]
    return max(tops) if tops else top_of(table)


# ---- sets of equals --------------------------------------------------------------------------------------------------


@measure
def off_grid(survey: Survey, table: Body, tables: Sequence[Body]) -> float:
    """How far [m] a table is off the row or column of the nearest of some others."""
    xy = SE2(yaw=survey.axis).to_local([table.centre, *(b.centre for b in tables if b is not table)])
    return float(np.abs(xy[1:] - xy[0]).min()) if len(xy) > 1 else math.inf


@measure
def longest_row(_: Survey, bodies: Sequence[Body], angle: float, offset: float, gap: float) -> list[Body]:
    """The most of some machines that face one way, within an angle [deg], and stand side by side."""
    ways: list[list[Body]] = []
    for body in bodies:
        same = (w for w in ways if abs(wrap_angle(body.yaw - w[0].yaw)) < math.radians(angle))
        way = next(same, None)
        if way is None:
            ways.append([body])
        else:
            way.append(body)
    return max((_row(way, offset, gap) for way in ways), key=len)


def _row(bodies: list[Body], offset: float, gap: float) -> list[Body]:
    """The most of some machines that face one way which stand side by side without a wide gap."""
    best: list[Body] = []
    for first in bodies:
        spots = sorted(
            (first.local(b.centre)[1], b.index, b) for b in bodies if abs(first.local(b.centre)[0]) <= offset
        )
        row: list[Body] = []
        for aside, _, body in spots:
            if row and aside - first.local(row[-1].centre)[1] > body.size[1] + gap:
                best, row = max(best, row, key=len), []
            row.append(body)
        best = max(best, row, key=len)
    return best


@measure
def uneven_gaps(survey: Survey, wall: Wall, seats: Sequence[Body], near: float, tables: str) -> float | None:
    """How much [m] the gaps between seats along a wall differ; None where equals have tables in every wide one."""
    spans = [along(wall, s)[0] for s in seats]
    gaps = [b[0] - a[1] for a, b in pairwise(spans)]
    close = [g for g in gaps if g < near]
    if len(close) < 2:
        return None
    wide = [(s, g) for s, g in zip(seats, gaps, strict=False) if 0.3 <= g <= near]
    filled = all(any(t.item.category in kind_set(tables) for t, _ in survey.near(s, g)) for s, g in wide)
    if len({s.item.category for s in seats}) == 1 and filled:
        return None
    return max(close) - min(close)


@measure
def serves(
    survey: Survey, mats: Any, bodies: Any, sides: Sequence[str], slack: float, gap: float, overlap: float = 0.1
) -> bool:
    """Whether any mat lies within a gap [m] of any of some bodies, before its middle at one of some sides.

    Args:
        survey: the room.
        mats, bodies: one or several.
        sides: "front", "back", "left", "right".
        slack: how far [m] the middle of the mat may lie beyond the ends of the side.
        gap: distance [m] between footprints.
        overlap: how far [m] the middle of the mat may lie behind the side.
    """
    for body in listed(bodies):
        for mat in listed(mats):
            if survey.placed.distance(body, mat) <= gap:
                for (x, y), (nx, ny), half in map(body.face, sides):
                    dx, dy = mat.centre[0] - x, mat.centre[1] - y
                    if dx * nx + dy * ny > -overlap and abs(dx * ny - dy * nx) <= half + slack:
                        return True
    return False
