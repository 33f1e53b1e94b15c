"""NLopt (Johnson). Its wheel on PyPI says MIT, which is its own code's licence; parts of the library are under LGPL.

Local algorithms with the engine's gradient (CCSAQ of Svanberg 2002, LBFGS, SLSQP, VAR2) begun anew from disturbed
starts, or global ones that see values alone (ISRES of Runarsson and Yao 2005, CRS2 of Kaelo and Ali 2006, DIRECT-L of
Gablonsky and Kelley 2001) over the box of the poses.

Fairness: as for `scipy_minimise`: the whole energy, any yaw, one layout a call; objectives as a penalty. It is a
dependency of the benchmarks alone. LBFGS and VAR2 are the parts under LGPL.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

from .flat import Flat, TimeUp
from .one_by_one import OneByOne


@dataclass(frozen=True)
class Nlopt(OneByOne):
    algorithm: str = "LD_CCSAQ"
    spread: float = 0.3  # [m] and [rad] standard deviation of a new beginning, of local algorithms
    weight: float = 30.0
    limit: float = 0.5

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "algorithm": ["LD_CCSAQ", "LD_LBFGS", "LD_SLSQP", "LD_VAR2", "GN_ISRES", "GN_CRS2_LM", "GN_DIRECT_L"],
        "spread": [0.05, 0.3, 1.0],
        "weight": [10.0, 30.0, 100.0],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray:
        import nlopt

        flat, rng = Flat(problem, given, until, self.objective, self.weight), np.random.default_rng(seed)
        nlopt.srand(seed + 1)

        def value(vector: np.ndarray, gradient: np.ndarray) -> float:
            energy, slope = flat(vector)
            if gradient.size:
                gradient[:] = slope
            return energy

        tool = nlopt.opt(getattr(nlopt, self.algorithm), len(flat.start))
        tool.set_min_objective(value)
        tool.set_lower_bounds(flat.low)
        tool.set_upper_bounds(np.maximum(flat.high, flat.low + 1e-6))
        tool.set_ftol_abs(1e-7)
        tool.set_xtol_rel(1e-6)
        begin, found = flat.start, []

        def run(vector: np.ndarray) -> np.ndarray:
            try:
                return tool.optimize(vector)
            except (TimeUp, nlopt.RoundoffLimited, RuntimeError):
                return vector  # it got as far as its time or its arithmetic goes; another beginning may get further

        while not until():
            run(begin)
            found.append(flat.best)
            if flat.nets:  # by the energy alone: a penalty ends beside what is valid
                flat.mending = True
                found.append(run(flat.best))
                flat.mending = False
            valid = problem.feasible(flat.poses(flat.best)[None].astype(np.float32))[0]
            if not flat.nets and (valid or flat.lowest < 1e-6):
                break
            begin = np.clip(flat.best + rng.normal(0.0, self.spread, begin.shape), flat.low, flat.high)
        return flat.poses(np.unique(found, axis=0)) if found else flat.poses(flat.best)
