"""What a design led to."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sceneweaver.brief import SceneGraph
from sceneweaver.critic import Review
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from .memory import Step


@dataclass(frozen=True)
class Result:
    """What a design led to.

    ``unmet`` lists what was asked for and is not so, ``notes`` what was assumed, ``undone`` the files that there was no
    time for, what a signal cut off, and parts of the program that broke down.
    """

    scene: Scene
    report: Report
    review: Review
    brief: SceneGraph
    steps: tuple[Step, ...]
    notes: tuple[str, ...]
    unmet: tuple[str, ...]
    seconds: float
    finished: str
    undone: tuple[str, ...] = ()
    out: Path | None = None

    @property
    def satisfied(self) -> bool:
        """Whether the scene is valid and all that was asked for is so, files included."""
        return self.report.valid and not self.unmet and not self.undone
