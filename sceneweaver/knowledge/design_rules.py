"""What an interior architect asks of a room, as data: the rules of ``design_rules.yaml``.

What a breach costs is drafted there and fitted to the grades of strict eyes; the fitted points stand in
``design_points.yaml``, which ``python -m benchmarks.critic_fit`` writes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Any, Literal

from pydantic import Field, NonNegativeFloat

from sceneweaver.scene.base import FrozenModel

from .load import read_yaml, room_types


class DesignRule(FrozenModel):
    """One rule: what it says, the grade that a breach lowers, and its numbers."""

    id: str
    statement: str = Field(description="One plain sentence")
    criterion: Literal["realism", "functionality", "layout", "completion"]
    points: NonNegativeFloat = Field(description="What one breach takes off the grade")
    most: NonNegativeFloat = Field(description="What all breaches of it take off together")
    drafted: NonNegativeFloat = Field(default=0.0, description="The points that it was given before the fit")
    rooms: frozenset[str] = Field(default=frozenset(), description="Kinds of rooms that it is for; empty: all")
    limits: dict[str, float] = Field(default={}, description="Numbers of the rule: metres, degrees, counts, shares")

    def applies(self, room: str) -> bool:
        """Whether the rule is for a kind of room."""
        return not self.rooms or room in self.rooms


class DesignPoints(FrozenModel):
    """What the fit found: the points of each rule, and how grades follow from them."""

    baseline: dict[str, NonNegativeFloat] = Field(description="By criterion, points lost to what only eyes can tell")
    weights: dict[str, NonNegativeFloat] = Field(
        description="By criterion, how much it feels breaches of its own rules"
    )
    others: dict[str, NonNegativeFloat] = Field(description="By criterion, how much it feels those of the other rules")
    scale: NonNegativeFloat = Field(description="By what drafted points are multiplied where a rule was not fitted")
    points: dict[str, NonNegativeFloat] = Field(description="What one breach of each rule takes off")


@cache
def design_points() -> DesignPoints:
    """The fitted numbers."""
    return DesignPoints(**_data("design_points.yaml"))


@cache
def drafted_rules() -> Mapping[str, DesignRule]:
    """All rules by id, in the order of the file, with the points that they were given before the fit.

    Raises:
        ValueError: a rule names a kind of room that is unknown, or an id is there twice.
    """
    rules = [DesignRule(**row, drafted=row["points"]) for row in _data("design_rules.yaml")]
    twice = [name for name, count in Counter(rule.id for rule in rules).items() if count > 1]
    unknown = sorted({room for rule in rules for room in rule.rooms} - set(room_types()))
    if twice or unknown:
        raise ValueError(f"design_rules.yaml: {', '.join([*twice, *unknown])} is there twice or no kind of room")
    return MappingProxyType({rule.id: rule for rule in rules})


@cache
def design_rules() -> Mapping[str, DesignRule]:
    """All rules by id, in the order of the file, with their fitted points; ValueError as `drafted_rules`."""
    fitted, found = design_points(), {}
    for rule in drafted_rules().values():
        points = fitted.points.get(rule.id, fitted.scale * rule.drafted)
        most = rule.most / rule.drafted * points if rule.drafted else 0.0
        found[rule.id] = rule.model_copy(update={"points": round(points, 3), "most": round(most, 3)})
    return MappingProxyType(found)


def _data(name: str) -> Any:
    return read_yaml(resources.files(__package__ or "").joinpath(name).read_text(encoding="utf-8"))


def limit(rule: str, name: str) -> float:
    """A number of a rule; KeyError when there is none of that name."""
    return design_rules()[rule].limits[name]
