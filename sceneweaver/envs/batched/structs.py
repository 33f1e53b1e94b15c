"""What kernels of a batch read and write: the robot, layouts, the simulation, episodes, observations.

W worlds, V layouts, R rooms, M moving bodies, D driven joints. Quaternions are (w, x, y, z), as MuJoCo Warp has them in
arrays of ``wp.quat``.
"""
# pyright: reportInvalidTypeForm=false
# The types of a struct's fields are calls.

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp


@wp.struct
class Goal:
    """One task of a layout, in the frames of its bodies."""

    kind: wp.int32  # number in `tasks.KINDS`; -1: none
    subject: wp.int32  # slot of the moving body that it is about; -1: that stands still, at `subject_pos`
    holder: wp.int32  # slot of the moving body that holds or carries the subject at the end; -1: as above
    joint: wp.int32  # slot of the link that is to be opened or closed; -1: none
    oval: wp.int32  # whether the interior is an ellipse in its plan
    share: wp.float32  # of the range; for `Take` the height [m], for `NavigateTo` the distance [m]
    open_end: wp.float32  # of the link's range [rad] or [m]
    begin: wp.float32  # where the link begins
    radius: wp.float32  # half the diagonal of the subject's box [m]
    centre: wp.vec3  # the point of the subject that counts, the grip of a link
    item_low: wp.vec3  # corners of the subject's box
    item_high: wp.vec3
    low: wp.vec3  # corners of the interior, or of the surface with its height as both z, in the holder's frame
    high: wp.vec3
    spot: wp.vec3  # where the subject is to stand there, at the bottom
    subject_pos: wp.vec3
    subject_quat: wp.quat
    holder_pos: wp.vec3
    holder_quat: wp.quat


_ROW: Any = Goal.numpy_dtype()
GOAL = np.dtype(_ROW)
"""A `Goal` in arrays of NumPy."""


@wp.struct
class RobotArrays:
    """Where the robot is in the model that all worlds share, as `joining.RobotIndices`."""

    base: wp.vec3i  # positions of the base's x, y and yaw in ``qpos``
    tool: int  # the site between the fingers
    drive: wp.array(dtype=int)  # [D] position actuators of the driven joints
    drive_position: wp.array(dtype=int)  # [D] in ``qpos``
    drive_dof: wp.array(dtype=int)  # [D]
    speeds: wp.array(dtype=float)  # [D] top speeds [rad/s] or [m/s]
    fingers: wp.array(dtype=int)  # actuators of the gripper
    finger_position: wp.array(dtype=int)  # of their joints in ``qpos``
    ctrl_range: wp.array(dtype=wp.vec2)  # [nu] limits of targets
    position: wp.array(dtype=int)  # [nu] positions of the actuators' joints in ``qpos``
    home: wp.array(dtype=float)  # the robot's part of ``qpos``, its last


@wp.struct
class Layouts:
    """The layouts of a `Bank`."""

    room: wp.array(dtype=int)  # [V]
    goals: wp.array2d(dtype=Goal)  # [V, K]
    goal_count: wp.array(dtype=int)  # [V]
    free_pose: wp.array3d(dtype=float)  # [V, F, 7] of free bodies
    spawns: wp.array3d(dtype=float)  # [V, P, 3] places of the base: x, y [m], yaw [rad]
    used: wp.array2d(dtype=int)  # [R, M] whether the room has a body in the slot


@wp.struct
class Simulation:
    """The state of all worlds, as MuJoCo Warp names it."""

    qpos: wp.array2d(dtype=float)
    qvel: wp.array2d(dtype=float)
    ctrl: wp.array2d(dtype=float)
    xpos: wp.array2d(dtype=wp.vec3)
    xquat: wp.array2d(dtype=wp.quat)
    site_xpos: wp.array2d(dtype=wp.vec3)
    site_xmat: wp.array2d(dtype=wp.mat33)


@wp.struct
class Episodes:
    """The episode that runs in each world; all arrays are [W]."""

    wanted: wp.array(dtype=int)  # layout to take; -1: any
    done: wp.array(dtype=int)  # whether it has ended
    fresh: wp.array(dtype=int)  # whether it has just begun
    number: wp.array(dtype=int)
    layout: wp.array(dtype=int)
    room: wp.array(dtype=int)
    goal: wp.array(dtype=int)  # of those of the layout
    steps: wp.array(dtype=int)
    draw: wp.array(dtype=float)  # 0..1, places the robot
    potential: wp.array(dtype=float)  # of the task at the step before
    start_height: wp.array(dtype=float)  # of what is to be taken
    start_goal: wp.array(dtype=wp.vec3)  # where that is to go


@wp.struct
class Observations:
    """Observations [W, n] of `env.BatchedRoomEnv`; what is not used is 0."""

    robot: wp.array2d(dtype=float)
    base: wp.array2d(dtype=float)
    tool: wp.array2d(dtype=float)
    gripper: wp.array2d(dtype=float)
    subject: wp.array2d(dtype=float)
    goal: wp.array2d(dtype=float)
    objects: wp.array3d(dtype=float)
    doors: wp.array2d(dtype=float)
    task: wp.array2d(dtype=float)


def filled(struct: Any, **values: Any) -> Any:
    """A struct with these values."""
    made = struct()
    for name, value in values.items():
        setattr(made, name, value)
    return made
