"""Files that the exports of many scenes share, each named by its content: meshes and images."""

from __future__ import annotations

import json
from collections.abc import Callable, Hashable
from typing import Protocol

from sceneweaver.assets.journal import Journal, journal_key
from sceneweaver.assets.recent import Recent

from .glb_mesh import PackedMesh, Primitive


class Store(Protocol):
    """Where shared files are kept."""

    def put(self, content: bytes, suffix: str) -> str:
        """Keep a content under a suffix ("bin", "obj", "png", ...); the path by which scenes name it."""
        ...

    def holds(self, path: str, size: int) -> bool:
        """Whether a file of that path and size [bytes] is there."""
        ...


class SharedFiles:
    """The meshes and images of many scenes in a store.

    What was put there once is known by its key from then on, so that it is neither made nor written again. Keys hold
    those of the geometry of assets: all scenes must have their assets from one library.

    Args:
        store: Keeps the files.
        used: Is told the id of an asset and the path of a file of it, whenever a scene names that.
        journal: Tells other processes what is in the store.
    """

    def __init__(self, store: Store, used: Callable[[str, str], None], journal: Journal):
        self._store, self._used, self._journal = store, used, journal
        self._paths: Recent[Hashable, str] = Recent(16 * 2**20, lambda path: len(path) + 512)
        self._meshes: Recent[Hashable, tuple[PackedMesh, str]] = Recent(64 * 2**20, lambda kept: kept[0].nbytes)

    def path(self, key: Hashable, suffix: str, make: Callable[[], bytes]) -> str:
        """The path of a file of that key; where it is of an asset, `uses` tells."""
        return self._paths.get((suffix, key), lambda: self._path(journal_key(suffix, key), suffix, make))

    def uses(self, asset: str, path: str) -> None:
        """Note that a file is one of those of an asset."""
        self._used(asset, path)

    def mesh(self, asset: str, key: Hashable, make: Callable[[], PackedMesh]) -> tuple[PackedMesh, str]:
        """A mesh of an asset without its data, and the path of these."""
        found = self._meshes.get(key, lambda: self._mesh(journal_key("mesh", key), make))
        self._used(asset, found[1])
        return found

    def _path(self, key: bytes, suffix: str, make: Callable[[], bytes]) -> str:
        told = self._journal.get(key)
        if told is not None:
            path, size = json.loads(told)
            if self._store.holds(path, size):
                return path
        content = make()
        path = self._store.put(content, suffix)
        self._journal.put(key, json.dumps([path, len(content)]).encode())
        return path

    def _mesh(self, key: bytes, make: Callable[[], PackedMesh]) -> tuple[PackedMesh, str]:
        told = self._journal.get(key)
        if told is not None:
            path, size, row = json.loads(told)
            if self._store.holds(path, size):
                return _mesh_of(row), path
        made = make()
        path = self._store.put(made.data, "bin")
        kept = made.without_data()
        row = {"views": kept.views, "accessors": kept.accessors, "primitives": [vars(p) for p in kept.primitives]}
        self._journal.put(key, json.dumps([path, len(made.data), row]).encode())
        return kept, path


def _mesh_of(row: dict) -> PackedMesh:
    """The mesh of a row in a journal."""
    primitives = tuple(Primitive(**primitive) for primitive in row["primitives"])
    return PackedMesh(b"", tuple(row["views"]), tuple(row["accessors"]), primitives)
