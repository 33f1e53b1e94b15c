"""Polygons under many poses at once, in float64; see `twin`."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.layout.region import EVERYWHERE
from sceneweaver.layout.shapes import Prism

Array = np.ndarray


def placed(polygon: Array, pose: Array) -> Array:
    """A polygon [V, 2] in the world under poses [K, 4]: [K, V, 2]."""
    z = np.exp(1j * pose[:, 3:4]) * (polygon[:, 0] + 1j * polygon[:, 1])
    return np.stack([z.real, z.imag], axis=-1) + pose[:, None, :2]


def _gaps(own: Array, other: Array) -> tuple[Array, Array]:
    """Gap between the shadows of two polygons on the outward normal of each face of the first: [K, faces].

    And the vertex of the other that is nearest along it: [K, faces].
    """
    along = np.roll(own, -1, axis=1) - own
    normal = np.stack([along[..., 1], -along[..., 0]], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    mine, theirs = normal @ own.transpose(0, 2, 1), normal @ other.transpose(0, 2, 1)
    return theirs.min(axis=2) - mine.max(axis=2), theirs.argmin(axis=2)


def separation(a: Array, b: Array, real: Sequence[bool] | None = None, parted: float = 0.0) -> Array:
    """Separating-axis distance over the face normals of both [K]; minus the depth where polygons [K, V, 2] overlap.

    Faces of b that are not ``real`` are no way out, nor are directions in which a would end on a vertex beside such a
    face. Such closed directions part the two, to any distance, when the gap is more than ``parted``; else they count
    only when there are no open ones.
    """
    real = np.asarray(real or [True] * b.shape[1])
    gaps, closed = [], []
    if a.shape[1] > 2:
        gap, vertex = _gaps(a, b)
        gaps.append(gap)
        closed.append(~(real & np.roll(real, 1))[vertex])
    if b.shape[1] > 2:
        gaps.append(_gaps(b, a)[0])
        closed.append(np.broadcast_to(~real, gaps[-1].shape))
    gap, shut = np.concatenate(gaps, axis=1), np.concatenate(closed, axis=1)
    way_out = np.where(shut, -np.inf, gap).max(axis=1)
    no_way = np.where(shut, gap, -np.inf).max(axis=1)
    return np.where(no_way > parted, np.inf, np.where(shut.all(axis=1), no_way, way_out))


def distance(a: Array, b: Array) -> Array:
    """Euclidean distance of polygons [K, V, 2]; minus the depth where they overlap.

    b may be points [K, 1, 2] or segments [K, 2, 2].
    """
    import shapely

    shapes = {1: lambda: shapely.points(b[:, 0]), 2: lambda: shapely.linestrings(b)}
    other = shapes.get(b.shape[1], lambda: shapely.polygons(b))()
    apart = shapely.distance(shapely.polygons(a), other)
    return np.where(apart > 0.0, apart, separation(a, b))


def shared_height(a: Prism, za: Array, b: Prism, zb: Array) -> Array:
    """Length that the z intervals of two prisms have in common; negative when they are apart.

    What is outside of the room is so at all heights, also for what has next to none itself.
    """
    if EVERYWHERE in (tuple(a.z), tuple(b.z)):
        return np.full(np.broadcast(za, zb).shape, np.inf)
    return np.minimum(za + a.z[1], zb + b.z[1]) - np.maximum(za + a.z[0], zb + b.z[0])


def reach(prisms: Sequence[Prism]) -> float:
    """Distance of the farthest vertex from the object's origin."""
    return max((float(np.hypot(*np.asarray(p.polygon).T).max()) for p in prisms), default=0.0)
