"""What pulls at the objects of an arranged room: a column for each kind of soft row, and one for each hard row at hand.

A room that minimises an energy is at rest: the slopes of its soft rows, times their weights, and the forces of the hard
rows that touch add up to nothing in every direction in which an object may go (the conditions of Karush, Kuhn and
Tucker). Both are linear in what is not known, so no weight has to be guessed to read them off a room.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.layout import Problem, compile
from sceneweaver.layout.rows import SOFT_WEIGHT
from sceneweaver.scene import Relation, Scene

KNEE = 0.05  # [m] of the energy's penalty
ALIKE = 0.999  # cosine from which on two directions of one hard row are the same
FORCE = 1.0e-3  # of a slope of 1: below it nothing acts


@dataclass(frozen=True)
class Forces:
    """The forces in one room, by free coordinates D of its roots (x, y, z [m], yaw in metres at an arm of the object).

    Attributes:
        soft: [D, K], the slope of the energy of each kind of soft row at a weight of 1.
        hard: [D, H], slopes of the hard rows that are violated here, or a step from here.
        objects: [D], the object that a coordinate is of.
    """

    soft: np.ndarray
    hard: np.ndarray
    objects: np.ndarray


def kinds_of(scene: Scene, problem: Problem, kind: Callable[[Relation], str | None]) -> list[str | None]:
    """The kind of each of a problem's relations; None for hard ones and those that do not count.

    Terms of the user's own are kinds by their names, as ``"term NAME"``.
    """
    found = []
    for info in problem.metadata[0].relations:
        if info.term is not None:
            found.append(f"term {info.term}")
        else:
            found.append(None if info.hard or info.index is None else kind(scene.relations[info.index]))
    return found


def forces_of(
    scene: Scene, kinds: Sequence[str], kind: Callable[[Relation], str | None], *, reach: float = 0.01, device: str
) -> Forces:
    """The forces in a room as it stands.

    Args:
        scene: the room, arranged.
        kinds: the kinds of soft rows, the columns of ``soft``.
        kind: the kind of a soft relation, None where it does not count.
        reach: how far objects are moved to find the hard rows that touch [m].
        device: as for `sceneweaver.refine`.
    """
    problem = compile(scene, device=device)
    home = problem.home
    info, free, roots = problem.metadata[0], problem.free[0], problem.roots[0]
    arms = _arms(problem)
    steps = [
        (obj, c, s) for obj in np.flatnonzero(free.any(axis=1)) for c in np.flatnonzero(free[obj]) for s in (1, -1)
    ]
    poses = np.repeat(home, 1 + len(steps), axis=0)
    for row, (obj, c, sign) in enumerate(steps, 1):
        poses[row, obj, c] += sign * reach / (arms[obj] if c == 3 else 1.0)
    poses = problem.carry(poses, like=np.repeat(home, len(poses), axis=0))
    residual, slope = problem.residuals(poses)
    of = kinds_of(scene, problem, kind)
    count, coordinates = len(info.objects), np.argwhere(free)
    soft = np.zeros((count, 4, len(kinds)))
    hard: list[np.ndarray] = []
    for k, item in enumerate(info.items):
        mine = problem.item_objects[0, k]
        relation = None if item.relation is None else info.relations[item.relation]
        if relation is None or relation.hard:
            rows = np.flatnonzero(np.abs(slope[:, k]).max(axis=(1, 2)) > FORCE)
            hard += _distinct([_on_roots(slope[row, k], mine, poses[row], roots, arms, count) for row in rows], free)
        elif of[item.relation or 0] in kinds:
            pull = SOFT_WEIGHT * residual[0, k] / KNEE / relation.weight * slope[0, k]
            soft[..., kinds.index(str(of[item.relation or 0]))] += _on_roots(pull, mine, home[0], roots, arms, count)
    at = (coordinates[:, 0], coordinates[:, 1])
    walls = np.array([one[at] for one in hard]).reshape(len(hard), len(coordinates)).T
    return Forces(soft[at], walls, coordinates[:, 0])


def _arms(problem: Problem) -> np.ndarray:
    """The length [m] at which a turn of each object counts: about a third of its reach, as for the optimisers."""
    sizes = np.array([o.size for o in problem.metadata[0].objects])
    return 0.15 * np.linalg.norm(sizes[:, :2], axis=1) + 0.05


def _on_roots(
    slope: np.ndarray, objects: np.ndarray, poses: np.ndarray, roots: np.ndarray, arms: np.ndarray, count: int
) -> np.ndarray:
    """Slopes [3, 4] by the poses of an item's objects as slopes [N, 4] by those of their roots, yaw in metres.

    What is carried turns about its root: a slope in the plane at a distance from there is also one by its yaw.
    """
    out = np.zeros((count, 4))
    for role, obj in enumerate(objects):
        if obj >= 0:
            root = roots[obj]
            x, y = poses[obj, :2] - poses[root, :2]
            turn = slope[role, 3] + x * slope[role, 1] - y * slope[role, 0]
            out[root] += (*slope[role, :3], turn / arms[root])
    return out


def _distinct(slopes: list[np.ndarray], free: np.ndarray) -> list[np.ndarray]:
    """Unit slopes [N, 4] of one hard row that point in different directions."""
    found: list[np.ndarray] = []
    for slope in slopes:
        masked = slope * free
        size = np.linalg.norm(masked)
        if size > FORCE and all(np.vdot(masked / size, other) < ALIKE for other in found):
            found.append(masked / size)
    return found
