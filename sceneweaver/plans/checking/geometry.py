"""Measures of the geometry: rooms that overlap, walls that are too thin, places that are neither room nor wall."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations

from ..profile import Rule
from .facts import PlanFacts
from .parts import RoomFacts
from .readings import Reading, fault, measure
from .regions import Region, components
from .walls import Wall, metres

OVERHANG = 1500
"""By how much a storey may reach over the one below [mm] (profile row storey), beside the thickness of its walls."""


def pairs(plan: PlanFacts, reach: int) -> Iterator[tuple[RoomFacts, RoomFacts]]:
    """Pairs of rooms of a storey whose boxes are nearer than ``reach`` on both axes."""
    for a, b in combinations(plan.rooms, 2):
        if a.storey != b.storey:
            continue
        (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a.box, b.box
        if max(ax0 - bx1, bx0 - ax1) < reach and max(ay0 - by1, by0 - ay1) < reach:
            yield a, b


@measure("overlap")
def overlap(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Pairs of rooms whose insides meet."""
    for a, b in pairs(plan, 0):
        shared = shared_area(a, b)
        if shared:
            yield fault((a.id, b.id), f"{a.id} and {b.id}: they share {float(shared):.4f} m2 of floor; move them apart")


def shared_area(a: RoomFacts, b: RoomFacts) -> Fraction:
    """What two rooms share [m2]; between oblique walls less than 100 mm2 are rounding."""
    if a.straight and b.straight:
        return Fraction((a.region & b.region).area, 1_000_000)
    shared = a.polygon.intersection(b.polygon).area
    return Fraction(round(shared), 1_000_000) if shared > 100 else Fraction(0)


@measure("wall_lack")
def wall_lack(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Pairs of rooms nearer than the inner wall is thick, where no open passage joins them."""
    for a, b in pairs(plan, plan.inner):
        if shared_area(a, b):
            continue  # told as an overlap
        gap = thinnest(plan, a, b)
        if gap is not None and gap < plan.inner:
            need = f"at least {plan.inner / 1000:.3f} m"
            yield fault((a.id, b.id), f"{a.id} and {b.id}: the wall between them is {gap / 1000:.3f} m thick; {need}")


def thinnest(plan: PlanFacts, a: RoomFacts, b: RoomFacts) -> float | None:
    """Least thickness of the wall between two rooms beside open passages [mm]; None: they are joined all along."""
    if not (a.straight and b.straight):
        gap = a.polygon.distance(b.polygon)
        joined = any(d.part.kind == "open" and set(d.rooms) == {a.id, b.id} for d in plan.doors)
        return None if joined else round(gap)  # corners of oblique walls are whole millimetres, distances are not
    passages = [d for d in plan.doors if d.part.kind == "open" and set(d.rooms) == {a.id, b.id}]
    if not passages:
        return min(max(_gap(p, q, 0), _gap(p, q, 1), 0) for p in a.region.boxes for q in b.region.boxes)
    # Walls that face each other, without the passages; and corners that come near each other over the diagonal.
    found: list[int] = []
    for wall in a.walls:
        open_spans = [(offset, offset + d.width) for d in passages for w, offset in [d.place_in(a)] if w is wall]
        for far in b.walls:
            span = facing_span(wall, far)
            if span is not None and _remains(span[1:], open_spans):
                found.append(span[0])
    for (px, py), (qx, qy) in ((p, q) for p in a.outline for q in b.outline):
        near = max(abs(px - qx), abs(py - qy))
        if near < plan.inner and not _at_passage(plan, a, (px, py), near):
            found.append(near)
    return min(found, default=None)


def _gap(p: tuple[int, ...], q: tuple[int, ...], axis: int) -> int:
    return max(p[axis] - q[axis + 2], q[axis] - p[axis + 2])


def facing_span(wall: Wall, far: Wall) -> tuple[int, int, int] | None:
    """(distance, first, last offset along ``wall``) of where two walls face each other; None: nowhere."""
    (ax, ay), (nx, ny) = ([round(v) for v in pair] for pair in (wall.along, wall.outward))
    bx, by = (round(v) for v in far.along)
    if (bx, by) != (-ax, -ay):
        return None
    gap = (far.start[0] - wall.start[0]) * nx + (far.start[1] - wall.start[1]) * ny
    ends = [(p[0] - wall.start[0]) * ax + (p[1] - wall.start[1]) * ay for p in (far.end, far.start)]
    first, last = max(0, ends[0]), min(round(wall.length), ends[1])
    return (gap, first, last) if gap >= 0 and first < last else None


def _remains(span: tuple[int, int], taken: list[tuple[int, int]]) -> bool:
    """Whether something of a span is left beside others."""
    at = span[0]
    for low, high in sorted(taken):
        if low > at:
            return True
        at = max(at, high)
        if at >= span[1]:
            return False
    return at < span[1]


def _at_passage(plan: PlanFacts, a: RoomFacts, corner: tuple[int, int], near: int) -> bool:
    """Whether a corner lies at the edge of an open passage: there the wall has an end."""
    for door in plan.doors_of(a):
        if door.part.kind != "open":
            continue
        wall, offset = door.place_in(a)
        for at in (offset, offset + door.width):
            x, y = wall.at(at)
            if max(abs(x - corner[0]), abs(y - corner[1])) <= near:
                return True
    return False


@measure("void")
def void(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """The largest square in places that rooms enclose, or that lie between them and the envelope's walls.

    What is no further than half an outer wall from a room counts as wall.
    """
    for storey in sorted({room.storey for room in plan.rooms}):
        rooms = plan.on_storey(storey)
        floors = Region.of_boxes(box for room in rooms for box in room.region.boxes)
        half = plan.outer // 2
        free = floors.grown(half).holes()
        if plan.envelope is not None:
            inner = [(round(x * 1000), round(y * 1000)) for x, y in plan.envelope.inner]
            free = (Region.of_outline(inner) - floors.grown(half)) | free
        if free.empty:
            continue
        around = free.grown(half) - floors
        labels = components(around.cells)
        for label in range(1, labels.max() + 1):
            part = Region(around.xs, around.ys, labels == label)
            x0, y0, x1, y1 = part.bounds
            where = f"around ({(x0 + x1) / 2000:.2f}, {(y0 + y1) / 2000:.2f})"
            near = tuple(r.id for r in rooms if any(_touches(box, part.bounds, plan.outer) for box in r.region.boxes))
            side = part.largest_square()
            yield Reading(near, metres(side), f"a place {where} that is no room, {side / 1000:.2f} m wide: width", "m")


def _touches(p: tuple[int, ...], q: tuple[int, ...], reach: int) -> bool:
    return _gap(p, q, 0) < reach and _gap(p, q, 1) < reach


@measure("storey_fault")
def storey_fault(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Rooms that reach further over the storey below than `OVERHANG` and the thickness of an outer wall."""
    for storey in sorted({room.storey for room in plan.rooms})[1:]:
        below = Region.of_boxes(box for room in plan.on_storey(storey - 1) for box in room.region.boxes)
        if below.empty:
            continue
        held = below.grown(OVERHANG + plan.outer)
        for room in plan.on_storey(storey):
            over = (room.region - held).area
            if over:
                line = (
                    f"{room.id}: {over / 1e6:.2f} m2 of it reach more than {OVERHANG / 1000:g} m over the storey below"
                )
                yield fault((room.id,), line)
