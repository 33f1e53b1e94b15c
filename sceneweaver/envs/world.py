"""A room with a robot as one MuJoCo model, and its state as tasks see it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load, loader, welded_assets
from sceneweaver.export.mjcf_clients import SLEEP_TOLERANCE
from sceneweaver.physics import build
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import InputError, Scene

from .geometry import SceneGeometry
from .joining import PREFIX, attach, indices_of
from .robots import Robot

Array = np.ndarray


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
        indices: Where the robot is in it.

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
        self.model = model = _compile(scene, robot, load, visual)
        geometry = self.geometry  # from here on: numbers of what is read and written at every step
        self.item_names = tuple(geometry.items)
        self.joint_names = tuple(geometry.articulations)
        bodies = (*geometry.items, *geometry.articulations)
        self._bodies = {name: model.body(name).id for name in bodies}
        self.item_ids = np.array([self._bodies[name] for name in self.item_names], dtype=int)
        self.joint_addresses = np.array([model.joint(name).qposadr[0] for name in self.joint_names], dtype=int)
        self.indices = indices_of(model, robot)

    @cached_property
    def robot_geoms(self) -> Array:
        """Which geoms [ngeom] bool are the robot's."""
        return self.model.body_rootid[self.model.geom_bodyid] == self.indices.body

    def new_data(self) -> Any:
        """A fresh ``mujoco.MjData``."""
        return load_mujoco().MjData(self.model)

    def place(self, data: Any, layout: Array, base: Array, joints: Mapping[str, float] | None = None) -> None:
        """Put everything where it starts: nothing of what went before is left.

        Args:
            data: The simulation.
            layout: Poses [N, 7] of the scene's objects.
            base: Where the robot stands: x, y [m], yaw [rad].
            joints: Positions of doors and drawers by name; all others are closed.
        """
        mujoco = load_mujoco()
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
        load_mujoco().mj_forward(self.model, data)

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
        at = self.indices
        if len(at.base):
            data.qpos[at.base] = base
        else:
            root = self.model.body(at.body)
            root.pos[:] = base[0], base[1], 0.0
            root.quat[:] = np.cos(base[2] / 2), 0.0, 0.0, np.sin(base[2] / 2)
        data.ctrl[at.drive] = data.qpos[at.drive_position]
        data.ctrl[at.fingers] = self.model.actuator_ctrlrange[at.fingers, 1]
        for number, position in zip(at.fingers, at.finger_position, strict=True):
            if position >= 0:
                data.qpos[position] = data.ctrl[number]

    def base(self, data: Any) -> Array:
        """Where the robot's base stands: x, y [m], yaw [rad]."""
        if len(self.indices.base):
            return data.qpos[self.indices.base].copy()
        root = self.model.body(self.indices.body)
        return np.array([*root.pos[:2], 2 * np.arctan2(root.quat[3], root.quat[0])])

    def pose(self, data: Any, name: str) -> Array:
        """The pose [7] of a body of the scene."""
        number = self._bodies[name]
        return np.concatenate([data.xpos[number], data.xquat[number]])

    def tool(self, data: Any) -> Array:
        """The pose [7] of the tool's site."""
        turn = np.empty(4)
        load_mujoco().mju_mat2Quat(turn, data.site_xmat[self.indices.tool])
        return np.concatenate([data.site_xpos[self.indices.tool], turn])

    def gripper_opening(self, data: Any) -> float:
        """How far the gripper is open by the targets of its actuators' joints: 0 closed, 1 open."""
        fingers = self.indices.fingers
        if not len(fingers):
            return 0.0
        low, high = self.model.actuator_ctrlrange[fingers].T
        return float(np.clip((data.actuator_length[fingers] - low) / (high - low), 0, 1).mean())

    def state(self, data: Any) -> RoomState:
        """What tasks look at, copied from the simulation."""
        poses = np.hstack([data.xpos, data.xquat])
        bodies = {name: poses[number] for name, number in self._bodies.items()}
        joints = dict(zip(self.joint_names, data.qpos[self.joint_addresses].tolist(), strict=True))
        return RoomState(bodies, joints, self.tool(data), self.base(data))


def _compile(scene: Scene, robot: Robot, load: Load, visual: bool) -> Any:
    mujoco = load_mujoco()
    if visual:
        from sceneweaver.export.mjcf import mjcf

        made = mjcf(scene, load)
    else:
        made = build(scene, load)
    room = mujoco.MjSpec.from_string(made.xml, assets=made.files)
    attach(room, robot)
    for key in list(room.keys):
        room.delete(key)  # they know nothing of the robot
    room.option.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    room.option.sleep_tolerance = SLEEP_TOLERANCE
    try:
        return room.compile()
    except ValueError as error:
        raise InputError(f"robot: {robot.name} does not fit into the room's model ({error})") from None
