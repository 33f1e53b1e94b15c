"""Where a parallel gripper can take hold of a thing or a door: what the asset says, else its rim or its box."""

from __future__ import annotations

import numpy as np

from .geometry import GraspFrame, Interior, SceneGeometry

Array = np.ndarray

OPENING = 0.08
"""How far the drawn robots' fingers open [m]."""

_SPARE = 0.006  # [m] between open fingers and what they close around, both sides together
_DEPTH = 0.025  # [m] by which fingertips reach below the top of what they hold
_AROUND = 12  # places on a round rim
_WALL = 0.006  # [m] thickness of the wall of a vessel, about
_DOWN = np.array([0.0, 0.0, -1.0])


def grasps_of(geometry: SceneGeometry, body: str) -> list[GraspFrame]:
    """Grasps of a body in its frame, the best first; empty: a hand of 8 cm cannot hold it.

    A thing whose asset names none is taken from above: a vessel by its rim, any other across its narrow side.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import SceneGeometry
        >>> grasps_of(SceneGeometry(sw.Scene.example("bedroom")), "bed")
        []
    """
    given = [frame for frame in geometry.grasps.get(body, ()) if frame.width < OPENING - _SPARE]
    if given or body not in geometry.items:
        return given
    item = geometry.items[body]
    found = []
    vessels = [one for one in geometry.interiors if one.body == body and one.entry[2] > 0.9]
    for vessel in vessels:
        found += _rim(vessel, item.high[2])
    for axis in np.argsort(item.size[:2]):
        width = float(item.size[axis])
        if width < OPENING - _SPARE:
            height = max(item.high[2] - _DEPTH, (item.low[2] + item.high[2]) / 2)
            position = np.array([*item.centre[:2], height])
            found.append(GraspFrame("top", body, position, _DOWN, np.eye(3)[axis], width))
    return found


def _rim(vessel: Interior, top: float) -> list[GraspFrame]:
    """Around the rim of a vessel: one finger inside, the other outside."""
    half, middle = (vessel.high - vessel.low)[:2] / 2, (vessel.high + vessel.low)[:2] / 2
    if half.min() < 0.02:  # no room for a finger
        return []
    found = []
    angles = np.arange(_AROUND if vessel.oval else 4) * 2 * np.pi / (_AROUND if vessel.oval else 4)
    for angle in angles:
        out = np.array([np.cos(angle), np.sin(angle)])
        edge = middle + half * out
        position = np.array([*edge, top - _DEPTH])
        found.append(GraspFrame("rim", vessel.body, position, _DOWN, np.append(out, 0.0), _WALL))
    return found
