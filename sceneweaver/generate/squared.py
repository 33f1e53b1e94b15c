"""Large furniture stands square to the walls of a room that is given: its floor seldom has the space for more."""

from __future__ import annotations

import math

from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.walls import walls_of
from sceneweaver.scene import Room, Scene, SceneObject

LARGE = 0.4
"""Floor [m2] from which on a thing stands square."""

STRAIGHT = math.radians(0.05)
"""How far the walls of a room may be from the axes."""


def squared(objects: tuple[SceneObject, ...], room: Room) -> tuple[SceneObject, ...]:
    """The objects, those that are large and no seats with quarter turns as their yaws; a room askew asks for nothing.

    Seats may be turned to what they look at, and small things as they come.
    """
    if any(abs(math.remainder(wall.yaw, math.pi / 2)) > STRAIGHT for wall in walls_of(room.outline)):
        return objects
    return tuple(o.model_copy(update={"yaw_domain": "quarter_turns"}) if _is_large(o) else o for o in objects)


def unsquared(scene: Scene) -> Scene:
    """The scene with yaws free again: whoever edits it later may turn things as he likes."""
    if all(o.yaw_domain is None for o in scene.objects):
        return scene
    objects = tuple(o.model_copy(update={"yaw_domain": None}) if o.yaw_domain else o for o in scene.objects)
    return scene.model_copy(update={"objects": objects})


def _is_large(obj: SceneObject) -> bool:
    large = obj.mount == "floor" and obj.size[0] * obj.size[1] >= LARGE and obj.yaw_domain is None
    return large and not has_role(obj.category, "armchair", "backless_seat")
