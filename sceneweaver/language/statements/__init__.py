"""Statements that are read by pattern before the clauses are: openings, free floor, people, arrangements.

Each reader looks for phrases of its subject in the source, adds what they say to `Parsed`, and blanks them out of the
source (`Source.blank`), so that no word of them is read as a thing. Things that a statement is about are named in the
words of the request; `resolve.resolved` finds their entities when these are known.
"""

from __future__ import annotations

from collections.abc import Callable

from ..parsed import Parsed
from ..source import Source
from .arrangements import arrangements
from .bounds import bounds
from .capacities import capacities
from .finishes import read_finishes
from .free_areas import read_free_areas
from .fullness import fullness
from .looks import read_looks
from .openings import read_openings

STATEMENTS: tuple[Callable[[Source, Parsed], None], ...] = (
    read_openings,
    bounds,
    arrangements,
    read_free_areas,
    capacities,
    read_finishes,
    read_looks,
    fullness,
)
"""The readers, in order; each gets what the ones before it left."""

__all__ = ["STATEMENTS"]
