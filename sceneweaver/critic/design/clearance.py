"""Room to use things: behind seats and counters, before ovens, boards, wardrobes, screens and windows."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.knowledge.kin import at_home_in
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..needs import seat_like, table_of
from ..survey import Survey
from .breach import breach
from .measure import along, applies, clear_depth, inside, movable, named, names, overlap, strip

CRAMPED = 0.45
"""Depth [m] behind a seat below which nobody gets up from it; from there to the rule's depth it counts by half."""

STEPPED_OVER = 0.2
"""Height [m] up to which a thing behind a seat is pushed aside with a foot: toys, shoes."""

OPENED = named(
    "wardrobe fridge side_by_side_fridge freezer stove oven_tower dishwasher washing_machine dryer linen_cabinet"
    " vending_machine photocopier"
)
"""What is opened or used by someone who stands before it."""

BROWSED = named("bookcase low_bookcase display_cabinet library_shelf wine_rack pantry_shelf metal_shelf")
"""What someone takes things from, for which less depth is enough."""

BOARDS = frozenset(("whiteboard", "blackboard", "notice_board"))

BINS = named("wastebasket trash_can pedal_bin recycling_bin")

SCREENS = frozenset(("tv", "projector_screen"))

TAKEN = 0.08
"""Share of the room before a thing that may be taken."""

BELOW_WINDOWS = kinds.SEE_THROUGH | kinds.WINDOW_WEAR | kinds.BEDS | kinds.LONG_BEDS | at_home_in("gym")
"""What may stand or hang before a window."""

DARK = 0.2
"""Share of a window from which what covers it takes its light."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for the room that things need."""
    yield from _behind_seats(survey)
    yield from _behind_counters(survey)
    yield from _before_use(survey)
    yield from _below(survey)
    yield from _windows(survey)


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
        free, other = clear_depth(survey, seat, "back", clear, lambda b, t=table: b is t or b.z[1] < STEPPED_OVER)
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
    for counter in survey.on_floor(("bar_counter", "reception_desk", "host_stand")):
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
    shelf = limit("before_use", "shelf")
    for body in survey.on_floor(BROWSED):
        free, other = clear_depth(survey, body, "front", shelf, movable)
        if free < shelf - 0.05 and other is not None and frozenset((other.id, body.id)) not in survey.pairs:
            yield breach(
                "before_use",
                (body.id, other.id),
                f"{free:.2f} m before {body.id} to {other.id}",
                measured=free,
                allowed=(shelf, None),
                weight=0.8,
                suggestion=f"leave {shelf:g} m before {body.id}",
            )
    for body in survey.on_floor(OPENED):
        area = strip(body, "front", clear, 0.9)
        taken = [
            (b, s)
            for b, s in inside(survey, area, (body,))
            if not movable(b) and frozenset((b.id, body.id)) not in survey.pairs
        ]
        total = sum(s for _, s in taken)
        if total > 2 * TAKEN:
            worst = max(taken, key=lambda t: (t[1], t[0].id))[0]
            yield breach(
                "before_use",
                (body.id, *(b.id for b, _ in taken)),
                f"{worst.id} takes {total:.0%} of the {clear:g} m before {body.id}",
                measured=total,
                allowed=(None, 2 * TAKEN),
                weight=min(1.0, 0.4 + total),
                suggestion=f"move {worst.id} away from the front of {body.id}",
            )


def _below(survey: Survey) -> Iterator[Finding]:
    """What stands between a board or screen on a wall and those who write on it or look at it."""
    most = TAKEN / 2  # nobody puts a bin there
    for rule, wanted in (("before_use", BOARDS), ("before_focus", SCREENS)):
        clear = limit(rule, "clear")
        for board in survey.of_kind(wanted):
            if board.item.mount != "wall":
                continue
            area = strip(board, "front", clear, 0.95)
            standing = [
                (b, s)
                for b, s in inside(survey, area, low=0.25)
                if s > (most if b.item.category in BINS else TAKEN)
                and not movable(b)
                and not _holds(b, board)
                and not seat_like(b)
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
