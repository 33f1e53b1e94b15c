"""Between a scene as it is and what the engine can solve: upright objects, not far from the room.

The engine knows x, y, z and yaw. A tilted object takes part as the upright prisms that contain it, and gets its tilt
back afterwards; so does what leans less than the judge minds.
"""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.rotations import from_yaw, multiply, tilt_of
from sceneweaver.scene import Part, Pose, Scene, SceneObject

UPRIGHT = math.radians(0.5)  # tilt that the judge takes for none
SAME = 1.0e-5  # [m] and [rad] by which a pose may differ and still count as unmoved; float32 loses about 1e-6
LEVEL = 1.9e-3  # [m] of height above what it stands on or below what it hangs from; the judge allows 2 mm


def engine_scene(scene: Scene, relations: bool) -> tuple[Scene, np.ndarray]:
    """The scene for the engine, and how far [N] the lowest point of each object is above its origin [m].

    Objects stand upright on their lowest point. What has its origin outside of the room begins at the nearest point
    of the outline, as an object that is far away would rather turn than come closer. Without ``relations`` all of
    them are soft, so that they do not count but still tie objects to each other's zones.
    """
    lift = np.zeros(len(scene.objects))
    objects = []
    for i, obj in enumerate(scene.objects):
        shape, lift[i] = _upright(obj)
        objects.append(shape)
    kept = scene.relations if relations else tuple(r.model_copy(update={"hard": False}) for r in scene.relations)
    return _indoors(scene.model_copy(update={"objects": tuple(objects), "relations": kept})), lift


def _upright(obj: SceneObject) -> tuple[SceneObject, float]:
    x, y, z = obj.pose.position
    if tilt_of(obj.pose.quaternion) <= UPRIGHT:
        return obj.model_copy(update={"pose": Pose.from_yaw(x, y, z, obj.pose.yaw)}), 0.0
    from sceneweaver.layout.shapes import solids_of

    prisms = solids_of(obj)
    low = min(p.z[0] for p in prisms)
    parts = tuple(
        Part.model_construct(polygon=tuple((float(u), float(v)) for u, v in p.polygon), z=(p.z[0] - low, p.z[1] - low))
        for p in prisms
    )
    size = (*obj.size[:2], max(p.z[1] for p in parts))
    pose = Pose.from_yaw(x, y, z + low, obj.pose.yaw)
    return obj.model_copy(update={"pose": pose, "parts": parts, "size": size}), low


def _indoors(scene: Scene) -> Scene:
    """Objects whose origin is outside of the outline at its nearest point, with what stands on them."""
    import shapely
    from shapely.ops import nearest_points

    room = shapely.Polygon(scene.room.outline)
    index = {o.id: i for i, o in enumerate(scene.objects)}
    poses = {}
    for obj in scene.objects:
        base = obj
        while base.support is not None:
            base = scene.objects[index[base.support.object]]
        at = shapely.Point(base.pose.position[:2])
        if not obj.fixed and not base.fixed and not room.covers(at):
            near = nearest_points(room, at)[0]
            x, y, z = obj.pose.position
            poses[obj.id] = Pose.from_yaw(x + near.x - at.x, y + near.y - at.y, z, obj.pose.yaw)
    return scene.replace_poses(poses)


def put_back(scene: Scene, lift: np.ndarray, poses: np.ndarray) -> Scene:
    """The scene with the engine's poses [N, 4]: what has not moved keeps its pose to the bit, all keep their tilt."""
    index = {o.id: i for i, o in enumerate(scene.objects)}
    after: dict[int, Pose] = {}

    def settle(i: int) -> Pose:
        """The pose of an object, where that of what it stands on is known."""
        obj, (x, y, z, yaw) = scene.objects[i], (float(value) for value in poses[i])
        (u, v, w), quaternion = obj.pose.position, obj.pose.quaternion
        if i in after or obj.fixed:
            return after.get(i, obj.pose)
        z -= lift[i]
        if obj.support is not None:
            below = index[obj.support.object]
            z += settle(below).position[2] + lift[below] - float(poses[below, 2])
        if max(abs(x - u), abs(y - v)) > SAME:
            u, v = x, y
        if abs(z - w) > (SAME if obj.mount == "wall" else LEVEL):
            w = float(z)
        turn = wrap_angle(yaw - obj.pose.yaw)
        after[i] = Pose(
            position=(u, v, w), quaternion=multiply(from_yaw(turn), quaternion) if abs(turn) > SAME else quaternion
        )
        return after[i]

    settled = {}
    for i, obj in enumerate(scene.objects):
        chain = [i]  # what it stands on, and what that stands on, first
        while (support := scene.objects[chain[-1]].support) is not None and index[support.object] not in after:
            chain.append(index[support.object])
        for below in reversed(chain):
            settled[obj.id] = settle(below)
    return scene.replace_poses({o.id: settled[o.id] for o in scene.objects if settled[o.id] != o.pose})
