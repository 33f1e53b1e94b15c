"""What the corners of triangles have of their own: smooth normals, texture coordinates, tangents."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets import Mesh
from sceneweaver.assets.recent import Recent
from sceneweaver.assets.textures import maps, uv_of
from sceneweaver.assets.textures.catalogue import found as pattern

_CREASE = math.radians(40)  # edges at most this sharp are shaded round
_FINE = 10_000  # steps of a normal's coordinates: equal ones are stored once
_UV_STEP = 2e-5  # texture coordinates [repeats] this close are one


@dataclass(frozen=True)
class Surface:
    """The faces of a mesh that are of one material, with a vertex for each different corner.

    ``number`` is that of the material; ``points``, ``normals`` float [N, 3]; ``uv`` float [N, 2] in repeats of the
    maps, v up, or None where the material has none; ``tangents`` float [N, 4]: the way of u, and 1 or -1 for the side
    on which v is; ``faces`` int [F, 3].
    """

    number: int
    points: np.ndarray
    normals: np.ndarray
    uv: np.ndarray | None
    tangents: np.ndarray | None
    faces: np.ndarray


def map_sizes(mesh: Mesh) -> tuple[tuple[float, float] | None, ...]:
    """Width and height of one repeat of the maps of each material [m]; None for those without."""
    return tuple(None if (found := maps(m.texture)) is None else found.size for m in mesh.materials)


def laid_by(mesh: Mesh) -> Hashable:
    """What of its materials the texture coordinates of a mesh follow from: sizes of maps, and grain where it has none
    of its own."""
    own = mesh.uv is not None
    return map_sizes(mesh), None if own else tuple((p := pattern(m.texture)) and p.grain for m in mesh.materials)


def texture_coordinates(mesh: Mesh) -> np.ndarray | None:
    """Coordinates of each corner in repeats of its material's maps, v up, [F, 3, 2]; None when no material has maps."""
    sizes = map_sizes(mesh)
    if not any(sizes[int(k)] for k in np.unique(mesh.face_material)):
        return None
    return uv_of(mesh) / np.array([size or (1.0, 1.0) for size in sizes])[mesh.face_material][:, None, :]


def indexed(uv: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Different coordinates [N, 2] of corners [F, 3, 2], and which of them each corner has [3 F]."""
    steps = np.rint(uv.reshape(-1, 2) / _UV_STEP).astype(np.int64)
    steps -= steps.min(axis=0)
    key = steps @ np.array([int(steps[:, 1].max()) + 1, 1])
    _, first, index = np.unique(key, return_index=True, return_inverse=True)
    return uv.reshape(-1, 2)[first], index.reshape(-1)


def surfaces(mesh: Mesh, plain: bool = False) -> list[Surface]:
    """A mesh by material, in their order; ``plain``: without texture coordinates."""
    normals, index = corner_normals(mesh.vertices, mesh.faces)
    index = index.reshape(-1, 3)
    uv = None if plain else texture_coordinates(mesh)
    found = []
    for number in np.unique(mesh.face_material):
        chosen, material = mesh.face_material == number, mesh.materials[int(number)]
        own = None if uv is None or maps(material.texture) is None else uv[chosen]
        found.append(_surface(int(number), mesh.vertices, mesh.faces[chosen], normals, index[chosen], own))
    return found


def _surface(number: int, points: np.ndarray, faces: np.ndarray, normals: np.ndarray, index: np.ndarray, uv) -> Surface:
    corner = faces.astype(np.int64) * len(normals) + index
    if uv is None:
        kept, packed = np.unique(corner, return_inverse=True)
        vertex, normal = kept // len(normals), normals[kept % len(normals)]
        return Surface(number, points[vertex], normal, None, None, packed.reshape(-1, 3))
    # Whole repeats more or less show the same: coordinates stay near 0, where floats are fine.
    uv = uv - np.floor(uv.reshape(-1, 2).min(axis=0))
    along, side = _tangents(points[faces], uv)
    steps = np.rint(uv / _UV_STEP).astype(np.int64).reshape(-1, 2)
    first, packed = first_of_each([corner.ravel(), *steps.T, np.repeat(side > 0, 3)])
    normal = normals[index.ravel()[first]]
    total = np.stack([np.bincount(packed, np.repeat(along[:, k], 3), len(first)) for k in range(3)], 1)
    total -= (total * normal).sum(1, keepdims=True) * normal
    length = np.linalg.norm(total, axis=1, keepdims=True)
    other = np.cross(normal, np.where(np.abs(normal[:, :1]) < 0.9, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
    other /= np.linalg.norm(other, axis=1, keepdims=True)
    tangent = np.where(length > 1e-9, total / np.maximum(length, 1e-9), other)
    hand = np.repeat(side, 3)[first].astype(float)
    return Surface(
        number,
        points[faces.ravel()[first]],
        normal,
        uv.reshape(-1, 2)[first],
        np.column_stack([tangent, hand]),
        packed.reshape(-1, 3),
    )


def first_of_each(columns: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Of rows of integers from 0, by columns [N]: where each different row stands first, and which of them each is.

    They are in the order of their numbers, the first column before the others.
    """
    spans = [int(column.max(initial=0)) + 1 for column in columns]
    if math.prod(spans) < 2**63:  # one number for each row: sorted many times quicker
        rows = np.zeros(len(columns[0]), dtype=np.int64)
        for column, span in zip(columns, spans, strict=True):
            rows = rows * span + column
        _, first, packed = np.unique(rows, return_index=True, return_inverse=True)
    else:
        _, first, packed = np.unique(np.stack(columns, 1), axis=0, return_index=True, return_inverse=True)
    return first, packed.reshape(-1)


def _tangents(corners: np.ndarray, uv: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The way of u on each face, unit [F, 3], and 1 or -1 for the side on which v is [F]."""
    e1, e2 = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    d1, d2 = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    area = d1[:, 0] * d2[:, 1] - d2[:, 0] * d1[:, 1]
    side = np.where(area < 0, -1, 1)
    along = (e1 * d2[:, 1:] - e2 * d1[:, 1:]) * side[:, None]
    return along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-30), side


def corner_normals(points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Unit normals [N, 3], and which of them each corner has [3 F], face by face.

    Corners at one vertex share a normal where the edges between their faces are flat or rounded, so that a turned leg
    is round and a box keeps its edges.
    """
    key = hashlib.blake2b(np.ascontiguousarray(points).tobytes(), digest_size=16)
    key.update(np.ascontiguousarray(faces).tobytes())
    return _NORMALS.get(key.digest(), lambda: _corner_normals(points, faces))


_NORMALS: Recent[bytes, tuple[np.ndarray, np.ndarray]] = Recent(32 * 2**20, lambda found: sum(a.nbytes for a in found))
"""Normals by content: furniture of one shape has the same in every finish."""


def _corner_normals(points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    corners = points[faces]
    before, after = corners[:, [2, 0, 1]] - corners, corners[:, [1, 2, 0]] - corners
    flat = np.cross(after[:, 0], before[:, 0])
    flat /= np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-30)
    lengths = np.linalg.norm(before, axis=2) * np.linalg.norm(after, axis=2)
    angles = np.arccos(np.clip((before * after).sum(axis=2) / np.maximum(lengths, 1e-30), -1, 1))

    # Edges as (low vertex, high vertex), with the corners at both ends; two faces meet where equal ones follow.
    start, end = faces, faces[:, [1, 2, 0]]
    number = np.arange(faces.size).reshape(-1, 3)
    turned = start > end
    low = np.where(turned, number[:, [1, 2, 0]], number).ravel()
    high = np.where(turned, number, number[:, [1, 2, 0]]).ravel()
    key = (np.minimum(start, end).astype(np.int64) * len(points) + np.maximum(start, end)).ravel()
    order = np.argsort(key, kind="stable")
    one, two = order[:-1], order[1:]
    meet = (key[one] == key[two]) & ((flat[one // 3] * flat[two // 3]).sum(axis=1) > math.cos(_CREASE))
    one, two = one[meet], two[meet]
    rows, columns = np.concatenate([low[one], high[one]]), np.concatenate([low[two], high[two]])
    graph = coo_matrix((np.ones(len(rows), dtype=np.int8), (rows, columns)), shape=(faces.size, faces.size))
    count, group = connected_components(graph, directed=False)

    weighted = (flat[:, None] * angles[:, :, None]).reshape(-1, 3)
    total = np.stack([np.bincount(group, weighted[:, k], count) for k in range(3)], axis=1)
    length = np.linalg.norm(total, axis=1)
    total[length < 1e-12] = (0.0, 0.0, 1.0)  # faces without area: any will do
    total /= np.linalg.norm(total, axis=1, keepdims=True)
    steps = np.rint(total * _FINE).astype(np.int64) + _FINE
    span = 2 * _FINE + 1
    packed, which = np.unique((steps[:, 0] * span + steps[:, 1]) * span + steps[:, 2], return_inverse=True)
    found = np.stack([packed // span**2, packed // span % span, packed % span], axis=1) - float(_FINE)
    return found / np.linalg.norm(found, axis=1, keepdims=True), which.reshape(-1)[group]
