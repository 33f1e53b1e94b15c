"""What is measured of a run when it is looked at."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.layout import Problem, StepOptimizer
from sceneweaver.layout.arrays import poses_from
from sceneweaver.layout.solution import differ

MOST_DISTINCT = 256  # valid layouts that are compared with one another: the first of them


@dataclass(frozen=True)
class Layouts:
    """Candidates of one problem, measured: poses [B, N, 4], energy [B] (inf where it is no number), feasible [B]."""

    poses: np.ndarray
    energy: np.ndarray
    feasible: np.ndarray

    def better_of(self, other: Layouts | None) -> Layouts:
        """Of two layouts of each candidate the better: a feasible one, then that of lower energy."""
        if other is None:
            return self
        mine = np.where(self.feasible == other.feasible, self.energy <= other.energy, self.feasible)
        return Layouts(
            np.where(mine[:, None, None], self.poses, other.poses),
            np.where(mine, self.energy, other.energy),
            self.feasible | other.feasible,
        )

    def columns(self) -> dict[str, Any]:
        """What goes into columns of `schema.COLUMNS`."""
        finite, good = self.energy[np.isfinite(self.energy)], self.energy[self.feasible]
        return {
            "valid": float(self.feasible.mean()),
            "distinct": count_distinct(self.poses[self.feasible][:MOST_DISTINCT]),
            "best_energy": float(finite.min()) if finite.size else None,
            "best_valid_energy": float(good.min()) if good.size else None,
            "median_energy": float(np.median(finite)) if finite.size else None,
        }


def measure(problem: Problem, poses: np.ndarray) -> Layouts:
    """Measure poses [B, N, 4] of one scene."""
    energy = np.asarray(problem.energy(poses), dtype=np.float64)
    energy[~np.isfinite(energy)] = np.inf
    return Layouts(poses, energy, np.asarray(problem.feasible(poses), dtype=bool) & np.isfinite(energy))


def look(optimizer: StepOptimizer, state: Any, problem: Problem, given: np.ndarray) -> Layouts:
    """An optimiser's best, as `sceneweaver.refine` takes it: free coordinates, and what is carried goes along.

    ``given`` [B, N, 4] is where it began.
    """
    best = np.asarray(poses_from(optimizer.best(state), problem.objects, problem.device).numpy())
    if best.shape != given.shape:
        raise ValueError(f"best gave an array of shape {best.shape}; poses are {given.shape}")
    return measure(problem, problem.carry(np.where(problem.free[0], best, given), like=given))


def count_distinct(layouts: np.ndarray) -> int:
    """Of how many layouts [K, N, 4], taken in turn, any two have an object 0.5 m or 45 degrees apart."""
    found = 0
    while len(layouts):
        layouts, found = layouts[differ(layouts, layouts[0])], found + 1
    return found
