"""What the checker of plans says."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class PlanViolation:
    """A rule that a plan breaks.

    Attributes:
        rule: id of the row of the profile, or "programme-..." for what the programme asks for.
        rooms: ids of the rooms that it is about.
        detail: one line with the numbers.
        amount: how far the measure is out of its bounds, in the measure's unit.
    """

    rule: str
    rooms: tuple[str, ...]
    detail: str
    amount: float


@dataclass(frozen=True)
class PlanReport:
    """Whether a plan keeps all hard rules, and how well it keeps the soft ones.

    Attributes:
        valid: no hard rule is broken.
        violations: of hard rules.
        soft: of soft rules.
        areas: floor between the walls [m2] by room.
        cost: of the soft rules that are broken, see `Rule.cost`; 0 is best.
        measures: values of the plan's own measures, such as ``circulation_share``.
    """

    valid: bool
    violations: tuple[PlanViolation, ...]
    soft: tuple[PlanViolation, ...] = ()
    areas: dict[str, float] = field(default_factory=dict)
    cost: float = 0.0
    measures: dict[str, float] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """The report as plain data for JSON."""
        from dataclasses import asdict

        return asdict(self)
