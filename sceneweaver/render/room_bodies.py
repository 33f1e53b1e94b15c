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
from sceneweaver.scene import InputError, Scene, SceneObject

from .caster import Instance
from .room_blocks import Builder
from .room_shell import frames_of

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
    frames = frames_of(scene.room)
    gone: set[str] = set()
    for thing in scene.objects:
        if thing.mount == "wall" and frames:
            point, front = np.asarray(thing.pose.position[:2]), _front(thing)
            gaps = []
            for k, frame in enumerate(frames):
                rel = point - frame.start
                s = float(np.clip(rel @ frame.along, 0.0, frame.length))
                # It turns its back to its wall: another wall, nearer at a corner, is not the one.
                turned = 0.5 * max(0.0, 1.0 + float(front @ frame.outward))
                gaps.append((float(np.linalg.norm(rel - s * frame.along)) + turned, k))
            if min(gaps)[1] in cut:
                gone.add(thing.id)
    grown = True
    while grown:
        more = {o.id for o in scene.objects if o.support is not None and o.support.object in gone} - gone
        gone |= more
        grown = bool(more)
    return gone


def _front(thing: SceneObject) -> np.ndarray:
    return np.array([np.cos(thing.pose.yaw), np.sin(thing.pose.yaw)])


def _instance(index: int, thing: SceneObject, load: Load) -> Instance:
    matrix = np.eye(4)
    matrix[:3, :3] = _rotation(thing.pose.quaternion)
    matrix[:3, 3] = thing.pose.position
    if thing.asset is None:
        return Instance(_parts_mesh(thing), matrix)
    try:
        asset = load(thing.asset)
    except InputError as error:
        raise InputError(f"objects[{index}].asset: {str(error).removeprefix('asset: ')}") from None
    factors = np.asarray(thing.size) / np.maximum(np.asarray(asset.size), 1e-9)
    if np.max(np.abs(factors - 1.0) * np.asarray(thing.size)) > 1e-5:  # [m]; sizes are rounded to 1e-6
        matrix[:3, :3] = matrix[:3, :3] * factors
    return Instance(asset.mesh, matrix)


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


def _rotation(quaternion: tuple[float, float, float, float]) -> np.ndarray:
    """The rotation matrix [3, 3] of a unit quaternion x, y, z, w."""
    x, y, z, w = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _library() -> Load:
    from sceneweaver.assets import Library

    return Library().load
