"""Measures at doors: frames, leaves as they open, and which door is near."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sceneweaver.verify.solids import Body, Opening

from ..survey import FLAT, Survey
from .measure import along, end_of, middle, swing
from .registry import measure


@measure
def has_doors(survey: Survey) -> bool:
    """Whether the room has a door and things that stand in it."""
    return bool(survey.placed.doors and survey.standing)


@measure
def doors(survey: Survey) -> Sequence[Opening]:
    """The doors of the room."""
    return survey.placed.doors


@measure
def nearest_door(survey: Survey, o: Body) -> Opening:
    """The door nearest to a body."""
    return min(survey.placed.doors, key=lambda d: (round(math.dist(o.centre, middle(d)), 3), d.item.id))


AT_FRAME = 0.5
"""Distance [m] from the wall of a door within which things are beside its frame."""


@measure
def frame_gap(_: Survey, door: Opening, o: Body) -> float | None:
    """Gap [m] along the wall between the frame of a door and what stands beside it; None for what does not."""
    (u0, u1), (v0, v1) = along(door, o)
    free = max(u0 - end_of(door), door.item.offset - u1)
    return None if v0 > AT_FRAME or v1 < 0 or free <= -0.05 else free


@measure
def near_leaf(survey: Survey, door: Opening, reach: float) -> list[Body]:
    """What is within a gap [m] of the leaf of a door as it opens, and not beside its frame."""
    leaf, found = swing(door), []
    for row in survey.tree.query(leaf, predicate="dwithin", distance=reach) if leaf is not None else ():
        body = survey.bodies[int(row)]
        if body.item.mount in ("surface", "ceiling") or body.z[1] <= FLAT or body.z[0] > 2.0:
            continue
        (u0, u1), (v0, _v) = along(door, body)
        if v0 >= AT_FRAME or not (u1 < door.item.offset or u0 > end_of(door)):
            found.append(body)
    return found


@measure
def leaf_gap(survey: Survey, door: Opening, o: Body) -> float:
    """Gap [m] between a body and the leaf of a door as it opens."""
    import shapely

    return float(shapely.distance(swing(door), survey.footprint(o)))


@measure
def at_door(survey: Survey, rug: Body, least: float = 0.02) -> bool:
    """Whether a rug lies within the way that a door needs to open."""
    import shapely

    shape = survey.boxes[rug.index]
    return any(shapely.Polygon(door.polygon).intersection(shape).area > least for door in survey.placed.doors)


@measure
def head_at_door_wall(survey: Survey, bed: Body, reach: float, angle: float) -> bool:
    """Whether the head of a bed is within a gap [m] and an angle [deg] of a wall that has a door."""
    back = survey.back_wall(bed)
    if back is None or back[1] > reach or math.degrees(back[2]) > angle:
        return False
    return back[0].index in {door.wall.index for door in survey.placed.doors}
