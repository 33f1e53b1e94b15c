"""Tables long enough for the seats that a request puts at them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.assets import Library
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import InputError

from .program import Program, Wanted
from .relations import thing_of
from .seats import ELBOW, SQUARE

TUCKED = 0.2
"""How much [m] narrower than the table the ring is on which the fronts of pulled-up seats stand."""

EDGES = 8
"""Edges of the collision part of a round table. Seats are pulled up to these, to every other one if that is enough."""


def lengthened(program: Program, rows: Sequence[Grounded], library: Library, brief: SceneGraph) -> bool:
    """Exchange tables that are too short for the seats at them for longer ones; whether any was.

    Those whose size the request gives stay as they are.
    """
    sized = {entity.id for entity in brief.entities if any(entity.size)}
    changed = False
    for table in program.wanted:
        if table.wish is None or table.asked in sized or not thing_of(table).is_table:
            continue
        depth, width, _ = table.asset.size
        length = _needed(table, program, rows)
        if length <= max(depth, width):
            continue
        size = _longer(table, length)
        if size is None:
            continue
        try:
            wish = replace(table.wish, size=(*size, table.wish.size[2]), beyond=True)
            table.asset = library.choose(table.category, 1, wish)[0]
        except InputError:
            continue
        changed = True
    return changed


def _needed(table: Wanted, program: Program, rows: Sequence[Grounded]) -> float:
    """Length of a table, or diameter of a round one [m], that its seats need; 0 where there are none."""
    seats = {one.id: one for one in program.wanted if thing_of(one).is_seat}
    own = [row for row in rows if row.target == table.id and row.subject in seats]
    wide = max((seats[row.subject].asset.size[1] for row in own), default=0.0)
    ring = len({row.subject for row in own if row.type == "around"})
    along = max((row.params["n"] for row in own if row.type == "seated_at"), default=0)
    if ring > 2 and _is_round(table):
        edges = EDGES if ring > EDGES // 2 else EDGES // 2
        return math.ceil(ring / edges) * wide / math.tan(math.pi / edges) + TUCKED
    if ring > 2:
        along = max(along, math.ceil((ring - 2) / 2))
    return along * (wide + ELBOW)


def _is_round(table: Wanted) -> bool:
    depth, width, _ = table.asset.size
    return "round" in table.category and max(depth, width) < SQUARE * min(depth, width)


def _longer(table: Wanted, length: float) -> tuple[float, float] | None:
    """Depth and width [m] of a table of some length, as far as such tables go; None where it is that long already."""
    known = category_named(table.category).size
    if known is None:
        return None
    depth, width, _ = table.asset.size
    at = 1 if width >= depth else 0
    most = known.reach[at][1]
    if _is_round(table):
        most = min(most, known.reach[0][1], known.reach[1][1])
    length = round(min(length, most), 3)
    if length <= max(depth, width) + 1e-3:
        return None
    return (length, length) if _is_round(table) else (depth, length) if at else (length, width)
