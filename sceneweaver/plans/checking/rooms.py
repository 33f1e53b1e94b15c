"""Measures of single rooms: area, sides, proportions, squares to turn and to walk in."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from ..profile import Rule
from .facts import PlanFacts
from .parts import DoorFacts, RoomFacts
from .readings import Reading, measure
from .regions import Region, components, largest
from .walls import Wall, metres


@measure("area")
def area(plan: PlanFacts, rule: Rule) -> Iterable[Reading]:
    """Floor between the walls, by the corners of the outline."""
    return (Reading((room.id,), room.area, f"{room.id}: floor", "m2") for room in plan.selected(rule.of))


@measure("largest_area")
def largest_area(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Floor of the largest of the rooms."""
    found = max(plan.selected(rule.of), key=lambda room: room.area, default=None)
    if found is not None:
        yield Reading((found.id,), found.area, f"largest of the habitable rooms, {found.id}: floor", "m2")
    else:
        yield Reading((), Fraction(0), "largest of the habitable rooms: floor", "m2")


@measure("side")
def side(plan: PlanFacts, rule: Rule) -> Iterable[Reading]:
    """Shorter side of a rectangle that fits, see `clear_side`."""
    return (
        Reading((room.id,), metres(clear_side(room)), f"{room.id}: clear width", "m") for room in plan.selected(rule.of)
    )


def clear_side(room: RoomFacts) -> int:
    """The widest shorter side of a rectangle along the axes that has half of the floor, or as much as any has [mm]."""
    rectangles = room.rectangles
    if not rectangles:
        return 0
    enough = min(room.region.area / 2, max(w * d for w, d in rectangles))
    return max(min(w, d) for w, d in rectangles if w * d >= enough)


@measure("aspect")
def aspect(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Longer by shorter side of the rectangle around the room."""
    for room in plan.selected(rule.of):
        x0, y0, x1, y1 = room.box
        short, long = sorted((x1 - x0, y1 - y0))
        yield Reading((room.id,), Fraction(long, short), f"{room.id}: length by width", "")


@measure("fill")
def fill(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Floor by the area of the rectangle around it: legs and recesses make it less than 1."""
    for room in plan.selected(rule.of):
        x0, y0, x1, y1 = room.box
        share = room.area * 1_000_000 / ((x1 - x0) * (y1 - y0))
        yield Reading((room.id,), share, f"{room.id}: share of the rectangle around it", "%")


@measure("area_over")
def area_over(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Floor beyond that of the smallest of the other rooms."""
    others = list(plan.selected(rule.to))
    for room in plan.selected(rule.of):
        small = min((o for o in others if o is not room), key=lambda o: o.area, default=None)
        if small is not None:
            yield Reading(
                (room.id, small.id), room.area - small.area, f"{room.id}: floor beyond that of {small.id}", "m2"
            )


@measure("ceiling")
def ceiling(plan: PlanFacts, rule: Rule) -> Iterable[Reading]:
    """Height of the storey."""
    return (
        Reading((room.id,), room.height, f"{room.id}: ceiling height", "m")
        for room in plan.selected(rule.of)
        if not room.outdoor
    )


@measure("turning")
def turning(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Side of the largest square beside the squares that swinging leaves take, and beside stairs."""
    for room in plan.selected(rule.of):
        yield Reading((room.id,), metres(turning_square(plan, room)), f"{room.id}: square to turn in", "m")


def turning_square(plan: PlanFacts, room: RoomFacts) -> int:
    """See `turning` [mm]."""
    taken = [leaf.box for door in plan.doors_of(room) if door.swings_into is room for leaf, *_ in door.leaves() if leaf]
    return (room.region - Region.of_boxes(taken)).largest_square()


@measure("dead_end")
def dead_end(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """From each side of the rectangle around a room to the nearest end of one of its doors, less its clear width."""
    for room in plan.selected(rule.of):
        spans = [_span(door, *door.place_in(room)) for door in plan.doors_of(room)]
        if not spans:
            continue
        x0, y0, x1, y1 = room.box
        reach = max(
            min(s[0] for s in spans) - x0,
            min(s[1] for s in spans) - y0,
            x1 - max(s[2] for s in spans),
            y1 - max(s[3] for s in spans),
        )
        beyond = max(0, reach - clear_side(room))
        yield Reading((room.id,), metres(beyond), f"{room.id}: way beyond the last door", "m")


def _span(door: DoorFacts, wall: Wall, offset: int) -> tuple[int, int, int, int]:
    """The rectangle around an opening in a wall [mm]."""
    (ax, ay), (bx, by) = wall.at(offset), wall.at(offset + door.width)
    return round(min(ax, bx)), round(min(ay, by)), round(max(ax, bx)), round(max(ay, by))


@measure("passage")
def passage(plan: PlanFacts, rule: Rule) -> Iterator[Reading]:
    """Side of the square that slides from each door to each other."""
    for room in plan.selected(rule.of):
        yield Reading((room.id,), metres(clear_passage(plan, room)), f"{room.id}: clear way between its doors", "m")


def clear_passage(plan: PlanFacts, room: RoomFacts) -> int:
    """The largest square that slides along the axes from each of the room's doors to each other [mm].

    At a door its side lies on the wall's face, and covers the opening or lies within it. Doors in oblique walls are
    left out.
    """
    doors = [(door, *door.place_in(room)) for door in plan.doors_of(room)]
    straight = [(door, wall, offset) for door, wall, offset in doors if wall.straight and room.straight]
    if not straight:
        return room.region.largest_square()
    x0, y0, x1, y1 = room.box
    return largest(lambda s: _slides(room.region, straight, s), min(x1 - x0, y1 - y0))


def _slides(region: Region, doors: list[tuple[DoorFacts, Wall, int]], s: int) -> bool:
    places = [_contact(door.width, wall, offset, s) for door, wall, offset in doors]
    xs, ys = region.corners(
        s, (v for x_range, _ in places for v in x_range), (v for _, y_range in places for v in y_range)
    )
    free = region.fits(s, xs, ys)
    labels = components(free)
    common: set[int] | None = None
    for (xa, xb), (ya, yb) in places:
        here = labels[(xs >= 2 * xa) & (xs <= 2 * xb)][:, (ys >= 2 * ya) & (ys <= 2 * yb)]
        parts = set(here[here > 0].tolist())
        common = parts if common is None else common & parts
    return bool(common)


def _contact(width: int, wall: Wall, offset: int, s: int) -> tuple[tuple[int, int], tuple[int, int]]:
    """Ranges in x and y of the lower left corner of a square that stands at an opening [mm]."""
    ax, ay = (round(v) for v in wall.along)
    nx, ny = (round(v) for v in wall.outward)
    first = (wall.start[0] + ax * offset, wall.start[1] + ay * offset)
    last = (first[0] + ax * width, first[1] + ay * width)

    def along(a: int, b: int) -> tuple[int, int]:
        low, high = min(a, b), max(a, b)
        return (min(high - s, low), max(high - s, low))

    def across(face: int, outward: int) -> tuple[int, int]:
        place = face - s if outward > 0 else face
        return place, place

    if ax:
        return along(first[0], last[0]), across(first[1], ny)
    return across(first[0], nx), along(first[1], last[1])
