"""What a profile asks of walls, as rows over the places of their lines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from sceneweaver.home import Home, HomeDoor, millimetres, place_in
from sceneweaver.plans import Rule, room_type
from sceneweaver.plans.room_types import selects

from .least_squares import Row
from .wall_lines import Face, WallLines

KEPT = 600
"""What is left of the width of any room [mm], where a rule says nothing."""

SPARE = 3.0
"""How much more than a rule asks is asked of products and ratios [mm], for rounding to whole millimetres."""

MOST_CORNERS = 24


def order_rows(lines: WallLines, home: Home) -> Iterator[Row]:
    """Rooms keep a width, and walls between rooms their thickness."""
    inner = millimetres(home.walls.inner)
    for k in range(len(lines.rooms)):
        for low, high, apart in lines.across(k):
            factors, constant = lines.difference(low, high)
            yield Row(factors, min(apart, KEPT) - constant)
    joined = {frozenset((d.room, d.to)) for d in home.doors if d.kind == "open"}
    for low, high, gap in lines.facing():
        factors, constant = lines.difference(low, high)
        if factors:
            touching = frozenset((lines.rooms[low.room].id, lines.rooms[high.room].id)) in joined
            yield Row(factors, (min(gap, inner) if touching else inner) - constant)


def rule_rows(lines: WallLines, rules: Sequence[Rule], places: np.ndarray) -> Iterator[Row]:
    """Rows for sides, ways, proportions and floors; floors by their slope at ``places``."""
    for rule in rules:
        chosen = [k for k, r in enumerate(lines.rooms) if _means(rule, r.type)]
        if rule.measure == "side" and rule.least is not None:
            for k in chosen:
                yield from _side_rows(lines, k, rule.least * 1000, places, rule.id)
        elif rule.measure == "passage" and rule.least is not None:
            for k in chosen:
                for low, high, apart in lines.across(k):
                    if apart >= 0.5 * rule.least * 1000:
                        factors, constant = lines.difference(low, high)
                        yield Row(factors, rule.least * 1000 - constant, rule.id)
        elif rule.measure == "aspect" and rule.most is not None:
            for k in chosen:
                yield from _aspect_rows(lines, k, rule.most, rule.id)
        elif rule.measure == "area" and rule.least is not None:
            for k in chosen:
                yield _area_row(lines, k, rule.least, places, rule.id)
        elif rule.measure == "largest_area" and rule.least is not None and chosen:
            best = max(chosen, key=lambda k: lines.area(k, places)[0])
            yield _area_row(lines, best, rule.least, places, rule.id)


def door_rows(lines: WallLines, home: Home, rules: Sequence[Rule]) -> Iterator[Row]:
    """Walls on both sides of a door long enough for it to be as wide as rules ask."""
    index = {room.id: k for k, room in enumerate(home.rooms)}
    faces = {(f.room, f.wall): f for f in lines.faces}
    for door in home.doors:
        least = wanted_width(home, door, rules)
        if least <= door.width:
            continue
        sides = [(index[door.room], door.wall)]
        if door.to is not None:
            sides.append((index[door.to], place_in(home, door, door.to)[0]))
        ends: list[Face] = []
        for room, wall in sides:
            count = len(home.rooms[room].outline)
            ends += [faces[n] for n in ((room, (wall - 1) % count), (room, (wall + 1) % count)) if n in faces]
        for low in ends:
            for high in ends:
                if low.at < high.at and low.way > 0 > high.way:
                    factors, constant = lines.difference(low, high)
                    yield Row(factors, least * 1000 + 2 - constant, "door")


def wanted_width(home: Home, door: HomeDoor, rules: Sequence[Rule]) -> float:
    """The least width [m] that rules ask of a door; 0: none."""
    word = "inner-door" if door.to is not None else "entrance-door"
    kinds = [room_type(home.room(r).type) for r in (door.room, door.to) if r is not None]
    return max(
        (
            rule.least
            for rule in rules
            if rule.measure == "door_width"
            and rule.least is not None
            and word in rule.of
            and not (rule.except_of and any(selects(rule.except_of, kind) for kind in kinds))
        ),
        default=0.0,
    )


def _means(rule: Rule, kind: str) -> bool:
    return selects(rule.of, room_type(kind))


def _area_row(lines: WallLines, room: int, least: float, places: np.ndarray, name: str) -> Row:
    floor, slope = lines.area(room, places)
    around = sum(abs(v) for v in slope.values())
    known = sum(slope[k] * places[k] for k in slope)
    # scaled to millimetres of wall, so that rows are as long as each other
    scale = max(1.0, around / max(1, len(slope)))
    bound = least * 1e6 + SPARE * around - floor + known
    return Row({k: v / scale for k, v in slope.items() if v}, bound / scale, name)


def _aspect_rows(lines: WallLines, room: int, most: float, name: str) -> Iterator[Row]:
    mine = [f for f in lines.faces if f.room == room]
    ends: list[tuple[Face, Face]] = []
    for axis in (0, 1):
        along = [f for f in mine if f.axis == axis]
        if len(along) < 2:
            return
        ends.append((min(along, key=lambda f: f.at), max(along, key=lambda f: f.at)))
    for short, long in ((0, 1), (1, 0)):
        wide, at = lines.difference(*ends[short])
        deep, on = lines.difference(*ends[long])
        factors = {k: most * v for k, v in wide.items()}
        for k, v in deep.items():
            factors[k] = factors.get(k, 0.0) - v
        yield Row({k: v for k, v in factors.items() if v}, on - most * at + SPARE, name)


def _side_rows(lines: WallLines, room: int, least: float, places: np.ndarray, name: str) -> Iterator[Row]:
    """The largest rectangle of a room, both of its sides."""
    corners = lines.outline(room, places)
    found = _main_rectangle(corners)
    if found is None:
        return
    x0, y0, x1, y1 = found
    mine = [f for f in lines.faces if f.room == room]
    for axis, (low, high), (begin, end) in ((0, (x0, x1), (y0, y1)), (1, (y0, y1), (x0, x1))):

        def at(place: float, way: int, axis: int = axis, begin: float = begin, end: float = end) -> list[Face]:
            return [
                f
                for f in mine
                if f.axis == axis
                and f.way == way
                and abs(places[lines.line[(room, f.wall)]] + lines.offset[(room, f.wall)] - place) < 0.5
                and f.low < end
                and f.high > begin
            ]

        for a in at(low, 1):
            for b in at(high, -1):
                factors, constant = lines.difference(a, b)
                yield Row(factors, least - constant, name)


def _main_rectangle(corners: list[list[float]]) -> tuple[float, float, float, float] | None:
    """Of the rectangles in a room that have half of its floor, the one with the longest shorter side."""
    if len(corners) > MOST_CORNERS:
        return None
    floor = shapely.Polygon(corners)
    grown = floor.buffer(0.01, join_style="mitre")
    shapely.prepare(grown)
    xs, ys = (sorted({c[k] for c in corners}) for k in (0, 1))
    tried = [
        (x0, y0, x1, y1)
        for i, x0 in enumerate(xs)
        for x1 in xs[i + 1 :]
        for j, y0 in enumerate(ys)
        for y1 in ys[j + 1 :]
    ]
    held = shapely.covers(grown, shapely.box(*np.array(tried).T)) if tried else []
    boxes = [box for box, within in zip(tried, held, strict=True) if within]

    def size(b: tuple[float, float, float, float]) -> float:
        return (b[2] - b[0]) * (b[3] - b[1])

    if not boxes:
        return None
    enough = min(floor.area / 2, max(map(size, boxes)))
    return max((b for b in boxes if size(b) >= enough - 1), key=lambda b: (min(b[2] - b[0], b[3] - b[1]), size(b)))
