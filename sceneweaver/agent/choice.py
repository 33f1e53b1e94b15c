"""Which of many valid layouts is good: rows of the design rules as terms that the engine rates all candidates by.

A term is about the objects of a scene before their poses are known, so what belongs together is read from relations and
categories. What a relation of the room demands anyway may be among the terms: then it takes nothing off.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.critic.design.query import cases
from sceneweaver.knowledge import RoomType
from sceneweaver.layout import QualityTerm
from sceneweaver.rules.design import DesignRule, Row, design_rules
from sceneweaver.scene import Scene

from .choice_order import terms as order_terms
from .planned import Planned

IN_DEGREES = frozenset(("bearing", "turned"))
"""Measures whose rows are in degrees, and terms in radians."""


def choice_terms(scene: Scene, room_type: RoomType) -> list[QualityTerm]:
    """The terms of design quality for a scene in a kind of room, whatever its poses are.

    Args:
        scene: what is to be laid out; members of the terms are its objects, doors, windows and walls.
        room_type: the kind of room, which says what rules there are.
    """
    plan = Planned(scene, room_type.name)
    found = [
        term
        for rule in design_rules().values()
        for row in rule.rows
        if row.span is not None and rule.points > 0 and rule.applies(plan.room) and row.applies(plan.room)
        for term in _terms(plan, rule, row)
    ]
    return [*found, *order_terms(plan)]


def _terms(plan: Planned, rule: DesignRule, row: Row) -> Iterator[QualityTerm]:
    """The terms of one row."""
    for case in cases(plan, row.of, rule.limits):
        for name, expression in row.let.items():
            case[name] = expression.value(case)
        if row.where is not None and not row.where.value(case):
            continue
        assert row.measure is not None and row.span is not None
        kind, objects = row.measure.value(case)
        unit = math.radians if kind in IN_DEGREES else float
        bounds = {"low": row.low, "high": row.high, "span": row.span}
        yield QualityTerm(
            kind,
            objects,
            weight=float(row.share.value(case)) * rule.points,
            params={name: float(e.value(case)) for name, e in row.params.items()},
            rule=rule.id,
            most=rule.most,
            **{name: unit(e.value(case)) for name, e in bounds.items() if e is not None},
        )
