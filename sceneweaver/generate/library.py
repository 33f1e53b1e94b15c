"""Make a finished scene what a request says: its floor, its objects and the relations that were asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sceneweaver.assets import Wish
from sceneweaver.assets.taxonomy import category_named, members
from sceneweaver.geometry.walls import walls_of
from sceneweaver.language import Entity, SceneGraph, Thing, grounded
from sceneweaver.scene import InputError, Pose, Room, Scene, SceneObject
from sceneweaver.scene.edits import Remove, Rename, apply, apply_all

from .carry import move
from .draft import Draft, groups_of
from .exchange import exchanged
from .meant import matches
from .objects import added
from .relations import in_room
from .reshape import reshaped
from .setup import Setup

CORNERS = {"rectangle": 4, "L": 6, "T": 8, "U": 8, "round": 12}
"""Corners of the shapes that a request can name."""

KIN = frozenset(("bed_group", "chair_group"))
"""Groups of which any member may be exchanged for any other."""

SMALLEST = 0.02
"""Relative change of a floor below which it is left as it is."""


def begun_with(setup: Setup, scene: Scene, tool: str, name: str) -> Scene:
    """The scene under this request: what an older one asked for is forgotten, and where it comes from is told."""
    return scene.model_copy(
        update={
            "id": setup.room_type.name,
            "prompt": setup.brief.text,
            "dropped": (),
            "objects": tuple(_unasked(o) for o in scene.objects),
            "relations": tuple(r.model_copy(update={"asked": False}) for r in scene.relations),
            "provenance": {
                **scene.provenance,
                "tool": tool,
                "library": name,
                "room": setup.room_type.name,
                "seed": setup.seed,
            },
        }
    )


def adapted(setup: Setup, scene: Scene, tool: str, name: str) -> tuple[Scene, list[str], list[str]]:
    """The scene as the request wants it, what was decided, and what could not be done."""
    brief, notes, unmet = setup.brief, list[str](), list[str]()
    scene = begun_with(setup, scene, tool, name)
    if is_of_another_shape(scene, brief):
        scene, said = reshaped(setup, scene)
        notes += said
    else:
        scene = _floor(scene, brief, notes, unmet)
    scene = _without(scene, brief, notes)
    made: dict[str, list[str]] = {}
    later: list[Entity] = []
    for asked in brief.entities:
        scene, made[asked.id] = _found(setup, scene, asked, notes)
        least = asked.count[0] if asked.count else 1
        if len(made[asked.id]) < least:
            later.append(asked)
    if brief.only and brief.entities:
        named = {id for ids in made.values() for id in ids}
        scene = _removed(scene, [o.id for o in scene.objects if o.id not in named and o.mount != "ceiling"])
    for asked in later:
        scene = _added(setup, scene, asked, made, notes, unmet)
    return related(scene, brief, made, unmet), notes, unmet


def is_of_another_shape(scene: Scene, brief: SceneGraph) -> bool:
    """Whether the request names a shape that the floor of a scene does not have."""
    return brief.shape is not None and len(scene.room.outline) != CORNERS[brief.shape]


def _unasked(obj: SceneObject) -> SceneObject:
    """What an older request asked for is not what this one asks for."""
    priority = "usual" if obj.intent.priority == "asked" else obj.intent.priority
    return with_intent(obj, request=None, priority=priority)


def with_intent(obj: SceneObject, **intent: str | None) -> SceneObject:
    """The object with some fields of its intent changed."""
    return obj.model_copy(update={"intent": obj.intent.model_copy(update=intent)})


# ---- the floor ------------------------------------------------------------------------------------------------------


def _floor(scene: Scene, brief: SceneGraph, notes: list[str], unmet: list[str]) -> Scene:
    """The scene with the floor and the height that were asked for; objects keep their place in proportion."""
    room = scene.room
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    x0, y0, w, d = min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)
    fx = fy = 1.0
    if brief.size is not None:
        wide, deep = brief.size if w >= d else (brief.size[1], brief.size[0])
        fx, fy = wide / w, deep / d
    elif brief.area is not None or brief.scale != 1.0:
        import shapely

        have = shapely.Polygon(room.outline).area
        fx = fy = ((brief.area or have * brief.scale) / have) ** 0.5
    height = brief.height or room.height
    if abs(fx - 1) < SMALLEST and abs(fy - 1) < SMALLEST and height == room.height:
        fx = fy = 1.0
    if fx == fy == 1.0 and height == room.height:
        return scene

    def at(x: float, y: float) -> tuple[float, float]:
        return round(x0 + (x - x0) * fx, 6), round(y0 + (y - y0) * fy, 6)

    try:
        outline = tuple(at(x, y) for x, y in room.outline)
        after = Room.model_validate(
            {**room.model_dump(), "outline": outline, "height": height, **_openings(room, outline, height)}
        )
    except InputError as error:
        unmet.append(f"the floor stays {w:.2f} x {d:.2f} m: {error}")
        return scene
    poses = {}
    for o in scene.objects:
        if o.support is None:
            x, y, z = o.pose.position
            up = height - room.height if o.mount == "ceiling" else 0.0
            poses[o.id] = Pose(position=(*at(x, y), z + up), quaternion=o.pose.quaternion)
    edits = move(scene, poses)
    notes.append(f"the floor of {w:.2f} x {d:.2f} m was made {w * fx:.2f} x {d * fy:.2f} m")
    return apply_all(scene.model_copy(update={"room": after}), edits)[0]


def _openings(room: Room, outline: tuple[tuple[float, float], ...], height: float) -> dict[str, list[dict[str, Any]]]:
    """Doors and windows at the same share of their walls, as wide as they were or as the walls allow."""
    out: dict[str, list[dict[str, Any]]] = {"doors": [], "windows": []}
    walls = walls_of(outline)
    for key, openings in (("doors", room.doors), ("windows", room.windows)):
        for o in openings:
            old, new = room.walls[o.wall].length, walls[o.wall].length
            width = min(o.width, max(0.3, new - 0.1))
            middle = (o.offset + o.width / 2) * new / old
            data = {**o.model_dump(), "width": width, "offset": min(max(0.0, middle - width / 2), new - width)}
            data["height"] = min(o.height, height - getattr(o, "sill", 0.0) - 0.02)
            out[key].append(data)
    return out


# ---- objects --------------------------------------------------------------------------------------------------------


def _without(scene: Scene, brief: SceneGraph, notes: list[str]) -> Scene:
    banned = {name for word in brief.without for name in (word, *members(word))}
    gone = [o.id for o in scene.objects if o.category in banned]
    if gone:
        notes.append(f"without {', '.join(gone[:6])}")
    return _removed(scene, gone)


def _removed(scene: Scene, ids: list[str]) -> Scene:
    for id in ids:
        if id in scene.ids:
            scene = apply(scene, Remove(id=id, cascade=True))
    return scene


def _found(setup: Setup, scene: Scene, asked: Entity, notes: list[str]) -> tuple[Scene, list[str]]:
    """Objects of the scene that stand for something asked: those of its category, or others exchanged for it."""
    free = [o for o in scene.objects if o.intent.request is None]
    own = [o.id for o in free if o.category == asked.category]
    most = asked.count[1] if asked.count else max(1, len(own))
    spare, ids = own[most:], own[:most]
    if spare:
        notes.append(f"{len(spare)} {asked.category} fewer")
        scene = _removed(scene, spare)
    least = asked.count[0] if asked.count else 1
    if not ids:
        items = {i.id for i in setup.room_type.items if matches(asked.category, i)}
        others = [o.id for o in free if o.intent.program_item in items or _kin(o.category, asked.category)]
        for id in others[: max(least, 1)]:
            scene, new = _swapped(setup, scene, id, asked, notes)
            ids.append(new)
    else:
        for id in ids:
            if not _suits(scene.object(id), asked):
                scene, _ = _swapped(setup, scene, id, asked, notes)
    objects = tuple(with_intent(o, request=asked.id, priority="asked") if o.id in ids else o for o in scene.objects)
    return scene.model_copy(update={"objects": objects}), ids


def _kin(one: str, other: str) -> bool:
    """Whether one of two categories serves where the other is not wanted: beds, chairs, or two kinds of sofa."""
    if groups_of(one) & groups_of(other) & KIN:
        return True
    return one.rpartition("_")[2] == other.rpartition("_")[2] and bool(
        groups_of(one) & groups_of(other) - {"furniture"}
    )


def _suits(obj: SceneObject, asked: Entity) -> bool:
    """Whether an object looks as was asked."""
    for key in ("color", "material", "style"):
        want = getattr(asked, key)
        if want is not None and want.lower() not in str(obj.attributes.get(key, "")).lower():
            return False
    return all(want is None or abs(have - want) <= 0.06 * want for have, want in zip(obj.size, asked.size, strict=True))


def _swapped(setup: Setup, scene: Scene, id: str, asked: Entity, notes: list[str]) -> tuple[Scene, str]:
    """The scene with another body in the place of one, and its id."""
    old = scene.object(id)
    size: list[float | None] = list(asked.size)
    category = category_named(asked.category)
    if category.size is not None and asked.category == old.category:
        size = [want if want is not None else have for want, have in zip(size, old.size, strict=True)]
    wish = Wish(
        size=(size[0], size[1], size[2]),
        color=asked.color,
        material=asked.material,
        style=asked.style or setup.brief.style,
        palette=scene.palette.code if scene.palette is not None else None,
        words=" ".join(asked.words),
        seed=setup.seed % 2**31,
        count=4,
    )
    try:
        asset = setup.library.choose(asked.category, 1, wish)[0]
        edits = exchanged(scene, old, asset, setup.seed, notes, notes)
        after, _ = apply_all(scene, edits)
    except InputError as error:
        notes.append(f"{id} stays as it is: {error}")
        return scene, id
    if asked.category == old.category:
        return after, id
    new = Draft.of(after.model_copy(update={"objects": tuple(o for o in after.objects if o.id != id)})).fresh(
        asked.category
    )
    notes.append(f"{id} became {new}")
    return apply(after, Rename(id=id, new_id=new)), new


def _added(
    setup: Setup, scene: Scene, asked: Entity, made: dict[str, list[str]], notes: list[str], unmet: list[str]
) -> Scene:
    """The scene with what is missing of something asked."""
    least = asked.count[0] if asked.count else 1
    row: dict[str, Any] = {"category": asked.category, "count": least - len(made[asked.id]), "asked": asked.id}
    row.update({k: v for k in ("color", "material", "style") if (v := getattr(asked, k)) is not None})
    if asked.attributes:
        row["words"] = " ".join(a.words for a in asked.attributes)
    if asked.size != (None, None, None):
        row["size"] = list(asked.size)
    on = [
        id
        for said in setup.brief.relations
        if said.subject == asked.id and said.type in ("on", "inside")
        for target in said.targets
        for id in made.get(target, [])
    ]
    if on:
        row["on"] = on
    more = added(replace(setup, scene=scene), [row])
    notes += more.notes
    unmet += more.unmet
    before = set(scene.ids)
    scene, _ = apply_all(scene, more.edits)
    made[asked.id] += [id for id in scene.ids if id not in before]
    return scene


# ---- relations ------------------------------------------------------------------------------------------------------


def related(scene: Scene, brief: SceneGraph, made: Mapping[str, list[str]], unmet: list[str]) -> Scene:
    """The scene with the relations that were asked for."""
    draft = Draft.of(scene)
    things = {name: [_thing(draft.objects[id]) for id in ids if id in draft.objects] for name, ids in made.items()}
    rows, unsaid = grounded(brief, things)
    unmet += [f"{said.words or said.type}: no relation can say it here" for said in unsaid if not said.implied]
    for row, relation in in_room(rows, scene.room, unmet):
        same = [r for r in draft.relations if (r.type, r.subject, r.target) == (row.type, row.subject, relation.target)]
        draft.relations = [*(r for r in draft.relations if r not in same), relation]
    return scene.model_copy(update={"relations": tuple(draft.relations)})


def _thing(obj: SceneObject) -> Thing:
    return Thing(obj.id, obj.category, obj.size, obj.mount, obj.support.object if obj.support is not None else None)
