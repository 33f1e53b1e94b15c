"""A program of a user's, typed strictly: it uses the public names, and pyright has nothing to say about it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

import sceneweaver as sw


def furnished() -> sw.Scene:
    """A room with a bed and a wish."""
    room = sw.Room.rectangle(4.0, 5.0, kind="bedroom").with_door("south", at=0.2).with_window("north")
    bed = sw.SceneObject(id="bed", category="bed", size=(2.0, 1.6, 0.5))
    wish = sw.Relation(type="against_wall", subject="bed", hard=False, weight=2.0)
    return sw.Scene(id="mine", room=room, objects=(bed,), relations=(wish,))


def solved(scene: sw.Scene) -> sw.Solution:
    """Layouts, rated by a term."""
    terms: Sequence[sw.QualityTerm] = [sw.QualityTerm("backing", ("bed", scene.room.doors[0].id), low=0.5, span=0.4)]
    solution: sw.Solution = sw.refine(scene, candidates=8, seed=0, device="cpu", time_limit=5.0, quality=terms)
    best: sw.Scene = solution.best
    status: npt.NDArray[np.int8] = solution.status
    told: str | None = solution.explanation
    if told is not None:
        print(told.splitlines(), status.shape, best.id)
    others: list[sw.Solution] = sw.refine_many([scene, scene], candidates=4, device="cpu")
    return sw.improve(others[0] if not others else solution, terms, candidates=4)


def measured(scene: sw.Scene) -> float:
    """Energy, gradient, terms and verdict."""
    problem: sw.Problem = sw.compile([scene], device="cpu")
    poses = problem.sample(0, 4)
    energy, gradient = problem.energy_and_grad(poses)
    parts = problem.terms(poses)
    collision: float = float(parts.energy["collision"].sum())
    residual, slope = problem.residuals(poses)
    good: int = int(problem.feasible(problem.project(poses)).sum())
    for info in problem.metadata[0].relations:
        print(info.index, info.hard, info.weight, info.term)
    shapes: tuple[int, ...] = gradient.shape + residual.shape + slope.shape
    return float(energy.mean()) + collision + good + len(shapes)


def judged(scene: sw.Scene) -> int:
    """Report, violations, repair."""
    report: sw.Report = sw.check(scene)
    held: int = report.relations.soft.satisfied + report.relations.hard.total
    for violation in report.violations:
        where: sw.Violation = violation
        print(where.kind, where.detail)
    unmet: int = len(report.unmet)
    mended: sw.Scene = sw.repair(scene)
    return held + unmet + len(mended.objects)


def holds(a: sw.SceneObject, b: sw.SceneObject | None, params: Mapping[str, float]) -> bool:
    """A predicate of a relation of one's own."""
    return b is not None and a.pose.position[0] >= b.pose.position[0] + params["by"]


def learned(scenes: Sequence[sw.Scene]) -> dict[str, float]:
    """Weights and arrays."""
    found: sw.LearnedWeights = sw.learn_weights(scenes)
    weighed: sw.Scene = found.applied(scenes[0])
    view = sw.datasets.tensors([*scenes, weighed], frame="unit")
    for batch in view.batches(2, seed=0):
        world: npt.NDArray[np.float32] = batch.world(batch.poses)
        print(world.shape, batch.mask.sum(), view.vocabulary.name(int(batch.categories[0, 0])))
    return found.weights


def edited(scene: sw.Scene, out: Path) -> Path:
    """Edits, files, a picture."""
    session = sw.EditSession(scene)
    print(type(session))
    moved: sw.Scene = scene.move("bed", by=(0.1, 0.0))
    moved.save(out)
    sw.draw_top(moved)
    again: sw.Scene = sw.Scene.load(out)
    if again != moved:
        raise sw.InputError("the file is another scene")
    return out
