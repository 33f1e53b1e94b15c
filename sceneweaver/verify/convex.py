"""Convex bodies in three dimensions, for tilted objects and meshes: penetration depth and exact solids.

Depth is the distance from the origin to the boundary of the Minkowski difference A - B, which is the least translation
that parts A and B. Solids are manifold3d's.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from sceneweaver.verify.solids import Array

EXACT_POINTS = 20_000
"""Vertex pairs up to which the Minkowski difference is built; larger hulls use the face normals of both only."""


def hull_vertices(points: Array) -> Array:
    """Return the vertices of the convex hull of ``points`` [n, 3]; all of them when they are flat."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        return points


def _normals(points: Array) -> Array:
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
    axes = np.concatenate([_normals(a), _normals(b), np.eye(3)])
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

    The directions tried are the normals of the shared pieces, the sums of those of different pieces, and the axes:
    enough for faces that touch. Used for concave meshes, whose hulls overlap where they themselves only touch.
    """
    axes = [_thinnest(piece) for piece in (a ^ b).decompose()]
    thin = [n for n, width in axes if width <= by]
    if len(thin) < len(axes):
        return False
    tried = _directions(thin)
    return any(shared_volume(a.translate(tuple(by * d)), b) <= allowed for d in tried)


def thickness(piece: Any) -> float:
    """Largest over the connected parts of a manifold of the least width [m]."""
    return max((_thinnest(p)[1] for p in piece.decompose()), default=0.0)


def _thinnest(piece: Any) -> tuple[Array, float]:
    """Face normal of the hull of ``piece`` along which it is thinnest, and that width [m]."""
    points = np.asarray(piece.to_mesh64().vert_properties)[:, :3]
    axes = np.concatenate([_normals(points), np.eye(3)])
    projected = points @ axes.T
    widths = projected.max(axis=0) - projected.min(axis=0)
    best = int(widths.argmin())
    return axes[best], float(widths[best])


def _directions(normals: list[Array]) -> list[Array]:
    """Both senses of each distinct normal, and of the sums of two and three of them, as unit vectors."""
    distinct: list[Array] = []
    for n in normals:
        if all(abs(float(n @ m)) < 0.999 for m in distinct):
            distinct.append(n)
    out = [s * n for n in distinct for s in (1.0, -1.0)]
    for depth_of in range(2, min(3, len(distinct)) + 1):
        first = distinct[:3]
        for signs in np.ndindex(*(2,) * depth_of):
            total = sum((1 - 2 * s) * n for s, n in zip(signs, first, strict=False))
            length = float(np.linalg.norm(total))
            if length > 1e-9:
                out.append(np.asarray(total) / length)
    return out
