"""Convex bodies in three dimensions, for tilted objects and meshes: penetration depth and exact solids.

Depth is the distance from the origin to the boundary of the Minkowski difference A - B, which is the least translation
that parts A and B. Solids are manifold3d's.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product
from typing import Any

import numpy as np

from sceneweaver.verify.solids import Array

EXACT_POINTS = 20_000
"""Vertex pairs up to which the Minkowski difference is built; larger hulls use the face normals of both only."""

MAIN_NORMALS = 4
"""Normals of a shared solid along which touching meshes are parted."""

CONVEX_SHARE = 0.9
"""Share of its hull's volume from which a solid counts as convex."""


def hull_vertices(points: Array) -> Array:
    """Return the vertices of the convex hull of ``points`` [n, 3]; all of them when they are flat."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        return points


def normals(points: Array) -> Array:
    """Unit normals of the faces of the convex hull of ``points`` [n, 3] as [f, 3]; none when they are flat."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return ConvexHull(points).equations[:, :3]
    except (QhullError, ValueError):
        return np.empty((0, 3))


def depth(a: Array, b: Array) -> float:
    """Penetration depth [m] of the hulls of ``a`` [n, 3] and ``b`` [m, 3]; 0 when they are apart.

    Exact up to `EXACT_POINTS` vertex pairs. Above, an upper bound that leaves out edge-against-edge directions.
    """
    from scipy.spatial import ConvexHull, QhullError

    if np.any(a.min(axis=0) >= b.max(axis=0)) or np.any(b.min(axis=0) >= a.max(axis=0)):
        return 0.0
    if len(a) * len(b) <= EXACT_POINTS:
        try:
            offsets = ConvexHull((a[:, None] - b[None]).reshape(-1, 3)).equations[:, 3]
        except QhullError:
            return 0.0
        return max(0.0, float(-offsets.max()))
    axes = np.concatenate([normals(a), normals(b), np.eye(3)])
    pa, pb = a @ axes.T, b @ axes.T
    reach = np.minimum(pa.max(axis=0) - pb.min(axis=0), pb.max(axis=0) - pa.min(axis=0))
    return max(0.0, float(reach.min()))


def solid(points: Array) -> Any:
    """Return the convex hull of ``points`` [n, 3] as a ``manifold3d.Manifold`` (empty when they are flat)."""
    import manifold3d

    return manifold3d.Manifold.hull_points(np.ascontiguousarray(points, dtype=float))


def union(solids: list[Any]) -> Any:
    """Return the union of manifolds."""
    import manifold3d

    if len(solids) == 1:
        return solids[0]
    return manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)


def shared_volume(a: Any, b: Any) -> float:
    """Volume of the intersection of two manifolds [m3]."""
    return max(0.0, float((a ^ b).volume()))


def separable(a: Any, b: Any, by: float, allowed: float) -> bool:
    """Whether moving manifold ``a`` by ``by`` metres in some direction leaves at most ``allowed`` m3 shared with ``b``.

    The directions tried are the main normals of what they share and the sums of two and three of them, which is enough
    for faces that touch. Used for concave meshes, whose hulls overlap where they themselves only touch.
    """
    shared = a ^ b
    if shared.volume() > by * shared.surface_area() / 2:  # thicker than ``by`` on average, seen from any side
        return False
    axes = _main_normals(shared)
    return any(shared_volume(a.translate(tuple(by * d)), b) <= allowed for d in _directions(axes))


def thickness(shared: Any) -> float:
    """Depth [m] of a shared solid by its thickest connected piece: its least width, or the mean one if it is bent."""
    deepest = 0.0
    for piece in shared.decompose():
        points = np.asarray(piece.to_mesh64().vert_properties)[:, :3]
        axes = np.concatenate([normals(points), np.eye(3)])
        projected = points @ axes.T
        width = float((projected.max(axis=0) - projected.min(axis=0)).min())
        if piece.volume() < CONVEX_SHARE * solid(points).volume():
            width = min(width, 2 * piece.volume() / piece.surface_area())
        deepest = max(deepest, width)
    return deepest


def _main_normals(shared: Any) -> list[Array]:
    """Up to `MAIN_NORMALS` unit normals of a solid's surface, those with the most area first, either sense once."""
    mesh = shared.to_mesh64()
    corners = np.asarray(mesh.vert_properties)[:, :3][np.asarray(mesh.tri_verts)]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1)
    cross, area = cross[area > 0], area[area > 0]
    found: list[Array] = []
    while len(area) and len(found) < MAIN_NORMALS:
        normals = cross / area[:, None]
        alike = np.abs(normals @ normals[area.argmax()]) > 0.999
        found.append(normals[area.argmax()])
        cross, area = cross[~alike], area[~alike]
    return found


def _directions(axes: list[Array]) -> Iterator[Array]:
    """Both senses of every axis, then of all sums of two and three axes, as unit vectors."""
    for count in (1, 2, 3):
        for chosen in combinations(axes, count):
            for signs in product((1.0, -1.0), repeat=count):
                total = np.sum([s * n for s, n in zip(signs, chosen, strict=True)], axis=0)
                length = float(np.linalg.norm(total))
                if length > 1e-6:
                    yield total / length
