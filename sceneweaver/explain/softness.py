"""Which soft rows fight hard ones: rows that hold in no valid layout, and what breaks when one follows their slope."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.layout import Problem, Solution, compile
from sceneweaver.layout.metadata import Metadata
from sceneweaver.layout.problem import Terms
from sceneweaver.layout.user import TERMS
from sceneweaver.scene import Scene

from .words import LINES, listed, relation_words

ENOUGH = 8
"""Valid layouts from which on it says something that a soft row holds in none."""

LOOKED = 8  # of the best valid layouts
ROWS = 8  # of those that never hold, how many are followed
STEP = 0.05  # [m] along the slope: what it breaks is in the way
FREE = 1.0e-4  # [m] from which on a violation is one
MISSING = 1.0e-3  # [m] of residual from which on a term asks for more


@dataclass(frozen=True)
class Fight:
    """A soft row that nothing satisfied, and what is in its way.

    Attributes:
        row: the soft relation, or the term with its objects, in words.
        breaks: hard rows in words, each with the number of layouts in which a small step for the row's sake breaks it.
        layouts: how many were looked at.
    """

    row: str
    breaks: tuple[tuple[str, int], ...]
    layouts: int

    def __str__(self) -> str:
        hard = listed([f"{words} (in {count} of {self.layouts})" for words, count in self.breaks[:LINES]])
        return f"{self.row} pulls against what is hard: 5 cm more for it would break {hard}."


def lost_wishes(solution: Solution) -> list[str]:
    """The soft relations and terms that hold in no valid layout, and what each of the first ones fights."""
    valid = solution.ranked
    if len(valid) < ENOUGH:
        return []
    scene = solution.source
    never = [j for j in np.flatnonzero(~np.any(solution.relations[valid], axis=0)) if not scene.relations[j].hard]
    problem = compile(scene, device=solution.device) if never or TERMS else None
    if problem is None:
        return []
    poses = solution.bodies[valid[:LOOKED]]
    terms = _terms_that_miss(problem, poses)
    lines = []
    for what, lost in (
        ("Soft relations", [relation_words(scene.relations[j]) for j in never]),
        ("Terms of your own", list(dict.fromkeys(str(problem.metadata[0].relations[r].term) for r in terms))),
    ):
        if lost:
            lines.append(
                f"{what} that hold in none of {len(valid)} valid layouts, so they seem to contradict what is hard or "
                f"each other: {listed(lost)}."
            )
    info = problem.metadata[0]
    place = {relation.index: r for r, relation in enumerate(info.relations) if relation.index is not None}
    return [*lines, *map(str, fights(problem, poses, [*(place[int(j)] for j in never), *terms])[: LINES + 1])]


def fights(problem: Problem, poses: np.ndarray, rows: Sequence[int]) -> list[Fight]:
    """Which of some soft rows pull against hard ones, those that break most first.

    Args:
        problem: of one scene.
        poses: valid layouts [B, N, 4].
        rows: places of the soft rows among the problem's relations; the first `ROWS` are looked at.

    Returns:
        A fight for each that breaks a hard row in half of the layouts or more, when its objects go `STEP` along it.
    """
    rows, info, scene = list(rows)[:ROWS], problem.metadata[0], problem.scenes[0]
    if not rows:
        return []
    before = problem.terms(poses)
    moved = np.concatenate([_followed(problem, poses, row) for row in rows])
    after = problem.terms(moved)
    hard = [k for k, item in enumerate(info.items) if item.relation is None or info.relations[item.relation].hard]
    found = []
    for n, row in enumerate(rows):
        broken = _broken(before, after, slice(n * len(poses), (n + 1) * len(poses)))
        counts = Counter({_item_words(info, scene, k): int(broken[:, k].sum()) for k in hard})
        breaks = tuple((words, count) for words, count in counts.most_common(LINES) if 2 * count >= len(poses))
        if breaks:
            found.append(Fight(_row_words(info, scene, row), breaks, len(poses)))
    return sorted(found, key=lambda fight: -fight.breaks[0][1])


def _followed(problem: Problem, poses: np.ndarray, row: int) -> np.ndarray:
    """Layouts [B, N, 4] whose objects of a soft row went a step along its slope, with what they carry."""
    _, slope = problem.residuals(poses)
    free, roots, moved = problem.free[0], problem.roots[0], poses.copy()
    for role, obj in enumerate(problem.item_objects[0, row]):
        if obj >= 0:
            root = roots[obj]
            way = slope[:, row, role] * free[root]
            long = np.linalg.norm(way, axis=1, keepdims=True)
            moved[:, root] -= (STEP * way / np.maximum(long, 1.0e-9)).astype(np.float32)
    return problem.carry(moved, like=poses)


def _broken(before: Terms[np.ndarray], after: Terms[np.ndarray], part: slice) -> np.ndarray:
    return (after.violation[part] > FREE) & (before.violation <= FREE)


def _terms_that_miss(problem: Problem, poses: np.ndarray) -> list[int]:
    """Places of the terms' rows whose residual asks for more in every layout."""
    info = problem.metadata[0]
    rows = [r for r, relation in enumerate(info.relations) if relation.term is not None]
    if not rows:
        return []
    residual, _ = problem.residuals(poses)
    return [r for r in rows if (residual[:, r] > MISSING).all()]


def _row_words(info: Metadata, scene: Scene, row: int) -> str:
    relation = info.relations[row]
    if relation.index is not None:
        return relation_words(scene.relations[relation.index])
    return f"the term {relation.term} of {listed([info.objects[o].id for o in relation.objects])}"


def _item_words(info: Metadata, scene: Scene, k: int) -> str:
    item = info.items[k]
    if item.relation is not None:
        relation = info.relations[item.relation]
        if relation.index is not None:
            return relation_words(scene.relations[relation.index])
        return f"the place at a wall of {info.objects[item.objects[0]].id}"
    names = [info.objects[o].id for o in item.objects]
    return f"the space between {names[0]} and {names[1]}" if len(names) == 2 else f"the place of {names[0]} in the room"
