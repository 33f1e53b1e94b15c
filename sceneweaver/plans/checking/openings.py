"""Measures of doors and windows: where they lead, what is before them, whether leaves swing freely."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from ..profile import DOORS, Rule
from ..room_types import selects
from .facts import PlanFacts
from .parts import OBLIQUE, DoorFacts, OpeningFacts, RoomFacts
from .quarters import Quarter
from .readings import Reading, fault, measure
from .regions import Region
from .walls import Wall, metres

if TYPE_CHECKING:
    from shapely import Polygon

FREE_BEFORE_WINDOW = 1000
"""What a window has before the outer wall [mm] (profile row windows-outside)."""

FREE_BEFORE_ENTRANCE = 600
"""What the door of an entrance has before the outer wall [mm]."""

LEAF = tuple[Quarter | None, Wall, int, int, bool]


@measure("door_fault")
def door_fault(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Doors that do not lead from the one room straight into the other, or out of the home."""
    for door in plan.doors:
        name = f"door {door.id} of {door.room.id}"
        if door.other is None:
            if door.room.outdoor:
                continue
            met = _indoors_at(plan, door, plan.outer + FREE_BEFORE_ENTRANCE)
            if met:
                reach = (plan.outer + FREE_BEFORE_ENTRANCE) / 1000
                line = f"{name}: it leads out, but {' and '.join(met)} lies within {reach:.2f} m"
                yield fault((door.room.id, *met), line)
        elif door.far is None:
            line = (
                f"{name}: no wall of {door.other.id} lies behind it over its whole width of {door.width / 1000:.3f} m"
            )
            yield fault(door.rooms, line)
        else:
            strip = door.wall.strip(door.offset, door.width, 0, door.far[2])
            between = plan.on_storey(door.room.storey) if door.far[2] else []
            met = sorted(room.id for room in between if room.meets(strip))
            if met:
                yield fault((*door.rooms, *met), f"{name} to {door.other.id}: {' and '.join(met)} lies in its way")


def _indoors_at(plan: PlanFacts, opening: OpeningFacts, depth: int) -> list[str]:
    """Ids of the rooms indoors that lie before an opening within that depth."""
    strip = opening.wall.strip(opening.offset, opening.width, 0, depth)
    rooms = plan.on_storey(opening.room.storey, outdoor=False)
    return sorted(room.id for room in rooms if room.meets(strip))


@measure("window_fault")
def window_fault(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Windows with a room before them, and such as lie in a party wall of the envelope."""
    for window in plan.windows:
        name = f"window {window.id} of {window.room.id}"
        met = [] if window.room.outdoor else _indoors_at(plan, window, plan.outer + FREE_BEFORE_WINDOW)
        if met:
            reach = (plan.outer + FREE_BEFORE_WINDOW) / 1000
            yield fault((window.room.id, *met), f"{name}: {' and '.join(met)} lies within {reach:.2f} m before it")
        elif plan.envelope is not None:
            wall = _envelope_wall(plan, window)
            if wall not in plan.envelope.open_walls:
                which = "no wall of the envelope" if wall is None else f"wall {wall} of the envelope, which has none"
                yield fault((window.room.id,), f"{name}: it lies in {which}")


def _envelope_wall(plan: PlanFacts, opening: OpeningFacts) -> int | None:
    """The wall of the envelope through which an opening looks, of those as far as the outer wall is thick."""
    assert plan.envelope is not None
    outline = [(round(x * 1000), round(y * 1000)) for x, y in plan.envelope.outline]
    (ox, oy), half = opening.wall.outward, opening.width // 2
    x, y = opening.wall.at(opening.offset + half)
    for i, a in enumerate(outline):
        outer = Wall(a, outline[(i + 1) % len(outline)])
        if abs(outer.outward[0] - ox) + abs(outer.outward[1] - oy) > 1e-9:
            continue
        gap = (a[0] - x) * ox + (a[1] - y) * oy
        along = (x - a[0]) * outer.along[0] + (y - a[1]) * outer.along[1]
        if 0 <= gap <= plan.outer and half <= along <= outer.length - half:
            return i
    return None


@measure("opening_fault")
def opening_fault(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Openings of one wall that overlap, over the ends of their wall, or higher than the room."""
    for room in plan.rooms:
        placed = [(door, *door.place_in(room)) for door in plan.doors_of(room) if door.other is None or door.far]
        placed += [(window, window.wall, window.offset) for window in plan.windows_of(room)]
        for opening, wall, offset in placed:
            slack = 0 if wall.straight else OBLIQUE
            if offset < -slack or offset + opening.width > wall.length + slack:
                yield fault((room.id,), f"{opening.id} of {room.id}: it reaches over the end of its wall")
            if opening.top > room.height and not room.outdoor:
                line = f"{float(opening.top):.3f} m; the room has {float(room.height):.3f} m"
                yield fault((room.id,), f"{opening.id} of {room.id}: its top is at {line}")
        for (a, wall, start), (b, other, begin) in combinations(placed, 2):
            apart = start + a.width <= begin or begin + b.width <= start or a.top <= b.bottom or b.top <= a.bottom
            if wall is other and not apart:
                both = min(start + a.width, begin + b.width) - max(start, begin)
                yield fault((room.id,), f"{a.id} and {b.id} of {room.id}: they share {both / 1000:.3f} m of a wall")


@measure("leaf_fault")
def leaf_fault(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Leaves that meet a wall, stairs or each other while they swing by a quarter of a circle."""
    for room in plan.rooms:
        swung = [(door, leaf) for door in plan.doors_of(room) if door.swings_into is room for leaf in door.leaves()]
        stairs = [part for part in plan.stairs if room.id in (part.lower, part.upper)]
        for door, leaf in swung:
            if not _in_room(room, leaf):
                line = f"the leaf of {leaf[3] / 1000:.3f} m has no quarter of a circle free"
                yield fault((room.id,), f"door {door.id} into {room.id}: {line}")
            for stair in stairs:
                steps = [(round(x * 1000), round(y * 1000)) for x, y in stair.outline]
                if _meets_region(leaf, Region.of_outline(steps)):
                    yield fault((room.id,), f"door {door.id} into {room.id}: its leaf swings over stairs {stair.id}")
        for (first, a), (second, b) in combinations(swung, 2):
            if first is not second and _leaves_meet(a, b):
                yield fault((room.id,), f"doors {first.id} and {second.id}: their leaves meet in {room.id}")


def _in_room(room: RoomFacts, leaf: LEAF) -> bool:
    quarter = leaf[0]
    if quarter is None or not room.straight:
        return _sector(leaf).difference(room.polygon.buffer(1.0)).area < 1.0
    x0, y0, x1, y1 = quarter.box
    outside = Region.of_boxes([(x0, y0, x1, y1)]) - room.region
    return not quarter.meets_any(outside.boxes)


def _meets_region(leaf: LEAF, region: Region) -> bool:
    quarter = leaf[0]
    if quarter is not None:
        return quarter.meets_any(region.boxes)
    import shapely

    return _sector(leaf).intersection(shapely.union_all([shapely.box(*box) for box in region.boxes])).area > 100


def _leaves_meet(a: LEAF, b: LEAF) -> bool:
    if a[0] is not None and b[0] is not None:
        return a[0].meets(b[0])
    return _sector(a).intersection(_sector(b)).area > 100


def _sector(leaf: LEAF) -> Polygon:
    """The quarter of a leaf in an oblique wall, as a polygon within it [mm]."""
    import math

    import shapely

    _, wall, at, radius, forward = leaf
    (x, y), (ax, ay), (nx, ny) = wall.at(at), wall.along, wall.outward
    way = 1 if forward else -1
    turns = [k * math.pi / 32 for k in range(17)]
    arc = [
        (
            x + radius * (math.cos(t) * ax * way - math.sin(t) * nx),
            y + radius * (math.cos(t) * ay * way - math.sin(t) * ny),
        )
        for t in turns
    ]
    return shapely.Polygon([(x, y), *arc])


# ---- sizes of doors


def chosen_doors(plan: PlanFacts, rule: Rule) -> Iterator[tuple[str, list[DoorFacts]]]:
    """The doors that a row is about, in groups of which the widest counts: the entrances together, others alone."""
    words = [word for word in rule.of if word in DOORS]
    kinds = [word for word in rule.of if word not in DOORS]

    def meant(door: DoorFacts) -> bool:
        rooms = [room for room in (door.room, door.other) if room is not None]
        if rule.except_of and any(selects(rule.except_of, room.kind) for room in rooms):
            return False
        return not kinds or any(selects(kinds, room.kind) for room in rooms)

    entrances = [door for door in plan.entrances if meant(door)]
    if "entrance-door" in words and entrances:
        yield "entrance", entrances
    for door in plan.doors if "inner-door" in words else ():
        if door.other is not None and meant(door):
            yield "door", [door]


@measure("door_width")
def door_width(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Clear width; a home's door is as wide as its opening is clear."""
    for noun, doors in chosen_doors(plan, rule):
        door = max(doors, key=lambda d: d.width)
        yield Reading(door.rooms, metres(door.width), f"{noun} {door.id} of {door.room.id}: clear width", "m")


@measure("door_height")
def door_height(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Clear height."""
    for noun, doors in chosen_doors(plan, rule):
        door = max(doors, key=lambda d: d.top)
        yield Reading(door.rooms, door.top, f"{noun} {door.id} of {door.room.id}: height", "m")
