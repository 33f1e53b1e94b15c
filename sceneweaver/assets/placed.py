"""Objects of a scene as bodies: an asset in the object's size, or the object's own parts in a plain finish."""

from __future__ import annotations

import contextlib
import zlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from sceneweaver.geometry.prisms import prism_mesh
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError, Part, SceneObject

from .asset import Asset
from .body import Material, Mesh
from .materials import color_named, finish, tinted
from .sources import Library

Load = Callable[[str], Asset]
"""From the id of an asset to the asset; ``Library().load`` is one."""

SAME_SIZE = 1e-5
"""Length [m] by which an object may differ from its asset and not count as scaled; sizes are rounded to 1e-6."""

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


def loader(load: Load | None = None) -> Load:
    """``load``, or the library of this user, with each asset loaded once."""
    return cache(load or Library().load)


def welded_assets(load: Load | None = None) -> Load:
    """As ``load``, but what could be taken off an asset is part of its base: a link without hulls moves nothing."""
    inner = loader(load)

    def welded(asset_id: str) -> Asset:
        asset = inner(asset_id)
        loose = {number for number, link in enumerate(asset.links, 1) if link.joint == "free"}
        if not loose:
            return asset
        hulls = tuple(replace(h, link=0) if h.link in loose else h for h in asset.hulls)
        return replace(asset, hulls=hulls, drawn_as=f"{asset.geometry}#welded")

    return welded


def scaled_asset(index: int, thing: SceneObject, load: Load) -> tuple[Asset | None, tuple[float, float, float]]:
    """The asset of ``objects[index]``, if it has one, and the factors that bring it to the object's size.

    Raises:
        InputError: the asset is not known, or its files are gone or broken; the text names the field.
    """
    if thing.asset is None:
        return None, (1.0, 1.0, 1.0)
    checkpoint()
    try:
        asset = load(thing.asset)
    except InputError as error:
        raise InputError(f"objects[{index}].asset: {str(error).removeprefix('asset: ')}") from None
    except (EOFError, KeyError, OSError, ValueError) as error:
        what = f"'{thing.asset}' cannot be read ({type(error).__name__}: {error})"
        raise InputError(f"objects[{index}].asset: {what}; import it again") from None
    factors = np.asarray(thing.size) / np.maximum(np.asarray(asset.size), 1e-9)
    if np.max(np.abs(factors - 1) * np.asarray(thing.size)) < SAME_SIZE:
        return asset, (1.0, 1.0, 1.0)
    x, y, z = factors.tolist()
    return asset, (x, y, z)


def plain_material(thing: SceneObject) -> Material:
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


def parts_mesh(parts: Sequence[Part], material: Material) -> Mesh:
    """The mesh of convex prisms: each one a closed piece of its own."""
    pieces = [prism_mesh(part.polygon, part.z) for part in parts]
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in pieces)])
    faces = [own + start for (_, own), start in zip(pieces, starts, strict=False)]
    triangles = np.concatenate(faces).astype(np.int32)
    zeros = np.zeros(len(triangles), dtype=np.int32)
    return Mesh(np.concatenate([vertices for vertices, _ in pieces]), triangles, zeros, zeros, (material,))
