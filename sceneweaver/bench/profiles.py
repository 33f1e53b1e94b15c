"""Performance profiles (Dolan and Moré 2002) and data profiles (Moré and Wild 2009)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .curves import Target, best_found, cost_to, instances, methods
from .results import Run


@dataclass(frozen=True)
class Profile:
    """Shares of instances that each method has solved within a cost.

    Attributes:
        at: costs [K]: multiples of the cheapest method's, or costs for each variable and one more.
        shares: [method, K].
        methods: names.

    Examples:
        >>> import numpy as np
        >>> from sceneweaver import bench
        >>> profile = bench.Profile(np.array([1.0, 2.0]), np.array([[0.5, 1.0]]), ("adam",))
        >>> dict(zip(profile.methods, profile.shares[:, -1].tolist()))
        {'adam': 1.0}
    """

    at: np.ndarray
    shares: np.ndarray
    methods: tuple[str, ...]


def costs(runs: Sequence[Run], target: Target, cost: str) -> np.ndarray:
    """Costs [method, instance] to reach a target; inf: never, or no such run. An instance is a problem and a seed."""
    best, rows, columns = best_found(runs), methods(runs), instances(runs)
    found = np.full((len(rows), len(columns)), np.inf)
    for run in runs:
        found[rows.index(run.key[0]), columns.index(run.key[1:])] = cost_to(run, target, cost, best)
    return found


def performance_profile(runs: Sequence[Run], target: Target, cost: str = "seconds", most: float = 1e4) -> Profile:
    """The share of instances that a method solves within a multiple of what the cheapest method needs.

    An instance that no method solves counts as unsolved by all. Costs are those of looks at a run, so ratios below that
    of two looks (about 1.6) say little; a cost of 0 (solved at the start) counts as the smallest above 0.

    Args:
        runs: of several methods on the same problems and seeds.
        target: what solved means.
        cost: "seconds", "evaluations" or "energy_calls".
        most: the largest multiple.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> profile = bench.performance_profile(bench.read_runs(path), bench.Target("valid", 0.5))
        >>> profile.shares.shape
        (2, 200)
    """
    needed = costs(runs, target, cost)
    least = needed[np.isfinite(needed) & (needed > 0)].min(initial=np.inf)
    needed = np.maximum(needed, least)
    cheapest = needed.min(axis=0)
    with np.errstate(invalid="ignore"):
        ratios = np.where(np.isfinite(needed), needed / cheapest, np.inf)
    return _shares(ratios, np.geomspace(1.0, most, 200), methods(runs))


def data_profile(runs: Sequence[Run], target: Target, cost: str = "evaluations") -> Profile:
    """The share of instances that a method solves within a cost for each free coordinate of the problem and one more.

    In evaluations that unit is what a gradient by differences takes of one candidate.

    Args:
        runs: of several methods on the same problems and seeds.
        target: what solved means.
        cost: "seconds", "evaluations" or "energy_calls".

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import bench
        >>> settings = bench.Settings(candidates=4, seconds=0.05, device="cpu")
        >>> path = bench.run(["adam", "langevin"], [sw.Scene.example("bedroom")], "results", seeds=1, settings=settings)
        >>> profile = bench.data_profile(bench.read_runs(path), bench.Target("objective", 0.5))
        >>> profile.methods
        ('adam', 'langevin')
    """
    sizes = {run.key[1:]: float(np.max(run["variables"])) + 1.0 for run in runs}
    each = costs(runs, target, cost) / np.array([sizes[instance] for instance in instances(runs)])
    finite = each[np.isfinite(each) & (each > 0)]
    at = np.geomspace(finite.min(), finite.max(), 200) if finite.size else np.ones(1)
    return _shares(each, at, methods(runs))


def _shares(values: np.ndarray, at: np.ndarray, names: Sequence[str]) -> Profile:
    return Profile(at, (values[:, :, None] <= at * (1 + 1e-9)).mean(axis=1), tuple(names))
