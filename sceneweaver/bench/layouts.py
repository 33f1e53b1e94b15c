"""Candidates of a run, measured: which are valid, which is the best, how many differ."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.layout import Problem
from sceneweaver.layout.solution import differ

from .entries import Task

MOST_DISTINCT = 256  # valid layouts that are compared with one another: the first of them


@dataclass(frozen=True)
class Layouts:
    """Candidates of one problem, measured.

    Poses [B, N, 4], energy [B] (inf where it is no number), feasible [B]; objective [B] float64 (inf where not
    feasible), or None without one.
    """

    poses: np.ndarray
    energy: np.ndarray
    feasible: np.ndarray
    objective: np.ndarray | None = None

    @property
    def score(self) -> np.ndarray:
        """What tells valid layouts apart [B]: the lower the better."""
        return self.energy if self.objective is None else np.where(self.feasible, self.objective, self.energy)

    def better_of(self, other: Layouts | None) -> Layouts:
        """Of two layouts of each candidate the better: a feasible one, then that of lower objective or energy."""
        if other is None:
            return self
        mine = np.where(self.feasible == other.feasible, self.score <= other.score, self.feasible)
        objective = None
        if self.objective is not None and other.objective is not None:
            objective = np.where(mine, self.objective, other.objective)
        return Layouts(
            np.where(mine[:, None, None], self.poses, other.poses),
            np.where(mine, self.energy, other.energy),
            self.feasible | other.feasible,
            objective,
        )

    def best(self) -> int | None:
        """The best valid candidate; None: none is valid."""
        return int(np.where(self.feasible, self.score, np.inf).argmin()) if self.feasible.any() else None

    def columns(self) -> dict[str, Any]:
        """What goes into columns of `results.COLUMNS`."""
        finite, good = self.energy[np.isfinite(self.energy)], self.energy[self.feasible]
        best = self.best()
        return {
            "valid": float(self.feasible.mean()),
            "distinct": count_distinct(self.poses[self.feasible][:MOST_DISTINCT]),
            "best_energy": float(finite.min()) if finite.size else None,
            "best_valid_energy": float(good.min()) if good.size else None,
            "best_objective": None if best is None or self.objective is None else float(self.objective[best]),
            "median_energy": float(np.median(finite)) if finite.size else None,
        }


def measure(problem: Problem, poses: np.ndarray, task: Task) -> Layouts:
    """Measure poses [B, N, 4] of a task."""
    energy = np.asarray(problem.energy(poses), dtype=np.float64)
    energy[~np.isfinite(energy)] = np.inf
    feasible = np.asarray(problem.feasible(poses), dtype=bool) & np.isfinite(energy)
    objective = None
    if task.objective:
        objective = np.full(len(poses), np.inf)  # a thousand layouts of many nets take long: only what is asked for
        objective[feasible] = task.objective_of(poses[feasible])
    return Layouts(poses, energy, feasible, objective)


def count_distinct(layouts: np.ndarray) -> int:
    """Of how many layouts [K, N, 4], taken in turn, any two have an object 0.5 m or 45 degrees apart."""
    found = 0
    while len(layouts):
        layouts, found = layouts[differ(layouts, layouts[0])], found + 1
    return found
