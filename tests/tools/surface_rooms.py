"""Small rooms for the tests of the surface tools."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.assets import Library, make
from sceneweaver.knowledge import room_types
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Pose, Relation, Room, Scene, SceneObject
from sceneweaver.scene.edits import apply_all
from sceneweaver.tools.base import Context, Proposal, Tool
from sceneweaver.verify import check

LIBRARY = Library()
KIND = "studio_apartment"
"""The kind of room in which most small things may be."""

BAD = ("collision", "unsupported", "out_of_bounds", "blocked_zone", "blocked_opening")


def standing(category: str, seed: int = 3, at: tuple[float, float, float] = (0.4, -0.3, 0.7)) -> SceneObject:
    """A piece of furniture called CATEGORY-0 at x, y [m] and yaw [rad]."""
    return make(category, seed).object(f"{category}-0", pose=Pose.from_yaw(at[0], at[1], 0.0, at[2]))


def room(objects: Iterable[SceneObject], relations: Iterable[Relation] = (), **more: Any) -> Scene:
    """Objects in a room of ten by ten metres around the origin."""
    square = ((-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0))
    return Scene(id="s", room=Room(outline=square, **more), objects=tuple(objects), relations=tuple(relations))


def laid(category: str, chairs: int = 4) -> Scene:
    """A table, turned, with chairs tied to it, half of them at either long side."""
    table = make(category, 3).object(f"{category}-0", pose=Pose.from_yaw(0.5, 0.5, 0.0, 0.6))
    chair, (d, w, _) = make("dining_chair", 3), table.size
    objects, relations = [table], []
    for k in range(chairs):
        side = 1 if k % 2 else -1
        x, y = side * (d / 2 + 0.3), ((k // 2 + 0.5) / (chairs // 2) - 0.5) * w
        c, s = math.cos(0.6), math.sin(0.6)
        pose = Pose.from_yaw(0.5 + c * x - s * y, 0.5 + s * x + c * y, 0.0, 0.6 + (math.pi if side > 0 else 0.0))
        objects.append(chair.object(f"chair-{k}", pose=pose))
        relations.append(Relation(type="front_against", subject=f"chair-{k}", target=table.id))
    return room(objects, relations)


def answer(tool: Tool, scene: Scene, inputs: Mapping[str, Any] | None = None, seed: int = 1) -> Proposal:
    """What a tool proposes for a scene."""
    kind = room_types()[KIND]
    return tool.propose(Context(SceneGraph(text=""), kind, scene, LIBRARY, seed, inputs=inputs or {}))


def after(scene: Scene, proposal: Proposal) -> Scene:
    """The scene with the edits of a proposal."""
    return apply_all(scene, proposal.edits)[0]


def carrier(scene: Scene, obj: SceneObject) -> SceneObject:
    """What an object stands on in the end, be it by way of other small things."""
    while obj.support is not None:
        obj = scene.object(obj.support.object)
    return obj


def faults(scene: Scene, but: tuple[str, ...] = ()) -> list[str]:
    """What the judge finds wrong, save about the objects of ``but`` alone."""
    return [v.detail for v in check(scene).violations if v.kind in BAD and not set(v.objects) <= set(but)]
