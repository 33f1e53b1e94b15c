"""A compiled scene that is kept while the scene is edited, to move a few of its objects as little as is needed."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.rotations import is_upright
from sceneweaver.geometry.se2 import absolute, relative
from sceneweaver.kernels import load
from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.optimizers import Batch, Monitor, streams
from sceneweaver.optimizers.projection import nearest_feasible
from sceneweaver.scene import Pose, Scene

from .batch import make_batch
from .compile import CompiledScene, compile_scene, poses_of
from .devices import pick_devices
from .engine import mend_surfaces
from .free_floor import area_poses, stand_ins
from .job import Job

MODULES = ("bookkeeping", "linearise", "projection", "verdict")
CANDIDATES = 4  # the first begins at the given poses; the others differ from the second try on
STARTS = 48  # places over the floor


class LiveLayout:
    """The layout problem of a scene under edits.

    What compiling makes does not depend on the poses of upright objects, so an edit that only moves things leaves the
    compiled scene and its tables on the device as they are.
    """

    def __init__(self, device: str = "auto") -> None:
        self.device = pick_devices(device)[0]
        self._compiled: CompiledScene | None = None
        self._batches: dict[int, Batch] = {}
        load(self.device, *MODULES)

    def compiled(self, scene: Scene) -> CompiledScene:
        """The scene compiled, or what is kept of the last one with new poses."""
        kept = self._compiled
        if kept is None or not _differ_in_poses_alone(kept.scene, scene):
            self._batches = {}
            kept = compile_scene(scene)
        else:
            home, faulty = poses_of(scene)
            extra = stand_ins(scene, home)
            home = np.concatenate([home, np.array(extra.home, dtype=np.float64).reshape(-1, 4)])
            room = replace(kept.room, home=home, faulty=faulty)
            room.packed = kept.room.packed
            kept = CompiledScene(scene, room, kept.domains, extra)
        self._compiled = kept
        return kept

    def settle(
        self, scene: Scene, free: Collection[str], *, surfaces: bool = False, tries: int = 4, seed: int = 0
    ) -> np.ndarray | None:
        """The feasible poses nearest to those of a scene, of some objects alone.

        Args:
            scene: where things are.
            free: ids of what may move, with all that stands on it; fixed objects may not.
            surfaces: whether what stands on surfaces is put in order first, on each for itself.
            tries: how often to begin, the first time from where things are.
            seed: of the later tries.

        Returns:
            Poses [N, 4], or None where no feasible layout was found. The judge has the last word on them. Those of
            the free areas that have a pose of their own follow them, see `area_poses`.
        """
        compiled = self.compiled(scene)
        world = compiled.room.home[None]
        if surfaces and compiled.domains:
            job = Job(compiled, world, "given", seed)
            mend_surfaces(job, "projection", self.device, Monitor(len(job.world)))
            world = job.world
        poses, lack, moved = self._nearest(compiled, np.repeat(world, CANDIDATES, axis=0), free, tries, seed)
        best = int(np.lexsort((moved, lack))[0])
        return None if lack[best] > 0 else poses[best]

    def place(self, scene: Scene, free: Collection[str], *, count: int = STARTS, seed: int = 0) -> np.ndarray | None:
        """Feasible poses with some objects anywhere in the room, as near as possible to where they are.

        Args:
            scene: where things are.
            free: ids of what may go anywhere, with all that stands on it; all else is held.
            count: places to begin at, drawn over the floor, with the objects turned by quarters.
            seed: of these places.

        Returns:
            Poses [N, 4], or None where no feasible layout was found, or where what is free stands on something.
        """
        compiled = self.compiled(scene)
        room = compiled.room
        roots = sorted({scene.index(name) for name in free})
        if any(room.roots[i] != i for i in roots):
            return None
        rng = np.random.default_rng(seed)
        x0, y0, x1, y1 = room.region.box
        start = np.repeat(room.home[None], count, axis=0)
        for i in roots:
            members = np.flatnonzero(room.roots == i)
            stack = relative(start[:, members], start[:, None, i])
            there = start[:, i].copy()
            there[:, :2] = rng.uniform((x0, y0), (x1, y1), (count, 2))
            there[:, 3] += rng.integers(4, size=count) * (np.pi / 2)
            start[:, members] = absolute(stack, there[:, None])
        poses, lack, _ = self._nearest(compiled, start, free, 1, seed)
        d = poses[:, roots] - room.home[roots]
        far = np.linalg.norm(d[..., :3], axis=-1) + 0.5 * np.abs(wrap_angle(d[..., 3]))
        best = int(np.lexsort((far.sum(axis=1), lack))[0])
        return None if lack[best] > 0 else poses[best]

    def area_poses(self, scene: Scene, poses: np.ndarray) -> dict[str, Pose]:
        """Where the free areas of a scene lie, by id, in poses that `settle` or `place` found for it."""
        return area_poses(scene, self.compiled(scene).stand_ins.area, poses[len(scene.objects) :])

    def _nearest(
        self, compiled: CompiledScene, start: np.ndarray, free: Collection[str], tries: int, seed: int
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Layouts [B, N, 4] projected with some objects free: poses, what each misses [m], its squared movement."""
        room, count = compiled.room, len(start)
        if count not in self._batches:
            self._batches[count] = make_batch([room], np.zeros(count, dtype=np.int32), self.device)
        batch = self._batches[count]
        roots = {int(room.roots[compiled.scene.index(name)]) for name in free}
        mask = np.isin(np.arange(room.size), sorted(roots)) | (np.arange(room.size) >= len(compiled.scene.objects))
        batch.keep.object_free.assign(np.where(mask, room.free, 0).astype(np.int32))  # else the tables are kept
        for array in (batch.state.poses, batch.state.anchors):
            array.assign(start.astype(np.float32))
        wp.launch(set_turns, start.shape[:2], [batch.state.poses], [batch.state.turns], device=self.device)
        batch.state.rng.assign(streams(seed, np.arange(count)))
        lack, moved = nearest_feasible(batch, tries)
        batch.keep.object_free.assign(room.free.astype(np.int32))  # others share the tables
        return np.array(batch.state.poses.numpy(), dtype=np.float64), lack, moved


def _differ_in_poses_alone(one: Scene, other: Scene) -> bool:
    """Whether two scenes are the same but for where upright objects stand, seen without a deep comparison.

    Edits share what they do not change, so parts that are not the very same count as different.
    """
    if not _same_areas(one, other):
        return False
    if one.room is not other.room or one.relations is not other.relations or len(one.objects) != len(other.objects):
        return False
    for a, b in zip(one.objects, other.objects, strict=True):
        if a is b:
            continue
        shared = all(getattr(a, name) is getattr(b, name) for name in type(a).model_fields if name != "pose")
        if not shared or not (is_upright(a.pose.quaternion) and is_upright(b.pose.quaternion)):
            return False
    return True


def _same_areas(one: Scene, other: Scene) -> bool:
    """Whether two scenes keep the same floor free, wherever it lies."""
    if one.free_areas is other.free_areas:
        return True
    if len(one.free_areas) != len(other.free_areas):
        return False
    pairs = zip(one.free_areas, other.free_areas, strict=True)
    return all(a.model_copy(update={"pose": b.pose}) == b for a, b in pairs)
