"""Where a round robot can stand and drive, from the collision parts of a room as they are now."""

from __future__ import annotations

from typing import Any

import numpy as np

from .predicates import to_world
from .world import World

Array = np.ndarray

CELL = 0.05
"""Side of a cell [m]."""

_OVER = 0.02  # [m]; rugs and mats are driven over
_ARM = 1.0  # [m]; above, only the folded arm is in the way, which is wider than the base
_ARM_RADIUS = 0.33  # [m] of the folded arm about the axis of the base
_TOP = 1.7  # [m]; above, there is nothing of the robot
_CLEAR = 0.02  # [m] kept to everything
_COMFORT = 0.25  # [m]; nearer to obstacles than this, a metre costs up to four


class FloorMap:
    """Free places for the middle of the base on a grid of `CELL`, with shortest ways between them.

    Args:
        world: The room with the robot.
        data: Its simulation: things are where they are in it.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import FloorMap, World, mobile_manipulator, poses_of
        >>> world = World(sw.Scene.example("bedroom"), mobile_manipulator())
        >>> data = world.new_data()
        >>> world.place(data, poses_of(world.scene), (0.0, 0.0, 0.0))
        >>> bool(FloorMap(world, data).free.any())
        True
    """

    def __init__(self, world: World, data: Any) -> None:
        """Lay the grid over the room."""
        import shapely
        from scipy.ndimage import distance_transform_edt

        outline = np.asarray(world.scene.room.outline, dtype=float)
        self.low = outline.min(axis=0)
        count = np.ceil((outline.max(axis=0) - self.low) / CELL).astype(int)
        x, y = (self.low[k] + (np.arange(count[k]) + 0.5) * CELL for k in (0, 1))
        self.points = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)
        flat = shapely.points(self.points)
        radius = world.robot.radius + _CLEAR
        room = shapely.Polygon(outline)
        low, high = _plans(world, data, _OVER, _ARM), _plans(world, data, _ARM, _TOP)
        self.free = shapely.contains(room.buffer(-max(radius, _ARM_RADIUS)), flat)
        for plans, wide in ((low, radius), (high, _ARM_RADIUS)):
            if plans:
                blocked = shapely.unary_union(plans).buffer(wide)
                shapely.prepare(blocked)
                self.free &= ~shapely.contains(blocked, flat)
        self._room = np.asarray(distance_transform_edt(np.pad(self.free, 1)))[1:-1, 1:-1] * CELL

    def cell(self, point: Array) -> tuple[int, int]:
        """The free cell nearest to a point [2].

        Raises:
            LookupError: there is none.
        """
        if not self.free.any():
            raise LookupError("no free floor")
        gap = np.linalg.norm(self.points - np.asarray(point)[:2], axis=-1)
        gap[~self.free] = np.inf
        row, column = np.unravel_index(np.argmin(gap), gap.shape)
        return int(row), int(column)

    def reached(self, start: Array) -> Array:
        """Which cells bool can be driven to from near a point."""
        from scipy.ndimage import label

        regions, _ = label(self.free)
        return regions == regions[self.cell(start)]

    def path(self, start: Array, goal: Array) -> Array:
        """A way [K, 2] from a point to another, over the middles of free cells; the ends are the points themselves.

        Raises:
            LookupError: there is none.
        """
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import dijkstra

        numbers = np.full(self.free.shape, -1)
        numbers[self.free] = np.arange(self.free.sum())
        price = 1 + 3 * np.clip(1 - self._room / _COMFORT, 0, 1)
        rows, columns, costs = [], [], []
        for dx, dy in ((1, 0), (0, 1), (1, 1), (1, -1)):
            one, other = _shifted(numbers, dx, dy)
            both = (one >= 0) & (other >= 0)
            first, second = _shifted(price, dx, dy)
            rows.append(one[both])
            columns.append(other[both])
            costs.append((np.hypot(dx, dy) * CELL * (first + second) / 2)[both])
        size = int(self.free.sum())
        index = (np.concatenate(rows), np.concatenate(columns))
        graph = csr_array((np.concatenate(costs), index), shape=(size, size))
        end, begin = numbers[self.cell(goal)], numbers[self.cell(start)]
        _, before = dijkstra(graph, directed=False, indices=begin, return_predecessors=True)
        way = [int(end)]
        while way[-1] != begin:
            if before[way[-1]] < 0:
                raise LookupError("no way over free floor")
            way.append(int(before[way[-1]]))
        places = self.points[self.free][way[::-1]]
        return np.vstack([np.asarray(start)[:2], places[1:-1], np.asarray(goal)[:2]])


def _shifted(grid: Array, dx: int, dy: int) -> tuple[Array, Array]:
    """A grid and its neighbour in a direction, where both are there."""
    wide, high = grid.shape
    here = grid[: wide - dx, max(-dy, 0) : high - max(dy, 0)]
    return here, grid[dx:, max(dy, 0) : high + min(dy, 0)]


def _plans(world: World, data: Any, low: float, high: float) -> list[Any]:
    """Plans of all collision parts between two heights, with the leaves of the room's doors left out."""
    import shapely

    found: list[Array] = []
    for thing in world.geometry.things:
        for body in thing.bodies:
            pose = world.pose(data, body.name)
            for solid in body.solids:
                points = to_world(pose, np.asarray(solid.points))
                if points[:, 2].min() < high and points[:, 2].max() > low:
                    found.append(points[:, :2])
    if not found:
        return []
    owner = np.repeat(np.arange(len(found)), [len(points) for points in found])
    points: Any = shapely.points(np.concatenate(found))
    clouds: Any = shapely.multipoints(points, indices=owner)
    return list(shapely.convex_hull(clouds))
