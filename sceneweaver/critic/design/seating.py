"""Whether seats stand in groups: the coffee table within reach, armchairs turned to it, no seat or piece alone."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..groups import ALL_BEDS, SEATS, Seating, furniture, groups_of
from ..needs import table_of
from ..survey import Survey, turn_to
from .breach import Call, breach
from .focus import HOME

FOOTRESTS = frozenset(("pouf", "ottoman"))
"""Seats that serve another seat: they stand before it or at its table."""

AHEAD = 60.0
"""Angle [deg] from the front of a seat up to which a footrest stands before it."""

LOW_TABLES = kinds.COFFEE | frozenset(("side_table", "console_table", "ottoman", "nightstand"))
"""What a sofa needs within reach."""

ARMCHAIRS = frozenset(("armchair", "recliner", "egg_chair", "rocking_chair"))

ALONE = kinds.WALL_BACKED & frozenset(
    ("sideboard", "cabinet", "bookcase", "low_bookcase", "cube_shelf", "display_cabinet", "filing_cabinet", "dresser")
)
"""Furniture that looks lost with nothing near it."""

LOST = 1.5
"""Gap [m] to the nearest other furniture from which a piece of a home is alone."""

FACED = frozenset(("teddy_bear", "rocking_horse", "doll_house", "armchair", "egg_chair", "rocking_chair"))
"""What has a face or a front that is looked at."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Seats and pieces outside of a group, and groups that do not hold together."""
    home = survey.room_type.name in HOME
    for group in groups_of(survey).seatings:
        if home and group.table is not None:
            yield from _table(survey, group, group.table)
    yield from _footrests(survey)
    yield from _sofas(survey)
    yield from _side_tables(survey)
    yield from _faces(survey)
    if home:
        yield from _alone(survey)


def _table(survey: Survey, group: Seating, table: Body) -> Iterator[Finding]:
    low, high = limit("coffee_table_distance", "low"), limit("coffee_table_distance", "high")
    gap = float(survey.boxes[group.anchor.index].distance(survey.boxes[table.index]))
    if group.anchor.item.category in kinds.SOFAS and not low - 0.02 <= gap <= high + 0.02:
        yield breach(
            "coffee_table_distance",
            (table.id, group.anchor.id),
            f"{table.id} is {gap:.2f} m from {group.anchor.id}",
            measured=gap,
            allowed=(low, high),
            suggestion=f"put {table.id} 0.4 m before {group.anchor.id}",
        )
    far, most = limit("armchair_in_group", "distance"), limit("armchair_in_group", "angle")
    for seat in group.seats:
        if seat.item.category not in ARMCHAIRS:
            continue
        gap = float(survey.boxes[seat.index].distance(survey.boxes[table.index]))
        angle = math.degrees(turn_to(seat, table.centre))
        if gap > far or angle > most:
            yield breach(
                "armchair_in_group",
                (seat.id, table.id),
                f"{seat.id} is {gap:.2f} m from {table.id} and turned {angle:.0f} degrees away from it",
                measured=gap,
                allowed=(None, far),
                suggestion=f"put {seat.id} beside {table.id}, turned to it",
            )


def _footrests(survey: Survey) -> Iterator[Finding]:
    """Poufs that stand before no seat and at no table."""
    reach = limit("seat_in_a_group", "reach")
    for body in survey.on_floor(FOOTRESTS):
        near = survey.near(body, reach)
        served = any(
            other.item.category in kinds.COFFEE
            or (other.item.category in ALL_BEDS | {"dressing_table", "vanity"})
            or (other.item.category in kinds.LOUNGE and math.degrees(turn_to(other, body.centre)) <= AHEAD)
            for other, _ in near
        )
        if not served:
            yield breach(
                "seat_in_a_group",
                (body.id,),
                f"{body.id} stands before no seat and at no table within {reach:g} m",
                allowed=(None, reach),
                suggestion=f"put {body.id} before a seat, or remove it",
                call=_gone(survey, body),
            )


def _gone(survey: Survey, body: Body) -> Call | None:
    """The call that takes out what nobody asked for."""
    if body.id in survey.program.asked_of or body.item.intent.priority in ("needed", "asked"):
        return None
    return "remove_objects", {"ids": [body.id]}


def _sofas(survey: Survey) -> Iterator[Finding]:
    """Sofas and benches with no table in reach; in a home they need one before them."""
    reach = limit("seat_in_a_group", "reach")
    for body in survey.on_floor(kinds.SOFAS, ("waiting_bench",)):
        if any(other.item.category in LOW_TABLES | kinds.SEATED_AT - {"desk"} for other, _ in survey.near(body, reach)):
            continue
        yield breach(
            "seat_in_a_group",
            (body.id,),
            f"no table is within {reach:g} m of {body.id}: it stands alone",
            allowed=(None, reach),
            suggestion=f"put a table before {body.id}",
        )


def _side_tables(survey: Survey) -> Iterator[Finding]:
    """Side tables near a sofa that do not stand beside its arm."""
    most, ahead_most = limit("table_beside_seat", "gap"), limit("table_beside_seat", "ahead")
    for table in survey.of_kind(("side_table",)):
        seat = next((b for b, _ in survey.near(table, 0.6) if b.item.category in SEATS - FOOTRESTS), None)
        if seat is None:
            if any(b.item.category in ALL_BEDS for b, _ in survey.near(table, 0.6)) or table.item.mount != "floor":
                continue
            seat = next((b for b, _ in survey.near(table, 0.4) if table_of(survey, b) is None), None)
            if seat is None or survey.room_type.name in HOME:
                yield breach(
                    "table_beside_seat",
                    (table.id,),
                    f"no seat is within 0.6 m of {table.id}",
                    allowed=(None, 0.6),
                    suggestion=f"put {table.id} beside the arm of a seat",
                )
            continue
        ahead, aside = seat.local(table.centre)
        gap = abs(aside) - seat.size[1] / 2 - min(table.size[:2]) / 2
        if seat.item.category in kinds.LOUNGE and (gap > most or abs(ahead) > ahead_most):
            yield breach(
                "table_beside_seat",
                (table.id, seat.id),
                f"{table.id} stands {ahead:.2f} m ahead of the middle of {seat.id} and {max(0.0, gap):.2f} m beside it",
                measured=abs(ahead),
                allowed=(None, ahead_most),
                suggestion=f"put {table.id} beside the arm of {seat.id}",
            )


def _faces(survey: Survey) -> Iterator[Finding]:
    least = limit("faces_room", "clear")
    for body in survey.on_floor(FACED):
        clear = survey.clear_ahead(body)
        if clear < least:
            yield breach(
                "faces_room",
                (body.id,),
                f"{body.id} looks at a wall {clear:.2f} m away",
                measured=clear,
                allowed=(least, None),
                suggestion=f"turn {body.id} into the room",
            )


def _alone(survey: Survey) -> Iterator[Finding]:
    """Storage of a home far from all other furniture."""
    others = [b for b in furniture(survey) if b.item.category not in kinds.TALL_PLANTS]
    for body in survey.of_kind(ALONE):
        near = [b for b, _ in survey.near(body, LOST) if b in others]
        if not near and len(others) > 1:
            yield breach(
                "piece_in_a_group",
                (body.id,),
                f"nothing stands within {LOST:g} m of {body.id}",
                allowed=(None, LOST),
                suggestion=f"put {body.id} beside other furniture",
            )
