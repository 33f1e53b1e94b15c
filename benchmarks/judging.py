"""The judge, ``sceneweaver.verify.check``, over a pool of processes. It never sees the engine."""

from __future__ import annotations

import multiprocessing
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import lru_cache
from typing import NamedTuple, Self

import numpy as np

from sceneweaver.scene import Pose, Scene
from sceneweaver.verify import check

CHUNK = 64


class Opinion(NamedTuple):
    """What the judge says about one layout.

    ``solid``: nothing collides or leaves the room. ``reason``: the first thing that makes it invalid, else empty.
    """

    valid: bool
    solid: bool
    hard: tuple[int, int]
    soft: tuple[int, int]
    walkable: float | None
    reason: str


def place(scene: Scene, poses: np.ndarray) -> Scene:
    """The scene with poses [N, 4], as ``Solution.scene`` has it: fixed objects stay where they are."""
    moved = {
        o.id: Pose.from_yaw(*(float(v) for v in pose))
        for o, pose in zip(scene.objects, poses, strict=True)
        if not o.fixed
    }
    return scene.replace_poses(moved)


def opinion(scene: Scene, walkable: bool = False) -> Opinion:
    """Judge one scene."""
    report = check(scene, walkable=walkable)
    wrong = [v for v in report.violations if v.hard]
    hard, soft = report.relations.hard, report.relations.soft
    return Opinion(
        valid=report.valid,
        solid=report.collisions == 0 and report.out_of_bounds == 0,
        hard=(hard.satisfied, hard.total),
        soft=(soft.satisfied, soft.total),
        walkable=report.walkable_share,
        reason=f"{wrong[0].kind}: {wrong[0].detail}" if wrong else "",
    )


@lru_cache(maxsize=4)
def _scene(text: str) -> Scene:
    return Scene.loads(text)


def _work(text: str, poses: np.ndarray, walkable: bool) -> list[Opinion]:
    scene = _scene(text)
    return [opinion(place(scene, p), walkable) for p in poses]


class Judge:
    """Judges layouts in ``jobs`` processes, made when first needed; a context manager that ends them."""

    def __init__(self, jobs: int = 1) -> None:
        self.jobs = jobs
        self._pool: ProcessPoolExecutor | None = None

    def __call__(self, scene: Scene, poses: np.ndarray, *, walkable: bool = False) -> list[Opinion]:
        """Opinions on layouts [B, N, 4], in their order."""
        if self.jobs < 2 or len(poses) < 2:
            return [opinion(place(scene, p), walkable) for p in poses]
        if self._pool is None:  # spawned: a fork would take along Warp's threads and the GPU
            self._pool = ProcessPoolExecutor(self.jobs, mp_context=multiprocessing.get_context("spawn"))
        text = scene.dumps()
        size = max(1, min(CHUNK, -(-len(poses) // (2 * self.jobs))))
        chunks = [poses[i : i + size] for i in range(0, len(poses), size)]
        work = self._pool.map(_work, [text] * len(chunks), chunks, [walkable] * len(chunks))
        return [o for part in work for o in part]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)
            self._pool = None


def share(held: Sequence[tuple[int, int]]) -> float | None:
    """Share of relations that hold, over all layouts; None when there are none."""
    total = sum(t for _, t in held)
    return sum(h for h, _ in held) / total if total else None
