"""The measures that expressions of rows may call, by name, and what a measure of several objects returns."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from sceneweaver.verify.solids import Body, Opening

from .measure import middle

MEASURES: dict[str, Callable[..., Any]] = {}
"""What expressions of rows may call, by name; each takes a survey first."""


class Reading(float):
    """A number and the objects that it is about."""

    by: tuple[Any, ...] = ()

    @classmethod
    def of(cls, value: float, by: Iterable[Any]) -> Reading:
        """A reading of some objects."""
        found = cls(value)
        found.by = tuple(by)
        return found


def measure(function: Callable[..., Any]) -> Callable[..., Any]:
    """Make a function of a survey one that rows may call by its name."""
    MEASURES[function.__name__] = function
    return function


def spot(thing: Body | Opening) -> tuple[float, float]:
    """The middle of a body, or of an opening at its wall."""
    return thing.centre if isinstance(thing, Body) else middle(thing)
