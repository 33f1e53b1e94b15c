"""Rooms that receive people: staff and visitor sides, desks that look at the door, waiting seats with their tables."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..survey import Survey, turn_to
from .breach import breach
from .measure import along, applies, door_distance, middle, named, names, outlook, strip

STAFFED = frozenset(("reception_desk", "bar_counter", "host_stand"))
"""What staff stand or sit behind, at its back."""

STAFF_SEATS = named("office_chair gaming_chair conference_chair stool bar_stool")
"""Seats that may be those of staff."""

VISITORS = kinds.LOUNGE | named(
    "chair waiting_bench bench magazine_rack water_cooler coffee_table round_coffee_table activity_table"
    " menu_board dining_chair"
)
"""What visitors use."""

WAITING = kinds.LOUNGE | named("chair waiting_bench bench folding_chair")

CHILD_SEATS = named("kids_chair stool pouf floor_cushion bean_bag")

LOW_TABLES = kinds.COFFEE | {"side_table"}

SIDEWAYS = 115.0
"""Angle [degrees] to the door up to which a board with a menu is read by who comes in."""

BESIDE = 0.9
"""Distance [m] beyond the ends of a counter up to which what is behind it is its staff's side."""

KNEES = 0.5
"""Depth [m] before a waiting seat that other seats leave free."""

ROW = 0.3
"""Distance [m] from a wall up to which a seat stands along it."""

NEAR = 2.2
"""Gap [m] between neighbours up to which seats along a wall make one row."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for staff and visitors."""
    yield from _sides(survey)
    yield from _looks_at_door(survey)
    if applies(survey, "seats_in_order"):
        seats = survey.on_floor(WAITING)
        yield from _rows(survey, seats)
        yield from _knees(survey, seats)
        yield from _tables(survey, seats)
        yield from _lost(survey, seats)


def _sides(survey: Survey) -> Iterator[Finding]:
    if not applies(survey, "staff_and_visitors_apart"):
        return
    depth = limit("staff_and_visitors_apart", "depth")
    for desk in survey.on_floor(STAFFED):
        d, w, _ = desk.size
        if desk.item.category == "host_stand":
            continue  # guests pass on either side of it
        behind = []
        for body in survey.on_floor(VISITORS):
            ahead, aside = desk.local(body.centre)
            if -d / 2 - depth < ahead < (0.0 if abs(aside) < w / 2 else d / 2) and abs(aside) < w / 2 + BESIDE:
                behind.append(body)
        if behind:
            yield breach(
                "staff_and_visitors_apart",
                (*(b.id for b in behind), desk.id),
                f"{names(behind)} stands on the staff's side of {desk.id}",
                measured=float(len(behind)),
                weight=min(2.0, 0.7 + 0.3 * len(behind)),
                suggestion=f"move {names(behind)} to the visitors' side of {desk.id}",
            )
        if desk.item.category != "reception_desk":
            continue
        clerks = [b for b, _ in survey.near(desk, 1.0) if b.item.category in STAFF_SEATS - {"bar_stool"}]
        wrong = [b for b in clerks if desk.local(b.centre)[0] > 0.0]
        if wrong and len(wrong) == len(clerks):
            yield breach(
                "staff_and_visitors_apart",
                (wrong[0].id, desk.id),
                f"{wrong[0].id} stands on the visitors' side of {desk.id}",
                measured=desk.local(wrong[0].centre)[0],
                allowed=(None, 0.0),
                weight=1.5,
                suggestion=f"put {wrong[0].id} behind {desk.id}",
            )


def _looks_at_door(survey: Survey) -> Iterator[Finding]:
    if not applies(survey, "desk_looks_at_door"):
        return
    angle, distance = limit("desk_looks_at_door", "angle"), limit("desk_looks_at_door", "distance")
    for desk in survey.on_floor(("reception_desk", "host_stand", "menu_board")):
        doors = survey.placed.doors
        if not doors:
            return
        away = door_distance(survey, desk)
        turned = min(outlook(desk, middle(door)) for door in doors)
        host = desk.item.category != "reception_desk"
        most = SIDEWAYS if desk.item.category == "menu_board" else angle
        if host and away > distance:
            yield breach(
                "desk_looks_at_door",
                (desk.id,),
                f"{desk.id} stands {away:.1f} m from the door",
                measured=away,
                allowed=(None, distance),
                suggestion=f"put {desk.id} beside the door",
                call=("add_relation", {"relations": _welcoming(desk, doors[0].item.id, distance)}),
            )
        elif turned > most:
            yield breach(
                "desk_looks_at_door",
                (desk.id,),
                f"{desk.id} is turned {turned:.0f} degrees away from the door",
                measured=turned,
                allowed=(None, most),
                suggestion=f"turn {desk.id} to the door",
                call=("add_relation", {"relations": _welcoming(desk, doors[0].item.id, distance)}),
            )


def _welcoming(desk: Body, door: str, distance: float) -> list[dict[str, Any]]:
    """The relations of something that looks at a door, and where it greets guests stands near it [m]."""
    near = {"type": "near_door", "subject": desk.id, "target": door, "params": {"max": distance - 1.0}, "hard": False}
    facing = {"type": "facing_door", "subject": desk.id, "target": door, "hard": False}
    return [facing] if desk.item.category == "reception_desk" else [facing, near]


# ---- waiting ---------------------------------------------------------------------------------------------------------


def _walls(survey: Survey, seats: list[Body]) -> dict[int, list[tuple[float, float, Body]]]:
    """By wall the seats with their backs to it: the interval [m] of each along it, in order."""
    found: dict[int, list[tuple[float, float, Body]]] = defaultdict(list)
    for seat in seats:
        back = survey.back_wall(seat)
        if back is not None and back[1] < ROW and math.degrees(back[2]) < 15:
            (u0, u1), _ = along(back[0], seat)
            found[back[0].index].append((u0, u1, seat))
    return {k: sorted(rows, key=lambda r: r[0]) for k, rows in found.items()}


def _rows(survey: Survey, seats: list[Body]) -> Iterator[Finding]:
    """Seats along a wall at odd distances."""
    spread = limit("seats_in_order", "spread")
    for rows in _walls(survey, [s for s in seats if "bench" not in s.item.category]).values():
        gaps = [b[0] - a[1] for a, b in zip(rows, rows[1:], strict=False)]
        gaps = [g for g in gaps if g < NEAR]
        if len(gaps) < 2 or max(gaps) - min(gaps) <= spread:
            continue
        if len({s.item.category for *_, s in rows}) == 1 and _between(survey, rows):
            continue
        yield breach(
            "seats_in_order",
            (s.id for *_, s in rows),
            f"{len(rows)} seats in a row stand {min(gaps):.2f} to {max(gaps):.2f} m apart",
            measured=max(gaps) - min(gaps),
            allowed=(None, spread),
            suggestion="set the seats at one distance",
        )


def _between(survey: Survey, rows: list[tuple[float, float, Body]]) -> bool:
    """Whether every wide gap of a row holds a table."""
    for a, b in zip(rows, rows[1:], strict=False):
        if b[0] - a[1] < 0.3 or b[0] - a[1] > NEAR:
            continue
        if not any(t.item.category in LOW_TABLES for t, _ in survey.near(a[2], b[0] - a[1])):
            return False
    return True


def _knees(survey: Survey, seats: list[Body]) -> Iterator[Finding]:
    """Two seats around a corner of which one stands where the other's knees are."""
    import shapely

    for seat in seats:
        area = strip(seat, "front", KNEES, 0.8)
        for other, _ in survey.near(seat, KNEES):
            if other not in seats or abs(math.cos(seat.yaw - other.yaw)) > 0.8:
                continue
            if shapely.area(area & survey.boxes[other.index]) > 0.02 * area.area:
                gap = float(shapely.distance(survey.boxes[seat.index], survey.boxes[other.index]))
                yield breach(
                    "seats_in_order",
                    (seat.id, other.id),
                    f"{gap:.2f} m before {seat.id} to {other.id} around the corner: no room for knees",
                    measured=gap,
                    allowed=(KNEES, None),
                    suggestion=f"leave {KNEES:g} m before {seat.id}",
                )


def _tables(survey: Survey, seats: list[Body]) -> Iterator[Finding]:
    """Coffee tables with fewer than two seats in reach."""
    reach = limit("coffee_table_distance", "reach")
    for table in survey.on_floor(kinds.COFFEE):
        near = [b for b, gap in survey.near(table, reach) if b in seats and math.degrees(turn_to(b, table.centre)) < 75]
        if len(near) >= 2 or len(seats) < 2 or any("bench" in b.item.category for b in near):
            continue  # a bench is for several
        gap = min((g for b, g in survey.near(table, 5.0) if b in seats), default=math.inf)
        yield breach(
            "coffee_table_distance",
            (table.id, *(b.id for b in near)),
            f"{len(near)} of {len(seats)} seats within {reach:g} m of {table.id}, the nearest at {gap:.2f} m",
            measured=float(len(near)),
            allowed=(2.0, None),
            suggestion=f"put {table.id} before the seats",
        )


def _lost(survey: Survey, seats: list[Body]) -> Iterator[Finding]:
    """Racks far from the seats of those who read, and tables for children without a seat for them."""
    reach = limit("piece_in_a_group", "seats")
    for body in survey.on_floor(("magazine_rack", "newspaper_stand")):
        if seats and not any(b in seats for b, _ in survey.near(body, reach)):
            yield breach(
                "piece_in_a_group",
                (body.id,),
                f"{body.id} stands more than {reach:g} m from all {len(seats)} seats",
                allowed=(None, reach),
                suggestion=f"put {body.id} beside the seats",
            )
    for table in survey.on_floor(("activity_table", "kids_table")):
        if not any(b.item.category in CHILD_SEATS for b, _ in survey.near(table, reach)):
            yield breach(
                "piece_in_a_group",
                (table.id,),
                f"no child's seat is within {reach:g} m of {table.id}",
                allowed=(None, reach),
                suggestion=f"put a child's seat at {table.id}",
            )
