"""Statements that are read by pattern before the clauses are: sides, openings, free floor, arrangements, lengths ...

Each reader looks for phrases of its subject in the source, adds what they say to `Parsed`, and blanks them out of the
source (`Source.blank`), so that no word of them is read as a thing. Things that a statement is about are named in the
words of the request; `resolve.resolved` finds their entities when these are known.
"""

from __future__ import annotations

from collections.abc import Callable

from ..parsed import Parsed
from ..source import Source
from .appearances import read_appearances
from .arrangements import arrangements
from .bounds import bounds
from .built_parts import built_parts
from .capacities import capacities
from .contrasts import contrasts
from .entering import entering
from .finishes import read_finishes
from .free_areas import read_free_areas
from .fullness import emptied, fullness
from .groups import aisles, facing_rows, groups, horseshoes, merged
from .labels import labels
from .limits import limits
from .looks import read_looks
from .measures import measures
from .openings import read_openings
from .persons import persons
from .roles import roles
from .room_kind import furnish_zones, read_room_kind
from .room_sides import room_sides
from .said_again import said_again
from .seen_from import seen_from
from .spacings import spacings
from .states import read_states
from .surfaces import read_surfaces
from .unwanted import unwanted
from .unwanted_looks import read_unwanted_looks
from .views import views
from .wings import wings


def _told_of_rows(source: Source, parsed: Parsed) -> None:
    """What is said of rows beside their number: aisles, backs together, how far apart their things are."""
    facing_rows(source, parsed)
    aisles(source, parsed)
    horseshoes(source, parsed)
    spacings(source, parsed)
    merged(parsed)


STATEMENTS: tuple[Callable[[Source, Parsed], None], ...] = (
    persons,
    entering,
    contrasts,
    labels,
    said_again,
    roles,
    wings,
    room_sides,
    read_openings,
    seen_from,
    built_parts,
    read_unwanted_looks,
    read_surfaces,
    read_finishes,
    bounds,
    groups,
    limits,
    arrangements,
    _told_of_rows,
    read_free_areas,
    measures,
    emptied,
    read_states,
    read_appearances,
    views,
    capacities,
    read_looks,
    fullness,
    unwanted,
    read_room_kind,
)
"""The readers, in order; each gets what the ones before it left."""

__all__ = ["STATEMENTS", "furnish_zones"]
