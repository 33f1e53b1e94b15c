"""What a critic says about a scene."""

from __future__ import annotations

from collections import Counter
from typing import Any, Literal

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer

from sceneweaver.scene.base import FrozenModel

FULL = 10.0
"""The best grade that there is."""

CRITERIA = ("realism", "functionality", "layout", "completion", "alignment")

ItemKind = Literal[
    "entity", "attribute", "relation", "exclusion", "capacity", "arrangement", "free_area", "room", "unread"
]

Status = Literal["met", "partly", "substituted", "assumed", "not_understood", "unmet"]
"""What became of an item: measured and so; so, but words beside it were not understood; another thing stands for it;
so, by an assumption that the request does not state; not measured, as the words or what they mean for a scene are not
known; measured and not so."""

STATUSES: tuple[Status, ...] = ("met", "partly", "substituted", "assumed", "not_understood", "unmet")
"""All of them, the best first."""


USE = "room.use"
"""Item that no request states and every one means: that what stands there can be reached."""


class ItemOutcome(FrozenModel):
    """What became of one item of a request."""

    item: str = Field(description="Id of the item in the scene graph; of a room fact 'room.' and the field's name")
    kind: ItemKind
    status: Status
    objects: tuple[str, ...] = Field(default=(), description="Ids of the objects that it is about")
    quantity: str = Field(default="", description="What was measured; empty where there is no number")
    measured: float | None = None
    allowed: tuple[float | None, float | None] | None = Field(
        default=None, description="Interval in which it should lie; null: open"
    )
    unit: str = Field(default="", description="m, m2, deg; empty for counts and shares")
    reason: str = Field(description="One sentence")
    told: bool = Field(default=False, description="Whether the sentence has the numbers")


class Alignment(FrozenModel):
    """What became of every item of a request, in the order of the scene graph."""

    items: tuple[ItemOutcome, ...] = ()

    def of(self, item: str) -> ItemOutcome:
        """The outcome of an item; KeyError when there is none."""
        for outcome in self.items:
            if outcome.item == item:
                return outcome
        raise KeyError(item)

    @property
    def summary(self) -> dict[str, int]:
        """How many items there are, in all and by status."""
        found = Counter(outcome.status for outcome in self.items)
        return {"total": len(self.items), **{status: found[status] for status in STATUSES}}

    @property
    def share(self) -> float:
        """Share of the stated items that are so, 0 to 1: what is so in part, or by another thing, counts half."""
        stated = [outcome for outcome in self.items if outcome.item != USE]
        if not stated:
            return 1.0
        found = Counter(outcome.status for outcome in stated)
        half = found["partly"] + found["substituted"] + found["assumed"]
        return (found["met"] + 0.5 * half) / len(stated)


class Fault(FrozenModel):
    """Something that lowers a grade, and what would mend it.

    ``points`` is how much it takes off its criterion; ``tool`` and ``inputs`` are a call that a tool can act on.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.Fault(criterion="layout", kind="crowded", objects=("bed",), reason="the bed is hemmed in").points
        1.0
    """

    criterion: str
    kind: str = Field(description="Short name of the check, such as missing_needed, wrong_orientation, empty_area")
    objects: tuple[str, ...] = Field(default=(), description="Ids of the objects meant")
    reason: str = Field(description="One sentence with what was measured")
    suggestion: str = Field(default="", description="One sentence that a tool can act on")
    tool: str | None = None
    inputs: dict[str, Any] = {}
    points: float = 1.0
    lid: float | None = Field(default=None, description="Highest share [tenths] of its grade that stays; null: all")
    rule: str | None = Field(default=None, description="Id of the design rule that it breaks, if it is one")
    measured: float | None = None
    allowed: tuple[float | None, float | None] | None = Field(
        default=None, description="Interval in which the measured value should lie; null: open"
    )


class VisualFault(Fault):
    """A fault that a model saw; ``points`` is its severity times the share of the answers that saw it."""

    severity: float = Field(description="1: a blemish, 2: a flaw, 3: the room fails at it; mean of those that saw it")
    share: float = Field(description="Share of the answers that saw it, above 0 to 1")


class VisualReview(FrozenModel):
    """What a vision model says about a scene, from one or several answers. Beside `Review`, it decides no validity.

    Examples:
        >>> from sceneweaver.critic import VisualReview
        >>> grades, off = {"realism": 6.0, "layout": 5.0}, {"realism": 1.0, "layout": 0.0}
        >>> seen = VisualReview(model="m", samples=2, grades=grades, deviation=off)
        >>> seen.mean, seen.spread
        (5.5, 0.5)
    """

    model: str = Field(description="Name of the model")
    samples: int = Field(description="Answers that are averaged")
    failed: tuple[str, ...] = Field(default=(), description="Why the other answers are left out, one line each")
    pictures: tuple[str, ...] = Field(default=(), description="Titles of the pictures that it was shown")
    grades: dict[str, float] = Field(description="Mean grade 0 to 10 by criterion")
    deviation: dict[str, float] = Field(default={}, description="Standard deviation of the answers' grades")
    ranges: dict[str, tuple[float, float]] = Field(default={}, description="Lowest and highest grade")
    comments: dict[str, tuple[str, ...]] = Field(default={}, description="What each answer says, by criterion")
    faults: tuple[VisualFault, ...] = Field(default=(), description="Merged over the answers, the gravest first")

    @property
    def mean(self) -> float:
        """Mean of the grades; of two scenes the one that the model likes better has more."""
        return sum(self.grades.values()) / max(1, len(self.grades))

    @property
    def spread(self) -> float:
        """Mean over the criteria of the standard deviation of the answers; 0 for one answer."""
        return sum(self.deviation.values()) / max(1, len(self.deviation))

    @property
    def summary(self) -> dict[str, Any]:
        """For ``scores.seen`` of ``metrics.json``: model, number of answers, grades with mean and spread."""
        return {
            "critic": "vlm",
            "model": self.model,
            "samples": self.samples,
            "grades": {name: round(grade, 2) for name, grade in self.grades.items()},
            "deviation": {name: round(value, 2) for name, value in self.deviation.items()},
            "mean": round(self.mean, 2),
            "spread": round(self.spread, 2),
        }


class Review(FrozenModel):
    """Grades 0 to 10 for each criterion, with every fault that was found, the gravest first.

    ``seen`` is what a vision model says, where one was asked: it changes neither grades nor ``total``.
    """

    critic: Literal["symbolic", "vlm"] = "symbolic"
    grades: dict[str, float]
    faultless: dict[str, float] = Field(
        default={},
        description="What the grades were without any fault: less for a kind of room of which less is known",
    )
    faults: tuple[Fault, ...] = ()
    measures: dict[str, float] = Field(default={}, description="What was measured: shares, counts, metres")
    alignment: Alignment = Field(default=Alignment(), description="What became of each item of the request")
    seen: VisualReview | None = Field(
        default=None, description="What a vision model says; left out where none was asked"
    )

    @model_serializer(mode="wrap")
    def _without_none(self, write: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """A review without a vision model is written as it always was."""
        data = write(self)
        if data.get("seen", self) is None:
            del data["seen"]
        return data

    @property
    def unmet(self) -> float:
        """Points of what is not as asked; the grade for alignment tells less and less of them the more there are."""
        return sum(fault.points for fault in self.faults if fault.criterion == "alignment")

    @property
    def total(self) -> float:
        """Mean of the grades."""
        return sum(self.grades.values()) / max(1, len(self.grades))

    @property
    def to_gain(self) -> float:
        """By how much the mean of the grades would rise if every fault were mended."""
        best = sum(self.best(name) for name in self.grades)
        return best / max(1, len(self.grades)) - self.total

    def best(self, criterion: str) -> float:
        """What a grade were without any fault; the full one where that is not known."""
        return self.faultless.get(criterion, FULL)
