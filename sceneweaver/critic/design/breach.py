"""One breach of a design rule as a finding, with the points of the rule."""

from __future__ import annotations

import math
from collections.abc import Iterable

from sceneweaver.rules.design import design_rules

from ..grade import Call, Finding
from ..model import Fault

Interval = tuple[float | None, float | None]


def breach(
    rule_id: str,
    objects: Iterable[str],
    reason: str,
    *,
    measured: float | None = None,
    allowed: Interval | None = None,
    weight: float = 1.0,
    suggestion: str = "",
    call: Call | None = None,
) -> Finding:
    """A finding for one breach of a rule.

    Args:
        rule_id: id in ``sceneweaver/rules/design``; KeyError when there is none.
        objects: ids of the objects that it is about; none for the room as a whole.
        reason: one sentence with what was measured.
        measured: the value, in the unit of the rule; an infinite one is none.
        allowed: the interval in which it should lie; None at an end: open. None: of what was counted there should be
            nothing.
        weight: share of the rule's points, for what is not all of a breach, or more than one.
        suggestion: one sentence that says what would mend it.
        call: a tool and its inputs that do mend it; None where no tool can.
    """
    rule = design_rules()[rule_id]
    tool, inputs = call or (None, {})
    if measured is not None and not math.isfinite(measured):
        measured = None
    if measured is not None and allowed is None:
        allowed = (0.0, 0.0)
    return Finding(
        Fault(
            criterion=rule.criterion,
            kind=rule.id,
            rule=rule.id,
            objects=tuple(objects),
            reason=reason,
            suggestion=suggestion,
            measured=None if measured is None else round(measured, 4),
            allowed=allowed,
            tool=tool,
            inputs=inputs,
            points=round(weight * rule.points, 3),
        )
    )
