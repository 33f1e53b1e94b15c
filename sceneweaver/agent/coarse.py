"""Plainer collision shapes for the search: a layout that is valid for them is valid for the true parts inside them.

A sofa of four octagons costs the engine sixteen times what its box costs, and its box is where nothing else can stand
anyway. What others reach under (tables, desks) or around (corner sofas) keeps a box for each of its parts.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from sceneweaver.geometry.polygons import union
from sceneweaver.scene import CATALOGUE, Part, Relation, Scene, SceneObject

HANGING = 0.09
"""Depth [m] that pictures and the like are given: none hangs before another within the tolerance of its wall."""

SOLID = 0.8
"""Share of its box that an object's plan must cover to be taken for the whole box."""


DISTANCES = ("near", "distance")
"""Types of relations with a most distance between footprints: larger ones are nearer than the true ones."""

Shapes = tuple[tuple[Any, Any], ...]
"""Plan and heights of each part of an object. The same things stand in many scenes and are made plainer once."""

LEAST_MAX = 0.5
"""Share of its most distance that such a relation keeps at least."""


def coarse(scene: Scene) -> Scene:
    """The same scene with at most a few boxes for each object; ids and poses are as they were, and relations except for
    the most distance between footprints, which is less by as much as these grow."""
    carrying = {o.support.object for o in scene.objects if o.support is not None}
    seating = CATALOGUE.with_role("seat")
    seats = {r.subject for r in scene.relations if r.type in seating}
    tables = {t for r in scene.relations if r.type in seating for t in r.targets}
    objects = []
    for o in scene.objects:
        if o.mount == "wall" and o.size[0] < HANGING and o.id not in carrying:
            objects.append(o.model_copy(update={"parts": (_hanging(o),)}))
        elif not o.parts or o.id in carrying:
            objects.append(o)
        elif o.id in seats or o.id in tables:
            objects.append(o.model_copy(update={"parts": tuple(_box(part.polygon, part.z) for part in o.parts)}))
        else:
            objects.append(o.model_copy(update={"parts": _merged(_shapes(o), o.size[0] * o.size[1])}))
    pairs = {true.id: (true, rough) for true, rough in zip(scene.objects, objects, strict=True)}
    relations = tuple(_nearer(r, pairs) if r.type in DISTANCES else r for r in scene.relations)
    return scene.model_copy(update={"objects": tuple(objects), "relations": relations})


def _nearer(relation: Relation, pairs: Mapping[str, tuple[SceneObject, SceneObject]]) -> Relation:
    """A relation that true footprints hold wherever the rough ones of its objects hold it."""
    given = relation.params.get("max", CATALOGUE[relation.type].params["max"].default)
    grown = sum(_growth(*pairs[name]) for name in (relation.subject, *relation.targets) if name in pairs)
    if not isinstance(given, int | float) or grown <= 0.0:
        return relation
    least = relation.params.get("min")
    most = max(given - grown, LEAST_MAX * given, least if isinstance(least, int | float) else 0.0)
    return relation.model_copy(update={"params": {**relation.params, "max": most}})


def _growth(true: SceneObject, rough: SceneObject) -> float:
    """The largest distance [m] of a point of the rough footprint from the true one."""
    return 0.0 if true is rough else _grown(_shapes(true), _shapes(rough))


@lru_cache(maxsize=256)
def _grown(true: Shapes, rough: Shapes) -> float:
    import shapely

    plans = [union(shapely.Polygon(polygon) for polygon, _ in shapes) for shapes in (true, rough)]
    return max(float(shapely.distance(plans[0], point)) for point in shapely.points(shapely.get_coordinates(plans[1])))


def _hanging(obj: SceneObject) -> Part:
    """The box of a thin thing on a wall with the space before it."""
    depth, width, height = obj.size
    return _prism(-depth / 2, -width / 2, HANGING - depth / 2, width / 2, (0.0, height))


def _shapes(obj: SceneObject) -> Shapes:
    return tuple((part.polygon, part.z) for part in obj.solids)


def _box(polygon: Any, z: Any) -> Part:
    xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
    return _prism(min(xs), min(ys), max(xs), max(ys), z)


def _prism(x0: float, y0: float, x1: float, y1: float, z: tuple[float, float]) -> Part:
    return Part.model_construct(polygon=((x0, y0), (x1, y0), (x1, y1), (x0, y1)), z=z)


@lru_cache(maxsize=512)
def _merged(shapes: Shapes, area: float) -> tuple[Part, ...]:
    """One box around all parts where their boxes fill most of it, or most of the object's own (of an ``area`` [m2]);
    else those boxes.

    What is high above the floor, such as the shade of an arched lamp, stays apart from what stands below it.
    """
    import shapely

    boxes = [_box(polygon, z) for polygon, z in shapes]
    plan = union(shapely.Polygon(b.polygon) for b in boxes)
    if plan.area >= SOLID * min(area, plan.envelope.area):
        x0, y0, x1, y1 = plan.bounds
        return (_prism(x0, y0, x1, y1, (min(b.z[0] for b in boxes), max(b.z[1] for b in boxes))),)
    return tuple(boxes)
