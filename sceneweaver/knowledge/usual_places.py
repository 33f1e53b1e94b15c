"""Where things go when nobody says, from ``usual_places.yaml``: a fireplace at a wall, a floor lamp by a seat."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cache
from importlib import resources

from .load import read_yaml
from .model import Place


@dataclass(frozen=True)
class UsualPlace:
    """One relation that things of some categories usually have.

    Attributes:
        place: the relation; its target is named only where that is a part of the room.
        among: categories of other things; the first that is there is the target.
    """

    place: Place
    among: tuple[str, ...] = ()

    @classmethod
    def read(cls, entry: object) -> UsualPlace:
        """One entry of the file: as `Place`, but ``to`` may be a list."""
        if isinstance(entry, dict) and isinstance(entry.get("to"), list):
            return cls(Place(**{k: v for k, v in entry.items() if k != "to"}), tuple(entry["to"]))
        return cls(Place.model_validate(entry))


@cache
def usual_places() -> tuple[tuple[frozenset[str], tuple[UsualPlace, ...]], ...]:
    """Categories and groups with the relations that they usually have; the first row that fits counts."""
    file = resources.files(__package__ or "").joinpath("usual_places.yaml")
    rows = read_yaml(file.read_text(encoding="utf-8"))
    return tuple((frozenset(row["what"]), tuple(map(UsualPlace.read, row["place"]))) for row in rows)


def usual_places_of(names: AbstractSet[str]) -> tuple[UsualPlace, ...]:
    """The usual places of a thing by its category and the groups that this belongs to."""
    return next((places for what, places in usual_places() if names & what), ())
