"""Rooms as Gymnasium environments."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load, loader
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError, Scene

from .control import Control, Controller, control_named
from .geometry import SceneGeometry
from .layouts import layouts_of
from .navigation import FloorMap, entrance
from .pictures import Pictures
from .robots import Robot, robot_named
from .sampling import task_named, tasks_of
from .tasks import Task, Tidy
from .world import RoomState, World

try:
    import gymnasium
except ImportError:
    raise MissingDependencyError(missing_extra("envs", "gymnasium is not installed")) from None

Array = np.ndarray

PERIOD = 0.04
"""Time between two actions [s]."""

_WIDEST = 1e6  # bound of numbers of observations that have none
_KEPT = 8  # models of rooms that are kept
_NEAR = 0.35  # [m] between the spawn point inside a door and where a robot begins, about


class RoomEnv(gymnasium.Env):
    """A room, a robot and a task.

    Observations are a dict of float32 arrays (``objects`` and ``doors`` are filled up with zeros where rooms differ):

    - ``robot`` [2 n]: positions and velocities of the driven joints, base first;
    - ``base`` [3]: x, y, yaw of the base in the room; ``tool`` [7]: pose of the tool's site;
    - ``gripper`` [1]: how far it is open, 0..1;
    - ``subject`` [7]: pose of the body that the task is about; ``goal`` [3]: the point where it, or the base, is to go;
    - ``objects`` [N, 7]: poses of objects and of what can be taken; ``doors`` [L]: how far each is open, 0..1;
    - ``image`` uint8 [H, W, 3] from the eye of the robot's mast, where ``image_size`` is given.

    Poses are position [m] and quaternion (w, x, y, z). ``info`` has ``instruction``, ``task``, ``scene``, ``layout``
    and ``success``. All that is random comes from the seed of `reset`; the same seed and actions give the same
    observations.

    Args:
        scenes: One scene, a path of one, or a list; `reset` chooses.
        task: Words, a `Task`, or None: one of those that are feasible, another at each reset.
        robot: "mobile", "arm" or a `Robot`.
        layouts: Of a single scene; see `layouts_of`. `reset` chooses one.
        control: "joint" or "ee"; see `Controller`.
        seed: Of the first `reset` that has none.
        max_steps: After which an episode is cut off.
        image_size: (height, width) of ``image``; it needs OpenGL, as with ``MUJOCO_GL=egl``.
        render_mode: "rgb_array" or None; pictures are drawn by MuJoCo.
        load: From asset id to asset; None: the library of this user.
        loose: Whether fruit in a bowl and the like are bodies of their own.

    Raises:
        InputError: something of this is wrong, or no task is feasible.
        MissingDependencyError: Gymnasium is not installed.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import RoomEnv
        >>> env = RoomEnv(sw.Scene.example("bedroom"), task="go to the bed")
        >>> observation, info = env.reset(seed=0)
        >>> info["instruction"]
        'go to the bed'
        >>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
        >>> env.close()
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": round(1 / PERIOD)}

    # Options of an environment are keyword arguments, as `gymnasium.make` hands them over by name, hence more than ten.
    def __init__(
        self,
        scenes: Scene | str | os.PathLike[str] | Sequence[Scene | str | os.PathLike[str]],
        task: str | Task | None = None,
        *,
        robot: str | Robot = "mobile",
        layouts: Any = None,
        control: str = "joint",
        seed: int | None = None,
        max_steps: int = 2500,
        image_size: tuple[int, int] | None = None,
        render_mode: str | None = None,
        load: Load | None = None,
        loose: bool = True,
    ) -> None:
        """Build the model of the first scene."""
        listed = [scenes] if isinstance(scenes, Scene | str | os.PathLike) else list(scenes)
        if not listed:
            raise InputError("scenes: none is given; give at least one")
        if layouts is not None and len(listed) > 1:
            raise InputError("layouts: they are those of one scene; give one, or scenes alone")
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise InputError(f"render_mode: '{render_mode}' is not known; use rgb_array or None")
        self.scenes = tuple(one if isinstance(one, Scene) else Scene.load(one) for one in listed)
        self.robot, self.max_steps = robot_named(robot), max_steps
        self.control: Control = control_named(control)
        self.render_mode, self.image_size = render_mode, image_size
        self._asked, self._first_seed, self._loose = task, seed, loose
        self._load = loader(load)
        self._visual = render_mode is not None or image_size is not None
        self._layouts = [layouts_of(scene, layouts if len(listed) == 1 else None) for scene in self.scenes]
        self._world = lru_cache(_KEPT)(self._make_world)
        self._pictures: Pictures | None = None
        self._open_scene(0)
        sizes = [_sizes(scene, self._load, loose) for scene in self.scenes] if len(listed) > 1 else []
        items, doors = len(self.world.item_names), len(self.world.joint_names)
        self._most = max([items, *(s[0] for s in sizes)]), max([doors, *(s[1] for s in sizes)])
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (self._controller.size,), np.float32)
        self.observation_space = self._observation_space()

    @property
    def tasks(self) -> tuple[Task, ...]:
        """Those that are feasible in the room that is open now."""
        return tuple(tasks_of(self.world.geometry, self.robot, self._rest.bodies))

    def reset(self, *, seed: int | None = None, options: Mapping[str, Any] | None = None) -> tuple[dict, dict]:
        """Begin an episode.

        Args:
            seed: Of all that is random from now on; None: go on as before.
            options: ``scene`` and ``layout``: their numbers; ``base``: x, y, yaw of the robot; ``task``: as for the
                environment.
        """
        if seed is None and self._first_seed is not None:
            seed, self._first_seed = self._first_seed, None
        super().reset(seed=seed)
        options = options or {}
        number = int(options.get("scene", self.np_random.integers(len(self.scenes))))
        self._open_scene(number)
        self._layout = int(options.get("layout", self.np_random.integers(len(self._layouts[number]))))
        layout = self._layouts[number][self._layout]
        self.world.place(self.data, layout, self._corner())
        self._rest = self.world.state(self.data)
        self.task = self._choose_task(options.get("task", self._asked))
        joints = self.task.start_joints(self.world.geometry)
        self.world.place(self.data, layout, self._corner(), joints)
        if isinstance(self.task, Tidy):
            self._scatter(self.task)
        base = options.get("base")
        self.world.place_robot(self.data, self._start_base() if base is None else np.asarray(base, dtype=float))
        self.world.forward(self.data)
        self.start = self.world.state(self.data)
        self._steps = 0
        self._potential = self.task.potential(self.world.geometry, self.start, self.start)
        return self._observe(self.start), self._info(self.start)

    def step(self, action: Array) -> tuple[dict, float, bool, bool, dict]:
        """Go on by `PERIOD` with one action; see `Controller`."""
        self._controller.apply(self.data, np.asarray(action))
        mujoco = load_mujoco()
        mujoco.mj_step(self.world.model, self.data, self._substeps)
        mujoco.mj_kinematics(self.world.model, self.data)
        state = self.world.state(self.data)
        self._steps += 1
        info = self._info(state)
        before, self._potential = self._potential, self.task.potential(self.world.geometry, state, self.start)
        reward = self._potential - before + float(info["success"])
        return self._observe(state), reward, info["success"], self._steps >= self.max_steps, info

    def render(self) -> Array | None:
        """The room from above the door, uint8 [480, 640, 3]; None without a render mode."""
        return None if self.render_mode is None else self._drawn().overview(self.data)

    def close(self) -> None:
        """Let go of the renderer."""
        if self._pictures is not None:
            self._pictures.close()
            self._pictures = None

    @property
    def state(self) -> RoomState:
        """What tasks look at, now."""
        return self.world.state(self.data)

    def _drawn(self) -> Pictures:
        if self._pictures is None:
            self._pictures = Pictures(self.world)
        return self._pictures

    def _make_world(self, number: int) -> World:
        return World(self.scenes[number], self.robot, self._load, visual=self._visual, loose=self._loose)

    def _open_scene(self, number: int) -> None:
        self.world = self._world(number)
        if getattr(self, "_opened", None) != number:
            self.close()
            self._opened = number
            self.data = self.world.new_data()
            self._controller = Controller(self.world, self.control, PERIOD)
            self._substeps = max(round(PERIOD / self.world.model.opt.timestep), 1)
            self.world.place(self.data, self._layouts[number][0], self._corner())
            self._rest = self.world.state(self.data)

    def _choose_task(self, asked: str | Task | None) -> Task:
        if isinstance(asked, Task):
            return asked
        tasks = self.tasks
        if asked is not None:
            return task_named(asked, tasks, self.world.geometry)
        if not tasks:
            raise InputError(f"task: none is feasible in scene '{self.world.scene.id}' with robot '{self.robot.name}'")
        kinds = sorted({type(task).__name__ for task in tasks})
        kind = kinds[self.np_random.integers(len(kinds))]
        those = [task for task in tasks if type(task).__name__ == kind]
        return those[self.np_random.integers(len(those))]

    def _corner(self) -> Array:
        """Outside the room, where the robot is in nobody's way while the room is looked at."""
        low = np.min(self.world.scene.room.outline, axis=0)
        return np.array([low[0] - 3.0, low[1] - 3.0, 0.0])

    def _start_base(self) -> Array:
        """A free place: for a robot that drives near a door, else in front of what its task is about."""
        floor = FloorMap(self.world, self.data)
        goal = self.task.goal(self.world.geometry, self.world.state(self.data))
        if not floor.free.any():
            raise InputError(f"scene '{self.world.scene.id}' has no free floor for robot '{self.robot.name}'")
        if self.robot.base:
            near = entrance(self.world.scene, floor)
            reached = floor.reached(near)
            gap = np.linalg.norm(floor.points - near, axis=-1)
            places = floor.points[reached & (gap < gap[reached].min() + _NEAR)]
        else:
            gap = np.linalg.norm(floor.points - goal[:2], axis=-1)
            places = floor.points[floor.free & (np.abs(gap - 0.7 * self.robot.reach) < 0.15 * self.robot.reach)]
            places = places if len(places) else floor.points[floor.cell(goal[:2])][None]
        place = places[self.np_random.integers(len(places))]
        yaw = np.arctan2(goal[1] - place[1], goal[0] - place[0])
        return np.array([*place, yaw])

    def _scatter(self, task: Tidy) -> None:
        """Things of a tidy-up stand somewhere on the free floor."""
        self.world.forward(self.data)
        for name in task.scattered:
            floor = FloorMap(self.world, self.data)
            places = floor.points[floor.free]
            item = self.world.geometry.items[name]
            place = places[self.np_random.integers(len(places))]
            self.world.set_pose(self.data, name, np.array([*place, 0.002 - item.low[2], 1.0, 0, 0, 0]))
            self.world.forward(self.data)

    def _observation_space(self) -> Any:
        box, spaces = gymnasium.spaces.Box, gymnasium.spaces
        driven, (items, doors) = len(self.world.indices.drive), self._most

        def real(*shape: int) -> Any:
            return box(-_WIDEST, _WIDEST, shape, np.float32)

        found = {"robot": real(2 * driven), "base": real(3), "tool": real(7), "subject": real(7), "goal": real(3)}
        found |= {"gripper": box(0.0, 1.0, (1,), np.float32), "objects": real(items, 7)}
        found["doors"] = box(0.0, 1.0, (doors,), np.float32)
        if self.image_size is not None:
            found["image"] = box(0, 255, (*self.image_size, 3), np.uint8)
        return spaces.Dict(found)

    def _observe(self, state: RoomState) -> dict[str, Array]:
        world, data = self.world, self.data
        driven = data.qpos[world.indices.drive_position], data.qvel[world.indices.drive_dof]
        objects, doors = np.zeros((self._most[0], 7)), np.zeros(self._most[1])
        objects[: len(world.item_names)] = np.hstack([data.xpos[world.item_ids], data.xquat[world.item_ids]])
        ends = np.array([world.geometry.articulations[name].open_end for name in world.joint_names])
        doors[: len(ends)] = np.clip(data.qpos[world.joint_addresses] / ends, 0, 1)
        found: dict[str, Array] = {
            "robot": np.concatenate(driven),
            "base": state.base,
            "tool": state.tool,
            "subject": state.bodies[self.task.subject],
            "goal": self.task.goal(world.geometry, state),
            "gripper": np.array([world.gripper_opening(data)]),
            "objects": objects,
            "doors": doors,
        }
        found = {name: value.astype(np.float32) for name, value in found.items()}
        if self.image_size is not None:
            found["image"] = self._drawn().mast(self.data, self.image_size)
        return found

    def _info(self, state: RoomState) -> dict[str, Any]:
        success = self.task.success(self.world.geometry, state, self.start)
        words = self.task.instruction(self.world.geometry)
        where = {"scene": self.world.scene.id, "layout": self._layout}
        return {"instruction": words, "task": self.task, "success": success, **where}


def _sizes(scene: Scene, load: Load, loose: bool) -> tuple[int, int]:
    """How many objects with what can be taken, and how many doors and drawers a scene has."""
    geometry = SceneGeometry(scene, load, loose=loose)
    return len(geometry.items), len(geometry.articulations)
