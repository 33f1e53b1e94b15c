"""Another body for an object where it is: what it carries stays on it where there is room."""

from __future__ import annotations

from collections.abc import Mapping
from urllib.parse import parse_qsl, urlencode

from sceneweaver.assets import Asset, Library, Wish
from sceneweaver.geometry.polygons import rectangle
from sceneweaver.geometry.se2 import SE2
from sceneweaver.scene import Scene, SceneObject, Support, Surface
from sceneweaver.scene.edits import AnyEdit, Remove, Replace, SetPose, SetSupport

from .carry import carried, follow, local, world
from .surface_spots import LIFT, spot_on

Size = tuple[float, float, float]

PARAMETRIC = "parametric:"


def exchanged(
    scene: Scene, obj: SceneObject, asset: Asset, seed: int, notes: list[str], unmet: list[str]
) -> list[AnyEdit]:
    """Edits that give an object another body where it is; what it carries stays on it where there is room."""
    made = asset.object(obj.id, pose=obj.pose, mount=obj.mount, support=obj.support)
    made = made.model_copy(update={"intent": obj.intent, "fixed": obj.fixed})
    if obj.mount == "ceiling":
        x, y, _ = obj.pose.position
        top = scene.room.height - made.size[2]
        made = made.model_copy(update={"pose": obj.pose.model_copy(update={"position": (x, y, top)})})
    return _with_riders(scene, obj, made, seed, notes, unmet)


def resized_body(library: Library, obj: SceneObject, size: Size, seed: int) -> Asset | None:
    """The same design in another size; for what was imported another body; None for what has no body at all."""
    if obj.asset is None:
        return None
    if obj.asset.startswith(PARAMETRIC):
        name, _, query = obj.asset.partition("?")
        recipe = {**dict(parse_qsl(query, keep_blank_values=True)), "size": ",".join(f"{s:.6g}" for s in size)}
        return library.load(f"{name}?{urlencode(recipe, safe=',')}").of_style(obj.attributes.get("style"))
    color, material, style = (
        v if isinstance(v := obj.attributes.get(k), str) else None for k in ("color", "material", "style")
    )
    wish = Wish(size=size, color=color, material=material, style=style, seed=seed % 2**31, count=4)
    return library.choose(obj.category, 1, wish)[0]


def _with_riders(
    scene: Scene, old: SceneObject, new: SceneObject, seed: int, notes: list[str], unmet: list[str]
) -> list[AnyEdit]:
    """The exchange of a body, with what stands on it put where it fits on the new one."""
    objects = {o.id: o for o in scene.objects}
    riders = [o for o in scene.objects if o.support is not None and o.support.object == old.id]
    before: list[AnyEdit] = []
    after: list[AnyEdit] = []
    placed = {id: o for id, o in objects.items() if id == old.id or id not in carried(objects, old.id)}
    placed[old.id] = new
    for rider in sorted(riders, key=lambda o: -o.size[0] * o.size[1]):
        found = _stays(old, new, rider, placed) or spot_on(placed, scene.room, [new.id], rider.size, seed)
        if found is None:
            before.append(Remove(id=rider.id, cascade=True))
            grave = rider.intent.priority == "asked"
            (unmet if grave else notes).append(f"{rider.id} has no place on the new {new.id}")
            continue
        support, pose = found
        if support != rider.support:
            before.append(SetSupport(id=rider.id, support=None))
            after.append(SetSupport(id=rider.id, support=support))
        after.append(SetPose(id=rider.id, pose=pose))
        placed[rider.id] = rider.model_copy(update={"pose": pose, "support": support})
        for k in carried(objects, rider.id):
            moved = follow(rider.pose, pose, objects[k].pose)
            after.append(SetPose(id=k, pose=moved))
            placed[k] = objects[k].model_copy(update={"pose": moved})
    return [*before, Replace(object=new), *after]


def _stays(old: SceneObject, new: SceneObject, rider: SceneObject, placed: Mapping[str, SceneObject]):
    """Support and pose where a thing keeps its place in proportion to the size; None when it does not fit there."""
    import shapely

    surface = _like(old, new, rider)
    if surface is None or (surface.headroom is not None and surface.headroom < rider.size[2] + LIFT):
        return None
    x, y, _, yaw = local(old.pose, rider.pose)
    x, y = x * new.size[0] / old.size[0], y * new.size[1] / old.size[1]
    ground = shapely.Polygon(surface.polygon).buffer(1e-6)
    shape = _foot(rider, x, y, yaw)
    if not ground.covers(shape):
        return None
    support = Support(object=new.id, surface=surface.name)
    for o in placed.values():
        if o.support == support:
            ox, oy, _, turn = local(new.pose, o.pose)
            if _foot(o, ox, oy, turn).intersection(shape).area > 1e-6:
                return None
    return support, world(new.pose, x, y, surface.z, yaw)


def _foot(obj: SceneObject, x: float, y: float, yaw: float):
    import shapely

    return shapely.Polygon([SE2(x, y, yaw).world(u, v) for u, v in rectangle(*obj.size[:2])])


def _like(old: SceneObject, new: SceneObject, rider: SceneObject) -> Surface | None:
    """The new surface that corresponds to the one a thing stands on: of its name, else at the same share of height."""
    assert rider.support is not None
    for surface in new.surfaces:
        if surface.name == rider.support.surface:
            return surface
    share = next((s.z / old.size[2] for s in old.surfaces if s.name == rider.support.surface), None)
    if share is None or not new.surfaces:
        return None
    return min(new.surfaces, key=lambda s: abs(s.z / new.size[2] - share))
