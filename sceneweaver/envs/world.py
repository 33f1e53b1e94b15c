"""A room with a robot as one MuJoCo model, and its state as tasks see it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load, loader, welded_assets
from sceneweaver.export.mjcf_clients import SLEEP_TOLERANCE
from sceneweaver.physics import build
from sceneweaver.scene import InputError, Scene

from .geometry import SceneGeometry
from .robots import Robot

Array = np.ndarray

PREFIX = "robot:"
"""Before every name of the robot's in the model."""


@dataclass(frozen=True)
class RoomState:
    """What tasks look at: poses [7] of bodies by name (position, w, x, y, z), positions of doors and drawers by name,
    the pose [7] of the tool's site, and the robot's base (x, y, yaw).

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import envs
        >>> env = envs.make(sw.Scene.example("bedroom"), "go to the bed", seed=0)
        >>> _ = env.reset()
        >>> env.state.tool.shape, env.state.base.shape
        ((7,), (3,))
    """

    bodies: Mapping[str, Array]
    joints: Mapping[str, float]
    tool: Array
    base: Array


class World:
    """The MuJoCo model of a scene with a robot in it.

    Attributes:
        scene, robot: What it was made of.
        geometry: Grasps, interiors, surfaces, doors and drawers of the scene.
        model: The ``mujoco.MjModel``.

    Args:
        scene: The room.
        robot: The robot.
        load: From asset id to asset; None: the library of this user.
        visual: Whether the meshes of assets are in the model, for pictures by MuJoCo.
        loose: As in `sceneweaver.physics.build`.

    Raises:
        InputError: an asset cannot be loaded, or the robot's names or its MJCF are wrong.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import World, mobile_manipulator
        >>> world = World(sw.Scene.example("bedroom"), mobile_manipulator())
        >>> world.model.nu
        11
    """

    def __init__(
        self, scene: Scene, robot: Robot, load: Load | None = None, *, visual: bool = False, loose: bool = True
    ) -> None:
        """Build and compile the model."""
        load = loader(load if loose else welded_assets(load))
        self.scene, self.robot = scene, robot
        self.geometry = SceneGeometry(scene, load)
        self.model = _compile(scene, robot, load, visual)
        self._find()

    def _find(self) -> None:
        """Numbers of what is read and written at every step."""
        model, robot, geometry = self.model, self.robot, self.geometry
        self.item_names = tuple(geometry.items)
        self.joint_names = tuple(geometry.articulations)
        bodies = (*geometry.items, *geometry.articulations)
        self._bodies = {name: model.body(name).id for name in bodies}
        self.item_ids = np.array([self._bodies[name] for name in self.item_names], dtype=int)
        self.joint_addresses = np.array([model.joint(name).qposadr[0] for name in self.joint_names], dtype=int)
        self._tool = _named(model.site, PREFIX + robot.tool, "tool")
        driven = [*robot.base, *robot.arm]
        joints = [_named(model.joint, PREFIX + name, "base or arm") for name in driven]
        self.driven_addresses = model.jnt_qposadr[joints].astype(int)
        self.driven_dofs = model.jnt_dofadr[joints].astype(int)
        self.actuators = np.array([_actuator_of(model, joint) for joint in joints], dtype=int)
        self.gripper = np.array([_named(model.actuator, PREFIX + n, "gripper") for n in robot.gripper], dtype=int)
        self.speeds = np.array([robot.speeds.get(name, 1.0) for name in driven])
        self._root = next(k for k in range(model.nbody) if model.body(k).name.startswith(PREFIX))
        self._base_joints = self.driven_addresses[: len(robot.base)]

    @cached_property
    def robot_geoms(self) -> Array:
        """Which geoms [ngeom] bool are the robot's."""
        return self.model.body_rootid[self.model.geom_bodyid] == self._root

    def new_data(self) -> Any:
        """A fresh ``mujoco.MjData``."""
        return import_module("mujoco").MjData(self.model)

    def place(self, data: Any, layout: Array, base: Array, joints: Mapping[str, float] | None = None) -> None:
        """Put everything where it starts: nothing of what went before is left.

        Args:
            data: The simulation.
            layout: Poses [N, 7] of the scene's objects.
            base: Where the robot stands: x, y [m], yaw [rad].
            joints: Positions of doors and drawers by name; all others are closed.
        """
        mujoco = import_module("mujoco")
        mujoco.mj_resetData(self.model, data)
        for thing, pose in zip(self.geometry.things, layout, strict=True):
            for body in thing.bodies:
                if body.number == 0 or body.loose:
                    self.set_pose(data, body.name, pose)
        for name, position in (joints or {}).items():
            data.joint(name).qpos[0] = position
        for name, position in self.robot.home.items():
            data.joint(PREFIX + name).qpos[0] = position
        self.place_robot(data, base)
        self.forward(data)

    def forward(self, data: Any) -> None:
        """Bring poses of bodies and contacts up to date after positions were set."""
        import_module("mujoco").mj_forward(self.model, data)

    def set_pose(self, data: Any, name: str, pose: Array) -> None:
        """Put a body [7] somewhere; one that stands still is moved in the model."""
        body = self.model.body(self._bodies[name])
        if self.geometry.items[name].free:
            address = self.model.jnt_qposadr[body.jntadr[0]]
            data.qpos[address : address + 7] = pose
        else:
            body.pos[:], body.quat[:] = pose[:3], pose[3:]

    def place_robot(self, data: Any, base: Array) -> None:
        """Put the base of the robot at x, y [m] and yaw [rad]; the targets of its joints are where they are."""
        if len(self._base_joints):
            data.qpos[self._base_joints] = base
        else:
            root = self.model.body(self._root)
            root.pos[:] = base[0], base[1], 0.0
            root.quat[:] = np.cos(base[2] / 2), 0.0, 0.0, np.sin(base[2] / 2)
        data.ctrl[self.actuators] = data.qpos[self.driven_addresses]
        data.ctrl[self.gripper] = self.model.actuator_ctrlrange[self.gripper, 1]
        for number in self.gripper:
            joint, kind = self.model.actuator_trnid[number, 0], self.model.actuator_trntype[number]
            if kind == import_module("mujoco").mjtTrn.mjTRN_JOINT:
                data.qpos[self.model.jnt_qposadr[joint]] = data.ctrl[number]

    def base(self, data: Any) -> Array:
        """Where the robot's base stands: x, y [m], yaw [rad]."""
        if len(self._base_joints):
            return data.qpos[self._base_joints].copy()
        root = self.model.body(self._root)
        return np.array([*root.pos[:2], 2 * np.arctan2(root.quat[3], root.quat[0])])

    def pose(self, data: Any, name: str) -> Array:
        """The pose [7] of a body of the scene."""
        number = self._bodies[name]
        return np.concatenate([data.xpos[number], data.xquat[number]])

    def tool(self, data: Any) -> Array:
        """The pose [7] of the tool's site."""
        turn = np.empty(4)
        import_module("mujoco").mju_mat2Quat(turn, data.site_xmat[self._tool])
        return np.concatenate([data.site_xpos[self._tool], turn])

    def gripper_opening(self, data: Any) -> float:
        """How far the gripper is open by the targets of its actuators' joints: 0 closed, 1 open."""
        if not len(self.gripper):
            return 0.0
        low, high = self.model.actuator_ctrlrange[self.gripper].T
        return float(np.clip((data.actuator_length[self.gripper] - low) / (high - low), 0, 1).mean())

    @property
    def tool_id(self) -> int:
        """Number of the tool's site."""
        return self._tool

    def state(self, data: Any) -> RoomState:
        """What tasks look at, copied from the simulation."""
        bodies = _Poses(self._bodies, np.hstack([data.xpos, data.xquat]))
        joints = dict(zip(self.joint_names, data.qpos[self.joint_addresses].tolist(), strict=True))
        return RoomState(bodies, joints, self.tool(data), self.base(data))


class _Poses(Mapping[str, Array]):
    """Poses [7] of bodies by name, over one array of all of them."""

    def __init__(self, numbers: Mapping[str, int], poses: Array) -> None:
        self._numbers, self._poses = numbers, poses

    def __getitem__(self, name: str) -> Array:
        return self._poses[self._numbers[name]]

    def __iter__(self) -> Iterator[str]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)


def _compile(scene: Scene, robot: Robot, load: Load, visual: bool) -> Any:
    mujoco: Any = import_module("mujoco")
    if visual:
        from sceneweaver.export.mjcf import mjcf

        made = mjcf(scene, load)
    else:
        made = build(scene, load)
    room = mujoco.MjSpec.from_string(made.xml, assets=made.files)
    try:
        if robot.folder is None:
            own = mujoco.MjSpec.from_string(robot.xml)
        else:
            own = mujoco.MjSpec.from_file(str(robot.folder / f"{robot.name}.xml"))
        for key in list(own.keys):
            own.delete(key)
        room.attach(own, prefix=PREFIX, frame=room.worldbody.add_frame())
        for key in list(room.keys):
            room.delete(key)  # they know nothing of the robot
        room.option.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        room.option.sleep_tolerance = SLEEP_TOLERANCE
        return room.compile()
    except ValueError as error:
        raise InputError(f"robot: {robot.name} does not fit into the room's model ({error})") from None


def _named(find: Any, name: str, what: str) -> int:
    try:
        return find(name).id
    except KeyError:
        raise InputError(f"robot: {what} '{name.removeprefix(PREFIX)}' is not in its MJCF") from None


def _actuator_of(model: Any, joint: int) -> int:
    """The number of the position actuator of a joint."""
    for number in range(model.nu):
        if model.actuator_trnid[number, 0] == joint and model.actuator_trntype[number] == 0:
            return number
    raise InputError(f"robot: joint '{model.joint(joint).name.removeprefix(PREFIX)}' has no actuator")
