"""What every object of a scene looks like: a mesh in its own frame, shared by all that have the same one."""

from __future__ import annotations

import contextlib
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Literal

import numpy as np

from sceneweaver.assets import Asset, Material, Mesh
from sceneweaver.assets.materials import color_named, finish, tinted
from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.scene import InputError, Part, Scene, SceneObject

Load = Callable[[str], Asset]
"""From the id of an asset to the asset; ``Library().load`` is one."""

Missing = Literal["error", "parts"]
"""What happens to an object whose asset cannot be loaded: an error, or it is shown as its parts."""

_SAME_SIZE = 1e-5  # [m], relative to the extents of furniture: sizes of assets are rounded to 1e-6

_CLAYS = tuple(
    Material(f"{name} clay", color, roughness=0.8)
    for name, color in (
        ("sand", (0.80, 0.74, 0.65)),
        ("sage", (0.66, 0.72, 0.62)),
        ("rose", (0.80, 0.65, 0.60)),
        ("sky", (0.64, 0.71, 0.78)),
        ("ochre", (0.80, 0.68, 0.47)),
        ("plum", (0.67, 0.60, 0.69)),
        ("chalk", (0.83, 0.82, 0.79)),
    )
)
"""What a body without a mesh is made of unless its attributes say: one of these by its category."""


@dataclass(frozen=True)
class Body:
    """The look of one object.

    ``mesh`` is in the frame of the asset; bodies with an equal ``key`` have the same. ``scale`` [3] brings it to the
    object's size, (1, 1, 1) unless someone gave the object another size than its asset has. ``note`` says what had
    to be done without, empty when nothing.
    """

    object: SceneObject
    key: str
    mesh: Mesh
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    note: str = ""


def bodies_of(scene: Scene, load: Load | None = None, missing: Missing = "error") -> list[Body]:
    """The bodies of all objects, in their order; each asset is loaded once.

    Raises:
        InputError: when an asset cannot be loaded, unless ``missing`` is "parts".
    """
    load = cache(load or _library())
    return [_body(index, thing, load, missing) for index, thing in enumerate(scene.objects)]


def prisms(parts: Sequence[Part], material: Material) -> Mesh:
    """The mesh of convex prisms: each one a closed piece of its own."""
    pieces = [prism_mesh(part.polygon, part.z) for part in parts]
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in pieces)])
    faces = [own + start for (_, own), start in zip(pieces, starts, strict=False)]
    triangles = np.concatenate(faces).astype(np.int32)
    zeros = np.zeros(len(triangles), dtype=np.int32)
    return Mesh(np.concatenate([vertices for vertices, _ in pieces]), triangles, zeros, zeros, (material,))


def _body(index: int, thing: SceneObject, load: Load, missing: Missing) -> Body:
    if thing.asset is None:
        return _plain(thing)
    try:
        asset = load(thing.asset)
    except InputError as error:
        if missing == "error":
            raise InputError(f"objects[{index}].asset: {str(error).removeprefix('asset: ')}") from None
        return _plain(thing, f"{thing.id}: its mesh is missing, its collision parts are shown")
    factors = np.asarray(thing.size) / np.maximum(np.asarray(asset.size), 1e-9)
    if np.max(np.abs(factors - 1) * np.asarray(thing.size)) < _SAME_SIZE:
        factors = np.ones(3)
    x, y, z = (float(f) for f in factors)
    return Body(thing, thing.asset, asset.mesh, (x, y, z))


def _plain(thing: SceneObject, note: str = "") -> Body:
    """The parts of an object as they are."""
    material = _material_of(thing)
    shape = ";".join(f"{p.polygon}{p.z}" for p in thing.solids)
    return Body(thing, f"parts:{material.name}:{shape}", prisms(thing.solids, material), note=note)


def _material_of(thing: SceneObject) -> Material:
    """The finish that an object's attributes name; else the clay of its category."""
    found = _CLAYS[zlib.crc32(thing.category.encode()) % len(_CLAYS)]
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


__all__ = ["Body", "Load", "Missing", "bodies_of", "prisms"]
