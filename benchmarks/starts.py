"""Where candidates start: anywhere, drawn from the relations, or near the witness."""

from __future__ import annotations

import math

import numpy as np

from benchmarks.rooms import witness
from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.scene import Pose, Scene

STARTS = ("random", "sample", "noisy")
NOISE_M = 0.3
NOISE_RAD = math.radians(15)


def start(scene: Scene, name: str, candidates: int, seed: int) -> tuple[Scene, str | np.ndarray]:
    """The scene to refine and its ``init``. Only noisy starts know anything of the witness."""
    if name == "noisy":
        return scene, noisy_poses(scene, candidates, seed)
    return blind(scene), name


def blind(scene: Scene) -> Scene:
    """The scene without its witness: all that may move lies at the origin, at the height where it was."""
    poses = {o.id: Pose.from_yaw(0.0, 0.0, o.pose.position[2], 0.0) for o in scene.objects if not o.fixed}
    return scene.replace_poses(poses)


def movable(scene: Scene) -> np.ndarray:
    """Indices of floor objects that are not fixed."""
    return np.array([i for i, o in enumerate(scene.objects) if o.mount == "floor" and not o.fixed], dtype=int)


def noisy_poses(
    scene: Scene, candidates: int, seed: int, metres: float = NOISE_M, radians: float = NOISE_RAD
) -> np.ndarray:
    """The witness, N(0, metres) and N(0, radians) off on the floor; what stands on an object follows it."""
    rng = np.random.default_rng([seed, 0xBAD])
    poses = np.repeat(witness(scene)[None], candidates, axis=0)
    floor = movable(scene)
    poses[:, floor, :2] += rng.normal(0.0, metres, (candidates, len(floor), 2))
    poses[:, floor, 3] += rng.normal(0.0, radians, (candidates, len(floor)))
    return carry(scene, poses)


def random_poses(scene: Scene, candidates: int, seed: int) -> np.ndarray:
    """Floor objects anywhere in the box around the room, turned anyhow; what stands on an object follows it."""
    rng = np.random.default_rng([seed, 0xA11])
    poses = np.repeat(witness(scene)[None], candidates, axis=0)
    floor = movable(scene)
    outline = np.array(scene.room.outline)
    low, high = outline.min(axis=0), outline.max(axis=0)
    poses[:, floor, :2] = rng.uniform(low, high, (candidates, len(floor), 2))
    poses[:, floor, 3] = rng.uniform(-math.pi, math.pi, (candidates, len(floor)))
    return carry(scene, poses)


def carry(scene: Scene, poses: np.ndarray) -> np.ndarray:
    """Put what stands on an object where the witness has it on that object, in place."""
    own = witness(scene)
    index = {o.id: i for i, o in enumerate(scene.objects)}

    def depth(i: int) -> int:
        support = scene.objects[i].support
        return 0 if support is None else 1 + depth(index[support.object])

    carried = [i for i, o in enumerate(scene.objects) if o.support is not None and not o.fixed]
    for i in sorted(carried, key=depth):
        support = scene.objects[i].support
        assert support is not None
        below = index[support.object]
        poses[:, i] = absolute(relative(own[i], own[below]), poses[:, below])
    return poses
