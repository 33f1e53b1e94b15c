"""Typed edits of a scene. Each applies to an immutable scene, gives a new one, and has an exact inverse.

Edits change what a scene says; they solve no poses. ``apply`` refuses an edit that would leave a scene that does not
load, with an InputError of one line, and leaves the scene it was given as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Annotated, Any, Literal, TypeVar, get_args

from pydantic import Field

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote, show, suggest

from .base import FrozenModel
from .content import SceneContent
from .fields import Flag, Id, Index, JsonDict, Length, Name, Target
from .intent import Intent
from .messages import FieldError, describe
from .objects import Part, Pose, SceneObject, Support, Surface, Zone
from .references import check_references, relation_fits
from .relation import Relation

AnyScene = TypeVar("AnyScene", bound=SceneContent)


class _Edit(FrozenModel):
    @classmethod
    def _prefix(cls, data: Any) -> str:
        return str(cls.model_fields["op"].default)


class Add(_Edit):
    """Put an object into the list, at ``index`` or at its end."""

    op: Literal["add"] = "add"
    object: SceneObject
    index: Index | None = None


class Remove(_Edit):
    """Take an object out, and the relations that name it.

    Refused when something stands on it, unless ``cascade`` says to take that out, too.
    """

    op: Literal["remove"] = "remove"
    id: Id
    cascade: Flag = False


class Replace(_Edit):
    """Put another object of the same id in the place of one: a new category, asset, shape or any other field."""

    op: Literal["replace"] = "replace"
    object: SceneObject


class Relate(_Edit):
    """Put a relation into the list, at ``index`` or at its end."""

    op: Literal["relate"] = "relate"
    relation: Relation
    index: Index | None = None


class Unrelate(_Edit):
    """Take out the first relation of that type, subject and target; with ``index`` the one there, which must be so."""

    op: Literal["unrelate"] = "unrelate"
    type: Name
    subject: Id
    target: Target = None
    index: Index | None = None


class SetPose(_Edit):
    """Move an object."""

    op: Literal["pose"] = "pose"
    id: Id
    pose: Pose


class Geometry(FrozenModel):
    """Parts, zones and surfaces of an object."""

    parts: tuple[Part, ...] | None = None
    zones: tuple[Zone, ...] = ()
    surfaces: tuple[Surface, ...] = ()


class SetSize(_Edit):
    """Change the size [m]: parts, zones and surfaces are scaled with it, or set to ``geometry`` where that is given."""

    op: Literal["size"] = "size"
    id: Id
    size: tuple[Length, Length, Length]
    geometry: Geometry | None = None


class SetSupport(_Edit):
    """Put an object on a surface (mount becomes surface), or take it off (mount becomes floor, or what is given)."""

    op: Literal["support"] = "support"
    id: Id
    support: Support | None = None
    mount: Literal["floor", "wall", "ceiling", "surface"] | None = None


class Rename(_Edit):
    """Give an object another id, in relations and supports, too."""

    op: Literal["rename"] = "rename"
    id: Id
    new_id: Id


class SetAttributes(_Edit):
    """Set some attributes of an object and take others away; taking away one that is not there does nothing."""

    op: Literal["attributes"] = "attributes"
    id: Id
    set: JsonDict = Field(default_factory=dict)
    unset: tuple[str, ...] = ()


class SetIntent(_Edit):
    """Say what an object is there for, in the place of what was said before."""

    op: Literal["intent"] = "intent"
    id: Id
    intent: Intent


AnyEdit = (
    Add | Remove | Replace | Relate | Unrelate | SetPose | SetSize | SetSupport | Rename | SetAttributes | SetIntent
)

Edit = Annotated[AnyEdit, Field(discriminator="op")]
"""Any edit, told apart by ``op``."""

EDITS: Mapping[str, type[_Edit]] = {cls.model_fields["op"].default: cls for cls in get_args(AnyEdit)}
"""The edit classes by ``op``."""


def edit_from_json(data: Any) -> AnyEdit:
    """An edit from plain JSON data; InputError with one line on anything wrong."""
    if not isinstance(data, Mapping):
        raise InputError(f'edit is {show(data)}; give an object {{"op": ...}}')
    op = data.get("op")
    if not isinstance(op, str) or op not in EDITS:
        what = '"op" is missing' if "op" not in data else f"op is {show(op)}"
        raise InputError(f"edit: {what}{suggest(op, EDITS, what='give one of')}")
    return EDITS[op].model_validate(data)  # pyright: ignore[reportReturnType]


def edits_from_json(data: Any) -> list[AnyEdit]:
    """A list of edits from plain JSON data; InputError with one line that says which one is wrong."""
    if not isinstance(data, list | tuple):
        raise InputError(f"edits is {show(data)}; give a list of edits")
    out = []
    for i, item in enumerate(data):
        try:
            out.append(edit_from_json(item))
        except InputError as error:
            raise InputError(f"edits[{i}] {error}") from None
    return out


def edit_to_json(edit: AnyEdit) -> dict[str, Any]:
    """An edit as plain JSON data."""
    return edit.model_dump(mode="json", by_alias=True)


def apply(scene: AnyScene, edit: AnyEdit) -> AnyScene:
    """The scene after the edit.

    Raises:
        InputError: when it names something that is not there, or would leave a scene that does not load.
    """
    try:
        after = _changed(scene, edit)
        if not _keeps_references(scene, edit):
            try:
                check_references(after.room, after.objects, after.relations)
            except FieldError as error:
                raise InputError(describe(error.loc, error.text, after)) from None
    except InputError as error:
        raise InputError(f"{edit.op} {_named(edit)}: {error}") from None
    return after


def apply_all(scene: AnyScene, edits: Iterable[AnyEdit]) -> tuple[AnyScene, list[AnyEdit]]:
    """The scene after all edits in order, and the edits that lead back from it.

    Raises:
        InputError: when one of them cannot be applied; the line says which.
    """
    back: list[AnyEdit] = []
    for i, edit in enumerate(edits):
        try:
            after = apply(scene, edit)
        except InputError as error:
            raise InputError(f"edits[{i}] {error}") from None
        back[:0] = invert(scene, edit)
        scene = after
    return scene, back


def invert(scene: SceneContent, edit: AnyEdit) -> list[AnyEdit]:
    """The edits that take ``apply(scene, edit)`` back to ``scene``, exactly, the order of its lists included.

    Args:
        scene: the scene before the edit.
        edit: an edit that applies to it.

    Raises:
        InputError: when it names something that is not there.
    """
    match edit:
        case Add():
            return [Remove(id=edit.object.id)]
        case Remove():
            return _restore(scene, _removed(scene, edit))
        case Replace():
            return [Replace(object=scene.object(edit.object.id))]
        case Relate():
            r = edit.relation
            at = len(scene.relations) if edit.index is None else edit.index
            return [Unrelate(type=r.type, subject=r.subject, target=r.target, index=at)]
        case Unrelate():
            at = _find_relation(scene, edit)
            return [Relate(relation=scene.relations[at], index=at)]
        case SetPose():
            return [SetPose(id=edit.id, pose=scene.object(edit.id).pose)]
        case SetSize():
            o = scene.object(edit.id)
            geometry = Geometry(parts=o.parts, zones=o.zones, surfaces=o.surfaces)
            return [SetSize(id=o.id, size=o.size, geometry=geometry)]
        case SetSupport():
            o = scene.object(edit.id)
            return [SetSupport(id=o.id, support=o.support, mount=o.mount)]
        case Rename():
            scene.index(edit.id)
            return [Rename(id=edit.new_id, new_id=edit.id)]
        case SetAttributes():
            old = scene.object(edit.id).attributes
            named = [*edit.set, *edit.unset]
            put = {key: old[key] for key in named if key in old}
            return [SetAttributes(id=edit.id, set=put, unset=tuple(key for key in edit.set if key not in old))]
        case SetIntent():
            return [SetIntent(id=edit.id, intent=scene.object(edit.id).intent)]


def _keeps_references(scene: SceneContent, edit: AnyEdit) -> bool:
    """Whether an edit changes no references, or adds something whose all exist: those of the rest hold as before."""
    if isinstance(edit, SetPose | SetAttributes | SetIntent):
        return True
    if isinstance(edit, Relate):
        return relation_fits(edit.relation, scene.room, scene._positions())
    if not isinstance(edit, Add) or edit.object.id in scene._positions():
        return False
    if any(edit.object.id == opening.id for opening in scene.room.openings):
        return False
    support = edit.object.support
    if support is None:
        return True
    at = scene._positions().get(support.object)
    return at is not None and any(s.name == support.surface for s in scene.objects[at].surfaces)


def _changed(scene: AnyScene, edit: AnyEdit) -> AnyScene:
    """The scene after an edit whose references are still to be checked."""
    match edit:
        case Add():
            return scene.model_copy(update={"objects": _inserted(scene.objects, edit.object, edit.index)})
        case Remove():
            gone = _removed(scene, edit)
            keep = tuple(o for o in scene.objects if o.id not in gone)
            relations = tuple(r for r in scene.relations if gone.keys().isdisjoint((r.subject, *r.targets)))
            return scene.model_copy(update={"objects": keep, "relations": relations})
        case Replace():
            return _with_object(scene, edit.object)
        case Relate():
            return scene.model_copy(update={"relations": _inserted(scene.relations, edit.relation, edit.index)})
        case Unrelate():
            at = _find_relation(scene, edit)
            return scene.model_copy(update={"relations": scene.relations[:at] + scene.relations[at + 1 :]})
        case SetSize():
            return _with_object(scene, _sized(scene.object(edit.id), edit))
        case SetSupport():
            mount = edit.mount or ("surface" if edit.support else "floor")
            return _with_object(scene, _rebuilt(scene.object(edit.id), support=edit.support, mount=mount))
        case Rename():
            return _renamed(scene, edit)
        case SetPose():
            return scene.replace_poses({edit.id: edit.pose})
        case SetAttributes():
            return _with_object(scene, _attributes(scene.object(edit.id), edit))
        case SetIntent():
            return _with_object(scene, scene.object(edit.id).model_copy(update={"intent": edit.intent}))


def edited_ids(edits: Iterable[AnyEdit]) -> set[str]:
    """The ids of the objects that edits are about; what stood on something removed may be gone with it."""
    found: set[str] = set()
    for edit in edits:
        match edit:
            case Add() | Replace():
                found.add(edit.object.id)
            case Relate():
                found.add(edit.relation.subject)
            case Rename():
                found.add(edit.new_id)
            case SetPose() | SetSize() | SetSupport():
                found.add(edit.id)
            case Remove():
                found.discard(edit.id)
            case Unrelate() | SetAttributes() | SetIntent():
                pass
    return found


def _named(edit: AnyEdit) -> str:
    match edit:
        case Add() | Replace():
            return quote(edit.object.id)
        case Relate():
            return f"{edit.relation.type} {quote(edit.relation.subject)}"
        case Unrelate():
            return f"{quote(edit.type)[1:-1]} {quote(edit.subject)}"
        case _:
            return quote(edit.id)


def _inserted(items: tuple[Any, ...], item: Any, index: int | None) -> tuple[Any, ...]:
    if index is None:
        return (*items, item)
    if index > len(items):
        raise InputError(f"index is {index}, but there are {len(items)}; give 0 to {len(items)}, or null for the end")
    return (*items[:index], item, *items[index:])


def _with_object(scene: AnyScene, obj: SceneObject) -> AnyScene:
    at = scene.index(obj.id)
    return scene.model_copy(update={"objects": (*scene.objects[:at], obj, *scene.objects[at + 1 :])})


def _rebuilt(obj: SceneObject, **changes: Any) -> SceneObject:
    """The object with some fields changed, checked as a new one."""
    return SceneObject(**{**{name: getattr(obj, name) for name in SceneObject.model_fields}, **changes})


def carried(scene: SceneContent, object_id: str) -> dict[str, int]:
    """What stands on an object, directly or on something that does, with how many steps up each is."""
    levels = {object_id: 0}
    grew = True
    while grew:
        grew = False
        for o in scene.objects:
            if o.support and o.id not in levels and o.support.object in levels:
                levels[o.id] = levels[o.support.object] + 1
                grew = True
    return levels


def _removed(scene: SceneContent, edit: Remove) -> dict[str, int]:
    """What is taken out, and how many steps up from the first each is."""
    scene.index(edit.id)
    gone = carried(scene, edit.id)
    if len(gone) > 1 and not edit.cascade:
        on = ", ".join(quote(object_id) for object_id in list(gone)[1:4]) + (", ..." if len(gone) > 4 else "")
        raise InputError(f"{on} would stand on nothing; set cascade to true to remove all")
    return gone


def _restore(scene: SceneContent, gone: Mapping[str, int]) -> list[AnyEdit]:
    """Edits that put objects and the relations that name them back where they were, carriers before what they carry."""
    order = sorted(map(scene.index, gone), key=lambda i: (gone[scene.objects[i].id], i))
    there = {i for i, o in enumerate(scene.objects) if o.id not in gone}
    out: list[AnyEdit] = []
    for i in order:
        out.append(Add(object=scene.objects[i], index=sum(k < i for k in there)))
        there.add(i)
    for i, relation in enumerate(scene.relations):
        if not gone.keys().isdisjoint((relation.subject, *relation.targets)):
            out.append(Relate(relation=relation, index=i))
    return out


def _find_relation(scene: SceneContent, edit: Unrelate) -> int:
    key = (edit.type, edit.subject, edit.target)
    fits = [i for i, r in enumerate(scene.relations) if (r.type, r.subject, r.target) == key]
    if edit.index is None and fits:
        return fits[0]
    if edit.index is not None and edit.index in fits:
        return edit.index
    where = "" if edit.index is None else f" at index {edit.index}"
    to = "without target" if edit.target is None else f"with target {show(edit.target)}"
    about = [f"{r.type} {show(r.target)}" for r in scene.relations if r.subject == edit.subject]
    raise InputError(f"there is no such relation {to}{where}{suggest('', about, what='relations of that subject')}")


def _sized(obj: SceneObject, edit: SetSize) -> SceneObject:
    if edit.geometry is not None:
        g = edit.geometry
        return _rebuilt(obj, size=edit.size, parts=g.parts, zones=g.zones, surfaces=g.surfaces)
    sx, sy, sz = (new / old for new, old in zip(edit.size, obj.size, strict=True))

    def flat(polygon: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        return [(x * sx, y * sy) for x, y in polygon]

    def tall(z: tuple[float, float]) -> tuple[float, float]:
        return (z[0] * sz, z[1] * sz)

    parts = obj.parts and [{"polygon": flat(p.polygon), "z": tall(p.z)} for p in obj.parts]
    zones = [{"name": z.name, "polygon": flat(z.polygon), "z": tall(z.z), "hard": z.hard} for z in obj.zones]
    surfaces = [
        {"name": s.name, "polygon": flat(s.polygon), "z": s.z * sz, "headroom": s.headroom and s.headroom * sz}
        for s in obj.surfaces
    ]
    return _rebuilt(obj, size=edit.size, parts=parts, zones=zones, surfaces=surfaces)


def _attributes(obj: SceneObject, edit: SetAttributes) -> SceneObject:
    both = sorted({*edit.set} & {*edit.unset})
    if both:
        raise InputError(f"{show(both[0])} is both set and unset; do one of them")
    kept = {key: value for key, value in obj.attributes.items() if key not in edit.unset}
    return obj.model_copy(update={"attributes": {**kept, **edit.set}})


def _renamed(scene: AnyScene, edit: Rename) -> AnyScene:
    scene.index(edit.id)

    def new(object_id: str) -> str:
        return edit.new_id if object_id == edit.id else object_id

    objects = []
    for o in scene.objects:
        update: dict[str, Any] = {"id": edit.new_id} if o.id == edit.id else {}
        if o.support and o.support.object == edit.id:
            update["support"] = o.support.model_copy(update={"object": edit.new_id})
        objects.append(o.model_copy(update=update) if update else o)
    relations = []
    for r in scene.relations:
        if edit.id in (r.subject, *r.targets):
            pair = None if r.target is None else tuple(new(t) for t in r.targets)
            target = pair[0] if pair and isinstance(r.target, str) else pair
            r = r.model_copy(update={"subject": new(r.subject), "target": target})
        relations.append(r)
    areas = tuple(
        a.model_copy(update={"targets": tuple(map(new, a.targets)), "others": tuple(map(new, a.others))})
        if edit.id in (*a.targets, *a.others)
        else a
        for a in scene.free_areas
    )
    changed = {"objects": tuple(objects), "relations": tuple(relations), "free_areas": areas}
    return scene.model_copy(update=changed)
