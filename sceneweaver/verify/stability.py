"""Whether a scene stays as it is when physics is let loose on it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sceneweaver.scene import Scene

from .measure import at_most, length
from .report import Violation

FALLEN = 0.1
"""Movement [m] in `SECONDS` from which on something did not stay where it was put, but fell or slid."""

SECONDS = 3.0
"""Time [s] that is simulated, as in the SceneWeaver paper's table."""


def measure(scene: Scene, load: Callable[[str], Any] | None = None) -> tuple[dict[str, float], list[Violation]]:
    """The numbers of ``metrics.json``, and a violation for each object that did not stay."""
    from sceneweaver.physics import stability

    found = stability(scene, load, SECONDS)
    return numbers(found), violations(found["moved"])


def numbers(found: Mapping[str, Any]) -> dict[str, float]:
    """What ``metrics.json`` keeps of `sceneweaver.physics.stability`."""
    return {key: round(float(found[key]), 6) for key in ("moved_over_0_1m", "moved_over_0_01m", "mean_shift_m")}


def violations(moved: Mapping[str, float]) -> list[Violation]:
    """One for each object that moved farther than `FALLEN`, given the movement [m] of each."""
    return [
        Violation.of(
            "unstable",
            (object_id,),
            f"{object_id} moves {length(far)} in {SECONDS:g} s of physics",
            at_most("movement in physics", far, 0.0, slack=FALLEN),
        )
        for object_id, far in moved.items()
        if far > FALLEN
    ]
