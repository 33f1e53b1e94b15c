"""Where the joints of the drawn robots have to be for a pose of their tool: closed form, two numbers free.

The wrist's axes meet in a point ``HAND`` behind the tool, at the end of the telescope. So the lift has the height of
that point, and the base is behind it by what the telescope is long, in any direction: yaw of the base and length of the
telescope are free, all else follows.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .robots import HAND

Array = np.ndarray

WRIST = 0.25
"""From the axis of the base to the wrist with the telescope drawn in [m]."""

STROKE = 0.56
"""How far the telescope comes out [m]."""

_LIMITS = {"lift": (0.125, 1.575), "wrist_yaw": (-1.98, 1.98), "wrist_pitch": (-0.78, 1.88)}


@dataclass(frozen=True)
class ToolPose:
    """Where the tool is to be: ``position`` [3], unit vectors ``approach`` and ``closing`` [3], in the room's frame."""

    position: Array
    approach: Array
    closing: Array

    def moved(self, shift: Array) -> ToolPose:
        """The same, moved by [3]."""
        return ToolPose(self.position + shift, self.approach, self.closing)

    def back(self, distance: float) -> ToolPose:
        """The same, ``distance`` [m] before it along the approach."""
        return self.moved(-distance * self.approach)


def configuration(tool: ToolPose, yaw: float, extend: float) -> Array | None:
    """Joints [9] of the mobile robot: base x, y, yaw, lift, the two stages, wrist yaw, pitch and roll.

    Args:
        tool: Where the tool is to be.
        yaw: Of the base [rad].
        extend: Of both stages of the telescope together [m].

    Returns:
        None where a joint would be beyond its limits.

    Examples:
        >>> from sceneweaver.envs.kinematics import ToolPose, configuration
        >>> tool = ToolPose(np.array([1.0, 0, 0.5]), np.array([1.0, 0, 0]), np.array([0.0, 1, 0]))
        >>> configuration(tool, 0.0, 0.2).round(2).tolist()
        [0.29, 0.0, 0.0, 0.5, 0.1, 0.1, 0.0, 0.0, 0.0]
    """
    wrist = tool.position - HAND * tool.approach
    along = np.array([np.cos(yaw), np.sin(yaw)])
    base = wrist[:2] - (WRIST + extend) * along
    level = float(np.hypot(*tool.approach[:2]))
    pitch = float(np.arctan2(-tool.approach[2], level))
    heading = float(np.arctan2(tool.approach[1], tool.approach[0])) if level > 1e-3 else yaw
    turn = _wrapped(heading - yaw)
    side = np.array([-np.sin(yaw + turn), np.cos(yaw + turn), 0.0])
    up = np.cross(tool.approach, side)
    roll = float(np.arctan2(tool.closing @ up, tool.closing @ side))
    roll = (roll + np.pi / 2) % np.pi - np.pi / 2  # the two fingers are alike
    values = {"lift": float(wrist[2]), "wrist_yaw": turn, "wrist_pitch": pitch}
    if not 0 <= extend <= STROKE or any(not low <= values[k] <= high for k, (low, high) in _LIMITS.items()):
        return None
    return np.array([*base, yaw, wrist[2], extend / 2, extend / 2, turn, pitch, roll])


def _wrapped(angle: float) -> float:
    return float((angle + np.pi) % (2 * np.pi) - np.pi)
