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

    Attributes:
        scene: the room.
        report: the judge on it.
        review: grades of the critic and what it finds fault with.
        brief: the request as it was read.
        steps: what the agent tried, in order.
        notes: what was assumed.
        unmet: what was asked for and is not so.
        seconds: wall time.
        finished: why the agent ended.
        undone: files that there was no time for, what a signal cut off, and parts of the program that broke down.
        out: the folder that was written; None: none.

    Examples:
        >>> import sceneweaver as sw
        >>> result = sw.design("a store room with one shelf", seed=1, steps=1, candidates=8, device="cpu")
        >>> result.satisfied, sorted(result.review.grades)[:2]
        (True, ['alignment', 'completion'])
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
