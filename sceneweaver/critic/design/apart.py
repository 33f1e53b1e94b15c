"""What keeps apart: tables off the walls, groups off each other, things that are not used where they touch."""

from __future__ import annotations

from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..needs import seat_like, table_of
from ..survey import FLAT, Survey
from .breach import breach
from .measure import applies, names

APART = kinds.SEATED_AT | frozenset(("activity_table", "kids_table", "standing_mirror"))
"""What stands apart from all that is none of its group."""


RAMMED = frozenset(
    (
        ("standing_mirror", "nightstand"),
        ("laundry_hamper", "nightstand"),
        ("laundry_hamper", "pedal_bin"),
        ("scale", "toilet"),
        ("reception_desk", "library_shelf"),
    )
)
"""Things that are not used where they touch."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for what keeps apart."""
    if applies(survey, "table_off_walls"):
        yield from _tables_at_walls(survey)
    if applies(survey, "pieces_apart"):
        yield from _apart(survey)


def _tables_at_walls(survey: Survey) -> Iterator[Finding]:
    least = limit("table_off_walls", "gap")
    for table in survey.on_floor(kinds.DINING):
        gap = float(survey.wall_gaps[table.index])
        round_ = "round" in table.item.category
        seats = [b for b, _ in survey.near(table, 0.9) if seat_like(b) and table_of(survey, b) is table]
        if (
            gap >= least
            or len(seats) < (3 if round_ else 4)
            or (not round_ and _end_at_wall(survey, table, seats, least))
        ):
            continue
        yield breach(
            "table_off_walls",
            (table.id,),
            f"{table.id} for {len(seats)} stands {gap:.2f} m from a wall: its seats crowd the other sides",
            measured=gap,
            allowed=(least, None),
            suggestion=f"move {table.id} at least {least:g} m off the walls",
        )


def _end_at_wall(survey: Survey, table: Body, seats: list[Body], least: float) -> bool:
    """Whether only a short end of a table is at a wall, and its seats are at the long sides alone."""
    ends = ("front", "back") if table.size[0] > table.size[1] else ("left", "right")
    sides = tuple(s for s in ("front", "back", "left", "right") if s not in ends)
    if any(survey.clear_ahead(table, s) < least for s in sides):
        return False
    along_x, half = ends[0] == "front", max(table.size[:2]) / 2
    return not any(abs(table.local(b.centre)[0 if along_x else 1]) > half - 0.15 for b in seats)


def _apart(survey: Survey) -> Iterator[Finding]:
    """Tables of different groups that touch, seats of one at another, and things that are rammed together."""
    least = limit("pieces_apart", "gap")
    for body in survey.on_floor(APART, {one for one, _ in RAMMED}):
        seats: list[tuple[float, Body]] = []
        for other, gap in survey.near(body, 3 * least):
            if other.item.mount != "floor" or other.z[1] <= FLAT / 2 or _one_group(survey, body, other):
                continue
            both = body.item.category in kinds.SEATED_AT and other.item.category in kinds.SEATED_AT
            rammed = (body.item.category, other.item.category) in RAMMED
            if kinds.upright_seat(other.item.category) and table_of(survey, other) not in (body, None):
                seats.append((gap, other))
            if (both and body.index < other.index) or (rammed and gap < least - 0.01):
                yield _close(body, [(gap, other)], least if rammed else 3 * least)
        if seats and body.item.category in kinds.SEATED_AT:
            yield _close(body, seats, 3 * least)


def _close(body: Body, others: list[tuple[float, Body]], least: float) -> Finding:
    gap = min(g for g, _ in others)
    return breach(
        "pieces_apart",
        (body.id, *(b.id for _, b in others)),
        f"{gap:.2f} m between {body.id} and {names(b for _, b in others)}, which is of another group",
        measured=gap,
        allowed=(round(least, 3), None),
        suggestion=f"move {body.id} away from {names(b for _, b in others)}",
    )


def _one_group(survey: Survey, a: Body, b: Body) -> bool:
    """Whether two things stand together on purpose: tied, or equal tables in a row."""
    return a.item.category == b.item.category or frozenset((a.id, b.id)) in survey.pairs
