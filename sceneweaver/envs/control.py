"""From actions to targets of a robot's position actuators."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from sceneweaver.runtime.mujoco_module import load_mujoco
from sceneweaver.scene import InputError

from .predicates import rotate, turned
from .world import World

Array = np.ndarray
Control = Literal["joint", "ee"]

LEAD = 0.25
"""How far the target of a joint runs ahead of the joint at most, in seconds at its top speed: a hand that is held back
does not wind up."""

TOOL_SPEED = (0.25, 1.0)
"""Top speeds of the tool with control "ee": [m/s] and [rad/s]."""

_DAMPING = 0.05  # of the least squares of differential inverse kinematics


def control_named(name: str) -> Control:
    """A kind of control by its name.

    Raises:
        InputError: for a name that is none.
    """
    if name not in ("joint", "ee"):
        raise InputError(f"control: '{name}' is not known; use joint or ee")
    return name


class Controller:
    """Turns actions in -1..1 into targets of position actuators.

    With "joint" an action has the speed of each driven joint's target as a share of its top speed: of the base
    forwards, to the left and about z, then of the arm; the last is the gripper, from -1 (closed) to 1 (open). With "ee"
    it has those of the base, then the velocity of the tool (3, in the base's frame) and its turning (3), then the
    gripper; the arm follows by damped least squares.
    """

    def __init__(self, world: World, control: Control, period: float) -> None:
        """Control of a world's robot every ``period`` [s]."""
        self.world, self.control, self.period = world, control, period
        self.bases = len(world.robot.base)
        self.size = (len(world.indices.drive) if control == "joint" else self.bases + 6) + bool(
            len(world.indices.fingers)
        )
        span = world.model.actuator_ctrlrange[world.indices.drive]
        limited = world.model.actuator_ctrllimited[world.indices.drive].astype(bool)
        self._low, self._high = np.where(limited[:, None], span, [-np.inf, np.inf]).T

    def apply(self, data: Any, action: Array) -> None:
        """Set the targets for the next period."""
        world = self.world
        share = np.clip(np.asarray(action, dtype=float), -1.0, 1.0)
        now = data.qpos[world.indices.drive_position]
        speeds = np.zeros(len(world.indices.drive))
        speeds[: self.bases] = share[: self.bases] * world.indices.speeds[: self.bases]
        if self.control == "joint":
            speeds[self.bases :] = share[self.bases : len(speeds)] * world.indices.speeds[self.bases :]
        else:
            speeds[self.bases :] = self._follow(data, share[self.bases : self.bases + 6])
        if self.bases:
            speeds[:2] = turned(speeds[:2], now[2])
        target = data.ctrl[world.indices.drive] + speeds * self.period
        lead = LEAD * world.indices.speeds
        target = np.clip(target, now - lead, now + lead)
        data.ctrl[world.indices.drive] = np.clip(target, self._low, self._high)
        if len(world.indices.fingers):
            low, high = world.model.actuator_ctrlrange[world.indices.fingers].T
            data.ctrl[world.indices.fingers] = low + (high - low) * (share[-1] + 1) / 2

    def _follow(self, data: Any, share: Array) -> Array:
        """Speeds of the arm's joints for a velocity of the tool."""
        world = self.world
        linear, angular = np.zeros((3, world.model.nv)), np.zeros((3, world.model.nv))
        load_mujoco().mj_jacSite(world.model, data, linear, angular, world.indices.tool)
        matrix = np.vstack([linear, angular])[:, world.indices.drive_dof[self.bases :]]
        yaw = world.base(data)[2]
        turn = np.array([np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)])
        wanted = np.concatenate([rotate(turn, share[:3]) * TOOL_SPEED[0], rotate(turn, share[3:]) * TOOL_SPEED[1]])
        square = matrix @ matrix.T + _DAMPING**2 * np.eye(6)
        speeds = matrix.T @ np.linalg.solve(square, wanted)
        most = np.max(np.abs(speeds) / world.indices.speeds[self.bases :], initial=1.0)
        return speeds / most
