"""Where things go when nobody says, from ``usual_places.yaml``: a fireplace at a wall, a floor lamp by a seat."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from functools import cache

from .load import data_of
from .model import Place


@cache
def usual_places() -> tuple[tuple[frozenset[str], tuple[Place, ...]], ...]:
    """Categories and groups with the relations that they usually have; the first row that fits counts.

    A relation to one of several categories has no ``to`` and these in ``instead``; the first that is there is meant.
    """
    rows = data_of("usual_places.yaml")
    return tuple((frozenset(row["what"]), tuple(map(Place.model_validate, row["place"]))) for row in rows)


def usual_places_of(names: AbstractSet[str]) -> tuple[Place, ...]:
    """The usual places of a thing by its category and the groups that this belongs to."""
    return next((places for what, places in usual_places() if names & what), ())
