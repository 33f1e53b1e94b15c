"""Lengths as variables beside known optima, and Pareto fronts beside random weighted sums."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from benchmarks.timing import warm
from sceneweaver.layout import (
    ObjectiveTerm,
    Variable,
    hypervolume,
    objective_of,
    optimize_variables,
    pareto_front,
    refine,
)
from sceneweaver.layout.pareto import non_dominated
from sceneweaver.scene import SCHEMA, Scene

SEEDS, QUICK_SEEDS = 3, 1
HEIGHT = 0.5

OPTIMA = (
    Column("problem", "problem"),
    Column("variables", "variables", "count"),
    Column("known", "known optimum", "number"),
    Column("mean", "found, mean", "number"),
    Column("worst", "worst miss", "share"),
    Column("valid", "valid", "share"),
    Column("exceptions", "exceptions", "count"),
    Column("scenes", "scenes tried", "count"),
    Column("seconds", "seconds", "number"),
)
FRONTS = (
    Column("problem", "problem"),
    Column("seeds", "seeds", "count"),
    Column("ours", "hypervolume", "number"),
    Column("random", "random sums", "number"),
    Column("wins", "seeds won", "count"),
    Column("ours_points", "points", "number"),
    Column("random_points", "points of random sums", "number"),
    Column("exceptions", "exceptions", "count"),
    Column("seconds", "seconds each", "number"),
)


@dataclass(frozen=True)
class Known:
    """A problem with variables whose optimum is known by arithmetic."""

    name: str
    scene: Scene
    variables: tuple[Variable, ...]
    optimum: float
    objective: Any = ()


def box(name: str, size: tuple[float, float], at: tuple[float, float] = (1.0, 1.0), **more: Any) -> dict[str, Any]:
    """A block, square to the room unless something else is said."""
    pose = {"position": [*at, 0.0], "quaternion": [0.0, 0.0, 0.0, 1.0]}
    data = {"id": name, "category": "block", "size": [*size, HEIGHT], "pose": pose, "yaw_domain": [0.0]}
    return {**data, **more}


def boxes_in(x: float, y: float, objects: list[dict[str, Any]], **room: Any) -> Scene:
    """Blocks in a rectangular room."""
    outline = [[0, 0], [x, 0], [x, y], [0, y]]
    data = {"schema": SCHEMA, "id": "blocks", "room": {"outline": outline, "height": 2.5, **room}, "relations": []}
    return Scene.from_json({**data, "objects": objects})


def known_problems() -> list[Known]:
    """Problems whose optimum follows from sums of lengths."""
    depths = (1.2, 0.7, 0.5, 0.9, 0.4)
    door = {"id": "door", "wall": 0, "offset": 0.3, "width": 0.8, "height": 2.0, "swing": "out"}
    found = []
    for count in (3, 5):
        row = [box(f"b{i}", (d, 1.8), (0.6 + i, 1.0)) for i, d in enumerate(depths[:count])]
        extent = Variable("room", "", "x", 1.0, 6.0, cost=1.0)
        found.append(
            Known(f"narrowest room of {count} side by side", boxes_in(6.0, 2.0, row), (extent,), sum(depths[:count]))
        )
    posts = [box("l", (1.0, 2.0), (0.5, 1.0), fixed=True), box("r", (1.0, 2.0), (3.5, 1.0), fixed=True)]
    both = tuple(Variable("size", "d", axis, 0.5, 3.0, cost=-1.0) for axis in ("depth", "width"))
    found.append(
        Known("largest block between two", boxes_in(4.0, 2.0, [*posts, box("d", (0.9, 0.6), (2.0, 1.0))]), both, -4.0)
    )
    squares = [box(f"s{i}", (1.0, 1.0), (0.7 + 1.2 * (i % 2), 0.7 + 1.2 * (i // 2))) for i in range(4)]
    extents = tuple(Variable("room", "", axis, 1.0, 4.5) for axis in ("x", "y"))
    found.append(Known("least area of four squares", boxes_in(3.0, 3.0, squares), extents, 4.0, area_of))
    goal = [box("goal", (1.0, 1.0), (2.8, 2.4), fixed=True)]
    offset = Variable("opening", "door", "offset", 0.0, 3.2)
    terms = [ObjectiveTerm("flow", ("door", "goal"))]
    found.append(Known("door nearest to a goal", boxes_in(4.0, 3.0, goal, doors=[door]), (offset,), 2.4, terms))
    return found


def area_of(scene: Scene) -> float:
    """Area of the room's bounding box [m2]."""
    return float(np.prod(np.ptp(np.asarray(scene.room.outline), axis=0)))


def run(settings: Settings, judge: Judge) -> Result:
    """Optimise lengths where the best ones are known, and find fronts beside weighted sums drawn at random."""
    about = (
        "Lengths chosen together with the layout (optimize_variables, default budget) where arithmetic gives the best "
        "ones, and Pareto fronts of two objectives beside sums with random weights given the same wall time."
    )
    result = Result("variables", "Variables and fronts", about)
    seeds = range(settings.seed, settings.seed + (QUICK_SEEDS if settings.quick else SEEDS))
    optima = result.add("optima", "Known optima", OPTIMA)
    problems = known_problems()
    for problem in problems[:1] if settings.quick else problems:
        optima.rows.append(_optimum(settings, judge, result, problem, seeds))
    fronts = result.add("fronts", "Fronts at equal time", FRONTS)
    for name, make in FRONT_PROBLEMS.items() if not settings.quick else [next(iter(FRONT_PROBLEMS.items()))]:
        fronts.rows.append(_front(settings, judge, result, name, *make(), seeds))
    result.notes.append(
        "Worst miss: of the value found from the known optimum, over it, in the worst seed; the judge lets bodies sink "
        "in by 1 mm, so a value may be better than arithmetic says. Hypervolume: over the box from the best values of "
        "both methods to the worst of their fronts, so 1 would be a single layout best by both; the mean over seeds."
    )
    return result


def _optimum(settings: Settings, judge: Judge, result: Result, problem: Known, seeds: range) -> dict[str, Any]:
    size = {"population": 4, "candidates": 4, "generations": 2} if settings.quick else {}
    warm(problem.scene, settings)
    found, valid, wrong, tried, seconds = [], 0, 0, 0, 0.0
    for seed in seeds:
        answer = optimize_variables(
            problem.scene, problem.variables, objective=problem.objective, seed=seed, device=settings.device, **size
        )
        seconds += answer.elapsed
        tried = len(answer.tried)
        if answer.valid:
            valid += 1
            found.append(answer.objective)
            wrong += _wrong(judge, answer.scene)
    if wrong:
        result.failures.append(f"{problem.name}: {wrong} scenes are called valid and are not")
    miss = [abs(value - problem.optimum) / abs(problem.optimum) for value in found]
    return {
        "problem": problem.name,
        "variables": len(problem.variables),
        "known": problem.optimum,
        "mean": float(np.mean(found)) if found else None,
        "worst": max(miss) if miss else None,
        "valid": valid / len(seeds),
        "exceptions": wrong,
        "scenes": tried,
        "seconds": seconds / len(seeds),
    }


def _wrong(judge: Judge, scene: Scene) -> int:
    poses = np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]])
    return sum(not opinion.valid for opinion in judge(scene, poses))


Terms = list[ObjectiveTerm]


def bedroom() -> tuple[Scene, Terms, Terms]:
    """A bed near its wardrobe, or by the window."""
    near, light = ObjectiveTerm("flow", ("bed", "wardrobe")), ObjectiveTerm("flow", ("bed", "window"))
    return Scene.example("bedroom"), [near], [light]


def blocks() -> tuple[Scene, Terms, Terms]:
    """Twelve blocks whose two nets pull to different corners."""
    rng = np.random.default_rng(0)
    sizes = rng.uniform(0.4, 1.2, (12, 2))
    objects = [
        box(f"b{i}", (float(w), float(h)), (2.0, 2.0), yaw_domain="quarter_turns") for i, (w, h) in enumerate(sizes)
    ]
    pads = [box("p", (0.05, 0.05), (0.05, 0.05), fixed=True), box("q", (0.05, 0.05), (3.95, 3.95), fixed=True)]
    terms = [[ObjectiveTerm("flow", (f"b{i}", pad)) for i in range(12)] for pad in ("p", "q")]
    return boxes_in(4.0, 4.0, [*objects, *pads]), terms[0], terms[1]


def kinked() -> tuple[Scene, Terms, Terms]:
    """One block around an obstacle, near to either of two places: a straight front, on which no sum has its minimum."""
    fixed = [
        box("wall", (0.6, 1.6), (2.0, 1.6), fixed=True),
        box("p", (0.1, 0.1), (0.1, 2.9), fixed=True),
        box("q", (0.1, 0.1), (3.9, 2.9), fixed=True),
    ]
    first, second = ([ObjectiveTerm("flow", ("a", to))] for to in ("p", "q"))
    return boxes_in(4.0, 3.0, [box("a", (0.4, 0.4)), *fixed]), first, second


FRONT_PROBLEMS: dict[str, Callable[[], tuple[Scene, Terms, Terms]]] = {
    "one block, straight front": kinked,
    "bedroom": bedroom,
    "twelve blocks": blocks,
}


def _front(
    settings: Settings, judge: Judge, result: Result, name: str, scene: Scene, first: Terms, second: Terms, seeds: range
) -> dict[str, Any]:
    candidates, moves = settings.size(16, 4), 2_000 if settings.quick else None
    how: dict[str, Any] = {"candidates": candidates, "moves": moves, "device": settings.device}
    pareto_front(scene, first, second, weights=2, rounds=2, candidates=2, moves=100, device=settings.device)  # warm
    ours, theirs, points, wins, wrong, seconds = [], [], [], 0, 0, 0.0
    for seed in seeds:
        front = pareto_front(scene, first, second, seed=seed, rounds=2 if settings.quick else 3, **how)
        seconds += front.elapsed
        other = _random_sums(scene, first, second, seed, front.elapsed, how)
        both = np.concatenate([front.values, other])
        low = both.min(axis=0)
        reach = np.maximum(both.max(axis=0) - low, 1e-9)
        ours.append(hypervolume((front.values - low) / reach, (1.1, 1.1)) / 1.21)
        theirs.append(hypervolume((other - low) / reach, (1.1, 1.1)) / 1.21)
        points.append((len(front.values), len(other)))
        wins += ours[-1] > theirs[-1]
        wrong += sum(not o.valid for o in judge(scene, front.poses))
    if wrong:
        result.failures.append(f"{name}: {wrong} layouts of a front are called valid and are not")
    ours_points, random_points = np.mean(points, axis=0)
    return {
        "problem": name,
        "seeds": len(seeds),
        "ours": float(np.mean(ours)),
        "random": float(np.mean(theirs)),
        "wins": wins,
        "ours_points": float(ours_points),
        "random_points": float(random_points),
        "exceptions": wrong,
        "seconds": seconds / len(seeds),
    }


def _random_sums(
    scene: Scene, first: Terms, second: Terms, seed: int, seconds: float, how: dict[str, Any]
) -> np.ndarray:
    """The front [K, 2] of all valid layouts that sums with random weights find in so many seconds, at least three.

    The first two calls minimise either objective alone, which gives the scales of both.
    """
    rng, began, number = np.random.default_rng(seed), time.monotonic(), 0
    values, scale = np.zeros((0, 2)), np.ones(2)
    while number < 3 or time.monotonic() - began < seconds:
        share = (1.0, 0.0)[number] if number < 2 else rng.random()
        terms = [
            replace(term, weight=term.weight * weight)
            for group, weight in ((first, share / scale[0]), (second, (1.0 - share) / scale[1]))
            for term in group
            if weight > 0.0
        ]
        solution = refine(scene, objective=terms, seed=(seed + 104729 * number) % 2**32, walk=False, **how)
        poses = solution.poses[solution.status == 0].astype(np.float64)
        if len(poses):
            found = np.stack([objective_of(scene, group, poses) for group in (first, second)], axis=1)
            values = np.concatenate([values, found])
        number += 1
        if number == 2 and len(values):
            scale = np.maximum(np.ptp(values[non_dominated(values)], axis=0), 1e-9)
    return values[non_dominated(values)]
