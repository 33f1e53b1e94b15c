"""The measures that expressions of rows may call, by name, and what measures return beside numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

MEASURES: dict[str, Callable[..., Any]] = {}
"""What expressions of rows may call, by name; each takes a survey first."""


class Reading(float):
    """A number and what it is about: one thing, several, or None."""

    by: Any = None

    @classmethod
    def of(cls, value: float, by: Any) -> Reading:
        """A reading of some thing."""
        found = cls(value)
        found.by = by
        return found


class Span(NamedTuple):
    """An interval [m] across the axis of a body or along a wall, and that of the distance ahead of either."""

    start: float
    end: float
    near: float = 0.0
    far: float = 0.0

    @property
    def length(self) -> float:
        """Its length [m]."""
        return self.end - self.start

    @property
    def middle(self) -> float:
        """Its middle [m]."""
        return (self.start + self.end) / 2


def measure(function: Callable[..., Any]) -> Callable[..., Any]:
    """Make a function of a survey one that rows may call by its name."""
    MEASURES[function.__name__] = function
    return function
