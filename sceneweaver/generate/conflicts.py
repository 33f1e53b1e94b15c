"""What a request states that cannot hold to the letter all at once, taken as people mean it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.language import Grounded

from .program import Wanted
from .under import is_closed

BEHIND = 0.08
"""Free depth [m] of what stands between a thing and the wall that it is against."""

WITHIN = 0.5
"""Most gap [m] to a thing in a corner of what is said to be around it."""

AGAINST = 0.1
"""Most gap [m] between a thing that has nothing under it and what was to be there."""

Pair = frozenset[str | tuple[str, str] | None]

SILL, BEFORE_PANE = 0.9, 0.36
"""Height [m] of sills as a rule, and how far [m] from the wall of a window what is higher stands, as the depth before
the pane stays free."""

EDGES = ("against_wall", "in_corner", "at_window")
"""Types of relations that leave no room on all sides of a thing."""


def _pair(row: Grounded) -> Pair:
    return frozenset((row.subject, row.target))


def reconciled(rows: Sequence[Grounded], wanted: Sequence[Wanted]) -> list[Grounded]:
    """Relations that a request states, without those that exclude each other.

    What is next to a thing is not across the room from it as well, which is often said of a wall. What is around a
    thing in a corner or at a wall is near it, as it cannot be on all its sides. A sofa against a wall
    with a screen behind it stands as far off that wall as the screen needs.

    Args:
        rows: the grounded relations.
        wanted: the objects to be.
    """
    at_edge = {row.subject for row in rows if row.hard and row.type in EDGES}
    close = {_pair(row): float(row.params["max"]) for row in rows if row.hard and row.type == "near"}
    depth = {one.id: one.asset.size[0] for one in wanted if one.mount == "floor"}
    between: dict[str, float] = {}
    under = {row.subject for row in rows if row.hard and row.type == "over"}
    for row in rows:
        if row.hard and row.type == "behind" and isinstance(row.target, str) and row.subject in depth:
            between[row.target] = max(between.get(row.target, 0.0), depth[row.subject])
    bodies = {one.id: one for one in wanted if one.mount == "floor"}
    over_sills = {one.id for one in bodies.values() if one.asset.size[2] > SILL}
    found = []
    for row in rows:
        if row.type == "above" and row.subject in bodies:
            row = replace(row, hard=False)  # what stands on the floor is over nothing that does
        if row.type == "over" and is_closed(bodies.get(row.subject), bodies.get(str(row.target))):
            row = replace(row, type="near", params={"max": AGAINST})  # shoes under a bench that reaches to the floor
        if row.type == "distance" and float(row.params.get("min") or 0.0) > close.get(_pair(row), math.inf):
            row = replace(row, hard=False)  # what stands next to a thing is not across the room from it
        if row.type == "around" and row.target in at_edge:
            high = max(WITHIN, float((row.params.get("gap") or (0.0, 0.0))[1]))
            row = replace(row, type="near", params={"max": high})
        if row.type == "against_wall" and row.target is None and row.subject in under:
            row = replace(row, hard=False)  # shoes under a bench at the wall
        if row.type == "against_wall" and row.target == "window" and row.subject in over_sills:
            row = replace(row, params={**row.params, "gap": [0.0, BEFORE_PANE]})
        if row.type == "against_wall" and row.subject in between:
            row = replace(row, params={**row.params, "gap": [0.0, round(between[row.subject] + BEHIND, 3)]})
        found.append(row)
    return found
