"""The ways of a run of kitchen units around a corner of a room, and how wide its units are.

A run with a corner unit has two wings. The wing with a piece that wants a window takes the wall of one, and what stands
between it and the corner is as wide as brings it before the window's middle. Poses stay the search's.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from sceneweaver.geometry.angles import cross
from sceneweaver.scene import Relation, Room

from .program import Wanted

FRAME = 0.3
"""Wall [m] that stays free between a run and a door."""

REACH = 0.75
"""Distance [m] of a door from a corner up to which its leaf swings before what stands at the other wall there."""

SIDE_OF_WINDOW = 0.08
"""Wall [m] between a window and a hung cabinet."""

TIGHT = {"gap": [0.0, 0.012], "offset": 0.012, "degrees": 1.0}
"""How exactly the pieces of a run have to fit: what looks like one piece of furniture has no steps."""

ROUNDING = 0.005
"""Length [m] that the rounded widths of a wing may be too much."""

SQUARE = 0.98
"""Sine of the angle between two walls from which on a run goes around their corner."""

FILLER = 0.6
"""Width [m] of what stands between the corner and the sink where there is no window."""

NO_WINDOW, COOK_AT_WINDOW = 1.0, 1.5
"""Metres off the middle of the window that count as much as a sink at no window, and as a stove at one."""

JOINT = 0.006
"""Length [m] that a joint between two pieces takes at most."""

Variant = tuple[Relation, ...]
Widths = Callable[[Wanted], tuple[float, float]]


@dataclass(frozen=True)
class CornerRun:
    """One way around one corner: ``wall`` starts there, and ``ahead`` stand along it from the corner on, ``turned``
    along the wall before it; ``widths`` [m] are those of all pieces, ``cost`` is what speaks against it."""

    corner: Wanted
    wall: int
    before: int
    ahead: tuple[Wanted, ...]
    turned: tuple[Wanted, ...]
    widths: dict[str, float]
    cost: float

    @property
    def relations(self) -> Variant:
        """Where the corner unit is, and who is next to whom."""
        leader = self.corner.id
        found = [
            Relation(
                type="against_wall",
                subject=leader,
                target=f"wall:{self.wall}",
                params={"gap": TIGHT["gap"], "degrees": TIGHT["degrees"]},
            ),
            Relation(
                type="side_against_wall", subject=leader, target=f"wall:{self.before}", params={"gap": TIGHT["gap"]}
            ),
        ]
        for wing, side in ((self.ahead, "right"), (self.turned, "left")):
            for a, b in itertools.pairwise((self.corner, *wing)):
                found.append(Relation(type="run_on", subject=b.id, target=a.id, params={"side": side, **TIGHT}))
        return tuple(found)

    def spans(self) -> dict[str, tuple[int, float, float]]:
        """For each piece its wall and the distances [m] from the corner between which it stands."""
        found = {self.corner.id: (self.wall, 0.0, self.widths[self.corner.id])}
        for wing, wall in ((self.ahead, self.wall), (self.turned, self.before)):
            at = self.widths[self.corner.id]
            for one in wing:
                found[one.id] = (wall, at, at + self.widths[one.id])
                at += self.widths[one.id]
        return found


def corner_runs(pieces: Sequence[Wanted], room: Room, widths: Widths | None = None) -> list[CornerRun]:
    """All ways to lead a run with a corner unit around a corner of the room, the best first; empty where none fits.

    Args:
        pieces: of the run, in order.
        room: the empty room.
        widths: the least and largest width [m] of a piece; those that its item says if None.
    """
    at = next((k for k, one in enumerate(pieces) if has_place(one, "in_corner")), None)
    if at is None:
        return []
    low, high = tuple(reversed(pieces[:at])), tuple(pieces[at + 1 :])
    found = []
    for wall in room.walls:
        before = room.walls[wall.index - 1]
        if cross(before.along, wall.along) < SQUARE:
            continue
        for ahead, turned in ((high, low), (low, high)):
            one = _around(pieces[at], room, wall.index, before.index, ahead, turned, widths or said_widths)
            if one is not None:
                found.append(one)
    return sorted(found, key=lambda run: (round(run.cost, 2), run.wall))


def run_of(wanted: Sequence[Wanted]) -> list[Wanted]:
    """The pieces of the run in order, if items make one."""
    run = [w for w in wanted if w.item and w.item.row == "run" and w.mount == "floor"]
    return sorted(run, key=lambda w: (w.item.run if w.item and w.item.run is not None else 0.5, w.number))


def has_place(one: Wanted, type: str) -> bool:
    """Whether a relation of that type stands among the places of its item."""
    return one.item is not None and any(place.type == type for place in one.item.place)


def _around(
    corner: Wanted,
    room: Room,
    wall: int,
    before: int,
    ahead: tuple[Wanted, ...],
    turned: tuple[Wanted, ...],
    range_of: Widths,
) -> CornerRun | None:
    """The run around one corner; None where a wing is longer than its wall."""
    widths = {corner.id: corner.asset.size[1]}
    cost = 0.0
    for wing, index, forward in ((ahead, wall, True), (turned, before, False)):
        free, windows = _free(room, index, forward), windows_from(room, index, forward)
        fitting = _wing_widths(wing, corner.asset.size[1], free, windows, range_of)
        if fitting is None:
            return None
        widths |= fitting[0]
        cost += fitting[1]
    return CornerRun(corner, wall, before, ahead, turned, widths, cost)


def _wing_widths(
    wing: Sequence[Wanted], start: float, free: float, windows: Sequence[tuple[float, float]], range_of: Widths
) -> tuple[dict[str, float], float] | None:
    """Widths [m] of the pieces of a wing from the corner on, and what speaks against it; None where it is too long."""
    ranges = {one.id: range_of(one) for one in wing}
    widths = {id: low for id, (low, _) in ranges.items()}
    spare = free - start - sum(widths.values()) - JOINT * len(wing)
    if spare < -ROUNDING:
        return None

    def widen(pieces: Sequence[Wanted], more: float) -> None:
        nonlocal spare
        more = min(more, spare)
        for k, one in enumerate(pieces):
            growth = max(0.0, min(ranges[one.id][1] - widths[one.id], more / (len(pieces) - k)))
            widths[one.id] += growth
            more -= growth
            spare -= growth

    def end_of(k: int) -> float:
        return start + sum(widths[one.id] for one in wing[:k])

    cost = 0.0
    eyed = next((k for k, one in enumerate(wing) if has_place(one, "at_window")), None)
    if eyed is not None:
        own = widths[wing[eyed].id]
        middle = sum(windows[0]) / 2 if windows else None
        widen(wing[:eyed], FILLER - end_of(eyed) + start if middle is None else middle - own / 2 - end_of(eyed))
        cost = NO_WINDOW if middle is None else abs(end_of(eyed) + own / 2 - middle)
        widen(wing[eyed + 1 :], spare)
    else:
        widen(wing, spare)
        for k, one in enumerate(wing):
            cooks = one.item is not None and one.item.top == "stove_top"
            cost += COOK_AT_WINDOW * (cooks and overlaps((end_of(k), end_of(k + 1)), windows))
    return {id: round(width, 3) for id, width in widths.items()}, cost


def said_widths(one: Wanted) -> tuple[float, float]:
    """Widths [m] that a piece may have: those of its item, or the one that it has."""
    said = one.item.size[1] if one.item is not None and one.asked is None else None
    return said or drawn_widths(one)


def drawn_widths(one: Wanted) -> tuple[float, float]:
    """The width [m] that a piece has, twice."""
    return one.asset.size[1], one.asset.size[1]


def _free(room: Room, wall: int, forward: bool) -> float:
    """Length [m] of a wall from its start, or backward from its end, up to a door, the leaf of one or the next wall."""
    walls = room.walls
    length = walls[wall].length
    ends = [d.offset if forward else length - d.offset - d.width for d in room.doors if d.wall == wall]
    after = walls[(wall + (1 if forward else -1)) % len(walls)]
    for door in room.doors:
        beside = door.offset if forward else after.length - door.offset - door.width
        if door.wall == after.index and beside < REACH and door.swing.startswith("in"):
            ends.append(length - door.width)
    return min([length - 0.01, *(end - FRAME for end in ends)])


def windows_from(room: Room, wall: int, forward: bool) -> list[tuple[float, float]]:
    """The windows of a wall as distances [m] from its start, or from its end, the nearest first."""
    length = room.walls[wall].length
    found = [
        (w.offset, w.offset + w.width) if forward else (length - w.offset - w.width, length - w.offset)
        for w in room.windows
        if w.wall == wall
    ]
    return sorted(found)


def overlaps(span: tuple[float, float], others: Sequence[tuple[float, float]]) -> bool:
    """Whether a stretch of wall [m] comes near another one."""
    return any(span[0] < b + SIDE_OF_WINDOW and span[1] > a - SIDE_OF_WINDOW for a, b in others)
