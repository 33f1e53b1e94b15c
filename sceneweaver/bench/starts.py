"""Where runs of a task start: the same layouts for every method."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sceneweaver.layout import refine

from .entries import Task
from .settings import Settings

ROUND = 1_000_003  # between the seeds of a run's rounds


@dataclass
class Starts:
    """Starts of one task by seed and round.

    What stands on surfaces is solved beforehand, with as little change as that takes: an optimiser moves roots alone,
    and no layout could become valid. That is done once a seed; later rounds carry what the first one had. The first
    round of the last seed is kept, as all methods begin there.
    """

    task: Task
    settings: Settings
    _solved: dict[int, np.ndarray] = field(default_factory=dict)
    _first: dict[int, np.ndarray] = field(default_factory=dict)

    def draw(self, seed: int, attempt: int = 0) -> tuple[np.ndarray, int]:
        """Poses [B, N, 4] of a round, and its seed."""
        own = (seed + attempt * ROUND) % 2**32
        if attempt:
            return self._drawn(seed, attempt, own), own
        if seed not in self._first:
            self._first = {seed: self._drawn(seed, 0, own)}
        return self._first[seed].copy(), own

    def _drawn(self, seed: int, attempt: int, own: int) -> np.ndarray:
        task, settings = self.task, self.settings
        drawn = np.asarray(task.start(settings.start, settings.candidates, own), dtype=np.float32)
        problem = task.compile(settings.device)
        if not problem.surfaces:
            return drawn
        if seed not in self._solved:
            first = drawn if attempt == 0 else self.draw(seed)[0]
            kept = refine(task.scene, init=first, optimizer=_Keep(), seed=seed, device=settings.device, walk=False)
            self._solved[seed] = kept.poses.astype(np.float32)
        return problem.carry(drawn, like=self._solved[seed])


class _Keep:
    """Leaves everything where it is; `refine` has solved surfaces before it begins."""

    steps = 1

    def init(self, problem: Any, poses: Any, key: int) -> Any:
        return poses

    def step(self, state: Any) -> Any:
        return state

    def best(self, state: Any) -> Any:
        return state
