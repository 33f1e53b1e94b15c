"""Files that the exports of many scenes share, each named by its content: meshes and images."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from weakref import WeakKeyDictionary

from sceneweaver.assets.recent import Recent
from sceneweaver.physics.hulls import Solid

from .glb_mesh import PackedMesh


class SharedFiles:
    """A place for the meshes and images of many scenes.

    What was put there once is known by its key from then on, so that it is neither made nor written again. Keys hold
    ids of assets: all scenes must have their assets from one library.

    Args:
        put: Keeps a content under a suffix ("bin", "obj", "png", ...) and returns the path by which scenes name it.
        used: Is told the id of an asset and the path of a file of it, whenever a scene names that.
    """

    def __init__(self, put: Callable[[bytes, str], str], used: Callable[[str, str], None]):
        self._put, self._used = put, used
        self._paths: Recent[Hashable, str] = Recent(16 * 2**20, lambda path: len(path) + 512)
        self._meshes: Recent[Hashable, tuple[PackedMesh, str]] = Recent(64 * 2**20, lambda kept: kept[0].nbytes)
        self._hulls: WeakKeyDictionary[Solid, str] = WeakKeyDictionary()

    def path(self, key: Hashable, suffix: str, make: Callable[[], bytes], asset: str | None = None) -> str:
        """The path of a file of that key, perhaps of an asset."""
        path = self._paths.get((suffix, key), lambda: self._put(make(), suffix))
        if asset is not None:
            self._used(asset, path)
        return path

    def mesh(self, asset: str, key: Hashable, make: Callable[[], PackedMesh]) -> tuple[PackedMesh, str]:
        """A mesh of an asset without its data, and the path of these."""

        def put() -> tuple[PackedMesh, str]:
            made = make()
            return made.without_data(), self._put(made.data, "bin")

        found = self._meshes.get(key, put)
        self._used(asset, found[1])
        return found

    def hull(self, asset: str | None, solid: Solid, make: Callable[[], bytes]) -> str:
        """The path of the mesh of a collision part."""
        if solid not in self._hulls:
            self._hulls[solid] = self._put(make(), "obj")
        if asset is not None:
            self._used(asset, self._hulls[solid])
        return self._hulls[solid]
