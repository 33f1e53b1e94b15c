"""Relations that an imported scene has by its geometry, as soft ones: what holds, and what very nearly does.

Files of other systems overlap by centimetres: a nightstand that reaches into its bed is beside the bed for all that.
So a relation that categories suggest (a seat and its table, a bed and what stands beside it, a cupboard and its wall)
counts where it is missed by no more than `NEARLY`; what only geometry suggests has to hold by the judge.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from sceneweaver.assets.roles import has_role
from sceneweaver.scene import Relation, Scene, SceneObject
from sceneweaver.verify.relations import nearly_holds
from sceneweaver.verify.solids import Placed

NEARLY = 0.3
"""Length [m] by which the worst measure of a relation that categories suggest may be off; radians count 0.5 m."""

NEIGHBOURS = 3
"""Nearest objects that an object is looked at with, where only geometry suggests a relation."""

TABLES = ("meal_table", "dining_table", "desk", "dressing_place")


class Pair(NamedTuple):
    """A relation that roles of two objects suggest, of the one to the nearest of the others."""

    subject: tuple[str, ...]
    target: tuple[str, ...]
    type: str
    params: dict[str, Any] = {}


PAIRS = (
    Pair(("table_seat", "light_seat", "armchair"), TABLES, "front_against"),
    Pair(("bedside",), ("any_bed",), "leftright_to_leftright"),
    Pair(("bedside",), ("sofa", "armchair"), "leftright_to_leftright"),
    Pair(("coffee_table",), ("sofa",), "front_to_front", {"gap": [0.2, 0.6]}),
    Pair(("lounge_seat",), ("screen_stand",), "facing", {"degrees": 25}),
    Pair(("hanging_light",), ("dining_table", "coffee_table"), "above"),
)


def relations_of(scene: Scene) -> tuple[Relation, ...]:
    """The soft relations that a scene has as it is, at most a few for each object.

    A floor object against a wall; a seat at a table; what stands beside a bed or a sofa; a lamp over a table; a sofa
    that looks at a screen; things side by side.
    """
    placed = Placed.of(scene)
    found: dict[tuple[str, str, Any], Relation] = {}
    for relation, slack in _candidates(scene):
        key = relation.type, relation.subject, relation.target
        if key not in found and nearly_holds(placed, relation, slack):
            found[key] = relation
    return tuple(found.values())


def _candidates(scene: Scene) -> Iterator[tuple[Relation, float]]:
    """Relations to look at, with the length [m] by which they may be missed."""
    floor = [o for o in scene.objects if o.mount == "floor"]
    for one in scene.objects:
        for pair in PAIRS:
            others = [o for o in floor if o.id != one.id and has_role(o.category, *pair.target)]
            if others and has_role(one.category, *pair.subject) and (one.mount == "floor" or pair.type == "above"):
                (nearest,) = _nearest(one, others, 1)
                yield _soft(pair.type, one.id, nearest.id, pair.params), NEARLY
    for one in floor:
        yield _soft("against_wall", one.id), NEARLY if has_role(one.category, "wall_backed", "any_bed") else 0.0
        for other in _nearest(one, floor, NEIGHBOURS):
            if one.id < other.id:
                yield _soft("leftright_to_leftright", one.id, other.id), 0.0


def _soft(kind: str, subject: str, target: str | None = None, params: dict[str, Any] | None = None) -> Relation:
    return Relation(type=kind, subject=subject, target=target, params=params or {}, hard=False)


def _nearest(one: SceneObject, others: list[SceneObject], count: int) -> list[SceneObject]:
    x, y, _ = one.pose.position
    rest = [o for o in others if o.id != one.id]
    return sorted(rest, key=lambda o: math.dist((x, y), o.pose.position[:2]))[:count]
