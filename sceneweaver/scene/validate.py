"""What must agree between the parts of a scene: openings and walls, ids and who names them, supports.

Each check raises Problem with the path from the model that it was given.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

from .catalogue import CATALOGUE
from .messages import Loc, Problem, quote, show, suggest

if TYPE_CHECKING:
    from .model import Relation, Room, Scene, SceneObject

FIT_TOLERANCE = 1e-6
"""How far [m] an opening may stand over its wall's end or the ceiling: rounding, no more."""

_WALL = re.compile(r"wall:(0|[1-9][0-9]{0,8})", re.ASCII)


def wall_number(target: str) -> int | None:
    """k of "wall:k"; None when it is something else."""
    match = _WALL.fullmatch(target)
    return int(match[1]) if match else None


def check_openings(room: Room) -> None:
    """Doors and windows lie in a wall that exists, within its length and height."""
    corners = room.outline
    for key, openings in (("doors", room.doors), ("windows", room.windows)):
        for i, opening in enumerate(openings):
            if opening.wall >= len(corners):
                known = f"the outline has walls 0 to {len(corners) - 1}"
                raise Problem((key, i, "wall"), f"is {opening.wall}; {known}")
            length = math.dist(corners[opening.wall], corners[(opening.wall + 1) % len(corners)])
            end = opening.offset + opening.width
            if end > length + FIT_TOLERANCE:
                fix = f"wall {opening.wall} is {length:.6g} m long; move it or make it narrower"
                raise Problem((key, i), f": offset + width is {end:.6g} m, but {fix}")
            sill = getattr(opening, "sill", 0.0)
            top = sill + opening.height
            if top > room.height + FIT_TOLERANCE:
                what = "sill + height" if key == "windows" else "height"
                fix = f"the room is {room.height:.6g} m high; make it lower"
                raise Problem((key, i), f": {what} is {top:.6g} m, but {fix}")


def check_object(obj: SceneObject) -> None:
    """Mount and support go together; the surfaces of an object have names of their own."""
    if obj.mount == "surface" and obj.support is None:
        raise Problem(("support",), 'is missing, but mount is "surface"; name the object and surface that it stands on')
    if obj.mount != "surface" and obj.support is not None:
        raise Problem(("support",), f'is given, but mount is "{obj.mount}"; set mount to "surface" or support to null')
    names: set[str] = set()
    for i, surface in enumerate(obj.surfaces):
        if surface.name in names:
            raise Problem(("surfaces", i, "name"), f"{show(surface.name)} is taken; choose another")
        names.add(surface.name)


def check_relation(relation: Relation) -> None:
    """The target has the form that the relation type asks for, and is not the subject."""
    spec = CATALOGUE[relation.type]
    kind, target = spec.target_kind, relation.target
    wanted = {
        "none": "null",
        "wall": '"wall:k"',
        "object": "the id of an object",
        "objects": "a list of two object ids",
        "window": "the id of a window",
        "door": "the id of a door",
    }[kind]
    wanted += " or null" if spec.target_optional and kind != "none" else ""
    if target is None:
        if not spec.target_optional:
            raise Problem(("target",), f"is missing; {relation.type} takes {wanted}")
        return
    if kind == "none":
        raise Problem(("target",), f"is {_show_target(target)}; {relation.type} takes none, set it to null")
    if isinstance(target, str) == (kind == "objects"):
        raise Problem(("target",), f"is {_show_target(target)}; {relation.type} takes {wanted}")
    if kind == "wall" and wall_number(relation.targets[0]) is None:
        raise Problem(("target",), f"is {_show_target(target)}; {relation.type} takes {wanted}, such as wall:0")
    if relation.subject in relation.targets:
        raise Problem(("target",), f"is {quote(relation.subject)}, the subject itself; name another object")
    if kind == "objects" and len(set(relation.targets)) < 2:
        raise Problem(("target",), f"names {quote(relation.targets[0])} twice; name two objects")


def check_references(scene: Scene) -> None:
    """Ids are unique, and whatever names an object, surface, wall or opening names one that exists."""
    room = scene.room
    seen: dict[str, str] = {}
    for loc, id in _ids(scene):
        where = "".join(f"[{k}]" if isinstance(k, int) else f".{k}" for k in loc).lstrip(".")
        if id in seen:
            raise Problem((*loc, "id"), f"is taken by {seen[id]}; ids are unique over doors, windows and objects")
        seen[id] = where
    objects = {o.id: o for o in scene.objects}
    _check_supports(scene, objects)
    kinds: dict[str, Iterable[str]] = {
        "object": objects,
        "objects": objects,
        "window": [w.id for w in room.windows],
        "door": [d.id for d in room.doors],
        "wall": [f"wall:{i}" for i in range(len(room.outline))],
    }
    for i, relation in enumerate(scene.relations):
        if relation.subject not in objects:
            fix = suggest(relation.subject, objects, what="objects", mark="'")
            raise Problem(("relations", i, "subject"), f"is {quote(relation.subject)}, which is no object{fix}")
        kind = CATALOGUE[relation.type].target_kind
        for k, target in enumerate(relation.targets):
            if target not in kinds[kind]:
                noun = kind.removesuffix("s")
                loc: Loc = ("relations", i, "target", k) if kind == "objects" else ("relations", i, "target")
                fix = suggest(target, kinds[kind], what=f"{noun}s", mark="'")
                fix = f"; the walls are wall:0 to wall:{len(room.outline) - 1}" if kind == "wall" else fix
                raise Problem(loc, f"is {quote(target)}, which is no {noun} of this scene{fix}")


def _check_supports(scene: Scene, objects: dict[str, SceneObject]) -> None:
    done: set[str] = set()
    for i, obj in enumerate(scene.objects):
        if obj.support is None:
            continue
        carrier = objects.get(obj.support.object)
        if carrier is None:
            name = obj.support.object
            fix = suggest(name, objects, what="objects", mark="'")
            raise Problem(("objects", i, "support", "object"), f"is {quote(name)}, which is no object{fix}")
        if obj.support.surface not in (s.name for s in carrier.surfaces):
            fix = suggest(obj.support.surface, [s.name for s in carrier.surfaces], what="its surfaces")
            text = f"is {show(obj.support.surface)}, which is no surface of {quote(carrier.id)}{fix}"
            raise Problem(("objects", i, "support", "surface"), text)
    for obj in scene.objects:
        path: dict[str, None] = {}
        at: SceneObject | None = obj
        while at is not None and at.id not in done:
            if at.id in path:
                circle = " -> ".join(quote(id) for id in [*list(path)[list(path).index(at.id) :], at.id])
                i = next(i for i, o in enumerate(scene.objects) if o is at)
                raise Problem(("objects", i, "support"), f"goes round in a circle: {circle}; one must stand elsewhere")
            path[at.id] = None
            at = objects[at.support.object] if at.support else None
        done.update(path)


def _ids(scene: Scene) -> Iterable[tuple[Loc, str]]:
    yield from ((("room", "doors", i), d.id) for i, d in enumerate(scene.room.doors))
    yield from ((("room", "windows", i), w.id) for i, w in enumerate(scene.room.windows))
    yield from ((("objects", i), o.id) for i, o in enumerate(scene.objects))


def _show_target(target: str | tuple[str, str]) -> str:
    return quote(target) if isinstance(target, str) else f"[{', '.join(quote(t) for t in target)}]"
