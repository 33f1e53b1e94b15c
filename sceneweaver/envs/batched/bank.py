"""Rooms and layouts as rows of arrays that all fit one model of slots.

The slots are: S boxes that stand still, links on hinges and on slides, free bodies, each with so many boxes. A room
takes as many as it needs; the rest is parked high above it, tiny and without weight. What does not fit stands still,
and what does not fit there either is left out, the smallest first.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.envs.geometry import SceneGeometry
from sceneweaver.envs.layouts import layouts_of
from sceneweaver.envs.predicates import product
from sceneweaver.envs.robots import Robot, robot_named
from sceneweaver.envs.tasks import KINDS, Task
from sceneweaver.geometry.rotations import matrix, xyzw
from sceneweaver.io import InputError, open_writable, parse_json, read_arrays, reason, whole
from sceneweaver.runtime.processes import pool
from sceneweaver.scene import Room, Scene

from .goals import TaskRow, goal_rows, has_goal, task_rows
from .room import (
    ANCHORED,
    BODY_FIELDS,
    DOF_FIELDS,
    FREE,
    HINGE,
    JOINT_FIELDS,
    SLIDE,
    Boxes,
    MovingBody,
    RoomBodies,
    bodies_of,
)
from .structs import GOAL

PARKED = 500.0
"""Height [m] from which unused slots are parked, each on a place of its own."""

_TINY = 1e-3  # [m] half extent of a box that is not used
_NEAR = 0.5  # [kg]: what weighs about as much is the first to be free


@dataclass(frozen=True)
class Slots:
    """How many there are: boxes that stand still, and the boxes of each hinge, slide and free body."""

    still: int
    hinges: tuple[int, ...]
    slides: tuple[int, ...]
    free: tuple[int, ...]

    @classmethod
    def fit(
        cls, rooms: Sequence[RoomBodies], still: int = 256, hinges: int = 16, slides: int = 12, free: int = 16
    ) -> Slots:
        """As few as hold all rooms, and not more than so many."""

        def parts(kind: int, most: int) -> tuple[int, ...]:
            found = [0] * most
            for room in rooms:
                for k, body in enumerate(_chosen(room, kind, most)):
                    found[k] = max(found[k], len(body.boxes))
            return tuple(n for n in found if n)

        moving = parts(HINGE, hinges), parts(SLIDE, slides), parts(FREE, free)
        needed = max((len(_still(room, hinges, slides, free)) for room in rooms), default=0)
        return cls(min(needed, still), *moving)

    @property
    def parts(self) -> tuple[int, ...]:
        """Boxes of each moving body: hinges, slides, free bodies."""
        return (*self.hinges, *self.slides, *self.free)

    @property
    def links(self) -> int:
        """How many hinges and slides."""
        return len(self.hinges) + len(self.slides)

    @property
    def geoms(self) -> int:
        """Boxes in all."""
        return self.still + sum(self.parts)

    @property
    def dofs(self) -> int:
        """Degrees of freedom."""
        return self.links + 6 * len(self.free)


@dataclass
class Bank:
    """R rooms and V layouts of them (V >= R), all in the same slots.

    G boxes (those that stand still first), M moving bodies (hinges, slides, free), L links, D degrees of freedom, N the
    most objects of a room.

    Attributes:
        slots: The slots.
        room: Fields of each room by name of the MuJoCo field: ``geom_size`` [R, G, 3], ``body_mass`` [R, M],
            ``jnt_axis`` [R, L, 3], ``dof_damping`` [R, D] ...
        layout: Fields of each layout: ``room`` [V] its room; ``still_pos`` [V, S, 3], ``still_quat`` [V, S, 4],
            ``link_pos`` [V, L, 3], ``link_quat`` [V, L, 4], ``free_pose`` [V, F, 7] (position, w, x, y, z); ``spawns``
            [V, P, 3] free places of the robot's base; ``goals`` [V, K] rows of ``structs.GOAL`` and ``goal_count`` [V].
        names: By room, the name of the body in each moving slot; "" where it is not used.
        instructions: By room, what each of its goals asks for, in words.
        dropped: By room, how many boxes were left out.
    """

    slots: Slots
    room: dict[str, np.ndarray]
    layout: dict[str, np.ndarray]
    names: list[list[str]]
    instructions: list[list[str]]
    dropped: list[int]

    @property
    def rooms(self) -> int:
        """R."""
        return len(self.names)

    @property
    def layouts(self) -> int:
        """V."""
        return len(self.layout["room"])

    @classmethod
    def of(
        cls,
        scenes: Sequence[Scene],
        layouts: Sequence[Any] | None = None,
        robot: Robot | None = None,
        tasks: Sequence[type[Task]] = KINDS,
        *,
        load: Load | None = None,
        slots: Slots | None = None,
        anchored: float = ANCHORED,
        jobs: int = 1,
    ) -> Bank:
        """The bank of some rooms. Layouts without a feasible task are left out.

        Args:
            scenes: The rooms.
            layouts: For each room its layouts, as `sceneweaver.envs.layouts.layouts_of` takes them; None: as it is.
            robot: Who works there; None: the drawn mobile manipulator.
            tasks: Kinds of tasks.
            load: From asset id to asset; None: the library of this user.
            slots: None: as few as hold all, within the limits of `Slots.fit`.
            anchored: Mass [kg] from which things stand still.
            jobs: Processes that read rooms; with more than one ``load`` has to be picklable.

        Raises:
            InputError: no task is feasible in any of them.
        """
        chosen = [None] * len(scenes) if layouts is None else list(layouts)
        robot = robot or robot_named("mobile")
        read = partial(_read, robot=robot, kinds=tuple(tasks), load=load, anchored=anchored)
        if jobs > 1:
            with pool(min(jobs, len(scenes))) as processes:
                rooms = list(processes.map(read, scenes, chosen))
        else:
            rooms = list(map(read, scenes, chosen))
        slots = slots or Slots.fit([room.bodies for room in rooms])
        rows = [_room_row(room.bodies, slots) for room in rooms]
        found, places = [], []
        for number, (room, row) in enumerate(zip(rooms, rows, strict=True)):
            for pose in room.poses:
                goals = goal_rows(room.tasks, row.names, pose)
                if len(goals):
                    place = _layout_row(row, slots, pose, number)
                    place["spawns"] = spawns(room.bodies.scene.room, row, slots, place, robot.radius)
                    places.append(place)
                    found.append(goals)
        if not places:
            raise InputError("scenes: no task of these kinds is feasible in any of them")
        most = max(map(len, found))
        goals = np.zeros((len(found), most), GOAL)
        goals["kind"], goals["joint"] = -1, -1
        for k, some in enumerate(found):
            goals[k, : len(some)] = some
        return cls(
            slots,
            _stacked([row.fields for row in rows]),
            _stacked(places) | {"goals": goals, "goal_count": np.array([len(some) for some in found], dtype=np.int32)},
            [row.names for row in rows],
            [
                [t.instruction for t in room.tasks if has_goal(t, row.names)]
                for room, row in zip(rooms, rows, strict=True)
            ],
            [row.dropped for row in rows],
        )

    def keep(self, rows: np.ndarray) -> Bank:
        """The bank with some of its layouts, by a mask [V] or their numbers."""
        return replace(self, layout={name: values[rows] for name, values in self.layout.items()})

    def save(self, path: str | Path) -> None:
        """As one compressed ``.npz`` file."""
        arrays = {f"room/{k}": v for k, v in self.room.items()} | {f"layout/{k}": v for k, v in self.layout.items()}
        about = {name: getattr(self, name) for name in ("names", "instructions", "dropped")}
        about["slots"] = asdict(self.slots)
        with whole(path, through_link=True) as temporary, open_writable(temporary, "xb") as file:
            np.savez_compressed(file, allow_pickle=False, about=np.array(json.dumps(about)), **arrays)

    @classmethod
    def load(cls, path: str | Path) -> Bank:
        """What ``save`` wrote.

        Raises:
            InputError: it is no such file, or damaged.
        """
        try:
            return cls._of(read_arrays(path))
        except InputError as error:
            text = str(error)
            raise InputError(text if text.startswith(Path(path).name) else f"{Path(path).name}: {text}") from None
        except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
            raise InputError(f"{Path(path).name}: no bank of rooms, or damaged ({reason(error)})") from None

    @classmethod
    def _of(cls, arrays: dict[str, np.ndarray]) -> Bank:
        about: Any = parse_json(str(arrays["about"]))
        parts = [
            {key.partition("/")[2]: values for key, values in arrays.items() if key.startswith(f"{name}/")}
            for name in ("room", "layout")
        ]
        still, *moving = about["slots"].values()
        slots = Slots(still, *map(tuple, moving))
        parts[1]["goals"] = parts[1]["goals"].view(GOAL)  # older files name its poses otherwise
        return cls(slots, parts[0], parts[1], about["names"], about["instructions"], about["dropped"])


@dataclass(frozen=True)
class _Read:
    bodies: RoomBodies
    tasks: tuple[TaskRow, ...]
    poses: np.ndarray


def _read(
    scene: Scene, layouts: Any, *, robot: Robot, kinds: Sequence[type[Task]], load: Load | None, anchored: float
) -> _Read:
    """A room with its tasks and layouts; what takes the time."""
    poses = layouts_of(scene, layouts)
    tasks = task_rows(SceneGeometry(scene, load, loose=False), robot, poses[0], kinds)
    return _Read(bodies_of(scene, load, anchored), tasks, poses)


def _stacked(rows: Sequence[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """Rows with equal names as one array for each name."""
    return {name: np.stack([row[name] for row in rows]) for name in rows[0]}


@dataclass(frozen=True)
class _Row:
    fields: dict[str, np.ndarray]
    names: list[str]
    still: Boxes
    moving: list[MovingBody | None]
    dropped: int


def _chosen(room: RoomBodies, kind: int, most: int) -> list[MovingBody]:
    """The bodies of a kind that get a slot, those of the most boxes first."""
    if kind == FREE:
        first = sorted(room.free, key=lambda b: abs(np.log(b.mass / _NEAR)))
    else:  # a leaf of the room's doors before others, then the largest
        some = [b for b in room.links if b.kind == kind]
        first = sorted(some, key=lambda b: (b.owner >= 0, -float(np.prod(b.boxes.size, axis=1).sum())))
    return sorted(first[:most], key=lambda b: -len(b.boxes))


def _still(room: RoomBodies, hinges: int, slides: int, free: int) -> Boxes:
    """What stands still: of the room, and what gets no slot; the largest first."""
    kept = {
        b.name for kind, most in ((HINGE, hinges), (SLIDE, slides), (FREE, free)) for b in _chosen(room, kind, most)
    }
    found = [room.still] + [_on_owner(b) for b in (*room.links, *room.free) if b.name not in kept]
    boxes = Boxes.joined(found)
    face = np.prod(np.sort(boxes.size, axis=1)[:, 1:], axis=1)  # of a board what counts is how much it carries
    return boxes.take(np.argsort(-face, kind="stable"))


def _on_owner(body: MovingBody) -> Boxes:
    """The boxes of a body in the frame of its owner, where it is closed."""
    b = body.boxes
    pos = body.pos + b.pos @ matrix(xyzw(body.quat)).T
    quat = product(body.quat, b.quat)
    return Boxes(np.full(len(b), body.owner), pos, quat, b.size, b.friction)


def _room_row(room: RoomBodies, slots: Slots) -> _Row:
    counts = len(slots.hinges), len(slots.slides), len(slots.free)
    still = _still(room, *counts)
    dropped = max(0, len(still) - slots.still)
    still = still.take(np.arange(min(len(still), slots.still)))
    moving: list[MovingBody | None] = []
    for kind, most in zip((HINGE, SLIDE, FREE), counts, strict=True):
        some = _chosen(room, kind, most)
        moving += [*some, *[None] * (most - len(some))]
    f = _empty(slots)
    n = len(still)
    f["geom_size"][:n], f["geom_friction"][:n] = still.size, still.friction
    geom, dof = slots.still, 0
    for k, (body, parts) in enumerate(zip(moving, slots.parts, strict=True)):
        free = k >= slots.links
        if body is not None:
            b, m = body.boxes.take(np.arange(min(len(body.boxes), parts))), geom + min(len(body.boxes), parts)
            f["geom_size"][geom:m], f["geom_friction"][geom:m] = b.size, b.friction
            f["geom_pos"][geom:m], f["geom_quat"][geom:m] = b.pos, b.quat
            f["geom_pos"][m : geom + parts] = b.pos[0]  # unused: inside of its largest, where nothing comes
            dropped += max(0, len(body.boxes) - parts)
            f["body_gravcomp"][k] = 0.0
            for name in BODY_FIELDS:
                f[name][k] = body.body[name]
            for name in DOF_FIELDS:
                f[name][dof : dof + (6 if free else 1)] = body.joint[name]
            if not free:
                for name in JOINT_FIELDS:
                    f[name][k] = body.joint[name]
        geom, dof = geom + parts, dof + (6 if free else 1)
    return _Row(f, ["" if b is None else b.name for b in moving], still, moving, dropped)


UNUSED: dict[str, Any] = {
    "geom_size": [_TINY] * 3,
    "geom_friction": [0.5, 0.005, 0.0001],
    "geom_pos": [0.0] * 3,
    "geom_quat": [1.0, 0.0, 0.0, 0.0],
    "body_gravcomp": 1.0,
    "body_ipos": [0.0] * 3,
    "body_iquat": [1.0, 0.0, 0.0, 0.0],
    "body_mass": 1.0,
    "body_inertia": [1.0] * 3,
    "body_invweight0": [1.0] * 2,
    "body_subtreemass": 1.0,
    "jnt_pos": [0.0] * 3,
    "jnt_axis": [0.0, 0.0, 1.0],
    "jnt_range": [-1.0, 1.0],
    "dof_frictionloss": 0.0,
    "dof_damping": 1.0,
    "dof_armature": 0.0,
    "dof_invweight0": 1.0,
}
"""Fields of the model for a slot that a room does not use."""


def _empty(slots: Slots) -> dict[str, np.ndarray]:
    """The fields of a room that uses no slot."""
    count = {"geom": slots.geoms, "body": len(slots.parts), "jnt": slots.links, "dof": slots.dofs}
    return {
        name: np.tile(np.asarray(row, dtype=np.float32), (count[name.partition("_")[0]], *[1] * np.ndim(row)))
        for name, row in UNUSED.items()
    }


def _layout_row(row: _Row, slots: Slots, poses: np.ndarray, number: int) -> dict[str, np.ndarray]:
    """Where everything is; ``poses`` [N, 7] (position, w, x, y, z) of the room's objects."""
    world = np.concatenate([np.asarray(poses, dtype=float), [[0, 0, 0, 1.0, 0, 0, 0]]])  # the last: the room itself
    turns, quats = matrix(xyzw(world[:, 3:])), world[:, 3:]
    still_pos = _parked(slots.still, 0)
    still_quat = np.tile([1.0, 0, 0, 0], (slots.still, 1))
    owner, n = row.still.owner, len(row.still)
    still_pos[:n] = world[owner, :3] + np.einsum("kij,kj->ki", turns[owner], row.still.pos)
    still_quat[:n] = product(quats[owner], row.still.quat)
    count = len(slots.parts)
    pos, quat = _parked(count, slots.still), np.tile([1.0, 0, 0, 0], (count, 1))
    for k, body in enumerate(row.moving):
        if body is not None:
            pos[k] = world[body.owner, :3] + turns[body.owner] @ body.pos
            quat[k] = product(quats[body.owner], body.quat)
    found = {
        "still_pos": still_pos,
        "still_quat": still_quat,
        "link_pos": pos[: slots.links],
        "link_quat": quat[: slots.links],
        "free_pose": np.concatenate([pos, quat], axis=1)[slots.links :],
    }
    return {"room": np.array(number, dtype=np.int32)} | {
        name: values.astype(np.float32) for name, values in found.items()
    }


def _parked(count: int, begin: int) -> np.ndarray:
    """Places [count, 3] of their own for what is not used."""
    k = begin + np.arange(count)
    return np.stack([k % 16, k // 16 % 16, PARKED + k // 256], axis=1).astype(float)


PLACES = 16
"""Places of a layout where the robot may begin."""

_GRID = 0.1  # [m] between places that are looked at
_OVER = 1.6  # [m]: what hangs higher is in nobody's way


def spawns(room: Room, row: _Row, slots: Slots, place: dict[str, np.ndarray], radius: float) -> np.ndarray:
    """Free places [P, 3] (x, y [m], yaw [rad]) of a robot's base of that radius [m], spread over the floor.

    Where none is free the one with the most room.
    """
    from shapely import Polygon, STRtree, box, contains_xy
    from shapely import points as shapely_points

    size = row.fields["geom_size"]
    turn = matrix(xyzw(place["still_quat"]))
    half = np.einsum("kij,kj->ki", np.abs(turn), size[: slots.still])
    boxes = [(place["still_pos"] - half, place["still_pos"] + half)]
    geom = slots.still
    frames = np.concatenate([np.concatenate([place["link_pos"], place["link_quat"]], axis=1), place["free_pose"]])
    for body, parts, frame in zip(row.moving, slots.parts, frames, strict=True):
        rows = slice(geom, geom + parts)
        geom += parts
        if body is not None:
            own = matrix(xyzw(frame[3:]))
            middle = frame[:3] + row.fields["geom_pos"][rows] @ own.T
            half = np.einsum("kij,kj->ki", np.abs(own @ matrix(xyzw(row.fields["geom_quat"][rows]))), size[rows])
            boxes.append((middle - half, middle + half))
    low, high = (np.concatenate(ends) for ends in zip(*boxes, strict=True))
    near = (low[:, 2] < _OVER) & (high[:, 2] > 0.02)
    low, high = low[near, :2], high[near, :2]
    outline = np.asarray(room.outline)
    (x0, y0), (x1, y1) = outline.min(axis=0), outline.max(axis=0)
    x, y = (v.ravel() for v in np.meshgrid(np.arange(x0, x1, _GRID), np.arange(y0, y1, _GRID)))
    inside = contains_xy(Polygon(outline), x, y)
    points = np.stack([x[inside], y[inside]], axis=1)
    if not len(points):
        points = outline.mean(axis=0)[None]
    clear = np.full(len(points), np.inf)
    if len(low):
        tree = STRtree(box(*low.T, *high.T))
        clear = tree.query_nearest(shapely_points(points), return_distance=True, all_matches=False)[1]
    rng = np.random.default_rng(len(points))
    free = np.flatnonzero(clear > radius + 0.02)
    chosen = rng.choice(free, PLACES) if len(free) else np.full(PLACES, int(np.argmax(clear)))
    return np.column_stack([points[chosen], rng.uniform(-np.pi, np.pi, PLACES)]).astype(np.float32)
