"""Arrangements that a request states as relations: each thing has its place about the first one of its pattern."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.knowledge.capacity import number
from sceneweaver.knowledge.desk_sides import is_desk
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.language.model import Arrangement
from sceneweaver.language.vocabulary import family
from sceneweaver.scene import CATALOGUE, Room

from .desk_sides import at_desks
from .draft import area_of
from .focus import BETWEEN, IN_ROWS, focus_in, focus_of
from .galley import without_runs
from .grid import PULL, group_of
from .patterns import (
    Pitch,
    Spot,
    back_to_back,
    block,
    circle,
    double_rows,
    end_to_end,
    extent,
    extent_of,
    right_angle,
    ring,
    seen_from,
    side_by_side,
    u_shape,
    upright,
)
from .places import kept_clear, lined_at, means_at, seats_at_tables
from .program import Wanted
from .sights import turned_to_views
from .stacks import rows_for
from .stations import as_they_belong, hung_before, of_their_own, room_beside, rows_before_walls, with_their_own
from .units import Unit, composed, front_way, side_way, told_between

OFFSET = 0.03
"""Most distance [m] of a thing from its place."""

TOUCHING, APART, LOOSE = 0.005, 0.12, 0.6
"""Gaps [m] in a row: of what stands side by side, of seats, of what is worked at."""

WAY, LEGS, AISLE = 1.1, 0.45, 1.2
"""Ways [m] between rows of furniture, between rows of seats, and through the middle of a block of rows."""

LOW_THING = 0.7
"""Height [m] from which on what is not entered from its sides stands in rows without gaps."""

MOVED, IN_A_ROW = 0.05, 6
"""Gap [m] between stacks beside each other, and how many of them are in one row."""

LOUNGE, PULLED = 0.32, -0.1
"""Gaps [m] between the fronts of armchairs, and of chairs, and the table that a group of them is around."""

SEEN = 1.2
"""Way [m] between the front row and what all look at."""

HALF, QUARTER = math.radians(165), math.radians(75)
"""Angles that a half circle goes over from its first to its last thing, and one of two things."""

MATS = 0.3
"""Gap [m] between what lies on the floor."""

OFF_WALLS = 0.85
"""Least distance [m] of islands from walls."""

LOW, STACK_GAP, HIGH = 0.9, 0.02, 2.4
"""Height [m] of the lowest row of what hangs in rows, the gap between neighbours there, and where the top row ends."""

WALLS = {
    "": ("long-0", "long-1"),
    "long": ("long-0", "long-1"),
    "short": ("short-0", "short-1"),
    "side": ("left", "right"),
}
"""The two opposite walls that are meant by what kind of them is said; see `wall_names.direction_of`."""

FILLED = 0.9
"""Share of the floor that patterns with the ways about them take at most."""

LED_ASTRAY = CATALOGUE.with_role("edge", "wall", "formation", "seat") | {"side_by_side", "aligned", "parallel"}
"""Types of relations of a room's own that the first thing of a pattern has no more."""

DROPPED = CATALOGUE.with_role("placing", "turning", "edge", "wall", "seat") | {"distance", "near_window", "near_door"}
"""Types of relations that a thing with a place in a pattern has no more."""


@dataclass(frozen=True)
class Laid:
    """An arrangement of things: the leader, their spots in its frame, and the box [m] about all of them."""

    said: Arrangement
    leader: Wanted
    spots: tuple[tuple[Wanted, Spot], ...]
    box: tuple[float, float]
    at: tuple[str, str] | None = None
    """The relation of the leader to a wall, and the wall, where the pattern says it."""

    @property
    def followers(self) -> frozenset[str]:
        """The ids of all but the leader."""
        return frozenset(one.id for one, _ in self.spots) - {self.leader.id}


def laid_out(brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Laid]:
    """The arrangements of a request of which there are two things at least that stand or hang."""
    found, lined = [], lined_at(brief, wanted)
    for said in (*brief.arrangements, *rows_before_walls(brief, wanted)):
        if said.pattern == "row" and said.entity in lined:
            continue  # each has its place at the table
        things = [w for w in wanted if w.asked == said.entity and w.support is None and w.mount in ("floor", "wall")]
        if said.pattern == "stack":
            found += _beside_each_other(said, [w for w in wanted if w.asked == said.entity])
            continue
        things += [w for w in wanted if w.asked in said.others and w.support is None and w.mount == "floor"]
        if (
            len(things) < 2
            or said.pattern in ("between", "outside", "inside")
            or (said.pattern == "sides" and said.around)
        ):
            continue
        if said.pattern == "cluster":
            found += _clusters(said, things, wanted)
        elif said.pattern == "walls":
            found += _along_walls(said, things, wanted, brief)
        elif said.pattern == "wall":
            sizes = [one.asset.size[:2] for one in things]
            spots = side_by_side(sizes, TOUCHING)
            box = extent_of([(spot, *size) for spot, size in zip(spots, sizes, strict=True)])
            found.append(Laid(said, things[0], tuple(zip(things, spots, strict=True)), box, ("against_wall", "")))
        elif said.pattern == "right_angle":
            found.append(_at_right_angles(said, things))
        elif not (said.pattern == "circle" and _is_table(said.around, wanted)):
            seats = {r.subject for r in brief.relations if said.entity in r.targets and means_at(r)}
            pitch = _pitch(things[0], wanted, said, _spacing(said, brief), seats)
            if focus_of(said, brief) is not None:
                pitch = _in_rows(pitch, things[0], wanted, seats)
            pitch = _parted(_of_stations(pitch, said, things[0], wanted, brief), said, things, wanted, brief)
            found.append(_pattern(said, things, _spots(said, things, wanted, pitch, brief)))
    return found


def _pattern(said: Arrangement, things: Sequence[Wanted], spots: Sequence[Spot]) -> Laid:
    depth, width, _ = things[0].asset.size
    return Laid(said, things[0], tuple(zip(things, spots, strict=True)), extent(spots, depth, width))


def _beside_each_other(said: Arrangement, things: Sequence[Wanted]) -> Iterator[Laid]:
    """The lowest things of a few stacks, in a row."""
    bases = things[:: rows_for(said, things[0].category, len(things))] if things else []
    if said.groups is None or not 2 <= len(bases) <= IN_A_ROW or any(w.mount != "floor" for w in bases):
        return
    sizes = [one.asset.size[:2] for one in bases]
    spots = side_by_side(sizes, MOVED)
    box = extent_of([(spot, size[0], size[1]) for spot, size in zip(spots, sizes, strict=True)])
    yield Laid(said, bases[0], tuple(zip(bases, spots, strict=True)), box)


def _parted(
    pitch: Pitch, said: Arrangement, things: Sequence[Wanted], wanted: Sequence[Wanted], brief: SceneGraph
) -> Pitch:
    """Gaps that hold what the request has between neighbours."""
    names = told_between(brief, said.entity)
    parts = [w for w in wanted if w.asked in names and w.mount == "floor" and w.support is None]
    if not parts:
        return pitch
    deep, wide = max(w.asset.size[0] for w in parts), max(w.asset.size[1] for w in parts)
    if said.facing == "each other":
        room = LEGS if has_role(things[0].category, "lounge_seat") else APART / 2
        return pitch._replace(between=deep + 2 * room)
    return pitch._replace(beside=max(pitch.beside if pitch.beside < LOOSE else 0.0, wide + APART))


def _along_walls(
    said: Arrangement, things: Sequence[Wanted], wanted: Sequence[Wanted], brief: SceneGraph
) -> Iterator[Laid]:
    """A row at each of two opposite walls, with their backs to it; few beds with their long sides."""
    names = WALLS[said.around.partition(":")[2]]
    half = said.sides[0] if len(said.sides) == 2 else math.ceil(len(things) / 2)
    pitch = _parted(_pitch(things[0], wanted, said, _spacing(said, brief)), said, things, wanted, brief)
    for name, row in zip(names, (things[:half], things[half:]), strict=True):
        if not row:
            continue
        sizes = [one.asset.size[:2] for one in row]
        lengthwise = half <= 2 and family(row[0].category) == "bed_group"
        ways = max((side_way(one) for one in row), default=0.0)
        spots = end_to_end(sizes, pitch.beside) if lengthwise else side_by_side(sizes, max(pitch.beside, ways))
        box = extent_of([(spot, *size) for spot, size in zip(spots, sizes, strict=True)])
        kind = "side_against_wall" if lengthwise else "against_wall"
        yield Laid(said, row[0], tuple(zip(row, spots, strict=True)), box, (kind, f"wall:{name}"))


def _at_right_angles(said: Arrangement, things: Sequence[Wanted]) -> Laid:
    """Things in two rows that meet at a corner, the seats with room for legs there."""
    half = sum(one.asked == said.entity for one in things) if said.others else math.ceil(len(things) / 2)
    one, other = ([w.asset.size[:2] for w in part] for part in (things[:half], things[half:]))
    seat = family(things[0].category) == "seat"
    corner = LEGS if seat else max(TOUCHING, front_way(things[half - 1]))
    spots = right_angle(one, other, APART if seat else TOUCHING, corner, open_=seat)
    sizes = [w.asset.size[:2] for w in things]
    box = extent_of([(spot, *size) for spot, size in zip(spots, sizes, strict=True)])
    at = ("in_corner", "") if said.around.startswith("wall") else None
    return Laid(said, things[0], tuple(zip(things, spots, strict=True)), box, at)


def _clusters(said: Arrangement, things: Sequence[Wanted], wanted: Sequence[Wanted]) -> Iterator[Laid]:
    """Each group of so many: around its thing, else in a block or a ring of its own."""
    hosts = [w for w in wanted if said.around and w.asked == said.around and w.mount == "floor"]
    size = said.columns or max(2, len(things) // max(1, said.groups or 1))
    for at in range(0, len(things), size):
        group = things[at : at + size]
        if hosts:
            if at // size >= len(hosts):
                return
            host = hosts[at // size]
            gap = LOUNGE if has_role(group[0].category, "lounge_seat") else PULLED
            spots = ring(len(group), (host.asset.size[0], host.asset.size[1]), group[0].asset.size[0], gap)
            d, w, _ = group[0].asset.size
            yield Laid(said, host, tuple(zip(group, spots, strict=True)), extent([Spot(0.0, 0.0), *spots], d, w))
            continue
        if len(group) < 2:
            continue
        if family(group[0].category) == "seat":
            yield _pattern(said, group, circle(len(group), _pitch(group[0], wanted, said, None)))
            continue
        d, w, _ = group[0].asset.size
        if len(group) == 2:  # a pair is side by side
            yield _pattern(said, group, [Spot(0.0, 0.0), Spot(0.0, w + TOUCHING)])
            continue
        yield _pattern(said, group, back_to_back(len(group), Pitch(d, w, TOUCHING, 0.0)))


def _spacing(said: Arrangement, brief: SceneGraph) -> float | None:
    """The gap [m] that is stated of an arrangement: with it, or as floor that stays free between its things."""
    if said.spacing is not None:
        return said.spacing
    gaps = [area for area in brief.free_areas if area.kind == "gap" and set(area.targets) == {said.entity}]
    return gaps[0].size[0] + 2 * OFFSET if gaps else None  # that much at least, wherever each is within its play


def _spots(
    said: Arrangement, things: Sequence[Wanted], wanted: Sequence[Wanted], pitch: Pitch, brief: SceneGraph
) -> list[Spot]:
    count, one = len(things), things[0]
    rows, columns = shape_of(said, count)
    if said.upright:
        return upright(rows, columns, one.asset.size[1], STACK_GAP)
    if said.pattern == "circle":
        return circle(count, pitch, radius=_radius(said, wanted))
    if said.pattern == "semicircle":
        return circle(count, pitch, arc=HALF if count > 2 else QUARTER, radius=_radius(said, wanted))
    if said.pattern == "u":
        inside = any(a.pattern == "inside" and a.around == said.entity for a in brief.arrangements)
        turn = (
            180.0 if has_role(one.category, "desk") and not inside else 0.0
        )  # who sits at a desk is before its front, outside
        if one.thing.is_table and not inside:  # its seats are outside
            pitch = Pitch(one.asset.size[0], one.asset.size[1], TOUCHING, pitch.between)
        spots = u_shape(count, pitch)
        return [seen_from(Spot(0.0, 0.0, turn), Spot(s.ahead, s.left, s.turn + turn)) for s in spots]
    if said.pattern in ("back_to_back", "head_to_head"):
        near = pitch._replace(depth=one.asset.size[0], beside=max(pitch.beside, side_way(one)))
        if said.rows or said.columns:
            return double_rows(rows, columns, count, near)
        return back_to_back(count, near)
    if said.pattern == "end_to_end":
        return end_to_end([thing.asset.size[:2] for thing in things], TOUCHING)
    aisle = max(AISLE, said.spacing or 0.0) if said.pattern == "sides" else 0.0
    aisle = said.aisle or aisle
    if aisle and said.facing == "each other" and rows == 2:
        pitch, aisle = pitch._replace(between=max(pitch.between, aisle)), 0.0
    return block(rows, columns, count, pitch, opposed=said.facing == "each other" and rows > 1, aisle=aisle)


def shape_of(said: Arrangement, count: int) -> tuple[int, int]:
    """Rows and columns of so many things, as far as an arrangement says them; else nearly as many of one as of the
    other."""
    if said.pattern == "row":
        return 1, count
    if said.sides:
        return max(said.sides), 2
    rows, columns = said.rows, said.columns
    if said.aisle and rows == 2 and said.facing != "each other":
        return max(columns or 0, math.ceil(count / 2)), 2  # a row at either hand of the aisle
    if rows is None and columns is None:
        if said.pattern == "islands" and count <= 2:
            return 1, count
        return _even(count, 2 if said.aisle else 1)
    if rows is None:
        assert columns is not None
        return math.ceil(count / columns), columns
    columns = columns or math.ceil(count / rows)
    return max(rows, math.ceil(count / columns)), columns


def _even(count: int, by: int) -> tuple[int, int]:
    """Rows and columns of so many things, whole rows if that is nearly a square; columns by so many."""
    root = math.sqrt(count)
    shapes = [(math.ceil(count / c), c) for c in range(by, count + 1, by) if c <= 2 * root + by]

    def off(shape: tuple[int, int]) -> float:
        return (shape[0] * shape[1] - count) / count + abs(math.log(shape[1] / root)) / 2

    return min(shapes, key=off, default=(1, count))


def _pitch(
    one: Wanted, wanted: Sequence[Wanted], said: Arrangement, spacing: float | None, seats: Collection[str] = ()
) -> Pitch:
    """The extents of a thing with the seats at it, and the gaps that such things have in rows."""
    depth, width, height = one.asset.size
    seat = family(one.category) == "seat"
    if one.thing.is_flat or height < 0.05:
        gap = MATS if spacing is None else spacing
        return Pitch(depth, width, gap, gap)
    group = group_of(one, [w for w in wanted if w is one or w.parent is one])
    seated = any(w.parent is one and family(w.category) == "seat" for w in wanted)
    if seated:
        depth, width = group.depth, group.width
    around = max((w.asset.size[0] + PULL for w in wanted if w.asked in seats and w.parent is not one), default=0.0)
    if around:
        seated, depth, width = True, max(depth, one.asset.size[0] + 2 * around), width + 0.5 * around
    beside, between = (APART, LEGS) if seat else (LOOSE, WAY)
    if seat and has_role(one.category, "armchair"):
        between = 2 * LEGS
    sides = {zone.name for zone in one.asset.zones if zone.hard} & {"left", "right"}
    generic = category_named(one.category).size is None
    if not seat and not sides and not generic:
        beside = TOUCHING if said.pattern in ("row", "rows") and height > LOW_THING else APART
    if seated or one.thing.is_table:
        beside = LOOSE if said.pattern != "u" else TOUCHING
    if spacing is not None:
        column = said.pattern == "rows" and (said.columns == 1 or said.facing == "each other")
        beside = beside if column or said.pattern == "sides" else spacing
        between = spacing if said.pattern != "row" and said.pattern != "sides" else between
    if said.pitch is not None:
        beside = max(TOUCHING, said.pitch - width + (2 * OFFSET if said.at_least else 0.0))
    return Pitch(depth, width, beside, between)


def _in_rows(pitch: Pitch, table: Wanted, wanted: Sequence[Wanted], seats: Collection[str]) -> Pitch:
    """A pitch of tables in rows with seats on one side: who sits there needs floor behind, and none at the ends."""
    if not table.thing.is_table:
        return pitch
    deep = max((w.asset.size[0] for w in wanted if w.asked in seats or w.parent is table), default=0.0)
    depth, width, _ = table.asset.size
    return Pitch(depth + deep, width, pitch.beside, BETWEEN) if deep else pitch


def _of_stations(pitch: Pitch, said: Arrangement, one: Wanted, wanted: Sequence[Wanted], brief: SceneGraph) -> Pitch:
    """A pitch with room for what each thing has for its own, and for the floor that stays free around each."""
    depth, width = with_their_own(one, brief, wanted)
    beside = max(pitch.beside, room_beside(one, brief, wanted)) if said.pitch is None else pitch.beside
    free = [area.size[0] for area in brief.free_areas if area.kind == "clearance" and said.entity in area.targets]
    clear = max(free, default=0.0) + (2 * OFFSET if free else 0.0)
    more = max(0.0, width - pitch.width) if said.pitch is None else 0.0
    return Pitch(
        max(pitch.depth, depth), pitch.width + more, max(beside - more, clear - more, 0.0), max(pitch.between, clear)
    )


def _radius(said: Arrangement, wanted: Sequence[Wanted]) -> float:
    """How far [m] from the middle of a circle the fronts are, for what stands in it."""
    inner = [w for w in wanted if said.around and w.asked == said.around]
    return max((math.hypot(*w.asset.size[:2]) / 2 + number("reach") for w in inner), default=0.0)


def _is_table(name: str, wanted: Sequence[Wanted]) -> bool:
    return any(w.asked == name and w.thing.is_table for w in wanted)


def patterned(rows: Iterable[Grounded], brief: SceneGraph, wanted: Sequence[Wanted]) -> list[Grounded]:
    """What a request states of things, with the places of those in patterns instead of what else says where they are.

    The first of a pattern keeps what is said of it: at which wall, before which window. What all look at, it looks at.
    """
    patterns = laid_out(brief, wanted)
    followers = frozenset[str]().union(*(p.followers for p in patterns))
    seated = {(seat.subject, seat.target) for seat in _at_sides(brief, wanted)}
    rows = without_runs(as_they_belong(at_desks(tuple(rows), brief, wanted), brief, wanted), brief, wanted)
    kept = [r for r in seats_at_tables(rows, brief, wanted) if not (r.subject in followers and r.type in DROPPED)]
    kept = [r for r in kept if (r.subject, r.target) not in seated]
    for one in patterns:
        kept = [r for r in kept if not _led_astray(r, one)]
        kept += _of_pattern(one, wanted, brief)
    kept += list(_at_sides(brief, wanted))
    for row in of_their_own(brief, wanted, [(one.said.entity, [t for t, _ in one.spots]) for one in patterns]):
        kept = [r for r in kept if not (r.subject == row.subject and r.type in DROPPED)]
        kept = [r for r in kept if not (r.subject == row.target and r.target == row.subject)]
        kept.append(row)
    for row in _about_a_u(brief, wanted):
        kept = [r for r in kept if not (r.subject == row.subject and r.type in DROPPED)]
        kept.append(row)
    for unit in units_of(brief, wanted, patterns):
        kept = _as_unit(kept, unit)
    return [*kept, *turned_to_views(kept, brief, wanted)]


def units_of(brief: SceneGraph, wanted: Sequence[Wanted], patterns: Sequence[Laid] | None = None) -> list[Unit]:
    """The groups that a request tells thing by thing, grown about its patterns."""
    laid = laid_out(brief, wanted) if patterns is None else patterns
    spots = [one.spots if one.spots[0][0] is one.leader else ((one.leader, Spot(0.0, 0.0)), *one.spots) for one in laid]
    return composed(brief, wanted, spots)


def _as_unit(rows: Sequence[Grounded], unit: Unit) -> list[Grounded]:
    """Relations with the places of a group's members about its leader instead of what else says where they are."""
    members = {one.id for one, _, _ in unit.spots}
    inside = members | {unit.leader.id}
    kept = [
        r
        for r in rows
        if not (r.subject in members and r.type in DROPPED)
        and not (r.subject == unit.leader.id and r.type in DROPPED and set(_ids(r.target)) & inside)
        and not (r.subject in unit.turned and r.type == "facing")
    ]
    for one, spot, said in unit.spots:
        params = {"ahead": round(spot.ahead, 4), "left": round(spot.left, 4), "turn": round(spot.turn, 3)}
        kept.append(Grounded(said, "arranged", one.id, unit.leader.id, {**params, "offset": OFFSET, "degrees": 2.0}))
    return kept


def _ids(target: str | tuple[str, str] | None) -> tuple[str, ...]:
    return (target,) if isinstance(target, str) else target or ()


def _led_astray(row: Grounded, one: Laid) -> bool:
    """Whether what is said of a leader, or of others by it, is said of the pattern now."""
    if one.leader.asked == one.said.around:
        return False  # a table keeps its place; what is around it has its own
    if row.subject != one.leader.id:
        return False
    if row.type == "facing" or row.target in one.followers:
        return True
    return one.said.pattern == "circle" and row.type == "around"


def _of_pattern(one: Laid, wanted: Sequence[Wanted], brief: SceneGraph) -> Iterator[Grounded]:
    for thing, spot in one.spots:
        if thing is one.leader:
            continue
        params = {"ahead": round(spot.ahead, 4), "left": round(spot.left, 4), "turn": round(spot.turn, 3)}
        yield Grounded(one.said.id, "arranged", thing.id, one.leader.id, {**params, "offset": OFFSET, "degrees": 2.0})
    if one.at is not None:
        kind, wall = one.at
        params = {"side": "right"} if kind == "side_against_wall" else {}
        yield Grounded(one.said.id, kind, one.leader.id, wall or None, params)
    focus = [w for w in wanted if w.asked in (one.said.facing, one.said.around) and w.asked]
    focus = focus or focus_in(one.said, brief, wanted)
    around = bool(focus) and focus[0].asked == one.said.around and not focus[0].wall
    if focus and (one.said.pattern == "circle" or (one.said.pattern == "semicircle" and around)):
        ahead = _middle_of(one)
        at = {"ahead": round(ahead, 4), "left": 0.0, "turn": 180.0, "offset": 0.1, "degrees": 180.0}
        yield Grounded(one.said.id, "arranged", focus[0].id, one.leader.id, at)
    elif focus and one.said.pattern == "semicircle" and (one.said.around or _free(focus[0], brief)):
        yield _over_the_open_side(one, focus[0])
    elif focus and _before(one, focus[0], brief):
        xs = [spot.ahead for _, spot in one.spots]
        ys = [spot.left for _, spot in one.spots]
        gap = max(0.0, max(xs)) + (one.leader.asset.size[0] + focus[0].asset.size[0]) / 2 + SEEN
        left = (max(ys) + min(ys)) / 2
        at = {"ahead": round(gap, 4), "left": round(left, 4), "turn": 180.0, "offset": 0.3, "degrees": 10.0}
        yield Grounded(one.said.id, "arranged", focus[0].id, one.leader.id, at)
    elif focus and one.said.pattern in ("semicircle", "u", "row", "rows", "grid", "sides"):
        offset = max(0.3, 0.3 * max(one.box))
        before: dict[str, Any] = {"side": "front", "gap": [0.6, 8.0], "offset": offset, "degrees": 8.0}
        outward = one.said.pattern == "u" and has_role(one.leader.category, "desk") and max(xs := _aheads(one)) <= 0.0
        if outward and min(xs) < 0.0:  # the open side is behind the desks
            ahead = min(xs) - one.leader.asset.size[1] / 2 - SEEN
            lefts = [spot.left for _, spot in one.spots]
            left = round((max(lefts) + min(lefts)) / 2, 4)
            at = {"ahead": round(ahead, 4), "left": left, "turn": 0.0, "offset": SEEN, "degrees": 20.0}
            yield Grounded(one.said.id, "arranged", focus[0].id, one.leader.id, at)
            return
        yield Grounded(one.said.id, "across_from", one.leader.id, focus[0].id, before, hard=False)
        if is_desk(one.leader.thing) and one.said.pattern in IN_ROWS:  # who sits there looks across its back
            back = {"side": "back", "gap": [0.6, 8.0], "offset": offset, "degrees": 8.0}
            yield Grounded(one.said.id, "across_from", focus[0].id, one.leader.id, back)
            return
        yield Grounded(one.said.id, "facing", one.leader.id, focus[0].id, {"degrees": 35.0})
    elif focus and one.said.pattern == "right_angle":
        yield Grounded(one.said.id, "facing", one.leader.id, focus[0].id, {"degrees": 35.0})
    if one.said.pattern == "islands":
        for thing, _ in one.spots:
            yield Grounded(one.said.id, "off_walls", thing.id, None, {"min": OFF_WALLS})


def _aheads(one: Laid) -> list[float]:
    return [spot.ahead for _, spot in one.spots]


def _before(one: Laid, focus: Wanted, brief: SceneGraph) -> bool:
    """Whether what rows look at has its place before them: it stands free, and nothing else says where."""
    patterns = ("row", "rows", "grid", "sides")
    level = all(abs(spot.turn) < 1.0 for _, spot in one.spots)
    return one.said.pattern in patterns and level and _free(focus, brief)


def _free(focus: Wanted, brief: SceneGraph) -> bool:
    """Whether what is looked at stands on the floor and nothing that is asked says where."""
    placed = any(r.subject == focus.asked and not r.implied for r in brief.relations)
    return focus.mount == "floor" and not placed and focus.support is None


def _over_the_open_side(one: Laid, focus: Wanted) -> Grounded:
    """The place of what a half circle looks at: straight before its open side, with its front to it."""
    turns = [math.radians(spot.turn) for _, spot in one.spots]
    way = math.atan2(sum(map(math.sin, turns)), sum(map(math.cos, turns)))
    middle = _middle_of(one)  # straight ahead of the leader
    far = max(0.0, *(_along(spot, way) for _, spot in one.spots)) + SEEN / 2
    far = max(far, middle * math.cos(way)) + (one.leader.asset.size[0] + focus.asset.size[0]) / 2
    beyond = far - middle * math.cos(way)
    ahead, left = middle + beyond * math.cos(way), beyond * math.sin(way)
    turn = math.degrees(math.remainder(way + math.pi, 2 * math.pi))
    at = {"ahead": round(ahead, 4), "left": round(left, 4), "turn": round(turn, 3), "offset": 0.3, "degrees": 10.0}
    return Grounded(one.said.id, "arranged", focus.id, one.leader.id, at)


def _along(spot: Spot, way: float) -> float:
    """How far [m] a spot is along a direction [rad] of the leader's frame."""
    return spot.ahead * math.cos(way) + spot.left * math.sin(way)


def _middle_of(one: Laid) -> float:
    """How far [m] the middle of a circle, of which all or an arc is there, is ahead of its leader."""
    far = max((spot for _, spot in one.spots), key=lambda spot: math.hypot(spot.ahead, spot.left))
    return (far.ahead**2 + far.left**2) / (2.0 * far.ahead)


def _at_sides(brief: SceneGraph, wanted: Sequence[Wanted]) -> Iterator[Grounded]:
    """Seats on one side of a table and on the other: in the middles of equal parts of its long sides."""
    for said in brief.arrangements:
        tables = [w for w in wanted if said.around and w.asked == said.around]
        if said.pattern != "sides" or not tables:
            continue
        seats = iter([one for one in wanted if one.asked == said.entity])
        for table in tables:
            d, w, _ = table.asset.size
            order = ("front", "back", "left", "right") if w >= d else ("left", "right", "front", "back")
            for side, count in zip(order, said.sides, strict=False):
                for k in range(count):
                    seat = next(seats, None)
                    if seat is not None:
                        yield Grounded(said.id, "seated_at", seat.id, table.id, {"side": side, "k": k, "n": count})
                        if kept_clear(table, side):
                            yield Grounded(said.id, "front_against", seat.id, table.id, hard=False)


def _about_a_u(brief: SceneGraph, wanted: Sequence[Wanted]) -> Iterator[Grounded]:
    """Seats on the outer or the inner side of tables that are set out in a U: shared out among them."""
    for said in brief.arrangements:
        tables = [w for w in wanted if said.pattern in ("outside", "inside") and w.asked == said.around]
        seats = [w for w in wanted if w.asked == said.entity and w.mount == "floor"]
        if not tables or not seats:
            continue
        # A desk has its front to who sits at it; other tables of a U look inward.
        outer = "front" if has_role(tables[0].category, "desk") or said.pattern == "inside" else "back"
        for k, seat in enumerate(seats):
            table, at = tables[k % len(tables)], k // len(tables)
            share = len(seats[k % len(tables) :: len(tables)])
            yield Grounded(said.id, "seated_at", seat.id, table.id, {"side": outer, "k": at, "n": share})


def led(brief: SceneGraph, wanted: Sequence[Wanted]) -> dict[str, frozenset[str]]:
    """By the ids of the leaders of patterns, the types of relations of a room's own that hold for them no more."""
    found = {}
    for one in laid_out(brief, wanted):
        alone = one.said.pattern == "row" or one.leader.asked == one.said.around
        found[one.leader.id] = frozenset() if alone else LED_ASTRAY
    for unit in units_of(brief, wanted):
        turned = {"facing", "across_from"} if unit.leader.id in unit.turned else set[str]()
        found[unit.leader.id] = found.get(unit.leader.id, frozenset()) | turned
    return found


def arranged_ids(brief: SceneGraph, wanted: Sequence[Wanted]) -> Collection[str]:
    """The ids of all things that stand in patterns."""
    return {one.id for laid in laid_out(brief, wanted) for one, _ in laid.spots}


def fits(brief: SceneGraph, wanted: Sequence[Wanted], room: Room) -> bool:
    """Whether the floor of a room has a place for the box about each pattern, and for what is longer than usual."""
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    short, long = sorted((max(xs) - min(xs), max(ys) - min(ys)))
    if any(w.asked and w.mount == "floor" and max(w.asset.size[:2]) + WAY > long for w in wanted if _is_long(w)):
        return False
    patterns = laid_out(brief, wanted)
    if not _units_fit(units_of(brief, wanted, patterns), short, long):
        return False
    if sum((one.box[0] + WAY) * (one.box[1] + WAY) for one in patterns if not one.said.upright) > FILLED * area_of(
        room
    ):
        return False
    for one in patterns:
        margin = 0.1 if one.said.upright else 2 * OFF_WALLS if one.said.pattern == "islands" else WAY
        a, b = sorted(one.box)
        if one.said.upright:
            if b + margin > long:
                return False
        elif a + (margin if one.said.pattern != "row" else 0.0) > short or b + margin > long:
            return False
    return True


def _is_long(one: Wanted) -> bool:
    """Whether something was made longer than such things usually are, for those who sit at it."""
    usual = category_named(one.category).size
    return usual is not None and max(one.asset.size[:2]) > max(usual.depth[1], usual.width[1]) + OFFSET


def _units_fit(units: Sequence[Unit], short: float, long: float) -> bool:
    """Whether the box about each group has a place between walls, with a way beside it."""
    for unit in units:
        members = [(unit.leader, Spot(0.0, 0.0)), *((one, spot) for one, spot, _ in unit.spots)]
        a, b = sorted(extent_of([(spot, one.asset.size[0], one.asset.size[1]) for one, spot in members]))
        if a + WAY / 2 > short or b + WAY / 2 > long:
            return False
    return True


def hung(brief: SceneGraph, wanted: Sequence[Wanted]) -> None:
    """Gives what hangs in rows one above the other, and before seats, its wall and its height."""
    hung_before(brief, wanted)
    for said in brief.arrangements:
        things = [w for w in wanted if w.asked == said.entity]
        if not said.upright or len(things) < 2:
            continue
        rows, columns = shape_of(said, len(things))
        step = things[0].asset.size[2] + STACK_GAP
        low = max(LOW, min(1.2, HIGH - rows * step))
        for k, one in enumerate(things):
            at = round(low + (k // columns) * step, 3)
            one.support, one.held, one.hung = None, "wall", (at, at + 0.002)
