"""Measures of stairs: steps, headroom, whether they fit their footprint and one can get on and off."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from sceneweaver.home import Stair

from ..profile import Rule
from .facts import PlanFacts
from .parts import RoomFacts
from .readings import Reading, fault, measure
from .regions import Box, Region
from .walls import metres, mm

FLIGHT = Fraction(25, 100)
"""How thick a flight is, for the headroom under stairs over stairs [m]."""

LEAST_STEP_OFF = 600
"""Width of a door or floor [mm] by which one gets on or off stairs."""


def _rooms(plan: PlanFacts, stair: Stair) -> tuple[RoomFacts, RoomFacts]:
    return plan.by_id[stair.lower], plan.by_id[stair.upper]


def _rise(plan: PlanFacts, stair: Stair) -> Fraction:
    lower, upper = _rooms(plan, stair)
    return plan.elevations[upper.storey] - plan.elevations[lower.storey]


def _name(stair: Stair) -> str:
    return f"stairs {stair.id} from {stair.lower} to {stair.upper}"


@measure("riser")
def riser(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Rise between the floors by the number of steps."""
    for stair in plan.stairs:
        yield Reading(
            (stair.lower, stair.upper), _rise(plan, stair) / stair.risers, f"{_name(stair)}: riser", "m"
        )  # fmt: skip


@measure("going")
def going(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Depth of a step, as given; `stair_run_lack` tells whether it fits."""
    for stair in plan.stairs:
        yield Reading((stair.lower, stair.upper), metres(mm(stair.going)), f"{_name(stair)}: going", "m")


@measure("stair_width")
def stair_width(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Width of a flight, as given."""
    for stair in plan.stairs:
        yield Reading((stair.lower, stair.upper), metres(mm(stair.width)), f"{_name(stair)}: width", "m")


@measure("headroom")
def headroom(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Over the last step the upper storey's ceiling; under stairs that go on from there, one flight's rise."""
    for stair in plan.stairs:
        lower, upper = _rooms(plan, stair)
        found = [plan.heights[upper.storey]]
        for above in plan.stairs:
            if above.lower == stair.upper:
                found.append(_rise(plan, above) - FLIGHT)
        yield Reading((lower.id, upper.id), min(found), f"{_name(stair)}: headroom", "m")


def _extents(stair: Stair) -> tuple[int, int]:
    """Length of the footprint along the first flight, and across [mm]."""
    xs, ys = [mm(x) for x, _ in stair.outline], [mm(y) for _, y in stair.outline]
    w, d = max(xs) - min(xs), max(ys) - min(ys)
    return (w, d) if abs(stair.up[0]) > abs(stair.up[1]) else (d, w)


@measure("stair_run_lack")
def stair_run_lack(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """By how much a footprint is too short or narrow: n risers of a flight have n - 1 goings between them.

    ``u``: two flights side by side, a landing as deep as a flight is wide at the far end. ``l``: two flights at a right
    angle, the landing in the corner between them.
    """
    for stair in plan.stairs:
        length, across = _extents(stair)
        going_mm, width, n = mm(stair.going), mm(stair.width), stair.risers
        if stair.shape == "straight":
            lack = max((n - 1) * going_mm - length, width - across)
        elif stair.shape == "u":
            lack = max(((n + 1) // 2 - 1) * going_mm + width - length, 2 * width - across)
        else:
            splits = ((k - 1, n - k - 1) for k in range(1, n))
            lack = min(max(a * going_mm + width - length, b * going_mm + width - across) for a, b in splits)
        yield Reading(
            (stair.lower, stair.upper), metres(max(0, lack)), f"{_name(stair)}: what its footprint lacks", "m"
        )  # fmt: skip


@measure("stairs_lack")
def stairs_lack(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Storeys with rooms that no stairs join to the next."""
    storeys = sorted({room.storey for room in plan.rooms})
    joined = {plan.by_id[stair.lower].storey for stair in plan.stairs}
    for storey in storeys[:-1]:
        if storey not in joined:
            name = plan.home.storeys[storey].id
            yield fault((), f"no stairs lead from storey {name} to the next; add stairwells and stairs")


@measure("stair_fault")
def stair_fault(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Stairs that do not lie in both stairwells, or that one cannot get on or off."""
    for stair in plan.stairs:
        lower, upper = _rooms(plan, stair)
        footprint = Region.of_outline([(mm(x), mm(y)) for x, y in stair.outline])
        for room in (lower, upper):
            over = (footprint - room.region).area
            if over:
                yield fault(
                    (room.id,), f"{_name(stair)}: {over / 1e6:.3f} m2 of the footprint lie outside of {room.id}"
                )
        starts, ends = _step_off(stair)
        for room, places, what in ((lower, starts, "first"), (upper, ends, "last")):
            if not any(_reached(plan, room, footprint, place) for place in places):
                line = f"{_name(stair)}: before the {what} step there is neither a door of {room.id} nor its floor"
                yield fault((room.id,), line)


def _step_off(stair: Stair) -> tuple[list[tuple[Box, str]], list[tuple[Box, str]]]:
    """Boxes of no depth, where the first step begins and the last one ends; more than one where the turn is free.

    Each with the side of the footprint that it lies on: of "w", "e", "s", "n".
    """
    xs, ys = [mm(x) for x, _ in stair.outline], [mm(y) for _, y in stair.outline]
    x0, y0, x1, y1 = min(xs), min(ys), max(xs), max(ys)
    along_x = abs(stair.up[0]) > abs(stair.up[1])
    forward = (stair.up[0] if along_x else stair.up[1]) > 0
    near, far = (("w", "e") if forward else ("e", "w")) if along_x else (("s", "n") if forward else ("n", "s"))
    width = mm(stair.width)

    def edge(side: str, low: int | None = None, high: int | None = None) -> tuple[Box, str]:
        a, b = (y0, y1) if side in "we" else (x0, x1)
        a, b = (a if low is None else low), (b if high is None else high)
        at = {"w": x0, "e": x1, "s": y0, "n": y1}[side]
        return ((at, a, at, b) if side in "we" else (a, at, b, at)), side

    low, high = (y0, y1) if along_x else (x0, x1)
    if stair.shape == "straight":
        return [edge(near)], [edge(far)]
    halves = [edge(near, low, low + width), edge(near, high - width, high)]
    if stair.shape == "u":
        return halves, halves
    sides = ("s", "n") if along_x else ("w", "e")
    return halves, [edge(side) for side in sides]


def _reached(plan: PlanFacts, room: RoomFacts, footprint: Region, place: tuple[Box, str]) -> bool:
    """Whether an edge of the footprint has floor of the room beside it, or a door of the room right behind it."""
    (x0, y0, x1, y1), side = place
    dx, dy = {"w": (-1, 0), "e": (1, 0), "s": (0, -1), "n": (0, 1)}[side]
    beside: Box = (
        min(x0, x0 + dx * LEAST_STEP_OFF),
        min(y0, y0 + dy * LEAST_STEP_OFF),
        max(x1, x1 + dx * LEAST_STEP_OFF),
        max(y1, y1 + dy * LEAST_STEP_OFF),
    )
    floor = Region.of_boxes([beside]) & (room.region - footprint)
    if floor.largest_square() >= LEAST_STEP_OFF:
        return True
    for door in plan.doors_of(room):
        wall, offset = door.place_in(room)
        if not wall.straight:
            continue
        (ax, ay), (bx, by) = wall.at(offset), wall.at(offset + door.width)
        if dx and ax == bx == x0:
            shared = min(max(ay, by), y1) - max(min(ay, by), y0)
        elif dy and ay == by == y0:
            shared = min(max(ax, bx), x1) - max(min(ax, bx), x0)
        else:
            continue
        if shared >= LEAST_STEP_OFF:
            return True
    return False
