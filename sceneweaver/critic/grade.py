"""From faults to grades: how points add up, and which faults put a lid on a grade."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from sceneweaver.rules.design import design_points, design_rules
from sceneweaver.rules.faults import fault_kind, number

from .model import CRITERIA, Alignment, Fault

FULL = 10.0

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


def grades(found: Sequence[Finding], asked: Alignment | None = None) -> dict[str, float]:
    """The grade 0 to 10 of every criterion.

    ``asked`` is what became of the items of the request: where anything of it is not so, the grade for alignment is not
    above 8, nor above the mean of what its faults leave and of ten times the share of items that is so.

    Strict eyes that see one thing wrong mark down the rest as well, and see what no rule tells: a breach of a design
    rule takes points off the other criteria too, and every grade begins a little below the full one
    (`DesignPoints`). What was asked for is graded by itself.
    """
    fitted, graded = design_points(), {}
    by_criterion: dict[str, list[Finding]] = {criterion: [] for criterion in CRITERIA}
    for f in found:
        by_criterion[f.fault.criterion].append(f)
    breaches = {c: _lost([f for f in rows if f.fault.rule is not None]) for c, rows in by_criterion.items()}
    for criterion, rows in by_criterion.items():
        if criterion == "alignment":
            left = _lidded(squash(_whole(rows)), rows)
            if asked is not None and asked.share < 1.0:
                left = min(number("faithful"), left, max(1.0, 0.5 * (left + FULL * asked.share)))
            graded[criterion] = round(left, 3)
            continue
        others = sum(lost for c, lost in breaches.items() if c != criterion)
        felt = fitted.weights[criterion] * breaches[criterion] + fitted.others[criterion] * others
        lost = fitted.baseline[criterion] + older_lost([f.fault for f in rows]) + felt
        graded[criterion] = round(eased(lost), 3)
    return graded


def older_lost(faults: Iterable[Fault]) -> float:
    """Points that faults of one criterion lose beside the design rules: their sum, or what the lowest lid says.

    A lid of 5 halves the grade.
    """
    kinds: dict[str, float] = defaultdict(float)
    most = 0.0
    for fault in faults:
        if fault.rule is None:
            kinds[fault.kind] += fault.points
            most = max(most, FULL * math.log(FULL / fault.lid) if fault.lid else 0.0)
    total = sum(min(points, _most(kind)) for kind, points in kinds.items())
    return max(total, most + SLOPE * total) if most else total


def _lidded(grade: float, found: Sequence[Finding]) -> float:
    """The grade of what was asked for under the lids of the findings, each a little lower for what is lost beside."""
    for lid in {f.cap for f in found if f.cap is not None}:
        others = _whole([f for f in found if f.cap is None or f.cap > lid])
        grade = min(grade, max(0.5 * lid, lid - SLOPE * others))
    return grade


def _whole(found: Sequence[Finding]) -> float:
    """Points lost to what was asked for: all of them count."""
    return sum(f.fault.points for f in found)


def _lost(found: Sequence[Finding]) -> float:
    """Points lost: those of one kind add up to its limit."""
    kinds: dict[str, float] = defaultdict(float)
    for f in found:
        kinds[f.fault.kind] += f.fault.points
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
