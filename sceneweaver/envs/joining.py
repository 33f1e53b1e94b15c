"""A robot in the model of a room: how it joins, and where its joints, actuators and sites are then."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.io import read_spec
from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import InputError

from .robots import Robot

Array = np.ndarray

PREFIX = "robot:"
"""Before every name of the robot's in the model."""


@dataclass(frozen=True, eq=False)
class RobotIndices:
    """Where a robot is in a model; D joints are driven: those of the base, then those of the arm.

    Attributes:
        body: Its root body.
        tool: Its site between the fingertips.
        base: Positions in ``qpos`` of its base's x, y and yaw; empty for a robot that stands on its place.
        drive: [D] position actuators of the driven joints.
        drive_position, drive_dof: [D] their positions in ``qpos`` and degrees of freedom.
        speeds: [D] their top speeds [rad/s] or [m/s].
        fingers: Actuators of the gripper; ``finger_position`` where their joints are in ``qpos``; -1: it has no joint.
    """

    body: int
    tool: int
    base: Array
    drive: Array
    drive_position: Array
    drive_dof: Array
    speeds: Array
    fingers: Array
    finger_position: Array


def attach(spec: Any, robot: Robot, touching: int = 0) -> None:
    """Put a robot into a ``mujoco.MjSpec``, its names after ``PREFIX``; its keyframes are left out.

    Args:
        spec: The model.
        robot: The robot.
        touching: Bits of contact that its parts get besides their own, where they touch anything.

    Raises:
        InputError: its MJCF cannot be read, or does not fit.
    """
    mujoco = load_mujoco()
    try:
        if robot.folder is None:
            own = mujoco.MjSpec.from_string(robot.xml)
        else:
            own = read_spec(robot.folder / f"{robot.name}.xml")
        for key in list(own.keys):
            own.delete(key)
        for geom in own.geoms:
            if geom.contype or geom.conaffinity:
                geom.conaffinity |= touching
        spec.attach(own, prefix=PREFIX, frame=spec.worldbody.add_frame())
    except (ValueError, TypeError) as error:
        raise InputError(f"robot: {robot.name} does not fit into the room's model ({error})") from None


def indices_of(model: Any, robot: Robot) -> RobotIndices:
    """Where a robot is in a compiled model.

    Raises:
        InputError: a joint, actuator or site that it names is not there.
    """
    driven = [*robot.base, *robot.arm]
    joints = [_named(model.joint, name, "base or arm") for name in driven]
    fingers = np.array([_named(model.actuator, name, "gripper") for name in robot.gripper], dtype=int)
    jointed = model.actuator_trntype[fingers] == load_mujoco().mjtTrn.mjTRN_JOINT
    addresses = model.jnt_qposadr.astype(int)
    return RobotIndices(
        next(k for k in range(model.nbody) if model.body(k).name.startswith(PREFIX)),
        _named(model.site, robot.tool, "tool"),
        addresses[joints[: len(robot.base)]],
        np.array([_actuator_of(model, joint) for joint in joints], dtype=int),
        addresses[joints],
        model.jnt_dofadr[joints].astype(int),
        np.array([robot.speeds.get(name, 1.0) for name in driven]),
        fingers,
        np.where(jointed, addresses[np.where(jointed, model.actuator_trnid[fingers, 0], 0)], -1),
    )


def _named(find: Any, name: str, what: str) -> int:
    try:
        return find(PREFIX + name).id
    except KeyError:
        raise InputError(f"robot: {what} '{name}' is not in its MJCF") from None


def _actuator_of(model: Any, joint: int) -> int:
    """The number of the position actuator of a joint."""
    for number in range(model.nu):
        if model.actuator_trnid[number, 0] == joint and model.actuator_trntype[number] == 0:
            return number
    raise InputError(f"robot: joint '{model.joint(joint).name.removeprefix(PREFIX)}' has no actuator")
