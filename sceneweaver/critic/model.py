"""What a critic says about a scene."""

from __future__ import annotations

from collections import Counter
from typing import Any, Literal

from pydantic import Field

from sceneweaver.scene.base import FrozenModel

CRITERIA = ("realism", "functionality", "layout", "completion", "alignment")

ItemKind = Literal["entity", "attribute", "relation", "exclusion", "room", "unread"]

Status = Literal["met", "assumed", "not_understood", "unmet"]
"""What became of an item: measured and so; so, by an assumption that the request does not state; not measured, as the
words or what they mean for a scene are not known; measured and not so."""

STATUSES: tuple[Status, ...] = ("met", "assumed", "not_understood", "unmet")
"""All of them, the best first."""


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
        return {"total": len(self.items), **{s: found[s] for s in ("met", "unmet", "assumed", "not_understood")}}


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


class Review(FrozenModel):
    """Grades 0 to 10 for each criterion, with every fault that was found, the gravest first."""

    critic: Literal["symbolic", "vlm"] = "symbolic"
    grades: dict[str, float]
    faults: tuple[Fault, ...] = ()
    measures: dict[str, float] = Field(default={}, description="What was measured: shares, counts, metres")
    alignment: Alignment = Field(default=Alignment(), description="What became of each item of the request")

    @property
    def unmet(self) -> float:
        """Points of what is not as asked; the grade for alignment tells less and less of them the more there are."""
        return sum(fault.points for fault in self.faults if fault.criterion == "alignment")

    @property
    def total(self) -> float:
        """Mean of the grades."""
        return sum(self.grades.values()) / max(1, len(self.grades))
