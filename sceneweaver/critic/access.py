"""Whether the fronts of furniture, the seats, the doors and the windows are free."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.verify.solids import Body, Opening

from . import kinds
from .design.measure import HEAD, along, overlap, strip
from .grade import Finding, finding, moved, related
from .seats import seat_like, table_of
from .survey import FLAT, Survey

DEEP = 0.45
"""Depth [m] of the room that a front needs, where the category asks for no less."""

COVERED = 0.35
"""Share of the room before a front that may be taken."""

RISE = 0.3
"""Depth [m] behind a seat to sit down and stand up."""

ENTRY = 0.9
"""Depth [m] of the way through a door that should be free."""

LIGHT = 0.6
"""Depth [m] before a window in which tall things take its light."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Blocked fronts, seats without room, obstructed doors, darkened windows."""
    yield from _fronts(survey)
    yield from _seats(survey)
    yield from _doors(survey)
    yield from _windows(survey)
    yield from _hung(survey)


def _fronts(survey: Survey) -> Iterator[Finding]:
    known = survey.violated.get("blocked_zone", set())
    for body in survey.standing:
        row = categories().get(body.item.category)
        if row is None or not row.sides or seat_like(body) or body.item.category in kinds.SEATED_AT:
            continue
        table = "table_group" in kinds.groups_of(body.item.category)
        if table and body.item.category not in kinds.WALL_BACKED | {"nightstand"}:
            continue
        for side in ("front",) if "front" in row.sides else ():
            depth = min(DEEP, row.clearance.get(side, 0.3))
            if body.item.category in kinds.LOUNGE:
                depth = 0.2
            area = strip(body, side, depth)
            blockers = [
                (share, other)
                for other, share in _inside(survey, area, body)
                if frozenset((body.id, other.id)) not in known and not _companion(survey, body, other)
            ]
            total = sum(share for share, _ in blockers)
            if total > COVERED:
                worst = max(blockers, key=lambda b: (b[0], b[1].id))[1]
                yield finding(
                    "layout",
                    "blocked_front",
                    (body.id, *(b.id for _, b in blockers)),
                    f"{worst.id} takes {total:.0%} of the {depth:.2f} m before {body.id}",
                    f"move {worst.id} away from the front of {body.id}",
                    points=1.2 + total,
                    grave=True,
                    call=moved(worst.id),
                )


def _companion(survey: Survey, body: Body, other: Body) -> bool:
    """Whether something may stand before a front: what is tied to it, and light seats."""
    if frozenset((body.id, other.id)) in survey.pairs:
        return True
    return other.item.category in ("stool", "pouf", "ottoman", "floor_cushion", "bean_bag") or (
        body.item.category in kinds.LOUNGE and other.item.category in kinds.COFFEE | kinds.LOUNGE
    )


def _seats(survey: Survey) -> Iterator[Finding]:
    """Seats at desks and tables that nobody can get into."""
    for seat in survey.standing:
        if not kinds.upright_seat(seat.item.category) or table_of(survey, seat) is None:
            continue
        table = table_of(survey, seat)
        area = strip(seat, "back", RISE)
        outside = 1.0 - float(area.intersection(survey.placed.floor).area) / max(1e-9, float(area.area))
        taken = [(s, b) for b, s in _inside(survey, area, seat) if b is not table and not seat_like(b)]
        total = outside + sum(s for s, _ in taken)
        if total <= 0.6:
            continue
        what = max(taken, key=lambda t: (t[0], t[1].id))[1].id if taken and taken[0][0] > outside else "the wall"
        names = (seat.id, *(b.id for _, b in taken))
        yield finding(
            "functionality",
            "cramped_seat",
            names,
            f"{what} leaves less than {RISE:g} m behind {seat.id}: {min(1.0, total):.0%} of it is taken",
            f"leave at least {RISE:g} m behind {seat.id}",
            call=moved(seat.id, *([table.id] if table else [])),
        )


def _doors(survey: Survey) -> Iterator[Finding]:
    known = survey.violated.get("blocked_opening", set())
    for door in survey.placed.doors:
        for other, share in _inside(survey, _before(door, ENTRY), None):
            if share > 0.12 and frozenset((other.id, door.item.id)) not in known:
                yield finding(
                    "layout",
                    "door_obstructed",
                    (other.id, door.item.id),
                    f"{other.id} takes {share:.0%} of the {ENTRY:g} m behind {door.item.id}",
                    f"move {other.id} away from {door.item.id}",
                    points=0.6 + share,
                    grave=share > 0.5,
                    call=related("away_from_door", other.id),
                )


def _windows(survey: Survey) -> Iterator[Finding]:
    known = survey.violated.get("blocked_opening", set())
    for window in survey.placed.windows:
        item, height = window.item, window.z[1] - window.z[0]
        for other, _ in _inside(survey, _before(window, LIGHT), None, head=10.0):
            category = other.item.category
            if other.item.mount == "wall":
                continue  # what hangs across a window is said below
            if category in kinds.SEE_THROUGH | kinds.WINDOW_WEAR or frozenset((other.id, item.id)) in known:
                continue
            wide = overlap(along(window, other)[0], (item.offset, item.offset + item.width))
            share = max(0.0, wide) / item.width * max(0.0, overlap(other.z, window.z)) / height
            if share > 0.2:
                yield finding(
                    "layout",
                    "dark_window",
                    (other.id, item.id),
                    f"{other.id}, {other.z[1]:.2f} m high, covers {share:.0%} of {item.id}",
                    f"move {other.id} away from {item.id}",
                    points=0.7 + share,
                    call=moved(other.id),
                )


def _hung(survey: Survey) -> Iterator[Finding]:
    """Things on a wall across a door or a window."""
    known = survey.violated.get("blocked_opening", set())
    for body in survey.bodies:
        if body.item.mount != "wall" or body.item.category in kinds.WINDOW_WEAR:
            continue
        for opening in survey.placed.openings:
            if frozenset((body.id, opening.item.id)) in known:
                continue
            span, (near, _) = along(opening, body)
            if not -0.2 <= near <= 0.25:
                continue
            wide = overlap(span, (opening.item.offset, opening.item.offset + opening.item.width))
            tall = overlap(body.z, opening.z)
            if wide > 0.05 and tall > 0.05:
                yield finding(
                    "layout",
                    "hung_over_opening",
                    (body.id, opening.item.id),
                    f"{body.id} hangs {wide:.2f} m across {opening.item.id}",
                    f"move {body.id} to a free wall",
                    call=moved(body.id),
                )


def _before(opening: Opening, depth: float) -> Any:
    import shapely

    return shapely.polygons(opening.wall.strip(opening.item.offset, opening.item.width, 0.0, depth))


def _inside(survey: Survey, area: Any, own: Body | None, head: float = HEAD) -> Iterator[tuple[Body, float]]:
    """Things on the floor or low on a wall that reach into an area, with the share of it that they take."""
    there = [
        b
        for b in survey.reaching(area)
        if b is not own and b.item.mount not in ("surface", "ceiling") and b.z[1] > FLAT and b.z[0] <= head
    ]
    for other, share in zip(there, survey.taken(area, there), strict=True):
        if share > 0.02:
            yield other, share
