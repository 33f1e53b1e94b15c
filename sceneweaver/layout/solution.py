"""What a refinement returns."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import Pose, Scene
from sceneweaver.scene.display import Shown

from .free_floor import area_poses

WALKABLE = 0.9  # share of the free floor that a room should let one walk to
ALL_SOFT = 16.0  # points of quality that all soft relations weigh together
AT_WALL = 0.15  # [m] from a wall at which something stands there
LARGE = 0.35  # [m2] of plan from which on a piece makes a layout another one


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


def missing_points(scene: Scene, relations: np.ndarray) -> np.ndarray:
    """Points [B] that soft relations take off which do not hold: `ALL_SOFT` when none does."""
    weights = np.array([0.0 if r.hard else r.weight for r in scene.relations])
    return ALL_SOFT * (~relations @ weights) / max(float(weights.sum()), 1e-9)


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
class Solution(Shown):
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
        quality: [B] float32, minus the points that the terms of design quality take off (0 at best), NaN where a
            candidate is not valid; None where there are no such terms.
        objective: [B] float64, the value of the objective that was minimised, NaN where a candidate is not valid; None
            where there was none.
        timed_out: True when the time limit cut the run off.
        free_floor: [B, F, 4] float32, poses of the bodies that stand for free areas; None where there are none.
        floors: for each of these its place among the scene's free areas; None where that has no pose of its own.
        explanation: what stands in the way when nothing is valid, soft relations that hold in no valid layout, and
            relations of your own that engine and judge see otherwise; None where there is nothing to say.

    Examples:
        >>> import sceneweaver as sw
        >>> solution = sw.refine(sw.Scene.example("bedroom"), candidates=8, device="cpu")
        >>> solution.candidates, len(solution.distinct(3)) <= 3
        (8, True)
        >>> solution.best == solution.scene(solution.order[0])
        True
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
    quality: np.ndarray | None = None
    objective: np.ndarray | None = None
    free_floor: np.ndarray | None = None
    floors: tuple[int | None, ...] = ()

    @property
    def candidates(self) -> int:
        """Number of candidates B."""
        return len(self.status)

    @cached_property
    def order(self) -> np.ndarray:
        """Candidates, best first: by status, then blocked floor, then soft relations missing, then energy.

        With terms of quality these come before the energy, in one sum with the soft relations. An objective comes
        right after the status.
        """
        keys = _keys(self.source, self.status, self.relations, self.energy, self.walkable, self.moved)
        if self.objective is not None:
            keys.insert(1, np.where(np.isnan(self.objective), np.inf, self.objective))
        if self.quality is None:
            return np.lexsort(keys[::-1])
        worth = np.where(np.isnan(self.quality), -np.inf, self.quality)
        keys[-2] = np.round(missing_points(self.source, self.relations) - worth, 4)
        return np.lexsort(keys[::-1])

    @property
    def ranked(self) -> np.ndarray:
        """The valid candidates, best first."""
        return self.order[self.status[self.order] == 0]

    def scene(self, candidate: int) -> Scene:
        """The scene in one candidate's layout. Fixed objects keep their exact poses."""
        poses = {}
        for obj, (x, y, z, yaw) in zip(self.source.objects, self.poses[candidate].astype(float), strict=True):
            if not obj.fixed:
                poses[obj.id] = Pose.from_yaw(float(x), float(y), float(z), float(yaw))
        placed = self.source.replace_poses(poses)
        if self.free_floor is None:
            return placed
        return placed.replace_area_poses(area_poses(self.source, self.floors, self.free_floor[candidate]))

    @property
    def bodies(self) -> np.ndarray:
        """Poses [B, N + F, 4] of objects and of what stands for free areas, as the engine takes them to begin with."""
        return self.poses if self.free_floor is None else np.concatenate([self.poses, self.free_floor], axis=1)

    @property
    def best(self) -> Scene:
        """The scene in its best layout."""
        return self.scene(int(self.order[0]))

    def distinct(self, k: int) -> list[Scene]:
        """Up to k valid layouts, best first, that differ: some object is 0.5 m or 45 degrees away.

        With terms of quality the best of each of `signatures` come first and make up half; the others differ in poses.
        """
        return [self.scene(i) for i in self.best_candidates(k)]

    def best_candidates(self, k: int) -> list[int]:
        """The candidates of `distinct`."""
        first = [] if self.quality is None else best_of_each_signature(self)[: (k + 1) // 2]
        chosen = [int(i) for i in first]
        left = self.ranked
        for i in chosen:
            left = left[differ(self.poses[left], self.poses[i])]
        while len(left) and len(chosen) < k:
            chosen.append(int(left[0]))
            left = left[differ(self.poses[left], self.poses[left[0]])]
        return chosen


def joined(first: Solution, second: Solution) -> Solution:
    """One solution with the candidates of two of the same scene, both rated or neither; neither keeps to poses."""

    def both(name: str) -> np.ndarray:
        return np.concatenate([getattr(first, name), getattr(second, name)])

    rated = () if first.quality is None else ("quality",)
    rated += () if first.free_floor is None else ("free_floor",)
    rated += () if first.objective is None else ("objective",)
    return replace(
        first,
        **{name: both(name) for name in ("poses", "status", "relations", "energy", "walkable", *rated)},
        elapsed=first.elapsed + second.elapsed,
        timed_out=first.timed_out or second.timed_out,
    )


def signatures(scene: Scene, poses: np.ndarray) -> np.ndarray:
    """What makes layouts [B, N, 4] really different: integers [B, 2 F] for the F large pieces that may move.

    For each its wall (-1: none) and its eighth of a turn.
    """
    large = [
        i
        for i, o in enumerate(scene.objects)
        if o.mount == "floor" and not o.fixed and o.size[0] * o.size[1] >= LARGE and o.size[2] > 0.05
    ]
    chosen = poses[:, large].astype(float)
    yaw, half = chosen[..., 3], np.array([scene.objects[i].size[0] / 2 for i in large])
    back_x, back_y = chosen[..., 0] - half * np.cos(yaw), chosen[..., 1] - half * np.sin(yaw)
    gap, wall = np.full(yaw.shape, np.inf), np.full(yaw.shape, -1)
    start = np.array(scene.room.outline)
    for number, ((x, y), (u, v)) in enumerate(zip(start, np.roll(start, -1, axis=0) - start, strict=True)):
        share = np.clip(((back_x - x) * u + (back_y - y) * v) / (u * u + v * v), 0.0, 1.0)
        own = np.sqrt((back_x - (x + share * u)) ** 2 + (back_y - (y + share * v)) ** 2)
        nearer = own < gap
        gap[nearer], wall[nearer] = own[nearer], number
    wall[gap > AT_WALL] = -1
    eighth = np.round(yaw / (np.pi / 4)).astype(int) % 8
    return np.concatenate([wall, eighth], axis=-1)


def best_of_each_signature(solution: Solution) -> np.ndarray:
    """The best valid candidate of each signature, best first."""
    ranked = solution.ranked
    _, first = np.unique(signatures(solution.source, solution.poses[ranked]), axis=0, return_index=True)
    return ranked[np.sort(first)]


def differ(layouts: np.ndarray, other: np.ndarray) -> np.ndarray:
    """In which layouts [K, N, 4] some object stands 0.5 m or is turned 45 degrees apart from another layout: [K]."""
    moved = np.linalg.norm(layouts[..., :3] - other[:, :3], axis=-1) >= 0.5
    turned = np.abs(wrap_angle(layouts[..., 3] - other[:, 3])) >= np.pi / 4
    return np.any(moved | turned, axis=-1)
