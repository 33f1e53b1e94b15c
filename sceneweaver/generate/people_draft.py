"""A request as it grows by what its people need."""

from __future__ import annotations

from dataclasses import dataclass, field

from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.kin import excluded_kinds
from sceneweaver.language import Entity, SceneGraph, StatedRelation
from sceneweaver.language.model import RelationType

CHILDREN = frozenset(("child", "children", "kid", "kids", "boys", "girls", "boy", "girl", "toddlers", "twins"))
"""Words for those who sit and sleep in small things."""


@dataclass
class PeopleDraft:
    """The things and relations of a request as they grow."""

    brief: SceneGraph
    room: RoomType
    entities: list[Entity]
    relations: list[StatedRelation] = field(default_factory=list[StatedRelation])

    def change(self, entity: Entity, **changed: object) -> None:
        """Something that the request names, with what follows of it."""
        at = next(k for k, one in enumerate(self.entities) if one.id == entity.id)
        if "size" in changed and not any(entity.size):
            changed["sized_for_people"] = True
        self.entities[at] = entity.model_copy(update=changed)

    def now(self, name: str) -> Entity:
        """A thing as it has become."""
        return next(one for one in self.entities if one.id == name)

    def add(self, category: str, count: int) -> Entity | None:
        """A thing that the request implies; None where it wants no such thing."""
        if category in excluded_kinds(self.brief.without):
            return None
        taken = {one.id for one in self.entities}
        name = next(n for n in (category, *(f"{category}-{k}" for k in range(2, 99))) if n not in taken)
        noun = category.replace("_", " ") + ("s" if count > 1 else "")
        entity = Entity(id=name, noun=noun, category=category, count=(count, count), implied=True)
        self.entities.append(entity)
        return entity


def is_vague(entity: Entity) -> bool:
    """Whether a request names several without saying how many."""
    return (entity.count is None and entity.noun.endswith("s")) or (
        entity.count is not None and entity.count[0] < entity.count[1]
    )


def told(draft: PeopleDraft, seat: Entity, table: Entity, kind: RelationType, count: int, each: bool) -> None:
    """Says that seats are at a table, unless the request says where they are."""
    if any(r.subject == seat.id and table.id in r.targets for r in draft.relations):
        return
    numbers = {"count": (count, count), "each": True} if each else {}
    said = StatedRelation(
        id=f"relation-{len(draft.relations)}", type=kind, subject=seat.id, targets=(table.id,), implied=True, **numbers
    )
    draft.relations.append(said)


def sits_at(draft: PeopleDraft, seat: Entity, table: Entity) -> bool:
    """Whether seats are told to be at a table."""
    return any(r.subject == seat.id and table.id in r.targets for r in draft.relations)
