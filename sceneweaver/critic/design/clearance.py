"""Room to use things: behind seats and counters, before ovens, boards, wardrobes, screens and windows."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..needs import seat_like, table_of
from ..survey import FLAT, Survey
from .breach import breach
from .measure import along, applies, clear_depth, floor_of_kind, inside, movable, named, names, overlap, strip

CRAMPED = 0.45
"""Depth [m] behind a seat below which nobody gets up from it; from there to the rule's depth it counts by half."""

OPENED = named(
    "wardrobe fridge side_by_side_fridge freezer stove oven_tower dishwasher washing_machine dryer linen_cabinet"
    " vending_machine photocopier"
)
"""What is opened or used by someone who stands before it."""

BROWSED = named("bookcase display_cabinet library_shelf wine_rack pantry_shelf metal_shelf")
"""What someone takes things from: half of the depth is enough."""

BOARDS = frozenset(("whiteboard", "blackboard", "notice_board"))

SCREENS = frozenset(("tv", "projector_screen"))

TAKEN = 0.08
"""Share of the room before a thing that may be taken."""

LOW = 0.35
"""Height [m] over the lower edge of a board or screen up to which something below it covers none of it."""

OFF_WALL = 0.3
"""Gap [m] to a wall below which a table that people sit around is pushed against it."""

BELOW_WINDOWS = kinds.SEE_THROUGH | kinds.WINDOW_WEAR | kinds.BEDS | kinds.LONG_BEDS
"""What may stand or hang before a window."""

DARK = 0.2
"""Share of a window from which what covers it takes its light."""

APART = kinds.SEATED_AT | frozenset(("activity_table", "kids_table", "standing_mirror"))
"""What stands apart from all that is none of its group."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for the room that things need."""
    yield from _behind_seats(survey)
    yield from _behind_counters(survey)
    yield from _before_use(survey)
    yield from _below(survey)
    yield from _windows(survey)
    yield from _tables_at_walls(survey)
    yield from _apart(survey)


def _behind_seats(survey: Survey) -> Iterator[Finding]:
    if not applies(survey, "behind_seats"):
        return
    clear = limit("behind_seats", "clear")
    tight: dict[bool, list[tuple[float, Body, Body, Body | None]]] = defaultdict(list)
    for seat in survey.standing:
        if not kinds.upright_seat(seat.item.category) or seat.item.category == "stool":
            continue
        table = table_of(survey, seat)
        if table is None:
            continue
        free, other = clear_depth(survey, seat, "back", clear, lambda b, t=table: b is t)
        if free < clear - 0.15:
            tight[free < CRAMPED].append((free, seat, table, other))
    for cramped, rows in tight.items():
        free, seat, _, other = min(rows, key=lambda r: (round(r[0], 3), r[1].id))
        tables = dict.fromkeys(t.id for *_, t, _ in rows)
        yield breach(
            "behind_seats",
            (*(s.id for _, s, *_ in rows), *dict.fromkeys(o.id for *_, o in rows if o is not None), *tables),
            f"{free:.2f} m behind {seat.id} to {'the wall' if other is None else other.id}"
            + (f", and little behind {len(rows) - 1} more seats" if len(rows) > 1 else ""),
            measured=free,
            allowed=(clear, None),
            weight=(1.0 if cramped else 0.5) * min(2.5, 0.7 + 0.3 * len(tables)),
            suggestion=f"leave {clear:g} m behind {names(s for _, s, *_ in rows)}",
        )


def _behind_counters(survey: Survey) -> Iterator[Finding]:
    clear = limit("behind_counter", "clear")
    for counter in floor_of_kind(survey, ("bar_counter", "reception_desk", "host_stand")):
        free, other = clear_depth(survey, counter, "back", clear, movable)
        if free < clear - 0.05:
            what = "the wall" if other is None else other.id
            yield breach(
                "behind_counter",
                (counter.id, *([other.id] if other else [])),
                f"{free:.2f} m behind {counter.id} to {what}: staff cannot stand there",
                measured=free,
                allowed=(clear, None),
                suggestion=f"leave {clear:g} m behind {counter.id}",
            )


def _before_use(survey: Survey) -> Iterator[Finding]:
    clear = limit("before_use", "clear")
    for body in floor_of_kind(survey, OPENED, BROWSED):
        depth = clear if body.item.category in OPENED else clear / 2
        area = strip(body, "front", depth, 0.9)
        taken = [(b, s) for b, s in inside(survey, area, (body,)) if not movable(b) and not _carried(survey, b, body)]
        total = sum(s for _, s in taken)
        if total > 2 * TAKEN:
            worst = max(taken, key=lambda t: (t[1], t[0].id))[0]
            yield breach(
                "before_use",
                (body.id, *(b.id for b, _ in taken)),
                f"{worst.id} takes {total:.0%} of the {depth:g} m before {body.id}",
                measured=total,
                allowed=(None, 2 * TAKEN),
                weight=min(1.0, 0.4 + total),
                suggestion=f"move {worst.id} away from the front of {body.id}",
            )


def _carried(survey: Survey, body: Body, base: Body) -> bool:
    return frozenset((body.id, base.id)) in survey.pairs


def _below(survey: Survey) -> Iterator[Finding]:
    """What stands between a board or screen on a wall and those who write on it or look at it."""
    for rule, wanted in (("before_use", BOARDS), ("before_focus", SCREENS)):
        clear = limit(rule, "clear")
        for board in survey.of_kind(wanted):
            if board.item.mount != "wall":
                continue
            area = strip(board, "front", clear, 0.95)
            standing = [
                (b, s)
                for b, s in inside(survey, area, low=0.25)
                if s > TAKEN and not movable(b) and not _holds(b, board) and not seat_like(b)
            ]
            if standing:
                share = sum(s for _, s in standing)
                yield breach(
                    rule,
                    (board.id, *(b.id for b, _ in standing)),
                    f"{names(b for b, _ in standing)} takes {share:.0%} of the {clear:g} m before {board.id}",
                    measured=share,
                    allowed=(None, TAKEN),
                    weight=min(1.0, 0.5 + share),
                    suggestion=f"move {names(b for b, _ in standing)} away from {board.id}",
                )


def _holds(body: Body, board: Body) -> bool:
    """Whether a screen hangs over it as over its stand."""
    return board.item.category in SCREENS and body.item.category in (
        *("tv_stand", "sideboard", "low_bookcase", "fireplace", "dresser", "tallboy", "desk", "chest", "rug"),
    )


def _windows(survey: Survey) -> Iterator[Finding]:
    slack = limit("low_below_windows", "above_sill")
    for window in survey.placed.windows:
        u = (window.item.offset, window.item.offset + window.item.width)
        for body in survey.standing:
            low = body.item.category in BELOW_WINDOWS or body.z[1] <= window.z[0] + slack
            if low and body.item.category != "laundry_hamper":
                continue
            (a, b), (near, _) = along(window, body)
            wide = overlap(u, (a, b))
            if near > limit("before_use", "window") or wide < 0.15 or movable(body):
                continue
            high = max(0.0, min(body.z[1], window.z[1]) - window.z[0]) / (window.z[1] - window.z[0])
            if high * wide / window.item.width > DARK:
                continue  # takes its light, which another check says
            yield breach(
                "low_below_windows",
                (body.id, window.item.id),
                f"{body.id}, {body.z[1]:.2f} m high, stands {wide:.2f} m wide before {window.item.id}",
                measured=body.z[1],
                allowed=(None, window.z[0]),
                suggestion=f"move {body.id} away from {window.item.id}",
            )


def _tables_at_walls(survey: Survey) -> Iterator[Finding]:
    if not applies(survey, "table_off_walls"):
        return
    least = limit("table_off_walls", "gap")
    for table in floor_of_kind(survey, kinds.DINING):
        gap = float(survey.wall_gaps[table.index])
        round_ = "round" in table.item.category
        seats = [b for b, _ in survey.near(table, 0.9) if seat_like(b) and table_of(survey, b) is table]
        if gap >= least or len(seats) < (3 if round_ else 4):
            continue
        yield breach(
            "table_off_walls",
            (table.id,),
            f"{table.id} for {len(seats)} stands {gap:.2f} m from a wall: its seats crowd the other sides",
            measured=gap,
            allowed=(least, None),
            suggestion=f"move {table.id} at least {least:g} m off the walls",
        )


def _apart(survey: Survey) -> Iterator[Finding]:
    """Tables of different groups that touch, seats of one at another, and things that are rammed together."""
    if not applies(survey, "pieces_apart"):
        return
    least = limit("pieces_apart", "gap")
    for body in floor_of_kind(survey, APART, ("laundry_hamper",)):
        seats: list[tuple[float, Body]] = []
        for other, gap in survey.near(body, 3 * least):
            if other.item.mount != "floor" or other.z[1] <= FLAT or _one_group(survey, body, other):
                continue
            both = body.item.category in kinds.SEATED_AT and other.item.category in kinds.SEATED_AT
            rammed = body.item.category in ("standing_mirror", "laundry_hamper") and "nightstand" in other.item.category
            if kinds.upright_seat(other.item.category) and table_of(survey, other) not in (body, None):
                seats.append((gap, other))
            if (both and body.index < other.index) or (rammed and gap < least):
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
