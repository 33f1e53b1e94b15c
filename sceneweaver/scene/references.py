"""What must agree between the parts of a scene: ids and who names them, supports.

Errors are Problems with the path from the scene.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from sceneweaver.io.messages import quote, show, suggest

from .catalogue import CATALOGUE
from .free_area import FreeArea
from .messages import FieldError, Loc
from .objects import SceneObject
from .relation import Relation
from .room import Room


def check_references(room: Room, objects: Sequence[SceneObject], relations: Sequence[Relation]) -> None:
    """Ids are unique, and whatever names an object, surface, wall or opening names one that exists."""
    seen: dict[str, Loc] = {}
    for loc, name in _ids(room, objects):
        if name in seen:
            where = "".join(f"[{k}]" if isinstance(k, int) else f".{k}" for k in seen[name]).lstrip(".")
            raise FieldError((*loc, "id"), f"is taken by {where}; ids are unique over doors, windows and objects")
        seen[name] = loc
    by_id = {o.id: o for o in objects}
    _check_supports(by_id)
    kinds = _targets(room, by_id)
    for i, relation in enumerate(relations):
        if relation.subject not in by_id:
            fix = suggest(relation.subject, by_id, what="objects", mark="'")
            raise FieldError(("relations", i, "subject"), f"is {quote(relation.subject)}, which is no object{fix}")
        kind = CATALOGUE[relation.type].target_kind
        for k, target in enumerate(relation.targets):
            if target not in kinds[kind]:
                noun = kind.removesuffix("s")
                loc: Loc = ("relations", i, "target", k) if kind == "objects" else ("relations", i, "target")
                fix = suggest(target, kinds[kind], what=f"{noun}s", mark="'")
                fix = f"; the walls are wall:0 to wall:{len(room.outline) - 1}" if kind == "wall" else fix
                raise FieldError(loc, f"is {quote(target)}, which is no {noun} of this scene{fix}")


def check_free_areas(areas: Sequence[FreeArea]) -> None:
    """The ids of free areas are unique."""
    seen: dict[str, int] = {}
    for i, area in enumerate(areas):
        if area.id in seen:
            raise FieldError(("free_areas", i, "id"), f"is taken by free_areas[{seen[area.id]}]; choose another")
        seen[area.id] = i


def relation_fits(relation: Relation, room: Room, ids: Collection[str]) -> bool:
    """Whether all that a relation names is there; ``ids`` are those of the objects."""
    known = _targets(room, ids)[CATALOGUE[relation.type].target_kind] if relation.targets else ()
    return relation.subject in ids and all(target in known for target in relation.targets)


def _targets(room: Room, ids: Collection[str]) -> dict[str, Collection[str]]:
    """What a relation may name as its target, by kind of target."""
    return {
        "object": ids,
        "objects": ids,
        "window": [w.id for w in room.windows],
        "door": [d.id for d in room.doors],
        "wall": [f"wall:{i}" for i in range(len(room.outline))],
    }


def _check_supports(objects: dict[str, SceneObject]) -> None:
    done: set[str] = set()
    for i, obj in enumerate(objects.values()):
        if obj.support is None:
            continue
        carrier = objects.get(obj.support.object)
        if carrier is None:
            name = obj.support.object
            fix = suggest(name, objects, what="objects", mark="'")
            raise FieldError(("objects", i, "support", "object"), f"is {quote(name)}, which is no object{fix}")
        if obj.support.surface not in (s.name for s in carrier.surfaces):
            fix = suggest(obj.support.surface, [s.name for s in carrier.surfaces], what="its surfaces")
            text = f"is {show(obj.support.surface)}, which is no surface of {quote(carrier.id)}{fix}"
            raise FieldError(("objects", i, "support", "surface"), text)
    for obj in objects.values():
        path: dict[str, None] = {}
        at: SceneObject | None = obj
        while at is not None and at.id not in done:
            if at.id in path:
                circle = " -> ".join(quote(name) for name in [*list(path)[list(path).index(at.id) :], at.id])
                i = next(i for i, o in enumerate(objects.values()) if o is at)
                raise FieldError(
                    ("objects", i, "support"), f"goes round in a circle: {circle}; one must stand elsewhere"
                )
            path[at.id] = None
            at = objects[at.support.object] if at.support else None
        done.update(path)


def _ids(room: Room, objects: Sequence[SceneObject]) -> Iterable[tuple[Loc, str]]:
    yield from ((("room", "doors", i), d.id) for i, d in enumerate(room.doors))
    yield from ((("room", "windows", i), w.id) for i, w in enumerate(room.windows))
    yield from ((("objects", i), o.id) for i, o in enumerate(objects))
