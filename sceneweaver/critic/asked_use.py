"""Whether a room can be used for what it was asked for, which every request means.

One has to get at what stands on the floor; what people are there for has to be there, as asked; and nothing may be in
the way of those who sit or work there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from sceneweaver.rules.faults import number
from sceneweaver.verify.measure import Measurement

from .model import USE, Fault
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
    whole = sum(
        number("half_served") if item.status in ("partly", "substituted") else item.status == "met" for item in needed
    )
    served = counted("share of what it is for", whole / max(1, len(needed)), number("served"))
    short = [item for item in needed if item.status != "met"]
    lacking = next((item for item in short if item.status == "unmet"), None)
    if lacking is None and needed and not served.ok():
        lacking = short[0]
    if lacking is not None:
        reason = f"{len(short)} of {len(needed)} things that it is for are not quite so: {lacking.reason}"
        yield partly("room", USE, lacking.objects, reason, served)
        return
    for fault in faults:
        if fault.kind in HINDER:
            yield partly("room", USE, fault.objects, fault.reason, m)
            return
    yield met("room", USE, (), "all that stands on the floor can be reached from the door", m)


__all__ = ["outcomes"]
