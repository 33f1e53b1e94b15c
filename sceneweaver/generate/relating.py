"""From what a call says ("near the sofa", "at the left wall") to relations between objects that are there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.io.messages import suggest
from sceneweaver.knowledge import Place
from sceneweaver.scene import CATALOGUE, InputError, Relation, SceneObject

from .draft import Draft
from .relations import CEILING, behind_it, wall_named

Chosen = dict[str, str]
"""Which instance a word means for one subject, so that all its relations mean the same."""


def place_of(entry: Mapping[str, Any], where: str) -> Place:
    """A relation that a call says; InputError for one of an unknown type."""
    if entry["type"] not in CATALOGUE:
        raise InputError(f"{where}.type is '{entry['type']}'{suggest(entry['type'], CATALOGUE)}")
    return Place.model_validate({k: v for k, v in entry.items() if v is not None or k not in Place.model_fields})


def relations_of(
    draft: Draft, places: Iterable[Place], subject: SceneObject, count: int = 1
) -> tuple[list[Relation], list[str]]:
    """The relations of one subject, and what could not be said, each as a line.

    Args:
        draft: what is there; the subject is in it already.
        places: the relations; a target is an id, an item or a category.
        subject: the object to place.
        count: how many equal ones are placed with it.
    """
    found: list[Relation] = []
    failed: list[str] = []
    chosen: Chosen = {}
    for place in places:
        try:
            relation = _relation(draft, place, subject, count, chosen)
        except InputError as error:
            failed.append(f"{subject.id} {place.type}: {error}")
            continue
        if relation is None:
            words = " ".join((subject.id, place.type, *filter(None, (" or ".join(place.targets),))))
            failed.append(f"{words}: there is no such thing here")
            continue
        if any((r.type, r.target) == (relation.type, relation.target) for r in found):
            continue
        found.append(relation)
        if relation.type == "above" and subject.mount == "wall":  # at the wall behind it, not at the one opposite
            found.append(behind_it(relation))
    return found, failed


def _relation(draft: Draft, place: Place, subject: SceneObject, count: int, chosen: Chosen) -> Relation | None:
    kind, room = CATALOGUE[place.type].target_kind, draft.room
    type, params, to = place.type, dict(place.params), next(iter(place.targets), None)
    target: str | tuple[str, str] | None = None
    if kind == "wall":
        target = _wall(draft, to)
    elif kind == "window":
        if not room.windows:
            return None
        target = _opening(draft, to, [w.id for w in room.windows], "window", subject)
        width = next(w.width for w in room.windows if w.id == target)
        if subject.mount == "wall" and "overlap" not in params:  # a curtain hangs before the middle of its window
            params["overlap"] = max(0.1, round(0.95 * min(1.0, width / subject.size[1]), 2))
    elif kind == "door":
        if not room.doors:
            return None
        if to is not None and to != "door":
            target = _opening(draft, to, [d.id for d in room.doors], "door", subject)
    elif kind == "objects":
        target = _pair(draft, place.targets, subject)
        if target is None:
            return None
    elif kind == "object":
        target = _instance(draft, place.targets, subject, chosen)
        if target is None:
            return None
        other = draft.objects[target]
        if type == "above" and other.size[2] + subject.size[2] + CEILING > room.height:
            raise InputError(f"there is no height for it above {target}")
        if type == "around":
            tied = [r for r in draft.relations if r.type == "around" and r.target == target and r.subject != subject.id]
            if count < 2 or any(draft.objects[r.subject].category != subject.category for r in tied):
                type, params = "front_against", {}
            else:
                params.setdefault("n", count)
    return Relation(
        type=type, subject=subject.id, target=target, params=params, hard=not place.soft, weight=place.weight
    )


def _instance(draft: Draft, words: Iterable[str], subject: SceneObject, chosen: Chosen) -> str | None:
    """The object that is meant: of the first word that names any, the one that fewest of this kind are tied to."""
    for word in words:
        if word in chosen:
            return chosen[word]
        pool = [id for id in draft.named(word) if id != subject.id]
        if not pool:
            continue
        kept = [id for id in pool if id in chosen.values()]
        best = kept[0] if kept else min(pool, key=lambda id: (draft.load(id, subject), pool.index(id)))
        chosen[word] = best
        return best
    return None


def _wall(draft: Draft, to: str | None) -> str | None:
    """ "wall:k" of "wall:2", "wall:left" or "left wall"; None for any wall."""
    if to is None or to == "wall":
        return None
    return f"wall:{wall_named(to.removeprefix('wall:').removesuffix(' wall'), draft.room)}"


def _opening(draft: Draft, to: str | None, ids: list[str], noun: str, subject: SceneObject) -> str:
    if to is not None and to in ids:
        return to
    if to not in (None, noun, f"{noun}s"):
        raise InputError(f"'{to}' is no {noun}{suggest(str(to), ids)}")
    return min(ids, key=lambda id: (draft.load(id, subject), ids.index(id)))


def _pair(draft: Draft, words: Iterable[str], subject: SceneObject) -> tuple[str, str] | None:
    pools = [[id for id in draft.named(word) if id != subject.id] for word in words]
    if len(pools) == 1 and len(pools[0]) > 1:
        return pools[0][0], pools[0][1]
    if len(pools) == 2 and all(pools):
        second = [id for id in pools[1] if id != pools[0][0]]
        return (pools[0][0], second[0]) if second else None
    return None
