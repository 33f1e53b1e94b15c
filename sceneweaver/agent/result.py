"""What a design led to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sceneweaver.critic import Review
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from .changed import Start
from .memory import Step
from .roles import Roles


@dataclass(frozen=True)
class ModelUse:
    """What a model did in a design.

    Attributes:
        name: of the model.
        roles: who was to plan, to read the request and to grade.
        planned: who planned each step, in order: the name of a model, or "rules".
        read: who read the request: the name of a model, or "rules".
        lost: why the model was not asked any more; empty when it was there to the end.
        disagreements: where the model read the request in another way than the rules.
        usage: calls, tokens, cost and seconds, in all and by purpose.
    """

    name: str
    roles: Roles
    planned: tuple[str, ...] = ()
    read: str = "rules"
    lost: str = ""
    disagreements: tuple[str, ...] = ()
    usage: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """As JSON data: the key ``models`` of ``metrics.json``."""
        return {
            "name": self.name,
            "roles": self.roles.model_dump(mode="json"),
            "planned": list(self.planned),
            "read": self.read,
            "lost": self.lost or None,
            "disagreements": list(self.disagreements),
            "usage": dict(self.usage),
        }


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
        broken: those of them that broke down.
        files: what was written for this result, in the order in which to look at it, by paths inside ``out``.
        left_out: files that there was no time for, by the paths that they would have.
        out: the folder that was written; None: none.
        models: what a model did; None: none had anything to do.
        start: the scene of somebody else that it began with, and what was changed of it; None: it began with none.

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
    broken: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    out: Path | None = None
    models: ModelUse | None = None
    start: Start | None = None

    @property
    def satisfied(self) -> bool:
        """Whether the scene is valid and all that was asked for is so, files included."""
        return self.report.valid and not self.unmet and not self.undone
