"""Relations that an imported scene keeps: those of its geometry that hold, as soft ones."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.assets.roles import has_role
from sceneweaver.scene import Relation, Scene, SceneObject
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Placed


def relations_of(scene: Scene) -> tuple[Relation, ...]:
    """The soft relations that hold in a scene as it is, by the judge: at most a few for each object.

    A floor object against a wall or in a corner; a seat at a table; a thing facing another; things side by side.
    """
    placed = Placed.of(scene)
    held: list[Relation] = []
    for relation in _candidates(scene):
        if judge_relation(placed, relation).holds:
            held.append(relation)
    return tuple(held)


def _candidates(scene: Scene) -> Iterator[Relation]:
    floor = [o for o in scene.objects if o.mount == "floor"]
    for one in floor:
        yield Relation(type="against_wall", subject=one.id, hard=False)
        for other in _nearest(one, floor):
            yield from _of_pair(one, other)


def _nearest(one: SceneObject, others: list[SceneObject], count: int = 3) -> list[SceneObject]:
    x, y, _ = one.pose.position
    rest = [o for o in others if o.id != one.id]
    return sorted(rest, key=lambda o: math.dist((x, y), o.pose.position[:2]))[:count]


def _of_pair(one: SceneObject, other: SceneObject) -> Iterator[Relation]:
    if has_role(one.category, "light_seat") and has_role(
        other.category, "meal_table", "desk", "dining_table", "dressing_place"
    ):
        yield Relation(type="front_against", subject=one.id, target=other.id, hard=False)
    if one.id < other.id:
        yield Relation(type="leftright_to_leftright", subject=one.id, target=other.id, hard=False)
        yield Relation(type="front_to_front", subject=one.id, target=other.id, hard=False)
