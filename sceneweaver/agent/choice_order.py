"""Terms of design quality for what the critic measures beside the design rules: order, and whether one gets to things.

The critic takes their points off one criterion, where those of a rule count for all: a term has `SHARE` of them.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.assets import categories
from sceneweaver.critic import kinds
from sceneweaver.critic.access import RISE
from sceneweaver.critic.order import CROOKED, STRAIGHT
from sceneweaver.critic.physical import NEEDED
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge.small_things import left_about
from sceneweaver.layout import QualityTerm
from sceneweaver.rules.design import design_points
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import CATALOGUE, SceneObject
from sceneweaver.verify.walkable import ARM, RADIUS

from .planned import Planned

_FELT = design_points()
SHARE = 4.0 / (sum(_FELT.weights.values()) + 3.0 * sum(_FELT.others.values()))
"""What a point off one criterion is worth beside one of a rule, which the other three feel as well."""

MOST_REACHED = 32
"""Pieces of which is measured whether one gets to them."""

QUARTER = math.pi / 2


def terms(plan: Planned) -> Iterator[QualityTerm]:
    """The terms of order and access of a scene."""
    yield from _reached(plan)
    yield from _cramped(plan)
    yield from _turned(plan)
    yield from _rows(plan)


def _term(
    rule: str,
    kind: str,
    *objects: str,
    points: float,
    span: float,
    low: float = -math.inf,
    high: float = math.inf,
    **params: float,
) -> QualityTerm:
    bounds = {name: value for name, value in (("low", low), ("high", high)) if math.isfinite(value)}
    most = SHARE * fault_kind(rule).most
    return QualityTerm(kind, objects, span=span, weight=SHARE * points, params=params, rule=rule, most=most, **bounds)


def _reached(plan: Planned) -> Iterator[QualityTerm]:
    """Pieces that a robot gets to at a side where they are used: to seats and what has seats at any."""
    if not plan.scene.room.doors:
        return
    ties = CATALOGUE.with_role("seat")
    tucked = {name for r in plan.scene.relations if r.type in ties for name in (r.subject, *r.targets)}
    grave = ("asked", "needed")
    pieces = sorted(plan.standing, key=lambda o: o.intent.priority not in grave)[:MOST_REACHED]
    for o in pieces:
        side, depth = _used_side(o, o.id in tucked)
        points = NEEDED if o.intent.priority in grave else 0.25 * NEEDED
        # the grid hides a step of clearance
        low, span = 1.6 * RADIUS, 0.8 * RADIUS
        yield _term("unreachable", "way", o.id, points=points, low=low, span=span, reach=ARM + depth, side=side)


def _used_side(o: SceneObject, tucked: bool) -> tuple[float, float]:
    """The side at which a piece is used (-1: any) and how far its zone reaches out there [m]."""
    depths = {0.0: 0.0} if not tucked else {}
    for zone in o.zones:
        if zone.hard:
            xs, ys = [p[0] for p in zone.polygon], [p[1] for p in zone.polygon]
            out = {0.0: max(xs) - o.size[0] / 2, 1.0: max(ys) - o.size[1] / 2}
            out |= {2.0: -min(xs) - o.size[0] / 2, 3.0: -min(ys) - o.size[1] / 2}
            side = max(out, key=lambda name: out[name])
            depths[side] = max(depths.get(side, 0.0), out[side])
    if len(depths) == 1:
        return next(iter(depths.items()))
    return -1.0, 0.0


def _cramped(plan: Planned) -> Iterator[QualityTerm]:
    """Seats at tables with hardly any room behind them."""
    least = 0.4 * RISE
    seated = fault_kind("cramped_seat").points or 0.0
    seats = [o.id for o in plan.standing if kinds.upright_seat(o.category) or o.category in ("bench", "booth_seat")]
    for seat in plan.standing:
        tables = [o.id for o in plan.tied(seat, "seated_at")]
        if kinds.upright_seat(seat.category) and tables:
            others = [name for name in seats if name != seat.id] + tables
            yield _term("cramped_seat", "clear", seat.id, *others, points=seated, low=least, span=0.05, side=2)


def _turned(plan: Planned) -> Iterator[QualityTerm]:
    """Pieces that are not parallel to a wall or to their table."""
    walls = plan.scene.room.walls
    axes = {round(math.degrees(wrap_angle(w.yaw - walls[0].yaw, QUARTER))) % 90 for w in walls if w.length >= 0.4}
    if axes not in ({0}, {0, 45}):
        return
    period = QUARTER if axes == {0} else QUARTER / 2
    for o in plan.standing:
        if _round(o) or o.category in kinds.TALL_PLANTS or left_about(o.category, plan.room):
            continue
        base, turn = "wall:0", period
        if kinds.upright_seat(o.category):
            tables = plan.tied(o, "seated_at")
            if not tables or "round" in tables[0].category or tables[0].category == "conference_table":
                continue
            base, turn = tables[0].id, QUARTER
        yield _term("crooked", "turned", base, o.id, points=0.4, high=STRAIGHT, span=STRAIGHT, period=turn)
        if o.category in kinds.WALL_BACKED | kinds.BEDS | kinds.LONG_BEDS | kinds.SOFAS | kinds.DESKS | kinds.DINING:
            points = 0.4 + min(1.2, 0.7 * o.size[0] * o.size[1])
            yield _term("askew", "turned", base, o.id, points=points, high=CROOKED, span=STRAIGHT, period=turn)


def _round(o: SceneObject) -> bool:
    row, (d, w, _) = categories().get(o.category), o.size
    return "round" in o.category or (abs(d - w) < 0.03 * max(d, w) and (row is None or not row.sides))


def _rows(plan: Planned) -> Iterator[QualityTerm]:
    """Equals that nearly stand in line: pieces of a kind, and the seats at one side of a table."""
    sets: dict[tuple[str, str], list[SceneObject]] = defaultdict(list)
    for o in plan.standing:
        seat = kinds.upright_seat(o.category)
        tables = plan.tied(o, "seated_at") if seat else []
        if o.category not in kinds.TALL_PLANTS and bool(tables) == seat:
            sets[o.category, tables[0].id if tables else ""].append(o)
    for (_, table), pieces in sets.items():
        if len(pieces) >= (2 if table else 3):
            reach = 1.5 * max(max(o.size[:2]) for o in pieces) + 0.8
            each = 0.25 if table else 0.4
            names = [o.id for o in pieces]
            seats = 1.0 if table else 0.0
            yield _term("uneven_row", "uneven", *names, points=1.5, high=0.0, span=1.5 / each, reach=reach, seats=seats)
