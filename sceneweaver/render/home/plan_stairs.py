"""Stairs in plan: treads, the cut through the flight on the lower storey, and an arrow up."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sceneweaver.home import Home, Stair
from sceneweaver.home.treads import Tread, treads

from ..canvas import Point, Text
from ..shapes import Plan
from .plan_walls import LINE, POCHE, draw_head

_CUT = 1.2
"""Height [m] at which a plan cuts a storey."""

_TREAD = (255, 255, 255)


def draw_stairs(plan: Plan, home: Home, storey: str) -> None:
    """The stairs that begin on a storey, cut, and those that come up to it, seen from above."""
    for stair in home.stairs:
        if home.room(stair.lower).storey == storey:
            height = home.storey_of(stair.upper).elevation - home.storey_of(stair.lower).elevation
            _draw_flights(plan, stair, _CUT / (height / stair.risers))
        elif home.room(stair.upper).storey == storey:
            _draw_flights(plan, stair, math.inf)


def _draw_flights(plan: Plan, stair: Stair, cut: float) -> None:
    """A stair of which steps up to the number ``cut`` are seen and the others dashed."""
    steps = treads(stair)
    for step in steps:
        points = plan.points((float(x), float(y)) for x, y in step.plan)
        if step.number <= cut:
            plan.polygon(points, _TREAD, LINE, 0.9)
    for step in steps:
        if step.number > cut:
            points = plan.points((float(x), float(y)) for x, y in step.plan)
            plan.dashed(points, (*LINE, 140), 0.8, (4.0, 3.0), closed=True)
    line = plan.points(_walked(stair, steps))
    if math.isinf(cut):
        _draw_arrow(plan, line[::-1], "DN")
        return
    _draw_break(plan, steps, cut)
    _draw_arrow(plan, line, "UP")


def _walked(stair: Stair, steps: Sequence[Tread]) -> list[tuple[float, float]]:
    """The line along which a stair is walked up [m]: in the middle of its flights, square over its landings."""
    up = np.asarray(stair.up, dtype=float)
    left = np.array([-up[1], up[0]])
    middles = [step.plan.mean(axis=0) for step in steps]
    first = steps[0].plan @ up
    line = [middles[0] + (first.min() - middles[0] @ up) * up]
    for k, step in enumerate(steps):
        if min(np.ptp(step.plan @ up), np.ptp(step.plan @ left)) > 1.5 * stair.going and 0 < k < len(steps) - 1:
            line += [(middles[k] @ up) * up + (middles[other] @ left) * left for other in (k - 1, k + 1)]
            if stair.shape == "l":
                line.pop()
    end = steps[-1].plan
    way = middles[-1] - line[-1]
    way = way / max(float(np.linalg.norm(way)), 1e-9)
    line.append(middles[-1] + (float((end @ way).max()) - float(middles[-1] @ way)) * way)
    return [(float(x), float(y)) for x, y in line]


def _draw_break(plan: Plan, steps: Sequence[Tread], cut: float) -> None:
    """Two slanting lines across the step at which the flight is cut."""
    at = next((step for step in steps if step.number > cut), None)
    if at is None:
        return
    # Across the step, slanting from its near to its far edge; the walk goes across, so along its first side or not.
    corners = plan.points((float(x), float(y)) for x, y in at.plan)
    before = steps[max(0, at.number - 2)].plan.mean(axis=0)
    way = at.plan.mean(axis=0) - before
    side = at.plan[1] - at.plan[0]
    along = abs(float(way @ side)) > abs(float(way @ (at.plan[3] - at.plan[0])))
    a, b = (corners[0], corners[2]) if along else (corners[1], corners[3])
    length = math.dist(a, b) or 1.0
    nx, ny = -(b[1] - a[1]) / length * 3.0 * plan.unit, (b[0] - a[0]) / length * 3.0 * plan.unit
    for sign in (-0.5, 0.5):
        ends = ((a[0] + sign * nx, a[1] + sign * ny), (b[0] + sign * nx, b[1] + sign * ny))
        plan.line(ends, POCHE, 1.2)


def _draw_arrow(plan: Plan, line: Sequence[Point], text: str) -> None:
    """A line with a dot where it begins, a head where it ends, and a word beside its beginning."""
    tip, before = line[-1], line[-2]
    length = math.dist(tip, before)
    short = min(10 * plan.unit, 0.3 * length)
    end = (tip[0] + (before[0] - tip[0]) * short / length, tip[1] + (before[1] - tip[1]) * short / length)
    start, after = line[0], line[1]
    length = math.dist(start, after)
    into = min(0.12 * plan.scale, 0.2 * length)
    begin = (start[0] + (after[0] - start[0]) * into / length, start[1] + (after[1] - start[1]) * into / length)
    run = [begin, *line[1:-1], end]
    plan.line(run, POCHE, 1.2)
    plan.disc(begin, 3.2 * plan.unit, POCHE)
    draw_head(plan, run[-2], run[-1], 9 * plan.unit)
    size = plan.font_size(12)
    x, y = (after[0] - start[0]) / length, (after[1] - start[1]) / length
    upright = abs(y) > abs(x)
    aside = 0.85 * size
    at = (begin[0] + 1.6 * size * x - aside * abs(y), begin[1] + 1.6 * size * y - aside * abs(x))
    plan.text(Text((text,), at, size, POCHE, _TREAD, max(1, round(2 * plan.unit)), upright=upright))
