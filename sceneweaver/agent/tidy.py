"""Share out the seats of a valid layout evenly; whatever the judge then finds worse goes back to where it was."""

from __future__ import annotations

import math

from sceneweaver.scene import Pose, Scene, SceneObject
from sceneweaver.verify import check

from .seats import spread

ROUNDS = 4

ALONE = 12
"""Objects of one step that are tried one by one."""

Poses = dict[str, tuple[float, float, float, float]]


def tidy(scene: Scene) -> Scene:
    """The scene with its seats shared out; what it violates is no more than before."""
    return _kept(scene, spread(scene))


def _kept(scene: Scene, wanted: Poses) -> Scene:
    """The scene with as many of the wanted poses as the judge finds no fault with.

    All at once first; then without those that are in trouble, which at last are tried one by one, the largest first.
    """
    wanted = {id: pose for id, pose in wanted.items() if _moves(scene.object(id), pose)}
    if not wanted:
        return scene
    before, late = _faults(scene), []
    for _ in range(ROUNDS):
        after = _moved(scene, wanted)
        worse = _faults(after) - before
        if not worse:
            scene = after
            break
        named = {id for _, objects in worse for id in objects if id in set(scene.ids)}
        blamed = named | {_root(scene, id) for id in named}
        late += [(id, wanted.pop(id)) for id in list(wanted) if id in blamed]
        if not wanted or not blamed:
            break
    late.sort(key=lambda row: -scene.object(row[0]).size[0] * scene.object(row[0]).size[1])
    for id, pose in late[:ALONE]:
        after = _moved(scene, {id: pose})
        if not _faults(after) - before:
            scene = after
    return scene


def _faults(scene: Scene) -> set[tuple[str, tuple[str, ...]]]:
    report = check(scene, walkable=False)
    return {(v.relation.type if v.relation else v.kind, v.objects) for v in report.violations}


def _moves(obj: SceneObject, pose: tuple[float, float, float, float]) -> bool:
    (x, y, z), yaw = obj.pose.position, obj.pose.yaw
    return max(abs(pose[0] - x), abs(pose[1] - y), abs(pose[2] - z), abs(_wrap(pose[3] - yaw))) > 1e-6


def _moved(scene: Scene, wanted: Poses) -> Scene:
    """The scene with objects elsewhere, and what stands on them carried along."""
    above: dict[str, list[str]] = {}
    for o in scene.objects:
        if o.support is not None:
            above.setdefault(o.support.object, []).append(o.id)
    poses: dict[str, Pose] = {}

    def place(id: str, x: float, y: float, z: float, yaw: float) -> None:
        old = scene.object(id).pose
        poses[id] = Pose.from_yaw(x, y, z, _wrap(yaw))
        turn = yaw - old.yaw
        c, s = math.cos(turn), math.sin(turn)
        for other in above.get(id, ()):
            p = scene.object(other).pose
            dx, dy = p.position[0] - old.position[0], p.position[1] - old.position[1]
            up = p.position[2] - old.position[2]
            place(other, x + c * dx - s * dy, y + s * dx + c * dy, z + up, p.yaw + turn)

    for id, pose in wanted.items():
        place(id, *pose)
    return scene.replace_poses(poses)


def _root(scene: Scene, id: str) -> str:
    obj = scene.object(id)
    while obj.support is not None:
        obj = scene.object(obj.support.object)
    return obj.id


def _wrap(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
