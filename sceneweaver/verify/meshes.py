"""Meshes of assets: where they are found, and the exact solids that they enclose.

A mesh is given in its object's frame (metres, z up, front +x, origin at the bottom centre of the box), exactly as the
vertices stand in the file: no axis is converted. A mesh that does not enclose a volume has no solid, and its object is
judged by its parts instead.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.io import InputError, read_mesh
from sceneweaver.scene import SceneObject
from sceneweaver.verify import convex
from sceneweaver.verify.solids import DEPTH, Array

SUFFIXES = (".glb", ".obj", ".stl", ".ply")
"""File types looked for in a folder of meshes, in this order."""


class MeshBody:
    """One asset's mesh: ``vertices`` [n, 3] in metres and ``faces`` [m, 3]."""

    def __init__(self, asset: str, mesh: Any) -> None:
        """Take a ``trimesh.Trimesh`` (anything with ``vertices`` and triangular ``faces``)."""
        self.asset = asset
        self.vertices: Array = np.array(getattr(mesh, "vertices", ()), dtype=float)
        self.faces: NDArray[np.int64] = np.array(getattr(mesh, "faces", ()), dtype=np.int64)
        if self.vertices.ndim != 2 or not len(self.faces):
            raise InputError(f"meshes[{asset!r}]: no triangles; give a trimesh.Trimesh or a mesh file")
        if not np.isfinite(self.vertices).all():
            raise InputError(f"meshes[{asset!r}]: vertices must be finite numbers")

    @cached_property
    def hull(self) -> Array:
        """Vertices of the convex hull [k, 3]."""
        return convex.hull_vertices(self.vertices)

    @cached_property
    def solid(self) -> Any | None:
        """The enclosed solid as a manifold3d manifold, overlapping shells united; None when the mesh is not closed."""
        import manifold3d

        points, index = np.unique(self.vertices, axis=0, return_inverse=True)
        faces = index.reshape(-1)[self.faces]
        a, b, c = faces.T
        faces = faces[(a != b) & (b != c) & (c != a)]
        mesh = manifold3d.Mesh64(np.ascontiguousarray(points), np.ascontiguousarray(faces, dtype=np.uint64))
        whole = manifold3d.Manifold(mesh)
        if whole.status() != manifold3d.Error.NoError or whole.is_empty():
            return None
        shells = whole.decompose()
        if any(shell.volume() < 0 for shell in shells):  # cavities keep their orientation
            return whole if whole.volume() > 0 else None
        joined = convex.union(shells)
        return joined if joined.volume() > 0 else None

    def outside(self, item: SceneObject) -> float:
        """How far the mesh reaches out of the parts of ``item`` [m]; 0 when they contain it."""
        least = np.full(len(self.vertices), np.inf)
        for part in item.solids:
            flat = np.asarray(part.polygon, dtype=float)
            edge = np.roll(flat, -1, axis=0) - flat
            normal = np.stack([edge[:, 1], -edge[:, 0]], axis=1)
            length = np.linalg.norm(normal, axis=1)
            normal, start = normal[length > 0] / length[length > 0, None], flat[length > 0]
            turn = np.sign(np.sum(flat[:, 0] * np.roll(flat[:, 1], -1) - np.roll(flat[:, 0], -1) * flat[:, 1]))
            side = turn * (self.vertices[:, :2] @ normal.T - np.sum(normal * start, axis=1))
            z = self.vertices[:, 2]
            beyond = np.maximum.reduce([side.max(axis=1), part.z[0] - z, z - part.z[1]])
            least = np.minimum(least, beyond)
        return max(0.0, float(least.max()))


class MeshSet:
    """Meshes by asset id, loaded when first asked for and kept.

    Make one and pass it to every `check` of a batch: solids are then built once.
    """

    def __init__(self, source: Mapping[str, Any] | str | Path | None) -> None:
        """``source``: asset id -> trimesh or mesh file, or a folder that holds ``<asset>`` + one of `SUFFIXES`."""
        self._mapping: Mapping[str, Any] = {}
        self._folder: Path | None = None
        self._bodies: dict[str, MeshBody | None] = {}
        self._outside: dict[tuple[str, Any], float] = {}
        if isinstance(source, Mapping):
            self._mapping = source
        elif source is not None:
            self._folder = Path(source)
            if not self._folder.is_dir():
                raise InputError(f"meshes: {source} is not a folder; give a folder, or a mapping of asset id to mesh")

    @classmethod
    def of(cls, source: MeshSet | Mapping[str, Any] | str | Path | None) -> MeshSet:
        """Return ``source`` itself when it is a set already."""
        return source if isinstance(source, MeshSet) else cls(source)

    def get(self, asset: str | None) -> MeshBody | None:
        """Return the mesh of ``asset``, or None when there is none."""
        if asset is None:
            return None
        if asset not in self._bodies:
            mesh = self._mapping.get(asset) if self._folder is None else self._file(asset)
            if isinstance(mesh, str | Path):
                mesh = _load(asset, Path(mesh))
            self._bodies[asset] = None if mesh is None else MeshBody(asset, mesh)
        return self._bodies[asset]

    def stick_out(self, item: SceneObject, body: MeshBody) -> str | None:
        """One line when the mesh reaches more than 1 mm out of the parts of ``item``, which gate its collisions."""
        key = (body.asset, item.parts)
        if key not in self._outside:
            self._outside[key] = body.outside(item) if item.parts else 0.0
        by = self._outside[key]
        return f"{item.id}: its mesh reaches {by * 100:.1f} cm out of its collision parts" if by > DEPTH else None

    def _file(self, asset: str) -> Path | None:
        assert self._folder is not None
        root = self._folder.resolve()
        for suffix in SUFFIXES:
            path = root / f"{asset}{suffix}"
            if os.path.isfile(path) and path.resolve().is_relative_to(root):
                return path
        return None


def part_points(item: SceneObject, body: MeshBody | None) -> list[Array]:
    """Convex pieces of an object in its frame, as vertices [k, 3]: its parts, or the hull of a mesh without parts."""
    if body is not None and not item.parts:
        return [body.hull]
    return [prism_vertices(p.polygon, p.z) for p in item.solids]


def _load(asset: str, path: Path) -> Any:
    try:
        return read_mesh(path)
    except InputError as error:
        raise InputError(f"meshes[{asset!r}]: {error}") from None
