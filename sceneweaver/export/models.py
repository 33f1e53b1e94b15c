"""Meshes of a scene as files of their own: names that any file system takes, and assets that do have a mesh."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass

from sceneweaver.assets import Asset, Mesh
from sceneweaver.assets.placed import Load, loader
from sceneweaver.scene import InputError

from .bodies import Body


@dataclass(frozen=True)
class ModelFile:
    """A mesh in the object frame under its ``name``, and what a reader is told of it."""

    name: str
    mesh: Mesh
    category: str
    description: str
    materials: tuple[str, ...]


def model_name(key: str, category: str) -> str:
    """A name for a mesh: letters, digits, ``_`` and ``-`` only, another one for each key.

    Readers take model ids apart at dots and use them as names of files, and ids of assets may hold anything.
    """
    word = re.sub(r"[^a-z0-9]+", "_", category.lower()).strip("_")[:40] or "object"
    return f"{word}-{hashlib.sha256(key.encode()).hexdigest()[:10]}"


def model_of(body: Body) -> ModelFile:
    """The file of a body; bodies with an equal key have the same."""
    used = dict.fromkeys(body.mesh.materials[int(k)].name for k in body.mesh.face_material)
    kind = body.object.category
    return ModelFile(model_name(body.key, kind), body.mesh, kind, body.object.description or "", tuple(used))


def with_mesh(load: Load | None) -> Load:
    """The loader, which refuses assets without a single triangle; None: that of this user's library."""
    given = loader(load)

    def checked(object_id: str) -> Asset:
        asset = given(object_id)
        if not len(asset.mesh.faces):
            raise InputError(f"asset: '{object_id}' has no mesh; import it again or choose another asset")
        return asset

    return checked
