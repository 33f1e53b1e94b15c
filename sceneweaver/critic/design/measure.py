"""Shapes in plan that measures share: boxes, strips before sides, what reaches into them, leaves of doors, tops."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from sceneweaver.assets.roles import with_role
from sceneweaver.verify.solids import Body, Opening

from ..survey import FLAT, Survey

HEAD = 1.9
"""Height [m] above which things are not in the way."""

MOVED_ASIDE = with_role("light_seat", "upright_seat")
"""Seats that are moved aside by whoever passes."""


def shape_of(survey: Survey, thing: Any) -> Any:
    """A thing in plan as a shapely geometry: the box of a body, the room that a door or window needs, or itself."""
    import shapely

    if isinstance(thing, Body):
        return survey.boxes[thing.index]
    return shapely.Polygon(thing.polygon) if isinstance(thing, Opening) else thing


def spot(thing: Any) -> tuple[float, float]:
    """The middle of a body, of an opening at its wall, or of a geometry."""
    if isinstance(thing, Body):
        return thing.centre
    if isinstance(thing, Opening):
        return middle(thing)
    return thing.centroid.x, thing.centroid.y


def strip(body: Body, side: str, depth: float, width: float = 0.95) -> Any:
    """The rectangle of some depth [m] before a side of a body in plan; ``width`` is a share of the side's."""
    import shapely

    (x, y), (nx, ny), half = body.face(side)
    half *= width
    a, b = (x - ny * half, y + nx * half), (x + ny * half, y - nx * half)
    far = (b[0] + nx * depth, b[1] + ny * depth), (a[0] + nx * depth, a[1] + ny * depth)
    return shapely.polygons((a, b, *far))


def inside(survey: Survey, area: Any, skip: Iterable[Body] = ()) -> list[Body]:
    """Things on the floor that reach into an area between what is walked on and the height of a head."""
    skipped = {b.index for b in skip}
    there = [
        b
        for b in survey.reaching(area)
        if b.index not in skipped and b.item.mount == "floor" and b.z[1] > FLAT and b.z[0] <= HEAD
    ]
    return [b for b, share in zip(there, survey.taken(area, there), strict=True) if share > 1e-3]


def clear_depth(
    survey: Survey, body: Body, side: str, most: float, passes: Callable[[Body], bool]
) -> tuple[float, Body | None]:
    """Free depth [m] up to ``most`` before a side, and what ends it (None: a wall, or nothing does)."""
    import shapely

    area = strip(body, side, most, 0.85)
    face = body.face(side)
    best, who = min(most, survey.clear_ahead(body, side)), None
    for other in inside(survey, area, (body,)):
        if passes(other):
            continue
        points = shapely.get_coordinates(survey.footprint(other).intersection(area))
        near = float(((points - face.centre) @ face.normal).min()) if len(points) else math.inf
        if near < best:
            best, who = max(0.0, near), other
    return best, who


def middle(opening: Opening, depth: float = 0.0) -> tuple[float, float]:
    """The point before the middle of a door or window at a depth [m]."""
    return opening.wall.point(opening.item.offset + opening.item.width / 2, depth)


def parts_of(body: Body) -> list[tuple[float, float]]:
    """For each solid of a body, the share of its box in plan that the solid's takes, and the height [m] of its top."""
    d, w, _ = body.size
    found = []
    for part in body.item.solids:
        xs, ys = [p[0] for p in part.polygon], [p[1] for p in part.polygon]
        found.append(((max(xs) - min(xs)) * (max(ys) - min(ys)) / (d * w), part.z[1]))
    return found


def top_of(body: Body) -> float:
    """Height [m] of the top of a table or unit over its lower end; a tap on it does not count."""
    if body.item.surfaces:
        return max(s.z for s in body.item.surfaces)
    return max((top for share, top in parts_of(body) if share > 0.6), default=body.size[2])


def overlap(a: tuple[float, float], b: tuple[float, float]) -> float:
    """Length [m] that two intervals share; negative: the gap between them."""
    return min(a[1], b[1]) - max(a[0], b[0])


def along(opening_or_wall: Any, body: Body) -> tuple[tuple[float, float], tuple[float, float]]:
    """Interval [m] that a body takes along a wall, and that of its distance from it."""
    wall = getattr(opening_or_wall, "wall", opening_or_wall)
    us, vs = np.array([wall.coordinates(c) for c in body.corners]).T.tolist()
    return (min(us), max(us)), (min(vs), max(vs))


def swing(door: Opening) -> Any:
    """The quarter disc that a leaf sweeps in plan; None where it opens outward or slides."""
    import shapely

    kind = getattr(door.item, "swing", "")
    if not kind.startswith("in-"):
        return None
    width, start = door.item.width, door.item.offset
    left = kind == "in-left"
    turns = np.linspace(0.0, math.pi / 2, 9)
    u = start + width * np.cos(turns) if left else start + width - width * np.cos(turns)
    v = width * np.sin(turns)
    hinge = door.wall.point(start if left else start + width)
    return shapely.Polygon([hinge, *(door.wall.point(float(a), float(b)) for a, b in zip(u, v, strict=True))])
