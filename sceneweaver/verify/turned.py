"""Objects whose yaw is none of those that they may have."""

from __future__ import annotations

import math

from sceneweaver.scene import Scene
from sceneweaver.verify.measure import at_most
from sceneweaver.verify.report import Violation

ANGLE = math.degrees(2e-3)
"""Angle [deg] by which a yaw may miss its domain."""


def find(scene: Scene) -> list[Violation]:
    """One violation for each object outside its ``yaw_domain``, in the frame of the room, or of what carries it."""
    found = []
    by_id = {obj.id: obj for obj in scene.objects}
    for obj in scene.objects:
        if obj.yaw_domain is None:
            continue
        base = by_id[obj.support.object].pose.yaw if obj.support is not None else 0.0
        yaw = math.degrees(obj.pose.yaw - base)
        off = min(abs(math.remainder(yaw - own, 360.0)) for own in obj.yaws)
        if off > ANGLE:
            where = "the room" if obj.support is None else obj.support.object
            detail = (
                f"{obj.id} is turned {off:.2g} degrees off the nearest yaw that it may have in the frame of {where}"
            )
            measured = at_most("angle to the nearest yaw of its domain", off, 0.0, "deg", slack=ANGLE)
            found.append(Violation.of("yaw_domain", (obj.id,), detail, measured))
    return found
