"""The placed scene in plain arrays: bodies, their convex prisms, and the walls and openings of the room.

Units are metres, radians and cubic metres; everything is float64 and in world coordinates. An upright object (tilted by
at most 0.5 degrees) keeps its polygons and is only turned by its yaw. A tilted object is described by its rotated
vertices: its prisms are the convex hulls of their projections to the floor over the z interval that they span, which
contains the true solid; `convex` has the exact one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.polygons import rectangle, signed_area
from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.geometry.rotations import matrix, tilt_of
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.shell import clear_zone, heights
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Door, Scene, SceneObject, Window

Array = NDArray[np.float64]
Point = tuple[float, float]

DEPTH = 1e-3
"""Depth in metres up to which two solids count as touching."""

TILT = math.radians(0.5)
"""Tilt in radians from which the true rotated geometry of an object is used."""

RECENT = 2
"""Scenes whose placement is kept: the judge and the critic look at one after the other."""


class Face(NamedTuple):
    """A vertical side of a box: its centre, outward unit normal and half width in the plane [m]."""

    centre: Point
    normal: Point
    half: float


class Opening(NamedTuple):
    """A door or window with the rectangle before it that must stay clear, from ``z[0]`` to ``z[1]`` [m]."""

    item: Door | Window
    wall: Wall
    polygon: tuple[Point, ...]
    z: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Body:
    """One object where it stands. ``z`` is the height interval that its solids fill."""

    index: int
    item: SceneObject
    id: str
    position: tuple[float, float, float]
    size: tuple[float, float, float]
    yaw: float
    rotation: Array
    tilted: bool
    z: tuple[float, float]
    corners: tuple[Point, ...]
    frame: SE2

    @cached_property
    def volume(self) -> float:
        """Summed volume of its solids [m3]."""
        return sum(abs(signed_area(p.polygon)) * (p.z[1] - p.z[0]) for p in self.item.solids)

    @property
    def bottom(self) -> float:
        """Height of the bottom [m]: the origin's, or that of the lowest vertex of a tilted body."""
        return self.z[0] if self.tilted else self.position[2]

    @property
    def centre(self) -> Point:
        """The object's origin in the plane [m]."""
        return self.position[0], self.position[1]

    @property
    def front(self) -> Point:
        """Unit vector of the object's front in the plane."""
        return self.frame.axis

    def local(self, point: Point) -> Point:
        """Return ``point`` in the object's frame: (metres ahead of, metres left of) its origin."""
        return self.frame.local(*point)

    def face(self, side: str) -> Face:
        """Return the box face ``front``, ``back``, ``left`` or ``right``."""
        (x, y, _), (fx, fy) = self.position, self.front
        d, w = self.size[0] / 2, self.size[1] / 2
        if side == "front":
            return Face((x + fx * d, y + fy * d), (fx, fy), w)
        if side == "back":
            return Face((x - fx * d, y - fy * d), (-fx, -fy), w)
        if side == "left":
            return Face((x - fy * w, y + fx * w), (-fy, fx), d)
        return Face((x + fy * w, y - fx * w), (fy, -fx), d)

    def to_world(self, points: Array) -> Array:
        """Return ``points`` [n, 3] of the object's frame in the world [m]."""
        return points @ self.rotation.T + np.asarray(self.position)


@dataclass(frozen=True, eq=False)
class Prisms:
    """Polygons ``xy`` [n, v, 2] (short ones repeat their last vertex) times intervals ``z`` [n, 2]; ``owner`` [n]."""

    xy: Array
    z: Array
    owner: NDArray[np.intp]
    names: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.xy)

    @cached_property
    def polygons(self) -> NDArray[Any]:
        """The polygons as shapely geometries [n]."""
        import shapely

        made: Any = shapely.polygons(self.xy) if len(self) else np.empty(0, dtype=object)
        return made

    @cached_property
    def boxes(self) -> Array:
        """Bounding boxes [n, 4]: x0, y0, x1, y1 [m]."""
        return np.concatenate([self.xy.min(axis=1), self.xy.max(axis=1)], axis=1)

    @cached_property
    def normals(self) -> tuple[Array, NDArray[np.bool_]]:
        """Unit normals of the edges [n, v, 2], of either orientation, and which edges have a length [n, v]."""
        edge = np.roll(self.xy, -1, axis=1) - self.xy
        length = np.hypot(edge[..., 0], edge[..., 1])
        real = length >= 1e-9
        length[~real] = 1.0
        return np.stack([edge[..., 1], -edge[..., 0]], axis=-1) / length[..., None], real

    @cached_property
    def spans(self) -> tuple[Array, Array]:
        """Extent of every polygon along each of its own normals: lowest and highest [n, v] [m]."""
        projected = np.einsum("nvd,nad->nav", self.xy, self.normals[0])
        return projected.min(axis=2), projected.max(axis=2)

    def pick(self, rows: Any) -> Prisms:
        """Return the prisms of ``rows`` (indices or a mask) only."""
        return Prisms(self.xy[rows], self.z[rows], self.owner[rows])


class _Raw(NamedTuple):
    body: Body
    polygon: Sequence[Point]
    z: tuple[float, float]


def _place(raw: Sequence[_Raw], names: tuple[str, ...] = ()) -> Prisms:
    """Turn prisms given in their bodies' frames into world prisms."""
    if not raw:
        return Prisms(np.empty((0, 4, 2)), np.empty((0, 2)), np.empty(0, dtype=np.intp), names)
    polygons, poses, heights = [], [], []
    for body, polygon, (z0, z1) in raw:
        if body.tilted:
            points = body.to_world(prism_vertices(polygon, (z0, z1)))
            polygons.append(_outline(points))
            poses.append((1.0, 0.0, 0.0, 0.0))
            heights.append((points[:, 2].min(), points[:, 2].max()))
        else:
            x, y, z = body.position
            polygons.append(polygon)
            poses.append((*body.front, x, y))
            heights.append((z + z0, z + z1))
    most = max(map(len, polygons))
    local = np.array([(*p, *(p[-1],) * (most - len(p))) for p in polygons], dtype=float)
    c, s, x, y = np.array(poses).T[:, :, None]
    xy = np.stack([c * local[..., 0] - s * local[..., 1] + x, s * local[..., 0] + c * local[..., 1] + y], axis=-1)
    return Prisms(xy, np.array(heights, dtype=float), np.array([r.body.index for r in raw], dtype=np.intp), names)


def _outline(points: Array) -> tuple[Point, ...]:
    """Corners of the convex hull of ``points`` [n, 3] as seen from above."""
    return tuple(map(tuple, convex_hull(points[:, :2]).tolist()))


def _body(index: int, item: SceneObject) -> Body:
    quaternion = item.pose.quaternion
    tilted, frame = tilt_of(quaternion) > TILT, item.pose.frame
    rotation = matrix(quaternion) if tilted else _upright(frame)
    position, size, solids = item.pose.position, item.size, item.solids
    if tilted:
        world = np.asarray(position)
        heights = np.concatenate([prism_vertices(p.polygon, p.z) @ rotation[2] + world[2] for p in solids])
        z = (float(heights.min()), float(heights.max()))
        corners = _outline(prism_vertices(rectangle(size[0], size[1]), (0.0, size[2])) @ rotation.T + world)
    else:
        z = (position[2] + min(p.z[0] for p in solids), position[2] + max(p.z[1] for p in solids))
        corners = tuple(frame.world(u, v) for u, v in rectangle(size[0], size[1]))
    return Body(index, item, item.id, position, size, frame.yaw, rotation, tilted, z, corners, frame)


def _upright(frame: SE2) -> Array:
    """The rotation about z only: the little by which an upright object tilts is none."""
    c, s = frame.axis
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


@dataclass(frozen=True, eq=False)
class Placed:
    """A scene made ready for judging; what is costly is worked out on first use and kept."""

    scene: Scene
    bodies: tuple[Body, ...]
    walls: tuple[Wall, ...]
    doors: tuple[Opening, ...]
    windows: tuple[Opening, ...]

    _recent: ClassVar[tuple[Placed, ...]] = ()

    @classmethod
    def of(cls, scene: Scene) -> Placed:
        """Place every object of ``scene``; what was made of the same scene a moment ago is taken again."""
        for one in cls._recent:
            if one.scene is scene:
                return one
        made = cls._made(scene)
        cls._recent = (made, *cls._recent[: RECENT - 1])
        return made

    @classmethod
    def _made(cls, scene: Scene) -> Placed:
        walls = scene.room.walls

        def opening(item: Door | Window) -> Opening:
            return Opening(item, walls[item.wall], clear_zone(item, walls), heights(item))

        return cls(
            scene=scene,
            bodies=tuple(_body(i, item) for i, item in enumerate(scene.objects)),
            walls=walls,
            doors=tuple(opening(d) for d in scene.room.doors),
            windows=tuple(opening(w) for w in scene.room.windows),
        )

    @cached_property
    def by_id(self) -> dict[str, Body]:
        """The bodies by object id."""
        return {body.id: body for body in self.bodies}

    @cached_property
    def parts(self) -> Prisms:
        """Every solid part, grouped by object in scene order."""
        return _place([_Raw(b, p.polygon, p.z) for b in self.bodies for p in b.item.solids])

    @cached_property
    def first_part(self) -> NDArray[np.intp]:
        """Index of the first part of each object, and the number of parts at the end [objects + 1]."""
        return np.searchsorted(self.parts.owner, np.arange(len(self.bodies) + 1))

    @cached_property
    def zones(self) -> Prisms:
        """Every hard zone of every object; ``names`` are the zones' own."""
        raw = [(_Raw(b, z.polygon, z.z), z.name) for b in self.bodies for z in b.item.zones if z.hard]
        return _place([r for r, _ in raw], tuple(name for _, name in raw))

    @cached_property
    def openings(self) -> tuple[Opening, ...]:
        """Doors, then windows."""
        return self.doors + self.windows

    @cached_property
    def opening_zones(self) -> Prisms:
        """The clear spaces of `openings`, in that order; ``owner`` is the index of the opening."""
        n = len(self.openings)
        xy = np.array([o.polygon for o in self.openings], dtype=float).reshape(n, 4, 2)
        z = np.array([o.z for o in self.openings], dtype=float).reshape(n, 2)
        return Prisms(xy, z, np.arange(n), tuple(o.item.id for o in self.openings))

    @cached_property
    def floor(self) -> Any:
        """The room's outline as a shapely polygon."""
        import shapely

        return shapely.polygons(np.asarray(self.scene.room.outline, dtype=float))

    def part_rows(self, body: Body) -> slice:
        """Rows of ``body`` in `parts`."""
        return slice(int(self.first_part[body.index]), int(self.first_part[body.index + 1]))

    def footprint(self, body: Body) -> NDArray[Any]:
        """Polygons of the parts of ``body``; its footprint is their union."""
        return self.parts.polygons[self.part_rows(body)]

    def distance(self, a: Body, b: Body) -> float:
        """Distance between two footprints [m]; 0 where they overlap."""
        import shapely

        return float(shapely.distance(self.footprint(a)[:, None], self.footprint(b)[None, :]).min())
