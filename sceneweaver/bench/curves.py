"""Runs as functions of what they cost: anytime curves, costs to a target, intervals, profiles."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.scene import InputError

from .results import Run

COSTS = {"seconds": "seconds", "evaluations": "evaluations", "energy_calls": "energy calls"}
RESAMPLES = 1000
FLOOR = 1e-3  # [m] of energy: gaps below it are none


@dataclass(frozen=True)
class Target:
    """What a run has to reach.

    ``kind`` "valid": a share of at least ``value`` of the candidates is valid. "objective": the test of Moré and Wild
    2009, f(x) <= f_best + value (f(start) - f_best), f being the lowest energy of a valid layout; f(start) is that of
    any candidate at the start, and f_best the lowest that is known or that any method found.

    Examples:
        >>> from sceneweaver import bench
        >>> bench.Target.parse("valid:0.5")
        Target(kind='valid', value=0.5)
    """

    kind: str
    value: float

    @classmethod
    def parse(cls, text: str) -> Target:
        """From "valid:0.5" or "objective:0.1"."""
        kind, _, value = text.partition(":")
        try:
            found = cls(kind, float(value))
        except ValueError:
            raise InputError(f'target: "{text}" has no number; give valid:0.5 or objective:0.1') from None
        if kind not in ("valid", "objective") or not 0 < found.value <= 1:
            raise InputError(f'target: "{text}" is not valid:SHARE or objective:TOLERANCE, from 0 to 1')
        return found

    def __str__(self) -> str:
        words = "of candidates valid" if self.kind == "valid" else "of the way to the best objective left"
        return f"{self.value:.0%} {words}"


def instances(runs: Sequence[Run]) -> list[tuple[str, int]]:
    """Problems with their seeds, in order."""
    return sorted({run.key[1:] for run in runs})


def methods(runs: Sequence[Run]) -> list[str]:
    """Names of methods in the order of the results."""
    return list(dict.fromkeys(run.key[0] for run in runs))


def in_common(runs: Sequence[Run]) -> list[Run]:
    """The runs on problems and seeds that every method was run on."""
    names, ran = methods(runs), {run.key for run in runs}
    return [run for run in runs if all((name, *run.key[1:]) in ran for name in names)]


def best_found(runs: Sequence[Run]) -> dict[str, float]:
    """For each problem the lowest energy of a valid layout, known before or found by any run; inf: none."""
    found: dict[str, float] = {}
    for run in runs:
        values = [*run["best_valid_energy"], run.last("best_known")]
        found[run.key[1]] = np.nanmin([found.get(run.key[1], np.inf), *np.asarray(values, dtype=float)])
    return found


def value_at(run: Run, name: str, cost: str, points: np.ndarray) -> np.ndarray:
    """Values of a column at costs [K]: those of the last look before; NaN where there was none."""
    looks = np.searchsorted(run[cost], points, side="right") - 1
    values = np.asarray(run[name], dtype=float)
    return np.where(looks >= 0, values[np.maximum(looks, 0)], np.nan)


def gap_at(run: Run, cost: str, points: np.ndarray, best: dict[str, float]) -> np.ndarray:
    """How far the best valid layout is from the best that is known [m], at costs [K]; inf where none is valid."""
    gap = np.maximum(value_at(run, "best_valid_energy", cost, points) - best[run.key[1]], 0.0)
    return np.where(np.isnan(gap), np.inf, gap)


def left_at(run: Run, cost: str, points: np.ndarray, best: dict[str, float]) -> np.ndarray:
    """The share of the way from the start's lowest energy to the best known that is left, at costs [K], from 0 to 1.

    Candidates count here whether they are valid or not. NaN where no valid layout of the problem is known.
    """
    lowest, start = best[run.key[1]], float(run["best_energy"][0])
    if not np.isfinite(lowest) or not start > lowest:
        return np.full(len(points), np.nan)
    return np.clip((value_at(run, "best_energy", cost, points) - lowest) / (start - lowest), 0.0, 1.0)


def cost_to(run: Run, target: Target, cost: str, best: dict[str, float]) -> float:
    """The cost of the first look at which a target is reached; inf: never, or nobody counted."""
    if target.kind == "valid":
        there = run["valid"] >= target.value
    else:
        lowest, start = best[run.key[1]], float(run["best_energy"][0])
        limit = lowest + max(target.value * (start - lowest), FLOOR)
        there = np.asarray(run["best_valid_energy"], dtype=float) <= limit  # no NaN is
    counted = cost == "seconds" or run.last("steps") == 0 or run.last(cost) > 0  # else nobody counted that cost
    return float(run[cost][np.argmax(there)]) if there.any() and counted else np.inf


def table(runs: Sequence[Run], value: Callable[[Run], np.ndarray | float]) -> dict[str, np.ndarray]:
    """For each method an array [problem, seed, ...] of a value of its runs; NaN where there is no run."""
    problems, seeds = (sorted({run.key[k] for run in runs}) for k in (1, 2))  # pyright: ignore[reportArgumentType]
    shape = (len(problems), len(seeds), *np.shape(value(runs[0])))
    found = {method: np.full(shape, np.nan) for method in methods(runs)}
    for run in runs:
        found[run.key[0]][problems.index(run.key[1]), seeds.index(run.key[2])] = value(run)
    return found


def interval(values: np.ndarray, seed: int = 0) -> tuple[float, float]:
    """A 95 % interval of the mean of values [problem, seed] by the bootstrap of Efron 1979, percentiles of means.

    Problems are drawn first, then seeds of each, so what is said holds for other problems of the kind, not for other
    seeds alone.
    """
    values = values[~np.isnan(values).all(axis=1)]
    problems, seeds = values.shape
    if not problems:
        return np.nan, np.nan
    rng = np.random.default_rng(seed)
    rows = rng.integers(problems, size=(RESAMPLES, problems, 1))
    drawn = values[rows, rng.integers(seeds, size=(RESAMPLES, problems, seeds))]
    there = ~np.isnan(drawn)
    means = np.where(there, drawn, 0.0).sum(axis=(1, 2)) / np.maximum(there.sum(axis=(1, 2)), 1)
    low, high = np.percentile(means, (2.5, 97.5))
    return float(low), float(high)


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
