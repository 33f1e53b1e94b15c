"""Measures of the room before things: what reaches into it, and what hangs across openings."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.verify.solids import Body, Opening

from ..design.measure import HEAD, along, overlap, strip
from ..design.query import listed
from ..design.registry import measure
from ..survey import FLAT, Survey


def _area(thing: Body | Opening, depth: float, side: str) -> Any:
    """The rectangle of a depth [m] before a side of a body, or before an opening, in plan."""
    import shapely

    if isinstance(thing, Body):
        return strip(thing, side, depth)
    return shapely.polygons(thing.wall.strip(thing.item.offset, thing.item.width, 0.0, depth))


@measure
def before(
    survey: Survey, thing: Body | Opening, depth: float, least: float, side: str = "front", head: float = HEAD
) -> list[Body]:
    """What takes more than a share of the room before a side of a thing, on the floor or low on a wall.

    Args:
        survey: the scene.
        thing: a body or an opening.
        depth: how deep [m] the room is.
        least: the share.
        side: of a body.
        head: height [m] above which things are not in the way.
    """
    area = _area(thing, depth, side)
    there = [
        b
        for b in survey.reaching(area)
        if b is not thing and b.item.mount not in ("surface", "ceiling") and b.z[1] > FLAT and b.z[0] <= head
    ]
    return [b for b, share in zip(there, survey.taken(area, there), strict=True) if share > least]


@measure
def taken(survey: Survey, thing: Body | Opening, others: Any, depth: float, side: str = "front") -> float:
    """Share of the room before a side of a thing, of a depth [m], that others take."""
    return sum(survey.taken(_area(thing, depth, side), listed(others)))


@measure
def most_taking(survey: Survey, thing: Body | Opening, others: Sequence[Body], depth: float, side="front") -> Body:
    """Which of some bodies takes most of the room before a side of a thing."""
    shares = zip(survey.taken(_area(thing, depth, side), others), others, strict=True)
    return max(shares, key=lambda row: (row[0], row[1].id))[1]


@measure
def beyond_floor(survey: Survey, o: Body, depth: float, side: str) -> float:
    """Share of the room before a side of a body, of a depth [m], that is not in the room."""
    area = _area(o, depth, side)
    return 1.0 - float(area.intersection(survey.placed.floor).area) / max(1e-9, float(area.area))


@measure
def clearance(_: Survey, o: Body, side: str, usual: float) -> float:
    """Room [m] that the category of a body asks for before a side; the usual one where it says none."""
    row = categories().get(o.item.category)
    return row.clearance.get(side, usual) if row is not None else usual


@measure
def openings(survey: Survey) -> Sequence[Opening]:
    """The doors and windows of the room."""
    return list(survey.placed.openings)


@measure
def from_wall(_: Survey, opening: Opening, o: Body) -> float:
    """Least distance [m] of a body from the wall of an opening; negative beyond it."""
    return along(opening, o)[1][0]


@measure
def height_shared(_: Survey, a: Body | Opening, b: Body | Opening) -> float:
    """Height [m] that two things share; negative: the gap between them."""
    return overlap(a.z, b.z)
