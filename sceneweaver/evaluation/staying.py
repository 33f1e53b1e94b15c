"""Whether objects stay where they were put when physics is let loose, as SceneSmith has it: 5 s, 1 cm, 0.1 rad."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.physics import settle_many
from sceneweaver.scene import Scene

SECONDS = 5.0
"""Time [s] that is simulated."""

FAR = 0.01
"""Movement [m] of the middle of an object's box, up to which it is stable."""

TURNED = 0.1
"""Rotation [rad] up to which it is stable."""


class Stayed(NamedTuple):
    """How many objects may move, how many of them are stable, and whether the simulation diverged: then none is."""

    free: int
    stable: int
    diverged: bool


def stability(scene: Scene, load: Load | None = None) -> Stayed:
    """Simulate a scene by MuJoCo.

    Raises:
        InputError: an asset that cannot be loaded.
    """
    many = settle_many(scene, None, load, SECONDS, device="cpu", threads=1)
    free = len(many.free)
    if many.overflow[0] or many.diverged[0]:
        return Stayed(free, 0, True)
    at = [scene.index(name) for name in many.free]
    before, after = many.start[0, at, 3:], many.poses[0, at, 3:]
    alike = np.abs((before * after).sum(axis=1)) / (np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1))
    turned = 2.0 * np.arccos(np.clip(alike, 0.0, 1.0))
    return Stayed(free, int(((many.shift[0] <= FAR) & (turned <= TURNED)).sum()), False)
