"""Layouts of one room: where its objects stand, as arrays."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from sceneweaver.geometry.rotations import wxyz
from sceneweaver.scene import InputError, Scene

Array = np.ndarray


def poses_of(scene: Scene) -> Array:
    """Poses [N, 7] of a scene's objects: position [m] and quaternion (w, x, y, z).

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import poses_of
        >>> poses_of(sw.Scene.example("bedroom")).shape[1]
        7
    """
    rows = [(*thing.pose.position, *wxyz(thing.pose.quaternion)) for thing in scene.objects]
    return np.array(rows, dtype=float).reshape(-1, 7)


def layouts_of(scene: Scene, layouts: Any = None) -> Array:
    """Layouts [B, N, 7] of a scene's objects.

    Args:
        scene: The scene.
        layouts: None: the scene as it is; poses [B, N, 4] (x, y, z [m] and yaw [rad]), as `Solution.poses`; poses
            [B, N, 7] (position, w, x, y, z); or scenes of the same objects.

    Raises:
        InputError: another shape or other objects, or a number that is not finite.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import layouts_of
        >>> scene = sw.Scene.example("bedroom")
        >>> layouts_of(scene, [scene, scene]).shape == (2, len(scene.objects), 7)
        True
    """
    if layouts is None:
        return poses_of(scene)[None]
    if isinstance(layouts, Iterable) and not isinstance(layouts, np.ndarray):
        listed = list(layouts)
        if listed and all(isinstance(one, Scene) for one in listed):
            return _of_scenes(scene, listed)
        layouts = listed
    given = np.asarray(layouts, dtype=float)
    count = len(scene.objects)
    if given.ndim != 3 or given.shape[1] != count or given.shape[2] not in (4, 7) or not len(given):
        raise InputError(f"layouts: shape {given.shape}; give [B, {count}, 4] or [B, {count}, 7] with B above 0")
    if not np.isfinite(given).all():
        raise InputError("layouts: numbers must be finite")
    if given.shape[2] == 7:
        turns = given[..., 3:] / np.maximum(np.linalg.norm(given[..., 3:], axis=-1, keepdims=True), 1e-12)
        return np.concatenate([given[..., :3], turns], axis=-1)
    half = given[..., 3] / 2
    zero = np.zeros_like(half)
    return np.concatenate([given[..., :3], np.stack([np.cos(half), zero, zero, np.sin(half)], axis=-1)], axis=-1)


def _of_scenes(scene: Scene, layouts: list[Scene]) -> Array:
    ids = [thing.id for thing in scene.objects]
    for k, one in enumerate(layouts):
        if [thing.id for thing in one.objects] != ids:
            raise InputError(f"layouts[{k}]: not the objects of the scene; give such a scene to `scene` in a list")
    return np.stack([poses_of(one) for one in layouts])
