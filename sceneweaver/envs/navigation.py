"""Where a round robot can stand and drive, from the collision parts of a room as they are now."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.scene import Scene

from .geometry import SceneGeometry
from .predicates import to_world
from .robots import Robot
from .world import World

Array = np.ndarray
Poses = Mapping[str, Array]

CELL = 0.05
"""Side of a cell [m]."""

_OVER = 0.02  # [m]; rugs and mats are driven over
_ARM = 1.0  # [m]; above, only the folded arm is in the way, which is wider than the base
_ARM_RADIUS = 0.33  # [m] of the folded arm about the axis of the base
_TOP = 1.7  # [m]; above, there is nothing of the robot
_CLEAR = 0.02  # [m] kept to everything
_INSIDE = 0.6  # [m] from a door's wall to where a robot comes in
_COMFORT = 0.25  # [m]; nearer to obstacles than this, a metre costs up to four


@dataclass(frozen=True)
class Plans:
    """All collision parts of a room's things from above: convex ``hulls`` [K] of shapely, each with the heights ``low``
    and ``high`` [K] between which it is; the leaves of the room's doors are left out."""

    hulls: Array
    low: Array
    high: Array

    @classmethod
    def of(cls, geometry: SceneGeometry, poses: Poses) -> Plans:
        """Those of a scene whose bodies stand at some poses [7]."""
        import shapely

        solids = [
            to_world(poses[body.name], np.asarray(solid.points))
            for thing in geometry.things
            for body in thing.bodies
            for solid in body.solids
        ]
        if not solids:
            return cls(np.empty(0, dtype=object), np.empty(0), np.empty(0))
        owner = np.repeat(np.arange(len(solids)), [len(points) for points in solids])
        points: Any = shapely.points(np.concatenate(solids)[:, :2])
        clouds: Any = shapely.multipoints(points, indices=owner)
        heights = [np.array([end(s[:, 2]) for s in solids]) for end in (np.min, np.max)]
        return cls(np.asarray(shapely.convex_hull(clouds)), *heights)

    def between(self, low: float, high: float) -> Array:
        """The hulls of what is between two heights [m]."""
        return self.hulls[(self.low < high) & (self.high > low)]


class FloorMap:
    """Free places for the middle of the base on a grid of `CELL`, with shortest ways between them.

    Args:
        world: The room with the robot.
        data: Its simulation: things are where they are in it.

    Attributes:
        points: Middles [X, Y, 2] of the cells.
        free: Which cells [X, Y] the middle of the base may be in.

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
        """Lay the grid over the room as it is in a simulation."""
        geometry = world.geometry
        poses = {body.name: world.pose(data, body.name) for thing in geometry.things for body in thing.bodies}
        self._lay(world.scene, world.robot, Plans.of(geometry, poses))

    @classmethod
    def of(cls, scene: Scene, robot: Robot, plans: Plans) -> FloorMap:
        """The map of a room whose things are somewhere, without a simulation."""
        made = cls.__new__(cls)
        made._lay(scene, robot, plans)
        return made

    def _lay(self, scene: Scene, robot: Robot, plans: Plans) -> None:
        import shapely
        from scipy.ndimage import distance_transform_edt

        outline = np.asarray(scene.room.outline, dtype=float)
        self.low = outline.min(axis=0)
        count = np.ceil((outline.max(axis=0) - self.low) / CELL).astype(int)
        x, y = (self.low[k] + (np.arange(count[k]) + 0.5) * CELL for k in (0, 1))
        self.points = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)
        flat = shapely.points(self.points)
        radius = robot.radius + _CLEAR
        room = shapely.Polygon(outline)
        self.free = shapely.contains(room.buffer(-max(radius, _ARM_RADIUS)), flat)
        for (low, high), wide in (((_OVER, _ARM), radius), ((_ARM, _TOP), _ARM_RADIUS)):
            found: Any = plans.between(low, high)
            if len(found):
                blocked = shapely.unary_union(found).buffer(wide)
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


def entrance(scene: Scene, floor: FloorMap) -> Array:
    """The point [2] where a robot comes into a room: inside its first door, in a room without one its middle."""
    door = next(iter(scene.room.doors), None)
    if door is None:
        return floor.points.mean(axis=(0, 1))
    return np.asarray(scene.room.walls[door.wall].point(door.offset + door.width / 2, _INSIDE))
