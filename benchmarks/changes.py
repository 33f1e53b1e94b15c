"""Edits of one object of a valid layout, as someone at an editor would make them."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from benchmarks.starts import movable
from sceneweaver.geometry.se2 import SE2
from sceneweaver.scene import Add, Pose, Scene, SceneObject, SetPose, SetSize, apply
from sceneweaver.verify import check

MOVE = 0.3  # [m]
GROW = 1.1
NEW_SIZE = (0.35, 0.35, 0.8)  # [m]
TRIES = 200

Change = Callable[[Scene, np.random.Generator], "tuple[Scene, str] | None"]
"""Gives the scene after the edit and the id of the object that was edited; None when the edit is not possible."""


def _one(scene: Scene, rng: np.random.Generator) -> SceneObject:
    return scene.objects[int(rng.choice(movable(scene)))]


def _posed(scene: Scene, obj: SceneObject, dx: float, dy: float, turn: float) -> Scene:
    """An object moved with what stands on it."""
    x, y, _ = obj.pose.position
    frame = SE2(x + dx, y + dy, turn)
    for other in _stack(scene, obj.id):
        ox, oy, oz = other.pose.position
        scene = apply(
            scene, SetPose(id=other.id, pose=Pose.from_yaw(*frame.world(ox - x, oy - y), oz, other.pose.yaw + turn))
        )
    return scene


def _stack(scene: Scene, object_id: str) -> list[SceneObject]:
    """An object and all that stands on it."""
    ids = {object_id}
    while more := {o.id for o in scene.objects if o.support and o.support.object in ids} - ids:
        ids |= more
    return [o for o in scene.objects if o.id in ids]


def move(scene: Scene, rng: np.random.Generator) -> tuple[Scene, str]:
    """Push an object 0.3 m in any direction."""
    obj, angle = _one(scene, rng), rng.uniform(0, 2 * math.pi)
    return _posed(scene, obj, MOVE * math.cos(angle), MOVE * math.sin(angle), 0.0), obj.id


def turn(scene: Scene, rng: np.random.Generator) -> tuple[Scene, str]:
    """Turn an object by 90 degrees."""
    obj = _one(scene, rng)
    return _posed(scene, obj, 0.0, 0.0, math.pi / 2), obj.id


def grow(scene: Scene, rng: np.random.Generator) -> tuple[Scene, str]:
    """Make an object 10 % larger in every direction; what stands on it is lifted."""
    obj = _one(scene, rng)
    d, w, h = obj.size
    after = apply(scene, SetSize(id=obj.id, size=(GROW * d, GROW * w, GROW * h)))
    for other in _stack(after, obj.id)[1:]:
        if other.support and other.support.object == obj.id:
            surface = next(s for s in obj.surfaces if s.name == other.support.surface)
            lift = (GROW - 1) * surface.z
            for above in _stack(after, other.id):
                x, y, z = above.pose.position
                pose = Pose(position=(x, y, z + lift), quaternion=above.pose.quaternion)
                after = apply(after, SetPose(id=above.id, pose=pose))
    return after, obj.id


def _new(scene: Scene, x: float, y: float) -> Scene:
    obj = SceneObject(id="new-object", category="plant", size=NEW_SIZE, pose=Pose.from_yaw(x, y, 0.0, 0.0))
    return apply(scene, Add(object=obj))


def add_free(scene: Scene, rng: np.random.Generator) -> tuple[Scene, str] | None:
    """Put a new object where there is room for it."""
    outline = np.array(scene.room.outline)
    for _ in range(TRIES):
        after = _new(scene, *(float(v) for v in rng.uniform(outline.min(axis=0), outline.max(axis=0))))
        if check(after, walkable=False).valid:
            return after, "new-object"
    return None


def add_occupied(scene: Scene, rng: np.random.Generator) -> tuple[Scene, str]:
    """Put a new object where another one stands."""
    x, y, _ = _one(scene, rng).pose.position
    return _new(scene, x, y), "new-object"


CHANGES: dict[str, Change] = {
    "move 0.3 m": move,
    "grow 10 %": grow,
    "turn 90 degrees": turn,
    "add in a free spot": add_free,
    "add in an occupied spot": add_occupied,
}


def involved(scene: Scene, edited: str) -> set[str]:
    """The edited object, all that violations of the edited scene name, and what stands on those."""
    named = {edited}
    for violation in check(scene, walkable=False).violations:
        if violation.hard:
            named |= set(violation.objects) & set(scene.ids)
    return {o.id for object_id in named for o in _stack(scene, object_id)}
