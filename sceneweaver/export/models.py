"""Meshes of a scene as files of their own: names that any file system takes, and assets that do have a mesh."""

from __future__ import annotations

import hashlib
import re

from sceneweaver.assets import Asset
from sceneweaver.assets.placed import Load, loader
from sceneweaver.scene import InputError


def model_name(key: str, category: str) -> str:
    """A name for a mesh: letters, digits, ``_`` and ``-`` only, another one for each key.

    Readers take model ids apart at dots and use them as names of files, and ids of assets may hold anything.
    """
    word = re.sub(r"[^a-z0-9]+", "_", category.lower()).strip("_")[:40] or "object"
    return f"{word}-{hashlib.sha256(key.encode()).hexdigest()[:10]}"


def with_mesh(load: Load | None) -> Load:
    """The loader, which refuses assets without a single triangle; None: that of this user's library."""
    given = loader(load)

    def checked(object_id: str) -> Asset:
        asset = given(object_id)
        if not len(asset.mesh.faces):
            raise InputError(f"asset: '{object_id}' has no mesh; import it again or choose another asset")
        return asset

    return checked
