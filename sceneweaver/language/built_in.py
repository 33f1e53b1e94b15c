"""What the name of a built-in thing says of where it is: a window seat is at a window, or in its bay."""

from __future__ import annotations

from collections.abc import Sequence

from .model import Entity, StatedOpening, StatedRelation
from .told_openings import is_bay

AT_WINDOWS = ("window_seat",)
"""Categories that are at windows by their names."""


def by_their_names(
    entities: Sequence[Entity], relations: Sequence[StatedRelation], openings: Sequence[StatedOpening]
) -> list[StatedRelation]:
    """The relations that the names of things state, where the request says nothing else of their place."""
    found: list[StatedRelation] = []
    bay = any(map(is_bay, openings))
    for entity in entities:
        placed = any(r.subject == entity.id and {"window", "wall:bay"} & set(r.targets) for r in relations)
        if entity.category in AT_WINDOWS and not placed:
            kind, place = ("against", "wall:bay") if bay else ("at", "window")
            said = StatedRelation(
                type=kind,  # type: ignore[arg-type]
                subject=entity.id,
                targets=(place,),
                words=entity.noun,
                span=entity.span,
            )
            found.append(said)
    return found


__all__ = ["by_their_names"]
