"""Whether a room can be used for what it was asked for, which every request means.

One has to get at what stands on the floor; what people are there for has to be there, as asked; and nothing may be in
the way of those who sit or work there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from sceneweaver.rules.faults import number
from sceneweaver.verify.measure import Measurement

from .model import USE, Fault, ItemOutcome
from .survey import Survey
from .verdict import Asked, counted, met, partly

NEEDED = ("entity", "capacity", "arrangement")
"""Kinds of items without which a room is not what it was asked for."""

HINDER = frozenset(("behind_seats", "cramped_seat", "incomplete_group", "work_triangle"))
"""Kinds of faults with which a place cannot be used, though one gets to it."""


def outcomes(survey: Survey, told: Sequence[Asked], faults: Iterable[Fault]) -> Iterator[Asked]:
    """That the room can be used, once something stands on its floor."""
    share = survey.report.reachable_share
    if share is None or not any(b.item.mount == "floor" for b in survey.bodies):
        return
    m = Measurement("share within reach", share, number("within_reach"), 1.0)
    if not m.ok(1e-9):
        reason = f"{1.0 - share:.0%} of what stands on the floor cannot be reached from the door"
        yield partly("room", USE, (), reason, m)
        return
    needed = [item.outcome for item in told if item.outcome.kind in NEEDED and item.outcome.status != "assumed"]
    if (lacking := _lacking(needed)) is not None:
        good = sum(item.status == "met" for item in needed)
        share_met = counted("share of what it is for", good / len(needed), number("served"))
        yield partly("room", USE, lacking.objects, lacking.reason, share_met)
        return
    for fault in faults:
        if fault.kind in HINDER:
            yield partly("room", USE, fault.objects, fault.reason, m)
            return
    yield met("room", USE, (), "all that stands on the floor can be reached from the door", m)


def _lacking(needed: Sequence[ItemOutcome]) -> ItemOutcome | None:
    """What people are there for that is not there, or the first of those that are so in part where these are many."""
    unmet = next((item for item in needed if item.status == "unmet"), None)
    short = [item for item in needed if item.status != "met"]
    if unmet is None and len(needed) - len(short) < number("served") * len(needed):
        return short[0]
    return unmet


__all__ = ["outcomes"]
