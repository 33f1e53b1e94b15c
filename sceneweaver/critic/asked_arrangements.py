"""Whether things stand as a request sets them out: rows, grids, circles, backs together, groups, stacks.

Rows and columns are found from where the centres are, and not from the relations that made them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.angles import bearing, wrap_angle
from sceneweaver.language.model import Arrangement
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from .group_measures import apart
from .group_patterns import (
    about_a_u,
    aisle,
    along_walls,
    at_sides,
    ends,
    full_wall,
    in_gaps,
    limit,
    opening,
    right_angle,
)
from .survey import FLAT, Survey, turn_to
from .verdict import Asked, counted, met, not_understood, unmet

Checks = Iterator[Measurement]


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each arrangement that the request states; of what stands otherwise what is farthest off."""
    for k, said in enumerate(survey.brief.arrangements):
        item = said.id or f"arrangement-{k}"
        bodies = survey.standing_for(said.entity)
        if not bodies:
            known = survey.brief.entity(said.entity) is not None
            reason = f"'{said.words}': there is no such thing"
            yield (
                unmet("arrangement", item, (), reason, fault="not_arranged")
                if known
                else not_understood("arrangement", item, (), f"'{said.words}': it is not clear of what")
            )
            continue
        found = list(_CHECKS[said.pattern](survey, said, bodies))
        if said.facing not in ("", "each other") and said.pattern not in _LOOKING:
            found += _faced(survey, said, bodies)
        ids = [b.id for b in bodies]
        failing = [m for m in found if not m.ok()]
        if not failing:
            yield met("arrangement", item, ids, f"'{said.words}': so it is", found[0] if found else None)
            continue
        worst = failing[0]
        yield unmet(
            "arrangement",
            item,
            ids,
            f"'{said.words}' does not hold: {worst}",
            worst,
            fault="not_arranged",
            share=len(failing) / len(found),
            suggestion=f"set out {', '.join(ids[:6])} as asked",
        )


# ---- rows ------------------------------------------------------------------------------------------------------------


def _rows(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Rows of equal numbers with even gaps, alike or looking at each other."""
    points = [(b.centre[0], b.centre[1]) for b in bodies]
    if said.upright:
        yield from _hung(said, bodies)
        return
    rows, columns = _shape(said, len(bodies))
    best: list[Measurement] | None = None
    for axis in (bodies[0].yaw, bodies[0].yaw + math.pi / 2):
        lines = _lines(points, axis, limit("line") if len(bodies) < 3 else _tolerance(bodies))
        found = list(_in_lines(said, bodies, lines, axis, rows, columns))
        if best is None or sum(not m.ok() for m in found) < sum(not m.ok() for m in best):
            best = found
    yield from best or ()
    yield from aisle(survey, said, bodies)
    if said.facing == "each other" and rows and rows > 1:
        yield from _opposed(bodies)
    elif said.facing:
        yield from _faced(survey, said, bodies)


def _tolerance(bodies: Sequence[Body]) -> float:
    """How far [m] the centres of one row may be apart across it before they are two rows."""
    return max(limit("line"), limit("row_share") * min(min(b.size[:2]) for b in bodies))


def _shape(said: Arrangement, count: int) -> tuple[int | None, int | None]:
    if said.pattern == "row":
        return 1, said.columns or count
    if said.sides:
        return None, None
    rows, columns = said.rows, said.columns
    if rows is None and columns is not None:
        rows = math.ceil(count / columns)
    if columns is None and rows is not None:
        columns = math.ceil(count / rows)
    return rows, columns


def _lines(points: Sequence[tuple[float, float]], axis: float, tolerance: float) -> list[list[int]]:
    """The points in lines along an axis, by how far they are across it; each line in order along the axis."""
    c, s = math.cos(axis), math.sin(axis)
    across = sorted(range(len(points)), key=lambda k: c * points[k][1] - s * points[k][0])
    lines: list[list[int]] = []
    last = -math.inf
    for k in across:
        value = c * points[k][1] - s * points[k][0]
        if value - last > tolerance:
            lines.append([])
        lines[-1].append(k)
        last = value
    return [sorted(line, key=lambda k: c * points[k][0] + s * points[k][1]) for line in lines]


def _in_lines(
    said: Arrangement,
    bodies: Sequence[Body],
    lines: Sequence[Sequence[int]],
    axis: float,
    rows: int | None,
    columns: int | None,
) -> Checks:
    c, s = math.cos(axis), math.sin(axis)
    if said.sides:
        # Two blocks, one at either hand of a way: as many rows as the longer side has.
        rows, columns = max(said.sides), 2
    if rows is not None:
        shapes = [(rows, columns), (columns, rows)] if said.pattern == "grid" and columns else [(rows, columns)]
        down, full = next((shape for shape in shapes if shape[0] == len(lines)), shapes[0])
        yield counted("rows", len(lines), down or 1, down or 1)
        if full is not None:
            rest = full if len(bodies) >= rows * full else 1
            yield counted("in the longest row", max(map(len, lines)), full, full)
            yield counted("in the shortest row", min(map(len, lines)), rest, full)
    for line in lines:
        values = [c * bodies[k].centre[1] - s * bodies[k].centre[0] for k in line]
        yield Measurement("out of line", max(values) - min(values), -math.inf, 2 * limit("line"))
    gaps = [gap for line in lines for gap in _in_line(said, bodies, line)]
    between = [min(apart(bodies[a], bodies[b]) for a in one for b in other) for one, other in pairwise(lines)]
    by_rows = said.spacing is not None and (columns == 1 or said.facing == "each other")
    if said.pitch is not None:
        steps = [math.dist(bodies[a].centre[:2], bodies[b].centre[:2]) for line in lines for a, b in pairwise(line)]
        slack = limit("spacing") / 2
        if steps:
            yield Measurement("between middles", min(steps), said.pitch - slack, math.inf)
            yield Measurement("between middles", max(steps), 0.0, math.inf if said.at_least else said.pitch + slack)
    elif said.sides or not (between if by_rows else gaps):
        pass
    elif by_rows and said.spacing is not None:
        slack = limit("spacing")
        yield Measurement("between rows", min(between), said.spacing - slack, said.spacing + slack)
    elif said.spacing is not None:
        slack = limit("spacing")
        yield Measurement("gap", min(gaps), said.spacing - slack, said.spacing + slack)
        yield Measurement("gap", max(gaps), said.spacing - slack, said.spacing + slack)
    else:
        yield Measurement("difference of gaps", max(gaps) - min(gaps), -math.inf, limit("even"))
        yield Measurement("gap", max(gaps), -math.inf, limit("row"))
    for line in lines:  # a row looks one way, the next one may look at it; around a table its two sides do
        alike = math.pi if said.around or said.facing == "each other" or _even_sided(bodies) else 2 * math.pi
        turned = [abs(wrap_angle(bodies[k].yaw - bodies[line[0]].yaw, alike)) for k in line]
        yield Measurement("turned", math.degrees(max(turned)), -math.inf, limit("turned"), "deg")


def _even_sided(bodies: Sequence[Body]) -> bool:
    """Whether the things look alike from front and back: tables, stools, rugs."""
    return all(
        has_role(b.item.category, "backless_seat", "pulled_up_to") or b.size[2] <= FLAT or b.item.mount == "ceiling"
        for b in bodies
    )


def _in_line(said: Arrangement, bodies: Sequence[Body], line: Sequence[int]) -> list[float]:
    """The gaps [m] between neighbours of a row, less what parts them: an aisle, or what stands between each two."""
    gaps = [apart(bodies[a], bodies[b]) for a, b in pairwise(line)]
    if said.aisle is not None and gaps and max(gaps) >= said.aisle - limit("spacing"):
        gaps.remove(max(gaps))
    return gaps


def _hung(said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Rows one above the other on one wall, column over column."""
    walls = {round(math.degrees(b.yaw)) % 360 for b in bodies}
    yield counted("walls", len(walls), 1, 1)
    axis = bodies[0].yaw + math.pi / 2
    points = [(math.cos(axis) * b.centre[0] + math.sin(axis) * b.centre[1], b.z[0]) for b in bodies]
    rows = _lines(points, 0.0, limit("line"))
    if said.rows is not None:
        yield counted("rows", len(rows), said.rows, said.rows)
    if said.columns is not None:
        yield counted("in the shortest row", min(map(len, rows)), said.columns, said.columns)
        yield counted(
            "columns", len(_lines([(z, x) for x, z in points], 0.0, limit("line"))), said.columns, said.columns
        )


def _opposed(bodies: Sequence[Body]) -> Checks:
    """Half of the things look one way, half the other, and each has one of these before it."""
    for b in bodies:
        across = [o for o in bodies if abs(wrap_angle(o.yaw - b.yaw - math.pi)) < math.radians(limit("turned"))]
        off = min((math.degrees(turn_to(b, (o.centre[0], o.centre[1]))) for o in across), default=180.0)
        yield Measurement("off the one across", off, -math.inf, limit("faced"), "deg")


def _faced(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Each looks at what all look at, where that is in the scene."""
    for target in survey.standing_for(said.facing)[:1]:
        off = max(math.degrees(turn_to(b, (target.centre[0], target.centre[1]))) for b in bodies)
        yield Measurement("off what is looked at", off, -math.inf, limit("seen"), "deg")


# ---- around a middle -------------------------------------------------------------------------------------------------


def _circle(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Evenly around a middle at one distance, all looking at it."""
    x = sum(b.centre[0] for b in bodies) / len(bodies)
    y = sum(b.centre[1] for b in bodies) / len(bodies)
    radii = [math.dist((x, y), (b.centre[0], b.centre[1])) for b in bodies]
    yield Measurement("difference of distances from the middle", max(radii) - min(radii), -math.inf, 2 * limit("even"))
    angles = sorted(bearing((x, y), (b.centre[0], b.centre[1])) for b in bodies)
    steps = [math.degrees((b - a) % (2 * math.pi)) for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
    even = 360.0 / len(bodies)
    yield Measurement("off even angles", max(abs(s - even) for s in steps), -math.inf, limit("spread"), "deg")
    off = max(math.degrees(turn_to(b, (x, y))) for b in bodies)
    yield Measurement("off the middle", off, -math.inf, limit("faced"), "deg")
    for target in survey.standing_for(said.around)[:1]:
        away = math.dist((x, y), (target.centre[0], target.centre[1]))
        yield Measurement("middle off what it is around", away, -math.inf, limit("near"))


def _open_curve(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Looking inward over an open side: each front has most of the others ahead of it or beside it, none behind."""
    behind = [
        sum(b.local((o.centre[0], o.centre[1]))[0] < -b.size[0] / 2 for o in bodies if o is not b) for b in bodies
    ]
    yield counted("things behind others", sum(n > 0 for n in behind), 0, 0)
    x = sum(b.centre[0] for b in bodies) / len(bodies)
    y = sum(b.centre[1] for b in bodies) / len(bodies)
    spread = max(abs(wrap_angle(b.yaw - o.yaw)) for b in bodies for o in bodies)
    yield Measurement("turned to each other", math.degrees(spread), limit("curved"), math.inf, "deg")
    ends = max(math.dist((a.centre[0], a.centre[1]), (b.centre[0], b.centre[1])) for a in bodies for b in bodies)
    yield Measurement(
        "depth of the curve", max(math.dist((x, y), (b.centre[0], b.centre[1])) for b in bodies), limit("deep"), ends
    )
    if len(bodies) > 3:
        angles = sorted(bearing((x, y), (b.centre[0], b.centre[1])) for b in bodies)
        steps = [math.degrees((b - a) % (2 * math.pi)) for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
        others = (360.0 - max(steps)) / (len(steps) - 1)
        yield Measurement("open side by the other steps", max(steps) / others, limit("open_side"), math.inf)
    for target in survey.standing_for(said.facing or said.around)[:1]:
        off = min(math.degrees(turn_to(b, (target.centre[0], target.centre[1]))) for b in bodies)
        yield Measurement("off what is looked at", off, -math.inf, limit("faced"), "deg")


def _half_circle(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """On one circle about a middle that all look at, over about half of it, what is looked at beyond the open side."""
    if len(bodies) < 3:
        yield from _open_curve(survey, said, bodies)
        return
    points = [(b.centre[0], b.centre[1]) for b in bodies]
    middle = _circumcentre(points)
    radii = [math.dist(middle, p) for p in points]
    yield Measurement("difference of distances from the middle", max(radii) - min(radii), -math.inf, 2 * limit("even"))
    angles = sorted(bearing(middle, p) % (2 * math.pi) for p in points)
    steps = [(b - a) % (2 * math.pi) for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
    open_ = max(steps)
    span = math.degrees(2 * math.pi - open_)
    yield Measurement("angle of the half circle", span, limit("arc_least"), limit("arc_most"), "deg")
    others = sorted(math.degrees(s) for s in steps)[:-1]
    yield Measurement("difference of angles", others[-1] - others[0], -math.inf, limit("spread"), "deg")
    off = max(math.degrees(turn_to(b, middle)) for b in bodies)
    yield Measurement("off the middle", off, -math.inf, limit("faced"), "deg")
    way = angles[steps.index(open_)] + open_ / 2
    for target in survey.standing_for(said.facing or said.around)[:1]:
        if not said.facing and math.dist(middle, (target.centre[0], target.centre[1])) <= limit("near"):
            continue  # they are around it
        seen = bearing(middle, (target.centre[0], target.centre[1]))
        away = math.degrees(abs(wrap_angle(seen - way)))
        yield Measurement("off the open side", away, -math.inf, limit("faced"), "deg")


def _circumcentre(points: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """The middle of the circle that is nearest to some points, by least squares."""
    xy = np.asarray(points)
    left = np.column_stack([2 * xy, np.ones(len(xy))])
    x, y, _ = np.linalg.lstsq(left, (xy**2).sum(axis=1), rcond=None)[0]
    return float(x), float(y)


# ---- pairs, groups, stacks -------------------------------------------------------------------------------------------


def _backs(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Each has its back at the back of another."""
    for b in bodies:
        gaps = []
        for o in bodies:
            if o is b or abs(wrap_angle(o.yaw - b.yaw - math.pi)) > math.radians(limit("turned")):
                continue
            ahead, aside = b.local((o.centre[0], o.centre[1]))
            if ahead < 0 and abs(aside) < b.size[1] / 2:
                gaps.append(-ahead - b.size[0] / 2 - o.size[0] / 2)
        yield Measurement("between backs", min(gaps, default=math.inf), -limit("into"), limit("backs"))


def _clusters(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """So many groups of so many, each around its thing or close together."""
    hosts = survey.standing_for(said.around) if said.around else []
    if hosts:
        sizes = []
        for host in hosts:
            near = {o.id for o, _ in survey.near(host, limit("near"))}
            own = [b for b in bodies if b.id in near]
            sizes.append(len(own))
            for b in own:
                off = math.degrees(turn_to(b, (host.centre[0], host.centre[1])))
                yield Measurement("off the middle of its group", off, -math.inf, limit("faced"), "deg")
    else:
        left, sizes = list(bodies), []
        while left:
            group = [left.pop()]
            for member in group:
                close = [o for o in left if apart(member, o) <= limit("within")]
                group += close
                left = [o for o in left if o not in close]
            sizes.append(len(group))
    if said.groups is not None:
        yield counted("groups", len(sizes), said.groups, said.groups)
    if said.columns is not None and sizes:
        yield counted("in the smallest group", min(sizes), said.columns, said.columns)
        yield counted("in the largest group", max(sizes), said.columns, said.columns)


def _islands(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Each stands free of the walls and of the others."""
    for b in bodies:
        yield Measurement("from the walls", float(survey.wall_gaps[b.index]), limit("wall"), math.inf)
        others = [apart(b, o) for o in bodies if o is not b]
        least = (said.spacing or limit("free")) - limit("spacing")
        yield Measurement("between islands", min(others, default=math.inf), least, math.inf)


def _sides(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """So many on one side of a thing and on the other; without a thing: two blocks with a way between."""
    hosts = survey.standing_for(said.around) if said.around else []
    if not hosts:
        yield from _rows(survey, said, bodies)
        return
    yield from at_sides(survey, said, bodies)


def _stacks(survey: Survey, said: Arrangement, bodies: Sequence[Body]) -> Checks:
    """Things of the kind that carry each other, so many or so high."""
    own = {b.id: b for b in bodies}
    heights: dict[str, list[Body]] = {}
    for b in bodies:
        base = b
        while base.item.support is not None and base.item.support.object in own:
            base = own[base.item.support.object]
        heights.setdefault(base.id, []).append(b)
    stacks = [s for s in heights.values() if len(s) > 1]
    rows = said.rows or (2 if said.height is None else None)
    if rows is not None:
        whole = [s for s in stacks if len(s) >= (len(bodies) if said.rows is None and len(bodies) <= 4 else rows)]
        yield counted("stacks of the asked height", len(whole), said.groups or 1)
    if said.height is not None:
        tall = max((max(b.z[1] for b in s) - min(b.z[0] for b in s) for s in stacks), default=0.0)
        yield Measurement("height of the highest stack", tall, said.height - limit("stacked"), math.inf)


_CHECKS: dict[str, Callable[[Survey, Arrangement, Sequence[Body]], Checks]] = {
    "row": _rows,
    "rows": _rows,
    "grid": _rows,
    "circle": _circle,
    "semicircle": _half_circle,
    "u": opening,
    "back_to_back": _backs,
    "stack": _stacks,
    "cluster": _clusters,
    "islands": _islands,
    "sides": _sides,
    "walls": along_walls,
    "between": in_gaps,
    "right_angle": right_angle,
    "head_to_head": _backs,
    "end_to_end": ends,
    "outside": about_a_u,
    "inside": about_a_u,
    "wall": full_wall,
}
"""What is measured of each pattern."""

_LOOKING = ("row", "rows", "grid", "sides", "u", "semicircle")
"""Patterns whose measures have what their things look at."""
