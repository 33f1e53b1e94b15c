"""From faults to grades: how points add up, and which faults put a lid on a grade."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from sceneweaver.rules.design import design_rules
from sceneweaver.rules.faults import fault_kind, fault_kinds, number
from sceneweaver.rules.grades import TRAITS, Traits, grade_weights

from .model import FULL, Alignment, Fault

LINEAR = 5.0
"""Points up to which every point of what was asked for counts in full; what comes after counts less and less, so that
grades never stop telling a bad scene from a worse one."""

SLOPE = 0.2
"""How much a point beside the capping faults lowers a capped grade."""


Call = tuple[str, dict[str, Any]]
"""A call that mends a fault: name of the tool and its inputs."""


@dataclass(frozen=True)
class Finding:
    """A fault, and the lid that it puts on the grade of its criterion (None: none)."""

    fault: Fault
    cap: float | None = None


def finding(
    criterion: str,
    kind: str,
    objects: Iterable[str],
    reason: str,
    suggestion: str = "",
    *,
    points: float | None = None,
    grave: bool = False,
    cap: float | None = None,
    call: Call | None = None,
) -> Finding:
    """A finding in one call.

    Args:
        points: what it takes off; None: what the row of the kind says, or else 1.
        grave: whether the lid of the kind's row lies on the grade.
        cap: a lid of its own.
    """
    row = fault_kind(kind)
    if points is None:
        points = 1.0 if row.points is None else row.points
    if grave:
        cap = row.lid
    tool, inputs = call or (None, {})
    fault = Fault(
        criterion=criterion,
        kind=kind,
        objects=tuple(objects),
        reason=reason,
        suggestion=suggestion,
        tool=tool,
        inputs=inputs,
        points=round(points, 3),
        lid=cap,
    )
    return Finding(fault, cap)


def moved(*ids: str) -> Call:
    """The call that lays some objects out anew; all without any."""
    return "update_layout", {"ids": list(ids)}


def related(kind: str, subject: str, target: str | None = None) -> Call:
    """The call that adds a hard relation."""
    return "add_relation", {"relations": [{"type": kind, "subject": subject, "target": target, "hard": True}]}


def grades(found: Sequence[Finding], asked: Alignment | None = None, traits: Traits | None = None) -> dict[str, float]:
    """The grade 0 to 10 of every criterion.

    ``asked`` is what became of the items of the request: where anything of it is not so, the grade for alignment is not
    above 8, nor above the mean of what its faults leave and of ten times the share of items that is so. ``traits`` are
    those of the room; None: it lacks none of them.

    Strict eyes that see one thing wrong mark down the rest as well, and see what no rule tells: a fault takes points
    off the other criteria too, and every grade begins below the full one (`sceneweaver.rules.grades`). What was asked
    for is graded by itself.
    """
    weights, graded = grade_weights(), {}
    lost = {c: Lost.of([f.fault for f in found if f.fault.criterion == c]) for c in weights.criteria}
    for criterion, row in weights.criteria.items():
        own = lost[criterion]
        points = row.baseline + own.defined + weights.lid * own.lid
        points += row.own_checks * own.checks + row.own_rules * own.rules
        points += row.other_checks * (sum(one.checks for one in lost.values()) - own.checks)
        points += row.other_rules * (sum(one.rules for one in lost.values()) - own.rules)
        if traits is not None:
            points += sum(row.short[name] * short for name, short in shortfalls(traits).items())
        graded[criterion] = round(eased(points), 3)
    rows = [f for f in found if f.fault.criterion == "alignment"]
    left = _lidded(squash(_whole(rows)), rows)
    if asked is not None and asked.share < 1.0:
        left = min(number("faithful"), left, max(1.0, 0.5 * (left + FULL * asked.share)))
    return {**graded, "alignment": round(left, 3)}


def shortfalls(traits: Traits) -> dict[str, float]:
    """By trait, how much less of it a room has than is enough; 0 where it has that."""
    enough = grade_weights().enough
    return {name: max(0.0, enough[name] - getattr(traits, name)) for name in TRAITS}


class Lost(NamedTuple):
    """Points that the faults of one criterion take off, those of one kind up to their limit: of our checks, of design
    rules, and of a user's own checks, which count in full; and the most that a lid stands for: 6.9 for one of 5."""

    checks: float
    rules: float
    defined: float
    lid: float

    @classmethod
    def of(cls, faults: Sequence[Fault]) -> Lost:
        """Those of the faults of one criterion."""
        lids = [FULL * math.log(FULL / f.lid) for f in faults if f.rule is None and f.lid]
        by_rule, others = ([f for f in faults if (f.rule is not None) == ruled] for ruled in (True, False))
        checks, defined = ([f for f in others if (f.kind in fault_kinds()) == known] for known in (True, False))
        return cls(_lost(checks), _lost(by_rule), _lost(defined), max(lids, default=0.0))


def _lidded(grade: float, found: Sequence[Finding]) -> float:
    """The grade of what was asked for under the lids of the findings, each a little lower for what is lost beside."""
    for lid in {f.cap for f in found if f.cap is not None}:
        others = _whole([f for f in found if f.cap is None or f.cap > lid])
        grade = min(grade, max(0.5 * lid, lid - SLOPE * others))
    return grade


def _whole(found: Sequence[Finding]) -> float:
    """Points lost to what was asked for: all of them count."""
    return sum(f.fault.points for f in found)


def _lost(faults: Sequence[Fault]) -> float:
    """Points lost: those of one kind add up to its limit."""
    kinds: dict[str, float] = defaultdict(float)
    for fault in faults:
        kinds[fault.kind] += fault.points
    return sum(min(points, _most(kind)) for kind, points in kinds.items())


def _most(kind: str) -> float:
    """Most points that faults of one kind take together."""
    rule = design_rules().get(kind)
    return rule.most if rule is not None else fault_kind(kind).most


def eased(lost: float) -> float:
    """The grade after ``lost`` points: a point is a point at first, and less the lower the grade is already."""
    return FULL * math.exp(-lost / FULL)


def squash(lost: float) -> float:
    """The grade after ``lost`` points of what was asked for: falls by a point each up to `LINEAR`, never below 0."""
    if lost <= LINEAR:
        return FULL - lost
    rest = FULL - LINEAR
    return rest * math.exp(-(lost - LINEAR) / rest)
