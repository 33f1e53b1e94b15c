"""What a critic says about a scene."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from sceneweaver.scene.base import FrozenModel

CRITERIA = ("realism", "functionality", "layout", "completion", "alignment")


class Fault(FrozenModel):
    """Something that lowers a grade, and what would mend it.

    ``points`` is how much it takes off its criterion; ``tool`` and ``inputs`` are a call that a tool can act on.
    """

    criterion: str
    kind: str = Field(description="Short name of the check, such as missing_needed, wrong_orientation, empty_area")
    objects: tuple[str, ...] = Field(default=(), description="Ids of the objects meant")
    reason: str = Field(description="One sentence with what was measured")
    suggestion: str = Field(default="", description="One sentence that a tool can act on")
    tool: str | None = None
    inputs: dict[str, Any] = {}
    points: float = 1.0


class Review(FrozenModel):
    """Grades 0 to 10 for each criterion, with every fault that was found, the gravest first."""

    critic: Literal["symbolic", "vlm"] = "symbolic"
    grades: dict[str, float]
    faults: tuple[Fault, ...] = ()
    measures: dict[str, float] = Field(default={}, description="What was measured: shares, counts, metres")

    @property
    def total(self) -> float:
        """Mean of the grades."""
        return sum(self.grades.values()) / max(1, len(self.grades))
