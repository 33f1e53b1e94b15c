"""Shortest ways on foot over the free floor of layouts, in float64: Dijkstra's algorithm on a grid."""

from __future__ import annotations

import heapq
import math

import numpy as np

from sceneweaver.scene import Scene

from .floor_grid import HIGH, LOW, Grid

WALKER = 0.2
"""[m] that the middle of who walks keeps from bodies and walls."""


def detour(scene: Scene) -> float:
    """What is added to the straight line where there is no way: once around the room [m]."""
    return sum(wall.length for wall in scene.room.walls)


def shortest_ways(scene: Scene, poses: np.ndarray, pins: np.ndarray) -> np.ndarray:
    """Lengths [B] of the ways between two pins [B, 2, 2] in layouts [B, N, 4], from cell to one of eight neighbours.

    A way begins and ends at the free cells nearest to the pins, and is never shorter than the straight line.
    """
    return np.array([_way(scene, layout, at) for layout, at in zip(poses, pins, strict=True)])


def _way(scene: Scene, layout: np.ndarray, pins: np.ndarray) -> float:
    import shapely

    outline = shapely.Polygon(scene.room.outline)
    grid = Grid(outline.bounds)
    nx, ny = grid.shape
    x = grid.box[0] + grid.cell * (np.arange(nx) + 0.5)
    y = grid.box[1] + grid.cell * (np.arange(ny) + 0.5)
    middles = shapely.points(*np.meshgrid(x, y))
    solid = shapely.unary_union(_plans(scene, layout))
    inside = shapely.contains(outline, middles) & (shapely.distance(outline.exterior, middles) >= WALKER)
    free = np.asarray(inside)
    if not solid.is_empty:
        free = free & (shapely.distance(solid, middles) >= WALKER)
    straight = math.dist(*pins)
    if not free.any():
        return straight + detour(scene)
    ends = [_nearest(free, x, y, pin) for pin in pins]
    length = _dijkstra(free, grid.cell, ends[0][0], ends[1][0])
    found = ends[0][1] + length + ends[1][1]
    return max(found, straight) if math.isfinite(found) else straight + detour(scene)


def _plans(scene: Scene, layout: np.ndarray) -> list:
    """What stands in the way, in plan."""
    import shapely

    plans = []
    for obj, (px, py, pz, yaw) in zip(scene.objects, layout, strict=False):
        c, s = math.cos(yaw), math.sin(yaw)
        for part in obj.solids:
            if pz + part.z[0] < HIGH and pz + part.z[1] > LOW:
                points = np.asarray(part.polygon) @ np.array([[c, s], [-s, c]]) + (px, py)
                plans.append(shapely.Polygon(points))
    return plans


def _nearest(free: np.ndarray, x: np.ndarray, y: np.ndarray, pin: np.ndarray) -> tuple[tuple[int, int], float]:
    off = np.where(free, np.hypot(x[None, :] - pin[0], y[:, None] - pin[1]), np.inf)
    row, column = divmod(int(off.argmin()), len(x))
    return (row, column), float(off[row, column])


def _dijkstra(free: np.ndarray, cell: float, start: tuple[int, int], goal: tuple[int, int]) -> float:
    ny, nx = free.shape
    best, queue = {start: 0.0}, [(0.0, start)]
    while queue:
        length, (row, column) = heapq.heappop(queue)
        if (row, column) == goal:
            return length
        if length > best[row, column]:
            continue
        for down in (-1, 0, 1):
            for right in (-1, 0, 1):
                r, k = row + down, column + right
                if not (0 <= r < ny and 0 <= k < nx) or not (free[r, k] and free[row, k] and free[r, column]):
                    continue
                other = length + cell * math.hypot(down, right)
                if other < best.get((r, k), math.inf):
                    best[r, k] = other
                    heapq.heappush(queue, (other, (r, k)))
    return math.inf
