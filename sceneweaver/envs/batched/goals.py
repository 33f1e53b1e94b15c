"""Tasks as rows of numbers, which kernels judge."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.envs.geometry import SceneGeometry
from sceneweaver.envs.robots import Robot
from sceneweaver.envs.sampling import tasks_of
from sceneweaver.envs.tasks import KINDS, Close, JointTask, NavigateTo, Open, PutTask, Take, Task, point_of

from .structs import GOAL

LIMITS: dict[type[Task], str] = {Open: "share", Close: "share", NavigateTo: "reach", Take: "height"}
"""By kind of task, the number of it that a goal is judged by."""


@dataclass(frozen=True)
class TaskRow:
    """A task of a room before slots and layouts are known.

    Attributes:
        task: The task.
        instruction: In words.
        row: Of ``GOAL``, without slots and poses.
        subject, holder: Names of bodies; holder "": none.
        subject_owner, holder_owner: Numbers of their objects in the scene.
    """

    task: Task
    instruction: str
    row: np.ndarray
    subject: str
    holder: str
    subject_owner: int
    holder_owner: int


def task_rows(
    geometry: SceneGeometry, robot: Robot, poses: np.ndarray, kinds: Sequence[type[Task]], most: int = 32
) -> tuple[TaskRow, ...]:
    """Feasible tasks of some kinds, at most so many: one of each kind in turn.

    Args:
        geometry: Of the scene, with ``loose=False``.
        robot: Who does them.
        poses: [N, 7] of the scene's objects (position, w, x, y, z).
        kinds: Kinds of tasks.
        most: At most so many.
    """
    place = {o.id: pose for o, pose in zip(geometry.scene.objects, poses, strict=True)}
    where = {name: place[geometry.owner[name]] for name in (*geometry.items, *geometry.articulations)}
    found = tasks_of(geometry, robot, where)
    queues = [[task for task in found if type(task) is kind] for kind in kinds]
    turns = max(map(len, queues), default=0)
    taken = [queue[k] for k in range(turns) for queue in queues if k < len(queue)]
    number = {o.id: k for k, o in enumerate(geometry.scene.objects)}
    return tuple(_row(geometry, task, number) for task in taken[:most])


def goal_rows(tasks: Sequence[TaskRow], names: Sequence[str], poses: np.ndarray) -> np.ndarray:
    """The tasks of a room as rows of ``GOAL`` for one layout; those whose subject got no slot are left out.

    Args:
        tasks: The tasks.
        names: Of the body in each moving slot; "" where none is.
        poses: [N, 7] of the scene's objects (position, w, x, y, z).
    """
    slot = {name: k for k, name in enumerate(names) if name}
    rows = []
    for task in tasks:
        row = task.row.copy()
        row["subject"], row["holder"] = slot.get(task.subject, -1), slot.get(task.holder, -1)
        for who, owner in (("subject", task.subject_owner), ("holder", task.holder_owner)):
            row[f"{who}_pos"], row[f"{who}_quat"] = poses[owner, :3], poses[owner, 3:]
        if isinstance(task.task, JointTask):
            row["joint"] = row["subject"]
        if has_goal(task, names):
            rows.append(row)
    return np.array(rows, GOAL)


def has_goal(task: TaskRow, names: Sequence[str]) -> bool:
    """Whether a task is one of a batch with these moving bodies: what it is about moves, or is only gone to."""
    return task.subject in names or isinstance(task.task, NavigateTo)


def _row(geometry: SceneGeometry, task: Task, number: dict[str, int]) -> TaskRow:
    row, name, holder, owner = np.zeros((), GOAL), task.subject, "", geometry.owner
    row["kind"], row["joint"], row["centre"] = KINDS.index(type(task)), -1, point_of(geometry, name)
    if type(task) in LIMITS:
        row["share"] = getattr(task, LIMITS[type(task)])
    if name in geometry.articulations:
        row["open_end"] = geometry.articulations[name].open_end
        row["begin"] = task.start_joints(geometry).get(name, 0.0)
    else:
        item = geometry.items[name]
        row["item_low"], row["item_high"], row["radius"] = item.low, item.high, np.linalg.norm(item.size) / 2
    if isinstance(task, PutTask):
        place = task.place(geometry)
        holder, row["low"], row["high"], row["oval"] = place.body, place.low, place.high, place.oval
        row["spot"] = place.target
    words = task.instruction(geometry)
    return TaskRow(task, words, row, name, holder, number[owner[name]], number[owner[holder or name]])
