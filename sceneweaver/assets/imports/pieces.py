"""A mesh as its connected pieces, after vertices at one place have been joined."""

from __future__ import annotations

import numpy as np

_LOOSE = 48
"""So many pieces more than by shared vertices may sharing edges make before it is not believed."""


def pieces_of(vertices: np.ndarray, faces: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """The pieces as (vertices, faces).

    Triangles hang together by edges that just two of them share: boards that touch along an edge, where four meet, stay
    apart. Where that leaves hardly anything together (doubled triangles, say), sharing a vertex is enough.
    """
    points, triangles = welded(vertices, faces)
    a, b, c = triangles.T
    triangles = triangles[(a != b) & (b != c) & (c != a)]
    if not len(triangles):
        return []
    loose = linked(len(points), triangles[:, :2], triangles[:, 1:])[triangles[:, 0]]
    strict = _by_edges(triangles)
    of_face = strict if strict.max() <= 4 * loose.max() + _LOOSE else loose
    order = np.argsort(of_face, kind="stable")
    pieces = []
    for mine in np.split(order, np.flatnonzero(np.diff(of_face[order])) + 1):
        used, packed = np.unique(triangles[mine], return_inverse=True)
        pieces.append((points[used], packed.reshape(-1, 3)))
    return pieces


def welded(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices at one place (to 1e-7 of the extent) as one, and the faces that name them; none is dropped."""
    scale = max(float(np.ptp(vertices, axis=0).max()), 1e-9)
    _, first, joined = np.unique(np.round(vertices / scale, 7), axis=0, return_index=True, return_inverse=True)
    return vertices[first], joined.reshape(-1)[faces]


def linked(count: int, *edges: np.ndarray) -> np.ndarray:
    """The number of the connected piece of each of ``count`` things that edges [E, 2] join."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    pairs = np.concatenate(edges)
    graph = coo_matrix((np.ones(len(pairs), dtype=np.int8), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return connected_components(graph, directed=False)[1]


def _by_edges(triangles: np.ndarray) -> np.ndarray:
    """The piece of each triangle, where only edges of two triangles join."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    owner = np.tile(np.arange(len(triangles)), 3)
    _, name, counts = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    pairs = owner[np.argsort(name.reshape(-1), kind="stable")]
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])[counts == 2]
    return linked(len(triangles), np.stack([pairs[starts], pairs[starts + 1]], axis=1))
