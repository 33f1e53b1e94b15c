"""How many layouts are really different."""

from __future__ import annotations

import math

import numpy as np

from benchmarks.starts import movable
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import Scene

AT_WALL = 0.15  # [m] from the middle of the back
GRID = 0.5  # [m]
BINS = 8
APART_M = 0.01
APART_RAD = math.radians(1)


def signatures(scene: Scene, poses: np.ndarray) -> np.ndarray:
    """For every floor object its wall (-1: none), cell of a 0.5 m grid and eighth of a turn: [B, 4 * F] integers."""
    floor = movable(scene)
    p, yaw = poses[:, floor, :2].astype(float), poses[:, floor, 3].astype(float)
    depth = np.array([scene.objects[i].size[0] for i in floor])
    back = p - 0.5 * depth[None, :, None] * np.stack([np.cos(yaw), np.sin(yaw)], axis=-1)
    distance = _wall_distances(scene, back)
    wall = np.where(distance.min(axis=-1) <= AT_WALL, distance.argmin(axis=-1), -1)
    cell = np.floor(p / GRID).astype(int)
    eighth = np.round(yaw / (2 * math.pi / BINS)).astype(int) % BINS
    return np.concatenate([wall[..., None], cell, eighth[..., None]], axis=-1).reshape(len(poses), -1)


def _wall_distances(scene: Scene, points: np.ndarray) -> np.ndarray:
    """Distance of points [..., 2] to every wall [..., W]."""
    a = np.array(scene.room.outline)
    t = np.roll(a, -1, axis=0) - a
    along = np.clip(((points[..., None, :] - a) * t).sum(-1) / (t * t).sum(-1), 0.0, 1.0)
    return np.linalg.norm(points[..., None, :] - (a + along[..., None] * t), axis=-1)


def different(poses: np.ndarray) -> np.ndarray:
    """Indices of layouts of which any two have some object more than 1 cm or 1 degree apart."""
    count = len(poses)
    if count == 0 or poses.shape[1] == 0:
        return np.arange(min(count, 1))
    poses = poses.astype(float)
    lead = int(np.argmax(np.ptp(poses[:, :, 0], axis=0)))
    kept, indices, first = np.empty_like(poses), [], 0
    for i in np.argsort(poses[:, lead, 0], kind="stable"):
        x = poses[i, lead, 0]
        while first < len(indices) and kept[first, lead, 0] < x - APART_M:
            first += 1
        near = kept[first : len(indices)]
        moved = np.linalg.norm(near[:, :, :3] - poses[i, :, :3], axis=-1) > APART_M
        turned = np.abs(wrap_angle(near[:, :, 3] - poses[i, :, 3])) > APART_RAD
        if np.all(np.any(moved | turned, axis=1)):
            kept[len(indices)] = poses[i]
            indices.append(int(i))
    return np.array(sorted(indices), dtype=int)


def count_distinct(scene: Scene, poses: np.ndarray) -> tuple[int, int]:
    """How many layouts have a signature of their own, and how many have poses of their own."""
    kept = different(poses)
    if not len(kept):
        return 0, 0
    return len(np.unique(signatures(scene, poses[kept]), axis=0)), len(kept)
