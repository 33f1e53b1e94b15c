"""Optimise lengths of a scene together with its layout, a population of scenes at a time."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.scene import InputError, Scene
from sceneweaver.scene.display import Shown

from . import engine
from .cross_entropy import CrossEntropy
from .objective import ObjectiveTerm, check_objective
from .objective_values import objective_of
from .solution import Solution
from .variables import Variable, check_variables, with_values

STEP = 7919
Objective = Sequence[ObjectiveTerm] | Callable[[Scene], float]


@dataclass(frozen=True)
class VariableSolution(Shown):
    """Values of variables, with a layout in which they are valid.

    Attributes:
        variables: what was chosen.
        values: [V] float64 [m], in the order of the variables and inside their bounds.
        scene: the scene at these values in its best layout, valid where ``valid`` is true.
        solution: all candidates of that scene; None where no values gave a scene.
        objective: what the values are worth: costs of variables and the objective; NaN where nothing is valid.
        valid: whether the engine, and so `sceneweaver.check`, calls the scene valid.
        explanation: what stands in the way where nothing is valid; else None.
        tried: [T, V] values that were tried, generation after generation.
        worth: [T] what each was worth, NaN where no candidate was valid.
        best: [G] the lowest worth after each generation.
        elapsed: seconds from call to return.
        timed_out: True when the time limit cut the run off.

    Examples:
        >>> import sceneweaver as sw
        >>> bed = sw.Variable("size", "bed", "width", 1.4, 1.8, cost=-1.0)
        >>> found = sw.optimize_variables(
        ...     sw.Scene.example("bedroom"), [bed], population=4, candidates=4, generations=1, device="cpu"
        ... )
        >>> found.tried.shape, found.worth.shape, found.valid == (found.explanation is None)
        ((4, 1), (4,), True)
    """

    variables: tuple[Variable, ...]
    values: np.ndarray
    scene: Scene
    solution: Solution | None
    objective: float
    valid: bool
    explanation: str | None
    tried: np.ndarray
    worth: np.ndarray
    best: np.ndarray
    elapsed: float
    timed_out: bool = False


@dataclass(frozen=True)
class _Member:
    """One scene of a population: its key (not valid, then worth or what is amiss; the less the better)."""

    values: np.ndarray
    key: tuple[int, float]
    solution: Solution | None
    candidate: int = 0


def optimize_variables(
    scene: Scene,
    variables: Sequence[Variable],
    *,
    objective: Objective = (),
    population: int = 16,
    candidates: int = 16,
    generations: int = 10,
    elite: float = 0.25,
    seed: int = 0,
    device: str = "auto",
    time_limit: float | None = None,
    steps: int | None = None,
    moves: int | None = None,
) -> VariableSolution:
    """Choose lengths of a scene, within bounds, so that a valid layout of it is worth least.

    A generation is a population of scenes with values drawn by the cross-entropy method, refined together in shared
    launches: half of their candidates from nothing, half from the best layout so far. A scene without a valid candidate
    ranks behind all that have one, by the energy that is left. What is minimised is the sum of the variables' ``cost``
    times their values and of ``objective``.

    Args:
        scene: what to lay out; values of it that are within the bounds are tried first.
        variables: what may be chosen.
        objective: terms that the search minimises in every layout, or a function of a scene with a layout in it, which
            is measured for the best layout of each scene.
        population: scenes of a generation, at least 4.
        candidates: layouts of each scene, at least 2.
        generations: how many.
        elite: share of a generation that the next one is drawn like, above 0 and at most 0.5.
        seed: equal seeds give equal results unless time runs out.
        device: "auto", "cpu", "cuda" or "cuda:k".
        time_limit: seconds for all; the generation that it cuts off still counts.
        steps: attempts of the search, as in `sceneweaver.refine`.
        moves: of the minimisation of terms, as in `sceneweaver.refine`.

    Returns:
        The best values that were found, with their layouts.

    Raises:
        InputError: an argument is out of range, or a variable or term names what the scene does not have.

    Examples:
        >>> import sceneweaver as sw
        >>> desk = sw.Variable("size", "desk", "width", 1.0, 1.8, cost=-1.0)  # the wider the better
        >>> found = sw.optimize_variables(
        ...     sw.Scene.example("study"), [desk], population=4, candidates=4, generations=2, device="cpu"
        ... )
        >>> width = float(found.values[0])
        >>> found.valid, 1.0 <= width <= 1.8, found.scene.object("desk").size[1] == width
        (True, True, True)
    """
    began = time.monotonic()
    check_variables(scene, variables)
    terms = () if callable(objective) else tuple(objective)
    check_objective(scene, terms)
    _check(population, candidates, generations, elite, time_limit)
    run = _Run(tuple(variables), objective, terms, seed, device, steps, moves, time_limit, began)
    method = CrossEntropy(len(variables), seed, elite)
    members: list[_Member] = []
    best: _Member | None = None
    lowest: list[float] = []
    low, high = (np.array([getattr(v, end) for v in variables], dtype=np.float64) for end in ("low", "high"))
    span = np.maximum(high - low, 1e-12)
    for generation in range(generations):
        points = method.draw(population)
        if generation == 0:
            points[0] = np.clip((np.array([v.value(scene) for v in variables]) - low) / span, 0.0, 1.0)
        points[:, high == low] = 0.0
        values = np.clip(low + points * span, low, high)
        found = run.refined(scene, best, values, candidates, generation)
        order = sorted(range(population), key=lambda k: (found[k].key, k))
        if best is None or found[order[0]].key < best.key:
            best = found[order[0]]
        method.learn(points, np.array(order), (best.values - low) / span)
        members += found
        lowest.append(best.key[1] if best.key[0] == 0 else math.nan)
        if run.over():
            break
    assert best is not None
    return run.outcome(scene, best, members, lowest)


def _check(population: int, candidates: int, generations: int, elite: float, time_limit: float | None) -> None:
    """Raise InputError on anything out of range."""
    for name, value, least in (
        ("population", population, 4),
        ("candidates", candidates, 2),
        ("generations", generations, 1),
    ):
        if not isinstance(value, int | np.integer) or isinstance(value, bool) or value < least:
            raise InputError(f"{name}: {value!r} is not a whole number of at least {least}")
    if not isinstance(elite, int | float) or not 0 < elite <= 0.5:
        raise InputError(f"elite: {elite!r} is not a share above 0 and at most 0.5")
    if time_limit is not None and not time_limit > 0:
        raise InputError(f"time_limit: {time_limit!r} is not a positive number of seconds")


@dataclass(frozen=True)
class _Run:
    """What all generations share."""

    variables: tuple[Variable, ...]
    objective: Objective
    terms: tuple[ObjectiveTerm, ...]
    seed: int
    device: str
    steps: int | None
    moves: int | None
    time_limit: float | None
    began: float

    def over(self) -> bool:
        """Whether time is up."""
        return self.time_limit is not None and time.monotonic() - self.began >= self.time_limit

    def refined(
        self, scene: Scene, best: _Member | None, values: np.ndarray, candidates: int, generation: int
    ) -> list[_Member]:
        """A generation's scenes [population, V] refined, from nothing and from the best layout so far."""
        warm = candidates // 2 if best is not None and best.solution is not None else 0
        found: list[list[Solution]] = [[] for _ in values]
        for init, count in (("sample", candidates - warm), ("current", warm)):
            if not count or (found[0] and self.over()):
                continue
            base = scene
            if init == "current" and best is not None and best.solution is not None:
                base = best.solution.scene(best.candidate)
            scenes = [self._scene(base, row) for row in values]
            there = [k for k, made in enumerate(scenes) if made is not None]
            seeds = [(self.seed + STEP * (generation * len(values) + k)) % 2**32 for k in there]
            left = None if self.time_limit is None else max(self.time_limit - (time.monotonic() - self.began), 0.05)
            solutions = engine.refine_many(
                [made for made in scenes if made is not None],
                candidates=count,
                seed=seeds,
                init=init,
                device=self.device,
                steps=self.steps,
                time_limit=left,
                objective=[self.terms] * len(there) if self.terms else None,
                moves=self.moves,
            )
            for k, solution in zip(there, solutions, strict=True):
                found[k].append(solution)
        return [self._member(row, solutions) for row, solutions in zip(values, found, strict=True)]

    def _scene(self, scene: Scene, values: np.ndarray) -> Scene | None:
        """The scene at some values; None where there is none."""
        try:
            return with_values(scene, self.variables, values)
        except InputError:
            return None

    def _member(self, values: np.ndarray, solutions: Sequence[Solution]) -> _Member:
        """What one scene's candidates are worth: that of the best one."""
        members = []
        for solution in solutions:
            ranked = solution.ranked
            if not len(ranked):
                energy = np.where(np.isfinite(solution.energy), solution.energy, np.inf)
                k = int(np.argmin(energy))
                members.append(_Member(values, (1, float(energy[k])), solution, k))
                continue
            k = int(ranked[0])
            worth = float(sum(v.cost * x for v, x in zip(self.variables, values, strict=True)))
            if self.terms:
                worth += float(objective_of(solution.source, self.terms, solution.poses[k : k + 1])[0])
            if callable(self.objective):
                own = float(self.objective(solution.scene(k)))
                if not math.isfinite(own):
                    raise InputError(f"objective: the function returns {own}; it has to be a finite number")
                worth += own
            members.append(_Member(values, (0, worth), solution, k))
        return min(members, key=lambda member: member.key, default=_Member(values, (2, math.inf), None))

    def outcome(
        self, scene: Scene, best: _Member, members: Sequence[_Member], lowest: Sequence[float]
    ) -> VariableSolution:
        """What is returned."""
        solution, valid = best.solution, best.key[0] == 0
        worth = np.array([m.key[1] if m.key[0] == 0 else math.nan for m in members])
        explanation = None
        if not valid and solution is None:
            explanation = f"No values of {len(members)} tried give a scene: openings do not fit on their walls."
        elif not valid:
            where = ", ".join(f"{v.name} {x:.3f} m" for v, x in zip(self.variables, best.values, strict=True))
            explanation = (
                f"No layout is valid at any of {len(members)} values tried; the least energy, {best.key[1]:.3g} m, was "
                f"left at {where}. Widen the bounds, or ask `refine` of that scene what stands in the way."
            )
        return VariableSolution(
            variables=self.variables,
            values=best.values,
            scene=scene if solution is None else solution.scene(best.candidate),
            solution=solution,
            objective=best.key[1] if valid else math.nan,
            valid=valid,
            explanation=explanation,
            tried=np.array([m.values for m in members]),
            worth=worth,
            best=np.array(lowest),
            elapsed=time.monotonic() - self.began,
            timed_out=self.over(),
        )
