"""What a stated relation means in the relation catalogue, before there are objects."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from sceneweaver.assets.taxonomy import category_named

from .grounding import Grounded, grounded, named
from .model import Entity, SceneGraph, StatedRelation
from .pairs import Thing

FEW = 8
"""Things of a kind that are looked at: more are in no other relations."""


@dataclass(frozen=True)
class Meaning:
    """A relation of the catalogue: ``target`` is an entity's id, two of them, a place with a side, or None."""

    type: str
    target: str | tuple[str, str] | None = None
    params: dict[str, Any] = field(default_factory=dict)


def meanings(graph: SceneGraph) -> list[tuple[StatedRelation, Meaning]]:
    """The stated relations of a graph with what they mean for each of their subjects.

    A stated relation that means something else for each of its subjects, such as the two sides of a bed, is left out.
    """
    things = {entity.id: _things(entity) for entity in graph.entities}
    owner = {thing.id: name for name, several in things.items() for thing in several}
    rows, _ = grounded(graph, things)
    by_said: dict[str, list[Grounded]] = {}
    for row in rows:
        if row.hard and row.subject in owner:
            by_said.setdefault(row.said, []).append(row)
    found: list[tuple[StatedRelation, Meaning]] = []
    seen: dict[str, list[tuple[StatedRelation, Meaning]]] = {}
    for said, numbered in zip(graph.relations, named(graph), strict=True):
        held = _held(said, graph, things) if said.type in ("on", "inside") else None
        own, before = by_said.get(numbered.id, []), seen.setdefault(said.subject, [])
        subjects = {row.subject for row in own}
        every = [row for row in own if sum(other.type == row.type for other in own) >= len(subjects)]
        every = [row for row in every if owner[row.subject] == said.subject]
        for meant in [held] if held is not None else [_of_row(row, owner) for row in every]:
            if (said, meant) not in before:
                before.append((said, meant))
                found.append((said, meant))
    return found


def _of_row(row: Grounded, owner: dict[str, str]) -> Meaning:
    """What a relation of one thing means for all that stand for the same."""
    names = (row.target,) if isinstance(row.target, str) else row.target or ()
    targets = [owner.get(name, name) for name in names]
    place = targets[0] if len(targets) == 1 else (targets[0], targets[1]) if targets else None
    return Meaning(row.type, "middle" if row.type == "in_middle" else place, row.params)


def meaning(said: StatedRelation, graph: SceneGraph) -> Meaning | None:
    """The first relation of the catalogue that a stated one asks for; None when the catalogue has none."""
    return next((meant for other, meant in meanings(graph) if other is said), None)


def unsaid(graph: SceneGraph) -> list[StatedRelation]:
    """The stated relations that nothing in the catalogue says."""
    return grounded(graph, {entity.id: _things(entity) for entity in graph.entities})[1]


def _things(entity: Entity) -> list[Thing]:
    category = category_named(entity.category)
    ranges = category.size.ranges if category.size is not None else ((0.5, 0.5),) * 3
    size = tuple(given or (low + high) / 2 for given, (low, high) in zip(entity.size, ranges, strict=True))
    thing = Thing(entity.id, entity.category, (size[0], size[1], size[2]), category.mount[0])
    count = max(1, min(FEW, entity.count[0] if entity.count else 1))
    return [replace(thing, id=f"{entity.id}#{k}") for k in range(count)]


def _held(said: StatedRelation, graph: SceneGraph, things: dict[str, list[Thing]]) -> Meaning | None:
    """What stands on or in a thing: held by one of its surfaces, where it may be."""
    subject, target = graph.entity(said.subject), graph.entity(said.targets[0]) if said.targets else None
    if subject is None or target is None or "surface" not in category_named(subject.category).mount:
        return None
    held = category_named(target.category)
    if things[target.id][0].is_flat or not (held.mount[0] == "floor" or held.holds):
        return None
    return Meaning("on_top" if said.type == "on" else "inside", target.id)


__all__ = ["Meaning", "meaning", "meanings", "unsaid"]
