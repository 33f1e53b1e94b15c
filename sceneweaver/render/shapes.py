"""Outlines of objects as polygons in the plane, in metres, and their order from below."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.prisms import prism_vertices
from sceneweaver.geometry.rotations import is_upright, matrix
from sceneweaver.scene import Pose, Scene, SceneObject, Vec2


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
