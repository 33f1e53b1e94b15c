"""Poses as seen from another object."""

from __future__ import annotations

import math

from sceneweaver.scene import SceneObject


def local(a: SceneObject, b: SceneObject) -> tuple[float, float]:
    """Position [m] of a in b's frame: along b's front, and to its left."""
    dx, dy = a.pose.position[0] - b.pose.position[0], a.pose.position[1] - b.pose.position[1]
    c, s = math.cos(b.pose.yaw), math.sin(b.pose.yaw)
    return c * dx + s * dy, c * dy - s * dx


def world(b: SceneObject, u: float, v: float, z: float, yaw: float) -> tuple[float, float, float, float]:
    """The pose (x, y, z, yaw) of what is at (u, v) [m] of b's frame, with its own height and yaw in the world's."""
    c, s = math.cos(b.pose.yaw), math.sin(b.pose.yaw)
    return b.pose.position[0] + c * u - s * v, b.pose.position[1] + s * u + c * v, z, yaw
