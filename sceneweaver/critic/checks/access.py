"""Measures of the room before things: what reaches into it, and what it shares with doors and windows."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.category import Side
from sceneweaver.verify.solids import Body, Opening

from ..design.measure import HEAD, along, overlap
from ..design.registry import measure
from ..survey import FLAT, Survey


@measure
def before(_: Survey, opening: Opening, depth: float) -> Any:
    """The rectangle of a depth [m] before a door or window in plan."""
    import shapely

    return shapely.polygons(opening.wall.strip(opening.item.offset, opening.item.width, 0.0, depth))


@measure
def reaching(survey: Survey, area: Any, least: float, head: float = HEAD) -> list[Body]:
    """What takes more than a share of an area, on the floor or on a wall lower than the height of a head [m]."""
    there = [
        b
        for b in survey.reaching(area)
        if b.item.mount not in ("surface", "ceiling") and b.z[1] > FLAT and b.z[0] <= head
    ]
    return [b for b, share in zip(there, survey.taken(area, there), strict=True) if share > least]


@measure
def clearance(_: Survey, o: Body, side: Side, usual: float) -> float:
    """Room [m] that the category of a body asks for before a side; the usual one where it says none."""
    row = categories().get(o.item.category)
    return row.clearance.get(side, usual) if row is not None else usual


@measure
def width_shared(_: Survey, opening: Opening, o: Body) -> float:
    """Length [m] along its wall that a body shares with a door or window; negative: the gap between them."""
    return overlap(along(opening, o)[0], (opening.item.offset, opening.item.offset + opening.item.width))


@measure
def height_shared(_: Survey, opening: Opening, o: Body) -> float:
    """Height [m] that a body shares with a door or window; negative: the gap between them."""
    return overlap(o.z, opening.z)
