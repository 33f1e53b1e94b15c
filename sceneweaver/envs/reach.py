"""What a robot gets at in a room: where its base can stand, what it drives up to, surfaces and points in reach."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.assets.placed import Load
from sceneweaver.scene import Scene

from .geometry import Item, SceneGeometry, SupportSurface
from .layouts import poses_of
from .navigation import FloorMap, Plans, entrance
from .predicates import distance_to_box, to_world
from .robots import Robot, robot_named
from .tasks import NavigateTo

Array = np.ndarray
Poses = Mapping[str, Array]

FLAT = 0.1
"""[m]; lower things, as rugs, are driven over, and nobody drives up to them."""

GRID = 0.05
"""Between the points of a surface that are looked at [m]."""

ELBOW_ROOM = 0.06
"""Around a thing that is put down, for the fingers [m]."""

_HAND = 0.3  # [m] over a thing that is put down, for the hand
_MARGIN = 0.01  # [m] between a thing and the edge of what it stands on
_LIFT = 0.005  # [m]; what rises less over a surface is part of it


class Reach:
    """Where a robot gets in a room whose things stand somewhere.

    Its base drives over the floor that it can get to from inside the first door, with its own radius kept to
    everything; from there the tool reaches as far as `Robot.reach` and `Robot.heights` say. A robot that does not
    drive is put in front of what it is asked for: of it only the heights count.

    Args:
        geometry: Of the scene.
        robot: Who it is.
        poses: Poses [7] of all bodies, closed.
    """

    def __init__(self, geometry: SceneGeometry, robot: Robot, poses: Poses) -> None:
        """Lay the map of the floor."""
        self._geometry, self._robot, self._poses = geometry, robot, poses
        self._plans = Plans.of(geometry, poses)

    @cached_property
    def cells(self) -> Array:
        """Places [C, 2] for the middle of the base that it can drive to."""
        scene = self._geometry.scene
        floor = FloorMap.of(scene, self._robot, self._plans)
        if not floor.free.any():
            return np.empty((0, 2))
        return floor.points[floor.reached(entrance(scene, floor))]

    def points(self, points: Array) -> Array:
        """Which points [..., 3] of the room the tool gets to: bool [...]."""
        points = np.asarray(points, dtype=float)
        low, high = self._robot.heights
        level = (low <= points[..., 2]) & (points[..., 2] <= high)
        if not self._robot.base:
            return level
        if not len(self.cells):
            return np.zeros(points.shape[:-1], dtype=bool)
        near, _ = self._tree.query(points[..., :2], distance_upper_bound=self._robot.reach)
        return level & np.isfinite(near)

    def beside(self, name: str) -> bool:
        """Whether the base gets as near to an object as `NavigateTo` asks."""
        item = self._geometry.items[name]
        way = distance_to_box(self.cells, self._poses[name], item.low, item.high)
        return bool((way <= NavigateTo(name).reach).any())

    def surface(self, top: SupportSurface) -> float:
        """The share of a surface that the tool gets to, 0..1."""
        spots = _grid(top)
        return float(self.points(to_world(self._poses[top.body], spots)).mean()) if len(spots) else 0.0

    def spot(self, top: SupportSurface, item: Item) -> tuple[float, float] | None:
        """A free place for a thing on a surface, in its plan [m], within reach, the one nearest to its middle; None:
        there is none."""
        radius, headroom = float(max(item.size[:2])) / 2, float(item.size[2]) + _HAND
        if (top.high - top.low < 2 * (radius + _MARGIN)).any():
            return None
        edge, clear, reached = self._surface_free(top, headroom)
        spots = _grid(top)
        good = (edge >= radius + _MARGIN) & (clear >= radius + ELBOW_ROOM) & reached
        if not good.any():
            return None
        aside = np.linalg.norm(spots[:, :2] - (top.low + top.high) / 2, axis=1)
        x, y = np.round(spots[int(np.argmin(np.where(good, aside, np.inf))), :2], 4).tolist()
        return x, y

    @cached_property
    def _tree(self) -> Any:
        from scipy.spatial import KDTree

        return KDTree(self.cells)

    def _surface_free(self, top: SupportSurface, headroom: float) -> tuple[Array, Array, Array]:
        """Of the points of a surface: how far they are from its edge and from what stands over it up to a height, and
        whether the tool gets there."""
        import shapely

        kept = self.__dict__.setdefault("_free_of", {})
        key = (top.body, top.name, round(headroom, 1))
        if key not in kept:
            spots = to_world(self._poses[top.body], _grid(top))
            flat = shapely.points(spots[:, :2])
            plan = to_world(self._poses[top.body], np.column_stack([top.outline, np.full(len(top.outline), top.z)]))
            edge = shapely.distance(shapely.LinearRing(plan[:, :2]), flat)
            height = float(plan[0, 2])
            above: Any = self._plans.between(height + _LIFT, height + headroom)
            clear = np.full(len(spots), np.inf)
            if len(above):
                (mine, _), gaps = shapely.STRtree(above).query_nearest(flat, all_matches=False, return_distance=True)
                clear[mine] = gaps
            kept[key] = edge, clear, self.points(spots + [0.0, 0.0, 0.05])
        return kept[key]


def _grid(top: SupportSurface) -> Array:
    """Points [K, 3] of a surface in its body's frame, its middle among them."""
    import shapely

    middle, half = (top.low + top.high) / 2, (top.high - top.low) / 2
    axes = [middle[k] + GRID * np.arange(-(count := int(half[k] / GRID)), count + 1) for k in (0, 1)]
    plan = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2)
    inside = shapely.contains(shapely.Polygon(top.outline), shapely.points(plan))
    return np.column_stack([plan[inside], np.full(int(inside.sum()), top.z)])


@dataclass(frozen=True)
class ReachReport:
    """What a robot gets at in a room, shares 0..1.

    Attributes:
        share: Of the objects that stand on the floor and are no rugs, those that the base gets as near to as
            `NavigateTo` asks; 1 when there are none.
        unreached: Ids of the others.
        surfaces: By object and name of a surface, the share of its area that the tool gets to.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import envs
        >>> report = envs.reach_of(sw.Scene.example("bedroom"))
        >>> report.share, report.unreached
        (0.9, ('nightstand-left',))
    """

    share: float
    unreached: tuple[str, ...]
    surfaces: Mapping[tuple[str, str], float]


def reach_of(scene: Scene, robot: str | Robot = "mobile", load: Load | None = None) -> ReachReport:
    """What a robot gets at in a room as the scene has it, by the robot's own radius, reach and heights.

    Args:
        scene: The room.
        robot: "mobile" or a `Robot`, as with another ``radius``; see `Robot`.
        load: From asset id to asset; None: the library of this user.

    Raises:
        InputError: an asset cannot be loaded.

    Examples:
        >>> from dataclasses import replace
        >>> import sceneweaver as sw
        >>> from sceneweaver import envs
        >>> scene = sw.Scene.example("bedroom")
        >>> wide = replace(envs.mobile_manipulator(), radius=0.6)
        >>> envs.reach_of(scene).share > envs.reach_of(scene, wide).share
        True
    """
    geometry = SceneGeometry(scene, load)
    place = dict(zip(scene.ids, poses_of(scene), strict=True))
    found = Reach(geometry, robot_named(robot), {name: place[owner] for name, owner in geometry.owner.items()})
    standing = [thing.object.id for thing in geometry.things if stands(thing.object.mount, thing.object.size[2])]
    missed = tuple(name for name in standing if not found.beside(name))
    share = 1.0 - len(missed) / len(standing) if standing else 1.0
    return ReachReport(share, missed, {(top.body, top.name): found.surface(top) for top in geometry.surfaces})


def stands(mount: str, height: float) -> bool:
    """Whether something is an object that one drives up to."""
    return mount == "floor" and height > FLAT
