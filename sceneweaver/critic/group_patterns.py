"""Measures of groups: aisles, rows along two walls, right angles, ends together, one in each gap, sides of a table."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Sequence

from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.angles import dot, wrap_angle
from sceneweaver.geometry.walls import Wall
from sceneweaver.language.model import Arrangement
from sceneweaver.language.wall_names import direction_of
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from .group_measures import apart, nearest_point, of_between, outline
from .survey import FLAT, Survey, turn_to
from .verdict import counted

Checks = Iterator[Measurement]


def limit(name: str) -> float:
    """A number of the fault of arrangements; see ``asked.yaml``."""
    return float(fault_kind("not_arranged").limits[name])


def _spans(bodies: Sequence[Body], axis: float) -> list[tuple[float, float]]:
    """The extents [m] of bodies along an axis, merged where they touch, in order."""
    c, s = math.cos(axis), math.sin(axis)
    found: list[tuple[float, float]] = []
    for low, high in sorted((min(v), max(v)) for v in ([c * x + s * y for x, y in b.corners] for b in bodies)):
        if found and low <= found[-1][1]:
            found[-1] = found[-1][0], max(found[-1][1], high)
        else:
            found.append((low, high))
    return found


def aisle(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """A straight way through a block of rows, as wide as asked, with nothing in it."""
    import shapely

    if said.aisle is None:
        return
    best, lane = 0.0, None
    for axis in (bodies[0].yaw, bodies[0].yaw + math.pi / 2):
        across, along = _spans(bodies, axis), _spans(bodies, axis + math.pi / 2)
        for (_, low), (high, _) in itertools.pairwise(across):
            if high - low > best:
                best, lane = high - low, (axis, low, high, along[0][0], along[-1][1])
    yield Measurement("aisle", best, said.aisle - limit("spacing") / 2, math.inf)
    if lane is None:
        return
    axis, low, high, start, end = lane
    c, s = math.cos(axis), math.sin(axis)
    middle, half = (low + high) / 2, min(said.aisle, high - low) / 2 - limit("into")
    box = [(middle - half, start), (middle + half, start), (middle + half, end), (middle - half, end)]
    way = shapely.Polygon([(c * u - s * v, s * u + c * v) for u, v in box])
    inside = [
        b
        for b in survey.standing
        if b not in bodies
        and b.z[1] > FLAT
        and b.z[0] < 2.0
        and shapely.area(survey.footprint(b) & way) > limit("litter")
    ]
    yield counted("things in the aisle", len(inside), 0, 0)


def _walls_of(survey: Survey, body: Body) -> set[int]:
    """The walls that the back, an end or a side of a body is at."""
    found = set[int]()
    for wall in survey.scene.room.walls:
        places = [wall.coordinates(p) for p in body.corners]
        level = all(-limit("into") <= at <= wall.length + limit("into") for at, _ in places)
        if level and min(depth for _, depth in places) <= limit("at_wall"):
            found.add(wall.index)
    return found


def _two_walls(survey: Survey, at: Sequence[set[int]]) -> tuple[Wall, Wall] | None:
    """The two walls across from each other at which most things are; None where the room has no such walls."""
    pairs = [
        (one, other)
        for one, other in itertools.combinations(survey.scene.room.walls, 2)
        if dot(one.inward, other.inward) < -limit("across")
    ]
    return max(pairs, key=lambda pair: sum(bool({w.index for w in pair} & a) for a in at), default=None)


def along_walls(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Rows at two walls across from each other, of the kind that is said, as many at either."""
    at = [_walls_of(survey, b) for b in bodies]
    pair = _two_walls(survey, at)
    if pair is None:
        yield counted("walls across from each other", 0, 2)
        return
    shares = sorted(sum(wall.index in a for a in at) for wall in pair)
    yield counted("things at neither wall", sum(not {w.index for w in pair} & a for a in at), 0, 0)
    if said.sides:
        yield counted("at the fuller wall", shares[1], max(said.sides), max(said.sides))
        yield counted("at the other wall", shares[0], min(said.sides), min(said.sides))
    else:
        yield counted("more at one wall", shares[1] - shares[0], 0, 1)
    longest = max(w.length for w in survey.scene.room.walls)
    kind = said.around.partition(":")[2]
    if kind == "long":
        yield Measurement("length of the walls", max(w.length for w in pair), limit("longest") * longest, math.inf)
    elif kind == "short":
        outline = survey.scene.room.outline
        sides = [max(p[k] for p in outline) - min(p[k] for p in outline) for k in (0, 1)]
        most = min(sides) / limit("longest")
        yield Measurement("length of the walls", max(w.length for w in pair), -math.inf, most)
    elif kind == "side" and (way := direction_of("left", survey.scene.room)) is not None:
        yield Measurement("side walls", abs(dot(pair[0].inward, way)), limit("across"), math.inf, "")
    yield from aisle(survey, said, bodies)


def full_wall(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Side by side over most of one wall."""
    at = [_walls_of(survey, b) for b in bodies]
    best = 0.0
    for wall in survey.scene.room.walls:
        own = [b for b, walls in zip(bodies, at, strict=True) if wall.index in walls]
        best = max(best, sum(high - low for low, high in _spans(own, wall.yaw)) / wall.length if own else 0.0)
    yield Measurement("share of a wall", best, limit("covered"), math.inf, "")


def right_angle(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Two rows at right angles that meet at a corner, looking into it; along walls also at two of them."""
    others = [b for name in said.others for b in survey.standing_for(name)]
    every = [*bodies, *others]
    if len(every) < 2:
        yield counted("things at right angles", len(every), 2)
        return
    lead = every[0]
    turned = [abs(wrap_angle(b.yaw - lead.yaw)) for b in every]
    away = [b for b, t in zip(every, turned, strict=True) if abs(t - math.pi / 2) <= math.radians(limit("turned"))]
    level = [b for b, t in zip(every, turned, strict=True) if t <= math.radians(limit("turned"))]
    yield counted("things at right angles to the first", len(away), 1)
    yield counted("things turned otherwise", len(every) - len(away) - len(level), 0, 0)
    if not away:
        return
    gap = min(apart(a, b) for a in level for b in away)
    yield Measurement("gap at the corner", gap, -math.inf, limit("corner"))
    behind = sum(_behind(a, b) or _behind(b, a) for a in level for b in away)
    yield counted("behind each other", behind, 0, 0)
    if said.around.startswith("wall"):
        walls = set[int]().union(*(_walls_of(survey, b) for b in every))
        yield counted("walls", len(walls), 2)
        yield counted("things at no wall", sum(not _walls_of(survey, b) for b in every), 0, 0)


def _behind(one: Body, other: Body) -> bool:
    """Whether another is behind a thing."""
    return one.local(other.centre)[0] < -one.size[0] / 2


def ends(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """In one line, end at end; heads together are backs together."""
    for a, b in itertools.pairwise(_in_order(bodies)):
        long = 0 if a.size[0] >= a.size[1] else 1
        places = a.local(b.centre)
        yield Measurement("out of line", abs(places[1 - long]), -math.inf, 2 * limit("line"))
        yield Measurement("gap", apart(a, b), -math.inf, limit("backs"))
        turned = math.degrees(abs(wrap_angle(a.yaw - b.yaw, math.pi)))
        yield Measurement("turned", turned, -math.inf, limit("turned"), "deg")


def _in_order(bodies: Sequence[Body]) -> list[Body]:
    first = bodies[0]
    long = 0 if first.size[0] >= first.size[1] else 1
    return sorted(bodies, key=lambda b: first.local(b.centre)[long])


def in_gaps(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """One in each gap between neighbours of what they are between, close to both."""
    hosts = survey.standing_for(said.around)
    asked = survey.brief.entity(said.entity)
    need = asked.count[0] if asked is not None and asked.count is not None else 1
    pairs: set[tuple[int, int]] = set()
    for b in bodies:
        close = sorted((apart(b, h), h.index, h) for h in hosts if h is not b)[:2]
        if len(close) < 2:
            continue
        yield Measurement("gap to the farther of the two", close[1][0], -math.inf, limit("amid"))
        one, other = close[0][2], close[1][2]
        yield from of_between(survey, b, [outline(survey, one), outline(survey, other)], bodies=(one, other))
        pairs.add((min(one.index, other.index), max(one.index, other.index)))
    yield counted("gaps with one in it", len(pairs), need)


def at_sides(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """So many on each side of a table, close to it and looking at it."""
    hosts = survey.standing_for(said.around)
    if not hosts:
        yield counted("things that they are around", 0, 1)
        return
    for host in hosts:  # each of several has its own
        own = [b for b in bodies if min(hosts, key=lambda h: apart(b, h)) is host]
        yield from _at_sides_of(host, said, own)


def _at_sides_of(host: Body, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    have: Counter[str] = Counter()
    for b in bodies:
        x, y = host.local(b.centre)
        ahead, aside = abs(x) - host.size[0] / 2, abs(y) - host.size[1] / 2
        side = ("front" if x > 0 else "back") if ahead >= aside else ("left" if y > 0 else "right")
        have[side] += 1
        yield Measurement("gap to it", apart(b, host), -math.inf, limit("near"))
        off = math.degrees(turn_to(b, host.centre))
        if len(said.sides) != 4 or max(said.sides) > 1:  # at a long side each looks at its own place
            off = min(off, math.degrees(turn_to(b, nearest_point(host, b.centre))))
        if not has_role(b.item.category, "backless_seat"):
            yield Measurement("off its side of it", off, -math.inf, limit("faced"), "deg")
    long = ("front", "back") if host.size[1] >= host.size[0] else ("left", "right")
    short = ("left", "right") if long[0] == "front" else ("front", "back")
    numbers = [have[side] for side in (*long, *short)]
    if len(said.sides) == 4:
        for count, asked in zip(sorted(numbers[:2]) + sorted(numbers[2:]), _asked_sides(said), strict=True):
            yield counted("on a side", count, asked, asked)
    else:
        low, high = sorted(said.sides[:2]) if len(said.sides) > 1 else (0, sum(said.sides))
        oblong = max(host.size[:2]) > limit("oblong") * min(host.size[:2]) and high > 1
        ways = [sorted(numbers[:2])] if oblong else [sorted(numbers[:2]), sorted(numbers[2:])]
        best = min(ways, key=lambda way: abs(way[0] - low) + abs(way[1] - high))
        yield counted("on the fuller side", best[1], high, high)
        yield counted("on the other side", best[0], low, low)


def about_a_u(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Seats at tables of a U, on its outer side or its inner one."""
    tables = survey.standing_for(said.around)
    if not tables:
        yield counted("tables", 0, 1)
        return
    x, y = (sum(t.centre[k] for t in tables) / len(tables) for k in (0, 1))
    for b in bodies:
        near = min(tables, key=lambda t: apart(b, t))
        yield Measurement("gap to its table", apart(b, near), -math.inf, limit("within"))
        out = math.dist(b.centre, (x, y)) - math.dist(near.centre, (x, y))
        low, high = (0.0, math.inf) if said.pattern == "outside" else (-math.inf, 0.0)
        yield Measurement("beyond its table", out, low, high)


def _asked_sides(said: Arrangement) -> list[int]:
    return sorted(said.sides[:2]) + sorted(said.sides[2:4])


def opening(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """A U of desks that are sat at from outside: all backs look inward; what it opens to is on the open side."""
    sign = -1.0 if all(has_role(b.item.category, "desk") for b in bodies) else 1.0
    x = sum(b.centre[0] for b in bodies) / len(bodies)
    y = sum(b.centre[1] for b in bodies) / len(bodies)
    behind = [
        sum(sign * b.local(o.centre)[0] < -b.size[0] / 2 - limit("into") for o in bodies if o is not b) for b in bodies
    ]
    yield counted("things that look out of the U", sum(n > 0 for n in behind), 0, 0)
    spread = max(abs(wrap_angle(b.yaw - o.yaw)) for b in bodies for o in bodies)
    yield Measurement("turned to each other", math.degrees(spread), limit("curved"), math.inf, "deg")
    way = (sign * sum(b.front[0] for b in bodies), sign * sum(b.front[1] for b in bodies))
    for target in survey.standing_for(said.facing)[:1]:
        to = (target.centre[0] - x, target.centre[1] - y)
        off = abs(wrap_angle(math.atan2(to[1], to[0]) - math.atan2(way[1], way[0])))
        yield Measurement("open side off what it opens to", math.degrees(off), -math.inf, limit("faced"), "deg")
