"""What became of the states that a request tells of things, measured on their bodies in the scene."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from sceneweaver.assets import categories
from sceneweaver.assets.states import State
from sceneweaver.language.told_states import pulled_as_told
from sceneweaver.rules.faults import fault_kind
from sceneweaver.scene import Window
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from .seats import table_of
from .survey import Survey
from .verdict import Asked, met, text_of, unmet

LIMITS = fault_kind("wrong_state").limits
"""What a body in a state measures: see the row."""


def measured_state(body: Body, state: State, posture: str | None, windows: Sequence[Window]) -> Measurement | None:
    """How far a body is in a state; None where the scene does not tell.

    Args:
        body: Where it stands.
        state: A row of ``states.yaml``.
        posture: How such a thing is drawn in it.
        windows: Those of the room.
    """
    low, high = state.range
    given = body.item.attributes.get("posture")
    in_posture = float(posture is None or given == posture)
    if state.becomes and body.item.category not in state.becomes.values():
        in_posture = 0.0
    if state.measure == "cover":
        return Measurement("share of its width that it covers", _covered(body), low, high, "")
    if state.measure == "drop":
        tall = min((w.height for w in windows), default=0.0)
        return Measurement("height by that of the window", body.size[2] / tall, low, high, "") if tall else None
    if state.measure == "lean" and in_posture:
        row = categories().get(body.item.category)
        if row is not None and row.size is not None and row.size.height[0] > LIMITS["tall"] * row.size.width[0]:
            share = body.size[2] / row.size.height[0]
            return Measurement("height by the least usual upright", share, 0.0, LIMITS["upright"], "")
    if given is None and posture is not None:
        return None if state.measure == "glow" else Measurement("bodies in that state", 0.0, 1.0, 1.0, "")
    return Measurement("bodies in that state", in_posture, 1.0, 1.0, "")


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Seats that are told to be pulled out: how far they are from the table that they belong to."""
    for asked in survey.brief.entities:
        for told in asked.attributes:
            far = pulled_as_told(told)
            if far is None:
                continue
            seats = survey.standing_for(asked.id)
            found = [(seat, m) for seat in seats if (m := _away(survey, seat, far)) is not None]
            ids = [seat.id for seat in seats]
            if not found:
                reason = f"no '{asked.noun}' is at a table that it could be {told.words} from"
                yield unmet("attribute", told.id, ids, reason, fault="wrong_state")
                continue
            good = [m for _, m in found if m.ok()]
            if len(good) >= (told.count[0] if told.count else len(found)):
                yield met("attribute", told.id, ids, f"{found[0][0].id}: {text_of(good[0])}", good[0])
                continue
            seat, worst = next((seat, m) for seat, m in found if not m.ok())
            yield unmet("attribute", told.id, ids, f"{seat.id}: {text_of(worst)}", worst, fault="wrong_state")


def _away(survey: Survey, seat: Body, far: float) -> Measurement | None:
    """The gap between a seat and its table; None where it belongs to none."""
    table = table_of(survey, seat)
    if table is None:
        return None
    gap = next(
        (gap for other, gap in survey.near(seat, far + LIMITS["around"]) if other is table), far + LIMITS["around"]
    )
    return Measurement(
        "gap to the table", gap, max(LIMITS["nearest"], far - LIMITS["slack"]), far + LIMITS["slack"], "m"
    )


def _covered(body: Body) -> float:
    """The share of the width of what hangs that its parts of more than half its height cover."""
    spans = sorted(
        (float(np.min(ys)), float(np.max(ys)))
        for part in body.item.solids
        if part.z[1] - part.z[0] > LIMITS["hangs"] * body.size[2]
        for ys in [[y for _, y in part.polygon]]
    )
    covered, end = 0.0, -np.inf
    for low, high in spans:
        covered += max(0.0, high - max(low, end))
        end = max(end, high)
    return float(covered / max(body.size[1], 1e-6))


__all__ = ["measured_state", "outcomes"]
