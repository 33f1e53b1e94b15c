"""What stands on something goes where it goes: rigid motion of objects with all that they carry."""

from __future__ import annotations

from collections.abc import Mapping

from sceneweaver.geometry.rotations import Vector, from_yaw, inverse, multiply, rotate, yaw_of
from sceneweaver.scene import Pose, Scene, SceneObject
from sceneweaver.scene.edits import SetPose


def carried(objects: Mapping[str, SceneObject], id: str) -> list[str]:
    """Ids of what stands on an object, directly or on something that does, carriers first."""
    found, at = [id], 0
    while at < len(found):
        found += [o.id for o in objects.values() if o.support is not None and o.support.object == found[at]]
        at += 1
    return found[1:]


def has_place(carrier: SceneObject) -> bool:
    """Whether an object has a place in the room already; one at the very origin waits for the engine to give it one."""
    return carrier.pose.position[:2] != (0.0, 0.0) or carrier.pose.yaw != 0.0


def move(scene: Scene, poses: Mapping[str, Pose]) -> list[SetPose]:
    """Edits that bring objects to new poses, and what they carry along with them.

    What is named itself goes to its own pose, whatever carries it.
    """
    objects = {o.id: o for o in scene.objects}
    after: dict[str, Pose] = {}
    for id in sorted(poses, key=lambda i: (_depth(objects, i), i)):
        after[id] = poses[id]
        for rider in carried(objects, id):
            after[rider] = follow(objects[id].pose, poses[id], objects[rider].pose)
    after.update(poses)
    return [SetPose(id=id, pose=pose) for id, pose in after.items()]


def follow(old: Pose, new: Pose, rider: Pose) -> Pose:
    """Where ``rider`` goes when what carries it moves rigidly from ``old`` to ``new``."""
    turn = multiply(new.quaternion, inverse(old.quaternion))
    offset = rotate(turn, _minus(rider.position, old.position))
    x, y, z = (a + b for a, b in zip(new.position, offset, strict=True))
    return Pose(position=(x, y, z), quaternion=multiply(turn, rider.quaternion))


def local(carrier: Pose, rider: Pose) -> tuple[float, float, float, float]:
    """x, y, z [m] and yaw [rad] of ``rider`` in the frame of ``carrier``."""
    back = inverse(carrier.quaternion)
    x, y, z = rotate(back, _minus(rider.position, carrier.position))
    return x, y, z, yaw_of(multiply(back, rider.quaternion))


def world(carrier: Pose, x: float, y: float, z: float, yaw: float) -> Pose:
    """The pose whose place [m] and yaw [rad] in the frame of ``carrier`` are given."""
    offset = rotate(carrier.quaternion, (x, y, z))
    a, b, c = (p + q for p, q in zip(carrier.position, offset, strict=True))
    return Pose(position=(a, b, c), quaternion=multiply(carrier.quaternion, from_yaw(yaw)))


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _depth(objects: Mapping[str, SceneObject], id: str) -> int:
    depth, at = 0, objects.get(id)
    while at is not None and at.support is not None:
        depth, at = depth + 1, objects.get(at.support.object)
    return depth
