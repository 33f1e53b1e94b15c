"""Tables that people sit around: even seats of the right height, a place laid for each, tables on a grid."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from sceneweaver.geometry.se2 import SE2
from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..needs import seat_like, table_of
from ..survey import Survey
from .breach import breach
from .measure import applies, named, names, top_of

PLATES = frozenset(("plate", "place_setting"))

DRINKS = named("drinking_glass wine_glass champagne_flute mug cup_and_saucer place_setting")

POURED = named("pitcher carafe teapot")

CUTLERY = frozenset(("cutlery_set", "place_setting"))

SNACKS = frozenset(("cafe", "bakery", "break_room"))
"""Rooms in which a plate on a table is that of one person: tables are not laid."""

EDGE = 0.1
"""Distance [m] from the edge of a table within which the top begins that one sits at."""

FEWEST = 4
"""Tables from which a grid is expected."""


HIGH = named("reception_desk bar_counter bar_table kitchen_island standing_desk workbench lab_bench")
"""Tables that people stand at, or sit at on high seats."""

SITTING = (0.15, 0.58)
"""Heights [m] of the seats of children's to adults' chairs."""

CHILD = 0.62
"""Height [m] up to which a chair is a child's, who sits a little less far below a table."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for tables."""
    tables = survey.on_floor(kinds.SEATED_AT, ("activity_table",))
    unlaid: dict[str, list[Body]] = defaultdict(list)
    for table in tables:
        seats = [b for b, _ in survey.near(table, 0.9) if seat_like(b) and table_of(survey, b) is table]
        if table.item.category in kinds.DINING | {"activity_table"}:
            yield from _even(survey, table, seats)
            if survey.room_type.name not in SNACKS and (wrong := _laid(survey, table, len(seats))):
                unlaid[wrong].append(table)
        if table.item.category not in HIGH:
            yield from _height(survey, table, seats)
    if applies(survey, "plates_equal_seats"):
        for wrong, bodies in unlaid.items():
            yield breach(
                "plates_equal_seats",
                (b.id for b in bodies),
                f"{names(bodies)}: {wrong}",
                weight=(1.0 if "for" in wrong else 0.5) * min(2.0, 0.8 + 0.2 * len(bodies)),
                suggestion=f"lay a place with plate, cutlery and glass before each seat of {names(bodies)}",
            )
    if applies(survey, "tables_on_grid"):
        yield from _grid(survey)


def _even(survey: Survey, table: Body, seats: list[Body]) -> Iterator[Finding]:
    if len(seats) < 2 or not applies(survey, "seats_even"):
        return
    angle, offset = limit("seats_even", "angle"), limit("seats_even", "offset")
    if max(table.size[:2]) < 1.15 * min(table.size[:2]) and "round" in table.item.category:
        turns = sorted(math.degrees(math.atan2(*reversed(table.local(s.centre)))) % 360 for s in seats)
        steps = [b - a for a, b in pairwise([*turns, turns[0] + 360])]
        off = max(abs(step - 360 / len(seats)) for step in steps)
        if off > angle and len(seats) >= 3:
            yield breach(
                "seats_even",
                (table.id, *(s.id for s in seats)),
                f"the seats around {table.id} are {min(steps):.0f} to {max(steps):.0f} degrees apart",
                measured=off,
                allowed=(0.0, angle),
                suggestion=f"set the seats around {table.id} at equal angles",
            )
        return
    sides = _sides(table, seats)
    for one, other in (("front", "back"), ("left", "right")):
        a, b = sorted(sides[one]), sorted(sides[other])
        shift = 0.0
        if len(a) == len(b) and a:
            shift = max(*(abs(x - y) for x, y in zip(a, b, strict=True)), abs(float(np.mean([*a, *b]))))
        elif a or b:
            shift = max(abs(float(np.mean(s))) for s in (a, b) if s)
        if shift > offset + 0.03:
            yield breach(
                "seats_even",
                (table.id, *(s.id for s in seats)),
                f"the seats at the two sides of {table.id} are {shift:.2f} m off each other or its middle",
                measured=shift,
                allowed=(0.0, offset),
                suggestion=f"set the seats of {table.id} opposite each other",
            )
            return


def _sides(table: Body, seats: list[Body]) -> dict[str, list[float]]:
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


def _laid(survey: Survey, table: Body, seats: int) -> str:
    """What a laid table lacks: plates for its seats, cutlery, glasses; glasses to a pitcher. Empty: nothing."""
    on = Counter(b.item.category for b in survey.carried.get(table.id, ()))
    plates, drinks = sum(on[c] for c in PLATES), sum(on[c] for c in DRINKS)
    wrong = []
    if plates and plates != seats:
        wrong.append(f"{plates} plates for {seats} seats")
    if plates and not sum(on[c] for c in CUTLERY):
        wrong.append("no cutlery")
    if plates and not drinks:
        wrong.append("no glass")
    if seats and not drinks and any(on[c] for c in POURED):
        wrong.append("something to pour from and no glass")
    return ", ".join(wrong)


def seat_height(seat: Body) -> float | None:
    """Height [m] that people sit at: the top of the highest wide part that is low enough; None without such a part."""
    d, w, _ = seat.size
    tops = []
    for part in seat.item.solids:
        xs, ys = [p[0] for p in part.polygon], [p[1] for p in part.polygon]
        wide = (max(xs) - min(xs)) * (max(ys) - min(ys)) > 0.3 * d * w
        if wide and SITTING[0] < part.z[1] < SITTING[1]:
            tops.append(part.z[1])
    return max(tops) if tops else None


def _top_at(table: Body, seat: Body) -> float:
    """Height [m] of the top of a table at the side where a seat is: a shelf along its other side does not count."""
    x, y = table.local(seat.centre)
    axis = 0 if abs(x) * table.size[1] > abs(y) * table.size[0] else 1
    sign = 1.0 if (x, y)[axis] > 0 else -1.0
    edge = table.size[axis] / 2 - EDGE
    tops = [s.z for s in table.item.surfaces if max(sign * p[axis] for p in s.polygon) > edge]
    return max(tops) if tops else top_of(table)


def _height(survey: Survey, table: Body, seats: list[Body]) -> Iterator[Finding]:
    if not applies(survey, "seat_fits_table"):
        return
    low, high = limit("seat_fits_table", "low"), limit("seat_fits_table", "high")
    wrong = []
    for seat in seats:
        height, less, top = seat_height(seat), 0.08 if seat.size[2] < CHILD else 0.0, _top_at(table, seat)
        if height is not None and not low - less - 0.03 <= top - height <= high - less + 0.02:
            wrong.append((top - height, seat))
    if wrong:
        rise = max(wrong, key=lambda w: (round(abs(w[0] - (low + high) / 2), 3), w[1].id))[0]
        yield breach(
            "seat_fits_table",
            (table.id, *(s.id for _, s in wrong)),
            f"{names(s for _, s in wrong)} sits {rise:.2f} m below the top of {table.id}",
            measured=rise,
            allowed=(low, high),
            weight=min(1.5, 0.5 + 5 * max(low - rise, rise - high, 0.0)),
            suggestion=f"take a seat that is {low:g} to {high:g} m lower than {table.id}",
        )


def _grid(survey: Survey) -> Iterator[Finding]:
    """Tables that share neither a row nor a column with another."""
    tables = survey.on_floor(kinds.DINING, ("booth_seat", "school_desk"))
    if len(tables) < FEWEST:
        return
    offset = limit("tables_on_grid", "offset")
    xy = SE2(yaw=survey.axis).to_local([b.centre for b in tables])
    away = np.abs(xy[:, None, :] - xy[None, :, :]) + 9.0 * np.eye(len(tables))[:, :, None]
    alone = [b for b, least in zip(tables, away.min(axis=(1, 2)), strict=True) if least > offset]
    if alone:
        yield breach(
            "tables_on_grid",
            (b.id for b in alone),
            f"{names(alone)} shares no row or column with another table",
            measured=float(away.min(axis=(1, 2)).max()),
            allowed=(None, offset),
            suggestion="set the tables out on a grid",
        )
