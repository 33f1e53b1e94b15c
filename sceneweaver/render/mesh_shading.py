"""What a mesh needs to be drawn besides its triangles: normals at their corners, and the way that wood grows in it."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sceneweaver.assets.body import Mesh

_CREASE = np.cos(np.radians(36.0))


class _Keep:
    """A mesh as a cache's argument: equal to all, as the id beside it tells meshes apart, and kept alive by it."""

    def __init__(self, mesh: Mesh):
        self.mesh = mesh

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Keep) and other.mesh is self.mesh

    def __hash__(self) -> int:
        return id(self.mesh)


def prepared(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Corner normals [3 F, 3] and grain [F] of a mesh, kept for when it is drawn again."""
    return _prepared(id(mesh), _Keep(mesh))


@lru_cache(maxsize=512)
def _prepared(_: int, keep: _Keep) -> tuple[np.ndarray, np.ndarray]:
    return corner_normals(keep.mesh), _grain(keep.mesh)


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


def _grain(mesh: Mesh) -> np.ndarray:
    """The axis along which a triangle's piece is longest, [F]: the way that wood grows in it."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    f = mesh.faces
    edges = np.concatenate([f[:, :2], f[:, 1:]])
    shape = (len(mesh.vertices),) * 2
    graph = coo_matrix((np.ones(len(edges), dtype=np.int8), (edges[:, 0], edges[:, 1])), shape=shape)
    count, label = connected_components(graph, directed=False)
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, label, mesh.vertices)
    np.maximum.at(high, label, mesh.vertices)
    return np.argmax(high - low, axis=1)[label[f[:, 0]]]
