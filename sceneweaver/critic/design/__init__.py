"""Checks of the design rules: one module for each family of rules, each ``faults(survey)``."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ..grade import Finding
from ..survey import Survey
from . import (
    apart,
    axes,
    bath,
    bed,
    clearance,
    complete,
    doors,
    fill,
    focus,
    gym,
    kitchen,
    light,
    rugs,
    seating,
    small,
    style,
    tables,
    visitors,
    walls,
    ways,
    weights,
    workplaces,
)

CHECKS: tuple[Callable[[Survey], Iterator[Finding]], ...] = (
    axes.faults,
    rugs.faults,
    focus.faults,
    seating.faults,
    walls.faults,
    fill.faults,
    bed.faults,
    doors.faults,
    ways.faults,
    clearance.faults,
    apart.faults,
    light.faults,
    visitors.faults,
    workplaces.faults,
    tables.faults,
    gym.faults,
    weights.faults,
    kitchen.faults,
    bath.faults,
    small.faults,
    style.faults,
    complete.faults,
)
"""All of them."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Every breach of a design rule that is for this kind of room."""
    for check in CHECKS:
        yield from check(survey)
