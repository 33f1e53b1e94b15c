"""Where layouts of a problem start: anywhere, or near its witness."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.scene import Scene

NOISE_M = 0.3
NOISE_RAD = math.radians(15)


def draw(scene: Scene, witness: np.ndarray | None, count: int, seed: int) -> np.ndarray:
    """Layouts [count, N, 4] float32, by a stream of its own for each seed.

    Without a witness all but what stands on a surface is uniform in the box around the room, at its own height, and
    what stands on a surface uniform in the box around that; all turned anyhow. With one, it is the witness with noise,
    N(0, 0.3 m) and N(0, 15 degrees), for all but what stands on a surface, which goes along. What is fixed stays.
    """
    rng = np.random.default_rng([seed, 0 if witness is None else 1])
    n = len(scene.objects)
    own = np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects], dtype=np.float64).reshape(n, 4)
    base = own if witness is None else witness.astype(np.float64)
    poses = np.repeat(base[None], count, axis=0)
    outline = np.array(scene.room.outline)
    for i in _supporters_first(scene):
        item = scene.objects[i]
        if item.fixed:
            continue
        if item.support is None and witness is None:
            poses[:, i, :2] = rng.uniform(outline.min(axis=0), outline.max(axis=0), (count, 2))
            poses[:, i, 3] = rng.uniform(-math.pi, math.pi, count)
        elif item.support is None:
            poses[:, i, :2] += rng.normal(0.0, NOISE_M, (count, 2))
            poses[:, i, 3] += rng.normal(0.0, NOISE_RAD, count)
        else:
            below = scene.index(item.support.object)
            local = np.repeat(relative(base[i], base[below])[None], count, axis=0)
            if witness is None:
                surface = next(s for s in scene.objects[below].surfaces if s.name == item.support.surface)
                corners = np.array(surface.polygon)
                local[:, :2] = rng.uniform(corners.min(axis=0), corners.max(axis=0), (count, 2))
                local[:, 2] = surface.z
                local[:, 3] = rng.uniform(-math.pi, math.pi, count)
            poses[:, i] = absolute(local, poses[:, below])
    return poses.astype(np.float32)


def _supporters_first(scene: Scene) -> list[int]:
    def depth(i: int) -> int:
        support = scene.objects[i].support
        return 0 if support is None else 1 + depth(scene.index(support.object))

    return sorted(range(len(scene.objects)), key=depth)
