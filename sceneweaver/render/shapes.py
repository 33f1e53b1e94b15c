"""Outlines of objects as polygons in the plane [m], their order from below, and the way from metres to pixels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.geometry.rotations import is_upright, matrix
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.render.canvas import Canvas, Point
from sceneweaver.render.palette import PAPER
from sceneweaver.scene import Pose, Room, Scene, SceneObject, Vec2


@dataclass(frozen=True)
class Prism:
    """One part of an object as seen from above: its outline and the heights that it spans."""

    polygon: tuple[Vec2, ...]
    bottom: float
    top: float


def to_world(pose: Pose, points: Iterable[Vec2], z: float = 0.0) -> tuple[Vec2, ...]:
    """Points of an object's frame, at its height ``z``, seen from above."""
    if is_upright(pose.quaternion):
        return tuple(pose.frame.world(x, y) for x, y in points)
    (px, py, _), ((a, b, c), (d, e, f), _) = pose.position, matrix(pose.quaternion).tolist()
    return tuple((px + a * x + b * y + c * z, py + d * x + e * y + f * z) for x, y in points)


def prism(pose: Pose, polygon: Sequence[Vec2], low: float, high: float) -> Prism:
    """A prism of an object's frame seen from above; a tilted one shows the hull of its two faces."""
    z = pose.position[2]
    if is_upright(pose.quaternion, 1e-4):
        return Prism(to_world(pose, polygon), z + low, z + high)
    corners = prism_vertices(polygon, (low, high)) @ matrix(pose.quaternion).T + pose.position
    hull = tuple((float(x), float(y)) for x, y in convex_hull(corners[:, :2]))
    return Prism(hull, float(corners[:, 2].min()), float(corners[:, 2].max()))


def prisms(obj: SceneObject) -> list[Prism]:
    """The parts of an object seen from above."""
    return [prism(obj.pose, part.polygon, *part.z) for part in obj.solids]


def layers(scene: Scene) -> dict[str, int]:
    """Drawing layer by object id: 0 on the floor, 1 and more on supporters, from 100 what hangs, from 200 its load."""
    by_id = {o.id: o for o in scene.objects}
    out: dict[str, int] = {}
    for obj in scene.objects:
        depth, at, seen = 0, obj, {obj.id}
        while at.mount == "surface" and at.support is not None:
            below = by_id.get(at.support.object)
            if below is None or below.id in seen:
                break
            depth, at = depth + 1, below
            seen.add(below.id)
        if at.mount in ("wall", "ceiling"):
            depth += 200 if depth else 100
        elif at.mount == "surface":
            depth += 1
        out[obj.id] = depth
    return out


def inside(polygon: Sequence[Vec2], x: float, y: float) -> bool:
    """Whether a point lies in a simple polygon."""
    result = False
    for (x0, y0), (x1, y1) in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) / (y1 - y0) * (x1 - x0):
            result = not result
    return result


def cut(a: Vec2, b: Vec2, convex: Sequence[Vec2]) -> tuple[float, float] | None:
    """The share [t0, t1] of the segment from a to b that lies in a convex counter-clockwise polygon."""
    t0, t1 = 0.0, 1.0
    dx, dy = b[0] - a[0], b[1] - a[1]
    for (x0, y0), (x1, y1) in zip(convex, [*convex[1:], convex[0]], strict=True):
        nx, ny = y0 - y1, x1 - x0  # inward normal
        start, rate = nx * (a[0] - x0) + ny * (a[1] - y0), nx * dx + ny * dy
        if abs(rate) < 1e-12:
            if start < 0:
                return None
        elif rate > 0:
            t0 = max(t0, -start / rate)
        else:
            t1 = min(t1, -start / rate)
    return (t0, t1) if t1 - t0 > 1e-9 else None


@dataclass(frozen=True)
class View:
    """A similarity from the plane in metres (y up) to pixels (y down)."""

    scale: float  # pixels a metre
    left: float  # x [m] of the picture's left edge
    top: float  # y [m] of the picture's upper edge

    def point(self, p: Vec2) -> Point:
        """The pixel of a point in metres."""
        return ((p[0] - self.left) * self.scale, (self.top - p[1]) * self.scale)

    def points(self, polygon: Iterable[Vec2]) -> list[Point]:
        """The pixels of several points."""
        return [self.point(p) for p in polygon]


class Plan(Canvas):
    """A canvas on which things are drawn that are given in metres."""

    def __init__(self, width: int, height: int, view: View, unit: float) -> None:
        super().__init__(width, height, PAPER, unit)
        self.scale, self.point, self.points = view.scale, view.point, view.points


@dataclass(frozen=True)
class Bounds:
    """An axis-aligned rectangle in metres."""

    x0: float
    y0: float
    x1: float
    y1: float

    @property
    def width(self) -> float:
        """Extent along x."""
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        """Extent along y."""
        return self.y1 - self.y0


def bounds_of(points: Sequence[Vec2]) -> Bounds:
    """The rectangle around some points."""
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return Bounds(min(xs), min(ys), max(xs), max(ys))


def content(room: Room, solids: Iterable[Prism]) -> Bounds:
    """What a picture shows: the room with its walls, and objects outside of it as long as they are near."""
    inner = bounds_of(room.outline)
    slack = max(1.5, 0.25 * max(inner.width, inner.height))
    x0, y0, x1, y1 = inner.x0, inner.y0, inner.x1, inner.y1
    for p in solids:
        b = bounds_of(p.polygon)
        x0, x1 = min(x0, max(b.x0, inner.x0 - slack)), max(x1, min(b.x1, inner.x1 + slack))
        y0, y1 = min(y0, max(b.y0, inner.y0 - slack)), max(y1, min(b.y1, inner.y1 + slack))
    for door in room.doors:
        if door.swing == "out":
            # An outward leaf needs room in the picture too.
            for px, py in room.walls[door.wall].strip(door.offset, door.width, 0.0, -door.width)[2:]:
                x0, x1, y0, y1 = min(x0, px), max(x1, px), min(y0, py), max(y1, py)
    t = WALL_THICKNESS
    return Bounds(x0 - t, y0 - t, x1 + t, y1 + t)


def step_for(scale: float, pixels: float) -> int:
    """The least of 1, 2, 5, 10, 20 ... metres that is at least ``pixels`` wide."""
    step = 1
    while step * scale < pixels:
        digit = str(step)[0]
        step = step * 5 // 2 if digit == "2" else step * 2
    return step
