"""Relations for placers that move objects and never turn them: intervals along directions that stay the same.

Which wall, corner or side is meant is settled once, for every candidate, by where the objects are at the start.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.rivals.pulls import Room
from benchmarks.starts import movable
from sceneweaver.scene import CATALOGUE, Relation, Scene

APART = 1e9  # [m] no limit


@dataclass(frozen=True)
class Hinge:
    """Wants ``low <= direction . (subject - target) <= high`` of the middles of floor objects.

    Attributes:
        subject, target: floor objects; a target of -1 is the origin of the room.
        direction: unit vectors [B, 2], or None for the distance of the middles.
        low, high: limits [B] [m].
    """

    subject: int
    target: int
    direction: np.ndarray | None
    low: np.ndarray
    high: np.ndarray


def footprints(scene: Scene, poses: np.ndarray) -> np.ndarray:
    """Half extents [B, n, 2] along the axes of the room of floor objects as they are turned in poses [B, N, 4] [m]."""
    floor = movable(scene)
    half = np.array([scene.objects[i].size for i in floor]).reshape(-1, 3)[:, :2] / 2
    c, s = np.abs(np.cos(poses[:, floor, 3])), np.abs(np.sin(poses[:, floor, 3]))
    return np.stack([c * half[:, 0] + s * half[:, 1], s * half[:, 0] + c * half[:, 1]], axis=-1)


def hinges(scene: Scene, starts: np.ndarray) -> list[Hinge]:
    """Hinges of all relations of floor objects that say something about positions, from starts [B, N, 4]."""
    floor, room, half = movable(scene), Room(scene), footprints(scene, starts)
    index = {scene.objects[i].id: k for k, i in enumerate(floor)}
    middle = starts[:, floor, :2]
    found: list[Hinge] = []
    for rel in scene.relations:
        a = index.get(rel.subject, -1)
        b = index.get(rel.target, -1) if isinstance(rel.target, str) else -1
        if a >= 0:
            found += _room_hinges(scene, room, rel, a, middle[:, a], half[:, a])
        if a >= 0 and b >= 0:
            found += _object_hinges(rel, a, b, middle, half)
    return found


def _limits(low: float, high: float, by: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """An interval of faces as one of middles, ``by`` [B] apart."""
    return low + by, high + by


def _at_walls(room: Room, a: int, walls: np.ndarray, half: np.ndarray, high: float) -> Hinge:
    """Box a at walls [B], at most ``high`` from them."""
    n = room.n[walls]
    level = (n * room.p[walls]).sum(axis=1) + (np.abs(n) * half).sum(axis=1)
    return Hinge(a, -1, n, *_limits(0.0, high, level))


def _room_hinges(
    scene: Scene, room: Room, rel: Relation, a: int, middle: np.ndarray, half: np.ndarray
) -> Iterator[Hinge]:
    """Nearest wall, corner or window at the start."""
    spec = CATALOGUE[rel.type]
    if rel.type in ("against_wall", "side_against_wall"):
        walls = np.abs(np.einsum("bwi,wi->bw", middle[:, None] - room.p, room.n)).argmin(axis=1)
        if isinstance(rel.target, str):
            walls[:] = int(rel.target.partition(":")[2])
        yield _at_walls(room, a, walls, half, spec.gap_range(rel, 0.0)[1])
    elif rel.type == "in_corner":
        away = np.linalg.norm(middle[:, None] - room.p[room.convex], axis=-1)
        corner = room.convex[away.argmin(axis=1)]
        for walls in (corner, corner - 1):
            yield _at_walls(room, a, walls, half, spec.value(rel, "to_wall"))
    elif rel.type == "at_window":
        window = next((w for w in scene.room.windows if rel.target in (None, w.id)), None)
        if window is not None:
            walls = np.full(len(middle), window.wall)
            yield _at_walls(room, a, walls, half, spec.value(rel, "max"))
            along = room.t[walls]
            begin = (along * room.p[walls]).sum(axis=1) + window.offset
            yield Hinge(a, -1, along, *_limits(0.0, window.width, begin))


def _object_hinges(rel: Relation, a: int, b: int, middle: np.ndarray, half: np.ndarray) -> Iterator[Hinge]:
    """Next to the target on the side where the subject is, or within a distance of it."""
    spec = CATALOGUE[rel.type]
    d, reach = middle[:, a] - middle[:, b], half[:, a] + half[:, b]
    if spec.subject_sides and spec.target_sides:
        rows = np.arange(len(d))
        axis = (np.abs(d) - reach).argmax(axis=1)
        side = np.zeros_like(d)
        side[rows, axis] = np.where(d[rows, axis] < 0, -1.0, 1.0)
        yield Hinge(a, b, side, *_limits(0.0, spec.gap_range(rel, 0.0)[1], reach[rows, axis]))
        across = 1 - axis
        least = spec.value(rel, "overlap") * 2 * np.minimum(half[rows, a, across], half[rows, b, across])
        slide = np.maximum(reach[rows, across] - least, 0.0)
        yield Hinge(a, b, np.abs(side[:, ::-1]), -slide, slide)
    elif rel.type in ("near", "distance"):
        most = spec.value(rel, "max")
        around = half[:, a].min(axis=1) + half[:, b].min(axis=1)
        low = (spec.value(rel, "min") or 0.0) if rel.type == "distance" else 0.0
        yield Hinge(a, b, None, *_limits(low, APART if most is None else most, around))
