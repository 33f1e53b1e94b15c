"""A radiance cache: the light on the surfaces of a room in cells of a grid, with all bounces, for all of its views.

Points spread over all surfaces are lit by sun, sky and lamps, and look around for the cells that they see. What goes to
and fro between the cells is then a sparse linear system per colour, which a few products solve.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp

from . import cache_kernels, world_kernels
from .bands import launch
from .world import Geometry

CELL = 0.11
"""Side [m] of a cell in rooms of usual size."""

_MOST_CELLS = 6_000_000
_POINTS = 6.0  # on each face of a cell
_MOST_POINTS = 600_000
_KEPT = 12  # points of a cell that are lit at most
_SHADOW_RAYS = 2
_BOUNCE_RAYS = 6
_BOUNCES = 12


def build_cache(world: Any, lights: Any, geometry: Geometry, low: np.ndarray, high: np.ndarray) -> Any:
    """The cache of everything between ``low`` and ``high`` [3], on the current device."""
    cache = world_kernels.Cache()
    span = high - low
    cell = CELL
    while np.prod(np.ceil(span / cell) + 1) * 6 > _MOST_CELLS:
        cell *= 1.25
    shape = (np.ceil(span / cell) + 1).astype(int)
    low = low - 0.37 * cell  # faces that lie in planes of the grid would fall to either side
    cache.low, cache.cell = wp.vec3(*low), cell
    cache.nx, cache.ny, cache.nz = (int(n) for n in shape)
    points, normals = _spread_points(geometry, low, low + shape * cell, cell)
    entry = _entries(points, normals, low, cell, shape)
    cells, order = _grouped(entry)
    points, normals, row = points[order], normals[order], np.searchsorted(cells, entry[order])
    index = np.full(int(np.prod(shape)) * 6, -1, dtype=np.int32)
    index[cells] = np.arange(len(cells))
    cache.index = wp.array(index, dtype=int)
    cache.light = wp.zeros(max(len(cells), 1), dtype=wp.vec3)
    cache.mean = wp.vec3(0.0)
    if len(cells):
        light = _solved(world, lights, cache, points, normals, row, len(cells))
        cache.light = wp.array(light, dtype=wp.vec3)
        cache.mean = wp.vec3(*np.median(light, axis=0))
    return cache


def _solved(
    world: Any, lights: Any, cache: Any, points: np.ndarray, normals: np.ndarray, row: np.ndarray, count: int
) -> np.ndarray:
    """Irradiance over pi of each cell [count, 3] with all bounces."""
    from scipy.sparse import csr_matrix

    n, rays = len(points), _BOUNCE_RAYS
    direct, color = wp.zeros(n, dtype=wp.vec3), wp.zeros(n * rays, dtype=wp.vec3)
    hit, inside = wp.zeros(n * rays, dtype=int), wp.zeros(n, dtype=float)
    places = [wp.array(points, dtype=wp.vec3), wp.array(normals, dtype=wp.vec3)]
    launch(
        cache_kernels.light_points,
        n,
        [world, lights, cache, *places, _SHADOW_RAYS, rays],
        [],
        [direct, hit, color, inside],
    )
    # Points within bodies are in the dark, and not seen: where a cell has others, those stand for it.
    share = np.where(inside.numpy() > 0.5, 1e-6, 1.0)
    share = share / np.bincount(row, share, count)[row]
    own = np.stack([np.bincount(row, direct.numpy()[:, k] * share, count) for k in range(3)], axis=1)
    target, albedo = hit.numpy(), color.numpy()
    seen = target >= 0
    ends = (np.repeat(row, rays)[seen], target[seen])
    light = np.empty_like(own)
    weight = np.repeat(share, rays)[seen] / rays
    for k in range(3):
        throw = csr_matrix((weight * albedo[seen, k], ends), shape=(count, count))
        total = own[:, k]
        for _ in range(_BOUNCES):
            total = own[:, k] + throw @ total
        light[:, k] = total
    return light


def _spread_points(geometry: Geometry, low: np.ndarray, high: np.ndarray, cell: float) -> tuple[np.ndarray, np.ndarray]:
    """Points [N, 3] spread evenly over all surfaces in a box and their unit normals; both sides of see-through ones."""
    corners = geometry.corners
    clear = np.arange(len(corners)) >= geometry.opaque
    near = ((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)).all(axis=1)
    corners, clear = corners[near], clear[near]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1) / 2
    kept = area > 1e-10
    corners, clear, normal, area = corners[kept], clear[kept], normal[kept], area[kept]
    if not len(area):
        return np.zeros((0, 3)), np.zeros((0, 3))
    normal = normal / (2 * area[:, None])
    count = int(np.clip(_POINTS * area.sum() / cell**2, 64, _MOST_POINTS))
    at = (np.arange(count) + 0.5) / count * area.sum()
    face = np.minimum(np.searchsorted(np.cumsum(area), at), len(area) - 1)
    k = np.arange(count)
    u, v = (0.5 + 0.7548776662466927 * k) % 1.0, (0.5 + 0.5698402909980532 * k) % 1.0
    r = np.sqrt(u)[:, None]
    a, b, c = (corners[face, j] for j in range(3))
    points, normals = a * (1 - r) + b * (r * (1 - v[:, None])) + c * (r * v[:, None]), normal[face]
    back = clear[face]
    points, normals = np.concatenate([points, points[back]]), np.concatenate([normals, -normals[back]])
    inside = ((points >= low) & (points < high)).all(axis=1)
    return points[inside], normals[inside]


def _entries(points: np.ndarray, normals: np.ndarray, low: np.ndarray, cell: float, shape: np.ndarray) -> np.ndarray:
    """The entry of the grid [N] that each point belongs to; as `world_kernels.cell_of` finds it."""
    at = np.floor((points + normals * (0.02 * cell) - low) / cell).astype(int)
    at = np.clip(at, 0, shape - 1)
    axis = np.argmax(np.abs(normals), axis=1)
    side = 2 * axis + (normals[np.arange(len(normals)), axis] <= 0)
    return ((at[:, 2] * shape[1] + at[:, 1]) * shape[0] + at[:, 0]) * 6 + side


def _grouped(entry: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The entries that have points, sorted, and the points to light, at most `_KEPT` of each."""
    order = np.argsort(entry, kind="stable")
    sorted_entry = entry[order]
    cells, start, count = np.unique(sorted_entry, return_index=True, return_counts=True)
    rank = np.arange(len(entry)) - np.repeat(start, count)
    step = np.repeat(np.maximum(np.ceil(count / _KEPT), 1), count)
    return cells, order[rank % step == 0] if len(entry) else order
