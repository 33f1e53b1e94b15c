"""Checks of the design rules: one module for each family of rules, each ``faults(survey)``."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ..grade import Finding
from ..survey import Survey
from . import axes, bed, fill, focus, rugs, seating, walls

CHECKS: tuple[Callable[[Survey], Iterator[Finding]], ...] = (
    axes.faults,
    focus.faults,
    seating.faults,
    rugs.faults,
    bed.faults,
    walls.faults,
    fill.faults,
)
"""All of them."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Every breach of a design rule that is for this kind of room."""
    for check in CHECKS:
        yield from check(survey)
