"""What a report is about."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from sceneweaver.assets.placed import Load
from sceneweaver.critic import Phrase, Review
from sceneweaver.scene import Scene

if TYPE_CHECKING:
    from PIL.Image import Image


@dataclass(frozen=True)
class RankedCall:
    """A call that a planner named, and what came of it; ``confidence`` in 0..1."""

    tool: str
    confidence: float
    instruction: str
    outcome: str


@dataclass(frozen=True)
class ThoughtRow:
    """What a planner said before a step; ``by`` is the name of a model, or "rules"."""

    by: str
    problem: str = ""
    last_step: str = ""
    solved: str = ""
    note: str = ""
    ranked: tuple[RankedCall, ...] = ()


@dataclass(frozen=True)
class StepRow:
    """One step on the way to the scene.

    ``grades`` are the critic's grades (0 to 10, by criterion) after the step; what they were before is read from the
    last accepted step above it. ``seconds`` is wall time. ``accepted`` is False when the step was rolled back.
    """

    number: int
    tool: str
    instruction: str
    accepted: bool
    seconds: float
    grades: Mapping[str, float] = field(default_factory=dict)
    note: str = ""
    picture: Image | None = None
    thought: ThoughtRow | None = None


@dataclass(frozen=True)
class ReportData:
    """All that a report shows.

    ``metrics`` has the form of metrics.json; an empty one means that the scene was not checked. ``pictures`` are by
    name, of which ``top``, ``top_annotated`` and ``corner`` have captions of their own. ``load`` brings assets by id,
    None is the library of this user; objects whose asset is missing are shown as their parts, with a warning.
    ``request`` is the text that ``phrases`` tell of.
    """

    scene: Scene
    metrics: Mapping[str, Any] = field(default_factory=dict)
    review: Review | None = None
    pictures: Mapping[str, Image] = field(default_factory=dict)
    steps: tuple[StepRow, ...] = ()
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    load: Load | None = None
    title: str = ""
    request: str = ""
    phrases: tuple[Phrase, ...] = ()
