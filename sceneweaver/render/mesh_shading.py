"""What a mesh needs to be drawn besides its triangles: normals at their corners."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sceneweaver.assets.body import Mesh
from sceneweaver.assets.by_identity import ByIdentity

_CREASE = np.cos(np.radians(36.0))


def prepared(mesh: Mesh) -> np.ndarray:
    """Corner normals [3 F, 3] of a mesh, kept for when it is drawn again."""
    return _prepared(ByIdentity(mesh))


@lru_cache(maxsize=512)
def _prepared(mesh: ByIdentity[Mesh]) -> np.ndarray:
    return corner_normals(mesh.it)


def corner_normals(mesh: Mesh) -> np.ndarray:
    """A unit normal for each triangle corner, [3 F, 3]: smooth over edges that bend by less than 36 degrees."""
    v, f = mesh.vertices, mesh.faces
    normal = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
    unit = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-18)
    corner = f.reshape(-1)
    owner = np.repeat(np.arange(len(f)), 3)
    order = np.argsort(corner, kind="stable")
    counts = np.bincount(corner, minlength=len(v))
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    # Every pair of triangles around a vertex.
    size = counts[corner]
    mine = np.repeat(np.arange(len(corner)), size)
    step = np.arange(len(mine)) - np.repeat(np.cumsum(size) - size, size)
    other = owner[order[starts[corner[mine]] + step]]
    alike = np.einsum("ij,ij->i", unit[owner[mine]], unit[other]) > _CREASE
    total = np.zeros((len(corner), 3))
    for k in range(3):
        total[:, k] = np.bincount(mine[alike], normal[other[alike], k], len(corner))
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.where(length > 1e-18, total / np.maximum(length, 1e-18), unit[owner])
