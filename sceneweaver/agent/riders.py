"""What stands on furniture and has its place there goes along with it: a search need not move each cup of a table.

For the search the carriers have a box for each of their riders instead; in its layouts the riders follow.
"""

from __future__ import annotations

import numpy as np

from sceneweaver.generate.carry import follow
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import Part, Scene, SceneObject
from sceneweaver.verify import Report

from .coarse import coarse

LEVEL = 1e-3
"""Height [m] by which the bottom of what has its place may miss its surface."""

BY_PLACE = frozenset({"out_of_bounds", "blocked_opening"})
"""Kinds of violations that say where the carrier is, and nothing of what stands on it."""


def searched(scene: Scene) -> Scene:
    """The coarse scene for a search, without what stands on something: its boxes are parts of what carries it in the
    end. With all objects when something that is carried has no place yet."""
    known = {o.id: o for o in scene.objects}
    riders = [o for o in scene.objects if o.support is not None]
    if not riders or not all(_placed(o, known) for o in riders):
        return coarse(scene)
    extra: dict[str, list[Part]] = {}
    for rider in riders:
        root = _root(rider, known)
        extra.setdefault(root.id, []).append(_box(rider, root))
    standing = tuple(o for o in scene.objects if o.support is None)
    ids = {o.id for o in standing}
    relations = tuple(r for r in scene.relations if {r.subject, *r.targets} & set(known) <= ids)
    plain = coarse(scene.model_copy(update={"objects": standing, "relations": relations}))
    objects = tuple(
        o.model_copy(update={"parts": (*o.solids, *extra[o.id])}) if o.id in extra else o for o in plain.objects
    )
    return plain.model_copy(update={"objects": objects})


def at_rest(scene: Scene, report: Report) -> bool:
    """Whether all that is carried may stay where it stands on its carrier: nothing is wrong between a carrier and what
    stands on it, and no relation that was asked for, or has to hold, is about it. What is wrong between carriers tells
    nothing: it is where they have no place yet."""
    known = {o.id: o for o in scene.objects}
    carried = {o.id for o in scene.objects if o.support is not None}
    if any((r.hard or r.asked) and carried & {r.subject, *r.targets} for r in scene.relations):
        return False
    for fault in report.violations:
        names = known.keys() & set(fault.objects) if fault.hard and fault.kind not in BY_PLACE else set()
        if carried & names and len({_root(known[name], known).id for name in names}) == 1:
            return False
    return True


def with_riders(scene: Scene, layout: Scene) -> Scene:
    """A scene with the poses of a layout of it; what the layout is without follows what carries it."""
    poses = {o.id: o.pose for o in layout.objects}
    known = {o.id: o for o in scene.objects}
    for o in scene.objects:
        if o.id not in poses:
            root = _root(o, known)
            poses[o.id] = follow(root.pose, poses[root.id], o.pose)
    placed = scene.replace_poses(poses)
    return placed.replace_area_poses({area.id: area.pose for area in layout.free_areas}) if scene.free_areas else placed


def _root(rider: SceneObject, known: dict[str, SceneObject]) -> SceneObject:
    at = rider
    while at.support is not None:
        at = known[at.support.object]
    return at


def _placed(rider: SceneObject, known: dict[str, SceneObject]) -> bool:
    """Whether a thing stands on its surface where it and its carrier are."""
    carrier = known.get(rider.support.object) if rider.support is not None else None
    if carrier is None or rider.support is None:
        return False
    surface = next((s for s in carrier.surfaces if s.name == rider.support.surface), None)
    if surface is None or not (carrier.support is None or _placed(carrier, known)):
        return False
    return abs(rider.pose.position[2] - carrier.pose.position[2] - surface.z) <= LEVEL


def _box(rider: SceneObject, root: SceneObject) -> Part:
    """The box of a rider's parts, in the frame of what carries it."""
    points = np.concatenate([rider.pose.frame.to_world(np.asarray(part.polygon)) for part in rider.solids])
    local = root.pose.frame.to_local(points)
    turn = wrap_angle(rider.pose.yaw - root.pose.yaw)
    straight = abs(np.sin(2 * turn)) < 1e-6
    (x0, y0), (x1, y1) = local.min(axis=0), local.max(axis=0)
    low = rider.pose.position[2] - root.pose.position[2]
    z = (low + min(p.z[0] for p in rider.solids), low + max(p.z[1] for p in rider.solids))
    if straight:
        ring = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    else:
        import shapely

        hull = shapely.MultiPoint(local).convex_hull
        ring = tuple((float(x), float(y)) for x, y in shapely.get_coordinates(shapely.normalize(hull))[:-1][::-1])
    return Part.model_construct(polygon=tuple((float(x), float(y)) for x, y in ring), z=z)
