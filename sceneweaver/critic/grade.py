"""From faults to grades: how points add up, and which faults put a lid on a grade."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from sceneweaver.knowledge.design_rules import design_rules

from .model import CRITERIA, Fault

FULL = 10.0

LINEAR = 5.0
"""Points up to which every point counts in full; what comes after counts less and less, so that grades never stop
telling a bad scene from a worse one."""

KIND_LIMIT = 3.0
"""Most points that faults of one kind take together, where `LIMITS` says nothing else."""

LIMITS = {
    "collision": 6.0,
    "out_of_bounds": 6.0,
    "unsupported": 6.0,
    "dropped": 6.0,
    "blocked_zone": 5.0,
    "blocked_opening": 5.0,
    "missing_needed": 8.0,
    "foreign_object": 7.0,
    "wrong_orientation": 6.0,
    "wrong_size": 6.0,
    "missing_usual": 4.0,
    "empty_support": 4.0,
    "bare": 6.0,
    "unwalkable": 5.0,
    "empty_room": 10.0,
}

SLOPE = 0.2
"""How much a point beside the capping faults lowers a capped grade."""


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
    points: float = 1.0,
    cap: float | None = None,
    tool: str | None = None,
    inputs: dict[str, Any] | None = None,
) -> Finding:
    """A finding in one call; ``inputs`` are those of ``tool``."""
    fault = Fault(
        criterion=criterion,
        kind=kind,
        objects=tuple(objects),
        reason=reason,
        suggestion=suggestion,
        tool=tool,
        inputs=inputs or {},
        points=round(points, 3),
    )
    return Finding(fault, cap)


def grades(found: Sequence[Finding]) -> dict[str, float]:
    """The grade 0 to 10 of every criterion."""
    return {criterion: _grade([f for f in found if f.fault.criterion == criterion]) for criterion in CRITERIA}


def _grade(found: Sequence[Finding]) -> float:
    grade = squash(_lost(found))
    for lid in {f.cap for f in found if f.cap is not None}:
        others = _lost([f for f in found if f.cap is None or f.cap > lid])
        grade = min(grade, max(0.5 * lid, lid - SLOPE * others))
    return round(grade, 3)


def _lost(found: Sequence[Finding]) -> float:
    """Points lost: those of one kind add up to its limit, but all that was asked for counts in full."""
    kinds: dict[str, float] = defaultdict(float)
    for f in found:
        if f.fault.criterion != "alignment":
            kinds[f.fault.kind] += f.fault.points
    asked = sum(f.fault.points for f in found if f.fault.criterion == "alignment")
    return asked + sum(min(points, _most(kind)) for kind, points in kinds.items())


def _most(kind: str) -> float:
    """Most points that faults of one kind take together."""
    rule = design_rules().get(kind)
    return rule.most if rule is not None else LIMITS.get(kind, KIND_LIMIT)


def squash(lost: float) -> float:
    """The grade after ``lost`` points: falls by a point each at first, never below 0, and never stands still."""
    if lost <= LINEAR:
        return FULL - lost
    rest = FULL - LINEAR
    return rest * math.exp(-(lost - LINEAR) / rest)
