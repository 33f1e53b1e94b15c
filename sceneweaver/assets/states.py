"""States of things that can be shown: what a word such as "knocked over" means for the body of a category."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from typing import Any

from .category import read_yaml
from .roles import groups_above, has_role

_FIXED = ("built_in", "rug", "any_bed")
"""Roles of what nobody knocks over."""


@dataclass(frozen=True)
class State:
    """A row of ``states.yaml``."""

    words: tuple[str, ...]
    of: tuple[str | Mapping[str, str], ...] = ()
    of_all: bool = False
    after: tuple[str, ...] = ()
    part: str = ""
    posture: str | None = None
    several: str | None = None
    measure: str = ""
    range: tuple[float, float] = (0.0, 1.0)
    becomes: Mapping[str, str] = field(default_factory=dict)
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)

    def holds_for(self, category: str) -> bool:
        """Whether things of a category can be in it."""
        if self.of_all:
            return not has_role(category, *_FIXED)
        if category in self.becomes or category in self.becomes.values():
            return True
        names = groups_above(category) | {category}
        return any(has_role(category, name["role"]) if isinstance(name, Mapping) else name in names for name in self.of)


@cache
def states() -> tuple[State, ...]:
    """All rows, in order."""
    rows: list[dict[str, Any]] = read_yaml(resources.files(__package__ or "").joinpath("states.yaml"))
    return tuple(State(**_frozen(row)) for row in rows)


def _frozen(row: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(value) if isinstance(value, list) else value for key, value in row.items()}


def state_of(category: str, word: str, part: str = "") -> State | None:
    """What a word says of a thing of a category, or of its ``part`` (door, drawer); None: nothing that can be shown.

    Examples:
        >>> from sceneweaver.assets.states import state_of
        >>> state_of("chair", "knocked over").posture
        'on_side'
    """
    known = (row for row in states() if row.part == part and word in (*row.words, *row.after))
    return next((row for row in known if row.holds_for(category)), None)


__all__ = ["State", "state_of", "states"]
