"""What small things stand on that have a place in the room and nothing to stand on: a sewing machine under the window.

Without it they go where such things usually are, on the nearest bed if there is no better, and far from their place.
"""

from __future__ import annotations

from collections.abc import Iterator

from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named, likeliness
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.kin import excluded_kinds
from sceneweaver.language import Entity, SceneGraph, StatedRelation

from .draft import groups_of

PLACES = ("window", "door", "wall", "corner", "fireplace", "radiator")
"""Targets of a relation that are parts of the room, before the colon."""

PLACED = ("below", "near", "next_to", "at", "against", "between", "in_front_of", "opposite", "left_of", "right_of")
"""Relations that put such a thing somewhere in the room."""

CARRIED = ("on", "inside", "hanging_from", "centered_on", "leaning_on", "above", "around")
"""Relations by which it has something to stand on or to hang from."""

HIGHEST = 1.2
"""Height [m] of what small things are put down on."""

PLAIN = "side_table"
"""What carries a thing where nothing that usually carries it may stand in the room."""


def with_stands(brief: SceneGraph, room_type: RoomType) -> SceneGraph:
    """A request with something to stand on for each small thing that it gives a place at a part of the room.

    That goes to the place as well; both are implied, so no one takes them for what was asked.
    """
    entities, relations = list(brief.entities), list(brief.relations)
    unwanted = excluded_kinds((*brief.without, *room_type.never)) | room_type.absent
    for one in brief.entities:
        places = _places(one, brief, room_type)
        carrier = next((name for name in _carriers(one, room_type) if name not in unwanted), None) if places else None
        if carrier is None:
            continue
        taken = {e.id for e in entities}
        name = next(n for n in (carrier, *(f"{carrier}-{k}" for k in range(2, 99))) if n not in taken)
        noun = carrier.replace("_", " ")
        entities.append(Entity(id=name, noun=noun, category=carrier, count=(1, 1), implied=True))
        on = StatedRelation(id=f"relation-{len(relations)}", type="on", subject=one.id, targets=(name,), implied=True)
        relations.append(on)
        for said in places:
            id = f"relation-{len(relations)}"
            relations.append(said.model_copy(update={"id": id, "subject": name, "implied": True, "each": False}))
    if len(entities) == len(brief.entities):
        return brief
    return brief.model_copy(update={"entities": tuple(entities), "relations": tuple(relations)})


def _places(one: Entity, brief: SceneGraph, room_type: RoomType) -> list[StatedRelation]:
    """The parts of the room that a small thing is said to be at; none where it has something to stand on, where it may
    as well stand on the floor or hang, or where something that is asked for may carry it there."""
    known = category_named(one.category)
    if known.mount != ("surface",) or has_role(one.category, "set_down"):
        return []
    own = [r for r in brief.relations if r.subject == one.id]
    if any(r.type in CARRIED for r in own):
        return []
    if any(likeliness(one.category, e.category) is not None and not e.implied for e in brief.entities if e is not one):
        return []
    found = [r for r in own if r.type in PLACED and r.targets]
    return [r for r in found if all(_is_place(name, one, brief, room_type) for name in r.targets)]


def _is_place(target: str, one: Entity, brief: SceneGraph, room_type: RoomType) -> bool:
    """Whether a thing that is told to be at a target needs something of its own to stand on there: a printer beside a
    bed does, a lamp beside it has the nightstand."""
    other = brief.entity(target)
    if other is None:
        return target.partition(":")[0] in PLACES
    company = {item.what[0] for item in room_type.items if item.with_ is not None}
    if company & set(category_named(one.category).on[:2]):
        return False
    return category_named(other.category).mount[:1] == ("floor",) and not {"table_group"} & groups_of(other.category)


def _carriers(one: Entity, room_type: RoomType) -> Iterator[str]:
    """What may carry a thing, the likeliest first: what the room has anyway, then what such a thing stands on
    elsewhere, then a plain table."""
    here = [name for item in room_type.items if item.with_ is None for name in item.what]
    usual = category_named(one.category).on
    yield from (name for name in usual if name in here and _may_carry(name, one))
    yield from (name for name in usual if "table_group" in groups_of(name) and _may_carry(name, one))
    yield from (name for name in here if "table_group" in groups_of(name) and _may_carry(name, one))
    yield PLAIN


def _may_carry(carrier: str, one: Entity) -> bool:
    """Whether a thing fits on top of another that stands on the floor, within a person's reach."""
    known, size = category_named(carrier), category_named(one.category).size
    if (
        known.mount[:1] != ("floor",)
        or known.size is None
        or size is None
        or {"bed_group", "seating"} & groups_of(carrier)
    ):
        return False
    (_, depth), (_, width), (low, _) = known.size.ranges
    return low <= HIGHEST and size.ranges[0][0] <= depth and size.ranges[1][0] <= width
