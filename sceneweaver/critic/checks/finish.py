"""Measures of whether tables and shelves are in use."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from sceneweaver.assets.roles import groups_above
from sceneweaver.verify.solids import Body

from ..design.looks import supports, within_reach
from ..design.registry import measure
from ..survey import Survey


@measure
def filled_share(survey: Survey, o: Body) -> float:
    """Share of the surfaces of a body within reach on which something stands; a table is full with anything on it."""
    names = {s.name for s in o.item.surfaces if within_reach(o, s.z)}
    used = {b.item.support.surface for b in survey.carried.get(o.id, ()) if b.item.support is not None}
    if not names or (used and "table_group" in groups_above(o.item.category)):
        return 1.0
    return len(names & used) / len(names)


@measure
def populated_share(survey: Survey) -> float:
    """Mean over the supports of how far they are filled; half of a shelf's boards are enough."""
    bases = supports(survey)
    return sum(min(1.0, 2.0 * filled_share(survey, b)) for b in bases) / len(bases) if bases else 1.0


class Filling(NamedTuple):
    """Supports that one call fills: the tool, and the arrangement or theme that the room's item for them names."""

    bodies: tuple[Body, ...]
    tool: str
    arrangement: str | None
    theme: str | None


@measure
def fillings(survey: Survey, bodies: Sequence[Body]) -> list[Filling]:
    """The calls that fill some supports."""
    groups: dict[tuple[str, str | None, str | None], list[Body]] = {}
    for body in bodies:
        groups.setdefault(_filling(survey, body), []).append(body)
    return [Filling(tuple(row), *how) for how, row in groups.items()]


def _filling(survey: Survey, body: Body) -> tuple[str, str | None, str | None]:
    name = survey.program.item_of.get(body.id)
    item = survey.room_type.item(name) if name else None
    if item is not None and item.top is not None:
        return "add_tabletop", item.top, None
    if item is not None and item.fill is not None:
        return "add_crowd", None, item.fill
    return ("add_crowd" if len(body.item.surfaces) > 1 else "add_tabletop"), None, None
