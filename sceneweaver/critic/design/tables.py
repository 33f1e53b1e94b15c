"""Measures of tables and sets: seats around a table, what is laid on it, rows, blocks and grids of equals."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.walls import Wall
from sceneweaver.verify.solids import Body

from ..survey import Survey
from .measure import along, top_of
from .plan import seats_at
from .query import kind_set
from .registry import measure

PLATES = "=plate =place_setting"

DRINKS = "=drinking_glass =wine_glass =champagne_flute =mug =cup_and_saucer =place_setting"

POURED = "=pitcher =carafe =teapot"

CUTLERY = "=cutlery_set =place_setting"

LOW_TABLES = "coffee_table =side_table"

EDGE = 0.1
"""Distance [m] from the edge of a table within which the top begins that one sits at."""

SITTING = (0.15, 0.58)
"""Heights [m] of the seats of children's to adults' chairs."""

CHILD = 0.62
"""Height [m] up to which a chair is a child's, who sits a little less far below a table."""


@measure
def round_top(_: Survey, table: Body) -> bool:
    """Whether a table is round."""
    return max(table.size[:2]) < 1.15 * min(table.size[:2]) and "round" in table.item.category


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
    plates, drinks = sum(on[c] for c in kind_set(PLATES)), sum(on[c] for c in kind_set(DRINKS))
    wrong = []
    if plates and plates != seats:
        wrong.append(f"{plates} plates for {seats} seats")
    if plates and not sum(on[c] for c in kind_set(CUTLERY)):
        wrong.append("no cutlery")
    if plates and not drinks:
        wrong.append("no glass")
    if seats and not drinks and any(on[c] for c in kind_set(POURED)):
        wrong.append("something to pour from and no glass")
    return ", ".join(wrong)


@measure
def unlaid(survey: Survey, tables: Sequence[Body]) -> list[str]:
    """What laid tables lack, each once."""
    return [what for what in dict.fromkeys(lacks(survey, t) for t in tables) if what]


@measure
def seat_height(_: Survey, seat: Body) -> float | None:
    """Height [m] that people sit at: the top of the highest wide part that is low enough; None without such a part."""
    d, w, _h = seat.size
    tops = []
    for part in seat.item.solids:
        xs, ys = [p[0] for p in part.polygon], [p[1] for p in part.polygon]
        wide = (max(xs) - min(xs)) * (max(ys) - min(ys)) > 0.3 * d * w
        if wide and SITTING[0] < part.z[1] < SITTING[1]:
            tops.append(part.z[1])
    return max(tops) if tops else None


@measure
def child(_: Survey, seat: Body) -> float:
    """How much less [m] far below a table a child sits."""
    return 0.08 if seat.size[2] < CHILD else 0.0


@measure
def rise(survey: Survey, table: Body, seat: Body) -> float | None:
    """Height [m] from the seat of a chair to the top of its table."""
    height = seat_height(survey, seat)
    return None if height is None else _top_at(table, seat) - height


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
def most_off_grid(survey: Survey, tables: Sequence[Body]) -> float:
    """The most that any of some tables is off the row or column of another [m]."""
    return max(off_grid(survey, t, tables) for t in tables)


@measure
def by_kind(_: Survey, bodies: Sequence[Body]) -> list[tuple[Body, ...]]:
    """Some bodies by category."""
    found: dict[str, list[Body]] = defaultdict(list)
    for body in bodies:
        found[body.item.category].append(body)
    return [tuple(row) for row in found.values()]


@measure
def blocks(survey: Survey, kinds_: str, reach: float, least: float = 0.7) -> list[tuple[Body, ...]]:
    """Equal storage, higher than ``least`` [m], that stands with its back to a wall; others stand in aisles."""
    found: dict[tuple[Any, ...], list[Body]] = defaultdict(list)
    for body in survey.on_floor(kind_set(kinds_)):
        back = survey.back_wall(body)
        if body.size[2] > least and back is not None and back[1] < reach:
            found[body.item.category, *(round(s, 2) for s in body.size)].append(body)
    return [tuple(row) for row in found.values()]


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
def seats_along(survey: Survey, wall: Wall, kinds_: str, reach: float) -> list[Body]:
    """The seats with their backs to a wall, within a gap [m], in order."""
    found = []
    for seat in survey.on_floor(kind_set(kinds_)):
        back = survey.back_wall(seat)
        if back is not None and back[0] is wall and back[1] < reach and math.degrees(back[2]) < 15:
            found.append((along(wall, seat)[0][0], seat.index, seat))
    return [seat for *_, seat in sorted(found)]


@measure
def uneven_gaps(survey: Survey, wall: Wall, seats: Sequence[Body], near: float) -> float | None:
    """How much [m] the gaps between seats along a wall differ; None where equals have tables in every wide one."""
    spans = [along(wall, s)[0] for s in seats]
    gaps = [b[0] - a[1] for a, b in pairwise(spans)]
    close = [g for g in gaps if g < near]
    if len(close) < 2:
        return None
    wide = [(s, g) for s, g in zip(seats, gaps, strict=False) if 0.3 <= g <= near]
    tables = all(any(t.item.category in kind_set(LOW_TABLES) for t, _ in survey.near(s, g)) for s, g in wide)
    if len({s.item.category for s in seats}) == 1 and tables:
        return None
    return max(close) - min(close)
