"""A compiled scene that is kept while the scene is edited, to move a few of its objects as little as is needed."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.geometry.rotations import is_upright
from sceneweaver.kernels import load
from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.optimizers import Batch, streams
from sceneweaver.optimizers.projection import nearest_feasible
from sceneweaver.scene import Scene

from .batch import make_batch
from .compile import CompiledScene, compile_scene, poses_of
from .devices import pick_devices
from .engine import mend_surfaces
from .job import Job

MODULES = ("bookkeeping", "linearise", "projection", "verdict")
CANDIDATES = 4  # the first begins at the given poses; the others differ from the second try on


class LiveLayout:
    """The layout problem of a scene under edits.

    What compiling makes does not depend on the poses of upright objects, so an edit that only moves things leaves the
    compiled scene and its tables on the device as they are.
    """

    def __init__(self, device: str = "auto") -> None:
        self.device = pick_devices(device)[0]
        self._compiled: CompiledScene | None = None
        self._batch: Batch | None = None
        load(self.device, *MODULES)

    def compiled(self, scene: Scene) -> CompiledScene:
        """The scene compiled, or what is kept of the last one with new poses."""
        kept = self._compiled
        if kept is None or not _differ_in_poses_alone(kept.scene, scene):
            self._batch = None
            kept = compile_scene(scene)
        else:
            home, faulty = poses_of(scene)
            room = replace(kept.room, home=home, faulty=faulty)
            room.packed = kept.room.packed
            kept = CompiledScene(scene, room, kept.domains)
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
            Poses [N, 4], or None where no feasible layout was found. The judge has the last word on them.
        """
        compiled = self.compiled(scene)
        room = compiled.room
        world = room.home[None]
        if surfaces and compiled.domains:
            job = Job(compiled, world, "given", seed)
            mend_surfaces(job, "projection", self.device, None)
            world = job.world
        batch = self._batch
        if batch is None:
            batch = self._batch = make_batch([room], np.zeros(CANDIDATES, dtype=np.int32), self.device)
        indices = {compiled.scene.index(object_id) for object_id in free}
        mask = np.isin(np.arange(room.size), sorted({int(room.roots[i]) for i in indices}))
        batch.keep.object_free.assign(np.where(mask, room.free, 0).astype(np.int32))  # else the tables are kept
        start = np.repeat(world, CANDIDATES, axis=0).astype(np.float32)
        for array in (batch.state.poses, batch.state.anchors):
            array.assign(start)
        wp.launch(set_turns, start.shape[:2], [batch.state.poses], [batch.state.turns], device=self.device)
        batch.state.rng.assign(streams(seed, np.arange(CANDIDATES)))
        lack, moved = nearest_feasible(batch, tries)
        batch.keep.object_free.assign(room.free.astype(np.int32))  # others share the tables
        best = int(np.lexsort((moved, lack))[0])
        return None if lack[best] > 0 else np.asarray(batch.state.poses.numpy()[best], dtype=np.float64)


def _differ_in_poses_alone(one: Scene, other: Scene) -> bool:
    """Whether two scenes are the same but for where upright objects stand, seen without a deep comparison.

    Edits share what they do not change, so parts that are not the very same count as different.
    """
    if one.room is not other.room or one.relations is not other.relations or len(one.objects) != len(other.objects):
        return False
    for a, b in zip(one.objects, other.objects, strict=True):
        if a is b:
            continue
        shared = all(getattr(a, name) is getattr(b, name) for name in type(a).model_fields if name != "pose")
        if not shared or not (is_upright(a.pose.quaternion) and is_upright(b.pose.quaternion)):
            return False
    return True
