"""SciPy's local minimisers from the candidate's start, again and again from disturbed ones, and its dual annealing.

L-BFGS-B (Byrd, Lu, Nocedal and Zhu 1995), SLSQP (Kraft 1988) and TNC (Nash 1984) with the engine's gradient, each run
begun anew within ``spread`` of the best; `scipy.optimize.dual_annealing` (Xiang, Sun, Fan and Gong 1997) over the box
of the poses, with L-BFGS-B as its local search. SciPy is under BSD-3.

Fairness: both see the whole energy of the engine (bodies as they are, zones, doors, relations, any yaw) and its
gradient; not the verdict. Objectives come as a penalty: ``weight`` metres for a metre of energy. One layout a call:
what the engine does for a batch at a time it does here for one, which costs several times as much.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

from .flat import Flat, TimeUp
from .one_by_one import OneByOne


@dataclass(frozen=True)
class ScipyMinimise(OneByOne):
    method: str = "L-BFGS-B"
    spread: float = 0.3  # [m] and [rad] standard deviation of a new beginning
    weight: float = 30.0
    limit: float = 0.5

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "method": ["L-BFGS-B", "SLSQP", "TNC"],
        "spread": [0.05, 0.3, 1.0],
        "weight": [10.0, 30.0, 100.0],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray:
        from scipy.optimize import minimize

        flat, rng = Flat(problem, given, until, self.objective, self.weight), np.random.default_rng(seed)
        box, begin = np.stack([flat.low, flat.high], axis=1), flat.start
        found: list[np.ndarray] = []
        try:
            while True:
                minimize(flat, begin, jac=True, method=self.method, bounds=box)
                found.append(flat.best)
                if flat.nets:
                    found.append(self._mended(flat, box))
                layout = flat.poses(flat.best)[None].astype(np.float32)
                if not flat.nets and (flat.lowest < 1e-6 or problem.feasible(layout)[0]):
                    break
                begin = np.clip(flat.best + rng.normal(0.0, self.spread, begin.shape), flat.low, flat.high)
        except TimeUp:
            found.append(flat.best)
        return flat.poses(np.unique(found, axis=0))

    def _mended(self, flat: Flat, box: np.ndarray) -> np.ndarray:
        """From the best on by the energy alone: a penalty ends beside what is valid."""
        from scipy.optimize import minimize

        flat.mending = True
        mended = minimize(flat, flat.best, jac=True, method=self.method, bounds=box).x
        flat.mending = False
        return mended


@dataclass(frozen=True)
class DualAnnealing(OneByOne):
    temperature: float = 50.0  # at the start
    restart: float = 1e-4  # share of it at which it begins anew
    visit: float = 2.62
    weight: float = 30.0
    limit: float = 1.0

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "temperature": [5.0, 50.0, 5230.0],
        "restart": [2e-5, 1e-4, 1e-2],
        "visit": [1.5, 2.62],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray:
        from scipy.optimize import dual_annealing

        flat = Flat(problem, given, until, self.objective, self.weight)
        wide = np.maximum(flat.high, flat.low + 1e-6)
        local = {"method": "L-BFGS-B", "jac": lambda v: flat(v)[1], "bounds": list(zip(flat.low, wide, strict=True))}
        with contextlib.suppress(TimeUp):
            dual_annealing(
                flat.value,
                np.stack([flat.low, wide], axis=1),
                x0=flat.start,
                seed=seed,  # pyright: ignore[reportCallIssue]
                initial_temp=self.temperature,
                restart_temp_ratio=self.restart,
                visit=self.visit,
                minimizer_kwargs=local,
                maxiter=100_000,
                callback=lambda x, value, context: value < 1e-6 and not flat.nets,
            )
        return flat.poses(flat.best)
