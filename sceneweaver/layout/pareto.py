"""Pareto fronts: the valid layouts of a scene of which none is better by both of two objectives."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import InputError, Scene

from . import engine
from .compile import compile_scene
from .objective import ObjectiveTerm, check_objective
from .objective_values import objective_of
from .solution import Solution

STEP = 7919


@dataclass(frozen=True)
class ParetoFront:
    """Valid layouts of a scene of which none is at least as good by both objectives and better by one.

    Attributes:
        source: the scene.
        values: [K, 2] float64, the two objectives of each layout, the first ascending (and so the second descending).
        solution: the layouts as candidates of one solution, in the same order; None where there are none.
        found: [T, 2] the objectives of all valid layouts that were found.
        elapsed: seconds from call to return.
        timed_out: True when the time limit cut the run off.

    Examples:
        >>> import sceneweaver as sw
        >>> first, second = ([sw.ObjectiveTerm("flow", ("bed", to))] for to in ("wardrobe", "window"))
        >>> front = sw.pareto_front(
        ...     sw.Scene.example("bedroom"), first, second, weights=2, candidates=4, rounds=1, moves=200, device="cpu"
        ... )
        >>> sw.check(front.scene(0)).valid, (front.values[1:, 0] > front.values[:-1, 0]).all().item()
        (True, True)
    """

    source: Scene
    values: np.ndarray
    solution: Solution | None
    found: np.ndarray
    elapsed: float
    timed_out: bool = False

    @property
    def poses(self) -> np.ndarray:
        """World poses [K, N, 4] of the layouts."""
        if self.solution is None:
            return np.zeros((0, len(self.source.objects), 4), dtype=np.float32)
        return self.solution.poses

    def scene(self, k: int) -> Scene:
        """The scene in the k-th layout of the front."""
        if self.solution is None or not 0 <= k < len(self.values):
            raise InputError(f"k: {k!r} is none of the front's {len(self.values)} layouts")
        return self.solution.scene(k)

    def hypervolume(self, reference: Sequence[float] | np.ndarray) -> float:
        """The area that the front dominates below a point of reference, see `sceneweaver.hypervolume`."""
        return hypervolume(self.values, reference)


def non_dominated(values: np.ndarray) -> np.ndarray:
    """Indices of the points [B, 2] that no other dominates, the first coordinate ascending; of equals the first.

    Points with a NaN are none. Less is better.
    """
    points = np.asarray(values, dtype=np.float64)
    there = np.flatnonzero(np.isfinite(points).all(axis=1))
    order = there[np.lexsort((there, points[there, 1], points[there, 0]))]
    lowest = np.minimum.accumulate(points[order, 1])
    better = np.ones(len(order), dtype=bool)
    better[1:] = points[order[1:], 1] < lowest[:-1]
    return order[better]


def hypervolume(values: np.ndarray | Sequence[Sequence[float]], reference: Sequence[float] | np.ndarray) -> float:
    """The area of all points that some of ``values`` [B, 2] dominates and that dominate ``reference`` [2].

    It is exact: a sum of rectangles (Zitzler and Thiele 1998). Points that do not dominate the reference add nothing.

    Raises:
        InputError: other shapes, or a reference that is not finite.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.hypervolume([[0.0, 1.0], [1.0, 0.0], [1.0, 1.0]], (2.0, 2.0))
        3.0
    """
    points, corner = np.asarray(values, dtype=np.float64), np.asarray(reference, dtype=np.float64)
    if corner.shape != (2,) or not np.isfinite(corner).all():
        raise InputError(f"reference: {reference!r} is not two finite numbers")
    if points.size == 0:
        return 0.0
    if points.ndim != 2 or points.shape[1] != 2:
        raise InputError(f"values: an array of shape {points.shape} is not [B, 2]")
    points = points[(points < corner).all(axis=1)]
    front = points[non_dominated(points)]
    if not len(front):
        return 0.0
    right = np.append(front[1:, 0], corner[0])
    return float(np.sum((right - front[:, 0]) * (corner[1] - front[:, 1])))


def pareto_front(
    scene: Scene,
    first: Sequence[ObjectiveTerm],
    second: Sequence[ObjectiveTerm],
    *,
    weights: int = 8,
    candidates: int = 16,
    rounds: int = 3,
    seed: int = 0,
    device: str = "auto",
    time_limit: float | None = None,
    steps: int | None = None,
    moves: int | None = None,
) -> ParetoFront:
    """The valid layouts of a scene that are best by two objectives, none better than another by both.

    In the first round each objective is minimised alone, which tells their ranges; then weighted sums of the two,
    scaled by these, evenly from one to the other, in shared launches. Every further round looks at the widest gaps of
    the front: it starts from the layouts on both sides of a gap and minimises the weighted sum whose level lines run
    along it (adaptive weighted sums, after Kim and de Weck 2005). Where the front is straight or bends inwards no sum
    has its least value inside a gap; so layouts between the two sides, some objects as on one, others as on the other
    or on the way, are mended and count as they are. All valid layouts that any of these found count.

    Args:
        scene: what to lay out.
        first, second: terms of either objective, less is better.
        weights: sums of a round, at least 2.
        candidates: layouts for each sum.
        rounds: how many, the first included.
        seed: equal seeds give equal results unless time runs out.
        device: "auto", "cpu", "cuda" or "cuda:k".
        time_limit: seconds for all.
        steps, moves: as in `sceneweaver.refine`.

    Returns:
        The front; one without layouts where no valid one was found.

    Raises:
        InputError: an argument is out of range, or a term names what the scene does not have.

    Examples:
        >>> import sceneweaver as sw
        >>> near = [sw.ObjectiveTerm("flow", ("bed", "wardrobe"))]
        >>> light = [sw.ObjectiveTerm("flow", ("bed", "window"))]
        >>> front = sw.pareto_front(
        ...     sw.Scene.example("bedroom"), near, light, weights=2, candidates=4, rounds=1, device="cpu"
        ... )
        >>> front.values.shape[1], front.hypervolume((10.0, 10.0)) > 0.0
        (2, True)
    """
    began = time.monotonic()
    aims = (tuple(first), tuple(second))
    for name, terms in zip(("first", "second"), aims, strict=True):
        if not terms:
            raise InputError(f"{name}: give at least one ObjectiveTerm")
        check_objective(scene, terms)
    for name, value, least in (("weights", weights, 2), ("candidates", candidates, 1), ("rounds", rounds, 1)):
        if not isinstance(value, int | np.integer) or isinstance(value, bool) or value < least:
            raise InputError(f"{name}: {value!r} is not a whole number of at least {least}")
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit!r} is not a positive number of seconds")
    archive = _Archive(scene, aims)
    how = {"device": device, "steps": steps, "moves": moves}

    def left() -> float | None:
        """Seconds that remain."""
        return None if time_limit is None else max(time_limit - (time.monotonic() - began), 0.05)

    def over() -> bool:
        """Whether time is up."""
        return time_limit is not None and time.monotonic() - began >= time_limit

    share = None if time_limit is None else time_limit / (2 * rounds)  # so that a late round gets its time as well
    archive.add(_from_nothing(scene, aims, [(1.0, 0.0), (0.0, 1.0)], candidates, seed, share, how))
    pairs = [(1.0 - k / (weights - 1), k / (weights - 1)) for k in range(1, weights - 1)]
    if pairs and not over():
        a, b = archive.scale()
        archive.add(_from_nothing(scene, aims, [(u / a, v / b) for u, v in pairs], candidates, seed + 2, share, how))
    compiled = compile_scene(scene) if rounds > 1 else None
    for number in range(1, rounds):
        gaps = archive.gaps(weights)
        rng = np.random.default_rng([seed, number])
        blends = [_blends(starts, candidates, rng) for starts, _ in gaps if len(starts) == 2]
        if blends and not over():
            budget = left()
            archive.add(
                [
                    engine.refine(
                        scene,
                        candidates=candidates * len(blends),
                        init=np.concatenate(blends),
                        seed=(seed + STEP * number * weights - 1) % 2**32,
                        time_limit=None if budget is None else budget / 2 / (rounds - number),
                        device=device,
                        steps=steps,
                        compiled=compiled,
                        walk=False,
                    )
                ]
            )
        for k, (starts, pair) in enumerate(gaps):
            if over():
                break
            budget = left()
            archive.add(
                [
                    engine.refine(
                        scene,
                        candidates=candidates,
                        init=np.resize(starts, (candidates, *starts.shape[1:])),
                        seed=(seed + STEP * (number * weights + k)) % 2**32,
                        time_limit=None if budget is None else budget / (len(gaps) - k) / (rounds - number),
                        objective=_weighted(aims, pair),
                        compiled=compiled,
                        walk=False,
                        **how,
                    )
                ]
            )
    return archive.front(began, over())


def _weighted(aims: tuple[tuple[ObjectiveTerm, ...], ...], pair: tuple[float, float]) -> list[ObjectiveTerm]:
    """The terms of a weighted sum of two objectives."""
    return [
        replace(term, weight=term.weight * weight) for terms, weight in zip(aims, pair, strict=True) for term in terms
        if weight > 0.0
    ]  # fmt: skip


def _blends(ends: np.ndarray, count: int, rng: np.random.Generator) -> np.ndarray:
    """Layouts [count, N, 4] between two [2, N, 4]: all on the way by one share, or each object as at either end."""
    share = np.repeat((np.arange(count) + 0.5)[:, None, None] / count, ends.shape[1], axis=1)
    mixed = np.arange(count) % 2 == 1
    share[mixed] = rng.random(share[mixed].shape) < share[mixed]
    way = ends[1].astype(np.float64) - ends[0]
    way[:, 3] = wrap_angle(way[:, 3])
    return ends[0] + share * way


def _from_nothing(
    scene: Scene,
    aims: tuple[tuple[ObjectiveTerm, ...], ...],
    pairs: Sequence[tuple[float, float]],
    candidates: int,
    seed: int,
    time_limit: float | None,
    how: dict,
) -> list[Solution]:
    """Weighted sums minimised from layouts drawn anew, all in shared launches."""
    return engine.refine_many(
        [scene] * len(pairs),
        candidates=candidates,
        seed=[(seed + STEP * k) % 2**32 for k in range(len(pairs))],
        objective=[_weighted(aims, pair) for pair in pairs],
        time_limit=time_limit,
        **how,
    )


class _Archive:
    """All valid layouts found so far, with their two values."""

    def __init__(self, scene: Scene, aims: tuple[tuple[ObjectiveTerm, ...], ...]) -> None:
        self._scene, self._aims = scene, aims
        self._solutions: list[Solution] = []
        self._where: list[tuple[int, int]] = []
        self._values = np.zeros((0, 2))

    def add(self, solutions: Sequence[Solution]) -> None:
        """Take in the valid candidates of solutions."""
        for solution in solutions:
            valid = np.flatnonzero(solution.status == 0)
            if not len(valid):
                continue
            poses = solution.poses[valid].astype(np.float64)
            values = np.stack([objective_of(self._scene, terms, poses) for terms in self._aims], axis=1)
            self._where += [(len(self._solutions), int(k)) for k in valid]
            self._values = np.concatenate([self._values, values])
            self._solutions.append(solution)

    def scale(self) -> tuple[float, float]:
        """How far the front reaches along either objective; 1 where it does not."""
        front = self._values[non_dominated(self._values)]
        reach = np.ptp(front, axis=0) if len(front) else np.zeros(2)
        return tuple(float(r) if r > 1e-9 else 1.0 for r in reach)  # pyright: ignore[reportReturnType]

    def gaps(self, count: int) -> list[tuple[np.ndarray, tuple[float, float]]]:
        """The widest gaps of the front: the layouts [2, N, 4] on both sides, and the weights that run along it.

        A front of one point is looked at from that point, by both objectives alike.
        """
        front = non_dominated(self._values)
        if not len(front):
            return []
        a, b = self.scale()
        if len(front) == 1:
            return [(self._bodies(front), (1.0 / a, 1.0 / b))]
        step = np.abs(np.diff(self._values[front], axis=0))
        width = np.hypot(step[:, 0] / a, step[:, 1] / b)
        widest = sorted(np.argsort(-width, kind="stable")[:count].tolist())
        found = []
        for k in widest:
            across = math.hypot(step[k, 0] / a, step[k, 1] / b)
            pair = (float(step[k, 1] / b / across / a), float(step[k, 0] / a / across / b))
            found.append((self._bodies(front[k : k + 2]), pair))
        return found

    def _bodies(self, rows: np.ndarray) -> np.ndarray:
        """The poses of all bodies of some layouts."""
        return np.stack([self._solutions[s].bodies[k] for s, k in (self._where[int(row)] for row in rows)])

    def front(self, began: float, timed_out: bool) -> ParetoFront:
        """The front of all that was found."""
        rows = non_dominated(self._values)
        chosen = [self._where[int(row)] for row in rows]
        solution = None
        if chosen:
            names = ("poses", "status", "relations", "energy", "walkable")
            names += () if self._solutions[0].free_floor is None else ("free_floor",)
            arrays = {n: np.stack([getattr(self._solutions[s], n)[k] for s, k in chosen]) for n in names}
            solution = replace(self._solutions[0], **arrays, objective=None, moved=None)
        return ParetoFront(
            source=self._scene,
            values=self._values[rows],
            solution=solution,
            found=self._values,
            elapsed=time.monotonic() - began,
            timed_out=timed_out,
        )
