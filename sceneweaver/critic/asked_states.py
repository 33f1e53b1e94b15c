"""What became of the states that a request tells of things, measured on their bodies in the scene."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.assets import categories
from sceneweaver.assets.states import State
from sceneweaver.scene import Window
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

UPRIGHT = 0.85
"""Height by the least usual one from which on a thing is not on its side, unless it is as wide as it is high."""


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
    if state.measure == "cover":
        return Measurement("share of its width that it covers", _covered(body), low, high, "")
    if state.measure == "drop":
        tall = min((w.height for w in windows), default=0.0)
        return Measurement("height by that of the window", body.size[2] / tall, low, high, "") if tall else None
    if state.measure == "lean" and in_posture:
        row = categories().get(body.item.category)
        if row is not None and row.size is not None and row.size.height[0] > 1.2 * max(row.size.width[0], 0.01):
            share = body.size[2] / row.size.height[0]
            return Measurement("height by the least usual upright", share, 0.0, UPRIGHT, "")
    if given is None and posture is not None:
        return None if state.measure == "glow" else Measurement("bodies in that state", 0.0, 1.0, 1.0, "")
    return Measurement("bodies in that state", in_posture, 1.0, 1.0, "")


def _covered(body: Body) -> float:
    """The share of the width of what hangs that its parts of more than half its height cover."""
    spans = sorted(
        (float(np.min(ys)), float(np.max(ys)))
        for part in body.item.solids
        if part.z[1] - part.z[0] > 0.5 * body.size[2]
        for ys in [[y for _, y in part.polygon]]
    )
    covered, end = 0.0, -np.inf
    for low, high in spans:
        covered += max(0.0, high - max(low, end))
        end = max(end, high)
    return float(covered / max(body.size[1], 1e-6))


__all__ = ["measured_state"]
