"""Free floor of a request in a first draft: the scene's free areas, what contradicts them, and how much floor it is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sceneweaver.language import SceneGraph
from sceneweaver.language.free_floor import alike, scene_area
from sceneweaver.scene import CATALOGUE, FreeArea, Relation, Room

SHARE = 0.6
"""Share of a free area that is floor beside what a room of the kind leaves free anyway."""

LONG = 1.5
"""Usual length of the side of a thing, or of a gap [m]."""

WAY = 0.8
"""Width of the ways that every room has [m]."""

EDGES = CATALOGUE.with_role("edge")
"""Relations that put a thing at a wall."""

BEYOND = frozenset({"behind", "in_front_of", "left_of", "right_of", "beside"})
"""Relations by which the middle of a thing is beyond a side of another."""

BEYOND_GAP = 1.0
"""How much more than the gap [m] the middle of what is beyond it may be away."""

BESIDE = 0.3
"""How much farther than asked a thing may be from its wall or corner [m]."""


def kept_free(brief: SceneGraph) -> float:
    """Floor [m2] that a request keeps free beside what rooms leave free."""
    found = 0.0
    for area in brief.free_areas:
        depth, width = area.size
        if area.kind in ("rectangle", "circle"):
            found += SHARE * depth * width
        elif area.kind == "clearance":
            found += SHARE * depth * LONG * {"around": 4, "sides": 2, "long": 2}.get(area.side, 1)
        elif area.kind == "gap":
            found += SHARE * depth * LONG
        else:
            found += max(depth - WAY, 0.0) * 2 * LONG
    return found


def people_of(brief: SceneGraph) -> int | None:
    """For how many people the room is: as the request says it of the room, else of what they do there."""
    told = [one.people for one in brief.capacities]
    return brief.people if brief.people is not None or not told else max(told)


def free_areas_of(brief: SceneGraph, made: Mapping[str, Sequence[str]], room: Room) -> tuple[FreeArea, ...]:
    """The free areas of a scene that a request states; ``made`` are the ids of the objects of each entity."""

    def ids_of(entity_id: str) -> list[str]:
        return [name for one in alike(brief, entity_id) for name in made.get(one, ())]

    found = (scene_area(asked, ids_of, room) for asked in brief.free_areas)
    return tuple(area for area in found if area is not None)


def agreeing(relations: Sequence[Relation], areas: Sequence[FreeArea]) -> list[Relation]:
    """Relations without those that nobody asked for and that contradict free floor; what was asked for gives room.

    What something stands behind, across a gap, has its back to no wall.
    """
    off = {name: a.size[0] for a in areas if a.kind == "gap" and "wall" in a.others for name in a.targets}
    around = {name for a in areas if a.kind == "clearance" and a.side == "around" for name in a.targets}
    boxed = {name for a in areas if a.kind == "clearance" and a.side in ("sides", "long") for name in a.targets}
    apart: dict[frozenset[str], float] = {}
    for area in areas:
        if area.kind == "gap":
            pairs = area.pairs((*area.targets, *area.others), relations)
            apart |= {frozenset(pair): area.size[0] for pair in pairs}
    backed = {r.targets[0] for r in relations if r.type == "behind" and frozenset((r.subject, *r.targets)) in apart}
    kept: list[Relation] = []
    for one in relations:
        at_wall = one.type in EDGES and one.type != "at_window"
        astray = at_wall and (one.subject in off or one.subject in around or one.subject in backed)
        astray = astray or (one.type == "in_corner" and one.subject in boxed)
        near = _nearest(one)
        least = apart.get(frozenset((one.subject, *one.targets)))
        astray = astray or (near is not None and least is not None and near < least)
        if one.asked and one.subject in off and astray:
            kept.append(one.model_copy(update={"params": {**one.params, **_farther(one, off[one.subject])}}))
        elif least is not None and (one.type in BEYOND or (one.type == "near" and one.asked)):
            most = max(float(CATALOGUE[one.type].value(one, "max")), least + BEYOND_GAP)
            kept.append(one.model_copy(update={"params": {**one.params, "max": most}}))
        elif one.asked or not astray:
            kept.append(one)
    return kept


def _nearest(relation: Relation) -> float | None:
    """The largest distance [m] that a relation leaves between two things; None where it says nothing of that."""
    spec = CATALOGUE[relation.type]
    if spec.target_kind != "object":
        return None
    if relation.type == "near":
        return float(spec.value(relation, "max"))
    if "gap" not in spec.params:
        return None
    span = spec.value(relation, "gap")
    return 0.05 if span is None or isinstance(span, str) else float(span[1])


def _farther(relation: Relation, gap: float) -> dict[str, Any]:
    """Params of a relation to a wall or corner that leave a gap [m] to it."""
    if relation.type == "in_corner":
        return {"to_wall": gap + BESIDE, "to_corner": 1.5 * (gap + BESIDE)}
    return {"gap": (0.0, gap + BESIDE)}


__all__ = ["agreeing", "free_areas_of", "kept_free", "people_of"]
