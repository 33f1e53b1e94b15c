"""Outlines of objects, zones, walls and openings as polygons in the plane, in metres."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sceneweaver.scene import Door, Pose, Room, Scene, SceneObject, Vec2, Vec3, Window

WALL_THICKNESS = 0.12


@dataclass(frozen=True)
class Prism:
    """One part of an object as seen from above: its outline and the heights that it spans."""

    polygon: tuple[Vec2, ...]
    bottom: float
    top: float


@dataclass(frozen=True)
class Wall:
    """A wall's inner edge from ``start`` along the unit vector ``along``; ``inward`` points into the room."""

    index: int
    start: Vec2
    along: Vec2
    inward: Vec2
    length: float

    def point(self, offset: float, depth: float) -> Vec2:
        """The point ``offset`` metres along the wall and ``depth`` metres into the room."""
        (x, y), (tx, ty), (nx, ny) = self.start, self.along, self.inward
        return (x + tx * offset + nx * depth, y + ty * offset + ny * depth)

    def strip(self, offset: float, width: float, near: float, far: float) -> tuple[Vec2, ...]:
        """The rectangle along the wall between two depths."""
        end = offset + width
        return (self.point(offset, near), self.point(end, near), self.point(end, far), self.point(offset, far))


def rotate(quaternion: Sequence[float], v: Vec3) -> Vec3:
    """A vector turned by an xyzw quaternion of any length above zero."""
    x, y, z, w = quaternion
    n = x * x + y * y + z * z + w * w
    if n < 1e-18:
        return v
    s = 2.0 / n
    a, b, c = v
    return (
        a * (1 - s * (y * y + z * z)) + b * s * (x * y - z * w) + c * s * (x * z + y * w),
        a * s * (x * y + z * w) + b * (1 - s * (x * x + z * z)) + c * s * (y * z - x * w),
        a * s * (x * z - y * w) + b * s * (y * z + x * w) + c * (1 - s * (x * x + y * y)),
    )


def to_world(pose: Pose, points: Iterable[Vec2], z: float = 0.0) -> tuple[Vec2, ...]:
    """Points of an object's frame, at its height ``z``, seen from above."""
    px, py, _ = pose.position
    out = []
    for x, y in points:
        v = rotate(pose.quaternion, (x, y, z))
        out.append((px + v[0], py + v[1]))
    return tuple(out)


def prism(pose: Pose, polygon: Sequence[Vec2], low: float, high: float) -> Prism:
    """A prism of an object's frame seen from above; a tilted one shows the hull of its two faces."""
    x, y = pose.quaternion[0], pose.quaternion[1]
    z0 = pose.position[2]
    if abs(x) < 1e-4 and abs(y) < 1e-4:
        return Prism(to_world(pose, polygon), z0 + low, z0 + high)
    corners = [rotate(pose.quaternion, (px, py, pz)) for px, py in polygon for pz in (low, high)]
    hull = _hull([(pose.position[0] + c[0], pose.position[1] + c[1]) for c in corners])
    heights = [c[2] for c in corners]
    return Prism(hull, z0 + min(heights), z0 + max(heights))


def prisms(obj: SceneObject) -> list[Prism]:
    """The parts of an object seen from above."""
    return [prism(obj.pose, part.polygon, *part.z) for part in obj.solids]


def walls(room: Room) -> list[Wall]:
    """The walls of a room in order; edges of no length are left out."""
    out = []
    count = len(room.outline)
    for index, (x0, y0) in enumerate(room.outline):
        x1, y1 = room.outline[(index + 1) % count]
        length = math.hypot(x1 - x0, y1 - y0)
        if length > 1e-6:
            t = ((x1 - x0) / length, (y1 - y0) / length)
            out.append(Wall(index, (x0, y0), t, (-t[1], t[0]), length))
    return out


def outer_outline(room: Room, thickness: float = WALL_THICKNESS) -> tuple[Vec2, ...]:
    """The outer face of the walls: the outline moved outward, with mitred corners of limited length."""
    edges = walls(room)
    out: list[Vec2] = []
    for before, after in zip(edges[-1:] + edges[:-1], edges, strict=True):
        (ax, ay), (bx, by) = before.inward, after.inward
        x, y = after.start
        k = 1 + ax * bx + ay * by
        if k > 0.25:
            out.append((x - thickness * (ax + bx) / k, y - thickness * (ay + by) / k))
        else:
            out.append((x - thickness * ax, y - thickness * ay))
            out.append((x - thickness * bx, y - thickness * by))
    return tuple(out)


def opening_zone(wall: Wall, opening: Door | Window) -> tuple[Vec2, ...]:
    """The floor that an opening needs free."""
    depth = 0.3
    if isinstance(opening, Door):
        depth = opening.width if opening.swing.startswith("in") else 0.6
    return wall.strip(opening.offset, opening.width, 0.0, depth)


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


def area(polygon: Sequence[Vec2]) -> float:
    """Signed area, positive for counter-clockwise polygons."""
    return 0.5 * sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(polygon, [*polygon[1:], polygon[0]], strict=True))


def _hull(points: Sequence[Vec2]) -> tuple[Vec2, ...]:
    """Convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return tuple(ordered)
    chains = []
    for run in (ordered, ordered[::-1]):
        chain: list[Vec2] = []
        for p in run:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return tuple(chains[0] + chains[1])


def _turn(a: Vec2, b: Vec2, c: Vec2) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
