"""What a stated relation means in the relation catalogue, given what it is said of."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from sceneweaver.assets.taxonomy import category_named

from .model import Entity, SceneGraph, StatedRelation
from .relating import family

BESIDE = 0.6
"""Distance [m] up to which things are next to each other."""

DIRECT: dict[str, str] = {
    "near": "near",
    "next_to": "near",
    "side_by_side": "side_by_side",
    "in_front_of": "in_front_of",
    "behind": "behind",
    "left_of": "left_of",
    "right_of": "right_of",
    "between": "between",
    "around": "around",
    "on": "on_top",
    "inside": "inside",
    "above": "above",
    "facing": "facing",
    "opposite": "facing",
    "parallel": "parallel",
    "aligned": "aligned",
    "back_to_back": "back_to_back",
    "flanking": "leftright_to_leftright",
    "at": "front_against",
}
"""Stated relations between two things that the catalogue has whatever the things are."""

_BEDS = ("bed", "king_bed", "single_bed", "canopy_bed")


@dataclass(frozen=True)
class Meaning:
    """A relation of the catalogue: ``target`` is an entity's id, two of them, a place with a side, or None."""

    type: str
    target: str | tuple[str, str] | None = None
    params: dict[str, Any] = field(default_factory=dict)


def meaning(said: StatedRelation, graph: SceneGraph) -> Meaning | None:
    """The relation of the catalogue that a stated one asks for; None when the catalogue has none."""
    subject = graph.entity(said.subject)
    if subject is None or not said.targets:
        return None
    things = [graph.entity(name) for name in said.targets]
    if said.type == "between":
        pair = said.targets if len(said.targets) == 2 else said.targets * 2
        return Meaning("between", (pair[0], pair[1])) if all(things) else None
    target = things[0]
    found = _of_place(said, subject) if target is None else _of_things(said, subject, target)
    return found and Meaning(found.type, found.target, {**found.params, **said.params})


def meanings(graph: SceneGraph) -> list[tuple[StatedRelation, Meaning]]:
    """The stated relations of a graph that the catalogue has, with what they mean there."""
    found = ((said, meaning(said, graph)) for said in graph.relations)
    return [(said, meant) for said, meant in found if meant is not None]


def _of_things(said: StatedRelation, subject: Entity, target: Entity) -> Meaning | None:
    mount = category_named(subject.category).mount
    support = category_named(target.category)
    kind, carries = said.type, support.mount[0] == "floor" or bool(support.holds)
    found: tuple[str, dict[str, Any]] | None
    if kind in ("on", "inside") and (mount[0] == "wall" or ("surface" not in mount and mount[0] != "floor")):
        found = "above", {}
    elif kind in ("on", "inside") and (not carries or (mount[0] == "floor" and "surface" not in mount)):
        found = "near", {"max": 0.3}
    elif kind in ("next_to", "near") and subject.category == "nightstand" and target.category in _BEDS:
        found = "leftright_to_leftright", {}
    elif kind == "flanking" and mount[0] != "floor":
        found = "near", {"max": BESIDE}
    elif kind == "at" or (kind == "near" and family(subject.category) == "seat" and family(target.category) == "table"):
        found = "front_against", {}
    elif kind == "next_to":
        found = "near", {"max": BESIDE}
    elif kind == "below":
        found = "near", {"max": 0.0}
    elif kind in ("against", "leaning_on"):
        found = "near", {"max": 0.1}
    elif kind == "above" and mount[0] == "ceiling":
        found = "near", {"max": 0.3}
    elif kind == "around" and mount[0] == "floor":
        found = "front_against", {}
    else:
        found = (DIRECT[kind], {}) if kind in DIRECT else None
    return None if found is None else Meaning(found[0], target.id, found[1])


def _of_place(said: StatedRelation, subject: Entity) -> Meaning | None:
    place, kind = said.targets[0], said.type
    mount = category_named(subject.category).mount[0]
    if place == "middle":
        return Meaning("in_middle", "middle")
    if place == "corner":
        return Meaning("in_corner") if mount == "floor" else None
    if place == "window" and kind not in ("facing", "opposite"):
        return Meaning("away_from_door") if kind == "far_from" else Meaning("at_window", "window")
    if place == "door":
        return Meaning("away_from_door") if kind in ("far_from", "opposite", "facing") else None
    if place.startswith("wall") and mount != "surface":
        return Meaning("against_wall", place if ":" in place else None)
    return None


__all__ = ["Meaning", "meaning", "meanings"]
