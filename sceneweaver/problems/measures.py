"""How tight a layout is, and how much is asked of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import shapely

from sceneweaver.geometry.shell import clear_zone, heights
from sceneweaver.scene import Scene, SceneObject


def tightness_of(scene: Scene) -> float:
    """Share of the floor that footprints and hard zones of floor objects take, where they stand.

    The floor is the room without what its doors need free. What lies in one another counts once.
    """
    floor = free_floor(scene)
    taken = [shape for item in scene.objects if item.mount == "floor" for shape in _floor_of(item)]
    return float(shapely.unary_union(taken).intersection(floor).area / floor.area) if taken else 0.0


def free_floor(scene: Scene) -> Any:
    """The room's outline without what its doors need free, as a shapely polygon."""
    doors = [shapely.Polygon(clear_zone(door, scene.room.walls)) for door in scene.room.doors]
    return shapely.Polygon(scene.room.outline).difference(shapely.unary_union(doors))


def footprint(item: SceneObject) -> Any:
    """The footprint of an object where it stands, as a shapely shape."""
    return shapely.unary_union([placed_polygon(item, part.polygon) for part in item.solids])


def placed_polygon(item: SceneObject, polygon: Any) -> Any:
    """A polygon of an object's frame where the object stands, as a shapely polygon."""
    (x, y, _), yaw = item.pose.position, item.pose.yaw
    c, s = math.cos(yaw), math.sin(yaw)
    return shapely.Polygon(np.array(polygon) @ np.array([[c, s], [-s, c]]) + (x, y))


def openings_in(scene: Scene) -> Iterator[tuple[Any, tuple[float, float]]]:
    """For each door and window the floor that it needs free, as a shapely polygon, and its heights [m]."""
    for opening in (*scene.room.doors, *scene.room.windows):
        yield shapely.Polygon(clear_zone(opening, scene.room.walls)), heights(opening)


def facts_of(scene: Scene) -> dict[str, float]:
    """The figures of a layout: tightness, hard relations an object, and how full walls and surfaces are."""
    hard = [r for r in scene.relations if r.hard]
    facts = {
        "tightness": round(tightness_of(scene), 3),
        "density": round(len(hard) / max(len(scene.objects), 1), 2),
    }
    if soft := len(scene.relations) - len(hard):
        facts["wishes"] = round(soft / len(scene.objects), 2)
    backs = {r.subject for r in hard if r.type == "against_wall"}
    length = sum(w.length for w in scene.room.walls) - sum(d.width for d in scene.room.doors)
    if backs:
        facts["wall_fill"] = round(sum(scene.object(name).size[1] for name in backs) / length, 3)
    carried = [o for o in scene.objects if o.support is not None]
    if carried:
        used = {(o.support.object, o.support.surface) for o in carried if o.support}
        boards = [s for o in scene.objects for s in o.surfaces if (o.id, s.name) in used]
        area = sum(_area(s.polygon) for s in boards)
        facts["surface_tightness"] = round(sum(o.size[0] * o.size[1] for o in carried) / area, 3)
    return facts


def _floor_of(item: SceneObject) -> Iterator[Any]:
    yield footprint(item)
    for zone in item.zones:
        if zone.hard:
            yield placed_polygon(item, zone.polygon)


def _area(polygon: Any) -> float:
    return float(shapely.Polygon(polygon).area)
