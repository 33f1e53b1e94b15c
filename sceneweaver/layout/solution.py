"""What a refinement returns."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import Pose, Scene

WALKABLE = 0.9  # share of the free floor that a room should let one walk to


def rank(
    scene: Scene,
    status: np.ndarray,
    relations: np.ndarray,
    energy: np.ndarray,
    walkable: np.ndarray | None = None,
    moved: np.ndarray | None = None,
) -> np.ndarray:
    """Order [B] of candidates, best first. A floor that was not measured counts as a blocked one.

    Where movement counts (an edit of a scene that is there already), it comes before anything but the status.
    """
    return np.lexsort(_keys(scene, status, relations, energy, walkable, moved)[::-1])


def best_of(
    k: int,
    scene: Scene,
    status: np.ndarray,
    relations: np.ndarray,
    energy: np.ndarray,
    moved: np.ndarray | None = None,
) -> np.ndarray:
    """The first k of `rank`, without sorting all the others: a batch may have millions of candidates."""
    keys = _keys(scene, status, relations, energy, None, moved)
    chosen: list[np.ndarray] = []
    tied = np.arange(len(status))
    for key in keys:
        left = k - sum(map(len, chosen))
        if len(tied) <= left:
            break
        values = key[tied]
        last = values.min()
        if np.count_nonzero(values == last) < left:  # rare: most candidates are valid, and many have nothing left
            last = np.partition(values, left - 1)[left - 1]
        chosen.append(tied[values < last])
        tied = tied[values == last]
    few = np.concatenate([*chosen, tied])
    few.sort()  # where all keys are alike, the first come first
    return few[np.lexsort([key[few] for key in keys[::-1]])][:k]


def _keys(
    scene: Scene,
    status: np.ndarray,
    relations: np.ndarray,
    energy: np.ndarray,
    walkable: np.ndarray | None,
    moved: np.ndarray | None,
) -> list[np.ndarray]:
    """What candidates are ordered by, the most important first: numbers [B], the less the better."""
    keys = [status]
    if moved is not None:
        keys.append(np.where(np.isnan(moved), np.inf, moved))
    if walkable is not None:
        keys.append(np.round(1.0 - np.minimum(np.nan_to_num(walkable), WALKABLE) / WALKABLE, 3))
    missing = np.zeros(len(status))
    for i, relation in enumerate(scene.relations):
        if not relation.hard:
            missing += relation.weight * ~relations[:, i]
    return [*keys, missing, np.where(np.isnan(energy), np.inf, energy)]


@dataclass(frozen=True)
class Solution:
    """Refined candidates of one scene.

    Attributes:
        source: the scene that was refined.
        poses: world poses (x, y, z, yaw) [B, N, 4] float32, objects in the scene's order.
        status: [B] int8: 0 valid, 1 hard violation, 2 a hard relation is false, 3 diverged.
        relations: [B, R] bool, relations in the scene's order.
        energy: [B] float32, what was left of the energy [m]; 0 means everything holds with its margin.
        walkable: [B] float32, share of the free floor that can be reached from the doors; measured for the best few
            candidates, NaN for the others.
        moved: [B], how far objects were moved in all [m], where ``init="current"`` asked for little; None otherwise.
            An object that was in order before counts as 5 m more when it moves at all.
        elapsed: seconds from call to return.
        timed_out: True when the time limit cut the run off.
        explanation: what stands in the way when nothing is valid; None otherwise.
    """

    source: Scene
    poses: np.ndarray
    status: np.ndarray
    relations: np.ndarray
    energy: np.ndarray
    walkable: np.ndarray
    moved: np.ndarray | None
    seed: int
    device: str
    elapsed: float
    timed_out: bool = False
    explanation: str | None = None

    @property
    def candidates(self) -> int:
        """Number of candidates B."""
        return len(self.status)

    @cached_property
    def order(self) -> np.ndarray:
        """Candidates, best first: by status, then blocked floor, then soft relations missing, then energy."""
        return rank(self.source, self.status, self.relations, self.energy, self.walkable, self.moved)

    def scene(self, candidate: int) -> Scene:
        """The scene in one candidate's layout. Fixed objects keep their exact poses."""
        poses = {}
        for obj, (x, y, z, yaw) in zip(self.source.objects, self.poses[candidate].astype(float), strict=True):
            if not obj.fixed:
                poses[obj.id] = Pose.from_yaw(float(x), float(y), float(z), float(yaw))
        return self.source.replace_poses(poses)

    @property
    def best(self) -> Scene:
        """The scene in its best layout."""
        return self.scene(int(self.order[0]))

    def distinct(self, k: int) -> list[Scene]:
        """Up to k valid layouts, best first, that differ: some object is 0.5 m or 45 degrees away."""
        chosen: list[int] = []
        for i in self.order:
            if self.status[i] != 0 or len(chosen) == k:
                break
            if all(_differ(self.poses[i], self.poses[j]) for j in chosen):
                chosen.append(int(i))
        return [self.scene(i) for i in chosen]


def _differ(a: np.ndarray, b: np.ndarray) -> bool:
    """True when some object stands 0.5 m or is turned 45 degrees apart."""
    moved = np.linalg.norm(a[:, :3] - b[:, :3], axis=1) >= 0.5
    turned = np.abs(wrap_angle(a[:, 3] - b[:, 3])) >= np.pi / 4
    return bool(np.any(moved | turned))
