"""Tasks as rows of numbers, which kernels judge."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.envs.geometry import SceneGeometry
from sceneweaver.envs.robots import Robot
from sceneweaver.envs.sampling import tasks_of
from sceneweaver.envs.tasks import Close, NavigateTo, Open, PutIn, PutOn, Take, Task

KINDS: tuple[type[Task], ...] = (Open, Close, NavigateTo, PutIn, PutOn, Take)
"""Kinds of tasks that batches know, by number."""

GOAL = np.dtype(
    [
        ("kind", np.int32),
        ("subject", np.int32),
        ("holder", np.int32),
        ("joint", np.int32),
        ("oval", np.int32),
        ("share", np.float32),
        ("open_end", np.float32),
        ("begin", np.float32),
        ("radius", np.float32),
        ("centre", np.float32, 3),
        ("item_low", np.float32, 3),
        ("item_high", np.float32, 3),
        ("low", np.float32, 3),
        ("high", np.float32, 3),
        ("subject_pose", np.float32, 7),
        ("holder_pose", np.float32, 7),
    ]
)
"""One task of a layout.

- ``kind``: number in ``KINDS``; -1: none.
- ``subject``, ``holder``: slots of the moving bodies that it is about and that holds or carries it; -1: it stands
  still, at ``subject_pose`` or ``holder_pose`` (position [m], w, x, y, z).
- ``joint``: slot of the link that is to be opened or closed; -1: none. ``open_end`` of its range [rad] or [m],
  ``begin`` where it begins.
- ``share``: of the range; for `Take` the height [m], for `NavigateTo` the distance [m].
- ``centre``: the point of the subject that counts, the grip of a link; ``item_low`` and ``item_high`` its box;
  ``radius`` half the diagonal of it [m]. All in its frame.
- ``low``, ``high``: of the interior, or of the surface with its height as both z, in the holder's frame; ``oval``
  whether the interior is.
"""


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
        row["subject_pose"], row["holder_pose"] = poses[task.subject_owner], poses[task.holder_owner]
        if isinstance(task.task, Open | Close):
            row["joint"] = row["subject"]
        if has_goal(task, names):
            rows.append(row)
    return np.array(rows, GOAL)


def has_goal(task: TaskRow, names: Sequence[str]) -> bool:
    """Whether a task is one of a batch with these moving bodies: what it is about moves, or is only gone to."""
    return task.subject in names or isinstance(task.task, NavigateTo)


def _row(geometry: SceneGeometry, task: Task, number: dict[str, int]) -> TaskRow:
    row, name, holder = np.zeros((), GOAL), task.subject, ""
    row["kind"], row["joint"] = KINDS.index(type(task)), -1
    if isinstance(task, Open | Close):
        link = geometry.articulations[task.joint]
        row["share"], row["open_end"] = task.share, link.open_end
        row["begin"] = task.begin * link.open_end if isinstance(task, Close) else 0.0
        grasps = geometry.grasps.get(task.joint)
        row["centre"] = grasps[0].position if grasps else geometry.items[link.object].centre
    else:
        item = geometry.items[name]
        row["centre"], row["item_low"], row["item_high"] = item.centre, item.low, item.high
        row["radius"] = np.linalg.norm(item.size) / 2
    if isinstance(task, NavigateTo):
        row["share"] = task.reach
    elif isinstance(task, Take):
        row["share"] = task.height
    elif isinstance(task, PutIn):
        holder, inside = task.container, geometry.interior(task.container, task.interior)
        row["low"], row["high"], row["oval"] = inside.low, inside.high, inside.oval
    elif isinstance(task, PutOn):
        holder, top = task.support, geometry.surface(task.support, task.surface)
        row["low"], row["high"] = (*top.low, top.z), (*top.high, top.z)
    owner = geometry.owner
    return TaskRow(
        task, task.instruction(geometry), row, name, holder, number[owner[name]], number[owner[holder or name]]
    )
