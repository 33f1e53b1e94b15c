"""Moving one thing of a scene, with all that stands on it, and judging what that does where it ends up."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.geometry.polygons import rectangle
from sceneweaver.scene import Relation, Scene, SceneObject
from sceneweaver.scene.edits import carried
from sceneweaver.verify import Violation, check
from sceneweaver.verify.solids import Array, Body, Placed

from .facts import FLAT, group_of

NEIGHBOURHOOD = 0.1
"""Distance [m] from which two things have nothing to do with each other, their zones aside."""

_BUILT_IN = frozenset(("sanitary",))
_FASTENED = frozenset(("run_on", "on_grid", "next_to"))


def is_movable(scene: Scene, body: Body) -> bool:
    """Whether people would move it about: it stands on the floor, alone, and is no fixture."""
    item = body.item
    if item.mount != "floor" or item.fixed or body.tilted or body.z[1] <= FLAT or group_of(item.category) in _BUILT_IN:
        return False
    return not any(r.type in _FASTENED and body.id in (r.subject, *r.targets) for r in scene.relations)


class Judged(NamedTuple):
    """What is wrong after a move: hard violations, and the relations of `soft` that do not hold, by their place."""

    hard: list[Violation]
    lost: list[int]


def judged_locally(
    scene: Scene, object_id: str, hard: Sequence[Relation], soft: Sequence[Relation] = (), reaches: Array | None = None
) -> Judged:
    """What is wrong with an object and all that it carries, judged with what is near it alone.

    All judgements but walkability are between neighbours, so this is what ``check`` says of these objects.

    Args:
        scene: the scene after the move.
        object_id: what was moved.
        hard: relations that have to hold; those that do not concern these objects are left out.
        soft: relations that need not hold.
        reaches: what `reaches_of` says of the scene, where that is known.
    """
    group = carried(scene, object_id)
    centres = np.array([o.pose.position[:2] for o in scene.objects])
    reaches = (reaches_of(scene) if reaches is None else reaches)[:, None]
    mine = np.array([o.id in group for o in scene.objects])
    low, high = (centres - reaches)[mine].min(axis=0), (centres + reaches)[mine].max(axis=0)
    near = ((centres - reaches <= high + NEIGHBOURHOOD) & (centres + reaches >= low - NEIGHBOURHOOD)).all(axis=1)
    wanted = {scene.objects[k].id for k in np.flatnonzero(near)}
    targets = {r.target for r in hard if r.subject in group and r.target is not None}
    tied = [r for r in hard if not group.keys().isdisjoint((r.subject, *r.targets)) or r.target in targets]
    judged = [*tied, *(r.model_copy(update={"hard": False}) for r in soft)]
    ids = {o.id: o for o in scene.objects}
    wanted |= {name for r in judged for name in (r.subject, *r.targets) if name in ids}
    for name in [*wanted]:
        support = ids[name].support
        while support is not None and support.object not in wanted:
            wanted.add(support.object)
            support = ids[support.object].support
    objects = tuple(o for o in scene.objects if o.id in wanted)
    part = scene.model_copy(update={"objects": objects, "relations": tuple(judged), "dropped": ()})
    found = [v for v in check(part, walkable=False).violations if v.relation or not group.keys().isdisjoint(v.objects)]
    lost = [v.relation.index - len(tied) for v in found if v.relation is not None and v.relation.index >= len(tied)]
    return Judged([v for v in found if v.hard], lost)


def reaches_of(scene: Scene) -> Array:
    """How far [m] each object with its zones reaches from its origin, in the plane."""
    return np.array([_reach(o) for o in scene.objects])


def _reach(item: SceneObject) -> float:
    """How far [m] an object with its zones reaches from its origin, in the plane; generous for what is tilted."""
    reach = math.hypot(*item.size) / 2
    return max([reach, *(math.hypot(x, y) for zone in item.zones for x, y in zone.polygon)])


class Space:
    """What is in the way in a scene, for boxes that are to stand somewhere."""

    def __init__(self, scene: Scene, placed: Placed | None = None, reaches: Array | None = None):
        import shapely

        self.scene = scene
        self.placed = Placed.of(scene) if placed is None else placed
        self.reaches = reaches_of(scene) if reaches is None else reaches
        self.parts = shapely.STRtree(self.placed.parts.polygons)
        doors = self.placed.opening_zones.polygons[: len(self.placed.doors)]
        self.zones = shapely.STRtree(np.concatenate([self.placed.zones.polygons, doors]))
        self.zone_owner = np.append(self.placed.zones.owner, np.full(len(doors), -1))
        self.zone_low = np.append(self.placed.zones.z[:, 0], np.zeros(len(doors)))

    def after(self, scene: Scene, object_id: str) -> Space:
        """The space of a scene in which one object, with what it carries, has moved and all else has not."""
        group = carried(scene, object_id)
        part = scene.model_copy(update={"objects": tuple(o for o in scene.objects if o.id in group)})
        moved = {body.id: body for body in Placed.of(part).bodies}
        bodies = tuple(replace(moved[b.id], index=b.index) if b.id in moved else b for b in self.placed.bodies)
        return Space(scene, replace(self.placed, scene=scene, bodies=bodies), self.reaches)

    def free(self, object_id: str, poses: np.ndarray, height: float, carrier: tuple[str, str] | None) -> np.ndarray:
        """Where an object's box and zones would stand free.

        Args:
            object_id: the object; what it carries is not in its way.
            poses: candidates [n, 3] (x, y, yaw) [m, rad].
            height: of its bottom [m].
            carrier: object and surface under it, of which it must not reach over the edge; None: the floor.

        Returns:
            Flags [n].
        """
        import shapely

        item = self.scene.object(object_id)
        group = carried(self.scene, object_id)
        mine = np.array([b.index for b in self.placed.bodies if b.id in group])
        low, high = height, height + item.size[2]
        z = self.placed.parts.z
        blocking = (z[:, 0] < high - 1e-3) & (z[:, 1] > low + 1e-3) & ~np.isin(self.placed.parts.owner, mine)
        if carrier is None:
            region, blocking = self.placed.floor, blocking & (z[:, 1] > FLAT)
        else:
            body = self.placed.by_id[carrier[0]]
            surface = next(s for s in body.item.surfaces if s.name == carrier[1])
            region = shapely.polygons(body.frame.to_world(surface.polygon))
        region = shapely.buffer(region, 1e-3)
        shapely.prepare(region)
        boxes = _placed(rectangle(*item.size[:2]), poses)
        good = shapely.contains_properly(region, boxes)
        row, part = self.parts.query(boxes, predicate="intersects")
        good[row[blocking[part]]] = False
        row, zone = self.zones.query(boxes, predicate="intersects")
        good[row[~np.isin(self.zone_owner[zone], mine) & (self.zone_low[zone] < high)]] = False
        for own in (zone for zone in item.zones if zone.hard):
            row, part = self.parts.query(_placed(own.polygon, poses), predicate="intersects")
            good[row[blocking[part]]] = False
        return good


def _placed(polygon: Sequence[tuple[float, float]], poses: np.ndarray) -> np.ndarray:
    """A polygon of an object's frame at poses [n, 3], as shapely geometries [n]."""
    import shapely

    c, s = np.cos(poses[:, 2:]), np.sin(poses[:, 2:])
    x, y = np.array(polygon).T
    made: Any = shapely.polygons(np.stack([poses[:, :1] + c * x - s * y, poses[:, 1:2] + s * x + c * y], axis=-1))
    return made
