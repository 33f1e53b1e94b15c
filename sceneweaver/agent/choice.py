"""Which of many valid layouts is good: rows of the rules as terms that the engine rates all candidates by.

A term is about the objects of a scene before their poses are known, so what belongs together is read from relations and
categories. What a relation of the room demands anyway may be among the terms: then it takes nothing off. Rows of the
kinds of faults beside the design rules make terms as well. The critic takes their points off one criterion, where those
of a rule count for all: such a term has a share of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from sceneweaver.critic.design.query import cases
from sceneweaver.knowledge import RoomType
from sceneweaver.layout import QualityTerm
from sceneweaver.rules.design import Row, design_rules
from sceneweaver.rules.faults import fault_kinds
from sceneweaver.rules.grades import grade_weights
from sceneweaver.scene import Scene

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
        for term in _terms(plan, row, rule.id, {**rule.limits, "points": rule.points}, rule.most)
    ]
    felt = grade_weights().criteria.values()
    others = len(felt) - 1
    # what a point of a check is worth beside one of a rule, over all grades
    share = sum(row.own_checks + others * row.other_checks for row in felt)
    share /= sum(row.own_rules + others * row.other_rules for row in felt)
    for kind in fault_kinds().values():
        for row in kind.rows:
            if row.span is not None:
                found += _terms(plan, row, kind.id, {**kind.limits, "points": kind.points}, kind.most, share)
    return found


def _terms(
    plan: Planned, row: Row, rule: str, scope: Mapping[str, Any], most: float, felt: float = 1.0
) -> Iterator[QualityTerm]:
    """The terms of one row; ``points`` of the scope are those of its rule, and ``felt`` how much a point counts."""
    for case in cases(plan, row.of, scope):
        for name, expression in row.let.items():
            case[name] = expression.value(case)
        if row.where is not None and not row.where.value(case):
            continue
        assert row.measure is not None and row.span is not None
        kind, objects = row.measure.value(case)
        unit = math.radians if kind in IN_DEGREES else float
        bounds = {"low": row.low, "high": row.high, "span": row.span}
        points = case["points"] if row.points is None else float(row.points.value(case))
        yield QualityTerm(
            kind,
            objects,
            weight=felt * float(row.share.value(case)) * points,
            params={name: float(e.value(case)) for name, e in row.params.items()},
            rule=rule,
            most=felt * most,
            **{name: unit(e.value(case)) for name, e in bounds.items() if e is not None},
        )
