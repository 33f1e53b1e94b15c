"""Where each object's mesh stands, and which objects a picture leaves out."""

from __future__ import annotations

import contextlib
import zlib
from collections.abc import Callable, Collection
from functools import cache

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.materials import color_named, finish, tinted
from sceneweaver.geometry.rotations import matrix
from sceneweaver.geometry.walls import wall_behind
from sceneweaver.scene import InputError, Scene, SceneObject

from .caster import Instance
from .room_blocks import Builder

Load = Callable[[str], Asset]

_CLAYS = (
    (0.80, 0.74, 0.65),
    (0.66, 0.72, 0.62),
    (0.80, 0.65, 0.60),
    (0.64, 0.71, 0.78),
    (0.80, 0.68, 0.47),
    (0.67, 0.60, 0.69),
    (0.83, 0.82, 0.79),
)


def instances_of(scene: Scene, load: Load | None = None) -> list[Instance]:
    """One instance an object, in their order; objects without an asset are drawn as their parts.

    Raises:
        InputError: when an asset cannot be loaded.
    """
    load = cache(load or _library())
    return [_instance(k, thing, load) for k, thing in enumerate(scene.objects)]


def hidden_with(scene: Scene, cut: Collection[int]) -> set[str]:
    """Ids of the objects that hang on walls that are cut away, and of all that stands on those objects."""
    walls = scene.room.walls
    hung = [o for o in scene.objects if o.mount == "wall"]
    gone = {o.id for o in hung if wall_behind(walls, o.pose.position, o.pose.frame.axis) in cut}
    grown = True
    while grown:
        more = {o.id for o in scene.objects if o.support is not None and o.support.object in gone} - gone
        gone |= more
        grown = bool(more)
    return gone


def _instance(index: int, thing: SceneObject, load: Load) -> Instance:
    place = np.eye(4)
    place[:3, :3] = matrix(thing.pose.quaternion)
    place[:3, 3] = thing.pose.position
    if thing.asset is None:
        return Instance(_parts_mesh(thing), place)
    try:
        asset = load(thing.asset)
    except InputError as error:
        raise InputError(f"objects[{index}].asset: {str(error).removeprefix('asset: ')}") from None
    factors = np.asarray(thing.size) / np.maximum(np.asarray(asset.size), 1e-9)
    if np.max(np.abs(factors - 1.0) * np.asarray(thing.size)) > 1e-5:  # [m]; sizes are rounded to 1e-6
        place[:3, :3] = place[:3, :3] * factors
    return Instance(asset.mesh, place)


def _parts_mesh(thing: SceneObject) -> Mesh:
    builder, look = Builder(), material_of(thing)
    for part in thing.solids:
        builder.prism(np.asarray(part.polygon, dtype=float), part.z, look)
    mesh = builder.mesh()
    assert mesh is not None  # every object has at least its box
    return mesh


def material_of(thing: SceneObject) -> Material:
    """What the attributes of an object say; else a clay by its category."""
    number = zlib.crc32(thing.category.encode()) % len(_CLAYS)
    found = Material(f"clay {number}", _CLAYS[number], roughness=0.8)
    material, color = thing.attributes.get("material"), thing.attributes.get("color")
    if isinstance(material, str):
        with contextlib.suppress(KeyError):  # any words may stand there
            found = finish(material.strip().lower()).material
    if isinstance(color, str):
        with contextlib.suppress(InputError):
            found = tinted(found, color_named(color))
    return found


def _library() -> Load:
    from sceneweaver.assets import Library

    return Library().load
