"""A radiance cache: the light on the surfaces of a room in cells of a grid, with all bounces, for all of its views.

Points spread over all surfaces are lit by sun, sky and lamps, and look around for the cells that they see. What goes to
and fro between the cells is then a sparse linear system per colour, which a few products solve.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from . import cache_kernels, world_kernels
from .lights import Emitters, emitters
from .rays import launch
from .world import Geometry, linear_color

_MOST_CELLS = 6_000_000
_POINTS = 6.0  # on each face of a cell
_MOST_POINTS = 600_000
_KEPT = 12  # points of a cell that are lit at most
_SHADOW_RAYS = 2
_BOUNCE_RAYS = 6
_BOUNCES = 12
_PATCH = 1.2  # side [m] of the blocks whose sunlit cells make one lamp


def build_cache(
    world: Any, lights: Any, geometry: Geometry, low: np.ndarray, high: np.ndarray, cell: float
) -> tuple[Any, Emitters]:
    """The cache of everything between ``low`` and ``high`` [3], on the current device, and patches of sun as lamps.

    Cells have sides of ``cell`` [m], larger ones in a large box.
    """
    cache = world_kernels.Cache()
    span = high - low
    while np.prod(np.ceil(span / cell) + 1) * 6 > _MOST_CELLS:
        cell *= 1.25
    shape = (np.ceil(span / cell) + 1).astype(int)
    low = low - 0.37 * cell  # faces that lie in planes of the grid would fall to either side
    cache.low, cache.cell = wp.vec3(*low), cell
    cache.nx, cache.ny, cache.nz = (int(n) for n in shape)
    spread = _spread_points(geometry, low, low + shape * cell, cell)
    entry = _entries(spread.points, spread.normals, low, cell, shape)
    cells, order = _grouped(entry)
    row = np.searchsorted(cells, entry[order])
    some = Spread(spread.points[order], spread.normals[order], spread.color[order], spread.area[order])
    index = np.full(int(np.prod(shape)) * 6, -1, dtype=np.int32)
    index[cells] = np.arange(len(cells))
    cache.index = wp.array(index, dtype=int)
    cache.light = cache.bounced = wp.zeros(max(len(cells), 1), dtype=wp.vec3)
    cache.mean = wp.vec3(0.0)
    if not len(cells):
        return cache, emitters([])
    area = np.bincount(np.searchsorted(cells, entry), spread.area, len(cells))
    light, sun = _solved(world, lights, cache, some, row, len(cells))
    patches, lamps = _sun_patches(some, row, sun, area, cell)
    cache.light = wp.array(light, dtype=wp.vec3)
    cache.bounced = wp.array(np.where(lamps[:, None], light - sun, light), dtype=wp.vec3)
    cache.mean = wp.vec3(*np.median(light, axis=0))
    return cache, patches


@dataclass(frozen=True)
class Spread:
    """Points on surfaces [N, 3], their unit normals [N, 3], linear colours [N, 3] and the area [N] each stands for
    [m2], 0 on see-through ones."""

    points: np.ndarray
    normals: np.ndarray
    color: np.ndarray
    area: np.ndarray


def _solved(
    world: Any, lights: Any, cache: Any, spread: Spread, row: np.ndarray, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Irradiance over pi of each cell [count, 3] with all bounces, and that by the sun alone [count, 3]."""
    from scipy.sparse import csr_matrix

    n, rays = len(spread.points), _BOUNCE_RAYS
    places = [wp.array(spread.points, dtype=wp.vec3), wp.array(spread.normals, dtype=wp.vec3)]
    found = cache_kernels.PointLight()
    found.direct, found.sun, found.inside = (wp.zeros(n, dtype=kind) for kind in (wp.vec3, wp.vec3, float))
    found.hit, found.color = wp.zeros(n * rays, dtype=int), wp.zeros(n * rays, dtype=wp.vec3)
    launch(cache_kernels.light_points, n, [world, lights, cache, *places, _SHADOW_RAYS, rays], [found])
    # Points within bodies are in the dark, and not seen: where a cell has others, those stand for it.
    share = np.where(found.inside.numpy() > 0.5, 1e-6, 1.0)
    share = share / np.bincount(row, share, count)[row]
    sun, own = (
        np.stack([np.bincount(row, a.numpy()[:, k] * share, count) for k in range(3)], axis=1)
        for a in (found.sun, found.direct)
    )
    own = own + sun
    target, albedo = found.hit.numpy(), found.color.numpy()
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
    return light, sun


def _sun_patches(
    spread: Spread, row: np.ndarray, sun: np.ndarray, area: np.ndarray, cell: float
) -> tuple[Emitters, np.ndarray]:
    """The cells on which the sun falls as lamps, some of a neighbourhood to each, and which cells these are [count]."""
    count = len(sun)
    points = np.bincount(row, minlength=count)[:, None]

    def mean(values: np.ndarray) -> np.ndarray:
        return np.stack([np.bincount(row, values[:, k], count) for k in range(3)], axis=1) / points

    bright = sun.mean(axis=1)
    chosen = (bright > 0.1 * bright.max()) & (area > 0.02 * cell**2)
    if bright.max() <= 0 or not chosen.any():
        return emitters([]), np.zeros(count, dtype=bool)
    normal = mean(spread.normals)
    normal = normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-9)
    middle = (mean(spread.points) + 0.01 * normal)[chosen]
    radiance = (mean(spread.color) * sun)[chosen]
    normal, size = normal[chosen], np.sqrt(area[chosen])
    # An even triangle about the middle with the area of the cell's surfaces.
    aside = np.cross(normal, np.where(np.abs(normal[:, :1]) > 0.7, (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)))
    aside = aside / np.linalg.norm(aside, axis=1, keepdims=True)
    other = np.cross(normal, aside)
    reach = (size * np.sqrt(4 / (3 * np.sqrt(3))))[:, None]
    turns = np.radians((0.0, 120.0, 240.0))
    corners = np.stack([middle + reach * (np.cos(t) * aside + np.sin(t) * other) for t in turns], axis=1)
    block = np.floor(middle / _PATCH).astype(int)
    _, group = np.unique(block, axis=0, return_inverse=True)
    group = group.reshape(-1)
    return emitters([(corners[group == k], radiance[group == k], -1) for k in range(group.max() + 1)], True), chosen


def _spread_points(geometry: Geometry, low: np.ndarray, high: np.ndarray, cell: float) -> Spread:
    """Points spread evenly over all surfaces in a box, on both sides of see-through ones."""
    corners = geometry.corners
    clear = np.arange(len(corners)) >= geometry.opaque
    near = ((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)).all(axis=1)
    corners, clear, look = corners[near], clear[near], geometry.material[near]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1) / 2
    kept = area > 1e-10
    corners, clear, normal, area, look = corners[kept], clear[kept], normal[kept], area[kept], look[kept]
    if not len(area):
        none = np.zeros((0, 3))
        return Spread(none, none, none, np.zeros(0))
    normal = normal / (2 * area[:, None])
    count = int(np.clip(_POINTS * area.sum() / cell**2, 64, _MOST_POINTS))
    at = (np.arange(count) + 0.5) / count * area.sum()
    face = np.minimum(np.searchsorted(np.cumsum(area), at), len(area) - 1)
    k = np.arange(count)
    u, v = (0.5 + 0.7548776662466927 * k) % 1.0, (0.5 + 0.5698402909980532 * k) % 1.0
    r = np.sqrt(u)[:, None]
    a, b, c = (corners[face, j] for j in range(3))
    points, normals = a * (1 - r) + b * (r * (1 - v[:, None])) + c * (r * v[:, None]), normal[face]
    color = np.array([linear_color(m) * (1 - 0.15 * m.metallic) for m in geometry.materials])[look[face]]
    stands = np.where(clear[face], 0.0, area.sum() / count)
    back = clear[face]
    points, normals = np.concatenate([points, points[back]]), np.concatenate([normals, -normals[back]])
    color, stands = np.concatenate([color, color[back]]), np.concatenate([stands, stands[back]])
    inside = ((points >= low) & (points < high)).all(axis=1)
    return Spread(points[inside], normals[inside], color[inside], stands[inside])


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
