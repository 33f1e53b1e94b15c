"""What an interior architect asks of a room, as data: the rules of ``design_rules.yaml``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Literal

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
    rooms: frozenset[str] = Field(default=frozenset(), description="Kinds of rooms that it is for; empty: all")
    limits: dict[str, float] = Field(default={}, description="Numbers of the rule: metres, degrees, counts, shares")

    def applies(self, room: str) -> bool:
        """Whether the rule is for a kind of room."""
        return not self.rooms or room in self.rooms


@cache
def design_rules() -> Mapping[str, DesignRule]:
    """All rules by id, in the order of the file; ValueError where it names a room that is unknown, or an id twice."""
    data = read_yaml(resources.files(__package__ or "").joinpath("design_rules.yaml").read_text(encoding="utf-8"))
    rules = [DesignRule(**row) for row in data]
    twice = [name for name, count in Counter(rule.id for rule in rules).items() if count > 1]
    unknown = sorted({room for rule in rules for room in rule.rooms} - set(room_types()))
    if twice or unknown:
        raise ValueError(f"design_rules.yaml: {', '.join([*twice, *unknown])} is there twice or no kind of room")
    return MappingProxyType({rule.id: rule for rule in rules})


def limit(rule: str, name: str) -> float:
    """A number of a rule; KeyError when there is none of that name."""
    return design_rules()[rule].limits[name]
